//! Columns of a square root of a covariance, carried along a step by its exact derivative.
//!
//! A column is a direction in which state and parameters deviate. Along a part of a step it
//! follows the derivative of the method: each stage k = f(t, y) has the deviation J y + B p with
//! the Jacobians at that stage. At a zero crossing the time of the event deviates too:
//!
//! ```text
//! dt = -(dg/dy dy)/g'      dy+ = R dy- + (R f- + R_t - f+) dt        (saltation)
//! ```
//!
//! with guard g, reset R and the rates f before and after.

mod implicit;

use super::follow::Follow;
use super::projection::Projection;
use super::{ExtendedKalmanFilter, FixedMethod, FixedSteps, Rest, add, ahead};
use crate::{Dual, DualFunction, Shape};
use implicit::Implicit;

/// Maximum number of stages of a method.
const STAGES: usize = 4;

/// Columns that follow a step.
pub(super) struct Carried<'w> {
    filter: &'w ExtendedKalmanFilter<'w>,
    /// Entries of x, column by column.
    columns: &'w mut [f64],
    /// Deviation of a disturbed parameter per unit of its intensity: h^-1/2.
    per_intensity: f64,
    /// Jacobians at the stages.
    by_state: &'w mut [f64],
    by_parameters: &'w mut [f64],
    stage: &'w mut [f64],
    slope: &'w mut [f64],
    sum: &'w mut [f64],
    /// Deviation of the time of the events at hand, for each column.
    timing: &'w mut [f64],
    guard_rates: &'w mut [f64],
    projection: Projection<'w, f64>,
    implicit: Implicit<'w>,
    duals: &'w mut [Dual],
}

/// Returns the length of the workspace.
pub(super) fn room(filter: &ExtendedKalmanFilter<'_>) -> usize {
    let simulator = filter.simulator;
    let states = simulator.shape().states();
    let by_state = simulator.rate_jacobian_pattern().entries.len();
    let by_parameters = simulator.parameter_jacobian_pattern().entries.len();
    STAGES * (by_state + by_parameters)
        + 3 * states
        + filter.columns()
        + simulator.events()
        + Projection::room(simulator)
        + Implicit::room(filter)
}

