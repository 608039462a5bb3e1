//! A complete fit: searches from several starts, with scales that follow the residuals.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

use super::{End, Evaluation, Fit, Found, Loss, spread_starts};

/// Maximum number of updates of the scales.
const REWEIGHTINGS: usize = 4;
/// Relative change below which scales have settled.
const SETTLED: f64 = 1e-2;
/// Size of Huber's loss in standard deviations: 95 % as efficient as squares without outliers.
const HUBER: f64 = 1.345;
/// Ratio of standard deviation and median absolute value of a normal distribution.
const OF_MEDIAN: f64 = 1.4826;

/// Settings of a fit.
#[derive(Debug, Clone, Copy)]
pub struct Plan<'a> {
    /// True to reduce the weight of outliers by Huber's loss.
    pub is_robust: bool,
    /// Number of starts, at least one.
    pub starts: usize,
    /// Maximum number of steps of each search.
    pub steps: usize,
    /// Flag that ends the fit at its current point.
    pub interrupt: Option<&'a AtomicBool>,
}

impl Default for Plan<'_> {
    /// One start and at most 100 steps by least squares.
    fn default() -> Self {
        Self { is_robust: false, starts: 1, steps: 100, interrupt: None }
    }
}

impl Plan<'_> {
    /// Returns whether the fit is interrupted.
    pub(super) fn is_flagged(&self) -> bool {
        self.interrupt.is_some_and(|flag| flag.load(Ordering::Relaxed))
    }
}

/// Reason why nothing was found.
#[derive(
    Debug, Clone, PartialEq, Eq, thiserror::Error, strum::IntoStaticStr, strum::VariantNames,
)]
#[strum(prefix = "fit::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Unsolved {
    /// The fit was interrupted before anything was found.
    #[error("the fit was interrupted at its start")]
    Interrupted,
    /// No start can be simulated.
    #[error("no start can be simulated: {why}")]
    NoStart {
        /// Reason for the first start.
        why: String,
    },
}

impl Unsolved {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.into()
    }
}

/// Result of a fit.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Fitted {
    /// End of the search.
    pub found: Found,
    /// Loss of the last search.
    pub loss: Loss,
    /// Scales of the outputs.
    pub scales: Vec<(String, f64)>,
    /// Number of starts that failed, and the reason for the first.
    pub lost: (usize, Option<String>),
    /// Number of steps of all searches.
    pub steps: usize,
    /// Number of evaluations.
    pub runs: usize,
}

