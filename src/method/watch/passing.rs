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
mod roots;
mod samples;

use machinist_contract::Direction;
use serde::{Deserialize, Serialize};

use super::super::System;
use super::super::one_step::OneStep;
use super::super::stretch::within;
use super::noise::Noise;
use super::watched::{Sources, Watched};
use super::{ROUNDINGS, Side};
use samples::Samples;

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
    pub(super) prescribed: Vec<usize>,
    watched: Vec<Watched>,
    sources: Sources,
    state: Vec<f64>,
    start: Look,
    end: Look,
    /// Start of the previous step, if that was within the same segment.
    before: Look,
    has_before: bool,
    samples: Samples,
    /// States at the times that are sampled together.
    states: Vec<f64>,
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
        (entries, scales): (usize, Vec<f64>),
    ) -> Self {
        let count = watched.len();
        let zeros = || vec![0.0; count];
        let events = system.simulator().events();
        Self {
            ends: (f64::NEG_INFINITY, f64::INFINITY),
            prescribed: Vec::new(),
            sources: Sources::new(system.simulator()),
            state: vec![0.0; entries],
            start: Look::default(),
            end: Look { time: f64::NAN, ..Look::default() },
            before: Look::default(),
            has_before: false,
            samples: Samples::new(count),
            states: Vec::new(),
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
        if self.noise.is_due(time, is_any_small) {
            let (watched, sources) = (&self.watched, &mut self.sources);
            // Also at times beyond the ends of the stretch: time is rounded there too.
            self.noise.look((time, &start[..system.states()]), |time, state, guards| {
                sources.take(system, time, state);
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
            constraints.follow(&self.prescribed, within(time, self.ends), &mut self.state);
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
        if let Some(values) = self.samples.at(time) {
            return values[index];
        }
        if let Some(value) = self.known(step, time, index) {
            self.note_size(index, value.abs());
            return value;
        }
        step.method.interpolate(time, &mut self.state);
        self.sample_state(step.system, time)[index]
    }

    /// Samples all guards at times within the step, unless they are known without the state.
    fn sample_all(
        &mut self,
        step: &mut Step<'_, '_>,
        times: impl Iterator<Item = f64>,
        index: usize,
    ) {
        let is_end = |time: f64| {
            [&self.start, &self.end].map(|it| it.time.to_bits()).contains(&time.to_bits())
        };
        let is_missing = |time: &f64| !is_end(*time) && self.samples.at(*time).is_none();
        let missing: Vec<f64> = times.filter(is_missing).collect();
        let Some(first) = missing.first() else { return };
        if self.known(step, *first, index).is_some() {
            return;
        }
        let mut states = std::mem::take(&mut self.states);
        let size = self.state.len();
        states.resize(missing.len() * size, 0.0);
        step.method.interpolate_each(&missing, &mut states);
        for (time, state) in missing.iter().zip(states.chunks_exact(size)) {
            self.state.copy_from_slice(state);
            self.sample_state(step.system, *time);
        }
        self.states = states;
    }

    /// Samples all guards at the present state.
    fn sample_state(&mut self, system: &System<'_>, time: f64) -> &[f64] {
        self.follow(system, time);
        let Self { sources, watched, state, samples, sizes, .. } = self;
        sources.take(system, within(time, self.ends), state);
        samples.push(time, watched.iter().map(|watched| sources.value(system, *watched)));
        let values = samples.last();
        for (size, value) in sizes.iter_mut().zip(values) {
            *size = size.max(value.abs());
        }
        values
    }

    /// Returns a zero of a guard on the dense output of the step. Its rate is the slope there, which
    /// may differ from the rate along the motion, even in sign, within the error of the step.
    fn zero_at(&mut self, step: &mut Step<'_, '_>, time: f64, index: usize) -> Zero {
        let count = self.samples.count();
        let by = f64::EPSILON.cbrt() * (self.end.time - self.start.time);
        let (low, high) = ((time - by).max(self.start.time), (time + by).min(self.end.time));
        let [before, residual, behind] = [low, time, high].map(|at| self.sample(step, at, index));
        self.samples.truncate(count);
        Zero { time, residual, rate: (behind - before) / (high - low) }
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
