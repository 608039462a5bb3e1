//! Two inertias on a spring and a damper, under constant and harmonic torques.
//!
//! ```text
//! Jd phi_d'' = Md - T      T = c theta + b theta'      theta = phi_d - phi_2
//! J2 phi_2'' = T - M       M = M_mean + A sin(w t + p)
//! ```
//!
//! Dividing by the inertias and subtracting gives one damped oscillator for the twist. Adding gives
//! the motion of the whole as a rigid body:
//!
//! ```text
//! Jr theta'' + b theta' + c theta = (Md J2 + M Jd)/(Jd + J2)    Jr = Jd J2/(Jd + J2)
//! (Jd + J2) Omega' = Md - M         Omega = (Jd phi_d' + J2 phi_2')/(Jd + J2)
//! phi_d' = Omega + theta' J2/(Jd + J2)      phi_2' = Omega - theta' Jd/(Jd + J2)
//! ```
//!
//! Both are linear with constant coefficients, so a particular solution and the free decay of the
//! remaining initial deviation are the complete solution.
//!
//! Source: saw-gin study (2020), equations (1), with ratio 1; solution by hand.

/// Driver and driven inertia on an elasto-dissipative coupling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoMass {
    /// Jd \[kg m^2\], positive.
    pub driver_inertia: f64,
    /// J2 \[kg m^2\], positive.
    pub driven_inertia: f64,
    /// c \[N m/rad\], positive.
    pub stiffness: f64,
    /// b \[N m s/rad\], not negative.
    pub damping: f64,
}

/// Rotor of the motor and saw cylinder of the saw gin on their coupling.
pub const SAW_GIN: TwoMass =
    TwoMass { driver_inertia: 4.20, driven_inertia: 1.244, stiffness: 23_065.2, damping: 128.5346 };

/// Torques on both masses: Md, and M = mean + amplitude sin(frequency t + phase),
/// which resists.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Torques {
    /// Md on the driver \[N m\].
    pub driving: f64,
    /// Mean resisting torque on the driven mass \[N m\].
    pub load: f64,
    /// Amplitude of the harmonic resisting torque \[N m\].
    pub load_amplitude: f64,
    /// Its angular frequency \[rad/s\].
    pub load_frequency: f64,
    /// Its phase at t = 0 \[rad\].
    pub load_phase: f64,
}

/// Twist and its rate.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Twist {
    /// theta = phi_d - phi_2 \[rad\].
    pub angle: f64,
    /// theta' \[rad/s\].
    pub rate: f64,
}

/// Angles \[rad\] and speeds \[rad/s\] of both masses.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Motion {
    /// phi_d.
    pub driver_angle: f64,
    /// phi_d'.
    pub driver_speed: f64,
    /// phi_2.
    pub driven_angle: f64,
    /// phi_2'.
    pub driven_speed: f64,
}

/// Response to a harmonic torque: `theta = amplitude sin(w t + p - phase_lag)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HarmonicResponse {
    /// Amplitude of the twist \[rad\].
    pub amplitude: f64,
    /// Lag behind the torque \[rad\], from 0 to pi.
    pub phase_lag: f64,
}

impl Motion {
    /// Twist of the coupling.
    #[must_use]
    pub fn twist(&self) -> Twist {
        Twist {
            angle: self.driver_angle - self.driven_angle,
            rate: self.driver_speed - self.driven_speed,
        }
    }
}

impl TwoMass {
    /// Angles and speeds at time t \[s\] after `start`.
    #[must_use]
    pub fn motion(&self, t: f64, start: Motion, torques: Torques) -> Motion {
        let twist = self.twist(t, start.twist(), torques);
        let mean = self.mean_motion(t, start, torques);
        let driver_share = self.driven_inertia / self.total_inertia();
        let driven_share = self.driver_inertia / self.total_inertia();
        Motion {
            driver_angle: mean.angle + driver_share * twist.angle,
            driver_speed: mean.rate + driver_share * twist.rate,
            driven_angle: mean.angle - driven_share * twist.angle,
            driven_speed: mean.rate - driven_share * twist.rate,
        }
    }

    /// Twist at time t \[s\]: static twist, harmonic response, and the free decay of the remaining
    /// initial deviation. Holds below, at and above critical damping.
    #[must_use]
    pub fn twist(&self, t: f64, start: Twist, torques: Torques) -> Twist {
        let level = self.static_twist(torques.driving, torques.load);
        let first = self.harmonic_twist(0.0, torques);
        let now = self.harmonic_twist(t, torques);
        let left =
            Twist { angle: start.angle - level - first.angle, rate: start.rate - first.rate };
        let free = self.free_decay(t, left);
        Twist { angle: level + now.angle + free.angle, rate: now.rate + free.rate }
    }

    /// Twist without torques: Jr theta'' + b theta' + c theta = 0.
    ///
    /// With a = b/(2 Jr) and D = c/Jr - a^2 the solution is
    /// `e^(-a t) [theta_0 C + (theta_0' + a theta_0) S]`, C = cos(sqrt(D) t), S = sin(sqrt(D)
    /// t)/sqrt(D); hyperbolic for D < 0, C = 1 and S = t at D = 0.
    #[must_use]
    pub fn free_decay(&self, t: f64, start: Twist) -> Twist {
        let decay = self.damping / (2.0 * self.reduced_inertia());
        let square = self.stiffness / self.reduced_inertia();
        let (c, s) = damped_pair(t, decay, square);
        Twist {
            angle: start.angle * c + (start.rate + decay * start.angle) * s,
            rate: start.rate * c - (decay * start.rate + square * start.angle) * s,
        }
    }

