//! Taylor's method for many variants of a machine at once, one in each lane.
//!
//! Every lane has its own parameters, time, step and jumps, and takes the next
//! variant when it is done. What a lane computes does not depend on its neighbours:
//! results are those of one run after another, to the last bit.

mod lane;

use machinist_contract::taylor::TaylorSeries;
use machinist_contract::{Real, Simulator};

use super::MIDDLE;
use super::step::{self, order_for};
use crate::error::StopCause;
use crate::lanes::Lanes;
use crate::method::Stopped;
use crate::method::one_step::{self, End, LOOKS, end_of_step, is_too_small, rests};
use lane::{Lane, Trial};

pub(crate) use lane::{Outcome, Overseer, Variant};

/// Runs variants of one relative tolerance until there are no more; `done` gets each
/// with its number in the order of the iterator. Steps that are good at their ends are looked at
/// in their middle too if told so.
pub(crate) fn integrate<R: Lanes>(
    (machine, series): (&dyn Simulator<R>, &dyn TaylorSeries<R>),
    (rtol, looks_within): (f64, bool),
    variants: &mut dyn Iterator<Item = Variant<'_>>,
    done: &mut dyn FnMut(usize, Result<Outcome, Stopped>),
) {
    let mut variants = variants.enumerate();
    let mut lanes: Vec<Option<Lane<'_>>> = Vec::with_capacity(R::COUNT);
    for _ in 0..R::COUNT {
        lanes.push(variants.next().map(|(number, variant)| Lane::new(number, variant)));
    }
    let Some(first) = lanes.first().and_then(Option::as_ref) else { return };
    let mut bundle = Bundle::<R>::new(series, rtol, &first.variant);
    if looks_within {
        bundle.middle = Some(Middle::new(machine, &first.variant));
    }
    for (index, lane) in lanes.iter_mut().enumerate() {
        match lane {
            Some(lane) => bundle.load(index, lane),
            // An idle lane repeats its neighbour, whose numbers are harmless.
            None => bundle.copy_lane(0, index),
        }
    }
    while lanes.iter().any(Option::is_some) {
        bundle.expand();
        bundle.judge(&mut lanes);
        for (index, place) in lanes.iter_mut().enumerate() {
            let Some(lane) = place else { continue };
            let Some(outcome) = bundle.go_on(index, lane) else { continue };
            done(lane.number, outcome);
            *place = variants.next().map(|(number, variant)| Lane::new(number, variant));
            if let Some(lane) = place {
                bundle.load(index, lane);
            }
        }
        bundle.aim(&lanes);
    }
}

/// What lanes compute in the middle of their steps.
struct Middle<'a, R> {
    machine: &'a dyn Simulator<R>,
    constants: Vec<R>,
    state: Vec<R>,
    slope: Vec<R>,
    rate: Vec<R>,
}

impl<'a, R: Lanes> Middle<'a, R> {
    fn new(machine: &'a dyn Simulator<R>, first: &Variant<'_>) -> Self {
        let states = || vec![R::literal(0.0); first.initial.len()];
        let constants = vec![R::literal(0.0); machine.constants()];
        Self { machine, constants, state: states(), slope: states(), rate: states() }
    }
}

/// What all lanes compute together.
struct Bundle<'a, R> {
    series: &'a dyn TaylorSeries<R>,
    states: usize,
    order: usize,
    parameters: Vec<R>,
    /// Coefficients at the start of each lane's step, order after order.
    current: Vec<R>,
    /// Coefficients at its end.
    following: Vec<R>,
    workspace: Vec<R>,
    /// Where `following` is computed.
    time: R,
    end: Vec<R>,
    /// Ends of the steps that lanes try, for those that do.
    aimed: Vec<R>,
    slope: Vec<R>,
    /// Zero in the lanes whose coefficients are finite, NaN in others.
    zeros: R,
    /// What every lane allows of every state, apart from its size.
    absolute: Vec<R>,
    relative: R,
    /// One over what is allowed at the start of each lane's step.
    inverse_weights: Vec<R>,
    /// Sizes of the last coefficients, from the last one back, in units of the tolerance.
    sizes: [R; step::JUDGED],
    scratch: Vec<f64>,
    middle: Option<Middle<'a, R>>,
}

