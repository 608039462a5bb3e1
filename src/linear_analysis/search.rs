//! How an equilibrium is looked for: by Newton's method, and where that finds none, along the
//! way on which the machine would creep to rest.

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector, Dyn, SVD};

use super::banded::LeastSquares;
use super::sparse_rows::SparseRows;
use super::{LinearError, Point, full};

const MAX_ITERATIONS: usize = 100;
const MAX_HALVINGS: usize = 40;
/// Relative to the size of its row, a rate below this is zero.
pub(super) const ACCEPTED: f64 = 1e-9;
/// Below this nothing is left to gain.
const ROUNDING: f64 = 1e-15;
/// Singular values below this, of matrices with rows of length 1, count as zero.
pub(super) const RANK: f64 = 1e-10;
/// Steps of a creep.
const MAX_CREEPS: usize = 400;
/// How far the first of them goes at most, in scales of what moves.
const FIRST_REACH: f64 = 0.1;
/// Below this a creep is near enough for Newton's method.
const NEAR: f64 = 1e-6;
/// Changes of what is named above this share of its scale count.
const SEEN: f64 = 1e-9;

/// Rates at a point that are zero in equilibrium, each divided by the size of its row, and how
/// they change with what a search may move: positions, speeds of drift, first-order states.
pub(super) struct Equations<F> {
    pub frame: F,
    pub residual: DVector<f64>,
    pub jacobian: SparseRows,
}

impl<F> Equations<F> {
    pub fn size(&self) -> f64 {
        if self.residual.is_empty() { 0.0 } else { self.residual.amax() }
    }
}

/// A machine in the unknowns of its equilibrium.
pub(super) trait Balance {
    /// What moves at a point, and how.
    type Frame;

    /// What is looked at.
    fn simulator(&self) -> &dyn Simulator<f64>;

    fn equations(&self, point: &Point) -> Result<Equations<Self::Frame>, LinearError>;
    /// Length of the residuals at another point, as far as they can be compared with those of
    /// the frame.
    fn length_at(&self, point: &Point, frame: &Self::Frame) -> Result<f64, LinearError>;
    /// What a small change of the unknowns does to the state.
    fn unfolded(&self, frame: &Self::Frame, step: &DVector<f64>) -> DVector<f64>;
    /// Rates y' as residuals.
    fn measured(&self, frame: &Self::Frame, rates: &DVector<f64>) -> DVector<f64>;
    /// Takes velocities that are no drift from a change of the state.
    fn keep_drift(&self, frame: &Self::Frame, change: &mut DVector<f64>);
    /// The point with its unknowns changed.
    fn moved(
        &self,
        point: &Point,
        frame: &Self::Frame,
        step: &DVector<f64>,
    ) -> Result<Point, LinearError>;
    /// How named entries of the state follow the unknowns, over their scales.
    fn named(&self, frame: &Self::Frame) -> DMatrix<f64>;
    /// B and the number of its columns that are positions: B x'' of positions, B x' of the
    /// others, is the residual that would move the unknowns so, without damping or inertia of
    /// anything else.
    fn creep(&self, frame: &Self::Frame) -> (DMatrix<f64>, usize);
    /// The point, if rates are zero there.
    fn accepted(&self, point: Point) -> Result<Point, LinearError>;
}

/// Newton's method, with steps halved until the rates shrink.
pub(super) fn newton(balance: &impl Balance, guess: Point) -> Result<Point, LinearError> {
    let mut point = guess;
    for _ in 0..MAX_ITERATIONS {
        let equations = balance.equations(&point)?;
        if equations.size() <= ROUNDING {
            break;
        }
        match shrinking_step(balance, &point, &equations)? {
            Some(next) => point = next,
            None => break,
        }
    }
    balance.accepted(point)
}

/// The point after the longest of the steps 1, 1/2, 1/4, ... that shrinks the rates; nothing
/// if none does.
fn shrinking_step<B: Balance>(
    balance: &B,
    point: &Point,
    equations: &Equations<B::Frame>,
) -> Result<Option<Point>, LinearError> {
    let least = LeastSteps::new(balance, equations)?;
    let step = least.solve(&-&equations.residual)?;
    let length = equations.residual.norm();
    let mut share = 1.0;
    for _ in 0..MAX_HALVINGS {
        // NaN is no less, and what does not come back is too far.
        if let Ok(next) = balance.moved(point, &equations.frame, &(&step * share))
            && balance.length_at(&next, &equations.frame)? < length
        {
            return Ok(Some(next));
        }
        share /= 2.0;
    }
    Ok(None)
}

/// Steps x that solve J x = r, or come nearest to it. Of those that do, one that moves what is
/// named least, and of these the least.
pub(super) enum LeastSteps {
    /// By singular values.
    Full { svd: SVD<f64, Dyn, Dyn>, named: DMatrix<f64>, rank: usize },
    /// Where nothing is named and rates depend on few unknowns each.
    Sparse(LeastSquares),
}

impl LeastSteps {
    pub(super) fn new<B: Balance>(
        balance: &B,
        equations: &Equations<B::Frame>,
    ) -> Result<Self, LinearError> {
        let named = balance.named(&equations.frame);
        if named.nrows() == 0
            && let Some(sparse) = LeastSquares::new(&equations.jacobian, RANK)
        {
            return Ok(Self::Sparse(sparse));
        }
        let jacobian = full(balance.simulator(), &equations.jacobian)?;
        let svd = jacobian.try_svd(true, true, f64::EPSILON, 10_000).ok_or(SINGULAR)?;
        let rank = svd.rank(RANK);
        Ok(Self::Full { svd, named, rank })
    }

