//! Operations of an extended Kalman filter.

use machinist_contract::Dual;
use machinist_contract::fixed_step::StepMethod;
use machinist_model::StateKind;
use machinist_model::functions::FunctionId;

use super::duals::on_duals;
use super::{Step, executed};
use crate::emit::c99::EstimatorOptions;
use crate::emit::c99::estimator::{CarriedFunction, Tangents};

/// Way in which a filter differentiates functions along its columns.
#[derive(Clone, Copy)]
pub(super) enum Derivatives<'a> {
    /// By tapes, column by column, in C.
    Tapes(&'a Tangents),
    /// On dual numbers, several columns at a time, in Rust.
    Duals,
}

/// Operations of the functions that carry columns of the root of a covariance.
pub(super) struct Filter<'a> {
    step: &'a Step<'a>,
    options: &'a EstimatorOptions,
    derivatives: Derivatives<'a>,
    /// Number of columns that are carried.
    columns: usize,
    /// Operations of the deviations of parameters, over all columns.
    directions: usize,
    entries: usize,
}

impl<'a> Filter<'a> {
    /// Returns the operations for the columns of a step, or for those of an update.
    pub(super) fn new(
        step: &'a Step<'a>,
        options: &'a EstimatorOptions,
        derivatives: Derivatives<'a>,
        of_a_step: bool,
    ) -> Self {
        let entries = step.states + options.estimated.len();
        let added = options.diffusing.len() + options.disturbed.len();
        Self {
            step,
            options,
            derivatives,
            columns: if of_a_step { entries + added } else { entries },
            directions: if of_a_step { options.disturbed.len() } else { 0 },
            entries,
        }
    }

    /// Returns the operations of a function's derivative along all columns.
    fn along(&self, function: CarriedFunction) -> usize {
        let step = self.step;
        let own = match self.derivatives {
            Derivatives::Tapes(tangents) => {
                let tape = tangents.tape(function);
                self.columns * tape.map_or(0, |tape| executed(tape, step.real))
            }
            Derivatives::Duals => {
                self.columns.div_ceil(Dual::DIRECTIONS) * on_duals(step.model, function)
            }
        };
        self.directions + own
    }

    /// Returns the operations of the deviation of a rate, except those of `directions`.
    fn slope(&self) -> usize {
        let model = self.step.model;
        let along = |parameter: &u32| {
            let parameter = *parameter as usize;
            let disturbed = self.options.disturbed.iter().any(|(other, _)| *other == parameter);
            disturbed || self.options.estimated.contains(&parameter)
        };
        let of_parameters = model.parameter_jacobian.pattern.entries.iter();
        let of_parameters = of_parameters.filter(|(_, parameter)| along(parameter)).count();
        2 * (model.rate_jacobian.pattern.entries.len() + of_parameters)
    }

    /// Returns the operations that carry the columns along a part of a step.
    pub(super) fn part(&self) -> usize {
        let (step, states) = (self.step, self.step.states);
        let model = step.model;
        let count = self.options.estimated.len() + self.options.disturbed.len();
        let reads_parameters = count > 0 && !model.parameter_jacobian.pattern.entries.is_empty();
        let by_parameters = usize::from(reads_parameters);
        let of_parameters = match self.derivatives {
            // Emitted Rust computes it with the other Jacobian.
            Derivatives::Duals if model.gives_jacobians_at_once() => {
                executed(&step.hoisted.jacobians, step.real)
            }
            _ => step.of(FunctionId::ParameterJacobian),
        };
        let jacobians = step.of(FunctionId::RateJacobian) + by_parameters * of_parameters;
        let rate = step.of(FunctionId::Rate);
        let own = match step.method {
            StepMethod::RungeKutta4 => {
                let stages = 4 * jacobians + 3 * rate + 6 * states + 6 + 3 * by_parameters;
                stages + self.columns * (4 * self.slope() + 14 * states + 1)
            }
            StepMethod::Heun => {
                let stages = 2 * jacobians + rate + 2 * states + 2 + by_parameters;
                stages + self.columns * (2 * self.slope() + 6 * states)
            }
            StepMethod::Rosenbrock2 => self.implicit_part(jacobians, by_parameters),
        };
        own + self.directions + usize::from(step.is_constrained) + self.projected()
    }

