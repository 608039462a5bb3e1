//! Times within a step at which guards cross zero.
//!
//! Relations are held within a step, so guards are smooth. Each is evaluated in two tiers:
//!
//! 1. The cubic through its values and rates at both ends of the step, widened by the extrapolation
//!    error of the previous step's cubic at the end. If it is clear of zero, so is the guard.
//! 2. Otherwise, polynomials through samples of the dense output, halved until the sign is certain,
//!    and a root by bracketing.
//!
//! A guard that is zero but for rounding at the start of a segment is divided by the time since
//! then. The quotient has the same sign and the other roots.

mod bounds;

use machinist_contract::Direction;
use serde::{Deserialize, Serialize};

use super::super::System;
use super::super::one_step::OneStep;
use super::super::stretch::within;
use super::noise::Noise;
use super::polynomial::{NODES, SHARES};
use super::watched::{Sources, Watched};
use super::{ROUNDINGS, Side};

/// Relative change of a guard, at its current rate, below which it is at rest.
pub(super) const AT_REST: f64 = 1e-9;

/// Maximum number of pieces of a step evaluated for one root; at about five a
/// period, enough for 200 periods of an oscillation within a step.
const PIECES: usize = 1000;

/// Factor by which a span grows in which a guard was resolved and had no root. Polynomials resolve
/// up to 10 rad of an oscillation surely; three times as much could look resolved by chance.
const GROWTH: f64 = 1.25;

/// All watched functions at one time.
#[derive(Debug, Clone, Default)]
struct Look {
    time: f64,
    values: Vec<f64>,
    rates: Vec<f64>,
}

/// Guards over the current step.
pub(super) struct Parts {
    /// Ends of the stretch; a guard that jumps at one of them has not jumped within it.
    pub(super) ends: (f64, f64),
    /// Constraints that hold in modes and repeat others.
    pub(super) led: Vec<usize>,
    watched: Vec<Watched>,
    sources: Sources,
    state: Vec<f64>,
    start: Look,
    end: Look,
    /// Start of the previous step, if that was within the same segment.
    before: Look,
    has_before: bool,
    /// Samples on the dense output of the step.
    samples: Vec<(f64, Vec<f64>)>,
    /// Mean rate of change of the rate of each guard over the step.
    bends: Vec<f64>,
    /// Largest value of each guard so far.
    sizes: Vec<f64>,
    turns: Vec<Turns>,
    /// Largest value of each guard since its relation last changed.
    excursions: Vec<f64>,
    /// Span in which each counter is evaluated at once \[s\].
    spans: Vec<f64>,
    noise: Noise,
}

/// Extent of a guard and of its rate so far. A guard that oscillates, with amplitude A and angular
/// frequency w, has a rate of up to A w.
#[derive(Debug, Clone, Copy)]
struct Turns {
    least: f64,
    greatest: f64,
    steepest: f64,
}

impl Default for Turns {
    fn default() -> Self {
        Self { least: f64::INFINITY, greatest: f64::NEG_INFINITY, steepest: 0.0 }
    }
}

impl Turns {
    fn note(&mut self, value: f64, rate: f64) {
        self.least = self.least.min(value);
        self.greatest = self.greatest.max(value);
        self.steepest = self.steepest.max(rate.abs());
    }

    /// Returns whether an oscillation of this extent may turn so far within a span that its values
    /// and rates at both ends do not show it.
    fn may_turn_within(&self, span: f64) -> bool {
        /// Angle up to which cubics missed no zero in the 69 000 steps of the prototype \[rad\].
        const SHOWN: f64 = 4.0;
        self.steepest * span > SHOWN * 0.5 * (self.greatest - self.least)
    }
}

/// A guard that was zero but for rounding at a time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Zero {
    pub(super) time: f64,
    pub(super) residual: f64,
    pub(super) rate: f64,
}

impl Zero {
    /// Returns true at the time at which the guard was zero.
    pub(super) fn is_at(self, time: f64) -> bool {
        self.time.to_bits() == time.to_bits()
    }
}

