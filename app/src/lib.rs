//! The program `machinist`: command line, report, plots.
//!
//! Without the feature `derive` it reads no specs, needs no computer algebra, and runs built-in
//! scenes and model files.
//!
//! This is a library for its tests and for the Python package ([`embedded`]). Other programs should
//! depend on `machinist`.

mod cli;
mod codes;
mod config;
#[cfg(feature = "derive")]
mod deriving;
#[cfg(feature = "derive")]
pub mod embedded;
#[cfg(feature = "derive")]
mod explain;
mod failure;
#[cfg(feature = "derive")]
mod fields;
#[cfg(feature = "derive")]
mod fmu;
#[cfg(feature = "derive")]
mod freeze;
mod interrupt;
mod matrices;
mod number;
#[cfg(feature = "derive")]
pub mod object;
mod orders;
mod parquet;
pub mod plot;
#[cfg(feature = "derive")]
mod program;
mod progress;
#[cfg(feature = "derive")]
mod report;
#[cfg(feature = "derive")]
mod robot;
mod rounding;
mod spec_source;
mod spectrum;
mod trials;
#[cfg(feature = "derive")]
mod watch;

pub use cli::{command, main};
pub use codes::codes as error_codes;
pub use config::KEYS as CONFIGURATION_KEYS;
#[cfg(feature = "derive")]
pub use failure::Trouble;
#[cfg(feature = "derive")]
pub use report::{Headless, HeadlessDrawing};
