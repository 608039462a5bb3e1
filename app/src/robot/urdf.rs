//! Reading of URDF.

use nalgebra::Vector3;
use roxmltree::{Document, Node};

use super::shapes::{Shape, turn_of_z};
use super::tree::{Inertial, Joint, Limits, Link, Mimic, Motion, Pose, Robot, RobotError, Visual};
use super::xml::{Read, Reader, child};

/// Reads a robot description, and checks it.
///
/// # Errors
/// The first mistake, with its line.
pub fn read(document: &Document<'_>) -> Result<Robot, RobotError> {
    let root = document.root_element();
    let reader = Reader { document };
    if root.tag_name().name() != "robot" {
        let found = root.tag_name().name().escape_debug().to_string();
        let message = format!(
            "this is no robot description: the root is <{found}>, not <robot>, <mujoco> or <sdf>"
        );
        return Err(reader.error(root, message, ""));
    }
    let mut robot = Robot { name: reader.name(root)?, ..Robot::default() };
    for node in root.children().filter(Node::is_element) {
        match node.tag_name().name() {
            "link" => robot.links.push(reader.link(node)?),
            "joint" if node.attribute("type") == Some("planar") => {
                reader.planar(node, &mut robot)?;
            }
            "joint" => robot.joints.push(reader.joint(node)?),
            _ => {}
        }
    }
    if robot.links.is_empty() {
        return Err(reader.error(root, "the robot has no links", ""));
    }
    robot.check()?;
    Ok(robot)
}

impl Reader<'_, '_> {
    fn pose(&self, of: Node<'_, '_>) -> Read<Pose> {
        let origin = child(of, "origin");
        Ok(Pose {
            xyz: self.vector(origin, "xyz", [0.0; 3])?,
            rpy: self.vector(origin, "rpy", [0.0; 3])?,
        })
    }

    fn link(&self, node: Node<'_, '_>) -> Read<Link> {
        let name = self.name(node)?;
        let inertial =
            child(node, "inertial").map(|inertial| self.inertial(inertial)).transpose()?;
        let mut link = Link { name, line: self.line(node), inertial, ..Link::default() };
        for visual in node.children().filter(|node| node.has_tag_name("visual")) {
            let Some(geometry) = child(visual, "geometry") else { continue };
            let origin = self.pose(visual)?;
            let shape = self.shape(geometry)?;
            link.visuals.extend(shape.map(|shape| Visual { origin, shape }));
            if let Some(mesh) = child(geometry, "mesh") {
                link.meshes.push(self.attribute(mesh, "filename")?.to_owned());
            }
        }
        Ok(link)
    }

    /// Reads the shape of a drawing; `None` for a mesh.
    fn shape(&self, geometry: Node<'_, '_>) -> Read<Option<Shape>> {
        let Some(node) = geometry.children().find(Node::is_element) else { return Ok(None) };
        let shape = match node.tag_name().name() {
            "box" => {
                self.attribute(node, "size")?;
                Shape::Box(self.vector(Some(node), "size", [0.0; 3])?.map(|edge| edge / 2.0))
            }
            "cylinder" => {
                let half = self.number(node, "length")? / 2.0;
                Shape::Cylinder(self.number(node, "radius")?, half)
            }
            "sphere" => Shape::Sphere(self.number(node, "radius")?),
            _ => return Ok(None),
        };
        if !shape.is_solid() {
            return Err(self.error(node, "a dimension of this shape is not positive", ""));
        }
        Ok(Some(shape))
    }

    fn inertial(&self, node: Node<'_, '_>) -> Read<Inertial> {
        let part = |tag: &str| {
            child(node, tag)
                .ok_or_else(|| self.error(node, format!("<inertial> lacks <{tag}>"), ""))
        };
        let mass = self.number(part("mass")?, "value")?;
        let tensor = part("inertia")?;
        let mut inertia = [0.0; 6];
        for (entry, key) in inertia.iter_mut().zip(["ixx", "iyy", "izz", "ixy", "ixz", "iyz"]) {
            *entry = self.number(tensor, key)?;
        }
        Ok(Inertial { origin: self.pose(node)?, mass, inertia })
    }

