//! Mass bouncing on a shaken plate, with one bounce per period.
//!
//! ```text
//! plate A sin w t     flight T = 2 pi/w     leaves and arrives with V = g T/2
//! V - u = e (V + u)   u = A w cos(phase) = V (1 - e)/(1 + e)
//! ```
//!
//! The orbit with the impact while the plate slows down on its way up is stable for
//! accelerations A w^2 from pi g (1 - e)/(1 + e) up to about that of free fall.
//!
//! Source: textbook.

use std::f64::consts::TAU;

/// Plate and mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShakenPlate {
    /// A \[m\].
    pub amplitude: f64,
    /// w \[rad/s\].
    pub frequency: f64,
    /// g \[m/s^2\].
    pub gravity: f64,
    /// e, speed after over speed before an impact.
    pub restitution: f64,
}

impl ShakenPlate {
    /// Returns the time between impacts, 2 pi/w \[s\].
    #[must_use]
    pub fn period(&self) -> f64 {
        TAU / self.frequency
    }

    /// Returns the time of the first impact after 0 \[s\]; NaN if there is no such orbit.
    #[must_use]
    pub fn first_impact(&self) -> f64 {
        let speed = self.launch() * (1.0 - self.restitution) / (1.0 + self.restitution);
        (speed / (self.amplitude * self.frequency)).acos() / self.frequency
    }

    /// Returns height \[m\] and velocity \[m/s\] of the mass on the orbit at time t \[s\].
    #[must_use]
    pub fn motion(&self, t: f64) -> (f64, f64) {
        let height = self.amplitude * (self.frequency * self.first_impact()).sin();
        let flown = (t - self.first_impact()).rem_euclid(self.period());
        let launch = self.launch();
        let fallen = self.gravity * flown;
        (height + (launch - 0.5 * fallen) * flown, launch - fallen)
    }

    /// Returns the number of impacts from 0 until t \[s\].
    #[must_use]
    pub fn impacts(&self, t: f64) -> usize {
        ((t - self.first_impact()) / self.period() + 1.0).floor() as usize
    }

    fn launch(&self) -> f64 {
        self.gravity * self.period() / 2.0
    }
}

#[cfg(test)]
mod tests {
    use super::ShakenPlate;

    #[test]
    fn the_orbit_meets_the_plate_as_the_law_of_impact_wants() {
        let plate = ShakenPlate {
            amplitude: 1.7395e-3,
            frequency: 62.831_853_071_795_86,
            gravity: 9.81,
            restitution: 0.8,
        };
        let at = plate.first_impact();
        let (before, after) = (plate.motion(at - 1e-12), plate.motion(at + 1e-12));
        let (sin, cos) = (62.831_853_071_795_86 * at).sin_cos();
        let speed = 1.7395e-3 * 62.831_853_071_795_86 * cos;
        assert!((before.0 - 1.7395e-3 * sin).abs() < 1e-11);
        assert!((after.1 - speed + 0.8 * (before.1 - speed)).abs() < 1e-10);
        assert_eq!(plate.impacts(0.0), 0);
        assert_eq!(plate.impacts(1000.0), 10_000);
    }
}