impl<'a, R: Lanes> Bundle<'a, R> {
    fn new(series: &'a dyn TaylorSeries<R>, rtol: f64, first: &Variant<'_>) -> Self {
        let (states, order) = (first.initial.len(), order_for(rtol));
        let zeros = |count: usize| vec![R::literal(0.0); count];
        Self {
            series,
            states,
            order,
            parameters: zeros(first.parameters.len()),
            current: zeros((order + 1) * states),
            following: zeros((order + 1) * states),
            workspace: zeros(series.series_workspace(order)),
            time: R::literal(0.0),
            end: zeros(states),
            aimed: zeros(states),
            slope: zeros(states),
            zeros: R::literal(0.0),
            absolute: vec![R::literal(1.0); states],
            relative: R::literal(0.0),
            inverse_weights: vec![R::literal(1.0); states],
            sizes: [R::literal(0.0); step::JUDGED],
            scratch: vec![0.0; step::JUDGED.max(3) * states],
            middle: None,
        }
    }

    /// Puts a variant at its start.
    fn load(&mut self, index: usize, lane: &mut Lane<'_>) {
        for (into, value) in self.parameters.iter_mut().zip(&lane.variant.parameters) {
            into.set_lane(index, *value);
        }
        for (into, value) in self.end.iter_mut().zip(&lane.variant.initial) {
            into.set_lane(index, *value);
        }
        for (into, value) in self.absolute.iter_mut().zip(lane.tolerance.absolute()) {
            into.set_lane(index, *value);
        }
        self.relative.set_lane(index, lane.tolerance.relative());
        if let Some(middle) = &mut self.middle {
            middle.machine.prepare(&self.parameters, &mut middle.constants);
        }
        while lane.next_sample_until(lane.time).is_some() {
            lane.rows.extend_from_slice(&lane.variant.initial);
            lane.taken += 1;
        }
        self.time.set_lane(index, lane.within(lane.time));
        lane.longest = (lane.until() - lane.from()) / step::GROWTH;
        lane.trial = Trial::Start;
    }

    fn copy_lane(&mut self, from: usize, to: usize) {
        for values in [&mut self.parameters, &mut self.end] {
            for value in values {
                let known = value.lane(from);
                value.set_lane(to, known);
            }
        }
        let known = self.time.lane(from);
        self.time.set_lane(to, known);
    }

    /// Coefficients of every lane at the end of its step.
    fn expand(&mut self) {
        self.series.series(
            self.time,
            &self.end,
            &self.parameters,
            &mut self.following,
            &mut self.workspace,
        );
    }

