//! Runs of the UR5 that falls for 1 s, beside those of Pinocchio with scipy and of MuJoCo: the time of
//! the fastest setting whose error of the final state is small enough.

use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use machinist::{Method, Simulation};
use machinist_algebra::cas::Algebra;
use machinist_model::ModelSimulator;

use crate::derive::derived;
use crate::robots::{robots, scene_of};

const REFERENCE: &str = include_str!("../../tests/spatial/ur5_free_fall.csv");
const ERRORS: [f64; 3] = [1e-3, 1e-6, 1e-9];
const METHODS: [Method; 3] = [Method::Dop853, Method::Tsit5, Method::Taylor];

/// A run: its method, the error of its final state, and its time \[ms\].
struct Run {
    name: String,
    error: f64,
    time: f64,
}

/// Prints the table.
pub fn print() -> Result<(), Box<dyn Error>> {
    let mut runs = ours()?;
    runs.extend(others()?);
    let mut names: Vec<&str> = runs.iter().map(|run| run.name.as_str()).collect();
    names.dedup();
    println!("\n| UR5 falls for 1 s, ms | error 1e-3 | 1e-6 | 1e-9 |\n| --- | --- | --- | --- |");
    for name in names {
        let cells = ERRORS.map(|error| {
            let enough = runs.iter().filter(|run| run.name == name && run.error <= error);
            let least = enough.fold(f64::INFINITY, |least, run| least.min(run.time));
            if least.is_finite() { format!("{least:.3}") } else { "-".to_owned() }
        });
        println!("| {name} | {} |", cells.join(" | "));
    }
    Ok(())
}

fn ours() -> Result<Vec<Run>, Box<dyn Error>> {
    let rows = REFERENCE.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
    let row = |line: &str| line.split(',').map(str::parse).collect::<Result<Vec<f64>, _>>();
    let rows: Vec<Vec<f64>> = rows.map(row).collect::<Result<_, _>>()?;
    let [start, end] = [rows.first(), rows.last()].map(|row| row.cloned().unwrap_or_default());
    let mut text = scene_of(&robots()["robots"]["ur5"]);
    text = text.replace("until = 1\n", "until = 1\npoints = 2\n") + "[initial]\n";
    for n in 1..=6 {
        writeln!(text, "\"r.q{n}\" = {}\n\"r.q{n}_dot\" = {}", start[n], start[6 + n])?;
    }
    let simulator = ModelSimulator::compiled_at_once(derived(&text, Algebra::default())?);
    let mut runs = Vec::new();
    for method in METHODS {
        for digits in 3..=13 {
            let simulation = Simulation::new(&simulator).method(method).rtol(0.1f64.powi(digits));
            let (mut time, mut error) = (f64::INFINITY, 0.0_f64);
            for _ in 0..9 {
                let begin = Instant::now();
                let run = simulation.clone().run()?;
                time = time.min(begin.elapsed().as_secs_f64() * 1e3);
                for n in 1..=6 {
                    for (name, wanted) in
                        [(format!("r.q{n}"), end[n]), (format!("r.q{n}_dot"), end[6 + n])]
                    {
                        let values = run.column(&name).ok_or("no column")?;
                        error = error.max((values[values.len() - 1] - wanted).abs());
                    }
                }
            }
            runs.push(Run { name: format!("{method:?}, JIT").to_lowercase(), error, time });
        }
    }
    Ok(runs)
}

/// Runs the script of the others, if an interpreter with them is named.
fn others() -> Result<Vec<Run>, Box<dyn Error>> {
    let Some(python) = std::env::var_os("MACHINIST_PYTHON") else {
        println!(
            "\nMACHINIST_PYTHON names no Python with pin, mujoco and scipy: they are left out"
        );
        return Ok(Vec::new());
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let paths =
        ["benches/robots/fall.py", "app/tests/urdf/ur5.urdf", "tests/spatial/ur5_free_fall.csv"];
    let output = Command::new(python).args(paths.map(|path| root.join(path))).output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    let text = String::from_utf8(output.stdout)?;
    let run = |line: &str| -> Result<Run, Box<dyn Error>> {
        let words: Vec<&str> = line.split_whitespace().collect();
        let [name, _, error, time] = words[..] else { return Err(line.into()) };
        Ok(Run { name: name.replace('+', " with "), error: error.parse()?, time: time.parse()? })
    };
    text.lines().map(run).collect()
}
