//! Minimization of an expression within bounds and inequalities, by sequential quadratic
//! programming.
//!
//! ```text
//! min max_k f_k(u),   max_k c_jk(u) <= 0,   lower <= u <= upper
//! ```
//!
//! An extreme over time is the greatest of many local ones, each of which is smooth. The problem of
//! a step contains all of them (K. Madsen, H. Schjaer-Jacobsen, Linearly constrained minimax
//! optimization, Math. Programming 14, 1978), so that it accounts for a second peak that a step
//! would raise:
//!
//! ```text
//! min t + nu sum_j s_j + 1/2 d^T B d,   f_k + g_k d <= t,   c_jk + a_jk d <= s_j,   s_j >= 0
//! ```
//!
//! B follows from Powell's damped update (M. J. D. Powell, 1978). Steps are shortened until f + nu
//! sum_j max(0, c_j) decreases (S. P. Han, 1977). If inequalities cannot be met, nu grows until
//! their violation is minimal, and the search ends as infeasible. A point that cannot be evaluated
//! counts as a step that was too long.

use std::sync::atomic::{AtomicBool, Ordering};

use nalgebra::{DMatrix, DVector};

use super::evaluate::Branch;
use super::quadratic::Quadratic;
use crate::fit::Bounds;

/// Branches of a value: the first is the value, the others are not greater.
pub type Branches = Vec<Branch>;

/// Objective and inequalities at a point, scaled to values of size 1.
#[derive(Debug, Clone)]
pub struct Evaluation {
    /// Objective, to be minimized.
    pub objective: Branches,
    /// Constraints, each required to be at most zero.
    pub constraints: Vec<Branches>,
}

/// Settings of a search.
#[derive(Debug, Clone, Copy)]
pub struct Search<'a> {
    /// Lower and upper bound of each unknown; infinite where there is none.
    pub bounds: &'a [Bounds],
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
    /// The violation of the inequalities has reached a minimum.
    Infeasible,
    /// The maximum number of steps is reached.
    Steps,
    /// The search was interrupted.
    Interrupted,
    /// No step improves the objective although one should: the functions are not smooth, or less
    /// exact than requested.
    Stuck,
}

/// End of a search.
#[derive(Debug, Clone)]
pub struct Found {
    /// Unknowns u.
    pub at: Vec<f64>,
    /// Evaluation at this point.
    pub evaluation: Evaluation,
    /// Multipliers of the inequalities: decrease of the objective per unit by which one is relaxed.
    pub multipliers: Vec<f64>,
    /// Multipliers of the bounds of unknowns: positive for lower ones, negative for upper ones.
    pub of_bounds: Vec<f64>,
    /// Number of steps taken.
    pub steps: usize,
    /// Reason for the end.
    pub end: End,
    /// Number of points that could not be evaluated, and the reason for the first.
    pub failed: (usize, Option<String>),
}

/// Predicted gain of a step, relative to the objective, below which the search has converged.
const GAIN: f64 = 1e-10;
/// Predicted gain below which a failing step ends the search: evaluations are not more exact.
const FAINT: f64 = 1e-6;
/// Tolerance of inequalities.
const MISSED: f64 = 1e-7;
/// Maximum weight of a violated inequality.
const HEAVIEST: f64 = 1e5;

impl Search<'_> {
    fn clipped(&self, at: &[f64]) -> Vec<f64> {
        at.iter().zip(self.bounds).map(|(u, bounds)| u.clamp(bounds.low, bounds.high)).collect()
    }

    fn is_interrupted(&self) -> bool {
        self.interrupt.is_some_and(|flag| flag.load(Ordering::Relaxed))
    }
}

impl Evaluation {
    fn is_finite(&self) -> bool {
        let all = self.constraints.iter().flatten().chain(&self.objective);
        let mut numbers = all.flat_map(|branch| branch.slopes.iter().chain([&branch.value]));
        numbers.all(|number| number.is_finite())
    }

    /// Returns the total violation of the inequalities.
    #[must_use]
    pub fn missed(&self) -> f64 {
        self.constraints.iter().map(|branches| branches[0].value.max(0.0)).sum()
    }

