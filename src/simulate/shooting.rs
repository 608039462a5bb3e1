//! Runs from one state to another, as shooting needs them.

use super::Simulation;
use crate::method::sensitivity::By;

impl Simulation<'_> {
    /// Starts from exactly this state: initial values and the search for an equilibrium no longer
    /// apply.
    pub(crate) fn shot_from(mut self, state: &[f64]) -> Self {
        self.initial_state = Some(state.to_vec());
        self.initial_values.clear();
        self.in_equilibrium = Some(false);
        self
    }

    /// Requests sensitivities by the initial values of these states, then by this parameter.
    pub(crate) fn along(mut self, states: &[usize], parameter: Option<usize>) -> Self {
        let states = states.iter().map(|index| By::Initial(*index));
        self.sensitivities = states.chain(parameter.map(By::Parameter)).collect();
        self
    }

    /// Sets the parameter of an index.
    pub(crate) fn parameter_at(mut self, index: usize, value: f64) -> Self {
        self.parameters[index] = value;
        self
    }

    /// Returns the indices of states that are not modes.
    pub(crate) fn continuous_states(&self) -> Vec<usize> {
        let states = 0..self.simulator.shape().states();
        states.filter(|index| !self.simulator.is_mode(*index)).collect()
    }
}
