//! Oscillator with dry friction, half cycle by half cycle.
//!
//! ```text
//! m x'' + k x = -F sign(x')      x(0) = X, x'(0) = 0
//! x = c + (X - c) cos w t        c = F/k sign(X), w^2 = k/m, for 0 <= w t <= pi
//! ```
//!
//! Each half cycle ends at 2 c - X. The next one begins there if the spring exceeds the breakaway
//! friction, k |x| > F_s; otherwise the mass sticks.
//!
//! Source: textbook.

use std::f64::consts::PI;

use super::Number;

/// Mass on a spring with dry friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoulombOscillator<N = f64> {
    /// m \[kg\], positive.
    pub mass: N,
    /// k \[N/m\], positive.
    pub stiffness: N,
    /// F \[N\], sliding friction.
    pub kinetic: N,
    /// F_s \[N\], breakaway friction, at least F.
    pub limit: N,
}

impl<N: Number> CoulombOscillator<N> {
    /// Returns position \[m\] and velocity \[m/s\] at time t \[s\] after release at X \[m\].
    #[must_use]
    pub fn motion(&self, t: f64, start: N) -> (N, N) {
        let frequency = (self.stiffness / self.mass).sqrt();
        let (mut x, mut phase) = (start, frequency * N::literal(t));
        while self.slides_from(x) {
            let centre = self.centre(x);
            if phase.value() < PI {
                let (sin, cos) = phase.sin_cos();
                return (centre + (x - centre) * cos, -frequency * (x - centre) * sin);
            }
            x = N::literal(2.0) * centre - x;
            phase = phase - N::literal(PI);
        }
        (x, N::literal(0.0))
    }

    /// Returns the number of half cycles until the mass sticks.
    #[must_use]
    pub fn half_cycles(&self, start: N) -> usize {
        let (mut x, mut count) = (start, 0);
        while self.slides_from(x) {
            x = N::literal(2.0) * self.centre(x) - x;
            count += 1;
        }
        count
    }

    fn slides_from(&self, x: N) -> bool {
        self.stiffness.value() * x.value().abs() > self.limit.value()
    }

    fn centre(&self, x: N) -> N {
        self.kinetic / self.stiffness * N::literal(x.value().signum())
    }
}

#[cfg(test)]
mod tests {
    use super::CoulombOscillator;

    const SLIDER: CoulombOscillator =
        CoulombOscillator { mass: 1.0, stiffness: 400.0, kinetic: 2.5, limit: 4.0 };

    #[test]
    fn every_half_cycle_takes_as_much_off_and_the_last_ends_within_the_limit() {
        // 97, 84.5, 72, ..., 9.5 mm: seven times 12.5 mm less, the last below 10 mm.
        assert_eq!(SLIDER.half_cycles(0.097), 7);
        let (x, v) = SLIDER.motion(10.0, 0.097);
        assert!((x + 0.0095).abs() < 1e-15 && v == 0.0, "{x} {v}");
    }

    #[test]
    fn the_motion_obeys_its_equation() {
        let step = 1e-4;
        for tenth in 1..10 {
            let t = 0.1 * f64::from(tenth);
            let at = |t| SLIDER.motion(t, 0.097);
            let acceleration = (at(t + step).1 - at(t - step).1) / (2.0 * step);
            let (x, v) = at(t);
            let residual = acceleration + 400.0 * x + 2.5 * v.signum();
            assert!(residual.abs() < 1e-4, "{residual} at {t}");
        }
    }
}
