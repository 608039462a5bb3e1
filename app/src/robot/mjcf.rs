//! Reading of MJCF, the format of MuJoCo.
//!
//! Bodies, joints, inertias, damping, friction, springs and rotors of drives map to a scene, equalities
//! to constraints and joints that follow others. Contact, actuators and tendons are named as left out.

use std::collections::BTreeMap;

use nalgebra::{Isometry3, Matrix3, Quaternion, Unit, UnitQuaternion, Vector3};
use roxmltree::{Document, Node};

use super::shapes::{Shape, isometry, pose, together, turn_of_z};
use super::tree::{
    Closure, Inertial, Joint, Limits, Link, Mimic, Motion, Pose, Robot, RobotError, WORLD,
};
use super::xml::{DEEPEST, Read, Reader, child};

/// Density of shapes without one \[kg/m^3\].
const DENSITY: f64 = 1000.0;
/// Elements that take part in the motion or describe the robot elsewhere.
const LEFT_OUT: [&str; 5] = ["actuator", "contact", "tendon", "deformable", "extension"];

/// Reads a robot description, and checks it.
///
/// # Errors
/// The first mistake, with its line.
pub fn read(document: &Document<'_>) -> Result<Robot, RobotError> {
    let root = document.root_element();
    let reader = Reader { document };
    let unknown = ["include", "replicate", "composite", "flexcomp", "frame", "attach"];
    let found = root.descendants().find(|node| unknown.contains(&node.tag_name().name()));
    if let Some(node) = found {
        let message = format!("<{}> is not read", node.tag_name().name());
        let help = "save the model as one file without it: mj_saveLastXML, or `compile` of MuJoCo";
        return Err(reader.error(node, message, help));
    }
    let Some(world) = child(root, "worldbody") else {
        return Err(reader.error(root, "the model has no <worldbody>", ""));
    };
    let mut model = Model::new(reader, root)?;
    model.bodies(world, WORLD, None, 0)?;
    for equality in elements(root).filter(|node| node.tag_name().name() == "equality") {
        for node in elements(equality).filter(|node| node.attribute("active") != Some("false")) {
            model.equality(node)?;
        }
    }
    let mut robot = model.robot;
    robot.name = root.attribute("model").unwrap_or("model").chars().take(200).collect();
    let present = |tag: &&str| child(root, tag).is_some_and(|node| node.has_children());
    robot.left_out.extend(LEFT_OUT.into_iter().filter(present).map(|tag| format!("<{tag}>")));
    if robot.links.len() == 1 {
        return Err(model.reader.error(world, "the model has no bodies", ""));
    }
    robot.check()?;
    Ok(robot)
}

struct Model<'a, 'input> {
    reader: Reader<'a, 'input>,
    /// Radians per unit of an angle.
    angle: f64,
    sequence: String,
    /// True if shapes give the inertia even beside <inertial>.
    always_from_shapes: bool,
    /// Attributes of elements by class and tag.
    defaults: BTreeMap<(String, String), BTreeMap<String, String>>,
    robot: Robot,
}

impl<'a, 'input> Model<'a, 'input> {
    fn new(reader: Reader<'a, 'input>, root: Node<'a, 'input>) -> Read<Self> {
        let compiler = child(root, "compiler");
        let of = |key: &str| compiler.and_then(|node| node.attribute(key)).unwrap_or_default();
        let world = Link { name: WORLD.to_owned(), ..Link::default() };
        let mut model = Model {
            reader,
            angle: if of("angle") == "radian" { 1.0 } else { std::f64::consts::PI / 180.0 },
            sequence: if of("eulerseq").is_empty() { "xyz" } else { of("eulerseq") }.to_owned(),
            always_from_shapes: of("inertiafromgeom") == "true",
            defaults: BTreeMap::new(),
            robot: Robot { links: vec![world], ..Robot::default() },
        };
        if let (Some(node), "global") = (compiler, of("coordinate")) {
            return Err(model.reader.error(node, "global coordinates are not read", ""));
        }
        if let Some(option) = child(root, "option") {
            model.robot.gravity = model.reader.exactly(option, "gravity")?;
        }
        if let Some(main) = child(root, "default") {
            model.classes(main, None, 0)?;
        }
        Ok(model)
    }

