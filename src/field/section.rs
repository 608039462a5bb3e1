//! Fields with local forces that are linear in their slopes:
//!
//! ```text
//! f_1 = c + a u_x + b u_xt                        with numbers that parameters decide
//! F_i = H_i f_0(u_i, u_i') + sum over elements of 1/h sum over j of B_ij (a u_j + b u_j')
//!       - c at the first node, + c at the last
//! B_ij = integral of l_i' l_j' over the unit interval
//! ```
//!
//! The coefficients between nodes are computed once per run, and so is their part of the Jacobian:
//! each call only evaluates f_0.

use machinist_contract::Real;
use machinist_contract::field::{FieldScene, Variation};

use super::constants::Constants;
use super::local::Local;
use super::mesh::{Mesh, Owner};
use super::{NOWHERE, Work};

/// Number of coefficients of a section: c, a, b.
pub(super) const NUMBERS: usize = 3;

/// Structure of such a field.
#[derive(Debug, Clone)]
pub(super) struct Section {
    local: Local,
    /// B, row by row.
    stiffness: Vec<f64>,
    /// Places of the derivatives of an own node's acceleration by u and by u' of the nodes of its
    /// element: element by element, row by row.
    places: Vec<[u32; 2]>,
    /// Own nodes with the places of the derivatives by their own u, and by their own u'.
    own: [Vec<(u32, u32)>; 2],
    ports: Vec<Port>,
}

/// A port, with the variables on which its force depends.
#[derive(Debug, Clone)]
struct Port {
    node: usize,
    /// One entry for each of its elements and each of their nodes.
    beside: Vec<Beside>,
    /// Places of the derivatives by its own u and u', for each row of the Jacobian that the force
    /// on the port affects.
    own: Vec<[u32; 2]>,
}

/// A node that exerts a force on a port.
#[derive(Debug, Clone)]
struct Beside {
    /// Segment of their common element.
    segment: usize,
    /// Entry of B for both nodes.
    stiffness: f64,
    /// Places for this node, ordered as [`Port::own`].
    places: Vec<[u32; 2]>,
}

impl Section {
    /// Returns whether a field has a section.
    pub fn is_there(local: &Local) -> bool {
        let [.., by_u_x, _, by_u_xt] = local.structure.derivatives;
        [by_u_x, by_u_xt].iter().all(|by| *by != Variation::Varying)
    }

    /// Creates the section of a mesh. `places` are those of its elements, `rows` the rows of the
    /// Jacobian that the force on a port affects, and `find` returns the place of an entry.
    pub fn new(
        local: Local,
        mesh: &Mesh,
        places: Vec<[u32; 2]>,
        columns: impl Fn(Owner) -> Option<[u32; 2]>,
        rows: impl Fn(Owner) -> Vec<u32>,
        find: impl Fn(u32, u32) -> u32,
    ) -> Self {
        let place = |row: u32, node: usize| match columns(mesh.owners[node]) {
            Some(columns) => columns.map(|column| find(row, column)),
            None => [NOWHERE; 2],
        };
        let mut own = [const { Vec::new() }; 2];
        for (node, owner) in mesh.owners.iter().enumerate() {
            let (Owner::Field(_), Some([_, row])) = (owner, columns(*owner)) else { continue };
            for (own, place) in own.iter_mut().zip(place(row, node)) {
                if place != NOWHERE {
                    own.push((node as u32, place));
                }
            }
        }
        let stiffness = mesh.rule.stiffness();
        let ports = mesh.ports.iter().map(|&node| {
            let rows = rows(mesh.owners[node]);
            let at = |node: usize| rows.iter().map(|row| place(*row, node)).collect();
            let mut beside = Vec::new();
            for nodes in mesh.elements_of_nodes().filter(|nodes| nodes.contains(&node)) {
                let (segment, i) = (mesh.segment_of(nodes.start), node - nodes.start);
                for (j, node) in nodes.clone().enumerate() {
                    let stiffness = stiffness[i * nodes.len() + j];
                    beside.push(Beside { segment, stiffness, places: at(node) });
                }
            }
            Port { node, beside, own: at(node) }
        });
        Self { local, ports: ports.collect(), stiffness, places, own }
    }

