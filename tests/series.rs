//! Emitted Taylor series equal those of the model, to high orders.

use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_contract::taylor::TaylorSeries;
use machinist_model::ModelSimulator;
use machinist_scenes::scenes;

use crate::own_scene::model_of_specs;
use crate::place::Place;

const ORDER: usize = 20;

/// Returns the coefficients from order 0 on, for all states each.
fn coefficients(series: &dyn TaylorSeries<f64>, at: &Place) -> Vec<f64> {
    let Place { time, state, parameters } = at;
    let mut coefficients = vec![0.0; (ORDER + 1) * state.len()];
    let mut workspace = vec![0.0; series.series_workspace(ORDER)];
    series.series(*time, state, parameters, &mut coefficients, &mut workspace);
    coefficients
}

#[test]
fn every_emitted_series_is_that_of_its_model() {
    let mut looked_at = 0;
    for name in scenes::NAMES {
        let Some(scene) = scenes::find_f64(name) else { continue };
        let Some(emitted) = scene.taylor() else { continue };
        let model = ModelSimulator::interpreted(model_of_specs(name, Keep::Needed));
        let model: &dyn Simulator<f64> = &model;
        let interpreted = model.taylor().expect("a series of the model");
        let states = scene.shape().states();
        for seed in 0..8 {
            let at = Place::near_the_start(scene, seed);
            let (ours, theirs) = (coefficients(emitted, &at), coefficients(interpreted, &at));
            let per_order = ours.chunks(states).zip(theirs.chunks(states)).enumerate();
            for (order, (ours, theirs)) in per_order {
                let size = theirs.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
                for (state, (ours, theirs)) in ours.iter().zip(theirs).enumerate() {
                    let what = format!("{name}, {seed}: order {order} of state {state}");
                    let allowed = 1e-6 * theirs.abs() + 1e-13 * size;
                    let is_same =
                        ours.to_bits() == theirs.to_bits() || ours.is_nan() && theirs.is_nan();
                    assert!(
                        is_same || (ours - theirs).abs() <= allowed,
                        "{what}: {ours:e} for {theirs:e}"
                    );
                }
            }
        }
        looked_at += 1;
    }
    assert!(looked_at > 15, "{looked_at} scenes");
}
