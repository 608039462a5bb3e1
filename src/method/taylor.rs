//! Taylor's method: each step sums the power series of the solution.
//!
//! The coefficients follow from recurrences that were derived with the machine
//! (`machinist_contract::taylor`). An order costs about as much as one evaluation of the rate, so
//! orders of ten to twenty are efficient. Between its ends a step is its polynomial: dense output
//! has the full order of accuracy, and events are roots of guards on it.

pub(crate) mod magnitude;
#[cfg(test)]
mod order;
pub(super) mod quadrature;
pub(crate) mod step;
#[cfg(feature = "sweep")]
pub(crate) mod variants;

use machinist_contract::taylor::TaylorSeries;

use super::one_step::{LOOKS, OneStep, Pace, Trial, drive_all, rests};
use super::saturating::{FLAT, Motion, Saturating};
use super::system::FLOWS;
use super::{Integrator, Samples, Sealed, Stopped, Stretch};
use crate::error::StopCause;
use quadrature::Gauss;
use step::{Between, Tolerance, order_for};

/// Smallest relative tolerance; tighter ones are below rounding.
pub(crate) const LEAST_RTOL: f64 = 4.0 * f64::EPSILON;

/// Fractions of a step at which it is checked for corners.
const PROBES: [f64; 5] = [0.1, 0.3, 0.5, 0.7, 0.9];

/// Number of finite coefficients below which steps are of low order.
#[cfg(feature = "implicit")]
pub(super) const FEW: usize = 3;

/// Taylor series whose order depends on the tolerance.
pub(super) struct Taylor;

impl Sealed for Taylor {}

impl Integrator for Taylor {
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        let series = stretch
            .system
            .simulator()
            .taylor()
            .ok_or(Stopped { time: stretch.from, cause: StopCause::NoSeries })?;
        drive_all(&mut TaylorSteps::new(stretch, series), stretch, state, samples)
    }
}

/// Steps by Taylor series. Their length follows from the coefficients at their start, before they
/// are tried.
pub(super) struct TaylorSteps<'a> {
    stretch: &'a Stretch<'a>,
    series: &'a dyn TaylorSeries<f64>,
    states: usize,
    order: usize,
    /// Number of coefficients wanted at ends of steps.
    wanted: usize,
    time: f64,
    step: f64,
    /// Longest step to be tried next, which limits steps based on coefficients that vanish by
    /// chance.
    longest: f64,
    /// Highest order up to which the current coefficients are finite.
    finite: usize,
    /// Step size control for this order.
    pace: Pace,
    tolerance: Tolerance,
    /// Coefficients of the current step, order by order.
    current: Vec<f64>,
    /// Coefficients at its end.
    following: Vec<f64>,
    workspace: Vec<f64>,
    /// State at the start of the step with energy flows; the coefficients contain the former but
    /// not the latter.
    start: Vec<f64>,
    /// State at the end of the step with energy flows.
    end: Vec<f64>,
    /// Derivative of the polynomial at the end.
    slope: Vec<f64>,
    flows: Option<Gauss>,
    saturating: Option<Saturating<f64>>,
    /// Fractions of a step at which the rate is compared with the polynomial's derivative.
    probes: &'static [f64],
    between: Between<f64>,
}

impl<'a> TaylorSteps<'a> {
    pub(super) fn new(stretch: &'a Stretch<'a>, series: &'a dyn TaylorSeries<f64>) -> Self {
        let (states, len) = (stretch.system.states(), stretch.system.len());
        let order = order_for(stretch.rtol);
        let room = || vec![0.0; (order + 1) * states];
        Self {
            stretch,
            series,
            states,
            order,
            wanted: order,
            time: stretch.from,
            step: 0.0,
            longest: 0.0,
            finite: order,
            pace: step::pace(order),
            tolerance: Tolerance::new(stretch.rtol, &stretch.atol[..states], order),
            current: room(),
            following: room(),
            workspace: vec![0.0; series.series_workspace(order)],
            start: vec![0.0; len],
            end: vec![0.0; len],
            slope: vec![0.0; states],
            flows: (len > states).then(|| Gauss::new(order / 2 + 2)),
            saturating: Saturating::new(stretch.system.simulator().saturations(), states),
            probes: if series.has_corners() { &PROBES } else { &[] },
            between: Between::new(states),
        }
    }

    /// Returns the order of series for a relative tolerance.
    #[cfg(feature = "implicit")]
    pub(super) fn order_for(rtol: f64) -> usize {
        order_for(rtol)
    }

