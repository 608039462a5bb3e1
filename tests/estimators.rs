//! Extended Kalman filters against differences of their steps, the steady covariance of a linear
//! machine, and their own errors.

#[rustfmt::skip]
mod emitted {
    pub use machinist_scenes::scenes::saw_gin;
    pub mod saw_gin_ekf;
}

mod operations;

use std::path::Path;

use machinist::Simulation;
use machinist::estimator::{
    Consistency, ConsistencyRun, Estimator, EstimatorDesign, EstimatorError, EstimatorIndices,
    Instant,
};
use machinist::linear_analysis::{Hold, Linearization, Place, Weight, operating_point};
use machinist_codegen::emit::EmitOptions;
use machinist_codegen::emit::c99::EstimatorOptions;
use machinist_codegen::emit::rust::emit_estimator;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_contract::fixed_step::{Clock, FixedMethod, FixedSteps, Room, StepMethod};

use machinist_model::{Elimination, ModelSimulator};

use crate::own_scene::{model_of_specs, of_specs, of_text};

fn list(of: &[(&str, f64)]) -> Vec<(String, f64)> {
    of.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect()
}

/// Returns the state after steps from another start, and the estimated parameters.
fn stepped(
    simulator: &dyn Simulator<f64>,
    method: FixedMethod<'_>,
    (time, step, steps): (f64, f64, usize),
    state: &[f64],
    parameters: &[f64],
) -> Vec<f64> {
    let mut constants = vec![0.0; simulator.constants()];
    simulator.prepare(parameters, &mut constants);
    let machine = FixedSteps {
        simulator,
        parameters,
        constants: &constants,
        method,
        parts_a_step: FixedSteps::<f64>::enough_parts(simulator),
    };
    let [numbers, signs] = machine.room();
    let (mut numbers, mut signs) = (vec![0.0; numbers], vec![0; signs]);
    let mut room = Room { numbers: &mut numbers, signs: &mut signs };
    let mut state = state.to_vec();
    let mut clock = Clock::new(time);
    machine.restore_and_settle(time, &mut state, &mut room);
    for _ in 0..steps {
        let _ = machine.step(clock.time(), step, &mut state, &mut room);
        clock.pass(step);
    }
    state
}

