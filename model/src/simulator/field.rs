//! Fields of scenes run from their tapes.

use machinist_contract::field::{FieldAttachment, FieldDescription, FieldPoint, FieldScene};

use super::{ModelSimulator, Read, TapeFunction};
use crate::{FieldModel, Model, Tape};

/// The point functions of one field.
#[derive(Debug)]
pub(super) struct PointFunctions {
    attachments: Vec<FieldAttachment>,
    inertia: TapeFunction,
    inertia_gradient: TapeFunction,
    force: TapeFunction,
    force_jacobian: TapeFunction,
    force_gradient: TapeFunction,
    energy: TapeFunction,
    power: TapeFunction,
    places: TapeFunction,
    places_gradient: TapeFunction,
    initial: TapeFunction,
}

impl PointFunctions {
    pub(super) fn new(model: &Model, field: &FieldModel) -> Self {
        let own = model.parameters.len();
        Self {
            attachments: field.attachments.iter().map(|at| at.described(own)).collect(),
            inertia: TapeFunction::default(),
            inertia_gradient: TapeFunction::default(),
            force: TapeFunction::default(),
            force_jacobian: TapeFunction::default(),
            force_gradient: TapeFunction::default(),
            energy: TapeFunction::default(),
            power: TapeFunction::default(),
            places: TapeFunction::default(),
            places_gradient: TapeFunction::default(),
            initial: TapeFunction::default(),
        }
    }
}

/// A function of a field with its tape.
type OfField<'a> = (&'a TapeFunction, &'a Tape);

impl ModelSimulator {
    fn at_point(
        &self,
        (function, tape): OfField<'_>,
        (time, x, point): (f64, f64, &FieldPoint<f64>),
        p: &[f64],
        results: &mut [f64],
    ) {
        let [value, slope, rate, slope_rate] = *point;
        let state = [value, slope, rate, slope_rate, x];
        let read = Read { state: &state, ..self.read_without_state(&time, p) };
        function.run((|| tape, self.running), 1, &read, results);
    }

    fn at_place(&self, of_field: OfField<'_>, x: f64, p: &[f64], results: &mut [f64]) {
        self.at_point(of_field, (0.0, x, &[0.0; 4]), p, results);
    }
}

/// A function of a field with its tape, by its name.
macro_rules! of_field {
    ($simulator:ident, $index:ident, $name:ident) => {
        (&$simulator.fields[$index].$name, &$simulator.model.fields[$index].$name)
    };
}

impl FieldScene<f64> for ModelSimulator {
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
            parameters: &field.parameters,
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
        self.at_place(of_field!(self, index, inertia), x, p, &mut inertia);
        inertia[0]
    }
    fn field_inertia_gradient(&self, index: usize, x: f64, p: &[f64], gradient: &mut [f64]) {
        self.at_place(of_field!(self, index, inertia_gradient), x, p, gradient);
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
        self.at_point(of_field!(self, index, force), (time, x, point), p, &mut force);
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
        self.at_point(of_field!(self, index, force_jacobian), (time, x, point), p, &mut jacobian);
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
        self.at_point(of_field!(self, index, force_gradient), (time, x, point), p, gradient);
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
        self.at_point(of_field!(self, index, energy), (time, x, point), p, &mut energy);
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
        self.at_point(of_field!(self, index, power), (time, x, point), p, &mut power);
        power
    }
    fn field_places(&self, index: usize, p: &[f64], places: &mut [f64]) {
        self.at_place(of_field!(self, index, places), 0.0, p, places);
    }
    fn field_places_gradient(&self, index: usize, p: &[f64], gradient: &mut [f64]) {
        self.at_place(of_field!(self, index, places_gradient), 0.0, p, gradient);
    }
    fn field_initial(&self, index: usize, x: f64, p: &[f64]) -> [f64; 2] {
        let mut initial = [0.0; 2];
        self.at_place(of_field!(self, index, initial), x, p, &mut initial);
        initial
    }
}
