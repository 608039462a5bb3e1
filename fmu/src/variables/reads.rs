//! What results of tapes depend on.

use std::collections::BTreeSet;

use machinist_model::{Model, NodeId, Op, Tape};

/// What something is computed from.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Reads {
    /// Whether time is.
    pub time: bool,
    /// Entries of the state.
    pub states: BTreeSet<u32>,
    /// Parameters.
    pub parameters: BTreeSet<u32>,
}

impl Reads {
    /// Of one result of a model's tape.
    #[must_use]
    pub fn of(model: &Model, tape: &Tape, result: NodeId) -> Self {
        Self::of_results(model, tape, &[result])
    }

    /// Of all results of a model's tape.
    #[must_use]
    pub fn of_all(model: &Model, tape: &Tape) -> Self {
        Self::of_results(model, tape, &tape.results)
    }

    /// Adds what something else is computed from.
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
            // The motion's tape goes before others and reads none.
            reads.extend(&Self::of_results(model, &motion.tape, &results));
        }
        reads
    }
}
