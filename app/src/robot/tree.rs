//! A robot as a tree of links and joints, with its checks.

use std::collections::{BTreeMap, BTreeSet};

use machinist_codegen::spec::ROUNDED_GYRATION;

use super::shapes::Shape;
use super::tendons::{Coupling, Tendon};

/// Maximum magnitude of a number, in SI units: products of eight of them are finite.
pub const LARGEST: f64 = f32::MAX as f64;

/// A mistake in a robot description.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RobotError {
    /// Line in the file, from 1; 0 if it concerns the whole file.
    pub line: usize,
    /// The mistake, in one sentence.
    pub message: String,
    /// A hint, which may be empty.
    pub help: String,
}

impl RobotError {
    /// Creates a mistake at a line.
    pub fn new(line: usize, message: impl Into<String>, help: impl Into<String>) -> Self {
        RobotError { line, message: message.into(), help: help.into() }
    }
}

/// A robot.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Robot {
    /// Its name.
    pub name: String,
    /// Links in the order of the file.
    pub links: Vec<Link>,
    /// Joints in the order of the file.
    pub joints: Vec<Joint>,
    /// Acceleration of free fall \[m/s^2\]; that of the earth along -z if absent.
    pub gravity: Option<[f64; 3]>,
    /// Parts of the file that take part in the motion, but not in the scene.
    pub left_out: Vec<String>,
    /// Joints that close loops of the others.
    pub closures: Vec<Closure>,
    /// Springs and losses along joints and between points.
    pub tendons: Vec<Tendon>,
    /// Equations between positions of joints and lengths of tendons.
    pub couplings: Vec<Coupling>,
    /// Joints that [`Robot::check`] made fixed, because nothing that they move has inertia.
    pub held: Vec<String>,
    /// Joints that move no inertia where all are at zero, in sentences.
    pub weak: Vec<String>,
    /// Axes of loops that [`Robot::align`] turned, and coordinates that count from elsewhere than in the
    /// file, in sentences.
    pub notes: Vec<String>,
}

/// A rigid link. Its frame is that of the joint that carries it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Link {
    /// Its name.
    pub name: String,
    /// Its line in the file.
    pub line: usize,
    /// Its inertia, if it has one.
    pub inertial: Option<Inertial>,
    /// Share of its weight that is compensated.
    pub compensation: f64,
    /// Shapes by which it is drawn.
    pub visuals: Vec<Visual>,
    /// Files of meshes by which it would be drawn.
    pub meshes: Vec<String>,
}

/// A shape of a drawing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Visual {
    /// Pose of its middle and axes in the link's frame.
    pub origin: Pose,
    /// The shape.
    pub shape: Shape,
}

/// Inertia of a link.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Inertial {
    /// Pose of the centre of mass and of the axes of `inertia` in the link's frame.
    pub origin: Pose,
    /// Mass \[kg\].
    pub mass: f64,
    /// xx, yy, zz, xy, xz, yz about the centre \[kg m^2\].
    pub inertia: [f64; 6],
}

impl Inertial {
    /// Returns true if mass and inertia are zero.
    pub fn is_zero(&self) -> bool {
        self.mass == 0.0 && self.inertia.iter().all(|entry| *entry == 0.0)
    }
}

/// Name of a base that does not move.
pub const WORLD: &str = "world";

/// Position and orientation.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Pose {
    /// Position \[m\].
    pub xyz: [f64; 3],
    /// Roll, pitch and yaw \[rad\].
    pub rpy: [f64; 3],
}

/// Motion that a joint allows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Motion {
    /// None.
    Fixed,
    /// Rotation about the axis, limited or not.
    Turns,
    /// Displacement along the axis.
    Slides,
    /// Any rotation.
    Rolls,
    /// All six motions.
    Floats,
}

