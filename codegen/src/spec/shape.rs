//! Shapes of bodies in drawings: `[shapes.NAME]` of a unit. They have no effect on the motion.

use crate::spec::Formula;
use crate::spec::body::{Components, RotationSpec, components_of, rotations, vector};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Spanned};
use crate::spec::fields::{Fields, Findings};
use crate::spec::names::quoted;
use crate::spec::toml::{Entry, Tree};

/// A shape that is fixed to a frame, or lies between two frames.
#[derive(Debug, Clone, PartialEq)]
pub struct ShapeSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// The frame it is fixed to.
    pub frame: Spanned<String>,
    /// Its centre, along the axes of the frame \[m\].
    pub centre: Option<Components>,
    /// Rotations of its axes relative to those of the frame.
    pub rotations: Vec<RotationSpec>,
    /// Its form.
    pub form: FormSpec,
    /// Meaning.
    pub doc: String,
}

/// Form of a shape.
#[derive(Debug, Clone, PartialEq)]
pub enum FormSpec {
    /// Box with these edges along its axes \[m\].
    Box(Box<Components>),
    /// Cylinder.
    Cylinder(Box<CylinderSpec>),
    /// Sphere of a diameter \[m\].
    Sphere(Formula),
    /// Rod to the origin of another frame.
    Rod(Spanned<String>),
    /// Spring to the origin of another frame.
    Spring(Spanned<String>),
}

/// A cylinder about its centre.
#[derive(Debug, Clone, PartialEq)]
pub struct CylinderSpec {
    /// Direction of its axis; z if absent.
    pub axis: Option<Components>,
    /// Length along the axis \[m\].
    pub length: Formula,
    /// Outer diameter \[m\].
    pub diameter: Formula,
}

/// Reads a shape of a unit.
pub fn shape(entry: &Entry, found: &mut Findings) -> Option<ShapeSpec> {
    let name = entry.key.clone();
    let mut fields = Fields::open(&entry.value, format!("shape {}", quoted(&name.value)), found);
    let frame = fields.required_text("frame");
    let centre = vector("centre", &mut fields);
    let rotations = rotations(&mut fields);
    let edges = fields
        .take("box")
        .and_then(|tree| components_of(tree, "box", "the edges along x, y, z", &mut fields));
    let cylinder = fields.take("cylinder").and_then(|tree| cylinder(tree, fields.found()));
    let sphere = fields.formula("sphere");
    let [rod, spring] =
        ["rod", "spring"].map(|key| fields.take(key).and_then(|tree| fields.as_text(tree, key)));
    let doc = fields.text("doc");
    let forms: Vec<FormSpec> = [
        edges.map(|edges| FormSpec::Box(Box::new(edges))),
        cylinder.map(|cylinder| FormSpec::Cylinder(Box::new(cylinder))),
        sphere.map(FormSpec::Sphere),
        rod.map(FormSpec::Rod),
        spring.map(FormSpec::Spring),
    ]
    .into_iter()
    .flatten()
    .collect();
    let count = forms.len();
    let form = forms.into_iter().next().filter(|_| count == 1);
    if form.is_none() {
        let message = format!("shape {} needs exactly one form", quoted(&name.value));
        let help = "write box = [x, y, z], cylinder = { length = 1, diameter = 0.1 }, sphere = \
                    diameter, rod = \"frame\" or spring = \"frame\"";
        fields
            .found()
            .mistakes
            .push(Mistake::new(Code::ConflictingKeys, name.span, message, "its form").help(help));
    }
    fields.close();
    Some(ShapeSpec { name, frame: frame?, centre, rotations, form: form?, doc })
}

fn cylinder(tree: &Spanned<Tree>, found: &mut Findings) -> Option<CylinderSpec> {
    let mut fields = Fields::open(tree, "`cylinder`".to_owned(), found);
    let axis = vector("axis", &mut fields);
    for key in ["length", "diameter"] {
        fields.require(key);
    }
    let [length, diameter] = ["length", "diameter"].map(|key| fields.formula(key));
    fields.close();
    Some(CylinderSpec { axis, length: length?, diameter: diameter? })
}
