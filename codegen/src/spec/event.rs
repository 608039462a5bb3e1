//! Reading of modes and events.

use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::dimension::Unit;
use crate::spec::expression::{Ast, Literal, Node};
use crate::spec::fields::{Fields, Findings};
use crate::spec::inside::{by_path, values_by_name};
use crate::spec::measure::Factor;
use crate::spec::names::{did_you_mean, quoted};
use crate::spec::toml::{Entry, Tree};
use crate::spec::{Declared, EventSpec, Formula, StateSpec};
use machinist_model::Direction;

/// Reads an event.
pub fn event(entry: &Entry, found: &mut Findings) -> Option<EventSpec> {
    let what = format!("event {}", quoted(&entry.key.value));
    let mut fields = Fields::open(&entry.value, what, found);
    let guard = fields.required_expression("guard");
    let direction = direction(&mut fields);
    let when = fields.entries("when");
    let when = whole_numbers(when, &mut fields);
    let set = fields.entries("set");
    let set = values_by_name(set, &mut fields);
    let doc = fields.text("doc");
    fields.close();
    Some(EventSpec {
        name: entry.key.clone(),
        guard: guard?,
        direction: direction?,
        when,
        set,
        doc,
    })
}

/// Reads a mode: a dimensionless state whose rate is 0.
#[expect(clippy::unnecessary_wraps, reason = "as all that are read by name")]
pub fn mode(entry: &Entry, found: &mut Findings) -> Option<StateSpec> {
    let what = format!("mode {}", quoted(&entry.key.value));
    let mut fields = Fields::open(&entry.value, what, found);
    let initial = fields.formula("initial");
    let doc = fields.text("doc");
    fields.close();
    if let Some(Formula::Number(number)) = &initial
        && !number.value.0.is_integer()
    {
        found.mistakes.push(no_whole_number(number.span, "a mode"));
    }
    Some(mode_called(entry.key.clone(), initial, doc))
}

/// Returns a mode of this name.
pub fn mode_called(name: Spanned<String>, initial: Option<Formula>, doc: String) -> StateSpec {
    let span = name.span;
    let unit =
        Declared { text: "1".to_owned(), unit: Unit::default(), factor: Factor::one(), span };
    let rate = Ast { span, node: Node::Number(Literal::of_integer(0), None) };
    StateSpec { name, unit, doc, rate, is_mode: true, initial, scale: 1.0 }
}

/// Reads `rising`, `falling` or `both`, which is the default.
fn direction(fields: &mut Fields<'_>) -> Option<Direction> {
    let Some(tree) = fields.take("direction") else { return Some(Direction::Both) };
    let text = fields.as_text(tree, "direction")?;
    let known = Direction::ALL.into_iter().find(|direction| direction.name() == text.value);
    if known.is_none() {
        let message = format!("unknown direction {}", quoted(&text.value));
        let help = did_you_mean(&text.value, Direction::ALL.into_iter().map(Direction::name));
        fields
            .found()
            .mistakes
            .push(Mistake::new(Code::UnknownChoice, text.span, message, "unknown").help(help));
    }
    known
}

/// Reads modes with the whole numbers they must be; `instance.mode` too, which TOML reads as a
/// table.
pub(super) fn whole_numbers(
    entries: &[Entry],
    fields: &mut Fields<'_>,
) -> Vec<(Spanned<String>, i32)> {
    let mut numbers = Vec::new();
    for (name, tree) in by_path(entries) {
        let own = name.value.rsplit('.').next().unwrap_or_default();
        let number = whole_number(tree, own, fields);
        numbers.extend(number.map(|number| (name, number)));
    }
    numbers
}

fn whole_number(tree: &Spanned<Tree>, key: &str, fields: &mut Fields<'_>) -> Option<i32> {
    let number = fields.as_number(tree, key)?;
    let is_whole = number.value.fract() == 0.0 && number.value.abs() <= f64::from(i32::MAX);
    if !is_whole {
        fields.found().mistakes.push(no_whole_number(number.span, "a mode"));
        return None;
    }
    Some(number.value as i32)
}

fn no_whole_number(span: Span, what: &str) -> Mistake {
    let message = format!("{what} must be an integer");
    Mistake::new(Code::WrongType, span, message, "not an integer")
}
