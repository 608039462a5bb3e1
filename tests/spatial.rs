//! Rigid bodies in space, compared with references and closed forms.
//!
//! `spatial/robots.json` has mass matrices, accelerations and their derivatives, computed by
//! Pinocchio 4.1 (`pinocchio.crba`, `rnea`, `aba`, `computeABADerivatives`) from the robot
//! descriptions of the Python package example-robot-data 6.0.0.

mod long_trees;
mod robots;

use std::fmt::Write as _;

use machinist::complex_step::dense;
use machinist::{Simulation, Trajectory};
use machinist_codegen::independent::Comparison;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, Real as _, Simulator};
use machinist_model::Model;
use machinist_model::evaluate::{Evaluator, Inputs};
use machinist_studies::double_double::DoubleDouble;
use nalgebra::{DMatrix, Matrix3, Quaternion, UnitQuaternion, Vector3};

use crate::common::column;
use crate::own_scene::{of_text, refusal, system_of};
use robots::{numbers, robots, rows, scene_of};

/// Returns the largest difference of two matrices, relative to the largest entry.
fn off(found: impl Fn(usize, usize) -> f64, wanted: &[Vec<f64>]) -> f64 {
    let size = wanted.iter().flatten().fold(0.0, |size: f64, entry| size.max(entry.abs()));
    let mut worst: f64 = 0.0;
    for (i, row) in wanted.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            worst = worst.max((found(i, j) - entry).abs());
        }
    }
    worst / size.max(1e-300)
}

fn compared_with_pinocchio(name: &str, tolerance: f64) {
    let robot = &robots()["robots"][name];
    let scene = of_text(&scene_of(robot), Keep::All);
    let n = scene.shape().coordinates;
    for state in robot["states"].as_array().expect("states") {
        let y = [numbers(&state["q"]), numbers(&state["v"])].concat();
        let p = numbers(&state["tau"]);
        let energy = Simulator::<f64>::energy(&scene, 0.0, &y, &p);
        let [kinetic, potential] = ["T", "V"].map(|key| state[key].as_f64().expect("a number"));
        let size = kinetic.abs() + potential.abs();
        assert!((energy.kinetic - kinetic).abs() <= tolerance * size, "{name}: T");
        assert!((energy.potential - potential).abs() <= tolerance * size, "{name}: V");
        let mut entries = vec![0.0; scene.mass_matrix_pattern().entries.len()];
        scene.mass_matrix(0.0, &y, &p, &mut entries);
        let mass_matrix = dense(scene.mass_matrix_pattern(), &entries);
        let error = off(|i, j| mass_matrix[(i, j)], &rows(&state["M"]));
        assert!(error <= tolerance, "{name}: M is off by {error:e}");
        let mut rate = vec![0.0; 2 * n];
        scene.rate(0.0, &y, &p, &mut rate);
        let error = off(|_, j| rate[n + j], &[numbers(&state["ddq"])]);
        assert!(error <= tolerance, "{name}: q'' is off by {error:e}");
        let mut entries = vec![0.0; scene.rate_jacobian_pattern().entries.len()];
        scene.rate_jacobian(0.0, &y, &p, &mut entries);
        let jacobian = dense(scene.rate_jacobian_pattern(), &entries);
        for (key, first) in [("ddq_dq", 0), ("ddq_dv", n)] {
            let error = off(|i, j| jacobian[(n + i, first + j)], &rows(&state[key]));
            assert!(error <= tolerance, "{name}: {key} is off by {error:e}");
        }
    }
}

#[test]
fn robots_move_as_pinocchio_says() {
    for name in ["ur5", "panda", "double_pendulum", "two_dofs"] {
        compared_with_pinocchio(name, 1e-12);
    }
}

