//! Constraint forces that forces depend on.
//!
//! ```text
//! A x = f_0 + sum of b_k lambda_k        x = [q'', -lambda]
//! (1 - L) lambda = lambda_0              L_jk = lambda_j of A x = b_k
//! ```
//!
//! A is the symmetric matrix of [`super::substitute`], and lambda_0 the solution without these
//! forces; only the few lambda_k that forces depend on are unknowns.
//!
//! b_k may differ by the sign of lambda_k. With the force of one constraint left out, lambda_k = h,
//! and with it lambda_k = h + L_kk(sign) lambda_k. While L_kk < 1 for both signs, as L_kk = 0 is for h,
//! the solution has the sign of h: friction that does not jam changes the size of a reaction, not its
//! direction. h itself needs the signs of the others, with k left out, and so on for fewer and fewer.

use std::collections::BTreeMap;

use machinist_algebra::expr::{Expr, Graph, Symbol};
use machinist_model::{Function, NodeId};
use num_bigint::BigInt;
use num_rational::BigRational;

use super::substitute::Substitution;
use crate::mechanics::linearize::Reaction;

/// The unknowns lambda_k, and how forces depend on them.
#[derive(Default)]
pub struct Reactions {
    /// Rows of -lambda_k in x.
    rows: Vec<usize>,
    /// b_k by rows, at the signs of the motion.
    sides: Vec<Vec<(usize, NodeId)>>,
    /// L at the signs of the motion, by columns.
    columns: Vec<Vec<NodeId>>,
    /// True for unknowns whose sign matters.
    is_signed: Vec<bool>,
}

/// A column of L.
enum Column {
    Same(Vec<NodeId>),
    /// For a negative and a positive unknown.
    Signed([Vec<NodeId>; 2]),
}

/// What is known while signs are searched for.
struct Search {
    columns: Vec<Column>,
    /// True for unknowns whose sign matters.
    is_signed: Vec<bool>,
    /// lambda_0.
    without: Vec<NodeId>,
    /// Solutions without some of the signed unknowns, by the set of these, a bit for each.
    known: BTreeMap<u32, Vec<NodeId>>,
}

/// The multipliers that forces depend on, before they are solved for.
pub struct Unknowns<'a> {
    /// df/dlambda.
    pub reactions: &'a [Reaction],
    /// Number of coordinates, whose rows come first.
    pub coordinates: usize,
}

impl Unknowns<'_> {
    /// Solves for them, given right sides without them and `lower` for expressions, and sets the
    /// nodes of multipliers without load.
    pub fn reactions(
        &self,
        graph: &mut Graph,
        substitution: &Substitution,
        side: &[NodeId],
        lower: impl Fn(&mut Graph, &Expr) -> NodeId,
    ) -> Reactions {
        let row = |of: &Reaction| self.coordinates + of.constraint.0 as usize;
        let rows: Vec<usize> = self.reactions.iter().map(row).collect();
        if rows.is_empty() {
            return Reactions::default();
        }
        let without = forces(graph, substitution, &rows, side);
        let column = |graph: &mut Graph, reaction: &Reaction, sign: i64| {
            let mut column = vec![graph.literal(0.0); side.len()];
            for (row, slope) in &reaction.forcing {
                column[*row] = lower(graph, &at_sign(slope, sign));
            }
            forces(graph, substitution, &rows, &column)
        };
        let is_signed: Vec<bool> = self.reactions.iter().map(is_signed).collect();
        let columns = self.reactions.iter().zip(&is_signed).map(|(reaction, is_signed)| {
            if *is_signed {
                Column::Signed([-1, 1].map(|sign| column(graph, reaction, sign)))
            } else {
                Column::Same(column(graph, reaction, 1))
            }
        });
        let columns = columns.collect();
        let mut search =
            Search { columns, is_signed: is_signed.clone(), without, known: BTreeMap::new() };
        let columns = (0..rows.len()).map(|unknown| search.column(graph, unknown, 0)).collect();
        for (unknown, reaction) in self.reactions.iter().enumerate() {
            if is_signed[unknown] {
                let unloaded = search.solution(graph, 1 << unknown)[unknown];
                graph.set_unloaded([(reaction.constraint, unloaded)]);
            }
        }
        let mut lowered = |of: &Reaction| {
            of.forcing.iter().map(|(row, slope)| (*row, lower(graph, slope))).collect()
        };
        let sides = self.reactions.iter().map(&mut lowered).collect();
        Reactions { rows, sides, columns, is_signed }
    }
}

/// Returns an expression without its terms in constraint forces.
pub fn without_reactions(expr: &Expr) -> Expr {
    if !expr.mentions(|symbol| matches!(symbol, Symbol::Multiplier(_))) {
        return expr.clone();
    }
    // The sign does not matter where the force is zero.
    expr.replace(&|symbol| match symbol {
        Symbol::Multiplier(_) => Some(Expr::integer(0)),
        Symbol::Unloaded(_) => Some(Expr::integer(1)),
        _ => None,
    })
}

