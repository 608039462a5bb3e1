//! Lagrangian specs of machines to fast, checked Rust simulators.
//!
//! Start with [`Simulation`], which runs any `Simulator` of
//! [`machinist_contract`]: emitted code, a model file, one written by hand. The README
//! shows the whole of it:
#![cfg_attr(all(feature = "diffsol", feature = "sweep"), doc = include_str!("../README.md"))]
//!
//! Features leave out what a program does not need: methods by family (`diffsol`,
//! `implicit`), linear analysis (`linear`), many variants at once (`sweep`), parameters from
//! measured runs (`fit`).
//! Without any of them, what remains runs any simulator by explicit methods.

#[cfg(feature = "linear")]
pub mod complex_step;
pub mod constraints;
mod dense;
pub mod error;
pub mod error_estimate;
pub mod field;
#[cfg(feature = "fit")]
pub mod fit;
pub mod hosted;
#[cfg(feature = "fit")]
pub mod improve;
#[cfg(feature = "sweep")]
pub mod lanes;
#[cfg(feature = "linear")]
pub mod linear_analysis;
pub mod method;
mod scales;
pub mod simulate;
#[cfg(any(feature = "fit", feature = "linear"))]
mod sorting;
#[cfg(feature = "sweep")]
pub mod sweep;
#[cfg(feature = "sweep")]
mod threads;
pub mod trajectory;

pub use error::SimulateError;
pub use field::{Discretisation, FieldSimulator};
pub use method::Method;
pub use simulate::Simulation;
#[cfg(feature = "sweep")]
pub use sweep::Sweep;
pub use trajectory::Trajectory;
