//! Validation and simulation of archives by FMPy, if Python has it.

use std::process::{Command, Output};

use machinist_scenes::scenes;

use super::archives::library;
use crate::process::{REPOSITORY, answer, machinist};

/// Scenes with events, constraints, modes, inputs of time, fields.
const SCENES: [&str; 7] = [
    "saw_gin",
    "stick_slip",
    "bouncing_mass",
    "winder_linkage",
    "winder_holder_drop",
    "four_bar",
    "shaft_with_rotors",
];

/// Tests these scenes, those that `MACHINIST_PEERS` names, or `all` built-in ones.
#[test]
fn fmpy_validates_and_simulates_what_is_exported() {
    let python = std::env::var("MACHINIST_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let has_fmpy = Command::new(&python).args(["-c", "import fmpy"]).output();
    if !has_fmpy.is_ok_and(|output| output.status.success()) {
        println!("skipped: {python} has no FMPy; MACHINIST_PYTHON names one that has");
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let library = library();
    let mut check = Command::new(&python);
    check.arg(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fmu/peers.py"));
    let wanted = std::env::var("MACHINIST_PEERS").unwrap_or_else(|_| SCENES.join(","));
    let built_in = [scenes::NAMES, scenes::FIELD_NAMES].concat();
    let all = if wanted == "all" { built_in } else { wanted.split(',').collect() };
    for scene in all {
        let [archive, csv] =
            ["fmu", "csv"].map(|ending| folder.path().join(scene).with_extension(ending));
        let [library, out, table] =
            [&library, &archive, &csv].map(|path| path.to_str().expect("a plain path"));
        answer(machinist(REPOSITORY, &["fmu", scene, "-o", out, "--library", library]));
        let run = ["run", scene, "--rtol", "1e-10", "--out", table];
        answer(machinist(REPOSITORY, &run));
        check.args([&archive, &csv]);
    }
    let Output { status, stdout, stderr } = check.output().expect("Python starts");
    let [out, err] = [stdout, stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    assert!(status.success(), "{out}{err}");
    print!("{out}");
}
