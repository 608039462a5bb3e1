// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen

//! Simulators emitted from the specs, one module a scene.
use crate::{Real, Simulator};

/// Mass bouncing on a shaken plate
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod bouncing_mass;

/// Oscillator with a one-sided stop
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod contact_oscillator;

/// Oscillator with a one-sided stop, smoothed
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod contact_oscillator_smooth;

/// Oscillator braked by dry friction
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod coulomb_oscillator;

/// Four-bar linkage under gravity
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod four_bar;

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

/// Chain of three pendulums, by constraints
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod pendulum_constrained;

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

/// Slider-crank turned at constant speed
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod slider_crank;

/// Stick-slip oscillation on a belt
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod stick_slip;

/// Stick-slip oscillation on a belt, smoothed
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod stick_slip_smooth;

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

/// Four-link bobbin holder, let go
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod winder_holder_drop;

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

/// Four-link bobbin holder, at work
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod winder_linkage;

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
    "bouncing_mass",
    "contact_oscillator",
    "contact_oscillator_smooth",
    "coulomb_oscillator",
    "four_bar",
    "motor_run_up",
    "motor_stationary_axes",
    "pendulum_chain",
    "pendulum_constrained",
    "saw_gin",
    "saw_gin_as_printed",
    "slider_crank",
    "stick_slip",
    "stick_slip_smooth",
    "two_mass",
    "winder_holder_drop",
    "winder_linear",
    "winder_linkage",
    "winder_nonlinear",
];

/// The scene of a name.
#[must_use]
#[rustfmt::skip]
pub fn find<R: Real>(name: &str) -> Option<&'static dyn Simulator<R>> {
    match name {
        "bouncing_mass" => Some(&bouncing_mass::BouncingMass),
        "contact_oscillator" => Some(&contact_oscillator::ContactOscillator),
        "contact_oscillator_smooth" => {
            Some(&contact_oscillator_smooth::ContactOscillatorSmooth)
        }
        "coulomb_oscillator" => Some(&coulomb_oscillator::CoulombOscillator),
        "four_bar" => Some(&four_bar::FourBar),
        "motor_run_up" => Some(&motor_run_up::MotorRunUp),
        "motor_stationary_axes" => Some(&motor_stationary_axes::MotorStationaryAxes),
        "pendulum_chain" => Some(&pendulum_chain::PendulumChain),
        "pendulum_constrained" => Some(&pendulum_constrained::PendulumConstrained),
        "saw_gin" => Some(&saw_gin::SawGin),
        "saw_gin_as_printed" => Some(&saw_gin_as_printed::SawGinAsPrinted),
        "slider_crank" => Some(&slider_crank::SliderCrank),
        "stick_slip" => Some(&stick_slip::StickSlip),
        "stick_slip_smooth" => Some(&stick_slip_smooth::StickSlipSmooth),
        "two_mass" => Some(&two_mass::TwoMass),
        "winder_holder_drop" => Some(&winder_holder_drop::WinderHolderDrop),
        "winder_linear" => Some(&winder_linear::WinderLinear),
        "winder_linkage" => Some(&winder_linkage::WinderLinkage),
        "winder_nonlinear" => Some(&winder_nonlinear::WinderNonlinear),
        _ => None,
    }
}
