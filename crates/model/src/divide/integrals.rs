//! Forces, energies and powers of a machine with its divided fields.

use crate::{FieldModel, Tape};

use super::{Builder, Loaded, NodeId, Op, Owner, Whole};

impl Whole<'_> {
    /// Returns the forcing of the machine, then F at the own nodes of fields.
    pub(super) fn forcing(&self) -> Tape {
        let mut builder = Builder::default();
        let fields = self.load(&mut builder);
        let handed = self.hand_over(&mut builder, &fields, false);
        let mut results = self.inline(&mut builder, &self.model.forcing, &handed);
        results.extend(self.own().map(|(field, node, _)| fields[field].force[node]));
        builder.tape(&results)
    }

    /// Returns kinetic, potential and stored energy.
    pub(super) fn energy(&self) -> Tape {
        let mut builder = Builder::default();
        let fields = self.load(&mut builder);
        let handed = self.hand_over(&mut builder, &fields, false);
        let mut energy = self.inline(&mut builder, &self.model.energy, &handed);
        for (field, density) in self.integrals(&mut builder, &fields, |field| &field.energy) {
            energy[0] = builder.add(energy[0], density[0]);
            energy[1] = builder.add(energy[1], density[1]);
            // The machine counts the inertia of the nodes at its ports, too.
            for (velocity, loaded) in self.ports(&mut builder, field, &fields[field]) {
                let square = builder.multiply(velocity, velocity);
                let twice = builder.multiply(loaded.0, square);
                let counted = builder.scale(twice, -0.5);
                energy[0] = builder.add(energy[0], counted);
            }
        }
        builder.tape(&energy)
    }

    /// Returns the rate of the stored energy, power supplied and power dissipated.
    pub(super) fn power_balance(&self) -> Tape {
        let mut builder = Builder::default();
        let fields = self.load(&mut builder);
        let handed = self.hand_over(&mut builder, &fields, false);
        let mut balance = self.inline(&mut builder, &self.model.power_balance, &handed);
        for (field, density) in self.integrals(&mut builder, &fields, |field| &field.power) {
            for (sum, density) in balance.iter_mut().zip(density) {
                *sum = builder.add(*sum, density);
            }
            // The machine counts the forces of fields on its nodes as supplied.
            for (velocity, loaded) in self.ports(&mut builder, field, &fields[field]) {
                let power = builder.multiply(velocity, loaded.1);
                let counted = builder.scale(power, -1.0);
                balance[1] = builder.add(balance[1], counted);
            }
        }
        // The rate of a node's kinetic energy is its force times its velocity.
        for (field, node, coordinate) in self.own() {
            let velocity = builder.put(Op::State((coordinate + self.all) as u32));
            let power = builder.multiply(velocity, fields[field].force[node]);
            balance[0] = builder.add(balance[0], power);
        }
        builder.tape(&balance)
    }

    /// Returns the integral of densities over each field.
    fn integrals(
        &self,
        builder: &mut Builder,
        fields: &[Loaded],
        density: impl Fn(&FieldModel) -> &Tape,
    ) -> Vec<(usize, Vec<NodeId>)> {
        let meshes = self.meshes.iter().zip(&self.model.fields).zip(fields).enumerate();
        let integrals = meshes.map(|(index, ((mesh, field), loaded))| {
            let mut sums: Vec<Option<NodeId>> = vec![None; density(field).results.len()];
            for element in loaded.elements.iter().flatten() {
                for (point, weight) in mesh.rule.weights.iter().enumerate() {
                    let state = self.point(builder, mesh, element, point);
                    let share = builder.scale(element.length, *weight);
                    let values = builder.at_point(density(field), state);
                    for (sum, value) in sums.iter_mut().zip(values) {
                        let part = builder.multiply(share, value);
                        *sum = Some(sum.map_or(part, |sum| builder.add(sum, part)));
                    }
                }
            }
            let zero = builder.literal(0.0);
            (index, sums.into_iter().map(|sum| sum.unwrap_or(zero)).collect())
        });
        integrals.collect()
    }

    /// Returns velocity, and inertia and force of the field, at each node of a field that belongs
    /// to the machine.
    fn ports(
        &self,
        builder: &mut Builder,
        field: usize,
        loaded: &Loaded,
    ) -> Vec<(NodeId, (NodeId, NodeId))> {
        let nodes = self.meshes[field].owners.iter().enumerate();
        let ports = nodes.filter_map(|(node, owner)| match owner {
            Owner::Port(coordinate) => {
                let velocity = builder.put(Op::State((coordinate + self.all) as u32));
                Some((velocity, (loaded.inertia[node], loaded.force[node])))
            }
            _ => None,
        });
        ports.collect()
    }
}
