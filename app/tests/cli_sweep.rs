//! `machinist sweep` as seen by users: tables, refusals, variants that stop.

use std::process::Output;

use machinist::Simulation;
use machinist_scenes::scenes::two_mass::TwoMass;

use crate::process;

fn sweep(arguments: &[&str]) -> Output {
    let arguments = [&["sweep"], arguments].concat();
    process::output(process::machinist(process::REPOSITORY, &arguments))
}

/// Returns lines of cells, and asserts the exit code.
fn table(arguments: &[&str], code: i32) -> Vec<Vec<String>> {
    let output = sweep(arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {said}");
    let text = String::from_utf8(output.stdout).expect("text");
    text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

const STIFFNESS: &str = "coupling.stiffness=1e3..1e5:log";

#[test]
fn a_table_holds_what_single_runs_give_built_in_or_from_a_file() {
    for scene in ["two_mass", "specs/scenes/two_mass.toml"] {
        let columns = ["--outputs", "coupling_torque,twist", "--until", "0.1"];
        let arguments = [&[scene, "--parameter", STIFFNESS, "--count", "3"], &columns[..]].concat();
        let lines = table(&arguments, 0);
        let stiffness = "coupling.stiffness [N m/rad]";
        assert_eq!(lines[0], [stiffness, "coupling_torque [N m]", "twist [rad]", "steps"]);
        assert_eq!(lines.len(), 4);
        for line in &lines[1..] {
            let number = |cell: usize| line[cell].parse::<f64>().expect("a number");
            let run = Simulation::new(&TwoMass).parameter("coupling.stiffness", number(0));
            let run = run.expect("a parameter").until(0.1).points(2).run().expect("it runs");
            for (cell, name) in [(1, "coupling_torque"), (2, "twist")] {
                let found = number(cell);
                let exact = run.last(name).expect("an output");
                assert!((found - exact).abs() <= 1e-12 * exact.abs(), "{scene}: {line:?}, {exact}");
            }
        }
    }
}

#[test]
fn masses_of_the_wrong_sign_are_told_of_beside_the_table() {
    for method in ["tsit5", "taylor"] {
        let range = ["--parameter", "driver.inertia=-1..2", "--count", "4", "--until", "0.01"];
        let output = sweep(&[&["two_mass", "--method", method], &range[..]].concat());
        let told = String::from_utf8_lossy(&output.stderr);
        let words = "1 of 4 variants, the first in row 1: the inertia of `driver.phi` is negative";
        assert!(told.contains(words), "{method}: {told}");
    }
}

#[test]
fn methods_lanes_threads_and_fields_change_no_number() {
    let fields = ["--parameter", "shaft.stiffness=7e5..8e5", "--count", "20", "--until", "1e-3"];
    let lanes = ["--parameter", STIFFNESS, "--count", "20", "--until", "0.02"];
    let spec = "specs/scenes/saw_gin.toml";
    let all: [(&[&str], &[&str]); 5] = [
        (&["shaft_with_rotors"], &fields),
        (&["specs/scenes/shaft_with_rotors.toml"], &fields),
        (&["saw_gin", "--method", "auto"], &lanes),
        (&[spec, "--method", "auto"], &lanes),
        (&[spec, "--method", "taylor"], &lanes),
    ];
    for (scene, ranges) in all {
        let of = |threads: &str| table(&[scene, ranges, &["--threads", threads]].concat(), 0);
        let alone = of("1");
        assert_eq!(alone.len(), 21);
        assert_ne!(alone[1], alone[20]);
        assert_eq!(alone, of("2"), "{scene:?}");
    }
    // `auto` gives the same as the method that it chooses.
    let by = |method: &str| table(&[&[spec, "--method", method], &lanes[..]].concat(), 0);
    assert_eq!(by("auto"), by("taylor"));
}

#[test]
fn two_ranges_are_a_grid_with_the_last_fastest_and_extremes_enclose_all_values() {
    let ranges = ["--parameter", STIFFNESS, "--parameter", "load_torque=0..100", "--count", "2"];
    let more = ["--outputs", "twist", "--extremes", "--until", "0.2", "--threads", "2"];
    let lines = table(&[&["two_mass"], &ranges[..], &more[..]].concat(), 0);
    assert_eq!(lines[0][..2], ["coupling.stiffness [N m/rad]", "load_torque [N m]"]);
    assert_eq!(lines[0][2..4], ["twist.least [rad]", "twist.greatest [rad]"]);
    let grid: Vec<&[String]> = lines[1..].iter().map(|line| &line[..2]).collect();
    assert_eq!(grid, [["1000", "0"], ["1000", "100"], ["100000", "0"], ["100000", "100"]]);
    for line in &lines[1..] {
        let [least, greatest] = [2, 3].map(|cell| line[cell].parse::<f64>().expect("a number"));
        assert!(least < greatest, "{line:?}");
    }
}

#[test]
fn variants_that_stop_say_so_in_a_column_and_leave_the_others_alone() {
    let ranges = ["--parameter", "driver.inertia=0..1", "--count", "2", "--outputs", "twist"];
    let lines = table(&[&["two_mass", "--until", "0.01"], &ranges[..]].concat(), 1);
    assert_eq!(lines[0].last().map(String::as_str), Some("error"));
    assert!(lines[1].iter().any(|cell| cell.contains("not a finite number")), "{lines:?}");
    assert!(lines[2][1].parse::<f64>().is_ok_and(f64::is_finite), "{lines:?}");
}

#[test]
fn nonsense_is_refused_with_the_reason() {
    let range = ["--parameter", STIFFNESS, "--count", "3"];
    let unknown = ["--parameter", "coupling.stifness=1..2", "--count", "3"];
    let cases: [(&[&str], &[&str], &str); 10] = [
        (&unknown, &[], "did you mean"),
        (&range, &["--outputs", "twst"], "twist"),
        (&range, &["--method", "bfd"], "bdf"),
        (&range, &["--rtol", "-1"], "above 0"),
        (&range, &["--until", "0"], "after it starts"),
        (&range, &["--threads", "0"], "at least one"),
        (&range, &["--parameter", STIFFNESS], "twice"),
        (&range, &["--out", "table.txt"], ".csv"),
        (&["--parameter", STIFFNESS, "--count", "1"], &[], "at least 2"),
        (&["--parameter", STIFFNESS, "--count", "2000000"], &[], "too many"),
    ];
    for (base, more, words) in cases {
        let arguments = [&["two_mass"], base, more].concat();
        let output = sweep(&arguments);
        let said = String::from_utf8_lossy(&output.stderr).replace('│', " ");
        let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(output.stdout.is_empty() && said.contains(words), "{arguments:?}: {said}");
    }
}
