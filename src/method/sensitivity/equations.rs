//! The variational equations S' = J S + df/dp, as sums over the nonzeros of J.

use std::ops::Range;

use machinist_contract::{Real, SparsityPattern};

use crate::method::vectors::Work;

/// Where the nonzeros of J and df/dp stand in S and S', whose entries stand at
/// `state * directions + direction`.
pub(crate) struct Equations {
    directions: usize,
    /// Rows of J, one for each state: where they begin in S', and their entries.
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
        let mut first = 0;
        let row = |index: usize| {
            let entries = jacobian.entries[first..].iter();
            let from = first;
            first += entries.take_while(|entry| entry.0 as usize == index).count();
            (index * count, from..first)
        };
        let rows = (0..jacobian.rows).map(row).collect();
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

    /// Writes df/dp of the directions where it is not zero, from dy'/dp.
    pub(super) fn drive(&self, by_parameters: &[f64], into: &mut [f64]) {
        for (entry, place) in &self.driven {
            into[*place] = by_parameters[*entry];
        }
    }

    /// J S + df/dp, as many directions at once as registers hold.
    #[inline(always)]
    pub(crate) fn rate(&self, of: Linear<'_>, tangents: &[f64], into: &mut [f64]) {
        let mut first = 0;
        while first < self.directions {
            let of = (of.0, &of.1[first..]);
            let (s, into) = (&tangents[first..], &mut into[first..]);
            first += match self.directions - first {
                10.. => self.rate_of::<10>(of, s, into),
                6.. => self.rate_of::<6>(of, s, into),
                4.. => self.rate_of::<4>(of, s, into),
                2.. => self.rate_of::<2>(of, s, into),
                _ => self.rate_of::<1>(of, s, into),
            };
        }
    }

    /// J S + df/dp in the first directions of every row; so many.
    #[inline(always)]
    fn rate_of<const N: usize>(
        &self,
        (jacobian, drive): Linear<'_>,
        s: &[f64],
        into: &mut [f64],
    ) -> usize {
        for (row, entries) in &self.rows {
            let Some(drive) = first_of(drive, *row) else { break };
            let Some(into) = into.get_mut(*row..).and_then(<[f64]>::first_chunk_mut::<N>) else {
                break;
            };
            let mut sum = *drive;
            let entries = self.columns[entries.clone()].iter().zip(&jacobian[entries.clone()]);
            for (column, value) in entries {
                let Some(tangents) = first_of::<N>(s, *column) else { break };
                for (sum, tangent) in sum.iter_mut().zip(tangents) {
                    *sum = Real::mul_add(*value, *tangent, *sum);
                }
            }
            *into = sum;
        }
        N
    }
}

/// Values of J, and df/dp.
pub(crate) type Linear<'a> = (&'a [f64], &'a [f64]);

/// So many numbers from a place on.
#[inline(always)]
fn first_of<const N: usize>(numbers: &[f64], place: usize) -> Option<&[f64; N]> {
    numbers.get(place..)?.first_chunk()
}

/// J S + df/dp.
pub(super) struct Product<'a> {
    pub(super) equations: &'a Equations,
    pub(super) of: Linear<'a>,
    pub(super) tangents: &'a [f64],
    pub(super) into: &'a mut [f64],
}

impl Work for Product<'_> {
    type Result = ();
    #[inline(always)]
    fn run(self) {
        self.equations.rate(self.of, self.tangents, self.into);
    }
}
