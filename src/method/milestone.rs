//! Runs whose steps are so short that they lead nowhere near the end.

use crate::error::StopCause;

/// Number of steps measured at once: a start from rest, a contact or a run-in is over by then.
const MANY: u64 = 100_000;
/// Multiple of the limit on steps, at the pace of the last ones, above which a run is hopeless: no
/// run becomes so much faster that it would end after all.
const HOPELESS: f64 = 1e5;

/// Steps and time at the last measurement of the pace of a run.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Milestone {
    steps: u64,
    time: f64,
}

impl Milestone {
    /// Returns the number of steps at the next measurement.
    #[cfg(feature = "sweep")]
    pub(super) fn next(&self) -> u64 {
        self.steps + MANY
    }

    /// Returns the mean of many steps, of which the last ended at `time` \[s\], once in as many.
    pub(super) fn pace(&mut self, steps: u64, time: f64) -> Option<f64> {
        let earlier = *self;
        if steps.saturating_sub(earlier.steps) < MANY {
            return None;
        }
        *self = Self { steps, time };
        (earlier.steps > 0).then(|| (time - earlier.time) / (steps - earlier.steps) as f64)
    }
}

/// Returns the cause to end after some steps if all allowed steps are taken, or if what is `left`
/// \[s\] takes far too many steps of the length that is measured occasionally.
pub(super) fn out_of_steps(
    (steps, limit): (u64, usize),
    left: f64,
    pace: impl FnOnce() -> Option<f64>,
) -> Option<StopCause> {
    if steps >= limit as u64 {
        return Some(StopCause::TooManySteps { limit });
    }
    let step = pace()?;
    let steps = left / step;
    (steps > HOPELESS * limit as f64).then_some(StopCause::TooSlowPace { step, steps })
}
