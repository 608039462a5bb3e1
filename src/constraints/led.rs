//! Constraints that hold in modes and repeat others, as these go on: what is held already may
//! move on with what holds it, as a shaft does whose motion is imposed.

use super::mobility::repeated_rows;
use super::{Constraints, Level, largest_of};

impl Constraints<'_> {
    /// Rows that hold in the modes of a state and repeat others.
    pub(crate) fn led(&self, time: f64, state: &[f64]) -> Vec<usize> {
        let mut rows = repeated_rows(self, &self.matrix(time, state));
        rows.retain(|row| self.simulator.constraint(*row).in_modes);
        rows
    }

    /// Puts a state onto all constraints but these rows, as well as it can be.
    pub(crate) fn follow(&self, led: &[usize], time: f64, state: &mut [f64]) {
        let state = &mut state[..self.simulator.shape().states()];
        for level in [Level::Positions, Level::Velocities] {
            let mut there = state.to_vec();
            if self.put_back_but(led, level, time, &mut there).is_ok() {
                state.copy_from_slice(&there);
            }
        }
    }

    /// By how much these rows are off in velocity, as [`Constraints::relative`] has it.
    pub(crate) fn left_behind(&self, led: &[usize], time: f64, state: &[f64]) -> f64 {
        let state = &state[..self.simulator.shape().states()];
        let slopes = self.slopes(time, state);
        let residual = self.residual(Level::Velocities, time, state);
        let off = self.relative(Level::Velocities, &slopes, &residual, state);
        let off: Vec<f64> = led.iter().map(|row| off[*row]).collect();
        largest_of(&off)
    }

    /// Whether some hold always and some in modes, so that those may lead these.
    pub(crate) fn may_lead(&self) -> bool {
        self.holds_in_modes() && (0..self.count).any(|row| !self.simulator.constraint(row).in_modes)
    }
}
