//! By modes: M q'' + D q' + K q = f(t) with symmetric K and D that share the modes
//! of K, as without damping or with Rayleigh's.

use nalgebra::{Cholesky, Complex, DMatrix, DVector, SymmetricEigen};

use super::Solution;
use super::piece::Piece;
use super::response::responses;
use crate::method::Stretch;

/// Deviations from symmetry and from common modes that rounding makes, relative.
const ROUNDING: f64 = 1e-11;
/// (eigenvalue distance times span) below which two eigenvalues count as one: what
/// is neglected is of its square, what is avoided is a loss of its inverse in digits.
const EQUAL: f64 = 1e-5;
/// Two eigenvalues that are closer than this part of their size, but not equal, cost
/// as many digits: no longer worth it.
const CLOSE: f64 = 1e-3;

/// All modes of a piece, and where each starts.
pub(super) struct Modal<'a> {
    piece: &'a Piece,
    /// Modes by columns, normalized by mass.
    shapes: DMatrix<f64>,
    modes: Vec<Mode>,
    /// Each wave in local time; see [`Piece::local`].
    locals: Vec<Vec<Complex<f64>>>,
}

/// x'' + d x' + k x = f, by its two eigenvalues.
struct Mode {
    eigenvalues: [Complex<f64>; 2],
    is_double: bool,
    /// x and x' at the start.
    start: [f64; 2],
    /// For each wave the amplitude on this mode.
    amplitudes: Vec<Complex<f64>>,
}

impl<'a> Modal<'a> {
    /// Nothing if the machine has no such modes, or not to the last digits.
    pub(super) fn new(piece: &'a Piece, stretch: &Stretch<'_>, state: &[f64]) -> Option<Self> {
        let mass = mass_matrix(piece, stretch)?;
        let n = mass.nrows();
        let stiffness = symmetric(&-(&mass * piece.matrix.view((n, 0), (n, n))))?;
        let damping = symmetric(&-(&mass * piece.matrix.view((n, n), (n, n))))?;
        let factor = Cholesky::new(mass.clone())?.l();
        let inverse = factor.try_inverse()?;
        let mut shapes = modes_of(&stiffness, &inverse)?;
        let stiffnesses = stiffnesses(&stiffness, &mass, &mut shapes);
        let dampings = dampings(&damping, &shapes)?;
        let (position, velocity) =
            (DVector::from_column_slice(&state[..n]), DVector::from_column_slice(&state[n..]));
        let [position, velocity] =
            [position, velocity].map(|vector| shapes.tr_mul(&(&mass * vector)));
        let mut modes = Vec::with_capacity(n);
        for index in 0..n {
            let (eigenvalues, is_double) =
                eigenvalues(stiffnesses[index], dampings[index], piece.span())?;
            // f acts on accelerations as M^-1 f; so f is M times that.
            let force = |(entry, amplitude): &(usize, Complex<f64>)| {
                amplitude * mass.column(entry - n).dot(&shapes.column(index))
            };
            let amplitudes =
                piece.waves.iter().map(|wave| wave.amplitudes.iter().map(force).sum()).collect();
            let start = [position[index], velocity[index]];
            modes.push(Mode { eigenvalues, is_double, start, amplitudes });
        }
        let locals = piece.waves.iter().map(|wave| piece.local(wave)).collect();
        Some(Modal { piece, shapes, modes, locals })
    }

    /// How many modes there are.
    pub(super) fn modes(&self) -> usize {
        self.modes.len()
    }
}

impl Solution for Modal<'_> {
    fn state_at(&mut self, time: f64, state: &mut [f64]) {
        let h = time - self.piece.from;
        let n = self.modes.len();
        let mut moved = DMatrix::zeros(n, 2);
        for (index, mode) in self.modes.iter().enumerate() {
            let [mut position, mut velocity] = mode.free(h);
            for ((wave, local), amplitude) in
                self.piece.waves.iter().zip(&self.locals).zip(&mode.amplitudes)
            {
                if *amplitude == Complex::ZERO {
                    continue;
                }
                let forced = mode.forced(wave.mu, h, local);
                position += (amplitude * forced[0]).re;
                velocity += (amplitude * forced[1]).re;
            }
            moved[(index, 0)] = position;
            moved[(index, 1)] = velocity;
        }
        state.copy_from_slice((&self.shapes * moved).as_slice());
    }

    // Every state is computed from the start.
    fn settle(&mut self, _time: f64, _state: &[f64]) {}
}

