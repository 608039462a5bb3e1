//! Quantities of a model as FMI knows them: references, causality, variability, start values.
//!
//! References count from 0 in the order of [`Variables::all`]: time, continuous states, their
//! derivatives, modes, parameters, outputs, event indicators.

mod reads;

use std::collections::BTreeSet;

use machinist::field::FieldError;
use machinist::hosted::{Beginning, Hosted};
use machinist::simulate::parameter_defaults;
use machinist_contract::Simulator;
use machinist_model::{Model, NodeId, Op};
use thiserror::Error;

pub use reads::Reads;

/// Quantity of the machine that a variable stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Time t.
    Time,
    /// Continuous entry of the state.
    State(usize),
    /// Rate of a continuous entry of the state.
    Derivative(usize),
    /// Entry of the state that is a mode.
    Mode(usize),
    /// A parameter.
    Parameter(usize),
    /// Wanted output.
    Output(usize),
    /// Event indicator of this number: a guard or, after the guards of events, a switching surface.
    Indicator(usize),
    /// Largest step of Co-Simulation, which only [sources](Variables::of_sources) have.
    Step,
}

impl Kind {
    /// Returns the entry of the state that the variable is, if it is one.
    #[must_use]
    pub fn entry(self) -> Option<usize> {
        match self {
            Self::State(entry) | Self::Mode(entry) => Some(entry),
            _ => None,
        }
    }
}

/// Role of a variable towards the host.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Causality {
    /// Time.
    Independent,
    /// Set by the host before the run or at events.
    Parameter,
    /// Set by the host along the run.
    Input,
    /// Read by the host.
    Output,
    /// Internal; the host may read it.
    Local,
}

/// Times at which a variable changes.
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

/// Origin of a variable's value at the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Initial {
    /// The start value.
    Exact,
    /// The start value, as a guess.
    Approx,
    /// Computed from other variables.
    Calculated,
}

/// Variable of an FMU.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Unique name.
    pub name: String,
    /// Quantity of the machine.
    pub kind: Kind,
    /// Role towards the host.
    pub causality: Causality,
    /// Times at which it changes.
    pub variability: Variability,
    /// Origin of the value at the start; `None` for time and for what the host sets.
    pub initial: Option<Initial>,
    /// SI unit as specs write it; `1` if dimensionless.
    pub unit: String,
    /// Meaning in one sentence; may be empty.
    pub doc: String,
    /// Start value, if there is one.
    pub start: Option<f64>,
    /// Typical size, if known.
    pub nominal: Option<f64>,
}

/// Reason why a model cannot be exported as wanted.
#[derive(Debug, Clone, PartialEq, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "fmu::", serialize_all = "kebab-case")]
pub enum Unfit {
    /// The scene has no fields to discretize.
    #[error("scene `{scene}` has no fields")]
    NoFields {
        /// Name of the scene.
        scene: String,
    },
    /// The fields cannot be discretized as wanted.
    #[strum(serialize = "")]
    #[error(transparent)]
    Cut(#[from] FieldError),
    /// The parameter does not exist.
    #[error("scene `{scene}` has no parameter `{name}` that could be an input")]
    UnknownInput {
        /// Name of the scene.
        scene: String,
        /// Name of the parameter.
        name: String,
    },
    /// The equations of motion take the parameter to be constant.
    #[error("parameter `{name}` cannot be an input that changes with time: {why}")]
    NotAnInput {
        /// Name of the parameter.
        name: String,
        /// Use that forbids it.
        why: &'static str,
    },
}

impl Unfit {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Cut(error) => error.code(),
            error => error.into(),
        }
    }
}

/// All variables of a model, by reference.
#[derive(Debug, Clone, PartialEq)]
pub struct Variables {
    all: Vec<Variable>,
    /// Continuous entries of the state.
    states: Vec<usize>,
    indicators: usize,
}

impl Variables {
    /// Builds the variables of a model and its simulator, with the parameters named in `inputs` as
    /// inputs.
    ///
    /// # Errors
    /// [`Unfit`] if such a parameter does not exist or must not change with time.
    pub fn of(
        model: &Model,
        simulator: &dyn Simulator<f64>,
        inputs: &[String],
    ) -> Result<Self, Unfit> {
        let scene = || model.name.clone();
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
        let entries = 0..simulator.shape().states();
        let states = entries.filter(|entry| !simulator.is_mode(*entry)).collect();
        let indicators = simulator.events() + simulator.kinks();
        let all = Gather::new((model, simulator), &uses, inputs, &states).all();
        Ok(Self { all, states, indicators })
    }

