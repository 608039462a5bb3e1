//! Orders of a run: spectra over the angle of a shaft instead of time.
//!
//! The run is sampled at equal steps of the angle, so that a component that repeats k times in a
//! turn is a line at order k, however fast the speed changes. Blocks of a whole number B of turns
//! overlap; each gives amplitudes at the orders 0, 1/B, 2/B, ...

use machinist::trajectory::Column;

use crate::spectrum::{Window, amplitudes};

/// Blocks per length of a block: each begins a quarter of a block after the one before.
const OVERLAP: usize = 4;

/// Division of a run into blocks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blocks {
    /// Turns of a block.
    pub turns: usize,
    /// Samples of a turn.
    pub samples: usize,
    /// Window function.
    pub window: Window,
}

/// Amplitudes of one output over speed and order.
#[derive(Debug, Clone, PartialEq)]
pub struct Waterfall {
    /// Time in the middle of each block \[s\].
    pub times: Vec<f64>,
    /// Mean speed of each block \[rad/s\].
    pub speeds: Vec<f64>,
    /// Orders of the lines.
    pub orders: Vec<f64>,
    /// Amplitudes, a row for each block, mean first.
    pub amplitudes: Vec<Vec<f64>>,
}

impl Blocks {
    /// Returns the samples of a block.
    fn length(self) -> usize {
        self.turns * self.samples
    }

    /// Returns the amplitudes of samples at equal steps of the angle, taken at `times` \[s\].
    /// There are none if the samples do not fill a block.
    pub fn waterfall(self, times: &[f64], values: &[f64]) -> Waterfall {
        let length = self.length();
        let step = (length / OVERLAP).max(1);
        let beginnings = 0..times.len().saturating_sub(length);
        let starts: Vec<usize> = beginnings.step_by(step).collect();
        let turns = self.turns as f64;
        let span = |start: &usize| times[start + length] - times[*start];
        Waterfall {
            times: starts.iter().map(|start| times[start + length / 2]).collect(),
            speeds: starts.iter().map(|at| std::f64::consts::TAU * turns / span(at)).collect(),
            orders: (0..=length / 2).map(|line| line as f64 / turns).collect(),
            amplitudes: starts
                .iter()
                .map(|start| amplitudes(&values[*start..start + length], self.window))
                .collect(),
        }
    }
}

impl Waterfall {
    /// Returns the amplitude of a line over the blocks.
    pub fn cut(&self, line: usize) -> Vec<f64> {
        self.amplitudes.iter().map(|row| row[line]).collect()
    }

    /// Returns the greatest amplitude of each line.
    pub fn greatest(&self) -> Vec<f64> {
        let greatest = |line: usize| self.cut(line).into_iter().fold(0.0, f64::max);
        (0..self.orders.len()).map(greatest).collect()
    }

    /// Returns the lines whose greatest amplitude is greater than those of both neighbours, the
    /// greatest first, without the mean.
    pub fn strongest(&self, most: usize) -> Vec<usize> {
        crate::spectrum::peaks(&self.greatest(), most)
    }
}

/// Returns the times at which an angle passes the multiples of `step` beyond its start, where it
/// is known at `times` with its rate, by cubics that meet both.
///
/// # Errors
/// The time at which the angle does not increase \[s\].
pub fn times_at(
    step: f64,
    times: &[f64],
    angle: &[f64],
    rate: Option<&[f64]>,
) -> Result<Vec<f64>, f64> {
    // A comparison with NaN is no increase either.
    let increases = |pair: &[f64]| pair[0] <= pair[1];
    if let Some(at) = angle.windows(2).position(|pair| !increases(pair)) {
        return Err(times[at]);
    }
    let slope = |at: usize| {
        if let Some(rate) = rate {
            return rate[at];
        }
        let (a, b) = (at.saturating_sub(1), (at + 1).min(times.len() - 1));
        (angle[b] - angle[a]) / (times[b] - times[a])
    };
    let (first, last) = (angle[0], angle[angle.len() - 1]);
    let count = ((last - first) / step).floor() as usize;
    let mut found = Vec::with_capacity(count + 1);
    let mut piece = 0;
    for number in 0..=count {
        let wanted = first + step * number as f64;
        while piece + 2 < angle.len() && angle[piece + 1] < wanted {
            piece += 1;
        }
        let (width, low, high) = (times[piece + 1] - times[piece], angle[piece], angle[piece + 1]);
        let (before, after) = (slope(piece) * width, slope(piece + 1) * width);
        let cubic = |u: f64| {
            let rest = 1.0 - u;
            low * rest * rest * (1.0 + 2.0 * u)
                + before * u * rest * rest
                + high * u * u * (3.0 - 2.0 * u)
                - after * u * u * rest
        };
        let (mut left, mut right) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = f64::midpoint(left, right);
            if cubic(middle) < wanted { left = middle } else { right = middle }
        }
        found.push(times[piece] + width * f64::midpoint(left, right));
    }
    // Times of equal angles may coincide by rounding where the shaft stands.
    found.dedup();
    Ok(found)
}

