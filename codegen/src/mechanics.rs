//! Mechanics: a Lagrangian system to equations of motion, to what is needed of them, to
//! their partial derivatives.

pub mod constraint;
pub mod density;
pub mod dependencies;
pub mod lagrange;
pub mod linearize;
pub mod reduce;
pub mod state;
#[cfg(test)]
mod tests;