/// A guard to evaluate.
#[derive(Debug, Clone, Copy)]
pub(super) struct Guard {
    pub(super) index: usize,
    pub(super) direction: Direction,
    pub(super) is_kink: bool,
    /// The start of the segment, if the guard was zero there.
    pub(super) zero: Option<Zero>,
}

/// Behaviour of a guard over a step.
#[derive(Debug, Clone, Copy)]
pub(super) enum Outcome {
    /// No event happens; the guard ends on this side.
    Stays(Side),
    /// The event happens; the guard comes from this side (1 or -1).
    Passes { time: f64, from: f64 },
}

/// A step of a method, for samples.
pub(super) struct Step<'s, 'a> {
    pub(super) system: &'s System<'a>,
    pub(super) method: &'s mut dyn OneStep,
}

impl Parts {
    /// Returns the guards of `watched` functions of states with this number of entries; `scales`
    /// are the typical sizes of states, zero for modes.
    pub(super) fn new(
        system: &System<'_>,
        watched: Vec<Watched>,
        entries: usize,
        scales: Vec<f64>,
    ) -> Self {
        let count = watched.len();
        let zeros = || vec![0.0; count];
        let events = system.simulator().events();
        Self {
            ends: (f64::NEG_INFINITY, f64::INFINITY),
            led: Vec::new(),
            sources: Sources::new(system.simulator()),
            state: vec![0.0; entries],
            start: Look::default(),
            end: Look { time: f64::NAN, ..Look::default() },
            before: Look::default(),
            has_before: false,
            samples: Vec::new(),
            bends: zeros(),
            sizes: zeros(),
            turns: vec![Turns::default(); count],
            excursions: zeros(),
            spans: vec![f64::INFINITY; count],
            noise: Noise::new(events, count - events, scales),
            watched,
        }
    }

    /// Starts a segment, in which the previous steps do not apply.
    pub(super) fn restart(&mut self) {
        self.end.time = f64::NAN;
        self.noise.restart();
    }

    /// Evaluates guards at both ends of a step.
    pub(super) fn look(
        &mut self,
        step: &mut Step<'_, '_>,
        (from, until): (f64, f64),
        start: &[f64],
    ) {
        self.samples.clear();
        let goes_on = self.end.time.to_bits() == from.to_bits();
        self.has_before = goes_on && !self.start.values.is_empty();
        if goes_on {
            std::mem::swap(&mut self.before, &mut self.start);
            std::mem::swap(&mut self.start, &mut self.end);
        } else {
            self.state.copy_from_slice(start);
            let old = std::mem::take(&mut self.start);
            self.start = self.look_at(step.system, from, old);
            self.note_look(false);
        }
        self.state.copy_from_slice(step.method.end());
        let old = std::mem::take(&mut self.end);
        self.end = self.look_at(step.system, until, old);
        self.note_look(true);
        let span = until - from;
        for index in 0..self.watched.len() {
            let bend = ((self.end.rates[index] - self.start.rates[index]) / span).abs();
            self.bends[index] = if bend.is_finite() { bend } else { 0.0 };
        }
        self.look_for_noise(step.system, from, start);
    }

    /// Takes note of the values at the end of the step, or at its start.
    fn note_look(&mut self, is_end: bool) {
        let Self { start, end, sizes, turns, .. } = self;
        let look = if is_end { end } else { start };
        let notes = sizes.iter_mut().zip(turns);
        for ((value, rate), (size, turns)) in look.values.iter().zip(&look.rates).zip(notes) {
            *size = size.max(value.abs());
            turns.note(*value, *rate);
        }
    }

    fn note_size(&mut self, index: usize, size: f64) {
        self.sizes[index] = self.sizes[index].max(size);
    }

    /// Takes note of how far guards go from the start of the step to a time within it, with values
    /// and rates there, by the cubics through both.
    pub(super) fn note_arcs(&mut self, time: f64, guards: &[(f64, f64)]) {
        let third = (time - self.start.time) / 3.0;
        let starts = self.start.values.iter().zip(&self.start.rates);
        for ((excursion, end), start) in self.excursions.iter_mut().zip(guards).zip(starts) {
            let arc = [*start.0, start.0 + third * start.1, end.0 - third * end.1, end.0];
            *excursion = arc.into_iter().fold(*excursion, |most, value| most.max(value.abs()));
        }
    }

