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

/// Both hinges at the height of their own: their forces in the same direction are equal, 2 z counts
/// twice.
#[test]
fn hinges_share_forces_if_asked_to() {
    let outputs = "\
        a = { expression = \"door.lower_x\", unit = \"N\" }\n\
        b = { expression = \"door.upper_x\", unit = \"N\" }\n\
        c = { expression = \"door.lower_z\", unit = \"N\" }\n\
        d = { expression = \"door.upper_z\", unit = \"N\" }\n\
        phi = \"door.phi\"";
    let spec = |share: &str| {
        door(UPPER)
            .replace("name = \"door\"", &format!("name = \"door\"\n{share}"))
            .replace("phi = \"door.phi\"", outputs)
    };
    let forces = |share: &str| {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("door.toml"), spec(share)).expect("written");
        let verify = answer(machinist(&folder, &["verify", "door.toml", "--algebra", "plain"]));
        assert!(verify.contains(" 0 failed") && !verify.contains("not checked"), "{verify}");
        let table = answer(run(&folder, &["--columns", "a,b,c,d,phi", "--out", "-"]));
        let row = |row: &str| {
            row.split(',').skip(1).map(|cell| cell.parse().expect("a number")).collect()
        };
        table.lines().skip(1).map(row).collect::<Vec<Vec<f64>>>()
    };
    let (alone, shared) = (forces(""), forces("share_redundant = true"));
    let weight = 20.0 * 9.81;
    for (alone, shared) in alone.iter().zip(&shared) {
        let [a, b, c, d, phi] = shared[..] else { panic!("{shared:?}") };
        assert!((phi - alone[4]).abs() < 1e-9, "{phi}");
        assert!((a - alone[0] / 2.0).abs() < 1e-6 && (a - b).abs() < 1e-9, "{a} {b} {alone:?}");
        // c + 2 d = m g with c^2 + d^2 least.
        assert!((c - weight / 5.0).abs() < 1e-6 && (d - 2.0 * c).abs() < 1e-6, "{c} {d}");
        assert!(alone[1] == 0.0 && (alone[2] - weight).abs() < 1e-6, "{alone:?}");
    }
}

/// The constraint follows from others only at the start; elsewhere it jams the door.
#[test]
fn what_follows_from_others_only_at_the_start_is_refused() {
    let jam = r#"jam = { expression = "x - width/2*cos(phi) + (phi - 0.5 [rad])^2*1 [m/rad^2]" }"#;
    assert_refused(run(&written(jam), &[]), &["says nothing that is new beside"]);
}

/// Returns the head of a scene with one unit, whose coordinate starts at a value and is an output.
fn head(scene: &str, (unit, coordinate): (&str, &str), start: f64, output: &str) -> String {
    format!(
        r#"
[scene]
name = "{scene}"
[units.{unit}]
unit = "{unit}"
[initial]
"{unit}.{coordinate}" = {start}
[outputs]
{output} = "{unit}.{coordinate}"
[run]
until = 2
points = 21
rtol = 1e-10
method = "dop853"
"#
    )
}

