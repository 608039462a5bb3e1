//! A variant and its progress in a lane.

use std::time::Duration;

use crate::error::StopCause;
use crate::method::milestone::{Milestone, out_of_steps};
use crate::method::patience::Patience;
use crate::method::{StepTolerance, Stopped, Work};

/// A variant of a machine to be run.
pub(crate) struct Variant {
    pub(crate) parameters: Vec<f64>,
    pub(crate) initial: Vec<f64>,
    /// Start, jumps in order, and end \[s\].
    pub(crate) ends: Vec<f64>,
    /// Output times, sorted \[s\].
    pub(crate) times: Vec<f64>,
    pub(crate) tolerance: StepTolerance,
    pub(crate) max_steps: usize,
}

/// Result of a variant.
pub(crate) enum Ended {
    /// The run is complete.
    Through(Outcome),
    /// The run stopped.
    Stopped(Stopped),
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
            time_spent: Duration::ZERO,
            variant,
        }
    }

    pub(super) fn from(&self) -> f64 {
        self.variant.ends[self.stretch]
    }

    pub(super) fn until(&self) -> f64 {
        self.variant.ends[self.stretch + 1]
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
            return Ended::Stopped(stopped);
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
