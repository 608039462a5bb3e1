//! `machinist watch`: the page of a machine in a browser, updated whenever its files are saved.

use clap::Args;

use super::arguments::TimeArgs;
use super::scene::SceneSource;
use crate::failure::Failure;
use crate::spec_source::SpecSource;
use crate::watch;

#[derive(Debug, Args)]
pub struct Watch {
    /// Scene file
    scene: String,
    /// Local port that serves the page. Default: a free one
    #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u16).range(1..))]
    port: Option<u16>,
    #[command(flatten)]
    time: TimeArgs,
}

impl Watch {
    pub fn execute(&self) -> Result<(), Failure> {
        let scene = &self.scene;
        match SceneSource::of(scene)? {
            SceneSource::Spec(SpecSource::File(file)) if file.is_file() => {
                watch::watch(&file, self.port, self.time.limit_or_default())
            }
            SceneSource::Spec(SpecSource::File(file)) => {
                let message = format!("{}: there is no such file", file.display());
                Err(Failure::input(
                    message,
                    "`machinist new NAME --spec-only` writes one to begin with",
                ))
            }
            SceneSource::Spec(SpecSource::BuiltIn(_)) => {
                let message = format!("{scene} is a built-in scene, not a file");
                Err(Failure::input(
                    message,
                    "give a scene file; `machinist new NAME --spec-only` writes one",
                ))
            }
            SceneSource::Model(_) => {
                let message = format!("{scene} is a model file, not a spec");
                Err(Failure::input(message, "give the spec it was compiled from"))
            }
        }
    }
}
