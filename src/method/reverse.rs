//! Adjoint gradient of one number of a run by all parameters and initial values.
//!
//! The number's derivative lambda by the state is carried backwards over the steps of an explicit
//! pair that the run took,
//!
//! ```text
//! Y_i = y + h sum_j a_ij k_j     k_i = f(t + c_i h, Y_i)     y_new = Y_s
//! Y_i* = J_i^T k_i* (+ lambda_new of Y_s)     k_j* = h sum_i a_ij Y_i*     lambda = sum_i Y_i*
//! d(number)/dp += sum_i (df/dp)_i^T k_i*
//! ```
//!
//! so the cost does not depend on the number of parameters, and the result equals that of
//! sensitivities along the same steps, to rounding. A bounded number of states of the run is kept;
//! those between are computed again.
//!
//! Source: A. Griewank, A. Walther: Evaluating Derivatives, 2nd edition (2008), chapters 3 and 12.

use std::cell::RefCell;

use machinist_contract::SparsityPattern;

use super::explicit::pair_of;
use super::lanes::{Sum, combine, padded, sum};
use super::stretch::within;
use super::tableau::Pair;
use super::{Method, System};

/// Maximum number of values in the kept states.
const KEPT: usize = 1 << 22;
/// Number of states that are kept in any case.
const LEAST: usize = 64;

/// Steps of a run, and some of their states.
#[derive(Default)]
pub(crate) struct Log {
    inner: RefCell<Inner>,
}

struct Inner {
    /// Start and length of every step \[s\].
    steps: Vec<(f64, f64)>,
    checkpoints: Vec<Checkpoint>,
    /// Number of steps per kept state.
    stride: usize,
    /// Number of steps since the last kept state.
    since: usize,
}

impl Default for Inner {
    fn default() -> Self {
        Self { steps: Vec::new(), checkpoints: Vec::new(), stride: 1, since: 0 }
    }
}

/// State before a step.
struct Checkpoint {
    /// Index of the step; the number of steps if none follows.
    step: usize,
    /// Start and end of its segment \[s\].
    stretch: (f64, f64),
    /// True if it is at the start of the segment.
    begins: bool,
    state: Vec<f64>,
}

impl Log {
    /// Records the start of a segment.
    pub(crate) fn begin(&self, stretch: (f64, f64), state: &[f64]) {
        let inner = &mut *self.inner.borrow_mut();
        let step = inner.steps.len();
        inner.checkpoints.push(Checkpoint { step, stretch, begins: true, state: state.to_vec() });
        inner.since = 0;
    }

    /// Records a step from a state.
    pub(crate) fn take(&self, step: (f64, f64), state: &[f64]) {
        let inner = &mut *self.inner.borrow_mut();
        let stretch = inner.checkpoints.last().map_or(step, |last| last.stretch);
        if inner.since == inner.stride {
            let step = inner.steps.len();
            let state = state.to_vec();
            inner.checkpoints.push(Checkpoint { step, stretch, begins: false, state });
            inner.since = 0;
            inner.thin_out();
        }
        inner.steps.push(step);
        inner.since += 1;
    }
}

impl Inner {
    /// Drops every other state if there are too many.
    fn thin_out(&mut self) {
        let size = self.checkpoints.last().map_or(1, |last| last.state.len().max(1));
        if self.checkpoints.len() <= (KEPT / size).max(LEAST) {
            return;
        }
        self.stride *= 2;
        let mut is_odd = false;
        self.checkpoints.retain(|checkpoint| {
            is_odd = !checkpoint.begins && !is_odd;
            !is_odd
        });
        let last = self.checkpoints.last().map_or(0, |last| last.step);
        self.since = self.steps.len() - last;
    }
}

/// Dependence of the number on states at output times, with a callback.
pub(crate) struct Pulled<'p> {
    /// Output times, ascending \[s\].
    pub(crate) times: &'p [f64],
    /// d(number)/dy at each time, one row after another.
    pub(crate) by_states: &'p [f64],
    /// Called at the start of each segment.
    pub(crate) begins: &'p mut Begins<'p>,
}

/// Callback with the time \[s\] of a start, and lambda and the state there.
pub(crate) type Begins<'b> = dyn FnMut(f64, &[f64], &[f64]) + 'b;

