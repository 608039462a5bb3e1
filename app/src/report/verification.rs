//! Table of checks.

use machinist_studies::verify::{Tally, Verdict, because};
use maud::{Markup, html};

use crate::number::number;

/// Renders the verdicts of a machine and the command that prints them.
pub fn section(verdicts: &[Verdict], command: &str) -> Markup {
    html! {
        p {
            "Each row holds a simulator against something known without it: a closed form, a
             converged reference computed by other means, equations written by hand, derivatives
             by the complex step, or the energy account. A row passes if its error is at most its
             tolerance. The same table is printed by " code { (command) } "."
        }
        @if let Some(left_out) = left_out(verdicts) { p { (left_out) } }
        @if let Some(unchecked) = unchecked(verdicts) { p { (unchecked) } }
        div.scroll {
            table.verdicts {
                thead {
                    tr {
                        th { "Check" } th { "Against" } th.number { "Error" }
                        th.number { "Tolerance" } th { "Because" } th { "Result" }
                    }
                }
                tbody { @for verdict in verdicts { (row(verdict)) } }
            }
        }
    }
}

/// Renders the number of passed rows among the checked ones, as a figure of a page.
pub fn entry(tally: Tally) -> Markup {
    let Tally { checked, passed, left_out, unchecked } = tally;
    html! {
        div class=[(!tally.is_clean()).then_some("bad")] {
            dt { "checks passed" } dd { (passed) " / " (checked) }
            @if left_out > 0 { dd.note { (left_out) " left out" } }
            @if unchecked > 0 { dd.note { (unchecked) " not checked" } }
        }
    }
}

/// Returns a sentence on the rows that were left out, if there are any.
fn left_out(verdicts: &[Verdict]) -> Option<String> {
    let Tally { left_out, .. } = Tally::of(verdicts);
    let text = match left_out {
        0 => return None,
        1 => "One row cannot be asked of this machine and is left out; it says why.".to_owned(),
        count => {
            format!("{count} rows cannot be asked of this machine and are left out; each says why.")
        }
    };
    Some(text)
}

/// Returns a sentence on the rows that were not checked, if there are any.
fn unchecked(verdicts: &[Verdict]) -> Option<String> {
    let Tally { unchecked, .. } = Tally::of(verdicts);
    match unchecked {
        0 => None,
        1 => Some("One row was not checked: what it takes stopped; it says why.".to_owned()),
        count => {
            Some(format!("{count} rows were not checked: what they take stopped; each says why."))
        }
    }
}

fn row(verdict: &Verdict) -> Markup {
    // Rows that were not checked have neither.
    let is_checked = verdict.skipped.is_none() && verdict.unchecked.is_none();
    let asked = |value| if is_checked { number(value, 2) } else { String::new() };
    html! {
        tr {
            td { (verdict.check) (numbers(verdict)) }
            td { (verdict.reference) }
            td.number { (asked(verdict.error)) }
            td.number { (asked(verdict.tolerance)) }
            td { (because(verdict)) }
            td {
                @if verdict.skipped.is_some() { span.muted { "left out" } }
                @else if verdict.unchecked.is_some() { span.muted { "not checked" } }
                @else { (badge(verdict.pass)) }
            }
        }
    }
}

fn numbers(verdict: &Verdict) -> Markup {
    html! {
        @if let (Some(value), Some(expected)) = (verdict.value, verdict.expected) {
            div.muted { (number(value, 6)) " for " (number(expected, 6)) }
        }
    }
}

/// Renders pass or fail as a word, not by colour alone.
pub fn badge(pass: bool) -> Markup {
    html! { @if pass { span.badge.pass { "pass" } } @else { span.badge.fail { "FAIL" } } }
}
