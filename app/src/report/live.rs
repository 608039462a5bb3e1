//! Live page of a machine: the model as WebAssembly, methods as scripts, and sliders of its
//! parameters. Without scripts the page stays static.

mod moving;
mod order;

use base64::prelude::{BASE64_STANDARD, Engine as _};
use machinist::field::Discretisation;
use machinist::method::Method;
use machinist::method::published::{ExplicitTable, RosenbrockTable, dop853, rodas5p, tsit5};
use machinist::trajectory::Trajectory;
use machinist_contract::{Reader, RelationKind};
use machinist_model::functions::FunctionId;
use machinist_model::wasm::{Layout, NotInWasm, WasmModule, module};
use machinist_model::{Model, ModelSimulator, SparsityPattern, StateKind};
use maud::{Markup, PreEscaped, html};
use serde::Serialize;

pub(super) use moving::Moving;
pub(super) use order::by_run;

use super::machine::Machine;
use super::space::Space;
use crate::fields::divided;
use crate::number::exact;

/// Scripts that run a machine, in the order of their dependencies.
const ENGINE: [&str; 9] = [
    include_str!("live/machine.js"),
    include_str!("live/matrix.js"),
    include_str!("live/constraints.js"),
    include_str!("live/system.js"),
    include_str!("live/steps.js"),
    include_str!("live/roots.js"),
    include_str!("live/relations.js"),
    include_str!("live/watch.js"),
    include_str!("live/run.js"),
];
/// Scripts that show it.
const DISPLAY: [&str; 7] = [
    include_str!("live/chart.js"),
    include_str!("live/controls.js"),
    include_str!("live/tables.js"),
    include_str!("live/motion.js"),
    include_str!("live/places.js"),
    include_str!("live/space.js"),
    include_str!("live/page.js"),
];

/// Maximum bytes of a module, so that a page stays below 1.5 MB in total.
const LARGEST: usize = 500_000;
/// Maximum bytes of a module beside a drawing in space, whose equations take room too.
const LARGEST_IN_SPACE: usize = 300_000;
/// Number of sliders in view; others are folded away.
const IN_SIGHT: usize = 8;
/// Maximum number of points of a run in a page; more would not be visible.
const MOST_POINTS: usize = 2001;

/// Functions that every page runs. Some machines have more.
const FUNCTIONS: [FunctionId; 13] = [
    FunctionId::InitialState,
    FunctionId::Discontinuities,
    FunctionId::Rate,
    FunctionId::Outputs,
    FunctionId::Guards,
    FunctionId::GuardRates,
    FunctionId::Resets,
    FunctionId::MassMatrix,
    FunctionId::ConstraintValues,
    FunctionId::ConstraintRates,
    FunctionId::ConstraintMatrix,
    FunctionId::KinkGuards,
    FunctionId::KinkRates,
];
/// Functions that only implicit methods call.
const OF_IMPLICIT: [FunctionId; 2] = [FunctionId::RateJacobian, FunctionId::TimeDerivative];

/// Scripts and data that run a machine as its page does, for programs without a page.
#[derive(Debug, Clone)]
pub struct Headless {
    /// Scripts in the order of their dependencies.
    pub engine: String,
    /// Data of the machine, as JSON.
    pub known: String,
}

impl Headless {
    /// Returns the page's data and scripts for a model with its run.
    ///
    /// # Errors
    /// A sentence that says why the machine cannot run in a page.
    pub fn of(model: &Model, run: &Trajectory) -> Result<Self, String> {
        let live = Live::of_run((model, &model.name), &Moving::default(), run, (None, None))?;
        Ok(Self { engine: ENGINE.concat(), known: live.known() })
    }
}

/// Scripts and data that place the elements of a machine's drawing in space, as its page does.
#[derive(Debug, Clone)]
pub struct HeadlessDrawing {
    /// Scripts in the order of their dependencies.
    pub scripts: String,
    /// Data of the drawing, as JSON.
    pub known: String,
}

impl HeadlessDrawing {
    /// Returns the page's data and scripts for a model with its run; `None` without a drawing.
    #[must_use]
    pub fn of(model: &Model, run: &Trajectory) -> Option<Self> {
        let space = Space::of(model, run, &[])?;
        let scripts = [include_str!("live/motion.js"), include_str!("live/places.js")].concat();
        Some(Self { scripts, known: serde_json::to_string(&space).ok()? })
    }
}

/// Data and order of parameters of a live page.
pub(super) struct Live {
    known: Known,
    /// Parameters in the order of their effect on the run, the largest first.
    order: Vec<usize>,
}