    fn implicit_part(&self, jacobians: usize, by_parameters: usize) -> usize {
        let (step, states) = (self.step, self.step.states);
        let [factor, solve] = step.elimination();
        let nonzeros = step.model.rate_jacobian.pattern.entries.len();
        // The stages again, without the end of the step.
        let stages = 2 * jacobians
            + 2 * step.of(FunctionId::Rate)
            + step.of(FunctionId::TimeDerivative)
            + factor
            + 2 * solve
            + (4 * states + 4 * states + 2 * states)
            + 3
            + by_parameters;
        let bends =
            self.along(CarriedFunction::RateJacobian) + self.along(CarriedFunction::TimeDerivative);
        let of_column = 2 * self.slope() + 4 * nonzeros + 2 * states + 2 * solve + 14 * states + 2;
        stages + bends + self.columns * of_column
    }

    /// Returns the operations of the projection of the columns; zero without constraints.
    pub(super) fn projected(&self) -> usize {
        let step = self.step;
        if !step.is_constrained {
            return 0;
        }
        let functions = [CarriedFunction::ConstraintValues, CarriedFunction::ConstraintRates]
            .map(|of| self.along(of));
        let shifted = step.shift_positions() + step.model.coordinates.len();
        functions.iter().sum::<usize>() + self.columns * (2 * step.shortest() + shifted)
    }

    /// Returns the operations that shift the columns by the deviation of a time.
    fn shift(&self) -> usize {
        self.step.of(FunctionId::Rate) + self.columns * (1 + 2 * self.step.states)
    }

    /// Returns the operations before events.
    pub(super) fn before(&self) -> usize {
        self.step.of(FunctionId::GuardRates)
            + 2
            + self.along(CarriedFunction::Guards)
            + 2 * self.columns
            + self.shift()
    }

    /// Returns the operations of an event on the columns.
    pub(super) fn reset(&self) -> usize {
        self.along(CarriedFunction::Resets)
    }

    /// Returns the operations after events.
    pub(super) fn after(&self) -> usize {
        self.shift()
    }

    /// Returns the operations of a prediction besides its step: intensities, and reflections.
    pub(super) fn around_a_step(&self) -> usize {
        let of_row = |row: usize| {
            let width = self.columns - row;
            let below = self.entries - 1 - row;
            2 * width + 1 + 3 * width + 3 + 1 + 3 + below * (4 * width + 1) + 1
        };
        2 + self.options.diffusing.len() + (0..self.entries).map(of_row).sum::<usize>()
    }

    /// Returns the operations of a correction.
    pub(super) fn correct(&self) -> usize {
        let (step, entries) = (self.step, self.entries);
        let measured = self.options.measured.len();
        let of_row = |row: usize| {
            let later = measured - 1 - row;
            let own = 2 + 2 * entries + 1 + 5 + 2;
            own + later * (4 * entries + 3) + entries * (4 * entries + 3)
        };
        let is_mode = |state: &&machinist_model::State| state.kind == StateKind::Mode;
        let modes = step.model.states.iter().filter(is_mode).count();
        let prepare = match self.options.estimated.len() {
            0 => 0,
            _ => executed(&step.hoisted.constants, step.real),
        };
        let restored = step.project()
            + self.projected()
            + if step.events > 0 { step.settle(Some(self)) + step.look() } else { 0 };
        step.of(FunctionId::Outputs)
            + measured
            + self.along(CarriedFunction::Measured)
            + (0..measured).map(of_row).sum::<usize>()
            + entries
            - modes
            + prepare
            + restored
    }
}
