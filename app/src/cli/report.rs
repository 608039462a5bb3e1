//! `machinist report`: pages with all results, of all machines or of one.

use std::path::PathBuf;

use clap::Args;

use super::arguments::{DeriveArgs, TimeArgs};
use super::generate::EMITTED;
use super::output::{print, write_file};
use super::scene;
use crate::failure::{ErrorCode, Failure};
use crate::report::{self, Extent};

#[derive(Debug, Args)]
pub struct Report {
    /// Scene file or name of a spec, for a page of this machine. Default: a page for each scene of
    /// the folder, with an index
    scene: Option<String>,
    /// Folder of the scenes
    #[arg(long, value_name = "DIR", default_value = scene::SCENES, conflicts_with = "scene")]
    specs: PathBuf,
    /// Folder of the emitted files, which are updated unless `--algebra` is given
    #[arg(long, value_name = "DIR", default_value = EMITTED, conflicts_with = "scene")]
    emitted: PathBuf,
    /// Leave out timings, so that pages are reproducible
    #[arg(long)]
    no_times: bool,
    /// Folder for the pages
    #[arg(
        short,
        long,
        help_heading = "Output",
        value_name = "DIR",
        default_value = "target/report"
    )]
    out: PathBuf,
    #[command(flatten)]
    time: TimeArgs,
    #[command(flatten)]
    derivation: DeriveArgs,
}

impl Report {
    /// Writes the pages even if a check fails, because they show which one.
    pub fn execute(&self) -> Result<(), Failure> {
        self.derivation.apply();
        let time_limit = self.time.limit_or_default();
        let extent = Extent { with_times: !self.no_times, time_limit };
        let pages = match &self.scene {
            Some(scene) => report::own(scene, extent)?,
            None => report::whole(&self.specs, &self.emitted, extent)?,
        };
        for (place, html) in &pages.files {
            let file = self.out.join(place);
            let folder = file.parent().unwrap_or(&self.out);
            std::fs::create_dir_all(folder).map_err(|error| Failure::file(folder, &error))?;
            write_file(&file, |out| out.write_all(html.as_bytes()))?;
        }
        if let Some((place, _)) = pages.files.first() {
            print(&format!("wrote {}\n", self.out.join(place).display()))?;
        }
        if pages.all_passed {
            Ok(())
        } else {
            let message = "some checks failed; the page and `machinist verify` say which";
            Err(Failure::ended(ErrorCode::CheckFailed, message, ""))
        }
    }
}
