//! Caution of implicit methods where a machine changes suddenly.

use super::one_step::Trial;

/// Holds errors stricter from a step on that fails by far though it is not much longer than the
/// one before, which was good.
///
/// Where a machine that sticks lets go, small errors grow a thousandfold before anything is seen
/// of it, and no estimate of an error of one step knows that. What is seen are such steps.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Caution {
    /// The last step taken since the last start \[s\]; 0 if there is none.
    taken: f64,
    /// Whether a step failed by far since then, and one before the last that was taken.
    is_surprised: bool,
    is_warned: bool,
}

impl Caution {
    /// Another start: the first step from it is guessed, and what a kink on the way there did
    /// is explained.
    pub(super) fn begin(&mut self) {
        self.taken = 0.0;
        self.is_surprised = false;
    }

    /// Looks at what came of a step.
    pub(super) fn look(&mut self, step: f64, tried: &Result<f64, Trial>) {
        /// An error, over what is allowed, that the step before did not foretell.
        const FAR: f64 = 10.0;
        /// A step that grew by more was a guess.
        const LONGER: f64 = 3.0;
        let is_far = !matches!(tried, Ok(error) if *error < FAR);
        self.is_surprised |= is_far && step.abs() <= LONGER * self.taken.abs();
    }

    /// The step that was tried last is taken.
    pub(super) fn accept(&mut self, step: f64) {
        self.taken = step;
        self.is_warned |= std::mem::take(&mut self.is_surprised);
    }

    /// By so much errors are held stricter than a relative tolerance asks for: measured by a
    /// block that sticks and slips on a belt with the friction of bristles (`cargo bench -p
    /// machinist-tests --features measure --bench tolerances`); less where rounding would be in the way.
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
