//! Fields of elements of order 1 whose forces are local: chains of inertias at nodes and
//! springs between them.
//!
//! ```text
//! F_i = H_i f_0(u_i, u_i') + f_1(e - 1) - f_1(e)      e - 1 and e the elements beside i
//! ```
//!
//! with H_i half the lengths of these elements, and f_1 once an element, for its slope is
//! the same at both ends.

use std::ops::Range;

use machinist_contract::Real;
use machinist_contract::field::{FieldScene, ForceStructure, Variation};

use super::constants::Constants;
use super::mesh::{Mesh, Owner};
use super::{NOWHERE, Work};

/// What is known of a chain once its elements are.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    field: usize,
    structure: ForceStructure,
    /// Entries of a row of the Jacobian, as in [`Row`], that are not zero anyway.
    slots: Vec<usize>,
    /// Where the row of every node is among the entries of the Jacobian.
    rows: Vec<Row>,
}

/// Places of the derivatives of a node's acceleration by u of the node before, of itself
/// and of the one after it, then by u'.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Row {
    /// Those of the chain's slots one after another.
    Together(u32),
    /// [`NOWHERE`] if there is no such entry.
    Apart([u32; 6]),
    /// It is no own node.
    None,
}

/// Numbers of a [`Section`].
pub(super) const SECTION: usize = 3;

/// f_1 where it is c + a u_x + b u_xt with numbers that parameters decide: c, a, b.
type Section<R> = [R; SECTION];

/// Columns beside a node, as in a [`Row`].
pub(super) fn columns_beside(
    mesh: &Mesh,
    node: usize,
    columns: impl Fn(Owner) -> Option<[u32; 2]>,
) -> [u32; 6] {
    let owners = [node.checked_sub(1), Some(node), Some(node + 1)];
    let owners = owners.map(|node| node.and_then(|node| mesh.owners.get(node)).copied());
    let beside = owners.map(|owner| owner.and_then(&columns).unwrap_or([NOWHERE; 2]));
    let [before, at, after] = beside;
    [before[0], at[0], after[0], before[1], at[1], after[1]]
}

impl Chain {
    /// That of a mesh of order 1; `find` gives the place of an entry in the Jacobian,
    /// `row` the row of an own node.
    pub(super) fn new<R: Real>(
        (scene, field): (&dyn FieldScene<R>, usize),
        mesh: &Mesh,
        columns: impl Fn(Owner) -> Option<[u32; 2]>,
        find: impl Fn(u32, u32) -> u32,
    ) -> Self {
        let structure = scene.force_structure(field);
        let [others, itself] = [structure.reaches(false), structure.reaches(true)];
        let is_there = [0, 1].map(|by| [others[by], itself[by], others[by]]).concat();
        let slots: Vec<usize> = (0..6).filter(|slot| is_there[*slot]).collect();
        let row = |node: usize| {
            let (Owner::Field(_), Some([_, row])) = (mesh.owners[node], columns(mesh.owners[node]))
            else {
                return Row::None;
            };
            let beside = columns_beside(mesh, node, &columns);
            let places =
                beside.map(|column| if column == NOWHERE { NOWHERE } else { find(row, column) });
            let first = slots.first().map_or(NOWHERE, |slot| places[*slot]);
            let follow = |(k, slot): (usize, &usize)| places[*slot] == first + k as u32;
            if first != NOWHERE && slots.iter().enumerate().all(follow) {
                Row::Together(first)
            } else {
                Row::Apart(places)
            }
        };
        let rows = (0..mesh.owners.len()).map(row).collect();
        Self { field, structure, slots, rows }
    }

    /// Whether it has a [`Section`].
    fn has_section(&self) -> bool {
        let [.., by_u_x, _, by_u_xt] = self.structure.derivatives;
        [by_u_x, by_u_xt].iter().all(|by| *by != Variation::Varying)
    }

    /// Its section at these parameters; zeros if it has none.
    pub(super) fn section<R: Real>(&self, scene: &dyn FieldScene<R>, p: &[R]) -> Section<R> {
        let zero = R::literal(0.0);
        let [mut c, mut a, mut b] = [[zero]; SECTION];
        if self.has_section() {
            let at_rest: [&[R]; 2] = [&[zero], &[zero]];
            scene.field_forces_on_slopes(self.field, at_rest, p, &mut c);
            scene.field_forces_on_slopes_jacobian(self.field, at_rest, p, [&mut a, &mut b]);
        }
        [c[0], a[0], b[0]]
    }

