//! P A = L U of a banded matrix, with a special method for three diagonals.

use nalgebra::ComplexField;

use crate::method::lu::Singular;

/// A matrix with `width` diagonals on each side. Its entries are stored elsewhere: row i contains
/// the columns from i - width to i + 2 width, which exchanges may fill.
pub(super) struct Band<S> {
    size: usize,
    width: usize,
    pivots: Vec<usize>,
    three: Three<S>,
}

/// Factors of a tridiagonal matrix. U has ones on its diagonal, so each of its rows takes one
/// product and one difference that depend on the row below.
///
/// Without exchanges, both halves are eliminated towards the middle at the same time, since they
/// are independent: below the middle, L and U exchange their roles.
struct Three<S> {
    lower: Vec<S>,
    inverse: Vec<S>,
    upper: Vec<S>,
    /// Second diagonal of U, which exchanges fill.
    second: Vec<S>,
    is_exchanged: Vec<bool>,
    has_exchanges: bool,
}

impl<S: ComplexField<RealField = f64> + Copy> Band<S> {
    pub(super) fn new(size: usize, width: usize) -> Self {
        let zeros = || vec![S::zero(); if width == 1 { size } else { 0 }];
        let three = Three {
            lower: zeros(),
            inverse: zeros(),
            upper: zeros(),
            second: zeros(),
            is_exchanged: vec![false; if width == 1 { size } else { 0 }],
            has_exchanges: false,
        };
        Self { size, width, pivots: vec![0; size], three }
    }

    #[cfg(test)]
    pub(super) fn width(&self) -> usize {
        self.width
    }

    /// Returns the number of places for entries.
    pub(super) fn places(&self) -> usize {
        self.size * (3 * self.width + 1)
    }

    /// Returns the place of an entry.
    pub(super) fn place(&self, row: usize, column: usize) -> usize {
        row * (3 * self.width + 1) + column + self.width - row
    }

    /// Factors the matrix in place of its entries.
    ///
    /// # Errors
    /// [`Singular`], also where entries are not finite.
    pub(super) fn factor(&mut self, entries: &mut [S]) -> Result<(), Singular> {
        if self.width == 1 {
            return self.three.factor(&entries[..4 * self.size]);
        }
        for k in 0..self.size {
            let bottom = (k + self.width + 1).min(self.size);
            let end = (k + 2 * self.width + 1).min(self.size);
            let size_of = |row: usize| entries[self.place(row, k)].norm1();
            let mut pivot = (k, size_of(k));
            for row in k + 1..bottom {
                let size = size_of(row);
                if size > pivot.1 {
                    pivot = (row, size);
                }
            }
            if !(pivot.1 > 0.0 && pivot.1.is_finite()) {
                return Err(Singular);
            }
            self.pivots[k] = pivot.0;
            if pivot.0 != k {
                for column in k..end {
                    entries.swap(self.place(k, column), self.place(pivot.0, column));
                }
            }
            let first = self.place(k, k);
            let inverse = entries[first].recip();
            for row in k + 1..bottom {
                let start = self.place(row, k);
                if entries[start].is_zero() {
                    continue;
                }
                let factor = entries[start] * inverse;
                entries[start] = factor;
                let (above, below) = entries.split_at_mut(start);
                let above = &above[first + 1..first + end - k];
                for (entry, above) in below[1..].iter_mut().zip(above) {
                    *entry -= factor * *above;
                }
            }
        }
        Ok(())
    }

    /// Solves for x in place of b.
    pub(super) fn solve(&self, entries: &[S], b: &mut [S]) {
        if self.width == 1 {
            return self.three.solve(b);
        }
        for k in 0..self.size {
            b.swap(k, self.pivots[k]);
            let known = b[k];
            if known.is_zero() {
                continue;
            }
            let bottom = (k + self.width + 1).min(self.size);
            for (row, value) in (k + 1..bottom).zip(&mut b[k + 1..bottom]) {
                *value -= entries[self.place(row, k)] * known;
            }
        }
        for row in (0..self.size).rev() {
            let end = (row + 2 * self.width + 1).min(self.size);
            let first = self.place(row, row);
            let entries = &entries[first..first + end - row];
            let (unknown, known) = b[row..].split_at_mut(1);
            let mut sum = unknown[0];
            for (entry, value) in entries[1..].iter().zip(known) {
                sum -= *entry * *value;
            }
            unknown[0] = sum / entries[0];
        }
    }
}

impl<S: ComplexField<RealField = f64> + Copy> Three<S> {
    /// Factors rows of (below, diagonal, above, unused).
    fn factor(&mut self, entries: &[S]) -> Result<(), Singular> {
        self.has_exchanges = !self.factor_from_both_ends(entries);
        if !self.has_exchanges {
            return Ok(());
        }
        let rows = entries.chunks_exact(4);
        let size = rows.len();
        let (mut diagonal, mut above) = (entries[1], entries[2]);
        for (k, next) in rows.skip(1).enumerate() {
            let (below, next_diagonal, next_above) = (next[0], next[1], next[2]);
            let is_exchanged = below.norm1() > diagonal.norm1();
            self.is_exchanged[k] = is_exchanged;
            if is_exchanged {
                let inverse = pivot(below)?;
                let factor = diagonal * inverse;
                self.lower[k] = factor;
                self.inverse[k] = inverse;
                self.upper[k] = next_diagonal * inverse;
                self.second[k] = next_above * inverse;
                diagonal = above - factor * next_diagonal;
                above = -factor * next_above;
            } else {
                let inverse = pivot(diagonal)?;
                self.lower[k] = below * inverse;
                self.inverse[k] = inverse;
                self.upper[k] = above * inverse;
                self.second[k] = S::zero();
                diagonal = next_diagonal - (below * above) * inverse;
                above = next_above;
            }
        }
        self.inverse[size - 1] = pivot(diagonal)?;
        Ok(())
    }

