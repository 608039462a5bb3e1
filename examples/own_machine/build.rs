//! Emits the simulator of `specs/own_machine.toml` to `OUT_DIR/own_machine.rs`.

use machinist_codegen::{Build, BuildError};

fn main() -> Result<(), BuildError> {
    let build = Build::new().scene("specs/own_machine.toml");
    build.compile()
}
