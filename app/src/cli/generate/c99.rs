//! `machinist gen --target c99`: one scene as C99.

use std::fmt::Write as _;
use std::path::Path;

use clap::{Args, ValueEnum};
use machinist::Simulation;
use machinist::estimator::EstimatorIndices;
use machinist::field::Discretisation;
use machinist::linear_analysis::{Place, operating_point};
use machinist_codegen::emit::c99::{
    C99Options, EstimatorOptions, FilterCost, Real, filter_cost, needs_start, rust_filter_cost,
    step_cost,
};
use machinist_codegen::write::{Mode, WriteError, emit_c99, emit_rust_estimator};
use machinist_contract::Simulator;
use machinist_contract::fixed_step::StepMethod;
use machinist_fmu::variables::{Unfit, Variables};
use machinist_model::{Elimination, Model, ModelSimulator};

use super::describe;
use crate::cli::arguments::FieldArgs;
use crate::cli::estimator::EstimatorArgs;
use crate::cli::output::print;
use crate::cli::run::step_method;
use crate::cli::scene::stamped;
use crate::failure::{Failure, did_you_mean};
use crate::fields::whole;

/// The type of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Width {
    F64,
    F32,
}

#[derive(Debug, Clone, Args)]
pub struct Options {
    /// With --target c99: type of numbers, f64 (double) or f32 (float). Default: f64
    #[arg(long, value_name = "TYPE")]
    real: Option<Width>,
    /// With --target c99 or --estimator: step method, rk4, heun or ros2. Default: rk4
    #[arg(long, value_name = "NAME", value_parser = step_method)]
    step: Option<StepMethod>,
    /// With --target c99: parameters that become inputs, in a separate struct, and can be set
    /// during the run
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    inputs: Vec<String>,
    #[command(flatten)]
    fields: FieldArgs,
}

impl Options {
    /// Returns an error if options of C99 are given for another target.
    pub fn refuse(&self) -> Result<(), Failure> {
        let given = [
            ("--real", self.real.is_some()),
            ("--step", self.step.is_some()),
            ("--inputs", !self.inputs.is_empty()),
            ("--elements", self.fields.elements.is_some()),
            ("--order", self.fields.order.is_some()),
        ];
        match given.into_iter().find(|(_, is_given)| *is_given) {
            None => Ok(()),
            Some((option, _)) => {
                Err(Failure::input(format!("{option} requires --target c99"), "add --target c99"))
            }
        }
    }

    /// Emits a scene with a filter as Rust.
    pub fn estimator(
        &self,
        scene: &str,
        estimator: &EstimatorArgs,
        keep_all: bool,
        out: &Path,
        mode: Mode,
    ) -> Result<(), Failure> {
        Self { step: None, fields: FieldArgs::default(), ..self.clone() }.refuse()?;
        let model = self.model(scene, keep_all)?;
        let method = self.step.unwrap_or_default();
        let filter = emitted(&model, estimator, method)?;
        let start = match start(&model)? {
            Some(start) => start,
            None => initial(&model),
        };
        let name = Path::new(scene).file_name().unwrap_or(scene.as_ref()).to_string_lossy();
        let mut command = format!("machinist gen {name} -o .{}", estimator.describe()?);
        if let Some(step) = self.step {
            command.extend([" --step ", step.name()]);
        }
        command.push_str(&self.division());
        let FilterCost { predict, correct } = rust_filter_cost(&model, method, &filter);
        let filter = (&filter, method, &start[..]);
        let summary = emit_rust_estimator(out, &model, filter, &command, mode);
        let text = describe(&fresh(summary)?, "");
        let correct = format!("a correction takes at most {correct} operations");
        print(&format!("{text}a prediction takes {predict}\n{correct}\n"))
    }

