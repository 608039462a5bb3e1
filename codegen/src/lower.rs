//! Linearized equations to one tape for each function.

pub(crate) mod graph;
mod program;
mod terms;

use crate::expr::Expr;

pub use graph::Graph;
pub use program::lower;

/// Operations of the tape of one expression.
#[must_use]
pub fn operations(expr: &Expr) -> usize {
    let mut graph = Graph::new();
    let root = graph.lower(expr);
    graph.tape(&[root]).nodes.iter().filter(|node| node.op.is_arithmetic()).count()
}

/// Time that the tape of one expression takes, in that of a sum, roughly.
#[must_use]
pub fn cost(expr: &Expr) -> u32 {
    let mut graph = Graph::new();
    let root = graph.lower(expr);
    graph.tape(&[root]).nodes.iter().map(|node| node.op.cost()).sum()
}
