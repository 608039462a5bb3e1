//! An induction motor at constant speed: two complex linear equations.
//!
//! With Psi = psi_x + j psi_y of stator (s) and rotor (r), in axes that turn at
//! the electrical synchronous speed w0 = 2 pi f, and slip s = 1 - P w/w0,
//!
//! ```text
//! Psi_s' = U - w0 (a_s + j) Psi_s + w0 a_s Kr Psi_r        U = Um e^(j gamma)
//! Psi_r' =     w0 a_r Ks Psi_s    - w0 (a_r + j s) Psi_r
//! Md = 3 P Kr w0/(2 sigma x_s) Im(Psi_s conj(Psi_r))        sigma = 1 - Ks Kr
//! ```
//!
//! At rest of both, the second gives Psi_r = a_r Ks Psi_s/(a_r + j s), the first
//! then Psi_s, and the torque is a quotient of polynomials in the slip:
//!
//! ```text
//! Md(s) = N s/(A s^2 + 2 H s + B)
//! N = 3 P Kr Ks a_r Um^2/(2 sigma x_s w0)     A = 1 + a_s^2
//! H = a_s a_r (1 - sigma)                     B = a_r^2 (1 + sigma^2 a_s^2)
//! ```
//!
//! It is largest where A s = B/s: breakdown slip sqrt(B/A), breakdown torque
//! N/(2 (sqrt(A B) + H)). This is the Kloss formula without neglected terms.
//!
//! Source: saw-gin study (2020), equations (2), in their consistent reading;
//! solution by hand.

use std::f64::consts::{PI, SQRT_2};

use num_complex::Complex64;

/// Parameters of the motor; all positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InductionMotor {
    /// Root mean square of the phase voltage \[V\]; Um is sqrt(2) times this.
    pub phase_voltage: f64,
    /// Frequency f of the supply \[Hz\].
    pub supply_frequency: f64,
    /// Phase gamma of the supply \[rad\].
    pub supply_phase: f64,
    /// Pairs of poles P.
    pub pole_pairs: f64,
    /// Ks = x_mu/x_s.
    pub k_s: f64,
    /// Kr = x_mu/x_r.
    pub k_r: f64,
    /// Stator reactance x_s at supply frequency \[ohm\].
    pub x_s: f64,
    /// Stator decay a_s = r_s/(sigma x_s).
    pub alpha_s: f64,
    /// Rotor decay a_r = r_r/(sigma x_r).
    pub alpha_r: f64,
}

/// Motor 4A280M8 of the saw gin, with sigma not rounded.
pub const MOTOR_4A280M8: InductionMotor = InductionMotor {
    phase_voltage: 220.0,
    supply_frequency: 50.0,
    supply_phase: 0.0,
    pole_pairs: 4.0,
    k_s: 0.956,
    k_r: 0.952,
    x_s: 4.14,
    alpha_s: 0.115,
    alpha_r: 0.0858,
};

/// Data sheet of a motor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nameplate {
    /// Rated power \[W\].
    pub power: f64,
    /// Rated speed \[1/min\].
    pub speed: f64,
    /// Rated torque \[N m\].
    pub torque: f64,
    /// Breakdown torque \[N m\].
    pub breakdown_torque: f64,
    /// Rated slip.
    pub slip: f64,
    /// Slip at the breakdown torque.
    pub breakdown_slip: f64,
    /// Root mean square of a phase current at rated load \[A\].
    pub current: f64,
    /// cos phi at rated load.
    pub power_factor: f64,
    /// Efficiency at rated load.
    pub efficiency: f64,
}

/// Nameplate of the motor 4A280M8, as printed in the study.
pub const NAMEPLATE_4A280M8: Nameplate = Nameplate {
    power: 75_000.0,
    speed: 735.0,
    torque: 974.4,
    breakdown_torque: 1948.8,
    slip: 0.02,
    breakdown_slip: 0.074_64,
    current: 144.53,
    power_factor: 0.85,
    efficiency: 0.925,
};

/// A steady state of the motor. Losses are those of the windings: the equations have none in
/// iron, by friction or fan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadPoint {
    /// Root mean square of a phase current \[A\].
    pub current: f64,
    /// cos phi.
    pub power_factor: f64,
    /// Power from the supply \[W\].
    pub supplied: f64,
    /// Power at the shaft \[W\].
    pub shaft_power: f64,
}

