//! Where within a step a guard passes zero.

use machinist_contract::Direction;

use super::super::System;
use super::super::one_step::OneStep;
use super::super::stretch::within;
use super::Side;

/// Below this share of its largest value over a step, a guard is zero but for rounding.
const ROUNDING: f64 = 1e-12;
/// A guard that would change by less than this share, at the rate it has, is at rest.
const AT_REST: f64 = 1e-9;

/// Guards and their rates at the ends of the parts of a step.
pub(super) struct Parts {
    /// Of the stretch: a guard that jumps at its end has not jumped within it.
    pub(super) ends: (f64, f64),
    times: Vec<f64>,
    /// One row for each time.
    guards: Vec<f64>,
    rates: Vec<f64>,
    /// Guards of events, which come first, and all of them.
    events: usize,
    count: usize,
    state: Vec<f64>,
    one: [Vec<f64>; 2],
}

/// A guard to be looked at.
#[derive(Debug, Clone, Copy)]
pub(super) struct Guard {
    pub(super) index: usize,
    pub(super) direction: Direction,
    pub(super) is_kink: bool,
}

/// What a guard does over a step.
#[derive(Debug, Clone, Copy)]
pub(super) enum Outcome {
    /// Its event does not happen; where it is at the end.
    Stays(Side),
    /// Its event happens: the guard comes from this side (1 or -1).
    Passes { time: f64, from: f64 },
}

impl Outcome {
    pub(super) fn passing(&self) -> Option<f64> {
        match self {
            Outcome::Passes { time, .. } => Some(*time),
            Outcome::Stays(_) => None,
        }
    }
}

impl Parts {
    pub(super) fn new(events: usize, kinks: usize, states: usize) -> Self {
        let count = events + kinks;
        let one = [vec![0.0; count], vec![0.0; count]];
        let none = Vec::new;
        let (times, guards, rates) = (none(), none(), none());
        let (ends, state) = ((f64::NEG_INFINITY, f64::INFINITY), vec![0.0; states]);
        Self { ends, times, guards, rates, events, count, state, one }
    }

    /// Looks at a step of `method`.
    pub(super) fn fill<M: OneStep>(
        &mut self,
        system: &System<'_>,
        method: &mut M,
        (from, until): (f64, f64),
        start: &[f64],
    ) {
        let parts = method.parts();
        self.times.resize(parts + 1, 0.0);
        for rows in [&mut self.guards, &mut self.rates] {
            rows.resize((parts + 1) * self.count, 0.0);
        }
        for part in 0..=parts {
            let time = from + (until - from) * (part as f64 / parts as f64);
            let time = if part == parts { until } else { time };
            match part {
                0 => self.state.copy_from_slice(start),
                _ if part == parts => self.state.copy_from_slice(method.end()),
                _ => method.interpolate(time, &mut self.state),
            }
            self.times[part] = time;
            let row = part * self.count..(part + 1) * self.count;
            let into = [&mut self.guards[row.clone()], &mut self.rates[row]];
            evaluate(system, self.events, within(time, self.ends), &self.state, into);
        }
    }

    /// Whether no guard could pass within a step that ends in state `end`: there are kinks
    /// only, and each is further from zero at both ends than it moves in several such steps.
    pub(super) fn are_far<M: OneStep>(
        &mut self,
        system: &System<'_>,
        method: &M,
        (from, until): (f64, f64),
        (start, sides): (&[f64], &[Side]),
    ) -> bool {
        const STEPS: f64 = 4.0;
        // Between the ends of longer steps a guard may do more than its rates there tell.
        const SHORT: usize = 4;
        if self.events > 0 || method.parts() > SHORT {
            return false;
        }
        for rows in [&mut self.guards, &mut self.rates] {
            rows.resize(2 * self.count, 0.0);
        }
        let (before, after) = self.guards.split_at_mut(self.count);
        let (rates_before, rates_after) = self.rates.split_at_mut(self.count);
        evaluate(
            system,
            0,
            within(until, self.ends),
            method.end(),
            [&mut after[..self.count], &mut rates_after[..self.count]],
        );
        evaluate(system, 0, from, start, [before, rates_before]);
        (0..self.count).all(|index| {
            let Side::Known(side) = sides[index] else { return false };
            let (g, h) = (before[index], after[index]);
            let (dg, dh) = (rates_before[index].abs(), rates_after[index].abs());
            let way = ((until - from) * dg.max(dh)).max((h - g).abs());
            side * g > STEPS * way && side * h > STEPS * way
        })
    }

