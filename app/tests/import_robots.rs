//! `machinist import`: robots from MJCF and from Denavit-Hartenberg tables.

use std::fmt::Write as _;

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use tempfile::TempDir;

use crate::process::{answer, assert_refused, machinist};

const MANY: &str = include_str!("urdf/many_joints.xml");

/// Start of the model, and its state 0.5 s later by MuJoCo 4.0.0, with the integrator RK4 at steps of
/// 1e-4 s; steps of 2e-4 s give the same within 1e-11.
const MANY_RUN: [(&str, f64, f64); 14] = [
    ("shoulder", 0.3, -0.601_281_247_502_495_6),
    ("elbow", -0.5, 1.410_150_613_869_023),
    ("twist", 0.4, 0.698_254_836_994_914_4),
    ("slider", 0.05, -0.320_187_257_419_287_44),
    ("shoulder_dot", 1.0, -0.834_040_478_955_629_9),
    ("elbow_dot", 0.7, -2.368_686_826_251_72),
    ("twist_dot", -1.2, 1.202_345_413_634_163_8),
    ("slider_dot", 0.2, -2.534_999_723_190_751),
    ("wrist_omega_x", 0.5, -6.048_299_065_554_382_5),
    ("wrist_omega_y", -0.8, 14.531_379_414_145_53),
    ("wrist_omega_z", 1.1, 12.365_103_471_465_233),
    ("fly_turn_omega_x", 1.0, 1.085_884_366_573_550_7),
    ("fly_turn_omega_y", -2.0, -2.020_487_843_338_368),
    ("fly_turn_omega_z", 0.7, 0.467_108_010_194_569_6),
];

/// Imports a file, adds lines to the scene, runs it and returns its last row by name.
fn run(folder: &TempDir, call: &[&str], more: &str) -> Vec<(String, f64)> {
    answer(machinist(folder, &[&["import"], call, &["--out", "robot.toml"]].concat()));
    let path = folder.path().join("robot.toml");
    let text =
        std::fs::read_to_string(&path).expect("a scene").replace("until = 1.0", "until = 0.5");
    std::fs::write(&path, text + more).expect("written");
    let run = ["run", "robot.toml", "--rtol", "1e-11", "--no-error", "--out", "-"];
    let table = answer(machinist(folder, &run));
    let mut lines = table.lines();
    let names = lines.next().expect("a head").split(',');
    let names = names.map(|name| name.split(" [").next().unwrap_or(name).trim().to_owned());
    let last = lines.next_back().expect("rows").split(',');
    names.zip(last.map(|cell| cell.parse().expect("a number"))).collect()
}

fn value(row: &[(String, f64)], name: &str) -> f64 {
    row.iter().find(|(known, _)| known == name).unwrap_or_else(|| panic!("no {name}: {row:?}")).1
}

/// Hinges beside the origins of their bodies, two in a body, a slide, a ball, a free body, every
/// kind of orientation and shape, classes, springs, a rotor.
#[test]
fn a_model_of_mujoco_moves_as_mujoco_says() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("many.xml"), MANY).expect("written");
    let mut more = "\n[initial]\n".to_owned();
    for (name, start, _) in MANY_RUN {
        writeln!(more, "\"robot.{name}\" = {start:?}").expect("text");
    }
    let row = run(&folder, &["many.xml"], &more);
    for (name, _, wanted) in MANY_RUN {
        let found = value(&row, &format!("robot.{name}"));
        assert!((found - wanted).abs() < 1e-9, "{name}: {found} instead of {wanted}");
    }
}

const SETTINGS: [(&str, &str); 3] = [
    ("settings.xml", include_str!("urdf/settings.xml")),
    ("settings_of_parts.xml", include_str!("urdf/settings_of_parts.xml")),
    ("settings_hand.xml", include_str!("urdf/settings_hand.xml")),
];

/// Start of a model in three files with settings of the compiler and of classes, and its state 0.5 s later
/// by MuJoCo 4.0.0 likewise.
const SETTINGS_RUN: [(&str, f64, f64); 13] = [
    ("lift", 0.3, 1.835_912_478_686_076),
    ("lift_dot", 1.0, 1.065_203_224_875_88),
    ("out", 0.05, 0.150_836_867_836_301_82),
    ("out_dot", -0.4, 0.429_658_990_202_696_2),
    ("wrist_omega_x", 0.5, 0.027_546_071_607_645_956),
    ("wrist_omega_y", -0.8, -0.175_967_112_881_451_03),
    ("wrist_omega_z", 1.1, 0.014_802_533_646_092_714),
    ("fly_px_dot", 0.2, 0.290_970_089_656_257_76),
    ("fly_py_dot", -0.3, -0.257_625_553_054_952),
    ("fly_pz_dot", 1.0, -3.464_886_597_937_358_6),
    ("fly_turn_omega_x", 1.0, 0.060_177_357_802_318_7),
    ("fly_turn_omega_y", -2.0, -0.054_013_535_713_813_975),
    ("fly_turn_omega_z", 0.7, 0.026_302_818_838_545_55),
];

