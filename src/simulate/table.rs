//! Columns of a trajectory: states, outputs and the account of energy, row by row.

use machinist_contract::Simulator;

use crate::method::System;
use crate::trajectory::{Column, ColumnKind, EnergyBalance};

/// Columns of a trajectory while they are filled.
pub(super) struct Table<'a> {
    simulator: &'a dyn Simulator<f64>,
    states: Vec<Vec<f64>>,
    outputs: Vec<Vec<f64>>,
    energy: Vec<f64>,
    largest_active: f64,
    buffer: Vec<f64>,
}

impl<'a> Table<'a> {
    pub(super) fn new(simulator: &'a dyn Simulator<f64>, points: usize) -> Self {
        let shape = simulator.shape();
        let empty = |_| Vec::with_capacity(points);
        Self {
            simulator,
            states: (0..shape.states()).map(empty).collect(),
            outputs: (0..shape.outputs).map(empty).collect(),
            energy: empty(0),
            largest_active: 0.0,
            buffer: vec![0.0; shape.outputs],
        }
    }

    pub(super) fn push(&mut self, time: f64, row: &[f64], parameters: &[f64]) {
        let state = &row[..self.states.len()];
        for (column, value) in self.states.iter_mut().zip(state) {
            column.push(*value);
        }
        self.simulator.outputs(time, state, parameters, &mut self.buffer);
        for (column, value) in self.outputs.iter_mut().zip(&self.buffer) {
            column.push(*value);
        }
        let energy = self.simulator.energy(time, state, parameters);
        self.energy.push(energy.total());
        let active = energy.kinetic.abs() + energy.stored.abs();
        self.largest_active = self.largest_active.max(active);
    }

    /// Adds a note on outputs and energies that are NaN or infinite while the states are finite,
    /// such as the logarithm of a negative number.
    pub(super) fn note_not_finite(&self, system: &System<'_>, times: &[f64]) {
        let outputs = self.outputs.iter().enumerate();
        let outputs = outputs.map(|(index, values)| {
            (format!("output `{}`", self.simulator.output(index).name), values)
        });
        for (what, values) in outputs.chain([("the energy".to_owned(), &self.energy)]) {
            let count = values.iter().filter(|value| !value.is_finite()).count();
            let first = values.iter().zip(times).find(|(value, _)| !value.is_finite());
            if let Some((value, time)) = first {
                let of = times.len();
                system.note(format!(
                    "{what} is {value} at {time} s, and not a finite number at {count} of {of} times"
                ));
            }
        }
    }

    /// Computes the energy balance from rows of `width` whose last three entries are the
    /// quadratures.
    pub(super) fn energy_balance(
        &self,
        rows: &[f64],
        width: usize,
        energy_at_start: f64,
    ) -> EnergyBalance {
        let states = self.states.len();
        let quadrature = |flow: usize| {
            rows.chunks_exact(width).map(|row| row[states + flow]).collect::<Vec<_>>()
        };
        let (supplied, dissipated) = (quadrature(0), quadrature(1));
        let gained = |index: usize| self.energy[index] - energy_at_start;
        let residual = (0..self.energy.len())
            .map(|index| gained(index) - supplied[index] + dissipated[index])
            .collect();
        let passed = quadrature(2);
        EnergyBalance {
            supplied,
            dissipated,
            passed,
            residual,
            largest_active: self.largest_active,
        }
    }

    pub(super) fn into_columns(self, balance: Option<&EnergyBalance>) -> Vec<Column> {
        let simulator = self.simulator;
        let column = |kind, quantity: machinist_contract::Quantity<'_>, values| Column {
            name: quantity.name.to_owned(),
            unit: quantity.unit.to_owned(),
            kind,
            doc: quantity.doc.to_owned(),
            values,
        };
        let energy = |name: &str, doc: &str, values| Column {
            name: format!("energy.{name}"),
            unit: "J".to_owned(),
            kind: ColumnKind::Energy,
            doc: doc.to_owned(),
            values,
        };
        let states = self.states.into_iter().enumerate();
        let outputs = self.outputs.into_iter().enumerate();
        let mut columns: Vec<Column> =
            states
                .map(|(index, values)| column(ColumnKind::State, simulator.state(index), values))
                .chain(outputs.map(|(index, values)| {
                    column(ColumnKind::Output, simulator.output(index), values)
                }))
                .collect();
        columns.push(energy("total", "energy in motion, springs and fields", self.energy));
        if let Some(balance) = balance {
            columns.push(energy(
                "supplied",
                "energy supplied since start",
                balance.supplied.clone(),
            ));
            columns.push(energy(
                "dissipated",
                "energy lost since start",
                balance.dissipated.clone(),
            ));
            columns.push(energy("residual", "error of the account", balance.residual.clone()));
        }
        columns
    }
}
