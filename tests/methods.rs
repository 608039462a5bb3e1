//! Special properties of the methods of this crate: stiff machines compared with each other,
//! tolerances that are kept, choices that are reported.

use std::cell::RefCell;

use crate::common::{HardSpring, Scalar};
use crate::own_scene::{of_specs, of_text};
use machinist::error::StopCause;
use machinist::method::{Auto, ExplicitMethod, ImplicitMethod, Work};
use machinist::{Method, SimulateError, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_model::ModelSimulator;
use machinist_scenes::scenes;
use machinist_studies::stability::machines::{PROTHERO_ROBINSON, ROBERTSON, VAN_DER_POL};

const OWN: [Method; 5] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Auto];

/// Largest error of the states over all output times, each over its size.
fn error(simulator: &dyn Simulator<f64>, run: &Trajectory, reference: &Trajectory) -> f64 {
    let mut largest: f64 = 0.0;
    for state in 0..simulator.shape().states() {
        let size = simulator.state_scale(state);
        let values = run.columns[state].values.iter().zip(&reference.columns[state].values);
        largest = values.fold(largest, |largest, (a, b)| largest.max((a - b).abs() / size));
    }
    largest
}

#[test]
fn errors_keep_to_the_tolerance_from_loose_to_tight() {
    let base = Simulation::new(&HardSpring);
    let reference = base.clone().method(Method::Dop853).rtol(1e-14).run().unwrap();
    for method in OWN {
        let (mut least, mut most) = (f64::INFINITY, 0.0);
        let mut rtol = 1e-3;
        while rtol > 0.9e-12 {
            let run = base.clone().method(method).rtol(rtol).run().unwrap();
            let found = error(&HardSpring, &run, &reference) / rtol;
            println!("{method} {rtol:.0e}: {found:.2} rtol, {} steps", run.work.steps);
            assert!(found < 15.0, "{method} at {rtol:e} errs by {found} times the tolerance");
            // Tolerances of `auto` are never looser than 1e-5.
            if method != Method::Auto || rtol < 2e-5 {
                (least, most) = (found.min(least), found.max(most));
            }
            rtol /= 10.0;
        }
        assert!(most < 10.0 * least, "{method} errs by {least} to {most} times the tolerance");
    }
}

/// Returns the observed order from errors against numbers of steps, by least squares of logarithms.
fn order_by_steps(points: &[(u64, f64)]) -> f64 {
    let logs: Vec<(f64, f64)> =
        points.iter().map(|(steps, error)| ((*steps as f64).ln(), error.ln())).collect();
    let mean =
        |of: &dyn Fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / logs.len() as f64;
    let (x, y) = (mean(&|log| log.0), mean(&|log| log.1));
    let covariance = mean(&|log| (log.0 - x) * (log.1 - y));
    -covariance / mean(&|log| (log.0 - x).powi(2))
}

#[test]
fn methods_of_fixed_order_show_it_in_errors_against_steps() {
    // The steps of diffsol's methods cannot be counted; bdf and radau change their order.
    let base = Simulation::new(&HardSpring).points(2);
    let reference = base.clone().method(Method::Dop853).rtol(1e-14).run().unwrap();
    for (method, order, tightest) in [
        (Method::TrBdf2, 2.0, -8),
        (Method::Esdirk34, 3.0, -10),
        (Method::Tsit45, 5.0, -11),
        (Method::Tsit5, 5.0, -11),
        (Method::Rodas5p, 5.0, -11),
        (Method::Bdf, 5.0, -12),
    ] {
        let points: Vec<(u64, f64)> = (2 * tightest..=-8)
            .map(|half_power| {
                let rtol = 10f64.powf(0.5 * f64::from(half_power));
                let run = base.clone().method(method).rtol(rtol).run().unwrap();
                (run.work.steps, error(&HardSpring, &run, &reference))
            })
            .collect();
        let observed = order_by_steps(&points);
        println!("{method}: {observed:.2} {points:?}");
        assert!((observed - order).abs() < 0.2, "{method} shows an order of {observed}");
    }
}

