//! The reproduction ledger: printed figures, and what becomes of them.

use machinist_studies::ledger::LedgerRow;
use maud::{Markup, html};

use crate::number::number;

/// All rows, or why there are none.
pub fn section(ledger: &Result<Vec<LedgerRow>, String>) -> Markup {
    html! {
        p {
            "The figures that the studies print, next to what their equations and numbers give
             as printed, and in the consistent reading that the scenes follow. Every number but the
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
        div.scroll {
            table.ledger {
                thead {
                    tr {
                        th { "Figure" } th { "Unit" } th.number { "Printed" }
                        th.number { "As printed gives" } th.number { "Consistent" } th { "Verdict" }
                    }
                }
                tbody {
                    @for row in rows {
                        tr {
                            td { (row.figure) }
                            td.unit { (row.unit) }
                            td.number { (optional(row.printed)) }
                            td.number { (optional(row.as_printed)) }
                            td.number { (optional(row.consistent)) }
                            td { (row.verdict) }
                        }
                    }
                }
            }
        }
    }
}

fn optional(value: Option<f64>) -> String {
    value.map_or_else(|| "\u{2013}".to_owned(), |value| number(value, 6))
}
