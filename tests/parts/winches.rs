//! A winch with a lossy gear: power of its motor, holding by its brake, and no run with tiny steps
//! while something comes to rest.

use machinist::{Method, SimulateError, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use super::{METHODS, column};
use crate::own_scene::of_text;

/// Returns the scene of the specs, after changes of its text.
fn winch(changes: &[(&str, &str)]) -> ModelSimulator {
    let mut text = include_str!("../../specs/scenes/drives/winch.toml").to_owned();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    of_text(&text, Keep::Needed)
}

/// When what the brake leaves alone with the gear has come to rest \[s\]: the scene ends before.
const LONG: f64 = 9.0;

/// Returns the mean of a column between two times.
fn mean(run: &Trajectory, name: &str, from: f64, until: f64) -> f64 {
    let values = run.times.iter().zip(column(run, name));
    let within = values.filter(|(time, _)| (from..until).contains(*time));
    let found: Vec<f64> = within.map(|(_, value)| *value).collect();
    found.iter().sum::<f64>() / found.len() as f64
}

/// The motor and the brake hold the load in turn: the motor also supplies the losses of the gear,
/// the brake holds the load alone.
#[test]
fn a_winch_of_standard_parts_lifts_and_holds_its_load() {
    let scene = winch(&[]);
    let torque = 500.0 * 9.81 * 0.25;
    for method in [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Auto] {
        for rtol in [1e-4, 1e-7, 1e-10] {
            let what = format!("{method} at {rtol:e}");
            let run = Simulation::new(&scene).method(method).rtol(rtol).until(LONG).run();
            let run = run.unwrap_or_else(|error| panic!("{what}: {error}"));
            let lifting = torque / 20.0 / 0.6 / 0.85;
            let speed = mean(&run, "speed", 2.5, 3.0);
            assert!((speed - 80.0).abs() < 0.1, "{what}: {speed}");
            let current = mean(&run, "current", 2.5, 3.0);
            assert!((current - lifting).abs() < 0.01 * lifting, "{what}: {current}");
            let closes = run.switches.iter().find(|switch| switch.event == "brake.closes");
            assert!((closes.expect("it closes").time - 3.0).abs() < 1e-12, "{what}");
            let held = mean(&run, "holding", 8.0, 9.0);
            let most = (2e-3 + 100.0 * rtol) * torque;
            assert!((held - torque).abs() < most, "{what}: {held} for {torque}");
            let after =
                run.times.iter().zip(column(&run, "speed")).filter(|(time, _)| **time > 8.0);
            // Far below the tolerance of the speed of 80 rad/s.
            let rest = 1e-3 * rtol * 80.0;
            for (time, speed) in after {
                assert!(speed.abs() < rest, "{what}: {speed} at {time}");
            }
        }
    }
}

/// Power into the gear, and its losses.
const POWERS: (&str, &str) = (
    "[outputs]\n",
    "[outputs]\nlost = \"gear.loss\"\ngiven = { expression = \"motor.torque*motor.omega\", unit = \"W\" }\n",
);

/// One run of the winch. Once its brake holds the drum, the motor is left alone with the gear, and
/// what moves there dies out far below what its angle resolves.
#[derive(Debug, Clone, Copy)]
struct Lift {
    method: Method,
    rtol: f64,
    efficiency: f64,
    mass: f64,
}

impl Lift {
    /// Runs within some steps, and compares with the efficiency.
    fn check(self, scene: &ModelSimulator) {
        const STEPS: usize = 30_000;
        let Self { method, rtol, efficiency, mass } = self;
        let run = || -> Result<Trajectory, SimulateError> {
            let run = Simulation::new(scene).parameter("gear.efficiency", efficiency)?;
            let run = run.parameter("load.mass", mass)?.method(method).rtol(rtol);
            let run = run.until(LONG);
            let limit = std::time::Duration::from_secs(20);
            run.max_steps(STEPS).time_limit(limit).with_energy_balance(true).run()
        };
        let run = run().unwrap_or_else(|error| panic!("{self:?}: {error}"));
        let torque = mass * 9.81 * 0.25;
        let lifting = torque / 20.0 / 0.6 / efficiency;
        let found = mean(&run, "current", 2.0, 3.0);
        // Oscillations on the rope have not decayed yet.
        assert!((found - lifting).abs() < 0.03 * lifting, "{self:?}: {found} for {lifting}");
        let lost = mean(&run, "lost", 2.0, 3.0) / mean(&run, "given", 2.0, 3.0);
        assert!((lost - (1.0 - efficiency)).abs() < 0.02, "{self:?}: {lost} lost");
        let held = mean(&run, "holding", 8.5, 9.0);
        assert!((held - torque).abs() < 2e-2 * torque, "{self:?}: {held} for {torque}");
        let rest = mean(&run, "speed", 8.5, 9.0);
        assert!(rest.abs() < 1e-9 + rtol, "{self:?}: {rest}");
        let balance = run.energy_balance.as_ref().expect("asked for").max_residual_relative();
        assert!(balance < 1e3 * rtol, "{self:?}: {balance:e}");
    }
}

/// A few by their numbers, and so many by chance as `MACHINIST_WINCHES` says.
#[test]
fn no_winch_creeps_as_its_motor_comes_to_rest() {
    let scene = winch(&[POWERS]);
    let lift = |method, rtol, efficiency, mass| Lift { method, rtol, efficiency, mass };
    for (number, efficiency) in [0.3, 0.6, 0.8, 0.97, 1.0].into_iter().enumerate() {
        for rtol in [1e-3, 1e-6, 1e-7, 1e-9] {
            lift(Method::Auto, rtol, efficiency, 500.0).check(&scene);
        }
        let rtol = [1e-5, 1e-5, 1e-6, 1e-8, 1e-10][number];
        lift(METHODS[number], rtol, efficiency, [100.0, 700.0][number % 2]).check(&scene);
    }
    let more = std::env::var("MACHINIST_WINCHES").ok().and_then(|text| text.parse().ok());
    let mut random = fastrand::Rng::with_seed(7);
    for _ in 0..more.unwrap_or(0) {
        let method = METHODS[random.usize(..METHODS.len())];
        let rtol = 10f64.powf(-10.0 + 7.0 * random.f64());
        lift(method, rtol, 0.3 + 0.7 * random.f64(), 50.0 + 700.0 * random.f64()).check(&scene);
    }
}
