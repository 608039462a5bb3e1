//! Equalities: connections of bodies, and joints that follow others.

use nalgebra::{Isometry3, Quaternion, UnitQuaternion, Vector3};
use roxmltree::Node;

use super::Model;
use crate::robot::shapes::pose;
use crate::robot::tendons::{Coupling, Length};
use crate::robot::tree::{Closure, Joint, Mimic, Motion, WORLD};
use crate::robot::xml::Read;

impl<'a, 'input> Model<'a, 'input> {
    /// Reads a connection of two bodies, or a joint that follows another.
    pub(super) fn equality(&mut self, node: Node<'a, 'input>) -> Read<()> {
        let kind = node.tag_name().name();
        let motion = match kind {
            "connect" => Motion::Rolls,
            "weld" => Motion::Fixed,
            "joint" => return self.follow(node),
            "tendon" => return self.couple(node, Length::Tendon),
            _ => {
                self.robot.left_out.push(format!("<{kind}> of <equality>"));
                return Ok(());
            }
        };
        if node.has_attribute("site1") {
            let [one, other] = [self.site(node, "site1")?, self.site(node, "site2")?];
            self.connect(node, motion, &[one.link, other.link], [one.at, other.at]);
            return Ok(());
        }
        let ends = self.ends(node)?;
        let [one, other] = &ends;
        let places = if motion == Motion::Rolls {
            let [x, y, z] = self.reader.exactly(node, "anchor")?.unwrap_or_default();
            let place = Isometry3::translation(x, y, z);
            [place, self.within(one, other) * place]
        } else {
            let given = self.reader.exactly(node, "relpose")?.and_then(|relative| {
                let [x, y, z, w, i, j, k] = relative;
                let turn = UnitQuaternion::try_new(Quaternion::new(w, i, j, k), 0.0)?;
                Some(Isometry3::from_parts(Vector3::new(x, y, z).into(), turn))
            });
            [given.unwrap_or_else(|| self.within(other, one)), Isometry3::identity()]
        };
        self.connect(node, motion, &ends, places);
        Ok(())
    }

    /// Returns the bodies of an equality.
    fn ends(&self, node: Node<'a, 'input>) -> Read<[String; 2]> {
        let of = |key: &str| {
            let Some(name) = node.attribute(key) else { return Ok(WORLD.to_owned()) };
            let name = self.referred(name);
            if self.robot.links.iter().any(|link| link.name == name) {
                return Ok(name);
            }
            let message = format!("the body `{}` is missing", name.escape_debug());
            Err(self.reader.error(node, message, ""))
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
        let name = self.own_name(node, "loop");
        let joint = Joint::plain(&name, self.reader.line(node), motion, [one, other]);
        self.robot.closures.push(Closure {
            joint,
            poses: places.map(|at| pose(&at)),
            is_planar: false,
        });
    }

    /// Returns the pose of a body in the frame of another, with all joints at zero.
    fn within(&self, body: &str, frame: &str) -> Isometry3<f64> {
        self.robot.at_zero(frame).inverse() * self.robot.at_zero(body)
    }

    /// Lets a joint follow another in proportion, or couples it by an equation.
    fn follow(&mut self, node: Node<'a, 'input>) -> Read<()> {
        let name = self.referred(self.reader.attribute(node, "joint1")?);
        let leader = node.attribute("joint2").map(|name| self.referred(name));
        let coefficients = self.coefficients(node)?;
        let Some(joint) = self.robot.joints.iter_mut().find(|joint| joint.name == name) else {
            let message = format!("the joint `{}` is missing", name.escape_debug());
            return Err(self.reader.error(node, message, ""));
        };
        match (leader, &coefficients[..]) {
            (Some(leader), [offset, multiplier]) if joint.mimic.is_none() => {
                let (multiplier, offset) = (*multiplier, *offset);
                joint.mimic = Some(Mimic { joint: leader, multiplier, offset });
                Ok(())
            }
            _ => self.couple(node, Length::Joint),
        }
    }

    /// Couples two joints or tendons, or holds one, by an equation.
    fn couple(&mut self, node: Node<'a, 'input>, length: fn(String) -> Length) -> Read<()> {
        let kind = node.tag_name().name();
        let find = |key: String| -> Read<Option<Length>> {
            let Some(name) = node.attribute(&*key) else { return Ok(None) };
            let length = length(self.referred(name));
            let is_known = match &length {
                Length::Joint(name) => self.robot.joint(name).is_some(),
                Length::Tendon(name) => self.robot.tendons.iter().any(|one| one.name == *name),
            };
            if is_known {
                return Ok(Some(length));
            }
            let message = format!("the {kind} `{}` is missing", name.escape_debug());
            Err(self.reader.error(node, message, "tendons around shapes are not read"))
        };
        self.reader.attribute(node, &format!("{kind}1"))?;
        let Some(of) = find(format!("{kind}1"))? else { return Ok(()) };
        let by = find(format!("{kind}2"))?;
        let coefficients = self.coefficients(node)?;
        let name = self.own_name(node, "equality");
        self.robot.couplings.push(Coupling { name, of, by, coefficients });
        Ok(())
    }

    /// Reads the coefficients of a polynomial, without zeros at the end.
    fn coefficients(&self, node: Node<'a, 'input>) -> Read<Vec<f64>> {
        let mut all = self.reader.numbers(node, "polycoef")?.unwrap_or(vec![0.0, 1.0]);
        while all.len() > 2 && all.last() == Some(&0.0) {
            all.pop();
        }
        if let [_] = all[..] {
            all.push(1.0);
        }
        Ok(all)
    }
}
