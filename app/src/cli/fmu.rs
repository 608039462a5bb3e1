//! `machinist fmu`: a scene as a functional mock-up unit, which hosts of FMI 2.0 or 3.0 run.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use machinist_codegen::emit::c99::FmiVersion;
use machinist_contract::fixed_step::StepMethod;
use machinist_fmu::resource::Export;

use super::amount::time;
use super::arguments::{FieldArgs, SourceArgs};
use super::output::{print, require_ending, write_file};
use super::run::step_method;
use crate::failure::Failure;
use crate::fmu::{Archive, Content, Library, SourceSettings};

/// Version of the standard.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Version {
    #[value(name = "2")]
    Two,
    #[value(name = "3")]
    Three,
}

#[derive(Debug, Args)]
pub struct Fmu {
    /// Version of the standard: 2 for FMI 2.0, 3 for FMI 3.0
    #[arg(long, value_name = "VERSION", default_value = "3")]
    fmi: Version,
    /// Parameters and inputs of units that become inputs, which the importer sets during the run. An
    /// input bound to an expression gets a variable that is added to it
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    inputs: Vec<String>,
    /// Shared library to include, instead of the one beside this program
    #[arg(long, value_name = "FILE")]
    library: Option<PathBuf>,
    /// Include C99 sources instead of the library, for hosts that compile
    #[arg(long, conflicts_with = "library")]
    source: bool,
    /// With --source: step method of Co-Simulation, rk4, heun or ros2. Default: rk4, or ros2 for a
    /// stiff machine
    #[arg(long, value_name = "NAME", requires = "source", value_parser = step_method)]
    step: Option<StepMethod>,
    /// With --source: largest step of Co-Simulation, `1ms`. Default: the output interval, halved
    /// until errors in the scene's run are below 1e-4 of the range of each output
    #[arg(long, value_name = "TIME", requires = "source", value_parser = time, allow_hyphen_values = true)]
    step_size: Option<f64>,
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
        let content = self.content()?;
        let (stamped, inputs) = self.scene.stamped_opened(&self.inputs)?;
        let FieldArgs { elements, order } = self.fields;
        let export = Export { inputs, elements, order };
        let archive = Archive::of(&stamped, &export, self.version(), &content)?;
        write_file(&self.out, |out| out.write_all(archive.bytes()))?;
        let (name, out) = (&stamped.model.name, self.out.display());
        let [variables, bytes] = [archive.variables(), archive.bytes().len()];
        let steps = archive.statement().map(|text| format!("Co-Simulation: {text}\n"));
        let steps = steps.unwrap_or_default();
        print(&format!("wrote {out}: {name}, {variables} variables, {bytes} bytes\n{steps}"))
    }

    fn version(&self) -> FmiVersion {
        match self.fmi {
            Version::Two => FmiVersion::Two,
            Version::Three => FmiVersion::Three,
        }
    }

    fn content(&self) -> Result<Content, Failure> {
        if !self.source {
            return Ok(Content::Library(Library::find(self.library.as_deref())?));
        }
        if let Some(step) = self.step_size
            && !(step > 0.0 && step.is_finite())
        {
            let message = format!("--step-size {step}: the step size must be above zero");
            return Err(Failure::input(message, "such as `--step-size 1ms`"));
        }
        let settings =
            SourceSettings { method: self.step, step: self.step_size, command: self.command() };
        Ok(Content::Sources(settings))
    }

    /// Returns the command that makes the archive again, in a folder of the reader's choice.
    fn command(&self) -> String {
        // Without the folder of the file on this machine.
        let file =
            |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let [scene, out] = [Path::new(&self.scene.scene), &self.out].map(file);
        let mut command = format!("machinist fmu {scene} --out {out} --source");
        if self.fmi == Version::Two {
            command.push_str(" --fmi 2");
        }
        if let Some(step) = self.step {
            command.extend([" --step ", step.name()]);
        }
        if let Some(size) = self.step_size {
            command.extend([" --step-size ", &size.to_string()]);
        }
        if !self.inputs.is_empty() {
            command.extend([" --inputs ", &*self.inputs.join(",")]);
        }
        let FieldArgs { elements, order } = self.fields;
        for (name, value) in [("elements", elements), ("order", order)] {
            if let Some(value) = value {
                command.extend([" --", name, " ", &value.to_string()]);
            }
        }
        if self.scene.keep.keep_all {
            command.push_str(" --keep-all");
        }
        command
    }
}
