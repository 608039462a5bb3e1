//! The formulas that the saw-gin study prints for its distributed shaft, entered literally, to find
//! the evaluation that gives its figures.
//!
//! The study sets the acceleration of the shaft to a fitted law (3),
//! `phi_tt = 200 e^(2.05 t) cos 75 t`, spreads the load as q x with
//! `q = (Mm + M0 cos(pi w2 t))/(R (pi/3) l)` (9), and integrates
//! `G I phi_xx = rho phi_tt - q x` twice from phi(0) = phi_x(0) = 0 (14), (15):
//!
//! ```text
//! phi_x = [rho phi_tt x     - q x^2/2]/(G I)
//! phi   = [rho phi_tt x^2/2 - q x^3/6]/(G I)          rho = J/l
//! ```
//!
//! Which evaluation gives the headline figures 1.89 deg/m and 4.39 deg:
//!
//! * phi_x at the far end x = l and at t = 1.8 s, with rho = J instead of J/l and
//!   with the load term halved once more (q x^2/4), is -1.89167 deg/m. Its size is
//!   the largest of all x and of all t up to 1.8 s.
//! * That slope times the whole length, phi_x(l) l, is -4.39245 deg; with the slope
//!   first rounded to 1.892 deg/m it is 4.393 deg. It is not formula (15): that
//!   gives -2.11 deg with the same readings.
//! * As printed, with rho = J/l, the slope reaches 1.1464 deg/m up to 1.8 s
//!   (1.1450 at 1.8 s) and the angle 1.1664 deg.
//!
//! Source: saw-gin study (2020), equations (3), (9), (14), (15).

use std::f64::consts::PI;

/// Printed law of cylinder acceleration (3) at time t \[s\]: 200 e^(2.05 t) cos 75 t
/// \[rad/s^2\].
#[must_use]
pub fn acceleration(t: f64) -> f64 {
    200.0 * (2.05 * t).exp() * (75.0 * t).cos()
}

/// Time at which the study states its largest acceleration \[s\].
pub const PEAK_ACCELERATION_TIME: f64 = 1.844;

/// Time at which the study states its twist \[s\].
pub const TWIST_TIME: f64 = 1.8;

/// The shaft of the saw cylinder with the load spread over its discs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrintedShaft {
    /// Moment of inertia J of the whole cylinder \[kg m^2\].
    pub inertia: f64,
    /// Length l \[m\].
    pub length: f64,
    /// Shear modulus G \[Pa\].
    pub shear_modulus: f64,
    /// Polar moment I \[m^4\].
    pub polar_moment: f64,
    /// Radius R of the saw discs \[m\].
    pub disc_radius: f64,
    /// Working arc of the discs \[rad\].
    pub arc: f64,
    /// Mean load Mm \[N m\].
    pub load_mean: f64,
    /// Amplitude M0 of the load \[N m\].
    pub load_amplitude: f64,
    /// Nominal speed w2 \[rad/s\].
    pub nominal_speed: f64,
}

/// The shaft with the printed numbers.
pub const SAW_GIN_SHAFT: PrintedShaft = PrintedShaft {
    inertia: 1.244,
    length: 2.322,
    shear_modulus: 8e10,
    polar_moment: 9.817e-6,
    disc_radius: 0.16,
    arc: PI / 3.0,
    load_mean: 843.72,
    load_amplitude: 78.78,
    nominal_speed: PI * 735.0 / 30.0,
};

/// Evaluation of the printed formulas.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reading {
    /// As printed: rho = J/l, complete load terms.
    AsPrinted,
    /// Evaluation that gives the printed figures: rho = J, load terms halved.
    OfTheFigures,
}

impl PrintedShaft {
    /// Relative twist phi_x at time t \[s\] and place x \[m\], formula (14) \[rad/m\].
    #[must_use]
    pub fn slope(&self, t: f64, x: f64, reading: Reading) -> f64 {
        let [inertia, load] = self.terms(t, reading);
        (inertia * x - load * x * x / 2.0) / self.rigidity()
    }

    /// Angle of twist phi at time t \[s\] and place x \[m\], formula (15) \[rad\].
    #[must_use]
    pub fn angle(&self, t: f64, x: f64, reading: Reading) -> f64 {
        let [inertia, load] = self.terms(t, reading);
        (inertia * x * x / 2.0 - load * x.powi(3) / 6.0) / self.rigidity()
    }

