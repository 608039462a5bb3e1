//! The matrix of implicit steps, shift I - df/dy, reduced to its nontrivial part.

use nalgebra::ComplexField;

use super::System;
use super::bordered::Bordered;
use super::lu::{Lu, Singular};
use super::sparse::Sparse;

/// shift I - J for y = \[q, q', z\]. The upper rows of J state that the rate of q is q', so q is
/// eliminated beforehand:
///
/// ```text
/// q = (r_q + q') / shift
/// (shift I - J_vv - J_vq / shift) x_v = r_v + J_vq r_q / shift     x_v = [q', z]
/// ```
///
/// Only the n + m lower equations of the 2 n + m are factored: as a band with a border if the
/// simulator provides one, otherwise as a sparse matrix where that is worthwhile, otherwise as a
/// dense matrix.
pub(super) struct StepMatrix<'a, S> {
    /// Number of eliminated coordinates: all, or none if the pattern has another form.
    coordinates: usize,
    entries: &'a [(u32, u32)],
    /// Runs of nonzeros of J_vq, and their entries, diagonal by diagonal.
    by_position: Vec<Run>,
    diagonals: Vec<f64>,
    shift: S,
    factors: Factors<S>,
}

enum Factors<S> {
    Full(Lu<S>),
    Bordered(Box<Bordered<S>>),
    /// The dense matrix exists if the last one needed exchanges.
    Sparse(Box<Sparse<S>>, Option<Lu<S>>),
}

impl<'a, S: ComplexField<RealField = f64> + Copy> StepMatrix<'a, S> {
    pub(super) fn new(system: &'a System<'a>) -> Self {
        let entries = system.jacobian_pattern().entries;
        let coordinates = system.simulator().shape().coordinates;
        let upper = entries.iter().filter(|(row, _)| (*row as usize) < coordinates);
        let expected = (0..coordinates as u32).map(|row| (row, row + coordinates as u32));
        let coordinates = if upper.copied().eq(expected) { coordinates } else { 0 };
        let size = system.states() - coordinates;
        // Positions are replaced by the velocities with which they are eliminated.
        let lower = entries[coordinates..].iter().map(|&(row, column)| {
            let (row, column) = (row as usize, column as usize);
            (row - coordinates, column.checked_sub(coordinates).unwrap_or(column))
        });
        let lower: Vec<(usize, usize)> = lower.collect();
        let factors = match system.simulator().border() {
            Some(border) if coordinates > 0 => {
                let border = border.iter().map(|index| *index as usize);
                let border: Vec<usize> =
                    border.filter_map(|index| index.checked_sub(coordinates)).collect();
                Factors::Bordered(Box::new(Bordered::new(size, &border, &lower)))
            }
            _ => match Sparse::new(size, &lower) {
                Some(sparse) => Factors::Sparse(Box::new(sparse), None),
                None => Factors::Full(Lu::new(size)),
            },
        };
        let by_position = runs(entries, coordinates);
        let diagonals = vec![0.0; by_position.iter().map(|run| run.rows * run.width).sum()];
        Self { coordinates, entries, by_position, diagonals, shift: S::one(), factors }
    }

    /// Factors shift I - J, with J given by its nonzeros in pattern order.
    ///
    /// # Errors
    /// [`Singular`] if the matrix cannot be factored.
    pub(super) fn factor(&mut self, shift: S, jacobian: &[f64]) -> Result<(), Singular> {
        self.shift = shift;
        let mut diagonals = self.diagonals.as_mut_slice();
        for run in &self.by_position {
            let (of_run, rest) = diagonals.split_at_mut(run.rows * run.width);
            run.gather(jacobian, of_run);
            diagonals = rest;
        }
        let n = self.coordinates;
        let inverse = shift.recip();
        let value = |column: u32, value: f64| {
            if (column as usize) < n { -inverse.scale(value) } else { -S::from_real(value) }
        };
        let lower = self.entries[n..].iter().zip(&jacobian[n..]);
        let add_all = |values: &mut [S], targets: &[u32]| {
            for ((&(_, column), entry), target) in lower.clone().zip(targets) {
                values[*target as usize] += value(column, *entry);
            }
        };
        let factor_fully = |lu: &mut Lu<S>| {
            lu.clear();
            for index in 0..lu.size() {
                lu.add(index, index, shift);
            }
            for (&(row, column), entry) in lower.clone() {
                let (row, at) = (row as usize - n, column as usize);
                lu.add(row, at.checked_sub(n).unwrap_or(at), value(column, *entry));
            }
            lu.factor()
        };
        match &mut self.factors {
            Factors::Full(lu) => factor_fully(lu),
            Factors::Bordered(bordered) => {
                let (values, targets) = bordered.start(shift);
                add_all(values, targets);
                bordered.factor()
            }
            Factors::Sparse(sparse, full) => {
                let (values, targets) = sparse.start(shift);
                add_all(values, targets);
                *full = None;
                if sparse.factor().is_err() {
                    factor_fully(full.insert(Lu::new(sparse.size())))?;
                }
                Ok(())
            }
        }
    }

