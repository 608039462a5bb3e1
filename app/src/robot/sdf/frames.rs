//! Frames of a model: poses that are given relative to each other.

use std::collections::BTreeMap;
use std::iter;

use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion, Vector3};
use roxmltree::Node;

use super::{elements, text_of};
use crate::robot::digits::Digits;
use crate::robot::shapes::isometry;
use crate::robot::tree::Pose;
use crate::robot::xml::{DEEPEST, Read, Reader, child};

/// Name of the model's own frame.
pub(super) const MODEL: &str = "__model__";

/// A pose and the frame that it is relative to.
struct RelativePose<'a, 'input> {
    node: Node<'a, 'input>,
    relative_to: String,
    pose: Isometry3<f64>,
    /// Rounding of the rotation by the digits of the file \[rad\].
    rounding: f64,
}

/// Frames of links and joints and frames alone, by name.
pub(super) struct Frames<'a, 'input> {
    reader: &'a Reader<'a, 'input>,
    model: Node<'a, 'input>,
    /// Pose of the model in the world.
    placed: Isometry3<f64>,
    /// Digits of positions and directions.
    digits: Digits,
    /// Links between the axes of a joint, and the joints whose frames are theirs.
    between: BTreeMap<String, String>,
    all: BTreeMap<String, RelativePose<'a, 'input>>,
}

impl<'a, 'input> Frames<'a, 'input> {
    /// Reads the poses of a model.
    pub(super) fn new(reader: &'a Reader<'a, 'input>, model: Node<'a, 'input>) -> Read<Self> {
        let is_geometry = |node: &Node<'_, '_>| ["pose", "xyz"].contains(&node.tag_name().name());
        let geometry = model.descendants().filter(is_geometry);
        let digits = Digits::of(geometry.filter_map(|node| node.text()));
        let (placed, all) = (Isometry3::identity(), BTreeMap::new());
        let between = BTreeMap::new();
        let mut frames = Frames { reader, model, placed, digits, between, all };
        frames.placed = frames.own(model)?;
        for tag in ["link", "joint", "frame"] {
            for node in elements(model, tag) {
                let name = reader.name(node)?;
                let own = child(node, "pose").and_then(|pose| pose.attribute("relative_to"));
                let default = match tag {
                    "link" => MODEL.to_owned(),
                    "joint" => text_of(
                        node.children()
                            .find(|one| one.has_tag_name("child"))
                            .ok_or_else(|| reader.error(node, "<joint> lacks <child>", ""))?,
                    ),
                    _ => node.attribute("attached_to").unwrap_or_default().to_owned(),
                };
                let relative_to = own.filter(|own| !own.is_empty()).map_or(default, str::to_owned);
                let (pose, rounding) = (frames.own(node)?, frames.own_rounding(node));
                let given = RelativePose { node, relative_to, pose, rounding };
                if frames.all.insert(name.clone(), given).is_some() {
                    let message = format!("two frames are called `{}`", name.escape_debug());
                    return Err(reader.error(node, message, ""));
                }
            }
        }
        Ok(frames)
    }

    /// Adds a link between the axes of a joint.
    pub(super) fn add_between(&mut self, link: &str, joint: &str) {
        self.between.insert(link.to_owned(), joint.to_owned());
    }

    /// Returns the frame of the file that a frame is.
    fn known<'n>(&'n self, name: &'n str) -> &'n str {
        self.between.get(name).map_or(name, String::as_str)
    }

    /// Returns the pose that an element has relative to another.
    fn own(&self, of: Node<'_, '_>) -> Read<Isometry3<f64>> {
        let Some(node) = child(of, "pose") else { return Ok(Isometry3::identity()) };
        let angle = match node.attribute("degrees") {
            Some("true" | "1") => std::f64::consts::PI / 180.0,
            _ => 1.0,
        };
        match node.attribute("rotation_format") {
            None | Some("euler_rpy") => {
                if text_of(node).is_empty() {
                    return Ok(Isometry3::identity());
                }
                let [x, y, z, roll, pitch, yaw] = self.reader.listed(node)?;
                let rpy = [roll, pitch, yaw].map(|part| part * angle);
                Ok(isometry(&Pose { xyz: [x, y, z], rpy }))
            }
            Some("quat_xyzw") => {
                let [x, y, z, i, j, k, w] = self.reader.listed(node)?;
                let turn = UnitQuaternion::try_new(Quaternion::new(w, i, j, k), 0.0)
                    .ok_or_else(|| self.reader.error(node, "the quaternion is zero", ""))?;
                Ok(Isometry3::from_parts(Translation3::from(Vector3::new(x, y, z)), turn))
            }
            Some(other) => {
                let message = format!("`rotation_format` is `{}`", other.escape_debug());
                Err(self.reader.error(node, message, "known are euler_rpy and quat_xyzw"))
            }
        }
    }

