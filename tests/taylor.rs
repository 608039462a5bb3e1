//! Difficult cases for Taylor's method: series whose last coefficients vanish, branches, tables,
//! jumps, and the energy balance.

use std::f64::consts::{FRAC_PI_2, PI};

use machinist::error::StopCause;
use machinist::{Method, SimulateError, Simulation, Trajectory};
use machinist_contract::Simulator;
use machinist_scenes::scenes;

#[allow(dead_code, clippy::pedantic, reason = "tests need not use all; bodies are long")]
mod coupled {
    include!("../codegen/tests/emitted/coupled.rs");
}

#[allow(dead_code, clippy::pedantic, reason = "tests need not use all; bodies are long")]
mod recurrences {
    include!("../codegen/tests/emitted/recurrences.rs");
}

#[allow(dead_code, clippy::pedantic, reason = "tests need not use all; bodies are long")]
mod pendulum {
    include!("../codegen/tests/emitted/pendulum.rs");
}

fn run(simulation: Simulation<'_>, method: Method, rtol: f64) -> Trajectory {
    simulation.method(method).rtol(rtol).run().expect("a run to its end")
}

/// Returns the largest difference of the states of two runs, each over its scale.
fn difference(simulator: &dyn Simulator<f64>, a: &Trajectory, b: &Trajectory) -> f64 {
    let of_state = |index: usize| {
        let (name, scale) = (simulator.state(index).name, simulator.state_scale(index));
        let values = |run: &Trajectory| run.column(name).expect("a state").to_vec();
        let pairs = values(a).into_iter().zip(values(b));
        pairs.map(|(a, b)| (a - b).abs() / scale).fold(0.0, f64::max)
    };
    (0..simulator.shape().states()).map(of_state).fold(0.0, f64::max)
}

#[test]
fn errors_follow_the_tolerance_over_nine_decades() {
    for exponent in 3..=12 {
        let rtol = 10_f64.powi(-exponent);
        let run = run(Simulation::new(&crate::common::Oscillator), Method::Taylor, rtol);
        let angle = run.column("rotor.angle").expect("a state");
        let errors = run.times.iter().zip(angle);
        let errors = errors.map(|(time, q)| (q - crate::common::oscillator_state(*time)[0]).abs());
        let error = errors.fold(0.0, f64::max);
        println!("{rtol:e}: {error:e} in {} steps", run.work.steps);
        assert!(error < 10.0 * rtol, "{rtol:e}: {error:e}");
        assert!(run.work.steps < 60, "{rtol:e}: {} steps", run.work.steps);
    }
}

/// Returns the energy of the double pendulum of `coupled`.
fn energy([q_0, q_1, w_0, w_1]: [f64; 4]) -> f64 {
    let kinetic = w_0 * w_0 + 0.5 * w_1 * w_1 + (q_0 - q_1).cos() * w_0 * w_1;
    kinetic - 9.80665 * (2.0 * q_0.cos() + q_1.cos())
}

#[test]
fn a_chain_let_go_from_symmetric_rest_does_not_leap() {
    // In a horizontal position at rest, three of four coefficients vanish.
    let start = [FRAC_PI_2, FRAC_PI_2, 0.0, 0.0];
    for rtol in [1e-3, 1e-5, 1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12] {
        let simulation = Simulation::new(&coupled::Coupled).initial_state(&start).until(5.0);
        let run = run(simulation.points(501), Method::Taylor, rtol);
        let states = ["q_0", "q_1", "q_0_dot", "q_1_dot"].map(|name| run.column(name).unwrap());
        let energies = (0..501).map(|row| energy(states.map(|column| column[row])));
        let drift = energies.map(f64::abs).fold(0.0, f64::max) / 9.80665;
        println!("{rtol:e}: {drift:e} in {} steps", run.work.steps);
        assert!(drift < 200.0 * rtol, "{rtol:e}: energy drifts by {drift:e}");
    }
}

