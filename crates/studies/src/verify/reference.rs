//! Converged references of whole runs as numbers.
//!
//! Each was computed once from equations written by hand, by two unrelated
//! methods: Taylor series of high order in 113-bit arithmetic at tolerance 1e-26,
//! and Gragg-Bulirsch-Stoer extrapolation in quadruple precision at 1e-20.

use super::{CheckFailure, Machine};
use machinist::Trajectory;

/// Name of a state, its reference value and its scale.
pub(super) type FinalState = (&'static str, f64, f64);

/// The motor alone, from rest, at t = 1 s. Both methods agree in all digits stored.
pub(super) const MOTOR_RUN_UP: &[FinalState] = &[
    ("motor.psi_sx", 1.024_564_881_712_43e-2, 1.0),
    ("motor.psi_sy", -0.990_357_301_483_125_6, 1.0),
    ("motor.psi_rx", 1.079_097_667_518_466e-2, 1.0),
    ("motor.psi_ry", -0.946_665_902_247_526_3, 1.0),
    ("motor.omega", 78.543_066_823_246_44, 78.5),
];

/// The saw gin from rest, loaded at 1.2 s, at t = 2 s. Both methods agree to 3.4e-17 in the measure
/// of [`scaled_distance`].
pub(super) const SAW_GIN: &[FinalState] = &[
    ("motor.psi_sx", 1.369_984_093_352_053e-2, 1.0),
    ("motor.psi_sy", -0.970_209_917_281_856_2, 1.0),
    ("motor.psi_rx", -0.168_462_718_410_368_6, 1.0),
    ("motor.psi_ry", -0.893_655_982_491_246_6, 1.0),
    // The angles are 120.543_034_120_545_41 and 120.507_180_237_520_9.
    ("coupling.twist", 0.035_853_883_024_51, 1.0),
    ("motor.omega", 77.173_039_332_711_94, 78.5),
    ("cylinder.omega", 77.445_021_774_930_57, 78.5),
];

/// Returns the root mean square over the states of |y - reference|/max(|reference|, scale) at the
/// end of the run.
pub(super) fn scaled_distance(
    machine: &Machine,
    trajectory: &Trajectory,
    reference: &[FinalState],
) -> Result<f64, CheckFailure> {
    let mut sum = 0.0;
    for (name, value, scale) in reference {
        let ours = machine.last(trajectory, name)?;
        sum += ((ours - value) / value.abs().max(*scale)).powi(2);
    }
    Ok((sum / reference.len() as f64).sqrt())
}
