//! Profile likelihood: growth of the cost of the best fit as one unknown is held away from its
//! estimate.
//!
//! ```text
//! S(u_k) = min sum rho(r_i)  over all other unknowns
//! tau    = sign(u_k - found) sqrt((S(u_k) - S)/s^2)      s^2 = sum r^2/(m - n)
//! ```
//!
//! Values with |tau| <= t, Student's t of 95 % with m - n degrees of freedom, form the confidence
//! interval; F(1, m - n) = t^2. For a linear model tau is linear too, and the interval is that of
//! the standard error. (D. M. Bates, D. G. Watts, Nonlinear Regression Analysis and Its
//! Applications, 1988, section 6.1.)
//!
//! A walk goes outwards by steps of a part of t, each from the last best point along the tangent
//! dS/du_others = 0. When it has passed t, Newton's method leads back to t: dS/du_k follows from
//! the derivatives of the residuals alone.

use nalgebra::{DMatrix, DVector};
use serde::Serialize;

use super::findings::quantity;
use super::least_squares::weighed;
use super::rounds::Counter;
use super::statistics::students_t;
use super::{Bounds, End, Evaluation, Fit, Fitted, Found, Loss, Plan, Search, Unknown, scale_of};
use crate::sorting::sort_ascending;

/// Number of steps of a walk to t if tau grows linearly.
const STEPS: f64 = 4.0;
/// Maximum number of points of one side.
const MOST: usize = 60;
/// Length of a walk, in the search coordinate, beyond which the interval counts as open: a factor
/// of a thousand on a logarithmic scale.
const FAR: f64 = 7.0;
/// First step if the residuals do not determine its length.
const FIRST: f64 = 0.05;
/// Maximum number of halvings of a step whose run fails.
const HALVINGS: usize = 6;
/// Decrease of the sum of squares, in variances, from which on another, better fit is reported.
const BETTER: f64 = 0.01;
/// Relative accuracy of tau = t at an end of an interval.
const EXACT: f64 = 1e-6;

/// Profile of one unknown.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Profile {
    /// Name of the parameter or state.
    pub parameter: String,
    /// Its unit.
    pub unit: String,
    /// Estimate.
    pub value: f64,
    /// Ends of the confidence interval of 95 %; null where the interval is open.
    pub confidence_95: [Option<f64>; 2],
    /// Reason why the interval is open.
    pub open: [Option<String>; 2],
    /// Points of the profile, ascending.
    pub points: Vec<ProfilePoint>,
}

/// The best fit with one unknown held at a value.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct ProfilePoint {
    /// Value of the held unknown.
    pub value: f64,
    /// Signed root of the growth of the sum of squares, over the variance of residuals.
    pub tau: f64,
    /// Derivative of tau by the value.
    pub slope: f64,
    /// Best values of all unknowns, including the held one.
    pub parameters: Vec<f64>,
}

/// Point of a walk, in search coordinates.
#[derive(Clone)]
struct Stand {
    at: Vec<f64>,
    /// Absolute value of tau.
    tau: f64,
    /// d tau/d u_k, outwards.
    slope: f64,
    /// d u/d u_k with the other unknowns at their best.
    tangent: Vec<f64>,
}

/// One side of a profile.
struct Side {
    /// Points in the outward direction.
    points: Vec<Stand>,
    end: Result<f64, String>,
}

/// Data of a walk.
struct Walk<'w> {
    fit: &'w Fit<'w>,
    fitted: &'w Fitted,
    plan: &'w Plan<'w>,
    tell: &'w (dyn Fn(&Evaluation) + Sync),
    /// Index of the held unknown.
    held: usize,
    outwards: f64,
    /// s^2.
    variance: f64,
    t: f64,
}

