//! Result of a fit, for people and for programs.

use machinist::fit::{
    Combination, End, Experiment, Findings, Fit, Fitted, FoundParameter, Loss, OutputResidual,
    Profile, students_t,
};
use machinist_contract::Simulator;
use serde::Serialize;
use serde_json::{Map, Value};

use super::experiments::Setup;
use crate::cli::amount::as_json;
use crate::cli::output::{columns, notes_told};
use crate::cli::scene::Scene;
use crate::number::{exact, number};

/// Size from which on correlations are reported.
const CORRELATED: f64 = 0.9;
/// Probability below which residuals count as not random.
const UNLIKELY: f64 = 0.01;

/// Complete result.
#[derive(Debug, Serialize)]
pub struct Answer {
    pub scene: String,
    pub title: String,
    /// Reason why the search ended.
    pub end: &'static str,
    pub steps: usize,
    pub runs: usize,
    /// Number of compared values, and of gaps in the data.
    pub values: usize,
    pub gaps: usize,
    pub from: f64,
    pub until: f64,
    pub experiments: Vec<ComparedExperiment>,
    pub parameters: Vec<FoundParameter>,
    /// Correlation of each pair of parameters; null if undetermined.
    pub correlations: Vec<Vec<Option<f64>>>,
    pub untold: Vec<Combination>,
    pub outputs: Vec<OutputResidual>,
    /// Number of variants that could not be simulated, and the reason of the first.
    pub failed: usize,
    pub why_failed: Option<String>,
    /// Notes of the runs with the parameters found.
    pub notes: Vec<String>,
    /// Profiles of the requested parameters.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub profiles: Vec<Profile>,
    /// Quantile of Student's t for 95 %.
    #[serde(skip)]
    pub t: f64,
}

/// Experiment as it was compared.
#[derive(Debug, Serialize)]
pub struct ComparedExperiment {
    pub name: String,
    pub data: String,
    /// Parameters and initial values of this experiment, in SI units.
    pub set: Map<String, Value>,
    pub from: f64,
    pub until: f64,
    pub values: usize,
    pub gaps: usize,
}

