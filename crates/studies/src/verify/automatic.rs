//! Checks for any machine: equations against a second derivation, derivatives against differences,
//! powers against energies, the run against converged ones; and the checks of its author.
//!
//! A check that does not apply to a machine is also a row, with the reason.

mod derivatives;
mod energy;
mod independent;
mod own;
mod runs;
mod sensitivities;
mod visit;

use std::borrow::Cow;

use machinist::error::StopCause;
use machinist::{SimulateError, Simulation, Trajectory};
use machinist_contract::Simulator;

use super::Verdict;
pub use independent::{Difference, Independent, Look};
pub use own::{OfTimes, OwnCheck, OwnReference};
use visit::Visit;

/// A machine to be checked.
pub struct Subject<'a> {
    /// Its run, with the requested parameters, end and tolerance.
    pub simulation: Simulation<'a>,
    /// The same run in few elements, for the check of sensitivities, if fields have many: their
    /// derivatives take minutes there. Or the reason why there is no such run.
    pub in_few_elements: Option<Result<Simulation<'a>, String>>,
    /// The same machine in another execution, or the reason why there is none.
    pub twin: Result<&'a dyn Simulator<f64>, &'static str>,
    /// A second derivation of its spec, or the reason why there is none.
    pub independent: Independent<'a>,
    /// Checks of its author.
    pub own: Vec<OwnCheck<'a>>,
    /// Text that `scene: check` must contain, if given.
    pub only: Option<String>,
}

impl Subject<'_> {
    fn wants(&self, check: &str) -> bool {
        let scene = self.simulation.simulator().name();
        self.only.as_ref().is_none_or(|text| format!("{scene}: {check}").contains(text.as_str()))
    }
}

/// One row of the table.
struct Row {
    name: &'static str,
    reference: &'static str,
    tolerance: f64,
    /// Justification of the tolerance.
    reason: &'static str,
    /// Consequence if the row fails.
    matters: &'static str,
    measure: fn(&Visit<'_>) -> Outcome,
}

/// Result of a row.
enum Outcome {
    Found(Found),
    /// The row does not apply to this machine.
    Skipped(String),
    /// The row applies, but a run that it needs stopped, so that nothing is known.
    Undone(String),
    /// A run that the row needs exceeded its time limit.
    TooSlow(String),
}

/// An error with its place.
struct Found {
    error: f64,
    place: String,
}

impl Found {
    fn nothing() -> Self {
        Self { error: 0.0, place: String::new() }
    }

    /// Takes a larger error; NaN is the largest.
    fn take(&mut self, error: f64, place: impl FnOnce() -> String) {
        if !self.error.is_nan() && (error.is_nan() || error > self.error) {
            *self = Self { error, place: place() };
        }
    }
}

const ROWS: &[Row] = &[
    independent::INDEPENDENT,
    derivatives::BY_STATE,
    derivatives::BY_PARAMETERS,
    derivatives::BY_TIME,
    derivatives::BITS,
    energy::BALANCE,
    energy::ACCOUNT,
    energy::LOST,
    energy::EVENTS,
    energy::FORCES,
    runs::DRIFT_BEFORE,
    runs::DRIFT_AFTER,
    runs::AGREEMENT,
    runs::CONVERGENCE,
    sensitivities::BY_DIFFERENCES,
];

/// Computes the wanted rows of a machine: first whether it runs, then the automatic checks, then
/// those of its author. If it does not complete its run, nothing else is checked.
#[must_use]
pub fn verify_machine(subject: &Subject<'_>) -> Vec<Verdict> {
    let scene = subject.simulation.simulator().name();
    let run = match own::with_times(subject).run() {
        Ok(run) => run,
        Err(error) => return vec![runs_to_its_end(scene, Some(describe(&error)))],
    };
    let visit = Visit::new(subject, &run);
    let mut verdicts = vec![runs_to_its_end(scene, None)];
    verdicts.retain(|verdict| subject.wants(&verdict.check));
    let rows = ROWS.iter().filter(|row| subject.wants(row.name));
    verdicts.extend(rows.map(|row| row.verdict(scene, &visit)));
    let own = subject.own.iter().filter(|check| subject.wants(&check.title()));
    verdicts.extend(own.map(|check| check.verdict(subject, &run)));
    verdicts
}

fn runs_to_its_end(scene: &str, failure: Option<String>) -> Verdict {
    Verdict {
        check: "the run".into(),
        reference: "its end".into(),
        tolerance: 0.0,
        reason: "what stops early shows nothing of the rest".into(),
        ..Verdict::judged(scene, if failure.is_some() { f64::INFINITY } else { 0.0 }, 0.0, failure)
    }
}

impl Row {
    fn verdict(&self, scene: &str, visit: &Visit<'_>) -> Verdict {
        let judged = match (self.measure)(visit) {
            Outcome::Skipped(why) => Verdict::skipped(scene, why),
            Outcome::Undone(why) => Verdict::unchecked(scene, why),
            Outcome::TooSlow(why) => {
                Verdict::judged(scene, f64::INFINITY, self.tolerance, Some(why))
            }
            Outcome::Found(Found { error, place }) => {
                let failure = || format!("{} {place}", self.matters).trim_end().to_owned();
                // NaN must not pass.
                let passes = error <= self.tolerance;
                Verdict::judged(scene, error, self.tolerance, (!passes).then(failure))
            }
        };
        let words = |text: &'static str| Cow::Borrowed(text);
        Verdict {
            check: words(self.name),
            reference: words(self.reference),
            tolerance: self.tolerance,
            reason: words(self.reason),
            ..judged
        }
    }
}

impl Outcome {
    /// Returns the result of a row that needs a run which stopped.
    fn without_run(error: &SimulateError) -> Self {
        match error {
            _ if is_too_slow(error) => Self::TooSlow(describe(error)),
            SimulateError::Stopped { .. } => Self::Undone(describe(error)),
            _ => Self::Skipped(describe(error)),
        }
    }
}

fn is_too_slow(error: &SimulateError) -> bool {
    matches!(error, SimulateError::Stopped { cause: StopCause::TooSlow { .. }, .. })
}

/// Returns why a run stopped; for one that took too long, how far it came.
fn describe(error: &SimulateError) -> String {
    match error {
        SimulateError::Stopped {
            method,
            time,
            cause: StopCause::TooSlow { seconds },
            kept: Some(kept),
            ..
        } => format!(
            "`{method}` stopped after {seconds} s at t = {time} s, of {} steps: it creeps, or is \
             large; give more by `--time-limit`.",
            kept.work.steps
        ),
        error => error.to_string(),
    }
}

/// Returns the states of a trajectory, column by column.
fn states(run: &Trajectory) -> Vec<&[f64]> {
    let columns = run.of_kind(machinist::trajectory::ColumnKind::State);
    columns.map(|column| column.values.as_slice()).collect()
}
