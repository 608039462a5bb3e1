//! Times of a rate and of a Jacobian, as methods call them: constants are computed before.

use std::hint::black_box;
use std::time::Instant;

use machinist_contract::Simulator;

/// Calls of a round, and rounds of which the fastest counts.
const CALLS: u32 = 10_000;
const ROUNDS: u32 = 9;

/// Times of a machine, and its results at the start.
pub struct Measured {
    /// Least times of a rate and of a Jacobian \[ns\].
    pub times: [f64; 2],
    /// y'.
    pub rate: Vec<f64>,
    /// Nonzeros of dy'/dy.
    pub jacobian: Vec<f64>,
}

/// Measures a machine at a state and parameters. One coordinate moves a little at each call.
pub fn measure(simulator: &dyn Simulator<f64>, state: &[f64], parameters: &[f64]) -> Measured {
    let mut constants = vec![0.0; simulator.constants()];
    simulator.prepare(parameters, &mut constants);
    let mut rate = vec![0.0; state.len()];
    let mut jacobian = vec![0.0; simulator.rate_jacobian_pattern().entries.len()];
    let of_rate = least(state, |y| {
        simulator.prepared_rate(0.0, y, parameters, &constants, &mut rate);
        black_box(&mut rate);
    });
    let of_jacobian = least(state, |y| {
        simulator.prepared_rate_jacobian(0.0, y, parameters, &constants, &mut jacobian);
        black_box(&mut jacobian);
    });
    simulator.prepared_rate(0.0, state, parameters, &constants, &mut rate);
    simulator.prepared_rate_jacobian(0.0, state, parameters, &constants, &mut jacobian);
    Measured { times: [of_rate, of_jacobian], rate, jacobian }
}

/// Returns the least time of a call in nanoseconds.
fn least(state: &[f64], mut call: impl FnMut(&[f64])) -> f64 {
    let mut state = state.to_vec();
    let round = |_| {
        let begin = Instant::now();
        for _ in 0..CALLS {
            state[0] += 1e-9;
            call(black_box(&state));
        }
        begin.elapsed().as_secs_f64() * 1e9 / f64::from(CALLS)
    };
    (0..ROUNDS).map(round).fold(f64::INFINITY, f64::min)
}