    fn merit(&self, weight: f64) -> f64 {
        self.objective[0].value + weight * self.missed()
    }
}

impl Found {
    fn ended(self, end: End) -> Self {
        Self { end, ..self }
    }

    /// Returns whether all inequalities are fulfilled.
    #[must_use]
    pub fn is_feasible(&self) -> bool {
        self.evaluation.constraints.iter().all(|branches| branches[0].value <= MISSED)
    }

    /// Returns whether this end of a search is better than another.
    #[must_use]
    pub fn is_better_than(&self, other: &Self) -> bool {
        match (self.is_feasible(), other.is_feasible()) {
            (true, true) => {
                self.evaluation.objective[0].value < other.evaluation.objective[0].value
            }
            (false, false) => self.evaluation.missed() < other.evaluation.missed(),
            (feasible, _) => feasible,
        }
    }
}

/// A step with its prediction.
struct Step {
    d: DVector<f64>,
    /// Gain of the linearized merit function.
    gain: f64,
    /// Violation of the linearized inequalities at its end.
    missed: f64,
    /// Multipliers of the branches of the objective, then of those of each inequality.
    multipliers: Vec<Vec<f64>>,
    of_bounds: Vec<f64>,
}

/// Minimizes from `start`.
///
/// # Errors
/// The reason why the start cannot be evaluated.
pub fn search(
    mut evaluate: impl FnMut(&[f64]) -> Result<Evaluation, String>,
    start: &[f64],
    search: &Search<'_>,
) -> Result<Found, String> {
    let at = search.clipped(start);
    let evaluation = evaluate(&at)?;
    if !evaluation.is_finite() {
        return Err("the objective or an inequality is not a finite number".to_owned());
    }
    let n = at.len();
    let constraints = evaluation.constraints.len();
    let mut found = Found {
        at,
        evaluation,
        multipliers: vec![0.0; constraints],
        of_bounds: vec![0.0; n],
        steps: 0,
        end: End::Steps,
        failed: (0, None),
    };
    let mut bend = DMatrix::<f64>::identity(n, n);
    let (mut weight, mut reach) = (10.0, 0.3);
    let mut is_fresh = true;
    while found.steps < search.most {
        if search.is_interrupted() {
            return Ok(found.ended(End::Interrupted));
        }
        let Some(step) = steered(&found, &bend, (&mut weight, reach), search.bounds) else {
            return Ok(found.ended(End::Stuck));
        };
        found.multipliers = step.multipliers[1..].iter().map(|all| all.iter().sum()).collect();
        found.of_bounds.clone_from(&step.of_bounds);
        let size = 1.0 + found.evaluation.merit(weight).abs();
        if step.gain <= GAIN * size {
            if step.missed <= MISSED {
                return Ok(found.ended(End::Converged));
            }
            if weight >= HEAVIEST {
                return Ok(found.ended(End::Infeasible));
            }
            weight *= 10.0;
            continue;
        }
        let Some((ahead, evaluation, share)) =
            shortened(&mut evaluate, &mut found, &step, weight, search)
        else {
            if search.is_interrupted() {
                return Ok(found.ended(End::Interrupted));
            }
            // The remaining gain is rounding.
            if step.missed > MISSED && step.missed >= (1.0 - FAINT) * found.evaluation.missed() {
                if weight >= HEAVIEST {
                    return Ok(found.ended(End::Infeasible));
                }
                weight *= 10.0;
                continue;
            }
            if !is_fresh {
                // B may be the cause.
                bend = DMatrix::identity(n, n);
                is_fresh = true;
                reach *= 0.1;
                continue;
            }
            let is_faint = step.gain <= FAINT * size && found.is_feasible();
            return Ok(found.ended(if is_faint { End::Converged } else { End::Stuck }));
        };
        found.steps += 1;
        let moved = DVector::from_fn(n, |k, _| ahead[k] - found.at[k]);
        let is_far = step.d.amax() > 0.99 * reach;
        if share < 1.0 {
            reach = (2.0 * moved.amax()).clamp(1e-6, reach);
        } else if is_far {
            reach = (2.0 * reach).min(3.0);
        }
        let [before, after] = [&found.evaluation, &evaluation]
            .map(|at| slope_of_sum(&found.evaluation, at, &step.multipliers));
        is_fresh = false;
        update(&mut bend, &moved, &(after - before));
        found.at = ahead;
        found.evaluation = evaluation;
    }
    Ok(found)
}