/// Pinocchio's velocities of a free base are those of its frame, along its own axes; ours are rates
/// of position and of angles about z, y and x.
#[test]
fn a_quadruped_moves_as_pinocchio_says() {
    let robot = &robots()["robots"]["hyq"];
    let scene = of_text(&scene_of(robot), Keep::All);
    let p = vec![0.0; scene.shape().parameters];
    let mut compared = 0;
    for state in robot["states"].as_array().expect("states") {
        let (q, v) = (numbers(&state["q"]), numbers(&state["v"]));
        let turned = UnitQuaternion::new_normalize(Quaternion::new(q[6], q[3], q[4], q[5]));
        let (roll, pitch, yaw) = turned.euler_angles();
        let (linear, omega) = (Vector3::new(v[0], v[1], v[2]), Vector3::new(v[3], v[4], v[5]));
        let angles = [yaw, pitch, roll];
        let to_omega = omega_by_rates(angles);
        let rates = to_omega.try_inverse().expect("regular") * omega;
        let velocity = turned * linear;
        let positions = [&q[..3], &angles, &q[7..]].concat();
        let y = [&positions[..], velocity.as_slice(), rates.as_slice(), &v[6..]].concat();
        let energy = Simulator::<f64>::energy(&scene, 0.0, &y, &p);
        let [kinetic, potential] = ["T", "V"].map(|key| state[key].as_f64().expect("a number"));
        let size = kinetic.abs() + potential.abs();
        assert!((energy.kinetic - kinetic).abs() <= 1e-12 * size, "T");
        assert!((energy.potential - potential).abs() <= 1e-12 * size, "V");
        let Some(wanted) = state.get("ddq").map(numbers) else { continue };
        let mut rate = vec![0.0; 36];
        scene.rate(0.0, &y, &p, &mut rate);
        let bends = Vector3::from_column_slice(&rate[21..24]);
        // d(R^T p')/dt = R^T p'' - omega x (R^T p'), and d(W e')/dt = W e'' + W' e'.
        let moving = turned.inverse() * Vector3::from_column_slice(&rate[18..21]);
        let linear = moving - omega.cross(&linear);
        let turning = to_omega * bends + rate_of_omega(angles, rates.into());
        let found = [linear.as_slice(), turning.as_slice(), &rate[24..]].concat();
        let error = off(|_, j| found[j], &[wanted]);
        assert!(error <= 1e-12, "q'' is off by {error:e}");
        compared += 1;
    }
    assert_eq!(compared, 1);
}

/// Returns W of omega = W \[yaw', pitch', roll'\] along the axes of the frame.
fn omega_by_rates([_, pitch, roll]: [f64; 3]) -> Matrix3<f64> {
    let ((sp, cp), (sr, cr)) = (pitch.sin_cos(), roll.sin_cos());
    Matrix3::new(-sp, 0.0, 1.0, cp * sr, cr, 0.0, cp * cr, -sr, 0.0)
}

/// Returns W' \[yaw', pitch', roll'\].
fn rate_of_omega([_, pitch, roll]: [f64; 3], [yaw_rate, dp, dr]: [f64; 3]) -> Vector3<f64> {
    let ((sp, cp), (sr, cr)) = (pitch.sin_cos(), roll.sin_cos());
    Vector3::new(
        -cp * dp * yaw_rate,
        (-sp * dp * sr + cp * cr * dr) * yaw_rate - sr * dr * dp,
        (-sp * dp * cr - cp * sr * dr) * yaw_rate - cr * dr * dp,
    )
}

pub fn run(text: &str) -> Trajectory {
    Simulation::new(&of_text(text, Keep::Needed)).run().unwrap_or_else(|error| panic!("{error}"))
}

/// Returns an orientation in a row.
pub fn turned(run: &Trajectory, name: &str, row: usize) -> UnitQuaternion<f64> {
    let [w, x, y, z] = ["w", "x", "y", "z"].map(|part| column(run, &format!("{name}_{part}"))[row]);
    UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z))
}

/// Returns its rates in a row \[rad/s\].
pub fn omega(run: &Trajectory, name: &str, row: usize) -> Vector3<f64> {
    let [x, y, z] = ["x", "y", "z"].map(|axis| column(run, &format!("{name}_omega_{axis}"))[row]);
    Vector3::new(x, y, z)
}

