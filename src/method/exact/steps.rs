//! Steps of a linear machine between switches: the power series of the closed form, to rounding.
//!
//! ```text
//! z(t + h) = sum of A^k z h^k/k!    k up to p
//! ```
//!
//! The norm of A bounds what is left out, whatever follows. Steps are as long as that is below
//! rounding: about a period of the fastest motion, or for ever where the series ends, as in a free
//! flight. Affine guards are polynomials of the same kind, so bounds of their derivatives are
//! certain, and so are their first zeros.

use std::rc::Rc;

use machinist_contract::linear::LinearEquations;

use super::equations::{Equations, Refusal, product};
use super::tangents::Carried;
use crate::method::Stretch;
use crate::method::one_step::{Bounded, OneStep, Pace, Trial};
use crate::method::sensitivity::Tangents;
use crate::method::system::FLOWS;
use crate::method::taylor::quadrature::Gauss;

/// Least order of the series.
const ORDER: usize = 24;
/// Number of orders that follow each other as tolerances tighten by a factor of four. Results do not
/// depend on the order but for rounding, which the difference of two runs then shows.
const ORDERS: usize = 8;
/// Share of the rounding of a state that may be left out.
const SHARE: f64 = 0.25;

/// Steps in closed form.
pub(in crate::method) struct ExactSteps<'a> {
    stretch: &'a Stretch<'a>,
    linear: &'a dyn LinearEquations<f64>,
    equations: Rc<Equations>,
    order: usize,
    time: f64,
    step: f64,
    /// Unit of time of the coefficients \[s\].
    unit: f64,
    /// Longest step from the start \[s\].
    longest: f64,
    /// Coefficients of all unknowns, order by order.
    coefficients: Vec<f64>,
    /// State at the start of the step with energy flows.
    start: Vec<f64>,
    /// State at its end.
    end: Vec<f64>,
    /// Coefficients of watched functions, as far as they were asked for.
    functions: Vec<(Bounded, Vec<f64>)>,
    flows: Option<Gauss>,
    carried: Option<Carried>,
    /// Reason why equations changed within a stretch to ones without a closed form.
    refusal: Option<Refusal>,
    is_last: bool,
}

impl<'a> ExactSteps<'a> {
    /// Returns steps from a state at the start of the stretch.
    ///
    /// # Errors
    /// [`Refusal`] if there is no closed form.
    pub(in crate::method) fn new(
        stretch: &'a Stretch<'a>,
        linear: &'a dyn LinearEquations<f64>,
        state: &[f64],
    ) -> Result<Self, Refusal> {
        let equations = Equations::at(stretch, linear, stretch.from, state)?;
        let tightenings = (-0.5 * stretch.rtol.log2()).round().max(0.0) as usize;
        let order = ORDER + tightenings % ORDERS;
        let (states, len) = (stretch.system.states(), stretch.system.len());
        Ok(Self {
            stretch,
            linear,
            equations,
            order,
            time: stretch.from,
            step: 0.0,
            unit: 1.0,
            longest: 0.0,
            coefficients: Vec::new(),
            start: vec![0.0; len],
            end: vec![0.0; len],
            functions: Vec::new(),
            flows: (len > states).then(|| Gauss::new(order / 2 + 2)),
            carried: stretch.system.tangents().map(Carried::new),
            refusal: None,
            is_last: false,
        })
    }

    /// Returns the reason why the last step has no continuation in closed form.
    pub(in crate::method) fn refusal(&self) -> Option<&Refusal> {
        self.refusal.as_ref()
    }

    /// Computes the series from the start.
    fn expand(&mut self) {
        let (stretch, time) = (self.stretch, self.time);
        let states = stretch.system.states();
        if !self.equations.are_for(stretch, time, &self.start) {
            match Equations::at(stretch, self.linear, time, &self.start[..states]) {
                Ok(equations) => self.equations = equations,
                Err(refusal) => {
                    self.refusal = Some(refusal);
                    self.longest = f64::NAN;
                    return;
                }
            }
        }
        let equations = &self.equations;
        let size = equations.size();
        let span = stretch.until - time;
        self.unit = if equations.norm > 0.0 { equations.norm.recip() } else { span };
        self.coefficients.resize((self.order + 1) * size, 0.0);
        let (first, _) = self.coefficients.split_at_mut(size);
        first[..states].copy_from_slice(&self.start[..states]);
        equations.waves(time, first);
        for order in 0..self.order {
            let (known, next) = self.coefficients.split_at_mut((order + 1) * size);
            let factor = self.unit / (order + 1) as f64;
            equations.apply(factor, &known[order * size..], &mut next[..size]);
        }
        self.functions.clear();
        let resolved = match self.carried {
            // A parameter may cause a motion that the machine does not have.
            Some(_) => self.resolved().min(Carried::LONGEST),
            None => self.resolved(),
        };
        self.longest = (resolved * self.unit).min(equations.until - time);
        // An order costs about as much as a rate.
        stretch.system.count(|work| work.rate_evaluations += self.order as u64);
    }

