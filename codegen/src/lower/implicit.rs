//! Jacobians of the rate, by the factors of the mass matrix.
//!
//! ```text
//! M q'' = f + G^T lambda      M dq''/ds = df/ds - (dM/ds) q'' + ...
//! ```
//!
//! Right sides are on a tape. The solution for all columns is data for a loop.

use std::collections::{BTreeMap, BTreeSet};

use machinist_model::{NodeId, Solve, SolveStep, SparsityPattern};

use super::needed::needed;
use super::substitute::Step;

/// Number of products up to which a loop is short enough, even if many are unnecessary. A longer
/// loop has to be dense.
const SHORT: usize = 2000;

/// Fraction of the products of a loop that are of nonzeros, if it is dense.
const DENSE: [usize; 2] = [9, 10];

/// Data for the columns of a Jacobian; (row, column) of nonzeros only.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Columns {
    /// Number of columns.
    pub count: usize,
    /// Right sides of the equations of accelerations.
    pub sides: BTreeMap<(usize, usize), NodeId>,
    /// Entries that are not accelerations.
    pub given: BTreeMap<(usize, usize), NodeId>,
}

/// A Jacobian computed by solving linear equations.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Implicit {
    /// Nonzeros of the Jacobian.
    pub pattern: SparsityPattern,
    /// Given entries, then the right sides.
    pub inputs: Vec<NodeId>,
    /// Steps of the solution.
    pub steps: Vec<Step>,
    /// Products of nonzeros in all steps.
    products: usize,
    /// Number of rows, as in [`Solve`].
    rows: u32,
    columns: u32,
    given: Vec<u32>,
    right_sides: Vec<(u32, u32)>,
    solved: Vec<(u32, u32, u32)>,
}

/// Plans the solution for columns of the derivative of `rows` rates. `velocities` are the entries
/// of the state that are velocities, with their coordinates.
#[must_use]
pub fn implicit(
    columns: &Columns,
    steps: &[Step],
    velocities: &[(usize, usize)],
    rows: usize,
) -> Implicit {
    let wanted = velocities.iter().map(|(_, coordinate)| *coordinate).collect();
    let needed = needed(steps, &columns.sides.keys().copied().collect(), &wanted);
    // Right sides by column, only those that affect the result.
    let mut sides: Vec<((usize, usize), NodeId)> = columns.sides.clone().into_iter().collect();
    sides.retain(|((row, _), _)| needed.sides.contains(row));
    sides.sort_by_key(|((row, column), _)| (*column, *row));
    let used: BTreeSet<usize> = sides.iter().map(|((_, column), _)| *column).collect();
    let place: BTreeMap<usize, u32> = used.into_iter().zip(0..).collect();
    // Nonzeros of the result by row: `None` if given, else the row of the solution.
    let mut entries: BTreeMap<(usize, usize), Option<usize>> =
        columns.given.keys().map(|at| (*at, None)).collect();
    for (entry, coordinate) in velocities {
        for column in needed.columns.get(coordinate).into_iter().flatten() {
            entries.insert((*entry, *column), Some(*coordinate));
        }
    }
    let (mut given, mut solved) = (Vec::new(), Vec::new());
    for (index, ((_, column), row)) in (0..).zip(&entries) {
        match row {
            None => given.push(index),
            Some(row) => solved.push((index, *row as u32, place[column])),
        }
    }
    solved.sort_by_key(|(entry, _, column)| (*column, *entry));
    let entries = entries.keys().map(|(row, column)| (*row as u32, *column as u32)).collect();
    let largest = needed
        .steps
        .iter()
        .flat_map(|step| step.terms.iter().map(|(_, from)| *from).chain([step.row]));
    let largest = largest.chain(sides.iter().map(|((row, _), _)| *row)).max();
    Implicit {
        pattern: SparsityPattern { rows, columns: columns.count, entries },
        inputs: columns.given.values().copied().chain(sides.iter().map(|(_, n)| *n)).collect(),
        rows: largest.map_or(0, |row| row as u32 + 1),
        columns: place.len() as u32,
        given,
        right_sides: sides.iter().map(|((row, column), _)| (*row as u32, place[column])).collect(),
        solved,
        products: needed.products,
        steps: needed.steps,
    }
}

impl Implicit {
    /// Returns a Jacobian of which every nonzero is known.
    #[must_use]
    pub fn unrolled(
        nonzeros: &BTreeMap<(usize, usize), NodeId>,
        rows: usize,
        columns: usize,
    ) -> Self {
        let entries = nonzeros.keys().map(|(row, column)| (*row as u32, *column as u32)).collect();
        Implicit {
            pattern: SparsityPattern { rows, columns, entries },
            inputs: nonzeros.values().copied().collect(),
            ..Self::default()
        }
    }

    /// Reports whether a loop over all columns does little unnecessary work.
    #[must_use]
    pub fn is_worth_a_loop(&self) -> bool {
        let all: usize = self.steps.iter().map(|step| step.terms.len()).sum();
        let all = all * self.columns as usize;
        all <= SHORT || self.products * DENSE[1] >= all * DENSE[0]
    }

    /// Reports whether equations remain to be solved.
    #[must_use]
    pub fn is_solved(&self) -> bool {
        !self.solved.is_empty()
    }

    /// Returns the solution as data of a model, with indices of its factors in `factors`.
    ///
    /// # Panics
    /// If a factor is not among them.
    #[must_use]
    pub fn solve(&self, factors: &[NodeId]) -> Solve {
        let place = |factor: NodeId| {
            let place = factors.iter().position(|known| *known == factor);
            place.expect("factors are those of all steps") as u32
        };
        let terms = |step: &Step| {
            step.terms.iter().map(|(factor, from)| (place(*factor), *from as u32)).collect()
        };
        let steps = self.steps.iter().map(|step| SolveStep {
            row: step.row as u32,
            scale: step.scale.map(place),
            terms: terms(step),
        });
        Solve {
            rows: self.rows,
            columns: self.columns,
            steps: steps.collect(),
            given: self.given.clone(),
            right_sides: self.right_sides.clone(),
            solved: self.solved.clone(),
        }
    }
}
