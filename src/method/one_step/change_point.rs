//! Change points: positions of a loop at which its constraints lose rank, such as that of a
//! parallelogram whose links lie in one line.
//!
//! Two branches of motion cross there, and the forces of constraints may grow without bound, but
//! the motion along a branch is smooth. It is carried past by one step of collocation: a polynomial
//! that fulfils the equations of motion at the nodes of Gauss, before and behind the change point
//! and at a distance from it. The velocity selects the branch. At the nodes the states are
//! projected onto the constraints, so that errors across the branch are not enlarged.

use nalgebra::{DMatrix, DVector};

use super::control::Control;
use super::kept::Kept;
use super::{OneStep, Pace, ResumePoint, Samples, Stopped, Stretch, Trial, begin_behind, drive};
use crate::constraints::{Constraints, Level};
use crate::method::taylor::quadrature::Gauss;

/// Number of nodes of Gauss; even, so that none is in the middle.
const NODES: usize = 12;

/// Largest number of iterations of a step.
const ROUNDS: usize = 40;

/// Result of an attempt to pass a change point instead of a step.
pub(super) enum Past {
    Nothing,
    /// The watch has an event to apply.
    Event,
    /// A change point of the constraints; the method has begun behind it.
    ChangePoint,
    /// Nothing: the change point is still too far for a step past it. A step of this length \[s\]
    /// leads nearer.
    Ahead(f64),
}