    /// Returns the longest step over which the series is exact to rounding, in units of time.
    ///
    /// With q = step norm/(p + 1) below a half, the terms left out are at most q/(1 - q) times the
    /// last one, in the balanced norm.
    fn resolved(&self) -> f64 {
        const ROUNDS: usize = 4;
        let size = self.equations.size();
        let last = &self.coefficients[(self.order - 1) * size..];
        if last.iter().all(|value| *value == 0.0) {
            return f64::INFINITY;
        }
        let mut step = 0.5 * (self.order + 1) as f64;
        for _ in 0..ROUNDS {
            let excess = self.excess(step);
            if excess <= 1.0 {
                break;
            }
            step *= (1.0 / excess).powf(1.0 / (self.order - 1) as f64);
        }
        step
    }

    /// Returns the largest term left out of the series of a step over what may be left out.
    fn excess(&self, step: f64) -> f64 {
        let (size, order) = (self.equations.size(), self.order);
        let mut excess: f64 = 0.0;
        for unknown in 0..size {
            let term = |k: usize| self.coefficients[k * size + unknown].abs();
            let last = (term(order) * step + term(order - 1)) * step.powi(order as i32 - 1);
            if last == 0.0 {
                continue;
            }
            let range = (0..=order).rev().fold(0.0, |sum, k| sum * step + term(k));
            excess = excess.max(last / (SHARE * f64::EPSILON * range));
        }
        excess
    }

    /// Computes the state at a time since the start.
    fn sum(&self, since: f64, state: &mut [f64]) {
        let (size, x) = (self.equations.size(), since / self.unit);
        state.fill(0.0);
        for terms in self.coefficients.chunks_exact(size).rev() {
            for (value, term) in state.iter_mut().zip(terms) {
                *value = *value * x + term;
            }
        }
    }

    /// Returns the energy flows at a time within the step.
    fn flows_until(&self, until: f64) -> [f64; FLOWS] {
        let states = self.stretch.system.states();
        let mut total = [0.0; FLOWS];
        let Some(gauss) = &self.flows else { return total };
        total.copy_from_slice(&self.start[states..]);
        if until <= self.time {
            return total;
        }
        let mut between = vec![0.0; states];
        for (time, weight) in gauss.points(self.time, until) {
            self.sum(time - self.time, &mut between);
            let rates = self.stretch.flow_rates(time, &between);
            for (total, rate) in total.iter_mut().zip(rates) {
                *total += weight * rate;
            }
        }
        total
    }

    /// Carries sensitivities from the start of the step to a time within it.
    fn carry_until(
        &mut self,
        until: f64,
        tangents: &Tangents<'_>,
        start: &[f64],
        into: &mut [f64],
    ) {
        let Some(mut carried) = self.carried.take() else { return };
        let span = [self.time, until];
        carried.carry(&self.equations, span, (start, into), |time, zero, drive| {
            let mut state = vec![0.0; self.stretch.system.states()];
            self.sum(time - self.time, &mut state);
            tangents.rate(self.stretch, time, &state, zero, drive);
        });
        self.carried = Some(carried);
    }

    /// Returns the place of the coefficients of a watched function; `None` if it is constant.
    fn function(&mut self, of: Bounded) -> Option<usize> {
        if let Some(known) = self.functions.iter().position(|(known, _)| *known == of) {
            return Some(known);
        }
        let slopes = self.equations.slopes(of)?;
        let terms = self.coefficients.chunks_exact(self.equations.size());
        let terms = terms.map(|terms| product(slopes, terms)).collect();
        self.functions.push((of, terms));
        Some(self.functions.len() - 1)
    }
}

