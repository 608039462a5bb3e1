//! Caution of implicit methods where a machine changes suddenly.

use super::one_step::Trial;

/// Tightens errors from a step that fails by far, though it is not much longer than the previous
/// one, which was good.
///
/// When a sticking part breaks away, small errors grow a thousandfold before anything is visible,
/// and no error estimate of a single step shows it. Only such steps show it.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Caution {
    /// The last step taken since the last start \[s\]; 0 if there is none.
    taken: f64,
    /// True if a step failed by far since then, before the last one that was taken.
    is_surprised: bool,
    is_warned: bool,
}

impl Caution {
    /// Begins another start: its first step is a guess, and the effect of a kink on the way there
    /// is explained.
    pub(super) fn begin(&mut self) {
        self.taken = 0.0;
        self.is_surprised = false;
    }

    /// Takes the result of a step.
    pub(super) fn look(&mut self, step: f64, tried: &Result<f64, Trial>) {
        /// Error over the tolerances that the previous step did not predict.
        const FAR: f64 = 10.0;
        /// Growth of a step above which it was a guess.
        const LONGER: f64 = 3.0;
        let is_far = !matches!(tried, Ok(error) if *error < FAR);
        self.is_surprised |= is_far && step.abs() <= LONGER * self.taken.abs();
    }

    /// Accepts the step that was tried last.
    pub(super) fn accept(&mut self, step: f64) {
        self.taken = step;
        self.is_warned |= std::mem::take(&mut self.is_surprised);
    }

    /// Returns the factor by which errors are tighter than a relative tolerance requires: measured
    /// with a block that sticks and slips on a belt with the friction of bristles (`cargo bench -p
    /// machinist-tests --features measure --bench tolerances`); smaller where rounding would limit
    /// it.
    pub(super) fn strictness(&self, rtol: f64) -> f64 {
        const STRICTER: f64 = 30.0;
        const TIGHTEST: f64 = 1e-12;
        if self.is_warned || self.is_surprised {
            (rtol / TIGHTEST).clamp(1.0, STRICTER)
        } else {
            1.0
        }
    }
}
