//! Watched functions: guards of events, relations and borders, and ends of sliding.

use machinist_contract::{RelationKind, Simulator};

use crate::method::System;
use crate::method::one_step::Bounded;
use crate::method::sliding::Slide;

/// A function of time and state whose sign is watched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Watched {
    /// Guard of an event.
    Event(usize),
    /// Guard of a branch.
    Branch(usize),
    /// Distance of the argument of `floor` above its integer.
    Low(usize),
    /// Distance of the argument below the next integer.
    High(usize),
    /// Share of the rate above in a motion that slides along the surface of a relation.
    FromBelow(usize),
    /// Share of the rate below in such a motion.
    FromAbove(usize),
    /// Guard of a kink at which nothing changes.
    Border(usize),
    /// Guard of a zone, likewise.
    Zone(usize),
    /// Rate of the guard within a zone: it falls to zero where the motion is nearest.
    Nearest(usize),
}

impl Watched {
    /// Returns all watched functions of a simulator, events first.
    pub(super) fn all(simulator: &dyn Simulator<f64>) -> Vec<Self> {
        let relations = simulator.relations();
        let mut all: Vec<Self> = (0..simulator.events()).map(Self::Event).collect();
        for index in 0..relations {
            match simulator.relation(index).kind {
                RelationKind::Branch => {
                    all.extend([
                        Self::Branch(index),
                        Self::FromBelow(index),
                        Self::FromAbove(index),
                    ]);
                }
                RelationKind::Zone => all.extend([Self::Zone(index), Self::Nearest(index)]),
                RelationKind::Whole => all.extend([
                    Self::Low(index),
                    Self::High(index),
                    Self::FromBelow(index),
                    Self::FromAbove(index),
                ]),
            }
        }
        all.extend((relations..simulator.kinks()).map(Self::Border));
        all
    }

    /// Returns whether nothing changes where it crosses zero.
    pub(super) fn is_border(self) -> bool {
        matches!(self, Self::Border(_) | Self::Zone(_))
    }

    /// Returns the relation that changes where it crosses zero, if one does.
    pub(super) fn relation(self) -> Option<usize> {
        match self {
            Self::Branch(index)
            | Self::Low(index)
            | Self::High(index)
            | Self::FromBelow(index)
            | Self::FromAbove(index) => Some(index),
            Self::Event(_) | Self::Border(_) | Self::Zone(_) | Self::Nearest(_) => None,
        }
    }

    /// Returns the function whose derivatives have the sizes of this one's, among guards of `events`
    /// and kinks and shares; `None` if there is none.
    pub(super) fn bounded(self, events: usize) -> Option<Bounded> {
        match self {
            Self::Event(index) => Some(Bounded::Guard(index)),
            Self::FromBelow(index) | Self::FromAbove(index) => Some(Bounded::Share(index)),
            Self::Nearest(_) => None,
            _ => self.kink().map(|(index, _)| Bounded::Guard(events + index)),
        }
    }

    /// Returns the value of this function from that of [`Watched::bounded`].
    pub(super) fn of_bounded(self, value: f64, system: &System<'_>) -> f64 {
        match self {
            Self::Low(index) => value - system.held().slot(index),
            Self::High(index) => 1.0 + system.held().slot(index) - value,
            Self::FromAbove(_) => 1.0 - value,
            _ => value,
        }
    }

    /// Returns the guard among those of kinks, with its sign, if it is one.
    pub(super) fn kink(self) -> Option<(usize, f64)> {
        match self {
            Self::Branch(index) | Self::Low(index) | Self::Border(index) | Self::Zone(index) => {
                Some((index, 1.0))
            }
            Self::High(index) => Some((index, -1.0)),
            Self::Event(_) | Self::FromBelow(_) | Self::FromAbove(_) | Self::Nearest(_) => None,
        }
    }
}

/// Values of all watched functions, from guards of events and kinks.
pub(super) struct Sources {
    events: usize,
    /// Guards of events, then of kinks.
    values: Vec<f64>,
    /// Rates of the guards of zones.
    nearing: Vec<(usize, f64)>,
    alphas: Vec<f64>,
    slides: Vec<Slide>,
}

