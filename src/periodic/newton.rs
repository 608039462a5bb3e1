//! Newton's method for the equations of shooting, damped by halving steps.

use nalgebra::{DMatrix, DVector, Dyn, SVD};

use super::equations::{Guess, Linear, Problem, Step};
use super::error::CycleError;
use super::shot::Shot;

/// Maximum number of times that a step is halved.
const HALVINGS: i32 = 10;
/// Share of the decrease that Newton's step predicts, below which it is halved (Armijo).
const DECREASE: f64 = 1e-4;
/// Errors of sensitivities over the relative tolerance of a run. At 1e-11, the multipliers 1 of a
/// pendulum's family of swings were off by 1e-9.
const NOISE: f64 = 1e3;
/// Largest relative change of the period in a step.
const PERIOD_CHANGE: f64 = 0.5;

/// Solution of the equations.
pub(super) struct Solution {
    pub(super) guess: Guess,
    pub(super) shots: Vec<Shot>,
    /// Largest difference, relative.
    pub(super) residual: f64,
    pub(super) iterations: usize,
}

/// Unknowns with the runs from them.
struct Point {
    guess: Guess,
    shots: Vec<Shot>,
    linear: Linear,
}

impl Point {
    fn new(problem: &Problem<'_>, guess: Guess) -> Result<Self, CycleError> {
        let shots = problem.shots(&guess)?;
        let linear = problem.linear(&guess, &shots);
        Ok(Self { guess, shots, linear })
    }

    /// Returns whether the differences are those of the runs' own errors. An error on the way
    /// grows with the derivatives of the end.
    fn is_solved(&self, problem: &Problem<'_>) -> bool {
        let growth = self.shots.iter().map(|shot| problem.scaled(&shot.transition).norm());
        let tolerance = problem.tolerance() * growth.fold(1.0, f64::max);
        problem.largest_gap(&self.shots).0 <= tolerance
    }
}

/// An equation besides those of shooting: its value, and its slopes by the states over their
/// scales, the logarithm of the period, and the parameter over its range.
pub(super) struct Side {
    pub(super) residual: f64,
    pub(super) states: DVector<f64>,
    pub(super) period: f64,
    pub(super) value: f64,
    pub(super) range: f64,
}

/// Solves the equations from a guess.
///
/// # Errors
/// [`CycleError::NotFound`], [`CycleError::OtherMode`], and the errors of runs.
pub(super) fn solve(
    problem: &Problem<'_>,
    guess: Guess,
    most: usize,
) -> Result<Solution, CycleError> {
    solve_beside(problem, guess, most, &|_| None)
}

/// Like [`solve`], with a further equation for the parameter.
pub(super) fn solve_beside(
    problem: &Problem<'_>,
    guess: Guess,
    most: usize,
    side: &dyn Fn(&Guess) -> Option<Side>,
) -> Result<Solution, CycleError> {
    let mut point = Point::new(problem, guess)?;
    let mut is_refined = false;
    for iterations in 0..=most {
        let is_solved = point.is_solved(problem);
        if is_solved && is_refined && problem.other_mode(&point.shots).is_none() {
            let residual = problem.largest_gap(&point.shots).0;
            let Point { mut guess, shots, .. } = point;
            // Nodes on the constraints.
            for (node, shot) in guess.nodes.iter_mut().zip(&shots) {
                node.clone_from(&shot.start);
            }
            return Ok(Solution { guess, shots, residual, iterations });
        }
        if iterations == most {
            break;
        }
        let next = side(&point.guess);
        let step = newton_step(&point.linear, next.as_ref(), problem.run.relative_tolerance());
        if is_solved {
            // One more step gains the digits that the tolerance leaves open.
            is_refined = true;
            if let Ok(refined) = Point::new(problem, moved(problem, &point, &step, 1.0)) {
                let gap = |point: &Point| problem.largest_gap(&point.shots).0;
                if gap(&refined) <= gap(&point) || refined.is_solved(problem) {
                    point = refined;
                }
            }
            continue;
        }
        is_refined = false;
        match damped(problem, &point, &step, side)? {
            Some(next) => point = next,
            None => break,
        }
    }
    Err(not_found(problem, &point, most))
}

fn moved(problem: &Problem<'_>, point: &Point, step: &Step, share: f64) -> Guess {
    problem.moved(&point.guess, &point.shots, &step.times(share))
}

/// Returns the first of ever shorter steps that decreases the residual.
fn damped(
    problem: &Problem<'_>,
    point: &Point,
    step: &Step,
    side: &dyn Fn(&Guess) -> Option<Side>,
) -> Result<Option<Point>, CycleError> {
    let size = |point: &Point| {
        let beside = side(&point.guess).map_or(0.0, |side| side.residual);
        point.linear.residual.norm().hypot(beside)
    };
    let before = size(point);
    let longest = (PERIOD_CHANGE / step.period.abs()).min(1.0);
    let (mut other_modes, mut last) = (None, None);
    for halving in 0..=HALVINGS {
        let share = longest * 0.5_f64.powi(halving);
        match Point::new(problem, moved(problem, point, step, share)) {
            Ok(next) if size(&next) <= before * (1.0 - DECREASE * share) => return Ok(Some(next)),
            // In other modes the residual is another function, and may be larger at first.
            Ok(next) if other_modes.is_none() && has_other_modes(problem, point, &next) => {
                other_modes = Some(next);
            }
            Ok(_) => {}
            Err(error) if error.is_final() => return Err(error),
            Err(error) => last = Some(error),
        }
    }
    match (other_modes, last) {
        (Some(next), _) => Ok(Some(next)),
        (None, Some(error)) if error.is_of_motion() => Err(error),
        _ => Ok(None),
    }
}

