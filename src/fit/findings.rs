//! What a fit has found, and what the data say of it.

use machinist_contract::{Quantity, Simulator};
use serde::Serialize;

use super::statistics::{Chance, Direction, Statistics, chance, statistics, students_t};
use super::{ColumnResiduals, Fit, Fitted, Unknown};
use crate::sorting::sort_descending;

/// Unknowns that may go further than this share of themselves are not told.
const FAR: f64 = 0.5;
/// Shares of a combination below this are not named.
const MINOR: f64 = 0.1;
/// Residuals of this share of what was measured may be errors of the runs.
const ROUNDING: f64 = 1e-6;

/// All of it.
#[derive(Debug, Clone, Serialize)]
pub struct Findings {
    /// Values that were compared.
    pub values: usize,
    /// What was looked for.
    pub parameters: Vec<FoundParameter>,
    /// Correlations of each two of them; null where one is not told.
    pub correlations: Vec<Vec<Option<f64>>>,
    /// Ways along which the data say little.
    pub untold: Vec<Combination>,
    /// What is left of each output.
    pub outputs: Vec<OutputResidual>,
}

/// A parameter or initial value that was found.
#[derive(Debug, Clone, Serialize)]
pub struct FoundParameter {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Where the search started.
    pub start: f64,
    /// What was found.
    pub value: f64,
    /// Null where the data do not tell it, or a bound holds it.
    pub standard_error: Option<f64>,
    /// Interval of confidence of 95 %.
    pub confidence_95: Option<[f64; 2]>,
    /// Whether a bound holds it.
    pub is_at_bound: bool,
}

/// A way of parameters along which the data say little.
#[derive(Debug, Clone, Serialize)]
pub struct Combination {
    /// Relative changes of parameters, with their names.
    pub shares: Vec<(String, f64)>,
    /// How far it may go within a standard error; null if the data say nothing.
    pub standard_error: Option<f64>,
}

/// What an output is off in the end.
#[derive(Debug, Clone, Serialize)]
pub struct OutputResidual {
    /// Name of the experiment.
    pub experiment: String,
    /// Its name.
    pub output: String,
    /// Its unit.
    pub unit: String,
    /// Values compared.
    pub values: usize,
    /// Root of the mean square of residuals, in its unit.
    pub rms: f64,
    /// The largest of them.
    pub largest: f64,
    /// What residuals were weighed by: a standard deviation, or the root mean square of all.
    pub scale: f64,
    /// Whether they are as small as errors of the runs may be.
    pub is_rounding: bool,
    /// Of each residual with the next; null, as what follows, where they are too few.
    pub autocorrelation: Option<f64>,
    /// Runs of one sign.
    pub runs: Option<usize>,
    /// As many are expected of chance.
    pub expected_runs: Option<f64>,
    /// Probability of a number as far from that.
    pub probability_of_runs: Option<f64>,
}

impl Fit<'_> {
    /// Statistics about where a search has ended, and which unknowns a bound holds there.
    pub(super) fn told(&self, fitted: &Fitted) -> (Statistics, Vec<bool>) {
        let Fitted { found, loss, .. } = fitted;
        let values = self.values(&found.at);
        let is_held = |(value, unknown): (&f64, &Unknown)| {
            let (low, high) = unknown.bounds;
            *value <= low || *value >= high
        };
        let held: Vec<bool> = values.iter().zip(self.unknowns).map(is_held).collect();
        // One unit of what the search knows is a relative change, but of what starts at
        // another size.
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

    /// What was found, and what the data say of it.
    #[must_use]
    pub fn findings(&self, fitted: &Fitted) -> Findings {
        let Fitted { found, scales, .. } = fitted;
        let simulator = self.simulation.simulator();
        let values = self.values(&found.at);
        let (told, held) = self.told(fitted);
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

/// The largest size of what was measured.
fn largest_of(fit: &Fit<'_>, name: &str) -> f64 {
    let own = fit.columns().filter(|(_, other, _)| *other == name);
    let own = own.flat_map(|(_, _, values)| values);
    own.filter(|value| !value.is_nan()).fold(0.0_f64, |most, value| most.max(value.abs()))
}

/// The value of an unknown beyond its bounds too, as intervals may reach there.
pub(super) fn unknown_value(unknown: &Unknown, inner: f64) -> f64 {
    let free = (f64::NEG_INFINITY, f64::INFINITY);
    if unknown.is_logarithmic() {
        inner.exp()
    } else {
        Unknown { bounds: free, ..unknown.clone() }.outer(inner)
    }
}

/// The parameter, output or state of a name.
pub(super) fn quantity<'s>(simulator: &'s dyn Simulator<f64>, name: &str) -> Option<Quantity<'s>> {
    let shape = simulator.shape();
    let parameters = (0..shape.parameters).map(|index| simulator.parameter(index));
    let outputs = (0..shape.outputs).map(|index| simulator.output(index));
    let states = (0..shape.states()).map(|index| simulator.state(index));
    parameters.chain(outputs).chain(states).find(|quantity| quantity.name == name)
}
