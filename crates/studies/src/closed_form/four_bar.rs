//! A four-bar linkage: Freudenstein's equation, and its speed from conservation of energy.
//!
//! Crank a, coupler b, rocker c, base d along the line from which angles count; the
//! rocker's angle p follows from the crank's angle th by
//!
//! ```text
//! k1 cos p - k2 cos th + k3 = cos(th - p)
//! k1 = d/a    k2 = d/c    k3 = (a^2 - b^2 + c^2 + d^2)/(2 a c)
//! I(th) th'^2/2 + V(th) = E
//! ```
//!
//! At rest where V' = 0, by the balance of virtual works, it swings with w^2 = V''/I.
//!
//! Source: F. Freudenstein, Trans. ASME 76 (1954) 483-492; the rest is a textbook's.

/// A bar, its centre of mass in the middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bar {
    /// Length \[m\].
    pub length: f64,
    /// Mass \[kg\].
    pub mass: f64,
    /// Moment of inertia about the centre of mass \[kg m^2\].
    pub inertia: f64,
}

/// The linkage, open (not crossed).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FourBar {
    /// a.
    pub crank: Bar,
    /// b.
    pub coupler: Bar,
    /// c.
    pub rocker: Bar,
    /// d \[m\].
    pub base: f64,
    /// g \[m/s^2\], against the direction of the angle pi/2.
    pub gravity: f64,
}

impl FourBar {
    /// Returns the angles of coupler and rocker at the crank's angle \[rad\]; NaN out of reach.
    #[must_use]
    pub fn angles(&self, crank: f64) -> (f64, f64) {
        let [a, b, c] = [self.crank, self.coupler, self.rocker].map(|bar| bar.length);
        let d = self.base;
        let (k1, k2) = (d / a, d / c);
        let k3 = (a * a - b * b + c * c + d * d) / (2.0 * a * c);
        let (sin, cos) = crank.sin_cos();
        let first = cos - k1 - k2 * cos + k3;
        let middle = -2.0 * sin;
        let last = k1 - (k2 + 1.0) * cos + k3;
        let root = (middle * middle - 4.0 * first * last).sqrt();
        let half = (-middle - root).atan2(2.0 * first);
        let rocker = (2.0 * half).sin().atan2((2.0 * half).cos());
        let across = c * rocker.sin() - a * sin;
        let along = d + c * rocker.cos() - a * cos;
        (across.atan2(along), rocker)
    }

    /// Angular speeds of coupler and rocker over the crank's.
    #[must_use]
    pub fn ratios(&self, crank: f64) -> (f64, f64) {
        let (coupler, rocker) = self.angles(crank);
        let [a, b, c] = [self.crank, self.coupler, self.rocker].map(|bar| bar.length);
        let between = (rocker - coupler).sin();
        (a * (crank - rocker).sin() / (b * between), a * (crank - coupler).sin() / (c * between))
    }

    /// Speed of the crank \[rad/s\] at an angle, from angle and speed at another.
    #[must_use]
    pub fn speed(&self, crank: f64, (start, start_speed): (f64, f64)) -> f64 {
        let energy = 0.5 * self.inertia(start) * start_speed * start_speed + self.potential(start);
        (2.0 * (energy - self.potential(crank)) / self.inertia(crank)).sqrt()
    }

    /// Angle of the crank \[rad\] at which the linkage rests, near a guess, by Newton's
    /// method, and w \[rad/s\] of small oscillations about it; NaN if it would fall.
    #[must_use]
    pub fn small_oscillation(&self, guess: f64) -> (f64, f64) {
        let mut angle = guess;
        for _ in 0..50 {
            let (slope, curvature) = self.slopes(angle);
            angle -= slope / curvature;
        }
        (angle, (self.slopes(angle).1 / self.inertia(angle)).sqrt())
    }

