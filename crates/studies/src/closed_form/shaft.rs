//! A uniform shaft in torsion.
//!
//! ```text
//! rho phi_tt = (G I phi_x)_x + Q        0 <= x <= l        c = sqrt(G I/rho)
//! torque in a section: G I phi_x
//! ```
//!
//! Fixed means phi(0) = 0. At a free end the torque is zero. A rotor J at an end has
//! G I phi_x = -J phi_tt at x = l and +J phi_tt at x = 0. Every solution is a sum of waves of speed
//! c, so everything below is exact.
//!
//! Source: saw-gin study (2020), distributed shaft with balanced loads; solutions by
//! hand.

use std::f64::consts::PI;

use super::roots::turning_point;
use super::two_mass::damped_pair;

/// A uniform shaft; all positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaft {
    /// G I \[N m^2\], I the polar moment of the section.
    pub stiffness: f64,
    /// rho, moment of inertia per length \[kg m\].
    pub density: f64,
    /// l \[m\].
    pub length: f64,
}

/// Shaft of the saw gin with the inertia of the saw cylinder distributed along it: G = 8e10 Pa,
/// I = 9.817e-6 m^4, J = 1.244 kg m^2, l = 2.322 m.
pub const SAW_GIN_SHAFT: Shaft =
    Shaft { stiffness: 8e10 * 9.817e-6, density: 1.244 / 2.322, length: 2.322 };

/// Distribution of a torque M along the shaft; both integrate to M.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadDensity {
    /// M/l.
    Uniform,
    /// 2 M x/l^2.
    Linear,
}

/// The other end of a shaft that is free at x = l.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Support {
    /// phi(0) = 0.
    Fixed,
    /// phi_x(0) = 0.
    Free,
}

/// Rotation, speed and torque at one place and time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    /// phi \[rad\].
    pub angle: f64,
    /// phi_t \[rad/s\].
    pub speed: f64,
    /// G I phi_x \[N m\].
    pub torque: f64,
}

impl Shaft {
    /// c = sqrt(G I/rho) \[m/s\].
    #[must_use]
    pub fn wave_speed(&self) -> f64 {
        (self.stiffness / self.density).sqrt()
    }

    /// rho l \[kg m^2\].
    #[must_use]
    pub fn inertia(&self) -> f64 {
        self.density * self.length
    }

    /// (2 k - 1) pi c/(2 l) \[rad/s\], fixed at one end, free at the other, k from 1.
    #[must_use]
    pub fn fixed_free_frequency(&self, k: u32) -> f64 {
        self.frequency((f64::from(k) - 0.5) * PI)
    }

    /// k pi c/l \[rad/s\], free at both ends; k = 0 is the rigid rotation.
    #[must_use]
    pub fn free_free_frequency(&self, k: u32) -> f64 {
        self.frequency(f64::from(k) * PI)
    }

    /// k-th frequency \[rad/s\], k from 1, fixed at x = 0, with a rotor \[kg m^2\] at
    /// x = l: w = s c/l with m = rotor/(rho l) and
    ///
    /// ```text
    /// m s tan s = 1        (k - 1) pi < s <= (k - 1/2) pi
    /// ```
    #[must_use]
    pub fn fixed_rotor_frequency(&self, k: u32, rotor: f64) -> f64 {
        let (m, before) = (rotor / self.inertia(), f64::from(k) - 1.0);
        let sign = alternating(k);
        let root = turning_point(before * PI, (before + 0.5) * PI, |s| {
            sign * (s.cos() - m * s * s.sin()) > 0.0
        });
        self.frequency(root)
    }

    /// k-th frequency \[rad/s\], k from 1 and without the rigid rotation, with rotors
    /// \[kg m^2\] at both ends: w = s c/l with m_i = rotor_i/(rho l) and
    ///
    /// ```text
    /// (m_0 + m_1) s cos s + (1 - m_0 m_1 s^2) sin s = 0     (k - 1) pi < s <= k pi
    /// ```
    ///
    /// Divided by sin s, the left side falls from positive to negative in each of these intervals,
    /// so each has one root.
    #[must_use]
    pub fn rotor_ended_frequency(&self, k: u32, rotors: [f64; 2]) -> f64 {
        let [first, last] = rotors.map(|rotor| rotor / self.inertia());
        let before = f64::from(k) - 1.0;
        let sign = alternating(k);
        let root = turning_point(before * PI, (before + 1.0) * PI, |s| {
            let (sin, cos) = s.sin_cos();
            sign * ((first + last) * s * cos + (1.0 - first * last * s * s) * sin) > 0.0
        });
        self.frequency(root)
    }

    /// Angle \[rad\] at x of the shaft fixed at 0 under a torque M at l: M x/(G I).
    #[must_use]
    pub fn static_twist(&self, x: f64, torque: f64) -> f64 {
        torque * x / self.stiffness
    }