impl Sources {
    pub(super) fn new(simulator: &dyn Simulator<f64>) -> Self {
        let events = simulator.events();
        let values = vec![0.0; events + simulator.kinks()];
        Self { events, values, nearing: zones(simulator), alphas: Vec::new(), slides: Vec::new() }
    }

    /// Evaluates guards at a state.
    pub(super) fn take(&mut self, system: &System<'_>, time: f64, state: &[f64]) {
        let (simulator, state) = (system.simulator(), &state[..system.states()]);
        let (guards, kinks) = self.values.split_at_mut(self.events);
        let held = system.held().all();
        if !guards.is_empty() {
            simulator.guards(time, state, &held, guards);
        }
        if !kinks.is_empty() {
            simulator.kink_guards(time, state, &held, kinks);
        }
        if !self.nearing.is_empty() {
            let mut rates = vec![0.0; simulator.kinks()];
            simulator.kink_rates(time, state, &held, &mut rates);
            for (zone, rate) in &mut self.nearing {
                *rate = rates[*zone];
            }
        }
        drop(held);
        if system.is_sliding() {
            self.slides = system.slides();
            self.alphas = system.alphas(time, state);
        } else {
            self.slides.clear();
        }
    }

    /// Returns the value of a watched function.
    pub(super) fn value(&self, system: &System<'_>, watched: Watched) -> f64 {
        let alpha = |relation: usize| {
            let place = self.slides.iter().position(|slide| slide.relation == relation);
            place.map_or(0.5, |place| self.alphas[place])
        };
        match watched {
            Watched::Event(index) => self.values[index],
            Watched::Branch(index) | Watched::Border(index) | Watched::Zone(index) => {
                self.values[self.events + index]
            }
            Watched::Low(index) => self.values[self.events + index] - system.held().slot(index),
            Watched::High(index) => {
                1.0 + system.held().slot(index) - self.values[self.events + index]
            }
            Watched::Nearest(index) => {
                let found = self.nearing.iter().find(|(zone, _)| *zone == index);
                found.map_or(0.0, |(_, rate)| *rate)
            }
            Watched::FromBelow(index) => alpha(index),
            Watched::FromAbove(index) => 1.0 - alpha(index),
        }
    }

    /// Evaluates rates of guards along the motion at a state; none for shares.
    pub(super) fn take_rates(&mut self, system: &System<'_>, time: f64, state: &[f64]) {
        let (simulator, state) = (system.simulator(), &state[..system.states()]);
        let events = self.events;
        let take = |values: &mut [f64]| {
            let (rates, kinks) = values.split_at_mut(events);
            let held = system.held().all();
            if !rates.is_empty() {
                simulator.guard_rates(time, state, &held, rates);
            }
            if !kinks.is_empty() {
                simulator.kink_rates(time, state, &held, kinks);
            }
        };
        if !system.is_sliding() {
            return take(&mut self.values);
        }
        // Rates of guards are linear in y', like y' along surfaces.
        let values = &mut self.values;
        values.fill(0.0);
        let mut side = vec![0.0; values.len()];
        system.for_each_side(&system.alphas(time, state), |share| {
            take(&mut side);
            for (value, side) in values.iter_mut().zip(&side) {
                *value += share * side;
            }
        });
    }

    /// Returns the rate of a watched function after [`Sources::take_rates`].
    pub(super) fn rate(&self, watched: Watched) -> f64 {
        match watched {
            Watched::Event(index) => self.values[index],
            _ => watched
                .kink()
                .map_or(f64::NAN, |(index, sign)| sign * self.values[self.events + index]),
        }
    }
}

/// Returns the zones of a simulator, each with a rate not known yet.
fn zones(simulator: &dyn Simulator<f64>) -> Vec<(usize, f64)> {
    let is_zone = |index: &usize| simulator.relation(*index).kind == RelationKind::Zone;
    (0..simulator.relations()).filter(is_zone).map(|index| (index, 0.0)).collect()
}
