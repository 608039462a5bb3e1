//! Parts of mechanisms in space, and mechanisms of parts alone.

use std::f64::consts::{PI, TAU};

use machinist::Trajectory;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Describe;
use machinist_model::ModelSimulator;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use super::{column, example, off, run};
use crate::own_scene::{of_text, refusal};
use crate::spatial::{omega, turned};

const GRAVITY: f64 = 9.81;

fn part(name: &str) -> ModelSimulator {
    example(&format!("spatial/{name}"), Keep::Needed)
}

/// Checks that a pendulum released level, with its centre at (x, z), turns as its energy says:
/// J w^2/2 = m g (x sin + z cos - z), positive about y.
fn swings(
    found: &Trajectory,
    angle: &str,
    rate: &str,
    [mass, inertia]: [f64; 2],
    [x, z]: [f64; 2],
) {
    let whole = inertia + mass * (x * x + z * z);
    let mut most = 0.0_f64;
    for (angle, rate) in column(found, angle).iter().zip(column(found, rate)) {
        // A turn by phi about y lowers x by x sin(phi) and raises z to z cos(phi).
        let fallen = x * angle.sin() + z - z * angle.cos();
        let error = whole * rate * rate / 2.0 - mass * GRAVITY * fallen;
        assert!(error.abs() < 1e-8 * mass * GRAVITY, "{error:e} J at {angle}");
        most = most.max(angle.abs());
    }
    assert!(most > 1.0, "it swings by {most}");
}

#[test]
fn pendulums_of_each_body_swing_as_their_inertias_say() {
    swings(&run(&part("world"), &[], &[]), "pivot.phi", "pivot.omega", [2.0, 0.04], [0.5, 0.0]);
    for (density, length, width) in [(7700.0, 0.5, 0.1), (2000.0, 0.3, 0.2)] {
        let set = [("bob.density", density), ("bob.length", length), ("bob.height", width)];
        let mass = density * length * 0.1 * width;
        let inertia = mass * (length * length + width * width) / 12.0;
        let found = run(&part("bar"), &set, &[]);
        swings(&found, "pivot.phi", "pivot.omega", [mass, inertia], [length / 2.0, 0.0]);
    }
    for (outer, inner) in [(0.1_f64, 0.08_f64), (0.2, 0.0)] {
        let set = [("bob.diameter", outer), ("bob.inner_diameter", inner)];
        let mass = 7700.0 * PI * (outer * outer - inner * inner) * 0.5 / 4.0;
        let inertia = mass * ((outer * outer + inner * inner) / 16.0 + 0.25 / 12.0);
        let found = run(&part("cylinder"), &set, &[]);
        swings(&found, "pivot.phi", "pivot.omega", [mass, inertia], [0.25, 0.0]);
    }
    let set = [("arm.x", 0.3), ("arm.z", 0.2), ("bob.mass", 1.7)];
    let found = run(&part("translation"), &set, &[]);
    swings(&found, "pivot.phi", "pivot.omega", [1.7, 0.01], [0.3, 0.2]);
}

/// Energy and the vertical angular momentum about the pivot stay.
fn spins(found: &Trajectory, name: &str, mass: f64, centre: Vector3<f64>, inertia: Matrix3<f64>) {
    let about =
        inertia + mass * (Matrix3::identity() * centre.dot(&centre) - centre * centre.transpose());
    let of = |row: usize| {
        let (turn, rates) = (turned(found, name, row), omega(found, name, row));
        let energy = rates.dot(&(about * rates)) / 2.0 + mass * GRAVITY * (turn * centre).z;
        (energy, (turn * (about * rates)).z)
    };
    let (energy, momentum) = of(0);
    for row in 0..found.times.len() {
        let (now, around) = of(row);
        assert!((now - energy).abs() < 1e-7 * (1.0 + energy.abs()), "{now} J, at first {energy} J");
        assert!((around - momentum).abs() < 1e-8 * (1.0 + momentum.abs()), "{around}, {momentum}");
    }
}

