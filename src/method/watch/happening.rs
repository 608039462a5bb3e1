//! Changes where guards cross zero: relations take other sides, events are applied, and runs with
//! endless ones stop.

use machinist_contract::Direction;

use super::passing::{Outcome, is_wanted};
use super::settle::is_beyond;
use super::{ENDLESS, EventRecord, NO_TIME, Passed, ROUNDINGS, Side, Watch, by_rounding};
use crate::error::StopCause;
use crate::method::{Stopped, Stretch};
use crate::trajectory::Switch;

impl Watch<'_> {
    /// Ends the step at `time` for the crossings found, in state `end`.
    pub(in crate::method) fn happens(&self, time: f64, first: f64, end: &[f64]) {
        let inner = &mut *self.inner.borrow_mut();
        let near = ROUNDINGS * f64::EPSILON * time.abs().max(inner.time.abs());
        let mut happening = Vec::new();
        let guards = inner.parts.all_at(self.system, time, end);
        inner.parts.note_arcs(time, &guards);
        for (index, (outcome, (guard, rate))) in inner.outcomes.iter().zip(guards).enumerate() {
            match *outcome {
                Outcome::Passes { time: passing, from } if passing <= first + near => {
                    // It may have crossed the other way within the step.
                    if let side @ Side::Known(_) = &mut inner.sides[index] {
                        *side = Side::Known(from);
                    }
                    happening.push(index);
                }
                Outcome::Passes { from, .. } if inner.sides[index] != Side::Known(from) => {
                    // Either it crossed in the direction without an event, or it crosses now.
                    let zero = inner.parts.rounding(index).max(near * rate.abs());
                    inner.sides[index] = if guard.abs() > zero {
                        Side::Known(guard.signum())
                    } else {
                        Side::Fresh { passed: true, residual: guard.abs() }
                    };
                }
                Outcome::Passes { from, .. } => {
                    let residual = inner.zeros[index].map_or(0.0, |zero| zero.residual);
                    if (guard - residual) * from < 0.0 {
                        happening.push(index);
                    } else {
                        inner.sides[index] = Side::Known(from);
                    }
                }
                Outcome::Stays(end @ Side::Known(_))
                    if !self.is_kink(index)
                        && guard.abs() > inner.parts.rounding(index)
                        && time > inner.time =>
                {
                    let side = Side::Known(guard.signum());
                    let start = inner.sides[index];
                    // An event that did not cross is beyond zero only by rounding, as speeds of
                    // parts at rest are. One that crossed at the start has gone on.
                    let has_gone_on = matches!(start, Side::Fresh { passed: true, residual } if guard.abs() > residual);
                    if !is_beyond(self.direction(index), guard)
                        || has_gone_on
                        || [start, end].contains(&side)
                    {
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

    /// Returns whether only relations change or borders are crossed.
    pub(in crate::method) fn is_of_kinks(&self) -> bool {
        let inner = self.inner.borrow();
        let happening = inner.happening.as_ref().map(|(_, guards)| &guards[..]);
        happening.is_some_and(|guards| {
            !guards.is_empty() && guards.iter().all(|index| self.is_kink(*index))
        })
    }

    /// Applies the events for which the method stopped to `state`, in the order of the spec. Each
    /// event happens only if it is still armed. Returns the time.
    ///
    /// # Errors
    /// Returns an error if a new value is not finite, or if events do not end.
    pub(in crate::method) fn switch(&self, state: &mut [f64]) -> Result<Option<f64>, Stopped> {
        let Some((time, mut events)) = self.inner.borrow_mut().happening.take() else {
            return Ok(None);
        };
        let states = self.system.states();
        self.inner.borrow_mut().record = EventRecord::default();
        self.keep_front(time, state);
        let guards_before = self.guards(time, state);
        let kinks_before = self.system.kink_guards(time, state);
        let mut passed = vec![Passed::No; guards_before.len()];
        let leapt: Vec<bool> =
            (0..passed.len()).map(|index| self.has_leapt(index, time, state)).collect();
        // Guards that crossed and whose event turned them back.
        let mut turned_back: Vec<usize> = (0..passed.len())
            .filter(|index| self.has_passed(*index) && !self.is_approached(*index, time, state))
            .collect();
        let kinks: Vec<usize> =
            events.iter().copied().filter(|index| self.is_kink(*index)).collect();
        for index in &kinks {
            passed[*index] = Passed::GoesOn;
        }
        self.change_relations((time, &mut *state), &kinks)?;
        let jumped = self.jumped_over_zero((time, state), &guards_before, &events);
        events.extend(&jumped);
        events.sort_unstable();
        for index in events {
            if !self.is_kink(index) && self.is_armed(index, state) {
                self.require_resolved(index, time)?;
                let surfaces = self.surfaces(time, state);
                self.apply(index, time, &mut state[..states])?;
                self.leave_surfaces(surfaces, (time, state), 0.0);
                self.settle_relations((time, state), &[])?;
                passed[index] =
                    if self.is_armed(index, state) { Passed::GoesOn } else { Passed::Disarmed };
                self.count(index, time)?;
                if !self.is_approached(index, time, state) {
                    turned_back.push(index);
                }
            }
        }
        let all = passed.iter().enumerate().filter(|(_, passed)| **passed != Passed::No);
        self.inner.borrow_mut().record.passed = all.map(|(index, _)| index).collect();
        self.settle_after(time, state, &guards_before, &mut passed)?;
        self.settle_relations((time, state), &[])?;
        let guards = self.guards(time, state);
        // What crossed zero and was then moved by a relation is on the side where it is now.
        let is_same = |index: &usize| guards[*index].to_bits() == guards_before[*index].to_bits();
        let kinks_after = self.system.kink_guards(time, state);
        let stays = |index: usize| match self.watched[index].kink() {
            Some(_) if self.watched[index].is_border() => is_same(&index),
            Some((kink, _)) => {
                let moved = (kinks_after[kink] - kinks_before[kink]).abs();
                moved == 0.0 || moved <= self.rounding_at(kink, time, state)
            }
            None => true,
        };
        let crossed: Vec<usize> = kinks.iter().copied().filter(|index| stays(*index)).collect();
        self.take_sides_of_kinks((time, state), &crossed, |index| !is_same(&index));
        let fresh = |index: usize| {
            let residual = self.residual(index, time, state, guards[index]);
            Side::Fresh { passed: false, residual }
        };
        // A guard that other events move towards zero crosses again, as for a ball that is hit from
        // both sides.
        turned_back.retain(|index| self.is_approached(*index, time, state));
        let again = turned_back;
        let inner = &mut *self.inner.borrow_mut();
        inner.turn = None;
        let events = self.system.simulator().events();
        for (index, side) in inner.sides.iter_mut().enumerate().take(events) {
            let was_watched = *side != Side::Idle;
            let is_same = is_same(&index);
            if !self.is_armed(index, state) {
                *side = Side::Idle;
            } else if jumped.contains(&index) && guards[index] != 0.0
                || passed[index] == Passed::GoesOn && is_same && leapt[index]
            {
                // Not near zero: an event moved the guard there, or the guard is as steep as a
                // jump.
                *side = Side::Known(guards[index].signum());
            } else if passed[index] == Passed::GoesOn
                || passed[index] == Passed::No && again.contains(&index)
            {
                let residual = 4.0 * guards_before[index].abs();
                *side = Side::Fresh { passed: !again.contains(&index), residual };
            } else if passed[index] == Passed::Disarmed || !(was_watched && is_same) {
                // A guard at zero that relations turn crosses there, also without a direction.
                let is_zero = |guard: f64| guard.abs() <= inner.parts.rounding(index);
                let stays = passed[index] == Passed::No
                    && matches!(side, Side::Known(_))
                    && self.direction(index) == Direction::Both
                    && is_zero(guards[index])
                    && is_zero(guards_before[index]);
                if !stays {
                    *side = fresh(index);
                }
            } else if guards[index] == 0.0
                && matches!(side, Side::Known(_))
                && self.direction(index) != Direction::Both
            {
                // Zero on the branch that relations took. One whose event has happened at this
                // instant is known to have crossed.
                *side = Side::Fresh { passed: false, residual: 0.0 };
            }
        }
        Ok(Some(time))
    }

    /// Changes relations whose guards cross zero.
    pub(super) fn change_relations(
        &self,
        (time, state): (f64, &mut [f64]),
        kinks: &[usize],
    ) -> Result<(), Stopped> {
        let mut changes: Vec<_> = kinks.iter().filter_map(|index| self.change_at(*index)).collect();
        if self.hold_flat(time, state, &changes)? {
            changes.clear();
        }
        self.settle_relations((time, state), &changes)?;
        if self.system.is_sliding() {
            self.system.put_onto_surfaces(time, state)?;
        }
        self.count_changes(time, changes.len())
    }

    /// Settles relations after velocities jumped; at guards in `thrown_back` the motion stays on
    /// its side.
    ///
    /// # Errors
    /// As [`Watch::switch`].
    pub(in crate::method) fn settle_after_impulses(
        &self,
        time: f64,
        (before, state): (&[f64], &[f64]),
        thrown_back: &[usize],
    ) -> Result<(), Stopped> {
        self.leave_surfaces(self.surfaces(time, before), (time, state), 0.0);
        self.settle_relations((time, state), &[])?;
        let passed = self.inner.borrow().record.passed.clone();
        let is_settled = |index: &usize| {
            self.is_kink(*index)
                && (!self.watched[*index].is_border() || thrown_back.contains(index))
        };
        let passed: Vec<usize> = passed.into_iter().filter(is_settled).collect();
        self.take_sides_of_kinks((time, state), &passed, |_| true);
        Ok(())
    }

    /// Returns the events whose guards cross zero in their direction because relations changed.
    pub(super) fn jumped_over_zero(
        &self,
        (time, state): (f64, &[f64]),
        before: &[f64],
        passed: &[usize],
    ) -> Vec<usize> {
        if self.system.simulator().relations() == 0 {
            return Vec::new();
        }
        let after = self.guards(time, state);
        let mut jumped = Vec::new();
        for index in 0..self.system.simulator().events() {
            if after[index].to_bits() == before[index].to_bits() || passed.contains(&index) {
                continue;
            }
            let rounding = self.rounding_of(index);
            let known = self.inner.borrow().sides[index];
            let (side, zero) = match known {
                Side::Known(side) => (side, rounding),
                // A guard that rests at zero leaves it to the far side, as where it does not jump.
                Side::Fresh { passed: false, .. }
                    if self.direction(index) != Direction::Both
                        && before[index].abs() <= rounding =>
                {
                    (-after[index].signum(), self.zero(index, time, state).max(rounding))
                }
                _ => continue,
            };
            if side * after[index] < 0.0 && after[index].abs() > zero {
                if is_wanted(self.direction(index), side) {
                    jumped.push(index);
                } else {
                    self.inner.borrow_mut().sides[index] = Side::Known(-side);
                }
            }
        }
        jumped
    }

    /// Settles relations after a jump in time.
    pub(in crate::method) fn jump_in_time(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
    ) -> Result<(), Stopped> {
        let front = self.inner.borrow_mut().parts.all_at(self.system, stretch.from, state);
        self.inner.borrow_mut().parts.ends = (stretch.from, stretch.until);
        self.settle_at_jump(stretch.within(stretch.from), state)?;
        self.note_touched(stretch.from, state, &front);
        Ok(())
    }

    /// Finds the guards of events that are zero at a known time and do not cross it: they turn
    /// there, as `abs(t - t0)`, or stay, as `max(t0 - t, 0)`. `front` are guards and rates before.
    fn note_touched(&self, time: f64, state: &[f64], front: &[(f64, f64)]) {
        let inner = &mut *self.inner.borrow_mut();
        let behind = inner.parts.all_at(self.system, time, state);
        for index in 0..self.system.simulator().events() {
            let Side::Known(side) = inner.sides[index] else { continue };
            let (rounding, direction) = (inner.parts.rounding(index), self.direction(index));
            let is_zero =
                |(guard, rate): (f64, f64)| guard.abs() <= rounding.max(by_rounding(time, rate));
            let (came, goes) = (side * front[index].1, side * behind[index].1);
            if is_zero(front[index]) && is_zero(behind[index]) && came < 0.0 && goes >= 0.0 {
                if is_wanted(direction, side) {
                    inner.touched.push((index, side));
                } else if goes > 0.0 {
                    inner.touched.push((index, -side));
                }
            }
        }
    }

    /// Settles relations just behind a jump in time.
    pub(super) fn settle_at_jump(&self, time: f64, state: &mut [f64]) -> Result<(), Stopped> {
        if self.system.simulator().relations() == 0 {
            return Ok(());
        }
        self.settle_relations((time, state), &[])?;
        if self.system.is_sliding() {
            self.system.put_onto_surfaces(time, state)?;
        }
        self.take_sides_of_kinks((time, state), &[], |_| true);
        Ok(())
    }

    /// Applies the new values of an event.
    pub(super) fn apply(&self, index: usize, time: f64, state: &mut [f64]) -> Result<(), Stopped> {
        let simulator = self.system.simulator();
        for (entry, value) in self.system.new_values(index, time, state) {
            if !value.is_finite() {
                let what = format!(
                    "the new value of `{}` at event `{}`",
                    self.system.name(entry),
                    simulator.event(index).name
                );
                return Err(Stopped { time, cause: StopCause::not_finite(what) });
            }
            state[entry] = if simulator.is_mode(entry) { value.round() } else { value };
        }
        Ok(())
    }

    /// Counts an event and stops a run with infinitely many.
    pub(super) fn count(&self, index: usize, time: f64) -> Result<(), Stopped> {
        let event = self.system.simulator().event(index).name.to_owned();
        self.system.count(|work| work.switches += 1);
        self.inner.borrow_mut().record.applied.push(index);
        self.count_one(time, &event)?;
        self.inner.borrow_mut().switches.push(Switch::new(time, &event));
        Ok(())
    }

    /// Counts changes of relations and stops a run with infinitely many.
    pub(super) fn count_changes(&self, time: f64, count: usize) -> Result<(), Stopped> {
        (0..count).try_for_each(|_| self.count_one(time, "a comparison of the spec"))
    }

    /// Stops a run in which rounding alone decides when an event happens.
    pub(super) fn require_resolved(&self, index: usize, time: f64) -> Result<(), Stopped> {
        let inner = &mut *self.inner.borrow_mut();
        let excursion = inner.parts.take_excursion(index);
        let is_resolved = excursion > inner.parts.rounding(index);
        let count = &mut inner.unresolved[index];
        *count = if is_resolved { 0 } else { *count + 1 };
        if *count < ENDLESS {
            return Ok(());
        }
        let event = self.system.simulator().event(index).name.to_owned();
        Err(Stopped { time, cause: StopCause::Zeno { event, count: ENDLESS } })
    }

    pub(super) fn count_one(&self, time: f64, event: &str) -> Result<(), Stopped> {
        let inner = &mut *self.inner.borrow_mut();
        inner.latest.push_back(time);
        // Many parts may begin at the same time.
        let endless = ENDLESS.max(self.most() + 2 * self.system.simulator().relations());
        if inner.latest.len() > endless {
            let earliest = inner.latest.pop_front().unwrap_or(time);
            if time - earliest <= NO_TIME * self.span.max(time.abs()) {
                let event = event.to_owned();
                return Err(Stopped { time, cause: StopCause::Zeno { event, count: endless } });
            }
        }
        Ok(())
    }
}