/// A joint between two links.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Its name.
    pub name: String,
    /// Its line in the file.
    pub line: usize,
    /// The motion it allows.
    pub motion: Motion,
    /// The link that carries it.
    pub parent: String,
    /// The link that it carries.
    pub child: String,
    /// Pose of the child's frame in the parent's, before it moves.
    pub origin: Pose,
    /// Axis of the motion.
    pub axis: [f64; 3],
    /// Largest rounding of the direction of the axis, seen from the link that carries it \[rad\].
    pub rounding: f64,
    /// Viscous damping \[N m s/rad or N s/m\].
    pub damping: f64,
    /// Dry friction \[N m or N\].
    pub friction: f64,
    /// Stiffness of a spring \[N m/rad or N/m\], and the position at which it is unloaded.
    pub spring: [f64; 2],
    /// Inertia of the drive's rotor, as felt by the joint \[kg m^2 or kg\].
    pub armature: f64,
    /// Limits, which the scene mentions in a comment.
    pub limits: Option<Limits>,
    /// Another joint that it follows.
    pub mimic: Option<Mimic>,
}

/// Limits of a joint, in rad or m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Lower and upper limit of the position.
    pub position: [f64; 2],
    /// Limit of the speed.
    pub velocity: f64,
    /// Limit of the drive's force or torque.
    pub effort: f64,
}

/// A joint follows another: position = multiplier times the other's + offset.
#[derive(Debug, Clone, PartialEq)]
pub struct Mimic {
    /// The other joint.
    pub joint: String,
    /// Multiplier.
    pub multiplier: f64,
    /// Offset.
    pub offset: f64,
}

/// A joint that closes a loop, by constraints.
#[derive(Debug, Clone, PartialEq)]
pub struct Closure {
    /// The joint, without losses.
    pub joint: Joint,
    /// Pose of the joint, with z along its axis, in the frames of the links that carry it and that it
    /// carries.
    pub poses: [Pose; 2],
    /// True if the loop is planar: across z, or across x if the joint slides.
    pub is_planar: bool,
}

impl Closure {
    /// Returns the ends of the names of its constraints.
    pub fn constraints(&self) -> &'static [&'static str] {
        match (self.joint.motion, self.is_planar) {
            (Motion::Floats, _) => &[],
            (Motion::Turns | Motion::Rolls, true) => &["x", "y"],
            (Motion::Slides, true) => &["y", "tilt_y"],
            (Motion::Fixed, _) => &["x", "y", "z", "tilt_x", "tilt_y", "turn"],
            (Motion::Turns, false) => &["x", "y", "z", "tilt_x", "tilt_y"],
            (Motion::Slides, false) => &["x", "y", "tilt_x", "tilt_y", "turn"],
            (Motion::Rolls, false) => &["x", "y", "z"],
        }
    }
}

impl Motion {
    /// Returns the number of equations of a joint in space.
    pub fn constraints(self) -> usize {
        match self {
            Self::Fixed => 6,
            Self::Turns | Self::Slides => 5,
            Self::Rolls => 3,
            Self::Floats => 0,
        }
    }
}

impl Joint {
    /// Returns a joint without losses that carries a link.
    pub fn plain(name: &str, line: usize, motion: Motion, [parent, child]: [&str; 2]) -> Self {
        Joint {
            name: name.to_owned(),
            line,
            motion,
            parent: parent.to_owned(),
            child: child.to_owned(),
            origin: Pose::default(),
            axis: [0.0, 0.0, 1.0],
            rounding: 0.0,
            damping: 0.0,
            friction: 0.0,
            spring: [0.0; 2],
            armature: 0.0,
            limits: None,
            mimic: None,
        }
    }
}

impl Robot {
    /// Checks that links and joints form a tree, and holds joints that move nothing with inertia.
    ///
    /// # Errors
    /// The first mistake.
    pub fn check(&mut self) -> Result<(), RobotError> {
        self.check_tree()?;
        self.join_mimics()?;
        self.check_mimics()?;
        self.check_inertias()?;
        self.hold_without_inertia()?;
        self.check_motions()
    }

