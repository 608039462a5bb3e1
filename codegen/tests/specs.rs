//! Good and bad specs, one file per case, with the composed system or the report beside it as a
//! snapshot.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::common::describe;
use machinist_codegen::scene::compose;
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_codegen::spec::diagnostic::Diagnostics;
use machinist_codegen::spec::load_scene;

/// Time within which a mistake is found, also on a busy machine. An endless search fails.
const PATIENCE: Duration = Duration::from_secs(30);

fn read(path: &Path) -> Result<LagrangianSystem, Diagnostics> {
    compose(&load_scene(path)?)
}

fn folder(kind: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(kind)
}

/// Returns the specs of a folder, sorted, with their names.
fn specs(kind: &str) -> Vec<(String, PathBuf)> {
    let entries = std::fs::read_dir(folder(kind)).expect("folder of specs");
    let paths = entries.map(|entry| entry.expect("entry").path());
    let mut specs: Vec<(String, PathBuf)> = paths
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .map(|path| (path.file_stem().expect("stem").to_string_lossy().into_owned(), path))
        .collect();
    specs.sort();
    specs
}

/// Returns names, sizes and times of change of all files in a folder.
fn contents(folder: &Path) -> Vec<(PathBuf, u64, std::time::SystemTime)> {
    let entries = std::fs::read_dir(folder).expect("folder");
    let mut contents: Vec<_> = entries
        .map(|entry| {
            let entry = entry.expect("entry");
            let metadata = entry.metadata().expect("metadata");
            (entry.path(), metadata.len(), metadata.modified().expect("time"))
        })
        .collect();
    contents.sort();
    contents
}

/// Returns the report of a bad spec, found in time and without a panic.
fn report(path: &Path) -> String {
    let start = Instant::now();
    let result = read(path);
    let elapsed = start.elapsed();
    let report = result.expect_err(&format!("{} is refused", path.display())).render();
    assert!(elapsed < PATIENCE, "{} took {elapsed:?}", path.display());
    report
}

#[test]
fn bad_specs_are_refused_with_file_line_term_and_hint() {
    let before = contents(&folder("fail"));
    let specs = specs("fail");
    assert!(specs.len() >= 147, "{} bad specs", specs.len());
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("fail");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        for (name, path) in &specs {
            let report = report(path);
            assert!(!report.contains(env!("CARGO_MANIFEST_DIR")), "{name} tells an absolute path");
            insta::assert_snapshot!(name.as_str(), report);
        }
    });
    let after: Vec<_> = contents(&folder("fail"));
    let specs_only = |contents: Vec<(PathBuf, u64, std::time::SystemTime)>| {
        let kept = contents.into_iter().filter(|(path, ..)| {
            let name = path.to_string_lossy();
            name.ends_with(".toml") || name.ends_with(".csv")
        });
        kept.collect::<Vec<_>>()
    };
    assert_eq!(specs_only(before), specs_only(after), "reading writes nothing");
}

#[test]
fn good_specs_compose_to_the_system_on_record() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("pass");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        for (name, path) in specs("pass") {
            match read(&path) {
                Ok(system) => insta::assert_snapshot!(name.as_str(), describe(&system)),
                Err(errors) => panic!("{name}: {}", errors.render()),
            }
        }
    });
}

#[test]
fn scenes_of_the_repository_compose() {
    let scenes = specs("../../specs/scenes");
    let bench = specs("../../specs/scenes/bench");
    assert!(!scenes.is_empty() && !bench.is_empty());
    for (_, path) in scenes.into_iter().chain(bench) {
        if let Err(errors) = read(&path) {
            panic!("{}: {}", path.display(), errors.render());
        }
    }
}
