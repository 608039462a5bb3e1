//! Tables of Denavit and Hartenberg.
//!
//! ```text
//! standard   A = Rot_z(theta + q) Trans_z(d) Trans_x(a) Rot_x(alpha)
//! modified   A = Rot_x(alpha) Trans_x(a) Rot_z(theta + q) Trans_z(d)
//! ```
//!
//! A prismatic joint adds q to d instead. Mass, centre and inertia of a link are along the axes of the
//! frame of its row.

use super::tree::{Inertial, Joint, LARGEST, Link, Motion, Pose, Robot, RobotError, WORLD};

/// Convention of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Convention {
    /// The row's constants follow its joint (Paul).
    Standard,
    /// The row's a and alpha precede its joint (Craig).
    Modified,
}

/// Kind of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Unit {
    Text,
    Angle,
    Length,
    Other(&'static str),
}

/// Columns by name. The first four are required.
const COLUMNS: [(&str, Unit); 18] = [
    ("a", Unit::Length),
    ("alpha", Unit::Angle),
    ("d", Unit::Length),
    ("theta", Unit::Angle),
    ("joint", Unit::Text),
    ("type", Unit::Text),
    ("mass", Unit::Other("kg")),
    ("cx", Unit::Length),
    ("cy", Unit::Length),
    ("cz", Unit::Length),
    ("ixx", Unit::Other("kg m^2")),
    ("iyy", Unit::Other("kg m^2")),
    ("izz", Unit::Other("kg m^2")),
    ("ixy", Unit::Other("kg m^2")),
    ("ixz", Unit::Other("kg m^2")),
    ("iyz", Unit::Other("kg m^2")),
    ("damping", Unit::Other("")),
    ("friction", Unit::Other("")),
];

/// Reads a table, and checks the robot.
///
/// # Errors
/// The first mistake, with its line.
pub fn read(name: &str, text: &str, convention: Convention) -> Result<Robot, RobotError> {
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_reader(text.as_bytes());
    let head = reader.headers().map_err(|error| wrong(&error))?.clone();
    let columns = head.iter().map(column).collect::<Result<Vec<_>, _>>()?;
    let place = |name: &str| columns.iter().position(|(known, _)| COLUMNS[*known].0 == name);
    for (needed, _) in &COLUMNS[..4] {
        if place(needed).is_none() {
            let message = format!("the table has no column `{needed}`");
            let help = "it needs a, alpha, d and theta, and for motions mass, cx, cy, cz, ixx, \
                        iyy, izz";
            return Err(RobotError::new(1, message, help));
        }
    }
    for (index, (column, _)) in columns.iter().enumerate() {
        if columns[..index].iter().any(|(other, _)| other == column) {
            let message = format!("the table has two columns `{}`", COLUMNS[*column].0);
            return Err(RobotError::new(1, message, ""));
        }
    }
    let world = Link { name: WORLD.to_owned(), ..Link::default() };
    let mut robot = Robot { name: name.to_owned(), links: vec![world], ..Robot::default() };
    let mut last = WORLD.to_owned();
    for (index, record) in reader.records().enumerate() {
        let record = record.map_err(|error| wrong(&error))?;
        let line = record.position().map_or(0, |at| at.line() as usize);
        let value = |name: &str| -> Result<f64, RobotError> {
            let Some(at) = place(name) else { return Ok(0.0) };
            number(line, name, &record[at]).map(|value| value * columns[at].1)
        };
        let text = |name: &str| place(name).map(|at| record[at].to_owned()).unwrap_or_default();
        let mut joint = text("joint");
        if joint.is_empty() {
            joint = format!("q{}", index + 1);
        }
        let motion = match text("type").to_ascii_lowercase().as_str() {
            "" | "revolute" | "r" => Motion::Turns,
            "prismatic" | "p" => Motion::Slides,
            other => {
                let message = format!("joint `{joint}` is of type `{}`", other.escape_debug());
                return Err(RobotError::new(line, message, "write revolute or prismatic"));
            }
        };
        let values = |names: [&str; 3]| -> Result<[f64; 3], RobotError> {
            let [x, y, z] = names;
            Ok([value(x)?, value(y)?, value(z)?])
        };
        let [xx, yy, zz] = values(["ixx", "iyy", "izz"])?;
        let [xy, xz, yz] = values(["ixy", "ixz", "iyz"])?;
        let inertial = Inertial {
            origin: Pose { xyz: values(["cx", "cy", "cz"])?, rpy: [0.0; 3] },
            mass: value("mass")?,
            inertia: [xx, yy, zz, xy, xz, yz],
        };
        if value("damping")? < 0.0 || value("friction")? < 0.0 {
            let message = format!("damping and friction of `{joint}` must not be negative");
            return Err(RobotError::new(line, message, ""));
        }
        let row = Row {
            number: index + 1,
            line,
            joint,
            motion,
            distances: [value("a")?, value("d")?],
            angles: [value("alpha")?, value("theta")?],
            inertial,
            losses: [value("damping")?, value("friction")?],
        };
        last = row.add(&mut robot, &last, convention);
    }
    if robot.joints.is_empty() {
        return Err(RobotError::new(1, "the table has no rows", ""));
    }
    robot.check()?;
    Ok(robot)
}

