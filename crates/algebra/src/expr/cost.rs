//! Costs of expressions.

use machinist_model::Op;

use super::{ConstraintId, Expr, Graph, Symbol};

/// Returns the number of operations of the tape of one expression.
#[must_use]
pub fn operations(expr: &Expr) -> usize {
    weigh(expr).0
}

/// Returns the number of operations of the tape of one expression, and their approximate cost
/// relative to an addition.
#[must_use]
pub fn weigh(expr: &Expr) -> (usize, u32) {
    let mut graph = Graph::new();
    // Unknowns of the equations of motion cost nothing here and are represented by themselves: a
    // guard may contain the magnitude of a constraint force.
    let (mut count, mut shared) = (0, Vec::new());
    expr.visit(&mut |part| match part {
        Expr::Symbol(Symbol::Acceleration(id)) => count = count.max(id.0 + 1),
        Expr::Symbol(Symbol::Multiplier(id) | Symbol::Unloaded(id)) => count = count.max(id.0 + 1),
        Expr::Shared(part) => shared.push(part.digest()),
        _ => {}
    });
    let unknowns = 2 * count + shared.len() as u32;
    let solved: Vec<_> = (0..unknowns).map(|entry| graph.push(Op::Motion(entry))).collect();
    // Shared parts cost the same in every form of the expression, so they are unknowns too.
    graph.shared.extend(shared.into_iter().zip(solved[2 * count as usize..].iter().copied()));
    let (accelerations, multipliers) = solved[..2 * count as usize].split_at(count as usize);
    graph.set_accelerations(accelerations.to_vec(), multipliers.to_vec());
    graph.set_unloaded((0..count).map(ConstraintId).zip(multipliers.iter().copied()));
    let root = graph.lower(expr);
    let ops = graph.tape(&[root]).nodes.into_iter().map(|node| node.op);
    let ops = ops.filter(Op::is_arithmetic);
    ops.fold((0, 0), |(count, time), op| (count + 1, time + op.cost()))
}
