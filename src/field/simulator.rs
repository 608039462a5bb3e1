//! A [`FieldSimulator`] as a simulator like any other.

use machinist_scenes::field::FieldPlace;
use machinist_scenes::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator, SparsityPattern,
    StateKind,
};

use super::mesh::Owner;
use super::{FieldSimulator, Work};

impl<R: Real> Describe for FieldSimulator<'_, R> {
    fn name(&self) -> &str {
        self.scene.name()
    }
    fn title(&self) -> &str {
        self.scene.title()
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: self.coordinates(),
            positions: self.coordinates(),
            quadratures: 0,
            parameters: self.parameters,
            ..self.machine
        }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        let (n, all) = (self.machine.coordinates, self.coordinates());
        let node = |order: usize, node: usize| {
            let field = self.scene.field(self.field_of[node] as usize);
            let quantity = if order == 0 { field.value } else { field.rate };
            Quantity { name: &self.names[order][node], ..shorter(quantity, self) }
        };
        match index {
            _ if index < n => self.scene.state(index),
            _ if index < all => node(0, index - n),
            _ if index < all + n => self.scene.state(index - all + n),
            _ if index < 2 * all => node(1, index - all - n),
            _ => self.scene.state(index - 2 * all + 2 * n),
        }
    }
    fn state_kind(&self, index: usize) -> StateKind {
        match index / self.coordinates().max(1) {
            0 => StateKind::Position,
            1 => StateKind::Velocity,
            _ => StateKind::FirstOrder,
        }
    }
    fn state_scale(&self, index: usize) -> f64 {
        let (n, all) = (self.machine.coordinates, self.coordinates());
        let node =
            |order: usize, node: usize| self.scene.field(self.field_of[node] as usize).scale[order];
        match index {
            _ if index < n => self.scene.state_scale(index),
            _ if index < all => node(0, index - n),
            _ if index < all + n => self.scene.state_scale(index - all + n),
            _ if index < 2 * all => node(1, index - all - n),
            _ => self.scene.state_scale(index - 2 * all + 2 * n),
        }
    }
    fn parameter(&self, index: usize) -> Quantity<'_> {
        assert!(index < self.parameters, "there is no parameter of number {index}");
        self.scene.parameter(index)
    }
    fn parameter_default(&self, index: usize) -> f64 {
        self.scene.parameter_default(index)
    }
    fn output(&self, index: usize) -> Quantity<'_> {
        self.scene.output(index)
    }
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> {
        let states = self.shape().states();
        SparsityPattern { rows: states, columns: states, entries: &self.rate_jacobian }
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        let (rows, columns) = (self.shape().states(), self.parameters);
        SparsityPattern { rows, columns, entries: &self.parameter_jacobian }
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        let n = self.coordinates();
        SparsityPattern { rows: n, columns: n, entries: &self.mass_matrix }
    }
    fn border(&self) -> Option<&[u32]> {
        Some(&self.border)
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        self.scene.run_defaults()
    }
}

/// A quantity for as long as the simulator lives.
fn shorter<'s, R>(quantity: Quantity<'s>, _: &'s FieldSimulator<'_, R>) -> Quantity<'s> {
    quantity
}