#[test]
fn errors_of_taylor_keep_to_the_tolerance_from_loose_to_tight() {
    for name in ["winder_nonlinear", "motor_run_up", "saw_gin"] {
        let simulator = scenes::find_f64(name).unwrap();
        let base = Simulation::new(simulator).points(101);
        let reference = base.clone().method(Method::Radau).rtol(1e-14).run().unwrap();
        let (mut least, mut most) = (f64::INFINITY, 0.0);
        for power in 3..=12 {
            let rtol = 10f64.powi(-power);
            let run = base.clone().method(Method::Taylor).rtol(rtol).run().unwrap();
            // Accumulated rounding in this run and in the reference.
            let found = (error(simulator, &run, &reference) - 5e-13).max(0.1 * rtol) / rtol;
            println!("{name} {rtol:.0e}: {found:.2} rtol, {} steps", run.work.steps);
            (least, most) = (found.min(least), found.max(most));
        }
        assert!(most < 10.0 * least && most < 2.0, "{name}: {least} to {most} tolerances");
    }
}

#[test]
fn two_unrelated_methods_agree_on_van_der_pol() {
    // y'' = mu (1 - y^2) y' - y, mu = 1e3, in time over mu until 2.
    let simulation = Simulation::new(&VAN_DER_POL).points(21);
    let radau = simulation.clone().method(Method::Radau).rtol(1e-12).run().unwrap();
    // Hairer, Wanner, test set of stiff problems: y(2), y'(2).
    let published = [1.706_167_732_170_483, -8.928_097_010_248_25e-1];
    for (state, value) in published.iter().enumerate() {
        let found = radau.columns[state].values[20];
        assert!((found / value - 1.0).abs() < 1e-8, "state {state} is {found}");
    }
    for method in [Method::Rodas5p, Method::Auto] {
        for rtol in [1e-5, 1e-8] {
            let run = simulation.clone().method(method).rtol(rtol).run().unwrap();
            let at_end = (run.columns[0].values[20] / published[0] - 1.0).abs();
            println!("{method} {rtol:e}: {at_end:e} {:?}", run.work);
            assert!(at_end < 100.0 * rtol, "{method} at {rtol:e} errs by {at_end:e}");
            assert!(run.work.steps < 5000, "{method}: {:?}", run.work);
        }
    }
}

#[test]
fn two_unrelated_methods_agree_on_robertson() {
    let simulation = Simulation::new(&ROBERTSON).times(&[0.0, 40.0, 4e5, 1e11]);
    let radau = simulation.clone().method(Method::Radau).rtol(1e-11).run().unwrap();
    // The same test set: y at 1e11.
    let published = [2.083_340_149_701_253e-8, 8.333_360_770_334_716e-14, 9.999_999_791_665_05e-1];
    for (state, value) in published.iter().enumerate() {
        let found = radau.columns[state].values[3];
        assert!((found / value - 1.0).abs() < 1e-6, "state {state} is {found}");
    }
    for method in [Method::Rodas5p, Method::Auto] {
        let run = simulation.clone().method(method).rtol(1e-7).run().unwrap();
        for time in 1..3 {
            for state in 0..3 {
                let exact = radau.columns[state].values[time];
                let found = run.columns[state].values[time] / exact - 1.0;
                assert!(found.abs() < 1e-5, "{method}, {time}, {state}: {found:e}");
            }
        }
        assert!(run.work.steps < 3000, "{method}: {:?}", run.work);
    }
}

#[test]
fn rosenbrock_keeps_its_order_near_a_stiff_equilibrium() {
    // Prothero and Robinson: y' = -L (y - cos t) - sin t, from y = cos t. Methods not designed for
    // it lose all orders but one or two.
    let scalar = Simulation::new(&PROTHERO_ROBINSON).parameter("lambda", -1e5).unwrap();
    for (method, most) in [(Method::Rodas5p, 100), (Method::Radau, 60)] {
        let run = scalar.clone().method(method).rtol(1e-6).run().unwrap();
        let error = (run.last("y1").unwrap() - 3.0f64.cos()).abs();
        println!("{method}: {error:e} {:?}", run.work);
        assert!(error < 1e-6 && run.work.steps < most, "{method}: {error:e}, {:?}", run.work);
    }
}

