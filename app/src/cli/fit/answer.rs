//! What a fit has found, for people and for programs.

use std::path::PathBuf;

use machinist::fit::{self, Chance, End, Loss, chance, statistics, students_t};
use machinist_contract::{Quantity, Simulator};
use serde::Serialize;

use super::{Fitted, scale_of};
use crate::cli::output::columns;
use crate::cli::scene::Scene;
use crate::number::{exact, number};

/// Unknowns that may go further than this share of themselves are not told.
const FAR: f64 = 0.5;
/// Shares of a combination below this are not named.
const MINOR: f64 = 0.1;
/// Correlations from this size on are named.
const CORRELATED: f64 = 0.9;
/// Residuals of this share of what was measured may be errors of the runs.
const ROUNDING: f64 = 1e-6;
/// Residuals with fewer chances than this are not chance.
const UNLIKELY: f64 = 0.01;

/// All that is to be told.
#[derive(Debug, Serialize)]
pub struct Answer {
    pub scene: String,
    pub title: String,
    /// Why the search ended.
    pub end: &'static str,
    pub steps: usize,
    pub runs: usize,
    /// Values that were compared, and places without one.
    pub values: usize,
    pub gaps: usize,
    pub from: f64,
    pub until: f64,
    pub parameters: Vec<FoundParameter>,
    /// Of each two parameters; null where one is not told.
    pub correlations: Vec<Vec<Option<f64>>>,
    pub untold: Vec<Combination>,
    pub outputs: Vec<OutputResidual>,
    /// Variants that could not be simulated, and why the first could not.
    pub failed: usize,
    pub why_failed: Option<String>,
}

#[derive(Debug, Serialize)]
pub struct FoundParameter {
    pub name: String,
    pub unit: String,
    pub start: f64,
    pub value: f64,
    /// Null where the data do not tell it, or a bound holds it.
    pub standard_error: Option<f64>,
    pub confidence_95: Option<[f64; 2]>,
    pub is_at_bound: bool,
}

/// A way of parameters along which the data say little.
#[derive(Debug, Serialize)]
pub struct Combination {
    /// Relative changes of parameters, with their names.
    pub shares: Vec<(String, f64)>,
    /// How far it may go within a standard error; null if the data say nothing.
    pub standard_error: Option<f64>,
}

#[derive(Debug, Serialize)]
pub struct OutputResidual {
    pub output: String,
    pub unit: String,
    pub values: usize,
    pub rms: f64,
    pub largest: f64,
    /// The scale by which residuals were weighed.
    pub scale: f64,
    /// Whether they are as small as errors of the runs may be.
    pub is_rounding: bool,
    pub autocorrelation: Option<f64>,
    pub runs: Option<usize>,
    pub expected_runs: Option<f64>,
    pub probability_of_runs: Option<f64>,
}

