//! Sensitivities along a run: against closed forms, and against differences of runs.

use machinist::field::{Discretisation, FieldSimulator};
use machinist::{Method, SimulateError, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_scenes::scenes;

use crate::common::{Oscillator, oscillator_state};
use machinist_model::ModelSimulator;

use crate::own_scene::{model_of_specs, of_specs, of_text};

const EXPLICIT: [Method; 2] = [Method::Tsit5, Method::Dop853];

/// Sixth-order central differences of every state and output at the end of a run, by
/// parameters and initial values of the spec; `step` is a share of what is varied.
fn differences(
    adjusted: &dyn Fn(Simulation<'_>) -> Simulation<'_>,
    scene: &dyn Simulator<f64>,
    by: &str,
    step: f64,
) -> Vec<Vec<f64>> {
    let place = (0..scene.shape().parameters).find(|index| scene.parameter(*index).name == by);
    let place = place.unwrap_or_else(|| panic!("{by}"));
    let value = adjusted(Simulation::new(scene)).parameter_values()[place];
    let step = step * if value == 0.0 { 1.0 } else { value.abs() };
    let at = |times: f64| {
        let run = adjusted(Simulation::new(scene)).parameter(by, value + times * step);
        let run = run.expect("known").run().expect("it runs");
        run.columns.into_iter().map(|column| column.values).collect::<Vec<_>>()
    };
    let weights = [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)];
    let runs = weights.map(|(times, weight)| (at(times), at(-times), weight / (60.0 * step)));
    let column = |index: usize| {
        let row = |row: usize| {
            runs.iter().map(|(a, b, weight)| weight * (a[index][row] - b[index][row])).sum()
        };
        (0..runs[0].0[index].len()).map(row).collect()
    };
    (0..runs[0].0.len()).map(column).collect()
}

/// Returns the largest error of all sensitivities by `by` over all times, over the largest size of
/// each.
fn off_differences(
    scene: &dyn Simulator<f64>,
    adjusted: &dyn Fn(Simulation<'_>) -> Simulation<'_>,
    by: &str,
    step: f64,
) -> f64 {
    let run = adjusted(Simulation::new(scene)).sensitivities(&[by]).expect("known");
    let run = run.run().unwrap_or_else(|error| panic!("by {by}: {error}"));
    let found = differences(adjusted, scene, by, step);
    let shape = scene.shape();
    let values = adjusted(Simulation::new(scene)).parameter_values().to_vec();
    let place = (0..shape.parameters).find(|index| scene.parameter(*index).name == by);
    let value = place.map_or(1.0, |index| values[index].abs().max(1e-3));
    let mut worst = 0.0_f64;
    for (index, differences) in found.iter().enumerate().take(shape.states() + shape.outputs) {
        let column = &run.columns[index];
        let own = run.columns.iter().filter(|c| c.name == format!("d({})/d({by})", column.name));
        let own: Vec<_> = own.collect();
        // An output may have the name of a state.
        let own = &own[usize::from(own.len() > 1 && index >= shape.states())].values;
        let size = own.iter().chain(differences).fold(0.0_f64, |most, value| most.max(value.abs()));
        let off = own.iter().zip(differences).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let scale = column.values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        // A column that is zero except for rounding, such as a constrained coordinate, determines
        // nothing, and neither does an effect too small for differences.
        if scale > 1e-9 && size * value > 1e-6 * scale {
            worst = worst.max(off / size);
            if off / size > 1e-6 {
                eprintln!("{} by {by}: {off:e} of {size:e}", column.name);
            }
        }
    }
    worst
}

fn built_in(name: &str) -> &'static dyn Simulator<f64> {
    scenes::find_f64(name).unwrap_or_else(|| panic!("{name}"))
}

#[test]
fn an_oscillator_with_a_step_has_the_derivatives_of_its_closed_form() {
    // By its initial angle the motion is linear; by the start of the torque it is the rate
    // of what the torque adds.
    let times: Vec<f64> = (0..=30).map(|k| 0.1 * f64::from(k)).collect();
    for method in EXPLICIT {
        let run = Simulation::new(&Oscillator).method(method).rtol(1e-12).times(&times);
        let by = ["rotor.angle", "torque_start", "torque", "rotor.stiffness"];
        let run = run.sensitivities(&by).expect("known").run().expect("it runs");
        let (decay, spring) = (0.2_f64, 25.0_f64);
        let w = (spring - decay * decay).sqrt();
        for (row, time) in times.iter().enumerate() {
            let free = |t: f64| (-decay * t).exp() * ((w * t).cos() + decay / w * (w * t).sin());
            let speed = |t: f64| -(-decay * t).exp() * spring / w * (w * t).sin();
            let since = (time - 0.7_f64).max(0.0);
            let close = |of: &str, by: &str, wanted: f64, scale: f64| {
                let found = run.sensitivity(of, by).expect("a column")[row];
                let off = (found - wanted).abs() / scale;
                assert!(off < 1e-9, "{method}: {of} by {by} at {time}: {found}, {wanted}");
            };
            close("rotor.angle", "rotor.angle", free(*time), 1.0);
            close("rotor.omega", "rotor.angle", speed(*time), 5.0);
            close("rotor.angle", "torque", (1.0 - free(since)) / 50.0, 0.02);
            // angle = 0.6 (1 - free(t - t0)) + ...
            close("rotor.angle", "torque_start", 0.6 * speed(since), 3.0);
            let stiffness = run.sensitivity("rotor.angle", "rotor.stiffness").expect("a column");
            let torque = run.sensitivity("spring_torque", "rotor.stiffness").expect("a column");
            let wanted = 50.0 * stiffness[row] + oscillator_state(*time)[0];
            assert!((torque[row] - wanted).abs() < 1e-9, "the output is c q");
        }
        let off = off_differences(
            &Oscillator,
            &|run| run.method(method).rtol(1e-12).times(&times),
            "rotor.stiffness",
            1e-2,
        );
        assert!(off < 1e-8, "{method}: {off}");
    }
}

#[test]
fn units_divide_and_names_are_told() {
    let run = Simulation::new(&Oscillator).method(Method::Dop853);
    let run = run.sensitivities(&["rotor.stiffness"]).expect("known").run().expect("it runs");
    let column = run.find("d(spring_torque)/d(rotor.stiffness)").expect("a column");
    assert_eq!(column.unit, "N m/(N m/rad)");
    let error = Simulation::new(&Oscillator).sensitivities(&["rotor.stifness"]).err();
    let error = error.expect("refused").to_string();
    assert!(error.contains("did you mean `rotor.stiffness`"), "{error}");
}

/// A ball of restitution e that falls from h: it lands at t_0 = sqrt(2 h/g), and for the n-th
/// time at t_0 (1 + 2 e + ... + 2 e^(n-1)), with speed e^n sqrt(2 g h) upwards from there.
pub fn bouncing_ball() -> ModelSimulator {
    of_text(
        r#"
        [scene]
        name = "balls"
        [units.ball]
        unit = "ball"
        [parameters.height]
        value = 1.0
        unit = "m"
        doc = "height at the start"
        [initial]
        "ball.x" = "height"
        [run]
        until = 2.0
        points = 201
        rtol = 1e-12
        method = "dop853"
        [outputs]
        x = "ball.x"
        v = "ball.v"
        [define.ball.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.ball.parameters]
        gravity = { value = 9.81, unit = "m/s^2" }
        restitution = { value = 0.8, unit = "1" }
        [define.ball.energy]
        kinetic = "1 [kg]*v^2/2"
        potential = "1 [kg]*gravity*x"
        [define.ball.events.bounce]
        guard = "x"
        direction = "falling"
        set = { v = "-restitution*v" }
        "#,
        Keep::Needed,
    )
}

#[test]
fn bounces_have_the_derivatives_of_their_closed_form() {
    let ball = bouncing_ball();
    let (g, e, h) = (9.81_f64, 0.8_f64, 1.0_f64);
    // Position after the n-th bounce as a function of g, e, h.
    let position = |t: f64, g: f64, e: f64, h: f64, n: i32| {
        let fall = (2.0 * h / g).sqrt();
        let landed: f64 = fall * (1.0 + 2.0 * (1..n).map(|k| e.powi(k)).sum::<f64>());
        let u = t - landed;
        e.powi(n) * (2.0 * g * h).sqrt() * u - g * u * u / 2.0
    };
    for method in EXPLICIT {
        let by = ["ball.restitution", "ball.gravity", "height"];
        let run = Simulation::new(&ball).method(method).sensitivities(&by).expect("known");
        let run = run.run().expect("it runs");
        let landings: Vec<f64> = run.switches.iter().map(|switch| switch.time).collect();
        assert_eq!(landings.len(), 3);
        for (row, t) in run.times.iter().enumerate() {
            let n = landings.iter().filter(|landing| *landing < t).count();
            if n == 0 || landings.iter().any(|landing| (landing - t).abs() < 1e-3) {
                continue;
            }
            let n = n as i32;
            let by = [
                ("ball.restitution", 1e-3, [g, e, h], 1),
                ("ball.gravity", 1e-2, [g, e, h], 0),
                ("height", 1e-3, [g, e, h], 2),
            ];
            for (name, step, at, index) in by {
                let near = |k: f64| {
                    let mut p = at;
                    p[index] += k * step;
                    position(*t, p[0], p[1], p[2], n)
                };
                let wanted = (45.0 * (near(1.0) - near(-1.0)) - 9.0 * (near(2.0) - near(-2.0))
                    + near(3.0)
                    - near(-3.0))
                    / (60.0 * step);
                let found = run.sensitivity("x", name).expect("a column")[row];
                assert!(
                    (found - wanted).abs() < 1e-9 * (1.0 + wanted.abs()),
                    "{method} by {name} at {t}: {found} for {wanted}"
                );
            }
        }
    }
}

/// A slider on a rough floor stops after v0^2/(2 mu g), and stays at rest.
#[test]
fn a_slider_stops_where_its_closed_form_does() {
    let run = Simulation::new(built_in("coulomb_oscillator")).rtol(1e-12).method(Method::Dop853);
    // The mass is let go at A, slides half cycles about +-d, d = mu_c N/k, and turns at
    // A - 2 d, A - 4 d, ... : where it stays is A - 2 m d (in magnitude and sign).
    let by = ["deflection"];
    let run = run.sensitivities(&by).expect("known").run().expect("it runs");
    let last = *run.sensitivity("slider.x", "deflection").expect("a column").last().expect("rows");
    assert!((last.abs() - 1.0).abs() < 1e-9, "{last}");
    let velocity = run.sensitivity("slider.v", "deflection").expect("a column");
    assert!(velocity.last().expect("rows").abs() < 1e-12);
}

#[test]
fn what_cannot_be_done_is_refused_by_name() {
    let of = |scene: &'static str, by: &str, method: Option<Method>| {
        let run = Simulation::new(built_in(scene)).until(0.1).points(2);
        let run = method.into_iter().fold(run, Simulation::method);
        run.sensitivities(&[by]).and_then(|run| run.run()).expect_err("refused").to_string()
    };
    let error = of("stick_slip", "slider.slip", None);
    assert!(error.contains("whole numbers"), "{error}");
    let error = of("saw_gin", "coupling.stiffness", Some(Method::Bdf));
    assert!(error.contains("`bdf` does not carry") && error.contains("dop853"), "{error}");
    // A jump at the very start is one-sided.
    let run = Simulation::new(&Oscillator).from(0.7).sensitivities(&["torque_start"]);
    let error = run.expect("known").run().expect_err("refused");
    assert!(matches!(error, SimulateError::NotDifferentiable { .. }), "{error}");
}

