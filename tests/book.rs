//! Rust of the book's chapters, compiled and run as documentation tests.

/// Calling simulators.
#[cfg(doctest)]
#[doc = include_str!("../docs/book/src/rust.md")]
pub struct FromRust;

/// Derivatives of runs.
#[cfg(doctest)]
#[doc = include_str!("../docs/book/src/designs.md")]
pub struct Designs;
