//! Scenes run straight from their tapes, without compiling what they emit.

mod field;

use std::cell::RefCell;

use machinist_codegen::evaluate::Evaluator;
use machinist_codegen::program::{Program, SparsityPattern as Pattern};
use machinist_codegen::state::Motion;
use machinist_codegen::system;
use machinist_codegen::taylor::{SeriesEvaluator, recurrences};
use machinist_scenes::linear::LinearEquations;
use machinist_scenes::taylor::{Bends, TaylorSeries};
use machinist_scenes::{
    Constraint, Describe, Direction, Energy, Event, PowerBalance, Quantity, RunDefaults, Shape,
    Simulator, SparsityPattern, StateKind,
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
    guards: RefCell<Evaluator>,
    guard_rates: RefCell<Evaluator>,
    resets: RefCell<Evaluator>,
    constraint_values: RefCell<Evaluator>,
    constraint_rates: RefCell<Evaluator>,
    constraint_matrix: RefCell<Evaluator>,
    is_given: Vec<bool>,
    series: RefCell<SeriesEvaluator>,
    bends: Bends,
    linear: Option<[RefCell<Evaluator>; 2]>,
    fields: Vec<field::InterpretedField>,
}

impl InterpretedSimulator {
    /// Prepares every tape of a program.
    #[must_use]
    pub fn new(program: Program) -> Self {
        let prepared = |tape| RefCell::new(Evaluator::new(tape));
        let series = recurrences(&program);
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
            guards: prepared(&program.guards),
            guard_rates: prepared(&program.guard_rates),
            resets: prepared(&program.resets),
            constraint_values: prepared(&program.constraint_values),
            constraint_rates: prepared(&program.constraint_rates),
            constraint_matrix: prepared(&program.constraint_matrix.tape),
            is_given: program.is_given(),
            bends: series.bends(program.system.discontinuities.len()),
            series: RefCell::new(SeriesEvaluator::new(series)),
            linear: program
                .excitation
                .as_ref()
                .map(|excitation| [&excitation.values, &excitation.switches].map(prepared)),
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

    /// Runs a tape that reads no state.
    fn run_without_state(
        &self,
        evaluator: &RefCell<Evaluator>,
        time: f64,
        parameters: &[f64],
        results: &mut [f64],
    ) {
        let system = &self.program.system;
        assert_eq!(parameters.len(), system.parameters.len(), "number of parameters");
        evaluator.borrow_mut().evaluate(time, &[], parameters, &system.tables, results);
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
    fn events(&self) -> usize {
        self.program.events.len()
    }
    fn event(&self, index: usize) -> Event<'_> {
        let event = &self.program.events[index];
        Event {
            name: &event.name.path,
            doc: &event.doc,
            direction: match event.direction {
                system::Direction::Rising => Direction::Rising,
                system::Direction::Falling => Direction::Falling,
                system::Direction::Both => Direction::Both,
            },
            when: &event.when,
            sets: &event.sets,
        }
    }
    fn is_mode(&self, index: usize) -> bool {
        match self.program.layout.states[index].motion {
            Motion::FirstOrder(id) => self.program.system.first_order[id.0 as usize].is_mode,
            _ => false,
        }
    }
    fn constraints(&self) -> usize {
        self.program.constraints.len()
    }
    fn constraint(&self, index: usize) -> Constraint<'_> {
        let constraint = &self.program.constraints[index];
        Constraint {
            name: &constraint.name.path,
            unit: &constraint.unit,
            doc: &constraint.doc,
            is_of_positions: constraint.is_of_positions,
        }
    }
    fn constraint_matrix_pattern(&self) -> SparsityPattern<'_> {
        borrowed(&self.program.constraint_matrix.pattern)
    }
    fn is_given(&self, index: usize) -> bool {
        self.is_given[index]
    }
}

impl Simulator<f64> for InterpretedSimulator {
    fn initial_state(&self, parameters: &[f64], state: &mut [f64]) {
        self.run_without_state(&self.initial_state, 0.0, parameters, state);
    }
    fn discontinuities(&self, parameters: &[f64], times: &mut [f64]) {
        self.run_without_state(&self.discontinuities, 0.0, parameters, times);
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
    fn guards(&self, time: f64, state: &[f64], parameters: &[f64], guards: &mut [f64]) {
        self.run(&self.guards, time, state, parameters, guards);
    }
    fn guard_rates(&self, time: f64, state: &[f64], parameters: &[f64], rates: &mut [f64]) {
        self.run(&self.guard_rates, time, state, parameters, rates);
    }
    fn resets(&self, time: f64, state: &[f64], parameters: &[f64], values: &mut [f64]) {
        self.run(&self.resets, time, state, parameters, values);
    }
    fn constraint_values(&self, time: f64, state: &[f64], parameters: &[f64], values: &mut [f64]) {
        self.run(&self.constraint_values, time, state, parameters, values);
    }
    fn constraint_rates(&self, time: f64, state: &[f64], parameters: &[f64], rates: &mut [f64]) {
        self.run(&self.constraint_rates, time, state, parameters, rates);
    }
    fn constraint_matrix(&self, time: f64, state: &[f64], parameters: &[f64], values: &mut [f64]) {
        self.run(&self.constraint_matrix, time, state, parameters, values);
    }
    fn taylor(&self) -> Option<&dyn TaylorSeries<f64>> {
        self.program.constraints.is_empty().then_some(self as &dyn TaylorSeries<f64>)
    }
    fn linear(&self) -> Option<&dyn LinearEquations<f64>> {
        self.linear.is_some().then_some(self)
    }
}

impl LinearEquations<f64> for InterpretedSimulator {
    fn excitation_terms(&self) -> &[(u32, u32)] {
        self.program.excitation.as_ref().map_or(&[], |excitation| &excitation.terms)
    }
    fn excitation(&self, time: f64, parameters: &[f64], values: &mut [f64]) {
        if let Some([excitation, _]) = &self.linear {
            self.run_without_state(excitation, time, parameters, values);
        }
    }
    fn switches(&self) -> usize {
        self.program.excitation.as_ref().map_or(0, |excitation| excitation.switches.results.len())
    }
    fn switch_times(&self, parameters: &[f64], times: &mut [f64]) {
        if let Some([_, switches]) = &self.linear {
            self.run_without_state(switches, 0.0, parameters, times);
        }
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
    fn bends(&self) -> Bends {
        self.bends
    }
}

fn described(quantity: &system::Quantity) -> Quantity<'_> {
    Quantity { name: &quantity.name.path, unit: &quantity.unit, doc: &quantity.doc }
}

fn borrowed(pattern: &Pattern) -> SparsityPattern<'_> {
    SparsityPattern { rows: pattern.rows, columns: pattern.columns, entries: &pattern.entries }
}
