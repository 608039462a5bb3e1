//! Consistent initial states from guesses.

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector, Dyn, SVD};

use super::mobility::{NOTHING, change_point, quoted, repeated_rows};
use super::{Constraints, Level, largest_of, mobility};
use crate::error::SimulateError;

/// Ratio to the largest singular value below which others count as zero.
const SMALLEST: f64 = 1e-11;

/// Returns a state that fulfils the constraints. Given entries stay unchanged; the others are
/// solved for from their guesses, by the shortest moves relative to the scales of states. If that
/// fails and given entries are off by less than the relative tolerance of the spec's run, such as
/// by their last written digit, they are projected too.
///
/// Uses the Gauss-Newton iteration with halved steps. Each step solves a least-squares problem by
/// an SVD, so neither missing nor redundant constraints stop it.
///
/// # Errors
/// [`SimulateError::ImpossibleStart`] if there is no such state nearby.
pub(crate) fn consistent(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    time: f64,
    mut state: Vec<f64>,
    is_given: &dyn Fn(usize) -> bool,
) -> Result<Vec<f64>, SimulateError> {
    let Some(constraints) = Constraints::of(simulator, parameters) else { return Ok(state) };
    for (level, what) in [(Level::Positions, "position"), (Level::Velocities, "velocity")] {
        let given = state.clone();
        let off = constraints.solve(&[], level, time, &mut state, is_given);
        if off.is_some()
            && let Some(projected) = constraints.projected(level, time, (&given, &state), is_given)
        {
            state = projected;
            continue;
        }
        if let Some(worst) = off {
            let residuals = constraints.residual(level, time, &state);
            let unit = if level == Level::Positions { "" } else { " per second" };
            let named = |index: usize| {
                let constraint = simulator.constraint(index);
                let value = residuals[index];
                format!("`{}` is {value:.3e} [{}]{unit}", constraint.name, constraint.unit)
            };
            let others = (0..constraints.count)
                .filter(|index| *index != worst && residuals[*index].abs() > 1e-12)
                .map(named);
            let others: Vec<String> = others.take(5).collect();
            let others =
                if others.is_empty() { String::new() } else { format!("; {}", others.join(", ")) };
            return Err(SimulateError::ImpossibleStart {
                scene: simulator.name().to_owned(),
                what,
                constraint: constraints.name(worst).to_owned(),
                residuals: format!("{}{others}", named(worst)),
            });
        }
    }
    Ok(state)
}

/// Returns the initial state of the spec at `time` \[s\]. Entries given in the spec stay unchanged,
/// the others fulfil the constraints.
///
/// # Errors
/// [`SimulateError::ImpossibleStart`] if there is no such state near the spec's guesses.
pub fn start(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    time: f64,
) -> Result<Vec<f64>, SimulateError> {
    let mut state = vec![0.0; simulator.shape().states()];
    simulator.initial_state(parameters, &mut state);
    consistent(simulator, parameters, time, state, &|index| simulator.is_given(index))
}

/// Linear map from residuals to moves of the entries that are not given at a start.
pub(crate) struct FreeMoves {
    /// Indices of the entries that move.
    pub(crate) entries: Vec<usize>,
    /// True if the residuals alone determine the moves.
    pub(crate) is_determined: bool,
    scales: Vec<f64>,
    weighed: SVD<f64, Dyn, Dyn>,
    /// Changes of the entries by moves of the coordinates.
    by_coordinates: DMatrix<f64>,
}

impl FreeMoves {
    /// Returns the moves, with one row for each entry and one column for each of several residuals.
    /// `residuals` contains them row by row.
    pub(crate) fn solve(&self, residuals: &[Vec<f64>]) -> DMatrix<f64> {
        let columns = residuals.first().map_or(0, Vec::len);
        let right_side = DMatrix::from_fn(residuals.len(), columns, |i, k| residuals[i][k]);
        let least = SMALLEST * self.weighed.singular_values.max().max(f64::MIN_POSITIVE);
        let mut moves = self
            .weighed
            .solve(&right_side, least)
            .unwrap_or_else(|_| DMatrix::zeros(self.scales.len(), columns));
        for (mut row, scale) in moves.row_iter_mut().zip(&self.scales) {
            row *= *scale;
        }
        &self.by_coordinates * moves
    }
}

