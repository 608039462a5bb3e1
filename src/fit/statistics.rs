//! Statistics of unknowns and residuals.

use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

use super::least_squares::{Evaluation, Loss, weighed};
use crate::sorting::sort_descending;

/// Uncertainty of the unknowns, to first order about the end of the search.
///
/// ```text
/// s^2 = sum r^2 / (m - n)      C = s^2 (J^T J)^-1
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Statistics {
    /// Number of residuals, m.
    pub count: usize,
    /// Degrees of freedom, m - n; n is the number of unknowns that are not at a bound.
    pub freedom: usize,
    /// s, the standard deviation of residuals; NaN without degrees of freedom.
    pub deviation: f64,
    /// Standard error of each unknown: infinite if the data do not determine it, 0 at a bound.
    pub errors: Vec<f64>,
    /// Correlation of every two unknowns; NaN where one of them is not determined.
    pub correlations: DMatrix<f64>,
    /// Directions of unknowns that the data hardly determine, the worst first.
    pub untold: Vec<Direction>,
}

/// A combination of unknowns.
#[derive(Debug, Clone, PartialEq)]
pub struct Direction {
    /// Shares of the unknowns, of length 1.
    pub shares: Vec<f64>,
    /// Standard error along this direction, in units of the unknowns' sizes; infinite if the data
    /// do not determine it.
    pub error: f64,
}

/// Ratio to the largest singular value below which others are rounding.
const ROUNDING: f64 = 1e-9;

/// Computes the statistics of a fit. `sizes` are the units of changes of the unknowns. Directions
/// with errors above `far` of them count as not determined. `held` marks the unknowns at a bound.
#[must_use]
pub fn statistics(
    evaluation: &Evaluation,
    loss: Loss,
    (sizes, far): (&[f64], f64),
    held: &[bool],
) -> Statistics {
    let (jacobian, residuals) = weighed(evaluation, loss);
    let (m, all) = (jacobian.nrows(), jacobian.ncols());
    let free: Vec<usize> = (0..all).filter(|k| !held[*k]).collect();
    let freedom = m.saturating_sub(free.len());
    let variance = if freedom > 0 { residuals.norm_squared() / freedom as f64 } else { f64::NAN };
    let deviation = variance.sqrt();
    let relative =
        DMatrix::from_fn(m, free.len(), |row, k| jacobian[(row, free[k])] * sizes[free[k]]);
    // An empty matrix has no decomposition.
    let svd = (!free.is_empty()).then(|| relative.svd(false, true));
    let (values, turns) = svd
        .and_then(|svd| Some((svd.singular_values, svd.v_t?)))
        .unwrap_or_else(|| (DVector::zeros(0), DMatrix::zeros(0, free.len())));
    let largest = values.iter().copied().fold(0.0, f64::max);
    let mut untold = Vec::new();
    let mut covariance = DMatrix::<f64>::zeros(all, all);
    let mut errors = vec![0.0; all];
    for (value, turn) in values.iter().zip(turns.row_iter()) {
        let is_told = *value > ROUNDING * largest;
        let error = if is_told { deviation / value } else { f64::INFINITY };
        if !is_told || error > far {
            let mut shares = vec![0.0; all];
            for (k, share) in free.iter().zip(turn.iter()) {
                shares[*k] = *share;
            }
            untold.push(Direction { shares, error });
        }
        for (i, a) in free.iter().zip(turn.iter()) {
            if !is_told && a.abs() > 1e-6 {
                errors[*i] = f64::INFINITY;
            }
            for (j, b) in free.iter().zip(turn.iter()) {
                if is_told {
                    covariance[(*i, *j)] += a * b / (value * value) * sizes[*i] * sizes[*j];
                }
            }
        }
    }
    sort_descending(&mut untold, |direction| direction.error);
    for (k, error) in errors.iter_mut().enumerate() {
        *error += deviation * covariance[(k, k)].sqrt();
    }
    let correlations = DMatrix::from_fn(all, all, |i, j| {
        let is_told = errors[i].is_finite() && errors[j].is_finite() && !held[i] && !held[j];
        let product = (covariance[(i, i)] * covariance[(j, j)]).sqrt();
        if is_told { covariance[(i, j)] / product } else { f64::NAN }
    });
    Statistics { count: m, freedom, deviation, errors, correlations, untold }
}

/// Returns Student's t whose absolute value is exceeded with a probability of 5 %.
#[must_use]
pub fn students_t(freedom: usize) -> f64 {
    StudentsT::new(0.0, 1.0, freedom as f64).map_or(f64::NAN, |t| t.inverse_cdf(0.975))
}

/// Test of residuals for randomness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chance {
    /// Correlation of each residual with the next.
    pub autocorrelation: f64,
    /// Number of runs of one sign.
    pub runs: usize,
    /// Number of runs expected by chance.
    pub expected: f64,
    /// Probability of a number of runs that deviates as much by chance (A. Wald, J. Wolfowitz,
    /// 1940).
    pub probability: f64,
}

