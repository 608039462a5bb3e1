//! `machinist cycle`: periodic motions, their tables and branches.

use std::fs;

use crate::process::{answer, assert_refused, machinist};

/// Block on a spring that hardens, driven.
const DUFFING: &str = r#"
[scene]
name = "duffing"
[units.block]
unit = "block"
[outputs]
x = "block.x"
[run]
until = 100
rtol = 1e-9
method = "dop853"
[define.block.coordinates.x]
unit = "m"
velocity = "v"
[define.block.parameters]
damping = { value = 0.1, unit = "N s/m" }
force = { value = 0.3, unit = "N" }
frequency = { value = 1.0, unit = "rad/s" }
[define.block.energy]
kinetic = "1 [kg]*v^2/2"
potential = "1 [N/m]*x^2/2 + 1 [N/m^3]*x^4/4"
dissipation = "damping*v^2/2"
[[define.block.forces]]
coordinate = "x"
expression = "force*cos(frequency*t)"
"#;

fn cycle(folder: &tempfile::TempDir, more: &[&str]) -> std::process::Command {
    fs::write(folder.path().join("duffing.toml"), DUFFING).expect("written");
    let common = ["cycle", "duffing.toml", "--algebra", "plain"];
    machinist(folder, &[&common[..], more].concat())
}

#[test]
fn a_motion_is_shown_written_drawn_and_given_as_json() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = ["--out", "x.csv", "--plot", "x.svg", "--points", "11"];
    let said = answer(cycle(&folder, &[&["--period", "block.frequency"], &files[..]].concat()));
    for words in ["period 6.283185307 s (of the excitation)", "Stable", "x [m]", "wrote x.csv"] {
        assert!(said.contains(words), "{words}: {said}");
    }
    let table = fs::read_to_string(folder.path().join("x.csv")).expect("a table");
    assert_eq!(table.lines().count(), 12);
    assert!(fs::read_to_string(folder.path().join("x.svg")).expect("a plot").contains("</svg>"));
    // The same period as a time in another unit.
    let json = answer(cycle(&folder, &["--period", "6283.185307179586 [ms]", "--json"]));
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(json["stability"], "stable");
    let multipliers = json["multipliers"].as_array().expect("a list").iter();
    let product: f64 =
        multipliers.map(|multiplier| multiplier["modulus"].as_f64().expect("a number")).product();
    // Liouville: exp(-damping/mass times the period).
    assert!((product - (-0.1 * std::f64::consts::TAU).exp()).abs() < 1e-9, "{product}");
}

#[test]
fn a_branch_is_a_table_with_its_bifurcations() {
    let folder = tempfile::tempdir().expect("a folder");
    let over =
        ["--period", "block.frequency", "--over", "block.frequency=0.9..2", "--points", "51"];
    let table = answer(cycle(&folder, &[&over[..], &["--out", "-"]].concat()));
    let mut rows = table.lines();
    let head = rows.next().expect("a head");
    assert!(
        head.starts_with("block.frequency [rad/s],period [s],modulus [1],x.mean [m]"),
        "{head}"
    );
    assert_eq!(rows.filter(|row| row.ends_with(",fold")).count(), 2);
    let said = answer(cycle(&folder, &[&over[..], &["--plot", "b.svg"]].concat()));
    assert!(said.contains("stable to unstable") && said.contains("unstable to stable"), "{said}");
    let svg = fs::read_to_string(folder.path().join("b.svg")).expect("a plot");
    assert_eq!(svg.matches("<circle").count(), 2);
    assert!(svg.contains("x amplitude, unstable"));
}

/// The mass bounces once, twice or four times in its period on both sides of the flips.
#[test]
fn sections_repeat_after_the_periods_of_the_branches_that_begin_at_flips() {
    let folder = tempfile::tempdir().expect("a folder");
    let common = ["cycle", "bouncing_mass", "--period", "frequency", "--columns", "height"];
    let run = |more: &[&str]| answer(machinist(&folder, &[&common[..], more].concat()));
    let branches = ["--over", "amplitude=1.7e-3..3.08e-3", "--doublings", "2", "--out", "b.csv"];
    let said = run(&[&branches[..], &["--plot", "b.svg"]].concat());
    assert_eq!(said.matches("Twice the period").count(), 2, "{said}");
    let table = fs::read_to_string(folder.path().join("b.csv")).expect("a table");
    let flips: Vec<f64> = table
        .lines()
        .filter(|row| row.ends_with(",flip"))
        .map(|row| row.split(',').nth(1).expect("a value").parse().expect("a number"))
        .collect();
    // Each flip is a point of both branches.
    let [one, same, two, again] = flips[..] else { panic!("{flips:?}") };
    assert!((one - same).abs() + (two - again).abs() < 1e-15 && one < two);
    assert!((2.63e-3..2.69e-3).contains(&one) && (2.99e-3..3.05e-3).contains(&two));
    let at = ["--over", "amplitude=2.45e-3..3.05e-3", "--settle", "60", "--sections", "11"];
    let at = [&at[..], &["--returns", "16"]].concat();
    let said = run(&[&at[..], &["--out", "s.csv", "--plot", "s.svg"]].concat());
    let told: Vec<&str> =
        said.lines().skip(4).map_while(|row| row.split_whitespace().last()).collect();
    assert_eq!(told, ["1", "2", "4"], "{said}");
    let table = fs::read_to_string(folder.path().join("s.csv")).expect("a table");
    assert_eq!(table.lines().count(), 1 + 11 * 16);
    // The period may be that of the parameter.
    let said = answer(cycle(
        &folder,
        &[
            "--period",
            "block.frequency",
            "--over",
            "block.frequency=0.9..1.1",
            "--sections",
            "3",
            "--settle",
            "300",
        ],
    ));
    assert!(said.contains("3 values of 64 periods"), "{said}");
    assert!(said.trim_end().ends_with('1'), "{said}");
}

#[test]
fn what_is_no_period_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    for (more, words) in [
        (&[][..], "depends on time"),
        (&["--period", "block.frequence"], "did you mean `block.frequency`?"),
        (&["--period", "block.force"], "determines no period"),
        (&["--period", "3 [m]"], "is in s"),
        (&["--period", "0"], "must be above 0 s"),
        (&["--multiple", "2"], "--period"),
        (&["--period", "6", "--turns", "block.x=1"], "only angles"),
        (&["--period", "6", "--segments", "0"], "1 to 200"),
        (&["--period", "6", "--columns", "y"], "no output or state `y`"),
        (&["--period", "6", "--over", "block.force=1..1"], "has no length"),
        (&["--period", "6", "--plot", "x.pdf"], "unknown format"),
        (&["--period", "6", "--over", "block.force=1..2", "--sections", "1"], "at least 2"),
        (&["--over", "block.force=1..2", "--sections", "9"], "--period"),
        (&["--period", "6", "--doublings", "1"], "--over"),
    ] {
        assert_refused(cycle(&folder, more), &[words]);
    }
}
