//! What of a matrix is not zero, row by row.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

/// A square matrix of which most is zero.
pub(super) struct SparseRows {
    rows: Vec<Vec<(usize, f64)>>,
}

impl SparseRows {
    /// The nonzeros of a full matrix.
    pub(super) fn of(matrix: &DMatrix<f64>) -> Self {
        let mut rows = vec![Vec::new(); matrix.nrows()];
        for (column, entries) in matrix.column_iter().enumerate() {
            for (row, entry) in entries.iter().enumerate().filter(|(_, entry)| **entry != 0.0) {
                rows[row].push((column, *entry));
            }
        }
        Self { rows }
    }

    /// (column, entry) of a row, ascending.
    pub(super) fn row(&self, row: usize) -> &[(usize, f64)] {
        &self.rows[row]
    }

    /// A x.
    pub(super) fn times(&self, vector: &DVector<Complex64>) -> DVector<Complex64> {
        let row = |row: usize| self.rows[row].iter().map(|(at, entry)| vector[*at] * *entry).sum();
        DVector::from_fn(self.rows.len(), |index, _| row(index))
    }

    /// The square root of the sum of all squares.
    pub(super) fn norm(&self) -> f64 {
        self.rows.iter().flatten().map(|(_, entry)| entry * entry).sum::<f64>().sqrt()
    }
}
