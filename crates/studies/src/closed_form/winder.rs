//! Bobbin on a drum with a linear layer of yarn: transient and steady response to harmonics of
//! force and drum shape.
//!
//! ```text
//! m q'' + h (q' - Y') + c_p q + c (q - Y) = F(t)      (consistent)
//! m q'' + h q' + (c + c_p) q = F(t) + c Y(t)          (printed)
//! ```
//!
//! The response to a harmonic F = Re(F e^(j p t)) or Y = Re(Y e^(j p t)) is
//!
//! ```text
//! q = Re(F e^(j p t)/Z)    q = Re(Y (c + j h p) e^(j p t)/Z)    Z = c + c_p - m p^2 + j h p
//! ```
//!
//! and the complete motion is the sum of these and the free decay of the initial deviation. At
//! worst-case phases, amplitudes add up.
//!
//! Source: winder study; solution by hand.

use std::f64::consts::PI;

use num_complex::Complex64;

use super::two_mass::damped_pair;

/// Bobbin, layer and spring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BobbinOscillator {
    /// m, reduced mass \[kg\], positive.
    pub mass: f64,
    /// h, damping of the layer \[N s/m\], not negative.
    pub viscosity: f64,
    /// c, stiffness of the layer \[N/m\], positive.
    pub layer_stiffness: f64,
    /// c_p, spring of the holder \[N/m\], not negative.
    pub spring_stiffness: f64,
}

/// The bench winder, whose numbers are ours: the study gives no masses, stiffnesses or
/// dimensions.
pub const BENCH_BOBBIN: BobbinOscillator = BobbinOscillator {
    mass: 1.9,
    viscosity: 95.0,
    layer_stiffness: 42_000.0,
    spring_stiffness: 3800.0,
};

/// Force disturbance of the bench winder \[N\]; ours.
pub const BENCH_FORCE: Harmonic = Harmonic { amplitude: 25.0, frequency: 110.0, phase: 0.0 };

/// Drum-shape disturbance of the bench winder \[m\]; ours.
pub const BENCH_SHAPE: Harmonic = Harmonic { amplitude: 2e-4, frequency: 220.0, phase: 0.0 };

/// A harmonic, amplitude cos(frequency t + phase).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Harmonic {
    /// Amplitude, in the unit of the quantity.
    pub amplitude: f64,
    /// Angular frequency p \[rad/s\].
    pub frequency: f64,
    /// Phase at t = 0 \[rad\].
    pub phase: f64,
}

/// Deflection and velocity.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Deflection {
    /// q \[m\].
    pub value: f64,
    /// q' \[m/s\].
    pub rate: f64,
}

impl Harmonic {
    /// Value and rate at time t \[s\].
    #[must_use]
    pub fn at(&self, t: f64) -> Deflection {
        let (sine, cosine) = (self.frequency * t + self.phase).sin_cos();
        Deflection { value: self.amplitude * cosine, rate: -self.amplitude * self.frequency * sine }
    }
}

impl BobbinOscillator {
    /// Deflection at time t \[s\] after `start`, under harmonics of force and shape.
    #[must_use]
    pub fn motion(
        &self,
        t: f64,
        start: Deflection,
        forces: &[Harmonic],
        shapes: &[Harmonic],
    ) -> Deflection {
        let to_shapes = shapes.iter().map(|shape| self.answer_to_shape(shape));
        self.motion_of(t, start, forces, &to_shapes.collect::<Vec<_>>())
    }

    /// Computes the same by the study's equation of motion, whose forcing by the shape is c Y
    /// alone.
    #[must_use]
    pub fn motion_as_printed(
        &self,
        t: f64,
        start: Deflection,
        forces: &[Harmonic],
        shapes: &[Harmonic],
    ) -> Deflection {
        let to_shapes = shapes.iter().map(|shape| self.answer_to_shape_as_printed(shape));
        self.motion_of(t, start, forces, &to_shapes.collect::<Vec<_>>())
    }