/// Passes a change point that makes steps fail, if one lies within a few of the last steps.
pub(super) fn past<M: OneStep>(
    method: &mut M,
    stretch: &Stretch<'_>,
    kept: &mut Kept,
    control: &mut Control,
    (state, samples): (&mut [f64], &mut Samples<'_>),
) -> Result<Past, Stopped> {
    /// Steps within which it lies.
    const STEPS: f64 = 4.0;
    let (system, time) = (stretch.system, control.time);
    let Some(constraints) = system.constraints() else { return Ok(Past::Nothing) };
    if method.passes_change_points() || system.tangents().is_some() || system.is_sliding() {
        return Ok(Past::Nothing);
    }
    let reach = STEPS * control.longest.max(control.step);
    let Some(until) = time_to_change_point(stretch, constraints, (time, &kept.end), reach) else {
        return Ok(Past::Nothing);
    };
    let mut passage = Passage::new(stretch);
    passage.begin(time, &kept.end);
    let Some(step) = passage.step_past(until) else { return Ok(Past::Ahead(0.5 * until)) };
    state.copy_from_slice(&kept.end);
    // The step is the whole step of a stretch that does not end near it.
    let ahead = Stretch { until: time + 4.0 * step, ..*stretch };
    let Some(left) =
        drive(&mut passage, &ahead, ResumePoint { time, step }, state, samples, |_, _| true)?
    else {
        return Ok(Past::Event);
    };
    system.note(format!(
        "passes a change point of its constraints at t = {:.6} s, along the branch on which it \
         moves",
        time + until
    ));
    begin_behind(method, stretch, kept, (left.time, state));
    control.begin(left.time, left.step);
    stretch.require_wanted(left.time, state)?;
    Ok(Past::ChangePoint)
}

/// Returns the time until the constraints lose rank, if the motion from a state leads there within
/// `reach`: where a singular value of their matrix, with its sign, crosses zero.
fn time_to_change_point(
    stretch: &Stretch<'_>,
    constraints: &Constraints<'_>,
    (time, start): (f64, &[f64]),
    reach: f64,
) -> Option<f64> {
    /// Singular values, relative to the largest, of constraints that repeat others.
    const REPEATED: f64 = 1e-12;
    /// Largest value at the change point, relative to that at the start.
    const VANISHED: f64 = 0.1;
    let path = Path::new(stretch, time, start);
    let scaled = |after: f64| constraints.scaled_matrix(time + after, &path.at(after));
    let svd = scaled(0.0).transpose().try_svd(true, true, f64::EPSILON, 1000)?;
    let (across, along) = (svd.u?, svd.v_t?);
    let least = REPEATED * svd.singular_values.max();
    let mut order: Vec<usize> = (0..svd.singular_values.len()).collect();
    order.retain(|index| svd.singular_values[*index] > least);
    order.sort_by(|one, other| svd.singular_values[*one].total_cmp(&svd.singular_values[*other]));
    order.into_iter().find_map(|index| {
        let first = svd.singular_values[index];
        let signed = |after: f64| {
            let image = scaled(after) * across.column(index);
            (along.row(index) * image)[0]
        };
        let until = first_zero(signed, first, reach)?;
        let below = |values: &DVector<f64>| {
            values.iter().filter(|value| **value <= VANISHED * first).count()
        };
        let there = scaled(until).singular_values();
        (below(&there) > below(&svd.singular_values)).then_some(until)
    })
}

/// Returns a zero of a function between 0, where it is `first`, and `reach`, by secants from 0.
fn first_zero(function: impl Fn(f64) -> f64, first: f64, reach: f64) -> Option<f64> {
    const ROUNDS: usize = 10;
    const RESOLVED: f64 = 1e-6;
    let (mut before, mut at_before) = (0.0, first);
    let mut after = 1e-3 * reach;
    for _ in 0..ROUNDS {
        let at_after = function(after);
        let next = after - at_after * (after - before) / (at_after - at_before);
        if !next.is_finite() || next <= 0.0 || next > reach {
            return None;
        }
        (before, at_before, after) = (after, at_after, next);
        if (after - before).abs() <= RESOLVED * after {
            return Some(after);
        }
    }
    None
}

/// The motion from a state by its velocities and accelerations.
struct Path {
    start: Vec<f64>,
    rate: Vec<f64>,
    /// Number of positions that are as many as velocities; 0 with quaternions.
    bent: usize,
    first_velocity: usize,
}

impl Path {
    fn new(stretch: &Stretch<'_>, time: f64, start: &[f64]) -> Self {
        let mut rate = vec![0.0; start.len()];
        stretch.rate(time, start, &mut rate);
        let shape = stretch.system.simulator().shape();
        let bent = if shape.positions == shape.coordinates { shape.coordinates } else { 0 };
        Self { start: start.to_vec(), rate, bent, first_velocity: shape.positions }
    }

    /// Returns the state after a time.
    fn at(&self, after: f64) -> Vec<f64> {
        let mut state: Vec<f64> =
            self.start.iter().zip(&self.rate).map(|(start, rate)| start + after * rate).collect();
        let accelerations = &self.rate[self.first_velocity..];
        for (position, acceleration) in state[..self.bent].iter_mut().zip(accelerations) {
            *position += 0.5 * after * after * acceleration;
        }
        state
    }
}

/// One step of collocation.
struct Passage<'a> {
    stretch: &'a Stretch<'a>,
    rule: Rule,
    time: f64,
    start: Vec<f64>,
    step: f64,
    /// Coefficients of the rates in Legendre polynomials over the step, one column each.
    rates: DMatrix<f64>,
    end: Vec<f64>,
    /// Rounding of the states at the nodes, in tolerances: 0 if it is small, infinite if nothing else
    /// is left.
    rounding: f64,
}

impl<'a> Passage<'a> {
    fn new(stretch: &'a Stretch<'a>) -> Self {
        let size = stretch.system.len();
        Self {
            stretch,
            rule: Rule::new(),
            time: stretch.from,
            start: vec![0.0; size],
            step: 0.0,
            rates: DMatrix::zeros(size, NODES),
            end: vec![0.0; size],
            rounding: 0.0,
        }
    }

    /// Returns the step past a change point after a time, if one is within the tolerances. The
    /// change point lies in the middle between two nodes: of the whole step first; if rounding is
    /// too large at nodes so near, of steps that reach ever further behind it.
    fn step_past(&mut self, until: f64) -> Option<f64> {
        for node in (1..=NODES / 2).rev() {
            let share = 0.5 + 0.25 * (self.rule.nodes[node - 1] + self.rule.nodes[node]);
            let step = until / share;
            if self.time + step >= self.stretch.until {
                return None;
            }
            if self.succeeds(step) {
                return Some(step);
            }
            if self.rounding == 0.0 {
                return None;
            }
        }
        None
    }

