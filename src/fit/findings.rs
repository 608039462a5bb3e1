//! Results of a fit and their uncertainty.

use machinist_contract::{Quantity, Simulator};
use serde::Serialize;

use super::statistics::{Chance, Direction, Statistics, chance, statistics, students_t};
use super::{Bounds, ColumnResiduals, Fit, Fitted, Unknown};
use crate::sorting::sort_descending;

/// Relative error above which a parameter counts as not determined by the data.
const FAR: f64 = 0.5;
/// Share of a combination below which a parameter is not named.
const MINOR: f64 = 0.1;
/// Ratio of residuals to measured values below which residuals may be errors of the runs.
const ROUNDING: f64 = 1e-6;

/// Results of a fit.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Findings {
    /// Number of compared values.
    pub values: usize,
    /// Estimated parameters and initial values.
    pub parameters: Vec<FoundParameter>,
    /// Correlation of every two parameters; null if one of them is not determined.
    pub correlations: Vec<Vec<Option<f64>>>,
    /// Combinations of parameters that the data hardly determine.
    pub untold: Vec<Combination>,
    /// Residuals of each output.
    pub outputs: Vec<OutputResidual>,
}

/// An estimated parameter or initial value.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct FoundParameter {
    /// Name of the parameter or state.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Start of the search.
    pub start: f64,
    /// Estimate.
    pub value: f64,
    /// Standard error; null if the data do not determine the parameter, or it is at a bound.
    pub standard_error: Option<f64>,
    /// Confidence interval of 95 %.
    pub confidence_95: Option<[f64; 2]>,
    /// True if the estimate is at a bound.
    pub is_at_bound: bool,
}

/// A combination of parameters that the data hardly determine.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Combination {
    /// Names of parameters and their relative changes.
    pub shares: Vec<(String, f64)>,
    /// Relative standard error along this combination; null if the data do not determine it.
    pub standard_error: Option<f64>,
}

/// Residuals of one output.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct OutputResidual {
    /// Name of the experiment.
    pub experiment: String,
    /// Name of the output.
    pub output: String,
    /// Its unit.
    pub unit: String,
    /// Number of compared values.
    pub values: usize,
    /// Root mean square of the residuals, in the unit of the output.
    pub rms: f64,
    /// Largest residual.
    pub largest: f64,
    /// Divisor of the residuals: a standard deviation, or the root mean square of all.
    pub scale: f64,
    /// True if the residuals are small enough to be errors of the runs.
    pub is_rounding: bool,
    /// Correlation of each residual with the next. This and the following are null if there are too
    /// few residuals.
    pub autocorrelation: Option<f64>,
    /// Number of runs of one sign.
    pub runs: Option<usize>,
    /// Number of runs expected by chance.
    pub expected_runs: Option<f64>,
    /// Probability of a number of runs that deviates as much by chance.
    pub probability_of_runs: Option<f64>,
}

