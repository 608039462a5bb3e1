//! `machinist compile`: a scene to a model file, which needs neither its spec nor the generator.

use std::path::PathBuf;

use clap::Args;
use machinist_model::file;

use super::arguments::SourceArgs;
use super::output::{print, require_ending, write_file};
use super::scene::{MODEL_ENDING, SceneSource, derived_stamped};
use crate::failure::Failure;

#[derive(Debug, Args)]
pub struct Compile {
    /// Model file to write, ending in .model
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: PathBuf,
    #[command(flatten)]
    scene: SourceArgs,
}

impl Compile {
    pub fn execute(&self) -> Result<(), Failure> {
        require_ending(&self.out, &[MODEL_ENDING], "--out")?;
        let SourceArgs { scene, keep, .. } = &self.scene;
        let stamped = match self.scene.given()? {
            SceneSource::Spec(source) => derived_stamped(&source, keep.keep_all)?,
            SceneSource::Model(_) => {
                let message = format!("{scene} is already a model");
                return Err(Failure::input(message, "copy it, or give the spec of a scene"));
            }
        };
        let bytes = file::write(&stamped);
        write_file(&self.out, |out| out.write_all(&bytes))?;
        let (name, out) = (&stamped.model.name, self.out.display());
        print(&format!("wrote {out}: {name}, {} bytes\n", bytes.len()))
    }
}
