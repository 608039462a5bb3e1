//! Events of scenes run from their specs: each is found once by every method that monitors events.

use std::time::Duration;

use machinist::error::StopCause;
use machinist::method::{Auto, Problem, StepTolerance, System};
use machinist::{Method, SimulateError, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Describe;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

/// Returns a scene of one unit `ball` with coordinate `x` and mass 1 kg, with additional text of
/// the unit.
fn scene(more: &str) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "balls"
        [units.ball]
        unit = "ball"
        [run]
        until = 10.0
        points = 101
        rtol = 1e-10
        method = "auto"
        [define.ball.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.ball.modes.count]
        [define.ball.modes.other]
        [define.ball.parameters]
        gravity = {{ value = 9.81, unit = "m/s^2" }}
        restitution = {{ value = 1.0, unit = "1" }}
        spring = {{ value = 0.0, unit = "N/m" }}
        {more}
        "#
    );
    of_text(&text, Keep::Needed)
}

const FALLS: &str = r#"
    [define.ball.energy]
    kinetic = "1 [kg]*v^2/2"
    potential = "1 [kg]*gravity*x"
    [define.ball.events.bounce]
    guard = "x"
    direction = "falling"
    set = { v = "-restitution*v", count = "count + 1" }
"#;

/// Returns an oscillation x = cos t with events.
fn swings(events: &str) -> ModelSimulator {
    scene(&format!(
        "[define.ball.energy]\nkinetic = \"1 [kg]*v^2/2\"\n\
         potential = \"1 [N/m]*x^2/2\"\n{events}"
    ))
}

/// Returns the methods that watch events and can run a machine.
fn watching(simulator: &ModelSimulator) -> impl Iterator<Item = Method> {
    Method::ALL.iter().copied().filter(|method| method.watches_events() && method.suits(simulator))
}

fn from_height(ball: &ModelSimulator, method: Method) -> Simulation<'_> {
    Simulation::new(ball).initial_state(&[1.0, 0.0, 0.0, 0.0]).method(method)
}

fn times(run: &Trajectory) -> Vec<f64> {
    run.switches.iter().map(|switch| switch.time).collect()
}

#[test]
fn every_watching_method_bounces_at_the_exact_times() {
    let ball = scene(FALLS);
    let fall = (2.0_f64 / 9.81).sqrt();
    for method in watching(&ball) {
        let run = from_height(&ball, method).run().expect("it runs");
        let times = times(&run);
        let expected = (0.5 + 5.0 / fall).floor() as usize;
        assert_eq!(times.len(), expected, "{method}");
        assert_eq!(run.work.switches, expected as u64, "{method}");
        assert_eq!(run.last("ball.count"), Some(expected as f64), "{method}");
        for (number, time) in times.iter().enumerate() {
            let exact = (2.0 * number as f64 + 1.0) * fall;
            assert!((time - exact).abs() < 1e-8, "{method}: {time} for {exact}");
        }
    }
}

#[test]
fn bounces_that_decay_stop_with_the_name_of_the_event_where_they_end() {
    let ball = scene(FALLS);
    let fall = (2.0_f64 / 9.81).sqrt();
    for restitution in [0.0, 0.3, 0.8] {
        for method in watching(&ball) {
            let run = from_height(&ball, method).parameter("ball.restitution", restitution);
            let stopped = run.expect("a parameter").run().expect_err("it is endless");
            let SimulateError::Stopped { time, cause: StopCause::Zeno { event, .. }, .. } = stopped
            else {
                panic!("{method}: {stopped}");
            };
            let end = fall * (1.0 + restitution) / (1.0 - restitution);
            assert_eq!(event, "ball.bounce");
            assert!((time - end).abs() < 1e-7, "{method}, {restitution}: {time} for {end}");
        }
    }
}

