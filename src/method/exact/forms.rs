//! The quadratic forms of a machine whose state is \[q, q'\], and the modes they share.

use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

use super::chain;
use super::piece::Piece;
use crate::method::Stretch;

/// Deviations from symmetry and from common modes that rounding makes, relative.
pub(super) const ROUNDING: f64 = 1e-11;

/// Matrices of more rows take seconds.
const MOST_OF_MATRICES: usize = 400;

/// M, K and D.
pub(super) struct Forms {
    pub(super) mass: Mass,
    /// Nonzeros.
    stiffness: Vec<(usize, usize, f64)>,
    damping: Vec<(usize, usize, f64)>,
}

/// M.
pub(super) enum Mass {
    /// Inertia of each coordinate alone.
    Diagonal(Vec<f64>),
    Full(DMatrix<f64>),
}

/// Modes by columns, of length one by mass, with x^T K x and x^T D x of each.
pub(super) struct Modes {
    pub(super) stiffnesses: Vec<f64>,
    pub(super) dampings: Vec<f64>,
    pub(super) shapes: DMatrix<f64>,
    /// How far rounding has mixed them, where that is known.
    pub(super) mixing: f64,
}

impl Forms {
    /// Nothing if the state is another, a rate of a position not its velocity, or a wave
    /// acts on that.
    pub(super) fn of(piece: &Piece, stretch: &Stretch<'_>) -> Option<Self> {
        let shape = stretch.system.simulator().shape();
        let n = shape.coordinates;
        if n == 0 || shape.positions != n || shape.first_order != 0 || shape.quadratures != 0 {
            return None;
        }
        let (upper, lower): (Vec<_>, Vec<_>) =
            piece.entries.iter().copied().filter(|entry| entry.2 != 0.0).partition(|e| e.0 < n);
        let is_kinematic = upper.len() == n
            && upper.iter().all(|&(row, column, value)| {
                column == row + n && value.to_bits() == 1.0_f64.to_bits()
            });
        let mut forces = piece.waves.iter().flat_map(|wave| &wave.amplitudes);
        if !is_kinematic || forces.any(|(entry, _)| *entry < n) {
            return None;
        }
        let mass = Mass::of(piece, stretch, n);
        let part = |first: usize| {
            let part = lower.iter().filter(|(_, column, _)| column / n == first / n);
            let part = part.map(|&(row, column, value)| (row - n, column - first, -value));
            mass.times_entries(n, &part.collect::<Vec<_>>())
        };
        let (stiffness, damping) = (part(0), part(n));
        Some(Self { mass, stiffness, damping })
    }

    /// Nothing if there are none that all share. Those of a chain may be mixed by more than
    /// the tolerance if it is too long for matrices, which keep apart even equal modes.
    pub(super) fn modes(&self, rtol: f64) -> Option<Modes> {
        let of_chain = self.modes_of_chain();
        if of_chain.as_ref().is_some_and(|modes| modes.mixing <= rtol) {
            return of_chain;
        }
        let is_short = self.mass.len() <= MOST_OF_MATRICES;
        if of_chain.is_none() || is_short { self.modes_of_matrices() } else { of_chain }
    }

    /// Of a line of springs, damped not at all or as Rayleigh's.
    fn modes_of_chain(&self) -> Option<Modes> {
        let Mass::Diagonal(mass) = &self.mass else { return None };
        let [by_mass, by_stiffness] = self.rayleigh(mass)?;
        let chain = chain::modes(mass, &self.stiffness)?;
        let (stiffnesses, shapes, mixing) = (chain.eigenvalues, chain.shapes, chain.mixing);
        let dampings = stiffnesses.iter().map(|k| by_mass + by_stiffness * k).collect();
        Some(Modes { stiffnesses, dampings, shapes, mixing })
    }