impl Fit<'_> {
    /// Computes profiles of these unknowns about the end of a fit, with its scales and its loss.
    /// `watch` receives every evaluation, as in [`Fit::solve`].
    pub fn profiles(
        &self,
        fitted: &Fitted,
        which: &[usize],
        plan: &Plan<'_>,
        watch: &mut (dyn FnMut(usize, &Evaluation) + Send),
    ) -> Vec<Profile> {
        let (told, _) = self.statistics_of(fitted);
        let (variance, t) = (told.deviation * told.deviation, students_t(told.freedom));
        let counter = Counter::new(watch);
        let mut sides = self.each(2 * which.len(), |fit, number| {
            let (held, outwards) = (which[number / 2], if number % 2 == 0 { -1.0 } else { 1.0 });
            let tell = &|now: &Evaluation| counter.tell(now);
            Walk { fit, fitted, plan, tell, held, outwards, variance, t }.side()
        });
        let profiles = which.iter().rev().map(|held| {
            let (up, down) = (sides.pop(), sides.pop());
            self.joined(*held, [down, up].map(Option::unwrap_or_default))
        });
        let mut profiles: Vec<Profile> = profiles.collect();
        profiles.reverse();
        profiles
    }

    /// Joins both sides of a profile.
    fn joined(&self, held: usize, [down, up]: [Side; 2]) -> Profile {
        let unknown = &self.unknowns[held];
        let point = |stand: &Stand, outwards: f64| {
            let parameters = self.values(&stand.at);
            let value = parameters[held];
            let slope = stand.slope / unknown.slope(value).abs();
            ProfilePoint { value, tau: outwards * stand.tau, slope, parameters }
        };
        let below = down.points.iter().skip(1).rev().map(|stand| point(stand, -1.0));
        let above = up.points.iter().map(|stand| point(stand, 1.0));
        let value = up.points.first().map_or(f64::NAN, |stand| unknown.outer(stand.at[held]));
        let points = below.chain(above).collect();
        let ends = [&down.end, &up.end];
        Profile {
            parameter: unknown.name.clone(),
            unit: quantity(self.simulation.simulator(), &unknown.name)
                .map_or("", |quantity| quantity.unit)
                .to_owned(),
            value,
            confidence_95: ends.map(|end| end.as_ref().ok().map(|inner| unknown.outer(*inner))),
            open: ends.map(|end| end.as_ref().err().cloned()),
            points,
        }
    }
}

impl Default for Side {
    fn default() -> Self {
        Self { points: Vec::new(), end: Err(String::new()) }
    }
}

impl Walk<'_> {
    fn side(&self) -> Side {
        let Found { at, evaluation, .. } = &self.fitted.found;
        let (tangent, alone) = tangent(evaluation, self.fitted.loss, self.held, &self.is_free(at));
        let slope = alone / self.variance.sqrt();
        let mut points = vec![Stand { at: at.clone(), tau: 0.0, slope, tangent }];
        let end = if self.t.is_finite() && self.variance > 0.0 {
            self.outward(&mut points)
        } else {
            Err("the accuracy of the data cannot be estimated from the residuals".to_owned())
        };
        Side { points, end }
    }

    fn unknown(&self) -> &Unknown {
        &self.fit.unknowns[self.held]
    }

    /// Returns the bound of the walk, in the search coordinate.
    fn bound(&self) -> f64 {
        let Bounds { low, high } = self.unknown().inner_bounds();
        if self.outwards < 0.0 { low } else { high }
    }

    /// Walks until tau has passed t. Returns the value at which tau is t, or the reason why there
    /// is none.
    fn outward(&self, points: &mut Vec<Stand>) -> Result<f64, String> {
        let (first, bound) = (points[0].at[self.held], self.bound());
        let by_slope = self.t / STEPS / points[0].slope;
        let mut step = if by_slope < FAR { by_slope } else { FIRST };
        let mut halvings = 0;
        while points.len() < MOST {
            let here = points[points.len() - 1].clone();
            let from = here.at[self.held];
            if (bound - from) * self.outwards <= 0.0 {
                return Err("it is at its bound".to_owned());
            }
            if (from - first).abs() > FAR {
                break;
            }
            let wanted = from + self.outwards * step;
            let ahead = if (bound - wanted) * self.outwards < 0.0 { bound } else { wanted };
            match self.best_at(ahead, &here) {
                Ok(next) => {
                    points.push(next.clone());
                    if next.tau >= self.t {
                        return self.crossing(points, here, next);
                    }
                    let by_slope = self.t / STEPS / next.slope.max(f64::MIN_POSITIVE);
                    step = by_slope.clamp(0.25 * step, 2.0 * step);
                }
                Err(Halt::Run(why)) if halvings == HALVINGS => {
                    let value = number(self.unknown().outer(from));
                    return Err(format!("it cannot be simulated beyond {value}: {why}"));
                }
                Err(Halt::Run(_)) => {
                    halvings += 1;
                    step *= 0.25;
                }
                Err(Halt::For(why)) => return Err(why),
            }
        }
        let last = self.unknown().outer(points[points.len() - 1].at[self.held]);
        Err(format!("the data do not determine it up to {}", number(last)))
    }

    /// Finds where tau is t between two points of the walk, and adds the points on the way.
    fn crossing(
        &self,
        points: &mut Vec<Stand>,
        mut low: Stand,
        mut high: Stand,
    ) -> Result<f64, String> {
        const MOST: usize = 12;
        let by_slope =
            |from: &Stand| from.at[self.held] + self.outwards * (self.t - from.tau) / from.slope;
        for _ in 0..MOST {
            let is_low_nearer = self.t - low.tau < high.tau - self.t;
            let from = if is_low_nearer { &low } else { &high };
            if (from.tau - self.t).abs() <= EXACT * self.t {
                return Ok(by_slope(from));
            }
            let (a, b) = (low.at[self.held], high.at[self.held]);
            let straight = by_slope(from);
            let is_between = (straight - a) * (straight - b) < 0.0;
            let ahead = if is_between { straight } else { f64::midpoint(a, b) };
            let next = self.best_at(ahead, from).map_err(|halt| match halt {
                Halt::Run(why) | Halt::For(why) => why,
            })?;
            // Points stay in the order of the walk.
            points.insert(points.len() - 1, next.clone());
            sort_ascending(points, |point| self.outwards * point.at[self.held]);
            if next.tau < self.t {
                low = next;
            } else {
                high = next;
            }
        }
        Err("the sum of squares is too noisy there to locate the end".to_owned())
    }

    /// Returns the best fit with the unknown held at a value, searched for from a point of the
    /// walk.
    fn best_at(&self, held: f64, from: &Stand) -> Result<Stand, Halt> {
        let Walk { fit, fitted, plan, .. } = self;
        let mut bounds = fit.bounds();
        bounds[self.held] = Bounds { low: held, high: held };
        let moved = held - from.at[self.held];
        let straight: Vec<f64> =
            from.at.iter().zip(&from.tangent).map(|(u, slope)| u + slope * moved).collect();
        let loss = fitted.loss;
        let search = Search { bounds: &bounds, loss, most: plan.steps, interrupt: plan.interrupt };
        let scales = |name: &str| scale_of(&fitted.scales, name);
        let look = |start: &[f64]| fit.search_within(start, &scales, &search, self.tell);
        let found = look(&straight).or_else(|_| look(&from.at));
        let interrupted = || Halt::For("the profile was interrupted".to_owned());
        let found =
            found.map_err(|why| if plan.is_flagged() { interrupted() } else { Halt::Run(why) })?;
        if found.end == End::Interrupted {
            return Err(interrupted());
        }
        let grown = 2.0 * (found.cost - fitted.found.cost);
        if grown < -BETTER * self.variance {
            let value = number(self.unknown().outer(held));
            let why = format!("there is a better fit at {value}; start from there");
            return Err(Halt::For(why));
        }
        let tau = (grown.max(0.0) / self.variance).sqrt();
        let (jacobian, residuals) = weighed(&found.evaluation, loss);
        let rise = self.outwards * jacobian.column(self.held).dot(&residuals);
        let (tangent, alone) =
            tangent(&found.evaluation, loss, self.held, &self.is_free(&found.at));
        let slope =
            if tau > 0.0 { rise / (self.variance * tau) } else { alone / self.variance.sqrt() };
        Ok(Stand { at: found.at, tau, slope, tangent })
    }

    /// Returns which other unknowns are not at a bound.
    fn is_free(&self, at: &[f64]) -> Vec<bool> {
        let bounds = self.fit.bounds();
        let is_within = |(k, (u, Bounds { low, high })): (usize, (&f64, &Bounds))| {
            k != self.held && low < u && u < high
        };
        at.iter().zip(&bounds).enumerate().map(is_within).collect()
    }
}

