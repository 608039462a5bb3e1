//! Tapes of a model, compiled or interpreted at first use.

use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, OnceLock};

use machinist_contract::Real;

#[cfg(feature = "compiled")]
use crate::compiled::{Again, CompiledSeries, CompiledTape, Regions, SeriesRoom};
use crate::evaluate::{Evaluator, Inputs};
use crate::room::with_room;
use crate::series::{SeriesEvaluator, TaylorTape, recurrences};
use crate::{Model, Table, Tape};

/// Number of calls that are interpreted before a tape is compiled. They take between two thirds and
/// all of the compile time, whatever the length of the tape, so that a run takes at most twice the time
/// that it would take if the number of its calls were known.
const CALLS_AT_FIRST: u32 = 20_000;

/// The same for series, a call of which computes about twenty orders.
const SERIES_AT_FIRST: u32 = 1000;

/// Way in which the tapes of a model run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Running {
    /// Interpreted until a function has been called some thousand times, then as machine code;
    /// tapes that cannot be compiled remain interpreted.
    Compiled,
    /// As machine code, compiled at the first call of each function; tapes that cannot be compiled
    /// are interpreted.
    CompiledAtOnce,
    /// Interpreted, operation by operation.
    Interpreted,
}

/// Number of calls of a function that is not compiled yet.
#[derive(Debug, Default)]
struct Calls(AtomicU32);

impl Calls {
    /// Counts a call, and returns whether it is one of the first `at_first` that are interpreted.
    fn is_interpreted(&self, running: Running, at_first: u32) -> bool {
        running == Running::Compiled && self.0.fetch_add(1, Ordering::Relaxed) < at_first
    }
}

/// Inputs of tapes by region, with the lanes of each number next to each other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Read<'a> {
    pub time: &'a [f64],
    pub state: &'a [f64],
    pub parameters: &'a [f64],
    pub handed: &'a [f64],
    pub constants: &'a [f64],
    pub motion: &'a [f64],
    pub tables: &'a Arc<[Table]>,
}

impl Read<'_> {
    #[cfg(feature = "compiled")]
    #[inline(always)]
    fn regions(&self) -> Regions<'_> {
        let Self { time, state, parameters, handed, constants, motion, .. } = *self;
        Regions { time, state, parameters, handed, constants, motion }
    }

    fn inputs(&self) -> Inputs<'_> {
        let Self { time, state, parameters, handed, constants, motion, tables } = *self;
        Inputs { time: time[0], state, parameters, handed, constants, motion, tables }
    }

    /// Runs a closure for each of `lanes` lanes, with inputs and results of one.
    fn for_each_lane(
        &self,
        lanes: usize,
        results: &mut [f64],
        mut run: impl FnMut(&Inputs<'_>, &mut [f64]),
    ) {
        if lanes == 1 {
            return run(&self.inputs(), results);
        }
        let [state, parameters, handed, constants, motion] =
            [self.state, self.parameters, self.handed, self.constants, self.motion]
                .map(<[f64]>::len);
        let counts = [state, parameters, handed, constants, motion, results.len()]
            .map(|count| count / lanes);
        with_room(counts.iter().sum(), |room| {
            for lane in 0..lanes {
                let mut rest = &mut *room;
                let [state, parameters, handed, constants, motion, alone] = counts.map(|count| {
                    let (first, others) = std::mem::take(&mut rest).split_at_mut(count);
                    rest = others;
                    first
                });
                let read = [self.state, self.parameters, self.handed, self.constants, self.motion];
                let of_lane =
                    [&mut *state, &mut *parameters, &mut *handed, &mut *constants, &mut *motion];
                for (alone, all) in of_lane.into_iter().zip(read) {
                    for (one, all) in alone.iter_mut().zip(all.chunks_exact(lanes)) {
                        *one = all[lane];
                    }
                }
                let inputs = Inputs {
                    time: self.time[lane],
                    state,
                    parameters,
                    handed,
                    constants,
                    motion,
                    tables: self.tables,
                };
                run(&inputs, alone);
                for (one, all) in alone.iter().zip(results.chunks_exact_mut(lanes)) {
                    all[lane] = *one;
                }
            }
        });
    }
}

/// A tape that is ready to run on numbers of some lanes.
#[derive(Debug)]
enum Ready {
    #[cfg(feature = "compiled")]
    Compiled(CompiledTape),
    Interpreted(Evaluator),
}

impl Ready {
    #[cfg_attr(not(feature = "compiled"), allow(unused_variables, reason = "compiled by none"))]
    fn new(tape: &Tape, tables: &Arc<[Table]>, running: Running, lanes: usize) -> Self {
        #[cfg(feature = "compiled")]
        if running != Running::Interpreted
            && let Some(compiled) = CompiledTape::with_lanes(tape, tables, lanes)
        {
            return Self::Compiled(compiled);
        }
        Self::Interpreted(Evaluator::new(tape))
    }

