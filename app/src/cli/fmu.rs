//! `machinist fmu`: a scene as a functional mock-up unit, which hosts of FMI 3.0 run.

use std::path::PathBuf;

use clap::Args;
use machinist_fmu::resource::Export;

use super::arguments::{FieldArgs, SourceArgs};
use super::output::{print, require_ending, write_file};
use crate::failure::Failure;
use crate::fmu::{Archive, Library};

#[derive(Debug, Args)]
pub struct Fmu {
    /// Parameters that become inputs, which the importer sets during the run
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    inputs: Vec<String>,
    /// Shared library to include, instead of the one beside this program
    #[arg(long, value_name = "FILE")]
    library: Option<PathBuf>,
    /// FMU to write, ending in .fmu
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: PathBuf,
    #[command(flatten)]
    scene: SourceArgs,
    #[command(flatten)]
    fields: FieldArgs,
}

impl Fmu {
    pub fn execute(&self) -> Result<(), Failure> {
        require_ending(&self.out, &["fmu"], "--out")?;
        let library = Library::find(self.library.as_deref())?;
        let stamped = self.scene.stamped()?;
        let FieldArgs { elements, order } = self.fields;
        let export = Export { inputs: self.inputs.clone(), elements, order };
        let archive = Archive::of(&stamped, &export, &library)?;
        write_file(&self.out, |out| out.write_all(archive.bytes()))?;
        let (name, out) = (&stamped.model.name, self.out.display());
        let [variables, bytes] = [archive.variables(), archive.bytes().len()];
        print(&format!("wrote {out}: {name}, {variables} variables, {bytes} bytes\n"))
    }
}