/// Reason why a walk ends.
enum Halt {
    /// The point cannot be simulated.
    Run(String),
    /// Another reason.
    For(String),
}

/// Returns the first-order change of the other unknowns with the held one, and the norm of the part
/// of its Jacobian column that they cannot reproduce.
fn tangent(evaluation: &Evaluation, loss: Loss, held: usize, is_free: &[bool]) -> (Vec<f64>, f64) {
    const ROUNDING: f64 = 1e-9;
    let (jacobian, _) = weighed(evaluation, loss);
    let own = jacobian.column(held).into_owned();
    let free: Vec<usize> = (0..is_free.len()).filter(|k| is_free[*k]).collect();
    let mut tangent = vec![0.0; is_free.len()];
    tangent[held] = 1.0;
    if free.is_empty() {
        return (tangent, own.norm());
    }
    let others = DMatrix::from_fn(jacobian.nrows(), free.len(), |row, k| jacobian[(row, free[k])]);
    // Columns are scaled to length 1, since unknowns differ in size.
    let sizes: Vec<f64> =
        others.column_iter().map(|column| column.norm().max(f64::MIN_POSITIVE)).collect();
    let scaled = DMatrix::from_fn(others.nrows(), free.len(), |row, k| others[(row, k)] / sizes[k]);
    let made = scaled.clone().svd(true, true).solve(&own, ROUNDING);
    let made = made.unwrap_or_else(|_| DVector::zeros(free.len()));
    for (k, (place, size)) in free.iter().zip(&sizes).enumerate() {
        tangent[*place] = -made[k] / size;
    }
    (tangent, (own - scaled * made).norm())
}

/// Returns the number with six digits, for messages.
fn number(value: f64) -> String {
    format!("{value:.5e}")
        .parse::<f64>()
        .map_or_else(|_| value.to_string(), |value| value.to_string())
}
