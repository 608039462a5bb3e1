//! The linear equations of q'' and -lambda, factored block by block on the graph, and the
//! steps of a substitution with these factors.
//!
//! The steps are written down once. Done on the graph they give the accelerations; as data
//! they give derivatives of them with respect to many numbers at once: see
//! [`machinist_contract::implicit`](machinist_model::Solve).
//!
//! Rows are the coordinates, then the constraints. Right sides are `f` and `gamma` in their
//! rows, of a pinned block `gamma` alone; afterwards the rows of coordinates hold q'', those
//! of constraints that are left -lambda.
//!
//! Where some motion has no kinetic energy of its own (a rod without mass between two joints),
//! M has no factors, though the whole may be regular. Then
//!
//! ```text
//! | M + G^T W G  G^T | | q''     |   | f + G^T W gamma |
//! | G             0  | | -lambda | = | gamma           |
//! ```
//!
//! is solved instead, which has the same solution, whatever the weights W are: the first
//! equation differs by G^T W times the second. It is positive definite at every state where
//! the whole is regular, which no order of pivots is (Benzi, Golub and Liesen, Acta Numerica
//! 14, 2005, section 5.3). Weights are as large as M beside G, in any units.

use std::collections::{BTreeMap, BTreeSet};

use machinist_model::NodeId;

use crate::expr::Graph;
use crate::lower::blocks::{Block, Blocks, blocks};
use crate::lower::factor::{Factorization, factor};

/// `x_row = scale x_row - sum of factor x_from`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Step {
    /// The row that changes.
    pub row: usize,
    /// What it is scaled by before.
    pub scale: Option<NodeId>,
    /// (factor, from which row)
    pub terms: Vec<(NodeId, usize)>,
}

impl Step {
    /// What it multiplies by.
    pub fn factors(&self) -> impl Iterator<Item = NodeId> {
        self.scale.into_iter().chain(self.terms.iter().map(|(factor, _)| *factor))
    }
}

/// Factors of the bordered matrix, and how to solve with them.
pub struct Substitution {
    /// M bordered by G.
    matrix: Vec<Vec<NodeId>>,
    /// Rows of the matrix that are coordinates.
    coordinates: usize,
    /// Whether M has no factors.
    is_singular: bool,
    blocks: Blocks,
    factors: Vec<BlockFactors>,
    /// What gives the accelerations.
    pub steps: Vec<Step>,
}

/// What solves a pinned block.
enum BlockFactors {
    /// -1/G of a block of one.
    One(NodeId),
    /// Of the block bordered by its part of M, which keeps a factorization without
    /// pivoting as safe as that of the whole.
    Bordered(Factorization),
}

/// A block, ready to be solved for.
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

/// Adds G^T W G to the M of a bordered matrix of which the first `free` rows are M, by the
/// constraints that always hold. A weight is the sum of M's diagonal over that of G G^T's
/// entry: nothing that is zero at a state where all is regular.
fn stiffen(graph: &mut Graph, matrix: &mut [Vec<NodeId>], free: usize) -> Vec<Weighed> {
    let zero = graph.literal(0.0);
    let sum = |graph: &mut Graph, parts: Vec<NodeId>| {
        parts.into_iter().fold(zero, |sum, part| graph.add(sum, part))
    };
    let trace = sum(graph, (0..free).map(|i| matrix[i][i]).collect());
    let trace = if graph.is_zero(trace) { graph.literal(1.0) } else { trace };
    let mut weighed = Vec::new();
    for constraint in free..matrix.len() {
        let line = matrix[constraint].clone();
        let held: Vec<usize> = (0..free).filter(|i| !graph.is_zero(line[*i])).collect();
        if held.is_empty() || !graph.is_zero(line[constraint]) {
            continue;
        }
        let squares = held.iter().map(|i| graph.mul(line[*i], line[*i])).collect();
        let size = sum(graph, squares);
        let weight = graph.div(trace, size);
        for &i in &held {
            let factor = graph.mul(weight, line[i]);
            for &j in held.iter().filter(|j| **j <= i) {
                let part = graph.mul(factor, line[j]);
                matrix[i][j] = graph.add(matrix[i][j], part);
                matrix[j][i] = matrix[i][j];
            }
            weighed.push(Weighed { row: i, constraint, factor });
        }
    }
    weighed
}

impl Substitution {
    /// Factors a matrix of which the first `coordinates` rows are M, which may be singular
    /// where the whole is not.
    pub fn new(
        graph: &mut Graph,
        matrix: Vec<Vec<NodeId>>,
        coordinates: usize,
        is_singular: bool,
    ) -> Self {
        let held: Vec<Vec<usize>> = matrix[coordinates..]
            .iter()
            .map(|row| (0..coordinates).filter(|c| !graph.is_zero(row[*c])).collect())
            .collect();
        // A constraint that holds in some modes only has an entry on the diagonal, and decides
        // nothing by itself.
        let always: Vec<usize> = (0..held.len())
            .filter(|row| graph.is_zero(matrix[coordinates + row][coordinates + row]))
            .collect();
        let blocks = blocks_of(&held, &always, coordinates);
        let mut this = Substitution {
            matrix,
            coordinates,
            is_singular,
            blocks,
            factors: Vec::new(),
            steps: Vec::new(),
        };
        this.factor(graph);
        this
    }

