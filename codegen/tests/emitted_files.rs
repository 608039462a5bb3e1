//! Writing and checking emitted files.

use std::fs;
use std::path::Path;

use crate::support::{oddities, pendulum};
use machinist_codegen::write::{
    Freshness, Mode, WriteError, Written, check, emit_scenes, write_if_changed, write_within,
};

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| {
        let name = entry.expect("an entry").file_name();
        name.into_string().expect("a plain name")
    });
    let mut names: Vec<String> = entries.collect();
    names.sort();
    names
}

#[test]
fn equal_text_leaves_a_file_untouched() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.rs");
    assert_eq!(write_if_changed(&path, "one").expect("written"), Written::Created);
    let long_ago = std::time::SystemTime::UNIX_EPOCH + std::time::Duration::from_secs(86400);
    let file = fs::File::options().write(true).open(&path).expect("the file");
    file.set_modified(long_ago).expect("a time");
    assert_eq!(write_if_changed(&path, "one").expect("compared"), Written::Unchanged);
    let modified = fs::metadata(&path).expect("the file").modified().expect("a time");
    assert_eq!(modified, long_ago);

    assert_eq!(write_if_changed(&path, "two").expect("written"), Written::Changed);
    let modified = fs::metadata(&path).expect("the file").modified().expect("a time");
    assert_ne!(modified, long_ago);
    assert_eq!(fs::read_to_string(&path).expect("the file"), "two");
    assert_eq!(names(folder.path()), ["a.rs"], "nothing is left beside it");
}

#[cfg(unix)]
#[test]
fn written_files_have_the_permissions_of_new_files() {
    use std::os::unix::fs::PermissionsExt as _;
    let folder = tempfile::tempdir().expect("a folder");
    let (ours, theirs) = (folder.path().join("ours"), folder.path().join("theirs"));
    write_if_changed(&ours, "text").expect("written");
    fs::write(&theirs, "text").expect("written");
    let mode = |path: &Path| fs::metadata(path).expect("a file").permissions().mode();
    assert_eq!(mode(&ours), mode(&theirs));
}

#[test]
fn check_tells_fresh_from_stale_from_missing() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.rs");
    assert_eq!(check(&path, "one").expect("compared"), Freshness::Missing);
    fs::write(&path, "one").expect("written");
    assert_eq!(check(&path, "one").expect("compared"), Freshness::Fresh);
    assert_eq!(check(&path, "two").expect("compared"), Freshness::Stale);
}

#[test]
fn nothing_is_written_outside_the_folder() {
    let outer = tempfile::tempdir().expect("a folder");
    let folder = outer.path().join("inner");
    for file in ["../a.rs", "/a.rs", "b/a.rs", "..", ".", "", "b\\a.rs"] {
        let error = write_within(&folder, file, "text").expect_err(file);
        assert!(error.to_string().contains("only plain file names"), "{error}");
    }
    assert_eq!(names(outer.path()), Vec::<String>::new());
    assert_eq!(write_within(&folder, "a.rs", "text").expect("written"), Written::Created);
}

#[test]
fn a_check_names_what_is_not_fresh_and_the_command_that_mends_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let models = [pendulum(), oddities()];
    let summary = emit_scenes(folder.path(), &models, Mode::Write).expect("written");
    let created =
        ["mod.rs", "oddities.rs", "pendulum.rs"].map(|f| (f.to_owned(), Written::Created));
    assert_eq!(summary.files, created);
    emit_scenes(folder.path(), &models, Mode::Check).expect("fresh right after writing");

    fs::write(folder.path().join("pendulum.rs"), "// edited by hand").expect("written");
    fs::remove_file(folder.path().join("oddities.rs")).expect("removed");
    fs::write(folder.path().join("by_hand.rs"), "// not ours").expect("written");
    let error = emit_scenes(folder.path(), &models, Mode::Check).expect_err("not fresh");
    insta::assert_snapshot!(error, @r"
    emitted scenes do not match the specs:
      oddities.rs is missing
      pendulum.rs is out of date
    run `cargo run --release -- gen`
    ");
    assert_eq!(names(folder.path()), ["by_hand.rs", "mod.rs", "pendulum.rs"], "nothing is written");
}

#[test]
fn what_was_not_emitted_is_never_overwritten() {
    let folder = tempfile::tempdir().expect("a folder");
    let programs = [pendulum(), oddities()];
    fs::write(folder.path().join("pendulum.rs"), "// written by hand").expect("written");
    fs::create_dir(folder.path().join("mod.rs")).expect("a folder");
    let error = emit_scenes(folder.path(), &programs, Mode::Write).expect_err("in the way");
    let report = error.to_string().replace(&*folder.path().to_string_lossy(), "...");
    insta::assert_snapshot!(report, @r"
    something is in the way of emitted files; nothing was written:
      .../mod.rs is a folder
      .../pendulum.rs was not emitted by Machinist
    move it away, rename the scene, or name another folder
    ");
    assert_eq!(names(folder.path()), ["mod.rs", "pendulum.rs"], "nothing is written");
    let kept = fs::read_to_string(folder.path().join("pendulum.rs")).expect("the file");
    assert_eq!(kept, "// written by hand");
}

#[test]
fn files_of_scenes_that_are_no_more_are_reported_and_kept() {
    let folder = tempfile::tempdir().expect("a folder");
    emit_scenes(folder.path(), &[pendulum(), oddities()], Mode::Write).expect("written");
    let summary = emit_scenes(folder.path(), &[pendulum()], Mode::Write).expect("written");
    assert_eq!(summary.orphans, ["oddities.rs"]);
    assert!(folder.path().join("oddities.rs").exists());
    let error = emit_scenes(folder.path(), &[pendulum()], Mode::Check).expect_err("an orphan");
    assert!(matches!(error, WriteError::NotFresh { ref files, .. } if files.is_empty()));
    insta::assert_snapshot!(error, @r"
    emitted scenes do not match the specs:
      oddities.rs has no scene any more; delete it
    run `cargo run --release -- gen`
    ");
}

#[test]
fn no_scenes_give_an_index_of_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    emit_scenes(folder.path(), &[], Mode::Write).expect("written");
    let index = fs::read_to_string(folder.path().join("mod.rs")).expect("the index");
    assert!(syn::parse_file(&index).is_ok());
    assert!(index.contains("pub const NAMES: &[&str] = &[];"));
}

#[test]
fn a_scene_that_cannot_be_emitted_leaves_all_files_as_they_were() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut broken = oddities();
    broken.run.until = f64::NAN;
    let error =
        emit_scenes(folder.path(), &[pendulum(), broken], Mode::Write).expect_err("no number");
    insta::assert_snapshot!(error, @"scene `oddities`: run: NaN is not a finite number");
    assert_eq!(names(folder.path()), Vec::<String>::new());
}
