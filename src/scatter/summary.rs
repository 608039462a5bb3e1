//! Estimates from samples, with confidence intervals.

use statrs::distribution::{Binomial, ContinuousCDF, DiscreteCDF, StudentsT};

use super::ScatterError;
use super::jackknife::Jackknife;
use super::normal::normal_quantile;
use super::points::Groups;

/// Estimate with its confidence interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Estimate.
    pub value: f64,
    /// Lower end of the interval; minus infinity if the samples do not bound it.
    pub low: f64,
    /// Upper end of the interval; infinity if the samples do not bound it.
    pub high: f64,
}

/// Statistics of the values of one quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// Number of values.
    pub count: usize,
    /// Mean.
    ///
    /// The interval is mean +- t s/sqrt(n), of independent values or of the means of replicates.
    pub mean: Estimate,
    /// Standard deviation.
    ///
    /// The interval is that of a jackknife of its logarithm over values or replicates, corrected for
    /// skewness (Hall: On the removal of skewness by transformation, J. R. Stat. Soc. B 54, 1992) and
    /// kurtosis (O'Neill: Some useful moment results in sampling problems, Am. Stat. 68, 2014).
    pub deviation: Estimate,
    /// Least value.
    pub least: f64,
    /// Greatest value.
    pub greatest: f64,
    sorted: Vec<f64>,
    replicates: Vec<Vec<f64>>,
    confidence: f64,
}

impl Summary {
    /// Computes statistics of values, of which those that are not finite count as missing.
    ///
    /// # Errors
    /// [`ScatterError::Samples`] for fewer than 2 values, or a confidence that is not between 0 and
    /// 1.
    pub fn of(values: &[f64], groups: &Groups, confidence: f64) -> Result<Self, ScatterError> {
        if !(confidence > 0.0 && confidence < 1.0) {
            let message = format!("a confidence must be between 0 and 1, not {confidence}");
            return Err(ScatterError::Samples(message));
        }
        let mut sorted: Vec<f64> = values.iter().copied().filter(|y| y.is_finite()).collect();
        sorted.sort_unstable_by(f64::total_cmp);
        let count = sorted.len();
        if count < 2 {
            let message = format!("{count} values: statistics need at least 2");
            return Err(ScatterError::Samples(message));
        }
        let mut replicates = grouped(values, *groups);
        let mean = mean(&sorted);
        let parts: Vec<Moments> = if replicates.is_empty() {
            sorted.iter().map(|value| Moments::of(&[*value], mean)).collect()
        } else {
            replicates.iter().map(|values| Moments::of(values, mean)).collect()
        };
        let mut whole = Moments::default();
        for part in &parts {
            whole.add(part, 1.0);
        }
        let jackknife = |value: fn(&Moments) -> f64| {
            Jackknife::of(value(&whole), parts.iter().map(|part| value(&whole.without(part))))
        };
        let [low, high] = jackknife(Moments::mean).interval(confidence).map(|offset| mean + offset);
        let deviation = whole.variance().sqrt();
        let of_deviation = if deviation > 0.0 {
            let logarithm = jackknife(|sums| 0.5 * sums.variance().ln());
            logarithm.corrected_interval(confidence).map(f64::exp)
        } else {
            [deviation; 2]
        };
        for values in &mut replicates {
            values.sort_unstable_by(f64::total_cmp);
        }
        Ok(Self {
            count,
            mean: Estimate { value: mean, low, high },
            deviation: Estimate { value: deviation, low: of_deviation[0], high: of_deviation[1] },
            least: sorted[0],
            greatest: sorted[count - 1],
            sorted,
            replicates,
            confidence,
        })
    }

    /// Returns the values in ascending order.
    #[must_use]
    pub fn sorted(&self) -> &[f64] {
        &self.sorted
    }

