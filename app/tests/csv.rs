//! CSV files that expressions read.

use std::fs;
use std::path::Path;

use crate::process::{answer, machinist, output, said};

/// Returns a mass pushed by a force from a table, interpolated as `course` says.
fn spec(course: &str) -> String {
    format!(
        r#"
[scene]
name = "pushed"
[units.force]
unit = "sources/force"
inputs = {{ force = 'table("load.csv", "load", t{course})' }}
[units.mass]
unit = "translational/mass"
[[joints]]
connect = ["force.a", "mass.a"]
[outputs]
load = {{ expression = 'table("load.csv", "load", t{course})', unit = "N" }}
[run]
until = 2
"#
    )
}

/// Returns standard error of `command` for a table with these rows, with whitespace joined.
fn warned(folder: &Path, rows: &str, course: &str, command: &str) -> String {
    fs::write(folder.join("load.csv"), format!("time [s],load [N]\n{rows}")).expect("a table");
    fs::write(folder.join("pushed.toml"), spec(course)).expect("a spec");
    let output = output(machinist(folder, &[command, "pushed.toml", "--algebra", "plain"]));
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    said(&output)
}

#[test]
fn a_spline_that_overshoots_is_warned_of_once_with_file_row_and_remedy() {
    let folder = tempfile::tempdir().expect("a folder");
    for (step, row) in [("1,0\n1.001,100\n", 1), ("1,0\n1.05,100\n1.1,90\n", 1)] {
        let rows = format!("0,0\n{step}2,100\n");
        for command in ["check", "run"] {
            let said = warned(folder.path(), &rows, "", command);
            for words in [
                "natural cubic spline through `load` of `load.csv` overshoots",
                &format!("between rows {row} and {}", row + 1),
                &format!("load.csv:{}", row + 1),
                "\"monotone\"",
                "\"linear\"",
            ] {
                assert!(said.contains(words), "{command} does not say `{words}`: {said}");
            }
            assert_eq!(said.matches("overshoots").count(), 1, "{said}");
        }
    }
}

#[test]
fn a_course_that_is_named_or_stays_near_its_data_is_not_warned_of() {
    let folder = tempfile::tempdir().expect("a folder");
    let step = "0,0\n1,0\n1.001,100\n2,100\n";
    for course in ["natural", "linear", "monotone"] {
        let said = warned(folder.path(), step, &format!(", \"{course}\""), "check");
        assert!(!said.contains("overshoots"), "{course}: {said}");
    }
    let smooth: Vec<String> =
        (0..9).map(|k| f64::from(k) / 4.0).map(|t| format!("{t},{}", (3.0 * t).sin())).collect();
    let said = warned(folder.path(), &smooth.join("\n"), "", "check");
    assert!(!said.contains("overshoots"), "{said}");
}

#[test]
fn a_table_read_as_monotone_stays_within_its_data() {
    let folder = tempfile::tempdir().expect("a folder");
    warned(folder.path(), "0,0\n1,0\n1.001,100\n2,100\n", ", \"monotone\"", "check");
    let table = answer(machinist(
        folder.path(),
        &["run", "pushed.toml", "--algebra", "plain", "--columns", "load", "--out", "-"],
    ));
    let loads = table.lines().skip(1).map(|line| line.rsplit(',').next().expect("a cell"));
    let loads: Vec<f64> = loads.map(|load| load.parse().expect("a number")).collect();
    assert!(loads.len() > 100 && loads.iter().all(|load| (0.0..=100.0).contains(load)));
}
