//! The half of Machinist that derives: spec text to a [`Model`](machinist_model::Model), and
//! a model to emitted Rust.
//!
//! The straight line is [`pipeline`]; each stage takes the previous one's type.

mod build;
pub mod emit;
pub mod independent;
pub mod lower;
pub mod mechanics;
pub mod pipeline;
pub mod scene;
pub mod spec;
pub mod write;

pub use build::{Build, BuildError};
