//! States that move far less than the scale that their absolute tolerance assumes.
//!
//! A state without a `scale` in the spec has scale 1. If it stays far below it along a run, the run
//! is repeated with absolute tolerances of its own size. A state that is only rounding cannot be held
//! to its size: steps would shrink to nothing, and the first run is kept.

use std::time::Instant;

use super::Simulation;
use crate::error::SimulateError;
use crate::method::System;
use crate::trajectory::Trajectory;

/// Fraction of a state's scale below which all of its motion is small: it then has three digits less
/// than requested.
pub(super) const SMALL: f64 = 1e-3;

/// A run, the largest absolute value of every state unless the run is a closed form, and the scales
/// that its tolerances assumed.
pub(super) struct Sized {
    pub(super) trajectory: Trajectory,
    pub(super) sizes: Vec<f64>,
    pub(super) scales: Vec<f64>,
}

impl Simulation<'_> {
    /// Sets whether a run is repeated if states without a scale of their own turn out to be far below
    /// it, so that their errors are relative to their size; true unless set. Sweeps repeat no runs.
    pub fn with_small_states_held(mut self, wanted: bool) -> Self {
        self.holds_small = wanted;
        self
    }

    /// Runs, and repeats the run while states without a scale of their own are small.
    pub(super) fn run_resized(
        &self,
        run: impl Fn(&Self) -> Result<Sized, SimulateError>,
    ) -> Result<Trajectory, SimulateError> {
        /// Maximum number of repetitions: a state that was small by its errors is smaller afterwards.
        const ROUNDS: usize = 3;
        /// Maximum ratio of the steps of a repetition to those expected from the order.
        const MORE: f64 = 4.0;
        /// Number of steps of a short run, which a repetition may exceed by more.
        const FEW: u64 = 50;
        let began = Instant::now();
        let mut best = run(self)?;
        let (mut again, mut first) = (self.clone(), String::new());
        for _ in 0..ROUNDS {
            let small = self.small(&best);
            if small.is_empty() {
                break;
            }
            if first.is_empty() {
                let scaled = |(index, size): &(usize, f64)| (*index, best.scales[*index], *size);
                first = self.listed(&small.iter().map(scaled).collect::<Vec<_>>());
            }
            let ratios = small.iter().map(|(index, size)| best.scales[*index] / size);
            let order = best.trajectory.method.order().clamp(2, 4);
            let expected = ratios.fold(1.0, f64::max).powf(1.0 / f64::from(order + 1));
            let limit = MORE * expected * best.trajectory.work.steps.max(FEW) as f64;
            again.max_steps = (limit as usize).min(self.max_steps);
            again.patience.limit =
                self.patience.limit.map(|limit| limit.saturating_sub(began.elapsed()));
            again.sizes.retain(|(index, _)| small.iter().all(|(other, _)| other != index));
            again.sizes.extend(small);
            match run(&again) {
                Ok(mut resized) => {
                    resized.trajectory.notes.push(format!(
                        "repeated with absolute tolerances of the size of states that stay below a \
                         thousandth of the scale: {first}"
                    ));
                    best = resized;
                }
                Err(_) => break,
            }
        }
        Ok(best.trajectory)
    }

    /// Returns the small states without a scale of their own, with their sizes: those whose
    /// tolerance, relative to their size, is above the rounding of the largest state.
    fn small(&self, run: &Sized) -> Vec<(usize, f64)> {
        const ROUNDING: f64 = 16.0 * f64::EPSILON;
        if self.atol.is_some() || !self.holds_small {
            return Vec::new();
        }
        let is_open = |index: usize| {
            let scale = self.simulator.state_scale(index);
            !self.simulator.is_mode(index) && scale.to_bits() == 1f64.to_bits()
        };
        let open = run.sizes.iter().zip(&run.scales).enumerate().filter(|(i, _)| is_open(*i));
        let largest = open.clone().map(|(_, (size, _))| *size).fold(0.0, f64::max);
        let known = ROUNDING * largest / run.trajectory.rtol;
        let small = open.filter(|(_, (size, scale))| **size > known && **size < SMALL * **scale);
        small.map(|(index, (size, _))| (index, *size)).collect()
    }

    /// Returns the largest absolute value of every state along a run, from its steps and its rows.
    pub(super) fn sizes(system: &System<'_>, rows: &[f64]) -> Vec<f64> {
        let mut sizes = system.sizes();
        for row in rows.chunks_exact(system.len().max(1)) {
            for (size, value) in sizes.iter_mut().zip(row) {
                *size = size.max(value.abs());
            }
        }
        sizes
    }
}