    fn motion_of(
        &self,
        t: f64,
        start: Deflection,
        forces: &[Harmonic],
        to_shapes: &[Harmonic],
    ) -> Deflection {
        let answers = || {
            let to_forces = forces.iter().map(|force| self.answer_to_force(force));
            to_forces.chain(to_shapes.iter().copied())
        };
        let steady = |t| {
            answers().fold(Deflection::default(), |sum, answer| {
                let now = answer.at(t);
                Deflection { value: sum.value + now.value, rate: sum.rate + now.rate }
            })
        };
        let (first, now) = (steady(0.0), steady(t));
        let left = Deflection { value: start.value - first.value, rate: start.rate - first.rate };
        let free = self.free_decay(t, left);
        Deflection { value: now.value + free.value, rate: now.rate + free.rate }
    }

    /// Motion without disturbances, e^(-a t) (q_0 C + (q_0' + a q_0) S) with
    /// a = h/(2 m); see [`super::TwoMass::free_decay`].
    #[must_use]
    pub fn free_decay(&self, t: f64, start: Deflection) -> Deflection {
        let decay = self.viscosity / (2.0 * self.mass);
        let square = self.stiffness() / self.mass;
        let (c, s) = damped_pair(t, decay, square);
        Deflection {
            value: start.value * c + (start.rate + decay * start.value) * s,
            rate: start.rate * c - (decay * start.rate + square * start.value) * s,
        }
    }

    /// Steady deflection \[m\] under a harmonic force \[N\].
    #[must_use]
    pub fn answer_to_force(&self, force: &Harmonic) -> Harmonic {
        self.answer(Complex64::from(1.0), force)
    }

    /// Steady deflection \[m\] under a harmonic drum shape \[m\], including the layer's damping
    /// force from the rate of the shape.
    #[must_use]
    pub fn answer_to_shape(&self, shape: &Harmonic) -> Harmonic {
        let layer = Complex64::new(self.layer_stiffness, self.viscosity * shape.frequency);
        self.answer(layer, shape)
    }

    /// Computes the same by the study's equation of motion, with forcing c Y alone.
    #[must_use]
    pub fn answer_to_shape_as_printed(&self, shape: &Harmonic) -> Harmonic {
        self.answer(Complex64::from(self.layer_stiffness), shape)
    }

    /// The study's formula A/sqrt((c + c_p - m p^2)^2 + h^2 m^2 p^2) \[m\] for a forcing
    /// of modulus A \[N\]: the square of h m p belongs to a damping term h m q'.
    #[must_use]
    pub fn amplitude_as_printed(&self, forcing: f64, frequency: f64) -> f64 {
        let in_phase = self.stiffness() - self.mass * frequency * frequency;
        forcing / in_phase.hypot(self.viscosity * self.mass * frequency)
    }

    /// The study's phase (21) \[rad\], arctan(h m p/(c + c_p - m p^2)): h m instead of h, and the
    /// opposite sign of the lag of the motion behind its forcing.
    #[must_use]
    pub fn phase_as_printed(&self, frequency: f64) -> f64 {
        let in_phase = self.stiffness() - self.mass * frequency * frequency;
        (self.viscosity * self.mass * frequency / in_phase).atan()
    }

    /// Sum of the amplitudes \[m\]: an upper bound for all phases.
    #[must_use]
    pub fn amplitude_sum(&self, forces: &[Harmonic], shapes: &[Harmonic]) -> f64 {
        let to_forces = forces.iter().map(|force| self.answer_to_force(force).amplitude);
        let to_shapes = shapes.iter().map(|shape| self.answer_to_shape(shape).amplitude);
        to_forces.chain(to_shapes).sum()
    }

    /// Steady compression Y - q \[m\] of the layer under a harmonic drum shape \[m\]:
    /// Y (c_p - m p^2)/Z.
    #[must_use]
    pub fn compression_by_shape(&self, shape: &Harmonic) -> Harmonic {
        let rest = self.spring_stiffness - self.mass * shape.frequency * shape.frequency;
        self.answer(Complex64::from(rest), shape)
    }