impl<'w> Carried<'w> {
    pub(super) fn new(
        filter: &'w ExtendedKalmanFilter<'w>,
        (columns, numbers, duals): (&'w mut [f64], &'w mut [f64], &'w mut [Dual]),
        per_intensity: f64,
    ) -> Self {
        let simulator = filter.simulator;
        let states = simulator.shape().states();
        let mut rest = Rest(numbers);
        let timing = rest.take(filter.columns());
        timing.fill(0.0);
        Self {
            filter,
            columns,
            per_intensity,
            by_state: rest.take(STAGES * simulator.rate_jacobian_pattern().entries.len()),
            by_parameters: rest.take(STAGES * simulator.parameter_jacobian_pattern().entries.len()),
            stage: rest.take(states),
            slope: rest.take(states),
            sum: rest.take(states),
            timing,
            guard_rates: rest.take(simulator.events()),
            projection: Projection::new(simulator, &mut rest),
            implicit: Implicit::new(filter, &mut rest),
            duals,
        }
    }

    /// Returns the number of columns that are carried.
    fn count(&self) -> usize {
        self.columns.len() / self.filter.entries()
    }

    /// Evaluates a function along the columns of a batch. [`Carried::along`] reads the results.
    pub(super) fn evaluate(
        &mut self,
        function: DualFunction,
        (time, state): (f64, &[f64]),
        parameters: &[f64],
        (first, results): (usize, usize),
    ) {
        let (filter, size) = (self.filter, self.filter.entries());
        let directions = first..self.count().min(first + Dual::DIRECTIONS);
        let (states, rest) = self.duals.split_at_mut(state.len());
        let (along, rest) = rest.split_at_mut(parameters.len());
        for (dual, &value) in states.iter_mut().zip(state).chain(along.iter_mut().zip(parameters)) {
            *dual = Dual::constant(value);
        }
        let mut time = Dual::constant(time);
        for (direction, column) in directions.enumerate() {
            let entries = &self.columns[column * size..(column + 1) * size];
            for (dual, entry) in states.iter_mut().zip(entries) {
                dual.slopes[direction] = *entry;
            }
            for (slot, &parameter) in filter.estimated.iter().enumerate() {
                along[parameter].slopes[direction] = entries[state.len() + slot];
            }
            if let Some((parameter, intensity)) = filter.disturbance(column) {
                along[parameter].slopes[direction] = intensity * self.per_intensity;
            }
            time.slopes[direction] = self.timing[column];
        }
        let derivatives = filter.simulator.derivatives().expect("functions on dual numbers");
        derivatives.on_duals(function, time, states, along, &mut rest[..results]);
    }

    /// Returns the derivative of a result of the last evaluation along a column of its batch.
    pub(super) fn along(&self, result: usize, direction: usize) -> f64 {
        let shape = self.filter.simulator.shape();
        self.duals[shape.states() + shape.parameters + result].slopes[direction]
    }

    /// Returns the first column and the number of columns of each batch.
    pub(super) fn batches(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let count = self.count();
        (0..count)
            .step_by(Dual::DIRECTIONS)
            .map(move |first| (first, (count - first).min(Dual::DIRECTIONS)))
    }

    /// Computes the Jacobians of a stage, and its rate if another follows.
    fn at_stage(&mut self, of: &FixedSteps<'_, f64>, stage: usize, time: f64, is_last: bool) {
        self.jacobians_at(of, stage, time);
        if !is_last {
            of.rate(time, self.stage, self.slope);
        }
    }

    /// Computes the Jacobians of a stage.
    fn jacobians_at(&mut self, of: &FixedSteps<'_, f64>, stage: usize, time: f64) {
        let simulator = of.simulator;
        let nonzeros = simulator.rate_jacobian_pattern().entries.len();
        let values = &mut self.by_state[stage * nonzeros..(stage + 1) * nonzeros];
        let (p, c) = (of.parameters, of.constants);
        simulator.prepared_rate_jacobian(time, self.stage, p, c, values);
        let nonzeros = simulator.parameter_jacobian_pattern().entries.len();
        if self.filter.reads_parameters() {
            let values = &mut self.by_parameters[stage * nonzeros..(stage + 1) * nonzeros];
            simulator.prepared_parameter_jacobian(time, self.stage, p, c, values);
        }
    }

    /// Computes the deviation of a stage's rate, `J stage + B p`, for a column.
    fn slope_at(&mut self, stage: usize, column: usize) {
        let (filter, size) = (self.filter, self.filter.entries());
        let pattern = filter.simulator.rate_jacobian_pattern().entries;
        let values = &self.by_state[stage * pattern.len()..];
        self.slope.fill(0.0);
        for (&(row, of), value) in pattern.iter().zip(values) {
            let slope = &mut self.slope[row as usize];
            *slope += value * self.stage[of as usize];
        }
        let pattern = filter.simulator.parameter_jacobian_pattern().entries;
        if !filter.reads_parameters() {
            return;
        }
        let values = &self.by_parameters[stage * pattern.len()..];
        let states = self.stage.len();
        let entries = &self.columns[column * size + states..(column + 1) * size];
        for (&(row, parameter), value) in pattern.iter().zip(values) {
            let slope = &mut self.slope[row as usize];
            if let Some(slot) = filter.slot(parameter as usize) {
                *slope += value * entries[slot];
            }
            if let Some((disturbed, intensity)) = filter.disturbance(column)
                && disturbed == parameter as usize
            {
                *slope += value * (intensity * self.per_intensity);
            }
        }
    }

    /// Carries a column along a step by the derivative of an explicit method.
    fn carry(&mut self, column: usize, h: f64, is_heun: bool) {
        let first = column * self.filter.entries();
        let own = first..first + self.stage.len();
        self.stage.copy_from_slice(&self.columns[own.clone()]);
        self.slope_at(0, column);
        self.sum.copy_from_slice(self.slope);
        let half = 0.5 * h;
        let last = if is_heun {
            ahead(self.stage, &self.columns[own.clone()], h, self.slope);
            self.slope_at(1, column);
            add(self.sum, 1.0, self.slope);
            half
        } else {
            for (stage, (length, weight)) in [(half, 2.0), (half, 2.0), (h, 1.0)].iter().enumerate()
            {
                ahead(self.stage, &self.columns[own.clone()], *length, self.slope);
                self.slope_at(stage + 1, column);
                add(self.sum, *weight, self.slope);
            }
            h / 6.0
        };
        add(&mut self.columns[own], last, self.sum);
    }

    /// Adds `share rate dt` to every column, with the deviations dt of the time of the events.
    fn shift(&mut self, share: f64) {
        let (size, states) = (self.filter.entries(), self.slope.len());
        for (column, dt) in self.columns.chunks_exact_mut(size).zip(self.timing.iter()) {
            add(&mut column[..states], share * dt, self.slope);
        }
    }

    fn project(&mut self, of: &FixedSteps<'_, f64>, time: f64, state: &[f64]) {
        let constraints = of.simulator.constraints();
        let Shape { coordinates, positions, .. } = of.simulator.shape();
        let size = self.filter.entries();
        for function in [DualFunction::ConstraintValues, DualFunction::ConstraintRates] {
            for (first, count) in self.batches() {
                self.evaluate(function, (time, state), of.parameters, (first, constraints));
                for direction in 0..count {
                    for constraint in 0..constraints {
                        self.projection.off[constraint] = self.along(constraint, direction);
                    }
                    self.projection.shortest(of, time, state);
                    let column = (first + direction) * size;
                    let column = &mut self.columns[column..column + size];
                    if function == DualFunction::ConstraintRates {
                        self.projection.shift(&mut column[positions..positions + coordinates]);
                    } else if positions == coordinates {
                        self.projection.shift(&mut column[..coordinates]);
                    } else {
                        // On the constraints the shift is zero, so quaternions turn by its
                        // deviation alone.
                        self.projection.find_turn(of, time, state);
                        self.projection.turn(&mut column[..positions]);
                    }
                }
            }
        }
    }
}

impl Follow<f64> for Carried<'_> {
    fn part(
        &mut self,
        of: &FixedSteps<'_, f64>,
        (time, h): (f64, f64),
        start: &[f64],
        end: &[f64],
    ) {
        let half = 0.5 * h;
        self.stage.copy_from_slice(start);
        match of.method {
            FixedMethod::Heun => {
                self.at_stage(of, 0, time, false);
                ahead(self.stage, start, h, self.slope);
                self.at_stage(of, 1, time + h, true);
            }
            FixedMethod::RungeKutta4 => {
                self.at_stage(of, 0, time, false);
                ahead(self.stage, start, half, self.slope);
                self.at_stage(of, 1, time + half, false);
                ahead(self.stage, start, half, self.slope);
                self.at_stage(of, 2, time + half, false);
                ahead(self.stage, start, h, self.slope);
                self.at_stage(of, 3, time + h, true);
            }
            FixedMethod::Rosenbrock2(elimination) => {
                self.implicit_part(of, &elimination, (time, h), start);
                return self.projected(of, time + h, end);
            }
        }
        for column in 0..self.count() {
            self.carry(column, h, of.method == FixedMethod::Heun);
        }
        self.projected(of, time + h, end);
    }

