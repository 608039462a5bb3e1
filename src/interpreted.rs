//! Scenes run straight from their tapes, without compiling what they emit.

mod field;

use std::cell::RefCell;

use machinist_codegen::evaluate::Evaluator;
use machinist_codegen::program::{Program, SparsityPattern as Pattern};
use machinist_codegen::state::Motion;
use machinist_codegen::system;
use machinist_codegen::taylor::{SeriesEvaluator, recurrences};
use machinist_scenes::taylor::TaylorSeries;
use machinist_scenes::{
    Describe, Energy, PowerBalance, Quantity, RunDefaults, Shape, Simulator, SparsityPattern,
    StateKind,
};

/// A program as a simulator: the numbers of the emitted code, to the last bit, at
/// the cost of interpreting every operation.
///
/// Not for several threads at once: the tapes' values are kept between calls, so
/// that no call allocates.
#[derive(Debug)]
pub struct InterpretedSimulator {
    program: Program,
    initial_state: RefCell<Evaluator>,
    discontinuities: RefCell<Evaluator>,
    rate: RefCell<Evaluator>,
    rate_jacobian: RefCell<Evaluator>,
    parameter_jacobian: RefCell<Evaluator>,
    time_derivative: RefCell<Evaluator>,
    mass_matrix: RefCell<Evaluator>,
    forcing: RefCell<Evaluator>,
    outputs: RefCell<Evaluator>,
    energy: RefCell<Evaluator>,
    power_balance: RefCell<Evaluator>,
    series: RefCell<SeriesEvaluator>,
    fields: Vec<field::InterpretedField>,
}

impl InterpretedSimulator {
    /// Prepares every tape of a program.
    #[must_use]
    pub fn new(program: Program) -> Self {
        let prepared = |tape| RefCell::new(Evaluator::new(tape));
        Self {
            initial_state: prepared(&program.initial_state),
            discontinuities: prepared(&program.discontinuities),
            rate: prepared(&program.rate),
            rate_jacobian: prepared(&program.rate_jacobian.tape),
            parameter_jacobian: prepared(&program.parameter_jacobian.tape),
            time_derivative: prepared(&program.time_derivative),
            mass_matrix: prepared(&program.mass_matrix.tape),
            forcing: prepared(&program.forcing),
            outputs: prepared(&program.outputs),
            energy: prepared(&program.energy),
            power_balance: prepared(&program.power_balance),
            series: RefCell::new(SeriesEvaluator::new(recurrences(&program))),
            fields: program.fields.iter().map(field::InterpretedField::new).collect(),
            program,
        }
    }

    /// The program that is run.
    #[must_use]
    pub fn program(&self) -> &Program {
        &self.program
    }

    /// Runs one tape, once the slices have the lengths the contract asks for.
    fn run(
        &self,
        evaluator: &RefCell<Evaluator>,
        time: f64,
        state: &[f64],
        parameters: &[f64],
        results: &mut [f64],
    ) {
        let system = &self.program.system;
        assert_eq!(state.len(), self.program.layout.len(), "length of the state");
        assert_eq!(parameters.len(), system.parameters.len(), "number of parameters");
        evaluator.borrow_mut().evaluate(time, state, parameters, &system.tables, results);
    }

    /// Runs a tape that reads parameters only.
    fn run_of_parameters(
        &self,
        evaluator: &RefCell<Evaluator>,
        parameters: &[f64],
        results: &mut [f64],
    ) {
        let system = &self.program.system;
        assert_eq!(parameters.len(), system.parameters.len(), "number of parameters");
        evaluator.borrow_mut().evaluate(0.0, &[], parameters, &system.tables, results);
    }
}