/// Returns a bar of mass 20 kg on parallel cranks of 0.4 m, whose constraints beyond the second crank
/// follow from others on the branch of its motion only.
fn bar_on_cranks(places: &[f64], start: f64) -> String {
    let mut text = head("bar", ("bar", "a0"), start, "angle");
    text.push_str(
        r#"
[define.bar.parameters]
length = { value = 0.4, unit = "m" }
[define.bar.coordinates]
x = { unit = "m" }
y = { unit = "m" }
psi = { unit = "rad" }
"#,
    );
    let write = |text: &mut String, line: &str| {
        text.push_str(line);
        text.push('\n');
    };
    let names: Vec<String> = (0..places.len()).map(|index| format!("a{index}")).collect();
    for name in &names {
        write(&mut text, &format!(r#"{name} = {{ unit = "rad" }}"#));
    }
    let speeds: Vec<String> = names.iter().map(|name| format!("{name}_dot^2")).collect();
    write(&mut text, "[define.bar.energy]");
    let kinetic = format!(
        "10 [kg]*(x_dot^2 + y_dot^2) + psi_dot^2*1 [kg m^2] + 0.05 [kg m^2]*({})",
        speeds.join(" + ")
    );
    write(&mut text, &format!(r#"kinetic = "{kinetic}""#));
    write(&mut text, r#"potential = "20 [kg]*9.81 [m/s^2]*y""#);
    write(&mut text, "[define.bar.constraints]");
    for (name, place) in names.iter().zip(places) {
        let along = format!("x + {place} [m]*(cos(psi) - 1) - length*sin({name})");
        let up = format!("y + {place} [m]*sin(psi) + length*cos({name})");
        write(&mut text, &format!(r#"{name}_along = {{ expression = "{along}" }}"#));
        write(&mut text, &format!(r#"{name}_up = {{ expression = "{up}" }}"#));
    }
    write(&mut text, "[guess]");
    write(
        &mut text,
        &format!("\"bar.x\" = {}\n\"bar.y\" = {}", 0.4 * start.sin(), -0.4 * start.cos()),
    );
    for name in &names[1..] {
        write(&mut text, &format!("\"bar.{name}\" = {start}"));
    }
    text
}

/// The pendulum that turns as the cranks do.
fn crank(cranks: usize, start: f64) -> String {
    let head = head("crank", ("bar", "a0"), start, "angle");
    format!(
        r#"{head}
[define.bar.coordinates]
a0 = {{ unit = "rad" }}
[define.bar.energy]
kinetic = "(10 [kg]*(0.4 [m])^2 + {cranks}*0.05 [kg m^2])*a0_dot^2"
potential = "-20 [kg]*9.81 [m/s^2]*0.4 [m]*cos(a0)"
"#
    )
}

/// A door on two ball hinges in space, by Euler angles: its six constraints have rank five where they
/// are fulfilled, since the distance of the hinges is that of the body.
fn door_in_space(lean: f64) -> String {
    let head = head("door", ("d", "a"), 0.5, "phi");
    format!(
        r#"{head}
[define.d.coordinates]
x = {{ unit = "m" }}
y = {{ unit = "m" }}
z = {{ unit = "m" }}
a = {{ unit = "rad" }}
b = {{ unit = "rad" }}
c = {{ unit = "rad" }}
[define.d.parameters]
w = {{ value = 0.4, unit = "m" }}
h = {{ value = 0.9, unit = "m" }}
[define.d.helpers]
rx = {{ expression = "cos(a)*cos(b)", unit = "1" }}
ry = {{ expression = "sin(a)*cos(b)", unit = "1" }}
rz = {{ expression = "-sin(b)", unit = "1" }}
ux = {{ expression = "cos(a)*sin(b)*cos(c) + sin(a)*sin(c)", unit = "1" }}
uy = {{ expression = "sin(a)*sin(b)*cos(c) - cos(a)*sin(c)", unit = "1" }}
uz = {{ expression = "cos(b)*cos(c)", unit = "1" }}
p = {{ expression = "c_dot - a_dot*sin(b)", unit = "rad/s" }}
q = {{ expression = "b_dot*cos(c) + a_dot*cos(b)*sin(c)", unit = "rad/s" }}
r = {{ expression = "-b_dot*sin(c) + a_dot*cos(b)*cos(c)", unit = "rad/s" }}
[define.d.energy]
kinetic = "10 [kg]*(x_dot^2 + y_dot^2 + z_dot^2) + 1 [kg m^2]*(p^2 + q^2 + r^2)"
potential = "15 [N m]*a^2 + 196.2 [N]*(z + {lean}*(x - w))"
[define.d.constraints]
lower_x = {{ expression = "x - w*rx - h*ux" }}
lower_y = {{ expression = "y - w*ry - h*uy" }}
lower_z = {{ expression = "z - w*rz - h*uz + h" }}
upper_x = {{ expression = "x - w*rx + h*ux" }}
upper_y = {{ expression = "y - w*ry + h*uy" }}
upper_z = {{ expression = "z - w*rz + h*uz - h" }}
"#
    )
}

/// The same about its axis.
fn door_about_its_axis(lean: f64) -> String {
    let head = head("door", ("d", "a"), 0.5, "phi");
    format!(
        r#"{head}
[define.d.coordinates]
a = {{ unit = "rad" }}
[define.d.energy]
kinetic = "(10 [kg]*(0.4 [m])^2 + 1 [kg m^2])*a_dot^2"
potential = "15 [N m]*a^2 + 196.2 [N]*{lean}*0.4 [m]*cos(a)"
"#
    )
}

/// Runs two scenes; the first says what it dropped, and both move alike.
fn assert_same_motion(redundant: &str, plain: &str, dropped: &[&str]) {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("redundant.toml"), redundant).expect("written");
    fs::write(folder.path().join("plain.toml"), plain).expect("written");
    let column = |scene: &str, name: &str| -> Vec<f64> {
        let words = ["run", scene, "--columns", name, "--out", "-", "--algebra", "plain"];
        let table = answer(machinist(&folder, &words));
        let cells = table.lines().skip(1).map(|row| row.rsplit(',').next().expect("a cell"));
        cells.map(|cell| cell.parse().expect("a number")).collect()
    };
    let name = if redundant.contains("angle =") { "angle" } else { "phi" };
    for (found, exact) in column("redundant.toml", name).iter().zip(column("plain.toml", name)) {
        assert!((found - exact).abs() < 1e-7, "{found} {exact}\n{redundant}");
    }
    let command = machinist(&folder, &["run", "redundant.toml", "--algebra", "plain"]);
    let told = said(&output(command));
    for name in dropped {
        assert!(told.contains(&format!("constraint `{name}` of")), "{name}: {told}");
    }
}

#[test]
fn constraints_that_follow_on_the_branch_of_the_motion_are_dropped() {
    for places in [&[-0.9, 0.9, 0.0][..], &[0.0, 1.3, 0.4], &[-0.5, 0.5, 0.2, -0.1]] {
        for start in [0.2, 0.5, -0.9, 1.2, 2.0] {
            let dropped: Vec<String> =
                (2..places.len()).map(|index| format!("bar.a{index}_up")).collect();
            let dropped: Vec<&str> = dropped.iter().map(String::as_str).collect();
            let redundant = bar_on_cranks(places, start);
            assert_same_motion(&redundant, &crank(places.len(), start), &dropped);
        }
    }
    for lean in [0.0, 0.1, -0.3] {
        assert_same_motion(&door_in_space(lean), &door_about_its_axis(lean), &["d.upper_z"]);
    }
}