    /// a and b of D = a M + b K; nothing if D is another.
    fn rayleigh(&self, mass: &[f64]) -> Option<[f64; 2]> {
        let largest = |entries: &[(usize, usize, f64)]| {
            entries.iter().fold(0.0, |size: f64, entry| size.max(entry.2.abs()))
        };
        let size = largest(&self.damping);
        if size == 0.0 {
            return Some([0.0; 2]);
        }
        let known = |entries: &[(usize, usize, f64)], row: usize, column: usize| {
            let found = entries.iter().find(|entry| (entry.0, entry.1) == (row, column));
            found.map_or(0.0, |entry| entry.2)
        };
        // Any spring tells b, then any inertia a.
        let is_coupling = |entry: &&(usize, usize, f64)| entry.0 != entry.1;
        let by_stiffness = match self.stiffness.iter().find(is_coupling) {
            Some(&(row, column, spring)) => known(&self.damping, row, column) / spring,
            None => 0.0,
        };
        let on_diagonal = known(&self.damping, 0, 0) - by_stiffness * known(&self.stiffness, 0, 0);
        let by_mass = on_diagonal / mass[0];
        let by_mass = if (by_mass * mass[0]).abs() <= ROUNDING * size { 0.0 } else { by_mass };
        let mut rest: Vec<(usize, usize, f64)> = self.damping.clone();
        rest.extend(
            self.stiffness.iter().map(|&(row, column, k)| (row, column, -by_stiffness * k)),
        );
        rest.extend(mass.iter().enumerate().map(|(index, m)| (index, index, -by_mass * m)));
        rest.sort_by_key(|entry| (entry.0, entry.1));
        let sums = rest.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1));
        let sums = sums.map(|chunk| chunk.iter().map(|entry| entry.2).sum::<f64>().abs());
        (sums.fold(0.0, f64::max) <= ROUNDING * size).then_some([by_mass, by_stiffness])
    }

    /// Of any symmetric matrices.
    fn modes_of_matrices(&self) -> Option<Modes> {
        let n = self.mass.len();
        let full = |entries: &[(usize, usize, f64)]| {
            let mut matrix = DMatrix::zeros(n, n);
            for &(row, column, value) in entries {
                matrix[(row, column)] += value;
            }
            symmetric(&matrix)
        };
        let (stiffness, damping) = (full(&self.stiffness)?, full(&self.damping)?);
        let mass = match &self.mass {
            Mass::Diagonal(mass) => DMatrix::from_diagonal(&DVector::from_column_slice(mass)),
            Mass::Full(mass) => mass.clone(),
        };
        let inverse = Cholesky::new(mass.clone())?.l().try_inverse()?;
        let mut shapes = modes_of(&stiffness, &inverse)?;
        let stiffnesses = stiffnesses(&stiffness, &mass, &mut shapes);
        let dampings = dampings(&damping, &shapes)?;
        Some(Modes { stiffnesses, dampings, shapes, mixing: 0.0 })
    }
}

impl Mass {
    fn of(piece: &Piece, stretch: &Stretch<'_>, n: usize) -> Self {
        let system = stretch.system;
        let pattern = system.simulator().mass_matrix_pattern();
        let mut values = vec![0.0; pattern.entries.len()];
        let middle = 0.5 * (piece.from + piece.until);
        let rest = vec![0.0; 2 * n];
        system.simulator().mass_matrix(middle, &rest, system.parameters(), &mut values);
        if pattern.entries.iter().all(|(row, column)| row == column) {
            let mut mass = vec![0.0; n];
            for (&(row, _), value) in pattern.entries.iter().zip(values) {
                mass[row as usize] = value;
            }
            return Mass::Diagonal(mass);
        }
        let mut mass = DMatrix::zeros(n, n);
        for (&(row, column), value) in pattern.entries.iter().zip(values) {
            mass[(row as usize, column as usize)] = value;
        }
        Mass::Full(mass)
    }

    /// Number of coordinates.
    pub(super) fn len(&self) -> usize {
        match self {
            Mass::Diagonal(mass) => mass.len(),
            Mass::Full(mass) => mass.nrows(),
        }
    }

    /// M x.
    pub(super) fn times(&self, x: &[f64]) -> DVector<f64> {
        match self {
            Mass::Diagonal(mass) => {
                DVector::from_iterator(x.len(), mass.iter().zip(x).map(|(mass, x)| mass * x))
            }
            Mass::Full(mass) => mass * DVector::from_column_slice(x),
        }
    }

