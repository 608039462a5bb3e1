//! Watches guards while a method steps, and does what events say where one passes
//! zero.
//!
//! - A step is looked at in parts: a guard that changes its sign over a part, or
//!   turns round beyond zero within it, has passed. The root is bracketed on the step's
//!   dense output; then the step is taken anew, so that it ends there, and the root is
//!   corrected by Newton's method: an event is as exact as a step.
//! - Just after an event its guard is zero but for rounding. Then the side it is on is
//!   that to which dg/dt points; if that vanishes too, that on which it is next seen.
//!   So nothing happens twice, and no bounce, however short, is overlooked.
//! - A guard that sets out from zero to the far side without having just passed has
//!   passed now.
//! - Modes that contradict their guards are set right: an event that changes the modes it
//!   is watched for in, and whose guard is beyond zero already, happens at once. So at the
//!   start, where it may change modes only, and after events; see `settle`.
//! - Events without end within no time (Zeno) stop the run.
//! - Kinks of the rate are guards too, at which nothing happens but that a step ends and the
//!   method begins anew behind them; see `crossing`.

mod crossing;
mod hosted;
mod led;
mod noise;
mod passing;
mod resting;
mod settle;

use std::cell::RefCell;
use std::collections::VecDeque;

use machinist_contract::Direction;
use serde::{Deserialize, Serialize};

use super::one_step::OneStep;
use super::{Problem, Stopped, Stretch, System};
use crate::error::StopCause;
use crate::trajectory::Switch;
pub(crate) use hosted::Memory;
use led::Turn;
use passing::{Guard, Outcome, Parts, guards_at, is_wanted};
use resting::Passages;
use settle::is_beyond;

/// So many events within [`NO_TIME`] are taken for endless ones; more in a scene that has many.
const ENDLESS: usize = 50;
/// Of the time reached, or of the run: so long before the end of a step what jumps there has not
/// jumped yet.
const A_MOMENT: f64 = 1e-12;
/// Of the largest value that a guard has had: further from zero it is behind a jump.
const JUMPED: f64 = 1e-2;
/// Share of the time reached, or of the run if that is longer.
const NO_TIME: f64 = 1e-10;

/// The guards of a run, and what became of them.
pub struct Watch<'a> {
    system: &'a System<'a>,
    span: f64,
    rtol: f64,
    atol: &'a [f64],
    inner: RefCell<Inner>,
}

struct Inner {
    sides: Vec<Side>,
    /// Start of the next step.
    time: f64,
    start: Vec<f64>,
    parts: Parts,
    outcomes: Vec<Outcome>,
    /// What begins or ends to rest first within the step.
    turn: Option<Turn>,
    /// Time and events, where a guard passed.
    happening: Option<(f64, Vec<usize>)>,
    latest: VecDeque<f64>,
    passages: Vec<Passages>,
    switches: Vec<Switch>,
    happened: Happened,
}

/// What happened at once.
#[derive(Debug, Clone, Default)]
pub(crate) struct Happened {
    /// Guards that passed zero, of events that were watched for and of kinks.
    pub(crate) passed: Vec<usize>,
    /// Events whose new values were given, in order; also those that others led to.
    pub(crate) applied: Vec<usize>,
}

impl Inner {
    /// The first of the guards that pass, and when; nothing if something that is led turns before.
    /// Of what passes at one time, what jumps there tells least of when that is.
    fn first(&self) -> Option<(usize, f64)> {
        let near = |time: f64| 64.0 * f64::EPSILON * time.abs();
        let passings = || {
            let guards = self.outcomes.iter().enumerate();
            guards.filter_map(|(index, outcome)| match outcome {
                Outcome::Passes { time, jumps, .. } => Some((index, *time, *jumps)),
                Outcome::Stays(_) => None,
            })
        };
        let first = passings().min_by(|a, b| a.1.total_cmp(&b.1))?;
        let at_once = passings().filter(|(_, time, _)| *time <= first.1 + near(first.1));
        let (index, time, _) = at_once.min_by_key(|(_, _, jumps)| *jumps)?;
        let turns_before = |turn: &Turn| turn.time < time - near(time);
        (!self.turn.as_ref().is_some_and(turns_before)).then_some((index, time))
    }