impl<R: Real> FieldSimulator<'_, R> {
    /// Places of the fields at these parameters.
    pub(super) fn place(&self, parameters: &[R], work: &mut Work<R>) {
        assert_eq!(parameters.len(), self.parameters, "number of parameters");
        work.p[..self.parameters].copy_from_slice(parameters);
        for index in 0..self.meshes.len() {
            let description = self.scene.field(index);
            let places = &mut work.places[..=description.attachments.len()];
            self.scene.field_places(index, &work.p, places);
            let bounds = &mut work.bounds[index];
            let inside = description.attachments.iter().zip(places.iter());
            let inside = inside.filter(|(at, _)| at.place == FieldPlace::Inside);
            let mut bound = 1;
            for (_, place) in inside {
                bounds[bound] = *place;
                bound += 1;
            }
            bounds[0] = R::literal(0.0);
            bounds[bound] = places[places.len() - 1];
        }
    }

    /// Nodes, state of the machine, inertia and force of the fields, and what they
    /// hand over.
    fn load(&self, time: R, state: &[R], parameters: &[R], work: &mut Work<R>) {
        assert_eq!(state.len(), self.shape().states(), "length of the state");
        self.place(parameters, work);
        for (index, value) in work.state.iter_mut().enumerate() {
            *value = state[self.border[index] as usize];
        }
        for (index, mesh) in self.meshes.iter().enumerate() {
            let nodes = mesh.nodes();
            for (owner, node) in mesh.owners.iter().zip(nodes.clone()) {
                [work.u[node], work.v[node]] = match self.columns(*owner) {
                    Some(columns) => columns.map(|column| state[column as usize]),
                    None => [R::literal(0.0); 2],
                };
            }
            let elements = mesh.elements(index, &work.bounds[index]);
            elements.inertia(self.scene, &work.p, &mut work.inertia[nodes.clone()]);
            let motion = (&work.u[nodes.clone()], &work.v[nodes.clone()]);
            elements.force(self.scene, (time, &work.p), motion, &mut work.force[nodes.clone()]);
            for (owner, node) in mesh.owners.iter().zip(nodes) {
                if let Owner::Port { handed, .. } = *owner {
                    work.p[handed as usize] = work.inertia[node];
                    work.p[handed as usize + 1] = work.force[node];
                }
            }
        }
    }

    /// Slopes on both sides of every port, handed over for outputs.
    fn hand_over_slopes(&self, time: R, work: &mut Work<R>) {
        let result = &mut work.result[..work.state.len()];
        self.scene.rate(time, &work.state, &work.p, result);
        for (index, mesh) in self.meshes.iter().enumerate() {
            let nodes = mesh.nodes();
            let motion = (&work.u[nodes.clone()], &work.v[nodes]);
            let elements = mesh.elements(index, &work.bounds[index]);
            let attachments = self.scene.field(index).attachments;
            for [number, bound, _] in &mesh.attached {
                let at = attachments[*number];
                let velocity = |coordinate: u32| self.machine.positions + coordinate as usize;
                let acceleration =
                    at.coordinate.map_or(R::literal(0.0), |c| work.result[velocity(c)]);
                let handed = at.handed as usize;
                let beside = elements.beside(*bound);
                for (element, (is_last, place)) in beside.iter().zip([(true, 2), (false, 3)]) {
                    let Some(element) = element else { continue };
                    work.p[handed + place] = elements.slope_of_section(
                        self.scene,
                        (time, &work.p),
                        motion,
                        (element, is_last),
                        acceleration,
                    );
                }
            }
        }
    }

    /// Every own node: field, node among those of all, and its number.
    fn own(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.meshes.iter().flat_map(|mesh| {
            mesh.owners.iter().zip(mesh.nodes()).filter_map(|(owner, node)| match owner {
                Owner::Field(own) => Some((node, *own as usize)),
                _ => None,
            })
        })
    }

    /// Every port: node among those of all, and first of the parameters handed over.
    fn ports(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.meshes.iter().flat_map(|mesh| {
            mesh.owners.iter().zip(mesh.nodes()).filter_map(|(owner, node)| match owner {
                Owner::Port { handed, .. } => Some((node, *handed as usize)),
                _ => None,
            })
        })
    }

    /// Entry of a pattern.
    fn find(entries: &[(u32, u32)], row: u32, column: u32) -> usize {
        entries.binary_search(&(row, column)).expect("the pattern was made of these entries")
    }
}

