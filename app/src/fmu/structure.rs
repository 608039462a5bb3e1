//! Dependencies of the unknowns of a model.

use std::collections::BTreeSet;

use machinist_fmu::variables::{Causality, Initial, Kind, Reads, Variable, Variables};
use machinist_model::{Model, Tape};

use super::xml::Element;

/// List of a model's structure that an unknown is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum List {
    Outputs,
    Derivatives,
    AtStart,
    Indicators,
}

/// Unknown of a model's structure.
pub struct Unknown {
    pub list: List,
    /// Value reference.
    pub at: u32,
    /// Value references of what it depends on; `None` if that may be everything.
    pub dependencies: Option<BTreeSet<u32>>,
}

/// Structure of a model.
pub struct Structure<'a> {
    model: &'a Model,
    variables: &'a Variables,
}

impl<'a> Structure<'a> {
    pub fn new(model: &'a Model, variables: &'a Variables) -> Self {
        Self { model, variables }
    }

    /// Returns the elements of FMI 3.0.
    pub fn elements(&self) -> Vec<Element> {
        let element = |unknown: Unknown| {
            let name = match unknown.list {
                List::Outputs => "Output",
                List::Derivatives => "ContinuousStateDerivative",
                List::AtStart => "InitialUnknown",
                List::Indicators => "EventIndicator",
            };
            let dependencies = unknown.dependencies.map(|all| joined(all.into_iter()));
            let element = Element::new(name).with("valueReference", unknown.at);
            element.with_some("dependencies", dependencies)
        };
        self.unknowns().into_iter().map(element).collect()
    }

    /// Returns outputs, derivatives, unknowns of the start, and event indicators.
    pub fn unknowns(&self) -> Vec<Unknown> {
        let along = |list: List, is: fn(&Variable) -> bool| {
            let all = self.variables.with_references().filter(move |(_, variable)| is(variable));
            all.map(move |(at, variable)| {
                let dependencies =
                    (!self.has_fields()).then(|| self.along_the_run(&self.reads(variable.kind)));
                Unknown { list, at, dependencies }
            })
        };
        let is_output = |variable: &Variable| variable.causality == Causality::Output;
        let is_derivative = |variable: &Variable| matches!(variable.kind, Kind::Derivative(_));
        let is_indicator = |variable: &Variable| matches!(variable.kind, Kind::Indicator(_));
        let mut unknowns: Vec<Unknown> = along(List::Outputs, is_output).collect();
        unknowns.extend(along(List::Derivatives, is_derivative));
        unknowns.extend(self.unknown_at_start());
        unknowns.extend(along(List::Indicators, is_indicator));
        unknowns
    }

    /// Returns whether the model has fields. Tapes do not contain their nodes, so any unknown may
    /// depend on everything.
    fn has_fields(&self) -> bool {
        !self.model.fields.is_empty()
    }

    fn unknown_at_start(&self) -> impl Iterator<Item = Unknown> {
        let is_unknown = |variable: &Variable| match variable.kind {
            Kind::Output(_) | Kind::Derivative(_) => true,
            Kind::State(_) => variable.initial != Some(Initial::Exact),
            Kind::Mode(_) => variable.causality == Causality::Output,
            Kind::Time | Kind::Parameter(_) | Kind::Indicator(_) | Kind::Step => false,
        };
        let all = self.variables.with_references();
        all.filter(move |(_, variable)| is_unknown(variable)).map(|(at, variable)| {
            let is_whole = self.model.constraints.is_empty()
                && self.model.events.is_empty()
                && !self.model.starts_in_equilibrium;
            if !is_whole || self.has_fields() {
                // Constraints, equilibria and corrected modes couple all unknowns of the start.
                return Unknown { list: List::AtStart, at, dependencies: None };
            }
            let reads = match variable.kind {
                Kind::State(entry) => self.start_of(entry),
                kind => self.reads(kind),
            };
            let dependencies = Some(self.at_start(&reads));
            Unknown { list: List::AtStart, at, dependencies }
        })
    }

    /// Returns the direct dependencies of a variable at a state of the run.
    fn reads(&self, kind: Kind) -> Reads {
        let model = self.model;
        let of = |tape: &Tape, index: usize| match tape.results.get(index) {
            Some(result) => Reads::of(model, tape, *result),
            None => Reads::default(),
        };
        match kind {
            Kind::Derivative(entry) => {
                let mut reads = of(&model.rate, entry);
                let row = |pattern: &machinist_model::SparsityPattern| -> BTreeSet<u32> {
                    let entries = pattern.entries.iter();
                    entries.filter(|(row, _)| *row as usize == entry).map(|(_, at)| *at).collect()
                };
                reads.states.extend(row(&model.rate_jacobian.pattern));
                reads.parameters.extend(row(&model.parameter_jacobian.pattern));
                reads
            }
            Kind::Output(index) => of(&model.outputs, index),
            Kind::Indicator(index) => match index.checked_sub(model.events.len()) {
                None => of(&model.guards, index),
                Some(kink) => of(&model.kink_guards, kink),
            },
            Kind::State(entry) | Kind::Mode(entry) => {
                Reads { states: [entry as u32].into(), ..Reads::default() }
            }
            Kind::Time | Kind::Parameter(_) | Kind::Step => Reads::default(),
        }
    }

    fn start_of(&self, entry: usize) -> Reads {
        let tape = &self.model.initial_state;
        Reads::of(self.model, tape, tape.results[entry])
    }

    /// Returns the knowns along a run: time, continuous states, inputs.
    fn along_the_run(&self, reads: &Reads) -> BTreeSet<u32> {
        self.knowns(reads, &|variable| match variable.kind {
            Kind::State(_) | Kind::Time => true,
            _ => variable.causality == Causality::Input,
        })
    }

    /// Returns the knowns at the start: time, parameters, inputs, and states that start exactly.
    /// States that are calculated are replaced by their own dependencies.
    fn at_start(&self, reads: &Reads) -> BTreeSet<u32> {
        let mut all = reads.clone();
        for variable in self.variables.all() {
            if let (Kind::State(entry), Some(Initial::Calculated)) =
                (variable.kind, variable.initial)
                && reads.states.contains(&(entry as u32))
            {
                all.extend(&self.start_of(entry));
            }
        }
        self.knowns(&all, &|variable| match variable.kind {
            Kind::State(_) => variable.initial == Some(Initial::Exact),
            Kind::Time | Kind::Parameter(_) => true,
            _ => false,
        })
    }

    fn knowns(&self, reads: &Reads, is_known: &dyn Fn(&Variable) -> bool) -> BTreeSet<u32> {
        let is_read = |variable: &Variable| match variable.kind {
            Kind::Time => reads.time,
            Kind::State(entry) => reads.states.contains(&(entry as u32)),
            Kind::Parameter(index) => reads.parameters.contains(&(index as u32)),
            _ => false,
        };
        let all = self.variables.with_references();
        all.filter(|(_, variable)| is_known(variable) && is_read(variable))
            .map(|(at, _)| at)
            .collect()
    }
}

/// Joins numbers to a list of XML.
pub fn joined(numbers: impl Iterator<Item = impl ToString>) -> String {
    numbers.map(|number| number.to_string()).collect::<Vec<_>>().join(" ")
}
