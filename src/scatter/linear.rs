//! Linear propagation of uncertainty.

use super::correlation::Correlation;

/// Variance of a result to first order in the parameters.
///
/// ```text
/// sigma^2 = S C S^T = sum_ij (s_i sigma_i) rho_ij (s_j sigma_j)
/// ```
///
/// with the slopes s_i, the standard deviations sigma_i and the correlations rho_ij of the
/// parameters. Exact for a linear function. Source: JCGM 100:2008, section 5.
#[derive(Debug, Clone, PartialEq)]
pub struct Propagation {
    /// Standard deviation of the result.
    pub deviation: f64,
    /// Shares of the parameters.
    pub shares: Vec<Share>,
}

/// Contribution of one parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Share {
    /// s_i sigma_i, the change of the result for one standard deviation of the parameter.
    pub contribution: f64,
    /// s_i sigma_i sum_j rho_ij s_j sigma_j/sigma^2; shares add up to 1, and can be negative if
    /// parameters are correlated.
    pub share: f64,
}

/// Propagates standard deviations of parameters through slopes, to first order.
#[must_use]
pub fn propagate(slopes: &[f64], deviations: &[f64], correlation: &Correlation) -> Propagation {
    let contributions: Vec<f64> = slopes
        .iter()
        .zip(deviations)
        .map(|(slope, deviation)| if *deviation == 0.0 { 0.0 } else { slope * deviation })
        .collect();
    let matrix = correlation.matrix();
    let together = |row: usize| -> f64 {
        let products = contributions.iter().enumerate();
        let sum: f64 = products.map(|(column, other)| matrix[(row, column)] * other).sum();
        contributions[row] * sum
    };
    let parts: Vec<f64> = (0..contributions.len()).map(together).collect();
    let variance = parts.iter().sum::<f64>().max(0.0);
    let share = |(contribution, part): (&f64, &f64)| Share {
        contribution: *contribution,
        share: if variance > 0.0 { part / variance } else { 0.0 },
    };
    let shares = contributions.iter().zip(&parts).map(share).collect();
    Propagation { deviation: variance.sqrt(), shares }
}
