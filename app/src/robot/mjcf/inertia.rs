//! Inertias of bodies, given or of shapes.

use nalgebra::Isometry3;
use roxmltree::Node;

use super::Model;
use super::places::Part;
use crate::robot::shapes::{Shape, pose, together};
use crate::robot::tree::Inertial;
use crate::robot::xml::{Read, child};

/// Density of shapes without one \[kg/m^3\].
const DENSITY: f64 = 1000.0;

impl<'a, 'input> Model<'a, 'input> {
    /// Reads the inertia of a body: that of <inertial>, or of its shapes.
    pub(super) fn inertial(&self, body: &Part<'a, 'input>) -> Read<Option<Inertial>> {
        let given = child(body.node, "inertial").filter(|_| !self.compiler.always_from_shapes);
        let found = match given {
            Some(given) => self.given(given).map(Some),
            None => self.of_shapes(body),
        };
        Ok(self.compiler.bounded(found?))
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

    fn of_shapes(&self, body: &Part<'a, 'input>) -> Read<Option<Inertial>> {
        let mut parts = Vec::new();
        for Part { node: geom, frame, class, .. } in self.parts(body, "geom")? {
            let group = self.value(geom, class, "group")?;
            if !self.compiler.groups.contains(&group) {
                continue;
            }
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
            parts.push((mass, frame * at, shape.inertia(mass)));
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
        let (at, length) = self.stretched(node, class)?;
        let (mut half, mut third) = (size.get(1).copied(), size.get(2).copied());
        if length.is_some() {
            let is_round = matches!(kind.as_str(), "capsule" | "cylinder");
            (half, third) = (if is_round { length } else { size.first().copied() }, length);
        }
        let shape = match (kind.as_str(), size.first(), half, third) {
            ("plane" | "hfield", ..) => return Ok(None),
            ("sphere", Some(r), ..) => Shape::Sphere(*r),
            ("capsule", Some(r), Some(h), _) => Shape::Capsule(*r, h),
            ("cylinder", Some(r), Some(h), _) => Shape::Cylinder(*r, h),
            ("box", Some(a), Some(b), Some(c)) => Shape::Box([*a, b, c]),
            ("ellipsoid", Some(a), Some(b), Some(c)) => Shape::Ellipsoid([*a, b, c]),
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
