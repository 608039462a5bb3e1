//! The contract between simulators emitted by Machinist and the programs that run them.
//!
//! This crate is `no_std`, allocates nothing and depends only on `core` (and on `libm` where
//! there is no `std`).
//!
//! Signs and names are fixed for all simulators. A scene has `n` generalized coordinates `q` with
//! velocities `q'`, and `m` first-order states `z`. Its state is
//!
//! ```text
//! y = [q_1 .. q_n, q'_1 .. q'_n, z_1 .. z_m]        length 2 n + m
//! M(q, t) q'' = f(q, q', z, t)                      z' = h(q, q', z, t)
//! y' = [q', M^-1 f, h]
//! ```
//!
//! without the entries that the scene's outputs do not need. A position that nothing depends on
//! is left out, and positions that matter only relative to each other are replaced by their
//! differences. States that are only integrated for an output come last. [`Shape`] counts the
//! entries, and [`Describe::state`] names them.
#![no_std]
#![forbid(unsafe_code)]
#[cfg(feature = "std")]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("elementary functions come from `std` or `libm`: turn on one of these features");

mod contract;
pub mod digits;
mod dual;
mod elements;
pub mod elimination;
pub mod emitted;
pub mod exponential;
pub mod field;
mod field_scene;
pub mod fixed_step;
mod functions;
pub mod implicit;
mod include;
mod interval;
pub mod linear;
mod pair;
mod real;
mod side_by_side;
mod simulator;
pub mod sine;
mod sources;
mod table;
pub mod taylor;

pub use contract::{
    Constraint, Describe, Direction, Energy, Event, Jumps, PowerBalance, Quantity, Reader, Refusal,
    Relation, RelationKind, RunDefaults, Shape, SideBySide, Simulator, SparsityPattern, StateKind,
    jacobians_apart,
};
pub use dual::{Derivatives, Dual, DualFunction};
pub use interval::{Interval, Ranges};
pub use pair::F64x2;
pub use real::Real;
pub use sources::SOURCES;
pub use table::CubicTable;
