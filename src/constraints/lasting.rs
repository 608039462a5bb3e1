//! Constraints that follow from others in all positions, such as those of a second hinge.

use machinist_contract::Simulator;

use super::start::{consistent, start};
use super::{Redundant, mobility};
use crate::scales::beside;

/// Number of positions at which a constraint has to follow from others.
const PLACES: usize = 4;
/// Distance of these positions from the start, in scales of states.
const REACH: f64 = 0.2;
/// Relative change of a parameter that shows whether it matters.
const CHANGE: f64 = 1e-3;

/// A constraint that follows from others in all positions.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Lasting {
    /// Name of the constraint.
    pub constraint: String,
    /// Names of the constraints from which it follows; none if it holds in any position.
    pub repeats: Vec<String>,
    /// Names of the parameters that must keep their values for this.
    pub needs: Vec<String>,
}

/// Returns the constraints that always hold and follow consistently from others that do, or that no
/// coordinate can change, at the start and at positions around it that fulfil all constraints. The
/// machine moves in the same way without them; how all of them share the force is not determined.
#[must_use]
pub fn lasting(simulator: &dyn Simulator<f64>, parameters: &[f64], time: f64) -> Vec<Lasting> {
    let Ok(state) = start(simulator, parameters, time) else { return Vec::new() };
    if followers(simulator, parameters, time, &state).is_empty() {
        return Vec::new();
    }
    let Some(found) = everywhere(simulator, parameters, time, &state) else { return Vec::new() };
    let mut lasting: Vec<Lasting> = found
        .into_iter()
        .map(|Redundant { constraint, repeats, .. }| Lasting {
            constraint,
            repeats,
            needs: Vec::new(),
        })
        .collect();
    for index in 0..parameters.len() {
        let mut changed = parameters.to_vec();
        changed[index] += if changed[index] == 0.0 { CHANGE } else { CHANGE * changed[index] };
        let still = everywhere(simulator, &changed, time, &state).unwrap_or_default();
        for one in &mut lasting {
            if !still.iter().any(|other| other.constraint == one.constraint) {
                one.needs.push(simulator.parameter(index).name.to_owned());
            }
        }
    }
    lasting
}

/// Returns the constraints that follow from others at all positions; none if constraints contradict
/// each other.
fn everywhere(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    time: f64,
    state: &[f64],
) -> Option<Vec<Redundant>> {
    let mut found: Option<Vec<Redundant>> = None;
    for place in 0..PLACES {
        let moved = beside(simulator, state, place, REACH);
        let there = consistent(simulator, parameters, time, moved, |_| false).ok()?;
        let followers = followers(simulator, parameters, time, &there);
        found = Some(match found {
            None => followers,
            Some(mut found) => {
                found
                    .retain(|one| followers.iter().any(|other| other.constraint == one.constraint));
                found
            }
        });
    }
    found
}

/// Returns the constraints that always hold and follow from others that do, or that no coordinate
/// can change, at a state.
fn followers(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    time: f64,
    state: &[f64],
) -> Vec<Redundant> {
    let found = mobility(simulator, parameters, time, state);
    let mut redundant = found.map_or_else(Vec::new, |found| found.redundant);
    let always = |name: &String| {
        let mut all = (0..simulator.constraints()).map(|index| simulator.constraint(index));
        all.any(|constraint| constraint.name == name && !constraint.in_modes)
    };
    redundant.retain(|one| !one.in_modes && !one.is_level && one.repeats.iter().all(always));
    redundant
}
