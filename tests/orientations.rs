//! Quaternions as coordinates: closed forms, the same machines by angles, and a second derivation.

mod rolling_and_spinning;

use std::f64::consts::PI;

use machinist::Simulation;
use machinist::constraints::start;
use machinist::linear_analysis::{Linearization, Mode, Place, operating_point};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, Simulator};
use machinist_model::ModelSimulator;
use nalgebra::{UnitQuaternion, Vector3};

use crate::common::column;
use crate::own_scene::{of_text, refusal};
use crate::spatial::{compared, omega, run, turned};

/// Returns sn, cn and dn of u for a parameter m, by descending Landen transformations.
fn jacobi(u: f64, m: f64) -> [f64; 3] {
    let (mut a, mut b, mut c) = (1.0, (1.0 - m).sqrt(), m.sqrt());
    let mut steps = vec![(a, c)];
    while c.abs() > 1e-16 * a {
        (a, b, c) = (f64::midpoint(a, b), (a * b).sqrt(), (a - b) / 2.0);
        steps.push((a, c));
    }
    let mut phi = 2f64.powi(steps.len() as i32 - 1) * a * u;
    for (a, c) in steps.iter().skip(1).rev() {
        phi = f64::midpoint((c / a * phi.sin()).asin(), phi);
    }
    [phi.sin(), phi.cos(), (1.0 - m * phi.sin().powi(2)).sqrt()]
}

const FREE: &str = r#"
[scene]
name = "free"
[units]
b = { unit = "body" }
[run]
until = UNTIL
points = POINTS
rtol = RTOL
method = "METHOD"
[initial]
"b.turn_omega_x" = WX
"b.turn_omega_y" = WY
"b.turn_omega_z" = WZ
[define.body.orientations]
turn = { rotation = { sequence = "zyx", angles = [0.3, -1.5707963267948966, 0.8] } }
[define.body.frames]
body = { spherical = "turn" }
[define.body.bodies]
body = { frame = "body", mass = 2, inertia = { xx = 0.5, yy = 0.3, zz = 0.1 } }
"#;

fn free(method: &str, rtol: f64, until: f64, points: usize, rates: [f64; 3]) -> String {
    let [x, y, z] = rates.map(|rate| format!("{rate:?}"));
    FREE.replace("METHOD", method)
        .replace("RTOL", &format!("{rtol:e}"))
        .replace("UNTIL", &format!("{until:?}"))
        .replace("POINTS", &points.to_string())
        .replace("WX", &x)
        .replace("WY", &y)
        .replace("WZ", &z)
}

/// Euler's equations: with A > B > C and A, C about the axes of sn at the start 0, the rates are
/// w_x = a cn, w_y = b sn, w_z = c dn of k t if 2 T B > L^2. Landau and Lifshitz, Mechanics, section
/// 37. The angular momentum along the world's axes stays.
#[test]
fn a_free_body_turns_as_elliptic_functions() {
    let [a, b, c] = [0.5, 0.3, 0.1];
    for (method, tolerance) in [
        ("dop853", 1e-9),
        ("taylor", 1e-9),
        ("tsit5", 1e-7),
        ("radau", 1e-6),
        ("rodas5p", 1e-6),
        ("auto", 1e-8),
    ] {
        for start in [[0.7, 0.0, 4.0], [0.2, 0.0, 9.0]] {
            let [x, _, z]: [f64; 3] = start;
            let twice_energy = a * x * x + c * z * z;
            let square = (a * x).powi(2) + (c * z).powi(2);
            assert!(twice_energy * b > square, "the larger part is about z");
            let rate = ((b - c) * (twice_energy * a - square) / (a * b * c)).sqrt();
            let m = (a - b) * (square - twice_energy * c) / ((b - c) * (twice_energy * a - square));
            let middle = ((square - twice_energy * c) / (b * (b - c))).sqrt();
            let found = run(&free(method, 1e-11, 20.0, 101, start));
            let momentum = |row: usize| {
                let own = omega(&found, "b.turn", row).component_mul(&Vector3::new(a, b, c));
                turned(&found, "b.turn", row) * own
            };
            for (row, time) in found.times.iter().enumerate() {
                let [sn, cn, dn] = jacobi(rate * time, m);
                // The direction of w_y follows from B w_y' = (C - A) w_z w_x.
                let wanted = Vector3::new(x * cn, -middle * sn, z * dn);
                let error = (omega(&found, "b.turn", row) - wanted).norm();
                assert!(error < tolerance * 10.0, "{method}: {error:e} at {time} s");
                let drift = (momentum(row) - momentum(0)).norm() / momentum(0).norm();
                assert!(drift < tolerance, "{method}: L is off by {drift:e} at {time} s");
            }
        }
    }
}

