//! The program `machinist`: command line, report, plots.
//!
//! Without the feature `derive` it reads no specs, needs no computer algebra, and runs built-in
//! scenes and model files.
//!
//! This is a library only for its tests. Other programs should depend on `machinist`.

mod cli;
mod config;
#[cfg(feature = "derive")]
mod deriving;
#[cfg(feature = "derive")]
mod explain;
mod failure;
#[cfg(feature = "derive")]
mod fmu;
#[cfg(feature = "derive")]
mod freeze;
mod interrupt;
mod matrices;
mod number;
#[cfg(feature = "derive")]
pub mod object;
mod parquet;
pub mod plot;
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
pub use config::KEYS as CONFIGURATION_KEYS;
#[cfg(feature = "derive")]
pub use report::Headless;
