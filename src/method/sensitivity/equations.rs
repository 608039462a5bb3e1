//! The variational equations S' = J S + df/dp, as sums over the nonzeros of J.

use std::ops::Range;

use machinist_contract::{Real, SparsityPattern};

use crate::method::vectors::Work;

/// Where the nonzeros of J and df/dp stand in S and S', whose entries stand at
/// `state * directions + direction`.
pub(crate) struct Equations {
    directions: usize,
    /// Rows of J: where they begin in S', and their entries.
    rows: Vec<(usize, Range<usize>)>,
    /// Where the row of S begins that an entry of J is multiplied with.
    columns: Vec<usize>,
    /// (entry of dy'/dp, place in S') of the parameters among the directions.
    driven: Vec<(usize, usize)>,
}

impl Equations {
    /// Those of a J and a dy'/dp with these nonzeros; `directions` says of each direction which
    /// parameter it is, if any.
    pub(super) fn new(
        jacobian: SparsityPattern<'_>,
        by_parameters: SparsityPattern<'_>,
        directions: &[Option<usize>],
    ) -> Self {
        let count = directions.len();
        let mut driven = Vec::new();
        for (entry, (row, column)) in by_parameters.entries.iter().enumerate() {
            for (direction, parameter) in directions.iter().enumerate() {
                if *parameter == Some(*column as usize) {
                    driven.push((entry, *row as usize * count + direction));
                }
            }
        }
        let columns = jacobian.entries.iter().map(|entry| entry.1 as usize * count).collect();
        let mut rows = Vec::new();
        let mut first = 0;
        for row in jacobian.entries.chunk_by(|a, b| a.0 == b.0) {
            rows.push((row[0].0 as usize * count, first..first + row.len()));
            first += row.len();
        }
        Self { directions: count, rows, columns, driven }
    }

    /// Nonzeros of J.
    pub(crate) fn nonzeros(&self) -> usize {
        self.columns.len()
    }

    /// Whether any direction is a parameter that a rate depends on.
    pub(super) fn are_driven(&self) -> bool {
        !self.driven.is_empty()
    }

    /// Writes df/dp of the directions, from dy'/dp.
    pub(super) fn drive(&self, by_parameters: &[f64], into: &mut [f64]) {
        into.fill(0.0);
        for (entry, place) in &self.driven {
            into[*place] = by_parameters[*entry];
        }
    }

    /// Adds J S, as many directions at once as registers hold.
    #[inline(always)]
    pub(crate) fn add_product(&self, jacobian: &[f64], tangents: &[f64], into: &mut [f64]) {
        let mut first = 0;
        while first < self.directions {
            let (s, into) = (&tangents[first..], &mut into[first..]);
            first += match self.directions - first {
                10.. => self.add_block::<10>(jacobian, s, into),
                6.. => self.add_block::<6>(jacobian, s, into),
                4.. => self.add_block::<4>(jacobian, s, into),
                2.. => self.add_block::<2>(jacobian, s, into),
                _ => self.add_block::<1>(jacobian, s, into),
            };
        }
    }

    /// Adds J S in the first directions of every row; so many.
    #[inline(always)]
    fn add_block<const N: usize>(&self, jacobian: &[f64], s: &[f64], into: &mut [f64]) -> usize {
        for (row, entries) in &self.rows {
            let Some(into) = into.get_mut(*row..).and_then(<[f64]>::first_chunk_mut::<N>) else {
                break;
            };
            let mut sum = *into;
            for (column, value) in
                self.columns[entries.clone()].iter().zip(&jacobian[entries.clone()])
            {
                let Some(tangents) = s.get(*column..).and_then(<[f64]>::first_chunk::<N>) else {
                    break;
                };
                for (sum, tangent) in sum.iter_mut().zip(tangents) {
                    *sum = Real::mul_add(*value, *tangent, *sum);
                }
            }
            *into = sum;
        }
        N
    }
}

/// Adds J S to what stands in S'.
pub(super) struct Product<'a> {
    pub(super) equations: &'a Equations,
    pub(super) jacobian: &'a [f64],
    pub(super) tangents: &'a [f64],
    pub(super) into: &'a mut [f64],
}

impl Work for Product<'_> {
    type Result = ();
    #[inline(always)]
    fn run(self) {
        self.equations.add_product(self.jacobian, self.tangents, self.into);
    }
}