    /// Takes note of how far guards go over the whole step.
    pub(super) fn note_arcs_to_end(&mut self) {
        let ends = self.end.values.iter().copied().zip(self.end.rates.iter().copied());
        let ends: Vec<(f64, f64)> = ends.collect();
        self.note_arcs(self.end.time, &ends);
    }

    /// Takes note of a value that a guard may have.
    pub(super) fn note_excursion(&mut self, index: usize, size: f64) {
        self.excursions[index] = self.excursions[index].max(size);
    }

    /// Evaluates guards again at the end of the step, which was projected onto constraints or
    /// surfaces.
    pub(super) fn renew_end(&mut self, system: &System<'_>, time: f64, state: &[f64]) {
        if self.end.time.to_bits() == time.to_bits() {
            self.state.copy_from_slice(state);
            let old = std::mem::take(&mut self.end);
            self.end = self.look_at(system, time, old);
        }
    }

    /// Evaluates guards at a time, in the memory of a look that is not needed any more.
    fn look_at(&mut self, system: &System<'_>, time: f64, mut look: Look) -> Look {
        self.follow(system, time);
        let at = within(time, self.ends);
        let Self { sources, watched, state, .. } = self;
        look.time = time;
        look.values.clear();
        look.rates.clear();
        sources.take(system, at, state);
        look.values.extend(watched.iter().map(|watched| sources.value(system, *watched)));
        sources.take_rates(system, at, state);
        look.rates.extend(watched.iter().map(|watched| sources.rate(*watched)));
        look
    }

    /// Estimates the changes of guards by rounding of states, which may be far larger than the
    /// rounding of the guards.
    fn look_for_noise(&mut self, system: &System<'_>, time: f64, start: &[f64]) {
        const SMALL: f64 = 1e-6;
        let is_small = |index: usize| {
            self.largest(index) <= SMALL * self.sizes[index].max(self.noise.slope(index))
        };
        let is_any_small = (0..self.watched.len()).any(is_small);
        if self.noise.is_due(is_any_small) {
            let (ends, watched, sources) = (self.ends, &self.watched, &mut self.sources);
            self.noise.look((time, &start[..system.states()]), |time, state, guards| {
                sources.take(system, within(time, ends), state);
                for (guard, watched) in guards.iter_mut().zip(watched) {
                    *guard = sources.value(system, *watched);
                }
            });
        }
    }

    /// Projects the state onto the constraints that prescribe a motion, so that guards see the
    /// states from which steps start.
    fn follow(&mut self, system: &System<'_>, time: f64) {
        if let Some(constraints) = system.constraints().filter(|it| it.may_lead()) {
            constraints.follow(&self.led, within(time, self.ends), &mut self.state);
        }
    }

    /// Returns the largest value of each guard, also in earlier pieces of a run.
    pub(super) fn sizes_mut(&mut self) -> &mut Vec<f64> {
        &mut self.sizes
    }

    /// Returns the largest value of a guard since the last call, at which its relation changed.
    pub(super) fn take_excursion(&mut self, index: usize) -> f64 {
        std::mem::take(&mut self.excursions[index])
    }

    /// Returns the rate of change of a guard's rate over the last step.
    pub(super) fn bend(&self, index: usize) -> f64 {
        self.bends[index]
    }

    /// Returns a guard and its rate at a state.
    pub(super) fn at(
        &mut self,
        system: &System<'_>,
        time: f64,
        state: &[f64],
        index: usize,
    ) -> (f64, f64) {
        let at = within(time, self.ends);
        self.sources.take(system, at, state);
        let value = self.sources.value(system, self.watched[index]);
        self.sources.take_rates(system, at, state);
        (value, self.sources.rate(self.watched[index]))
    }

