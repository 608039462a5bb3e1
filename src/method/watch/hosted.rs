//! Guards of a run that somebody else steps, or cuts into pieces.
//!
//! A run in pieces is watched as any other; what is known of guards is kept from piece to
//! piece. Who steps a run himself sees an indicator for each guard, and has to stop where one
//! changes its sign. Then, and after each of his steps, guards are looked at:
//!
//! - A guard that is on the other side of zero has passed, and its event happens.
//! - A guard that has only now passed is at zero but for rounding. Its indicator is moved by
//!   some of that to the side it leaves to, so that it changes its sign where the guard comes
//!   back, however soon; once the guard is clear of zero, its indicator is the guard itself.
//! - A guard at rest at zero has an indicator that is moved to the near side.

use std::collections::VecDeque;

use machinist_contract::{Direction, Simulator};
use serde::{Deserialize, Serialize};

use super::passing::{AT_REST, guards_at, is_wanted};
use super::settle::is_beyond;
use super::{Problem, Side, Stopped, Switch, Watch};
use crate::error::StopCause;

/// Of what a guard compares, at the states' typical sizes: no more of it is zero.
const ROUNDINGS: f64 = 64.0;

/// What is known of guards between the pieces of a run.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Memory {
    sides: Vec<Side>,
    /// By how much indicators are moved to the side their guards are on.
    slack: Vec<f64>,
    latest: VecDeque<f64>,
    happening: Option<(f64, Vec<usize>)>,
    /// The largest value that each guard has had: its rounding is that of what it compares.
    sizes: Vec<f64>,
}

impl Memory {
    /// Whether it is one of runs of a simulator.
    pub(crate) fn fits(&self, simulator: &dyn Simulator<f64>) -> bool {
        let count = simulator.events() + simulator.kinks();
        let happening = self.happening.iter().flat_map(|(_, guards)| guards);
        [self.sides.len(), self.slack.len(), self.sizes.len()] == [count; 3]
            && happening.into_iter().all(|guard| *guard < count)
    }

    /// Whether events have been found that have not happened yet.
    pub(crate) fn is_halted(&self) -> bool {
        self.happening.is_some()
    }

    /// Whether the event or the kink of an indicator is watched for, so that it is its guard.
    pub(crate) fn is_watched(&self, index: usize) -> bool {
        self.sides.get(index).is_some_and(|side| *side != Side::Idle)
    }

    /// What changes its sign where a guard has to be looked at, for each event and each kink.
    pub(crate) fn indicators(
        &self,
        (simulator, parameters): (&dyn Simulator<f64>, &[f64]),
        (time, state): (f64, &[f64]),
        values: &mut [f64],
    ) {
        let events = simulator.events();
        guards_at((simulator, parameters), events, time, state, values);
        for (index, value) in values.iter_mut().enumerate() {
            match self.sides[index] {
                // Of an event that is not watched for, whatever the guard does.
                Side::Idle => *value = 1.0,
                Side::Known(side) | Side::Jumped(side) => *value += side * self.slack[index],
                Side::Fresh { residual, .. } if index < events => {
                    *value += match simulator.event(index).direction {
                        Direction::Rising => -residual,
                        Direction::Falling => residual,
                        Direction::Both => 0.0,
                    };
                }
                Side::Fresh { .. } => {}
            }
        }
    }
}

impl<'a> Watch<'a> {
    /// The watch over the next piece of a run; nothing if there is nothing to watch.
    pub(crate) fn resume(problem: &'a Problem<'a>, memory: &Memory) -> Option<Self> {
        let (sides, latest) = (memory.sides.clone(), memory.latest.clone());
        if sides.is_empty() {
            return None;
        }
        let watch = Self::with(problem, sides, latest, &problem.initial);
        watch.inner.borrow_mut().parts.sizes_mut().clone_from(&memory.sizes);
        Some(watch)
    }

    /// What the next piece of a run has to know.
    pub(crate) fn into_memory(self) -> Memory {
        let mut inner = self.inner.into_inner();
        let sizes = std::mem::take(inner.parts.sizes_mut());
        let (sides, latest, happening) = (inner.sides, inner.latest, inner.happening);
        let slack = vec![0.0; sides.len()];
        Memory { sides, slack, latest, happening, sizes }
    }

    /// The time at which events have been found that have not happened yet.
    pub(crate) fn has_halted(&self) -> Option<f64> {
        self.inner.borrow().happening.as_ref().map(|(time, _)| *time)
    }

    /// Looks at guards after a step of somebody else's; whether events have to happen, of which
    /// nothing is done.
    pub(crate) fn look(&self, memory: &mut Memory, time: f64, state: &[f64]) -> bool {
        let passed = self.passed(memory, time, state);
        memory.sides.clone_from(&self.inner.borrow().sides);
        !passed.is_empty()
    }

    /// Lets happen what a piece of a run has found at its end. The state is then on the
    /// constraints.
    pub(crate) fn go_through(
        self,
        memory: &mut Memory,
        time: f64,
        state: &mut [f64],
    ) -> Result<Vec<Switch>, Stopped> {
        self.inner.borrow_mut().happening = memory.happening.take();
        if self.switch(state)?.is_some() {
            self.system.constrain(time, state)?;
        }
        let switches = std::mem::take(&mut self.inner.borrow_mut().switches);
        *memory = self.into_memory();
        Ok(switches)
    }