/// Asserts that a scene moves as a second derivation says, and returns the error.
pub fn compared(text: &str) -> f64 {
    let system = system_of(text);
    let scene = of_text(text, Keep::All);
    let comparison = Comparison::new(&system, &scene, DoubleDouble::to_f64).expect("comparable");
    let parameters: Vec<f64> =
        (0..scene.shape().parameters).map(|k| scene.parameter_default(k)).collect();
    let found = comparison.at_random(10, &parameters, 0x5eed);
    assert!(found.compared > 10, "{found:?}");
    assert!(found.error <= 1e-11, "{found:?}");
    found.error
}

/// The reference is good to 5e-11: Pinocchio's `aba`, integrated by DOP853 of scipy at rtol 1e-13.
#[test]
fn an_arm_falls_as_pinocchio_says() {
    let reference: Vec<Vec<f64>> = include_str!("spatial/ur5_free_fall.csv")
        .lines()
        .filter(|line| line.starts_with(|c: char| c.is_ascii_digit()))
        .map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    let start = &reference[0];
    let mut text = scene_of(&robots()["robots"]["ur5"]);
    text =
        text.replace("until = 1\n", "until = 1\npoints = 11\nrtol = 1e-12\nmethod = \"dop853\"\n");
    text += "[initial]\n";
    for n in 1..=6 {
        writeln!(text, "\"r.q{n}\" = {}\n\"r.q{n}_dot\" = {}", start[n], start[6 + n])
            .expect("text");
    }
    let found = run(&text);
    for (row, wanted) in reference.iter().enumerate() {
        for n in 1..=6 {
            let error = column(&found, &format!("r.q{n}"))[row] - wanted[n];
            assert!(error.abs() < 2e-10, "q{n} at {} s is off by {error:e}", wanted[0]);
            let error = column(&found, &format!("r.q{n}_dot"))[row] - wanted[6 + n];
            assert!(error.abs() < 2e-9, "q{n}' at {} s is off by {error:e}", wanted[0]);
        }
    }
}

/// A tree with all that frames may have: branches, oblique axes, fixed rotations of each kind,
/// joints that follow a coordinate or time, several joints in a frame, bodies of parameters.
const TREE: &str = r#"
[scene]
name = "tree"

[units]
m = { unit = "tree" }

[run]
until = 1

[define.tree]
gravity = ["0.1*g", 0, "-g"]

[define.tree.coordinates]
a = { unit = "rad" }
b = { unit = "rad" }
s = { unit = "m" }
x = { unit = "m" }
u = { unit = "rad" }
v = { unit = "rad" }

[define.tree.parameters]
g = { value = 9.81, unit = "m/s^2" }
m = { value = 1.3, unit = "kg" }
l = { value = 0.7, unit = "m" }
J = { value = 0.2, unit = "kg m^2" }
omega = { value = 1.1, unit = "rad/s" }
force = { value = 2.5, unit = "N" }

[define.tree.frames]
slide = { displacement = ["x", 0, "0.2 [m]"] }
turning = { parent = "slide", revolute = { axis = [0, 0, 1], angle = "omega*t + a" } }
oblique = { parent = "turning", displacement = ["l", 0.1, 0], rotation = { roll_pitch_yaw = [0.3, -0.2, "90 [deg]"] }, revolute = { axis = [1, 2, -2], angle = "b" } }
rod = { parent = "oblique", rotation = { axis = [0, 1, 1], angle = "40 [deg]" }, prismatic = { axis = [1, 0, 1], displacement = "s + 0.1 [m]" } }
gimbal = { parent = "turning", displacement = [0, "-l", 0], rotation = [{ quaternion = [0.8, 0.1, -0.3, 0.5] }, { sequence = "zxy", angles = ["u", "0.5*v", "v"] }] }
follower = { parent = "gimbal", revolute = { axis = [0, 1, 0], angle = "-0.5*b + 0.3 [rad]" } }
tool = { parent = "rod", displacement = [0.1, 0.2, 0.3], rotation = { sequence = "xyx", angles = [0.1, 0.2, 0.3] } }

