//! Generic element of a field: point functions from its densities.
//!
//! At a point of a field u(x, t) the densities are those of a small Lagrangian system with the
//! coordinates u and u_x. Its equations provide all functions of elements:
//!
//! ```text
//! m   = d2T/du_t2
//! f_0 = dL/du   - dD/du_t  + Q      what acts on u
//! f_1 = dL/du_x - dD/du_xt          what acts on u_x, minus the torque in a section
//! ```
//!
//! with their derivatives. An element integrates them over its length with its shape functions.
//! That loop of the contract is independent of the scene and of the number of elements, so the
//! derived and emitted functions are the same for any number.
//!
//! Excluded: shape functions, quadrature, numbers of elements.

use std::collections::BTreeSet;

use machinist_algebra::cas::Cas;
use machinist_algebra::expr::{Expr, ParameterId, Symbol};
use machinist_model::Quantity;

use crate::mechanics::lagrange::{self, EquationsOfMotion};
use crate::mechanics::linearize::{Linearization, linearize};
use crate::scene::system::{
    Coordinate, Field, FirstOrderState, GeneralizedForce, LagrangianSystem,
};
use crate::spatial::orientation::Orientations;

/// A field with the derivatives of its densities.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldEquations {
    /// Densities as a system with the coordinates u and u_x and the state x.
    pub density: Linearization,
    /// Parameters that the densities or the places on the field depend on.
    pub parameters: Vec<ParameterId>,
    /// Places of the attachments, then the length; each with its derivatives by `parameters`.
    pub places: Vec<(Expr, Vec<Expr>)>,
}

/// Derives the generic element of every field of a system.
pub fn derive(cas: &mut Cas, system: &LagrangianSystem) -> Vec<FieldEquations> {
    system.fields.iter().map(|field| field_equations(cas, system, field)).collect()
}

fn field_equations(cas: &mut Cas, system: &LagrangianSystem, field: &Field) -> FieldEquations {
    let places = field.attachments.iter().map(|at| &at.at).chain([&field.length]);
    let densities = [&field.kinetic, &field.potential, &field.dissipation, &field.force];
    let symbols = densities.into_iter().chain(places.clone()).flat_map(Expr::symbols);
    let parameters: BTreeSet<ParameterId> = symbols
        .filter_map(|symbol| match symbol {
            Symbol::Parameter(id) => Some(id),
            _ => None,
        })
        .collect();
    let parameters: Vec<ParameterId> = parameters.into_iter().collect();
    let places = places.map(|place| {
        let form = cas.form(place);
        let slopes = parameters.iter().map(|id| {
            let slope = cas.derivative(&form, Symbol::Parameter(*id));
            cas.simplify(&slope)
        });
        let slopes = slopes.collect();
        (cas.expr(&form), slopes)
    });
    let places = places.collect();
    let equations: EquationsOfMotion = lagrange::derive(cas, &density(system, field));
    FieldEquations { density: linearize(cas, &equations), parameters, places }
}

/// Returns the system at one point of a field.
fn density(system: &LagrangianSystem, field: &Field) -> LagrangianSystem {
    let [value, slope, rate, slope_rate, place] = &field.quantities;
    let coordinate = |position: &Quantity, velocity: &Quantity| Coordinate {
        position: position.clone(),
        velocity: velocity.clone(),
        identified: Vec::new(),
        initial: [Expr::integer(0), Expr::integer(0)],
        is_given: [true; 2],
        scale: field.scale,
    };
    let force = |total: Expr| GeneralizedForce { total, conversion: Expr::integer(0) };
    LagrangianSystem {
        coordinates: vec![coordinate(value, rate), coordinate(slope, slope_rate)],
        first_order: vec![FirstOrderState {
            quantity: place.clone(),
            rate: Expr::integer(0),
            initial: Expr::integer(0),
            is_mode: false,
            scale: 1.0,
        }],
        kinetic: field.kinetic.clone(),
        potential: field.potential.clone(),
        dissipation: field.dissipation.clone(),
        generalized_force: vec![force(field.force.clone()), force(Expr::integer(0))],
        mechanisms: Vec::new(),
        drawing: Vec::new(),
        orientations: Orientations::default(),
        scalars: Vec::new(),
        springs: Vec::new(),
        stored_energy: Expr::integer(0),
        supplied_power: Expr::integer(0),
        dissipated_power: Expr::integer(0),
        helpers: Vec::new(),
        outputs: Vec::new(),
        checks: Vec::new(),
        discontinuities: Vec::new(),
        fields: Vec::new(),
        handed: Vec::new(),
        ..system.clone()
    }
}
