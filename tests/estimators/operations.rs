//! Operations of filters in Rust: those stated compared with those of the functions that filters
//! call, tallied call by call on the tapes. The operations between the calls are those of filters in
//! C, which give the same digits and whose operations are counted one by one (`c99::counted`).

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::ops::{Add, Div, Mul, Neg, Sub};

use machinist::estimator::{Estimator, EstimatorIndices};
use machinist_codegen::emit::c99::{FilterCost, rust_filter_cost};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::fixed_step::StepMethod;
use machinist_contract::{
    Constraint, Derivatives, Describe, Dual, DualFunction, Energy, Event, PowerBalance, Quantity,
    Real, Relation, RunDefaults, Shape, Simulator, SparsityPattern, StateKind,
};
use machinist_model::evaluate::{Evaluator, Inputs};
use machinist_model::functions::FunctionId;
use machinist_model::hoist::Hoisted;
use machinist_model::{Elimination, Model, ModelSimulator, Tape};

use crate::c99::filter_of;
use crate::own_scene::whole_model_of_specs;

thread_local! {
    static TALLY: Cell<usize> = const { Cell::new(0) };
}

fn tally(operations: usize) {
    TALLY.set(TALLY.get() + operations);
}

/// A number that tallies its operations: one each, or with `ON_DUALS` those of dual numbers.
#[derive(Debug, Clone, Copy)]
struct Tallied<const ON_DUALS: bool>;

impl<const ON_DUALS: bool> Tallied<ON_DUALS> {
    /// Tallies an operation on `own` numbers, and as many `along` each direction.
    fn of(own: usize, along: usize) -> Self {
        tally(if ON_DUALS { own + along * Dual::DIRECTIONS } else { 1 });
        Self
    }

    /// Tallies a function and its derivative, then for each direction a product and the comparison
    /// that keeps what does not move at zero.
    fn call(own: usize) -> Self {
        Self::of(own, 2)
    }
}

macro_rules! operators {
    ($($trait:ident $name:ident $own:literal $along:literal)*) => {$(
        impl<const ON_DUALS: bool> $trait for Tallied<ON_DUALS> {
            type Output = Self;
            fn $name(self, _: Self) -> Self {
                Self::of($own, $along)
            }
        }
    )*};
}

operators! { Add add 1 1  Sub sub 1 1  Mul mul 1 3  Div div 1 3 }

impl<const ON_DUALS: bool> Neg for Tallied<ON_DUALS> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::of(1, 1)
    }
}

macro_rules! functions {
    ($($name:ident $own:literal)*) => {$(
        fn $name(self) -> Self {
            Self::call($own)
        }
    )*};
}

impl<const ON_DUALS: bool> Real for Tallied<ON_DUALS> {
    fn literal(_: f64) -> Self {
        Self
    }
    fn select_less(_: Self, _: Self, _: Self, _: Self) -> Self {
        Self::of(1, 0)
    }
    fn powi(self, _: i32) -> Self {
        Self::call(3)
    }
    fn powf(self, _: Self) -> Self {
        Self::of(6, 5)
    }
    fn abs(self) -> Self {
        Self::of(2, 1)
    }
    fn floor(self) -> Self {
        Self::of(1, 0)
    }
    fn sin(self) -> Self {
        // With the cosine, and its slope.
        Self::of(3, 4)
    }
    fn cos(self) -> Self {
        Self::of(3, 4)
    }
    fn interpolate(_: &machinist_contract::CubicTable<'_>, _: u32, _: Self) -> Self {
        Self::call(2)
    }
    functions! {
        sqrt 2 exp 1 ln 2 tan 3 asin 6 acos 6 atan 4 sinh 2 cosh 2 tanh 4
    }
}

/// Returns the operations of a tape.
fn operations<const ON_DUALS: bool>(model: &Model, tape: &Tape) -> usize {
    let numbers = |count: usize| vec![Tallied::<ON_DUALS>; count];
    let [state, parameters, constants, motion] =
        [model.states.len(), 1000, 1000, 1000].map(numbers);
    let inputs = Inputs {
        time: Tallied,
        state: &state,
        parameters: &parameters,
        handed: &[],
        constants: &constants,
        motion: &motion,
        tables: &model.tables,
    };
    let evaluator = Evaluator::new(tape);
    let before = TALLY.take();
    evaluator.evaluate_in(
        &mut numbers(evaluator.room()),
        &inputs,
        &mut numbers(tape.results.len()),
    );
    TALLY.replace(before)
}

/// A machine that tallies the operations of its functions.
struct Machine<'a> {
    model: &'a Model,
    hoisted: Hoisted,
    simulator: ModelSimulator,
    /// Operations of tapes, by their addresses.
    known: RefCell<BTreeMap<(*const Tape, bool), usize>>,
}

