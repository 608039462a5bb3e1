//! Frames and rigid bodies: `[frames.NAME]`, `[orientations.NAME]`, `[bodies.NAME]` and `gravity`
//! of a unit.

use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::dimension::Unit;
use crate::spec::fields::{Fields, Findings};
use crate::spec::measure::Factor;
use crate::spec::names::quoted;
use crate::spec::toml::{Entry, Tree};
use crate::spec::{CoordinateSpec, Declared, Formula};

/// Radius of gyration below which a moment of inertia is rounding of a file \[m\].
pub const ROUNDED_GYRATION: f64 = 1e-6;

/// Name of the frame that does not move.
pub const WORLD: &str = "world";

/// Three components.
pub type Components = [Formula; 3];

/// A frame: its parent, moved, turned, and moved by a joint, in this order.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// The frame it is given relative to; the world if absent.
    pub parent: Option<Spanned<String>>,
    /// True for a frame that is given by what is joined to its port alone.
    pub is_joined: bool,
    /// Position of the origin, along the parent's axes \[m\].
    pub displacement: Option<Components>,
    /// Rotations, each about the axes that the preceding ones have turned.
    pub rotations: Vec<RotationSpec>,
    /// Rotation about an axis along the axes so far, by an angle \[rad\].
    pub revolute: Option<AxisSpec>,
    /// The orientation by which it turns freely.
    pub spherical: Option<Spanned<String>>,
    /// Motion along an axis, by a length \[m\].
    pub prismatic: Option<AxisSpec>,
    /// Meaning.
    pub doc: String,
}

impl FrameSpec {
    /// Returns the frame of a port that is given by what is joined to it.
    #[must_use]
    pub fn joined(name: &Spanned<String>) -> Self {
        FrameSpec {
            name: name.clone(),
            parent: None,
            is_joined: true,
            displacement: None,
            rotations: Vec::new(),
            revolute: None,
            spherical: None,
            prismatic: None,
            doc: String::new(),
        }
    }
}

/// A force and a torque that act on a body at a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// The frame at whose origin they act, and with which the body moves.
    pub frame: Spanned<String>,
    /// The frame of the body that takes the reaction, at the same point; none if absent.
    pub against: Option<Spanned<String>>,
    /// The frame along whose axes they are given; the world if absent.
    pub axes: Option<Spanned<String>>,
    /// Components of the force \[N\].
    pub force: Option<Components>,
    /// Components of the torque \[N m\].
    pub torque: Option<Components>,
    /// True if they only convert energy of the first-order states.
    pub conversion: bool,
    /// Meaning.
    pub doc: String,
}

/// An orientation: a unit quaternion whose velocities are the rates about the turned axes.
#[derive(Debug, Clone, PartialEq)]
pub struct OrientationSpec {
    /// Its name, from which those of its parts follow.
    pub name: Spanned<String>,
    /// Rotations at the start.
    pub rotations: Vec<RotationSpec>,
    /// Typical size of the rates.
    pub velocity_scale: f64,
    /// Meaning.
    pub doc: String,
}

impl OrientationSpec {
    /// Returns the name of the quaternion's part w.
    #[must_use]
    pub fn scalar(&self) -> Spanned<String> {
        Spanned { value: format!("{}_w", self.name.value), span: self.name.span }
    }

    /// Returns the coordinates: the parts x, y and z, and their velocities.
    #[must_use]
    pub fn coordinates(&self, number: usize) -> [CoordinateSpec; 3] {
        let OrientationSpec { name, velocity_scale, doc, .. } = self;
        let span = name.span;
        let called = |end: &str| Spanned { value: format!("{}_{end}", name.value), span };
        ["x", "y", "z"].map(|axis| CoordinateSpec {
            name: called(axis),
            velocity: called(&format!("omega_{axis}")),
            acceleration: called(&format!("alpha_{axis}")),
            unit: Declared {
                text: "1".to_owned(),
                unit: Unit::default(),
                factor: Factor::one(),
                span,
            },
            orientation: Some(number),
            doc: if doc.is_empty() {
                format!("part {axis} of {}", name.value)
            } else {
                doc.clone()
            },
            scale: [1.0, *velocity_scale],
            is_fixed: false,
        })
    }
}

/// A rotation of a frame.
#[derive(Debug, Clone, PartialEq)]
pub enum RotationSpec {
    /// About an axis by an angle.
    Axis(AxisSpec),
    /// About coordinate axes (0, 1, 2) by angles, each about the axes turned so far.
    Sequence(Vec<(usize, Formula)>),
    /// A constant unit quaternion w, x, y, z.
    Quaternion([Formula; 4], Span),
}

/// An axis, and the angle about it or the length along it.
#[derive(Debug, Clone, PartialEq)]
pub struct AxisSpec {
    /// A vector of any length along the axis.
    pub axis: Components,
    /// Angle or length.
    pub by: Formula,
    /// Source span.
    pub span: Span,
}

