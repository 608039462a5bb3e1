//! Expressions, and the algebra that derives equations of motion from them.
//!
//! [`expr`] has expressions, the graph of their operations, and analyses of them; [`cas`]
//! differentiates and simplifies them, with Symbolica or with our own algebra.
//!
//! Excluded: names to look up, spans, units, scenes, mechanics.

pub mod cas;
pub mod expr;
pub mod faults;
pub mod interrupt;
