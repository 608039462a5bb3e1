//! Jacobians of a rate by automatic differentiation: the tape of its [tangent](Model::tangent), with
//! a literal 1 for one direction and 0 for all others, so that zeros vanish.

use crate::{Directions, MatrixTape, Model, NodeId, Op, SparsityPattern, Tape};

use super::Builder;

impl Model {
    /// Sets dy'/dy, dy'/dp and the partial derivative of y' by time to those of the rate.
    pub(super) fn derive_rates(&mut self) {
        let (states, parameters) = (self.states.len(), self.parameters.len());
        let directions = Directions { along: (0..parameters as u32).collect() };
        let all: Vec<usize> = (0..states).collect();
        let tangent = self.tangent(&self.rate, &all, &directions);
        let by_states = (0..states).map(|entry| Op::State((states + entry) as u32));
        let by_parameters = (0..parameters).map(|entry| Op::Parameter((parameters + entry) as u32));
        let by_time = Op::Parameter(2 * parameters as u32);
        let partials = |inputs: &[Op]| Partials::of(&tangent, (states, parameters), inputs);
        self.rate_jacobian = partials(&by_states.collect::<Vec<_>>()).matrix(states);
        self.parameter_jacobian = partials(&by_parameters.collect::<Vec<_>>()).matrix(states);
        self.time_derivative = partials(&[by_time]).column();
    }
}

/// Partial derivatives of the results of a tape.
struct Partials {
    builder: Builder,
    /// Derivatives of all results by one input after the other.
    columns: Vec<Vec<NodeId>>,
}

impl Partials {
    /// Evaluates a tangent, of a machine with these numbers of states and parameters, for a unit of
    /// each of some directions.
    fn of(tangent: &Tape, (states, parameters): (usize, usize), inputs: &[Op]) -> Self {
        let is_direction = |op: Op| match op {
            Op::State(entry) => entry as usize >= states,
            Op::Parameter(entry) => entry as usize >= parameters,
            _ => false,
        };
        let mut builder = Builder::default();
        let zero = builder.literal(0.0);
        // Places of nodes that are the same for all directions, and indices of the others.
        let mut values: Vec<NodeId> = Vec::with_capacity(tangent.nodes.len());
        let mut varies = vec![false; tangent.nodes.len()];
        let mut varying = Vec::new();
        for (index, node) in tangent.nodes.iter().enumerate() {
            let mut operands = node.op.operands().into_iter();
            varies[index] = is_direction(node.op) || operands.any(|id| varies[id.0 as usize]);
            let op = node.op.with_operands(|id| values[id.0 as usize]);
            let place = if varies[index] { zero } else { builder.put(op) };
            if varies[index] {
                varying.push((index, node.op.operands()));
            }
            values.push(place);
        }
        let one = builder.literal(1.0);
        let columns = inputs.iter().map(|input| {
            for (index, operands) in &varying {
                let op = tangent.nodes[*index].op;
                let mut directed = operands.iter().filter(|id| varies[id.0 as usize]);
                values[*index] = if operands.is_empty() {
                    if op == *input { one } else { zero }
                } else if directed.all(|id| builder.is_zero(values[id.0 as usize])) {
                    // Tangents are linear in their direction.
                    zero
                } else {
                    builder.folded(op.with_operands(|id| values[id.0 as usize]))
                };
            }
            tangent.results.iter().map(|id| values[id.0 as usize]).collect()
        });
        let columns = columns.collect();
        Self { builder, columns }
    }

    /// Returns the matrix of this number of rows, without zeros.
    fn matrix(self, rows: usize) -> MatrixTape {
        let (mut entries, mut results) = (Vec::new(), Vec::new());
        for row in 0..rows {
            for (column, values) in self.columns.iter().enumerate() {
                if !self.builder.is_zero(values[row]) {
                    entries.push((row as u32, column as u32));
                    results.push(values[row]);
                }
            }
        }
        let pattern = SparsityPattern { rows, columns: self.columns.len(), entries };
        MatrixTape { pattern, tape: self.builder.tape(&results), solve: None }
    }

    /// Returns the only column.
    fn column(self) -> Tape {
        self.builder.tape(&self.columns[0])
    }
}
