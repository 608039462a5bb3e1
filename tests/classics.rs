//! Problems of the literature against their published values, at a loose and a tight tolerance;
//! `cargo test -p machinist-tests classics -- --nocapture` prints the errors.

use std::path::Path;

use machinist::Simulation;
use machinist::trajectory::Trajectory;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::{Check, Reference};

use crate::own_scene::of_specs;

/// Maximum errors at tolerances of 1e-6 and 1e-10: errors of single steps grow by a
/// problem-dependent factor until the time of the reference.
const SCENES: [(&str, [f64; 2]); 11] = [
    ("arenstorf", [1e-5, 2e-8]),
    ("cycloid", [3e-6, 1e-9]),
    ("hires", [2e-6, 2e-10]),
    ("kepler", [1e-4, 1e-8]),
    ("oregonator", [3e-6, 1e-10]),
    ("pleiades", [2e-3, 1e-6]),
    ("pollution", [3e-7, 1e-11]),
    ("ring_modulator", [2e-5, 3e-9]),
    ("robertson", [2e-6, 1e-7]),
    ("squeezer", [3e-5, 3e-9]),
    ("van_der_pol", [5e-5, 1e-9]),
];

#[test]
fn published_values_are_met_at_a_loose_and_at_a_tight_tolerance() {
    let mut wrong = Vec::new();
    for (name, limits) in SCENES {
        let scene = of_specs(&format!("classics/{name}"), Keep::Needed);
        let checks = &scene.model().checks;
        let times: Vec<f64> = checks.iter().flat_map(times).collect();
        for (rtol, limit) in [1e-6, 1e-10].into_iter().zip(limits) {
            let run = Simulation::new(&scene).rtol(rtol).points(2).also_at(&times);
            let parameters = run.parameter_values().to_vec();
            let run = run.run().expect("it runs");
            let errors = checks.iter().map(|check| error(&run, check, &parameters));
            let error = errors.fold(0.0, f64::max);
            println!("{name:15} {rtol:.0e}: {error:.1e}");
            if error > limit || error.is_nan() {
                wrong.push(format!("{name} at {rtol:.0e}: {error:.1e}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn every_classic_is_held_against_something() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/scenes/classics");
    let files = std::fs::read_dir(folder).expect("the folder");
    let stem = |path: &Path| path.file_stem().expect("a name").to_string_lossy().into_owned();
    let mut found: Vec<String> = files.map(|file| stem(&file.expect("a file").path())).collect();
    found.sort();
    assert_eq!(found, SCENES.map(|(name, _)| name.to_owned()));
}

/// Returns the times of a check.
fn times(check: &Check) -> Vec<f64> {
    match &check.reference {
        Reference::Values(rows) => rows.iter().map(|[time, _]| *time).collect(),
        Reference::Closed(_) => (0..=40).map(|half| f64::from(half) / 2.0).collect(),
    }
}

/// Returns the largest error, relative to the largest value of the reference.
fn error(run: &Trajectory, check: &Check, parameters: &[f64]) -> f64 {
    let times = times(check);
    let values: Vec<f64> = match &check.reference {
        Reference::Values(rows) => rows.iter().map(|[_, value]| *value).collect(),
        Reference::Closed(closed) => closed.values(&times, parameters),
    };
    // A quantity that returns to zero is measured by its earlier values.
    let size = values.iter().map(|value| value.abs()).fold(0.0, f64::max);
    let size = if size > 0.0 { size } else { 1.0 };
    let column = run.column(&check.of).expect("what is checked");
    let off = times.iter().zip(&values).map(|(time, value)| {
        let row = run.times.partition_point(|row| row < time);
        (column[row] - value).abs()
    });
    off.fold(0.0, f64::max) / size
}