    /// Returns the variables of an archive with sources: the step of Co-Simulation \[s\], with its
    /// meaning, is a parameter, and an equilibrium at the start is that of the model's parameters,
    /// because sources search for none.
    #[must_use]
    pub fn of_sources(mut self, model: &Model, step: f64, doc: String) -> Self {
        if model.starts_in_equilibrium && model.constraints.is_empty() {
            let states = self.all.iter_mut().filter(|v| matches!(v.kind, Kind::State(_)));
            states.for_each(|state| state.initial = Some(Initial::Exact));
        }
        let mut name = "fixed_step".to_owned();
        while self.all.iter().any(|variable| variable.name == name) {
            name = format!("machine.{name}");
        }
        self.all.push(Variable {
            unit: "s".to_owned(),
            doc,
            causality: Causality::Parameter,
            variability: Variability::Fixed,
            initial: None,
            start: Some(step),
            ..continuous(&name, Kind::Step)
        });
        self
    }

    /// All variables, in the order of their references.
    #[must_use]
    pub fn all(&self) -> &[Variable] {
        &self.all
    }

    /// Returns the variable of a reference.
    #[must_use]
    pub fn get(&self, reference: u32) -> Option<&Variable> {
        self.all.get(reference as usize)
    }

    /// Iterates over all variables with their references.
    pub fn with_references(&self) -> impl Iterator<Item = (u32, &Variable)> {
        (0..).zip(&self.all)
    }

    /// Returns the reference of the variable that stands for a quantity of the machine.
    #[must_use]
    pub fn reference(&self, kind: Kind) -> Option<u32> {
        self.with_references().find(|(_, variable)| variable.kind == kind).map(|(at, _)| at)
    }

    /// Continuous entries of the state, in the order in which hosts know them.
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

/// Uses of parameters in a model.
struct Uses {
    constraints: Reads,
    kinetic: Reads,
    jumps: Reads,
    motion: Reads,
    initial: Vec<Reads>,
    /// Parameters that fields depend on.
    fields: BTreeSet<u32>,
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
            fields: model.fields.iter().flat_map(|field| &field.parameters).copied().collect(),
        }
    }

    /// Returns the reason why a parameter must not change with time; `None` if it may.
    fn forbids_input(&self, parameter: usize) -> Option<&'static str> {
        let parameter = parameter as u32;
        let reasons = [
            (&self.constraints, "a constraint depends on it, and would need its rate"),
            (&self.kinetic, "kinetic energy depends on it, and momentum would need its rate"),
            (&self.jumps, "the time of a jump depends on it"),
        ];
        let found = reasons.into_iter().find(|(reads, _)| reads.parameters.contains(&parameter));
        let of_fields = self.fields.contains(&parameter).then_some("a field depends on it");
        found.map(|(_, why)| why).or(of_fields)
    }

    /// Returns whether a parameter may change at events. Parameters that constraints or fields
    /// depend on must not, nor those that matter only at the start.
    fn is_tunable(&self, parameter: usize) -> bool {
        let parameter = parameter as u32;
        let is_of = |reads: &Reads| reads.parameters.contains(&parameter);
        !is_of(&self.constraints)
            && !self.fields.contains(&parameter)
            && (is_of(&self.motion) || is_of(&self.jumps))
    }
}

/// List of variables under construction.
struct Gather<'a> {
    model: &'a Model,
    simulator: &'a dyn Simulator<f64>,
    uses: &'a Uses,
    inputs: &'a [String],
    states: &'a Vec<usize>,
    /// State at the start of a run with the spec's parameters.
    start: Vec<f64>,
    names: BTreeSet<String>,
    all: Vec<Variable>,
}

