//! Models as simulators, compiled or interpreted.

mod describe;
mod field;
mod motion;
mod run;

use std::sync::{Arc, OnceLock};

use machinist_contract::field::FieldScene;
use machinist_contract::linear::LinearEquations;
use machinist_contract::taylor::TaylorSeries;
use machinist_contract::{
    Derivatives, Dual, Energy, PowerBalance, Ranges, Real, SideBySide, Simulator, jacobians_apart,
};

use crate::functions::{FUNCTIONS, FunctionId};
use crate::hoist::Hoisted;
use crate::lanes::{F64x2, Lane};
use crate::{Model, Table, Tape};

use run::{Read, Series, TapeFunction};

pub use run::Running;

/// A model as a simulator: its numbers equal those of the emitted code to the last bit.
///
/// Runs on `f64`, or on [`F64x2`](crate::lanes::F64x2) for two variants of a machine in lanes.
/// Functions are prepared at their first call, or after some thousand calls, and may be called by
/// any number of threads concurrently. Calls allocate nothing after that.
#[derive(Debug)]
pub struct ModelSimulator {
    model: Model,
    running: Running,
    /// Tables of the model, for machine code to point at.
    tables: Arc<[Table]>,
    /// One function for each row of the table of functions.
    functions: [TapeFunction; FUNCTIONS.len()],
    /// Computation before the functions that read the motion.
    motion: motion::MotionFunction,
    hoisted: OnceLock<Box<Hoisted>>,
    /// Computation of the constants, then the rate and Jacobians that read them.
    prepared: [TapeFunction; Prepared::ALL.len()],
    series: Series,
    /// Excitation and its switching times.
    linear: [TapeFunction; 2],
    fields: Box<[field::PointFunctions]>,
    /// For each event, whether it only counts.
    counters: Box<[bool]>,
    /// For each event, whether its guard or the rate of its guard reads a state that it sets.
    moves_guard: Box<[bool]>,
    inertia_has_corners: bool,
}

impl ModelSimulator {
    /// Runs a model as machine code once that pays, if the target has a backend; otherwise
    /// interprets it.
    #[must_use]
    pub fn new(model: Model) -> Self {
        Self::with(model, if is_compiled() { Running::Compiled } else { Running::Interpreted })
    }

    /// Runs a model as machine code from the first call of each function, for callers that must not
    /// wait later or that need machine code itself.
    #[must_use]
    pub fn compiled_at_once(model: Model) -> Self {
        let at_once = Running::CompiledAtOnce;
        Self::with(model, if is_compiled() { at_once } else { Running::Interpreted })
    }

    /// Runs a model operation by operation: ready immediately, and several times slower.
    #[must_use]
    pub fn interpreted(model: Model) -> Self {
        Self::with(model, Running::Interpreted)
    }

    fn with(model: Model, running: Running) -> Self {
        Self {
            running,
            tables: model.tables.clone().into(),
            functions: Default::default(),
            motion: motion::MotionFunction::new(&model),
            hoisted: OnceLock::new(),
            prepared: Default::default(),
            series: Series::default(),
            linear: Default::default(),
            fields: model
                .fields
                .iter()
                .map(|field| field::PointFunctions::new(&model, field))
                .collect(),
            counters: model.counters().into(),
            moves_guard: model.events_that_move_their_guard().into(),
            inertia_has_corners: model.inertia_has_corners(),
            model,
        }
    }

    /// Returns the simulator on single numbers.
    #[must_use]
    pub fn single(&self) -> &(dyn Simulator<f64> + Sync) {
        self
    }

    /// Returns the simulator on two variants in lanes.
    #[must_use]
    pub fn in_pairs(&self) -> &(dyn SideBySide<F64x2> + Sync) {
        self
    }

    /// Returns the simulator with fields to be discretized.
    #[must_use]
    pub fn with_fields(&self) -> &dyn FieldScene<f64> {
        self
    }

    /// Returns the same on numbers that carry derivatives.
    #[must_use]
    pub fn with_fields_on_duals(&self) -> &dyn FieldScene<Dual> {
        self
    }

    /// Returns the simulator with fields, shared.
    #[must_use]
    pub fn shared_with_fields(self: Arc<Self>) -> Arc<dyn FieldScene<f64> + Send> {
        self
    }

    /// Returns the same on numbers that carry derivatives.
    #[must_use]
    pub fn shared_with_fields_on_duals(self: Arc<Self>) -> Arc<dyn FieldScene<Dual> + Send> {
        self
    }

    /// Returns the model.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Returns how the model is run.
    #[must_use]
    pub fn running(&self) -> Running {
        self.running
    }

