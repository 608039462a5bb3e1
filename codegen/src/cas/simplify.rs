//! Which of several equal forms is cheapest.

use symbolica::atom::{Atom, AtomCore};
use symbolica::id::Pattern;
use symbolica::parse;

use super::Form;
use super::convert::to_expr;
use super::functions::Vocabulary;
use crate::lower::operations;

/// Forms larger than this are not factored: the cost of factoring grows much
/// faster than what it can save.
const FACTOR_LIMIT: usize = 60;

/// Forms larger than this are not multiplied out.
const EXPAND_LIMIT: usize = 2000;

/// The form whose tape has the fewest operations: as it is, with common factors
/// collected, multiplied out with trigonometric identities applied, or factored.
pub(super) fn cheapest(vocabulary: &Vocabulary, form: &Form) -> Form {
    let cost = |atom: &Atom| operations(&to_expr(vocabulary, atom.as_view()));
    let mut best = (cost(&form.0), form.0.clone());
    let mut offer = |candidate: Atom| {
        let cost = cost(&candidate);
        if cost < best.0 {
            best = (cost, candidate);
        }
    };
    let size = cost(&form.0);
    offer(trigonometric(&form.0));
    if size <= EXPAND_LIMIT {
        let expanded = trigonometric(&form.0.expand());
        offer(expanded.collect_factors());
        if size <= FACTOR_LIMIT {
            offer(expanded.factor());
        }
        offer(expanded);
    }
    Form(best.1)
}

/// Pythagoras and the addition theorems, as often as they apply.
pub(super) fn trigonometric(atom: &Atom) -> Atom {
    if !atom.contains_symbol(symbolica::atom::Symbol::SIN) {
        return atom.clone();
    }
    let rules = rules();
    let mut current = atom.clone();
    // Every rule shortens the sum it applies to, so this ends.
    loop {
        let mut next = current.clone();
        for (pattern, replacement) in &rules {
            next = next.replace(pattern.clone()).with(replacement.clone());
        }
        if next == current {
            return current;
        }
        current = next;
    }
}

fn rules() -> Vec<(Pattern, Atom)> {
    [
        ("c___*sin(x_)^2 + c___*cos(x_)^2", "c___"),
        ("c___*cos(x_)*cos(y_) + c___*sin(x_)*sin(y_)", "c___*cos(x_ - y_)"),
        ("c___*sin(x_)*cos(y_) - c___*cos(x_)*sin(y_)", "c___*sin(x_ - y_)"),
    ]
    .into_iter()
    .map(|(pattern, replacement)| (parse!(pattern).to_pattern(), parse!(replacement)))
    .collect()
}
