//! Hoisting: values that depend on parameters only are computed once a run instead of at every
//! rate; in loops over many points, values that depend on time and parameters only are computed
//! once for all points.
//!
//! Excluded: parts of a rate that depend on time and parameters only. Every stage of a method has
//! its own time, so that they are computed once a stage anyway.

use std::collections::HashSet;

use rustc_hash::FxHashMap;

use crate::functions::FunctionId;
use crate::{
    Dependence, Model, Node, NodeId, Op, OpKey, Tape, needed_nodes, operations, reachable,
};

/// Rate and Jacobians without the operations that depend on parameters only.
#[derive(Debug, Clone, PartialEq)]
pub struct Hoisted {
    /// Tape of parameters only, whose results are the constants.
    pub constants: Tape,
    /// y', which reads constants, as the Jacobians do.
    pub rate: Tape,
    /// dy'/dy.
    pub rate_jacobian: Tape,
    /// dy'/dp.
    pub parameter_jacobian: Tape,
    /// Both Jacobians, entries of dy'/dp behind those of dy'/dy, with shared operations done once;
    /// empty unless [`Model::gives_jacobians_at_once`].
    pub jacobians: Tape,
    /// Tape that runs before dy'/dy and other functions; empty if there is none.
    pub motion: Tape,
}

impl Hoisted {
    /// Splits the rate and the Jacobians of a model. Every operation keeps its operands, so no
    /// result changes by a bit.
    #[must_use]
    pub fn new(model: &Model) -> Self {
        let mut constants = Constants::new(Known::OnceARun);
        let rate = constants.hoist(&model.rate);
        let rate_jacobian = constants.hoist(&model.rate_jacobian.tape);
        let motion = model.motion.as_ref().map(|motion| constants.hoist(&motion.tape));
        let motion = motion.unwrap_or_default();
        let parameter_jacobian = constants.hoist(&model.parameter_jacobian.tape);
        let jacobians = if model.gives_jacobians_at_once() {
            let both = [&model.rate_jacobian, &model.parameter_jacobian];
            constants.hoist(&at_once(both.map(|matrix| &matrix.tape)))
        } else {
            Tape::default()
        };
        let constants = constants.shared.tape;
        Self { constants, rate, rate_jacobian, parameter_jacobian, jacobians, motion }
    }

    /// Returns the tape of a function, without hoisted operations if the function has any.
    #[must_use]
    pub fn tape<'a>(&'a self, model: &'a Model, id: FunctionId) -> &'a Tape {
        match id {
            FunctionId::Rate => &self.rate,
            FunctionId::RateJacobian => &self.rate_jacobian,
            FunctionId::ParameterJacobian => &self.parameter_jacobian,
            id => model.tape(id),
        }
    }

    /// Returns the number of operations done once a run.
    #[must_use]
    pub fn operations(&self) -> usize {
        operations(&self.constants)
    }
}

/// Splits a tape into the operations that do not depend on the state, and the rest, for which the
/// results of the former are constants. Every operation keeps its operands.
#[must_use]
pub fn apart_from_state(tape: &Tape) -> (Tape, Tape) {
    let mut constants = Constants::new(Known::OnceATime);
    let remaining = constants.hoist(tape);
    (constants.shared.tape, remaining)
}

/// Returns one tape with the results of several in order, and every operation once.
fn at_once<const N: usize>(tapes: [&Tape; N]) -> Tape {
    let mut shared = Shared::default();
    let mut results = Vec::new();
    for tape in tapes {
        let places = shared.keep(tape, |_| true);
        results.extend(tape.results.iter().map(|id| places[id.0 as usize]));
    }
    Tape { results, ..shared.tape }
}

/// Inputs from which constants are computed.
#[derive(Debug, Clone, Copy)]
enum Known {
    /// Parameters, once a run.
    OnceARun,
    /// Parameters and time, once for each time.
    OnceATime,
}

/// Constants found so far, shared by several tapes.
struct Constants {
    shared: Shared,
    of: Known,
    /// Index of the constant of each node of the shared tape.
    places: FxHashMap<NodeId, u32>,
}

/// Nodes of several tapes on one tape, each operation once.
#[derive(Default)]
struct Shared {
    tape: Tape,
    /// Nodes by their operation.
    known: FxHashMap<OpKey, NodeId>,
    /// Names in use.
    names: HashSet<String>,
}

impl Constants {
    fn new(of: Known) -> Self {
        Self { shared: Shared::default(), of, places: FxHashMap::default() }
    }