/// Returns the moves of one level at a start; `None` if there are no free entries or no
/// constraints.
pub(crate) fn free_moves(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    level: Level,
    (time, state): (f64, &[f64]),
    is_given: &dyn Fn(usize) -> bool,
) -> Option<FreeMoves> {
    let constraints = Constraints::of(simulator, parameters)?;
    let first = constraints.first(level);
    let free = |index: &usize| !is_given(first + index);
    let free: Vec<usize> = (0..constraints.coordinates).filter(free).collect();
    let all = constraints.scales(level);
    let scales: Vec<f64> = free.iter().map(|index| all[*index]).collect();
    let matrix = constraints.matrix(time, state);
    if free.is_empty() || !matrix.iter().all(|value| value.is_finite()) {
        return None;
    }
    let of_velocities = |row: usize| !simulator.constraint(row).is_of_positions;
    let weighed = DMatrix::from_fn(constraints.count, free.len(), |row, column| {
        // Constraints of velocities alone do not restrict positions.
        let is_silent = level == Level::Positions && of_velocities(row);
        if is_silent { 0.0 } else { matrix[(row, free[column])] * scales[column] }
    });
    let weighed = weighed.svd(true, true);
    let largest = weighed.singular_values.max();
    let rank = weighed.singular_values.iter().filter(|value| **value > SMALLEST * largest).count();
    let is_determined = rank == free.len();
    let mut columns = Vec::new();
    for index in &free {
        let mut change = DVector::zeros(constraints.coordinates);
        change[*index] = 1.0;
        let moves = match level {
            Level::Positions => constraints.moves(time, state, &change),
            Level::Velocities => change.as_slice().to_vec(),
        };
        columns.push(DVector::from_vec(moves));
    }
    let all = DMatrix::from_columns(&columns);
    let moved = (0..all.nrows()).filter(|row| all.row(*row).iter().any(|entry| *entry != 0.0));
    let moved: Vec<usize> = moved.collect();
    let by_coordinates = all.select_rows(&moved);
    let entries = moved.into_iter().map(|row| first + row).collect();
    Some(FreeMoves { entries, is_determined, scales, weighed, by_coordinates })
}

/// Refuses change points, and constraints that are redundant at a state or without effect, unless the
/// motion does not depend on the distribution of forces.
///
/// # Errors
/// [`SimulateError::RedundantConstraint`] for the first one.
pub(crate) fn require_independent(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    time: f64,
    state: &[f64],
) -> Result<(), SimulateError> {
    let Some(constraints) = Constraints::of(simulator, parameters) else { return Ok(()) };
    if let Some((constraint, others)) = change_point(&constraints, time, state) {
        return Err(SimulateError::RedundantConstraint {
            scene: simulator.name().to_owned(),
            constraint,
            why: format!(
                "{} here, though not beside: the start is a change point, where branches of motion \
                 cross",
                if others.is_empty() {
                    "has no effect".to_owned()
                } else {
                    format!("depends on {}", quoted(&others))
                }
            ),
            hint: "start a little beside it, on the branch of the motion",
        });
    }
    let found = mobility(simulator, parameters, time, state);
    let mut redundant = found.into_iter().flat_map(|mobility| mobility.redundant);
    redundant.find(|redundant| !redundant.is_shared).map_or(Ok(()), |redundant| {
        Err(SimulateError::RedundantConstraint {
            scene: simulator.name().to_owned(),
            why: redundant.why(),
            hint: redundant.hint(),
            constraint: redundant.constraint,
        })
    })
}

