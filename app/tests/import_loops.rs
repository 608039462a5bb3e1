//! `machinist import`: loops of robots from SDF and MJCF.

use std::f64::consts::FRAC_PI_2;

use crate::process::{answer, machinist};

/// A coupler between two parallel cranks of length 0.5 m, in the plane of x and z. The last joint, of the
/// type `closing`, closes the loop. Where it is fixed, the coupler is in two halves. Rotations of joints
/// and their axes are texts by name.
fn linkage(closing: &str, axes: impl Fn(&str) -> [String; 2]) -> String {
    let link = |name: &str, x: f64, z: f64, mass: f64| {
        format!(
            "<link name=\"{name}\"><pose>{x} 0 {z} 0 0 0</pose><inertial><mass>{mass}</mass><inertia>\
             <ixx>0.02</ixx><iyy>0.03</iyy><izz>0.01</izz></inertia></inertial></link>"
        )
    };
    let joint = |name: &str, kind: &str, at: &str, parent: &str, child: &str| {
        let [turn, axis] = axes(name);
        let axis = format!("<axis><xyz>{axis}</xyz></axis>");
        let axis = if kind == "revolute" { &*axis } else { "" };
        format!(
            "<joint name=\"{name}\" type=\"{kind}\"><pose relative_to=\"__model__\">{at} {turn}</pose>\
             <parent>{parent}</parent><child>{child}</child>{axis}</joint>"
        )
    };
    let (end, half) = if closing == "fixed" { ("far", 1.5) } else { ("coupler", 3.0) };
    let mut text = link("a", 0.0, -0.25, 1.0) + link("b", 1.0, -0.25, 1.0).as_str();
    text += &link("coupler", 0.5, -0.5, half);
    text += &joint("pin a", "revolute", "0 0 0", "world", "a");
    text += &joint("pin b", "revolute", "1 0 0", "world", "b");
    text += &joint("carry", "revolute", "0 0 -0.5", "a", "coupler");
    if closing == "fixed" {
        text += &link(end, 0.5, -0.5, half);
        text += &joint("rest", "revolute", "1 0 -0.5", "b", end);
        text += &joint("close", closing, "0.5 0 -0.5", "coupler", end);
    } else {
        text += &joint("close", closing, "1 0 -0.5", "b", end);
    }
    format!(
        "<sdf version=\"1.9\"><world name=\"w\"><gravity>0 0 -9.81</gravity><model name=\"linkage\">\
         <pose>0.3 -0.2 1 0 0 0.7</pose>{text}</model></world></sdf>"
    )
}

/// The same in MJCF. One crank is turned by a quarter about x, as `quarter` says in radians, and its axis
/// is -z.
fn linkage_of_mujoco(closing: &str, quarter: Option<&str>) -> String {
    let body = |name: &str, [x, z]: [f64; 2], pin: &str, at: [f64; 2], mass: f64| {
        let inertia = "0.02 0.03 0.01";
        let place = format!("{} 0 {}", at[0], at[1]);
        let (turn, axis, at, inertia) = match quarter.filter(|_| name == "b") {
            None => ("0", "0 1 0", place, inertia),
            Some(quarter) => (quarter, "0 0 -1", format!("0 {} 0", at[1]), "0.02 0.01 0.03"),
        };
        format!(
            "<body name=\"{name}\" pos=\"{x} 0 {z}\" euler=\"{turn} 0 0\"><joint name=\"{pin}\" \
             axis=\"{axis}\" pos=\"{at}\"/><inertial pos=\"0 0 0\" mass=\"{mass}\" \
             diaginertia=\"{inertia}\"/>"
        )
    };
    let half = if closing == "weld" { 1.5 } else { 3.0 };
    let mut text = body("a", [0.0, -0.25], "pin a", [0.0, 0.25], 1.0);
    text += &body("coupler", [0.5, -0.25], "carry", [-0.5, 0.0], half);
    text += "</body></body>";
    text += &body("b", [1.0, -0.25], "pin b", [0.0, 0.25], 1.0);
    let equality = match closing {
        "weld" => {
            text += &body("far", [-0.5, -0.25], "rest", [0.5, 0.0], half);
            text += "</body>";
            "<weld name=\"close\" body1=\"coupler\" body2=\"far\"/>"
        }
        // Without a loop: the coupler keeps its direction as the joint of one crank says.
        "joint" => {
            "<joint joint1=\"carry\" joint2=\"pin a\" polycoef=\"0 -1 0 0 0\"/>\
             <joint joint1=\"pin b\" joint2=\"pin a\"/>"
        }
        _ if quarter.is_some() => {
            "<connect name=\"close\" body1=\"b\" body2=\"coupler\" anchor=\"0 -0.25 0\"/>"
        }
        _ => "<connect name=\"close\" body1=\"b\" body2=\"coupler\" anchor=\"0 0 -0.25\"/>",
    };
    format!(
        "<mujoco model=\"linkage\"><compiler angle=\"radian\"/><option gravity=\"0 0 -9.81\"/>\
         <worldbody>{text}</body></worldbody><equality>{equality}</equality></mujoco>"
    )
}

