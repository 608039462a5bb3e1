//! Where within a step a guard passes zero.

use machinist_contract::{Direction, Simulator};

use super::super::System;
use super::super::one_step::OneStep;
use super::super::stretch::within;
use super::Side;
use super::noise::Noise;

/// Below this share of its largest value over a step, a guard is zero but for rounding.
const ROUNDING: f64 = 1e-12;
/// A guard that would change by less than this share, at the rate it has, is at rest.
pub(super) const AT_REST: f64 = 1e-9;

/// Guards and their rates at the ends of the parts of a step.
pub(super) struct Parts {
    /// Of the stretch: a guard that jumps at its end has not jumped within it.
    pub(super) ends: (f64, f64),
    /// Constraints that hold in modes and repeat others.
    pub(super) led: Vec<usize>,
    times: Vec<f64>,
    /// One row for each time.
    guards: Vec<f64>,
    rates: Vec<f64>,
    /// Guards of events, which come first, and all of them.
    events: usize,
    count: usize,
    state: Vec<f64>,
    one: [Vec<f64>; 2],
    /// How fast the rate of each guard changed where last looked at.
    bends: Vec<f64>,
    /// The largest value that each guard has had.
    sizes: Vec<f64>,
    noise: Noise,
    /// The share of the step that was looked at of which guards tell what they do, if that is not all.
    told: Option<f64>,
    /// Whether some guard was not foretold in it, as where one jumps.
    is_unclear: bool,
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
    /// Its event happens: the guard comes from this side (1 or -1), and may jump over zero.
    Passes { time: f64, from: f64, jumps: bool },
}

impl Parts {
    /// Of guards of events and of kinks, over so many entries of a state; of those that are
    /// states, typical sizes, zero of modes.
    pub(super) fn new([events, kinks]: [usize; 2], entries: usize, scales: Vec<f64>) -> Self {
        let count = events + kinks;
        let one = [vec![0.0; count], vec![0.0; count]];
        let none = Vec::new;
        let (times, guards, rates) = (none(), none(), none());
        let (ends, state) = ((f64::NEG_INFINITY, f64::INFINITY), vec![0.0; entries]);
        let [bends, sizes] = [vec![0.0; count], vec![0.0; count]];
        let noise = Noise::new(events, kinks, scales);
        let led = Vec::new();
        let (told, is_unclear) = (None, false);
        Self {
            ends,
            led,
            times,
            guards,
            rates,
            events,
            count,
            state,
            one,
            bends,
            sizes,
            noise,
            told,
            is_unclear,
        }
    }

    /// The share of the step that was looked at of which guards tell what they do, if that is not
    /// all of it: in what is longer one goes to and fro more often than is looked.
    pub(super) fn told(&self) -> Option<f64> {
        self.told
    }

    /// Whether some guard jumped, perhaps, in the step that was looked at.
    pub(super) fn is_unclear(&self) -> bool {
        self.is_unclear
    }

    /// Looks at a step of `method`, in parts so short that guards between their ends are as
    /// these and their rates foretell: what goes round passes and comes back within a step.
    pub(super) fn fill(
        &mut self,
        system: &System<'_>,
        method: &mut dyn OneStep,
        span: (f64, f64),
        (start, sides): (&[f64], &[Side]),
    ) {
        /// In so many times more parts at most: a guard that jumps is never foretold.
        const FINEST: usize = 32;
        let mut finer = 1;
        (self.told, self.is_unclear) = (None, false);
        loop {
            let parts = finer * method.parts();
            self.fill_parts(system, method, span, start, parts);
            if finer == 1 {
                self.look_for_noise(system, span.0, start);
            }
            if self.is_foretold(system, method, sides) {
                break;
            }
            if finer >= FINEST {
                (self.told, self.is_unclear) = (self.share_that_is_told(sides), true);
                break;
            }
            finer *= 2;
        }
        for event in 0..self.count {
            self.sizes[event] = self.sizes[event].max(self.largest(event));
            let bends = (0..self.parts()).map(|part| {
                let change = self.rate(part + 1, event) - self.rate(part, event);
                (change / (self.times[part + 1] - self.times[part])).abs()
            });
            self.bends[event] = bends.filter(|bend| bend.is_finite()).fold(0.0, f64::max);
        }
    }