    /// Returns all guards and their rates at a state.
    pub(super) fn all_at(
        &mut self,
        system: &System<'_>,
        time: f64,
        state: &[f64],
    ) -> Vec<(f64, f64)> {
        let at = within(time, self.ends);
        let Self { sources, watched, .. } = self;
        sources.take(system, at, state);
        let values = watched.iter().map(|watched| (sources.value(system, *watched), 0.0));
        let mut all: Vec<(f64, f64)> = values.collect();
        sources.take_rates(system, at, state);
        for ((_, rate), watched) in all.iter_mut().zip(watched) {
            *rate = sources.rate(*watched);
        }
        all
    }

    /// A guard and its rate at the end of the step that was looked at.
    pub(super) fn last(&self, index: usize) -> (f64, f64) {
        (self.end.values[index], self.end.rates[index])
    }

    /// Returns a guard on the dense output of the step.
    fn sample(&mut self, step: &mut Step<'_, '_>, time: f64, index: usize) -> f64 {
        for look in [&self.start, &self.end] {
            if time.to_bits() == look.time.to_bits() {
                return look.values[index];
            }
        }
        if let Some((_, values)) = self.samples.iter().find(|it| it.0.to_bits() == time.to_bits()) {
            return values[index];
        }
        if let Some(value) = self.known(step, time, index) {
            self.note_size(index, value.abs());
            return value;
        }
        step.method.interpolate(time, &mut self.state);
        self.follow(step.system, time);
        self.sources.take(step.system, within(time, self.ends), &self.state);
        let value = |watched: &Watched| self.sources.value(step.system, *watched);
        let values: Vec<f64> = self.watched.iter().map(value).collect();
        for (other, value) in values.iter().enumerate() {
            self.note_size(other, value.abs());
        }
        let found = values[index];
        self.samples.push((time, values));
        found
    }

    /// Returns a zero of a guard on the dense output of the step.
    fn zero_at(&mut self, step: &mut Step<'_, '_>, time: f64, index: usize) -> Zero {
        step.method.interpolate(time, &mut self.state);
        self.follow(step.system, time);
        let there = self.state.clone();
        let (residual, rate) = self.at(step.system, time, &there, index);
        Zero { time, residual, rate }
    }

    /// Returns how a guard that is on `side` at the start of the step begins.
    ///
    /// # Errors
    /// The side on which it stays, if it surely does not cross zero until a time within the step.
    fn beginning(
        &mut self,
        step: &mut Step<'_, '_>,
        (guard, until): (Guard, f64),
        side: Side,
    ) -> Result<Beginning, Side> {
        let Guard { index, direction, zero, .. } = guard;
        match side {
            Side::Idle => Err(side),
            Side::Known(on) if until >= self.end.time && self.is_clear(step, index, on) => {
                Err(side)
            }
            Side::Known(side) => Ok(Beginning { side, zero, leaves: false }),
            Side::Fresh { passed, residual } => {
                match self.first_seen(step, (index, direction), (passed, residual), until) {
                    Start::On(side, zero) => Ok(Beginning { side, zero, leaves: false }),
                    Start::Leaves { from, zero } => {
                        Ok(Beginning { side: -from, zero, leaves: true })
                    }
                    Start::Unseen => Err(side),
                }
            }
        }
    }

    /// Returns the outcome for a guard that is on `side` at the start of the step, until a limit
    /// within the step.
    pub(super) fn outcome(
        &mut self,
        step: &mut Step<'_, '_>,
        (guard, limit): (Guard, f64),
        side: Side,
    ) -> Outcome {
        let Guard { index, direction, is_kink, .. } = guard;
        let Beginning { mut side, mut zero, leaves } =
            match self.beginning(step, (guard, limit), side) {
                Ok(beginning) => beginning,
                Err(stays) => return Outcome::Stays(stays),
            };
        if leaves && !is_kink && is_wanted(direction, -side) {
            return Outcome::Passes { time: self.start.time, from: -side };
        }
        let (mut from, until) = (self.start.time, limit);
        loop {
            let mut pieces = PIECES;
            let of = (index, side, zero);
            let Some(time) = self.first_root(step, of, [from, until], &mut pieces) else { break };
            if is_wanted(direction, side) {
                return Outcome::Passes { time, from: side };
            }
            side = -side;
            if time <= from || time >= until {
                break;
            }
            (from, zero) = (time, Some(self.zero_at(step, time, index)));
        }
        Outcome::Stays(Side::Known(side))
    }

