//! Fields of scenes run from their tapes.

use std::cell::RefCell;

use machinist_contract::field::{FieldAttachment, FieldDescription, FieldPoint, FieldScene};

use super::InterpretedSimulator;
use crate::evaluate::{Evaluator, Inputs};
use crate::{FieldModel, Model};

/// The point functions of one field.
#[derive(Debug)]
pub(super) struct InterpretedField {
    attachments: Vec<FieldAttachment>,
    parameters: Vec<u32>,
    inertia: RefCell<Evaluator>,
    inertia_gradient: RefCell<Evaluator>,
    force: RefCell<Evaluator>,
    force_jacobian: RefCell<Evaluator>,
    force_gradient: RefCell<Evaluator>,
    energy: RefCell<Evaluator>,
    power: RefCell<Evaluator>,
    places: RefCell<Evaluator>,
    places_gradient: RefCell<Evaluator>,
    initial: RefCell<Evaluator>,
}

impl InterpretedField {
    pub(super) fn new(model: &Model, field: &FieldModel) -> Self {
        let prepared = |tape| RefCell::new(Evaluator::new(tape));
        let own = model.parameters.len();
        Self {
            attachments: field.attachments.iter().map(|at| at.described(own)).collect(),
            parameters: field.parameters.clone(),
            inertia: prepared(&field.inertia),
            inertia_gradient: prepared(&field.inertia_gradient),
            force: prepared(&field.force),
            force_jacobian: prepared(&field.force_jacobian),
            force_gradient: prepared(&field.force_gradient),
            energy: prepared(&field.energy),
            power: prepared(&field.power),
            places: prepared(&field.places),
            places_gradient: prepared(&field.places_gradient),
            initial: prepared(&field.initial),
        }
    }
}

impl InterpretedSimulator {
    fn at_point(
        &self,
        evaluator: &RefCell<Evaluator>,
        (time, x, point): (f64, f64, &FieldPoint<f64>),
        p: &[f64],
        results: &mut [f64],
    ) {
        let [value, slope, rate, slope_rate] = *point;
        let state = [value, slope, rate, slope_rate, x];
        let inputs = Inputs { state: &state, ..self.inputs_without_state(time, p) };
        evaluator.borrow_mut().evaluate(&inputs, results);
    }

    fn at_place(&self, evaluator: &RefCell<Evaluator>, x: f64, p: &[f64], results: &mut [f64]) {
        self.at_point(evaluator, (0.0, x, &[0.0; 4]), p, results);
    }
}

impl FieldScene<f64> for InterpretedSimulator {
    fn fields(&self) -> usize {
        self.fields.len()
    }
    fn field(&self, index: usize) -> FieldDescription<'_> {
        let field = &self.model().fields[index];
        let [value, slope, rate, ..] = &field.quantities;
        FieldDescription {
            value: value.described(),
            rate: rate.described(),
            slope: slope.described(),
            scale: field.scale,
            fixed: field.fixed,
            length: field.length,
            attachments: &self.fields[index].attachments,
            parameters: &self.fields[index].parameters,
            elements: field.elements,
            order: field.order,
        }
    }
    fn jacobian_reads_forces(&self) -> bool {
        self.model().jacobian_reads_forces()
    }
    fn field_is_linear(&self, index: usize) -> bool {
        self.model().fields[index].is_linear
    }
    fn field_is_local(&self, index: usize) -> bool {
        self.model().fields[index].local.is_some()
    }
    fn field_inertia(&self, index: usize, x: f64, p: &[f64]) -> f64 {
        let mut inertia = [0.0];
        self.at_place(&self.fields[index].inertia, x, p, &mut inertia);
        inertia[0]
    }
    fn field_inertia_gradient(&self, index: usize, x: f64, p: &[f64], gradient: &mut [f64]) {
        self.at_place(&self.fields[index].inertia_gradient, x, p, gradient);
    }
    fn field_force(
        &self,
        index: usize,
        time: f64,
        x: f64,
        point: &FieldPoint<f64>,
        p: &[f64],
    ) -> [f64; 2] {
        let mut force = [0.0; 2];
        self.at_point(&self.fields[index].force, (time, x, point), p, &mut force);
        force
    }
    fn field_force_jacobian(
        &self,
        index: usize,
        time: f64,
        x: f64,
        point: &FieldPoint<f64>,
        p: &[f64],
    ) -> [f64; 8] {
        let mut jacobian = [0.0; 8];
        self.at_point(&self.fields[index].force_jacobian, (time, x, point), p, &mut jacobian);
        jacobian
    }
    fn field_force_gradient(
        &self,
        index: usize,
        time: f64,
        x: f64,
        point: &FieldPoint<f64>,
        p: &[f64],
        gradient: &mut [f64],
    ) {
        self.at_point(&self.fields[index].force_gradient, (time, x, point), p, gradient);
    }
    fn field_energy(
        &self,
        index: usize,
        time: f64,
        x: f64,
        point: &FieldPoint<f64>,
        p: &[f64],
    ) -> [f64; 2] {
        let mut energy = [0.0; 2];
        self.at_point(&self.fields[index].energy, (time, x, point), p, &mut energy);
        energy
    }
    fn field_power(
        &self,
        index: usize,
        time: f64,
        x: f64,
        point: &FieldPoint<f64>,
        p: &[f64],
    ) -> [f64; 3] {
        let mut power = [0.0; 3];
        self.at_point(&self.fields[index].power, (time, x, point), p, &mut power);
        power
    }
    fn field_places(&self, index: usize, p: &[f64], places: &mut [f64]) {
        self.at_place(&self.fields[index].places, 0.0, p, places);
    }
    fn field_places_gradient(&self, index: usize, p: &[f64], gradient: &mut [f64]) {
        self.at_place(&self.fields[index].places_gradient, 0.0, p, gradient);
    }
    fn field_initial(&self, index: usize, x: f64, p: &[f64]) -> [f64; 2] {
        let mut initial = [0.0; 2];
        self.at_place(&self.fields[index].initial, x, p, &mut initial);
        initial
    }
}
