//! An induction motor as four windings: their inductances and resistances, their
//! currents, and Park's transformation, by which it becomes the motor in flux
//! linkages.
//!
//! Stator windings lie along fixed axes alpha, beta; rotor windings turn with the
//! rotor, at the electrical angle theta = P phi. Write currents as I = i_a + j i_b,
//! each in the axes of its windings, and i_r' = I_r e^(j theta) for the rotor's seen
//! from the stator. Co-energy, losses and work of the supply are those of three phases:
//!
//! ```text
//! T = J phi'^2/2 + 3/4 (L_s |I_s|^2 + L_r |I_r|^2) + 3/2 M Re(conj(I_s) I_r e^(j theta))
//! D = 3/4 (R_s |I_s|^2 + R_r |I_r|^2)          Q = 3/2 Um e^(j (w0 t + gamma)) on the stator
//! ```
//!
//! Lagrange's equations, divided by 3/2, are Kirchhoff's; the angle's is the torque:
//!
//! ```text
//! (L_s I_s + M I_r e^(j theta))' + R_s I_s = Um e^(j (w0 t + gamma))
//! (L_r I_r + M I_s e^(-j theta))' + R_r I_r = 0
//! J phi'' = dT/dphi = 3/2 P M Im(I_s conj(I_r e^(j theta)))
//! ```
//!
//! In axes that turn at w0 the currents are I_s = i_s e^(j w0 t) and
//! I_r = i_r e^(j (w0 t - theta)) (Park), and Psi_s = L_s i_s + M i_r,
//! Psi_r = L_r i_r + M i_s obey
//!
//! ```text
//! Psi_s' = U - R_s i_s - j w0 Psi_s        Psi_r' = -R_r i_r - j (w0 - P phi') Psi_r
//! i_s = (Psi_s - Kr Psi_r)/(sigma L_s)     i_r = (Psi_r - Ks Psi_s)/(sigma L_r)
//! ```
//!
//! These are the equations in flux linkages if
//!
//! ```text
//! L_s = x_s/w0    M = Ks L_s    L_r = M/Kr = Ks x_s/(Kr w0)
//! R_s = a_s sigma x_s           R_r = a_r sigma x_r = a_r sigma Ks x_s/Kr
//! ```
//!
//! because then Ks Kr = M^2/(L_s L_r), so that sigma is the leakage of both.
//!
//! Source: textbook (White and Woodson 1959, generalized machine), by hand.

use num_complex::Complex64;

use super::induction_motor::{Flux, InductionMotor};

/// Four windings of an induction motor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotorWindings {
    /// L_s \[H\].
    pub stator_inductance: f64,
    /// L_r \[H\].
    pub rotor_inductance: f64,
    /// M \[H\], of windings that lie along each other; below sqrt(L_s L_r).
    pub mutual_inductance: f64,
    /// R_s \[ohm\].
    pub stator_resistance: f64,
    /// R_r \[ohm\].
    pub rotor_resistance: f64,
    /// Pairs of poles P.
    pub pole_pairs: f64,
}

/// Currents of stator and rotor \[A\], as amplitudes of phase quantities; the axes depend on the
/// function that returns them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Currents {
    /// i_s.
    pub stator: Complex64,
    /// i_r.
    pub rotor: Complex64,
}

impl MotorWindings {
    /// Windings of a motor that is given by its reactances.
    #[must_use]
    pub fn of(motor: &InductionMotor) -> Self {
        let w0 = motor.synchronous_frequency();
        let rotor_reactance = motor.k_s * motor.x_s / motor.k_r;
        Self {
            stator_inductance: motor.x_s / w0,
            rotor_inductance: rotor_reactance / w0,
            mutual_inductance: motor.k_s * motor.x_s / w0,
            stator_resistance: motor.alpha_s * motor.leakage() * motor.x_s,
            rotor_resistance: motor.alpha_r * motor.leakage() * rotor_reactance,
            pole_pairs: motor.pole_pairs,
        }
    }

