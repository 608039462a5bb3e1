//! Constants of the parameters are computed once per run without a change of any bit.

use machinist::complex_step::dense;
use machinist::field::{Discretisation, FieldSimulator};
use machinist_bench_scenes as bench;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Real as _, Simulator};
use machinist_model::ModelSimulator;
use machinist_scenes::scenes;
use machinist_studies::double_double::DoubleDouble;
use nalgebra::DMatrix;

use crate::own_scene::model_of_specs;
use crate::place::Place;

/// A motor with many constants, branches, factors that depend on the state, a solution in a loop,
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

/// Tapes as derived, and tapes that read constants.
#[test]
fn rate_and_jacobian_by_constants_are_those_of_the_whole_tape_to_the_last_bit() {
    for name in SCENES {
        let scene = ModelSimulator::interpreted(model_of_specs(name, Keep::Needed));
        let scene: &dyn Simulator<f64> = &scene;
        assert!(scene.constants() > 0, "{name} computes nothing once a run");
        assert_same(name, scene);
    }
}

/// The fields of these scenes are linear, so their part of the Jacobian is constant.
#[test]
fn of_fields_too_to_the_last_bit() {
    let scenes = scenes::FIELD_NAMES.iter().map(|name| (*name, scenes::find_field_f64(name)));
    let bench = bench::FIELD_NAMES.iter().map(|name| (*name, bench::find_field_f64(name)));
    for (name, scene) in scenes.chain(bench) {
        let scene = scene.expect("built in");
        // Elements of order 1 have a special method for rates; with few elements, no node lies
        // between two others.
        let mut cuts = vec![(12, 1), (12, 2), (12, 3)];
        let all_few = (1..6).map(|elements| (elements, 1));
        cuts.extend(all_few.filter(|cut| FieldSimulator::new(scene, wanted(*cut)).is_ok()));
        assert!(cuts.len() > 3, "{name}: no few elements");
        for cut in cuts {
            let cut = FieldSimulator::new(scene, wanted(cut)).expect("elements");
            let scene: &dyn Simulator<f64> = &cut;
            assert_same(name, scene);
            let nonzeros = scene.rate_jacobian_pattern().entries.len();
            assert!(scene.constants() > nonzeros, "{name}: no part of the Jacobian is constant");
        }
    }
}

fn wanted((elements, order): (usize, usize)) -> Discretisation {
    Discretisation { elements: Some(elements), order: Some(order) }
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
        let by_parameters = filled(entries, by_constants);
        assert_same_bits(name, &by_parameters, &plain);
        let at_once = filled(nonzeros + entries, |values| {
            scene.prepared_jacobians(t, y, p, &c, values);
        });
        assert_same_bits(name, &at_once, &[prepared, by_parameters].concat());
    }
}

/// Machine code of both Jacobians at once, compared with the tape of each.
#[test]
fn compiled_at_once_too_to_the_last_bit() {
    for name in ["saw_gin", "winder_linkage"] {
        let model = model_of_specs(name, Keep::Needed);
        assert_eq!(model.gives_jacobians_at_once(), name == "saw_gin");
        let (scene, tapes) =
            (ModelSimulator::compiled_at_once(model.clone()), ModelSimulator::interpreted(model));
        let (scene, tapes): (&dyn Simulator<f64>, &dyn Simulator<f64>) = (&scene, &tapes);
        assert_same(name, scene);
        let lengths = [scene.rate_jacobian_pattern(), scene.parameter_jacobian_pattern()];
        let [nonzeros, entries] = lengths.map(|pattern| pattern.entries.len());
        for seed in 0..20 {
            let at = Place::near_the_start(scene, seed);
            let (t, y, p) = (at.time, &at.state[..], &at.parameters[..]);
            let c = filled(scene.constants(), |values| scene.prepare(p, values));
            let at_once = filled(nonzeros + entries, |values| {
                scene.prepared_jacobians(t, y, p, &c, values);
            });
            let apart = [
                filled(nonzeros, |values| tapes.rate_jacobian(t, y, p, values)),
                filled(entries, |values| tapes.parameter_jacobian(t, y, p, values)),
            ];
            assert_same_bits(name, &at_once, &apart.concat());
        }
    }
}

