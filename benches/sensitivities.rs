//! What sensitivities to ten parameters cost beside the run alone.
//!
//! `cargo bench -p machinist --bench sensitivities`
#![allow(missing_docs, reason = "the macros of criterion define undocumented functions")]

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use machinist::{Method, Simulation};
use machinist_scenes::scenes;

const BY: [&str; 10] = [
    "coupling.stiffness",
    "coupling.damping",
    "motor.inertia",
    "cylinder.inertia",
    "motor.phase_voltage",
    "motor.supply_frequency",
    "motor.k_s",
    "motor.k_r",
    "motor.x_s",
    "motor.alpha_s",
];

fn saw_gin(criterion: &mut Criterion) {
    let scene = scenes::find_f64("saw_gin").expect("it is built in");
    for (method, rtol) in [(Method::Tsit5, 1e-6), (Method::Dop853, 1e-8)] {
        let mut group = criterion.benchmark_group(format!("saw_gin, {method}, rtol {rtol:e}"));
        group.sample_size(20).measurement_time(Duration::from_secs(3));
        let run = Simulation::new(scene).method(method).rtol(rtol).points(201);
        group.bench_function("alone", |bencher| bencher.iter(|| black_box(run.run())));
        let with = run.clone().sensitivities(&BY).expect("it has these parameters");
        group.bench_function("controlled", |bencher| bencher.iter(|| black_box(with.run())));
        let free = with.with_controlled_sensitivities(false);
        group.bench_function("uncontrolled", |bencher| bencher.iter(|| black_box(free.run())));
        group.finish();
    }
}

criterion_group!(benches, saw_gin);
criterion_main!(benches);
