//! Rates with switching surfaces, by `abs`, `min`, `max` and `sign`: steps end at them without loss
//! of accuracy, and chattering is reported.

use std::cell::Cell;

use machinist::error::StopCause;
use machinist::{Method, SimulateError, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, Simulator};
use machinist_model::ModelSimulator;

use crate::own_scene::{of_specs, of_text};

const OWN: [Method; 6] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Taylor, Method::Auto];

/// Returns a block of 1 kg with a potential and a force of x, v, t, thrown at 1 m/s.
fn block(potential: &str, force: &str) -> ModelSimulator {
    of_text(&text(potential, force), Keep::Needed)
}

fn text(potential: &str, force: &str) -> String {
    format!(
        r#"
        [scene]
        name = "blocks"
        [units.block]
        unit = "block"
        [initial]
        "block.v" = 1.0
        [run]
        until = 10.0
        points = 81
        rtol = 1e-8
        method = "auto"
        [define.block.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.block.parameters]
        gap = {{ value = 0.3, unit = "m" }}
        stiffness = {{ value = 50.0, unit = "N/m" }}
        [define.block.energy]
        kinetic = "1 [kg]*v^2/2"
        potential = "{potential}"
        [[define.block.forces]]
        coordinate = "x"
        expression = "{force}"
        "#
    )
}

fn run(block: &ModelSimulator, method: Method, rtol: f64, set: &[(&str, f64)]) -> Trajectory {
    let mut run = Simulation::new(block).method(method).rtol(rtol);
    for (name, value) in set {
        run = run.parameter(name, *value).expect("a parameter");
    }
    run.run().unwrap_or_else(|error| panic!("{method} at {rtol:e}, {set:?}: {error}"))
}

/// Returns the largest difference of x and v.
fn difference(a: &Trajectory, b: &Trajectory) -> f64 {
    ["block.x", "block.v"].iter().fold(0.0, |most: f64, name| {
        let values = [a, b].map(|run| run.column(name).expect("a state"));
        let pairs = values[0].iter().zip(values[1]);
        pairs.fold(most, |most, (a, b)| most.max((a - b).abs()))
    })
}

/// Compares runs at ten tolerances from 1e-3 to 1e-10 and all own methods with two runs that agree,
/// in units of the tolerance.
fn keeps_its_digits(block: &ModelSimulator, set: &[(&str, f64)], most: f64) {
    let exact = run(block, Method::Dop853, 1e-13, set);
    let other = run(block, Method::Radau, 1e-12, set);
    let doubt = difference(&exact, &other);
    assert!(doubt < 1e-10, "{set:?}: two converged runs differ by {doubt:e}");
    for method in OWN {
        let mut worst = 0.0f64;
        for step in 0..10 {
            let rtol = 10f64.powf(-3.0 - 7.0 * f64::from(step) / 9.0);
            let error = difference(&run(block, method, rtol, set), &exact);
            assert!(error < most * rtol + doubt, "{method} at {rtol:e}, {set:?}: {error:e}");
            worst = worst.max(error / rtol);
        }
        println!("{method}, {set:?}: at most {worst:.1} tolerances");
    }
}

#[test]
fn a_spring_with_play_keeps_its_digits() {
    let force = "0.3 [N]*cos(1.3 [rad/s]*t) - 0.2 [N s/m]*v";
    let play = block("stiffness*max(abs(x) - gap, 0)^2/2", force);
    assert_eq!(play.kinks(), 2, "abs and max");
    for (gap, stiffness) in [(0.3, 50.0), (0.1, 10.0), (0.05, 30.0)] {
        keeps_its_digits(&play, &[("block.gap", gap), ("block.stiffness", stiffness)], 300.0);
    }
    let force = format!("{force} - sign(x)*stiffness*max(abs(x) - gap, 0)^2/(1 [m])");
    let by_force = block("0 [J]", &force);
    keeps_its_digits(&by_force, &[], 300.0);
}

#[test]
fn forces_that_jump_with_state_or_time_keep_their_digits() {
    let force = "0.5 [N]*sign(sin(1.3 [rad/s]*t)) - 0.1 [N s^2/m^2]*v*abs(v) - 0.1 [N]*sign(v)\
                 + min(0.3 [N], abs(0.2 [N/m]*x + 0.1 [N s/m]*v))";
    let block = block("1 [N/m]*x^2/2 + 1 [N/m^2]*abs(x)^3/3", force);
    assert_eq!(block.kinks(), 5, "a square wave, v, x, a minimum and its argument");
    keeps_its_digits(&block, &[], 300.0);
}

