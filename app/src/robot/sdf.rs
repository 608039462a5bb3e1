//! Reading of SDF, the format of Gazebo.
//!
//! Links, joints, inertias, damping, friction, springs, limits and shapes of drawings map to a scene.
//! Collisions, sensors and plugins are named as left out.

mod frames;

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::iter;

use nalgebra::{UnitQuaternion, Vector3};
use roxmltree::{Document, Node};

use super::shapes::{Shape, pose, turn_of_z};
use super::tree::{
    Closure, Inertial, Joint, Limits, Link, Mimic, Motion, Robot, RobotError, Visual, WORLD,
};
use super::xml::{Read, Reader, child};
use frames::{Frames, MODEL};

/// Elements that take part in the motion or describe the robot elsewhere.
const LEFT_OUT: [&str; 9] = [
    "battery",
    "collision",
    "enable_wind",
    "fluid_added_mass",
    "gripper",
    "physics",
    "plugin",
    "sensor",
    "velocity_decay",
];
/// Elements without which the motion would be another.
const UNKNOWN: [&str; 3] = ["include", "axis2", "thread_pitch"];
/// Limits beyond this are none \[rad or m\]: the format writes 1e16.
const UNLIMITED: f64 = 1e12;

/// Reads a robot description, and checks it.
///
/// # Errors
/// The first mistake, with its line.
pub fn read(document: &Document<'_>) -> Result<Robot, RobotError> {
    let root = document.root_element();
    let reader = Reader { document };
    let world = child(root, "world");
    let models: Vec<_> = elements(world.unwrap_or(root), "model").collect();
    let [model] = models[..] else {
        let message = format!("the file has {} models, not one", models.len());
        return Err(reader.error(world.unwrap_or(root), message, ""));
    };
    let unknown = |node: &Node<'_, '_>| UNKNOWN.contains(&node.tag_name().name());
    let inner = model.descendants().skip(1);
    let unread = inner.clone().find(|node| unknown(node) || node.has_tag_name("model"));
    if let Some(node) = unread {
        let message = format!("<{}> within a model is not read", node.tag_name().name());
        return Err(reader.error(node, message, "write its links and joints instead"));
    }
    if is_true(child(model, "static")) {
        return Err(reader.error(model, "the model is static: nothing of it moves", ""));
    }
    let mut robot = Robot { name: reader.name(model)?, ..Robot::default() };
    if let Some(gravity) = world.and_then(|world| child(world, "gravity")) {
        robot.gravity = Some(reader.listed(gravity)?);
    }
    let present = |tag: &&str| inner.clone().any(|node| node.has_tag_name(*tag));
    robot.left_out.extend(LEFT_OUT.into_iter().filter(present).map(|tag| format!("<{tag}>")));
    let frames = Frames::new(&reader, model)?;
    for node in elements(model, "link") {
        robot.links.push(reader.sdf_link(node, &frames)?);
    }
    if robot.links.is_empty() {
        return Err(reader.error(model, "the model has no links", ""));
    }
    let ends = elements(model, "joint").map(|node| reader.ends(node));
    let ends = ends.collect::<Read<Vec<_>>>()?;
    let closing = closing(&ends);
    for (at, ends) in ends.iter().enumerate() {
        if closing.contains(&at) {
            reader.closure(ends, &frames, &mut robot)?;
        } else {
            reader.sdf_joint(ends, &frames, &mut robot)?;
        }
    }
    finish(&mut robot, &frames)?;
    Ok(robot)
}

/// A joint, and the links that it joins.
struct Ends<'a, 'input> {
    node: Node<'a, 'input>,
    name: String,
    motion: Motion,
    parent: String,
    carried: String,
}

/// Returns the joints that close loops, those with few constraints if possible.
fn closing(joints: &[Ends<'_, '_>]) -> BTreeSet<usize> {
    let mut order: Vec<usize> = (0..joints.len()).collect();
    order.sort_by_key(|at| Reverse(joints[*at].motion.constraints()));
    let mut carriers: BTreeMap<&str, &str> = BTreeMap::new();
    let mut closing = BTreeSet::new();
    for at in order {
        let Ends { parent, carried, .. } = &joints[at];
        let mut above = iter::successors(Some(parent.as_str()), |link| carriers.get(link).copied());
        if carriers.contains_key(carried.as_str()) || above.any(|link| link == carried) {
            closing.insert(at);
        } else {
            carriers.insert(carried, parent);
        }
    }
    closing
}

