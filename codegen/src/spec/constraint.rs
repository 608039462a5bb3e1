//! Reading of constraints on coordinates.

use crate::spec::ConstraintSpec;
use crate::spec::event::whole_numbers;
use crate::spec::fields::{Fields, Findings};
use crate::spec::names::quoted;
use crate::spec::toml::Entry;

/// Reads a constraint.
pub fn constraint(entry: &Entry, found: &mut Findings) -> Option<ConstraintSpec> {
    let what = format!("constraint {}", quoted(&entry.key.value));
    let mut fields = Fields::open(&entry.value, what, found);
    let expression = fields.required_expression("expression");
    let when = fields.entries("when");
    let when = whole_numbers(when, &mut fields);
    let doc = fields.text("doc");
    fields.close();
    let name = entry.key.clone();
    Some(ConstraintSpec { name, expression: expression?, when, doc, friction: None })
}
