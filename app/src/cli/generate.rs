//! `machinist gen`: specs to emitted Rust, or the check that it is fresh.

use std::path::PathBuf;

use clap::Args;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::write::{Mode, Summary, Written, emit_scenes};
use machinist_model::Model;

use super::output::print;
use super::{scene, specs};
use crate::deriving;
use crate::failure::Failure;
use crate::freeze::admit;
use crate::spec_source::SpecSource;

/// Where emitted scenes are kept.
pub const EMITTED: &str = "generated/src/scenes";

#[derive(Debug, Args)]
pub struct Generate {
    /// Write nothing; fail if any emitted file is not what the specs give
    #[arg(long)]
    check: bool,
    /// The folder of the scenes
    #[arg(long, value_name = "DIR", default_value = scene::SCENES)]
    specs: PathBuf,
    /// The folder of the emitted files
    #[arg(long, value_name = "DIR", default_value = EMITTED)]
    out: PathBuf,
    /// Leave nothing out, whether the outputs need it or not
    #[arg(long)]
    keep_all: bool,
}

impl Generate {
    /// Everything is derived and emitted in memory before anything is written.
    pub fn execute(&self) -> Result<(), Failure> {
        let files = specs::scene_files(&self.specs)?;
        let bench_files = specs::scene_files_below(&self.specs, scene::BENCH)?;
        let models = self.models(&files)?;
        let bench_programs = self.models(&bench_files)?;
        let mode = if self.check { Mode::Check } else { Mode::Write };
        let mut text = describe(&emit_scenes(&self.out, &models, mode)?, "");
        if !bench_programs.is_empty() {
            let emitted = emit_scenes(&self.out.join(scene::BENCH), &bench_programs, mode)?;
            text.push_str(&describe(&emitted, "bench/"));
        }
        print(&text)
    }
}

impl Generate {
    fn models(&self, files: &[SpecSource]) -> Result<Vec<Model>, Failure> {
        let keep = if self.keep_all { Keep::All } else { Keep::Needed };
        let models = deriving::models(files, keep)?;
        if !self.keep_all {
            for (file, model) in files.iter().zip(&models) {
                admit(file, model)?;
            }
        }
        Ok(models)
    }
}

/// One line a file, whose names begin with `folder`.
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
        lines.push(format!("orphan   {folder}{file}: its scene is no more; delete it\n"));
    }
    lines.concat()
}