impl<R: Real> Simulator<R> for FieldSimulator<'_, R> {
    fn initial_state(&self, parameters: &[R], state: &mut [R]) {
        let work = &mut *self.work.borrow_mut();
        self.place(parameters, work);
        self.scene.initial_state(&work.p, &mut work.state);
        for (index, value) in work.state.iter().enumerate() {
            state[self.border[index] as usize] = *value;
        }
        for (index, mesh) in self.meshes.iter().enumerate() {
            let x = &mut work.force[mesh.nodes()];
            mesh.elements(index, &work.bounds[index]).places(x);
            for (owner, x) in mesh.owners.iter().zip(x) {
                if let (Owner::Field(_), Some(columns)) = (owner, self.columns(*owner)) {
                    let initial = self.scene.field_initial(index, *x, &work.p);
                    for (column, value) in columns.into_iter().zip(initial) {
                        state[column as usize] = value;
                    }
                }
            }
        }
    }

    fn discontinuities(&self, parameters: &[R], times: &mut [R]) {
        let work = &mut *self.work.borrow_mut();
        self.place(parameters, work);
        self.scene.discontinuities(&work.p, times);
    }

    fn rate(&self, time: R, state: &[R], parameters: &[R], rate: &mut [R]) {
        let work = &mut *self.work.borrow_mut();
        self.load(time, state, parameters, work);
        let n = self.coordinates();
        rate[..n].copy_from_slice(&state[n..2 * n]);
        let result = &mut work.result[..work.state.len()];
        self.scene.rate(time, &work.state, &work.p, result);
        for (index, value) in result.iter().enumerate() {
            rate[self.border[index] as usize] = *value;
        }
        let first = n + self.machine.coordinates;
        for (node, own) in self.own() {
            rate[first + own] = work.force[node] / work.inertia[node];
        }
    }

    fn rate_jacobian(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let work = &mut *self.work.borrow_mut();
        self.load(time, state, parameters, work);
        let entries = &self.rate_jacobian;
        assert_eq!(values.len(), entries.len(), "entries of the Jacobian");
        let n = self.coordinates();
        values.fill(R::literal(0.0));
        values[..n].fill(R::literal(1.0));
        let result = &mut work.result[..self.machine_entries.len()];
        self.scene.rate_jacobian(time, &work.state, &work.p, result);
        for (place, value) in self.machine_entries.iter().zip(&*result) {
            values[*place as usize] = *value;
        }
        self.scene.parameter_jacobian(time, &work.state, &work.p, &mut work.parameter_jacobian);

        work.at_ports.clear();
        let at_ports = &mut work.at_ports;
        let mut places = self.element_entries.iter();
        for (index, mesh) in self.meshes.iter().enumerate() {
            let nodes = mesh.nodes();
            let inertia = &work.inertia[nodes.clone()];
            let motion = (&work.u[nodes.clone()], &work.v[nodes]);
            let elements = mesh.elements(index, &work.bounds[index]);
            elements.force_jacobian(
                self.scene,
                (time, &work.p),
                motion,
                |element, i, j, by_u, by_v| {
                    let row = element * mesh.order + i;
                    let place = places.next().map_or([u32::MAX; 2], |place| *place);
                    if place[0] != u32::MAX {
                        for (place, by) in place.into_iter().zip([by_u, by_v]) {
                            let value = &mut values[place as usize];
                            *value = *value + by / inertia[row];
                        }
                    } else if let Owner::Port { handed, .. } = mesh.owners[row] {
                        let columns = self.columns(mesh.owners[element * mesh.order + j]);
                        for (column, by) in columns.into_iter().flatten().zip([by_u, by_v]) {
                            at_ports.push((handed as usize, column, by));
                        }
                    }
                },
            );
        }
        for (handed, column, by) in &*at_ports {
            for (index, row) in self.rows_of_port(*handed as u32) {
                let place = Self::find(entries, self.entry(row as usize), *column);
                values[place] = values[place] + work.parameter_jacobian[index] * *by;
            }
        }
    }

    fn parameter_jacobian(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let work = &mut *self.work.borrow_mut();
        self.load(time, state, parameters, work);
        let entries = &self.parameter_jacobian;
        assert_eq!(values.len(), entries.len(), "entries of the Jacobian");
        values.fill(R::literal(0.0));
        self.scene.parameter_jacobian(time, &work.state, &work.p, &mut work.parameter_jacobian);
        let machine = &self.machine_parameter_jacobian;
        for ((row, column), value) in machine.iter().zip(&work.parameter_jacobian) {
            if (*column as usize) < self.parameters {
                values[Self::find(entries, self.entry(*row as usize), *column)] = *value;
            }
        }
        for (index, mesh) in self.meshes.iter().enumerate() {
            let description = self.scene.field(index);
            let count = description.parameters.len();
            let slopes = &mut work.slopes[..count * (description.attachments.len() + 1)];
            self.scene.field_places_gradient(index, &work.p, slopes);
            let nodes = mesh.nodes();
            let motion = (&work.u[nodes.clone()], &work.v[nodes.clone()]);
            let elements = mesh.elements(index, &work.bounds[index]);
            let bounds = &mut work.bound_changes[..=mesh.segments.len()];
            bounds.fill(R::literal(0.0));
            for (k, parameter) in description.parameters.iter().enumerate() {
                for [number, bound, _] in &mesh.attached {
                    if description.attachments[*number].place == FieldPlace::Inside {
                        bounds[*bound] = slopes[number * count + k];
                    }
                }
                bounds[mesh.segments.len()] = slopes[description.attachments.len() * count + k];
                let inertia = &mut work.inertia_change[nodes.clone()];
                let force = &mut work.force_change[nodes.clone()];
                let gradient = &mut work.gradient[..2 * (2 + count)];
                let changes = (gradient, &mut *inertia, &mut *force);
                elements.by_parameter(self.scene, (time, &work.p), motion, (k, &*bounds), changes);
                for (node, owner) in mesh.owners.iter().enumerate() {
                    match *owner {
                        Owner::Fixed => {}
                        Owner::Field(_) => {
                            let Some([_, row]) = self.columns(*owner) else { continue };
                            let m = work.inertia[nodes.start + node];
                            let acceleration = work.force[nodes.start + node] / m;
                            let place = Self::find(entries, row, *parameter);
                            values[place] = (force[node] - acceleration * inertia[node]) / m;
                        }
                        Owner::Port { handed, .. } => {
                            let all = machine.iter().zip(&work.parameter_jacobian);
                            for ((row, column), value) in all {
                                let change = match column.checked_sub(handed) {
                                    Some(0) => inertia[node],
                                    Some(1) => force[node],
                                    _ => continue,
                                };
                                let row = self.entry(*row as usize);
                                let place = Self::find(entries, row, *parameter);
                                values[place] = values[place] + *value * change;
                            }
                        }
                    }
                }
            }
        }
    }

    fn time_derivative(&self, time: R, state: &[R], parameters: &[R], derivative: &mut [R]) {
        let work = &mut *self.work.borrow_mut();
        self.load(time, state, parameters, work);
        derivative.fill(R::literal(0.0));
        let result = &mut work.result[..work.state.len()];
        self.scene.time_derivative(time, &work.state, &work.p, result);
        for (index, value) in result.iter().enumerate() {
            derivative[self.border[index] as usize] = *value;
        }
        self.scene.parameter_jacobian(time, &work.state, &work.p, &mut work.parameter_jacobian);
        for (index, mesh) in self.meshes.iter().enumerate() {
            let nodes = mesh.nodes();
            let motion = (&work.u[nodes.clone()], &work.v[nodes.clone()]);
            let count = self.scene.field(index).parameters.len();
            let gradient = &mut work.gradient[..2 * (2 + count)];
            let changes = (gradient, &mut work.force_change[nodes]);
            let elements = mesh.elements(index, &work.bounds[index]);
            elements.force_by_time(self.scene, (time, &work.p), motion, changes);
        }
        for (node, handed) in self.ports() {
            for (index, row) in self.rows_of_port(handed as u32) {
                let change = &mut derivative[self.entry(row as usize) as usize];
                *change = *change + work.parameter_jacobian[index] * work.force_change[node];
            }
        }
        let first = self.coordinates() + self.machine.coordinates;
        for (node, own) in self.own() {
            derivative[first + own] = work.force_change[node] / work.inertia[node];
        }
    }

    fn mass_matrix(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let work = &mut *self.work.borrow_mut();
        self.load(time, state, parameters, work);
        let (machine, own) = values.split_at_mut(self.mass_matrix.len() - self.own_nodes);
        self.scene.mass_matrix(time, &work.state, &work.p, machine);
        for (node, place) in self.own() {
            own[place] = work.inertia[node];
        }
    }

    fn forcing(&self, time: R, state: &[R], parameters: &[R], forcing: &mut [R]) {
        let work = &mut *self.work.borrow_mut();
        self.load(time, state, parameters, work);
        let (machine, own) = forcing.split_at_mut(self.machine.coordinates);
        self.scene.forcing(time, &work.state, &work.p, machine);
        for (node, place) in self.own() {
            own[place] = work.force[node];
        }
    }

    fn outputs(&self, time: R, state: &[R], parameters: &[R], outputs: &mut [R]) {
        let work = &mut *self.work.borrow_mut();
        self.load(time, state, parameters, work);
        self.hand_over_slopes(time, work);
        self.scene.outputs(time, &work.state, &work.p, outputs);
    }

    fn energy(&self, time: R, state: &[R], parameters: &[R]) -> Energy<R> {
        let work = &mut *self.work.borrow_mut();
        self.load(time, state, parameters, work);
        let mut energy = self.scene.energy(time, &work.state, &work.p);
        for (index, mesh) in self.meshes.iter().enumerate() {
            let motion = (&work.u[mesh.nodes()], &work.v[mesh.nodes()]);
            let elements = mesh.elements(index, &work.bounds[index]);
            let [kinetic, potential, ..] =
                elements.energy_and_power(self.scene, (time, &work.p), motion);
            energy.kinetic = energy.kinetic + kinetic;
            energy.potential = energy.potential + potential;
        }
        // The machine has counted its nodes of the fields already.
        for (node, _) in self.ports() {
            let v = work.v[node];
            energy.kinetic = energy.kinetic - R::literal(0.5) * work.inertia[node] * v * v;
        }
        energy
    }

    fn power_balance(&self, time: R, state: &[R], parameters: &[R]) -> PowerBalance<R> {
        let work = &mut *self.work.borrow_mut();
        self.load(time, state, parameters, work);
        let mut balance = self.scene.power_balance(time, &work.state, &work.p);
        for (index, mesh) in self.meshes.iter().enumerate() {
            let motion = (&work.u[mesh.nodes()], &work.v[mesh.nodes()]);
            let elements = mesh.elements(index, &work.bounds[index]);
            let [_, _, stored, supplied, dissipated] =
                elements.energy_and_power(self.scene, (time, &work.p), motion);
            balance.stored_rate = balance.stored_rate + stored;
            balance.supplied = balance.supplied + supplied;
            balance.dissipated = balance.dissipated + dissipated;
        }
        // Kinetic energy of a node changes by its force times its speed.
        for (node, _) in self.own() {
            balance.stored_rate = balance.stored_rate + work.v[node] * work.force[node];
        }
        // What a field does to its node of the machine comes from nowhere else.
        for (node, _) in self.ports() {
            balance.supplied = balance.supplied - work.v[node] * work.force[node];
        }
        balance
    }
}
