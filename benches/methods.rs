//! One run of every emitted scene by every method that suits it, from loose to
//! tight tolerances: `cargo bench -p machinist --bench methods`.

#![allow(missing_docs, reason = "what the macro of benchmarks makes")]

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use machinist::{Method, Simulation};
use machinist_scenes::scenes;

const TOLERANCES: [f64; 3] = [1e-4, 1e-6, 1e-9];

fn methods(criterion: &mut Criterion) {
    for name in scenes::NAMES {
        let Some(simulator) = scenes::find_f64(name) else { continue };
        let defaults = simulator.run_defaults();
        let ends = [defaults.from, defaults.until];
        let mut group = criterion.benchmark_group(*name);
        group.sample_size(20);
        for method in Method::compiled_in().filter(|method| method.suits(simulator)) {
            for rtol in TOLERANCES {
                let run = Simulation::new(simulator).times(&ends).rtol(rtol).method(method);
                if run.run().is_err() {
                    continue;
                }
                let id = BenchmarkId::new(method.name(), format!("{rtol:e}"));
                group.bench_function(id, |bencher| bencher.iter(|| run.run()));
            }
        }
        group.finish();
    }
}

criterion_group!(benches, methods);
criterion_main!(benches);