/// A rigid body.
#[derive(Debug, Clone, PartialEq)]
pub struct BodySpec {
    /// Its name.
    pub name: Spanned<String>,
    /// The frame it is fixed to.
    pub frame: Spanned<String>,
    /// Mass \[kg\].
    pub mass: Formula,
    /// Centre of mass, along the axes of the frame \[m\].
    pub centre: Option<Components>,
    /// Inertia about the centre: xx, yy, zz, xy, xz, yz \[kg m^2\].
    pub inertia: [Option<Formula>; 6],
    /// Rotations of the axes of `inertia` relative to those of the frame.
    pub rotations: Vec<RotationSpec>,
    /// Meaning.
    pub doc: String,
}

/// Keys of `inertia`, in the order of [`BodySpec::inertia`].
pub const INERTIA: [&str; 6] = ["xx", "yy", "zz", "xy", "xz", "yz"];

/// Reads a frame of a unit.
pub fn frame(entry: &Entry, found: &mut Findings) -> Option<FrameSpec> {
    let name = entry.key.clone();
    let mut fields = Fields::open(&entry.value, format!("frame {}", quoted(&name.value)), found);
    if name.value == WORLD {
        let mistake = Mistake::new(
            Code::InvalidName,
            name.span,
            "`world` is the frame that does not move",
            "taken",
        );
        fields.found().mistakes.push(mistake.help("choose another name"));
    }
    let parent = fields.take("parent").and_then(|tree| fields.as_text(tree, "parent"));
    let displacement = vector("displacement", &mut fields);
    let rotations = rotations(&mut fields);
    let revolute =
        fields.take("revolute").and_then(|tree| axis(tree, "revolute", "angle", fields.found()));
    let spherical = fields.take("spherical").and_then(|tree| fields.as_text(tree, "spherical"));
    if let (Some(_), Some(spherical)) = (&revolute, &spherical) {
        let message = "a frame has `revolute` or `spherical`, not both";
        let mistake = Mistake::new(Code::ConflictingKeys, spherical.span, message, "besides");
        fields.found().mistakes.push(mistake.help("put one of them into a frame between"));
    }
    let prismatic = fields
        .take("prismatic")
        .and_then(|tree| axis(tree, "prismatic", "displacement", fields.found()));
    let doc = fields.text("doc");
    fields.close();
    Some(FrameSpec {
        name,
        parent,
        is_joined: false,
        displacement,
        rotations,
        revolute,
        spherical,
        prismatic,
        doc,
    })
}

/// Reads a force and a torque at a frame of a unit.
pub fn load(entry: &Entry, found: &mut Findings) -> Option<LoadSpec> {
    let name = entry.key.clone();
    let mut fields = Fields::open(&entry.value, format!("load {}", quoted(&name.value)), found);
    let frame = fields.required_text("frame");
    let [against, axes] =
        ["against", "axes"].map(|key| fields.take(key).and_then(|tree| fields.as_text(tree, key)));
    let (force, torque) = (vector("force", &mut fields), vector("torque", &mut fields));
    let conversion = fields.flag("conversion");
    let doc = fields.text("doc");
    if force.is_none() && torque.is_none() {
        let message = format!("load {} has neither `force` nor `torque`", quoted(&name.value));
        let mistake = Mistake::new(Code::NoEffect, name.span, message, "no effect");
        fields.found().mistakes.push(mistake.help("write force = [\"F\", 0, 0]"));
    }
    fields.close();
    Some(LoadSpec { name, frame: frame?, against, axes, force, torque, conversion, doc })
}

/// Reads an orientation of a unit.
pub fn orientation(entry: &Entry, found: &mut Findings) -> Option<OrientationSpec> {
    let name = entry.key.clone();
    let what = format!("orientation {}", quoted(&name.value));
    let mut fields = Fields::open(&entry.value, what, found);
    let rotations = rotations(&mut fields);
    let velocity_scale = fields.scale("velocity_scale");
    let doc = fields.text("doc");
    fields.close();
    Some(OrientationSpec { name, rotations, velocity_scale, doc })
}

/// Reads a body of a unit.
pub fn body(entry: &Entry, found: &mut Findings) -> Option<BodySpec> {
    let name = entry.key.clone();
    let mut fields = Fields::open(&entry.value, format!("body {}", quoted(&name.value)), found);
    let frame = fields.required_text("frame");
    fields.require("mass");
    let mass = fields.formula("mass");
    let centre = vector("centre", &mut fields);
    let inertia = fields.take("inertia").map(|tree| inertia(tree, fields.found()));
    let rotations = rotations(&mut fields);
    let doc = fields.text("doc");
    fields.close();
    let inertia = inertia.unwrap_or_default();
    Some(BodySpec { name, frame: frame?, mass: mass?, centre, inertia, rotations, doc })
}

fn inertia(tree: &Spanned<Tree>, found: &mut Findings) -> [Option<Formula>; 6] {
    let mut fields = Fields::open(tree, "`inertia`".to_owned(), found);
    let inertia = INERTIA.map(|key| fields.formula(key));
    fields.close();
    inertia
}