    /// A row of M times x.
    pub(super) fn row_times(&self, row: usize, x: &[f64]) -> f64 {
        match self {
            Mass::Diagonal(mass) => mass[row] * x[row],
            Mass::Full(mass) => mass.column(row).iter().zip(x).map(|(mass, x)| mass * x).sum(),
        }
    }

    /// M times a matrix of these entries, likewise.
    fn times_entries(&self, n: usize, entries: &[(usize, usize, f64)]) -> Vec<(usize, usize, f64)> {
        match self {
            Mass::Diagonal(mass) => {
                entries.iter().map(|&(row, column, v)| (row, column, mass[row] * v)).collect()
            }
            Mass::Full(mass) => {
                let mut matrix = DMatrix::zeros(n, n);
                for &(row, column, value) in entries {
                    matrix[(row, column)] += value;
                }
                let product = mass * matrix;
                let places = (0..n).flat_map(|row| (0..n).map(move |column| (row, column)));
                let all = places.map(|(row, column)| (row, column, product[(row, column)]));
                all.filter(|entry| entry.2 != 0.0).collect()
            }
        }
    }
}

/// The symmetric part of a matrix that is symmetric to rounding.
fn symmetric(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let transposed = matrix.transpose();
    let deviation = (matrix - &transposed).amax();
    (deviation <= ROUNDING * matrix.amax()).then(|| (matrix + transposed) * 0.5)
}

/// Modes by columns, of length one by mass.
fn modes_of(stiffness: &DMatrix<f64>, inverse: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = stiffness.nrows();
    if n == 1 {
        return Some(inverse.clone());
    }
    let reduced = inverse * stiffness * inverse.transpose();
    let reduced = (&reduced + reduced.transpose()) * 0.5;
    let most = 100 * n;
    let eigen = SymmetricEigen::try_new(reduced, f64::EPSILON, most)?;
    Some(inverse.tr_mul(&eigen.eigenvectors))
}

/// x^T K x of every mode; the modes get the length 1 by mass again.
///
/// An eigenvalue is found to the rounding of the largest one. Rayleigh's quotient
/// squares the error of the mode, and written by differences,
///
/// ```text
/// x^T K x = sum_i (sum_j K_ij) x_i^2 - sum_(i<j) K_ij (x_i - x_j)^2
/// ```
///
/// it does not cancel for slow modes of stiff chains: they keep their digits.
fn stiffnesses(
    stiffness: &DMatrix<f64>,
    mass: &DMatrix<f64>,
    shapes: &mut DMatrix<f64>,
) -> Vec<f64> {
    let n = stiffness.nrows();
    let to_ground: Vec<f64> = stiffness.row_iter().map(|row| row.sum()).collect();
    let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
    let springs: Vec<(usize, usize, f64)> = pairs
        .map(|(i, j)| (i, j, stiffness[(i, j)]))
        .filter(|(_, _, spring)| *spring != 0.0)
        .collect();
    let mut quotients = Vec::with_capacity(n);
    for mut shape in shapes.column_iter_mut() {
        let length = shape.dot(&(mass * &shape)).sqrt();
        shape /= length;
        let ground: f64 = to_ground.iter().zip(shape.iter()).map(|(k, x)| k * x * x).sum();
        let between: f64 =
            springs.iter().map(|&(i, j, spring)| spring * (shape[i] - shape[j]).powi(2)).sum();
        quotients.push(ground - between);
    }
    quotients
}

/// x^T D x of every mode, if the modes share no damper.
fn dampings(damping: &DMatrix<f64>, shapes: &DMatrix<f64>) -> Option<Vec<f64>> {
    if damping.iter().all(|value| *value == 0.0) {
        return Some(vec![0.0; shapes.ncols()]);
    }
    let modal = shapes.tr_mul(&(damping * shapes));
    let diagonal: Vec<f64> = modal.diagonal().iter().copied().collect();
    // What is computed as zero is zero to the rounding of the largest.
    let rounding = 4.0 * f64::EPSILON * modal.nrows() as f64 * modal.amax();
    let shared = (0..modal.ncols()).any(|column| {
        (0..modal.nrows()).any(|row| {
            let size = (diagonal[row] * diagonal[column]).abs().sqrt();
            row != column && modal[(row, column)].abs() > rounding.max(ROUNDING * size)
        })
    });
    (!shared).then_some(diagonal)
}