#[test]
fn bodies_on_balls_keep_energy_and_momentum() {
    let inclined = Matrix3::new(0.01, 0.002, 0.0, 0.002, 0.04, 0.0, 0.0, 0.0, 0.01);
    spins(&run(&part("body"), &[], &[]), "pivot.turn", 2.0, Vector3::new(0.5, 0.0, 0.0), inclined);
    let mass = 7700.0 * PI * 0.001 / 6.0;
    let inertia = Matrix3::identity() * (mass * 0.01 / 10.0);
    spins(
        &run(&part("sphere"), &[], &[]),
        "pivot.turn",
        mass,
        Vector3::new(0.0, 0.0, -1.0),
        inertia,
    );
    let top = Matrix3::from_diagonal(&Vector3::new(0.05, 0.05, 0.02));
    let found = run(&part("spherical"), &[], &[]);
    spins(&found, "tip.turn", 1.5, Vector3::new(0.0, 0.0, 0.3), top);
    let spread = (0..found.times.len()).map(|row| omega(&found, "tip.turn", row).z - 60.0);
    assert!(spread.fold(0.0, |most: f64, off| most.max(off.abs())) < 1e-9);
}

#[test]
fn joints_along_axes_follow_newton() {
    for angle in [0.5_f64, 1.2] {
        let found = run(&part("rotation"), &[("slope.angle", angle)], &[]);
        assert!(off(&found, "slide.s", |t| GRAVITY * angle.sin() * t * t / 2.0) < 1e-8);
    }
    let found = run(&part("cylindrical"), &[], &[]);
    assert!(off(&found, "pole.phi", |t| 3.0 * t) < 1e-9);
    assert!(off(&found, "pole.s", |t| -GRAVITY * t * t / 2.0) < 1e-9);
    // m h^2 + J against the weight at the lever h, the advance per radian.
    for pitch in [0.5, -0.2] {
        let lever = pitch / TAU;
        let rate = -2.0 * GRAVITY * lever / (2.0 * lever * lever + 0.03);
        let found = run(&part("screw"), &[("thread.pitch", pitch)], &[]);
        assert!(off(&found, "thread.phi", |t| rate * t * t / 2.0) < 1e-8);
    }
    // On an axis at 45 degrees, with the spring: m s'' = -m g/sqrt(2) - k s.
    let found = run(&part("prismatic"), &[], &[]);
    let rest = -GRAVITY / 2f64.sqrt() / 50.0;
    assert!(off(&found, "slide.s", |t| rest * (1.0 - (50f64.sqrt() * t).cos())) < 1e-8);
    // On a table turned by 0.3 about x, whose y axis rises.
    let found = run(&part("planar"), &[], &[]);
    // Its centre of mass beside the origin flies as a point; the damper slows its rotation.
    let angle = |t: f64| 4.0 * (1.0 - (-0.5 * t).exp());
    assert!(off(&found, "plate.phi", angle) < 1e-8);
    assert!(off(&found, "plate.x", |t| 0.1 + t - 0.1 * angle(t).cos()) < 1e-8);
    let fallen = |t: f64| 0.2 * t - GRAVITY * 0.3f64.sin() * t * t / 2.0;
    assert!(off(&found, "plate.y", |t| fallen(t) - 0.1 * angle(t).sin()) < 1e-8);
}

/// A torque M between two wheels on one axis: theirs are M/J and -M/J.
#[test]
fn drives_act_between_the_frames_of_a_joint() {
    let found = run(&part("revolute"), &[], &[]);
    assert!(off(&found, "base.phi", |t| -0.3 / 0.21 * t * t / 2.0 * 0.21 / 0.2) < 1e-8);
    assert!(off(&found, "joint.phi", |t| (0.3 / 0.05 + 0.3 / 0.2) * t * t / 2.0) < 1e-8);
    let found = run(&part("torque"), &[], &[]);
    // The satellite's own inertia, with 0.01 of the wheel's body across.
    assert!(off(&found, "satellite", |t| -0.1 / 0.8 * t) < 1e-8);
    assert!(off(&found, "wheel", |t| (0.1 / 0.02 + 0.1 / 0.8) * t) < 1e-8);
    let found = run(&part("force"), &[], &[]);
    assert!(off(&found, "flight.x", |t| 3.0 / 2.0 * t * t / 2.0) < 1e-8);
    let heights = column(&found, "flight.z").iter().fold(0.0, |most: f64, z| most.max(z.abs()));
    assert!(heights < 1e-10, "the weight is carried: {heights}");
}

