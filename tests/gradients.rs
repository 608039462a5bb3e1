//! Gradients by the adjoint method, compared with sensitivities along the same steps and a closed
//! form.

use machinist::field::{Discretisation, FieldSimulator};
use machinist::improve::{Expression, gradient};
use machinist::simulate::Pull;
use machinist::{Method, SimulateError, Simulation, Trajectory};
use machinist_bench_scenes as bench;
use machinist_contract::{Describe, Simulator};
use machinist_scenes::scenes;

use crate::common::Oscillator;

/// Returns random pulls by every state and output at some of the times.
fn pulls(run: &Trajectory, columns: usize, seed: u64) -> Vec<Pull> {
    let mut random = fastrand::Rng::with_seed(seed);
    let columns = &run.columns[..columns];
    let pulls = columns.iter().map(|column| {
        let size = column.values.iter().fold(1e-9_f64, |most, value| most.max(value.abs()));
        let mut slope = |row: usize| match row % 3 {
            0 => 0.0,
            _ => (random.f64() - 0.5) / size,
        };
        let slopes = (0..run.times.len()).map(&mut slope).collect();
        Pull { column: column.name.clone(), slopes }
    });
    pulls.collect()
}

/// Returns the largest difference from sums over sensitivities, relative to their terms.
fn off_sensitivities(run: &Simulation<'_>, seed: u64) -> f64 {
    let simulator = run.simulator();
    let shape = simulator.shape();
    let columns = shape.states() + shape.outputs;
    let gradient = run.gradient(|run| pulls(run, columns, seed)).expect("it is smooth");
    let names: Vec<String> = gradient.slopes.iter().map(|slope| slope.name.clone()).collect();
    let forwards = run.clone().with_controlled_sensitivities(false);
    let forwards = forwards.sensitivities(&names).expect("known").run().expect("it runs");
    assert_eq!(forwards.work.steps, gradient.run.work.steps, "the same steps");
    let pulls = pulls(&gradient.run, columns, seed);
    let mut worst = 0.0_f64;
    for slope in &gradient.slopes {
        let (mut sum, mut size) = (0.0, 0.0);
        for (index, pull) in pulls.iter().enumerate() {
            let name = format!("d({})/d({})", pull.column, slope.name);
            let own: Vec<_> = forwards.columns.iter().filter(|c| c.name == name).collect();
            // An output may have the name of a state, and is found after it.
            let own = own[usize::from(own.len() > 1 && index >= shape.states())];
            for (pull, value) in pull.slopes.iter().zip(&own.values) {
                sum += pull * value;
                size += (pull * value).abs();
            }
        }
        if size > 0.0 {
            worst = worst.max((sum - slope.value).abs() / size);
        } else {
            assert!(slope.value.abs() < 1e-300, "{} is pulled by nothing", slope.name);
        }
    }
    worst
}

#[test]
fn they_are_sums_over_sensitivities_along_the_same_steps() {
    // A load at a time that is a parameter, a linear machine, a mass matrix that depends on the
    // state.
    let cases = [
        (scenes::find_f64("saw_gin"), 1.4),
        (scenes::find_f64("two_mass"), 0.3),
        (scenes::find_f64("pendulum_chain"), 0.5),
        (bench::find_f64("m6_5"), 0.3),
    ];
    for (scene, until) in cases {
        let scene = scene.expect("built in");
        for (method, rtol) in [(Method::Tsit5, 1e-4), (Method::Dop853, 1e-7)] {
            let run = Simulation::new(scene).method(method).rtol(rtol).until(until).points(23);
            let off = off_sensitivities(&run, 5);
            assert!(off < 1e-11, "{} by {method}: {off:e}", scene.name());
        }
    }
}

#[test]
fn of_fields_too() {
    let wanted = Discretisation { elements: Some(3), order: Some(2) };
    for name in ["shaft_with_rotors", "saw_gin_shaft"] {
        let scene = scenes::find_field_f64(name).expect("built in");
        let scene = FieldSimulator::new(scene, wanted).expect("elements");
        let scene = scene.with_derivatives(scenes::find_field_duals(name).expect("built in"));
        let run = Simulation::new(&scene).method(Method::Dop853).rtol(1e-6).until(2e-3).points(7);
        let off = off_sensitivities(&run, 6);
        assert!(off < 1e-11, "{name}: {off:e}");
    }
}

