//! A variant and its progress in a lane.

use std::time::Duration;

use crate::error::StopCause;
use crate::method::milestone::{Milestone, out_of_steps};
use crate::method::patience::Patience;
use crate::method::{Stopped, Work};

/// A variant of a machine to be run.
pub(crate) struct Variant {
    pub(crate) parameters: Vec<f64>,
    pub(crate) initial: Vec<f64>,
    /// Start, jumps in order, and end \[s\].
    pub(crate) ends: Vec<f64>,
    /// Output times, sorted \[s\].
    pub(crate) times: Vec<f64>,
    pub(crate) atol: Vec<f64>,
    pub(crate) max_steps: usize,
    /// Computing time spent before.
    pub(crate) time_spent: Duration,
    /// Number of steps that counts as few; infinite if many steps are allowed.
    pub(crate) few: f64,
}

/// Result of a variant.
pub(crate) enum Ended {
    /// The run is complete.
    Through(Outcome),
    /// The run stopped.
    Stopped(Stopped),
    /// The run was left because its loose steps are too many.
    Over(Spent),
}

/// Work spent on a variant in vain.
#[derive(Clone, Copy, Default)]
pub(crate) struct Spent {
    pub(crate) steps: u64,
    pub(crate) time: Duration,
}

/// States at the output times, one row after another.
pub(crate) struct Outcome {
    pub(crate) rows: Vec<f64>,
    pub(crate) work: Work,
}

/// A variant in progress.
pub(super) struct Lane {
    pub(super) number: usize,
    pub(super) variant: Variant,
    /// Index of the current segment.
    pub(super) stretch: usize,
    pub(super) rows: Vec<f64>,
    pub(super) taken: usize,
    pub(super) rejected: u64,
    pub(super) stopped: Option<Stopped>,
    milestone: Milestone,
    /// Computing time spent.
    time_spent: Duration,
    /// True if the variant has taken too many loose steps.
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

    /// Returns the start and the length of the whole run.
    pub(super) fn span(&self) -> (f64, f64) {
        let ends = &self.variant.ends;
        (ends[0], ends[ends.len() - 1] - ends[0])
    }

    /// Returns the time of the next sample; infinite if there is none.
    pub(super) fn next_sample(&self) -> f64 {
        self.variant.times.get(self.taken).copied().unwrap_or(f64::INFINITY)
    }

    /// Returns the number of steps after which the variant is asked whether it goes on.
    pub(super) fn steps_at_once(&self) -> u64 {
        self.milestone.next().min(self.variant.max_steps as u64)
    }

    /// Does the same as [`crate::method::Stretch::out_of_steps`], after steps up to a time.
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

    /// Returns why the variant has to end after more computing time, if it has to.
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

    /// Returns the result of the variant, after a number of steps of an order.
    pub(super) fn ended(self, steps: u64, order: usize) -> Ended {
        if let Some(stopped) = self.stopped {
            let spent = Spent { steps, time: self.time_spent };
            return if self.is_over { Ended::Over(spent) } else { Ended::Stopped(stopped) };
        }
        // Coefficients are those at ends of steps and at starts of segments.
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