    /// Returns the quantile at probability p, interpolated linearly between order statistics.
    ///
    /// The interval of independent values is that between the order statistics whose ranks are
    /// quantiles of the binomial distribution. Of replicates, it is where the mean of their
    /// distribution functions differs from p by less than its t interval (Woodruff: Confidence
    /// intervals for medians and other position measures, J. Am. Stat. Assoc. 47, 1952).
    #[must_use]
    pub fn quantile(&self, p: f64) -> Estimate {
        let p = p.clamp(0.0, 1.0);
        let last = self.count - 1;
        let at = |p: f64| {
            let place = p * last as f64;
            let below = place.floor() as usize;
            let share = place - below as f64;
            self.sorted[below] * (1.0 - share) + self.sorted[(below + 1).min(last)] * share
        };
        let value = at(p);
        let (low, high) = if self.replicates.is_empty() {
            self.between_ranks(p)
        } else {
            let shares = self
                .replicates
                .iter()
                .map(|values| values.partition_point(|y| *y <= value) as f64 / values.len() as f64);
            let half = half_width(&shares.collect::<Vec<_>>(), self.confidence);
            (
                if p >= half { at(p - half) } else { f64::NEG_INFINITY },
                if p + half <= 1.0 { at(p + half) } else { f64::INFINITY },
            )
        };
        Estimate { value, low, high }
    }

    /// Returns the order statistics whose ranks are quantiles of the binomial distribution.
    fn between_ranks(&self, p: f64) -> (f64, f64) {
        let tail = 0.5 * (1.0 - self.confidence);
        let Ok(ranks) = Binomial::new(p, self.count as u64) else {
            return (f64::NEG_INFINITY, f64::INFINITY);
        };
        // Ranks from 1; 0 and count + 1 are beyond the values.
        let (low, high) =
            (ranks.inverse_cdf(tail) as usize, ranks.inverse_cdf(1.0 - tail) as usize);
        let low = low.checked_sub(1).map_or(f64::NEG_INFINITY, |index| self.sorted[index]);
        (low, self.sorted.get(high).copied().unwrap_or(f64::INFINITY))
    }
}

/// Sums over independent parts of the samples, about an origin near the mean.
#[derive(Debug, Clone, Copy, Default)]
struct Moments {
    parts: f64,
    count: f64,
    sum: f64,
    squares: f64,
    /// Sums over parts of n_r^2, n_r s_r and s_r^2, with the number n_r and the sum s_r of the
    /// values of a part.
    count_squared: f64,
    count_sum: f64,
    sum_squared: f64,
}

impl Moments {
    fn of(values: &[f64], origin: f64) -> Self {
        let count = values.len() as f64;
        let sum: f64 = values.iter().map(|value| value - origin).sum();
        Self {
            parts: 1.0,
            count,
            sum,
            squares: values.iter().map(|value| (value - origin).powi(2)).sum(),
            count_squared: count * count,
            count_sum: count * sum,
            sum_squared: sum * sum,
        }
    }

    fn add(&mut self, other: &Self, factor: f64) {
        self.parts += factor * other.parts;
        self.count += factor * other.count;
        self.sum += factor * other.sum;
        self.squares += factor * other.squares;
        self.count_squared += factor * other.count_squared;
        self.count_sum += factor * other.count_sum;
        self.sum_squared += factor * other.sum_squared;
    }

    fn without(&self, part: &Self) -> Self {
        let mut rest = *self;
        rest.add(part, -1.0);
        rest
    }

    fn mean(&self) -> f64 {
        self.sum / self.count
    }

    /// Returns the variance, without bias for parts of equal size: mean((y - m)^2) + V(m), where
    /// V(m) is the variance of the mean m over the parts. Independent values are parts of one value,
    /// and this is s^2.
    fn variance(&self) -> f64 {
        let mean = self.mean();
        let between =
            self.sum_squared - 2.0 * mean * self.count_sum + mean * mean * self.count_squared;
        let of_mean = between * self.parts / ((self.parts - 1.0) * self.count * self.count);
        self.squares / self.count - mean * mean + of_mean
    }
}

/// Number of samples that fulfil a condition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tally {
    /// Number of samples.
    pub count: usize,
    /// Number of those that fulfil it.
    pub hits: usize,
    /// Probability, with Wilson's score interval.
    ///
    /// Of replicates, the interval uses the effective number of samples p(1 - p)/v with the
    /// variance v of the mean over replicates, times (z/t)^2 for the few degrees of freedom of v
    /// (Korn, Graubard: Confidence intervals for proportions with small expected number of positive
    /// counts estimated from survey data, Surv. Methodol. 24, 1998). If all replicates agree, it is
    /// that of independent samples.
    pub probability: Estimate,
}