    /// A guard and its rate at a state.
    pub(super) fn at(
        &mut self,
        system: &System<'_>,
        time: f64,
        state: &[f64],
        event: usize,
    ) -> (f64, f64) {
        let [guards, rates] = &mut self.one;
        evaluate(system, self.events, within(time, self.ends), state, [guards, rates]);
        (guards[event], rates[event])
    }

    fn between<M: OneStep>(
        &mut self,
        system: &System<'_>,
        method: &mut M,
        time: f64,
        event: usize,
    ) -> (f64, f64) {
        let mut state = std::mem::take(&mut self.state);
        method.interpolate(time, &mut state);
        let found = self.at(system, time, &state, event);
        self.state = state;
        found
    }

    /// Number of parts.
    fn parts(&self) -> usize {
        self.times.len().saturating_sub(1)
    }

    fn guard(&self, part: usize, event: usize) -> f64 {
        self.guards[part * self.count + event]
    }

    fn rate(&self, part: usize, event: usize) -> f64 {
        self.rates[part * self.count + event]
    }

    /// What a guard does that is on `side` at the start of the step.
    pub(super) fn outcome<M: OneStep>(
        &mut self,
        system: &System<'_>,
        method: &mut M,
        guard: Guard,
        side: Side,
    ) -> Outcome {
        let Guard { index: event, direction, is_kink } = guard;
        let start = match side {
            Side::Idle => return Outcome::Stays(Side::Idle),
            Side::Known(known) => self.carried(event, known),
            Side::Fresh { passed, residual } => self.first_seen(event, direction, passed, residual),
        };
        let (mut side, first_part) = match start {
            Start::On(side, part) => (side, part),
            Start::Leaves { from } if !is_kink && is_wanted(direction, from) => {
                return Outcome::Passes { time: self.times[0], from };
            }
            Start::Leaves { from } => (-from, 0),
            Start::Unseen => return Outcome::Stays(side),
        };
        for part in first_part..self.parts() {
            let mut bracket = [self.times[part], self.times[part + 1]];
            let crosses = side * self.guard(part + 1, event) < 0.0;
            let turns =
                side * self.rate(part, event) < 0.0 && side * self.rate(part + 1, event) > 0.0;
            if crosses {
                if side * self.guard(part, event) <= 0.0 && side * self.rate(part, event) > 0.0 {
                    // It sets out from zero, and is back beyond it: the top is between.
                    bracket[0] = self.turn(system, method, event, bracket, side);
                }
                if is_wanted(direction, side) {
                    let time = self.root(system, method, event, bracket, side);
                    return Outcome::Passes { time, from: side };
                }
                side = -side;
            } else if turns {
                let turn = self.turn(system, method, event, bracket, -side);
                if side * self.between(system, method, turn, event).0 < 0.0 {
                    let (bracket, from) = if is_wanted(direction, side) {
                        ([bracket[0], turn], side)
                    } else {
                        ([turn, bracket[1]], -side)
                    };
                    let time = self.root(system, method, event, bracket, from);
                    return Outcome::Passes { time, from };
                }
            }
        }
        Outcome::Stays(Side::Known(side))
    }

    fn largest(&self, event: usize) -> f64 {
        (0..=self.parts()).fold(0.0, |most: f64, part| most.max(self.guard(part, event).abs()))
    }

    /// The start of a step for a guard whose side is known: it is still there, unless
    /// the guard itself jumped.
    fn carried(&self, event: usize, side: f64) -> Start {
        let guard = self.guard(0, event);
        if side * guard < -ROUNDING * self.largest(event) {
            Start::Leaves { from: side }
        } else {
            Start::On(side, 0)
        }
    }

