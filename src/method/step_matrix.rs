//! The matrix of implicit steps, shift I - df/dy, without its trivial half.

use nalgebra::ComplexField;

use super::System;
use super::bordered::Bordered;
use super::lu::{Lu, Singular};

/// shift I - J for y = \[q, q', z\]. The upper rows of J say that the rate of q
/// is q', so that q is eliminated beforehand:
///
/// ```text
/// q = (r_q + q') / shift
/// (shift I - J_vv - J_vq / shift) x_v = r_v + J_vq r_q / shift     x_v = [q', z]
/// ```
///
/// and only the n + m lower equations of the 2 n + m are factored: as a band with a
/// border where the simulator knows of one, else as a full matrix.
pub(super) struct StepMatrix<'a, S> {
    /// Number of coordinates eliminated: all, or none if the pattern is not of
    /// this form.
    coordinates: usize,
    entries: &'a [(u32, u32)],
    shift: S,
    factors: Factors<S>,
}

enum Factors<S> {
    Full(Lu<S>),
    Bordered(Box<Bordered<S>>),
}

impl<'a, S: ComplexField<RealField = f64> + Copy> StepMatrix<'a, S> {
    pub(super) fn new(system: &'a System<'a>) -> Self {
        let entries = system.jacobian_pattern().entries;
        let coordinates = system.simulator().shape().coordinates;
        let upper = entries.iter().filter(|(row, _)| (*row as usize) < coordinates);
        let expected = (0..coordinates as u32).map(|row| (row, row + coordinates as u32));
        let coordinates = if upper.copied().eq(expected) { coordinates } else { 0 };
        let size = system.states() - coordinates;
        let factors = match system.simulator().border() {
            Some(border) if coordinates > 0 => {
                let border = border.iter().map(|index| *index as usize);
                let border: Vec<usize> =
                    border.filter_map(|index| index.checked_sub(coordinates)).collect();
                let lower = entries[coordinates..].iter().map(|&(row, column)| {
                    let (row, column) = (row as usize, column as usize);
                    (row - coordinates, column.checked_sub(coordinates).unwrap_or(column))
                });
                Factors::Bordered(Box::new(Bordered::new(size, &border, lower)))
            }
            _ => Factors::Full(Lu::new(size)),
        };
        Self { coordinates, entries, shift: S::one(), factors }
    }

    /// Factors shift I - J, J from its nonzeros in pattern order.
    ///
    /// # Errors
    /// [`Singular`] if that cannot be done.
    pub(super) fn factor(&mut self, shift: S, jacobian: &[f64]) -> Result<(), Singular> {
        self.shift = shift;
        let (n, entries) = (self.coordinates, self.entries);
        match &mut self.factors {
            Factors::Full(lu) => {
                lu.clear();
                let size = lu.size();
                fill(n, entries, (shift, size), jacobian, |row, column, value| {
                    lu.add(row, column, value);
                });
                lu.factor()
            }
            Factors::Bordered(bordered) => {
                bordered.clear();
                let size = bordered.size();
                fill(n, entries, (shift, size), jacobian, |row, column, value| {
                    bordered.add(row, column, value);
                });
                bordered.factor()
            }
        }
    }

    /// Solves (shift I - J) x = r; r becomes x.
    pub(super) fn solve(&mut self, jacobian: &[f64], r: &mut [S]) {
        let n = self.coordinates;
        let inverse = self.shift.recip();
        let (upper, lower) = r.split_at_mut(n);
        if n > 0 {
            for value in upper.iter_mut() {
                *value *= inverse;
            }
            for ((row, column), value) in lower_entries(n, self.entries, jacobian) {
                if column < n {
                    lower[row - n] += upper[column].scale(value);
                }
            }
        }
        match &mut self.factors {
            Factors::Full(lu) => lu.solve(lower),
            Factors::Bordered(bordered) => bordered.solve(lower),
        }
        for (upper, lower) in upper.iter_mut().zip(lower) {
            *upper += *lower * inverse;
        }
    }
}

/// Adds the entries of the matrix that is factored.
fn fill<S: ComplexField<RealField = f64> + Copy>(
    n: usize,
    entries: &[(u32, u32)],
    (shift, size): (S, usize),
    jacobian: &[f64],
    mut add: impl FnMut(usize, usize, S),
) {
    let inverse = shift.recip();
    for index in 0..size {
        add(index, index, shift);
    }
    for ((row, column), value) in lower_entries(n, entries, jacobian) {
        if column < n {
            add(row - n, column, -inverse.scale(value));
        } else {
            add(row - n, column - n, -S::from_real(value));
        }
    }
}

/// The nonzeros of J below the eliminated rows.
fn lower_entries<'b>(
    n: usize,
    entries: &'b [(u32, u32)],
    jacobian: &'b [f64],
) -> impl Iterator<Item = ((usize, usize), f64)> + 'b {
    let places = entries[n..].iter().map(|&(row, column)| (row as usize, column as usize));
    places.zip(jacobian[n..].iter().copied())
}
