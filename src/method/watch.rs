//! Watches guards while a method steps, and applies events at their zero crossings.
//!
//! - Relations are held within a step. Where one changes, the step is retaken to end there, with
//!   the time corrected by Newton's method. The time of a change is as accurate as a step; see
//!   `passing`.
//! - At a change a relation takes the side to which the motion goes on, or the motion slides along
//!   its surface; see `relations`.
//! - Just after an event its guard is zero but for rounding. The sign of dg/dt then tells the side.
//!   If dg/dt is zero, the first side on which the guard is seen counts. So no event happens twice,
//!   and no short bounce is missed.
//! - A guard that starts at zero and leaves to the far side counts as crossed, unless it has just
//!   crossed.
//! - Modes that contradict their guards are corrected. An event that changes a mode of its own
//!   `when`, and whose guard is already beyond zero, happens at once. At the start it may change
//!   only modes; it may also happen after events. See `settle`.
//! - Infinitely many events in a finite time (Zeno) stop the run.

mod clear;
mod counters;
mod crossing;
mod happening;
mod hosted;
mod noise;
mod passing;
mod polynomial;
mod prescribed;
mod relations;
mod settle;
mod silent;
mod surfaces;
mod watched;

use std::cell::{Cell, RefCell};
use std::collections::VecDeque;

use machinist_contract::Direction;
use serde::{Deserialize, Serialize};

use super::one_step::OneStep;
use super::{Problem, StepTolerance, Stopped, Stretch, System};
use crate::trajectory::Switch;
use clear::ClearBox;
use counters::Counters;
pub(crate) use hosted::Memory;
use passing::{Guard, Outcome, Parts, Step, Zero};
use prescribed::Turn;
use relations::{Change, Relations};
pub(super) use settle::is_beyond;
use watched::{Sources, Watched};

/// Maximum number of events within [`NO_TIME`] before a run is declared Zeno. The limit is higher
/// for a scene with many events.
const ENDLESS: usize = 50;
/// Zeno window, as a share of the time reached, or of the run if that is longer.
const NO_TIME: f64 = 1e-10;
/// Rounding errors of a guard's terms, or of time, that count as zero: a few for each operation of
/// a guard.
const ROUNDINGS: f64 = 64.0;

/// The guards of a run and their states.
pub struct Watch<'a> {
    system: &'a System<'a>,
    span: f64,
    rtol: f64,
    atol: &'a [f64],
    /// Tolerances of steps over those of the run.
    tightness: Cell<f64>,
    /// All watched functions, events first.
    watched: Vec<Watched>,
    /// Values of guards at states other than those of steps.
    sources: RefCell<Sources>,
    inner: RefCell<Inner>,
}

struct Inner {
    sides: Vec<Side>,
    /// Guards that were zero at the start of the segment.
    zeros: Vec<Option<Zero>>,
    relations: Relations,
    /// Start of the next step.
    time: f64,
    start: Vec<f64>,
    parts: Parts,
    clear: ClearBox,
    outcomes: Vec<Outcome>,
    counters: Counters,
    /// Guards whose relations change within the step without ending it, with these changes.
    silent: Vec<(usize, Change)>,
    /// First time within the step at which a prescribed part comes to rest or starts to move.
    turn: Option<Turn>,
    /// Events whose guards reach or leave zero at the start of the stretch, where time turns them,
    /// and the sides from which they cross.
    touched: Vec<(usize, f64)>,
    /// Longest step within the current zone \[s\], and the time at which the motion entered it.
    longest: f64,
    entered: f64,
    /// Time and guards of a crossing that has been found.
    happening: Option<(f64, Vec<usize>)>,
    latest: VecDeque<f64>,
    /// Number of times in a row that each event has happened without its guard leaving zero in
    /// between by more than rounding.
    unresolved: Vec<usize>,
    switches: Vec<Switch>,
    record: EventRecord,
    /// State before the last change, if sensitivities are carried.
    front: Option<Front>,
}

