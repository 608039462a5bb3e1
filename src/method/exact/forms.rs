//! Quadratic forms of a machine whose state is \[q, q'\], and their common eigenmodes.

use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

use super::chain;
use super::piece::Piece;
use crate::dense::dense;
use crate::method::Stretch;

/// Relative deviation from symmetry and from common eigenmodes that counts as rounding.
pub(super) const ROUNDING: f64 = 1e-11;

/// Maximum number of rows; larger matrices take seconds.
const MOST_OF_MATRICES: usize = 400;

/// Relative size of K M^-1 D - D M^-1 K above which K and D have no common eigenmodes. It is far
/// above rounding, so eigenmodes need not be computed.
const APART: f64 = 1e-6;

/// Matrices M, K and D.
pub(super) struct Forms {
    pub(super) mass: Mass,
    /// Nonzeros of K and D.
    stiffness: Vec<(usize, usize, f64)>,
    damping: Vec<(usize, usize, f64)>,
}

/// Mass matrix M.
pub(super) enum Mass {
    /// One inertia for each coordinate.
    Diagonal(Vec<f64>),
    Full(DMatrix<f64>),
}

/// Eigenmodes as columns, normalized by mass, with x^T K x and x^T D x of each.
pub(super) struct Modes {
    pub(super) stiffnesses: Vec<f64>,
    pub(super) dampings: Vec<f64>,
    pub(super) shapes: DMatrix<f64>,
    /// Amount of mixing due to rounding, where it is known.
    pub(super) mixing: f64,
}

impl Forms {
    /// Returns `None` if the state has another form, if the rate of a position is not its velocity,
    /// or if a wave acts on such a rate.
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

    /// Returns the common eigenmodes, if they exist. A chain that is too long for matrices, which
    /// separate even equal eigenmodes, may have ones that are mixed by more than the tolerance.
    pub(super) fn modes(&self, rtol: f64) -> Option<Modes> {
        let of_chain = self.modes_of_chain();
        if of_chain.as_ref().is_some_and(|modes| modes.mixing <= rtol) {
            return of_chain;
        }
        let is_short = self.mass.len() <= MOST_OF_MATRICES;
        if of_chain.is_some() && !is_short {
            return of_chain;
        }
        if self.share_none() { None } else { self.modes_of_matrices() }
    }

    /// Returns whether K and D clearly have no common eigenmodes, because they do not commute. This
    /// is decided from their entries; computing eigenmodes takes the cube of the rows.
    fn share_none(&self) -> bool {
        let Mass::Diagonal(mass) = &self.mass else { return false };
        let by_mass = |entries: &[(usize, usize, f64)]| {
            let mut rows = vec![Vec::new(); mass.len()];
            let mut largest: f64 = 0.0;
            for &(row, column, value) in entries {
                let value = value / (mass[row] * mass[column]).sqrt();
                rows[row].push((column, value));
                largest = largest.max(value.abs());
            }
            (rows, largest)
        };
        let (stiffness, stiffest) = by_mass(&self.stiffness);
        let (damping, most_damped) = by_mass(&self.damping);
        let allowed = APART * stiffest * most_damped;
        let mut sums = vec![0.0; mass.len()];
        let mut touched = Vec::new();
        (0..mass.len()).any(|row| {
            for (sign, first, second) in [(1.0, &stiffness, &damping), (-1.0, &damping, &stiffness)]
            {
                for (middle, factor) in &first[row] {
                    for (column, value) in &second[*middle] {
                        sums[*column] += sign * factor * value;
                        touched.push(*column);
                    }
                }
            }
            // Sums are cleared as they are read: a repeated entry is zero the second time.
            touched.drain(..).any(|column| std::mem::take::<f64>(&mut sums[column]).abs() > allowed)
        })
    }

    /// Returns the eigenmodes of a line of springs, without damping or with Rayleigh damping.
    fn modes_of_chain(&self) -> Option<Modes> {
        let Mass::Diagonal(mass) = &self.mass else { return None };
        let [by_mass, by_stiffness] = self.rayleigh(mass)?;
        let chain = chain::modes(mass, &self.stiffness)?;
        let (stiffnesses, shapes, mixing) = (chain.eigenvalues, chain.shapes, chain.mixing);
        let dampings = stiffnesses.iter().map(|k| by_mass + by_stiffness * k).collect();
        Some(Modes { stiffnesses, dampings, shapes, mixing })
    }

    /// Returns a and b of D = a M + b K; `None` if D has another form.
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
        // Any spring determines b, then any inertia a.
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