impl Machine<'_> {
    fn inner(&self) -> &dyn Simulator<f64> {
        self.simulator.single()
    }

    fn tape<const ON_DUALS: bool>(&self, tape: &Tape) {
        let key = (std::ptr::from_ref(tape), ON_DUALS);
        let count = self.known.borrow().get(&key).copied();
        let count = count.unwrap_or_else(|| operations::<ON_DUALS>(self.model, tape));
        self.known.borrow_mut().insert(key, count);
        tally(count);
    }

    fn called<const ON_DUALS: bool>(&self, id: FunctionId, own: &Tape, motion: &Tape) {
        self.tape::<ON_DUALS>(own);
        if self.model.reads_motion(id) {
            self.tape::<ON_DUALS>(motion);
        }
        assert!(self.model.solve(id).is_none(), "{}: a solve is not tallied", self.model.name);
    }

    /// Tallies a function without constants.
    fn plain<const ON_DUALS: bool>(&self, id: FunctionId) {
        let row = self.model.functions().find(|row| row.id == id).expect("a function");
        let none = Tape::default();
        let motion = self.model.motion.as_ref().map_or(&none, |motion| &motion.tape);
        self.called::<ON_DUALS>(id, (row.tape)(self.model), motion);
    }

    fn prepared(&self, id: FunctionId) {
        let of = &self.hoisted;
        let together = id == FunctionId::ParameterJacobian && self.model.gives_jacobians_at_once();
        let tape = if together { &of.jacobians } else { of.tape(self.model, id) };
        self.called::<false>(id, tape, &of.motion);
    }
}

impl Describe for Machine<'_> {
    fn name(&self) -> &str {
        self.inner().name()
    }
    fn title(&self) -> &str {
        self.inner().title()
    }
    fn shape(&self) -> Shape {
        self.inner().shape()
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        self.inner().state(index)
    }
    fn state_kind(&self, index: usize) -> StateKind {
        self.inner().state_kind(index)
    }
    fn coordinate(&self, index: usize) -> Quantity<'_> {
        self.inner().coordinate(index)
    }
    fn state_scale(&self, index: usize) -> f64 {
        self.inner().state_scale(index)
    }
    fn parameter(&self, index: usize) -> Quantity<'_> {
        self.inner().parameter(index)
    }
    fn parameter_default(&self, index: usize) -> f64 {
        self.inner().parameter_default(index)
    }
    fn output(&self, index: usize) -> Quantity<'_> {
        self.inner().output(index)
    }
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> {
        self.inner().rate_jacobian_pattern()
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        self.inner().parameter_jacobian_pattern()
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        self.inner().mass_matrix_pattern()
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        self.inner().run_defaults()
    }
    fn events(&self) -> usize {
        self.inner().events()
    }
    fn event(&self, index: usize) -> Event<'_> {
        self.inner().event(index)
    }
    fn is_mode(&self, index: usize) -> bool {
        self.inner().is_mode(index)
    }
    fn kinks(&self) -> usize {
        self.inner().kinks()
    }
    fn relations(&self) -> usize {
        self.inner().relations()
    }
    fn relation(&self, index: usize) -> Relation<'_> {
        self.inner().relation(index)
    }
    fn constraints(&self) -> usize {
        self.inner().constraints()
    }
    fn constraint(&self, index: usize) -> Constraint<'_> {
        self.inner().constraint(index)
    }
    fn constraint_matrix_pattern(&self) -> SparsityPattern<'_> {
        self.inner().constraint_matrix_pattern()
    }
    fn is_given(&self, index: usize) -> bool {
        self.inner().is_given(index)
    }
}

macro_rules! tallied {
    ($($name:ident $id:ident)*; $($prepared:ident $of:ident)*) => {
        $(fn $name(&self, t: f64, y: &[f64], p: &[f64], values: &mut [f64]) {
            self.plain::<false>(FunctionId::$id);
            self.inner().$name(t, y, p, values);
        })*
        $(fn $prepared(&self, t: f64, y: &[f64], p: &[f64], c: &[f64], values: &mut [f64]) {
            self.prepared(FunctionId::$of);
            self.inner().$prepared(t, y, p, c, values);
        })*
    };
}

