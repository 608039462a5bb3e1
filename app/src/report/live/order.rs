//! Ranking of parameters by their effect on a run.
//!
//! The run itself says it: each parameter is changed a little, and the machine is run again. Runs
//! that would take too long are replaced by the rates and outputs at states of the stored run.

use machinist::Simulation;
use machinist::trajectory::{Column, ColumnKind, Trajectory};
use machinist_contract::Simulator;
use machinist_model::{Model, ModelSimulator, operations};

use crate::report::key;

/// Relative change of each parameter.
const CHANGE: f64 = 0.01;
/// Number of states of the run at which parameters are changed.
const SAMPLES: usize = 24;

/// Maximum product of parameters, rate evaluations and operations of a rate for which the machine
/// is run again.
const MOST_OPERATIONS: f64 = 5e8;
/// Limit of the steps of a changed run, relative to the stored one.
const MOST_STEPS: usize = 4;
/// Tolerance of the runs: a change by a hundredth is far above it.
const RTOL: f64 = 1e-5;
/// Standard acceleration of free fall \[m/s^2\], as specs round it.
const FREE_FALL: std::ops::Range<f64> = 9.8..9.82;

/// Returns the indices of the parameters in the order of their effect on the outputs of the run,
/// for a change of each by a hundredth: the mean difference of each output relative to its range. Parameters that are zero and gravity come last; nobody turns them first.
pub(in crate::report) fn by_run(model: &Model, run: &Trajectory) -> Vec<usize> {
    let quick = at_once(model, run);
    let operations = operations(&model.rate) as f64;
    let cost = operations * run.work.rate_evaluations as f64 * model.parameters.len() as f64;
    if cost > MOST_OPERATIONS {
        return quick;
    }
    let simulator = ModelSimulator::new(model.clone());
    let values: Vec<f64> = model.parameters.iter().map(|parameter| parameter.value).collect();
    let again = |parameters: &[f64]| {
        let steps = MOST_STEPS * run.work.steps.max(100) as usize;
        let again = Simulation::new(simulator.single()).parameters(parameters);
        again.times(&run.times).at_tolerance(RTOL.max(run.rtol)).max_steps(steps).run().ok()
    };
    let Some(base) = again(&values) else { return quick };
    let effect = |index: &usize| {
        let mut changed = values.clone();
        changed[*index] *= 1.0 + CHANGE;
        // A machine that no longer runs feels the change most.
        again(&changed).map_or(f64::MAX, |changed| difference(&base, &changed))
    };
    let mut effects = vec![0.0; values.len()];
    for index in quick.iter().filter(|index| values[**index] != 0.0) {
        effects[*index] = effect(index);
    }
    let mut order = quick;
    order.sort_by(|a, b| effects[*b].total_cmp(&effects[*a]));
    last_if_fixed(model, order)
}

/// Returns the indices of the parameters in the order of their effect on rates and outputs, without
/// another run. Gravity and parameters that are zero come last.
pub(super) fn at_once(model: &Model, run: &Trajectory) -> Vec<usize> {
    last_if_fixed(model, by_effect(model, run))
}

/// Moves gravity and parameters that are zero behind the others, in their order.
fn last_if_fixed(model: &Model, mut order: Vec<usize>) -> Vec<usize> {
    order.sort_by_key(|index| {
        let parameter = &model.parameters[*index];
        let is_gravity =
            parameter.quantity.unit == "m/s^2" && FREE_FALL.contains(&parameter.value.abs());
        is_gravity || parameter.value == 0.0
    });
    order
}

/// Returns the mean over the outputs of the mean difference of two runs, relative to the range of
/// each output.
fn difference(base: &Trajectory, changed: &Trajectory) -> f64 {
    let of_column = |column: &Column| {
        let other = changed.find(&column.name)?;
        let finite = column.values.iter().copied().filter(|value| value.is_finite());
        let (low, high) = finite
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), value| (value.min(a), value.max(b)));
        let pairs = column.values.iter().zip(&other.values);
        let off = pairs.map(|(a, b)| (a - b).abs()).filter(|off| off.is_finite());
        let mean = off.sum::<f64>() / column.values.len().max(1) as f64;
        (high > low).then(|| (mean / (high - low)).min(1.0))
    };
    let all: Vec<f64> = key::shown(base).filter_map(of_column).collect();
    all.iter().sum::<f64>() / all.len().max(1) as f64
}

/// Returns the indices of the parameters in the order of their effect: the change of rates and
/// outputs along the run and of the start state, each relative to its largest value, for a change
/// of the parameter by a hundredth.
fn by_effect(model: &Model, run: &Trajectory) -> Vec<usize> {
    let simulator = ModelSimulator::interpreted(model.clone());
    let values: Vec<f64> = model.parameters.iter().map(|parameter| parameter.value).collect();
    let states: Vec<&Column> = run.of_kind(ColumnKind::State).collect();
    let rows = run.times.len();
    let state = |row: usize| states.iter().map(|column| column.values[row]).collect::<Vec<_>>();
    let picked = (0..SAMPLES.min(rows)).map(|k| k * (rows - 1) / (SAMPLES - 1).max(1));
    let samples: Vec<(f64, Vec<f64>)> = picked.map(|row| (run.times[row], state(row))).collect();
    let numbers = |parameters: &[f64]| -> Vec<Vec<f64>> {
        let along = samples.iter().map(|(time, state)| {
            let mut numbers = vec![0.0; model.states.len() + model.wanted.len()];
            let (rate, outputs) = numbers.split_at_mut(model.states.len());
            simulator.rate(*time, state, parameters, rate);
            simulator.outputs(*time, state, parameters, outputs);
            numbers
        });
        along.collect()
    };
    let start = |parameters: &[f64]| {
        let mut start = vec![0.0; model.states.len()];
        simulator.initial_state(parameters, &mut start);
        start
    };
    let (base, base_start) = (numbers(&values), start(&values));
    let largest: Vec<f64> = (0..model.states.len() + model.wanted.len())
        .map(|k| base.iter().map(|row| row[k].abs()).fold(0.0, f64::max))
        .collect();
    let part = |change: f64, of: f64| {
        let part = if change == 0.0 { 0.0 } else { change.abs() / of.max(f64::MIN_POSITIVE) };
        if part.is_finite() { part.min(1.0) } else { 1.0 }
    };
    let effect = |index: usize| {
        let mut changed = values.clone();
        changed[index] += if changed[index] == 0.0 { CHANGE } else { CHANGE * changed[index] };
        let rows = numbers(&changed);
        let along = rows.iter().zip(&base).map(|(row, base)| {
            let pairs = row.iter().zip(base).zip(&largest);
            pairs.map(|((a, b), of)| part(a - b, *of)).sum::<f64>()
        });
        let of_start = start(&changed);
        let at_start = of_start.iter().zip(&base_start).zip(&model.states);
        let at_start = at_start.map(|((a, b), state)| part(a - b, b.abs().max(state.scale)));
        along.sum::<f64>() / samples.len().max(1) as f64 + at_start.sum::<f64>()
    };
    let effects: Vec<f64> = (0..values.len()).map(effect).collect();
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| effects[*b].total_cmp(&effects[*a]));
    order
}