/// 10 000 turns of a body about an axis beside a principal one.
#[test]
fn energy_and_momentum_of_a_free_body_last() {
    let until = 10_000.0 * 2.0 * PI / 9.0;
    let found = run(&free("taylor", 1e-12, until, 5, [0.2, 0.3, 9.0]));
    let inertia = Vector3::new(0.5, 0.3, 0.1);
    let of = |row: usize| {
        let own = omega(&found, "b.turn", row).component_mul(&inertia);
        let energy = own.dot(&omega(&found, "b.turn", row)) / 2.0;
        (turned(&found, "b.turn", row) * own, energy)
    };
    let ((momentum, energy), (last, last_energy)) = (of(0), of(4));
    let drift = (last - momentum).norm() / momentum.norm();
    assert!(drift < 2e-9, "L is off by {drift:e}");
    assert!((last_energy / energy - 1.0).abs() < 2e-9, "T is {last_energy}, at first {energy}");
}

/// A machine with everything that orientations may be used for, once by quaternions and once by
/// angles.
const MACHINE: &str = r#"
[scene]
name = "machine"
[units]
m = { unit = "machine" }
[run]
until = 1
rtol = 1e-10
points = 11
[define.machine]
gravity = ["0.2*g", 0, "-g"]
[define.machine.parameters]
g = { value = 9.81, unit = "m/s^2" }
k = { value = 40, unit = "N/m" }
drag = { value = 0.05, unit = "N m s/rad" }
pull = { value = 3, unit = "N" }
spin = { value = 0.7, unit = "rad/s" }
[define.machine.coordinates]
s = { unit = "m" }
a = { unit = "rad" }
ANGLES
[define.machine.frames]
slide = { rotation = { axis = [1, 2, 3], angle = 0.4 }, prismatic = { axis = [0, 1, 1], displacement = "s" } }
ball = { parent = "slide", displacement = [0.1, 0.2, -0.1], rotation = { axis = [0, 1, 0], angle = "spin*t" }, JOINT }
tip = { parent = "ball", displacement = [0, 0.3, 0.4] }
arm = { parent = "ball", displacement = [0.2, 0, 0], revolute = { axis = [0, 0, 1], angle = "a" } }
[define.machine.bodies]
slide = { frame = "slide", mass = 2 }
ball = { frame = "ball", mass = 1.5, centre = [0, 0.1, 0.1], inertia = { xx = 0.05, yy = 0.06, zz = 0.07, xy = 0.004 } }
arm = { frame = "arm", mass = 0.6, centre = [0.2, 0, 0], inertia = { xx = 0.002, yy = 0.01, zz = 0.011 } }
[define.machine.energy]
kinetic = "KINETIC"
potential = "k*(tip_x^2 + (tip_y - 0.3 [m])^2 + tip_x*tip_z)/2"
dissipation = "drag*(tip_omega_x^2 + tip_omega_y^2 + a_dot^2)/2"
[[define.machine.forces]]
along = "tip_y + 0.3*tip_r_xz*tip_x"
expression = "pull*cos(3 [rad/s]*t)"
[define.machine.helpers]
rate = { expression = "der(tip_x*tip_r_yz)", unit = "m/s" }
[outputs]
x = "m.tip_x"
y = "m.arm_y"
axis = "m.arm_r_zx"
power = "m.rate"
bend = { expression = "der(m.tip_v_x)", unit = "m/s^2" }
"#;

