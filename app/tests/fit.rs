//! Sensitivities and fits from the command line.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use crate::cli::{answer, assert_refused, machinist, text};
use crate::process;

/// Writes a run of the saw gin with a stiffer coupling, for half a second.
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
fn an_effect_on_what_does_not_move_is_left_out_with_a_word() {
    let still = r#"
        [scene]
        name = "still"
        [units.body]
        unit = "translational/mass"
        [units.spring]
        unit = "translational/spring_damper"
        parameters = { stiffness = 10, damping = 1, free_length = 1 }
        [units.wall]
        unit = "translational/fixed"
        [[joints]]
        connect = ["wall.a", "spring.a"]
        [[joints]]
        connect = ["spring.b", "body.a"]
        [initial]
        "body.x" = 1
        [outputs]
        speed = "body.v"
        [run]
        until = 1
        points = 3
        "#;
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("still.toml");
    fs::write(&file, still).expect("a scene");
    let text = answer(&["sensitivity", text(&file)]);
    assert!(text.contains("left out: the effect of spring.free_length on speed"), "{text}");
    assert!(!text.contains("inf"), "{text}");
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
    // The scene is never overwritten.
    let over = ["fit", &out, "--data", &data, "--parameters", "coupling.stiffness", "--out", &out];
    assert_refused(&over, &["would overwrite"]);
}

/// The same values in other units are the same measurement.
#[test]
fn columns_in_other_units_are_converted() {
    let folder = tempfile::tempdir().expect("a folder");
    let data = measured(folder.path());
    let text = fs::read_to_string(&data).expect("a run");
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("time [s],twist [rad]"));
    let mut other = "time [ms],twist [deg],sigma(twist) [deg]\n".to_owned();
    for line in lines {
        let (time, twist) = line.split_once(',').expect("two columns");
        let [time, twist] = [time, twist].map(|cell| cell.parse::<f64>().expect("a number"));
        let sigma = 0.01_f64.to_degrees();
        writeln!(other, "{},{},{sigma}", 1e3 * time, twist.to_degrees()).expect("room");
    }
    let in_other = folder.path().join("other.csv");
    fs::write(&in_other, other).expect("written");
    let found = |data: &str, more: &[&str]| {
        let asked = ["fit", "saw_gin", "--data", data, "--parameters", "coupling.stiffness"];
        let json = answer(&[&asked[..], &["--json"], more].concat());
        let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
        json["parameters"][0]["value"].as_f64().expect("a number")
    };
    let plain = found(&data, &["--sigma", "twist=0.01"]);
    let converted = found(crate::cli::text(&in_other), &[]);
    for value in [plain, converted] {
        assert!((value / 30_000.0 - 1.0).abs() < 1e-6, "{value}");
    }
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
    refused("time,twist [mm]\n0.1,1\n", stiffness, &["in mm", "rad"]);
    refused("time [mm],twist\n0.1,1\n", stiffness, &["in mm", "not a unit of time"]);
    refused("time [parsec],twist\n0.1,1\n", stiffness, &["in parsec", "not a unit of time"]);
    refused("time,twist\n0.1,1\n0.05,1\n", stiffness, &["line 3", "increase"]);
    refused("time,twist\n-0.1,1\n", stiffness, &["before the start", "--from"]);
    refused("time,twist\n0.1,abc\n", stiffness, &["line 2", "not a number"]);
    refused("time,twist\n0.1,\n0.2,0.1\n", "motor.inertia,coupling.stiffness", &["too few"]);
    refused("time,twist\n0.1,1\n", "coupling.stiffness=5..1", &["invalid bounds"]);
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

/// Ball on a spring whose stiffness is the root of 4 minus a load. Beyond that load there is none.
const LOADED: &str = r#"
[scene]
name = "loaded"
[units.ball]
unit = "ball"
[initial]
"ball.x" = 1.0
[outputs]
x = "ball.x"
[run]
until = 1.0
[define.ball.coordinates.x]
unit = "m"
velocity = "v"
[define.ball.parameters]
load = { value = 1.0, unit = "1" }
[define.ball.energy]
kinetic = "0.5 [kg]*v^2/2"
[[define.ball.forces]]
coordinate = "x"
expression = "-10 [N/m]*x*sqrt(4 - load)"
"#;

#[test]
fn a_range_in_which_runs_fail_is_survived_and_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let [scene, data] =
        ["loaded.toml", "data.csv"].map(|name| folder.path().join(name).display().to_string());
    fs::write(&scene, LOADED).expect("written");
    answer(&[
        "run",
        &scene,
        "--points",
        "21",
        "--columns",
        "x",
        "--set",
        "ball.load=3.9",
        "--out",
        &data,
    ]);
    let fit = ["fit", &scene, "--data", &data, "--parameters", "ball.load=0.5..20"];
    let text = answer(&[&fit[..], &["--starts", "4"]].concat());
    assert!(text.contains("3.9") && text.contains("could not be simulated"), "{text}");
    assert!(text.contains("not a finite number"), "{text}");
    // If no start can be simulated, nothing is found, and the message says so.
    let beyond = ["fit", &scene, "--data", &data, "--parameters", "ball.load=5..20"];
    let output = process::output(machinist(&beyond));
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(1) && said.contains("no start can be"), "{said}");
}