    /// Returns whether a step is within the tolerances, and its end near the constraints.
    fn succeeds(&mut self, step: f64) -> bool {
        let is_good = matches!(self.attempt(step), Trial::Error(error) if error <= 1.0);
        let mut end = self.end.clone();
        is_good && self.stretch.constrain(self.time + step, &mut end).is_ok()
    }

    /// Returns the state at x in \[-1, 1\] of the step.
    fn state_at(&self, x: f64) -> Vec<f64> {
        let gained = &self.rates * (Rule::integrals(x) * (0.5 * self.step));
        self.start.iter().zip(gained.iter()).map(|(start, gained)| start + gained).collect()
    }

    /// Projects the state at a node onto the constraints; returns whether it can be.
    fn project(&self, time: f64, state: &mut [f64]) -> bool {
        let states = self.stretch.system.states();
        self.stretch.system.constraints().is_none_or(|constraints| {
            [Level::Positions, Level::Velocities]
                .into_iter()
                .all(|level| constraints.put_back(level, time, &mut state[..states]).is_ok())
        })
    }

    /// Solves the equations of a step; returns false if the iteration fails.
    fn solve(&mut self) -> bool {
        /// Share of the tolerances at which the iteration ends.
        const SOLVED: f64 = 1e-3;
        /// Rounds without progress after which only rounding is left, and its largest size relative
        /// to a state.
        const IDLE: u32 = 4;
        const ROUNDING: f64 = 1e-10;
        self.rounding = f64::INFINITY;
        let (size, states) = (self.start.len(), self.stretch.system.states());
        let path = Path::new(self.stretch, self.time, &self.start);
        let mut rates = DMatrix::zeros(size, NODES);
        let mut before: Option<Vec<Vec<f64>>> = None;
        let (mut least, mut idle) = (f64::INFINITY, 0);
        for _ in 0..ROUNDS {
            let mut nodes = Vec::with_capacity(NODES);
            for (index, x) in self.rule.nodes.iter().enumerate() {
                let after = 0.5 * (1.0 + x) * self.step;
                let mut state = if before.is_none() { path.at(after) } else { self.state_at(*x) };
                let time = self.time + after;
                if !self.project(time, &mut state) {
                    return false;
                }
                let mut rate = vec![0.0; size];
                self.stretch.rate(time, &state, &mut rate);
                if rate.iter().any(|value| !value.is_finite()) {
                    return false;
                }
                rates.column_mut(index).copy_from_slice(&rate);
                nodes.push(state);
            }
            let last = std::mem::replace(&mut self.rates, &rates * &self.rule.analysis);
            let moved = before.map_or(f64::INFINITY, |before| {
                let pairs = before.iter().flatten().zip(nodes.iter().flatten()).enumerate();
                let of_states = pairs.filter(|(index, _)| index % size < states);
                let shares = of_states.map(|(index, (before, now))| {
                    (now - before).abs() / self.allowed(index % size, *now)
                });
                shares.fold(0.0, f64::max)
            });
            if moved <= SOLVED {
                self.rounding = 0.0;
                return true;
            }
            idle = if moved <= 0.5 * least { 0 } else { idle + 1 };
            least = least.min(moved);
            if idle >= IDLE && least * self.stretch.rtol <= ROUNDING {
                self.rounding = moved + self.largest(&(&self.rates - last), 0..NODES);
                return true;
            }
            before = Some(nodes);
        }
        false
    }

    /// Returns the largest sum over some coefficients of rates over the step, in tolerances.
    fn largest(&self, rates: &DMatrix<f64>, of: std::ops::Range<usize>) -> f64 {
        let sums = (0..self.stretch.system.states()).map(|index| {
            let sum: f64 = of.clone().map(|k| rates[(index, k)].abs()).sum();
            0.5 * self.step * sum / self.allowed(index, self.start[index])
        });
        sums.fold(0.0, f64::max)
    }

