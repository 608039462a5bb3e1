//! Emits the simulator of `specs/drive.toml` to `OUT_DIR/drive.rs`.

fn main() -> Result<(), machinist_codegen::BuildError> {
    machinist_codegen::Build::new().scene("specs/drive.toml").compile()
}
