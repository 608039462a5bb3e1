//! Undamped frequencies, slow ones as accurate as fast ones.

use nalgebra::DMatrix;

use super::{LinearError, SecondOrder};

/// Ratio to the largest squared frequency below which others have lost too many digits and are
/// computed again among themselves.
const SLOW: f64 = 1e-2;
/// Maximum of K x for a free motion, in roundings of its terms.
const ROUNDINGS: f64 = 16.0;

impl SecondOrder {
    /// Returns natural frequencies without damping, ascending \[rad/s\]: w of (K - w^2 M) x = 0,
    /// with the symmetric part of K. A free motion has 0, and an unstable direction, w^2 < 0, has
    /// NaN.
    ///
    /// Eigenvalues of a symmetric matrix have the rounding error of the largest. Those of slow
    /// motions are therefore computed again from K and M restricted to these motions, by sums
    /// without cancellation error, and so on: each frequency is accurate to rounding.
    ///
    /// # Errors
    /// [`LinearError::Singular`] if M is not positive definite.
    pub fn undamped_frequencies(&self) -> Result<Vec<f64>, LinearError> {
        let stiffness = (&self.stiffness + self.stiffness.transpose()) / 2.0;
        let stiffness = Stiffness::new(&stiffness);
        let mut found = Vec::with_capacity(self.mass.nrows());
        let mut motions = DMatrix::identity(self.mass.nrows(), self.mass.nrows());
        while motions.ncols() > 0 {
            motions = self.fast_ones(&stiffness, &motions, &mut found)?;
        }
        found.sort_by(f64::total_cmp);
        Ok(found)
    }

    /// Adds frequencies of the faster motions among the columns of `motions`, and returns the
    /// slower motions, which are fewer.
    fn fast_ones(
        &self,
        stiffness: &Stiffness,
        motions: &DMatrix<f64>,
        found: &mut Vec<f64>,
    ) -> Result<DMatrix<f64>, LinearError> {
        let singular = LinearError::Singular { what: "the mass matrix" };
        let mass = motions.transpose() * &self.mass * motions;
        let lower = mass.cholesky().ok_or_else(|| singular.clone())?.l();
        let inverse = lower.try_inverse().ok_or(singular)?;
        let forces = stiffness.times(motions);
        let between = motions.transpose() * forces;
        let between = (&between + between.transpose()) / 2.0;
        let eigen = (&inverse * between * inverse.transpose()).symmetric_eigen();
        let largest = eigen.eigenvalues.amax();
        let shapes = motions * inverse.transpose() * eigen.eigenvectors;
        let mut slow = Vec::new();
        for (index, square) in eigen.eigenvalues.iter().enumerate() {
            let shape = shapes.column(index).into_owned();
            if stiffness.is_rounding(shape.as_slice()) {
                found.push(0.0);
            } else if square.abs() >= SLOW * largest {
                found.push(square.sqrt());
            } else {
                slow.push(index);
            }
        }
        Ok(shapes.select_columns(&slow))
    }
}

/// K by rows, without zeros.
struct Stiffness(Vec<Vec<(usize, f64)>>);

impl Stiffness {
    fn new(matrix: &DMatrix<f64>) -> Self {
        let row = |row: usize| {
            let entries = (0..matrix.ncols()).map(move |column| (column, matrix[(row, column)]));
            entries.filter(|(_, entry)| *entry != 0.0).collect()
        };
        Self((0..matrix.nrows()).map(row).collect())
    }

    fn times(&self, columns: &DMatrix<f64>) -> DMatrix<f64> {
        DMatrix::from_fn(self.0.len(), columns.ncols(), |row, column| {
            dot(self.0[row].iter().map(|(at, entry)| (*entry, columns[(*at, column)])))
        })
    }

    /// Returns whether a motion is free: each of its forces is a rounding error of its terms.
    fn is_rounding(&self, shape: &[f64]) -> bool {
        self.0.iter().all(|row| {
            let parts = row.iter().map(|(at, entry)| (*entry, shape[*at]));
            let size: f64 = parts.clone().map(|(a, b)| (a * b).abs()).sum();
            dot(parts).abs() <= ROUNDINGS * f64::EPSILON * size
        })
    }
}

/// Returns a sum of products with twice the digits, then rounded (Ogita, Rump and Oishi, Accurate
/// sum and dot product, SIAM J. Sci. Comput. 26, 2005, algorithm 5.3).
fn dot(parts: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut sum, mut rest) = (0.0, 0.0);
    for (a, b) in parts {
        let product: f64 = a * b;
        let of_product = a.mul_add(b, -product);
        let next: f64 = sum + product;
        let part = next - sum;
        let of_sum = (sum - (next - part)) + (product - part);
        sum = next;
        rest += of_product + of_sum;
    }
    sum + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_keeps_what_cancels() {
        let parts = [(1e16, 1.0), (1.0, 3.0), (-1e16, 1.0), (1e-3, 1e-3)];
        assert_eq!(dot(parts.into_iter()).to_bits(), (3.0_f64 + 1e-6).to_bits());
    }

    /// Two masses, a stiff spring between them and a soft one to the ground: w^2 of
    /// det [[k + s - w^2, -k], [-k, k - w^2]] = w^4 - (2 k + s) w^2 + k s.
    #[test]
    fn a_slow_motion_beside_a_fast_one_has_all_its_digits() {
        // Beyond this, forces of the soft spring are below 16 roundings of the stiff one's.
        for exponent in 0..48 {
            let (k, s) = (f64::from(2_u32).powi(exponent), 3.0);
            let half = k + s / 2.0;
            let fast = half + (half * half - k * s).sqrt();
            let exact = [(k * s / fast).sqrt(), fast.sqrt()];
            let found = SecondOrder {
                mass: DMatrix::identity(2, 2),
                damping: DMatrix::zeros(2, 2),
                stiffness: DMatrix::from_row_slice(2, 2, &[k + s, -k, -k, k]),
            };
            let found = found.undamped_frequencies().expect("M is 1");
            for (found, exact) in found.iter().zip(exact) {
                let off = (found / exact - 1.0).abs();
                assert!(off < 1e-14, "2^{exponent}: {found} for {exact}");
            }
        }
    }
}
