//! Redundant constraints: dropped with a note if they follow from others everywhere, refused if
//! they contradict.

use std::fs;

use crate::process::{answer, assert_refused, machinist, output, said};

/// Returns a door that turns about a vertical axis, held by the constraints in `hinges` and closed
/// by a spring: J = m w^2/3 about the axis.
fn door(hinges: &str) -> String {
    format!(
        r#"
[scene]
name = "door"
[units.door]
unit = "door"
[initial]
"door.phi" = 0.5
[guess]
"door.x" = 0.4
"door.y" = 0.2
[outputs]
phi = "door.phi"
height = "door.z"
[run]
until = 2
points = 21
rtol = 1e-10
method = "dop853"
[define.door.coordinates]
x = {{ unit = "m" }}
y = {{ unit = "m" }}
z = {{ unit = "m" }}
phi = {{ unit = "rad" }}
[define.door.parameters]
mass = {{ value = 20, unit = "kg" }}
width = {{ value = 0.9, unit = "m" }}
upper = {{ value = 0.45, unit = "m" }}
stiffness = {{ value = 30, unit = "N m/rad" }}
[define.door.energy]
kinetic = "mass*(x_dot^2 + y_dot^2 + z_dot^2 + width^2*phi_dot^2/12)/2"
potential = "stiffness*phi^2/2 + mass*9.81 [m/s^2]*z"
[define.door.constraints]
lower_x = {{ expression = "x - width/2*cos(phi)" }}
lower_y = {{ expression = "y - width/2*sin(phi)" }}
lower_z = {{ expression = "z" }}
{hinges}
"#
    )
}

/// The same position of the axis, further up.
const UPPER: &str = r#"upper_x = { expression = "x - width/2*cos(phi)" }
upper_y = { expression = "y - width/2*sin(phi)" }
upper_z = { expression = "2*z" }"#;

/// The same position, as long as a parameter has its value.
const ALIGNED: &str = r#"upper_x = { expression = "x - upper*cos(phi)" }"#;

fn written(hinges: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("door.toml"), door(hinges)).expect("written");
    folder
}

fn run(folder: &tempfile::TempDir, more: &[&str]) -> std::process::Command {
    machinist(folder, &[&["run", "door.toml", "--algebra", "plain"], more].concat())
}

fn angles(hinges: &str) -> Vec<f64> {
    let table = answer(run(&written(hinges), &["--columns", "phi", "--out", "-"]));
    let cells = table.lines().skip(1).map(|row| row.rsplit(',').next().expect("a cell"));
    cells.map(|cell| cell.parse().expect("a number")).collect()
}

#[test]
fn a_door_on_two_hinges_swings_as_on_one_and_says_what_was_dropped() {
    let (one, two, three) = (angles(""), angles(UPPER), angles(ALIGNED));
    let natural = (30.0_f64 / (20.0 * 0.81 / 3.0)).sqrt();
    for (index, ((one, two), three)) in one.iter().zip(&two).zip(&three).enumerate() {
        let exact = 0.5 * (natural * 0.1 * index as f64).cos();
        for found in [one, two, three] {
            assert!((found - exact).abs() < 1e-8, "{index}: {found} {exact}");
        }
    }
    let told = said(&output(run(&written(UPPER), &[])));
    for name in ["door.upper_x", "door.upper_y", "door.upper_z"] {
        let words = format!("constraint `{name}` of door follows from `door.lower");
        assert!(told.contains(&words), "{told}");
    }
    assert!(!said(&output(run(&written(""), &[]))).contains("follows from"));
}

#[test]
fn checks_of_a_door_on_two_hinges_pass() {
    let folder = written(UPPER);
    let check = answer(machinist(&folder, &["check", "door.toml", "--algebra", "plain"]));
    assert!(check.contains("mobility 1 by rank"), "{check}");
    let verify = answer(machinist(&folder, &["verify", "door.toml", "--algebra", "plain"]));
    assert!(verify.contains(" 0 failed") && !verify.contains("not checked"), "{verify}");
    answer(machinist(
        &folder,
        &["compile", "door.toml", "--out", "door.model", "--algebra", "plain"],
    ));
    answer(machinist(&folder, &["run", "door.model"]));
}

#[test]
fn a_parameter_on_which_it_rests_that_a_constraint_follows_is_not_changed() {
    let folder = written(ALIGNED);
    let words = "the change of parameter `door.upper` is 0, so that constraint `door.upper_x`";
    assert_refused(run(&folder, &["--set", "door.upper=0.5"]), &[words]);
    assert_refused(run(&folder, &["--set", "door.width=0.8"]), &["parameter `door.width`"]);
    answer(run(&folder, &["--set", "door.mass=10"]));
    answer(run(&written(UPPER), &["--set", "door.width=0.8"]));
}

#[test]
fn hinges_that_contradict_each_other_are_refused() {
    for hinges in [
        r#"upper_x = { expression = "x - width/2*cos(phi) - 0.01 [m]" }"#,
        r#"upper_z = { expression = "z - 0.1 [m]" }"#,
    ] {
        assert_refused(run(&written(hinges), &[]), &["no initial position fulfils"]);
    }
}

/// The constraint follows from others only at the start; elsewhere it jams the door.
#[test]
fn what_follows_from_others_only_at_the_start_is_refused() {
    let jam = r#"jam = { expression = "x - width/2*cos(phi) + (phi - 0.5 [rad])^2*1 [m/rad^2]" }"#;
    assert_refused(run(&written(jam), &[]), &["says nothing that is new beside"]);
}
