//! In-place factorization of small square matrices, real and complex.

use nalgebra::ComplexField;

use super::vectors::{Work, widest};

/// Error for a matrix with a column without a pivot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Singular;

/// P A = L U by partial pivoting, stored in place of A.
///
/// Columns beyond the last nonzero of a row are not touched, so the cost of a banded matrix is that
/// of its band.
pub(super) struct Lu<S> {
    size: usize,
    /// Entries, row by row.
    entries: Vec<S>,
    /// One past the last column of each row that may be nonzero.
    row_ends: Vec<usize>,
    /// One past the last row of each column that may be nonzero, below the diagonal.
    column_ends: Vec<usize>,
    /// Row exchanged with the k-th one before its elimination.
    pivots: Vec<usize>,
}

impl<S: ComplexField<RealField = f64> + Copy> Lu<S> {
    pub(super) fn new(size: usize) -> Self {
        Self {
            size,
            entries: vec![S::zero(); size * size],
            row_ends: vec![0; size],
            column_ends: vec![0; size],
            pivots: vec![0; size],
        }
    }

    /// Returns the number of rows.
    pub(super) fn size(&self) -> usize {
        self.size
    }

    /// Sets the matrix to zero, for [`Lu::add`].
    pub(super) fn clear(&mut self) {
        self.entries.fill(S::zero());
        self.row_ends.fill(0);
        self.column_ends.fill(0);
    }

    /// Adds to an entry of a matrix that is not factored.
    pub(super) fn add(&mut self, row: usize, column: usize, value: S) {
        self.entries[row * self.size + column] += value;
        self.row_ends[row] = self.row_ends[row].max(column + 1);
        self.column_ends[column] = self.column_ends[column].max(row + 1);
    }

    /// Factors the matrix.
    ///
    /// # Errors
    /// [`Singular`], also where entries are not finite.
    #[inline(always)]
    pub(super) fn factor(&mut self) -> Result<(), Singular> {
        for k in 0..self.size {
            let bottom = self.column_ends[k].max(k + 1);
            let pivot = self.largest_below(k, bottom);
            self.pivots[k] = pivot;
            if pivot != k {
                self.exchange(k, pivot);
            }
            let (above, below) = self.entries.split_at_mut((k + 1) * self.size);
            let end = self.row_ends[k].max(k + 1);
            let pivot_row = &above[k * self.size..][k..end];
            let size = pivot_row[0].norm1();
            if !(size > 0.0 && size.is_finite()) {
                return Err(Singular);
            }
            let inverse = pivot_row[0].recip();
            for (row, row_end) in below
                .chunks_exact_mut(self.size)
                .zip(&mut self.row_ends[k + 1..])
                .take(bottom - k - 1)
            {
                if row[k].is_zero() {
                    continue;
                }
                let factor = row[k] * inverse;
                row[k] = factor;
                for (entry, above) in row[k + 1..end].iter_mut().zip(&pivot_row[1..]) {
                    *entry -= factor * *above;
                }
                *row_end = (*row_end).max(end);
            }
            for column_end in &mut self.column_ends[k + 1..end] {
                *column_end = (*column_end).max(bottom);
            }
        }
        Ok(())
    }

    /// Solves A x = b in place.
    pub(super) fn solve(&self, b: &mut [S]) {
        for (k, &pivot) in self.pivots.iter().enumerate() {
            b.swap(k, pivot);
        }
        for (row, entries) in self.entries.chunks_exact(self.size.max(1)).enumerate() {
            let (known, rest) = b.split_at_mut(row);
            let mut sum = rest[0];
            for (entry, value) in entries.iter().zip(known) {
                sum -= *entry * *value;
            }
            rest[0] = sum;
        }
        for row in (0..self.size).rev() {
            let entries = &self.entries[row * self.size..][row..self.row_ends[row].max(row + 1)];
            let (unknown, known) = b[row..].split_at_mut(1);
            let mut sum = unknown[0];
            for (entry, value) in entries[1..].iter().zip(known) {
                sum -= *entry * *value;
            }
            unknown[0] = sum / entries[0];
        }
    }

