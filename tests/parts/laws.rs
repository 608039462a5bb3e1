//! Closed forms of parts.

use std::f64::consts::{PI, TAU};

use machinist_codegen::mechanics::reduce::Keep;

use super::{by_small_steps, column, contact, example, off, run};

/// Returns ratios, stiffnesses and the like over orders of magnitude, the same in every run.
fn sweep(low: f64, high: f64, count: i32) -> impl Iterator<Item = f64> {
    (0..count).map(move |k| low * (high / low).powf(f64::from(k) / f64::from(count - 1)))
}

/// Two bodies on a spring, the second thrown: relative motion.
#[test]
fn springs_between_two_bodies_swing_at_their_frequency() {
    for (name, unit, inertia, end) in [
        ("rotational/spring", "rad", "inertia", "twist"),
        ("translational/spring", "m", "mass", "stretch"),
    ] {
        let scene = example(name, Keep::Needed);
        for stiffness in sweep(1e-1, 1e6, 8) {
            for body in sweep(1e-2, 1e3, 4) {
                let body_name = format!("right.{inertia}");
                let run = run(&scene, &[("spring.stiffness", stiffness), (&body_name, body)], &[]);
                let frequency = (stiffness * (1.0 / 2.0 + 1.0 / body)).sqrt();
                let speed = if unit == "rad" { 3.0 } else { 1.0 };
                let error = off(&run, end, |t| speed / frequency * (frequency * t).sin());
                assert!(error < 1e-8, "{name} k = {stiffness}, {body}: {error:e}");
            }
        }
    }
}

#[test]
fn dampers_bring_two_bodies_to_the_speed_of_both() {
    for (name, inertia) in [("rotational/damper", "inertia"), ("translational/damper", "mass")] {
        let scene = example(name, Keep::Needed);
        for damping in sweep(1e-2, 1e3, 6) {
            for body in sweep(1e-1, 1e2, 4) {
                let body_name = format!("left.{inertia}");
                let run = run(&scene, &[("damper.damping", damping), (&body_name, body)], &[]);
                let decay = damping * (1.0 + 1.0 / body);
                let mean = 3.0 / (1.0 + body);
                let left = |t: f64| mean * (1.0 - (-decay * t).exp());
                let right = |t: f64| mean + (3.0 - mean) * (-decay * t).exp();
                let error = off(&run, "left", left).max(off(&run, "right", right));
                assert!(error < 1e-8, "{name} d = {damping}, {body}: {error:e}");
            }
        }
    }
}

#[test]
fn a_spring_with_a_damper_decays_as_it_should() {
    let scene = example("translational/spring_damper", Keep::Needed);
    for damping in sweep(1e-2, 20.0, 6) {
        for stiffness in sweep(150.0, 1e5, 4) {
            let run =
                run(&scene, &[("mount.damping", damping), ("mount.stiffness", stiffness)], &[]);
            let decay = damping / 2.0;
            let frequency = (stiffness - decay * decay).sqrt();
            let exact = |t: f64| (-decay * t).exp() * (frequency * t).sin() / frequency;
            let error = off(&run, "place", exact);
            assert!(error < 1e-8, "d = {damping}, k = {stiffness}: {error:e}");
        }
    }
}

/// Returns the quarter period of x'' = -k x - c x^3 from rest at x0, by the arithmetic-geometric
/// mean.
fn quarter_period(k: f64, c: f64, x0: f64) -> f64 {
    // T/4 = K(m)/sqrt(k + c x0^2) with m = c x0^2/(2 (k + c x0^2)), K = pi/(2 agm(1, sqrt(1 - m))).
    let square = k + c * x0 * x0;
    let m = c * x0 * x0 / (2.0 * square);
    let (mut a, mut b) = (1.0, (1.0 - m).sqrt());
    for _ in 0..40 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    PI / (2.0 * a) / square.sqrt()
}

