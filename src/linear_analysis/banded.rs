//! Eigenmodes of machines whose coordinates are each coupled to few others, such as chains. The
//! cost grows with the square of their number, like the size of all shapes, instead of the cube.
//!
//! Coordinates and first-order states that depend on each other form a graph. Each connected part
//! of it is treated by itself, in an order that keeps neighbours near. Its motions e^(s t) x belong
//! to a banded matrix T(s), see [`pencil`]; eigenvalues are the zeros of its determinant
//! ([`roots`]), and shapes follow by inverse iteration.
//!
//! All results are checked. Eigenvalues must have the correct sum and sum of squares; left and
//! right vectors of each eigenvalue, except those of drift, must not be orthogonal; all shapes must
//! fulfil the equations. Otherwise dense matrices are used.

mod least;
mod null_space;
mod order;
mod pencil;
mod roots;
#[cfg(test)]
mod tests;

use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

use super::equilibrium::DRIFT;
use super::motions::Motions;
use super::sparse_rows::SparseRows;
pub(super) use least::LeastSquares;
use null_space::NullSpace;
use pencil::{Factors, Pencil};

/// Number of coordinates and first-order states below which dense matrices are as fast.
const FEW: usize = 48;
/// Minimum ratio of the size of a part to its bandwidth.
const SLENDER: usize = 8;
/// Limit, relative to the size of a row, above which a value is not zero; values between this and
/// `DRIFT` are undecidable.
const DOUBTFUL: f64 = 100.0 * DRIFT;
/// Ratio to the largest eigenvalue below which an eigenvalue may be zero.
const NEARLY_ZERO: f64 = 1e-10;
/// Tolerance for sums of eigenvalues against traces, relative to the sum of their absolute values.
const SUMS: f64 = 1e-9;
/// Lower limit of w T' x of left and right vectors, relative to its terms; below it the eigenvalue
/// is double.
const ACROSS: f64 = 1e-7;
/// Upper limit of T x for a shape, relative to its terms.
const RESIDUAL: f64 = 1e-11;
/// Number of solutions of inverse iteration.
const ITERATIONS: usize = 3;
/// Maximum number of improved eigenvalues.
const ROUNDS: usize = 12;
/// Relative difference below which two eigenvalues count as one if their shapes are equal.
const SAME: f64 = 1e-7;

/// An eigenvalue with nonnegative imaginary part, and its vectors of \[q, q', z\] over their
/// scales. For eigenvalue zero the left vector is the right one.
pub(super) struct Found {
    pub value: Complex64,
    pub right: DVector<Complex64>,
    pub left: DVector<Complex64>,
}

/// Returns all eigenvalues with their vectors, those of drift and other zeros first; `None` where
/// dense matrices are better.
pub(super) fn spectrum(motions: &Motions) -> Option<Vec<Found>> {
    let (n, nodes) = (motions.coordinates, motions.coordinates + motions.first_order);
    if nodes < FEW {
        return None;
    }
    let mut neighbours = vec![Vec::new(); nodes];
    for row in 0..nodes {
        for (column, _) in motions.matrix.row(n + row) {
            let column = node(n, *column);
            if column != row {
                neighbours[row].push(column);
                neighbours[column].push(row);
            }
        }
    }
    let mut places = vec![0; nodes];
    let mut found = Vec::new();
    for order in order::parts(&neighbours) {
        order.iter().enumerate().for_each(|(place, index)| places[*index] = place);
        found.extend(Part::new(motions, order, &places)?.spectrum()?);
    }
    Some(found)
}

/// Returns the null space of a matrix with short rows, as columns; `None` if the matrix is not of
/// this kind.
pub(super) fn drift(matrix: &SparseRows) -> Option<DMatrix<f64>> {
    let columns = matrix.columns();
    if columns < FEW {
        return None;
    }
    let rows: Vec<_> = matrix.iter().map(<[_]>::to_vec).collect();
    let vectors = NullSpace::of(columns, &rows, DRIFT)?.vectors;
    Some(DMatrix::from_fn(columns, vectors.len(), |row, column| vectors[column][row]))
}

/// Returns the node of an entry of \[q, q', z\]: the index of a coordinate, or n plus that of a
/// first-order state. The rate of its velocity, or of itself, is the row n further.
fn node(n: usize, entry: usize) -> usize {
    if entry < n { entry } else { entry - n }
}

/// A connected part of coordinates and first-order states.
struct Part<'m> {
    motions: &'m Motions,
    /// Rates in order: (place of the variable, whether it is a velocity, entry). Velocities are
    /// measured by the scales of their coordinates here.
    rates: Vec<Vec<(usize, bool, f64)>>,
    /// Nodes in order.
    order: Vec<usize>,
    /// Start vector of inverse iteration, not orthogonal to any motion.
    start: Vec<Complex64>,
    pencil: Pencil,
}

