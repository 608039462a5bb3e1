//! Tendons along joints and between sites.

use roxmltree::Node;

use super::{Model, elements};
use crate::robot::tendons::{Path, Segment, Site, Tendon};
use crate::robot::xml::Read;

/// Value of `springlength` for the length at which the springs of joints are unloaded.
const BY_JOINTS: [f64; 2] = [-1.0; 2];

impl<'a, 'input> Model<'a, 'input> {
    /// Reads a tendon.
    pub(super) fn tendon(&mut self, node: Node<'a, 'input>) -> Read<()> {
        let name = self.own_name(node, "tendon");
        let value = |key: &str| self.value(node, None, key);
        let mut tendon = Tendon {
            path: Path::Joints(Vec::new()),
            rest: match self.values(node, None, "springlength")?[..] {
                [] => BY_JOINTS,
                [rest] => [rest; 2],
                [lower, upper, ..] => [lower, upper],
            },
            stiffness: value("stiffness")?,
            damping: value("damping")?,
            friction: value("frictionloss")?,
            armature: value("armature")?,
            name,
        };
        let losses = [tendon.stiffness, tendon.damping, tendon.friction, tendon.armature];
        if losses.iter().any(|value| *value < 0.0) {
            let message = "stiffness, damping, friction and armature must not be negative";
            return Err(self.reader.error(node, message, ""));
        }
        self.has_ranges[1] |= self.is_limited(node, None)?;
        let is_of_joints = node.tag_name().name() == "fixed";
        let by_joints = tendon.rest == BY_JOINTS;
        if is_of_joints {
            let joints = self.along_joints(node)?;
            let sum = |of: &dyn Fn(&str) -> Option<f64>| -> f64 {
                joints.iter().map(|(name, share)| share * of(name).unwrap_or(0.0)).sum()
            };
            // The length counts from that with all joints at zero.
            tendon.rest = if by_joints {
                [sum(&|name| Some(self.robot.joint(name)?.spring[1])); 2]
            } else {
                let zero = sum(&|name| self.references.get(name).copied());
                tendon.rest.map(|rest| rest - zero)
            };
            tendon.path = Path::Joints(joints);
        } else if let Some(segments) = self.between_sites(node)? {
            if by_joints {
                tendon.rest = [self.robot.distance(&segments, true); 2];
            }
            tendon.path = Path::Segments(segments);
        } else {
            if tendon.acts() {
                let name = &tendon.name;
                self.robot.left_out.push(format!("tendon `{name}`, which wraps around shapes,"));
            }
            return Ok(());
        }
        self.robot.tendons.push(tendon);
        Ok(())
    }

    /// Reads the joints of a tendon, with their coefficients.
    fn along_joints(&self, node: Node<'a, 'input>) -> Read<Vec<(String, f64)>> {
        let parts = elements(node).filter(|part| part.has_tag_name("joint"));
        let joint = |part: Node<'a, 'input>| {
            let name = self.referred(self.reader.attribute(part, "joint")?);
            if self.robot.joint(&name).is_none() {
                let message = format!("the joint `{}` is missing", name.escape_debug());
                return Err(self.reader.error(part, message, ""));
            }
            Ok((name, self.reader.number(part, "coef")?))
        };
        parts.map(joint).collect()
    }

    /// Reads the sites of a tendon, in branches that pulleys separate; `None` if it wraps around shapes.
    fn between_sites(&self, node: Node<'a, 'input>) -> Read<Option<Vec<Segment>>> {
        let (mut segments, mut last, mut share) = (Vec::new(), None, 1.0);
        for part in elements(node) {
            match part.tag_name().name() {
                "site" => {
                    let site = self.site(part, "site")?;
                    if let Some(last) = last.replace(site.clone()) {
                        segments.push(Segment { ends: [last, site], share });
                    }
                }
                "pulley" => {
                    let divisor = self.reader.number(part, "divisor")?;
                    if divisor <= 0.0 {
                        return Err(self.reader.error(part, "`divisor` must be positive", ""));
                    }
                    (last, share) = (None, divisor.recip());
                }
                _ => return Ok(None),
            }
        }
        Ok(Some(segments))
    }

    /// Returns the site that an attribute names.
    pub(super) fn site(&self, node: Node<'a, 'input>, key: &str) -> Read<Site> {
        let name = self.referred(self.reader.attribute(node, key)?);
        self.sites.get(&name).cloned().ok_or_else(|| {
            let message = format!("the site `{}` is missing", name.escape_debug());
            self.reader.error(node, message, "")
        })
    }
}
