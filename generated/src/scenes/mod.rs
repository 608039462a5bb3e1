// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen

//! Simulators emitted from the specs, one module and one feature a scene.
use ::machinist_contract::{Dual, Real, Simulator, field::FieldScene};

/// Mass bouncing on a shaken plate
#[cfg(feature = "bouncing_mass")]
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
#[cfg(feature = "contact_oscillator")]
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
#[cfg(feature = "contact_oscillator_smooth")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod contact_oscillator_smooth;

/// Oscillator damped by dry friction
#[cfg(feature = "coulomb_oscillator")]
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
#[cfg(feature = "four_bar")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod four_bar;

/// Loom: motor, coupling, shaft and reed
#[cfg(feature = "loom_drive")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod loom_drive;

/// No-load run-up of an induction motor
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

/// No-load run-up of an induction motor, from its co-energy
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

/// Triple pendulum
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

/// Triple pendulum, by constraints
#[cfg(feature = "pendulum_constrained")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod pendulum_constrained;

/// Triple pendulum in relative angles
#[cfg(feature = "pendulum_relative")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod pendulum_relative;

/// Beat-up of a reed by an elastic shaft
#[cfg(feature = "reed_beat_up")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod reed_beat_up;

/// Beat-up of a reed against a one-sided fell
#[cfg(feature = "reed_beat_up_one_sided")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod reed_beat_up_one_sided;

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

/// Saw gin with a distributed shaft
#[cfg(feature = "saw_gin_shaft")]
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
#[cfg(feature = "shaft_step_torque")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod shaft_step_torque;

/// Shaft with a rotor at each end, released twisted
#[cfg(feature = "shaft_with_rotors")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod shaft_with_rotors;

/// Slider-crank at constant speed
#[cfg(feature = "slider_crank")]
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
#[cfg(feature = "stick_slip")]
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
#[cfg(feature = "stick_slip_smooth")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod stick_slip_smooth;

/// Two rotors on a spring-damper coupling
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

/// Bobbin on a winding drum, all nonlinearities
#[cfg(feature = "winder_full")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod winder_full;

/// Four-link bobbin holder, released
#[cfg(feature = "winder_holder_drop")]
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

/// Bobbin on a winding drum as printed
#[cfg(feature = "winder_linear_as_printed")]
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod winder_linear_as_printed;

/// Four-link bobbin holder, working position
#[cfg(feature = "winder_linkage")]
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
    #[cfg(feature = "bouncing_mass")]
    "bouncing_mass",
    #[cfg(feature = "contact_oscillator")]
    "contact_oscillator",
    #[cfg(feature = "contact_oscillator_smooth")]
    "contact_oscillator_smooth",
    #[cfg(feature = "coulomb_oscillator")]
    "coulomb_oscillator",
    #[cfg(feature = "four_bar")]
    "four_bar",
    #[cfg(feature = "motor_run_up")]
    "motor_run_up",
    #[cfg(feature = "motor_stationary_axes")]
    "motor_stationary_axes",
    #[cfg(feature = "pendulum_chain")]
    "pendulum_chain",
    #[cfg(feature = "pendulum_constrained")]
    "pendulum_constrained",
    #[cfg(feature = "pendulum_relative")]
    "pendulum_relative",
    #[cfg(feature = "saw_gin")]
    "saw_gin",
    #[cfg(feature = "saw_gin_as_printed")]
    "saw_gin_as_printed",
    #[cfg(feature = "slider_crank")]
    "slider_crank",
    #[cfg(feature = "stick_slip")]
    "stick_slip",
    #[cfg(feature = "stick_slip_smooth")]
    "stick_slip_smooth",
    #[cfg(feature = "two_mass")]
    "two_mass",
    #[cfg(feature = "winder_full")]
    "winder_full",
    #[cfg(feature = "winder_holder_drop")]
    "winder_holder_drop",
    #[cfg(feature = "winder_linear")]
    "winder_linear",
    #[cfg(feature = "winder_linear_as_printed")]
    "winder_linear_as_printed",
    #[cfg(feature = "winder_linkage")]
    "winder_linkage",
    #[cfg(feature = "winder_nonlinear")]
    "winder_nonlinear",
];