    /// Particular solution for the harmonic load alone: steady-state twist at time t \[s\].
    #[must_use]
    pub fn harmonic_twist(&self, t: f64, torques: Torques) -> Twist {
        let answer = self.harmonic_response(torques.load_amplitude, torques.load_frequency);
        let argument = torques.load_frequency * t + torques.load_phase - answer.phase_lag;
        Twist {
            angle: answer.amplitude * argument.sin(),
            rate: answer.amplitude * torques.load_frequency * argument.cos(),
        }
    }

    /// Steady-state response to a harmonic torque on the driven mass: amplitude
    /// A Jd/(Jd + J2)/sqrt((c - Jr w^2)^2 + (b w)^2), lag atan2(b w, c - Jr w^2).
    #[must_use]
    pub fn harmonic_response(&self, amplitude: f64, frequency: f64) -> HarmonicResponse {
        let in_phase = self.stiffness - self.reduced_inertia() * frequency * frequency;
        let quadrature = self.damping * frequency;
        let share = self.driver_inertia / self.total_inertia();
        HarmonicResponse {
            amplitude: amplitude * share / in_phase.hypot(quadrature),
            phase_lag: quadrature.atan2(in_phase),
        }
    }

    /// Amplitude ratio of the torque of the coupling to that of a harmonic load: twist times
    /// |c + j b w|.
    #[must_use]
    pub fn load_gain(&self, frequency: f64) -> f64 {
        let stiffness = self.stiffness.hypot(self.damping * frequency);
        self.harmonic_response(1.0, frequency).amplitude * stiffness
    }

    /// Motion of the whole as a rigid body: angle and speed of the mean weighted by
    /// inertia, (Jd + J2) Omega' = Md - M, integrated exactly.
    #[must_use]
    pub fn mean_motion(&self, t: f64, start: Motion, torques: Torques) -> Twist {
        let total = self.total_inertia();
        let weigh = |driver: f64, driven: f64| {
            (self.driver_inertia * driver + self.driven_inertia * driven) / total
        };
        let (once, twice) = sine_integrals(t, torques.load_frequency, torques.load_phase);
        let steady = (torques.driving - torques.load) / total;
        let harmonic = torques.load_amplitude / total;
        let speed = weigh(start.driver_speed, start.driven_speed);
        let angle = weigh(start.driver_angle, start.driven_angle);
        Twist {
            angle: angle + speed * t + steady * t * t / 2.0 - harmonic * twice,
            rate: speed + steady * t - harmonic * once,
        }
    }

    /// Twist under constant torques: (Md J2 + M Jd)/(c (Jd + J2)) \[rad\].
    #[must_use]
    pub fn static_twist(&self, driving: f64, load: f64) -> f64 {
        (driving * self.driven_inertia + load * self.driver_inertia)
            / (self.stiffness * self.total_inertia())
    }

    /// Jr = Jd J2/(Jd + J2) \[kg m^2\].
    #[must_use]
    pub fn reduced_inertia(&self) -> f64 {
        self.driver_inertia * self.driven_inertia / self.total_inertia()
    }

    /// sqrt(c/Jr) \[rad/s\], undamped frequency.
    #[must_use]
    pub fn natural_frequency(&self) -> f64 {
        (self.stiffness / self.reduced_inertia()).sqrt()
    }

    /// Damping ratio b/(2 sqrt(c Jr)); below 1 the twist oscillates.
    #[must_use]
    pub fn damping_ratio(&self) -> f64 {
        self.damping / (2.0 * (self.stiffness * self.reduced_inertia()).sqrt())
    }

    fn total_inertia(&self) -> f64 {
        self.driver_inertia + self.driven_inertia
    }
}

impl Torques {
    /// Constant torques without a harmonic part.
    #[must_use]
    pub fn constant(driving: f64, load: f64) -> Self {
        Self { driving, load, ..Self::default() }
    }
}

/// e^(-a t) C and e^(-a t) S of [`TwoMass::free_decay`], with D = square - decay^2.
///
/// The hyperbolic pair uses decaying exponentials only, so it neither overflows nor loses the slow
/// one to cancellation.
pub(super) fn damped_pair(t: f64, decay: f64, square: f64) -> (f64, f64) {
    let discriminant = square - decay * decay;
    let root = discriminant.abs().sqrt();
    let fade = (-decay * t).exp();
    if root == 0.0 {
        (fade, fade * t)
    } else if discriminant > 0.0 {
        let (sine, cosine) = (root * t).sin_cos();
        (fade * cosine, fade * sine / root)
    } else {
        let slow = (-square / (decay + root) * t).exp();
        let spread = (-2.0 * root * t).exp_m1();
        (slow * (1.0 + spread / 2.0), -slow * spread / (2.0 * root))
    }
}

/// The integral of sin(w u + p) from 0 to t, and its integral from 0 to t.
fn sine_integrals(t: f64, frequency: f64, phase: f64) -> (f64, f64) {
    let x = frequency * t;
    let half = sine_quotient(x / 2.0);
    let once = t * half * (x / 2.0 + phase).sin();
    // x - sin x cancels for small x; six terms of its series reach full precision.
    let odd = if x.abs() < 0.5 {
        let s = x * x;
        x / 6.0
            * (1.0
                - s / 20.0
                    * (1.0 - s / 42.0 * (1.0 - s / 72.0 * (1.0 - s / 110.0 * (1.0 - s / 156.0)))))
    } else {
        (x - x.sin()) / (x * x)
    };
    (once, t * t * (half * half / 2.0 * phase.sin() + odd * phase.cos()))
}

/// sin(x)/x, 1 at 0.
fn sine_quotient(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { x.sin() / x }
}

#[cfg(test)]
#[path = "two_mass_tests.rs"]
mod tests;