/// A row of the table.
struct Row {
    number: usize,
    line: usize,
    joint: String,
    motion: Motion,
    /// a and d.
    distances: [f64; 2],
    /// alpha and theta.
    angles: [f64; 2],
    inertial: Inertial,
    losses: [f64; 2],
}

impl Row {
    /// Adds the row behind a link, and returns the last link.
    fn add(self, robot: &mut Robot, last: &str, convention: Convention) -> String {
        let Row { number, line, joint, motion, distances: [a, d], angles, inertial, .. } = self;
        let [alpha, theta] = angles;
        let mut link = |name: String, inertial: Option<Inertial>| {
            robot.links.push(Link { name: name.clone(), line, inertial, ..Link::default() });
            name
        };
        let arm = Pose { xyz: [a, 0.0, 0.0], rpy: [alpha, 0.0, 0.0] };
        let moving = format!("link_{number}");
        let mut moves = Joint::plain(&joint, line, motion, [last, &moving]);
        [moves.damping, moves.friction] = self.losses;
        moves.origin.rpy[2] = theta;
        match convention {
            Convention::Standard => {
                link(moving.clone(), None);
                let end = link(format!("frame_{number}"), Some(inertial));
                let name = format!("{joint} end");
                let mut rest = Joint::plain(&name, line, Motion::Fixed, [&moving, &end]);
                rest.origin = Pose { xyz: [a, 0.0, d], ..arm };
                robot.joints.extend([moves, rest]);
                end
            }
            Convention::Modified => {
                let base = link(format!("base_{number}"), None);
                link(moving.clone(), Some(inertial));
                let name = format!("{joint} base");
                let mut first = Joint::plain(&name, line, Motion::Fixed, [last, &base]);
                first.origin = arm;
                moves.parent = base;
                moves.origin.xyz[2] = d;
                robot.joints.extend([first, moves]);
                moving
            }
        }
    }
}

/// Returns the index of a column, and its unit in SI units.
fn column(head: &str) -> Result<(usize, f64), RobotError> {
    let (name, unit) = match head.split_once('[') {
        Some((name, unit)) => (name.trim(), Some(unit.trim_end_matches(']').trim())),
        None => (head, None),
    };
    let known = COLUMNS.iter().position(|(known, _)| *known == name.to_ascii_lowercase());
    let Some(index) = known else {
        let message = format!("there is no column `{}` in such a table", name.escape_debug());
        let names: Vec<&str> = COLUMNS.iter().map(|(name, _)| *name).collect();
        return Err(RobotError::new(1, message, format!("known are {}", names.join(", "))));
    };
    let factor = match (COLUMNS[index].1, unit) {
        (_, None) | (Unit::Length, Some("m")) | (Unit::Angle, Some("rad")) => 1.0,
        (Unit::Length, Some("mm")) => 1e-3,
        (Unit::Angle, Some("deg" | "\u{b0}")) => std::f64::consts::PI / 180.0,
        (Unit::Other(own), Some(unit)) if own == unit => 1.0,
        (_, Some(unit)) => {
            let message = format!("column `{name}` is in `{}`", unit.escape_debug());
            let help = "known are m and mm, rad and deg, kg and kg m^2";
            return Err(RobotError::new(1, message, help));
        }
    };
    Ok((index, factor))
}

fn number(line: usize, key: &str, text: &str) -> Result<f64, RobotError> {
    if text.is_empty() {
        return Ok(0.0);
    }
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value.abs() <= LARGEST => Ok(value),
        _ => {
            let message = format!("`{key}` is `{}`, not a number of a robot", text.escape_debug());
            let help = format!("numbers are finite and at most {LARGEST:e}");
            Err(RobotError::new(line, message, help))
        }
    }
}

fn wrong(error: &csv::Error) -> RobotError {
    let line = error.position().map_or(0, |at| at.line() as usize);
    RobotError::new(line, format!("not a table: {error}"), "")
}
