//! Rate of a scene whose fields all have a section without f_0 and elements of order 1, without
//! memory between calls: forces are accumulated in the accelerations, directly from the given
//! state.

use std::ops::Range;

use machinist_contract::Real;
use machinist_contract::field::Variation;

use super::constants::Constants;
use super::mesh::{Mesh, Owner};
use super::{FieldSimulator, Law};

/// Maximum number of parameters of the machine; others use the kept memory.
const PARAMETERS: usize = 64;
/// Maximum number of states of the machine.
const STATES: usize = 32;

/// Indices of the nodes of a field in positions and velocities.
#[derive(Debug)]
pub(super) struct Line {
    /// Nodes between two bounds, for each segment.
    inner: Vec<Inner>,
    /// Nodes at the bounds.
    bounds: Vec<Bound>,
    /// True where f_1 depends on u_x and on u_xt; next, the last of these on which it does.
    by_slopes: [bool; 2],
    last_kind: usize,
}

/// Neighbouring own nodes of a field within a segment.
#[derive(Debug)]
struct Inner {
    /// Indices among all nodes.
    nodes: Range<usize>,
    /// Index of the first one among positions.
    place: usize,
}

/// A node between segments or at an end.
#[derive(Debug)]
struct Bound {
    /// Index among all nodes.
    node: usize,
    /// Index among positions; `None` if the node is held.
    place: Option<usize>,
    /// Index of the first parameter that the field provides, if the node is a port.
    handed: Option<usize>,
}

/// Returns the lines of all fields of a machine, if its rates can be computed in this way.
pub(super) fn lines<R: Real>(simulator: &FieldSimulator<'_, R>) -> Option<Vec<Line>> {
    let machine = simulator.machine;
    let is_large = machine.parameters > PARAMETERS || machine.states() > STATES;
    if is_large || simulator.scene().relations() > 0 {
        return None;
    }
    let laws = simulator.laws.iter().zip(&simulator.meshes).enumerate();
    laws.map(|(index, (law, mesh))| match law {
        Law::Section(_) if mesh.order == 1 => simulator.line(index, mesh),
        _ => None,
    })
    .collect()
}

impl<R: Real> FieldSimulator<'_, R> {
    /// Returns `None` for a field without springs or with forces at nodes: the latter are calls for
    /// neighbouring nodes, which are better evaluated together.
    fn line(&self, index: usize, mesh: &Mesh) -> Option<Line> {
        let place = |node: usize| {
            let [position, _] = self.columns(mesh.owners[node])?;
            Some(position as usize)
        };
        let firsts = mesh.segments.iter().map(|segment| segment.first_node as usize);
        let bounds: Vec<usize> = firsts.chain([mesh.owners.len() - 1]).collect();
        let inner = bounds.windows(2).map(|ends| {
            let nodes = mesh.first_node + ends[0] + 1..mesh.first_node + ends[1];
            // The place is not used if there are no nodes.
            let place = if nodes.is_empty() { 0 } else { place(ends[0] + 1)? };
            Some(Inner { nodes, place })
        });
        let inner = inner.collect::<Option<_>>()?;
        let bound = |node: &usize| Bound {
            node: mesh.first_node + node,
            place: place(*node),
            handed: match mesh.owners[*node] {
                Owner::Port { handed, .. } => Some(handed as usize),
                _ => None,
            },
        };
        let structure = self.scene().force_structure(index);
        if structure.forces[0] != Variation::Zero {
            return None;
        }
        let [.., by_u_x, _, by_u_xt] = structure.derivatives;
        let by_slopes = [by_u_x, by_u_xt].map(|by| by != Variation::Zero);
        Some(Line {
            inner,
            bounds: bounds.iter().map(bound).collect(),
            by_slopes,
            last_kind: by_slopes.iter().rposition(|is_there| *is_there)?,
        })
    }

    /// Computes y'.
    pub(super) fn direct_rate(
        &self,
        lines: &[Line],
        (time, state): (R, &[R]),
        parameters: &[R],
        constants: &Constants<'_, R>,
        rate: &mut [R],
    ) {
        assert_eq!(state.len(), self.border_and_own(), "length of the state");
        assert_eq!(rate.len(), state.len(), "length of the rate");
        assert_eq!(parameters.len(), self.parameters, "number of parameters");
        let zero = R::literal(0.0);
        let mut p = [zero; PARAMETERS];
        let p = &mut p[..self.machine.parameters];
        p[..self.parameters].copy_from_slice(parameters);
        for (node, handed) in &self.ports {
            p[*handed] = constants.inertia[*node];
        }
        let n = self.coordinates();
        let (u, v) = (&state[..n], &state[n..2 * n]);
        rate[..n].copy_from_slice(v);
        for (index, line) in lines.iter().enumerate() {
            self.accelerate((index, line), [u, v], constants, p, &mut rate[n..2 * n]);
        }
        let [mut from, mut into] = [[zero; STATES]; 2];
        let (from, into) = (&mut from[..self.border.len()], &mut into[..self.border.len()]);
        for (value, place) in from.iter_mut().zip(&self.border) {
            *value = state[*place as usize];
        }
        self.scene().prepared_rate(time, from, p, constants.machine, into);
        for (value, place) in into.iter().zip(&self.border) {
            rate[*place as usize] = *value;
        }
    }

    /// Computes the accelerations of a field's own nodes, and stores forces on its ports among the
    /// parameters.
    fn accelerate(
        &self,
        (index, line): (usize, &Line),
        motion: [&[R]; 2],
        constants: &Constants<'_, R>,
        p: &mut [R],
        rate: &mut [R],
    ) {
        let pulls = constants.pulls(&self.meshes[index]);
        let mut begins = true;
        for (kind, values) in line.kinds(motion) {
            let ends = kind == line.last_kind;
            for ((inner, bounds), pulls) in line.inner.iter().zip(line.bounds.windows(2)).zip(pulls)
            {
                let places = inner.place..inner.place + inner.nodes.len();
                let beside = (bounds[0].of(values), &values[places.clone()], bounds[1].of(values));
                let into = (&constants.inverse[inner.nodes.clone()], &mut rate[places]);
                let by = pulls[kind];
                match (begins, ends) {
                    (false, false) => pull::<R, false, false>(by, beside, into),
                    (false, true) => pull::<R, false, true>(by, beside, into),
                    (true, false) => pull::<R, true, false>(by, beside, into),
                    (true, true) => pull::<R, true, true>(by, beside, into),
                }
            }
            begins = false;
        }
        let [c, ..] = constants.section(index);
        for (number, bound) in line.bounds.iter().enumerate() {
            let Some(place) = bound.place else { continue };
            let mut force = R::literal(0.0);
            for (kind, values) in line.kinds(motion) {
                let at = values[place];
                if let Some(before) = number.checked_sub(1) {
                    let value = line.beside(before, values).1;
                    force = force + pulls[before][kind] * (at - value);
                }
                if let Some(pulls) = pulls.get(number) {
                    let value = line.beside(number, values).0;
                    force = force - pulls[kind] * (value - at);
                }
            }
            if number == 0 {
                force = force - c;
            }
            if number + 1 == line.bounds.len() {
                force = force + c;
            }
            match bound.handed {
                Some(handed) => p[handed + 1] = force,
                None => rate[place] = force * constants.inverse[bound.node],
            }
        }
    }
}

