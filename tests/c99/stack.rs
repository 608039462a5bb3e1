//! Stack of emitted C: the stated bound compared with the frames that a compiler lays out without
//! optimisation. Optimising compilers keep further results, so their own statement counts: it is a
//! bound, because no frame grows at run time.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use machinist_codegen::emit::c99::{C99File, C99Options, Real, StackBound, StackBounds, emit};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::fixed_step::StepMethod;

use super::{filter_of, options, options_with};
use crate::own_scene::{scenes_to_try, whole_model_of_specs};

/// A compiler with its target, and the bytes that a call costs at most: return address and
/// saved registers, rounded up to the alignment of a frame.
struct Target {
    command: &'static str,
    flags: &'static [&'static str],
    call: usize,
}

/// A Cortex-M saves nine registers of four bytes, and eight of eight bytes of its unit for floating
/// point. An x86-64 saves six.
const ON_CORTEX_M: usize = 9 * 4 + 8 * 8 + 4;

const TARGETS: [Target; 3] = [
    Target { command: "gcc", flags: &[], call: 8 + 6 * 8 + 8 },
    Target {
        command: "arm-none-eabi-gcc",
        flags: &["-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard"],
        call: ON_CORTEX_M,
    },
    Target {
        command: "arm-none-eabi-gcc",
        flags: &["-mcpu=cortex-m7", "-mthumb", "-mfpu=fpv5-d16", "-mfloat-abi=hard"],
        call: ON_CORTEX_M,
    },
];

/// Returns the levels of optimisation to try. The bound is compared with frames of the first, which
/// also shows frames that grow; those of the others are only printed.
fn levels() -> &'static [&'static str] {
    let is_all = std::env::var("MACHINIST_C99").is_ok_and(|which| which == "all");
    if is_all { &["-O0", "-O2", "-O3"] } else { &["-O0"] }
}

/// A motor, friction with events, constraints, a brake that is a constraint.
const SCENES: [&str; 4] = ["saw_gin", "stick_slip", "four_bar", "drives/winch"];

impl Target {
    fn is_here(&self) -> bool {
        let quiet = Command::new(self.command).arg("--version").stdout(Stdio::null()).status();
        let is_here = quiet.is_ok_and(|status| status.success());
        if !is_here {
            eprintln!("skipped: {} is not here to lay out frames of emitted C", self.command);
        }
        is_here
    }

    /// Returns the stack of every function that others may call, including the functions it calls.
    fn stacks(&self, (name, folder): (&str, &Path), level: &str) -> BTreeMap<String, usize> {
        let mut command = Command::new(self.command);
        command.args(self.flags).args(["-std=c99", level, "-ffp-contract=off", "-c"]);
        command.args(["-fcallgraph-info=su", &format!("{name}.c")]);
        let output = command.current_dir(folder).output().expect("a compiler");
        let said = String::from_utf8_lossy(&output.stderr);
        if said.contains("-fcallgraph-info") {
            eprintln!("skipped: {} tells no frames", self.command);
            return BTreeMap::new();
        }
        assert!(output.status.success(), "{command:?}:\n{said}");
        let graph = std::fs::read_to_string(folder.join(format!("{name}.ci"))).expect("a graph");
        let graph = Graph::of(&graph);
        graph.frames.keys().map(|title| (title.clone(), graph.deepest(title))).collect()
    }
}

/// Frames of functions by their titles, and who calls whom.
#[derive(Default)]
struct Graph {
    frames: BTreeMap<String, usize>,
    calls: Vec<(String, String)>,
}

impl Graph {
    fn of(text: &str) -> Self {
        let mut graph = Self::default();
        let quoted = |line: &str, key: &str| -> Option<String> {
            let (_, rest) = line.split_once(&format!("{key}: \""))?;
            Some(rest.split_once('"')?.0.to_owned())
        };
        for line in text.lines() {
            if let (Some(from), Some(to)) = (quoted(line, "sourcename"), quoted(line, "targetname"))
            {
                graph.calls.push((from, to));
            } else if line.contains("bytes (dynamic") {
                panic!("a frame that grows at run time: {line}");
            } else if let (Some(title), Some(label)) =
                (quoted(line, "title"), quoted(line, "label"))
                && let Some((before, _)) = label.split_once(" bytes (static)")
            {
                let bytes = before.rsplit("\\n").next().and_then(|bytes| bytes.parse().ok());
                graph.frames.insert(title, bytes.expect("bytes"));
            }
        }
        graph
    }

    fn deepest(&self, title: &str) -> usize {
        let called = self.calls.iter().filter(|(from, _)| from == title);
        let deepest = called.map(|(_, to)| self.deepest(to)).max().unwrap_or(0);
        self.frames.get(title).copied().unwrap_or(0) + deepest
    }
}

/// Compares the frames of the functions whose stack is stated.
fn compare(said: &str, (name, files): (&str, &[C99File]), targets: &[&Target]) {
    let folder = tempfile::tempdir().expect("a folder");
    for file in files {
        std::fs::write(folder.path().join(&file.name), &file.text).expect("written");
    }
    let bounds = StackBounds::of(&files[0].text, &files[1].text);
    for target in targets {
        let stacks = levels().iter().map(|level| {
            let stacks = target.stacks((name, folder.path()), level);
            (*level, stacks)
        });
        let stacks: Vec<_> = stacks.collect();
        for function in ["step", "estimator_predict", "estimator_correct"] {
            let Some(bound) = bounds.function(&format!("{name}_{function}")) else { continue };
            assert!(files[0].text.replace("\n * ", " ").contains(&format!("holds {bound}.")));
            let StackBound { bytes, calls } = bound;
            let mut row = String::new();
            for (level, stacks) in &stacks {
                let Some(found) = stacks.get(&format!("{name}_{function}")) else { continue };
                let what = format!("{said}: {function} at {level} for {}", target.command);
                let is_bound = *level != "-O0" || *found <= bytes + calls * target.call;
                assert!(is_bound, "{what}: {found} of {bound}");
                let _ = write!(row, " {level} {found}");
            }
            println!("{said}, {} {:?}: {function} {bound}:{row}", target.command, target.flags);
        }
    }
}

#[test]
fn frames_of_compilers_are_within_the_stated_stack() {
    let targets: Vec<&Target> = TARGETS.iter().filter(|target| target.is_here()).collect();
    for name in scenes_to_try("MACHINIST_C99", &SCENES) {
        let model = whole_model_of_specs(&name, Keep::Needed);
        for (method, real) in [
            (StepMethod::RungeKutta4, Real::Double),
            (StepMethod::Rosenbrock2, Real::Double),
            (StepMethod::RungeKutta4, Real::Float),
        ] {
            let options = C99Options { method, ..options(real, &model) };
            let files = emit(&model, &options).expect("emitted");
            compare(&format!("{name} by {method:?} in {real:?}"), (&model.name, &files), &targets);
        }
        if model.rate_jacobian.pattern.entries.is_empty() || model.wanted.is_empty() {
            continue;
        }
        for method in [StepMethod::RungeKutta4, StepMethod::Rosenbrock2] {
            let options = options_with(Real::Double, &model, filter_of(&model), method);
            let files = emit(&model, &options).expect("emitted");
            let said = format!("filter of {name} by {method:?}");
            compare(&said, (&model.name, &files), &targets);
        }
    }
}
