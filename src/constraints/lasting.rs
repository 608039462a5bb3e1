//! Constraints that follow from others in all positions, such as those of a second hinge.

use machinist_contract::Simulator;

use super::start::start;
use super::{Constraints, Redundant, mobility};
use crate::scales::beside;

/// Number of positions at which a constraint has to follow from others.
const PLACES: usize = 4;
/// Distance of these positions from the start, in scales of states.
pub(super) const REACH: f64 = 0.2;
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
    let at_start = followers(simulator, parameters, time, &state);
    if at_start.is_empty() {
        return Vec::new();
    }
    let places: Vec<Vec<f64>> =
        (0..PLACES).map(|place| beside(simulator, &state, place, REACH)).collect();
    let found = everywhere(simulator, parameters, time, &at_start, &places);
    let mut lasting: Vec<Lasting> = found
        .iter()
        .map(|Redundant { constraint, repeats, .. }| Lasting {
            constraint: constraint.clone(),
            repeats: repeats.clone(),
            needs: Vec::new(),
        })
        .collect();
    for index in 0..parameters.len() {
        let mut changed = parameters.to_vec();
        changed[index] += if changed[index] == 0.0 { CHANGE } else { CHANGE * changed[index] };
        let still = everywhere(simulator, &changed, time, &found, &places);
        for one in &mut lasting {
            if !still.iter().any(|other| other.constraint == one.constraint) {
                one.needs.push(simulator.parameter(index).name.to_owned());
            }
        }
    }
    lasting
}

/// Returns those of some constraints that follow from the others at all positions: where the
/// others are fulfilled, these are too, and their rows of G depend on the other rows. Positions are
/// solved for without them, because their rows are nearly dependent beside such positions, where
/// moves along them have any length.
fn everywhere(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    time: f64,
    among: &[Redundant],
    places: &[Vec<f64>],
) -> Vec<Redundant> {
    let Some(constraints) = Constraints::of(simulator, parameters) else { return Vec::new() };
    let is_one = |row: usize| among.iter().any(|one| one.constraint == constraints.name(row));
    let rows: Vec<usize> = (0..constraints.count).filter(|row| is_one(*row)).collect();
    let mut found = among.to_vec();
    for place in places {
        let Some(there) = constraints.fulfilled_but(&rows, time, place) else { return Vec::new() };
        let followers = followers(simulator, parameters, time, &there);
        let is_fulfilled = |name: &str| {
            rows.iter()
                .filter(|row| constraints.name(**row) == name)
                .all(|row| constraints.is_fulfilled(*row, time, &there))
        };
        found.retain(|one| {
            is_fulfilled(&one.constraint)
                && followers.iter().any(|other| other.constraint == one.constraint)
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