    /// When a guard passes, or something that is led turns, whichever is first.
    fn first_time(&self) -> Option<f64> {
        let turn = self.turn.as_ref().map(|turn| turn.time);
        self.first().map(|(_, time)| time).or(turn)
    }
}

/// What became of a guard where events happened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Passed {
    No,
    /// It passed zero, and was watched all the time.
    GoesOn,
    /// Its event left the modes in which it is watched for: if other events lead back to these,
    /// it has not passed in them.
    Left,
}

/// Where a guard is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
enum Side {
    /// Not watched: a mode has another value.
    Idle,
    /// Above zero (1) or below (-1).
    Known(f64),
    /// It has jumped there, though by errors of the step it may be in front of its jump yet.
    Jumped(f64),
    /// To be seen; what is not larger than `residual` is zero.
    Fresh { passed: bool, residual: f64 },
}

impl<'a> Watch<'a> {
    /// A watch over a run from a state, whose modes it sets right; nothing if the simulator
    /// has no events and no kinks.
    ///
    /// # Errors
    /// [`StopCause::Contradiction`] if the start contradicts an event that would change
    /// more than modes.
    pub fn new(problem: &'a Problem<'a>, state: &mut [f64]) -> Result<Option<Self>, Stopped> {
        let (system, from) = (problem.system, problem.from);
        let simulator = system.simulator();
        let count = simulator.events() + simulator.kinks();
        if count == 0 {
            return Ok(None);
        }
        let watch = Self::with(problem, vec![Side::Idle; count], VecDeque::new(), state);
        watch.settle_start(from, state)?;
        Ok(Some(watch))
    }

    fn with(
        problem: &'a Problem<'a>,
        sides: Vec<Side>,
        latest: VecDeque<f64>,
        state: &[f64],
    ) -> Self {
        let Problem { system, from, until, rtol, atol, .. } = problem;
        let (events, kinks) = (system.simulator().events(), system.simulator().kinks());
        let scale = |entry: usize| {
            if system.simulator().is_mode(entry) { 0.0 } else { atol[entry] / rtol }
        };
        let scales = (0..system.states()).map(scale);
        let inner = Inner {
            sides,
            time: *from,
            start: state.to_vec(),
            parts: Parts::new([events, kinks], state.len(), scales.collect()),
            outcomes: Vec::new(),
            turn: None,
            happening: None,
            latest,
            passages: vec![Passages::default(); events + kinks],
            switches: Vec::new(),
            happened: Happened::default(),
        };
        Self { system, span: until - from, rtol: *rtol, atol, inner: RefCell::new(inner) }
    }

    /// Every event that has happened, in order.
    #[must_use]
    pub fn into_switches(self) -> Vec<Switch> {
        self.inner.into_inner().switches
    }

    /// Starts on a stretch.
    pub(super) fn start_stretch(&self, stretch: &Stretch<'_>, state: &[f64]) {
        self.inner.borrow_mut().parts.ends = (stretch.from, stretch.until);
        self.look_who_is_led(stretch.from, state);
        self.start(stretch.from, state);
    }

    /// Starts anew within a stretch.
    pub(super) fn start(&self, time: f64, state: &[f64]) {
        let inner = &mut *self.inner.borrow_mut();
        inner.time = time;
        inner.start.copy_from_slice(state);
    }

    /// State at the start of the current step.
    pub(super) fn copy_start(&self, state: &mut [f64]) {
        state.copy_from_slice(&self.inner.borrow().start);
    }

    /// The first time at which a kink is passed within a step that is too long: up to there
    /// it may do.
    pub(super) fn kink_within(&self, method: &mut dyn OneStep, until: f64) -> Option<f64> {
        if self.system.simulator().kinks() == 0 {
            return None;
        }
        let inner = &mut *self.inner.borrow_mut();
        self.look_into(inner, method, until);
        if inner.parts.told().is_some() {
            return None;
        }
        let (index, passing) = inner.first()?;
        self.is_kink(index).then_some(passing)
    }

