//! Dependencies of the results of tapes.

use std::collections::BTreeSet;

use machinist_model::{Model, NodeId, Op, Tape};

/// Time, states and parameters from which something is computed.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Reads {
    /// True if time is read.
    pub time: bool,
    /// Entries of the state that are read.
    pub states: BTreeSet<u32>,
    /// Parameters that are read.
    pub parameters: BTreeSet<u32>,
}

impl Reads {
    /// Returns the dependencies of one result of a model's tape.
    #[must_use]
    pub fn of(model: &Model, tape: &Tape, result: NodeId) -> Self {
        Self::of_results(model, tape, &[result])
    }

    /// Returns the dependencies of all results of a model's tape.
    #[must_use]
    pub fn of_all(model: &Model, tape: &Tape) -> Self {
        Self::of_results(model, tape, &tape.results)
    }

    /// Adds the dependencies of something else.
    pub fn extend(&mut self, other: &Self) {
        self.time |= other.time;
        self.states.extend(&other.states);
        self.parameters.extend(&other.parameters);
    }

    fn of_results(model: &Model, tape: &Tape, results: &[NodeId]) -> Self {
        let mut reads = Self::default();
        let mut of_motion = Vec::new();
        let mut seen = vec![false; tape.nodes.len()];
        let mut open: Vec<NodeId> = results.to_vec();
        while let Some(NodeId(node)) = open.pop() {
            if std::mem::replace(&mut seen[node as usize], true) {
                continue;
            }
            let op = tape.nodes[node as usize].op;
            match op {
                Op::Time => reads.time = true,
                Op::State(entry) => {
                    reads.states.insert(entry);
                }
                Op::Parameter(index) => {
                    reads.parameters.insert(index);
                }
                Op::Motion(result) => of_motion.push(result),
                _ => open.extend(op.operands()),
            }
        }
        if let (Some(motion), false) = (&model.motion, of_motion.is_empty()) {
            let results: Vec<NodeId> =
                of_motion.iter().map(|result| motion.tape.results[*result as usize]).collect();
            // The tape of the motion is evaluated first and reads no other.
            reads.extend(&Self::of_results(model, &motion.tape, &results));
        }
        reads
    }
}