    pub fn execute(
        &self,
        (scene, estimator): (&str, &EstimatorArgs),
        keep_all: bool,
        out: &Path,
        mode: Mode,
    ) -> Result<(), Failure> {
        let model = self.model(scene, keep_all)?;
        self.check_inputs(&model)?;
        let method = self.step.unwrap_or_default();
        let filter =
            estimator.is_given().then(|| emitted(&model, estimator, method)).transpose()?;
        let options = C99Options {
            real: match self.real {
                None | Some(Width::F64) => Real::Double,
                Some(Width::F32) => Real::Float,
            },
            method,
            command: format!("{}{}", self.command(scene, keep_all), estimator.describe()?),
            inputs: self.inputs.clone(),
            start: start(&model)?,
            estimator: filter,
        };
        let (summary, stack) = fresh(emit_c99(out, &model, &options, mode))?;
        let cost = step_cost(&model, options.method, options.real);
        let mut costs = vec![("step", "a step takes", cost.to_string())];
        if let Some(filter) = &options.estimator {
            let cost = filter_cost(&model, (options.method, options.real), filter);
            costs.push(("estimator_predict", "a prediction takes", cost.predict.to_string()));
            let correct = format!("at most {} operations", cost.correct);
            costs.push(("estimator_correct", "a correction takes", correct));
        }
        let mut text = describe(&summary, "");
        for (function, takes, cost) in costs {
            let _ = writeln!(text, "{takes} {cost}");
            if let Some(bound) = stack.function(&format!("{}_{function}", model.name)) {
                let _ = writeln!(text, "  its stack holds {bound}");
            }
        }
        print(&text)
    }

    /// Returns the model of a scene, with its fields divided.
    fn model(&self, scene: &str, keep_all: bool) -> Result<Model, Failure> {
        let FieldArgs { elements, order } = self.fields;
        whole(stamped(scene, keep_all)?.model, Discretisation { elements, order })
    }

    /// Returns an error for inputs that are given twice, that do not exist, or that the equations
    /// take to be constant.
    fn check_inputs(&self, model: &Model) -> Result<(), Failure> {
        if self.inputs.is_empty() {
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
        command.push_str(&self.division());
        if keep_all {
            command.push_str(" --keep-all");
        }
        command
    }

    /// Returns the options that divide fields, as they stand on a command line.
    fn division(&self) -> String {
        let FieldArgs { elements, order } = self.fields;
        let given = [("elements", elements), ("order", order)].into_iter();
        given.filter_map(|(name, value)| Some(format!(" --{name} {}", value?))).collect()
    }
}

/// Returns what has been written, or an error that names files that are out of date.
fn fresh<T>(written: Result<T, WriteError>) -> Result<T, Failure> {
    match written {
        Ok(written) => Ok(written),
        Err(WriteError::NotFresh { files, .. }) => {
            let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
            let message = format!("out of date: {}", names.join(", "));
            Err(Failure::unsuccessful(message, "without `--check` it is written again"))
        }
        Err(error) => Err(error.into()),
    }
}

/// Returns the filter of a scene for emission.
fn emitted(
    model: &Model,
    estimator: &EstimatorArgs,
    method: StepMethod,
) -> Result<EstimatorOptions, Failure> {
    let simulator = ModelSimulator::interpreted(model.clone());
    let list = Elimination::new(model.states.len(), &model.rate_jacobian.pattern.entries);
    let found = estimator.indices(simulator.single(), method.with(list.borrowed()))?;
    let EstimatorIndices { measured, estimated, diffusing, disturbed, start, .. } = found;
    Ok(EstimatorOptions { measured, estimated, diffusing, disturbed, start })
}

/// Returns the initial state of the spec.
fn initial(model: &Model) -> Vec<f64> {
    let simulator = ModelSimulator::interpreted(model.clone());
    let parameters: Vec<f64> = model.parameters.iter().map(|p| p.value).collect();
    let mut state = vec![0.0; model.states.len()];
    simulator.initial_state(&parameters, &mut state);
    state
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
    if !needs_start(model) {
        return Ok(None);
    }
    let simulator = ModelSimulator::interpreted(model.clone());
    let run = Simulation::new(&simulator);
    Ok(Some(operating_point(&run, Place::Initial)?.state))
}
