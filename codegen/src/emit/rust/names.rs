//! Names in emitted Rust: valid, distinct, and those of the spec if it has one.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span};
use quote::format_ident;

use super::functions::JACOBIANS;
use crate::emit::EmitError;
use machinist_model::functions::Gives;

/// Returns an argument, prefixed by an underscore if the function does not read it.
pub(super) fn argument(is_read: bool, name: &str) -> Ident {
    if is_read { format_ident!("{name}") } else { format_ident!("_{name}") }
}

/// Names that a local variable must not take: those bound by signatures, those that the prelude
/// and the module make patterns, and misleading ones.
const RESERVED: &[&str] = &[
    "p",
    "c",
    "state",
    "time",
    "R",
    "None",
    "Some",
    "Ok",
    "Err",
    "core",
    "PARAMETERS",
    "CONSTANTS",
    "EVENT_SHAPES",
    "CONSTRAINT_SHAPES",
    "STATE_ROWS",
    "PARAMETER_QUANTITIES",
    "PARAMETER_DEFAULTS",
    "OUTPUT_QUANTITIES",
    "COORDINATE_QUANTITIES",
    "RUN_DEFAULTS",
    "EXCITATION_TERMS",
    "SLOPES",
    "RATE_JACOBIAN_STEPS",
    "PARAMETER_JACOBIAN_STEPS",
    "SWITCHES",
];

/// Functions that are not in the table.
const FUNCTIONS: &[&str] =
    &["series", "prepare", JACOBIANS, "excitation", "switches", "substitute"];

/// Iterates over the names of the functions, and of the constants for the sizes of their results.
fn of_the_table() -> impl Iterator<Item = &'static str> {
    machinist_model::functions::FUNCTIONS.iter().flat_map(|row| {
        let given = match row.gives {
            Gives::Numbers(constant) | Gives::Record(_, constant) | Gives::Matrix(constant) => {
                Some(constant)
            }
            Gives::Structure(..) => None,
        };
        [Some(row.name), row.prepared, given].into_iter().flatten()
    })
}

/// Types that the emitted module defines or imports.
const TYPES: &[&str] = &[
    "Parameters",
    "Outputs",
    "Constants",
    "Motion",
    "Step",
    "Constraint",
    "CubicTable",
    "Describe",
    "Direction",
    "Event",
    "Energy",
    "PowerBalance",
    "Quantity",
    "Real",
    "RunDefaults",
    "Shape",
    "Simulator",
    "SparsityPattern",
    "Factored",
    "Lanes",
    "TaylorSeries",
    "R",
    "Self",
    "Default",
    "Debug",
    "Clone",
    "Copy",
    "Option",
    "Some",
    "None",
    "Ok",
    "Err",
    "Result",
    "Box",
    "Vec",
    "String",
    "PhantomData",
];

/// Returns the identifier of a text, or the error that it is not one.
pub(super) fn identifier(text: &str) -> Result<Ident, EmitError> {
    syn::parse_str(text).map_err(|_| EmitError::Identifier { name: text.to_owned() })
}

/// Returns identifiers of all names of a kind, checked to be distinct.
pub(super) fn distinct<'a>(
    names: impl IntoIterator<Item = &'a str>,
    kind: &'static str,
) -> Result<Vec<Ident>, EmitError> {
    let mut seen = BTreeSet::new();
    let mut idents = Vec::new();
    for name in names {
        if !seen.insert(name) {
            return Err(EmitError::NamedTwice { name: name.to_owned(), kind });
        }
        idents.push(identifier(name)?);
    }
    Ok(idents)
}

/// Allocates names, each once.
#[derive(Debug, Clone)]
pub(super) struct Namer {
    taken: BTreeSet<String>,
}

impl Namer {
    /// Returns a namer for local variables of emitted functions.
    pub(super) fn for_locals() -> Self {
        let taken = RESERVED.iter().chain(FUNCTIONS).copied().chain(of_the_table());
        Self { taken: taken.map(str::to_owned).collect() }
    }

    /// Returns a namer for constants of the emitted module.
    pub(super) fn for_constants() -> Self {
        let taken = RESERVED.iter().copied().chain(of_the_table());
        Self { taken: taken.map(str::to_owned).collect() }
    }

    /// Returns a namer without reserved names.
    pub(super) fn empty() -> Self {
        Self { taken: BTreeSet::new() }
    }

    /// Reserves a name.
    pub(super) fn reserve(&mut self, name: &str) {
        self.taken.insert(name.to_owned());
    }

    /// Returns `wanted`, or `wanted_2`, `wanted_3`, ... if it is taken. `wanted` must be an
    /// identifier.
    pub(super) fn claim(&mut self, wanted: &str) -> Ident {
        let mut name = wanted.to_owned();
        let mut count = 1_u32;
        while !self.taken.insert(name.clone()) {
            count += 1;
            name = format!("{wanted}_{count}");
        }
        Ident::new(&name, Span::call_site())
    }
}

/// Changes `saw_gin` to `SawGin`, distinct from the module's other types.
pub(super) fn type_name(scene: &str) -> String {
    let mut name = String::new();
    for word in scene.split('_') {
        let mut letters = word.chars();
        name.extend(letters.next().map(|letter| letter.to_ascii_uppercase()));
        name.push_str(letters.as_str());
    }
    let begins_well = name.starts_with(|letter: char| letter.is_alphabetic());
    if !begins_well || TYPES.contains(&name.as_str()) {
        name.insert_str(0, "Machine");
    }
    name
}

/// Returns the upper-case spelling of an identifier.
pub(super) fn constant_name(ident: &str) -> String {
    ident.to_ascii_uppercase()
}

#[cfg(test)]
mod tests {
    use super::{Namer, identifier, type_name};

    #[test]
    fn scenes_become_types_that_clash_with_nothing() {
        let names = ["saw_gin", "two_mass_2", "parameters", "_1", "x"].map(type_name);
        assert_eq!(names, ["SawGin", "TwoMass2", "MachineParameters", "Machine1", "X"]);
    }

    #[test]
    fn a_name_is_handed_out_once() {
        let mut namer = Namer::for_locals();
        let names = ["phi", "phi", "phi", "state"].map(|name| namer.claim(name).to_string());
        assert_eq!(names, ["phi", "phi_2", "phi_3", "state_2"]);
    }

    #[test]
    fn keywords_and_code_are_no_identifiers() {
        for text in ["fn", "a b", "", "1a", "a; fn main() {}", "self", "_"] {
            assert!(identifier(text).is_err(), "{text:?}");
        }
    }
}
