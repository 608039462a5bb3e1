//! Stick-slip of a sprung mass on a belt with constant kinetic friction.
//!
//! ```text
//! sticks:  x' = V until k x = F_s
//! slides:  m x'' + k x = F from x = F_s/k, x' = V
//!          x = F/k + b cos w t + (V/w) sin w t,  b = (F_s - F)/k,  w^2 = k/m
//!          until x' = V again, at w t = 2 (pi - atan(b w/V)), x = F/k - b
//! ```
//!
//! Source: textbook.

use std::f64::consts::PI;

use super::Number;

/// Mass, spring, belt and friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StickSlip<N = f64> {
    /// m \[kg\], positive.
    pub mass: N,
    /// k \[N/m\], positive.
    pub stiffness: N,
    /// V \[m/s\], positive.
    pub belt_speed: N,
    /// F_s \[N\].
    pub limit: N,
    /// F \[N\], less than F_s.
    pub kinetic: N,
}

impl<N: Number> StickSlip<N> {
    /// Deflection \[m\], velocity \[m/s\] and how often stick and slip have changed, at
    /// time t \[s\] after the mass started to stick at x = 0.
    #[must_use]
    pub fn motion(&self, t: f64) -> (N, N, usize) {
        let t = N::literal(t);
        let first = self.limit / self.stiffness / self.belt_speed;
        if t.value() < first.value() {
            return (self.belt_speed * t, self.belt_speed, 0);
        }
        let cycles = ((t - first) / self.period()).value().floor();
        let since = t - first - N::literal(cycles) * self.period();
        let switches = 2 * cycles as usize + 1;
        let (offset, frequency) = (self.offset(), self.frequency());
        let centre = self.kinetic / self.stiffness;
        if since.value() < self.slip_time().value() {
            let (sin, cos) = (frequency * since).sin_cos();
            let swing = self.belt_speed / frequency;
            let x = centre + offset * cos + swing * sin;
            (x, frequency * (swing * cos - offset * sin), switches)
        } else {
            let stuck = since - self.slip_time();
            (centre - offset + self.belt_speed * stuck, self.belt_speed, switches + 1)
        }
    }

    /// Time of a whole cycle \[s\].
    #[must_use]
    pub fn period(&self) -> N {
        self.slip_time() + N::literal(2.0) * self.offset() / self.belt_speed
    }

    fn slip_time(&self) -> N {
        let frequency = self.frequency();
        let angle = N::literal(PI) - (self.offset() * frequency / self.belt_speed).atan();
        N::literal(2.0) * angle / frequency
    }

    fn frequency(&self) -> N {
        (self.stiffness / self.mass).sqrt()
    }

    fn offset(&self) -> N {
        (self.limit - self.kinetic) / self.stiffness
    }
}

#[cfg(test)]
mod tests {
    use super::StickSlip;

    #[test]
    fn deflection_and_velocity_are_continuous_over_a_cycle() {
        let belt =
            StickSlip { mass: 1.0, stiffness: 400.0, belt_speed: 0.1, limit: 4.0, kinetic: 2.5 };
        let first = 0.1;
        for change in [first, first + belt.slip_time(), first + belt.period()] {
            let (before, after) = (belt.motion(change - 1e-9), belt.motion(change + 1e-9));
            assert!((before.0 - after.0).abs() < 1e-9 && (before.1 - after.1).abs() < 1e-7);
            assert_eq!(before.2 + 1, after.2);
        }
    }
}
