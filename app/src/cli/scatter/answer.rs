//! Results of a scatter as JSON and as text.

use machinist::scatter::{Estimate, Groups, SobolIndices, Summary, Tally};
use serde::Serialize;

use super::analyses::{Linearized, Screened};
use super::inputs::Inputs;
use super::runs::{Plan, Ran};
use super::{Results, ScatterCommand};
use crate::cli::improve::units;
use crate::cli::output::columns;
use crate::cli::scene::Scene;
use crate::failure::Failure;
use crate::number::number;

/// Number of runs without results that are listed.
const LISTED: usize = 5;

/// Estimate with its confidence interval; an end that is `null` is not bounded by the samples.
#[derive(Debug, Clone, Copy, Serialize)]
struct IntervalEstimate {
    value: f64,
    low: Option<f64>,
    high: Option<f64>,
}

impl From<Estimate> for IntervalEstimate {
    fn from(of: Estimate) -> Self {
        let bounded = |end: f64| end.is_finite().then_some(end);
        Self { value: of.value, low: bounded(of.low), high: bounded(of.high) }
    }
}

impl IntervalEstimate {
    fn row(&self, name: String, digits: usize) -> [String; 4] {
        let shown =
            |end: Option<f64>| end.map_or_else(|| "?".to_owned(), |end| number(end, digits));
        [name, number(self.value, digits), shown(self.low), shown(self.high)]
    }
}

#[derive(Debug, Serialize)]
struct Parameter {
    name: String,
    distribution: &'static str,
    mean: f64,
    deviation: f64,
    unit: String,
}

#[derive(Debug, Serialize)]
struct Quantile {
    probability: f64,
    #[serde(flatten)]
    estimate: IntervalEstimate,
}

#[derive(Debug, Serialize)]
struct IndexOf {
    parameter: String,
    first: IntervalEstimate,
    total: IntervalEstimate,
}

#[derive(Debug, Serialize)]
struct ResultOf {
    of: String,
    unit: String,
    count: usize,
    mean: IntervalEstimate,
    deviation: IntervalEstimate,
    least: f64,
    greatest: f64,
    quantiles: Vec<Quantile>,
    #[serde(skip_serializing_if = "Option::is_none")]
    indices: Option<Vec<IndexOf>>,
    /// Reason why there are no indices although they were requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    without_indices: Option<String>,
}

#[derive(Debug, Serialize)]
struct LimitOf {
    limit: String,
    /// Number of runs that miss it.
    failures: usize,
    count: usize,
    probability: IntervalEstimate,
}

#[derive(Debug, Serialize)]
struct StoppedRun {
    run: usize,
    why: String,
}

/// Answer of the command.
#[derive(Debug, Serialize)]
pub struct Answer {
    scene: String,
    #[serde(skip)]
    head: String,
    sampler: String,
    seed: u64,
    confidence: f64,
    runs: usize,
    parameters: Vec<Parameter>,
    correlated: bool,
    left_out: Vec<String>,
    results: Vec<ResultOf>,
    limits: Vec<LimitOf>,
    stopped: usize,
    /// The first runs without results.
    stopped_runs: Vec<StoppedRun>,
    interrupted: bool,
    notes: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub screening: Vec<Screened>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub linear: Vec<Linearized>,
}