    /// Solves A X = B with several columns in place; B is stored row by row.
    pub(super) fn solve_each(&self, b: &mut [S], columns: usize) {
        for (k, &pivot) in self.pivots.iter().enumerate() {
            if pivot != k {
                let (above, below) = b.split_at_mut(pivot * columns);
                above[k * columns..][..columns].swap_with_slice(&mut below[..columns]);
            }
        }
        widest(Substitution { factors: self, b, columns });
    }

    fn largest_below(&self, k: usize, bottom: usize) -> usize {
        let size_of = |row: usize| self.entries[row * self.size + k].norm1();
        let mut best = (k, size_of(k));
        for row in k + 1..bottom {
            let size = size_of(row);
            if size > best.1 {
                best = (row, size);
            }
        }
        best.0
    }

    /// Exchanges whole rows, with the multipliers to their left, so that all exchanges can be made
    /// on the right-hand side beforehand.
    fn exchange(&mut self, upper: usize, lower: usize) {
        let (above, below) = self.entries.split_at_mut(lower * self.size);
        above[upper * self.size..][..self.size].swap_with_slice(&mut below[..self.size]);
        self.row_ends.swap(upper, lower);
    }
}

/// Forward and backward substitution of many columns, as many at once as registers hold.
struct Substitution<'a, S> {
    factors: &'a Lu<S>,
    b: &'a mut [S],
    columns: usize,
}

impl<S: ComplexField<RealField = f64> + Copy> Work for Substitution<'_, S> {
    type Result = ();
    #[inline(always)]
    fn run(self) {
        let Self { factors, b, columns } = self;
        let mut first = 0;
        while first < columns {
            first += match columns - first {
                10.. => factors.substitute::<10>(b, first, columns),
                4.. => factors.substitute::<4>(b, first, columns),
                _ => factors.substitute::<1>(b, first, columns),
            };
        }
    }
}

impl<S: ComplexField<RealField = f64> + Copy> Lu<S> {
    /// Substitutes `N` of the columns; returns how many these are.
    #[inline(always)]
    fn substitute<const N: usize>(&self, b: &mut [S], first: usize, columns: usize) -> usize {
        for (row, entries) in self.entries.chunks_exact(self.size.max(1)).enumerate() {
            let (known, rest) = b.split_at_mut(row * columns);
            let Some(rest) = rest.get_mut(first..).and_then(<[S]>::first_chunk_mut::<N>) else {
                break;
            };
            *rest = subtracted(&entries[..row], known, (first, columns), *rest);
        }
        for row in (0..self.size).rev() {
            let entries = &self.entries[row * self.size..][row..self.row_ends[row].max(row + 1)];
            let (unknown, known) = b[row * columns..].split_at_mut(columns);
            let Some(unknown) = unknown.get_mut(first..).and_then(<[S]>::first_chunk_mut::<N>)
            else {
                break;
            };
            let rest = subtracted(&entries[1..], known, (first, columns), *unknown);
            let inverse = entries[0].recip();
            *unknown = rest.map(|value| value * inverse);
        }
        N
    }
}

/// Returns some columns minus rows times their entries, many of which are zero.
#[inline(always)]
fn subtracted<S: ComplexField + Copy, const N: usize>(
    entries: &[S],
    rows: &[S],
    (first, columns): (usize, usize),
    mut from: [S; N],
) -> [S; N] {
    for (entry, row) in entries.iter().zip(rows.chunks_exact(columns)) {
        if entry.is_zero() {
            continue;
        }
        let Some(row) = row.get(first..).and_then(<[S]>::first_chunk::<N>) else { break };
        for (value, known) in from.iter_mut().zip(row) {
            *value -= *entry * *known;
        }
    }
    from
}

/// Factorization of a matrix of numbers that is large enough for wide vectors.
struct Factorization<'a>(&'a mut Lu<f64>);

impl Work for Factorization<'_> {
    type Result = Result<(), Singular>;
    #[inline(always)]
    fn run(self) -> Result<(), Singular> {
        self.0.factor()
    }
}

