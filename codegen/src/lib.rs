//! The generator of Machinist: derives a [`Model`](machinist_model::Model) from spec text, and
//! emits a model as Rust or C99.
//!
//! A program that simulates machines of its own needs [`Build`] alone, in its build script. A program
//! that reads specs while it runs calls [`pipeline::generate`], and shows errors by
//! [`Diagnostics::render`](spec::diagnostic::Diagnostics::render). [`emit`] writes a model as source
//! code.
//!
//! [`pipeline`] is the sequence of stages; each takes the result of the preceding one.

mod build;
pub mod emit;
pub mod independent;
pub mod lower;
pub mod mechanics;
pub mod pipeline;
pub mod scene;
pub mod spatial;
pub mod spec;
pub mod write;

pub use build::{Build, BuildError};