impl Answer {
    pub fn new(
        command: &ScatterCommand,
        scene: &Scene,
        inputs: &Inputs,
        results: &Results,
        plan: &Plan,
        ran: &Ran,
    ) -> Result<Self, Failure> {
        let simulator = scene.simulator();
        let groups = plan.groups();
        let no_statistics = |error: machinist::scatter::ScatterError| {
            Failure::unsuccessful(format!("no statistics: {error}"), "more --samples may help")
        };
        let mut told = Vec::new();
        for (index, (of, expression)) in results.of.iter().enumerate() {
            let all = ran.values(index);
            let summary = Summary::of(&plan.samples(&all), &groups, command.confidence);
            let summary = summary.map_err(no_statistics)?;
            let quantile =
                |p: &f64| Quantile { probability: *p, estimate: summary.quantile(*p).into() };
            let (indices, without_indices) = match plan.row_length() {
                None => (None, None),
                Some(length) => match indices(&all, length, &groups, command, inputs) {
                    Ok(indices) => (Some(indices), None),
                    Err(why) => (None, Some(why)),
                },
            };
            told.push(ResultOf {
                of: of.clone(),
                unit: units::of(expression, simulator),
                count: summary.count,
                mean: summary.mean.into(),
                deviation: summary.deviation.into(),
                least: summary.least,
                greatest: summary.greatest,
                quantiles: command.quantiles.iter().map(quantile).collect(),
                indices,
                without_indices,
            });
        }
        let mut limits = Vec::new();
        for (index, (text, limit)) in results.limits.iter().enumerate() {
            let left = ran.values(results.of.len() + 2 * index);
            let right = ran.values(results.of.len() + 2 * index + 1);
            let missed: Vec<Option<bool>> = left
                .iter()
                .zip(&right)
                .map(|(left, right)| {
                    let holds = if limit.is_at_most { left <= right } else { left >= right };
                    left.is_finite().then_some(!holds)
                })
                .collect();
            let tally = Tally::of(&plan.samples(&missed), &groups, command.confidence);
            let tally = tally.map_err(no_statistics)?;
            limits.push(LimitOf {
                limit: text.clone(),
                failures: tally.hits,
                count: tally.count,
                probability: tally.probability.into(),
            });
        }
        let stopped = ran.stopped().take(LISTED);
        let parameter = |index: usize| Parameter {
            name: inputs.names[index].clone(),
            distribution: inputs.distributions[index].name(),
            mean: inputs.distributions[index].mean(),
            deviation: inputs.distributions[index].deviation(),
            unit: inputs.units[index].clone(),
        };
        Ok(Self {
            scene: simulator.name().to_owned(),
            head: format!("{}: {} ({})", simulator.name(), simulator.title(), scene.how()),
            sampler: command.sampler.clone(),
            seed: command.seed,
            confidence: command.confidence,
            runs: ran.count(),
            parameters: (0..inputs.names.len()).map(parameter).collect(),
            correlated: !inputs.correlation.is_none(),
            left_out: inputs.left_out.clone(),
            results: told,
            limits,
            stopped: ran.stopped().count(),
            stopped_runs: stopped
                .map(|(run, why)| StoppedRun { run, why: why.to_owned() })
                .collect(),
            interrupted: ran.is_interrupted,
            notes: ran.note_on_bands().into_iter().collect(),
            screening: Vec::new(),
            linear: Vec::new(),
        })
    }

    /// Returns the answer for people.
    pub fn describe(&self) -> String {
        let points = match self.sampler.as_str() {
            "sobol" => "Sobol points",
            "latin" => "Latin hypercubes",
            _ => "random points",
        };
        let mut text =
            format!("{}\n{} runs, {points}, seed {}\n\n", self.head, self.runs, self.seed);
        text.push_str(&self.parameters_told());
        let interval = format!("{} % interval", number(100.0 * self.confidence, 4));
        for result in &self.results {
            text.extend([format!("\n{} [{}], {} values\n", result.of, result.unit, result.count)]);
            text.push_str(&result.describe(&interval));
        }
        if !self.limits.is_empty() {
            let header =
                ["requirement", "failures", "probability", &interval, ""].map(str::to_owned);
            let row = |limit: &LimitOf| {
                let [_, value, low, high] = limit.probability.row(String::new(), 4);
                let failures = format!("{} of {}", limit.failures, limit.count);
                [limit.limit.clone(), failures, value, low, high]
            };
            let rows = std::iter::once(header).chain(self.limits.iter().map(row));
            text.push('\n');
            text.push_str(&columns(&rows.collect::<Vec<_>>(), 1));
        }
        self.screening.iter().for_each(|screened| text.push_str(&screened_told(screened)));
        self.linear.iter().for_each(|linear| text.push_str(&linear_told(linear)));
        if self.stopped > 0 {
            text.extend([format!("\n{} runs have no result:\n", self.stopped)]);
            for StoppedRun { run, why } in &self.stopped_runs {
                text.extend([format!("  run {run}: {why}\n")]);
            }
            if self.stopped > LISTED {
                text.extend([format!("  and {} more\n", self.stopped - LISTED)]);
            }
        }
        for note in &self.notes {
            text.extend([format!("\n{note}\n")]);
        }
        if !self.left_out.is_empty() {
            let names = self.left_out.join(", ");
            text.extend([format!(
                "\nnot varied, because no output depends on them or they are not tunable: {names}\n"
            )]);
        }
        text
    }

    fn parameters_told(&self) -> String {
        let header = ["parameter", "distribution", "mean", "deviation", "unit"].map(str::to_owned);
        let row = |parameter: &Parameter| {
            let [mean, deviation] =
                [parameter.mean, parameter.deviation].map(|value| number(value, 6));
            [
                parameter.name.clone(),
                parameter.distribution.to_owned(),
                mean,
                deviation,
                parameter.unit.clone(),
            ]
        };
        let rows = std::iter::once(header).chain(self.parameters.iter().map(row));
        let mut text = columns(&rows.collect::<Vec<_>>(), 2);
        if self.correlated {
            text.push_str("parameters are correlated as the scene says\n");
        }
        text
    }
}

