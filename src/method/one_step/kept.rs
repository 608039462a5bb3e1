//! The end of a step, projected onto the constraints.

use super::OneStep;
use crate::method::{Stopped, Stretch};

/// The end of a step, on the constraints.
pub(super) struct Kept {
    pub(super) end: Vec<f64>,
}

impl Kept {
    pub(super) fn new(state: &[f64]) -> Self {
        Self { end: state.to_vec() }
    }

    /// Projects the end of the current step onto the constraints. Returns whether the move is large
    /// enough for the next step to start from it.
    pub(super) fn put_back(
        &mut self,
        method: &dyn OneStep,
        stretch: &Stretch<'_>,
        time: f64,
    ) -> Result<bool, Stopped> {
        /// Share of the tolerances of a step.
        const NOTICED: f64 = 1e-3;
        let end = method.end();
        self.end.copy_from_slice(end);
        let is_sliding = stretch.system.is_sliding();
        if stretch.system.constraints().is_none() && !is_sliding {
            return Ok(false);
        }
        if is_sliding {
            stretch.system.put_onto_surfaces(stretch.within(time), &mut self.end)?;
        }
        stretch.constrain(time, &mut self.end)?;
        Ok(self.moved_from(stretch, end) > NOTICED)
    }

    /// Returns the largest distance of the end from a state, in tolerances.
    fn moved_from(&self, stretch: &Stretch<'_>, state: &[f64]) -> f64 {
        let moved = (0..stretch.system.states()).map(|index| {
            let allowed = stretch.atol[index] + stretch.rtol * state[index].abs();
            (self.end[index] - state[index]).abs() / allowed
        });
        moved.fold(0.0, f64::max)
    }
}
