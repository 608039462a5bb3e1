//! Tapes of a model, compiled or interpreted when they are first asked for.

use std::sync::{Arc, OnceLock};

use machinist_contract::Dual;

#[cfg(feature = "compiled")]
use crate::compiled::{CompiledSeries, CompiledTape, Regions};
use crate::evaluate::{Evaluator, Inputs};
use crate::room::with_room;
use crate::series::{SeriesEvaluator, TaylorTape, recurrences};
use crate::{Model, Table, Tape};

/// How the tapes of a model are run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Running {
    /// As machine code, made when a function is first called; what cannot be compiled is
    /// interpreted.
    Compiled,
    /// Operation by operation.
    Interpreted,
}

/// What tapes read: region by region, numbers of one place side by side.
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

    /// Runs something for each of so many lanes, with inputs and results of one.
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

/// A tape that is ready to be run on numbers of some lanes.
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
        if running == Running::Compiled
            && let Some(compiled) = CompiledTape::with_lanes(tape, tables, lanes)
        {
            return Self::Compiled(compiled);
        }
        Self::Interpreted(Evaluator::new(tape))
    }
}

/// A function of a model.
#[derive(Debug, Default)]
pub(super) struct TapeFunction {
    /// On one number, on two.
    ready: [OnceLock<Box<Ready>>; 2],
    on_duals: OnceLock<Box<Evaluator>>,
}

impl TapeFunction {
    /// Writes the results of its tape for numbers of so many lanes.
    #[inline(always)]
    pub fn run<'a>(
        &self,
        (tape, running): (impl FnOnce() -> &'a Tape, Running),
        lanes: usize,
        read: &Read<'_>,
        results: &mut [f64],
    ) {
        let ready = match self.ready[lanes - 1].get() {
            Some(ready) => ready,
            None => self.make_ready(tape(), read.tables, running, lanes),
        };
        match ready {
            #[cfg(feature = "compiled")]
            Ready::Compiled(compiled) => compiled.run(&read.regions(), results),
            Ready::Interpreted(evaluator) => {
                let evaluate = |inputs: &Inputs<'_>, results: &mut [f64]| {
                    evaluator.evaluate(inputs, results);
                };
                read.for_each_lane(lanes, results, evaluate);
            }
        }
    }
}

impl TapeFunction {
    /// Writes the results of its tape on dual numbers, interpreted.
    pub fn run_on_duals(&self, tape: &Tape, inputs: &Inputs<'_, Dual>, results: &mut [Dual]) {
        let evaluator = self.on_duals.get_or_init(|| Box::new(Evaluator::new(tape)));
        let mut room = vec![Dual::constant(0.0); evaluator.room()];
        evaluator.evaluate_in(&mut room, inputs, results);
    }

    #[cold]
    fn make_ready(
        &self,
        tape: &Tape,
        tables: &Arc<[Table]>,
        running: Running,
        lanes: usize,
    ) -> &Ready {
        self.ready[lanes - 1].get_or_init(|| Box::new(Ready::new(tape, tables, running, lanes)))
    }
}

/// Recurrences that are ready to be run on numbers of some lanes.
#[derive(Debug)]
enum ReadySeries {
    #[cfg(feature = "compiled")]
    Compiled(Box<CompiledSeries>),
    Interpreted(SeriesEvaluator),
}

/// The Taylor series of a model.
#[derive(Debug, Default)]
pub(super) struct Series {
    tape: OnceLock<TaylorTape>,
    ready: [OnceLock<ReadySeries>; 2],
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
            if running == Running::Compiled
                && let Some(compiled) = CompiledSeries::with_lanes(self.tape(model), tables, lanes)
            {
                return ReadySeries::Compiled(Box::new(compiled));
            }
            ReadySeries::Interpreted(SeriesEvaluator::new(self.tape(model).clone()))
        })
    }

    /// Numbers of workspace, each of so many lanes.
    #[cfg_attr(not(feature = "compiled"), allow(unused_variables, reason = "compiled by none"))]
    pub fn workspace(
        &self,
        (model, running): (&Model, Running),
        tables: &Arc<[Table]>,
        lanes: usize,
        order: usize,
    ) -> usize {
        match self.ready(model, tables, running, lanes) {
            #[cfg(feature = "compiled")]
            ReadySeries::Compiled(compiled) => compiled.workspace(order),
            ReadySeries::Interpreted(_) => 0,
        }
    }

    /// Writes coefficients, order after order.
    #[cfg_attr(not(feature = "compiled"), allow(unused_variables, reason = "compiled by none"))]
    pub fn run(
        &self,
        (model, running): (&Model, Running),
        lanes: usize,
        read: &Read<'_>,
        coefficients: &mut [f64],
        workspace: &mut [f64],
    ) {
        match self.ready(model, read.tables, running, lanes) {
            #[cfg(feature = "compiled")]
            ReadySeries::Compiled(compiled) => {
                compiled.run(&read.regions(), coefficients, workspace);
            }
            ReadySeries::Interpreted(evaluator) => {
                let evaluate = |inputs: &Inputs<'_>, coefficients: &mut [f64]| {
                    evaluator.evaluate(inputs, coefficients);
                };
                read.for_each_lane(lanes, coefficients, evaluate);
            }
        }
    }
}
