//! Invariant zeros.
//!
//! Zeros are the s at which \[A - s, B; C, D\] loses rank. The system is reduced, without change of
//! its zeros, until D is square and regular (A. Emami-Naeini and P. Van Dooren, Computation of
//! zeros of linear multivariable systems, Automatica 18, 1982). They are then the eigenvalues of
//! A - B D^-1 C.

use nalgebra::DMatrix;
use num_complex::Complex64;

use super::poles::{eigenvalues_about, sort_poles};
use super::{LinearError, Matrices, StateSpace};

/// Singular value, relative to the norm of \[B; D\] or \[C, D\], that counts as rounding.
const ROUNDING: f64 = 1e-12;

impl StateSpace {
    /// Returns the invariant zeros, by size: s \[1/s\], or z of a sampled model. They include
    /// decoupling zeros: poles that no input moves or no output shows.
    ///
    /// # Errors
    /// [`LinearError::Eigenvalues`] if an iteration does not converge.
    pub fn zeros(&self) -> Result<Vec<Complex64>, LinearError> {
        let (mut matrices, _) = self.balanced();
        // Time is measured so that the rates have the size of the states.
        let norm = matrices.a.norm();
        let pace = if self.sampling.is_none() && norm > 0.0 { norm } else { 1.0 };
        matrices.a.unscale_mut(pace);
        matrices.b.unscale_mut(pace);
        let full_rows = with_full_rows(of_unit_signals(matrices))?;
        let square = with_full_rows(transposed(full_rows))?;
        let Matrices { a, b, c, d } = square;
        if a.is_empty() || d.is_empty() {
            return eigenvalues_of_rest(a, self.steady_pole(), pace);
        }
        let Some(inner) = d.lu().solve(&c) else { return Ok(Vec::new()) };
        eigenvalues_of_rest(a - b * inner, self.steady_pole(), pace)
    }
}

/// Returns the eigenvalues of what the reduction leaves, with time in seconds again.
fn eigenvalues_of_rest(
    rest: DMatrix<f64>,
    one: f64,
    pace: f64,
) -> Result<Vec<Complex64>, LinearError> {
    let zeros = eigenvalues_about(rest, one)?;
    let mut zeros: Vec<Complex64> = zeros.into_iter().map(|zero| zero * pace).collect();
    sort_poles(&mut zeros);
    Ok(zeros)
}

/// Measures inputs and outputs so that columns of \[B; D\], then rows of \[C, D\], have length 1.
fn of_unit_signals(of: Matrices) -> Matrices {
    let Matrices { a, mut b, mut c, mut d } = of;
    for index in 0..b.ncols() {
        let length = b.column(index).norm().hypot(d.column(index).norm());
        if length > 0.0 {
            b.column_mut(index).unscale_mut(length);
            d.column_mut(index).unscale_mut(length);
        }
    }
    for index in 0..c.nrows() {
        let length = c.row(index).norm().hypot(d.row(index).norm());
        if length > 0.0 {
            c.row_mut(index).unscale_mut(length);
            d.row_mut(index).unscale_mut(length);
        }
    }
    Matrices { a, b, c, d }
}

fn transposed(of: Matrices) -> Matrices {
    let [a, b, c, d] = [of.a, of.c, of.b, of.d].map(|matrix| matrix.transpose());
    Matrices { a, b, c, d }
}

/// Reduces a system until D has full row rank: states that the outputs without feedthrough show
/// are zero together with these, and their rates become outputs.
fn with_full_rows(mut of: Matrices) -> Result<Matrices, LinearError> {
    loop {
        let (n, m) = of.b.shape();
        // Rows of the outputs without feedthrough come last.
        let (left, rank) = compressed(&of.d, of.d.norm().max(of.c.norm()))?;
        let (c, d) = (left.transpose() * &of.c, left.transpose() * &of.d);
        let rest = c.nrows() - rank;
        if rest == 0 {
            return Ok(Matrices { c, d, ..of });
        }
        let shown = c.rows(rank, rest).transpose();
        let (states, shows) = compressed(&shown, of.c.norm())?;
        let (with_c, with_d) = (c.rows(0, rank).into_owned(), d.rows(0, rank).into_owned());
        if shows == 0 {
            return Ok(Matrices { c: with_c, d: with_d, ..of });
        }
        // The first `shows` states are zero with these outputs.
        let a = states.transpose() * &of.a * &states;
        let b = states.transpose() * &of.b;
        let c = with_c * &states;
        let kept = n - shows;
        let mut outputs = DMatrix::zeros(shows + rank, kept);
        outputs.rows_mut(0, shows).copy_from(&a.view((0, shows), (shows, kept)));
        outputs.rows_mut(shows, rank).copy_from(&c.columns(shows, kept));
        let mut through = DMatrix::zeros(shows + rank, m);
        through.rows_mut(0, shows).copy_from(&b.rows(0, shows));
        through.rows_mut(shows, rank).copy_from(&with_d);
        of = Matrices {
            a: a.view((shows, shows), (kept, kept)).into_owned(),
            b: b.rows(shows, kept).into_owned(),
            c: outputs,
            d: through,
        };
    }
}

/// Returns an orthogonal U and the rank r of a matrix X: rows of U^T X beyond the first r are zero.
fn compressed(matrix: &DMatrix<f64>, size: f64) -> Result<(DMatrix<f64>, usize), LinearError> {
    let rows = matrix.nrows();
    let mut square = DMatrix::zeros(rows, rows.max(matrix.ncols()));
    square.columns_mut(0, matrix.ncols()).copy_from(matrix);
    if square.is_empty() {
        return Ok((DMatrix::identity(rows, rows), 0));
    }
    let svd = square.try_svd(true, false, f64::EPSILON, 100 * rows);
    let svd = svd.ok_or(LinearError::Eigenvalues)?;
    let values = &svd.singular_values;
    let is_above = |index: &usize| values[*index] > ROUNDING * size;
    let (above, below): (Vec<usize>, Vec<usize>) = (0..rows).partition(is_above);
    let order = [&above[..], &below[..]].concat();
    let u = svd.u.as_ref().ok_or(LinearError::Eigenvalues)?;
    Ok((u.select_columns(&order), above.len()))
}