impl OneStep for ExactSteps<'_> {
    fn begin(&mut self, time: f64, state: &[f64]) {
        (self.time, self.step) = (time, 0.0);
        self.start.copy_from_slice(state);
        self.end.copy_from_slice(state);
        self.expand();
    }

    fn first_step(&mut self) -> f64 {
        self.longest.min(self.stretch.until - self.time)
    }

    fn is_last(&mut self, is_last: bool) {
        self.is_last = is_last;
    }

    fn attempt(&mut self, step: f64) -> Trial {
        if self.refusal.is_some() {
            return Trial::Unsolved { shrink: 0.0 };
        }
        self.step = step;
        let states = self.stretch.system.states();
        let mut end = std::mem::take(&mut self.end);
        self.sum(step, &mut end[..states]);
        if self.flows.is_some() {
            let flows = self.flows_until(self.time + step);
            end[states..].copy_from_slice(&flows);
        }
        self.end = end;
        match self.end.iter().position(|value| !value.is_finite()) {
            Some(index) => Trial::NotFinite { what: "the state", index: index.min(states - 1) },
            None => Trial::Error(0.0),
        }
    }

    fn end(&self) -> &[f64] {
        &self.end
    }

    fn interpolate(&mut self, time: f64, state: &mut [f64]) {
        let states = self.stretch.system.states();
        self.sum(time - self.time, &mut state[..states]);
        if self.flows.is_some() {
            state[states..].copy_from_slice(&self.flows_until(time));
        }
    }

    /// Adds the sizes of all terms of the series.
    fn reach(&mut self, _within: [f64; 2], _start: &[f64], reach: &mut [f64]) {
        let reach = &mut reach[..self.stretch.system.states()];
        let x = self.step / self.unit;
        reach.fill(0.0);
        for terms in self.coefficients.chunks_exact(self.equations.size()).skip(1).rev() {
            for (reach, term) in reach.iter_mut().zip(terms) {
                *reach = (*reach + term.abs()) * x;
            }
        }
    }

    fn value(&mut self, of: Bounded, time: f64) -> Option<f64> {
        if !self.equations.are_for(self.stretch, self.time, &self.start) {
            return None;
        }
        let place = self.function(of)?;
        let x = (time - self.time) / self.unit;
        let terms = &self.functions[place].1;
        Some(terms.iter().rev().fold(0.0, |sum, term| sum * x + term))
    }

    fn bound(&mut self, of: Bounded, order: usize, until: f64) -> Option<f64> {
        // A relation may be held in another way for a moment.
        if !self.equations.are_for(self.stretch, self.time, &self.start) {
            return None;
        }
        let Some(place) = self.function(of) else { return Some(0.0) };
        let x = (until - self.time).max(0.0) / self.unit;
        let terms = &self.functions[place].1;
        let factor = |k: usize| (k + 1 - order..=k).map(|factor| factor as f64).product::<f64>();
        let sum =
            (order..=self.order).rev().fold(0.0, |sum, k| sum * x + factor(k) * terms[k].abs());
        // The terms left out are at most as large as the last one of each unknown.
        let last = &self.coefficients[self.order * self.equations.size()..];
        let slopes = self.equations.slopes(of).unwrap_or_default();
        let last: f64 = slopes.iter().map(|(at, slope)| (slope * last[*at]).abs()).sum();
        let left_out = 2.0 * factor(self.order) * last * x.powi((self.order - order) as i32);
        Some((sum + left_out) / self.unit.powi(order as i32))
    }

    fn carry(&mut self, tangents: &Tangents<'_>, start: &[f64], end: &mut [f64]) -> f64 {
        self.carry_until(self.time + self.step, tangents, start, end);
        0.0
    }

    fn tangents_at(&mut self, tangents: &Tangents<'_>, time: f64, start: &[f64], into: &mut [f64]) {
        self.carry_until(time, tangents, start, into);
    }

    fn accept(&mut self) {
        self.time += self.step;
        std::mem::swap(&mut self.start, &mut self.end);
        self.end.copy_from_slice(&self.start);
        if !self.is_last {
            self.expand();
        }
    }

    fn pace(&self) -> Pace {
        Pace { exponent: 1.0, memory: 0.0, safety: 1.0, smallest: 0.1, largest: 2.0, hold: 1.0 }
    }

    fn own_step(&mut self) -> Option<f64> {
        Some(self.first_step())
    }
}
