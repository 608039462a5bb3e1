//! Nodes of a tape that results need, and dependences of nodes.

use machinist_contract::field::HANDED;

use crate::{Node, NodeId, Op, Tape};

/// Returns the part of `nodes` that `results` reach, renumbered, in order.
#[must_use]
pub fn reachable(nodes: &[Node], results: &[NodeId]) -> Tape {
    reachable_at(nodes, results).0
}

/// Returns the same, with the index in `nodes` of each of its nodes.
#[must_use]
pub fn reachable_at(nodes: &[Node], results: &[NodeId]) -> (Tape, Vec<NodeId>) {
    let mut needed = vec![false; nodes.len()];
    for result in results {
        needed[result.0 as usize] = true;
    }
    // A node refers only to earlier ones, so one backward pass reaches all.
    for index in (0..nodes.len()).rev() {
        if needed[index] {
            for operand in nodes[index].op.operands() {
                needed[operand.0 as usize] = true;
            }
        }
    }
    let mut place = vec![NodeId(0); nodes.len()];
    let mut tape = Tape::default();
    let mut originals = Vec::new();
    for (index, node) in nodes.iter().enumerate().filter(|(index, _)| needed[*index]) {
        place[index] = NodeId(tape.nodes.len() as u32);
        originals.push(NodeId(index as u32));
        let op = node.op.with_operands(|id| place[id.0 as usize]);
        tape.nodes.push(Node { op, name: node.name.clone() });
    }
    tape.results = results.iter().map(|result| place[result.0 as usize]).collect();
    (tape, originals)
}

/// Counts the operations with a cost at run time, among the nodes that results need.
#[must_use]
pub fn operations(tape: &Tape) -> usize {
    let needed = needed_nodes(tape);
    let nodes = tape.nodes.iter().zip(needed);
    nodes.filter(|(node, needed)| *needed && node.op.is_arithmetic()).count()
}

/// Returns for each node whether a result depends on it.
#[must_use]
pub fn needed_nodes(tape: &Tape) -> Vec<bool> {
    let mut needed = vec![false; tape.nodes.len()];
    for &NodeId(result) in &tape.results {
        if let Some(flag) = needed.get_mut(result as usize) {
            *flag = true;
        }
    }
    for (index, node) in tape.nodes.iter().enumerate().rev() {
        if needed[index] {
            for NodeId(operand) in node.op.operands() {
                if let Some(flag) = needed.get_mut(operand as usize) {
                    *flag = true;
                }
            }
        }
    }
    needed
}

/// Returns whether a number that a field hands over is the inertia of its node, which depends on
/// parameters only.
fn is_inertia(number: u32) -> bool {
    (number as usize).is_multiple_of(HANDED)
}

/// For each node, whether it depends on time, and whether on the state.
#[derive(Debug, Clone)]
pub struct Dependence(Vec<(bool, bool)>);

impl Dependence {
    /// Analyses a tape. The values that fields hand over change with the state, except inertias.
    #[must_use]
    pub fn of(tape: &Tape) -> Self {
        let mut known: Vec<(bool, bool)> = Vec::with_capacity(tape.nodes.len());
        for node in &tape.nodes {
            known.push(match node.op {
                Op::Time => (true, false),
                // The motion is computed from the state. A slot is held from one segment to the
                // next.
                Op::State(_) | Op::Motion(_) | Op::Held(_) => (false, true),
                Op::Handed(number) => (false, !is_inertia(number)),
                ref op => op.operands().iter().fold((false, false), |(time, state), id| {
                    let of = known[id.0 as usize];
                    (time || of.0, state || of.1)
                }),
            });
        }
        Dependence(known)
    }

    /// Returns whether a node depends on time.
    #[must_use]
    pub fn on_time(&self, id: NodeId) -> bool {
        self.0[id.0 as usize].0
    }

    /// Returns whether a node depends on the state.
    #[must_use]
    pub fn on_state(&self, id: NodeId) -> bool {
        self.0[id.0 as usize].1
    }

    /// Returns whether a node depends on either.
    #[must_use]
    pub fn on_anything(&self, id: NodeId) -> bool {
        self.0[id.0 as usize] != (false, false)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_field_hands_over_changes_with_the_state_but_for_its_inertia() {
        let nodes =
            (0..2 * HANDED as u32).map(|number| Node { op: Op::Handed(number), name: None });
        let nodes: Vec<Node> = nodes.collect();
        let tape = reachable(&nodes, &[NodeId(0), NodeId(5)]);
        assert_eq!(tape.nodes, [nodes[0].clone(), nodes[5].clone()]);
        let dependence = Dependence::of(&Tape { nodes, results: vec![] });
        let on_state = (0..2 * HANDED as u32).map(|id| dependence.on_state(NodeId(id)));
        let expected = [false, true, true, true, false, true, true, true];
        assert_eq!(on_state.collect::<Vec<_>>(), expected);
    }
}