/// The function for both Jacobians is compared with that of dy'/dy, to the last bit, and with
/// central differences of the rate in 31 digits, whose error is below our rounding.
#[test]
fn emitted_jacobians_at_once_are_the_slopes_of_the_rate() {
    let of_scenes =
        scenes::NAMES.iter().map(|name| (name, scenes::find_f64(name), scenes::find(name)));
    let of_bench = bench::NAMES.iter().map(|name| (name, bench::find_f64(name), bench::find(name)));
    let mut looked_at = 0;
    for (name, scene, twin) in of_scenes.chain(of_bench) {
        let (Some(scene), Some(twin)) = (scene, twin) else { continue };
        let patterns = [scene.rate_jacobian_pattern(), scene.parameter_jacobian_pattern()];
        let [nonzeros, entries] = patterns.map(|pattern| pattern.entries.len());
        for seed in 0..4 {
            let at = Place::near_the_start(scene, seed);
            let (t, y, p) = (at.time, &at.state[..], &at.parameters[..]);
            let c = filled(scene.constants(), |values| scene.prepare(p, values));
            let ours = filled(nonzeros + entries, |values| {
                scene.prepared_jacobians(t, y, p, &c, values);
            });
            let alone =
                filled(nonzeros, |values| scene.prepared_rate_jacobian(t, y, p, &c, values));
            assert_same_bits(name, &ours[..nonzeros], &alone);
            let ours =
                [dense(patterns[0], &ours[..nonzeros]), dense(patterns[1], &ours[nonzeros..])];
            let slopes = differences(twin, &at);
            let largest = slopes[0].amax().max(slopes[1].amax());
            for (ours, slopes) in ours.iter().zip(&slopes) {
                for (row, slopes) in slopes.row_iter().enumerate() {
                    let off = (ours.row(row) - slopes).amax();
                    // Where a whole row is zero, differences have a rounding error of their own.
                    let allowed = 1e-10 * slopes.amax() + 1e-16 * largest;
                    assert!(off <= allowed, "{name}: {off:e}, not {allowed:e}, in row {row}");
                }
            }
        }
        looked_at += 1;
    }
    assert!(looked_at > 20, "{looked_at} scenes");
}

/// Returns dy'/dy and dy'/dp by central differences of the rate in 31 digits.
fn differences(twin: &dyn Simulator<DoubleDouble>, at: &Place) -> [DMatrix<f64>; 2] {
    let to = |values: &[f64]| -> Vec<DoubleDouble> {
        values.iter().map(|value| DoubleDouble::literal(*value)).collect()
    };
    let rate = |given: &[Vec<DoubleDouble>; 2]| {
        let mut rate = vec![DoubleDouble::literal(0.0); at.state.len()];
        twin.rate(DoubleDouble::literal(at.time), &given[0], &given[1], &mut rate);
        rate
    };
    [0, 1].map(|varied| {
        let mut given = [to(&at.state), to(&at.parameters)];
        let count = given[varied].len();
        let mut matrix = DMatrix::zeros(at.state.len(), count);
        for column in 0..count {
            let value = given[varied][column];
            let size = value.to_f64().abs();
            let step = 1e-10 * if size > 0.0 { size } else { 1.0 };
            let [ahead, here, behind] = [step, 0.0, -step].map(|step| {
                given[varied][column] = value + DoubleDouble::literal(step);
                rate(&given)
            });
            given[varied][column] = value;
            for (row, here) in here.into_iter().enumerate() {
                let sides =
                    [(ahead[row] - here), (here - behind[row])].map(|by| by.to_f64() / step);
                let [ahead, behind] = sides;
                // A number that is 0 may switch a law on. The law that holds is the one on the side
                // on which the rate does not jump.
                let change = step * ahead.abs().max(behind.abs());
                let jumps = size == 0.0 && change > 1e-6 * (1.0 + here.to_f64().abs());
                matrix[(row, column)] = match jumps {
                    true if ahead.abs() < behind.abs() => ahead,
                    true => behind,
                    false => 0.5 * (ahead + behind),
                };
            }
        }
        matrix
    })
}
