//! `machinist import`: links with mass and without inertia.

use std::fmt::Write as _;

use crate::process::{answer, assert_refused, machinist};

/// Mass and place of a link, and its inertia if it is not a point.
type Mass<'a> = Option<(f64, &'a str, [f64; 3])>;

/// A chain of joints, each with its type, its axis and the mass of the link that it carries. The frame of
/// each link is 0.5 m along x from that before, the first at the world.
fn chain(joints: &[(&str, &str, Mass<'_>)]) -> String {
    let mut text = "<robot name=\"chain\"><link name=\"base\"/>".to_owned();
    for (at, (kind, axis, mass)) in joints.iter().enumerate() {
        let parent = if at == 0 { "base".to_owned() } else { format!("link{at}") };
        let (number, x) = (at + 1, if at == 0 { 0.0 } else { 0.5 });
        let _ = write!(
            text,
            "<joint name=\"j{number}\" type=\"{kind}\"><origin xyz=\"{x} 0 0\"/><axis xyz=\"{axis}\"/>\
             <parent link=\"{parent}\"/><child link=\"link{number}\"/></joint><link name=\"link{number}\">"
        );
        if let Some((mass, place, [xx, yy, zz])) = mass {
            let _ = write!(
                text,
                "<inertial><origin xyz=\"{place}\"/><mass value=\"{mass}\"/><inertia ixx=\"{xx}\" \
                 iyy=\"{yy}\" izz=\"{zz}\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>"
            );
        }
        text += "</link>";
    }
    text + "</robot>"
}

const POINT: [f64; 3] = [0.0; 3];
const TURN: &str = "continuous";

/// Imports a chain, and returns its folder and the notes.
fn imported(text: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("chain.urdf"), text).expect("written");
    let call = ["import", "chain.urdf", "--out", "chain.toml"];
    let output = machinist(&folder, &call).output().expect("it starts");
    let noted = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{noted}");
    (folder, noted)
}

fn rows(folder: &tempfile::TempDir, columns: &str) -> Vec<Vec<f64>> {
    let run = ["run", "chain.toml", "--rtol", "1e-10", "--no-error", "--out", "-"];
    let table = answer(machinist(folder, &[&run[..], &["--columns", columns]].concat()));
    let row =
        |line: &str| line.split(',').skip(1).map(|cell| cell.parse().expect("a number")).collect();
    table.lines().skip(1).map(row).collect()
}

/// A pendulum with a point mass on the axis of a second joint, which rounding leaves off by nanometres or
/// with a moment of inertia. The mass counts, wherever its joint is.
#[test]
fn joints_with_mass_on_their_axis_are_fixed() {
    for (place, inertia) in [
        ("0 0.2 0", POINT),
        ("1e-17 0.2 0", [0.0, 1e-20, 0.0]),
        ("3e-9 0.2 -5e-10", [0.0, -5.421e-20, 0.0]),
        ("5e-7 0.2 0", POINT),
        ("0 0 0", POINT),
    ] {
        let arm = Some((1.0, "0.3 0 0", [0.01, 0.02, 0.02]));
        let text = chain(&[(TURN, "0 1 0", arm), (TURN, "0 1 0", Some((0.5, place, inertia)))]);
        let (folder, noted) = imported(&text);
        let wanted = "joint `j2` is fixed: its motion moves no inertia";
        assert!(noted.contains(wanted), "{place}: {noted}");
        let (about_axis, moment) = (0.02 + 0.09 + 0.5 * 0.25, 9.81 * (0.3 + 0.5 * 0.5));
        for row in rows(&folder, "robot.j1,robot.j1_dot") {
            let energy = about_axis * row[1] * row[1] / 2.0 - moment * row[0].sin();
            assert!(energy.abs() < 1e-5, "{place}: {row:?}");
        }
    }
    // A millimetre is no rounding, and neither is the inertia of a small disc.
    for (place, inertia) in [("0.001 0.2 0", POINT), ("0 0.2 0", [0.0, 1e-9, 0.0])] {
        let arm = Some((1.0, "0.3 0 0", [0.01, 0.02, 0.02]));
        let text = chain(&[(TURN, "0 1 0", arm), (TURN, "0 1 0", Some((0.5, place, inertia)))]);
        let (folder, noted) = imported(&text);
        assert!(!noted.contains("is fixed"), "{place}: {noted}");
        rows(&folder, "robot.j1");
    }
    // Without mass on its axis, the first joint is held too once the second is.
    let text = chain(&[
        (TURN, "0 0 1", Some((2.0, "0.1 0 0", POINT))),
        (TURN, "1 0 0", None),
        (TURN, "1 0 0", Some((1.0, "0.3 0 0", POINT))),
    ]);
    let (_, noted) = imported(&text);
    for joint in ["j2", "j3"] {
        assert!(noted.contains(&format!("joint `{joint}` is fixed")), "{noted}");
    }
}

/// Joints that move a point mass nowhere together, at any position.
#[test]
fn joints_that_move_nothing_together_are_refused() {
    let point = Some((0.5, "0.4 0 0.1", POINT));
    for (joints, wanted) in [
        (vec![("floating", "0 0 1", point)], "joint `j1` moves no inertia at any position"),
        (
            vec![(TURN, "1 0 0", Some((0.5, "0.4 0 0", POINT)))],
            "joint `j1` moves no inertia, and nothing else moves",
        ),
        // Three axes through a point.
        (
            vec![
                (TURN, "0 0 1", None),
                (TURN, "0 1 0", None),
                (TURN, "1 0 0", Some((0.5, "0 0 0", POINT))),
            ],
            "joint `j3` is fixed",
        ),
        // Two parallel slides.
        (
            vec![("prismatic", "1 0 0", None), ("prismatic", "1 0 0", point)],
            "joints `j1`, `j2` move no inertia together at any position",
        ),
        // A floating base that carries a point by a slide.
        (
            vec![("floating", "0 0 1", None), ("prismatic", "1 0 0", point)],
            "joint `j1` moves no inertia at any position",
        ),
    ] {
        let text = chain(&joints);
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("chain.urdf"), &text).expect("written");
        let call = ["import", "chain.urdf", "--out", "chain.toml"];
        if wanted.contains("is fixed") {
            let (_, noted) = imported(&text);
            assert!(noted.contains(wanted), "{noted}");
            continue;
        }
        let help = match wanted.split_once(", and nothing else moves") {
            None => format!("give link `link{}` its inertia about its centre", joints.len()),
            Some(_) => "give its link an inertia about its axis".to_owned(),
        };
        assert_refused(machinist(&folder, &call), &[wanted, &help]);
        assert!(!folder.path().join("chain.toml").exists(), "{wanted}");
    }
}

