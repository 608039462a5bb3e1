//! Radau IIA collocation of orders 5, 9 and 13, for stiff machines and tight
//! tolerances.
//!
//! E. Hairer, G. Wanner: Solving Ordinary Differential Equations II, section
//! IV.8, and J. Comput. Appl. Math. 111 (1999) 93-111 for the choice of order.

mod collocation;
mod newton;
mod tangents;

use self::collocation::Collocation;
use self::newton::{Newton, Outcome};
use super::one_step::{
    BETWEEN, OneStep, Pace, Trial, drive_all, first_step, sum_of_squares, weighted_norm,
};
use super::tableau::RADAU;
use super::{Integrator, Samples, Sealed, Stopped, Stretch};
use crate::method::sensitivity::Tangents;

/// Radau IIA of variable order.
pub(super) struct Radau;

impl Sealed for Radau {}

impl Integrator for Radau {
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        drive_all(&mut RadauSteps::new(stretch), stretch, state, samples)
    }
}

/// Steps of Radau methods. The energy quadratures have no feedback, so their stages follow from
/// those of the states without equations to solve.
pub(super) struct RadauSteps<'a> {
    stretch: &'a Stretch<'a>,
    size: usize,
    len: usize,
    time: f64,
    step: f64,
    start: Vec<f64>,
    end: Vec<f64>,
    /// f at the start, with quadratures last.
    rate: Vec<f64>,
    rate_at_end: Vec<f64>,
    /// Allowed errors at the start, from the tolerances for this order.
    scale: Vec<f64>,
    /// Stages relative to the start, one after another, of `len` each.
    stages: Vec<f64>,
    /// The last accepted step, from which the stages of the next are extrapolated.
    previous: Previous,
    /// The polynomial of the current step, which may yet be rejected.
    within: Vec<f64>,
    methods: Vec<Collocation>,
    /// Index into `methods`, and whether it is fixed.
    current: usize,
    is_fixed: bool,
    newton: Newton<'a>,
    error: Vec<f64>,
    scratch: Vec<f64>,
    /// Result of the last attempt.
    was_rejected: bool,
    last_error: f64,
    accepted: Option<Accepted>,
    order_choice: OrderChoice,
    carried: tangents::Carried,
}

/// Polynomial of the last accepted step, in divided differences.
struct Previous {
    differences: Vec<f64>,
    method: usize,
    step: f64,
    is_known: bool,
}

/// Step and error of the last accepted step, for the prediction of the next one.
#[derive(Clone, Copy)]
struct Accepted {
    step: f64,
    error: f64,
}

/// Data for the choice of order.
#[derive(Default)]
struct OrderChoice {
    steps_since_change: usize,
    contraction: f64,
    newton_failed: bool,
}

impl<'a> RadauSteps<'a> {
    pub(super) fn new(stretch: &'a Stretch<'a>) -> Self {
        let (size, len) = (stretch.system.states(), stretch.system.len());
        let methods: Vec<_> = RADAU.iter().map(Collocation::new).collect();
        let most = RADAU.iter().map(|method| method.nodes.len()).max().unwrap_or(0);
        let zeros = || vec![0.0; len];
        Self {
            stretch,
            size,
            len,
            time: stretch.from,
            step: 0.0,
            start: zeros(),
            end: zeros(),
            rate: zeros(),
            rate_at_end: zeros(),
            scale: zeros(),
            stages: vec![0.0; len * most],
            previous: Previous {
                differences: vec![0.0; len * (most + 1)],
                method: 0,
                step: 0.0,
                is_known: false,
            },
            within: vec![0.0; len * (most + 1)],
            methods,
            current: 0,
            is_fixed: false,
            newton: Newton::new(stretch, most),
            error: zeros(),
            scratch: zeros(),
            was_rejected: false,
            last_error: 1.0,
            accepted: None,
            order_choice: OrderChoice::default(),
            carried: tangents::Carried::default(),
        }
    }

    /// Returns the last Jacobian evaluated, in pattern order.
    pub(super) fn jacobian(&self) -> &[f64] {
        self.newton.jacobian()
    }

