//! Reductions of a time-dependent quantity, with derivatives.
//!
//! Between samples, a quantity is the polynomial through the six nearest samples that are not
//! beyond an event or jump. An extreme is that of the polynomial. A shift of its time does not
//! change it to first order, so its derivative is that of the quantity at its time (envelope
//! theorem). Derivatives are exact for the computed value.

use crate::sorting::sort_descending;
use nalgebra::{DMatrix, DVector};

/// Number of samples of a polynomial.
const POINTS: usize = 6;
/// Number of parts of an interval in which an extreme is searched for.
const PARTS: usize = 8;
/// Maximum number of extremes returned.
const MOST: usize = 12;

/// A number with its derivatives.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Value {
    pub value: f64,
    pub slopes: Vec<f64>,
}

/// A number at each output time, with derivatives.
#[derive(Debug, Clone)]
pub(super) struct Course<'t> {
    /// Output times, ascending.
    pub times: &'t [f64],
    /// First samples of the segments on which the quantity is smooth.
    pub stretches: &'t [usize],
    pub values: Vec<Value>,
}

/// An extreme and its time, both with derivatives.
#[derive(Debug, Clone)]
pub(super) struct Extreme {
    pub value: Value,
    pub time: Value,
}

impl Course<'_> {
    /// Returns the greatest value, then other local maxima in descending order.
    pub fn greatest(&self) -> Vec<Extreme> {
        let mut found = Vec::new();
        let ends = self.stretches.iter().skip(1).copied().chain([self.times.len()]);
        for (first, end) in self.stretches.iter().copied().zip(ends) {
            for sample in first..end {
                let at = self.values[sample].value;
                let rises = sample > first && self.values[sample - 1].value > at;
                let falls = sample + 1 < end && self.values[sample + 1].value >= at;
                if !rises && !falls {
                    found.push(self.near(sample, (first, end)));
                }
            }
        }
        sort_descending(&mut found, |extreme| extreme.value.value);
        found.truncate(MOST);
        found
    }

    /// Returns the greatest value between the neighbours of a sample.
    fn near(&self, sample: usize, (first, end): (usize, usize)) -> Extreme {
        let count = POINTS.min(end - first);
        let from = (sample + 1).saturating_sub(count / 2).clamp(first, end - count);
        let span = self.times[from + count - 1] - self.times[from];
        let still = || Extreme {
            value: self.values[sample].clone(),
            time: Value {
                value: self.times[sample],
                slopes: vec![0.0; self.values[sample].slopes.len()],
            },
        };
        if count < 3 || span <= 0.0 {
            return still();
        }
        // Polynomials are in units of the samples' span, relative to the sample.
        let inner = |time: f64| (time - self.times[sample]) / span;
        let matrix = DMatrix::from_fn(count, count, |row, power| {
            inner(self.times[from + row]).powi(power as i32)
        });
        let Some(inverse) = matrix.try_inverse() else { return still() };
        let coefficients = |of: &dyn Fn(&Value) -> f64| {
            &inverse * DVector::from_fn(count, |row, _| of(&self.values[from + row]))
        };
        let polynomial = coefficients(&|value| value.value);
        let low = inner(self.times[sample.max(first + 1) - 1]);
        let high = inner(self.times[(sample + 1).min(end - 1)]);
        let (mut best, mut at) = (self.values[sample].value, 0.0);
        let mut moves = false;
        for part in 0..PARTS {
            let edge = |part: usize| low + (high - low) * part as f64 / PARTS as f64;
            if let Some(root) = falling_root(&polynomial, edge(part), edge(part + 1)) {
                let value = evaluate(&polynomial, 0, root);
                if value >= best {
                    (best, at, moves) = (value, root, true);
                }
            }
        }
        if !moves {
            return still();
        }
        let bend = evaluate(&polynomial, 2, at);
        let count = self.values[sample].slopes.len();
        let mut extreme = still();
        extreme.value.value = best;
        extreme.time.value += at * span;
        for k in 0..count {
            let slope = coefficients(&|value| value.slopes[k]);
            extreme.value.slopes[k] = evaluate(&slope, 0, at);
            if bend != 0.0 {
                extreme.time.slopes[k] = -evaluate(&slope, 1, at) / bend * span;
            }
        }
        extreme
    }

    /// Returns the integral over time: by parabolas through three samples each where they are
    /// equally spaced, otherwise by trapezoids.
    pub fn integral(&self) -> Value {
        let weights = self.weights();
        let mut sum = Value { value: 0.0, slopes: vec![0.0; self.values[0].slopes.len()] };
        for (weight, value) in weights.iter().zip(&self.values) {
            sum.value += weight * value.value;
            sum.slopes
                .iter_mut()
                .zip(&value.slopes)
                .for_each(|(sum, slope)| *sum += weight * slope);
        }
        sum
    }

    fn weights(&self) -> Vec<f64> {
        const EVEN: f64 = 1e-9;
        let mut weights = vec![0.0; self.times.len()];
        let mut row = 0;
        while row + 1 < self.times.len() {
            let step = self.times[row + 1] - self.times[row];
            let is_even = row + 2 < self.times.len() && {
                let next = self.times[row + 2] - self.times[row + 1];
                let breaks = [row + 1, row + 2].iter().any(|k| self.stretches.contains(k));
                (next - step).abs() <= EVEN * step && !breaks
            };
            if is_even {
                weights[row] += step / 3.0;
                weights[row + 1] += 4.0 * step / 3.0;
                weights[row + 2] += step / 3.0;
                row += 2;
            } else {
                weights[row] += 0.5 * step;
                weights[row + 1] += 0.5 * step;
                row += 1;
            }
        }
        weights
    }
}

