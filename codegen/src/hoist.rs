//! What depends on parameters alone, computed once a run instead of at every rate; and, of
//! loops over many points, what depends on time and parameters alone, computed once for
//! all points.
//!
//! Excluded: what of a rate depends on time and parameters alone. A stage of a method has
//! a time of its own, so that is computed once a stage as it is.

use crate::emit::{needed_nodes, tape_operations};
use crate::program::Program;
use crate::prune::reachable;
use crate::scene::HANDED;
use crate::structure::Dependence;
use crate::tape::{Node, NodeId, Op, Tape};

/// Rate and Jacobian without what parameters alone decide.
#[derive(Debug, Clone, PartialEq)]
pub struct Hoisted {
    /// Of parameters only; its results are the constants.
    pub constants: Tape,
    /// y'. `Op::Parameter(PARAMETERS + k)` reads the k-th constant, here and below.
    pub rate: Tape,
    /// dy'/dy.
    pub rate_jacobian: Tape,
}

impl Hoisted {
    /// Takes the rate and the Jacobian of a program apart. Every operation is done
    /// on the same operands as before, so no result changes by a bit.
    #[must_use]
    pub fn new(program: &Program) -> Self {
        let fields = program.fields.iter().flat_map(|field| &field.field.attachments);
        let mut constants = Constants {
            tape: Tape::default(),
            of: Known::OnceARun { first: program.system.parameters.len() },
            // All that a field hands over but the inertia of its node.
            varying: fields.flat_map(|at| (1..HANDED as u32).map(|k| at.handed.0 + k)).collect(),
        };
        let rate = constants.hoist(&program.rate);
        let rate_jacobian = constants.hoist(&program.rate_jacobian.tape);
        Self { constants: constants.tape, rate, rate_jacobian }
    }

    /// Operations done once a run.
    #[must_use]
    pub fn operations(&self) -> usize {
        tape_operations(&self.constants)
    }
}

/// A tape in two: what no entry of the state decides, and what is left, which reads the
/// k-th result of the former as the entry `states + k` of the state. Every operation is
/// done on the same operands as before.
#[must_use]
pub fn apart_from_state(tape: &Tape, states: usize) -> (Tape, Tape) {
    let of = Known::OnceATime { first: states };
    let mut constants = Constants { tape: Tape::default(), of, varying: Vec::new() };
    let remaining = constants.hoist(tape);
    (constants.tape, remaining)
}

/// When constants are known, and where they begin among what tapes read.
#[derive(Debug, Clone, Copy)]
enum Known {
    /// From parameters alone; read as parameters.
    OnceARun { first: usize },
    /// From parameters and time; read as the state.
    OnceATime { first: usize },
}

/// The constants as they are found, those of several tapes shared.
struct Constants {
    tape: Tape,
    of: Known,
    /// Parameters that are another at every rate.
    varying: Vec<u32>,
}

