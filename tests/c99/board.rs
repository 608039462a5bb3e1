//! Emitted C on microcontrollers in QEMU: bits compared with the host, and cost of a step.

mod frames;

use std::path::Path;
use std::process::{Command, Stdio};

use machinist_codegen::emit::c99::{C99File, Real};

const PROGRAM: &str = include_str!("board/board.c");
const SCRIPT: &str = include_str!("board/board.ld");

/// A microcontroller that QEMU emulates.
pub struct Board {
    /// Name of its processor.
    pub processor: &'static str,
    unit: &'static str,
    machine: &'static str,
}

/// A Cortex-M4F, which computes `double` in software, and a Cortex-M7 with a hardware unit for it.
pub const BOARDS: [Board; 2] = [
    Board { processor: "cortex-m4", unit: "fpv4-sp-d16", machine: "mps2-an386" },
    Board { processor: "cortex-m7", unit: "fpv5-d16", machine: "mps2-an500" },
];

const GCC: &str = "arm-none-eabi-gcc";
const QEMU: &str = "qemu-system-arm";

/// Result of a run on a board.
pub struct Ran {
    /// State at the end.
    pub state: Vec<f64>,
    /// Number of events.
    pub events: u64,
    /// Bytes of the code and constants of the scene, without libraries.
    pub code: u64,
    /// Bytes of the struct that runs.
    pub ram: u64,
    /// Bytes of stack that were written.
    pub stack: u64,
    /// Bytes of stack of the deepest chain of calls in the binary, with the C library.
    pub deepest: u64,
    /// Instructions per step, mean and maximum.
    pub instructions: [u64; 2],
}

/// Returns whether QEMU and a compiler with a C library for these processors are installed.
pub fn are_here() -> bool {
    let is_here = |name: &&str| {
        let quiet = Command::new(name).arg("--version").stdout(Stdio::null()).status();
        quiet.is_ok_and(|status| status.success())
    };
    let missing = [GCC, "arm-none-eabi-size", QEMU].into_iter().find(|name| !is_here(name));
    let missing = missing.or_else(|| (!has_library()).then_some("C library for arm-none-eabi"));
    if let Some(missing) = missing {
        eprintln!("skipped: there is no {missing} to run emitted C on a microcontroller");
    }
    missing.is_none()
}

/// Returns whether the compiler has a C library, which Debian packages separately.
fn has_library() -> bool {
    let mut command = Command::new(GCC);
    command.args(["-print-file-name=nosys.specs"]).stderr(Stdio::null());
    // For a missing file, the compiler prints the bare name.
    let found = command.output().map(|output| output.stdout).unwrap_or_default();
    Path::new(String::from_utf8_lossy(&found).trim()).is_absolute()
}

/// SysTick counts at 25 MHz, and QEMU takes a nanosecond for an instruction.
const INSTRUCTIONS_A_TICK: u64 = 40;

impl Board {
    /// Runs a scene with constant steps, or its filter with the measurements of a function in C,
    /// `measure`.
    pub fn run(
        &self,
        (name, files, real): (&str, &[C99File], Real),
        (step, steps): (f64, usize),
        measure: Option<&str>,
    ) -> Ran {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path();
        for file in files {
            std::fs::write(path.join(&file.name), &file.text).expect("written");
        }
        std::fs::write(path.join("board.c"), PROGRAM).expect("written");
        std::fs::write(path.join("board.ld"), SCRIPT).expect("written");
        let target = [
            format!("-mcpu={}", self.processor),
            "-mthumb".to_owned(),
            format!("-mfpu={}", self.unit),
            "-mfloat-abi=hard".to_owned(),
            "-O2".to_owned(),
            "-ffp-contract=off".to_owned(),
        ];
        let source = format!("{name}.c");
        let strict = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"];
        run(Command::new(GCC).args(&target).args(strict).args(["-c", &source]), path);
        let object = format!("{name}.o");
        if let Some(measure) = measure {
            std::fs::write(path.join("measure.h"), measure).expect("written");
        }
        let measured = measure.map(|_| "-DMEASURE_HEADER=\"measure.h\"");
        let defined = [
            format!("-DSCENE={name}"),
            format!("-DSCENE_HEADER=\"{name}.h\""),
            format!("-DREAL={}", real.name()),
            format!("-DSTEP={step:e}"),
            format!("-DSTEPS={steps}"),
        ];
        let mut link = Command::new(GCC);
        link.args(&target).args(defined).args(measured).args([
            "board.c",
            &object,
            "-o",
            "board.elf",
        ]);
        link.args(["-nostartfiles", "-ffreestanding", "-T", "board.ld", "-lm", "-lc", "-lgcc"]);
        run(link.arg("--specs=nosys.specs"), path);
        let size = run(Command::new("arm-none-eabi-size").arg(&object), path);
        let code = size.lines().nth(1).and_then(|line| line.split_whitespace().next());
        let code = code.and_then(|code| code.parse().ok()).expect("bytes of text");
        let listing = run(Command::new("arm-none-eabi-objdump").args(["-d", "board.elf"]), path);
        let deepest = frames::deepest(&listing, "reset");
        let ran = self.answer(path, real, steps as u64, [code, deepest]);
        assert!(ran.stack <= deepest, "{name}: {} bytes of stack of {deepest}", ran.stack);
        ran
    }

    fn answer(&self, path: &Path, real: Real, steps: u64, [code, deepest]: [u64; 2]) -> Ran {
        let mut command = Command::new(QEMU);
        command.args(["-M", self.machine, "-nographic", "-icount", "shift=0"]);
        command.args(["-semihosting-config", "enable=on,target=native", "-kernel", "board.elf"]);
        let said = run(command.stdin(Stdio::null()), path);
        let numbers = |what: &str| -> Vec<u64> {
            let lines = said.lines().filter_map(|line| line.strip_prefix(what)?.strip_prefix(' '));
            lines.map(|hex| u64::from_str_radix(hex.trim(), 16).expect("a number")).collect()
        };
        let one = |what: &str| numbers(what).first().copied().unwrap_or_else(|| panic!("{said}"));
        let state = numbers("state").into_iter().map(|bits| match real {
            Real::Double => f64::from_bits(bits),
            Real::Float => f64::from(f32::from_bits(bits as u32)),
        });
        Ran {
            state: state.collect(),
            events: one("events"),
            code,
            ram: one("ram"),
            stack: one("stack"),
            deepest,
            instructions: [one("ticks") / steps, one("most")].map(|n| n * INSTRUCTIONS_A_TICK),
        }
    }
}

/// Returns the output of a command, which must succeed.
fn run(command: &mut Command, folder: &Path) -> String {
    let output = command.current_dir(folder).output().expect("a program that is here");
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    // QEMU's console for semihosting may be either.
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{command:?}:\n{said}{errors}");
    format!("{said}{errors}")
}
