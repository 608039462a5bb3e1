//! The matrix of implicit steps, shift I - df/dy, without its trivial half.

use nalgebra::ComplexField;

use super::System;
use super::lu::{Lu, Singular};

/// shift I - J for y = \[q, q', z\]. The upper rows of J say that the rate of q
/// is q', so that q is eliminated beforehand:
///
/// ```text
/// q = (r_q + q') / shift
/// (shift I - J_vv - J_vq / shift) x_v = r_v + J_vq r_q / shift     x_v = [q', z]
/// ```
///
/// and only the n + m lower equations of the 2 n + m are factored.
pub(super) struct StepMatrix<'a, S> {
    /// Number of coordinates eliminated: all, or none if the pattern is not of
    /// this form.
    coordinates: usize,
    entries: &'a [(u32, u32)],
    shift: S,
    lu: Lu<S>,
}

impl<'a, S: ComplexField<RealField = f64> + Copy> StepMatrix<'a, S> {
    pub(super) fn new(system: &'a System<'a>) -> Self {
        let entries = system.jacobian_pattern().entries;
        let coordinates = system.simulator().shape().coordinates;
        let upper = entries.iter().filter(|(row, _)| (*row as usize) < coordinates);
        let expected = (0..coordinates as u32).map(|row| (row, row + coordinates as u32));
        let coordinates = if upper.copied().eq(expected) { coordinates } else { 0 };
        let lu = Lu::new(system.states() - coordinates);
        Self { coordinates, entries, shift: S::one(), lu }
    }

    /// Factors shift I - J, J from its nonzeros in pattern order.
    ///
    /// # Errors
    /// [`Singular`] if that cannot be done.
    pub(super) fn factor(&mut self, shift: S, jacobian: &[f64]) -> Result<(), Singular> {
        let n = self.coordinates;
        self.shift = shift;
        let inverse = shift.recip();
        self.lu.clear();
        for index in 0..self.lu.size() {
            self.lu.add(index, index, shift);
        }
        for ((row, column), value) in self.lower(jacobian) {
            if column < n {
                self.lu.add(row - n, column, -inverse.scale(value));
            } else {
                self.lu.add(row - n, column - n, -S::from_real(value));
            }
        }
        self.lu.factor()
    }

    /// Solves (shift I - J) x = r; r becomes x.
    pub(super) fn solve(&self, jacobian: &[f64], r: &mut [S]) {
        let n = self.coordinates;
        let inverse = self.shift.recip();
        let (upper, lower) = r.split_at_mut(n);
        if n > 0 {
            for value in upper.iter_mut() {
                *value *= inverse;
            }
            for ((row, column), value) in self.lower(jacobian) {
                if column < n {
                    lower[row - n] += upper[column].scale(value);
                }
            }
        }
        self.lu.solve(lower);
        for (upper, lower) in upper.iter_mut().zip(lower) {
            *upper += *lower * inverse;
        }
    }

    /// The nonzeros of J below the eliminated rows.
    fn lower<'b>(
        &self,
        jacobian: &'b [f64],
    ) -> impl Iterator<Item = ((usize, usize), f64)> + use<'a, 'b, S> {
        let entries = &self.entries[self.coordinates..];
        entries
            .iter()
            .map(|&(row, column)| (row as usize, column as usize))
            .zip(jacobian[self.coordinates..].iter().copied())
    }
}
