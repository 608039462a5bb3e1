//! What simulators emitted by Machinist and those who run them agree on.
//!
//! This crate is `no_std`, allocates nothing and depends on nothing but `core`
//! (and `libm` where there is no `std`).
//!
//! Signs and names, fixed once: a scene has `n` generalized coordinates `q`
//! with velocities `q'`, and `m` first-order states `z`. Its state is
//!
//! ```text
//! y = [q_1 .. q_n, q'_1 .. q'_n, z_1 .. z_m]        length 2 n + m
//! M(q, t) q'' = f(q, q', z, t)                      z' = h(q, q', z, t)
//! y' = [q', M^-1 f, h]
//! ```
//!
//! less what the scene's outputs do not need: a position that nothing depends on
//! is not in the state, of positions that matter only relative to each other there
//! are only the relative ones, and what is only integrated for an output stands
//! last. [`Shape`] counts, and [`Describe::state`] names what there is.
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
    Constraint, Describe, Direction, Energy, Event, PowerBalance, Quantity, Refusal, RunDefaults,
    Shape, SideBySide, Simulator, SparsityPattern, StateKind, jacobians_apart,
};
pub use dual::{Derivatives, Dual, DualFunction};
pub use pair::F64x2;
pub use real::Real;
pub use sources::SOURCES;
pub use table::CubicTable;
