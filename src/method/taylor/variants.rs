//! Taylor's method for many variants of a machine, one in each lane.
//!
//! Each lane has its own parameters, time, step and jumps, and takes the next variant when it is
//! done. Lanes do not influence each other: results equal those of single runs, to the last bit.

mod clock;
mod judge;
mod lane;
mod overseer;

use std::time::{Duration, Instant};

use machinist_contract::SideBySide;
use machinist_contract::taylor::TaylorSeries;

use super::step::{self, Between, Judges, Tolerance, order_for};
use crate::error::StopCause;
use crate::lanes::Lanes;
use crate::method::one_step::resting;
use crate::method::patience::Patience;
use crate::method::saturating::{FLAT, Motion, Saturating};
use clock::Clock;
use judge::zeros;
use lane::Lane;

pub(crate) use clock::places;
pub(crate) use lane::{Ended, Outcome, Variant};
pub(crate) use overseer::{Equations, Moment, Overseer};

/// Number of steps of all lanes between checks for reasons to end variants from outside.
const TURNS: u32 = 16;

/// Runs all variants, which have the same relative tolerance, each no longer than `patience`
/// allows. `done` receives each result with its number in the order of the iterator. A variant that
/// the overseer rejects is interrupted.
pub(crate) fn integrate<'a, R: Lanes>(
    (machine, series): (&'a dyn SideBySide<R>, &'a dyn TaylorSeries<R>),
    rtol: f64,
    patience: Patience<'a>,
    overseer: Option<Box<dyn Overseer<R> + 'a>>,
    variants: &mut dyn Iterator<Item = Variant>,
    done: &mut dyn FnMut(usize, Ended),
) {
    let mut variants = variants.enumerate();
    let mut next = || variants.next().map(|(number, variant)| Lane::new(number, variant));
    let mut lanes: Vec<Option<Lane>> = Vec::with_capacity(R::COUNT);
    lanes.resize_with(R::COUNT, &mut next);
    let Some(first) = lanes.first().and_then(Option::as_ref) else { return };
    let mut bundle = Bundle::<R>::new((machine, series), rtol, &first.variant);
    bundle.overseer = overseer;
    bundle.wait = Wait { patience, ..Wait::default() };
    for (index, lane) in lanes.iter_mut().enumerate() {
        match lane {
            Some(lane) => bundle.load(index, lane),
            // An idle lane repeats its neighbour, whose numbers are harmless.
            None => bundle.copy_lane(0, index),
        }
    }
    bundle.equations.prepare();
    while bundle.clock.running != 0 {
        bundle.expand();
        bundle.judge(&mut lanes);
        let finished = bundle.go_on(&mut lanes);
        let finished = finished | bundle.lose_patience(!finished, &mut lanes);
        for index in places(finished) {
            let place = &mut lanes[index];
            if let Some(lane) = place.take() {
                let steps = bundle.clock.steps.lane(index) as u64;
                done(lane.number, lane.ended(steps, bundle.order));
            }
            *place = next();
            match place {
                Some(lane) => bundle.load(index, lane),
                None => bundle.clock.stop(index),
            }
        }
        if finished != 0 {
            bundle.equations.prepare();
        }
        bundle.leave();
    }
}

/// Computing time of lanes.
#[derive(Default)]
struct Wait<'a> {
    patience: Patience<'a>,
    turns: u32,
    /// Time of the last check, if there is a limit.
    looked: Option<Instant>,
}

impl Wait<'_> {
    /// Returns whether checks are due, and the computing time since the last one.
    fn look(&mut self) -> Option<Duration> {
        let is_due = self.turns.is_multiple_of(TURNS);
        self.turns = self.turns.wrapping_add(1);
        if !is_due {
            return None;
        }
        let now = self.patience.limit.map(|_| Instant::now());
        let since = now.zip(self.looked).map(|(now, looked)| now - looked);
        self.looked = now;
        Some(since.unwrap_or_default())
    }
}

/// The motions of all lanes over their steps.
struct Along<'a, R> {
    equations: &'a Equations<'a, R>,
    clock: &'a Clock<R>,
    coefficients: &'a [R],
}

impl<R: Lanes> Along<'_, R> {
    /// Returns the time, moved into the segment.
    fn time(&self, after: R) -> R {
        self.clock.within(self.clock.time + after)
    }
}

impl<R: Lanes> Motion<R> for Along<'_, R> {
    const OFF: f64 = 0.0;
    const SEES: f64 = FLAT;

    fn states<const N: usize>(&mut self, times: [R; N], states: &mut [[R; N]]) {
        step::states_at(self.coefficients, times, states);
    }

    fn arguments(&self, time: R, state: &[R], arguments: &mut [R]) {
        self.equations.saturating_arguments(self.time(time), state, arguments);
    }
}

