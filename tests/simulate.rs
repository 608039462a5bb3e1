//! Runs against closed forms, and all kinds of refusal.

use std::f64::consts::PI;
use std::sync::atomic::AtomicBool;

use crate::common::{Oscillator, Scalar, oscillator_state};
use crate::own_scene::of_text;
use machinist::error::StopCause;
use machinist::method::Work;
use machinist::trajectory::ColumnKind;
use machinist::{Method, SimulateError, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_scenes::scenes;

/// Returns the largest error of the oscillator's angle \[rad\] over all output times.
fn oscillator_error(trajectory: &Trajectory) -> f64 {
    let angle = trajectory.column("rotor.angle").unwrap();
    let errors =
        trajectory.times.iter().zip(angle).map(|(t, q)| (q - oscillator_state(*t)[0]).abs());
    errors.fold(0.0, f64::max)
}

/// Returns the allowed error of a run: if an error h^(p+1) of each step is kept at the tolerance,
/// the error of the run is h^p, the tolerance to the power p/(p + 1).
fn allowed(method: Method, rtol: f64) -> f64 {
    let order = f64::from(method.order().min(4));
    30.0 * rtol.powf(order / (order + 1.0))
}

/// Returns the methods that can run this simulator: one written as a closure has no Taylor series.
fn methods_for(simulator: &dyn Simulator<f64>) -> impl Iterator<Item = Method> {
    Method::compiled_in().filter(|method| method.suits(simulator))
}

fn refusal(simulation: &Simulation<'_>) -> SimulateError {
    simulation.run().expect_err("this run must be refused")
}

#[test]
fn every_method_follows_the_closed_form_in_proportion_to_its_tolerance() {
    for method in methods_for(&Oscillator) {
        let error = |rtol| {
            let run = Simulation::new(&Oscillator).method(method).rtol(rtol).run().unwrap();
            oscillator_error(&run)
        };
        for rtol in [1e-4, 1e-6, 1e-8] {
            let found = error(rtol);
            println!("{method} {rtol:e}: {found:e} ({:.1} rtol)", found / rtol);
            assert!(found < allowed(method, rtol), "{method} at {rtol:e} errs by {found:e}");
        }
    }
}

#[test]
fn a_jump_costs_no_accuracy_because_the_run_stops_there() {
    // y' = 1 before 1/3, 1000 afterwards: a step across that time would err by O(1000 h).
    const JUMP: f64 = 1.0 / 3.0;
    let mut scalar = Scalar::new(|t, _| if t < JUMP { 1.0 } else { 1000.0 }, |_, _| 0.0, 0.0);
    scalar.jumps = &[JUMP];
    for method in methods_for(&scalar) {
        let run = Simulation::new(&scalar).method(method).until(1.0).run().unwrap();
        let exact = JUMP + 1000.0 * (1.0 - JUMP);
        let error = (run.last("y").unwrap() / exact - 1.0).abs();
        assert!(error < 1e-12, "{method} errs by {error:e}");
    }
}

#[test]
fn the_state_at_a_jump_itself_belongs_to_both_sides() {
    let times = [0.7f64.next_down(), 0.7, 0.7f64.next_up(), 3.0];
    for method in methods_for(&Oscillator) {
        let run =
            Simulation::new(&Oscillator).method(method).rtol(1e-9).times(&times).run().unwrap();
        let speed = run.column("rotor.omega").unwrap();
        let spread = (speed[0] - speed[1]).abs().max((speed[2] - speed[1]).abs());
        assert!(spread < 1e-12, "{method}: {spread:e}");
        assert_eq!(run.column("drive_torque").unwrap()[..2], [0.0, 30.0], "{method}");
    }
}

#[test]
fn jumps_outside_repeated_and_nearly_equal_are_harmless() {
    let mut scalar = Scalar::new(|t, y| t.cos() - y, |_, _| -1.0, 0.0);
    let without = Simulation::new(&scalar).rtol(1e-9).run().unwrap().last("y").unwrap();
    scalar.jumps = &[0.3, 0.1 + 0.2, 0.3, -1.0, 0.0, 2.0, 5.0, 1.0];
    for method in methods_for(&scalar) {
        let with = Simulation::new(&scalar).rtol(1e-9).method(method).run().unwrap();
        let difference = (with.last("y").unwrap() - without).abs();
        assert!(difference < allowed(method, 1e-9), "{method}: {difference:e}");
    }
}

#[test]
fn implicit_methods_cross_a_stiff_transient_in_few_steps() {
    // Prothero and Robinson: y' = -L (y - cos t) - sin t, y = cos t + e^(-L t).
    const STIFFNESS: f64 = 1e6;
    let scalar = Scalar::new(|t, y| -STIFFNESS * (y - t.cos()) - t.sin(), |_, _| -STIFFNESS, 2.0);
    for method in Method::compiled_in().filter(|method| method.is_implicit()) {
        for rtol in [1e-4, 1e-6] {
            let simulation = Simulation::new(&scalar).method(method).rtol(rtol).until(PI);
            let run = simulation.run().unwrap();
            let error = (run.last("y").unwrap() - PI.cos()).abs();
            println!("{method} {rtol:e}: error {error:e}, {:?}", run.work);
            assert!(error < 10.0 * rtol, "{method} at {rtol:e} errs by {error:e}");
            assert!(run.work.steps < 2000, "{method} took {} steps", run.work.steps);
        }
    }
    let explicit = Simulation::new(&scalar).method(Method::Tsit45).until(PI).max_steps(2000);
    match refusal(&explicit) {
        SimulateError::Stopped { cause: StopCause::TooManySteps { limit: 2000 }, .. } => {}
        other => panic!("{other}"),
    }
}

#[test]
fn a_flag_stops_every_method_and_what_there_is_of_the_run_is_handed_over() {
    let flag = AtomicBool::new(true);
    for method in methods_for(&Oscillator) {
        let simulation = Simulation::new(&Oscillator).method(method).points(1001);
        let SimulateError::Stopped { time, cause, kept, .. } =
            refusal(&simulation.clone().until_flagged(&flag))
        else {
            panic!("{method}")
        };
        assert_eq!(cause, StopCause::Interrupted, "{method}");
        let kept = kept.expect("what there is of the run");
        assert!(kept.times.len() < 1001 && kept.times[0] == 0.0, "{method}");
        assert!(kept.times.last().is_some_and(|last| *last <= time), "{method}");
        let told = || Some(StopCause::TooSlow { seconds: 1.0 });
        match refusal(&simulation.clone().until_told(&told)) {
            SimulateError::Stopped { cause: StopCause::TooSlow { .. }, kept: Some(_), .. } => {}
            other => panic!("{method}: {other}"),
        }
        let unset = AtomicBool::new(false);
        let run = simulation.clone().until_flagged(&unset).run().unwrap();
        assert_eq!(run, simulation.run().unwrap(), "{method}");
    }
}

#[test]
fn the_energy_account_closes_for_every_method() {
    for method in methods_for(&Oscillator) {
        for rtol in [1e-5, 1e-8] {
            let simulation = Simulation::new(&Oscillator).method(method).rtol(rtol);
            let plain = simulation.run().unwrap();
            let run = simulation.with_energy_balance(true).run().unwrap();
            let balance = run.energy_balance.as_ref().unwrap();
            let residual = balance.max_residual_relative();
            println!("{method} {rtol:e}: {residual:e}\n  {:?}\n  {:?}", plain.work, run.work);
            assert!(residual > 0.0 && residual < 100.0 * rtol, "{method}: {residual:e}");
            assert!(oscillator_error(&run) < allowed(method, rtol), "{method}");
            let passed = balance.passed.last().unwrap();
            assert!(*passed > 1.0, "{method} passed {passed} J");
            assert_eq!(run.last("energy.supplied"), balance.supplied.last().copied());
        }
    }
}

#[test]
fn the_energy_account_costs_newton_few_more_steps() {
    for method in Method::compiled_in().filter(|method| method.is_implicit()) {
        let simulation = Simulation::new(&Oscillator).method(method).rtol(1e-7);
        let plain = simulation.run().unwrap().work.steps as f64;
        let with = simulation.with_energy_balance(true).run().unwrap().work.steps as f64;
        assert!(with < 2.0 * plain, "{method}: {with} steps against {plain}");
    }
}

#[test]
fn power_that_no_energy_accounts_for_is_the_residual() {
    // Nothing is stored, so the residual is minus the work of cos(3 t) W.
    let mut scalar = Scalar::new(|t, y| t.sin() - 50.0 * y, |_, _| -50.0, 1.0);
    scalar.supplied = |t| (3.0 * t).cos();
    for method in methods_for(&scalar) {
        let simulation = Simulation::new(&scalar).method(method).rtol(1e-7);
        let times = [0.5, 1.0, PI / 2.0, 2.0];
        let run = simulation.times(&times).with_energy_balance(true).run().unwrap();
        let balance = run.energy_balance.unwrap();
        for (time, residual) in times.iter().zip(&balance.residual) {
            let error = (residual + (3.0 * time).sin() / 3.0).abs();
            assert!(error < 1e-4, "{method}: {error:e} J at {time}");
        }
        // |cos 3t| over [0, pi/2] is three half waves of area 1/3.
        assert!((balance.passed[2] - 1.0).abs() < 1e-4, "{method}: {}", balance.passed[2]);
        let relative = balance.max_residual_relative();
        assert!((relative - 0.3325 / balance.passed[3]).abs() < 1e-3, "{method}: {relative}");
    }
}

#[test]
fn two_runs_are_equal_to_the_last_bit() {
    for method in methods_for(&Oscillator) {
        let simulation = Simulation::new(&Oscillator).method(method).with_energy_balance(true);
        let bytes = || {
            let mut csv = Vec::new();
            simulation.run().unwrap().write_csv(&mut csv).unwrap();
            csv
        };
        assert_eq!(bytes(), bytes(), "{method}");
    }
}

#[test]
fn output_times_do_not_change_the_steps() {
    for method in methods_for(&Oscillator) {
        let simulation = Simulation::new(&Oscillator).method(method);
        let few = simulation.clone().points(2).run().unwrap();
        let many = simulation.points(5000).run().unwrap();
        let steps = |work: Work| (work.steps, work.rejected, work.jacobian_evaluations);
        assert_eq!(steps(few.work), steps(many.work), "{method}");
        assert_eq!(few.last("rotor.angle"), many.last("rotor.angle"), "{method}");
    }
}

#[test]
fn a_trajectory_has_states_outputs_and_energy_with_units() {
    let run = Simulation::new(&Oscillator).run().unwrap();
    let names: Vec<_> = run.columns.iter().map(|c| (c.name.as_str(), c.unit.as_str())).collect();
    let wanted = [
        ("rotor.angle", "rad"),
        ("rotor.omega", "rad/s"),
        ("spring_torque", "N m"),
        ("drive_torque", "N m"),
        ("energy.total", "J"),
    ];
    assert_eq!(names, wanted);
    assert_eq!(run.of_kind(ColumnKind::Output).count(), 2);
    assert!(run.columns.iter().all(|column| column.values.len() == 301));
    assert_eq!((run.times[0], run.times[300]), (0.0, 3.0));
    assert_eq!(run.column("rotor.speed"), None);
    assert!(run.work.rate_evaluations > run.work.steps && run.work.jacobian_evaluations > 0);
    assert!(run.work.factorizations >= run.work.jacobian_evaluations / 2);
}

#[test]
fn a_run_takes_what_the_user_adjusts() {
    let base = Simulation::new(&Oscillator);
    let by_name = base.clone().parameter("rotor.stiffness", 0.0).unwrap();
    let by_list = base.clone().parameters(&[2.0, 0.8, 0.0, 30.0, 0.7]);
    assert_eq!(by_name.run().unwrap(), by_list.run().unwrap());
    // Without spring, torque and motion at the start, nothing moves.
    let still = by_name.parameter("torque", 0.0).unwrap().initial_state(&[1.5, 0.0]);
    let still = still.from(1.0).until(2.0).run().unwrap();
    assert_eq!((still.times[0], still.last("rotor.angle")), (1.0, Some(1.5)));
    // An absolute tolerance as tight as a relative one costs steps.
    let loose = base.clone().atol(&[1e-2, 1e-2]).run().unwrap();
    let tight = base.atol(&[1e-12, 1e-12]).run().unwrap();
    assert!(loose.work.steps < tight.work.steps);
}

#[test]
fn unknown_names_are_refused_with_the_nearest_known() {
    let error = Simulation::new(&Oscillator).parameter("rotor.inertai", 1.0).err().unwrap();
    assert_eq!(
        error.to_string(),
        "scene `oscillator` has no parameter `rotor.inertai` (did you mean `rotor.inertia`?)"
    );
    let error = Method::from_name("bfd").unwrap_err();
    assert_eq!(
        error.to_string(),
        "there is no method `bfd` (did you mean `bdf`?); known are bdf, tr_bdf2, esdirk34, \
         tsit45, tsit5, dop853, rodas5p, radau, auto, taylor, exact"
    );
    let error = "runge".parse::<Method>().unwrap_err().to_string();
    assert!(error.starts_with("there is no method `runge`; known are bdf"), "{error}");
    for method in methods_for(&Oscillator) {
        assert_eq!(Method::from_name(method.name()), Ok(method));
    }
}

#[test]
fn senseless_requests_are_refused_and_named() {
    let base = || Simulation::new(&Oscillator);
    let cases: [(Simulation<'_>, &str); 16] = [
        (base().rtol(0.0), "relative tolerance 0"),
        (base().rtol(f64::NAN), "relative tolerance NaN"),
        (base().rtol(-1e-6), "relative tolerance -0.000001"),
        (base().until(0.0), "from 0 s until 0 s"),
        (base().until(f64::INFINITY), "until inf s"),
        (base().from(f64::NAN), "from NaN s"),
        (base().points(1), "1 output points"),
        (base().points(10_000_001), "2 to 10000000"),
        (base().times(&[0.0, 2.0, 1.0]), "output time number 2, 1 s"),
        (base().times(&[0.0, 3.1]), "output time number 1, 3.1 s"),
        (base().times(&[0.0, f64::NAN]), "output time number 1, NaN s"),
        (base().parameters(&[1.0]), "has 5 parameters, but 1 values"),
        (base().parameter("torque", f64::NAN).unwrap(), "parameter `torque` is NaN"),
        (base().initial_state(&[1.0]), "has 2 states, but 1 values"),
        (base().initial_state(&[0.0, f64::INFINITY]), "initial value of `rotor.omega` is inf"),
        (base().atol(&[1e-6, 0.0]), "absolute tolerance 0 of `rotor.omega`"),
    ];
    for (simulation, part) in cases {
        let message = refusal(&simulation).to_string();
        assert!(message.contains(part), "`{message}` does not say `{part}`");
    }
}

#[test]
fn a_solution_that_explodes_stops_with_the_time_it_explodes_at() {
    let scalar = Scalar::new(|_, y| y * y, |_, y| 2.0 * y, 1.0);
    for method in methods_for(&scalar) {
        match refusal(&Simulation::new(&scalar).method(method).max_steps(100_000)) {
            SimulateError::Stopped { time, method: name, scene, .. } => {
                assert!((time - 1.0).abs() < 1e-3, "{method} stopped at {time}");
                assert_eq!((name, scene.as_str()), (method.name(), "scalar"));
            }
            other => panic!("{method}: {other}"),
        }
    }
}

#[test]
fn a_rate_that_turns_nan_is_named() {
    // y' = -sqrt(y) - 1 reaches zero and would continue into the root of a negative number.
    let scalar = Scalar::new(|_, y| -y.sqrt() - 1.0, |_, y| -0.5 / y.sqrt(), 0.25);
    for method in methods_for(&scalar) {
        match refusal(&Simulation::new(&scalar).method(method)) {
            SimulateError::Stopped { time, cause: StopCause::NotFinite { what, .. }, .. } => {
                assert!(time < 0.25 && time > 0.1, "{method}: {time}");
                assert!(what.ends_with("the rate of `y`"), "{method}: {what}");
            }
            other => panic!("{method}: {other}"),
        }
    }
    let scalar = Scalar::new(|t, _| (t - 1.0).ln(), |_, _| 0.0, 0.0);
    let message = refusal(&Simulation::new(&scalar)).to_string();
    assert!(
        message.starts_with("scalar: method `bdf` stopped at t = 0 s: the rate of `y` is not"),
        "{message}"
    );
}

#[test]
fn a_trial_step_into_nan_is_repeated_shorter() {
    // The root is real all along the solution, y = 1 - t^2/4 for t < 2, and steps that overshoot
    // its end must not stop a run that ends before.
    let scalar = Scalar::new(|_, y| -(1.0 - y).sqrt() - 1e-9, |_, y| 0.5 / (1.0 - y).sqrt(), 0.0);
    for method in methods_for(&scalar) {
        let run = Simulation::new(&scalar).method(method).until(1.0).run();
        assert!(run.is_ok(), "{method}: {}", run.unwrap_err());
    }
}

#[test]
fn a_jump_that_is_not_declared_still_ends() {
    let scalar = Scalar::new(
        |t, y| if t < 0.77 { 1.0 } else { -5.0 - y },
        |t, _| if t < 0.77 { 0.0 } else { -1.0 },
        0.0,
    );
    let exact = (0.77 + 5.0) * (-1.23f64).exp() - 5.0;
    for method in methods_for(&scalar) {
        let run = Simulation::new(&scalar).method(method).run().unwrap();
        let error = (run.last("y").unwrap() - exact).abs();
        assert!(error < 1e-3, "{method} errs by {error:e}");
    }
}

#[test]
fn a_long_run_is_not_stopped_by_newtons_failures_adding_up() {
    // An undeclared jump every tenth of a second disturbs Newton's iteration each time.
    let scalar = Scalar::new(
        |t, y| -100.0 * (y.powi(3) - if (t * 10.0) as i64 % 2 == 0 { 1.0 } else { -8.0 }),
        |_, y| -300.0 * y * y,
        1.0,
    );
    let run = Simulation::new(&scalar).until(30.0).run().unwrap();
    assert!(run.last("y").unwrap().abs() < 2.1);
}

#[test]
fn a_tolerance_below_rounding_does_not_hang() {
    for method in methods_for(&Oscillator) {
        let run = Simulation::new(&Oscillator).method(method).rtol(1e-18).max_steps(5000).run();
        assert!(matches!(run, Err(SimulateError::Stopped { .. })), "{method}");
    }
}

#[test]
fn a_run_far_from_time_zero_ends_on_time() {
    for method in methods_for(&Oscillator) {
        let simulation = Simulation::new(&Oscillator).method(method).points(11);
        let run = simulation.from(1e6).until(1e6 + 0.5).run().unwrap();
        assert_eq!(run.times.last(), Some(&(1e6 + 0.5)));
        // The torque is on: motion about 0.6 rad from 0.4 rad at rest.
        let exact = 0.6 - 0.2 * oscillator_state(0.5)[0] / 0.4;
        let error = (run.last("rotor.angle").unwrap() - exact).abs();
        assert!(error < allowed(method, 1e-8), "{method} errs by {error:e}");
    }
}

/// A logarithm of a value that becomes negative, and one of a value that always is.
#[test]
fn outputs_that_are_no_numbers_are_told_of() {
    let text = r#"
        [scene]
        name = "logarithms"
        [parameters]
        shift = { value = 0.5, unit = "1", doc = "shift" }
        [units.s]
        unit = "s"
        [initial]
        "s.x" = 1.0
        [outputs]
        late = { expression = "ln(s.x/1 [m] - shift)", unit = "1", doc = "falls without end" }
        [run]
        until = 2.0
        points = 21
        [define.s.coordinates]
        x = { unit = "m" }
        [define.s.energy]
        kinetic = "1 [kg]*x_dot^2/2"
        potential = "1 [N/m]*x^2/2"
        "#;
    let scene = of_text(text, Keep::Needed);
    let run = Simulation::new(&scene).run().expect("the states are numbers");
    // cos(t) passes 0.5 at pi/3, the first of the times behind which is 1.1.
    let told = "output `late` is NaN at 1.1 s, and not a finite number at 10 of 21 times";
    assert!(run.notes.iter().any(|note| note == told), "{:?}", run.notes);
    let before = Simulation::new(&scene).until(1.0).run().expect("all are");
    assert!(before.notes.iter().all(|note| !note.contains("not a finite number")));
}

#[test]
fn a_linear_machine_of_coefficients_beyond_squares_is_refused() {
    let scene = scenes::find_f64("two_mass").expect("a scene");
    for damping in [-1.5e245, 1.5e245] {
        let run = Simulation::new(scene).parameter("coupling.damping", damping).expect("it");
        let run = run.initial_value("cylinder.omega", 3.0).expect("a state").until(0.01);
        for method in [Method::Auto, Method::Exact] {
            assert!(run.clone().method(method).run().is_err(), "{method} at {damping:e}");
        }
    }
}

#[test]
fn masses_of_the_wrong_sign_are_told_of() {
    let notes = |scene: &dyn Simulator<f64>, name: &str, value: f64| {
        let run = Simulation::new(scene).parameter(name, value).expect("a parameter");
        let run = run.until(run_end(scene)).rtol(1e-6).run();
        run.map_or_else(|_| Vec::new(), |run| run.notes)
    };
    let told = |notes: &[String]| notes.iter().any(|note| note.contains("of the wrong sign"));
    let two_mass = scenes::find_f64("two_mass").expect("a scene");
    let negative = notes(two_mass, "driver.inertia", -1.0);
    assert!(negative.iter().any(|note| note.contains("`driver.phi` is negative")), "{negative:?}");
    let text = r#"
        [scene]
        name = "hidden"
        title = "A mass that is negative along neither coordinate"
        [units.s]
        unit = "s"
        [outputs]
        x = "s.x"
        [run]
        until = 0.1
        points = 3
        [define.s.coordinates]
        x = { unit = "m" }
        y = { unit = "m" }
        [define.s.parameters]
        m = { value = 0.5, unit = "kg", doc = "beside the diagonal" }
        [define.s.energy]
        kinetic = "1 [kg]*x_dot^2/2 + 1 [kg]*y_dot^2/2 + m*x_dot*y_dot"
        potential = "1 [N/m]*x^2/2 + 1 [N/m]*y^2/2"
        "#;
    let hidden = of_text(text, Keep::All);
    assert!(told(&notes(&hidden, "s.m", 2.0)) && !told(&notes(&hidden, "s.m", 0.5)));
    for name in scenes::NAMES {
        let Some(scene) = scenes::find_f64(name) else { continue };
        let run = Simulation::new(scene).until(run_end(scene)).rtol(1e-6).run();
        let notes = run.map_or_else(|_| Vec::new(), |run| run.notes);
        assert!(!told(&notes), "{name}: {notes:?}");
    }
}

/// Soon after the start.
fn run_end(scene: &dyn Simulator<f64>) -> f64 {
    let run = scene.run_defaults();
    run.from + 1e-3 * (run.until - run.from)
}

#[test]
fn energies_that_are_no_numbers_are_told_of() {
    let scene = scenes::find_f64("two_mass").expect("a scene");
    let heavy = Simulation::new(scene).parameter("cylinder.inertia", 1e308).expect("a parameter");
    let turning = heavy.initial_value("cylinder.omega", 10.0).expect("a state");
    let run = turning.until(0.1).points(3).run();
    let notes = run.expect("the states are numbers").notes;
    let told = "the energy is inf at 0 s, and not a finite number at 3 of 3 times";
    assert!(notes.iter().any(|note| note == told), "{notes:?}");
}
