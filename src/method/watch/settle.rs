//! Modes that contradict their guards, at the start and after events.
//!
//! An event that changes a mode of its own `when` defines the end of that mode. If its guard is
//! beyond zero in the event's direction while it is armed, no run passes through the state.
//! "Beyond" means by more than the tolerances of the run change the guard. A guard nearer to zero
//! counts as zero, and its rate decides.

use machinist_contract::Direction;

use super::passing::Outcome;
use super::{Inner, Passed, Side, Watch, by_rounding};
use crate::constraints::{Constraints, Level};
use crate::error::StopCause;
use crate::method::Stopped;

/// State after a trial of an event.
pub(super) struct Trial {
    pub(super) state: Vec<f64>,
    /// True if the event would no longer be armed.
    pub(super) leaves: bool,
    /// True if it would change something other than modes by more than the tolerances.
    pub(super) moves: bool,
}

impl Watch<'_> {
    /// Corrects the modes at the start of a run; other states keep the values of `[initial]`.
    pub(super) fn settle_start(&self, time: f64, state: &mut [f64]) -> Result<(), Stopped> {
        // No step has erred yet: states are off by their rounding.
        self.tightness.set((f64::EPSILON / self.rtol).min(1.0));
        let settled = self.settle_exactly(time, state);
        self.tightness.set(1.0);
        settled
    }

    fn settle_exactly(&self, time: f64, state: &mut [f64]) -> Result<(), Stopped> {
        let mut happened = 0;
        self.settle_relations((time, state), &[])?;
        self.let_go(time, state, |_| ())?;
        while let Some((index, trial)) = self.contradiction(time, state, |_| true, true)? {
            let event = || self.system.simulator().event(index).name.to_owned();
            if trial.moves || happened == self.most() {
                let cause = StopCause::Contradiction { event: event() };
                return Err(Stopped { time, cause });
            }
            state.copy_from_slice(&trial.state);
            self.count(index, time)?;
            self.settle_relations((time, state), &[])?;
            self.let_go(time, state, |_| ())?;
            happened += 1;
        }
        if self.system.is_sliding() {
            self.system.put_onto_surfaces(time, state)?;
        }
        self.take_sides_of_kinks((time, state), &[], |_| true);
        let guards = self.guards(time, state);
        let inner = &mut *self.inner.borrow_mut();
        inner.start.copy_from_slice(state);
        let events = self.system.simulator().events();
        for (index, side) in inner.sides.iter_mut().enumerate().take(events) {
            if self.is_armed(index, state) {
                let residual = self.residual(index, time, state, guards[index]);
                *side = Side::Fresh { passed: false, residual };
            }
        }
        Ok(())
    }

    /// Settles the state after events: events with guards beyond zero happen if they were not armed
    /// before, or if their guards have jumped. `before` are the guards before the events.
    pub(super) fn settle_after(
        &self,
        time: f64,
        state: &mut [f64],
        before: &[f64],
        passed: &mut [Passed],
    ) -> Result<(), Stopped> {
        // A guard that is beyond zero now was moved there by the events.
        let simulator = self.system.simulator();
        let is_new = |index: usize, side: &Side| {
            let is_near = !is_beyond(simulator.event(index).direction, before[index]);
            *side == Side::Idle || is_near && passed[index] == Passed::No
        };
        let sides = self.inner.borrow().sides.clone();
        let of_events = sides.iter().enumerate().take(simulator.events());
        let asked: Vec<bool> = of_events.map(|(index, side)| is_new(index, side)).collect();
        let mut happened = 0;
        let is_asked = |index: usize| asked[index];
        self.let_go(time, state, |index| passed[index] = Passed::Disarmed)?;
        // Relations alone begin no sticking, and may let prescribed speeds jump.
        if passed.iter().take(simulator.events()).any(|passed| *passed != Passed::No) {
            self.hold(time, state);
        }
        while let Some((index, trial)) = self.contradiction(time, state, is_asked, false)? {
            if happened == self.most() {
                let event = self.system.simulator().event(index).name.to_owned();
                return Err(Stopped { time, cause: StopCause::Contradiction { event } });
            }
            let surfaces = self.surfaces(time, state);
            state.copy_from_slice(&trial.state);
            self.leave_surfaces(surfaces, (time, state), 0.0);
            self.settle_relations((time, state), &[])?;
            passed[index] = Passed::Disarmed;
            self.count(index, time)?;
            self.let_go(time, state, |index| passed[index] = Passed::Disarmed)?;
            self.hold(time, state);
            happened += 1;
        }
        Ok(())
    }

    /// Lets the end of a mode that is first seen beyond zero count as crossed: no state beyond it
    /// belongs to the mode.
    pub(super) fn let_pass_at_start(&self, inner: &mut Inner) {
        for index in 0..self.system.simulator().events() {
            if let (Side::Fresh { passed: false, .. }, Outcome::Stays(Side::Known(side))) =
                (inner.sides[index], inner.outcomes[index])
                && is_beyond(self.direction(index), side)
                && self.sets_its_mode(index)
                && self.trial(index, inner.time, &inner.start).is_ok_and(|trial| trial.leaves)
            {
                inner.outcomes[index] = Outcome::Passes { time: inner.time, from: -side };
            }
        }
    }

    /// Returns whether a jump has left modes undetermined, so that events determine them at once.
    pub(super) fn is_undetermined(&self, time: f64, state: &[f64]) -> bool {
        let armed: Vec<usize> = {
            let sides = &self.inner.borrow().sides;
            let is_new = |index: &usize| {
                sides[*index] == Side::Idle
                    && self.sets_its_mode(*index)
                    && self.is_armed(*index, state)
            };
            (0..self.system.simulator().events()).filter(is_new).collect()
        };
        if armed.is_empty() {
            return false;
        }
        let guards = self.guards(time, state);
        armed.into_iter().any(|index| is_beyond(self.direction(index), guards[index]))
    }

    /// Returns whether some constraint holds in some modes only.
    fn holds_in_modes(&self) -> bool {
        self.system.constraints().is_some_and(Constraints::holds_in_modes)
    }

    /// Projects velocities onto the constraints of the state's modes. A part that has just begun to
    /// stick is at rest, except for the error of its time, which a guard of its sliding must not
    /// see. Friction whose speed has jumped does not stick: its force is finite.
    fn hold(&self, time: f64, state: &mut [f64]) {
        if !self.holds_in_modes() {
            return;
        }
        if let Some(constraints) = self.system.constraints() {
            let state = &mut state[..self.system.states()];
            let applied = self.inner.borrow().record.applied.clone();
            for mode in constraints.frictions_off(time, state, |entry| self.allowed(entry, state)) {
                self.system.reopen(mode, (time, &mut *state), &applied);
            }
            let mut held = state.to_vec();
            // A failure of the projection is reported once all events have happened.
            if constraints.put_back(Level::Velocities, time, &mut held).is_ok() {
                state.copy_from_slice(&held);
            }
        }
    }

    /// Returns the maximum number of events that may follow one another in no time.
    pub(super) fn most(&self) -> usize {
        2 * self.system.simulator().events() + 8
    }

    /// Returns the first event of some that contradicts the modes of a state, and its trial: an
    /// event that changes modes, or with `or_moves` other states alone.
    fn contradiction(
        &self,
        time: f64,
        state: &[f64],
        is_asked: impl Fn(usize) -> bool,
        or_moves: bool,
    ) -> Result<Option<(usize, Trial)>, Stopped> {
        let guards = self.guards(time, state);
        let events = self.system.simulator().events();
        for (index, guard) in guards.iter().enumerate().take(events) {
            let event = self.system.simulator().event(index);
            if !self.sets_its_mode(index)
                || !is_asked(index)
                || !self.is_armed(index, state)
                || !is_beyond(event.direction, *guard)
                || guard.abs() <= self.zero(index, time, state)
            {
                continue;
            }
            let trial = self.trial(index, time, state)?;
            if trial.leaves || or_moves && trial.moves {
                return Ok(Some((index, trial)));
            }
        }
        Ok(None)
    }

    /// Returns whether an event may change modes in which it is armed.
    pub(super) fn sets_its_mode(&self, index: usize) -> bool {
        let event = self.system.simulator().event(index);
        event.when.iter().any(|(entry, _)| event.sets.contains(entry))
    }

    pub(super) fn trial(&self, index: usize, time: f64, state: &[f64]) -> Result<Trial, Stopped> {
        let mut after = state.to_vec();
        self.apply(index, time, &mut after[..self.system.states()])?;
        let simulator = self.system.simulator();
        let moves = (0..self.system.states()).any(|entry| {
            let by = (after[entry] - state[entry]).abs();
            !simulator.is_mode(entry) && by > self.atol[entry] + self.rtol * state[entry].abs()
        });
        let leaves = !self.is_armed(index, &after);
        Ok(Trial { state: after, leaves, moves })
    }

    /// Returns the tolerance for zero of a guard when it becomes armed: a guard beyond zero by less
    /// than the tolerances counts as zero.
    pub(super) fn residual(&self, index: usize, time: f64, state: &[f64], guard: f64) -> f64 {
        let direction = self.direction(index);
        if is_beyond(direction, guard) { self.blur(index, time, state) } else { 0.0 }
    }

    /// Returns the tolerance for zero of a guard at events, from the tolerances of the run and the
    /// rounding of time.
    pub(super) fn zero(&self, index: usize, time: f64, state: &[f64]) -> f64 {
        let (_, rate) = self.guard_at(time, state, index);
        let by_time = by_rounding(time, rate);
        let blur = self.blur(index, time, state);
        if by_time > blur { by_time } else { blur }
    }

    /// Returns the change of a guard within the tolerances of the steps, as the sum over the errors
    /// of all states.
    pub(crate) fn blur(&self, index: usize, time: f64, state: &[f64]) -> f64 {
        let guard = self.guards(time, state)[index];
        let mut shifted = state.to_vec();
        let mut blur = 0.0;
        for entry in 0..self.system.states() {
            if self.system.simulator().is_mode(entry) {
                continue;
            }
            shifted[entry] += self.allowed(entry, state);
            blur += (self.guards(time, &shifted)[index] - guard).abs();
            shifted[entry] = state[entry];
        }
        blur
    }

    fn allowed(&self, entry: usize, state: &[f64]) -> f64 {
        self.tightness.get() * (self.atol[entry] + self.rtol * state[entry].abs())
    }
}

/// Returns whether a guard is on the far side of zero, on which its event has happened.
pub(in crate::method) fn is_beyond(direction: Direction, guard: f64) -> bool {
    match direction {
        Direction::Rising => guard > 0.0,
        Direction::Falling => guard < 0.0,
        Direction::Both => false,
    }
}
