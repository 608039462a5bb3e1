//! Eigenvectors by inverse iteration on the Hessenberg form A = Q H Q^T (Golub and Van Loan, Matrix
//! Computations, section 7.6.1): factoring H - s I takes n^2 operations, A - s I would take n^3 for
//! each eigenvalue.

use nalgebra::linalg::Hessenberg;
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

/// Number of solutions per eigenvalue; the second is the last that changes digits.
const ITERATIONS: usize = 4;

/// A matrix prepared for inverse iteration.
pub(super) struct InverseIteration {
    norm: f64,
    /// Q, orthogonal.
    basis: DMatrix<f64>,
    /// H, zero below the first subdiagonal.
    hessenberg: DMatrix<f64>,
}

impl InverseIteration {
    pub(super) fn new(matrix: &DMatrix<f64>) -> Self {
        let norm = matrix.norm();
        // The Hessenberg form needs at least two rows.
        let (basis, hessenberg) = if matrix.nrows() < 2 {
            (DMatrix::identity(matrix.nrows(), matrix.nrows()), matrix.clone())
        } else {
            Hessenberg::new(matrix.clone()).unpack()
        };
        Self { norm, basis, hessenberg }
    }

    /// Returns right and left vectors of length 1, A x = value x and A^T w = value w, the right one
    /// orthogonal to those already `found` for the same value. `number` determines the start
    /// vector.
    pub(super) fn vectors(
        &self,
        value: Complex64,
        number: usize,
        found: &[&DVector<Complex64>],
    ) -> [DVector<Complex64>; 2] {
        // A small shift off the eigenvalue makes the matrix invertible.
        let shift = value + Complex64::from(8.0 * f64::EPSILON * self.norm);
        let factors = Factors::new(&self.hessenberg, shift, f64::EPSILON * self.norm);
        let across: Vec<_> = found.iter().map(|vector| self.turned(vector, true)).collect();
        let right = self.iterated(number, &across, |vector| factors.solve(vector));
        let left = self.iterated(number, &[], |vector| factors.solve_transposed(vector));
        [right, left].map(|vector| self.turned(&vector, false))
    }

    /// Returns Q x, or Q^T x.
    fn turned(&self, vector: &DVector<Complex64>, back: bool) -> DVector<Complex64> {
        let turn = |part: DVector<f64>| {
            if back { self.basis.tr_mul(&part) } else { &self.basis * part }
        };
        turn(vector.map(|value| value.re))
            .zip_map(&turn(vector.map(|value| value.im)), Complex64::new)
    }

    fn iterated(
        &self,
        number: usize,
        across: &[DVector<Complex64>],
        solve: impl Fn(&mut DVector<Complex64>),
    ) -> DVector<Complex64> {
        let start = |index: usize| (1.0 + (index + 1) as f64 * (number + 2) as f64).cos();
        let size = self.hessenberg.nrows();
        let mut vector = DVector::from_fn(size, |index, _| Complex64::from(start(index)));
        for _ in 0..ITERATIONS {
            let mut next = vector.clone();
            solve(&mut next);
            for other in across {
                let along = other.dotc(&next);
                next.axpy(-along, other, Complex64::ONE);
            }
            let norm = next.norm();
            if !(norm.is_finite() && norm > 0.0) {
                break;
            }
            vector = next.unscale(norm);
        }
        vector
    }
}

/// H - s I = P_0 L_0 P_1 L_1 ... U, where each P_k swaps neighbours or does nothing.
struct Factors {
    /// U.
    upper: DMatrix<Complex64>,
    /// For each k: true if rows k and k + 1 are swapped, and the multiple of row k subtracted from the next.
    steps: Vec<(bool, Complex64)>,
}