#[test]
fn states_between_the_ends_of_long_steps_keep_to_the_tolerance() {
    // The stiffer the problem, the longer the accepted steps, up to the whole run at once.
    for power in [4, 6, 8, 10, 12] {
        let lambda = -10f64.powi(power);
        let scalar = Simulation::new(&PROTHERO_ROBINSON).parameter("lambda", lambda).unwrap();
        for method in [Method::Rodas5p, Method::Radau, Method::Auto] {
            for rtol in [1e-4, 1e-7, 1e-10] {
                let run = scalar.clone().method(method).rtol(rtol).points(301).run().unwrap();
                let values = run.times.iter().zip(run.column("y1").unwrap());
                let error = values.fold(0.0f64, |most, (t, y)| most.max((y - t.cos()).abs()));
                let about = format!("{method}, {lambda:e}, {rtol:e}: {error:e}");
                println!("{about}, {:?}", run.work);
                assert!(error < 100.0 * rtol && run.work.steps < 5000, "{about}");
            }
        }
    }
}

#[test]
fn auto_says_what_it_chose_and_why() {
    let run = |simulator: &dyn Simulator<f64>, rtol| {
        Simulation::new(simulator).method(Method::Auto).rtol(rtol).run().unwrap().notes
    };
    let notes = run(&HardSpring, 1e-2);
    assert_eq!(notes[0], "starts with dop853, for a relative tolerance of 1e-3");
    assert!(notes[1].contains("1e-3 instead of 1e-2: looser steps skip whole"), "{notes:?}");
    // Errors of many loose steps may add up.
    let long = Simulation::new(&HardSpring).until(1000.0).method(Method::Auto).rtol(1e-3);
    let notes = long.run().unwrap().notes;
    assert!(notes[1].contains("may have a relative error of 1e-3"), "{notes:?}");
    let notes = run(scenes::find_f64("pendulum_relative").unwrap(), 1e-3);
    assert!(notes[1].contains("1e-5 instead of 1e-3: errors add up"), "{notes:?}");
    assert_eq!(run(&HardSpring, 1e-6), ["starts with dop853, for a relative tolerance of 1e-6"]);
    for (rtol, implicit) in [(1e-5, "rodas5p"), (1e-6, "radau")] {
        let notes = run(&VAN_DER_POL, rtol);
        assert!(notes[0].starts_with(&format!("starts with {implicit}")), "{notes:?}");
        assert!(notes[0].contains("stability would require 1229508 steps of dop853"), "{notes:?}");
        assert!(notes[1].contains("no longer stiff"), "{notes:?}");
        assert!(notes[2].starts_with(implicit), "{notes:?}");
        assert!(notes[2].contains("limited by stability"), "{notes:?}");
    }
    let plain = Simulation::new(&HardSpring).method(Method::Radau).run().unwrap();
    assert!(plain.notes.is_empty());
}

#[test]
fn auto_makes_the_choices_of_a_run() {
    let machine = scenes::find_f64("saw_gin").expect("built in");
    let base = Simulation::new(machine).rtol(1e-8);
    let exact = base.clone().method(Method::Dop853).rtol(1e-12).run().expect("a run");
    for explicit in [ExplicitMethod::Taylor, ExplicitMethod::Dop853, ExplicitMethod::Tsit5] {
        let choices = Auto { explicit: Some(explicit), ..Auto::default() };
        let run = base.clone().auto(choices).run().expect("a run");
        let named = format!("starts with {}, ", format!("{explicit:?}").to_lowercase());
        assert!(run.notes.iter().any(|note| note.starts_with(&named)), "{:?}", run.notes);
        let error = error(machine, &run, &exact);
        assert!(error < 1e-4, "{explicit:?}: {error:e}");
    }
    let stiff = of_specs("classics/van_der_pol", Keep::Needed);
    for (implicit, rtol) in [(ImplicitMethod::Rodas5p, 1e-8), (ImplicitMethod::Radau, 1e-3)] {
        let choices = Auto { implicit: Some(implicit), ..Auto::default() };
        let run = Simulation::new(&stiff).rtol(rtol).auto(choices).run().expect("a run");
        let named = format!("starts with {}, ", format!("{implicit:?}").to_lowercase());
        assert!(run.notes.iter().any(|note| note.starts_with(&named)), "{:?}", run.notes);
    }
    let linear = of_specs("two_mass", Keep::Needed);
    let steps = |exact| {
        let run = Simulation::new(&linear).auto(Auto { exact, ..Auto::default() }).run();
        run.expect("a run").work.steps
    };
    assert!(steps(true) == 1 && steps(false) > 5, "{} and {}", steps(true), steps(false));
    let loosest = Auto { loosest: 1e-2, loosest_kept: 1e-2, ..Auto::default() };
    let run = base.rtol(1e-1).auto(loosest).run().expect("a run");
    assert!(
        run.notes.iter().any(|note| note.contains("tolerance of 1e-2 instead of 1e-1")),
        "{:?}",
        run.notes
    );
}