    /// Fixes the number of stages, and solves for them to rounding.
    #[cfg(feature = "implicit")]
    pub(super) fn of_stages(mut self, stages: usize) -> Self {
        self.current = (stages - 3) / 2;
        self.is_fixed = true;
        self
    }

    /// Returns the factor by which estimates may exceed the tolerance. The error estimate is
    /// proportional to the step to the power s + 1, the error at the end of a run to 2 s - 1. To
    /// make the latter proportional to the tolerance, estimates are compared with a looser one,
    /// within limits, because states between the ends are of order s only:
    ///
    /// ```text
    /// looser / rtol = (most / rtol)^(1 - (s + 1)/(2 s - 1))
    /// ```
    ///
    /// where `most` is the loosest tolerance for which a method is used; see [`highest_useful`].
    fn looser(&self) -> f64 {
        const LOOSEST: f64 = 10.0;
        let stages = self.methods[self.current].stages() as f64;
        let exponent = 1.0 - (stages + 1.0) / (2.0 * stages - 1.0);
        (MOST[self.current] / self.stretch.rtol).powf(exponent).clamp(1.0, LOOSEST)
    }

    /// Sets the allowed errors for a method's estimate.
    fn set_scale(&mut self) {
        let rtol = self.stretch.rtol;
        let looser = self.looser();
        for ((scale, state), atol) in self.scale.iter_mut().zip(&self.start).zip(self.stretch.atol)
        {
            *scale = looser * (atol + rtol * state.abs());
        }
        self.newton.set_tolerance(rtol * looser);
        if self.is_fixed {
            self.newton.demand(1e-9);
        }
    }

    fn try_step(&mut self) -> Result<f64, Trial> {
        self.set_scale();
        self.guess_stages();
        let method = &self.methods[self.current];
        let size = self.size;
        self.newton.linearize(self.time, &self.start[..size])?;
        let mut outcome = Outcome::Failed { shrink: 0.5 };
        // The second attempt has a new Jacobian, if the first one had an old one.
        for _ in 0..2 {
            outcome = self.newton.solve(
                method,
                (self.time, self.step),
                &self.start,
                &self.scale,
                &mut self.stages,
            )?;
            match outcome {
                Outcome::Failed { .. } if self.newton.renew(self.time, &self.start[..size])? => {
                    self.order_choice.newton_failed = true;
                    self.stages.fill(0.0);
                }
                _ => break,
            }
        }
        if let Outcome::Failed { shrink } = outcome {
            self.order_choice.newton_failed = true;
            return Err(Trial::Unsolved { shrink });
        }
        self.sum_up_flows();
        let last = (self.methods[self.current].stages() - 1) * self.len;
        for ((end, start), stage) in self.end.iter_mut().zip(&self.start).zip(&self.stages[last..])
        {
            *end = start + stage;
        }
        let error = self.estimate(false)?;
        if error > 1.0 && (self.was_rejected || self.accepted.is_none()) {
            return self.estimate_again();
        }
        Ok(error)
    }

    /// Returns the norm of (gamma/h I - J)^-1 (f - u'(t)), u being the polynomial through start and
    /// stages: the difference to an embedded method of order s. f is the rate at the start, or the
    /// contents of `rate_at_end`.
    fn estimate(&mut self, is_again: bool) -> Result<f64, Trial> {
        let rate = if is_again { &self.rate_at_end } else { &self.rate };
        let method = &self.methods[self.current];
        let real = method.coefficients.real / self.step;
        for (index, error) in self.error.iter_mut().enumerate() {
            let stages = self.stages[index..].iter().step_by(self.len);
            let slope: f64 = method.slope.iter().zip(stages).map(|(weight, z)| weight * z).sum();
            *error = rate[index] - slope / self.step;
        }
        let (states, flows) = self.error.split_at_mut(self.size);
        self.newton.solve_real(states);
        for flow in flows {
            *flow /= real;
        }
        let norm = (sum_of_squares(&self.error, &self.scale) / self.len as f64).sqrt();
        if norm.is_nan() {
            return Err(Trial::NotFinite { what: "the error of", index: 0 });
        }
        Ok(norm.max(1e-10))
    }

