//! `machinist gen`: specs to emitted Rust, or the check that it is fresh.

use std::path::PathBuf;

use clap::Args;
use machinist_codegen::pipeline;
use machinist_codegen::reduce::Keep;
use machinist_codegen::write::{Mode, Summary, Written, emit_scenes};

use super::output::print;
use super::progress::during;
use super::{Failure, specs};

/// Where emitted scenes are kept.
pub const EMITTED: &str = "generated/src/scenes";

#[derive(Debug, Args)]
pub struct Generate {
    /// Write nothing; fail if any emitted file is not what the specs give
    #[arg(long)]
    check: bool,
    /// The folder of the scenes
    #[arg(long, value_name = "DIR", default_value = specs::SCENES)]
    specs: PathBuf,
    /// The folder of the emitted files
    #[arg(long, value_name = "DIR", default_value = EMITTED)]
    out: PathBuf,
}

impl Generate {
    /// Everything is derived and emitted in memory before anything is written.
    pub fn execute(&self) -> Result<(), Failure> {
        let files = specs::scene_files(&self.specs)?;
        let programs = during("deriving", || {
            specs::all(&files, |file| pipeline::generate(file, Keep::Needed))
        })?;
        let mode = if self.check { Mode::Check } else { Mode::Write };
        let summary = emit_scenes(&self.out, &programs, mode)?;
        print(&describe(&summary))
    }
}

fn describe(summary: &Summary) -> String {
    let mut lines = Vec::new();
    for (file, written) in &summary.files {
        let what = match written {
            Written::Created => "created",
            Written::Changed => "changed",
            Written::Unchanged => "fresh",
        };
        lines.push(format!("{what:<8} {file}\n"));
    }
    for file in &summary.orphans {
        lines.push(format!("orphan   {file}: its scene is no more; delete it\n"));
    }
    lines.concat()
}