/// At a place other than zero the guard is a difference, and its rounding throws the mass back again
/// and again.
#[test]
fn impacts_that_decay_at_a_wall_anywhere_stop_where_they_end() {
    let mass = scene(
        r#"
        place = { value = 0.27, unit = "m" }
        [define.ball.energy]
        kinetic = "1 [kg]*v^2/2"
        potential = "40 [N/m]*x^2/2"
        dissipation = "0.2 [N*s/m]*v^2/2"
        [[define.ball.forces]]
        coordinate = "x"
        expression = "40 [N/m]*place + 3 [N] + cos(2 [1/s]*t)*1 [N]"
        [define.ball.events.bounce]
        guard = "x - place"
        direction = "rising"
        set = { v = "-restitution*v" }
        "#,
    );
    for (place, restitution) in [(0.27, 0.46), (2.7, 0.3), (-0.013, 0.6), (31.0, 0.5)] {
        let run = |method: Method, rtol: f64| {
            let run = Simulation::new(&mass).method(method).rtol(rtol);
            let run = run.parameter("ball.place", place).expect("a parameter");
            let run = run.parameter("ball.restitution", restitution).expect("a parameter");
            let run = run.initial_value("ball.x", place - 0.2).expect("a state");
            let stopped = run.max_steps(20_000).run().expect_err("it is endless");
            let SimulateError::Stopped { time, cause: StopCause::Zeno { .. }, .. } = stopped else {
                panic!("{method}, {place}, {rtol}: {stopped}");
            };
            time
        };
        let end = run(Method::Dop853, 1e-12);
        for method in watching(&mass) {
            for rtol in [1e-5, 1e-7, 1e-9] {
                let found = run(method, rtol);
                let allowed = 100.0 * rtol + 1e-6;
                assert!(
                    (found - end).abs() < allowed,
                    "{method}, {place}, {restitution}, {rtol}: {found} and not {end}"
                );
            }
        }
    }
}

#[test]
fn a_guard_is_seen_each_way_once_or_both_ways() {
    for (direction, first, expected) in [("rising", 1.5, 1), ("falling", 0.5, 2), ("both", 0.5, 3)]
    {
        let ball = swings(&format!(
            "[define.ball.events.crosses]\nguard = \"x\"\ndirection = \"{direction}\"\n\
             set = {{ count = \"count + 1\" }}"
        ));
        for method in watching(&ball) {
            let run = from_height(&ball, method).run().expect("it runs");
            let times = times(&run);
            assert_eq!(times.len(), expected, "{method} {direction}: {times:?}");
            let exact = first * std::f64::consts::PI;
            assert!((times[0] - exact).abs() < 1e-8, "{method} {direction}: {times:?}");
        }
    }
}

#[test]
fn a_guard_that_only_just_dips_below_zero_within_a_step_is_seen() {
    let ball =
        swings("[define.ball.events.dips]\nguard = \"x + 0.9999999 [m]\"\ndirection = \"falling\"");
    let half_width = 0.999_999_9_f64.acos();
    for method in watching(&ball) {
        let run = from_height(&ball, method).rtol(1e-12).run().expect("it runs");
        let times = times(&run);
        assert_eq!(times.len(), 2, "{method}: {times:?}");
        let exact = std::f64::consts::PI - half_width;
        assert!((times[0] - exact).abs() < 1e-7, "{method}: {} for {exact}", times[0]);
    }
}

#[test]
fn events_at_one_time_happen_in_the_order_of_the_spec() {
    let ball = swings(
        "[define.ball.events.first]\nguard = \"x\"\nset = { count = \"2*count + 1\" }\n\
         [define.ball.events.second]\nguard = \"-3*x\"\nset = { count = \"2*count\" }",
    );
    for method in watching(&ball) {
        let run = from_height(&ball, method).until(3.0).run().expect("it runs");
        let events: Vec<&str> = run.switches.iter().map(|switch| &*switch.event).collect();
        assert_eq!(events, ["ball.first", "ball.second"], "{method}");
        assert_eq!(run.last("ball.count"), Some(2.0), "{method}");
    }
}

#[test]
fn an_event_that_leaves_the_mode_of_another_keeps_it_from_happening_too() {
    let ball = swings(
        "[define.ball.events.first]\nguard = \"x\"\nset = { other = 1 }\n\
         [define.ball.events.second]\nguard = \"-3*x\"\nwhen = { other = 0 }\n\
         set = { count = 7 }",
    );
    let run = from_height(&ball, Method::Auto).run().expect("it runs");
    assert!(run.switches.iter().all(|switch| switch.event == "ball.first"));
    assert_eq!(run.last("ball.count"), Some(0.0));
}

