//! The program in an empty folder: what travels within it.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// The program in a folder, with no home but that.
fn machinist(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_machinist"))
        .args(arguments)
        .current_dir(folder)
        .env("HOME", folder)
        .env("MACHINIST_CACHE", concat!(env!("CARGO_TARGET_TMPDIR"), "/cache"))
        .env("NO_COLOR", "1")
        .output()
        .expect("the program starts")
}

/// Standard error, on one line, as it may be wrapped anywhere.
fn said(output: &Output) -> String {
    let text = String::from_utf8_lossy(&output.stderr).replace('│', " ");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Standard output of a run that must succeed.
fn answer(folder: &Path, arguments: &[&str]) -> String {
    let output = machinist(folder, arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", said(&output));
    String::from_utf8(output.stdout).expect("text")
}

/// Asserts bad input: exit code 2, nothing on standard output, and what is said.
fn assert_refused(folder: &Path, arguments: &[&str], words: &[&str]) {
    let output = machinist(folder, arguments);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
    assert!(output.stdout.is_empty(), "{arguments:?} printed an answer");
    for word in words {
        assert!(said.contains(word), "{arguments:?} does not say `{word}`: {said}");
    }
}

#[test]
fn scenes_that_are_built_in_need_no_files() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    assert!(answer(folder, &["check", "saw_gin", "m5"]).contains("saw_gin: ok, "));
    assert!(answer(folder, &["derive", "two_mass"]).contains("driver.phi_ddot"));
    answer(folder, &["run", "two_mass", "--keep-all", "--until", "0.01"]);
    assert!(answer(folder, &["explain", "two_mass", "--without-times"]).contains("cyclic"));
    answer(folder, &["verify", "two_mass", "--only", "energy"]);

    let repository = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
    let [by_name, by_file] = ["name.model", "file.model"].map(|name| folder.join(name));
    let compile = |place: &str, scene: &str, out: &Path| {
        let out = out.to_str().expect("a plain path");
        answer(Path::new(place), &["compile", scene, "--out", out]);
    };
    compile(folder.to_str().expect("a plain path"), "two_mass", &by_name);
    compile(repository, "specs/scenes/two_mass.toml", &by_file);
    assert!(fs::read(by_name).expect("a model") == fs::read(by_file).expect("a model"));
}

#[test]
fn a_name_without_the_ending_of_its_file_is_refused_with_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("hoist.toml"), "").expect("written");
    assert_refused(folder.path(), &["run", "hoist"], &["no scene `hoist`", "`hoist.toml`"]);
}
