//! Options of estimators, which `gen` emits and `verify` tests.

mod fitted;

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use machinist::estimator::{EstimatorDesign, EstimatorIndices};
use machinist_contract::Simulator;
use machinist_contract::fixed_step::FixedMethod;

use super::amount::{Amount, assignment, in_unit, quantity_of};
use crate::failure::Failure;
use fitted::Fitted;

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
    /// Measured outputs, with the standard deviations of their noise. Default of a deviation: the
    /// residuals in --fitted
    #[arg(
        long,
        value_name = "OUTPUT[=DEVIATION]",
        value_parser = perhaps_assigned,
        value_delimiter = ',',
        requires = "estimator"
    )]
    measure: Vec<(String, Option<Amount>)>,
    /// Result of `machinist fit --json` on measurements of the machine: its residuals give the
    /// noise of measurements, its standard errors the deviations of parameters
    #[arg(long, value_name = "FILE", requires = "estimator")]
    fitted: Option<PathBuf>,
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
    /// Standard deviations of states and estimated parameters at the start; known without one.
    /// Default of a deviation: the standard error in --fitted
    #[arg(
        long,
        value_name = "NAME[=DEVIATION]",
        value_parser = perhaps_assigned,
        value_delimiter = ',',
        requires = "estimator"
    )]
    uncertain: Vec<(String, Option<Amount>)>,
}

impl EstimatorArgs {
    /// Reports whether an estimator is asked for.
    pub fn is_given(&self) -> bool {
        self.estimator.is_some()
    }

    /// Returns the design in a scene.
    pub fn indices<'m>(
        &self,
        simulator: &dyn Simulator<f64>,
        method: FixedMethod<'m>,
    ) -> Result<EstimatorIndices<'m>, Failure> {
        let design = EstimatorDesign {
            method,
            measured: of_outputs(simulator, &self.measured()?)?,
            estimated: self.estimate.clone(),
            noise: of_states(simulator, &self.noise)?,
            start: of_states(simulator, &self.started()?)?,
        };
        design.indices(simulator).map_err(|error| Failure::input(error, ""))
    }

    /// Returns the measured outputs, with deviations from the fit where none is given.
    fn measured(&self) -> Result<Vec<(String, Amount)>, Failure> {
        self.completed("measure", &self.measure, Fitted::deviation)
    }

    /// Returns the deviations at the start, likewise.
    fn started(&self) -> Result<Vec<(String, Amount)>, Failure> {
        self.completed("uncertain", &self.uncertain, Fitted::standard_error)
    }

    fn completed(
        &self,
        option: &str,
        given: &[(String, Option<Amount>)],
        found: impl Fn(&Fitted, &str, &Path) -> Result<Amount, Failure>,
    ) -> Result<Vec<(String, Amount)>, Failure> {
        let is_open = given.iter().any(|(_, amount)| amount.is_none());
        let fitted = match &self.fitted {
            Some(path) if is_open => Some((Fitted::read(path)?, path)),
            _ => None,
        };
        let complete = |(name, amount): &(String, Option<Amount>)| {
            let amount = match (amount, &fitted) {
                (Some(amount), _) => amount.clone(),
                (None, Some((fitted, path))) => found(fitted, name, path)?,
                (None, None) => {
                    let message = format!("--{option} {name} has no deviation");
                    let help =
                        format!("give it, {name}=DEVIATION, or the result of a fit: --fitted FILE");
                    return Err(Failure::input(message, help));
                }
            };
            Ok((name.clone(), amount))
        };
        given.iter().map(complete).collect()
    }

    /// Returns the options as they stand on a command line, with the deviations of a fit.
    #[cfg(feature = "derive")]
    pub fn describe(&self) -> Result<String, Failure> {
        if !self.is_given() {
            return Ok(String::new());
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
            ("--measure", list(&self.measured()?)),
            ("--noise", list(&self.noise)),
            ("--estimate", self.estimate.join(",")),
            ("--uncertain", list(&self.started()?)),
        ] {
            if !value.is_empty() {
                text.extend([" ", option, " ", &value]);
            }
        }
        Ok(text)
    }
}

/// Parses a name, with or without a value.
fn perhaps_assigned(text: &str) -> Result<(String, Option<Amount>), String> {
    if text.contains('=') {
        let (name, amount) = assignment(text)?;
        return Ok((name, Some(amount)));
    }
    match text.trim() {
        "" => Err("write it as NAME or NAME=VALUE".to_owned()),
        name => Ok((name.to_owned(), None)),
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