/// Values just before a change.
#[derive(Debug, Clone)]
pub(crate) struct Front {
    /// y' with the relations before the change.
    pub(crate) rate: Vec<f64>,
    /// Each guard and its rate.
    pub(crate) guards: Vec<(f64, f64)>,
}

/// Changes that happened at one time.
#[derive(Debug, Clone, Default)]
pub(crate) struct EventRecord {
    /// Guards that crossed zero: those of armed events and of kinks.
    pub(crate) passed: Vec<usize>,
    /// Events that were applied, in order, including those that other events caused.
    pub(crate) applied: Vec<usize>,
}

impl Inner {
    /// Returns the first guard that crosses zero, with its time; `None` if a prescribed part comes
    /// to rest or starts to move before it.
    fn first(&self) -> Option<(usize, f64)> {
        let near = |time: f64| ROUNDINGS * f64::EPSILON * time.abs();
        let guards = self.outcomes.iter().enumerate();
        let passings = guards.filter_map(|(index, outcome)| match outcome {
            Outcome::Passes { time, .. } => Some((index, *time)),
            Outcome::Stays(_) => None,
        });
        let (index, time) = passings.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let turns_before = |turn: &Turn| turn.time < time - near(time);
        (!self.turn.as_ref().is_some_and(turns_before)).then_some((index, time))
    }

    /// Returns the time of the first zero crossing, or the time at which a prescribed part comes to
    /// rest or starts to move, whichever is first.
    fn first_time(&self) -> Option<f64> {
        let turn = self.turn.as_ref().map(|turn| turn.time);
        self.first().map(|(_, time)| time).or(turn)
    }
}

/// Effect of events on a guard.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Passed {
    No,
    /// The guard crossed zero and stayed armed.
    GoesOn,
    /// The event left the modes in which it is armed. If other events lead back to these modes, the
    /// guard has not crossed in them.
    Disarmed,
}

/// Side of a guard.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
enum Side {
    /// Not armed: a mode has another value.
    Idle,
    /// Above zero (1) or below (-1).
    Known(f64),
    /// Not known yet; values up to `residual` count as zero.
    Fresh { passed: bool, residual: f64 },
}

impl<'a> Watch<'a> {
    /// Returns a watch over a run, after correction of the modes of its state; `None` if the
    /// simulator has neither events nor kinks.
    ///
    /// # Errors
    /// [`StopCause::Contradiction`](crate::error::StopCause::Contradiction) if the start contradicts an event that would change more than
    /// modes.
    pub fn new(problem: &'a Problem<'a>, state: &mut [f64]) -> Result<Option<Self>, Stopped> {
        let (system, from) = (problem.system, problem.from);
        let watched = Watched::all(system.simulator());
        if watched.is_empty() {
            return Ok(None);
        }
        let sides = vec![Side::Idle; watched.len()];
        let watch = Self::with(problem, sides, VecDeque::new(), state);
        watch.settle_start(from, state)?;
        Ok(Some(watch))
    }

    fn with(
        problem: &'a Problem<'a>,
        sides: Vec<Side>,
        latest: VecDeque<f64>,
        state: &[f64],
    ) -> Self {
        let Problem { system, from, until, tolerance, .. } = problem;
        let StepTolerance { rtol, atol, .. } = tolerance;
        let scale = |entry: usize| {
            if system.simulator().is_mode(entry) { 0.0 } else { atol[entry] / rtol }
        };
        let scales = (0..system.states()).map(scale).collect();
        let watched = Watched::all(system.simulator());
        let inner = Inner {
            zeros: vec![None; sides.len()],
            sides,
            relations: Relations::new(system.simulator().relations()),
            time: *from,
            start: state.to_vec(),
            parts: Parts::new(system, watched.clone(), (state.len(), scales)),
            clear: ClearBox::new(system, watched.len()),
            outcomes: Vec::new(),
            counters: Counters::new(system),
            silent: Vec::new(),
            turn: None,
            touched: Vec::new(),
            longest: f64::INFINITY,
            entered: *from,
            happening: None,
            latest,
            unresolved: vec![0; system.simulator().events()],
            switches: Vec::new(),
            record: EventRecord::default(),
            front: None,
        };
        let (inner, sources) =
            (RefCell::new(inner), RefCell::new(Sources::new(system.simulator())));
        let (rtol, tightness, span) = (*rtol, Cell::new(1.0), until - from);
        Self { system, span, rtol, atol, tightness, watched, sources, inner }
    }

