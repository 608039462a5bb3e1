//! Reading of SDF, the format of Gazebo.
//!
//! Links, joints, inertias, damping, friction, springs, limits and shapes of drawings map to a scene.
//! Collisions, sensors and plugins are named as left out.

mod frames;
mod joints;

use roxmltree::{Document, Node};

use super::shapes::{Shape, pose};
use super::tree::{Inertial, Link, Robot, RobotError, Visual, WORLD};
use super::xml::{Read, Reader, child};
use frames::Frames;
use joints::closing;

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
const UNKNOWN: [&str; 1] = ["include"];

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
    let mut frames = Frames::new(&reader, model)?;
    for node in elements(model, "link") {
        robot.links.push(reader.sdf_link(node, &frames)?);
    }
    if robot.links.is_empty() {
        return Err(reader.error(model, "the model has no links", ""));
    }
    let mut ends = Vec::new();
    for node in elements(model, "joint") {
        ends.extend(reader.ends(node, &mut frames, &mut robot)?);
    }
    let closing = closing(&ends);
    for (at, ends) in ends.iter().enumerate() {
        if closing.contains(&at) {
            reader.closure(ends, &frames, &mut robot)?;
        } else {
            reader.sdf_joint(ends, &frames, &mut robot)?;
        }
    }
    for node in elements(model, "joint").filter(|node| node.attribute("type") == Some("gearbox")) {
        reader.gear(node, &frames, &mut robot)?;
    }
    finish(&mut robot, &frames)?;
    Ok(robot)
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
