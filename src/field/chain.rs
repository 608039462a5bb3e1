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
use machinist_contract::field::FieldScene;

use super::constants::Constants;
use super::mesh::{Mesh, Owner};
use super::{NOWHERE, Work};

/// What is known of a chain once its elements are.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    field: usize,
    /// Where the row of every node is among the entries of the Jacobian.
    rows: Vec<Row>,
}

/// Places of the derivatives of a node's acceleration by u of the node before, of itself
/// and of the one after it, then by u'.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Row {
    /// One after another.
    Together(u32),
    /// [`NOWHERE`] if there is no such entry.
    Apart([u32; 6]),
    /// It is no own node.
    None,
}

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
    pub(super) fn new(
        field: usize,
        mesh: &Mesh,
        columns: impl Fn(Owner) -> Option<[u32; 2]>,
        find: impl Fn(u32, u32) -> u32,
    ) -> Self {
        let row = |node: usize| {
            let (Owner::Field(_), Some([_, row])) = (mesh.owners[node], columns(mesh.owners[node]))
            else {
                return Row::None;
            };
            let beside = columns_beside(mesh, node, &columns);
            let places =
                beside.map(|column| if column == NOWHERE { NOWHERE } else { find(row, column) });
            let first = places[0];
            if first != NOWHERE && (0..6).all(|k| places[k] == first + k as u32) {
                Row::Together(first)
            } else {
                Row::Apart(places)
            }
        };
        Self { field, rows: (0..mesh.owners.len()).map(row).collect() }
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
        self.slopes((mesh, constants), work);
        let (nodes, elements) = (mesh.nodes(), mesh.owners.len() - 1);
        let values = [&constants.x[nodes.clone()], &work.u[nodes.clone()], &work.v[nodes.clone()]];
        let force = &mut work.force[nodes.clone()];
        scene.field_forces_on_values(self.field, time, values, &work.p, force);
        let slopes = [&work.u_x[..elements], &work.v_x[..elements]];
        let on_slopes = &mut work.on_slopes[..elements];
        scene.field_forces_on_slopes(self.field, slopes, &work.p, on_slopes);
        let mut before = R::literal(0.0);
        let inner = force.iter_mut().zip(&constants.lengths[nodes]);
        for ((force, length), after) in inner.zip(&*on_slopes) {
            *force = *force * *length + (before - *after);
            before = *after;
        }
        if let (Some(force), Some(length)) =
            (force.last_mut(), constants.lengths[mesh.nodes()].last())
        {
            *force = *force * *length + before;
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
        (mesh, constants): (&Mesh, &Constants<'_, R>),
        work: &mut Work<R>,
        jacobian: &mut [R],
        mut port: impl FnMut(usize, [R; 6]),
    ) {
        let (nodes, elements) = (mesh.nodes(), mesh.owners.len() - 1);
        self.slopes((mesh, constants), work);
        let Work { by_value, by_slope, u, v, u_x, v_x, p, .. } = work;
        let values = [&constants.x[nodes.clone()], &u[nodes.clone()], &v[nodes.clone()]];
        let [by_u, by_v] = by_value.each_mut().map(|by| &mut by[..=elements]);
        scene.field_forces_on_values_jacobian(self.field, time, values, p, [by_u, by_v]);
        let [by_u_x, by_v_x] = by_slope.each_mut().map(|by| &mut by[..elements]);
        let slopes = [&u_x[..elements], &v_x[..elements]];
        scene.field_forces_on_slopes_jacobian(self.field, slopes, p, [by_u_x, by_v_x]);
        self.over_lengths(mesh, constants, [by_u_x, by_v_x]);
        let zero = R::literal(0.0);
        let mut before = [zero; 2];
        for (node, row) in self.rows.iter().enumerate() {
            let after = if node < elements { [by_u_x[node], by_v_x[node]] } else { [zero; 2] };
            let length = constants.lengths[nodes.start + node];
            let [at_u, at_v] = [
                length * by_u[node] + (before[0] + after[0]),
                length * by_v[node] + (before[1] + after[1]),
            ];
            let of_force = [-before[0], at_u, -after[0], -before[1], at_v, -after[1]];
            let inverse = constants.inverse[nodes.start + node];
            match row {
                Row::Together(first) => {
                    let entries = &mut jacobian[*first as usize..][..6];
                    for (entry, of_force) in entries.iter_mut().zip(of_force) {
                        *entry = of_force * inverse;
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
            before = after;
        }
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