/// Joins the model to the world: at its joints to the world, or by a joint that moves freely.
fn finish(robot: &mut Robot, frames: &Frames<'_, '_>) -> Read<()> {
    if robot.joints.iter().any(|joint| joint.parent == WORLD) {
        robot.links.insert(0, Link { name: WORLD.to_owned(), ..Link::default() });
        return robot.check();
    }
    robot.check()?;
    let base = robot.root().map(|root| root.name.clone()).unwrap_or_default();
    robot.release()?;
    if let Some(joint) = robot.joints.last_mut() {
        joint.origin = pose(&frames.in_world(&base)?);
    }
    Ok(())
}

impl Reader<'_, '_> {
    /// Reads N numbers of the text of an element.
    fn listed<const N: usize>(&self, node: Node<'_, '_>) -> Read<[f64; N]> {
        let tag = node.tag_name().name();
        let parts = node.text().unwrap_or_default().split_whitespace();
        let values = parts.map(|part| self.number_in(node, tag, part)).collect::<Read<Vec<_>>>()?;
        let count = values.len();
        values
            .try_into()
            .map_err(|_| self.error(node, format!("<{tag}> has {N} numbers, not {count}"), ""))
    }

    /// Reads the number of an element within another, or a default.
    fn within(&self, node: Option<Node<'_, '_>>, tag: &str, default: f64) -> Read<f64> {
        let Some(found) = node.and_then(|node| child(node, tag)) else { return Ok(default) };
        let [value] = self.listed(found)?;
        Ok(value)
    }

    fn part<'a, 'i>(&self, node: Node<'a, 'i>, tag: &str) -> Read<Node<'a, 'i>> {
        let of = node.tag_name().name();
        child(node, tag).ok_or_else(|| self.error(node, format!("<{of}> lacks <{tag}>"), ""))
    }

    fn sdf_link(&self, node: Node<'_, '_>, frames: &Frames<'_, '_>) -> Read<Link> {
        let name = self.name(node)?;
        if child(node, "gravity").is_some_and(|gravity| !is_true(Some(gravity))) {
            let message = format!("link `{}` has no weight", name.escape_debug());
            return Err(self.error(node, message, "links without gravity are not read"));
        }
        let Some(inertial) = child(node, "inertial") else {
            let message = format!("link `{}` has no <inertial>", name.escape_debug());
            let help = "write it: the format's default of 1 kg and 1 kg m^2 is rarely meant";
            return Err(self.error(node, message, help));
        };
        let inertial = Some(self.sdf_inertial(inertial, frames)?);
        let mut link = Link { name, line: self.line(node), inertial, ..Link::default() };
        for visual in elements(node, "visual") {
            let Some(geometry) = child(visual, "geometry") else { continue };
            let origin = pose(&frames.placed(visual)?);
            let shape = self.sdf_shape(geometry)?;
            link.visuals.extend(shape.map(|shape| Visual { origin, shape }));
            if let Some(mesh) = child(geometry, "mesh") {
                let uri = self.part(mesh, "uri")?;
                link.meshes.push(uri.text().unwrap_or_default().trim().to_owned());
            }
        }
        Ok(link)
    }

    fn sdf_inertial(&self, node: Node<'_, '_>, frames: &Frames<'_, '_>) -> Read<Inertial> {
        if node.attribute("auto").is_some_and(|auto| auto != "false") {
            return Err(self.error(node, "inertias of collisions are not read", "write them"));
        }
        let [mass] = self.listed(self.part(node, "mass")?)?;
        let tensor = self.part(node, "inertia")?;
        let mut inertia = [0.0; 6];
        for (entry, key) in inertia.iter_mut().zip(["ixx", "iyy", "izz"]) {
            [*entry] = self.listed(self.part(tensor, key)?)?;
        }
        for (entry, key) in inertia[3..].iter_mut().zip(["ixy", "ixz", "iyz"]) {
            *entry = self.within(Some(tensor), key, 0.0)?;
        }
        Ok(Inertial { origin: pose(&frames.placed(node)?), mass, inertia })
    }

