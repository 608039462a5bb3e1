//! The reed's shaft from rest under the drive U sin(w t), as a series of its eigenmodes.
//!
//! Every mode phi_k, 1 at the drive, with the mass m_k = int phi_k^2 dxi + alpha ur_k^2,
//! obeys eta'' + s^2 eta = U sin(w tau)/m_k. The parts in sin(w tau) add up to the steady
//! answer, which is known without a series; what is left is
//!
//! ```text
//! u = A(x) sin(w tau) - sum over k of U w/(m_k s_k (s_k^2 - w^2)) phi_k(x) sin(s_k tau)
//! ```

use std::f64::consts::PI;

use super::{DrivenReed, Reed, ReedShaft};

/// Motion from rest, as a finite series.
#[derive(Debug, Clone, PartialEq)]
pub struct ReedTransient {
    steady: DrivenReed,
    amplitude: f64,
    modes: Vec<Mode>,
}

/// s_k and the factors of sin(s_k tau): at the reed's place the angle, both slopes, and
/// the angle of the reed.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Mode {
    frequency: f64,
    angle: f64,
    slopes: [f64; 2],
    reed: f64,
}

/// Motion and stresses at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReedMotion {
    /// u at the reed's place \[rad\].
    pub shaft_angle: f64,
    /// Angle of the reed \[rad\].
    pub reed_angle: f64,
    /// Stress at the shaft's surface, before the reed and beyond it \[Pa\].
    pub stress: [f64; 2],
}

impl ReedTransient {
    /// Creates the series for a start from rest at t = 0, u0 = U sin(w t), w \[rad/s\]; there are
    /// at least three eigenmodes, none of them at the drive's frequency.
    #[must_use]
    pub fn new(
        shaft: &ReedShaft,
        [amplitude, frequency]: [f64; 2],
        reed: Reed,
        modes: u32,
    ) -> Self {
        let steady = shaft.harmonic_response(amplitude, frequency, reed);
        let w = frequency * shaft.time_scale();
        let mode = |k: u32| {
            let s = shaft.frequency(k, reed);
            let factor = -amplitude * w / (shaft.mode_mass(s, reed) * s * (s * s - w * w));
            let support = shaft.support(s, reed);
            let [angle, slope] = shaft.segments(shaft.reed_place(), s, [1.0, 1.0], support);
            let slopes = [slope, slope + support * angle].map(|slope| factor * slope);
            let reed = factor * shaft.mode_reed(s, reed);
            Mode { frequency: s, angle: factor * angle, slopes, reed }
        };
        Self { steady, amplitude, modes: (1..=modes).map(mode).collect() }
    }

    /// Returns the motion at t \[s\].
    #[must_use]
    pub fn at(&self, t: f64) -> ReedMotion {
        let shaft = &self.steady.shaft;
        let tau = t / shaft.time_scale();
        let forced = (self.steady.frequency * tau).sin();
        let mut shaft_angle = forced * self.steady.angle(shaft.reed_position);
        let mut reed_angle = forced * self.steady.reed_angle();
        let mut stress = self.steady.stress_beside_reed().map(|stress| forced * stress);
        for mode in &self.modes {
            let free = (mode.frequency * tau).sin();
            shaft_angle += free * mode.angle;
            reed_angle += free * mode.reed;
            for (stress, slope) in stress.iter_mut().zip(mode.slopes) {
                *stress += free * self.steady.stress_of(slope);
            }
        }
        ReedMotion { shaft_angle, reed_angle, stress }
    }

    /// Returns bounds of the remainder of the series in the shaft's angle \[rad\] and in the stress
    /// before the reed \[Pa\].
    ///
    /// Between drive and reed |phi_k| <= (1 + 1/s^2)^(1/2) and
    /// m_k >= (1 + 1/s^2) (xi0 - 1/s)/2, so that |phi_k|/m_k <= 2/(xi0 - 1/s), and
    /// |phi_k'| <= s |phi_k| likewise; the frequency equation gives
    /// s_k >= (k - 2) pi/xi1, and sums over k are below their integrals.
    #[must_use]
    pub fn tail_bound(&self) -> [f64; 2] {
        let shaft = &self.steady.shaft;
        let (count, w) = (self.modes.len() as f64 - 2.0, self.steady.frequency);
        let spacing = PI / shaft.end_place();
        let first = count * spacing;
        let factor = 2.0 * self.amplitude * w
            / (shaft.reed_place() - 1.0 / first)
            / (1.0 - (w / first).powi(2));
        let angle = factor / (2.0 * count * count * spacing.powi(3));
        let slope = factor / (count * spacing * spacing);
        [angle, self.steady.stress_of(slope)]
    }
}

impl ReedShaft {
    /// int phi^2 dxi + alpha ur^2 of the mode of frequency s.
    ///
    /// With phi = A cos s xi + B sin s xi on a segment of length d the integral is
    /// (A^2 + B^2) d/2 + (A^2 - B^2) sin(2 s d)/(4 s) + A B sin^2(s d)/s.
    #[must_use]
    pub fn mode_mass(&self, s: f64, reed: Reed) -> f64 {
        let integral = |[angle, slope]: [f64; 2], d: f64| {
            let (a, b) = (angle, slope / s);
            (a * a + b * b) * d / 2.0
                + (a * a - b * b) * (2.0 * s * d).sin() / (4.0 * s)
                + a * b * (s * d).sin().powi(2) / s
        };
        let support = self.support(s, reed);
        let place = self.reed_place();
        let [angle, slope] = self.segments(place, s, [1.0, 1.0], support);
        let beyond = [angle, slope + support * angle];
        let own = self.mode_reed(s, reed);
        integral([1.0, 1.0], place)
            + integral(beyond, self.end_place() - place)
            + self.alpha() * own * own
    }
}

#[cfg(test)]
mod tests {
    use super::super::REED_STUDY;
    use super::*;

    fn driven(modes: u32) -> ReedTransient {
        let drive = [REED_STUDY.drive_amplitude(), REED_STUDY.drive_frequency()];
        ReedTransient::new(&REED_STUDY, drive, Reed::Free, modes)
    }

    #[test]
    fn the_motion_starts_at_rest_and_nothing_is_felt_before_the_wave_arrives() {
        let transient = driven(2000);
        let arrival = REED_STUDY.reed_place() * REED_STUDY.time_scale();
        for share in [0.0, 0.3, 0.9] {
            let motion = transient.at(share * arrival);
            assert!(motion.shaft_angle.abs() < 1e-8, "{motion:?}");
            assert!(motion.reed_angle.abs() < 1e-8, "{motion:?}");
            assert!(motion.stress[0].abs() < transient.tail_bound()[1], "{motion:?}");
        }
        assert!(transient.at(1.5 * arrival).shaft_angle > 1e-4);
    }

    #[test]
    fn what_is_left_out_stays_within_its_bound() {
        let (short, long) = (driven(50), driven(2000));
        let [angle, stress] = short.tail_bound();
        let mut largest = [0.0, 0.0];
        for step in 0..200 {
            let t = 5e-5 * f64::from(step);
            let (a, b) = (short.at(t), long.at(t));
            largest[0] = f64::max(largest[0], (a.shaft_angle - b.shaft_angle).abs());
            largest[1] = f64::max(largest[1], (a.stress[0] - b.stress[0]).abs());
        }
        assert!(largest[0] <= angle && largest[0] > 1e-3 * angle, "{} {angle}", largest[0]);
        assert!(largest[1] <= stress && largest[1] > 1e-3 * stress, "{} {stress}", largest[1]);
    }
}