impl Fit<'_> {
    /// Computes statistics at the end of a search, and which unknowns are at a bound there.
    pub(super) fn statistics_of(&self, fitted: &Fitted) -> (Statistics, Vec<bool>) {
        let Fitted { found, loss, .. } = fitted;
        let values = self.values(&found.at);
        let is_held = |(value, unknown): (&f64, &Unknown)| {
            let Bounds { low, high } = unknown.bounds;
            *value <= low || *value >= high
        };
        let held: Vec<bool> = values.iter().zip(self.unknowns).map(is_held).collect();
        // One unit of a search coordinate is a relative change, except for unknowns whose size
        // differs from their start.
        let sizes: Vec<f64> = self
            .unknowns
            .iter()
            .zip(&found.at)
            .map(
                |(unknown, at)| if unknown.is_logarithmic() || *at == 0.0 { 1.0 } else { at.abs() },
            )
            .collect();
        let told = statistics(&found.evaluation, *loss, (&sizes, FAR), &held);
        (told, held)
    }

    /// Returns the estimates and their uncertainty.
    #[must_use]
    pub fn findings(&self, fitted: &Fitted) -> Findings {
        let Fitted { found, scales, .. } = fitted;
        let simulator = self.simulation.simulator();
        let values = self.values(&found.at);
        let (told, held) = self.statistics_of(fitted);
        let t = students_t(told.freedom);
        let parameter = |k: usize| {
            let (unknown, at) = (&self.unknowns[k], found.at[k]);
            let error = told.errors[k];
            let has_interval = !held[k] && error.is_finite() && t.is_finite();
            let ends = [-1.0, 1.0].map(|side: f64| unknown_value(unknown, at + side * t * error));
            let slope = (unknown_value(unknown, at + 1e-6) - values[k]) / 1e-6;
            FoundParameter {
                name: unknown.name.clone(),
                unit: quantity(simulator, &unknown.name).map_or("", |q| q.unit).to_owned(),
                start: unknown.start,
                value: values[k],
                standard_error: has_interval.then_some((slope * error).abs()),
                confidence_95: has_interval.then_some(ends),
                is_at_bound: held[k],
            }
        };
        let named = |shares: &[f64]| {
            let mut named: Vec<(String, f64)> = self
                .unknowns
                .iter()
                .zip(shares)
                .filter(|(_, share)| share.abs() >= MINOR)
                .map(|(unknown, share)| (unknown.name.clone(), *share))
                .collect();
            sort_descending(&mut named, |(_, share)| share.abs());
            named
        };
        let combination = |direction: &Direction| Combination {
            shares: named(&direction.shares),
            standard_error: direction.error.is_finite().then_some(direction.error),
        };
        let all = self.residuals_by_column(&found.evaluation, scales);
        let output = |column: &ColumnResiduals<'_>| {
            let ColumnResiduals { experiment, output, residuals, sizes } = column;
            let count = residuals.len().max(1) as f64;
            let off = || residuals.iter().zip(sizes).map(|(r, size)| (r * size).abs());
            let root_mean = |squares: f64| (squares / count).sqrt();
            let rms = root_mean(off().map(|off| off * off).sum());
            let looks: Option<Chance> = chance(residuals);
            OutputResidual {
                experiment: (*experiment).to_owned(),
                output: (*output).to_owned(),
                unit: quantity(simulator, output).map_or("", |q| q.unit).to_owned(),
                values: residuals.len(),
                rms,
                largest: off().fold(0.0, f64::max),
                scale: root_mean(sizes.iter().map(|size| size * size).sum()),
                is_rounding: rms <= ROUNDING * largest_of(self, output),
                autocorrelation: looks.map(|chance| chance.autocorrelation),
                runs: looks.map(|chance| chance.runs),
                expected_runs: looks.map(|chance| chance.expected),
                probability_of_runs: looks.map(|chance| chance.probability),
            }
        };
        let count = self.unknowns.len();
        let number = |i: usize, j: usize| {
            let value = told.correlations[(i, j)];
            value.is_finite().then_some(value)
        };
        Findings {
            values: told.count,
            parameters: (0..count).map(parameter).collect(),
            correlations: (0..count).map(|i| (0..count).map(|j| number(i, j)).collect()).collect(),
            untold: told.untold.iter().map(combination).collect(),
            outputs: all.iter().map(output).collect(),
        }
    }
}

/// Returns the largest absolute value measured for an output.
fn largest_of(fit: &Fit<'_>, name: &str) -> f64 {
    let own = fit.columns().filter(|(_, other, _)| *other == name);
    let own = own.flat_map(|(_, _, values)| values);
    own.filter(|value| !value.is_nan()).fold(0.0_f64, |most, value| most.max(value.abs()))
}

/// Returns the value of an unknown at a search coordinate, also beyond its bounds, where intervals
/// may end.
pub(super) fn unknown_value(unknown: &Unknown, inner: f64) -> f64 {
    let free = Bounds::NONE;
    if unknown.is_logarithmic() {
        inner.exp()
    } else {
        Unknown { bounds: free, ..unknown.clone() }.outer(inner)
    }
}

/// Returns the parameter, output or state of this name.
pub(super) fn quantity<'s>(simulator: &'s dyn Simulator<f64>, name: &str) -> Option<Quantity<'s>> {
    let shape = simulator.shape();
    let parameters = (0..shape.parameters).map(|index| simulator.parameter(index));
    let outputs = (0..shape.outputs).map(|index| simulator.output(index));
    let states = (0..shape.states()).map(|index| simulator.state(index));
    parameters.chain(outputs).chain(states).find(|quantity| quantity.name == name)
}
