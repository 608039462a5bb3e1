//! Shared library within a functional mock-up unit (FMU): the C interfaces of FMI 2.0 and 3.0,
//! Model Exchange and Co-Simulation, for any model of Machinist.
//!
//! The library is the same in every archive. It reads the [`resource`]s beside it, a model file and
//! the settings of the export, and JIT-compiles the model. Layers, from below:
//!
//! - [`variables`]: the model's quantities as FMI knows them, for the library and for writing the
//!   descriptions of archives;
//! - [`resource`]: files of an archive;
//! - [`instance`]: an instance with its modes, in safe Rust, by [`machinist::hosted`];
//! - [`registry`]: handles of instances, so that no pointer of a host is ever followed;
//! - [`abi`]: the functions of `fmi3FunctionTypes.h` and `fmi2FunctionTypes.h`. Every failure becomes a status and a message
//!   in the host's log.

pub mod abi;
pub mod instance;
pub mod registry;
pub mod resource;
pub mod variables;