/// Finds the longest fraction of a step with a sufficient decrease. Returns the point, its
/// evaluation and the fraction; `None` if there is none, or if the search is interrupted.
fn shortened(
    evaluate: &mut impl FnMut(&[f64]) -> Result<Evaluation, String>,
    found: &mut Found,
    step: &Step,
    weight: f64,
    search: &Search<'_>,
) -> Option<(Vec<f64>, Evaluation, f64)> {
    const LEAST: f64 = 1e-7;
    let merit = found.evaluation.merit(weight);
    let mut share = 1.0;
    let mut factor = 0.5;
    while share >= LEAST {
        let ahead: Vec<f64> = found.at.iter().zip(&step.d).map(|(u, d)| u + share * d).collect();
        let ahead = search.clipped(&ahead);
        match evaluate(&ahead) {
            Ok(evaluation) if evaluation.is_finite() => {
                if evaluation.merit(weight) <= merit - 1e-4 * share * step.gain {
                    return Some((ahead, evaluation, share));
                }
            }
            tried => {
                if search.is_interrupted() {
                    return None;
                }
                found.failed.0 += 1;
                let why = tried.err().unwrap_or_else(|| "it is not finite".to_owned());
                found.failed.1.get_or_insert(why);
            }
        }
        if search.is_interrupted() {
            return None;
        }
        share *= factor;
        factor = 0.3;
    }
    None
}

/// Computes the step with a weight that makes it violate inequalities by little more than the
/// minimum (R. H. Byrd, J. Nocedal, R. A. Waltz, Steering exact penalty methods, Optim. Methods
/// Softw. 23, 2008). Otherwise a search may go where they cannot be fulfilled at all.
fn steered(
    found: &Found,
    bend: &DMatrix<f64>,
    (weight, reach): (&mut f64, f64),
    bounds: &[Bounds],
) -> Option<Step> {
    const SHARE: f64 = 0.9;
    let mut own = step(found, bend, (*weight, reach), bounds)?;
    if own.missed <= MISSED {
        return Some(own);
    }
    let now = found.evaluation.missed();
    let Some(least) = step(found, bend, (HEAVIEST, reach), bounds) else { return Some(own) };
    while now - own.missed < SHARE * (now - least.missed) - MISSED && *weight < HEAVIEST {
        *weight *= 10.0;
        own = step(found, bend, (*weight, reach), bounds)?;
    }
    Some(own)
}

