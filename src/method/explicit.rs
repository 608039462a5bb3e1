//! Explicit Runge-Kutta pairs.
//!
//! For small machines the overhead of a step matters beside the rate: work arrays are allocated
//! once, stages lie in lanes of four, and products with zero coefficients are left out.

mod carried;

use std::ops::Range;

use super::lanes::{Sum, combine, copy, padded, sum};
use super::one_step::{OneStep, Pace, Trial, drive_all, first_step};
use super::tableau::{DOP853, Pair, Row, TSIT5};
use super::{Integrator, Method, Samples, Sealed, Stopped, Stretch};
use crate::method::sensitivity::Tangents;
use carried::Carried;

/// The pair [`TSIT5`].
pub(super) struct Tsit5;
/// The pair [`DOP853`].
pub(super) struct Dop853;

impl Sealed for Tsit5 {}

impl Integrator for Tsit5 {
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        drive_all(&mut ExplicitSteps::new(&TSIT5, stretch), stretch, state, samples)
    }
}

impl Sealed for Dop853 {}

impl Integrator for Dop853 {
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        drive_all(&mut ExplicitSteps::new(&DOP853, stretch), stretch, state, samples)
    }
}

/// Returns the explicit pair of a method, if it is one.
pub(super) fn pair_of(method: Method) -> Option<&'static Pair> {
    match method {
        Method::Tsit5 => Some(&TSIT5),
        Method::Dop853 => Some(&DOP853),
        _ => None,
    }
}

/// Steps of an explicit pair.
pub(super) struct ExplicitSteps<'a> {
    pair: &'static Pair,
    stretch: &'a Stretch<'a>,
    size: usize,
    /// `size` plus padding of zeros.
    width: usize,
    time: f64,
    step: f64,
    start: Vec<f64>,
    end: Vec<f64>,
    /// Argument of the last stage but one, which is also at the end of the step.
    argument: Vec<f64>,
    /// k_i, one after another, with the extra ones last.
    stages: Vec<f64>,
    error: Vec<f64>,
    /// Rows of a, with offsets into `stages`.
    sums: Vec<Sum>,
    estimates: Vec<Sum>,
    weights: Vec<f64>,
    has_extra_stages: bool,
    /// Data for the middle of a step, made on demand.
    middle: Option<Middle>,
    carried: Option<Carried>,
}

impl<'a> ExplicitSteps<'a> {
    pub(super) fn new(pair: &'static Pair, stretch: &'a Stretch<'a>) -> Self {
        let size = stretch.system.len();
        let width = padded(size);
        let count = pair.nodes.len();
        let offsets = |row: &Row| sum(row, width);
        let zeros = || vec![0.0; width];
        Self {
            pair,
            stretch,
            size,
            width,
            time: stretch.from,
            step: 0.0,
            start: zeros(),
            end: zeros(),
            argument: zeros(),
            stages: vec![0.0; width * count],
            error: zeros(),
            sums: pair.rows.iter().chain(pair.dense.extra).map(offsets).collect(),
            estimates: pair.estimates.iter().map(offsets).collect(),
            weights: vec![0.0; count],
            has_extra_stages: false,
            middle: None,
            carried: stretch.system.tangents().map(|t| Carried::new(pair, t, width)),
        }
    }

    fn error_of_tangents(
        &self,
        carried: &mut Carried,
        tangents: &Tangents<'_>,
        ends: (&[f64], &[f64]),
    ) -> f64 {
        let count = tangents.len();
        tangents.errors(self.stretch, ends, |norm| {
            let mut error =
                |index| carried.estimate(index, self.step).map(|errors| norm(&errors[..count]));
            match error(0) {
                Some(first) if first > 0.0 => error(1).map_or(first, |lower| blended(first, lower)),
                first => first.unwrap_or(f64::NAN),
            }
        })
    }

    /// Evaluates J and df/dp at the states of stages.
    fn linearize(&self, carried: &mut Carried, tangents: &Tangents<'_>, stages: Range<usize>) {
        for stage in stages {
            let time = self.time + self.pair.nodes[stage] * self.step;
            carried.linearize(tangents, stage, |state, values, drive| {
                tangents.linearize(self.stretch, time, &state[..self.size], values, drive);
            });
        }
    }

    /// Returns time and state at the start of the next step.
    #[cfg(feature = "implicit")]
    pub(super) fn start(&self) -> (f64, &[f64]) {
        (self.time, &self.start[..self.stretch.system.states()])
    }

