//! `machinist gen --target c99`: one scene as C99.

use std::path::Path;

use clap::{Args, ValueEnum};
use machinist::Simulation;
use machinist::linear_analysis::{Place, operating_point};
use machinist_codegen::emit::c99::{C99Options, FixedMethod, Real};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::write::{Mode, emit_c99};
use machinist_model::{Model, ModelSimulator};

use super::describe;
use crate::cli::output::print;
use crate::cli::scene::{Given, derived};
use crate::failure::{Failure, did_you_mean};

/// The type of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Width {
    F64,
    F32,
}

/// How steps are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Step {
    /// Runge-Kutta's classical method of order 4
    Rk4,
    /// Heun's method of order 2
    Heun,
}

#[derive(Debug, Args)]
pub struct Options {
    /// With --target c99: the type of numbers, double or float; f64 unless given
    #[arg(long, value_name = "TYPE")]
    real: Option<Width>,
    /// With --target c99: the method of a step; rk4 unless given
    #[arg(long, value_name = "NAME")]
    step: Option<Step>,
    /// With --target c99: parameters that are set along the run, which get a struct of their own
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    inputs: Vec<String>,
}

impl Options {
    /// Refuses options of C99 where something else is emitted.
    pub fn refuse(&self) -> Result<(), Failure> {
        let given = [
            ("--real", self.real.is_some()),
            ("--step", self.step.is_some()),
            ("--inputs", !self.inputs.is_empty()),
        ];
        match given.into_iter().find(|(_, is_given)| *is_given) {
            None => Ok(()),
            Some((option, _)) => {
                Err(Failure::input(format!("{option} is of --target c99"), "name that target too"))
            }
        }
    }

    pub fn execute(
        &self,
        scene: &str,
        keep_all: bool,
        out: &Path,
        mode: Mode,
    ) -> Result<(), Failure> {
        let model = model(scene, keep_all)?;
        let known = model.parameters.iter().map(|p| p.quantity.name.path.as_str());
        if let Some(name) = self.inputs.iter().find(|name| !known.clone().any(|k| k == **name)) {
            let message = format!("scene `{}` has no parameter `{name}`", model.name);
            return Err(Failure::input(message, did_you_mean(name, known)));
        }
        let options = C99Options {
            real: match self.real {
                None | Some(Width::F64) => Real::Double,
                Some(Width::F32) => Real::Float,
            },
            method: match self.step {
                None | Some(Step::Rk4) => FixedMethod::RungeKutta4,
                Some(Step::Heun) => FixedMethod::Heun,
            },
            command: self.command(scene, keep_all),
            inputs: self.inputs.clone(),
            start: start(&model)?,
        };
        print(&describe(&emit_c99(out, &model, &options, mode)?, ""))
    }

    /// The command that makes the files again, in a folder that the reader names.
    fn command(&self, scene: &str, keep_all: bool) -> String {
        // Not where the file is on this machine.
        let name = Path::new(scene).file_name().unwrap_or(scene.as_ref()).to_string_lossy();
        let mut command = format!("machinist gen --target c99 {name} -o .");
        if self.real == Some(Width::F32) {
            command.push_str(" --real f32");
        }
        if self.step == Some(Step::Heun) {
            command.push_str(" --step heun");
        }
        if !self.inputs.is_empty() {
            command.push_str(&format!(" --inputs {}", self.inputs.join(",")));
        }
        if keep_all {
            command.push_str(" --keep-all");
        }
        command
    }
}

fn model(scene: &str, keep_all: bool) -> Result<Model, Failure> {
    match Given::of(scene)? {
        Given::Model(_) if keep_all => {
            let message = format!("{scene} is a model already");
            Err(Failure::input(message, "leave `--keep-all` out"))
        }
        Given::Model(stamped) => Ok(stamped.model),
        Given::Spec(source) => derived(&source, keep_all),
    }
}

/// The state in which a run starts, if that is more than the initial values of the spec.
fn start(model: &Model) -> Result<Option<Vec<f64>>, Failure> {
    if !model.fields.is_empty() || (model.constraints.is_empty() && !model.starts_in_equilibrium) {
        return Ok(None);
    }
    let simulator = ModelSimulator::interpreted(model.clone());
    let run = Simulation::new(&simulator);
    Ok(Some(operating_point(&run, Place::Initial)?.state))
}
