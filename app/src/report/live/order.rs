//! Ranking of parameters by their effect on a run.

use machinist::trajectory::{Column, ColumnKind, Trajectory};
use machinist_contract::Simulator;
use machinist_model::{Model, ModelSimulator};

/// Relative change of each parameter.
const CHANGE: f64 = 0.01;
/// Number of states of the run at which parameters are changed.
const SAMPLES: usize = 24;

/// Returns the indices of the parameters in the order of their effect: the change of rates and
/// outputs along the run and of the start state, each relative to its largest value, for a change
/// of the parameter by a hundredth.
pub(super) fn by_effect(model: &Model, run: &Trajectory) -> Vec<usize> {
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
