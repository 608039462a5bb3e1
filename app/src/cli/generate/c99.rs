//! `machinist gen --target c99`: one scene as C99.

use std::path::Path;

use clap::{Args, ValueEnum};
use machinist::Simulation;
use machinist::linear_analysis::{Place, operating_point};
use machinist_codegen::emit::c99::{C99Options, Real, needs_start, step_cost};
use machinist_codegen::write::{Mode, WriteError, emit_c99};
use machinist_contract::fixed_step::StepMethod;
use machinist_fmu::variables::{Unfit, Variables};
use machinist_model::{Model, ModelSimulator};

use super::describe;
use crate::cli::output::print;
use crate::cli::run::step_method;
use crate::cli::scene::stamped;
use crate::failure::{Failure, did_you_mean};

/// The type of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Width {
    F64,
    F32,
}

#[derive(Debug, Args)]
pub struct Options {
    /// With --target c99: type of numbers, f64 (double) or f32 (float). Default: f64
    #[arg(long, value_name = "TYPE")]
    real: Option<Width>,
    /// With --target c99: step method, rk4, heun or ros2. Default: rk4
    #[arg(long, value_name = "NAME", value_parser = step_method)]
    step: Option<StepMethod>,
    /// With --target c99: parameters that become inputs, in a separate struct, and can be set
    /// during the run
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    inputs: Vec<String>,
}

impl Options {
    /// Returns an error if options of C99 are given for another target.
    pub fn refuse(&self) -> Result<(), Failure> {
        let given = [
            ("--real", self.real.is_some()),
            ("--step", self.step.is_some()),
            ("--inputs", !self.inputs.is_empty()),
        ];
        match given.into_iter().find(|(_, is_given)| *is_given) {
            None => Ok(()),
            Some((option, _)) => {
                Err(Failure::input(format!("{option} requires --target c99"), "add --target c99"))
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
        let model = stamped(scene, keep_all)?.model;
        self.check_inputs(&model)?;
        let options = C99Options {
            real: match self.real {
                None | Some(Width::F64) => Real::Double,
                Some(Width::F32) => Real::Float,
            },
            method: self.step.unwrap_or_default(),
            command: self.command(scene, keep_all),
            inputs: self.inputs.clone(),
            start: start(&model)?,
        };
        match emit_c99(out, &model, &options, mode) {
            Ok(summary) => {
                let cost = step_cost(&model, options.method);
                let most = match cost.parts {
                    1 => String::new(),
                    parts => format!(", at most {} in {parts} parts", cost.most),
                };
                let step = format!("a step takes {} operations{most}\n", cost.usual);
                print(&format!("{}{step}", describe(&summary, "")))
            }
            Err(WriteError::NotFresh { files, .. }) => {
                let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
                let message = format!("out of date: {}", names.join(", "));
                Err(Failure::unsuccessful(message, "without `--check` it is written again"))
            }
            Err(error) => Err(error.into()),
        }
    }

    /// Returns an error for inputs that are given twice, that do not exist, or that the equations
    /// take to be constant.
    fn check_inputs(&self, model: &Model) -> Result<(), Failure> {
        if self.inputs.is_empty() || !model.fields.is_empty() {
            return Ok(());
        }
        let all = &self.inputs;
        if let Some(twice) = (1..all.len()).find(|at| all[..*at].contains(&all[*at])) {
            return Err(Failure::input(format!("--inputs {} is given twice", all[twice]), ""));
        }
        let simulator = ModelSimulator::interpreted(model.clone());
        let unfit = Variables::of(model, simulator.single(), all).err();
        unfit.map_or(Ok(()), |unfit| Err(refused(&unfit, model)))
    }

    /// Returns the command that renews the files, in a folder of the reader's choice.
    fn command(&self, scene: &str, keep_all: bool) -> String {
        // Without the folder of the file on this machine.
        let name = Path::new(scene).file_name().unwrap_or(scene.as_ref()).to_string_lossy();
        let mut command = format!("machinist gen --target c99 {name} -o .");
        if self.real == Some(Width::F32) {
            command.push_str(" --real f32");
        }
        if let Some(step) = self.step {
            command.extend([" --step ", step.name()]);
        }
        if !self.inputs.is_empty() {
            command.extend([" --inputs ", &*self.inputs.join(",")]);
        }
        if keep_all {
            command.push_str(" --keep-all");
        }
        command
    }
}

/// Explains why a parameter cannot be an input.
fn refused(unfit: &Unfit, model: &Model) -> Failure {
    let help = match unfit {
        Unfit::UnknownInput { name, .. } => {
            did_you_mean(name, model.parameters.iter().map(|p| p.quantity.name.path.as_str()))
        }
        Unfit::NotAnInput { .. } => {
            "forces, torques, voltages and other terms of the motion can be".to_owned()
        }
        Unfit::NoFields { .. } | Unfit::Cut(_) => String::new(),
    };
    Failure::input(unfit, help)
}

/// Returns the state in which a run starts, if it differs from the initial values of the spec.
pub fn start(model: &Model) -> Result<Option<Vec<f64>>, Failure> {
    if !model.fields.is_empty() || !needs_start(model) {
        return Ok(None);
    }
    let simulator = ModelSimulator::interpreted(model.clone());
    let run = Simulation::new(&simulator);
    Ok(Some(operating_point(&run, Place::Initial)?.state))
}