/// An induction machine in stationary axes, whose starting current leaves errors for the whole run.
#[test]
fn auto_keeps_the_digits_of_series_on_a_motor_in_stationary_axes() {
    let motor = of_specs("motor_stationary_axes", Keep::Needed);
    let run =
        |method, rtol| Simulation::new(&motor).rtol(rtol).method(method).run().expect("a run");
    let exact = run(Method::Dop853, 1e-13);
    let error = |method| error(&motor, &run(method, 1e-6), &exact);
    let (auto, series) = (error(Method::Auto), error(Method::Taylor));
    assert!(auto <= 2.0 * series && series < 1e-4, "{auto:e} {series:e}");
}

/// Bodies about a centre of gravity, whose series have many sums, and a chain of pendulums.
#[test]
fn series_with_many_sums_take_over_where_their_steps_are_long() {
    let bodies = of_specs("msl/spatial_point_gravity", Keep::Needed);
    let run = |method| {
        Simulation::new(&bodies).until(20.0).rtol(1e-6).method(method).run().expect("a run")
    };
    let [auto, pair] = [Method::Auto, Method::Dop853].map(run);
    let note = auto.notes.iter().find(|note| note.starts_with("taylor instead of dop853"));
    assert!(note.is_some(), "{:?}", auto.notes);
    let [few, many] = [&auto, &pair].map(|run| run.work.rate_evaluations);
    assert!(few < many, "{few} {many}");
    let chain = of_specs("bench/m6_10", Keep::Needed);
    let chain = Simulation::new(&chain).rtol(1e-6).method(Method::Auto).run().expect("a run");
    assert!(chain.notes.iter().all(|note| !note.contains("instead of")), "{:?}", chain.notes);
}

#[test]
fn auto_starts_with_series_where_they_tell_what_is_ahead() {
    let first = |name: &str, rtol| {
        let simulator = scenes::find_f64(name).unwrap();
        let base = Simulation::new(simulator).method(Method::Auto).rtol(rtol).points(2);
        base.until(0.01).run().unwrap().notes[0].clone()
    };
    // The last one has branches, which steps hold.
    for name in
        ["pendulum_chain", "winder_nonlinear", "motor_run_up", "saw_gin", "stick_slip_smooth"]
    {
        assert_eq!(first(name, 1e-6), "starts with taylor, for a relative tolerance of 1e-6");
    }
}

#[test]
fn auto_leaves_series_where_they_are_held_by_stability() {
    let simulator = scenes::find_f64("saw_gin").unwrap();
    let base = Simulation::new(simulator).parameter("coupling.stiffness", 1e5).unwrap();
    let base = base.until(0.1).points(11);
    let cases = [
        // The problem is so stiff that this is detected at the start.
        (1e6, 1e-5, "starts with rodas5p", 200),
        (1e6, 1e-6, "starts with radau", 200),
        // The stiffness is less obvious.
        (4.6e4, 1e-5, "rodas5p instead of taylor", 1000),
        (5.1e4, 1e-6, "radau instead of taylor", 1000),
    ];
    for (damping, rtol, note, most) in cases {
        let base = base.clone().parameter("coupling.damping", damping).unwrap();
        let exact = base.clone().method(Method::Radau).rtol(1e-11).run().unwrap();
        let run = base.method(Method::Auto).rtol(rtol).run().unwrap();
        println!("{:?}, {:?}", run.notes, run.work);
        assert!(run.notes.iter().any(|found| found.starts_with(note)), "{:?}", run.notes);
        assert!(run.work.steps < most, "{:?}", run.work);
        let found = error(simulator, &run, &exact);
        assert!(found < 100.0 * rtol, "{found:e}");
    }
}