/// Imports a linkage and checks that the cranks move as one pendulum, whose period at this amplitude
/// is that of an elliptic integral, and that the coupler does not turn. Some of the `cranks` have mass. Returns the notes of the import.
fn swings_as_one_pendulum(file: &str, text: &str, cranks: f64, wanted: &str) -> String {
    // Moments about the pins, and of the coupler's mass at the ends of the cranks.
    let inertia = cranks * (0.03 + 0.25 * 0.25) + 3.0 * 0.25;
    let moment = 9.81 * (cranks * 0.25 + 3.0 * 0.5);
    let amplitude: f64 = 0.6;
    // The mean of arithmetic and geometric means of 1 and cos(amplitude/2).
    let (mut one, mut other) = (1.0, (amplitude / 2.0).cos());
    for _ in 0..6 {
        (one, other) = (f64::midpoint(one, other), f64::sqrt(one * other));
    }
    let period = std::f64::consts::TAU * f64::sqrt(inertia / moment) / one;
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join(file), text).expect("written");
    let call = ["import", file, "--out", "loop.toml"];
    let output = machinist(&folder, &call).output().expect("it starts");
    let noted = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success() && noted.contains(wanted), "{noted}");
    let path = folder.path().join("loop.toml");
    let scene = std::fs::read_to_string(&path).expect("a scene");
    // The linkage has a second assembly, in which its cranks cross.
    let has_loop = scene.contains("coordinates.pin_b");
    let guess =
        format!("[guess]\n\"robot.pin_b\" = {amplitude}\n\"robot.carry\" = {}\n", -amplitude);
    let scene = scene.replace("until = 1.0", &format!("until = {period:?}"))
        + format!("\n[initial]\n\"robot.pin_a\" = {amplitude:?}\n").as_str()
        + if has_loop { &guess } else { "" };
    std::fs::write(&path, scene).expect("written");
    let run = ["run", "loop.toml", "--rtol", "1e-11", "--no-error", "--out", "-"];
    let table = answer(machinist(&folder, &run));
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().expect("a head").split(',').collect();
    let rows: Vec<Vec<f64>> = lines
        .map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    let place = |name: &str| {
        let is_it = |known: &&str| known.split(" [").next() == Some(name);
        names.iter().position(is_it)
    };
    let a = place("robot.pin_a").expect("a column");
    let last = rows.last().expect("rows");
    assert!((last[a] - amplitude).abs() < 1e-8, "{wanted}: {} at the end", last[a]);
    // Joints that follow others have no columns.
    let (Some(b), Some(carry)) = (place("robot.pin_b"), place("robot.carry")) else { return noted };
    for row in &rows {
        let gap = (row[a] - row[b]).abs().max((row[a] + row[carry]).abs());
        assert!(gap < 1e-9, "{wanted}: {row:?}");
    }
    noted
}

/// Returns axes along y, of which that of one pin is off by an angle.
fn along_y(tilt: f64) -> impl Fn(&str) -> [String; 2] {
    move |name| {
        let off = if name == "pin b" { tilt } else { 0.0 };
        ["0 0 0".to_owned(), format!("{off:e} 1 0")]
    }
}

/// Returns axes along the z axes of frames that are turned by a quarter about x, and differently in the
/// plane of the linkage, as a number of digits leaves them.
fn turned(written: impl Fn(f64) -> String) -> impl Fn(&str) -> [String; 2] {
    move |name| {
        let pitch = match name {
            "pin a" => 1.343_903_524_035_6,
            "pin b" => -0.364_021_863_402_61,
            "carry" => 0.050_273_815_295_7,
            "rest" => 2.218_453_012_943_8,
            _ => -1.091_235_502_187,
        };
        let angles = [FRAC_PI_2, pitch, 0.0].map(&written);
        [angles.join(" "), "0 0 1".to_owned()]
    }
}

/// Returns a unit of the last digit of a quarter turn.
fn significant_unit(digits: usize) -> f64 {
    0.1_f64.powi(digits as i32 - 1)
}

