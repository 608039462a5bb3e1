//! Functions that are called once for several arguments, so that their chains of operations run
//! side by side, in vectors if the target has them.
//!
//! A batch contains all calls of a kind whose arguments need the same number of preceding
//! batches. Nodes that no argument needs come after the batches, so their values need not be kept
//! across calls.

use std::collections::BTreeMap;

use machinist_model::{Function, NodeId, Op, Tape, needed_nodes};

/// Kind of the functions called together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::emit) enum Kind {
    /// Sine and cosine, one or both.
    SinCos,
    /// Hyperbolic tangent.
    Tanh,
}

/// One argument, and the nodes of its results.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) struct Member {
    pub(in crate::emit) argument: NodeId,
    /// Results for sine and cosine, or for the tangent alone.
    pub(in crate::emit) results: [Option<NodeId>; 2],
}

/// One call.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) struct Batch {
    pub(in crate::emit) kind: Kind,
    pub(in crate::emit) members: Vec<Member>,
}

impl Batch {
    /// Iterates over the nodes it computes.
    pub(in crate::emit) fn results(&self) -> impl Iterator<Item = NodeId> {
        self.members.iter().flat_map(|member| member.results).flatten()
    }

    /// Reports whether one call for all is better than single calls.
    fn is_worth_it(&self) -> bool {
        match self.members.as_slice() {
            [] => false,
            [one] => one.results.iter().all(Option::is_some),
            _ => true,
        }
    }
}

/// Next element of a body.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::emit) enum Step {
    /// The node of this index.
    Node(usize),
    /// A call for several arguments.
    Batch(Batch),
}

/// Returns the needed nodes of a tape, in an order that groups calls.
pub(in crate::emit) fn steps(tape: &Tape) -> Vec<Step> {
    let needed = needed_nodes(tape);
    let mut steps = Vec::with_capacity(tape.nodes.len());
    let mut is_done: Vec<bool> = needed.iter().map(|needed| !needed).collect();
    for batch in batches(tape, &needed) {
        let arguments = batch.members.iter().map(|member| member.argument);
        for index in missing(tape, arguments, &is_done) {
            is_done[index] = true;
            steps.push(Step::Node(index));
        }
        batch.results().for_each(|id| is_done[id.0 as usize] = true);
        steps.push(Step::Batch(batch));
    }
    steps.extend((0..tape.nodes.len()).filter(|index| !is_done[*index]).map(Step::Node));
    steps
}

/// Returns all batches, each after those it needs.
fn batches(tape: &Tape, needed: &[bool]) -> Vec<Batch> {
    // Number of consecutive calls before a node is known.
    let mut depths: Vec<u32> = Vec::with_capacity(tape.nodes.len());
    let mut groups: BTreeMap<(u32, Kind), Vec<Member>> = BTreeMap::new();
    for (index, node) in tape.nodes.iter().enumerate() {
        let before = node.op.operands().iter().map(|id| depths[id.0 as usize]).max().unwrap_or(0);
        let Some((kind, which, argument)) = call(&node.op) else {
            depths.push(before);
            continue;
        };
        depths.push(before + 1);
        if !needed[index] {
            continue;
        }
        let members = groups.entry((before, kind)).or_default();
        let place = members.iter().position(|member| member.argument == argument);
        let place = place.unwrap_or_else(|| {
            members.push(Member { argument, results: [None; 2] });
            members.len() - 1
        });
        members[place].results[which] = Some(NodeId(index as u32));
    }
    let batches = groups.into_iter().map(|((_, kind), members)| Batch { kind, members });
    batches.filter(Batch::is_worth_it).collect()
}

/// Returns the kind of a call, the index of its result, and its argument.
fn call(op: &Op) -> Option<(Kind, usize, NodeId)> {
    match *op {
        Op::Call(Function::Sin, argument) => Some((Kind::SinCos, 0, argument)),
        Op::Call(Function::Cos, argument) => Some((Kind::SinCos, 1, argument)),
        Op::Call(Function::Tanh, argument) => Some((Kind::Tanh, 0, argument)),
        _ => None,
    }
}

/// Returns the nodes not yet computed among these and those they need, in the order of the tape.
fn missing(tape: &Tape, nodes: impl Iterator<Item = NodeId>, is_done: &[bool]) -> Vec<usize> {
    let mut is_missing = vec![false; tape.nodes.len()];
    let mut open: Vec<NodeId> = nodes.collect();
    while let Some(id) = open.pop() {
        let index = id.0 as usize;
        if !is_done[index] && !is_missing[index] {
            is_missing[index] = true;
            open.extend(tape.nodes[index].op.operands());
        }
    }
    (0..is_missing.len()).filter(|index| is_missing[*index]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use machinist_model::Node;

    fn tape(ops: &[Op], results: &[u32]) -> Tape {
        let nodes = ops.iter().map(|&op| Node { op, name: None }).collect();
        Tape { nodes, results: results.iter().copied().map(NodeId).collect() }
    }

    fn call(function: Function, argument: u32) -> Op {
        Op::Call(function, NodeId(argument))
    }

    #[test]
    fn calls_that_need_no_other_come_together_and_before_what_they_do_not_need() {
        let ops = [
            Op::State(0),
            call(Function::Sin, 0),
            Op::State(1),
            Op::Mul(NodeId(2), NodeId(2)),
            call(Function::Cos, 2),
            call(Function::Sin, 4),
            Op::Add(NodeId(3), NodeId(5)),
            Op::Add(NodeId(1), NodeId(6)),
        ];
        let together = Batch {
            kind: Kind::SinCos,
            members: vec![
                Member { argument: NodeId(0), results: [Some(NodeId(1)), None] },
                Member { argument: NodeId(2), results: [None, Some(NodeId(4))] },
            ],
        };
        let [before, behind] = [[0, 2].as_slice(), &[3, 5, 6, 7]];
        let nodes = |nodes: &[usize]| nodes.iter().copied().map(Step::Node).collect::<Vec<_>>();
        let expected = [nodes(before), vec![Step::Batch(together)], nodes(behind)].concat();
        assert_eq!(steps(&tape(&ops, &[7])), expected);
    }

    #[test]
    fn one_call_alone_stays_where_it_is() {
        let ops = [Op::State(0), call(Function::Tanh, 0), call(Function::Sin, 1)];
        assert_eq!(steps(&tape(&ops, &[2])), (0..3).map(Step::Node).collect::<Vec<_>>());
    }
}
