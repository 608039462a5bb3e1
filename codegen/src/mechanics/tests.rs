//! Tests of the equations of small machines: power, constraints, undetermined motion.

use std::path::Path;

use machinist_algebra::cas::{Algebra, session};
use machinist_algebra::expr::Expr;
use machinist_contract::PowerBalance;
use machinist_model::ModelSimulator;

use crate::mechanics::lagrange::{self, EquationsOfMotion};
use crate::mechanics::reduce::Keep;
use crate::pipeline;
use crate::scene::compose;
use crate::scene::system::LagrangianSystem;
use crate::spec::library::LibraryScene;
use crate::spec::load_library_scene;

fn system(text: &str) -> LagrangianSystem {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("machine.toml");
    std::fs::write(&path, text).expect("written");
    let system = pipeline::check(Path::new(&path));
    system.unwrap_or_else(|errors| panic!("{}", errors.render()))
}

fn equations(system: LagrangianSystem) -> EquationsOfMotion {
    session("a test", Algebra::Plain, move |cas| lagrange::derive(cas, &system)).expect("a session")
}

/// A cart in a swinging frame, on a spring, with a brake that fades out. A moving constraint
/// couples another cart to it. A force converts the energy stored in a state.
const CARTS: &str = r#"
[scene]
name = "carts"
[units.s]
unit = "s"
[run]
until = 1.0
[define.s.coordinates]
x = { unit = "m" }
y = { unit = "m" }
[define.s.parameters]
mass = { value = 1.5, unit = "kg" }
stiffness = { value = 40, unit = "N/m" }
damping = { value = 2.5, unit = "N s/m" }
[define.s.energy]
kinetic = "mass*(x_dot + 2 [m/s]*cos(3 [1/s]*t))^2/2 + mass*y_dot^2/4"
potential = "stiffness*(1 + t/(1 [s]))*x^2/2"
dissipation = "damping*x_dot^2/2"
stored = "stiffness*z^2/4"
[define.s.states.z]
unit = "m"
rate = "2*x_dot - y_dot"
initial = 0
[define.s.constraints.led]
expression = "y - x/2 - 0.1 [m]*sin(2 [1/s]*t)"
[[define.s.forces]]
coordinate = "x"
expression = "7 [N]*sin(t/(1 [s]))"
[[define.s.forces]]
coordinate = "x"
expression = "-stiffness*z"
conversion = true
[[define.s.forces]]
coordinate = "y"
expression = "stiffness*z/2"
conversion = true
[define.s.events.pulled]
guard = "abs(led) - 3 [N]"
[define.s.events.met]
guard = "x*x_dot - z*y_dot + 0.2 [m^2/s]*sin(2 [1/s]*t)"
"#;

fn carts() -> ModelSimulator {
    let model = pipeline::compile_by(Algebra::Plain, system(CARTS), Keep::All);
    ModelSimulator::interpreted(model.unwrap_or_else(|errors| panic!("{}", errors.render())))
}

/// Returns a state on the constraint at a given time.
fn held(t: f64, x: f64, v: f64) -> [f64; 5] {
    let [y, y_dot] = [x / 2.0 + 0.1 * f64::sin(2.0 * t), v / 2.0 + 0.2 * f64::cos(2.0 * t)];
    [x, y, v, y_dot, 0.3 - v]
}

const PLACES: [(f64, f64, f64); 3] = [(0.2, 0.3, -1.1), (0.7, -0.4, 0.6), (1.9, 0.1, 2.3)];

#[test]
fn power_that_is_supplied_is_stored_or_dissipated_along_any_motion() {
    let simulator = carts();
    let simulator = simulator.single();
    let shape = simulator.shape();
    let p: Vec<f64> = (0..shape.parameters).map(|i| simulator.parameter_default(i)).collect();
    let names: Vec<&str> = (0..shape.states()).map(|i| simulator.state(i).name).collect();
    assert_eq!(names, ["s.x", "s.y", "s.x_dot", "s.y_dot", "s.z"]);
    for (t, x, v) in PLACES {
        let power = simulator.power_balance(t, &held(t, x, v), &p);
        let PowerBalance { stored_rate: stored, supplied, dissipated } = power;
        assert!((dissipated - 2.5 * v * v).abs() < 1e-12, "{dissipated}");
        let size = stored.abs() + supplied.abs() + dissipated;
        assert!((stored - supplied + dissipated).abs() < 1e-12 * size, "{power:?}");
    }
}

#[test]
fn a_model_says_which_files_it_is_of_and_how_much_may_be_taken_for_rigid() {
    let mut system = system(CARTS);
    system.freeze.tolerance = 0.02;
    let model = pipeline::compile_by(Algebra::Plain, system.clone(), Keep::All);
    let model = model.unwrap_or_else(|errors| panic!("{}", errors.render()));
    assert_eq!(model.freeze, system.freeze);
    let read = system.files.iter().map(|file| (&file.label, &file.sha256));
    assert!(read.eq(model.files.iter().map(|file| (&file.label, &file.sha256))));
    assert_eq!(model.files.len(), 1);
}

