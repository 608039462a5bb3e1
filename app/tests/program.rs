//! Program as seen by users, with one module for each subject; `cargo test -p machinist-app --test
//! program deriving::` runs one.

mod accessible;
mod anywhere;
mod book;
mod c99;
mod campbell;
mod cli;
mod cli_sweep;
mod configuration;
mod csv;
mod cycle;
mod deriving;
mod fit;
mod fmu;
mod fuzz;
mod help;
mod import;
mod improve;
mod linearize;
mod lists;
mod live;
mod options;
mod process;
mod reduced;
mod redundant;
mod refusals;
mod report;
mod scatter;
mod schema;
mod shaken;
mod spectrum;
mod symbolica;
mod tables;
mod trajectory;
mod verify;
mod watch;
