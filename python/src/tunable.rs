//! Parameters that can change during a run.

use machinist_contract::Simulator;

/// Returns, for each parameter, whether it may change between two segments of a run and has an
/// effect there: rate, outputs, events or times of discontinuities depend on it, constraints do
/// not. Parameters that
/// affect only the start or the constraints are not tunable.
///
/// Every function is evaluated at the start with the parameter set to NaN; a NaN result shows a
/// dependence. Rates use their sparsity pattern. In other functions, branches not taken at the
/// start are not seen.
pub fn tunable(simulator: &dyn Simulator<f64>) -> Vec<bool> {
    let shape = simulator.shape();
    let start = simulator.run_defaults().from;
    let mut parameters: Vec<f64> =
        (0..shape.parameters).map(|index| simulator.parameter_default(index)).collect();
    let mut state = vec![0.0; shape.states()];
    simulator.initial_state(&parameters, &mut state);
    let of_rate = simulator.parameter_jacobian_pattern().entries;
    let resets = (0..simulator.events()).map(|index| simulator.event(index).sets.len()).sum();
    let lengths = [shape.outputs, simulator.events(), resets, simulator.kinks()];
    let mut is_tunable = |index: usize| {
        let value = std::mem::replace(&mut parameters[index], f64::NAN);
        let p = &parameters;
        let mut seen = [0; 4].map(|_: usize| Vec::new());
        for (values, length) in seen.iter_mut().zip(lengths) {
            values.resize(length, 0.0);
        }
        let [outputs, guards, resets, kinks] = &mut seen;
        simulator.outputs(start, &state, p, outputs);
        if simulator.events() > 0 {
            simulator.guards(start, &state, p, guards);
            simulator.resets(start, &state, p, resets);
        }
        if simulator.kinks() > 0 {
            simulator.kink_guards(start, &state, p, kinks);
        }
        let mut jumps = vec![0.0; shape.discontinuities];
        simulator.discontinuities(p, &mut jumps);
        let count = simulator.constraints();
        let mut held = vec![0.0; 2 * count];
        if count > 0 {
            let (values, rates) = held.split_at_mut(count);
            simulator.constraint_values(start, &state, p, values);
            simulator.constraint_rates(start, &state, p, rates);
        }
        parameters[index] = value;
        let depends = |values: &[f64]| values.iter().any(|value| value.is_nan());
        let moves = of_rate.iter().any(|(_, column)| *column as usize == index);
        !depends(&held) && (moves || depends(&jumps) || seen.iter().any(|values| depends(values)))
    };
    (0..shape.parameters).map(&mut is_tunable).collect()
}
