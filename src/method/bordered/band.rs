//! P A = L U of a banded matrix, with a way of its own for three diagonals.

use nalgebra::ComplexField;

use crate::method::lu::Singular;

/// A matrix with `width` diagonals on each side. Its entries are not here: row i holds
/// the columns from i - width to i + 2 width, as far as exchanges fill it.
pub(super) struct Band<S> {
    size: usize,
    width: usize,
    pivots: Vec<usize>,
    three: Three<S>,
}

/// Factors of a matrix with three diagonals. U has ones on its diagonal, so that each of
/// its rows costs one product and one difference that wait for the row below.
struct Three<S> {
    lower: Vec<S>,
    inverse: Vec<S>,
    upper: Vec<S>,
    /// The second diagonal of U, which exchanges fill.
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

    /// How many places entries take.
    pub(super) fn places(&self) -> usize {
        self.size * (3 * self.width + 1)
    }

    /// Where an entry is.
    pub(super) fn place(&self, row: usize, column: usize) -> usize {
        row * (3 * self.width + 1) + column + self.width - row
    }

    /// Factors the matrix, over its entries.
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

    /// Solves for x; b becomes x.
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
    /// From rows of (below, diagonal, above, nothing).
    fn factor(&mut self, entries: &[S]) -> Result<(), Singular> {
        let rows = entries.chunks_exact(4);
        let size = rows.len();
        self.has_exchanges = false;
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
                self.has_exchanges = true;
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

    fn solve(&self, b: &mut [S]) {
        let size = b.len();
        let Some(last) = size.checked_sub(1) else { return };
        let (lower, inverse) = (&self.lower[..size], &self.inverse[..size]);
        let (upper, second) = (&self.upper[..size], &self.second[..size]);
        if self.has_exchanges {
            for k in 0..last {
                if self.is_exchanged[k] {
                    b.swap(k, k + 1);
                }
                let known = b[k];
                b[k + 1] -= lower[k] * known;
            }
        } else {
            let mut known = b[0];
            for (value, factor) in b[1..].iter_mut().zip(lower) {
                known = *value - *factor * known;
                *value = known;
            }
        }
        for (value, inverse) in b.iter_mut().zip(inverse) {
            *value *= *inverse;
        }
        let mut known = b[last];
        if self.has_exchanges {
            let mut after = S::zero();
            for k in (0..last).rev() {
                let value = (b[k] - second[k] * after) - upper[k] * known;
                (known, after) = (value, known);
                b[k] = value;
            }
        } else {
            for (value, upper) in b[..last].iter_mut().zip(upper).rev() {
                known = *value - *upper * known;
                *value = known;
            }
        }
    }
}

/// The inverse of a pivot.
fn pivot<S: ComplexField<RealField = f64> + Copy>(value: S) -> Result<S, Singular> {
    let size = value.norm1();
    if size > 0.0 && size.is_finite() { Ok(value.recip()) } else { Err(Singular) }
}
