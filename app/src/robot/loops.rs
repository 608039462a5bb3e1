//! Axes of loops, made parallel or perpendicular where the digits of a file leave them nearly so.
//!
//! A planar loop of joints moves because its constraints out of the plane are fulfilled in any position.
//! The rounding of numbers in files would undo this. Here, the axes become those of a loop that moves and
//! that has the same digits in the file, and constraints out of the plane are left out.

use std::collections::BTreeMap;

use nalgebra::{Isometry3, Vector3};

use super::shapes::{isometry, pose, turn_into};
use super::tree::{Closure, Joint, Motion, Robot};

/// Rounding of the arithmetic in angles \[rad\].
pub(super) const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// A joint of a loop that moves, and its axis.
struct Axis {
    owner: Owner,
    name: String,
    motion: Motion,
    /// Direction in the world with all joints at zero, of length 1.
    direction: Vector3<f64>,
    /// Sum of the roundings of the joints before it along the loop, its own, and that of those after it
    /// \[rad\].
    rounding: [f64; 3],
}

/// Owner of an axis, by its index.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Owner {
    Joint(usize),
    Closure(usize),
}

impl Axis {
    /// Returns the rounding of the angle to another axis \[rad\], along the better known part of the loop.
    fn rounding(&self, other: &Self) -> f64 {
        let is_first = self.rounding[0] <= other.rounding[0];
        let (first, last) = if is_first { (self, other) } else { (other, self) };
        let ([before, first, _], [_, last, after]) = (first.rounding, last.rounding);
        let whole: f64 = self.rounding.iter().sum();
        ROUNDING + (whole - before - after).min(before + first + last + after)
    }

    /// Reports whether it moves a link other than in a plane, apart from the closure of the loop.
    fn is_spatial(&self) -> bool {
        let is_plane = matches!(self.motion, Motion::Turns | Motion::Slides);
        matches!(self.owner, Owner::Joint(_)) && !is_plane
    }
}

impl Robot {
    /// Returns the pose of a link in the world with all joints at zero.
    pub fn at_zero(&self, link: &str) -> Isometry3<f64> {
        let carriers = self.carriers();
        let above = self.above(&carriers, link);
        above.iter().fold(Isometry3::identity(), |whole, joint| {
            isometry(&self.joints[*joint].origin) * whole
        })
    }

    /// Returns the joints that carry links, by link.
    pub(super) fn carriers(&self) -> BTreeMap<&str, usize> {
        self.joints.iter().enumerate().map(|(at, joint)| (&*joint.child, at)).collect()
    }

    /// Returns the joints from a link up to the base.
    pub(super) fn above(&self, carriers: &BTreeMap<&str, usize>, link: &str) -> Vec<usize> {
        let carrier = |link: &str| carriers.get(link).copied();
        let next = |at: &usize| carrier(&self.joints[*at].parent);
        std::iter::successors(carrier(link), next).take(self.joints.len()).collect()
    }

    /// Makes axes of each loop parallel, or those of sliding joints perpendicular to the others, if their
    /// angle is within the rounding of the file's numbers. No pose with all joints at zero changes.
    pub fn align(&mut self) {
        let mut aligned = Vec::new();
        for closure in 0..self.closures.len() {
            let mut axes = self.axes(closure);
            // Other loops keep what is aligned.
            axes.sort_by_key(|axis| !aligned.contains(&axis.owner));
            let mut turned = Vec::new();
            if let Some(normal) = self.make_parallel(&axes, &mut aligned, &mut turned) {
                self.flatten(closure, normal);
            }
            self.note(closure, &turned);
        }
    }

    /// Leaves out the constraints of a planar loop that are fulfilled in any position.
    fn flatten(&mut self, closure: usize, normal: Vector3<f64>) {
        let Closure { joint, is_planar, .. } = &mut self.closures[closure];
        let across = match joint.motion {
            Motion::Turns | Motion::Rolls => Vector3::z(),
            Motion::Slides => Vector3::x(),
            Motion::Fixed | Motion::Floats => return,
        };
        *is_planar = true;
        self.turn_closure(closure, across, normal);
    }

    /// Notes which axes of a loop turned, and by what angle.
    fn note(&mut self, closure: usize, turned: &[(&str, f64)]) {
        let turned = turned.iter().filter(|(_, angle)| *angle > ROUNDING);
        let names: Vec<_> = turned.clone().map(|(name, _)| format!("`{name}`")).collect();
        let largest = turned.map(|(_, angle)| *angle).fold(0.0, f64::max);
        let name = &self.closures[closure].joint.name;
        if !names.is_empty() {
            self.notes.push(format!(
                "axes of the loop at joint `{name}` are aligned: {} by at most {largest:.1e} rad, which is \
                 within the digits of the file",
                names.join(", ")
            ));
        }
    }