    /// Returns the estimate filtered once more, which is better for very stiff states.
    fn estimate_again(&mut self) -> Result<f64, Trial> {
        for ((scratch, start), error) in self.scratch.iter_mut().zip(&self.start).zip(&self.error) {
            *scratch = start + error;
        }
        self.stretch.rate(self.time, &self.scratch, &mut self.rate_at_end);
        self.estimate(true)
    }

    /// Evaluates the rate at the end of a step that is otherwise accepted.
    fn look_at_end(&mut self) -> Result<(), Trial> {
        let now = self.time + self.step;
        self.stretch.rate(now, &self.end, &mut self.rate_at_end);
        let mut ends = self.end.iter().chain(&self.rate_at_end);
        if let Some(index) = ends.position(|value| !value.is_finite()) {
            return Err(Trial::NotFinite { what: "the rate of", index: index % self.len });
        }
        self.newton.refuse_onset(&self.methods[self.current], (now, self.step), &self.end)
    }

    /// Computes the stages of the quadratures, Z_w = h A P.
    fn sum_up_flows(&mut self) {
        if self.len == self.size {
            return;
        }
        let method = &self.methods[self.current];
        let count = method.stages();
        for stage in 0..count {
            for flow in self.size..self.len {
                self.stages[stage * self.len + flow] = 0.0;
            }
        }
        for (stage, node) in method.coefficients.nodes.iter().enumerate() {
            for ((state, start), z) in
                self.scratch.iter_mut().zip(&self.start).zip(&self.stages[stage * self.len..])
            {
                *state = start + z;
            }
            let time = self.time + node * self.step;
            let flows = self.stretch.flow_rates(time, &self.scratch[..self.size]);
            for row in 0..count {
                let weight = self.step * method.integrals[row * count + stage];
                for (flow, rate) in flows.iter().enumerate() {
                    self.stages[row * self.len + self.size + flow] += weight * rate;
                }
            }
        }
    }

    /// Extrapolates stages from the polynomial of the last step.
    fn guess_stages(&mut self) {
        if !self.previous.is_known {
            self.stages.fill(0.0);
            self.newton.expect_nothing();
            return;
        }
        let ratio = self.step / self.previous.step;
        let method = &self.methods[self.previous.method];
        for (stage, node) in self.methods[self.current].coefficients.nodes.iter().enumerate() {
            let into = &mut self.stages[stage * self.len..][..self.len];
            method.evaluate(&self.previous.differences, 1.0 + node * ratio, into);
            for (stage, start) in into.iter_mut().zip(&self.start) {
                *stage -= start;
            }
        }
    }

    /// Chooses a higher order where Newton's iteration converges fast and steps are regular, a
    /// lower one where it converges badly.
    fn choose_order(&mut self) {
        const STEPS_BEFORE_A_RISE: usize = 10;
        let choice = &mut self.order_choice;
        choice.steps_since_change += 1;
        choice.contraction = self.newton.contraction().max(0.5 * choice.contraction).min(10.0);
        let ratio = self.accepted.map_or(1.0, |before| self.step / before.step);
        let is_even = ratio > 0.8 && ratio < 1.2;
        let struggles = choice.newton_failed || choice.contraction >= 0.8;
        let highest = highest_useful(self.stretch.rtol);
        let next = if struggles {
            self.current.saturating_sub(1)
        } else if choice.contraction <= 0.002
            && is_even
            && choice.steps_since_change > STEPS_BEFORE_A_RISE
        {
            (self.current + 1).min(highest)
        } else {
            self.current
        };
        choice.newton_failed = false;
        if next != self.current && !self.is_fixed {
            self.current = next;
            self.accepted = None;
            *choice = OrderChoice::default();
        }
    }
}

/// Tolerance from which on a method's estimate exceeds its error, from measured errors of motors
/// that run up.
const MOST: [f64; 3] = [1e-3, 1e-4, 1e-6];

/// Returns the index of the order that is efficient for a tolerance. A method of s stages costs
/// about s evaluations and (s + 1) / 2 solutions per iteration.
fn highest_useful(rtol: f64) -> usize {
    if rtol > 1e-5 {
        0
    } else if rtol > 1e-8 {
        1
    } else {
        2
    }
}

