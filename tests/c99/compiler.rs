//! C compilers of this machine, and their programs.

use std::io::{Read as _, Write as _};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use machinist_codegen::emit::c99::C99File;

/// Warnings that count as errors.
const STRICT: [&str; 6] = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"];

/// Available compilers.
pub struct Compiler {
    /// Name of the compiler that builds the programs.
    first: String,
    /// Names of compilers that only check the sources.
    others: Vec<String>,
    sanitizes: bool,
}

impl Compiler {
    /// Returns `gcc`, together with `clang` if available; `None`, with a message, if there is no
    /// compiler.
    pub fn found() -> Option<Self> {
        let is_here = |name: &&str| {
            let quiet = Command::new(name).arg("--version").stdout(Stdio::null()).status();
            quiet.is_ok_and(|status| status.success())
        };
        let mut all = ["gcc", "clang"].into_iter().filter(is_here).map(str::to_owned);
        let Some(first) = all.next() else {
            eprintln!("skipped: neither gcc nor clang is here to compile emitted C");
            return None;
        };
        let others: Vec<String> = all.collect();
        if others.is_empty() {
            eprintln!("{first} alone compiles emitted C: the other of gcc and clang is not here");
        }
        let mut compiler = Self { first, others, sanitizes: false };
        compiler.sanitizes = compiler.links_sanitizer();
        if !compiler.sanitizes {
            eprintln!("{} has no sanitizer for undefined behaviour here", compiler.first);
        }
        Some(compiler)
    }

    /// Disables the search for warnings and undefined behaviour, which is done elsewhere.
    pub fn plain(self) -> Self {
        Self { others: Vec::new(), sanitizes: false, ..self }
    }

    fn links_sanitizer(&self) -> bool {
        let folder = tempfile::tempdir().expect("a folder");
        let source = folder.path().join("empty.c");
        std::fs::write(&source, "int main(void) { return 0; }\n").expect("written");
        let mut command = Command::new(&self.first);
        command.args(["-fsanitize=undefined", "-o"]).arg(folder.path().join("empty")).arg(source);
        command.output().is_ok_and(|output| output.status.success())
    }

    /// Compiles the files of a scene and a driver program without warnings, and starts it.
    pub fn build(&self, name: &str, files: &[C99File], driver: &str) -> Program {
        let folder = tempfile::tempdir().expect("a folder");
        for file in files {
            std::fs::write(folder.path().join(&file.name), &file.text).expect("written");
        }
        std::fs::write(folder.path().join("driver.c"), driver).expect("written");
        let source = format!("{name}.c");
        for compiler in &self.others {
            let mut command = Command::new(compiler);
            command.args(STRICT).args(["-fsyntax-only", &source, &format!("{name}_example.c")]);
            run(command, folder.path());
        }
        let mut command = Command::new(&self.first);
        command.args(STRICT).args(["-c", "-O1", &format!("{name}_example.c")]);
        run(command, folder.path());
        let mut command = Command::new(&self.first);
        command.args(STRICT).args(["-O1", "-ffp-contract=off", "-c", &source]);
        if self.sanitizes {
            command.args(["-fsanitize=undefined", "-fno-sanitize-recover=all"]);
        }
        run(command, folder.path());
        let mut command = Command::new(&self.first);
        command.args(["-std=c99", "-O0", "driver.c", &format!("{name}.o"), "-lm", "-o", "program"]);
        if self.sanitizes {
            command.arg("-fsanitize=undefined");
        }
        run(command, folder.path());
        Program::start(folder)
    }
}

fn run(mut command: Command, folder: &Path) {
    let output = command.current_dir(folder).output().expect("a compiler");
    let said = String::from_utf8_lossy(&output.stderr);
    let said: String = said.chars().take(4000).collect();
    assert!(output.status.success(), "{command:?}:\n{said}");
}

/// A running program that answers numbers with numbers.
pub struct Program {
    child: Child,
    input: Option<ChildStdin>,
    output: ChildStdout,
    folder: tempfile::TempDir,
}

impl Program {
    fn start(folder: tempfile::TempDir) -> Self {
        let mut command = Command::new(folder.path().join("program"));
        let mut child = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("a program that was just compiled");
        let input = child.stdin.take();
        let output = child.stdout.take().expect("a pipe");
        Self { child, input, output, folder }
    }

    /// Runs the machine with constant steps; returns time, state and number of events after each.
    pub fn run(&self, step: f64, steps: usize, states: usize) -> Vec<(f64, Vec<f64>, f64)> {
        let mut command = Command::new(self.folder.path().join("program"));
        let output = command.args([format!("{step:e}"), steps.to_string()]).output();
        let output = output.expect("a program that was just compiled");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "the program ended badly: {said}");
        let rows = output.stdout.chunks_exact(8 * (states + 2)).map(|row| {
            let numbers: Vec<f64> = numbers(row).collect();
            (numbers[0], numbers[1..=states].to_vec(), numbers[states + 1])
        });
        rows.collect()
    }

    /// Sends numbers.
    pub fn send(&mut self, numbers: &[f64]) {
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_ne_bytes()).collect();
        let input = self.input.as_mut().expect("a pipe");
        input.write_all(&bytes).and_then(|()| input.flush()).expect("a program that reads");
    }

    /// Waits for a number of values.
    pub fn receive(&mut self, count: usize) -> Vec<f64> {
        let mut bytes = vec![0; 8 * count];
        self.output.read_exact(&mut bytes).expect("a program that answers");
        numbers(&bytes).collect()
    }
}

fn numbers(bytes: &[u8]) -> impl Iterator<Item = f64> {
    let numbers = bytes.chunks_exact(8);
    numbers.map(|chunk| f64::from_ne_bytes(chunk.try_into().expect("eight bytes")))
}

impl Drop for Program {
    fn drop(&mut self) {
        self.input = None;
        let status = self.child.wait();
        if !std::thread::panicking() {
            assert!(status.is_ok_and(|status| status.success()), "the program ended badly");
        }
    }
}
