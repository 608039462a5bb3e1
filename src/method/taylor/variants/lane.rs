//! A variant, and what it is at in its lane.

use std::time::Duration;

use crate::error::StopCause;
use crate::method::milestone::{Milestone, out_of_steps};
use crate::method::patience::Patience;
use crate::method::{Stopped, Work};

/// A variant of a machine, to be run.
pub(crate) struct Variant {
    pub(crate) parameters: Vec<f64>,
    pub(crate) initial: Vec<f64>,
    /// Start, jumps in order, end \[s\].
    pub(crate) ends: Vec<f64>,
    /// Times at which the state is wanted, sorted \[s\].
    pub(crate) times: Vec<f64>,
    pub(crate) atol: Vec<f64>,
    pub(crate) max_steps: usize,
    /// It has computed for so long before.
    pub(crate) time_spent: Duration,
    /// So many steps are few; infinite where many are no harm.
    pub(crate) few: f64,
}

/// What came of a variant.
pub(crate) enum Ended {
    /// It is through.
    Through(Outcome),
    /// It cannot go on.
    Stopped(Stopped),
    /// It was left, as its loose steps are too many.
    Over(Spent),
}

/// What a variant has taken in vain.
#[derive(Clone, Copy, Default)]
pub(crate) struct Spent {
    pub(crate) steps: u64,
    pub(crate) time: Duration,
}

/// States at the wanted times, one row after another.
pub(crate) struct Outcome {
    pub(crate) rows: Vec<f64>,
    pub(crate) work: Work,
}

/// A variant on its way.
pub(super) struct Lane {
    pub(super) number: usize,
    pub(super) variant: Variant,
    /// Which stretch between ends it is on.
    pub(super) stretch: usize,
    pub(super) rows: Vec<f64>,
    pub(super) taken: usize,
    pub(super) rejected: u64,
    pub(super) stopped: Option<Stopped>,
    milestone: Milestone,
    /// It has computed for so long.
    time_spent: Duration,
    /// Whether it has taken too many loose steps.
    pub(super) is_over: bool,
}

impl Lane {
    pub(super) fn new(number: usize, variant: Variant) -> Self {
        Self {
            number,
            stretch: 0,
            rows: Vec::with_capacity(variant.times.len() * variant.initial.len()),
            taken: 0,
            rejected: 0,
            stopped: None,
            milestone: Milestone::default(),
            time_spent: variant.time_spent,
            is_over: false,
            variant,
        }
    }

    pub(super) fn from(&self) -> f64 {
        self.variant.ends[self.stretch]
    }

    pub(super) fn until(&self) -> f64 {
        self.variant.ends[self.stretch + 1]
    }

    /// Start of the whole run, and its length.
    pub(super) fn span(&self) -> (f64, f64) {
        let ends = &self.variant.ends;
        (ends[0], ends[ends.len() - 1] - ends[0])
    }

    /// The time of the sample that is due next; infinite if there is none.
    pub(super) fn next_sample(&self) -> f64 {
        self.variant.times.get(self.taken).copied().unwrap_or(f64::INFINITY)
    }

    /// After so many steps it is to be asked whether the variant goes on.
    pub(super) fn steps_at_once(&self) -> u64 {
        self.milestone.next().min(self.variant.max_steps as u64)
    }

    /// As [`crate::method::Stretch::out_of_steps`], after steps up to a time.
    pub(super) fn out_of_steps(
        &mut self,
        steps: u64,
        time: f64,
        patience: &Patience<'_>,
    ) -> Option<StopCause> {
        let left = self.until() - time;
        out_of_steps((steps, self.variant.max_steps), left, || {
            if patience.is_limited() { None } else { self.milestone.pace(steps, time) }
        })
    }

    /// Why it is to end after it has computed for some more time, if it is.
    pub(super) fn out_of_patience(
        &mut self,
        more: Duration,
        patience: &Patience<'_>,
    ) -> Option<StopCause> {
        self.time_spent += more;
        patience.end(|| self.time_spent)
    }

    pub(super) fn stop(&mut self, time: f64, cause: StopCause) {
        self.stopped = Some(Stopped { time, cause });
    }

    /// What came of the variant, after steps of so many orders.
    pub(super) fn ended(self, steps: u64, order: usize) -> Ended {
        if let Some(stopped) = self.stopped {
            let spent = Spent { steps, time: self.time_spent };
            return if self.is_over { Ended::Over(spent) } else { Ended::Stopped(stopped) };
        }
        // Coefficients are those of ends of steps, and of starts of stretches.
        let series = steps + self.rejected + self.stretch as u64;
        let work = Work {
            steps,
            rejected: self.rejected,
            rate_evaluations: series * order as u64,
            ..Work::default()
        };
        Ended::Through(Outcome { rows: self.rows, work })
    }
}
