//! Models run straight from their tapes.

mod field;
mod motion;

use std::cell::RefCell;

use machinist_contract::linear::LinearEquations;
use machinist_contract::taylor::{Bends, TaylorSeries};
use machinist_contract::{
    Constraint, Describe, Direction, Energy, Event, PowerBalance, Quantity, RunDefaults, Shape,
    Simulator, SparsityPattern,
};

use crate::evaluate::{Evaluator, Inputs};
use crate::functions::{FUNCTIONS, FunctionId};
use crate::hoist::Hoisted;
use crate::series::{SeriesEvaluator, recurrences};
use crate::{Model, StateKind, names};

/// A model as a simulator: the numbers of the emitted code, to the last bit, at the cost
/// of interpreting every operation.
///
/// Not for several threads at once: the tapes' values are kept between calls, so
/// that no call allocates.
#[derive(Debug)]
pub struct InterpretedSimulator {
    model: Model,
    /// One for each row of the table of functions.
    functions: [RefCell<Evaluator>; FUNCTIONS.len()],
    /// What parameters alone decide, then rate and Jacobian that read it.
    prepared: [RefCell<Evaluator>; 3],
    /// What goes before functions that read it, and the same by constants.
    motion: Option<RefCell<motion::Motion>>,
    /// Which functions do.
    reads_motion: [bool; FUNCTIONS.len()],
    series: RefCell<SeriesEvaluator>,
    bends: Bends,
    /// Excitation and switches.
    linear: Option<[RefCell<Evaluator>; 2]>,
    fields: Vec<field::InterpretedField>,
}

impl InterpretedSimulator {
    /// Prepares every tape of a model.
    #[must_use]
    pub fn new(model: Model) -> Self {
        let prepared = |tape| RefCell::new(Evaluator::new(tape));
        let series = recurrences(&model);
        let hoisted = Hoisted::new(&model);
        Self {
            functions: FUNCTIONS.each_ref().map(|row| prepared((row.tape)(&model))),
            prepared: [&hoisted.constants, &hoisted.rate, &hoisted.rate_jacobian].map(prepared),
            motion: motion::Motion::new(&model, &hoisted).map(RefCell::new),
            reads_motion: FUNCTIONS.each_ref().map(|row| model.reads_motion(row.id)),
            bends: series.bends(model.discontinuities.results.len()),
            series: RefCell::new(SeriesEvaluator::new(series)),
            linear: model
                .excitation
                .as_ref()
                .map(|excitation| [&excitation.values, &excitation.switches].map(prepared)),
            fields: model
                .fields
                .iter()
                .map(|field| field::InterpretedField::new(&model, field))
                .collect(),
            model,
        }
    }

    /// The model that is run.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// What tapes read, once the slices have the lengths the contract asks for.
    fn inputs<'a>(&'a self, time: f64, state: &'a [f64], parameters: &'a [f64]) -> Inputs<'a> {
        assert_eq!(state.len(), self.model.states.len(), "length of the state");
        Inputs { state, ..self.inputs_without_state(time, parameters) }
    }

    fn inputs_without_state<'a>(&'a self, time: f64, parameters: &'a [f64]) -> Inputs<'a> {
        let [own, handed] = [self.model.parameters.len(), self.model.handed.len()];
        assert_eq!(parameters.len(), own + handed, "number of parameters");
        let (parameters, handed) = parameters.split_at(own);
        Inputs {
            time,
            state: &[],
            parameters,
            handed,
            constants: &[],
            motion: &[],
            tables: &self.model.tables,
        }
    }

    fn run(&self, function: FunctionId, inputs: &Inputs<'_>, results: &mut [f64]) {
        let mut tape = self.functions[function as usize].borrow_mut();
        self.run_tape(function, &mut tape, inputs, results);
    }

    /// A tape of a function, behind that of the motion if it goes by it.
    fn run_tape(
        &self,
        function: FunctionId,
        tape: &mut Evaluator,
        inputs: &Inputs<'_>,
        results: &mut [f64],
    ) {
        match &self.motion {
            Some(motion) if self.reads_motion[function as usize] => {
                let solve = self.model.solve(function);
                motion.borrow_mut().run(tape, solve, inputs, results);
            }
            _ => tape.evaluate(inputs, results),
        }
    }
}