impl<'m> Part<'m> {
    fn new(motions: &'m Motions, order: Vec<usize>, places: &[usize]) -> Option<Self> {
        let n = motions.coordinates;
        let scale = |node: usize| motions.scales[if node < n { node } else { node + n }];
        let rates = order.iter().map(|row| {
            let entries = motions.matrix.row(n + row).iter().map(|(at, entry)| {
                let column = node(n, *at);
                let is_velocity = (n..2 * n).contains(at);
                (places[column], is_velocity, entry * scale(column) / scale(*row))
            });
            entries.collect::<Vec<_>>()
        });
        let rates: Vec<_> = rates.collect();
        let reach = rates.iter().enumerate().flat_map(|(row, entries)| {
            entries.iter().map(move |(column, ..)| column.abs_diff(row))
        });
        let width = reach.max().unwrap_or(0);
        if order.len() >= FEW && width * SLENDER > order.len() {
            return None;
        }
        let mut pencil = Pencil::new(order.iter().map(|node| *node < n).collect(), width);
        for (row, entries) in rates.iter().enumerate() {
            for (column, is_velocity, entry) in entries {
                pencil.subtract(row, *column, *is_velocity, *entry);
            }
        }
        let start =
            (0..order.len()).map(|index| Complex64::from((0.7 * (index * index) as f64).cos()));
        Some(Self { motions, rates, start: start.collect(), order, pencil })
    }

    fn spectrum(&self) -> Option<Vec<Found>> {
        let drift = self.drift()?;
        let is_free = self.is_free(&drift)?;
        let zeros = if is_free { 2 * drift.len() } else { drift.len() };
        let values = roots::eigenvalues(&self.pencil, zeros)?;
        let largest = values.iter().fold(0.0_f64, |most, value| most.max(value.norm()));
        if values.iter().any(|value| value.norm() <= NEARLY_ZERO * largest) {
            return None;
        }
        let found: Option<Vec<Found>> = values.iter().map(|value| self.found(*value)).collect();
        let found = found?;
        if !self.is_all(&found) || has_one_twice(&found) {
            return None;
        }
        let still = drift.iter().cycle().take(zeros).map(|drift| {
            let right = self.unfolded(drift, &vec![Complex64::ZERO; drift.len()], false);
            Found { value: Complex64::ZERO, left: right.conjugate(), right }
        });
        Some(still.chain(found).collect())
    }

    /// Returns the directions of coordinates on which no rate depends, in order.
    fn drift(&self) -> Option<Vec<Vec<Complex64>>> {
        let coordinates: Vec<usize> =
            (0..self.order.len()).filter(|place| self.is_coordinate(*place)).collect();
        let of_coordinates = |place: &usize| coordinates.binary_search(place).ok();
        let rows = self.rates.iter().enumerate().map(|(row, entries)| {
            let size = self.row_size(row);
            let of_positions = entries.iter().filter(|(_, is_velocity, _)| !is_velocity);
            let entries = of_positions
                .filter_map(|(column, _, entry)| Some((of_coordinates(column)?, entry / size)));
            entries.collect()
        });
        let rows: Vec<Vec<(usize, f64)>> = rows.collect();
        let found = NullSpace::of(coordinates.len(), &rows, DRIFT)?.vectors;
        let spread = |vector: &DVector<f64>| {
            let mut whole = vec![Complex64::ZERO; self.order.len()];
            for (place, value) in coordinates.iter().zip(vector) {
                whole[*place] = Complex64::from(*value);
            }
            whole
        };
        Some(found.iter().map(spread).collect())
    }

    /// Returns whether rates do not depend on velocities along drift either, so that each of its
    /// directions is a double eigenvalue zero; `None` if this holds for some directions only.
    fn is_free(&self, drift: &[Vec<Complex64>]) -> Option<bool> {
        let changes = |row: usize, along: &[Complex64]| {
            let of_velocities = self.rates[row].iter().filter(|(_, is_velocity, _)| *is_velocity);
            let change: f64 = of_velocities.map(|(at, _, entry)| entry * along[*at].re).sum();
            change.abs() / self.row_size(row)
        };
        let rows = 0..self.order.len();
        let most = |along: &Vec<Complex64>| {
            rows.clone().map(|row| changes(row, along)).fold(0.0, f64::max)
        };
        let changes: Vec<f64> = drift.iter().map(most).collect();
        let is_none = changes.iter().all(|change| *change <= DRIFT);
        let is_one_that_slows = changes.len() == 1 && changes[0] > DOUBTFUL;
        (is_none || is_one_that_slows).then_some(is_none)
    }

    /// Returns the change of a rate when all coordinates, velocities and states change by their
    /// scales.
    fn row_size(&self, row: usize) -> f64 {
        let entries = self.rates[row].iter().map(|(at, is_velocity, entry)| {
            if *is_velocity { entry * self.speed_scale(*at) } else { *entry }
        });
        let size = entries.map(|entry| entry * entry).sum::<f64>().sqrt();
        if size > 0.0 { size } else { 1.0 }
    }

    fn is_coordinate(&self, place: usize) -> bool {
        self.order[place] < self.motions.coordinates
    }

