//! Quantities of a model as FMI knows them: references, causality, variability, start values.
//!
//! References count from 0 in the order of [`Variables::all`]: time, continuous states, their
//! derivatives, modes, parameters, outputs, event indicators.

mod reads;

use std::collections::BTreeSet;

use machinist_contract::{Describe as _, Simulator as _};
use machinist_model::{Model, ModelSimulator, NodeId, Op, StateKind};
use thiserror::Error;

pub use reads::Reads;

/// What a variable is of the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// t.
    Time,
    /// An entry of the state that is no mode.
    State(usize),
    /// Its rate.
    Derivative(usize),
    /// An entry of the state that is a mode.
    Mode(usize),
    /// A parameter.
    Parameter(usize),
    /// A wanted output.
    Output(usize),
    /// What changes its sign at the event, or behind the events at the kink, of this number.
    Indicator(usize),
}

impl Kind {
    /// The entry of the state that it is.
    #[must_use]
    pub fn entry(self) -> Option<usize> {
        match self {
            Self::State(entry) | Self::Mode(entry) => Some(entry),
            _ => None,
        }
    }
}

/// What a variable is to the host.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Causality {
    /// Time.
    Independent,
    /// It sets it before the run, or at events.
    Parameter,
    /// It sets it along the run.
    Input,
    /// It reads it.
    Output,
    /// It may look at it.
    Local,
}

/// When a variable changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Variability {
    /// Never after the start.
    Fixed,
    /// When the host sets it, at events and between steps.
    Tunable,
    /// At events.
    Discrete,
    /// With time.
    Continuous,
}

/// Where a variable's value at the start is from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Initial {
    /// Its start value.
    Exact,
    /// Its start value is a guess.
    Approx,
    /// Others.
    Calculated,
}

/// A variable.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Its name, unique.
    pub name: String,
    /// What it is of the machine.
    pub kind: Kind,
    /// What it is to the host.
    pub causality: Causality,
    /// When it changes.
    pub variability: Variability,
    /// Where its start is from; nothing for time and what the host sets.
    pub initial: Option<Initial>,
    /// SI unit as specs write it; `1` for a pure number.
    pub unit: String,
    /// One sentence of meaning; may be empty.
    pub doc: String,
    /// Its start value, if it has one.
    pub start: Option<f64>,
    /// Its typical size, if that is known.
    pub nominal: Option<f64>,
}

/// Why a model is not exported as wanted.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum Unfit {
    /// It has fields.
    #[error("scene `{scene}` has fields, which cannot be exported as an FMU yet")]
    Fields {
        /// The scene.
        scene: String,
    },
    /// There is no such parameter.
    #[error("scene `{scene}` has no parameter `{name}` that could be an input")]
    UnknownInput {
        /// The scene.
        scene: String,
        /// The name.
        name: String,
    },
    /// The equations of motion take a parameter for constant.
    #[error("parameter `{name}` cannot be an input that changes with time: {why}")]
    NotAnInput {
        /// The parameter.
        name: String,
        /// Where it is used.
        why: &'static str,
    },
}

/// All variables of a model, by reference.
#[derive(Debug, Clone, PartialEq)]
pub struct Variables {
    all: Vec<Variable>,
    /// Entries of the state that are no modes.
    states: Vec<usize>,
    indicators: usize,
}

impl Variables {
    /// Those of a model, of whose parameters these are inputs.
    ///
    /// # Errors
    /// [`Unfit`] if the model has fields, or if such a parameter does not exist or is one that
    /// must not change with time.
    pub fn of(model: &Model, inputs: &[String]) -> Result<Self, Unfit> {
        let scene = || model.name.clone();
        if !model.fields.is_empty() {
            return Err(Unfit::Fields { scene: scene() });
        }
        let uses = Uses::of(model);
        for name in inputs {
            let known = model.parameters.iter().position(|p| p.quantity.name.path == *name);
            let index = known.ok_or_else(|| {
                let name = name.clone();
                Unfit::UnknownInput { scene: scene(), name }
            })?;
            if let Some(why) = uses.forbids_input(index) {
                return Err(Unfit::NotAnInput { name: name.clone(), why });
            }
        }
        let is_mode = |entry: &usize| model.states[*entry].kind == StateKind::Mode;
        let states = (0..model.states.len()).filter(|entry| !is_mode(entry)).collect();
        let indicators = model.events.len() + model.kink_guards.results.len();
        let all = Gather::new(model, &uses, inputs, &states).all();
        Ok(Self { all, states, indicators })
    }

    /// Every variable; its place is its reference.
    #[must_use]
    pub fn all(&self) -> &[Variable] {
        &self.all
    }

    /// The variable of a reference.
    #[must_use]
    pub fn get(&self, reference: u32) -> Option<&Variable> {
        self.all.get(reference as usize)
    }

