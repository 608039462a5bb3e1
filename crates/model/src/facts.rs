//! Facts that the tapes of a model imply for every state: values that depend on parameters only.

use crate::evaluate::{Evaluator, Inputs, call};
use crate::{Event, Function, Model, NodeId, Op, Requirement, StateKind, Tape, What, needed_nodes};

impl Model {
    /// Returns the first requirement that the given parameters do not fulfil, with its value.
    ///
    /// # Panics
    /// If `parameters` is shorter than the parameters of the model.
    #[must_use]
    pub fn unfulfilled(&self, parameters: &[f64]) -> Option<(&Requirement, f64)> {
        if self.requirements.is_empty() {
            return None;
        }
        let mut values = vec![0.0; self.requirements.len()];
        let inputs = Inputs { parameters, tables: &self.tables, ..Inputs::default() };
        Evaluator::new(&self.required).evaluate(&inputs, &mut values);
        let mut values = self.requirements.iter().zip(values);
        values.find(|(requirement, value)| !requirement.bound.admits(*value))
    }

    /// Returns true if the spec has a parameter of this name that was left out because nothing
    /// depends on it.
    #[must_use]
    pub fn is_unused(&self, parameter: &str) -> bool {
        let mut left_out = self.reduction.left_out.iter();
        left_out.any(|one| one.what == What::Parameter && one.name == parameter)
    }

    /// Returns true if no power is supplied or dissipated at any state and time with these
    /// parameters: both are zero by the structure of their tape, after factors that these
    /// parameters make zero. Returns `None` for a machine with fields, because their densities are
    /// not analysed.
    #[must_use]
    pub fn conserves_energy(&self, parameters: &[f64]) -> Option<bool> {
        let tape = &self.power_balance;
        let [_, supplied, dissipated] = tape.results[..] else { return None };
        if !self.fields.is_empty() {
            return None;
        }
        let known = known(tape, parameters);
        let is_zero = |node: NodeId| known[node.0 as usize] == Some(0.0);
        Some(is_zero(supplied) && is_zero(dissipated))
    }

    /// Returns true if the kinetic energy reads a table, or a comparison that steps do not hold:
    /// velocities may jump where these have corners, although no relation changes.
    #[must_use]
    pub fn inertia_has_corners(&self) -> bool {
        let kinetic = Tape {
            nodes: self.energy.nodes.clone(),
            results: self.energy.results.iter().take(1).copied().collect(),
        };
        let motion = self.motion.iter().map(|motion| &motion.tape);
        motion.chain([&kinetic, &self.mass_matrix.tape]).any(|tape| {
            let is_held = |id: NodeId| {
                let op = tape[id].op;
                matches!(op, Op::Held(_)) || tape.shifted(op).is_some()
            };
            let mut nodes = tape.nodes.iter().zip(needed_nodes(tape));
            nodes.any(|(node, is_needed)| {
                let has_corners = match node.op {
                    Op::Table { .. } | Op::Call(Function::Abs | Function::Floor, _) => true,
                    Op::SelectLess { lhs, .. } => !is_held(lhs),
                    _ => false,
                };
                is_needed && has_corners
            })
        })
    }

    /// Returns for each event whether it only counts: between events the entries that it sets are
    /// constant, and neither the motion, its energy, a guard nor the `when` of an event reads them.
    #[must_use]
    pub fn counters(&self) -> Vec<bool> {
        let motion = self.motion.iter().map(|motion| &motion.tape);
        let of_events = [&self.guards, &self.guard_rates, &self.kink_guards, &self.kink_rates];
        let of_constraints =
            [&self.constraint_values, &self.constraint_rates, &self.constraint_matrix.tape];
        let of_motion = [&self.rate, &self.mass_matrix.tape, &self.forcing];
        let of_energy = [&self.energy, &self.power_balance];
        let tapes = motion.chain(of_events).chain(of_constraints).chain(of_motion).chain(of_energy);
        let mut is_read = vec![false; self.states.len()];
        for tape in tapes {
            let nodes = tape.nodes.iter().zip(needed_nodes(tape));
            for (node, _) in nodes.filter(|(_, is_needed)| *is_needed) {
                if let Op::State(entry) = node.op {
                    is_read[entry as usize] = true;
                }
            }
        }
        for (entry, _) in self.events.iter().flat_map(|event| &event.when) {
            is_read[*entry as usize] = true;
        }
        let rate = |entry: u32| self.rate.nodes[self.rate.results[entry as usize].0 as usize].op;
        let is_constant = |entry: &u32| matches!(rate(*entry), Op::Literal(0.0));
        let counts = |entry: &u32| !is_read[*entry as usize] && is_constant(entry);
        self.events.iter().map(|event| event.sets.iter().all(counts)).collect()
    }

    /// Returns for each event whether its guard or the rate of its guard reads a state, other than a
    /// mode, that it sets.
    #[must_use]
    pub fn events_that_move_their_guard(&self) -> Vec<bool> {
        let moves = |(index, event): (usize, &Event)| {
            let is_set = |entry: &u32| {
                let is_mode = self.states[*entry as usize].kind == StateKind::Mode;
                !is_mode && event.sets.contains(entry)
            };
            let mut tapes = [&self.guards, &self.guard_rates].into_iter();
            event.sets.iter().any(is_set)
                && tapes.any(|tape| self.reads(tape, tape.results[index], &is_set))
        };
        self.events.iter().enumerate().map(moves).collect()
    }

