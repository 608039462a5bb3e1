//! The table of checks.

use machinist_studies::verify::{Tally, Verdict, because};
use maud::{Markup, html};

use crate::number::number;

/// The verdicts of a machine, and the command that prints them.
pub fn section(verdicts: &[Verdict], command: &str) -> Markup {
    html! {
        p {
            "Each row holds a simulator against something known without it: a closed form, a
             converged reference computed by other means, equations written by hand, derivatives
             by the complex step, or the energy account. A row passes if its error is at most its
             tolerance. The same table is printed by " code { (command) } "."
        }
        @if let Some(left_out) = left_out(verdicts) { p { (left_out) } }
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

/// Rows that passed of those that were asked, as one of the figures of a page.
pub fn entry(tally: Tally) -> Markup {
    let Tally { checked, passed, left_out } = tally;
    html! {
        div class=[(!tally.is_clean()).then_some("bad")] {
            dt { "checks passed" } dd { (passed) " / " (checked) }
            @if left_out > 0 { dd.note { (left_out) " left out" } }
        }
    }
}

/// That some rows were not asked.
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

fn row(verdict: &Verdict) -> Markup {
    // What is left out has neither.
    let asked = |value| if verdict.skipped.is_some() { String::new() } else { number(value, 2) };
    html! {
        tr {
            td { (verdict.check) (numbers(verdict)) }
            td { (verdict.reference) }
            td.number { (asked(verdict.error)) }
            td.number { (asked(verdict.tolerance)) }
            td { (because(verdict)) }
            td { @if verdict.skipped.is_some() { span.muted { "left out" } } @else { (badge(verdict.pass)) } }
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

/// Pass or fail, told by a word and not by colour alone.
pub fn badge(pass: bool) -> Markup {
    html! { @if pass { span.badge.pass { "pass" } } @else { span.badge.fail { "FAIL" } } }
}