[define.tree.bodies]
slide = { frame = "slide", mass = 2 }
arm = { frame = "oblique", mass = "m", centre = ["l/2", 0.1, 0], inertia = { xx = "J/2", yy = "J", zz = "J", xy = 0.01 } }
tip = { frame = "tool", mass = "m/2", centre = [0, 0.1, 0.1], inertia = { xx = 0.01, yy = 0.02, zz = 0.025, yz = 0.003 }, rotation = { axis = [1, 0, 0], angle = 0.4 } }
rotor = { frame = "gimbal", mass = 1, centre = [0.1, 0, 0.2], inertia = { xx = 0.1, yy = 0.2, zz = 0.15 } }
last = { frame = "follower", mass = 0.5, centre = [0.1, 0.1, 0.2], inertia = { xx = 0.1, yy = 0.1, zz = 0.1, xz = 0.02 } }

[define.tree.energy]
kinetic = "0.3 [kg]*s_dot^2/2"
potential = "5 [N/m]*s^2/2"
dissipation = "0.1 [N m s/rad]*(b_dot^2 + a_dot*u_dot + 4*a_dot^2 + u_dot^2)/2"

[[define.tree.forces]]
along = "tool_y - 0.3*slide_x"
expression = "force"

[outputs]
x = "m.tool_x"
v_x = "m.tool_v_x"
axis = "m.tool_r_zx"
turning = "m.follower_omega_y"
"#;

#[test]
fn a_tree_moves_as_its_energies_say() {
    compared(TREE);
}

/// Joints are driven and forces act, so power flows in and out.
#[test]
fn the_power_of_bodies_balances() {
    let scene = of_text(TREE, Keep::All);
    let p: Vec<f64> = (0..scene.shape().parameters).map(|k| scene.parameter_default(k)).collect();
    for sample in 0..5 {
        let y: Vec<f64> = (0..12).map(|k| f64::from(7 * sample + 3 * k).sin()).collect();
        let power = scene.power_balance(0.3 * f64::from(sample), &y, &p);
        let size = power.stored_rate.abs() + power.supplied.abs() + power.dissipated.abs();
        assert!(power.residual().abs() <= 1e-12 * size, "{power:?}");
        assert!(power.supplied.abs() > 1e-3 && power.dissipated.abs() > 1e-3, "{power:?}");
    }
}

#[test]
fn velocities_of_frames_are_rates_of_their_positions() {
    let text = TREE.replace(
        "[outputs]",
        "[outputs]\nrate = { expression = \"der(m.tool_x)\", unit = \"m/s\" }",
    );
    let scene = of_text(&text, Keep::All);
    let y: Vec<f64> = (0..12).map(|k| (1.3 * f64::from(k)).sin()).collect();
    let p: Vec<f64> = (0..scene.shape().parameters).map(|k| scene.parameter_default(k)).collect();
    let mut outputs = vec![0.0; scene.shape().outputs];
    scene.outputs(0.4, &y, &p, &mut outputs);
    let of = |name: &str| {
        let place = (0..outputs.len()).find(|k| scene.output(*k).name == name);
        outputs[place.expect("an output")]
    };
    assert!((of("rate") - of("v_x")).abs() < 1e-13, "{} {}", of("rate"), of("v_x"));
    assert!(of("rate").abs() > 0.1);
}

