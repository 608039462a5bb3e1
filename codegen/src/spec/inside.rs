//! Contents of a scene or an assembly: instances of units, and their joints.
//!
//! Excluded: the units themselves, which are only named.

use crate::spec::array;
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Spanned};
use crate::spec::distributed;
use crate::spec::fields::{Fields, Findings};
use crate::spec::names::{self, quoted};
use crate::spec::scatter;
use crate::spec::spread::Spread;
use crate::spec::toml::{Entry, Tree};
use crate::spec::unit::each;
use crate::spec::{DiscretisationSpec, Formula, JointSpec, Value};

/// Instances, joints and initial values, as written.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Inside {
    /// Instances of units.
    pub instances: Vec<InstanceText>,
    /// Joints between their ports.
    pub joints: Vec<JointSpec>,
    /// Initial values, by `instance.name`.
    pub initial: Vec<(Spanned<String>, Formula)>,
    /// Guesses of the initial values that constraints determine, likewise.
    pub guess: Vec<(Spanned<String>, Formula)>,
}

/// An instance whose unit is given by name only.
#[derive(Debug, Clone, PartialEq)]
pub struct InstanceText {
    /// Its name.
    pub name: Spanned<String>,
    /// The name of its unit.
    pub unit: Spanned<String>,
    /// Number of instances, for a row.
    pub count: Option<Spanned<i64>>,
    /// Values that replace the unit's, also for inner instances: `gear.ratio`.
    pub parameters: Vec<(Spanned<String>, Value)>,
    /// Tolerances of these values.
    pub tolerances: Vec<(Spanned<String>, Spanned<Spread>)>,
    /// Expressions for the inputs.
    pub inputs: Vec<(Spanned<String>, Formula)>,
    /// Division of its fields into elements.
    pub fields: Vec<DiscretisationSpec>,
}

/// Reads `[units]` and `[[joints]]`.
pub fn parts(fields: &mut Fields<'_>) -> (Vec<InstanceText>, Vec<JointSpec>) {
    let instances = each(fields, "units", instance);
    let joints = fields.list("joints");
    let joints = joints.iter().filter_map(|tree| joint(tree, fields.found())).collect();
    (instances, joints)
}

fn instance(entry: &Entry, found: &mut Findings) -> Option<InstanceText> {
    let what = format!("instance {}", quoted(&entry.key.value));
    let mut fields = Fields::open(&entry.value, what, found);
    let unit = fields.required_text("unit");
    let count = fields.number("count").and_then(|count| {
        if count.value.fract() == 0.0 && (1.0..=array::MOST).contains(&count.value) {
            return Some(Spanned { value: count.value as i64, span: count.span });
        }
        let message = format!("`count` must be an integer from 1 to {}", array::MOST);
        fields.found().mistakes.push(Mistake::new(
            Code::OutOfRange,
            count.span,
            message,
            "out of range",
        ));
        None
    });
    let unit = unit.filter(|unit| match check_unit_path(unit) {
        Ok(()) => true,
        Err(mistake) => {
            fields.found().mistakes.push(mistake);
            false
        }
    });
    let overrides = fields.entries("parameters");
    let (mut parameters, mut tolerances) = (Vec::new(), Vec::new());
    for (name, tree) in by_path(overrides) {
        let Some(read) = scatter::value(&mut fields, tree, &name.value) else { continue };
        tolerances.extend(read.tolerance.map(|tolerance| (name.clone(), tolerance)));
        parameters.push((name, read.value));
    }
    let bindings = fields.entries("inputs");
    let inputs = bindings.iter().filter_map(|entry| {
        let formula = fields.as_formula(&entry.value, &entry.key.value)?;
        Some((entry.key.clone(), formula))
    });
    let inputs = inputs.collect();
    let choices = each(&mut fields, "fields", distributed::discretisation);
    fields.close();
    let name = entry.key.clone();
    let unit = unit?;
    Some(InstanceText { name, unit, count, parameters, tolerances, inputs, fields: choices })
}

/// Checks the name of a unit: `inertia`, or `rotational/inertia` in a folder, with names between
/// slashes.
fn check_unit_path(unit: &Spanned<String>) -> Result<(), Mistake> {
    let names = unit.value.split('/');
    names
        .map(|part| Spanned { value: part.to_owned(), span: unit.span })
        .try_for_each(|part| names::check(&part))
}

fn joint(tree: &Spanned<Tree>, found: &mut Findings) -> Option<JointSpec> {
    let mut fields = Fields::open(tree, "[[joints]]".to_owned(), found);
    let connect = fields.require("connect").and_then(|list| ports(list, &mut fields));
    let ratio = fields.formula("ratio");
    fields.close();
    Some(JointSpec { connect: connect?, ratio, within: None })
}

fn ports(tree: &Spanned<Tree>, fields: &mut Fields<'_>) -> Option<[Spanned<String>; 2]> {
    let Tree::List(items) = &tree.value else {
        return fields.wrong(tree, "connect", "a list of two ports");
    };
    let [first, second] = items.as_slice() else {
        let mistake =
            Mistake::new(Code::WrongType, tree.span, "a joint must connect two ports", "not two");
        fields.found().mistakes.push(mistake.help("write connect = [\"a.port\", \"b.port\"]"));
        return None;
    };
    Some([fields.as_text(first, "connect")?, fields.as_text(second, "connect")?])
}

/// Reads both `"motor.angle" = 0` and `motor.angle = 0`, which TOML reads as a table.
pub fn values_by_name<'a>(
    entries: impl IntoIterator<Item = &'a Entry>,
    fields: &mut Fields<'_>,
) -> Vec<(Spanned<String>, Formula)> {
    let mut values = Vec::new();
    for (name, tree) in by_path(entries) {
        let own = name.value.rsplit('.').next().unwrap_or_default();
        let formula = fields.as_formula(tree, own);
        values.extend(formula.map(|value| (name, value)));
    }
    values
}

/// Returns entries by their full path, whether its dots are quoted or not; `row[3]` is `row_3`.
pub fn by_path<'a>(
    entries: impl IntoIterator<Item = &'a Entry>,
) -> Vec<(Spanned<String>, &'a Spanned<Tree>)> {
    let mut all = Vec::new();
    for Entry { key, value } in entries {
        let Tree::Table(inner) = &value.value else {
            let name = Spanned { value: array::numbered(&key.value), span: key.span };
            all.push((name, value));
            continue;
        };
        for (name, value) in by_path(inner) {
            let path = array::numbered(&format!("{}.{}", key.value, name.value));
            all.push((Spanned { value: path, span: name.span }, value));
        }
    }
    all
}
