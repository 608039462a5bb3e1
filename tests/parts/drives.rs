//! Controllers and motors against their closed forms.

use std::f64::consts::TAU;

use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use nalgebra::Complex;

use super::{METHODS, column, example, off, run};
use crate::own_scene::{of_specs, of_text};

#[test]
fn a_lag_follows_a_wave_as_its_closed_form() {
    let scene = example("control/lag", Keep::Needed);
    for time_constant in [1e-3, 0.1, 3.0, 100.0] {
        for gain in [-2.0, 0.5] {
            let set = [("sensor.time_constant", time_constant), ("sensor.gain", gain)];
            let (run, w) = (run(&scene, &set, &[]), 10.0);
            let turn = w * time_constant;
            let exact = |t: f64| {
                let settled = (w * t).sin() - turn * (w * t).cos();
                gain / (1.0 + turn * turn) * (settled + turn * (-t / time_constant).exp())
            };
            let error = off(&run, "measured", exact);
            assert!(error < 1e-8, "{time_constant}, {gain}: {error:e}");
        }
    }
}

const LOOP: &str = r#"
[scene]
name = "closed_loop"

[units.controller]
unit = "control/pi_controller"
parameters = { least = -1e9, greatest = 1e9 }
inputs = { error = "1 - plant.output" }

[units.plant]
unit = "control/lag"
inputs = { input = "controller.output" }

[outputs]
answer = "plant.output"

[run]
until = 3.0
points = 301
rtol = 1e-10
method = "auto"
"#;

/// If the integral time equals that of the plant, the loop is of first order.
#[test]
fn a_loop_whose_controller_cancels_the_lag_answers_a_step_as_its_closed_form() {
    let scene = of_text(LOOP, Keep::Needed);
    for time in [0.05, 1.0, 20.0] {
        for (gain, of_plant) in [(0.3, 1.0), (2.0, 5.0), (40.0, 0.5)] {
            let set = [
                ("controller.gain", gain),
                ("controller.integral_time", time),
                ("plant.time_constant", time),
                ("plant.gain", of_plant),
            ];
            let run = run(&scene, &set, &[]);
            let error = off(&run, "answer", |t| 1.0 - (-gain * of_plant * t / time).exp());
            assert!(error < 1e-7, "{time}, {gain}, {of_plant}: {error:e}");
        }
    }
}

/// Steady dq currents: the stationary solution of its two equations at a speed.
#[test]
fn a_synchronous_motor_settles_where_its_currents_and_its_load_say() {
    let scene = example("electrical/pmsm", Keep::Needed);
    for pole_pairs in [1.0, 4.0, 9.0] {
        for magnet in [0.05, 0.3] {
            for resistance in [0.2, 2.0] {
                let set = [
                    ("motor.pole_pairs", pole_pairs),
                    ("motor.magnet", magnet),
                    ("motor.resistance", resistance),
                ];
                let mut simulation = Simulation::new(&scene).rtol(1e-10).until(20.0);
                for (name, value) in set {
                    simulation = simulation.parameter(name, value).expect("a parameter");
                }
                let run = simulation.run().expect("it runs");
                let last = |name: &str| *column(&run, name).last().expect("a row");
                let (speed, of_d, of_q) = (last("speed"), 0.004, 0.006);
                let turning = pole_pairs * speed;
                // R i_d - w L_q i_q = u_d, w L_d i_d + R i_q = u_q - w psi
                let (u_d, u_q) = (-10.0, 60.0 - turning * magnet);
                let divisor = resistance * resistance + turning * turning * of_d * of_q;
                let i_d = (resistance * u_d + turning * of_q * u_q) / divisor;
                let i_q = (resistance * u_q - turning * of_d * u_d) / divisor;
                let torque = 1.5 * pole_pairs * (magnet + (of_d - of_q) * i_d) * i_q;
                let brake = 20.0 * (speed / 50.0) / (1.0 + (speed / 50.0).powi(2));
                let size = i_d.abs().max(i_q.abs());
                let what = format!("{pole_pairs}, {magnet}, {resistance}: {speed}");
                assert!((last("current_d") - i_d).abs() < 1e-6 * size, "{what}");
                assert!((last("current_q") - i_q).abs() < 1e-6 * size, "{what}");
                assert!((torque - brake).abs() < 1e-6 * brake.abs(), "{what}");
            }
        }
    }
}

const AT_A_SPEED: &str = r#"
[scene]
name = "at_a_speed"