impl Answer {
    pub(super) fn new(
        fit: &Fit<'_>,
        fitted: &Fitted,
        (setups, gaps): (&[Setup], &[usize]),
        simulator: &dyn Simulator<f64>,
    ) -> Self {
        let Fitted { found, loss, lost, steps, runs, .. } = fitted;
        let Findings { values, parameters, correlations, untold, outputs, .. } =
            fit.findings(fitted);
        let experiments = experiments(fit, setups, gaps);
        let held = parameters.iter().filter(|found| found.is_at_bound).count();
        let notes = notes(fit, &parameters);
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
            values,
            gaps: gaps.iter().sum(),
            from: experiments.iter().map(|told| told.from).fold(f64::INFINITY, f64::min),
            until: experiments.iter().map(|told| told.until).fold(f64::NEG_INFINITY, f64::max),
            t: students_t(values.saturating_sub(parameters.len() - held)),
            experiments,
            parameters,
            correlations,
            untold,
            outputs,
            failed: found.failed.0 + lost.0,
            why_failed: found.failed.1.clone().or_else(|| lost.1.clone()),
            notes,
            profiles: Vec::new(),
        }
        .with_loss(*loss)
    }

    /// Returns whether residuals are within the errors of the runs.
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

    /// Formats the result for people.
    pub fn describe(&self, scene: &Scene) -> String {
        let gaps =
            if self.gaps > 0 { format!(", {} gaps left out", self.gaps) } else { String::new() };
        let is_plain = |told: &ComparedExperiment| told.set.is_empty() && told.name == told.data;
        let all_plain = self.experiments.iter().all(is_plain);
        let files: Vec<&str> = self.experiments.iter().map(|told| &*told.data).collect();
        let fitted_to = match files.len() {
            _ if all_plain => files.join(", "),
            1 => "1 experiment".to_owned(),
            count => format!("{count} experiments"),
        };
        let mut text = format!(
            "{}: {} ({})\nfitted to {fitted_to}: {} values{gaps}, {} s to {} s\n",
            self.scene,
            self.title,
            scene.how(),
            self.values,
            self.from,
            self.until,
        );
        if !all_plain {
            text.push_str(&self.experiments_told());
        }
        text.extend([format!(
            "{} after {} steps, {} evaluations{}\n\n",
            self.end,
            self.steps,
            self.runs,
            notes_told(&self.notes, "--json")
        )]);
        text.push_str(&columns(&self.parameter_rows(), 2));
        if self.t.is_nan() {
            text.push_str(
                "\nThere are as many unknowns as values, so no errors can be estimated\n",
            );
        }
        text.push_str(&self.correlations_told());
        for Combination { shares, standard_error, .. } in &self.untold {
            let shares: Vec<String> = shares
                .iter()
                .map(|(name, share)| format!("{name} {}{}", sign(*share), number(share.abs(), 2)))
                .collect();
            let error = match standard_error {
                Some(error) => format!("only to {} %", number(100.0 * error, 2)),
                None => "not at all".to_owned(),
            };
            text.extend([format!(
                "\nThe data determine this relative change {error}: {}\n",
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
                    "Residuals of {} are not random: the model is incomplete, and the intervals \
                     are too narrow\n",
                    output.output
                )]);
            }
        }
        text.push_str(&self.profiles_told());
        if let Some(why) = &self.why_failed {
            let count = self.failed;
            text.extend([format!("\n{count} variants could not be simulated; the first: {why}\n")]);
        }
        text
    }

    fn experiments_told(&self) -> String {
        let row = |told: &ComparedExperiment| {
            let set = told
                .set
                .iter()
                .filter_map(|(name, value)| Some(format!("{name}={}", exact(value.as_f64()?))));
            let set = set.collect::<Vec<_>>().join(", ");
            let data = if told.name == told.data { String::new() } else { told.data.clone() };
            let span = format!("{} values, {} s to {} s", told.values, told.from, told.until);
            [format!("  {}", told.name), data, span, set]
        };
        let rows: Vec<[String; 4]> = self.experiments.iter().map(row).collect();
        columns(&rows, 4)
    }

    /// Formats confidence intervals by profiles beside those by standard errors, with reasons for
    /// missing ones.
    fn profiles_told(&self) -> String {
        if self.profiles.is_empty() {
            return String::new();
        }
        let header = ["", "unit", "95 % by standard error", "by likelihood"].map(str::to_owned);
        let interval = |[low, high]: [Option<f64>; 2]| {
            let end = |end: Option<f64>| end.map_or_else(|| "?".to_owned(), |end| number(end, 6));
            format!("{} .. {}", end(low), end(high))
        };
        let row = |profile: &Profile| {
            let found = self.parameters.iter().find(|found| found.name == profile.parameter);
            let linear = found.and_then(|found| found.confidence_95);
            let linear = linear.map_or_else(String::new, |ends| interval(ends.map(Some)));
            let (name, unit) = (profile.parameter.clone(), profile.unit.clone());
            [name, unit, linear, interval(profile.confidence_95)]
        };
        let rows: Vec<[String; 4]> =
            std::iter::once(header).chain(self.profiles.iter().map(row)).collect();
        let mut text = format!("\nProfiles\n{}", columns(&rows, 2));
        for profile in &self.profiles {
            for (side, why) in ["lower", "upper"].iter().zip(&profile.open) {
                if let Some(why) = why {
                    text.extend([format!("No {side} limit of {}: {why}\n", profile.parameter)]);
                }
            }
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
            let name = match self.experiments.len() {
                1 => output.output.clone(),
                _ => format!("{}, {}", output.output, output.experiment),
            };
            [
                name,
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

fn experiments(fit: &Fit<'_>, setups: &[Setup], gaps: &[usize]) -> Vec<ComparedExperiment> {
    let told = |((experiment, setup), gaps): ((&Experiment, &Setup), &usize)| {
        let times = &experiment.measured.times;
        let columns = experiment.measured.columns.iter().flat_map(|(_, values)| values);
        ComparedExperiment {
            name: setup.name.clone(),
            data: setup.data.display().to_string(),
            set: as_json(&setup.set),
            from: times.first().copied().unwrap_or(f64::NAN),
            until: times.last().copied().unwrap_or(f64::NAN),
            values: columns.filter(|value| !value.is_nan()).count(),
            gaps: *gaps,
        }
    };
    fit.experiments.iter().zip(setups).zip(gaps).map(told).collect()
}

/// Returns the distinct notes of the runs with the parameters found.
fn notes(fit: &Fit<'_>, parameters: &[FoundParameter]) -> Vec<String> {
    let values: Vec<f64> = parameters.iter().map(|found| found.value).collect();
    let mut notes = Vec::new();
    for experiment in fit.experiments {
        let times = &experiment.measured.times;
        // The reason of a run that stopped is reported elsewhere.
        let run = fit.run(experiment, &values, times, false);
        for note in run.into_iter().flat_map(|run| run.notes) {
            if !notes.contains(&note) {
                notes.push(note);
            }
        }
    }
    notes
}

fn sign(share: f64) -> char {
    if share < 0.0 { '-' } else { '+' }
}
