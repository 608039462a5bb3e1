//! Expressions, and algebra on them: what equations of motion are derived by.
//!
//! [`expr`] has expressions, the graph of their operations, and what is asked of them; [`cas`]
//! works them out, by Symbolica or by our own algebra.
//!
//! Excluded: names to look up, spans, units, scenes, mechanics.

pub mod cas;
pub mod expr;
pub mod faults;
