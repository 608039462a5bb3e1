//! Reading of MJCF, the format of MuJoCo.
//!
//! Bodies, joints, inertias, damping, friction, springs, rotors of drives and tendons map to a scene,
//! equalities to constraints and joints that follow others. Contact and actuators are named as left out.

mod compiler;
mod equality;
mod inertia;
mod places;
mod tendons;

use std::collections::BTreeMap;

use nalgebra::{Point3, Vector3};
use roxmltree::{Document, Node};

use super::digits::Digits;
use super::shapes::{isometry, pose};
use super::tendons::{Length, Site};
use super::tree::{Joint, Limits, Link, Motion, Pose, Robot, RobotError, WORLD};
use super::xml::{DEEPEST, Read, Reader, child};
use compiler::Compiler;
use places::{GEOMETRY, Part};

/// Elements that take part in the motion or describe the robot elsewhere.
const LEFT_OUT: [&str; 4] = ["actuator", "contact", "deformable", "extension"];

/// Attributes that refer to other elements, without numbers.
const REFERENCES: [&str; 4] = ["body", "joint", "site", "tendon"];

/// Maximum number of links.
const MOST_LINKS: usize = 100_000;

/// Reads a robot description, and checks it.
///
/// # Errors
/// The first mistake, with its line.
pub fn read(document: &Document<'_>) -> Result<Robot, RobotError> {
    let root = document.root_element();
    let reader = Reader { document };
    let unknown = ["composite", "flexcomp", "attach"];
    let found = root.descendants().find(|node| unknown.contains(&node.tag_name().name()));
    if let Some(node) = found {
        let message = format!("<{}> is not read", node.tag_name().name());
        let help = "save the model as one file without it: mj_saveLastXML, or `compile` of MuJoCo";
        return Err(reader.error(node, message, help));
    }
    let mut model = Model::new(reader, root)?;
    for world in sections(root, "worldbody") {
        model.bodies(&Part::of(world, None, String::new()), WORLD, 0)?;
    }
    for tendons in sections(root, "tendon") {
        for node in elements(tendons) {
            model.for_copies(node, Model::tendon)?;
        }
    }
    let is_open = ["equality", "constraint"].iter().any(|flag| model.is_off(flag));
    for equality in sections(root, "equality").filter(|_| !is_open) {
        for node in elements(equality) {
            if model.text(node, None, "active").is_none_or(|active| active != "false") {
                model.for_copies(node, Model::equality)?;
            }
        }
    }
    model.name_stops();
    let mut robot = model.robot;
    robot.scale_to(model.compiler.total_mass);
    let couplings = &robot.couplings;
    let is_coupled = |name: &str| {
        let named = |length: &Length| matches!(length, Length::Tendon(own) if own == name);
        couplings.iter().any(|one| named(&one.of) || one.by.as_ref().is_some_and(named))
    };
    robot.tendons.retain(|tendon| tendon.acts() || is_coupled(&tendon.name));
    robot.tune(&model.tuned);
    robot.name = root.attribute("model").unwrap_or("model").chars().take(200).collect();
    let present = |tag: &&str| sections(root, tag).any(|node| node.has_children());
    robot.left_out.extend(LEFT_OUT.into_iter().filter(present).map(|tag| format!("<{tag}>")));
    if robot.links.len() == 1 {
        return Err(model.reader.error(root, "the model has no bodies", ""));
    }
    robot.check()?;
    Ok(robot)
}

struct Model<'a, 'input> {
    reader: Reader<'a, 'input>,
    compiler: Compiler,
    /// Attributes of elements by class and tag.
    defaults: BTreeMap<(String, String), BTreeMap<String, String>>,
    /// Digits of positions and directions.
    digits: Digits,
    sites: BTreeMap<String, Site>,
    /// Ends of the names of copies, by the name in the file.
    copies: BTreeMap<String, Vec<String>>,
    /// End of the names of the copies to which references lead.
    ending: String,
    /// Positions of joints in the file with all at zero in the scene, unless they are zero too.
    references: BTreeMap<String, f64>,
    /// Time constants and damping ratios that determine springs and damping, by joint.
    tuned: Vec<(String, [f64; 2])>,
    /// True if shapes may touch.
    has_contact: bool,
    /// True if a joint has a range that it keeps, and if a tendon has one.
    has_ranges: [bool; 2],
    robot: Robot,
}