impl Factors {
    /// Factors the matrix; pivots smaller than `least` are replaced by it.
    fn new(hessenberg: &DMatrix<f64>, shift: Complex64, least: f64) -> Self {
        let size = hessenberg.nrows();
        let mut upper = DMatrix::zeros(size, size);
        let mut steps: Vec<(bool, Complex64)> = Vec::with_capacity(size);
        let mut entries = vec![Complex64::ZERO; size + 1];
        for column in 0..size {
            let below = (column + 1).min(size - 1);
            for row in 0..=below {
                entries[row] = Complex64::from(hessenberg[(row, column)]);
            }
            entries[column] -= shift;
            for (row, (swapped, factor)) in steps.iter().enumerate() {
                if *swapped {
                    entries.swap(row, row + 1);
                }
                let part = *factor * entries[row];
                entries[row + 1] -= part;
            }
            if column < below {
                let swapped = entries[below].norm_sqr() > entries[column].norm_sqr();
                if swapped {
                    entries.swap(column, below);
                }
                entries[column] = at_least(entries[column], least);
                steps.push((swapped, entries[below] / entries[column]));
            } else {
                entries[column] = at_least(entries[column], least);
            }
            for row in 0..=column {
                upper[(row, column)] = entries[row];
            }
        }
        Factors { upper, steps }
    }

    fn solve(&self, vector: &mut DVector<Complex64>) {
        for (row, (swapped, factor)) in self.steps.iter().enumerate() {
            if *swapped {
                vector.swap_rows(row, row + 1);
            }
            let part = *factor * vector[row];
            vector[row + 1] -= part;
        }
        for column in (0..vector.len()).rev() {
            vector[column] /= self.upper[(column, column)];
            let value = vector[column];
            for row in 0..column {
                vector[row] -= self.upper[(row, column)] * value;
            }
        }
    }

    fn solve_transposed(&self, vector: &mut DVector<Complex64>) {
        for column in 0..vector.len() {
            let known = (0..column).map(|row| self.upper[(row, column)] * vector[row]);
            let known: Complex64 = known.sum();
            vector[column] = (vector[column] - known) / self.upper[(column, column)];
        }
        for (row, (swapped, factor)) in self.steps.iter().enumerate().rev() {
            let part = *factor * vector[row + 1];
            vector[row] -= part;
            if *swapped {
                vector.swap_rows(row, row + 1);
            }
        }
    }
}

fn at_least(pivot: Complex64, least: f64) -> Complex64 {
    if pivot.norm() < least { Complex64::from(least.max(f64::MIN_POSITIVE)) } else { pivot }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_solve_with_the_matrix_and_with_its_transpose() {
        // This matrix has both swapped and unswapped rows.
        let size = 7;
        let hessenberg = DMatrix::from_fn(size, size, |row, column| {
            if row > column + 1 { 0.0 } else { (1.3 * row as f64 + 2.1 * column as f64).sin() }
        });
        let shift = Complex64::new(0.3, -0.7);
        let factors = Factors::new(&hessenberg, shift, 1e-16);
        assert!(factors.steps.iter().any(|(swapped, _)| *swapped));
        assert!(factors.steps.iter().any(|(swapped, _)| !swapped));
        let shifted = hessenberg.map(Complex64::from) - DMatrix::identity(size, size) * shift;
        let wanted = DVector::from_fn(size, |row, _| Complex64::new(row as f64, 1.0));
        let mut plain = &shifted * &wanted;
        factors.solve(&mut plain);
        assert!((plain - &wanted).norm() < 1e-12);
        let mut transposed = shifted.transpose() * &wanted;
        factors.solve_transposed(&mut transposed);
        assert!((transposed - &wanted).norm() < 1e-12);
    }

    #[test]
    fn vectors_are_those_of_a_matrix_that_is_not_normal() {
        let matrix = DMatrix::from_row_slice(3, 3, &[2.0, 5.0, -1.0, 0.0, 3.0, 4.0, 0.0, 0.0, 7.0]);
        let iteration = InverseIteration::new(&matrix);
        let complex = matrix.map(Complex64::from);
        for value in [2.0, 3.0, 7.0].map(Complex64::from) {
            let [right, left] = iteration.vectors(value, 0, &[]);
            assert!((&complex * &right - &right * value).norm() < 1e-13);
            assert!((complex.transpose() * &left - &left * value).norm() < 1e-13);
        }
    }
}