/// A pendulum on a cross with phi_b alone is planar, and so it is with phi_a alone.
#[test]
fn a_cross_turns_about_both_axes() {
    for (name, across) in [("cross.phi_a", 0.01), ("cross.phi_b", 0.01)] {
        let start = [("cross.phi_a", 0.0), ("cross.omega_b", 0.0), (name, 1.2)];
        let found = run(&part("universal"), &[], &start);
        let whole = across + 0.25;
        let rate = name.replace("phi", "omega");
        for (angle, rate) in column(&found, name).iter().zip(column(&found, &rate)) {
            let energy = whole * rate * rate / 2.0 - GRAVITY * 0.5 * (angle.cos() - 1.2f64.cos());
            assert!(energy.abs() < 1e-8, "{energy:e} J at {angle}");
        }
    }
}

/// The middle axis of a thrown racket is unstable: it turns over. Energy and angular momentum stay.
#[test]
fn a_racket_flies_and_turns_over() {
    let found = run(&part("free"), &[], &[]);
    assert!(off(&found, "flight.x", |t| 2.0 * t) < 1e-9);
    assert!(off(&found, "flight.z", |t| 5.0 * t - GRAVITY * t * t / 2.0) < 1e-9);
    let inertia = Vector3::new(0.003, 0.02, 0.022);
    let momentum = |row: usize| {
        let rates = omega(&found, "flight.turn", row);
        turned(&found, "flight.turn", row) * rates.component_mul(&inertia)
    };
    for row in 0..found.times.len() {
        assert!((momentum(row) - momentum(0)).norm() < 1e-8);
    }
}

/// Newton's equations of a point on a spring with a damper along it, by small steps.
#[test]
fn a_spring_between_points_pulls_along_its_line() {
    let found = run(&part("spring_damper"), &[], &[]);
    let rate = |_: f64, y: &[f64; 6]| {
        let (place, speed) = (Vector3::new(y[0], y[1], y[2]), Vector3::new(y[3], y[4], y[5]));
        let length = place.norm();
        let pull = 60.0 * (length - 0.3) + 0.5 * place.dot(&speed) / length;
        let a = -place * (pull / length) - Vector3::z() * GRAVITY;
        [y[3], y[4], y[5], a.x, a.y, a.z]
    };
    let exact = super::by_small_steps([0.0, 0.0, -0.4, 0.5, 0.2, 0.0], 1.0, 200_000, rate);
    for (name, exact) in ["flight.x", "flight.y", "flight.z"].iter().zip(exact) {
        let last = column(&found, name).last().copied().expect("rows");
        assert!((last - exact).abs() < 1e-7, "{name}: {last} instead of {exact}");
    }
}

/// A circular orbit closes after its period.
#[test]
fn a_satellite_returns() {
    let found = run(&part("central_gravity"), &[], &[]);
    let (radius, speed) = (7e6_f64, (3.986_004_418e14 / 7e6_f64).sqrt());
    assert!(off(&found, "x", |t| radius * (speed / radius * t).cos()) < 1e-6);
    assert!(off(&found, "y", |t| radius * (speed / radius * t).sin()) < 1e-6);
}

/// As `spatial::a_spatial_four_bar_closes_its_loop`, of parts.
#[test]
fn a_rod_with_two_balls_closes_a_loop() {
    let found = run(&part("rod"), &[], &[]);
    for (crank, rocker) in column(&found, "crank").iter().zip(column(&found, "rocker")) {
        let pin = Vector3::new(0.2 * crank.cos(), 0.2 * crank.sin(), 0.0);
        let ball = Vector3::new(0.0, 0.8 - 0.5 * rocker.sin(), 0.3 + 0.5 * rocker.cos());
        assert!(((pin - ball).norm_squared() - 0.7).abs() < 1e-11);
    }
    let energy = column(&found, "energy.total");
    assert!(energy.iter().all(|e| (e - energy[0]).abs() < 1e-7 * energy[0].abs()));
    assert!(column(&found, "crank").last().is_some_and(|angle| angle.abs() > 2.0));
}

