//! The matrix \[M, G^T; G, 0\] of a long mechanism, factored along its chains: time and memory grow
//! with the number of nonzeros, not with the cube and square of the size.

use std::collections::BTreeSet;

/// Smallest ratio of a pivot to the sum of its terms. Below it, constraints nearly repeat each
/// other, and rows have to be exchanged.
const LEAST: f64 = 1e-9;

/// L D L^T without exchanges. The order is chosen once from the pattern of nonzeros: rows with the
/// fewest neighbours first, a constraint only after all of its coordinates. Every eliminated part
/// is then a saddle matrix by itself, so pivots of coordinates are positive where M is positive
/// definite, and those of constraints negative where they are independent (Vanderbei, "Symmetric
/// quasidefinite matrices", SIAM J. Optim. 5, 1995; minimum degree order, George, Liu, SIAM Review
/// 31, 1989).
pub(super) struct Saddle {
    coordinates: usize,
    /// Rows in the order of elimination.
    order: Vec<u32>,
    /// Place of each row in `order`.
    place: Vec<u32>,
    /// First entry of each column of L, and one past the last; `rows` contains the places of
    /// entries.
    starts: Vec<usize>,
    rows: Vec<u32>,
    below: Vec<f64>,
    diagonal: Vec<f64>,
}

impl Saddle {
    /// Creates the structure for a matrix with these nonzeros of M and G.
    pub(super) fn new(sizes: [usize; 2], mass: &[(u32, u32)], matrix: &[(u32, u32)]) -> Self {
        let [coordinates, constraints] = sizes;
        let size = coordinates + constraints;
        let mut met = vec![BTreeSet::new(); size];
        let of_matrix = matrix.iter().map(|(row, column)| (row + coordinates as u32, *column));
        for (row, column) in mass.iter().copied().chain(of_matrix) {
            if row != column {
                met[row as usize].insert(column);
                met[column as usize].insert(row);
            }
        }
        // Coordinates that have to be eliminated before each constraint.
        let mut awaited: Vec<BTreeSet<u32>> = vec![BTreeSet::new(); size];
        for (row, column) in matrix {
            awaited[coordinates + *row as usize].insert(*column);
        }
        let ready = |row: usize, met: &[BTreeSet<u32>]| (met[row].len(), row as u32);
        let mut waiting: BTreeSet<(usize, u32)> =
            (0..size).filter(|row| awaited[*row].is_empty()).map(|row| ready(row, &met)).collect();
        let (mut order, mut around) = (Vec::with_capacity(size), Vec::with_capacity(size));
        while let Some((_, row)) = waiting.pop_first() {
            let its = std::mem::take(&mut met[row as usize]);
            for &other in &its {
                let at = other as usize;
                let was_ready = awaited[at].is_empty();
                waiting.remove(&ready(at, &met));
                met[at].remove(&row);
                met[at].extend(its.iter().filter(|third| **third != other));
                awaited[at].remove(&row);
                if was_ready || awaited[at].is_empty() {
                    waiting.insert(ready(at, &met));
                }
            }
            order.push(row);
            around.push(its);
        }
        let mut place = vec![0; size];
        for (at, row) in order.iter().enumerate() {
            place[*row as usize] = at as u32;
        }
        let (mut starts, mut rows) = (vec![0], Vec::new());
        for its in &around {
            let first = rows.len();
            rows.extend(its.iter().map(|row| place[*row as usize]));
            rows[first..].sort_unstable();
            starts.push(rows.len());
        }
        let (below, diagonal) = (vec![0.0; rows.len()], vec![0.0; size]);
        Self { coordinates, order, place, starts, rows, below, diagonal }
    }