    /// Every variable with its reference.
    pub fn with_references(&self) -> impl Iterator<Item = (u32, &Variable)> {
        (0..).zip(&self.all)
    }

    /// Reference of what something of the machine is shown as.
    #[must_use]
    pub fn reference(&self, kind: Kind) -> Option<u32> {
        self.with_references().find(|(_, variable)| variable.kind == kind).map(|(at, _)| at)
    }

    /// Entries of the state that are continuous, in the order in which hosts know them.
    #[must_use]
    pub fn states(&self) -> &[usize] {
        &self.states
    }

    /// Number of event indicators.
    #[must_use]
    pub fn indicators(&self) -> usize {
        self.indicators
    }
}

/// Where parameters are used.
struct Uses {
    constraints: Reads,
    kinetic: Reads,
    jumps: Reads,
    motion: Reads,
    initial: Vec<Reads>,
}

impl Uses {
    fn of(model: &Model) -> Self {
        let every = |tapes: &[&machinist_model::Tape]| {
            let mut all = Reads::default();
            for tape in tapes {
                all.extend(&Reads::of_all(model, tape));
            }
            all
        };
        let kinetic = model.energy.results.first();
        let kinetic =
            kinetic.map_or_else(Reads::default, |id| Reads::of(model, &model.energy, *id));
        let of_motion =
            [&model.rate, &model.outputs, &model.guards, &model.resets, &model.kink_guards];
        let constraints =
            [&model.constraint_values, &model.constraint_rates, &model.constraint_matrix.tape];
        let initial = &model.initial_state;
        Self {
            constraints: every(&constraints),
            kinetic,
            jumps: every(&[&model.discontinuities]),
            motion: every(&of_motion),
            initial: initial.results.iter().map(|id| Reads::of(model, initial, *id)).collect(),
        }
    }

    /// Why a parameter must not change with time; nothing if it may.
    fn forbids_input(&self, parameter: usize) -> Option<&'static str> {
        let parameter = parameter as u32;
        let reasons = [
            (&self.constraints, "a constraint depends on it, and would need its rate"),
            (&self.kinetic, "kinetic energy depends on it, and momentum would need its rate"),
            (&self.jumps, "the time of a jump depends on it"),
        ];
        let found = reasons.into_iter().find(|(reads, _)| reads.parameters.contains(&parameter));
        found.map(|(_, why)| why)
    }

    /// Whether a parameter may change at events: what constraints are made of must not, nor
    /// does what matters at the start alone.
    fn is_tunable(&self, parameter: usize) -> bool {
        let parameter = parameter as u32;
        let is_of = |reads: &Reads| reads.parameters.contains(&parameter);
        !is_of(&self.constraints) && (is_of(&self.motion) || is_of(&self.jumps))
    }
}

/// The list as it grows.
struct Gather<'a> {
    model: &'a Model,
    uses: &'a Uses,
    inputs: &'a [String],
    states: &'a Vec<usize>,
    /// The state as the spec has it start.
    start: Vec<f64>,
    names: BTreeSet<String>,
    all: Vec<Variable>,
}

impl<'a> Gather<'a> {
    fn new(model: &'a Model, uses: &'a Uses, inputs: &'a [String], states: &'a Vec<usize>) -> Self {
        let simulator = ModelSimulator::interpreted(model.clone());
        let parameters: Vec<f64> =
            (0..model.parameters.len()).map(|index| simulator.parameter_default(index)).collect();
        let mut start = vec![0.0; model.states.len()];
        simulator.initial_state(&parameters, &mut start);
        // Outputs keep the names that scenes give them.
        let names = model.wanted.iter().map(|wanted| wanted.name.path.clone()).collect();
        let all = Vec::new();
        Self { model, uses, inputs, states, start, names, all }
    }

    fn all(mut self) -> Vec<Variable> {
        self.push(Variable {
            unit: "s".to_owned(),
            doc: "time".to_owned(),
            causality: Causality::Independent,
            initial: None,
            ..continuous("time", Kind::Time)
        });
        for entry in self.states {
            self.push_state(*entry);
        }
        for entry in self.states {
            self.push_derivative(*entry);
        }
        for entry in 0..self.model.states.len() {
            if self.model.states[entry].kind == StateKind::Mode {
                self.push_mode(entry);
            }
        }
        for index in 0..self.model.parameters.len() {
            self.push_parameter(index);
        }
        for (index, wanted) in self.model.wanted.iter().enumerate() {
            if self.state_of_output(index).is_none() {
                self.push(Variable {
                    unit: wanted.unit.clone(),
                    doc: wanted.doc.clone(),
                    causality: Causality::Output,
                    ..continuous(&wanted.name.path, Kind::Output(index))
                });
            }
        }
        self.push_indicators();
        self.all
    }

