//! A driven shaft with a reed on a spring: half of the beat-up mechanism of a loom.
//!
//! ```text
//! T = int rho Jp u_t^2/2 dx + Ir ur_t^2/2                    0 <= x <= l
//! V = int G Jp u_x^2/2 dx + C0 (u(0) - u0)^2/2 + C1 (u(l0) - ur)^2/2 + C2 ur^2/2
//! ```
//!
//! x = 0 is driven through the spring C0 by the prescribed angle u0. x = l is the middle of a
//! symmetric shaft (u_x = 0). The reed ur is attached by the spring C1 at x = l0, and C2 is the
//! cloth fell, here always in contact. With the length L = G Jp/C0 and the time T = L sqrt(rho/G),
//! beta = C1/C0, alpha = Ir/(T^2 C0), b2 = C2/C0:
//!
//! ```text
//! u_tautau = u_xixi - (u - u0) delta(xi) - beta (u - ur) delta(xi - xi0)
//! alpha ur_tautau = beta (u - ur) - b2 ur
//! ```
//!
//! A motion of frequency s has ur = beta u(xi0)/(beta + b2 - alpha s^2). The reed acts on the shaft
//! as a spring of stiffness
//!
//! ```text
//! held: beta        free: beta (b2 - alpha s^2)/(beta + b2 - alpha s^2)
//! ```
//!
//! in units of C0, called `support` below.
//!
//! Source: reed study, in its consistent reading (reference to symmetry, xi0 where
//! equation (15) prints xi1); solutions by hand.

#[path = "reed_transient.rs"]
mod transient;

use std::f64::consts::PI;

use super::roots::turning_point;
pub use transient::{ReedMotion, ReedTransient};

/// Dimensions and stiffnesses of shaft and reed; all positive except `contact_stiffness`, which may
/// be 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReedShaft {
    /// l, half of the shaft \[m\].
    pub length: f64,
    /// R \[m\].
    pub radius: f64,
    /// rho \[kg/m^3\].
    pub density: f64,
    /// E \[Pa\].
    pub youngs_modulus: f64,
    /// nu.
    pub poisson_ratio: f64,
    /// C0 \[N m/rad\].
    pub drive_stiffness: f64,
    /// C1 \[N m/rad\].
    pub reed_stiffness: f64,
    /// C2 \[N m/rad\].
    pub contact_stiffness: f64,
    /// l0 \[m\], below l.
    pub reed_position: f64,
    /// M \[kg\].
    pub reed_mass: f64,
    /// Lever arm of the reed's mass \[m\]; the study takes the radius of the shaft.
    pub reed_arm: f64,
}

/// The mechanism of the study, without contact.
pub const REED_STUDY: ReedShaft = ReedShaft {
    length: 1.75,
    radius: 0.025,
    density: 7659.0,
    youngs_modulus: 2e11,
    poisson_ratio: 0.3,
    drive_stiffness: 45_200.0,
    reed_stiffness: 15_600.0,
    contact_stiffness: 0.0,
    reed_position: 1.0,
    reed_mass: 3.56,
    reed_arm: 0.025,
};

/// Speed v0 \[rad/s\] of the study's drive law u0 = (v0 T tau0/pi) sin(pi tau/tau0).
pub const DRIVE_SPEED: f64 = 30.0;
/// Its half period tau0, in units of T.
pub const DRIVE_HALF_PERIOD: f64 = 80.0;

/// Constraint of the reed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reed {
    /// ur = 0.
    Held,
    /// The reed moves.
    Free,
}

/// Steady-state response to u0 = U sin(w t): everything is in phase with the drive, or in antiphase
/// if negative.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrivenReed {
    shaft: ReedShaft,
    /// Frequency s in 1/T.
    frequency: f64,
    /// u at x = 0 and its slope u_xi there, for the amplitude U of the drive.
    start: [f64; 2],
    support: f64,
    reed: f64,
}

impl ReedShaft {
    /// G = E/(2 (1 + nu)) \[Pa\].
    #[must_use]
    pub fn shear_modulus(&self) -> f64 {
        self.youngs_modulus / (2.0 * (1.0 + self.poisson_ratio))
    }

    /// Jp = pi R^4/2 \[m^4\].
    #[must_use]
    pub fn polar_moment(&self) -> f64 {
        PI * self.radius.powi(4) / 2.0
    }

    /// Ir = M arm^2 \[kg m^2\].
    #[must_use]
    pub fn reed_inertia(&self) -> f64 {
        self.reed_mass * self.reed_arm * self.reed_arm
    }

    /// L = G Jp/C0 \[m\].
    #[must_use]
    pub fn length_scale(&self) -> f64 {
        self.shear_modulus() * self.polar_moment() / self.drive_stiffness
    }

    /// T = L sqrt(rho/G) \[s\].
    #[must_use]
    pub fn time_scale(&self) -> f64 {
        self.length_scale() * (self.density / self.shear_modulus()).sqrt()
    }

    /// beta = C1/C0.
    #[must_use]
    pub fn beta(&self) -> f64 {
        self.reed_stiffness / self.drive_stiffness
    }

