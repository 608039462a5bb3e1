//! What parameters alone decide is computed once a run and changes no bit.

use machinist::field::{Discretisation, FieldSimulator};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_model::ModelSimulator;
use machinist_scenes::{bench, scenes};

use crate::own_scene::model_of_specs;

/// A motor's many constants, branches, factors that move with the state, a solve in a loop,
/// constraints.
const SCENES: [&str; 5] =
    ["saw_gin", "winder_full", "pendulum_chain", "winder_linkage", "slider_crank"];

fn filled(length: usize, write: impl FnOnce(&mut [f64])) -> Vec<f64> {
    let mut values = vec![f64::NAN; length];
    write(&mut values);
    values
}

fn assert_same_bits(what: &str, ours: &[f64], theirs: &[f64]) {
    let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(ours), bits(theirs), "{what}: {ours:?} for {theirs:?}");
}

/// The tapes as they were derived, and those that read constants.
#[test]
fn rate_and_jacobian_by_constants_are_those_of_the_whole_tape_to_the_last_bit() {
    for name in SCENES {
        let scene = ModelSimulator::interpreted(model_of_specs(name, Keep::Needed));
        let scene: &dyn Simulator<f64> = &scene;
        assert!(scene.constants() > 0, "{name} computes nothing once a run");
        assert_same(name, scene);
    }
}

/// What is between the nodes of all these is linear, and its part of the Jacobian a constant.
#[test]
fn of_fields_too_to_the_last_bit() {
    let scenes = scenes::FIELD_NAMES.iter().map(|name| (*name, scenes::find_field_f64(name)));
    let bench = bench::FIELD_NAMES.iter().map(|name| (*name, bench::find_field_f64(name)));
    for (name, scene) in scenes.chain(bench) {
        for order in [1, 3] {
            let wanted = Discretisation { elements: Some(12), order: Some(order) };
            let cut = FieldSimulator::new(scene.expect("built in"), wanted).expect("elements");
            let scene: &dyn Simulator<f64> = &cut;
            assert_same(name, scene);
            let nonzeros = scene.rate_jacobian_pattern().entries.len();
            assert!(scene.constants() > nonzeros, "{name}: no part of the Jacobian is constant");
        }
    }
}

fn assert_same(name: &str, scene: &dyn Simulator<f64>) {
    let shape = scene.shape();
    let nonzeros = scene.rate_jacobian_pattern().entries.len();
    for sample in 0..100_usize {
        let value = |index: usize| ((index * 7 + sample) as f64 * 0.37).sin();
        let factor = |index| 1.0 + 0.1 * value(index);
        let parameters: Vec<f64> = (0..shape.parameters)
            .map(|index| scene.parameter_default(index) * factor(index))
            .collect();
        let state: Vec<f64> =
            (0..shape.states()).map(|i| value(i) * scene.state_scale(i)).collect();
        let (t, y, p) = (0.02 * sample as f64, &state[..], &parameters[..]);
        let c = filled(scene.constants(), |values| scene.prepare(p, values));
        let plain = filled(state.len(), |values| scene.rate(t, y, p, values));
        let prepared = filled(state.len(), |values| scene.prepared_rate(t, y, p, &c, values));
        assert_same_bits(name, &prepared, &plain);
        let plain = filled(nonzeros, |values| scene.rate_jacobian(t, y, p, values));
        let prepared = filled(nonzeros, |values| scene.prepared_rate_jacobian(t, y, p, &c, values));
        assert_same_bits(name, &prepared, &plain);
        let entries = scene.parameter_jacobian_pattern().entries.len();
        let plain = filled(entries, |values| scene.parameter_jacobian(t, y, p, values));
        let by_constants = |values: &mut [f64]| {
            scene.prepared_parameter_jacobian(t, y, p, &c, values);
        };
        assert_same_bits(name, &filled(entries, by_constants), &plain);
    }
}
