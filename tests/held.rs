//! Parts held by static friction stay at rest in starts in equilibrium and in eigenmodes.

use machinist::Simulation;
use machinist::linear_analysis::{Linearization, Mode, ModeKind, Place, operating_point};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe as _, Simulator};
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

const MASS: f64 = 1.0;
const STIFFNESS: f64 = 1000.0;

/// Returns a carriage held by friction, and a load beside it on a spring that is pushed.
fn carriage(damping: f64, push: f64, at: f64) -> ModelSimulator {
    of_text(
        &format!(
            r#"
            [scene]
            name = "carriage"
            [units.carriage]
            unit = "translational/mass"
            parameters = {{ mass = 10 }}
            [units.spring]
            unit = "translational/spring_damper"
            parameters = {{ stiffness = {STIFFNESS}, damping = {damping} }}
            [units.load]
            unit = "translational/mass"
            parameters = {{ mass = {MASS} }}
            [[joints]]
            connect = ["carriage.a", "spring.a"]
            [[joints]]
            connect = ["spring.b", "load.a"]
            [friction.guide]
            speed = "carriage.v"
            sliding = "100 [N]"
            unit = "N"
            [[forces]]
            port = "load.a"
            expression = "{push} [N]"
            [outputs]
            x = "load.x"
            [run]
            until = 1
            rtol = 1e-8
            [initial]
            "carriage.x" = {at}
            "load.x" = {at}
            "#
        ),
        Keep::All,
    )
}

/// Returns the state at the start of a run in equilibrium.
fn start(simulator: &dyn Simulator<f64>, name: &str) -> f64 {
    let run = Simulation::new(simulator).in_equilibrium(true).run().expect("it starts");
    run.column(name).expect("a state")[0]
}

#[test]
fn a_start_in_equilibrium_moves_nothing_that_friction_holds_and_stands_still() {
    for damping in [0.0, 5.0, 500.0] {
        for (push, at) in [(20.0, 0.5), (-99.0, 0.5), (20.0, -3.0), (0.0, 0.0), (1e-3, 7.0)] {
            let simulator = carriage(damping, push, at);
            let of = |name| start(&simulator, name);
            let expected = at + push / STIFFNESS;
            assert!((of("load.x") - expected).abs() < 1e-9, "{damping} {push} {at}");
            assert!((of("carriage.x") - at).abs() < 1e-12, "{damping} {push} {at}");
            assert!(of("load.v").abs() < 1e-12 && of("carriage.v").abs() < 1e-12, "{damping}");
            let run = Simulation::new(&simulator).in_equilibrium(true).run().expect("it runs");
            assert!(run.switches.is_empty());
            let moves = run.column("load.x").expect("x").iter().map(|x| (x - expected).abs());
            assert!(moves.fold(0.0, f64::max) < 1e-9, "{damping} {push} {at}");
        }
    }
}

fn modes(simulator: &dyn Simulator<f64>, place: Place) -> Vec<Mode> {
    let point = operating_point(&Simulation::new(simulator), place).expect("a point");
    Linearization::at(simulator, point).expect("finite").modes().expect("modes")
}

/// Asserts that the eigenmodes are one oscillation with these values.
fn assert_one(modes: &[Mode], natural: f64, ratio: f64) {
    let [mode] = modes else { panic!("{modes:?}") };
    assert_eq!(mode.kind, ModeKind::Oscillation);
    assert!((mode.natural_frequency() / natural - 1.0).abs() < 1e-9, "{mode:?}");
    assert!((mode.damping_ratio() - ratio).abs() < 1e-9, "{mode:?}");
}

#[test]
fn a_machine_that_friction_holds_has_the_modes_of_what_is_left_to_move() {
    for damping in [0.5, 5.0, 50.0] {
        let simulator = carriage(damping, 20.0, 0.5);
        let natural = (STIFFNESS / MASS).sqrt();
        let ratio = damping / (2.0 * (STIFFNESS * MASS).sqrt());
        for place in [Place::Equilibrium, Place::Initial, Place::Time(0.37)] {
            assert_one(&modes(&simulator, place), natural, ratio);
        }
    }
}

/// Returns a drum held by a brake, with a load on a rope below it.
fn drum(normal_force: f64) -> ModelSimulator {
    of_text(
        &format!(
            r#"
            [scene]
            name = "drum"
            [units.drum]
            unit = "rotational/inertia"
            parameters = {{ inertia = 3 }}
            [units.brake]
            unit = "rotational/brake"
            parameters = {{ friction = 0.4, geometry = 0.3 }}
            inputs = {{ normal_force = "{normal_force} [N]" }}
            [units.winding]
            unit = "rotational/rack"
            parameters = {{ radius = 0.2 }}
            [units.rope]
            unit = "translational/spring_damper"
            parameters = {{ stiffness = 8e5, damping = 4000 }}
            [units.load]
            unit = "translational/mass"
            parameters = {{ mass = 500 }}
            [[joints]]
            connect = ["drum.a", "brake.a"]
            [[joints]]
            connect = ["drum.b", "winding.a"]
            [[joints]]
            connect = ["load.a", "rope.a"]
            [[joints]]
            connect = ["rope.b", "winding.b"]
            [[forces]]
            port = "load.a"
            expression = "-load.mass*9.81 [m/s^2]"
            [outputs]
            height = "load.x"
            [run]
            until = 1
            rtol = 1e-8
            "#
        ),
        Keep::All,
    )
}

/// sqrt(k/m) = 40 rad/s, c/(2 sqrt(k m)) = 0.1.
#[test]
fn a_load_below_a_braked_drum_swings_on_its_rope_alone() {
    let simulator = drum(20e3);
    for place in [Place::Equilibrium, Place::Time(0.2)] {
        assert_one(&modes(&simulator, place), 40.0, 0.1);
    }
    let hangs = start(&simulator, "load.x") - start(&simulator, "drum.phi") * 0.2;
    assert!((hangs + 500.0 * 9.81 / 8e5).abs() < 1e-9, "{hangs}");
    // With an open brake the drum turns: there is no equilibrium, since the load falls.
    let open = drum(0.0);
    assert!(operating_point(&Simulation::new(&open), Place::Equilibrium).is_err());
    let point = operating_point(&Simulation::new(&open), Place::Initial).expect("the start");
    let modes = Linearization::at(&open, point).expect("finite").modes().expect("modes");
    let [free, turns, swings] = &modes[..] else { panic!("{modes:?}") };
    let kinds = [free.kind, turns.kind, swings.kind];
    assert_eq!(kinds, [ModeKind::Free, ModeKind::Free, ModeKind::Oscillation]);
    // The inertia of the drum at the rope, J/r^2, acts as a second mass.
    let reduced = 1.0 / (1.0 / 500.0 + 0.04 / 3.0);
    assert!((swings.natural_frequency() / (8e5_f64 / reduced).sqrt() - 1.0).abs() < 1e-9);
    assert_eq!(open.shape().coordinates, 2);
}
