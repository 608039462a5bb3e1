//! A fit from start to end: searches from several starts, and scales that follow residuals.

use std::sync::atomic::{AtomicBool, Ordering};

use super::{End, Evaluation, Fit, Found, Loss, Measured, Unknown, spread_starts};
use crate::simulate::Simulation;

/// How often the scales of outputs follow the residuals.
const REWEIGHTINGS: usize = 4;
/// Scales that change by no more than this share have settled.
const SETTLED: f64 = 1e-2;
/// Huber's size in standard deviations: 95 % as efficient as squares where nothing is wild.
const HUBER: f64 = 1.345;
/// A standard deviation for a median of sizes, of the normal distribution.
const OF_MEDIAN: f64 = 1.4826;

/// How a fit is made.
#[derive(Debug, Clone, Copy)]
pub struct Plan<'a> {
    /// Standard deviations of outputs' measurements that are known, in their units; what is not
    /// known follows from residuals.
    pub sigma: &'a [(String, f64)],
    /// Whether outliers count less, by Huber's loss.
    pub is_robust: bool,
    /// Searches from so many starts, at least one.
    pub starts: usize,
    /// Steps of each at most.
    pub steps: usize,
    /// Ends the fit where it is, once set.
    pub interrupt: Option<&'a AtomicBool>,
}

/// Why nothing was found.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Unsolved {
    /// Somebody asked, before anything was found.
    #[error("the fit was interrupted at its start")]
    Interrupted,
    /// No run gets through.
    #[error("no start can be simulated: {why}")]
    NoStart {
        /// Why the first does not.
        why: String,
    },
}

/// A search that has ended, with what it went by.
#[derive(Debug, Clone)]
pub struct Fitted {
    /// Where it ended.
    pub found: Found,
    /// How residuals counted at last.
    pub loss: Loss,
    /// Scale of each output.
    pub scales: Vec<(String, f64)>,
    /// Starts that led nowhere, and why the first did not.
    pub lost: (usize, Option<String>),
    /// Steps of all searches.
    pub steps: usize,
    /// Evaluations.
    pub runs: usize,
}

impl Fit<'_> {
    /// The whole fit: searches from all starts, then again with scales that follow the
    /// residuals, or with Huber's loss. `watch` is told of every evaluation and how many there
    /// have been.
    ///
    /// # Errors
    /// [`Unsolved`] if nothing was found at all.
    pub fn solve(
        &self,
        plan: &Plan<'_>,
        watch: &mut dyn FnMut(usize, &Evaluation),
    ) -> Result<Fitted, Unsolved> {
        let is_flagged = || plan.interrupt.is_some_and(|flag| flag.load(Ordering::Relaxed));
        let mut scales = self.first_scales(plan.sigma);
        let mut runs = 0;
        let mut search = |start: &[f64], scales: &[(String, f64)], loss: Loss| {
            let scale_of = |name: &str| scale_of(scales, name);
            let (first, told) = (runs, std::cell::Cell::new(runs));
            let found =
                self.search(start, &scale_of, (loss, plan.steps), plan.interrupt, |evaluation| {
                    told.set(told.get() + 1);
                    watch(told.get(), evaluation);
                });
            runs = told.get().max(first);
            found
        };
        let mut best: Option<Found> = None;
        let mut lost = (0, None);
        for start in spread_starts(&self.start(), &self.bounds(), plan.starts) {
            match search(&start, &scales, Loss::Squares) {
                Ok(found) => {
                    let is_interrupted = found.end == End::Interrupted;
                    if best.as_ref().is_none_or(|best| found.cost < best.cost) {
                        best = Some(found);
                    }
                    if is_interrupted {
                        break;
                    }
                }
                Err(_) if is_flagged() => {}
                Err(why) => {
                    lost.0 += 1;
                    lost.1.get_or_insert(why);
                }
            }
            if is_flagged() {
                break;
            }
        }
        let Some(mut found) = best else {
            if is_flagged() {
                return Err(Unsolved::Interrupted);
            }
            return Err(Unsolved::NoStart { why: lost.1.unwrap_or_default() });
        };
        let mut loss = Loss::Squares;
        let weighs = plan.sigma.is_empty() && self.outputs().len() > 1;
        let is_robust = plan.is_robust;
        let rounds = if weighs || is_robust { REWEIGHTINGS } else { 0 };
        let mut steps = found.steps;
        for _ in 0..rounds {
            if is_flagged() {
                break;
            }
            let before = scales.clone();
            if weighs {
                scales = renewed(self, &found.evaluation, &scales, is_robust);
            }
            let is_same =
                |(a, b): (&(String, f64), &(String, f64))| (a.1 - b.1).abs() <= SETTLED * a.1;
            if !is_robust && before.iter().zip(&scales).all(is_same) {
                break;
            }
            if is_robust {
                let scale_of = |name: &str| scale_of(&scales, name);
                if let Ok(now) = self.evaluate(&found.at, &scale_of) {
                    let sizes: Vec<f64> = now.residuals.iter().map(|r| r.abs()).collect();
                    loss = Loss::Huber(HUBER * OF_MEDIAN * median(sizes).max(f64::MIN_POSITIVE));
                }
            }
            match search(&found.at.clone(), &scales, loss) {
                Ok(better) => {
                    steps += better.steps;
                    found = better;
                }
                Err(why) => {
                    scales = before;
                    if !is_flagged() {
                        lost.1.get_or_insert(why);
                    }
                    break;
                }
            }
        }
        if is_flagged() {
            found.end = End::Interrupted;
        }
        Ok(Fitted { found, loss, scales, lost, steps, runs })
    }

    /// What residuals are measured by at first: the standard deviation given, else that of what
    /// was measured about its mean.
    fn first_scales(&self, sigma: &[(String, f64)]) -> Vec<(String, f64)> {
        let of = |name: &&str| {
            let given = sigma.iter().find(|(other, _)| other == name);
            let all = self.measured.iter().flat_map(|measured| &measured.columns);
            let own = all.filter(|(other, _)| other == name).flat_map(|(_, values)| values);
            let own: Vec<f64> = own.copied().filter(|value| !value.is_nan()).collect();
            let scale = given.map_or_else(|| spread(&own), |(_, sigma)| *sigma);
            ((*name).to_owned(), scale)
        };
        self.outputs().iter().map(of).collect()
    }
}

