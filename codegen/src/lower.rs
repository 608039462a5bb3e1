//! Lowering of linearized equations to a model, with one tape per function.

mod along;
pub mod angles;
pub mod blocks;
mod checks;
pub mod density;
mod describe;
pub mod excitation;
mod factor;
mod implicit;
mod kinks;
mod model;
mod needed;
mod nonzeros;
mod reactions;
mod share;
mod shared_forces;
pub mod structure;
pub mod substitute;

pub use model::lower;
