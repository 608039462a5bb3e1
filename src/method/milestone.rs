//! Runs whose steps are so short that they lead nowhere near the end.

use crate::error::StopCause;

/// So many steps are measured at once: a start from rest, a contact or a run-in is over by then.
const MANY: u64 = 100_000;
/// So many times the limit on steps at the pace of the last ones: no run becomes so much faster
/// that it would end after all.
const HOPELESS: f64 = 1e5;

/// Steps and time when last the pace of a run was measured.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Milestone {
    steps: u64,
    time: f64,
}

impl Milestone {
    /// The next one is after so many steps.
    #[cfg(feature = "sweep")]
    pub(super) fn next(&self) -> u64 {
        self.steps + MANY
    }

    /// The mean of many steps, of which the last ended at `time` \[s\]; once in as many.
    pub(super) fn pace(&mut self, steps: u64, time: f64) -> Option<f64> {
        let earlier = *self;
        if steps.saturating_sub(earlier.steps) < MANY {
            return None;
        }
        *self = Self { steps, time };
        (earlier.steps > 0).then(|| (time - earlier.time) / (steps - earlier.steps) as f64)
    }
}

/// The cause to end after so many steps if they are all that may be taken, or if what is `left` \[s\]
/// takes far too many steps of the length that is measured now and then.
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
