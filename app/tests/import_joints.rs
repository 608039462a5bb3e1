//! `machinist import`: universal joints, screws and gearboxes of SDF, and planar joints of URDF.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use crate::process::{answer, assert_refused, machinist};

/// A link of SDF at a place, with its mass and its principal moments of inertia.
fn link(name: &str, place: &str, mass: f64, [xx, yy, zz]: [f64; 3]) -> String {
    format!(
        "<link name=\"{name}\"><pose>{place}</pose><inertial><mass>{mass}</mass><inertia><ixx>{xx}</ixx>\
         <iyy>{yy}</iyy><izz>{zz}</izz></inertia></inertial></link>"
    )
}

/// A joint of SDF at its child, with what it contains besides its links.
fn joint(name: &str, kind: &str, [parent, child]: [&str; 2], inner: &str) -> String {
    format!(
        "<joint name=\"{name}\" type=\"{kind}\"><parent>{parent}</parent><child>{child}</child>{inner}\
         </joint>"
    )
}

fn model(inner: &str) -> String {
    format!(
        "<sdf version=\"1.9\"><world name=\"w\"><gravity>0 0 -9.81</gravity><model name=\"m\">{inner}\
         </model></world></sdf>"
    )
}

/// Imports a robot, adds lines to its scene, and returns the rows of a run for some columns.
fn run(file: &str, text: &str, more: &str, columns: &str) -> Vec<Vec<f64>> {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join(file), text).expect("written");
    answer(machinist(&folder, &["import", file, "--out", "robot.toml"]));
    let path = folder.path().join("robot.toml");
    let scene = std::fs::read_to_string(&path).expect("a scene");
    std::fs::write(&path, scene + more).expect("written");
    let run = ["run", "robot.toml", "--rtol", "1e-11", "--no-error", "--out", "-"];
    let table = answer(machinist(&folder, &[&run[..], &["--columns", columns]].concat()));
    let row = |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
    table.lines().skip(1).map(row).collect()
}

fn refused(text: &str, wanted: &str) {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("bad.sdf"), text).expect("written");
    assert_refused(machinist(&folder, &["import", "bad.sdf", "--out", "bad.toml"]), &[wanted]);
    assert!(!folder.path().join("bad.toml").exists(), "{wanted}");
}

/// Two shafts under an angle beta, joined by a universal joint, whose cross is between them. The angles
/// fulfil tan(psi) = cos(beta) tan(phi), and the speeds the energy of both.
#[test]
fn shafts_with_a_universal_joint_turn_as_cardan_found() {
    let (of_input, of_output, start) = (0.4, 0.3, 5.0);
    for (beta, kind) in [(0.3_f64, "universal"), (0.9, "universal"), (0.5, "revolute2")] {
        let text = [link("input", "0 0 0 0 0 0", 1.0, [of_input, 1.0, 1.0]),
link("output", &format!("0 0 0 0 0 {beta:?}"), 1.0, [of_output, 1.0, 1.0]),
joint("drive", "revolute", ["world", "input"], "<axis><xyz>1 0 0</xyz></axis>"),
joint(
                "cross",
                kind,
                ["input", "output"],
                "<axis><xyz expressed_in=\"__model__\">0 0 1</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>",
            ),
joint("driven", "revolute", ["world", "output"], "<axis><xyz>1 0 0</xyz></axis>")].concat();
        let more = format!("\n[initial]\n\"robot.drive_dot\" = {start:?}\n");
        // The loop is cut at the joint of the output, whose angle is that of its frame.
        let outputs = "\n[outputs]\n\
            y = { expression = \"dot(y_axis(robot.output), vector(0, 0, 1))\", unit = \"1\" }\n\
            z = { expression = \"dot(z_axis(robot.output), vector(0, 0, 1))\", unit = \"1\" }\n";
        let rows = run(
            "m.sdf",
            &model(&text),
            &format!("{more}{outputs}"),
            "robot.drive,robot.drive_dot,y,z",
        );
        let rate = |phi: f64| beta.cos() / (1.0 - (beta.sin() * phi.sin()).powi(2));
        let energy =
            |phi: f64, speed: f64| (of_input + of_output * rate(phi).powi(2)) * speed * speed / 2.0;
        for row in &rows {
            let [_, phi, speed, y, z] = row[..] else { panic!("{row:?}") };
            // The arm of the cross in the input is along z, and that in the output along y at first.
            let gap = y * phi.cos() - z * beta.cos() * phi.sin();
            assert!(gap.abs() < 1e-9, "{beta}, {kind}: {gap} at {phi}");
            let lost = energy(phi, speed) / energy(0.0, start) - 1.0;
            assert!(lost.abs() < 1e-8, "{beta}, {kind}: {lost} at {phi}");
        }
        assert!(rows.last().expect("rows")[1] > 0.5 * TAU, "{beta}");
    }
}