    /// Returns the eigenmodes of symmetric matrices.
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
        Mass::Full(dense(pattern, &values))
    }

    /// Returns the number of coordinates.
    pub(super) fn len(&self) -> usize {
        match self {
            Mass::Diagonal(mass) => mass.len(),
            Mass::Full(mass) => mass.nrows(),
        }
    }

    /// Returns M x.
    pub(super) fn times(&self, x: &[f64]) -> DVector<f64> {
        match self {
            Mass::Diagonal(mass) => {
                DVector::from_iterator(x.len(), mass.iter().zip(x).map(|(mass, x)| mass * x))
            }
            Mass::Full(mass) => mass * DVector::from_column_slice(x),
        }
    }

    /// Returns a row of M times x.
    pub(super) fn row_times(&self, row: usize, x: &[f64]) -> f64 {
        match self {
            Mass::Diagonal(mass) => mass[row] * x[row],
            Mass::Full(mass) => mass.column(row).iter().zip(x).map(|(mass, x)| mass * x).sum(),
        }
    }

    /// Returns M times a matrix, both by entries.
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

/// Returns the symmetric part of a matrix that is symmetric to rounding.
fn symmetric(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let transposed = matrix.transpose();
    let deviation = (matrix - &transposed).amax();
    (deviation <= ROUNDING * matrix.amax()).then(|| (matrix + transposed) * 0.5)
}

/// Returns eigenmodes as columns, normalized by mass.
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

/// Returns x^T K x of every eigenmode, and normalizes the eigenmodes by mass.
///
/// Eigenvalues are computed with the rounding error of the largest one. Rayleigh's quotient squares
/// the error of the eigenmode, and in terms of differences,
///
/// ```text
/// x^T K x = sum_i (sum_j K_ij) x_i^2 - sum_(i<j) K_ij (x_i - x_j)^2
/// ```
///
/// it has no cancellation for slow eigenmodes of stiff chains, which keep their digits.
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

/// Returns x^T D x of every eigenmode, if D does not couple them.
fn dampings(damping: &DMatrix<f64>, shapes: &DMatrix<f64>) -> Option<Vec<f64>> {
    if damping.iter().all(|value| *value == 0.0) {
        return Some(vec![0.0; shapes.ncols()]);
    }
    let modal = shapes.tr_mul(&(damping * shapes));
    let diagonal: Vec<f64> = modal.diagonal().iter().copied().collect();
    // Zeros are accurate to the rounding of the largest entry.
    let rounding = 4.0 * f64::EPSILON * modal.nrows() as f64 * modal.amax();
    let shared = (0..modal.ncols()).any(|column| {
        (0..modal.nrows()).any(|row| {
            let size = (diagonal[row] * diagonal[column]).abs().sqrt();
            row != column && modal[(row, column)].abs() > rounding.max(ROUNDING * size)
        })
    });
    (!shared).then_some(diagonal)
}

#[cfg(test)]
mod tests {
    use super::*;

    const N: usize = 6;

    /// Returns rotors on springs with the given damping.
    fn forms(damping: impl Fn(usize, usize, f64) -> f64) -> Forms {
        let inertia = |row: usize| 1.0 + 0.5 * row as f64;
        let spring = |row: usize, column: usize| match row.abs_diff(column) {
            0 => 2000.0 + 300.0 * row as f64,
            1 => -900.0 - 50.0 * (row + column) as f64,
            _ => 0.0,
        };
        let places = || (0..N).flat_map(|row| (0..N).map(move |column| (row, column)));
        let entries = |value: &dyn Fn(usize, usize) -> f64| {
            let all = places().map(|(row, column)| (row, column, value(row, column)));
            all.filter(|entry| entry.2 != 0.0).collect()
        };
        Forms {
            mass: Mass::Diagonal((0..N).map(inertia).collect()),
            stiffness: entries(&spring),
            damping: entries(&|row, column| damping(row, column, spring(row, column))),
        }
    }

    #[test]
    fn matrices_that_share_modes_are_not_told_apart() {
        let inertia = |row: usize| 1.0 + 0.5 * row as f64;
        let rayleigh = forms(|row, column, spring| {
            1e-4 * spring + if row == column { 0.3 * inertia(row) } else { 0.0 }
        });
        // K M^-1 K is not a combination of M and K.
        let springs = forms(|_, _, spring| spring);
        let stiffness = |row: usize, column: usize| {
            let found = springs.damping.iter().find(|entry| (entry.0, entry.1) == (row, column));
            found.map_or(0.0, |entry| entry.2)
        };
        let squared = forms(|row, column, _| {
            (0..N).map(|at| stiffness(row, at) * stiffness(at, column) / inertia(at)).sum()
        });
        for forms in [forms(|_, _, _| 0.0), rayleigh, squared] {
            assert!(!forms.share_none());
            assert!(forms.modes(1e-9).is_some());
        }
    }

    #[test]
    fn matrices_without_common_modes_are_seen_by_their_entries() {
        for place in 0..N {
            let braked = forms(|row, column, spring| {
                1e-4 * spring + if (row, column) == (place, place) { 0.5 } else { 0.0 }
            });
            assert!(braked.share_none());
            assert!(braked.modes_of_matrices().is_none());
        }
    }
}