    /// Returns the tolerance of a state.
    fn allowed(&self, index: usize, value: f64) -> f64 {
        self.stretch.atol[index] + self.stretch.rtol * value.abs()
    }
}

impl OneStep for Passage<'_> {
    fn begin(&mut self, time: f64, state: &[f64]) {
        self.time = time;
        self.start.copy_from_slice(state);
    }

    fn first_step(&mut self) -> f64 {
        self.step
    }

    fn attempt(&mut self, step: f64) -> Trial {
        /// Factor of the rounding that is not taken for an error of the step.
        const NOISY: f64 = 4.0;
        self.step = step;
        if !self.solve() {
            return Trial::Error(f64::INFINITY);
        }
        self.end = self.state_at(1.0);
        // The last coefficients bound the error between the ends, which exceeds that at the end.
        let error = self.largest(&self.rates, NODES - 2..NODES);
        Trial::Error(error / (1.0 + NOISY * self.rounding))
    }

    fn end(&self) -> &[f64] {
        &self.end
    }

    fn interpolate(&mut self, time: f64, state: &mut [f64]) {
        state.copy_from_slice(&self.state_at(2.0 * (time - self.time) / self.step - 1.0));
    }

    fn accept(&mut self) {
        self.time += self.step;
        self.start.clone_from(&self.end);
    }

    fn pace(&self) -> Pace {
        let exponent = 1.0 / NODES as f64;
        Pace { exponent, memory: 0.0, safety: 0.9, smallest: 0.5, largest: 1.0, hold: 1.0 }
    }

    fn passes_change_points(&self) -> bool {
        true
    }
}

/// The rule of Gauss on \[-1, 1\].
struct Rule {
    nodes: [f64; NODES],
    /// Takes values at the nodes to coefficients of Legendre polynomials, one column each.
    analysis: DMatrix<f64>,
}

impl Rule {
    fn new() -> Self {
        let mut nodes = [0.0; NODES];
        let mut weights = [0.0; NODES];
        let points = Gauss::new(NODES);
        // From the last point to the first.
        let places = nodes.iter_mut().zip(&mut weights).rev();
        for ((node, weight), point) in places.zip(points.points(-1.0, 1.0)) {
            (*node, *weight) = point;
        }
        let analysis = DMatrix::from_fn(NODES, NODES, |node, k| {
            (k as f64 + 0.5) * weights[node] * legendre(nodes[node])[k]
        });
        Self { nodes, analysis }
    }

    /// Returns the integrals of the Legendre polynomials from -1 to x.
    fn integrals(x: f64) -> DVector<f64> {
        let values = legendre(x);
        DVector::from_fn(NODES, |k, _| {
            if k == 0 { x + 1.0 } else { (values[k + 1] - values[k - 1]) / (2 * k + 1) as f64 }
        })
    }
}

/// Returns the Legendre polynomials of degree 0 to [`NODES`] at x.
fn legendre(x: f64) -> [f64; NODES + 1] {
    let mut values = [1.0; NODES + 1];
    values[1] = x;
    for k in 1..NODES {
        values[k + 1] =
            ((2 * k + 1) as f64 * x * values[k] - k as f64 * values[k - 1]) / (k + 1) as f64;
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_integrates_polynomials() {
        let rule = Rule::new();
        let power = NODES as i32 - 1;
        let values = DVector::from_fn(NODES, |node, _| rule.nodes[node].powi(power));
        let coefficients = values.transpose() * &rule.analysis;
        for x in [-1.0, -0.3, 0.0, 0.7, 1.0_f64] {
            let integral = (coefficients.clone() * Rule::integrals(x))[0];
            let exact = (x.powi(power + 1) - 1.0) / f64::from(power + 1);
            assert!((integral - exact).abs() < 1e-14, "{x}: {integral} {exact}");
        }
    }
}
