// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen

//! Simulators emitted from the specs, one module a scene.
use crate::{Real, Simulator};

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

/// Names of all scenes, sorted.
#[rustfmt::skip]
pub const NAMES: &[&str] = &[
    "motor_run_up",
    "saw_gin",
    "saw_gin_as_printed",
    "two_mass",
];

/// The scene of a name.
#[must_use]
pub fn find<R: Real>(name: &str) -> Option<&'static dyn Simulator<R>> {
    match name {
        "motor_run_up" => Some(&motor_run_up::MotorRunUp),
        "saw_gin" => Some(&saw_gin::SawGin),
        "saw_gin_as_printed" => Some(&saw_gin_as_printed::SawGinAsPrinted),
        "two_mass" => Some(&two_mass::TwoMass),
        _ => None,
    }
}
