//! Options of estimators, which `gen` emits and `verify` tests.

use clap::{Args, ValueEnum};
use machinist::estimator::{EstimatorDesign, EstimatorIndices};
use machinist_contract::Simulator;
use machinist_contract::fixed_step::StepMethod;

use super::amount::{Amount, assignment, in_unit, quantity_of};
use crate::failure::Failure;

/// Kind of an estimator.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Kind {
    /// Extended Kalman filter
    Ekf,
}

#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Estimator")]
pub struct EstimatorArgs {
    /// Kind of a state estimator: ekf, an extended Kalman filter on fixed steps
    #[arg(long, value_name = "KIND", requires = "measure")]
    estimator: Option<Kind>,
    /// Measured outputs, with the standard deviations of their noise
    #[arg(
        long,
        value_name = "OUTPUT=DEVIATION",
        value_parser = assignment,
        value_delimiter = ',',
        requires = "estimator"
    )]
    measure: Vec<(String, Amount)>,
    /// Noise: of parameters, in their unit times the root of a second; of states and estimated
    /// parameters, in their unit per root of a second
    #[arg(
        long,
        value_name = "NAME=INTENSITY",
        value_parser = assignment,
        value_delimiter = ',',
        requires = "estimator"
    )]
    noise: Vec<(String, Amount)>,
    /// Parameters to estimate with the state
    #[arg(long, value_name = "NAMES", value_delimiter = ',', requires = "estimator")]
    estimate: Vec<String>,
    /// Standard deviations of states and estimated parameters at the start; known without one
    #[arg(
        long,
        value_name = "NAME=DEVIATION",
        value_parser = assignment,
        value_delimiter = ',',
        requires = "estimator"
    )]
    uncertain: Vec<(String, Amount)>,
}

impl EstimatorArgs {
    /// Reports whether an estimator is asked for.
    pub fn is_given(&self) -> bool {
        self.estimator.is_some()
    }

    /// Returns the design in a scene.
    pub fn indices(
        &self,
        simulator: &dyn Simulator<f64>,
        method: StepMethod,
    ) -> Result<EstimatorIndices, Failure> {
        let design = EstimatorDesign {
            method,
            measured: of_outputs(simulator, &self.measure)?,
            estimated: self.estimate.clone(),
            noise: of_states(simulator, &self.noise)?,
            start: of_states(simulator, &self.uncertain)?,
        };
        design.indices(simulator).map_err(|error| Failure::input(error, ""))
    }

    /// Returns the options as they stand on a command line.
    #[cfg(feature = "derive")]
    pub fn told(&self) -> String {
        if !self.is_given() {
            return String::new();
        }
        let list = |of: &[(String, Amount)]| {
            let one = |(name, amount): &(String, Amount)| match &amount.unit {
                Some(unit) => format!("\"{name}={} [{unit}]\"", in_unit(amount.value, unit)),
                None => format!("{name}={}", amount.value),
            };
            of.iter().map(one).collect::<Vec<_>>().join(",")
        };
        let mut text = " --estimator ekf".to_owned();
        for (option, value) in [
            ("--measure", list(&self.measure)),
            ("--noise", list(&self.noise)),
            ("--estimate", self.estimate.join(",")),
            ("--uncertain", list(&self.uncertain)),
        ] {
            if !value.is_empty() {
                text.extend([" ", option, " ", &value]);
            }
        }
        text
    }
}

/// Returns deviations of outputs in the units of the outputs.
fn of_outputs(
    simulator: &dyn Simulator<f64>,
    given: &[(String, Amount)],
) -> Result<Vec<(String, f64)>, Failure> {
    let deviation = |(name, amount): &(String, Amount)| {
        let count = simulator.shape().outputs;
        let output = (0..count).map(|index| simulator.output(index)).find(|o| o.name == name);
        // Unknown names are refused by the design.
        let Some(output) = output else { return Ok((name.clone(), amount.value)) };
        amount.check(name, output.unit)?;
        // Amounts with a unit are in SI units; outputs may be in others.
        let value = match amount.unit {
            Some(_) => in_unit(amount.value, output.unit),
            None => amount.value,
        };
        Ok((name.clone(), value))
    };
    given.iter().map(deviation).collect()
}

/// Returns deviations of states and parameters, in SI units.
fn of_states(
    simulator: &dyn Simulator<f64>,
    given: &[(String, Amount)],
) -> Result<Vec<(String, f64)>, Failure> {
    let deviation = |(name, amount): &(String, Amount)| {
        if let Some(quantity) = quantity_of(simulator, name) {
            amount.check(name, quantity.unit)?;
        }
        Ok((name.clone(), amount.value))
    };
    given.iter().map(deviation).collect()
}
