//! The program `machinist`: command line, report, plots.
//!
//! A library only so that its parts can be tested; other programs want `machinist`.

mod cli;
mod deriving;
mod explain;
mod failure;
mod freeze;
pub mod object;
pub mod plot;
mod progress;
mod report;

pub use cli::main;
