//! Deviations read from the result of a fit: of measurements from its residuals, of parameters
//! from their standard errors.

use std::path::Path;

use serde::Deserialize;

use crate::cli::amount::Amount;
use crate::failure::{ErrorCode, Failure, did_you_mean};
use crate::number::number;

/// Probability below which residuals do not look like noise.
const UNLIKELY: f64 = 0.01;

/// Result of `machinist fit --json`, as far as a filter needs it.
#[derive(Debug, Deserialize)]
pub struct Fitted {
    outputs: Vec<Residual>,
    parameters: Vec<Found>,
}

#[derive(Debug, Deserialize)]
struct Residual {
    output: String,
    values: usize,
    rms: f64,
    is_rounding: bool,
    probability_of_runs: Option<f64>,
}

#[derive(Debug, Deserialize)]
struct Found {
    name: String,
    standard_error: Option<f64>,
}

impl Fitted {
    /// Reads the result of a fit.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let text = std::fs::read_to_string(path).map_err(|error| {
            let help = "`machinist fit ... --json > FILE` writes one";
            Failure::coded(ErrorCode::File, format!("{}: {error}", path.display()), help)
        })?;
        serde_json::from_str(&text).map_err(|error| {
            let message = format!("{}: not the result of a fit: {error}", path.display());
            Failure::coded(
                ErrorCode::InvalidData,
                message,
                "`machinist fit ... --json > FILE` writes one",
            )
        })
    }

    /// Returns the standard deviation of an output's measurement, in the unit of the output: the
    /// root mean square of its residuals in all experiments, with the degrees of freedom that the
    /// fitted parameters take. `file` is for messages.
    pub fn deviation(&self, output: &str, file: &Path) -> Result<Amount, Failure> {
        let of_output: Vec<&Residual> =
            self.outputs.iter().filter(|row| row.output == output).collect();
        let file = file.display();
        if of_output.is_empty() {
            let known = self.outputs.iter().map(|row| row.output.as_str());
            let message =
                format!("{file} has no residuals of `{output}`{}", did_you_mean(output, known));
            let help = format!("fit it too, or give its deviation: {output}=DEVIATION");
            return Err(Failure::input(message, help));
        }
        if of_output.iter().any(|row| row.is_rounding) {
            let message =
                format!("{file}: the residuals of `{output}` are errors of the runs, not noise");
            return Err(Failure::input(message, format!("give a deviation: {output}=DEVIATION")));
        }
        let all: usize = self.outputs.iter().map(|row| row.values).sum();
        let free = all.saturating_sub(self.parameters.len()).max(1);
        let values: usize = of_output.iter().map(|row| row.values).sum();
        let squares: f64 = of_output.iter().map(|row| row.values as f64 * row.rms * row.rms).sum();
        let value = (squares / values.max(1) as f64 * (all as f64 / free as f64)).sqrt();
        let is_unlikely = |row: &&Residual| row.probability_of_runs.is_some_and(|p| p < UNLIKELY);
        if of_output.iter().any(is_unlikely) {
            eprintln!(
                "machinist: the residuals of `{output}` in {file} do not look like noise: the \
                 machine differs from its model, and {} is no deviation of measurements alone",
                number(value, 3)
            );
        }
        Ok(Amount { value, unit: None })
    }

    /// Returns the standard error of a parameter, in SI units.
    pub fn standard_error(&self, name: &str, file: &Path) -> Result<Amount, Failure> {
        let file = file.display();
        let Some(found) = self.parameters.iter().find(|found| found.name == name) else {
            let known = self.parameters.iter().map(|found| found.name.as_str());
            let message =
                format!("{file} has no estimate of `{name}`{}", did_you_mean(name, known));
            return Err(Failure::input(message, format!("give a deviation: {name}=DEVIATION")));
        };
        let value = found.standard_error.ok_or_else(|| {
            let message = format!("{file}: the data do not determine `{name}`");
            Failure::input(message, format!("give a deviation: {name}=DEVIATION"))
        })?;
        Ok(Amount { value, unit: None })
    }
}