impl Constants {
    /// The tape with constants in place of what is done once a run.
    fn hoist(&mut self, tape: &Tape) -> Tape {
        let dependence = Dependence::with_varying(tape, &self.varying);
        let needed = needed_nodes(tape);
        let is_constant: Vec<bool> = (0..tape.nodes.len())
            .map(|index| {
                let id = NodeId(index as u32);
                let varies = match self.of {
                    Known::OnceARun { .. } => dependence.on_anything(id),
                    Known::OnceATime { .. } => dependence.on_state(id),
                };
                tape.nodes[index].op.is_arithmetic() && !varies
            })
            .collect();
        // A constant is read if something at every evaluation asks for it.
        let mut is_read = vec![false; tape.nodes.len()];
        for (index, node) in tape.nodes.iter().enumerate() {
            if needed[index] && !is_constant[index] {
                node.op.operands().iter().for_each(|id| is_read[id.0 as usize] = true);
            }
        }
        tape.results.iter().for_each(|id| is_read[id.0 as usize] = true);
        let mut places = vec![NodeId(0); tape.nodes.len()];
        let mut remaining = Tape::default();
        for (index, node) in tape.nodes.iter().enumerate().filter(|(index, _)| needed[*index]) {
            let op = if !is_constant[index] {
                node.op.with_operands(|id| places[id.0 as usize])
            } else if is_read[index] {
                let constant = self.constant(tape, index);
                match self.of {
                    Known::OnceARun { first } => Op::Parameter((first + constant) as u32),
                    Known::OnceATime { first } => Op::State((first + constant) as u32),
                }
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

    /// Which constant the node of a tape is.
    fn constant(&mut self, tape: &Tape, index: usize) -> usize {
        let id = self.node(tape, index);
        self.tape.results.iter().position(|known| *known == id).unwrap_or_else(|| {
            self.tape.results.push(id);
            self.tape.results.len() - 1
        })
    }

    /// The node on the tape of constants, with all that it needs.
    fn node(&mut self, tape: &Tape, index: usize) -> NodeId {
        let op = tape.nodes[index].op.with_operands(|id| self.node(tape, id.0 as usize));
        let known = self.tape.nodes.iter().position(|known| is_same(known.op, op));
        let known = known.unwrap_or_else(|| {
            let name = tape.nodes[index].name.clone();
            let is_free = !self.tape.nodes.iter().any(|node| node.name == name);
            self.tape.nodes.push(Node { op, name: name.filter(|_| is_free) });
            self.tape.nodes.len() - 1
        });
        NodeId(known as u32)
    }
}

/// Whether two operations give the same bits.
fn is_same(a: Op, b: Op) -> bool {
    match (a, b) {
        (Op::Literal(a), Op::Literal(b)) => a.to_bits() == b.to_bits(),
        _ => a == b,
    }
}

#[cfg(test)]
mod tests {
    use super::{Constants, Known, apart_from_state, is_same};
    use crate::structure::Frequency;
    use crate::tape::{Node, NodeId, Op, Tape};

    fn tape(ops: &[Op], results: &[u32]) -> Tape {
        let nodes = ops.iter().map(|&op| Node { op, name: None }).collect();
        Tape { nodes, results: results.iter().copied().map(NodeId).collect() }
    }

    #[test]
    fn what_parameters_decide_is_done_once_and_shared_between_tapes() {
        let (p, product) = (Op::Parameter(0), |a, b| Op::Mul(NodeId(a), NodeId(b)));
        // p^2 y, then p^2 alone and its root.
        let first = tape(&[p, Op::State(0), product(0, 0), product(2, 1)], &[3]);
        let root = Op::Call(crate::expr::Function::Sqrt, NodeId(1));
        let second = tape(&[p, product(0, 0), root], &[1, 2]);
        let mut constants = Constants {
            tape: Tape::default(),
            of: Known::OnceARun { first: 1 },
            varying: Vec::new(),
        };
        let (first, second) = (constants.hoist(&first), constants.hoist(&second));
        assert_eq!(first, tape(&[Op::State(0), Op::Parameter(1), product(1, 0)], &[2]));
        // The parameter itself is read by nothing any more.
        assert_eq!(second, tape(&[Op::Parameter(1), Op::Parameter(2)], &[0, 1]));
        assert_eq!(constants.tape, tape(&[p, product(0, 0), root], &[1, 2]));
        assert_eq!(Frequency::of(&first), Frequency { once: 0, by_time: 0, by_state: 1 });
    }

    #[test]
    fn what_no_state_decides_is_told_apart() {
        let product = |a, b| Op::Mul(NodeId(a), NodeId(b));
        // (p t) y, p t being known before y is.
        let all =
            tape(&[Op::Parameter(0), Op::Time, product(0, 1), Op::State(0), product(2, 3)], &[4]);
        let (before, rest) = apart_from_state(&all, 5);
        assert_eq!(before, tape(&[Op::Parameter(0), Op::Time, product(0, 1)], &[2]));
        assert_eq!(rest, tape(&[Op::State(5), Op::State(0), product(0, 1)], &[2]));
    }

    #[test]
    fn zeros_of_either_sign_are_not_the_same() {
        assert!(is_same(Op::Literal(1.0), Op::Literal(1.0)));
        assert!(!is_same(Op::Literal(0.0), Op::Literal(-0.0)));
    }
}