/// Returns a number with some significant digits, without zeros at the end.
fn significant(value: f64, digits: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", digits - 1).parse().expect("a number");
    rounded.to_string()
}

#[test]
fn loops_of_gazebo_are_closed_by_constraints() {
    for (closing, tilt, wanted) in [
        ("revolute", 0.0, "2 constraints close the planar loop at joint `close`"),
        ("revolute", 1e-12, "5 constraints close the loop at joint `close`"),
        ("ball", 0.0, "2 constraints close the planar loop at joint `close`"),
        ("ball", 3e-13, "3 constraints close the loop at joint `close`"),
        ("ball", 2e-11, "3 constraints close the loop at joint `close`"),
        // A loop is cut where it takes the fewest equations.
        ("fixed", 0.0, "2 constraints close the planar loop at joint `rest`"),
        ("fixed", 1e-12, "5 constraints close the loop at joint `rest`"),
    ] {
        swings_as_one_pendulum("loop.sdf", &linkage(closing, along_y(tilt)), 2.0, wanted);
    }
}

/// Files of few digits leave axes of a planar loop off by up to 1e-4.
#[test]
fn loops_are_planar_within_the_digits_of_their_file() {
    for digits in [4, 5, 6, 8, 10] {
        for (closing, wanted) in [
            ("revolute", "2 constraints close the planar loop at joint `close`"),
            ("ball", "2 constraints close the planar loop at joint `close`"),
            ("fixed", "2 constraints close the planar loop at joint `rest`"),
        ] {
            let decimals = linkage(closing, turned(|angle| format!("{angle:.digits$}")));
            let shortest = linkage(closing, turned(|angle| significant(angle, digits)));
            for text in [decimals, shortest] {
                let noted = swings_as_one_pendulum("loop.sdf", &text, 2.0, wanted);
                assert!(noted.contains("within the digits of the file"), "{digits}: {noted}");
            }
        }
        // Other links than the axes are off by the square of the rounding.
        let quarter = significant(FRAC_PI_2, digits.max(5));
        let text = linkage_of_mujoco("connect", Some(&quarter));
        let wanted = "2 constraints close the planar loop at joint `close`";
        let noted = swings_as_one_pendulum("loop.xml", &text, 2.0, wanted);
        assert!(noted.contains("within the digits of the file"), "{digits}: {noted}");
    }
}

/// A crank of length 0.2 m, a rod of 0.7 m and a slider along x, without weight. The last of the joints
/// closes the loop.
fn slider_crank(closing: &str, axes: impl Fn(&str) -> [String; 2]) -> String {
    let link = |name: &str, x: f64, mass: f64| {
        format!(
            "<link name=\"{name}\"><pose>{x} 0 0 0 0 0</pose><inertial><mass>{mass}</mass><inertia>\
             <ixx>0.01</ixx><iyy>0.02</iyy><izz>0.02</izz></inertia></inertial></link>"
        )
    };
    let joint = |name: &str, kind: &str, x: f64, parent: &str, child: &str| {
        let [turn, axis] =
            if kind == "revolute" { axes(name) } else { ["0 0 0", "1 0 0"].map(str::to_owned) };
        format!(
            "<joint name=\"{name}\" type=\"{kind}\"><pose relative_to=\"__model__\">{x} 0 0 {turn}</pose>\
             <parent>{parent}</parent><child>{child}</child><axis><xyz>{axis}</xyz></axis></joint>"
        )
    };
    let links =
        [link("crank", 0.1, 0.5), link("rod", 0.55, 0.8), link("slider", 0.9, 1.5)].concat();
    let slide = joint("slide", "prismatic", 0.9, "world", "slider");
    let end = joint("pin b", "revolute", 0.9, "rod", "slider");
    let last = if closing == "slide" { [end, slide] } else { [slide, end] };
    let first = joint("pin a", "revolute", 0.0, "world", "crank");
    let joints = [first, joint("carry", "revolute", 0.2, "crank", "rod"), last.concat()].concat();
    format!(
        "<sdf version=\"1.9\"><world name=\"w\"><gravity>0 0 0</gravity><model name=\"linkage\">{links}{joints}\
         </model></world></sdf>"
    )
}