/// Data of the machine for scripts.
#[derive(Serialize)]
struct Known {
    name: String,
    /// Command that runs the machine outside of the page.
    command: String,
    /// Module in base 64.
    module: String,
    layout: Layout,
    coordinates: usize,
    states: Vec<State>,
    parameters: Vec<Parameter>,
    /// Names of the quantities shown: outputs, or states if there are none.
    outputs: Vec<String>,
    shows_states: bool,
    discontinuities: usize,
    events: Vec<Event>,
    /// Number of guards of kinks, those of relations first.
    kinks: usize,
    relations: Vec<Relation>,
    constraints: Vec<Constraint>,
    rate_jacobian: SparsityPattern,
    mass_matrix: SparsityPattern,
    constraint_matrix: SparsityPattern,
    moving: Moving,
    #[serde(skip_serializing_if = "Option::is_none")]
    space: Option<Space>,
    methods: Methods,
    run: RunOfPage,
    /// Present if the machine starts in equilibrium.
    #[serde(skip_serializing_if = "Option::is_none")]
    equilibrium: Option<Equilibrium>,
}

/// Data of a machine that is shown moving but does not run in the page.
#[derive(Serialize)]
struct Still<'a> {
    name: &'a str,
    moving: &'a Moving,
    space: &'a Space,
}

/// Start of the stored run, and the guess near which it was found.
#[derive(Serialize)]
struct Equilibrium {
    guess: Vec<f64>,
    state: Vec<f64>,
    /// Unknown states: positions, first-order states, velocities that are not zero.
    unknown: Vec<usize>,
    /// States whose rates are zero.
    still: Vec<usize>,
}

#[derive(Serialize)]
struct State {
    name: String,
    scale: f64,
    kind: &'static str,
    is_given: bool,
}

#[derive(Serialize)]
struct Relation {
    kind: &'static str,
    /// Kind of each reader and its index, if it has one.
    readers: Vec<(&'static str, u32)>,
}

#[derive(Serialize)]
struct Constraint {
    name: String,
    in_modes: bool,
    /// The mode of dry friction, as an entry of the state.
    friction: Option<u32>,
}

#[derive(Serialize)]
struct Parameter {
    name: String,
    unit: String,
    doc: String,
    value: f64,
}

#[derive(Serialize)]
struct Event {
    name: String,
    direction: &'static str,
    when: Vec<(u32, f64)>,
    sets: Vec<u32>,
    /// True if the event only counts, so that no step ends there.
    counts: bool,
}

#[derive(Serialize)]
struct Methods {
    explicit: ExplicitTable,
    implicit: Option<RosenbrockTable>,
}

#[derive(Serialize)]
struct RunOfPage {
    from: f64,
    until: f64,
    points: usize,
    /// Output times, if they are not equally spaced.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    times: Vec<f64>,
    rtol: f64,
    method: &'static str,
    /// True if the spec's method is for stiff machines.
    is_stiff: bool,
    /// True if the spec's method is always explicit.
    stays_explicit: bool,
}

impl Live {
    /// Builds the live page of a machine with its stored run; `None` without a run.
    ///
    /// # Errors
    /// A sentence that says why the machine cannot run in a page.
    pub(super) fn of(machine: &Machine, space: Option<&Space>) -> Option<Result<Self, String>> {
        let run = machine.trajectory()?;
        let (model, order) = (&machine.model, machine.order.as_deref());
        let argument = &machine.argument;
        Some(Self::of_run((model, argument), &machine.moving, run, (order, space)))
    }

    fn of_run(
        (model, argument): (&Model, &str),
        moving: &Moving,
        run: &Trajectory,
        (order, space): (Option<&[usize]>, Option<&Space>),
    ) -> Result<Self, String> {
        let refused = |why: &dyn std::fmt::Display| format!("The page cannot run it: {why}.");
        if !model.fields.is_empty() {
            let whole = divided(model, Discretisation::default(), Model::divided);
            let whole = whole.map_err(|why| refused(&why))?;
            let moving = moving.moved(model.coordinates.len(), whole.coordinates.len());
            return Self::of_run((&whole, argument), &moving, run, (order, space));
        }
        if !model.constraints.is_empty() && model.positions() > model.coordinates.len() {
            return Err(refused(&"it has constraints and an orientation"));
        }
        let (module, is_implicit) = modules(model).map_err(|error| refused(&error))?;
        if module.bytes.len() > largest(model) {
            let size = module.bytes.len() / 1000;
            return Err(refused(&format!("its equations would take {size} kB of the page")));
        }
        let order = order.map_or_else(|| order::at_once(model, run), <[usize]>::to_vec);
        let mut known = Known::of((model, argument), moving, run, (&module, is_implicit));
        known.space = space.cloned();
        Ok(Self { known, order })
    }

