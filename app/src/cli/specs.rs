//! Scene specs in a folder, and the costs of the functions derived from one.

use std::path::{Path, PathBuf};

use machinist_model::Model;
use machinist_model::operations;

use crate::failure::Failure;
use crate::spec_source::SpecSource;

pub use super::scene::DRIVES;

/// Returns all scene files of a folder, sorted by name.
pub fn scene_files(folder: &Path) -> Result<Vec<SpecSource>, Failure> {
    let files = toml_files(folder)?;
    if files.is_empty() {
        let message = format!("{}: there are no scenes in this folder", folder.display());
        return Err(Failure::input(message, "scenes are files that end in `.toml`"));
    }
    Ok(files)
}

/// Returns all scene files of a subfolder, sorted by name; none if it does not exist.
pub fn scene_files_below(folder: &Path, name: &str) -> Result<Vec<SpecSource>, Failure> {
    let below = folder.join(name);
    if below.is_dir() { toml_files(&below) } else { Ok(Vec::new()) }
}

fn toml_files(folder: &Path) -> Result<Vec<SpecSource>, Failure> {
    let failed = |error: std::io::Error| {
        let help = "run this in the folder that holds `specs`, or name the folder of the scenes";
        Failure::input(format!("{}: {error}", folder.display()), help)
    };
    let mut files: Vec<PathBuf> = Vec::new();
    for entry in folder.read_dir().map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.extension().is_some_and(|ending| ending == "toml") && path.is_file() {
            files.push(path);
        }
    }
    files.sort();
    Ok(files.into_iter().map(SpecSource::File).collect())
}

/// Cost of an emitted function.
pub struct Cost {
    /// Name of the function.
    pub function: &'static str,
    /// Meaning of the result.
    pub meaning: &'static str,
    /// Number of results.
    pub results: usize,
    /// Size of the full matrix, for functions that write only nonzeros.
    pub full: Option<usize>,
    /// Arithmetic operations, functions and selections.
    pub operations: usize,
}

/// Returns the cost of every function of a scene.
pub fn costs(model: &Model) -> Vec<Cost> {
    let costs = model.functions().map(|row| {
        let tape = (row.tape)(model);
        Cost {
            function: row.name,
            meaning: row.meaning,
            results: tape.results.len(),
            full: row.pattern.map(|pattern| pattern(model)).map(|p| p.rows * p.columns),
            operations: operations(tape),
        }
    });
    costs.collect()
}
