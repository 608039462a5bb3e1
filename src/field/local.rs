//! Fields with local forces: f_0 depends only on u and u', and nothing else of the field is needed
//! at nodes.
//!
//! ```text
//! F_i = H_i f_0(u_i, u_i') + ...      H_i the part of the length that is the node's
//! ```

use machinist_contract::Real;
use machinist_contract::field::{FieldScene, ForceStructure, Variation};

use super::Work;
use super::constants::Constants;
use super::mesh::Mesh;

/// A field with local forces.
#[derive(Debug, Clone, Copy)]
pub(super) struct Local {
    pub field: usize,
    pub structure: ForceStructure,
}

impl Local {
    /// Returns the variation of df_0/du and df_0/du_t.
    pub fn variations(&self) -> [Variation; 2] {
        [self.structure.derivatives[0], self.structure.derivatives[2]]
    }

    /// Computes H f_0 of all nodes.
    pub fn force<R: Real>(
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
            return;
        }
        let values = [&constants.x[nodes.clone()], &work.u[nodes.clone()], &work.v[nodes.clone()]];
        scene.field_forces_on_values(self.field, time, values, &work.p, force);
        for (force, length) in force.iter_mut().zip(&constants.lengths[nodes]) {
            *force = *force * *length;
        }
    }

    /// Computes df_0/du and df_0/du_t of all nodes into `work.by_value`.
    pub fn derivatives<R: Real>(
        &self,
        scene: &dyn FieldScene<R>,
        time: R,
        (mesh, constants): (&Mesh, &Constants<'_, R>),
        work: &mut Work<R>,
    ) {
        let nodes = mesh.nodes();
        let Work { by_value, u, v, p, .. } = work;
        let by = by_value.each_mut().map(|by| &mut by[..nodes.len()]);
        if self.variations() == [Variation::Zero; 2] {
            // The memory may contain values of another field.
            for by in by {
                by.fill(R::literal(0.0));
            }
            return;
        }
        let values = [&constants.x[nodes.clone()], &u[nodes.clone()], &v[nodes]];
        scene.field_forces_on_values_jacobian(self.field, time, values, p, by);
    }

    /// Computes the partial derivative of F by time into `work.force_change`.
    pub fn force_by_time<R: Real>(
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
}
