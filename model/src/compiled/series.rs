//! Taylor recurrences as machine code.
//!
//! What an order costs is known before the run: a program computes zeroth coefficients and
//! what of them all orders read (inverses, factors of the mass matrix); another computes
//! the coefficients of one order from the newest ones, which stay in registers, and from
//! sums over the older ones. The factors of those sums stand in rows, an order a row, so
//! that the sums of all products are formed side by side.

mod lowering;
mod sums;

use std::sync::Arc;

use super::native::{Code, Regions};
use crate::Table;
use crate::evaluate::Inputs;
use crate::series::TaylorTape;
use lowering::{Lowered, Orders};
use sums::Sums;

/// Numbers of an order: 1/k, k, 1/(k + 1), and the coefficient of time.
const NUMBERS: usize = 4;

/// Recurrences as machine code: evaluating them allocates nothing, from any number of
/// threads.
#[derive(Debug)]
pub struct CompiledSeries {
    zeroth: Code,
    /// For the first two orders, and for those behind them.
    higher: [Code; 2],
    states: usize,
    /// Zeroth coefficients and what follows from them.
    constants: usize,
    sums: Sums,
    lanes: usize,
}

impl CompiledSeries {
    /// Compiles recurrences. `None` where the target has no backend, or where they are too
    /// long to be written out.
    #[must_use]
    pub fn new(tape: &TaylorTape, tables: &Arc<[Table]>) -> Option<Self> {
        Self::with_lanes(tape, tables, 1)
    }

    pub(crate) fn with_lanes(
        tape: &TaylorTape,
        tables: &Arc<[Table]>,
        lanes: usize,
    ) -> Option<Self> {
        let first = Lowered::new(tape, Orders::First, tables.len())?;
        let later = Lowered::new(tape, Orders::Later, tables.len())?;
        let code = |program| Code::new(program, tables, lanes);
        Some(Self {
            zeroth: code(&first.zeroth)?,
            higher: [code(&first.higher)?, code(&later.higher)?],
            states: tape.rate.len(),
            constants: first.constants,
            sums: first.sums,
            lanes,
        })
    }

    /// Numbers of a row: left factors, right factors, the next coefficients of the state.
    fn row(&self) -> usize {
        2 * self.sums.lanes() + self.states
    }

    /// Numbers of workspace for series up to an order.
    #[must_use]
    pub fn workspace(&self, order: usize) -> usize {
        self.constants + self.sums.lanes() + order.max(1) * self.row()
    }

    /// Writes normalized coefficients of the solution, order after order, each as long as
    /// the state; the highest order is what there is room for.
    ///
    /// # Panics
    /// If `coefficients` has no room for the state, if `workspace` is shorter than
    /// [`CompiledSeries::workspace`] says, or if `inputs` lack an entry that is read.
    pub fn evaluate(&self, inputs: &Inputs<'_>, coefficients: &mut [f64], workspace: &mut [f64]) {
        let Inputs { ref time, state, parameters, handed, .. } = *inputs;
        let time = std::slice::from_ref(time);
        let read = Regions { time, state, parameters, handed, constants: &[] };
        self.run(&read, coefficients, workspace);
    }

    pub(crate) fn run(&self, read: &Regions<'_>, coefficients: &mut [f64], workspace: &mut [f64]) {
        let states = self.states * self.lanes;
        coefficients[..states].copy_from_slice(&read.state[..states]);
        let orders = coefficients.len() / states.max(1);
        if orders < 2 {
            return;
        }
        let [kept, lanes, row] =
            [self.constants, self.sums.lanes(), self.row()].map(|count| count * self.lanes);
        let (constants, rows) = workspace.split_at_mut(kept + lanes);
        // Row 0 has nothing but the coefficients of order one at its end; those of an order
        // stand at the end of the row before, and are copied when they are long written.
        self.zeroth.run(read, constants);
        rows[2 * lanes..row].copy_from_slice(&constants[kept - states..kept]);
        for order in 1..orders - 1 {
            let (known, newest) = rows[..(order + 1) * row].split_at_mut(order * row);
            self.sums.form(order, known, row, self.lanes, &mut constants[kept..]);
            let numbers = numbers(order, self.lanes);
            let first = if order < 3 { &[][..] } else { &known[row..2 * row] };
            let last = &known[(order - 1) * row..];
            let read =
                Regions { time: &numbers, state: last, parameters: first, constants, ..*read };
            self.higher[usize::from(order > 2)].run(&read, newest);
        }
        let rows = rows.chunks_exact(row);
        for (next, row) in coefficients.chunks_exact_mut(states).skip(1).zip(rows) {
            next.copy_from_slice(&row[2 * lanes..]);
        }
    }
}

/// The numbers of an order, once for each lane.
fn numbers(order: usize, lanes: usize) -> [f64; 2 * NUMBERS] {
    let k = order as f64;
    let time = if order == 1 { 1.0 } else { 0.0 };
    let [a, b, c, d] = [1.0 / k, k, 1.0 / (k + 1.0), time];
    if lanes == 1 { [a, b, c, d, 0.0, 0.0, 0.0, 0.0] } else { [a, a, b, b, c, c, d, d] }
}