    /// Factors from both ends; returns false, with unusable factors, if rows should be exchanged.
    fn factor_from_both_ends(&mut self, entries: &[S]) -> bool {
        let size = entries.len() / 4;
        let middle = size / 2;
        let row = |k: usize| &entries[4 * k..][..3];
        let is_pivot = |pivot: S, other: S| {
            let size = pivot.norm1();
            size > 0.0 && size.is_finite() && size >= other.norm1()
        };
        let (mut upper, mut lower) = (row(0)[1], row(size - 1)[1]);
        let mut is_good = true;
        for k in 0..size - 1 - middle {
            if k < middle {
                let (above, below) = (row(k)[2], row(k + 1)[0]);
                is_good &= is_pivot(upper, below);
                let inverse = upper.recip();
                self.inverse[k] = inverse;
                self.lower[k] = below * inverse;
                self.upper[k] = above * inverse;
                upper = row(k + 1)[1] - (below * above) * inverse;
            }
            let from_end = size - 1 - k;
            let (below, above) = (row(from_end)[0], row(from_end - 1)[2]);
            is_good &= is_pivot(lower, above);
            let inverse = lower.recip();
            self.inverse[from_end] = inverse;
            self.lower[from_end] = above * inverse;
            self.upper[from_end] = below * inverse;
            lower = row(from_end - 1)[1] - (below * above) * inverse;
        }
        for k in size - 1 - middle..middle {
            let (above, below) = (row(k)[2], row(k + 1)[0]);
            is_good &= is_pivot(upper, below);
            let inverse = upper.recip();
            self.inverse[k] = inverse;
            self.lower[k] = below * inverse;
            self.upper[k] = above * inverse;
            upper = row(k + 1)[1] - (below * above) * inverse;
        }
        // Both eliminations meet there, each including the diagonal itself.
        let pivot = if size == 1 { upper } else { upper + (lower - row(middle)[1]) };
        self.inverse[middle] = pivot.recip();
        is_good && is_pivot(pivot, S::zero())
    }

    /// Solves with the factors from both ends.
    fn solve_from_both_ends(&self, b: &mut [S]) {
        let size = b.len();
        let middle = size / 2;
        let (left, right) = b.split_at_mut(middle);
        let Some((centre, right)) = right.split_first_mut() else { return };
        let (lower, of_right) = self.lower.split_at(middle);
        let (upper, of_right) =
            (&self.upper[..middle], (&of_right[1..], &self.upper[middle + 1..]));
        // There is at most one more row on the left than on the right.
        let [mut above, mut below] = [S::zero(); 2];
        let spare = left.len() - right.len();
        let (first, rest) = left.split_at_mut(spare);
        for (value, lower) in first.iter_mut().zip(lower) {
            above = *value - above;
            *value = above;
            above = *lower * above;
        }
        let pairs = rest.iter_mut().zip(&lower[spare..]);
        let others = right.iter_mut().zip(of_right.0).rev();
        for ((value, lower), (other, of_other)) in pairs.zip(others) {
            above = *value - above;
            below = *other - below;
            (*value, *other) = (above, below);
            above = *lower * above;
            below = *of_other * below;
        }
        *centre = (*centre - above - below) * self.inverse[middle];
        for (value, inverse) in left.iter_mut().zip(&self.inverse) {
            *value *= *inverse;
        }
        for (value, inverse) in right.iter_mut().zip(&self.inverse[middle + 1..]) {
            *value *= *inverse;
        }
        let [mut above, mut below] = [*centre; 2];
        let (first, rest) = left.split_at_mut(spare);
        let pairs = rest.iter_mut().zip(&upper[spare..]).rev();
        for ((value, upper), (other, of_other)) in pairs.zip(right.iter_mut().zip(of_right.1)) {
            above = *value - *upper * above;
            below = *other - *of_other * below;
            (*value, *other) = (above, below);
        }
        for (value, upper) in first.iter_mut().zip(upper).rev() {
            above = *value - *upper * above;
            *value = above;
        }
    }

    fn solve(&self, b: &mut [S]) {
        if !self.has_exchanges {
            return self.solve_from_both_ends(b);
        }
        let size = b.len();
        let Some(last) = size.checked_sub(1) else { return };
        let (lower, inverse) = (&self.lower[..size], &self.inverse[..size]);
        let (upper, second) = (&self.upper[..size], &self.second[..size]);
        for k in 0..last {
            if self.is_exchanged[k] {
                b.swap(k, k + 1);
            }
            let known = b[k];
            b[k + 1] -= lower[k] * known;
        }
        for (value, inverse) in b.iter_mut().zip(inverse) {
            *value *= *inverse;
        }
        let [mut known, mut after] = [b[last], S::zero()];
        for k in (0..last).rev() {
            let value = (b[k] - second[k] * after) - upper[k] * known;
            (known, after) = (value, known);
            b[k] = value;
        }
    }
}

/// Returns the inverse of a pivot.
fn pivot<S: ComplexField<RealField = f64> + Copy>(value: S) -> Result<S, Singular> {
    let size = value.norm1();
    if size > 0.0 && size.is_finite() { Ok(value.recip()) } else { Err(Singular) }
}