#[test]
fn a_spring_that_stiffens_has_the_period_of_duffing() {
    for (name, start) in
        [("rotational/nonlinear_spring", "rotor.phi"), ("translational/nonlinear_spring", "body.x")]
    {
        let scene = example(name, Keep::All);
        let output = if name.starts_with('r') { "angle" } else { "place" };
        for cubic in [-100.0, -10.0, 0.0, 1.0, 100.0, 1e4] {
            let x0 = 0.3;
            let quarter = quarter_period(50.0, cubic, x0);
            let simulation = machinist::Simulation::new(&scene)
                .rtol(1e-11)
                .parameter("spring.cubic_stiffness", cubic)
                .expect("a parameter")
                .times(&[0.0, quarter, 2.0 * quarter, 3.0 * quarter, 4.0 * quarter]);
            let run = simulation.run().expect("it runs");
            assert!(scene_has(&run, start));
            for (place, expected) in column(&run, output).iter().zip([x0, 0.0, -x0, 0.0, x0]) {
                assert!((place - expected).abs() < 1e-8, "{name} {cubic}: {place} at {expected}");
            }
        }
    }
}

fn scene_has(run: &machinist::Trajectory, name: &str) -> bool {
    run.column(name).is_some()
}

#[test]
fn a_gear_accelerates_by_its_ratio() {
    let scene = example("rotational/gear", Keep::Needed);
    for size in sweep(1e-3, 1e3, 7) {
        for ratio in [size, -size] {
            for load in sweep(1e-2, 1e4, 4) {
                let run = run(&scene, &[("gear.ratio", ratio), ("load.inertia", load)], &[]);
                let alpha = 3.0 * ratio / (0.1 * ratio * ratio + load);
                let error = off(&run, "load", |t| alpha * t);
                let motor = off(&run, "motor", |t| ratio * alpha * t);
                assert!(error.max(motor) < 1e-9, "ratio {ratio}: {error:e}, {motor:e}");
            }
        }
    }
}

#[test]
fn a_planetary_gear_turns_by_willis() {
    let scene = example("rotational/planetary", Keep::Needed);
    for ratio in sweep(1e-1, 1e2, 7) {
        for load in sweep(1e-2, 1e3, 4) {
            let run = run(&scene, &[("gear.ratio", ratio), ("load.inertia", load)], &[]);
            // With the ring held, sun over carrier is 1 + ratio.
            let turns = 1.0 + ratio;
            let alpha = 3.0 * turns / (0.1 * turns * turns + load);
            let carrier = off(&run, "carrier", |t| alpha * t);
            let sun = off(&run, "sun", |t| turns * alpha * t);
            // The ring takes what sun and carrier leave: its torque is ratio times the sun's.
            let torque = off(&run, "torque", |_| ratio * (0.1 * turns * alpha - 3.0));
            assert!(carrier.max(sun).max(torque) < 1e-8, "{ratio}: {carrier:e} {sun:e} {torque:e}");
        }
    }
}

#[test]
fn a_differential_gives_both_sides_one_torque() {
    let scene = example("rotational/differential", Keep::Needed);
    for left in sweep(1e-3, 1e3, 7) {
        let run = run(&scene, &[("left.inertia", left)], &[]);
        // T = J a + 2 M, M = J_l a_l = J_r a_r, a = (a_l + a_r)/2.
        let torque = 6.0 / (2.0 + 0.1 * (1.0 / left + 1.0 / 3.0) / 2.0);
        let error = off(&run, "left", |t| torque / left * t)
            .max(off(&run, "right", |t| torque / 3.0 * t))
            .max(off(&run, "torque", |_| torque));
        assert!(error < 1e-8, "{left}: {error:e}");
    }
}

