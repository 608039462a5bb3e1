//! Robots of a reference file as scenes.

use std::fmt::Write as _;

use serde_json::Value;

/// Returns the robots of the reference file.
pub fn robots() -> Value {
    serde_json::from_str(include_str!("robots.json")).expect("it is JSON")
}

/// Returns a list of numbers.
pub fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|v| v.as_f64().expect("a number")).collect()
}

/// Returns the rows of a matrix.
pub fn rows(value: &Value) -> Vec<Vec<f64>> {
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
pub fn scene_of(robot: &Value) -> String {
    let mut text = format!(
        "[scene]\nname = \"robot\"\n[units]\nr = {{ unit = \"robot\" }}\n[run]\nuntil = 1\n\
         [define.robot]\ngravity = {}\n",
        robot["gravity"]
    );
    for (index, joint) in robot["joints"].as_array().expect("joints").iter().enumerate() {
        let (n, kind) = (index + 1, joint["type"].as_str().expect("a type"));
        if kind == "JointModelFreeFlyer" {
            text += FREE;
            text += &body_of(n, joint);
            continue;
        }
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
        write!(
            text,
            "[define.robot.coordinates.q{n}]\nunit = \"{0}\"\n\
             [define.robot.parameters.tau{n}]\nvalue = 0\nunit = \"{1}\"\n\
             [[define.robot.forces]]\ncoordinate = \"q{n}\"\nexpression = \"tau{n}\"\n\
             [define.robot.frames.f{n}]\nparent = \"{parent}\"\ndisplacement = {2}\n\
             rotation = {{ quaternion = {turned:?} }}\n{3} = {{ axis = {axis}, {4} = \"q{n}\" }}\n",
            unit[0], unit[1], joint["p"], by[0], by[1],
        )
        .expect("text");
        text += &body_of(n, joint);
    }
    text
}

/// A base that moves freely.
const FREE: &str = r#"
[define.robot.coordinates]
x = { unit = "m" }
y = { unit = "m" }
z = { unit = "m" }
yaw = { unit = "rad" }
pitch = { unit = "rad" }
roll = { unit = "rad" }
[define.robot.frames.f1]
displacement = ["x", "y", "z"]
rotation = { sequence = "zyx", angles = ["yaw", "pitch", "roll"] }
"#;

fn body_of(n: usize, joint: &Value) -> String {
    let inertia = rows(&joint["inertia_at_com"]);
    format!(
        "[define.robot.bodies.b{n}]\nframe = \"f{n}\"\nmass = {0}\ncentre = {1}\n\
         inertia = {{ xx = {2}, yy = {3}, zz = {4}, xy = {5}, xz = {6}, yz = {7} }}\n",
        joint["mass"],
        joint["com"],
        inertia[0][0],
        inertia[1][1],
        inertia[2][2],
        inertia[0][1],
        inertia[0][2],
        inertia[1][2],
    )
}