    /// The first time at which a guard passes zero within the current step, which ends
    /// at `until`; if none does, the step's end is the start of the next one.
    pub(super) fn first_passing(&self, method: &mut dyn OneStep, until: f64) -> Option<f64> {
        let inner = &mut *self.inner.borrow_mut();
        let start = (&inner.start[..], &inner.sides[..]);
        if inner.parts.are_far(self.system, method, (inner.time, until), start) {
            inner.time = until;
            inner.start.copy_from_slice(method.end());
            return None;
        }
        self.look_into(inner, method, until);
        if inner.parts.told().is_some() {
            return None;
        }
        self.let_pass_at_start(inner);
        while let Some((index, _)) = inner.first()
            && self.is_held(inner, index, until, method.end())
        {
            inner.outcomes[index] = Outcome::Stays(inner.sides[index]);
        }
        inner.turn = self.turn_within(inner, method, until);
        let mut first = inner.first_time();
        if first.is_none() && inner.parts.is_unclear() {
            let front = until - A_MOMENT * until.abs().max(self.span);
            first = self.first_in_front(inner, method, (inner.time, front));
        }
        if first.is_none() {
            for (side, outcome) in inner.sides.iter_mut().zip(&inner.outcomes) {
                if let Outcome::Stays(on) = outcome {
                    *side = *on;
                }
            }
            inner.time = until;
            inner.start.copy_from_slice(method.end());
        }
        first
    }

    /// The share of the current step that is to be tried instead, if guards do not tell what they
    /// do in all of it.
    pub(super) fn share_that_is_told(&self) -> Option<f64> {
        self.inner.borrow().parts.told()
    }

    /// Sees what all guards do within the current step.
    fn look_into(&self, inner: &mut Inner, method: &mut dyn OneStep, until: f64) {
        let start = (&inner.start[..], &inner.sides[..]);
        inner.parts.fill(self.system, method, (inner.time, until), start);
        inner.outcomes.clear();
        for (index, side) in inner.sides.iter().enumerate() {
            let direction = self.direction(index);
            let guard = Guard { index, direction, is_kink: self.is_kink(index) };
            inner.outcomes.push(inner.parts.outcome(self.system, method, guard, *side));
        }
        inner.turn = None;
    }

    /// Until when a step that ends at the kink that is passed first may be tried, within one
    /// that ends at `until`: what happens before must not be passed on the way.
    pub(super) fn next_event(&self, until: f64) -> f64 {
        let inner = self.inner.borrow();
        let events = inner.outcomes.iter().take(self.system.simulator().events());
        let passings = events.filter_map(|outcome| match outcome {
            Outcome::Passes { time, .. } => Some(*time),
            Outcome::Stays(_) => None,
        });
        passings.fold(until, f64::min)
    }

    /// When the first guard passes of those that are on another side in front of the end of the
    /// current step than at its start, although none was seen to pass before that end: a
    /// comparison with a sawtooth may turn back with it, where looks are too far apart.
    pub(super) fn passes_in_front(
        &self,
        method: &mut dyn OneStep,
        span: (f64, f64),
    ) -> Option<f64> {
        self.first_in_front(&mut self.inner.borrow_mut(), method, span)
    }

    fn first_in_front(
        &self,
        inner: &mut Inner,
        method: &mut dyn OneStep,
        (from, front): (f64, f64),
    ) -> Option<f64> {
        let mut first = None;
        for index in 0..inner.outcomes.len() {
            let Side::Known(side) = inner.sides[index] else { continue };
            let stays = match inner.outcomes[index] {
                Outcome::Passes { time, .. } => time > front,
                Outcome::Stays(end) => end == Side::Known(side),
            };
            if !stays || !is_wanted(self.direction(index), side) {
                continue;
            }
            let passing =
                inner.parts.passing_before(self.system, method, (from, front), index, side);
            if let Some((time, jumps)) = passing {
                inner.outcomes[index] = Outcome::Passes { time, from: side, jumps };
                first = Some(first.map_or(time, |first: f64| first.min(time)));
            }
        }
        first
    }

    /// Whether what passes first is a kink.
    pub(super) fn passes_kink(&self) -> bool {
        self.inner.borrow().first().is_some_and(|(index, _)| self.is_kink(index))
    }