    /// Aligns the axes of a loop, and adds their names and angles to `turned`. Returns the normal of its
    /// plane, if all its joints move in one.
    fn make_parallel<'a>(
        &mut self,
        axes: &'a [Axis],
        aligned: &mut Vec<Owner>,
        turned: &mut Vec<(&'a str, f64)>,
    ) -> Option<Vector3<f64>> {
        let of = |motion| axes.iter().filter(move |axis| axis.motion == motion);
        let mut directions: Vec<&Axis> = Vec::new();
        for axis in of(Motion::Turns) {
            let angle = |other: &Axis| axis.direction.cross(&other.direction).norm();
            let near = directions.iter().find(|other| angle(other) <= axis.rounding(other));
            let Some(near) = near else {
                directions.push(axis);
                continue;
            };
            aligned.extend([axis.owner, near.owner]);
            let into = near.direction * near.direction.dot(&axis.direction).signum();
            turned.push((&axis.name, self.turn_axis(axis, into)));
        }
        let [normal] = directions[..] else { return None };
        for axis in of(Motion::Slides) {
            let along = axis.direction.dot(&normal.direction);
            if along.abs() > axis.rounding(normal) {
                return None;
            }
            aligned.push(axis.owner);
            let into = (axis.direction - normal.direction * along).normalize();
            turned.push((&axis.name, self.turn_axis(axis, into)));
        }
        let is_planar = of(Motion::Turns).count() > 1 && !axes.iter().any(Axis::is_spatial);
        is_planar.then_some(normal.direction)
    }

    /// Turns an axis into a direction, unless only arithmetic separates them. Returns the angle \[rad\].
    fn turn_axis(&mut self, axis: &Axis, into: Vector3<f64>) -> f64 {
        let angle = axis.direction.cross(&into).norm();
        if angle <= ROUNDING {
            return angle;
        }
        match axis.owner {
            Owner::Joint(at) => {
                let frame = self.at_zero(&self.joints[at].child).rotation;
                let joint = &mut self.joints[at];
                let length = Vector3::from(joint.axis).norm();
                joint.axis = (frame.inverse() * into * length).into();
            }
            Owner::Closure(at) => self.turn_closure(at, Vector3::z(), into),
        }
        angle
    }

    /// Turns the frames of a closure, so that an axis of them has a direction or its opposite.
    fn turn_closure(&mut self, closure: usize, axis: Vector3<f64>, along: Vector3<f64>) {
        let Joint { parent, child, .. } = &self.closures[closure].joint;
        let links = [parent, child].map(|link| self.at_zero(link).rotation);
        for (link, at) in links.into_iter().zip(&mut self.closures[closure].poses) {
            let mut own = isometry(at);
            let there = link * own.rotation;
            let now = there * axis;
            let turn = turn_into(&now, &(along * now.dot(&along).signum()));
            own.rotation = link.inverse() * turn * there;
            *at = pose(&own);
        }
    }

    /// Returns the axes of a loop, in its order; none if a joint of it follows another.
    fn axes(&self, closure: usize) -> Vec<Axis> {
        let Joint { parent, child, .. } = &self.closures[closure].joint;
        let carriers = self.carriers();
        let mut down = self.above(&carriers, parent);
        let mut up = self.above(&carriers, child);
        while down.last().is_some() && down.last() == up.last() {
            down.pop();
            up.pop();
        }
        let owners = down.into_iter().rev().map(Owner::Joint);
        let owners = owners.chain([Owner::Closure(closure)]);
        let owners = owners.chain(up.into_iter().map(Owner::Joint));
        let mut axes: Vec<Axis> = Vec::new();
        let mut before = 0.0;
        for owner in owners {
            let (joint, along) = match owner {
                Owner::Joint(at) => {
                    let joint = &self.joints[at];
                    (joint, self.at_zero(&joint.child).rotation * Vector3::from(joint.axis))
                }
                Owner::Closure(at) => {
                    let closure = &self.closures[at];
                    let frame = self.at_zero(&closure.joint.parent) * isometry(&closure.poses[0]);
                    (&closure.joint, frame.rotation * Vector3::z())
                }
            };
            if joint.mimic.is_some() {
                return Vec::new();
            }
            axes.push(Axis {
                owner,
                name: joint.name.clone(),
                motion: joint.motion,
                direction: along.normalize(),
                rounding: [before, joint.rounding, 0.0],
            });
            before += joint.rounding;
        }
        for axis in &mut axes {
            axis.rounding[2] = before - axis.rounding[0] - axis.rounding[1];
        }
        axes.retain(|axis| axis.motion != Motion::Fixed);
        axes
    }
}
