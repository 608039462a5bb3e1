//! Times of rates and Jacobians: emitted code, JIT-compiled models, and Pinocchio.

use std::error::Error;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use machinist::complex_step::dense;
use machinist_algebra::cas::Algebra;
use machinist_codegen::emit::EmitOptions;
use machinist_codegen::emit::rust::emit;
use machinist_contract::Simulator;
use machinist_model::{Model, ModelSimulator};
use serde_json::Value;

use crate::derive::derived;
use crate::measure::{Measured, measure};
use crate::robots::{numbers, robots, rows, scene_of};

const ROBOTS: [&str; 2] = ["ur5", "panda"];
/// Programs run in turns, because the machine may be busy.
const TURNS: usize = 5;
/// Largest difference of rates and Jacobians, relative to the largest entry.
const TOLERANCE: f64 = 1e-11;

/// A robot with one state of its reference.
struct Robot {
    name: &'static str,
    model: Model,
    tree: String,
    state: Vec<f64>,
    parameters: Vec<f64>,
}

/// Prints the table.
pub fn print() -> Result<(), Box<dyn Error>> {
    let all = robots();
    let cases = ROBOTS.map(|name| robot(name, &all["robots"][name]));
    let cases: Vec<Robot> = cases.into_iter().collect::<Result<_, _>>()?;
    let folder = tempfile::tempdir()?;
    let emitted = build_emitted(folder.path(), &cases)?;
    let pinocchio = build_pinocchio(folder.path())?;
    println!("\n| robot | function | emitted [ns] | JIT [ns] | Pinocchio [ns] | ratios |");
    println!("| --- | --- | --- | --- | --- | --- |");
    for case in &cases {
        row(case, &emitted, pinocchio.as_deref())?;
    }
    Ok(())
}

fn robot(name: &'static str, value: &Value) -> Result<Robot, Box<dyn Error>> {
    let mut text = scene_of(value);
    text = text.replacen("name = \"robot\"", &format!("name = \"{name}\""), 1);
    let state = &value["states"][1];
    Ok(Robot {
        name,
        model: derived(&text, Algebra::default())?,
        tree: tree(value),
        state: [numbers(&state["q"]), numbers(&state["v"])].concat(),
        parameters: numbers(&state["tau"]),
    })
}

/// Returns numbers as words of a line.
fn list(numbers: &[f64]) -> String {
    let words: Vec<String> = numbers.iter().map(|number| format!("{number:e}")).collect();
    words.join(" ")
}

/// Returns the tree of a robot as `pinocchio.cpp` reads it.
fn tree(robot: &Value) -> String {
    let joints = robot["joints"].as_array().expect("joints");
    let mut text = format!("{}\n{}\n", joints.len(), list(&numbers(&robot["gravity"])));
    for joint in joints {
        let kind = joint["type"].as_str().expect("a type");
        let axis = joint.get("axis").map_or(vec![0.0; 3], numbers);
        let [turned, tensor] = ["R", "inertia_at_com"].map(|key| rows(&joint[key]).concat());
        writeln!(
            text,
            "{kind} {} {} {} {} {} {} {}",
            joint["parent"],
            list(&axis),
            list(&numbers(&joint["p"])),
            list(&turned),
            joint["mass"],
            list(&numbers(&joint["com"])),
            list(&tensor),
        )
        .expect("text");
    }
    text
}

/// Compiles a program of emitted robots for this processor and returns its path.
fn build_emitted(folder: &Path, cases: &[Robot]) -> Result<PathBuf, Box<dyn Error>> {
    let source = folder.join("src");
    std::fs::create_dir(&source)?;
    let contract = concat!(env!("CARGO_MANIFEST_DIR"), "/../crates/contract");
    let manifest = format!(
        "[package]\nname = \"emitted\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n\
         [dependencies]\nmachinist-contract = {{ path = {contract:?} }}\n\
         [profile.release]\ncodegen-units = 1\n"
    );
    std::fs::write(folder.join("Cargo.toml"), manifest)?;
    std::fs::write(source.join("main.rs"), include_str!("emitted.rs"))?;
    std::fs::write(source.join("measure.rs"), include_str!("measure.rs"))?;
    for case in cases {
        let text = emit(&case.model, &EmitOptions::for_build_script())?;
        std::fs::write(source.join(format!("{}.rs", case.name)), text)?;
    }
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--release", "--quiet", "--offline"]).current_dir(folder);
    cargo.env("RUSTFLAGS", "-C target-cpu=native").env_remove("CARGO_TARGET_DIR");
    cargo.env_remove("RUSTC_WORKSPACE_WRAPPER").env_remove("RUSTC_WRAPPER");
    if !cargo.status()?.success() {
        return Err("the emitted robots do not compile".into());
    }
    Ok(folder.join("target/release/emitted"))
}

