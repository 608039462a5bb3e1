//! Guards of a run that a host steps or cuts into pieces.
//!
//! A run in pieces is watched like any other; the state of the guards is kept from piece to piece.
//! A host that steps a run itself receives an indicator for each guard, and has to stop where an
//! indicator changes its sign. There, and after each step of the host, the guards are evaluated:
//!
//! - A guard on the other side of zero has crossed, and its event happens.
//! - A guard that has just crossed is zero but for rounding. Its indicator is shifted to the side
//!   to which the guard leaves, so that the sign changes when the guard returns. Once the guard is
//!   clear of zero, the indicator is the guard itself.
//! - A guard that rests at zero has an indicator shifted to the near side.

use std::collections::VecDeque;

use machinist_contract::{Direction, RelationKind, Simulator};
use serde::{Deserialize, Serialize};

use super::passing::{AT_REST, Zero, is_wanted};
use super::settle::is_beyond;
use super::{Problem, ROUNDINGS, Side, Stopped, Switch, System, Watch, Watched};
use crate::error::StopCause;
use crate::method::sliding::{Order, Sides, Slide};

/// State of the guards between two pieces of a run.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Memory {
    sides: Vec<Side>,
    /// Shift of each indicator towards the side of its guard.
    slack: Vec<f64>,
    latest: VecDeque<f64>,
    happening: Option<(f64, Vec<usize>)>,
    /// Largest value of each guard, which determines its rounding error.
    sizes: Vec<f64>,
    /// Slots of the relations.
    slots: Vec<f64>,
    /// Relations along whose surfaces the motion slides; true if by the second derivative.
    slides: Vec<(usize, bool)>,
    /// Guards that were zero but for rounding at the last change.
    zeros: Vec<Option<Zero>>,
}

impl Memory {
    /// Returns whether this is the memory of a run of a simulator.
    pub(crate) fn fits(&self, simulator: &dyn Simulator<f64>) -> bool {
        let count = Watched::all(simulator).len();
        let happening = self.happening.iter().flat_map(|(_, guards)| guards);
        let counts = [self.sides.len(), self.slack.len(), self.sizes.len(), self.zeros.len()];
        counts == [count; 4]
            && happening.into_iter().all(|guard| *guard < count)
            && (count == 0 || self.slots.len() == simulator.relations())
            && self.slides.iter().all(|(relation, _)| *relation < simulator.relations())
    }

    /// Returns the parameters with the slots of the relations as held.
    pub(crate) fn parameters(&self, parameters: &[f64]) -> Vec<f64> {
        [parameters, &self.slots].concat()
    }

    /// Returns whether events have been found that have not happened yet.
    pub(crate) fn is_halted(&self) -> bool {
        self.happening.is_some()
    }

    /// Returns whether the motion slides along a surface.
    pub(crate) fn is_sliding(&self) -> bool {
        !self.slides.is_empty()
    }

    /// Makes a system hold the relations of the run.
    pub(crate) fn hold(&self, system: &System<'_>) {
        system.held().set_all(&self.slots);
        let order = |is_second: bool| if is_second { Order::Second } else { Order::First };
        let slides = self.slides.iter();
        let slides = slides.map(|&(relation, second)| {
            let sides = Sides::above_slot(self.slots[relation]);
            Slide { relation, sides, order: order(second) }
        });
        system.slide(&slides.collect::<Vec<_>>());
    }

    /// Returns the derivative of the indicator of a kink by its guard.
    pub(crate) fn slope(&self, simulator: &dyn Simulator<f64>, kink: usize, guard: f64) -> f64 {
        let is_whole =
            kink < simulator.relations() && simulator.relation(kink).kind == RelationKind::Whole;
        // (a - n) (n + 1 - a)
        if is_whole { 2.0 * self.slots[kink] + 1.0 - 2.0 * guard } else { 1.0 }
    }

    /// Returns whether the event or kink of an indicator is watched, so that the indicator is its
    /// guard.
    pub(crate) fn is_watched(&self, simulator: &dyn Simulator<f64>, index: usize) -> bool {
        let events = simulator.events();
        let of = |watched: &Watched| match watched {
            Watched::Event(event) => *event == index,
            other => other.kink().is_some_and(|(kink, _)| events + kink == index),
        };
        let places = Watched::all(simulator).into_iter().enumerate();
        let mut places = places.filter(|(_, watched)| of(watched)).map(|(place, _)| place);
        places.any(|place| self.sides.get(place).is_some_and(|side| *side != Side::Idle))
    }

