//! The page: head, contents, summary, and the sections in their order.

use base64::prelude::{BASE64_STANDARD, Engine as _};
use maud::{DOCTYPE, Markup, PreEscaped, html};

use machinist_studies::work_precision::{Plan, WorkPrecision};

use super::gather::Report;
use super::{figure, ledger, licences, scene, stability, verification, winder_walk};

/// Nothing may be loaded: everything the page needs is in it.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; font-src data:; \
     img-src data: blob:";

/// The command that makes the page.
const COMMAND: &str = "cargo run --release -- report";

/// The whole page as HTML.
pub fn render(report: &Report) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            (head())
            body {
                (contents(report))
                main {
                    (introduction(report))
                    section id="verification" {
                        h2 { "Verification" }
                        (verification::section(&report.verdicts))
                    }
                    @for data in &report.scenes { (scene::section(data)) }
                    @if !report.work_precision.is_empty() {
                        section id="work-precision" {
                            h2 { "Error against run time" }
                            (work_precision(&report.work_precision))
                        }
                    }
                    @if let Some(study) = &report.stability {
                        section id="stability" {
                            h2 { "Extreme cases" }
                            (stability::section(study))
                        }
                    }
                    @if let Some(fields) = &report.fields {
                        section id="fields" {
                            h2 { "Fields" }
                            (fields.section())
                        }
                    }
                    section id="winder-walk" {
                        h2 { "Which model a winder needs" }
                        (winder_walk::section(&report.winder))
                    }
                    section id="ledger" {
                        h2 { "Reproduction ledger" }
                        (ledger::section(&report.ledger))
                    }
                    section id="licences" {
                        h2 { "Licences" }
                        (licences::section())
                    }
                }
                (figure::script())
            }
        }
    };
    page.into_string()
}

fn head() -> Markup {
    html! {
        head {
            meta charset="utf-8";
            meta http-equiv="Content-Security-Policy" content=(POLICY);
            meta name="viewport" content="width=device-width, initial-scale=1";
            meta name="color-scheme" content="light dark";
            title { "Machinist: report" }
            style { (PreEscaped(math_font())) (PreEscaped(include_str!("style.css"))) }
        }
    }
}

/// The font of the equations, within the page: most systems have none that knows
/// how to set mathematics.
fn math_font() -> String {
    let font = BASE64_STANDARD.encode(include_bytes!("font/latinmodern-math.woff2"));
    format!(
        "@font-face {{ font-family: \"Latin Modern Math\"; \
         src: url(data:font/woff2;base64,{font}) format(\"woff2\"); }}\n"
    )
}

fn contents(report: &Report) -> Markup {
    html! {
        nav aria-label="Contents" {
            details open {
                summary { "Contents" }
                ol {
                    li { a href="#summary" { "Summary" } }
                    li { a href="#verification" { "Verification" } }
                    @for scene in &report.scenes {
                        li { a href={ "#" (scene.name()) } { (scene.title()) } }
                    }
                    @if !report.work_precision.is_empty() {
                        li { a href="#work-precision" { "Error against run time" } }
                    }
                    @if report.stability.is_some() {
                        li { a href="#stability" { "Extreme cases" } }
                    }
                    li { a href="#fields" { "Fields" } }
                    li { a href="#winder-walk" { "Which model a winder needs" } }
                li { a href="#ledger" { "Reproduction ledger" } }
                    li { a href="#licences" { "Licences" } }
                }
            }
        }
    }
}

fn introduction(report: &Report) -> Markup {
    let passed = report.verdicts.iter().filter(|verdict| verdict.pass).count();
    let all = report.verdicts.len();
    let stale: Vec<&str> = report.stale().collect();
    html! {
        header id="summary" {
            h1 { "Machinist" }
            p.lead {
                "Lagrangian specs of machines, turned into fast, checked Rust simulators. This page
                 derives every scene from its spec, compares the emitted code with what the specs
                 give, runs it, and holds it against what is known without it."
            }
            dl.strip {
                div class=[(passed < all).then_some("bad")] {
                    dt { "checks passed" } dd { (passed) " / " (all) }
                }
                div { dt { "scenes" } dd { (report.scenes.len()) } }
                div class=[(!stale.is_empty()).then_some("bad")] {
                    dt { "emitted code" } dd { @if stale.is_empty() { "fresh" } @else { "stale" } }
                }
                div { dt { "Machinist" } dd { (env!("CARGO_PKG_VERSION")) } }
                @for (package, version) in PINNED { div { dt { (package) } dd { (version) } } }
            }
            @if !stale.is_empty() {
                p.warning {
                    "Out of date with the specs, and now written anew: " (stale.join(", ")) ". The runs
                     on this page are by the code built before; make the page again to see the new."
                }
            }
            @for orphan in &report.emitted.orphans {
                p.warning { (orphan) " is of a scene that is no more; delete it." }
            }
            p { "Made by " code { (COMMAND) } }
        }
    }
}

fn work_precision(measured: &[WorkPrecision]) -> Markup {
    html! {
        p {
            "Each point is one tolerance, from 1e-2 at the top to 1e-12; each curve is one method.
             The error is the largest over all states and 101 output times, relative to the largest
             value of the state. On the right is the error over the tolerance: a method that keeps
             to what it is asked for runs level there."
        }
        @for scene in measured {
            (figure::work_precision(
                &format!("{}-work-precision", scene.scene),
                scene,
                &html! {
                    code { (scene.scene) } ", measured against " (scene.reference.name) ". Times are
                     medians of up to " (Plan::default().runs) " runs on the machine that made this page; only their
                     ratios mean anything elsewhere."
                },
            ))
        }
    }
}

/// Versions of what is pinned, for the page's foot.
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