    /// Reads the shape of a drawing; `None` for a mesh and others.
    fn sdf_shape(&self, geometry: Node<'_, '_>) -> Read<Option<Shape>> {
        let Some(node) = geometry.children().find(Node::is_element) else { return Ok(None) };
        let number = |tag: &str| {
            let [value] = self.listed(self.part(node, tag)?)?;
            Ok::<f64, RobotError>(value)
        };
        let shape = match node.tag_name().name() {
            "box" => {
                let edges: [f64; 3] = self.listed(self.part(node, "size")?)?;
                Shape::Box(edges.map(|edge| edge / 2.0))
            }
            "cylinder" => Shape::Cylinder(number("radius")?, number("length")? / 2.0),
            "capsule" => Shape::Capsule(number("radius")?, number("length")? / 2.0),
            "sphere" => Shape::Sphere(number("radius")?),
            _ => return Ok(None),
        };
        if !shape.is_solid() {
            return Err(self.error(node, "a dimension of this shape is not positive", ""));
        }
        Ok(Some(shape))
    }

    fn ends<'a, 'i>(&self, node: Node<'a, 'i>) -> Read<Ends<'a, 'i>> {
        let name = self.name(node)?;
        let motion = match self.attribute(node, "type")? {
            "fixed" => Motion::Fixed,
            "revolute" | "continuous" => Motion::Turns,
            "prismatic" => Motion::Slides,
            "ball" => Motion::Rolls,
            other => {
                let message = format!("joint `{name}` is of type `{}`", other.escape_debug());
                let help = "known are fixed, revolute, continuous, prismatic and ball";
                return Err(self.error(node, message, help));
            }
        };
        let end = |tag: &str| Ok(text_of(self.part(node, tag)?));
        Ok(Ends { parent: end("parent")?, carried: end("child")?, node, name, motion })
    }

    /// Reads a joint that closes a loop.
    fn closure(&self, ends: &Ends<'_, '_>, frames: &Frames<'_, '_>, robot: &mut Robot) -> Read<()> {
        let Ends { node, name, motion, parent, carried } = ends;
        let mut joint = Joint::plain(name, self.line(*node), *motion, [parent, carried]);
        let mut along = UnitQuaternion::identity();
        if matches!(motion, Motion::Turns | Motion::Slides) {
            self.along(self.part(*node, "axis")?, frames, &mut joint)?;
            along = turn_of_z(&Vector3::from(joint.axis));
        }
        if joint.mimic.is_some() {
            let message = format!("joint `{name}` follows another and closes a loop");
            return Err(self.error(*node, message, "follow by a joint that closes none"));
        }
        if joint.damping > 0.0 || joint.friction > 0.0 || joint.spring[0] > 0.0 {
            robot.left_out.push(format!("what acts in joint `{name}`, which closes a loop,"));
        }
        let rounding = [parent, carried].map(|link| frames.rounding(link, name));
        joint.rounding += rounding.iter().sum::<f64>();
        let poses = [parent, carried].map(|link| frames.between(link, name));
        let [at_parent, at_child] = poses;
        let poses = [at_parent? * along, at_child? * along].map(|at| pose(&at));
        robot.closures.push(Closure { joint, poses, is_planar: false });
        Ok(())
    }

    /// Reads a joint. If its frame is not that of the link that it carries, a link of its own is
    /// between the two.
    fn sdf_joint(
        &self,
        ends: &Ends<'_, '_>,
        frames: &Frames<'_, '_>,
        robot: &mut Robot,
    ) -> Read<()> {
        let Ends { node, name, motion, parent, carried } = ends;
        let is_there = frames.is_at(name, carried);
        let moved = if is_there { carried.clone() } else { format!("{carried} at {name}") };
        let line = self.line(*node);
        let mut joint = Joint::plain(name, line, *motion, [parent, &moved]);
        joint.origin = pose(&frames.between(parent, name)?);
        joint.rounding = frames.rounding(parent, name);
        if matches!(motion, Motion::Turns | Motion::Slides) {
            let axis = self.part(*node, "axis")?;
            self.along(axis, frames, &mut joint)?;
        }
        robot.joints.push(joint);
        if !is_there {
            robot.links.push(Link { name: moved.clone(), line, ..Link::default() });
            let mut fixed = Joint::plain(
                &format!("{name} to {carried}"),
                line,
                Motion::Fixed,
                [&moved, carried],
            );
            fixed.origin = pose(&frames.between(name, carried)?);
            fixed.rounding = frames.rounding(name, carried);
            robot.joints.push(fixed);
        }
        Ok(())
    }