#[test]
fn machines_run_as_by_a_method_of_another_kind() {
    for name in ["motor_run_up", "saw_gin", "two_mass"] {
        let simulator = scenes::find_f64(name).expect("an emitted scene");
        let simulation = || Simulation::new(simulator).points(201);
        let reference = run(simulation(), Method::Tsit45, 1e-11);
        for rtol in [1e-5, 1e-8, 1e-10] {
            let error = difference(simulator, &run(simulation(), Method::Taylor, rtol), &reference);
            println!("{name} {rtol:e}: {error:e}");
            assert!(error < 30.0 * rtol.max(1e-10), "{name} at {rtol:e} differs by {error:e}");
        }
    }
}

#[test]
fn a_table_a_branch_and_a_jump_keep_their_accuracy() {
    // The drive of the pendulum jumps in at 0.1 s and follows a table with knots.
    let simulation = || Simulation::new(&pendulum::Pendulum).until(4.0).points(401);
    let reference = run(simulation(), Method::Tsit45, 1e-12);
    for rtol in [1e-4, 1e-6, 1e-8] {
        let found = run(simulation(), Method::Taylor, rtol);
        let error = difference(&pendulum::Pendulum, &found, &reference);
        println!("{rtol:e}: {error:e}, {:?}", found.work);
        assert!(error < 100.0 * rtol, "{rtol:e}: {error:e}");
    }
}

#[test]
fn corners_are_noticed_and_approached() {
    // States that integrate |x - v|, choices and tables of an oscillation.
    let start: Vec<f64> = (0..recurrences::STATES).map(|i| [0.3, 0.4, 0.0][i.min(2)]).collect();
    let simulation = || Simulation::new(&recurrences::Recurrences).initial_state(&start);
    let simulation =
        || simulation().parameter("drive.lag", 0.2).unwrap().until(2.0 * PI).points(65);
    let reference = run(simulation(), Method::Tsit45, 1e-11);
    for rtol in [1e-4, 1e-6, 1e-8] {
        let found = run(simulation(), Method::Taylor, rtol);
        let error = difference(&recurrences::Recurrences, &found, &reference);
        println!("{rtol:e}: {error:e}, {:?}", found.work);
        assert!(error < 1000.0 * rtol, "{rtol:e}: {error:e}");
    }
}

#[test]
fn dense_output_is_as_exact_as_the_steps() {
    let start = [FRAC_PI_2, 0.3, 0.0, 1.0];
    let simulation = || Simulation::new(&coupled::Coupled).initial_state(&start).until(2.0);
    let simulation = || simulation().points(1001);
    let exact = run(simulation(), Method::Taylor, 1e-13);
    for rtol in [1e-4, 1e-7, 1e-10] {
        let found = run(simulation(), Method::Taylor, rtol);
        let error = difference(&coupled::Coupled, &found, &exact);
        println!("{rtol:e}: {error:e} in {} steps", found.work.steps);
        assert!(found.work.steps < 100, "far fewer steps than samples");
        assert!(error < 200.0 * rtol, "{rtol:e}: {error:e}");
    }
}

#[test]
fn the_energy_account_closes() {
    let simulator = scenes::find_f64("saw_gin").expect("an emitted scene");
    let simulation = Simulation::new(simulator).points(101).with_energy_balance(true);
    let run = run(simulation, Method::Taylor, 1e-9);
    let residual = run.energy_balance.expect("asked for").max_residual_relative();
    assert!(residual < 1e-7, "{residual:e}");
}

#[test]
fn simulators_without_series_are_refused_with_advice() {
    let scalar = crate::common::Scalar::new(|_, y| -y, |_, _| -1.0, 1.0);
    assert!(!Method::Taylor.suits(&scalar));
    match Simulation::new(&scalar).method(Method::Taylor).run() {
        Err(SimulateError::Stopped { cause: cause @ StopCause::NoSeries, .. }) => {
            let message = cause.to_string();
            assert!(message.contains("no Taylor series"), "{message}");
        }
        other => panic!("{other:?}"),
    }
}