/// A kinetic energy beside that of the bodies, whose momenta turn with the body.
const BESIDE: &str = "0.2 [kg]*(tip_v_x^2 + tip_v_y^2 + 2*tip_v_z^2)/2 + 0.004 [kg \
                      m^2]*(tip_omega_z*a_dot + tip_omega_x^2)";

fn by_quaternion(text: &str) -> String {
    text.replace("ANGLES", "").replace("JOINT", "spherical = \"turn\"").replace("KINETIC", BESIDE)
        + "[define.machine.orientations]\nturn = { rotation = { sequence = \"zxy\", angles = \
           [0.3, 0.5, -0.2] } }\n"
}

/// The rates about the turned axes y, x and z of a sequence "zxy" follow from those of its angles.
fn by_angles(text: &str) -> String {
    text.replace("ANGLES", "u = { unit = \"rad\" }\nv = { unit = \"rad\" }\nw = { unit = \"rad\" }")
        .replace(
            "rotation = { axis = [0, 1, 0], angle = \"spin*t\" }, JOINT",
            "rotation = [{ axis = [0, 1, 0], angle = \"spin*t\" }, { sequence = \"zxy\", angles = \
         [\"u\", \"v\", \"w\"] }]",
        )
}

#[test]
fn quaternions_move_as_angles() {
    let (u, v, w): (f64, f64, f64) = (0.3, 0.5, -0.2);
    let rates = [1.1, -0.6, 0.8];
    // omega = E_y(w)^T (E_x(v)^T z u' + x v') + y w'.
    let [z, x, y] = [Vector3::z(), Vector3::x(), Vector3::y()];
    let by =
        |axis: Vector3<f64>, angle: f64| UnitQuaternion::from_scaled_axis(axis * angle).inverse();
    let omega = by(y, w) * (by(x, v) * (z * rates[0]) + x * rates[1]) + y * rates[2];
    let machine = MACHINE.replace("KINETIC", "0.2 [kg]*s_dot^2/2");
    let angles = by_angles(&machine)
        + &*format!(
            "[initial]\n\"m.u\" = {u}\n\"m.v\" = {v}\n\"m.w\" = {w}\n\"m.u_dot\" = {}\n\"m.v_dot\" \
             = {}\n\"m.w_dot\" = {}\n",
            rates[0], rates[1], rates[2]
        );
    let [p, q, r] = [omega.x, omega.y, omega.z];
    let quaternion = by_quaternion(&machine)
        + &*format!(
            "[initial]\n\"m.turn_omega_x\" = {p:?}\n\"m.turn_omega_y\" = {q:?}\n\
             \"m.turn_omega_z\" = {r:?}\n"
        );
    let (one, other) = (run(&quaternion), run(&angles));
    for name in ["x", "y", "axis", "power", "bend", "m.s", "m.a", "energy.total"] {
        for (row, (found, wanted)) in
            column(&one, name).iter().zip(column(&other, name)).enumerate()
        {
            let error = (found - wanted).abs();
            assert!(error < 1e-7 * (1.0 + wanted.abs()), "{name}: {found}, {wanted} at row {row}");
        }
    }
}

#[test]
fn quaternions_move_as_energies_say() {
    compared(&by_quaternion(MACHINE));
    // With a constraint on positions, and one on velocities.
    let held = by_quaternion(MACHINE)
        + "[define.machine.constraints]\nrod = { expression = \"(tip_x - 1 [m])^2 + tip_y^2 + \
           tip_z^2 - 1.2 [m^2]\" }\nroll = { expression = \"tip_v_x*tip_r_xx - 0.2 \
           [m]*arm_omega_z\" }\n";
    compared(&held);
}