/// Writes runs of the saw gin at full and at lower voltage, with a stiffer coupling, and a file
/// with their settings.
fn laboratory(folder: &Path) -> String {
    for (file, voltage) in [("full.csv", "220"), ("low.csv", "180")] {
        let file = folder.join(file).display().to_string();
        let run = ["run", "saw_gin", "--until", "0.3", "--points", "41", "--columns", "twist"];
        let voltage = format!("motor.phase_voltage={voltage}");
        let set = ["--set", "coupling.stiffness=30000", "--set", &voltage, "--out", &file];
        answer(&[&run[..], &set].concat());
    }
    let file = folder.join("lab.toml");
    let text = r#"
        [[experiment]]
        data = "full.csv"
        [[experiment]]
        name = "low"
        data = "low.csv"
        set = { motor.phase_voltage = "0.18 [kV]" }
    "#;
    fs::write(&file, text).expect("written");
    file.display().to_string()
}

#[test]
fn experiments_have_settings_of_their_own() {
    let folder = tempfile::tempdir().expect("a folder");
    let lab = laboratory(folder.path());
    let plot = folder.path().join("all.svg").display().to_string();
    let fit = ["fit", "saw_gin", "--parameters", "coupling.stiffness=1e3..1e6"];
    let told = answer(&[&fit[..], &["--experiments", &lab, "--plot", &plot]].concat());
    for words in ["2 experiments: 82 values", "motor.phase_voltage=180", "twist, low", "30000"] {
        assert!(told.contains(words), "{words}: {told}");
    }
    let second = fs::read_to_string(folder.path().join("all-2.svg")).expect("a plot");
    assert!(second.contains(", low"), "its title says which it is");
    let json = answer(&[&fit[..], &["--experiments", &lab, "--json"]].concat());
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let low = &json["experiments"][1];
    assert_eq!((&low["name"], &low["values"]), (&"low".into(), &41.into()));
    assert_eq!(low["set"]["motor.phase_voltage"], 180.0);
    assert_eq!(json["outputs"][1]["experiment"], "low");
    // With one voltage for both, nothing fits.
    let [full, low] = ["full.csv", "low.csv"].map(|name| folder.path().join(name));
    let files = ["--data", &*full.to_string_lossy(), "--data", &*low.to_string_lossy(), "--json"];
    let json = answer(&[&fit[..], &files].concat());
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let value = json["parameters"][0]["value"].as_f64().expect("a value");
    assert!((value / 30_000.0 - 1.0).abs() > 1e-2, "{value}");
}

#[test]
fn experiments_that_make_no_sense_are_refused_by_name() {
    let folder = tempfile::tempdir().expect("a folder");
    laboratory(folder.path());
    let file = folder.path().join("wrong.toml");
    let path = file.display().to_string();
    let refused = |text: &str, words: &[&str]| {
        fs::write(&file, text).expect("written");
        let fit = ["fit", "saw_gin", "--parameters", "coupling.stiffness", "--experiments", &path];
        assert_refused(&fit, words);
    };
    let with = |line: &str| format!("[[experiment]]\ndata = \"full.csv\"\n{line}\n");
    refused("", &["no experiments", "[[experiment]]"]);
    refused(&with("sgima = { twist = 1 }"), &["line 3", "did you mean `sigma`"]);
    let sets = "set = { coupling.stiffness = 3 }";
    refused(&with(sets), &["full.csv", "coupling.stiffness", "which is fitted"]);
    refused(&with("set = { motor.inertja = 3 }"), &["full.csv", "did you mean `motor.inertia`"]);
    refused(&with("set = { motor.inertia = \"3 [kg]\" }"), &["motor.inertia is in kg m^2"]);
    refused(&with("sigma = { twst = 1 }"), &["full.csv", "did you mean `twist`"]);
    refused(&with("outputs = [\"twst\"]"), &["did you mean `twist`"]);
    refused(&with("from = 0.2"), &["line 2", "before the start", "0.2 s"]);
    let both = with("sigma = { twist = 1 }") + "[[experiment]]\ndata = \"low.csv\"\n";
    refused(&both, &["sigma of `twist`", "not for low.csv"]);
    refused(&with("").repeat(2), &["`full.csv`", "a different `name`"]);
    let twice = folder.path().join("full.csv").display().to_string();
    let fit = ["fit", "saw_gin", "--parameters", "coupling.stiffness", "--data", &twice];
    assert_refused(&[&fit[..], &["--data", &twice]].concat(), &["two runs", "full.csv"]);
}

