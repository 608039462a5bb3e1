//! Lagrangian specs of machines to fast, checked Rust simulators.

#[cfg(feature = "cli")]
pub mod interpreted;