#[test]
fn scenes_with_events_agree_with_differences() {
    type Case<'c> = (&'c str, f64, &'c [&'c str], f64);
    let cases: [Case<'_>; 3] = [
        ("bouncing_mass", 0.5, &["amplitude", "frequency", "height", "speed"], 1e-5),
        ("stick_slip", 2.0, &["belt_speed", "slider.static_friction"], 1e-5),
        ("contact_oscillator", 0.5, &["deflection", "stop.stiffness"], 1e-5),
    ];
    for (name, until, by, step) in cases {
        let scene = built_in(name);
        for by in by {
            let off = off_differences(
                scene,
                &|run| run.rtol(1e-12).method(Method::Dop853).until(until).points(97),
                by,
                step,
            );
            assert!(off < 1e-6, "{name} by {by}: {off:e}");
        }
    }
}

/// Contacts, a package that grows, friction; and a winch with brake, rope, controller.
#[test]
fn machines_of_many_events_agree_with_differences() {
    let winder = built_in("winder_full");
    for by in ["layer.stiffness", "force_amplitude", "holder.preload"] {
        let off = off_differences(
            winder,
            &|run| run.rtol(1e-12).method(Method::Dop853).until(0.1).points(41),
            by,
            1e-4,
        );
        assert!(off < 1e-6, "winder_full by {by}: {off:e}");
    }
    let winch = of_specs("drives/winch", Keep::Needed);
    for by in ["load.mass", "gear.efficiency"] {
        let off = off_differences(
            &winch,
            &|run| run.rtol(1e-12).method(Method::Dop853).until(2.0).points(21),
            by,
            1e-4,
        );
        assert!(off < 1e-6, "winch by {by}: {off:e}");
    }
}

