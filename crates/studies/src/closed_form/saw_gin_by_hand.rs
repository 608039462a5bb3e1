//! The equations of the saw gin written by hand, for comparison with the derived and emitted ones.
//!
//! ```text
//! psi_sx' = Um - w0 a_s psi_sx + w0 a_s Kr psi_rx + w0 psi_sy
//! psi_sy' =    - w0 a_s psi_sy + w0 a_s Kr psi_ry - w0 psi_sx
//! psi_rx' =    - w0 a_r psi_rx + w0 a_r Ks psi_sx + (w0 - P w_d) psi_ry
//! psi_ry' =    - w0 a_r psi_ry + w0 a_r Ks psi_sy - (w0 - P w_d) psi_rx
//! Md = 3 P Kr w0 (psi_rx psi_sy - psi_sx psi_ry)/(2 sigma x_s)
//! T  = c (phi_d - phi_2) + b (w_d - w_2)
//! Jd w_d' = Md - T          J2 w_2' = T - ML
//! ML = r(t) (Mm + M0 sin(pi w2 t)) tanh(w_2/0.5)     r = 1/(1 + e^(-(t - 1.2)/0.02))
//! ```
//!
//! Source: saw-gin study (2020), equations (1) and (2), consistent reading; the
//! engagement r and the sign of the load are ours.

use std::f64::consts::{PI, SQRT_2};

/// State of the saw gin.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SawGinState {
    /// psi_sx, psi_sy, psi_rx, psi_ry \[V s\].
    pub flux: [f64; 4],
    /// phi_d \[rad\] and w_d \[rad/s\] of the motor.
    pub motor: [f64; 2],
    /// phi_2 \[rad\] and w_2 \[rad/s\] of the cylinder.
    pub cylinder: [f64; 2],
}

/// A rate, and the largest absolute value of its terms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sum {
    /// The sum, in the unit of the state per second.
    pub value: f64,
    /// Largest absolute value of a term, to which rounding errors are relative.
    pub largest_term: f64,
}

/// The equations with the printed numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SawGinByHand;

impl SawGinByHand {
    /// Returns the rates at time t \[s\], in the order psi_sx, psi_sy, psi_rx, psi_ry, phi_d, w_d,
    /// phi_2, w_2.
    #[must_use]
    pub fn rate(&self, t: f64, state: &SawGinState) -> [Sum; 8] {
        let (w0, um) = (2.0 * PI * 50.0, SQRT_2 * 220.0);
        let (k_s, k_r, a_s, a_r) = (0.956, 0.952, 0.115, 0.0858);
        let [psi_sx, psi_sy, psi_rx, psi_ry] = state.flux;
        let ([phi_d, w_d], [phi_2, w_2]) = (state.motor, state.cylinder);
        let pole_speed = 4.0 * w_d;

        let factor = 3.0 * 4.0 * k_r * w0 / (2.0 * (1.0 - k_s * k_r) * 4.14);
        let torque = [factor * psi_rx * psi_sy, -factor * psi_sx * psi_ry];
        let coupling = [23_065.2 * (phi_d - phi_2), 128.5346 * (w_d - w_2)];
        let load = load(t, w_2);
        let (j_d, j_2) = (4.20, 1.244);
        [
            sum(&[um, -w0 * a_s * psi_sx, w0 * a_s * k_r * psi_rx, w0 * psi_sy]),
            sum(&[-w0 * a_s * psi_sy, w0 * a_s * k_r * psi_ry, -w0 * psi_sx]),
            sum(&[-w0 * a_r * psi_rx, w0 * a_r * k_s * psi_sx, w0 * psi_ry, -pole_speed * psi_ry]),
            sum(&[-w0 * a_r * psi_ry, w0 * a_r * k_s * psi_sy, -w0 * psi_rx, pole_speed * psi_rx]),
            sum(&[w_d]),
            sum(&[torque[0] / j_d, torque[1] / j_d, -coupling[0] / j_d, -coupling[1] / j_d]),
            sum(&[w_2]),
            sum(&[coupling[0] / j_2, coupling[1] / j_2, -load[0] / j_2, -load[1] / j_2]),
        ]
    }
}

/// Returns mean and harmonic part of the load's torque \[N m\].
fn load(t: f64, speed: f64) -> [f64; 2] {
    let engagement = 1.0 / (1.0 + (-(t - 1.2) / 0.02).exp());
    let nominal = PI * 735.0 / 30.0;
    let sign = (speed / 0.5).tanh();
    [engagement * 843.72 * sign, engagement * 78.78 * (PI * nominal * t).sin() * sign]
}

fn sum(terms: &[f64]) -> Sum {
    Sum {
        value: terms.iter().sum(),
        largest_term: terms.iter().fold(0.0, |largest, term| term.abs().max(largest)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::closed_form::induction_motor::MOTOR_4A280M8;
    use crate::closed_form::two_mass::SAW_GIN;

    fn values(t: f64, state: &SawGinState) -> [f64; 8] {
        SawGinByHand.rate(t, state).map(|sum| sum.value)
    }

    #[test]
    fn flux_at_rest_under_supply_is_steady_where_the_motor_settles() {
        let speed = 76.97;
        let flux = MOTOR_4A280M8.steady_flux(MOTOR_4A280M8.slip(speed));
        let state = SawGinState {
            flux: [flux.stator.re, flux.stator.im, flux.rotor.re, flux.rotor.im],
            motor: [0.0, speed],
            cylinder: [0.0, speed],
        };
        let rates = values(0.0, &state);
        for rate in &rates[..4] {
            assert!(rate.abs() < 1e-10, "{rate}");
        }
        let torque = MOTOR_4A280M8.torque_of_flux(flux);
        assert!((rates[5] * 4.2 - torque).abs() < 1e-9);
        assert!(rates[7].abs() < 1e-20, "the load has not engaged yet");
    }

    #[test]
    fn torques_on_both_masses_add_up_to_motor_less_load() {
        let state = SawGinState {
            flux: [0.1, -0.9, -0.1, -0.8],
            motor: [10.0, 70.0],
            cylinder: [9.9, 71.0],
        };
        let rates = values(3.0, &state);
        let sum = rates[5] * SAW_GIN.driver_inertia + rates[7] * SAW_GIN.driven_inertia;
        let factor = 6.0 * 0.952 * 100.0 * PI / ((1.0 - 0.956 * 0.952) * 4.14);
        let motor = factor * (0.1 * 0.9 - 0.1 * -0.8);
        let load = 843.72 + 78.78 * (PI * PI * 24.5 * 3.0).sin();
        assert!((sum - (motor - load)).abs() < 1e-9, "{sum}");
    }

    #[test]
    fn load_opposes_motion_either_way_and_vanishes_at_standstill() {
        for t in [1.2, 5.0] {
            let forward = load(t, 70.0);
            let backward = load(t, -70.0);
            assert!(forward[0] > 0.0 && forward[0] + backward[0] == 0.0);
            assert!(load(t, 0.0) == [0.0, 0.0]);
        }
    }
}