#[test]
fn included_files_and_settings_of_mujoco_act() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in SETTINGS {
        std::fs::write(folder.path().join(name), text).expect("written");
    }
    let starts = SETTINGS_RUN.map(|(name, start, _)| format!("\"robot.{name}\" = {start:?}\n"));
    let row = run(&folder, &["settings.xml"], &format!("\n[initial]\n{}", starts.concat()));
    for (name, _, wanted) in SETTINGS_RUN {
        let found = value(&row, &format!("robot.{name}"));
        assert!((found - wanted).abs() < 1e-9, "{name}: {found} instead of {wanted}");
    }
    let call = ["import", "settings.xml", "--out", "settings.toml"];
    let noted = machinist(&folder, &call).output().expect("it starts").stderr;
    let noted = String::from_utf8_lossy(&noted).into_owned();
    for wanted in [
        "joint `lift` counts from its `ref`, 0.4",
        "`mocap` of body `target` of settings.xml is left out",
    ] {
        assert!(noted.contains(wanted), "{noted}");
    }
    // A mistake is told with the included file and its line.
    let bad = SETTINGS[2].1.replace("size=\"0.03 0.1\"", "size=\"wide\"");
    std::fs::write(folder.path().join("settings_hand.xml"), bad).expect("written");
    assert_refused(machinist(&folder, &call), &["settings_hand.xml:4: `size` is `wide`"]);
    let bad = SETTINGS[0].1.replace("ref=\"-0.1\"", "ref=\"far\"");
    std::fs::write(folder.path().join("settings.xml"), bad).expect("written");
    std::fs::write(folder.path().join("settings_hand.xml"), SETTINGS[2].1).expect("written");
    assert_refused(machinist(&folder, &call), &["settings.xml:12: `ref` is `far`"]);
    std::fs::remove_file(folder.path().join("settings_hand.xml")).expect("removed");
    let output = machinist(&folder, &call).output().expect("it starts");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!output.status.success() && said.contains("settings_hand.xml: No such file"), "{said}");
}

/// A frame moves what it contains, and frames add up.
#[test]
fn frames_of_mujoco_place_what_is_in_them() {
    let model = |inner: &str| {
        format!(
            "<mujoco model=\"frames\"><compiler angle=\"radian\"/><default><default class=\"slow\">\
             <joint damping=\"0.3\"/></default></default><worldbody>{inner}</worldbody></mujoco>"
        )
    };
    // Quarter turns about z take x to y and y to -x.
    let framed = model(
        "<frame pos=\"1 0 0\" euler=\"0 0 1.5707963267948966\" childclass=\"slow\"><frame pos=\"0 0 0.5\">\
         <body name=\"arm\" pos=\"0.2 0 0\"><frame pos=\"0 0.1 0\" quat=\"1 0 0 1\">\
         <joint name=\"turn\" axis=\"1 0 0\" pos=\"0.3 0 0\"/>\
         <geom type=\"box\" size=\"0.1 0.2 0.3\" pos=\"0 0 -0.4\"/></frame></body></frame></frame>",
    );
    let plain = model(
        "<body name=\"arm\" pos=\"1 0.2 0.5\" euler=\"0 0 1.5707963267948966\" childclass=\"slow\">\
         <joint name=\"turn\" axis=\"0 1 0\" pos=\"0 0.4 0\"/>\
         <geom type=\"box\" size=\"0.2 0.1 0.3\" pos=\"0 0.1 -0.4\"/></body>",
    );
    let rows = [framed, plain].map(|text| {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("frames.xml"), text).expect("written");
        let more = "\n[initial]\n\"robot.turn\" = 0.7\n[outputs]\nx = \"robot.arm_x\"\ny = \"robot.arm_y\"\n\
                    z = \"robot.arm_z\"\n";
        run(&folder, &["frames.xml"], more)
    });
    assert!(rows[0].len() > 5, "{rows:?}");
    for ((name, one), (_, other)) in rows[0].iter().zip(&rows[1]) {
        assert!((one - other).abs() < 1e-10, "{name}: {one} {other}");
    }
}

