//! Sensitivities of motions that slide along the surfaces of relations.
//!
//! Along surfaces y' = f- + sum alpha_i D_i with D_i = f+_i - f-, so that
//!
//! ```text
//! S' = (J- + sum alpha_i (J+_i - J-)) S + (df/dp likewise) + sum D_i dalpha_i/dp
//! g_y S + g_p = 0
//! ```
//!
//! dalpha/dy and dalpha/dp are central differences. The first matrix has entries where dy'/dy has
//! none, so all entries are carried.
//!
//! Where a slide begins, the second equation determines S: S+ = S- - sum D_i nu_i. That is the jump
//! S- + (f- - f+) dt/dp of a motion that arrives from one side, and also holds for one that starts
//! on the surface.

use machinist_contract::{DualFunction, SparsityPattern};
use nalgebra::DMatrix;

use super::{By, Equations, Tangents};
use crate::error::StopCause;
use crate::method::{Stopped, System};

impl Tangents<'_> {
    /// Begins a stretch: along surfaces, S is projected onto them.
    ///
    /// # Errors
    /// [`StopCause::OffSurface`] if the projection fails.
    pub(crate) fn begin_stretch(
        &self,
        system: &System<'_>,
        time: f64,
        state: &[f64],
    ) -> Result<(), Stopped> {
        self.is_sliding.set(system.is_sliding());
        self.scratch.borrow_mut().jacobians.resize(self.equations().values(), 0.0);
        if !system.is_sliding() {
            return Ok(());
        }
        let start = self.inner.borrow().start.clone();
        let kinks = self.simulator.kinks();
        let state = &state[..self.states];
        let slopes = self.slopes(DualFunction::KinkGuards, kinks, time, state, &start);
        let (slides, count) = (system.slides(), self.by.len());
        let right = DMatrix::from_fn(slides.len(), count, |row, direction| {
            slopes[slides[row].relation][direction]
        });
        let Some((differences, shares)) = system.shares_along_surfaces(time, state, &right) else {
            return Err(Stopped { time, cause: StopCause::OffSurface { state: system.name(0) } });
        };
        let start = &mut self.inner.borrow_mut().start;
        for (difference, shares) in differences.iter().zip(shares.row_iter()) {
            for (row, difference) in start.chunks_exact_mut(count).zip(difference) {
                for (value, share) in row.iter_mut().zip(&shares) {
                    *value -= difference * share;
                }
            }
        }
        Ok(())
    }

    /// Evaluates all entries of J, then those of df/dp by the parameters among the directions, along
    /// the surfaces.
    pub(super) fn linearize_along_surfaces(
        &self,
        system: &System<'_>,
        time: f64,
        state: &[f64],
        values: &mut [f64],
    ) {
        let n = self.states;
        let state = &state[..n];
        let parameters = parameters_of(&self.by);
        let (jacobian, by_parameters) =
            (self.simulator.rate_jacobian_pattern(), self.simulator.parameter_jacobian_pattern());
        let nonzeros = jacobian.entries.len();
        let mut sparse = vec![0.0; nonzeros + by_parameters.entries.len()];
        values.fill(0.0);
        let (of_states, of_parameters) = values.split_at_mut(n * n);
        let (alphas, differences) = system.across_surfaces(time, state);
        system.for_each_side(&alphas, |share| {
            system.jacobians(time, state, &mut sparse);
            for ((row, column), value) in jacobian.entries.iter().zip(&sparse) {
                of_states[*row as usize * n + *column as usize] += share * value;
            }
            for ((row, column), value) in by_parameters.entries.iter().zip(&sparse[nonzeros..]) {
                let place = parameters.iter().position(|it| *it == *column as usize);
                if let Some(place) = place {
                    of_parameters[*row as usize * parameters.len() + place] += share * value;
                }
            }
        });
        let add = |into: &mut [f64], width: usize, column: usize, slopes: &[f64]| {
            for (difference, slope) in differences.iter().zip(slopes) {
                for (row, difference) in difference.iter().enumerate() {
                    into[row * width + column] += difference * slope;
                }
            }
        };
        for column in 0..n {
            add(of_states, n, column, &system.slopes_of_alphas(time, state, column));
        }
        for (place, parameter) in parameters.iter().enumerate() {
            let slopes = system.slopes_of_alphas(time, state, n + parameter);
            add(of_parameters, parameters.len(), place, &slopes);
        }
    }
}

/// Returns the parameters among the directions, each once.
fn parameters_of(by: &[By]) -> Vec<usize> {
    let mut parameters: Vec<usize> = by
        .iter()
        .filter_map(|by| if let By::Parameter(index) = by { Some(*index) } else { None })
        .collect();
    parameters.sort_unstable();
    parameters.dedup();
    parameters
}

/// Returns the variational equations with all entries.
pub(super) fn full_equations(states: usize, by: &[By]) -> Equations {
    let all = |columns: usize| -> Vec<(u32, u32)> {
        let rows = 0..states as u32;
        rows.flat_map(|row| (0..columns as u32).map(move |column| (row, column))).collect()
    };
    let parameters = parameters_of(by);
    let places: Vec<Option<usize>> = by
        .iter()
        .map(|by| match by {
            By::Parameter(index) => parameters.iter().position(|it| it == index),
            By::Initial(_) => None,
        })
        .collect();
    let (of_states, of_parameters) = (all(states), all(parameters.len()));
    let pattern = |columns, entries| SparsityPattern { rows: states, columns, entries };
    Equations::new(pattern(states, &of_states), pattern(parameters.len(), &of_parameters), &places)
}