impl Describe for InterpretedSimulator {
    fn name(&self) -> &str {
        &self.program.system.name
    }
    fn title(&self) -> &str {
        &self.program.system.title
    }
    fn shape(&self) -> Shape {
        let system = &self.program.system;
        Shape {
            coordinates: system.coordinates.len(),
            positions: self.program.layout.positions(),
            first_order: system.first_order.len(),
            quadratures: self.program.layout.quadratures,
            parameters: system.parameters.len(),
            outputs: system.outputs.len(),
            discontinuities: system.discontinuities.len(),
        }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        described(&self.program.layout.states[index].quantity)
    }
    fn state_kind(&self, index: usize) -> StateKind {
        match self.program.layout.states[index].motion {
            Motion::Position { .. } => StateKind::Position,
            Motion::Velocity(_) => StateKind::Velocity,
            Motion::FirstOrder(_) => StateKind::FirstOrder,
        }
    }
    fn coordinate(&self, index: usize) -> Quantity<'_> {
        described(&self.program.system.coordinates[index].position)
    }
    fn state_scale(&self, index: usize) -> f64 {
        self.program.layout.states[index].scale
    }
    fn parameter(&self, index: usize) -> Quantity<'_> {
        described(&self.program.system.parameters[index].quantity)
    }
    fn parameter_default(&self, index: usize) -> f64 {
        self.program.system.parameters[index].value
    }
    fn output(&self, index: usize) -> Quantity<'_> {
        described(&self.program.system.outputs[index].quantity)
    }
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> {
        borrowed(&self.program.rate_jacobian.pattern)
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        borrowed(&self.program.parameter_jacobian.pattern)
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        borrowed(&self.program.mass_matrix.pattern)
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        let run = &self.program.system.run;
        RunDefaults {
            from: run.from,
            until: run.until,
            points: run.points,
            rtol: run.rtol,
            method: &run.method,
        }
    }
}

impl Simulator<f64> for InterpretedSimulator {
    fn initial_state(&self, parameters: &[f64], state: &mut [f64]) {
        self.run_of_parameters(&self.initial_state, parameters, state);
    }
    fn discontinuities(&self, parameters: &[f64], times: &mut [f64]) {
        self.run_of_parameters(&self.discontinuities, parameters, times);
    }
    fn rate(&self, time: f64, state: &[f64], parameters: &[f64], rate: &mut [f64]) {
        self.run(&self.rate, time, state, parameters, rate);
    }
    fn rate_jacobian(&self, time: f64, state: &[f64], parameters: &[f64], values: &mut [f64]) {
        self.run(&self.rate_jacobian, time, state, parameters, values);
    }
    fn parameter_jacobian(&self, time: f64, state: &[f64], parameters: &[f64], values: &mut [f64]) {
        self.run(&self.parameter_jacobian, time, state, parameters, values);
    }
    fn time_derivative(
        &self,
        time: f64,
        state: &[f64],
        parameters: &[f64],
        derivative: &mut [f64],
    ) {
        self.run(&self.time_derivative, time, state, parameters, derivative);
    }
    fn mass_matrix(&self, time: f64, state: &[f64], parameters: &[f64], values: &mut [f64]) {
        self.run(&self.mass_matrix, time, state, parameters, values);
    }
    fn forcing(&self, time: f64, state: &[f64], parameters: &[f64], forcing: &mut [f64]) {
        self.run(&self.forcing, time, state, parameters, forcing);
    }
    fn outputs(&self, time: f64, state: &[f64], parameters: &[f64], outputs: &mut [f64]) {
        self.run(&self.outputs, time, state, parameters, outputs);
    }
    fn energy(&self, time: f64, state: &[f64], parameters: &[f64]) -> Energy<f64> {
        let mut values = [0.0; 3];
        self.run(&self.energy, time, state, parameters, &mut values);
        let [kinetic, potential, stored] = values;
        Energy { kinetic, potential, stored }
    }
    fn power_balance(&self, time: f64, state: &[f64], parameters: &[f64]) -> PowerBalance<f64> {
        let mut values = [0.0; 3];
        self.run(&self.power_balance, time, state, parameters, &mut values);
        let [stored_rate, supplied, dissipated] = values;
        PowerBalance { stored_rate, supplied, dissipated }
    }
    fn taylor(&self) -> Option<&dyn TaylorSeries<f64>> {
        Some(self)
    }
}

impl TaylorSeries<f64> for InterpretedSimulator {
    fn series_workspace(&self, _order: usize) -> usize {
        0
    }
    fn series(
        &self,
        time: f64,
        state: &[f64],
        parameters: &[f64],
        coefficients: &mut [f64],
        _workspace: &mut [f64],
    ) {
        let system = &self.program.system;
        assert_eq!(state.len(), self.program.layout.len(), "length of the state");
        assert_eq!(parameters.len(), system.parameters.len(), "number of parameters");
        let mut series = self.series.borrow_mut();
        series.evaluate(time, state, parameters, &system.tables, coefficients);
    }
}

fn described(quantity: &system::Quantity) -> Quantity<'_> {
    Quantity { name: &quantity.name.path, unit: &quantity.unit, doc: &quantity.doc }
}

fn borrowed(pattern: &Pattern) -> SparsityPattern<'_> {
    SparsityPattern { rows: pattern.rows, columns: pattern.columns, entries: &pattern.entries }
}