    /// How far a state is in front of the kink that is passed first, as its guard has it; and
    /// the time until there at the rate it has.
    pub(super) fn before_kink(&self, time: f64, state: &[f64]) -> (f64, f64) {
        let inner = &mut *self.inner.borrow_mut();
        let Some((index, _)) = inner.first() else { return (0.0, 0.0) };
        let from = match inner.outcomes[index] {
            Outcome::Passes { from, .. } => from,
            Outcome::Stays(_) => 1.0,
        };
        let there = self.followed(inner, time, state);
        let (guard, rate) = inner.parts.at(self.system, time, &there, index);
        (from * guard, -guard / rate)
    }

    /// What of the guard that passes first may be rounding.
    pub(super) fn rounding(&self) -> f64 {
        let inner = self.inner.borrow();
        inner.first().map_or(0.0, |(index, _)| inner.parts.rounding(index))
    }

    /// By how much a passing at `time`, where the state is `end`, is early; nothing if
    /// the guard says too little there.
    pub(super) fn correction(&self, time: f64, end: &[f64]) -> Option<f64> {
        let inner = &mut *self.inner.borrow_mut();
        let (index, _) = inner.first()?;
        if matches!(inner.outcomes[index], Outcome::Passes { jumps: true, .. }) {
            return None;
        }
        let there = self.followed(inner, time, end);
        let (guard, rate) = inner.parts.at(self.system, time, &there, index);
        let correction = -guard / rate;
        correction.is_finite().then_some(correction)
    }

    /// The step ends at `time` because of the events that were found, in state `end`.
    pub(super) fn happens(&self, time: f64, first: f64, end: &[f64]) {
        let inner = &mut *self.inner.borrow_mut();
        let near = 64.0 * f64::EPSILON * time.abs().max(inner.time.abs());
        let mut happening = Vec::new();
        for (index, outcome) in inner.outcomes.iter().enumerate() {
            let (guard, rate) = inner.parts.at(self.system, time, end, index);
            match *outcome {
                Outcome::Passes { time: passing, .. } if passing <= first + near => {
                    happening.push(index);
                }
                Outcome::Passes { from, .. } if inner.sides[index] == Side::Known(-from) => {
                    // It has passed in the direction in which nothing happens, or passes now.
                    let zero = inner.parts.rounding(index).max(near * rate.abs());
                    inner.sides[index] = if guard.abs() > zero {
                        Side::Known(guard.signum())
                    } else {
                        Side::Fresh { passed: true, residual: guard.abs() }
                    };
                }
                Outcome::Passes { from, .. } => {
                    if guard * from < 0.0 {
                        happening.push(index);
                    } else {
                        inner.sides[index] = Side::Known(from);
                    }
                }
                Outcome::Stays(end @ Side::Known(_))
                    if guard.abs() > inner.parts.rounding(index) && time > inner.time =>
                {
                    let side = Side::Known(guard.signum());
                    let start = inner.sides[index];
                    // An event that has not passed is not beyond but by rounding, as speeds of
                    // what is held are.
                    if !is_beyond(self.direction(index), guard) || [start, end].contains(&side) {
                        inner.sides[index] = side;
                    }
                }
                Outcome::Stays(_) => {}
            }
        }
        inner.turn.take_if(|turn| turn.time > time + near);
        if let Some(turn) = &inner.turn {
            happening.extend(&turn.begins);
            happening.sort_unstable();
            happening.dedup();
        }
        inner.happening = Some((time, happening));
    }

