//! Probability distributions of parameters.

use super::ScatterError;
use super::normal::normal_quantile;

/// Law of a distribution. All numbers are in the unit of the parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Law {
    /// Normal distribution.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation, at least 0.
        deviation: f64,
    },
    /// Uniform distribution between two bounds.
    Uniform {
        /// Lower bound.
        low: f64,
        /// Upper bound.
        high: f64,
    },
    /// Triangular distribution between two bounds.
    Triangular {
        /// Lower bound.
        low: f64,
        /// Most probable value.
        mode: f64,
        /// Upper bound.
        high: f64,
    },
    /// Lognormal distribution: the logarithm is normal. Given by the moments of the variable itself,
    /// not of its logarithm.
    Lognormal {
        /// Mean, above 0.
        mean: f64,
        /// Standard deviation, at least 0.
        deviation: f64,
    },
}

/// A valid distribution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distribution(Law);

impl Distribution {
    /// Checks a law.
    ///
    /// # Errors
    /// [`ScatterError::Distribution`] for numbers that are not finite, negative deviations, bounds
    /// or modes out of order, and lognormal means that are not above 0.
    pub fn new(law: Law) -> Result<Self, ScatterError> {
        let wrong = |message: String| Err(ScatterError::Distribution(message));
        let numbers = match law {
            Law::Normal { mean, deviation } | Law::Lognormal { mean, deviation } => {
                [mean, deviation, 0.0]
            }
            Law::Uniform { low, high } => [low, high, 0.0],
            Law::Triangular { low, mode, high } => [low, mode, high],
        };
        if let Some(bad) = numbers.iter().find(|number| !number.is_finite()) {
            return wrong(format!("{bad} is not a finite number"));
        }
        match law {
            Law::Normal { deviation, .. } | Law::Lognormal { deviation, .. } if deviation < 0.0 => {
                wrong(format!("a standard deviation must not be negative: {deviation}"))
            }
            Law::Lognormal { mean, .. } if mean <= 0.0 => {
                wrong(format!("the mean of a lognormal distribution must be above 0, not {mean}"))
            }
            Law::Uniform { low, high } | Law::Triangular { low, high, .. }
                if low > high || !(high - low).is_finite() =>
            {
                wrong(format!("the lower bound {low} must not be above the upper bound {high}"))
            }
            Law::Triangular { low, mode, high } if !(low..=high).contains(&mode) => {
                wrong(format!("the mode {mode} must be between {low} and {high}"))
            }
            law => Ok(Self(law)),
        }
    }

    /// Returns the law.
    #[must_use]
    pub fn law(&self) -> Law {
        self.0
    }

    /// Returns x with P(X <= x) = u, for u between 0 and 1.
    #[must_use]
    pub fn quantile(&self, u: f64) -> f64 {
        match self.0 {
            Law::Normal { .. } | Law::Lognormal { .. } => self.of_score(normal_quantile(u)),
            Law::Uniform { low, high } => low + (high - low) * u,
            Law::Triangular { low, mode, high } => {
                let width = high - low;
                if width == 0.0 {
                    return low;
                }
                if u * width <= mode - low {
                    low + (u * width * (mode - low)).sqrt()
                } else {
                    high - ((1.0 - u) * width * (high - mode)).sqrt()
                }
            }
        }
    }

    /// Returns the value at a standard normal score z, quantile(Phi(z)).
    #[must_use]
    pub fn of_score(&self, z: f64) -> f64 {
        match self.0 {
            Law::Normal { mean, deviation } => mean + deviation * z,
            Law::Lognormal { mean, deviation } => {
                let variance = log_variance(mean, deviation);
                mean * (variance.sqrt() * z - 0.5 * variance).exp()
            }
            Law::Uniform { .. } | Law::Triangular { .. } => self.quantile(super::normal_cdf(z)),
        }
    }

    /// Returns the mean.
    #[must_use]
    pub fn mean(&self) -> f64 {
        match self.0 {
            Law::Normal { mean, .. } | Law::Lognormal { mean, .. } => mean,
            Law::Uniform { low, high } => low + (high - low) / 2.0,
            Law::Triangular { low, mode, high } => low / 3.0 + mode / 3.0 + high / 3.0,
        }
    }

    /// Returns the standard deviation.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        match self.0 {
            Law::Normal { deviation, .. } | Law::Lognormal { deviation, .. } => deviation,
            Law::Uniform { low, high } => (high - low) / 12.0_f64.sqrt(),
            Law::Triangular { low, mode, high } => {
                // Variance (w^2 - a b)/18 with the sides a and b of the mode and w = a + b.
                let (left, right) = (mode - low, high - mode);
                let width = high - low;
                if width == 0.0 {
                    return 0.0;
                }
                let (left, right) = (left / width, right / width);
                width * ((1.0 - left * right) / 18.0).sqrt()
            }
        }
    }

    /// Returns the name of the law in specs.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self.0 {
            Law::Normal { .. } => "normal",
            Law::Uniform { .. } => "uniform",
            Law::Triangular { .. } => "triangular",
            Law::Lognormal { .. } => "lognormal",
        }
    }
}

/// Returns the variance of the logarithm, ln(1 + (s/m)^2).
fn log_variance(mean: f64, deviation: f64) -> f64 {
    (deviation / mean).powi(2).ln_1p()
}