#[test]
fn a_belt_swings_about_its_ratio() {
    let scene = example("rotational/belt", Keep::Needed);
    for radius in sweep(0.01, 1.0, 5) {
        for stiffness in sweep(1e4, 1e6, 3) {
            let set = [("belt.radius_b", radius), ("belt.stiffness", stiffness)];
            let run = run(&scene, &set, &[]);
            // The stretch s: s'' = r_a T/J_a - w (k s + d s'), w = r_a^2/J_a + r_b^2/J_b.
            let weight = 0.05f64.powi(2) / 0.01 + radius * radius / 0.5;
            let (decay, square) = (weight * 50.0 / 2.0, weight * stiffness);
            let frequency = (square - decay * decay).sqrt();
            let rest = 0.05 * 2.0 / 0.01 / square;
            let part = |t: f64| {
                let (sin, cos) = (frequency * t).sin_cos();
                let swing = (-decay * t).exp() * (cos + decay / frequency * sin);
                let rate = (-decay * t).exp() * square / frequency * sin;
                rest * (stiffness * (1.0 - swing) + 50.0 * rate)
            };
            let error = off(&run, "tension", part);
            assert!(error < 1e-7, "{radius}, {stiffness}: {error:e}");
        }
    }
}

#[test]
fn racks_screws_wheels_and_levers_move_by_their_lengths() {
    let scene = example("rotational/rack", Keep::Needed);
    for radius in sweep(1e-3, 10.0, 7) {
        let run = run(&scene, &[("rack.radius", radius)], &[]);
        let frequency = (400.0 / (4.0 + 0.01 / (radius * radius))).sqrt();
        let error = off(&run, "travel", |t| 0.5 / frequency * (frequency * t).sin()).max(off(
            &run,
            "angle",
            |t| 0.5 / frequency / radius * (frequency * t).sin(),
        ));
        assert!(error < 1e-8, "rack of {radius}: {error:e}");
    }
    let scene = example("rotational/screw", Keep::Needed);
    for lead in sweep(1e-4, 1.0, 7) {
        let run = run(&scene, &[("screw.lead", lead)], &[]);
        let alpha = 0.5 / (1e-3 + 100.0 * (lead / TAU).powi(2));
        let error = off(&run, "speed", |t| alpha / 10.0 * (1.0 - (10.0 * t).cos()));
        let travel = |t: f64| lead / TAU * alpha / 10.0 * (t - (10.0 * t).sin() / 10.0);
        let error = error.max(off(&run, "travel", travel));
        assert!(error < 1e-8, "screw of {lead}: {error:e}");
    }
    let scene = example("rotational/wheel", Keep::Needed);
    for radius in sweep(1e-2, 10.0, 7) {
        let run = run(&scene, &[("wheel.radius", radius)], &[]);
        let pull = 20.0 / radius / (60.0 + 0.5 / (radius * radius));
        let error = off(&run, "speed", |t| pull * t);
        assert!(error < 1e-9, "wheel of {radius}: {error:e}");
    }
    let scene = example("translational/gear", Keep::Needed);
    for ratio in sweep(1e-2, 1e2, 7) {
        let run = run(&scene, &[("tackle.ratio", ratio)], &[]);
        let pull = 10.0 * ratio / (0.5 * ratio * ratio + 20.0);
        let error = off(&run, "load", |t| pull * t).max(off(&run, "hand", |t| ratio * pull * t));
        assert!(error < 1e-9, "tackle of {ratio}: {error:e}");
    }
    let scene = example("translational/lever", Keep::Needed);
    for arm in sweep(1e-3, 10.0, 7) {
        let run = run(&scene, &[("lever.arm_b", arm)], &[]);
        let ratio = arm / 0.1;
        let pull = 3.0 / (9.0 + ratio * ratio);
        let error = off(&run, "left", |t| pull * t).max(off(&run, "right", |t| -ratio * pull * t));
        assert!(error < 1e-9, "lever of {arm}: {error:e}");
    }
}