/// The same outputs by names and by vectors.
#[test]
fn vectors_are_their_components() {
    let vectors = by_quaternion(MACHINE)
        + "[define.machine.outputs]\nrolls = { expression = \"dot(omega(ball), z_axis(tip))\", unit = \
           \"rad/s\" }\n";
    let pairs = [
        (
            "m.rolls",
            "m.ball_omega_x*m.tip_r_xz + m.ball_omega_y*m.tip_r_yz + m.ball_omega_z*m.tip_r_zz",
            "rad/s",
        ),
        (
            "norm(position(m.tip) - position(m.arm))",
            "sqrt((m.tip_x - m.arm_x)^2 + (m.tip_y - m.arm_y)^2 + (m.tip_z - m.arm_z)^2)",
            "m",
        ),
        (
            "y_of(cross(omega(m.tip), position(m.tip)))",
            "m.tip_omega_z*m.tip_x - m.tip_omega_x*m.tip_z",
            "m/s",
        ),
        (
            "x_of(in_frame(2*velocity(m.tip), m.arm)/3)",
            "2/3*(m.tip_v_x*m.arm_r_xx + m.tip_v_y*m.arm_r_yx + m.tip_v_z*m.arm_r_zx)",
            "m/s",
        ),
        ("z_of(der(position(m.tip)))", "m.tip_v_z", "m/s"),
        ("norm(x_axis(m.tip))", "1", "1"),
        ("x_of(-vector(m.s, 0, 0) + position(m.ball))", "m.ball_x - m.s", "m"),
        // A point that is fixed to a body moves with its angular velocity.
        (
            "y_of(velocity(m.ball) + cross(omega(m.ball), position(m.tip) - position(m.ball)))",
            "m.tip_v_y",
            "m/s",
        ),
    ];
    let mut outputs = String::new();
    for (number, (one, other, unit)) in pairs.iter().enumerate() {
        for (name, text) in [("a", one), ("b", other)] {
            use std::fmt::Write as _;
            writeln!(outputs, "{name}{number} = {{ expression = \"{text}\", unit = \"{unit}\" }}")
                .expect("text");
        }
    }
    let scene =
        of_text(&vectors.replace("[outputs]\n", &format!("[outputs]\n{outputs}")), Keep::All);
    let p: Vec<f64> = (0..scene.shape().parameters).map(|k| scene.parameter_default(k)).collect();
    let states = scene.shape().states() as u32;
    let y: Vec<f64> = (0..states).map(|k| (1.7 * f64::from(k)).sin()).collect();
    let mut values = vec![0.0; scene.shape().outputs];
    scene.outputs(0.2, &y, &p, &mut values);
    for (number, (one, ..)) in pairs.iter().enumerate() {
        let [a, b] = ["a", "b"].map(|name| {
            let name = format!("{name}{number}");
            values[(0..values.len()).find(|k| scene.output(*k).name == name).expect("an output")]
        });
        assert!((a - b).abs() < 1e-12 * (1.0 + b.abs()) && b.abs() > 1e-3, "{one}: {a}, {b}");
    }
    let refused = [
        ("dot(position(m.tip), 3)", "this is not a vector"),
        ("position(m.tip)", "a vector is not a value"),
        ("norm(position(m.tip)*velocity(m.tip))", "a product of vectors is written"),
        ("norm(position(m.tip) + velocity(m.tip))", "m/s"),
        ("norm(position(m.top))", "unknown name"),
        ("x_of(position(2*m.tip))", "given by its name"),
        ("dot(position(m.tip))", "wrong number"),
    ];
    for (text, wanted) in refused {
        let output = format!("[outputs]\nbad = {{ expression = \"{text}\", unit = \"m\" }}\n");
        let said = refusal(&by_quaternion(MACHINE).replace("[outputs]\n", &output));
        assert!(said.contains(wanted), "{text}: {said}");
    }
    // Vectors in vectors do not grow without limit.
    let deep =
        (0..40).fold("position(m.tip)".to_owned(), |u, _| format!("cross(vector(1, 2, 3), {u})"));
    let output = format!("[outputs]\nbad = {{ expression = \"norm({deep})\", unit = \"m\" }}\n");
    let said = refusal(&by_quaternion(MACHINE).replace("[outputs]\n", &output));
    assert!(said.contains("more than"), "{said}");
}

