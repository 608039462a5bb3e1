//! Emitted scenes against a second derivation of their specs, which takes no computer algebra
//! and none of what the first one is made of.

use std::path::{Path, PathBuf};

use machinist::field::{Discretisation, FieldSimulator};
use machinist_codegen::independent::{Comparison, Deviation, elements};
use machinist_codegen::pipeline;
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_contract::Simulator;
use machinist_scenes::scenes;
use machinist_studies::double_double::DoubleDouble;

/// Rounding of emitted code beside the size of what its numbers are put together from.
const LIMIT: f64 = 1e-12;
/// Random places of each scene.
const PLACES: usize = 20;

fn spec(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/scenes").join(format!("{name}.toml"))
}

fn system(name: &str) -> LagrangianSystem {
    pipeline::check(&spec(name)).unwrap_or_else(|errors| panic!("{}", errors.render()))
}

fn deviation(system: &LagrangianSystem, simulator: &dyn Simulator<f64>) -> Deviation {
    let comparison = Comparison::new(system, simulator, DoubleDouble::to_f64);
    let comparison = comparison.unwrap_or_else(|error| panic!("{}: {error}", system.name));
    let parameters = 0..simulator.shape().parameters;
    let parameters: Vec<f64> = parameters.map(|k| simulator.parameter_default(k)).collect();
    comparison.at_random(PLACES, &parameters, 0x5eed)
}

fn assert_small(name: &str, found: &Deviation) {
    println!("{name}: {:.1e} of {}, {}", found.error, found.compared, found.place);
    assert!(found.error <= LIMIT, "{name}: {found:?}");
    assert!(found.compared > PLACES, "{name}: {found:?}");
}

#[test]
fn emitted_scenes_are_what_their_energies_say() {
    for name in scenes::NAMES {
        let simulator = scenes::find_f64(name).expect("a scene");
        assert_small(name, &deviation(&system(name), simulator));
    }
}

#[test]
fn emitted_fields_are_what_their_densities_say() {
    for name in scenes::FIELD_NAMES {
        let scene = scenes::find_field::<f64>(name).expect("a scene");
        let (written_out, elements) = elements::written_out(&system(name)).expect("elements");
        let cut = Discretisation { elements: Some(elements), order: None };
        let simulator = FieldSimulator::new(scene, cut).expect("it can be cut so");
        assert_small(name, &deviation(&written_out, &simulator));
    }
}