#[test]
fn a_gearbox_without_play_swings_about_its_ratio() {
    let scene = example("rotational/gearbox", Keep::Needed);
    for ratio in sweep(0.1, 50.0, 5) {
        for stiffness in sweep(1e3, 1e5, 3) {
            let set = [
                ("gear.ratio", ratio),
                ("gear.stiffness", stiffness),
                ("gear.backlash", 0.0),
                ("gear.damping", 0.0),
            ];
            let run = run(&scene, &set, &[]);
            let drive = 3.0 / (ratio * 0.02);
            let square = stiffness * (1.0 / (ratio * ratio * 0.02) + 0.5);
            let twist = |t: f64| drive / square * (1.0 - (square.sqrt() * t).cos());
            let error = off(&run, "twist", twist);
            // Up to 1800 swings, each of which grazes the bend of the contact.
            assert!(error < 3e-5, "{ratio}, {stiffness}: {error:e}");
        }
    }
}

#[test]
fn smooth_friction_and_eddy_currents_slow_down_by_their_laws() {
    let scenes =
        [("rotational/smooth_friction", "bearing"), ("translational/smooth_friction", "guide")];
    for (name, part) in scenes {
        let scene = example(name, Keep::Needed);
        for fading in sweep(0.02, 5.0, 6) {
            let fading_speed = format!("{part}.fading_speed");
            let run = run(&scene, &[(&fading_speed, fading)], &[]);
            // w' = -tanh(w/s): sinh(w/s) decays as exp(-t/s).
            let decay = |t: f64| (-t / fading).exp() * (3.0 / fading).sinh();
            let error = off(&run, "speed", |t| fading * decay(t).asinh());
            assert!(error < 1e-8, "{name} {fading}: {error:e}");
        }
    }
    let scene = example("sources/eddy_brake", Keep::Needed);
    for nominal in sweep(1.0, 1e3, 5) {
        let run = run(&scene, &[("brake.nominal_speed", nominal)], &[]);
        // J w' = -2 M u/(1 + u^2) with u = w/n: ln u + u^2/2 falls by 2 M t/(J n).
        let measure = |u: f64| u.ln() + u * u / 2.0;
        let start = measure(200.0 / nominal);
        for (time, speed) in run.times.iter().zip(column(&run, "speed")) {
            let fallen = start - measure(speed / nominal);
            let exact = 2.0 * 10.0 * time / (2.0 * nominal);
            assert!((fallen - exact).abs() < 1e-7 * (1.0 + start.abs()), "{nominal} at {time}");
        }
    }
}

#[test]
fn a_cardan_joint_has_the_ratio_of_its_angle() {
    let scene = example("rotational/cardan", Keep::All);
    for angle in [-1.4, -0.5, 0.0, 0.1, 0.6, 1.0, 1.3, 1.5] {
        let run = run(&scene, &[("joint.angle", angle)], &[]);
        let [left, right] = ["left", "right"].map(|name| column(&run, name));
        let phi = column(&run, "left.phi");
        let follower = column(&run, "right.phi");
        let start = 2.0 * 100.0 + 0.5 * right[0] * right[0];
        for row in 0..phi.len() {
            let exact = angle.cos() / (1.0 - (angle.sin() * phi[row].cos()).powi(2));
            let error = (right[row] / left[row] - exact).abs() / exact;
            assert!(error < 1e-8, "{angle}: {error:e}");
            // Both turn on together, and no energy is lost.
            assert!((follower[row] - phi[row]).abs() < PI / 2.0, "{angle}: another branch");
            let energy = 2.0 * left[row].powi(2) + 0.5 * right[row].powi(2);
            assert!((energy - start).abs() < 1e-6 * start, "{angle}: {energy} of {start}");
        }
    }
}