    /// dN \[N\]: largest deviation of the pressure from that at rest at worst-case phases, the sum
    /// over harmonics of the amplitude of compression times |c + j h p|. With a vibrating drum, the
    /// compression determines the pressure; the amplitude of the bobbin alone would miss that of
    /// the drum.
    #[must_use]
    pub fn pressure_variation(&self, forces: &[Harmonic], shapes: &[Harmonic]) -> f64 {
        let pressed = |compression: Harmonic| {
            compression.amplitude.abs() * self.dynamic_layer_stiffness(compression.frequency)
        };
        let by_forces = forces.iter().map(|force| pressed(self.answer_to_force(force)));
        let by_shapes = shapes.iter().map(|shape| pressed(self.compression_by_shape(shape)));
        by_forces.chain(by_shapes).sum()
    }

    /// |c + j h p|, dynamic stiffness of the layer at a frequency \[N/m\].
    #[must_use]
    pub fn dynamic_layer_stiffness(&self, frequency: f64) -> f64 {
        self.layer_stiffness.hypot(self.viscosity * frequency)
    }

    /// sqrt((c + c_p)/m) \[rad/s\], undamped frequency.
    #[must_use]
    pub fn natural_frequency(&self) -> f64 {
        (self.stiffness() / self.mass).sqrt()
    }

    fn stiffness(&self) -> f64 {
        self.layer_stiffness + self.spring_stiffness
    }

    fn answer(&self, per_disturbance: Complex64, disturbance: &Harmonic) -> Harmonic {
        let p = disturbance.frequency;
        let impedance = Complex64::new(self.stiffness() - self.mass * p * p, self.viscosity * p);
        let answer = per_disturbance / impedance;
        Harmonic {
            amplitude: disturbance.amplitude * answer.norm(),
            frequency: p,
            phase: disturbance.phase + answer.arg(),
        }
    }
}

/// Mass of a bobbin holder reduced to the bobbin's centre \[kg\].
///
/// ```text
/// m(R) = m0 + mn (lbc/lab)^2 + pi (R^2 - Rmin^2) H rho      (consistent)
/// m(R) = m0 + mn lbc/lab     + pi (R^2 - Rmin^2) H rho      (printed)
/// ```
///
/// A mass on the arm lbc moves lbc/lab times as fast as the bobbin on the arm lab, so its kinetic
/// energy takes the square. Equation (16) reduces weights, which are linear in the arms; the study
/// takes its masses from there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReducedMass {
    /// m0 \[kg\].
    pub bobbin: f64,
    /// mn \[kg\].
    pub links: f64,
    /// lbc/lab.
    pub arm_ratio: f64,
    /// Rmin \[m\].
    pub bobbin_radius: f64,
    /// H \[m\].
    pub width: f64,
    /// rho \[kg/m^3\].
    pub density: f64,
}

/// Masses of the bench winder, ours: 1.9 kg with an empty bobbin, 2.1 kg as printed.
pub const BENCH_MASS: ReducedMass = ReducedMass {
    bobbin: 1.5,
    links: 0.9,
    arm_ratio: 0.1 / 0.15,
    bobbin_radius: 0.03,
    width: 0.15,
    density: 350.0,
};

impl ReducedMass {
    /// m(R) at a package radius \[m\], by kinetic energy.
    #[must_use]
    pub fn at(&self, radius: f64) -> f64 {
        self.bobbin + self.links * self.arm_ratio * self.arm_ratio + self.yarn(radius)
    }

    /// m(R) at a package radius \[m\] by equation (16), which reduces weights.
    #[must_use]
    pub fn as_printed(&self, radius: f64) -> f64 {
        self.bobbin + self.links * self.arm_ratio + self.yarn(radius)
    }

    fn yarn(&self, radius: f64) -> f64 {
        let area = PI * (radius * radius - self.bobbin_radius * self.bobbin_radius);
        area * self.width * self.density
    }
}

#[cfg(test)]
#[path = "winder_tests.rs"]
mod tests;