    fn before_events(
        &mut self,
        of: &FixedSteps<'_, f64>,
        first: Option<usize>,
        time: f64,
        state: &[f64],
    ) {
        self.timing.fill(0.0);
        let Some(event) = first else { return };
        of.simulator.guard_rates(time, state, of.parameters, self.guard_rates);
        let rate = self.guard_rates[event];
        if !(rate < 0.0 || 0.0 < rate) {
            return;
        }
        let events = of.simulator.events();
        for (first, count) in self.batches() {
            // The time does not deviate yet, so the guard changes by the columns alone.
            self.evaluate(DualFunction::Guards, (time, state), of.parameters, (first, events));
            for direction in 0..count {
                self.timing[first + direction] = -(self.along(event, direction) / rate);
            }
        }
        of.rate(time, state, self.slope);
        self.shift(1.0);
    }

    fn reset(&mut self, of: &FixedSteps<'_, f64>, event: usize, time: f64, before: &[f64]) {
        let sets = |event: usize| of.simulator.event(event).sets;
        let place: usize = (0..event).map(|event| sets(event).len()).sum();
        let resets = of.resets();
        let size = self.filter.entries();
        for (first, count) in self.batches() {
            self.evaluate(DualFunction::Resets, (time, before), of.parameters, (first, resets));
            for direction in 0..count {
                for (index, &entry) in sets(event).iter().enumerate() {
                    self.columns[(first + direction) * size + entry as usize] =
                        self.along(place + index, direction);
                }
            }
        }
    }

    fn projected(&mut self, of: &FixedSteps<'_, f64>, time: f64, state: &[f64]) {
        if of.simulator.constraints() > 0 {
            self.project(of, time, state);
        }
    }

    fn after_events(&mut self, of: &FixedSteps<'_, f64>, time: f64, state: &[f64]) {
        of.rate(time, state, self.slope);
        self.shift(-1.0);
        self.timing.fill(0.0);
    }
}