    /// Returns c, a and b for these parameters.
    pub fn numbers<R: Real>(&self, scene: &dyn FieldScene<R>, p: &[R]) -> [R; NUMBERS] {
        let zero = R::literal(0.0);
        let [mut c, mut a, mut b] = [[zero]; NUMBERS];
        let at_rest: [&[R]; 2] = [&[zero], &[zero]];
        scene.field_forces_on_slopes(self.local.field, at_rest, p, &mut c);
        scene.field_forces_on_slopes_jacobian(self.local.field, at_rest, p, [&mut a, &mut b]);
        [c[0], a[0], b[0]]
    }

    /// Computes F of all nodes.
    pub fn force<R: Real>(
        &self,
        scene: &dyn FieldScene<R>,
        time: R,
        (mesh, constants): (&Mesh, &Constants<'_, R>),
        work: &mut Work<R>,
    ) {
        self.local.force(scene, time, (mesh, constants), work);
        let Work { u, v, force, .. } = work;
        let (nodes, [c, a, b]) = (mesh.nodes(), constants.section(self.local.field));
        let [.., by_u_x, _, by_u_xt] = self.local.structure.derivatives;
        for (is, by, values) in [(by_u_x, a, u), (by_u_xt, b, v)] {
            if is == Variation::Zero {
                continue;
            }
            for (stretch, inverse) in constants.stretches(mesh, self.local.field) {
                let stretch = nodes.start + stretch.start..nodes.start + stretch.end;
                let (values, force) = (&values[stretch.clone()], &mut force[stretch]);
                match mesh.order {
                    1 => pull_evenly(by * inverse, values, force),
                    order => self.pull(order, by * inverse, values, force),
                }
            }
        }
        if let [first, .., last] = &mut force[nodes] {
            *first = *first - c;
            *last = *last + c;
        }
    }

    /// Adds the forces of elements of this order to the nodes of a segment; `by` is their
    /// stiffness.
    fn pull<R: Real>(&self, order: usize, by: R, values: &[R], force: &mut [R]) {
        for first in (0..values.len() - 1).step_by(order) {
            let (values, force) =
                (&values[first..=first + order], &mut force[first..=first + order]);
            // Relative to the first node, so that an element that moves as a whole has no force at
            // all.
            let start = values[0];
            for (force, row) in force.iter_mut().zip(self.stiffness.chunks_exact(order + 1)) {
                let mut sum = R::literal(0.0);
                for (value, stiffness) in values[1..].iter().zip(&row[1..]) {
                    sum = sum + R::literal(*stiffness) * (*value - start);
                }
                *force = *force + by * sum;
            }
        }
    }

    /// Adds the constant part of the rows of own nodes to the Jacobian.
    pub fn constant_part<R: Real>(
        &self,
        scene: &dyn FieldScene<R>,
        at: (&Mesh, &Constants<'_, R>),
        work: &mut Work<R>,
        jacobian: &mut [R],
    ) {
        let (mesh, constants) = at;
        let [_, a, b] = constants.section(self.local.field);
        let inverses = &constants.inverse[mesh.nodes()];
        let mut places = self.places.iter();
        for (stretch, inverse) in constants.stretches(mesh, self.local.field) {
            let by = [a * inverse, b * inverse];
            for first in (stretch.start..stretch.end - 1).step_by(mesh.order) {
                for (row, stiffness) in self.stiffness.chunks_exact(mesh.order + 1).enumerate() {
                    for (stiffness, places) in stiffness.iter().zip(&mut places) {
                        let weight = R::literal(*stiffness) * inverses[first + row];
                        for (place, by) in places.iter().zip(by) {
                            if *place != NOWHERE {
                                let value = &mut jacobian[*place as usize];
                                *value = *value + by * weight;
                            }
                        }
                    }
                }
            }
        }
        // The result does not depend on time and motion.
        self.local.derivatives(scene, R::literal(0.0), at, work);
        self.add_own(Variation::Constant, at, work, jacobian);
    }

    /// Adds the varying part of these rows.
    pub fn varying_part<R: Real>(
        &self,
        scene: &dyn FieldScene<R>,
        time: R,
        at: (&Mesh, &Constants<'_, R>),
        work: &mut Work<R>,
        jacobian: &mut [R],
    ) {
        self.local.derivatives(scene, time, at, work);
        self.add_own(Variation::Varying, at, work, jacobian);
    }

    /// Adds derivatives of f_0 of one kind of variation.
    fn add_own<R: Real>(
        &self,
        wanted: Variation,
        (mesh, constants): (&Mesh, &Constants<'_, R>),
        work: &Work<R>,
        jacobian: &mut [R],
    ) {
        let (lengths, inverses) =
            (&constants.lengths[mesh.nodes()], &constants.inverse[mesh.nodes()]);
        let own = self.own.iter().zip(&work.by_value).zip(self.local.variations());
        for ((own, by), _) in own.filter(|(_, is)| *is == wanted) {
            for (node, place) in own {
                let (node, value) = (*node as usize, &mut jacobian[*place as usize]);
                *value = *value + lengths[node] * by[node] * inverses[node];
            }
        }
    }

    /// Adds to the rows that forces on ports affect, with `weights` for each of them. Uses the
    /// results of [`Section::varying_part`].
    pub fn rows_of_ports<R: Real>(
        &self,
        (mesh, constants): (&Mesh, &Constants<'_, R>),
        (by_value, weights): (&[Vec<R>; 2], &[Vec<R>]),
        jacobian: &mut [R],
    ) {
        let [_, a, b] = constants.section(self.local.field);
        let mut add = |places: &[[u32; 2]], weights: &[R], by: [R; 2]| {
            for (places, weight) in places.iter().zip(weights) {
                for (place, by) in places.iter().zip(by) {
                    if *place != NOWHERE {
                        let value = &mut jacobian[*place as usize];
                        *value = *value + *weight * by;
                    }
                }
            }
        };
        for (port, weights) in self.ports.iter().zip(weights) {
            let length = constants.lengths[mesh.first_node + port.node];
            add(&port.own, weights, by_value.each_ref().map(|by| length * by[port.node]));
            for beside in &port.beside {
                let inverse = constants.inverse_of_length(mesh, self.local.field, beside.segment);
                let weight = R::literal(beside.stiffness) * inverse;
                add(&beside.places, weights, [a * weight, b * weight]);
            }
        }
    }

    /// Returns the number of ports.
    pub fn ports(&self) -> usize {
        self.ports.len()
    }

    /// Computes the partial derivative of F by time into `work.force_change`.
    pub fn force_by_time<R: Real>(
        &self,
        scene: &dyn FieldScene<R>,
        time: R,
        at: (&Mesh, &Constants<'_, R>),
        work: &mut Work<R>,
    ) {
        self.local.force_by_time(scene, time, at, work);
    }
}

/// Does the same as [`Section::pull`] for elements of order 1: equal springs between nodes.
fn pull_evenly<R: Real>(by: R, values: &[R], force: &mut [R]) {
    let last = values.len() - 1;
    let inner = values[..last].iter().zip(&values[1..last]).zip(&values[2..]);
    for (force, ((before, at), after)) in force[1..last].iter_mut().zip(inner) {
        *force = *force + by * ((*at - *before) - (*after - *at));
    }
    force[0] = force[0] - by * (values[1] - values[0]);
    force[last] = force[last] + by * (values[last] - values[last - 1]);
}
