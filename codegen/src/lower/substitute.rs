//! Factorization, block by block on the graph, of the linear equations of q'' and -lambda, and
//! the substitution steps with these factors.
//!
//! The steps are listed once. Carried out on the graph they give the accelerations. As data they
//! give derivatives of the accelerations with respect to many numbers at once: see
//! [`machinist_contract::implicit`](machinist_model::Solve).
//!
//! Rows are the coordinates, then the constraints. Right sides are `f` and `gamma` in their rows,
//! and `gamma` alone for a pinned block. After the substitution the rows of coordinates contain
//! q'', and the remaining rows of constraints -lambda.
//!
//! If some motion has no kinetic energy of its own (such as a massless rod between two joints), M
//! has no factors, though the whole matrix may be regular. Then
//!
//! ```text
//! | M + G^T W G  G^T | | q''     |   | f + G^T W gamma |
//! | G             0  | | -lambda | = | gamma           |
//! ```
//!
//! is solved instead. It has the same solution for any weights W: the first equation differs by
//! G^T W times the second. M + G^T W G is positive definite at every state where the whole is
//! regular, which no order of pivots guarantees (Benzi, Golub and Liesen, Acta Numerica 14, 2005,
//! section 5.3). The weights make G^T W G as large as M, in any units.

use std::collections::{BTreeMap, BTreeSet};

use machinist_algebra::expr::Graph;
use machinist_model::NodeId;

use crate::lower::blocks::{Block, Blocks, blocks};
use crate::lower::factor::{Factorization, factor};
use crate::lower::nonzeros::Nonzeros;

/// `x_row = scale x_row - sum of factor x_from`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Step {
    /// The row that changes.
    pub row: usize,
    /// Factor that scales the row first, if any.
    pub scale: Option<NodeId>,
    /// (factor, other row)
    pub terms: Vec<(NodeId, usize)>,
}

impl Step {
    /// Iterates over its factors.
    pub fn factors(&self) -> impl Iterator<Item = NodeId> {
        self.scale.into_iter().chain(self.terms.iter().map(|(factor, _)| *factor))
    }
}

/// Factors of the bordered matrix, and the steps of solving with them.
pub struct Substitution {
    /// M bordered by G.
    matrix: Nonzeros,
    /// Number of coordinates, which are the first rows of the matrix.
    coordinates: usize,
    /// True if M has no factors.
    is_singular: bool,
    blocks: Blocks,
    factors: Vec<BlockFactors>,
    /// Steps that give the accelerations.
    pub steps: Vec<Step>,
    /// For each row, the steps that read it.
    readers: Vec<Vec<usize>>,
    /// For each row, true if it is that of a pinned coordinate.
    is_pinned: Vec<bool>,
}

/// Factors of a pinned block.
enum BlockFactors {
    /// -1/G of a block of one.
    One(NodeId),
    /// Factors of the block bordered by its part of M, which makes a factorization without
    /// pivoting as safe as that of the whole.
    Bordered(Factorization),
}

/// A block, ready to be solved.
struct Bordered {
    rows: Vec<usize>,
    steps: Vec<Step>,
    factorization: Factorization,
}

/// W G of a constraint and a coordinate, by their rows in a block.
struct Weighed {
    row: usize,
    constraint: usize,
    factor: NodeId,
}

