//! Machines of one's own, for tests of the runtime: from a spec's text to a simulator.

use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_model::ModelSimulator;

/// The scene of a spec in one file.
pub fn of_text(text: &str, keep: Keep) -> ModelSimulator {
    of_files(&[("scene.toml", text)], keep)
}

/// The scene of the first of some files, which stand in one folder.
pub fn of_files(files: &[(&str, &str)], keep: Keep) -> ModelSimulator {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in files {
        std::fs::write(folder.path().join(name), text).expect("written");
    }
    match pipeline::generate(&folder.path().join(files[0].0), keep) {
        Ok(model) => ModelSimulator::new(model),
        Err(errors) => panic!("{}", errors.render()),
    }
}