#[test]
fn constraints_close_loops() {
    // As the joint of the same kind: turned by 0.4 about x, then by its own rate about y.
    let (held, joined) =
        (run(&part("universal_constraint"), &[], &[]), run(&part("universal"), &[], &[]));
    for row in 0..held.times.len() {
        let turn = turned(&held, "flight.turn", row);
        let [a, b] = ["cross.phi_a", "cross.phi_b"].map(|name| column(&joined, name)[row]);
        let wanted = UnitQuaternion::from_scaled_axis(Vector3::x() * a)
            * UnitQuaternion::from_scaled_axis(Vector3::y() * b);
        assert!(turn.angle_to(&wanted) < 1e-7, "off by {:e}", turn.angle_to(&wanted));
    }
    let hinged = run(&part("revolute_constraint"), &[], &[]);
    for row in 0..hinged.times.len() {
        let turn = turned(&hinged, "flight.turn", row);
        let rate = omega(&hinged, "flight.turn", row).y;
        let fallen = -(turn * Vector3::new(0.5, 0.0, 0.0)).z;
        let energy = (0.04 + 2.0 * 0.25) * rate * rate / 2.0 - 2.0 * GRAVITY * fallen;
        assert!(energy.abs() < 1e-7, "{energy:e} J");
    }
    let inclined = Matrix3::new(0.01, 0.002, 0.0, 0.002, 0.04, 0.0, 0.0, 0.0, 0.01);
    let ball = run(&part("spherical_constraint"), &[], &[]);
    spins(&ball, "flight.turn", 2.0, Vector3::new(0.5, 0.0, 0.0), inclined);
}

/// A chain of links of parts, joined in any direction and order, moves as one unit with frames.
#[test]
fn trees_of_parts_move_as_frames_of_one_unit() {
    let whole = r#"
[scene]
name = "whole"
[units]
m = { unit = "arm" }
[run]
until = 1
points = 21
rtol = 1e-11
[initial]
"m.a" = 0.3
"m.b_dot" = 1.5
"m.r_omega_y" = 0.7
[outputs]
a = "m.a"
b = "m.b"
x = "m.tip_x"
[define.arm]
gravity = [0, 0, -9.81]
[define.arm.coordinates]
a = { unit = "rad" }
b = { unit = "rad" }
[define.arm.orientations]
r = {}
[define.arm.frames]
upper = { rotation = { axis = [1, 0, 0], angle = 0.4 }, revolute = { axis = [0, 1, 0], angle = "a" } }
elbow = { parent = "upper", displacement = [0.5, 0, 0.1] }
lower = { parent = "elbow", revolute = { axis = [0, 0, 1], angle = "b" } }
hand = { parent = "lower", displacement = [0.4, 0, 0], spherical = "r" }
tip = { parent = "hand", displacement = [0, 0.1, 0.2] }
[define.arm.bodies]
upper = { frame = "upper", mass = 2, centre = [0.25, 0, 0], inertia = { xx = 0.01, yy = 0.05, zz = 0.05 } }
lower = { frame = "lower", mass = 1, centre = [0.2, 0, 0], inertia = { xx = 0.01, yy = 0.02, zz = 0.02 } }
hand = { frame = "hand", mass = 0.5, centre = [0, 0.05, 0.1], inertia = { xx = 0.01, yy = 0.02, zz = 0.015, xy = 0.001 } }
"#;
    // The elbow's joint, its link and the ball are joined backwards.
    let parts = r#"
[scene]
name = "parts"
[units]
hand = { unit = "spatial/body", parameters = { mass = 0.5, centre_y = 0.05, centre_z = 0.1, inertia_xx = 0.01, inertia_yy = 0.02, inertia_zz = 0.015, inertia_xy = 0.001 } }
tip = { unit = "spatial/translation", parameters = { y = 0.1, z = 0.2 } }
ball = { unit = "spatial/spherical" }
fore = { unit = "spatial/translation", parameters = { x = -0.4 } }
lower = { unit = "spatial/body", parameters = { mass = 1, centre_x = 0.2, inertia_xx = 0.01, inertia_yy = 0.02, inertia_zz = 0.02 } }
elbow = { unit = "spatial/revolute" }
arm = { unit = "spatial/translation", parameters = { x = -0.5, z = -0.1 } }
upper = { unit = "spatial/body", parameters = { mass = 2, centre_x = 0.25, inertia_xx = 0.01, inertia_yy = 0.05, inertia_zz = 0.05 } }
shoulder = { unit = "spatial/revolute", parameters = { n_y = 1, n_z = 0 } }
base = { unit = "spatial/rotation", parameters = { n_x = 1, n_z = 0, angle = 0.4 } }
world = { unit = "spatial/world" }
JOINTS
[run]
until = 1
points = 21
rtol = 1e-11
[initial]
"shoulder.phi" = 0.3
"elbow.omega" = -1.5
BALL
[outputs]
a = "shoulder.phi"
b = { expression = "-elbow.phi", unit = "rad" }
x = "tip.b_x"
"#;
    let joints = [
        "tip.a=hand.a",
        "fore.a=BALL_OUT",
        "hand.a=BALL_IN",
        "elbow.a=lower.a",
        "fore.b=lower.a",
        "arm.a=elbow.b",
        "arm.b=shoulder.b",
        "upper.a=shoulder.b",
        "shoulder.a=base.b",
        "base.a=world.frame",
    ];
    let scene = |ball: [&str; 3]| {
        let joints = joints.map(|joint| {
            let joint = joint.replace("BALL_OUT", ball[0]).replace("BALL_IN", ball[1]);
            let (one, other) = joint.split_once('=').expect("two ports");
            format!("[[joints]]\nconnect = [\"{one}\", \"{other}\"]\n")
        });
        parts.replace("JOINTS", &joints.concat()).replace("BALL", ball[2])
    };
    let forward = scene(["ball.a", "ball.b", "\"ball.turn_omega_y\" = 0.7"]);
    // Joined backwards, its rates are those of the fore-arm in the hand: the opposite at the start.
    let backward = scene(["ball.b", "ball.a", "\"ball.turn_omega_y\" = -0.7"]);
    let of = |text: &str| run(&of_text(text, Keep::Needed), &[], &[]);
    let wanted = of(whole);
    for text in [forward, backward] {
        let found = of(&text);
        for name in ["a", "b", "x", "energy.total"] {
            let rows = column(&found, name).iter().zip(column(&wanted, name));
            for (found, wanted) in rows {
                assert!((found - wanted).abs() < 1e-8, "{name}: {found} instead of {wanted}");
            }
        }
    }
}