#[test]
fn parts_of_mujoco_that_no_scene_has_are_named() {
    for (before, after, wanted) in [
        ("</worldbody>", "</worldbody><actuator><motor joint=\"elbow\"/></actuator>", "<actuator>"),
        ("<option", "<option viscosity=\"0.1\"", "the viscosity of the medium"),
        ("", "", "contact of shapes"),
        ("name=\"twist\"", "name=\"twist\" range=\"-1 1\"", "the range of joints"),
        (
            "</worldbody>",
            "</worldbody><tendon><fixed range=\"0 1\"><joint joint=\"elbow\" coef=\"2\"/></fixed></tendon>",
            "the range of tendons",
        ),
        (
            "</worldbody>",
            "</worldbody><tendon><spatial name=\"rope\" stiffness=\"1\"><geom/></spatial></tendon>",
            "tendon `rope`, which wraps around shapes,",
        ),
        ("<option", "<option><flag gravity=\"disable\"/></option><option", ""),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        assert!(MANY.contains(before), "{before}");
        let text = MANY.replacen(before, after, 1);
        std::fs::write(folder.path().join("many.xml"), text).expect("written");
        let call = ["import", "many.xml", "--out", "many.toml"];
        let output = machinist(&folder, &call).output().expect("it starts");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let wanted =
            if wanted.is_empty() { "" } else { &format!("{wanted} of many.xml is left out") };
        assert!(output.status.success() && said.contains(wanted), "{said}");
        let scene = std::fs::read_to_string(folder.path().join("many.toml")).expect("a scene");
        assert_eq!(
            scene.contains("gravity = [0.0, 0.0, 0.0]"),
            after.contains("gravity="),
            "{scene}"
        );
    }
}

#[test]
fn bad_models_of_mujoco_are_refused_and_nothing_is_written() {
    let [open, close] = ["<replicate count=\"1000\">", "</replicate>"].map(|tag| tag.repeat(3));
    let copies = format!("{open}{close}</worldbody>");
    let circle = "</worldbody><equality><joint joint1=\"elbow\" joint2=\"twist\"/>\
                  <joint joint1=\"twist\" joint2=\"elbow\"/></equality>";
    let deep = format!("{}{}<body name=\"upper\"", "<body>".repeat(600), "</body>".repeat(600));
    for (before, after, wanted) in [
        ("<worldbody>", "<include file=\"bad.xml\"/><worldbody>", "is included twice"),
        ("<worldbody>", "<include file=\"/etc/none.xml\"/><worldbody>", "by an absolute path"),
        ("<worldbody>", "<include/><worldbody>", "lacks the attribute `file`"),
        ("<worldbody>", "<composite/><worldbody>", "<composite> is not read"),
        ("</worldbody>", "<replicate/></worldbody>", "lacks the attribute `count`"),
        ("</worldbody>", "<replicate count=\"1000000\"/></worldbody>", "at most 100000"),
        ("</worldbody>", &copies, "more than 100000 copies"),
        (
            "</worldbody>",
            "</worldbody><tendon><fixed><joint joint=\"x\"/></fixed></tendon>",
            "`x` is missing",
        ),
        (
            "</worldbody>",
            "</worldbody><tendon><spatial><site site=\"x\"/></spatial></tendon>",
            "`x` is missing",
        ),
        (
            "</worldbody>",
            "</worldbody><tendon><spatial><pulley divisor=\"0\"/></spatial></tendon>",
            "positive",
        ),
        ("</worldbody>", circle, "follows itself"),
        ("<mujoco model=\"many joints\">", "<!DOCTYPE a><mujoco>", "DTD"),
        ("eulerseq=\"zyx\"", "coordinate=\"global\"", "global coordinates"),
        ("eulerseq=\"zyx\"", "eulerseq=\"zya\"", "no orientation"),
        ("type=\"slide\"", "type=\"screw\"", "is of type `screw`"),
        ("stiffness=\"2\"", "stiffness=\"2 3\"", "polynomial"),
        ("stiffness=\"2\"", "stiffness=\"-2\"", "must not be negative"),
        ("armature=\"0.01\"", "armature=\"nan\"", "which no robot has"),
        ("armature=\"0.01\"", "armature=\"1 kg\"", "not a number"),
        ("axis=\"0.1 1 0.3\"", "axis=\"0 0 0\"", "is zero"),
        ("axis=\"0.1 1 0.3\"", "axis=\"0 1\"", "three numbers"),
        ("quat=\"0.9 0.1 -0.3 0.2\"", "quat=\"0 0 0 0\"", "no orientation"),
        ("type=\"ellipsoid\"", "type=\"mesh\"", "inertia of a mesh is not known"),
        ("size=\"0.04 0.1\"", "size=\"0.04\"", "not complete"),
        ("size=\"0.03\"", "size=\"0.03\" density=\"-1\"", "negative"),
        ("mass=\"0.7\"", "", "lacks the attribute `mass`"),
        ("mass=\"0.7\"", "mass=\"-0.7\"", "must not be negative"),
        ("diaginertia=\"0.003 0.004 0.002\"", "", "either `diaginertia` or `fullinertia`"),
        ("type=\"ball\"", "type=\"ball\" stiffness=\"1\"", "springs of ball joints"),
        ("<body name=\"upper\"", &deep, "too deeply"),
        ("name=\"lower\"", "name=\"upper\"", "two links are called"),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        assert!(MANY.contains(before), "{before}");
        std::fs::write(folder.path().join("bad.xml"), MANY.replacen(before, after, 1))
            .expect("written");
        let call = ["import", "bad.xml", "--out", "bad.toml"];
        assert_refused(machinist(&folder, &call), &[wanted]);
        assert!(!folder.path().join("bad.toml").exists(), "{after} wrote a scene");
    }
}