    /// Returns |h lambda| of the fastest motion in the last two stages, which are both at the end
    /// of the step: h |f(Y_s) - f(Y_(s-1))| / |Y_s - Y_(s-1)|; 0 if they are equal (Hairer, Wanner,
    /// section IV.2).
    #[cfg(feature = "implicit")]
    pub(super) fn stiffness(&self) -> f64 {
        let last = (self.pair.rows.len() - 1) * self.width;
        let (before, last) = self.stages[last - self.width..].split_at(self.width);
        let distance = |a: &[f64], b: &[f64]| {
            a.iter()
                .zip(b)
                .zip(self.stretch.atol)
                .zip(&self.end)
                .map(|(((a, b), atol), size)| {
                    let ratio = (a - b) / (atol + self.stretch.rtol * size.abs());
                    ratio * ratio
                })
                .sum::<f64>()
        };
        let states = distance(&self.end, &self.argument);
        let ratio = (distance(last, before) / states).sqrt();
        if ratio.is_finite() { self.step.abs() * ratio } else { 0.0 }
    }

    fn rate(&mut self, stage: usize, at: At) {
        let time = self.time + self.pair.nodes[stage] * self.step;
        let state = match at {
            At::Argument => &self.argument,
            At::End => &self.end,
        };
        if let Some(carried) = &mut self.carried {
            copy(state, carried.state(stage));
        }
        let rate = &mut self.stages[stage * self.width..][..self.size];
        self.stretch.rate(time, &state[..self.size], rate);
    }

    /// Returns the error of the step relative to the tolerances.
    fn error(&mut self) -> f64 {
        let mut norm = |row: &Sum| {
            combine(row, &self.stages, self.step, None, &mut self.error);
            super::one_step::weighted_norm(
                self.stretch,
                &self.error[..self.size],
                &self.start,
                &self.end,
            )
        };
        let error = norm(&self.estimates[0]);
        match self.estimates.get(1) {
            Some(lower) if error > 0.0 => blended(error, norm(lower)),
            _ => error,
        }
    }

    /// Returns which quantity of a refused attempt is not finite.
    fn trouble(&self) -> Trial {
        let is_bad = |value: &f64| !value.is_finite();
        let of_rates = self.stages.iter().position(is_bad);
        match of_rates {
            Some(position) => {
                Trial::NotFinite { what: "the rate of", index: position % self.width }
            }
            None => match self.end.iter().position(is_bad) {
                Some(index) => Trial::NotFinite { what: "the state", index },
                None => Trial::Error(f64::INFINITY),
            },
        }
    }

    /// Evaluates the stages that only the dense output needs, unless they are present.
    fn add_extra_stages(&mut self) {
        if self.has_extra_stages {
            return;
        }
        for stage in self.pair.rows.len()..self.pair.nodes.len() {
            let start = Some(&self.start[..]);
            // The memory of the error is free here; the argument of the last stage but one is not.
            combine(&self.sums[stage], &self.stages, self.step, start, &mut self.error);
            if let Some(carried) = &mut self.carried {
                carried.state(stage).copy_from_slice(&self.error);
            }
            let time = self.time + self.pair.nodes[stage] * self.step;
            let rate = &mut self.stages[stage * self.width..][..self.size];
            self.stretch.rate(time, &self.error[..self.size], rate);
        }
        self.has_extra_stages = true;
    }
}

/// Dense output at the middle of a step.
struct Middle {
    /// Weights b_i(1/2).
    state: Sum,
    /// Derivatives of b_i at 1/2.
    slope: Sum,
    rate: Vec<f64>,
}

impl Middle {
    fn new(pair: &Pair, width: usize) -> Self {
        /// Central differences of order 8, exact for polynomials up to that degree.
        const DIFFERENCES: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
        const DISTANCE: f64 = 0.125;
        let at = |theta: f64| {
            let mut weights = vec![0.0; pair.nodes.len()];
            (pair.dense.weights)(theta, &mut weights);
            weights
        };
        let mut slopes = vec![0.0; pair.nodes.len()];
        for (steps, weight) in (1..).zip(DIFFERENCES) {
            let distance = f64::from(steps) * DISTANCE;
            let [after, before] = [at(0.5 + distance), at(0.5 - distance)];
            for (slope, (after, before)) in slopes.iter_mut().zip(after.iter().zip(&before)) {
                *slope += weight / DISTANCE * (after - before);
            }
        }
        let of = |weights: Vec<f64>| {
            let row = weights.into_iter().enumerate().filter(|(_, weight)| *weight != 0.0);
            let row: Vec<(usize, f64)> = row.collect();
            sum(&row, width)
        };
        Self { state: of(at(0.5)), slope: of(slopes), rate: vec![0.0; width] }
    }
}

