//! Measured order of Taylor's method at fixed orders, with constant steps.

use machinist_contract::Simulator;
use machinist_contract::taylor::value as series_value;
use machinist_scenes::scenes;

const UNTIL: f64 = 1.0;

/// Returns the state after some steps by series of an order.
fn end(simulator: &dyn Simulator<f64>, order: usize, steps: usize) -> Vec<f64> {
    let shape = simulator.shape();
    let parameters: Vec<f64> =
        (0..shape.parameters).map(|index| simulator.parameter_default(index)).collect();
    let mut state = vec![0.0; shape.states()];
    simulator.initial_state(&parameters, &mut state);
    let series = simulator.taylor().expect("an emitted scene has its series");
    let mut coefficients = vec![0.0; (order + 1) * state.len()];
    let mut workspace = vec![0.0; series.series_workspace(order)];
    let length = UNTIL / steps as f64;
    for index in 0..steps {
        let time = index as f64 * length;
        series.series(time, &state, &parameters, &mut coefficients, &mut workspace);
        series_value(&coefficients, length, &mut state);
    }
    state
}

#[test]
fn series_of_an_order_converge_at_it() {
    let simulator = scenes::find_f64("pendulum_chain").expect("built in");
    let exact = end(simulator, 20, 400);
    for (order, steps) in [(3, 400), (5, 150), (8, 40)] {
        let error = |steps| {
            let found = end(simulator, order, steps);
            found.iter().zip(&exact).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()))
        };
        let (rough, fine) = (error(steps), error(2 * steps));
        let observed = (rough / fine).log2();
        println!("order {order}: {observed:.2}, from {rough:.1e} to {fine:.1e}");
        assert!((observed - order as f64).abs() < 0.2, "order {order} shows as {observed}");
    }
}