/// Start of a model with tendons along joints and between sites, copies, a spring by its time constant and
/// a compensated weight, and its state 0.5 s later by DOP853 of scipy on the accelerations of MuJoCo 4.0.0,
/// which is accurate to 2e-9.
const TENDONS_RUN: [(&str, f64, f64); 12] = [
    ("a", 0.3, 1.734_466_320_441_855),
    ("b", -0.5, 3.401_312_796_045_904_6),
    ("turn", 0.4, 0.126_558_279_002_750_85),
    ("slider", 0.05, -0.151_297_819_070_536_58),
    ("swing_0", 0.6, 0.583_166_229_056_572_7),
    ("swing_1", -0.3, 0.369_872_203_812_248_56),
    ("a_dot", 1.0, 2.027_005_670_999_148),
    ("b_dot", 0.7, 3.894_710_582_610_124_5),
    ("turn_dot", -1.2, 10.507_502_710_255_615),
    ("slider_dot", 0.2, 3.144_075_517_639_055_6),
    ("swing_0_dot", -0.4, 0.057_264_926_089_298_87),
    ("swing_1_dot", 0.9, -3.455_492_851_604_709_4),
];

#[test]
fn tendons_and_copies_of_mujoco_act_as_mujoco_says() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("tendons.xml"), include_str!("urdf/tendons.xml"))
        .expect("written");
    let starts = TENDONS_RUN.map(|(name, start, _)| format!("\"robot.{name}\" = {start:?}\n"));
    let row = run(&folder, &["tendons.xml"], &format!("\n[initial]\n{}", starts.concat()));
    for (name, _, wanted) in TENDONS_RUN {
        let found = value(&row, &format!("robot.{name}"));
        assert!((found - wanted).abs() < 1e-8, "{name}: {found} instead of {wanted}");
    }
}

