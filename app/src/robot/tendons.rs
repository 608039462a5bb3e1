//! Lengths that joints or points of a robot determine, with springs and losses, and equations between them.

use nalgebra::{Isometry3, Point3};

use super::tree::{Motion, Robot};

/// A point that is fixed to a link.
#[derive(Debug, Clone, PartialEq)]
pub struct Site {
    /// Its name.
    pub name: String,
    /// The link.
    pub link: String,
    /// Its pose in the frame of the link.
    pub at: Isometry3<f64>,
}

/// A share of the distance of two sites.
#[derive(Debug, Clone, PartialEq)]
pub struct Segment {
    /// The sites.
    pub ends: [Site; 2],
    /// The share.
    pub share: f64,
}

/// Length of a tendon.
#[derive(Debug, Clone, PartialEq)]
pub enum Path {
    /// Sum of the positions of joints, from zero, each times a coefficient.
    Joints(Vec<(String, f64)>),
    /// Sum of shares of distances.
    Segments(Vec<Segment>),
}

/// A tendon, with a spring and losses along its length.
#[derive(Debug, Clone, PartialEq)]
pub struct Tendon {
    /// Its name.
    pub name: String,
    /// Its length.
    pub path: Path,
    /// Lengths between which the spring is unloaded.
    pub rest: [f64; 2],
    /// Stiffness of the spring.
    pub stiffness: f64,
    /// Viscous damping.
    pub damping: f64,
    /// Dry friction.
    pub friction: f64,
    /// Inertia along the length.
    pub armature: f64,
}

impl Tendon {
    /// Reports whether a force acts along it.
    pub fn acts(&self) -> bool {
        [self.stiffness, self.damping, self.friction, self.armature].iter().any(|one| *one > 0.0)
    }
}

/// A joint or a tendon, by its name.
#[derive(Debug, Clone, PartialEq)]
pub enum Length {
    Joint(String),
    Tendon(String),
}

/// An equation: a length, from that with all joints at zero, is a polynomial of another, or constant.
#[derive(Debug, Clone, PartialEq)]
pub struct Coupling {
    /// Its name.
    pub name: String,
    /// The length.
    pub of: Length,
    /// The other.
    pub by: Option<Length>,
    /// Coefficients of the polynomial, the constant one first.
    pub coefficients: Vec<f64>,
}

impl Robot {
    /// Returns the sum of shares of distances, with all joints at zero or with their springs unloaded.
    pub fn distance(&self, segments: &[Segment], is_unloaded: bool) -> f64 {
        let place = |site: &Site| self.placed(&site.link, is_unloaded) * site.at * Point3::origin();
        let all = segments
            .iter()
            .map(|Segment { ends: [a, b], share }| share * (place(a) - place(b)).norm());
        all.sum()
    }

    /// Returns the pose of a link in the world, with all joints at zero or with their springs unloaded.
    pub fn placed(&self, link: &str, is_unloaded: bool) -> Isometry3<f64> {
        let above = self.above(&self.carriers(), link);
        above.iter().fold(Isometry3::identity(), |whole, at| {
            let joint = &self.joints[*at];
            let moved = match joint.motion {
                Motion::Turns | Motion::Slides if is_unloaded => joint.moved(joint.spring[1]),
                _ => Isometry3::identity(),
            };
            super::shapes::isometry(&joint.origin) * moved * whole
        })
    }
}
