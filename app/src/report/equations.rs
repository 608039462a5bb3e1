//! Equations as MathML.

mod wrapped;

use machinist_codegen::emit::document::Equation;
use maud::{Markup, PreEscaped, html};
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

/// Renders a group of equations under a heading. Long equations wrap to the width of the page.
pub fn section(heading: &str, equations: &[Equation]) -> Markup {
    html! {
        @if !equations.is_empty() {
            h3 { (heading) }
            dl.equations {
                @for equation in equations {
                    dt { (meaning(equation)) }
                    dd.scroll { (formula(equation)) }
                }
            }
        }
    }
}

fn formula(equation: &Equation) -> Markup {
    let Equation { left, right, unit, .. } = equation;
    let mut pieces = wrapped::pieces(left);
    if let Some(last) = pieces.last_mut() {
        last.push_str(" = ");
    }
    pieces.extend(wrapped::pieces(right));
    html! {
        @for piece in &pieces { (math(piece)) wbr; }
        @if !unit.is_empty() && unit != "1" { span.unit { (unit) } }
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