/// Computes the step from the current point.
fn step(
    found: &Found,
    bend: &DMatrix<f64>,
    (weight, reach): (f64, f64),
    bounds: &[Bounds],
) -> Option<Step> {
    let Evaluation { objective, constraints } = &found.evaluation;
    let (n, m) = (found.at.len(), constraints.len());
    // d, t, s.
    let size = n + 1 + m;
    let mut hessian = DMatrix::zeros(size, size);
    // Everything is divided by the weight, so that the largest numbers are of size 1.
    hessian.view_mut((0, 0), (n, n)).copy_from(&(bend / weight));
    let mut gradient = DVector::zeros(size);
    gradient[n] = 1.0 / weight;
    gradient.rows_mut(n + 1, m).fill(1.0);
    let groups: Vec<&Branches> = std::iter::once(objective).chain(constraints).collect();
    let branches: usize = groups.iter().map(|branches| branches.len()).sum();
    let count = branches + m + 2 * n;
    let mut rows = DMatrix::zeros(count, size);
    let mut limits = DVector::zeros(count);
    let mut row = 0;
    for (group, branches) in groups.iter().enumerate() {
        for branch in *branches {
            for (column, slope) in branch.slopes.iter().enumerate() {
                rows[(row, column)] = *slope;
            }
            rows[(row, n + group)] = -1.0;
            limits[row] = -branch.value;
            row += 1;
        }
    }
    for group in 0..m {
        rows[(row, n + 1 + group)] = -1.0;
        row += 1;
    }
    for (k, Bounds { low, high }) in bounds.iter().enumerate() {
        rows[(row, k)] = -1.0;
        limits[row] = (found.at[k] - low).min(reach);
        rows[(row + 1, k)] = 1.0;
        limits[row + 1] = (high - found.at[k]).min(reach);
        row += 2;
    }
    let mut guess = DVector::zeros(size);
    guess[n] = objective[0].value + 1.0;
    for (group, branches) in constraints.iter().enumerate() {
        guess[n + 1 + group] = branches[0].value.max(0.0) + 1.0;
    }
    let problem = Quadratic { hessian, gradient, rows, limits };
    let (solution, z) = problem.solve(&guess)?;
    let z = z * weight;
    let mut d = solution.rows(0, n).into_owned();
    // Unknowns held by a bound are at it, to the last bit.
    for (k, Bounds { low, high }) in bounds.iter().enumerate() {
        let row = branches + m + 2 * k;
        let [below, above] = [d[k] + problem.limits[row], problem.limits[row + 1] - d[k]];
        if z[row] > below && found.at[k] - low <= reach {
            d[k] = low - found.at[k];
        } else if z[row + 1] > above && high - found.at[k] <= reach {
            d[k] = high - found.at[k];
        }
    }
    let linear = |branches: &Branches| {
        let along = |branch: &Branch| {
            branch.value + branch.slopes.iter().zip(&d).map(|(a, d)| a * d).sum::<f64>()
        };
        branches.iter().map(along).fold(f64::NEG_INFINITY, f64::max)
    };
    let missed: f64 = constraints.iter().map(|branches| linear(branches).max(0.0)).sum();
    let gain = found.evaluation.merit(weight) - linear(objective) - weight * missed;
    let mut rest = z.as_slice();
    let multipliers = groups
        .iter()
        .map(|branches| {
            let (own, others) = rest.split_at(branches.len());
            rest = others;
            own.to_vec()
        })
        .collect();
    // The reach of a step is not a bound.
    let of_bound = |k: usize, side: usize| {
        let Bounds { low, high } = bounds[k];
        let room = if side == 0 { found.at[k] - low } else { high - found.at[k] };
        if room <= reach { rest[m + 2 * k + side] } else { 0.0 }
    };
    let of_bounds = (0..n).map(|k| of_bound(k, 0) - of_bound(k, 1)).collect();
    Some(Step { d, gain, missed, multipliers, of_bounds })
}

/// Returns the slopes of the sum of branches of `of`, weighted by multipliers of the branches at
/// `at`. Extremes correspond if their times are nearest.
fn slope_of_sum(of: &Evaluation, at: &Evaluation, multipliers: &[Vec<f64>]) -> DVector<f64> {
    let n = at.objective[0].slopes.len();
    let mut sum = DVector::zeros(n);
    let groups = |evaluation: &Evaluation| -> Vec<Branches> {
        std::iter::once(&evaluation.objective).chain(&evaluation.constraints).cloned().collect()
    };
    for ((known, branches), multipliers) in groups(of).iter().zip(&groups(at)).zip(multipliers) {
        for (known, multiplier) in known.iter().zip(multipliers) {
            let off = |branch: &Branch| (branch.label - known.label).abs();
            let nearest = branches.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
            for (sum, slope) in sum.iter_mut().zip(nearest.map_or(&[][..], |b| &b.slopes)) {
                *sum += multiplier * slope;
            }
        }
    }
    sum
}