/// A coupling so stiff and so damped that stability holds explicit steps.
#[test]
fn stiff_machines_are_carried_by_radau() {
    let scene = built_in("two_mass");
    for method in [Method::Radau, Method::Auto] {
        for by in ["driver.inertia", "drive_torque"] {
            let off = off_differences(
                scene,
                &|run| {
                    let run = run.parameter("coupling.stiffness", 2e7).expect("known");
                    let run = run.parameter("coupling.damping", 1e5).expect("known");
                    run.rtol(1e-10).method(method).until(0.2).points(11)
                },
                by,
                1e-3,
            );
            assert!(off < 1e-6, "{method} by {by}: {off:e}");
        }
    }
}

/// Emitted code and models, by parameters of the field, of the attached machine and of the places
/// of ports. The gin's shaft is made soft: twists of a stiff one are rounding in differences, and
/// so are runs at 1e-12 or over smaller steps of a parameter.
#[test]
fn scenes_with_fields_agree_with_differences() {
    type Case<'c> = (&'c str, f64, &'c [&'c str], Method, f64);
    let cases: [Case<'_>; 3] = [
        ("saw_gin_shaft", 0.05, &["saws.inertia", "motor.inertia"], Method::Radau, 1e-7),
        ("shaft_with_rotors", 0.005, &["shaft.length", "driven.inertia"], Method::Dop853, 1e-7),
        ("loom_drive", 0.1, &["shaft.reed_position", "crank.stiffness"], Method::Radau, 1e-5),
    ];
    let wanted = Discretisation { elements: Some(4), order: Some(2) };
    // Where a reed is hardly moves a motor, and differences are rounding there.
    for (name, until, by, method, allowed) in cases {
        let emitted = scenes::find_field_f64(name).expect("built in");
        let emitted = FieldSimulator::new(emitted, wanted).expect("elements");
        let emitted = emitted.with_derivatives(scenes::find_field_duals(name).expect("built in"));
        let model = ModelSimulator::new(model_of_specs(name, Keep::Needed));
        let own = FieldSimulator::new(model.with_fields(), wanted).expect("elements");
        let own = own.with_derivatives(model.with_fields_on_duals());
        for scene in [&emitted, &own] {
            for by in by {
                let off = off_differences(
                    scene,
                    &|run| softened(run.rtol(1e-11).method(method).until(until).points(11)),
                    by,
                    3e-3,
                );
                assert!(off < allowed, "{name} by {by}, {method}: {off:e}");
            }
        }
    }
}

/// Returns the run with a softer cylinder, where there is one.
fn softened(run: Simulation<'_>) -> Simulation<'_> {
    run.clone().parameter("saws.shear_modulus", 8e6).unwrap_or(run)
}

#[test]
fn smooth_scenes_agree_with_differences() {
    type Case<'c> = (&'c str, f64, &'c [&'c str]);
    let cases: [Case<'_>; 3] = [
        ("saw_gin", 0.4, &["coupling.stiffness", "motor.inertia", "coupling.damping"]),
        ("four_bar", 0.3, &["crank.length", "angle", "coupler.mass"]),
        ("slider_crank", 0.3, &["rod.length", "speed"]),
    ];
    for (name, until, by) in cases {
        let scene = built_in(name);
        for by in by {
            let off = off_differences(
                scene,
                &|run| run.rtol(1e-12).method(Method::Dop853).until(until).points(21),
                by,
                1e-3,
            );
            assert!(off < 1e-8, "{name} by {by}: {off:e}");
        }
    }
}