    /// Factors the matrix of these entries; returns false if rows would have to be exchanged.
    pub(super) fn factor<'a>(
        &mut self,
        mass: impl Iterator<Item = (&'a (u32, u32), &'a f64)>,
        matrix: impl Iterator<Item = (&'a (u32, u32), &'a f64)>,
    ) -> bool {
        self.below.fill(0.0);
        self.diagonal.fill(0.0);
        for ((row, column), value) in mass.filter(|((row, column), _)| row >= column) {
            self.add(*row as usize, *column as usize, *value);
        }
        for ((row, column), value) in matrix {
            self.add(self.coordinates + *row as usize, *column as usize, *value);
        }
        // Sum of the absolute terms of each pivot.
        let mut made_of: Vec<f64> = self.diagonal.iter().map(|value| value.abs()).collect();
        for at in 0..self.order.len() {
            let pivot = self.diagonal[at];
            let is_coordinate = (self.order[at] as usize) < self.coordinates;
            let has_sign = if is_coordinate { pivot > 0.0 } else { pivot < 0.0 };
            if !has_sign || !pivot.is_finite() || pivot.abs() < LEAST * made_of[at] {
                return false;
            }
            let column = self.starts[at]..self.starts[at + 1];
            for first in column.clone() {
                let row = self.rows[first] as usize;
                let multiplier = self.below[first] / pivot;
                let taken = multiplier * self.below[first];
                self.diagonal[row] -= taken;
                made_of[row] += taken.abs();
                // Places of later rows in this row's column; both are ascending.
                let mut target = self.starts[row];
                for second in first + 1..column.end {
                    while self.rows[target] < self.rows[second] {
                        target += 1;
                    }
                    self.below[target] -= multiplier * self.below[second];
                }
            }
            for entry in column {
                self.below[entry] /= pivot;
            }
        }
        true
    }

    /// Adds to an entry and to its mirror image.
    fn add(&mut self, row: usize, column: usize, value: f64) {
        let [a, b] = [self.place[row], self.place[column]];
        if a == b {
            self.diagonal[a as usize] += value;
            return;
        }
        let (first, later) = (a.min(b) as usize, a.max(b));
        let column = self.starts[first]..self.starts[first + 1];
        let index = self.rows[column.clone()].partition_point(|row| *row < later);
        self.below[column.start + index] += value;
    }

    /// Solves with the last factors.
    pub(super) fn solve(&self, right_side: &[f64]) -> Vec<f64> {
        let mut x: Vec<f64> = self.order.iter().map(|row| right_side[*row as usize]).collect();
        let entries = |at: usize| {
            let column = self.starts[at]..self.starts[at + 1];
            self.rows[column.clone()].iter().zip(&self.below[column])
        };
        for at in 0..x.len() {
            let known = x[at];
            entries(at).for_each(|(row, entry)| x[*row as usize] -= entry * known);
        }
        for (value, pivot) in x.iter_mut().zip(&self.diagonal) {
            *value /= pivot;
        }
        for at in (0..x.len()).rev() {
            let sum: f64 = entries(at).map(|(row, entry)| entry * x[*row as usize]).sum();
            x[at] -= sum;
        }
        self.place.iter().map(|at| x[*at as usize]).collect()
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector};

    use super::*;

    type Entries = Vec<((u32, u32), f64)>;

    /// Returns a chain of bodies with 3 coordinates, M coupled along it by `coupling`, each joined
    /// to the one before by two constraints; with `far`, some are joined to distant ones too.
    fn chain(bodies: u32, coupling: f64, far: bool, seed: u64) -> [Entries; 2] {
        let mut random = fastrand::Rng::with_seed(seed);
        let mut number = || random.f64() - 0.5;
        let (mut mass, mut matrix) = (Vec::new(), Vec::new());
        for body in 0..bodies {
            for at in 3 * body..3 * body + 3 {
                mass.push(((at, at), 3.0 + number()));
            }
            if coupling != 0.0 && body > 0 {
                let value = coupling * number();
                mass.push(((3 * body, 3 * body - 3), value));
                mass.push(((3 * body - 3, 3 * body), value));
            }
            for part in 0..2 {
                let row = 2 * body + part;
                let mut held = vec![3 * body + part, 3 * body + 2];
                if body > 0 {
                    held.extend([3 * body - 3 + part, 3 * body - 1]);
                }
                if far && body % 7 == 6 {
                    held.push(3 * (body / 2) + part);
                }
                held.sort_unstable();
                held.dedup();
                let first = held.contains(&(3 * body + part));
                assert!(first);
                matrix.extend(
                    held.into_iter()
                        .map(|at| ((row, at), if at == 3 * body + part { 1.0 } else { number() })),
                );
            }
        }
        [mass, matrix]
    }

    fn pattern(entries: &Entries) -> Vec<(u32, u32)> {
        entries.iter().map(|(place, _)| *place).collect()
    }

    fn factored(saddle: &mut Saddle, [mass, matrix]: &[Entries; 2]) -> bool {
        saddle.factor(mass.iter().map(|(p, v)| (p, v)), matrix.iter().map(|(p, v)| (p, v)))
    }

    #[test]
    fn sparse_and_full_factors_solve_alike() {
        for (bodies, coupling, far) in
            [(1, 0.0, false), (5, 0.0, false), (20, 1.0, false), (40, 0.0, true), (40, 1.0, true)]
        {
            for seed in 0..20 {
                let entries = chain(bodies, coupling, far, seed);
                let [n, m] = [3 * bodies as usize, 2 * bodies as usize];
                let [mass, matrix] = &entries;
                let mut saddle = Saddle::new([n, m], &pattern(mass), &pattern(matrix));
                assert!(factored(&mut saddle, &entries), "{bodies} {coupling} {far} {seed}");
                let mut full = DMatrix::zeros(n + m, n + m);
                for ((row, column), value) in mass {
                    full[(*row as usize, *column as usize)] = *value;
                }
                for ((row, column), value) in matrix {
                    full[(n + *row as usize, *column as usize)] = *value;
                    full[(*column as usize, n + *row as usize)] = *value;
                }
                let b = DVector::from_fn(n + m, |i, _| ((i * 37 + 11) % 17) as f64 - 8.0);
                let x = DVector::from_vec(saddle.solve(b.as_slice()));
                let exact = full.clone().lu().solve(&b).unwrap();
                let error = (&x - &exact).norm() / exact.norm();
                assert!(error < 1e-10, "{bodies} {coupling} {far} {seed}: {error:e}");
                let residual = (&full * &x - &b).norm() / (full.norm() * x.norm());
                assert!(residual < 1e-12, "{bodies} {coupling} {far} {seed}: {residual:e}");
            }
        }
    }

    #[test]
    fn what_comes_in_grows_as_the_chain_does() {
        let count = |bodies: u32| {
            let [mass, matrix] = chain(bodies, 1.0, false, 0);
            let sizes = [3 * bodies as usize, 2 * bodies as usize];
            Saddle::new(sizes, &pattern(&mass), &pattern(&matrix)).rows.len()
        };
        let [few, many] = [count(100), count(1000)];
        assert!(many < 11 * few, "{few} {many}");
    }

    #[test]
    fn constraints_that_repeat_others_are_left_to_exchanges() {
        let [mass, mut matrix] = chain(3, 0.0, false, 1);
        let last: Vec<_> = matrix.iter().filter(|((row, _), _)| *row == 5).copied().collect();
        matrix.extend(last.into_iter().map(|((_, column), value)| ((6, column), 2.0 * value)));
        let mut saddle = Saddle::new([9, 7], &pattern(&mass), &pattern(&matrix));
        assert!(!factored(&mut saddle, &[mass.clone(), matrix]));
        // A constraint without effect.
        let matrix: Entries = vec![((0, 0), 0.0)];
        let mut saddle = Saddle::new([9, 1], &pattern(&mass), &pattern(&matrix));
        assert!(!factored(&mut saddle, &[mass, matrix]));
    }
}
