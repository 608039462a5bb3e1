//! Lagrangian specs of machines to fast, checked Rust simulators.
pub mod closed_form;
