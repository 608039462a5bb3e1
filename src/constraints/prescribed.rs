//! Constraints that hold in modes and repeat others: a part that sticks may go on moving with the
//! part that holds it, such as a shaft with prescribed motion.

use super::mobility::repeated_rows;
use super::{Constraints, Level, largest_of};

impl Constraints<'_> {
    /// Returns the rows that hold in the modes of a state and repeat others.
    pub(crate) fn prescribed(&self, time: f64, state: &[f64]) -> Vec<usize> {
        let mut rows = repeated_rows(self, &self.matrix(time, state));
        rows.retain(|row| self.simulator.constraint(*row).in_modes);
        rows
    }

    /// Projects a state onto all constraints except these rows, as far as possible.
    pub(crate) fn follow(&self, prescribed: &[usize], time: f64, state: &mut [f64]) {
        let state = &mut state[..self.simulator.shape().states()];
        for level in [Level::Positions, Level::Velocities] {
            let mut there = state.to_vec();
            if self.put_back_but(prescribed, level, time, &mut there).is_ok() {
                state.copy_from_slice(&there);
            }
        }
    }

    /// Returns the largest residual of these rows in velocity, as defined by
    /// [`Constraints::relative`].
    pub(crate) fn left_behind(&self, prescribed: &[usize], time: f64, state: &[f64]) -> f64 {
        let state = &state[..self.simulator.shape().states()];
        let slopes = self.slopes(time, state);
        let residual = self.residual(Level::Velocities, time, state);
        let off = self.relative(Level::Velocities, &slopes, &residual, state);
        let off: Vec<f64> = prescribed.iter().map(|row| off[*row]).collect();
        largest_of(&off)
    }

    /// Returns whether some constraints hold always and some in modes, so that the former may
    /// prescribe the motion of the latter.
    pub(crate) fn may_lead(&self) -> bool {
        self.holds_in_modes() && (0..self.count).any(|row| !self.simulator.constraint(row).in_modes)
    }
}