fn method_name(method: &FixedMethod<'_>) -> &'static str {
    match method {
        FixedMethod::RungeKutta4 => "rk4",
        FixedMethod::Heun => "heun",
        FixedMethod::Rosenbrock2(_) => "ros2",
    }
}

/// Compares the covariance after steps with the one by central differences of the steps, entry by
/// entry, relative to the product of the deviations.
fn compare_with_differences(
    name: &str,
    (time, step, steps): (f64, f64, usize),
    (uncertain, estimated): (&[&str], &[&str]),
    (size, tolerances): (f64, [f64; 3]),
) {
    let simulator = of_specs(name, Keep::Needed);
    let simulator: &dyn Simulator<f64> = simulator.single();
    let point = operating_point(&Simulation::new(simulator), Place::Time(time)).expect("a point");
    let states = simulator.shape().states();
    let is_uncertain = |entry: usize| {
        !simulator.is_mode(entry)
            && (uncertain.is_empty() || uncertain.contains(&simulator.state(entry).name))
    };
    let free: Vec<usize> = (0..states).filter(|entry| is_uncertain(*entry)).collect();
    let mut start: Vec<(String, f64)> = free
        .iter()
        .map(|entry| (simulator.state(*entry).name.to_owned(), simulator.state_scale(*entry)))
        .collect();
    for name in estimated {
        start.push(((*name).to_owned(), 1.0));
    }
    let list = Elimination::new(states, simulator.rate_jacobian_pattern().entries);
    let methods =
        [FixedMethod::RungeKutta4, FixedMethod::Heun, FixedMethod::Rosenbrock2(list.borrowed())];
    for (method, allowed) in methods.into_iter().zip(tolerances) {
        let design = EstimatorDesign {
            method,
            measured: vec![(simulator.output(0).name.to_owned(), 1.0)],
            estimated: estimated.iter().map(|name| (*name).to_owned()).collect(),
            start: start.clone(),
            ..EstimatorDesign::default()
        };
        let indices = design.indices(simulator).expect("names of the scene");
        let mut estimator =
            Estimator::at(simulator, &indices, point.time, &point.state, &point.parameters);
        for _ in 0..steps {
            let _ = estimator.predict(step);
        }
        let fixed = indices.filter(simulator).method;
        let of = |entry: usize, by: f64| {
            let (mut state, mut parameters) = (point.state.clone(), point.parameters.clone());
            match entry.checked_sub(states) {
                None => state[entry] += by,
                Some(slot) => parameters[indices.estimated[slot]] += by,
            }
            stepped(simulator, fixed, (point.time, step, steps), &state, &parameters)
        };
        let columns: Vec<Vec<f64>> = (free.iter().copied())
            .chain(states..states + estimated.len())
            .map(|entry| {
                let by = size * indices.start[entry];
                let [above, below] = [of(entry, by), of(entry, -by)];
                above.iter().zip(below).map(|(a, b)| (a - b) / (2.0 * size)).collect()
            })
            .collect();
        let wanted = |row: usize, column: usize| -> f64 {
            columns.iter().map(|entries| entries[row] * entries[column]).sum()
        };
        for row in 0..states {
            for column in 0..states {
                // What the constraints determine has a deviation of rounding.
                let scale = |entry: usize| 1e-6 * simulator.state_scale(entry);
                let deviation = |entry: usize| wanted(entry, entry).sqrt().max(scale(entry));
                let size = deviation(row) * deviation(column);
                let error = (estimator.covariance(row, column) - wanted(row, column)).abs();
                let [row, column] = [row, column].map(|entry| simulator.state(entry).name);
                assert!(
                    error <= allowed * size,
                    "{name} by {}: {row}, {column}: {error:e} of {size:e}",
                    method_name(&method)
                );
            }
        }
    }
}

#[test]
fn covariances_follow_the_derivative_of_the_steps() {
    compare_with_differences("saw_gin", (1.0, 1e-3, 20), (&[], &["load.mean"]), (1e-6, [1e-7; 3]));
    compare_with_differences("two_mass", (0.0, 1e-3, 20), (&[], &[]), (1e-5, [1e-7; 3]));
    // Far from linear within a step: second derivatives of the rate count.
    compare_with_differences("pendulum_chain", (0.0, 2e-2, 40), (&[], &[]), (1e-5, [1e-7; 3]));
}

#[test]
fn covariances_follow_the_derivative_across_events_and_their_times() {
    // Contact and rebound; the belt lets go. The time of an event deviates as that of the motion,
    // from which the located root differs by the order of the method.
    compare_with_differences("bouncing_mass", (0.0, 1e-3, 700), (&[], &[]), (1e-7, [1e-5; 3]));
    compare_with_differences(
        "stick_slip",
        (0.0, 1e-3, 2000),
        (&["slider.x"], &[]),
        (1e-7, [1e-5, 1e-2, 1e-2]),
    );
}

#[test]
fn covariances_follow_the_derivative_as_a_brake_slips_and_locks() {
    // The tightening rope tears the drum loose at 3.09 s; a constraint holds it again at 3.11 s. Heun's
    // steps find these times to first order in their length.
    for state in ["motor.phi", "motor.omega", "wheel.omega", "motor.current"] {
        compare_with_differences(
            "drives/winch",
            (3.08, 2.5e-4, 120),
            (&[state], &[]),
            (1e-7, [1e-2; 3]),
        );
    }
}

#[test]
fn covariances_follow_the_derivative_of_the_projection() {
    compare_with_differences(
        "pendulum_constrained",
        (0.0, 1e-3, 50),
        (&[], &[]),
        (1e-5, [1e-6, 1e-6, 1e-5]),
    );
    compare_with_differences("slider_crank", (0.0, 1e-4, 50), (&[], &[]), (1e-5, [1e-6; 3]));
    compare_with_differences(
        "parts/spatial/revolute_constraint",
        (0.0, 1e-3, 50),
        (&[], &[]),
        (1e-6, [1e-6, 1e-6, 1e-5]),
    );
}

/// A motor that lifts a load by an elastic rope: a linear machine.
const HOIST: &str = r#"
[scene]
name = "hoist"
title = "A winch"

[units]
motor = { unit = "electrical/dc_motor", inputs = { voltage = "5.109375 [V] + command" } }
gear = { unit = "rotational/gear", parameters = { ratio = 20 } }
wheel = { unit = "rotational/inertia", parameters = { inertia = 2 } }
drum = { unit = "rotational/rack", parameters = { radius = 0.25 } }
rope = { unit = "translational/spring_damper", parameters = { stiffness = 4e5, damping = 2e3 } }
load = { unit = "translational/mass", parameters = { mass = 500 } }
weight = { unit = "sources/force", inputs = { force = "-load.mass*9.81 [m/s^2] + gust" } }

[parameters]
command = { value = 0, unit = "V", doc = "voltage" }
gust = { value = 0, unit = "N", doc = "force on the load" }

[[joints]]
connect = ["motor.a", "gear.a"]
[[joints]]
connect = ["gear.b", "wheel.a"]
[[joints]]
connect = ["drum.a", "wheel.a"]
[[joints]]
connect = ["drum.b", "rope.b"]
[[joints]]
connect = ["rope.a", "load.a"]
[[joints]]
connect = ["weight.a", "load.a"]

[outputs]
height = "load.x"
current = "motor.current"
pull = "rope.force"

[run]
until = 3.0
points = 401
method = "auto"
"#;

#[test]
fn the_covariance_of_a_linear_machine_becomes_that_of_the_riccati_equation() {
    let simulator = of_text(HOIST, Keep::Needed);
    let simulator: &dyn Simulator<f64> = simulator.single();
    let run = Simulation::new(simulator);
    let point = operating_point(&run, Place::Equilibrium).expect("an equilibrium");
    let linear = Linearization::at(simulator, point.clone()).expect("a linearization");
    let model = linear.state_space(&["command", "gust"], &["height", "current"]).expect("a model");
    // RK4 differs from the exponential by (0.0044)^5/120 a step here.
    let step = 1e-4;
    let model = model.sampled(step, Hold::Zoh).expect("samples");
    let (measured, noise) =
        ([("height", 5e-3), ("current", 2.0)], [("gust", 300.0), ("command", 1.0)]);
    let weights: Vec<Weight> = measured
        .iter()
        .chain(&noise)
        .map(|(name, deviation)| Weight { name: (*name).to_owned(), deviation: *deviation })
        .collect();
    let steady = model.kalman(&weights).expect("a filter");
    // Deviations of samples are intensities over the root of the step.
    let noise = noise.map(|(name, deviation)| (name, deviation * step.sqrt()));
    let start: Vec<(String, f64)> = (0..simulator.shape().states())
        .map(|entry| (simulator.state(entry).name.to_owned(), 0.1))
        .collect();
    let design = EstimatorDesign {
        measured: list(&measured),
        noise: list(&noise),
        start,
        ..EstimatorDesign::default()
    };
    let indices = design.indices(simulator).expect("names of the scene");
    let mut estimator = Estimator::at(simulator, &indices, 0.0, &point.state, &point.parameters);
    let _ = estimator.predict(step);
    for _ in 0..60_000 {
        estimator.correct(&estimator_outputs(&estimator));
        let _ = estimator.predict(step);
    }
    for (row, state) in steady.states.iter().enumerate() {
        let at = |name: &str| {
            (0..simulator.shape().states())
                .find(|entry| simulator.state(*entry).name == name)
                .expect("a state")
        };
        for (column, other) in steady.states.iter().enumerate() {
            let wanted = steady.covariance[row][column];
            let size = (steady.covariance[row][row] * steady.covariance[column][column]).sqrt();
            let error = (estimator.covariance(at(state), at(other)) - wanted).abs() / size;
            assert!(error < 1e-9, "{state}, {other}: {error:e}");
        }
    }
}

/// Returns height and current as the estimate predicts them.
fn estimator_outputs(estimator: &Estimator<'_>) -> Vec<f64> {
    estimator.outputs()[..2].to_vec()
}

fn consistency(
    name: &str,
    time: f64,
    design: &EstimatorDesign<'_>,
    run: &ConsistencyRun,
) -> Consistency {
    let simulator = of_specs(name, Keep::Needed);
    let simulator: &dyn Simulator<f64> = simulator.single();
    let place = operating_point(&Simulation::new(simulator), Place::Time(time)).expect("a point");
    let indices: EstimatorIndices<'_> = design.indices(simulator).expect("names of the scene");
    let start = (place.time, &place.state[..], &place.parameters[..]);
    let found = Consistency::of(simulator, &indices, start, run);
    for (nees, nis) in found.nees.iter().zip(&found.nis) {
        println!(
            "{name} at {:.4} s: NEES {:.3} of {} in [{:.3}, {:.3}]; NIS {:.3} of {} in [{:.3}, {:.3}]",
            nees.time,
            nees.mean,
            nees.freedom,
            nees.band[0],
            nees.band[1],
            nis.mean,
            nis.freedom,
            nis.band[0],
            nis.band[1]
        );
    }
    println!("{name}: other modes {}", found.other_modes);
    found
}

/// Checks that the mean over the instants is within the band of one, which is wider than its own,
/// and that few instants are beyond theirs.
fn assert_consistent(instants: &[Instant]) {
    let mean = instants.iter().map(|instant| instant.mean).sum::<f64>() / instants.len() as f64;
    let [low, high] = instants[0].band;
    assert!(low <= mean && mean <= high, "{mean} is not within [{low}, {high}]");
    let within = instants.iter().filter(|instant| instant.is_within()).count();
    // Five of ten are beyond with a probability of 6e-5.
    assert!(5 * within >= 3 * instants.len(), "{within} of {} are within", instants.len());
}

#[test]
fn the_errors_of_the_gin_s_estimator_are_those_it_claims() {
    let design = EstimatorDesign {
        measured: list(&[("motor_speed", 0.1), ("stator_current", 0.5)]),
        estimated: vec!["load.mean".to_owned()],
        noise: list(&[("load.mean", 5.0), ("motor.phase_voltage", 0.05)]),
        start: list(&[
            ("coupling.twist", 1e-3),
            ("motor.omega", 0.2),
            ("cylinder.omega", 0.2),
            ("load.mean", 10.0),
        ]),
        ..EstimatorDesign::default()
    };
    let run = ConsistencyRun { step: 1e-3, steps: 200, draws: 200, instants: 10, seed: 1 };
    let found = consistency("saw_gin", 1.5, &design, &run);
    assert_consistent(&found.nees);
    assert_consistent(&found.nis);
}

#[test]
fn the_errors_of_the_winch_s_estimator_are_those_it_claims() {
    let design = EstimatorDesign {
        measured: list(&[("speed", 0.5), ("current", 1.0)]),
        noise: list(&[("load.mass", 0.2), ("motor.current", 20.0), ("controller.integral", 5e-3)]),
        start: list(&[
            ("motor.phi", 1e-3),
            ("motor.omega", 0.05),
            ("load.v", 1e-3),
            ("load.x", 1e-4),
            ("motor.current", 0.1),
            ("controller.integral", 1e-3),
        ]),
        ..EstimatorDesign::default()
    };
    // The motor lifts; then the brake closes at 3 s and holds the drum by a constraint.
    for (time, steps) in [(2.5, 400), (2.9, 600)] {
        let run = ConsistencyRun { step: 5e-4, steps, draws: 200, instants: 10, seed: 2 };
        let found = consistency("drives/winch", time, &design, &run);
        assert_consistent(&found.nees);
        assert_consistent(&found.nis);
    }
}

#[test]
fn a_wrong_noise_is_found_inconsistent() {
    let design = EstimatorDesign {
        measured: list(&[("motor_speed", 0.1), ("stator_current", 0.5)]),
        noise: list(&[("load.mean", 5.0)]),
        start: list(&[("motor.omega", 0.2), ("cylinder.omega", 0.2)]),
        ..EstimatorDesign::default()
    };
    let simulator = of_specs("saw_gin", Keep::Needed);
    let simulator: &dyn Simulator<f64> = simulator.single();
    let indices = design.indices(simulator).expect("names of the scene");
    let place = operating_point(&Simulation::new(simulator), Place::Time(1.5)).expect("a point");
    let start = (place.time, &place.state[..], &place.parameters[..]);
    let run = ConsistencyRun { step: 1e-3, steps: 50, draws: 50, instants: 5, seed: 3 };
    let within = |instants: &[Instant]| instants.iter().filter(|it| it.is_within()).count();
    let right = Consistency::of(simulator, &indices, start, &run);
    assert!(within(&right.nees) >= 4 && within(&right.nis) >= 4);
    let mut rougher = indices.clone();
    rougher.disturbed[0].1 *= 10.0;
    let [mut worse, mut better] = [indices.clone(), indices.clone()];
    worse.measured.iter_mut().for_each(|(_, deviation)| *deviation *= 1.5);
    better.measured.iter_mut().for_each(|(_, deviation)| *deviation *= 0.6);
    let against = |noise| Consistency::against(simulator, [&indices, noise], start, &run);
    assert_eq!(within(&against(&rougher).nees[2..]), 0, "noise of the load");
    for noise in [&worse, &better] {
        assert_eq!(within(&against(noise).nis), 0, "noise of the measurements");
    }
}

#[test]
fn designs_are_refused_by_name() {
    let simulator = of_specs("saw_gin", Keep::Needed);
    let simulator: &dyn Simulator<f64> = simulator.single();
    let design = |measured: &[(&str, f64)], noise: &[(&str, f64)]| EstimatorDesign {
        measured: list(measured),
        noise: list(noise),
        ..EstimatorDesign::default()
    };
    let said =
        |design: EstimatorDesign<'_>| design.indices(simulator).expect_err("a refusal").to_string();
    let speed = ("motor_speed", 0.1);
    assert_eq!(
        said(design(&[("motor_sped", 0.1)], &[])),
        "the scene has no output `motor_sped` (did you mean `motor_speed`?)"
    );
    assert!(said(design(&[], &[])).starts_with("no output is measured"));
    assert!(said(design(&[speed, speed], &[])).contains("given twice"));
    assert!(said(design(&[("motor_speed", 0.0)], &[])).contains("above 0"));
    assert!(said(design(&[speed], &[("load.men", 1.0)])).contains("did you mean `load.mean`"));
    let stick = of_specs("stick_slip", Keep::Needed);
    let mode = EstimatorDesign {
        measured: vec![(stick.single().output(0).name.to_owned(), 1.0)],
        noise: list(&[("slider.slip", 1.0)]),
        ..EstimatorDesign::default()
    };
    let error = mode.indices(stick.single()).expect_err("a mode");
    assert_eq!(error, EstimatorError::Mode { name: "slider.slip".to_owned() });
}

#[test]
fn an_emitted_filter_is_that_of_its_design() {
    let mut emitted = emitted::saw_gin_ekf::Estimator::new();
    let design = EstimatorDesign {
        measured: list(&[("motor_speed", 0.1), ("stator_current", 0.5)]),
        estimated: vec!["load.mean".to_owned()],
        noise: list(&[("load.mean", 5.0), ("motor.phase_voltage", 0.05)]),
        start: list(&[("load.mean", 10.0), ("motor.omega", 0.1)]),
        ..EstimatorDesign::default()
    };
    let model = model_of_specs("saw_gin", Keep::Needed);
    let simulator = ModelSimulator::interpreted(model.clone());
    let indices = design.indices(simulator.single()).expect("names of the scene");
    let filter = EstimatorOptions {
        measured: indices.measured.clone(),
        estimated: indices.estimated.clone(),
        diffusing: indices.diffusing.clone(),
        disturbed: indices.disturbed.clone(),
        start: indices.start.clone(),
    };
    let mut own = Estimator::new(&emitted::saw_gin::SawGin, &indices);
    let start = own.state().to_vec();
    let options = EmitOptions {
        command: "machinist gen saw_gin -o . --estimator ekf --measure \
                  motor_speed=0.1,stator_current=0.5 --noise load.mean=5,motor.phase_voltage=0.05 \
                  --estimate load.mean --uncertain load.mean=10,motor.omega=0.1"
            .to_owned(),
        scene_features: false,
    };
    let text = emit_estimator(&model, &filter, StepMethod::RungeKutta4, &start, &options);
    let text = text.expect("emitted");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("estimators/emitted/saw_gin_ekf.rs");
    let known = std::fs::read_to_string(&path).unwrap_or_default();
    if std::env::var("MACHINIST_BOOK").is_ok_and(|what| what == "write") {
        std::fs::write(&path, &text).expect("written");
    } else {
        assert_eq!(known, text, "MACHINIST_BOOK=write updates {}", path.display());
    }
    // The module of the machine was derived by another algebra, with other constants.
    let [known, of_module] = [Simulator::<f64>::constants(&simulator), emitted::saw_gin::CONSTANTS];
    let bytes = size_of::<emitted::saw_gin_ekf::Estimator>() + 8 * known - 8 * of_module;
    assert!(text.contains(&format!("{bytes} bytes")), "the header tells {bytes} bytes");
    for step in 0..200 {
        let _ = (own.predict(1e-3), emitted.predict(1e-3));
        let noise = (0.37 * f64::from(step)).sin();
        let mut outputs = [0.0; 8];
        emitted.outputs(&mut outputs);
        let measured = [outputs[0] + 0.1 * noise, outputs[7] - 0.5 * noise];
        let [a, b] = [own.correct(&measured), emitted.correct(&measured)];
        assert_eq!(a.innovation.to_bits(), b.innovation.to_bits(), "step {step}");
    }
    let bits = |state: &[f64]| state.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(own.state()), bits(emitted.state()));
    assert_eq!(own.covariance(7, 7).to_bits(), emitted.covariance(7, 7).to_bits());
    assert_eq!(own.time().to_bits(), emitted.time().to_bits());
    let speed = 16;
    own.set(speed, 700.0);
    emitted.set(speed, 700.0);
    let _ = (own.predict(1e-3), emitted.predict(1e-3));
    assert_eq!(bits(own.state()), bits(emitted.state()));
    assert_eq!(bits(own.parameters()), bits(emitted.parameters()));
}
