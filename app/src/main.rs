//! The `machinist` model.

mod cli;
mod explain;
mod failure;
mod freeze;
mod object;
mod plot;
mod progress;
mod report;

fn main() -> std::process::ExitCode {
    cli::main()
}
