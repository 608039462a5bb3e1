//! Relations: the branch of each, whether it is active, and surfaces along which the motion slides.
//!
//! Guards are evaluated in order, each after those that it reads, so no iteration is needed, except
//! if several are zero at once. A relation at zero takes the side to which the motion leaves, by g'
//! on both sides, or by g'' where g' vanishes:
//!
//! ```text
//! g'+ > 0, g'- > 0   above        g'+ > 0 > g'-   the side to which it was going
//! g'+ < 0, g'- < 0   below        g'+ < 0 < g'-   the motion slides along g = 0
//! ```
//!
//! A relation whose readers are all on branches that are not taken, or are events that are not
//! armed, is inactive: it ends no step.

use machinist_contract::{Reader, RelationKind};

use super::{Inner, Side, Watch, Watched, Zero, by_rounding};
use crate::error::StopCause;
use crate::method::Stopped;
use crate::method::sliding::{ABOVE, BELOW, Order, Sides, Slide};

const FLAT: &str = "a motion that oscillates about a switching surface by less than the tolerances \
                    follows the surface instead; its rates across the surface are left out";

/// State of the relations.
#[derive(Debug, Clone, Default)]
pub(super) struct Relations {
    /// Relations that are active.
    pub(super) active: Vec<bool>,
    /// Largest distance of each guard from zero between its last two changes, if it has changed.
    excursions: Vec<Option<f64>>,
    /// Guard of each relation at its last change; at this value rounding does not tell its side.
    at_change: Vec<Option<f64>>,
    /// Time of the last change.
    times: Vec<f64>,
}

/// A relation that changes, and its new slot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Change {
    pub(super) relation: usize,
    /// Watched function that crosses zero.
    guard: usize,
    sides: Sides,
    /// The slot on the other side.
    pub(super) slot: f64,
    /// True if the motion leaves a surface along which it slid.
    leaves: bool,
}

/// A relation at its surface.
#[derive(Debug, Clone, Copy)]
struct Contact {
    relation: usize,
    sides: Sides,
    /// Slot of the side to which the motion was going.
    toward: f64,
}

impl Relations {
    pub(super) fn new(count: usize) -> Self {
        Self {
            active: vec![false; count],
            excursions: vec![None; count],
            at_change: vec![None; count],
            times: vec![f64::NAN; count],
        }
    }
}

