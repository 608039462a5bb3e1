//! Checks of powers and energies of a machine.
//!
//! The balance closes for any force: the work of a force counts as supplied, regardless of its
//! sign. Its residual reveals inconsistent forces marked `conversion`, and inconsistent energies
//! and powers of first-order states. Wrong signs show elsewhere: as negative dissipation, as events
//! that gain energy, and as forces that push along in either direction of motion.

use machinist_contract::{Direction, PowerBalance, Simulator, StateKind};

use super::visit::Visit;
use super::{Found, Outcome, Row};
use crate::verify::machine::Point;
use crate::verify::power::{account_error, residual};

pub(super) const BALANCE: Row = Row {
    name: "power balance along the run and around it",
    reference: "dE/dt = supplied - lost, relative to the sizes of its terms",
    tolerance: 1e-10,
    reason: "an identity; rounding is left, more where terms cancel",
    matters: "Energy appears or vanishes: a force marked `conversion` and the first-order states \
              it takes from do not balance, or `stored`, `supplied` and `dissipated` of these do \
              not belong to their rates.",
    measure: balance,
};

pub(super) const ACCOUNT: Row = Row {
    name: "energy account of a converged run",
    reference: "energy stored, supplied and lost, relative to the energy passed, if any, or in \
                motion, at least to that of small moves",
    tolerance: 1e-8,
    reason: "a thousand times the tolerance of a step, which errors of many steps stay below",
    matters: "Energy appears or vanishes along the run, between states that balance or at events.",
    measure: account,
};

pub(super) const LOST: Row = Row {
    name: "power lost is never negative",
    reference: "at velocities along the run and around it and at their negatives, half of both; \
                relative to the largest power",
    tolerance: 1e-9,
    reason: "rounding of the largest power",
    matters: "What should lose energy gives some: look for a sign in a `dissipation` or in \
              `power.dissipated`.",
    measure: lost,
};

pub(super) const EVENTS: Row = Row {
    name: "no event gains energy",
    reference: "energy lost so far, which must not shrink, relative to the energy passed or in \
                motion",
    tolerance: 1e-8,
    reason: "errors of the account, see there",
    matters: "An event leaves more energy than there was: look at what it sets, such as a \
              restitution above 1.",
    measure: events,
};

pub(super) const FORCES: Row = Row {
    name: "no force feeds every motion",
    reference: "power supplied at the velocities of the run, and at their negatives: the less of \
                the two, beside what is supplied at rest, relative to both; and no more than what \
                both give to what moves",
    tolerance: 1e-6,
    reason: "a drive supplies power one way only, and what slows takes it both ways",
    matters: "Forces supply power whichever way the machine moves, as a drag of the wrong sign \
              does. A machine that is meant to excite itself fails this row rightly.",
    measure: forces,
};

/// Checks the balance as for the built-in studies, with the gradient of the energy by differences,
/// which only sets the scale.
fn balance(visit: &Visit<'_>) -> Outcome {
    let simulator = visit.simulator;
    let energy =
        |point: &Point| simulator.energy(point.time, &point.state, &point.parameters).total();
    let least = least_power(visit);
    let mut found = Found::nothing();
    for point in &visit.points {
        let rate = visit.rate(point);
        let slope = |size: f64, shift: &dyn Fn(&mut Point, f64)| {
            let at = |step: f64| {
                let mut point = point.clone();
                shift(&mut point, step);
                energy(&point)
            };
            let step = 1e-4 * size;
            (at(step) - at(-step)) / (2.0 * step)
        };
        let mut terms: Vec<f64> = (0..rate.len())
            .filter(|index| !simulator.is_mode(*index))
            .map(|index| rate[index] * slope(visit.sizes[index], &|p, h| p.state[index] += h))
            .collect();
        terms.push(slope(1e-2 * visit.duration(), &|p, h| p.time += h));
        // Terms without a value near the point set no scale.
        let size: f64 = terms.iter().filter(|term| term.is_finite()).map(|term| term.abs()).sum();
        let error = residual(simulator, point, size + least);
        found.take(error, || format!("Worst at {} s.", point.time));
    }
    Outcome::Found(found)
}

