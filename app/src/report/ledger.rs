//! Reproduction ledger: printed figures and the result of reproducing each.

use machinist_studies::ledger::{LedgerRow, Study};
use maud::{Markup, html};

use crate::number::number;

/// Renders all rows, or the reason why there are none.
pub fn section(ledger: &Result<Vec<LedgerRow>, String>) -> Markup {
    html! {
        p {
            "Every equation, table, figure and number of the studies: the printed value, the result of
             the equations as printed, and that of the consistent reading, which the scenes follow.
             Below each reading stand its place in Machinist and the check or test that covers it.
             All values except the printed ones were computed for this page."
        }
        @match ledger {
            Ok(rows) => (table(rows)),
            Err(error) => p.warning { "The ledger could not be filled: " (error) },
        }
    }
}

fn table(rows: &[LedgerRow]) -> Markup {
    html! {
        @for study in Study::ALL {
            h3 { (study.name()) }
            @let (numbers, words): (Vec<_>, Vec<_>) =
                rows.iter().filter(|row| row.study == study).partition(|row| has_numbers(row));
            div.scroll { (table_of_words(words.into_iter())) }
            div.scroll { (table_of_numbers(numbers.into_iter())) }
        }
    }
}

fn has_numbers(row: &LedgerRow) -> bool {
    [row.printed, row.as_printed, row.consistent].iter().any(Option::is_some)
}

/// Renders the rows of one study that have no numbers.
fn table_of_words<'a>(rows: impl Iterator<Item = &'a LedgerRow>) -> Markup {
    html! {
        table.ledger {
            thead { tr { th { "In the study" } th { "Subject" } th { "Reading" } } }
            tbody {
                @for row in rows {
                    tr { td { (row.at) } td { (row.figure) } td { (reading(row)) } }
                }
            }
        }
    }
}

fn table_of_numbers<'a>(rows: impl Iterator<Item = &'a LedgerRow>) -> Markup {
    html! {
        table.ledger {
            thead {
                tr {
                    th { "In the study" } th { "Subject" } th.number { "Printed" }
                    th.number { "As printed" } th.number { "Consistent" } th { "Unit" }
                    th { "Reading" }
                }
            }
            tbody {
                @for row in rows {
                    tr {
                        td { (row.at) }
                        td { (row.figure) }
                        td.number { (optional(row.printed)) }
                        td.number { (optional(row.as_printed)) }
                        td.number { (optional(row.consistent)) }
                        td.unit { (row.unit) }
                        td { (reading(row)) }
                    }
                }
            }
        }
    }
}

/// Renders the reading of a row; below it the place in Machinist and the check.
fn reading(row: &LedgerRow) -> Markup {
    html! {
        (row.verdict)
        div.held { (coded(row.place)) br; (coded(&row.held.describe())) }
    }
}

/// Renders text with backticks as code.
fn coded(text: &str) -> Markup {
    html! {
        @for (index, part) in text.split('`').enumerate() {
            @if index % 2 == 1 { code { (part) } } @else { (part) }
        }
    }
}

fn optional(value: Option<f64>) -> String {
    value.map_or_else(|| "\u{2013}".to_owned(), |value| number(value, 6))
}