    /// Returns the tape with constants in place of hoisted operations.
    fn hoist(&mut self, tape: &Tape) -> Tape {
        let dependence = Dependence::of(tape);
        let needed = needed_nodes(tape);
        let is_constant: Vec<bool> = (0..tape.nodes.len())
            .map(|index| {
                let id = NodeId(index as u32);
                let varies = match self.of {
                    Known::OnceARun => dependence.on_anything(id),
                    Known::OnceATime => dependence.on_state(id),
                };
                tape.nodes[index].op.is_arithmetic() && !varies
            })
            .collect();
        // A constant is needed if an operation that is not hoisted reads it.
        let mut is_read = vec![false; tape.nodes.len()];
        for (index, node) in tape.nodes.iter().enumerate() {
            if needed[index] && !is_constant[index] {
                node.op.operands().iter().for_each(|id| is_read[id.0 as usize] = true);
            }
        }
        tape.results.iter().for_each(|id| is_read[id.0 as usize] = true);
        let moved =
            self.shared.keep(tape, |index| is_constant[index] && is_read[index] && needed[index]);
        let mut places = vec![NodeId(0); tape.nodes.len()];
        let mut remaining = Tape::default();
        for (index, node) in tape.nodes.iter().enumerate().filter(|(index, _)| needed[*index]) {
            let op = if !is_constant[index] {
                node.op.with_operands(|id| places[id.0 as usize])
            } else if is_read[index] {
                Op::Constant(self.place(moved[index]))
            } else {
                continue;
            };
            let name = if is_constant[index] { None } else { node.name.clone() };
            places[index] = NodeId(remaining.nodes.len() as u32);
            remaining.nodes.push(Node { op, name });
        }
        let results: Vec<NodeId> = tape.results.iter().map(|id| places[id.0 as usize]).collect();
        reachable(&remaining.nodes, &results)
    }

    /// Returns the index of the constant for a node of the shared tape.
    fn place(&mut self, id: NodeId) -> u32 {
        let next = self.shared.tape.results.len() as u32;
        let place = *self.places.entry(id).or_insert(next);
        if place == next {
            self.shared.tape.results.push(id);
        }
        place
    }
}

impl Shared {
    /// Adds nodes of a tape with all that they need, and returns their new ids.
    fn keep(&mut self, tape: &Tape, is_read: impl Fn(usize) -> bool) -> Vec<NodeId> {
        let mut wanted: Vec<bool> = (0..tape.nodes.len()).map(is_read).collect();
        for index in (0..tape.nodes.len()).rev() {
            if wanted[index] {
                for operand in tape.nodes[index].op.operands() {
                    wanted[operand.0 as usize] = true;
                }
            }
        }
        let mut moved = vec![NodeId(0); tape.nodes.len()];
        for (index, node) in tape.nodes.iter().enumerate().filter(|(index, _)| wanted[*index]) {
            let op = node.op.with_operands(|id| moved[id.0 as usize]);
            moved[index] = self.node(op, node.name.as_deref());
        }
        moved
    }

    /// Returns the node of an operation.
    fn node(&mut self, op: Op, name: Option<&str>) -> NodeId {
        let next = NodeId(self.tape.nodes.len() as u32);
        let id = *self.known.entry(op.key()).or_insert(next);
        if id == next {
            let name = name.filter(|name| self.names.insert((*name).to_owned()));
            self.tape.nodes.push(Node { op, name: name.map(str::to_owned) });
        }
        id
    }
}

#[cfg(test)]
mod tests {
    use super::{Constants, Known, apart_from_state};
    use crate::{Function, Node, NodeId, Op, Tape};

    fn tape(ops: &[Op], results: &[u32]) -> Tape {
        let nodes = ops.iter().map(|&op| Node { op, name: None }).collect();
        Tape { nodes, results: results.iter().copied().map(NodeId).collect() }
    }

    #[test]
    fn what_parameters_decide_is_done_once_and_shared_between_tapes() {
        let (p, product) = (Op::Parameter(0), |a, b| Op::Mul(NodeId(a), NodeId(b)));
        // p^2 y, then p^2 alone and its root.
        let first = tape(&[p, Op::State(0), product(0, 0), product(2, 1)], &[3]);
        let root = Op::Call(Function::Sqrt, NodeId(1));
        let second = tape(&[p, product(0, 0), root], &[1, 2]);
        let mut constants = Constants::new(Known::OnceARun);
        let (first, second) = (constants.hoist(&first), constants.hoist(&second));
        assert_eq!(first, tape(&[Op::State(0), Op::Constant(0), product(1, 0)], &[2]));
        // No operation reads the parameter itself any more.
        assert_eq!(second, tape(&[Op::Constant(0), Op::Constant(1)], &[0, 1]));
        assert_eq!(constants.shared.tape, tape(&[p, product(0, 0), root], &[1, 2]));
    }

    #[test]
    fn what_no_state_decides_is_told_apart() {
        let product = |a, b| Op::Mul(NodeId(a), NodeId(b));
        // (p t) y, where p t is known before y.
        let all =
            tape(&[Op::Parameter(0), Op::Time, product(0, 1), Op::State(0), product(2, 3)], &[4]);
        let (before, rest) = apart_from_state(&all);
        assert_eq!(before, tape(&[Op::Parameter(0), Op::Time, product(0, 1)], &[2]));
        assert_eq!(rest, tape(&[Op::Constant(0), Op::State(0), product(0, 1)], &[2]));
    }
}