impl Constraints<'_> {
    /// Returns the state nearest to `near` that fulfils one level, if given entries move by no more
    /// than the tolerance of the spec's run.
    fn projected(
        &self,
        level: Level,
        time: f64,
        (given, near): (&[f64], &[f64]),
        is_given: &dyn Fn(usize) -> bool,
    ) -> Option<Vec<f64>> {
        let mut state = near.to_vec();
        if self.solve(&[], level, time, &mut state, &|_| false).is_some() {
            return None;
        }
        let (first, rtol) = (self.first(level), self.simulator.run_defaults().rtol);
        let scales = self.scales(level);
        let is_near = |(index, scale): (usize, &f64)| {
            let entry = first + index;
            let size = scale.max(given[entry].abs());
            !is_given(entry) || (state[entry] - given[entry]).abs() <= rtol * size
        };
        scales.iter().enumerate().all(is_near).then_some(state)
    }

    /// Returns the state near `state` that fulfils all constraints except those of some rows; `None`
    /// if there is none.
    pub(super) fn fulfilled_but(
        &self,
        without: &[usize],
        time: f64,
        state: &[f64],
    ) -> Option<Vec<f64>> {
        let mut state = state.to_vec();
        let mut levels = [Level::Positions, Level::Velocities].into_iter();
        levels
            .all(|level| self.solve(without, level, time, &mut state, &|_| false).is_none())
            .then_some(state)
    }

    /// Returns whether a state fulfils one constraint, to the accuracy at which rows of G count as
    /// dependent.
    pub(super) fn is_fulfilled(&self, row: usize, time: f64, state: &[f64]) -> bool {
        let slopes = self.slopes(time, state);
        [Level::Positions, Level::Velocities].into_iter().all(|level| {
            let residual = self.residual(level, time, state);
            self.off_by(level, &slopes, &residual, state)[row] <= NOTHING
        })
    }

    /// Returns how far constraints are off, relative to the effects of their coordinates. Rounding of
    /// terms as large as the largest effect does not count: the distance of a linkage from its plane
    /// is a difference of positions in it.
    fn off_by(
        &self,
        level: Level,
        slopes: &[f64],
        residual: &DVector<f64>,
        state: &[f64],
    ) -> Vec<f64> {
        self.relative_beyond([NOTHING, f64::EPSILON], level, slopes, residual, state)
    }

    /// Solves one level of all constraints except those of some rows; returns the constraint with
    /// the largest residual if that fails.
    fn solve(
        &self,
        without: &[usize],
        level: Level,
        time: f64,
        state: &mut [f64],
        is_given: &dyn Fn(usize) -> bool,
    ) -> Option<usize> {
        const ROUNDS: usize = 200;
        const HALVINGS: usize = 30;
        let first = self.first(level);
        let free: Vec<usize> =
            (0..self.coordinates).filter(|index| !is_given(first + index)).collect();
        let scales = self.scales(level);
        let others = |state: &[f64]| {
            let mut residual = self.residual(level, time, state);
            for row in without {
                residual[*row] = 0.0;
            }
            residual
        };
        let mut residual = others(state);
        for _ in 0..ROUNDS {
            let slopes = self.slopes(time, state);
            self.worst(level, &slopes, &residual, state)?;
            let mut matrix = self.filled(&slopes);
            for row in without {
                matrix.row_mut(*row).fill(0.0);
            }
            let weighed = DMatrix::from_fn(self.count, free.len(), |row, column| {
                matrix[(row, free[column])] * scales[free[column]]
            });
            let Some(step) = least_squares(&weighed, &residual) else { break };
            let start = state.to_vec();
            let before = residual.norm();
            let mut share = 1.0;
            let mut improved = false;
            for _ in 0..HALVINGS {
                let mut change = DVector::zeros(self.coordinates);
                for (index, step) in free.iter().zip(step.iter()) {
                    change[*index] = -share * scales[*index] * step;
                }
                state.copy_from_slice(&start);
                self.shift(level, time, state, &change);
                residual = others(state);
                if residual.norm() < before {
                    improved = true;
                    break;
                }
                share *= 0.5;
            }
            if !improved {
                state.copy_from_slice(&start);
                residual = others(state);
                break;
            }
        }
        let slopes = self.slopes(time, state);
        let worst = self.worst(level, &slopes, &residual, state)?;
        // Redundant constraints of files agree no better than their numbers are rounded.
        let off = self.off_by(level, &slopes, &residual, state)[worst];
        let agrees = off <= NOTHING && !repeated_rows(self, &self.filled(&slopes)).is_empty();
        (!agrees).then_some(worst)
    }

    /// Returns the constraint with the largest residual beyond rounding.
    fn worst(
        &self,
        level: Level,
        slopes: &[f64],
        residual: &DVector<f64>,
        state: &[f64],
    ) -> Option<usize> {
        const ROUNDING: f64 = 1e-13;
        let off = self.off_by(level, slopes, residual, state);
        let worst = largest_of(&off);
        if worst <= ROUNDING {
            return None;
        }
        off.iter().position(|off| off.is_nan() || *off >= worst)
    }
}

/// Returns the shortest x that minimizes |A x - b|.
fn least_squares(matrix: &DMatrix<f64>, right_side: &DVector<f64>) -> Option<DVector<f64>> {
    if matrix.ncols() == 0 || !matrix.iter().all(|value| value.is_finite()) {
        return None;
    }
    let svd = matrix.clone().svd(true, true);
    let largest = svd.singular_values.max();
    svd.solve(right_side, SMALLEST * largest.max(f64::MIN_POSITIVE)).ok()
}
