//! Scenes with constraints run from their specs: started, kept to, refused by name.
#![cfg(feature = "cli")]

use machinist::constraints::{mobility, start};
use machinist::error::Lack;
use machinist::interpreted::InterpretedSimulator;
use machinist::{Method, SimulateError, Simulation};
use machinist_codegen::pipeline;
use machinist_codegen::reduce::Keep;

/// A scene of point masses `a` and `b`, 1 kg each, with more of the scene.
fn scene(more: &str) -> InterpretedSimulator {
    let text = format!(
        r#"
        [scene]
        name = "masses"
        [units.a]
        unit = "point_mass"
        [units.b]
        unit = "point_mass"
        [run]
        until = 2.0
        points = 21
        rtol = 1e-9
        method = "auto"
        {more}
        "#
    );
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text).expect("written");
    match pipeline::generate(&path, Keep::Needed) {
        Ok(program) => InterpretedSimulator::new(program),
        Err(errors) => panic!("{}", errors.render()),
    }
}

fn start_of(scene: &InterpretedSimulator) -> Result<Vec<f64>, SimulateError> {
    use machinist_scenes::Describe as _;
    let count = scene.shape().parameters;
    let parameters: Vec<f64> = (0..count).map(|index| scene.parameter_default(index)).collect();
    start(scene, &parameters, 0.0)
}

/// Two masses on rods from the origin.
const RODS: &str = r#"
    [constraints]
    rod_a = { expression = "a.x^2 + a.y^2 - 1 [m^2]" }
    rod_b = { expression = "b.x^2 + b.y^2 - 4 [m^2]" }
    [initial]
    "a.x" = 0.6
    "a.v_x" = 0.3
    [guess]
    "a.y" = -1
    "b.x" = 1.5
    "b.y" = -1.5
"#;

#[test]
fn what_is_given_stays_and_the_rest_is_solved_for() {
    let state = start_of(&scene(RODS)).expect("it starts");
    let [x, y, b_x, b_y, v_x, v_y, ..] = state[..] else { panic!("eight states") };
    assert_eq!((x, v_x), (0.6, 0.3));
    assert!((y + 0.8).abs() < 1e-13 && (b_x * b_x + b_y * b_y - 4.0).abs() < 1e-12);
    assert!((x * v_x + y * v_y).abs() < 1e-13);
}

#[test]
fn an_impossible_position_is_refused_by_the_constraint_s_name() {
    let far = scene(&RODS.replace("\"a.x\" = 0.6", "\"a.x\" = 1.2"));
    let refused = start_of(&far).expect_err("the rod is too short");
    let text = refused.to_string();
    assert!(text.contains("no initial position fulfils constraint `rod_a`"), "{text}");
    assert!(text.contains("[m^2]"), "{text}");
}

#[test]
fn an_impossible_velocity_is_refused_by_the_constraint_s_name() {
    let both = scene(&RODS.replace("\"a.v_x\" = 0.3", "\"a.v_x\" = 0.3\n\"a.v_y\" = 0.3"));
    let refused = start_of(&both).expect_err("it would leave the rod");
    let text = refused.to_string();
    assert!(text.contains("no initial velocity fulfils constraint `rod_a`"), "{text}");
}

#[test]
fn inconsistent_constraints_are_refused() {
    let two =
        scene(&RODS.replace(
            "[initial]",
            "other = { expression = \"a.x^2 + a.y^2 - 2 [m^2]\" }\n[initial]",
        ));
    let refused = start_of(&two).expect_err("no place has two distances");
    assert!(matches!(refused, SimulateError::ImpossibleStart { .. }), "{refused}");
}

#[test]
fn a_redundant_constraint_is_refused_with_those_it_repeats() {
    let twice = scene(&RODS.replace(
        "[initial]",
        "sum = { expression = \"a.x^2 + a.y^2 + b.x^2 + b.y^2 - 5 [m^2]\" }\n[initial]",
    ));
    let refused = Simulation::new(&twice).run().expect_err("it says nothing new");
    let text = refused.to_string();
    assert!(text.contains("`sum` says nothing that is new beside `rod_a`, `rod_b`"), "{text}");
    let state = start_of(&twice).expect("it is consistent all the same");
    let found = mobility(&twice, &[1.0, 9.81, 1.0, 9.81], 0.0, &state).expect("constraints");
    assert_eq!((found.by_rank(), found.by_count()), (2, 1));
}

