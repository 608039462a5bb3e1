//! Properties of a run that sweeps need.

use super::Simulation;
use crate::error::SimulateError;
use crate::method::patience::Patience;
use crate::method::taylor::variants::Variant;
use crate::method::{Method, StepTolerance, cut};

impl<'a> Simulation<'a> {
    /// Returns the data that a method in lanes needs for a run.
    ///
    /// # Errors
    /// As [`Simulation::run`].
    pub(crate) fn variant_for(&self, method: Method) -> Result<Variant, SimulateError> {
        let parameters = self.checked_parameters()?;
        let initial = self.checked_initial_state()?;
        let atol = self.checked_atol(&initial)?;
        Ok(Variant {
            parameters: parameters.to_vec(),
            ends: cut(self.from, self.until, self.checked_jumps()?),
            times: self.checked_times()?,
            tolerance: StepTolerance::new(
                (method, self.auto),
                (self.simulator, parameters),
                (self.rtol, atol),
            ),
            max_steps: self.max_steps,
            initial,
        })
    }

    /// Returns the limits on the duration of the run.
    pub(crate) fn patience(&self) -> Patience<'a> {
        self.patience
    }

    /// Returns whether the run has neither sensitivities nor an energy balance, and leaves the choice
    /// of the explicit method to `auto`.
    #[cfg(feature = "implicit")]
    pub(crate) fn may_go_in_lanes(&self) -> bool {
        self.auto.explicit.is_none() && self.sensitivities.is_empty() && !self.energy_balance
    }
}
