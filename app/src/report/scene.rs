//! Page of one machine: description, run, checks, equations, parameters, structure.

use machinist::trajectory::{Column, ColumnKind, Trajectory};
use machinist_codegen::emit::document::Document;
use machinist_model::Model;
use machinist_studies::work_precision::{Plan, WorkPrecision};
use maud::{Markup, html};

use super::live::{Live, motion as motion_of, scripts, still};
use super::machine::{By, Machine};
use super::page::{Page, prose, section};
use super::space::Space;
use super::{equations, fields, figure, key, modes, reduction, schematic, verification};
use crate::cli::specs::{Cost, costs};
use crate::explain::Explanation;
use crate::number::{exact, number};
use crate::plot::alike;

/// Page of a machine in pieces.
pub(super) struct Pieces {
    pub(super) title: String,
    pub(super) header: Markup,
    /// Sections by id, title and content.
    pub(super) sections: Vec<(&'static str, &'static str, Markup)>,
    /// Data of the machine that runs or moves in the page, as JSON.
    pub(super) known: Option<String>,
}

impl Pieces {
    /// Renders the pieces for a machine, without the sections whose data are missing.
    pub(super) fn of(machine: &Machine) -> Self {
        let model = &machine.model;
        let (name, argument) = (machine.name(), machine.argument.as_str());
        let moving = &machine.moving;
        let run = machine.trajectory();
        let space = run.and_then(|run| Space::of(model, run, &moving.entries()));
        let live = Live::of(machine, space.as_ref());
        let known = match (&live, &space) {
            (Some(Ok(live)), _) => Some(live.known()),
            (_, Some(space)) => Some(still(name, moving, space)),
            _ => None,
        };
        let mut sections = vec![
            (
                "machine",
                "The machine",
                picture(machine, space.as_ref(), matches!(live, Some(Ok(_)))),
            ),
            ("run", "Run", ran(machine, argument, live.as_ref())),
        ];
        if !machine.verdicts.is_empty() {
            let checks = verification::section(&machine.verdicts, &verify_command(machine));
            sections.push(("checks", "Checks", checks));
        }
        if let Some(found) = &machine.modes {
            let content = modes::section(argument, found);
            sections.push(("modes", "Modes at the operating point", content));
        }
        sections.extend([
            ("equations", "Equations of motion", motion(&machine.document)),
            ("parameters", "Parameters", parameters(model)),
        ]);
        if let Some(explanation) = &machine.explanation {
            sections.push(("needs", "What the outputs need", needs(machine, explanation)));
        }
        if let Some(measured) = &machine.work_precision {
            sections.push(("methods", "Error against run time", methods(name, measured)));
        }
        let title = format!("{}: Machinist", machine.title());
        Self { title, header: header(machine), sections, known }
    }

    /// Returns the sections by id and title.
    pub(super) fn contents(&self) -> Vec<(&'static str, String)> {
        self.sections.iter().map(|(id, name, _)| (*id, (*name).to_owned())).collect()
    }
}

/// Renders the page of a machine, with a link to the others if there are any.
pub(super) fn page(machine: &Machine, has_index: bool) -> String {
    let pieces = Pieces::of(machine);
    let page = Page {
        contents: pieces.contents(),
        title: pieces.title,
        others: if has_index { vec![("../index.html", "All machines")] } else { Vec::new() },
        has_equations: true,
        served: None,
        body: html! {
            (pieces.header)
            @for (id, title, content) in &pieces.sections { (section(id, title, content)) }
            @if let Some(known) = &pieces.known { (scripts(known)) }
        },
    };
    page.render()
}

/// Returns the command that verifies the machine. Built-in scenes have rows of their own beside
/// those of any machine.
fn verify_command(machine: &Machine) -> String {
    let argument = &machine.argument;
    match machine.by {
        By::Emitted => format!("machinist verify --only {argument}"),
        By::Compiled | By::Interpreted => format!("machinist verify {argument}"),
    }
}

fn header(machine: &Machine) -> Markup {
    let model = &machine.model;
    html! {
        header id="summary" {
            h1 { (model.title) }
            p.muted { code { (model.name) } }
            @for paragraph in machine.doc.split("\n\n") { p { (prose(paragraph)) } }
            (sources(&model.source))
            dl.strip {
                @if !machine.verdicts.is_empty() { (verification::entry(machine.tally())) }
                @for figure in machine.figures() { (figure.entry()) }
            }
        }
    }
}

/// Renders the source of a scene, or those of its parts, one a line.
fn sources(text: &str) -> Markup {
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).collect();
    html! {
        @match lines.as_slice() {
            [] => {}
            [only] => p.muted { "Source: " (prose(only)) },
            _ => details.muted {
                summary { "Sources of " (lines.len()) " parts" }
                ul { @for line in lines { li { (prose(line)) } } }
            }
        }
    }
}

fn picture(machine: &Machine, space: Option<&Space>, is_live: bool) -> Markup {
    let model = &machine.model;
    let counts = [
        ("parts", machine.schematic.parts()),
        ("coordinates", model.coordinates.len()),
        ("first-order states", model.first_order()),
        ("constraints", model.constraints.len()),
        ("events", model.events.len()),
        ("parameters", model.parameters.len()),
    ];
    html! {
        @if space.is_some() { (motion_of(&machine.moving, space)) }
        figure {
            (schematic::legend(&machine.schematic))
            div.scroll { (schematic::drawing(&machine.schematic)) }
        }
        @if space.is_none() && is_live { (motion_of(&machine.moving, None)) }
        dl.counts {
            @for (what, count) in counts.into_iter().filter(|(_, count)| *count > 0) {
                div { dt { (what) } dd { (count) } }
            }
        }
        (machine.schematic.list())
    }
}