/// Common computation of all lanes.
struct Bundle<'a, R> {
    series: &'a dyn TaylorSeries<R>,
    states: usize,
    rtol: f64,
    order: usize,
    /// Coefficients for the lengths of steps of this order.
    judges: Judges,
    equations: Equations<'a, R>,
    clock: Clock<R>,
    /// Coefficients at the start of each lane's step, order by order.
    current: Vec<R>,
    /// Coefficients at its end.
    following: Vec<R>,
    workspace: Vec<R>,
    /// Times at which `following` is computed.
    time: R,
    end: Vec<R>,
    /// Ends of the steps that lanes try.
    aimed: Vec<R>,
    slope: Vec<R>,
    /// Number of finite terms in each lane.
    terms: R,
    /// Upper limit of defect times step for an accepted step.
    limit: R,
    /// Lanes with an accepted step, as bits and as 1 or 0.
    passed: u32,
    good: R,
    /// 1 in the lanes whose step is repeated, 0 in others.
    rejected: R,
    /// Absolute tolerance of every state in each lane.
    absolute: Vec<R>,
    relative: R,
    /// Inverse of the tolerance at the start of each lane's step.
    inverse_weights: Vec<R>,
    /// Inverse of the tolerance at its end.
    following_weights: Vec<R>,
    /// Maximum move of a state at rest.
    resting: Vec<R>,
    /// Sizes of the last coefficients, from the last one back, in units of the tolerance.
    sizes: [R; step::JUDGED],
    scratch: Vec<f64>,
    saturating: Option<Saturating<R>>,
    between: Between<R>,
    /// Supervisor of the steps, if there is one.
    overseer: Option<Box<dyn Overseer<R> + 'a>>,
    wait: Wait<'a>,
}

impl<'a, R: Lanes> Bundle<'a, R> {
    fn new(
        (machine, series): (&'a dyn SideBySide<R>, &'a dyn TaylorSeries<R>),
        rtol: f64,
        first: &Variant,
    ) -> Self {
        let (states, order) = (first.initial.len(), order_for(rtol));
        let zeros = |count: usize| vec![R::literal(0.0); count];
        Self {
            series,
            states,
            rtol,
            order,
            judges: step::judges(order, step::decay(rtol, order)),
            equations: Equations::new(machine),
            clock: Clock::new(),
            current: zeros((order + 1) * states),
            following: zeros((order + 1) * states),
            workspace: zeros(series.series_workspace(order)),
            time: R::literal(0.0),
            end: zeros(states),
            aimed: zeros(states),
            slope: zeros(states),
            terms: R::literal(0.0),
            limit: R::literal(0.0),
            passed: 0,
            rejected: R::literal(0.0),
            good: R::literal(0.0),
            absolute: vec![R::literal(1.0); states],
            relative: R::literal(step::aimed_at(rtol)),
            inverse_weights: vec![R::literal(1.0); states],
            following_weights: vec![R::literal(1.0); states],
            resting: zeros(states),
            sizes: [R::literal(0.0); step::JUDGED],
            scratch: vec![0.0; step::JUDGED.max(3) * states],
            saturating: Saturating::new(machine.saturations(), states),
            between: Between::new(states),
            overseer: None,
            wait: Wait::default(),
        }
    }

    /// Sets a lane to the start of a variant.
    fn load(&mut self, index: usize, lane: &mut Lane) {
        self.equations.load(index, &lane.variant.parameters);
        for (into, value) in self.end.iter_mut().zip(&lane.variant.initial) {
            into.set_lane(index, *value);
        }
        for ((absolute, resting_by), atol) in
            self.absolute.iter_mut().zip(&mut self.resting).zip(&lane.variant.tolerance.atol)
        {
            absolute.set_lane(index, step::aimed_at(*atol));
            resting_by.set_lane(index, resting(*atol));
        }
        while lane.next_sample() <= lane.from() {
            lane.rows.extend_from_slice(&lane.variant.initial);
            lane.taken += 1;
        }
        self.clock.load(index, lane);
        self.start_at(index);
    }

    fn copy_lane(&mut self, from: usize, to: usize) {
        for values in [&mut self.equations.parameters, &mut self.end] {
            for value in values {
                let known = value.lane(from);
                value.set_lane(to, known);
            }
        }
        let known = self.time.lane(from);
        self.time.set_lane(to, known);
    }