    /// Takes a variable, under a name that no other has.
    fn push(&mut self, mut variable: Variable) {
        if variable.causality != Causality::Output {
            let group = match variable.kind {
                Kind::Parameter(_) => "parameters",
                Kind::State(_) | Kind::Mode(_) | Kind::Derivative(_) => "states",
                Kind::Time | Kind::Output(_) | Kind::Indicator(_) => "machine",
            };
            while !self.names.insert(variable.name.clone()) {
                variable.name = match variable.name.strip_prefix("der(") {
                    Some(name) => format!("der({group}.{name}"),
                    None => format!("{group}.{}", variable.name),
                };
            }
        }
        self.all.push(variable);
    }

    /// The entry of the state that an output is and is named as.
    fn state_of_output(&self, index: usize) -> Option<usize> {
        let NodeId(result) = *self.model.outputs.results.get(index)?;
        let Op::State(entry) = self.model.outputs.nodes[result as usize].op else { return None };
        let name = &self.model.states[entry as usize].quantity.name.path;
        (*name == self.model.wanted[index].name.path).then_some(entry as usize)
    }

    /// Output or local, for an entry of the state; a scene that wants nothing wants all of them.
    fn causality(&self, entry: usize) -> Causality {
        let mut outputs = 0..self.model.wanted.len();
        let is_output = self.model.wanted.is_empty()
            || outputs.any(|index| self.state_of_output(index) == Some(entry));
        if is_output { Causality::Output } else { Causality::Local }
    }

    fn push_state(&mut self, entry: usize) {
        let state = &self.model.states[entry];
        let is_free = !self.model.constraints.is_empty() && !state.is_given;
        let initial = if is_free {
            Initial::Approx
        } else if self.uses.initial[entry].parameters.is_empty() {
            Initial::Exact
        } else {
            Initial::Calculated
        };
        let name = &state.quantity.name.path;
        self.push(Variable {
            unit: state.quantity.unit.clone(),
            doc: state.quantity.doc.clone(),
            causality: self.causality(entry),
            initial: Some(initial),
            start: (initial != Initial::Calculated).then_some(self.start[entry]),
            nominal: Some(state.scale),
            ..continuous(name, Kind::State(entry))
        });
    }

    fn push_derivative(&mut self, entry: usize) {
        let quantity = &self.model.states[entry].quantity;
        let name = format!("der({})", quantity.name.path);
        self.push(Variable {
            unit: per_second(&quantity.unit),
            doc: format!("rate of {}", quantity.name.path),
            ..continuous(&name, Kind::Derivative(entry))
        });
    }

    fn push_mode(&mut self, entry: usize) {
        let quantity = &self.model.states[entry].quantity;
        self.push(Variable {
            doc: quantity.doc.clone(),
            causality: self.causality(entry),
            variability: Variability::Discrete,
            initial: Some(Initial::Approx),
            start: Some(self.start[entry].round()),
            ..continuous(&quantity.name.path, Kind::Mode(entry))
        });
    }

    fn push_parameter(&mut self, index: usize) {
        let parameter = &self.model.parameters[index];
        let name = &parameter.quantity.name.path;
        let (causality, variability) = if self.inputs.contains(name) {
            (Causality::Input, Variability::Continuous)
        } else if self.uses.is_tunable(index) {
            (Causality::Parameter, Variability::Tunable)
        } else {
            (Causality::Parameter, Variability::Fixed)
        };
        self.push(Variable {
            unit: parameter.quantity.unit.clone(),
            doc: parameter.quantity.doc.clone(),
            causality,
            variability,
            initial: None,
            start: Some(parameter.value),
            ..continuous(name, Kind::Parameter(index))
        });
    }

    fn push_indicators(&mut self) {
        for (index, event) in self.model.events.iter().enumerate() {
            let name = format!("{}.guard", event.name.path);
            let doc = format!("changes its sign where {} happens", event.name.path);
            self.push(Variable { doc, ..continuous(&name, Kind::Indicator(index)) });
        }
        let events = self.model.events.len();
        for kink in 0..self.model.kink_guards.results.len() {
            let name = format!("kink_{}.guard", kink + 1);
            let doc = "changes its sign where rates are not smooth".to_owned();
            self.push(Variable { doc, ..continuous(&name, Kind::Indicator(events + kink)) });
        }
    }
}

/// A local variable that is calculated and changes with time, a pure number without a meaning.
fn continuous(name: &str, kind: Kind) -> Variable {
    Variable {
        name: name.to_owned(),
        kind,
        causality: Causality::Local,
        variability: Variability::Continuous,
        initial: Some(Initial::Calculated),
        unit: "1".to_owned(),
        doc: String::new(),
        start: None,
        nominal: None,
    }
}

/// The unit of a rate.
fn per_second(unit: &str) -> String {
    match unit {
        "1" => "1/s".to_owned(),
        "m" | "rad" => format!("{unit}/s"),
        "m/s" | "rad/s" => format!("{unit}^2"),
        other => format!("({other})/s"),
    }
}
