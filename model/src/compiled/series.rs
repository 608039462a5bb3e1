//! Taylor recurrences as machine code.
//!
//! What an order costs is known before the run: a program computes zeroth coefficients and
//! what of them all orders read (inverses, factors of the mass matrix); another computes
//! the coefficients of one order from the newest ones, which stay in registers, and from
//! sums over the older ones. The factors of those sums stand in rows, an order a row, so
//! that the sums of all products are formed side by side.

mod factors;
mod lowering;

use std::sync::Arc;

use super::native::{Code, Regions};
use crate::Table;
use crate::evaluate::Inputs;
use crate::series::TaylorTape;
use lowering::{Lowered, Orders};

/// Numbers of an order: 1/k, k, 1/(k + 1), and the coefficient of time.
const NUMBERS: usize = 4;

/// Which sums there are.
#[derive(Debug, Clone, Copy)]
struct Sums {
    /// Sums of products of series.
    products: usize,
    /// Products with what is linear in time: `L_1 R_(k-1)`.
    lines: usize,
}

impl Sums {
    /// Numbers that factors of one side take in a row.
    fn lanes(&self) -> usize {
        self.products + self.lines
    }

    /// Numbers of a row: left factors, right factors, the next coefficients of the state,
    /// and sums, of which vectors may write one more than there are.
    fn row(&self, states: usize) -> usize {
        2 * self.lanes() + states + self.lanes() + 1
    }
}

/// What machine code of recurrences asks for, told without making it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SeriesRoom {
    /// Zeroth coefficients and what follows from them.
    constants: usize,
    /// Numbers of an order.
    row: usize,
}

impl SeriesRoom {
    /// That of recurrences with so many tables. `None` where they are too long to be written out.
    pub(crate) fn of(tape: &TaylorTape, tables: usize) -> Option<Self> {
        Lowered::new(tape, Orders::First, tables).map(|lowered| Self::of_lowered(tape, &lowered))
    }

    fn of_lowered(tape: &TaylorTape, lowered: &Lowered) -> Self {
        Self { constants: lowered.constants, row: lowered.sums.row(tape.rate.len()) }
    }

    /// Numbers of workspace for series up to an order.
    pub(crate) fn numbers(self, order: usize) -> usize {
        self.constants + order.max(1) * self.row
    }
}

/// Recurrences as machine code: evaluating them allocates nothing, from any number of
/// threads.
#[derive(Debug)]
pub struct CompiledSeries {
    zeroth: Code,
    /// For the first two orders, and for those behind them.
    higher: [Code; 2],
    states: usize,
    room: SeriesRoom,
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
            room: SeriesRoom::of_lowered(tape, &first),
            sums: first.sums,
            lanes,
        })
    }

    /// Numbers of workspace for series up to an order.
    #[must_use]
    pub fn workspace(&self, order: usize) -> usize {
        self.room.numbers(order)
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
        // Row 0 has nothing but the coefficients of order one; those of an order stand in
        // the row before, and are copied when they are long written.
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

    /// The sums of the first two orders. Of order one there are no products, of order two
    /// there is one, of the row of order one.
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

/// Orders whose numbers are known beforehand.
const KNOWN: usize = 48;

/// Of numbers of one lane, then of two.
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

/// The numbers of an order, once for each lane.
const fn numbers(order: usize, lanes: usize) -> [f64; 2 * NUMBERS] {
    let k = order as f64;
    let time = if order == 1 { 1.0 } else { 0.0 };
    let [a, b, c, d] = [1.0 / k, k, 1.0 / (k + 1.0), time];
    if lanes == 1 { [a, b, c, d, 0.0, 0.0, 0.0, 0.0] } else { [a, a, b, b, c, c, d, d] }
}