/// Makes the runs test of residuals in the order of time; `None` for fewer than 10, or for one
/// sign.
#[must_use]
pub fn chance(residuals: &[f64]) -> Option<Chance> {
    const FEWEST: usize = 10;
    let n = residuals.len() as f64;
    let above = residuals.iter().filter(|r| **r >= 0.0).count() as f64;
    let below = n - above;
    if residuals.len() < FEWEST || above == 0.0 || below == 0.0 {
        return None;
    }
    let changes = residuals.windows(2).filter(|pair| (pair[0] >= 0.0) != (pair[1] >= 0.0)).count();
    let runs = changes + 1;
    let expected = 1.0 + 2.0 * above * below / n;
    let variance = (expected - 1.0) * (expected - 2.0) / (n - 1.0);
    let z = (runs as f64 - expected) / variance.sqrt();
    let probability = 2.0 * Normal::standard().cdf(-z.abs());
    let mean = residuals.iter().sum::<f64>() / n;
    let of = |lag: usize| {
        let ahead = &residuals[lag..];
        residuals.iter().zip(ahead).map(|(a, b)| (a - mean) * (b - mean)).sum::<f64>()
    };
    Some(Chance { autocorrelation: of(1) / of(0), runs, expected, probability })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tables of Student's t, as in any textbook.
    #[test]
    fn students_t_is_that_of_the_tables() {
        for (freedom, wanted) in
            [(1, 12.706_205), (2, 4.302_653), (10, 2.228_139), (30, 2.042_272), (1000, 1.962_339)]
        {
            let t = students_t(freedom);
            assert!((t - wanted).abs() < 2e-6, "{freedom}: {t}");
        }
    }

    /// No unknown has an error if all are at a bound.
    #[test]
    fn what_bounds_hold_altogether_has_no_errors() {
        let evaluation = Evaluation {
            residuals: DVector::from_vec(vec![3.0, -4.0]),
            jacobian: DMatrix::from_element(2, 1, 1.0),
        };
        let found = statistics(&evaluation, Loss::Squares, (&[1.0], 1e3), &[true]);
        assert_eq!((found.freedom, found.errors, found.untold), (2, vec![0.0], vec![]));
        assert!((found.deviation - 12.5_f64.sqrt()).abs() < 1e-15);
    }

    /// A line through five points: textbook sums.
    #[test]
    fn errors_of_a_line_are_those_of_the_textbook() {
        let (x, y) = ([1.0, 2.0, 3.0, 4.0, 5.0], [1.1, 1.9, 3.2, 3.9, 5.1]);
        let mean = 3.0;
        let spread: f64 = x.iter().map(|x| (x - mean) * (x - mean)).sum();
        let slope: f64 = x.iter().zip(y).map(|(x, y)| (x - mean) * y).sum::<f64>() / spread;
        let offset = y.iter().sum::<f64>() / 5.0 - slope * mean;
        let evaluation = Evaluation {
            residuals: DVector::from_fn(5, |k, _| offset + slope * x[k] - y[k]),
            jacobian: DMatrix::from_fn(5, 2, |k, j| if j == 0 { 1.0 } else { x[k] }),
        };
        let found = statistics(&evaluation, Loss::Squares, (&[1.0, 1.0], 100.0), &[false, false]);
        let s2 = evaluation.residuals.norm_squared() / 3.0;
        assert!((found.errors[1] - (s2 / spread).sqrt()).abs() < 1e-12);
        assert!((found.errors[0] - (s2 * (0.2 + 9.0 / spread)).sqrt()).abs() < 1e-12);
        assert!((found.correlations[(0, 1)] + 3.0 / 11.0_f64.sqrt()).abs() < 1e-12);
        assert!(found.untold.is_empty());
    }

    #[test]
    fn a_sum_that_alone_counts_leaves_the_difference_untold() {
        let evaluation = Evaluation {
            residuals: DVector::from_vec(vec![0.1, -0.1, 0.05, -0.05]),
            jacobian: DMatrix::from_fn(4, 2, |k, _| k as f64 + 1.0),
        };
        let found = statistics(&evaluation, Loss::Squares, (&[1.0, 1.0], 1.0), &[false, false]);
        let [direction] = &found.untold[..] else { panic!("{found:?}") };
        assert!(direction.error.is_infinite() && found.errors[0].is_infinite());
        assert!((direction.shares[0] + direction.shares[1]).abs() < 1e-12);
    }

    #[test]
    fn residuals_that_alternate_or_drift_are_not_chance() {
        let drift: Vec<f64> = (0..40).map(|k| f64::from(k) - 19.5).collect();
        let found = chance(&drift).unwrap();
        assert!(found.runs == 2 && found.probability < 1e-6 && found.autocorrelation > 0.8);
        let swaps: Vec<f64> = (0..40).map(|k| if k % 2 == 0 { 1.0 } else { -1.0 }).collect();
        assert!(chance(&swaps).unwrap().probability < 1e-6);
        assert!(chance(&drift[..5]).is_none());
    }
}