    /// Computes the indicators of all events and kinks. An indicator changes its sign where its
    /// guard has to be evaluated.
    pub(crate) fn indicators(
        &self,
        (simulator, parameters): (&dyn Simulator<f64>, &[f64]),
        (time, state): (f64, &[f64]),
        values: &mut [f64],
    ) {
        let events = simulator.events();
        let parameters = self.parameters(parameters);
        let (guards, kinks) = values.split_at_mut(events);
        if !guards.is_empty() {
            simulator.guards(time, state, &parameters, guards);
        }
        if !kinks.is_empty() {
            simulator.kink_guards(time, state, &parameters, kinks);
        }
        let mut whole = 1.0;
        for (place, watched) in Watched::all(simulator).into_iter().enumerate() {
            let (side, slack) = (self.sides[place], self.slack[place]);
            match watched {
                Watched::Event(event) => {
                    values[event] =
                        shown(values[event], side, slack, simulator.event(event).direction);
                }
                Watched::Branch(index) | Watched::Border(index) | Watched::Zone(index) => {
                    let value = &mut values[events + index];
                    *value = shown(*value, side, slack, Direction::Both);
                }
                // For integers, the product of the distances to both ends: positive between them.
                Watched::Low(index) => whole = values[events + index] - self.slots[index] + slack,
                Watched::High(index) => {
                    let above = 1.0 + self.slots[index] - values[events + index] + slack;
                    values[events + index] = if side == Side::Idle { 1.0 } else { whole * above };
                }
                Watched::FromBelow(_) | Watched::FromAbove(_) | Watched::Nearest(_) => {}
            }
        }
    }
}

/// Returns the indicator of a guard.
fn shown(guard: f64, side: Side, slack: f64, direction: Direction) -> f64 {
    match side {
        // The event is not armed, whatever its guard does.
        Side::Idle => 1.0,
        Side::Known(side) => guard + side * slack,
        Side::Fresh { residual, .. } => match direction {
            Direction::Rising => guard - residual,
            Direction::Falling => guard + residual,
            Direction::Both => guard,
        },
    }
}

impl<'a> Watch<'a> {
    /// Returns the watch over the next piece of a run; `None` if there is nothing to watch.
    pub(crate) fn resume(problem: &'a Problem<'a>, memory: &Memory) -> Option<Self> {
        let (sides, latest) = (memory.sides.clone(), memory.latest.clone());
        if sides.is_empty() {
            return None;
        }
        let watch = Self::with(problem, sides, latest, &problem.initial);
        watch.inner.borrow_mut().parts.sizes_mut().clone_from(&memory.sizes);
        watch.inner.borrow_mut().zeros.clone_from(&memory.zeros);
        memory.hold(problem.system);
        watch.find_active(&problem.initial);
        Some(watch)
    }

    /// Returns the memory for the next piece of a run.
    pub(crate) fn into_memory(self) -> Memory {
        let (slots, slides) = self.slots_and_slides();
        let mut inner = self.inner.into_inner();
        let sizes = std::mem::take(inner.parts.sizes_mut());
        let (sides, zeros) = (inner.sides, inner.zeros);
        let (latest, happening) = (inner.latest, inner.happening);
        let slack = vec![0.0; sides.len()];
        Memory { sides, slack, latest, happening, sizes, slots, slides, zeros }
    }

    /// Returns the slots and the surfaces along which the motion slides.
    fn slots_and_slides(&self) -> (Vec<f64>, Vec<(usize, bool)>) {
        let slides = self.system.slides().into_iter();
        let slides = slides.map(|slide| (slide.relation, slide.order == Order::Second));
        (self.system.held().slots(), slides.collect())
    }

    /// Returns the time of events that have been found and have not happened yet.
    pub(crate) fn has_halted(&self) -> Option<f64> {
        self.inner.borrow().happening.as_ref().map(|(time, _)| *time)
    }

    /// Evaluates guards after a step of the host. Returns whether events have to happen, without
    /// applying them.
    pub(crate) fn look(&self, memory: &mut Memory, time: f64, state: &[f64]) -> bool {
        let passed = self.passed(memory, time, state);
        memory.sides.clone_from(&self.inner.borrow().sides);
        !passed.is_empty()
    }

    /// Applies the events found at the end of a piece of a run. The state is then on the
    /// constraints.
    pub(crate) fn go_through(
        self,
        problem: &Problem<'_>,
        memory: &mut Memory,
        time: f64,
        state: &mut [f64],
    ) -> Result<Vec<Switch>, Stopped> {
        let left = || self.is_undetermined(time, state).then(|| (time, Vec::new()));
        let happening = memory.happening.take().or_else(left);
        self.inner.borrow_mut().happening = happening;
        problem.apply(&self, state)?;
        let switches = self.take_switches();
        *memory = self.into_memory();
        Ok(switches)
    }