    /// alpha = Ir/(T^2 C0).
    #[must_use]
    pub fn alpha(&self) -> f64 {
        self.reed_inertia() / (self.time_scale().powi(2) * self.drive_stiffness)
    }

    /// b2 = C2/C0.
    #[must_use]
    pub fn contact(&self) -> f64 {
        self.contact_stiffness / self.drive_stiffness
    }

    /// xi0 = l0/L.
    #[must_use]
    pub fn reed_place(&self) -> f64 {
        self.reed_position / self.length_scale()
    }

    /// xi1 = l/L.
    #[must_use]
    pub fn end_place(&self) -> f64 {
        self.length / self.length_scale()
    }

    /// Amplitude of the study's drive, v0 T tau0/pi \[rad\].
    #[must_use]
    pub fn drive_amplitude(&self) -> f64 {
        DRIVE_SPEED * self.time_scale() * DRIVE_HALF_PERIOD / PI
    }

    /// Angular frequency of the study's drive, pi/(tau0 T) \[rad/s\].
    #[must_use]
    pub fn drive_frequency(&self) -> f64 {
        PI / (DRIVE_HALF_PERIOD * self.time_scale())
    }

    /// Stiffness of the reed acting on the shaft, in units of C0, at frequency s. It is infinite at
    /// s^2 = (beta + b2)/alpha, the frequency of the reed alone.
    #[must_use]
    pub fn support(&self, s: f64, reed: Reed) -> f64 {
        let (beta, contact) = (self.beta(), self.contact());
        let inertia = self.alpha() * s * s;
        match reed {
            Reed::Held => beta,
            Reed::Free => beta * (contact - inertia) / (beta + contact - inertia),
        }
    }

    /// The frequency equation, zero at frequencies s in 1/T:
    ///
    /// ```text
    /// support (s cos s xi0 + sin s xi0) cos s(xi1 - xi0) - s (s sin s xi1 - cos s xi1)
    /// ```
    #[must_use]
    pub fn frequency_equation(&self, s: f64, reed: Reed) -> f64 {
        self.equation(s, self.reed_place(), self.support(s, reed))
    }

    /// Equation (15) as the study prints it, with xi1 instead of xi0 in the first bracket, for a
    /// held reed.
    #[must_use]
    pub fn printed_frequency_equation(&self, s: f64) -> f64 {
        self.equation(s, self.end_place(), self.beta())
    }

    fn equation(&self, s: f64, first_bracket: f64, support: f64) -> f64 {
        let (place, end) = (self.reed_place(), self.end_place());
        let (sin, cos) = (s * first_bracket).sin_cos();
        support * (s * cos + sin) * (s * (end - place)).cos()
            - s * (s * (s * end).sin() - (s * end).cos())
    }

    /// The study's own scales, as it prints them: xi/x, tau/t and alpha. For consistent dimensions,
    /// xi/x would be 1/L in 1/m, tau/t 1/T in 1/s, and alpha dimensionless. As printed, xi/x is
    /// dimensionless, tau/t is in m/s and alpha in 1/m.
    #[must_use]
    pub fn printed_scales(&self) -> [f64; 3] {
        let stiffness = self.drive_stiffness * self.radius * self.radius;
        let section = self.polar_moment() * self.length;
        [
            (stiffness / (self.shear_modulus() * section)).sqrt(),
            (stiffness / (self.density * section)).sqrt(),
            self.reed_mass * self.radius / (self.density * section),
        ]
    }

    /// k-th frequency s in 1/T, k from 1; s/T is in rad/s.
    ///
    /// The angle theta of (u, u_xi/s) grows by s times the length along the shaft. It starts at
    /// atan s (spring C0), and at the reed it drops to where its cotangent is larger by support/s.
    /// The end has u_xi = 0 where theta is (k - 1/2) pi. Above the frequency of the reed alone, the
    /// reed adds half a turn for its own motion. The count of such crossings grows with s, so
    /// bisection on it finds each root and misses none.
    #[must_use]
    pub fn frequency(&self, k: u32, reed: Reed) -> f64 {
        let wanted = (f64::from(k) - 0.5) * PI;
        // Each root is below that of the shaft with the reed's end cut off and held.
        let highest = (f64::from(k) + 1.0) * PI / self.end_place() + self.reed_alone() + 1.0;
        turning_point(0.0, highest, |s| self.end_angle(s, reed) < wanted)
    }

    /// Frequency of the reed alone on its springs, sqrt((beta + b2)/alpha).
    fn reed_alone(&self) -> f64 {
        ((self.beta() + self.contact()) / self.alpha()).sqrt()
    }

    fn end_angle(&self, s: f64, reed: Reed) -> f64 {
        let place = self.reed_place();
        let before = s.atan() + s * place;
        let turns = (before / PI).floor();
        let (sin, cos) = (before - turns * PI).sin_cos();
        // cot theta grows by support/s; the angle stays within its half turn.
        let after = turns * PI + sin.atan2(cos + self.support(s, reed) / s * sin);
        let own = if reed == Reed::Free && s > self.reed_alone() { PI } else { 0.0 };
        after + own + s * (self.end_place() - place)
    }

