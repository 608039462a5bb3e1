//! The end of a step, put back onto what constraints hold.

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

    /// Takes the end of the current step and puts it back onto the constraints; whether
    /// that is a move that the next step should start with.
    pub(super) fn put_back(
        &mut self,
        method: &dyn OneStep,
        stretch: &Stretch<'_>,
        time: f64,
    ) -> Result<bool, Stopped> {
        /// Of what the tolerances allow a step.
        const NOTICED: f64 = 1e-3;
        let end = method.end();
        self.end.copy_from_slice(end);
        if stretch.system.constraints().is_none() {
            return Ok(false);
        }
        stretch.constrain(time, &mut self.end)?;
        Ok(self.moved_from(stretch, end) > NOTICED)
    }

    /// The same where a step ends at a kink, in `front` of which the constraints may hold other
    /// speeds than at it: what jumps there has not jumped yet.
    pub(super) fn stay_in_front(
        &mut self,
        method: &mut dyn OneStep,
        stretch: &Stretch<'_>,
        (front, time): (f64, f64),
    ) -> Result<(), Stopped> {
        self.put_back(method, stretch, time)?;
        if self.moved_from(stretch, method.end()) > 1.0 {
            let mut at = |time: f64| {
                let mut state = self.end.clone();
                method.interpolate(time, &mut state);
                stretch.constrain(time, &mut state).map(|()| state)
            };
            let [earlier, nearer] = [at(front)?, at(0.5 * (front + time))?];
            let off = self.moved_from(stretch, &earlier);
            // What does not jump is half as far half as soon.
            if off > 1.0 && self.moved_from(stretch, &nearer) > 0.75 * off {
                self.end = earlier;
            }
        }
        Ok(())
    }

    /// By how many tolerances the end is off a state.
    fn moved_from(&self, stretch: &Stretch<'_>, state: &[f64]) -> f64 {
        let moved = (0..stretch.system.states()).map(|index| {
            let allowed = stretch.atol[index] + stretch.rtol * state[index].abs();
            (self.end[index] - state[index]).abs() / allowed
        });
        moved.fold(0.0, f64::max)
    }
}