impl LoadPoint {
    /// Power at the shaft over that from the supply.
    #[must_use]
    pub fn efficiency(&self) -> f64 {
        self.shaft_power / self.supplied
    }
}

/// Flux linkages of stator and rotor \[V s\].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Flux {
    /// Psi_s = psi_sx + j psi_sy.
    pub stator: Complex64,
    /// Psi_r = psi_rx + j psi_ry.
    pub rotor: Complex64,
}

impl InductionMotor {
    /// Steady torque at a slip \[N m\]; see the module for N, A, H, B.
    #[must_use]
    pub fn torque(&self, slip: f64) -> f64 {
        let [n, a, h, b] = self.torque_coefficients();
        n * slip / ((a * slip + 2.0 * h) * slip + b)
    }

    /// Slip of the largest torque, sqrt(B/A).
    #[must_use]
    pub fn breakdown_slip(&self) -> f64 {
        let [_, a, _, b] = self.torque_coefficients();
        (b / a).sqrt()
    }

    /// Largest torque of the motor, N/(2 (sqrt(A B) + H)) \[N m\].
    #[must_use]
    pub fn breakdown_torque(&self) -> f64 {
        let [n, a, h, b] = self.torque_coefficients();
        n / (2.0 * ((a * b).sqrt() + h))
    }

    /// Current and powers at a slip, in steady state.
    #[must_use]
    pub fn load_point(&self, slip: f64) -> LoadPoint {
        let flux = self.steady_flux(slip);
        let current = self.synchronous_frequency() * (flux.stator - self.k_r * flux.rotor)
            / (self.leakage() * self.x_s);
        let apparent = 1.5 * self.supply() * current.conj();
        LoadPoint {
            current: current.norm() / SQRT_2,
            power_factor: apparent.re / apparent.norm(),
            supplied: apparent.re,
            shaft_power: self.torque(slip) * self.speed(slip),
        }
    }

    /// Steady torque at standstill \[N m\].
    #[must_use]
    pub fn starting_torque(&self) -> f64 {
        self.torque(1.0)
    }

    /// Flux linkages \[V s\] to which the motor settles at a slip.
    #[must_use]
    pub fn steady_flux(&self, slip: f64) -> Flux {
        let rotor_over_stator = self.alpha_r * self.k_s / Complex64::new(self.alpha_r, slip);
        let stator = self.supply()
            / (self.synchronous_frequency()
                * (Complex64::new(self.alpha_s, 1.0)
                    - self.alpha_s * self.k_r * rotor_over_stator));
        Flux { stator, rotor: rotor_over_stator * stator }
    }

    /// Flux linkages \[V s\] at time t \[s\] after `start`, the slip being constant.
    ///
    /// The exponential of the 2 by 2 matrix with eigenvalues m + d, m - d is
    /// e^(m t) (cosh(d t) + (matrix - m) sinh(d t)/d): two complex exponentials,
    /// without a division by d when the eigenvalues come close to each other.
    #[must_use]
    pub fn flux(&self, t: f64, start: Flux, slip: f64) -> Flux {
        let settled = self.steady_flux(slip);
        let [[ss, sr], [rs, rr]] = self.rate_matrix(slip);
        let (stator, rotor) = (start.stator - settled.stator, start.rotor - settled.rotor);
        let mean = (ss + rr) / 2.0;
        let half = (ss - rr) / 2.0;
        let distance = (half * half + sr * rs).sqrt();
        let (even, odd) = exponential_pair(t, mean, distance);
        Flux {
            stator: settled.stator + even * stator + odd * (half * stator + sr * rotor),
            rotor: settled.rotor + even * rotor + odd * (rs * stator - half * rotor),
        }
    }

    /// Torque of given flux linkages \[N m\], 3 P Kr w0/(2 sigma x_s) Im(Psi_s conj(Psi_r)).
    #[must_use]
    pub fn torque_of_flux(&self, flux: Flux) -> f64 {
        1.5 * self.pole_pairs * self.k_r * self.synchronous_frequency()
            / (self.leakage() * self.x_s)
            * (flux.stator * flux.rotor.conj()).im
    }

