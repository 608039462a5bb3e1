//! Estimators by `gen` and `verify`, and `linearize --along`: files, rows and refusals.

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
    refused(&gen_with(&["--step", "ros2"]), "rk4 or heun");
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
