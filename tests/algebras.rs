//! Models derived by our own algebra, without Symbolica: the same machines, possibly with equations
//! in another form.

use std::path::Path;

use machinist::Simulation;
use machinist::field::{Discretisation, FieldSimulator};
use machinist::trajectory::{ColumnKind, Trajectory};
use machinist_algebra::cas::Algebra;
use machinist_codegen::independent::{Comparison, elements};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_contract::{Describe as _, Simulator};
use machinist_model::ModelSimulator;
use machinist_scenes::scenes;
use machinist_studies::double_double::DoubleDouble;

use crate::own_scene::{folder_of_specs, specs_in, system_of};

/// Rounding relative to the size of the terms of a number.
const LIMIT: f64 = 3e-12;
/// Random places of each scene.
const PLACES: usize = 3;

fn checked(path: &Path) -> LagrangianSystem {
    pipeline::check(path).unwrap_or_else(|errors| panic!("{}", errors.render()))
}

/// Returns the simulator that our own algebra gives.
fn plain(system: &LagrangianSystem) -> ModelSimulator {
    let model = pipeline::compile_by(Algebra::Plain, system.clone(), Keep::Needed);
    ModelSimulator::new(model.unwrap_or_else(|errors| panic!("{}", errors.render())))
}

/// Returns the largest difference from the second derivation, relative to the terms.
fn deviation(system: &LagrangianSystem, simulator: &dyn Simulator<f64>) -> f64 {
    let comparison = Comparison::new(system, simulator, DoubleDouble::to_f64);
    let comparison = comparison.unwrap_or_else(|error| panic!("{}: {error}", system.name));
    let parameters = 0..simulator.shape().parameters;
    let parameters: Vec<f64> = parameters.map(|k| simulator.parameter_default(k)).collect();
    let found = comparison.at_random(PLACES, &parameters, 0x5eed);
    assert!(found.compared > 0, "{}: nothing was compared", system.name);
    found.error
}

/// Returns that of a system with fields, divided into few elements, and the number of entries of
/// its Jacobian.
fn deviation_of_fields(system: &LagrangianSystem, simulator: &ModelSimulator) -> (f64, usize) {
    let (written_out, elements) = elements::written_out(system).expect("elements");
    let cut = Discretisation { elements: Some(elements), order: None };
    let simulator = FieldSimulator::new(simulator.with_fields(), cut).expect("it can be cut so");
    let entries = simulator.rate_jacobian_pattern().entries.len();
    (deviation(&written_out, &simulator), entries)
}

/// Returns a shaft with elements of this order, a rotor at its end and this law.
fn shaft_of(law: &str, order: usize) -> LagrangianSystem {
    let text = format!(
        r#"
[scene]
name = "shaft"
title = "Shaft"

[units.shaft]
unit = "bar"
fields = {{ phi = {{ elements = 2, order = {order} }} }}
[units.disc]
unit = "rotor"

[[joints]]
connect = ["shaft.end", "disc.shaft"]

[outputs]
angle = "disc.phi"

[tunable]
parameters = []

[run]
until = 1.0

[define.rotor.unit]
name = "rotor"
title = "Rotor"
[define.rotor.coordinates.phi]
unit = "rad"
[define.rotor.ports.shaft]
kind = "rotational"
coordinate = "phi"
[define.rotor.energy]
kinetic = "3 [kg m^2]*phi_dot^2/2"

[define.bar.unit]
name = "bar"
title = "Bar"
[define.bar.parameters.length]
value = 1.3
unit = "m"
[define.bar.fields.phi]
unit = "rad"
over = "length"
kinetic = "2 [kg m]*phi_dot^2/2"
{law}
[define.bar.ports.end]
kind = "rotational"
field = "phi"
at = "length"
"#
    );
    system_of(&text)
}

#[test]
fn fields_of_any_law_are_what_it_says_and_their_jacobians_have_no_more_entries_than_it_needs() {
    const TWIST: &str = "potential = \"500 [N m^2]*(phi_x - 0.2 [rad/m])^2/2\"";
    const STIFFENING: &str = "potential = \"500 [N m^2]*phi_x^2/2 + 90 [N m^4]*phi_x^4\"";
    const ON_GROUND: &str = "potential = \"500 [N m^2]*phi_x^2/2 + 30 [N]*phi^2/2\"";
    const DAMPED: &str = "dissipation = \"0.3 [N m^2 s]*phi_x_dot^2/2\"";
    const WEARING: &str = "dissipation = \"0.3 [N m^2 s]*phi_x_dot^4*1 [m^2 s^2]\"";
    const IN_OIL: &str = "dissipation = \"0.3 [N s]*phi_dot^2/2\"";
    const DRIVEN: &str = "force = \"2 [N]*sin(3 [1/s]*t) - 0.1 [N s^3]*phi_dot^3\"";
    // Two elements of order 1: three angles follow speeds; the nodes reach two, three and two
    // by angles, and if speeds pull at each other, as many by these.
    for (law, entries) in [
        (TWIST.to_owned(), 3 + 7),
        (STIFFENING.to_owned(), 3 + 7),
        (ON_GROUND.to_owned(), 3 + 7),
        (format!("{TWIST}\n{DAMPED}"), 3 + 14),
        (format!("{TWIST}\n{WEARING}"), 3 + 14),
        (format!("{STIFFENING}\n{IN_OIL}"), 3 + 7 + 3),
        (format!("{ON_GROUND}\n{DRIVEN}"), 3 + 7 + 3),
        (format!("{DAMPED}\n{DRIVEN}"), 3 + 7),
        (DRIVEN.to_owned(), 3 + 3),
    ] {
        for order in [1, 2, 3] {
            let system = shaft_of(&law, order);
            let (error, found) = deviation_of_fields(&system, &plain(&system));
            assert!(error <= LIMIT, "{law}, order {order}: {error:e}");
            assert!(order > 1 || found == entries, "{law}: {found} entries");
        }
    }
}

#[test]
fn every_scene_is_what_its_energies_say() {
    let paths = specs_in(&folder_of_specs());
    assert!(paths.len() > 100, "{}", paths.len());
    for path in paths {
        let system = checked(&path);
        let simulator = plain(&system);
        let error = if system.fields.is_empty() {
            deviation(&system, &simulator)
        } else {
            deviation_of_fields(&system, &simulator).0
        };
        assert!(error <= LIMIT, "{}: {error:e}", path.display());
    }
}

/// Runs at a tolerance of 1e-12.
fn run(simulator: &dyn Simulator<f64>) -> Trajectory {
    let run = Simulation::new(simulator).rtol(1e-12).run();
    run.unwrap_or_else(|error| panic!("{}: {error}", simulator.name()))
}

#[test]
fn emitted_scenes_run_as_those_derived_with_symbolica() {
    for name in scenes::NAMES {
        let simulator = plain(&checked(&folder_of_specs().join(format!("{name}.toml"))));
        let own = run(&simulator);
        let other = run(scenes::find_f64(name).expect("a scene"));
        // After impacts on a stiff layer, runs differ by more than their tolerance says.
        let limit = if *name == "winder_holder_drop" { 1e-8 } else { 1e-9 };
        for column in other.of_kind(ColumnKind::Output) {
            let size = column.values.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
            let values = own.column(&column.name).expect("the same output");
            for (a, b) in values.iter().zip(&column.values) {
                assert!((a - b).abs() <= limit * size, "{name}: {} {a:e} {b:e}", column.name);
            }
        }
    }
}
