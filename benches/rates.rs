//! Nanoseconds of one rate and of one Jacobian of every emitted scene:
//! `cargo bench -p machinist --bench rates`.

#![allow(missing_docs, reason = "what the macro of benchmarks makes")]

use std::cell::Cell;
use std::f64::consts::FRAC_PI_4;
use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use machinist_bench_scenes as bench;
use machinist_contract::Simulator;
use machinist_scenes::scenes;

/// States that a measurement cycles through, so that the branch predictor cannot learn one.
const STATES: usize = 16;

type Scene = dyn Simulator<f64>;
type Function = fn(&Scene, f64, &[f64], &[f64], &mut [f64]);

fn rates(criterion: &mut Criterion) {
    measure(criterion, "rate", |scene| scene.shape().states(), Simulator::rate);
    let entries = |scene: &Scene| scene.rate_jacobian_pattern().entries.len();
    measure(criterion, "rate_jacobian", entries, Simulator::rate_jacobian);
}

/// Times a function that writes `length` numbers, scene by scene.
fn measure(
    criterion: &mut Criterion,
    what: &str,
    length: impl Fn(&Scene) -> usize,
    function: Function,
) {
    let mut group = criterion.benchmark_group(what);
    for name in scenes::NAMES.iter().chain(bench::NAMES) {
        let Some(scene) = scenes::find_f64(name).or_else(|| bench::find_f64(name)) else {
            continue;
        };
        let parameters: Vec<f64> =
            (0..scene.shape().parameters).map(|index| scene.parameter_default(index)).collect();
        let states: Vec<Vec<f64>> = (0..STATES).map(|number| state(scene, number)).collect();
        let mut values = vec![0.0; length(scene)];
        let count = Cell::new(0);
        group.bench_function(BenchmarkId::from_parameter(name), |bencher| {
            bencher.iter(|| {
                let number = (count.get() + 1) % STATES;
                count.set(number);
                let state = black_box(&states[number]);
                function(scene, 0.01 * number as f64, state, &parameters, &mut values);
                black_box(&mut values);
            });
        });
    }
    group.finish();
}

/// Returns a state of typical size.
fn state(scene: &Scene, number: usize) -> Vec<f64> {
    let angle = |index: usize| FRAC_PI_4 * (1.0 + index as f64 + 0.3 * number as f64);
    let value = |index| 0.3 * scene.state_scale(index) * angle(index).sin();
    (0..scene.shape().states()).map(value).collect()
}

criterion_group!(benches, rates);
criterion_main!(benches);
