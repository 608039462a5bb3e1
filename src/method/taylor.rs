//! Taylor's method: every step sums the solution's own power series.
//!
//! The coefficients come from recurrences that were derived with the machine
//! (`machinist_scenes::taylor`), so an order costs about as much as one
//! evaluation of the rate and orders of ten to twenty pay. Between its ends a
//! step is its polynomial: dense output costs no order of accuracy.

#[cfg(all(test, feature = "scenes"))]
mod order;
pub(super) mod quadrature;
mod step;
#[cfg(feature = "sweep")]
pub(crate) mod variants;

use machinist_scenes::taylor::TaylorSeries;

use super::system::FLOWS;
use super::{Integrator, Samples, Stopped, Stretch};
use crate::error::StopCause;
use quadrature::Gauss;
use step::{Tolerance, order_for};

/// Tighter tolerances are below rounding.
pub(crate) const LEAST_RTOL: f64 = 4.0 * f64::EPSILON;

/// Taylor series of an order that follows the tolerance.
pub(super) struct Taylor;

impl Integrator for Taylor {
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        if stretch.rtol < LEAST_RTOL {
            return Err(Stopped { time: stretch.from, cause: StopCause::StepTooSmall });
        }
        let series = stretch.system.simulator().taylor().ok_or_else(|| Stopped {
            time: stretch.from,
            cause: StopCause::Solver(
                "this simulator has no Taylor series: it was written by hand, or is too large; \
                 try the method `bdf`"
                    .to_owned(),
            ),
        })?;
        Run::new(stretch, series).integrate(state, samples)
    }
}

/// One stretch being integrated.
struct Run<'a> {
    stretch: &'a Stretch<'a>,
    series: &'a dyn TaylorSeries<f64>,
    states: usize,
    order: usize,
    /// Longest step to be tried next: one that is judged from coefficients which
    /// happen to vanish must not leap.
    longest: f64,
    tolerance: Tolerance,
    /// Coefficients of the step that is being taken, order after order.
    current: Vec<f64>,
    /// Coefficients at its end.
    following: Vec<f64>,
    workspace: Vec<f64>,
    /// The state at the step's end, and the derivative of the polynomial there.
    end: Vec<f64>,
    slope: Vec<f64>,
    flows: Option<Gauss>,
}

impl<'a> Run<'a> {
    fn new(stretch: &'a Stretch<'a>, series: &'a dyn TaylorSeries<f64>) -> Self {
        let states = stretch.system.states();
        let order = order_for(stretch.rtol);
        let room = || vec![0.0; (order + 1) * states];
        let with_flows = stretch.system.len() > states;
        Self {
            stretch,
            series,
            states,
            order,
            longest: (stretch.until - stretch.from) / step::GROWTH,
            tolerance: Tolerance::new(stretch.rtol, &stretch.atol[..states], order),
            current: room(),
            following: room(),
            workspace: vec![0.0; series.series_workspace(order)],
            end: vec![0.0; states],
            slope: vec![0.0; states],
            flows: with_flows.then(|| Gauss::new(order / 2 + 2)),
        }
    }

    fn integrate(mut self, state: &mut [f64], samples: &mut Samples<'_>) -> Result<(), Stopped> {
        let stretch = self.stretch;
        let mut time = stretch.from;
        self.expand(time, &state[..self.states], self.order);
        std::mem::swap(&mut self.current, &mut self.following);
        loop {
            let order = self.finite_orders(time)?;
            let (step, arrived) = self.step(time, order)?;
            let until = if arrived { stretch.until } else { time + step };
            self.record(time, until, state, samples);
            state[..self.states].copy_from_slice(&self.end);
            stretch.system.count(|work| work.steps += 1);
            if arrived {
                return Ok(());
            }
            if stretch.system.work().steps >= stretch.max_steps as u64 {
                let cause = StopCause::TooManySteps { limit: stretch.max_steps };
                return Err(Stopped { time: until, cause });
            }
            std::mem::swap(&mut self.current, &mut self.following);
            time = until;
        }
    }