/// Adds G^T W G to the M of a bordered matrix, for the constraints that always hold. The first
/// `free` rows are M. A weight is the sum of M's diagonal divided by the constraint's entry of G
/// G^T, which is nonzero at every state where the whole matrix is regular.
fn stiffen(graph: &mut Graph, matrix: &mut Nonzeros, free: usize) -> Vec<Weighed> {
    let zero = graph.literal(0.0);
    let sum = |graph: &mut Graph, parts: Vec<NodeId>| {
        parts.into_iter().fold(zero, |sum, part| graph.add(sum, part))
    };
    let trace = sum(graph, (0..free).filter_map(|i| matrix.get(i, i)).collect());
    let trace = if graph.is_zero(trace) { graph.literal(1.0) } else { trace };
    let mut weighed = Vec::new();
    for constraint in free..matrix.len() {
        let line = matrix.row(constraint).clone();
        let held: Vec<(usize, NodeId)> = line.range(..free).map(|(i, node)| (*i, *node)).collect();
        if held.is_empty() || line.contains_key(&constraint) {
            continue;
        }
        let squares = held.iter().map(|(_, entry)| graph.mul(*entry, *entry)).collect();
        let size = sum(graph, squares);
        let weight = graph.div(trace, size);
        for &(i, entry) in &held {
            let factor = graph.mul(weight, entry);
            for &(j, other) in held.iter().filter(|(j, _)| *j <= i) {
                let part = graph.mul(factor, other);
                let entry = graph.add(matrix.get(i, j).unwrap_or(zero), part);
                matrix.set(graph, (i, j), entry);
                matrix.set(graph, (j, i), entry);
            }
            weighed.push(Weighed { row: i, constraint, factor });
        }
    }
    weighed
}

impl Substitution {
    /// Factors a matrix of which the first `coordinates` rows are M, which may be singular even
    /// if the whole is regular.
    pub fn new(graph: &mut Graph, matrix: Nonzeros, coordinates: usize, is_singular: bool) -> Self {
        let held: Vec<Vec<usize>> = (coordinates..matrix.len())
            .map(|row| matrix.row(row).range(..coordinates).map(|(column, _)| *column).collect())
            .collect();
        // A constraint that holds in some modes only has an entry on the diagonal, and determines
        // nothing by itself.
        let always: Vec<usize> = (0..held.len())
            .filter(|row| matrix.get(coordinates + row, coordinates + row).is_none())
            .collect();
        let blocks = blocks_of(&held, &always, coordinates);
        let rows = matrix.len();
        let mut is_pinned = vec![false; rows];
        for coordinate in blocks.pinned.iter().flat_map(|block| &block.coordinates) {
            is_pinned[*coordinate] = true;
        }
        let mut this = Substitution {
            matrix,
            coordinates,
            is_singular,
            blocks,
            factors: Vec::new(),
            steps: Vec::new(),
            readers: vec![Vec::new(); rows],
            is_pinned,
        };
        this.factor(graph);
        for (place, step) in this.steps.iter().enumerate() {
            let scaled = step.scale.map(|_| step.row);
            for row in scaled.into_iter().chain(step.terms.iter().map(|(_, from)| *from)) {
                this.readers[row].push(place);
            }
        }
        this
    }

    fn factor(&mut self, graph: &mut Graph) {
        let blocks = self.blocks.clone();
        let mut known: Vec<usize> = Vec::new();
        for block in &blocks.pinned {
            let rows: Vec<usize> = self.constraint_rows(block).collect();
            for &row in &rows {
                self.couple(row, &known);
            }
            let factors = if let ([coordinate], [row]) = (&block.coordinates[..], &rows[..]) {
                let minus_one = graph.literal(-1.0);
                let held = self.matrix.get(*row, *coordinate);
                let held = held.unwrap_or_else(|| graph.literal(0.0));
                let inverse = graph.div(minus_one, held);
                self.push(Step { row: *coordinate, scale: None, terms: vec![(inverse, *row)] });
                BlockFactors::One(inverse)
            } else {
                let bordered = self.bordered(graph, block);
                self.substitute(&bordered);
                BlockFactors::Bordered(bordered.factorization)
            };
            self.factors.push(factors);
            known.extend(&block.coordinates);
        }
        known.sort_unstable();
        let bordered = self.bordered(graph, &blocks.free);
        for &row in &bordered.rows {
            self.couple(row, &known);
        }
        self.substitute(&bordered);
    }