/// Returns balls of 1 kg in a row that collide without loss, each with position and speed.
fn row(balls: &[(f64, f64)]) -> ModelSimulator {
    let masses = (0..balls.len()).map(|k| {
        format!("[units.b{k}]\nunit = \"translational/mass\"\nparameters = {{ mass = 1.0 }}\n")
    });
    let hits = (1..balls.len()).zip(0..).map(|(next, k)| {
        format!(
            "[events.h{k}]\nguard = \"b{next}.x - b{k}.x\"\ndirection = \"falling\"\n\
             set = {{ \"b{k}.v\" = \"b{next}.v\", \"b{next}.v\" = \"b{k}.v\" }}\n"
        )
    });
    let starts = balls
        .iter()
        .zip(0..)
        .map(|((place, speed), k)| format!("\"b{k}.x\" = {place:?}\n\"b{k}.v\" = {speed:?}\n"));
    let (masses, hits, starts): (String, String, String) =
        (masses.collect(), hits.collect(), starts.collect());
    let text = format!(
        r#"
        [scene]
        name = "row"
        [run]
        until = 10.0
        points = 101
        rtol = 1e-8
        method = "auto"
        {masses}
        {hits}
        [initial]
        {starts}
        "#
    );
    of_text(&text, Keep::Needed)
}

#[test]
fn what_hits_at_one_time_hits_on_until_all_move_apart() {
    // The middle one is hit from both sides; two hit three that touch, one soon after the other.
    let both_sides = (vec![(-1.0, 1.0), (0.0, 0.0), (1.0, -1.0)], vec![-1.0, 0.0, 1.0]);
    let touching = [(0.0, 0.0); 3];
    let two_on_three =
        ([&[(-1.2, 1.0), (-1.0, 1.0)], &touching[..]].concat(), vec![0.0, 0.0, 0.0, 1.0, 1.0]);
    for (balls, speeds) in &[both_sides, two_on_three] {
        let row = row(balls);
        for method in watching(&row) {
            let run = Simulation::new(&row).method(method).run();
            let run = run.unwrap_or_else(|error| panic!("{method}: {error}"));
            for (k, speed) in speeds.iter().enumerate() {
                let v = run.last(&format!("b{k}.v")).expect("a state");
                assert!((v - speed).abs() < 1e-9, "{method}: ball {k} of {speeds:?} has {v}");
            }
        }
    }
}

#[test]
fn a_sample_at_an_event_is_from_before_it_and_one_after_it_from_after() {
    let ball = scene(FALLS);
    let fall = (2.0_f64 / 9.81).sqrt();
    let wanted = [0.0, fall - 1e-9, fall + 1e-9, 1.0];
    let run = from_height(&ball, Method::Dop853).until(1.0).times(&wanted).run().expect("it runs");
    let speed = run.column("ball.v").expect("a state");
    assert!(speed[1] < -4.0 && speed[2] > 4.0, "{speed:?}");
}

#[test]
fn energy_lost_at_events_is_dissipated() {
    let ball = scene(FALLS);
    for method in watching(&ball) {
        let run = from_height(&ball, method).until(2.0).parameter("ball.restitution", 0.9);
        let run = run.expect("a parameter").with_energy_balance(true).run().expect("it runs");
        let balance = run.energy_balance.expect("it was asked for");
        assert!(balance.max_residual_relative() < 1e-8, "{method}");
        let lost = balance.dissipated.last().copied().unwrap_or(0.0);
        let kept = 0.81_f64.powi(run.switches.len() as i32);
        assert!((lost - 9.81 * (1.0 - kept)).abs() < 1e-7, "{method}: {lost}");
    }
}

#[test]
fn a_new_value_that_is_not_finite_stops_the_run_and_is_named() {
    let ball =
        swings("[define.ball.events.breaks]\nguard = \"x\"\nset = { v = \"v/(spring/1 [N/m])\" }");
    let stopped = from_height(&ball, Method::Auto).run().expect_err("it divides by zero");
    let text = stopped.to_string();
    assert!(text.contains("`ball.v` at event `ball.breaks`"), "{text}");
}

#[test]
fn a_guard_that_is_zero_everywhere_is_refused_by_name() {
    let ball = swings("[define.ball.events.never]\nguard = \"gravity*x - x*gravity\"");
    let refused = from_height(&ball, Method::Auto).run().expect_err("it is zero");
    assert!(matches!(&refused, SimulateError::GuardIsZero { event, .. } if event == "ball.never"));
}