/// The crank keeps the energy of its slider and rod, whose motion is that of the closed form.
#[test]
fn a_slider_crank_is_planar_within_the_digits_of_its_file() {
    const START: f64 = 12.0;
    let energy = |angle: f64, speed: f64| {
        let (sine, cosine) = angle.sin_cos();
        let rod = 0.7 * (1.0 - (0.2 / 0.7 * sine).powi(2)).sqrt();
        let slider = -0.2 * speed * sine * (1.0 + 0.2 * cosine / rod);
        let turn = -0.2 * speed * cosine / rod;
        let middle = [f64::midpoint(slider, -0.2 * speed * sine), 0.1 * speed * cosine];
        let of_rod = 0.8 * (middle[0].powi(2) + middle[1].powi(2)) + 0.02 * turn * turn;
        (0.025 * speed * speed + of_rod + 1.5 * slider * slider) / 2.0
    };
    for (digits, closing) in [(4, "slide"), (4, "pin b"), (6, "slide"), (6, "pin b"), (9, "slide")]
    {
        let text = slider_crank(closing, turned(|angle| significant(angle, digits)));
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("loop.sdf"), text).expect("written");
        let output = machinist(&folder, &["import", "loop.sdf", "--out", "loop.toml"]).output();
        let noted = String::from_utf8_lossy(&output.expect("it starts").stderr).into_owned();
        let wanted = format!("2 constraints close the planar loop at joint `{closing}`");
        assert!(noted.contains(&wanted) && noted.contains("within the digits"), "{noted}");
        let path = folder.path().join("loop.toml");
        let scene = std::fs::read_to_string(&path).expect("a scene");
        let start = format!("\n[initial]\n\"robot.pin_a_dot\" = {START:?}\n");
        std::fs::write(&path, [scene, start].concat()).expect("written");
        let columns = "robot.pin_a,robot.carry,robot.pin_a_dot";
        let run = ["run", "loop.toml", "--rtol", "1e-11", "--no-error", "--out", "-"];
        let table = answer(machinist(&folder, &[&run[..], &["--columns", columns]].concat()));
        // The plane is inclined to x by the rounding of angles, so lengths are off by its square.
        let allowed = 1e-10 + significant_unit(digits).powi(2);
        let mut turns = 0.0_f64;
        for row in table.lines().skip(1) {
            let cells = row.split(',').map(|cell| cell.parse().expect("a number"));
            let [_, angle, carry, speed] = cells.collect::<Vec<f64>>()[..] else { panic!("{row}") };
            let gap = 0.2 * angle.sin() + 0.7 * (angle + carry).sin();
            assert!(gap.abs() < allowed, "{digits}, {closing}: {gap}");
            let lost = energy(angle, speed) / energy(0.0, START) - 1.0;
            assert!(lost.abs() < 100.0 * allowed, "{digits}, {closing}: {lost}");
            turns = turns.max(angle / std::f64::consts::TAU);
        }
        assert!(turns > 1.0, "{turns}");
    }
}

/// An axis that is off by more than the digits of the file jams the loop.
#[test]
fn loops_that_are_not_planar_are_kept() {
    for (text, tilted) in [
        (linkage("revolute", along_y(3e-5)), "3e-5 1 0"),
        (linkage("ball", turned(|angle| format!("{:.9}", angle - 1e-6 * (angle + 1.0).cos()))), ""),
    ] {
        assert!(text.contains(tilted), "{text}");
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("loop.sdf"), text).expect("written");
        let output = machinist(&folder, &["import", "loop.sdf", "--out", "loop.toml"]).output();
        let noted = String::from_utf8_lossy(&output.expect("it starts").stderr).into_owned();
        assert!(!noted.contains("within the digits"), "{noted}");
    }
}

#[test]
fn equalities_of_mujoco_are_constraints() {
    for (closing, quarter, wanted) in [
        ("connect", None, "2 constraints close the planar loop at joint `close`"),
        (
            "connect",
            Some("1.5707963267948966"),
            "2 constraints close the planar loop at joint `close`",
        ),
        ("weld", None, "6 constraints close the loop at joint `close`"),
        ("joint", None, ""),
    ] {
        swings_as_one_pendulum("loop.xml", &linkage_of_mujoco(closing, quarter), 2.0, wanted);
    }
}

/// The joint of a crank without mass is not held: the loop moves it.
#[test]
fn a_crank_without_mass_moves_with_its_loop() {
    let text = linkage_of_mujoco("connect", None);
    let (before, crank) = text.split_once("<body name=\"b\"").expect("a crank");
    let (joint, after) = crank.split_once("<inertial").expect("its inertia");
    let (_, after) = after.split_once("/>").expect("an end");
    let text = format!("{before}<body name=\"b\"{joint}{after}");
    let wanted = "2 constraints close the planar loop at joint `close`";
    let noted = swings_as_one_pendulum("loop.xml", &text, 1.0, wanted);
    assert!(!noted.contains("no inertia"), "{noted}");
}