    fn constraint_rows<'a>(&self, block: &'a Block) -> impl Iterator<Item = usize> + 'a {
        let first = self.coordinates;
        block.constraints.iter().map(move |constraint| first + constraint)
    }

    /// Returns the rows of a block with their factors, and adds steps on right sides that precede
    /// them.
    fn bordered(&self, graph: &mut Graph, block: &Block) -> Bordered {
        let constraints = self.constraint_rows(block);
        let rows: Vec<usize> = block.coordinates.iter().copied().chain(constraints).collect();
        let place: BTreeMap<usize, usize> = rows.iter().copied().zip(0..).collect();
        let mut matrix = Nonzeros::new(rows.len());
        for (at, row) in rows.iter().enumerate() {
            for (column, node) in self.matrix.row(*row) {
                if let Some(column) = place.get(column) {
                    matrix.set(graph, (at, *column), *node);
                }
            }
        }
        let free = block.coordinates.len();
        let weighed = if self.is_singular { stiffen(graph, &mut matrix, free) } else { Vec::new() };
        let steps = weighed.into_iter().map(|Weighed { row, constraint, factor }| Step {
            row: rows[row],
            scale: None,
            terms: vec![(graph.neg(factor), rows[constraint])],
        });
        let steps = steps.collect();
        Bordered { rows, steps, factorization: factor(graph, &matrix, free) }
    }

    fn push(&mut self, step: Step) {
        if step.scale.is_some() || !step.terms.is_empty() {
            self.steps.push(step);
        }
    }

    /// Moves known coordinates to the right side of a row.
    fn couple(&mut self, row: usize, known: &[usize]) {
        let entry = |column: &usize| Some((self.matrix.get(row, *column)?, *column));
        let terms = known.iter().filter_map(entry).collect();
        self.push(Step { row, scale: None, terms });
    }

    fn substitute(&mut self, bordered: &Bordered) {
        let Bordered { rows, steps, factorization: factors } = bordered;
        self.steps.extend(steps.iter().cloned());
        for (i, row) in rows.iter().enumerate() {
            let terms = factors.lower.row(i).iter();
            let terms = terms.map(|(k, factor)| (*factor, rows[*k])).collect();
            self.push(Step { row: *row, scale: None, terms });
        }
        for (i, row) in rows.iter().enumerate().rev() {
            let terms = factors.column(i).map(|(k, factor)| (factor, rows[k])).collect();
            self.push(Step { row: *row, scale: Some(factors.inverse_diagonal[i]), terms });
        }
    }

    /// Returns the number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.matrix.len()
    }

    /// Returns q'', then -lambda, for right sides `f` and `gamma`.
    pub fn solve(&self, graph: &mut Graph, right_side: &[NodeId]) -> Vec<NodeId> {
        let zero = graph.literal(0.0);
        let sides = right_side.iter().copied().enumerate().collect();
        let found = self.accelerations(graph, sides);
        let mut x = vec![zero; right_side.len()];
        for (row, value) in found {
            x[row] = value;
        }
        let n = self.coordinates;
        // For pinned blocks from the last to the first, G_b^T (-lambda_b) is the residual of the
        // equations of motion.
        let mut known = self.blocks.free.constraints.clone();
        for (block, factors) in self.blocks.pinned.iter().zip(&self.factors).rev() {
            let constraints = || self.constraint_rows(block);
            let left: Vec<NodeId> = block
                .coordinates
                .iter()
                .map(|&row| {
                    let others = (0..n).chain(known.iter().map(|constraint| n + constraint));
                    let mut left = right_side[row];
                    let others =
                        others.filter_map(|column| Some((self.matrix.get(row, column)?, column)));
                    for (entry, column) in others {
                        let part = graph.mul(entry, x[column]);
                        left = graph.sub(left, part);
                    }
                    left
                })
                .collect();
            match factors {
                BlockFactors::One(inverse) => {
                    let negative = graph.mul(*inverse, left[0]);
                    for row in constraints() {
                        x[row] = graph.neg(negative);
                    }
                }
                BlockFactors::Bordered(factors) => {
                    let mut sides = left;
                    sides.extend(constraints().map(|_| zero));
                    let solved = factors.solve(graph, &sides);
                    for (row, value) in constraints().zip(&solved[block.coordinates.len()..]) {
                        x[row] = *value;
                    }
                }
            }
            known.extend(&block.constraints);
        }
        x
    }

    /// Returns q'' in the rows of coordinates, for right sides `f` and `gamma`. The rows of
    /// constraints contain -lambda for those in no pinned block. Missing rows are zero, before
    /// and after.
    pub fn accelerations(
        &self,
        graph: &mut Graph,
        mut x: BTreeMap<usize, NodeId>,
    ) -> BTreeMap<usize, NodeId> {
        let zero = graph.literal(0.0);
        x.retain(|row, value| self.is_read(*row) && !graph.is_zero(*value));
        // Most of a column of a Jacobian is zero, and most steps do not change it.
        let mut open: BTreeSet<usize> =
            x.keys().flat_map(|row| self.readers[*row].iter().copied()).collect();
        while let Some(place) = open.pop_first() {
            let Step { row, scale, terms } = &self.steps[place];
            let before = x.get(row).copied();
            let mut value = match (before, scale) {
                (Some(value), Some(scale)) => graph.mul(value, *scale),
                (before, _) => before.unwrap_or(zero),
            };
            for (factor, from) in terms {
                if let Some(from) = x.get(from) {
                    let part = graph.mul(*factor, *from);
                    value = graph.sub(value, part);
                }
            }
            if graph.is_zero(value) {
                x.remove(row);
                continue;
            }
            x.insert(*row, value);
            if before.is_none() {
                open.extend(self.readers[*row].iter().filter(|later| **later > place));
            }
        }
        x
    }

    /// Reports whether a row of right sides affects the accelerations.
    #[must_use]
    pub fn is_read(&self, row: usize) -> bool {
        !self.is_pinned[row]
    }
}