#[test]
fn an_unbalance_turns_by_its_weight_and_shakes_its_bearing() {
    let scene = example("rotational/unbalance", Keep::All);
    for speed in [2.0, 40.0, 300.0] {
        let run = run(&scene, &[("unbalance.mass", 2.0)], &[("rotor.omega", speed)]);
        let inertia = 0.1 + 2.0 * 0.05f64.powi(2);
        let phi = column(&run, "rotor.phi");
        let omega = column(&run, "speed");
        for row in 0..phi.len() {
            // J w^2/2 + m g e sin(phi) stays.
            let square = speed * speed - 2.0 * 2.0 * 9.81 * 0.05 * phi[row].sin() / inertia;
            assert!((omega[row] * omega[row] - square).abs() < 1e-6 * speed * speed, "{speed}");
            // The bearing carries m (y'' + g) of y = e sin(phi).
            let alpha = -2.0 * 9.81 * 0.05 * phi[row].cos() / inertia;
            let lift = 0.05 * (alpha * phi[row].cos() - omega[row].powi(2) * phi[row].sin());
            let force = 2.0 * (9.81 + lift);
            let found = column(&run, "bearing_y")[row];
            assert!((found - force).abs() < 1e-9 * (20.0 + force.abs()), "{speed}: {found}");
        }
    }
}

#[test]
fn a_fan_runs_down_and_a_pump_up() {
    let scene = example("sources/fan", Keep::Needed);
    for torque in sweep(1e-2, 1e3, 6) {
        let run = run(&scene, &[("fan.nominal_torque", torque)], &[]);
        let error = off(&run, "speed", |t| 150.0 / (1.0 + torque * t / (0.2 * 150.0)));
        assert!(error < 1e-8, "{torque}: {error:e}");
    }
    let scene = example("sources/pump", Keep::Needed);
    for head in [0.0, 1.0, 5.0, 11.0] {
        let simulation = machinist::Simulation::new(&scene).until(200.0);
        let simulation = simulation.parameter("pump.head_torque", head).expect("a parameter");
        let run = simulation.run().expect("it runs");
        let steady = 150.0 * ((12.0 - head) / 10.0).sqrt();
        let speed = run.last("speed").expect("an output");
        assert!((speed - steady).abs() < 1e-6 * steady, "{head}: {speed} of {steady}");
    }
}

#[test]
fn a_motor_has_both_its_time_constants() {
    let scene = example("electrical/dc_motor", Keep::Needed);
    for inductance in sweep(1e-5, 1e-2, 5) {
        for inertia in sweep(1e-2, 10.0, 3) {
            let set = [("motor.inductance", inductance), ("load.inertia", inertia)];
            // Thrown at 100 rad/s with the brushes short-circuited after the ramp: from the
            // steady state at 100 V the run stays there; so compare the way back to it.
            let (r, k, j) = (0.05, 0.6, 0.15 + inertia);
            let run = {
                let mut simulation =
                    machinist::Simulation::new(&scene).rtol(1e-10).from(0.5).until(1.5);
                for (name, value) in set {
                    simulation = simulation.parameter(name, value).expect("a parameter");
                }
                let mut state = vec![0.0; 2];
                let names = [0, 1].map(|i| machinist_contract::Describe::state(&scene, i).name);
                let omega = names.iter().position(|name| name.ends_with("omega")).expect("a speed");
                state[omega] = 50.0;
                simulation.initial_state(&state).run().expect("it runs")
            };
            // L i' = u - R i - k w, J w' = k i, by the eigenvalues of the two.
            let half = r / inductance / 2.0;
            let square = k * k / (inductance * j);
            let root = nalgebra::Complex::new(half * half - square, 0.0).sqrt();
            let [fast, slow] = [-root - half, root - half];
            let offset = 50.0 - 100.0 / k;
            // w = 100/k + a e^(slow t) + b e^(fast t), w'(0) = 0.
            let b = offset * slow / (slow - fast);
            let a = -b + offset;
            let exact = |t: f64| {
                let t = t - 0.5;
                let current = (a * slow * (slow * t).exp() + b * fast * (fast * t).exp()) * j / k;
                (100.0 / k + (a * (slow * t).exp() + b * (fast * t).exp()).re, current.re)
            };
            let error =
                off(&run, "speed", |t| exact(t).0).max(off(&run, "current", |t| exact(t).1));
            assert!(error < 1e-7, "{inductance}, {inertia}: {error:e}");
        }
    }
}

