//! The variational equations S' = J S + df/dp, as sums over the nonzeros of J.

use std::ops::Range;

use machinist_contract::{Real, SparsityPattern};

use crate::method::vectors::Work;

/// Positions of the nonzeros of J and df/dp in S and S', whose entries are at `state * directions +
/// direction`.
pub(crate) struct Equations {
    directions: usize,
    /// Rows of J, one for each state: where they begin in S', and their entries.
    rows: Vec<(usize, Range<usize>)>,
    /// Start of the row of S that an entry of J is multiplied with.
    columns: Vec<usize>,
    /// (place among the values, place in S') of entries of dy'/dp of the parameters among the
    /// directions.
    driven: Vec<(usize, usize)>,
    /// See [`Equations::values`].
    values: usize,
}

impl Equations {
    /// Returns the equations for a J and a dy'/dp with these nonzeros; `directions` gives the
    /// parameter of each direction, if any.
    pub(super) fn new(
        jacobian: SparsityPattern<'_>,
        by_parameters: SparsityPattern<'_>,
        directions: &[Option<usize>],
    ) -> Self {
        let count = directions.len();
        let nonzeros = jacobian.entries.len();
        let mut driven = Vec::new();
        for (entry, (row, column)) in by_parameters.entries.iter().enumerate() {
            for (direction, parameter) in directions.iter().enumerate() {
                if *parameter == Some(*column as usize) {
                    driven.push((nonzeros + entry, *row as usize * count + direction));
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
        let values = nonzeros + if driven.is_empty() { 0 } else { by_parameters.entries.len() };
        Self { directions: count, rows, columns, driven, values }
    }

    /// Returns the number of values they are made of: nonzeros of J, then those of dy'/dp if any is
    /// requested.
    pub(crate) fn values(&self) -> usize {
        self.values
    }

    /// Returns whether any direction is a parameter that a rate depends on.
    pub(super) fn are_driven(&self) -> bool {
        !self.driven.is_empty()
    }

    /// Writes df/dp of the directions where it is nonzero, from the values.
    pub(super) fn drive(&self, values: &[f64], into: &mut [f64]) {
        for (entry, place) in &self.driven {
            into[*place] = values[*entry];
        }
    }

    /// Computes J S + df/dp, for as many directions at once as registers hold.
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

    /// Computes J S + df/dp in the first `N` directions of every row; returns their number.
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

/// Values that begin with J, and df/dp.
pub(crate) type Linear<'a> = (&'a [f64], &'a [f64]);

/// Returns `N` numbers from a place on.
#[inline(always)]
fn first_of<const N: usize>(numbers: &[f64], place: usize) -> Option<&[f64; N]> {
    numbers.get(place..)?.first_chunk()
}

/// The product J S + df/dp.
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

#[cfg(test)]
mod tests {
    use machinist_contract::SparsityPattern;

    use super::{Equations, Product};
    use crate::method::vectors::widest;

    /// A row of J without entries still has its df/dp; thirteen directions are blocks of several
    /// widths.
    #[test]
    #[allow(clippy::float_cmp, reason = "small whole numbers are exact")]
    fn sums_are_those_of_dense_matrices() {
        let pattern = |entries, columns| SparsityPattern { rows: 3, columns, entries };
        let jacobian = pattern(&[(0, 0), (0, 2), (2, 1)], 3);
        let by_parameters = pattern(&[(0, 1), (1, 0), (1, 1)], 2);
        let directions: Vec<_> = (0..13).map(|k| [None, Some(0), Some(1)][k % 3]).collect();
        let equations = Equations::new(jacobian, by_parameters, &directions);
        // J, then dy'/dp.
        let values = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0];
        let s: Vec<f64> = (0..39).map(f64::from).collect();
        let mut drive = vec![0.0; s.len()];
        assert_eq!(equations.values(), values.len());
        equations.drive(&values, &mut drive);
        let mut found = vec![f64::NAN; s.len()];
        let of = (&values[..], &drive[..]);
        widest(Product { equations: &equations, of, tangents: &s, into: &mut found });
        for (k, by) in directions.iter().enumerate() {
            let [x, y, z] = [s[k], s[13 + k], s[26 + k]];
            let driven = by.map_or([0.0; 3], |by| [[0.0, 11.0, 0.0], [7.0, 13.0, 0.0]][by]);
            let wanted = [2.0 * x + 3.0 * z + driven[0], driven[1], 5.0 * y + driven[2]];
            assert_eq!([found[k], found[13 + k], found[26 + k]], wanted, "direction {k}");
        }
    }
}