impl Answer {
    pub(super) fn new(
        fit: &fit::Fit<'_>,
        fitted: &Fitted,
        gaps: usize,
        simulator: &dyn Simulator<f64>,
    ) -> Self {
        let Fitted { found, loss, scales, lost, steps, runs } = fitted;
        let values = fit.values(&found.at);
        let is_held = |(value, unknown): (&f64, &fit::Unknown)| {
            let (low, high) = unknown.bounds;
            *value <= low || *value >= high
        };
        let held: Vec<bool> = values.iter().zip(fit.unknowns).map(is_held).collect();
        // One unit of what the search knows is a relative change, but of what starts at
        // another size.
        let sizes: Vec<f64> = fit
            .unknowns
            .iter()
            .zip(&found.at)
            .map(
                |(unknown, at)| if unknown.is_logarithmic() || *at == 0.0 { 1.0 } else { at.abs() },
            )
            .collect();
        let told = statistics(&found.evaluation, *loss, (&sizes, FAR), &held);
        let t = students_t(told.freedom);
        let parameter = |k: usize| {
            let (unknown, at) = (&fit.unknowns[k], found.at[k]);
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
            let mut named: Vec<(String, f64)> = fit
                .unknowns
                .iter()
                .zip(shares)
                .filter(|(_, share)| share.abs() >= MINOR)
                .map(|(unknown, share)| (unknown.name.clone(), *share))
                .collect();
            named.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
            named
        };
        let combination = |direction: &fit::Direction| Combination {
            shares: named(&direction.shares),
            standard_error: direction.error.is_finite().then_some(direction.error),
        };
        let all = fit.residuals_by_column(&found.evaluation);
        let output = |(name, residuals): &(&str, &[f64])| {
            let scale = scale_of(scales, name);
            let mean = residuals.iter().map(|r| r * r).sum::<f64>() / residuals.len() as f64;
            let looks: Option<Chance> = chance(residuals);
            OutputResidual {
                output: (*name).to_owned(),
                unit: quantity(simulator, name).map_or("", |q| q.unit).to_owned(),
                values: residuals.len(),
                rms: scale * mean.sqrt(),
                largest: scale * residuals.iter().fold(0.0_f64, |most, r| most.max(r.abs())),
                scale,
                is_rounding: scale * mean.sqrt() <= ROUNDING * largest_of(fit, name),
                autocorrelation: looks.map(|chance| chance.autocorrelation),
                runs: looks.map(|chance| chance.runs),
                expected_runs: looks.map(|chance| chance.expected),
                probability_of_runs: looks.map(|chance| chance.probability),
            }
        };
        let count = fit.unknowns.len();
        let number = |i: usize, j: usize| {
            let value = told.correlations[(i, j)];
            value.is_finite().then_some(value)
        };
        let times = || fit.measured.iter().flat_map(|measured| measured.times.iter().copied());
        Self {
            scene: simulator.name().to_owned(),
            title: simulator.title().to_owned(),
            end: match found.end {
                End::Converged => "converged",
                End::Steps => "ended by the number of steps",
                End::Interrupted => "interrupted",
                End::Stuck => "stuck",
            },
            steps: *steps,
            runs: *runs,
            values: told.count,
            gaps,
            from: times().fold(f64::INFINITY, f64::min),
            until: times().fold(f64::NEG_INFINITY, f64::max),
            parameters: (0..count).map(parameter).collect(),
            correlations: (0..count).map(|i| (0..count).map(|j| number(i, j)).collect()).collect(),
            untold: told.untold.iter().map(combination).collect(),
            outputs: all.iter().map(output).collect(),
            failed: found.failed.0 + lost.0,
            why_failed: found.failed.1.clone().or_else(|| lost.1.clone()),
        }
        .with_loss(*loss)
    }

    /// Whether residuals are as small as errors of the runs may be.
    pub fn is_exact(&self) -> bool {
        self.outputs.iter().all(|output| output.is_rounding)
    }

    fn with_loss(mut self, loss: Loss) -> Self {
        if self.end == "stuck" && self.is_exact() {
            self.end = "converged, as far as runs are exact,";
        }
        if let Loss::Huber(_) = loss {
            self.end = match self.end {
                "converged" => "converged, by Huber's loss",
                other => other,
            };
        }
        self
    }

    /// The answer for people.
    pub fn told(&self, scene: &Scene, files: &[PathBuf]) -> String {
        let files: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
        let gaps =
            if self.gaps > 0 { format!(", {} gaps left out", self.gaps) } else { String::new() };
        let mut text = format!(
            "{}: {} ({})\nfitted to {}: {} values{gaps}, {} s to {} s\n{} after {} steps, {} \
             evaluations\n\n",
            self.scene,
            self.title,
            scene.how(),
            files.join(", "),
            self.values,
            self.from,
            self.until,
            self.end,
            self.steps,
            self.runs,
        );
        text.push_str(&columns(&self.parameter_rows(), 2));
        text.push_str(&self.correlations_told());
        for Combination { shares, standard_error } in &self.untold {
            let shares: Vec<String> = shares
                .iter()
                .map(|(name, share)| format!("{name} {}{}", sign(*share), number(share.abs(), 2)))
                .collect();
            let error = match standard_error {
                Some(error) => format!("only to {} %", number(100.0 * error, 2)),
                None => "not at all".to_owned(),
            };
            text.extend([format!(
                "\nThe data tell {error} of this relative change: {}\n",
                shares.join(", ")
            )]);
        }
        text.push_str("\nResiduals\n");
        text.push_str(&columns(&self.residual_rows(), 2));
        for output in &self.outputs {
            if !output.is_rounding
                && output.probability_of_runs.is_some_and(|chance| chance < UNLIKELY)
            {
                text.extend([format!(
                    "Residuals of {} are not chance: the model lacks something, and intervals are \
                     narrower than they should be\n",
                    output.output
                )]);
            }
        }
        if let Some(why) = &self.why_failed {
            let count = self.failed;
            text.extend([format!("\n{count} variants could not be simulated; the first: {why}\n")]);
        }
        text
    }