/// Returns the blocks of the constraints that always hold. The others are appended to the free
/// block, because a redundant constraint may only be one that does not always hold.
fn blocks_of(held: &[Vec<usize>], always: &[usize], coordinates: usize) -> Blocks {
    let rows: Vec<Vec<usize>> = always.iter().map(|row| held[*row].clone()).collect();
    let mut found = blocks(&rows, coordinates);
    for block in found.pinned.iter_mut().chain([&mut found.free]) {
        block.constraints.iter_mut().for_each(|row| *row = always[*row]);
    }
    let others = (0..held.len()).filter(|row| !always.contains(row));
    found.free.constraints.sort_unstable();
    found.free.constraints.extend(others);
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lower::needed::needed;
    use machinist_model::Op;
    use machinist_model::evaluate::{Evaluator, Inputs};

    /// M (diagonal except for one coupling) and G of a machine. The first two coordinates are
    /// pinned one by one, the next two together, and three with one constraint remain.
    const MASS: [(usize, usize); 8] =
        [(0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5), (6, 6), (1, 4)];
    const BORDER: [&[usize]; 5] = [&[0], &[0, 1], &[1, 2, 3], &[2, 3], &[3, 4, 5]];
    const N: usize = 7;
    const SIZE: usize = N + BORDER.len();

    /// Returns the bordered matrix in numbers, and its nonzeros. In the singular case some
    /// coordinates have no inertia: one of each block, and two of the free ones.
    fn numbers(is_singular: bool) -> [[f64; SIZE]; SIZE] {
        let mut matrix = [[0.0; SIZE]; SIZE];
        let mut set = |i: usize, j: usize, value| {
            matrix[i][j] = value;
            matrix[j][i] = value;
        };
        for (k, (i, j)) in MASS.into_iter().enumerate() {
            set(i, j, if i == j { 1.0 + 0.3 * k as f64 } else { 0.4 });
        }
        if is_singular {
            for (i, j) in [(1, 4), (4, 1), (0, 0), (2, 2), (3, 3), (4, 4)] {
                matrix[i][j] = 0.0;
            }
        }
        let mut set = |i: usize, j: usize, value| {
            matrix[i][j] = value;
            matrix[j][i] = value;
        };
        for (c, held) in BORDER.into_iter().enumerate() {
            for (k, coordinate) in held.iter().enumerate() {
                set(N + c, *coordinate, 0.7 + 0.9 * ((3 * c + 5 * k) as f64).sin());
            }
        }
        matrix
    }

    fn values(tape: &machinist_model::Tape, state: &[f64]) -> Vec<f64> {
        let inputs = Inputs { state, ..Inputs::default() };
        let mut values = vec![0.0; tape.results.len()];
        Evaluator::new(tape).evaluate(&inputs, &mut values);
        values
    }

    /// Returns a graph whose state is the entries of the matrix, then the right side.
    fn built(is_singular: bool) -> (Graph, Substitution, Vec<NodeId>, Vec<f64>) {
        let mut graph = Graph::new();
        let zero = graph.literal(0.0);
        let matrix = numbers(is_singular);
        let mut state = matrix.as_flattened().to_vec();
        let mut entry = |i: usize, j: usize| {
            let place = (i.max(j) * SIZE + i.min(j)) as u32;
            if matrix[i][j] == 0.0 { zero } else { graph.insert(Op::State(place)) }
        };
        let places = (0..SIZE).flat_map(|i| (0..SIZE).map(move |j| (i, j)));
        let entries: Vec<_> = places.map(|(i, j)| ((i, j), entry(i, j))).collect();
        let mut nodes = Nonzeros::new(SIZE);
        for (place, node) in entries {
            nodes.set(&graph, place, node);
        }
        let substitution = Substitution::new(&mut graph, nodes, N, is_singular);
        let side = (0..SIZE).map(|i| graph.insert(Op::State((SIZE * SIZE + i) as u32))).collect();
        state.extend((0..SIZE).map(|i| (i as f64 + 0.5).cos()));
        (graph, substitution, side, state)
    }

    #[test]
    fn accelerations_and_multipliers_fulfil_the_equations() {
        for is_singular in [false, true] {
            let (mut graph, substitution, side, state) = built(is_singular);
            let solution = substitution.solve(&mut graph, &side);
            let x = values(&graph.tape(&solution), &state);
            for (row, right) in numbers(is_singular).iter().zip(&state[SIZE * SIZE..]) {
                let left: f64 = row.iter().zip(&x).map(|(entry, x)| entry * x).sum();
                assert!((left - right).abs() < 1e-11, "{left} {right}, {is_singular}");
            }
        }
    }

    #[test]
    fn no_force_has_a_say_in_what_is_pinned() {
        let (graph, substitution, ..) = built(false);
        assert!((0..4).all(|row| !substitution.is_read(row)));
        assert!((4..SIZE).all(|row| substitution.is_read(row)));
        // One column for each row of right sides that is read.
        let sides = (4..SIZE).map(|row| (row, row)).collect();
        let needed = needed(&substitution.steps, &sides, &(0..N).collect());
        let columns = |row: usize| needed.columns[&row].iter().copied().collect::<Vec<_>>();
        assert_eq!(columns(0), [N]);
        assert_eq!(columns(1), [N, N + 1]);
        assert_eq!(columns(2), [N, N + 1, N + 2, N + 3]);
        assert_eq!(columns(6), [6]);
        assert!(needed.steps.iter().flat_map(Step::factors).all(|factor| !graph.is_zero(factor)));
    }

    #[test]
    fn nothing_is_left_for_sides_without_a_say() {
        let (_, substitution, ..) = built(false);
        let sides = BTreeSet::from([(6, 0)]);
        let needed = needed(&substitution.steps, &sides, &BTreeSet::from([0, 1, 4]));
        assert!(needed.steps.is_empty());
        assert!(!needed.sides.contains(&6));
    }
}
