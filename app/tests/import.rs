//! `machinist import`: robots from URDF.

use std::fmt::Write as _;

use crate::process::{answer, assert_refused, machinist};

const UR5: &str = include_str!("urdf/ur5.urdf");
const JOINTS: [&str; 6] = [
    "shoulder_pan_joint",
    "shoulder_lift_joint",
    "elbow_joint",
    "wrist_1_joint",
    "wrist_2_joint",
    "wrist_3_joint",
];

/// State 2 of the arm in `tests/spatial/robots.json`, and positions and velocities 1 s later by
/// Pinocchio's `aba` and DOP853 of scipy at rtol 1e-13, good to 5e-11.
const START: [f64; 12] = [
    -0.394_117_087_488_07,
    -0.194_859_961_861_25,
    1.048_809_199_121_8,
    0.200_218_963_695_24,
    1.428_386_921_577,
    0.617_180_967_522_61,
    1.265_561_356_910_4,
    0.649_342_595_290_75,
    0.226_531_394_209_1,
    -0.179_942_482_746_58,
    -0.100_611_557_479_49,
    -1.946_617_021_978_9,
];
const END: [f64; 12] = [
    1.316_147_564_230_1,
    2.573_797_975_282_4,
    1.807_913_692_027_8,
    -3.499_460_986_797_8,
    1.473_331_198_354_4,
    -0.863_541_706_358_15,
    2.146_924_745_148_6,
    -2.320_995_408_586_7,
    1.944_090_460_883_8,
    -0.440_445_082_128_79,
    0.633_354_752_079_42,
    -1.249_853_161_438_1,
];

#[test]
fn an_arm_falls_as_its_description_says() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("ur5.urdf"), UR5).expect("written");
    let said = answer(machinist(&folder, &["import", "ur5.urdf", "--out", "ur5.toml"]));
    assert!(said.contains("6 joints that move"), "{said}");
    let path = folder.path().join("ur5.toml");
    let mut text = std::fs::read_to_string(&path).expect("a scene");
    text += "\n[initial]\n";
    for (k, joint) in JOINTS.iter().enumerate() {
        let (q, v) = (START[k], START[6 + k]);
        writeln!(text, "\"robot.{joint}\" = {q:?}\n\"robot.{joint}_dot\" = {v:?}").expect("text");
    }
    std::fs::write(&path, text).expect("written");
    let run = ["run", "ur5.toml", "--rtol", "1e-12", "--method", "dop853", "--no-error"];
    let table = answer(machinist(&folder, &[&run[..], &["--out", "-"]].concat()));
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().expect("a head").split(',').collect();
    let last: Vec<&str> = lines.next_back().expect("rows").split(',').collect();
    for (k, joint) in JOINTS.iter().enumerate() {
        for (suffix, wanted, tolerance) in [("", END[k], 2e-10), ("_dot", END[6 + k], 2e-9)] {
            let name = format!("robot.{joint}{suffix}");
            let place = names.iter().position(|known| {
                known.starts_with(&name) && {
                    known[name.len()..].trim_start_matches(' ').is_empty()
                        || known[name.len()..].starts_with([' ', '['])
                }
            });
            let found: f64 = last[place.expect("a column")].parse().expect("a number");
            assert!((found - wanted).abs() < tolerance, "{name}: {found} instead of {wanted}");
        }
    }
}

/// A robot with each kind of joint, losses, and names that specs do not allow.
const ALL: &str = r#"<robot name="2nd robot">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="base-link"><inertial><mass value="1"/>
    <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="arm.1"><inertial><origin xyz="0 0 1" rpy="0.1 0 0"/><mass value="1"/>
    <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="slider"><inertial><mass value="1"/>
    <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="finger"><inertial><mass value="1"/>
    <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="tool"/>
  <joint name="arm.1" type="continuous"><parent link="base-link"/><child link="arm.1"/>
    <origin xyz="0 0 1" rpy="1.5707963267948966 0 0"/><axis xyz="0 1 1"/>
    <dynamics damping="0.5" friction="0.1"/></joint>
  <joint name="arm 1" type="prismatic"><parent link="arm.1"/><child link="slider"/>
    <limit lower="0" upper="0.5" effort="10" velocity="1"/><dynamics damping="2"/></joint>
  <joint name="follows" type="revolute"><parent link="arm.1"/><child link="finger"/>
    <mimic joint="arm 1" multiplier="-3" offset="-0.2"/>
    <limit lower="-1e16" upper="1e16" effort="1" velocity="1"/></joint>
  <joint name="hand" type="fixed"><parent link="finger"/><child link="tool"/></joint>