    /// Looks at how far rounding of states moves guards, where that is to be known.
    fn look_for_noise(&mut self, system: &System<'_>, time: f64, start: &[f64]) {
        const SMALL: f64 = 1e-6;
        let is_small = |index: usize| {
            self.largest(index) <= SMALL * self.sizes[index].max(self.noise.slope(index))
        };
        let is_any_small = (0..self.count).any(is_small);
        if self.noise.is_due(is_any_small) {
            let (events, ends) = (self.events, self.ends);
            self.noise.look((time, &start[..system.states()]), |time, state, guards| {
                let of_system = (system.simulator(), system.parameters());
                guards_at(of_system, events, within(time, ends), state, guards);
            });
        }
    }

    /// Whether every guard that might pass is, between the ends of parts, as the cubic through
    /// its values and rates there has it.
    fn is_foretold(
        &mut self,
        system: &System<'_>,
        method: &mut dyn OneStep,
        sides: &[Side],
    ) -> bool {
        /// Of what a guard goes over a step.
        const NEAR: f64 = 0.1;
        /// Parts are even: what goes round once a part looks as if it stood still but here.
        const UNEVEN: f64 = 0.382;
        let parts = self.parts();
        let of_first = self.times[0] + UNEVEN * (self.times[1] - self.times[0]);
        let mut has_looked = false;
        for event in (0..self.count).filter(|event| sides[*event] != Side::Idle) {
            let values = (0..=parts).map(|part| self.guard(part, event));
            let [least, most] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], value| {
                [a.min(value), b.max(value)]
            });
            let rates = (0..=parts).map(|part| self.rate(part, event).abs()).fold(0.0, f64::max);
            let span = self.times[parts] - self.times[0];
            let bent = 0.5 * span * span * self.bends[event];
            let far = (most - least).max(span * rates).max(bent);
            let nearest = if least > 0.0 { least } else { -most };
            if nearest > 4.0 * far || far <= AT_REST * self.largest(event) {
                continue;
            }
            let range = (most - least).max(AT_REST * self.largest(event));
            if rates * span > parts as f64 * range.max(self.rounding(event)) {
                // It may be back where it was between any two looks.
                return false;
            }
            let room = (NEAR * range).max(self.rounding(event));
            let ends = |low: usize, high: usize| {
                [low, high]
                    .map(|part| [self.times[part], self.guard(part, event), self.rate(part, event)])
            };
            let mut odd = (1..parts).step_by(2);
            if !odd.all(|part| {
                let foretold = cubic(ends(part - 1, part + 1), self.times[part]);
                is_near(foretold, self.guard(part, event), room)
            }) {
                return false;
            }
            let foretold = cubic(ends(0, 1), of_first);
            if !std::mem::replace(&mut has_looked, true) {
                // Of all guards at once.
                self.between(system, method, of_first, event);
            }
            if !is_near(foretold, self.one[0][event], room) {
                return false;
            }
        }
        true
    }

    /// Of the step, where some guard goes further within its parts, at the rates it has, than it
    /// ever is from where it was: a guard that jumps has no such rate.
    fn share_that_is_told(&self, sides: &[Side]) -> Option<f64> {
        /// Of the way between its least and its largest value, in a part.
        const MOST: f64 = 1.0;
        /// Of the stretch: shorter steps would not reach its end.
        const SHORTEST: f64 = 1e-10;
        let parts = self.parts();
        let part = (self.times[parts] - self.times[0]) / parts as f64;
        let shares = (0..self.count).filter(|event| sides[*event] != Side::Idle).map(|event| {
            let values = (0..=parts).map(|part| self.guard(part, event));
            let [least, most] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], value| {
                [a.min(value), b.max(value)]
            });
            let rates = (0..=parts).map(|part| self.rate(part, event).abs());
            let way = part * rates.filter(|rate| rate.is_finite()).fold(0.0, f64::max);
            let range = (most - least).max(AT_REST * self.largest(event)).max(self.rounding(event));
            MOST * range / way
        });
        let least = SHORTEST * (self.ends.1 - self.ends.0) / (part * parts as f64);
        let share = shares.filter(|share| *share < 1.0).reduce(f64::min)?.min(0.5);
        (share > least).then_some(share)
    }

    fn fill_parts(
        &mut self,
        system: &System<'_>,
        method: &mut dyn OneStep,
        (from, until): (f64, f64),
        start: &[f64],
        parts: usize,
    ) {
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
            self.follow(system, time);
            self.times[part] = time;
            let row = part * self.count..(part + 1) * self.count;
            let into = [&mut self.guards[row.clone()], &mut self.rates[row]];
            evaluate(system, self.events, within(time, self.ends), &self.state, into);
        }
    }

    /// Puts the state onto what leads others: their guards tell no less of it than they would of
    /// the states that steps start from.
    fn follow(&mut self, system: &System<'_>, time: f64) {
        if let Some(constraints) = system.constraints().filter(|it| it.may_lead()) {
            constraints.follow(&self.led, within(time, self.ends), &mut self.state);
        }
    }

    /// Whether no guard could pass within a step that ends in state `end`: there are kinks
    /// only, and each is further from zero at both ends than it moves in several such steps, by
    /// its rates and by how they changed in shorter steps before.
    pub(super) fn are_far(
        &mut self,
        system: &System<'_>,
        method: &dyn OneStep,
        (from, until): (f64, f64),
        (start, sides): (&[f64], &[Side]),
    ) -> bool {
        const STEPS: f64 = 4.0;
        // Between the ends of longer steps a guard may do more than its rates there tell.
        const SHORT: usize = 4;
        const FADES: f64 = 0.9;
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
        let (bends, sizes) = (&mut self.bends, &mut self.sizes);
        (0..self.count).all(|index| {
            let Side::Known(side) = sides[index] else { return false };
            let (g, h) = (before[index], after[index]);
            // What it has been tells what of it is rounding later.
            sizes[index] = sizes[index].max(h.abs());
            let (dg, dh) = (rates_before[index].abs(), rates_after[index].abs());
            let span = until - from;
            let way = (span * dg.max(dh)).max((h - g).abs()).max(0.5 * span * span * bends[index]);
            let is_far = side * g > STEPS * way && side * h > STEPS * way;
            if is_far {
                // What a longer step would not see is kept for a while.
                let bend = (rates_after[index] - rates_before[index]).abs() / span;
                bends[index] = bend.max(FADES * bends[index]);
            }
            is_far
        })
    }

    /// The largest value that each guard has had.
    pub(super) fn sizes(&self) -> &[f64] {
        &self.sizes
    }

    /// The largest value that each guard has had, also in pieces of a run before.
    pub(super) fn sizes_mut(&mut self) -> &mut Vec<f64> {
        &mut self.sizes
    }

    /// How fast the rate of a guard changed where last looked at.
    pub(super) fn bend(&self, event: usize) -> f64 {
        self.bends[event]
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

    fn between(
        &mut self,
        system: &System<'_>,
        method: &mut dyn OneStep,
        time: f64,
        event: usize,
    ) -> (f64, f64) {
        method.interpolate(time, &mut self.state);
        self.follow(system, time);
        let state = std::mem::take(&mut self.state);
        let found = self.at(system, time, &state, event);
        self.state = state;
        found
    }

    /// A guard and its rate at the end of the step that was looked at.
    pub(super) fn last(&self, event: usize) -> (f64, f64) {
        (self.guard(self.parts(), event), self.rate(self.parts(), event))
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
    pub(super) fn outcome(
        &mut self,
        system: &System<'_>,
        method: &mut dyn OneStep,
        guard: Guard,
        side: Side,
    ) -> Outcome {
        let Guard { index: event, direction, is_kink } = guard;
        let start = match side {
            Side::Idle => return Outcome::Stays(Side::Idle),
            Side::Known(known) => self.carried(event, known),
            Side::Jumped(side) => Start::On(side, 1),
            Side::Fresh { passed, residual } => {
                self.first_seen(system, method, (event, direction), passed, residual)
            }
        };
        let mut clear = self.times[0];
        let (mut side, first_part) = match start {
            Start::On(side, part) => (side, part),
            Start::Shortly(side, time) => {
                clear = time;
                (side, 0)
            }
            Start::Leaves { from } if !is_kink && is_wanted(direction, from) => {
                return Outcome::Passes { time: self.times[0], from, jumps: false };
            }
            Start::Leaves { from } => (-from, 0),
            Start::Unseen => return Outcome::Stays(side),
        };
        let rounding = self.rounding(event);
        for part in first_part..self.parts() {
            let mut bracket = [self.times[part].max(clear), self.times[part + 1]];
            if is_kink && side * self.guard(part, event) < -rounding {
                // It is behind, whatever was taken for its side.
                side = -side;
            }
            let crosses = side * self.guard(part + 1, event) < -rounding;
            let turns =
                side * self.rate(part, event) < 0.0 && side * self.rate(part + 1, event) > 0.0;
            let starts_beyond = side * self.guard(part, event) < 0.0;
            let sinks = side * self.rate(part, event) <= 0.0;
            if crosses && is_kink && part == 0 && starts_beyond && sinks {
                // By rounding it was there already as the step began.
                side = -side;
            } else if crosses {
                let is_clear = bracket[0] > self.times[part];
                let sets_out =
                    side * self.guard(part, event) <= 0.0 && side * self.rate(part, event) > 0.0;
                if sets_out && !is_clear {
                    // It sets out from zero, and is back beyond it: the top is between.
                    bracket[0] = self.turn(system, method, event, bracket, side);
                }
                if is_wanted(direction, side) {
                    let (time, jumps) = self.root(system, method, event, bracket, side);
                    // A step cannot end at a kink at which it starts.
                    if !is_kink || time > self.times[0] {
                        return Outcome::Passes { time, from: side, jumps };
                    }
                }
                side = -side;
            } else if turns {
                let turn = self.turn(system, method, event, bracket, -side);
                if side * self.between(system, method, turn, event).0 < -rounding {
                    let (bracket, from) = if is_wanted(direction, side) {
                        ([bracket[0], turn], side)
                    } else {
                        ([turn, bracket[1]], -side)
                    };
                    let (time, jumps) = self.root(system, method, event, bracket, from);
                    if !is_kink || time > self.times[0] {
                        return Outcome::Passes { time, from, jumps };
                    }
                }
            }
        }
        Outcome::Stays(Side::Known(side))
    }

    /// What of a guard may be rounding of what it compares: beyond zero by no more, it has not
    /// passed, and of a kink the rate is the same on both sides.
    pub(super) fn rounding(&self, event: usize) -> f64 {
        const ROUNDINGS: f64 = 64.0;
        let size = self.sizes[event].max(self.largest(event)).max(self.noise.slope(event));
        ROUNDINGS * f64::EPSILON * size
    }

    fn largest(&self, event: usize) -> f64 {
        (0..self.times.len()).fold(0.0, |most: f64, part| most.max(self.guard(part, event).abs()))
    }

    /// The start of a step for a guard whose side is known: it is still there, unless
    /// the guard itself jumped.
    fn carried(&self, event: usize, side: f64) -> Start {
        let guard = self.guard(0, event);
        if side * guard < -(ROUNDING * self.largest(event)).max(self.rounding(event)) {
            Start::Leaves { from: side }
        } else {
            Start::On(side, 0)
        }
    }

    /// The start of a step for a guard whose side is not known.
    fn first_seen(
        &mut self,
        system: &System<'_>,
        method: &mut dyn OneStep,
        (event, direction): (usize, Direction),
        passed: bool,
        residual: f64,
    ) -> Start {
        let (guard, rate) = (self.guard(0, event), self.rate(0, event));
        let (largest, span) = (self.largest(event), self.times[self.parts()] - self.times[0]);
        let by_time = 16.0 * f64::EPSILON * self.times[0].abs() * rate.abs();
        let zero = residual.max(ROUNDING * largest).max(by_time);
        // What may be beyond zero by rounding alone is not taken for beyond.
        let is_far =
            |side: f64| direction != Direction::Both && is_wanted(direction, -side.signum());
        let unclear = if is_far(guard) { zero.max(self.rounding(event)) } else { zero };
        if guard.abs() > unclear {
            return Start::On(guard.signum(), 0);
        }
        let moved = rate.abs() * span;
        let is_known = moved > AT_REST * largest && rate != 0.0;
        let (seen, part) = if is_known && (!is_far(rate) || moved > self.rounding(event)) {
            (rate.signum(), 0)
        } else {
            let least = zero.max(AT_REST * largest).max(self.rounding(event));
            let clear = |part: &usize| self.guard(*part, event).abs() > least;
            let Some(part) = (1..=self.parts()).find(clear) else { return Start::Unseen };
            let seen = self.guard(part, event).signum();
            match self.sooner(system, method, event, part, zero) {
                Some((before, time)) if before * seen < 0.0 && !is_far(before) => {
                    return Start::Shortly(before, time);
                }
                Some((before, _)) => (before, part),
                None => (seen, part),
            }
        };
        // What has just passed at a finite rate goes on; what then rests does not.
        let goes_on = passed && part == 0;
        if !goes_on && is_far(seen) { Start::Leaves { from: -seen } } else { Start::On(seen, part) }
    }

    /// The side to which a guard leaves zero that does so at no rate, and the first time at which
    /// it is seen there: by the start of `part`, where it is surely seen, it may be back, as where
    /// something slides for a moment only.
    fn sooner(
        &mut self,
        system: &System<'_>,
        method: &mut dyn OneStep,
        event: usize,
        part: usize,
        zero: f64,
    ) -> Option<(f64, f64)> {
        const SOONER: f64 = 0.125;
        let span = self.times[part] - self.times[0];
        let least = zero.max(self.rounding(event));
        let mut looks = Vec::new();
        let mut after = SOONER * span;
        while self.times[0] + after > self.times[0] {
            let time = self.times[0] + after;
            let (guard, rate) = self.between(system, method, time, event);
            if rate.abs() * after <= least {
                break;
            }
            looks.push((time, guard, rate));
            after *= SOONER;
        }
        // Near the start of a step its rate is exact, where its states err by more than they move.
        let side = looks.last()?.2.signum();
        let there = looks.iter().find(|(_, guard, _)| side * guard > least);
        Some((side, there.or(looks.last())?.0))
    }

    /// Where `side` g is largest between two times, at which its rate is above and
    /// below zero.
    fn turn(
        &mut self,
        system: &System<'_>,
        method: &mut dyn OneStep,
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

    /// Where a guard passes within a step that starts with it on `side`, and whether it jumps there, if
    /// in front of its end it is on the other.
    pub(super) fn passing_before(
        &mut self,
        system: &System<'_>,
        method: &mut dyn OneStep,
        (from, front): (f64, f64),
        event: usize,
        side: f64,
    ) -> Option<(f64, bool)> {
        let beyond = |guard: f64, rounding: f64| side * guard < -rounding;
        let rounding = self.rounding(event);
        let is_there = beyond(self.between(system, method, front, event).0, rounding)
            && !beyond(self.between(system, method, from, event).0, rounding);
        is_there.then(|| self.root(system, method, event, [from, front], side))
    }

    /// Where g leaves `side` between two times, by the rule of false position with
    /// halving (Illinois), to the last bit but some; never early; and whether
    /// it jumps there.
    fn root(
        &mut self,
        system: &System<'_>,
        method: &mut dyn OneStep,
        event: usize,
        [mut low, mut high]: [f64; 2],
        side: f64,
    ) -> (f64, bool) {
        /// A step is many roundings long: what does not jump is far smaller than that within one.
        const JUMPS: f64 = 1e-2;
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
        let (least, largest) = (g_low.min(-g_high), self.largest(event));
        (high, least > JUMPS * largest)
    }
}

/// The cubic through two times, values and rates, at a time between.
fn cubic([[from, low, low_rate], [until, high, high_rate]]: [[f64; 3]; 2], time: f64) -> f64 {
    let span = until - from;
    let (s, left) = ((time - from) / span, (until - time) / span);
    let ends = left * left * (1.0 + 2.0 * s) * low + s * s * (3.0 - 2.0 * s) * high;
    ends + span * s * left * (left * low_rate - s * high_rate)
}

fn is_near(foretold: f64, found: f64, room: f64) -> bool {
    (foretold - found).abs() <= room
}

/// Guards of so many events and of all kinks at a state.
pub(super) fn guards_at(
    (simulator, parameters): (&dyn Simulator<f64>, &[f64]),
    events: usize,
    time: f64,
    state: &[f64],
    guards: &mut [f64],
) {
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
    let (simulator, parameters) = (system.simulator(), system.parameters());
    let state = &state[..system.states()];
    guards_at((simulator, parameters), events, time, state, guards);
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
    /// On a side as the step starts, as seen at this time within its first part.
    Shortly(f64, f64),
    /// It leaves this side right there.
    Leaves { from: f64 },
    /// Zero all the step.
    Unseen,
}

/// Whether a guard that comes from `side` passes in this direction.
pub(super) fn is_wanted(direction: Direction, side: f64) -> bool {
    match direction {
        Direction::Rising => side < 0.0,
        Direction::Falling => side > 0.0,
        Direction::Both => true,
    }
}

/// Between two times, if numbers lie there that differ by more than rounding.
pub(super) fn middle(low: f64, high: f64) -> Option<f64> {
    let middle = low + 0.5 * (high - low);
    let resolved = 4.0 * f64::EPSILON * low.abs().max(high.abs());
    (high - low > resolved && low < middle && middle < high).then_some(middle)
}