    /// Returns all times at which a guard that is on `side` at the start of the step crosses zero
    /// in its direction, until a time within the step, and its side then.
    pub(super) fn passings(
        &mut self,
        step: &mut Step<'_, '_>,
        (guard, until): (Guard, f64),
        side: Side,
    ) -> (Vec<f64>, Side) {
        let Guard { index, direction, .. } = guard;
        let mut passings = Vec::new();
        self.samples.clear();
        let Beginning { mut side, mut zero, leaves } =
            match self.beginning(step, (guard, until), side) {
                Ok(beginning) => beginning,
                Err(stays) => return (passings, stays),
            };
        if leaves && is_wanted(direction, -side) {
            passings.push(self.start.time);
        }
        let mut from = self.start.time;
        let (mut since, mut span) = (from, self.spans[index].min(until - from));
        while from < until {
            self.samples.clear();
            let to = if from + span < until { from + span } else { until };
            let mut pieces = PIECES;
            let found = self.first_root(step, (index, side, zero), [from, to], &mut pieces);
            if pieces == 0 && middle(from, 0.5 * (from + to)).is_some() {
                span = 0.5 * (to - from);
                continue;
            }
            // The root at which it was zero does not count again.
            let is_other = |time: &f64| zero.is_none_or(|zero| *time > zero.time);
            let Some(time) = found.filter(is_other) else {
                span *= if to < until { GROWTH } else { 1.0 };
                from = to;
                continue;
            };
            if is_wanted(direction, side) {
                passings.push(time);
            }
            // The next root is about as far from this one as the last one.
            span = if middle(since, time).is_some() { time - since } else { span };
            (from, since) = (time, time);
            let at = self.zero_at(step, time, index);
            side = match self.first_sign(step, index, at, until) {
                Some((seen, _)) if at.rate * side > 0.0 => seen,
                _ => -side,
            };
            zero = Some(at);
        }
        self.samples.clear();
        self.spans[index] = span;
        (passings, Side::Known(side))
    }

    /// Returns the largest distance of a guard beyond zero within the step, if it is back on its
    /// side at the end.
    pub(super) fn dip(
        &mut self,
        step: &mut Step<'_, '_>,
        (index, side): (usize, f64),
        passing: f64,
    ) -> Option<f64> {
        if side * self.end.values[index] <= 0.0 {
            return None;
        }
        let zero = Some(self.zero_at(step, passing, index));
        let of = (index, -side, zero);
        let back = self.first_root(step, of, [passing, self.end.time], &mut PIECES.clone())?;
        let depths = SHARES
            .map(|share| -side * self.sample(step, passing + (back - passing) * share, index));
        Some(depths.into_iter().fold(0.0, f64::max))
    }

    /// Returns whether the guard of an event stays on its side over the whole step, with relations
    /// held in another way than the step was evaluated.
    pub(super) fn stays_as_held(
        &mut self,
        step: &mut Step<'_, '_>,
        (index, side): (usize, f64),
        start: &[f64],
    ) -> bool {
        let (from, until) = (self.start.time, self.end.time);
        self.state.copy_from_slice(start);
        let begin = self.look_at(step.system, from, Look::default());
        self.state.copy_from_slice(step.method.end());
        let end = self.look_at(step.system, until, Look::default());
        let kept = (
            std::mem::replace(&mut self.start, begin),
            std::mem::replace(&mut self.end, end),
            std::mem::take(&mut self.samples),
        );
        let is_beyond = side * self.start.values[index] <= 0.0;
        let of = (index, side, None);
        let stays =
            !is_beyond && self.first_root(step, of, [from, until], &mut PIECES.clone()).is_none();
        (self.start, self.end, self.samples) = kept;
        stays
    }

