//! Scene specs in a folder, and what is derived from one of them.

use std::path::{Path, PathBuf};

use machinist_codegen::mechanics::lagrange::EquationsOfMotion;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_codegen::spec::diagnostic::Diagnostics;
use machinist_model::Model;
use machinist_model::operations;

use super::Failure;

/// Where scenes are kept.
pub const SCENES: &str = "specs/scenes";
/// The folder below it with scenes that are there to be measured, and the folder
/// below that of the emitted files with their simulators.
pub const BENCH: &str = "bench";

/// Where the spec of a scene may be.
pub fn places_of(name: &str) -> [PathBuf; 2] {
    let file = format!("{name}.toml");
    [Path::new(SCENES).join(&file), Path::new(SCENES).join(BENCH).join(&file)]
}

/// All scene files of a folder, sorted by name.
pub fn scene_files(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let files = toml_files(folder)?;
    if files.is_empty() {
        let message = format!("{}: there are no scenes in this folder", folder.display());
        return Err(Failure::input(message, "scenes are files that end in `.toml`"));
    }
    Ok(files)
}

/// All scene files of `bench` below a folder, likewise; none without that folder.
pub fn bench_files(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let bench = folder.join(BENCH);
    if bench.is_dir() { toml_files(&bench) } else { Ok(Vec::new()) }
}

fn toml_files(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let failed = |error: std::io::Error| {
        let help = "run this in the folder that holds `specs`, or name the folder of the scenes";
        Failure::input(format!("{}: {error}", folder.display()), help)
    };
    let mut files = Vec::new();
    for entry in folder.read_dir().map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.extension().is_some_and(|ending| ending == "toml") && path.is_file() {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// Applies a stage to every file; if any fails, fails with what is wrong in all.
pub fn all<T>(
    files: &[PathBuf],
    stage: impl Fn(&Path) -> Result<T, Diagnostics>,
) -> Result<Vec<T>, Failure> {
    let (mut done, mut wrong) = (Vec::new(), Vec::new());
    for file in files {
        match stage(file) {
            Ok(result) => done.push(result),
            Err(diagnostics) => wrong.push(diagnostics.into()),
        }
    }
    if wrong.is_empty() { Ok(done) } else { Err(Failure::Input(wrong)) }
}

/// A scene with its equations and what is computed of them.
pub struct Derived {
    /// For people: of the whole scene.
    pub equations: EquationsOfMotion,
    /// For machines: of what the outputs need.
    pub program: Program,
}

impl Derived {
    /// Derives a scene file.
    pub fn new(scene: &Path) -> Result<Self, Diagnostics> {
        let equations = pipeline::derive(scene)?;
        let program = pipeline::compile(equations.system.clone(), Keep::Needed)?;
        Ok(Self { equations, program })
    }
}

/// What one emitted function costs.
pub struct Cost {
    /// Its name.
    pub function: &'static str,
    /// What it computes.
    pub meaning: &'static str,
    /// How many numbers it writes.
    pub results: usize,
    /// Size of the full matrix, of functions that write nonzeros only.
    pub full: Option<usize>,
    /// Arithmetic operations, functions and selections.
    pub operations: usize,
}

/// The cost of every function of a scene.
pub fn costs(program: &Program) -> Vec<Cost> {
    let plain = |function, meaning, tape: &machinist_model::Tape| Cost {
        function,
        meaning,
        results: tape.results.len(),
        full: None,
        operations: tape_operations(tape),
    };
    let matrix = |function, meaning, matrix: &machinist_model::MatrixTape| Cost {
        full: Some(matrix.pattern.rows * matrix.pattern.columns),
        ..plain(function, meaning, &matrix.tape)
    };
    vec![
        plain("rate", "y' = [q', M^-1 f, z']", &program.rate),
        matrix("rate_jacobian", "dy'/dy", &program.rate_jacobian),
        matrix("parameter_jacobian", "dy'/dp", &program.parameter_jacobian),
        plain("time_derivative", "partial y'/partial t", &program.time_derivative),
        matrix("mass_matrix", "M", &program.mass_matrix),
        plain("forcing", "f", &program.forcing),
        plain("outputs", "wanted outputs", &program.outputs),
        plain("energy", "T, V, stored", &program.energy),
        plain("power_balance", "dE/dt, supplied, dissipated", &program.power_balance),
        plain("initial_state", "y at the start", &program.initial_state),
        plain("discontinuities", "times of jumps", &program.discontinuities),
    ]
}