#[test]
fn every_keeping_method_swings_as_a_pendulum_does() {
    let rods = scene(RODS);
    let mut ends = Vec::new();
    for &method in Method::ALL {
        let run = Simulation::new(&rods).method(method).rtol(1e-10).run();
        if !method.keeps_constraints() {
            let Err(SimulateError::Unsuitable(unsuitable)) = run else {
                panic!("{method}: {run:?}")
            };
            assert_eq!(unsuitable.lack, Lack::Constraints, "{method}");
            continue;
        }
        let run = run.expect("it runs");
        let column = |name: &str| run.column(name).expect("a state").to_vec();
        let (x, y) = (column("a.x"), column("a.y"));
        let off = x.iter().zip(&y).map(|(x, y)| (x * x + y * y - 1.0).abs()).fold(0.0, f64::max);
        assert!(off < 1e-14, "{method}: {off}");
        let drift = run.drift.expect("it has constraints");
        assert!(drift.before > drift.after && drift.after < 1e-14, "{method}: {drift:?}");
        ends.push((method, x[20], run.column("energy.total").expect("energy").to_vec()));
    }
    for (method, end, energy) in &ends {
        assert!((end - ends[0].1).abs() < 1e-7, "{method}: {end}");
        assert!((energy[20] - energy[0]).abs() < 1e-7, "{method}");
    }
}

#[test]
fn a_constraint_of_velocities_is_kept_and_its_force_does_no_work() {
    // A blade: no velocity across its edge, which points from b to a.
    let blade = scene(
        r#"
        [constraints]
        bar = { expression = "(a.x - b.x)^2 + (a.y - b.y)^2 - 1 [m^2]" }
        edge = { expression = "a.v_x*(a.y - b.y) - a.v_y*(a.x - b.x)" }
        [initial]
        "a.x" = 1.0
        "b.x" = 0.0
        "b.y" = 0.0
        "a.v_x" = 0.5
        "b.v_y" = 1.0
        [outputs]
        slip = { expression = "a.v_x*(a.y - b.y) - a.v_y*(a.x - b.x)", unit = "m^2/s" }
        a_x = "a.x"
        b_x = "b.x"
        side_force = "edge"
        "#,
    );
    let run = Simulation::new(&blade).with_energy_balance(true).run().expect("it runs");
    let slip = run.column("slip").expect("an output");
    assert!(slip.iter().all(|slip| slip.abs() < 1e-12), "{slip:?}");
    let balance = run.energy_balance.as_ref().expect("it was asked for");
    assert!(balance.max_residual_relative() < 1e-7);
    assert_eq!(run.find("side_force").map(|column| column.unit.as_str()), Some("kg/s^2"));
}

#[test]
fn a_moving_constraint_supplies_what_the_energy_gains() {
    let lift = scene(
        r#"
        [constraints]
        lift = { expression = "a.y - 0.5 [m/s^2]*t^2" }
        rail = { expression = "a.x" }
        [outputs]
        force = "lift"
        height = "a.y"
        "#,
    );
    let run = Simulation::new(&lift).with_energy_balance(true).run().expect("it runs");
    let force = run.column("force").expect("an output");
    assert!(force.iter().all(|force| (force - 10.81).abs() < 1e-9), "{force:?}");
    let balance = run.energy_balance.expect("it was asked for");
    let supplied = balance.supplied.last().copied().unwrap_or_default();
    // (g + a) a t^2/2 of 1 kg after 2 s.
    assert!((supplied - 10.81 * 2.0).abs() < 1e-7, "{supplied}");
}

#[test]
fn an_event_is_followed_by_the_impulse_of_constraints() {
    // A mass on an incline of 45 degrees is stopped sideways: the incline stops it whole.
    let incline = scene(
        r#"
        [constraints]
        incline = { expression = "a.x + a.y" }
        [events.hits]
        guard = "a.x - 1 [m]"
        direction = "rising"
        set = { "a.v_x" = 0 }
        [outputs]
        x = "a.x"
        v_x = "a.v_x"
        v_y = "a.v_y"
        "#,
    );
    let run = Simulation::new(&incline).until(0.6387).run().expect("it runs");
    // x'' = g/2, so that it hits at t = 2/sqrt(g) = 0.63855 s with v_x = -v_y = sqrt(g); the
    // stop takes v_x alone, and the incline shares what is left of v_y between both.
    let hit = run.switches.first().expect("it hits").time;
    assert!((hit - 2.0 / 9.81_f64.sqrt()).abs() < 1e-9, "{hit}");
    let (v_x, v_y) = (run.last("v_x").expect("one"), run.last("v_y").expect("one"));
    assert!((v_x + v_y).abs() < 1e-12);
    let expected = 9.81_f64.sqrt() / 2.0 + 9.81 / 2.0 * (0.6387 - hit);
    assert!((v_x - expected).abs() < 1e-8, "{v_x} for {expected}");
}
