//! Rigid bodies in space, compared with references and closed forms.
//!
//! `spatial/robots.json` has mass matrices, accelerations and their derivatives, computed by
//! Pinocchio 4.1 (`pinocchio.crba`, `rnea`, `aba`, `computeABADerivatives`) from the robot
//! descriptions of the Python package example-robot-data 6.0.0.

use std::fmt::Write as _;

use machinist::complex_step::dense;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, Simulator};
use serde_json::Value;

use crate::own_scene::of_text;

fn robots() -> Value {
    serde_json::from_str(include_str!("spatial/robots.json")).expect("it is JSON")
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|v| v.as_f64().expect("a number")).collect()
}

fn rows(value: &Value) -> Vec<Vec<f64>> {
    value.as_array().expect("a list").iter().map(numbers).collect()
}

/// Returns the quaternion of a rotation matrix that turns by less than half a turn.
fn quaternion(r: &[Vec<f64>]) -> [f64; 4] {
    let trace = r[0][0] + r[1][1] + r[2][2];
    let largest = (0..3).max_by(|a, b| r[*a][*a].total_cmp(&r[*b][*b])).expect("three");
    if trace > r[largest][largest] {
        let w = (1.0 + trace).sqrt() / 2.0;
        let part = |i: usize, j: usize| (r[i][j] - r[j][i]) / (4.0 * w);
        return [w, part(2, 1), part(0, 2), part(1, 0)];
    }
    let (i, j, k) = (largest, (largest + 1) % 3, (largest + 2) % 3);
    let part = (1.0 + r[i][i] - r[j][j] - r[k][k]).sqrt() / 2.0;
    let mut q = [0.0; 4];
    q[0] = (r[k][j] - r[j][k]) / (4.0 * part);
    q[1 + i] = part;
    q[1 + j] = (r[j][i] + r[i][j]) / (4.0 * part);
    q[1 + k] = (r[k][i] + r[i][k]) / (4.0 * part);
    q
}

/// Returns a scene of a robot, with a force on each coordinate as parameter.
fn scene_of(robot: &Value) -> String {
    let mut text = format!(
        "[scene]\nname = \"robot\"\n[units]\nr = {{ unit = \"robot\" }}\n[run]\nuntil = 1\n\
         [define.robot]\ngravity = {}\n",
        robot["gravity"]
    );
    for (index, joint) in robot["joints"].as_array().expect("joints").iter().enumerate() {
        let (n, kind) = (index + 1, joint["type"].as_str().expect("a type"));
        let is_prismatic = kind.starts_with("JointModelP");
        let unit = if is_prismatic { ["m", "N"] } else { ["rad", "N m"] };
        let axis = match kind.chars().last() {
            Some('X') => "[1, 0, 0]".to_owned(),
            Some('Y') => "[0, 1, 0]".to_owned(),
            Some('Z') => "[0, 0, 1]".to_owned(),
            _ => joint["axis"].to_string(),
        };
        let by = if is_prismatic { ["prismatic", "displacement"] } else { ["revolute", "angle"] };
        let parent = match joint["parent"].as_u64() {
            Some(0) | None => "world".to_owned(),
            Some(parent) => format!("f{parent}"),
        };
        let turned = quaternion(&rows(&joint["R"]));
        let inertia = rows(&joint["inertia_at_com"]);
        write!(
            text,
            "[define.robot.coordinates.q{n}]\nunit = \"{0}\"\n\
             [define.robot.parameters.tau{n}]\nvalue = 0\nunit = \"{1}\"\n\
             [[define.robot.forces]]\ncoordinate = \"q{n}\"\nexpression = \"tau{n}\"\n\
             [define.robot.frames.f{n}]\nparent = \"{parent}\"\ndisplacement = {2}\n\
             rotation = {{ quaternion = {turned:?} }}\n{3} = {{ axis = {axis}, {4} = \"q{n}\" }}\n\
             [define.robot.bodies.b{n}]\nframe = \"f{n}\"\nmass = {5}\ncentre = {6}\n\
             inertia = {{ xx = {7}, yy = {8}, zz = {9}, xy = {10}, xz = {11}, yz = {12} }}\n",
            unit[0],
            unit[1],
            joint["p"],
            by[0],
            by[1],
            joint["mass"],
            joint["com"],
            inertia[0][0],
            inertia[1][1],
            inertia[2][2],
            inertia[0][1],
            inertia[0][2],
            inertia[1][2],
        )
        .expect("text");
    }
    text
}

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
