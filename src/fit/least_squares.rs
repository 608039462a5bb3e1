//! Nonlinear least squares within bounds by the Levenberg-Marquardt method.
//!
//! ```text
//! min 1/2 sum rho(r_i(u)),   lower <= u <= upper
//! (J^T W J + lambda D^2) step = -J^T W r
//! ```
//!
//! D contains the largest columns of J so far (J. J. Moré, The Levenberg-Marquardt algorithm,
//! 1978). The step follows from a QR factorization of J over sqrt(lambda) D, without the unknowns
//! that the gradient holds at a bound. lambda depends on how well the last step met its prediction
//! (H. B. Nielsen, 1999). A point that cannot be evaluated counts as a step that was too long.

use std::sync::atomic::{AtomicBool, Ordering};

use nalgebra::{DMatrix, DVector};

use super::Bounds;

/// Residuals and their derivatives, one row per residual.
#[derive(Debug, Clone)]
pub struct Evaluation {
    /// Residuals r.
    pub residuals: DVector<f64>,
    /// Jacobian dr/du.
    pub jacobian: DMatrix<f64>,
}

/// Loss as a function of a residual.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Loss {
    /// r^2.
    Squares,
    /// r^2 up to this size, linear beyond (P. J. Huber, 1964).
    Huber(f64),
}

impl Loss {
    /// Returns 1/2 rho.
    fn cost(self, r: f64) -> f64 {
        match self {
            Self::Huber(size) if r.abs() > size => size * (r.abs() - 0.5 * size),
            _ => 0.5 * r * r,
        }
    }

    /// Returns the weight of a residual in a sum of squares.
    #[must_use]
    pub fn weight(self, r: f64) -> f64 {
        match self {
            Self::Huber(size) if r.abs() > size => size / r.abs(),
            _ => 1.0,
        }
    }
}

/// Settings of a search.
#[derive(Debug, Clone, Copy)]
pub struct Search<'a> {
    /// Lower and upper bound of each unknown; infinite where there is none.
    pub bounds: &'a [Bounds],
    /// Loss as a function of a residual.
    pub loss: Loss,
    /// Maximum number of steps.
    pub most: usize,
    /// Flag that ends the search at its current point.
    pub interrupt: Option<&'a AtomicBool>,
}

/// Reason for the end of a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// The minimum is reached.
    Converged,
    /// The maximum number of steps is reached.
    Steps,
    /// The search was interrupted.
    Interrupted,
    /// No step improves the cost although the gradient does not vanish: the residuals are not
    /// smooth, or less exact than requested.
    Stuck,
}

/// End of a search.
#[derive(Debug, Clone)]
pub struct Found {
    /// Unknowns u.
    pub at: Vec<f64>,
    /// Evaluation at this point.
    pub evaluation: Evaluation,
    /// Cost, 1/2 sum rho.
    pub cost: f64,
    /// Number of steps tried.
    pub steps: usize,
    /// Reason for the end.
    pub end: End,
    /// Number of points that could not be evaluated, and the reason for the first.
    pub failed: (usize, Option<String>),
}

/// Cosine of the angle between gradient and residuals below which the gradient counts as zero.
const GRADIENT: f64 = 1e-10;
/// Relative gain in cost below which the search has converged.
const GAIN: f64 = 1e-13;

/// Predicted relative gain below which a failing step ends the search: evaluations are not more
/// exact, and unknowns are converged to a small part of their errors.
const FAINT: f64 = 1e-6;

