//! The motion's tape, run before the functions that read it, and matrices that are solved for with
//! its factors.

use machinist_contract::Real;
use machinist_contract::implicit::LANES;

use super::ModelSimulator;
use super::run::{Read, Running, TapeFunction};
use crate::evaluate::Inputs;
use crate::functions::{COUNT, FUNCTIONS, FunctionId};
use crate::room::with_room;
use crate::{Model, Motion, Solve, Tape};

/// The motion's tape, unprepared and with constants of the parameters.
#[derive(Debug, Default)]
pub(super) struct MotionFunction {
    tapes: [TapeFunction; 2],
    /// True for each function that reads it.
    readers: [bool; COUNT],
}

impl MotionFunction {
    pub fn new(model: &Model) -> Self {
        Self {
            tapes: Default::default(),
            readers: FUNCTIONS.each_ref().map(|row| model.reads_motion(row.id)),
        }
    }

    /// Writes the results of a model's motion tape.
    pub fn run_on<R: Real>(&self, tape: &Tape, inputs: &Inputs<'_, R>, results: &mut [R]) {
        self.tapes[0].run_on(tape, inputs, results);
    }

    #[inline(always)]
    pub fn is_read_by(&self, function: FunctionId) -> bool {
        self.readers[function as usize]
    }
}

impl ModelSimulator {
    /// Runs the motion's tape, the prepared one if there are constants, then a function that reads
    /// it.
    #[inline(never)]
    pub(super) fn run_behind_motion<'a>(
        &'a self,
        (function, ready): (FunctionId, &TapeFunction),
        tape: (impl FnOnce() -> &'a Tape, Running),
        lanes: usize,
        read: &Read<'_>,
        results: &mut [f64],
    ) {
        let Some(motion) = &self.model.motion else { return };
        let is_prepared = !read.constants.is_empty();
        let of_motion = || if is_prepared { &self.hoisted().motion } else { &motion.tape };
        let solve = self.model.solve(function);
        let [inputs, rows] =
            solve.map_or([0; 2], |solve| [solve.inputs(), solve.rows as usize * LANES]);
        let counts = [motion.tape.results.len(), inputs].map(|count| count * lanes);
        // Followed by the numbers of one lane: factors, inputs, values, and the solution.
        let of_lane = [motion.factors.len(), inputs, results.len() / lanes, rows];
        let all = counts.iter().chain(&of_lane).sum();
        with_room(all, |room| {
            let (known, rest) = room.split_at_mut(counts[0]);
            let (inputs, rest) = rest.split_at_mut(counts[1]);
            let own = (of_motion, self.running);
            self.motion.tapes[usize::from(is_prepared)].run(own, lanes, read, known);
            let read = Read { motion: known, ..*read };
            match solve {
                None => ready.run(tape, lanes, &read, results),
                Some(solve) => {
                    ready.run(tape, lanes, &read, inputs);
                    for lane in 0..lanes {
                        solve_lane((motion, solve), (lane, lanes), [known, inputs], rest, results);
                    }
                }
            }
        });
    }
}

/// Solves for the matrix of one of `lanes` lanes, in workspace for one lane.
fn solve_lane(
    (motion, solve): (&Motion, &Solve),
    (lane, lanes): (usize, usize),
    [known, inputs]: [&[f64]; 2],
    room: &mut [f64],
    results: &mut [f64],
) {
    let (factors, rest) = room.split_at_mut(motion.factors.len());
    let (own, rest) = rest.split_at_mut(solve.inputs());
    let (values, work) = rest.split_at_mut(results.len() / lanes);
    for (factor, place) in factors.iter_mut().zip(&motion.factors) {
        *factor = known[*place as usize * lanes + lane];
    }
    for (one, all) in own.iter_mut().zip(inputs.chunks_exact(lanes)) {
        *one = all[lane];
    }
    solve.write(factors, own, work.as_chunks_mut().0, values);
    for (all, one) in results.chunks_exact_mut(lanes).zip(&*values) {
        all[lane] = *one;
    }
}