/// Steps that a variant may take before it is given up: many times those of the start.
#[must_use]
pub fn steps_of(simulation: &Simulation<'_>, unknowns: &[Unknown], measured: &[Measured]) -> usize {
    const TIMES: u64 = 50;
    const LEAST: u64 = 20_000;
    const UNKNOWN: u64 = 200_000;
    let first = simulation.clone().max_steps(UNKNOWN as usize);
    let fit = Fit { simulation: &first, unknowns, measured };
    let starts: Vec<f64> = unknowns.iter().map(|unknown| unknown.start).collect();
    let runs = measured.iter().map(|measured| fit.run(measured, &starts, false));
    let most = runs.map(|run| run.map_or(UNKNOWN / TIMES, |run| run.work.steps)).max();
    (TIMES * most.unwrap_or_default()).max(LEAST) as usize
}

/// The scale of an output; 1 of what has none.
#[must_use]
pub fn scale_of(scales: &[(String, f64)], name: &str) -> f64 {
    scales.iter().find(|(other, _)| other == name).map_or(1.0, |(_, scale)| *scale)
}

/// Standard deviation about the mean; the size of what does not vary, and 1 of zeros.
fn spread(values: &[f64]) -> f64 {
    let n = values.len().max(1) as f64;
    let mean = values.iter().sum::<f64>() / n;
    let square = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / n;
    let size = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    match square.sqrt() {
        spread if spread > 1e-9 * size => spread,
        _ if size > 0.0 => size,
        _ => 1.0,
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Scales of outputs by their residuals, so that what is measured well counts for more; not
/// below a millionth of what they were at first.
fn renewed(
    fit: &Fit<'_>,
    evaluation: &Evaluation,
    scales: &[(String, f64)],
    is_robust: bool,
) -> Vec<(String, f64)> {
    const LEAST: f64 = 1e-6;
    let residuals = fit.residuals_by_column(evaluation);
    let renew = |(name, scale): &(String, f64)| {
        let own = residuals.iter().filter(|(other, _)| other == name);
        let own: Vec<f64> = own.flat_map(|(_, residuals)| *residuals).copied().collect();
        let mean = own.iter().map(|r| r * r).sum::<f64>() / own.len().max(1) as f64;
        let usual = if is_robust {
            OF_MEDIAN * median(own.iter().map(|r| r.abs()).collect())
        } else {
            mean.sqrt()
        };
        (name.clone(), scale * if usual.is_finite() { usual.max(LEAST) } else { 1.0 })
    };
    scales.iter().map(renew).collect()
}