/// Makes Powell's damped update of B for a step and the change of the gradient.
fn update(bend: &mut DMatrix<f64>, step: &DVector<f64>, change: &DVector<f64>) {
    let along = &*bend * step;
    let known = step.dot(&along);
    if known.is_nan() || known <= f64::MIN_POSITIVE {
        return;
    }
    let met = step.dot(change);
    let share = if met >= 0.2 * known { 1.0 } else { 0.8 * known / (known - met) };
    let change = change * share + &along * (1.0 - share);
    let met = step.dot(&change);
    *bend += &change * change.transpose() / met - &along * along.transpose() / known;
}

#[cfg(test)]
mod tests {
    use super::*;

    fn branch(value: f64, slopes: &[f64], label: f64) -> Branch {
        Branch { value, slopes: slopes.to_vec(), label }
    }

    fn greatest_first(mut branches: Branches) -> Branches {
        branches.sort_by(|a, b| b.value.total_cmp(&a.value));
        branches
    }

    fn ask(bounds: &[Bounds]) -> Search<'_> {
        Search { bounds, most: 200, interrupt: None }
    }

    const FREE: Bounds = Bounds::NONE;

    /// W. Hock, K. Schittkowski, Test Examples for Nonlinear Programming Codes, 1981.
    #[test]
    fn problems_of_hock_and_schittkowski_are_solved() {
        // 43, Rosen and Suzuki: f = -44 at (0, 1, 2, -1), multipliers 1, 0, 2.
        let evaluate = |x: &[f64]| {
            let [a, b, c, d] = x[..] else { panic!() };
            let f = a * a + b * b + 2.0 * c * c + d * d - 5.0 * a - 5.0 * b - 21.0 * c + 7.0 * d;
            let g = [2.0 * a - 5.0, 2.0 * b - 5.0, 4.0 * c - 21.0, 2.0 * d + 7.0];
            let c1 = a * a + b * b + c * c + d * d + a - b + c - d - 8.0;
            let c2 = a * a + 2.0 * b * b + c * c + 2.0 * d * d - a - d - 10.0;
            let c3 = 2.0 * a * a + b * b + c * c + 2.0 * a - b - d - 5.0;
            let g1 = [2.0 * a + 1.0, 2.0 * b - 1.0, 2.0 * c + 1.0, 2.0 * d - 1.0];
            let g2 = [2.0 * a - 1.0, 4.0 * b, 2.0 * c, 4.0 * d - 1.0];
            let g3 = [4.0 * a + 2.0, 2.0 * b - 1.0, 2.0 * c, -1.0];
            let rows = [(c1, g1), (c2, g2), (c3, g3)];
            let constraints = rows.map(|(c, g)| vec![branch(c, &g, 0.0)]).to_vec();
            Ok(Evaluation { objective: vec![branch(f, &g, 0.0)], constraints })
        };
        let found = search(evaluate, &[0.0; 4], &ask(&[FREE; 4])).expect("it starts");
        assert_eq!(found.end, End::Converged);
        for (found, wanted) in found.at.iter().zip([0.0, 1.0, 2.0, -1.0]) {
            assert!((found - wanted).abs() < 1e-4, "{found} for {wanted}");
        }
        assert!((found.evaluation.objective[0].value + 44.0).abs() < 1e-7);
        for (found, wanted) in found.multipliers.iter().zip([1.0, 0.0, 2.0]) {
            assert!((found - wanted).abs() < 1e-3, "{found} for {wanted}");
        }
        // 35, Beale: 1/9 at (4/3, 7/9, 4/9).
        let evaluate = |x: &[f64]| {
            let [a, b, c] = x[..] else { panic!() };
            let f = 9.0 - 8.0 * a - 6.0 * b - 4.0 * c
                + 2.0 * a * a
                + 2.0 * b * b
                + c * c
                + 2.0 * a * b
                + 2.0 * a * c;
            let g = [
                -8.0 + 4.0 * a + 2.0 * b + 2.0 * c,
                -6.0 + 4.0 * b + 2.0 * a,
                -4.0 + 2.0 * c + 2.0 * a,
            ];
            let constraints = vec![vec![branch(a + b + 2.0 * c - 3.0, &[1.0, 1.0, 2.0], 0.0)]];
            Ok(Evaluation { objective: vec![branch(f, &g, 0.0)], constraints })
        };
        let positive = [Bounds { low: 0.0, ..FREE }; 3];
        let found = search(evaluate, &[0.5; 3], &ask(&positive)).expect("it starts");
        assert!((found.evaluation.objective[0].value - 1.0 / 9.0).abs() < 1e-8, "{found:?}");
        assert!((found.multipliers[0] - 2.0 / 9.0).abs() < 1e-3);
    }

    /// K. Madsen's problem and that of C. Charalambous and A. R. Conn: minimax with several
    /// branches at the solution.
    #[test]
    fn several_peaks_are_lowered_together() {
        // max(x^2 + y^4, (2 - x)^2 + (2 - y)^2, 2 e^(y - x)): 1.9522244939 at
        // (1.1390376, 0.8995599).
        let evaluate = |u: &[f64]| {
            let (x, y) = (u[0], u[1]);
            let e = 2.0 * (y - x).exp();
            Ok(Evaluation {
                objective: greatest_first(vec![
                    branch(x * x + y.powi(4), &[2.0 * x, 4.0 * y.powi(3)], 1.0),
                    branch(
                        (2.0 - x).powi(2) + (2.0 - y).powi(2),
                        &[2.0 * x - 4.0, 2.0 * y - 4.0],
                        2.0,
                    ),
                    branch(e, &[-e, e], 3.0),
                ]),
                constraints: Vec::new(),
            })
        };
        let found = search(evaluate, &[1.0, -0.1], &ask(&[FREE; 2])).expect("it starts");
        assert_eq!(found.end, End::Converged, "{found:?}");
        assert!((found.evaluation.objective[0].value - 1.952_224_493_9).abs() < 1e-8);
        assert!(
            (found.at[0] - 1.139_037_6).abs() < 1e-4 && (found.at[1] - 0.899_559_9).abs() < 1e-4
        );
    }

    #[test]
    fn what_cannot_be_met_is_missed_by_the_least_and_told() {
        // x >= 3 and x <= 1.
        let evaluate = |u: &[f64]| {
            let x = u[0];
            Ok(Evaluation {
                objective: vec![branch(x * x, &[2.0 * x], 0.0)],
                constraints: vec![
                    vec![branch(3.0 - x, &[-1.0], 0.0)],
                    vec![branch(x - 1.0, &[1.0], 0.0)],
                ],
            })
        };
        let found = search(evaluate, &[0.0], &ask(&[FREE])).expect("it starts");
        assert_eq!(found.end, End::Infeasible, "{found:?}");
        assert!((found.evaluation.missed() - 2.0).abs() < 1e-6);
    }

    #[test]
    fn bounds_hold_and_what_fails_is_a_step_too_long() {
        // -x, to be had up to 1, evaluated up to 0.7.
        let evaluate = |limit: f64| {
            move |u: &[f64]| {
                if u[0] > limit {
                    return Err("too far".to_owned());
                }
                let objective = vec![branch((u[0] - 0.69).powi(2), &[2.0 * (u[0] - 0.69)], 0.0)];
                Ok(Evaluation { objective, constraints: Vec::new() })
            }
        };
        let found = search(evaluate(0.7), &[0.0], &ask(&[Bounds { low: -1.0, high: 5.0 }]))
            .expect("it starts");
        assert!((found.at[0] - 0.69).abs() < 1e-5, "{found:?}");
        let found = search(evaluate(9.0), &[0.0], &ask(&[Bounds { low: -1.0, high: 0.25 }]))
            .expect("it starts");
        assert_eq!((found.end, found.at[0].to_bits()), (End::Converged, 0.25_f64.to_bits()));
        // The objective decreases by 2 (0.69 - 0.25) per unit by which the bound is relaxed.
        assert!((found.of_bounds[0] + 0.88).abs() < 1e-6, "{found:?}");
        assert!(search(|_| Err("no".to_owned()), &[0.0], &ask(&[FREE])).is_err());
    }
}