    /// Takes all events that happened so far, in order.
    pub(crate) fn take_switches(&self) -> Vec<Switch> {
        std::mem::take(&mut self.inner.borrow_mut().switches)
    }

    /// Returns all events that happened, in order.
    #[must_use]
    pub fn into_switches(self) -> Vec<Switch> {
        self.inner.into_inner().switches
    }

    /// Starts a stretch.
    pub(super) fn start_stretch(&self, stretch: &Stretch<'_>, state: &[f64]) {
        self.inner.borrow_mut().parts.ends = (stretch.from, stretch.until);
        self.look_who_is_led(stretch.from, state);
        self.start(stretch.from, state);
    }

    /// Starts a segment within a stretch.
    pub(super) fn start(&self, time: f64, state: &[f64]) {
        let inner = &mut *self.inner.borrow_mut();
        inner.time = time;
        inner.start.copy_from_slice(state);
        inner.counters.clear();
        inner.parts.restart();
        inner.clear.forget();
    }

    /// Takes the state to which the end of the accepted step was projected.
    pub(super) fn put_back(&self, time: f64, state: &[f64]) {
        let inner = &mut *self.inner.borrow_mut();
        inner.start.copy_from_slice(state);
        inner.parts.renew_end(self.system, time, state);
    }

    /// Copies the state at the start of the current step.
    pub(super) fn copy_start(&self, state: &mut [f64]) {
        state.copy_from_slice(&self.inner.borrow().start);
    }

    /// Returns the first zero crossing within the current step, which ends at `until`.
    pub(super) fn first_passing(&self, method: &mut dyn OneStep, until: f64) -> Option<f64> {
        let inner = &mut *self.inner.borrow_mut();
        inner.clear.follow(method, [inner.time, until], &inner.start);
        if inner.clear.are_all() {
            self.note_excursions_of_box(inner);
            inner.outcomes.clear();
            inner.silent.clear();
            inner.turn = None;
            return None;
        }
        self.look_into(inner, method, until);
        self.let_pass_at_start(inner);
        while let Some((index, _)) = inner.first()
            && self.is_held(inner, index, until, method.end())
        {
            inner.outcomes[index] = Outcome::Stays(inner.sides[index]);
        }
        inner.turn = self.turn_within(inner, method, until);
        inner.first_time()
    }

    /// Makes the end of the current step the start of the next one, where no guard crossed zero.
    ///
    /// # Errors
    /// As [`Watch::tally`].
    pub(super) fn pass(&self, method: &mut dyn OneStep, until: f64) -> Result<(), Stopped> {
        self.tally(method, until)?;
        let inner = &mut *self.inner.borrow_mut();
        for (side, outcome) in inner.sides.iter_mut().zip(&inner.outcomes) {
            if let Outcome::Stays(on) = outcome {
                *side = *on;
            }
        }
        if !inner.outcomes.is_empty() {
            inner.parts.note_arcs_to_end();
        }
        self.change_silently(inner);
        self.look_for_clear(inner, method, until);
        inner.time = until;
        inner.start.copy_from_slice(method.end());
        Ok(())
    }

    /// Returns the longest step allowed now \[s\].
    pub(super) fn longest_step(&self) -> f64 {
        self.inner.borrow().longest
    }

    /// Returns whether the step that was tried is too long for its zone, once it shows the time at
    /// which the motion is nearest to the centre. A few steps over the zone may see next to nothing
    /// of its force, and a single one nothing at all by chance.
    pub(super) fn is_too_long(&self, tried: f64) -> bool {
        /// A bell is about a tenth as wide as its zone.
        const STEPS: f64 = 16.0;
        let inner = &mut *self.inner.borrow_mut();
        let nearest =
            inner.first().filter(|(index, _)| matches!(self.watched[*index], Watched::Nearest(_)));
        if let Some((_, nearest)) = nearest
            && inner.longest.is_infinite()
        {
            inner.longest = (nearest - inner.entered) / STEPS;
            return tried > inner.longest;
        }
        false
    }

