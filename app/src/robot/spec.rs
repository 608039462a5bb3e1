//! A robot as the text of a scene.

mod drawn;
mod tendons;

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write as _;

use machinist_codegen::spec::{MAX_NAME, is_reserved};

use super::tree::{Joint, Link, Motion, Pose, Robot, WORLD};

/// Room in names for a number, and for what is appended to the name of a joint or frame: `_friction`,
/// `_turn_omega_x`.
const LONGEST_END: usize = 16;

/// A robot, with names that specs allow.
pub struct Spec<'a> {
    robot: &'a Robot,
    /// Name of the file, for comments.
    file: &'a str,
    /// Name of the scene.
    scene: String,
    frames: BTreeMap<&'a str, String>,
    coordinates: BTreeMap<&'a str, String>,
    /// Names of closures, and of their frames on both links.
    closures: Vec<[String; 3]>,
    /// Names of the frames of sites, and of centres of mass of links whose weight is compensated.
    sites: BTreeMap<&'a str, String>,
    centres: BTreeMap<&'a str, String>,
    /// Names of the lengths of tendons, and of couplings.
    tendons: BTreeMap<&'a str, String>,
    couplings: Vec<String>,
}

impl<'a> Spec<'a> {
    /// Chooses names: those of the robot, with `_` in place of other characters.
    pub fn new(robot: &'a Robot, file: &'a str) -> Self {
        let mut taken = BTreeSet::from([WORLD.to_owned()]);
        let mut frame = |name: &str| named_with(name, &FRAME, &mut taken);
        let mut frames = BTreeMap::new();
        for link in &robot.links {
            let is_world = robot.is_world(link);
            let name = if is_world { WORLD.to_owned() } else { frame(&link.name) };
            frames.insert(link.name.as_str(), name);
        }
        let own = robot.closures.iter().map(|closure| {
            let name = &closure.joint.name;
            ["", "_a", "_b"].map(|end| frame(&format!("{name}{end}")))
        });
        let closures: Vec<[String; 3]> = own.collect();
        let mut sites = BTreeMap::new();
        for site in robot.sites() {
            sites.entry(&*site.name).or_insert_with(|| frame(&site.name));
        }
        let lifted = robot.links.iter().filter(|link| link.is_lifted());
        let centres = lifted.map(|link| (&*link.name, frame(&format!("{}_centre", link.name))));
        let centres: BTreeMap<&str, String> = centres.collect();
        // Components of a frame's motion are called after it: `tool_x`, `tool_v_x`.
        let all = [&frames, &sites, &centres].into_iter().flat_map(BTreeMap::values);
        let mut taken = BTreeSet::new();
        for frame in all.chain(closures.iter().flatten()) {
            taken.extend(FRAME.map(|end| format!("{frame}{end}")));
        }
        let moving = robot.joints.iter().filter(|joint| joint.motion != Motion::Fixed);
        let coordinates = moving.map(|joint| {
            let ends: &[&str] = match joint.motion {
                Motion::Rolls => &ORIENTATION,
                Motion::Floats => &FLOATING,
                _ => &["_dot"],
            };
            (&*joint.name, named_with(&joint.name, ends, &mut taken))
        });
        let coordinates = coordinates.collect();
        let tendons = robot.tendons.iter();
        let tendons = tendons.map(|one| (&*one.name, named(&one.name, &mut taken))).collect();
        let couplings = robot.couplings.iter().map(|one| named(&one.name, &mut taken)).collect();
        let scene = named(&robot.name, &mut BTreeSet::new()).to_lowercase();
        Spec {
            robot,
            file,
            scene,
            frames,
            coordinates,
            closures,
            sites,
            centres,
            tendons,
            couplings,
        }
    }