    fn parameter_rows(&self) -> Vec<[String; 6]> {
        let header = ["", "unit", "start", "fitted", "95 % interval", "error"].map(str::to_owned);
        let row = |found: &FoundParameter| {
            let interval = match (found.confidence_95, found.is_at_bound) {
                (Some([low, high]), _) => format!("{} .. {}", number(low, 6), number(high, 6)),
                (None, true) => "at its bound".to_owned(),
                (None, false) => "not told".to_owned(),
            };
            let relative = found.standard_error.map_or_else(String::new, |error| {
                if found.value == 0.0 {
                    number(error, 2)
                } else {
                    format!("{} %", number(100.0 * error / found.value.abs(), 2))
                }
            });
            let (start, value) = (exact(found.start), number(found.value, 8));
            [found.name.clone(), found.unit.clone(), start, value, interval, relative]
        };
        std::iter::once(header).chain(self.parameters.iter().map(row)).collect()
    }

    fn correlations_told(&self) -> String {
        let mut told = Vec::new();
        for (i, row) in self.correlations.iter().enumerate() {
            for (j, value) in row.iter().enumerate().take(i) {
                if let Some(value) = value.filter(|value| value.abs() >= CORRELATED) {
                    let [a, b] = [&self.parameters[j].name, &self.parameters[i].name];
                    told.push(format!("{a} and {b} {}", number(value, 4)));
                }
            }
        }
        if told.is_empty() { String::new() } else { format!("\ncorrelated: {}\n", told.join(", ")) }
    }

    fn residual_rows(&self) -> Vec<[String; 8]> {
        let header = ["", "unit", "values", "rms", "largest", "lag 1", "runs", "expected"]
            .map(str::to_owned);
        let row = |output: &OutputResidual| {
            let optional = |value: Option<f64>, digits| {
                value.map_or_else(String::new, |value| number(value, digits))
            };
            [
                output.output.clone(),
                output.unit.clone(),
                output.values.to_string(),
                number(output.rms, 4),
                number(output.largest, 4),
                optional(output.autocorrelation, 2),
                output.runs.map_or_else(String::new, |runs| runs.to_string()),
                optional(output.expected_runs, 3),
            ]
        };
        std::iter::once(header).chain(self.outputs.iter().map(row)).collect()
    }
}

/// The largest size of what was measured.
fn largest_of(fit: &fit::Fit<'_>, name: &str) -> f64 {
    let all = fit.measured.iter().flat_map(|measured| &measured.columns);
    let own = all.filter(|(other, _)| other == name).flat_map(|(_, values)| values);
    own.filter(|value| !value.is_nan()).fold(0.0_f64, |most, value| most.max(value.abs()))
}

fn sign(share: f64) -> char {
    if share < 0.0 { '-' } else { '+' }
}

/// The value of an unknown beyond its bounds too, as intervals may reach there.
fn unknown_value(unknown: &fit::Unknown, inner: f64) -> f64 {
    let free = (f64::NEG_INFINITY, f64::INFINITY);
    if unknown.is_logarithmic() {
        inner.exp()
    } else {
        fit::Unknown { bounds: free, ..unknown.clone() }.outer(inner)
    }
}

/// The parameter, output or state of a name.
fn quantity<'s>(simulator: &'s dyn Simulator<f64>, name: &str) -> Option<Quantity<'s>> {
    let shape = simulator.shape();
    let parameters = (0..shape.parameters).map(|index| simulator.parameter(index));
    let outputs = (0..shape.outputs).map(|index| simulator.output(index));
    let states = (0..shape.states()).map(|index| simulator.state(index));
    parameters.chain(outputs).chain(states).find(|quantity| quantity.name == name)
}
