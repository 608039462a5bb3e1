//! The mass matrix factored on the tape: M = L D L^T without square roots,
//! unrolled along its nonzeros.
//!
//! Diagonal and block-diagonal matrices need no case of their own: structural
//! zeros fold away, so a diagonal matrix costs one reciprocal a row and a block
//! its own factorization.

use crate::expr::Graph;
use machinist_model::NodeId;

/// L (unit lower triangle) and 1/D.
pub struct Factorization {
    /// L, of which the part below the diagonal is not zero.
    pub lower: Vec<Vec<NodeId>>,
    /// 1/D.
    pub inverse_diagonal: Vec<NodeId>,
}

/// Factors a symmetric matrix given by its nodes: positive definite in its first `free` rows,
/// bordered by constraints.
///
/// Of constraints that hold in modes, which have an entry on the diagonal, one may repeat those
/// before it. Nothing is then left of its pivot, and 0 is taken for 1/D: its force is 0, and the
/// others are as if it were not there.
pub fn factor(graph: &mut Graph, matrix: &[Vec<NodeId>], free: usize) -> Factorization {
    let n = matrix.len();
    let zero = graph.literal(0.0);
    let one = graph.literal(1.0);
    let mut lower = vec![vec![zero; n]; n];
    // scaled[i][j] = L_ij D_j
    let mut scaled = vec![vec![zero; n]; n];
    let mut inverse_diagonal = Vec::with_capacity(n);
    // Columns before j in which L_j is not zero: all that a long chain has is one or two.
    let mut filled: Vec<Vec<usize>> = vec![Vec::new(); n];
    for j in 0..n {
        let may_repeat = j >= free && !graph.is_zero(matrix[j][j]);
        let mut diagonal = matrix[j][j];
        // What it is without other constraints, if there are some that it may repeat.
        let mut alone = None;
        for &k in &filled[j] {
            if k >= free && may_repeat {
                alone = alone.or(Some(diagonal));
            }
            let part = graph.mul(lower[j][k], scaled[j][k]);
            diagonal = graph.sub(diagonal, part);
        }
        let inverse = match alone {
            None if may_repeat && filled[j].is_empty() => inverse_of_empty(graph, diagonal),
            None => graph.div(one, diagonal),
            Some(alone) => inverse_if_any(graph, diagonal, alone),
        };
        inverse_diagonal.push(inverse);
        for i in j + 1..n {
            let mut entry = matrix[i][j];
            for &k in &filled[j] {
                let part = graph.mul(lower[i][k], scaled[j][k]);
                entry = graph.sub(entry, part);
            }
            if !graph.is_zero(entry) {
                scaled[i][j] = entry;
                lower[i][j] = graph.mul(entry, inverse);
                filled[i].push(j);
            }
        }
    }
    Factorization { lower, inverse_diagonal }
}

/// 1/d of a negative pivot d; 0 where only rounding is left of what it was alone.
fn inverse_if_any(graph: &mut Graph, pivot: NodeId, alone: NodeId) -> NodeId {
    /// The square of an angle between two constraints, as M measures it.
    const NOTHING: f64 = 1e-12;
    let (zero, one, nothing) = (graph.literal(0.0), graph.literal(1.0), graph.literal(NOTHING));
    let least = graph.mul(nothing, alone);
    let divisor = graph.select_less(least, pivot, one, pivot);
    let inverse = graph.div(one, divisor);
    graph.select_less(least, pivot, zero, inverse)
}

/// 1/d of a constraint that holds nothing but what others decide whatever the forces: its pivot is
/// -1 where it does not hold, and 0 where it does, for which 0 is taken.
fn inverse_of_empty(graph: &mut Graph, pivot: NodeId) -> NodeId {
    let (zero, one) = (graph.literal(0.0), graph.literal(1.0));
    let divisor = graph.select_less(pivot, zero, pivot, one);
    let inverse = graph.div(one, divisor);
    graph.select_less(pivot, zero, inverse, zero)
}

impl Factorization {
    /// x with L D L^T x = b.
    pub fn solve(&self, graph: &mut Graph, right_side: &[NodeId]) -> Vec<NodeId> {
        let n = right_side.len();
        let mut x = right_side.to_vec();
        for i in 0..n {
            for k in 0..i {
                let part = graph.mul(self.lower[i][k], x[k]);
                x[i] = graph.sub(x[i], part);
            }
        }
        for (entry, inverse) in x.iter_mut().zip(&self.inverse_diagonal) {
            *entry = graph.mul(*entry, *inverse);
        }
        for i in (0..n).rev() {
            for k in i + 1..n {
                let part = graph.mul(self.lower[k][i], x[k]);
                x[i] = graph.sub(x[i], part);
            }
        }
        x
    }
}
