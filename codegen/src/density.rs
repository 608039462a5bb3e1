//! One generic element of a field: its densities to point functions.
//!
//! At a point of a field u(x, t) the densities are those of a small Lagrangian system
//! with the coordinates u and u_x. Its equations give all that elements are made of:
//!
//! ```text
//! m   = d2T/du_t2
//! f_0 = dL/du   - dD/du_t  + Q      what acts on u
//! f_1 = dL/du_x - dD/du_xt          what acts on u_x, minus the torque in a section
//! ```
//!
//! with their derivatives. An element integrates them over its length with its shape
//! functions, a loop of the contract that knows neither the scene nor the number of
//! elements; so what is derived and emitted is the same for any number.
//!
//! Excluded: shape functions, quadrature, numbers of elements.

use std::collections::BTreeSet;

use crate::cas::Cas;
use crate::expr::{CoordinateId, Expr, FirstOrderId, ParameterId, Symbol};
use crate::lagrange::{self, EquationsOfMotion};
use crate::linear::is_homogeneous;
use crate::linearize::{Linearization, Partials, linearize};
use crate::lower::Graph;
use crate::program::{FieldProgram, LocalForces};
use crate::system::{
    Coordinate, Field, FirstOrderState, GeneralizedForce, LagrangianSystem, Quantity,
};
use crate::tape::{NodeId, Op, Tape};

/// A field with the derivatives of its densities.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldEquations {
    /// Densities as a system with the coordinates u and u_x and the state x.
    pub density: Linearization,
    /// Parameters that the densities or the places on the field depend on.
    pub parameters: Vec<ParameterId>,
    /// Places of the attachments, then the length; each with its derivatives with
    /// respect to `parameters`.
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

/// The system at one point of a field.
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
        springs: Vec::new(),
        stored_energy: Expr::integer(0),
        supplied_power: Expr::integer(0),
        dissipated_power: Expr::integer(0),
        helpers: Vec::new(),
        outputs: Vec::new(),
        discontinuities: Vec::new(),
        fields: Vec::new(),
        ..system.clone()
    }
}

/// One tape for each point function of a field.
#[must_use]
pub fn lower(field: &Field, equations: &FieldEquations) -> FieldProgram {
    let linearization = &equations.density;
    let motion = &linearization.equations;
    let mut build = Build { graph: Graph::for_scene(motion.layout.symbols()) };
    let place = linearization.state.iter().find(|partials| partials.symbol == PLACE);
    let of_parameters =
        equations.parameters.iter().filter_map(|id| linearization.parameters.get(id.0 as usize));
    let of_parameters: Vec<&Partials> = of_parameters.collect();

    let inertia = build.nodes([&motion.mass_matrix[0][0]]);
    let inertia_gradient: Vec<NodeId> =
        place.into_iter().chain(of_parameters.iter().copied()).map(|p| build.inertia(p)).collect();
    let force = build.nodes(&motion.forcing);
    let columns: Vec<[NodeId; 2]> =
        linearization.state.iter().take(4).map(|partials| build.force(partials)).collect();
    let force_jacobian = [0, 1].iter().flat_map(|row| columns.iter().map(move |c| c[*row]));
    let force_jacobian: Vec<NodeId> = force_jacobian.collect();
    let others = place.into_iter().chain([&linearization.time]).chain(of_parameters);
    let force_gradient: Vec<NodeId> = others.flat_map(|partials| build.force(partials)).collect();
    let energy = build.nodes(&motion.energy[..2]);
    let stored = build.stored(linearization);
    let rest = build.nodes([&motion.supplied, &motion.dissipated]);
    let power: Vec<NodeId> = std::iter::once(stored).chain(rest).collect();
    let places = build.nodes(equations.places.iter().map(|(place, _)| place));
    let slopes = build.nodes(equations.places.iter().flat_map(|(_, slopes)| slopes));
    let initial = build.nodes(&field.initial);
    let tape = |nodes: &[NodeId]| -> Tape { build.graph.tape(nodes) };
    // The derivative by time stands behind that by x.
    let by_time = force_gradient[if place.is_some() { 2 } else { 0 }];
    let [u, u_x, u_t, u_xt] = [U, U_X, U_T, U_XT].map(|entry| entry as usize);
    let local = LocalForces {
        on_value: tape(&force[..1]),
        on_value_jacobian: tape(&[force_jacobian[u], force_jacobian[u_t]]),
        on_value_by_time: tape(&[by_time]),
        on_slope: tape(&force[1..]),
        on_slope_jacobian: tape(&[force_jacobian[4 + u_x], force_jacobian[4 + u_xt]]),
    };
    let is_local = reads_only(&local.on_value, &[U, U_T, X], true)
        && reads_only(&local.on_slope, &[U_X, U_XT], false);
    let force = tape(&force);
    FieldProgram {
        is_linear: is_homogeneous(&force, X),
        local: is_local.then_some(local),
        field: field.clone(),
        layout: motion.layout.clone(),
        parameters: equations.parameters.clone(),
        inertia: tape(&inertia),
        inertia_gradient: tape(&inertia_gradient),
        force,
        force_jacobian: tape(&force_jacobian),
        force_gradient: tape(&force_gradient),
        energy: tape(&energy),
        power: tape(&power),
        places: tape(&places),
        places_gradient: tape(&slopes),
        initial: tape(&initial),
    }
}