impl<'a> Gather<'a> {
    fn new(
        (model, simulator): (&'a Model, &'a dyn Simulator<f64>),
        uses: &'a Uses,
        inputs: &'a [String],
        states: &'a Vec<usize>,
    ) -> Self {
        let shape = simulator.shape();
        let parameters = parameter_defaults(simulator);
        let mut start = vec![0.0; shape.states()];
        simulator.initial_state(&parameters, &mut start);
        if simulator.starts_in_equilibrium() {
            start = equilibrium((model, simulator), &parameters, &start).unwrap_or(start);
        }
        // Outputs keep the names that scenes give them.
        let names = model.wanted.iter().map(|wanted| wanted.name.path.clone()).collect();
        let all = Vec::new();
        Self { model, simulator, uses, inputs, states, start, names, all }
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
        for entry in 0..self.start.len() {
            if self.simulator.is_mode(entry) {
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

    /// Adds a variable under a unique name.
    fn push(&mut self, mut variable: Variable) {
        if variable.causality != Causality::Output {
            let group = match variable.kind {
                Kind::Parameter(_) => "parameters",
                Kind::State(_) | Kind::Mode(_) | Kind::Derivative(_) => "states",
                Kind::Time | Kind::Output(_) | Kind::Indicator(_) | Kind::Step => "machine",
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

    /// Returns the entry of the state whose value and name an output has.
    fn state_of_output(&self, index: usize) -> Option<usize> {
        if !self.model.fields.is_empty() {
            // The states of fields stand between those of the machine, so that entries have other
            // numbers.
            return None;
        }
        let NodeId(result) = *self.model.outputs.results.get(index)?;
        let Op::State(entry) = self.model.outputs.nodes[result as usize].op else { return None };
        let name = &self.model.states[entry as usize].quantity.name.path;
        (*name == self.model.wanted[index].name.path).then_some(entry as usize)
    }

    /// Returns the causality of an entry of the state: output or local. All entries are outputs if
    /// the scene lists none.
    fn causality(&self, entry: usize) -> Causality {
        let mut outputs = 0..self.model.wanted.len();
        let is_output = self.model.wanted.is_empty()
            || outputs.any(|index| self.state_of_output(index) == Some(entry));
        if is_output { Causality::Output } else { Causality::Local }
    }

    fn push_state(&mut self, entry: usize) {
        let state = self.simulator.state(entry);
        let is_free = self.simulator.starts_in_equilibrium()
            || !self.model.constraints.is_empty() && !self.simulator.is_given(entry);
        let is_of_none =
            self.model.fields.is_empty() && self.uses.initial[entry].parameters.is_empty();
        let initial = if is_free {
            Initial::Approx
        } else if is_of_none {
            Initial::Exact
        } else {
            Initial::Calculated
        };
        self.push(Variable {
            unit: state.unit.to_owned(),
            doc: state.doc.to_owned(),
            causality: self.causality(entry),
            initial: Some(initial),
            start: (initial != Initial::Calculated).then_some(self.start[entry]),
            nominal: Some(self.simulator.state_scale(entry)),
            ..continuous(state.name, Kind::State(entry))
        });
    }

    fn push_derivative(&mut self, entry: usize) {
        let state = self.simulator.state(entry);
        let name = format!("der({})", state.name);
        self.push(Variable {
            unit: per_second(state.unit),
            doc: format!("rate of {}", state.name),
            ..continuous(&name, Kind::Derivative(entry))
        });
    }

    fn push_mode(&mut self, entry: usize) {
        let state = self.simulator.state(entry);
        self.push(Variable {
            doc: state.doc.to_owned(),
            causality: self.causality(entry),
            variability: Variability::Discrete,
            initial: Some(Initial::Approx),
            start: Some(self.start[entry].round()),
            ..continuous(state.name, Kind::Mode(entry))
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

/// Computes the equilibrium near a state in which a run with these parameters starts. `None` if
/// there is none, because the host may set other parameters.
fn equilibrium(
    (model, simulator): (&Model, &dyn Simulator<f64>),
    parameters: &[f64],
    near: &[f64],
) -> Option<Vec<f64>> {
    let (from, until, rtol) = (model.run.from, model.run.until, model.run.rtol);
    let is_given = &|entry: usize| simulator.is_given(entry);
    let state = near.to_vec();
    let [is_stepped, in_equilibrium] = [false, true];
    let beginning = Beginning { from, until, rtol, is_stepped, state, is_given, in_equilibrium };
    Some(Hosted::new(simulator, parameters).begin(beginning).ok()?.state)
}

/// Builds a calculated, continuous local variable, dimensionless and without a description.
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

/// Returns the unit of the rate of a quantity with this unit.
fn per_second(unit: &str) -> String {
    match unit {
        "1" => "1/s".to_owned(),
        "m" | "rad" => format!("{unit}/s"),
        "m/s" | "rad/s" => format!("{unit}^2"),
        other => format!("({other})/s"),
    }
}
