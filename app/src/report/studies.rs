//! Page of the studies that do not belong to one machine: the questions of the studies' authors,
//! the reproduction ledger, models of a winder, fields, extreme cases.

use maud::html;

use super::gather::Report;
use super::page::{Page, section};
use super::{conclusions, ledger, printed_figures, stability, winder_walk};

/// Renders the page.
pub(super) fn page(report: &Report) -> String {
    let mut contents = vec![
        ("conclusions", CONCLUSIONS),
        ("ledger", "Reproduction ledger"),
        ("printed-figures", FIGURES),
        ("winder-walk", WINDERS),
    ];
    if report.fields.is_some() {
        contents.push(("fields", "Fields"));
    }
    if report.stability.is_some() {
        contents.push(("stability", "Extreme cases"));
    }
    let page = Page {
        title: "Machinist: studies and extreme cases".to_owned(),
        others: vec![("index.html", "All machines")],
        contents: contents.into_iter().map(|(id, name)| (id, name.to_owned())).collect(),
        has_equations: false,
        served: None,
        body: html! {
            header { h1 { "Studies and extreme cases" } }
            (section("conclusions", CONCLUSIONS, &conclusions::section(&report.conclusions)))
            (section("ledger", "Reproduction ledger", &ledger::section(&report.ledger)))
            (section("printed-figures", FIGURES, &printed_figures::section()))
            (section("winder-walk", WINDERS, &winder_walk::section(report)))
            @if let Some(fields) = &report.fields {
                (section("fields", "Fields", &fields.section()))
            }
            @if let Some(study) = &report.stability {
                (section("stability", "Extreme cases", &stability::section(study)))
            }
        },
    };
    page.render()
}

const CONCLUSIONS: &str = "What the authors wanted to know";
const FIGURES: &str = "Figures of the saw gin's shaft";
const WINDERS: &str = "Which model a winder needs";
