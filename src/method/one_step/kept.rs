//! The end of a step, projected onto the constraints.

use super::OneStep;
use super::bends::Bends;
use crate::method::{Stopped, Stretch};

/// Distance from the constraints, in tolerances of a step, beyond which projection is not believed:
/// near a change point it enlarges errors without bound.
const FAR: f64 = 100.0;

/// The end of a step, on the constraints.
pub(super) struct Kept {
    pub(super) end: Vec<f64>,
    /// The end of the step before, with constraints.
    before: Vec<f64>,
    bends: Option<Bends>,
}

/// The distance by which a state was projected, in tolerances.
#[derive(Clone, Copy)]
pub(super) struct Moved(f64);

impl Moved {
    /// Returns whether the next step has to start from the projected state.
    pub(super) fn is_noticed(self) -> bool {
        /// Share of the tolerances of a step.
        const NOTICED: f64 = 1e-3;
        self.0 > NOTICED
    }

    /// Returns whether the projected state is not believed.
    pub(super) fn is_far(self) -> bool {
        self.0.is_nan() || self.0 > FAR
    }
}

impl Kept {
    pub(super) fn new(state: &[f64]) -> Self {
        Self { end: state.to_vec(), before: Vec::new(), bends: None }
    }

    /// Returns the same, with the places at which functions bend.
    pub(super) fn with_bends(method: &dyn OneStep, stretch: &Stretch<'_>, state: &[f64]) -> Self {
        Self { bends: Bends::new(method, stretch), ..Self::new(state) }
    }

    /// Returns the time of the first bend within the current step that the method does not see.
    pub(super) fn first_bend<M: OneStep>(
        &mut self,
        method: &mut M,
        stretch: &Stretch<'_>,
        ends: [f64; 2],
    ) -> Option<f64> {
        self.bends.as_mut()?.first(method, stretch, &self.end, ends)
    }

    /// Projects the end of the current step onto the constraints. Returns how far it moved.
    pub(super) fn put_back(
        &mut self,
        method: &dyn OneStep,
        stretch: &Stretch<'_>,
        time: f64,
    ) -> Result<Moved, Stopped> {
        let end = method.end();
        let is_sliding = stretch.system.is_sliding();
        if stretch.system.constraints().is_none() && !is_sliding {
            self.end.copy_from_slice(end);
            return Ok(Moved(0.0));
        }
        self.before.clone_from(&self.end);
        self.end.copy_from_slice(end);
        if is_sliding {
            stretch.system.put_onto_surfaces(stretch.within(time), &mut self.end)?;
        }
        stretch.constrain(time, &mut self.end)?;
        Ok(Moved(distance(stretch, &self.end, end)))
    }

    /// Exchanges the projected end of the current step and its start.
    pub(super) fn exchange(&mut self) {
        std::mem::swap(&mut self.end, &mut self.before);
    }
}

/// Projects a state within a step onto the constraints, if projection is to be believed: its step
/// may pass a change point, where the state of the method is nearer to the motion.
pub(super) fn put_back_between(stretch: &Stretch<'_>, time: f64, state: &mut [f64]) {
    if stretch.system.constraints().is_none() {
        return;
    }
    let mut projected = state.to_vec();
    let is_projected = stretch.constrain(time, &mut projected).is_ok();
    if is_projected && !Moved(distance(stretch, &projected, state)).is_far() {
        state.copy_from_slice(&projected);
    }
}

/// Returns the largest distance of one state from another, in tolerances.
fn distance(stretch: &Stretch<'_>, one: &[f64], other: &[f64]) -> f64 {
    let distances = (0..stretch.system.states()).map(|index| {
        let allowed = stretch.atol[index] + stretch.rtol * other[index].abs();
        (one[index] - other[index]).abs() / allowed
    });
    distances.fold(0.0, f64::max)
}
