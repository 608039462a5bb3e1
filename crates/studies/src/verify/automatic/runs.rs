//! The run against converged ones, and its drift from constraints.

use machinist::trajectory::EnergyBalance;
use machinist::{Method, Trajectory};

use super::visit::Visit;
use super::{Found, Outcome, Row, describe, is_too_slow, states};

pub(super) const DRIFT_BEFORE: Row = Row {
    name: "off the constraints before being put back",
    reference: "moves of typical size, in tolerances of the run",
    tolerance: 1e4,
    reason: "a step errs by its tolerance, more where a constraint bends within it",
    matters: "Steps leave the constraints: the run is more wrong than its tolerance says; lower \
              `rtol`.",
    measure: drift_before,
};

pub(super) const DRIFT_AFTER: Row = Row {
    name: "off the constraints after being put back",
    reference: "moves of typical size",
    tolerance: 1e-9,
    reason: "Newton's iteration ends at rounding, more where the machine is near a dead point",
    matters: "The states of the run are off the constraints.",
    measure: drift_after,
};

pub(super) const AGREEMENT: Row = Row {
    name: "two converged runs agree",
    reference: "states of two methods at tight tolerances, in tolerances of the run",
    tolerance: 100.0,
    reason: "a hundredth of what the run may err by",
    matters: "The motion cannot be told to this tolerance: it grows whatever is off, or the rate \
              jumps where nothing says so.",
    measure: agreement,
};

pub(super) const CONVERGENCE: Row = Row {
    name: "the run at its own method and tolerance",
    reference: "a converged run: states off, in tolerances of the run",
    tolerance: 1e4,
    reason: "errors of many steps add up, and fast motions are interpolated between them",
    matters: "The run is much more wrong than its tolerance says: lower `rtol`, or choose another \
              method.",
    measure: convergence,
};

/// Methods for references, with tight tolerances and maximum numbers of steps: the machine is stiff
/// if an explicit method takes more.
const CANDIDATES: [(Method, f64, usize); 5] = [
    (Method::Dop853, 1e-12, 50_000),
    (Method::Radau, 1e-12, 50_000),
    (Method::Rodas5p, 1e-10, 100_000),
    (Method::Taylor, 1e-12, 20_000),
    (Method::Bdf, 1e-9, 100_000),
];
/// Number of states above which explicit steps follow fast waves of fields rather than stiffness, and
/// the factor on the maximum numbers of steps there.
const MANY: (usize, usize) = (100, 3);
/// Tolerance below which references are no better than the run.
const FINEST: f64 = 1e-10;
/// Part of the run around an event within which times are not compared, because states jump there.
const AROUND_EVENTS: f64 = 1e-5;

/// Converged runs of unrelated methods, at most two.
pub(super) struct References {
    runs: Vec<Trajectory>,
    failures: Vec<String>,
    is_too_slow: bool,
}

impl References {
    pub(super) fn of(visit: &Visit<'_>) -> Self {
        let mut found = Self { runs: Vec::new(), failures: Vec::new(), is_too_slow: false };
        let candidates = CANDIDATES.into_iter().filter(|(method, ..)| method.is_compiled_in());
        let is_large = visit.simulator.shape().states() > MANY.0;
        let factor = if is_large { MANY.1 } else { 1 };
        for (method, rtol, steps) in candidates {
            if found.runs.len() == 2 {
                break;
            }
            let steps = factor * steps;
            let atol: Vec<f64> = visit.sizes.iter().map(|size| rtol * size).collect();
            let run = visit.subject.simulation.clone().times(&visit.run.times).method(method);
            let run = run.rtol(rtol).atol(&atol).max_steps(steps);
            match run.with_energy_balance(found.runs.is_empty()).run() {
                Ok(run) => found.runs.push(run),
                Err(error) => {
                    found.failures.push(describe(&error));
                    found.is_too_slow |= is_too_slow(&error);
                }
            }
        }
        found
    }

    /// Returns the energy balance of the first run.
    pub(super) fn account(&self) -> Option<&EnergyBalance> {
        self.runs.first().and_then(|run| run.energy_balance.as_ref())
    }

    /// Returns the events of the first run.
    pub(super) fn switches(&self) -> &[machinist::trajectory::Switch] {
        self.runs.first().map_or(&[], |run| &run.switches)
    }

    /// Returns the result of a row that needs two references if there are fewer.
    pub(super) fn missing(&self) -> Outcome {
        let why = self.failures.join("; ");
        let why = format!("no two methods get through the run at tight tolerances: {why}");
        if self.is_too_slow { Outcome::TooSlow(why) } else { Outcome::Undone(why) }
    }
}

fn drift_before(visit: &Visit<'_>) -> Outcome {
    drift(visit, |drift| drift.before / visit.run.rtol)
}

fn drift_after(visit: &Visit<'_>) -> Outcome {
    drift(visit, |drift| drift.after)
}

fn drift(visit: &Visit<'_>, of: impl Fn(machinist::constraints::Drift) -> f64) -> Outcome {
    match visit.run.drift {
        None => Outcome::Skipped("the machine has no constraints".to_owned()),
        Some(drift) => Outcome::Found(Found { error: of(drift), place: String::new() }),
    }
}

fn agreement(visit: &Visit<'_>) -> Outcome {
    let references = visit.references();
    match references.runs.as_slice() {
        [first, second, ..] => Outcome::Found(distance(visit, second, first)),
        _ => references.missing(),
    }
}

fn convergence(visit: &Visit<'_>) -> Outcome {
    let references = visit.references();
    match references.runs.as_slice() {
        [first, _, ..] => Outcome::Found(distance(visit, visit.run, first)),
        _ => references.missing(),
    }
}

/// Returns max over states and times of |a - b|/(rtol (scale + max |b|)), except at times near an
/// event of either run.
fn distance(visit: &Visit<'_>, a: &Trajectory, b: &Trajectory) -> Found {
    let near = AROUND_EVENTS * visit.duration();
    let switches: Vec<f64> = a.switches.iter().chain(&b.switches).map(|s| s.time).collect();
    let is_near = |time: f64| switches.iter().any(|switch| (switch - time).abs() <= near);
    let rows: Vec<usize> = (0..b.times.len()).filter(|row| !is_near(b.times[*row])).collect();
    let rtol = visit.run.rtol.max(FINEST);
    let mut found = Found::nothing();
    for (index, (a, exact)) in states(a).iter().zip(states(b)).enumerate() {
        let largest = exact.iter().fold(0.0f64, |most, value| most.max(value.abs()));
        let unit = rtol * (visit.simulator.state_scale(index) + largest);
        for row in &rows {
            found.take((a[*row] - exact[*row]).abs() / unit, || {
                let name = visit.simulator.state(index).name;
                format!("Worst: {name} at {} s.", b.times[*row])
            });
        }
    }
    if a.switches.len() != b.switches.len() {
        let counts = format!("{} events for {}.", a.switches.len(), b.switches.len());
        found.place = format!("{} {counts}", found.place);
    }
    found
}