    /// Returns whether a node of a tape depends on one of some states. What fields hand over depends
    /// on all.
    fn reads(&self, tape: &Tape, node: NodeId, is_one: &impl Fn(&u32) -> bool) -> bool {
        let last = node.0 as usize;
        let mut is_reached = vec![false; last + 1];
        is_reached[last] = true;
        for index in (0..=last).rev() {
            if !is_reached[index] {
                continue;
            }
            let op = tape.nodes[index].op;
            let reads = match (op, &self.motion) {
                (Op::State(entry), _) => is_one(&entry),
                (Op::Handed(_), _) => true,
                (Op::Motion(result), Some(motion)) => {
                    self.reads(&motion.tape, motion.tape.results[result as usize], is_one)
                }
                _ => false,
            };
            if reads {
                return true;
            }
            op.operands().iter().for_each(|operand| is_reached[operand.0 as usize] = true);
        }
        false
    }
}

/// Returns the value of each node that depends on parameters only; a product with zero is zero.
fn known(tape: &Tape, parameters: &[f64]) -> Vec<Option<f64>> {
    let mut known: Vec<Option<f64>> = Vec::with_capacity(tape.nodes.len());
    for node in &tape.nodes {
        let of = |id: NodeId| known[id.0 as usize];
        let is_zero = |id| of(id) == Some(0.0);
        let value = match node.op {
            Op::Literal(value) => Some(value),
            Op::Parameter(index) => parameters.get(index as usize).copied(),
            Op::Time
            | Op::State(_)
            | Op::Handed(_)
            | Op::Held(_)
            | Op::Constant(_)
            | Op::Motion(_)
            | Op::Table { .. } => None,
            Op::Neg(a) => of(a).map(|a| -a),
            Op::Add(a, b) => of(a).zip(of(b)).map(|(a, b)| a + b),
            Op::Sub(a, b) if a == b => Some(0.0),
            Op::Sub(a, b) => of(a).zip(of(b)).map(|(a, b)| a - b),
            Op::Mul(a, b) if is_zero(a) || is_zero(b) => Some(0.0),
            Op::Mul(a, b) => of(a).zip(of(b)).map(|(a, b)| a * b),
            Op::Div(a, _) if is_zero(a) => Some(0.0),
            Op::Div(a, b) => of(a).zip(of(b)).map(|(a, b)| a / b),
            Op::Powi(a, exponent) => of(a).map(|a| a.powi(exponent)),
            Op::Powf(a, b) => of(a).zip(of(b)).map(|(a, b)| a.powf(b)),
            Op::Call(function, a) => of(a).map(|a| call(function, a)),
            Op::SelectLess { lhs, rhs, then, otherwise } => match (of(lhs), of(rhs)) {
                (Some(lhs), Some(rhs)) => of(if lhs < rhs { then } else { otherwise }),
                _ => of(then).filter(|value| of(otherwise) == Some(*value)),
            },
        };
        known.push(value);
    }
    known
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Bound, Node};

    fn tape(ops: &[Op], results: &[u32]) -> Tape {
        let nodes = ops.iter().map(|op| Node { op: *op, name: None }).collect();
        Tape { nodes, results: results.iter().copied().map(NodeId).collect() }
    }

    /// Losses p0 v |v|, selected by a comparison of the state; no power supplied.
    fn lossy() -> Model {
        let [zero, speed, drag, size, share, loss, chosen] = [0, 1, 2, 3, 4, 5, 6].map(NodeId);
        let ops = [
            Op::Literal(0.0),
            Op::State(1),
            Op::Parameter(0),
            Op::Call(Function::Abs, speed),
            Op::Mul(drag, size),
            Op::Mul(share, speed),
            Op::SelectLess { lhs: zero, rhs: speed, then: loss, otherwise: zero },
        ];
        Model { power_balance: tape(&ops, &[0, zero.0, chosen.0]), ..Model::default() }
    }

    #[test]
    fn losses_behind_a_comparison_are_losses_wherever_the_state_is() {
        assert_eq!(lossy().conserves_energy(&[0.5]), Some(false));
        assert_eq!(lossy().conserves_energy(&[1e-300]), Some(false));
    }

    #[test]
    fn a_parameter_of_zero_takes_losses_away() {
        assert_eq!(lossy().conserves_energy(&[0.0]), Some(true));
        assert_eq!(lossy().conserves_energy(&[-0.0]), Some(true));
    }

    #[test]
    fn what_is_supplied_counts_as_well() {
        let ops = [Op::Literal(0.0), Op::Time];
        let model = Model { power_balance: tape(&ops, &[0, 1, 0]), ..Model::default() };
        assert_eq!(model.conserves_energy(&[]), Some(false));
    }

    #[test]
    fn the_first_requirement_that_fails_is_found_with_its_value() {
        let one = |bound| Requirement { rule: format!("{bound:?}"), bound };
        let model = Model {
            requirements: vec![one(Bound::NotZero), one(Bound::Positive)],
            required: tape(&[Op::Parameter(0), Op::Parameter(1)], &[0, 1]),
            ..Model::default()
        };
        let failed = |parameters: &[f64]| {
            model.unfulfilled(parameters).map(|(requirement, value)| (requirement.bound, value))
        };
        assert_eq!(failed(&[-1.0, 2.0]), None);
        assert_eq!(failed(&[0.0, -2.0]), Some((Bound::NotZero, 0.0)));
        assert_eq!(failed(&[1.0, -2.0]), Some((Bound::Positive, -2.0)));
        assert_eq!(failed(&[f64::INFINITY, 1.0]), Some((Bound::NotZero, f64::INFINITY)));
    }
}
