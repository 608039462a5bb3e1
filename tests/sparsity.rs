//! Sparse Jacobians contain no entries that are zero except for rounding.

use machinist_bench_scenes as bench;
use machinist_contract::{Real, Simulator, SparsityPattern};
use machinist_scenes::scenes;
use machinist_studies::double_double::DoubleDouble;

use crate::place::Place;

/// Number of points at which an entry is evaluated: near the start of the scene, in all modes, and
/// with other parameters.
const PLACES: u64 = 24;

/// Returns the nonzeros of dy'/dy, then of dy'/dp.
fn nonzeros<R: Real>(at: &Place, scene: &dyn Simulator<R>) -> Vec<R> {
    let to = |values: &[f64]| values.iter().map(|v| R::literal(*v)).collect::<Vec<R>>();
    let (time, state, parameters) = (R::literal(at.time), to(&at.state), to(&at.parameters));
    let of = |pattern: SparsityPattern<'_>| vec![R::literal(0.0); pattern.entries.len()];
    let mut by_state = of(scene.rate_jacobian_pattern());
    scene.rate_jacobian(time, &state, &parameters, &mut by_state);
    let mut by_parameter = of(scene.parameter_jacobian_pattern());
    scene.parameter_jacobian(time, &state, &parameters, &mut by_parameter);
    by_state.extend(by_parameter);
    by_state
}

/// Counts entries that are rounding in double precision and vanish in 31 digits at all points.
fn zeros_in_disguise(scene: &dyn Simulator<f64>, twin: &dyn Simulator<DoubleDouble>) -> usize {
    let places: Vec<(Vec<f64>, Vec<f64>)> = (0..PLACES)
        .map(|seed| Place::near_the_start(scene, seed))
        .map(|at| {
            let precise = nonzeros(&at, twin);
            (nonzeros(&at, scene), precise.into_iter().map(DoubleDouble::to_f64).collect())
        })
        .collect();
    let entries = 0..places[0].0.len();
    let is_rounding = |entry: usize| {
        let values = places.iter().map(|(double, precise)| (double[entry], precise[entry]));
        let mut values = values.filter(|(double, _)| *double != 0.0).peekable();
        values.peek().is_some()
            && values.all(|(double, precise)| precise.abs() < 1e-8 * double.abs())
    };
    entries.filter(|entry| is_rounding(*entry)).count()
}

#[test]
fn no_entry_of_an_emitted_jacobian_is_zero_but_for_rounding() {
    let of_scenes = scenes::NAMES.iter().map(|name| (name, scenes::find(name), scenes::find(name)));
    let of_bench = bench::NAMES.iter().map(|name| (name, bench::find(name), bench::find(name)));
    let mut looked_at = 0;
    for (name, scene, twin) in of_scenes.chain(of_bench) {
        let (Some(scene), Some(twin)) = (scene, twin) else { continue };
        assert_eq!(zeros_in_disguise(scene, twin), 0, "{name}");
        looked_at += 1;
    }
    assert!(looked_at > 20, "{looked_at} scenes");
}
