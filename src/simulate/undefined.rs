//! Parameters whose values leave the rate without a value.

use super::Simulation;
use crate::error::StopCause;
use crate::method::Held;

/// Size of the value that replaces a parameter of 0 whose default is 0.
const SMALL: f64 = 1e-3;

impl Simulation<'_> {
    /// Adds to the cause of a stop the parameters to whose values it is due, if the rate is not finite
    /// at the start already: each is replaced by its default, or a zero by a small number, and makes
    /// the rate finite alone.
    pub(super) fn with_parameters(&self, cause: StopCause, start: &[f64]) -> StopCause {
        let StopCause::NotFinite { what, .. } = cause else { return cause };
        let parameters = if self.has_rate(&self.parameters, start) {
            Vec::new()
        } else {
            (0..self.simulator.shape().parameters)
                .filter(|index| self.is_due_to(*index, start))
                .map(|index| {
                    (self.simulator.parameter(index).name.to_owned(), self.parameters[index])
                })
                .collect()
        };
        StopCause::NotFinite { what, parameters }
    }

    /// Returns whether another value of a parameter makes the rate finite.
    fn is_due_to(&self, index: usize, start: &[f64]) -> bool {
        let (own, default) = (self.parameters[index], self.simulator.parameter_default(index));
        let beside = if own == 0.0 { SMALL } else { own };
        [default, beside].into_iter().filter(|value| value.to_bits() != own.to_bits()).any(
            |value| {
                let mut changed = self.parameters.clone();
                changed[index] = value;
                self.has_rate(&changed, start)
            },
        )
    }

    /// Returns whether all rates are finite at a state.
    fn has_rate(&self, parameters: &[f64], state: &[f64]) -> bool {
        let mut rate = vec![0.0; state.len()];
        let held = Held::live(self.simulator, parameters);
        self.simulator.rate(self.from, state, &held.all(), &mut rate);
        rate.iter().all(|value| value.is_finite())
    }
}