impl Line {
    /// Returns positions, velocities or both: those on whose slopes f_1 depends.
    fn kinds<'m, R>(&self, motion: [&'m [R]; 2]) -> impl Iterator<Item = (usize, &'m [R])> {
        let by_slopes = self.by_slopes;
        motion.into_iter().enumerate().filter(move |(kind, _)| by_slopes[*kind])
    }

    /// Returns the values of the second node and the last but one of a segment.
    fn beside<R: Real>(&self, segment: usize, values: &[R]) -> (R, R) {
        let inner = &self.inner[segment];
        match &values[inner.place..inner.place + inner.nodes.len()] {
            [] => (self.bounds[segment + 1].of(values), self.bounds[segment].of(values)),
            [first, .., last] => (*first, *last),
            [single] => (*single, *single),
        }
    }
}

impl Bound {
    /// Returns the value, or zero if the node is held.
    fn of<R: Real>(&self, values: &[R]) -> R {
        self.place.map_or(R::literal(0.0), |place| values[place])
    }
}

/// Adds the forces of equal springs to nodes between two others. `BEGINS` starts from zero, `ENDS`
/// divides by inertias.
fn pull<R: Real, const BEGINS: bool, const ENDS: bool>(
    by: R,
    (first, values, last): (R, &[R], R),
    (inverses, into): (&[R], &mut [R]),
) {
    let pulled = |force: R, [before, at, after]: [R; 3], inverse: R| {
        let force = if BEGINS { R::literal(0.0) } else { force };
        let force = force + by * ((at - before) - (after - at));
        if ENDS { force * inverse } else { force }
    };
    let count = values.len();
    match values {
        [] => {}
        [at] => into[0] = pulled(into[0], [first, *at, last], inverses[0]),
        [start, .., end] => {
            into[0] = pulled(into[0], [first, *start, values[1]], inverses[0]);
            let beside = values.iter().zip(&values[1..count - 1]).zip(&values[2..]);
            let inner = into[1..count - 1].iter_mut().zip(&inverses[1..count - 1]);
            for ((into, inverse), ((before, at), after)) in inner.zip(beside) {
                *into = pulled(*into, [*before, *at, *after], *inverse);
            }
            let (before, inverse) = (values[count - 2], inverses[count - 1]);
            into[count - 1] = pulled(into[count - 1], [before, *end, last], inverse);
        }
    }
}