/// C (psi' + phi' cos) phi' - A phi'^2 cos = m g l keeps the inclination of a heavy top, with A and
/// C about the support.
#[test]
fn a_heavy_top_precesses_steadily() {
    const TOP: &str = r#"
[scene]
name = "top"
[units]
gyro = { unit = "top" }
[run]
until = 20
points = 11
rtol = 1e-11
[define.top]
gravity = [0, 0, -9.81]
[define.top.coordinates]
phi = { unit = "rad" }
theta = { unit = "rad" }
psi = { unit = "rad" }
[define.top.frames]
top = { rotation = { sequence = "zxz", angles = ["phi", "theta", "psi"] } }
[define.top.bodies]
top = { frame = "top", mass = 1.5, centre = [0, 0, 0.3], inertia = { xx = 0.05, yy = 0.05, zz = 0.02 } }
"#;
    let (c, about_support, weight_arm) = (0.02, 0.05 + 1.5 * 0.3 * 0.3, 1.5 * 9.81 * 0.3);
    let (inclination, precession) = (0.6_f64, 2.0);
    let total = (weight_arm / precession + about_support * precession * inclination.cos()) / c;
    let spin = total - precession * inclination.cos();
    let start = format!(
        "[initial]\n\"gyro.theta\" = {inclination}\n\"gyro.phi_dot\" = {precession}\n\
         \"gyro.psi_dot\" = {spin}\n"
    );
    let found = run(&format!("{TOP}{start}"));
    let rows = found.times.iter().zip(column(&found, "gyro.theta")).zip(column(&found, "gyro.phi"));
    for ((time, theta), phi) in rows {
        assert!((theta - inclination).abs() < 1e-8, "inclined by {theta} at {time} s");
        assert!((phi - precession * time).abs() < 1e-7, "turned by {phi} at {time} s");
    }
}

/// Two shafts at an angle beta, joined by a cross: tan(out) = tan(in)/cos(beta) for axes of the
/// cross that start in the plane of the shafts.
#[test]
fn a_cardan_shaft_turns_unevenly() {
    let text = r#"
[scene]
name = "cardan"
[units]
c = { unit = "cardan" }
[run]
until = 5
points = 101
rtol = 1e-10
[initial]
"c.a_dot" = 2
[guess]
"c.b" = "30 [deg]"
"c.d_dot" = 2
[outputs]
input = "c.a"
out_x = "c.output_r_xx"
out_u = "c.output_u"
[define.cardan.coordinates]
a = { unit = "rad" }
b = { unit = "rad" }
c = { unit = "rad" }
d = { unit = "rad" }
[define.cardan.frames]
input = { revolute = { axis = [0, 0, 1], angle = "a" } }
cross = { parent = "input", revolute = { axis = [1, 0, 0], angle = "b" } }
yoke = { parent = "cross", revolute = { axis = [0, 1, 0], angle = "c" } }
bearing = { rotation = { axis = [1, 0, 0], angle = "30 [deg]" } }
output = { parent = "bearing", revolute = { axis = [0, 0, 1], angle = "d" } }
[define.cardan.bodies]
input = { frame = "input", mass = 1, inertia = { xx = 0.1, yy = 0.1, zz = 0.2 } }
cross = { frame = "cross", mass = 0.1, inertia = { xx = 0.01, yy = 0.01, zz = 0.01 } }
output = { frame = "output", mass = 1, inertia = { xx = 0.1, yy = 0.1, zz = 0.3 } }
yoke = { frame = "yoke", mass = 0.1, inertia = { xx = 0.01, yy = 0.01, zz = 0.01 } }
[define.cardan.constraints]
along_x = { expression = "output_r_xz*yoke_r_xx + output_r_yz*yoke_r_yx + output_r_zz*yoke_r_zx" }
along_y = { expression = "output_r_xz*yoke_r_xy + output_r_yz*yoke_r_yy + output_r_zz*yoke_r_zy" }
around = { expression = "output_r_xx*yoke_r_xy + output_r_yx*yoke_r_yy + output_r_zx*yoke_r_zy" }
[define.cardan.outputs]
output_u = { expression = "cos(30 [deg])*output_r_yx + sin(30 [deg])*output_r_zx", unit = "1" }
"#;
    let found = run(text);
    let (x, u) = (column(&found, "out_x"), column(&found, "out_u"));
    let mut turned: f64 = 0.0;
    for (row, input) in column(&found, "input").iter().enumerate() {
        // The output's x axis turns in the plane of world x and the bearing's y.
        let out = u[row].atan2(x[row]);
        let beta = std::f64::consts::FRAC_PI_6;
        // The cross has its pins along the input's x and the output's y.
        let wanted = (input.sin() * beta.cos()).atan2(input.cos());
        let error = (out - wanted).sin();
        assert!(error.abs() < 1e-8, "{out} instead of {wanted} at {input}");
        turned = turned.max(*input);
    }
    assert!(turned > 6.0, "it turns {turned} rad");
    let energy = column(&found, "energy.total");
    let spread = energy.iter().fold(0.0, |worst: f64, e| worst.max((e - energy[0]).abs()));
    assert!(spread < 1e-8 * energy[0].abs(), "the energy changes by {spread}");
}

