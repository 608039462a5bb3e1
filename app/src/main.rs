//! The `machinist` program.

fn main() -> std::process::ExitCode {
    machinist_app::main()
}
