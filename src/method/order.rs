//! Measured orders of convergence: one row a method.

#[path = "../../tests/common/mod.rs"]
mod common;

use super::explicit::ExplicitSteps;
use super::one_step::{OneStep, Trial};
use super::radau::RadauSteps;
use super::rosenbrock::RosenbrockSteps;
use super::tableau::{DOP853, RODAS5P, TSIT5};
use super::{Stretch, System};
use common::HardSpring;

const UNTIL: f64 = 8.0;

type Make = for<'a> fn(&'a Stretch<'a>) -> Box<dyn OneStep + 'a>;

struct Row {
    name: &'static str,
    make: Make,
    order: f64,
    dense_order: f64,
    /// How far off the measured orders may be: 13 shows only over a few halvings of
    /// large steps, and is proven by the test of its quadrature.
    within: f64,
    /// Two numbers of steps between which the order shows, above rounding.
    steps: [usize; 2],
}

const ROWS: &[Row] = &[
    Row {
        name: "tsit5",
        make: |stretch| Box::new(ExplicitSteps::new(&TSIT5, stretch)),
        order: 5.0,
        dense_order: 4.0,
        within: 0.2,
        steps: [160, 320],
    },
    Row {
        name: "dop853",
        make: |stretch| Box::new(ExplicitSteps::new(&DOP853, stretch)),
        order: 8.0,
        dense_order: 7.0,
        within: 0.2,
        steps: [64, 128],
    },
    Row {
        name: "rodas5p",
        make: |stretch| Box::new(RosenbrockSteps::new(&RODAS5P, stretch)),
        order: 5.0,
        dense_order: 4.0,
        within: 0.2,
        steps: [256, 512],
    },
    Row {
        name: "radau, 3 stages",
        make: |stretch| Box::new(RadauSteps::new(stretch).of_stages(3)),
        order: 5.0,
        dense_order: 3.0,
        within: 0.2,
        steps: [128, 256],
    },
    Row {
        name: "radau, 5 stages",
        make: |stretch| Box::new(RadauSteps::new(stretch).of_stages(5)),
        order: 9.0,
        dense_order: 5.0,
        within: 0.25,
        steps: [24, 48],
    },
    Row {
        name: "radau, 7 stages",
        make: |stretch| Box::new(RadauSteps::new(stretch).of_stages(7)),
        order: 13.0,
        dense_order: 7.0,
        within: 0.9,
        steps: [9, 18],
    },
];

/// Steps a hard spring by so many equal steps, and hands over the states at
/// 0.3 of each step and at its end.
fn run(row: &Row, steps: usize, from: &[f64], mut at: impl FnMut(usize, &[f64], &[f64])) {
    let system = System::new(&HardSpring, &[], false);
    let stretch = Stretch::for_test(&system, 0.0, UNTIL, &[1e-6, 1e-6]);
    let mut method = (row.make)(&stretch);
    method.begin(0.0, from);
    let step = UNTIL / steps as f64;
    let mut between = vec![0.0; from.len()];
    for index in 0..steps {
        // What the method takes for its error is of no interest here.
        assert!(matches!(method.attempt(step), Trial::Error(_)), "{}", row.name);
        method.interpolate((index as f64 + 0.3) * step, &mut between);
        at(index, &between, method.end());
        method.accept();
    }
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |max, (a, b)| max.max((a - b).abs()))
}

const START: [f64; 2] = [1.0, 0.5];

/// States at equal times by many steps of the eighth order, 10 a unit of `parts`.
fn reference(parts: usize) -> Vec<Vec<f64>> {
    let mut states = vec![START.to_vec()];
    let system = System::new(&HardSpring, &[], false);
    let stretch = Stretch::for_test(&system, 0.0, UNTIL, &[1e-6, 1e-6]);
    let mut method = ExplicitSteps::new(&DOP853, &stretch);
    method.begin(0.0, &START);
    for _ in 0..parts * 10 {
        assert!(matches!(method.attempt(UNTIL / (parts * 10) as f64), Trial::Error(_)));
        method.accept();
        states.push(method.end().to_vec());
    }
    states
}

#[test]
fn every_method_converges_at_its_order_at_the_ends_of_steps_and_between() {
    let mut wrong = Vec::new();
    for row in ROWS {
        let errors = |steps: usize| {
            let exact = reference(steps);
            let mut largest = [0.0f64; 2];
            run(row, steps, &START, |index, between, end| {
                largest[0] = largest[0].max(distance(end, &exact[10 * index + 10]));
                largest[1] = largest[1].max(distance(between, &exact[10 * index + 3]));
            });
            largest
        };
        let (coarse, fine) = (errors(row.steps[0]), errors(row.steps[1]));
        let ratio = row.steps[1] as f64 / row.steps[0] as f64;
        let orders: [f64; 2] =
            std::array::from_fn(|index| (coarse[index] / fine[index]).log(ratio));
        println!("{}: {orders:?}, errors {fine:?}", row.name);
        // The state between is that of the step's start, of full order, and one
        // step of the dense output, of one order more than its own.
        let between = (row.dense_order + 1.0).min(row.order);
        if (orders[0] - row.order).abs() > row.within || orders[1] < between - row.within {
            wrong.push((row.name, orders));
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn steps_forth_and_back_return_to_the_start() {
    for row in ROWS {
        let system = System::new(&HardSpring, &[], false);
        let stretch = Stretch::for_test(&system, -1.0, UNTIL, &[1e-6, 1e-6]);
        let mut method = (row.make)(&stretch);
        method.begin(0.0, &START);
        for step in [0.01; 100].into_iter().chain([-0.01; 100]) {
            assert!(matches!(method.attempt(step), Trial::Error(_)));
            method.accept();
        }
        let error = distance(method.end(), &START);
        assert!(error < 1e-9, "{} returns with an error of {error:e}", row.name);
    }
}
