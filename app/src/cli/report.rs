//! `machinist report`: one page with everything.

use std::path::PathBuf;

use clap::Args;

use super::generate::EMITTED;
use super::output::{print, write_file};
use super::scene;
use crate::failure::Failure;
use crate::report;

#[derive(Debug, Args)]
pub struct Report {
    /// The folder to write index.html into
    #[arg(long, value_name = "DIR", default_value = "target/report")]
    out: PathBuf,
    /// The folder of the scenes
    #[arg(long, value_name = "DIR", default_value = scene::SCENES)]
    specs: PathBuf,
    /// The folder of the emitted files, which are brought up to date
    #[arg(long, value_name = "DIR", default_value = EMITTED)]
    emitted: PathBuf,
    /// Leave out error against run time: the page is then the same every time
    #[arg(long)]
    no_times: bool,
}

impl Report {
    /// The page is written also if a check fails, for it says which.
    pub fn execute(&self) -> Result<(), Failure> {
        let page = report::page(&self.specs, &self.emitted, !self.no_times)?;
        std::fs::create_dir_all(&self.out).map_err(|error| Failure::file(&self.out, &error))?;
        let file = self.out.join("index.html");
        write_file(&file, |out| out.write_all(page.html.as_bytes()))?;
        print(&format!("wrote {}\n", file.display()))?;
        if page.all_passed {
            Ok(())
        } else {
            let message = "some checks failed; the page and `machinist verify` say which";
            Err(Failure::unsuccessful(message, ""))
        }
    }
}
