//! Settings of MuJoCo's compiler.

use std::f64::consts::PI;
use std::ops::RangeInclusive;

use nalgebra::{Matrix3, SymmetricEigen, Vector3};
use roxmltree::Node;

use super::sections;
use crate::robot::tree::{Inertial, Robot};
use crate::robot::xml::{Read, Reader};

/// Settings of the compiler.
pub(super) struct Compiler {
    /// Radians per unit of an angle.
    pub(super) angle: f64,
    /// Axes of Euler angles.
    pub(super) sequence: String,
    /// True if shapes give the inertia even beside <inertial>.
    pub(super) always_from_shapes: bool,
    /// Groups of the shapes that have mass.
    pub(super) groups: RangeInclusive<f64>,
    /// Total mass to which all are scaled \[kg\]; 0 if they are not.
    pub(super) total_mass: f64,
    /// Least mass \[kg\] and least moment of inertia \[kg m^2\] of a body.
    least: [f64; 2],
    /// True if moments of inertia that no body has become their mean.
    balances: bool,
}

impl Compiler {
    pub(super) fn new(reader: &Reader<'_, '_>, root: Node<'_, '_>) -> Read<Self> {
        let of =
            |key: &str| sections(root, "compiler").filter(|node| node.has_attribute(key)).last();
        let text = |key: &str| of(key).and_then(|node| node.attribute(key)).unwrap_or_default();
        let number = |key: &str| reader.number_or(of(key), key, 0.0);
        if let (Some(node), "global") = (of("coordinate"), text("coordinate")) {
            return Err(reader.error(node, "global coordinates are not read", ""));
        }
        let groups = of("inertiagrouprange").map(|node| reader.exactly(node, "inertiagrouprange"));
        let [first, last] = groups.transpose()?.flatten().unwrap_or([f64::MIN, f64::MAX]);
        let sequence = text("eulerseq");
        Ok(Compiler {
            angle: if text("angle") == "radian" { 1.0 } else { PI / 180.0 },
            sequence: if sequence.is_empty() { "xyz" } else { sequence }.to_owned(),
            always_from_shapes: text("inertiafromgeom") == "true",
            groups: first..=last,
            total_mass: number("settotalmass")?,
            least: [number("boundmass")?, number("boundinertia")?],
            balances: text("balanceinertia") == "true",
        })
    }

    /// Returns the inertia of a body within the bounds of the compiler.
    pub(super) fn bounded(&self, inertial: Option<Inertial>) -> Option<Inertial> {
        let [mass, moment] = self.least;
        if mass <= 0.0 && moment <= 0.0 && !self.balances {
            return inertial;
        }
        let mut bounded = inertial.unwrap_or_default();
        bounded.mass = bounded.mass.max(mass);
        let [xx, yy, zz, xy, xz, yz] = bounded.inertia;
        let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let SymmetricEigen { mut eigenvalues, eigenvectors } = tensor.symmetric_eigen();
        eigenvalues.iter_mut().for_each(|own| *own = own.max(moment));
        if self.balances && 2.0 * eigenvalues.max() > eigenvalues.sum() {
            eigenvalues = Vector3::repeat(eigenvalues.mean());
        }
        let tensor = eigenvectors * Matrix3::from_diagonal(&eigenvalues) * eigenvectors.transpose();
        bounded.inertia = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|at| tensor[at]);
        Some(bounded)
    }
}

impl Robot {
    /// Determines springs and damping of joints by their time constants \[s\] and damping ratios, for the
    /// inertia that they feel.
    pub(super) fn tune(&mut self, joints: &[(String, [f64; 2])]) {
        let felt = if joints.is_empty() { None } else { self.felt() };
        for (name, [time, ratio]) in joints {
            let inertia = felt.as_ref().and_then(|felt| felt.get(name));
            let joint = self.joints.iter_mut().find(|joint| joint.name == *name);
            let (Some(inertia), Some(joint)) = (inertia, joint) else {
                self.left_out.push(format!("`springdamper` of joint `{}`", name.escape_debug()));
                continue;
            };
            joint.spring[0] = inertia / (time * ratio).powi(2);
            joint.damping = 2.0 * inertia / time;
        }
    }

    /// Scales all masses and inertias to a total mass \[kg\], unless it is zero.
    pub(super) fn scale_to(&mut self, total: f64) {
        let inertials = || self.links.iter().filter_map(|link| link.inertial);
        let now: f64 = inertials().map(|inertial| inertial.mass).sum();
        if total <= 0.0 || now <= 0.0 {
            return;
        }
        for inertial in self.links.iter_mut().filter_map(|link| link.inertial.as_mut()) {
            inertial.mass *= total / now;
            inertial.inertia = inertial.inertia.map(|entry| entry * total / now);
        }
    }
}
