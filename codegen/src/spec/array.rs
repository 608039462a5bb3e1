//! Rows of equal instances: `count = 10` makes `disc_1` to `disc_10` of `disc`.
//!
//! A statement with the index `i` (`disc[i].b`, `disc[i+1].a`) is repeated for each `i` for which
//! all names in it exist. Within expressions `i` is the number itself. The result contains no
//! index.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Spanned};
use crate::spec::expression::{Ast, Literal, Node};
use crate::spec::fields::Findings;
use crate::spec::inside::{Inside, InstanceText};
use crate::spec::names::quoted;
use crate::spec::{Acts, Formula, JointSpec, PortForceSpec, Value};

/// Maximum number of instances of a row.
pub const MOST: f64 = 10_000.0;
/// The name of the index.
const INDEX: &str = "i";

/// Number of instances of each row.
type Counts = BTreeMap<String, i64>;

/// Repeats each statement for all of its indices; `names` are names that the index must not have.
pub fn unroll<'n>(
    inside: &mut Inside,
    forces: &mut Vec<PortForceSpec>,
    names: impl Iterator<Item = &'n Spanned<String>>,
    found: &mut Findings,
) {
    let rows = inside.instances.iter().filter_map(|text| Some((text, text.count.as_ref()?)));
    let counts: Counts = rows.map(|(text, count)| (text.name.value.clone(), count.value)).collect();
    if !counts.is_empty() {
        for name in names.filter(|name| name.value == INDEX) {
            let message = "`i` is reserved for the index of rows, as in `disc[i]`";
            found.mistakes.push(Mistake::new(Code::InvalidName, name.span, message, "rename this"));
        }
    }
    let mut unroll = Unroll { counts, found };
    unroll.instances(&mut inside.instances);
    inside.joints = unroll.joints(std::mem::take(&mut inside.joints));
    *forces = unroll.forces(std::mem::take(forces));
    for values in [&mut inside.initial, &mut inside.guess] {
        *values = unroll.values(std::mem::take(values));
    }
}

struct Unroll<'f> {
    counts: Counts,
    found: &'f mut Findings,
}

impl Unroll<'_> {
    fn instances(&mut self, instances: &mut Vec<InstanceText>) {
        let mut all: Vec<InstanceText> = Vec::new();
        for text in std::mem::take(instances) {
            let Some(count) = &text.count else {
                all.push(text);
                continue;
            };
            for index in 1..=count.value {
                all.push(text.at(index));
            }
        }
        let mut names = BTreeSet::new();
        if let Some(text) = all.iter().find(|text| !names.insert(text.name.value.as_str())) {
            let message = format!("there are two instances {}", quoted(&text.name.value));
            self.found.mistakes.push(Mistake::new(
                Code::DuplicateName,
                text.name.span,
                message,
                "again",
            ));
        }
        *instances = all;
    }

    fn joints(&mut self, joints: Vec<JointSpec>) -> Vec<JointSpec> {
        let mut all = Vec::new();
        for joint in joints {
            let [a, b] = &joint.connect;
            for index in self.indices(&[a, b]) {
                let connect = joint.connect.each_ref().map(|port| at(port, index));
                let ratio = joint.ratio.as_ref().map(|ratio| ratio.for_index(index));
                all.push(JointSpec { connect, ratio, within: None });
            }
        }
        all
    }

    fn forces(&mut self, forces: Vec<PortForceSpec>) -> Vec<PortForceSpec> {
        let mut all = Vec::new();
        for force in forces {
            let rows = match &force.acts {
                Acts::On(port) => vec![port.clone()],
                Acts::Along(ast) => ast.rows(),
            };
            for index in self.indices(&rows.iter().collect::<Vec<_>>()) {
                let of = |own: &Ast| index.map_or_else(|| own.clone(), |index| own.at(index));
                let acts = match &force.acts {
                    Acts::On(port) => Acts::On(at(port, index)),
                    Acts::Along(ast) => Acts::Along(of(ast)),
                };
                let (expression, doc) = (of(&force.expression), force.doc.clone());
                all.push(PortForceSpec { acts, expression, doc });
            }
        }
        all
    }

    fn values(
        &mut self,
        values: Vec<(Spanned<String>, Formula)>,
    ) -> Vec<(Spanned<String>, Formula)> {
        let mut all = Vec::new();
        for (name, formula) in values {
            for index in self.indices(&[&name]) {
                all.push((at(&name, index), formula.for_index(index)));
            }
        }
        all
    }

    /// Returns the indices for which all paths exist; a single `None` for paths without an index.
    fn indices(&mut self, paths: &[&Spanned<String>]) -> Vec<Option<i64>> {
        let mut indices: Option<RangeInclusive<i64>> = None;
        for path in paths {
            let Some((row, offset)) = indexed(&path.value) else { continue };
            let Some(count) = self.counts.get(row) else {
                let message = format!("{} is not a row of instances", quoted(row));
                let help = format!("write count = 10 in [units.{row}]");
                self.found.mistakes.push(
                    Mistake::new(Code::WrongKindOfName, path.span, message, "one").help(help),
                );
                return Vec::new();
            };
            let own = 1 - offset..=count - offset;
            indices = Some(match indices {
                None => own,
                Some(known) => *known.start().max(own.start())..=*known.end().min(own.end()),
            });
        }
        let Some(indices) = indices else { return vec![None] };
        if indices.is_empty() {
            let message = "no index `i` is valid for all of these rows";
            let first = paths
                .first()
                .map(|path| Mistake::new(Code::OutOfRange, path.span, message, "nowhere"));
            self.found.mistakes.extend(first);
        }
        indices.map(Some).collect()
    }
}

