//! Fields of scenes, computed by their tapes.

use machinist_contract::field::{
    FieldAttachment, FieldDescription, FieldPoint, FieldScene, ForceStructure,
};
use machinist_contract::{Dual, Real};

use super::{ModelSimulator, Read, TapeFunction};
use crate::{FieldModel, Model, Tape};

/// The point functions of one field.
#[derive(Debug)]
pub(super) struct PointFunctions {
    attachments: Vec<FieldAttachment>,
    structure: ForceStructure,
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
            structure: field.structure(),
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

/// Number types on which functions of a point run.
pub(super) trait AtPoint: Real {
    /// Writes the results of a function, whose state is \[u, u_x, u_t, u_xt, x\].
    fn run(
        simulator: &ModelSimulator,
        of_field: OfField<'_>,
        motion: (Self, &[Self]),
        p: &[Self],
        results: &mut [Self],
    );
}

impl AtPoint for f64 {
    fn run(
        simulator: &ModelSimulator,
        (function, tape): OfField<'_>,
        (time, state): (f64, &[f64]),
        p: &[f64],
        results: &mut [f64],
    ) {
        if !function.run_again(1, [time; 2], [state, p, &[]], results) {
            let read = Read { state, ..simulator.read_without_state(&time, p) };
            function.run_and_keep((|| tape, simulator.running), 1, &read, results);
        }
    }
}

impl AtPoint for Dual {
    fn run(
        simulator: &ModelSimulator,
        (function, tape): OfField<'_>,
        motion: (Dual, &[Dual]),
        p: &[Dual],
        results: &mut [Dual],
    ) {
        function.run_on(tape, &simulator.inputs_of(motion, p), results);
    }
}

impl ModelSimulator {
    fn at_point<R: AtPoint>(
        &self,
        of_field: OfField<'_>,
        (time, x, point): (R, R, &FieldPoint<R>),
        p: &[R],
        results: &mut [R],
    ) {
        let [value, slope, rate, slope_rate] = *point;
        let state = [value, slope, rate, slope_rate, x];
        R::run(self, of_field, (time, &state), p, results);
    }

    fn at_place<R: AtPoint>(&self, of_field: OfField<'_>, x: R, p: &[R], results: &mut [R]) {
        let zero = R::literal(0.0);
        self.at_point(of_field, (zero, x, &[zero; 4]), p, results);
    }
}

/// Returns a function of a field with its tape, by name.
macro_rules! of_field {
    ($simulator:ident, $index:ident, $name:ident) => {
        (&$simulator.fields[$index].$name, &$simulator.model.fields[$index].$name)
    };
}

/// Implements the contract on a type of numbers. As for the scene itself, it is not generic, so that it is compiled here.
macro_rules! on_numbers {
    ($R:ident) => {
        impl FieldScene<$R> for ModelSimulator {
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
            fn force_structure(&self, index: usize) -> ForceStructure {
                self.fields[index].structure
            }
            fn field_inertia(&self, index: usize, x: $R, p: &[$R]) -> $R {
                let mut inertia = [$R::literal(0.0)];
                self.at_place(of_field!(self, index, inertia), x, p, &mut inertia);
                inertia[0]
            }
            fn field_inertia_gradient(&self, index: usize, x: $R, p: &[$R], gradient: &mut [$R]) {
                self.at_place(of_field!(self, index, inertia_gradient), x, p, gradient);
            }
            fn field_force(
                &self,
                index: usize,
                time: $R,
                x: $R,
                point: &FieldPoint<$R>,
                p: &[$R],
            ) -> [$R; 2] {
                let mut force = [$R::literal(0.0); 2];
                self.at_point(of_field!(self, index, force), (time, x, point), p, &mut force);
                force
            }
            fn field_force_jacobian(
                &self,
                index: usize,
                time: $R,
                x: $R,
                point: &FieldPoint<$R>,
                p: &[$R],
            ) -> [$R; 8] {
                let mut jacobian = [$R::literal(0.0); 8];
                self.at_point(
                    of_field!(self, index, force_jacobian),
                    (time, x, point),
                    p,
                    &mut jacobian,
                );
                jacobian
            }
            fn field_force_gradient(
                &self,
                index: usize,
                time: $R,
                x: $R,
                point: &FieldPoint<$R>,
                p: &[$R],
                gradient: &mut [$R],
            ) {
                self.at_point(
                    of_field!(self, index, force_gradient),
                    (time, x, point),
                    p,
                    gradient,
                );
            }
            fn field_energy(
                &self,
                index: usize,
                time: $R,
                x: $R,
                point: &FieldPoint<$R>,
                p: &[$R],
            ) -> [$R; 2] {
                let mut energy = [$R::literal(0.0); 2];
                self.at_point(of_field!(self, index, energy), (time, x, point), p, &mut energy);
                energy
            }
            fn field_power(
                &self,
                index: usize,
                time: $R,
                x: $R,
                point: &FieldPoint<$R>,
                p: &[$R],
            ) -> [$R; 3] {
                let mut power = [$R::literal(0.0); 3];
                self.at_point(of_field!(self, index, power), (time, x, point), p, &mut power);
                power
            }
            fn field_places(&self, index: usize, p: &[$R], places: &mut [$R]) {
                self.at_place(of_field!(self, index, places), $R::literal(0.0), p, places);
            }
            fn field_places_gradient(&self, index: usize, p: &[$R], gradient: &mut [$R]) {
                self.at_place(
                    of_field!(self, index, places_gradient),
                    $R::literal(0.0),
                    p,
                    gradient,
                );
            }
            fn field_initial(&self, index: usize, x: $R, p: &[$R]) -> [$R; 2] {
                let mut initial = [$R::literal(0.0); 2];
                self.at_place(of_field!(self, index, initial), x, p, &mut initial);
                initial
            }
        }
    };
}

on_numbers! { f64 }
on_numbers! { Dual }