    /// Currents of flux linkages in common axes, in the same axes:
    /// i_s = (L_r Psi_s - M Psi_r)/(L_s L_r - M^2), i_r likewise.
    #[must_use]
    pub fn currents(&self, flux: Flux) -> Currents {
        let (l_s, l_r, m) = (self.stator_inductance, self.rotor_inductance, self.mutual_inductance);
        let determinant = l_s * l_r - m * m;
        Currents {
            stator: (l_r * flux.stator - m * flux.rotor) / determinant,
            rotor: (l_s * flux.rotor - m * flux.stator) / determinant,
        }
    }

    /// Torque of currents in common axes, 3/2 P M Im(i_s conj(i_r)) \[N m\].
    #[must_use]
    pub fn torque(&self, currents: Currents) -> f64 {
        1.5 * self.pole_pairs
            * self.mutual_inductance
            * (currents.stator * currents.rotor.conj()).im
    }
}

impl Currents {
    /// From synchronous axes to the axes of the windings: the stator's currents
    /// turned by w0 t, the rotor's by w0 t - P phi \[rad\] (Park, backwards).
    #[must_use]
    pub fn in_windings(self, supply_angle: f64, rotor_angle: f64) -> Self {
        Self {
            stator: self.stator * Complex64::cis(supply_angle),
            rotor: self.rotor * Complex64::cis(supply_angle - rotor_angle),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::induction_motor::MOTOR_4A280M8;
    use super::*;

    fn close(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-12 * b.abs(), "{a} against {b}");
    }

    const FLUX: Flux = Flux { stator: Complex64::new(0.3, -0.9), rotor: Complex64::new(0.1, -0.8) };

    #[test]
    fn windings_have_the_printed_resistances_and_reactances() {
        let windings = MotorWindings::of(&MOTOR_4A280M8);
        let w0 = MOTOR_4A280M8.synchronous_frequency();
        assert!((windings.stator_resistance - 0.043).abs() < 5e-4);
        assert!((windings.rotor_resistance - 0.032).abs() < 5e-4);
        assert!((windings.mutual_inductance * w0 - 3.957).abs() < 1e-3);
        assert!((windings.rotor_inductance * w0 - 4.155).abs() < 5e-3);
    }

    #[test]
    fn torque_of_currents_is_torque_of_their_flux() {
        let windings = MotorWindings::of(&MOTOR_4A280M8);
        close(windings.torque(windings.currents(FLUX)), MOTOR_4A280M8.torque_of_flux(FLUX));
    }

    #[test]
    fn losses_of_the_currents_are_those_of_the_flux_equations() {
        // Psi' of the closed form holds R i and the turning of the axes.
        let windings = MotorWindings::of(&MOTOR_4A280M8);
        let slip = 0.3;
        let [[ss, sr], [rs, rr]] = MOTOR_4A280M8.rate_matrix(slip);
        let currents = windings.currents(FLUX);
        let w0 = MOTOR_4A280M8.synchronous_frequency();
        let turning = |rate: f64, flux: Complex64| -Complex64::i() * rate * flux;
        let stator = -windings.stator_resistance * currents.stator + turning(w0, FLUX.stator);
        let rotor = -windings.rotor_resistance * currents.rotor + turning(slip * w0, FLUX.rotor);
        assert!((stator - (ss * FLUX.stator + sr * FLUX.rotor)).norm() < 1e-10);
        assert!((rotor - (rs * FLUX.stator + rr * FLUX.rotor)).norm() < 1e-10);
    }

    #[test]
    fn park_s_transformation_keeps_the_torque() {
        let windings = MotorWindings::of(&MOTOR_4A280M8);
        let currents = windings.currents(FLUX);
        let (supply, rotor) = (1.3, 0.4);
        let own = currents.in_windings(supply, rotor);
        let seen_from_the_stator = Currents { rotor: own.rotor * Complex64::cis(rotor), ..own };
        close(windings.torque(seen_from_the_stator), windings.torque(currents));
    }
}