    fn check_tree(&self) -> Result<(), RobotError> {
        unique("link", self.links.iter().map(|link| (&link.name, link.line)))?;
        unique("joint", self.joints.iter().map(|joint| (&joint.name, joint.line)))?;
        let links: BTreeSet<&str> = self.links.iter().map(|link| link.name.as_str()).collect();
        let mut carriers: BTreeMap<&str, &Joint> = BTreeMap::new();
        for joint in &self.joints {
            for link in [&joint.parent, &joint.child] {
                if !links.contains(link.as_str()) {
                    let message =
                        format!("joint `{}` refers to link `{link}`, which is missing", joint.name);
                    return Err(RobotError::new(joint.line, message, ""));
                }
            }
            if let Some(other) = carriers.insert(&joint.child, joint) {
                let (child, a, b) = (&joint.child, &other.name, &joint.name);
                let message = format!("link `{child}` is carried by two joints, `{a}` and `{b}`");
                let help = "URDF describes trees; close a loop by constraints in the scene";
                return Err(RobotError::new(joint.line, message, help));
            }
        }
        let mut roots = self.links.iter().filter(|link| !carriers.contains_key(&*link.name));
        let Some(root) = roots.next() else {
            let message = "every link is carried by another: the joints form a loop";
            return Err(RobotError::new(0, message, "one link has to be the base"));
        };
        if let Some(other) = roots.next() {
            let message = format!("there are two bases, `{}` and `{}`", root.name, other.name);
            return Err(RobotError::new(other.line, message, "connect them by a joint"));
        }
        let order = self.order(root);
        if order.len() < self.links.len() {
            let is_reached = |link: &&Link| !order.iter().any(|known| known.name == link.name);
            let first = self.links.iter().find(is_reached);
            let (name, line) = first.map_or(("", 0), |link| (&*link.name, link.line));
            let message = format!("link `{name}` is not connected to the base: it is in a loop");
            return Err(RobotError::new(line, message, ""));
        }
        Ok(())
    }

    /// Returns the links, each after the one that carries it.
    pub fn order<'a>(&'a self, root: &'a Link) -> Vec<&'a Link> {
        let mut children: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for joint in &self.joints {
            children.entry(&joint.parent).or_default().push(&joint.child);
        }
        let by_name: BTreeMap<&str, &Link> =
            self.links.iter().map(|link| (&*link.name, link)).collect();
        let mut order = vec![root];
        let mut at = 0;
        while at < order.len() {
            let below = children.get(&*order[at].name).into_iter().flatten();
            order.extend(below.filter_map(|name| by_name.get(name)));
            at += 1;
        }
        order
    }

    /// Returns the link that no joint carries.
    pub fn root(&self) -> Option<&Link> {
        self.links.iter().find(|link| self.carrier(link).is_none())
    }

    /// Reports whether a link is a base that does not move.
    pub fn is_world(&self, link: &Link) -> bool {
        link.name == WORLD && self.carrier(link).is_none()
    }

    /// Lets the base move freely.
    ///
    /// # Errors
    /// If the robot stands in a world of its own.
    pub fn release(&mut self) -> Result<(), RobotError> {
        let base = self.root().map(|root| root.name.clone()).unwrap_or_default();
        if self.links.iter().any(|link| link.name == WORLD) {
            let message = "the robot has a link `world`, to which its base is connected";
            return Err(RobotError::new(0, message, "make that joint floating instead"));
        }
        self.links.insert(0, Link { name: WORLD.to_owned(), ..Link::default() });
        let ends = [WORLD, &*base];
        self.joints.push(Joint::plain("base", 0, Motion::Floats, ends));
        self.check()
    }

    /// Returns the joint that carries a link.
    pub fn carrier(&self, link: &Link) -> Option<&Joint> {
        self.joints.iter().find(|joint| joint.child == link.name)
    }

    /// Returns the joint of a name.
    pub fn joint(&self, name: &str) -> Option<&Joint> {
        self.joints.iter().find(|joint| joint.name == name)
    }

    /// Lets joints that follow followers follow their leaders.
    fn join_mimics(&mut self) -> Result<(), RobotError> {
        for at in 0..self.joints.len() {
            for _ in 0..self.joints.len() {
                let Some(mimic) = &self.joints[at].mimic else { break };
                let other = self.joint(&mimic.joint).and_then(|leader| leader.mimic.clone());
                let Some(other) = other else { break };
                let Joint { name, line, .. } = &self.joints[at];
                if other.joint == *name {
                    let message = format!("joint `{name}` follows itself");
                    let help = "name a joint that moves by itself";
                    return Err(RobotError::new(*line, message, help));
                }
                let multiplier = mimic.multiplier * other.multiplier;
                let offset = mimic.multiplier * other.offset + mimic.offset;
                self.joints[at].mimic = Some(Mimic { multiplier, offset, ..other });
            }
        }
        Ok(())
    }

