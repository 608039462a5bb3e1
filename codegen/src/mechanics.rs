//! Mechanics: equations of motion of a Lagrangian system, their reduction, and their partial
//! derivatives.

mod bodies;
pub mod constraint;
pub mod density;
pub mod dependencies;
pub mod lagrange;
pub mod linearize;
pub mod reduce;
pub mod state;
#[cfg(test)]
mod tests;
