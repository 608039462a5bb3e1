//! Description of a model as the contract has it: names, shapes and patterns.

use machinist_contract::{
    Constraint, Describe, Direction, Event, Quantity, Refusal, Relation, RunDefaults, Shape,
    SparsityPattern,
};

use super::ModelSimulator;
use crate::{StateKind, names};

impl ModelSimulator {
    fn parameter_at(&self, index: usize) -> &crate::Parameter {
        let own = self.model.parameters.len();
        index
            .checked_sub(own)
            .map_or_else(|| &self.model.parameters[index], |k| &self.model.handed[k])
    }
}

impl Describe for ModelSimulator {
    fn name(&self) -> &str {
        &self.model.name
    }
    fn title(&self) -> &str {
        &self.model.title
    }
    fn shape(&self) -> Shape {
        let model = &self.model;
        Shape {
            coordinates: model.coordinates.len(),
            positions: model.positions(),
            first_order: model.first_order(),
            quadratures: model.quadratures,
            parameters: model.parameters.len() + model.handed.len(),
            outputs: model.wanted.len(),
            discontinuities: model.discontinuities.results.len(),
        }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        self.model.states[index].quantity.described()
    }
    fn state_kind(&self, index: usize) -> machinist_contract::StateKind {
        self.model.states[index].kind.described()
    }
    fn coordinate(&self, index: usize) -> Quantity<'_> {
        self.model.coordinates[index].position.described()
    }
    fn state_scale(&self, index: usize) -> f64 {
        self.model.states[index].scale
    }
    fn parameter(&self, index: usize) -> Quantity<'_> {
        self.parameter_at(index).quantity.described()
    }
    fn parameter_default(&self, index: usize) -> f64 {
        self.parameter_at(index).value
    }
    fn output(&self, index: usize) -> Quantity<'_> {
        self.model.wanted[index].described()
    }
    fn output_answers_at_once(&self, index: usize) -> bool {
        self.model.at_once.contains(&(index as u32))
    }
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> {
        self.model.rate_jacobian.pattern.borrowed()
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        self.model.parameter_jacobian.pattern.borrowed()
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        self.model.mass_matrix.pattern.borrowed()
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        let run = &self.model.run;
        RunDefaults {
            from: run.from,
            until: run.until,
            points: run.points,
            times: &run.times,
            rtol: run.rtol,
            method: &run.method,
        }
    }
    fn events(&self) -> usize {
        self.model.events.len()
    }
    fn event(&self, index: usize) -> Event<'_> {
        let event = &self.model.events[index];
        Event {
            name: &event.name.path,
            doc: &event.doc,
            direction: match event.direction {
                names::Direction::Rising => Direction::Rising,
                names::Direction::Falling => Direction::Falling,
                names::Direction::Both => Direction::Both,
            },
            when: &event.when,
            sets: &event.sets,
            counts: self.counters[index],
            moves_guard: self.moves_guard[index],
        }
    }
    fn is_mode(&self, index: usize) -> bool {
        self.model.states[index].kind == StateKind::Mode
    }
    fn kinks(&self) -> usize {
        self.model.kink_guards.results.len()
    }
    fn inertia_has_corners(&self) -> bool {
        self.inertia_has_corners
    }
    fn saturations(&self) -> usize {
        self.model.saturating_arguments.results.len()
    }
    fn relations(&self) -> usize {
        self.model.relations.len()
    }
    fn relation(&self, index: usize) -> Relation<'_> {
        let crate::Relation { kind, readers } = &self.model.relations[index];
        Relation { kind: *kind, readers }
    }
    fn constraints(&self) -> usize {
        self.model.constraints.len()
    }
    fn constraint(&self, index: usize) -> Constraint<'_> {
        let constraint = &self.model.constraints[index];
        Constraint {
            name: &constraint.name.path,
            unit: &constraint.unit,
            doc: &constraint.doc,
            is_of_positions: constraint.is_of_positions,
            in_modes: constraint.in_modes,
            friction: constraint.friction,
            jumps: constraint.jumps,
        }
    }
    fn constraint_matrix_pattern(&self) -> SparsityPattern<'_> {
        self.model.constraint_matrix.pattern.borrowed()
    }
    fn starts_in_equilibrium(&self) -> bool {
        self.model.starts_in_equilibrium
    }
    fn refusal(&self, parameters: &[f64]) -> Option<Refusal<'_>> {
        let (requirement, value) = self.model.unfulfilled(parameters)?;
        Some(Refusal { rule: &requirement.rule, value })
    }
    fn is_unused(&self, parameter: &str) -> bool {
        self.model.is_unused(parameter)
    }
    fn conserves_energy(&self, parameters: &[f64]) -> Option<bool> {
        self.model.conserves_energy(parameters)
    }
    fn is_given(&self, index: usize) -> bool {
        self.model.states[index].is_given
    }
}