    /// Evaluates all guards over the current step.
    fn look_into(&self, inner: &mut Inner, method: &mut dyn OneStep, until: f64) {
        let mut step = Step { system: self.system, method };
        inner.parts.look(&mut step, (inner.time, until), &inner.start);
        inner.outcomes.clear();
        inner.outcomes.extend(inner.sides.iter().map(|side| Outcome::Stays(*side)));
        // Borders first: other guards are evaluated only up to the first border.
        let mut limit = until;
        for index in (0..self.watched.len()).rev() {
            if inner.counters.has(index) || inner.clear.is_clear(index) {
                continue;
            }
            let (direction, is_kink) = (self.direction(index), self.is_kink(index));
            let guard = Guard { index, direction, is_kink, zero: inner.zeros[index] };
            let outcome = inner.parts.outcome(&mut step, (guard, limit), inner.sides[index]);
            if let (true, Outcome::Passes { time, .. }) = (self.watched[index].is_border(), outcome)
            {
                limit = limit.min(time);
            }
            inner.outcomes[index] = outcome;
        }
        let counters = &inner.counters;
        let (counted, touched): (Vec<_>, Vec<_>) =
            inner.touched.drain(..).partition(|(index, _)| counters.has(*index));
        inner.touched = counted;
        for (index, from) in touched {
            inner.outcomes[index] = Outcome::Passes { time: inner.time, from };
        }
        self.look_over_dips(inner, &mut step);
        self.look_over_silent_changes(inner, &mut step);
        inner.turn = None;
    }

    /// Ignores relations that have just changed and return within the step, if their guards go
    /// beyond zero by less than the tolerances. A branch has no memory, so this is the error of the
    /// step.
    fn look_over_dips(&self, inner: &mut Inner, step: &mut Step<'_, '_>) {
        for index in self.system.simulator().events()..self.watched.len() {
            let Outcome::Passes { time, from } = inner.outcomes[index] else { continue };
            let was_zero = inner.zeros[index].is_some_and(|zero| zero.is_at(inner.time));
            if !was_zero || self.watched[index].is_border() {
                continue;
            }
            let dip = inner.parts.dip(step, (index, from), time);
            if dip.is_some_and(|dip| dip <= self.blur(index, inner.time, &inner.start)) {
                inner.outcomes[index] = Outcome::Stays(Side::Known(from));
            }
        }
    }

    /// Returns the rounding error of a watched function in the last step.
    pub(crate) fn rounding_of(&self, index: usize) -> f64 {
        self.inner.borrow().parts.rounding(index)
    }

    /// Marks that the method ended here without an event, so that another segment begins.
    pub(super) fn goes_on_elsewhere(&self, time: f64) {
        self.inner.borrow_mut().happening = Some((time, Vec::new()));
    }

    /// Returns whether relations changed at the last stop of the run.
    pub(super) fn has_changed_relations(&self) -> bool {
        self.inner.borrow().record.passed.iter().any(|index| self.is_kink(*index))
    }

    /// Returns whether the relations that changed last compare nothing that depends on the state.
    pub(super) fn changes_with_time(&self, time: f64, state: &[f64]) -> bool {
        let passed = self.inner.borrow().record.passed.clone();
        let simulator = self.system.simulator();
        let kinks = passed.iter().filter_map(|index| Some(self.watched[*index].kink()?.0));
        let kinks: Vec<usize> = kinks.collect();
        let here = self.system.kink_guards(time, state);
        let mut shifted = state.to_vec();
        (0..self.system.states()).filter(|entry| !simulator.is_mode(*entry)).all(|entry| {
            shifted[entry] = state[entry] + simulator.state_scale(entry);
            let there = self.system.kink_guards(time, &shifted);
            shifted[entry] = state[entry];
            kinks.iter().all(|kink| here[*kink].to_bits() == there[*kink].to_bits())
        })
    }