    /// Collects the inputs of tapes after a check of the slices' lengths.
    #[inline(always)]
    fn read<'a, R: Lane>(&'a self, time: &'a R, state: &'a [R], parameters: &'a [R]) -> Read<'a> {
        assert_eq!(state.len(), self.model.states.len(), "length of the state");
        Read { state: R::numbers(state), ..self.read_without_state(time, parameters) }
    }

    #[inline(always)]
    fn read_without_state<'a, R: Lane>(&'a self, time: &'a R, parameters: &'a [R]) -> Read<'a> {
        let [own, handed] = [self.model.parameters.len(), self.model.handed.len()];
        assert_eq!(parameters.len(), self.model.slots().end, "number of parameters");
        let handed = &parameters[own..own + handed];
        Read {
            time: R::numbers(std::slice::from_ref(time)),
            state: &[],
            parameters: R::numbers(parameters),
            handed: R::numbers(handed),
            constants: &[],
            motion: &[],
            tables: &self.tables,
        }
    }

    /// Passes the parameters followed by the slots of relations: the given slots, or slots that
    /// leave relations live.
    #[inline(always)]
    fn with_slots<R: Real, T>(&self, parameters: &[R], work: impl FnOnce(&[R]) -> T) -> T {
        let relations = &self.model.relations;
        if relations.is_empty() || parameters.len() == self.model.slots().end {
            return work(parameters);
        }
        let live = relations.iter().map(|relation| R::literal(relation.kind.live()));
        work(&parameters.iter().copied().chain(live).collect::<Vec<R>>())
    }

    fn hoisted(&self) -> &Hoisted {
        self.hoisted.get_or_init(|| Box::new(Hoisted::new(&self.model)))
    }

    #[inline(always)]
    fn function(&self, called: Called) -> &TapeFunction {
        match called {
            Called::Function(id) => &self.functions[id as usize],
            Called::Prepared(prepared) => &self.prepared[prepared as usize],
        }
    }

    fn tape(&self, called: Called) -> &Tape {
        match called {
            Called::Function(id) => self.model.tape(id),
            Called::Prepared(Prepared::Constants) => &self.hoisted().constants,
            Called::Prepared(Prepared::Rate) => &self.hoisted().rate,
            Called::Prepared(Prepared::RateJacobian) => &self.hoisted().rate_jacobian,
            Called::Prepared(Prepared::ParameterJacobian) => &self.hoisted().parameter_jacobian,
            Called::Prepared(Prepared::Jacobians) => &self.hoisted().jacobians,
        }
    }

    /// Returns the function of the table, if it depends on the motion's tape.
    fn behind_motion(&self, called: Called) -> Option<FunctionId> {
        let function = match called {
            Called::Function(id) => id,
            // Of the prepared functions only the Jacobians can depend on it.
            Called::Prepared(Prepared::RateJacobian) => FunctionId::RateJacobian,
            Called::Prepared(Prepared::ParameterJacobian) => FunctionId::ParameterJacobian,
            Called::Prepared(_) => return None,
        };
        self.motion.is_read_by(function).then_some(function)
    }

    /// Writes the results of a tape that reads no constants, and no state if `motion` is `None`.
    #[inline(always)]
    fn call<R: Lane>(
        &self,
        called: Called,
        motion: Option<(R, &[R])>,
        parameters: &[R],
        results: &mut [R],
    ) {
        let (time, state) =
            motion.map_or((R::literal(0.0), None), |(time, state)| (time, Some(state)));
        let given = [state.unwrap_or(&[]), parameters, &[]].map(R::numbers);
        let results = R::numbers_mut(results);
        if !self.function(called).run_again(R::COUNT, time.ends(), given, results) {
            self.call_with_care(called, time, state, parameters, &[], results);
        }
    }

    /// Writes the results of a tape that reads constants.
    #[inline(always)]
    fn call_prepared<const PREPARED: usize, R: Lane>(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        results: &mut [R],
    ) {
        let given = [state, parameters, constants].map(R::numbers);
        let written = R::numbers_mut(results);
        if !self.prepared[PREPARED].run_again(R::COUNT, time.ends(), given, written) {
            self.prepared_with_care::<PREPARED, R>(time, state, parameters, constants, results);
        }
    }

    /// Handles the slow path. The arguments are those of the caller, so that the call is a jump and
    /// the caller saves no register.
    #[inline(never)]
    fn prepared_with_care<const PREPARED: usize, R: Lane>(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        results: &mut [R],
    ) {
        let called = Called::Prepared(Prepared::ALL[PREPARED]);
        let results = R::numbers_mut(results);
        self.call_with_care(called, time, Some(state), parameters, constants, results);
    }

    /// Handles the first call, changed lengths, and functions that are long or depend on the
    /// motion.
    #[inline(never)]
    fn call_with_care<R: Lane>(
        &self,
        called: Called,
        time: R,
        state: Option<&[R]>,
        parameters: &[R],
        constants: &[R],
        results: &mut [f64],
    ) {
        self.with_slots(parameters, |parameters| {
            let read = match state {
                Some(state) => self.read(&time, state, parameters),
                None => self.read_without_state(&time, parameters),
            };
            let read = Read { constants: R::numbers(constants), ..read };
            let tape = (|| self.tape(called), self.running);
            let ready = self.function(called);
            if let Some(function) = self.behind_motion(called) {
                self.run_behind_motion((function, ready), tape, R::COUNT, &read, results);
            } else {
                ready.run_and_keep(tape, R::COUNT, &read, results);
            }
        });
    }
}