/// Renders the run, up to where it stopped if it did.
fn ran(machine: &Machine, argument: &str, live: Option<&Result<Live, String>>) -> Markup {
    html! {
        @if let Err(error) = &machine.run { p.warning { "The run stopped. " (error) } }
        @if let Some(trajectory) = machine.trajectory() {
            (run(machine, argument, trajectory, live))
        }
        (fields::section(machine.name(), &machine.along))
    }
}

fn needs(machine: &Machine, explanation: &Explanation) -> Markup {
    html! {
        (reduction::section(explanation, &machine.dependencies))
        h3 { "What is emitted" }
        (emitted(&machine.model))
    }
}

fn methods(name: &str, measured: &WorkPrecision) -> Markup {
    html! {
        p {
            "Each point is one tolerance, from 1e-2 at the top to 1e-12; each curve is one method.
             The error is the largest over all states and 101 output times, relative to the largest
             value of the state. On the right is the error over the tolerance: a method that keeps
             to what it is asked for runs level there."
        }
        (figure::work_precision(
            &format!("{name}-work-precision"),
            measured,
            &html! {
                "Measured against " (measured.reference.name) ". Times are medians of up to "
                (Plan::default().runs) " runs on the machine that made this page; only their ratios
                 mean anything elsewhere."
            },
        ))
    }
}

fn motion(document: &Document) -> Markup {
    html! {
        (equations::section("Energies", &document.energies))
        (equations::section("Coordinates", &document.motion))
        (equations::section("First-order states", &document.first_order))
        (equations::section("Constraints", &document.constraints))
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

fn emitted(model: &Model) -> Markup {
    html! {
        div.scroll {
            table {
                thead { tr {
                    th { "Function" } th { "Computes" } th.number { "Numbers" }
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

fn run(
    machine: &Machine,
    argument: &str,
    trajectory: &Trajectory,
    live: Option<&Result<Live, String>>,
) -> Markup {
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
    let how = match machine.by {
        By::Emitted => "Emitted code",
        By::Compiled => "JIT-compiled",
        By::Interpreted => "Interpreted",
    };
    let (first, last) = match trajectory.times.as_slice() {
        [first, .., last] => (*first, *last),
        _ => (f64::NAN, f64::NAN),
    };
    html! {
        p {
            (how) ", method " code { (trajectory.method) } " at relative tolerance "
            (exact(trajectory.rtol)) ", from " (exact(first)) " s to " (exact(last)) " s, with the
             energy account integrated alongside. The same run: "
            code { "machinist run " (argument) }
        }
        (key::table(trajectory))
        @if !machine.model.events.is_empty() { div #run-events { (switches(trajectory)) } }
        @for note in &trajectory.notes { p.muted { (note) } }
        dl.counts { @for (what, count) in counters { div { dt { (what) } dd { (count) } } } }
        @match live {
            Some(Ok(live)) => (live.controls()),
            Some(Err(why)) => p.muted { (why) },
            None => {}
        }
        @for (index, group) in alike(key::shown(trajectory)).iter().enumerate() {
            (figure::over_time(
                &format!("{}-outputs-{index}", machine.name()),
                &trajectory.times,
                group,
                &meanings(group),
            ))
        }
        (energy(machine.name(), trajectory))
    }
}

/// Renders how often each event happened, and its first and last time.
fn switches(trajectory: &Trajectory) -> Markup {
    let mut events: Vec<(&str, usize, f64, f64)> = Vec::new();
    for switch in &trajectory.switches {
        match events.iter_mut().find(|(event, ..)| *event == switch.event) {
            Some((_, count, _, last)) => (*count, *last) = (*count + 1, switch.time),
            None => events.push((&switch.event, 1, switch.time, switch.time)),
        }
    }
    html! {
        @if !events.is_empty() {
            div.scroll {
                table {
                    thead { tr {
                        th { "Event" } th.number { "Times" } th.number { "First [s]" }
                        th.number { "Last [s]" }
                    } }
                    tbody { @for (event, count, first, last) in events { tr {
                        td { code { (event) } } td.number { (count) }
                        td.number { (number(first, 6)) } td.number { (number(last, 6)) }
                    } } }
                }
            }
        }
    }
}

/// Renders `motor_speed: angular speed of the rotor; ...`
fn meanings(columns: &[&Column]) -> Markup {
    html! {
        @for (index, column) in columns.iter().enumerate() {
            @if index > 0 { "; " }
            code { (column.name) }
            @if !column.doc.is_empty() && column.doc != column.name { " " (column.doc) }
        }
    }
}

fn energy(name: &str, trajectory: &Trajectory) -> Markup {
    let Some(balance) = &trajectory.energy_balance else { return html! {} };
    let energies: Vec<&Column> = trajectory.of_kind(ColumnKind::Energy).collect();
    let (residual, flows): (Vec<&Column>, Vec<&Column>) =
        energies.into_iter().partition(|column| column.name == "energy.residual");
    let id = |what: &str| format!("{name}-{what}");
    let account = html! {
        "Energy stored, supplied since the start and lost since the start."
    };
    let remainder = html! {
        "What remains of stored \u{2212} at start \u{2212} supplied + lost: equations and
         integration together. At most " (number(balance.max_residual_relative(), 2)) " of the
         energy that has passed."
    };
    html! {
        h3 { "Energy balance" }
        p.muted data-of-stored hidden { "That of the stored run, not of what the sliders say." }
        (figure::over_time(&id("energy"), &trajectory.times, &flows, &account))
        (figure::over_time(&id("residual"), &trajectory.times, &residual, &remainder))
    }
}