impl Lu<f64> {
    /// Does the same as [`Lu::factor`] for a matrix that is large enough for wide vectors.
    ///
    /// # Errors
    /// As for [`Lu::factor`].
    pub(super) fn factor_large(&mut self) -> Result<(), Singular> {
        widest(Factorization(self))
    }

    /// Returns whether the determinant of the factored matrix is negative.
    pub(super) fn is_negative(&self) -> bool {
        let exchanges = self.pivots.iter().enumerate().filter(|(k, pivot)| k != *pivot).count();
        let diagonal = self.entries.iter().step_by(self.size + 1);
        (exchanges + diagonal.filter(|pivot| **pivot < 0.0).count()) % 2 == 1
    }
}

#[cfg(test)]
mod tests {
    use num_complex::Complex64;

    use super::*;

    /// Returns reproducible random entries, a quarter of them 0.
    fn entry(row: usize, column: usize) -> f64 {
        let value = fastrand::Rng::with_seed((row * 1000 + column) as u64).f64();
        if value < 0.25 { 0.0 } else { value - 0.6 }
    }

    #[test]
    fn a_solution_satisfies_its_equations_dense_and_banded_real_and_complex() {
        for size in [1, 2, 3, 8, 40] {
            for band in [1, 2, size] {
                let mut real = Lu::<f64>::new(size);
                let mut complex = Lu::<Complex64>::new(size);
                // The second pass shows that clearing leaves nothing behind.
                for shift in [0, 5] {
                    let value = |row: usize, column: usize| {
                        let near = row.abs_diff(column) <= band;
                        if near { entry(row + shift, column) + 0.01 } else { 0.0 }
                    };
                    let turned =
                        |r: usize, c: usize| Complex64::new(value(r, c), value(c, r) + 0.3);
                    real.clear();
                    complex.clear();
                    for row in 0..size {
                        for column in 0..size {
                            if row.abs_diff(column) <= band {
                                real.add(row, column, value(row, column));
                                complex.add(row, column, turned(row, column));
                            }
                        }
                    }
                    real.factor().unwrap();
                    complex.factor().unwrap();
                    let mut x: Vec<f64> = (0..size).map(|i| entry(i, 99) + 1.0).collect();
                    let b = x.clone();
                    real.solve(&mut x);
                    let mut z: Vec<Complex64> = b.iter().map(|b| Complex64::new(*b, 1.0)).collect();
                    complex.solve(&mut z);
                    let mut each = b.iter().flat_map(|b| [*b, -2.0 * b, 0.0]).collect::<Vec<_>>();
                    real.solve_each(&mut each, 3);
                    for (x, each) in x.iter().zip(each.chunks_exact(3)) {
                        let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * (1.0 + b.abs());
                        assert!(near(each[0], *x) && near(each[1], -2.0 * x) && each[2] == 0.0);
                    }
                    let norm = x.iter().fold(1.0f64, |max, x| max.max(x.abs()));
                    let znorm = z.iter().fold(1.0f64, |max, z| max.max(z.norm()));
                    for (row, &known) in b.iter().enumerate() {
                        let sum: f64 = (0..size).map(|c| value(row, c) * x[c]).sum();
                        assert!((sum - known).abs() < 1e-13 * norm * size as f64);
                        let near = (0..size).filter(|c| row.abs_diff(*c) <= band);
                        let sum: Complex64 = near.map(|c| turned(row, c) * z[c]).sum();
                        let error = (sum - Complex64::new(known, 1.0)).norm();
                        assert!(error < 1e-13 * znorm * size as f64, "{error:e}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_matrix_without_pivot_is_singular() {
        for entries in [[0.0, 0.0, 0.0, 0.0], [1.0, 2.0, 2.0, 4.0], [f64::NAN, 1.0, 1.0, 0.0]] {
            let mut matrix = Lu::<f64>::new(2);
            matrix.clear();
            for (index, entry) in entries.iter().enumerate() {
                matrix.add(index / 2, index % 2, *entry);
            }
            assert_eq!(matrix.factor(), Err(Singular));
        }
    }
}