    /// Largest size of the slope over the whole length from t = 0 to `until`
    /// \[rad/m\], and when, on a grid of the given number of steps.
    ///
    /// For each time the slope is a parabola in x from 0 at x = 0, so it is largest
    /// at the far end or at its vertex, if that lies on the shaft.
    #[must_use]
    pub fn largest_slope(&self, until: f64, steps: u32, reading: Reading) -> (f64, f64) {
        let mut largest = (0.0, 0.0);
        for step in 0..=steps {
            let t = until * f64::from(step) / f64::from(steps);
            let [inertia, load] = self.terms(t, reading);
            let vertex = (inertia / load).clamp(0.0, self.length);
            for x in [vertex, self.length] {
                let size = self.slope(t, x, reading).abs();
                if size > largest.0 {
                    largest = (size, t);
                }
            }
        }
        largest
    }

    /// Torque to which the printed density q x of the mean load integrates,
    /// Mm l/(2 R arc) \[N m\]; it should be Mm.
    #[must_use]
    pub fn load_density_integral(&self) -> f64 {
        self.load_mean * self.length / (2.0 * self.disc_radius * self.arc)
    }

    /// Returns rho phi_tt \[N m/m\] and q \[N m/m^2\] of the formulas in a reading.
    fn terms(&self, t: f64, reading: Reading) -> [f64; 2] {
        let load = (self.load_mean + self.load_amplitude * (PI * self.nominal_speed * t).cos())
            / (self.disc_radius * self.arc * self.length);
        match reading {
            Reading::AsPrinted => [self.inertia / self.length * acceleration(t), load],
            Reading::OfTheFigures => [self.inertia * acceleration(t), load / 2.0],
        }
    }

    /// Torsional rigidity G I \[N m^2\].
    #[must_use]
    pub fn rigidity(&self) -> f64 {
        self.shear_modulus * self.polar_moment
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHAFT: PrintedShaft = SAW_GIN_SHAFT;

    fn assert_close(ours: f64, reference: f64, tolerance: f64) {
        assert!((ours - reference).abs() <= tolerance, "{ours} against {reference}");
    }

    #[test]
    fn printed_law_gives_the_published_acceleration() {
        assert_close(acceleration(PEAK_ACCELERATION_TIME), 8743.54, 5e-3);
    }

    #[test]
    fn density_taken_as_the_whole_inertia_and_half_the_load_give_the_figures() {
        let slope = SHAFT.slope(TWIST_TIME, SHAFT.length, Reading::OfTheFigures).to_degrees();
        assert_close(slope.abs(), 1.892, 5e-4);
        assert_close((slope * SHAFT.length).abs(), 4.39, 5e-3);
        assert_close(1.892 * SHAFT.length, 4.393, 5e-4);
        let (largest, at) = SHAFT.largest_slope(TWIST_TIME, 18_000, Reading::OfTheFigures);
        assert_close(largest.to_degrees(), slope.abs(), 1e-12);
        assert_close(at, TWIST_TIME, 1e-12);
    }

    #[test]
    fn formula_as_printed_stays_below_the_figures() {
        let (largest, _) = SHAFT.largest_slope(TWIST_TIME, 18_000, Reading::AsPrinted);
        assert!(largest.to_degrees() < 1.15 && largest.to_degrees() > 1.14);
        let angle = SHAFT.angle(TWIST_TIME, SHAFT.length, Reading::AsPrinted).to_degrees();
        assert_close(angle, -1.1664, 5e-5);
    }

    #[test]
    fn angle_is_the_integral_of_the_slope() {
        for reading in [Reading::AsPrinted, Reading::OfTheFigures] {
            // Simpson's rule is exact for the parabola.
            let x = 1.7;
            let at = |x| SHAFT.slope(1.1, x, reading);
            let integral = x / 6.0 * (at(0.0) + 4.0 * at(x / 2.0) + at(x));
            assert_close(SHAFT.angle(1.1, x, reading), integral, 1e-16);
        }
    }

    #[test]
    fn printed_formulas_satisfy_the_printed_equation() {
        // G I phi_xx = rho phi_tt - q x by a central difference, exact for a parabola.
        let (t, x, h) = (0.9, 1.3, 0.1);
        let at = |x| SHAFT.slope(t, x, Reading::AsPrinted);
        let curvature = (at(x + h) - at(x - h)) / (2.0 * h);
        let q = (843.72 + 78.78 * (PI * PI * 24.5 * t).cos()) / (0.16 * PI / 3.0 * 2.322);
        let expected = (1.244 / 2.322 * acceleration(t) - q * x) / 785_360.0;
        assert_close(curvature, expected, 1e-15);
    }

    #[test]
    fn printed_load_density_is_not_balanced() {
        assert_close(SHAFT.load_density_integral(), 5845.0, 2.0);
    }
}
