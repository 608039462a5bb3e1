//! Estimators by `gen` and `verify`, and `linearize --along`: files, rows and refusals.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::process::{answer, assert_refused, machinist};

const MEASURED: [&str; 4] = ["--estimator", "ekf", "--measure", "motor_speed=0.1"];

fn of_gin<'a>(command: &'a str, rest: &[&'a str]) -> Vec<&'a str> {
    [&[command, "saw_gin"][..], &MEASURED, rest].concat()
}

#[test]
fn a_filter_is_written_once_and_checked() {
    let folder = tempfile::tempdir().expect("a folder");
    for (target, files) in [
        (&["--target", "c99"][..], &["saw_gin.h", "saw_gin.c"][..]),
        (&[], &["saw_gin.rs", "saw_gin_ekf.rs", "mod.rs"]),
    ] {
        let out = ["--noise", "load.mean=5", "-o", "out"];
        let arguments = of_gin("gen", &[target, &out[..]].concat());
        answer(machinist(folder.path(), &arguments));
        for file in files {
            assert!(folder.path().join("out").join(file).exists(), "{file}");
        }
        let again = answer(machinist(folder.path(), &[&arguments[..], &["--check"]].concat()));
        assert!(again.contains("fresh"), "{again}");
    }
    let header = fs::read_to_string(folder.path().join("out/saw_gin.h")).expect("a header");
    for name in ["saw_gin_estimator_predict", "saw_gin_measured_t", "double motor_speed;"] {
        assert!(header.contains(name), "{name}");
    }
}

#[test]
fn what_makes_no_filter_is_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let refused = |arguments: &[&str], told: &str| {
        assert_refused(machinist(folder.path(), arguments), &[told]);
    };
    let out = ["-o", "out"];
    let gen_with = |rest: &[&'static str]| of_gin("gen", &[rest, &out[..]].concat());
    refused(&gen_with(&["--noise", "load.men=5"]), "did you mean `load.mean`");
    refused(&gen_with(&["--estimate", "motor.omega"]), "no parameter `motor.omega`");
    refused(&gen_with(&["--noise", "load.mean=0"]), "above 0");
    refused(&gen_with(&["--noise", "load.mean=5 [m]"]), "load.mean is in N m");
    refused(&of_gin("gen", &[]), "folder");
    refused(&["gen", "--estimator", "ekf", "--measure", "x=1"], "for one scene");
    refused(&["gen", "saw_gin", "--estimator", "ekf", "-o", "out"], "--measure");
    refused(&["verify", "--estimator", "ekf", "--measure", "x=1"], "one scene");
    refused(&["verify", "saw_gin", "--since", "1"], "--since is for an estimator");
    let only = ["--only", "estimator"];
    refused(&of_gin("verify", &only), "time between measurements");
    refused(&of_gin("verify", &[&only[..], &["--sample", "1"]].concat()), "fewer than 10");
    assert!(!folder.path().join("out").exists());
}

#[test]
fn deviations_are_read_from_a_fit() {
    let folder = tempfile::tempdir().expect("a folder");
    let call =
        |arguments: &str| machinist(folder.path(), &arguments.split(' ').collect::<Vec<_>>());
    let stiff = "--set coupling.stiffness=30000";
    answer(call(&format!(
        "run saw_gin --until 0.5 --points 301 --columns twist {stiff} --out run.csv"
    )));
    let text = fs::read_to_string(folder.path().join("run.csv")).expect("a table");
    let mut noisy = String::new();
    for (index, row) in text.lines().enumerate() {
        let numbers = row.split_once(',').filter(|_| index > 0);
        let Some((time, value)) = numbers else {
            let _ = writeln!(noisy, "{row}");
            continue;
        };
        // Evenly distributed, of deviation 1e-3 rad, in an order without a pattern.
        let uniform = (0.618_033_988_749_895 * (index * index % 997) as f64).fract();
        let noise = 1e-3 * 3.0_f64.sqrt() * (2.0 * uniform - 1.0);
        let value = value.parse::<f64>().expect("a number") + noise;
        let _ = writeln!(noisy, "{time},{value:e}");
    }
    fs::write(folder.path().join("noisy.csv"), noisy).expect("written");
    let fit = "fit saw_gin --data noisy.csv --parameters coupling.stiffness --until 0.5 --json";
    let json = answer(call(fit));
    fs::write(folder.path().join("fit.json"), &json).expect("written");
    let found: Value = serde_json::from_str(&json).expect("JSON");
    let number = |value: &Value| value.as_f64().expect("a number");
    let [values, rms] = ["values", "rms"].map(|key| number(&found["outputs"][0][key]));
    let wanted = rms * (values / (values - 1.0)).sqrt();
    assert!((wanted / 1e-3 - 1.0).abs() < 0.1, "{wanted}");
    let start = "gen saw_gin --estimator ekf --measure twist";
    let uncertain = "--estimate coupling.stiffness --uncertain coupling.stiffness";
    answer(call(&format!("{start} --fitted fit.json {uncertain} -o out")));
    let text = fs::read_to_string(folder.path().join("out/saw_gin_ekf.rs")).expect("a filter");
    let line = text.lines().skip_while(|line| !line.contains("pub const MEASURED")).nth(1);
    let deviation = line.and_then(|line| line.split([',', ')']).nth(1)).expect("a deviation");
    let deviation: f64 = deviation.trim().parse().expect("a number");
    assert!((deviation / wanted - 1.0).abs() < 1e-12, "{deviation} of {wanted}");
    let error = number(&found["parameters"][0]["standard_error"]);
    assert!(text.contains(&format!("    {error:?}, // coupling.stiffness")), "{error} in {text}");
    for (rest, told) in [
        ("", &["has no deviation", "--fitted FILE"][..]),
        (" --fitted noisy.csv", &["not the result of a fit"]),
        (" --fitted nowhere.json", &["nowhere.json"]),
        (" --fitted fit.json --uncertain motor.omega", &["no estimate of `motor.omega`"]),
    ] {
        assert_refused(call(&format!("{start}{rest} -o none")), told);
    }
    let other = "gen saw_gin --estimator ekf --measure motor_speed --fitted fit.json -o none";
    assert_refused(call(other), &["no residuals of `motor_speed`"]);
    assert!(!folder.path().join("none").exists());
}

#[test]
fn models_along_a_run_are_pieces() {
    let folder = tempfile::tempdir().expect("a folder");
    let start = ["linearize", "winch", "--inputs", "load.mass", "--outputs", "height"];
    let along = |rest: &[&'static str]| [&start[..], &["--along"], rest].concat();
    let text = answer(machinist(folder.path(), &along(&["2.9,2.95,3.2", "--json"])));
    let found: Value = serde_json::from_str(&text).expect("JSON");
    let pieces = found["pieces"].as_array().expect("pieces");
    assert_eq!(pieces.len(), 2);
    assert_eq!(pieces[0]["models"].as_array().map(Vec::len), Some(2));
    let order = |piece: &Value| piece["models"][0]["states"].as_array().map(Vec::len);
    assert_eq!([order(&pieces[0]), order(&pieces[1])], [Some(8), Some(6)]);
    for file in ["along.mat", "along.npz", "along.json"] {
        answer(machinist(folder.path(), &along(&["0.5", "--out", file])));
        assert!(Path::new(&folder.path().join(file)).exists(), "{file}");
    }
    for (rest, told) in [
        (&["3,2"][..], "does not follow"),
        (&["1,9"], "has no 9 s"),
        (&["0"], "a step is above 0"),
        (&["1", "--at", "initial"], "--at"),
        (&["1", "--lqr", "height=1,load.mass=1"], "--lqr"),
    ] {
        assert_refused(machinist(folder.path(), &along(rest)), &[told]);
    }
}
