//! The emitted scenes, eight variants side by side, for sweeps.
//!
//! Emitted code is generic, and compiled where it is asked for on some kind of number, as that
//! crate is compiled. Here that is done once, optimised, for programs that are not; and no more of
//! it than variants side by side ask for.
#![forbid(unsafe_code)]

use machinist::lanes::F64x8;
use machinist_contract::SideBySide;
use machinist_scenes::scenes::{
    contact_oscillator_smooth, motor_run_up, motor_stationary_axes, pendulum_chain,
    pendulum_relative, saw_gin, saw_gin_as_printed, two_mass, winder_linear, winder_nonlinear,
};

/// The scene of a name, eight at a time, if variants of it may go so: by series, without events and
/// corners.
#[must_use]
pub fn find(name: &str) -> Option<&'static dyn SideBySide<F64x8>> {
    #[cfg(feature = "bench")]
    if let Some(scene) = find_bench(name) {
        return Some(scene);
    }
    match name {
        "contact_oscillator_smooth" => Some(&contact_oscillator_smooth::ContactOscillatorSmooth),
        "motor_run_up" => Some(&motor_run_up::MotorRunUp),
        "motor_stationary_axes" => Some(&motor_stationary_axes::MotorStationaryAxes),
        "pendulum_chain" => Some(&pendulum_chain::PendulumChain),
        "pendulum_relative" => Some(&pendulum_relative::PendulumRelative),
        "saw_gin" => Some(&saw_gin::SawGin),
        "saw_gin_as_printed" => Some(&saw_gin_as_printed::SawGinAsPrinted),
        "two_mass" => Some(&two_mass::TwoMass),
        "winder_linear" => Some(&winder_linear::WinderLinear),
        "winder_nonlinear" => Some(&winder_nonlinear::WinderNonlinear),
        _ => None,
    }
}

#[cfg(feature = "bench")]
fn find_bench(name: &str) -> Option<&'static dyn SideBySide<F64x8>> {
    use machinist_scenes::bench::{m1, m2, m3_10, m4_7, m5, m6_2, m6_5, m6_10};
    match name {
        "m1" => Some(&m1::M1),
        "m2" => Some(&m2::M2),
        "m3_10" => Some(&m3_10::M310),
        "m4_7" => Some(&m4_7::M47),
        "m5" => Some(&m5::M5),
        "m6_2" => Some(&m6_2::M62),
        "m6_5" => Some(&m6_5::M65),
        "m6_10" => Some(&m6_10::M610),
        _ => None,
    }
}