impl Simulator<f64> for Machine<'_> {
    tallied! {
        rate Rate  mass_matrix MassMatrix  forcing Forcing  rate_jacobian RateJacobian
        parameter_jacobian ParameterJacobian  time_derivative TimeDerivative  outputs Outputs
        guards Guards  guard_rates GuardRates  resets Resets
        constraint_values ConstraintValues  constraint_rates ConstraintRates
        constraint_matrix ConstraintMatrix;
        prepared_rate Rate  prepared_rate_jacobian RateJacobian
        prepared_parameter_jacobian ParameterJacobian
    }
    fn initial_state(&self, p: &[f64], values: &mut [f64]) {
        self.inner().initial_state(p, values);
    }
    fn discontinuities(&self, p: &[f64], values: &mut [f64]) {
        self.plain::<false>(FunctionId::Discontinuities);
        self.inner().discontinuities(p, values);
    }
    fn energy(&self, _: f64, _: &[f64], _: &[f64]) -> Energy<f64> {
        unreachable!("no filter reads energies")
    }
    fn power_balance(&self, _: f64, _: &[f64], _: &[f64]) -> PowerBalance<f64> {
        unreachable!("no filter reads powers")
    }
    fn constants(&self) -> usize {
        self.inner().constants()
    }
    fn prepare(&self, p: &[f64], constants: &mut [f64]) {
        self.tape::<false>(&self.hoisted.constants);
        self.inner().prepare(p, constants);
    }
    fn derivatives(&self) -> Option<&dyn Derivatives> {
        Some(self)
    }
}

impl Derivatives for Machine<'_> {
    fn on_duals(
        &self,
        function: DualFunction,
        time: Dual,
        state: &[Dual],
        parameters: &[Dual],
        values: &mut [Dual],
    ) {
        self.plain::<true>(match function {
            DualFunction::Outputs => FunctionId::Outputs,
            DualFunction::Guards => FunctionId::Guards,
            DualFunction::Resets => FunctionId::Resets,
            DualFunction::ConstraintValues => FunctionId::ConstraintValues,
            DualFunction::ConstraintRates => FunctionId::ConstraintRates,
            DualFunction::RateJacobian => FunctionId::RateJacobian,
            DualFunction::TimeDerivative => FunctionId::TimeDerivative,
            other => unreachable!("no filter differentiates {other:?}"),
        });
        let inner = self.inner().derivatives().expect("functions on dual numbers");
        inner.on_duals(function, time, state, parameters, values);
    }
}

/// Scenes with steps in their span: a jump, rebound, friction, brakes and gears, constraints, shared
/// motion, quaternions.
const SCENES: [(&str, usize); 7] = [
    ("saw_gin", 400),
    ("bouncing_mass", 60),
    ("stick_slip", 60),
    ("drives/winch", 4000),
    ("pendulum_constrained", 200),
    ("pendulum_chain", 120),
    ("parts/spatial/revolute_constraint", 300),
];

#[test]
fn filters_in_rust_take_no_more_operations_than_are_stated() {
    for (name, count) in SCENES {
        let model = whole_model_of_specs(name, Keep::Needed);
        let simulator = ModelSimulator::interpreted(model.clone());
        let (hoisted, known) = (Hoisted::new(&model), RefCell::default());
        let machine = Machine { model: &model, hoisted, simulator, known };
        let list = Elimination::new(model.states.len(), &model.rate_jacobian.pattern.entries);
        let options = filter_of(&model);
        for method in StepMethod::ALL {
            let FilterCost { predict, correct } = rust_filter_cost(&model, method, &options);
            let indices = EstimatorIndices {
                method: method.with(list.borrowed()),
                measured: options.measured.clone(),
                estimated: options.estimated.clone(),
                diffusing: options.diffusing.clone(),
                disturbed: options.disturbed.clone(),
                start: options.start.clone(),
            };
            let mut filter = Estimator::new(&machine, &indices);
            let step = (model.run.until - model.run.from) / count as f64;
            let mut values = vec![0.0; model.wanted.len()];
            let [mut usual, mut most, mut corrected] = [0; 3];
            for _ in 0..count {
                TALLY.set(0);
                let stepped = filter.predict(step);
                let own = TALLY.take();
                most = most.max(own);
                if stepped == machinist_contract::fixed_step::Stepped::Events(0) {
                    usual = usual.max(own);
                }
                let (time, state, p) = (filter.time(), filter.state(), filter.parameters());
                machine.inner().outputs(time, state, p, &mut values);
                let measured: Vec<f64> =
                    options.measured.iter().map(|(output, _)| values[*output]).collect();
                let _ = filter.correct(&measured);
                corrected = corrected.max(TALLY.take());
            }
            let said = format!(
                "{name} by {}: functions {usual}, {most} and {corrected} of {}, {} and {correct}",
                method.name(),
                predict.usual,
                predict.most(),
            );
            println!("{said}");
            assert!(usual > 0 && usual <= predict.usual, "{said}");
            assert!(most <= predict.most() && corrected <= correct, "{said}");
        }
    }
}