impl ResultOf {
    /// Returns the number of digits that show the interval of the mean with two of its own.
    fn digits(&self) -> usize {
        const LEAST: usize = 6;
        const MOST: usize = 15;
        let size = self.least.abs().max(self.greatest.abs());
        let half = self.mean.high.map_or(0.0, |high| high - self.mean.value);
        let digits = (size / half).log10() + 2.0;
        if digits.is_finite() {
            (digits.ceil().max(0.0) as usize).clamp(LEAST, MOST)
        } else {
            LEAST
        }
    }

    fn describe(&self, interval: &str) -> String {
        let header = ["", "estimate", interval, ""].map(str::to_owned);
        let digits = self.digits();
        let exact = |name: &str, value: f64| {
            [name.to_owned(), number(value, digits), String::new(), String::new()]
        };
        let quantile = |of: &Quantile| {
            of.estimate.row(format!("{} % quantile", number(100.0 * of.probability, 4)), digits)
        };
        let rows = [
            header,
            self.mean.row("mean".to_owned(), digits),
            self.deviation.row("deviation".to_owned(), 5),
            exact("least", self.least),
        ]
        .into_iter()
        .chain(self.quantiles.iter().map(quantile))
        .chain([exact("greatest", self.greatest)]);
        let mut text = columns(&rows.collect::<Vec<_>>(), 1);
        if let Some(indices) = &self.indices {
            let header =
                ["Sobol index", "first", interval, "", "total", interval, ""].map(str::to_owned);
            let row = |index: &IndexOf| {
                let [name, first, low, high] = index.first.row(index.parameter.clone(), 3);
                let [_, total, total_low, total_high] = index.total.row(String::new(), 3);
                [name, first, low, high, total, total_low, total_high]
            };
            let rows = std::iter::once(header).chain(indices.iter().map(row));
            text.push('\n');
            text.push_str(&columns(&rows.collect::<Vec<_>>(), 1));
        }
        if let Some(why) = &self.without_indices {
            text.extend([format!("no indices: {why}\n")]);
        }
        text
    }
}

fn indices(
    values: &[f64],
    length: usize,
    groups: &Groups,
    command: &ScatterCommand,
    inputs: &Inputs,
) -> Result<Vec<IndexOf>, String> {
    let rows: Vec<Vec<f64>> = values.chunks_exact(length).map(<[f64]>::to_vec).collect();
    let found = SobolIndices::of(&rows, groups, command.confidence);
    let found = found.map_err(|error| error.to_string())?;
    let named = inputs.names.iter().zip(&found.indices).map(|(name, index)| IndexOf {
        parameter: name.clone(),
        first: index.first.into(),
        total: index.total.into(),
    });
    Ok(named.collect())
}

fn screened_told(screened: &Screened) -> String {
    let header = ["parameter", "mu*", "+-", "mu", "sigma"].map(str::to_owned);
    let mut effects: Vec<_> = screened.effects.iter().collect();
    effects.sort_by(|a, b| b.mean_absolute.total_cmp(&a.mean_absolute));
    let row = |effect: &super::analyses::ScreenedParameter| {
        let [absolute, error, mean, deviation] =
            [effect.mean_absolute, effect.error, effect.mean, effect.deviation]
                .map(|value| number(value, 4));
        [effect.parameter.clone(), absolute, error, mean, deviation]
    };
    let rows = std::iter::once(header).chain(effects.into_iter().map(row));
    let table = columns(&rows.collect::<Vec<_>>(), 1);
    format!("\nElementary effects on {}, per unit of probability\n{table}", screened.of)
}

fn linear_told(linear: &Linearized) -> String {
    let header = ["parameter", "derivative", "for one deviation", "share"].map(str::to_owned);
    let rows = linear.shares.iter().map(|share| {
        let [slope, contribution] = [share.slope, share.contribution].map(|value| number(value, 6));
        let part = format!("{} %", number(100.0 * share.share, 3));
        [share.parameter.clone(), slope, contribution, part]
    });
    let rows = std::iter::once(header).chain(rows);
    let table = columns(&rows.collect::<Vec<_>>(), 1);
    let mut text = format!(
        "\n{} by linear propagation: {} +- {}\n{table}",
        linear.of,
        number(linear.value, 6),
        number(linear.deviation, 6)
    );
    if !linear.left_out.is_empty() {
        text.extend(["without derivative: ", &linear.left_out.join("; "), "\n"]);
    }
    text
}
