//! Equalities: connections of bodies, and joints that follow others.

use nalgebra::{Isometry3, Quaternion, UnitQuaternion, Vector3};
use roxmltree::Node;

use super::Model;
use crate::robot::shapes::pose;
use crate::robot::tree::{Closure, Joint, Mimic, Motion, WORLD};
use crate::robot::xml::Read;

impl<'a, 'input> Model<'a, 'input> {
    /// Reads a connection of two bodies, or a joint that follows another.
    pub(super) fn equality(&mut self, node: Node<'a, 'input>) -> Read<()> {
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
}