    /// Solves (shift I - J) x = r in place with the last factors.
    pub(super) fn solve(&mut self, r: &mut [S]) {
        let n = self.coordinates;
        let inverse = self.shift.recip();
        let (upper, lower) = r.split_at_mut(n);
        for value in upper.iter_mut() {
            *value *= inverse;
        }
        let mut diagonals = self.diagonals.as_slice();
        for run in &self.by_position {
            let (of_run, rest) = diagonals.split_at(run.rows * run.width);
            run.add_product(of_run, upper, lower);
            diagonals = rest;
        }
        match &mut self.factors {
            Factors::Full(lu) => lu.solve(lower),
            Factors::Bordered(bordered) => bordered.solve(lower),
            Factors::Sparse(_, Some(full)) => full.solve(lower),
            Factors::Sparse(sparse, None) => sparse.solve(lower),
        }
        for (upper, lower) in upper.iter_mut().zip(lower) {
            *upper += *lower * inverse;
        }
    }
}

impl StepMatrix<'_, f64> {
    /// Returns whether [`StepMatrix::is_outgrown`] is available.
    pub(super) fn tells_growth(&self) -> bool {
        !matches!(self.factors, Factors::Bordered(_))
    }

    /// Returns whether an odd number of real eigenvalues of J are above the shift, from the sign of
    /// the determinant of the last factors. Such motions grow within a step by more than a method
    /// can distinguish from decay. Matrices with a border and backward steps are not examined.
    pub(super) fn is_outgrown(&self) -> bool {
        if self.shift < 0.0 {
            return false;
        }
        match &self.factors {
            Factors::Full(full) | Factors::Sparse(_, Some(full)) => full.is_negative(),
            Factors::Sparse(sparse, None) => sparse.is_negative(),
            Factors::Bordered(_) => false,
        }
    }
}

/// Consecutive rows with the same number of entries by positions, each shifted by one column from
/// the previous row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Run {
    /// First row, below the positions, with its first column and entry.
    row: usize,
    column: usize,
    entry: usize,
    rows: usize,
    /// Number of entries by positions in a row, and distance of entries between rows.
    width: usize,
    stride: usize,
}

/// Returns the rows below the first `n`, restricted to their first `n` columns, as runs.
fn runs(entries: &[(u32, u32)], n: usize) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let mut first = n;
    for row in entries[n..].chunk_by(|a, b| a.0 == b.0) {
        let mut entry = first;
        first += row.len();
        let by_position = row.iter().filter(|(_, column)| (*column as usize) < n);
        let by_position: Vec<(u32, u32)> = by_position.copied().collect();
        // Consecutive columns.
        for part in by_position.chunk_by(|a, b| a.1 + 1 == b.1) {
            let (at, column) = (part[0].0 as usize - n, part[0].1 as usize);
            let width = part.len();
            let is_next = |run: &Run| {
                let (last, after) = (run.rows - 1, run.rows);
                let stride = if last == 0 { entry.wrapping_sub(run.entry) } else { run.stride };
                run.width == width
                    && (run.row + after, run.column + after) == (at, column)
                    && run.entry + after * stride == entry
                    && stride >= width
            };
            match runs.last_mut().filter(|run| is_next(run)) {
                Some(run) => {
                    run.stride = (entry - run.entry) / run.rows;
                    run.rows += 1;
                }
                None => runs.push(Run { row: at, column, entry, rows: 1, width, stride: width }),
            }
            entry += width;
        }
    }
    runs
}

impl Run {
    /// Copies J_vq in these rows: the first entries of all rows, then the second ones.
    fn gather(&self, jacobian: &[f64], diagonals: &mut [f64]) {
        for (k, diagonal) in diagonals.chunks_exact_mut(self.rows).enumerate() {
            let entries = jacobian[self.entry + k..].iter().step_by(self.stride);
            diagonal.iter_mut().zip(entries).for_each(|(into, entry)| *into = *entry);
        }
    }

    /// Computes lower += J_vq upper in these rows.
    fn add_product<S>(&self, diagonals: &[f64], upper: &[S], lower: &mut [S])
    where
        S: ComplexField<RealField = f64> + Copy,
    {
        let rows = &mut lower[self.row..self.row + self.rows];
        for (k, diagonal) in diagonals.chunks_exact(self.rows).enumerate() {
            let columns = &upper[self.column + k..][..self.rows];
            for ((sum, entry), column) in rows.iter_mut().zip(diagonal).zip(columns) {
                *sum += column.scale(*entry);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::runs;

    #[test]
    fn products_by_runs_are_those_by_entries() {
        // Two kinematic rows would be first; here n = 4 positions, 8 states.
        let n = 4;
        let mut entries: Vec<(u32, u32)> = (0..4).map(|row| (row, row + 4)).collect();
        entries.extend([(4, 0), (4, 3), (4, 5), (5, 0), (5, 1), (5, 2), (5, 4), (5, 5), (5, 6)]);
        entries.extend([(6, 1), (6, 2), (6, 3), (6, 5), (6, 6), (6, 7), (7, 2), (7, 3), (7, 7)]);
        let jacobian: Vec<f64> = (0..entries.len()).map(|index| 1.0 + index as f64).collect();
        let upper = [1.0, 10.0, 100.0, 1000.0];
        let (mut by_runs, mut by_entries) = ([0.0; 4], [0.0; 4]);
        let runs = runs(&entries, n);
        assert!(runs.iter().any(|run| run.rows > 1), "{runs:?}");
        for run in &runs {
            let mut diagonals = vec![0.0; run.rows * run.width];
            run.gather(&jacobian, &mut diagonals);
            run.add_product(&diagonals, &upper, &mut by_runs);
        }
        for ((row, column), value) in entries.iter().zip(&jacobian).skip(n) {
            if (*column as usize) < n {
                by_entries[*row as usize - n] += value * upper[*column as usize];
            }
        }
        assert_eq!(by_runs.map(f64::to_bits), by_entries.map(f64::to_bits));
    }
}
