//! The shared library within a functional mock-up unit (FMU): the C interface of FMI 3.0, Model
//! Exchange and Co-Simulation, for any model of Machinist.
//!
//! The library is the same in every archive. It reads the [`resource`]s beside it, a model file
//! and what of it are inputs, and compiles the model at once. Layers, from below:
//!
//! - [`variables`]: the model's quantities as FMI knows them, for the library and for who writes
//!   descriptions of archives;
//! - [`resource`]: files of an archive;
//! - [`instance`]: an instance with its modes, in safe Rust, by [`machinist::hosted`];
//! - [`registry`]: handles of instances, so that no host's pointer is ever followed;
//! - [`abi`]: the functions of `fmi3FunctionTypes.h`. Whatever goes wrong is a status and a
//!   message to the host's log.

pub mod abi;
pub mod instance;
pub mod registry;
pub mod resource;
pub mod variables;
