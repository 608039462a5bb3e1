//! Constants of the parameters of a scene divided into elements, computed once per run.

use std::ops::Range;

use machinist_contract::Real;
use machinist_contract::field::FieldPlace;

use super::mesh::{Mesh, Owner};
use super::section::NUMBERS;
use super::{FieldSimulator, Law, Work};

/// Slices of the constants: those of the machine, then for each node of every field x, its part of
/// the length, its inertia and the inverse of it, then the bounds of all segments, the numbers of
/// every field's section and the corresponding stiffnesses in every segment, and the constant part
/// of the Jacobian.
#[derive(Debug, Clone, Copy)]
pub(super) struct Constants<'c, R> {
    pub machine: &'c [R],
    pub x: &'c [R],
    pub lengths: &'c [R],
    pub inertia: &'c [R],
    pub inverse: &'c [R],
    bounds: &'c [R],
    sections: &'c [R],
    pulls: &'c [[R; 2]],
    /// Complete Jacobian, or with zeros where it varies. Empty if nothing of it is constant, or if
    /// only the others were requested.
    pub jacobian: &'c [R],
}

impl<'c, R: Copy> Constants<'c, R> {
    /// Returns the bounds of the segments of a mesh.
    pub fn bounds(&self, range: Range<usize>) -> &'c [R] {
        &self.bounds[range]
    }

    /// Returns c, a and b of a field with a section.
    pub fn section(&self, field: usize) -> [R; NUMBERS] {
        std::array::from_fn(|number| self.sections[NUMBERS * field + number])
    }
}

impl<'c, R: Real> Constants<'c, R> {
    /// Returns a and b over the element length for each segment of a field with a section.
    pub fn pulls(&self, mesh: &Mesh) -> &'c [[R; 2]] {
        &self.pulls[mesh.first_segment..][..mesh.segments.len()]
    }

    /// Returns the nodes of each segment of a field, including both ends, and the inverse of its
    /// element length.
    pub fn stretches(
        &self,
        mesh: &'c Mesh,
        field: usize,
    ) -> impl Iterator<Item = (Range<usize>, R)> + use<'c, R> {
        let (constants, order) = (*self, mesh.order);
        mesh.segments.iter().enumerate().map(move |(index, segment)| {
            let (first, elements) = (segment.first_node as usize, segment.elements as usize);
            let inverse = constants.inverse_of_length(mesh, field, index);
            (first..first + order * elements + 1, inverse)
        })
    }

    /// Returns the inverse of the element length in a segment.
    pub fn inverse_of_length(&self, mesh: &Mesh, field: usize, segment: usize) -> R {
        mesh.inverse_of_length(segment, &self.bounds[mesh.bounds(field)])
    }
}

/// Numbers of constants.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Counts {
    machine: usize,
    nodes: usize,
    bounds: usize,
    sections: usize,
    segments: usize,
    jacobian: usize,
    /// True if machine and fields are linear and without switches.
    pub jacobian_is_constant: bool,
}

impl Counts {
    /// Returns the total number.
    pub fn all(&self) -> usize {
        self.without_jacobian() + self.jacobian
    }

    /// Returns the number without the Jacobian.
    pub fn without_jacobian(&self) -> usize {
        self.machine + 4 * self.nodes + self.bounds + self.sections + 2 * self.segments
    }
}