    /// Where the method stopped for events: does what they say to `state`, all of it
    /// from left to right in the order of the spec, each event only if it is still
    /// watched for. Gives the time.
    ///
    /// # Errors
    /// If a new value is not finite, or if events do not end.
    pub(super) fn switch(&self, state: &mut [f64]) -> Result<Option<f64>, Stopped> {
        let Some((time, events)) = self.inner.borrow_mut().happening.take() else {
            return Ok(None);
        };
        let states = self.system.states();
        self.inner.borrow_mut().happened = Happened::default();
        let guards_before = self.guards(time, state);
        let mut passed = vec![Passed::No; guards_before.len()];
        // Where an event has happened, and has turned its guard back.
        let mut turned_back: Vec<usize> = (0..passed.len())
            .filter(|index| self.has_passed(*index) && !self.is_approached(*index, time, state))
            .collect();
        for index in events {
            if self.is_kink(index) {
                passed[index] = Passed::GoesOn;
            } else if self.is_armed(index, state) {
                self.apply(index, time, &mut state[..states])?;
                passed[index] =
                    if self.is_armed(index, state) { Passed::GoesOn } else { Passed::Left };
                self.count(index, time)?;
                if !self.is_approached(index, time, state) {
                    turned_back.push(index);
                }
            }
        }
        let all = passed.iter().enumerate().filter(|(_, passed)| **passed != Passed::No);
        self.inner.borrow_mut().happened.passed = all.map(|(index, _)| index).collect();
        self.settle_after(time, state, &guards_before, &mut passed)?;
        let guards = self.guards(time, state);
        let fresh = |index: usize| {
            let residual = self.residual(index, time, state, guards[index]);
            Side::Fresh { passed: false, residual }
        };
        // What other events send on again while it is there happens again, as where balls hit one
        // from both sides.
        turned_back.retain(|index| self.is_approached(*index, time, state));
        let again = turned_back;
        let inner = &mut *self.inner.borrow_mut();
        inner.turn = None;
        let outcomes = &inner.outcomes;
        let jumped_from = |index: usize| match outcomes.get(index) {
            Some(Outcome::Passes { from, .. }) => Some(*from),
            _ => None,
        };
        // What goes steadily is found far nearer to zero than that.
        let (sizes, is_again) = (inner.parts.sizes(), |index| again.contains(&index));
        let has_jumped =
            |index: usize| !is_again(index) && guards[index].abs() > JUMPED * sizes[index];
        for (index, side) in inner.sides.iter_mut().enumerate() {
            let was_watched = *side != Side::Idle;
            let is_same = guards[index].to_bits() == guards_before[index].to_bits();
            if !self.is_armed(index, state) {
                *side = Side::Idle;
            } else if self.is_kink(index) && guards[index].abs() > inner.parts.rounding(index) {
                // Kinks have no more than sides.
                *side = Side::Known(guards[index].signum());
            } else if passed[index] == Passed::GoesOn && is_same && has_jumped(index) {
                *side = jumped_from(index)
                    .map_or(Side::Known(guards[index].signum()), |from| Side::Jumped(-from));
            } else if passed[index] == Passed::GoesOn
                || passed[index] == Passed::No && again.contains(&index)
            {
                let residual = 4.0 * guards_before[index].abs();
                *side = Side::Fresh { passed: !again.contains(&index), residual };
            } else if passed[index] == Passed::Left || !(was_watched && is_same) {
                *side = fresh(index);
            }
        }
        Ok(Some(time))
    }

    /// What happened where the run was last stopped for events, or as modes were set right at
    /// its start.
    pub(crate) fn happened(&self) -> Happened {
        self.inner.borrow().happened.clone()
    }

    /// A guard and its rate at a state.
    pub(crate) fn guard_at(&self, time: f64, state: &[f64], index: usize) -> (f64, f64) {
        self.inner.borrow_mut().parts.at(self.system, time, state, index)
    }

    /// Whether a guard has passed zero, and has not left it since.
    fn has_passed(&self, index: usize) -> bool {
        matches!(self.inner.borrow().sides[index], Side::Fresh { passed: true, .. })
    }

    /// Whether the guard of an event that happens one way moves that way.
    fn is_approached(&self, index: usize, time: f64, state: &[f64]) -> bool {
        let (_, rate) = self.guard_at(time, state, index);
        match self.direction(index) {
            Direction::Rising => rate > 0.0,
            Direction::Falling => rate < 0.0,
            Direction::Both => false,
        }
    }

    /// How fast the rate of a guard changed in the step that was last looked at.
    pub(crate) fn bend_of(&self, index: usize) -> f64 {
        self.inner.borrow().parts.bend(index)
    }

    /// Whether a guard is not an event's, but that of a kink.
    fn is_kink(&self, index: usize) -> bool {
        index >= self.system.simulator().events()
    }

