//! Measured orders of convergence: one row a method.

#[path = "../../tests/common/mod.rs"]
mod common;

use super::System;
use super::fixed::{FIXED, Fixed};
use common::HardSpring;

const UNTIL: f64 = 8.0;

struct Row {
    /// How far off the measured orders may be: 13 shows only over a few halvings of
    /// large steps, and is proven by the test of its quadrature.
    within: f64,
    dense_order: f64,
    /// Two numbers of steps between which the order shows, above rounding.
    steps: [usize; 2],
}

/// One for each of [`FIXED`].
const ROWS: [Row; 6] = [
    Row { within: 0.2, dense_order: 4.0, steps: [160, 320] },
    Row { within: 0.2, dense_order: 7.0, steps: [64, 128] },
    Row { within: 0.2, dense_order: 4.0, steps: [256, 512] },
    Row { within: 0.2, dense_order: 3.0, steps: [128, 256] },
    Row { within: 0.25, dense_order: 5.0, steps: [24, 48] },
    Row { within: 0.9, dense_order: 7.0, steps: [9, 18] },
];

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |max, (a, b)| max.max((a - b).abs()))
}

const START: [f64; 2] = [1.0, 0.5];

/// States at equal times by many steps of the eighth order, 10 a unit of `parts`.
fn reference(system: &System<'_>, parts: usize) -> Vec<Vec<f64>> {
    let mut states = vec![START.to_vec()];
    let dop853 = &FIXED[1];
    assert!(dop853.run(system, &START, (UNTIL, 10 * parts), |_, _, end| states.push(end.to_vec())));
    states
}

#[test]
fn every_method_converges_at_its_order_at_the_ends_of_steps_and_between() {
    let system = System::new(&HardSpring, &[], false);
    let mut wrong = Vec::new();
    for (method, row) in FIXED.iter().zip(&ROWS) {
        let Fixed { name, order, .. } = method;
        let errors = |steps: usize| {
            let exact = reference(&system, steps);
            let mut largest = [0.0f64; 2];
            assert!(method.run(&system, &START, (UNTIL, steps), |index, between, end| {
                largest[0] = largest[0].max(distance(end, &exact[10 * index + 10]));
                largest[1] = largest[1].max(distance(between, &exact[10 * index + 3]));
            }));
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
        if (orders[0] - order).abs() > row.within || orders[1] < between - row.within {
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
        let error = distance(&method.walk(&system, &START, &steps), &START);
        assert!(error < 1e-9, "{} returns with an error of {error:e}", method.name);
    }
}