/// A nut falls on a fixed screw: m z' + J (2 pi/p)^2 z' = -m g, less its damping.
#[test]
fn a_nut_falls_on_its_screw() {
    let (mass, about, lead) = (2.0, 0.001, 0.03);
    for (pitch, lead) in [
        (format!("<screw_thread_pitch>{lead}</screw_thread_pitch>"), lead),
        (format!("<screw_thread_pitch>{}</screw_thread_pitch>", -lead), -lead),
        (format!("<thread_pitch>{:?}</thread_pitch>", -TAU / lead), lead),
    ] {
        for damping in [0.0, 0.002] {
            let axis = format!(
                "{pitch}<axis><xyz>0 0 1</xyz><dynamics><damping>{damping}</damping></dynamics></axis>"
            );
            let text = [
                link("nut", "0 0 0.5 0 0 0", mass, [0.01, 0.01, about]),
                joint("screw", "screw", ["world", "nut"], &axis),
            ]
            .concat();
            let rows = run(
                "m.sdf",
                &model(&text),
                "\n[outputs]\nheight = \"robot.nut_z\"\n",
                "robot.screw,height",
            );
            // By the angle: (J + m h^2) phi'' + c phi' = -m g h, with h = p/(2 pi).
            let h = lead / TAU;
            let inertia = about + mass * h * h;
            for row in &rows {
                let [time, angle, height] = row[..] else { panic!("{row:?}") };
                let limit = -mass * 9.81 * h / if damping == 0.0 { 1.0 } else { damping };
                let exact = if damping == 0.0 {
                    limit / inertia * time * time / 2.0
                } else {
                    let fade = inertia / damping;
                    limit * (time - fade * (1.0 - (-time / fade).exp()))
                };
                assert!(
                    (angle - exact).abs() < 1e-8 * exact.abs().max(1.0),
                    "{pitch}: {angle} {exact}"
                );
                assert!(
                    (height - 0.5 - h * angle).abs() < 1e-12 * angle.abs().max(1.0),
                    "{pitch}: {height}"
                );
            }
        }
    }
}

/// A gearbox drives a pendulum by a rotor. The joint of the pendulum turns by -r of the rotor's angle,
/// seen from the axes, and losses act in both.
#[test]
fn a_rotor_moves_with_its_pendulum_by_a_gearbox() {
    let damping = 0.03;
    for (ratio, axis, axis2) in
        [(0.04, "1 0 0", "1 0 0"), (0.5, "1 0 0", "-1 0 0"), (-2.0, "-1 0 0", "1 0 0")]
    {
        let turns = format!(
            "<axis><xyz>1 0 0</xyz><dynamics><damping>{damping}</damping></dynamics></axis>"
        );
        let inner = format!(
            "<gearbox_reference_body>base</gearbox_reference_body><gearbox_ratio>{ratio}</gearbox_ratio>\
             <axis><xyz expressed_in=\"__model__\">{axis}</xyz></axis>\
             <axis2><xyz expressed_in=\"__model__\">{axis2}</xyz></axis2>"
        );
        let arm = "<pose relative_to=\"__model__\">0 0 1 0 0 0</pose>";
        let text = [
            link("base", "0 0 1 0 0 0", 1.0, [0.1; 3]),
            joint("stand", "fixed", ["world", "base"], ""),
            link("rotor", "0 0 1 0 0 0", 0.2, [0.001; 3]),
            link("arm", "0 0 0.7 0 0 0", 1.5, [0.02; 3]),
            joint("spin", "revolute", ["base", "rotor"], &turns),
            joint("swing", "revolute", ["base", "arm"], &format!("{arm}{turns}")),
            joint("gear", "gearbox", ["rotor", "arm"], &inner),
        ]
        .concat();
        let sign = if axis == axis2 { 1.0 } else { -1.0 };
        let factor = -ratio * sign;
        let start = 0.4 / factor;
        let more =
            format!("\n[initial]\n\"robot.spin\" = {start:?}\n[outputs]\ny = \"robot.arm_y\"\n");
        let rows = run("m.sdf", &model(&text), &more, "robot.spin,robot.spin_dot,y");
        // By the rotor's angle; small swings of the arm are not assumed.
        let inertia = 0.001 + factor * factor * (0.02 + 1.5 * 0.09);
        let loss = damping * (1.0 + factor * factor);
        let rate = |[angle, speed]: [f64; 2]| {
            let torque = -factor * 1.5 * 9.81 * 0.3 * (factor * angle).sin();
            [speed, (torque - loss * speed) / inertia]
        };
        let mut state = [start, 0.0];
        let mut time = 0.0;
        for row in &rows {
            let [until, angle, speed, y] = row[..] else { panic!("{row:?}") };
            // Kutta's method at steps far below the accuracy asked for.
            let step = (until - time) / 20.0;
            for _ in 0..if step > 0.0 { 20 } else { 0 } {
                let add = |by: [f64; 2], share: f64| [0, 1].map(|i| state[i] + share * by[i]);
                let one = rate(state);
                let two = rate(add(one, step / 2.0));
                let three = rate(add(two, step / 2.0));
                let four = rate(add(three, step));
                state = [0, 1].map(|i| {
                    state[i] + step / 6.0 * (one[i] + 2.0 * (two[i] + three[i]) + four[i])
                });
            }
            time = until;
            let size = start.abs();
            assert!((angle - state[0]).abs() < 1e-7 * size, "{ratio}: {angle} {}", state[0]);
            assert!((speed - state[1]).abs() < 1e-6 * size.max(state[1].abs()), "{ratio}: {speed}");
            assert!((y - 0.3 * (factor * angle).sin()).abs() < 1e-12, "{ratio}: {y}");
        }
    }
}