/// Adjoint computation for steps of an explicit pair.
pub(crate) struct WayBack {
    pair: &'static Pair,
}

impl WayBack {
    /// Returns that of a method, if it is an explicit pair.
    pub(crate) fn of(method: Method) -> Option<Self> {
        pair_of(method).map(|pair| Self { pair })
    }

    /// Returns lambda at the start of the run. Derivatives by parameters are added to
    /// `by_parameters`, whose length is the number of columns of dy'/dp.
    pub(crate) fn pull_back(
        &self,
        system: &System<'_>,
        log: Log,
        pulled: Pulled<'_>,
        by_parameters: &mut [f64],
    ) -> Vec<f64> {
        let Pulled { times, by_states, begins } = pulled;
        let Inner { steps, checkpoints, .. } = log.inner.into_inner();
        let size = system.states();
        let mut lambda = vec![0.0; size];
        let mut left = times.len();
        let mut back = StepBack::new(system, self.pair);
        let mut end = steps.len();
        for Checkpoint { step: first, stretch, begins: is_first, state } in checkpoints.iter().rev()
        {
            let steps = &steps[*first..end];
            let mut states = vec![state.clone()];
            for (index, step) in steps.iter().enumerate().take(steps.len().saturating_sub(1)) {
                states.push(back.forth(*stretch, *step, &states[index]));
            }
            for (step, state) in steps.iter().zip(&states).rev() {
                let sampled = times[..left].iter().rev().take_while(|time| **time > step.0).count();
                let rows = left - sampled..left;
                left -= sampled;
                let samples = rows.map(|row| (times[row], &by_states[row * size..][..size]));
                back.back(*stretch, *step, state, samples, &mut lambda, by_parameters);
            }
            end = *first;
            if *is_first {
                begins(stretch.0, &lambda, state);
            }
        }
        for row in by_states[..left * size].chunks_exact(size.max(1)) {
            add(row, 1.0, &mut lambda);
        }
        lambda
    }
}

fn add(from: &[f64], factor: f64, into: &mut [f64]) {
    for (into, from) in into.iter_mut().zip(from) {
        *into += factor * from;
    }
}

/// A step and its adjoint.
struct StepBack<'a> {
    system: &'a System<'a>,
    pair: &'static Pair,
    width: usize,
    sums: Vec<Sum>,
    /// k, stage by stage.
    rates: Vec<f64>,
    /// Y, stage by stage.
    states: Vec<f64>,
    start: Vec<f64>,
    /// k*, stage by stage.
    pulls: Vec<f64>,
    weights: Vec<f64>,
    /// Values of dy'/dy and dy'/dp.
    values: Vec<f64>,
    patterns: [SparsityPattern<'a>; 2],
}

impl<'a> StepBack<'a> {
    fn new(system: &'a System<'a>, pair: &'static Pair) -> Self {
        let simulator = system.simulator();
        let patterns = [simulator.rate_jacobian_pattern(), simulator.parameter_jacobian_pattern()];
        let (width, count) = (padded(system.states()), pair.nodes.len());
        let sums = pair.rows.iter().chain(pair.dense.extra).map(|row| sum(row, width)).collect();
        let zeros = || vec![0.0; width * count];
        Self {
            system,
            pair,
            width,
            sums,
            rates: zeros(),
            states: zeros(),
            start: vec![0.0; width],
            pulls: zeros(),
            weights: vec![0.0; count],
            values: vec![0.0; patterns.iter().map(|pattern| pattern.entries.len()).sum()],
            patterns,
        }
    }

    /// Computes the state of a stage, and its rate unless it is the last.
    fn stage(&mut self, stage: usize, stretch: (f64, f64), (time, step): (f64, f64)) {
        let at = stage * self.width;
        let state = &mut self.states[at..][..self.width];
        combine(&self.sums[stage], &self.rates, step, Some(&self.start), state);
        let time = within(time + self.pair.nodes[stage] * step, stretch);
        let size = self.system.states();
        let rate = &mut self.rates[at..][..size];
        self.system.state_rate(time, &state[..size], rate);
    }

    /// Returns the state after a step.
    fn forth(&mut self, stretch: (f64, f64), step: (f64, f64), state: &[f64]) -> Vec<f64> {
        self.start[..state.len()].copy_from_slice(state);
        let last = self.pair.rows.len() - 1;
        for stage in 0..last {
            self.stage(stage, stretch, step);
        }
        let end = &mut self.states[last * self.width..][..self.width];
        combine(&self.sums[last], &self.rates, step.1, Some(&self.start), end);
        end[..state.len()].to_vec()
    }

