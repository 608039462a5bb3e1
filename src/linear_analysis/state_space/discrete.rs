//! Sampled models.

use nalgebra::linalg::balancing::unbalance;
use nalgebra::{DMatrix, DVector};

use super::{Hold, LinearError, Matrices, Sampling, StateSpace, to_rows};
use crate::dense::balance;

impl StateSpace {
    /// Returns the model sampled at multiples of a period \[s\].
    ///
    /// [`Hold::Zoh`] is exact for inputs that are constant between samples:
    ///
    /// ```text
    /// [Ad Bd]       [A B]
    /// [0  1 ] = exp [0 0] h,  Cd = C, Dd = D
    /// ```
    ///
    /// [`Hold::Tustin`], with E = 1 - A h/2, is Ad = E^-1 (1 + A h/2), Bd = E^-1 B h, Cd = C E^-1,
    /// Dd = D + C E^-1 B h/2, as in `scipy.signal.cont2discrete(.., "bilinear")`.
    ///
    /// # Errors
    /// [`LinearError::BadPeriod`] unless the period is positive, [`LinearError::Sampled`] for a
    /// sampled model, [`LinearError::Overflow`] if a motion grows beyond all numbers within a
    /// period, [`LinearError::Singular`] if 2/h is an eigenvalue of A.
    pub fn sampled(&self, period: f64, hold: Hold) -> Result<Self, LinearError> {
        if !(period > 0.0 && period.is_finite()) {
            return Err(LinearError::BadPeriod { period });
        }
        if self.sampling.is_some() {
            return Err(LinearError::Sampled);
        }
        let sampled = match hold {
            Hold::Zoh => held(self.matrices(), period),
            Hold::Tustin => bilinear(&self.matrices(), period)?,
        };
        let Matrices { a, b, c, d } = sampled;
        if a.iter().chain(&b).chain(&c).chain(&d).any(|value| !value.is_finite()) {
            return Err(LinearError::Overflow { period });
        }
        let [a, b, c, d] = [a, b, c, d].each_ref().map(to_rows);
        let sampling = Some(Sampling { period, hold });
        Ok(Self { a, b, c, d, sampling, ..self.clone() })
    }
}

fn held(Matrices { a, b, c, d }: Matrices, period: f64) -> Matrices {
    let (n, m) = b.shape();
    let mut exponent = DMatrix::zeros(n + m, n + m);
    exponent.view_mut((0, 0), (n, n)).copy_from(&(a * period));
    exponent.view_mut((0, n), (n, m)).copy_from(&(b * period));
    let whole = exponential(exponent);
    let (a, b) = (whole.view((0, 0), (n, n)).into_owned(), whole.view((0, n), (n, m)).into_owned());
    Matrices { a, b, c, d }
}

/// Returns the exponential of a matrix, balanced first so that its norm is that of its motions.
pub(super) fn exponential(mut exponent: DMatrix<f64>) -> DMatrix<f64> {
    if exponent.is_empty() {
        return exponent;
    }
    let scales: DVector<f64> = balance(&mut exponent);
    let mut exponential = exponent.exp();
    unbalance(&mut exponential, &scales);
    exponential
}

fn bilinear(of: &Matrices, period: f64) -> Result<Matrices, LinearError> {
    let n = of.a.nrows();
    if n == 0 {
        return Ok(of.clone());
    }
    let half = &of.a * (period / 2.0);
    let factors = (DMatrix::identity(n, n) - &half).lu();
    let what = "1 - A h/2, for an eigenvalue of A at 2/h,";
    let solve = |right: &DMatrix<f64>| factors.solve(right).ok_or(LinearError::Singular { what });
    let a = solve(&(DMatrix::identity(n, n) + &half))?;
    let b = solve(&(&of.b * period))?;
    let c = &of.c * solve(&DMatrix::identity(n, n))?;
    let d = &of.d + &of.c * &b / 2.0;
    Ok(Matrices { a, b, c, d })
}
