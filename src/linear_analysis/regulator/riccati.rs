//! Algebraic Riccati equations.
//!
//! ```text
//! A^T X + X A - (X B + N) R^-1 (X B + N)^T + Q = 0                           continuous
//! A^T X A - X - (A^T X B + N) (R + B^T X B)^-1 (A^T X B + N)^T + Q = 0       sampled
//! ```
//!
//! A structure-preserving doubling algorithm finds the stabilizing X (E. K.-W. Chu, H.-Y. Fan and
//! W.-W. Lin, A structure-preserving doubling algorithm for continuous-time algebraic Riccati
//! equations, Linear Algebra and its Applications 396, 2005), for matrices that are balanced like a
//! Hamiltonian. Newton's method (Kleinman 1968, Hewer 1971), in the form of a correction by the
//! residual of the equation as given, then removes the errors of the doubling.

use nalgebra::linalg::Schur;
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

use crate::dense::balance;
use crate::linear_analysis::state_space::eigenvalues_about;

/// Maximum number of doublings: rates that differ by a factor 2^40 need as many.
const DOUBLINGS: usize = 60;
/// Maximum number of corrections; three are usual.
const CORRECTIONS: usize = 20;
/// Largest residual relative to the terms of the equation.
const ACCEPTED: f64 = 1e-9;
/// Shifts of the Cayley transformation that are tried, relative to the norm of A.
const SHIFTS: [f64; 7] = [0.3, 3.0, 0.03, 30.0, 3e-3, 3e-4, 3e-5];

/// Kind of time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Time {
    Continuous,
    Sampled,
}

/// A Riccati equation. R is positive definite.
#[derive(Debug, Clone)]
pub struct Riccati {
    pub time: Time,
    pub a: DMatrix<f64>,
    pub b: DMatrix<f64>,
    pub q: DMatrix<f64>,
    pub r: DMatrix<f64>,
    pub n: DMatrix<f64>,
}

/// The stabilizing solution.
#[derive(Debug, Clone)]
pub struct Solution {
    pub x: DMatrix<f64>,
    /// K of the stable matrix A - B K: R^-1 (X B + N)^T, or (R + B^T X B)^-1 (A^T X B + N)^T.
    pub gain: DMatrix<f64>,
}

impl Riccati {
    /// Returns the stabilizing solution; `None` if there is none, or if it was not found.
    pub fn solve(&self) -> Option<Solution> {
        let size = self.a.nrows();
        if size == 0 {
            let gain = DMatrix::zeros(self.b.ncols(), 0);
            return Some(Solution { x: DMatrix::zeros(0, 0), gain });
        }
        let scales = self.scales()?;
        let scaled = self.scaled(&scales);
        let starts = match self.time {
            Time::Sampled => vec![scaled.doubled_of_samples()],
            Time::Continuous => SHIFTS.map(|shift| scaled.doubled_of_flow(shift)).to_vec(),
        };
        let corrected = starts.into_iter().flatten().find_map(|x| scaled.corrected(x))?;
        let by = |row: usize, column: usize| 1.0 / (scales[row] * scales[column]);
        let x = corrected.map_with_location(|row, column, x| x * by(row, column));
        let gain = self.gain(&x)?;
        Some(Solution { x, gain })
    }

    /// Returns scales D of the states, powers of 2, so that the Hamiltonian matrix of D^-1 A D is
    /// balanced.
    fn scales(&self) -> Option<DVector<f64>> {
        let size = self.a.nrows();
        let [a, g, q] = self.without_cross_term()?;
        let mut hamiltonian = DMatrix::zeros(2 * size, 2 * size);
        hamiltonian.view_mut((0, 0), (size, size)).copy_from(&a);
        hamiltonian.view_mut((0, size), (size, size)).copy_from(&g);
        hamiltonian.view_mut((size, 0), (size, size)).copy_from(&q);
        hamiltonian.view_mut((size, size), (size, size)).copy_from(&a.transpose());
        let both = balance(&mut hamiltonian);
        // X has the scales 1/(D_i D_j), and costate over state that of D_(n+i)/D_i.
        let scale = |index: usize| {
            let half = (both[index] / both[size + index]).log2() / 2.0;
            half.round().exp2()
        };
        Some(DVector::from_fn(size, |index, _| scale(index)))
    }