    /// Returns the text of the scene.
    pub fn text(&self) -> String {
        let mut text = self.head();
        let Some(root) = self.robot.root() else { return text };
        for link in self.robot.order(root).into_iter().filter(|link| !self.robot.is_world(link)) {
            text.push('\n');
            let carrier = self.robot.carrier(link);
            if let Some(joint) = carrier {
                self.coordinate(&mut text, joint);
            }
            self.frame(&mut text, link, carrier);
            self.body(&mut text, link);
        }
        self.close(&mut text);
        self.lengths(&mut text);
        self.losses(&mut text);
        self.shapes(&mut text);
        text
    }

    fn head(&self) -> String {
        let Spec { scene, file, .. } = self;
        let title = quoted(&self.robot.name);
        let file = file.replace(|c: char| c.is_control(), " ");
        let source = quoted(&file);
        let gravity = vector(self.robot.gravity.unwrap_or(tendons::GRAVITY));
        format!(
            "# Imported from {file} by `machinist import`.\n\n\
             [scene]\nname = \"{scene}\"\ntitle = {title}\nsource = {source}\n\n\
             [units.robot]\nunit = \"{scene}_robot\"\n\n\
             [run]\nuntil = 1.0\npoints = 201\nrtol = 1e-8\n\n\
             [define.{scene}_robot]\ngravity = {gravity}\n"
        )
    }

    /// Writes the coordinate of a joint, and a port to drive it by.
    fn coordinate(&self, text: &mut String, joint: &Joint) {
        let scene = &self.scene;
        if joint.mimic.is_some() || joint.motion == Motion::Fixed {
            return;
        }
        let name = &self.coordinates[&*joint.name];
        let (unit, kind) = if joint.motion == Motion::Slides {
            ("m", "translational")
        } else {
            ("rad", "rotational")
        };
        if joint.motion == Motion::Rolls {
            let doc = quoted(&format!("joint {}", joint.name));
            let _ = writeln!(text, "[define.{scene}_robot.orientations.{name}]\ndoc = {doc}\n");
            return;
        }
        if joint.motion == Motion::Floats {
            for end in FLOATING {
                let _ = writeln!(
                    text,
                    "[define.{scene}_robot.coordinates.{name}{end}]\nunit = \"m\"\n"
                );
            }
            let doc = quoted(&format!("joint {}", joint.name));
            let _ =
                writeln!(text, "[define.{scene}_robot.orientations.{name}_turn]\ndoc = {doc}\n");
            return;
        }
        let doc = quoted(&format!("joint {}", joint.name));
        if let Some(limits) = &joint.limits {
            let [lower, upper] = limits.position.map(number);
            let (speed, effort) = (number(limits.velocity), number(limits.effort));
            let force = if unit == "m" { "N" } else { "N m" };
            let _ = writeln!(
                text,
                "# Limits, which nothing enforces: {lower} to {upper} {unit}, {speed} {unit}/s, \
                 {effort} {force}"
            );
        }
        let _ = writeln!(
            text,
            "[define.{scene}_robot.coordinates.{name}]\nunit = \"{unit}\"\ndoc = {doc}\n\n\
             [define.{scene}_robot.ports.{name}]\nkind = \"{kind}\"\ncoordinate = \"{name}\"\n"
        );
    }

    fn frame(&self, text: &mut String, link: &Link, carrier: Option<&Joint>) {
        let (scene, name) = (&self.scene, &self.frames[&*link.name]);
        let head = |text: &mut String, name: &str, parent: &str| {
            let _ = writeln!(text, "[define.{scene}_robot.frames.{name}]\nparent = \"{parent}\"");
        };
        let Some(joint) = carrier else { return head(text, name, "world") };
        let parent = &self.frames[&*joint.parent];
        if joint.motion == Motion::Floats {
            let base = format!("{name}_base");
            head(text, &base, parent);
            pose(text, "displacement", &joint.origin);
            text.push('\n');
            head(text, name, &base);
            let coordinate = &self.coordinates[&*joint.name];
            let [x, y, z] = FLOATING.map(|end| format!("\"{coordinate}{end}\""));
            let _ =
                writeln!(text, "displacement = [{x}, {y}, {z}]\nspherical = \"{coordinate}_turn\"");
            return;
        }
        head(text, name, parent);
        pose(text, "displacement", &joint.origin);
        if joint.motion == Motion::Rolls {
            let _ = writeln!(text, "spherical = \"{}\"", self.coordinates[&*joint.name]);
            return;
        }
        let (Some(position), axis) = (self.position(joint), vector(joint.axis)) else { return };
        let _ = match joint.motion {
            Motion::Turns => {
                writeln!(text, "revolute = {{ axis = {axis}, angle = {position} }}")
            }
            Motion::Slides => {
                writeln!(text, "prismatic = {{ axis = {axis}, displacement = {position} }}")
            }
            Motion::Fixed | Motion::Floats | Motion::Rolls => Ok(()),
        };
    }