impl<'a, 'input> Model<'a, 'input> {
    fn new(reader: Reader<'a, 'input>, root: Node<'a, 'input>) -> Read<Self> {
        let world = Link { name: WORLD.to_owned(), ..Link::default() };
        let nodes = root.descendants();
        let geometry =
            nodes.flat_map(|node| GEOMETRY.iter().filter_map(move |key| node.attribute(*key)));
        let mut model = Model {
            compiler: Compiler::new(&reader, root)?,
            reader,
            defaults: BTreeMap::new(),
            digits: Digits::of(geometry),
            sites: BTreeMap::new(),
            copies: BTreeMap::new(),
            ending: String::new(),
            references: BTreeMap::new(),
            tuned: Vec::new(),
            has_contact: false,
            has_ranges: [false; 2],
            robot: Robot { links: vec![world], ..Robot::default() },
        };
        for option in sections(root, "option") {
            let gravity = model.reader.exactly(option, "gravity")?;
            model.robot.gravity = gravity.or(model.robot.gravity);
            let is_given = |key: &&str| option.has_attribute(*key);
            let medium = ["density", "viscosity", "wind"].into_iter().filter(is_given);
            model.robot.left_out.extend(medium.map(|key| format!("the {key} of the medium")));
        }
        if model.is_off("gravity") {
            model.robot.gravity = Some([0.0; 3]);
        }
        for main in sections(root, "default") {
            model.classes(main, None, 0)?;
        }
        Ok(model)
    }

    /// Reports whether a flag of the options is disabled.
    fn is_off(&self, flag: &str) -> bool {
        let root = self.reader.document.root_element();
        let mut flags = sections(root, "option").filter_map(|option| child(option, "flag"));
        flags.any(|node| node.attribute(flag) == Some("disable"))
    }

