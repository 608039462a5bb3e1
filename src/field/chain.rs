//! Fields with elements of order 1 and local forces: chains of inertias at nodes and springs of any
//! law between them.
//!
//! ```text
//! F_i = H_i f_0(u_i, u_i') + f_1(e - 1) - f_1(e)      e - 1 and e the elements beside i
//! ```
//!
//! where H_i is half the length of these elements, and f_1 is evaluated once per element, since its
//! slope is the same at both ends.

use machinist_contract::Real;
use machinist_contract::field::FieldScene;

use super::constants::Constants;
use super::local::Local;
use super::mesh::{Mesh, Owner};
use super::{NOWHERE, Work};

/// Structure of a chain.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    local: Local,
    /// Place of the row of each node among the entries of the Jacobian.
    rows: Vec<Row>,
}

/// Places of the derivatives of a node's acceleration by u of the previous node, of itself and of
/// the next one, then by u'.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Row {
    /// Consecutive places.
    Together(u32),
    /// Separate places; [`NOWHERE`] where there is no entry.
    Apart([u32; 6]),
    /// The node is not an own node.
    None,
}

/// Returns the columns around a node, ordered as in a [`Row`].
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
    /// Creates the chain of a mesh of order 1. `find` returns the place of an entry in the
    /// Jacobian, `row` the row of an own node.
    pub(super) fn new(
        local: Local,
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
        Self { local, rows: (0..mesh.owners.len()).map(row).collect() }
    }

    /// Computes the slopes of all elements.
    fn slopes<R: Real>(&self, (mesh, constants): (&Mesh, &Constants<'_, R>), work: &mut Work<R>) {
        for (nodes, inverse) in constants.stretches(mesh, self.local.field) {
            for (values, slopes) in [(&work.u, &mut work.u_x), (&work.v, &mut work.v_x)] {
                let values = &values[mesh.first_node..][nodes.clone()];
                for (slope, ends) in slopes[nodes.start..].iter_mut().zip(values.windows(2)) {
                    *slope = (ends[1] - ends[0]) * inverse;
                }
            }
        }
    }

    /// Computes F of all nodes.
    pub(super) fn force<R: Real>(
        &self,
        scene: &dyn FieldScene<R>,
        time: R,
        (mesh, constants): (&Mesh, &Constants<'_, R>),
        work: &mut Work<R>,
    ) {
        self.local.force(scene, time, (mesh, constants), work);
        self.slopes((mesh, constants), work);
        let elements = mesh.owners.len() - 1;
        let slopes = [&work.u_x[..elements], &work.v_x[..elements]];
        let on_slopes = &mut work.on_slopes[..elements];
        scene.field_forces_on_slopes(self.local.field, slopes, &work.p, on_slopes);
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

    /// Computes the partial derivative of F by time into `work.force_change`.
    pub(super) fn force_by_time<R: Real>(
        &self,
        scene: &dyn FieldScene<R>,
        time: R,
        at: (&Mesh, &Constants<'_, R>),
        work: &mut Work<R>,
    ) {
        self.local.force_by_time(scene, time, at, work);
    }

    /// Writes the rows of all own nodes into the Jacobian. Rows of ports, which are derivatives of
    /// forces, are passed to `port` with the node's number.
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
        self.local.derivatives(scene, time, (mesh, constants), work);
        let Work { by_value: [by_u, by_v], by_slope, u_x, v_x, p, .. } = work;
        let [by_u_x, by_v_x] = by_slope.each_mut().map(|by| &mut by[..elements]);
        let slopes = [&u_x[..elements], &v_x[..elements]];
        scene.field_forces_on_slopes_jacobian(self.local.field, slopes, p, [by_u_x, by_v_x]);
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

    /// Converts derivatives by slopes to derivatives by differences.
    fn over_lengths<R: Real>(&self, mesh: &Mesh, constants: &Constants<'_, R>, by: [&mut [R]; 2]) {
        for by in by {
            for (nodes, inverse) in constants.stretches(mesh, self.local.field) {
                for by in &mut by[nodes.start..nodes.end - 1] {
                    *by = *by * inverse;
                }
            }
        }
    }
}