    fn direction(&self, index: usize) -> Direction {
        if self.is_kink(index) {
            Direction::Both
        } else {
            self.system.simulator().event(index).direction
        }
    }

    /// Guards of events, then of kinks.
    fn guards(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let (simulator, events) = (self.system.simulator(), self.system.simulator().events());
        let mut guards = vec![0.0; events + simulator.kinks()];
        let state = &state[..self.system.states()];
        guards_at((simulator, self.system.parameters()), events, time, state, &mut guards);
        guards
    }

    /// Whether the modes are those in which an event is watched for.
    fn is_armed(&self, index: usize, state: &[f64]) -> bool {
        if self.is_kink(index) {
            return true;
        }
        let when = self.system.simulator().event(index).when;
        // Modes are whole numbers, and stay so but for rounding.
        when.iter().all(|(entry, value)| (state[*entry as usize] - value).abs() < 0.5)
    }

    /// Gives the entries that an event sets their new values.
    fn apply(&self, index: usize, time: f64, state: &mut [f64]) -> Result<(), Stopped> {
        let simulator = self.system.simulator();
        let lengths: Vec<usize> =
            (0..simulator.events()).map(|event| simulator.event(event).sets.len()).collect();
        let mut values = vec![0.0; lengths.iter().sum()];
        simulator.resets(time, state, self.system.parameters(), &mut values);
        let first: usize = lengths[..index].iter().sum();
        let event = simulator.event(index);
        for (entry, value) in event.sets.iter().zip(&values[first..]) {
            let entry = *entry as usize;
            if !value.is_finite() {
                let what = format!(
                    "the new value of `{}` at event `{}`",
                    self.system.name(entry),
                    event.name
                );
                return Err(Stopped { time, cause: StopCause::NotFinite { what } });
            }
            state[entry] = if simulator.is_mode(entry) { value.round() } else { *value };
        }
        Ok(())
    }

    /// Counts an event, and stops what does not end.
    fn count(&self, index: usize, time: f64) -> Result<(), Stopped> {
        let event = self.system.simulator().event(index).name.to_owned();
        self.system.count(|work| work.switches += 1);
        let inner = &mut *self.inner.borrow_mut();
        inner.happened.applied.push(index);
        inner.latest.push_back(time);
        // Many parts may begin at one time.
        let endless = ENDLESS.max(self.most());
        if inner.latest.len() > endless {
            let earliest = inner.latest.pop_front().unwrap_or(time);
            if time - earliest <= NO_TIME * self.span.max(time.abs()) {
                return Err(Stopped { time, cause: StopCause::Zeno { event, count: endless } });
            }
        }
        inner.switches.push(Switch { time, event });
        Ok(())
    }
}

/// The event whose guard and its rate are exactly zero at all of some states spread over
/// the run, the time after it and the states' scales: it could never pass. A guard that only
/// a longer run would see move is none of these.
pub(crate) fn identically_zero(system: &System<'_>, (from, until): (f64, f64)) -> Option<usize> {
    const WITHIN: usize = 8;
    const PROBES: usize = 2 * WITHIN;
    let simulator = system.simulator();
    let count = simulator.events();
    let mut moves = vec![false; count];
    let (mut guards, mut rates) = (vec![0.0; count], vec![0.0; count]);
    for probe in 0..PROBES {
        let spread = |index: usize| ((probe * 31 + index * 17) as f64 * 0.618 + 0.3).sin();
        let value = |index: usize| simulator.state_scale(index) * spread(index + 1);
        let state: Vec<f64> = (0..system.states()).map(value).collect();
        let time = if probe < WITHIN {
            from + (until - from) * (probe as f64 + 0.5) / WITHIN as f64
        } else {
            until + (until - from) * 10f64.powi((probe - WITHIN) as i32)
        };
        simulator.guards(time, &state, system.parameters(), &mut guards);
        simulator.guard_rates(time, &state, system.parameters(), &mut rates);
        for ((moves, guard), rate) in moves.iter_mut().zip(&guards).zip(&rates) {
            *moves |= *guard != 0.0 || *rate != 0.0;
        }
    }
    moves.iter().position(|moves| !moves)
}