    /// Returns the changes at the last stop for events, or of the modes at the start.
    pub(crate) fn record(&self) -> EventRecord {
        self.inner.borrow().record.clone()
    }

    /// Returns a guard and its rate at a state.
    pub(crate) fn guard_at(&self, time: f64, state: &[f64], index: usize) -> (f64, f64) {
        self.inner.borrow_mut().parts.at(self.system, time, state, index)
    }

    /// Returns whether a guard has crossed zero and has not left it since.
    fn has_passed(&self, index: usize) -> bool {
        matches!(self.inner.borrow().sides[index], Side::Fresh { passed: true, .. })
    }

    /// Returns whether a guard is beyond zero by more than rounding.
    fn has_leapt(&self, index: usize, time: f64, state: &[f64]) -> bool {
        let Side::Known(side) = self.inner.borrow().sides[index] else { return false };
        let (guard, rate) = self.guard_at(time, state, index);
        let rounding = self.inner.borrow().parts.rounding(index);
        side * guard < -rounding.max(by_rounding(time, rate))
    }

    /// Returns whether the guard of an event with a direction moves in that direction.
    fn is_approached(&self, index: usize, time: f64, state: &[f64]) -> bool {
        let (_, rate) = self.guard_at(time, state, index);
        match self.direction(index) {
            Direction::Rising => rate > 0.0,
            Direction::Falling => rate < 0.0,
            Direction::Both => false,
        }
    }

    /// Returns the rate of change of a guard's rate in the last step.
    pub(crate) fn bend_of(&self, index: usize) -> f64 {
        self.inner.borrow().parts.bend(index)
    }

    /// Returns whether a guard is one of a kink and not of an event.
    fn is_kink(&self, index: usize) -> bool {
        index >= self.system.simulator().events()
    }

    fn direction(&self, index: usize) -> Direction {
        if matches!(self.watched[index], Watched::Nearest(_)) {
            Direction::Falling
        } else if self.is_kink(index) {
            Direction::Both
        } else {
            self.system.simulator().event(index).direction
        }
    }

    /// Returns the values of all watched functions, events first.
    fn guards(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let sources = &mut *self.sources.borrow_mut();
        sources.take(self.system, time, state);
        self.watched.iter().map(|watched| sources.value(self.system, *watched)).collect()
    }

    /// Keeps the values before a change that sensitivities need.
    fn keep_front(&self, time: f64, state: &[f64]) {
        let front = self.system.tangents().map(|_| {
            let mut rate = vec![0.0; self.system.len()];
            let inner = &mut *self.inner.borrow_mut();
            let at = super::stretch::within(time, inner.parts.ends);
            self.system.rate(at, state, &mut rate);
            Front { rate, guards: inner.parts.all_at(self.system, time, state) }
        });
        self.inner.borrow_mut().front = front;
    }

    /// Returns the values before the last change.
    pub(crate) fn front(&self) -> Option<Front> {
        self.inner.borrow().front.clone()
    }

    /// Returns whether the rate is continuous where a watched function crosses zero: at the end of
    /// sliding, and in a zone.
    pub(crate) fn is_smooth_at(&self, index: usize) -> bool {
        use Watched::{FromAbove, FromBelow, Nearest, Zone};
        matches!(self.watched[index], FromBelow(_) | FromAbove(_) | Zone(_) | Nearest(_))
    }

    /// Returns the guard of a kink among those of the simulator, with its sign.
    pub(crate) fn kink_of(&self, index: usize) -> Option<(usize, f64)> {
        self.watched[index].kink()
    }

    /// Returns whether an event is armed in the modes of a state.
    fn is_armed(&self, index: usize, state: &[f64]) -> bool {
        self.is_kink(index) || self.system.is_armed(index, state)
    }
}

/// Returns the rounding error of a guard with some rate, due to rounding of time.
fn by_rounding(time: f64, rate: f64) -> f64 {
    ROUNDINGS * f64::EPSILON * time.abs() * rate.abs()
}
