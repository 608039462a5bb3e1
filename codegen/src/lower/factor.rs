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

/// Factors a symmetric positive definite matrix given by its nodes.
pub fn factor(graph: &mut Graph, matrix: &[Vec<NodeId>]) -> Factorization {
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
        let mut diagonal = matrix[j][j];
        for &k in &filled[j] {
            let part = graph.mul(lower[j][k], scaled[j][k]);
            diagonal = graph.sub(diagonal, part);
        }
        let inverse = graph.div(one, diagonal);
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