    /// Renders the sliders, which the script shows once the machine runs.
    pub(super) fn controls(&self) -> Markup {
        let (first, rest) = self.order.split_at(self.order.len().min(IN_SIGHT));
        let RunOfPage { until, .. } = self.known.run;
        html! {
            div #live hidden {
                h3 { "Try it" }
                p {
                    "The machine runs in this page. What is moved is simulated again at once; the
                     stored run stays as thin dashed lines."
                    @if self.known.equilibrium.is_some() {
                        " Each run starts in the equilibrium near that of the stored one."
                    }
                }
                div.sliders {
                    @for index in first { (self.slider(*index)) }
                    (slider("until", "until", "s", "end of the run", until))
                }
                @if !rest.is_empty() {
                    details {
                        summary { (rest.len()) " more parameters, which do less to this run" }
                        div.sliders { @for index in rest { (self.slider(*index)) } }
                    }
                }
                p.tools {
                    button type="button" id="live-reset" { "Reset all" }
                    code #live-command {}
                }
                p #live-state role="status" {}
            }
        }
    }

    fn slider(&self, index: usize) -> Markup {
        let Parameter { name, unit, doc, value } = &self.known.parameters[index];
        slider(&index.to_string(), name, unit, doc, *value)
    }

    /// Returns the data of the machine for scripts, as JSON.
    pub(super) fn known(&self) -> String {
        serde_json::to_string(&self.known).unwrap_or_default()
    }
}

/// Returns the data of a machine that does not run in the page, as JSON.
pub(super) fn still(name: &str, moving: &Moving, space: &Space) -> String {
    serde_json::to_string(&Still { name, moving, space }).unwrap_or_default()
}

/// Renders the animated drawing with its controls, which the script shows. Empty if nothing in it
/// moves.
pub(super) fn motion(moving: &Moving, space: Option<&Space>) -> Markup {
    html! {
        @if space.is_some() || !moving.is_empty() {
            div #live-motion hidden {
                @if space.is_some() { (Space::figure()) }
                figure.plane hidden {
                    svg viewBox="0 0 880 320" role="img" aria-label="bodies in the plane" {}
                }
                p.tools.player {
                    button type="button" { "Play" }
                    input type="range" min="0" max="1000" step="1" value="0"
                        aria-label="time of the run";
                    output {}
                }
            }
        }
    }
}

/// Renders the data and scripts of a machine, for the end of the page.
pub(super) fn scripts(known: &str) -> Markup {
    html! {
        (data(known))
        script { (PreEscaped(script())) }
    }
}

/// Renders the data of a machine for scripts.
pub(super) fn data(known: &str) -> Markup {
    html! {
        script type="application/json" id="live-known" {
            // Escaped so that no text of a spec ends the script.
            (PreEscaped(known.replace('<', "\\u003c")))
        }
    }
}

/// Returns the script that runs the machine of [`data`].
pub(super) fn script() -> String {
    format!("(() => {{\n\"use strict\";\n{}{}}})();\n", ENGINE.concat(), DISPLAY.concat())
}

/// Renders a slider with its number and a reset. The script sets its range.
fn slider(key: &str, name: &str, unit: &str, doc: &str, value: f64) -> Markup {
    let unit = if unit == "1" { "" } else { unit };
    html! {
        div.slider data-key=(key) data-value=(exact(value)) {
            label for={ "live-" (key) } { code { (name) } " " span.muted { (doc) } }
            input type="range" id={ "live-" (key) } min="0" max="1000" step="1";
            input type="number" step="any" value=(exact(value)) aria-label={ "value of " (name) };
            span.unit { (unit) }
            button type="button" aria-label={ "reset " (name) } title={ "back to " (exact(value)) } {
                "\u{21ba}"
            }
        }
    }
}

/// Returns the maximum bytes of the module of a machine.
fn largest(model: &Model) -> usize {
    if model.drawing.is_some() { LARGEST_IN_SPACE } else { LARGEST }
}

/// Compiles the module, with the functions of implicit methods if they fit. Returns whether they
/// did.
fn modules(model: &Model) -> Result<(WasmModule, bool), NotInWasm> {
    // Divided fields have no Jacobian here.
    if model.rate_jacobian.tape.results.is_empty() {
        return module(model, &FUNCTIONS).map(|module| (module, false));
    }
    let all: Vec<FunctionId> = FUNCTIONS.into_iter().chain(OF_IMPLICIT).collect();
    match module(model, &all) {
        Ok(whole) if whole.bytes.len() <= largest(model) => Ok((whole, true)),
        Err(error @ (NotInWasm::Fields | NotInWasm::Malformed)) => Err(error),
        _ => module(model, &FUNCTIONS).map(|module| (module, false)),
    }
}

