//! Forces of redundant constraints, shared with the constraints from which they follow.
//!
//! The rows of G of redundant constraints are G_r = C G_k of those that are kept, so the motion
//! determines only l_k + C^T l_r = lambda_k. The forces of least sum of squares are
//!
//! ```text
//! (1 + C^T C) l_k = lambda_k,   l_r = C l_k,   C = G_r G_k^T (G_k G_k^T)^-1
//! ```

use machinist_algebra::expr::{Expr, Graph};
use machinist_model::NodeId;

use super::factor::{Factorization, factor};
use super::nonzeros::Nonzeros;
use crate::mechanics::lagrange::EquationsOfMotion;

/// Returns lambda, given -lambda without redundant constraints: shared, if the scene asks for that.
/// Only forces of constraints that share coordinates with redundant ones change.
pub fn shared(
    graph: &mut Graph,
    equations: &EquationsOfMotion,
    negative: &[NodeId],
    lower: impl Fn(&mut Graph, &Expr) -> NodeId,
) -> Vec<NodeId> {
    let mut forces: Vec<NodeId> = negative.iter().map(|node| graph.neg(*node)).collect();
    let system = &equations.system;
    let all = 0..system.constraints.len();
    let redundant: Vec<usize> =
        all.clone().filter(|row| system.constraints[*row].is_dropped).collect();
    if redundant.is_empty() || !system.shares_redundant {
        return forces;
    }
    let joined = joined(equations, &redundant);
    let kept: Vec<usize> =
        all.filter(|row| joined[*row] && system.constraints[*row].holds_always()).collect();
    let lines = |graph: &mut Graph, rows: &[usize]| -> Vec<Vec<NodeId>> {
        let line = |row: &usize| equations.constraints.matrix[*row].iter();
        rows.iter().map(|row| line(row).map(|entry| lower(graph, entry)).collect()).collect()
    };
    let (own, others) = (lines(graph, &kept), lines(graph, &redundant));
    let gram = symmetric(graph, &own);
    // Columns of C^T are solutions of G_k G_k^T c = G_k g_r.
    let rows: Vec<Vec<NodeId>> = others
        .iter()
        .map(|other| {
            let side: Vec<NodeId> = own.iter().map(|line| dot(graph, line, other)).collect();
            gram.solve(graph, &side)
        })
        .collect();
    let columns: Vec<Vec<NodeId>> =
        (0..kept.len()).map(|column| rows.iter().map(|row| row[column]).collect()).collect();
    let one = graph.literal(1.0);
    let mut matrix = products(graph, &columns);
    for index in 0..kept.len() {
        let sum = matrix.get(index, index).map_or(one, |entry| graph.add(one, entry));
        matrix.set(graph, (index, index), sum);
    }
    let side: Vec<NodeId> = kept.iter().map(|row| forces[*row]).collect();
    let count = kept.len();
    let shared = factor(graph, &matrix, count).solve(graph, &side);
    for (row, force) in kept.iter().zip(&shared) {
        forces[*row] = *force;
    }
    for (row, line) in redundant.iter().zip(&rows) {
        forces[*row] = dot(graph, line, &shared);
    }
    forces
}

/// Returns for each constraint whether coordinates join it with one of some, directly or by others.
fn joined(equations: &EquationsOfMotion, some: &[usize]) -> Vec<bool> {
    let constraints = &equations.constraints;
    let mut moved = vec![false; equations.forcing.len()];
    let mut joined = vec![false; constraints.len()];
    let mut open = some.to_vec();
    while let Some(row) = open.pop() {
        if std::mem::replace(&mut joined[row], true) {
            continue;
        }
        constraints.coordinates(row).for_each(|column| moved[column] = true);
        let others = (0..constraints.len()).filter(|row| !joined[*row]);
        open.extend(others.filter(|row| constraints.coordinates(*row).any(|of| moved[of])));
    }
    joined
}

fn symmetric(graph: &mut Graph, lines: &[Vec<NodeId>]) -> Factorization {
    let matrix = products(graph, lines);
    factor(graph, &matrix, lines.len())
}

/// Returns the products of all pairs of vectors.
fn products(graph: &mut Graph, lines: &[Vec<NodeId>]) -> Nonzeros {
    let mut matrix = Nonzeros::new(lines.len());
    for (i, one) in lines.iter().enumerate() {
        for (j, other) in lines.iter().enumerate().take(i + 1) {
            let entry = dot(graph, one, other);
            matrix.set(graph, (i, j), entry);
            matrix.set(graph, (j, i), entry);
        }
    }
    matrix
}

fn dot(graph: &mut Graph, one: &[NodeId], other: &[NodeId]) -> NodeId {
    let zero = graph.literal(0.0);
    one.iter().zip(other).fold(zero, |sum, (a, b)| {
        let part = graph.mul(*a, *b);
        graph.add(sum, part)
    })
}
