//! How many ways of moving constraints leave, and which of them are one too many.

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector};

use super::{Constraints, Level};

/// Ways of moving of a constrained machine.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mobility {
    /// Coordinates, n.
    pub coordinates: usize,
    /// Constraints, m, of those that hold in the modes of the state.
    pub constraints: usize,
    /// How many of the constraints are independent: the rank of G.
    pub rank: usize,
    /// The others.
    pub redundant: Vec<Redundant>,
}

/// A constraint that follows from others.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Redundant {
    /// Its name.
    pub constraint: String,
    /// Names of those it follows from; none if no coordinate can change it.
    pub repeats: Vec<String>,
}

impl Mobility {
    /// n less the rank.
    #[must_use]
    pub fn by_rank(&self) -> usize {
        self.coordinates - self.rank
    }

    /// Gruebler's count, n - m; below zero for a machine with more constraints than
    /// coordinates.
    #[must_use]
    pub fn by_count(&self) -> i64 {
        self.coordinates as i64 - self.constraints as i64
    }
}

impl Redundant {
    /// What is wrong with it, for people.
    #[must_use]
    pub fn why(&self) -> String {
        if self.repeats.is_empty() {
            return "does not change with any coordinate".to_owned();
        }
        let names = self.repeats.iter().map(|name| format!("`{name}`"));
        format!("says nothing that is new beside {}", names.collect::<Vec<_>>().join(", "))
    }
}

/// The mobility of a simulator at a state, \[q, q', z\]; nothing if it has no
/// constraints.
#[must_use]
pub fn mobility(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    time: f64,
    state: &[f64],
) -> Option<Mobility> {
    let constraints = Constraints::of(simulator, parameters)?;
    let matrix = constraints.matrix(time, state);
    let (rank, redundant) = independent_rows(&constraints, &matrix);
    let (coordinates, constraints) = (constraints.coordinates, rank + redundant.len());
    Some(Mobility { coordinates, constraints, rank, redundant })
}

/// The rank of G, by taking its rows one after another in the order of the spec, each
/// less its parts along those before it; and the rows of which nothing is left.
pub(super) fn independent_rows(
    constraints: &Constraints<'_>,
    matrix: &DMatrix<f64>,
) -> (usize, Vec<Redundant>) {
    /// What is left of a row of length 1 by rounding, and more.
    const NOTHING: f64 = 1e-9;
    let scales = constraints.scales(Level::Positions);
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let mut kept: Vec<(usize, DVector<f64>)> = Vec::new();
    let mut redundant = Vec::new();
    for row in 0..constraints.count {
        let mut line = DVector::from_fn(scales.len(), |i, _| matrix[(row, i)] * scales[i]);
        let length = line.norm();
        if length == 0.0 && constraints.simulator.constraint(row).in_modes {
            continue;
        }
        if length > 0.0 {
            line /= length;
        }
        let mut left = line.clone();
        // Twice is enough (Kahan).
        for _ in 0..2 {
            for direction in &basis {
                left -= direction * direction.dot(&left);
            }
        }
        let rest = left.norm();
        if rest > NOTHING {
            basis.push(left / rest);
            kept.push((row, line));
        } else {
            let constraint = constraints.name(row).to_owned();
            let repeats = sources(constraints, &kept, &line);
            redundant.push(Redundant { constraint, repeats });
        }
    }
    (basis.len(), redundant)
}

/// The rows of which a row is made.
fn sources(
    constraints: &Constraints<'_>,
    kept: &[(usize, DVector<f64>)],
    line: &DVector<f64>,
) -> Vec<String> {
    const SHARE: f64 = 1e-6;
    if kept.is_empty() || line.norm() == 0.0 {
        return Vec::new();
    }
    let columns: Vec<DVector<f64>> = kept.iter().map(|(_, row)| row.clone()).collect();
    let matrix = DMatrix::from_columns(&columns);
    let Ok(shares) = matrix.svd(true, true).solve(line, 1e-12) else { return Vec::new() };
    let made_of = kept.iter().zip(shares.iter()).filter(|(_, share)| share.abs() > SHARE);
    made_of.map(|((row, _), _)| constraints.name(*row).to_owned()).collect()
}
