//! `machinist import`: robots from URDF and SDF.

use std::fmt::Write as _;

use crate::process::{answer, assert_refused, machinist};

const UR5: &str = include_str!("urdf/ur5.urdf");
const SDF: &str = include_str!("urdf/ur5.sdf");
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
    for (file, text) in [("ur5.urdf", UR5), ("ur5.sdf", SDF)] {
        falls(file, text);
    }
}

/// Imports an arm and compares its fall with the reference.
fn falls(file: &str, text: &str) {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join(file), text).expect("written");
    let said = answer(machinist(&folder, &["import", file, "--out", "ur5.toml"]));
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

/// Links without inertia at the ends of joints, inertias that no body has, long names.
#[test]
fn robots_are_imported_as_vendors_describe_them() {
    let slider = "<link name=\"slider\"><inertial><mass value=\"1\"/>
    <inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>";
    let finger = "ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>
  <link name=\"tool\"/>";
    let long =
        "shapes_of_the_parent_of_the_camera_in_front_to_the_frame_of_the_colour_camera_in_front";
    let (arm, other) = (format!("\"{long}.1\""), format!("\"{long}.2\""));
    for (changes, joints, wanted) in [
        (
            vec![("type=\"fixed\"", "type=\"continuous\"")],
            3,
            "joint `hand` is fixed: its motion moves no inertia",
        ),
        // What follows it has inertia.
        (vec![(slider, "<link name=\"slider\"/>")], 3, ""),
        (
            vec![(finger, &*finger.replace("ixy=\"0\"", "ixy=\"1.5\""))],
            3,
            "no body has the inertia of `finger`: about some axis it is negative",
        ),
        (vec![("\"arm.1\"", &*arm), ("\"slider\"", &*other)], 3, ""),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let mut text = ALL.to_owned();
        for (before, after) in changes {
            assert!(text.contains(before), "{before}");
            text = text.replace(before, after);
        }
        std::fs::write(folder.path().join("all.urdf"), text).expect("written");
        let call = ["import", "all.urdf", "--out", "all.toml"];
        let output = machinist(&folder, &call).output().expect("it starts");
        let [said, noted] = [&output.stdout, &output.stderr].map(|of| String::from_utf8_lossy(of));
        assert!(said.contains(&format!("{joints} joints that move")), "{said}{noted}");
        assert!(noted.contains(wanted), "{noted}");
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
        ("<mass value=\"1\"/>", "<mass value=\"-1\"/>", "must not be negative"),
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
        ("type=\"continuous\"", "type=\"screw\"", "is of type `screw`"),
        ("<axis xyz=\"0 1 1\"/>", "<axis xyz=\"0 0 0\"/>", "is zero"),
        ("mimic joint=\"arm 1\"", "mimic joint=\"none\"", "which is missing"),
        ("mimic joint=\"arm 1\"", "mimic joint=\"follows\"", "joint `follows` follows itself"),
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

#[test]
fn shapes_are_drawn_and_meshes_are_named() {
    let mesh = "<visual><geometry><mesh filename=\"package://arm/hand.stl\"/></geometry></visual>";
    let shapes = "<visual><origin xyz=\"0 0 0.5\" rpy=\"0 0.3 0\"/><geometry><box size=\"0.1 0.2 1\"/>\
                  </geometry></visual><visual><geometry><sphere radius=\"0.2\"/></geometry></visual>\
                  <visual><geometry><cylinder radius=\"0.1\" length=\"0.6\"/></geometry></visual>";
    let text = ALL
        .replace("<link name=\"arm.1\">", &format!("<link name=\"arm.1\">{shapes}"))
        .replace("<link name=\"tool\"/>", &format!("<link name=\"tool\">{mesh}</link>"));
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("all.urdf"), &text).expect("written");
    answer(machinist(&folder, &["import", "all.urdf", "--out", "all.toml"]));
    let scene = std::fs::read_to_string(folder.path().join("all.toml")).expect("a scene");
    for part in [
        "shapes.arm_1]\nframe = \"arm_1\"\ncentre = [0.0, 0.0, 0.5]\n\
         rotation = { roll_pitch_yaw = [0.0, 0.3, 0.0] }\nbox = [0.1, 0.2, 1.0]",
        "shapes.arm_1_2]\nframe = \"arm_1\"\nsphere = 0.4",
        "shapes.arm_1_3]\nframe = \"arm_1\"\ncylinder = { length = 0.6, diameter = 0.2 }",
        "shapes.base_link_to_arm_1]\nframe = \"base_link\"\nrod = \"arm_1\"",
        "# Mesh of `tool`, which is not drawn: \"package://arm/hand.stl\"",
    ] {
        assert!(scene.contains(part), "{part} is missing: {scene}");
    }
    answer(machinist(&folder, &["report", "all.toml", "--out", "all.html"]));
    for (before, after, wanted) in [
        ("size=\"0.1 0.2 1\"", "size=\"0.1 0 1\"", "not positive"),
        ("size=\"0.1 0.2 1\"", "size=\"0.1 0.2\"", "three numbers"),
        ("size=\"0.1 0.2 1\"", "", "lacks the attribute `size`"),
        ("radius=\"0.2\"", "radius=\"inf\"", "no robot has"),
        (" length=\"0.6\"", "", "lacks the attribute `length`"),
    ] {
        std::fs::write(folder.path().join("bad.urdf"), text.replace(before, after))
            .expect("written");
        let call = ["import", "bad.urdf", "--out", "bad.toml"];
        assert_refused(machinist(&folder, &call), &[wanted]);
    }
}

#[test]
fn bad_models_of_gazebo_are_refused_and_nothing_is_written() {
    let forearm = "<link name=\"forearm_link\">";
    for (before, after, wanted) in [
        ("<model name=\"ur5\">", "<include/><model name=\"ur5\"><include/>", "<include> within"),
        ("<model name=\"ur5\">", "<model/><model name=\"ur5\">", "has 2 models"),
        ("<model name=\"ur5\">", "<model name=\"ur5\"><static>true</static>", "is static"),
        ("relative_to=\"bench\"", "relative_to=\"bank\"", "the frame `bank` is missing"),
        (
            "<frame name=\"bench\">",
            "<frame name=\"bench\" attached_to=\"shoulder_link\">",
            "itself",
        ),
        (
            "rotation_format=\"quat_xyzw\"",
            "rotation_format=\"quat\"",
            "`rotation_format` is `quat`",
        ),
        ("rotation_format=\"quat_xyzw\"", "", "has 6 numbers, not 7"),
        ("<mass>3.7</mass>", "<mass>nan</mass>", "which no robot has"),
        ("<mass>3.7</mass>", "<mass>-3.7</mass>", "must not be negative"),
        ("<mass>3.7</mass>", "<mass>3.7 kg</mass>", "not a number"),
        ("<mass>3.7</mass>", "", "lacks <mass>"),
        ("<ixx>0.010267495893</ixx>", "<ixx>-1</ixx>", "below 0"),
        ("<ixx>0.010267495893</ixx>", "", "lacks <ixx>"),
        ("<inertial>", "<inertial auto=\"true\">", "inertias of collisions"),
        (forearm, &format!("<link name=\"bare\"/>{forearm}"), "`bare` has no <inertial>"),
        (forearm, &format!("{forearm}<gravity>false</gravity>"), "has no weight"),
        ("type=\"revolute\"", "type=\"fork\"", "is of type `fork`"),
        ("type=\"revolute\"", "type=\"universal\"", "lacks <axis2>"),
        ("type=\"revolute\"", "type=\"screw\"", "has no pitch"),
        ("type=\"revolute\"", "type=\"gearbox\"", "lacks <gearbox_reference_body>"),
        ("<axis>", "<axis><dynamics><damping>-1</damping></dynamics>", "must not be negative"),
        ("<axis>", "<axis><mimic joint=\"none\"/>", "which is missing"),
        ("<axis>", "<axis><xyz>0 0 0</xyz>", "is zero"),
        ("<parent>base_link</parent>", "", "lacks <parent>"),
        ("<parent>base_link</parent>", "<parent>wrist_1_link</parent>", "two bases"),
        ("<radius>0.06</radius>", "<radius>0</radius>", "not positive"),
        ("<sdf version=\"1.10\">", "<!DOCTYPE a><sdf>", "DTD"),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        assert!(SDF.contains(before), "{before}");
        let text = SDF.replacen(before, after, 1);
        std::fs::write(folder.path().join("bad.sdf"), text).expect("written");
        let call = ["import", "bad.sdf", "--out", "bad.toml"];
        assert_refused(machinist(&folder, &call), &[wanted]);
        assert!(!folder.path().join("bad.toml").exists(), "{after} wrote a scene");
    }
}

#[test]
fn axes_along_the_model_are_read_in_both_versions_of_gazebo() {
    let now = "<axis><xyz expressed_in=\"__model__\">";
    let before = "<axis><use_parent_model_frame>1</use_parent_model_frame><xyz>";
    assert!(SDF.contains(now), "an axis");
    let scenes = [SDF.to_owned(), SDF.replace(now, before)].map(|text| {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("arm.sdf"), text).expect("written");
        answer(machinist(&folder, &["import", "arm.sdf", "--out", "arm.toml"]));
        std::fs::read_to_string(folder.path().join("arm.toml")).expect("a scene")
    });
    assert_eq!(scenes[0], scenes[1]);
}