/// Minimizes the sum of losses from `start`.
///
/// # Errors
/// The reason why the start cannot be evaluated.
pub fn least_squares(
    mut evaluate: impl FnMut(&[f64]) -> Result<Evaluation, String>,
    start: &[f64],
    search: &Search<'_>,
) -> Result<Found, String> {
    let clipped = |at: Vec<f64>| -> Vec<f64> {
        at.into_iter()
            .zip(search.bounds)
            .map(|(u, bounds)| u.clamp(bounds.low, bounds.high))
            .collect()
    };
    let at = clipped(start.to_vec());
    let evaluation = evaluate(&at)?;
    let cost = cost_of(&evaluation, search.loss);
    let (end, failed) = (End::Steps, (0, None));
    let mut found = Found { at, evaluation, cost, steps: 0, end, failed };
    let (mut lambda, mut growth) = (1e-3, 2.0);
    let mut sizes = vec![0.0_f64; found.at.len()];
    while found.steps < search.most {
        if search.interrupt.is_some_and(|flag| flag.load(Ordering::Relaxed)) {
            found.end = End::Interrupted;
            return Ok(found);
        }
        let (jacobian, residuals) = weighed(&found.evaluation, search.loss);
        for (size, column) in sizes.iter_mut().zip(jacobian.column_iter()) {
            *size = size.max(column.norm());
        }
        let gradient = jacobian.tr_mul(&residuals);
        let free = free(&found.at, &gradient, search.bounds);
        let is_flat = free.iter().all(|&k| {
            let size = jacobian.column(k).norm() * residuals.norm();
            gradient[k].abs() <= GRADIENT * size
        });
        if is_flat || found.cost == 0.0 {
            found.end = End::Converged;
            return Ok(found);
        }
        let room: Vec<(f64, f64)> = found
            .at
            .iter()
            .zip(search.bounds)
            .map(|(u, Bounds { low, high })| (low - u, high - u))
            .collect();
        let damping = (lambda, &sizes[..]);
        let Some((step, is_cut)) = bounded_step(&jacobian, &residuals, free, damping, &room) else {
            found.end = End::Stuck;
            return Ok(found);
        };
        let ahead = clipped(found.at.iter().zip(&step).map(|(u, step)| u + step).collect());
        let moved = DVector::from_fn(ahead.len(), |k, _| ahead[k] - found.at[k]);
        let foretold =
            0.5 * (residuals.norm_squared() - (&residuals + &jacobian * &moved).norm_squared());
        let is_still = moved.iter().zip(&found.at).all(|(m, u)| m.abs() <= 1e-15 * u.abs());
        if is_still || foretold <= GAIN * found.cost && lambda <= 1.0 && !is_cut {
            // The remaining gain is less than the accuracy of evaluations.
            found.end = if lambda <= 1.0 { End::Converged } else { End::Stuck };
            return Ok(found);
        }
        if foretold <= 0.0 {
            // The step was cut by bounds and leads uphill, or is damped to nothing.
            lambda *= growth;
            growth *= 2.0;
            continue;
        }
        found.steps += 1;
        let tried = evaluate(&ahead);
        if tried.is_err() && search.interrupt.is_some_and(|flag| flag.load(Ordering::Relaxed)) {
            found.end = End::Interrupted;
            return Ok(found);
        }
        let better = match tried {
            Ok(evaluation) => {
                let cost = cost_of(&evaluation, search.loss);
                let share = (found.cost - cost) / foretold;
                (share > 1e-4 && cost.is_finite()).then_some((evaluation, cost, share))
            }
            Err(why) => {
                found.failed.0 += 1;
                found.failed.1.get_or_insert(why);
                None
            }
        };
        if let Some((evaluation, cost, share)) = better {
            (found.at, found.evaluation, found.cost) = (ahead, evaluation, cost);
            let bend = 2.0 * share - 1.0;
            lambda = (lambda * (1.0 - bend.powi(3)).max(1.0 / 9.0)).max(1e-15);
            growth = 2.0;
        } else if foretold <= FAINT * found.cost && !is_cut {
            found.end = End::Converged;
            return Ok(found);
        } else {
            lambda *= growth;
            growth *= 2.0;
            if lambda > 1e16 {
                found.end = End::Stuck;
                return Ok(found);
            }
        }
    }
    Ok(found)
}

fn cost_of(evaluation: &Evaluation, loss: Loss) -> f64 {
    evaluation.residuals.iter().map(|r| loss.cost(*r)).sum()
}

/// Returns J and r, with each row multiplied by the root of its weight.
pub(super) fn weighed(evaluation: &Evaluation, loss: Loss) -> (DMatrix<f64>, DVector<f64>) {
    let Evaluation { residuals, jacobian } = evaluation;
    let (mut jacobian, mut weighed) = (jacobian.clone(), residuals.clone());
    if loss != Loss::Squares {
        for (row, r) in residuals.iter().enumerate() {
            let root = loss.weight(*r).sqrt();
            weighed[row] *= root;
            jacobian.row_mut(row).scale_mut(root);
        }
    }
    (jacobian, weighed)
}

/// Returns the unknowns that the gradient does not hold at a bound.
fn free(at: &[f64], gradient: &DVector<f64>, bounds: &[Bounds]) -> Vec<usize> {
    let is_held = |k: &usize| {
        let Bounds { low, high } = bounds[*k];
        at[*k] <= low && gradient[*k] > 0.0 || at[*k] >= high && gradient[*k] < 0.0
    };
    (0..at.len()).filter(|k| !is_held(k)).collect()
}

/// Computes the damped step of free unknowns within their bounds, and whether bounds cut it.
/// Unknowns that would leave their bounds stop there, and the others minimize the rest.
fn bounded_step(
    jacobian: &DMatrix<f64>,
    residuals: &DVector<f64>,
    mut free: Vec<usize>,
    damping: (f64, &[f64]),
    room: &[(f64, f64)],
) -> Option<(Vec<f64>, bool)> {
    let mut residuals = residuals.clone();
    let mut step = vec![0.0; jacobian.ncols()];
    let mut is_cut = false;
    loop {
        let found = damped_step(jacobian, &residuals, &free, damping)?;
        let leaves = |k: &usize| found[*k] < room[*k].0 || found[*k] > room[*k].1;
        let (out, within): (Vec<usize>, Vec<usize>) = free.into_iter().partition(leaves);
        if out.is_empty() {
            for k in within {
                step[k] = found[k];
            }
            return Some((step, is_cut));
        }
        for k in out {
            step[k] = found[k].clamp(room[k].0, room[k].1);
            residuals += jacobian.column(k) * step[k];
        }
        (free, is_cut) = (within, true);
    }
}