/// Reads three components, if present.
pub fn vector(key: &'static str, fields: &mut Fields<'_>) -> Option<Components> {
    let tree = fields.take(key)?;
    components_of(tree, key, "the components x, y, z", fields)
}

/// Reads a list of exactly N formulas.
pub fn components_of<const N: usize>(
    tree: &Spanned<Tree>,
    key: &str,
    what: &str,
    fields: &mut Fields<'_>,
) -> Option<[Formula; N]> {
    let Tree::List(items) = &tree.value else {
        return fields.wrong(tree, key, &format!("a list of {what}"));
    };
    let read: Vec<Formula> = items.iter().filter_map(|item| fields.as_formula(item, key)).collect();
    if items.len() != N {
        let message = format!("{} has {N} entries, {what}, not {}", quoted(key), items.len());
        fields.found().mistakes.push(Mistake::new(
            Code::WrongType,
            tree.span,
            message,
            "wrong length",
        ));
        return None;
    }
    read.try_into().ok()
}

fn axis(
    tree: &Spanned<Tree>,
    what: &str,
    by: &'static str,
    found: &mut Findings,
) -> Option<AxisSpec> {
    let mut fields = Fields::open(tree, format!("`{what}`"), found);
    fields.require("axis");
    let axis = vector("axis", &mut fields);
    fields.require(by);
    let by = fields.formula(by);
    fields.close();
    Some(AxisSpec { axis: axis?, by: by?, span: tree.span })
}

/// Reads `rotation`: one, or a list of them.
pub fn rotations(fields: &mut Fields<'_>) -> Vec<RotationSpec> {
    match fields.take("rotation") {
        None => Vec::new(),
        Some(Spanned { value: Tree::List(items), .. }) => {
            items.iter().filter_map(|item| rotation(item, fields.found())).collect()
        }
        Some(tree @ Spanned { value: Tree::Table(_), .. }) => {
            rotation(tree, fields.found()).into_iter().collect()
        }
        Some(tree) => {
            fields.wrong(tree, "rotation", "a table or a list of tables").unwrap_or_default()
        }
    }
}

/// Reads a rotation: `axis` and `angle`, `sequence` and `angles`, `roll_pitch_yaw` or `quaternion`.
fn rotation(tree: &Spanned<Tree>, found: &mut Findings) -> Option<RotationSpec> {
    let mut fields = Fields::open(tree, "`rotation`".to_owned(), found);
    let axis = vector("axis", &mut fields);
    let angle = fields.formula("angle");
    let sequence = fields.take("sequence").and_then(|tree| fields.as_text(tree, "sequence"));
    let angles = vector("angles", &mut fields);
    let roll_pitch_yaw = vector("roll_pitch_yaw", &mut fields);
    let quaternion = fields
        .take("quaternion")
        .and_then(|tree| components_of(tree, "quaternion", "the parts w, x, y, z", &mut fields));
    let span = fields.span;
    let given = match (axis, angle, sequence, angles, roll_pitch_yaw, quaternion) {
        (Some(axis), Some(by), None, None, None, None) => {
            Some(RotationSpec::Axis(AxisSpec { axis, by, span: tree.span }))
        }
        (None, None, Some(sequence), Some(angles), None, None) => {
            let order = order_of(&sequence, fields.found());
            order.map(|order| RotationSpec::Sequence(order.into_iter().zip(angles).collect()))
        }
        (None, None, None, None, Some([roll, pitch, yaw]), None) => {
            // About the fixed axes x, y, z: the same as about the turned axes z, y, x.
            Some(RotationSpec::Sequence(vec![(2, yaw), (1, pitch), (0, roll)]))
        }
        (None, None, None, None, None, Some(parts)) => {
            Some(RotationSpec::Quaternion(parts, tree.span))
        }
        _ => {
            let message = "a rotation is given in one of four ways";
            let help = "write { axis = [0, 0, 1], angle = \"a\" }, { sequence = \"zxz\", angles = \
                        [\"a\", \"b\", \"c\"] }, { roll_pitch_yaw = [0, 0, 1.57] } or { quaternion \
                        = [1, 0, 0, 0] }";
            let mistake = Mistake::new(Code::ConflictingKeys, span, message, "not one of them");
            fields.found().mistakes.push(mistake.help(help));
            None
        }
    };
    fields.close();
    given
}

/// Reads a sequence of axes, such as `zxz`.
fn order_of(sequence: &Spanned<String>, found: &mut Findings) -> Option<[usize; 3]> {
    let axes: Option<Vec<usize>> = sequence
        .value
        .chars()
        .map(|axis| ['x', 'y', 'z'].iter().position(|a| *a == axis))
        .collect();
    let order = axes.and_then(|axes| <[usize; 3]>::try_from(axes).ok());
    let order = order.filter(|[a, b, c]| a != b && b != c);
    if order.is_none() {
        let message = format!("{} is not a sequence of axes", quoted(&sequence.value));
        let help = "write three letters of x, y and z without equal neighbours, such as \"zxz\"";
        found
            .mistakes
            .push(Mistake::new(Code::UnknownChoice, sequence.span, message, "unknown").help(help));
    }
    order
}