/// A pendulum whose base nothing joins to the world falls with it, turned as the model is placed.
#[test]
fn a_model_of_gazebo_that_nothing_holds_is_free_and_its_losses_act() {
    let text = r#"<sdf version="1.8"><model name="pair"><pose>1 2 3 0.5 0 0</pose>
      <link name="base"><inertial><mass>2</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz>
        </inertia></inertial><sensor name="s"/><collision name="c"/></link>
      <link name="arm"><pose relative_to="base">0 0 0.5 0 0 0</pose><inertial><mass>1</mass><inertia>
        <ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial></link>
      <link name="copy"><inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz>
        </inertia></inertial></link>
      <joint name="turn" type="revolute"><parent>base</parent><child>arm</child><axis><xyz>0 1 0</xyz>
        <dynamics><damping>0.3</damping><friction>0.2</friction><spring_stiffness>4</spring_stiffness>
        <spring_reference>0.1</spring_reference></dynamics>
        <limit><lower>-1e16</lower><upper>inf</upper></limit></axis></joint>
      <joint name="follow" type="continuous"><parent>base</parent><child>copy</child><axis>
        <xyz>1 0 0</xyz><mimic joint="turn" axis="axis"><multiplier>2</multiplier><offset>0.5</offset>
        <reference>0.1</reference></mimic></axis></joint>
      </model></sdf>"#;
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("pair.sdf"), text).expect("written");
    let output = machinist(&folder, &["import", "pair.sdf", "--out", "pair.toml"]).output();
    let said = String::from_utf8_lossy(&output.expect("it starts").stderr).into_owned();
    for part in ["<collision> of pair.sdf is left out", "<sensor> of pair.sdf is left out"] {
        assert!(said.contains(part), "{said}");
    }
    let scene = std::fs::read_to_string(folder.path().join("pair.toml")).expect("a scene");
    for part in [
        "displacement = [1.0, 2.0, 3.0]\nrotation = { roll_pitch_yaw = [0.5, 0.0, 0.0] }",
        "angle = \"2.0*turn + 0.3 [rad]\"",
        "4.0 [N m/rad]*(turn - 0.1 [rad])^2/2",
        "0.3 [N m s/rad]*turn_dot^2/2",
        "sliding = \"0.2 [N m]\"",
        "displacement = [0.0, 0.0, 0.5]\nrevolute",
    ] {
        assert!(scene.contains(part), "{part} is missing: {scene}");
    }
    assert!(!scene.contains("# Limits"), "{scene}");
    answer(machinist(&folder, &["run", "pair.toml", "--no-error"]));
}