#[test]
fn auto_returns_to_the_explicit_method_when_stiffness_ends() {
    // The rate of decay is 1e5 until about t = 1, then 1, with a constant excitation.
    let scalar = Scalar::new(
        |t, y| (1.0 + 1e5 / (1.0 + (40.0 * (t - 1.0)).exp())) * ((5.0 * t).sin() - y),
        |t, _| -(1.0 + 1e5 / (1.0 + (40.0 * (t - 1.0)).exp())),
        0.0,
    );
    let run = Simulation::new(&scalar).method(Method::Auto).rtol(1e-5).until(20.0).run();
    let run = run.unwrap();
    println!("{:?} {:?}", run.notes, run.work);
    assert_eq!(run.notes.len(), 2, "{:?}", run.notes);
    assert!(run.notes[0].starts_with("starts with rodas5p"), "{:?}", run.notes);
    assert!(run.notes[1].starts_with("dop853 instead of rodas5p"), "{:?}", run.notes);
    let exact = Simulation::new(&scalar).method(Method::Radau).rtol(1e-11).until(20.0).run();
    let difference = run.last("y").unwrap() - exact.unwrap().last("y").unwrap();
    assert!(difference.abs() < 1e-5, "{difference:e}");
}

#[test]
fn auto_doubts_an_explicit_method_whose_steps_rounding_keeps_short() {
    // Contacts of a hundred tons per metre between plates that move by micrometres per second:
    // rounding of their forces causes an error before a step is unstable.
    let preload = of_specs("msl/preload", Keep::Needed);
    let run = |method, rtol| Simulation::new(&preload).method(method).rtol(rtol).run().unwrap();
    let exact = run(Method::Radau, 1e-12);
    for rtol in [1e-10, 1e-11] {
        let auto = run(Method::Auto, rtol);
        println!("{:?} {:?}", auto.notes, auto.work);
        let is_doubted = |note: &String| {
            note.contains("steps stayed near the stability limit")
                || note.starts_with("starts with radau")
        };
        assert!(auto.notes.iter().any(is_doubted), "{:?}", auto.notes);
        // Without the check there would be millions of steps.
        assert!(auto.work.steps < 20_000, "{:?}", auto.work);
        let found = error(&preload, &auto, &exact);
        assert!(found < 100.0 * rtol, "{found:e} at {rtol:e}");
    }
}

/// Returns a hard spring whose damper fails after a second, according to an expression that goes
/// from 1 to 0.
fn hard_spring_once_damped(failing: &str) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "late"
        title = "A hard spring whose damper fails"
        [units.s]
        unit = "s"
        [outputs]
        x = "s.x"
        [run]
        until = 400.0
        points = 3
        [initial]
        "s.x" = 0.1
        [define.s.coordinates]
        x = {{ unit = "m" }}
        [define.s.parameters]
        c = {{ value = 1e5, unit = "N*s/m", doc = "damping at first" }}
        [define.s.energy]
        kinetic = "1 [kg]*x_dot^2/2"
        potential = "1e4 [N/m]*x^2/2 + 1e5 [N/m^3]*x^4/4"
        dissipation = "c*{failing}*x_dot^2/2"
        "#
    );
    of_text(&text, Keep::Needed)
}

#[test]
fn doubts_cost_little_where_accuracy_holds_steps_near_what_is_stable() {
    let scene = hard_spring_once_damped("(1 - tanh(20 [1/s]*(t - 1 [s])))/2");
    let auto = Simulation::new(&scene).method(Method::Auto).rtol(1e-5).run().unwrap();
    println!("{:?} {:?}", auto.notes, auto.work);
    let is_doubted = |note: &&String| note.contains("steps stayed near the stability limit");
    let doubts = auto.notes.iter().filter(is_doubted).count();
    assert!((1..8).contains(&doubts), "{:?}", auto.notes);
    // There are no steps by series.
    assert!(auto.work.factorizations < auto.work.steps / 20, "{:?}", auto.work);
}