    /// Carries lambda from the end of a step to its start, with the contributions of output times
    /// within and at its end.
    fn back<'s>(
        &mut self,
        stretch: (f64, f64),
        step: (f64, f64),
        state: &[f64],
        samples: impl Iterator<Item = (f64, &'s [f64])>,
        lambda: &mut [f64],
        by_parameters: &mut [f64],
    ) {
        self.start[..state.len()].copy_from_slice(state);
        let (time, length) = step;
        let last = self.pair.rows.len() - 1;
        (0..=last).for_each(|stage| self.stage(stage, stretch, step));
        self.pulls.fill(0.0);
        let mut of_start = vec![0.0; state.len()];
        let mut is_within = false;
        for (at, pull) in samples {
            if at >= time + length {
                add(pull, 1.0, lambda);
                continue;
            }
            if !is_within {
                (last + 1..self.pair.nodes.len()).for_each(|k| self.stage(k, stretch, step));
                is_within = true;
            }
            (self.pair.dense.weights)((at - time) / length, &mut self.weights);
            for (pulls, weight) in self.pulls.chunks_exact_mut(self.width).zip(&self.weights) {
                add(pull, length * weight, pulls);
            }
            add(pull, 1.0, &mut of_start);
        }
        let mut of_stage = vec![0.0; state.len()];
        for stage in (0..self.pair.nodes.len()).rev() {
            of_stage.fill(0.0);
            self.through_rate(stage, stretch, step, &mut of_stage, by_parameters);
            if stage == last {
                add(lambda, 1.0, &mut of_stage);
            }
            for (place, weight) in &self.sums[stage] {
                add(&of_stage, length * weight, &mut self.pulls[*place..][..self.width]);
            }
            add(&of_stage, 1.0, &mut of_start);
        }
        lambda.copy_from_slice(&of_start);
    }

    /// Computes J^T k* and (df/dp)^T k* of a stage.
    fn through_rate(
        &mut self,
        stage: usize,
        stretch: (f64, f64),
        (time, step): (f64, f64),
        by_state: &mut [f64],
        by_parameters: &mut [f64],
    ) {
        let at = stage * self.width;
        let pulls = &self.pulls[at..][..self.width];
        if pulls.iter().all(|pull| *pull == 0.0) {
            return;
        }
        let time = within(time + self.pair.nodes[stage] * step, stretch);
        let state = &self.states[at..][..by_state.len()];
        self.system.jacobians(time, state, &mut self.values);
        let [jacobian, parameter_jacobian] = self.patterns;
        let (of_states, of_parameters) = self.values.split_at(jacobian.entries.len());
        for ((row, column), value) in jacobian.entries.iter().zip(of_states) {
            by_state[*column as usize] += value * pulls[*row as usize];
        }
        for ((row, column), value) in parameter_jacobian.entries.iter().zip(of_parameters) {
            by_parameters[*column as usize] += value * pulls[*row as usize];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{KEPT, Log};

    /// The number of kept states is bounded for any number of steps. Their distances do not exceed
    /// the stride, and those at starts of segments are never dropped.
    #[test]
    fn of_many_steps_a_bounded_number_of_states_is_kept() {
        let log = Log::default();
        let size = KEPT / 100;
        let state = vec![0.0; size];
        for stretch in 0..3 {
            log.begin((f64::from(stretch), f64::from(stretch) + 1.0), &state);
            (0..1000).for_each(|k| log.take((f64::from(k), 1.0), &state));
        }
        let inner = log.inner.into_inner();
        assert_eq!(inner.steps.len(), 3000);
        assert!(inner.checkpoints.len() <= 101, "{}", inner.checkpoints.len());
        let begins: Vec<usize> =
            inner.checkpoints.iter().filter(|c| c.begins).map(|c| c.step).collect();
        assert_eq!(begins, [0, 1000, 2000]);
        let apart = inner.checkpoints.windows(2).map(|pair| pair[1].step - pair[0].step);
        assert!(apart.max() <= Some(inner.stride), "{}", inner.stride);
    }
}
