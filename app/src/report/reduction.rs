//! Reduction of a scene, with a drawing of the dependencies.

use std::collections::BTreeMap;

use machinist_codegen::mechanics::dependencies::{Column, Dependencies, Node};
use maud::{Markup, html};

use crate::cli::explain;
use crate::explain::Explanation;

/// Distance of lines, width of columns and margins of the drawing.
const LINE: usize = 22;
const WIDTH: usize = 250;
const TOP: usize = 34;
const COLUMNS: [(Column, &str); 4] = [
    (Column::Output, "outputs"),
    (Column::Equation, "equations"),
    (Column::State, "states"),
    (Column::Parameter, "parameters"),
];
/// Width of a name's box.
const BOX: usize = 180;

/// Renders the section of one scene.
pub fn section(explanation: &Explanation, dependencies: &Dependencies) -> Markup {
    html! {
        @if explanation.reduction.left_out.is_empty() {
            p { "The outputs need all of this scene; nothing is left out." }
        } @else {
            (left_out(explanation))
        }
        (sizes(explanation))
        ul { @for line in explain::structure(explanation) { li { (line) } } }
        @match &explanation.times {
            Some(Ok(times)) => p { (explain::run_times(times)) "." },
            Some(Err(error)) => p.warning { "The runs to compare stopped. " (error) },
            None => {}
        }
        @if !explanation.candidates.is_empty() {
            p { "What could be taken for rigid on request, measured by running both:" }
            ul { @for candidate in &explanation.candidates { li { (explain::price(candidate)) } } }
        }
        figure {
            div.scroll { (drawing(dependencies)) }
            figcaption {
                "Who needs whom, from outputs on the left to parameters on the right; what is left
                 out is dashed."
            }
        }
    }
}

fn left_out(explanation: &Explanation) -> Markup {
    html! {
        div.scroll {
            table {
                thead { tr { th { "Left out" } th { "What" } th { "Why" } th { "Instead" } } }
                tbody {
                    @for thing in &explanation.reduction.left_out {
                        tr {
                            td { code { (thing.name) } }
                            td { (thing.what.name()) }
                            td { (thing.why.name()) }
                            td { (thing.instead) }
                        }
                    }
                }
            }
        }
    }
}

fn sizes(explanation: &Explanation) -> Markup {
    let names = explanation.stages.first().map(|stage| stage.size.figures());
    html! {
        div.scroll {
            table {
                thead { tr {
                    th { "step" }
                    @for (name, _) in names.into_iter().flatten() { th.number { (name) } }
                } }
                tbody {
                    @for stage in &explanation.stages {
                        tr {
                            td { (stage.done) }
                            @for (_, figure) in stage.size.figures() { td.number { (figure) } }
                        }
                    }
                }
            }
        }
    }
}

/// Draws four columns of names and a curve for each dependency.
fn drawing(graph: &Dependencies) -> Markup {
    let mut rows: BTreeMap<Column, usize> = BTreeMap::new();
    let places: Vec<(usize, usize)> = graph
        .nodes
        .iter()
        .map(|node| {
            let row = rows.entry(node.column).or_default();
            let place = (left_of(node.column), TOP + *row * LINE);
            *row += 1;
            place
        })
        .collect();
    let height = TOP + rows.values().max().unwrap_or(&0) * LINE;
    let width = WIDTH * (COLUMNS.len() - 1) + BOX;
    html! {
        svg.needs viewBox={ "0 0 " (width) " " (height) } width=(width) height=(height)
            role="img" aria-label="graph of what needs what" {
            @for (column, heading) in COLUMNS {
                text.heading x=(left_of(column)) y="14" { (heading) }
            }
            @for (from, to) in &graph.edges {
                (edge(&graph.nodes[*from], places[*from], &graph.nodes[*to], places[*to]))
            }
            @for (node, place) in graph.nodes.iter().zip(&places) { (name(node, *place)) }
        }
    }
}

fn left_of(column: Column) -> usize {
    COLUMNS.iter().position(|(known, _)| *known == column).unwrap_or(0) * WIDTH
}

fn edge(from: &Node, start: (usize, usize), to: &Node, end: (usize, usize)) -> Markup {
    let kept = if from.kept && to.kept { "kept" } else { "gone" };
    let (x0, y0, x1, y1) = (start.0 + BOX, start.1 + 8, end.0, end.1 + 8);
    let middle = usize::midpoint(x0, x1);
    html! { path class=(kept) d={ "M" (x0) " " (y0) "C" (middle) " " (y0) " " (middle) " " (y1) " " (x1) " " (y1) }; }
}

fn name(node: &Node, (x, y): (usize, usize)) -> Markup {
    let kept = if node.kept { "kept" } else { "gone" };
    html! {
        g class=(kept) {
            rect x=(x) y=(y) width=(BOX) height=(LINE - 5) rx="3";
            text x=(x + 6) y=(y + 12) { (node.name) }
        }
    }
}