#[test]
fn auto_leaves_series_whose_terms_are_no_numbers() {
    // The exponential overflows at t = 18.7, and its terms before; the quotient is zero.
    let scene = hard_spring_once_damped("1/(1 + exp(40 [1/s]*(t - 1 [s])))");
    let run = |method, rtol| Simulation::new(&scene).method(method).rtol(rtol).until(25.0).run();
    let exact = run(Method::Dop853, 1e-13).unwrap();
    for rtol in [1e-5, 1e-8] {
        let auto = run(Method::Auto, rtol).unwrap();
        println!("{:?} {:?}", auto.notes, auto.work);
        let is_told = |note: &String| note.starts_with("dop853 instead of taylor from t = 18.");
        assert!(auto.notes.iter().any(is_told), "{:?}", auto.notes);
        assert!(auto.work.steps < 20_000, "{:?}", auto.work);
        let found = error(&scene, &auto, &exact);
        assert!(found < 2e3 * rtol, "{found:e} at {rtol:e}");
    }
}

#[test]
fn auto_is_about_as_cheap_as_the_explicit_method_where_nothing_is_stiff() {
    let simulation = Simulation::new(&HardSpring).rtol(1e-6).points(2);
    let explicit = simulation.clone().method(Method::Dop853).run().unwrap();
    let auto = simulation.method(Method::Auto).run().unwrap();
    // It checks once whether anything is stiff.
    assert_eq!(Work { jacobian_evaluations: 1, ..explicit.work }, auto.work);
}

#[test]
fn all_methods_agree_on_the_saw_gin() {
    let simulator = scenes::find_f64("saw_gin").unwrap();
    let simulation = Simulation::new(simulator).points(41);
    let reference = simulation.clone().method(Method::Radau).rtol(1e-12).run().unwrap();
    for method in OWN {
        let run = simulation.clone().method(method).rtol(1e-7).run().unwrap();
        let found = error(simulator, &run, &reference);
        println!("{method}: {found:e}, {:?}", run.work);
        assert!(found < 1e-5, "{method} errs by {found:e}");
    }
}

#[test]
fn a_tolerance_finer_than_rounding_is_named() {
    for method in OWN {
        let refused = Simulation::new(&HardSpring).method(method).rtol(1e-17).run();
        let Err(SimulateError::Stopped { cause, .. }) = refused else { panic!("{method} runs") };
        assert_eq!(cause, StopCause::ToleranceBelowRounding { rtol: 1e-17 }, "{method}");
    }
}

#[test]
fn a_jacobian_that_is_not_finite_is_named() {
    let late: fn(f64, f64) -> f64 = |t, _| if t < 0.5 { -1.0 } else { f64::NAN };
    let never: fn(f64, f64) -> f64 = |_, _| f64::NAN;
    let cases =
        [Method::Rodas5p, Method::Radau].map(|method| [(method, late, 0.5), (method, never, 0.0)]);
    for (method, slope, from) in cases.into_iter().flatten() {
        let scalar = Scalar::new(|_, y| -y, slope, 1.0);
        match Simulation::new(&scalar).method(method).run() {
            Err(SimulateError::Stopped {
                cause: StopCause::NotFinite { what, .. }, time, ..
            }) => {
                assert_eq!(what, "the Jacobian of the rate of `y`", "{method}");
                // The last step before ends where the argument would become negative.
                assert!(time > from - 1e-12 && time < from + 0.2, "{method} stops at {time}");
            }
            other => panic!("{method}: {other:?}"),
        }
    }
}

#[test]
fn a_limit_on_steps_stops_every_method() {
    for method in OWN {
        let stopped = Simulation::new(&HardSpring).method(method).max_steps(3).run();
        let Err(SimulateError::Stopped { cause, .. }) = stopped else { panic!("{method} runs") };
        assert_eq!(cause, StopCause::TooManySteps { limit: 3 }, "{method}");
    }
}