/// The scene of a name, if its feature is on.
#[must_use]
#[allow(clippy::match_single_binding, reason = "features may leave no scene")]
#[rustfmt::skip]
pub fn find<R: Real>(name: &str) -> Option<&'static dyn Simulator<R>> {
    match name {
        #[cfg(feature = "bouncing_mass")]
        "bouncing_mass" => Some(&bouncing_mass::BouncingMass),
        #[cfg(feature = "contact_oscillator")]
        "contact_oscillator" => Some(&contact_oscillator::ContactOscillator),
        #[cfg(feature = "contact_oscillator_smooth")]
        "contact_oscillator_smooth" => {
            Some(&contact_oscillator_smooth::ContactOscillatorSmooth)
        }
        #[cfg(feature = "coulomb_oscillator")]
        "coulomb_oscillator" => Some(&coulomb_oscillator::CoulombOscillator),
        #[cfg(feature = "four_bar")]
        "four_bar" => Some(&four_bar::FourBar),
        #[cfg(feature = "motor_run_up")]
        "motor_run_up" => Some(&motor_run_up::MotorRunUp),
        #[cfg(feature = "motor_stationary_axes")]
        "motor_stationary_axes" => Some(&motor_stationary_axes::MotorStationaryAxes),
        #[cfg(feature = "pendulum_chain")]
        "pendulum_chain" => Some(&pendulum_chain::PendulumChain),
        #[cfg(feature = "pendulum_constrained")]
        "pendulum_constrained" => Some(&pendulum_constrained::PendulumConstrained),
        #[cfg(feature = "pendulum_relative")]
        "pendulum_relative" => Some(&pendulum_relative::PendulumRelative),
        #[cfg(feature = "saw_gin")]
        "saw_gin" => Some(&saw_gin::SawGin),
        #[cfg(feature = "saw_gin_as_printed")]
        "saw_gin_as_printed" => Some(&saw_gin_as_printed::SawGinAsPrinted),
        #[cfg(feature = "slider_crank")]
        "slider_crank" => Some(&slider_crank::SliderCrank),
        #[cfg(feature = "stick_slip")]
        "stick_slip" => Some(&stick_slip::StickSlip),
        #[cfg(feature = "stick_slip_smooth")]
        "stick_slip_smooth" => Some(&stick_slip_smooth::StickSlipSmooth),
        #[cfg(feature = "two_mass")]
        "two_mass" => Some(&two_mass::TwoMass),
        #[cfg(feature = "winder_full")]
        "winder_full" => Some(&winder_full::WinderFull),
        #[cfg(feature = "winder_holder_drop")]
        "winder_holder_drop" => Some(&winder_holder_drop::WinderHolderDrop),
        #[cfg(feature = "winder_linear")]
        "winder_linear" => Some(&winder_linear::WinderLinear),
        #[cfg(feature = "winder_linear_as_printed")]
        "winder_linear_as_printed" => {
            Some(&winder_linear_as_printed::WinderLinearAsPrinted)
        }
        #[cfg(feature = "winder_linkage")]
        "winder_linkage" => Some(&winder_linkage::WinderLinkage),
        #[cfg(feature = "winder_nonlinear")]
        "winder_nonlinear" => Some(&winder_nonlinear::WinderNonlinear),
        _ => None,
    }
}

/// The scene of a name in `f64`, compiled once and for all: who calls [`find`] compiles
/// all scenes within a crate of its own.
#[must_use]
pub fn find_f64(name: &str) -> Option<&'static dyn Simulator<f64>> {
    find(name)
}

/// Names of all scenes with fields, sorted.
#[rustfmt::skip]
pub const FIELD_NAMES: &[&str] = &[
    #[cfg(feature = "loom_drive")]
    "loom_drive",
    #[cfg(feature = "reed_beat_up")]
    "reed_beat_up",
    #[cfg(feature = "reed_beat_up_one_sided")]
    "reed_beat_up_one_sided",
    #[cfg(feature = "saw_gin_shaft")]
    "saw_gin_shaft",
    #[cfg(feature = "shaft_step_torque")]
    "shaft_step_torque",
    #[cfg(feature = "shaft_with_rotors")]
    "shaft_with_rotors",
];

/// The scene with fields of a name, not yet cut into elements.
#[must_use]
#[allow(clippy::match_single_binding, reason = "features may leave no scene")]
pub fn find_field<R: Real>(name: &str) -> Option<&'static dyn FieldScene<R>> {
    match name {
        #[cfg(feature = "loom_drive")]
        "loom_drive" => Some(&loom_drive::LoomDrive),
        #[cfg(feature = "reed_beat_up")]
        "reed_beat_up" => Some(&reed_beat_up::ReedBeatUp),
        #[cfg(feature = "reed_beat_up_one_sided")]
        "reed_beat_up_one_sided" => Some(&reed_beat_up_one_sided::ReedBeatUpOneSided),
        #[cfg(feature = "saw_gin_shaft")]
        "saw_gin_shaft" => Some(&saw_gin_shaft::SawGinShaft),
        #[cfg(feature = "shaft_step_torque")]
        "shaft_step_torque" => Some(&shaft_step_torque::ShaftStepTorque),
        #[cfg(feature = "shaft_with_rotors")]
        "shaft_with_rotors" => Some(&shaft_with_rotors::ShaftWithRotors),
        _ => None,
    }
}

/// The scene with fields of a name in `f64`, compiled once and for all.
#[must_use]
pub fn find_field_f64(name: &str) -> Option<&'static dyn FieldScene<f64>> {
    find_field(name)
}

/// It on numbers that carry derivatives, likewise.
#[must_use]
pub fn find_field_duals(name: &str) -> Option<&'static dyn FieldScene<Dual>> {
    find_field(name)
}
