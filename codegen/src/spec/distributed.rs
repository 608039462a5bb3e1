//! Fields: `[fields.NAME]` of a unit, and the settings of a scene for them.

use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Spanned};
use crate::spec::expression::Ast;
use crate::spec::fields::{Fields, Findings};
use crate::spec::names::{self, did_you_mean, quoted};
use crate::spec::toml::Entry;
use crate::spec::{CoordinateSpec, Declared, Formula, PortSpec};

/// Maximum number of elements of a field.
pub const MAX_ELEMENTS: f64 = 1e6;
/// Maximum order of the elements.
pub const MAX_ORDER: f64 = 16.0;

/// Boundary conditions by name.
pub const BOUNDARIES: &[(&str, Boundary)] = &[("free", Boundary::Free), ("fixed", Boundary::Fixed)];

/// A one-dimensional field, given by its densities per length.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// Name of its rate.
    pub rate: Spanned<String>,
    /// Name of its derivative along the field.
    pub gradient: Spanned<String>,
    /// Name of the rate of that derivative.
    pub gradient_rate: Spanned<String>,
    /// Unit of the field.
    pub unit: Declared,
    /// Meaning.
    pub doc: String,
    /// Typical sizes of field and rate.
    pub scale: [f64; 2],
    /// The parameter that gives its length.
    pub over: Spanned<String>,
    /// T, V, D per length.
    pub densities: [Option<Ast>; 3],
    /// Q per length.
    pub force: Option<Ast>,
    /// Boundary conditions at x = 0 and at x = length, unless a scene sets others.
    pub ends: [Boundary; 2],
}

/// Boundary condition at an end of a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Boundary {
    /// Free: only joined parts act on it.
    Free,
    /// Fixed: the field is zero.
    Fixed,
}

/// Division of a field of an instance into elements.
#[derive(Debug, Clone, PartialEq)]
pub struct DiscretisationSpec {
    /// The field.
    pub field: Spanned<String>,
    /// Default number of elements.
    pub elements: usize,
    /// Order of the shape functions.
    pub order: usize,
    /// Boundary conditions at both ends, if the scene sets them.
    pub ends: [Option<Boundary>; 2],
}

/// The place of a port on a field.
#[derive(Debug, Clone, PartialEq)]
pub struct AttachmentSpec {
    /// The field.
    pub field: Spanned<String>,
    /// x, of parameters.
    pub at: Formula,
}

/// Reads a field of a unit.
pub fn field(entry: &Entry, found: &mut Findings) -> Option<FieldSpec> {
    let what = format!("field {}", quoted(&entry.key.value));
    let mut fields = Fields::open(&entry.value, what, found);
    let unit = fields.unit();
    let doc = fields.text("doc");
    let default = |suffix: &str| Spanned {
        value: format!("{}_{suffix}", entry.key.value),
        span: entry.key.span,
    };
    let rate = fields.name("rate").unwrap_or_else(|| default("dot"));
    let gradient = fields.name("gradient").unwrap_or_else(|| default("x"));
    let gradient_rate = fields.name("gradient_rate").unwrap_or_else(|| default("x_dot"));
    let scale = [fields.scale("scale"), fields.scale("rate_scale")];
    let over = fields.required_text("over");
    let densities = ["kinetic", "potential", "dissipation"].map(|key| fields.expression(key));
    let force = fields.expression("force");
    let ends = ["start", "end"].map(|key| boundary(&mut fields, key).unwrap_or(Boundary::Free));
    fields.close();
    for name in [&rate, &gradient, &gradient_rate] {
        if let Err(mistake) = names::check(name) {
            found.mistakes.push(mistake);
        }
    }
    Some(FieldSpec {
        name: entry.key.clone(),
        rate,
        gradient,
        gradient_rate,
        unit: unit?,
        doc,
        scale,
        over: over?,
        densities,
        force,
        ends,
    })
}

fn boundary(fields: &mut Fields<'_>, key: &'static str) -> Option<Boundary> {
    Some(choice(fields, key, BOUNDARIES)?.value)
}

fn choice<T: Copy>(
    fields: &mut Fields<'_>,
    key: &'static str,
    choices: &[(&'static str, T)],
) -> Option<Spanned<T>> {
    let tree = fields.take(key)?;
    let text = fields.as_text(tree, key)?;
    let found = choices.iter().find(|(name, _)| *name == text.value);
    if found.is_none() {
        let message = format!("{} is not a value of `{key}`", quoted(&text.value));
        let known: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
        let help = format!(
            "{}\nit is one of: {}",
            did_you_mean(&text.value, known.iter().copied()),
            known.join(", ")
        );
        let mistake = Mistake::new(Code::UnknownChoice, text.span, message, "unknown");
        fields.found().mistakes.push(mistake.help(help.trim_start()));
    }
    found.map(|(_, value)| Spanned { value: *value, span: text.span })
}

/// Reads a scene's settings for a field.
pub fn discretisation(entry: &Entry, found: &mut Findings) -> Option<DiscretisationSpec> {
    let what = format!("field {}", quoted(&entry.key.value));
    let mut fields = Fields::open(&entry.value, what, found);
    let elements = count(&mut fields, "elements", MAX_ELEMENTS);
    let order = count(&mut fields, "order", MAX_ORDER);
    let ends = ["start", "end"].map(|key| boundary(&mut fields, key));
    fields.close();
    let (elements, order) = (elements?, order?);
    Some(DiscretisationSpec { field: entry.key.clone(), elements, order, ends })
}

fn count(fields: &mut Fields<'_>, key: &'static str, most: f64) -> Option<usize> {
    let number = fields.required_number(key)?;
    if number.value.fract() == 0.0 && (1.0..=most).contains(&number.value) {
        return Some(number.value as usize);
    }
    let message = format!("`{key}` must be an integer from 1 to {most}");
    fields.found().mistakes.push(Mistake::new(
        Code::OutOfRange,
        number.span,
        message,
        "out of range",
    ));
    None
}

/// Returns the coordinate of a port on a field: the value of the field at the port.
pub fn coordinate(port: &PortSpec, unit_fields: &[FieldSpec]) -> Option<CoordinateSpec> {
    let attachment = port.attachment.as_ref()?;
    let field = unit_fields.iter().find(|field| field.name.value == attachment.field.value)?;
    let name = |suffix: &str| Spanned {
        value: format!("{}{suffix}", port.name.value),
        span: port.name.span,
    };
    let doc = if field.doc.is_empty() { &field.name.value } else { &field.doc };
    Some(CoordinateSpec {
        name: name(""),
        velocity: name("_dot"),
        acceleration: name("_ddot"),
        unit: field.unit.clone(),
        orientation: None,
        doc: format!("{doc}, at port {}", port.name.value),
        scale: field.scale,
        is_fixed: false,
    })
}
