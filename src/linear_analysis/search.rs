//! Search for an equilibrium: by Newton's method or, if that fails, along the way on which the
//! machine would creep to rest.

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector, Dyn, SVD};

use super::banded::LeastSquares;
use super::sparse_rows::SparseRows;
use super::{LinearError, Point, full};

const MAX_ITERATIONS: usize = 100;
const MAX_HALVINGS: usize = 40;
/// Rate, relative to the size of its row, below which it is zero.
pub(super) const ACCEPTED: f64 = 1e-9;
/// Size of residuals below which nothing can be gained.
const ROUNDING: f64 = 1e-15;
/// Singular values below this, for matrices with rows of length 1, count as zero.
pub(super) const RANK: f64 = 1e-10;
/// Maximum number of steps of a creep.
const MAX_CREEPS: usize = 400;
/// Maximum length of the first step, in scales of the unknowns.
const FIRST_REACH: f64 = 0.1;
/// Size of residuals below which Newton's method takes over from a creep.
const NEAR: f64 = 1e-6;
/// Fraction of the scale above which changes of named entries count.
const SEEN: f64 = 1e-9;

/// Rates at a point that are zero in equilibrium, each divided by the size of its row, and their
/// derivatives by the unknowns of the search: positions, speeds of drift, first-order states.
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

/// A machine with the unknowns of its equilibrium.
pub(super) trait Balance {
    /// Motions at a point.
    type Frame;

    /// Returns the simulator.
    fn simulator(&self) -> &dyn Simulator<f64>;

    fn equations(&self, point: &Point) -> Result<Equations<Self::Frame>, LinearError>;
    /// Returns the norm of the residuals at another point, as far as they are comparable with those
    /// of the frame.
    fn length_at(&self, point: &Point, frame: &Self::Frame) -> Result<f64, LinearError>;
    /// Converts a small change of the unknowns to one of the state.
    fn unfolded(&self, frame: &Self::Frame, step: &DVector<f64>) -> DVector<f64>;
    /// Converts rates y' to residuals.
    fn measured(&self, frame: &Self::Frame, rates: &DVector<f64>) -> DVector<f64>;
    /// Removes velocities across drift from a change of the state.
    fn keep_drift(&self, frame: &Self::Frame, change: &mut DVector<f64>);
    /// Returns the point after a change of its unknowns.
    fn moved(
        &self,
        point: &Point,
        frame: &Self::Frame,
        step: &DVector<f64>,
    ) -> Result<Point, LinearError>;
    /// Returns the derivatives of named entries of the state by the unknowns, over their scales.
    fn named(&self, frame: &Self::Frame) -> DMatrix<f64>;
    /// Returns B and the number of its columns that are positions. B x'' for positions, and B x'
    /// for the others, is the residual that would move the unknowns by x without damping and
    /// without other inertia.
    fn creep(&self, frame: &Self::Frame) -> (DMatrix<f64>, usize);
    /// Returns the point if its rates are zero.
    fn accepted(&self, point: Point) -> Result<Point, LinearError>;
}

/// Solves by Newton's method, with steps halved until the rates decrease.
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

/// Returns the point after the longest of the steps 1, 1/2, 1/4, ... that decreases the rates;
/// `None` if none does.
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
        // NaN is not smaller; a failed projection means that the step is too long.
        if let Ok(next) = balance.moved(point, &equations.frame, &(&step * share))
            && balance.length_at(&next, &equations.frame)? < length
        {
            return Ok(Some(next));
        }
        share /= 2.0;
    }
    Ok(None)
}

/// Least-squares steps x of J x = r. If they are not unique, the step moves named entries least,
/// and is the shortest of these.
pub(super) enum LeastSteps {
    /// Singular value decomposition.
    Full { svd: SVD<f64, Dyn, Dyn>, named: DMatrix<f64>, rank: usize },
    /// Sparse solution if nothing is named and rates depend on few unknowns each.
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

    /// Returns whether the step is unique.
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
        // Directions that the equations leave open may compensate moves of named entries.
        let decided = rows.rows(0, rank);
        let size = step.len();
        let left_open = DMatrix::identity(size, size) - decided.transpose() * decided;
        let open = (named * &left_open).svd(true, true);
        let back = open.solve(&moved, RANK.sqrt()).map_err(|_| SINGULAR)?;
        Ok(step - left_open * back)
    }
}

const SINGULAR: LinearError = LinearError::Singular { what: "the Jacobian of the equilibrium" };

/// Follows the way to rest by pseudo-transient continuation. Positions follow their accelerating
/// forces, speeds of drift and first-order states their rates, by implicit Euler steps that grow to
/// Newton's steps. `settle` corrects modes after each step and returns whether it changed any; the
/// search then has to begin anew from `point`.
///
/// An equilibrium found in this way is stable in this sense, and lies downhill of the guess.
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
        // With positive feedback of rates, long steps would lead back.
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

/// Result of a creep.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Crept {
    /// Rates are small.
    Near,
    /// Modes have changed on the way.
    Switched,
    /// The creep does not end.
    Nowhere,
}

/// Returns a part of the time in which the fastest unknown would move by its scale \[s\].
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

/// Returns the smallest solution of (B/pace^2 - J) x = r, and whether it follows the rates; `None`
/// if there is no solution.
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