    /// Angle \[rad\] at x of the shaft fixed at 0 under a torque M distributed along it:
    /// M (x - x^2/(2 l))/(G I) and M (x - x^3/(3 l^2))/(G I).
    #[must_use]
    pub fn static_twist_under(&self, x: f64, torque: f64, density: LoadDensity) -> f64 {
        let share = x / self.length;
        let fill = match density {
            LoadDensity::Uniform => 1.0 - share / 2.0,
            LoadDensity::Linear => 1.0 - share * share / 3.0,
        };
        torque * x * fill / self.stiffness
    }

    /// The shaft fixed at 0, at rest until a torque M acts at l from t = 0 on: waves from the end,
    /// reflected at both ends (d'Alembert),
    ///
    /// ```text
    /// phi = (c M/(G I)) sum over n of (-1)^n [r(t - ((2n+1) l - x)/c) - r(t - ((2n+1) l + x)/c)]
    /// ```
    ///
    /// with r(u) = u for u > 0, else 0. It is periodic with 4 l/c: the rotation of the end is a
    /// triangle wave between 0 and 2 M l/(G I), and the torque at the wall a square wave between 0
    /// and 2 M.
    #[must_use]
    pub fn step_torque(&self, x: f64, t: f64, torque: f64) -> Wave {
        let c = self.wave_speed();
        let t = t.max(0.0) % (4.0 * self.length / c);
        let mut wave = Wave { angle: 0.0, speed: 0.0, torque: 0.0 };
        for n in 0..2 {
            let sign = if n == 0 { 1.0 } else { -1.0 };
            let path = f64::from(2 * n + 1) * self.length;
            let toward = t - (path - x) / c;
            let away = t - (path + x) / c;
            for (since, reflected) in [(toward, 1.0), (away, -1.0)] {
                if since > 0.0 {
                    wave.angle += sign * reflected * since * c * torque / self.stiffness;
                    wave.speed += sign * reflected * c * torque / self.stiffness;
                    wave.torque += sign * torque;
                }
            }
        }
        wave
    }

    /// Amplitude \[rad\] at x of the steady-state response to the torque M sin(w t) at l. It is in
    /// phase with the torque, or in antiphase if negative:
    ///
    /// ```text
    /// fixed at 0:  (M c/(G I w)) sin(w x/c)/cos(w l/c)
    /// free at 0:  -(M c/(G I w)) cos(w x/c)/sin(w l/c)
    /// ```
    #[must_use]
    pub fn harmonic_twist(&self, x: f64, torque: f64, frequency: f64, support: Support) -> f64 {
        let wave_number = frequency / self.wave_speed();
        let size = torque / (self.stiffness * wave_number);
        let (at, end) = (wave_number * x, wave_number * self.length);
        match support {
            Support::Fixed => size * at.sin() / end.cos(),
            Support::Free => -size * at.cos() / end.sin(),
        }
    }

    /// Amplitude \[N m\] of the torque at x in that response: M cos(w x/c)/cos(w l/c) fixed at 0,
    /// M sin(w x/c)/sin(w l/c) free.
    #[must_use]
    pub fn harmonic_torque(&self, x: f64, torque: f64, frequency: f64, support: Support) -> f64 {
        let wave_number = frequency / self.wave_speed();
        let (at, end) = (wave_number * x, wave_number * self.length);
        match support {
            Support::Fixed => torque * at.cos() / end.cos(),
            Support::Free => torque * at.sin() / end.sin(),
        }
    }

    fn frequency(&self, root: f64) -> f64 {
        root * self.wave_speed() / self.length
    }
}

/// Damping ratio d w/2 of an eigenmode with Kelvin-Voigt damping, where the torque in a section is
/// G I (phi_x + d phi_xt), for a frequency \[rad/s\] and a damping time d \[s\].
#[must_use]
pub fn kelvin_voigt_ratio(frequency: f64, damping_time: f64) -> f64 {
    damping_time * frequency / 2.0
}

/// Returns the value at time t \[s\] of an eigenmode released at 1: q'' + d w^2 q' + w^2 q = 0,
/// q(0) = 1, q'(0) = 0. Above a damping ratio of 1 it does not oscillate.
#[must_use]
pub fn kelvin_voigt_decay(t: f64, frequency: f64, damping_time: f64) -> f64 {
    let square = frequency * frequency;
    let decay = damping_time * square / 2.0;
    let (even, odd) = damped_pair(t, decay, square);
    even + decay * odd
}

/// 1, -1, 1, ... for k = 1, 2, 3, ...
fn alternating(k: u32) -> f64 {
    if k % 2 == 1 { 1.0 } else { -1.0 }
}

#[cfg(test)]
#[path = "shaft_tests.rs"]
mod tests;
