//! A second derivation, independent of the first: the motion of a composed scene by
//! derivatives of its Lagrangian as numbers, held against a simulator of the same scene.
//!
//! Of the line from spec to model it shares what reads and joins a spec, nothing after that:
//! no computer algebra, no mechanics, no reduction, no graph, no factorization. What is wrong
//! in one of those shows as a difference; what is wrong in a spec does not.
//!
//! Excluded: Symbolica (it never runs here), speed, fields (they are cut into coordinates
//! before, by [`elements`]).

mod compare;
pub mod elements;
mod formula;
mod hyper;
mod lift;
mod motion;
mod random;
mod rounded;
mod solve;

#[cfg(test)]
mod faulty;
#[cfg(test)]
mod systems;
#[cfg(test)]
mod tests;

pub use compare::{At, Comparison, Deviation, Unlike};