    /// Whether the equations leave no choice.
    pub(super) fn is_determined(&self) -> bool {
        match self {
            Self::Full { named, rank, .. } => named.ncols() == *rank,
            Self::Sparse(sparse) => sparse.is_determined(),
        }
    }

    pub(super) fn solve(&self, right_side: &DVector<f64>) -> Result<DVector<f64>, LinearError> {
        let (svd, named, rank) = match self {
            Self::Full { svd, named, rank } => (svd, named, *rank),
            Self::Sparse(sparse) => return sparse.solve(right_side).ok_or(SINGULAR),
        };
        let step = svd.solve(right_side, RANK).map_err(|_| SINGULAR)?;
        let moved = named * &step;
        let is_seen = moved.iter().any(|moved| moved.abs() > SEEN * step.amax());
        let Some(rows) = svd.v_t.as_ref().filter(|_| is_seen && !self.is_determined()) else {
            return Ok(step);
        };
        // What the equations leave open may make up for moves of what is named.
        let decided = rows.rows(0, rank);
        let size = step.len();
        let left_open = DMatrix::identity(size, size) - decided.transpose() * decided;
        let open = (named * &left_open).svd(true, true);
        let back = open.solve(&moved, RANK.sqrt()).map_err(|_| SINGULAR)?;
        Ok(step - left_open * back)
    }
}

const SINGULAR: LinearError = LinearError::Singular { what: "the Jacobian of the equilibrium" };

/// Follows the way to rest: pseudo-transient continuation. Positions move with what would
/// accelerate them, speeds of drift and first-order states with their rates, by implicit Euler
/// steps that grow into Newton's. `settle` sets modes right after each step and says whether it
/// changed any: then the search has to begin anew from there, with what has become of the point.
///
/// An equilibrium that it finds is stable in this sense, and lies downhill of the guess.
pub(super) fn creep<B: Balance>(
    balance: &B,
    point: &mut Point,
    settle: &dyn Fn(&mut Point) -> Result<bool, LinearError>,
) -> Result<Crept, LinearError> {
    let mut equations = balance.equations(point)?;
    let slowest = first_pace(balance, &equations);
    let (mut pace, mut reach) = (slowest, FIRST_REACH);
    for _ in 0..MAX_CREEPS {
        if equations.size() <= NEAR {
            return Ok(Crept::Near);
        }
        let found = creeping_step(balance, &equations, (pace, reach));
        // Where rates feed themselves, long steps would go back.
        let found = found.filter(|(_, follows)| *follows || pace <= slowest);
        let Some((step, _)) = found else {
            pace /= 4.0;
            continue;
        };
        let next = balance.moved(point, &equations.frame, &step);
        let next = next.and_then(|next| Ok((balance.equations(&next)?, next)));
        let Ok((after, next)) = next else {
            (pace, reach) = (pace / 10.0, reach / 10.0);
            continue;
        };
        let grows = after.residual.norm() > 2.0 * equations.residual.norm();
        let change = if grows { 0.5 } else { 2.0 };
        (pace, reach) = (pace * change, reach * change);
        *point = next;
        equations = after;
        if settle(point)? {
            return Ok(Crept::Switched);
        }
    }
    Ok(Crept::Nowhere)
}

/// What a creep has come to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Crept {
    /// Rates are small.
    Near,
    /// Modes have changed on the way.
    Switched,
    /// It goes on and on.
    Nowhere,
}

/// A part of the time in which the fastest of what moves would move by its scale \[s\].
fn first_pace<B: Balance>(balance: &B, equations: &Equations<B::Frame>) -> f64 {
    const PART: f64 = 0.5;
    let (matrix, positions) = balance.creep(&equations.frame);
    let time = |row: usize| {
        let of_positions = matrix.view((row, 0), (1, positions)).norm();
        let of_others = matrix.view((row, positions), (1, matrix.ncols() - positions)).norm();
        of_positions.sqrt().max(of_others)
    };
    let times = (0..matrix.nrows()).map(time).filter(|time| *time > 0.0);
    let least = times.fold(f64::INFINITY, f64::min);
    if least.is_finite() { PART * least } else { 1.0 }
}

/// (B/pace^2 - J) x = r, the least x where it leaves some open, and whether it goes where the
/// rates point; nothing where it has none.
fn creeping_step<B: Balance>(
    balance: &B,
    equations: &Equations<B::Frame>,
    (pace, reach): (f64, f64),
) -> Option<(DVector<f64>, bool)> {
    let (mut matrix, positions) = balance.creep(&equations.frame);
    let pull = matrix.transpose() * &equations.residual;
    for (index, mut column) in matrix.column_iter_mut().enumerate() {
        column /= if index < positions { pace * pace } else { pace };
    }
    matrix -= equations.jacobian.full();
    let step = if matrix.is_square() {
        matrix.lu().solve(&equations.residual)?
    } else {
        let transposed = matrix.transpose();
        &transposed * (matrix * &transposed).lu().solve(&equations.residual)?
    };
    let longest = step.amax();
    let share = if longest > reach { reach / longest } else { 1.0 };
    let follows = pull.dot(&step) >= 0.0;
    longest.is_finite().then(|| (step * share, follows))
}
