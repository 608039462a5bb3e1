//! Rainflow counts and damage: the example of the standard, a steady oscillation in closed form,
//! peaks between samples.

use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::cli::{answer, text};
use crate::process;
use crate::shaken::{self, DAMPING, MASS, STIFFNESS};

/// Returns the scene with other outputs and another end.
fn scene(outputs: &str, until: f64) -> String {
    let more = format!(
        r#"
        [outputs]
        {outputs}
        [run]
        until = {until:?}
        points = 2
        rtol = 1e-10
        method = "dop853"
        "#
    );
    shaken::scene("10 [N]*sin(2*pi*5 [Hz]*t)", &more)
}

fn counted(folder: &Path, scene: &str, options: &[&str]) -> Value {
    let [file, json] = ["loads.toml", "loads.json"].map(|name| folder.join(name));
    fs::write(&file, scene).expect("written");
    let start = ["fatigue", text(&file), "--out", text(&json)];
    answer(&[&start[..], options].concat());
    serde_json::from_slice(&fs::read(&json).expect("a file")).expect("JSON")
}

fn of(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// Returns ranges with their numbers of cycles, the smallest first.
fn ranges(output: &Value) -> Vec<(f64, f64)> {
    let mut found: Vec<(f64, f64)> = Vec::new();
    for cycle in output["cycles"].as_array().expect("cycles").iter().rev() {
        let (range, count) = (of(&cycle["range"]), of(&cycle["count"]));
        match found.last_mut() {
            Some((last, counts)) if (*last - range).abs() < 1e-9 => *counts += count,
            _ => found.push((range, count)),
        }
    }
    found
}

fn assert_ranges(output: &Value, wanted: &[(f64, f64)]) {
    let found = ranges(output);
    assert_eq!(found.len(), wanted.len(), "{found:?}");
    for ((range, count), (known, times)) in found.iter().zip(wanted) {
        assert!((range - known).abs() < 1e-9 && (count - times).abs() < 1e-12, "{found:?}");
    }
}

/// History of ASTM E1049-85, figures 6 and 7, as a table over time.
#[test]
fn the_history_of_the_standard_is_counted_as_printed() {
    let folder = tempfile::tempdir().expect("a folder");
    let history = [-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0];
    let rows = history.iter().enumerate().map(|(time, load)| format!("{time},{load}\n"));
    let table = "time [s],load [kN]\n".to_owned() + rows.collect::<String>().as_str();
    fs::write(folder.path().join("history.csv"), table).expect("written");
    let outputs = r#"
        load = { expression = 'table("history.csv", "load", t, "linear")', unit = "kN" }
        opposite = { expression = '-2*table("history.csv", "load", t, "linear")', unit = "kN" }
    "#;
    let scene = scene(outputs, 8.0);
    let options = ["--samples", "800", "--endurance", "load=2,opposite=4", "--slope", "3"];
    let once = counted(folder.path(), &scene, &options);
    assert_ranges(
        &once["outputs"][0],
        &[(3.0, 0.5), (4.0, 1.5), (6.0, 0.5), (8.0, 1.0), (9.0, 0.5)],
    );
    // Amplitudes over the endurance, to the third power; 1.5 is below the knee, with slope 5.
    let damage = (0.5 * 0.75_f64.powi(5) + 1.5 + 0.5 * 3.375 + 8.0 + 0.5 * 11.390_625) / 2e6;
    for output in 0..2 {
        let found = of(&once["outputs"][output]["damage"]);
        assert!((found - damage).abs() < 1e-9 * damage, "{found}, not {damage}");
        let life = of(&once["outputs"][output]["life"]);
        assert!((life * damage - 8.0).abs() < 1e-7, "{life}");
    }
    let repeated = counted(folder.path(), &scene, &[&options[..], &["--repeat"]].concat());
    assert_ranges(&repeated["outputs"][0], &[(3.0, 1.0), (4.0, 1.0), (7.0, 1.0), (9.0, 1.0)]);
    // A gate of half the largest range leaves one loop.
    let few = counted(folder.path(), &scene, &["--samples", "800", "--gate", "0.5", "--repeat"]);
    assert_ranges(&few["outputs"][0], &[(7.0, 1.0), (9.0, 1.0)]);
    assert_eq!(few["outputs"][0]["damage"], Value::Null);
}

/// A steady oscillation has its periods as cycles and twice its amplitude as range, also where
/// samples miss the peaks.
#[test]
fn a_steady_oscillation_has_the_damage_of_its_closed_form() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = scene(r#"way = { expression = "body.x", unit = "mm" }"#, 24.0);
    let omega = TAU * 5.0;
    let way = 1e4 / (STIFFNESS - MASS * omega * omega).hypot(DAMPING * omega);
    for (samples, tolerance) in [("20000", 1e-9), ("437", 1e-3)] {
        let options = ["--settle", "20", "--samples", samples, "--repeat"];
        let curve = ["--endurance", "5", "--slope", "4", "--knee", "1e6", "--miner", "elementary"];
        let found = counted(folder.path(), &scene, &[&options[..], &curve].concat());
        let output = &found["outputs"][0];
        let number = of(&output["number"]);
        assert!((number - 20.0).abs() < 1e-12, "{number} cycles in 20 periods");
        let amplitude = of(&output["equivalent_amplitude"]);
        assert!((amplitude - way).abs() < tolerance * way, "{amplitude}, not {way}");
        let damage = 20.0 / 1e6 * (way / 5.0).powi(4);
        let off = (of(&output["damage"]) - damage).abs();
        assert!(off < 4.0 * tolerance * damage, "{samples}: {off:e}");
    }
    // Goodman: the steady force of 0 leaves the amplitude, a mean of half the strength doubles it.
    let shifted = scene.replace("body.x\"", "body.x + 50 [mm]\"");
    let options = ["--settle", "20", "--repeat", "--mean", "goodman:100", "--slope", "4"];
    let found = counted(folder.path(), &shifted, &options);
    let amplitude = of(&found["outputs"][0]["equivalent_amplitude"]);
    assert!((amplitude - 2.0 * way).abs() < 1e-6 * way, "{amplitude}");
}

#[test]
fn tables_plots_and_json_agree() {
    let folder = tempfile::tempdir().expect("a folder");
    let [csv, plot] = ["loads.csv", "loads.svg"].map(|name| folder.path().join(name));
    let start = ["fatigue", "saw_gin", "--outputs", "coupling_torque", "--endurance", "400"];
    let told = answer(&[&start[..], &["--out", text(&csv), "--plot", text(&plot)]].concat());
    assert!(told.contains("S-N curve: slope 5, knee at 2e6 cycles"), "{told}");
    let json: Value =
        serde_json::from_str(&answer(&[&start[..], &["--json"]].concat())).expect("JSON");
    let output = &json["outputs"][0];
    let rows = fs::read_to_string(&csv).expect("a table");
    let damages: f64 = rows
        .lines()
        .skip(1)
        .map(|row| row.rsplit(',').next().expect("a column").parse::<f64>().expect("a number"))
        .sum();
    assert!((damages - of(&output["damage"])).abs() < 1e-12 * damages);
    assert_eq!(rows.lines().count(), 1 + output["cycles"].as_array().expect("cycles").len());
    assert!(fs::read_to_string(&plot).expect("a plot").contains("coupling_torque"));
    let text = answer(&[&start[..], &["--out", "-"]].concat());
    assert_eq!(text, rows);
}

#[test]
fn impossible_curves_and_outputs_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    for (options, reason) in [
        (&["--endurance", "0"][..], "not above zero"),
        (&["--endurance", "twist=1,way=2"], "`way` is not counted"),
        (&["--endurance", "twist"], "not a number"),
        (&["--slope", "0.5"], "below 1"),
        (&["--knee=-1"], "not above zero"),
        (&["--mean", "goodman"], "needs a strength"),
        (&["--mean", "goodman:-3"], "not above zero"),
        (&["--mean", "walker:2"], "at most 1"),
        (&["--mean", "fkm:1"], "one of none"),
        (&["--gate", "1"], "not a share"),
        (&["--samples", "2"], "needs 3 to"),
        (&["--outputs", "twits"], "no output or state"),
        (&["--mean", "goodman:1e-6"], "reaches the strength"),
        (&["--out", "loads.txt"], "unknown format"),
        (&["--settle", "1e9"], "is empty"),
    ] {
        let arguments = [&["fatigue", "saw_gin"], options].concat();
        process::assert_refused(process::machinist(folder.path(), &arguments), &[reason]);
    }
    assert!(fs::read_dir(folder.path()).expect("a folder").next().is_none());
}
