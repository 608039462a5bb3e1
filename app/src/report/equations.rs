//! Equations as MathML.

use machinist_codegen::emit::document::Equation;
use maud::{Markup, PreEscaped, html};
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

/// Renders a group of equations under a heading, aligned at their equals signs.
pub fn section(heading: &str, equations: &[Equation]) -> Markup {
    html! {
        @if !equations.is_empty() {
            h3 { (heading) }
            div.scroll {
                table.equations {
                    @for equation in equations { (row(equation)) }
                }
            }
        }
    }
}

fn row(equation: &Equation) -> Markup {
    html! {
        tr.meaning { td colspan="4" { (meaning(equation)) } }
        tr {
            td.left { (math(&equation.left)) }
            td { (math("=")) }
            td.right { (math(&equation.right)) }
            td.unit { @if !equation.unit.is_empty() && equation.unit != "1" { (equation.unit) } }
        }
    }
}

/// Renders the spec's name of a quantity and its meaning.
fn meaning(equation: &Equation) -> Markup {
    html! {
        @if equation.subject.len() > 1 { code { (equation.subject) } }
        @if !equation.doc.is_empty() && equation.doc != equation.subject { " " (equation.doc) }
    }
}

/// Converts LaTeX to MathML, or returns it unchanged if the converter fails.
fn math(latex: &str) -> Markup {
    let storage = Storage::new();
    let events: Result<Vec<_>, _> = Parser::new(latex, &storage).collect();
    let config = RenderConfig { display_mode: DisplayMode::Block, ..RenderConfig::default() };
    let mut mathml = String::new();
    let converted = events
        .ok()
        .and_then(|events| {
            let events = events.into_iter().map(Ok::<_, std::convert::Infallible>);
            push_mathml(&mut mathml, events, config).ok()
        })
        .is_some();
    html! {
        @if converted { (PreEscaped(mathml)) } @else { code { (latex) } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn latex_becomes_mathml_and_what_is_not_latex_stays_readable() {
        let good = math(r"\frac{1}{2} J_{\mathrm{motor}} \dot{\varphi}_{\mathrm{motor}}^{2}");
        assert!(good.0.contains("<mfrac>"), "{}", good.0);
        assert!(math(r"\frac{1}{").0.contains("<code>"));
    }
}