/// Returns whether models are compiled on this target.
fn is_compiled() -> bool {
    #[cfg(feature = "compiled")]
    let is_available = crate::compiled::is_available();
    #[cfg(not(feature = "compiled"))]
    let is_available = false;
    is_available
}

/// A function to run: one of the table, or one that replaces it once the parameters are known.
#[derive(Debug, Clone, Copy)]
enum Called {
    Function(FunctionId),
    Prepared(Prepared),
}

/// The constants, which depend on parameters only, and the functions that read them.
#[derive(Debug, Clone, Copy)]
enum Prepared {
    Constants,
    Rate,
    RateJacobian,
    ParameterJacobian,
    Jacobians,
}

impl Prepared {
    const ALL: [Self; 5] =
        [Self::Constants, Self::Rate, Self::RateJacobian, Self::ParameterJacobian, Self::Jacobians];
}

/// Runs functions of the table on a type of numbers.
trait Runs<R> {
    /// Writes the results of a function; `motion` is `None` for one of parameters only.
    fn run(&self, function: FunctionId, motion: Option<(&R, &[R])>, p: &[R], results: &mut [R]);
}

impl<R: Lane> Runs<R> for ModelSimulator {
    #[inline(always)]
    fn run(&self, function: FunctionId, motion: Option<(&R, &[R])>, p: &[R], results: &mut [R]) {
        let motion = motion.map(|(time, state)| (*time, state));
        self.call(Called::Function(function), motion, p, results);
    }
}

/// The methods of the table of functions, on a type of numbers.
macro_rules! functions {
    (
        [$number:ident]
        every { $($every:tt)* }
        events { $($events:tt)* }
        constraints { $($constraints:tt)* }
        kinks { $($kinks:tt)* }
        saturations { $($saturations:tt)* }
    ) => {
        $(function! { $number $every })*
        $(function! { $number $events })*
        $(function! { $number $constraints })*
        $(function! { $number $kinks })*
        $(function! { $number $saturations })*
    };
}

macro_rules! function {
    ($R:ident {
        $id:ident $name:ident Parameters $result:tt [] $meaning:literal $doc:literal
    }) => {
        fn $name(&self, parameters: &[$R], values: &mut [$R]) {
            Runs::<$R>::run(self, FunctionId::$id, None, parameters, values);
        }
    };
    ($R:ident {
        $id:ident $name:ident Motion [structure $structure:ident $($field:ident)*] []
        $meaning:literal $doc:literal
    }) => {
        fn $name(&self, time: $R, state: &[$R], parameters: &[$R]) -> $structure<$R> {
            let mut values = [$R::literal(0.0); [$(stringify!($field)),*].len()];
            let motion = Some((&time, state));
            Runs::<$R>::run(self, FunctionId::$id, motion, parameters, &mut values);
            let [$($field),*] = values;
            $structure { $($field),* }
        }
    };
    ($R:ident {
        $id:ident $name:ident Motion $result:tt [$($prepared:ident)?] $meaning:literal
        $doc:literal
    }) => {
        fn $name(&self, time: $R, state: &[$R], parameters: &[$R], values: &mut [$R]) {
            Runs::<$R>::run(self, FunctionId::$id, Some((&time, state)), parameters, values);
        }
    };
}

mod derivatives;
mod ranges;

