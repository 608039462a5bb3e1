//! Notes on the tolerance of a run and on the size of its states.

use super::Simulation;
use super::small::SMALL;
use crate::error::SimulateError;
use crate::method::tolerance::step_rtol;
use crate::method::{Method, StepTolerance, System};

/// Product of steps and relative tolerance above which a note warns that local errors add up. A
/// shaft of 96 nodes without damping (`reed_beat_up`) was off by 16 times its motion at a product
/// of 0.9, and by a hundredth at 0.006.
const ADDS_UP: f64 = 0.1;

impl Simulation<'_> {
    /// Returns the method of the run and the relative tolerance of its steps.
    pub(crate) fn method_and_step_rtol(&self) -> Result<(Method, f64), SimulateError> {
        let method = self.chosen_method()?;
        let machine = (self.simulator, &self.parameters[..]);
        Ok((method, step_rtol((method, self.auto), machine, self.rtol).0))
    }

    /// Adds notes on the tolerances of steps.
    pub(super) fn note_tolerance(
        &self,
        system: &System<'_>,
        tolerance: &StepTolerance,
        rows: &[f64],
    ) {
        let (steps, rtol) = (system.work().steps, tolerance.rtol);
        if let Some(reason) = tolerance.reason {
            system.note(format!(
                "steps keep to a relative tolerance of {rtol:e} instead of {:e}: {reason}",
                self.rtol
            ));
        }
        if steps as f64 * rtol > ADDS_UP {
            system.note(format!(
                "each of {steps} steps may have a relative error of {rtol:e}, and in undamped \
                 motions these errors add up: compare with a run at a lower `rtol`"
            ));
        }
        if self.atol.is_none() {
            self.note_small(system, tolerance, rows);
        }
    }

    /// Adds a note on states that move far less than their absolute tolerance assumes.
    fn note_small(&self, system: &System<'_>, tolerance: &StepTolerance, rows: &[f64]) {
        /// Apparent motion of a state at rest, due to rounding.
        const ROUNDING: f64 = 16.0 * f64::EPSILON;
        let width = system.len();
        let largest = |index: usize| {
            let values = rows.iter().skip(index).step_by(width);
            values.map(|value| value.abs()).filter(|value| value.is_finite()).fold(0.0, f64::max)
        };
        let scale = |index: usize| tolerance.atol[index] / tolerance.rtol;
        let small: Vec<(usize, f64, f64)> = (0..system.states())
            .filter(|index| !self.simulator.is_mode(*index))
            .map(|index| (index, scale(index), largest(index)))
            .filter(|(_, scale, most)| (ROUNDING * scale..SMALL * scale).contains(most))
            .collect();
        if small.is_empty() {
            return;
        }
        system.note(format!(
            "errors of {} are controlled to {:e} of the scale, which is much larger than the motion: \
             give a `scale` of its size in the spec, or a lower `rtol`",
            self.listed(&small),
            tolerance.rtol
        ));
    }

    /// Lists the first few of some states with their scales and largest values.
    pub(super) fn listed(&self, states: &[(usize, f64, f64)]) -> String {
        const SHOWN: usize = 3;
        let of = |(index, scale, most): &(usize, f64, f64)| {
            let state = self.simulator.state(*index);
            format!("`{}` (at most {most:.1e} {}, scale {scale:e})", state.name, state.unit)
        };
        let more = if states.len() > SHOWN { ", ..." } else { "" };
        let shown: Vec<String> = states.iter().take(SHOWN).map(of).collect();
        format!("{}{more}", shown.join(", "))
    }
}
