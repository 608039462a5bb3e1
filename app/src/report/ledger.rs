//! Reproduction ledger: printed figures and the result of reproducing each.

use machinist_studies::ledger::{LedgerRow, Study};
use maud::{Markup, html};

use crate::number::number;

/// Renders all rows, or the reason why there are none.
pub fn section(ledger: &Result<Vec<LedgerRow>, String>) -> Markup {
    html! {
        p {
            "Every equation, table, figure and number that the studies print, next to what their
             equations and numbers give as printed, and in the consistent reading that the scenes
             follow; where it is, and what holds it. Every number but the
             printed ones was computed for this page."
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
            div.scroll { (table_of(rows.iter().filter(|row| row.study == study))) }
        }
    }
}

/// Renders the rows of one study. Place and check share a column, so that the reading has room.
fn table_of<'a>(rows: impl Iterator<Item = &'a LedgerRow>) -> Markup {
    html! {
        table.ledger {
            thead {
                tr {
                    th { "In the study" } th { "Subject" } th.number { "Printed" }
                    th.number { "Result as printed" } th.number { "Consistent" } th { "Unit" }
                    th { "Reading" } th { "In Machinist; checked by" }
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
                        td { (row.verdict) }
                        td { (coded(row.place)) br; (coded(&row.held.told())) }
                    }
                }
            }
        }
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
