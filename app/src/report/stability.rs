//! Table of extreme cases: right, refused and wrong results.

use machinist_studies::stability::{LongRun, ObservedOrders, Outcome, POWERS, Row, Study};
use maud::{Markup, html};

use crate::trials::{DRIFT, ORDERS, cell, drift_cells, order, refusals, rule};

/// Renders all cases by all methods.
pub fn section(study: &Study) -> Markup {
    html! {
        p {
            "Extreme cases by every method. A number is the error of a run over its relative
             tolerance, so that 1 is what was asked for; a word says why a run was refused. The
             same table is printed by " code { "machinist stability" } "."
        }
        div.scroll {
            table {
                thead { tr {
                    th { "Case" }
                    @for method in &study.methods { th.number { code { (method.name()) } } }
                } }
                @for rows in study.rows.chunk_by(|a, b| a.part == b.part) {
                    (part(rows, study.methods.len() + 1))
                }
                tbody {
                    @for (index, what) in ["right", "refused", "wrong"].into_iter().enumerate() { tr {
                        th { (what) }
                        @for method in &study.methods {
                            td.number { (study.counts(*method)[index]) }
                        }
                    } }
                }
            }
        }
        p { (rule(study)) }
        p { (refusals(study)) }
        p { (ORDERS) }
        (orders(&study.orders))
        @if !study.long_runs.is_empty() {
            p { (DRIFT) }
            (long_runs(&study.long_runs))
        }
    }
}

fn long_runs(runs: &[LongRun]) -> Markup {
    html! {
        div.scroll {
            table {
                thead { tr {
                    th { "Scene" } th { "Method" } th.number { "Until" } th.number { "Steps" }
                    th.number { "Before" } th.number { "After" }
                } }
                tbody { @for run in runs { tr {
                    @for (index, cell) in drift_cells(run).into_iter().enumerate() {
                        td.number[index > 1] { (cell) }
                    }
                } } }
            }
        }
    }
}

fn orders(rows: &[ObservedOrders]) -> Markup {
    html! {
        div.scroll {
            table {
                thead { tr {
                    th { "Method" } th.number { "Order" }
                    @for power in POWERS { th.number { "-1e" (power) } }
                } }
                tbody { @for row in rows { tr {
                    td { (row.method) } td.number { (row.nominal) }
                    @for found in &row.orders { td.number { (order(*found)) } }
                } } }
            }
        }
    }
}

fn part(rows: &[Row], columns: usize) -> Markup {
    html! {
        tbody {
            tr.group { th colspan=(columns) scope="rowgroup" { (rows[0].part) } }
            @for row in rows { tr {
                td { (row.case) div.muted { (row.truth) } }
                @for found in &row.cells {
                    td.number title=(title(&found.outcome)) { (shown(&found.outcome)) }
                }
            } }
        }
    }
}

fn shown(outcome: &Outcome) -> Markup {
    match outcome {
        Outcome::Right { .. } => html! { (cell(outcome)) },
        Outcome::Refused { .. } => html! { span.muted { (cell(outcome)) } },
        Outcome::Wrong { .. } => html! { span.badge.fail { (cell(outcome)) } },
    }
}

fn title(outcome: &Outcome) -> String {
    match outcome {
        Outcome::Refused { reason, .. } => reason.clone(),
        Outcome::Right { steps, .. } | Outcome::Wrong { steps, .. } => format!("{steps} steps"),
    }
}
