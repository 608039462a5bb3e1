//! What an expression costs.

use machinist_model::Op;

use super::{Expr, Graph, Symbol};

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
    // What is solved for costs nothing here, and stands for itself: a guard may hold the size
    // of a constraint's force.
    let mut count = 0;
    expr.visit(&mut |part| match part {
        Expr::Symbol(Symbol::Acceleration(id)) => count = count.max(id.0 + 1),
        Expr::Symbol(Symbol::Multiplier(id)) => count = count.max(id.0 + 1),
        _ => {}
    });
    let solved: Vec<_> = (0..2 * count).map(|entry| graph.push(Op::Motion(entry))).collect();
    let (accelerations, multipliers) = solved.split_at(count as usize);
    graph.set_accelerations(accelerations.to_vec(), multipliers.to_vec());
    let root = graph.lower(expr);
    let ops = graph.tape(&[root]).nodes.into_iter().map(|node| node.op);
    let ops = ops.filter(Op::is_arithmetic);
    ops.fold((0, 0), |(count, time), op| (count + 1, time + op.cost()))
}
