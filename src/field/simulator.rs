//! [`FieldSimulator`] as an implementation of `Simulator`.

use machinist_contract::field::{FieldPlace, FieldScene};
use machinist_contract::linear::LinearEquations;
use machinist_contract::{
    Constraint, Derivatives, Describe, Dual, Energy, Event, PowerBalance, Quantity, Real, Refusal,
    Relation, RunDefaults, Shape, Simulator, SparsityPattern, StateKind,
};

use super::mesh::Owner;
use super::{EventPlaces, FieldSimulator, Work, find};

impl FieldSimulator<'_, f64> {
    /// Returns the simulator as a trait object whose code is compiled with this crate. A conversion
    /// elsewhere would compile that code again.
    #[must_use]
    #[inline(never)]
    pub fn single(&self) -> &dyn Simulator<f64> {
        self
    }
}

impl FieldSimulator<'_, Dual> {
    /// Avoids compiling the code again in other crates.
    #[inline(never)]
    fn as_derivatives(&self) -> &dyn Derivatives {
        self
    }
}

impl<R: Real> Describe for FieldSimulator<'_, R> {
    fn name(&self) -> &str {
        self.scene().name()
    }
    fn title(&self) -> &str {
        self.scene().title()
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
            let field = self.scene().field(self.field_of[node] as usize);
            let quantity = if order == 0 { field.value } else { field.rate };
            Quantity { name: &self.names[order][node], ..shorter(quantity, self) }
        };
        match index {
            _ if index < n => self.scene().state(index),
            _ if index < all => node(0, index - n),
            _ if index < all + n => self.scene().state(index - all + n),
            _ if index < 2 * all => node(1, index - all - n),
            _ => self.scene().state(index - 2 * all + 2 * n),
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
        let node = |order: usize, node: usize| {
            self.scene().field(self.field_of[node] as usize).scale[order]
        };
        match index {
            _ if index < n => self.scene().state_scale(index),
            _ if index < all => node(0, index - n),
            _ if index < all + n => self.scene().state_scale(index - all + n),
            _ if index < 2 * all => node(1, index - all - n),
            _ => self.scene().state_scale(index - 2 * all + 2 * n),
        }
    }
    fn parameter(&self, index: usize) -> Quantity<'_> {
        assert!(index < self.parameters, "there is no parameter of number {index}");
        self.scene().parameter(index)
    }
    fn parameter_default(&self, index: usize) -> f64 {
        self.scene().parameter_default(index)
    }
    fn output(&self, index: usize) -> Quantity<'_> {
        self.scene().output(index)
    }
    fn output_answers_at_once(&self, index: usize) -> bool {
        self.scene().output_answers_at_once(index)
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
        self.scene().run_defaults()
    }
    fn starts_in_equilibrium(&self) -> bool {
        self.scene().starts_in_equilibrium()
    }
    fn refusal(&self, parameters: &[f64]) -> Option<Refusal<'_>> {
        self.scene().refusal(parameters)
    }
    fn is_unused(&self, parameter: &str) -> bool {
        self.scene().is_unused(parameter)
    }
    fn events(&self) -> usize {
        self.events.len()
    }
    fn event(&self, index: usize) -> Event<'_> {
        let EventPlaces { when, sets } = &self.events[index];
        Event { when, sets, ..shorter_event(self.scene().event(index), self) }
    }
    fn is_mode(&self, index: usize) -> bool {
        let own = index.checked_sub(2 * self.coordinates());
        own.is_some_and(|own| self.scene().is_mode(own + 2 * self.machine.coordinates))
    }
    fn constraints(&self) -> usize {
        self.scene().constraints()
    }
    fn constraint(&self, index: usize) -> Constraint<'_> {
        self.scene().constraint(index)
    }
    fn kinks(&self) -> usize {
        self.scene().kinks()
    }
    fn inertia_has_corners(&self) -> bool {
        self.scene().inertia_has_corners()
    }
    fn saturations(&self) -> usize {
        self.scene().saturations()
    }

    fn relations(&self) -> usize {
        self.scene().relations()
    }
    fn relation(&self, index: usize) -> Relation<'_> {
        shorter_relation(self.scene().relation(index), self)
    }
    fn constraint_matrix_pattern(&self) -> SparsityPattern<'_> {
        // The coordinates of the machine come first.
        let columns = self.coordinates();
        SparsityPattern { columns, ..self.scene().constraint_matrix_pattern() }
    }
    fn is_given(&self, index: usize) -> bool {
        let place = self.border.iter().position(|entry| *entry as usize == index);
        place.is_none_or(|place| self.scene().is_given(place))
    }
}