impl Reactions {
    /// Reports whether forces depend on no constraint force.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Returns q'' in the rows of coordinates, for right sides by rows, and, if `with_forces`, -lambda
    /// in those of all constraints; see [`Substitution::accelerations`].
    pub fn solved(
        &self,
        graph: &mut Graph,
        substitution: &Substitution,
        side: BTreeMap<usize, NodeId>,
        with_forces: bool,
    ) -> BTreeMap<usize, NodeId> {
        if self.is_empty() && !with_forces {
            return substitution.accelerations(graph, side);
        }
        let mut sides = vec![graph.literal(0.0); substitution.rows()];
        for (row, node) in side {
            sides[row] = node;
        }
        let found = self.solve(graph, substitution, sides).into_iter().enumerate();
        found.filter(|(_, node)| !graph.is_zero(*node)).collect()
    }

    /// Returns x for right sides without the forces that depend on constraint forces.
    pub fn solve(
        &self,
        graph: &mut Graph,
        substitution: &Substitution,
        mut side: Vec<NodeId>,
    ) -> Vec<NodeId> {
        if self.is_empty() {
            return substitution.solve(graph, &side);
        }
        let without = forces(graph, substitution, &self.rows, &side);
        let found = eliminated(graph, &self.columns, without, &self.is_signed);
        for (of, value) in self.sides.iter().zip(found) {
            for (row, slope) in of {
                let part = graph.mul(*slope, value);
                side[*row] = graph.add(side[*row], part);
            }
        }
        substitution.solve(graph, &side)
    }
}

impl Search {
    /// Returns a column of L where unknowns are left out; its own is not.
    fn column(&mut self, graph: &mut Graph, unknown: usize, off: u32) -> Vec<NodeId> {
        let [negative, positive] = match &self.columns[unknown] {
            Column::Same(column) => return column.clone(),
            Column::Signed(both) => both.clone(),
        };
        let sign = self.solution(graph, off | 1 << unknown)[unknown];
        let zero = graph.literal(0.0);
        let pairs = negative.into_iter().zip(positive);
        pairs.map(|(n, p)| graph.select_less(sign, zero, n, p)).collect()
    }

    /// Returns the unknowns where the forces of some are left out.
    fn solution(&mut self, graph: &mut Graph, off: u32) -> Vec<NodeId> {
        if let Some(known) = self.known.get(&off) {
            return known.clone();
        }
        let zero = graph.literal(0.0);
        let count = self.columns.len();
        let columns: Vec<Vec<NodeId>> = (0..count)
            .map(|unknown| match off >> unknown & 1 {
                1 => vec![zero; count],
                _ => self.column(graph, unknown, off),
            })
            .collect();
        let found = eliminated(graph, &columns, self.without.clone(), &self.is_signed);
        self.known.insert(off, found.clone());
        found
    }
}

/// Reports whether forces differ by the sign of a multiplier.
fn is_signed(reaction: &Reaction) -> bool {
    let is_own = |symbol| symbol == Symbol::Unloaded(reaction.constraint);
    reaction.forcing.iter().any(|(_, slope)| slope.mentions(is_own))
}

/// Returns a factor for a sign of its multiplier.
fn at_sign(slope: &Expr, sign: i64) -> Expr {
    let sign = Expr::Number(BigRational::from_integer(BigInt::from(sign)));
    slope.replace(&|symbol| matches!(symbol, Symbol::Unloaded(_)).then(|| sign.clone()))
}

/// Returns lambda of some rows for right sides.
fn forces(
    graph: &mut Graph,
    substitution: &Substitution,
    rows: &[usize],
    side: &[NodeId],
) -> Vec<NodeId> {
    let x = substitution.solve(graph, side);
    rows.iter().map(|row| graph.neg(x[*row])).collect()
}

/// Solves (1 - L) lambda = side by elimination in order. Where the pivots of signed unknowns are not
/// positive, forces jam and the result is not a number.
fn eliminated(
    graph: &mut Graph,
    columns: &[Vec<NodeId>],
    mut side: Vec<NodeId>,
    is_signed: &[bool],
) -> Vec<NodeId> {
    let count = side.len();
    let one = graph.literal(1.0);
    let mut matrix: Vec<Vec<NodeId>> = (0..count)
        .map(|row| {
            let entry = |column: usize| {
                let entry = columns[column][row];
                if row == column { graph.sub(one, entry) } else { graph.neg(entry) }
            };
            (0..count).map(entry).collect()
        })
        .collect();
    for pivot in 0..count {
        if is_signed[pivot] && !graph.is_constant(matrix[pivot][pivot]) {
            let root = graph.call(Function::Sqrt, matrix[pivot][pivot]);
            matrix[pivot][pivot] = graph.mul(root, root);
        }
        let (above, below) = matrix.split_at_mut(pivot + 1);
        let from = &above[pivot];
        for (row, line) in (pivot + 1..).zip(below) {
            if graph.is_zero(line[pivot]) {
                continue;
            }
            let factor = graph.div(line[pivot], from[pivot]);
            for (entry, from) in line.iter_mut().zip(from).skip(pivot + 1) {
                let part = graph.mul(factor, *from);
                *entry = graph.sub(*entry, part);
            }
            let part = graph.mul(factor, side[pivot]);
            side[row] = graph.sub(side[row], part);
        }
    }
    for row in (0..count).rev() {
        for column in row + 1..count {
            let part = graph.mul(matrix[row][column], side[column]);
            side[row] = graph.sub(side[row], part);
        }
        side[row] = graph.div(side[row], matrix[row][row]);
    }
    side
}