/// A load acts as the force along its point's position, and the reaction as the opposite.
#[test]
fn loads_act_by_virtual_work() {
    let force = "[[define.machine.forces]]\nalong = \"tip_x\"\nexpression = \"2*pull\"\n\
                 [[define.machine.forces]]\nalong = \"tip_z\"\nexpression = \"-pull\"\n";
    let load =
        "[define.machine.loads]\npush = { frame = \"tip\", force = [\"2*pull\", 0, \"-pull\"] }\n";
    // The turned axes of the arm, and a torque about the axis of its joint, which takes the reaction.
    let motor =
        "[[define.machine.forces]]\ncoordinate = \"a\"\nexpression = \"0.3 [N m]*cos(t/1 [s])\"\n";
    let torque = "[define.machine.loads]\nmotor = { frame = \"arm\", against = \"ball\", axes = \"arm\", \
                  torque = [0, 0, \"0.3 [N m]*cos(t/1 [s])\"] }\n";
    // A force at the arm's end along its own axes, and its reaction on the slide at that point.
    let inner = "[define.machine.loads]\npair = { frame = \"arm\", against = \"slide\", axes = \"tip\", \
                 force = [\"pull\", \"-pull\", \"3*pull\"], torque = [1, 2, 3] }\n";
    let opposite = "[define.machine.loads]\npair = { frame = \"arm\", axes = \"tip\", force = \
                    [\"pull\", \"-pull\", \"3*pull\"], torque = [1, 2, 3] }\nback = { frame = \"at\", axes = \
                    \"tip\", force = [\"-pull\", \"pull\", \"-3*pull\"], torque = [-1, -2, -3] }\n";
    let at_arm = "at = { parent = \"slide\" }\n[define.machine.bodies]";
    for (one, other) in [(force, load), (motor, torque)] {
        let [one, other] = [one, other].map(|text| rate_of(&(by_quaternion(MACHINE) + text)));
        for (a, b) in one.iter().zip(&other) {
            assert!((a - b).abs() < 1e-11 * (1.0 + b.abs()), "{one:?} {other:?}");
        }
    }
    let pair = rate_of(&(by_quaternion(MACHINE) + inner));
    let alone = rate_of(&by_quaternion(MACHINE));
    assert!(pair.iter().zip(&alone).any(|(a, b)| (a - b).abs() > 1e-3));
    // Without the moment of the force about the slide, which cannot turn, the reaction is the same.
    let text = by_quaternion(MACHINE).replace("[define.machine.bodies]", at_arm) + opposite;
    for (a, b) in pair.iter().zip(rate_of(&text)) {
        assert!((a - b).abs() < 1e-11 * (1.0 + b.abs()), "{a} {b}");
    }
    for (text, wanted) in [
        ("push = { frame = \"tip\" }", "neither `force` nor `torque`"),
        ("push = { frame = \"top\", force = [1, 2, 3] }", "there is no frame `top`"),
        ("push = { frame = \"world\", force = [1, 2, 3] }", "nothing that moves"),
        ("push = { frame = \"tip\", force = [\"s\", 2, 3] }", "force"),
        ("push = { frame = \"tip\", torque = [1, 2] }", "has 3 entries"),
    ] {
        let said = refusal(&(by_quaternion(MACHINE) + "[define.machine.loads]\n" + text + "\n"));
        assert!(said.contains(wanted), "{wanted}: {said}");
    }
}

fn rate_of(text: &str) -> Vec<f64> {
    let scene = of_text(text, Keep::All);
    let p: Vec<f64> = (0..scene.shape().parameters).map(|k| scene.parameter_default(k)).collect();
    let y: Vec<f64> =
        (0..scene.shape().states() as u32).map(|k| (1.7 * f64::from(k)).sin()).collect();
    let mut rate = vec![0.0; y.len()];
    scene.rate(0.2, &y, &p, &mut rate);
    rate
}

#[test]
fn the_power_of_quaternions_balances() {
    let scene = of_text(&by_quaternion(MACHINE), Keep::All);
    let p: Vec<f64> = (0..scene.shape().parameters).map(|k| scene.parameter_default(k)).collect();
    for sample in 0..5 {
        let states = scene.shape().states() as u32;
        let y: Vec<f64> = (0..states).map(|k| f64::from(7 * sample + 3 * k).sin()).collect();
        let power = scene.power_balance(0.3 * f64::from(sample), &y, &p);
        let size = power.stored_rate.abs() + power.supplied.abs() + power.dissipated.abs();
        assert!(power.residual().abs() <= 1e-12 * size, "{power:?}");
        assert!(power.supplied.abs() > 1e-3 && power.dissipated.abs() > 1e-3, "{power:?}");
    }
}