#[test]
fn a_guard_that_moves_only_after_the_run_is_not_refused() {
    let late = swings("[define.ball.events.late]\nguard = \"max(t - 50 [s], 0 [s])\"");
    let run = from_height(&late, Method::Auto).run().expect("it runs");
    assert!(run.switches.iter().all(|switch| switch.event != "ball.late"));
}

#[test]
fn a_method_that_does_not_watch_refuses_a_scene_with_events() {
    let ball = scene(FALLS);
    for &method in Method::ALL {
        let refused = from_height(&ball, method).until(0.1).run().is_err();
        assert_eq!(refused, !method.suits(&ball), "{method}");
    }
}

#[test]
fn a_problem_refuses_what_a_simulation_refuses() {
    let ball = scene(FALLS);
    let parameters: Vec<f64> =
        (0..ball.shape().parameters).map(|index| ball.parameter_default(index)).collect();
    let system = System::new(&ball, &parameters, false);
    let problem = Problem {
        system: &system,
        from: 0.0,
        until: 0.1,
        times: &[0.1],
        initial: vec![1.0, 0.0, 0.0, 0.0],
        jumps: Vec::new(),
        tolerance: StepTolerance::requested(1e-6, vec![1e-6; 4]),
        auto: Auto::default(),
        max_steps: 1000,
    };
    for &method in Method::ALL.iter().filter(|method| !method.watches_events()) {
        let refused = from_height(&ball, method).run().expect_err("it does not watch");
        let stopped = problem.integrate(method).expect_err("nor here");
        let StopCause::Unsuitable(unsuitable) = stopped.cause else { panic!("{stopped:?}") };
        assert_eq!(SimulateError::Unsuitable((*unsuitable).clone()), refused);
        assert!(unsuitable.known.contains("taylor"), "{}", unsuitable.known);
    }
    assert!(problem.integrate(Method::Taylor).is_ok());
}

#[test]
fn a_ball_at_rest_on_the_guard_that_starts_downwards_bounces_at_once() {
    let ball = scene(FALLS);
    let start = [0.0, -1.0, 0.0, 0.0];
    let run = Simulation::new(&ball).initial_state(&start).until(0.1).run().expect("it runs");
    assert_eq!(times(&run), [0.0]);
    assert!(run.last("ball.x").is_some_and(|x| x > 0.0));
}

/// Returns a slider on a belt at rest, pulled by a spring.
fn slider() -> ModelSimulator {
    let text = r#"
        [scene]
        name = "thrown"
        [units.slider]
        unit = "friction_slider"
        inputs = { belt_speed = 0, belt_acceleration = 0 }
        parameters = { stribeck_friction = 0.0 }
        [outputs]
        x = "slider.x"
        v = "slider.v"
        slip = "slider.slip"
        [run]
        until = 2.0
        points = 101
        rtol = 1e-8
        method = "auto"
    "#;
    of_text(text, Keep::Needed)
}

#[test]
fn a_block_that_is_thrown_slides_and_is_braked() {
    let slider = slider();
    for method in watching(&slider) {
        for (speed, slip) in [(3.0, 1.0), (-3.0, -1.0), (1e-3, 1.0)] {
            let run = Simulation::new(&slider)
                .parameter("slider.stiffness", 0.0)
                .expect("a parameter")
                .initial_state(&[0.0, speed, 0.0])
                .method(method)
                .run()
                .expect("it runs");
            let began = run.column("slip").expect("an output")[0];
            assert_eq!(began.to_bits(), f64::to_bits(slip), "{method}");
            // The friction mu N/m brakes it to rest.
            let way = speed * f64::abs(speed) / (2.0 * 0.25 * 10.0);
            let x = run.last("x").expect("an output");
            assert!((x - way).abs() < 1e-7, "{method}, {speed}: {x} for {way}");
            assert_eq!(run.last("slip"), Some(0.0), "{method}");
            assert_eq!(run.last("v"), Some(0.0), "{method}");
        }
    }
}

#[test]
fn a_block_that_is_pulled_beyond_its_limit_at_the_start_slides() {
    let slider = slider();
    // 35 times the limit of 4 N; the first half cycle about 2.5 N/k.
    let x0 = 35.0 * 4.0 / 400.0;
    for method in watching(&slider) {
        let run = Simulation::new(&slider)
            .initial_state(&[x0, 0.0, 0.0])
            .times(&[0.0, 0.05])
            .until(0.05)
            .method(method)
            .run()
            .expect("it runs");
        let centre = 2.5 / 400.0;
        let exact = centre + (x0 - centre) * f64::cos(20.0 * 0.05);
        let x = run.last("x").expect("an output");
        assert!((x - exact).abs() < 1e-7, "{method}: {x} for {exact}");
    }
}

