//! Linearized equations to a model: one tape for each function.

pub mod angles;
pub mod density;
pub mod excitation;
mod factor;
mod model;
pub mod structure;

pub use model::lower;