/// A plate on three rods with balls, of which each is a constraint: the loop closes with quaternions.
#[test]
fn loops_with_quaternions_close() {
    let text = r#"
[scene]
name = "swing"
[units]
s = { unit = "swing" }
[run]
until = 20
points = 101
rtol = 1e-9
[initial]
"s.turn_omega_z" = 1.5
"s.x_dot" = 0.4
[guess]
"s.x" = 0.1
"s.z" = -0.8
"s.turn_x" = 0.1
[define.swing]
gravity = [0, 0, -9.81]
[define.swing.coordinates]
x = { unit = "m" }
y = { unit = "m" }
z = { unit = "m" }
[define.swing.orientations]
turn = {}
[define.swing.frames]
plate = { displacement = ["x", "y", "z"], spherical = "turn" }
a = { parent = "plate", displacement = [0.3, 0, 0] }
b = { parent = "plate", displacement = [-0.1, 0.2, 0] }
c = { parent = "plate", displacement = [-0.1, -0.2, 0] }
[define.swing.bodies]
plate = { frame = "plate", mass = 2, inertia = { xx = 0.02, yy = 0.04, zz = 0.06 } }
[define.swing.constraints]
rod_a = { expression = "(a_x - 0.4 [m])^2 + a_y^2 + a_z^2 - 0.81 [m^2]" }
rod_b = { expression = "(b_x + 0.2 [m])^2 + (b_y - 0.3 [m])^2 + b_z^2 - 0.81 [m^2]" }
rod_c = { expression = "(c_x + 0.2 [m])^2 + (c_y + 0.3 [m])^2 + c_z^2 - 0.81 [m^2]" }
"#;
    let scene: ModelSimulator = of_text(text, Keep::Needed);
    let first = start(&scene, &[], 0.0).expect("a start");
    let mut values = [1.0; 3];
    scene.constraint_values(0.0, &first, &[], &mut values);
    assert!(values.iter().all(|value| value.abs() < 1e-13), "{values:?}");
    let found = run(text);
    let energy = column(&found, "energy.total");
    let mut turned_by = 0.0_f64;
    for row in 0..found.times.len() {
        let state: Vec<f64> = (0..scene.shape().states())
            .map(|entry| column(&found, scene.state(entry).name)[row])
            .collect();
        scene.constraint_values(found.times[row], &state, &[], &mut values);
        assert!(values.iter().all(|value| value.abs() < 1e-12), "{values:?}");
        assert!((energy[row] - energy[0]).abs() < 1e-6, "{} J", energy[row] - energy[0]);
        turned_by = turned_by.max(turned(&found, "s.turn", row).angle());
    }
    assert!(turned_by > 0.3, "it turns by {turned_by}");
}

#[test]
fn mistakes_in_orientations_are_reported_where_they_are() {
    let text = by_quaternion(MACHINE);
    for (before, after, wanted) in [
        ("spherical = \"turn\"", "spherical = \"turm\"", "there is no orientation `turm`"),
        ("spherical = \"turn\"", "spherical = 3", "must be a string"),
        ("angles = [0.3, 0.5, -0.2]", "angles = [\"a\", 0.5, -0.2]", "depends on a coordinate"),
        ("angle = \"a\" }", "angle = \"turn_x\" }", "part of an orientation"),
        (
            "angle = \"a\" }",
            "angle = \"a\" }, spherical = \"turn\"",
            "`revolute` or `spherical`, not both",
        ),
        ("turn = {", "tip = {", "is given twice"),
        (
            "[outputs]",
            "[define.machine.ports]\np = { kind = \"rotational\", coordinate = \"turn_x\" }\n\
             [outputs]",
            "cannot be the coordinate of a port",
        ),
    ] {
        assert!(text.contains(before), "{before}");
        let said = refusal(&text.replacen(before, after, 1));
        assert!(said.contains(wanted), "{wanted}: {said}");
    }
}