fn account(visit: &Visit<'_>) -> Outcome {
    let Some(balance) = visit.references().account() else {
        return visit.references().missing();
    };
    let error = account_error(balance, small_energy(visit));
    Outcome::Found(Found { error, place: String::new() })
}

/// Returns the least reference energy of a balance \[J\]. At rest, or nearly so, no energy passes,
/// and errors of steps and rounding are large in comparison. This times the tolerance of the
/// balance is the effect of a hundred times the tolerance of a step on the energy at typical sizes,
/// plus rounding. A wrong sign causes an error of the size of the part itself.
fn small_energy(visit: &Visit<'_>) -> f64 {
    /// Fraction of typical moves.
    const SMALL: f64 = 1e-2;
    const ROUNDINGS: f64 = 64.0;
    let simulator = visit.simulator;
    let energy =
        |state: &[f64], point: &Point| simulator.energy(point.time, state, &point.parameters);
    let of = |point: &Point| {
        let here = energy(&point.state, point);
        let moved = |index: usize| {
            let mut state = point.state.clone();
            state[index] += SMALL * visit.sizes[index];
            (energy(&state, point).total() - here.total()).abs()
        };
        let entries = (0..point.state.len()).filter(|index| !simulator.is_mode(*index));
        let moves: f64 = entries.map(moved).filter(|moved| moved.is_finite()).sum();
        let parts = here.kinetic.abs() + here.potential.abs() + here.stored.abs();
        moves + ROUNDINGS * f64::EPSILON / ACCOUNT.tolerance * parts
    };
    visit.points.iter().map(of).filter(|energy| energy.is_finite()).fold(0.0, f64::max)
}

/// Returns a power that counts as negligible \[W\]: the energy in motion once per run.
fn least_power(visit: &Visit<'_>) -> f64 {
    let energy = |point: &Point| {
        let energy = visit.simulator.energy(point.time, &point.state, &point.parameters);
        energy.kinetic.abs() + energy.stored.abs()
    };
    visit.points.iter().map(energy).fold(0.0, f64::max) / visit.duration()
}

/// Checks half the sum of the powers dissipated at velocities and at their negatives. A damper with
/// one end moved dissipates c (v - u) v of the machine's own motion, which may be negative, since
/// the mover supplies the rest. The mean over both directions is c v^2.
fn lost(visit: &Visit<'_>) -> Outcome {
    let simulator = visit.simulator;
    let columns = super::states(visit.run);
    let parameters = visit.subject.simulation.parameter_values();
    let along = visit.run.times.iter().enumerate().map(|(row, time)| Point {
        time: *time,
        state: columns.iter().map(|column| column[row]).collect(),
        parameters: parameters.to_vec(),
    });
    let power = |point: Point| {
        let (ahead, back) = (power_at(simulator, &point, 1.0), power_at(simulator, &point, -1.0));
        let lost = f64::midpoint(ahead.dissipated, back.dissipated);
        let size = ahead.supplied.abs().max(ahead.dissipated.abs()).max(back.dissipated.abs());
        (point.time, lost, size)
    };
    let powers: Vec<_> = along.chain(visit.points.iter().cloned()).map(power).collect();
    let largest = powers.iter().fold(least_power(visit), |most, (.., size)| most.max(*size));
    let mut found = Found::nothing();
    for (time, lost, _) in powers {
        let error = if lost < 0.0 { -lost / largest } else { 0.0 };
        let error = if lost.is_nan() { f64::NAN } else { error };
        found.take(error, || format!("Worst: {lost:.3e} W at {time} s."));
    }
    Outcome::Found(found)
}

/// Returns the powers at a point with velocities multiplied by a factor.
fn power_at(simulator: &dyn Simulator<f64>, point: &Point, factor: f64) -> PowerBalance<f64> {
    let state = at_velocities(simulator, point, factor);
    simulator.power_balance(point.time, &state, &point.parameters)
}

/// Returns the state of a point with velocities multiplied by a factor.
fn at_velocities(simulator: &dyn Simulator<f64>, point: &Point, factor: f64) -> Vec<f64> {
    let mut state = point.state.clone();
    for (index, value) in state.iter_mut().enumerate() {
        if simulator.state_kind(index) == StateKind::Velocity {
            *value *= factor;
        }
    }
    state
}

