//! Fast, checked Rust simulators of machines, from Lagrangian specs.
//!
//! Start with [`Simulation`], which runs any `Simulator` of [`machinist_contract`]: emitted code, a
//! model file, or one written by hand. The README shows a complete example:
#![cfg_attr(all(feature = "diffsol", feature = "sweep"), doc = include_str!("../README.md"))]
#![cfg_attr(docsrs, feature(doc_cfg))]
// An example of the README names its file, for the test that runs it.
#![allow(rustdoc::invalid_codeblock_attributes)]
//!
//! Features select what a program needs: families of methods (`diffsol`, `implicit`), linear
//! analysis (`linear`), runs of many variants (`sweep`), estimation of parameters from measured
//! runs (`fit`). Without any of them, the crate runs any simulator by explicit methods.

#[cfg(feature = "linear")]
pub mod complex_step;
pub mod constraints;
mod dense;
pub mod error;
pub mod error_estimate;
pub mod estimator;
pub mod fatigue;
pub mod field;
#[cfg(feature = "fit")]
pub mod fit;
mod held;
pub mod hosted;
#[cfg(feature = "fit")]
pub mod improve;
#[cfg(feature = "sweep")]
pub mod lanes;
mod legendre;
#[cfg(feature = "linear")]
pub mod linear_analysis;
pub mod method;
mod method_table;
#[cfg(feature = "linear")]
pub mod periodic;
mod scales;
#[cfg(all(feature = "fit", feature = "sweep"))]
pub mod scatter;
pub mod simulate;
#[cfg(any(feature = "fit", feature = "linear"))]
mod sorting;
#[cfg(feature = "sweep")]
pub mod sweep;
#[cfg(feature = "sweep")]
mod threads;
pub mod trajectory;

/// Matrices and complex numbers of linear analysis and fits. A new major version of it is a breaking
/// change of this crate.
pub use nalgebra;

pub use error::SimulateError;
pub use field::{Discretisation, FieldSimulator};
pub use method::Method;
pub use simulate::Simulation;
#[cfg(feature = "sweep")]
pub use sweep::Sweep;
pub use trajectory::Trajectory;
