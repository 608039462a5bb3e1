//! Least-norm solutions of equations with few unknowns each, apart from a few unknowns that occur
//! in many.

use nalgebra::{DMatrix, DVector};

use super::super::sparse_rows::SparseRows;
use super::null_space::NullSpace;

/// Maximum number of unknowns that occur in many equations.
const MANY: usize = 8;
/// Number of iterative refinements.
const REFINEMENTS: usize = 3;

/// Least-norm least-squares solution x of J x = r, where J = \[P V\] with short rows of P and a few
/// columns of V:
///
/// ```text
/// x_P = P^+ (r - V s)       L^T V s = L^T r       L: what P^T takes to nothing
/// ```
///
/// and, of all such s, the one that minimizes x.
pub(in crate::linear_analysis) struct LeastSquares {
    columns: usize,
    /// P by rows, with columns numbered as in `short`, which contains their indices in J.
    rows: Vec<Vec<(usize, f64)>>,
    short: Vec<usize>,
    /// V, and the indices of its columns in J. Other columns are zero.
    long: DMatrix<f64>,
    places: Vec<usize>,
    right: NullSpace,
    left: NullSpace,
    limit: f64,
}

impl LeastSquares {
    /// Prepares a matrix; `None` if it does not have this form. Singular values below `limit` count
    /// as zero.
    pub(in crate::linear_analysis) fn new(jacobian: &SparseRows, limit: f64) -> Option<Self> {
        let (count, columns) = (jacobian.rows(), jacobian.columns());
        if count < super::FEW {
            return None;
        }
        let mut by_columns = vec![Vec::new(); columns];
        for (row, entries) in jacobian.iter().enumerate() {
            for (column, entry) in entries {
                by_columns[*column].push((row, *entry));
            }
        }
        let (mut short, mut places) = (Vec::new(), Vec::new());
        let (mut rows, mut transposed) = (vec![Vec::new(); count], Vec::new());
        for (column, entries) in by_columns.iter().enumerate() {
            if entries.len() * super::SLENDER > count {
                places.push(column);
            } else if !entries.is_empty() {
                for (row, entry) in entries {
                    rows[*row].push((short.len(), *entry));
                }
                short.push(column);
                transposed.push(entries.clone());
            }
        }
        if places.len() > MANY {
            return None;
        }
        let right = NullSpace::of(short.len(), &rows, limit)?;
        let left = NullSpace::of(count, &transposed, limit)?;
        let mut long = DMatrix::zeros(count, places.len());
        for (mut column, place) in long.column_iter_mut().zip(&places) {
            for (row, entry) in &by_columns[*place] {
                column[*row] = *entry;
            }
        }
        Some(Self { columns, rows, short, long, places, right, left, limit })
    }

    /// Returns whether the least-squares solution is unique.
    pub(in crate::linear_analysis) fn is_determined(&self) -> bool {
        let rank = self.long_across().map_or(0, |across| across.rank(self.limit));
        self.right.vectors.is_empty() && self.short.len() + rank == self.columns
    }

    /// Returns the solution of least norm.
    pub(in crate::linear_analysis) fn solve(
        &self,
        right_side: &DVector<f64>,
    ) -> Option<DVector<f64>> {
        let mut of_short = self.of_short(right_side);
        let mut whole = DVector::zeros(self.columns);
        if let Some(across) = self.long_across() {
            let followed: Vec<_> = self
                .long
                .column_iter()
                .map(|column| -self.of_short(&column.into_owned()))
                .collect();
            let followed = DMatrix::from_columns(&followed);
            let wanted = DVector::from_iterator(
                self.left.vectors.len(),
                self.left.vectors.iter().map(|vector| vector.dot(right_side)),
            );
            let count = self.places.len();
            // Rows of zeros ensure that all directions of s are among the singular vectors.
            let size = across.nrows().max(count);
            let svd = across.resize(size, count, 0.0).svd(true, true);
            let decided = svd.solve(&wanted.resize_vertically(size, 0.0), self.limit).ok()?;
            let open: Vec<usize> =
                (0..count).filter(|k| svd.singular_values[*k] <= self.limit).collect();
            let open = svd.v_t?.select_rows(&open).transpose();
            let moved = &followed * &open;
            let metric = moved.tr_mul(&moved) + open.tr_mul(&open);
            let before = &of_short + &followed * &decided;
            let back = moved.tr_mul(&before) + open.tr_mul(&decided);
            let long = decided - &open * metric.cholesky()?.solve(&back);
            of_short += followed * &long;
            self.places.iter().zip(&long).for_each(|(place, value)| whole[*place] = *value);
        }
        self.short.iter().zip(&of_short).for_each(|(place, value)| whole[*place] = *value);
        whole.iter().all(|value| value.is_finite()).then_some(whole)
    }

