//! Factorization of the mass matrix on the tape: M = L D L^T without square roots, unrolled along
//! its nonzeros.
//!
//! Diagonal and block-diagonal matrices need no special case: structural zeros are folded, so a
//! diagonal matrix costs one reciprocal per row, and a block its own factorization.

use std::collections::BTreeSet;

use super::nonzeros::Nonzeros;
use machinist_algebra::expr::Graph;
use machinist_model::NodeId;

/// L (unit lower triangle) and 1/D.
pub struct Factorization {
    /// L without its diagonal.
    pub lower: Nonzeros,
    /// Rows in which each column of L has entries.
    pub below: Vec<Vec<usize>>,
    /// 1/D.
    pub inverse_diagonal: Vec<NodeId>,
}

/// Factors a symmetric matrix given by its nodes. It is positive definite in its first `free`
/// rows, and bordered by constraints.
///
/// A constraint that holds in some modes has an entry on the diagonal, and may be redundant to
/// those before it. Its pivot then vanishes, and 1/D is set to 0: its force is 0, and the others
/// are as without it.
pub fn factor(graph: &mut Graph, matrix: &Nonzeros, free: usize) -> Factorization {
    let n = matrix.len();
    let zero = graph.literal(0.0);
    let one = graph.literal(1.0);
    let mut lower = Nonzeros::new(n);
    // L_ij D_j
    let mut scaled = Nonzeros::new(n);
    let mut inverse_diagonal = Vec::with_capacity(n);
    let mut below: Vec<Vec<usize>> = vec![Vec::new(); n];
    for j in 0..n {
        let given = matrix.get(j, j);
        let may_repeat = j >= free && given.is_some();
        let mut diagonal = given.unwrap_or(zero);
        let filled: Vec<(usize, NodeId, NodeId)> = lower
            .row(j)
            .iter()
            .map(|(k, lower)| (*k, *lower, scaled.get(j, *k).unwrap_or(zero)))
            .collect();
        // The pivot without other constraints, if there are some to which it may be redundant.
        let mut alone = None;
        for &(k, lower, scaled) in &filled {
            if k >= free && may_repeat {
                alone = alone.or(Some(diagonal));
            }
            let part = graph.mul(lower, scaled);
            diagonal = graph.sub(diagonal, part);
        }
        let inverse = match alone {
            None if may_repeat && filled.is_empty() => inverse_of_empty(graph, diagonal),
            None => graph.div(one, diagonal),
            Some(alone) => inverse_if_any(graph, diagonal, alone),
        };
        inverse_diagonal.push(inverse);
        let given = matrix.row(j).keys().copied();
        let made = filled.iter().flat_map(|(k, ..)| below[*k].iter().copied());
        let rows: BTreeSet<usize> = given.chain(made).filter(|i| *i > j).collect();
        for i in rows {
            let mut entry = matrix.get(i, j).unwrap_or(zero);
            for &(k, _, scaled) in &filled {
                if let Some(lower) = lower.get(i, k) {
                    let part = graph.mul(lower, scaled);
                    entry = graph.sub(entry, part);
                }
            }
            if !graph.is_zero(entry) {
                scaled.set(graph, (i, j), entry);
                let part = graph.mul(entry, inverse);
                lower.set(graph, (i, j), part);
                below[j].push(i);
            }
        }
    }
    Factorization { lower, below, inverse_diagonal }
}

/// Returns 1/d of a negative pivot d; 0 if it is only the rounding error of its value alone.
fn inverse_if_any(graph: &mut Graph, pivot: NodeId, alone: NodeId) -> NodeId {
    /// Limit for the squared angle between two constraints, in the norm of M.
    const NOTHING: f64 = 1e-12;
    let (zero, one, nothing) = (graph.literal(0.0), graph.literal(1.0), graph.literal(NOTHING));
    let least = graph.mul(nothing, alone);
    let divisor = graph.select_less(least, pivot, one, pivot);
    let inverse = graph.div(one, divisor);
    graph.select_less(least, pivot, zero, inverse)
}

/// Returns 1/d of a constraint that contains only coordinates determined by others. Its pivot is
/// -1 while it does not hold, and 0 while it does; 0 is then used for 1/d.
fn inverse_of_empty(graph: &mut Graph, pivot: NodeId) -> NodeId {
    let (zero, one) = (graph.literal(0.0), graph.literal(1.0));
    let divisor = graph.select_less(pivot, zero, pivot, one);
    let inverse = graph.div(one, divisor);
    graph.select_less(pivot, zero, inverse, zero)
}

impl Factorization {
    /// Iterates over the entries of L below the diagonal in a column, by row.
    pub fn column(&self, column: usize) -> impl Iterator<Item = (usize, NodeId)> {
        let rows = self.below[column].iter();
        rows.filter_map(move |row| Some((*row, self.lower.get(*row, column)?)))
    }

    /// Returns x with L D L^T x = b.
    pub fn solve(&self, graph: &mut Graph, right_side: &[NodeId]) -> Vec<NodeId> {
        let n = right_side.len();
        let mut x = right_side.to_vec();
        for i in 0..n {
            for (k, factor) in self.lower.row(i) {
                let part = graph.mul(*factor, x[*k]);
                x[i] = graph.sub(x[i], part);
            }
        }
        for (entry, inverse) in x.iter_mut().zip(&self.inverse_diagonal) {
            *entry = graph.mul(*entry, *inverse);
        }
        for i in (0..n).rev() {
            for (k, factor) in self.column(i) {
                let part = graph.mul(factor, x[k]);
                x[i] = graph.sub(x[i], part);
            }
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use machinist_model::Op;
    use machinist_model::evaluate::{Evaluator, Inputs};

    /// Solves m a = f + g (l_1 + l_2), g a = gamma, with the same constraint twice while the mode
    /// holds.
    #[test]
    fn what_a_mode_holds_twice_is_held_by_the_first() {
        let mut graph = Graph::new();
        let [mass, slope, diagonal, force, gamma] =
            [0, 1, 2, 3, 4].map(|entry| graph.insert(Op::State(entry)));
        let mut matrix = Nonzeros::new(3);
        matrix.set(&graph, (0, 0), mass);
        for row in [1, 2] {
            matrix.set(&graph, (row, 0), slope);
            matrix.set(&graph, (0, row), slope);
            matrix.set(&graph, (row, row), diagonal);
        }
        let factors = factor(&mut graph, &matrix, 1);
        let solution = factors.solve(&mut graph, &[force, gamma, gamma]);
        let tape = graph.tape(&solution);
        for (state, expected) in [
            ([3.0, 0.1, 0.0, 2.0, 0.7], [7.0, -190.0, 0.0]),
            ([0.3, 0.7, 0.0, 2.0, 0.7], [1.0, 1.7 / 0.7, 0.0]),
            ([3.0, 0.0, -1.0, 2.0, 0.0], [2.0 / 3.0, 0.0, 0.0]),
        ] {
            let mut found = [0.0; 3];
            let inputs = Inputs { state: &state, ..Inputs::default() };
            Evaluator::new(&tape).evaluate(&inputs, &mut found);
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-12 * expected.abs().max(1.0), "{found}");
            }
        }
    }
}
