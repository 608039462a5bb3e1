//! A second, independent derivation: the motion of a composed scene by numerical derivatives of
//! its Lagrangian, compared with a simulator of the same scene.
//!
//! It shares only the reading and composing of specs with the pipeline: no computer algebra, no
//! mechanics, no reduction, no graph, no factorization. A mistake in one of those shows as a
//! difference; a mistake in a spec does not.
//!
//! Excluded: Symbolica (it never runs here), speed, and fields (which [`elements`] divides into
//! coordinates beforehand).

mod compare;
pub mod elements;
mod formula;
mod hyper;
mod least;
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
