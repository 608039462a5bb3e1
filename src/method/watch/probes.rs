//! What guards depend on, found by evaluating them at states spread over a run.

use machinist_contract::RelationKind;

use crate::method::System;
use crate::method::sliding::{ABOVE, BELOW};

/// Returns an event whose guard and rate are zero on both branches of every relation at all probe
/// states, in the modes in which it is armed. The states are spread over the run, the time after it
/// and the scales of the states. Such an event can never happen. A guard that only a longer run
/// would move is not reported.
pub(crate) fn identically_zero(system: &System<'_>, span: (f64, f64)) -> Option<usize> {
    let count = system.simulator().events();
    let moving = moving_guards(system, span, &[]);
    let is_still = |event: &usize| {
        let when = system.simulator().event(*event).when;
        !moving[*event] && (when.is_empty() || !moving_guards(system, span, when)[*event])
    };
    (0..count).find(is_still)
}

/// Returns for each event whether its guard or the rate of its guard is other than zero at some
/// probe state, with the values of some modes given.
fn moving_guards(system: &System<'_>, span: (f64, f64), modes: &[(u32, f64)]) -> Vec<bool> {
    let mut moves = vec![false; system.simulator().events()];
    for probe in probes(system, span, modes) {
        for (moves, values) in moves.iter_mut().zip(probe.guards(system)) {
            *moves |= values.iter().any(|value| *value != 0.0);
        }
    }
    moves
}

/// Returns for each event whether it sets a state that its guard or the rate of its guard reads.
pub(super) fn steered_guards(system: &System<'_>, span: (f64, f64)) -> Vec<bool> {
    let simulator = system.simulator();
    let is_steered = |index: usize| {
        let event = simulator.event(index);
        let sets = event.sets.iter().map(|entry| *entry as usize);
        let sets: Vec<usize> = sets.filter(|entry| !simulator.is_mode(*entry)).collect();
        let reads = |mut probe: Probe| {
            let before = probe.guards(system)[index];
            for entry in &sets {
                probe.state[*entry] += simulator.state_scale(*entry);
            }
            probe.guards(system)[index].map(f64::to_bits) != before.map(f64::to_bits)
        };
        !sets.is_empty() && probes(system, span, event.when).any(reads)
    };
    (0..simulator.events()).map(is_steered).collect()
}

/// A state at which guards are evaluated to find out what they depend on.
struct Probe {
    time: f64,
    state: Vec<f64>,
    parameters: Vec<f64>,
}

impl Probe {
    /// Returns the guards of all events and their rates.
    fn guards(&self, system: &System<'_>) -> Vec<[f64; 2]> {
        let (simulator, Self { time, state, parameters }) = (system.simulator(), self);
        let [mut guards, mut rates] = [(); 2].map(|()| vec![0.0; simulator.events()]);
        simulator.guards(*time, state, parameters, &mut guards);
        simulator.guard_rates(*time, state, parameters, &mut rates);
        guards.into_iter().zip(rates).map(|(guard, rate)| [guard, rate]).collect()
    }
}

/// Returns states spread over a span and the time after it, with the values of some modes given and
/// relations on either branch: a guard may depend on a state, or be other than zero, on one only.
fn probes<'s>(
    system: &'s System<'_>,
    (from, until): (f64, f64),
    modes: &'s [(u32, f64)],
) -> impl Iterator<Item = Probe> + 's {
    const WITHIN: usize = 8;
    const PROBES: usize = 2 * WITHIN;
    let simulator = system.simulator();
    (0..PROBES).map(move |probe| {
        let spread = |index: usize| ((probe * 31 + index * 17) as f64 * 0.618 + 0.3).sin();
        let value = |index: usize| simulator.state_scale(index) * spread(index + 1);
        let mut state: Vec<f64> = (0..system.states()).map(value).collect();
        for (mode, value) in modes {
            state[*mode as usize] = *value;
        }
        let time = if probe < WITHIN {
            from + (until - from) * (probe as f64 + 0.5) / WITHIN as f64
        } else {
            until + (until - from) * 10f64.powi((probe - WITHIN) as i32)
        };
        let mut parameters = system.held().all().to_vec();
        let first = parameters.len() - simulator.relations();
        for (relation, slot) in parameters[first..].iter_mut().enumerate() {
            if simulator.relation(relation).kind == RelationKind::Branch {
                *slot = if spread(relation + 7) < 0.0 { BELOW } else { ABOVE };
            }
        }
        Probe { time, state, parameters }
    })
}