/// The final angle of an oscillator as a function of its initial one: a decaying cosine and sine.
#[test]
fn the_end_of_an_oscillator_moves_as_its_closed_form_says() {
    let run = Simulation::new(&Oscillator).method(Method::Dop853).rtol(1e-12).until(0.6).points(2);
    let end = |run: &Trajectory| {
        assert_eq!(run.times.len(), 2);
        vec![Pull { column: "rotor.angle".to_owned(), slopes: vec![0.0, 1.0] }]
    };
    let gradient = run.gradient(end).expect("it is smooth");
    let parameter = |name: &str| {
        let place = (0..Oscillator.shape().parameters)
            .find(|index| Oscillator.parameter(*index).name == name)
            .expect("it has it");
        Oscillator.parameter_default(place)
    };
    let (stiffness, damping) = (parameter("rotor.stiffness"), parameter("rotor.damping"));
    let inertia = parameter("rotor.inertia");
    let decay = 0.5 * damping / inertia;
    let w = (stiffness / inertia - decay * decay).sqrt();
    let t = 0.6_f64;
    let wanted = (-decay * t).exp() * ((w * t).cos() + decay / w * (w * t).sin());
    let slope = gradient.slopes.iter().find(|s| s.name == "rotor.angle" && !s.is_parameter);
    let found = slope.expect("a state").value;
    assert!((found - wanted).abs() < 1e-11, "{found} for {wanted}");
}

/// An extreme, a mean, a final value, and a parameter itself: by the adjoint method, and by
/// sensitivities of an implicit method.
#[test]
fn expressions_have_the_derivatives_that_sensitivities_give() {
    let text =
        "max(abs(twist))*coupling.stiffness + 0.3*rms(motor_torque) - final(twist)*motor.k_s";
    let expression = Expression::parse(text).expect("it is one");
    let gin = Simulation::new(scenes::find_f64("saw_gin").expect("built in"));
    let gin = gin.until(0.3).points(601).rtol(1e-10);
    let reverse = gradient(&gin.clone().method(Method::Dop853), &expression).expect("it runs");
    let forwards = gradient(&gin.method(Method::Radau), &expression).expect("it runs");
    assert!(reverse.is_in_reverse && !forwards.is_in_reverse);
    assert!((reverse.value / forwards.value - 1.0).abs() < 1e-8);
    for own in &forwards.gradient.slopes {
        let other = reverse.gradient.slopes.iter().find(|s| s.is_parameter && s.name == own.name);
        let size = reverse.value.abs() / own.at.abs().max(1e-3);
        let off = (other.expect("all are there").value - own.value).abs();
        assert!(off < 1e-6 * size, "{}: {off:e} of {size:e}", own.name);
    }
}

#[test]
fn what_cannot_be_gone_back_over_is_refused_by_name() {
    let refused = |scene: &dyn Simulator<f64>| {
        let run = Simulation::new(scene).gradient(|_| Vec::new());
        run.map(|_| ()).expect_err("it is not smooth").to_string()
    };
    let scene = |name| scenes::find_f64(name).expect("built in");
    assert!(refused(scene("bouncing_mass")).contains("it has events"));
    assert!(refused(scene("four_bar")).contains("it has constraints"));
    let gin = Simulation::new(scene("saw_gin"));
    let by_radau = gin.clone().method(Method::Radau).gradient(|_| Vec::new());
    assert!(matches!(by_radau, Err(SimulateError::NoSensitivities { method: "radau", .. })));
    let pull = |column: &str, count| vec![Pull { column: column.into(), slopes: vec![1.0; count] }];
    for pulls in [pull("no_such", 201), pull("twist", 3), pull("energy.total", 201)] {
        let refused = gin.clone().points(201).until(0.1).gradient(|_| pulls);
        assert!(matches!(refused, Err(SimulateError::NotReversible { .. })));
    }
}