#[test]
fn frames_that_cannot_be_joined_are_reported() {
    let text = r#"
[scene]
name = "parts"
[units]
world = { unit = "spatial/world" }
pivot = { unit = "spatial/revolute" }
bob = { unit = "spatial/body" }
lone = { unit = "spatial/body" }
[[joints]]
connect = ["world.frame", "lone.a"]
[[joints]]
connect = ["world.frame", "pivot.a"]
[[joints]]
connect = ["pivot.b", "bob.a"]
[outputs]
angle = "pivot.phi"
[run]
until = 1
rtol = 1e-9
"#;
    assert!(of_text(text, Keep::Needed).shape().coordinates == 1);
    for (before, after, wanted) in [
        ("[\"world.frame\", \"pivot.a\"]", "[\"pivot.b\", \"bob.a\"]", "without a joint"),
        ("[\"world.frame\", \"pivot.a\"]", "[\"world.frame\", \"pivot.b\"]\nratio = 2", "ratio"),
        ("connect = [\"world.frame\", \"lone.a\"]\n[[joints]]\n", "", "nothing connects"),
        ("[\"world.frame\", \"pivot.a\"]", "[\"world.frame\", \"pivot.axis\"]", "is not"),
        ("[\"world.frame\", \"pivot.a\"]", "[\"world.frame\", \"pivot.c\"]", "no port `c`"),
        (
            "[\"pivot.b\", \"bob.a\"]",
            "[\"pivot.b\", \"bob.a\"]\n[[joints]]\nconnect = [\"world.frame\", \"other.frame\"]",
            "give the gravity of the same machine",
        ),
    ] {
        assert!(text.contains(before), "{before}");
        let other = "[units]\nother = { unit = \"spatial/world\" }";
        let said = refusal(&text.replacen(before, after, 1).replace("[units]", other));
        assert!(said.contains(wanted), "{wanted}: {said}");
    }
}
