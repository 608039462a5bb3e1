//! Contents of a scene as plain data, from a spec or a model.

use machinist_model::evaluate::{Evaluator, Inputs};
use machinist_model::{Check as ModelCheck, Model, Reference, RunDefaults, StateKind};
use serde::Serialize;

/// Scene for people and as JSON. A model lacks instances, joints, reductions, and the expressions
/// of events and constraints.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Description {
    pub scene: String,
    pub title: String,
    pub doc: String,
    pub source: String,
    pub instances: Vec<Instance>,
    pub joints: Vec<Joint>,
    pub parameters: Vec<Parameter>,
    pub fields: Vec<Field>,
    pub states: Vec<State>,
    pub outputs: Vec<Quantity>,
    pub events: Vec<Event>,
    pub constraints: Vec<Constraint>,
    /// Loops of frames, and where they are cut.
    pub loops: Vec<String>,
    pub checks: Vec<Check>,
    pub rigid: Vec<String>,
    pub run: RunDefaults,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Instance {
    pub name: String,
    pub unit: String,
    pub title: String,
    pub ports: Vec<Port>,
    pub inputs: Vec<Input>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Port {
    pub name: String,
    /// One of rotational, translational, electrical or frame.
    pub kind: &'static str,
    /// Coordinate that moves with the port, in names of the instance.
    pub moves: String,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Input {
    pub name: String,
    pub unit: String,
    /// Text in the scene.
    pub expression: String,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Joint {
    /// `instance.port`, twice: the first follows the second by the ratio.
    pub connect: [String; 2],
    pub ratio: String,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Parameter {
    #[serde(flatten)]
    pub quantity: Quantity,
    pub value: f64,
    /// True if runs may change the value.
    pub tunable: bool,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Quantity {
    pub name: String,
    pub unit: String,
    pub doc: String,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Field {
    #[serde(flatten)]
    pub quantity: Quantity,
    /// Length in m.
    pub length: f64,
    pub elements: usize,
    pub order: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct State {
    #[serde(flatten)]
    pub quantity: Quantity,
    pub kind: Kind,
    /// Value at the spec's parameters; NaN if only a run determines it.
    pub initial: f64,
    /// True if constraints or a start in equilibrium may change the value.
    pub is_guess: bool,
    /// Other coordinates that joints connect with it.
    pub joined: Vec<String>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    Coordinate,
    Velocity,
    FirstOrder,
    Mode,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Event {
    pub name: String,
    pub doc: String,
    /// Text in the spec, in the names of its unit.
    pub guard: Option<String>,
    pub direction: &'static str,
    pub when: Vec<(String, i32)>,
    pub set: Vec<(String, Option<String>)>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Constraint {
    pub name: String,
    pub doc: String,
    /// Text in the spec, in the names of its unit.
    pub expression: Option<String>,
    pub when: Vec<(String, i32)>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Check {
    pub name: String,
    pub of: String,
    pub reference: String,
    pub tolerance: f64,
    pub absolute: Option<f64>,
    pub source: String,
}

impl Quantity {
    pub fn of(quantity: &machinist_model::Quantity) -> Self {
        let machinist_model::Quantity { name, unit, doc } = quantity;
        let doc = doc.split_whitespace().collect::<Vec<_>>().join(" ");
        Self { name: name.path.clone(), unit: unit.clone(), doc }
    }
}

/// Describes times and values in a few words.
pub fn described_values(rows: &[[f64; 2]]) -> String {
    match rows {
        [] => "no values".to_owned(),
        [[at, value]] => format!("{value} at {at} s"),
        [[first, _], .., [last, _]] => format!("{} values, {first} s to {last} s", rows.len()),
    }
}

impl Description {
    /// Describes the scene of a model.
    pub fn of_model(model: &Model) -> Self {
        let parameters = model.parameters.iter().map(|parameter| Parameter {
            quantity: Quantity::of(&parameter.quantity),
            value: parameter.value,
            tunable: true,
        });
        let fields = model.fields.iter().map(|field| Field {
            quantity: Quantity::of(&field.quantities[0]),
            length: field.length,
            elements: field.elements,
            order: field.order,
        });
        Self {
            scene: model.name.clone(),
            title: model.title.clone(),
            doc: model.doc.clone(),
            source: model.source.clone(),
            parameters: parameters.collect(),
            fields: fields.collect(),
            states: states(model),
            outputs: model.wanted.iter().map(Quantity::of).collect(),
            events: events(model),
            constraints: constraints(model),
            checks: model.checks.iter().map(check).collect(),
            rigid: model.freeze.rigid.clone(),
            run: model.run.clone(),
            ..Self::default()
        }
    }
}

fn states(model: &Model) -> Vec<State> {
    let parameters: Vec<f64> = model.all_parameters().map(|parameter| parameter.value).collect();
    let mut initial = vec![f64::NAN; model.states.len()];
    let tables = &model.tables;
    let inputs = Inputs { parameters: &parameters, tables, ..Inputs::default() };
    Evaluator::new(&model.initial_state).evaluate(&inputs, &mut initial);
    let states = model.states.iter().zip(initial).map(|(state, initial)| State {
        quantity: Quantity::of(&state.quantity),
        kind: match state.kind {
            StateKind::Position(_) => Kind::Coordinate,
            StateKind::Velocity(_) => Kind::Velocity,
            StateKind::FirstOrder => Kind::FirstOrder,
            StateKind::Mode => Kind::Mode,
        },
        initial,
        is_guess: model.starts_in_equilibrium && state.kind != StateKind::Mode
            || !model.constraints.is_empty() && !state.is_given,
        joined: Vec::new(),
    });
    states.collect()
}

fn events(model: &Model) -> Vec<Event> {
    let name = |entry: u32| model.states[entry as usize].quantity.name.path.clone();
    let events = model.events.iter().map(|event| Event {
        name: event.name.path.clone(),
        doc: event.doc.clone(),
        guard: None,
        direction: event.direction.name(),
        when: event.when.iter().map(|(entry, value)| (name(*entry), *value as i32)).collect(),
        set: event.sets.iter().map(|entry| (name(*entry), None)).collect(),
    });
    events.collect()
}

fn constraints(model: &Model) -> Vec<Constraint> {
    let constraints = model.constraints.iter().map(|constraint| Constraint {
        name: constraint.name.path.clone(),
        doc: constraint.doc.clone(),
        expression: None,
        when: Vec::new(),
    });
    constraints.collect()
}

fn check(check: &ModelCheck) -> Check {
    Check {
        name: check.name.clone(),
        of: check.of.clone(),
        reference: match &check.reference {
            Reference::Closed(closed) => closed.text.clone(),
            Reference::Values(rows) => described_values(rows),
        },
        tolerance: check.tolerance,
        absolute: check.absolute,
        source: check.source.clone(),
    }
}
