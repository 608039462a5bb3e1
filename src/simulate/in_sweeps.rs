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
            tolerance: StepTolerance::new(method, (self.simulator, parameters), (self.rtol, atol)),
            max_steps: self.max_steps,
            initial,
        })
    }

    /// Returns the limits on the duration of the run.
    pub(crate) fn patience(&self) -> Patience<'a> {
        self.patience
    }

    /// Returns the method of the run and the relative tolerance of its steps.
    pub(crate) fn method_and_step_rtol(&self) -> Result<(Method, f64), SimulateError> {
        let method = self.chosen_method()?;
        Ok((method, method.step_rtol((self.simulator, &self.parameters), self.rtol).0))
    }

    /// Returns whether the run has neither sensitivities nor an energy balance.
    #[cfg(feature = "implicit")]
    pub(crate) fn is_of_states_alone(&self) -> bool {
        self.sensitivities.is_empty() && !self.energy_balance
    }
}