    /// Applies the events at a state to which the host has stepped, until no more events follow at
    /// this time. Relations that jump with time change first. The state is then on the constraints.
    pub(crate) fn happen(
        &self,
        problem: &Problem<'_>,
        memory: &mut Memory,
        (time, is_jump): (f64, bool),
        state: &mut [f64],
    ) -> Result<(), Stopped> {
        self.leave_distant_surfaces(time, state);
        if is_jump {
            self.settle_at_jump(time, state)?;
        }
        let found = self.passed(memory, time, state);
        self.follow(problem, found, memory, (time, state))
    }

    /// Applies events and those that follow from them.
    fn follow(
        &self,
        problem: &Problem<'_>,
        mut found: Vec<usize>,
        memory: &mut Memory,
        (time, state): (f64, &mut [f64]),
    ) -> Result<(), Stopped> {
        for _ in 0..=self.most() {
            if found.is_empty() {
                found = self.passed(memory, time, state);
            }
            if found.is_empty() && !self.is_undetermined(time, state) {
                memory.sides.clone_from(&self.inner.borrow().sides);
                memory.zeros.clone_from(&self.inner.borrow().zeros);
                memory.latest.clone_from(&self.inner.borrow().latest);
                (memory.slots, memory.slides) = self.slots_and_slides();
                return Ok(());
            }
            self.inner.borrow_mut().happening = Some((time, found));
            problem.apply(self, state)?;
            found = self.leave_zero(memory, time, state);
        }
        let latest = self.inner.borrow().switches.last().map(|switch| switch.event.clone());
        let cause = StopCause::Contradiction { event: latest.unwrap_or_default() };
        Err(Stopped { time, cause })
    }

    /// Determines the sides of guards that are zero at the start of a run of a host.
    pub(crate) fn set_out(
        &self,
        problem: &Problem<'_>,
        state: &mut [f64],
    ) -> Result<Memory, Stopped> {
        let time = problem.from;
        let sides = self.inner.borrow().sides.clone();
        let zeros = self.inner.borrow().zeros.clone();
        let [slack, sizes] = [(); 2].map(|()| vec![0.0; sides.len()]);
        let mut memory = Memory { sides, slack, sizes, zeros, ..Memory::default() };
        let found = self.leave_zero(&mut memory, time, state);
        self.follow(problem, found, &mut memory, (time, state))?;
        Ok(memory)
    }

    /// Returns the guards of events that have crossed since they were last evaluated.
    fn passed(&self, memory: &mut Memory, time: f64, state: &[f64]) -> Vec<usize> {
        let inner = &mut *self.inner.borrow_mut();
        let mut passed = Vec::new();
        for index in 0..inner.sides.len() {
            let (guard, rate) = inner.parts.at(self.system, time, state, index);
            let direction = self.direction(index);
            let slack = &mut memory.slack[index];
            let (from, is_wanted) = match inner.sides[index] {
                Side::Idle => continue,
                Side::Known(side) => {
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
            if is_wanted && !self.watched[index].is_border() {
                passed.push(index);
            } else {
                inner.sides[index] = Side::Known(-from);
                *slack = 0.0;
            }
        }
        passed
    }

    /// Determines the sides of guards that have just crossed zero or begin at it. Returns the
    /// events whose guards leave to the far side without having just crossed.
    fn leave_zero(&self, memory: &mut Memory, time: f64, state: &[f64]) -> Vec<usize> {
        let mut found = Vec::new();
        let count = memory.sides.len();
        for index in 0..count {
            let zero = self.inner.borrow().zeros[index].filter(|zero| zero.is_at(time));
            if let (Side::Known(side), Some(zero), true) =
                (self.inner.borrow().sides[index], zero, self.is_kink(index))
            {
                let size = self.blur(index, time, state) / self.rtol;
                memory.slack[index] =
                    1.001 * (-side * zero.residual).max(0.0) + 16.0 * f64::EPSILON * size;
            }
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
                // Whatever holds the guard there, the host lets it drift within the tolerances.
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
                // The shift is as small as possible, since it accumulates over ever shorter
                // bounces.
                let beyond = (-seen * guard).max(0.0);
                memory.slack[index] = 1.001 * beyond + 16.0 * f64::EPSILON * size;
            }
        }
        found
    }
}