impl OneStep for RadauSteps<'_> {
    fn begin(&mut self, time: f64, state: &[f64]) {
        self.time = time;
        self.step = 0.0;
        self.start.copy_from_slice(state);
        self.end.copy_from_slice(state);
        self.stretch.rate(time, &self.start, &mut self.rate);
        self.previous.is_known = false;
        self.accepted = None;
        self.newton.forget();
    }

    fn first_step(&mut self) -> f64 {
        let size = self.size;
        let scratch = (&mut self.scratch[..size], &mut self.error[..size]);
        let given = (&self.start[..size], &self.rate[..size]);
        first_step(self.stretch, 3, self.time, given, scratch)
    }

    fn attempt(&mut self, step: f64) -> Trial {
        self.step = step;
        let tried = self.try_step().and_then(|error| {
            if error <= 1.0 {
                self.look_at_end()?;
            }
            Ok(error)
        });
        self.was_rejected |= !matches!(tried, Ok(error) if error <= 1.0);
        match tried {
            Ok(error) => {
                self.last_error = error;
                Trial::Error(error)
            }
            Err(trial) => trial,
        }
    }

    fn end(&self) -> &[f64] {
        &self.end
    }

    fn interpolate(&mut self, time: f64, state: &mut [f64]) {
        let method = &self.methods[self.current];
        method.differences(&self.start, &self.stages, &mut self.within);
        let theta = (time - self.time) / self.step;
        method.evaluate(&self.within, theta, state);
    }

    fn carry(&mut self, tangents: &Tangents<'_>, start: &[f64], end: &mut [f64]) -> f64 {
        self.carry_over(tangents, start, end)
    }

    fn tangents_at(
        &mut self,
        _tangents: &Tangents<'_>,
        time: f64,
        start: &[f64],
        into: &mut [f64],
    ) {
        self.carried_at(time, start, into);
    }

    /// Returns the norm of (gamma/h I - J)^-1 (f(t, u) - u'(t)) at the middle, u being the
    /// polynomial.
    fn error_between(&mut self, _is_sampled: bool) -> f64 {
        const THETA: f64 = 0.5;
        let method = &self.methods[self.current];
        method.differences(&self.start, &self.stages, &mut self.within);
        method.evaluate(&self.within, THETA, &mut self.scratch);
        let time = self.time + THETA * self.step;
        self.stretch.state_rate(time, &self.scratch[..self.size], &mut self.error[..self.size]);
        method.slope_at(&self.within, THETA, &mut self.scratch);
        let states = &mut self.error[..self.size];
        for (error, slope) in states.iter_mut().zip(&self.scratch) {
            *error -= slope / self.step;
        }
        self.newton.solve_real(states);
        let (start, end) = (&self.start[..self.size], &self.end[..self.size]);
        let error = weighted_norm(self.stretch, states, start, end) / BETWEEN;
        self.last_error = self.last_error.max(error);
        self.was_rejected |= error > 1.0;
        error
    }

    fn accept(&mut self) {
        let method = &self.methods[self.current];
        method.differences(&self.start, &self.stages, &mut self.previous.differences);
        self.previous = Previous {
            differences: std::mem::take(&mut self.previous.differences),
            method: self.current,
            step: self.step,
            is_known: true,
        };
        self.time += self.step;
        self.start.copy_from_slice(&self.end);
        self.rate.copy_from_slice(&self.rate_at_end);
        self.choose_order();
        self.accepted = Some(Accepted { step: self.step, error: self.last_error.max(1e-2) });
        self.was_rejected = false;
        self.newton.start_anew();
    }

    fn pace(&self) -> Pace {
        let exponent = 1.0 / (self.methods[self.current].stages() as f64 + 1.0);
        let safety = 0.9 * self.newton.ease();
        // Controller of Gustafsson, limited by the trend of the error.
        let largest = match self.accepted {
            Some(before) if !self.was_rejected => {
                let trend = before.error / (self.last_error * self.last_error);
                (0.9 * self.step / before.step * trend.powf(exponent)).clamp(0.2, 8.0)
            }
            _ => 8.0,
        };
        let hold = if self.newton.is_reusable() { 1.2 } else { 1.0 };
        Pace { exponent, memory: 0.0, safety, smallest: 0.2, largest, hold }
    }
}