    /// Relations are held in another way from the end of the step on.
    pub(super) fn forget_end(&mut self) {
        self.end.time = f64::NAN;
    }

    /// Returns whether a guard certainly stays on its side over the step, by the cubic through both
    /// ends and the error of the previous one.
    fn is_clear(&self, step: &mut Step<'_, '_>, index: usize, side: f64) -> bool {
        /// Distances from a place have a corner there, of which the estimate sees a tenth.
        const WIDER: f64 = 16.0;
        let ends = |look: &Look| [look.time, look.values[index], look.rates[index]];
        let [start, end] = [&self.start, &self.end].map(ends);
        let span = end[0] - start[0];
        let coefficients =
            [start[1], start[1] + span * start[2] / 3.0, end[1] - span * end[2] / 3.0, end[1]];
        let error = match self.bound(step, (index, None), 4, [start[0], end[0]]) {
            Some(bound) => bound * span.powi(4) / 384.0,
            None => match self.error_by_extrapolation(index) {
                Some(error) => WIDER * error,
                None => return false,
            },
        };
        let rounding = 16.0 * f64::EPSILON * self.sizes[index];
        let room = error + rounding;
        coefficients.iter().all(|value| side * value > room)
    }

    /// Returns an estimate of the distance between a guard and its cubic over the step, if the
    /// previous step allows one.
    fn error_by_extrapolation(&self, index: usize) -> Option<f64> {
        // The distance from a place turns as sharply as the place is narrow.
        let is_place = matches!(self.watched[index], Watched::Zone(_) | Watched::Nearest(_));
        if is_place
            || !self.has_before
            || self.turns[index].may_turn_within(self.end.time - self.start.time)
        {
            return None;
        }
        let ends = |look: &Look| [look.time, look.values[index], look.rates[index]];
        let [first, start, end] = [&self.before, &self.start, &self.end].map(ends);
        let (span, span_before) = (end[0] - start[0], start[0] - first[0]);
        // The previous cubic, extrapolated, misses by g'''' (h (h + h'))^2/24, and its rate
        // likewise. Between its ends this one is off by g'''' h^4/384 at most. Where a guard turns,
        // one estimate may be small by chance, but not both.
        let (whole, missed) = (span + span_before, cubic([first, start], end[0]));
        let by_value = (missed[0] - end[1]).abs() / (span * whole).powi(2);
        let by_rate = (missed[1] - end[2]).abs() / (2.0 * span * whole * (span + whole));
        Some(by_value.max(by_rate) * span.powi(4) / 16.0)
    }

    /// Returns the first time within a span at which a guard leaves a side, if it does.
    fn first_root(
        &mut self,
        step: &mut Step<'_, '_>,
        of: (usize, f64, Option<Zero>),
        [low, high]: [f64; 2],
        pieces: &mut usize,
    ) -> Option<f64> {
        let samples: [f64; NODES] = std::array::from_fn(|node| {
            let time = match node {
                0 => low,
                _ if node == NODES - 1 => high,
                _ => low + (high - low) * SHARES[node],
            };
            self.deflated(step, of, time)
        });
        let rounding = self.rounding(of.0);
        // At its start the quotient is a rate, and just behind it is the least accurate.
        let since = |time: f64| of.2.map_or(1.0, |zero| (time - zero.time).max(0.0));
        let soonest = if since(low) > 0.0 { low } else { low + (high - low) * SHARES[1] };
        let noise = 0.25 * rounding / since(soonest);
        let enclosure = self.enclosure(step, (of.0, of.2), (&samples, noise), [low, high]);
        let (first, last) = (samples[0], samples[NODES - 1]);
        if enclosure.is_above() {
            return None;
        }
        // Only rounding; a larger value is not resolved yet.
        let is_rounding = |(node, sample): (usize, &f64)| {
            (sample * since(low + (high - low) * SHARES[node])).abs() <= rounding
        };
        if samples.iter().enumerate().all(is_rounding) {
            return None;
        }
        let beyond = |sample: f64, time: f64| -sample * since(time) > rounding;
        if first < -enclosure.error && beyond(first, low) {
            return Some(low);
        }
        // A guard that does not reach zero, and is not surely above it, may turn within.
        if enclosure.is_monotone() && last < first && beyond(last, high) {
            return Some(self.root(step, of, [low, high]));
        }
        *pieces = pieces.saturating_sub(1);
        let Some(middle) = middle(low, high).filter(|_| *pieces > 0) else {
            return (last < 0.0).then_some(high);
        };
        self.first_root(step, of, [low, middle], pieces)
            .or_else(|| self.first_root(step, of, [middle, high], pieces))
    }