/// Compiles the program that measures Pinocchio, if an environment variable names its folder.
fn build_pinocchio(folder: &Path) -> Result<Option<PathBuf>, Box<dyn Error>> {
    let Some(prefix) = std::env::var_os("MACHINIST_PINOCCHIO").map(PathBuf::from) else {
        println!("\nMACHINIST_PINOCCHIO names no installation of Pinocchio: it is left out");
        return Ok(None);
    };
    let eigen = std::env::var_os("MACHINIST_EIGEN").map(PathBuf::from);
    let eigen = eigen.unwrap_or_else(|| prefix.join("include/eigen3"));
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../benches/robots/pinocchio.cpp");
    let program = folder.join("pinocchio");
    let library = prefix.join("lib");
    let compiled = Command::new("g++")
        .args(["-O3", "-march=native", "-std=c++17", "-DNDEBUG", "-w"])
        .args(["-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS"])
        .arg(format!("-I{}", prefix.join("include").display()))
        .arg(format!("-I{}", eigen.display()))
        .arg(source)
        .arg(format!("-L{}", library.display()))
        .arg(format!("-Wl,-rpath,{}", library.display()))
        .args(["-lboost_serialization", "-o"])
        .arg(&program)
        .status()?;
    if compiled.success() { Ok(Some(program)) } else { Err("g++ fails on Pinocchio".into()) }
}

fn row(case: &Robot, emitted: &Path, pinocchio: Option<&Path>) -> Result<(), Box<dyn Error>> {
    let jit = ModelSimulator::compiled_at_once(case.model.clone());
    let moment = format!("{} {}", list(&case.state), list(&case.parameters));
    let mut times = [[f64::INFINITY; 3]; 2];
    for _ in 0..TURNS {
        let by_emitted = printed(Command::new(emitted).arg(case.name), &moment)?;
        let by_jit = measure(&jit, &case.state, &case.parameters);
        let mut columns = vec![[by_emitted[0][0], by_emitted[0][1]], by_jit.times];
        compare(&by_jit, &by_emitted[1], &by_emitted[2])?;
        if let Some(program) = pinocchio {
            let found = printed(&mut Command::new(program), &format!("{}{moment}", case.tree))?;
            columns.push([found[0][0], found[0][1]]);
            compare_with_pinocchio(&jit, &by_jit, &found)?;
        }
        for (column, pair) in columns.iter().enumerate() {
            for (row, time) in times.iter_mut().zip(pair) {
                row[column] = row[column].min(*time);
            }
        }
    }
    for (function, [emitted, jit, pinocchio]) in ["rate", "Jacobian"].iter().zip(times) {
        println!(
            "| {} | {function} | {emitted:.0} | {jit:.0} | {pinocchio:.0} | {:.1}, {:.1} |",
            case.name,
            pinocchio / emitted,
            pinocchio / jit
        );
    }
    Ok(())
}

/// Runs a program and returns the lines of numbers that it prints.
fn printed(command: &mut Command, input: &str) -> Result<Vec<Vec<f64>>, Box<dyn Error>> {
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
    child.stdin.take().ok_or("no input")?.write_all(input.as_bytes())?;
    let output = child.wait_with_output()?;
    if !output.status.success() {
        return Err(format!("{command:?} fails").into());
    }
    let lines = String::from_utf8(output.stdout)?;
    let line = |line: &str| line.split_whitespace().map(str::parse).collect::<Result<_, _>>();
    Ok(lines.lines().map(line).collect::<Result<_, _>>()?)
}

fn compare(ours: &Measured, rate: &[f64], jacobian: &[f64]) -> Result<(), Box<dyn Error>> {
    close("rates", &ours.rate, rate)?;
    close("Jacobians", &ours.jacobian, jacobian)
}

fn compare_with_pinocchio(
    simulator: &dyn Simulator<f64>,
    ours: &Measured,
    theirs: &[Vec<f64>],
) -> Result<(), Box<dyn Error>> {
    let n = theirs[1].len();
    close("rates", &ours.rate[n..], &theirs[1])?;
    let jacobian = dense(simulator.rate_jacobian_pattern(), &ours.jacobian);
    for (first, rows) in [(0, &theirs[2..2 + n]), (n, &theirs[2 + n..])] {
        let block = (0..n * n).map(|k| jacobian[(n + k / n, first + k % n)]);
        close("Jacobians", &block.collect::<Vec<_>>(), &rows.concat())?;
    }
    Ok(())
}

fn close(what: &str, ours: &[f64], theirs: &[f64]) -> Result<(), Box<dyn Error>> {
    let size = theirs.iter().fold(0.0, |size: f64, entry| size.max(entry.abs()));
    let mut pairs = ours.iter().zip(theirs);
    if ours.len() != theirs.len() || !pairs.all(|(a, b)| (a - b).abs() <= TOLERANCE * size) {
        return Err(format!("{what} differ: {ours:?}, {theirs:?}").into());
    }
    Ok(())
}
