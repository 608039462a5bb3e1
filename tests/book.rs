//! Rust code of the book's chapters, compiled and run as documentation tests.
// Blocks name their files; see the tests of the book.
#![allow(rustdoc::invalid_codeblock_attributes)]

/// Calling simulators.
#[cfg(doctest)]
#[doc = include_str!("../docs/book/src/rust.md")]
pub struct FromRust;

/// Derivatives of runs.
#[cfg(doctest)]
#[doc = include_str!("../docs/book/src/designs.md")]
pub struct Designs;