/// Returns the value of a polynomial, or of its first or second derivative.
fn evaluate(coefficients: &DVector<f64>, order: usize, at: f64) -> f64 {
    let term = |(power, coefficient): (usize, &f64)| {
        let factor: usize = (0..order).map(|k| power.saturating_sub(k)).product();
        if power < order {
            0.0
        } else {
            factor as f64 * coefficient * at.powi((power - order) as i32)
        }
    };
    coefficients.iter().enumerate().map(term).sum()
}

/// Returns the point between two others where the slope of a polynomial changes from positive to
/// negative.
fn falling_root(coefficients: &DVector<f64>, mut low: f64, mut high: f64) -> Option<f64> {
    const HALVINGS: usize = 60;
    let slope = |at: f64| evaluate(coefficients, 1, at);
    if !(slope(low) >= 0.0 && slope(high) < 0.0) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if slope(middle) >= 0.0 { low = middle } else { high = middle }
    }
    Some(0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns x = e^(-d t) sin(w t) and its derivatives by d and w.
    fn decay(times: &[f64], d: f64, w: f64) -> Vec<Value> {
        let at = |t: &f64| {
            let (sine, cosine) = (w * t).sin_cos();
            let fade = (-d * t).exp();
            Value { value: fade * sine, slopes: vec![-t * fade * sine, t * fade * cosine] }
        };
        times.iter().map(at).collect()
    }

    #[test]
    fn peaks_and_their_times_are_those_of_the_closed_form() {
        let times: Vec<f64> = (0..=400).map(|k| 0.0125 * f64::from(k)).collect();
        for (d, w) in [(0.3_f64, 7.0_f64), (0.05, 3.1), (1.0, 11.0)] {
            let course = Course { times: &times, stretches: &[0], values: decay(&times, d, w) };
            let peak = |d: f64, w: f64| {
                let t = (w / d).atan() / w;
                ((-d * t).exp() * (w * t).sin(), t)
            };
            let found = &course.greatest()[0];
            let (value, time) = peak(d, w);
            let (off, late) = (found.value.value - value, found.time.value - time);
            assert!(off.abs() < 1e-7 && late.abs() < 1e-5, "{off:e} {late:e}");
            let h = 1e-5;
            for (k, (ahead, behind)) in
                [(peak(d + h, w), peak(d - h, w)), (peak(d, w + h), peak(d, w - h))]
                    .iter()
                    .enumerate()
            {
                let by_value = (ahead.0 - behind.0) / (2.0 * h);
                let by_time = (ahead.1 - behind.1) / (2.0 * h);
                assert!((found.value.slopes[k] - by_value).abs() < 1e-6, "{k}");
                assert!((found.time.slopes[k] - by_time).abs() < 1e-4, "{k}");
            }
            // Later peaks decrease by a constant factor.
            let second = &course.greatest()[1];
            let share = (-d * std::f64::consts::TAU / w).exp();
            assert!((second.value.value / value - share).abs() < 1e-6);
            // Integral up to each time in closed form.
            let whole = |t: f64| {
                let (sine, cosine) = (w * t).sin_cos();
                (w - (-d * t).exp() * (d * sine + w * cosine)) / (d * d + w * w)
            };
            assert!((course.integral().value - whole(5.0)).abs() < 1e-6);
        }
    }

    #[test]
    fn nothing_is_interpolated_across_a_jump() {
        let times: Vec<f64> = (0..=10).map(f64::from).collect();
        let value = |k: usize| Value { value: if k < 5 { k as f64 } else { -1.0 }, slopes: vec![] };
        let values = (0..=10).map(value).collect();
        let course = Course { times: &times, stretches: &[0, 5], values };
        assert_eq!(course.greatest()[0].value.value.to_bits(), 4.0_f64.to_bits());
    }
}
