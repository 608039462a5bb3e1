//! Events within a fixed step.

use super::{FixedSteps, Follow, Nobody, Rest, Room, Scratch, StepNumber, Stepped, before_jump};
use crate::{Constraint, Direction, Jumps};

/// Values and rates of the guards, at the start or the end of a part of a step.
struct Guards<'w, R> {
    values: &'w mut [R],
    rates: &'w mut [R],
}

/// Workspace for the events within a step.
struct Watch<'w, R> {
    sides: &'w mut [i8],
    passed: &'w mut [i8],
    /// 1 if an event may happen at once, [`WAITS`] if its guard counts as before zero.
    asked: &'w mut [i8],
    shares: &'w mut [R],
    before: &'w mut [R],
    start: Guards<'w, R>,
    end: Guards<'w, R>,
    trial: &'w mut [R],
    values: &'w mut [R],
}

/// Marks an event that waits: it would only undo one that has just happened.
const WAITS: i8 = -1;

/// Returns 1 for a positive number, -1 for a negative one, else 0.
fn sign_of<R: StepNumber>(x: R) -> i8 {
    let zero = R::literal(0.0);
    i8::from(zero < x) - i8::from(x < zero)
}

/// Reports whether a guard counts as zero: its rate takes it back to zero within h.
fn comes_back<R: StepNumber>(guard: R, rate: R, h: R) -> bool {
    sign_of(guard) * sign_of(rate) < 0 && guard.abs() <= h * rate.abs()
}

/// Returns the fraction of a step of length h at which a guard crosses zero. It is the root of
/// the cubic through values and rates at both ends, found by one bisection for each binary digit.
fn passing<R: StepNumber>(side: i8, h: R, guard: [R; 2], rate: [R; 2]) -> R {
    let l = R::literal;
    let change = guard[1] - guard[0];
    let slope = h * rate[0];
    let cubic = slope + h * rate[1] - l(2.0) * change;
    let square = change - slope - cubic;
    let (mut low, mut high) = (l(0.0), l(1.0));
    for _ in 0..R::DIGITS {
        let s = l(0.5) * (low + high);
        if sign_of(guard[0] + s * (slope + s * (square + s * cubic))) == side {
            low = s;
        } else {
            high = s;
        }
    }
    high
}

