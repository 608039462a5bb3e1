//! Settings of energies, and energies at the start of a run.

use super::Simulation;
use crate::error::SimulateError;

impl Simulation<'_> {
    /// Integrates the power balance alongside the states, for [`Trajectory::energy_balance`]. Its
    /// error is controlled like that of the states, so the steps differ from those of a run without
    /// it.
    ///
    /// [`Trajectory::energy_balance`]: crate::Trajectory::energy_balance
    pub fn with_energy_balance(mut self, wanted: bool) -> Self {
        self.energy_balance = wanted;
        self
    }

    /// Projects the states of a conservative machine with constraints onto its energy after each
    /// step, along with the constraints. Over long runs the energy then keeps the value of the start
    /// to rounding, and so does the pace of the motion.
    pub fn with_constant_energy(mut self, wanted: bool) -> Self {
        self.keeps_energy = wanted;
        self
    }

    /// Returns T + V + stored at the start \[J\].
    pub(super) fn total_energy(&self, initial: &[f64]) -> f64 {
        self.simulator.energy(self.from, initial, &self.parameters).total()
    }

    /// Returns a typical energy of the machine at its start \[J\].
    pub(crate) fn typical_energy(&self) -> Result<f64, SimulateError> {
        self.checked_initial_state().map(|initial| self.energy_scale(&initial))
    }

    /// Returns a typical energy of the machine \[J\], for the absolute tolerance of the
    /// quadratures: the energy at the start, or with every state at its scale, whichever is larger;
    /// 1 J if both are zero.
    pub(super) fn energy_scale(&self, initial: &[f64]) -> f64 {
        let scales: Vec<f64> =
            (0..initial.len()).map(|index| self.simulator.state_scale(index)).collect();
        let size = |state: &[f64]| {
            let energy = self.simulator.energy(self.from, state, &self.parameters);
            energy.kinetic.abs() + energy.stored.abs()
        };
        let scale = size(initial).max(size(&scales));
        if scale.is_finite() && scale > 0.0 { scale } else { 1.0 }
    }
}