impl<R: Real> FieldSimulator<'_, R> {
    /// Counts the constants, after everything else is laid out.
    pub(super) fn count_constants(&self) -> Counts {
        let linear = self.excitation_terms.as_ref().and_then(|_| self.scene().linear());
        let jacobian_is_constant = linear.is_some_and(|linear| linear.switches() == 0);
        let has_part = jacobian_is_constant || self.sections().next().is_some();
        Counts {
            machine: self.scene().constants(),
            nodes: self.nodes(),
            bounds: self.meshes.iter().map(|mesh| mesh.segments.len() + 1).sum(),
            sections: NUMBERS * self.meshes.len(),
            segments: self.meshes.iter().map(|mesh| mesh.segments.len()).sum(),
            jacobian: if has_part { self.rate_jacobian.len() } else { 0 },
            jacobian_is_constant,
        }
    }

    /// Divides the constants into their slices.
    pub(super) fn taken_apart<'c>(&self, constants: &'c [R]) -> Constants<'c, R> {
        let Counts { machine, nodes, bounds, sections, segments, .. } = self.counts;
        let (machine, rest) = constants.split_at(machine);
        let (x, rest) = rest.split_at(nodes);
        let (lengths, rest) = rest.split_at(nodes);
        let (inertia, rest) = rest.split_at(nodes);
        let (inverse, rest) = rest.split_at(nodes);
        let (bounds, rest) = rest.split_at(bounds);
        let (sections, rest) = rest.split_at(sections);
        let (pulls, jacobian) = rest.split_at(2 * segments);
        let (pulls, _) = pulls.as_chunks();
        Constants { machine, x, lengths, inertia, inverse, bounds, sections, pulls, jacobian }
    }

    /// Computes all constants.
    pub(super) fn prepare_all(&self, parameters: &[R], work: &mut Work<R>, into: &mut [R]) {
        assert_eq!(into.len(), self.counts.all(), "number of constants");
        let (others, jacobian) = into.split_at_mut(self.counts.without_jacobian());
        self.compute_constants(parameters, work, others);
        if !jacobian.is_empty() {
            // The result does not depend on time and state.
            let (time, rest) = (R::literal(0.0), vec![R::literal(0.0); self.border_and_own()]);
            let others = self.taken_apart(others);
            self.load_for_derivatives((time, &rest), parameters, &others, work);
            if self.counts.jacobian_is_constant {
                self.loaded_jacobian(time, &others, work, jacobian);
            } else {
                self.constant_part(&others, work, jacobian);
            }
        }
    }

    /// Computes the constants except the Jacobian, and leaves the parameters with the inertias that
    /// fields provide in `work.p`.
    pub(super) fn compute_constants(&self, parameters: &[R], work: &mut Work<R>, into: &mut [R]) {
        assert_eq!(into.len(), self.counts.without_jacobian(), "number of constants");
        self.place(parameters, work);
        let Counts { machine, nodes, bounds, sections, .. } = self.counts;
        let (machine, rest) = into.split_at_mut(machine);
        let (x, rest) = rest.split_at_mut(nodes);
        let (lengths, rest) = rest.split_at_mut(nodes);
        let (inertia, rest) = rest.split_at_mut(nodes);
        let (inverse, rest) = rest.split_at_mut(nodes);
        let (bounds, rest) = rest.split_at_mut(bounds);
        let (sections, pulls) = rest.split_at_mut(sections);
        let (pulls, _) = pulls.as_chunks_mut();
        bounds.copy_from_slice(&work.bounds);
        for (index, section) in self.sections() {
            let numbers @ [_, a, b] = section.numbers(self.scene(), &work.p);
            sections[NUMBERS * index..][..NUMBERS].copy_from_slice(&numbers);
            let mesh = &self.meshes[index];
            let bounds = &bounds[mesh.bounds(index)];
            for (segment, pulls) in
                pulls[mesh.first_segment..][..mesh.segments.len()].iter_mut().enumerate()
            {
                let inverse = mesh.inverse_of_length(segment, bounds);
                *pulls = [a * inverse, b * inverse];
            }
        }
        for (index, mesh) in self.meshes.iter().enumerate() {
            let elements = mesh.elements(index, &bounds[mesh.bounds(index)]);
            let nodes = mesh.nodes();
            elements.places(&mut x[nodes.clone()]);
            elements.lengths(&mut lengths[nodes.clone()]);
            let densities = &mut inertia[nodes.clone()];
            if self.scene().force_structure(index).local {
                self.scene().field_inertias(index, &x[nodes.clone()], &work.p, densities);
                for (inertia, length) in densities.iter_mut().zip(&lengths[nodes]) {
                    *inertia = *inertia * *length;
                }
            } else {
                elements.inertia(self.scene(), &work.p, densities);
            }
        }
        for (inverse, inertia) in inverse.iter_mut().zip(&*inertia) {
            *inverse = R::literal(1.0) / *inertia;
        }
        self.hand_over_inertias(inertia, work);
        self.scene().prepare(&work.p, machine);
    }

    /// Copies the inertias of ports into the parameters of the machine.
    pub(super) fn hand_over_inertias(&self, inertia: &[R], work: &mut Work<R>) {
        for (node, handed) in self.ports.iter().copied() {
            work.p[handed] = inertia[node];
        }
    }

    /// Writes the parameters, and behind those that fields provide the slots of relations: the given
    /// ones, or slots that leave relations live.
    fn write_parameters(&self, parameters: &[R], work: &mut Work<R>) {
        let (parameters, slots) = parameters.split_at(self.parameters);
        work.p[..self.parameters].copy_from_slice(parameters);
        let into = &mut work.p[self.machine.parameters..];
        if slots.is_empty() {
            for (index, slot) in into.iter_mut().enumerate() {
                *slot = R::literal(self.scene().relation(index).kind.live());
            }
        } else {
            into.copy_from_slice(slots);
        }
    }

    /// Computes the places of the fields for these parameters.
    pub(super) fn place(&self, parameters: &[R], work: &mut Work<R>) {
        self.write_parameters(parameters, work);
        for (index, mesh) in self.meshes.iter().enumerate() {
            let attachments = self.scene().field(index).attachments;
            let places = &mut work.places[..=attachments.len()];
            self.scene().field_places(index, &work.p, places);
            let bounds = &mut work.bounds[mesh.bounds(index)];
            let inside = attachments.iter().zip(places.iter());
            let inside = inside.filter(|(at, _)| at.place == FieldPlace::Inside);
            let mut bound = 1;
            for (_, place) in inside {
                bounds[bound] = *place;
                bound += 1;
            }
            bounds[0] = R::literal(0.0);
            bounds[bound] = places[places.len() - 1];
            // A port beyond an end of the field, or beyond another port, gives NaN, which is
            // reported as such.
            for bound in 1..=bound {
                let [before, here] = [bounds[bound - 1], bounds[bound]];
                bounds[bound] = R::select_less(here, before, R::literal(f64::NAN), here);
            }
        }
    }

    /// Computes values at nodes, the state of the machine, the forces of the fields, and the
    /// parameters that fields provide.
    pub(super) fn load(
        &self,
        (time, state): (R, &[R]),
        parameters: &[R],
        constants: &Constants<'_, R>,
        work: &mut Work<R>,
    ) {
        self.load_motion(state, parameters, constants, work);
        self.load_forces(time, constants, work);
    }

    /// Does the same as [`FieldSimulator::load`], without forces where derivatives do not need
    /// them.
    pub(super) fn load_for_derivatives(
        &self,
        (time, state): (R, &[R]),
        parameters: &[R],
        constants: &Constants<'_, R>,
        work: &mut Work<R>,
    ) {
        self.load_motion(state, parameters, constants, work);
        if self.derivatives_read_forces {
            self.load_forces(time, constants, work);
        }
    }

    fn load_motion(
        &self,
        state: &[R],
        parameters: &[R],
        constants: &Constants<'_, R>,
        work: &mut Work<R>,
    ) {
        assert_eq!(state.len(), self.border_and_own(), "length of the state");
        self.write_parameters(parameters, work);
        self.hand_over_inertias(constants.inertia, work);
        for (value, place) in work.state.iter_mut().zip(&self.border) {
            *value = state[*place as usize];
        }
        let (first, all) = (self.machine.coordinates, self.coordinates());
        for mesh in &self.meshes {
            let nodes = mesh.nodes();
            for run in &mesh.runs {
                let (into, from) = (nodes.start + run.nodes.start, first + run.own);
                let len = run.nodes.len();
                work.u[into..into + len].copy_from_slice(&state[from..from + len]);
                let from = from + all;
                work.v[into..into + len].copy_from_slice(&state[from..from + len]);
            }
            for port in &mesh.ports {
                let Owner::Port { coordinate, .. } = mesh.owners[*port] else { continue };
                work.u[nodes.start + port] = state[coordinate as usize];
                work.v[nodes.start + port] = state[coordinate as usize + all];
            }
        }
    }

    fn load_forces(&self, time: R, constants: &Constants<'_, R>, work: &mut Work<R>) {
        for (index, mesh) in self.meshes.iter().enumerate() {
            match &self.laws[index] {
                Law::Section(section) => section.force(self.scene(), time, (mesh, constants), work),
                Law::Chain(chain) => chain.force(self.scene(), time, (mesh, constants), work),
                Law::Any { .. } => {
                    let nodes = mesh.nodes();
                    let elements = mesh.elements(index, constants.bounds(mesh.bounds(index)));
                    let motion = (&work.u[nodes.clone()], &work.v[nodes.clone()]);
                    elements.force(self.scene(), (time, &work.p), motion, &mut work.force[nodes]);
                }
            }
        }
        for (node, handed) in self.ports.iter().copied() {
            work.p[handed + 1] = work.force[node];
        }
    }
}
