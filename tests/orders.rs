//! Measured orders of convergence, one row per method.

use crate::common::HardSpring;
use machinist::method::System;
use machinist::method::fixed::{FIXED, Fixed};
use machinist_contract::Simulator;
use machinist_studies::stability::machines::ByHand;

/// A problem with a sufficiently accurate solution.
struct Problem {
    simulator: &'static (dyn Simulator<f64> + Sync),
    start: [f64; 2],
    until: f64,
    /// Returns states at the start and at equally spaced times after it.
    exact: fn(usize) -> Vec<Vec<f64>>,
}

/// The hardening oscillator, compared with many steps of the eighth order.
static HARD: Problem =
    Problem { simulator: &HardSpring, start: [1.0, 0.5], until: 8.0, exact: hard_states };

/// x'' + 4x = 3 cos t, so x = cos t + cos 2t: orders of 9 and 13 show only over large
/// steps, which Newton's iteration takes where the Jacobian is constant.
static FORCED: Problem =
    Problem { simulator: &WAVES, start: [2.0, 0.0], until: 24.0, exact: forced_states };

static WAVES: ByHand = ByHand {
    name: "waves",
    title: "x'' + 4x = 3 cos t",
    initial: &[2.0, 0.0],
    scales: &[1.0, 1.0],
    parameters: &[],
    rate: |t, y, _, rate| rate.copy_from_slice(&[y[1], 3.0 * t.cos() - 4.0 * y[0]]),
    pattern: &[(0, 1), (1, 0)],
    jacobian: |_, _, _, values| values.copy_from_slice(&[1.0, -4.0]),
    time_derivative: |t, _, derivative| derivative.copy_from_slice(&[0.0, -3.0 * t.sin()]),
    jumps: 0,
    jump_times: |_, _| {},
    until: 24.0,
};

fn hard_states(times: usize) -> Vec<Vec<f64>> {
    let system = System::new(&HardSpring, &[], false);
    let mut states = vec![HARD.start.to_vec()];
    let dop853 = &FIXED[1];
    assert!(dop853.run(&system, &HARD.start, (HARD.until, times), |_, _, end| {
        states.push(end.to_vec());
    }));
    states
}

fn forced_states(times: usize) -> Vec<Vec<f64>> {
    let state = |index: usize| {
        let t = FORCED.until * index as f64 / times as f64;
        vec![t.cos() + (2.0 * t).cos(), -t.sin() - 2.0 * (2.0 * t).sin()]
    };
    (0..=times).map(state).collect()
}

struct Row {
    problem: &'static Problem,
    dense_order: f64,
    /// Two numbers of steps between which the order is measured, above rounding.
    steps: [usize; 2],
}

/// Tolerance of measured orders.
const WITHIN: f64 = 0.2;

/// One for each of [`FIXED`].
static ROWS: [Row; 6] = [
    Row { problem: &HARD, dense_order: 4.0, steps: [160, 320] },
    Row { problem: &HARD, dense_order: 7.0, steps: [64, 128] },
    Row { problem: &HARD, dense_order: 4.0, steps: [256, 512] },
    Row { problem: &HARD, dense_order: 3.0, steps: [128, 256] },
    Row { problem: &FORCED, dense_order: 5.0, steps: [40, 80] },
    Row { problem: &FORCED, dense_order: 7.0, steps: [22, 32] },
];

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |max, (a, b)| max.max((a - b).abs()))
}

#[test]
fn every_method_converges_at_its_order_at_the_ends_of_steps_and_between() {
    let mut wrong = Vec::new();
    for (method, row) in FIXED.iter().zip(&ROWS) {
        let Fixed { name, order, .. } = method;
        let problem = row.problem;
        let system = System::new(problem.simulator, &[], false);
        let errors = |steps: usize| {
            let exact = (problem.exact)(10 * steps);
            let mut largest = [0.0f64; 2];
            assert!(method.run(
                &system,
                &problem.start,
                (problem.until, steps),
                |index, between, end| {
                    largest[0] = largest[0].max(distance(end, &exact[10 * index + 10]));
                    largest[1] = largest[1].max(distance(between, &exact[10 * index + 3]));
                }
            ));
            largest
        };
        let (coarse, fine) = (errors(row.steps[0]), errors(row.steps[1]));
        let ratio = row.steps[1] as f64 / row.steps[0] as f64;
        let orders: [f64; 2] =
            std::array::from_fn(|index| (coarse[index] / fine[index]).log(ratio));
        println!("{name}: {orders:?}, errors {fine:?}");
        // The state between is that of the step's start, of full order, and one
        // step of the dense output, of one order more than its own.
        let order = f64::from(*order);
        let between = (row.dense_order + 1.0).min(order);
        if (orders[0] - order).abs() > WITHIN || orders[1] < between - WITHIN {
            wrong.push((name, orders));
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn steps_forth_and_back_return_to_the_start() {
    let system = System::new(&HardSpring, &[], false);
    let steps: Vec<f64> = [0.01; 100].into_iter().chain([-0.01; 100]).collect();
    for method in &FIXED {
        let error = distance(&method.walk(&system, &HARD.start, &steps), &HARD.start);
        assert!(error < 1e-9, "{} returns with an error of {error:e}", method.name);
    }
}
