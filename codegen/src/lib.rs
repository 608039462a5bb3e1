//! Build-time half of Machinist: spec text to emitted Rust.
pub mod diagnostic;
pub mod dimension;
pub mod expr;
pub mod program;
pub mod scene;

pub mod spec;
pub mod system;
pub mod tape;