#[test]
fn steps_that_lead_nowhere_near_the_end_stop_long_before_the_limit() {
    const STIFFNESS: f64 = 1e16;
    let scalar = Scalar::new(|t, y| -STIFFNESS * (y - t.cos()), |_, _| -STIFFNESS, 2.0);
    for method in [Method::Tsit5, Method::Dop853, Method::Tsit45] {
        let stopped = Simulation::new(&scalar).method(method).until(1.0).run();
        let Err(SimulateError::Stopped { cause, time, .. }) = stopped else {
            panic!("{method} runs")
        };
        let StopCause::TooSlowPace { step, steps } = cause else { panic!("{method}: {cause}") };
        assert!(time < 1e-9 && steps * step > 0.99, "{method} at {time}: {steps} of {step}");
    }
    // A check that may end the run early does not require the end to be reached.
    let asked = std::cell::Cell::new(0);
    let told = || {
        asked.set(asked.get() + 1);
        (asked.get() > 400_000).then_some(StopCause::Interrupted)
    };
    let left = Simulation::new(&scalar).method(Method::Tsit5).until_told(&told).run();
    let Err(SimulateError::Stopped { cause, .. }) = left else { panic!("it runs") };
    assert_eq!(cause, StopCause::Interrupted);
    // A million steps and more are not a failure.
    let scalar = Scalar::new(|t, y| -1e6 * (y - t.cos()), |_, _| -1e6, 2.0);
    let run = Simulation::new(&scalar).method(Method::Tsit5).until(1.0).run().expect("a run");
    assert!(run.work.steps > 200_000, "{} steps", run.work.steps);
}

#[test]
fn steps_so_many_that_their_errors_add_up_are_told_of() {
    let notes = |until: f64| {
        let simulator = scenes::find_f64("pendulum_chain").expect("a scene");
        let run = Simulation::new(simulator).method(Method::Tsit5).rtol(1e-3).until(until);
        run.run().expect("a run").notes
    };
    assert!(notes(1.0).is_empty());
    assert!(notes(30.0)[0].contains("errors add up"));
}

thread_local! {
    /// Times at which rates were evaluated.
    static ASKED: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
}

fn asked(time: f64, rate: f64) -> f64 {
    ASKED.with_borrow_mut(|asked| asked.push(time));
    rate
}

/// Hairer, Norsett, Wanner, section II.4, "Starting step size", for one equation.
#[test]
fn first_steps_are_those_of_the_book() {
    const RTOL: f64 = 1e-6;
    const FROM: f64 = 2.0;
    const UNTIL: f64 = 3.5;
    type Rate = fn(f64, f64) -> f64;
    let cases: [(Rate, f64, f64); 9] = [
        // The limit is the change of the rate, the rate, the guess, and the span.
        (|t, y| asked(t, -3.0 * y), 2.0, 1e-7),
        (|t, y| asked(t, -3.0 * y * y), 2.0, 1e-7),
        (|t, _| asked(t, 5.0), 2.0, 1e-7),
        (|t, y| asked(t, -100.0 * y), 2.0, 0.2),
        (|t, _| asked(t, 1.0), 8.0, 1e3),
        (|t, _| asked(t, 0.02), 8.0, 1e3),
        // Starts at rest, without a rate, and without either.
        (|t, y| asked(t, 1.0 - y), 0.0, 1e-7),
        (|t, y| asked(t, 2.0 - y), 2.0, 1e-7),
        (|t, _| asked(t, 0.0), 0.0, 1e-7),
    ];
    for (rate, y, atol) in cases {
        let scalar = Scalar::new(rate, |_, _| 0.0, y);
        let run = Simulation::new(&scalar).method(Method::Tsit5).from(FROM).until(UNTIL);
        ASKED.take();
        run.rtol(RTOL).atol(&[atol]).run().unwrap();
        let times = ASKED.take();
        // The start is evaluated slightly later.
        let mut later = times.into_iter().map(|time| time - FROM).filter(|time| *time > 1e-12);

        let scale = atol + RTOL * y;
        let f = rate(FROM, y);
        let (d0, d1) = (y / scale, f.abs() / scale);
        let h0 = if d0 < 1e-5 || d1 < 1e-5 { 1e-6 } else { 0.01 * d0 / d1 };
        let h0 = h0.min(UNTIL - FROM);
        let d2 = (rate(FROM, y + h0 * f) - f).abs() / scale / h0;
        let largest = d1.max(d2);
        let h1 = if largest <= 1e-15 { 1e-6 } else { (0.01 / largest).powf(0.2) };
        let first = h1.min(100.0 * h0).min(UNTIL - FROM);
        // The guess comes first, then the second stage.
        let found = [later.next(), later.next()].map(|time| time.unwrap());
        for (found, expected) in found.into_iter().zip([h0, 0.161 * first]) {
            assert!((found / expected - 1.0).abs() < 1e-6, "{y}: {found} {expected}");
        }
    }
}