    /// Returns the rounding of the rotation that an element has relative to another \[rad\].
    fn own_rounding(&self, of: Node<'_, '_>) -> f64 {
        let Some(node) = child(of, "pose") else { return 0.0 };
        let numbers = text_of(node);
        let rounding = self.digits.rounding(numbers.split_whitespace().skip(3));
        match (node.attribute("degrees"), node.attribute("rotation_format")) {
            // A rotation turns by twice the angle of its quaternion.
            (_, Some("quat_xyzw")) => 2.0 * rounding,
            (Some("true" | "1"), _) => rounding.to_radians(),
            _ => rounding,
        }
    }

    /// Returns the rounding of a direction in an element by its own numbers \[rad\].
    pub(super) fn rounding_of_axis(&self, node: Node<'_, '_>, axis: Vector3<f64>) -> f64 {
        self.digits.rounding(text_of(node).split_whitespace()) / axis.norm()
    }

    /// Returns the rounding of the rotation of a frame seen from another \[rad\].
    pub(super) fn rounding(&self, from: &str, to: &str) -> f64 {
        let [from, to] = [from, to].map(|name| self.known(name));
        let above = |name: &str, stop: &str| {
            let own = |name: &str| self.all.get(name.trim()).filter(|_| name.trim() != stop);
            let next = |given: &&RelativePose<'_, '_>| own(&given.relative_to);
            let all: Vec<_> = iter::successors(own(name), next).take(DEEPEST).collect();
            let ends_there = all.last().is_some_and(|last| last.relative_to.trim() == stop);
            (all.iter().map(|given| given.rounding).sum::<f64>(), ends_there)
        };
        let (rounding, ends_there) = above(to, from);
        if ends_there { rounding } else { rounding + above(from, MODEL).0 }
    }

    /// Returns the pose of a part of a link in the link's frame.
    pub(super) fn placed(&self, part: Node<'_, '_>) -> Read<Isometry3<f64>> {
        let own = self.own(part)?;
        let relative_to = child(part, "pose").and_then(|pose| pose.attribute("relative_to"));
        let Some(frame) = relative_to.filter(|frame| !frame.is_empty()) else { return Ok(own) };
        let link = part.parent().and_then(|link| link.attribute("name")).unwrap_or_default();
        Ok(self.between(link, frame)? * own)
    }

    /// Returns the pose of a frame in another. It is exact where it is given by steps between the two.
    pub(super) fn between(&self, from: &str, to: &str) -> Read<Isometry3<f64>> {
        let [from, to] = [from, to].map(|name| self.known(name));
        let (whole, end) = self.climb(to, from)?;
        if end == from { Ok(whole) } else { Ok(self.in_model(from)?.inverse() * whole) }
    }

    /// Reports whether a joint has the frame of the link that it carries.
    pub(super) fn is_at(&self, joint: &str, link: &str) -> bool {
        if self.known(link) == joint {
            return true;
        }
        let is_at = |given: &RelativePose<'_, '_>| {
            given.relative_to == link && given.pose == Isometry3::identity()
        };
        self.all.get(joint).is_some_and(is_at)
    }

    /// Returns the pose of a frame in the model.
    pub(super) fn in_model(&self, name: &str) -> Read<Isometry3<f64>> {
        Ok(self.climb(name, MODEL)?.0)
    }

    /// Returns the pose of a frame in the frame at which the climb ends: `stop`, or the model.
    fn climb<'n>(&'n self, name: &'n str, stop: &str) -> Read<(Isometry3<f64>, &'n str)> {
        let mut whole = Isometry3::identity();
        let (mut name, mut from) = (name.trim(), self.model);
        for _ in 0..DEEPEST {
            match name {
                "" | MODEL => return Ok((whole, MODEL)),
                _ if name == stop => return Ok((whole, name)),
                "world" => return Ok((self.of_world() * whole, MODEL)),
                _ => {}
            }
            let Some(given) = self.all.get(name) else {
                let message = format!("the frame `{}` is missing", name.escape_debug());
                return Err(self.reader.error(from, message, "name a link, a joint or a frame"));
            };
            whole = given.pose * whole;
            (name, from) = (given.relative_to.trim(), given.node);
        }
        let message = format!("the pose of `{}` is relative to itself", name.escape_debug());
        Err(self.reader.error(from, message, ""))
    }

    /// Returns the pose of the world in the model.
    pub(super) fn of_world(&self) -> Isometry3<f64> {
        self.placed.inverse()
    }

    /// Returns the pose of a frame in the world.
    pub(super) fn in_world(&self, name: &str) -> Read<Isometry3<f64>> {
        Ok(self.placed * self.in_model(name)?)
    }
}