/// A massless arm with a point mass at its end moves nothing along itself while it is straight. From
/// another start, it is a double pendulum whose energy is that of its one mass.
#[test]
fn joints_that_move_nothing_at_zero_are_noted() {
    let point = Some((0.5, "0.4 0 0", POINT));
    let (folder, noted) = imported(&chain(&[(TURN, "0 1 0", None), (TURN, "0 1 0", point)]));
    let wanted = "joints `j1`, `j2` move no inertia together where all joints are at zero, so that no run \
                  can start there: link `link2` has no inertia about its centre";
    assert!(noted.contains(wanted), "{noted}");
    let path = folder.path().join("chain.toml");
    let text = std::fs::read_to_string(&path).expect("a scene");
    let start = "\n[initial]\n\"robot.j2\" = 1.2\n\"robot.j1_dot\" = 1.5\n";
    std::fs::write(&path, text.replace("until = 1.0", "until = 0.1") + start).expect("written");
    let energy = |row: &[f64]| {
        let (both, speed) = (row[0] + row[1], row[2] + row[3]);
        let x = -0.5 * row[2] * row[0].sin() - 0.4 * speed * both.sin();
        let z = -0.5 * row[2] * row[0].cos() - 0.4 * speed * both.cos();
        let height = -0.5 * row[0].sin() - 0.4 * both.sin();
        0.25 * (x * x + z * z) + 0.5 * 9.81 * height
    };
    let rows = rows(&folder, "robot.j1,robot.j2,robot.j1_dot,robot.j2_dot");
    // The mass falls freely, since no moment acts on the arm that carries none.
    let height = |row: &[f64]| -0.5 * row[0].sin() - 0.4 * (row[0] + row[1]).sin();
    for row in &rows {
        assert!((energy(row) - energy(&rows[0])).abs() < 1e-7, "{row:?}");
    }
    let (first, last) = (&rows[0], rows.last().expect("rows"));
    let upwards = -0.5 * first[2] * first[0].cos()
        - 0.4 * (first[2] + first[3]) * (first[0] + first[1]).cos();
    let free = height(first) + upwards * 0.1 - 9.81 * 0.005;
    assert!((height(last) - free).abs() < 1e-8, "{} {free}", height(last));
}