    fn factor(&mut self, graph: &mut Graph) {
        let blocks = self.blocks.clone();
        let mut known: Vec<usize> = Vec::new();
        for block in &blocks.pinned {
            let rows: Vec<usize> = self.constraint_rows(block).collect();
            for &row in &rows {
                self.couple(graph, row, &known);
            }
            let factors = if let ([coordinate], [row]) = (&block.coordinates[..], &rows[..]) {
                let minus_one = graph.literal(-1.0);
                let inverse = graph.div(minus_one, self.matrix[*row][*coordinate]);
                self.push(Step { row: *coordinate, scale: None, terms: vec![(inverse, *row)] });
                BlockFactors::One(inverse)
            } else {
                let bordered = self.bordered(graph, block);
                self.substitute(graph, &bordered);
                BlockFactors::Bordered(bordered.factorization)
            };
            self.factors.push(factors);
            known.extend(&block.coordinates);
        }
        known.sort_unstable();
        let bordered = self.bordered(graph, &blocks.free);
        for &row in &bordered.rows {
            self.couple(graph, row, &known);
        }
        self.substitute(graph, &bordered);
    }

    fn constraint_rows<'a>(&self, block: &'a Block) -> impl Iterator<Item = usize> + 'a {
        let first = self.coordinates;
        block.constraints.iter().map(move |constraint| first + constraint)
    }

    /// Rows of a block with their factors, and steps on right sides before these are used.
    fn bordered(&self, graph: &mut Graph, block: &Block) -> Bordered {
        let constraints = self.constraint_rows(block);
        let rows: Vec<usize> = block.coordinates.iter().copied().chain(constraints).collect();
        let part = |row: &usize| rows.iter().map(|column| self.matrix[*row][*column]).collect();
        let mut matrix: Vec<Vec<NodeId>> = rows.iter().map(part).collect();
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

    /// Takes what is known of other coordinates to the right side of a row.
    fn couple(&mut self, graph: &Graph, row: usize, known: &[usize]) {
        let entry = |column: &usize| (self.matrix[row][*column], *column);
        let terms = known.iter().map(entry).filter(|(factor, _)| !graph.is_zero(*factor));
        let terms = terms.collect();
        self.push(Step { row, scale: None, terms });
    }

    fn substitute(&mut self, graph: &Graph, bordered: &Bordered) {
        let Bordered { rows, steps, factorization: factors } = bordered;
        self.steps.extend(steps.iter().cloned());
        let terms = |of: &mut dyn Iterator<Item = (NodeId, usize)>| -> Vec<(NodeId, usize)> {
            of.filter(|(factor, _)| !graph.is_zero(*factor)).collect()
        };
        for (i, row) in rows.iter().enumerate() {
            let terms = terms(&mut (0..i).map(|k| (factors.lower[i][k], rows[k])));
            self.push(Step { row: *row, scale: None, terms });
        }
        for (i, row) in rows.iter().enumerate().rev() {
            let terms = terms(&mut (i + 1..rows.len()).map(|k| (factors.lower[k][i], rows[k])));
            self.push(Step { row: *row, scale: Some(factors.inverse_diagonal[i]), terms });
        }
    }

    /// q'', then -lambda, of `f` and `gamma`.
    pub fn solve(&self, graph: &mut Graph, right_side: &[NodeId]) -> Vec<NodeId> {
        let mut x = self.accelerations(graph, right_side);
        let n = self.coordinates;
        // Of pinned blocks from the last to the first, G_b^T (-lambda_b) is what is left of
        // the equations of motion.
        let mut known = self.blocks.free.constraints.clone();
        for (block, factors) in self.blocks.pinned.iter().zip(&self.factors).rev() {
            let constraints = || self.constraint_rows(block);
            let left: Vec<NodeId> = block
                .coordinates
                .iter()
                .map(|&row| {
                    let others = (0..n).chain(known.iter().map(|constraint| n + constraint));
                    let mut left = right_side[row];
                    for column in others {
                        let part = graph.mul(self.matrix[row][column], x[column]);
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
                    let zero = graph.literal(0.0);
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

    /// q'' in the rows of coordinates, of `f` and `gamma`; the rows of constraints hold
    /// -lambda of those only that no pinned block has.
    pub fn accelerations(&self, graph: &mut Graph, right_side: &[NodeId]) -> Vec<NodeId> {
        let mut x = self.own_sides(graph, right_side);
        // Most of a column of a Jacobian is.
        let mut is_zero: Vec<bool> = x.iter().map(|value| graph.is_zero(*value)).collect();
        for Step { row, scale, terms } in &self.steps {
            let mut value = x[*row];
            if let Some(scale) = scale
                && !graph.is_zero(value)
            {
                value = graph.mul(value, *scale);
            }
            for (factor, from) in terms.iter().filter(|(_, from)| !is_zero[*from]) {
                let part = graph.mul(*factor, x[*from]);
                value = graph.sub(value, part);
            }
            is_zero[*row] = graph.is_zero(value);
            x[*row] = value;
        }
        x
    }

    /// The right side without the equations of motion of pinned coordinates.
    fn own_sides(&self, graph: &mut Graph, right_side: &[NodeId]) -> Vec<NodeId> {
        let mut sides = right_side.to_vec();
        for coordinate in self.blocks.pinned.iter().flat_map(|block| &block.coordinates) {
            sides[*coordinate] = graph.literal(0.0);
        }
        sides
    }

    /// Whether a row of right sides has a say in accelerations.
    #[must_use]
    pub fn is_read(&self, row: usize) -> bool {
        !self.blocks.pinned.iter().any(|block| block.coordinates.contains(&row))
    }
}

/// Blocks by the constraints that always hold; the others are left to the free block, behind
/// them: what repeats constraints is one that does not always hold.
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

/// Steps of which only those are left that take something from right sides to rows that
/// are wanted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Needed {
    /// What is left of them.
    pub steps: Vec<Step>,
    /// Rows of right sides that have a say.
    pub sides: BTreeSet<usize>,
    /// Products of nonzeros, in all columns.
    pub products: usize,
    /// Columns in which a row may be nonzero afterwards.
    pub columns: BTreeMap<usize, BTreeSet<usize>>,
}

/// Leaves out steps on structural zeros and steps that no wanted row needs. `sides` are the
/// (row, column) of nonzeros of right sides.
#[must_use]
pub fn needed(
    steps: &[Step],
    sides: &BTreeSet<(usize, usize)>,
    wanted: &BTreeSet<usize>,
) -> Needed {
    let mut columns: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
    for &(row, column) in sides {
        columns.entry(row).or_default().insert(column);
    }
    let mut forward = Vec::new();
    for step in steps {
        let terms = step.terms.iter().filter(|(_, from)| columns.contains_key(from));
        let terms: Vec<_> = terms.copied().collect();
        let scale = step.scale.filter(|_| columns.contains_key(&step.row));
        if scale.is_none() && terms.is_empty() {
            continue;
        }
        let more: Vec<usize> = terms.iter().flat_map(|(_, from)| columns[from].clone()).collect();
        let products = more.len();
        columns.entry(step.row).or_default().extend(more);
        forward.push((Step { row: step.row, scale, terms }, products));
    }
    let mut live = wanted.clone();
    let (mut kept, mut products) = (Vec::new(), 0);
    for (step, own) in forward.into_iter().rev() {
        if live.contains(&step.row) {
            live.extend(step.terms.iter().map(|(_, from)| *from));
            kept.push(step);
            products += own;
        }
    }
    kept.reverse();
    Needed { steps: kept, sides: live, products, columns }
}

#[cfg(test)]
mod tests {
    use super::*;
    use machinist_model::Op;
    use machinist_model::evaluate::{Evaluator, Inputs};

    /// M (diagonal but for one coupling) and G of a machine whose first two coordinates are
    /// pinned one by one, the next two together, and three left with one constraint.
    const MASS: [(usize, usize); 8] =
        [(0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5), (6, 6), (1, 4)];
    const BORDER: [&[usize]; 5] = [&[0], &[0, 1], &[1, 2, 3], &[2, 3], &[3, 4, 5]];
    const N: usize = 7;
    const SIZE: usize = N + BORDER.len();

    /// The bordered matrix in numbers, and where it is not zero. Some coordinates may have no
    /// inertia: of each block one, and two of those that are free.
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

    /// A graph whose state is the entries of the matrix, then the right side.
    fn built(is_singular: bool) -> (Graph, Substitution, Vec<NodeId>, Vec<f64>) {
        let mut graph = Graph::new();
        let zero = graph.literal(0.0);
        let matrix = numbers(is_singular);
        let mut state = matrix.as_flattened().to_vec();
        let mut entry = |i: usize, j: usize| {
            let place = (i.max(j) * SIZE + i.min(j)) as u32;
            if matrix[i][j] == 0.0 { zero } else { graph.insert(Op::State(place)) }
        };
        let nodes = (0..SIZE).map(|i| (0..SIZE).map(|j| entry(i, j)).collect()).collect();
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
        // A column for each row of right sides that is read.
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
