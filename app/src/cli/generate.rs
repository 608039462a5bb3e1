//! `machinist gen`: specs to emitted Rust or C99, or a check that emitted files are up to date.

mod c99;

pub use c99::start;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::write::{Mode, Summary, Written, emit_scenes};
use machinist_model::Model;

use super::arguments::{DeriveArgs, KeepArgs};
use super::estimator::EstimatorArgs;
use super::output::print;
use super::{scene, specs};
use crate::deriving;
use crate::failure::Failure;
use crate::freeze::admit;
use crate::spec_source::SpecSource;

/// Folder of emitted scenes.
pub const EMITTED: &str = "generated/src/scenes";
/// Folder of those for benchmarks, a crate of their own.
const EMITTED_BENCH: &str = "generated/bench/src/scenes";

/// Language of the emitted code.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Target {
    /// All scenes of a folder, as modules of a crate
    Rust,
    /// One scene, as a header, a source, a CMake file and an example
    C99,
}

#[derive(Debug, Args)]
pub struct Generate {
    /// With --target c99 or --estimator: name or file of the scene, or a model file
    scene: Option<String>,
    /// Target language
    #[arg(long, value_name = "NAME", default_value = "rust")]
    target: Target,
    /// Write nothing; fail if an emitted file is out of date
    #[arg(long)]
    check: bool,
    /// Folder of the scenes
    #[arg(long, value_name = "DIR", default_value = scene::SCENES)]
    specs: PathBuf,
    #[command(flatten)]
    c99: c99::Options,
    #[command(flatten)]
    estimator: EstimatorArgs,
    /// Folder for the emitted files. Default for Rust: generated/src/scenes
    #[arg(short, long, help_heading = "Output", value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    keep: KeepArgs,
    #[command(flatten)]
    derivation: DeriveArgs,
}

impl Generate {
    pub fn execute(&self) -> Result<(), Failure> {
        self.derivation.apply();
        let mode = if self.check { Mode::Check } else { Mode::Write };
        match (self.target, &self.scene) {
            (Target::C99, Some(scene)) => {
                let Some(out) = &self.out else {
                    let message = "--target c99 needs a folder for the files of the scene";
                    return Err(Failure::input(message, format!("-o {scene}")));
                };
                self.c99.execute((scene, &self.estimator), self.keep.keep_all, out, mode)
            }
            (Target::C99, None) => {
                let message = "--target c99 emits one scene at a time, but none is given";
                Err(Failure::input(message, "machinist gen --target c99 SCENE -o FOLDER"))
            }
            (Target::Rust, Some(scene)) if self.estimator.is_given() => {
                let Some(out) = &self.out else {
                    let message = "an estimator needs a folder for the files of the scene";
                    return Err(Failure::input(message, format!("-o {scene}")));
                };
                self.c99.estimator(scene, &self.estimator, self.keep.keep_all, out, mode)
            }
            (Target::Rust, Some(scene)) => {
                let message = format!("--target rust emits all scenes of a folder, not `{scene}`");
                let help = "leave the name out; `--specs` names another folder of scenes; with \
                            `--estimator` one scene is emitted";
                Err(Failure::input(message, help))
            }
            (Target::Rust, None) => {
                if self.estimator.is_given() {
                    let message = "an estimator is for one scene, but none is given";
                    return Err(Failure::input(message, "machinist gen SCENE --estimator ekf ..."));
                }
                self.c99.refuse()?;
                self.rust(mode)
            }
        }
    }

    /// Derives and emits everything in memory before anything is written.
    fn rust(&self, mode: Mode) -> Result<(), Failure> {
        let [out, bench_out] = match &self.out {
            Some(out) => [out.clone(), out.join(scene::BENCH)],
            None => [EMITTED, EMITTED_BENCH].map(PathBuf::from),
        };
        let files = specs::scene_files(&self.specs)?;
        let bench_files = specs::scene_files_below(&self.specs, scene::BENCH)?;
        let models = self.models(&files)?;
        let bench_programs = self.models(&bench_files)?;
        let mut text = describe(&emit_scenes(&out, &models, mode)?, "");
        if !bench_programs.is_empty() {
            let emitted = emit_scenes(&bench_out, &bench_programs, mode)?;
            text.push_str(&describe(&emitted, "bench/"));
        }
        print(&text)
    }
}

impl Generate {
    fn models(&self, files: &[SpecSource]) -> Result<Vec<Model>, Failure> {
        let keep = if self.keep.keep_all { Keep::All } else { Keep::Needed };
        let models = deriving::models(files, keep)?;
        if !self.keep.keep_all {
            for (file, model) in files.iter().zip(&models) {
                admit(file, model)?;
            }
        }
        Ok(models)
    }
}

/// Formats a line for each file, with names that begin with `folder`.
fn describe(summary: &Summary, folder: &str) -> String {
    let mut lines = Vec::new();
    for (file, written) in &summary.files {
        let what = match written {
            Written::Created => "created",
            Written::Changed => "changed",
            Written::Unchanged => "fresh",
        };
        lines.push(format!("{what:<8} {folder}{file}\n"));
    }
    for file in &summary.orphans {
        lines.push(format!("orphan   {folder}{file}: its scene no longer exists; delete it\n"));
    }
    lines.concat()
}
