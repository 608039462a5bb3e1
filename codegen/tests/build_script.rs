//! Tests of scenes emitted by build scripts.

use std::fs;
use std::path::{Path, PathBuf};

use machinist_codegen::{Build, BuildError};

fn own_machine() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/own_machine/specs/own_machine.toml")
}

#[test]
fn a_scene_is_emitted_under_its_name_and_touched_only_if_it_changes() {
    let folder = tempfile::tempdir().expect("a folder");
    let build = Build::new().scene(own_machine()).out_dir(folder.path());
    build.compile().expect("a scene without mistakes");
    let emitted = folder.path().join("own_machine.rs");
    let text = fs::read_to_string(&emitted).expect("the emitted file");
    assert!(syn::parse_file(&text).is_ok());
    assert!(text.contains("use ::machinist_contract::{"));
    assert!(!text.contains(env!("CARGO_MANIFEST_DIR")), "no absolute path");

    let long_ago = std::time::SystemTime::UNIX_EPOCH + std::time::Duration::from_secs(86400);
    let file = fs::File::options().write(true).open(&emitted).expect("the emitted file");
    file.set_modified(long_ago).expect("a time");
    build.compile().expect("the same again");
    let modified = fs::metadata(&emitted).expect("the emitted file").modified().expect("a time");
    assert_eq!(modified, long_ago);
}

#[test]
fn a_mistake_is_reported_for_people_and_writes_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let specs = tempfile::tempdir().expect("a folder");
    let wrong = specs.path().join("wrong.toml");
    let text = fs::read_to_string(own_machine()).expect("the spec");
    fs::write(&wrong, text.replace("inertia*omega^2/2 +", "inertia*omga^2/2 +")).expect("written");
    let build = Build::new().scene(own_machine()).scene(wrong).out_dir(folder.path());
    let error = build.compile().expect_err("a name that is not known");
    let report = format!("{error:?}");
    assert!(report.contains("inertia*omga^2/2") && report.contains("omga"), "{report}");
    assert_eq!(fs::read_dir(folder.path()).expect("the folder").count(), 0);
}

#[test]
fn two_scenes_of_one_name_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let error =
        Build::new().scenes([own_machine(), own_machine()]).out_dir(folder.path()).compile();
    assert!(matches!(error, Err(BuildError::NamedTwice { ref scene }) if scene == "own_machine"));
}