    /// Returns the ratio of the scales of a velocity and its coordinate.
    fn speed_scale(&self, place: usize) -> f64 {
        let (index, n) = (self.order[place], self.motions.coordinates);
        self.motions.scales[n + index] / self.motions.scales[index]
    }

    /// Returns an eigenvalue with its vectors, iterated until it settles: relative to the largest
    /// terms of T x, the residual is no measure of a small eigenvalue.
    fn found(&self, value: Complex64) -> Option<Found> {
        let mut value = value;
        let mut change = f64::INFINITY;
        for _ in 0..ROUNDS {
            let [right, left] = self.vectors(value);
            let [residual, _] = self.pencil.times(value, &right);
            let [slope, size] = self.pencil.slope_times(value, &right);
            let dot =
                |row: &[Complex64]| -> Complex64 { left.iter().zip(row).map(|(w, x)| w * x).sum() };
            let overlap = dot(&slope);
            let terms: f64 = left.iter().zip(&size).map(|(w, x)| w.norm_sqr().sqrt() * x.re).sum();
            if overlap.is_nan() || overlap.norm() <= ACROSS * terms {
                return None;
            }
            let better = value - dot(&residual) / overlap;
            let better = if value.im == 0.0 { Complex64::from(better.re) } else { better };
            let before = std::mem::replace(&mut change, (better - value).norm());
            value = better;
            // Newton's steps decrease until they are rounding.
            let is_settled = change <= 4.0 * f64::EPSILON * value.norm() || change >= 0.5 * before;
            let [residual, size] = self.pencil.times(value, &right);
            if is_settled && largest(&residual) <= RESIDUAL * largest(&size) {
                let moving = right
                    .iter()
                    .enumerate()
                    .map(|(place, x)| if self.is_coordinate(place) { x * value } else { *x });
                let moving: Vec<Complex64> = moving.collect();
                let momenta = self.pencil.momenta(value, &left);
                let right = self.unfolded(&right, &moving, false);
                return Some(Found { value, right, left: self.unfolded(&momenta, &left, true) });
            }
        }
        None
    }

    /// Returns right and left vectors of T by inverse iteration, with largest entries of absolute
    /// value 1.
    fn vectors(&self, value: Complex64) -> [Vec<Complex64>; 2] {
        let factors = self.pencil.factors(value);
        [Factors::solve, Factors::solve_transposed].map(|solve| {
            let mut vector = self.start.clone();
            for _ in 0..ITERATIONS {
                solve(&factors, &mut vector);
                let largest = largest(&vector);
                for x in &mut vector {
                    *x /= largest;
                }
            }
            vector
        })
    }

    /// Returns whether eigenvalues have the sum and the sum of squares of the whole part.
    fn is_all(&self, found: &[Found]) -> bool {
        let [mut sums, mut sizes] = [[0.0; 2]; 2];
        for Found { value, .. } in found {
            let times = if value.im > 0.0 { 2.0 } else { 1.0 };
            for (power, of_value) in [*value, value * value].into_iter().enumerate() {
                sums[power] += times * of_value.re;
                sizes[power] += times * of_value.norm();
            }
        }
        let traces = self.pencil.traces();
        (0..2).all(|power| (sums[power] - traces[power]).abs() <= SUMS * sizes[power])
    }

    /// Expands a motion or a left vector, given as coordinates and as velocities and states in
    /// order, to \[q, q', z\] over their scales.
    fn unfolded(
        &self,
        coordinates: &[Complex64],
        others: &[Complex64],
        is_left: bool,
    ) -> DVector<Complex64> {
        let n = self.motions.coordinates;
        let mut whole = DVector::zeros(2 * n + self.motions.first_order);
        for (place, index) in self.order.iter().enumerate() {
            let scale = if self.is_coordinate(place) { self.speed_scale(place) } else { 1.0 };
            if self.is_coordinate(place) {
                whole[*index] = coordinates[place];
            }
            whole[n + index] = if is_left { others[place] * scale } else { others[place] / scale };
        }
        whole
    }
}

/// Returns whether two entries are the same one: close eigenvalues with equal shapes.
fn has_one_twice(found: &[Found]) -> bool {
    let mut order: Vec<&Found> = found.iter().collect();
    order.sort_by(|a, b| a.value.im.total_cmp(&b.value.im).then(a.value.re.total_cmp(&b.value.re)));
    order.windows(2).any(|pair| {
        let [a, b] = pair else { return false };
        let alike = a.right.dotc(&b.right).norm() / (a.right.norm() * b.right.norm());
        (a.value - b.value).norm() <= SAME * a.value.norm() && alike > 1.0 - SAME
    })
}

/// Returns the absolute value of the largest entry.
fn largest(vector: &[Complex64]) -> f64 {
    // Squares of entries are in range for all vectors here; `norm` is some ten times slower.
    vector.iter().map(Complex64::norm_sqr).fold(0.0, f64::max).sqrt()
}
