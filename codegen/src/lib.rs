//! Build-time half of Machinist: spec text to emitted Rust.
pub mod emit;
pub mod evaluate;
pub mod expr;
pub mod program;
pub mod system;
pub mod tape;
pub mod write;