    /// Reads the attributes of a class, and of the classes within it.
    fn classes(&mut self, node: Node<'a, 'input>, outer: Option<&str>, depth: usize) -> Read<()> {
        if depth > DEEPEST {
            return Err(self.reader.error(node, "defaults are nested too deeply", ""));
        }
        let name = node.attribute("class").unwrap_or("main").to_owned();
        for tag in ["joint", "geom"] {
            let inherited = outer.and_then(|outer| self.default_of(outer, tag)).cloned();
            let mut all = inherited.unwrap_or_default();
            if let Some(own) = child(node, tag) {
                let own = own.attributes();
                all.extend(own.map(|one| (one.name().to_owned(), one.value().to_owned())));
            }
            self.defaults.insert((name.clone(), tag.to_owned()), all);
        }
        for inner in elements(node).filter(|node| node.tag_name().name() == "default") {
            self.classes(inner, Some(&name), depth + 1)?;
        }
        Ok(())
    }

    fn default_of(&self, class: &str, tag: &str) -> Option<&BTreeMap<String, String>> {
        self.defaults.get(&(class.to_owned(), tag.to_owned()))
    }

    /// Returns an attribute of an element, or that of its class.
    fn text(&self, node: Node<'a, 'input>, class: Option<&str>, key: &str) -> Option<String> {
        let class = node.attribute("class").or(class).unwrap_or("main");
        let own = node.attribute(key).map(str::to_owned);
        own.or_else(|| self.default_of(class, node.tag_name().name())?.get(key).cloned())
    }

    fn values(&self, node: Node<'a, 'input>, class: Option<&str>, key: &str) -> Read<Vec<f64>> {
        let text = self.text(node, class, key).unwrap_or_default();
        text.split_whitespace().map(|part| self.reader.number_in(node, key, part)).collect()
    }

    fn value(&self, node: Node<'a, 'input>, class: Option<&str>, key: &str) -> Read<f64> {
        // Newer files give coefficients of a polynomial, the first of which is the linear one.
        let values = self.values(node, class, key)?;
        if values.iter().skip(1).any(|value| *value != 0.0) {
            return Err(self.reader.error(node, format!("`{key}` is a polynomial"), ""));
        }
        Ok(values.first().copied().unwrap_or(0.0))
    }

    fn vector(
        &self,
        node: Node<'a, 'input>,
        class: Option<&str>,
        key: &str,
        default: [f64; 3],
    ) -> Read<[f64; 3]> {
        let values = self.values(node, class, key)?;
        if values.is_empty() {
            return Ok(default);
        }
        let count = values.len();
        values.try_into().map_err(|_| {
            self.reader.error(node, format!("`{key}` has three numbers, not {count}"), "")
        })
    }

    /// Reads position and orientation of an element.
    fn place(&self, node: Node<'a, 'input>, class: Option<&str>) -> Read<Isometry3<f64>> {
        let position = Vector3::from(self.vector(node, class, "pos", [0.0; 3])?);
        Ok(Isometry3::from_parts(position.into(), self.orientation(node, class)?))
    }

