//! `machinist report`: pages with everything, of all machines or of one.

use std::path::PathBuf;

use clap::Args;

use super::generate::EMITTED;
use super::output::{print, write_file};
use super::scene;
use crate::failure::Failure;
use crate::report;

#[derive(Debug, Args)]
pub struct Report {
    /// Scene file of a machine of one's own, or the name of a spec: a page for this machine.
    /// Without it, a page for every machine of the folder of scenes, with an index
    scene: Option<String>,
    /// The folder to write into
    #[arg(long, value_name = "DIR", default_value = "target/report")]
    out: PathBuf,
    /// The folder of the scenes
    #[arg(long, value_name = "DIR", default_value = scene::SCENES, conflicts_with = "scene")]
    specs: PathBuf,
    /// The folder of the emitted files, which are brought up to date
    #[arg(long, value_name = "DIR", default_value = EMITTED, conflicts_with = "scene")]
    emitted: PathBuf,
    /// Leave out error against run time: pages are then the same every time
    #[arg(long)]
    no_times: bool,
}

impl Report {
    /// Pages are written also if a check fails, for they say which.
    pub fn execute(&self) -> Result<(), Failure> {
        let pages = match &self.scene {
            Some(scene) => report::own(scene, !self.no_times)?,
            None => report::whole(&self.specs, &self.emitted, !self.no_times)?,
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
            Err(Failure::unsuccessful(message, ""))
        }
    }
}
