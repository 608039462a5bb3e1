//! Leaves out what the results do not need.

use crate::tape::{Node, NodeId, Op, Tape};

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
        let op = renumbered(node.op, &place);
        tape.nodes.push(Node { op, name: node.name.clone() });
    }
    tape.results = results.iter().map(|result| place[result.0 as usize]).collect();
    tape
}

fn renumbered(op: Op, place: &[NodeId]) -> Op {
    let at = |id: NodeId| place[id.0 as usize];
    match op {
        Op::Literal(_) | Op::Time | Op::State(_) | Op::Parameter(_) => op,
        Op::Neg(a) => Op::Neg(at(a)),
        Op::Add(a, b) => Op::Add(at(a), at(b)),
        Op::Sub(a, b) => Op::Sub(at(a), at(b)),
        Op::Mul(a, b) => Op::Mul(at(a), at(b)),
        Op::Div(a, b) => Op::Div(at(a), at(b)),
        Op::Powi(a, exponent) => Op::Powi(at(a), exponent),
        Op::Powf(a, b) => Op::Powf(at(a), at(b)),
        Op::Call(function, a) => Op::Call(function, at(a)),
        Op::SelectLess { lhs, rhs, then, otherwise } => {
            Op::SelectLess { lhs: at(lhs), rhs: at(rhs), then: at(then), otherwise: at(otherwise) }
        }
        Op::Table { table, order, argument } => Op::Table { table, order, argument: at(argument) },
    }
}