    #[inline(always)]
    fn run(&self, lanes: usize, read: &Read<'_>, results: &mut [f64]) {
        match self {
            #[cfg(feature = "compiled")]
            Self::Compiled(compiled) => compiled.run(&read.regions(), results),
            Self::Interpreted(evaluator) => interpret(evaluator, lanes, read, results),
        }
    }
}

fn interpret(evaluator: &Evaluator, lanes: usize, read: &Read<'_>, results: &mut [f64]) {
    read.for_each_lane(lanes, results, |inputs, results| evaluator.evaluate(inputs, results));
}

/// A function of a model.
#[derive(Debug, Default)]
pub(super) struct TapeFunction {
    /// On one lane, on two, for calls with the same lengths as before.
    #[cfg(feature = "compiled")]
    again: [OnceLock<Again>; 2],
    /// On one lane, on two.
    ready: [OnceLock<Box<Ready>>; 2],
    /// On other numbers, and for the first calls.
    evaluator: OnceLock<Box<Evaluator>>,
    calls: Calls,
}

impl TapeFunction {
    /// Writes the results of its tape for numbers of `lanes` lanes.
    #[inline(always)]
    pub fn run<'a>(
        &self,
        (tape, running): (impl FnOnce() -> &'a Tape, Running),
        lanes: usize,
        read: &Read<'_>,
        results: &mut [f64],
    ) {
        match self.ready[lanes - 1].get() {
            Some(ready) => ready.run(lanes, read, results),
            None => self.run_at_first((tape(), running), lanes, read, results),
        }
    }
}

impl TapeFunction {
    /// Writes the results of its tape and returns true, if its machine code was kept for these
    /// lengths; otherwise returns false. `time` is that of the first lane and of the last. `given`
    /// is the state, the parameters followed by the values that fields hand over, and the
    /// constants.
    #[inline(always)]
    #[cfg_attr(
        not(feature = "compiled"),
        allow(unused_variables, clippy::unused_self, reason = "compiled by none")
    )]
    pub fn run_again(
        &self,
        lanes: usize,
        time: [f64; 2],
        given: [&[f64]; 3],
        results: &mut [f64],
    ) -> bool {
        #[cfg(feature = "compiled")]
        if let Some(again) = self.again[lanes - 1].get() {
            return again.run(time, given, results);
        }
        false
    }

    /// Writes the results of its tape as [`TapeFunction::run`], and keeps short machine code for
    /// calls with the same lengths; see docs/decisions/0013-models-compiled-at-once.md.
    pub fn run_and_keep<'a>(
        &self,
        tape: (impl FnOnce() -> &'a Tape, Running),
        lanes: usize,
        read: &Read<'_>,
        results: &mut [f64],
    ) {
        self.run(tape, lanes, read, results);
        #[cfg(feature = "compiled")]
        if let Some(ready) = self.ready[lanes - 1].get()
            && let Ready::Compiled(compiled) = &**ready
            && let Some(again) = compiled.again(&read.regions())
        {
            // If another thread was first, it had the same lengths.
            let _ = self.again[lanes - 1].set(again);
        }
    }

    /// Writes the results of its tape on another type of numbers, interpreted.
    pub fn run_on<R: Real>(&self, tape: &Tape, inputs: &Inputs<'_, R>, results: &mut [R]) {
        let evaluator = self.evaluator(tape);
        let mut room = vec![R::literal(0.0); evaluator.room()];
        evaluator.evaluate_in(&mut room, inputs, results);
    }

    fn evaluator(&self, tape: &Tape) -> &Evaluator {
        self.evaluator.get_or_init(|| Box::new(Evaluator::new(tape)))
    }

    /// Runs the tape before it is ready. Interpreter and machine code give the same bits.
    #[cold]
    fn run_at_first(
        &self,
        (tape, running): (&Tape, Running),
        lanes: usize,
        read: &Read<'_>,
        results: &mut [f64],
    ) {
        if self.calls.is_interpreted(running, CALLS_AT_FIRST) {
            return interpret(self.evaluator(tape), lanes, read, results);
        }
        let ready = self.ready[lanes - 1]
            .get_or_init(|| Box::new(Ready::new(tape, read.tables, running, lanes)));
        ready.run(lanes, read, results);
    }
}

/// Recurrences that are ready to run on numbers of some lanes.
#[derive(Debug)]
enum ReadySeries {
    #[cfg(feature = "compiled")]
    Compiled(Box<CompiledSeries>),
    Interpreted,
}

