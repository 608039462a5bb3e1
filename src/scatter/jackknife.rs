//! Confidence intervals from estimates that leave out one part of the samples at a time.

use super::summary::{mean, student};

/// Jackknife of an estimate x over n independent parts of the samples.
///
/// The pseudo-values p_i = n x - (n - 1) x_i, with the estimate x_i without part i, take the place of
/// independent values whose mean is x.
/// Source: J. W. Tukey: Bias and confidence in not-quite large samples. Ann. Math. Stat. 29 (1958).
pub(super) struct Jackknife {
    whole: f64,
    count: f64,
    /// s/sqrt(n) with the standard deviation s of the pseudo-values. Not finite if one of the
    /// estimates is not.
    error: f64,
    /// Skewness g of the pseudo-values.
    skewness: f64,
    /// Fourth central moment of the pseudo-values over the square of the second.
    kurtosis: f64,
}

impl Jackknife {
    /// `without` are the estimates without one of the parts.
    pub(super) fn of(whole: f64, without: impl Iterator<Item = f64>) -> Self {
        let without: Vec<f64> = without.collect();
        let centre = mean(&without);
        let count = without.len() as f64;
        let moment = |power: i32| {
            without.iter().map(|estimate| (centre - estimate).powi(power)).sum::<f64>() / count
        };
        let second = moment(2);
        // Two parts have no skewness, and equal ones neither.
        let skewness = if count > 2.0 && second > 0.0 {
            moment(3) / second.powf(1.5) * (count * (count - 1.0)).sqrt() / (count - 2.0)
        } else {
            0.0
        };
        let error = (second * (count - 1.0)).sqrt();
        Self { whole, count, error, skewness, kurtosis: moment(4) / (second * second) }
    }

    /// Returns the t interval, x -+ t s/sqrt(n).
    pub(super) fn interval(&self, confidence: f64) -> [f64; 2] {
        self.ends(student(0.5 * (1.0 + confidence), self.count - 1.0), |t| t)
    }

    /// Returns the t interval corrected for skewness and kurtosis, x - s/sqrt(n) T(t) ..
    /// x - s/sqrt(n) T(-t), with the inverse T(w) of the cubic that removes the skewness of the
    /// studentised estimate (Hall):
    ///
    /// ```text
    /// w = T + g T^2/(3 sqrt(n)) + g^2 T^3/(27 n) + g/(6 sqrt(n))
    /// ```
    ///
    /// The degrees of freedom of t are those of a chi-squared distribution with the variance of s^2
    /// for the kurtosis k (O'Neill), 2 n/(k - (n - 3)/(n - 1)), at most the n - 1 of normal values.
    /// Sources: P. Hall: On the removal of skewness by transformation, J. R. Stat. Soc. B 54 (1992);
    /// B. O'Neill: Some useful moment results in sampling problems, Am. Stat. 68 (2014).
    pub(super) fn corrected_interval(&self, confidence: f64) -> [f64; 2] {
        let (n, root) = (self.count, self.count.sqrt());
        let freedom = 2.0 * n / (self.kurtosis - (n - 3.0) / (n - 1.0));
        self.ends(student(0.5 * (1.0 + confidence), freedom.min(n - 1.0)), |t| {
            let shifted = t - self.skewness / (6.0 * root);
            let c = (1.0 + self.skewness * shifted / root).cbrt();
            // (c - 1) 3 sqrt(n)/g without its cancellation
            3.0 * shifted / (c * c + c + 1.0)
        })
    }

    /// Unbounded if there is only one part, or an estimate without a part is not finite.
    fn ends(&self, t: f64, quantile: impl Fn(f64) -> f64) -> [f64; 2] {
        if self.count < 2.0 || !self.error.is_finite() {
            return [f64::NEG_INFINITY, f64::INFINITY];
        }
        if self.error <= 0.0 {
            return [self.whole; 2];
        }
        [t, -t].map(|t| self.whole - self.error * quantile(t))
    }
}
