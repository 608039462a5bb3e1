//! Scenes with constraints run from their specs: starts, projection, refusals.

use machinist::constraints::{mobility, start};
use machinist::error::Feature;
use machinist::linear_analysis::{
    LinearError, Linearization, Mode, ModeKind, Place, Point, equilibrium, operating_point,
};
use machinist::{Method, SimulateError, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

/// Returns a scene of point masses `a` and `b` of 1 kg, with additional text.
fn scene(more: &str) -> ModelSimulator {
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
    of_text(&text, Keep::Needed)
}

pub fn start_of(scene: &ModelSimulator) -> Result<Vec<f64>, SimulateError> {
    use machinist_contract::Describe as _;
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

/// Both coordinates of a mass are given, to any number of digits.
#[test]
fn a_start_off_by_less_than_the_tolerance_is_projected_and_told() {
    let given = |y: f64, v_y: f64| {
        let rods = RODS.replace("\"a.y\" = -1\n", "");
        let both = format!("\"a.v_x\" = 0.3\n\"a.y\" = {y:?}\n\"a.v_y\" = {v_y:?}");
        scene(&rods.replace("\"a.v_x\" = 0.3", &both))
    };
    for off in [2e-10, -7e-10, 3e-12] {
        for off_v in [0.0, 4e-10] {
            let scene = given(-0.8 + off, 0.225 + off_v);
            let run = Simulation::new(&scene).run().expect("it starts");
            let at_start = |name: &str| run.column(name).expect("a state")[0];
            let [x, y, v_x, v_y] = ["a.x", "a.y", "a.v_x", "a.v_y"].map(at_start);
            assert!((x * x + y * y - 1.0).abs() < 1e-14 && (x * v_x + y * v_y).abs() < 1e-14);
            // The projection is the shortest move, along the rod.
            assert!((y + 0.8 - off * 0.36).abs() < 1e-3 * off.abs() + 1e-15, "{y}");
            let notes = run.notes.join("\n");
            assert!(notes.contains("is projected onto them: `a.x` by"), "{notes}");
        }
    }
    let exact = Simulation::new(&given(-0.8, 0.225)).run().expect("it starts").notes.join("\n");
    assert!(!exact.contains("projected"), "{exact}");
    for (off, off_v, what) in [(1e-6, 0.0, "position"), (0.0, 1e-6, "velocity")] {
        let refused = start_of(&given(-0.8 + off, 0.225 + off_v)).expect_err("it is off");
        let wanted = format!("no initial {what} fulfils constraint `rod_a`");
        assert!(refused.to_string().contains(&wanted), "{refused}");
    }
}

#[test]
fn a_constraint_at_its_extremum_is_told_and_how_to_write_it() {
    for (expression, at) in [
        ("1 - cos(a.x/1 [m])", 0.0),
        ("(a.x - 2 [m])^2", 2.0),
        ("(a.x^2 - 4 [m^2])^2*(1 + b.y^2/1 [m^2])", 2.0),
    ] {
        let scene = scene(&format!(
            "[constraints]\nlevel = {{ expression = \"{expression}\" }}\n\
             [initial]\n\"a.x\" = {at:?}"
        ));
        let refused = Simulation::new(&scene).run().expect_err("it holds nothing").to_string();
        assert!(refused.contains("`level` is at an extremum"), "{refused}");
        assert!(refused.contains("`phi` instead of `1 - cos(phi)`"), "{refused}");
    }
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
            assert_eq!(unsuitable.feature, Feature::Constraints, "{method}");
            continue;
        }
        if !method.suits(&rods) {
            assert_eq!(method, Method::Exact);
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
    // A mass on an incline of 45 degrees is stopped sideways: the incline makes it stop completely.
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

/// Returns the eigenmodes about the equilibrium near the start.
fn modes_near_the_start(scene: &ModelSimulator) -> (Vec<f64>, Vec<Mode>) {
    use machinist_contract::Describe as _;
    let count = scene.shape().parameters;
    let parameters = (0..count).map(|index| scene.parameter_default(index)).collect();
    let state = start_of(scene).expect("it starts");
    let point = equilibrium(scene, &Point { time: 0.0, state, parameters }).expect("it rests");
    let linearization = Linearization::at(scene, point).expect("it is regular");
    (linearization.point().state.clone(), linearization.modes().expect("eigenvalues"))
}

/// Returns the frequencies of oscillations.
fn swings(modes: &[Mode]) -> Vec<f64> {
    let swings = modes.iter().filter(|mode| mode.kind == ModeKind::Oscillation);
    swings.map(Mode::natural_frequency).collect()
}

#[test]
fn masses_on_rods_swing_as_pendulums_of_their_lengths() {
    let near = RODS.replace("= 0.6", "= 0.1").replace("= 0.3", "= 0").replace("= 1.5", "= -0.2");
    let (_, modes) = modes_near_the_start(&scene(&near));
    assert_eq!(modes.len(), 2, "nothing else moves: {modes:?}");
    let found = swings(&modes);
    for (found, length) in found.iter().zip([2.0, 1.0]) {
        assert!((found / (9.81_f64 / length).sqrt() - 1.0).abs() < 1e-12, "{found}");
    }
    assert!(modes.iter().all(|mode| mode.residual < 1e-12));
}

#[test]
fn a_rod_by_its_velocity_swings_likewise_and_has_any_length() {
    let text = r#"
        [constraints]
        rod = { expression = "a.x*a.v_x + a.y*a.v_y" }
        shelf = { expression = "b.y" }
        stop = { expression = "b.x" }
        [initial]
        "a.x" = 0.1
        "a.y" = -1.0
    "#;
    let (state, modes) = modes_near_the_start(&scene(text));
    let found = swings(&modes);
    // It hangs at the current length.
    let length = -state[1];
    assert!(state[0].abs() < 1e-12 && (length - 1.0).abs() < 0.05, "{state:?}");
    assert_eq!((found.len(), modes.len()), (1, 2), "{modes:?}");
    assert!((found[0] / (9.81 / length).sqrt() - 1.0).abs() < 1e-12, "{found:?}");
    assert!(modes.iter().any(|mode| mode.kind == ModeKind::Free), "its length is free");
}

/// Returns the scene `slider_crank` without drive, with its crank near the lowest position.
pub fn slider_crank_let_go() -> ModelSimulator {
    let text = include_str!("../specs/scenes/slider_crank.toml");
    let (head, rest) = text.split_once("[constraints.drive]").expect("it is driven");
    let (_, outputs) = rest.split_once("[outputs]").expect("it has outputs");
    let outputs = outputs.lines().filter(|line| !line.contains("drive"));
    let start = "[initial]\n\"crank.phi\" = -1.4\n\"crank.omega\" = 0\n[guess]\n\"rod.x\" = 0.1\n\
                 \"rod.phi\" = 0.25\n\"slider.x\" = 0.19\n[outputs]";
    let unused = ["[parameters.speed]", "[parameters.start]"];
    assert!(unused.iter().all(|section| head.contains(section)));
    of_text(&format!("{head}{start}{}", outputs.collect::<Vec<_>>().join("\n")), Keep::Needed)
}

#[test]
fn a_slider_crank_swings_about_its_lowest_place_as_by_hand() {
    let found = swings(&modes_near_the_start(&slider_crank_let_go()).1);
    // The rod moves as a whole with the crank's end there: with l = 0.05 m,
    // w^2 = g l (m_crank + m_rod)/2/(J + m_crank l^2/4 + (m_rod + m_slider) l^2).
    let inertia = 2e-4 + 0.8 * 0.05 * 0.05 / 4.0 + (0.6 + 1.1) * 0.05 * 0.05;
    let exact = (9.81_f64 * 0.05 * (0.8 + 0.6) / 2.0 / inertia).sqrt();
    assert_eq!(found.len(), 1);
    assert!((found[0] / exact - 1.0).abs() < 1e-11, "{found:?} for {exact}");
}

#[test]
fn what_a_constraint_drives_is_in_no_equilibrium_and_the_constraint_is_named() {
    let text = include_str!("../specs/scenes/slider_crank.toml");
    let driven = of_text(text, Keep::Needed);
    let run = Simulation::new(&driven).until(0.1);
    let refused = operating_point(&run, Place::Equilibrium).expect_err("it turns");
    assert!(matches!(refused, LinearError::NoEquilibrium { .. }), "{refused}");
    assert!(refused.to_string().contains("`drive` changes by"), "{refused}");
    let point = operating_point(&run, Place::Initial).expect("it starts");
    let linearization = Linearization::at(&driven, point).expect("it is regular");
    assert!(linearization.modes().expect("eigenvalues").is_empty());
    let refused = linearization.response("speed", "angle", &[1.0]).expect_err("not analysed");
    assert!(matches!(refused, LinearError::MovesConstraint { .. }), "{refused}");
    assert!(refused.to_string().contains("constraint `drive` depends on it"), "{refused}");
}

/// Returns a pendulum of 1 m that is released at an angle, with a rod as a constraint or by its
/// angle.
fn let_go(angle: f64) -> [ModelSimulator; 2] {
    let run = "[run]\nuntil = 1000.0\npoints = 1001\nrtol = 1e-10\nmethod = \"auto\"";
    let (sine, cosine) = angle.sin_cos();
    let by_rod = format!(
        r#"
        [scene]
        name = "on_a_rod"
        [units.bob]
        unit = "bob"
        [initial]
        "bob.x" = {sine}
        [guess]
        "bob.y" = {}
        {run}
        [define.bob.coordinates.x]
        unit = "m"
        [define.bob.coordinates.y]
        unit = "m"
        [define.bob.constraints.rod]
        expression = "x^2 + y^2 - 1 [m^2]"
        [define.bob.energy]
        kinetic = "1 [kg]*(x_dot^2 + y_dot^2)/2"
        potential = "1 [kg]*9.81 [m/s^2]*y"
        [outputs]
        x = "bob.x"
        "#,
        -cosine
    );
    let by_angle = format!(
        r#"
        [scene]
        name = "by_its_angle"
        [units.bob]
        unit = "bob"
        [initial]
        "bob.angle" = {angle}
        {run}
        [define.bob.coordinates.angle]
        unit = "rad"
        [define.bob.energy]
        kinetic = "1 [kg m^2]*angle_dot^2/2"
        potential = "-9.81 [N m]*cos(angle)"
        [outputs]
        x = {{ expression = "sin(bob.angle)", unit = "1", doc = "to the side, over the length" }}
        "#
    );
    [by_rod, by_angle].map(|text| of_text(&text, Keep::Needed))
}

#[test]
fn a_pendulum_on_a_rod_keeps_its_phase_for_long_to_an_accuracy() {
    for angle in [0.1, 0.6435, 1.5, 2.5] {
        let [by_rod, by_angle] = let_go(angle);
        let exact = Simulation::new(&by_angle).method(Method::Taylor).rtol(1e-14);
        for (until, accuracies) in [(100.0, &[1e-4, 1e-7][..]), (1000.0, &[1e-6])] {
            let exact = exact.clone().until(until).run().expect("it swings");
            let exact = exact.column("x").expect("an output");
            for &accuracy in accuracies {
                let run = Simulation::new(&by_rod).method(Method::Auto).until(until);
                let run = run.run_to_accuracy(accuracy).expect("it swings");
                assert_eq!(run.shortfall, None, "{angle}, {until} s, {accuracy:e}");
                let x = run.trajectory.column("x").expect("an output");
                let error = x.iter().zip(exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                println!("{angle} rad, {until} s, {accuracy:e}: x {error:.1e} m");
                assert!(error < 3.0 * accuracy, "{angle}, {until} s, {accuracy:e}: {error:e} m");
            }
        }
    }
}
