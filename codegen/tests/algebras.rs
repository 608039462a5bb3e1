//! Comparison of models derived by Machinist's own algebra with those derived by Symbolica.
//!
//! These tests are not in the workspace's `suite`, which starts compilers: a process that has
//! used Symbolica starts no other.

use std::path::{Path, PathBuf};

use machinist_algebra::cas::Algebra;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_contract::{Describe as _, Simulator, SparsityPattern};
use machinist_model::ModelSimulator;

/// Returns the specs of a folder of scenes.
fn specs_in(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/scenes").join(folder);
    let files =
        std::fs::read_dir(folder).expect("a folder").map(|file| file.expect("a file").path());
    files.filter(|file| file.extension().is_some_and(|ending| ending == "toml")).collect()
}

/// Returns the simulator derived by an algebra.
fn derived(algebra: Algebra, system: &LagrangianSystem) -> ModelSimulator {
    let model = pipeline::compile_by(algebra, system.clone(), Keep::Needed);
    ModelSimulator::interpreted(model.unwrap_or_else(|errors| panic!("{}", errors.render())))
}

/// Returns dy'/dy, dy'/dp and dy'/dt at a place, in full.
fn derivatives(of: &ModelSimulator, t: f64, state: &[f64], parameters: &[f64]) -> Vec<f64> {
    let mut slopes = vec![0.0; state.len()];
    Simulator::<f64>::time_derivative(of, t, state, parameters, &mut slopes);
    let mut all = slopes;
    let mut spread = |pattern: &SparsityPattern, values: &[f64]| {
        let first = all.len();
        all.resize(first + pattern.rows * pattern.columns, 0.0);
        for ((row, column), value) in pattern.entries.iter().zip(values) {
            all[first + *row as usize * pattern.columns + *column as usize] = *value;
        }
    };
    let pattern = of.rate_jacobian_pattern();
    let mut values = vec![0.0; pattern.entries.len()];
    Simulator::<f64>::rate_jacobian(of, t, state, parameters, &mut values);
    spread(&pattern, &values);
    let pattern = of.parameter_jacobian_pattern();
    let mut values = vec![0.0; pattern.entries.len()];
    Simulator::<f64>::parameter_jacobian(of, t, state, parameters, &mut values);
    spread(&pattern, &values);
    all
}

#[test]
fn derivatives_are_those_of_symbolica() {
    let paths: Vec<PathBuf> = ["msl", "linkages"].into_iter().flat_map(specs_in).collect();
    assert!(paths.len() > 10, "{}", paths.len());
    for path in paths {
        let system = pipeline::check(&path).unwrap_or_else(|errors| panic!("{}", errors.render()));
        let [own, known] = [Algebra::Plain, Algebra::Symbolica].map(|by| derived(by, &system));
        let parameters = 0..own.shape().parameters;
        let parameters: Vec<f64> = parameters.map(|k| own.parameter_default(k)).collect();
        for place in 0..10_u32 {
            let entry = |k: usize| (1.7 * k as f64 + 0.9 * f64::from(place)).sin();
            let state: Vec<f64> = (0..own.shape().states()).map(entry).collect();
            let t = 0.071 * f64::from(place);
            let [a, b] = [&own, &known].map(|of| derivatives(of, t, &state, &parameters));
            assert_eq!(a.len(), b.len());
            let size = b.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
            for (a, b) in a.iter().zip(&b) {
                let is_same = (a - b).abs() <= 1e-12 * size || a.is_nan() && b.is_nan();
                assert!(is_same, "{}: {a:e} {b:e} of {size:e}", path.display());
            }
        }
    }
}