    /// Lets happen what guards say of a state to which somebody else has stepped, until nothing
    /// more follows of it at this time. The state is then on the constraints.
    pub(crate) fn happen(
        &self,
        memory: &mut Memory,
        time: f64,
        state: &mut [f64],
    ) -> Result<(), Stopped> {
        let found = self.passed(memory, time, state);
        self.follow(found, memory, time, state)
    }

    /// Lets events happen and what follows of them.
    fn follow(
        &self,
        mut found: Vec<usize>,
        memory: &mut Memory,
        time: f64,
        state: &mut [f64],
    ) -> Result<(), Stopped> {
        for _ in 0..=self.most() {
            if found.is_empty() {
                found = self.passed(memory, time, state);
            }
            if found.is_empty() {
                memory.sides.clone_from(&self.inner.borrow().sides);
                memory.latest.clone_from(&self.inner.borrow().latest);
                return Ok(());
            }
            self.inner.borrow_mut().happening = Some((time, found));
            self.switch(state)?;
            self.system.constrain(time, state)?;
            found = self.leave_zero(memory, time, state);
        }
        let latest = self.inner.borrow().switches.last().map(|switch| switch.event.clone());
        let cause = StopCause::Contradiction { event: latest.unwrap_or_default() };
        Err(Stopped { time, cause })
    }

    /// At the start of a run that somebody else steps: sees to which side guards leave that are
    /// at zero.
    pub(crate) fn set_out(&self, time: f64, state: &mut [f64]) -> Result<Memory, Stopped> {
        let sides = self.inner.borrow().sides.clone();
        let [slack, sizes] = [(); 2].map(|()| vec![0.0; sides.len()]);
        let mut memory = Memory { sides, slack, sizes, ..Memory::default() };
        let found = self.leave_zero(&mut memory, time, state);
        self.follow(found, &mut memory, time, state)?;
        Ok(memory)
    }

    /// Events whose guards have passed since they were last looked at.
    fn passed(&self, memory: &mut Memory, time: f64, state: &[f64]) -> Vec<usize> {
        let events = self.system.simulator().events();
        let inner = &mut *self.inner.borrow_mut();
        let mut passed = Vec::new();
        for index in 0..inner.sides.len() {
            let (guard, rate) = inner.parts.at(self.system, time, state, index);
            let direction = self.direction(index);
            let slack = &mut memory.slack[index];
            let (from, is_wanted) = match inner.sides[index] {
                Side::Idle => continue,
                Side::Known(side) | Side::Jumped(side) => {
                    let shown = side * guard + *slack;
                    let is_beyond = shown < 0.0 || shown == 0.0 && side * rate < 0.0;
                    if !is_beyond {
                        if side * guard > *slack {
                            *slack = 0.0;
                        }
                        continue;
                    }
                    (side, is_wanted(direction, side))
                }
                Side::Fresh { residual, .. } => {
                    if guard.abs() <= residual || guard == 0.0 {
                        continue;
                    }
                    let from = -guard.signum();
                    (from, direction != Direction::Both && is_wanted(direction, from))
                }
            };
            if is_wanted && index < events {
                passed.push(index);
            } else {
                inner.sides[index] = Side::Known(-from);
                *slack = 0.0;
            }
        }
        passed
    }

    /// Sees to which side guards leave that have just passed zero or begin at it; gives events
    /// of those that leave it to the far side without having just passed.
    fn leave_zero(&self, memory: &mut Memory, time: f64, state: &[f64]) -> Vec<usize> {
        let mut found = Vec::new();
        let count = memory.sides.len();
        for index in 0..count {
            let Side::Fresh { passed, residual } = self.inner.borrow().sides[index] else {
                continue;
            };
            memory.slack[index] = 0.0;
            let (guard, rate) = self.guard_at(time, state, index);
            let blur = self.blur(index, time, state);
            let size = blur / self.rtol;
            let rounding = ROUNDINGS * f64::EPSILON * size;
            let zero = residual.max(16.0 * f64::EPSILON * time.abs() * rate.abs()).max(rounding);
            let direction = self.direction(index);
            if guard.abs() > if is_beyond(direction, guard) { zero.max(blur) } else { zero } {
                self.inner.borrow_mut().sides[index] = Side::Known(guard.signum());
                continue;
            }
            if rate == 0.0 || rate.abs() * self.span <= AT_REST * size {
                // Whatever holds it there, who steps the run lets it drift within tolerances.
                let residual = residual.max(blur);
                self.inner.borrow_mut().sides[index] = Side::Fresh { passed, residual };
                continue;
            }
            let seen = rate.signum();
            let is_event = index < self.system.simulator().events();
            if is_event && !passed && direction != Direction::Both && is_wanted(direction, -seen) {
                found.push(index);
            } else {
                self.inner.borrow_mut().sides[index] = Side::Known(seen);
                // No more than it takes: it adds up over bounces that become ever shorter.
                let beyond = (-seen * guard).max(0.0);
                memory.slack[index] = 1.001 * beyond + 16.0 * f64::EPSILON * size;
            }
        }
        found
    }
}
