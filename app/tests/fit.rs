//! Sensitivities and fits from the command line.

use std::fs;
use std::path::Path;

use crate::cli::{answer, assert_refused, machinist};
use crate::process;

/// A run of the saw gin with a stiffer coupling, for half a second.
fn measured(folder: &Path) -> String {
    let file = folder.join("measured.csv").display().to_string();
    let run = ["run", "saw_gin", "--until", "0.5", "--points", "61", "--columns", "twist"];
    answer(&[&run[..], &["--set", "coupling.stiffness=30000", "--out", &file]].concat());
    file
}

#[test]
fn a_run_has_columns_of_derivatives_with_their_units() {
    let by = "coupling.stiffness,coupling.twist";
    let csv = answer(&["run", "saw_gin", "--until", "0.1", "--sensitivities", by, "--out", "-"]);
    let header = csv.lines().next().expect("a header");
    assert!(header.contains("d(twist)/d(coupling.stiffness) [rad/(N m/rad)]"), "{header}");
    assert!(header.contains("d(twist)/d(coupling.twist) [1]"), "{header}");
    let wrong = "coupling.stifness";
    assert_refused(&["run", "saw_gin", "--sensitivities", wrong], &["coupling.stiffness"]);
    let twice = "motor.inertia,motor.inertia";
    assert_refused(&["run", "saw_gin", "--sensitivities", twice], &["twice"]);
}

#[test]
fn what_matters_stands_first_and_what_cannot_be_is_said() {
    let text = answer(&["sensitivity", "saw_gin", "--until", "0.2", "--outputs", "twist"]);
    let first = text.lines().find(|line| line.contains("  twist ")).expect("a row");
    assert!(first.starts_with("motor.supply_frequency"), "{text}");
    assert!(text.contains("left out: motor.supply_phase is 0"), "{text}");
    let json = answer(&["sensitivity", "saw_gin", "--until", "0.1", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert!(json["effects"].as_array().is_some_and(|effects| effects.len() > 20));
}

#[test]
fn a_fit_finds_what_the_data_were_made_with() {
    let folder = tempfile::tempdir().expect("a folder");
    let data = measured(folder.path());
    let [out, plot] =
        ["fitted.toml", "fit.svg"].map(|name| folder.path().join(name).display().to_string());
    let fit = ["fit", "saw_gin", "--data", &data, "--parameters", "coupling.stiffness=1e3..1e6"];
    let text = answer(&[&fit[..], &["--out", &out, "--plot", &plot]].concat());
    assert!(text.contains("converged") && text.contains("30000"), "{text}");
    assert!(fs::read_to_string(&plot).expect("a plot").contains("twist, measured"));
    let scene = fs::read_to_string(&out).expect("a scene");
    assert!(scene.contains("stiffness = 30000") || scene.contains("stiffness = 29999.9"));
    // Never over the scene it comes from.
    let over = ["fit", &out, "--data", &data, "--parameters", "coupling.stiffness", "--out", &out];
    assert_refused(&over, &["would overwrite"]);
}

#[test]
fn bad_data_are_refused_with_the_place() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("data.csv");
    let path = file.display().to_string();
    let fit = |parameters: &'static str| {
        ["fit", "saw_gin", "--data", &path, "--parameters", parameters].map(str::to_owned)
    };
    let refused = |text: &str, parameters: &'static str, words: &[&str]| {
        fs::write(&file, text).expect("written");
        let arguments = fit(parameters);
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        assert_refused(&arguments, words);
    };
    let stiffness = "coupling.stiffness";
    refused("time,twst\n0.1,1\n", stiffness, &["twst", "did you mean `twist`", "--map"]);
    refused("x,twist\n0.1,1\n", stiffness, &["not time"]);
    refused("time,twist [deg]\n0.1,1\n", stiffness, &["in deg", "rad"]);
    refused("time,twist\n0.1,1\n0.05,1\n", stiffness, &["line 3", "ascend"]);
    refused("time,twist\n-0.1,1\n", stiffness, &["before the start", "--from"]);
    refused("time,twist\n0.1,abc\n", stiffness, &["line 2", "no number"]);
    refused("time,twist\n0.1,\n0.2,0.1\n", "motor.inertia,coupling.stiffness", &["too few"]);
    refused("time,twist\n0.1,1\n", "coupling.stiffness=5..1", &["cross"]);
    refused("time,twist\n0.1,1\n", "coupling.stifness", &["did you mean"]);
}

#[test]
fn gaps_are_counted_and_wild_values_count_less() {
    let folder = tempfile::tempdir().expect("a folder");
    let data = measured(folder.path());
    let text = fs::read_to_string(&data).expect("data");
    let spoilt: Vec<String> = text
        .lines()
        .enumerate()
        .map(|(index, line)| match (index, line.split_once(',')) {
            (5, Some((time, _))) => format!("{time},"),
            (9, Some((time, _))) => format!("{time},NaN"),
            (20 | 41, Some((time, _))) => format!("{time},0.05"),
            _ => line.to_owned(),
        })
        .collect();
    fs::write(&data, spoilt.join("\n")).expect("written");
    let fit = ["fit", "saw_gin", "--data", &data, "--parameters", "coupling.stiffness=1e4..1e5"];
    let text = answer(&[&fit[..], &["--loss", "huber", "--json"]].concat());
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(json["gaps"], 2);
    let value = json["parameters"][0]["value"].as_f64().expect("a value");
    assert!((value / 30000.0 - 1.0).abs() < 1e-3, "{value}");
}

#[test]
fn a_range_in_which_runs_fail_is_survived_and_told() {
    // A negative inertia lets the machine run away.
    let folder = tempfile::tempdir().expect("a folder");
    let data = measured(folder.path());
    let fit = ["fit", "saw_gin", "--data", &data, "--parameters", "cylinder.inertia=-1..5"];
    let output = process::output(machinist(&[&fit[..], &["--starts", "4"]].concat()));
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("cylinder.inertia"), "{text}");
}