impl Fit<'_> {
    /// Makes the complete fit: searches from all starts, then again with scales that follow the
    /// residuals, or with Huber's loss. `watch` receives every evaluation and the number of
    /// evaluations so far.
    ///
    /// # Errors
    /// [`Unsolved`] if nothing was found at all.
    pub fn solve(
        &self,
        plan: &Plan<'_>,
        watch: &mut (dyn FnMut(usize, &Evaluation) + Send),
    ) -> Result<Fitted, Unsolved> {
        let counter = Counter::new(watch);
        let mut fitted = self.best_of_starts(plan, &counter)?;
        let weighs =
            self.outputs().iter().any(|name| !self.is_known(name)) && self.outputs().len() > 1;
        if weighs || plan.is_robust {
            self.reweigh(&mut fitted, plan, weighs, &counter);
        }
        if plan.is_flagged() {
            fitted.found.end = End::Interrupted;
        }
        Ok(Fitted { runs: counter.count(), ..fitted })
    }

    /// Returns the best result of searches from all starts, with the initial scales.
    fn best_of_starts(&self, plan: &Plan<'_>, counter: &Counter<'_>) -> Result<Fitted, Unsolved> {
        let scales = self.first_scales();
        let starts = spread_starts(&self.start(), &self.bounds(), plan.starts);
        let searched = self.each(starts.len(), |fit, number| {
            let scale_of = |name: &str| scale_of(&scales, name);
            let how = (Loss::Squares, plan.steps);
            fit.search(&starts[number], &scale_of, how, plan.interrupt, &|now| counter.tell(now))
        });
        let (mut best, mut lost) = (None::<Found>, (0, None));
        for found in searched {
            match found {
                Ok(found) if best.as_ref().is_none_or(|best| found.cost < best.cost) => {
                    best = Some(found);
                }
                Ok(_) => {}
                Err(_) if plan.is_flagged() => {}
                Err(why) => {
                    lost.0 += 1;
                    lost.1.get_or_insert(why);
                }
            }
        }
        match best {
            Some(found) => {
                let steps = found.steps;
                Ok(Fitted { found, loss: Loss::Squares, scales, lost, steps, runs: 0 })
            }
            None if plan.is_flagged() => Err(Unsolved::Interrupted),
            None => Err(Unsolved::NoStart { why: lost.1.unwrap_or_default() }),
        }
    }

    /// Searches again, with scales from the residuals, or with a loss from their median.
    fn reweigh(&self, fitted: &mut Fitted, plan: &Plan<'_>, weighs: bool, counter: &Counter<'_>) {
        let is_same = |(a, b): (&(String, f64), &(String, f64))| (a.1 - b.1).abs() <= SETTLED * a.1;
        for _ in 0..REWEIGHTINGS {
            if plan.is_flagged() {
                return;
            }
            let mut scales = fitted.scales.clone();
            if weighs {
                scales = self.renewed(&fitted.found.evaluation, &scales, plan.is_robust);
            }
            if !plan.is_robust && fitted.scales.iter().zip(&scales).all(is_same) {
                return;
            }
            let scale_of = |name: &str| scale_of(&scales, name);
            if plan.is_robust
                && let Ok(now) = self.evaluate(&fitted.found.at, &scale_of)
            {
                let sizes: Vec<f64> = now.residuals.iter().map(|r| r.abs()).collect();
                let size = HUBER * OF_MEDIAN * median(sizes).max(f64::MIN_POSITIVE);
                fitted.loss = Loss::Huber(size);
            }
            let how = (fitted.loss, plan.steps);
            let tell = |now: &Evaluation| counter.tell(now);
            match self.search(&fitted.found.at, &scale_of, how, plan.interrupt, &tell) {
                Ok(better) => {
                    fitted.steps += better.steps;
                    (fitted.found, fitted.scales) = (better, scales);
                }
                Err(why) => {
                    if !plan.is_flagged() {
                        fitted.lost.1.get_or_insert(why);
                    }
                    return;
                }
            }
        }
    }

    /// Returns whether the noise of an output is known.
    fn is_known(&self, output: &str) -> bool {
        self.experiments.iter().any(|experiment| experiment.noise_of(output).is_some())
    }

    /// Returns the initial scales: 1 where noise is known, otherwise the standard deviation of the
    /// measured values about their mean.
    fn first_scales(&self) -> Vec<(String, f64)> {
        let of = |name: &&str| {
            let own = self.columns().filter(|(_, other, _)| other == name);
            let own = own.flat_map(|(_, _, values)| values).copied();
            let own: Vec<f64> = own.filter(|value| !value.is_nan()).collect();
            ((*name).to_owned(), if self.is_known(name) { 1.0 } else { spread(&own) })
        };
        self.outputs().iter().map(of).collect()
    }

    /// Returns scales of outputs from their residuals, so that precise measurements weigh more.
    /// Scales stay above a millionth of their initial values.
    fn renewed(
        &self,
        evaluation: &Evaluation,
        scales: &[(String, f64)],
        is_robust: bool,
    ) -> Vec<(String, f64)> {
        const LEAST: f64 = 1e-6;
        let residuals = self.residuals_by_column(evaluation, scales);
        let renew = |(name, scale): &(String, f64)| {
            if self.is_known(name) {
                return (name.clone(), *scale);
            }
            let own = residuals.iter().filter(|column| column.output == name);
            let own: Vec<f64> = own.flat_map(|column| column.residuals).copied().collect();
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
}

/// Counts evaluations of all threads, and reports them one after another.
pub(super) struct Counter<'w>(Mutex<(usize, Watch<'w>)>);

/// Callback that receives every evaluation and the number so far.
type Watch<'w> = &'w mut (dyn FnMut(usize, &Evaluation) + Send);

impl<'w> Counter<'w> {
    pub(super) fn new(watch: Watch<'w>) -> Self {
        Self(Mutex::new((0, watch)))
    }

    pub(super) fn tell(&self, evaluation: &Evaluation) {
        let mut told = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let (count, watch) = &mut *told;
        *count += 1;
        watch(*count, evaluation);
    }

    pub(super) fn count(&self) -> usize {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).0
    }
}

/// Returns the scale of an output, or 1 if it has none.
#[must_use]
pub fn scale_of(scales: &[(String, f64)], name: &str) -> f64 {
    scales.iter().find(|(other, _)| other == name).map_or(1.0, |(_, scale)| *scale)
}

/// Returns the standard deviation about the mean; the size of constant values, and 1 for zeros.
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
