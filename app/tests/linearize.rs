//! `machinist linearize`: a mass on a spring and damper against its closed form, files, refusals.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::process::{answer, assert_refused, machinist};
use crate::shaken::{DAMPING, MASS, STIFFNESS, scene};

const MORE: &str = r#"
    [parameters]
    push = { value = 0, unit = "N" }
    [outputs]
    way = { expression = "body.x", unit = "mm" }
    rate = "body.acceleration"
    [run]
    until = 1
    points = 2
    "#;

fn shaken() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("shaken.toml"), scene("push", MORE)).expect("written");
    folder
}

fn json(folder: &Path, rest: &[&str]) -> Value {
    let arguments = [&["linearize", "shaken.toml", "--json"][..], rest].concat();
    serde_json::from_str(&answer(machinist(folder, &arguments))).expect("JSON")
}

fn entry(of: &Value, matrix: &str, row: usize, column: usize) -> f64 {
    of[matrix][row][column].as_f64().expect("a number")
}

fn close(found: f64, wanted: f64) {
    assert!((found - wanted).abs() <= 1e-12 * wanted.abs().max(1e-3), "{found}, not {wanted}");
}

#[test]
fn a_force_on_a_coordinate_has_the_feedthrough_of_a_parameter() {
    let folder = shaken();
    let outputs = ["--outputs", "way,rate"];
    for input in ["push", "body.x"] {
        let found = json(folder.path(), &[&["--inputs", input][..], &outputs].concat());
        close(entry(&found, "a", 1, 0), -STIFFNESS / MASS);
        close(entry(&found, "a", 1, 1), -DAMPING / MASS);
        close(entry(&found, "b", 1, 0), 1.0 / MASS);
        close(entry(&found, "c", 0, 0), 1000.0);
        close(entry(&found, "c", 1, 0), -STIFFNESS / MASS);
        close(entry(&found, "d", 1, 0), 1.0 / MASS);
        assert_eq!(found["inputs"][0]["unit"], "N");
    }
    // Far above the resonance the mass is free: its acceleration is the force over it.
    let response =
        ["response", "shaken.toml", "--input", "body.x", "--output", "rate", "--out", "-"];
    let range = ["--range", "1e6:1e7", "--points", "2"];
    let table = answer(machinist(folder.path(), &[&response[..], &range].concat()));
    let last = table.lines().last().expect("a row").split(',').nth(1).expect("an amplitude");
    assert!((last.parse::<f64>().expect("a number") - 0.5).abs() < 1e-6, "{table}");
}

/// A single oscillator with weights q on its way and 1 on its force: x'' + 2 D x' + w^2 x of the
/// closed loop has w^4 = w0^4 + q/m^2 and 4 D^2 = 4 D0^2 + 2 (w^2 - w0^2).
#[test]
fn a_regulator_of_an_oscillator_has_the_gains_of_its_closed_form() {
    let folder = shaken();
    let weights = "way=5 [mm],push=3 [N]";
    let arguments = ["--inputs", "push", "--outputs", "way", "--lqr", weights];
    let found = json(folder.path(), &arguments);
    let weight = (3.0_f64 / 5e-3).powi(2);
    let frequency = STIFFNESS / MASS;
    let closed = (frequency * frequency + weight / (MASS * MASS)).sqrt();
    let damping = ((DAMPING / MASS).powi(2) + 2.0 * (closed - frequency)).sqrt();
    let gain = |column: usize| found["lqr"]["gain"][0][column].as_f64().expect("a gain");
    close(gain(0), MASS * (closed - frequency));
    close(gain(1), MASS * (damping - DAMPING / MASS));
    // Deviations in other units are the same.
    let again = ["--inputs", "push", "--outputs", "way", "--lqr", "way=5,push=0.003 [kN]"];
    assert_eq!(json(folder.path(), &again)["lqr"], found["lqr"]);
}

#[test]
fn files_hold_the_matrices_in_the_formats_of_matlab_and_numpy() {
    let folder = shaken();
    let write = |file: &str| {
        let arguments = ["linearize", "shaken.toml", "--inputs", "push", "--outputs", "way"];
        answer(machinist(folder.path(), &[&arguments[..], &["--out", file]].concat()));
        fs::read(folder.path().join(file)).expect("the file")
    };
    let mat = write("model.mat");
    assert!(mat.starts_with(b"MATLAB 5.0 MAT-file") && mat[124..128] == *b"\x00\x01IM");
    // The first array is A: flags, dimensions, name, and its four numbers by columns.
    let word = |at: usize| u32::from_le_bytes(mat[at..at + 4].try_into().expect("four bytes"));
    assert_eq!([word(128), word(136), word(144)], [14, 6, 6]);
    assert_eq!([word(152), word(156), word(160), word(164)], [5, 8, 2, 2]);
    assert_eq!((word(168), word(172), mat[176]), (1, 1, b'A'));
    assert_eq!([word(184), word(188)], [9, 32]);
    let number = |at: usize| f64::from_le_bytes(mat[at..at + 8].try_into().expect("eight bytes"));
    close(number(200), -STIFFNESS / MASS);
    close(number(208), 1.0);
    let mut at = 128;
    while at < mat.len() {
        assert_eq!(word(at), 14, "an array at {at}");
        at += 8 + word(at + 4) as usize;
    }
    assert_eq!(at, mat.len());
    let npz = write("model.npz");
    assert!(npz.starts_with(b"PK\x03\x04") && npz.windows(5).any(|bytes| bytes == b"A.npy"));
    let from_json: Value = serde_json::from_slice(&write("model.json")).expect("JSON");
    close(entry(&from_json, "a", 1, 0), -STIFFNESS / MASS);
}

#[test]
fn wrong_names_periods_and_weights_are_refused_and_nothing_is_written() {
    let folder = shaken();
    let refused = |inputs: &str, outputs: &str, rest: &[&str], words: &[&str]| {
        let arguments = ["linearize", "shaken.toml", "--inputs", inputs, "--outputs", outputs];
        let out = ["--out", "model.mat"];
        let command = machinist(folder.path(), &[&arguments[..], &out, rest].concat());
        assert_refused(command, words);
        assert!(!folder.path().join("model.mat").exists());
    };
    refused("pushh", "way", &[], &["pushh", "did you mean `push`?"]);
    refused("push", "body.y", &[], &["no output or state", "body.y"]);
    refused("push,push", "way", &[], &["input `push`", "twice"]);
    refused("push", "way", &["--sample=-1"], &["above 0"]);
    refused("push", "way", &["--lqr", "push=1,way=0"], &["deviation of `way`", "above 0"]);
    refused("push", "way", &["--lqr", "way=1"], &["no input has a deviation"]);
    refused("push", "way", &["--kalman", "push=1"], &["no output has a deviation"]);
    refused("push", "way", &["--lqr", "push=1,way=1 [s]"], &["mm", "not in s"]);
    let arguments = ["linearize", "shaken.toml", "--inputs", "push", "--outputs", "way"];
    let csv = [&arguments[..], &["--out", "model.csv"]].concat();
    assert_refused(machinist(folder.path(), &csv), &["unknown format", ".mat"]);
}