/// A crank and a rocker with oblique axes, connected by a rod with two balls. The loop is one
/// equation A sin b + B cos b = C of the rocker's angle b.
#[test]
fn a_spatial_four_bar_closes_its_loop() {
    let text = r#"
[scene]
name = "rssr"
[units]
l = { unit = "rssr" }
[run]
until = 3
points = 61
rtol = 1e-10
[initial]
"l.a_dot" = 5
[guess]
"l.b" = 1.2
[define.rssr]
gravity = [0, 0, -9.81]
[define.rssr.coordinates]
a = { unit = "rad" }
b = { unit = "rad" }
[define.rssr.frames]
crank = { revolute = { axis = [0, 0, 1], angle = "a" } }
pin = { parent = "crank", displacement = [0.2, 0, 0] }
rocker = { displacement = [0, 0.8, 0.3], revolute = { axis = [1, 0, 0], angle = "b" } }
ball = { parent = "rocker", displacement = [0, 0, 0.5] }
[define.rssr.bodies]
crank = { frame = "crank", mass = 1, inertia = { xx = 0.1, yy = 0.1, zz = 0.2 } }
rocker = { frame = "rocker", mass = 1, centre = [0, 0, 0.25], inertia = { xx = 0.02, yy = 0.02, zz = 0.001 } }
[define.rssr.constraints]
rod = { expression = "(pin_x - ball_x)^2 + (pin_y - ball_y)^2 + (pin_z - ball_z)^2 - 0.7 [m^2]" }
"#;
    let found = run(text);
    for (a, b) in column(&found, "l.a").iter().zip(column(&found, "l.b")) {
        // The ball is at (0, 0.8 - 0.5 sin b, 0.3 + 0.5 cos b).
        let pin = [0.2 * a.cos(), 0.2 * a.sin(), 0.0];
        let ball = [0.0, 0.8 - 0.5 * b.sin(), 0.3 + 0.5 * b.cos()];
        let square: f64 = pin.iter().zip(ball).map(|(p, q)| (p - q) * (p - q)).sum();
        assert!((square - 0.7).abs() < 1e-11, "the rod is {square} m^2 long at {a}");
    }
    let energy = column(&found, "energy.total");
    let spread = energy.iter().fold(0.0, |worst: f64, e| worst.max((e - energy[0]).abs()));
    assert!(spread < 1e-8, "the energy changes by {spread}");
    let turned = column(&found, "l.a").last().copied().expect("rows");
    assert!(turned.abs() > 3.0, "the crank turns by {turned}");
}

