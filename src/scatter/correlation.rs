//! Correlated parameters by a Gaussian copula.

use nalgebra::DMatrix;

use super::ScatterError;
use super::normal::normal_quantile;

/// Correlation of the normal scores of parameters.
///
/// Scores z = L z0 of independent standard normal z0, with the Cholesky factor L of the matrix,
/// become parameters by the quantiles of their own distributions. For normal distributions, the
/// matrix is their correlation; for others, it is the correlation of their normal scores.
#[derive(Debug, Clone, PartialEq)]
pub struct Correlation {
    matrix: DMatrix<f64>,
    factor: DMatrix<f64>,
    /// Rows with an entry off the diagonal; the others keep their points to the last bit.
    is_mixed: Vec<bool>,
}

impl Correlation {
    /// Creates the correlation of `count` independent parameters.
    #[must_use]
    pub fn none(count: usize) -> Self {
        let matrix = DMatrix::identity(count, count);
        Self { factor: matrix.clone(), matrix, is_mixed: vec![false; count] }
    }

    /// Checks a symmetric matrix with ones on its diagonal.
    ///
    /// # Errors
    /// [`ScatterError::Correlation`] unless the matrix is square, symmetric, with a unit diagonal
    /// and entries from -1 to 1, and positive definite.
    pub fn new(matrix: DMatrix<f64>) -> Result<Self, ScatterError> {
        let wrong = |message: &str| Err(ScatterError::Correlation(message.to_owned()));
        if !matrix.is_square() {
            return wrong("a correlation matrix must be square");
        }
        if matrix.iter().any(|entry| !(-1.0..=1.0).contains(entry)) {
            return wrong("correlations must be between -1 and 1");
        }
        let count = matrix.nrows();
        if (0..count).any(|k| !(1.0..=1.0).contains(&matrix[(k, k)])) {
            return wrong("the diagonal of a correlation matrix must be 1");
        }
        if matrix.transpose() != matrix {
            return wrong("a correlation matrix must be symmetric");
        }
        let is_mixed = (0..count)
            .map(|row| (0..count).any(|column| column != row && matrix[(row, column)] != 0.0));
        let is_mixed = is_mixed.collect();
        match matrix.clone().cholesky() {
            Some(found) => Ok(Self { factor: found.l(), matrix, is_mixed }),
            None => wrong(
                "the correlation matrix is not positive definite: these correlations contradict \
                 each other",
            ),
        }
    }

    /// Returns the matrix.
    #[must_use]
    pub fn matrix(&self) -> &DMatrix<f64> {
        &self.matrix
    }

    /// Returns whether no two parameters are correlated.
    #[must_use]
    pub fn is_none(&self) -> bool {
        !self.is_mixed.contains(&true)
    }

    /// Converts independent uniform numbers to correlated normal scores; `None` for parameters that
    /// are not correlated with any other.
    #[must_use]
    pub fn scores(&self, uniform: &[f64]) -> Vec<Option<f64>> {
        let normal: Vec<f64> = uniform
            .iter()
            .zip(&self.is_mixed)
            .map(|(u, is_mixed)| if *is_mixed { normal_quantile(*u) } else { 0.0 })
            .collect();
        let score = |row: usize| {
            self.is_mixed[row]
                .then(|| (0..=row).map(|column| self.factor[(row, column)] * normal[column]).sum())
        };
        (0..uniform.len()).map(score).collect()
    }
}