    /// The start of a step for a guard whose side is not known.
    fn first_seen(&self, event: usize, direction: Direction, passed: bool, residual: f64) -> Start {
        let (guard, rate) = (self.guard(0, event), self.rate(0, event));
        let (largest, span) = (self.largest(event), self.times[self.parts()] - self.times[0]);
        let by_time = 16.0 * f64::EPSILON * self.times[0].abs() * rate.abs();
        let zero = residual.max(ROUNDING * largest).max(by_time);
        if guard.abs() > zero {
            return Start::On(guard.signum(), 0);
        }
        let (seen, part) = if rate.abs() * span > AT_REST * largest && rate != 0.0 {
            (rate.signum(), 0)
        } else {
            let clear = |part: &usize| self.guard(*part, event).abs() > zero.max(AT_REST * largest);
            let Some(part) = (1..=self.parts()).find(clear) else { return Start::Unseen };
            (self.guard(part, event).signum(), part)
        };
        // What has just passed at a finite rate goes on; what then rests does not.
        let goes_on = passed && part == 0;
        if !goes_on && direction != Direction::Both && is_wanted(direction, -seen) {
            Start::Leaves { from: -seen }
        } else {
            Start::On(seen, part)
        }
    }

    /// Where `side` g is largest between two times, at which its rate is above and
    /// below zero.
    fn turn<M: OneStep>(
        &mut self,
        system: &System<'_>,
        method: &mut M,
        event: usize,
        [mut low, mut high]: [f64; 2],
        side: f64,
    ) -> f64 {
        while let Some(middle) = middle(low, high) {
            let (_, rate) = self.between(system, method, middle, event);
            if side * rate > 0.0 { low = middle } else { high = middle }
        }
        low
    }

    /// Where g leaves `side` between two times, by the rule of false position with
    /// halving (Illinois), to the last bit but some; never early.
    fn root<M: OneStep>(
        &mut self,
        system: &System<'_>,
        method: &mut M,
        event: usize,
        [mut low, mut high]: [f64; 2],
        side: f64,
    ) -> f64 {
        let mut g_low = side * self.between(system, method, low, event).0;
        let mut g_high = side * self.between(system, method, high, event).0;
        let mut kept = 0;
        let mut count = 0;
        while let Some(middle) = middle(low, high) {
            count += 1;
            let chord = high - (high - low) * (g_high / (g_high - g_low));
            let within = low < chord && chord < high;
            let time = if within && count % 4 != 0 { chord } else { middle };
            let guard = side * self.between(system, method, time, event).0;
            if guard > 0.0 {
                (low, g_low) = (time, guard);
                if kept == 1 {
                    g_high *= 0.5;
                }
                kept = 1;
            } else {
                (high, g_high) = (time, guard);
                if kept == -1 {
                    g_low *= 0.5;
                }
                kept = -1;
            }
            if guard == 0.0 {
                break;
            }
        }
        high
    }
}

/// Guards of so many events and of all kinks at a state.
pub(super) fn guards_at(
    system: &System<'_>,
    events: usize,
    time: f64,
    state: &[f64],
    guards: &mut [f64],
) {
    let (simulator, parameters) = (system.simulator(), system.parameters());
    let state = &state[..system.states()];
    let (guards, kinks) = guards.split_at_mut(events);
    if events > 0 {
        simulator.guards(time, state, parameters, guards);
    }
    if !kinks.is_empty() {
        simulator.kink_guards(time, state, parameters, kinks);
    }
}

/// The same, and their rates.
pub(super) fn evaluate(
    system: &System<'_>,
    events: usize,
    time: f64,
    state: &[f64],
    [guards, rates]: [&mut [f64]; 2],
) {
    guards_at(system, events, time, state, guards);
    let (simulator, parameters) = (system.simulator(), system.parameters());
    let state = &state[..system.states()];
    let (rates, kink_rates) = rates.split_at_mut(events);
    if events > 0 {
        simulator.guard_rates(time, state, parameters, rates);
    }
    if !kink_rates.is_empty() {
        simulator.kink_rates(time, state, parameters, kink_rates);
    }
}

/// Where a guard is as a step starts.
enum Start {
    /// On a side, as seen at the start of this part.
    On(f64, usize),
    /// It leaves this side right there.
    Leaves { from: f64 },
    /// Zero all the step.
    Unseen,
}

/// Whether a guard that comes from `side` passes in this direction.
fn is_wanted(direction: Direction, side: f64) -> bool {
    match direction {
        Direction::Rising => side < 0.0,
        Direction::Falling => side > 0.0,
        Direction::Both => true,
    }
}

/// Between two times, if numbers lie there that differ by more than rounding.
fn middle(low: f64, high: f64) -> Option<f64> {
    let middle = low + 0.5 * (high - low);
    let resolved = 4.0 * f64::EPSILON * low.abs().max(high.abs());
    (high - low > resolved && low < middle && middle < high).then_some(middle)
}
