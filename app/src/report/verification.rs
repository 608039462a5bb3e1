//! The table of checks.

use machinist_studies::verify::{Verdict, because};
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

fn row(verdict: &Verdict) -> Markup {
    html! {
        tr {
            td { (verdict.check) (numbers(verdict)) }
            td { (verdict.reference) }
            td.number { (number(verdict.error, 2)) }
            td.number { (number(verdict.tolerance, 2)) }
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