    /// Reads the attributes of a class, and of the classes within it.
    fn classes(&mut self, node: Node<'a, 'input>, outer: Option<&str>, depth: usize) -> Read<()> {
        if depth > DEEPEST {
            return Err(self.reader.error(node, "defaults are nested too deeply", ""));
        }
        let name = node.attribute("class").unwrap_or("main").to_owned();
        for tag in ["joint", "geom", "site", "tendon", "equality"] {
            // Sections of one class add up.
            let inherited = self.default_of(outer.unwrap_or(&name), tag).cloned();
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
        let section = node.parent().map_or("", |parent| parent.tag_name().name());
        let tag = match section {
            "tendon" | "equality" => section,
            _ => node.tag_name().name(),
        };
        own.or_else(|| self.default_of(class, tag)?.get(key).cloned())
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

    /// Reads the sites of a body, and the bodies within it.
    fn bodies(&mut self, within: &Part<'a, 'input>, parent: &str, depth: usize) -> Read<()> {
        if depth > DEEPEST || self.robot.links.len() > MOST_LINKS {
            return Err(self.reader.error(
                within.node,
                "bodies are nested too deeply, or too many",
                "",
            ));
        }
        for part in self.parts(within, "site")? {
            if !part.node.has_attribute("name") {
                continue;
            }
            let name = self.name(&part, "site");
            let at = part.frame * self.stretched(part.node, part.class)?.0;
            self.sites.insert(name.clone(), Site { name, link: parent.to_owned(), at });
        }
        for part in self.parts(within, "geom")? {
            let is_open =
                |key: &str| self.text(part.node, part.class, key).is_none_or(|bits| bits != "0");
            self.has_contact |= is_open("contype") || is_open("conaffinity");
        }
        for part in self.parts(within, "body")? {
            let name = self.body(&part, parent)?;
            self.bodies(&part, &name, depth + 1)?;
        }
        Ok(())
    }

    /// Names what would stop the motion as left out.
    fn name_stops(&mut self) {
        for (is_present, flag, what) in [
            (self.has_contact, "contact", "contact of shapes"),
            (self.has_ranges[0], "limit", "the range of joints"),
            (self.has_ranges[1], "limit", "the range of tendons"),
        ] {
            if is_present && !self.is_off(flag) && !self.is_off("constraint") {
                self.robot.left_out.push(what.to_owned());
            }
        }
    }

    /// Reports whether an element has a range that it keeps.
    fn is_limited(&self, node: Node<'a, 'input>, class: Option<&str>) -> Read<bool> {
        Ok(match self.text(node, class, "limited").as_deref() {
            Some("true") => true,
            Some("false") => false,
            _ => !self.values(node, class, "range")?.is_empty(),
        })
    }

    /// Reads a body, with a link of its own before it for each joint, and returns its name.
    fn body(&mut self, part: &Part<'a, 'input>, parent: &str) -> Read<String> {
        let node = part.node;
        let line = self.reader.line(node);
        let name = self.name(part, "body");
        if node.attribute("mocap").is_some_and(|text| text.trim() == "true") {
            self.robot.left_out.push(format!("`mocap` of body `{name}`"));
        }
        let compensation = self.reader.number_or(Some(node), "gravcomp", 0.0)?;
        let (mut last, mut at) = (parent.to_owned(), part.frame * self.place(node, None)?);
        let mut rounding = self.rounding_of_place(node)?;
        let mut joints = Vec::new();
        for kind in ["joint", "freejoint"] {
            joints.extend(self.parts(part, kind)?);
        }
        joints.sort_by_key(|part| part.node.range().start);
        for element in joints {
            let frame = element.frame;
            let mut joint = self.joint(&element)?;
            joint.origin.xyz = (frame * Point3::from(joint.origin.xyz)).coords.into();
            joint.axis = (frame.rotation * Vector3::from(joint.axis)).into();
            let moved = self.free_name(&format!("{name}_{}", joint.name));
            let anchor = joint.origin;
            at *= isometry(&anchor);
            self.robot.joints.push(Joint {
                parent: last,
                child: moved.clone(),
                origin: pose(&at),
                rounding: rounding + joint.rounding,
                ..joint
            });
            rounding = 0.0;
            self.robot.links.push(Link { name: moved.clone(), line, ..Link::default() });
            last = moved;
            at = isometry(&anchor).inverse();
        }
        let inertial = self.inertial(part)?;
        let link = Link { name: name.clone(), line, inertial, compensation, ..Link::default() };
        self.robot.links.push(link);
        let fixed = format!("{name} fixed");
        let mut rest = Joint::plain(&fixed, line, Motion::Fixed, [&last, &name]);
        (rest.origin, rest.rounding) = (pose(&at), rounding);
        self.robot.joints.push(rest);
        Ok(name)
    }

    /// Returns the name of an element, and remembers that of a copy.
    fn name(&mut self, part: &Part<'a, 'input>, kind: &str) -> String {
        let Some(name) = part.node.attribute("name") else { return self.free_name(kind) };
        if !part.ending.is_empty() {
            self.copies.entry(name.to_owned()).or_default().push(part.ending.clone());
        }
        format!("{name}{}", part.ending)
    }

    /// Reads an element that refers to others, once for each copy of those.
    fn for_copies(
        &mut self,
        node: Node<'a, 'input>,
        read: fn(&mut Self, Node<'a, 'input>) -> Read<()>,
    ) -> Read<()> {
        let attributes = node.descendants().flat_map(|node| node.attributes());
        let named = |key: &str| REFERENCES.contains(&key.trim_end_matches(['1', '2']));
        let mut references = attributes.filter(|one| named(one.name()));
        let copies = references.find_map(|one| self.copies.get(one.value()).cloned());
        let Some(endings) = copies else { return read(self, node) };
        if let Some(name) = node.attribute("name") {
            self.copies.insert(name.to_owned(), endings.clone());
        }
        for ending in endings {
            self.ending = ending;
            read(self, node)?;
        }
        self.ending.clear();
        Ok(())
    }

    /// Returns the name of an element that refers to others.
    fn own_name(&self, node: Node<'a, 'input>, kind: &str) -> String {
        let name = node.attribute("name").map(|name| format!("{name}{}", self.ending));
        name.unwrap_or_else(|| self.free_name(kind))
    }

    /// Returns the name of the element to which a reference leads.
    fn referred(&self, name: &str) -> String {
        let is_copy = self.copies.contains_key(name);
        if is_copy { format!("{name}{}", self.ending) } else { name.to_owned() }
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
    fn joint(&mut self, part: &Part<'a, 'input>) -> Read<Joint> {
        let (node, class) = (part.node, part.class);
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
        let name = self.name(part, "joint");
        let value = |key: &str| self.value(node, class, key);
        let turns = motion == Motion::Turns;
        let angle = if turns { self.compiler.angle } else { 1.0 };
        let losses = [value("damping")?, value("frictionloss")?, value("stiffness")?];
        let is_plain = matches!(motion, Motion::Turns | Motion::Slides);
        if losses.iter().any(|value| *value < 0.0) {
            let message = "damping, friction and stiffness must not be negative";
            return Err(self.reader.error(node, message, ""));
        }
        let springs = self.values(node, class, "springdamper")?;
        let springs =
            <[f64; 2]>::try_from(springs).ok().filter(|own| own.iter().all(|one| *one > 0.0));
        if !is_plain && (losses[2] != 0.0 || springs.is_some()) {
            let message = format!("springs of {kind} joints are not read");
            return Err(self.reader.error(node, message, "remove them"));
        }
        // Coordinates count from the position of the model.
        let zero = if is_plain { value("ref")? * angle } else { 0.0 };
        let axis = self.vector(node, class, "axis", [0.0, 0.0, 1.0])?;
        if is_plain && axis.iter().all(|entry| *entry == 0.0) {
            return Err(self.reader.error(node, "the axis of this joint is zero", ""));
        }
        let limits = match self.values(node, class, "range")?[..] {
            [lower, upper] if is_plain => Some(Limits {
                position: [lower * angle - zero, upper * angle - zero],
                velocity: 0.0,
                effort: 0.0,
            }),
            _ => None,
        };
        let xyz = match motion {
            Motion::Floats => [0.0; 3],
            _ => self.vector(node, class, "pos", [0.0; 3])?,
        };
        let joint = Joint {
            origin: Pose { xyz, rpy: [0.0; 3] },
            axis,
            rounding: self.rounding(node, class, "axis") / Vector3::from(axis).norm(),
            damping: losses[0],
            friction: losses[1],
            spring: [losses[2], value("springref")? * angle - zero],
            armature: value("armature")?,
            limits,
            ..Joint::plain(&name, self.reader.line(node), motion, ["", ""])
        };
        self.tuned.extend(springs.map(|springs| (name.clone(), springs)));
        self.has_ranges[0] |= self.is_limited(node, class)?;
        if zero != 0.0 {
            self.references.insert(name.clone(), zero);
        }
        let name = name.escape_debug();
        if zero != 0.0 {
            self.robot.notes.push(format!("joint `{name}` counts from its `ref`, {zero}"));
        }
        Ok(joint)
    }
}

/// Returns the sections of a model with one name; included files add some.
fn sections<'a, 'input: 'a>(
    root: Node<'a, 'input>,
    tag: &str,
) -> impl Iterator<Item = Node<'a, 'input>> {
    elements(root).filter(move |node| node.tag_name().name() == tag)
}

fn elements<'a, 'input: 'a>(
    node: Node<'a, 'input>,
) -> impl Iterator<Item = Node<'a, 'input>> + use<'a, 'input> {
    node.children().filter(Node::is_element)
}