impl Watch<'_> {
    fn relations(&self) -> usize {
        self.system.simulator().relations()
    }

    fn kind(&self, relation: usize) -> RelationKind {
        self.system.simulator().relation(relation).kind
    }

    /// Returns the change of a relation whose guard crosses zero.
    pub(super) fn change_at(&self, guard: usize) -> Option<Change> {
        let relation = self.watched[guard].relation()?;
        let held = self.system.held().slot(relation);
        let below = match self.watched[guard] {
            Watched::Branch(_) => BELOW,
            Watched::Low(_) => held - 1.0,
            // Along a surface the slot below it is held.
            _ => held,
        };
        let sides = Sides::above_slot(below);
        let (slot, leaves) = match self.watched[guard] {
            Watched::FromBelow(_) => (sides.below, true),
            Watched::FromAbove(_) => (sides.above, true),
            _ => (if held > below { sides.below } else { sides.above }, false),
        };
        Some(Change { relation, guard, sides, slot, leaves })
    }

    /// Settles relations at a state at which some of them change.
    ///
    /// # Errors
    /// [`StopCause::Chattering`] if the motion would slide and cannot.
    pub(super) fn settle_relations(
        &self,
        (time, state): (f64, &[f64]),
        changes: &[Change],
    ) -> Result<(), Stopped> {
        if self.relations() == 0 {
            return Ok(());
        }
        let left = |slide: &Slide| changes.iter().any(|it| it.relation == slide.relation);
        let mut slides = self.system.slides();
        slides.retain(|slide| !left(slide));
        let count = slides.len();
        let before = (count > 0).then(|| self.system.kink_guards(time, state));
        let mut zero = self.take_sides((time, state), changes, &slides);
        // A surface that jumps with the relations that it reads leaves the motion behind.
        if let Some(before) = before {
            let after = self.system.kink_guards(time, state);
            let bits = |guards: &[f64], slide: &Slide| guards[slide.relation].to_bits();
            slides.retain(|slide| bits(&before, slide) == bits(&after, slide));
        }
        if slides.len() < count {
            let known: Vec<usize> = zero.iter().map(|it| it.relation).collect();
            let more = self.take_sides((time, state), &[], &slides);
            zero.extend(more.into_iter().filter(|it| !known.contains(&it.relation)));
        }
        self.find_active(state);
        let is_active = |relation: usize| self.inner.borrow().relations.active[relation];
        slides.retain(|slide| is_active(slide.relation));
        let zero: Vec<Contact> = zero.into_iter().filter(|it| is_active(it.relation)).collect();
        self.leave_or_slide((time, state), &slides, &zero)?;
        self.find_active(state);
        Ok(())
    }

    /// Sets relations to the sides of their guards. Returns those at their surfaces.
    fn take_sides(
        &self,
        (time, state): (f64, &[f64]),
        changes: &[Change],
        slides: &[Slide],
    ) -> Vec<Contact> {
        let held = self.system.held();
        let mut zero = Vec::new();
        let mut guards = self.system.kink_guards(time, state);
        let at_first = guards.clone();
        for relation in 0..self.relations() {
            if slides.iter().any(|slide| slide.relation == relation) {
                continue;
            }
            let (guard, before) = (guards[relation], held.slot(relation));
            // A guard that jumps with the relations it reads takes the resulting side. They are at
            // their surfaces but for rounding, and so is a guard that jumps to its own.
            let moved = (guard - at_first[relation]).abs();
            let rounding = if moved == 0.0 { 0.0 } else { self.rounding_at(relation, time, state) };
            let jumps = moved > rounding;
            let is_at = |surface: f64| {
                let distance = (guard - surface).abs();
                distance == 0.0 || jumps && distance <= rounding
            };
            let change = changes.iter().find(|it| it.relation == relation).filter(|_| !jumps);
            let at_change = self.inner.borrow().relations.at_change[relation];
            if change.is_some() {
                self.inner.borrow_mut().relations.at_change[relation] = Some(guard);
            } else if !jumps && at_change.is_some_and(|at| at.to_bits() == guard.to_bits()) {
                continue;
            }
            let slot = match (self.kind(relation), change) {
                (RelationKind::Zone, _) => before,
                (RelationKind::Whole, None) if !is_at(guard.round()) => guard.floor(),
                (RelationKind::Whole, None) => {
                    let sides = Sides::above_slot(guard.round() - 1.0);
                    // What reads it is evaluated on the side to which it goes.
                    let falls = self.system.kink_rates(time, state)[relation] < 0.0;
                    let toward = if falls { sides.below } else { sides.above };
                    zero.push(Contact { relation, sides, toward });
                    toward
                }
                (_, Some(change)) => {
                    // A relation that changes again at once has been seen to leave for that side;
                    // its first derivatives are rounding.
                    let last = &mut self.inner.borrow_mut().relations.times[relation];
                    let is_again = (time - *last).abs() <= soon(time);
                    *last = time;
                    if !change.leaves && !is_again {
                        let Change { sides, slot: toward, .. } = *change;
                        zero.push(Contact { relation, sides, toward });
                    }
                    change.slot
                }
                (RelationKind::Branch, None) if is_at(0.0) => {
                    let toward = if before == 0.0 { ABOVE } else { before };
                    zero.push(Contact { relation, sides: Sides::above_slot(BELOW), toward });
                    toward
                }
                (RelationKind::Branch, None) => self.side_of(relation, guard, before),
            };
            if slot.to_bits() != before.to_bits() {
                held.set(relation, slot);
                guards = self.system.kink_guards(time, state);
            }
        }
        zero
    }

    /// Returns the rounding error of the guard of a relation, with that of the time.
    pub(super) fn rounding_at(&self, relation: usize, time: f64, state: &[f64]) -> f64 {
        let is_its = |it: &Watched| it.kink() == Some((relation, 1.0));
        let place = self.watched.iter().position(is_its);
        let rounding = place.map_or(0.0, |place| self.rounding_of(place));
        rounding.max(by_rounding(time, self.system.kink_rates(time, state)[relation]))
    }

    /// Returns the side of a guard. A guard that was zero at the start of the segment stays on its
    /// side until it is further from zero than that.
    fn side_of(&self, relation: usize, guard: f64, before: f64) -> f64 {
        let side = if guard < 0.0 { BELOW } else { ABOVE };
        let inner = self.inner.borrow();
        let place = self.watched.iter().position(|it| *it == Watched::Branch(relation));
        let zero = place.and_then(|place| inner.zeros[place]);
        let is_zero = zero.is_some_and(|zero| guard.abs() <= zero.residual.abs());
        if is_zero && before != 0.0 { before } else { side }
    }

    /// Finds the relations that are active in the modes of a state: outer ones before those on
    /// their branches.
    pub(super) fn find_active(&self, state: &[f64]) {
        let count = self.relations();
        let mut active: Vec<Option<bool>> = vec![None; count];
        let armed: Vec<bool> = (0..self.system.simulator().events())
            .map(|event| self.is_armed(event, state))
            .collect();
        for relation in (0..count).rev() {
            self.is_active(relation, &armed, &mut active);
        }
        let active = active.into_iter().map(|active| active.unwrap_or(true)).collect();
        self.inner.borrow_mut().relations.active = active;
    }

    fn is_active(&self, relation: usize, armed: &[bool], known: &mut [Option<bool>]) -> bool {
        if let Some(known) = known[relation] {
            return known;
        }
        // Readers have no cycles; in a cycle all relations would be active.
        known[relation] = Some(true);
        let held = self.system.held();
        let slides = self.system.slides();
        let is_sliding = |index: usize| slides.iter().any(|slide| slide.relation == index);
        let readers = self.system.simulator().relation(relation).readers;
        let is_active = readers.iter().any(|reader| match *reader {
            Reader::Rate => true,
            Reader::Event(event) => armed[event as usize],
            Reader::Relation(index) => self.is_active(index as usize, armed, known),
            Reader::Below(index) | Reader::Above(index) => {
                let index = index as usize;
                let is_below = held.slot(index) < 0.0;
                let is_taken = is_below == matches!(reader, Reader::Below(_)) || is_sliding(index);
                is_taken && self.is_active(index, armed, known)
            }
        });
        known[relation] = Some(is_active);
        is_active
    }

    /// Lets relations at zero take the side to which the motion leaves, or lets the motion slide.
    fn leave_or_slide(
        &self,
        (time, state): (f64, &[f64]),
        slides: &[Slide],
        zero: &[Contact],
    ) -> Result<(), Stopped> {
        self.system.slide(slides);
        let along = slides.iter().map(|&Slide { relation, sides, .. }| Contact {
            relation,
            sides,
            toward: sides.below,
        });
        let all: Vec<Contact> = along.chain(zero.iter().copied()).collect();
        if zero.is_empty() && slides.is_empty() {
            return Ok(());
        }
        // Enough rounds for all relations to change in turn, and one more.
        for _ in 0..2 * all.len() + 2 {
            let mut has_changed = false;
            for contact in &all {
                has_changed |= self.leave_or_slide_along((time, state), *contact)?;
            }
            if !has_changed {
                return Ok(());
            }
        }
        Err(self.chatters(time, state, &all[0]))
    }

    /// Does the same for one relation; returns whether it has changed.
    fn leave_or_slide_along(
        &self,
        (time, state): (f64, &[f64]),
        contact: Contact,
    ) -> Result<bool, Stopped> {
        let Contact { relation, sides, toward } = contact;
        let (system, held) = (self.system, self.system.held());
        let mut others = system.slides();
        let own = others.iter().position(|slide| slide.relation == relation);
        let own = own.map(|place| others.remove(place));
        let before = held.slot(relation);
        system.slide(&others);
        let leaving = sides.both().map(|slot| {
            held.set(relation, slot);
            self.leaving((time, state), relation)
        });
        let [below, above] = leaving;
        // Sign of the first nonzero derivative; zero if all derivatives evaluated vanish.
        let goes = |leaving: Option<(Order, f64)>| leaving.map_or(0.0, |(_, rate)| rate.signum());
        let slot = match (goes(below), goes(above)) {
            (low, high) if low >= 0.0 && high > 0.0 => sides.above,
            (low, high) if low < 0.0 && high <= 0.0 => sides.below,
            (low, high) if low > 0.0 && high < 0.0 => {
                let order = match (below, above) {
                    (Some((Order::First, _)), _) | (_, Some((Order::First, _))) => Order::First,
                    _ => Order::Second,
                };
                held.set(relation, sides.below);
                return self.slide_along((time, state), (others, own), (contact, order));
            }
            _ => toward,
        };
        held.set(relation, slot);
        Ok(own.is_some() || slot.to_bits() != before.to_bits())
    }

    /// Lets the motion slide along one more surface; returns whether it did not before.
    fn slide_along(
        &self,
        (time, state): (f64, &[f64]),
        (mut others, own): (Vec<Slide>, Option<Slide>),
        (contact, order): (Contact, Order),
    ) -> Result<bool, Stopped> {
        let Contact { relation, sides, toward } = contact;
        let slide = Slide { relation, sides, order };
        let is_carried = self.system.tangents().is_none() || order == Order::First;
        if !is_carried || !self.enters_forces_only(time, state, &contact) {
            return Err(self.chatters(time, state, &contact));
        }
        let is_alone = others.is_empty();
        let before = others.clone();
        others.push(slide);
        others.sort_by_key(|slide| slide.relation);
        self.system.slide(&others);
        let alphas = self.system.alphas(time, state);
        // With several surfaces, no share of the rates may stay on all of them.
        let is_share = |alpha: &f64| (-1e-9..=1.0 + 1e-9).contains(alpha);
        if !is_alone && !alphas.iter().all(is_share) {
            self.system.slide(&before);
            self.system.held().set(relation, toward);
            return Ok(own.is_some());
        }
        if !alphas.iter().all(|alpha| alpha.is_finite()) {
            return Err(self.chatters(time, state, &contact));
        }
        Ok(own != Some(slide))
    }

    /// Returns whether a relation is neither in the mass matrix nor in constraints; no motion
    /// slides along such relations.
    fn enters_forces_only(&self, time: f64, state: &[f64], contact: &Contact) -> bool {
        let (simulator, held) = (self.system.simulator(), self.system.held());
        let Contact { relation, sides, .. } = *contact;
        let before = held.slot(relation);
        let inertia = |slot: f64| {
            held.set(relation, slot);
            let mut values = vec![0.0; simulator.mass_matrix_pattern().entries.len()];
            let state = &state[..self.system.states()];
            simulator.mass_matrix(time, state, &held.all(), &mut values);
            let mut rows = vec![0.0; simulator.constraint_matrix_pattern().entries.len()];
            if simulator.constraints() > 0 {
                simulator.constraint_matrix(time, state, &held.all(), &mut rows);
            }
            values.extend(rows);
            values
        };
        let is_same = inertia(sides.below) == inertia(sides.above);
        held.set(relation, before);
        is_same
    }

    /// Returns the first nonzero derivative of the guard of a relation at zero, with its slot as
    /// held.
    fn leaving(&self, (time, state): (f64, &[f64]), relation: usize) -> Option<(Order, f64)> {
        let system = self.system;
        let states = system.states();
        let slides = system.slides();
        let mut rate = system.kink_rates(time, state)[relation];
        if !slides.is_empty() {
            // Along the surfaces, add the change of the rate from all branches below.
            let below = rate;
            for (slide, alpha) in slides.iter().zip(system.alphas(time, state)) {
                system.held().set(slide.relation, slide.sides.above);
                rate += alpha * (system.kink_rates(time, state)[relation] - below);
                system.held().set(slide.relation, slide.sides.below);
            }
        }
        let mut along = vec![0.0; states];
        system.state_rate(time, &state[..states], &mut along);
        let bend = system.bend_along(relation, (time, &state[..states]), &along);
        // A rate that turns before any time has passed is rounding of zero.
        if rate.abs() > bend.abs() * soon(time) {
            return Some((Order::First, rate));
        }
        (bend != 0.0).then_some((Order::Second, bend))
    }

    /// Returns the stop cause where no motion continues.
    fn chatters(&self, time: f64, state: &[f64], contact: &Contact) -> Stopped {
        // The state that the relation changes most, relative to its size.
        let (system, held) = (self.system, self.system.held());
        let mut rates = contact.sides.both().map(|slot| {
            held.set(contact.relation, slot);
            let mut rate = vec![0.0; system.states()];
            system.rate_of_modes(time, &state[..system.states()], &mut rate);
            rate
        });
        let above = rates[1].clone();
        for (below, above) in rates[0].iter_mut().zip(above) {
            *below = (*below - above).abs();
        }
        let index =
            (0..system.states()).max_by(|a, b| rates[0][*a].total_cmp(&rates[0][*b])).unwrap_or(0);
        let cause = StopCause::Chattering { state: system.name(index), value: state[index] };
        Stopped { time, cause }
    }

    /// Sets the sides of guards of relations and borders at the start of a segment; `passed` are
    /// those that crossed zero there, and `may_have_moved` names those whose values may have jumped.
    pub(super) fn take_sides_of_kinks(
        &self,
        (time, state): (f64, &[f64]),
        passed: &[usize],
        may_have_moved: impl Fn(usize) -> bool,
    ) {
        let events = self.system.simulator().events();
        let slides = self.system.slides();
        let inner = &mut *self.inner.borrow_mut();
        let guards = inner.parts.all_at(self.system, time, state);
        for (index, &(residual, rate)) in guards.iter().enumerate().skip(events) {
            let moved = Some(residual).filter(|_| may_have_moved(index));
            let side = self.side_of_kink(inner, &slides, index, moved, passed.contains(&index));
            if side != inner.sides[index] && matches!(self.watched[index], Watched::Zone(_)) {
                (inner.longest, inner.entered) = (f64::INFINITY, time);
            }
            inner.sides[index] = side;
            let before = inner.zeros[index].take();
            if matches!(self.watched[index], Watched::Nearest(_)) {
                let has_passed = passed.contains(&index);
                inner.zeros[index] = if has_passed {
                    Some(Zero { time, residual, rate })
                } else {
                    before.filter(|zero| (time - zero.time).abs() <= soon(time))
                };
                // Only within the zone, whose guard precedes this one, and not again at once.
                let is_within = inner.sides[index - 1] == Side::Known(1.0);
                if !(is_within && residual > 0.0 && inner.zeros[index].is_none()) {
                    inner.sides[index] = Side::Idle;
                }
                continue;
            }
            let Side::Known(side) = side else { continue };
            // For an integer one end was crossed, and the other is far away.
            let has_passed = passed.contains(&index) && residual.abs() < 0.5;
            if side * residual <= 0.0 || has_passed {
                inner.zeros[index] = Some(Zero { time, residual, rate });
            }
        }
    }

    fn side_of_kink(
        &self,
        inner: &Inner,
        slides: &[Slide],
        index: usize,
        moved: Option<f64>,
        has_passed: bool,
    ) -> Side {
        let held = self.system.held();
        let active = &inner.relations.active;
        let is_sliding = |relation: usize| slides.iter().any(|it| it.relation == relation);
        match self.watched[index] {
            Watched::Event(_) => inner.sides[index],
            Watched::Border(_) | Watched::Zone(_) => match (inner.sides[index], moved) {
                (Side::Known(side), _) if has_passed => Side::Known(-side),
                (_, Some(guard)) if guard.abs() > inner.parts.rounding(index) => {
                    Side::Known(guard.signum())
                }
                (side @ Side::Known(_), _) => side,
                _ => Side::Known(1.0),
            },
            Watched::Nearest(_) => Side::Known(1.0),
            Watched::Branch(relation) if active[relation] && !is_sliding(relation) => {
                Side::Known(held.slot(relation).signum())
            }
            Watched::Low(relation) | Watched::High(relation)
                if active[relation] && !is_sliding(relation) =>
            {
                Side::Known(1.0)
            }
            Watched::FromBelow(relation) | Watched::FromAbove(relation) if is_sliding(relation) => {
                Side::Known(1.0)
            }
            _ => Side::Idle,
        }
    }

    /// Puts the motion onto a surface of order two, along which it then slides, if it oscillates
    /// about the surface within the tolerances, unless energy is conserved: such a motion never
    /// comes to rest. Returns whether it does.
    ///
    /// # Errors
    /// As [`System::put_onto_surfaces`](crate::method::System::put_onto_surfaces).
    pub(super) fn hold_flat(
        &self,
        time: f64,
        state: &mut [f64],
        changes: &[Change],
    ) -> Result<bool, Stopped> {
        let (simulator, parameters) = (self.system.simulator(), self.system.parameters());
        let mut slides = self.system.slides();
        for change in changes.iter().filter(|it| !it.leaves) {
            if self.is_within_tolerances(time, state, change)
                && simulator.conserves_energy(parameters) != Some(true)
                && self.is_driven_back(time, state, change)
                && self.system.tangents().is_none()
            {
                let Change { relation, sides, .. } = *change;
                slides.push(Slide { relation, sides, order: Order::Second });
            }
        }
        let is_held = slides.len() > self.system.slides().len();
        if is_held {
            slides.sort_by_key(|slide| slide.relation);
            self.system.slide(&slides);
            // Its rate across the surface would lead away from it.
            self.system.put_onto_surfaces(time, state)?;
            self.system.note(FLAT.to_owned());
        }
        Ok(is_held)
    }

    /// Returns whether the guard of a relation that changes has been within the tolerances since
    /// the change before the last one.
    fn is_within_tolerances(&self, time: f64, state: &[f64], change: &Change) -> bool {
        let (excursion, earlier) = {
            let inner = &mut *self.inner.borrow_mut();
            let excursion = inner.parts.take_excursion(change.guard);
            // For an integer, the other end of its interval was far away.
            for (place, watched) in self.watched.iter().enumerate() {
                if watched.relation() == Some(change.relation) {
                    inner.parts.take_excursion(place);
                }
            }
            (excursion, inner.relations.excursions[change.relation].replace(excursion))
        };
        let Some(earlier) = earlier else { return false };
        excursion.max(earlier) <= self.blur(change.guard, time, state)
    }

    /// Returns whether both branches of a relation that changes accelerate its guard towards zero.
    fn is_driven_back(&self, time: f64, state: &[f64], change: &Change) -> bool {
        let states = &state[..self.system.states()];
        let [below, above] = change.sides.both().map(|slot| {
            self.system.held().set(change.relation, slot);
            let mut rate = vec![0.0; states.len()];
            self.system.state_rate(time, states, &mut rate);
            self.system.bend_along(change.relation, (time, states), &rate)
        });
        self.system.held().set(change.relation, change.slot);
        below > 0.0 && above < 0.0
    }
}

/// Returns the time after another one in which nothing moves but by rounding.
fn soon(time: f64) -> f64 {
    4.0 * f64::EPSILON * time.abs()
}