impl InterpretedSimulator {
    fn parameter_at(&self, index: usize) -> &crate::Parameter {
        let own = self.model.parameters.len();
        index
            .checked_sub(own)
            .map_or_else(|| &self.model.parameters[index], |k| &self.model.handed[k])
    }
}

impl Describe for InterpretedSimulator {
    fn name(&self) -> &str {
        &self.model.name
    }
    fn title(&self) -> &str {
        &self.model.title
    }
    fn shape(&self) -> Shape {
        let model = &self.model;
        Shape {
            coordinates: model.coordinates.len(),
            positions: model.positions(),
            first_order: model.first_order(),
            quadratures: model.quadratures,
            parameters: model.parameters.len() + model.handed.len(),
            outputs: model.wanted.len(),
            discontinuities: model.discontinuities.results.len(),
        }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        self.model.states[index].quantity.described()
    }
    fn state_kind(&self, index: usize) -> machinist_contract::StateKind {
        self.model.states[index].kind.described()
    }
    fn coordinate(&self, index: usize) -> Quantity<'_> {
        self.model.coordinates[index].position.described()
    }
    fn state_scale(&self, index: usize) -> f64 {
        self.model.states[index].scale
    }
    fn parameter(&self, index: usize) -> Quantity<'_> {
        self.parameter_at(index).quantity.described()
    }
    fn parameter_default(&self, index: usize) -> f64 {
        self.parameter_at(index).value
    }
    fn output(&self, index: usize) -> Quantity<'_> {
        self.model.wanted[index].described()
    }
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> {
        self.model.rate_jacobian.pattern.borrowed()
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        self.model.parameter_jacobian.pattern.borrowed()
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        self.model.mass_matrix.pattern.borrowed()
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        let run = &self.model.run;
        RunDefaults {
            from: run.from,
            until: run.until,
            points: run.points,
            rtol: run.rtol,
            method: &run.method,
        }
    }
    fn events(&self) -> usize {
        self.model.events.len()
    }
    fn event(&self, index: usize) -> Event<'_> {
        let event = &self.model.events[index];
        Event {
            name: &event.name.path,
            doc: &event.doc,
            direction: match event.direction {
                names::Direction::Rising => Direction::Rising,
                names::Direction::Falling => Direction::Falling,
                names::Direction::Both => Direction::Both,
            },
            when: &event.when,
            sets: &event.sets,
        }
    }
    fn is_mode(&self, index: usize) -> bool {
        self.model.states[index].kind == StateKind::Mode
    }
    fn constraints(&self) -> usize {
        self.model.constraints.len()
    }
    fn constraint(&self, index: usize) -> Constraint<'_> {
        let constraint = &self.model.constraints[index];
        Constraint {
            name: &constraint.name.path,
            unit: &constraint.unit,
            doc: &constraint.doc,
            is_of_positions: constraint.is_of_positions,
        }
    }
    fn constraint_matrix_pattern(&self) -> SparsityPattern<'_> {
        self.model.constraint_matrix.pattern.borrowed()
    }
    fn is_given(&self, index: usize) -> bool {
        self.model.states[index].is_given
    }
}

/// Methods that write the results of one function each.
macro_rules! functions {
    ($($name:ident = $id:ident),*) => {
        $(
            fn $name(&self, time: f64, state: &[f64], parameters: &[f64], values: &mut [f64]) {
                self.run(FunctionId::$id, &self.inputs(time, state, parameters), values);
            }
        )*
    };
}

