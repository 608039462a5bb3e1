//! Lagrangian specs of machines to fast, checked Rust simulators.
#![forbid(unsafe_code)]

#[cfg(feature = "cli")]
pub mod interpreted;