/// The Taylor series of a model.
#[derive(Debug, Default)]
pub(super) struct Series {
    tape: OnceLock<TaylorTape>,
    ready: [OnceLock<ReadySeries>; 2],
    evaluator: OnceLock<SeriesEvaluator>,
    #[cfg(feature = "compiled")]
    room: OnceLock<Option<SeriesRoom>>,
    calls: Calls,
}

impl Series {
    pub fn tape(&self, model: &Model) -> &TaylorTape {
        self.tape.get_or_init(|| recurrences(model))
    }

    #[cfg_attr(not(feature = "compiled"), allow(unused_variables, reason = "compiled by none"))]
    fn ready(
        &self,
        model: &Model,
        tables: &Arc<[Table]>,
        running: Running,
        lanes: usize,
    ) -> &ReadySeries {
        self.ready[lanes - 1].get_or_init(|| {
            #[cfg(feature = "compiled")]
            if running != Running::Interpreted
                && let Some(compiled) = CompiledSeries::with_lanes(self.tape(model), tables, lanes)
            {
                return ReadySeries::Compiled(Box::new(compiled));
            }
            ReadySeries::Interpreted
        })
    }

    /// Returns the length of the workspace of machine code, in numbers of `lanes` lanes. It applies
    /// to the interpreter too, because a method may go on with the same workspace after
    /// compilation.
    #[cfg_attr(
        not(feature = "compiled"),
        allow(unused_variables, clippy::unused_self, reason = "compiled by none")
    )]
    pub fn workspace(
        &self,
        (model, running): (&Model, Running),
        tables: &Arc<[Table]>,
        order: usize,
    ) -> usize {
        #[cfg(feature = "compiled")]
        if running != Running::Interpreted {
            let room = || SeriesRoom::of(self.tape(model), tables.len());
            return self.room.get_or_init(room).map_or(0, |room| room.numbers(order));
        }
        0
    }

    /// Writes coefficients, order by order.
    #[cfg_attr(not(feature = "compiled"), allow(unused_variables, reason = "compiled by none"))]
    pub fn run(
        &self,
        (model, running): (&Model, Running),
        lanes: usize,
        read: &Read<'_>,
        coefficients: &mut [f64],
        workspace: &mut [f64],
    ) {
        let is_ready = self.ready[lanes - 1].get().is_some();
        if !is_ready && self.calls.is_interpreted(running, SERIES_AT_FIRST) {
            return self.interpret(model, lanes, read, coefficients);
        }
        match self.ready(model, read.tables, running, lanes) {
            #[cfg(feature = "compiled")]
            ReadySeries::Compiled(compiled) => {
                compiled.run(&read.regions(), coefficients, workspace);
            }
            ReadySeries::Interpreted => self.interpret(model, lanes, read, coefficients),
        }
    }

    fn interpret(&self, model: &Model, lanes: usize, read: &Read<'_>, coefficients: &mut [f64]) {
        let evaluator =
            self.evaluator.get_or_init(|| SeriesEvaluator::new(self.tape(model).clone()));
        read.for_each_lane(lanes, coefficients, |inputs, coefficients| {
            evaluator.evaluate(inputs, coefficients);
        });
    }
}

#[cfg(all(test, feature = "compiled"))]
mod tests {
    use super::*;
    use crate::{Node, NodeId, Op};

    /// x -> 1 + x + ... by `count` additions.
    fn sums(count: usize) -> Tape {
        let mut ops = vec![Op::State(0), Op::Literal(1.0)];
        ops.extend((0..count).map(|k| Op::Add(NodeId(k as u32 + 1), NodeId(0))));
        let results = vec![NodeId(ops.len() as u32 - 1)];
        Tape { nodes: ops.into_iter().map(|op| Node { op, name: None }).collect(), results }
    }

    #[test]
    fn tapes_are_interpreted_until_machine_code_pays() {
        let tables: Arc<[Table]> = Arc::new([]);
        let cases = [(Running::CompiledAtOnce, 0), (Running::Compiled, CALLS_AT_FIRST)];
        for (running, at_first) in cases {
            let additions = 10;
            let (function, tape) = (TapeFunction::default(), sums(additions));
            let mut before = 0;
            for call in 1..=CALLS_AT_FIRST + 2 {
                let state = [f64::from(call) * 0.1];
                let read = Read {
                    time: &[0.0],
                    state: &state,
                    parameters: &[],
                    handed: &[],
                    constants: &[],
                    motion: &[],
                    tables: &tables,
                };
                let mut result = [0.0];
                function.run((|| &tape, running), 1, &read, &mut result);
                let expected = (0..additions).fold(1.0, |sum, _| sum + state[0]);
                assert_eq!(result[0].to_bits(), f64::to_bits(expected), "call {call}");
                before += u32::from(function.ready[0].get().is_none());
            }
            assert_eq!(before, at_first, "{running:?}");
        }
    }
}