fn has_other_modes(problem: &Problem<'_>, a: &Point, b: &Point) -> bool {
    let simulator = problem.run.simulator();
    let modes = |point: &Point| -> Vec<f64> {
        let starts = point.shots.iter().flat_map(|shot| shot.start.iter().enumerate());
        starts.filter(|(index, _)| simulator.is_mode(*index)).map(|(_, value)| *value).collect()
    };
    modes(a) != modes(b)
}

/// Solves the bordered linear equations by singular values: the shortest step of all where they do
/// not determine it, as in a family of motions.
fn newton_step(linear: &Linear, side: Option<&Side>, rtol: f64) -> Step {
    let n = linear.residual.len();
    let (has_period, has_side) = (linear.by_period.is_some(), side.is_some());
    let size = n + usize::from(has_period) + usize::from(has_side);
    let mut matrix = DMatrix::zeros(size, size);
    let mut right = DVector::zeros(size);
    matrix.view_mut((0, 0), (n, n)).copy_from(&linear.matrix);
    right.rows_mut(0, n).copy_from(&(-&linear.residual));
    if let Some((column, phase)) = &linear.by_period {
        matrix.view_mut((0, n), (n, 1)).copy_from(column);
        matrix.view_mut((n, 0), (1, n)).copy_from(&phase.transpose());
    }
    if let (Some(side), Some(column)) = (side, &linear.by_parameter) {
        matrix.view_mut((0, size - 1), (n, 1)).copy_from(&(column * side.range));
        matrix.view_mut((size - 1, 0), (1, n)).copy_from(&side.states.transpose());
        if has_period {
            matrix[(size - 1, n)] = side.period;
        }
        matrix[(size - 1, size - 1)] = side.value;
        right[size - 1] = -side.residual;
    }
    let solution = regularized(matrix, &right, rtol);
    Step {
        states: solution.rows(0, n).into_owned(),
        period: if has_period { solution[n] } else { 0.0 },
        value: side.map_or(0.0, |side| solution[size - 1] * side.range),
    }
}

/// Returns the least-squares solution of Newton's equations. Singular values below the size of the
/// residual are left out if the others leave at most half of it: near a family of motions, those of
/// the directions along the family vanish with the residual, and steps along them lead astray.
fn regularized(matrix: DMatrix<f64>, right: &DVector<f64>, rtol: f64) -> DVector<f64> {
    const LARGEST: f64 = 0.1;
    const LEFT: f64 = 0.5;
    let Some(factors) = Factors::new(matrix) else { return DVector::zeros(right.len()) };
    let least = NOISE * rtol;
    let short = factors.solve(right, right.norm().clamp(least, LARGEST));
    if (right - &factors.matrix * &short).norm() <= LEFT * right.norm() {
        return factors.scaled_back(short);
    }
    factors.scaled_back(factors.solve(right, least))
}

/// Returns the shortest least-squares solution. Singular values below [`NOISE`] are taken for zero.
pub(super) fn shortest(matrix: DMatrix<f64>, right: &DVector<f64>, rtol: f64) -> DVector<f64> {
    let Some(factors) = Factors::new(matrix) else { return DVector::zeros(right.len()) };
    factors.scaled_back(factors.solve(right, NOISE * rtol))
}

/// Singular values of a matrix whose columns are at most 1 long: longer ones are divided by their
/// lengths, such as that of the period where the motion is fast.
struct Factors {
    matrix: DMatrix<f64>,
    lengths: Vec<f64>,
    svd: SVD<f64, Dyn, Dyn>,
}

impl Factors {
    /// Returns nothing for a matrix that is not finite.
    fn new(mut matrix: DMatrix<f64>) -> Option<Self> {
        if matrix.iter().any(|entry| !entry.is_finite()) {
            return None;
        }
        let lengths: Vec<f64> = matrix.column_iter().map(|column| column.norm().max(1.0)).collect();
        for (index, length) in lengths.iter().enumerate() {
            matrix.column_mut(index).unscale_mut(*length);
        }
        let svd = matrix.clone().svd(true, true);
        Some(Self { matrix, lengths, svd })
    }

    /// Solves without singular values below this share of the largest.
    fn solve(&self, right: &DVector<f64>, least: f64) -> DVector<f64> {
        let least = least * self.svd.singular_values.max();
        let solution = self.svd.solve(right, least);
        solution.unwrap_or_else(|_| DVector::zeros(right.len()))
    }

    fn scaled_back(&self, mut solution: DVector<f64>) -> DVector<f64> {
        solution.iter_mut().zip(&self.lengths).for_each(|(value, length)| *value /= length);
        solution
    }
}

fn not_found(problem: &Problem<'_>, point: &Point, iterations: usize) -> CycleError {
    let simulator = problem.run.simulator();
    let scene = simulator.name().to_owned();
    let period = problem.span_of(&point.guess).1;
    if point.is_solved(problem)
        && let Some((state, from, to)) = problem.other_mode(&point.shots)
    {
        let state = simulator.state(state).name.to_owned();
        return CycleError::OtherMode { scene, period, state, from, to };
    }
    let (_, state, difference) = problem.largest_gap(&point.shots);
    let state = simulator.state(state).name.to_owned();
    CycleError::NotFound { scene, iterations, state, difference, period }
}