    /// Makes the start of a lane's segment the next point of its coefficients.
    fn start_at(&mut self, index: usize) {
        let time = self.clock.within(self.clock.time);
        self.time.set_lane(index, time.lane(index));
    }

    /// Computes the coefficients of each lane at the end of its step, and the weights there.
    fn expand(&mut self) {
        // These divisions run in parallel with the series.
        let one = R::literal(1.0);
        let allowed = self.absolute.iter().zip(&self.end);
        for (inverse, (absolute, value)) in self.following_weights.iter_mut().zip(allowed) {
            *inverse = one / (*absolute + self.relative * value.abs());
        }
        self.series.series(
            self.time,
            &self.end,
            &self.equations.parameters,
            &mut self.following,
            &mut self.workspace,
        );
    }

    /// Decides on the next step of each lane; returns the lanes that are done, as bits.
    fn go_on(&mut self, lanes: &mut [Option<Lane>]) -> u32 {
        let arrived = self.passed & self.clock.arrived();
        let (passed, starting) = (self.passed & !arrived, self.clock.starting());
        let fresh = passed | starting;
        let tried = self.clock.step;
        self.measure();
        // Aims would show later which coefficients are not finite, but these lanes need to know
        // now.
        let suspect = passed & self.clock.stuck() | self.starting_short(starting);
        for index in places(suspect) {
            if let Some(lane) = &mut lanes[index] {
                self.measure_finite(index, lane);
            }
        }
        let leaving = self.ask((passed, starting), tried, lanes);
        let exhausted = passed & self.clock.exhausted();
        let stuck = passed & self.clock.stuck();
        for index in places(exhausted | stuck) {
            let Some(lane) = &mut lanes[index] else { continue };
            let (steps, time) = (self.clock.steps.lane(index) as u64, self.clock.time.lane(index));
            let cause = lane.out_of_steps(steps, time, &self.wait.patience);
            self.clock.allow(index, lane);
            let stuck = (stuck >> index & 1 == 1).then_some(StopCause::StepTooSmall);
            if let Some(cause) = cause.or(stuck) {
                lane.stop(time, cause);
            }
        }
        for index in places(starting) {
            self.clock.waits.set_lane(index, 0.0);
        }
        let broken = fresh & self.aim();
        self.aim_finite(broken, passed, lanes);
        let mut done = 0;
        for index in places(arrived) {
            let Some(lane) = &mut lanes[index] else { continue };
            lane.stretch += 1;
            if lane.stretch + 1 == lane.variant.ends.len() {
                done |= 1 << index;
            } else {
                // The next segment starts at the end of the last step.
                self.clock.begin(index, lane);
                self.start_at(index);
            }
        }
        let rejected = self.clock.running & !fresh & !arrived;
        for index in places(rejected | suspect | leaving | exhausted | stuck | broken) {
            if lanes[index].as_ref().is_some_and(|lane| lane.stopped.is_some()) {
                done |= 1 << index;
            }
        }
        done
    }

    /// Stops lanes of `of` that have computed for too long, each for its share of the time, or that
    /// have to end, and returns them.
    fn lose_patience(&mut self, of: u32, lanes: &mut [Option<Lane>]) -> u32 {
        let Some(since) = self.wait.look() else { return 0 };
        let share = since / self.clock.running.count_ones();
        let mut ended = 0;
        for index in places(self.clock.running & of) {
            let Some(lane) = &mut lanes[index] else { continue };
            if let Some(cause) = lane.out_of_patience(share, &self.wait.patience) {
                lane.stop(self.clock.time.lane(index), cause);
                ended |= 1 << index;
            }
        }
        ended
    }

    /// Computes steps of the lanes with new coefficients, assuming that those are finite.
    fn measure(&mut self) {
        let half = R::literal(0.5);
        let step = step::step_length(self.sizes, &self.judges, self.order);
        let step = self.clock.bounded(step);
        self.clock.step = R::select_less(self.rejected, half, step, self.clock.step);
        let (terms, limit) = (self.order + 1, step::limit(self.order + 1));
        self.terms = R::select_less(self.rejected, half, R::literal(terms as f64), self.terms);
        self.limit = R::select_less(self.rejected, half, R::literal(limit), self.limit);
    }