    /// Tries steps until one passes; `end` and `following` are then those of its
    /// end. Returns its length and whether it reaches the end of the stretch.
    fn step(&mut self, time: f64, order: usize) -> Result<(f64, bool), Stopped> {
        let remaining = self.stretch.until - time;
        self.tolerance.weigh(&self.current[..self.states]);
        let mut step = self.tolerance.step_length(&self.current, order).min(self.longest);
        loop {
            let arrived = step >= remaining;
            step = step.min(remaining);
            if !arrived && time + step <= time {
                return Err(Stopped { time, cause: StopCause::StepTooSmall });
            }
            let used = &self.current[..(order + 1) * self.states];
            step::value_and_slope(used, step, &mut self.end, &mut self.slope);
            let end = std::mem::take(&mut self.end);
            // The last step needs the rate at its end, not a series.
            self.expand(time + step, &end, if arrived { 1 } else { self.order });
            self.end = end;
            let rate = &self.following[self.states..2 * self.states];
            let error = self.tolerance.error(&self.slope, rate, step, order);
            if error <= step::LARGEST_ERROR {
                self.longest = step::GROWTH * step;
                return Ok((step, arrived));
            }
            self.stretch.system.count(|work| work.rejected += 1);
            step *= step::shrink(error, order);
        }
    }

    /// Coefficients up to `order` of the solution through a state.
    fn expand(&mut self, time: f64, state: &[f64], order: usize) {
        let coefficients = &mut self.following[..(order + 1) * self.states];
        let (time, parameters) = (self.stretch.within(time), self.stretch.system.parameters());
        self.series.series(time, state, parameters, coefficients, &mut self.workspace);
        // Each order costs about as much as the rate.
        self.stretch.system.count(|work| work.rate_evaluations += order as u64);
    }

    /// The highest order up to which the current coefficients are finite.
    fn finite_orders(&self, time: f64) -> Result<usize, Stopped> {
        if step::all_finite(&self.current) {
            return Ok(self.order);
        }
        let broken = self.current.iter().position(|value| !value.is_finite());
        match broken {
            None => Ok(self.order),
            Some(index) if index >= 2 * self.states => Ok(index / self.states - 1),
            Some(index) => {
                let what = if index < self.states { "the state" } else { "the rate of" };
                Err(self.stretch.not_finite(what, index % self.states, time))
            }
        }
    }

    /// Pushes the samples between the ends of a step and carries the flows on.
    fn record(&mut self, from: f64, until: f64, state: &mut [f64], samples: &mut Samples<'_>) {
        let mut reached = from;
        let mut between = std::mem::take(&mut self.slope);
        while let Some(time) = samples.next_until(until) {
            self.carry_flows(from, reached, time, state);
            reached = time;
            if time >= until {
                state[..self.states].copy_from_slice(&self.end);
            } else {
                step::value(&self.current, time - from, &mut between);
                state[..self.states].copy_from_slice(&between);
            }
            samples.push(state);
        }
        self.slope = between;
        self.carry_flows(from, reached, until, state);
    }

    /// Integrates the flows from `reached` to `until` along the polynomial.
    fn carry_flows(&self, from: f64, reached: f64, until: f64, state: &mut [f64]) {
        let Some(gauss) = &self.flows else { return };
        if until <= reached {
            return;
        }
        let mut between = vec![0.0; self.states];
        let mut total = [0.0; FLOWS];
        for (time, weight) in gauss.points(reached, until) {
            step::value(&self.current, time - from, &mut between);
            let rates = self.stretch.flow_rates(time, &between);
            for (total, rate) in total.iter_mut().zip(rates) {
                *total += weight * rate;
            }
        }
        for (flow, total) in state[self.states..].iter_mut().zip(total) {
            *flow += total;
        }
    }
}