</robot>"#;

#[test]
fn every_kind_of_joint_and_any_name_is_imported() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("all.urdf"), ALL).expect("written");
    for (base, moving) in [(&["--free-base"][..], 4), (&[], 3)] {
        let call = [&["import", "all.urdf", "--out", "all.toml"], base].concat();
        let said = answer(machinist(&folder, &call));
        assert!(said.contains(&format!("{moving} joints that move")), "{said}");
        let text = std::fs::read_to_string(folder.path().join("all.toml")).expect("a scene");
        for part in [
            "rotation = { roll_pitch_yaw = [\"1*pi/2\", 0.0, 0.0] }",
            "angle = \"-3.0 [1/m]*arm_1_2 - 0.2 [rad]\"",
            "2.0 [N s/m]*arm_1_2_dot^2/2",
            "# Limits, which nothing enforces: 0.0 to 0.5 m, 1.0 m/s, 10.0 N",
        ] {
            assert!(text.contains(part), "{part} is missing: {text}");
        }
        answer(machinist(&folder, &["run", "all.toml", "--no-error"]));
    }
}

#[test]
fn bad_robots_are_refused_and_nothing_is_written() {
    let bomb = "<!DOCTYPE robot [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]>";
    let deep = format!("<robot name=\"r\">{}", "<link>".repeat(150_000));
    let arm = "<link name=\"arm.1\"><inertial><origin xyz=\"0 0 1\" rpy=\"0.1 0 0\"/>";
    for (before, after, wanted) in [
        ("<robot name=\"2nd robot\">", "<sdf>", "XML"),
        ("<robot name=\"2nd robot\">", "<robot>", "lacks the attribute `name`"),
        ("<robot name=\"2nd robot\">", &format!("{bomb}<robot name=\"r\">"), "DTD"),
        ("<robot name=\"2nd robot\">", &deep, "XML"),
        ("<mass value=\"1\"/>", "<mass value=\"nan\"/>", "is nan, which no robot has"),
        ("<mass value=\"1\"/>", "<mass value=\"1e300\"/>", "is 1e300, which no robot has"),
        ("<mass value=\"1\"/>", "<mass value=\"3 kg\"/>", "not a number"),
        ("<mass value=\"1\"/>", "<mass value=\"-1\"/>", "is negative"),
        ("<mass value=\"1\"/>", "", "lacks <mass>"),
        ("ixx=\"1\"", "ixx=\"-1\"", "below 0"),
        ("ixx=\"1\"", "", "lacks the attribute `ixx`"),
        (arm, "<link name=\"arm.1\"><inertial><origin xyz=\"0 0\"/>", "three numbers"),
        ("<link name=\"slider\"><inertial><mass value=\"1\"/>", "<link name=\"slider\"><a>", "XML"),
        ("<parent link=\"base-link\"/>", "<parent link=\"none\"/>", "which is missing"),
        ("<parent link=\"base-link\"/>", "<parent link=\"tool\"/>", "loop"),
        ("<child link=\"tool\"/>", "<child link=\"slider\"/>", "carried by two joints"),
        ("<link name=\"tool\"/>", "<link name=\"tool\"/><link name=\"b\"/>", "two bases"),
        ("<link name=\"tool\"/>", "<link name=\"slider\"/>", "two links are called"),
        ("type=\"fixed\"", "type=\"continuous\"", "neither it nor what it carries has inertia"),
        ("type=\"continuous\"", "type=\"planar\"", "is of type `planar`"),
        ("<axis xyz=\"0 1 1\"/>", "<axis xyz=\"0 0 0\"/>", "is zero"),
        ("mimic joint=\"arm 1\"", "mimic joint=\"none\"", "which is missing"),
        ("mimic joint=\"arm 1\"", "mimic joint=\"follows\"", "which follows another"),
        ("damping=\"0.5\"", "damping=\"-0.5\"", "must not be negative"),
        ("damping=\"0.5\"", "damping=\"${d}\"", "xacro"),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        assert!(ALL.contains(before), "{before}");
        let text = ALL.replacen(before, after, 1);
        std::fs::write(folder.path().join("bad.urdf"), text).expect("written");
        let call = ["import", "bad.urdf", "--out", "bad.toml"];
        assert_refused(machinist(&folder, &call), &[wanted]);
        assert!(!folder.path().join("bad.toml").exists(), "{after} wrote a scene");
    }
}
