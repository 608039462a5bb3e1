// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen

//! Simulators emitted from the specs, one module a scene.
use crate::{Real, Simulator, field::FieldScene};

/// Loom: motor, coupling, shaft and reed in one machine
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod loom_drive;

/// Induction motor running up empty
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod motor_run_up;

/// Induction motor running up empty, from its co-energy
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod motor_stationary_axes;

/// Chain of three pendulums
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod pendulum_chain;

/// Beat-up of a reed by an elastic shaft
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod reed_beat_up;

/// Saw gin: motor, coupling and saw cylinder
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod saw_gin;

/// Saw gin with the equations and numbers as printed
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod saw_gin_as_printed;

/// Saw gin with a distributed shaft
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod saw_gin_shaft;

/// Uniform shaft under a step of end torque
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod shaft_step_torque;

/// Shaft with a rotor at each end, let go twisted
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod shaft_with_rotors;

/// Two rotors on an elasto-dissipative coupling
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod two_mass;

/// Bobbin on a winding drum, linear layer
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod winder_linear;

/// Bobbin on a winding drum, stiffening layer
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod winder_nonlinear;

/// Names of all scenes, sorted.
#[rustfmt::skip]
pub const NAMES: &[&str] = &[
    "motor_run_up",
    "motor_stationary_axes",
    "pendulum_chain",
    "saw_gin",
    "saw_gin_as_printed",
    "two_mass",
    "winder_linear",
    "winder_nonlinear",
];

/// The scene of a name.
#[must_use]
pub fn find<R: Real>(name: &str) -> Option<&'static dyn Simulator<R>> {
    match name {
        "motor_run_up" => Some(&motor_run_up::MotorRunUp),
        "motor_stationary_axes" => Some(&motor_stationary_axes::MotorStationaryAxes),
        "pendulum_chain" => Some(&pendulum_chain::PendulumChain),
        "saw_gin" => Some(&saw_gin::SawGin),
        "saw_gin_as_printed" => Some(&saw_gin_as_printed::SawGinAsPrinted),
        "two_mass" => Some(&two_mass::TwoMass),
        "winder_linear" => Some(&winder_linear::WinderLinear),
        "winder_nonlinear" => Some(&winder_nonlinear::WinderNonlinear),
        _ => None,
    }
}

/// Names of all scenes with fields, sorted.
#[rustfmt::skip]
pub const FIELD_NAMES: &[&str] = &[
    "loom_drive",
    "reed_beat_up",
    "saw_gin_shaft",
    "shaft_step_torque",
    "shaft_with_rotors",
];

/// The scene with fields of a name, not yet cut into elements.
#[must_use]
pub fn find_field<R: Real>(name: &str) -> Option<&'static dyn FieldScene<R>> {
    match name {
        "loom_drive" => Some(&loom_drive::LoomDrive),
        "reed_beat_up" => Some(&reed_beat_up::ReedBeatUp),
        "saw_gin_shaft" => Some(&saw_gin_shaft::SawGinShaft),
        "shaft_step_torque" => Some(&shaft_step_torque::ShaftStepTorque),
        "shaft_with_rotors" => Some(&shaft_with_rotors::ShaftWithRotors),
        _ => None,
    }
}