/// The limit of a controller acts like this when the set point jumps.
#[test]
fn limits_that_a_jump_in_time_puts_far_behind_keep_their_digits() {
    let wanted = "1.6 [N]*step(t, 3 [s]) - 2 [N]*step(t, 6 [s]) - 0.5 [N s/m]*v";
    let force = format!("max(min({wanted}, 1 [N]), -0.8 [N])");
    let block = block("1 [N/m]*x^2/2", &force);
    assert_eq!((block.kinks(), block.shape().discontinuities), (2, 2));
    keeps_its_digits(&block, &[], 300.0);
}

/// Compares with `[friction.NAME]`, which sticks by a mode.
#[test]
fn friction_by_sign_sticks_as_declared_friction_does() {
    let pull = "0.5 [N]*cos(1.3 [rad/s]*t)";
    let by_sign = block("1 [N/m]*x^2/2", &format!("{pull} - 0.3 [N]*sign(v)"));
    let declared = {
        let friction = r#"
        [define.block.friction.rub]
        speed = "v"
        sliding = "0.3 [N]"
        unit = "N"
        "#;
        of_text(&format!("{}{friction}", text("1 [N/m]*x^2/2", pull)), Keep::Needed)
    };
    let reference = run(&declared, Method::Dop853, 1e-11, &[]);
    for method in OWN {
        let run = run(&by_sign, method, 1e-8, &[]);
        let off = difference(&run, &reference);
        assert!(off < 1e-5, "{method}: {off:e}");
        assert!(run.work.steps < 5000, "{method}: {} steps", run.work.steps);
    }
}

/// A preloaded spring acts like this on a body that it holds, and on one beside.
#[test]
fn what_rests_on_a_kink_goes_on_resting_by_all_methods() {
    for (potential, force) in [
        ("3 [N]*abs(x)", "-0.5 [N s/m]*v"),
        ("3 [N]*abs(x) + 5 [N/m]*x^2", "0.7 [N] - 0.5 [N s/m]*v"),
    ] {
        let block = block(potential, force);
        for method in OWN {
            let run = Simulation::new(&block).method(method).until(1000.0);
            let run = run.initial_value("block.v", 0.0).expect("a state");
            let run = run.max_steps(300_000).run();
            let run = run.unwrap_or_else(|error| panic!("{method}: {error}"));
            let last = run.column("block.x").and_then(|x| x.last()).expect("a row");
            assert!(last.abs() < 1e-9, "{method}: {last}");
        }
    }
}

/// Swings about a corner get shorter for ever, but do not add up to a finite time.
#[test]
fn what_swings_about_a_corner_comes_to_rest_on_it() {
    for (load, damping) in [(3.0, 0.5), (30.0, 2.0)] {
        let block = block(&format!("{load} [N]*abs(x)"), &format!("-{damping} [N s/m]*v"));
        let early = Simulation::new(&block).until(2.0).rtol(1e-11).run().expect("a run");
        for method in OWN {
            for rtol in [1e-3, 1e-5] {
                let what = format!("{method} at {rtol:e}, {load} N, {damping} N s/m");
                let run = Simulation::new(&block).method(method).rtol(rtol);
                let run = run.max_steps(300_000);
                let same = run.clone().until(2.0).run().expect("a run");
                let off = difference(&same, &early);
                assert!(off < 1e3 * rtol, "{what}: {off:e}");
                let run = run.until(1000.0).run().unwrap_or_else(|error| panic!("{what}: {error}"));
                for name in ["block.x", "block.v"] {
                    let last = run.last(name).expect("a state");
                    assert!(last.abs() < 1e-12, "{what}: {name} = {last:e}");
                }
                assert!(run.notes.iter().any(|note| note.contains("surface")), "{what}");
            }
        }
    }
}