    /// Elements of equal lengths, and the inverse of that length.
    fn stretches<'c, R: Real>(
        &self,
        mesh: &'c Mesh,
        constants: &Constants<'c, R>,
    ) -> impl Iterator<Item = (Range<usize>, R)> + use<'c, R> {
        let bounds = constants.bounds(mesh.bounds(self.field));
        mesh.segments.iter().zip(bounds.windows(2)).map(|(segment, ends)| {
            let inverse = R::literal(f64::from(segment.elements)) / (ends[1] - ends[0]);
            let first = segment.first_node as usize;
            (first..first + segment.elements as usize, inverse)
        })
    }

    /// Slopes of every element.
    fn slopes<R: Real>(&self, (mesh, constants): (&Mesh, &Constants<'_, R>), work: &mut Work<R>) {
        for (elements, inverse) in self.stretches(mesh, constants) {
            let first = elements.start;
            for (values, slopes) in [(&work.u, &mut work.u_x), (&work.v, &mut work.v_x)] {
                let values = &values[mesh.first_node..][first..=elements.end];
                for (slope, ends) in slopes[elements.clone()].iter_mut().zip(values.windows(2)) {
                    *slope = (ends[1] - ends[0]) * inverse;
                }
            }
        }
    }

    /// F of every node.
    pub(super) fn force<R: Real>(
        &self,
        scene: &dyn FieldScene<R>,
        time: R,
        (mesh, constants): (&Mesh, &Constants<'_, R>),
        work: &mut Work<R>,
    ) {
        let nodes = mesh.nodes();
        let force = &mut work.force[nodes.clone()];
        if self.structure.forces[0] == Variation::Zero {
            force.fill(R::literal(0.0));
        } else {
            let motion = [&work.u[nodes.clone()], &work.v[nodes.clone()]];
            let values = [&constants.x[nodes.clone()], motion[0], motion[1]];
            scene.field_forces_on_values(self.field, time, values, &work.p, force);
            for (force, length) in force.iter_mut().zip(&constants.lengths[nodes]) {
                *force = *force * *length;
            }
        }
        if self.has_section() {
            self.pull_by_section((mesh, constants), work);
        } else {
            self.pull(scene, (mesh, constants), work);
        }
    }

    /// Adds f_1 of the elements beside every node.
    fn pull<R: Real>(
        &self,
        scene: &dyn FieldScene<R>,
        (mesh, constants): (&Mesh, &Constants<'_, R>),
        work: &mut Work<R>,
    ) {
        self.slopes((mesh, constants), work);
        let elements = mesh.owners.len() - 1;
        let slopes = [&work.u_x[..elements], &work.v_x[..elements]];
        let on_slopes = &mut work.on_slopes[..elements];
        scene.field_forces_on_slopes(self.field, slopes, &work.p, on_slopes);
        let force = &mut work.force[mesh.nodes()];
        let mut before = R::literal(0.0);
        for (force, after) in force.iter_mut().zip(&*on_slopes) {
            *force = *force + (before - *after);
            before = *after;
        }
        if let Some(force) = force.last_mut() {
            *force = *force + before;
        }
    }

    /// As [`Chain::pull`], of a chain with a section, whose c acts on the ends alone.
    fn pull_by_section<R: Real>(
        &self,
        (mesh, constants): (&Mesh, &Constants<'_, R>),
        work: &mut Work<R>,
    ) {
        let Work { u, v, force, .. } = work;
        let (nodes, [c, a, b]) = (mesh.nodes(), constants.section(self.field));
        let [.., by_u_x, _, by_u_xt] = self.structure.derivatives;
        for (is, by, values) in [(by_u_x, a, u), (by_u_xt, b, v)] {
            if is == Variation::Zero {
                continue;
            }
            for (elements, inverse) in self.stretches(mesh, constants) {
                let of_stretch = nodes.start + elements.start..=nodes.start + elements.end;
                pull_evenly(by * inverse, &values[of_stretch.clone()], &mut force[of_stretch]);
            }
        }
        if let [first, .., last] = &mut force[nodes] {
            *first = *first - c;
            *last = *last + c;
        }
    }

    /// Partial derivative of F with respect to time, into `work.force_change`.
    pub(super) fn force_by_time<R: Real>(
        &self,
        scene: &dyn FieldScene<R>,
        time: R,
        (mesh, constants): (&Mesh, &Constants<'_, R>),
        work: &mut Work<R>,
    ) {
        let nodes = mesh.nodes();
        let values = [&constants.x[nodes.clone()], &work.u[nodes.clone()], &work.v[nodes.clone()]];
        let count = scene.field(self.field).parameters.len();
        let change = &mut work.force_change[nodes.clone()];
        let into = (&mut work.gradient[..2 * (2 + count)], &mut *change);
        scene.field_forces_on_values_by_time(self.field, time, values, &work.p, into);
        for (change, length) in change.iter_mut().zip(&constants.lengths[nodes]) {
            *change = *change * *length;
        }
    }

    /// Writes the rows of all own nodes into the Jacobian, and gives those of ports,
    /// which are derivatives of forces, to `port` with the node's number.
    pub(super) fn jacobian<R: Real>(
        &self,
        scene: &dyn FieldScene<R>,
        time: R,
        at: (&Mesh, &Constants<'_, R>),
        work: &mut Work<R>,
        jacobian: &mut [R],
        port: impl FnMut(usize, [R; 6]),
    ) {
        self.derivatives(scene, time, at, work);
        let into = (jacobian, port);
        // What is known here is known to the compiler where rows are written.
        match self.slots.as_slice() {
            [0, 1, 2, 3, 4, 5] => self.write(at, work, into, [0, 1, 2, 3, 4, 5]),
            [0, 1, 2, 4] => self.write(at, work, into, [0, 1, 2, 4]),
            [0, 1, 2] => self.write(at, work, into, [0, 1, 2]),
            slots => self.write(at, work, into, slots),
        }
    }

    /// Derivatives of f_0 at nodes and of f_1, by differences, of elements, unless they are
    /// known.
    fn derivatives<R: Real>(
        &self,
        scene: &dyn FieldScene<R>,
        time: R,
        (mesh, constants): (&Mesh, &Constants<'_, R>),
        work: &mut Work<R>,
    ) {
        let (nodes, elements) = (mesh.nodes(), mesh.owners.len() - 1);
        let [by_u, _, by_u_t, ..] = self.structure.derivatives;
        if [by_u, by_u_t].iter().any(|by| *by != Variation::Zero) {
            let Work { by_value, u, v, p, .. } = work;
            let values = [&constants.x[nodes.clone()], &u[nodes.clone()], &v[nodes]];
            let by = by_value.each_mut().map(|by| &mut by[..=elements]);
            scene.field_forces_on_values_jacobian(self.field, time, values, p, by);
        } else {
            // Another field may have been here.
            for by in &mut work.by_value {
                by[..=elements].fill(R::literal(0.0));
            }
        }
        if !self.has_section() {
            self.slopes((mesh, constants), work);
            let Work { by_slope, u_x, v_x, p, .. } = work;
            let slopes = [&u_x[..elements], &v_x[..elements]];
            let [by_u_x, by_v_x] = by_slope.each_mut().map(|by| &mut by[..elements]);
            scene.field_forces_on_slopes_jacobian(self.field, slopes, p, [by_u_x, by_v_x]);
            self.over_lengths(mesh, constants, [by_u_x, by_v_x]);
        }
    }

    /// Writes these entries of all rows.
    #[inline(always)]
    fn write<R: Real>(
        &self,
        (mesh, constants): (&Mesh, &Constants<'_, R>),
        work: &Work<R>,
        (jacobian, mut port): (&mut [R], impl FnMut(usize, [R; 6])),
        slots: impl AsRef<[usize]>,
    ) {
        let (slots, nodes, zero) = (slots.as_ref(), mesh.nodes(), R::literal(0.0));
        let [by_u, by_v] = &work.by_value;
        let [by_u_x, by_v_x] = &work.by_slope;
        let mut row = |node: usize, before: [R; 2], after: [R; 2]| {
            let length = constants.lengths[nodes.start + node];
            let [at_u, at_v] = [
                length * by_u[node] + (before[0] + after[0]),
                length * by_v[node] + (before[1] + after[1]),
            ];
            let of_force = [-before[0], at_u, -after[0], -before[1], at_v, -after[1]];
            let inverse = constants.inverse[nodes.start + node];
            match &self.rows[node] {
                Row::Together(first) => {
                    let entries = &mut jacobian[*first as usize..][..slots.len()];
                    for (entry, slot) in entries.iter_mut().zip(slots) {
                        *entry = of_force[*slot] * inverse;
                    }
                }
                Row::Apart(places) => {
                    for (place, of_force) in places.iter().zip(of_force) {
                        if *place != NOWHERE {
                            jacobian[*place as usize] = of_force * inverse;
                        }
                    }
                }
                Row::None => port(node, of_force),
            }
        };
        let section = self.has_section().then(|| constants.section(self.field));
        let mut before = [zero; 2];
        for (elements, inverse) in self.stretches(mesh, constants) {
            let even = section.map(|[_, a, b]| [a * inverse, b * inverse]);
            for node in elements {
                let after = even.unwrap_or_else(|| [by_u_x[node], by_v_x[node]]);
                row(node, before, after);
                before = after;
            }
        }
        row(mesh.owners.len() - 1, before, [zero; 2]);
    }

    /// Derivatives by slopes to those by differences.
    fn over_lengths<R: Real>(&self, mesh: &Mesh, constants: &Constants<'_, R>, by: [&mut [R]; 2]) {
        for by in by {
            for (elements, inverse) in self.stretches(mesh, constants) {
                for by in &mut by[elements] {
                    *by = *by * inverse;
                }
            }
        }
    }
}

/// Adds to the nodes of a stretch what equal springs between them do, which pull with
/// `by` times the difference of their ends.
fn pull_evenly<R: Real>(by: R, values: &[R], force: &mut [R]) {
    let last = values.len() - 1;
    let inner = values[..last].iter().zip(&values[1..last]).zip(&values[2..]);
    for (force, ((before, at), after)) in force[1..last].iter_mut().zip(inner) {
        *force = *force + by * ((*at - *before) - (*after - *at));
    }
    force[0] = force[0] - by * (values[1] - values[0]);
    force[last] = force[last] + by * (values[last] - values[last - 1]);
}
