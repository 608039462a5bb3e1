//! The polynomial through samples of a function over an interval of time, and its sign.

use std::sync::LazyLock;

/// Number of samples. Eight intervals are exact for the polynomials of all steps of explicit pairs
/// and collocation methods, and the transformation to Bernstein form loses two digits.
pub(super) const NODES: usize = 9;

/// Sample points as shares of an interval, both ends included (Chebyshev-Lobatto).
pub(super) static SHARES: LazyLock<[f64; NODES]> = LazyLock::new(|| {
    std::array::from_fn(|index| {
        let angle = std::f64::consts::PI * index as f64 / (NODES - 1) as f64;
        let share = 0.5 * (1.0 - angle.cos());
        if index == NODES - 1 { 1.0 } else { share }
    })
});

/// Share of the largest coefficient below which the last ones show how the others continue.
const RESOLVED: f64 = 1e-3;

/// Coefficients in Bernstein form, which enclose the polynomial, and a bound of the distance of the
/// function from it.
pub(super) struct Enclosure {
    pub(super) coefficients: [f64; NODES],
    /// Bound of the terms beyond the last Chebyshev coefficients, and rounding.
    pub(super) error: f64,
}

/// Matrix from Chebyshev coefficients to those in Bernstein form on \[0, 1\].
static TO_BERNSTEIN: LazyLock<[[f64; NODES]; NODES]> = LazyLock::new(|| {
    const N: usize = NODES - 1;
    // T_k(2 x - 1) by powers of x, exact: coefficients are integers below 2^53.
    let mut powers = [[0.0; NODES]; NODES];
    powers[0][0] = 1.0;
    powers[1][0] = -1.0;
    powers[1][1] = 2.0;
    for k in 2..NODES {
        for power in 0..NODES {
            let shifted = if power > 0 { powers[k - 1][power - 1] } else { 0.0 };
            powers[k][power] = 4.0 * shifted - 2.0 * powers[k - 1][power] - powers[k - 2][power];
        }
    }
    let choose = |n: usize, k: usize| {
        (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
    };
    let mut matrix = [[0.0; NODES]; NODES];
    for (row, entries) in matrix.iter_mut().enumerate() {
        for (k, entry) in entries.iter_mut().enumerate() {
            *entry = (0..=row)
                .map(|power| powers[k][power] * choose(row, power) / choose(N, power))
                .sum();
        }
    }
    matrix
});

/// cos(pi j k/N) over N/2, with halves at the ends and halves of the end coefficients.
static TO_CHEBYSHEV: LazyLock<[[f64; NODES]; NODES]> = LazyLock::new(|| {
    const N: usize = NODES - 1;
    let half = |index: usize| if index == 0 || index == N { 0.5 } else { 1.0 };
    std::array::from_fn(|k| {
        std::array::from_fn(|j| {
            // Samples start at the beginning of the interval, cosines at its end.
            let angle = std::f64::consts::PI * ((N - j) * k) as f64 / N as f64;
            half(k) * half(j) * angle.cos() * 2.0 / N as f64
        })
    })
});

impl Enclosure {
    /// Returns the enclosure for samples at [`SHARES`], each off by at most `noise`. `beyond` bounds
    /// the distance between the function and the polynomial through its values, if it is known.
    pub(super) fn of(samples: &[f64; NODES], noise: f64, beyond: Option<f64>) -> Self {
        let apply = |matrix: &[[f64; NODES]; NODES], to: &[f64; NODES]| -> [f64; NODES] {
            std::array::from_fn(|row| matrix[row].iter().zip(to).map(|(a, b)| a * b).sum())
        };
        let mut modes = apply(&TO_CHEBYSHEV, samples);
        let largest = samples.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let pair = |first: usize| modes[first].abs() + modes[first + 1].abs();
        let (tail, earlier) = (pair(NODES - 2), pair(NODES - 4));
        // The terms beyond decay as these two pairs do, or slower. Those of a corner decay as
        // 1/k^2, which occurs only where next to nothing of it is left.
        let decay = (tail / earlier).sqrt();
        let turns = modes[1..].iter().fold(0.0, |most: f64, mode| most.max(mode.abs()));
        let rounding = 16.0 * f64::EPSILON * largest;
        let beyond = if let Some(beyond) = beyond {
            beyond + 2.0 * noise
        } else if tail <= rounding.max(2.0 * noise) {
            2.0 * noise
        } else if decay < 1.0 && tail <= RESOLVED * turns {
            8.0 * tail / (1.0 - decay)
        } else if tail > 0.0 {
            modes[1..].iter().map(|mode| mode.abs()).sum()
        } else {
            0.0
        };
        let mut error = beyond + rounding;
        // What is no larger than the error tells nothing, and Bernstein's form would multiply it.
        let told = error;
        for mode in modes.iter_mut().filter(|mode| mode.abs() <= told) {
            error += mode.abs();
            *mode = 0.0;
        }
        Self { coefficients: apply(&TO_BERNSTEIN, &modes), error }
    }

    /// Returns the largest distance between a function and the polynomial through its samples over a
    /// span, for a bound of its derivative of order [`NODES`]: the product of the distances from
    /// all nodes is (1 - x^2) U_7(x)/2^7 on \[-1, 1\].
    pub(super) fn beyond(derivative: f64, span: f64) -> f64 {
        let factorial: f64 = (1..=NODES).map(|factor| factor as f64).product();
        let half = (0.5 * span).powi(NODES as i32);
        derivative * half / (factorial * 2f64.powi(NODES as i32 - 2))
    }

    /// Returns whether the function is surely positive.
    pub(super) fn is_above(&self) -> bool {
        self.coefficients.iter().all(|coefficient| *coefficient > self.error)
    }

    /// Returns whether the function rises or falls throughout, except for a small share of its
    /// range.
    pub(super) fn is_monotone(&self) -> bool {
        /// Share of the polynomial's range; a larger deviation may turn round in between.
        const PART: f64 = 1e-2;
        let steps = || self.coefficients.windows(2).map(|pair| pair[1] - pair[0]);
        let way = (self.coefficients[NODES - 1] - self.coefficients[0]).abs();
        let is_monotone = steps().all(|step| step <= 0.0) || steps().all(|step| step >= 0.0);
        is_monotone && self.error <= PART * way
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples(of: impl Fn(f64) -> f64) -> [f64; NODES] {
        SHARES.map(of)
    }

    /// Evaluates the Bernstein form by de Casteljau's algorithm.
    fn value(coefficients: &[f64; NODES], x: f64) -> f64 {
        let mut all = *coefficients;
        for left in (1..NODES).rev() {
            for index in 0..left {
                all[index] += x * (all[index + 1] - all[index]);
            }
        }
        all[0]
    }

    #[test]
    fn polynomials_are_met_exactly_and_enclosed() {
        for degree in 0..=6 {
            let of = |x: f64| (x - 0.3).powi(degree) + 0.1 * x;
            let enclosure = Enclosure::of(&samples(of), 0.0, None);
            for x in [0.0, 0.123, 0.5, 0.77, 1.0] {
                let off = (value(&enclosure.coefficients, x) - of(x)).abs();
                assert!(off < 1e-13, "degree {degree} at {x}: {off}");
                let [least, most] = enclosure
                    .coefficients
                    .iter()
                    .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], c| [a.min(*c), b.max(*c)]);
                assert!((least - 1e-13..=most + 1e-13).contains(&of(x)));
            }
            assert!(enclosure.error < 1e-13);
        }
    }

    #[test]
    fn a_known_derivative_bounds_the_distance_from_the_polynomial() {
        let mut closest: f64 = 0.0;
        for rate in [0.5_f64, 2.0, 5.0, 9.0] {
            let of = |x: f64| (rate * x + 0.4).sin();
            let beyond = Enclosure::beyond(rate.powi(NODES as i32), 1.0);
            let enclosure = Enclosure::of(&samples(of), 0.0, Some(beyond));
            for k in 0..=500 {
                let x = f64::from(k) / 500.0;
                let off = (value(&enclosure.coefficients, x) - of(x)).abs();
                assert!(off <= enclosure.error, "{rate} at {x}: {off} {}", enclosure.error);
                closest = closest.max(off / enclosure.error);
            }
        }
        assert!(closest > 0.1, "the bound is never near: {closest}");
    }

    #[test]
    fn the_error_covers_what_a_function_is_off_its_polynomial() {
        for rate in [1.0, 3.0, 6.0, 10.0] {
            let of = |x: f64| (rate * x).sin() + 0.2;
            let enclosure = Enclosure::of(&samples(of), 0.0, None);
            for k in 0..=200 {
                let x = f64::from(k) / 200.0;
                let off = (value(&enclosure.coefficients, x) - of(x)).abs();
                assert!(off <= enclosure.error, "{rate} at {x}: {off} {}", enclosure.error);
            }
        }
    }
}
