//! First page: a summary of the report and a card for each machine.

use machinist::Method;
use machinist_studies::verify::Tally;
use maud::{Markup, html};

use super::gather::{Report, page_of};
use super::machine::Machine;
use super::page::{Page, section};
use super::verification::badge;
use super::{figure, key, licences, schematic, verification};

/// Command that makes the report.
const COMMAND: &str = "cargo run --release -- report";
/// Number of figures on a card.
const FIGURES: usize = 3;

/// Renders the page.
pub(super) fn page(report: &Report) -> String {
    let cards = html! {
        div.cards { @for machine in &report.machines { (card(machine)) } }
    };
    let page = Page {
        title: "Machinist: report".to_owned(),
        others: vec![("studies.html", "Studies and extreme cases")],
        contents: [("summary", "Summary"), ("machines", "Machines"), ("licences", "Licences")]
            .map(|(id, name)| (id, name.to_owned()))
            .to_vec(),
        has_equations: false,
        served: None,
        body: html! {
            (introduction(report))
            (section("machines", "Machines", &cards))
            (section("licences", "Licences", &licences::section()))
        },
    };
    page.render()
}

fn card(machine: &Machine) -> Markup {
    let tally = machine.tally();
    html! {
        a.card href=(page_of(machine.name())) {
            div.picture { (picture(machine)) }
            h3 { (machine.title()) }
            p.muted { code { (machine.name()) } }
            dl {
                @for figure in machine.figures().iter().take(FIGURES) { (figure.entry()) }
            }
            p { (badge(tally.is_clean())) " " (of_card(tally)) }
        }
    }
}

/// Renders the curves of the quantity that loads the machine most; without a run, the drawing.
fn picture(machine: &Machine) -> Markup {
    let run = machine.trajectory();
    let curves = run.map(|run| (run, key::foremost(run))).filter(|(_, curves)| !curves.is_empty());
    match curves {
        Some((run, curves)) => figure::thumbnail(&run.times, &curves),
        None => schematic::drawing(&machine.schematic),
    }
}

fn of_card(tally: Tally) -> String {
    let Tally { checked, passed, left_out, unchecked } = tally;
    let left_out = if left_out == 0 { String::new() } else { format!(", {left_out} left out") };
    let unchecked =
        if unchecked == 0 { String::new() } else { format!(", {unchecked} not checked") };
    format!("{passed} of {checked} checks{left_out}{unchecked}")
}

fn introduction(report: &Report) -> Markup {
    let stale: Vec<&str> = report.stale().collect();
    html! {
        header id="summary" {
            h1 { "Machinist" }
            p.lead {
                "Lagrangian specs of machines, turned into fast, checked Rust simulators. For this
                 report every scene was derived from its spec, the emitted code compared with what
                 the specs give, run, and held against what is known without it."
            }
            dl.strip {
                (verification::entry(Tally::of(&report.verdicts)))
                div { dt { "machines" } dd { (report.machines.len()) } }
                div class=[(!stale.is_empty()).then_some("bad")] {
                    dt { "emitted code" }
                    dd {
                        @if report.emitted.is_none() { "not compared" }
                        @else if stale.is_empty() { "fresh" }
                        @else { "stale" }
                    }
                }
                div { dt { "Machinist" } dd { (env!("CARGO_PKG_VERSION")) } }
                @for (package, version) in PINNED.into_iter().filter(|(package, _)| is_in(package)) { div { dt { (package) } dd { (version) } } }
            }
            @if !stale.is_empty() {
                p.warning {
                    "Out of date with the specs, and now written anew: " (stale.join(", ")) ". The runs
                     of this report are by the code built before; make it again to see the new."
                }
            }
            @for orphan in report.emitted.iter().flat_map(|emitted| &emitted.orphans) {
                p.warning { (orphan) " is of a scene that is no more; delete it." }
            }
            p {
                "Made by " code { (COMMAND) } ". " code { (COMMAND) " own.toml" } " makes the page of a
                 machine of your own. What the textile studies print, held against what their
                 equations give, and extreme cases by every method are on "
                a href="studies.html" { "a page of their own" } "."
            }
        }
    }
}

/// Returns whether this build has a pinned package.
fn is_in(package: &str) -> bool {
    package != "diffsol" || Method::Bdf.is_compiled_in()
}

/// Versions of pinned packages.
const PINNED: [(&str, &str); 2] = [("diffsol", "0.18.0"), ("Symbolica", "2.2.0")];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_those_of_the_lock_file() {
        const LOCK: &str = include_str!("../../../Cargo.lock");
        for (package, version) in PINNED {
            let entry = format!("name = \"{}\"\nversion = \"{version}\"", package.to_lowercase());
            assert!(LOCK.contains(&entry), "{package}");
        }
    }
}
