//! The `machinist` program.

mod cli;
mod explain;
mod report;

fn main() -> std::process::ExitCode {
    cli::main()
}