/// Returns the integral of a speed over time, by cubics through four neighbouring samples.
pub fn integrated(times: &[f64], speed: &[f64]) -> Vec<f64> {
    let mut angle = vec![0.0];
    for at in 0..times.len() - 1 {
        let first = at.saturating_sub(1).min(times.len().saturating_sub(4));
        let last = (first + 4).min(times.len());
        let (x, y) = (&times[first..last], &speed[first..last]);
        let middle = f64::midpoint(times[at], times[at + 1]);
        // Simpson's formula is exact for the cubic.
        let sum = speed[at] + 4.0 * lagrange(x, y, middle) + speed[at + 1];
        angle.push(angle[at] + sum * (times[at + 1] - times[at]) / 6.0);
    }
    angle
}

fn lagrange(x: &[f64], y: &[f64], at: f64) -> f64 {
    let factor = |k: usize| {
        let others = x.iter().enumerate().filter(|(j, _)| *j != k);
        others.map(|(_, other)| (at - other) / (x[k] - other)).product::<f64>()
    };
    y.iter().enumerate().map(|(k, value)| value * factor(k)).sum()
}

/// Returns whether a column is an angle or a speed that orders may refer to.
pub fn is_angle(column: &Column) -> Option<bool> {
    match column.unit.as_str() {
        "rad" => Some(true),
        "rad/s" => Some(false),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn times_of_equal_angles_are_those_of_a_run_up() {
        for (start, growth) in [(1.0, 5.0), (0.0, 20.0), (300.0, -40.0)] {
            let times: Vec<f64> = (0..2001).map(|k| f64::from(k) * 1e-3).collect();
            let angle: Vec<f64> = times.iter().map(|t| start * t + growth * t * t / 2.0).collect();
            let speed: Vec<f64> = times.iter().map(|t| start + growth * t).collect();
            let found = times_at(0.05, &times, &angle, Some(&speed)).expect("it turns forward");
            let summed = integrated(&times, &speed);
            for (number, time) in found.iter().enumerate() {
                let wanted = 0.05 * number as f64;
                let there = start * time + growth * time * time / 2.0;
                assert!((there - wanted).abs() < 1e-9, "{start}, {growth}: {there} for {wanted}");
            }
            for (a, b) in summed.iter().zip(&angle) {
                assert!((a - b).abs() < 1e-10 * (1.0 + b), "{a} for {b}");
            }
        }
    }

    #[test]
    fn a_shaft_that_turns_back_is_refused_at_its_turn() {
        let times = [0.0, 1.0, 2.0, 3.0];
        assert_eq!(times_at(0.1, &times, &[0.0, 1.0, 0.5, 2.0], None), Err(1.0));
        assert_eq!(times_at(0.1, &times, &[0.0, 1.0, f64::NAN, 2.0], None), Err(1.0));
    }

    #[test]
    fn components_that_repeat_in_a_turn_have_their_amplitudes_at_any_speed() {
        let blocks = Blocks { turns: 8, samples: 64, window: Window::Hann };
        for growth in [0.1, 3.0, 50.0] {
            // 100 turns.
            let angles = (0..=6400).map(|k| TAU * f64::from(k) / 64.0);
            let time = |angle: f64| ((1.0 + 2.0 * growth * angle).sqrt() - 1.0) / growth;
            let times: Vec<f64> = angles.clone().map(time).collect();
            let value = |a: f64| 0.7 + 3.0 * (2.0 * a).cos() + 0.5 * (5.5 * a + 1.0).sin();
            let values: Vec<f64> = angles.map(value).collect();
            let found = blocks.waterfall(&times, &values);
            assert_eq!(found.times.len(), found.amplitudes.len());
            assert_eq!(found.strongest(2), [16, 44]);
            for (line, wanted) in [(0, 0.7), (16, 3.0), (44, 0.5), (80, 0.0)] {
                for amplitude in found.cut(line) {
                    assert!((amplitude - wanted).abs() < 1e-12, "{line}: {amplitude}");
                }
            }
            // At a constant acceleration, the mean speed is that at the middle of the time.
            for (block, speed) in found.speeds.iter().enumerate() {
                let [start, end] = [block * 128, block * 128 + 512].map(|sample| times[sample]);
                let wanted = 1.0 + growth * f64::midpoint(start, end);
                assert!((speed / wanted - 1.0).abs() < 1e-9, "{speed} for {wanted}");
            }
        }
    }
}
