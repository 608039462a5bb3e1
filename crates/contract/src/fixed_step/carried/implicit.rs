//! Columns along a Rosenbrock step.
//!
//! The derivative of the step is exact. With the deviations dJ and df_t of the Jacobian and of the
//! time derivative at its start, which are second derivatives of the rate,
//!
//! ```text
//! W dk1 = J dy + B dp + g h (dJ k1 + df_t)                         W = I - g h J
//! W dk2 = J' (dy + h dk1) + B' dp - 2 dk1 + g h (dJ k2 - df_t)
//! dy'   = dy + 3/2 h dk1 + 1/2 h dk2
//! ```
//!
//! where J' and B' are those at the second stage.

use super::{Carried, ExtendedKalmanFilter, FixedMethod, FixedSteps, Rest, add, ahead};
use crate::elimination::Elimination;
use crate::fixed_step::ROSENBROCK_GAMMA;
use crate::{Dual, DualFunction};

/// Workspace of Rosenbrock steps; empty for other methods.
pub(super) struct Implicit<'w> {
    factors: &'w mut [f64],
    /// k1 and k2.
    stages: [&'w mut [f64]; 2],
    /// `df_t + dJ k1` and `dJ k2 - df_t` of each column of a batch.
    bends: [&'w mut [f64]; 2],
    /// dk1.
    first: &'w mut [f64],
}

impl<'w> Implicit<'w> {
    /// Returns the numbers of factors and of states.
    fn sizes(filter: &ExtendedKalmanFilter<'_>) -> [usize; 2] {
        match filter.method {
            FixedMethod::Rosenbrock2(of) => [of.places, filter.simulator.shape().states()],
            FixedMethod::Heun | FixedMethod::RungeKutta4 => [0; 2],
        }
    }

    /// Returns the length of the workspace.
    pub(super) fn room(filter: &ExtendedKalmanFilter<'_>) -> usize {
        let [places, states] = Self::sizes(filter);
        places + (3 + 2 * Dual::DIRECTIONS) * states
    }

    pub(super) fn new(filter: &ExtendedKalmanFilter<'_>, rest: &mut Rest<'w, f64>) -> Self {
        let [places, states] = Self::sizes(filter);
        Self {
            factors: rest.take(places),
            stages: [rest.take(states), rest.take(states)],
            bends: [rest.take(Dual::DIRECTIONS * states), rest.take(Dual::DIRECTIONS * states)],
            first: rest.take(states),
        }
    }
}

impl Carried<'_> {
    /// Carries all columns along a part of a step that begins at a state.
    pub(super) fn implicit_part(
        &mut self,
        of: &FixedSteps<'_, f64>,
        elimination: &Elimination<'_>,
        (time, h): (f64, f64),
        start: &[f64],
    ) {
        self.implicit_stages(of, elimination, (time, h), start);
        for (first, count) in self.batches() {
            self.bend((time, start), of.parameters, (first, count));
            for direction in 0..count {
                self.carry_implicitly(elimination, h, (first + direction, direction));
            }
        }
    }

    /// Computes k1, k2, the factors, and the Jacobians at both stages.
    fn implicit_stages(
        &mut self,
        of: &FixedSteps<'_, f64>,
        elimination: &Elimination<'_>,
        (time, h): (f64, f64),
        start: &[f64],
    ) {
        let scale = ROSENBROCK_GAMMA * h;
        self.jacobians_at(of, 0, time);
        let nonzeros = of.simulator.rate_jacobian_pattern().entries.len();
        elimination.factor(scale, &self.by_state[..nonzeros], self.implicit.factors);
        of.simulator.time_derivative(time, start, of.parameters, self.sum);
        let [first, second] = &mut self.implicit.stages;
        of.rate(time, start, first);
        add(first, scale, self.sum);
        elimination.solve(self.implicit.factors, first);
        ahead(self.stage, start, h, first);
        of.rate(time + h, self.stage, second);
        for (second, (first, by_time)) in second.iter_mut().zip(first.iter().zip(&*self.sum)) {
            *second += -(2.0 * *first) - scale * *by_time;
        }
        elimination.solve(self.implicit.factors, second);
        self.jacobians_at(of, 1, time + h);
    }

    /// Computes the deviations of the Jacobian times the stages along a batch of columns.
    fn bend(&mut self, at: (f64, &[f64]), parameters: &[f64], (first, count): (usize, usize)) {
        let states = at.1.len();
        self.evaluate(DualFunction::TimeDerivative, at, parameters, (first, states));
        for direction in 0..count {
            for row in 0..states {
                let by_time = self.along(row, direction);
                self.implicit.bends[0][direction * states + row] = by_time;
                self.implicit.bends[1][direction * states + row] = -by_time;
            }
        }
        let pattern = self.filter.simulator.rate_jacobian_pattern().entries;
        self.evaluate(DualFunction::RateJacobian, at, parameters, (first, pattern.len()));
        for direction in 0..count {
            for (entry, &(row, column)) in pattern.iter().enumerate() {
                let value = self.along(entry, direction);
                let Implicit { stages, bends, .. } = &mut self.implicit;
                for (bend, stage) in bends.iter_mut().zip(stages.iter()) {
                    bend[direction * states + row as usize] += value * stage[column as usize];
                }
            }
        }
    }

    /// Carries a column, which has this place in its batch.
    fn carry_implicitly(
        &mut self,
        elimination: &Elimination<'_>,
        h: f64,
        (column, direction): (usize, usize),
    ) {
        let scale = ROSENBROCK_GAMMA * h;
        let states = self.stage.len();
        let first = column * self.filter.entries();
        let own = first..first + states;
        let of_batch = direction * states..(direction + 1) * states;
        self.stage.copy_from_slice(&self.columns[own.clone()]);
        self.slope_at(0, column);
        add(self.slope, scale, &self.implicit.bends[0][of_batch.clone()]);
        elimination.solve(self.implicit.factors, self.slope);
        self.implicit.first.copy_from_slice(self.slope);
        ahead(self.stage, &self.columns[own.clone()], h, self.slope);
        self.slope_at(1, column);
        add(self.slope, -2.0, self.implicit.first);
        add(self.slope, scale, &self.implicit.bends[1][of_batch]);
        elimination.solve(self.implicit.factors, self.slope);
        add(&mut self.columns[own.clone()], 1.5 * h, self.implicit.first);
        add(&mut self.columns[own], 0.5 * h, self.slope);
    }
}
