//! Intermediate results of the motion that several functions need, computed by one tape, and
//! matrices that are solved for with its factors.

use machinist_contract::Real;
use machinist_contract::implicit::{LANES, Step, substitute};
use serde::{Deserialize, Serialize};

use crate::Tape;

/// A tape that runs before those of other functions. It computes accelerations, factors of the mass
/// matrix, sines and cosines once for all of them. Other tapes read its k-th result as
/// [`Op::Motion`](crate::Op::Motion).
///
/// Only machines for which it pays have one; in small machines each function is complete by itself.
/// The rate always is.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Motion {
    /// A function of time, state and parameters.
    pub tape: Tape,
    /// Results that are the factors for the steps of a [`Solve`].
    pub factors: Vec<u32>,
}

/// A matrix of derivatives, some entries of which are solved for by the factors of the motion with
/// [`substitute`]. The results of the matrix's tape are then first the given entries, then the
/// right-hand sides.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Solve {
    /// Rows that the steps work on.
    pub rows: u32,
    /// Columns that are solved for.
    pub columns: u32,
    /// Steps of the substitution, in order.
    pub steps: Vec<SolveStep>,
    /// Entries of the pattern that the first results of the tape give.
    pub given: Vec<u32>,
    /// (row, column) of the right-hand side that each other result of the tape gives, sorted by
    /// column.
    pub right_sides: Vec<(u32, u32)>,
    /// (entry of the pattern, row, column) of the entries taken from the solution, sorted by
    /// column.
    pub solved: Vec<(u32, u32, u32)>,
}

/// `x_row = scale x_row - sum of factor x_from`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct SolveStep {
    /// The row that changes.
    pub row: u32,
    /// Factor by which the row is scaled before, if any.
    pub scale: Option<u32>,
    /// (factor, other row) of each product.
    pub terms: Vec<(u32, u32)>,
}

impl SolveStep {
    /// Returns the step as the contract takes it.
    #[must_use]
    pub fn borrowed(&self) -> Step<'_> {
        Step { row: self.row, scale: self.scale, terms: &self.terms }
    }
}

impl Solve {
    /// Returns the number of results of the matrix's tape.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.given.len() + self.right_sides.len()
    }

    /// Writes the matrix from `factors` and the results of its tape; `work` has a place for each
    /// row.
    ///
    /// # Panics
    /// If any slice is shorter than the steps and entries require.
    pub fn write<R: Real>(
        &self,
        factors: &[R],
        inputs: &[R],
        work: &mut [[R; LANES]],
        values: &mut [R],
    ) {
        let (given, right_sides) = inputs.split_at(self.given.len());
        for (&entry, &value) in self.given.iter().zip(given) {
            values[entry as usize] = value;
        }
        let mut right_sides = self.right_sides.iter().zip(right_sides).peekable();
        let mut solved = self.solved.iter().peekable();
        for first in (0..self.columns).step_by(LANES) {
            let end = first + LANES as u32;
            work.fill([R::literal(0.0); LANES]);
            while let Some((&(row, column), &value)) =
                right_sides.next_if(|((_, column), _)| *column < end)
            {
                work[row as usize][(column - first) as usize] = value;
            }
            substitute(self.steps.iter().map(SolveStep::borrowed), factors, work);
            while let Some(&(entry, row, column)) = solved.next_if(|(_, _, column)| *column < end) {
                values[entry as usize] = work[row as usize][(column - first) as usize];
            }
        }
    }
}
