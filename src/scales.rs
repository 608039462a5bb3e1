//! Scales of states for their absolute tolerances.

use machinist_contract::{Simulator, StateKind};

/// Returns the scale of every state at a start, as the spec gives it. A first-order state without a
/// scale in the spec has scale 1. It gets a smaller one if it acts strongly on a state that acts
/// weakly on it, as bristles of a micrometre do on a block of metres:
///
/// ```text
/// s_i = min(1, s_j sqrt(|J_ij / J_ji|))     for all j with which i is joined both ways
/// ```
///
/// so that errors of both have equal effects on each other (balancing of J).
pub(crate) fn scales(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    time: f64,
    state: &[f64],
) -> Vec<f64> {
    let mut scales: Vec<f64> = (0..state.len()).map(|index| simulator.state_scale(index)).collect();
    let is_open = |index: usize| {
        simulator.state_kind(index) == StateKind::FirstOrder
            && !simulator.is_mode(index)
            && scales[index].to_bits() == 1f64.to_bits()
    };
    let open: Vec<bool> = (0..state.len()).map(is_open).collect();
    if !open.contains(&true) {
        return scales;
    }
    let entries = simulator.rate_jacobian_pattern().entries;
    let mut values = vec![0.0; entries.len()];
    simulator.rate_jacobian(time, state, parameters, &mut values);
    let given = scales.clone();
    for (&(row, column), value) in entries.iter().zip(&values) {
        let (on, by) = (row as usize, column as usize);
        if !open[on] || open[by] {
            continue;
        }
        let back = entries.binary_search(&(column, row)).map_or(0.0, |index| values[index]);
        let balanced = given[by] * (value / back).abs().sqrt();
        if balanced > 0.0 && balanced < scales[on] {
            scales[on] = balanced;
        }
    }
    scales
}

/// Returns one of several states beside another, at most `reach` scales off in each entry; number 0
/// is that state itself. Modes are unchanged.
pub(crate) fn beside(
    simulator: &dyn Simulator<f64>,
    state: &[f64],
    number: usize,
    reach: f64,
) -> Vec<f64> {
    let moved = |(index, value): (usize, &f64)| {
        let wave = (1.0 + (1 + index) as f64 * 1.7 * number as f64).sin();
        let moves = number > 0 && !simulator.is_mode(index);
        value + if moves { reach * wave * simulator.state_scale(index) } else { 0.0 }
    };
    state.iter().enumerate().map(moved).collect()
}
