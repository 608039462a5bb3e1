//! Parts that would stick although their motion is prescribed: friction on a driven shaft, or on a
//! slider at a dead point of its crank.
//!
//! A constraint that holds in modes may repeat others. These others then prescribe the motion of
//! the part that it holds:
//!
//! - If they continue as the constraint requires, it holds, and they carry all of the force.
//! - If they continue otherwise, it cannot hold: whatever force it took, they would take more. Of
//!   the events that release it, one happens after which the motion continues and no other part
//!   would let go instead. So friction whose speed crosses zero slides to the other side at once.
//! - A part at rest with them lets go as soon as they move. A sliding part begins to stick as they
//!   come to rest. Neither needs a zero crossing of its guard.

use super::super::{Stopped, Stretch};
use super::passing::middle;
use super::settle::{Trial, is_beyond};
use super::{Inner, Side, Watch};
use crate::constraints::Constraints;
use crate::error::StopCause;
use crate::method::one_step::OneStep;

/// Relative residual of a constraint below which motions agree.
const ALIKE: f64 = 2e-14;
/// Relative residual above which motions differ; a projection could still remove it.
const OTHERWISE: f64 = 10.0 * ALIKE;

/// A time within a step at which a prescribed part comes to rest or starts to move.
#[derive(Debug, Clone, Default)]
pub(super) struct Turn {
    pub(super) time: f64,
    /// Events of the parts that come to rest.
    pub(super) begins: Vec<usize>,
    /// Time after which a part that starts to move has certainly moved \[s\].
    moves_within: f64,
}

