//! The generator of Machinist: derives a [`Model`](machinist_model::Model) from spec text, and
//! emits a model as Rust or C99.
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
