//! Tendons, couplings and compensated weights in a scene.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::{Spec, named, number, pose};
use crate::robot::shapes;
use crate::robot::tendons::{Length, Path, Segment, Site, Tendon};
use crate::robot::tree::{Joint, Link, Motion, Pose, Robot};

/// Acceleration of free fall, if a file gives none \[m/s^2\].
pub(super) const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

impl Robot {
    /// Returns the sites between which tendons run.
    pub(super) fn sites(&self) -> impl Iterator<Item = &Site> {
        let segments = self.tendons.iter().flat_map(|tendon| match &tendon.path {
            Path::Segments(segments) => &segments[..],
            Path::Joints(_) => &[],
        });
        segments.flat_map(|segment| &segment.ends)
    }
}

impl Link {
    /// Reports whether a share of its weight is compensated.
    pub(super) fn is_lifted(&self) -> bool {
        self.compensation != 0.0 && self.inertial.is_some_and(|inertial| inertial.mass > 0.0)
    }
}

impl Spec<'_> {
    /// Writes sites, lengths of tendons and equations between them, and compensated centres of mass.
    pub(super) fn lengths(&self, text: &mut String) {
        let mut written = BTreeSet::new();
        for site in self.robot.sites().filter(|site| written.insert(&*site.name)) {
            self.point(text, &self.sites[&*site.name], &site.link, &shapes::pose(&site.at));
        }
        for link in &self.robot.links {
            if let (Some(name), Some(inertial)) = (self.centres.get(&*link.name), link.inertial) {
                let at = Pose { rpy: [0.0; 3], ..inertial.origin };
                self.point(text, name, &link.name, &at);
            }
        }
        let scene = &self.scene;
        for tendon in &self.robot.tendons {
            let (name, unit) = (&self.tendons[&*tendon.name], self.unit(tendon));
            let length = self.length(tendon);
            let _ = write!(
                text,
                "\n[define.{scene}_robot.helpers.{name}]\nexpression = \"{length}\"\nunit = \"{unit}\"\n"
            );
        }
        for (coupling, name) in self.robot.couplings.iter().zip(&self.couplings) {
            let Some((of, own)) = self.moved_from_zero(&coupling.of) else { continue };
            let by = coupling.by.as_ref().and_then(|by| self.moved_from_zero(by));
            let mut expression = of;
            for (power, factor) in coupling.coefficients.iter().enumerate() {
                let dimension = i32::from(own == "m")
                    - match &by {
                        Some((_, "m")) => power as i32,
                        _ => 0,
                    };
                let unit = match dimension {
                    0 => String::new(),
                    1 => " [m]".to_owned(),
                    -1 => " [1/m]".to_owned(),
                    _ => format!(" [1/m^{}]", -dimension),
                };
                let times = match (power, &by) {
                    (0, _) => String::new(),
                    (_, None) => continue,
                    (1, Some((by, _))) => format!("*({by})"),
                    (_, Some((by, _))) => format!("*({by})^{power}"),
                };
                if *factor != 0.0 {
                    let _ = write!(expression, " - {}{unit}{times}", number(*factor));
                }
            }
            let expression = expression.replace("- -", "+ ");
            let _ = write!(
                text,
                "\n[define.{scene}_robot.constraints.{name}]\nexpression = \"{expression}\"\n"
            );
        }
    }

    fn point(&self, text: &mut String, name: &str, link: &str, at: &Pose) {
        let (scene, parent) = (&self.scene, &self.frames[link]);
        let _ = write!(text, "\n[define.{scene}_robot.frames.{name}]\nparent = \"{parent}\"\n");
        pose(text, "displacement", at);
    }

    /// Returns a length from that with all joints at zero, and its unit; `None` if it does not move.
    fn moved_from_zero(&self, length: &Length) -> Option<(String, &'static str)> {
        match length {
            Length::Joint(name) => {
                let joint = self.robot.joint(name)?;
                let unit = if joint.motion == Motion::Slides { "m" } else { "rad" };
                Some((self.bare_position(joint)?, unit))
            }
            Length::Tendon(name) => {
                let tendon = self.robot.tendons.iter().find(|tendon| tendon.name == *name)?;
                let (name, unit) = (&self.tendons[name.as_str()], self.unit(tendon));
                let zero = match &tendon.path {
                    Path::Joints(_) => return Some((name.clone(), unit)),
                    Path::Segments(segments) => self.robot.distance(segments, false),
                };
                Some((format!("{name} - {} [{unit}]", number(zero)), unit))
            }
        }
    }

    fn bare_position(&self, joint: &Joint) -> Option<String> {
        Some(self.position(joint)?.trim_matches('"').to_owned())
    }

    /// Returns the unit of the length of a tendon.
    fn unit(&self, tendon: &Tendon) -> &'static str {
        match &tendon.path {
            Path::Joints(joints) if !joints.iter().any(|(name, _)| self.slides(name)) => "rad",
            _ => "m",
        }
    }

    fn slides(&self, joint: &str) -> bool {
        self.robot.joint(joint).is_some_and(|joint| joint.motion == Motion::Slides)
    }

    /// Returns the expression of the length of a tendon.
    fn length(&self, tendon: &Tendon) -> String {
        let unit = self.unit(tendon);
        let terms: Vec<String> = match &tendon.path {
            Path::Joints(joints) => {
                let term = |(name, share): &(String, f64)| {
                    let position = self.bare_position(self.robot.joint(name)?)?;
                    let metres = if unit == "m" && !self.slides(name) { " [m]" } else { "" };
                    let whole =
                        if position.contains(' ') { format!("({position})") } else { position };
                    Some(times(*share, metres) + whole.as_str())
                };
                joints.iter().filter_map(term).collect()
            }
            Path::Segments(segments) => {
                let term = |Segment { ends, share }: &Segment| {
                    let [a, b] = ends.each_ref().map(|site| &self.sites[&*site.name]);
                    format!("{}norm(position({b}) - position({a}))", times(*share, ""))
                };
                segments.iter().map(term).collect()
            }
        };
        let sum = terms.join(" + ").replace("+ -", "- ");
        if sum.is_empty() { format!("0 [{unit}]") } else { sum }
    }

    /// Returns terms of the kinetic and potential energies and of the dissipation of tendons.
    pub(super) fn along(&self) -> [Vec<String>; 3] {
        let mut terms = [const { Vec::new() }; 3];
        for tendon in &self.robot.tendons {
            let (name, unit) = (&self.tendons[&*tendon.name], self.unit(tendon));
            let force = if unit == "m" { "N" } else { "N m" };
            let [lower, upper] = tendon.rest.map(number);
            // Distances are positive.
            let is_above = tendon.rest[0] <= 0.0 && matches!(tendon.path, Path::Segments(_));
            let stretched = format!("max({name} - {upper} [{unit}], 0 [{unit}])");
            let stretch = if lower == upper {
                format!("({name} - {upper} [{unit}])")
            } else if is_above {
                stretched
            } else {
                format!("({stretched} + min({name} - {lower} [{unit}], 0 [{unit}]))")
            };
            let stretch = stretch.replace("- -", "+ ");
            let inertia = if unit == "m" { "kg" } else { "kg m^2" };
            let rate = format!("der({name})");
            for (all, factor, unit, of) in [
                (0, tendon.armature, inertia.to_owned(), &rate),
                (1, tendon.stiffness, format!("{force}/{unit}"), &stretch),
                (2, tendon.damping, format!("{force} s/{unit}"), &rate),
            ] {
                if factor > 0.0 {
                    terms[all].push(format!("{} [{unit}]*{of}^2/2", number(factor)));
                }
            }
        }
        terms
    }

    /// Writes the friction of tendons.
    pub(super) fn friction_along(&self, text: &mut String, taken: &mut BTreeSet<String>) {
        for tendon in self.robot.tendons.iter().filter(|tendon| tendon.friction > 0.0) {
            let name = named(&tendon.name, taken);
            let unit = if self.unit(tendon) == "m" { "N" } else { "N m" };
            let rate = format!("der({})", self.tendons[&*tendon.name]);
            self.friction(text, &name, tendon.friction, &rate, unit);
        }
    }

    /// Returns the potential energies that compensate weights.
    pub(super) fn lifts(&self) -> Vec<String> {
        let gravity = self.robot.gravity.unwrap_or(GRAVITY);
        let term = |link: &Link| {
            let (name, mass) = (self.centres.get(&*link.name)?, link.inertial?.mass);
            let [x, y, z] = gravity.map(|g| number(g * link.compensation * mass));
            Some(format!("dot(vector({x} [N], {y} [N], {z} [N]), position({name}))"))
        };
        self.robot.links.iter().filter_map(term).collect()
    }
}

/// Returns the beginning of a product with a factor, which is empty for 1.
fn times(factor: f64, unit: &str) -> String {
    let factor = number(factor) + unit;
    if factor == "1.0" { String::new() } else { factor + "*" }
}