/// Entries of the state of a field's tapes.
const U: u32 = 0;
const U_X: u32 = 1;
const U_T: u32 = 2;
const U_XT: u32 = 3;
const X: u32 = 4;

/// Whether a tape reads nothing of the state but these entries, and no time unless told.
fn reads_only(tape: &Tape, entries: &[u32], time: bool) -> bool {
    tape.nodes.iter().all(|node| match node.op {
        Op::State(entry) => entries.contains(&entry),
        Op::Time => time,
        _ => true,
    })
}

/// x among the symbols of a density.
const PLACE: Symbol = Symbol::FirstOrder(FirstOrderId(0));

struct Build {
    graph: Graph,
}

impl Build {
    fn nodes<'a>(&mut self, exprs: impl IntoIterator<Item = &'a Expr>) -> Vec<NodeId> {
        exprs.into_iter().map(|expr| self.graph.lower(expr)).collect()
    }

    /// Rate of the potential: dV/du u_t + dV/du_x u_xt, and its change in time.
    fn stored(&mut self, linearization: &Linearization) -> NodeId {
        let mut total = self.graph.lower(&linearization.time.energy);
        for (value, rate) in [(0, 0), (1, 1)].map(|(q, v)| (CoordinateId(q), CoordinateId(v))) {
            let slope = linearization.state.iter().find(|p| p.symbol == Symbol::Coordinate(value));
            let Some(slope) = slope else { continue };
            let slope = self.graph.lower(&slope.energy);
            let rate = self.graph.lower(&Expr::Symbol(Symbol::Velocity(rate)));
            let part = self.graph.mul(slope, rate);
            total = self.graph.add(total, part);
        }
        total
    }

    /// dm/ds.
    fn inertia(&mut self, partials: &Partials) -> NodeId {
        let entry = partials.mass_matrix.iter().find(|(row, column, _)| (*row, *column) == (0, 0));
        match entry {
            Some((_, _, expr)) => self.graph.lower(expr),
            None => self.graph.literal(0.0),
        }
    }

    /// df/ds.
    fn force(&mut self, partials: &Partials) -> [NodeId; 2] {
        [0, 1].map(|wanted| {
            let entry = partials.forcing.iter().find(|(row, _)| *row == wanted);
            match entry {
                Some((_, expr)) => self.graph.lower(expr),
                None => self.graph.literal(0.0),
            }
        })
    }
}
