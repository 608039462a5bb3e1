//! Models whose fields are divided into elements, on tapes, against the loops over elements of the
//! engine: every function, for several numbers and orders of elements.

use machinist::FieldSimulator;
use machinist::field::Discretisation;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe as _, Simulator};
use machinist_model::functions::{FunctionRow, Reads};
use machinist_model::{Model, ModelSimulator, SparsityPattern};

use crate::own_scene::{divided, model_of_specs, scenes_to_try};
use crate::wasm::expected;

/// A run from rest with torques, fixed ends, a constraint beside a field, contacts with events, and
/// shafts of motors.
const SCENES: [&str; 8] = [
    "bench/m3",
    "bench/m4",
    "drives/shaft_crank",
    "loom_drive",
    "reed_beat_up",
    "reed_beat_up_one_sided",
    "saw_gin_shaft",
    "shaft_step_torque",
];

/// Returns time, state and parameters near those of the spec.
fn sample(model: &Model, round: usize) -> (f64, Vec<f64>, Vec<f64>) {
    let wave = |index: usize| ((index as f64 + 1.7) * (2.3 + 0.31 * round as f64)).sin();
    let states = model.states.iter().enumerate();
    let y = states.map(|(index, state)| wave(index) * state.scale).collect();
    let p = model.parameters.iter().enumerate();
    let p = p.map(|(index, p)| p.value * (1.0 + 0.05 * wave(3 * index))).collect();
    (0.013 * round as f64, y, p)
}

/// Returns the largest difference relative to the largest entry of its row.
fn difference(found: &[f64], wanted: &[f64], row: impl Fn(usize) -> usize) -> f64 {
    assert_eq!(found.len(), wanted.len());
    let mut sizes = std::collections::BTreeMap::new();
    for (index, value) in wanted.iter().enumerate() {
        let size: &mut f64 = sizes.entry(row(index)).or_default();
        *size = size.max(value.abs());
    }
    let off = found.iter().zip(wanted).enumerate();
    off.fold(0.0, |most: f64, (index, (a, b))| {
        let (off, size) = ((a - b).abs(), sizes[&row(index)]);
        if off == 0.0 { most } else { most.max(off / size) }
    })
}

/// Returns a matrix with its zeros, row by row.
fn filled(values: &[f64], entries: &[(u32, u32)], [rows, columns]: [usize; 2]) -> Vec<f64> {
    let mut all = vec![0.0; rows * columns];
    for ((row, column), value) in entries.iter().zip(values) {
        all[*row as usize * columns + *column as usize] = *value;
    }
    all
}

/// Returns the results of a function of two machines; those of matrices with their zeros.
fn both(
    model: &Model,
    row: &FunctionRow,
    of: [&dyn Simulator<f64>; 2],
    at: (f64, &[f64], &[f64]),
    count: usize,
) -> (Vec<f64>, Vec<f64>) {
    let [found, known] = of.map(|simulator| {
        let Some(pattern) = row.pattern else {
            return expected(simulator, row.name, at, count);
        };
        let entries = match row.name {
            "rate_jacobian" => simulator.rate_jacobian_pattern().entries,
            "parameter_jacobian" => simulator.parameter_jacobian_pattern().entries,
            "mass_matrix" => simulator.mass_matrix_pattern().entries,
            _ => simulator.constraint_matrix_pattern().entries,
        };
        let values = expected(simulator, row.name, at, entries.len());
        let SparsityPattern { rows, columns, .. } = pattern(model);
        filled(&values, entries, [*rows, *columns])
    });
    (found, known)
}

#[test]
fn divided_models_compute_what_loops_over_elements_compute() {
    for name in scenes_to_try("MACHINIST_DIVIDED", &SCENES) {
        let model = model_of_specs(&name, Keep::Needed);
        if model.fields.is_empty() {
            continue;
        }
        let simulator = ModelSimulator::interpreted(model.clone());
        for (elements, order) in [(3, 1), (4, 2), (5, 4), (3, 7)] {
            let wanted = Discretisation { elements: Some(elements), order: Some(order) };
            let cut = FieldSimulator::new(simulator.with_fields(), wanted).expect("a division");
            let whole = divided(&model, wanted);
            whole.validate().unwrap_or_else(|error| panic!("{name}: {error}"));
            let twin = ModelSimulator::interpreted(whole.clone());
            let of_twin = twin.single();
            assert_eq!(cut.shape().states(), of_twin.shape().states(), "{name}");
            for round in 0..3 {
                let (t, y, p) = sample(&whole, round);
                // Slots of held branches: none is held.
                for row in whole.functions() {
                    let said = format!("{name}, {elements} of order {order}: {}", row.name);
                    let count = (row.results)(&whole);
                    if count == 0 {
                        continue;
                    }
                    let (found, known) =
                        both(&whole, row, [of_twin, cut.single()], (t, &y, &p), count);
                    let columns = row.pattern.map_or(1, |pattern| pattern(&whole).columns);
                    let is_of_nodes = row.reads == Reads::Motion && columns == 1;
                    // Forces at nodes are sums of larger ones that cancel; relative to the largest.
                    let of_row = |index: usize| if is_of_nodes { 0 } else { index / columns };
                    let error = difference(&found, &known, of_row);
                    assert!(error < 1e-9, "{said}: off by {error:e}");
                }
            }
        }
    }
}
