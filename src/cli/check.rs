//! `machinist check`: what is wrong with specs, and nothing else.

use std::path::{Path, PathBuf};

use clap::Args;
use machinist_codegen::pipeline;

use super::output::print;
use super::scene::spec_path;
use super::{Failure, specs};

#[derive(Debug, Args)]
pub struct Check {
    /// Scene files, folders of them, or names of scenes
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<String>,
}

impl Check {
    pub fn execute(&self) -> Result<(), Failure> {
        let mut files: Vec<PathBuf> = Vec::new();
        for path in &self.paths {
            if Path::new(path).is_dir() {
                files.extend(specs::scene_files(Path::new(path))?);
                files.extend(specs::bench_files(Path::new(path))?);
            } else {
                files.push(spec_path(path)?);
            }
        }
        let systems = specs::all(&files, pipeline::check)?;
        let lines = files.iter().zip(&systems).map(|(file, system)| {
            format!(
                "{}: ok, {} coordinates, {} first-order states, {} parameters, {} outputs\n",
                file.display(),
                system.coordinates.len(),
                system.first_order.len(),
                system.parameters.len(),
                system.outputs.len(),
            )
        });
        print(&lines.collect::<String>())
    }
}
