//! Free vibration of a mass on a linear and a cubic spring, exactly.
//!
//! ```text
//! m x'' + k1 x + k3 x^3 = 0        x(0) = X, x'(0) = 0
//! x = X cn(w t | n)     w^2 = (k1 + k3 X^2)/m     n = k3 X^2/(2 (k1 + k3 X^2))
//! ```
//!
//! because cn'' = (2 n - 1) cn - 2 n cn^3 (n is the parameter, the square of the
//! modulus). The period is 4 K(n)/w. Holds for stiffening springs, 0 <= n < 1/2.
//!
//! Source: textbook.

use std::f64::consts::PI;

use super::Number;

/// Mass on a spring with force k1 x + k3 x^3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Duffing<N = f64> {
    /// m \[kg\], positive.
    pub mass: N,
    /// k1 \[N/m\], positive.
    pub stiffness: N,
    /// k3 \[N/m^3\], not negative.
    pub cubic_stiffness: N,
}

impl<N: Number> Duffing<N> {
    /// Returns position \[m\] and velocity \[m/s\] at time t \[s\] after release at X \[m\].
    #[must_use]
    pub fn motion(&self, t: f64, amplitude: N) -> (N, N) {
        let frequency = self.frequency(amplitude);
        let [sn, cn, dn] = jacobi(frequency * N::literal(t), self.parameter(amplitude));
        (amplitude * cn, -amplitude * frequency * sn * dn)
    }

    /// Period 4 K(n)/w \[s\], with K = pi/(2 agm(1, sqrt(1 - n))).
    #[must_use]
    pub fn period(&self, amplitude: N) -> N {
        let one = N::literal(1.0);
        let mean = arithmetic_geometric_mean(one, (one - self.parameter(amplitude)).sqrt());
        N::literal(2.0 * PI) / (mean * self.frequency(amplitude))
    }

    /// w \[rad/s\] of cn(w t).
    fn frequency(&self, amplitude: N) -> N {
        (self.largest_stiffness(amplitude) / self.mass).sqrt()
    }

    /// n.
    fn parameter(&self, amplitude: N) -> N {
        let twice = N::literal(2.0) * self.largest_stiffness(amplitude);
        self.cubic_stiffness * amplitude * amplitude / twice
    }

    /// k1 + k3 X^2, force over deflection at the turning point.
    fn largest_stiffness(&self, amplitude: N) -> N {
        self.stiffness + self.cubic_stiffness * amplitude * amplitude
    }
}

fn middle<N: Number>(a: N, b: N) -> N {
    N::literal(0.5) * (a + b)
}

/// Returns the common limit of both means; six steps suffice, since each squares the distance.
fn arithmetic_geometric_mean<N: Number>(mut a: N, mut b: N) -> N {
    for _ in 0..6 {
        (a, b) = (middle(a, b), (a * b).sqrt());
    }
    a
}

/// sn, cn and dn of u at the parameter n, 0 <= n < 1, by the means of 1 and sqrt(1 - n):
/// from the amplitude 2^k a_k u of the last of them back to that of the first (Abramowitz
/// and Stegun 16.4).
fn jacobi<N: Number>(u: N, n: N) -> [N; 3] {
    const STEPS: usize = 6;
    let one = N::literal(1.0);
    let (mut a, mut b) = (one, (one - n).sqrt());
    let mut ratios = [N::literal(0.0); STEPS];
    let mut scale = 1.0;
    for ratio in &mut ratios {
        let next = middle(a, b);
        *ratio = N::literal(0.5) * (a - b) / next;
        (a, b) = (next, (a * b).sqrt());
        scale *= 2.0;
    }
    let mut amplitude = N::literal(scale) * a * u;
    for ratio in ratios.iter().rev() {
        let (sine, _) = amplitude.sin_cos();
        amplitude = middle(amplitude, (*ratio * sine).asin());
    }
    let (sn, cn) = amplitude.sin_cos();
    [sn, cn, (one - n * sn * sn).sqrt()]
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAYER: Duffing = Duffing { mass: 2.1, stiffness: 45_800.0, cubic_stiffness: 2e9 };
    const AMPLITUDE: f64 = 5e-3;

    #[test]
    fn the_motion_keeps_its_energy_and_obeys_its_equation() {
        let energy = |(x, v): (f64, f64)| {
            LAYER.mass * v * v / 2.0
                + LAYER.stiffness * x * x / 2.0
                + LAYER.cubic_stiffness * x.powi(4) / 4.0
        };
        let start = energy((AMPLITUDE, 0.0));
        for step in 0..100 {
            let t = f64::from(step) * 1e-3;
            let (x, v) = LAYER.motion(t, AMPLITUDE);
            assert!((energy((x, v)) / start - 1.0).abs() < 1e-13);
            let h = 1e-6;
            let rate =
                (LAYER.motion(t + h, AMPLITUDE).0 - LAYER.motion(t - h, AMPLITUDE).0) / (2.0 * h);
            assert!((rate - v).abs() < 1e-6, "{rate} against {v}");
        }
    }

    #[test]
    fn the_period_is_that_of_the_quadrature() {
        // t = integral of dx/v over a quarter turn, x = X sin a: by the midpoint rule,
        // which converges at once for a periodic function.
        let steps = 200_u32;
        let width = std::f64::consts::FRAC_PI_2 / f64::from(steps);
        let square = AMPLITUDE * AMPLITUDE;
        let quarter: f64 = (0..steps)
            .map(|step| {
                let sine = ((f64::from(step) + 0.5) * width).sin();
                let root =
                    LAYER.stiffness + LAYER.cubic_stiffness * square * (1.0 + sine * sine) / 2.0;
                width / (root / LAYER.mass).sqrt()
            })
            .sum();
        let period = LAYER.period(AMPLITUDE);
        assert!((4.0 * quarter / period - 1.0).abs() < 1e-14);
        let (x, v) = LAYER.motion(3.0 * period, AMPLITUDE);
        assert!((x / AMPLITUDE - 1.0).abs() < 1e-13 && v.abs() < 1e-11);
    }

    #[test]
    fn without_the_cubic_term_it_is_harmonic() {
        let linear = Duffing { cubic_stiffness: 0.0, ..LAYER };
        let frequency = (45_800.0_f64 / 2.1).sqrt();
        let (x, _) = linear.motion(0.1, 1.0);
        assert!((x - (frequency * 0.1).cos()).abs() < 1e-13);
    }
}