#[test]
fn mistakes_in_frames_and_bodies_are_reported_where_they_are() {
    let with = |before: &str, after: &str| {
        assert!(TREE.contains(before), "{before}");
        refusal(&TREE.replace(before, after))
    };
    for (before, after, wanted) in [
        ("parent = \"slide\"", "parent = \"slid\"", "there is no frame `slid`"),
        ("slide = { displacement", "slide = { parent = \"tool\", displacement", "its own parent"),
        ("axis = [1, 2, -2]", "axis = [0, 0, 0]", "an axis of length 0 has no direction"),
        ("axis = [1, 2, -2]", "axis = [0, 1]", "has 3 entries"),
        ("quaternion = [0.8, 0.1, -0.3, 0.5]", "quaternion = [0, 0, 0, 0]", "no rotation"),
        ("\"zxy\"", "\"zzy\"", "is not a sequence of axes"),
        ("frame = \"gimbal\", mass = 1", "frame = \"gimbal\", mass = -1", "is negative"),
        ("frame = \"gimbal\", mass = 1", "frame = \"gimbal\", mass = \"l\"", "a mass is in"),
        ("displacement = \"s + 0.1 [m]\"", "displacement = \"b\"", "a displacement is in m"),
        ("displacement = \"s + 0.1 [m]\"", "displacement = \"tool_x\"", "depends on a frame"),
        ("angle = \"b\"", "angle = \"b_dot*0.1 [s]\"", "which is not allowed here"),
        (
            "rotation = { axis = [1, 0, 0], angle = 0.4 }",
            "rotation = { axis = [1, 0, 0], angle = \"b\" }",
            "do not move",
        ),
        ("angle = \"40 [deg]\"", "angles = [0, 0, 0]", "in one of four ways"),
        ("mass = 2 }", "mas = 2 }", "lacks `mass`"),
    ] {
        let said = with(before, after);
        assert!(said.contains(wanted), "{wanted}: {said}");
    }
}

/// The disc of a gyroscope is symmetric, so no rate depends on its angle. It turns at 300 rad/s, so
/// rates are sums of large terms that cancel. The reference are central differences in 31 digits.
#[test]
fn a_fast_gyroscope_has_exact_derivatives() {
    let text = include_str!("../docs/book/src/space.md");
    let (_, text) = text.split_once("```toml,file=gyroscope.toml\n").expect("the gyroscope");
    let (text, _) = text.split_once("```").expect("its end");
    let scene = of_text(text, Keep::Needed);
    let p: Vec<f64> = (0..scene.shape().parameters).map(|k| scene.parameter_default(k)).collect();
    let run = Simulation::new(&scene).run().expect("it runs");
    let count = scene.shape().states();
    for row in [0, 100, 342, 400] {
        let y: Vec<f64> = (0..count).map(|k| column(&run, scene.state(k).name)[row]).collect();
        let mut entries = vec![0.0; scene.rate_jacobian_pattern().entries.len()];
        scene.rate_jacobian(run.times[row], &y, &p, &mut entries);
        let found = dense(scene.rate_jacobian_pattern(), &entries);
        let exact = differences(scene.model(), &y, &p);
        let error = (&found - &exact).component_div(&exact.map(|e| e.abs().max(1.0))).amax();
        assert!(error <= 1e-13, "row {row}: {error:e}");
    }
}

/// Returns dy'/dy by central differences in 31 digits, good to 16.
fn differences(model: &Model, y: &[f64], p: &[f64]) -> DMatrix<f64> {
    const STEP: f64 = 1e-9;
    let rate = Evaluator::new(&model.rate);
    let at = |k: usize, step: f64| {
        let mut state: Vec<DoubleDouble> = y.iter().map(|y| DoubleDouble::literal(*y)).collect();
        state[k] = state[k] + DoubleDouble::literal(step);
        let parameters: Vec<DoubleDouble> = p.iter().map(|p| DoubleDouble::literal(*p)).collect();
        let zero = DoubleDouble::literal(0.0);
        let inputs = Inputs {
            time: zero,
            state: &state,
            parameters: &parameters,
            handed: &[],
            constants: &[],
            motion: &[],
            tables: &[],
        };
        let mut found = vec![zero; y.len()];
        rate.evaluate_in(&mut vec![zero; rate.room()], &inputs, &mut found);
        found
    };
    let columns = (0..y.len()).flat_map(|k| {
        let pairs = at(k, STEP).into_iter().zip(at(k, -STEP));
        let slope = |(a, b): (DoubleDouble, DoubleDouble)| (a - b).to_f64() / (2.0 * STEP);
        pairs.map(slope).collect::<Vec<_>>()
    });
    DMatrix::from_iterator(y.len(), y.len(), columns)
}