impl Tally {
    /// Counts samples; `None` stands for a missing one.
    ///
    /// # Errors
    /// [`ScatterError::Samples`] if there are none, or for a confidence that is not between 0 and 1.
    pub fn of(
        hits: &[Option<bool>],
        groups: &Groups,
        confidence: f64,
    ) -> Result<Self, ScatterError> {
        let numbers: Vec<f64> =
            hits.iter().map(|hit| hit.map_or(f64::NAN, |hit| f64::from(u8::from(hit)))).collect();
        let known: Vec<f64> = numbers.iter().copied().filter(|hit| hit.is_finite()).collect();
        if known.is_empty() || !(confidence > 0.0 && confidence < 1.0) {
            let message = "a probability needs samples, and a confidence between 0 and 1";
            return Err(ScatterError::Samples(message.to_owned()));
        }
        let (count, p) = (known.len(), mean(&known));
        let z = normal_quantile(0.5 * (1.0 + confidence));
        let means: Vec<f64> = grouped(&numbers, *groups).iter().map(|hits| mean(hits)).collect();
        let variance = variance_of_mean(&means);
        let effective = if variance > 0.0 {
            let t = student(0.5 * (1.0 + confidence), means.len() as f64 - 1.0);
            p * (1.0 - p) / variance * (z / t).powi(2)
        } else {
            count as f64
        };
        let hits = known.iter().filter(|hit| **hit > 0.5).count();
        Ok(Self { count, hits, probability: wilson(p, effective, z) })
    }
}

/// Returns Wilson's score interval of a proportion p of n samples.
///
/// Source: E. B. Wilson: Probable inference, the law of succession, and statistical inference.
/// J. Am. Stat. Assoc. 22 (1927).
fn wilson(p: f64, n: f64, z: f64) -> Estimate {
    let square = z * z / n;
    let centre = p + square / 2.0;
    let half = z * (p * (1.0 - p) / n + square / (4.0 * n)).sqrt();
    let (low, high) = ((centre - half) / (1.0 + square), (centre + half) / (1.0 + square));
    // Rounding must not leave 0 and 1.
    let low = if p <= 0.0 { 0.0 } else { low.max(0.0) };
    let high = if p >= 1.0 { 1.0 } else { high.min(1.0) };
    Estimate { value: p, low, high }
}

/// Splits values by replicate, without those that are not finite. Returns nothing unless at least
/// two replicates have values.
fn grouped(values: &[f64], groups: Groups) -> Vec<Vec<f64>> {
    let Groups::Replicates(count) = groups else { return Vec::new() };
    let mut all = vec![Vec::with_capacity(values.len() / count.max(1) + 1); count];
    for (index, value) in values.iter().enumerate().filter(|(_, value)| value.is_finite()) {
        all[index % count].push(*value);
    }
    all.retain(|values| !values.is_empty());
    if all.len() < 2 { Vec::new() } else { all }
}

pub(super) fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Returns s^2/n; 0 for fewer than two values.
fn variance_of_mean(values: &[f64]) -> f64 {
    if values.len() < 2 {
        return 0.0;
    }
    let mean = mean(values);
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    squares / ((values.len() - 1) as f64 * values.len() as f64)
}

/// Returns half the width of the t interval of a mean.
pub(super) fn half_width(values: &[f64], confidence: f64) -> f64 {
    let t = student(0.5 * (1.0 + confidence), values.len() as f64 - 1.0);
    t * variance_of_mean(values).sqrt()
}

/// Returns the quantile of Student's t distribution; normal for many degrees of freedom.
pub(super) fn student(p: f64, freedom: f64) -> f64 {
    /// Degrees of freedom at which t differs from z by less than 1e-6 of it: (z^2 + 1)/(4 n).
    const MANY: f64 = 2e6;
    if freedom >= MANY {
        return normal_quantile(p);
    }
    StudentsT::new(0.0, 1.0, freedom).map_or(f64::INFINITY, |t| t.inverse_cdf(p))
}
