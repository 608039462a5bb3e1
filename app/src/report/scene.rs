//! One scene: what it is, its equations, parameters, structure, run and energy.

use machinist::trajectory::{Column, ColumnKind, Trajectory};
use machinist_codegen::emit::document::Document;
use machinist_model::Model;
use maud::{Markup, html};

use super::gather::SceneData;
use super::{equations, fields, figure, modes, reduction};
use crate::cli::specs::{Cost, costs};
use crate::number::{exact, number};

/// The section of a scene.
pub fn section(scene: &SceneData) -> Markup {
    let model = &scene.model;
    html! {
        section id=(model.name) {
            h2 { (model.title) }
            p.muted { code { (model.name) } }
            @for paragraph in model.doc.split("\n\n") { p { (paragraph) } }
            @if !model.source.is_empty() { p.muted { "Source: " (model.source) } }
            h3 { "Equations of motion" }
            (motion(&scene.document))
            h3 { "Parameters" }
            (parameters(model))
            h3 { "Structure" }
            (structure(model))
            h3 { "What the outputs need" }
            (reduction::section(&scene.explanation, &scene.dependencies))
            h3 { "Run" }
            @match &scene.run {
                Ok(trajectory) => (run(scene, trajectory)),
                Err(error) => p.warning { "The run stopped. " (error) },
            }
            (fields::section(scene.name(), &scene.along))
            (modes::section(scene.name(), scene.modes.as_ref()))
        }
    }
}

fn motion(document: &Document) -> Markup {
    html! {
        (equations::section("Energies", &document.energies))
        (equations::section("Coordinates", &document.motion))
        (equations::section("First-order states", &document.first_order))
        (equations::section("Events", &document.events))
        (equations::section("With", &document.helpers))
        (equations::section("Outputs", &document.outputs))
    }
}

fn parameters(model: &Model) -> Markup {
    html! {
        div.scroll {
            table {
                thead { tr { th { "Parameter" } th.number { "Value" } th { "Unit" } th { "Meaning" } } }
                tbody {
                    @for parameter in &model.parameters {
                        tr {
                            td { code { (parameter.quantity.name.path) } }
                            td.number { (exact(parameter.value)) }
                            td.unit { (parameter.quantity.unit) }
                            td { (parameter.quantity.doc) }
                        }
                    }
                }
            }
        }
    }
}

fn structure(model: &Model) -> Markup {
    let counts = [
        ("states", model.states.len()),
        ("coordinates", model.coordinates.len()),
        ("first-order states", model.first_order()),
        ("parameters", model.parameters.len()),
        ("outputs", model.wanted.len()),
        ("known jumps", model.discontinuities.results.len()),
    ];
    html! {
        dl.counts { @for (what, count) in counts { div { dt { (what) } dd { (count) } } } }
        div.scroll {
            table {
                thead { tr {
                    th { "Emitted function" } th { "Computes" } th.number { "Numbers" }
                    th.number { "Of" } th.number { "Filled" } th.number { "Operations" }
                } }
                tbody { @for cost in costs(model) { (cost_row(&cost)) } }
            }
        }
    }
}

fn cost_row(cost: &Cost) -> Markup {
    let filled = |full: usize| 100.0 * cost.results as f64 / full.max(1) as f64;
    html! {
        tr {
            td { code { (cost.function) } }
            td { (cost.meaning) }
            td.number { (cost.results) }
            td.number { @if let Some(full) = cost.full { (full) } }
            td.number { @if let Some(full) = cost.full { (number(filled(full), 3)) " %" } }
            td.number { (cost.operations) }
        }
    }
}

fn run(scene: &SceneData, trajectory: &Trajectory) -> Markup {
    let work = trajectory.work;
    let counters = [
        ("steps", work.steps),
        ("rejected steps", work.rejected),
        ("rate evaluations", work.rate_evaluations),
        ("Jacobians", work.jacobian_evaluations),
        ("factorizations", work.factorizations),
        ("Newton iterations", work.newton_iterations),
        ("switches", work.switches),
    ];
    let how = if scene.is_built_in { "Emitted code" } else { "Compiled at once" };
    let (first, last) = match trajectory.times.as_slice() {
        [first, .., last] => (*first, *last),
        _ => (f64::NAN, f64::NAN),
    };
    html! {
        p {
            (how) ", method " code { (trajectory.method) } " at relative tolerance "
            (exact(trajectory.rtol)) ", from " (exact(first)) " s to " (exact(last)) " s, with the
             energy account integrated alongside. The same run: "
            code { "machinist run " (scene.name()) }
        }
        dl.counts { @for (what, count) in counters { div { dt { (what) } dd { (count) } } } }
        @for (index, group) in by_unit(trajectory).iter().enumerate() {
            (figure::over_time(
                &format!("{}-outputs-{index}", scene.name()),
                &trajectory.times,
                group,
                &meanings(group),
            ))
        }
        (energy(scene, trajectory))
    }
}

/// Outputs of one unit share a figure; states if a scene has no outputs.
fn by_unit(trajectory: &Trajectory) -> Vec<Vec<&Column>> {
    let mut groups: Vec<Vec<&Column>> = Vec::new();
    let mut columns: Vec<&Column> = trajectory.of_kind(ColumnKind::Output).collect();
    if columns.is_empty() {
        columns = trajectory.of_kind(ColumnKind::State).collect();
    }
    for column in columns {
        match groups.iter_mut().find(|group| group[0].unit == column.unit) {
            Some(group) => group.push(column),
            None => groups.push(vec![column]),
        }
    }
    groups
}

/// `motor_speed: angular speed of the rotor; ...`
fn meanings(columns: &[&Column]) -> Markup {
    html! {
        @for (index, column) in columns.iter().enumerate() {
            @if index > 0 { "; " }
            code { (column.name) }
            @if !column.doc.is_empty() && column.doc != column.name { " " (column.doc) }
        }
    }
}

fn energy(scene: &SceneData, trajectory: &Trajectory) -> Markup {
    let Some(balance) = &trajectory.energy_balance else { return html! {} };
    let energies: Vec<&Column> = trajectory.of_kind(ColumnKind::Energy).collect();
    let (residual, flows): (Vec<&Column>, Vec<&Column>) =
        energies.into_iter().partition(|column| column.name == "energy.residual");
    let id = |what: &str| format!("{}-{what}", scene.name());
    let account = html! {
        "Energy stored, supplied since the start and lost since the start."
    };
    let remainder = html! {
        "What remains of stored \u{2212} at start \u{2212} supplied + lost: equations and
         integration together. At most " (number(balance.max_residual_relative(), 2)) " of the
         energy that has passed."
    };
    html! {
        h4 { "Energy balance" }
        (figure::over_time(&id("energy"), &trajectory.times, &flows, &account))
        (figure::over_time(&id("residual"), &trajectory.times, &residual, &remainder))
    }
}
