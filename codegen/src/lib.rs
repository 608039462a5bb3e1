//! Build-time half of Machinist: spec text to emitted Rust.
//!
//! The straight line is [`pipeline`]; each stage takes the previous one's type.
pub mod abbreviate;
pub mod angles;
mod build;
pub mod cas;
pub mod constraint;
pub mod density;
pub mod dependencies;
pub mod diagnostic;
pub mod dimension;
pub mod document;
pub mod emit;
pub mod evaluate;
pub mod expr;
pub mod factor;
mod features;
pub mod fold;
pub mod hoist;
pub mod lagrange;
pub mod linear;
pub mod linearize;
pub mod lower;
pub mod pipeline;
pub mod program;
pub mod prune;
pub mod reduce;
pub mod scene;
pub mod spec;
mod stack;
pub mod state;
pub mod structure;
pub mod system;
pub mod tape;
pub mod taylor;
pub mod trigonometry;
pub mod write;

pub use build::{Build, BuildError};