/// Shortens the lifetime of an event to that of the simulator.
fn shorter_event<'s, R>(event: Event<'s>, _: &'s FieldSimulator<'_, R>) -> Event<'s> {
    event
}

/// Shortens the lifetime of a relation to that of the simulator.
fn shorter_relation<'s, R>(relation: Relation<'s>, _: &'s FieldSimulator<'_, R>) -> Relation<'s> {
    relation
}

/// Shortens the lifetime of a quantity to that of the simulator.
fn shorter<'s, R>(quantity: Quantity<'s>, _: &'s FieldSimulator<'_, R>) -> Quantity<'s> {
    quantity
}

impl<R: Real> FieldSimulator<'_, R> {
    /// Does the same as [`FieldSimulator::load`] with newly computed constants, and returns these.
    fn load_anew(&self, time: R, state: &[R], parameters: &[R], work: &mut Work<R>) -> Vec<R> {
        let mut constants = std::mem::take(&mut work.constants);
        self.compute_constants(parameters, work, &mut constants);
        let parts = self.taken_apart(&constants);
        work.inertia.copy_from_slice(parts.inertia);
        self.load((time, state), parameters, &parts, work);
        constants
    }

    /// Does the same as [`FieldSimulator::load_anew`] where constants are not needed afterwards.
    fn load_once(&self, time: R, state: &[R], parameters: &[R], work: &mut Work<R>) {
        work.constants = self.load_anew(time, state, parameters, work);
    }

    /// Evaluates a function that is that of the machine without its fields.
    fn of_scene(
        &self,
        (time, state, parameters): (R, &[R], &[R]),
        call: impl FnOnce(&dyn FieldScene<R>, &[R], &[R]),
    ) {
        let work = &mut *self.work();
        self.load_once(time, state, parameters, work);
        call(self.scene(), &work.state, &work.p);
    }

    /// Returns the length of the state.
    pub(super) fn border_and_own(&self) -> usize {
        self.border.len() + 2 * self.own_nodes
    }

    /// Provides the slopes on both sides of each port for outputs.
    fn hand_over_slopes(&self, time: R, work: &mut Work<R>) {
        let result = &mut work.result[..work.state.len()];
        self.scene().rate(time, &work.state, &work.p, result);
        for (index, mesh) in self.meshes.iter().enumerate() {
            let nodes = mesh.nodes();
            let motion = (&work.u[nodes.clone()], &work.v[nodes]);
            let elements = mesh.elements(index, &work.bounds[mesh.bounds(index)]);
            let attachments = self.scene().field(index).attachments;
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
                        self.scene(),
                        (time, &work.p),
                        motion,
                        (element, is_last),
                        acceleration,
                    );
                }
            }
        }
    }

    /// Returns each own node: its index among all nodes, and its number.
    fn own(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.meshes.iter().flat_map(|mesh| {
            mesh.owners.iter().zip(mesh.nodes()).filter_map(|(owner, node)| match owner {
                Owner::Field(own) => Some((node, *own as usize)),
                _ => None,
            })
        })
    }
}

