//! A derived machine as plain data.
//!
//! A [`Model`] is the result of derivation and the input of a run: names, units, shapes and
//! patterns, and one [`Tape`] of arithmetic for each function of a simulator. It can be [written to
//! a file](mod@file) and read anywhere. Neither the spec nor the computer algebra that derived it
//! is needed to run it.
//!
//! Excluded: symbols to look up, expressions, any type of a computer algebra system, integration
//! methods.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod check;
#[cfg(feature = "compiled")]
pub mod compiled;
mod divide;
mod drawing;
mod elimination;
pub mod evaluate;
mod excitation;
mod facts;
mod field;
pub mod file;
pub mod fingerprint;
pub mod functions;
pub mod hoist;
mod lanes;
mod live;
mod model;
mod motion;
mod names;
mod prune;
mod reduction;
mod room;
pub mod series;
mod simulator;
#[cfg(any(feature = "compiled", feature = "wasm"))]
mod straight;
mod tangent;
mod tape;
mod validate;
#[cfg(feature = "wasm")]
pub mod wasm;

pub use check::{Check, ClosedForm, Reference};
pub use divide::Division;
pub use drawing::{Drawing, Element, ElementKind};
pub use elimination::Elimination;
pub use excitation::Excitation;
pub use field::{Attachment, FieldModel, LocalForces};
pub use lanes::{F64x2, Lane};
pub use model::{
    Bound, Constraint, Coordinate, Event, Freeze, MatrixTape, Model, Parameter, Relation,
    Requirement, SparsityPattern, State, StateKind,
};
pub use motion::{Motion, Solve, SolveStep};
pub use names::{Direction, Name, Place, Quantity, RunDefaults, SourceFile, Table};
pub use prune::{Dependence, needed_nodes, operations, reachable, reachable_at};
pub use reduction::{LeftOut, Reduction, What, Why};
pub use simulator::{ModelSimulator, Running};
pub use tangent::Directions;
pub use tape::{Function, Node, NodeId, Op, OpKey, TableId, Tape};
pub use validate::Malformed;
