//! Campbell diagrams over a plain speed, in rpm and Hz.

use std::f64::consts::TAU;
use std::fs;

use crate::process::{answer, assert_refused, machinist};

/// Wheel of 2 kg m^2 on a shaft of 5000 N m/rad: 50 rad/s.
const WHEEL: &str = r#"
[scene]
name = "wheel"
[units.wall]
unit = "rotational/fixed"
[units.shaft]
unit = "rotational/spring"
parameters = { stiffness = 5000 }
[units.wheel]
unit = "rotational/inertia"
parameters = { inertia = 2 }
[[joints]]
connect = ["wall.a", "shaft.a"]
[[joints]]
connect = ["shaft.b", "wheel.a"]
[run]
until = 1
"#;

fn campbell(folder: &tempfile::TempDir, more: &[&str]) -> std::process::Command {
    let common = ["campbell", "wheel.toml", "--algebra", "plain", "--count", "11"];
    machinist(folder, &[&common[..], more].concat())
}

#[test]
fn a_plain_speed_is_an_axis_in_rpm_with_frequencies_in_hertz() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("wheel.toml"), WHEEL).expect("written");
    let more = ["--speeds", "0..600 [rpm]", "--orders", "1,2", "--hz", "--out", "-"];
    let table = answer(campbell(&folder, &more));
    let mut rows = table.lines();
    let head = rows.next().expect("a head");
    assert!(head.starts_with("speed [rpm],") && head.contains(" [Hz],"), "{head}");
    let rows: Vec<Vec<f64>> = rows
        .map(|row| row.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    assert_eq!(rows.len(), 11);
    for (index, row) in rows.iter().enumerate() {
        assert!((row[0] - 60.0 * index as f64).abs() < 1e-9, "{row:?}");
        assert!((row[1] * TAU / 50.0 - 1.0).abs() < 1e-12, "{row:?}");
    }
    // Order 1 meets 50 rad/s at 477.465 rpm, order 2 at half of that.
    let said = answer(campbell(&folder, &["--speeds", "0..600 [rpm]", "--orders", "1,2", "--hz"]));
    for words in ["speed [rpm]", "477.465", "238.732", "7.95775", "at [Hz]"] {
        assert!(said.contains(words), "{words}: {said}");
    }
    let plain = answer(campbell(&folder, &["--speeds", "0..60", "--orders", "1"]));
    assert!(plain.contains("speed [rad/s]") && plain.contains("at [rad/s]"), "{plain}");
    let json = answer(campbell(&folder, &["--speeds", "0..600 [rpm]", "--hz", "--json"]));
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let speed = json["critical"][0]["value"].as_f64().expect("a speed");
    assert!((speed - 50.0).abs() < 1e-9, "{json}");
}

#[test]
fn a_plot_labels_orders_and_circles_where_they_meet() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("wheel.toml"), WHEEL).expect("written");
    let more = ["--speeds", "0..600 [rpm]", "--orders", "1,2", "--plot", "wheel.svg", "--hz"];
    answer(campbell(&folder, &more));
    let svg = fs::read_to_string(folder.path().join("wheel.svg")).expect("a plot");
    for words in ["speed [rpm]", "[Hz]", "order 1", "order 2", "477.5", "238.7"] {
        assert!(svg.contains(words), "{words}");
    }
    assert_eq!(svg.matches("<circle").count(), 2);
}

#[test]
fn what_is_no_speed_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("wheel.toml"), WHEEL).expect("written");
    for (more, words) in [
        (&["--speeds", "0..600 [m]"][..], "a speed is in rad/s, not in m"),
        (&["--speeds", "600..0"], "must increase"),
        (&["--speeds", "0..9", "--parameter", "shaft.stiffness=1..2"], "cannot be used with"),
        (&[], "--parameter"),
    ] {
        assert_refused(campbell(&folder, more), &[words]);
    }
}