#[test]
fn profiles_stand_beside_standard_errors() {
    let folder = tempfile::tempdir().expect("a folder");
    let data = measured(folder.path());
    // Reproducible noise of 1e-4.
    let text = fs::read_to_string(&data).expect("data");
    let mut random = fastrand::Rng::with_seed(1);
    let noisy: Vec<String> = text
        .lines()
        .map(|line| match line.split_once(',').map(|(time, value)| (time, value.parse::<f64>())) {
            Some((time, Ok(value))) => {
                format!("{time},{}", value + 3e-4 * (random.f64() - 0.5))
            }
            _ => line.to_owned(),
        })
        .collect();
    fs::write(&data, noisy.join("\n")).expect("written");
    let plot = folder.path().join("profiles.svg").display().to_string();
    let fit = ["fit", "saw_gin", "--data", &data, "--parameters", "coupling.stiffness=1e4..1e5"];
    let profile = ["--profile", "--plot-profiles", &plot];
    let text = answer(&[&fit[..], &profile].concat());
    assert!(text.contains("95 % by standard error") && text.contains("by likelihood"), "{text}");
    assert!(fs::read_to_string(&plot).expect("a plot").contains("in standard errors"));
    let json = answer(&[&fit[..], &["--profile", "coupling.stiffness", "--json"]].concat());
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let ends = |of: &serde_json::Value| [0, 1].map(|end| of[end].as_f64().expect("a number"));
    let [low, high] = ends(&json["parameters"][0]["confidence_95"]);
    let [profile_low, profile_high] = ends(&json["profiles"][0]["confidence_95"]);
    let width = high - low;
    assert!((low - profile_low).abs() < 0.02 * width && (high - profile_high).abs() < 0.02 * width);
    assert!((low - width..high + width).contains(&30_000.0), "{low} .. {high}");
    let points = json["profiles"][0]["points"].as_array().expect("points");
    let tau: Vec<f64> = points.iter().filter_map(|point| point["tau"].as_f64()).collect();
    assert!(tau.len() > 8 && tau.is_sorted(), "{tau:?}");
    assert_refused(&[&fit[..], &["--profile", "motor.inertia"]].concat(), &["is not fitted"]);
    assert_refused(&[&fit[..], &["--plot-profiles", &plot]].concat(), &["needs `--profile`"]);
}

#[test]
fn noise_is_a_number_a_share_or_a_column() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("data.csv");
    let path = file.display().to_string();
    let fit = |sigma: &'static str| {
        let fit = ["fit", "saw_gin", "--data", &path, "--parameters", "coupling.stiffness"];
        let sigma = if sigma.is_empty() { vec![] } else { vec!["--sigma", sigma] };
        [&fit[..], &sigma].concat().iter().map(|word| (*word).to_owned()).collect::<Vec<_>>()
    };
    let refused = |text: &str, sigma: &'static str, words: &[&str]| {
        fs::write(&file, text).expect("written");
        let arguments = fit(sigma);
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        assert_refused(&arguments, words);
    };
    let plain = "time,twist\n0.1,0\n0.2,0.01\n";
    refused(plain, "twist=1 %", &["row 1", "relative standard deviation", "0.02 + 1 %"]);
    refused(plain, "twist=0", &["not above 0"]);
    refused(plain, "twist=1 + 2", &["0.02 + 1 %"]);
    refused(plain, "twst=1", &["did you mean `twist`"]);
    let column = "time,twist,sigma(twist)\n0.1,0.01,1\n0.2,0.01,0\n";
    refused(column, "", &["row 2", "not above 0"]);
    refused("time,twist,sigma(twist)\n0.1,0.01,1\n", "twist=1", &["data already contain"]);
    refused("time,twist,sigma(twist) [mm]\n0.1,0.01,1\n", "", &["in mm"]);
    refused("time,twist,sigma(motor_speed)\n0.1,0.01,1\n", "", &["belongs to no column"]);
    // An outlier has no weight.
    let data = measured(folder.path());
    let text = fs::read_to_string(&data).expect("data");
    let weighed: Vec<String> = text
        .lines()
        .enumerate()
        .map(|(row, line)| match (row, line.split_once(',')) {
            (0, _) => format!("{line},sigma(twist) [rad]"),
            (20, Some((time, _))) => format!("{time},0.05,100"),
            _ => format!("{line},0.0001"),
        })
        .collect();
    fs::write(&file, weighed.join("\n")).expect("written");
    let text = answer(&[
        "fit",
        "saw_gin",
        "--data",
        &path,
        "--parameters",
        "coupling.stiffness",
        "--json",
    ]);
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let value = json["parameters"][0]["value"].as_f64().expect("a value");
    assert!((value / 30_000.0 - 1.0).abs() < 1e-3, "{value}");
}

#[test]
fn as_many_unknowns_as_values_leave_errors_open() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("data.csv");
    fs::write(&file, "time,twist\n0.1,0.01\n").expect("written");
    let path = file.display().to_string();
    let text =
        answer(&["fit", "saw_gin", "--data", &path, "--parameters", "coupling.stiffness=1e3..1e6"]);
    assert!(text.contains("as many unknowns as values") && text.contains("not told"), "{text}");
}
