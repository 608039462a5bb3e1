//! Checks that any machine can be asked to pass, without knowing what it is: the equations
//! against those of a second derivation, derivatives against differences, powers against
//! energies, the run against converged ones; and the checks of its author's own.
//!
//! What cannot be asked of a machine is a row too, which says why.

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
    /// Its run, with the parameters, the end and the tolerance that are wanted.
    pub simulation: Simulation<'a>,
    /// The same machine run in another way, or why there is none.
    pub twin: Result<&'a dyn Simulator<f64>, &'static str>,
    /// A second derivation of its spec, or why there is none.
    pub independent: Independent<'a>,
    /// What its author wants checked.
    pub own: Vec<OwnCheck<'a>>,
}

/// One row of the table.
struct Row {
    name: &'static str,
    reference: &'static str,
    tolerance: f64,
    /// Why the tolerance is what it is.
    reason: &'static str,
    /// What it means if the row fails.
    matters: &'static str,
    measure: fn(&Visit<'_>) -> Outcome,
}

/// What a row finds.
enum Outcome {
    Found(Found),
    /// The row cannot be asked of this machine.
    Skipped(String),
    /// It can be asked, and what it takes stopped, so that nothing is known.
    Undone(String),
    /// What it takes was not done in time.
    TooSlow(String),
}

/// An error, and where it is largest.
struct Found {
    error: f64,
    place: String,
}

impl Found {
    fn nothing() -> Self {
        Self { error: 0.0, place: String::new() }
    }

    /// Takes a larger error; one that is no number is the largest.
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

/// Every row of a machine: first whether it runs, then the automatic checks, then those of
/// its author. If it does not run to its end, there is nothing else to check.
#[must_use]
pub fn verify_machine(subject: &Subject<'_>) -> Vec<Verdict> {
    let scene = subject.simulation.simulator().name();
    let run = match own::with_times(subject).run() {
        Ok(run) => run,
        Err(error) => return vec![runs_to_its_end(scene, Some(told(&error)))],
    };
    let visit = Visit::new(subject, &run);
    let mut verdicts = vec![runs_to_its_end(scene, None)];
    verdicts.extend(ROWS.iter().map(|row| row.verdict(scene, &visit)));
    verdicts.extend(subject.own.iter().map(|check| check.verdict(subject, &run)));
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
                // An error that is NaN must not pass.
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
    /// Of a row that takes a run which stopped.
    fn without_run(error: &SimulateError) -> Self {
        match error {
            _ if is_too_slow(error) => Self::TooSlow(told(error)),
            SimulateError::Stopped { .. } => Self::Undone(told(error)),
            _ => Self::Skipped(told(error)),
        }
    }
}

fn is_too_slow(error: &SimulateError) -> bool {
    matches!(error, SimulateError::Stopped { cause: StopCause::TooSlow { .. }, .. })
}

/// Why a run stopped; of one that took too long, how far it came.
fn told(error: &SimulateError) -> String {
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

/// States of a trajectory, column by column.
fn states(run: &Trajectory) -> Vec<&[f64]> {
    let columns = run.of_kind(machinist::trajectory::ColumnKind::State);
    columns.map(|column| column.values.as_slice()).collect()
}
