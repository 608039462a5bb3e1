//! Sensitivities along the run against differences of runs.

use machinist::trajectory::{ColumnKind, Trajectory};
use machinist::{Method, SimulateError, Simulation};

use super::visit::{Visit, size};
use super::{Found, Outcome, Row, Subject, own, states};
use crate::verify::machine::Point;

pub(super) const BY_DIFFERENCES: Row = Row {
    name: "sensitivities to the parameters that matter most",
    reference: "central differences of runs, over the largest of each; of fields in few elements",
    tolerance: 1e-2,
    reason: "differences of runs err by their tolerance over the step, wrong terms by far more",
    matters: "Sensitivities of this machine are not to be relied on, nor are fits.",
    measure: by_differences,
};

/// Number of varied parameters, and of times of the run.
const PARAMETERS: usize = 3;
const TIMES: usize = 20;
const RTOL: f64 = 1e-10;
const STEPS: usize = 20_000;
/// Motion, relative to its scale, below which it may be an error of steps, which is many times the
/// tolerance where a machine is at rest.
const NOTHING: f64 = 1e3 * RTOL;
/// Relative variation of parameters.
const STEP: f64 = 1e-4;
/// Relative effect on a state below which differences do not resolve it.
const LEAST: f64 = 1e-5;

fn by_differences(visit: &Visit<'_>) -> Outcome {
    let compared = match &visit.subject.in_few_elements {
        None => compared(visit),
        Some(simulation) => compared_in_few_elements(simulation),
    };
    match compared {
        Ok(found) => Outcome::Found(found),
        Err(outcome) => outcome,
    }
}

fn compared_in_few_elements(simulation: &Result<Simulation<'_>, String>) -> Result<Found, Outcome> {
    let simulation = simulation.clone().map_err(Outcome::Skipped)?;
    let none = "not asked for".to_owned();
    let subject = Subject {
        simulation,
        in_few_elements: None,
        twin: Err("not asked for"),
        independent: Err(none),
        own: Vec::new(),
        only: None,
    };
    let run = own::with_times(&subject).run().map_err(|error| Outcome::without_run(&error))?;
    compared(&Visit::new(&subject, &run))
}

fn compared(visit: &Visit<'_>) -> Result<Found, Outcome> {
    let last = visit.run.times.len() - 1;
    let mut times: Vec<f64> = (0..=TIMES).map(|k| visit.run.times[k * last / TIMES]).collect();
    times.dedup();
    let method =
        if visit.run.method.carries_sensitivities() { visit.run.method } else { Method::Auto };
    let base = visit.subject.simulation.clone().times(&times).rtol(RTOL).max_steps(STEPS);
    let base = base.method(method);
    let (run, by) = sensitivities(visit, &base)?;
    let columns = states(&run);
    let sizes: Vec<f64> =
        (0..columns.len()).map(|k| size(visit.simulator, k, columns[k], NOTHING)).collect();
    let mut ranked: Vec<(f64, usize)> =
        by.iter().map(|index| (effect(visit, (&run, &sizes), *index), *index)).collect();
    ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut found = Found::nothing();
    for (effect, index) in ranked.into_iter().take(PARAMETERS) {
        if effect > LEAST {
            compare(visit, &base, (&run, &sizes), index, &mut found)?;
        }
    }
    Ok(found)
}

/// Returns the run with its derivatives by all nonzero parameters that allow them.
fn sensitivities(
    visit: &Visit<'_>,
    base: &Simulation<'_>,
) -> Result<(Trajectory, Vec<usize>), Outcome> {
    let values = base.parameter_values();
    let mut by: Vec<usize> = (0..values.len()).filter(|index| values[*index] != 0.0).collect();
    loop {
        let names: Vec<&str> = by.iter().map(|k| visit.simulator.parameter(*k).name).collect();
        if names.is_empty() {
            let why = "there are no parameters to differentiate by";
            return Err(Outcome::Skipped(why.to_owned()));
        }
        match base.clone().sensitivities(&names).and_then(|run| run.run()) {
            Ok(run) => return Ok((run, by)),
            Err(SimulateError::NotDifferentiable { name, .. }) if names.contains(&&*name) => {
                by.retain(|index| visit.simulator.parameter(*index).name != name);
            }
            Err(error) => return Err(Outcome::without_run(&error)),
        }
    }
}

