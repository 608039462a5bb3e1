//! Taylor recurrences as machine code.
//!
//! The cost of an order is known before the run. One program computes the zeroth coefficients and
//! the values derived from them that all orders read (inverses, factors of the mass matrix).
//! Another computes the coefficients of one order from the newest ones, which stay in registers,
//! and from sums over the older ones. The factors of those sums are stored in rows, one for each
//! order, so that the sums of all products are formed in lanes.

mod factors;
mod lowering;

use std::sync::Arc;

use super::native::{Code, Regions};
use crate::Table;
use crate::evaluate::Inputs;
use crate::series::TaylorTape;
use lowering::{Lowered, Orders};

/// Number of the values of an order: 1/k, k, 1/(k + 1), and the coefficient of time.
const NUMBERS: usize = 4;

/// Numbers of sums.
#[derive(Debug, Clone, Copy)]
struct Sums {
    /// Number of sums of products of series.
    products: usize,
    /// Number of products with series linear in time: `L_1 R_(k-1)`.
    lines: usize,
}

impl Sums {
    /// Returns the number of factors of one side in a row.
    fn lanes(&self) -> usize {
        self.products + self.lines
    }

    /// Returns the length of a row: left factors, right factors, the next coefficients of the
    /// state, and sums, of which vectors may write one more than needed.
    fn row(&self, states: usize) -> usize {
        2 * self.lanes() + states + self.lanes() + 1
    }
}

/// Workspace of machine code of recurrences, computed without compiling it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SeriesRoom {
    /// Number of zeroth coefficients and values derived from them.
    constants: usize,
    /// Length of a row.
    row: usize,
}

impl SeriesRoom {
    /// Computes the workspace of recurrences with `tables` tables. Returns `None` if they are too
    /// long to be compiled.
    pub(crate) fn of(tape: &TaylorTape, tables: usize) -> Option<Self> {
        Lowered::new(tape, Orders::First, tables).map(|lowered| Self::of_lowered(tape, &lowered))
    }

    fn of_lowered(tape: &TaylorTape, lowered: &Lowered) -> Self {
        Self { constants: lowered.constants, row: lowered.sums.row(tape.rate.len()) }
    }

    /// Returns the length of the workspace for series up to an order.
    pub(crate) fn numbers(self, order: usize) -> usize {
        self.constants + order.max(1) * self.row
    }
}

/// Recurrences as machine code: evaluation allocates nothing and may run on any number of threads.
#[derive(Debug)]
pub struct CompiledSeries {
    zeroth: Code,
    /// For the first two orders, and for later ones.
    higher: [Code; 2],
    states: usize,
    room: SeriesRoom,
    sums: Sums,
    lanes: usize,
}

impl CompiledSeries {
    /// Compiles recurrences. Returns `None` if the target has no backend, or if they are too long
    /// to be compiled.
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
            room: SeriesRoom::of_lowered(tape, &first),
            sums: first.sums,
            lanes,
        })
    }

    /// Returns the length of the workspace for series up to an order.
    #[must_use]
    pub fn workspace(&self, order: usize) -> usize {
        self.room.numbers(order)
    }

    /// Writes normalized coefficients of the solution, order by order, each as long as the state.
    /// The length of `coefficients` determines the highest order.
    ///
    /// # Panics
    /// If `coefficients` is shorter than the state, if `workspace` is shorter than
    /// [`CompiledSeries::workspace`], or if `inputs` lack an entry that is read.
    pub fn evaluate(&self, inputs: &Inputs<'_>, coefficients: &mut [f64], workspace: &mut [f64]) {
        let Inputs { ref time, state, parameters, handed, .. } = *inputs;
        let time = std::slice::from_ref(time);
        let read = Regions { time, state, parameters, handed, constants: &[], motion: &[] };
        self.run(&read, coefficients, workspace);
    }

    pub(crate) fn run(&self, read: &Regions<'_>, coefficients: &mut [f64], workspace: &mut [f64]) {
        let states = self.states * self.lanes;
        coefficients[..states].copy_from_slice(&read.state[..states]);
        let orders = coefficients.len() / states.max(1);
        if orders < 2 {
            return;
        }
        let [row, kept, lanes] =
            [self.room.row, self.room.constants, self.sums.lanes()].map(|count| count * self.lanes);
        let (constants, rows) = workspace.split_at_mut(kept);
        // Row 0 holds only the coefficients of order one. The coefficients of an order are in the
        // row before it, and are copied long after they were written.
        let next = 2 * lanes..2 * lanes + states;
        self.zeroth.run(read, constants);
        rows[next.clone()].copy_from_slice(&constants[kept - states..]);
        for order in 1..orders - 1 {
            let (known, newest) = rows[..(order + 1) * row].split_at_mut(order * row);
            let first = if order < 3 {
                self.first_sums(order, known, &mut newest[next.end..]);
                &[][..]
            } else {
                &known[row..]
            };
            let far;
            let numbers = if let Some(known) = KNOWN_NUMBERS[self.lanes - 1].get(order) {
                known
            } else {
                far = numbers(order, self.lanes);
                &far
            };
            let last = &known[(order - 1) * row..];
            let read =
                Regions { time: numbers, state: last, parameters: first, constants, ..*read };
            self.higher[usize::from(order > 2)].run(&read, newest);
        }
        let rows = rows.chunks_exact(row);
        for (coefficients, row) in coefficients.chunks_exact_mut(states).skip(1).zip(rows) {
            coefficients.copy_from_slice(&row[next.clone()]);
        }
    }

    /// Computes the sums of the first two orders. Order one has no products, order two has one, of
    /// the row of order one.
    fn first_sums(&self, order: usize, rows: &[f64], sums: &mut [f64]) {
        let lanes = self.sums.lanes() * self.lanes;
        if order < 2 {
            return sums.fill(0.0);
        }
        let newest = &rows[rows.len() / 2..];
        let (left, right) = newest[..2 * lanes].split_at(lanes);
        for (sum, (left, right)) in sums.iter_mut().zip(left.iter().zip(right)) {
            *sum = left * right;
        }
    }
}

/// Number of orders whose numbers are tabulated.
const KNOWN: usize = 48;

/// Tabulated numbers, for one lane, then for two.
static KNOWN_NUMBERS: [[[f64; 2 * NUMBERS]; KNOWN]; 2] = {
    let mut known = [[[0.0; 2 * NUMBERS]; KNOWN]; 2];
    let mut order = 1;
    while order < KNOWN {
        known[0][order] = numbers(order, 1);
        known[1][order] = numbers(order, 2);
        order += 1;
    }
    known
};

/// Returns the numbers of an order, each once for each lane.
const fn numbers(order: usize, lanes: usize) -> [f64; 2 * NUMBERS] {
    let k = order as f64;
    let time = if order == 1 { 1.0 } else { 0.0 };
    let [a, b, c, d] = [1.0 / k, k, 1.0 / (k + 1.0), time];
    if lanes == 1 { [a, b, c, d, 0.0, 0.0, 0.0, 0.0] } else { [a, a, b, b, c, c, d, d] }
}