impl Known {
    fn of(
        (model, argument): (&Model, &str),
        moving: &Moving,
        run: &Trajectory,
        (module, is_implicit): (&WasmModule, bool),
    ) -> Self {
        let state = |state: &machinist_model::State| State {
            name: state.quantity.name.path.clone(),
            scale: state.scale,
            kind: match state.kind {
                StateKind::Position(_) => "position",
                StateKind::Velocity(_) => "velocity",
                StateKind::FirstOrder => "first order",
                StateKind::Mode => "mode",
            },
            is_given: state.is_given,
        };
        let parameter = |parameter: &machinist_model::Parameter| Parameter {
            name: parameter.quantity.name.path.clone(),
            unit: parameter.quantity.unit.clone(),
            doc: parameter.quantity.doc.clone(),
            value: parameter.value,
        };
        let simulator = ModelSimulator::interpreted(model.clone());
        let event = |(index, event): (usize, &machinist_model::Event)| Event {
            name: event.name.path.clone(),
            direction: event.direction.name(),
            when: event.when.clone(),
            sets: event.sets.clone(),
            counts: simulator.single().event(index).counts,
        };
        let constraint = |known: &machinist_model::Constraint| Constraint {
            name: known.name.path.clone(),
            in_modes: known.in_modes,
            friction: known.friction,
        };
        let outputs = model.wanted.iter().map(|output| output.name.path.clone());
        let states: Vec<State> = model.states.iter().map(state).collect();
        let shows_states = model.wanted.is_empty();
        let outputs = if shows_states {
            states.iter().map(|state| state.name.clone()).collect()
        } else {
            outputs.collect()
        };
        let is_tsit5 = matches!(run.method, Method::Tsit5 | Method::Tsit45);
        Self {
            name: model.name.clone(),
            command: format!("machinist run {argument}"),
            module: BASE64_STANDARD.encode(&module.bytes),
            layout: module.layout,
            coordinates: model.coordinates.len(),
            states,
            parameters: model.parameters.iter().map(parameter).collect(),
            outputs,
            shows_states,
            discontinuities: model.discontinuities.results.len(),
            events: model.events.iter().enumerate().map(event).collect(),
            kinks: model.kink_guards.results.len(),
            relations: model.relations.iter().map(Relation::of).collect(),
            constraints: model.constraints.iter().map(constraint).collect(),
            rate_jacobian: model.rate_jacobian.pattern.clone(),
            mass_matrix: model.mass_matrix.pattern.clone(),
            constraint_matrix: model.constraint_matrix.pattern.clone(),
            moving: moving.clone(),
            space: None,
            methods: Methods {
                explicit: if is_tsit5 { tsit5() } else { dop853() },
                implicit: is_implicit.then(rodas5p),
            },
            run: RunOfPage {
                from: model.run.from,
                until: model.run.until,
                points: model.run.points.clamp(2, MOST_POINTS),
                times: Some(&model.run.times)
                    .filter(|times| times.len() <= MOST_POINTS)
                    .cloned()
                    .unwrap_or_default(),
                rtol: run.rtol,
                method: run.method.name(),
                is_stiff: is_implicit
                    && run.method.is_implicit()
                    && !matches!(run.method, Method::Auto | Method::Exact),
                stays_explicit: is_tsit5 || run.method == Method::Dop853,
            },
            equilibrium: model.starts_in_equilibrium.then(|| equilibrium(model, run)),
        }
    }
}

impl Relation {
    fn of(relation: &machinist_model::Relation) -> Self {
        let reader = |reader: &Reader| match *reader {
            Reader::Rate => ("rate", 0),
            Reader::Event(index) => ("event", index),
            Reader::Relation(index) => ("relation", index),
            Reader::Below(index) => ("below", index),
            Reader::Above(index) => ("above", index),
        };
        let kind = match relation.kind {
            RelationKind::Branch => "branch",
            RelationKind::Whole => "whole",
            RelationKind::Zone => "zone",
        };
        Self { kind, readers: relation.readers.iter().map(reader).collect() }
    }
}

fn equilibrium(model: &Model, run: &Trajectory) -> Equilibrium {
    let simulator = ModelSimulator::interpreted(model.clone());
    let parameters: Vec<f64> = model.parameters.iter().map(|known| known.value).collect();
    let mut guess = vec![0.0; model.states.len()];
    simulator.single().initial_state(&parameters, &mut guess);
    let states = run.columns.iter().take(model.states.len());
    let state: Vec<f64> = states.map(|column| column.values[0]).collect();
    let places = |is: &dyn Fn(usize) -> bool| (0..state.len()).filter(|at| is(*at)).collect();
    let unknown = places(&|at| match model.states[at].kind {
        StateKind::Position(_) | StateKind::FirstOrder => true,
        StateKind::Velocity(_) => state[at] != 0.0,
        StateKind::Mode => false,
    });
    let still = places(&|at| {
        matches!(model.states[at].kind, StateKind::Velocity(_) | StateKind::FirstOrder)
    });
    Equilibrium { guess, state, unknown, still }
}