/// Returns the largest relative change of a state for one of a parameter.
fn effect(visit: &Visit<'_>, (run, sizes): (&Trajectory, &[f64]), index: usize) -> f64 {
    let value = visit.subject.simulation.parameter_values()[index].abs();
    let name = visit.simulator.parameter(index).name;
    let of = |state: usize| {
        let slopes = run.sensitivity(visit.simulator.state(state).name, name).unwrap_or_default();
        slopes.iter().fold(0.0_f64, |most, slope| most.max(slope.abs())) * value / sizes[state]
    };
    (0..sizes.len()).map(of).fold(0.0, f64::max)
}

fn compare(
    visit: &Visit<'_>,
    base: &Simulation<'_>,
    (run, sizes): (&Trajectory, &[f64]),
    index: usize,
    found: &mut Found,
) -> Result<(), Outcome> {
    let name = visit.simulator.parameter(index).name;
    let value = base.parameter_values()[index];
    let step = STEP * value.abs();
    let at = |times: f64| {
        let run = base.clone().parameter(name, value + times * step).and_then(|run| run.run());
        run.map_err(|error| Outcome::without_run(&error))
    };
    let [near, far] = [(at(1.0)?, at(-1.0)?), (at(2.0)?, at(-2.0)?)];
    let slopes = |pair: &(Trajectory, Trajectory), times: f64, state: usize, row: usize| {
        (states(&pair.0)[state][row] - states(&pair.1)[state][row]) / (2.0 * times * step)
    };
    // Runs are compared between the same events: where one run has passed an event and another has
    // not, their difference is no derivative.
    let passed = |run: &Trajectory, time: f64| {
        run.switches.iter().filter(|switch| switch.time <= time).count()
    };
    let all = [(&near.0, 1.0), (&near.1, -1.0), (&far.0, 2.0), (&far.1, -2.0)];
    let side = |run: &Trajectory, times: f64, row: usize| {
        let mut parameters = base.parameter_values().to_vec();
        parameters[index] += times * step;
        let state = states(run).iter().map(|column| column[row]).collect();
        visit.branches(&Point { time: run.times[row], state, parameters })
    };
    // Runs must also be on one side of switching surfaces, at which times of the run may lie.
    let is_on_one_side = |row: usize| {
        let here = side(run, 0.0, row);
        all.iter().all(|(other, times)| side(other, *times, row) == here)
    };
    let is_alike = |row: usize| {
        let time = run.times[row];
        all.iter().all(|(other, _)| passed(other, time) == passed(run, time)) && is_on_one_side(row)
    };
    let rows: Vec<usize> = (0..run.times.len()).filter(|row| is_alike(*row)).collect();
    for (state, column) in run.of_kind(ColumnKind::State).enumerate() {
        let Some(own) = run.sensitivity(&column.name, name) else { continue };
        let size = own.iter().fold(0.0_f64, |most, slope| most.max(slope.abs()));
        if size * value.abs() <= LEAST * sizes[state] || visit.simulator.is_mode(state) {
            continue;
        }
        for (row, slope) in rows.iter().map(|row| (*row, own[*row])) {
            let (one, two) = (slopes(&near, 1.0, state, row), slopes(&far, 2.0, state, row));
            // Deviations count only as far as differences themselves are accurate. Where a switch
            // lies between the runs, they err in proportion to their step: by as much as one over
            // twice the step differs from it.
            let off = ((slope - one).abs() - 2.0 * (one - two).abs()).max(0.0);
            found.take(off / size, || {
                format!("Worst: {} by {name} at {} s.", column.name, run.times[row])
            });
        }
    }
    Ok(())
}
