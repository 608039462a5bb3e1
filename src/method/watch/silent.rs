//! Relations that change within a step without ending it.
//!
//! A relation that only guards of events read has no influence on the motion. If none of these
//! guards comes near zero, on either branch, the step may pass over its change.

use machinist_contract::Reader;

use super::{Inner, Outcome, Side, Step, Watch, Watched};

impl Watch<'_> {
    /// Finds the relations that may change silently within the step.
    pub(super) fn look_over_silent_changes(&self, inner: &mut Inner, step: &mut Step<'_, '_>) {
        inner.silent.clear();
        for index in self.system.simulator().events()..self.watched.len() {
            let Watched::Branch(relation) = self.watched[index] else { continue };
            let Outcome::Passes { from, .. } = inner.outcomes[index] else { continue };
            let Some(change) = self.change_at(index) else { continue };
            let (last, _) = inner.parts.last(index);
            if last.abs() <= inner.parts.rounding(index) {
                continue;
            }
            let Some(events) = self.events_alone(inner, relation) else { continue };
            let (held, start) = (self.system.held(), std::mem::take(&mut inner.start));
            let slot = held.slot(relation);
            held.set(relation, change.slot);
            let is_silent =
                events.into_iter().all(|event| inner.parts.stays_as_held(step, event, &start));
            held.set(relation, slot);
            inner.start = start;
            if is_silent {
                let side = last.signum();
                inner.outcomes[index] = Outcome::Stays(Side::Known(side));
                if side * from < 0.0 {
                    inner.silent.push((index, change));
                }
            }
        }
    }

    /// Returns the armed events that read a relation, with the sides of their guards, if nothing
    /// else reads it, none of them passes within the step and no other relation that they read does.
    fn events_alone(&self, inner: &Inner, relation: usize) -> Option<Vec<(usize, f64)>> {
        let simulator = self.system.simulator();
        let passes = |other: usize| {
            let guards = self.watched.iter().zip(&inner.outcomes);
            guards.into_iter().any(|(watched, outcome)| {
                let is_its = watched.relation() == Some(other);
                is_its && matches!(outcome, Outcome::Passes { .. })
            })
        };
        let mut events = Vec::new();
        for reader in simulator.relation(relation).readers {
            let Reader::Event(event) = *reader else { return None };
            let event = event as usize;
            match (inner.sides[event], inner.outcomes[event]) {
                (Side::Idle, _) => {}
                // It is seen only on the branches that the step holds.
                _ if inner.counters.has(event) => return None,
                (Side::Known(side), Outcome::Stays(Side::Known(end))) if side * end > 0.0 => {
                    events.push((event, side));
                }
                _ => return None,
            }
        }
        let is_alone = (0..simulator.relations()).filter(|other| *other != relation).all(|other| {
            let readers = simulator.relation(other).readers;
            let depends = readers.iter().any(|reader| match *reader {
                Reader::Below(of) | Reader::Above(of) | Reader::Relation(of) => {
                    of as usize == relation
                }
                Reader::Rate | Reader::Event(_) => false,
            });
            let shares = |(event, _): &(usize, f64)| {
                readers.contains(&Reader::Event(u32::try_from(*event).expect("few events")))
            };
            !(depends || passes(other) && events.iter().any(shares))
        });
        is_alone.then_some(events)
    }

    /// Changes the relations that have changed silently within the accepted step.
    pub(super) fn change_silently(&self, inner: &mut Inner) {
        for (index, change) in inner.silent.drain(..) {
            self.system.held().set(change.relation, change.slot);
            inner.zeros[index] = None;
            inner.parts.forget_end();
            inner.clear.forget();
        }
    }
}