impl Simulator<f64> for InterpretedSimulator {
    fn initial_state(&self, parameters: &[f64], state: &mut [f64]) {
        self.run(FunctionId::InitialState, &self.inputs_without_state(0.0, parameters), state);
    }
    fn discontinuities(&self, parameters: &[f64], times: &mut [f64]) {
        self.run(FunctionId::Discontinuities, &self.inputs_without_state(0.0, parameters), times);
    }
    functions!(
        rate = Rate,
        rate_jacobian = RateJacobian,
        parameter_jacobian = ParameterJacobian,
        time_derivative = TimeDerivative,
        mass_matrix = MassMatrix,
        forcing = Forcing,
        outputs = Outputs,
        guards = Guards,
        guard_rates = GuardRates,
        resets = Resets,
        constraint_values = ConstraintValues,
        constraint_rates = ConstraintRates,
        constraint_matrix = ConstraintMatrix
    );
    fn constants(&self) -> usize {
        self.prepared[0].borrow().results()
    }
    fn prepare(&self, parameters: &[f64], constants: &mut [f64]) {
        let inputs = self.inputs_without_state(0.0, parameters);
        self.prepared[0].borrow_mut().evaluate(&inputs, constants);
    }
    fn prepared_rate(
        &self,
        time: f64,
        state: &[f64],
        parameters: &[f64],
        constants: &[f64],
        rate: &mut [f64],
    ) {
        let inputs = Inputs { constants, ..self.inputs(time, state, parameters) };
        self.prepared[1].borrow_mut().evaluate(&inputs, rate);
    }
    fn prepared_rate_jacobian(
        &self,
        time: f64,
        state: &[f64],
        parameters: &[f64],
        constants: &[f64],
        values: &mut [f64],
    ) {
        let inputs = Inputs { constants, ..self.inputs(time, state, parameters) };
        let mut tape = self.prepared[2].borrow_mut();
        self.run_tape(FunctionId::RateJacobian, &mut tape, &inputs, values);
    }
    fn energy(&self, time: f64, state: &[f64], parameters: &[f64]) -> Energy<f64> {
        let mut values = [0.0; 3];
        self.run(FunctionId::Energy, &self.inputs(time, state, parameters), &mut values);
        let [kinetic, potential, stored] = values;
        Energy { kinetic, potential, stored }
    }
    fn power_balance(&self, time: f64, state: &[f64], parameters: &[f64]) -> PowerBalance<f64> {
        let mut values = [0.0; 3];
        self.run(FunctionId::PowerBalance, &self.inputs(time, state, parameters), &mut values);
        let [stored_rate, supplied, dissipated] = values;
        PowerBalance { stored_rate, supplied, dissipated }
    }
    fn taylor(&self) -> Option<&dyn TaylorSeries<f64>> {
        self.model.constraints.is_empty().then_some(self as &dyn TaylorSeries<f64>)
    }
    fn linear(&self) -> Option<&dyn LinearEquations<f64>> {
        self.linear.is_some().then_some(self)
    }
}

impl LinearEquations<f64> for InterpretedSimulator {
    fn excitation_terms(&self) -> &[(u32, u32)] {
        self.model.excitation.as_ref().map_or(&[], |excitation| &excitation.terms)
    }
    fn excitation(&self, time: f64, parameters: &[f64], values: &mut [f64]) {
        if let Some([excitation, _]) = &self.linear {
            excitation.borrow_mut().evaluate(&self.inputs_without_state(time, parameters), values);
        }
    }
    fn switches(&self) -> usize {
        self.model.excitation.as_ref().map_or(0, |excitation| excitation.switches.results.len())
    }
    fn switch_times(&self, parameters: &[f64], times: &mut [f64]) {
        if let Some([_, switches]) = &self.linear {
            switches.borrow_mut().evaluate(&self.inputs_without_state(0.0, parameters), times);
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
        let inputs = self.inputs(time, state, parameters);
        self.series.borrow_mut().evaluate(&inputs, coefficients);
    }
    fn bends(&self) -> Bends {
        self.bends
    }
}