    /// Reads the axis of a joint: its direction, limits, losses and the joint that it follows.
    fn along(&self, node: Node<'_, '_>, frames: &Frames<'_, '_>, joint: &mut Joint) -> Read<()> {
        // Versions before 1.7 say so where later ones have an attribute.
        let of_model = is_true(child(node, "use_parent_model_frame")).then_some(MODEL);
        let way = self.part(node, "xyz")?;
        let axis: [f64; 3] = self.listed(way)?;
        if axis.iter().all(|entry| *entry == 0.0) {
            return Err(self.error(way, format!("the axis of joint `{}` is zero", joint.name), ""));
        }
        joint.rounding += frames.rounding_of_axis(way, Vector3::from(axis));
        joint.axis = match of_model.or_else(|| way.attribute("expressed_in")) {
            None | Some("") => axis,
            Some(frame) => {
                joint.rounding += frames.rounding(&joint.name, frame);
                let turn = frames.between(&joint.name, frame)?.rotation;
                (turn * Vector3::from(axis)).into()
            }
        };
        let dynamics = child(node, "dynamics");
        joint.damping = self.within(dynamics, "damping", 0.0)?;
        joint.friction = self.within(dynamics, "friction", 0.0)?;
        joint.spring = [
            self.within(dynamics, "spring_stiffness", 0.0)?,
            self.within(dynamics, "spring_reference", 0.0)?,
        ];
        if joint.damping < 0.0 || joint.friction < 0.0 || joint.spring[0] < 0.0 {
            let message = "damping, friction and stiffness must not be negative";
            return Err(self.error(dynamics.unwrap_or(node), message, ""));
        }
        joint.limits = self.sdf_limits(child(node, "limit"))?;
        if let Some(mimic) = child(node, "mimic") {
            let multiplier = self.within(Some(mimic), "multiplier", 1.0)?;
            let reference = self.within(Some(mimic), "reference", 0.0)?;
            let offset = self.within(Some(mimic), "offset", 0.0)? - multiplier * reference;
            let leader = self.attribute(mimic, "joint")?.trim().to_owned();
            joint.mimic = Some(Mimic { joint: leader, multiplier, offset });
        }
        Ok(())
    }

    /// Reads limits, which scenes only mention: `None` without a limit of the position.
    fn sdf_limits(&self, node: Option<Node<'_, '_>>) -> Read<Option<Limits>> {
        let Some(node) = node else { return Ok(None) };
        let of = |tag: &str| {
            let Some(node) = child(node, tag) else { return Ok(None) };
            let text = text_of(node);
            match text.parse::<f64>() {
                Ok(value) if value.abs() >= UNLIMITED => Ok(None),
                _ => self.number_in(node, tag, &text).map(Some),
            }
        };
        let (lower, upper) = (of("lower")?, of("upper")?);
        let [velocity, effort] = [of("velocity")?, of("effort")?].map(|limit| limit.unwrap_or(0.0));
        let limits = |(lower, upper)| Limits { position: [lower, upper], velocity, effort };
        Ok(lower.zip(upper).map(limits))
    }
}

fn is_true(node: Option<Node<'_, '_>>) -> bool {
    node.is_some_and(|node| ["true", "1"].contains(&text_of(node).as_str()))
}

fn text_of(node: Node<'_, '_>) -> String {
    node.text().unwrap_or_default().trim().to_owned()
}

fn elements<'a, 'input>(
    node: Node<'a, 'input>,
    tag: &'static str,
) -> impl Iterator<Item = Node<'a, 'input>> {
    node.children().filter(move |node| node.is_element() && node.has_tag_name(tag))
}