    /// Returns a value that is positive while a guard is on a side; for a guard that was zero,
    /// divided by the time since then.
    fn deflated(
        &mut self,
        step: &mut Step<'_, '_>,
        (index, side, zero): (usize, f64, Option<Zero>),
        time: f64,
    ) -> f64 {
        let value = |parts: &mut Self, step: &mut Step<'_, '_>| parts.sample(step, time, index);
        match zero {
            None => side * value(self, step),
            Some(zero) if time <= zero.time => side * zero.rate,
            Some(zero) => side * (value(self, step) - zero.residual) / (time - zero.time),
        }
    }

    /// Returns the time at which a guard leaves a side, between two times at which it is on it and
    /// not, by false position with halving (Illinois). The result is never early.
    fn root(
        &mut self,
        step: &mut Step<'_, '_>,
        of: (usize, f64, Option<Zero>),
        [mut low, mut high]: [f64; 2],
    ) -> f64 {
        let mut at_low = self.deflated(step, of, low);
        let mut at_high = self.deflated(step, of, high);
        if at_low <= 0.0 {
            return low;
        }
        let (mut kept, mut count) = (0, 0);
        while let Some(middle) = middle(low, high) {
            count += 1;
            let chord = high - (high - low) * (at_high / (at_high - at_low));
            let is_within = low < chord && chord < high;
            let time = if is_within && count % 4 != 0 { chord } else { middle };
            let guard = self.between(step, of, time);
            if guard > 0.0 {
                (low, at_low) = (time, guard);
                at_high *= if kept == 1 { 0.5 } else { 1.0 };
                kept = 1;
            } else {
                (high, at_high) = (time, guard);
                at_low *= if kept == -1 { 0.5 } else { 1.0 };
                kept = -1;
            }
            if guard == 0.0 {
                break;
            }
        }
        high
    }

    /// Returns [`Parts::deflated`] at a time that is not sampled again.
    fn between(
        &mut self,
        step: &mut Step<'_, '_>,
        of: (usize, f64, Option<Zero>),
        time: f64,
    ) -> f64 {
        let count = self.samples.len();
        let found = self.deflated(step, of, time);
        self.samples.truncate(count);
        found
    }

    /// Returns the start of a step for a guard whose side is not known.
    fn first_seen(
        &mut self,
        step: &mut Step<'_, '_>,
        (index, direction): (usize, Direction),
        (passed, residual): (bool, f64),
        until: f64,
    ) -> Start {
        let time = self.start.time;
        let (value, rate) = (self.start.values[index], self.start.rates[index]);
        let by_time = 16.0 * f64::EPSILON * time.abs() * rate.abs();
        let is_far =
            |side: f64| direction != Direction::Both && is_wanted(direction, -side.signum());
        let zero = residual.max(by_time);
        // A value that rounding alone may take beyond zero is not beyond it.
        let unclear = if is_far(value) { zero.max(self.rounding(index)) } else { zero };
        if value.abs() > unclear {
            return Start::On(value.signum(), None);
        }
        let at = Zero { time, residual: value, rate };
        let Some((seen, is_at_once)) = self.first_sign(step, index, at, until) else {
            return Start::Unseen;
        };
        // A guard that just crossed at a finite rate goes on; one that then rests does not.
        let goes_on = passed && is_at_once;
        if !goes_on && is_far(seen) {
            Start::Leaves { from: -seen, zero: Some(at) }
        } else {
            Start::On(seen, Some(at))
        }
    }