    /// Takes the coefficients of the lanes whose step passes.
    fn judge(&mut self, lanes: &mut [Option<Lane<'_>>]) {
        let mut rejected = R::literal(0.0);
        let mut is_any = false;
        let (defects, finite) = self.defects();
        let within = self.defects_within(lanes);
        for (index, lane) in lanes.iter_mut().enumerate() {
            let Some(lane) = lane else { continue };
            lane.work.rate_evaluations += self.order as u64;
            let Trial::Step { now } = lane.trial else { continue };
            let mut trial = if finite.lane(index) == 0.0 {
                let error = step::error(defects.lane(index), lane.step, lane.order);
                step::passing(error)
            } else {
                self.trial(index, lane)
            };
            if let (Some(within), one_step::Trial::Error(error)) = (within, trial)
                && error <= 1.0
            {
                let within = step::lasting_error(within.lane(index), lane.step);
                trial = one_step::Trial::Error(error.max(within));
            }
            if matches!(trial, one_step::Trial::Error(error) if error <= 1.0) {
                self.record(index, lane, now);
                lane.trial = Trial::Accepted;
            } else {
                lane.trial = Trial::Rejected;
                lane.work.rejected += 1;
                lane.step *= one_step::shrink(trial, step::pace(lane.order));
                if is_too_small(lane.step, lane.time) {
                    lane.stop(match trial {
                        one_step::Trial::NotFinite { what, index } => {
                            StopCause::NotFinite { what: format!("{what} state number {index}") }
                        }
                        _ => StopCause::StepTooSmall,
                    });
                }
                rejected.set_lane(index, 1.0);
                is_any = true;
            }
        }
        if is_any {
            let half = R::literal(0.5);
            for (current, following) in self.current.iter_mut().zip(&self.following) {
                *current = R::select_less(rejected, half, *following, *current);
            }
        } else {
            std::mem::swap(&mut self.current, &mut self.following);
        }
        self.zeros = zeros(&self.current);
        self.weigh();
    }

    /// The largest defect of every lane's step in units of its tolerance, and zero in the
    /// lanes in which state and rate at the end are finite.
    fn defects(&self) -> (R, R) {
        let zero = R::literal(0.0);
        let begin = &self.following[..2 * self.states];
        let rates = self.slope.iter().zip(&begin[self.states..]);
        let defects = rates.zip(&self.inverse_weights);
        let largest = defects.fold(zero, |largest, ((slope, rate), inverse)| {
            larger(largest, ((*slope - *rate) * *inverse).abs())
        });
        (largest, zeros(begin))
    }

    /// The largest defect in the middle of every lane's step in units of its tolerance, if it
    /// is looked for.
    fn defects_within(&mut self, lanes: &[Option<Lane<'_>>]) -> Option<R> {
        let middle = self.middle.as_mut()?;
        let zero = R::literal(0.0);
        let (mut after, mut time) = (zero, self.time);
        for (index, lane) in lanes.iter().enumerate() {
            let Some(lane) = lane else { continue };
            if let Trial::Step { .. } = lane.trial {
                let share = MIDDLE * lane.step;
                after.set_lane(index, share);
                time.set_lane(index, lane.within(lane.time + share));
            }
        }
        let Middle { machine, constants, state, slope, rate } = middle;
        step::value_and_slope(&self.current, after, state, slope);
        machine.prepared_rate(time, state, &self.parameters, constants, rate);
        let rates = slope.iter().zip(&*rate).zip(&self.inverse_weights);
        Some(rates.fold(zero, |largest, ((slope, rate), inverse)| {
            larger(largest, ((*slope - *rate) * *inverse).abs())
        }))
    }

    /// Weighs by the tolerances at the start of every lane's step, and measures the last
    /// coefficients by that.
    fn weigh(&mut self) {
        let one = R::literal(1.0);
        let allowed = self.absolute.iter().zip(&self.current);
        for (inverse, (absolute, value)) in self.inverse_weights.iter_mut().zip(allowed) {
            *inverse = one / (*absolute + self.relative * value.abs());
        }
        for (size, terms) in self.sizes.iter_mut().zip(self.current.chunks_exact(self.states).rev())
        {
            *size = terms
                .iter()
                .zip(&self.inverse_weights)
                .fold(R::literal(0.0), |largest, (term, inverse)| {
                    larger(largest, (*term * *inverse).abs())
                });
        }
    }

    /// What came of a lane's step to where something is not finite.
    fn trial(&mut self, index: usize, lane: &mut Lane<'_>) -> one_step::Trial {
        gather(&self.inverse_weights, index, lane.tolerance.inverse_weights());
        let (slope, begin) = self.scratch.split_at_mut(self.states);
        let begin = &mut begin[..2 * self.states];
        gather(&self.slope, index, slope);
        gather(&self.following[..2 * self.states], index, begin);
        step::trial(&lane.tolerance, slope, begin, (lane.step, lane.order))
    }

    /// Asks who looks at a lane's steps whether its variant stays.
    fn ask(&mut self, index: usize, lane: &mut Lane<'_>, step: f64) {
        let span = (lane.from(), lane.until());
        let Some(overseer) = &mut lane.variant.overseer else { return };
        let state = &mut self.scratch[..self.states];
        gather(&self.current, index, state);
        let stays = if lane.trial == Trial::Start {
            overseer.begin(span, state, lane.order)
        } else {
            overseer.stays(lane.time, state, step)
        };
        if !stays {
            lane.stop(StopCause::Interrupted);
        }
    }

    /// Decides what a lane tries next; gives its outcome if it is done.
    fn go_on(&mut self, index: usize, lane: &mut Lane<'_>) -> Option<Result<Outcome, Stopped>> {
        if lane.trial == Trial::Accepted && lane.time >= lane.until() {
            lane.stretch += 1;
            if lane.stretch + 1 == lane.variant.ends.len() {
                let rows = std::mem::take(&mut lane.rows);
                return Some(Ok(Outcome { rows, work: lane.work }));
            }
            // The end of the last step is where the next stretch starts.
            lane.trial = Trial::Start;
            lane.longest = (lane.until() - lane.from()) / step::GROWTH;
            self.time.set_lane(index, lane.within(lane.time));
            return None;
        }
        if lane.trial != Trial::Rejected {
            let tried = lane.step;
            self.measure(index, lane);
            self.ask(index, lane, tried);
        }
        if lane.trial == Trial::Accepted {
            if lane.work.steps >= lane.variant.max_steps as u64 {
                lane.stop(StopCause::TooManySteps { limit: lane.variant.max_steps });
            } else if lane.time + lane.step <= lane.time {
                lane.stop(StopCause::StepTooSmall);
            }
        }
        if let Some(stopped) = lane.stopped.take() {
            return Some(Err(stopped));
        }
        let End { now, tried, .. } = end_of_step(lane.time, lane.step, lane.until());
        lane.step = tried;
        lane.trial = Trial::Step { now };
        None
    }

    /// Orders and length of a step from new coefficients.
    fn measure(&mut self, index: usize, lane: &mut Lane<'_>) {
        lane.order = self.finite_orders(index, lane);
        if lane.order == self.order {
            let sizes = self.sizes.map(|size| size.lane(index));
            lane.step = lane.tolerance.step_length_of(sizes, lane.order).min(lane.longest);
            return;
        }
        let state = &mut self.scratch[..self.states];
        gather(&self.current, index, state);
        lane.tolerance.weigh(state);
        let judged = step::JUDGED.min(lane.order);
        let newest = &mut self.scratch[..judged * self.states];
        gather(&self.current[(lane.order + 1 - judged) * self.states..], index, newest);
        lane.step = lane.tolerance.step_length_by(newest, lane.order).min(lane.longest);
    }

    /// State and slope at the end of every lane's step.
    fn aim(&mut self, lanes: &[Option<Lane<'_>>]) {
        let (zero, half) = (R::literal(0.0), R::literal(0.5));
        let (mut steps, mut waits) = (zero, R::literal(1.0));
        for (index, lane) in lanes.iter().enumerate() {
            let Some(lane) = lane else { continue };
            if let Trial::Step { .. } = lane.trial {
                steps.set_lane(index, lane.step);
                waits.set_lane(index, 0.0);
                self.time.set_lane(index, lane.within(lane.time + lane.step));
            }
        }
        step::value_and_slope(&self.current, steps, &mut self.aimed, &mut self.slope);
        for (end, aimed) in self.end.iter_mut().zip(&self.aimed) {
            *end = R::select_less(waits, half, *aimed, *end);
        }
    }

    /// Takes the samples of a step that has passed, and goes to its end.
    fn record(&mut self, index: usize, lane: &mut Lane<'_>, until: f64) {
        while let Some(time) = lane.next_sample_until(until) {
            for state in 0..self.states {
                let value = if time >= until {
                    self.end[state].lane(index)
                } else {
                    self.value(index, state, time - lane.time)
                };
                lane.rows.push(value);
            }
            lane.taken += 1;
        }
        lane.time = until;
        lane.longest = step::GROWTH * lane.step;
        let state =
            |index_of: usize| (self.current[index_of].lane(index), self.end[index_of].lane(index));
        if rests((0..self.states).map(state), &lane.variant.atol) {
            lane.longest = lane.longest.min((lane.until() - lane.from()) / LOOKS);
        }
        lane.work.steps += 1;
    }

    /// The polynomial of a state after the start of the lane's step.
    fn value(&self, index: usize, state: usize, after: f64) -> f64 {
        let mut terms = self.current.iter().skip(state).step_by(self.states).rev();
        let highest = terms.next().map_or(0.0, |term| term.lane(index));
        terms.fold(highest, |value, term| Real::mul_add(value, after, term.lane(index)))
    }

    /// The highest order up to which the coefficients of a lane are finite; those
    /// beyond become zero.
    fn finite_orders(&mut self, index: usize, lane: &mut Lane<'_>) -> usize {
        if self.zeros.lane(index).is_finite() {
            return self.order;
        }
        let broken = self.current.iter().position(|value| !value.lane(index).is_finite());
        let Some(broken) = broken else { return self.order };
        if broken < 2 * self.states {
            let what = if broken < self.states { "the state" } else { "the rate of" };
            let what = format!("{what} state number {}", broken % self.states);
            lane.stop(StopCause::NotFinite { what });
            return self.order;
        }
        let order = broken / self.states - 1;
        for value in &mut self.current[(order + 1) * self.states..] {
            value.set_lane(index, 0.0);
        }
        order
    }
}

/// The larger number in every lane; one that is not a number does not count.
fn larger<R: Lanes>(size: R, value: R) -> R {
    R::select_less(size, value, value, size)
}

/// Zero in the lanes in which all numbers are finite, NaN in others.
fn zeros<R: Lanes>(values: &[R]) -> R {
    // Several sums, for additions that wait for one another would take most of the time.
    let zero = R::literal(0.0);
    let (blocks, rest) = values.as_chunks::<8>();
    let mut sums = [zero; 8];
    for block in blocks {
        for (sum, value) in sums.iter_mut().zip(block) {
            *sum = *sum + *value * zero;
        }
    }
    sums.iter()
        .fold(rest.iter().fold(zero, |sum, value| sum + *value * zero), |sum, part| sum + *part)
}

/// Numbers of one lane, as many as there is room for.
fn gather<R: Lanes>(values: &[R], index: usize, into: &mut [f64]) {
    for (into, value) in into.iter_mut().zip(values) {
        *into = value.lane(index);
    }
}