/// Implements the contract on a type of numbers. A generic implementation would be compiled in each crate that makes a
/// `dyn Simulator` of one, with the settings there; these are compiled here.
macro_rules! on_numbers {
    ($R:ident) => {
        impl Simulator<$R> for ModelSimulator {
            machinist_contract::for_each_function! { [functions] $R }
            fn constants(&self) -> usize {
                self.hoisted().constants.results.len()
            }
            fn prepare(&self, parameters: &[$R], constants: &mut [$R]) {
                self.call(Called::Prepared(Prepared::Constants), None, parameters, constants);
            }
            fn prepared_rate(
                &self,
                time: $R,
                state: &[$R],
                parameters: &[$R],
                constants: &[$R],
                rate: &mut [$R],
            ) {
                self.call_prepared::<{ Prepared::Rate as usize }, $R>(
                    time, state, parameters, constants, rate,
                );
            }
            fn prepared_rate_jacobian(
                &self,
                time: $R,
                state: &[$R],
                parameters: &[$R],
                constants: &[$R],
                values: &mut [$R],
            ) {
                self.call_prepared::<{ Prepared::RateJacobian as usize }, $R>(
                    time, state, parameters, constants, values,
                );
            }
            fn prepared_parameter_jacobian(
                &self,
                time: $R,
                state: &[$R],
                parameters: &[$R],
                constants: &[$R],
                values: &mut [$R],
            ) {
                self.call_prepared::<{ Prepared::ParameterJacobian as usize }, $R>(
                    time, state, parameters, constants, values,
                );
            }
            fn prepared_jacobians(
                &self,
                time: $R,
                state: &[$R],
                parameters: &[$R],
                constants: &[$R],
                values: &mut [$R],
            ) {
                if !self.model.gives_jacobians_at_once() {
                    return jacobians_apart(self, time, state, parameters, constants, values);
                }
                self.call_prepared::<{ Prepared::Jacobians as usize }, $R>(
                    time, state, parameters, constants, values,
                );
            }
            fn taylor(&self) -> Option<&dyn TaylorSeries<$R>> {
                self.model.constraints.is_empty().then_some(self as &dyn TaylorSeries<$R>)
            }
            fn linear(&self) -> Option<&dyn LinearEquations<$R>> {
                self.model.excitation.is_some().then_some(self)
            }
            /// Returns `None` for a model with fields, because some parameters follow from others; see
            /// [`ModelSimulator::shared_with_fields_on_duals`].
            fn derivatives(&self) -> Option<&dyn Derivatives> {
                self.model.fields.is_empty().then_some(self)
            }
            fn ranges(&self) -> Option<&dyn Ranges> {
                Some(self)
            }
        }

        impl LinearEquations<$R> for ModelSimulator {
            fn excitation_terms(&self) -> &[(u32, u32)] {
                self.model.excitation.as_ref().map_or(&[], |excitation| &excitation.terms)
            }
            fn slopes(&self) -> &[(u32, u32)] {
                self.model.excitation.as_ref().map_or(&[], |excitation| &excitation.slopes)
            }
            fn excitation(&self, time: $R, state: &[$R], parameters: &[$R], values: &mut [$R]) {
                if let Some(excitation) = &self.model.excitation {
                    self.with_slots(parameters, |parameters| {
                        let read = self.read(&time, state, parameters);
                        let tape = (|| &excitation.values, self.running);
                        self.linear[0].run(tape, $R::COUNT, &read, $R::numbers_mut(values));
                    });
                }
            }
            fn switches(&self) -> usize {
                self.model
                    .excitation
                    .as_ref()
                    .map_or(0, |excitation| excitation.switches.results.len())
            }
            fn switch_times(&self, parameters: &[$R], times: &mut [$R]) {
                if let Some(excitation) = &self.model.excitation {
                    let zero = $R::literal(0.0);
                    self.with_slots(parameters, |parameters| {
                        let read = self.read_without_state(&zero, parameters);
                        let tape = (|| &excitation.switches, self.running);
                        self.linear[1].run(tape, $R::COUNT, &read, $R::numbers_mut(times));
                    });
                }
            }
        }

        impl TaylorSeries<$R> for ModelSimulator {
            fn series_workspace(&self, order: usize) -> usize {
                self.series.workspace((&self.model, self.running), &self.tables, order)
            }
            fn series(
                &self,
                time: $R,
                state: &[$R],
                parameters: &[$R],
                coefficients: &mut [$R],
                workspace: &mut [$R],
            ) {
                self.with_slots(parameters, |parameters| {
                    let read = self.read(&time, state, parameters);
                    let [coefficients, workspace] = [coefficients, workspace].map($R::numbers_mut);
                    let model = (&self.model, self.running);
                    self.series.run(model, $R::COUNT, &read, coefficients, workspace);
                });
            }
            fn has_corners(&self) -> bool {
                let jumps = self.model.discontinuities.results.len();
                self.series.tape(&self.model).has_corners(jumps)
            }
        }
    };
}

on_numbers! { f64 }
on_numbers! { F64x2 }
