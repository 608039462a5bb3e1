//! Validation and simulation of archives by FMPy, if Python has it.

use std::ffi::OsStr;
use std::path::Path;
use std::process::{Command, Output};

use machinist_scenes::scenes;

use super::archives::library;
use crate::process::{REPOSITORY, answer, machinist};

/// Scenes with events, constraints, modes, inputs of time, fields, limits that jump with time.
const SCENES: [&str; 8] = [
    "saw_gin",
    "stick_slip",
    "bouncing_mass",
    "winder_linkage",
    "winder_holder_drop",
    "four_bar",
    "shaft_with_rotors",
    "specs/scenes/parts/control/pid_controller.toml",
];

/// Form of an archive.
#[derive(Clone, Copy)]
struct Form {
    /// Version of the standard.
    version: &'static str,
    /// True for sources, which FMPy's host compiles.
    is_source: bool,
}

const FORMS: [Form; 4] = [
    Form { version: "3", is_source: false },
    Form { version: "2", is_source: false },
    Form { version: "3", is_source: true },
    Form { version: "2", is_source: true },
];

/// Returns the forms in which a scene is tested: all where `MACHINIST_PEERS` names scenes, else
/// FMI 3.0 with the library and one other, in turn.
fn forms(place: usize, is_whole: bool) -> Vec<Form> {
    let other = FORMS[1 + place % 3];
    if is_whole { FORMS.to_vec() } else { vec![FORMS[0], other] }
}

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
    let named = std::env::var("MACHINIST_PEERS");
    let wanted = named.clone().unwrap_or_else(|_| SCENES.join(","));
    let built_in = [scenes::NAMES, scenes::FIELD_NAMES].concat();
    let all = if wanted == "all" { built_in } else { wanted.split(',').collect() };
    for (place, scene) in all.into_iter().enumerate() {
        let name = Path::new(scene).file_stem().and_then(OsStr::to_str).expect("a name");
        let csv = folder.path().join(name).with_extension("csv");
        let table = csv.to_str().expect("a plain path");
        answer(machinist(REPOSITORY, &["run", scene, "--rtol", "1e-10", "--out", table]));
        for Form { version, is_source } in forms(place, named.is_ok()) {
            let kind = if is_source { "sources" } else { "library" };
            let archive = folder.path().join(format!("{name}_{kind}_{version}.fmu"));
            let mut export = vec!["fmu", scene, "--fmi", version, "-o"];
            export.push(archive.to_str().expect("a plain path"));
            let library = library.to_str().expect("a plain path");
            export.extend(if is_source { vec!["--source"] } else { vec!["--library", library] });
            answer(machinist(REPOSITORY, &export));
            check.args([&archive, &csv]);
        }
    }
    let Output { status, stdout, stderr } = check.output().expect("Python starts");
    let [out, err] = [stdout, stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    assert!(status.success(), "{out}{err}");
    print!("{out}");
}
