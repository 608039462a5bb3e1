//! Joints of a model, and gears between them.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;
use std::iter;

use nalgebra::{UnitQuaternion, Vector3};
use roxmltree::Node;

use super::frames::{Frames, MODEL};
use super::{is_true, text_of};
use crate::robot::loops::ROUNDING;
use crate::robot::shapes::{pose, turn_of_z};
use crate::robot::tree::{Closure, Joint, Limits, Link, Mimic, Motion, Robot};
use crate::robot::xml::{Read, Reader, child};

/// Limits beyond this are none \[rad or m\]: the format writes 1e16.
const UNLIMITED: f64 = 1e12;
/// A joint, or one axis of it, and the links that it joins.
pub(super) struct Ends<'a, 'input> {
    node: Node<'a, 'input>,
    axis: Option<Node<'a, 'input>>,
    name: String,
    /// Name of the joint's frame.
    frame: String,
    motion: Motion,
    parent: String,
    carried: String,
    follows: Option<Mimic>,
}

/// Returns the joints that close loops, those with few constraints if possible.
pub(super) fn closing(joints: &[Ends<'_, '_>]) -> BTreeSet<usize> {
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

impl<'a, 'input> Ends<'a, 'input> {
    fn axis(&self, reader: &Reader<'_, '_>) -> Read<Node<'a, 'input>> {
        self.axis.map_or_else(|| reader.part(self.node, "axis"), Ok)
    }
}

impl Reader<'_, '_> {
    /// Reads the links that a joint joins. One with two axes or a screw is two joints, with a link
    /// between them; a gearbox is none.
    pub(super) fn ends<'a, 'i>(
        &self,
        node: Node<'a, 'i>,
        frames: &mut Frames<'_, '_>,
        robot: &mut Robot,
    ) -> Read<Vec<Ends<'a, 'i>>> {
        let name = self.name(node)?;
        let motions: &[Motion] = match self.attribute(node, "type")? {
            "fixed" => &[Motion::Fixed],
            "revolute" | "continuous" => &[Motion::Turns],
            "prismatic" => &[Motion::Slides],
            "ball" => &[Motion::Rolls],
            "universal" | "revolute2" => &[Motion::Turns, Motion::Turns],
            "screw" => &[Motion::Turns, Motion::Slides],
            "gearbox" => &[],
            other => {
                let message = format!("joint `{name}` is of type `{}`", other.escape_debug());
                let help = "known are fixed, revolute, continuous, prismatic, ball, universal, \
                            revolute2, screw and gearbox";
                return Err(self.error(node, message, help));
            }
        };
        let end = |tag: &str| Ok(text_of(self.part(node, tag)?));
        let (parent, carried): (String, String) = (end("parent")?, end("child")?);
        let one = |motion: Motion, name: String, [parent, carried]: [&str; 2]| Ends {
            node,
            axis: child(node, "axis"),
            name,
            frame: self.name(node).unwrap_or_default(),
            motion,
            parent: parent.to_owned(),
            carried: carried.to_owned(),
            follows: None,
        };
        match motions {
            [] => Ok(Vec::new()),
            [motion] => Ok(vec![one(*motion, name, [&parent, &carried])]),
            [first, second, ..] => {
                let between = format!("{name} between");
                robot.links.push(Link {
                    name: between.clone(),
                    line: self.line(node),
                    ..Link::default()
                });
                frames.add_between(&between, &name);
                let is_screw = *second == Motion::Slides;
                let names = if is_screw { ["", " advance"] } else { [" axis", " axis2"] };
                let [turn, other] = names.map(|end| format!("{name}{end}"));
                let mut second = one(*second, other, [&between, &carried]);
                if is_screw {
                    let multiplier = self.advance(node)?;
                    second.follows = Some(Mimic { joint: turn.clone(), multiplier, offset: 0.0 });
                } else {
                    second.axis = Some(self.part(node, "axis2")?);
                }
                Ok(vec![one(*first, turn, [&parent, &between]), second])
            }
        }
    }

    /// Reads by how much a screw advances per angle \[m/rad\].
    fn advance(&self, node: Node<'_, '_>) -> Read<f64> {
        let lead = self.within(Some(node), "screw_thread_pitch", 0.0)?;
        // Earlier versions give the angle per length, with the opposite sign.
        let pitch = self.within(Some(node), "thread_pitch", 0.0)?;
        match (lead == 0.0, pitch == 0.0) {
            (false, _) => Ok(lead / TAU),
            (true, false) => Ok(-1.0 / pitch),
            (true, true) => {
                let message = "this screw has no pitch other than zero";
                Err(self.error(node, message, "write <screw_thread_pitch>, in m per turn"))
            }
        }
    }

    /// Lets the joint of one wheel of a gearbox follow the other's: the angle of the child, seen from the
    /// reference body, is -ratio times that of the parent.
    pub(super) fn gear(
        &self,
        node: Node<'_, '_>,
        frames: &Frames<'_, '_>,
        robot: &mut Robot,
    ) -> Read<()> {
        let name = self.name(node)?;
        let reference = text_of(self.part(node, "gearbox_reference_body")?);
        let ratio = self.within(Some(node), "gearbox_ratio", 1.0)?;
        let wheel = |end: &str, axis: &str| {
            let link = text_of(self.part(node, end)?);
            let axis = self.part(node, axis)?;
            let mut own = Joint::plain(&name, self.line(node), Motion::Turns, [&reference, &link]);
            self.along(axis, &name, frames, &mut own)?;
            let found = robot.joints.iter().position(|joint| {
                joint.motion == Motion::Turns
                    && joint.mimic.is_none()
                    && joint.parent == reference
                    && [&*link, &*format!("{link} at {}", joint.name)].contains(&&*joint.child)
            });
            let same = found.and_then(|at| {
                let frame = frames.between(&name, &robot.joints[at].name).ok()?;
                let there = frame.rotation * Vector3::from(robot.joints[at].axis).normalize();
                let along = Vector3::from(own.axis).normalize();
                let off = own.rounding + robot.joints[at].rounding + ROUNDING;
                (there.cross(&along).norm() <= off).then_some((at, there.dot(&along).signum()))
            });
            same.ok_or_else(|| {
                let message = format!(
                    "gearbox `{name}` needs a revolute joint of `{reference}` with `{link}` along its <{}>",
                    axis.tag_name().name()
                );
                self.error(node, message, "other gears are not read")
            })
        };
        let ((driving, sign), (driven, other_sign)) =
            (wheel("parent", "axis")?, wheel("child", "axis2")?);
        let multiplier = -ratio * sign * other_sign;
        if multiplier == 0.0 || driving == driven {
            return Err(self.error(node, format!("gearbox `{name}` moves nothing"), ""));
        }
        let joint = robot.joints[driving].name.clone();
        robot.joints[driven].mimic = Some(Mimic { joint, multiplier, offset: 0.0 });
        Ok(())
    }

    /// Reads a joint that closes a loop.
    pub(super) fn closure(
        &self,
        ends: &Ends<'_, '_>,
        frames: &Frames<'_, '_>,
        robot: &mut Robot,
    ) -> Read<()> {
        let Ends { node, name, frame, motion, parent, carried, .. } = ends;
        let mut joint = Joint::plain(name, self.line(*node), *motion, [parent, carried]);
        let mut along = UnitQuaternion::identity();
        if matches!(motion, Motion::Turns | Motion::Slides) {
            self.along(ends.axis(self)?, frame, frames, &mut joint)?;
            along = turn_of_z(&Vector3::from(joint.axis));
        }
        if joint.mimic.is_some() || ends.follows.is_some() {
            let message = format!("joint `{name}` follows another and closes a loop");
            return Err(self.error(*node, message, "follow by a joint that closes none"));
        }
        if joint.damping > 0.0 || joint.friction > 0.0 || joint.spring[0] > 0.0 {
            robot.left_out.push(format!("what acts in joint `{name}`, which closes a loop,"));
        }
        let rounding = [parent, carried].map(|link| frames.rounding(link, frame));
        joint.rounding += rounding.iter().sum::<f64>();
        let poses = [parent, carried].map(|link| frames.between(link, frame));
        let [at_parent, at_child] = poses;
        let poses = [at_parent? * along, at_child? * along].map(|at| pose(&at));
        robot.closures.push(Closure { joint, poses, is_planar: false });
        Ok(())
    }

    /// Reads a joint. If its frame is not that of the link that it carries, a link of its own is
    /// between the two.
    pub(super) fn sdf_joint(
        &self,
        ends: &Ends<'_, '_>,
        frames: &Frames<'_, '_>,
        robot: &mut Robot,
    ) -> Read<()> {
        let Ends { node, name, frame, motion, parent, carried, .. } = ends;
        let is_there = frames.is_at(frame, carried);
        let moved = if is_there { carried.clone() } else { format!("{carried} at {name}") };
        let line = self.line(*node);
        let mut joint = Joint::plain(name, line, *motion, [parent, &moved]);
        joint.origin = pose(&frames.between(parent, frame)?);
        joint.rounding = frames.rounding(parent, frame);
        if matches!(motion, Motion::Turns | Motion::Slides) {
            self.along(ends.axis(self)?, frame, frames, &mut joint)?;
        }
        if let Some(follows) = &ends.follows {
            // What acts in a screw acts on its rotation.
            let axis = (joint.axis, joint.origin, joint.rounding);
            joint = Joint::plain(name, line, *motion, [parent, &moved]);
            (joint.axis, joint.origin, joint.rounding) = axis;
            joint.mimic = Some(follows.clone());
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
            fixed.origin = pose(&frames.between(frame, carried)?);
            fixed.rounding = frames.rounding(frame, carried);
            robot.joints.push(fixed);
        }
        Ok(())
    }

    /// Reads an axis of a joint, given the joint's frame: its direction, limits, losses and the joint that it follows.
    fn along(
        &self,
        node: Node<'_, '_>,
        of: &str,
        frames: &Frames<'_, '_>,
        joint: &mut Joint,
    ) -> Read<()> {
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
                joint.rounding += frames.rounding(of, frame);
                let turn = frames.between(of, frame)?.rotation;
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
