//! Events that only count, such as the lines of an encoder.
//!
//! Nothing that determines the motion or an event reads what they set, so they do not end a step.
//! All their crossings within an accepted step are found on its dense output. The steps go on with
//! the old values of the entries, and states that leave a method get the new ones.

use machinist_contract::{Reader, RelationKind};

use super::passing::{Guard, Step};
use super::{Inner, Outcome, Watch};
use crate::method::one_step::OneStep;
use crate::method::{Stopped, System};
use crate::trajectory::Switch;

/// Events that only count, and the entries of the state that they have set in this segment.
#[derive(Debug, Default)]
pub(super) struct Counters {
    events: Vec<usize>,
    /// Entries and their values at the start of the current step.
    before: Vec<(usize, f64)>,
    /// Times within the current step, with entries and their values from then on.
    within: Vec<(f64, usize, f64)>,
}

impl Counters {
    /// Returns the counters of a system; none if it carries sensitivities, which jump where an
    /// event stores a state.
    pub(super) fn new(system: &System<'_>) -> Self {
        let simulator = system.simulator();
        // A guard on a branch may reach zero where the branch ends, and with it the step.
        let is_on_branch = |index: usize| {
            let reader = Reader::Event(u32::try_from(index).expect("few events"));
            (0..simulator.relations())
                .map(|relation| simulator.relation(relation))
                .any(|it| it.kind == RelationKind::Branch && it.readers.contains(&reader))
        };
        let counts = |index: &usize| simulator.event(*index).counts && !is_on_branch(*index);
        let events = (0..simulator.events()).filter(counts);
        let events = if system.tangents().is_some() { Vec::new() } else { events.collect() };
        Self { events, ..Self::default() }
    }

    pub(super) fn has(&self, index: usize) -> bool {
        self.events.contains(&index)
    }

    /// Forgets the entries, which the state of a new segment contains.
    pub(super) fn clear(&mut self) {
        self.before.clear();
        self.within.clear();
    }

    /// Begins another step.
    fn renew(&mut self) {
        for (_, entry, value) in self.within.drain(..) {
            set(&mut self.before, entry, value);
        }
    }

    /// Enters the values at a time within the current step into a state.
    fn enter(&self, time: f64, state: &mut [f64]) {
        for (entry, value) in &self.before {
            state[*entry] = *value;
        }
        let until = self.within.partition_point(|(at, ..)| *at <= time);
        for (_, entry, value) in &self.within[..until] {
            state[*entry] = *value;
        }
    }
}

/// Sets the value of an entry.
fn set(values: &mut Vec<(usize, f64)>, entry: usize, value: f64) {
    match values.iter_mut().find(|(known, _)| *known == entry) {
        Some((_, known)) => *known = value,
        None => values.push((entry, value)),
    }
}

impl Watch<'_> {
    /// Makes events that only count end steps like all others, for callers that halt there.
    pub(in crate::method) fn halt_at_counters(&self) {
        self.inner.borrow_mut().counters = Counters::default();
    }

    /// Enters the values of counters at a time within the current step into a state.
    pub(in crate::method) fn enter_counts(&self, time: f64, state: &mut [f64]) {
        self.inner.borrow().counters.enter(time, state);
    }

    /// Applies the events that only count within the current step, up to a time.
    ///
    /// # Errors
    /// [`Stopped`] if a new value is not finite.
    pub(in crate::method) fn tally(
        &self,
        method: &mut dyn OneStep,
        until: f64,
    ) -> Result<(), Stopped> {
        let inner = &mut *self.inner.borrow_mut();
        if inner.counters.events.is_empty() {
            return Ok(());
        }
        inner.counters.renew();
        if inner.clear.are_all() {
            return Ok(());
        }
        let passings = self.passings_of_counters(inner, method, until);
        if passings.is_empty() {
            return Ok(());
        }
        let mut state = inner.start.clone();
        let mut latest = inner.counters.before.clone();
        for (time, index) in passings {
            method.interpolate(time, &mut state);
            for (entry, value) in &latest {
                state[*entry] = *value;
            }
            self.apply(index, time, &mut state[..self.system.states()])?;
            let event = self.system.simulator().event(index);
            for entry in event.sets.iter().map(|entry| *entry as usize) {
                inner.counters.within.push((time, entry, state[entry]));
                set(&mut latest, entry, state[entry]);
            }
            self.system.count(|work| work.switches += 1);
            inner.switches.push(Switch::new(time, event.name));
        }
        Ok(())
    }

    /// Returns the times of all events that only count within the current step, in order.
    fn passings_of_counters(
        &self,
        inner: &mut Inner,
        method: &mut dyn OneStep,
        until: f64,
    ) -> Vec<(f64, usize)> {
        let mut passings = Vec::new();
        let mut step = Step { system: self.system, method };
        passings.extend(inner.touched.drain(..).map(|(index, _)| (inner.time, index)));
        for index in inner.counters.events.clone() {
            if inner.clear.is_clear(index) {
                continue;
            }
            let direction = self.direction(index);
            let guard = Guard { index, direction, is_kink: false, zero: inner.zeros[index] };
            let side = inner.sides[index];
            let (times, side) = inner.parts.passings(&mut step, (guard, until), side);
            passings.extend(times.into_iter().map(|time| (time, index)));
            inner.sides[index] = side;
            inner.outcomes[index] = Outcome::Stays(side);
        }
        passings.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        passings
    }
}
