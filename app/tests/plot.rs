//! Plots of runs and of tables by `machinist plot`.

use std::fs;
use std::path::Path;

use crate::process::{answer, assert_refused, machinist};

/// Undamped oscillator with frequency 1 rad/s, which moves on a circle of the phase plane.
const OSCILLATOR: &str = r#"
[scene]
name = "oscillator"
title = "Oscillator"
[units]
mass = { unit = "translational/mass", parameters = { mass = 1 } }
spring = { unit = "translational/spring_damper", parameters = { stiffness = 1, damping = 0 } }
wall = { unit = "translational/fixed" }
[outputs]
x = "mass.x"
v = "mass.v"
[initial]
"mass.x" = 1
[run]
until = 6.2
points = 200
"#;

/// Returns the points of all lines of the data in a picture, in pixels.
fn lines(picture: &Path) -> Vec<Vec<[f64; 2]>> {
    let text = fs::read_to_string(picture).expect("a picture");
    let attribute =
        |line: &str| Some(line.split_once("points=\"")?.1.split_once('"')?.0.to_owned());
    let point = |point: &str| {
        let (x, y) = point.split_once(',')?;
        Some([x.parse().ok()?, y.parse().ok()?])
    };
    let drawn = text.lines().filter(|line| line.contains("stroke-width=\"6\""));
    let points = drawn.filter_map(attribute);
    points.map(|points| points.split_whitespace().filter_map(point).collect()).collect()
}

/// Returns the extent of coordinates: least and greatest.
fn extent(points: &[[f64; 2]], axis: usize) -> [f64; 2] {
    let all = || points.iter().map(|point| point[axis]);
    [all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)]
}

#[test]
fn a_table_is_drawn_over_its_first_column_where_it_has_numbers() {
    let folder = tempfile::tempdir().expect("a folder");
    let rows = (0..=40).map(|i| format!("{i}; {};sunny;{}\n", i * i, 7));
    let table = format!("time [ms];height [m];weather;count\n{}", rows.collect::<String>());
    fs::write(folder.path().join("a.csv"), table).expect("a table");
    let told = answer(machinist(&folder, &["plot", "a.csv", "--columns", "height"]));
    assert_eq!(told, "wrote a.svg\n");
    let picture = folder.path().join("a.svg");
    let points: Vec<[f64; 2]> = lines(&picture).concat();
    let ([left, right], [top, bottom]) = (extent(&points, 0), extent(&points, 1));
    assert!(points.len() >= 30, "{points:?}");
    for [x, y] in points {
        let (x, y) = ((x - left) / (right - left), (bottom - y) / (bottom - top));
        assert!((x * x - y).abs() < 3e-3, "{x} {y}");
    }
    answer(machinist(&folder, &["plot", "a.csv"]));
    let text = fs::read_to_string(&picture).expect("a picture");
    assert!(text.contains("count") && text.contains("[m]") && text.contains("time [ms]"));
    assert!(!text.contains("weather") && !text.contains("[]"));
}

#[test]
fn a_run_is_drawn_as_run_does_and_over_another_column() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    answer(machinist(&folder, &["plot", "two_mass", "--until", "100ms"]));
    answer(machinist(&folder, &["run", "two_mass", "--until", "0.1", "--plot", "run.svg"]));
    let read = |name: &str| fs::read_to_string(path(name)).expect("a picture");
    assert_eq!(read("two_mass.svg"), read("run.svg"));

    let joints = "joints = [{ connect = [\"wall.a\", \"spring.a\"] }, \
                  { connect = [\"spring.b\", \"mass.a\"] }]\n";
    fs::write(path("oscillator.toml"), format!("{joints}{OSCILLATOR}")).expect("a spec");
    let words = ["plot", "oscillator.toml", "--over", "x", "--columns", "v", "-o", "phase.svg"];
    answer(machinist(&folder, &words));
    let points = lines(&path("phase.svg")).concat();
    let ([left, right], [top, bottom]) = (extent(&points, 0), extent(&points, 1));
    for [x, y] in &points {
        let x = 2.0 * (x - left) / (right - left) - 1.0;
        let y = 2.0 * (y - top) / (bottom - top) - 1.0;
        assert!((x * x + y * y - 1.0).abs() < 2e-2, "{x} {y}");
    }
    assert!(points.len() > 100, "{}", points.len());
}

#[test]
fn what_cannot_be_plotted_is_refused_with_a_reason() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.csv"), "t,name,x\n0,a,1\n1,b,2\n").expect("a table");
    fs::write(folder.path().join("empty.csv"), "t,x\n").expect("a table");
    fs::write(folder.path().join("ragged.csv"), "t,x\n0,1\n1\n").expect("a table");
    for (words, said) in [
        (vec!["a.csv", "--columns", "y"], "no column of numbers `y`"),
        (vec!["a.csv", "--columns", "name"], "no column of numbers `name`"),
        (vec!["a.csv", "--over", "s"], "no column of numbers `s`"),
        (vec!["a.csv", "--out", "a.pdf"], ".svg or .png"),
        (vec!["a.csv", "--until", "5"], "is a table, so nothing runs"),
        (vec!["a.csv", "--set", "a.b=1"], "is a table, so nothing runs"),
        (vec!["empty.csv"], "no column of numbers"),
        (vec!["ragged.csv"], "ragged.csv"),
        (vec!["a.parquet"], ".csv"),
        (vec!["two_mass", "--columns", "twists"], "`twist`"),
    ] {
        assert_refused(machinist(&folder, &[&["plot"], &words[..]].concat()), &[said]);
    }
}
