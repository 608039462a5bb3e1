//! Checks of the printed formulas of the saw-gin study, and of the torque of its
//! motor in the speed reading of the printed equations.

use super::{Check, CheckFailure, Machine, Measured, worse};
use crate::closed_form::induction_motor::{InductionMotor, MOTOR_4A280M8};
use crate::closed_form::printed_laws::{
    PEAK_ACCELERATION_TIME, Reading, SAW_GIN_SHAFT, TWIST_TIME, acceleration,
};

const FLUX: [&str; 4] = ["motor.psi_x1", "motor.psi_y1", "motor.psi_x2", "motor.psi_y2"];

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "printed law of acceleration at 1.844 s",
        reference: "8743.54 rad/s^2",
        tolerance: 5e-3,
        reason: "half of the last digit stated",
        measure: |_| Ok(Measured::absolute(acceleration(PEAK_ACCELERATION_TIME), 8743.54)),
    },
    Check {
        name: "relative twist, density J, load halved",
        reference: "1.892 deg/m",
        tolerance: 5e-4,
        reason: "half of the last digit stated",
        measure: |_| Ok(Measured::absolute(relative_twist(), 1.892)),
    },
    Check {
        name: "that relative twist times the length",
        reference: "4.393 deg",
        tolerance: 1.4e-3,
        reason: "4.393 is 2.322 times the slope rounded to 1.892: half of its digit and 2.322 \
                 times half of the slope's",
        measure: |_| Ok(Measured::absolute(relative_twist() * SAW_GIN_SHAFT.length, 4.393)),
    },
    Check {
        name: "torque-speed curve, speed for the printed angle",
        reference: "closed form of the printed equations, relative",
        tolerance: 1e-12,
        reason: "both are algebra; solving the flux equations loses less than four of sixteen digits",
        measure: torque_curve,
    },
];

/// Returns the absolute slope at the far end at 1.8 s \[deg/m\].
fn relative_twist() -> f64 {
    let slope = SAW_GIN_SHAFT.slope(TWIST_TIME, SAW_GIN_SHAFT.length, Reading::OfTheFigures);
    slope.to_degrees().abs()
}

/// Compares torques at slips from -0.98 to 0.98 in steps of 0.04.
fn torque_curve(machine: &Machine) -> Result<Measured, CheckFailure> {
    let mut error = 0.0;
    for k in 1..=50 {
        let slip = (f64::from(k) - 25.5) / 25.0;
        let expected = printed_torque(slip);
        let ours = torque_at_slip(machine, slip)?;
        error = worse(error, ((ours - expected) / expected).abs());
    }
    Ok(Measured::error(error))
}

/// Returns the steady torque of the emitted equations as printed \[N m\], with the rotor's speed
/// where its angle is printed, at a slip relative to the printed synchronous speed.
pub(crate) fn torque_at_slip(machine: &Machine, slip: f64) -> Result<f64, CheckFailure> {
    let settings = [("motor.omega", (1.0 - slip) * 78.54)];
    let point = machine.steady_point(&[("motor.literal", 0.0)], &settings, &FLUX)?;
    machine.output(&point, "motor_torque")
}

/// Returns the closed form with the printed synchronous speed for w0, 220 V for the amplitude of
/// the voltage, and 0.0896 for sigma in the torque.
fn printed_torque(slip: f64) -> f64 {
    let motor = InductionMotor {
        phase_voltage: 220.0 / std::f64::consts::SQRT_2,
        supply_frequency: 78.54 / (2.0 * std::f64::consts::PI),
        ..MOTOR_4A280M8
    };
    motor.torque(slip) * motor.leakage() / 0.0896
}
