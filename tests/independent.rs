//! Emitted scenes against a second derivation of their specs, which takes no computer algebra
//! and none of what the first one is made of.

use std::path::{Path, PathBuf};

use machinist::field::{Discretisation, FieldSimulator};
use machinist_codegen::independent::{Comparison, Deviation, elements};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_contract::{Describe as _, Simulator};
use machinist_model::ModelSimulator;
use machinist_scenes::scenes;
use machinist_studies::double_double::DoubleDouble;

use crate::own_scene::system_of;

/// Rounding of emitted code relative to the size of the terms of its numbers.
const LIMIT: f64 = 1e-12;
/// Number of random points of each scene.
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

/// Rotors on a belt that is taken for rigid, one on a spring, the other driven and braked.
const FROZEN: &str = r#"
[scene]
name = "frozen"
source = "Textbook."

[units.a]
unit = "rotational/inertia"
parameters = { inertia = 2 }

[units.b]
unit = "rotational/inertia"

[units.belt]
unit = "rotational/belt"

[units.spring]
unit = "rotational/spring"

[units.wall]
unit = "rotational/fixed"

[units.drive]
unit = "sources/torque"
inputs = { torque = "3 [N m]*sin(2 [1/s]*t) - 0.3 [N m s^2]*a.omega^2" }

[[joints]]
connect = ["drive.a", "a.a"]

[[joints]]
connect = ["a.b", "belt.a"]

[[joints]]
connect = ["belt.b", "b.a"]

[[joints]]
connect = ["b.b", "spring.a"]

[[joints]]
connect = ["spring.b", "wall.a"]

[outputs]
a = "a.omega"
b = { expression = "b.alpha - 2*a.alpha", unit = "rad/s^2" }

[freeze]
rigid = ["belt"]
tolerance = 0.1

[run]
until = 1.0
points = 11
rtol = 1e-6
method = "dop853"
"#;

#[test]
fn what_is_taken_for_rigid_follows_as_its_spring_at_rest_says() {
    let mut system = system_of(FROZEN);
    for (keep, states) in [(Keep::All, 4), (Keep::Exact, 4), (Keep::Needed, 2)] {
        let model = pipeline::compile(system.clone(), keep)
            .unwrap_or_else(|errors| panic!("{}", errors.render()));
        assert_eq!(model.states.len(), states);
        let simulator = ModelSimulator::new(model);
        let mut own = system.clone();
        if keep < Keep::Needed {
            own.freeze.rigid.clear();
        }
        assert_small("frozen", &deviation(&own, &simulator));
    }
    // Another machine is none of these.
    let model = pipeline::compile(system.clone(), Keep::Needed);
    let model = model.unwrap_or_else(|errors| panic!("{}", errors.render()));
    let simulator = ModelSimulator::new(model);
    system.generalized_force.swap(0, 1);
    assert!(deviation(&system, &simulator).error > 1e-3);
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

/// Returns an arm of links that turn about z and y in turn, with rotations and places as helpers that
/// use those of the link before.
fn arm_by_helpers(links: usize) -> String {
    let mut text =
        "[scene]\nname = \"arm\"\n[units.c]\nunit = \"c\"\n[run]\nuntil = 1\n".to_owned();
    let (mut helpers, mut kinetic, mut potential) = (String::new(), Vec::new(), Vec::new());
    for link in 1..=links {
        text.extend([format!(
            "[define.c.coordinates.q{link}]\nunit = \"rad\"\nvelocity = \"w{link}\"\n"
        )]);
        let (c, s) = (format!("cos(q{link})"), format!("sin(q{link})"));
        let before = |row: usize, column: usize| match (link, row == column) {
            (1, is_one) => u8::from(is_one).to_string(),
            _ => format!("r{}_{row}{column}", link - 1),
        };
        let [first, last] = if link % 2 == 1 { [1, 2] } else { [3, 1] };
        for row in 1..=3 {
            for column in 1..=3 {
                let [a, b] = [first, last].map(|column| before(row, column));
                let entry = if column == first {
                    format!("{a}*{c} + {b}*{s}")
                } else if column == last {
                    format!("{b}*{c} - {a}*{s}")
                } else {
                    before(row, column)
                };
                helpers.extend([format!(
                    "r{link}_{row}{column} = {{ expression = \"{entry}\", unit = \"1\" }}\n"
                )]);
            }
            let place = if link == 1 { String::new() } else { format!("p{}_{row} + ", link - 1) };
            helpers.extend([format!(
                "p{link}_{row} = {{ expression = \"{place}0.4 [m]*r{link}_{row}1 + 0.1 [m]*r{link}_{row}3\", unit = \"m\" }}\n"
            )]);
        }
        let squares = [1, 2, 3].map(|row| format!("der(p{link}_{row})^2"));
        kinetic.push(format!("1.5 [kg]*({})/2 + 0.2 [kg m^2]*w{link}^2/2", squares.join(" + ")));
        potential.push(format!("1.5 [kg]*9.81 [m/s^2]*p{link}_3"));
    }
    let (kinetic, potential) = (kinetic.join(" + "), potential.join(" + "));
    format!(
        "{text}[define.c.helpers]\n{helpers}[define.c.energy]\nkinetic = \"{kinetic}\"\npotential = \"{potential}\"\n"
    )
}

/// Written out, a helper of its last link would have thousands of terms.
#[test]
fn an_arm_by_helpers_of_each_other_moves_as_its_energies_say() {
    let system = system_of(&arm_by_helpers(5));
    let model = pipeline::compile(system.clone(), Keep::Needed);
    let model = ModelSimulator::new(model.unwrap_or_else(|errors| panic!("{}", errors.render())));
    assert_small("arm", &deviation(&system, model.single()));
}

/// Only the long helper contains the second coordinate and the parameter.
#[test]
fn reduction_keeps_what_only_a_long_helper_contains() {
    let terms: Vec<String> = (1..=40).map(|k| format!("p*sin(q1 + q2/{k})")).collect();
    let text = format!(
        r#"
[scene]
name = "alone"
[units.c]
unit = "c"
[outputs]
angle = "c.q1"
[run]
until = 1
[define.c.coordinates]
q1 = {{ unit = "rad" }}
q2 = {{ unit = "rad" }}
[define.c.parameters]
unused = {{ value = 1, unit = "kg" }}
p = {{ value = 2, unit = "N m" }}
[define.c.helpers]
long = {{ expression = "{}", unit = "N m" }}
[define.c.energy]
kinetic = "1 [kg m^2]*(q1_dot^2 + q2_dot^2)/2"
potential = "long"
"#,
        terms.join(" + ")
    );
    let system = system_of(&text);
    let reduced = pipeline::compile(system, Keep::Needed);
    let reduced =
        ModelSimulator::new(reduced.unwrap_or_else(|errors| panic!("{}", errors.render())));
    assert_eq!((reduced.shape().states(), reduced.shape().parameters), (4, 1));
    let whole = system_of(&text.replace("unused = { value = 1, unit = \"kg\" }\n", ""));
    assert_small("alone", &deviation(&whole, reduced.single()));
}