impl Mode {
    /// x and x' after h from the start, without excitation.
    fn free(&self, h: f64) -> [f64; 2] {
        let [a, b] = self.eigenvalues;
        let [x, v] = self.start;
        let (of_a, of_b) = ((a * h).exp(), (b * h).exp());
        // x = x_0 c + v_0 s, with s the response to an impulse and c = s' - (a + b) s.
        let (s, s_dot, s_dot_dot) = if self.is_double {
            (of_a * h, of_a * (a * h + 1.0), of_a * a * (a * h + 2.0))
        } else {
            let distance = a - b;
            (
                (of_a - of_b) / distance,
                (a * of_a - b * of_b) / distance,
                (a * a * of_a - b * b * of_b) / distance,
            )
        };
        let sum = a + b;
        let (c, c_dot) = if self.is_double {
            (s_dot - sum * s, s_dot_dot - sum * s_dot)
        } else {
            // Without the cancellation, where one eigenvalue is far larger.
            ((a * of_b - b * of_a) / (a - b), -(a * b) * s)
        };
        [(c * x + s * v).re, (c_dot * x + s_dot * v).re]
    }

    /// x and x' after h from rest, excited by `sum_j local_j s^j e^(mu s)`.
    fn forced(&self, mu: Complex<f64>, h: f64, local: &[Complex<f64>]) -> [Complex<f64>; 2] {
        let [a, b] = self.eigenvalues;
        let highest = local.len() as u32 - 1;
        let sum = |parts: &mut dyn Iterator<Item = Complex<f64>>| {
            local.iter().zip(parts).map(|(local, part)| local * part).sum::<Complex<f64>>()
        };
        if self.is_double {
            // The impulse response is (h - s) e^(a (h - s)).
            let of = responses(a, mu, h, highest + 1);
            let once = sum(&mut of.iter().copied());
            let twice = sum(&mut of.windows(2).map(|pair| pair[0] * h - pair[1]));
            return [twice, once + a * twice];
        }
        let [of_a, of_b] = [a, b].map(|eigenvalue| responses(eigenvalue, mu, h, highest));
        let [of_a, of_b] = [of_a, of_b].map(|of| sum(&mut of.iter().copied()));
        let distance = a - b;
        [(of_a - of_b) / distance, (a * of_a - b * of_b) / distance]
    }
}

/// M, if the state is \[q, q'\] with every rate of a position its velocity and every
/// wave acting on velocities.
fn mass_matrix(piece: &Piece, stretch: &Stretch<'_>) -> Option<DMatrix<f64>> {
    let system = stretch.system;
    let shape = system.simulator().shape();
    let n = shape.coordinates;
    if n == 0 || shape.positions != n || shape.first_order != 0 || shape.quadratures != 0 {
        return None;
    }
    let mut kinematic = DMatrix::zeros(n, 2 * n);
    kinematic.view_mut((0, n), (n, n)).fill_with_identity();
    let is_kinematic = piece.matrix.rows(0, n) == kinematic;
    let mut forces = piece.waves.iter().flat_map(|wave| &wave.amplitudes);
    if !is_kinematic || forces.any(|(entry, _)| *entry < n) {
        return None;
    }
    let pattern = system.simulator().mass_matrix_pattern();
    let mut values = vec![0.0; pattern.entries.len()];
    let middle = 0.5 * (piece.from + piece.until);
    let rest = vec![0.0; 2 * n];
    system.simulator().mass_matrix(middle, &rest, system.parameters(), &mut values);
    let mut mass = DMatrix::zeros(n, n);
    for (&(row, column), value) in pattern.entries.iter().zip(values) {
        mass[(row as usize, column as usize)] = value;
    }
    Some(mass)
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

/// Roots of l^2 + d l + k, and whether they count as one; nothing if they are too
/// close to be told apart without loss.
fn eigenvalues(stiffness: f64, damping: f64, span: f64) -> Option<([Complex<f64>; 2], bool)> {
    let middle = -0.5 * damping;
    let distance = Complex::new(0.25 * damping * damping - stiffness, 0.0).sqrt();
    let size = stiffness.abs().sqrt().max(damping.abs());
    if distance.norm() * span <= EQUAL && (size * span <= EQUAL || distance.norm() <= EQUAL * size)
    {
        let middle = Complex::new(middle, 0.0);
        return Some(([middle, middle], true));
    }
    if distance.norm() <= CLOSE * size {
        return None;
    }
    if distance.im != 0.0 || damping == 0.0 {
        return Some(([middle + distance, middle - distance], false));
    }
    // Real roots: the smaller one by Vieta, without cancellation.
    let large = middle - distance.re.copysign(damping);
    let small = stiffness / large;
    Some(([Complex::new(small, 0.0), Complex::new(large, 0.0)], false))
}