/// Returns the row and the offset of the index, for `row[i]`, `row[i+1].port`, `row[i - 2]`.
fn indexed(path: &str) -> Option<(&str, i64)> {
    let (row, rest) = path.split_once('[')?;
    let (index, _) = rest.split_once(']')?;
    let offset = index.trim().strip_prefix(INDEX)?.trim();
    if offset.is_empty() {
        return Some((row, 0));
    }
    let (sign, digits) = match (offset.strip_prefix('+'), offset.strip_prefix('-')) {
        (Some(digits), _) => (1, digits),
        (_, Some(digits)) => (-1, digits),
        _ => return None,
    };
    let size: i64 = digits.trim().parse().ok().filter(|size| (0..=1_000_000).contains(size))?;
    Some((row, sign * size))
}

/// Writes `row[i+1].port` as `row_4.port` if `i` is 3, and `row[3].port` as `row_3.port`;
/// likewise later brackets.
fn plain(path: &str, index: Option<i64>) -> String {
    let Some((row, rest)) = path.split_once('[') else { return path.to_owned() };
    let Some((inside, rest)) = rest.split_once(']') else { return path.to_owned() };
    let rest = plain(rest, index);
    match (indexed(path), index, inside.trim().parse::<u32>()) {
        (Some((_, offset)), Some(index), _) => format!("{row}_{}{rest}", index + offset),
        (_, _, Ok(number)) => format!("{row}_{number}{rest}"),
        _ => format!("{row}[{inside}]{rest}"),
    }
}

/// Writes `row[3].port` as `row_3.port`.
pub fn numbered(path: &str) -> String {
    plain(path, None)
}

fn at(path: &Spanned<String>, index: Option<i64>) -> Spanned<String> {
    Spanned { value: plain(&path.value, index), span: path.span }
}

impl InstanceText {
    /// Returns the instance of a row with this index.
    fn at(&self, index: i64) -> InstanceText {
        let name = format!("{}_{index}", self.name.value);
        let parameters = self.parameters.iter().map(|(name, value)| {
            let value = match value {
                Value::Number(number) => Value::Number(*number),
                Value::Expression(ast) => Value::Expression(ast.at(index)),
            };
            (name.clone(), value)
        });
        let inputs = self.inputs.iter().map(|(name, formula)| (name.clone(), formula.at(index)));
        InstanceText {
            name: Spanned { value: name, span: self.name.span },
            unit: self.unit.clone(),
            count: None,
            parameters: parameters.collect(),
            tolerances: self.tolerances.clone(),
            inputs: inputs.collect(),
            fields: self.fields.clone(),
        }
    }
}

impl Formula {
    /// Returns the formula for an index, if there is one.
    fn for_index(&self, index: Option<i64>) -> Formula {
        index.map_or_else(|| self.clone(), |index| self.at(index))
    }

    fn at(&self, index: i64) -> Formula {
        match self {
            Formula::Number(number) => Formula::Number(number.clone()),
            Formula::Expression(ast) => Formula::Expression(ast.at(index)),
        }
    }
}

impl Ast {
    /// Returns the rows that it refers to by an index.
    fn rows(&self) -> Vec<Spanned<String>> {
        let mut rows = Vec::new();
        self.visit(&mut |part| {
            if let Node::Name(Some(instance), _) = &part.node
                && instance.contains('[')
            {
                rows.push(Spanned { value: instance.clone(), span: part.span });
            }
        });
        rows
    }

    /// Returns the expression for an index.
    fn at(&self, index: i64) -> Ast {
        let of = |ast: &Ast| ast.at(index);
        let boxed = |ast: &Ast| Box::new(ast.at(index));
        let parts = |parts: &[(bool, Ast)]| -> Vec<(bool, Ast)> {
            parts.iter().map(|(mark, of)| (*mark, of.at(index))).collect()
        };
        let node = match &self.node {
            Node::Name(None, name) if name == INDEX => {
                Node::Number(Literal::of_integer(index), None)
            }
            Node::Name(Some(instance), name) => {
                Node::Name(Some(plain(instance, Some(index))), name.clone())
            }
            Node::Negative(of) => Node::Negative(boxed(of)),
            Node::Sum(terms) => Node::Sum(parts(terms)),
            Node::Product(factors) => Node::Product(parts(factors)),
            Node::Power(a, b) => Node::Power(boxed(a), boxed(b)),
            Node::Less(a, b) => Node::Less(boxed(a), boxed(b)),
            Node::Call(name, span, arguments) => {
                Node::Call(name.clone(), *span, arguments.iter().map(of).collect())
            }
            Node::Number(..) | Node::Name(None, _) | Node::Text(_) => self.node.clone(),
        };
        Ast { span: self.span, node }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_lose_their_index() {
        for (path, flat) in [
            ("disc[i].b", "disc_3.b"),
            ("disc[i+1].b", "disc_4.b"),
            ("disc[ i - 2 ]", "disc_1"),
            ("disc[7].b", "disc_7.b"),
            ("disc.b", "disc.b"),
            ("train[i].disc[4].b", "train_3.disc_4.b"),
            ("train[2].disc[i].b", "train_2.disc_3.b"),
            ("disc[j].b", "disc[j].b"),
            ("disc[i*2].b", "disc[i*2].b"),
            ("disc[i", "disc[i"),
        ] {
            assert_eq!(plain(path, Some(3)), flat);
        }
    }
}
