//! Shapes of links, for drawings.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::{Spec, named, number, pose, quoted, vector};
use crate::robot::shapes::Shape;
use crate::robot::tree::{Link, Visual};

impl Spec<'_> {
    /// Writes the shapes of links, and the files of their meshes as comments. Beside shapes, a link
    /// without any is drawn as rods to the joints that it carries.
    pub(super) fn shapes(&self, text: &mut String) {
        let links = || self.robot.links.iter().filter(|link| !self.robot.is_world(link));
        for link in links() {
            for mesh in &link.meshes {
                let mesh = quoted(mesh);
                let _ = writeln!(
                    text,
                    "\n# Mesh of `{}`, which is not drawn: {mesh}",
                    self.frame_of(link)
                );
            }
        }
        let has_shape = |link: &&Link| link.visuals.iter().any(is_drawn);
        if !links().any(|link| has_shape(&link)) {
            return;
        }
        let mut taken = BTreeSet::new();
        for link in links() {
            for visual in link.visuals.iter().filter(|visual| is_drawn(visual)) {
                self.shape(text, &named(self.frame_of(link), &mut taken), link, visual);
            }
        }
        for link in links().filter(|link| !has_shape(link)) {
            let carried = self.robot.joints.iter().filter(|joint| joint.parent == link.name);
            for joint in carried.filter(|joint| joint.origin.xyz.iter().any(|entry| *entry != 0.0))
            {
                let Some(end) = self.frames.get(&*joint.child) else { continue };
                let (scene, frame) = (&self.scene, self.frame_of(link));
                let name = named(&format!("{frame}_to_{end}"), &mut taken);
                let _ = writeln!(
                    text,
                    "\n[define.{scene}_robot.shapes.{name}]\nframe = \"{frame}\"\nrod = \"{end}\""
                );
            }
        }
    }

    fn frame_of(&self, link: &Link) -> &str {
        &self.frames[&*link.name]
    }

    fn shape(&self, text: &mut String, name: &str, link: &Link, visual: &Visual) {
        let (scene, frame) = (&self.scene, self.frame_of(link));
        let _ = writeln!(text, "\n[define.{scene}_robot.shapes.{name}]\nframe = \"{frame}\"");
        pose(text, "centre", &visual.origin);
        let _ = match visual.shape {
            Shape::Box(half) => writeln!(text, "box = {}", vector(half.map(|half| 2.0 * half))),
            Shape::Sphere(r) => writeln!(text, "sphere = {}", number(2.0 * r)),
            Shape::Cylinder(r, h) => cylinder(text, r, h),
            Shape::Capsule(r, h) => cylinder(text, r, h + r),
            Shape::Ellipsoid(_) => Ok(()),
        };
    }
}

/// Reports whether drawings have such a shape.
fn is_drawn(visual: &Visual) -> bool {
    !matches!(visual.shape, Shape::Ellipsoid(_))
}

fn cylinder(text: &mut String, radius: f64, half: f64) -> std::fmt::Result {
    let (length, diameter) = (number(2.0 * half), number(2.0 * radius));
    writeln!(text, "cylinder = {{ length = {length}, diameter = {diameter} }}")
}
