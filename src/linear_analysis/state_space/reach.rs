//! Controllability and observability, by orthogonal staircase forms of the balanced matrices.
//!
//! The reachable space is built from B, A B, A^2 B, ... by orthonormal blocks, each orthogonal to
//! the former ones (P. Van Dooren, The generalized eigenstructure problem in linear system theory,
//! IEEE Transactions on Automatic Control 26, 1981). Its complement holds the left eigenvectors w
//! with w^T B = 0: motions that no input moves.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;
use serde::Serialize;

use super::poles::eigenvalues_about;
use super::{LinearError, Matrices, StateSpace};
use crate::linear_analysis::inverse_iteration::InverseIteration;
use crate::linear_analysis::state_space::poles::sort_poles;

/// Part of a new direction, relative to the norm of the matrix, that counts as rounding.
const ROUNDING: f64 = 1e-13;

/// An eigenmode that inputs cannot move, or that outputs do not show.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Hidden {
    /// Real and imaginary part of its pole: s \[1/s\], or z of a sampled model. The imaginary part
    /// is not negative.
    pub pole: [f64; 2],
    /// Shares of the states in the eigenmode, in the order of the states, with the sum 1. For an
    /// eigenmode that inputs cannot move, they are those of the left eigenvector: the combination
    /// of states that stays as it is.
    pub shares: Vec<f64>,
}

impl StateSpace {
    /// Returns the eigenmodes that no input moves. The model is controllable if there are none.
    ///
    /// # Errors
    /// [`LinearError::Eigenvalues`] if an iteration does not converge.
    pub fn uncontrollable(&self) -> Result<Vec<Hidden>, LinearError> {
        let (Matrices { a, b, .. }, _) = self.balanced();
        hidden(&a.transpose(), &outside(&a, &b)?, self.steady_pole())
    }

    /// Returns the eigenmodes that no output shows. The model is observable if there are none.
    ///
    /// # Errors
    /// [`LinearError::Eigenvalues`] if an iteration does not converge.
    pub fn unobservable(&self) -> Result<Vec<Hidden>, LinearError> {
        let (Matrices { a, c, .. }, _) = self.balanced();
        let transposed = a.transpose();
        hidden(&a, &outside(&transposed, &c.transpose())?, self.steady_pole())
    }
}

/// Returns an orthonormal basis of the directions that are orthogonal to B, A B, A^2 B, ...
fn outside(a: &DMatrix<f64>, b: &DMatrix<f64>) -> Result<DMatrix<f64>, LinearError> {
    let (size, norm) = (a.nrows(), a.norm());
    // Inputs are measured so that each has the same effect.
    let mut block = b.clone();
    for mut column in block.column_iter_mut() {
        let length = column.norm();
        if length > 0.0 {
            column /= length;
        }
    }
    let mut reached = DMatrix::zeros(size, 0);
    let mut least = ROUNDING;
    loop {
        // The second time removes the rounding of the first.
        for _ in 0..2 {
            block -= &reached * reached.tr_mul(&block);
        }
        let new = directions(block, least)?;
        let (before, added) = (reached.ncols(), new.ncols());
        if added == 0 {
            break;
        }
        reached = reached.resize_horizontally(before + added, 0.0);
        reached.columns_mut(before, added).copy_from(&new);
        if reached.ncols() >= size {
            return Ok(DMatrix::zeros(size, 0));
        }
        block = a * new;
        least = ROUNDING * norm;
    }
    let rest = DMatrix::identity(size, size) - &reached * reached.transpose();
    directions(rest, 0.5)
}

/// Returns an orthonormal basis of the columns of a matrix, without directions up to a limit.
fn directions(matrix: DMatrix<f64>, least: f64) -> Result<DMatrix<f64>, LinearError> {
    if matrix.is_empty() {
        return Ok(matrix.columns(0, 0).into_owned());
    }
    let iterations = 100 * matrix.nrows().max(matrix.ncols());
    let svd = matrix.try_svd(true, false, f64::EPSILON, iterations);
    let svd = svd.ok_or(LinearError::Eigenvalues)?;
    let u = svd.u.as_ref().ok_or(LinearError::Eigenvalues)?;
    let above = (0..svd.singular_values.len()).filter(|index| svd.singular_values[*index] > least);
    Ok(u.select_columns(&above.collect::<Vec<_>>()))
}

/// Returns the eigenmodes of a matrix within an invariant space.
fn hidden(
    matrix: &DMatrix<f64>,
    space: &DMatrix<f64>,
    one: f64,
) -> Result<Vec<Hidden>, LinearError> {
    if space.ncols() == 0 {
        return Ok(Vec::new());
    }
    let within = space.transpose() * matrix * space;
    let mut poles = eigenvalues_about(within.clone(), one)?;
    sort_poles(&mut poles);
    poles.retain(|pole| pole.im >= 0.0);
    let iteration = InverseIteration::new(&within);
    let mut found: Vec<(Complex64, DVector<Complex64>)> = Vec::new();
    let mut modes = Vec::with_capacity(poles.len());
    for (number, pole) in poles.into_iter().enumerate() {
        let near = |other: &Complex64| (other - pole).norm() <= 1e-7 * within.norm();
        let same: Vec<&DVector<Complex64>> =
            found.iter().filter(|(other, _)| near(other)).map(|(_, vector)| vector).collect();
        let [vector, _] = iteration.vectors(pole, number, &same);
        let whole = space.map(Complex64::from) * &vector;
        let total: f64 = whole.iter().map(Complex64::norm_sqr).sum();
        let shares = whole.iter().map(|entry| entry.norm_sqr() / total).collect();
        modes.push(Hidden { pole: [pole.re, pole.im], shares });
        found.push((pole, vector));
    }
    Ok(modes)
}