/// Returns whether a mode of the run at the time of a point would have ended at the point, with
/// velocities multiplied by a factor. The forces of that mode mean nothing there: a closed contact
/// would pull.
fn leaves_modes(visit: &Visit<'_>, point: &Point, factor: f64) -> bool {
    let simulator = visit.simulator;
    let far = |other: &&Point| (other.time - point.time).abs();
    let Some(on_run) = visit.points.iter().min_by(|a, b| far(a).total_cmp(&far(b))) else {
        return false;
    };
    let guards = |state: &[f64]| {
        let mut guards = vec![0.0; simulator.events()];
        simulator.guards(point.time, state, &point.parameters, &mut guards);
        guards
    };
    let (before, here) = (guards(&on_run.state), guards(&at_velocities(simulator, point, factor)));
    (0..simulator.events()).any(|index| {
        let event = simulator.event(index);
        let is_active = event
            .when
            .iter()
            .all(|(mode, value)| point.state[*mode as usize].total_cmp(value).is_eq());
        let has_happened = match event.direction {
            Direction::Rising => before[index] <= 0.0 && here[index] > 0.0,
            Direction::Falling => before[index] >= 0.0 && here[index] < 0.0,
            Direction::Both => before[index] * here[index] < 0.0,
        };
        !event.when.is_empty() && is_active && has_happened
    })
}

fn events(visit: &Visit<'_>) -> Outcome {
    if visit.simulator.events() == 0 {
        return Outcome::Skipped("the machine has no events".to_owned());
    }
    let Some(balance) = visit.references().account() else {
        return visit.references().missing();
    };
    if visit.points.iter().any(|point| are_timed(visit, point)) {
        let why = "events go by time: what moves with time may give energy";
        return Outcome::Skipped(why.to_owned());
    }
    let passed = balance.passed.last().copied().unwrap_or(0.0);
    let scale = passed.max(balance.largest_active).max(small_energy(visit));
    let mut found = Found::nothing();
    let switches = visit.references().switches();
    for (pair, times) in balance.dissipated.windows(2).zip(visit.run.times.windows(2)) {
        if !switches.iter().any(|switch| (times[0]..=times[1]).contains(&switch.time)) {
            continue;
        }
        let shrinks = pair[0] - pair[1];
        let error = if shrinks > 0.0 { shrinks / scale } else { 0.0 };
        let error = if shrinks.is_nan() { f64::NAN } else { error };
        found
            .take(error, || format!("Worst: {shrinks:.3e} J from {} to {} s.", times[0], times[1]));
    }
    Outcome::Found(found)
}

/// Returns whether guards or new values change while only time moves.
fn are_timed(visit: &Visit<'_>, point: &Point) -> bool {
    let simulator = visit.simulator;
    let sets: usize = (0..simulator.events()).map(|event| simulator.event(event).sets.len()).sum();
    let at = |time: f64| {
        let (mut guards, mut resets) = (vec![0.0; simulator.events()], vec![0.0; sets]);
        simulator.guards(time, &point.state, &point.parameters, &mut guards);
        simulator.resets(time, &point.state, &point.parameters, &mut resets);
        guards.extend(resets);
        guards
    };
    at(point.time) != at(point.time + 1e-3 * visit.duration())
}