impl Watch<'_> {
    fn constraints(&self) -> Option<&Constraints<'_>> {
        self.system.constraints()
    }

    /// Records which constraints repeat others in the modes of a state.
    pub(super) fn look_who_is_led(&self, time: f64, state: &[f64]) {
        let states = &state[..self.system.states()];
        let constraints = self.constraints().filter(|constraints| constraints.holds_in_modes());
        let prescribed =
            constraints.map_or_else(Vec::new, |constraints| constraints.prescribed(time, states));
        self.inner.borrow_mut().parts.prescribed.clone_from(&prescribed);
    }

    /// Returns the largest number of corrections of an event time. It is larger where a part may be
    /// prescribed, because a part not quite there would hold its drive.
    pub(in crate::method) fn corrections(&self) -> usize {
        if self.constraints().is_some_and(Constraints::may_lead) { 12 } else { 3 }
    }

    /// Returns a state projected onto the constraints that may prescribe a motion.
    pub(super) fn followed(&self, inner: &Inner, time: f64, state: &[f64]) -> Vec<f64> {
        let mut there = state.to_vec();
        if let Some(constraints) = self.constraints().filter(|it| it.may_lead()) {
            constraints.follow(&inner.parts.prescribed, time, &mut there);
        }
        there
    }

    /// Returns whether constraints hold the guard of an event at zero. All its changes over a step
    /// are then removed by the projection of the end.
    pub(super) fn is_held(&self, inner: &mut Inner, index: usize, until: f64, end: &[f64]) -> bool {
        let constraints = self.constraints().filter(|constraints| constraints.holds_in_modes());
        let Some(constraints) = constraints else { return false };
        let mut there = end.to_vec();
        constraints.follow(&inner.parts.prescribed, until, &mut there);
        let (guard, _) = inner.parts.at(self.system, until, &there, index);
        guard.abs() <= inner.parts.rounding(index)
    }

    /// Returns the time after which repeated constraints are violated, if that is soon.
    fn goes_otherwise(
        &self,
        prescribed: &[usize],
        time: f64,
        state: &[f64],
        within: f64,
    ) -> Option<f64> {
        /// Share of the run.
        const SOON: f64 = 1e-6;
        const FINEST: f64 = 1e-13;
        /// Less than 0.5^5, which a fifth power leaves at half the time.
        const EVENLY: f64 = 0.02;
        let constraints = self.constraints()?;
        let size = self.span.max(time.abs());
        let mut there = state.to_vec();
        constraints.follow(prescribed, time, &mut there);
        let now = constraints.left_behind(prescribed, time, &there);
        let least = FINEST * size;
        if now > OTHERWISE {
            return Some(least);
        }
        let off = |span: f64| {
            let later = self.later(prescribed, (time, &there), span);
            constraints.left_behind(prescribed, time + span, &later)
        };
        let most = within.max(SOON * size);
        let halvings = (most / least).log2() as i32;
        let spans = (0..=halvings).rev().map(|finer| most * 0.5_f64.powi(finer));
        let (span, far) = spans.map(|span| (span, off(span))).find(|(_, off)| *off > OTHERWISE)?;
        // A motion that starts later is excluded: half as soon, it is not visible yet.
        let is_now = within > 0.0 || off(0.5 * span) > EVENLY * far;
        is_now.then_some(span)
    }

    /// Returns the state after a short time, without the constraints that repeat others.
    fn later(&self, prescribed: &[usize], (time, state): (f64, &[f64]), by: f64) -> Vec<f64> {
        let states = self.system.states();
        let mut rate = vec![0.0; states];
        self.system.state_rate(time, &state[..states], &mut rate);
        let mut later: Vec<f64> = state.iter().zip(&rate).map(|(y, f)| y + by * f).collect();
        if let Some(constraints) = self.constraints() {
            constraints.follow(prescribed, time + by, &mut later);
        }
        later
    }

    /// Releases constraints that repeat others which continue otherwise, and notes who carries the
    /// rest.
    ///
    /// # Errors
    /// [`StopCause::Overdetermined`] if no event releases a constraint so that the motion can
    /// continue.
    pub(super) fn let_go(
        &self,
        time: f64,
        state: &mut [f64],
        mut went: impl FnMut(usize),
    ) -> Result<(), Stopped> {
        let Some(constraints) = self.constraints().filter(|it| it.holds_in_modes()) else {
            return Ok(());
        };
        let states = self.system.states();
        for _ in 0..=self.most() {
            let (simulator, parameters) = (self.system.simulator(), self.system.parameters());
            let found = crate::constraints::mobility(simulator, parameters, time, &state[..states]);
            let redundant = found.map_or_else(Vec::new, |mobility| mobility.redundant);
            let prescribed = constraints.prescribed(time, &state[..states]);
            let within = self.inner.borrow().turn.as_ref().map_or(0.0, |turn| turn.moves_within);
            let after = if prescribed.is_empty() {
                None
            } else {
                self.goes_otherwise(&prescribed, time, state, within)
            };
            let is_refused = |index: usize| !redundant[index].in_modes || after.is_some();
            let Some(first) = (0..redundant.len()).find(|index| is_refused(*index)) else {
                for redundant in redundant {
                    self.system.note(redundant.shares());
                }
                self.inner.borrow_mut().parts.prescribed = prescribed;
                return Ok(());
            };
            let released = after.and_then(|after| self.release(time, state, &prescribed, after));
            let Some((index, after)) = released else {
                let (constraint, why) =
                    (redundant[first].constraint.clone(), redundant[first].why());
                return Err(Stopped { time, cause: StopCause::Overdetermined { constraint, why } });
            };
            state.copy_from_slice(&after);
            self.count(index, time)?;
            went(index);
        }
        let event = self.system.simulator().event(0).name.to_owned();
        Err(Stopped { time, cause: StopCause::Contradiction { event } })
    }

    /// Returns the event that releases a repeated constraint, and the state after it.
    fn release(
        &self,
        time: f64,
        state: &[f64],
        prescribed: &[usize],
        after: f64,
    ) -> Option<(usize, Vec<f64>)> {
        let constraints = self.constraints()?;
        let simulator = self.system.simulator();
        let mut possible = None;
        for index in (0..simulator.events()).filter(|index| self.sets_its_mode(*index)) {
            if !self.is_armed(index, state) {
                continue;
            }
            let Ok(Trial { state: behind, leaves: true, moves: false }) =
                self.trial(index, time, state)
            else {
                continue;
            };
            let left = constraints.prescribed(time, &behind[..self.system.states()]);
            if left.len() >= prescribed.len() || !self.goes_on(time, (state, &behind), &left, after)
            {
                continue;
            }
            if !self.lets_others_go(time, (state, &behind)) {
                return Some((index, behind));
            }
            possible = possible.or(Some((index, behind)));
        }
        possible
    }

    /// Returns whether the motion continues after a release: no event that is armed only now has
    /// happened by then, and some guard changes.
    fn goes_on(
        &self,
        time: f64,
        (before, behind): (&[f64], &[f64]),
        prescribed: &[usize],
        after: f64,
    ) -> bool {
        // Guards other than those of speeds may be less sharp.
        const LONGER: f64 = 8.0;
        let after = LONGER * after;
        let later = self.later(prescribed, (time, behind), after);
        let (guards, guards_later) = (self.guards(time, behind), self.guards(time + after, &later));
        let is_new = |index: &usize| {
            self.sets_its_mode(*index)
                && self.is_armed(*index, behind)
                && !self.is_armed(*index, before)
        };
        let mut new = (0..self.system.simulator().events()).filter(is_new).peekable();
        let mut moves = false;
        new.all(|index| {
            let (now, then) = (guards[index], guards_later[index]);
            moves |= now.to_bits() != then.to_bits();
            let direction = self.direction(index);
            let zero = self.zero(index, time, behind);
            let is_behind = is_beyond(direction, now) && now.abs() > zero;
            !(is_behind || is_beyond(direction, then) && (then - now) * then > 0.0)
        }) && moves
    }

    /// Returns whether another part would also let go that would not have before.
    fn lets_others_go(&self, time: f64, (before, behind): (&[f64], &[f64])) -> bool {
        let (guards, guards_behind) = (self.guards(time, before), self.guards(time, behind));
        (0..self.system.simulator().events()).any(|index| {
            let direction = self.direction(index);
            self.sets_its_mode(index)
                && self.is_armed(index, before)
                && self.is_armed(index, behind)
                && !is_beyond(direction, guards[index])
                && is_beyond(direction, guards_behind[index])
                && guards_behind[index].abs() > self.zero(index, time, behind)
        })
    }

    /// Lets parts come to rest or start to move with their drive, in a state from which steps
    /// start, and modes that were left undetermined be determined. Returns whether any does.
    pub(in crate::method) fn turns(&self, stretch: &Stretch<'_>, time: f64, state: &[f64]) -> bool {
        let is_led = self.constraints().is_some_and(Constraints::holds_in_modes);
        if !is_led || time >= stretch.until {
            return false;
        }
        let prescribed = self.inner.borrow().parts.prescribed.clone();
        let begins = self.begin_to_rest(time, state);
        let ends =
            !prescribed.is_empty() && self.goes_otherwise(&prescribed, time, state, 0.0).is_some();
        if begins.is_empty() && !ends && !self.is_undetermined(time, state) {
            return false;
        }
        self.inner.borrow_mut().happening = Some((time, begins));
        true
    }

    /// Returns events with guards at rest at zero that make a prescribed constraint hold.
    fn begin_to_rest(&self, time: f64, state: &[f64]) -> Vec<usize> {
        let Some(constraints) = self.constraints().filter(|it| it.may_lead()) else {
            return Vec::new();
        };
        let inner = &mut *self.inner.borrow_mut();
        let mut there = state.to_vec();
        constraints.follow(&inner.parts.prescribed, time, &mut there);
        let guards = self.guards(time, &there);
        let events = 0..self.system.simulator().events();
        let at_zero = events.filter(|index| {
            let zero = inner.parts.rounding(*index);
            guards[*index].abs() <= zero
                && inner.parts.at(self.system, time, &there, *index).1.abs() * self.span <= zero
        });
        let at_zero: Vec<usize> = at_zero.collect();
        self.that_begin(&at_zero, inner, time, &there)
    }

    /// Returns those events with guards at rest at zero that make a constraint hold which repeats
    /// constraints that always hold.
    fn that_begin(&self, at_zero: &[usize], inner: &Inner, time: f64, state: &[f64]) -> Vec<usize> {
        let Some(constraints) = self.constraints() else { return Vec::new() };
        let (simulator, parameters) = (self.system.simulator(), self.system.parameters());
        let begins = |index: usize| {
            if !matches!(inner.sides[index], Side::Known(_))
                || !self.sets_its_mode(index)
                || !self.is_armed(index, state)
            {
                return false;
            }
            let Ok(Trial { state: behind, leaves: true, moves: false }) =
                self.trial(index, time, state)
            else {
                return false;
            };
            let behind = &behind[..self.system.states()];
            let found = crate::constraints::mobility(simulator, parameters, time, behind);
            let is_led = found.is_some_and(|found| found.redundant.iter().any(|it| it.is_led));
            let prescribed = constraints.prescribed(time, behind);
            is_led
                && prescribed.len() > inner.parts.prescribed.len()
                && self.goes_otherwise(&prescribed, time, behind, 0.0).is_none()
        };
        at_zero.iter().copied().filter(|index| begins(*index)).collect()
    }

    /// Returns the first time within the current step, which ends at `until`, at which a prescribed
    /// part comes to rest or starts to move.
    pub(super) fn turn_within(
        &self,
        inner: &Inner,
        method: &mut dyn OneStep,
        until: f64,
    ) -> Option<Turn> {
        let constraints = self.constraints().filter(|it| it.may_lead())?;
        let mut state = method.end().to_vec();
        let from = inner.time;
        constraints.follow(&inner.parts.prescribed, until, &mut state);
        if constraints.left_behind(&inner.parts.prescribed, until, &state) > OTHERWISE {
            let has_moved = |time: f64, state: &[f64]| {
                constraints.left_behind(&inner.parts.prescribed, time, state) > ALIKE
            };
            let time = self.first_time(inner, method, (from, until), has_moved).0;
            return Some(Turn { time, begins: Vec::new(), moves_within: until - time });
        }
        let zero = |index: usize| inner.parts.rounding(index);
        let at_zero = (0..self.system.simulator().events()).filter(|index| {
            let (guard, rate) = inner.parts.last(*index);
            guard.abs() <= zero(*index) && rate.abs() * self.span <= zero(*index)
        });
        let at_zero: Vec<usize> = at_zero.collect();
        if at_zero.is_empty() {
            return None;
        }
        let begins = self.that_begin(&at_zero, inner, until, &state);
        let first = *begins.first()?;
        let is_at_zero =
            |time: f64, state: &[f64]| self.guards(time, state)[first].abs() <= zero(first);
        let time = self.first_time(inner, method, (from, until), is_at_zero).1;
        Some(Turn { time, begins, moves_within: 0.0 })
    }

    /// Returns two neighbouring times within the current step between which a condition that is
    /// true at the end becomes true.
    fn first_time(
        &self,
        inner: &Inner,
        method: &mut dyn OneStep,
        (from, until): (f64, f64),
        is_so: impl Fn(f64, &[f64]) -> bool,
    ) -> (f64, f64) {
        let (mut before, mut after) = (from, until);
        let mut state = method.end().to_vec();
        let is_so_at = |time: f64, state: &mut Vec<f64>| {
            if let Some(constraints) = self.constraints() {
                constraints.follow(&inner.parts.prescribed, time, state);
            }
            is_so(time, state)
        };
        state.copy_from_slice(&inner.start);
        if is_so_at(from, &mut state) {
            return (from, from);
        }
        while let Some(time) = middle(before, after) {
            method.interpolate(time, &mut state);
            if is_so_at(time, &mut state) {
                after = time;
            } else {
                before = time;
            }
        }
        (before, after)
    }
}
