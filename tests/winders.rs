//! A winder whose package slips elastically and is pressed by a spring, against closed forms.

use std::f64::consts::PI;

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::common::column;
use crate::own_scene::of_specs;

const METHODS: [Method; 5] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Auto];
const FRICTION: f64 = 0.18;
const SPEED: f64 = 2.2;
const UNDISTURBED: [(&str, f64); 2] = [("force_amplitude", 0.0), ("ovality", 0.0)];

fn winder() -> ModelSimulator {
    of_specs("drives/winder_elastic_slip", Keep::Needed)
}

fn run(
    simulator: &ModelSimulator,
    settings: &[(&str, f64)],
    (method, until): (Method, f64),
) -> Trajectory {
    let base = Simulation::new(simulator.single()).method(method).rtol(1e-10);
    let settings = UNDISTURBED.iter().chain(settings);
    let run = settings
        .fold(base, |run, (name, value)| run.parameter(name, *value).expect("a parameter"))
        .until(until)
        .points(101);
    run.run().unwrap_or_else(|error| panic!("{method}: {error}"))
}

fn yarn(radius: f64) -> f64 {
    PI * (radius * radius - 9e-4) * 0.15 * 350.0
}

/// N by equation (15) \[N\].
fn pressure(radius: f64) -> f64 {
    40.0 + 3800.0 * (radius - 0.03) + 9.81 * yarn(radius)
}

fn inertia(radius: f64) -> f64 {
    6e-4 + PI * (radius.powi(4) - 0.03_f64.powi(4)) * 0.15 * 350.0 / 2.0
}

fn resistance(tension: f64, radius: f64) -> f64 {
    tension + pressure(radius) * 1e-3 / radius
}

/// J w' = (f N nu/nu_most - resistance) R with w = v/R (1 - nu): nu tends exponentially to
/// nu_most times the share of f N that the resistance takes.
#[test]
fn elastic_slip_is_the_share_of_friction_in_use() {
    let winder = winder();
    for method in METHODS {
        for (radius, tension, most) in
            [(0.03, 0.6, 0.04), (0.03, 3.0, 0.04), (0.05, 0.1, 0.04), (0.06, 8.0, 0.01)]
        {
            let settings = [
                ("pair.package_radius", radius),
                ("pair.tension", tension),
                ("pair.greatest_slip", most),
                ("pair.thread_area", 0.0),
            ];
            let run = run(&winder, &settings, (method, 0.1));
            let limit = FRICTION * pressure(radius);
            let settled = most * resistance(tension, radius) / limit;
            assert!(settled < most, "{settled}");
            let rate = limit * radius * radius / (inertia(radius) * most * SPEED);
            for (time, slip) in run.times.iter().zip(column(&run, "slip")) {
                let exact = settled * (1.0 - (-rate * time).exp());
                assert!((slip - exact).abs() < 1e-7, "{method} {radius} {time}: {slip} {exact}");
            }
        }
    }
}

/// More resistance than friction: past the greatest elastic slip the package lags behind evenly.
#[test]
fn beyond_its_greatest_elastic_slip_a_package_lags_behind() {
    let winder = winder();
    let tension = 9.0;
    for method in METHODS {
        let settings = [("pair.tension", tension), ("pair.thread_area", 0.0)];
        let run = run(&winder, &settings, (method, 0.15));
        let (limit, resisting) = (FRICTION * 40.0, resistance(tension, 0.03));
        let slows = (limit - resisting) * 0.03 / inertia(0.03);
        let (slip, speed) = (column(&run, "slip"), column(&run, "speed"));
        let first = slip.iter().position(|slip| *slip > 0.04).expect("it slips");
        assert!(first < 50, "{method}: {first}");
        for row in first..run.times.len() {
            let exact = speed[first] + slows * (run.times[row] - run.times[first]);
            assert!((speed[row] - exact).abs() < 1e-7, "{method} {row}: {} {exact}", speed[row]);
            let carried = column(&run, "friction")[row];
            assert!((carried - limit).abs() < 1e-9, "{method} {row}: {carried}");
        }
    }
}

/// A thread as thick as a rope fills the package within the run.
#[test]
fn the_pressure_of_a_growing_package_is_that_of_its_spring_and_weight() {
    let winder = winder();
    for method in METHODS {
        let run = run(&winder, &[("pair.thread_area", 3e-3)], (method, 0.2));
        let radii = column(&run, "radius");
        assert!(radii.last().is_some_and(|radius| *radius > 0.05), "{:?}", radii.last());
        for (found, radius) in column(&run, "pressure").iter().zip(radii) {
            let exact = pressure(*radius);
            assert!((found / exact - 1.0).abs() < 1e-6, "{method} {radius}: {found} {exact}");
        }
    }
}

/// The full winder with elastic slip, which has modes, against the other one, which limits the slip
/// by relations, in one disturbed motion.
#[test]
fn the_full_winder_slips_elastically_as_the_other_one() {
    let [full, other] =
        ["winder_full", "drives/winder_elastic_slip"].map(|name| of_specs(name, Keep::Needed));
    for (tension, most) in [(0.6, 0.04), (3.0, 0.02), (9.0, 0.04)] {
        let run = |scene: &ModelSimulator, method| {
            let settings = [
                ("winding_speed", 2.2),
                ("force_amplitude", 25.0),
                ("pair.thread_area", 0.0),
                ("pair.tension", tension),
                ("pair.greatest_slip", most),
            ];
            let run = Simulation::new(scene.single()).method(method).rtol(1e-10);
            let run = settings
                .iter()
                .fold(run, |run, (name, value)| run.parameter(name, *value).expect("a parameter"));
            let run = run.until(0.2).points(201).run();
            run.unwrap_or_else(|error| panic!("{method}: {error}"))
        };
        let exact = run(&other, Method::Dop853);
        assert!(column(&exact, "pressure").contains(&0.0), "it leaves the drum");
        for method in METHODS {
            let found = run(&full, method);
            let pairs = [
                ("pair.omega", "speed", 1e-6),
                ("slip", "slip", 1e-8),
                ("friction", "friction", 1e-4),
                ("deflection", "deflection", 1e-9),
            ];
            for (name, of_other, allowed) in pairs {
                let pairs = column(&found, name).iter().zip(column(&exact, of_other));
                for (row, (found, exact)) in pairs.enumerate() {
                    let off = (found - exact).abs();
                    assert!(off < allowed, "{method} {tension} {name} {row}: {found} {exact}");
                }
            }
        }
    }
}