/// A puck on a table, which stops: the friction direction changes with its motion.
#[test]
fn plane_friction_stops_soon_where_it_sticks() {
    let text = r#"
        [scene]
        name = "puck"
        [units.puck]
        unit = "puck"
        [initial]
        "puck.x_dot" = 2
        "puck.y_dot" = 1
        [run]
        until = 50
        points = 2
        rtol = 1e-8
        [define.puck.coordinates]
        x = { unit = "m" }
        y = { unit = "m" }
        [define.puck.energy]
        kinetic = "18 [kg]*(x_dot^2 + y_dot^2)/2"
        dissipation = "17.658 [N]*sqrt(x_dot^2 + y_dot^2)"
    "#;
    let puck = crate::own_scene::of_text(text, machinist_codegen::mechanics::reduce::Keep::Needed);
    for method in OWN {
        let stopped = Simulation::new(&puck).method(method).run();
        let SimulateError::Stopped { time, cause, kept, .. } = stopped.expect_err("it sticks")
        else {
            panic!("{method}: no stop")
        };
        let steps = kept.expect("the run until then").work.steps;
        assert!(matches!(&cause, StopCause::Chattering { .. }), "{method}: {cause}");
        let rest = 5.0f64.sqrt() / 0.981;
        assert!((time - rest).abs() < 1e-3 && steps < 5000, "{method}: {time}, {steps} steps");
    }
}

#[test]
fn without_kinks_there_are_no_guards() {
    let smooth = block("stiffness*x^2/2", "0.3 [N]*cos(1.3 [rad/s]*t)*tanh(v/(1 [m/s]))");
    assert_eq!(smooth.kinks(), 0);
    // Known times are not guards: the run is divided there.
    let timed = block("stiffness*x^2/2", "1 [N]*max(t/(1 [s]) - 5, 0) + 1 [N]*abs(t/(2 [s]) - 3)");
    assert_eq!((timed.kinks(), timed.shape().discontinuities), (0, 2));
    let mut times = [0.0; 2];
    let parameters = defaults(&timed);
    Simulator::<f64>::discontinuities(&timed, &parameters, &mut times);
    times.sort_by(f64::total_cmp);
    assert!((times[0] - 5.0).abs() < 1e-12 && (times[1] - 6.0).abs() < 1e-12, "{times:?}");
}

fn defaults(machine: &dyn Simulator<f64>) -> Vec<f64> {
    (0..machine.shape().parameters).map(|index| machine.parameter_default(index)).collect()
}

/// Returns dg/dt along the motion, by differences.
fn by_differences(machine: &dyn Simulator<f64>, time: f64, state: &[f64], h: f64) -> Vec<f64> {
    let parameters = defaults(machine);
    let mut rate = vec![0.0; state.len()];
    machine.rate(time, state, &parameters, &mut rate);
    let guards = |by: f64| {
        let moved: Vec<f64> = state.iter().zip(&rate).map(|(y, rate)| y + by * rate).collect();
        let mut guards = vec![0.0; machine.kinks()];
        machine.kink_guards(time + by, &moved, &parameters, &mut guards);
        guards
    };
    let [ahead, behind] = [guards(h), guards(-h)];
    ahead.iter().zip(&behind).map(|(a, b)| (a - b) / (2.0 * h)).collect()
}

#[test]
fn rates_of_kinks_are_their_derivatives_along_the_motion() {
    let functions = [
        "sqrt(u + 3)",
        "abs(u)",
        "exp(u)",
        "ln(u + 3)",
        "sin(u)",
        "cos(u)",
        "tan(u)",
        "asin(u/3)",
        "acos(u/3)",
        "atan(u)",
        "sinh(u)",
        "cosh(u)",
        "tanh(u)",
        "u^5",
        "1/(u + 3)^3",
        "(u + 3)^(1/2)",
        "min(u, 0.1)*u",
    ];
    let sum: Vec<String> = functions
        .iter()
        .map(|function| {
            let function = function.replace('u', "(x*t/(1 [m s]) + v/(2 [m/s]))");
            format!("0.01 [N]*max({function}, 0.3)")
        })
        .collect();
    let block = block("1 [N/m]*x^2/2", &sum.join(" + "));
    assert!(block.kinks() >= functions.len(), "{} of {}", block.kinks(), functions.len());
    let parameters = defaults(&block);
    for (time, state) in [(0.3, [0.4, -0.7]), (1.1, [-0.2, 0.9]), (0.7, [0.9, 0.35])] {
        let mut rates = vec![0.0; block.kinks()];
        block.kink_rates(time, &state, &parameters, &mut rates);
        let expected = by_differences(&block, time, &state, 1e-5);
        for (kink, (rate, expected)) in rates.iter().zip(&expected).enumerate() {
            let error = (rate - expected).abs() / (1.0 + expected.abs());
            assert!(error < 1e-7, "kink {kink} at {time}: {rate} for {expected}");
        }
    }
}

