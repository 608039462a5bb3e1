//! Branches of relations, for hosts that hold them over their own steps.

use machinist_contract::{RelationKind, Simulator};

use crate::method::System;

/// Returns the branches of all relations at a state, as slots: minus infinity for a comparison whose
/// guard is below zero, plus infinity for another one, and n for an integer. A rate with these after
/// the parameters holds the branches and is smooth; without them it is live.
#[must_use]
pub fn branches(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    (time, state): (f64, &[f64]),
) -> Vec<f64> {
    let guards = System::new(simulator, parameters, false).kink_guards(time, state);
    let slot = |(relation, guard): (usize, f64)| match simulator.relation(relation).kind {
        RelationKind::Branch if guard < 0.0 => f64::NEG_INFINITY,
        RelationKind::Branch => f64::INFINITY,
        RelationKind::Whole => guard.floor(),
        kind @ RelationKind::Zone => kind.live(),
    };
    guards.into_iter().take(simulator.relations()).enumerate().map(slot).collect()
}

/// Returns the distance of each relation's guard from the end of its branch, with branches as held:
/// positive within the branch, negative beyond. It is infinite for a relation that is live.
#[must_use]
pub fn margins(
    simulator: &dyn Simulator<f64>,
    (parameters, branches): (&[f64], &[f64]),
    (time, state): (f64, &[f64]),
) -> Vec<f64> {
    let system = System::new(simulator, parameters, false);
    system.held().set_all(branches);
    let guards = system.kink_guards(time, state);
    let margin =
        |(relation, (guard, slot)): (usize, (f64, &f64))| match simulator.relation(relation).kind {
            RelationKind::Branch if slot.is_infinite() => guard * slot.signum(),
            RelationKind::Whole if slot.is_finite() => (guard - slot).min(slot + 1.0 - guard),
            _ => f64::INFINITY,
        };
    guards.into_iter().zip(branches).enumerate().map(margin).collect()
}
