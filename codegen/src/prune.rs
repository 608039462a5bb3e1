//! Leaves out what the results do not need.

use crate::tape::{Node, NodeId, Tape};

/// The part of `nodes` that `results` reach, renumbered, in order.
#[must_use]
pub fn reachable(nodes: &[Node], results: &[NodeId]) -> Tape {
    let mut needed = vec![false; nodes.len()];
    for result in results {
        needed[result.0 as usize] = true;
    }
    // A node refers only to earlier ones, so one pass backwards reaches all.
    for index in (0..nodes.len()).rev() {
        if needed[index] {
            for operand in nodes[index].op.operands() {
                needed[operand.0 as usize] = true;
            }
        }
    }
    let mut place = vec![NodeId(0); nodes.len()];
    let mut tape = Tape::default();
    for (index, node) in nodes.iter().enumerate().filter(|(index, _)| needed[*index]) {
        place[index] = NodeId(tape.nodes.len() as u32);
        let op = node.op.with_operands(|id| place[id.0 as usize]);
        tape.nodes.push(Node { op, name: node.name.clone() });
    }
    tape.results = results.iter().map(|result| place[result.0 as usize]).collect();
    tape
}