[units.motor]
unit = "electrical/pmsm"
parameters = { inductance_d = 0.005, inductance_q = 0.005 }
inputs = { voltage_d = "7 [V]", voltage_q = "30 [V]" }

[units.drive]
unit = "sources/speed"
inputs = { speed = "given" }

[parameters]
given = { value = 40.0, unit = "rad/s" }

[[joints]]
connect = ["motor.a", "drive.a"]

[initial]
"motor.omega" = "given"

[outputs]
current_d = "motor.current_d"
current_q = "motor.current_q"

[run]
until = 0.05
points = 101
rtol = 1e-10
method = "dop853"
"#;

/// i' = (u - R i)/L - j w (i + psi/L), where both inductances are L.
#[test]
fn currents_of_a_round_rotor_turn_and_decay_as_one_complex_exponential() {
    let scene = of_text(AT_A_SPEED, Keep::Needed);
    for given in [0.0, 40.0, -300.0] {
        let run = run(&scene, &[("given", given)], &[]);
        let (r, l, magnet, turning) = (0.5, 0.005, 0.15, 4.0 * given);
        let pole = Complex::new(-r / l, -turning);
        let drive = Complex::new(7.0, 30.0 - turning * magnet) / l;
        let exact = |t: f64| drive / pole * ((pole * t).exp() - 1.0);
        let error = off(&run, "current_d", |t| exact(t).re);
        let error = error.max(off(&run, "current_q", |t| exact(t).im));
        assert!(error < 1e-7, "{given}: {error:e}");
    }
}

const ON_A_CONVERTER: &str = r#"
[scene]
name = "on_a_converter"
[units.converter]
unit = "electrical/converter"
inputs = { frequency = "frequency" }
[units.motor]
unit = "electrical/induction_motor"
inputs = { voltage_x = "converter.voltage", voltage_y = "0 [V]", axes_speed = "converter.speed" }
[units.drive]
unit = "sources/speed"
inputs = { speed = "given" }
[[joints]]
connect = ["motor.a", "drive.a"]
[parameters]
frequency = { value = 50.0, unit = "Hz" }
given = { value = 40.0, unit = "rad/s" }
[initial]
"motor.omega" = "given"
[outputs]
torque = "motor.torque"
current = "motor.current"
[run]
until = 6.0
points = 2
rtol = 1e-9
method = "auto"
"#;

/// Steady state, by the equivalent circuit: (R_s + j w L_s) I_s + j w M I_r = U,
/// (R_r + j s L_r) I_r + j s M I_s = 0 for the slip speed s.
#[test]
fn an_induction_motor_on_a_converter_settles_as_its_equivalent_circuit() {
    let scene = of_text(ON_A_CONVERTER, Keep::Needed);
    for (number, frequency) in [-50.0, 3.0, 20.0, 50.0, 90.0].into_iter().enumerate() {
        for slip in [-0.3, -0.02, 0.05, 1.0] {
            let turning = TAU * frequency;
            let given = turning * (1.0 - slip) / 2.0;
            let set = [("frequency", frequency), ("given", given)];
            let method = [Method::Auto, Method::Radau, Method::Dop853][number % 3];
            let run = set
                .into_iter()
                .try_fold(Simulation::new(&scene), |run, (name, value)| run.parameter(name, value))
                .expect("parameters")
                .method(method)
                .run()
                .unwrap_or_else(|error| panic!("{set:?} {method}: {error}"));
            let voltage = f64::min(15.0 + 310.0 * f64::abs(frequency) / 50.0, 325.0);
            let j = Complex::i();
            let rotor = -j * (slip * turning) * 0.172 / (1.2 + j * (slip * turning) * 0.18);
            let stator = voltage / (1.4 + j * turning * 0.18 + j * turning * 0.172 * rotor);
            let flux = stator * 0.18 + stator * rotor * 0.172;
            let torque = 1.5 * 2.0 * (flux.conj() * stator).im;
            let found = ["torque", "current"].map(|name| run.last(name).expect("an output"));
            let size = torque.abs().max(1.0);
            assert!((found[0] - torque).abs() < 1e-5 * size, "{set:?}: {found:?}, not {torque}");
            let current = stator.norm();
            assert!((found[1] - current).abs() < 1e-6 * current, "{set:?}: {found:?}, {current}");
        }
    }
}