impl<R: StepNumber> FixedSteps<'_, R> {
    /// Returns 1 if the event happens as its guard rises, -1 as it falls, 0 for both.
    fn direction(&self, event: usize) -> i8 {
        match self.simulator.event(event).direction {
            Direction::Rising => 1,
            Direction::Falling => -1,
            Direction::Both => 0,
        }
    }

    fn is_watched(&self, event: usize, state: &[R]) -> bool {
        self.simulator.event(event).when.iter().all(|&(entry, value)| {
            let (mode, value) = (state[entry as usize], R::literal(value));
            mode <= value && value <= mode
        })
    }

    fn is_wanted(&self, event: usize, side: i8) -> bool {
        side != 0 && self.direction(event) != side
    }

    fn is_beyond(&self, event: usize, guard: R) -> bool {
        let direction = self.direction(event);
        direction != 0 && sign_of(guard) == direction
    }

    /// Reports whether an event changes a mode in which it is active.
    fn ends_its_mode(&self, event: usize) -> bool {
        let event = self.simulator.event(event);
        event.when.iter().any(|(entry, _)| event.sets.contains(entry))
    }

    fn look_at(&self, time: R, state: &[R], guards: &mut Guards<'_, R>) {
        self.simulator.guards(time, state, self.parameters, guards.values);
        self.simulator.guard_rates(time, state, self.parameters, guards.rates);
    }

    /// Applies the resets of an event. `values` has room for as many values as the state has
    /// entries; the number of resets may be larger or smaller.
    fn apply(&self, event: usize, time: R, state: &mut [R], values: &mut [R]) {
        let before = |event: usize| self.simulator.event(event).sets.len();
        let first: usize = (0..event).map(before).sum();
        self.simulator.resets(time, state, self.parameters, values);
        for (place, &entry) in self.simulator.event(event).sets.iter().enumerate() {
            state[entry as usize] = values[first + place];
        }
    }

    /// Returns the number of values that events reset.
    pub(super) fn resets(&self) -> usize {
        (0..self.simulator.events()).map(|event| self.simulator.event(event).sets.len()).sum()
    }

    fn watch<'w>(&self, rest: &mut Rest<'w, R>, signs: &'w mut [i8]) -> Watch<'w, R> {
        let events = self.simulator.events();
        let mut signs = Rest(signs);
        Watch {
            sides: signs.take(events),
            passed: signs.take(events),
            asked: signs.take(events),
            shares: rest.take(events),
            before: rest.take(events),
            start: Guards { values: rest.take(events), rates: rest.take(events) },
            end: Guards { values: rest.take(events), rates: rest.take(events) },
            trial: rest.take(self.simulator.shape().states()),
            values: rest.take(self.resets()),
        }
    }

    /// Corrects modes that contradict their guards, and records the signs of the guards. Call it
    /// once before the first step, and whenever a state was changed by hand.
    ///
    /// # Panics
    /// As [`FixedSteps::step`].
    pub fn settle(&self, time: R, state: &mut [R], room: &mut Room<'_, R>) {
        self.settle_followed(time, state, room, &mut Nobody);
    }

    /// As [`FixedSteps::settle`]; a follower is told the events.
    pub(super) fn settle_followed(
        &self,
        time: R,
        state: &mut [R],
        room: &mut Room<'_, R>,
        follower: &mut impl Follow<R>,
    ) {
        if self.simulator.events() == 0 {
            return;
        }
        let mut rest = Rest(room.numbers);
        let mut scratch = self.scratch(&mut rest);
        let _end = rest.take(state.len());
        let mut watch = self.watch(&mut rest, room.signs);
        watch.asked.fill(1);
        watch.passed.fill(0);
        watch.sides.fill(0);
        let h = R::literal(0.0);
        self.settle_asked((time, h), state, (&mut watch, &mut scratch), follower);
        self.look((time, h), state, &mut watch);
    }

    /// Triggers events that leave the modes in which they are active and whose guard is beyond
    /// zero, if requested. Returns their number.
    fn settle_asked(
        &self,
        (time, h): (R, R),
        state: &mut [R],
        (watch, scratch): (&mut Watch<'_, R>, &mut Scratch<'_, R>),
        follower: &mut impl Follow<R>,
    ) -> usize {
        let events = self.simulator.events();
        let mut happened = 0;
        for _ in 0..2 * events {
            self.look_at(time, state, &mut watch.end);
            let mut found = false;
            for event in 0..events {
                let (guard, rate) = (watch.end.values[event], watch.end.rates[event]);
                if watch.asked[event] != 1
                    || !self.ends_its_mode(event)
                    || !self.is_watched(event, state)
                    || !self.is_beyond(event, guard)
                    || comes_back(guard, rate, h)
                {
                    continue;
                }
                watch.trial.copy_from_slice(state);
                self.apply(event, time, watch.trial, watch.values);
                if !self.is_watched(event, watch.trial) {
                    follower.reset(self, event, time, state);
                    state.copy_from_slice(watch.trial);
                    watch.asked[event] = 0;
                    found = true;
                    break;
                }
            }
            if !found {
                break;
            }
            happened += 1;
            self.project(time, state, scratch);
            follower.projected(self, time, state);
        }
        happened
    }

    /// Records the signs of all guards after events.
    fn look(&self, (time, h): (R, R), state: &[R], watch: &mut Watch<'_, R>) {
        self.look_at(time, state, &mut watch.end);
        for event in 0..self.simulator.events() {
            let (guard, rate) = (watch.end.values[event], watch.end.rates[event]);
            let side = sign_of(guard);
            watch.sides[event] = if !self.is_watched(event, state) {
                0
            } else if watch.asked[event] == WAITS {
                -self.direction(event)
            } else if watch.passed[event] != 0 || side == 0 {
                sign_of(rate)
            } else if watch.sides[event] == 0
                && self.is_beyond(event, guard)
                && comes_back(guard, rate, h)
            {
                -side
            } else {
                side
            };
        }
    }

    /// Reports whether an event would return to a mode that another has just ended. Both guards
    /// are at zero then, and only rounding can have taken this one beyond: the other event would
    /// happen again.
    fn undoes(&self, event: usize, time: R, state: &[R], watch: &mut Watch<'_, R>) -> bool {
        if !self.ends_its_mode(event) || !self.is_watched(event, state) {
            return false;
        }
        watch.trial.copy_from_slice(state);
        self.apply(event, time, watch.trial, watch.values);
        (0..self.simulator.events()).any(|ended| {
            watch.passed[ended] != 0
                && self.ends_its_mode(ended)
                && self.is_watched(ended, watch.trial)
        })
    }

    /// Resets the state where guards have crossed zero, at the end of a part of a step. `first` is
    /// the event whose zero crossing ended the part; `None` if a known time did.
    fn happen(
        &self,
        (time, h): (R, R),
        state: &mut [R],
        (watch, scratch): (&mut Watch<'_, R>, &mut Scratch<'_, R>),
        first: Option<usize>,
        follower: &mut impl Follow<R>,
    ) -> usize {
        let events = self.simulator.events();
        let mut happened = 0;
        follower.before_events(self, first, time, state);
        self.simulator.guards(time, state, self.parameters, watch.before);
        for event in 0..events {
            if watch.passed[event] != 0 && self.is_watched(event, state) {
                follower.reset(self, event, time, state);
                self.apply(event, time, state, watch.values);
                happened += 1;
            }
        }
        self.project(time, state, scratch);
        follower.projected(self, time, state);
        for event in 0..events {
            let is_new = watch.passed[event] == 0 && !self.is_beyond(event, watch.before[event]);
            watch.asked[event] = i8::from(watch.sides[event] == 0 || is_new);
            if watch.sides[event] == 0 && self.undoes(event, time, state, watch) {
                watch.asked[event] = WAITS;
            }
        }
        happened += self.settle_asked((time, h), state, (watch, scratch), follower);
        self.look((time, h), state, watch);
        follower.after_events(self, time, state);
        happened
    }

    /// Lets frictions begin anew whose speeds may jump in time: their forces are finite.
    fn reopen_frictions(&self, state: &mut [R]) {
        for constraint in 0..self.simulator.constraints() {
            let constraint = self.simulator.constraint(constraint);
            if let Some(mode) = constraint.friction.filter(|_| constraint.jumps == Jumps::InTime) {
                state[mode as usize] = R::literal(Constraint::OPEN);
            }
        }
    }

    /// Marks guards that cross zero up to the end of a part of a step, and reports whether there
    /// are any. A guard that started at zero, and whose event ends a mode in which it is active,
    /// has crossed when it is beyond zero: no state of that mode is there.
    fn pass(&self, state: &[R], watch: &mut Watch<'_, R>) -> bool {
        let mut found = false;
        for event in 0..self.simulator.events() {
            let (side, guard) = (watch.sides[event], watch.end.values[event]);
            let crosses = self.is_wanted(event, side) && sign_of(guard) == -side;
            let leaves = side == 0 && self.ends_its_mode(event) && self.is_beyond(event, guard);
            let passes = (crosses || leaves) && self.is_watched(event, state);
            watch.passed[event] = i8::from(passes);
            found |= passes;
        }
        found
    }

    /// Returns the fraction of a part of a step at which the first of the marked guards crosses
    /// zero, and its event.
    fn first_share(&self, h: R, watch: &mut Watch<'_, R>) -> (R, usize) {
        let (mut first, mut which) = (R::literal(1.0), 0);
        for event in (0..self.simulator.events()).filter(|event| watch.passed[*event] != 0) {
            let guard = [watch.start.values[event], watch.end.values[event]];
            let rate = [watch.start.rates[event], watch.end.rates[event]];
            let share = passing(watch.sides[event], h, guard, rate);
            watch.shares[event] = share;
            // A crossing at the very end of the part is the first one as well.
            which = if share < first || watch.passed[which] == 0 { event } else { which };
            first = if share < first { share } else { first };
        }
        (first, which)
    }

    /// Accepts a part of a step without further events.
    fn accept(&self, end: &[R], watch: &mut Watch<'_, R>) {
        for event in 0..self.simulator.events() {
            let side = sign_of(watch.end.values[event]);
            if !self.is_watched(event, end) {
                watch.sides[event] = 0;
            } else if watch.passed[event] == 0 && side != 0 {
                watch.sides[event] = side;
            }
        }
    }

    pub(super) fn step_with_events(
        &self,
        (time, step): (R, R),
        state: &mut [R],
        room: &mut Room<'_, R>,
        follower: &mut impl Follow<R>,
    ) -> Stepped {
        let mut rest = Rest(room.numbers);
        let mut scratch = self.scratch(&mut rest);
        let end = rest.take(state.len());
        let mut watch = self.watch(&mut rest, room.signs);
        let jumps = rest.take(self.simulator.shape().discontinuities);
        let (mut now, mut left, mut happened) = (time, step, 0);
        let mut too_many = false;
        for part in 1..=self.parts_a_step {
            if left <= R::literal(0.0) {
                break;
            }
            let is_last = part == self.parts_a_step;
            let jump = self.next_jump(now, now + left, jumps);
            too_many |= is_last && jump.is_some();
            let jump = jump.filter(|_| !is_last);
            let length = jump.map_or(left, |jump| before_jump(now, left, jump));
            self.look_at(now, state, &mut watch.start);
            self.advance(now, length, state, end, &mut scratch);
            self.look_at(now + length, end, &mut watch.end);
            let found = self.pass(state, &mut watch);
            if !found || is_last {
                too_many |= found;
                follower.part(self, (now, length), state, end);
                state.copy_from_slice(end);
                self.accept(state, &mut watch);
                let Some(jump) = jump else { break };
                left = left - (jump - now);
                now = jump;
                self.reopen_frictions(state);
                self.simulator.guards(now, state, self.parameters, watch.end.values);
                if self.pass(state, &mut watch) {
                    let room = (&mut watch, &mut scratch);
                    happened += self.happen((now, left), state, room, None, follower);
                }
                continue;
            }
            let (first, which) = self.first_share(length, &mut watch);
            if first < R::literal(1.0) {
                self.advance(now, first * length, state, end, &mut scratch);
            }
            follower.part(self, (now, first * length), state, end);
            state.copy_from_slice(end);
            now = now + first * length;
            left = left - first * length;
            self.simulator.guards(now, state, self.parameters, watch.end.values);
            for event in 0..self.simulator.events() {
                let passed = watch.passed[event] != 0
                    && (watch.shares[event] <= first
                        || sign_of(watch.end.values[event]) == -watch.sides[event]);
                watch.passed[event] = i8::from(passed);
            }
            let room = (&mut watch, &mut scratch);
            happened += self.happen((now, left), state, room, Some(which), follower);
        }
        if too_many { Stepped::TooManyParts } else { Stepped::Events(happened) }
    }
}