    /// Computes order and length of a lane's step from new coefficients if some of them are not
    /// finite; those beyond the order are set to zero. Returns whether this applies.
    fn measure_finite(&mut self, index: usize, lane: &mut Lane) -> bool {
        let broken = self.current.iter().position(|value| !value.lane(index).is_finite());
        let Some(broken) = broken else { return false };
        if broken < 2 * self.states {
            let what = if broken < self.states { "the state" } else { "the rate of" };
            let what = format!("{what} state number {}", broken % self.states);
            lane.stop(self.clock.time.lane(index), StopCause::not_finite(what));
            return true;
        }
        let order = broken / self.states - 1;
        if self.overseer.is_some() && step::is_cut_short(order, self.order) {
            // A supervised variant does not go on in this way.
            lane.stop(self.clock.time.lane(index), StopCause::Interrupted);
            return true;
        }
        for value in &mut self.current[(order + 1) * self.states..] {
            value.set_lane(index, 0.0);
        }
        let mut tolerance = Tolerance::new(self.rtol, &lane.variant.tolerance.atol, self.order);
        let state = &mut self.scratch[..self.states];
        gather(&self.current, index, state);
        tolerance.weigh(state);
        let judged = step::JUDGED.min(order);
        let newest = &mut self.scratch[..judged * self.states];
        gather(&self.current[(order + 1 - judged) * self.states..], index, newest);
        let step = self.clock.bounded(R::literal(tolerance.step_length_by(newest, order)));
        self.clock.step.set_lane(index, step.lane(index));
        self.terms.set_lane(index, (order + 1) as f64);
        self.limit.set_lane(index, step::limit(order + 1));
        true
    }

    /// Returns the highest order up to which a lane's coefficients are finite.
    fn order_of(&self, index: usize) -> usize {
        self.terms.lane(index) as usize - 1
    }

    /// Returns the lanes that begin with coefficients that are not all finite, if there is an
    /// overseer.
    fn starting_short(&self, starting: u32) -> u32 {
        if self.overseer.is_none() || starting == 0 {
            return 0;
        }
        starting & !R::less(zeros(&self.current), R::literal(0.5))
    }

    /// Asks the overseer which variants stay, after accepted steps and at starts of segments; stops
    /// the others, and returns them.
    fn ask(&mut self, (passed, starting): (u32, u32), tried: R, lanes: &mut [Option<Lane>]) -> u32 {
        let Some(overseer) = &mut self.overseer else { return 0 };
        let at = Moment {
            equations: &self.equations,
            time: self.clock.within(self.clock.time),
            left: self.clock.left(),
            state: &self.current[..self.states],
        };
        let mut leaving = overseer.look((passed, self.good), tried, &at);
        if starting != 0 {
            let is_first =
                |lane: &Option<Lane>| lane.as_ref().is_some_and(|lane| lane.stretch == 0);
            let first = places(starting).filter(|index| is_first(&lanes[*index]));
            let first = first.fold(0, |first, index| first | 1 << index);
            leaving |= overseer.begin(starting, first, self.terms, &at);
        }
        for index in places(leaving) {
            if let Some(lane) = &mut lanes[index] {
                lane.stop(self.clock.time.lane(index), StopCause::Interrupted);
            }
        }
        leaving
    }

    /// Computes state and slope at the end of each lane's step; returns the lanes in which the
    /// state is not finite, as bits.
    fn aim(&mut self) -> u32 {
        self.clock.aim();
        self.sum();
        !R::less(zeros(&self.aimed), R::literal(0.5))
    }

    fn sum(&mut self) {
        let (step, end) = (self.clock.step, (&mut self.aimed[..], &mut self.slope[..]));
        step::value_and_slope(&self.current, step, end.0, end.1);
    }

    /// Repeats this in lanes whose coefficients may not all be finite: one that is not makes the
    /// sum of its state infinite or NaN.
    fn aim_finite(&mut self, broken: u32, passed: u32, lanes: &mut [Option<Lane>]) {
        let mut is_any = false;
        for index in places(broken) {
            let Some(lane) = &mut lanes[index] else { continue };
            if self.measure_finite(index, lane) {
                is_any = true;
                if (passed & self.clock.stuck()) >> index & 1 == 1 {
                    lane.stop(self.clock.time.lane(index), StopCause::StepTooSmall);
                }
                self.clock.aim_at(index);
            }
        }
        if is_any {
            self.sum();
        }
    }

    /// Moves to the ends of the steps that are tried.
    fn leave(&mut self) {
        let half = R::literal(0.5);
        let time = self.clock.within(self.clock.time + self.clock.step);
        self.time = R::select_less(self.clock.waits, half, time, self.time);
        for (end, aimed) in self.end.iter_mut().zip(&self.aimed) {
            *end = R::select_less(self.clock.waits, half, *aimed, *end);
        }
    }
}

/// Copies the numbers of one lane.
fn gather<R: Lanes>(values: &[R], index: usize, into: &mut [f64]) {
    for (into, value) in into.iter_mut().zip(values) {
        *into = value.lane(index);
    }
}