#[test]
fn a_start_that_modes_cannot_set_right_is_refused_by_name() {
    let slider = slider();
    // It slides forwards, but its mode says backwards: ending that mode would stop it at once.
    let run = Simulation::new(&slider).initial_state(&[0.0, 3.0, -1.0]).run();
    let refused = run.expect_err("it contradicts").to_string();
    assert!(refused.contains("`slider.ends_back`"), "{refused}");
}

#[test]
fn a_run_that_stops_hands_over_what_there_is() {
    let ball = scene(FALLS);
    let run = from_height(&ball, Method::Dop853).parameter("ball.restitution", 0.5);
    let stopped = run.expect("a parameter").run().expect_err("it is endless");
    let SimulateError::Stopped { kept: Some(kept), time, .. } = stopped else {
        panic!("{stopped}");
    };
    assert_eq!(kept.stopped.as_ref().map(|stop| stop.time), Some(time));
    assert!(kept.stopped.is_some_and(|stop| stop.cause.contains("Zeno")));
    assert_eq!(kept.times.len(), 1 + (10.0 * time).floor() as usize);
    assert!(kept.switches.len() > 20);
    for column in &kept.columns {
        assert_eq!(column.values.len(), kept.times.len(), "{}", column.name);
    }
}

#[test]
fn what_grows_beyond_numbers_stops_every_method_with_its_name() {
    let grows = scene(
        "[define.ball.energy]\nkinetic = \"1 [kg]*v^2/2\"\n\
         potential = \"-2 [N/m]*x^2\"",
    );
    for &method in Method::ALL.iter().filter(|method| method.is_compiled_in()) {
        let run = from_height(&grows, method).until(1000.0).rtol(1e-6).max_steps(200_000).run();
        let SimulateError::Stopped { time, cause, kept, .. } = run.expect_err("it grows") else {
            panic!("{method}");
        };
        assert!(matches!(cause, StopCause::Overflow { .. }), "{method}: {cause}");
        assert!((170.0..=185.0).contains(&time), "{method}: {time}");
        let kept = kept.expect("what there is");
        assert!(kept.columns.iter().flat_map(|column| &column.values).all(|v| v.is_finite()));
    }
}

#[test]
fn a_root_that_begins_at_zero_does_not_cost_steps() {
    let ball = scene(
        "[define.ball.energy]\nkinetic = \"1 [kg]*v^2/2\"\n\
         potential = \"1 [N/m^3]*x^4/4\"\n\
         [[define.ball.forces]]\ncoordinate = \"x\"\n\
         expression = \"1 [N]*sqrt(step(t, 0.2 [s]))\"",
    );
    let run = |method| {
        from_height(&ball, method).until(3.0).rtol(1e-8).max_steps(2000).run().expect("it runs")
    };
    let (auto, dop853) = (run(Method::Auto), run(Method::Dop853));
    assert!(auto.work.steps < 100, "{:?}", auto.work);
    let [a, b] = [auto, dop853].map(|run| run.last("ball.x").expect("a state"));
    assert!((a - b).abs() < 1e-6, "{a} for {b}");
}

/// Dense output may slope against the motion near a peak of the torque, at loose tolerances.
#[test]
fn counters_near_peaks_take_no_longer_at_loose_tolerances() {
    let machine = of_text(include_str!("events/counted_overloads.toml"), Keep::Needed);
    for stiffness in [262_636.352_765_333_26, 144_974.067_037_263_24] {
        let [loose, tight] = [1e-3, 1e-9].map(|rtol| {
            let run = Simulation::new(&machine).rtol(rtol).method(Method::Taylor);
            let run = run.parameter("coupling.stiffness", stiffness).expect("a parameter");
            let run = run.time_limit(Duration::from_secs(20)).run().expect("it ends soon");
            run.last("trips").expect("an output")
        });
        // One peak is as high as the limit, but for errors.
        assert!(tight >= 14.0 && (loose - tight).abs() <= 1.0, "{loose}, {tight}");
    }
}