fn damped_step(
    jacobian: &DMatrix<f64>,
    residuals: &DVector<f64>,
    free: &[usize],
    (lambda, sizes): (f64, &[f64]),
) -> Option<Vec<f64>> {
    let (rows, count) = (jacobian.nrows(), free.len());
    if count == 0 {
        return Some(vec![0.0; jacobian.ncols()]);
    }
    let mut matrix = DMatrix::zeros(rows + count, count);
    let mut right_side = DVector::zeros(rows + count);
    right_side.rows_mut(0, rows).copy_from(residuals);
    for (column, &k) in free.iter().enumerate() {
        matrix.view_mut((0, column), (rows, 1)).copy_from(&jacobian.column(k));
        // An unknown without effect stays unchanged.
        let size = if sizes[k] > 0.0 { sizes[k] } else { 1.0 };
        matrix[(rows + column, column)] = lambda.sqrt() * size;
    }
    let qr = matrix.qr();
    qr.q_tr_mul(&mut right_side);
    let solution = qr.r().solve_upper_triangular(&right_side.rows(0, count).into_owned())?;
    let mut step = vec![0.0; jacobian.ncols()];
    for (&k, value) in free.iter().zip(solution.iter()) {
        step[k] = -value;
    }
    step.iter().all(|value| value.is_finite()).then_some(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FREE: Bounds = Bounds::NONE;

    fn search(bounds: &[Bounds]) -> Search<'_> {
        Search { bounds, loss: Loss::Squares, most: 200, interrupt: None }
    }

    /// H. H. Rosenbrock's valley, with his start.
    #[allow(clippy::unnecessary_wraps, reason = "as what is searched")]
    fn valley(u: &[f64]) -> Result<Evaluation, String> {
        Ok(Evaluation {
            residuals: DVector::from_vec(vec![10.0 * (u[1] - u[0] * u[0]), 1.0 - u[0]]),
            jacobian: DMatrix::from_row_slice(2, 2, &[-20.0 * u[0], 10.0, -1.0, 0.0]),
        })
    }

    #[test]
    fn the_bottom_of_a_bent_valley_is_found() {
        let found = least_squares(valley, &[-1.2, 1.0], &search(&[FREE; 2])).unwrap();
        assert_eq!(found.end, End::Converged);
        assert!(found.at.iter().all(|u| (u - 1.0).abs() < 1e-9), "{:?}", found.at);
    }

    #[test]
    fn a_bound_holds_and_the_rest_is_best_along_it() {
        let bounds = [Bounds { high: 0.5, ..FREE }, FREE];
        let found = least_squares(valley, &[-1.2, 1.0], &search(&bounds)).unwrap();
        assert_eq!(found.end, End::Converged);
        let [first, second] = found.at[..] else { panic!() };
        assert!((first - 0.5).abs() < 1e-15 && (second - 0.25).abs() < 1e-9, "{:?}", found.at);
    }

    /// The first steps from this start lead far out of bounds.
    #[test]
    fn a_search_within_narrow_bounds_goes_on_to_the_bottom() {
        let bounds = [Bounds { low: 0.0, high: 1.5 }, Bounds { low: 0.9, high: 1.2 }];
        let found = least_squares(valley, &[0.2, 1.2], &search(&bounds)).unwrap();
        assert!(found.at.iter().all(|u| (u - 1.0).abs() < 1e-8), "{found:?}");
    }

    #[test]
    fn what_cannot_be_evaluated_is_survived() {
        let guarded = |u: &[f64]| {
            if u[1] < -0.1 { Err("no machine there".to_owned()) } else { valley(u) }
        };
        let found = least_squares(guarded, &[2.0, 0.0], &search(&[FREE; 2])).unwrap();
        assert!(found.at.iter().all(|u| (u - 1.0).abs() < 1e-8), "{found:?}");
    }

    #[test]
    fn an_outlier_counts_less_by_the_loss_of_huber() {
        // A line through 20 points with one outlier: y = 2 + 3 x.
        let points: Vec<(f64, f64)> = (0..20)
            .map(|k| (f64::from(k), 2.0 + 3.0 * f64::from(k) + if k == 7 { 100.0 } else { 0.0 }))
            .collect();
        let line = |u: &[f64]| {
            Ok(Evaluation {
                residuals: DVector::from_fn(20, |k, _| u[0] + u[1] * points[k].0 - points[k].1),
                jacobian: DMatrix::from_fn(20, 2, |k, j| if j == 0 { 1.0 } else { points[k].0 }),
            })
        };
        let of = |loss| {
            let search = Search { loss, ..search(&[FREE; 2]) };
            least_squares(line, &[0.0, 0.0], &search).unwrap().at
        };
        let (squares, huber) = (of(Loss::Squares), of(Loss::Huber(0.01)));
        assert!((squares[0] - 2.0).abs() > 1.0);
        assert!((huber[0] - 2.0).abs() < 0.01 && (huber[1] - 3.0).abs() < 0.01, "{huber:?}");
    }
}