    /// Matrix of the flux equations at a slip \[1/s\], rows and columns stator, rotor.
    #[must_use]
    pub fn rate_matrix(&self, slip: f64) -> [[Complex64; 2]; 2] {
        let w0 = self.synchronous_frequency();
        [
            [
                -w0 * Complex64::new(self.alpha_s, 1.0),
                Complex64::from(w0 * self.alpha_s * self.k_r),
            ],
            [
                Complex64::from(w0 * self.alpha_r * self.k_s),
                -w0 * Complex64::new(self.alpha_r, slip),
            ],
        ]
    }

    /// Eigenvalues of [`Self::rate_matrix`] \[1/s\]: real part decay, imaginary part
    /// frequency of the two transients.
    #[must_use]
    pub fn eigenvalues(&self, slip: f64) -> [Complex64; 2] {
        let [[ss, sr], [rs, rr]] = self.rate_matrix(slip);
        let mean = (ss + rr) / 2.0;
        let half = (ss - rr) / 2.0;
        let distance = (half * half + sr * rs).sqrt();
        [mean + distance, mean - distance]
    }

    /// Supply voltage U = Um e^(j gamma) \[V\].
    #[must_use]
    pub fn supply(&self) -> Complex64 {
        Complex64::from_polar(SQRT_2 * self.phase_voltage, self.supply_phase)
    }

    /// sigma = 1 - Ks Kr.
    #[must_use]
    pub fn leakage(&self) -> f64 {
        1.0 - self.k_s * self.k_r
    }

    /// Electrical synchronous speed w0 = 2 pi f \[rad/s\].
    #[must_use]
    pub fn synchronous_frequency(&self) -> f64 {
        2.0 * PI * self.supply_frequency
    }

    /// Mechanical synchronous speed w0/P \[rad/s\].
    #[must_use]
    pub fn synchronous_speed(&self) -> f64 {
        self.synchronous_frequency() / self.pole_pairs
    }

    /// Slip at a rotor speed \[rad/s\].
    #[must_use]
    pub fn slip(&self, speed: f64) -> f64 {
        1.0 - speed / self.synchronous_speed()
    }

    /// Rotor speed \[rad/s\] at a slip.
    #[must_use]
    pub fn speed(&self, slip: f64) -> f64 {
        (1.0 - slip) * self.synchronous_speed()
    }

    /// N, A, H, B of the module's torque formula.
    fn torque_coefficients(&self) -> [f64; 4] {
        let sigma = self.leakage();
        let (a_s, a_r) = (self.alpha_s, self.alpha_r);
        let amplitude = SQRT_2 * self.phase_voltage;
        let n = 1.5 * self.pole_pairs * self.k_r * self.k_s * a_r * amplitude * amplitude
            / (sigma * self.x_s * self.synchronous_frequency());
        [
            n,
            1.0 + a_s * a_s,
            a_s * a_r * (1.0 - sigma),
            a_r * a_r * (1.0 + sigma * sigma * a_s * a_s),
        ]
    }
}

/// e^(m t) cosh(d t) and e^(m t) sinh(d t)/d.
fn exponential_pair(t: f64, mean: Complex64, distance: Complex64) -> (Complex64, Complex64) {
    let z = distance * t;
    if z.norm() < 0.1 {
        // Seven terms of the series in z^2: the next is below 1e-26.
        let square = z * z;
        let (mut even, mut odd) = (Complex64::from(1.0), Complex64::from(1.0));
        let (mut even_term, mut odd_term) = (even, odd);
        for k in 1..7 {
            let order = f64::from(2 * k);
            even_term *= square / (order * (order - 1.0));
            odd_term *= square / (order * (order + 1.0));
            even += even_term;
            odd += odd_term;
        }
        let fade = (mean * t).exp();
        return (fade * even, fade * odd * t);
    }
    // Apart, the two exponentials stay separate: neither grows.
    let (plus, minus) = (((mean + distance) * t).exp(), ((mean - distance) * t).exp());
    ((plus + minus) / 2.0, (plus - minus) / (2.0 * distance))
}

#[cfg(test)]
#[path = "induction_motor_tests.rs"]
mod tests;