    /// Returns the length of a step from a state at the start of a stretch, and its order; `None` if
    /// the solution has no power series there.
    #[cfg(feature = "implicit")]
    pub(super) fn step_from(
        stretch: &Stretch<'_>,
        series: &dyn TaylorSeries<f64>,
        state: &[f64],
    ) -> Option<[f64; 2]> {
        let mut steps = TaylorSteps::new(stretch, series);
        let mut whole = vec![0.0; stretch.system.len()];
        whole[..state.len()].copy_from_slice(state);
        steps.begin(stretch.from, &whole);
        steps.longest = f64::INFINITY;
        (!steps.is_cut_short()).then(|| [steps.first_step(), steps.order as f64])
    }

    /// Returns whether too few coefficients are finite for a power series.
    #[cfg(feature = "implicit")]
    pub(super) fn has_no_series(&self) -> bool {
        self.finite < FEW
    }

    /// Returns time and states at the start of the next step.
    #[cfg(feature = "implicit")]
    pub(super) fn start(&self) -> (f64, &[f64]) {
        (self.time, &self.start[..self.states])
    }

    /// Computes the coefficients up to `order` of the solution through a state.
    fn expand(&mut self, time: f64, at: At, order: usize) {
        let state = match at {
            At::Start => &self.start[..self.states],
            At::End => &self.end[..self.states],
        };
        let coefficients = &mut self.following[..(order + 1) * self.states];
        let (time, system) = (self.stretch.within(time), self.stretch.system);
        let parameters = &system.held().all();
        self.series.series(time, state, parameters, coefficients, &mut self.workspace);
        // Each order costs about as much as a rate evaluation.
        self.stretch.system.count(|work| work.rate_evaluations += order as u64);
    }

    /// Makes the coefficients computed last those of the next step.
    fn take_following(&mut self) {
        std::mem::swap(&mut self.current, &mut self.following);
        let finite = self.finite_orders();
        if finite != self.finite {
            (self.finite, self.pace) = (finite, step::pace(finite));
        }
        self.tolerance.weigh(&self.current[..self.states]);
    }

    /// Returns the highest order up to which the current coefficients are finite.
    fn finite_orders(&self) -> usize {
        if step::all_finite(&self.current) {
            return self.order;
        }
        let broken = self.current.iter().position(|value| !value.is_finite());
        // State and rate are finite here; otherwise the previous step would have been refused.
        broken.map_or(self.order, |index| (index / self.states).max(2) - 1)
    }

    /// Returns the finite coefficients.
    fn used(&self) -> &[f64] {
        &self.current[..(self.finite + 1) * self.states]
    }

    /// Returns the error due to a bend within the step, relative to what is allowed. Behind a bend
    /// the rate differs from the polynomial's derivative; without one it does so only near the end
    /// of a step.
    fn error_within(&mut self) -> f64 {
        let used = &self.current[..(self.finite + 1) * self.states];
        let along = Along { stretch: self.stretch, from: self.time, coefficients: used };
        let (step, weights) = (self.step, self.tolerance.weights());
        let errors = self.probes.iter().map(|share| {
            step::lasting_error(along.defect(&mut self.between, share * step, weights), step)
        });
        errors.fold(0.0, f64::max)
    }

    /// Does the same at the places where functions saturate.
    fn error_where_functions_saturate(&mut self) -> f64 {
        let Some(saturating) = &mut self.saturating else { return 0.0 };
        let used = &self.current[..(self.finite + 1) * self.states];
        let mut along = Along { stretch: self.stretch, from: self.time, coefficients: used };
        let (step, weights) = (self.step, self.tolerance.weights());
        let ends = (&used[..self.states], step, &self.end[..self.states]);
        let mut largest = 0.0f64;
        saturating.places(
            &mut along,
            ends,
            |place| place > 0.0,
            |along, after, _| {
                largest = largest.max(along.defect(&mut self.between, after, weights));
            },
        );
        step::lasting_error(largest, step)
    }

    /// Returns the energy flows at a time within the step, integrated along the polynomial.
    fn flows_until(&self, until: f64) -> [f64; FLOWS] {
        let mut total = [0.0; FLOWS];
        let Some(gauss) = &self.flows else { return total };
        total.copy_from_slice(&self.start[self.states..]);
        if until <= self.time {
            return total;
        }
        let mut between = vec![0.0; self.states];
        for (time, weight) in gauss.points(self.time, until) {
            step::value(self.used(), time - self.time, &mut between);
            let rates = self.stretch.flow_rates(time, &between);
            for (total, rate) in total.iter_mut().zip(rates) {
                *total += weight * rate;
            }
        }
        total
    }
}

/// The motion over a step.
struct Along<'a> {
    stretch: &'a Stretch<'a>,
    from: f64,
    coefficients: &'a [f64],
}

