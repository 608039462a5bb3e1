//! Lagrangian specs of machines to fast, checked Rust simulators.
//!
//! Start with [`Simulation`]; the scenes are in [`machinist_scenes`]. The README
//! shows the whole of it:
#![cfg_attr(all(feature = "diffsol", feature = "scenes", feature = "sweep"), doc = include_str!("../README.md"))]
//!
//! Features leave out what a program does not need: methods by family (`diffsol`,
//! `implicit`), built-in scenes (`scenes`), linear analysis (`linear`), the checks
//! against closed forms (`verify`), many variants at once (`sweep`), plots (`plot`) and
//! the command line (`cli`).
//! Without any of them, what remains runs any simulator by explicit methods.
#![forbid(unsafe_code)]

#[cfg(feature = "verify")]
pub mod closed_form;
#[cfg(feature = "linear")]
pub mod complex_step;
pub mod constraints;
#[cfg(feature = "verify")]
pub mod double_double;
pub mod error;
pub mod field;
#[cfg(feature = "cli")]
pub mod interpreted;
#[cfg(feature = "sweep")]
pub mod lanes;
#[cfg(feature = "verify")]
pub mod ledger;
#[cfg(feature = "linear")]
pub mod linear_analysis;
pub mod method;
#[cfg(feature = "cli")]
pub mod object;
#[cfg(feature = "plot")]
pub mod plot;
#[cfg(feature = "verify")]
pub mod reed_study;
pub mod simulate;
#[cfg(feature = "verify")]
pub mod stability;
#[cfg(feature = "sweep")]
pub mod sweep;
pub mod trajectory;
#[cfg(feature = "verify")]
pub mod verify;
#[cfg(feature = "verify")]
pub mod winder_walk;
#[cfg(feature = "verify")]
pub mod work_precision;

pub use error::SimulateError;
pub use field::{Discretisation, FieldSimulator};
pub use method::Method;
pub use simulate::Simulation;
#[cfg(feature = "sweep")]
pub use sweep::Sweep;
pub use trajectory::Trajectory;