    /// Returns the expression of a joint's position, in quotes.
    fn position(&self, joint: &Joint) -> Option<String> {
        let Some(mimic) = &joint.mimic else {
            return self.coordinates.get(&*joint.name).map(|name| quoted(name));
        };
        let unit = if joint.motion == Motion::Slides { "m" } else { "rad" };
        let mut expression = self.led(joint, "")?;
        if mimic.offset != 0.0 {
            let _ = write!(expression, " + {} [{unit}]", number(mimic.offset));
        }
        Some(quoted(&expression.replace("+ -", "- ")))
    }

    /// Returns the coordinate of a joint, or the product that gives it, with an end such as `_dot`.
    fn led(&self, joint: &Joint, end: &str) -> Option<String> {
        let Some(mimic) = &joint.mimic else {
            return self.coordinates.get(&*joint.name).map(|name| format!("{name}{end}"));
        };
        let (other, own) = (self.robot.joint(&mimic.joint)?, joint.motion);
        let leader = self.coordinates.get(&*other.name)?;
        // A length that follows an angle has a multiplier in m, and the reverse.
        let of_factor = match (own, other.motion) {
            (Motion::Slides, Motion::Turns) => " [m]",
            (Motion::Turns, Motion::Slides) => " [1/m]",
            _ => "",
        };
        Some(format!("{}{of_factor}*{leader}{end}", number(mimic.multiplier)))
    }

    /// Returns the speeds of a joint, each with true if it is one of a displacement.
    fn rates(&self, joint: &Joint) -> Vec<(String, bool)> {
        let slides = joint.motion == Motion::Slides;
        let Some(rate) = self.led(joint, "_dot") else { return Vec::new() };
        let name = rate.trim_end_matches("_dot");
        let turns = |name: &str| ["x", "y", "z"].map(|end| (format!("{name}_omega_{end}"), false));
        match joint.motion {
            Motion::Fixed => Vec::new(),
            Motion::Turns | Motion::Slides if joint.mimic.is_some() => {
                vec![(format!("({rate})"), slides)]
            }
            Motion::Turns | Motion::Slides => vec![(rate, slides)],
            Motion::Rolls => turns(name).to_vec(),
            Motion::Floats => {
                let slides = FLOATING.map(|end| (format!("{name}{end}_dot"), true));
                slides.into_iter().chain(turns(&format!("{name}_turn"))).collect()
            }
        }
    }

    fn body(&self, text: &mut String, link: &Link) {
        let Some(inertial) = link.inertial.as_ref().filter(|inertial| !inertial.is_zero()) else {
            return;
        };
        let (scene, name) = (&self.scene, &self.frames[&*link.name]);
        let _ = writeln!(text, "\n[define.{scene}_robot.bodies.{name}]\nframe = \"{name}\"");
        let _ = writeln!(text, "mass = {}", number(inertial.mass));
        pose(text, "centre", &inertial.origin);
        let keys = ["xx", "yy", "zz", "xy", "xz", "yz"];
        let entries = keys.iter().zip(inertial.inertia).filter(|(_, value)| *value != 0.0);
        let entries: Vec<String> =
            entries.map(|(key, value)| format!("{key} = {}", number(value))).collect();
        if !entries.is_empty() {
            let _ = writeln!(text, "inertia = {{ {} }}", entries.join(", "));
        }
    }

