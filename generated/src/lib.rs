//! Simulators emitted by Machinist.
//!
//! The modules under [`scenes`] are emitted from the specs in `specs/` by
//! `machinist gen`; they need [`machinist_contract`] and nothing else: `no_std`, no
//! allocation. Each has a Cargo feature of its own.
#![no_std]
#![forbid(unsafe_code)]

pub mod scenes;

/// The scene of a name as the trait object that is expected of it, of those that series carry: without
/// events and corners. All scenes have to be there; who makes trait objects of one compiles
/// what that trait asks for, and of [`scenes::find`] all of the contract.
#[macro_export]
macro_rules! find_carried {
    ($name:expr) => {
        match $name {
            "contact_oscillator_smooth" => {
                Some(&$crate::scenes::contact_oscillator_smooth::ContactOscillatorSmooth)
            }
            "motor_run_up" => Some(&$crate::scenes::motor_run_up::MotorRunUp),
            "motor_stationary_axes" => {
                Some(&$crate::scenes::motor_stationary_axes::MotorStationaryAxes)
            }
            "pendulum_chain" => Some(&$crate::scenes::pendulum_chain::PendulumChain),
            "pendulum_relative" => Some(&$crate::scenes::pendulum_relative::PendulumRelative),
            "saw_gin" => Some(&$crate::scenes::saw_gin::SawGin),
            "saw_gin_as_printed" => Some(&$crate::scenes::saw_gin_as_printed::SawGinAsPrinted),
            "two_mass" => Some(&$crate::scenes::two_mass::TwoMass),
            "winder_linear" => Some(&$crate::scenes::winder_linear::WinderLinear),
            "winder_linear_as_printed" => {
                Some(&$crate::scenes::winder_linear_as_printed::WinderLinearAsPrinted)
            }
            "winder_nonlinear" => Some(&$crate::scenes::winder_nonlinear::WinderNonlinear),
            _ => None,
        }
    };
}