    fn joint(&self, node: Node<'_, '_>) -> Read<Joint> {
        let name = self.name(node)?;
        let motion = match self.attribute(node, "type")? {
            "fixed" => Motion::Fixed,
            "revolute" | "continuous" => Motion::Turns,
            "prismatic" | "planar" => Motion::Slides,
            "floating" => Motion::Floats,
            other => {
                let message = format!("joint `{name}` is of type `{}`", other.escape_debug());
                let help = "known are fixed, revolute, continuous, prismatic, planar and floating";
                return Err(self.error(node, message, help));
            }
        };
        let link = |tag: &str| {
            let link = child(node, tag)
                .ok_or_else(|| self.error(node, format!("joint `{name}` lacks <{tag}>"), ""))?;
            Ok::<_, RobotError>(self.attribute(link, "link")?.trim().to_owned())
        };
        let (parent, carried) = (link("parent")?, link("child")?);
        let axis = self.vector(child(node, "axis"), "xyz", [1.0, 0.0, 0.0])?;
        let moves = matches!(motion, Motion::Turns | Motion::Slides);
        if moves && axis.iter().all(|entry| *entry == 0.0) {
            return Err(self.error(node, format!("the axis of joint `{name}` is zero"), ""));
        }
        let dynamics = child(node, "dynamics");
        let [damping, friction] =
            [self.number_or(dynamics, "damping", 0.0)?, self.number_or(dynamics, "friction", 0.0)?];
        if damping < 0.0 || friction < 0.0 {
            let message = format!("damping and friction of joint `{name}` must not be negative");
            return Err(self.error(dynamics.unwrap_or(node), message, ""));
        }
        Ok(Joint {
            origin: self.pose(node)?,
            axis,
            damping,
            friction,
            limits: self.limits(node)?,
            mimic: child(node, "mimic").map(|mimic| self.mimic(mimic)).transpose()?,
            ..Joint::plain(&name, self.line(node), motion, [&parent, &carried])
        })
    }

    /// Reads a joint that moves in the plane across its axis: two that slide, with links between them, and
    /// one that turns.
    fn planar(&self, node: Node<'_, '_>, robot: &mut Robot) -> Read<()> {
        let whole = self.joint(node)?;
        let Joint { name, line, .. } = &whole;
        if whole.mimic.is_some() {
            let message = format!("joint `{name}` is planar and follows another");
            return Err(self.error(node, message, "only joints with one coordinate follow others"));
        }
        if whole.damping > 0.0 || whole.friction > 0.0 {
            robot.left_out.push(format!("what acts in joint `{name}`, which is planar,"));
        }
        let frame = turn_of_z(&Vector3::from(whole.axis));
        let [x, y] = [Vector3::x(), Vector3::y()].map(|way| (frame * way).into());
        let between = ["x", "y"].map(|way| format!("{name} {way}"));
        for link in &between {
            robot.links.push(Link { name: link.clone(), line: *line, ..Link::default() });
        }
        let [first, second] = &between;
        let one = |end: &str, motion, axis, links: [&str; 2]| Joint {
            axis,
            ..Joint::plain(&format!("{name} {end}"), *line, motion, links)
        };
        robot.joints.extend([
            Joint { origin: whole.origin, ..one("x", Motion::Slides, x, [&whole.parent, first]) },
            one("y", Motion::Slides, y, [first, second]),
            one("turn", Motion::Turns, whole.axis, [second, &whole.child]),
        ]);
        Ok(())
    }

    fn limits(&self, node: Node<'_, '_>) -> Read<Option<Limits>> {
        let Some(limit) = child(node, "limit") else { return Ok(None) };
        // They are only mentioned, and some files write huge ones where there are none.
        let of = |key: &str| match limit.attribute(key).map(|text| text.trim().parse::<f64>()) {
            Some(Ok(value)) if value.is_finite() => Ok(value),
            _ => self.number_or(Some(limit), key, 0.0),
        };
        let position = [of("lower")?, of("upper")?];
        Ok(Some(Limits { position, velocity: of("velocity")?, effort: of("effort")? }))
    }

    fn mimic(&self, node: Node<'_, '_>) -> Read<Mimic> {
        Ok(Mimic {
            joint: self.attribute(node, "joint")?.trim().to_owned(),
            multiplier: self.number_or(Some(node), "multiplier", 1.0)?,
            offset: self.number_or(Some(node), "offset", 0.0)?,
        })
    }
}