    /// Returns the equation of states divided by scales.
    fn scaled(&self, scales: &DVector<f64>) -> Self {
        let at = |row: usize, column: usize| scales[row] * scales[column];
        Self {
            time: self.time,
            a: self.a.map_with_location(|i, j, a| a * scales[j] / scales[i]),
            b: self.b.map_with_location(|i, _, b| b / scales[i]),
            q: self.q.map_with_location(|i, j, q| q * at(i, j)),
            r: self.r.clone(),
            n: self.n.map_with_location(|i, _, n| n * scales[i]),
        }
    }

    /// Returns A - B R^-1 N^T, B R^-1 B^T and Q - N R^-1 N^T.
    fn without_cross_term(&self) -> Option<[DMatrix<f64>; 3]> {
        let r = self.r.clone().cholesky()?;
        let inner = r.solve(&self.n.transpose());
        let a = &self.a - &self.b * &inner;
        let g = &self.b * r.solve(&self.b.transpose());
        let q = &self.q - &self.n * inner;
        Some([a, symmetric(g), symmetric(q)])
    }

    /// Returns X of a sampled system by doubling.
    fn doubled_of_samples(&self) -> Option<DMatrix<f64>> {
        let [a, g, q] = self.without_cross_term()?;
        doubled(a, g, q)
    }

    /// Returns X of a continuous system by doubling, after the Cayley transformation with a shift.
    fn doubled_of_flow(&self, shift: f64) -> Option<DMatrix<f64>> {
        let [a, g, q] = self.without_cross_term()?;
        let size = a.nrows();
        let norm = a.norm().max((g.norm() * q.norm()).sqrt()) / (size as f64).sqrt();
        let shift = shift * if norm > 0.0 { norm } else { 1.0 };
        let identity = DMatrix::identity(size, size);
        let shifted = &a - &identity * shift;
        let inverse = shifted.clone().try_inverse()?;
        let forward = (&shifted + &g * inverse.tr_mul(&q)).try_inverse()?;
        let start_a = identity + &forward * (2.0 * shift);
        let start_g = &inverse * &g * forward.transpose() * (2.0 * shift);
        let start_q = forward.tr_mul(&q) * &inverse * (2.0 * shift);
        doubled(start_a, symmetric(start_g), symmetric(start_q))
    }

    /// Returns K of a solution.
    fn gain(&self, x: &DMatrix<f64>) -> Option<DMatrix<f64>> {
        let (weight, pull) = match self.time {
            Time::Continuous => (self.r.clone(), x * &self.b + &self.n),
            Time::Sampled => {
                let pulled = x * &self.b;
                (&self.r + self.b.tr_mul(&pulled), self.a.tr_mul(&pulled) + &self.n)
            }
        };
        Some(symmetric(weight).cholesky()?.solve(&pull.transpose()))
    }

    /// Returns the left side of the equation at X with its gain, and the size of its terms.
    fn residual(&self, x: &DMatrix<f64>, gain: &DMatrix<f64>) -> (DMatrix<f64>, f64) {
        let (moved, weight) = match self.time {
            Time::Continuous => {
                let moved = self.a.tr_mul(x);
                (&moved + moved.transpose(), self.r.clone())
            }
            Time::Sampled => {
                let weight = &self.r + self.b.tr_mul(&(x * &self.b));
                (self.a.tr_mul(&(x * &self.a)) - x, weight)
            }
        };
        let used = gain.tr_mul(&(weight * gain));
        let size = moved.norm() + used.norm() + self.q.norm();
        (symmetric(moved - used + &self.q), size)
    }