/// Returns the error from an estimate of higher order and one of lower order.
fn blended(error: f64, lower: f64) -> f64 {
    error * (error / (error * error + 0.01 * lower * lower).sqrt())
}

#[derive(Clone, Copy)]
enum At {
    Argument,
    End,
}

impl OneStep for ExplicitSteps<'_> {
    fn begin(&mut self, time: f64, state: &[f64]) {
        if let Some(carried) = &mut self.carried {
            carried.has_first_stage = false;
        }
        let stretch = self.stretch;
        stretch.system.log().inspect(|log| log.begin((stretch.from, stretch.until), state));
        self.time = time;
        self.step = 0.0;
        self.end[..self.size].copy_from_slice(state);
        self.start[..self.size].copy_from_slice(state);
        self.stages.fill(0.0);
        self.rate(0, At::End);
    }

    fn first_step(&mut self) -> f64 {
        let states = self.stretch.system.states();
        let (state, rate) = (&self.start[..states], &self.stages[..states]);
        let trial = &mut self.argument[..states];
        let trial_rate = &mut self.error[..states];
        first_step(self.stretch, self.pair.order, self.time, (state, rate), (trial, trial_rate))
    }

    fn attempt(&mut self, step: f64) -> Trial {
        self.step = step;
        self.has_extra_stages = false;
        let last = self.pair.rows.len() - 1;
        for stage in 1..last {
            let start = Some(&self.start[..]);
            combine(&self.sums[stage], &self.stages, step, start, &mut self.argument);
            self.rate(stage, At::Argument);
        }
        combine(&self.sums[last], &self.stages, step, Some(&self.start), &mut self.end);
        let last_is_in_the_estimate =
            self.pair.estimates[0].last().is_some_and(|&(stage, _)| stage == last);
        if last_is_in_the_estimate {
            self.rate(last, At::End);
        }
        let error = self.error();
        if error <= 1.0 && !last_is_in_the_estimate {
            self.rate(last, At::End);
        }
        let is_finite = || {
            let rate = &self.stages[last * self.width..][..self.width];
            self.end.iter().chain(rate).all(|value| value.is_finite())
        };
        if error <= 1.0 && is_finite() || error > 1.0 && error < f64::INFINITY {
            Trial::Error(error)
        } else {
            self.trouble()
        }
    }

    fn end(&self) -> &[f64] {
        &self.end[..self.size]
    }

    /// Returns the difference of the dense output's slope and the rate, times the step. This
    /// applies to pairs whose dense output has stages of its own, which the error of the step does
    /// not include.
    ///
    /// Once a fast motion has decayed to the last bit, the error of a step hundreds of its time
    /// constants long is small, but stages beyond its end amplify rounding by as much.
    fn error_between(&mut self, is_sampled: bool) -> f64 {
        /// Factor for the difference, which is an order larger than the error of a state.
        const AMISS: f64 = 100.0;
        if !is_sampled || self.pair.dense.extra.is_empty() {
            return 0.0;
        }
        self.add_extra_stages();
        let (size, pair, width) = (self.size, self.pair, self.width);
        let middle = self.middle.get_or_insert_with(|| Middle::new(pair, width));
        combine(&middle.state, &self.stages, self.step, Some(&self.start), &mut self.error);
        let time = self.time + 0.5 * self.step;
        self.stretch.rate(time, &self.error[..size], &mut middle.rate[..size]);
        combine(&middle.slope, &self.stages, 1.0, None, &mut self.error);
        for (slope, rate) in self.error.iter_mut().zip(&middle.rate) {
            *slope = self.step * (*slope - rate);
        }
        let error = &self.error[..size];
        let error = super::one_step::weighted_norm(self.stretch, error, &self.start, &self.end);
        error / AMISS
    }

    fn interpolate(&mut self, time: f64, state: &mut [f64]) {
        self.add_extra_stages();
        let theta = (time - self.time) / self.step;
        (self.pair.dense.weights)(theta, &mut self.weights);
        state.copy_from_slice(&self.start[..self.size]);
        for (weight, rate) in self.weights.iter().zip(self.stages.chunks_exact(self.width)) {
            let weight = self.step * weight;
            for (state, rate) in state.iter_mut().zip(rate) {
                *state += weight * rate;
            }
        }
    }

    /// Takes the cubic through the states and rates at both ends.
    fn sketch(&mut self, time: f64, state: &mut [f64]) {
        let theta = (time - self.time) / self.step;
        let rest = 1.0 - theta;
        let last = (self.pair.rows.len() - 1) * self.width;
        let (first, last) = (&self.stages[..self.size], &self.stages[last..][..self.size]);
        let ends = self.start.iter().zip(&self.end).zip(first.iter().zip(last));
        for (state, ((start, end), (first, last))) in state.iter_mut().zip(ends) {
            let chord = end - start;
            let bow = rest * (self.step * first - chord) - theta * (self.step * last - chord);
            *state = start + theta * (chord + rest * bow);
        }
    }

    /// Uses the rates of the stages, which lie all over the step; twice the largest covers those in
    /// between.
    fn reach(&mut self, _within: [f64; 2], _start: &[f64], reach: &mut [f64]) {
        reach.fill(0.0);
        for rates in self.stages.chunks_exact(self.width).take(self.pair.rows.len()) {
            for (reach, rate) in reach.iter_mut().zip(rates) {
                // Unlike `max`, a comparison takes one instruction for several states.
                let rate = rate.abs();
                *reach = if rate > *reach { rate } else { *reach };
            }
        }
        for reach in reach {
            *reach *= 2.0 * self.step.abs();
        }
    }

    fn accept(&mut self) {
        let log = self.stretch.system.log();
        log.inspect(|log| log.take((self.time, self.step), &self.start[..self.size]));
        self.time += self.step;
        copy(&self.end, &mut self.start);
        let last = self.pair.rows.len() - 1;
        self.stages.copy_within(last * self.width..(last + 1) * self.width, 0);
        if let Some(carried) = &mut self.carried {
            // After a projection onto constraints, the state differs from that of the last stage.
            carried.restart(last, self.stretch.system.constraints().is_none());
        }
    }

    fn carry(&mut self, tangents: &Tangents<'_>, start: &[f64], end: &mut [f64]) -> f64 {
        let Some(mut carried) = self.carried.take() else { return f64::NAN };
        carried.begin(start);
        let last = self.pair.rows.len() - 1;
        let first = usize::from(carried.has_first_stage);
        if first == 0 {
            carried.state(0).copy_from_slice(&self.start);
        }
        self.linearize(&mut carried, tangents, first..last + 1);
        carried.add_stages(tangents, first..last + 1, self.step);
        carried.has_first_stage = true;
        // The last stage is at the end of the step.
        end.copy_from_slice(carried.reached(end.len()));
        let error = if tangents.is_controlled() {
            self.error_of_tangents(&mut carried, tangents, (start, end))
        } else {
            0.0
        };
        self.carried = Some(carried);
        error
    }

    fn tangents_at(
        &mut self,
        tangents: &Tangents<'_>,
        time: f64,
        _start: &[f64],
        into: &mut [f64],
    ) {
        self.add_extra_stages();
        let Some(mut carried) = self.carried.take() else { return };
        if !carried.has_extra_stages {
            let extra = self.pair.rows.len()..self.pair.nodes.len();
            self.linearize(&mut carried, tangents, extra.clone());
            carried.add_stages(tangents, extra, self.step);
            carried.has_extra_stages = true;
        }
        let theta = (time - self.time) / self.step;
        (self.pair.dense.weights)(theta, &mut self.weights);
        carried.interpolate(&self.weights, self.step, into);
        self.carried = Some(carried);
    }

    fn pace(&self) -> Pace {
        let exponent = 1.0 / f64::from(self.pair.estimate_order + 1);
        // The method of order eight changes its step less often and needs no memory.
        let memory = if self.pair.order > 5 { 0.0 } else { 0.04 };
        Pace {
            exponent: exponent - 0.75 * memory,
            memory,
            safety: 0.9,
            smallest: 0.2,
            largest: 8.0,
            hold: 1.0,
        }
    }
}