    /// Writes the constraints of joints that close loops.
    fn close(&self, text: &mut String) {
        let scene = &self.scene;
        for (closure, [name, a, b]) in self.robot.closures.iter().zip(&self.closures) {
            let joint = &closure.joint;
            let links = [&joint.parent, &joint.child];
            for ((frame, link), at) in [a, b].into_iter().zip(links).zip(&closure.poses) {
                let parent = &self.frames[link.as_str()];
                let head =
                    format!("\n[define.{scene}_robot.frames.{frame}]\nparent = \"{parent}\"");
                let _ = writeln!(text, "{head}");
                pose(text, "displacement", at);
            }
            let of_gap =
                |way: &str| format!("{way}_of(in_frame(position({b}) - position({a}), {a}))");
            for end in closure.constraints() {
                let formula = match *end {
                    "tilt_x" => format!("dot(x_axis({a}), z_axis({b}))"),
                    "tilt_y" => format!("dot(y_axis({a}), z_axis({b}))"),
                    "turn" => format!("dot(x_axis({a}), y_axis({b}))"),
                    way => of_gap(way),
                };
                let _ = write!(
                    text,
                    "\n[define.{scene}_robot.constraints.{name}_{end}]\nexpression = \"{formula}\"\n"
                );
            }
        }
    }

    /// Writes damping as dissipation, and dry friction.
    fn losses(&self, text: &mut String) {
        let scene = &self.scene;
        let moving = || {
            let moving = self.robot.joints.iter();
            moving.filter(|joint| matches!(joint.motion, Motion::Turns | Motion::Slides))
        };
        let slides = |joint: &Joint| joint.motion == Motion::Slides;
        let quadratic = |of: fn(&Joint) -> f64, [sliding, turning]: [&str; 2]| {
            let all = self.robot.joints.iter().filter(|joint| of(joint) > 0.0);
            let terms = all.flat_map(|joint| {
                self.rates(joint).into_iter().map(|(rate, slides)| {
                    let unit = if slides { sliding } else { turning };
                    format!("{} [{unit}]*{rate}^2/2", number(of(joint)))
                })
            });
            terms.collect::<Vec<_>>()
        };
        let damped = quadratic(|joint| joint.damping, ["N s/m", "N m s/rad"]);
        let kinetic = quadratic(|joint| joint.armature, ["kg", "kg m^2"]);
        let potential = moving().filter(|joint| joint.spring[0] > 0.0).map(|joint| {
            let units = if slides(joint) { ["N/m", "m"] } else { ["N m/rad", "rad"] };
            let position = self.position(joint).unwrap_or_default();
            let position = position.trim_matches('"');
            let [stiffness, rest] = joint.spring;
            let way = match (rest == 0.0, joint.mimic.is_some()) {
                (true, false) => position.to_owned(),
                (true, true) => format!("({position})"),
                _ => format!("({position} - {} [{}])", number(rest), units[1]).replace("- -", "+ "),
            };
            format!("{} [{}]*{way}^2/2", number(stiffness), units[0])
        });
        let [mut kinetic, mut damped, mut potential] = [kinetic, damped, potential.collect()];
        potential.extend(self.lifts());
        for (all, more) in [&mut kinetic, &mut potential, &mut damped].into_iter().zip(self.along())
        {
            all.extend(more);
        }
        let energies = [("kinetic", kinetic), ("potential", potential), ("dissipation", damped)];
        if energies.iter().any(|(_, terms)| !terms.is_empty()) {
            let _ = write!(text, "\n[define.{scene}_robot.energy]\n");
        }
        for (key, terms) in energies.iter().filter(|(_, terms)| !terms.is_empty()) {
            let terms = terms.join(" + \\\n  ");
            let _ = writeln!(text, "{key} = \"\"\"\\\n  {terms}\"\"\"");
        }
        let mut taken = BTreeSet::new();
        for joint in self.robot.joints.iter().filter(|joint| joint.friction > 0.0) {
            for (rate, slides) in self.rates(joint) {
                let name = named(&joint.name, &mut taken);
                let unit = if slides { "N" } else { "N m" };
                self.friction(text, &name, joint.friction, &rate, unit);
            }
        }
        self.friction_along(text, &mut taken);
    }