#[test]
fn emitted_scenes_know_their_kinks() {
    let slider = machinist_scenes::scenes::stick_slip_smooth::StickSlipSmooth;
    assert_eq!(slider.kinks(), 1, "the sign of the sliding speed");
    let expected = by_differences(&slider, 0.2, &[0.01, 0.03], 1e-6);
    let parameters = defaults(&slider);
    let mut rates = [0.0];
    slider.kink_rates(0.2, &[0.01, 0.03], &parameters, &mut rates);
    assert!((rates[0] - expected[0]).abs() < 1e-6 * (1.0 + expected[0].abs()), "{rates:?}");
}

/// v^2 grows by twice the work of each bump, which lasts a thousandth of its period.
#[test]
fn bumps_that_are_passed_and_passed_back_within_a_step_are_not_stepped_over() {
    let bumpy = block("0", "max(200 [N]*(cos(20 [1/m]*x) - 0.9999), 0 [N])");
    // The angle at which a bump ends, and its work: 2 (sin - 0.9999 angle) 200/20.
    let angle = f64::acos(0.9999);
    let bump = 20.0 * (angle.sin() - 0.9999 * angle);
    for method in OWN {
        for rtol in [1e-7, 1e-10] {
            let run = run(&bumpy, method, rtol, &[]);
            let last = |name: &str| run.last(name).expect("a state");
            let turns = last("block.x") * 20.0 / std::f64::consts::TAU;
            let (passed, since) = (turns.floor() + 0.5, turns.fract() * std::f64::consts::TAU);
            assert!(since > angle && since < std::f64::consts::TAU - angle, "it ends on a bump");
            let exact = (1.0 + 2.0 * bump * passed).sqrt();
            let off = (last("block.v") - exact).abs();
            assert!(off < 1e4 * rtol * (exact - 1.0), "{method} at {rtol:e}: {off:e}");
        }
    }
}

#[test]
fn what_comes_to_rest_at_a_limit_does_not_chatter_there() {
    let limited = block("0", "1 [N]*max(min(smooth_step(t/2 [s]), 1), 0)");
    for method in OWN {
        for rtol in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
            let last = run(&limited, method, rtol, &[]).last("block.v").expect("a state");
            // Half of the first two seconds, and all of the other eight.
            assert!((last - 10.0).abs() < 1e3 * rtol, "{method} at {rtol:e}: {last}");
        }
    }
}

/// `abs` of a frequency that approaches zero with a horizontal tangent at the end of the run: it is
/// then rounding of its earlier values.
#[test]
fn a_ramp_that_ends_at_zero_does_not_chatter() {
    let scene = of_specs("parts/electrical/converter", Keep::Needed);
    let base = Simulation::new(&scene).points(2);
    let run = |method, rtol| base.clone().method(method).rtol(rtol).run().expect("a run");
    let exact = run(Method::Radau, 1e-13);
    let methods = [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Auto];
    for method in methods {
        for exponent in 4..=13 {
            let rtol = 10.0_f64.powi(-exponent);
            let found = run(method, rtol);
            for name in ["speed", "torque"] {
                let [found, exact] = [&found, &exact].map(|run| run.last(name).expect(name));
                let error = (found - exact).abs() / exact.abs();
                assert!(
                    error < 300.0 * rtol + 1e-10,
                    "{method:?} at {rtol:e}: {name} off {error:e}"
                );
            }
        }
    }
}

#[test]
fn a_run_all_of_whose_steps_end_at_kinks_is_left_when_it_is_told_to() {
    // Where x is already 0, v changes sign at every zero of the sine, far more often than steps
    // need.
    let block = block("0 [J]", "1 [N]*abs(sin(1e4 [1/s]*t + 0.1))");
    for method in [Method::Tsit5, Method::Dop853, Method::Taylor, Method::Radau] {
        let asked = Cell::new(0);
        let told = || {
            asked.set(asked.get() + 1);
            (asked.get() > 200).then_some(StopCause::Interrupted)
        };
        let stopped = Simulation::new(&block).method(method).rtol(1e-3).until_told(&told).run();
        let Err(SimulateError::Stopped { time, kept: Some(kept), .. }) = stopped else {
            panic!("{method} runs on")
        };
        assert!(time < 0.2, "{method} is left at {time} s");
        assert!(kept.work.steps < 1000, "{method} is left after {} steps", kept.work.steps);
    }
}