    fn orientation(
        &self,
        node: Node<'a, 'input>,
        class: Option<&str>,
    ) -> Read<UnitQuaternion<f64>> {
        let wrong = |key: &str| self.reader.error(node, format!("`{key}` is no orientation"), "");
        let unit = |values: &[f64], key: &str| {
            Unit::try_new(Vector3::new(values[0], values[1], values[2]), 0.0)
                .ok_or_else(|| wrong(key))
        };
        for key in ["quat", "axisangle", "euler", "xyaxes", "zaxis"] {
            let values = self.values(node, class, key)?;
            return Ok(match (key, values.len()) {
                (_, 0) => continue,
                ("quat", 4) if values.iter().any(|part| *part != 0.0) => {
                    let [w, x, y, z] = [values[0], values[1], values[2], values[3]];
                    UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z))
                }
                ("axisangle", 4) => {
                    UnitQuaternion::from_axis_angle(&unit(&values, key)?, values[3] * self.angle)
                }
                ("euler", 3) => self.euler(&values).ok_or_else(|| wrong("eulerseq"))?,
                ("xyaxes", 6) => {
                    let x = unit(&values, key)?;
                    let y = Vector3::new(values[3], values[4], values[5]);
                    let y = Unit::try_new(y - *x * x.dot(&y), 1e-12).ok_or_else(|| wrong(key))?;
                    let axes = Matrix3::from_columns(&[*x, *y, x.cross(&y)]);
                    UnitQuaternion::from_matrix(&axes)
                }
                ("zaxis", 3) => turn_of_z(&*unit(&values, key)?),
                _ => return Err(wrong(key)),
            });
        }
        Ok(UnitQuaternion::identity())
    }

    /// Returns rotations about axes that turn, or that do not if their letters are capitals.
    fn euler(&self, angles: &[f64]) -> Option<UnitQuaternion<f64>> {
        let mut whole = UnitQuaternion::identity();
        if self.sequence.len() != 3 {
            return None;
        }
        for (letter, angle) in self.sequence.chars().zip(angles) {
            let axis = match letter.to_ascii_lowercase() {
                'x' => Vector3::x_axis(),
                'y' => Vector3::y_axis(),
                'z' => Vector3::z_axis(),
                _ => return None,
            };
            let turn = UnitQuaternion::from_axis_angle(&axis, angle * self.angle);
            whole = if letter.is_ascii_lowercase() { whole * turn } else { turn * whole };
        }
        Some(whole)
    }

    /// Reads a connection of two bodies, or a joint that follows another.
    fn equality(&mut self, node: Node<'a, 'input>) -> Read<()> {
        let kind = node.tag_name().name();
        let is_between_sites = node.has_attribute("site1");
        match kind {
            "connect" if !is_between_sites => {
                let ends = self.ends(node)?;
                let [one, other] = &ends;
                let [x, y, z] = self.reader.exactly(node, "anchor")?.unwrap_or_default();
                let place = Isometry3::translation(x, y, z);
                let there = self.within(one, other) * place;
                self.connect(node, Motion::Rolls, &ends, [place, there]);
                Ok(())
            }
            "weld" if !is_between_sites => {
                let ends = self.ends(node)?;
                let [one, other] = &ends;
                let given = self.reader.exactly(node, "relpose")?.and_then(|relative| {
                    let [x, y, z, w, i, j, k] = relative;
                    let turn = UnitQuaternion::try_new(Quaternion::new(w, i, j, k), 0.0)?;
                    Some(Isometry3::from_parts(Vector3::new(x, y, z).into(), turn))
                });
                let place = given.unwrap_or_else(|| self.within(other, one));
                self.connect(node, Motion::Fixed, &ends, [place, Isometry3::identity()]);
                Ok(())
            }
            "joint" => self.follow(node),
            _ => {
                self.robot.left_out.push(format!("<{kind}> of <equality>"));
                Ok(())
            }
        }
    }

    /// Returns the bodies of an equality.
    fn ends(&self, node: Node<'a, 'input>) -> Read<[String; 2]> {
        let of = |key: &str| match node.attribute(key) {
            None => Ok(WORLD.to_owned()),
            Some(name) if self.robot.links.iter().any(|link| link.name == name) => {
                Ok(name.to_owned())
            }
            Some(name) => {
                let message = format!("the body `{}` is missing", name.escape_debug());
                Err(self.reader.error(node, message, ""))
            }
        };
        self.reader.attribute(node, "body1")?;
        Ok([of("body1")?, of("body2")?])
    }

    /// Connects two bodies at places in their frames.
    fn connect(
        &mut self,
        node: Node<'a, 'input>,
        motion: Motion,
        [one, other]: &[String; 2],
        places: [Isometry3<f64>; 2],
    ) {
        let name = node.attribute("name").map_or_else(|| self.free_name("loop"), str::to_owned);
        let joint = Joint::plain(&name, self.reader.line(node), motion, [one, other]);
        self.robot.closures.push(Closure { joint, poses: places.map(|at| pose(&at)) });
    }

    /// Returns the pose of a body in the frame of another, with all joints at zero.
    fn within(&self, body: &str, frame: &str) -> Isometry3<f64> {
        self.robot.at_zero(frame).inverse() * self.robot.at_zero(body)
    }

    /// Lets a joint follow another in proportion.
    fn follow(&mut self, node: Node<'a, 'input>) -> Read<()> {
        let name = self.reader.attribute(node, "joint1")?.to_owned();
        let coefficients = self.reader.numbers(node, "polycoef")?.unwrap_or(vec![0.0, 1.0]);
        let is_linear = coefficients.iter().skip(2).all(|one| *one == 0.0);
        let leader = node.attribute("joint2").filter(|_| is_linear);
        let Some(leader) = leader else {
            self.robot.left_out.push(format!("the equality of joint `{name}`"));
            return Ok(());
        };
        let at = |index: usize| coefficients.get(index).copied().unwrap_or(0.0);
        let mimic = Mimic { joint: leader.to_owned(), multiplier: at(1), offset: at(0) };
        let Some(joint) = self.robot.joints.iter_mut().find(|joint| joint.name == name) else {
            let message = format!("the joint `{}` is missing", name.escape_debug());
            return Err(self.reader.error(node, message, ""));
        };
        joint.mimic = Some(mimic);
        Ok(())
    }

    /// Reads the bodies within one.
    fn bodies(
        &mut self,
        node: Node<'a, 'input>,
        parent: &str,
        class: Option<&'a str>,
        depth: usize,
    ) -> Read<()> {
        if depth > DEEPEST {
            return Err(self.reader.error(node, "bodies are nested too deeply", ""));
        }
        for body in elements(node).filter(|node| node.tag_name().name() == "body") {
            let class = body.attribute("childclass").or(class);
            let name = self.body(body, parent, class)?;
            self.bodies(body, &name, class, depth + 1)?;
        }
        Ok(())
    }

    /// Reads a body, with a link of its own before it for each joint, and returns its name.
    fn body(
        &mut self,
        node: Node<'a, 'input>,
        parent: &str,
        class: Option<&'a str>,
    ) -> Read<String> {
        if node.has_attribute("mocap") {
            return Err(self.reader.error(node, "bodies of motion capture are not read", ""));
        }
        let line = self.reader.line(node);
        let name = node.attribute("name").map_or_else(|| self.free_name("body"), str::to_owned);
        let (mut last, mut at) = (parent.to_owned(), self.place(node, None)?);
        let is_joint =
            |node: &Node<'_, '_>| ["joint", "freejoint"].contains(&node.tag_name().name());
        for element in elements(node).filter(is_joint) {
            let joint = self.joint(element, class)?;
            let moved = self.free_name(&format!("{name}_{}", joint.name));
            let anchor = joint.origin;
            at *= isometry(&anchor);
            let joint = Joint { parent: last, child: moved.clone(), origin: pose(&at), ..joint };
            self.robot.joints.push(joint);
            self.robot.links.push(Link { name: moved.clone(), line, ..Link::default() });
            last = moved;
            at = isometry(&anchor).inverse();
        }
        let inertial = self.inertial(node, class)?;
        self.robot.links.push(Link { name: name.clone(), line, inertial, ..Link::default() });
        let fixed = format!("{name} fixed");
        let mut rest = Joint::plain(&fixed, line, Motion::Fixed, [&last, &name]);
        rest.origin = pose(&at);
        self.robot.joints.push(rest);
        Ok(name)
    }

    fn free_name(&self, wanted: &str) -> String {
        let is_taken = |name: &str| {
            self.robot.links.iter().any(|link| link.name == name)
                || self.robot.joints.iter().any(|joint| joint.name == name)
        };
        let more = (2..).map(|number| format!("{wanted}_{number}"));
        let mut all = std::iter::once(wanted.to_owned()).chain(more);
        all.find(|name| !is_taken(name)).unwrap_or_default()
    }

    /// Reads a joint, whose origin is its place in the body.
    fn joint(&self, node: Node<'a, 'input>, class: Option<&str>) -> Read<Joint> {
        let kind = match node.tag_name().name() {
            "freejoint" => "free".to_owned(),
            _ => self.text(node, class, "type").unwrap_or_else(|| "hinge".to_owned()),
        };
        let motion = match kind.as_str() {
            "hinge" => Motion::Turns,
            "slide" => Motion::Slides,
            "ball" => Motion::Rolls,
            "free" => Motion::Floats,
            other => {
                let message = format!("a joint is of type `{}`", other.escape_debug());
                let help = "known are hinge, slide, ball and free";
                return Err(self.reader.error(node, message, help));
            }
        };
        let name = node.attribute("name").map_or_else(|| self.free_name("joint"), str::to_owned);
        let value = |key: &str| self.value(node, class, key);
        let turns = motion == Motion::Turns;
        let angle = if turns { self.angle } else { 1.0 };
        if value("ref")? != 0.0 {
            let message = format!("joint `{}` has a `ref`", name.escape_debug());
            return Err(self.reader.error(node, message, "turn the body instead"));
        }
        let losses = [value("damping")?, value("frictionloss")?, value("stiffness")?];
        let is_plain = matches!(motion, Motion::Turns | Motion::Slides);
        if losses.iter().any(|value| *value < 0.0) {
            let message = "damping, friction and stiffness must not be negative";
            return Err(self.reader.error(node, message, ""));
        }
        if !is_plain && losses.iter().chain([&value("armature")?]).any(|value| *value != 0.0) {
            let message =
                format!("damping, friction, springs and rotors of {kind} joints are not read");
            return Err(self.reader.error(node, message, "remove them"));
        }
        let axis = self.vector(node, class, "axis", [0.0, 0.0, 1.0])?;
        if is_plain && axis.iter().all(|entry| *entry == 0.0) {
            return Err(self.reader.error(node, "the axis of this joint is zero", ""));
        }
        let limits = match self.values(node, class, "range")?[..] {
            [lower, upper] if is_plain => Some(Limits {
                position: [lower * angle, upper * angle],
                velocity: 0.0,
                effort: 0.0,
            }),
            _ => None,
        };
        let xyz = match motion {
            Motion::Floats => [0.0; 3],
            _ => self.vector(node, class, "pos", [0.0; 3])?,
        };
        Ok(Joint {
            origin: Pose { xyz, rpy: [0.0; 3] },
            axis,
            damping: losses[0],
            friction: losses[1],
            spring: [losses[2], value("springref")? * angle],
            armature: value("armature")?,
            limits,
            ..Joint::plain(&name, self.reader.line(node), motion, ["", ""])
        })
    }

    /// Reads the inertia of a body: that of <inertial>, or of its shapes.
    fn inertial(&self, node: Node<'a, 'input>, class: Option<&str>) -> Read<Option<Inertial>> {
        match child(node, "inertial").filter(|_| !self.always_from_shapes) {
            Some(given) => self.given(given).map(Some),
            None => self.of_shapes(node, class),
        }
    }

    fn given(&self, node: Node<'a, 'input>) -> Read<Inertial> {
        let mass = self.reader.number(node, "mass")?;
        let diagonal = self.reader.exactly::<3>(node, "diaginertia")?;
        let full = self.reader.exactly::<6>(node, "fullinertia")?;
        let inertia = match (diagonal, full) {
            (Some([xx, yy, zz]), None) => [xx, yy, zz, 0.0, 0.0, 0.0],
            (None, Some(full)) => full,
            _ => {
                let message = "<inertial> has either `diaginertia` or `fullinertia`";
                return Err(self.reader.error(node, message, ""));
            }
        };
        Ok(Inertial { origin: pose(&self.place(node, None)?), mass, inertia })
    }

    fn of_shapes(&self, node: Node<'a, 'input>, class: Option<&str>) -> Read<Option<Inertial>> {
        let mut parts = Vec::new();
        for geom in elements(node).filter(|node| node.tag_name().name() == "geom") {
            let mass = self.text(geom, class, "mass").map(|_| self.value(geom, class, "mass"));
            let mass = mass.transpose()?;
            if mass == Some(0.0) {
                continue;
            }
            let Some((shape, at)) = self.shape(geom, class)? else { continue };
            let density = match self.text(geom, class, "density") {
                Some(_) => self.value(geom, class, "density")?,
                None => DENSITY,
            };
            let mass = mass.unwrap_or(density * shape.volume());
            if mass < 0.0 {
                return Err(self.reader.error(geom, "the mass of this shape is negative", ""));
            }
            parts.push((mass, at, shape.inertia(mass)));
        }
        Ok(together(&parts))
    }

    /// Reads a shape and the place of its middle; `None` for one without mass.
    fn shape(
        &self,
        node: Node<'a, 'input>,
        class: Option<&str>,
    ) -> Read<Option<(Shape, Isometry3<f64>)>> {
        let kind = self.text(node, class, "type").unwrap_or_else(|| "sphere".to_owned());
        let size = self.values(node, class, "size")?;
        let mut at = self.place(node, class)?;
        let mut half = size.get(1).copied();
        let ends = self.values(node, class, "fromto")?;
        if let [x0, y0, z0, x1, y1, z1] = ends[..] {
            let (from, to) = (Vector3::new(x0, y0, z0), Vector3::new(x1, y1, z1));
            let way = to - from;
            at = Isometry3::from_parts(((from + to) / 2.0).into(), turn_of_z(&way));
            half = Some(way.norm() / 2.0);
        }
        let shape = match (kind.as_str(), size.first(), half, size.get(2)) {
            ("plane" | "hfield", ..) => return Ok(None),
            ("sphere", Some(r), ..) => Shape::Sphere(*r),
            ("capsule", Some(r), Some(h), _) => Shape::Capsule(*r, h),
            ("cylinder", Some(r), Some(h), _) => Shape::Cylinder(*r, h),
            ("box", Some(a), Some(b), Some(c)) if ends.is_empty() => Shape::Box([*a, b, *c]),
            ("ellipsoid", Some(a), Some(b), Some(c)) if ends.is_empty() => {
                Shape::Ellipsoid([*a, b, *c])
            }
            ("sphere" | "capsule" | "cylinder" | "box" | "ellipsoid", ..) => {
                let message = format!("the size of this {kind} is not complete");
                return Err(self.reader.error(node, message, ""));
            }
            (other, ..) => {
                let message = format!("the inertia of a {} is not known", other.escape_debug());
                let help = "give the body an <inertial>, or the shape mass=\"0\"";
                return Err(self.reader.error(node, message, help));
            }
        };
        Ok(Some((shape, at)))
    }
}

fn elements<'a, 'input: 'a>(
    node: Node<'a, 'input>,
) -> impl Iterator<Item = Node<'a, 'input>> + use<'a, 'input> {
    node.children().filter(Node::is_element)
}
