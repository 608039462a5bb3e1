//! Caution of implicit methods where a machine changes suddenly.

use super::one_step::Trial;

/// Holds errors stricter from a step on that fails by far though the one before was good.
///
/// Where a machine that sticks lets go, small errors grow a thousandfold before anything is seen
/// of it, and no estimate of an error of one step knows that. What is seen are such steps.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Caution {
    /// Whether a step was taken since the last start: what comes first is guessed.
    has_stepped: bool,
    /// Whether a step failed by far since then, and one before the last that was taken.
    is_surprised: bool,
    is_warned: bool,
}

impl Caution {
    /// Another start: the first step from it is guessed, and what a kink on the way there did
    /// is explained.
    pub(super) fn begin(&mut self) {
        self.has_stepped = false;
        self.is_surprised = false;
    }

    /// Looks at what came of a step.
    pub(super) fn look(&mut self, tried: &Result<f64, Trial>) {
        /// An error, over what is allowed, that the step before did not foretell.
        const FAR: f64 = 10.0;
        self.is_surprised |= self.has_stepped && !matches!(tried, Ok(error) if *error < FAR);
    }

    /// The step that was tried last is taken.
    pub(super) fn accept(&mut self) {
        self.has_stepped = true;
        self.is_warned |= std::mem::take(&mut self.is_surprised);
    }

    /// By so much errors are held stricter: measured by a block that sticks and slips on a belt
    /// with the friction of bristles (`cargo bench -p machinist-tests --features measure --bench
    /// tolerances`).
    pub(super) fn strictness(&self) -> f64 {
        const STRICTER: f64 = 30.0;
        if self.is_warned || self.is_surprised { STRICTER } else { 1.0 }
    }

    /// Whether a step that was taken was a surprise before.
    pub(super) fn is_warned(&self) -> bool {
        self.is_warned
    }
}
