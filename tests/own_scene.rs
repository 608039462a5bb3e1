//! Machines of one's own, for tests of the runtime: from a spec's text to a simulator.

use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_model::ModelSimulator;

/// The scene of a spec in one file.
pub fn of_text(text: &str, keep: Keep) -> ModelSimulator {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text).expect("written");
    match pipeline::generate(&path, keep) {
        Ok(model) => ModelSimulator::new(model),
        Err(errors) => panic!("{}", errors.render()),
    }
}
