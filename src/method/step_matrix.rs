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
    /// Entries of J_vq: (number of the entry, row below q, column).
    by_position: Vec<[u32; 3]>,
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
                let lower: Vec<(usize, usize)> = lower.collect();
                Factors::Bordered(Box::new(Bordered::new(size, &border, &lower)))
            }
            _ => Factors::Full(Lu::new(size)),
        };
        let first = coordinates as u32;
        let by_position = (0..).zip(entries).filter(|(_, (row, column))| {
            *row >= first && *column < first
        });
        let by_position = by_position.map(|(index, (row, column))| [index, row - first, *column]);
        let by_position = by_position.collect();
        Self { coordinates, entries, by_position, shift: S::one(), factors }
    }

    /// Factors shift I - J, J from its nonzeros in pattern order.
    ///
    /// # Errors
    /// [`Singular`] if that cannot be done.
    pub(super) fn factor(&mut self, shift: S, jacobian: &[f64]) -> Result<(), Singular> {
        self.shift = shift;
        let (n, entries) = (self.coordinates, &self.entries[self.coordinates..]);
        let inverse = shift.recip();
        let value = |column: usize, value: f64| {
            if column < n { -inverse.scale(value) } else { -S::from_real(value) }
        };
        let lower = entries.iter().zip(&jacobian[n..]);
        match &mut self.factors {
            Factors::Full(lu) => {
                lu.clear();
                for index in 0..lu.size() {
                    lu.add(index, index, shift);
                }
                for (&(row, column), entry) in lower {
                    let (row, column) = (row as usize - n, column as usize);
                    let place = column.checked_sub(n).unwrap_or(column);
                    lu.add(row, place, value(column, *entry));
                }
                lu.factor()
            }
            Factors::Bordered(bordered) => {
                let (values, targets) = bordered.start(shift);
                for ((&(_, column), entry), target) in lower.zip(targets) {
                    values[*target as usize] += value(column as usize, *entry);
                }
                bordered.factor()
            }
        }
    }

    /// Solves (shift I - J) x = r; r becomes x.
    pub(super) fn solve(&mut self, jacobian: &[f64], r: &mut [S]) {
        let n = self.coordinates;
        let inverse = self.shift.recip();
        let (upper, lower) = r.split_at_mut(n);
        for value in upper.iter_mut() {
            *value *= inverse;
        }
        for [entry, row, column] in &self.by_position {
            lower[*row as usize] += upper[*column as usize].scale(jacobian[*entry as usize]);
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