#[test]
fn an_outline_is_what_all_the_steps_come_to() {
    let of_library = ["two_mass", "slider_crank", "saw_gin"].map(|name| {
        let scene = LibraryScene::find(name).expect("a scene");
        compose(&load_library_scene(scene).expect("a spec")).expect("a system")
    });
    for system in of_library.into_iter().chain([system(CARTS)]) {
        let outline = pipeline::outline_by(Algebra::Plain, system.clone(), Keep::Needed);
        let whole = pipeline::derivation_by(Algebra::Plain, system, Keep::Needed);
        let (outline, whole) = (outline.expect("an outline"), whole.expect("a derivation"));
        assert_eq!(outline.model, *whole.stages.needed());
        assert_eq!(outline.latex, whole.latex);
        assert_eq!(outline.dependencies, whole.dependencies);
    }
}

/// Covers guards on a force, on its magnitude, and on positions and velocities.
#[test]
fn rates_of_guards_are_their_differences_along_the_motion() {
    const STEP: f64 = 1e-5;
    let simulator = carts();
    let simulator = simulator.single();
    let p: Vec<f64> =
        (0..simulator.shape().parameters).map(|i| simulator.parameter_default(i)).collect();
    let ahead = |t: f64, from: &[f64; 5], along: &[f64; 5], step: f64| -> [f64; 5] {
        let mut rate = [0.0; 5];
        simulator.rate(t, along, &p, &mut rate);
        std::array::from_fn(|entry| from[entry] + step * rate[entry])
    };
    for (t, x, v) in PLACES {
        let state = held(t, x, v);
        let guards = |step: f64| {
            let middle = ahead(t, &state, &state, step / 2.0);
            let end = ahead(t + step / 2.0, &state, &middle, step);
            let mut guards = [0.0; 2];
            simulator.guards(t + step, &end, &p, &mut guards);
            guards
        };
        let (after, before) = (guards(STEP), guards(-STEP));
        let mut rates = [0.0; 2];
        simulator.guard_rates(t, &state, &p, &mut rates);
        for (index, rate) in rates.into_iter().enumerate() {
            let expected = (after[index] - before[index]) / (2.0 * STEP);
            assert!((rate - expected).abs() < 1e-6 * expected.abs().max(1.0), "{rate} {expected}");
        }
    }
}

fn crank(inertia: f64, rod: &str, constraints: &str) -> LagrangianSystem {
    system(&format!(
        r#"
[scene]
name = "crank"
[units.s]
unit = "s"
[run]
until = 1.0
[initial]
"s.phi" = 0.3
[define.s.coordinates]
phi = {{ unit = "rad" }}
psi = {{ unit = "rad" }}
x = {{ unit = "m" }}
[define.s.parameters]
inertia = {{ value = {inertia}, unit = "kg m^2" }}
mass = {{ value = 1.5, unit = "kg" }}
crank = {{ value = 0.1, unit = "m" }}
rod = {{ value = 0.3, unit = "m" }}
[define.s.energy]
kinetic = "inertia*phi_dot^2/2 + mass*x_dot^2/2 {rod}"
{constraints}
"#
    ))
}

const LOOP: &str = r#"
[guess]
"s.psi" = -0.1
"s.x" = 0.4
[define.s.constraints.along]
expression = "x - crank*cos(phi) - rod*cos(psi)"
[define.s.constraints.across]
expression = "crank*sin(phi) + rod*sin(psi)"
"#;

#[test]
fn what_has_neither_inertia_nor_a_constraint_is_told_by_its_coordinates() {
    let of_rod = "+ inertia*psi_dot^2/2";
    let regular = equations(crank(0.02, of_rod, LOOP));
    assert!(!regular.is_singular());
    assert_eq!(regular.undecided(), None);
    // The loop supports a massless rod.
    let massless = equations(crank(0.02, "", LOOP));
    assert!(massless.is_singular());
    assert_eq!(massless.undecided(), None);
    // Redundant constraints leave forces undetermined, but no motion.
    let again = format!(
        "{LOOP}[define.s.constraints.again]\nexpression = \"2*x - 2*crank*cos(phi) - 2*rod*cos(psi)\"\n"
    );
    let repeated = equations(crank(0.02, "", &again));
    assert!(repeated.is_singular());
    assert_eq!(repeated.undecided(), None);
    let open = equations(crank(0.02, of_rod, ""));
    assert!(!open.is_singular());
    // An inertia that the spec sets to zero counts as none; the slider's mass determines the
    // motion.
    let light = equations(crank(0.0, of_rod, LOOP));
    assert!(light.is_singular());
    assert_eq!(light.undecided(), None);
    // Without it, nothing determines the one motion that the loop allows.
    let mut system = crank(0.02, of_rod, LOOP);
    system.kinetic = Expr::integer(0);
    let nothing = equations(system);
    assert!(nothing.is_singular());
    assert_eq!(nothing.undecided(), Some(vec![0, 1, 2]));
}