#[test]
fn circuits_have_their_time_constants() {
    let scene = example("electrical/resistor", Keep::Needed);
    let charged = example("electrical/voltage_source", Keep::Needed);
    for resistance in sweep(1.0, 1e5, 6) {
        let tau = resistance * 1e-3;
        let set = [("resistor.resistance", resistance)];
        let error = off(&run(&scene, &set, &[]), "voltage", |t| 5.0 * (-t / tau).exp());
        let rise = off(&run(&charged, &set, &[]), "voltage", |t| -10.0 * (-t / tau).exp_m1());
        assert!(error.max(rise) < 1e-7, "{resistance}: {error:e}, {rise:e}");
    }
    let scene = example("electrical/inductor", Keep::Needed);
    for inductance in sweep(1e-4, 10.0, 6) {
        let run = run(&scene, &[("inductor.inductance", inductance)], &[]);
        let frequency = 1.0 / (inductance * 1e-3).sqrt();
        let error = off(&run, "voltage", |t| 5.0 * (frequency * t).cos());
        assert!(error < 1e-8, "{inductance}: {error:e}");
    }
    let scene = example("electrical/capacitor", Keep::Needed);
    for capacitance in sweep(1e-5, 1.0, 6) {
        let run = run(&scene, &[("second.capacitance", capacitance)], &[]);
        let tau = 100.0 / (1e3 + 1.0 / capacitance);
        let mean = 5.0 * 1e-3 / (1e-3 + capacitance);
        let error = off(&run, "first", |t| mean + (5.0 - mean) * (-t / tau).exp());
        assert!(error < 1e-8, "{capacitance}: {error:e}");
    }
}

#[test]
fn imposed_motions_take_the_force_that_they_should() {
    let bodies = [
        ("sources/speed", "rotor.inertia", "torque"),
        ("sources/linear_speed", "body.mass", "force"),
    ];
    for (name, body, output) in bodies {
        let scene = example(name, Keep::All);
        let size = if name == "sources/speed" { 10.0 } else { 1.0 };
        for inertia in sweep(1e-2, 1e2, 5) {
            let run = run(&scene, &[(body, inertia)], &[]);
            // w' = c (u - w), u = A sin(f t): the damper's torque d (u - w) and that of the
            // drive's own inertia.
            let (c, f): (f64, f64) = (2.0 / inertia, 3.0);
            let square = c * c + f * f;
            let body_speed = |t: f64| {
                let steady = c * (f * t).sin() - f * (f * t).cos();
                size * c / square * (steady + f * (-c * t).exp())
            };
            let drive = |t: f64| {
                2.0 * (size * (f * t).sin() - body_speed(t)) + 1e-3 * size * f * (f * t).cos()
            };
            let error = off(&run, "speed", body_speed);
            assert!(error < 1e-7, "{name} {inertia}: {error:e}");
            // The torque is of the difference of both speeds, which may be a hundredth of them.
            let error = off(&run, output, drive);
            assert!(error < 1e-5, "{name} {inertia}: {error:e}");
        }
    }
    let feet =
        [("sources/angle", "rotor.inertia", "angle"), ("sources/position", "body.mass", "place")];
    for (name, body, output) in feet {
        let scene = example(name, Keep::All);
        for inertia in sweep(1e-2, 1e2, 5) {
            let run = run(&scene, &[(body, inertia)], &[]);
            let (w, f): (f64, f64) = ((100.0 / inertia).sqrt(), 3.0);
            let size = 0.2 * w * w / (w * w - f * f);
            let error = off(&run, output, |t| size * ((f * t).sin() - f / w * (w * t).sin()));
            assert!(error < 1e-7, "{name} {inertia}: {error:e}");
        }
    }
}

