//! Spectra of runs compared with the known response of a shaken mass.

use std::f64::consts::TAU;
use std::fs;

use serde_json::Value;

use crate::cli::{answer, assert_refused, machinist, text};
use crate::process::{output, said};
use crate::shaken::{self, DAMPING, MASS, STIFFNESS};

/// Frequencies and forces of the shaker.
const WAVES: [(f64, f64); 2] = [(5.0, 10.0), (12.0, 3.0)];

const FORCE: &str = "16 [N] + 10 [N]*sin(2*pi*5 [Hz]*t) + 3 [N]*cos(2*pi*12 [Hz]*t)";
const MORE: &str = r#"
    [outputs]
    way = { expression = "body.x", unit = "mm" }
    speed = "body.v"
    [run]
    until = 24
    points = 2
    rtol = 1e-11
    method = "auto"
    "#;

/// Returns |x| for a force of 1 N: m x'' + d x' + k x = force.
fn answers(hertz: f64) -> f64 {
    let omega = TAU * hertz;
    1.0 / (STIFFNESS - MASS * omega * omega).hypot(DAMPING * omega)
}

#[test]
fn lines_of_a_shaken_mass_are_those_of_its_closed_form() {
    let folder = tempfile::tempdir().expect("a folder");
    let [scene, json, plot] = ["a.toml", "a.json", "a.svg"].map(|name| folder.path().join(name));
    fs::write(&scene, shaken::scene(FORCE, MORE)).expect("written");
    // By 20 s the transient has decayed to e^-40.
    let stretch = ["spectrum", text(&scene), "--settle", "20", "--samples", "900"];
    for window in ["rectangle", "hann", "flat_top"] {
        let out = ["--window", window, "--out", text(&json), "--plot", text(&plot)];
        let told = answer(&[&stretch[..], &out].concat());
        assert!(told.contains("lines each 0.25 Hz up to 112.5 Hz"), "{told}");
        let spectra: Value =
            serde_json::from_slice(&fs::read(&json).expect("a file")).expect("JSON");
        assert_eq!(spectra["window"], window);
        let line = |output: usize, hertz: f64| {
            let number = |value: &Value| value.as_f64().expect("a number");
            let k = (hertz * 4.0) as usize;
            assert!((number(&spectra["frequencies"][k]) - hertz).abs() < 1e-12);
            number(&spectra["outputs"][output]["amplitudes"][k])
        };
        assert_eq!(spectra["outputs"][0]["name"], "way");
        assert!((line(0, 0.0) - 1e3 * 16.0 / STIFFNESS).abs() < 1e-7, "{window}");
        for (hertz, force) in WAVES {
            let way = force * answers(hertz);
            assert!((line(0, hertz) - 1e3 * way).abs() < 1e-7, "{window}, {hertz} Hz");
            assert!((line(1, hertz) - TAU * hertz * way).abs() < 1e-7, "{window}, {hertz} Hz");
        }
        assert!(line(0, 30.0) < 1e-7, "{window}");
        assert!(fs::read_to_string(&plot).expect("a plot").contains("frequency [Hz]"));
    }
}

#[test]
fn lines_go_to_standard_output_as_a_table() {
    let table = answer(&[
        "spectrum",
        "two_mass",
        "--outputs",
        "twist",
        "--samples",
        "64",
        "--window",
        "rectangle",
        "--out",
        "-",
    ]);
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines[0], "frequency [Hz],twist [rad]");
    assert_eq!(lines.len(), 34);
    assert!(lines[33].starts_with("64.0,"), "{table}");
}

#[test]
fn spectra_of_nothing_are_refused() {
    let of = |more: &[&'static str]| [&["spectrum", "two_mass"], more].concat();
    assert_refused(&of(&["--outputs", "twits"]), &["twits", "did you mean `twist`?"]);
    assert_refused(&of(&["--samples", "1"]), &["--samples 1", "2 to 10000000"]);
    assert_refused(&of(&["--settle", "0.5"]), &["the interval from 0.5 s to 0.5 s is empty"]);
    assert_refused(&of(&["--settle", "-1"]), &["begins at 0 s"]);
    assert_refused(&of(&["--window", "square"]), &["square", "rectangle"]);
    assert_refused(&of(&["--out", "lines.xls"]), &[".csv or .json"]);
    let heavy =
        ["spectrum", "winder_linear", "--until=0.01", "--set", "holder.bobbin_radius=1e308"];
    let answer = output(machinist(&heavy));
    assert_eq!(answer.status.code(), Some(1));
    assert!(said(&answer).contains("is -inf at 0 s"), "{}", said(&answer));
}
