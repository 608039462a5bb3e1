//! What an expression costs.

use machinist_model::Op;

use super::{Expr, Graph};

/// Operations of the tape of one expression.
#[must_use]
pub fn operations(expr: &Expr) -> usize {
    weigh(expr).0
}

/// Operations of the tape of one expression, and the time that they take in that of a sum,
/// roughly.
#[must_use]
pub fn weigh(expr: &Expr) -> (usize, u32) {
    let mut graph = Graph::new();
    let root = graph.lower(expr);
    let ops = graph.tape(&[root]).nodes.into_iter().map(|node| node.op);
    let ops = ops.filter(Op::is_arithmetic);
    ops.fold((0, 0), |(count, time), op| (count + 1, time + op.cost()))
}