    fn check_mimics(&self) -> Result<(), RobotError> {
        for joint in &self.joints {
            let Some(mimic) = &joint.mimic else { continue };
            let refuse = |why: &str| {
                let message = format!("joint `{}` follows `{}`, {why}", joint.name, mimic.joint);
                Err(RobotError::new(joint.line, message, "name a joint that moves by itself"))
            };
            match self.joint(&mimic.joint) {
                None => return refuse("which is missing"),
                Some(other) if !matches!(other.motion, Motion::Turns | Motion::Slides) => {
                    return refuse("which has no single coordinate");
                }
                Some(_) => {}
            }
        }
        Ok(())
    }

    fn check_inertias(&self) -> Result<(), RobotError> {
        for link in &self.links {
            let Some(Inertial { mass, inertia, .. }) = link.inertial else { continue };
            let name = link.name.escape_debug();
            if mass < 0.0 {
                let message = format!("the mass {mass} kg of link `{name}` must not be negative");
                return Err(RobotError::new(link.line, message, ""));
            }
            let is_negative = |moment: &&f64| **moment < -mass * ROUNDED_GYRATION.powi(2);
            if let Some(moment) = inertia[..3].iter().find(is_negative) {
                let message =
                    format!("the moment of inertia {moment} kg m^2 of link `{name}` is below 0");
                let help = "it is about the centre of mass, in kg m^2";
                return Err(RobotError::new(link.line, message, help));
            }
        }
        Ok(())
    }

    /// Fixes joints that move nothing with inertia, neither by themselves nor by joints that follow
    /// them: no equation would determine their motion.
    fn hold_without_inertia(&mut self) -> Result<(), RobotError> {
        // Constraints determine the motion of links that close loops.
        let closures = self.closures.iter().map(|closure| &closure.joint);
        let ends = closures.flat_map(|joint| [&*joint.parent, &*joint.child]);
        let mut with_inertia: BTreeSet<&str> = ends.collect();
        let order = self.root().map(|root| self.order(root)).unwrap_or_default();
        for link in order.iter().rev() {
            let own = link.inertial.as_ref().is_some_and(|inertial| !inertial.is_zero());
            let Some(joint) = self.carrier(link) else { continue };
            if own || with_inertia.contains(&*link.name) {
                with_inertia.extend([&*link.name, &*joint.parent]);
            }
        }
        let moves = |joint: &&Joint| joint.motion != Motion::Fixed;
        let leader = |joint: &Joint| joint.mimic.as_ref().map(|mimic| mimic.joint.clone());
        let carries = |joint: &&Joint| with_inertia.contains(&*joint.child);
        let moving = self.joints.iter().filter(moves).filter(carries);
        let led = moving.clone().filter_map(leader);
        let driven: BTreeSet<String> = moving.map(|joint| joint.name.clone()).chain(led).collect();
        let is_held = |joint: &Joint| {
            let leads = leader(joint).is_some_and(|leader| driven.contains(&leader));
            joint.motion != Motion::Fixed && !leads && !driven.contains(&joint.name)
        };
        let held: Vec<usize> =
            (0..self.joints.len()).filter(|at| is_held(&self.joints[*at])).collect();
        if driven.is_empty()
            && let Some(at) = held.first()
        {
            let Joint { name, child, line, .. } = &self.joints[*at];
            let message = format!(
                "joint `{name}` moves link `{child}`, but neither it nor what it carries has inertia"
            );
            let help = "add <inertial> to the link: nothing else of the robot moves";
            return Err(RobotError::new(*line, message, help));
        }
        for at in held {
            let joint = &mut self.joints[at];
            (joint.motion, joint.mimic) = (Motion::Fixed, None);
            self.held.push(joint.name.clone());
        }
        Ok(())
    }
}

fn unique<'a>(
    kind: &str,
    names: impl Iterator<Item = (&'a String, usize)>,
) -> Result<(), RobotError> {
    let mut known = BTreeSet::new();
    for (name, line) in names {
        if !known.insert(name) {
            let message = format!("two {kind}s are called `{}`", name.escape_debug());
            return Err(RobotError::new(line, message, ""));
        }
    }
    Ok(())
}