    /// Returns the requested number of roots of the printed equation, ascending: its changes of
    /// sign on a grid of a thousandth of pi/xi1.
    #[must_use]
    pub fn printed_frequencies(&self, count: usize) -> Vec<f64> {
        let step = PI / (1000.0 * self.end_place());
        let value = |s: f64| self.printed_frequency_equation(s);
        if !(step.is_finite() && step > 0.0) {
            return vec![f64::NAN; count];
        }
        let crossing = |index: u64| {
            let (low, high) = (step * index as f64, step * (index + 1) as f64);
            let is_positive = value(low) > 0.0;
            (is_positive != (value(high) > 0.0))
                .then(|| turning_point(low, high, |s| (value(s) > 0.0) == is_positive))
        };
        // A root lies in about every thousandth step.
        (1..10_000 * (count as u64 + 1)).filter_map(crossing).take(count).collect()
    }

    /// Mode shape u at xi for frequency s, 1 at xi = 0: cos s xi + sin(s xi)/s, and beyond the reed
    /// additionally support u(xi0) sin s(xi - xi0)/s. Mode shapes of two frequencies are
    /// orthogonal: the integral of u_i u_j, plus alpha ur_i ur_j for a free reed, is zero.
    #[must_use]
    pub fn mode_shape(&self, xi: f64, s: f64, reed: Reed) -> f64 {
        self.segments(xi, s, [1.0, 1.0], self.support(s, reed))[0]
    }

    /// Angle of the reed in that mode shape, beta u(xi0)/(beta + b2 - alpha s^2); 0 if held.
    #[must_use]
    pub fn mode_reed(&self, s: f64, reed: Reed) -> f64 {
        let at = self.mode_shape(self.reed_place(), s, reed);
        self.reed_angle(at, s, reed)
    }

    fn reed_angle(&self, at: f64, s: f64, reed: Reed) -> f64 {
        let beta = self.beta();
        match reed {
            Reed::Held => 0.0,
            Reed::Free => beta * at / (beta + self.contact() - self.alpha() * s * s),
        }
    }

    /// u and u_xi at xi from their values at 0, by two trigonometric segments.
    fn segments(&self, xi: f64, s: f64, [angle, slope]: [f64; 2], support: f64) -> [f64; 2] {
        let along = |length: f64, [angle, slope]: [f64; 2]| {
            let (sin, cos) = (s * length).sin_cos();
            [angle * cos + slope * sin / s, slope * cos - s * angle * sin]
        };
        let place = self.reed_place();
        if xi <= place {
            return along(xi, [angle, slope]);
        }
        let [angle, slope] = along(place, [angle, slope]);
        along(xi - place, [angle, slope + support * angle])
    }

    /// Steady-state response to u0 = U sin(w t), w \[rad/s\] above 0, U \[rad\].
    ///
    /// u_xi(0) = u(0) - U at the drive; u is continuous at the reed and u_xi jumps by
    /// support u(xi0); u_xi(xi1) = 0 leaves one linear equation for u(0).
    #[must_use]
    pub fn harmonic_response(&self, amplitude: f64, frequency: f64, reed: Reed) -> DrivenReed {
        let s = frequency * self.time_scale();
        let support = self.support(s, reed);
        let end = self.end_place();
        let [_, of_angle] = self.segments(end, s, [1.0, 1.0], support);
        let [_, of_drive] = self.segments(end, s, [0.0, -1.0], support);
        let angle = -amplitude * of_drive / of_angle;
        let start = [angle, angle - amplitude];
        let [at, _] = self.segments(self.reed_place(), s, start, support);
        let reed = self.reed_angle(at, s, reed);
        DrivenReed { shaft: *self, frequency: s, start, support, reed }
    }
}

impl DrivenReed {
    /// Amplitude of u at x \[rad\].
    #[must_use]
    pub fn angle(&self, x: f64) -> f64 {
        self.at(x / self.shaft.length_scale())[0]
    }

    /// Amplitude of the reed's angle \[rad\].
    #[must_use]
    pub fn reed_angle(&self) -> f64 {
        self.reed
    }

    /// Amplitude of the shear stress G R u_x at the shaft's surface at x \[Pa\]; at the reed, the
    /// value on the side of the drive.
    #[must_use]
    pub fn stress(&self, x: f64) -> f64 {
        self.stress_of(self.at(x / self.shaft.length_scale())[1])
    }

    /// Stress \[Pa\] on both sides of the reed: towards the drive and away from it. They differ by
    /// R C1 (u - ur)/Jp.
    #[must_use]
    pub fn stress_beside_reed(&self) -> [f64; 2] {
        let [angle, slope] = self.at(self.shaft.reed_place());
        [slope, slope + self.support * angle].map(|slope| self.stress_of(slope))
    }

    fn at(&self, xi: f64) -> [f64; 2] {
        self.shaft.segments(xi, self.frequency, self.start, self.support)
    }

    fn stress_of(&self, slope: f64) -> f64 {
        self.shaft.shear_modulus() * self.shaft.radius * slope / self.shaft.length_scale()
    }
}

#[cfg(test)]
#[path = "reed_tests.rs"]
mod tests;