    /// V' \[N m\] and V'' \[N m/rad\].
    fn slopes(&self, crank: f64) -> (f64, f64) {
        let (coupler, rocker) = self.angles(crank);
        let (by_coupler, by_rocker) = self.ratios(crank);
        let [a, b, c] = [self.crank, self.coupler, self.rocker].map(|bar| bar.length);
        // Ratios are a sin(th - p)/(b s) and a sin(th - f)/(c s), s = sin(p - f).
        let (sine, cosine) = (rocker - coupler).sin_cos();
        let widening = cosine * (by_rocker - by_coupler) / sine;
        let bent = |other: f64, ratio: f64, own: f64, length: f64| {
            a * (crank - other).cos() * (1.0 - ratio) / (length * sine) - own * widening
        };
        let coupler_bent = bent(rocker, by_rocker, by_coupler, b);
        let rocker_bent = bent(coupler, by_coupler, by_rocker, c);
        // Height of a bar's middle over its start: l sin(angle)/2.
        let height = |bar: Bar, angle: f64, ratio: f64, bent: f64| {
            let half = 0.5 * bar.length;
            let slope = half * angle.cos() * ratio;
            (slope, half * (angle.cos() * bent - angle.sin() * ratio * ratio))
        };
        let bars = [
            (self.crank.mass, height(self.crank, crank, 1.0, 0.0)),
            (self.coupler.mass, (a * crank.cos(), -a * crank.sin())),
            (self.coupler.mass, height(self.coupler, coupler, by_coupler, coupler_bent)),
            (self.rocker.mass, height(self.rocker, rocker, by_rocker, rocker_bent)),
        ];
        let sum = |of: fn((f64, f64)) -> f64| {
            self.gravity * bars.iter().map(|(mass, slopes)| mass * of(*slopes)).sum::<f64>()
        };
        (sum(|slopes| slopes.0), sum(|slopes| slopes.1))
    }

    /// I \[kg m^2\].
    fn inertia(&self, crank: f64) -> f64 {
        let (coupler, _) = self.angles(crank);
        let (coupler_rate, rocker_rate) = self.ratios(crank);
        let pivoted = |bar: Bar| bar.inertia + bar.mass * (0.5 * bar.length).powi(2);
        let (a, half) = (self.crank.length, 0.5 * self.coupler.length);
        let square = a * a
            + half * half * coupler_rate * coupler_rate
            + 2.0 * a * half * coupler_rate * (crank - coupler).cos();
        pivoted(self.crank)
            + self.coupler.mass * square
            + self.coupler.inertia * coupler_rate * coupler_rate
            + pivoted(self.rocker) * rocker_rate * rocker_rate
    }

    /// V \[J\].
    fn potential(&self, crank: f64) -> f64 {
        let (coupler, rocker) = self.angles(crank);
        let height = |bar: Bar, angle: f64| 0.5 * bar.length * angle.sin();
        let of_coupler = self.crank.length * crank.sin() + height(self.coupler, coupler);
        self.gravity
            * (self.crank.mass * height(self.crank, crank)
                + self.coupler.mass * of_coupler
                + self.rocker.mass * height(self.rocker, rocker))
    }
}

/// The machine of the scene `four_bar`.
pub const FOUR_BAR: FourBar = FourBar {
    crank: Bar { length: 0.1, mass: 0.5, inertia: 4.5e-4 },
    coupler: Bar { length: 0.25, mass: 0.9, inertia: 4.7e-3 },
    rocker: Bar { length: 0.2, mass: 0.7, inertia: 2.4e-3 },
    base: 0.22,
    gravity: 9.81,
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_loop_closes() {
        for angle in [0.0, 1.5, 3.0, 5.0] {
            let (coupler, rocker) = FOUR_BAR.angles(angle);
            let x = 0.1 * angle.cos() + 0.25 * coupler.cos() - 0.2 * rocker.cos() - 0.22;
            let y = 0.1 * angle.sin() + 0.25 * coupler.sin() - 0.2 * rocker.sin();
            assert!(x.abs() < 1e-15 && y.abs() < 1e-15);
        }
    }

    #[test]
    fn ratios_are_differences_of_angles() {
        for angle in [0.2, 1.5, 3.0, 5.0] {
            let step = 1e-5;
            let (before, after) = (FOUR_BAR.angles(angle - step), FOUR_BAR.angles(angle + step));
            let (coupler, rocker) = FOUR_BAR.ratios(angle);
            assert!(((after.0 - before.0) / (2.0 * step) - coupler).abs() < 1e-8);
            assert!(((after.1 - before.1) / (2.0 * step) - rocker).abs() < 1e-8);
        }
    }
    #[test]
    fn slopes_are_differences_of_the_potential() {
        for angle in [0.2, 1.5, 3.0, 5.0] {
            let step = 1e-5;
            let around =
                |of: &dyn Fn(f64) -> f64| (of(angle + step) - of(angle - step)) / (2.0 * step);
            let (slope, curvature) = FOUR_BAR.slopes(angle);
            assert!((around(&|angle| FOUR_BAR.potential(angle)) - slope).abs() < 1e-8);
            assert!((around(&|angle| FOUR_BAR.slopes(angle).0) - curvature).abs() < 1e-8);
        }
    }

    #[test]
    fn it_rests_where_it_is_lowest() {
        let (angle, frequency) = FOUR_BAR.small_oscillation(-1.5);
        let here = FOUR_BAR.potential(angle);
        assert!(frequency > 0.0);
        assert!(here < FOUR_BAR.potential(angle - 0.1) && here < FOUR_BAR.potential(angle + 0.1));
    }
}