#[test]
fn gearboxes_that_are_no_pair_of_joints_are_refused() {
    let turns = "<axis><xyz>1 0 0</xyz></axis>";
    let gear = |reference: &str, ratio: &str, axis: &str| {
        let inner = format!(
            "<gearbox_reference_body>{reference}</gearbox_reference_body><gearbox_ratio>{ratio}</gearbox_ratio>\
             <axis><xyz>{axis}</xyz></axis><axis2><xyz>1 0 0</xyz></axis2>"
        );
        let text = [
            link("rotor", "0 0 1 0 0 0", 0.2, [0.001; 3]),
            link("arm", "0 0 1 0 0 0", 1.5, [0.02; 3]),
            joint("spin", "revolute", ["world", "rotor"], turns),
            joint("swing", "revolute", ["world", "arm"], turns),
            joint("gear", "gearbox", ["rotor", "arm"], &inner),
        ]
        .concat();
        model(&text)
    };
    for (reference, ratio, axis, wanted) in [
        (
            "rotor",
            "0.5",
            "1 0 0",
            "needs a revolute joint of `rotor` with `rotor` along its <axis>",
        ),
        (
            "world",
            "0.5",
            "0 1 0",
            "needs a revolute joint of `world` with `rotor` along its <axis>",
        ),
        ("world", "0", "1 0 0", "gearbox `gear` moves nothing"),
        ("world", "fast", "1 0 0", "not a number"),
    ] {
        refused(&gear(reference, ratio, axis), wanted);
    }
}

/// A puck slides on an inclined plane without friction: its centre falls, and
/// its rotation stays.
#[test]
fn a_puck_slides_by_a_planar_joint() {
    let axis = [0.3_f64, -0.2, 0.9];
    let mut text = String::from("<robot name=\"puck\"><link name=\"table\"/>");
    let _ = write!(
        text,
        "<joint name=\"plane\" type=\"planar\"><origin xyz=\"0 0 1\" rpy=\"0.2 0 0.4\"/>\
         <axis xyz=\"{} {} {}\"/><parent link=\"table\"/><child link=\"puck\"/></joint>",
        axis[0], axis[1], axis[2]
    );
    text += "<link name=\"puck\"><inertial><origin xyz=\"0 0 0\"/><mass value=\"0.7\"/><inertia \
             ixx=\"0.01\" iyy=\"0.02\" izz=\"0.03\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link></robot>";
    let more = "\n[initial]\n\"robot.plane_turn_dot\" = 3.0\n\"robot.plane_x_dot\" = 0.4\n";
    let columns = ["x", "y", "z", "v_x", "v_y", "v_z"];
    let outputs = columns.map(|name| format!("{name} = \"robot.puck_{name}\"\n")).concat();
    let more = format!("{more}[outputs]\n{outputs}");
    let columns = format!("robot.plane_turn,{}", columns.join(","));
    let rows = run("puck.urdf", &text, &more, &columns);
    // The normal in the world: the origin turns the axis about x, then about z.
    let [x, y, z] = axis;
    let [y, z] = [y * 0.2_f64.cos() - z * 0.2_f64.sin(), y * 0.2_f64.sin() + z * 0.2_f64.cos()];
    let [x, y] = [x * 0.4_f64.cos() - y * 0.4_f64.sin(), x * 0.4_f64.sin() + y * 0.4_f64.cos()];
    let length = f64::sqrt(x * x + y * y + z * z);
    let normal = [x, y, z].map(|entry| entry / length);
    let falls = [0, 1, 2].map(|i| 9.81 * normal[2] * normal[i] - if i == 2 { 9.81 } else { 0.0 });
    for row in &rows {
        let (time, turn) = (row[0], row[1]);
        assert!((turn - 3.0 * time).abs() < 1e-9, "{turn}");
        let from: f64 = (0..3).map(|i| normal[i] * (row[2 + i] - rows[0][2 + i])).sum();
        assert!(from.abs() < 1e-12, "{from}");
        for i in 0..3 {
            let exact = rows[0][2 + i] + rows[0][5 + i] * time + falls[i] * time * time / 2.0;
            assert!((row[2 + i] - exact).abs() < 1e-9, "{i}: {} {exact}", row[2 + i]);
        }
    }
}
