//! Rate, Jacobian and time derivative from loaded values.

use machinist_contract::Real;

use super::chain::Chain;
use super::constants::Constants;
use super::mesh::Owner;
use super::{FieldSimulator, Law, NOWHERE, Work, find};

impl<R: Real> FieldSimulator<'_, R> {
    /// Computes y'.
    pub(super) fn loaded_rate(
        &self,
        (time, state): (R, &[R]),
        constants: &Constants<'_, R>,
        work: &mut Work<R>,
        rate: &mut [R],
    ) {
        let n = self.coordinates();
        rate[..n].copy_from_slice(&state[n..2 * n]);
        let result = &mut work.result[..work.state.len()];
        self.scene().prepared_rate(time, &work.state, &work.p, constants.machine, result);
        for (value, place) in result.iter().zip(&self.border) {
            rate[*place as usize] = *value;
        }
        self.of_own_nodes(&work.force, constants.inverse, rate);
    }

    /// Computes accelerations of own nodes from forces.
    fn of_own_nodes(&self, forces: &[R], inverse: &[R], rate: &mut [R]) {
        let first = self.coordinates() + self.machine.coordinates;
        for mesh in &self.meshes {
            for run in &mesh.runs {
                let nodes = mesh.first_node + run.nodes.start..mesh.first_node + run.nodes.end;
                let into = &mut rate[first + run.own..][..nodes.len()];
                let forces = forces[nodes.clone()].iter().zip(&inverse[nodes]);
                for (rate, (force, inverse)) in into.iter_mut().zip(forces) {
                    *rate = *force * *inverse;
                }
            }
        }
    }

    /// Computes the partial derivative of y' by time.
    pub(super) fn loaded_time_derivative(
        &self,
        time: R,
        constants: &Constants<'_, R>,
        work: &mut Work<R>,
        derivative: &mut [R],
    ) {
        derivative.fill(R::literal(0.0));
        let result = &mut work.result[..work.state.len()];
        self.scene().time_derivative(time, &work.state, &work.p, result);
        for (value, place) in result.iter().zip(&self.border) {
            derivative[*place as usize] = *value;
        }
        for (index, mesh) in self.meshes.iter().enumerate() {
            let (scene, at) = (self.scene(), (mesh, constants));
            match &self.laws[index] {
                Law::Section(section) => section.force_by_time(scene, time, at, work),
                Law::Chain(chain) => chain.force_by_time(scene, time, at, work),
                Law::Any { .. } => {
                    let nodes = mesh.nodes();
                    let motion = (&work.u[nodes.clone()], &work.v[nodes.clone()]);
                    let count = scene.field(index).parameters.len();
                    let gradient = &mut work.gradient[..2 * (2 + count)];
                    let changes = (gradient, &mut work.force_change[nodes]);
                    let elements = mesh.elements(index, constants.bounds(mesh.bounds(index)));
                    elements.force_by_time(scene, (time, &work.p), motion, changes);
                }
            }
        }
        self.weigh_ports(time, work);
        for (port, (node, _)) in self.ports.iter().copied().enumerate() {
            for (row, weight) in self.port_rows[port].iter().zip(&work.port_weights[port]) {
                let change = &mut derivative[row.row as usize];
                *change = *change + *weight * work.force_change[node];
            }
        }
        self.of_own_nodes(&work.force_change, constants.inverse, derivative);
    }

    /// Computes dy'/dy.
    pub(super) fn loaded_jacobian(
        &self,
        time: R,
        constants: &Constants<'_, R>,
        work: &mut Work<R>,
        values: &mut [R],
    ) {
        let entries = &self.rate_jacobian;
        assert_eq!(values.len(), entries.len(), "entries of the Jacobian");
        if constants.jacobian.is_empty() {
            self.constant_part(constants, work, values);
        } else {
            values.copy_from_slice(constants.jacobian);
        }
        let result = &mut work.result[..self.machine_entries.len()];
        self.scene().prepared_rate_jacobian(time, &work.state, &work.p, constants.machine, result);
        for (place, value) in self.machine_entries.iter().zip(&*result) {
            values[*place as usize] = *value;
        }
        self.weigh_ports(time, work);
        let mut port = 0;
        for (index, law) in self.laws.iter().enumerate() {
            match law {
                Law::Section(section) => {
                    let mesh = &self.meshes[index];
                    section.varying_part(self.scene(), time, (mesh, constants), work, values);
                    let weights = &work.port_weights[port..];
                    let by_ports = (&work.by_value, weights);
                    section.rows_of_ports((mesh, constants), by_ports, values);
                    port += section.ports();
                }
                Law::Chain(chain) => {
                    let at = (index, constants);
                    self.jacobian_of_chain(chain, (time, at), work, values, &mut port);
                }
                Law::Any { places } => {
                    let at = (index, constants);
                    self.jacobian_of_elements(places, (time, at), work, values, &mut port);
                }
            }
        }
    }

    /// Computes the constant part of the Jacobian, with zeros where it varies.
    pub(super) fn constant_part(
        &self,
        constants: &Constants<'_, R>,
        work: &mut Work<R>,
        values: &mut [R],
    ) {
        values.fill(R::literal(0.0));
        values[..self.coordinates()].fill(R::literal(1.0));
        for (index, section) in self.sections() {
            section.constant_part(self.scene(), (&self.meshes[index], constants), work, values);
        }
    }

    /// Adds the part of a chain; ports are counted.
    fn jacobian_of_chain(
        &self,
        chain: &Chain,
        (time, (index, constants)): (R, (usize, &Constants<'_, R>)),
        work: &mut Work<R>,
        values: &mut [R],
        port: &mut usize,
    ) {
        let mesh = &self.meshes[index];
        let mut of_ports = std::mem::take(&mut work.of_ports);
        of_ports.clear();
        chain.jacobian(self.scene(), time, (mesh, constants), work, values, |node, of_force| {
            if let Owner::Port { .. } = mesh.owners[node] {
                of_ports.push(of_force);
            }
        });
        for of_force in &of_ports {
            for (row, weight) in self.port_rows[*port].iter().zip(&work.port_weights[*port]) {
                for (place, of_force) in row.places.iter().zip(of_force) {
                    if *place != NOWHERE {
                        let value = &mut values[*place as usize];
                        *value = *value + *weight * *of_force;
                    }
                }
            }
            *port += 1;
        }
        work.of_ports = of_ports;
    }

    /// Adds the part of elements of any order; ports are counted.
    fn jacobian_of_elements(
        &self,
        places: &[[u32; 2]],
        (time, (index, constants)): (R, (usize, &Constants<'_, R>)),
        work: &mut Work<R>,
        values: &mut [R],
        port: &mut usize,
    ) {
        let mesh = &self.meshes[index];
        let nodes = mesh.nodes();
        let inverse = &constants.inverse[nodes.clone()];
        let motion = (&work.u[nodes.clone()], &work.v[nodes]);
        let elements = mesh.elements(index, constants.bounds(mesh.bounds(index)));
        let mut places = places.iter();
        let structure = self.scene().force_structure(index);
        let at_ports = &mut work.at_ports;
        at_ports.clear();
        elements.force_jacobian(
            self.scene(),
            (time, &work.p),
            motion,
            |element, i, j, by_u, by_v| {
                let row = element * mesh.order + i;
                let place = places.next().map_or([NOWHERE; 2], |place| *place);
                for (place, by) in place.into_iter().zip([by_u, by_v]) {
                    if place != NOWHERE {
                        let value = &mut values[place as usize];
                        *value = *value + by * inverse[row];
                    }
                }
                if mesh.ports.contains(&row) {
                    let columns = self.columns(mesh.owners[element * mesh.order + j]);
                    let reaches = structure.reaches(i == j);
                    let there = columns.into_iter().flatten().zip([by_u, by_v]).zip(reaches);
                    for ((column, by), _) in there.filter(|(_, there)| *there) {
                        at_ports.push((row, column, by));
                    }
                }
            },
        );
        for node in &mesh.ports {
            for (row, weight) in self.port_rows[*port].iter().zip(&work.port_weights[*port]) {
                for (_, column, by) in at_ports.iter().filter(|(at, ..)| at == node) {
                    let place = find(&self.rate_jacobian, row.row, *column);
                    values[place] = values[place] + *weight * *by;
                }
            }
            *port += 1;
        }
    }

    /// Computes derivatives of the machine's rates by forces on ports.
    fn weigh_ports(&self, time: R, work: &mut Work<R>) {
        if self.port_rows.is_empty() {
            return;
        }
        if self.accelerations_are_separate {
            self.scene().mass_matrix(time, &work.state, &work.p, &mut work.mass);
        } else {
            let values = &mut work.parameter_jacobian;
            self.scene().parameter_jacobian(time, &work.state, &work.p, values);
        }
        for (rows, weights) in self.port_rows.iter().zip(&mut work.port_weights) {
            for (row, weight) in rows.iter().zip(weights) {
                *weight = if self.accelerations_are_separate {
                    R::literal(1.0) / work.mass[row.coordinate as usize]
                } else {
                    work.parameter_jacobian[row.by_force as usize]
                };
            }
        }
    }
}