fn forces(visit: &Visit<'_>) -> Outcome {
    /// Factors of velocities; at the larger one, effects that grow with speed exceed those of a
    /// constant drive.
    const FASTER: [f64; 2] = [1.0, 100.0];
    let simulator = visit.simulator;
    let supplied = |point: &Point, factor: f64| power_at(simulator, point, factor).supplied;
    if visit.points.iter().any(|point| are_moved(simulator, point)) {
        let why = "constraints that move with time do work, which is supplied both ways";
        return Outcome::Skipped(why.to_owned());
    }
    let least = least_power(visit);
    let mut found = Found::nothing();
    let (mut is_timed, mut is_measured) = (false, false);
    for point in &visit.points {
        is_timed |= has_timed_energy(visit, point);
        let at_rest = supplied(point, 0.0);
        for factor in FASTER {
            let [ahead, back] = [factor, -factor].map(|f| supplied(point, f) - at_rest);
            let leaves = [factor, -factor].iter().any(|f| leaves_modes(visit, point, *f));
            if leaves || !(ahead.is_finite() && back.is_finite()) {
                continue;
            }
            is_measured = true;
            let least = factor * factor * least;
            let size = ahead.abs() + back.abs() + least;
            let error = if ahead.min(back) > 0.0 { ahead.min(back) / size } else { 0.0 };
            // Power supplied to first-order states, as by a controller that measures the speed,
            // exerts no force by itself.
            let error =
                if error > 0.0 { error.min(fed(visit, point, factor, least)) } else { error };
            found.take(error, || {
                format!("Worst at {} s: {ahead:.3e} W, and {back:.3e} W back.", point.time)
            });
        }
    }
    if !is_measured && !visit.points.is_empty() {
        let why = "the machine leaves its modes at all other velocities";
        return Outcome::Skipped(why.to_owned());
    }
    if is_timed && found.error > FORCES.tolerance {
        let why = "energies change with time: what moves with it does work, both ways";
        return Outcome::Skipped(why.to_owned());
    }
    Outcome::Found(found)
}

/// Returns whether energies change while only time moves, as for a rope that is wound up.
fn has_timed_energy(visit: &Visit<'_>, point: &Point) -> bool {
    const ROUNDINGS: f64 = 64.0;
    let energy = |time: f64| visit.simulator.energy(time, &point.state, &point.parameters);
    let (now, later) = (energy(point.time), energy(point.time + 1e-3 * visit.duration()));
    let differs = |a: f64, b: f64| (a - b).abs() > ROUNDINGS * f64::EPSILON * (a.abs() + b.abs());
    differs(now.kinetic, later.kinetic)
        || differs(now.potential, later.potential)
        || differs(now.stored, later.stored)
}

/// Returns the power that forces supply to motion, at velocities and at their negatives together,
/// relative to its parts: v^T M q'' and the dissipation. The powers of drives, springs and masses
/// in both directions cancel.
fn fed(visit: &Visit<'_>, point: &Point, factor: f64, least: f64) -> f64 {
    let simulator = visit.simulator;
    let lost = |factor: f64| power_at(simulator, point, factor).dissipated;
    let [ahead, back] = [factor, -factor].map(|factor| push_at(visit, point, factor));
    let lost = [factor, -factor].map(|factor| lost(factor) - lost(0.0));
    let parts = [ahead, back, lost[0], lost[1]];
    let size = parts.iter().map(|part| part.abs()).sum::<f64>() + least;
    (parts.iter().sum::<f64>() / size).max(0.0)
}

/// Returns v^T M q'' at velocities multiplied by a factor.
fn push_at(visit: &Visit<'_>, point: &Point, factor: f64) -> f64 {
    let simulator = visit.simulator;
    let velocities: Vec<usize> = (0..point.state.len())
        .filter(|index| simulator.state_kind(*index) == StateKind::Velocity)
        .collect();
    let point = Point { state: at_velocities(simulator, point, factor), ..point.clone() };
    let rate = visit.rate(&point);
    let pattern = simulator.mass_matrix_pattern();
    let mut masses = vec![0.0; pattern.entries.len()];
    simulator.mass_matrix(point.time, &point.state, &point.parameters, &mut masses);
    let parts = pattern.entries.iter().zip(&masses).map(|((row, column), mass)| {
        let [row, column] = [row, column].map(|index| velocities[*index as usize]);
        point.state[row] * mass * rate[column]
    });
    parts.sum()
}

/// Returns whether a constraint moves while nothing else does.
fn are_moved(simulator: &dyn Simulator<f64>, point: &Point) -> bool {
    let mut state = point.state.clone();
    for (index, value) in state.iter_mut().enumerate() {
        if simulator.state_kind(index) == StateKind::Velocity {
            *value = 0.0;
        }
    }
    let mut rates = vec![0.0; simulator.constraints()];
    simulator.constraint_rates(point.time, &state, &point.parameters, &mut rates);
    rates.iter().any(|rate| *rate != 0.0)
}
