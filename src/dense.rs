//! Full matrices from sparsity patterns, and their balancing to rows and columns of similar size,
//! so that small eigenvalues are found beside large ones.

use machinist_contract::SparsityPattern;
use nalgebra::DMatrix;
#[cfg(any(feature = "implicit", feature = "linear"))]
use nalgebra::{DVector, linalg::balancing::balance_parlett_reinsch};

/// Returns the full matrix of a pattern and its values.
///
/// # Panics
/// If an entry lies outside the matrix.
#[must_use]
pub fn dense(pattern: SparsityPattern<'_>, values: &[f64]) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(pattern.rows, pattern.columns);
    for (&(row, column), &value) in pattern.entries.iter().zip(values) {
        matrix[(row as usize, column as usize)] = value;
    }
    matrix
}

/// Replaces A by D^-1 A D and returns the scales D, powers of 2 after Parlett and Reinsch.
///
/// Leaves a matrix unchanged if squares of its entries are not finite: nalgebra's loop over its
/// rows would not end.
#[cfg(any(feature = "implicit", feature = "linear"))]
pub(crate) fn balance(matrix: &mut DMatrix<f64>) -> DVector<f64> {
    const LARGEST: f64 = 1e150;
    if matrix.iter().all(|entry| entry.abs() <= LARGEST) {
        balance_parlett_reinsch(matrix)
    } else {
        DVector::from_element(matrix.nrows(), 1.0)
    }
}

#[cfg(all(test, any(feature = "implicit", feature = "linear")))]
mod tests {
    use super::*;

    #[test]
    fn entries_beyond_what_can_be_squared_are_left_and_others_balanced() {
        for large in [1e245, f64::INFINITY, f64::NAN] {
            let mut matrix = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, large, -large]);
            assert_eq!(balance(&mut matrix), DVector::from_element(2, 1.0));
        }
        let mut matrix = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 1e140, 0.0]);
        let scales = balance(&mut matrix);
        assert!(scales[1] / scales[0] > 1e60, "{scales}");
        let ratio = matrix[(0, 1)] / matrix[(1, 0)];
        assert!((0.1..10.0).contains(&ratio), "{matrix}");
    }
}
