//! Poles: eigenvalues of A.

use nalgebra::DMatrix;
use num_complex::Complex64;

use super::super::modes::eigenvalues;
use super::{LinearError, StateSpace};
use crate::dense::balance;
use crate::sorting::sort_ascending;

/// Singular value, relative to the norm of a balanced matrix, that counts as zero for each row.
pub(super) const NEGLIGIBLE: f64 = 1e-15;

impl StateSpace {
    /// Returns the poles, by |pole|, then real part: s \[1/s\] of a continuous model, z of a sampled
    /// one.
    ///
    /// Poles at 0, or at z = 1, are separated first. A double one, the free rotation of a shaft,
    /// would otherwise be found only to the square root of the accuracy of the numbers.
    ///
    /// # Errors
    /// [`LinearError::Eigenvalues`] if the iteration does not converge.
    pub fn poles(&self) -> Result<Vec<Complex64>, LinearError> {
        let one = self.steady_pole();
        let (matrices, _) = self.balanced();
        let mut poles = eigenvalues_about(matrices.a, one)?;
        sort_poles(&mut poles);
        Ok(poles)
    }

    /// Returns the pole of a constant motion: 0, or 1 if sampled.
    pub(super) fn steady_pole(&self) -> f64 {
        if self.sampling.is_some() { 1.0 } else { 0.0 }
    }
}

/// Sorts by absolute value, then by real part; conjugates with the positive imaginary part first.
pub(in super::super) fn sort_poles(poles: &mut [Complex64]) {
    sort_ascending(poles, |pole| -pole.im);
    sort_ascending(poles, |pole| pole.re);
    sort_ascending(poles, |pole| pole.norm());
}

/// Returns the eigenvalues of a matrix. Those at `one` are exact, with all their multiplicity:
/// while A - one has a null space, its directions are separated and the rest is looked at again.
pub(in super::super) fn eigenvalues_about(
    matrix: DMatrix<f64>,
    one: f64,
) -> Result<Vec<Complex64>, LinearError> {
    let size = matrix.nrows();
    let mut rest = matrix - DMatrix::identity(size, size) * one;
    let mut found = Vec::with_capacity(size);
    while !rest.is_empty() {
        balance(&mut rest);
        let complement = complement_of_null_space(&rest)?;
        let zeros = rest.nrows() - complement.ncols();
        if zeros == 0 {
            break;
        }
        found.extend(std::iter::repeat_n(Complex64::from(one), zeros));
        rest = complement.transpose() * rest * &complement;
    }
    found.extend(eigenvalues(rest)?.into_iter().map(|value| value + one));
    Ok(found)
}

/// Returns an orthonormal basis of the complement of the null space of a square matrix.
fn complement_of_null_space(matrix: &DMatrix<f64>) -> Result<DMatrix<f64>, LinearError> {
    let size = matrix.nrows();
    let svd = matrix.clone().try_svd(false, true, f64::EPSILON, 100 * size);
    let svd = svd.ok_or(LinearError::Eigenvalues)?;
    let rows = svd.v_t.as_ref().ok_or(LinearError::Eigenvalues)?;
    let least = NEGLIGIBLE * size as f64 * svd.singular_values.max();
    let kept = svd.singular_values.iter().enumerate().filter(|(_, value)| **value > least);
    let kept: Vec<usize> = kept.map(|(index, _)| index).collect();
    Ok(rows.select_rows(&kept).transpose())
}