    /// Returns the side to which a guard leaves zero, and whether it does so at a finite rate.
    fn first_sign(
        &mut self,
        step: &mut Step<'_, '_>,
        index: usize,
        at: Zero,
        mut until: f64,
    ) -> Option<(f64, bool)> {
        const SOONER: f64 = 0.125;
        let mut found = None;
        while until > at.time {
            let span = until - at.time;
            // A rate within rounding does not count, nor one at which a guard rests.
            let rests = (AT_REST * self.largest(index)).max(self.rounding(index));
            if at.rate.abs() * span > rests {
                return Some((at.rate.signum(), true));
            }
            let samples: [f64; NODES] = std::array::from_fn(|node| {
                let time = at.time + span * SHARES[node];
                self.deflated(step, (index, 1.0, Some(at)), time)
            });
            let noise = self.rounding(index) / (span * SHARES[1]);
            let span_of = [at.time, until];
            let enclosure = self.enclosure(step, (index, Some(at)), (&samples, noise), span_of);
            let moved = |node: usize| samples[node].abs() * span * SHARES[node];
            let Some(seen) = (0..NODES).find(|node| moved(*node) > rests) else { break };
            if enclosure.error > SOONER * samples[seen].abs() {
                until = at.time + SOONER * span;
                continue;
            }
            found = Some((samples[seen].signum(), false));
            if seen > 1 {
                break;
            }
            // A long step may hide that the guard was on the other side before.
            until = at.time + SHARES[seen] * span;
        }
        found
    }

    /// Returns the rounding error of a guard, as that of the values it compares.
    pub(super) fn rounding(&self, index: usize) -> f64 {
        let size = match self.watched[index] {
            // Near a place nothing depends on the size of distances far away.
            Watched::Border(_) | Watched::Zone(_) | Watched::Nearest(_) => self.largest(index),
            _ => self.sizes[index].max(self.largest(index)).max(self.noise.slope(index)),
        };
        ROUNDINGS * f64::EPSILON * size
    }

    fn largest(&self, index: usize) -> f64 {
        let of = |look: &Look| look.values.get(index).map_or(0.0, |value| value.abs());
        of(&self.start).max(of(&self.end))
    }
}

/// Returns the cubic through two times, values and rates, with its rate, at a time between or
/// beyond them.
fn cubic([[from, low, low_rate], [until, high, high_rate]]: [[f64; 3]; 2], time: f64) -> [f64; 2] {
    let span = until - from;
    let (s, left) = ((time - from) / span, (until - time) / span);
    let ends = left * left * (1.0 + 2.0 * s) * low + s * s * (3.0 - 2.0 * s) * high;
    let rates = left * low_rate - s * high_rate;
    let slope = 6.0 * s * left * (high - low) / span + (left - s) * rates
        - s * left * (low_rate + high_rate);
    [ends + span * s * left * rates, slope]
}

/// Beginning of a guard that may cross zero within a step.
struct Beginning {
    /// Side on which it is, just behind the start.
    side: f64,
    /// The start of the segment, if it was zero there.
    zero: Option<Zero>,
    /// True if it leaves the other side at the start of the step.
    leaves: bool,
}

/// State of a guard at the start of a step.
enum Start {
    /// On a side; it may have been zero.
    On(f64, Option<Zero>),
    /// It leaves this side at the start.
    Leaves { from: f64, zero: Option<Zero> },
    /// Zero during the whole step.
    Unseen,
}

/// Returns whether a guard that comes from `side` crosses in this direction.
pub(super) fn is_wanted(direction: Direction, side: f64) -> bool {
    match direction {
        Direction::Rising => side < 0.0,
        Direction::Falling => side > 0.0,
        Direction::Both => true,
    }
}

/// Returns the middle of two times, if they differ by more than rounding.
pub(super) fn middle(low: f64, high: f64) -> Option<f64> {
    let middle = low + 0.5 * (high - low);
    let resolved = 4.0 * f64::EPSILON * low.abs().max(high.abs());
    (high - low > resolved && low < middle && middle < high).then_some(middle)
}
