//! Lowering of the generic element of a field.

use machinist_algebra::expr::{CoordinateId, Expr, FirstOrderId, Graph, Symbol};
use machinist_model::{Attachment, FieldModel, LocalForces, NodeId, Op, Tape};

use crate::lower::excitation::is_homogeneous;
use crate::mechanics::density::FieldEquations;
use crate::mechanics::linearize::{Linearization, Partials};
use crate::scene::system::Field;

/// Lowers the generic element to one tape for each point function of a field.
#[must_use]
pub fn lower(field: &Field, equations: &FieldEquations) -> FieldModel {
    let linearization = &equations.density;
    let motion = &linearization.equations;
    let mut build = Build { graph: Graph::for_scene(motion.layout.symbols()) };
    let place = linearization.state.iter().find(|partials| partials.symbol == PLACE);
    let of_parameters =
        equations.parameters.iter().filter_map(|id| linearization.parameters.get(id.0 as usize));
    let of_parameters: Vec<&Partials> = of_parameters.collect();

    let inertia = motion.mass_matrix.entry(0, 0).map(|entry| build.graph.lower(entry));
    let inertia = vec![inertia.unwrap_or_else(|| build.graph.literal(0.0))];
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
    // The derivative by time follows that by x.
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
    FieldModel {
        is_linear: is_homogeneous(&force, X),
        local: is_local.then_some(local),
        quantities: field.quantities.clone(),
        scale: field.scale,
        length: field.length_value,
        fixed: field.fixed,
        elements: field.elements,
        order: field.order,
        attachments: field.attachments.iter().map(attachment).collect(),
        parameters: equations.parameters.iter().map(|id| id.0).collect(),
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

fn attachment(at: &crate::scene::system::Attachment) -> Attachment {
    Attachment {
        name: at.name.clone(),
        coordinate: at.coordinate.map(|id| id.0),
        place: at.place,
        x: at.x,
        handed: at.handed.0,
    }
}

/// Entries of the state of a field's tapes.
const U: u32 = 0;
const U_X: u32 = 1;
const U_T: u32 = 2;
const U_XT: u32 = 3;
const X: u32 = 4;

/// Reports whether a tape reads only these entries of the state, and time only if `time`.
fn reads_only(tape: &Tape, entries: &[u32], time: bool) -> bool {
    tape.nodes.iter().all(|node| match node.op {
        Op::State(entry) => entries.contains(&entry),
        Op::Time => time,
        _ => true,
    })
}

/// Symbol of x in a density.
const PLACE: Symbol = Symbol::FirstOrder(FirstOrderId(0));

struct Build {
    graph: Graph,
}

impl Build {
    fn nodes<'a>(&mut self, exprs: impl IntoIterator<Item = &'a Expr>) -> Vec<NodeId> {
        exprs.into_iter().map(|expr| self.graph.lower(expr)).collect()
    }

    /// Returns the rate of the potential: dV/du u_t + dV/du_x u_xt, and its change in time.
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

    /// Returns dm/ds.
    fn inertia(&mut self, partials: &Partials) -> NodeId {
        let entry = partials.mass_matrix.iter().find(|(row, column, _)| (*row, *column) == (0, 0));
        match entry {
            Some((_, _, expr)) => self.graph.lower(expr),
            None => self.graph.literal(0.0),
        }
    }

    /// Returns df/ds.
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