#[test]
fn an_amplifier_gives_what_it_is_asked_for_up_to_its_limit() {
    let text = r#"
        [scene]
        name = "amplified"
        [units.amplifier]
        unit = "electrical/amplifier"
        inputs = { signal = "3*sin(10 [rad/s]*t)" }
        [units.follower]
        unit = "control/lag"
        inputs = { input = "amplifier.voltage/1 [V]" }
        [outputs]
        follower = "follower.output"
        voltage = { expression = "amplifier.voltage", unit = "V" }
        [run]
        until = 1.0
        points = 101
        rtol = 1e-9
        method = "auto"
    "#;
    let scene = of_text(text, Keep::Needed);
    for (gain, limit) in [(100.0, 100.0), (-2.0, 50.0), (30.0, 10.0)] {
        let run = run(&scene, &[("amplifier.gain", gain), ("amplifier.limit", limit)], &[]);
        let exact = |t: f64| (gain * 3.0 * (10.0 * t).sin()).clamp(-limit, limit);
        let error = off(&run, "voltage", exact);
        assert!(error < 1e-12, "{gain}, {limit}: {error:e}");
        assert!(column(&run, "follower").iter().any(|value| *value != 0.0));
    }
}

/// Returns the height of the press's slider at an angle of its crank, and its slope.
fn height(angle: f64) -> (f64, f64) {
    let (sin, cos) = angle.sin_cos();
    let along = (0.25f64.powi(2) - (0.05 * cos).powi(2)).sqrt();
    (0.05 * sin - along, 0.05 * cos - 0.0025 * sin * cos / along)
}

/// Results that depend on slipping and sticking are the same by any method: the time at which the
/// belt grips, the travel of the press, and where and by what it is held.
#[test]
fn a_press_of_standard_parts_starts_works_and_stops() {
    let scene = of_specs("drives/press", Keep::Needed);
    let run = |method: Method, rtol: f64| {
        let run = Simulation::new(&scene).method(method).rtol(rtol).with_energy_balance(true).run();
        run.unwrap_or_else(|error| panic!("{method} at {rtol:e}: {error}"))
    };
    let exact = run(Method::Dop853, 1e-11);
    for method in METHODS {
        for rtol in [1e-5, 1e-8] {
            let run = run(method, rtol);
            let what = format!("{method} at {rtol:e}");
            // The belt slips by Euler and Eytelwein until it grips.
            let first = |name: &str| {
                let found = run.switches.iter().find(|switch| switch.event == name);
                found.unwrap_or_else(|| panic!("{what}: no {name}")).time
            };
            let (slips, grips) = (first("belt.breaks_back"), first("belt.ends_back"));
            assert!(slips < 0.01 && grips > 0.1, "{what}: {slips}, {grips}");
            let gain = 0.4 * 1600.0 * f64::tanh(0.7) / 20.0;
            let mut worked: f64 = 0.0;
            for (row, time) in run.times.iter().enumerate() {
                let at = |name: &str| column(&run, name)[row];
                let (y, slope) = height(at("crank"));
                assert!((at("height") - y).abs() < 1e-9, "{what} at {time}: {}", at("height"));
                let (before, flywheel) = (row.max(1) - 1, column(&run, "flywheel"));
                if run.times[before] > slips && *time < grips {
                    let grown = flywheel[row] - flywheel[before];
                    let off = (grown - gain * (time - run.times[before])).abs();
                    assert!(off < 1e-6 + 10.0 * rtol, "{what} at {time}: {off:e}");
                } else if *time > grips && *time < 2.0 {
                    let rims = 0.05 * at("motor") - 0.4 * at("flywheel");
                    assert!(rims.abs() < 1e-10, "{what} at {time}: {rims:e}");
                }
                worked = worked.max(at("force"));
                if *time < 2.0 || *time > 4.7 {
                    // Held exactly, by the moment of all weights.
                    assert!(at("speed").abs() < 1e-12, "{what} at {time}: it creeps");
                    let cos = at("crank").cos();
                    let middle = 0.5 * (0.05 * cos + slope);
                    let moment = 9.81 * (20.0 * 0.01 * cos + 8.0 * middle + 30.0 * slope);
                    let off = (at("braked") - moment).abs();
                    assert!(off < 1e-6 + 1e3 * rtol, "{what} at {time}: {off:e}");
                }
            }
            assert!(worked > 4000.0, "{what}: {worked}");
            for (name, size) in [("crank", 25.0), ("flywheel", 12.5), ("motor", 100.0)] {
                let [found, exact] = [&run, &exact].map(|run| run.last(name).expect("an output"));
                assert!((found - exact).abs() < 300.0 * rtol * size, "{what} {name}: {found}");
            }
            let residual = run.energy_balance.as_ref().expect("asked for").max_residual_relative();
            assert!(residual < 1e2 * rtol, "{what}: {residual:e}");
        }
    }
}