impl Along<'_> {
    /// Returns the largest defect y' - f in units of the tolerance at a time after the start.
    fn defect(&self, between: &mut Between<f64>, after: f64, inverse_weights: &[f64]) -> f64 {
        between.defect(self.coefficients, after, inverse_weights, |state, rate| {
            self.stretch.state_rate(self.from + after, state, rate);
        })
    }
}

impl Motion<f64> for Along<'_> {
    const OFF: f64 = 0.0;
    const SEES: f64 = FLAT;

    fn states<const N: usize>(&mut self, times: [f64; N], states: &mut [[f64; N]]) {
        step::states_at(self.coefficients, times, states);
    }

    fn arguments(&self, time: f64, state: &[f64], arguments: &mut [f64]) {
        self.stretch.saturating_arguments(self.from + time, state, arguments);
    }
}

#[derive(Clone, Copy)]
enum At {
    Start,
    End,
}

impl OneStep for TaylorSteps<'_> {
    fn begin(&mut self, time: f64, state: &[f64]) {
        self.time = time;
        self.step = 0.0;
        self.longest = (self.stretch.until - self.stretch.from) / step::GROWTH;
        self.start.copy_from_slice(state);
        self.end.copy_from_slice(state);
        self.expand(time, At::Start, self.order);
        self.take_following();
    }

    fn first_step(&mut self) -> f64 {
        self.tolerance.step_length(&self.current, self.finite).min(self.longest)
    }

    /// Limits the coefficients of a last step, which needs the rate at its end but not a series.
    fn is_last(&mut self, is_last: bool) {
        self.wanted = if is_last { 1 } else { self.order };
    }

    fn attempt(&mut self, step: f64) -> Trial {
        self.step = step;
        let used = &self.current[..(self.finite + 1) * self.states];
        step::value_and_slope(used, step, &mut self.end[..self.states], &mut self.slope);
        // This does not depend on the series, so the processor can do both in parallel.
        let bent = self.error_where_functions_saturate();
        self.expand(self.time + step, At::End, self.wanted);
        let begin = &self.following[..2 * self.states];
        let mut trial = step::trial(&self.tolerance, &self.slope, begin, (step, self.finite));
        if let Trial::Error(error) = trial
            && error <= 1.0
        {
            trial = Trial::Error(error.max(bent).max(self.error_within()));
        }
        if matches!(trial, Trial::Error(error) if error <= 1.0) && self.flows.is_some() {
            let flows = self.flows_until(self.time + step);
            self.end[self.states..].copy_from_slice(&flows);
        }
        trial
    }

    fn end(&self) -> &[f64] {
        &self.end
    }

    fn interpolate(&mut self, time: f64, state: &mut [f64]) {
        step::value(self.used(), time - self.time, &mut state[..self.states]);
        if self.flows.is_some() {
            state[self.states..].copy_from_slice(&self.flows_until(time));
        }
    }

    fn interpolate_each(&mut self, times: &[f64], states: &mut [f64]) {
        if self.flows.is_some() {
            let size = self.start.len();
            for (time, state) in times.iter().zip(states.chunks_exact_mut(size)) {
                self.interpolate(*time, state);
            }
            return;
        }
        let all = times.chunks(step::ABREAST).zip(states.chunks_mut(step::ABREAST * self.states));
        for (times, states) in all {
            step::values(self.used(), times.iter().map(|time| time - self.time), states);
        }
    }

    fn sees_bends(&self) -> bool {
        true
    }

    /// Adds the sizes of all terms of the polynomial.
    fn reach(&mut self, _within: [f64; 2], _start: &[f64], reach: &mut [f64]) {
        let reach = &mut reach[..self.states];
        reach.fill(0.0);
        for terms in self.used().chunks_exact(self.states).skip(1).rev() {
            for (reach, term) in reach.iter_mut().zip(terms) {
                *reach = (*reach + term.abs()) * self.step;
            }
        }
    }

    fn accept(&mut self) {
        self.time += self.step;
        self.longest = step::GROWTH * self.step;
        let moves = self.start.iter().copied().zip(self.end.iter().copied());
        if rests(moves.take(self.states), self.stretch.atol) {
            self.longest = self.longest.min(self.stretch.looked_at() / LOOKS);
        }
        std::mem::swap(&mut self.start, &mut self.end);
        if self.wanted == self.order {
            self.take_following();
        }
    }

    fn pace(&self) -> Pace {
        self.pace
    }

    fn own_step(&mut self) -> Option<f64> {
        Some(self.first_step())
    }

    #[cfg(feature = "implicit")]
    fn is_cut_short(&self) -> bool {
        step::is_cut_short(self.finite, self.order)
    }
}