    /// Returns L^T V; `None` if there is no V.
    fn long_across(&self) -> Option<DMatrix<f64>> {
        let left = &self.left.vectors;
        (!self.places.is_empty()).then(|| {
            DMatrix::from_fn(left.len(), self.places.len(), |row, column| {
                left[row].dot(&self.long.column(column))
            })
        })
    }

    /// Returns P^+ b by the corrected seminormal equations (Bjorck, Linear Algebra Appl. 88/89,
    /// 1987).
    fn of_short(&self, b: &DVector<f64>) -> DVector<f64> {
        let b = self.left.across(b.clone());
        let mut x = DVector::zeros(self.short.len());
        for _ in 0..=REFINEMENTS {
            let mut pulled = DVector::zeros(x.len());
            for (row, b) in self.rows.iter().zip(&b) {
                let known: f64 = row.iter().map(|(column, entry)| entry * x[*column]).sum();
                for (column, entry) in row {
                    pulled[*column] += entry * (b - known);
                }
            }
            x = self.right.across(x + self.right.solve(&pulled));
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns `parts` chains, joined to the ground if `is_held`, and `long` unknowns in every
    /// equation.
    fn matrix(size: usize, is_held: bool, long: usize, parts: usize) -> DMatrix<f64> {
        DMatrix::from_fn(size, size + long, |row, column| {
            let part = |index: usize| index * parts / size;
            let (a, b) = (row.min(column), row.max(column));
            match column.checked_sub(size) {
                Some(k) if k + 1 < long => (1.3 * (row * (k + 2)) as f64).sin(),
                None if row == column => {
                    let end = |other: usize| usize::from(other < size && part(other) == part(row));
                    let others = end(row.wrapping_sub(1)) + end(row + 1);
                    others as f64 + if is_held && row == 3 { 0.7 } else { 0.0 }
                }
                None if b == a + 1 && part(a) == part(b) => -1.0,
                // The last of the long unknowns is in no equation.
                _ => 0.0,
            }
        })
    }

    #[test]
    fn least_solutions_are_those_of_singular_values() {
        for (size, is_held, long, parts) in [
            (60, true, 0, 1),
            (60, false, 0, 1),
            (70, false, 1, 1),
            (70, false, 2, 1),
            (70, false, 4, 1),
            (90, false, 3, 3),
            (90, true, 3, 2),
            (90, false, 0, 3),
        ] {
            let matrix = matrix(size, is_held, long, parts);
            let least = LeastSquares::new(&SparseRows::of(&matrix), 1e-10).expect("short rows");
            let svd = matrix.clone().svd(true, true);
            assert_eq!(least.is_determined(), svd.rank(1e-10) == matrix.ncols());
            let right_side = DVector::from_fn(size, |row, _| (0.7 * row as f64).cos());
            let expected = svd.solve(&right_side, 1e-10).expect("both sides");
            let found = least.solve(&right_side).expect("finite");
            let off = (&found - &expected).norm() / expected.norm();
            assert!(off < 1e-10, "{size} {is_held} {long} {parts}: {off:e}");
        }
        let full = DMatrix::from_fn(60, 60, |row, column| ((row * column) as f64).sin());
        assert!(LeastSquares::new(&SparseRows::of(&full), 1e-10).is_none());
    }
}
