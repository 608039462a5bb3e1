//! Models of the previous version of the format, 9. It has no drawings, and says neither which
//! constraints are of dry friction that sticks nor where functions saturate.

use machinist_contract::Jumps;
use serde::Deserialize;

use crate::{
    Check, Coordinate, Event, Excitation, FieldModel, Freeze, MatrixTape, Motion, Name, Parameter,
    Quantity, Reduction, Relation, Requirement, RunDefaults, SourceFile, State, Table, Tape,
};

/// Version of the format.
pub const VERSION: u32 = 9;

/// A model with its generator.
#[derive(Deserialize)]
pub struct Stamped {
    generator: String,
    model: Model,
}

impl From<Stamped> for super::Stamped {
    fn from(Stamped { generator, model }: Stamped) -> Self {
        Self { generator, model: model.into() }
    }
}

/// A constraint without its friction.
#[derive(Deserialize)]
struct Constraint {
    name: Name,
    doc: String,
    unit: String,
    is_of_positions: bool,
    in_modes: bool,
}

impl From<Constraint> for crate::Constraint {
    fn from(Constraint { name, doc, unit, is_of_positions, in_modes }: Constraint) -> Self {
        let (friction, jumps) = (None, Jumps::default());
        Self { name, doc, unit, is_of_positions, in_modes, friction, jumps }
    }
}

/// Declares the model with its fields in the order of the file, and the conversion.
macro_rules! model {
    ($($before:ident: $type:ty,)* | $($after:ident: $other:ty,)*) => {
        #[derive(Deserialize)]
        struct Model {
            $($before: $type,)*
            constraints: Vec<Constraint>,
            $($after: $other,)*
        }

        impl From<Model> for crate::Model {
            fn from(of: Model) -> Self {
                Self {
                    $($before: of.$before,)*
                    constraints: of.constraints.into_iter().map(Into::into).collect(),
                    $($after: of.$after,)*
                    drawing: None,
                    saturating_arguments: Tape::default(),
                }
            }
        }
    };
}

model! {
    name: String,
    title: String,
    doc: String,
    source: String,
    files: Vec<SourceFile>,
    coordinates: Vec<Coordinate>,
    states: Vec<State>,
    quadratures: usize,
    parameters: Vec<Parameter>,
    handed: Vec<Parameter>,
    wanted: Vec<Quantity>,
    at_once: Vec<u32>,
    tables: Vec<Table>,
    run: RunDefaults,
    freeze: Freeze,
    reduction: Reduction,
    starts_in_equilibrium: bool,
    initial_state: Tape,
    discontinuities: Tape,
    motion: Option<Motion>,
    rate: Tape,
    rate_jacobian: MatrixTape,
    parameter_jacobian: MatrixTape,
    time_derivative: Tape,
    mass_matrix: MatrixTape,
    forcing: Tape,
    outputs: Tape,
    energy: Tape,
    power_balance: Tape,
    excitation: Option<Excitation>,
    events: Vec<Event>,
    guards: Tape,
    guard_rates: Tape,
    resets: Tape,
    |
    constraint_values: Tape,
    constraint_rates: Tape,
    constraint_matrix: MatrixTape,
    kink_guards: Tape,
    kink_rates: Tape,
    fields: Vec<FieldModel>,
    checks: Vec<Check>,
    relations: Vec<Relation>,
    requirements: Vec<Requirement>,
    required: Tape,
}
