// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen

//! Simulators emitted from the specs, one module and one feature a scene.
use crate::{Real, Simulator};

/// Induction motor running up empty
#[cfg(feature = "motor_run_up")]
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
#[cfg(feature = "motor_stationary_axes")]
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
#[cfg(feature = "pendulum_chain")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod pendulum_chain;

/// Saw gin: motor, coupling and saw cylinder
#[cfg(feature = "saw_gin")]
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
#[cfg(feature = "saw_gin_as_printed")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod saw_gin_as_printed;

/// Two rotors on an elasto-dissipative coupling
#[cfg(feature = "two_mass")]
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
#[cfg(feature = "winder_linear")]
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
#[cfg(feature = "winder_nonlinear")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod winder_nonlinear;

/// Names of all scenes whose feature is on, sorted.
#[rustfmt::skip]
pub const NAMES: &[&str] = &[
    #[cfg(feature = "motor_run_up")]
    "motor_run_up",
    #[cfg(feature = "motor_stationary_axes")]
    "motor_stationary_axes",
    #[cfg(feature = "pendulum_chain")]
    "pendulum_chain",
    #[cfg(feature = "saw_gin")]
    "saw_gin",
    #[cfg(feature = "saw_gin_as_printed")]
    "saw_gin_as_printed",
    #[cfg(feature = "two_mass")]
    "two_mass",
    #[cfg(feature = "winder_linear")]
    "winder_linear",
    #[cfg(feature = "winder_nonlinear")]
    "winder_nonlinear",
];

/// The scene of a name, if its feature is on.
#[must_use]
#[allow(clippy::match_single_binding, reason = "features may leave no scene")]
pub fn find<R: Real>(name: &str) -> Option<&'static dyn Simulator<R>> {
    match name {
        #[cfg(feature = "motor_run_up")]
        "motor_run_up" => Some(&motor_run_up::MotorRunUp),
        #[cfg(feature = "motor_stationary_axes")]
        "motor_stationary_axes" => Some(&motor_stationary_axes::MotorStationaryAxes),
        #[cfg(feature = "pendulum_chain")]
        "pendulum_chain" => Some(&pendulum_chain::PendulumChain),
        #[cfg(feature = "saw_gin")]
        "saw_gin" => Some(&saw_gin::SawGin),
        #[cfg(feature = "saw_gin_as_printed")]
        "saw_gin_as_printed" => Some(&saw_gin_as_printed::SawGinAsPrinted),
        #[cfg(feature = "two_mass")]
        "two_mass" => Some(&two_mass::TwoMass),
        #[cfg(feature = "winder_linear")]
        "winder_linear" => Some(&winder_linear::WinderLinear),
        #[cfg(feature = "winder_nonlinear")]
        "winder_nonlinear" => Some(&winder_nonlinear::WinderNonlinear),
        _ => None,
    }
}