#[test]
fn contacts_push_and_ropes_pull_by_their_law() {
    let gap = example("translational/elastic_gap", Keep::All);
    let stops = example("translational/end_stops", Keep::All);
    let play = example("rotational/backlash", Keep::All);
    for damping in [0.0, 3.0, 100.0, 1e4] {
        for stiffness in [1e3, 1e5] {
            let set = [("buffers.stiffness", stiffness), ("buffers.damping", damping)];
            let run = run(&gap, &set, &[]);
            let exact = by_small_steps([0.0, 1.0, 1.0, 0.0], 2.0, 400_000, |_, y| {
                let push = contact(stiffness, damping, 0.5 - (y[2] - y[0]), y[1] - y[3]);
                [y[1], -push / 20.0, y[3], push / 10.0]
            });
            let error = (run.last("left").expect("one") - exact[1]).abs()
                + (run.last("right").expect("one") - exact[3]).abs();
            assert!(error < 1e-6, "gap, {stiffness}, {damping}: {error:e}");
            assert!(column(&run, "force").iter().all(|force| *force <= 0.0), "it only pushes");
        }
    }
    for damping in [0.0, 20.0, 500.0] {
        let run = run(&stops, &[("stops.damping", damping)], &[]);
        let exact = by_small_steps([0.0, 1.0], 2.0, 400_000, |_, y| {
            let push =
                contact(5e3, damping, y[0] - 0.1, y[1]) - contact(5e3, damping, -0.1 - y[0], -y[1]);
            [y[1], -push / 2.0]
        });
        let error = (run.last("place").expect("one") - exact[0]).abs();
        assert!(error < 1e-6, "stops, {damping}: {error:e}");
        let start = column(&run, "place").iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        assert!(start <= 0.1 + (2.0 / 5e3f64).sqrt() * 1.000_001, "{start}: beyond its energy");
    }
    for backlash in [0.0, 0.02, 0.5] {
        let set = [("play.backlash", backlash), ("play.stiffness", 300.0)];
        let run = run(&play, &set, &[]);
        let exact = by_small_steps([0.0; 4], 2.0, 400_000, |t, y| {
            let (twist, rate) = (y[2] - y[0], y[3] - y[1]);
            let pull = contact(300.0, 1.0, twist - backlash / 2.0, rate)
                - contact(300.0, 1.0, -twist - backlash / 2.0, -rate);
            let drive = 5.0 * (6.0 * t).sin();
            [y[1], (drive + pull) / 0.1, y[3], (-pull - 0.1 * y[3]) / 0.5]
        });
        let error = (run.last("twist").expect("one") - (exact[2] - exact[0])).abs();
        assert!(error < 1e-5, "play of {backlash}: {error:e}");
    }
    let rope = example("translational/rope", Keep::All);
    for length in [0.1, 2.0, 20.0] {
        let run = run(&rope, &[("rope.length", length)], &[]);
        // The tug alone until the rope is taut: x = t^2/2.
        let taut = (2.0 * length).sqrt();
        for (time, speed) in run.times.iter().zip(column(&run, "tug")) {
            assert!(*time > taut || (speed - time).abs() < 1e-9, "{length}: slack at {time}");
        }
        let late = |time: &&f64| **time > taut + 0.1;
        let pulls = column(&run, "force").iter().any(|force| *force > 1.0);
        assert_eq!(pulls, run.times.iter().any(|t| late(&t)), "{length}: it pulls once taut");
        assert!(column(&run, "force").iter().all(|force| *force >= 0.0), "{length}: it pushes");
        let momentum =
            20.0 * run.last("tug").expect("one") + 100.0 * run.last("barge").expect("one");
        assert!((momentum - 20.0 * 6.0).abs() < 1e-6, "{length}: {momentum}");
    }
}
