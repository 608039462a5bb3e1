//! Components of the motion of a frame: their names, units and meanings.

use crate::spec::dimension::{Dimension, Unit};

/// A component of the motion of a frame, along the axes of the world.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FramePart {
    /// Position of the origin.
    Position(usize),
    /// Velocity of the origin.
    Velocity(usize),
    /// Angular velocity.
    Omega(usize),
    /// Component, given first, of an axis of the frame.
    Rotation(usize, usize),
}

impl FramePart {
    /// Returns all parts with the ends of their names.
    pub fn all() -> Vec<(FramePart, String)> {
        let axes = ["x", "y", "z"];
        let mut all = Vec::new();
        for (i, axis) in axes.iter().enumerate() {
            all.push((FramePart::Position(i), (*axis).to_owned()));
            all.push((FramePart::Velocity(i), format!("v_{axis}")));
            all.push((FramePart::Omega(i), format!("omega_{axis}")));
            for (j, other) in axes.iter().enumerate() {
                all.push((FramePart::Rotation(i, j), format!("r_{axis}{other}")));
            }
        }
        all
    }

    /// Returns its unit of measure.
    pub fn unit(self) -> Unit {
        let (dimension, rad) = match self {
            FramePart::Position(_) => (Dimension::LENGTH, 0),
            FramePart::Velocity(_) => (Dimension::VELOCITY, 0),
            FramePart::Omega(_) => (Dimension::FREQUENCY, 2),
            FramePart::Rotation(..) => (Dimension::ONE, 0),
        };
        Unit { dimension, rad }
    }

    /// Returns the text of its unit, and its meaning.
    pub fn description(self, frame: &str) -> (&'static str, String) {
        let axis = |i: usize| ["x", "y", "z"][i];
        match self {
            FramePart::Position(i) => ("m", format!("position {} of {frame}", axis(i))),
            FramePart::Velocity(i) => ("m/s", format!("velocity of {frame} along {}", axis(i))),
            FramePart::Omega(i) => {
                ("rad/s", format!("angular velocity of {frame} about {}", axis(i)))
            }
            FramePart::Rotation(i, j) => {
                ("1", format!("component {} of the {} axis of {frame}", axis(i), axis(j)))
            }
        }
    }
}