    /// Improves a solution by Newton's method; `None` if it does not become one, or does not make
    /// the system stable.
    fn corrected(&self, start: DMatrix<f64>) -> Option<DMatrix<f64>> {
        let mut x = start;
        let mut least = f64::INFINITY;
        for _ in 0..CORRECTIONS {
            let gain = self.gain(&x)?;
            let closed = &self.a - &self.b * &gain;
            let (residual, _) = self.residual(&x, &gain);
            let change = correction(self.time, &closed, &residual)?;
            let moved = change.norm();
            // Below the rounding of X, changes do not decrease any more.
            if moved.is_nan() || moved >= 0.5 * least {
                break;
            }
            least = moved;
            x = symmetric(x + change);
            if moved <= f64::EPSILON * x.norm() {
                break;
            }
        }
        let gain = self.gain(&x)?;
        let (residual, size) = self.residual(&x, &gain);
        let is_solution = residual.norm() <= ACCEPTED * size;
        (is_solution && self.is_stable(&(&self.a - &self.b * gain))).then_some(x)
    }

    fn is_stable(&self, closed: &DMatrix<f64>) -> bool {
        let one = if self.time == Time::Sampled { 1.0 } else { 0.0 };
        let Ok(poles) = eigenvalues_about(closed.clone(), one) else { return false };
        poles.iter().all(|pole| match self.time {
            Time::Continuous => pole.re < 0.0,
            Time::Sampled => pole.norm() < 1.0,
        })
    }
}

/// Returns the limit of H in the doubling of x' = A x - G l, l = H x + A^T l'.
fn doubled(mut a: DMatrix<f64>, mut g: DMatrix<f64>, mut h: DMatrix<f64>) -> Option<DMatrix<f64>> {
    let identity = DMatrix::identity(a.nrows(), a.nrows());
    for _ in 0..DOUBLINGS {
        let factors = (&identity + &g * &h).lu();
        let moved = factors.solve(&a)?;
        // (1 + G H)^-1 G is symmetric, as is H (1 + G H)^-1.
        let inner = factors.solve(&g)?;
        let change = symmetric(a.tr_mul(&(&h * &moved)));
        g += symmetric(&a * inner * a.transpose());
        a = &a * moved;
        h += &change;
        if h.iter().any(|value| !value.is_finite()) {
            return None;
        }
        if change.norm() <= f64::EPSILON * h.norm() {
            break;
        }
    }
    Some(symmetric(h))
}

/// Returns the change of X by Newton's method: Y with C^T Y + Y C = -F, or C^T Y C - Y = -F, for the
/// closed loop C, by its Schur form.
fn correction(time: Time, closed: &DMatrix<f64>, residual: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    const ITERATIONS: usize = 100;
    let size = closed.nrows();
    let complex = closed.map(Complex64::from);
    let schur = Schur::try_new(complex, f64::EPSILON, ITERATIONS * size)?;
    let (u, t) = schur.unpack();
    let f = u.ad_mul(&(residual.map(Complex64::from) * &u));
    let adjoint = t.adjoint();
    let mut y = DMatrix::<Complex64>::zeros(size, size);
    for column in 0..size {
        let earlier = y.columns(0, column) * t.view((0, column), (column, 1));
        let mut right = -f.column(column).into_owned();
        let own = t[(column, column)];
        let matrix = match time {
            Time::Continuous => {
                right -= earlier;
                &adjoint + DMatrix::identity(size, size) * own
            }
            Time::Sampled => {
                right -= &adjoint * earlier;
                &adjoint * own - DMatrix::identity(size, size)
            }
        };
        y.set_column(column, &matrix.solve_lower_triangular(&right)?);
    }
    let whole = &u * y * u.adjoint();
    Some(symmetric(whole.map(|value| value.re)))
}

fn symmetric(matrix: DMatrix<f64>) -> DMatrix<f64> {
    let transposed = matrix.transpose();
    (matrix + transposed) / 2.0
}
