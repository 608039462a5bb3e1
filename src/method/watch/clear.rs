//! Guards that cannot be zero while the motion stays within a box.
//!
//! Most guards are far from zero most of the time. Their ranges over a box of times and states, by
//! interval arithmetic, show which of them have no zero there. Steps within the box do not evaluate
//! these guards. The box grows while all guards are clear in it.

use machinist_contract::Interval;

use super::super::System;
use super::super::one_step::OneStep;
use super::watched::Watched;
use super::{Inner, Side, Watch};
use crate::constraints::Constraints;

/// Least distance from the middle of a box to its sides, in steps: a box costs several evaluations
/// of all guards.
const LEAST: f64 = 16.0;
/// Greatest distance, beyond which nothing is saved.
const GREATEST: f64 = 1e6;
/// Steps of a segment before the first box. Segments between frequent events are not much longer.
const FIRST: u32 = 3;
/// Longest pause after a box without a clear guard, in steps.
const LONGEST_PAUSE: u32 = 64;

/// Guards that are clear within the box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Clear {
    None,
    Some,
    All,
}

/// A box, and the guards that are clear in it.
pub(super) struct ClearBox {
    /// False if guards see other states than the method's.
    is_possible: bool,
    time: Interval,
    state: Vec<Interval>,
    guards: Vec<Interval>,
    /// For each watched function.
    is_clear: Vec<bool>,
    clear: Clear,
    /// Distance from the middle to the sides, in steps.
    steps: f64,
    /// Steps to wait for the next box.
    wait: u32,
    pause: u32,
    reach: Vec<f64>,
    /// True once the ranges of guards within the box are noted.
    is_noted: bool,
}

impl ClearBox {
    /// Returns no box yet, for this number of watched functions.
    pub(super) fn new(system: &System<'_>, watched: usize) -> Self {
        let simulator = system.simulator();
        // Guards see states projected onto constraints that prescribe a motion.
        let is_led = system.constraints().is_some_and(Constraints::may_lead);
        Self {
            is_possible: !is_led,
            time: Interval::WHOLE,
            state: vec![Interval::WHOLE; system.states()],
            guards: vec![Interval::WHOLE; simulator.events() + simulator.kinks()],
            is_clear: vec![false; watched],
            clear: Clear::None,
            steps: LEAST,
            wait: FIRST,
            pause: FIRST,
            reach: vec![0.0; system.states()],
            is_noted: false,
        }
    }

    /// Leaves the box, because relations, sides or modes may have changed.
    pub(super) fn forget(&mut self) {
        self.leave();
        (self.wait, self.pause) = (FIRST, FIRST);
    }

    fn leave(&mut self) {
        self.clear = Clear::None;
        self.is_clear.fill(false);
        self.is_noted = false;
    }

    /// Returns whether a watched function is clear.
    pub(super) fn is_clear(&self, index: usize) -> bool {
        self.is_clear[index]
    }

    /// Returns whether all watched functions are clear.
    pub(super) fn are_all(&self) -> bool {
        self.clear == Clear::All
    }

    /// Leaves the box if the current step may do so.
    pub(super) fn follow(&mut self, method: &mut dyn OneStep, within: [f64; 2], start: &[f64]) {
        if self.clear == Clear::None {
            return;
        }
        method.reach(within, start, &mut self.reach);
        let is_in_time = self.time.low <= within[0] && within[1] <= self.time.high;
        let states = self.state.iter().zip(start.iter().zip(&self.reach));
        let is_within = is_in_time
            && states.into_iter().all(|(range, (start, reach))| {
                range.low <= start - reach && start + reach <= range.high
            });
        if !is_within {
            if self.clear == Clear::All {
                self.steps = (2.0 * self.steps).min(GREATEST);
            }
            self.leave();
        }
    }
}

impl Watch<'_> {
    /// Makes a box around the end of the current step, which passed over no change.
    pub(super) fn look_for_clear(&self, inner: &mut Inner, method: &mut dyn OneStep, until: f64) {
        let it = &mut inner.clear;
        if !it.is_possible || it.clear != Clear::None || self.system.is_sliding() {
            return;
        }
        if it.wait > 0 {
            it.wait -= 1;
            return;
        }
        let Some(ranges) = self.system.simulator().ranges() else { return };
        method.reach([inner.time, until], &inner.start, &mut it.reach);
        let reaches = it.reach.iter().zip(self.atol);
        for (range, ((reach, atol), end)) in it.state.iter_mut().zip(reaches.zip(method.end())) {
            *range = Interval::around(*end, it.steps * reach.max(*atol));
        }
        it.time = Interval { low: until, high: until + it.steps * (until - inner.time) };
        let parameters: Vec<_> =
            self.system.held().all().iter().copied().map(Interval::of).collect();
        ranges.guard_ranges(it.time, &it.state, &parameters, &mut it.guards);
        for (index, watched) in self.watched.iter().enumerate() {
            it.is_clear[index] = match inner.sides[index] {
                Side::Idle => true,
                Side::Fresh { .. } => false,
                Side::Known(side) => {
                    let range = range_of(*watched, self.system, &it.guards);
                    range.clearance(side) > inner.parts.rounding(index)
                }
            };
        }
        it.clear = match it.is_clear.iter().filter(|is_clear| **is_clear).count() {
            0 => Clear::None,
            count if count == self.watched.len() => Clear::All,
            _ => Clear::Some,
        };
        if it.clear == Clear::None {
            it.pause = (2 * it.pause).min(LONGEST_PAUSE);
            it.wait = it.pause;
        }
        if it.clear != Clear::All {
            it.steps = (0.5 * it.steps).max(LEAST);
        }
    }

    /// Takes note of how far guards may go within the box, where no step evaluates them.
    pub(super) fn note_excursions_of_box(&self, inner: &mut Inner) {
        if std::mem::replace(&mut inner.clear.is_noted, true) {
            return;
        }
        for (index, watched) in self.watched.iter().enumerate() {
            if inner.sides[index] != Side::Idle {
                let range = range_of(*watched, self.system, &inner.clear.guards);
                inner.parts.note_excursion(index, range.magnitude());
            }
        }
    }
}

/// Returns the range of a watched function, from those of guards of events and of kinks.
fn range_of(watched: Watched, system: &System<'_>, guards: &[Interval]) -> Interval {
    let events = system.simulator().events();
    match watched {
        Watched::Event(index) => guards[index],
        Watched::Branch(index) | Watched::Border(index) | Watched::Zone(index) => {
            guards[events + index]
        }
        Watched::Low(index) => guards[events + index] - Interval::of(system.held().slot(index)),
        Watched::High(index) => {
            Interval::of(1.0 + system.held().slot(index)) - guards[events + index]
        }
        Watched::FromBelow(_) | Watched::FromAbove(_) | Watched::Nearest(_) => Interval::WHOLE,
    }
}
