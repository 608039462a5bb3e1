//! Models as machine code, compiled in the process by Cranelift.
//!
//! ```text
//! Tape, TaylorTape -> Straight -> Schedule -> functions of Cranelift -> machine code
//! ```
//!
//! Every operation keeps its operands from the tape and their rounding, and calls the contract's
//! own functions. Results are therefore those of [`Evaluator`](crate::evaluate::Evaluator) and
//! [`SeriesEvaluator`](crate::series::SeriesEvaluator) to the last bit, except for the bits of NaN.
//! A program can be compiled for one number at a time or for two lanes.
//!
//! Excluded: parts of a model beyond its tapes; the decision when to compile.

mod native;
mod schedule;
mod series;
mod thunks;
mod translate;

use std::sync::Arc;

use crate::evaluate::Inputs;
use crate::{Table, Tape};

pub use native::is_available;
pub use series::CompiledSeries;

pub(crate) use native::{Again, Regions};
pub(crate) use series::SeriesRoom;

use crate::straight::Straight;
use native::Code;

/// A tape as machine code: evaluation allocates nothing and may run on any number of threads.
#[derive(Debug)]
pub struct CompiledTape {
    code: Arc<Code>,
    results: usize,
}

impl CompiledTape {
    /// Compiles a tape. Returns `None` if the target has no backend, or if the tape breaks the
    /// rules of models.
    #[must_use]
    pub fn new(tape: &Tape, tables: &Arc<[Table]>) -> Option<Self> {
        Self::with_lanes(tape, tables, 1)
    }

    pub(crate) fn with_lanes(tape: &Tape, tables: &Arc<[Table]>, lanes: usize) -> Option<Self> {
        let straight = Straight::of_tape(tape, tables.len())?;
        let code = Arc::new(Code::new(&straight, tables, lanes)?);
        Some(Self { code, results: tape.results.len() * lanes })
    }

    /// Writes the tape's results.
    ///
    /// # Panics
    /// If `results` is not as long as the tape's results, or if `inputs` lack an entry that the
    /// tape reads.
    #[inline(always)]
    pub fn evaluate(&self, inputs: &Inputs<'_>, results: &mut [f64]) {
        let Inputs { ref time, state, parameters, handed, constants, motion, .. } = *inputs;
        let time = std::slice::from_ref(time);
        self.run(&Regions { time, state, parameters, handed, constants, motion }, results);
    }

    #[inline(always)]
    pub(crate) fn run(&self, read: &Regions<'_>, results: &mut [f64]) {
        assert_eq!(results.len(), self.results, "one place for each result");
        self.code.run(read, results);
    }

    /// Prepares further calls with the same lengths as these; see [`Again::new`].
    pub(crate) fn again(&self, read: &Regions<'_>) -> Option<Again> {
        Again::new(&self.code, read, self.results)
    }
}
