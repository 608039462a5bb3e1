//! Difference of two Jacobians, entry by entry.

use nalgebra::DMatrix;

use super::worse;

/// Size of rows and columns of a matrix with constraints, relative to its largest entry, below
/// which they are rounding.
const NOTHING: f64 = 1e-12;
/// Lower limit of the reference size of entries of such a matrix, likewise.
const LEAST: f64 = 1e-3;

/// Weights of the entries of a Jacobian.
pub(super) struct Weights<'a> {
    /// Typical sizes of the variables of the rows.
    pub(super) rows: &'a [f64],
    /// Typical sizes of the variables of the columns.
    pub(super) columns: &'a [f64],
    /// True if constraints couple all coordinates.
    pub(super) is_constrained: bool,
    /// y' at the point.
    pub(super) rate: &'a [f64],
}

impl Weights<'_> {
    /// Returns the least reference size of each entry: 1e-2 F_ij, where F_ij is the largest of row
    /// i and column j, weighed by the sizes r of the rows and s of the columns, |B_ik| s_k/s_j and
    /// |B_kj| r_i/r_k. Returns `None` if the numbers of sizes and entries differ.
    ///
    /// 1e-12 of the floor is a hundred roundings of the largest entry, which matters where a dense
    /// mass matrix is solved: by the rotor's angle a motor's rotor currents change by 1e6, and the
    /// stator's, solved together with them, by some tens that such numbers leave. An entry outside
    /// a pattern is zero in A.
    ///
    /// Constraints couple all coordinates, so rounding of other rows enters each row. The floor is
    /// at least [`LEAST`] times the largest entry of B, or the rates over their sizes if these are
    /// larger. It is all of that for a row or column with nothing but rounding, such as those of
    /// the masses of a driven machine.
    pub(super) fn floors(&self, exact: &DMatrix<f64>) -> Option<DMatrix<f64>> {
        let (rows, columns) = (self.rows, self.columns);
        if (rows.len(), columns.len()) != exact.shape() {
            return None;
        }
        let weighed = DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
            exact[(i, j)].abs() * columns[j] / rows[i]
        });
        let largest = |values: &mut dyn Iterator<Item = &f64>| values.copied().fold(0.0, worse);
        let by_row: Vec<f64> = weighed.row_iter().map(|row| largest(&mut row.iter())).collect();
        let by_column: Vec<f64> =
            weighed.column_iter().map(|column| largest(&mut column.iter())).collect();
        let rates = self.rate.iter().zip(rows).map(|(rate, row)| (rate / row).abs());
        let of_all = rates.chain(by_row.iter().copied()).fold(0.0, worse);
        Some(DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
            let is_nothing = by_row[i].min(by_column[j]) <= NOTHING * of_all;
            let size = if self.is_constrained && is_nothing {
                of_all
            } else if self.is_constrained {
                worse(1e-2 * worse(by_row[i], by_column[j]), LEAST * of_all)
            } else {
                1e-2 * worse(by_row[i], by_column[j])
            };
            size * rows[i] / columns[j]
        }))
    }
}

/// Returns |A_ij - B_ij|/max(|B_ij|, floor) of every entry; no error over no scale if both are
/// zero, as for a saturated load.
pub(super) fn distances<'a>(
    ours: &'a DMatrix<f64>,
    exact: &'a DMatrix<f64>,
    floors: &'a DMatrix<f64>,
) -> impl Iterator<Item = ((usize, usize), f64)> + 'a {
    let entries = (0..exact.nrows()).flat_map(|i| (0..exact.ncols()).map(move |j| (i, j)));
    entries.map(|entry| {
        let (a, b) = (ours[entry], exact[entry]);
        let distance = (a - b).abs();
        let error = if distance == 0.0 { 0.0 } else { distance / b.abs().max(floors[entry]) };
        (entry, error)
    })
}

/// Returns the largest of [`distances`]; NaN if the shapes differ.
pub(super) fn matrix_error(
    ours: &DMatrix<f64>,
    exact: &DMatrix<f64>,
    weights: &Weights<'_>,
) -> f64 {
    match weights.floors(exact) {
        Some(floors) if ours.shape() == exact.shape() => {
            distances(ours, exact, &floors).map(|(_, error)| error).fold(0.0, worse)
        }
        _ => f64::NAN,
    }
}