/// Links that turn about x, without weight, and equations between them.
#[test]
fn equations_of_mujoco_hold_between_joints_and_tendons() {
    let bodies = ["a", "b", "c", "d", "e", "f"].map(|name| {
        format!(
            "<body name=\"{name}\"><joint name=\"{name}\" axis=\"1 0 0\"/><site name=\"{name}\" pos=\"0 0.1 0\"/>\
             <geom size=\"0.1\"/></body>"
        )
    });
    let text = format!(
        "<mujoco model=\"equations\"><option gravity=\"0 0 0\"/><worldbody>{}<site name=\"w\" pos=\"0 1 0\"/>\
         </worldbody><tendon><spatial name=\"rope\"><site site=\"w\"/><site site=\"e\"/></spatial>\
         <fixed name=\"sum\"><joint joint=\"a\" coef=\"1\"/><joint joint=\"f\" coef=\"2\"/></fixed></tendon>\
         <equality><joint joint1=\"b\" joint2=\"a\" polycoef=\"0.1 2\"/>\
         <joint joint1=\"c\" joint2=\"b\" polycoef=\"0 -1\"/>\
         <joint joint1=\"d\" joint2=\"a\" polycoef=\"0 0 0.5 1\"/>\
         <tendon tendon1=\"rope\" tendon2=\"sum\" polycoef=\"0 0.3\"/></equality></mujoco>",
        bodies.concat()
    );
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("equations.xml"), text).expect("written");
    let more = "\n[initial]\n\"robot.a_dot\" = 0.6\n\"robot.e\" = 0.4\n\"robot.e_dot\" = 0.5\n\
                [outputs]\nb = \"robot.b_y\"\nby = \"robot.b_r_yy\"\ncy = \"robot.c_r_yy\"\n";
    let row = run(&folder, &["equations.xml"], more);
    let [a, d, e, f] = ["a", "d", "e", "f"].map(|name| value(&row, &format!("robot.{name}")));
    assert!(a > 0.1, "{row:?}");
    let b = 0.1 + 2.0 * a;
    let rope = (1.0_f64 - 0.1 * e.cos()).hypot(0.1 * e.sin()) - 0.9;
    for (what, found, wanted) in [
        ("b", value(&row, "by"), b.cos()),
        ("c", value(&row, "cy"), b.cos()),
        ("d", d, 0.5 * a * a + a.powi(3)),
        ("rope", rope, 0.3 * (a + 2.0 * f)),
    ] {
        assert!((found - wanted).abs() < 1e-9, "{what}: {found} instead of {wanted}");
    }
}

/// A joint of a robot of this suite is held by a damping of 1e11.
#[test]
fn large_numbers_and_names_that_collide_are_imported() {
    for (before, after) in [
        ("name=\"twist\"", "name=\"twist\" damping=\"1e11\""),
        // The frame that joint `x` moves would be called as the position of frame `lower`.
        ("name=\"elbow\"", "name=\"x\""),
        ("name=\"wrist\"", "name=\"bob\""),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        assert!(MANY.contains(before), "{before}");
        std::fs::write(folder.path().join("many.xml"), MANY.replacen(before, after, 1))
            .expect("written");
        answer(machinist(&folder, &["import", "many.xml", "--out", "many.toml"]));
    }
}

/// Rows of a, alpha, d, theta, and whether the joint slides; masses, centres and inertias.
const ROWS: [([f64; 4], bool); 4] = [
    ([0.1, std::f64::consts::FRAC_PI_2, 0.4, 0.2], false),
    ([0.5, -0.7, 0.1, -0.4], false),
    ([0.05, 0.3, 0.2, 0.6], true),
    ([0.2, 1.1, -0.1, 0.0], false),
];
const START: [f64; 4] = [0.3, -0.8, 0.15, 1.2];
const RATES: [f64; 4] = [1.0, -0.5, 0.3, 2.0];

fn turn(axis: Vector3<f64>, angle: f64) -> Isometry3<f64> {
    Isometry3::from_parts(Translation3::identity(), UnitQuaternion::from_scaled_axis(axis * angle))
}

fn moved(x: f64, z: f64) -> Isometry3<f64> {
    Isometry3::translation(x, 0.0, z)
}

/// Centre of a link in the frame of its row in the standard convention.
fn centre(index: usize) -> Vector3<f64> {
    let k = index as f64;
    Vector3::new(-0.1 + 0.02 * k, 0.03 * k, 0.05)
}

fn table(modified: bool) -> String {
    let unit = if modified { "alpha [deg],a [mm]" } else { "alpha,a [m]" };
    let mut text = format!(
        "joint,type,{unit},d [m],theta [rad],mass [kg],cx [m],cy,cz,ixx [kg m^2],iyy,izz,ixy,ixz,iyz\n"
    );
    for (index, ([a, alpha, d, theta], slides)) in ROWS.into_iter().enumerate() {
        let centre = centre(index);
        let inertia = nalgebra::Matrix3::from_diagonal(&Vector3::new(0.02, 0.03, 0.025));
        // The constants of a standard row follow its joint, those of the next modified row.
        let rest = moved(a, 0.0) * turn(Vector3::x(), alpha);
        let (arm, centre, inertia) = if modified {
            let before = index.checked_sub(1).map_or([0.0; 4], |before| ROWS[before].0);
            let turned = rest.rotation.to_rotation_matrix();
            let inertia = turned.matrix() * inertia * turned.matrix().transpose();
            (
                [before[1].to_degrees(), before[0] * 1e3],
                (rest * nalgebra::Point3::from(centre)).coords,
                inertia,
            )
        } else {
            ([alpha, a], centre, inertia)
        };
        let kind = if slides { "prismatic" } else { "revolute" };
        let [xy, xz, yz] = [inertia[(0, 1)], inertia[(0, 2)], inertia[(1, 2)]];
        writeln!(
            text,
            "j{index},{kind},{:?},{:?},{d:?},{theta:?},1.5,{:?},{:?},{:?},{:?},{:?},{:?},{xy:?},{xz:?},{yz:?}",
            arm[0], arm[1], centre.x, centre.y, centre.z,
            inertia[(0, 0)], inertia[(1, 1)], inertia[(2, 2)],
        )
        .expect("text");
    }
    text
}

