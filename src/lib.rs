//! Fast, checked Rust simulators of machines, from Lagrangian specs.
//!
//! Start with [`Simulation`], which runs any `Simulator` of [`machinist_contract`]: emitted code, a
//! model file, or one written by hand. Its result is a [`Trajectory`]:
//!
//! ```
//! use machinist::{Method, Simulation};
//! # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/oscillator.rs"));
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//!
//! let run = Simulation::new(&Oscillator).method(Method::Dop853).until(2.0).points(201).run()?;
//! run.write_csv(std::io::sink())?;
//! assert_eq!(run.times.len(), run.column("rotor.angle").expect("a state").len());
//! # Ok(())
//! # }
//! ```
//!
//! | to | use |
//! | --- | --- |
//! | run a machine, with its estimated error | [`Simulation`], [`error_estimate`] |
//! | run it in pieces, from a host or a controller | [`hosted`] |
//! | find equilibria, eigenmodes, responses, state-space models, regulators | `linear_analysis` |
//! | find periodic motions and their stability | `periodic` |
//! | differentiate a run by parameters | [`Simulation::sensitivities`], [`Simulation::gradient`] |
//! | fit parameters to measured runs | `fit` |
//! | optimise parameters under constraints | `improve` |
//! | run many variants | `sweep`, `scatter` |
//! | count load cycles | [`fatigue`] |
//! | estimate states from measurements | [`estimator`] |
//!
//! The README shows how a machine is described. Specs become models by the crate
//! `machinist-codegen`, models become simulators by `machinist-model`.
//!
//! Features select what a program needs: families of methods (`diffsol`, `implicit`), linear
//! analysis (`linear`), runs of many variants (`sweep`), estimation of parameters from measured
//! runs (`fit`). Without any of them, the crate runs any simulator by explicit methods.
#![cfg_attr(docsrs, feature(doc_cfg))]

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

/// The examples of the README.
#[cfg(all(doctest, feature = "diffsol", feature = "sweep"))]
#[doc = include_str!("../README.md")]
// An example names its file, for the test that runs it.
#[allow(rustdoc::invalid_codeblock_attributes)]
struct Readme;