    fn friction(&self, text: &mut String, name: &str, force: f64, rate: &str, unit: &str) {
        let (scene, force) = (&self.scene, number(force));
        let _ = write!(
            text,
            "\n[define.{scene}_robot.friction.{name}_friction]\nspeed = \"{rate}\"\n\
             sliding = \"{force} [{unit}]\"\nunit = \"{unit}\"\n"
        );
    }
}

/// Ends of the names of a frame's motion.
const FRAME: [&str; 9] =
    ["_x", "_y", "_z", "_v_x", "_v_y", "_v_z", "_omega_x", "_omega_y", "_omega_z"];

/// Ends of the names of an orientation's parts and rates.
const ORIENTATION: [&str; 7] = ["_x", "_y", "_z", "_w", "_omega_x", "_omega_y", "_omega_z"];

/// Coordinates of a floating joint besides its orientation: the ends of their names.
const FLOATING: [&str; 3] = ["_px", "_py", "_pz"];

/// Writes a position under a key, and a rotation, without zeros.
fn pose(text: &mut String, key: &str, pose: &Pose) {
    if pose.xyz.iter().any(|entry| *entry != 0.0) {
        let _ = writeln!(text, "{key} = {}", vector(pose.xyz));
    }
    if pose.rpy.iter().any(|entry| *entry != 0.0) {
        let angles = pose.rpy.map(angle).join(", ");
        let _ = writeln!(text, "rotation = {{ roll_pitch_yaw = [{angles}] }}");
    }
}

/// Writes an angle; quarter turns as such, so that their sines are exact.
fn angle(value: f64) -> String {
    let quarters = (value / FRAC_PI_2).round();
    let is_quarter = (value - quarters * FRAC_PI_2).abs() <= f64::EPSILON * value.abs();
    if value != 0.0 && is_quarter { format!("\"{quarters}*pi/2\"") } else { number(value) }
}

fn vector(values: [f64; 3]) -> String {
    format!("[{}]", values.map(number).join(", "))
}

fn number(value: f64) -> String {
    // Minus zero is zero.
    format!("{:?}", if value == 0.0 { 0.0 } else { value })
}

/// Returns a TOML string.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => quoted.push(' '),
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

/// Returns a name of letters, digits and `_` that is not taken, and takes it.
fn named(name: &str, taken: &mut BTreeSet<String>) -> String {
    named_with(name, &[], taken)
}

/// Returns a name that is not taken, nor with any of some ends, and takes them.
fn named_with(name: &str, ends: &[&str], taken: &mut BTreeSet<String>) -> String {
    let is_allowed = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let allowed: String = name.chars().map(|c| if is_allowed(c) { c } else { '_' }).collect();
    let mut own = allowed.trim_matches('_').to_owned();
    while own.contains("__") {
        own = own.replace("__", "_");
    }
    if !own.starts_with(|c: char| c.is_ascii_alphabetic()) {
        own.insert_str(0, "n_");
    }
    // Names are ASCII.
    own.truncate(MAX_NAME - LONGEST_END);
    let mut count = 1;
    loop {
        let candidate = if count == 1 { own.clone() } else { format!("{own}_{count}") };
        let names: Vec<String> =
            [""].iter().chain(ends).map(|end| format!("{candidate}{end}")).collect();
        if !is_reserved(&candidate) && names.iter().all(|name| !taken.contains(name)) {
            taken.extend(names);
            return candidate;
        }
        count += 1;
    }
}