/// Both conventions describe the same arm, whose last frame is the product of the rows' matrices.
#[test]
fn tables_of_denavit_and_hartenberg_move_as_their_matrices() {
    let mut more = "\n[initial]\n".to_owned();
    for (index, (start, rate)) in START.into_iter().zip(RATES).enumerate() {
        writeln!(more, "\"robot.j{index}\" = {start:?}\n\"robot.j{index}_dot\" = {rate:?}")
            .expect("text");
    }
    let rows: Vec<Vec<(String, f64)>> = [false, true]
        .into_iter()
        .map(|modified| {
            let folder = tempfile::tempdir().expect("a folder");
            std::fs::write(folder.path().join("arm.csv"), table(modified)).expect("written");
            let call: &[&str] = if modified { &["arm.csv", "--modified"] } else { &["arm.csv"] };
            let frame = if modified { "link_4" } else { "frame_4" };
            let outputs = format!(
                "[outputs]\nx = \"robot.{frame}_x\"\ny = \"robot.{frame}_y\"\nz = \"robot.{frame}_z\"\n"
            );
            run(&folder, call, &format!("{more}{outputs}"))
        })
        .collect();
    for (name, value_of) in rows[0].iter().filter(|(name, _)| name.starts_with("robot.")) {
        let other = value(&rows[1], name);
        assert!((value_of - other).abs() < 1e-8, "{name}: {value_of} and {other}");
    }
    for (row, is_modified) in rows.iter().zip([false, true]) {
        let mut whole = Isometry3::identity();
        for (index, ([a, alpha, d, theta], slides)) in ROWS.into_iter().enumerate() {
            let q = value(row, &format!("robot.j{index}"));
            let (turned, slid) = if slides { (theta, d + q) } else { (theta + q, d) };
            whole *= turn(Vector3::z(), turned) * moved(0.0, slid);
            if !is_modified || index < 3 {
                whole *= moved(a, 0.0) * turn(Vector3::x(), alpha);
            }
        }
        for (name, wanted) in ["x", "y", "z"].into_iter().zip(whole.translation.vector.iter()) {
            let found = value(row, name);
            assert!((found - wanted).abs() < 1e-12, "{name}: {found} instead of {wanted}");
        }
    }
}

#[test]
fn bad_tables_are_refused_and_nothing_is_written() {
    let good = table(false);
    let row = good.lines().nth(1).expect("a row").to_owned();
    for (before, after, wanted) in [
        ("alpha,", "beta,", "there is no column `beta`"),
        (",iyz", ",ixx", "two columns `ixx`"),
        ("a [m]", "a [inch]", "is in `inch`"),
        ("prismatic", "helical", "is of type `helical`"),
        (",0.4,", ",nan,", "not a number"),
        (",0.4,", ",1e300,", "not a number"),
        (",0.4,", ",0.4 m,", "not a number"),
        (",0.4,", ",", "not a table"),
        (",1.5,", ",-1.5,", "must not be negative"),
        ("j1,", "j0,", "two joints are called"),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        assert!(good.contains(before), "{before}");
        std::fs::write(folder.path().join("bad.csv"), good.replacen(before, after, 1))
            .expect("written");
        let call = ["import", "bad.csv", "--out", "bad.toml"];
        assert_refused(machinist(&folder, &call), &[wanted]);
        assert!(!folder.path().join("bad.toml").exists(), "{after} wrote a scene");
    }
    for (text, wanted) in [
        ("a,alpha,d\n1,2,3\n", "no column `theta`"),
        ("a,alpha,d,theta\n", "no rows"),
        ("", "no column `a`"),
        ("a,alpha,d,theta\n1,0,0,0\n", "neither it nor what it carries has inertia"),
        (&row, "there is no column"),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("bad.csv"), text).expect("written");
        let call = ["import", "bad.csv", "--out", "bad.toml"];
        assert_refused(machinist(&folder, &call), &[wanted]);
        assert!(!folder.path().join("bad.toml").exists(), "{text}");
    }
}