impl<R: Real> Simulator<R> for FieldSimulator<'_, R> {
    fn linear(&self) -> Option<&dyn LinearEquations<R>> {
        self.excitation_terms.is_some().then_some(self)
    }

    fn derivatives(&self) -> Option<&dyn Derivatives> {
        self.on_duals.as_ref()?.get().map(FieldSimulator::as_derivatives)
    }

    fn initial_state(&self, parameters: &[R], state: &mut [R]) {
        let work = &mut *self.work();
        self.place(parameters, work);
        self.scene().initial_state(&work.p, &mut work.state);
        for (index, value) in work.state.iter().enumerate() {
            state[self.border[index] as usize] = *value;
        }
        for (index, mesh) in self.meshes.iter().enumerate() {
            let x = &mut work.force[mesh.nodes()];
            mesh.elements(index, &work.bounds[mesh.bounds(index)]).places(x);
            for (owner, x) in mesh.owners.iter().zip(x) {
                if let (Owner::Field(_), Some(columns)) = (owner, self.columns(*owner)) {
                    let initial = self.scene().field_initial(index, *x, &work.p);
                    for (column, value) in columns.into_iter().zip(initial) {
                        state[column as usize] = value;
                    }
                }
            }
        }
    }

    fn discontinuities(&self, parameters: &[R], times: &mut [R]) {
        let work = &mut *self.work();
        self.place(parameters, work);
        self.scene().discontinuities(&work.p, times);
    }

    fn constants(&self) -> usize {
        self.counts.all()
    }

    fn prepare(&self, parameters: &[R], constants: &mut [R]) {
        self.prepare_all(parameters, &mut self.work(), constants);
    }

    fn rate(&self, time: R, state: &[R], parameters: &[R], rate: &mut [R]) {
        let work = &mut *self.work();
        let constants = self.load_anew(time, state, parameters, work);
        self.loaded_rate((time, state), &self.taken_apart(&constants), work, rate);
        work.constants = constants;
    }

    fn prepared_rate(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        rate: &mut [R],
    ) {
        let constants = self.taken_apart(constants);
        if let Some(lines) = &self.lines {
            self.direct_rate(lines, (time, state), parameters, &constants, rate);
            return;
        }
        let work = &mut *self.work();
        self.load((time, state), parameters, &constants, work);
        self.loaded_rate((time, state), &constants, work, rate);
    }

    fn rate_jacobian(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let work = &mut *self.work();
        let constants = self.load_anew(time, state, parameters, work);
        self.loaded_jacobian(time, &self.taken_apart(&constants), work, values);
        work.constants = constants;
    }

    fn prepared_rate_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        values: &mut [R],
    ) {
        if self.counts.jacobian_is_constant {
            values.copy_from_slice(&constants[self.counts.without_jacobian()..]);
            return;
        }
        let (work, constants) = (&mut *self.work(), self.taken_apart(constants));
        self.load_for_derivatives((time, state), parameters, &constants, work);
        self.loaded_jacobian(time, &constants, work, values);
    }

    fn parameter_jacobian(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let work = &mut *self.work();
        self.load_once(time, state, parameters, work);
        let entries = &self.parameter_jacobian;
        assert_eq!(values.len(), entries.len(), "entries of the Jacobian");
        values.fill(R::literal(0.0));
        self.scene().parameter_jacobian(time, &work.state, &work.p, &mut work.parameter_jacobian);
        let machine = &self.machine_parameter_jacobian;
        for ((row, column), value) in machine.iter().zip(&work.parameter_jacobian) {
            if (*column as usize) < self.parameters {
                values[find(entries, self.entry(*row as usize), *column)] = *value;
            }
        }
        for (index, mesh) in self.meshes.iter().enumerate() {
            let description = self.scene().field(index);
            let count = description.parameters.len();
            let slopes = &mut work.slopes[..count * (description.attachments.len() + 1)];
            self.scene().field_places_gradient(index, &work.p, slopes);
            let nodes = mesh.nodes();
            let motion = (&work.u[nodes.clone()], &work.v[nodes.clone()]);
            let elements = mesh.elements(index, &work.bounds[mesh.bounds(index)]);
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
                elements.by_parameter(
                    self.scene(),
                    (time, &work.p),
                    motion,
                    (k, &*bounds),
                    changes,
                );
                for (node, owner) in mesh.owners.iter().enumerate() {
                    match *owner {
                        Owner::Fixed => {}
                        Owner::Field(_) => {
                            let Some([_, row]) = self.columns(*owner) else { continue };
                            let m = work.inertia[nodes.start + node];
                            let acceleration = work.force[nodes.start + node] / m;
                            let place = find(entries, row, *parameter);
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
                                let place = find(entries, row, *parameter);
                                values[place] = values[place] + *value * change;
                            }
                        }
                    }
                }
            }
        }
    }

    fn time_derivative(&self, time: R, state: &[R], parameters: &[R], derivative: &mut [R]) {
        let work = &mut *self.work();
        let constants = self.load_anew(time, state, parameters, work);
        self.loaded_time_derivative(time, &self.taken_apart(&constants), work, derivative);
        work.constants = constants;
    }

    fn prepared_time_derivative(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        derivative: &mut [R],
    ) {
        let (work, constants) = (&mut *self.work(), self.taken_apart(constants));
        self.load_for_derivatives((time, state), parameters, &constants, work);
        self.loaded_time_derivative(time, &constants, work, derivative);
    }

    fn mass_matrix(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let work = &mut *self.work();
        self.load_once(time, state, parameters, work);
        let (machine, own) = values.split_at_mut(self.mass_matrix.len() - self.own_nodes);
        self.scene().mass_matrix(time, &work.state, &work.p, machine);
        for (node, place) in self.own() {
            own[place] = work.inertia[node];
        }
    }

    fn forcing(&self, time: R, state: &[R], parameters: &[R], forcing: &mut [R]) {
        let work = &mut *self.work();
        self.load_once(time, state, parameters, work);
        let (machine, own) = forcing.split_at_mut(self.machine.coordinates);
        self.scene().forcing(time, &work.state, &work.p, machine);
        for (node, place) in self.own() {
            own[place] = work.force[node];
        }
    }

    fn guards(&self, time: R, state: &[R], parameters: &[R], guards: &mut [R]) {
        self.of_scene((time, state, parameters), |scene, state, p| {
            scene.guards(time, state, p, guards);
        });
    }

    fn guard_rates(&self, time: R, state: &[R], parameters: &[R], rates: &mut [R]) {
        self.of_scene((time, state, parameters), |scene, state, p| {
            scene.guard_rates(time, state, p, rates);
        });
    }

    fn resets(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        self.of_scene((time, state, parameters), |scene, state, p| {
            scene.resets(time, state, p, values);
        });
    }

    fn kink_guards(&self, time: R, state: &[R], parameters: &[R], guards: &mut [R]) {
        self.of_scene((time, state, parameters), |scene, state, p| {
            scene.kink_guards(time, state, p, guards);
        });
    }

    fn kink_rates(&self, time: R, state: &[R], parameters: &[R], rates: &mut [R]) {
        self.of_scene((time, state, parameters), |scene, state, p| {
            scene.kink_rates(time, state, p, rates);
        });
    }

    fn saturating_arguments(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        self.of_scene((time, state, parameters), |scene, state, p| {
            scene.saturating_arguments(time, state, p, values);
        });
    }

    fn constraint_values(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        self.of_scene((time, state, parameters), |scene, state, p| {
            scene.constraint_values(time, state, p, values);
        });
    }

    fn constraint_rates(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        self.of_scene((time, state, parameters), |scene, state, p| {
            scene.constraint_rates(time, state, p, values);
        });
    }

    fn constraint_matrix(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        self.of_scene((time, state, parameters), |scene, state, p| {
            scene.constraint_matrix(time, state, p, values);
        });
    }

    fn outputs(&self, time: R, state: &[R], parameters: &[R], outputs: &mut [R]) {
        let work = &mut *self.work();
        self.load_once(time, state, parameters, work);
        self.hand_over_slopes(time, work);
        self.scene().outputs(time, &work.state, &work.p, outputs);
    }

    fn energy(&self, time: R, state: &[R], parameters: &[R]) -> Energy<R> {
        let work = &mut *self.work();
        self.load_once(time, state, parameters, work);
        let mut energy = self.scene().energy(time, &work.state, &work.p);
        for (index, mesh) in self.meshes.iter().enumerate() {
            let motion = (&work.u[mesh.nodes()], &work.v[mesh.nodes()]);
            let elements = mesh.elements(index, &work.bounds[mesh.bounds(index)]);
            let [kinetic, potential, ..] =
                elements.energy_and_power(self.scene(), (time, &work.p), motion);
            energy.kinetic = energy.kinetic + kinetic;
            energy.potential = energy.potential + potential;
        }
        // The machine has already counted the nodes of fields that belong to it.
        for (node, _) in self.ports.iter().copied() {
            let v = work.v[node];
            energy.kinetic = energy.kinetic - R::literal(0.5) * work.inertia[node] * v * v;
        }
        energy
    }

    fn power_balance(&self, time: R, state: &[R], parameters: &[R]) -> PowerBalance<R> {
        let work = &mut *self.work();
        self.load_once(time, state, parameters, work);
        let mut balance = self.scene().power_balance(time, &work.state, &work.p);
        for (index, mesh) in self.meshes.iter().enumerate() {
            let motion = (&work.u[mesh.nodes()], &work.v[mesh.nodes()]);
            let elements = mesh.elements(index, &work.bounds[mesh.bounds(index)]);
            let [_, _, stored, supplied, dissipated] =
                elements.energy_and_power(self.scene(), (time, &work.p), motion);
            balance.stored_rate = balance.stored_rate + stored;
            balance.supplied = balance.supplied + supplied;
            balance.dissipated = balance.dissipated + dissipated;
        }
        // The rate of a node's kinetic energy is its force times its velocity.
        for (node, _) in self.own() {
            balance.stored_rate = balance.stored_rate + work.v[node] * work.force[node];
        }
        // The machine counts the forces of fields on its nodes as supplied; this removes them.
        for (node, _) in self.ports.iter().copied() {
            balance.supplied = balance.supplied - work.v[node] * work.force[node];
        }
        balance
    }
}
