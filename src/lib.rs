//! Lagrangian specs of machines to fast, checked Rust simulators.
//!
//! Start with [`Simulation`]; the scenes are in [`machinist_scenes`]. The README
//! shows the whole of it:
#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

pub mod closed_form;
pub mod complex_step;
pub mod error;
pub mod field;
#[cfg(feature = "cli")]
pub mod interpreted;
pub mod ledger;
pub mod linear_analysis;
pub mod method;
#[cfg(feature = "plot")]
pub mod plot;
pub mod reed_study;
pub mod simulate;
pub mod trajectory;
pub mod verify;
pub mod winder_walk;
pub mod work_precision;

pub use error::SimulateError;
pub use field::{Discretisation, FieldSimulator};
pub use method::Method;
pub use simulate::Simulation;
pub use trajectory::Trajectory;
