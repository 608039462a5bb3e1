//! Cylinders and valves against closed forms.

use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Describe;
use nalgebra::Complex;

use super::{column, example, run};
use crate::own_scene::of_text;

/// p' = -K V'/V keeps V exp(p/K); small swings are those of two springs K A^2/V.
#[test]
fn a_closed_cylinder_keeps_its_oil_and_swings_on_it() {
    let scene = example("hydraulic/cylinder", Keep::All);
    for (number, modulus) in [2e7, 1.4e9, 2e10].into_iter().enumerate() {
        for mass in [1.0, 200.0] {
            let method = [Method::Dop853, Method::Auto, Method::Radau][number];
            let stiffness = modulus * (0.002f64.powi(2) / 2e-4 + 0.0012f64.powi(2) / 8e-4);
            let frequency = (stiffness / mass).sqrt();
            for speed in [1e-7 * frequency, 1e-2 * frequency] {
                let simulation = Simulation::new(&scene)
                    .parameter("cylinder.bulk_modulus", modulus)
                    .and_then(|run| run.parameter("body.mass", mass))
                    .expect("parameters")
                    .method(method)
                    .rtol(1e-11)
                    .until(30.0 / frequency);
                let mut state = vec![0.0; 4];
                let index = (0..4).find(|k| scene.state(*k).name == "body.v").expect("a speed");
                state[index] = speed;
                let run = simulation.initial_state(&state).run().expect("it runs");
                let amplitude = speed / frequency;
                for row in 0..run.times.len() {
                    let at = |name: &str| column(&run, name)[row];
                    let x = at("place");
                    let case = format!("{modulus:e}, {mass}, {speed}: {x:e}");
                    for (pressure, change) in
                        [("pressure_a", 0.002 / 2e-4 * x), ("pressure_b", -0.0012 / 8e-4 * x)]
                    {
                        let exact = -modulus * change.ln_1p();
                        let off = (at(pressure) - exact).abs();
                        assert!(off < 1e-7 * modulus * amplitude * 10.0 + 1e-3, "{case}: {off}");
                    }
                    if amplitude < 1e-6 {
                        let exact = amplitude * (frequency * run.times[row]).sin();
                        assert!((x - exact).abs() < 1e-4 * amplitude, "{case}: {exact:e}");
                    }
                }
            }
        }
    }
}

const DRIVEN: &str = r#"
[scene]
name = "driven"
[units.valve]
unit = "hydraulic/valve"
parameters = { laminar_drop = 10 }
inputs = { opening = "opening", pressure_a = "cylinder.pressure_a", pressure_b = "cylinder.pressure_b" }
[units.cylinder]
unit = "hydraulic/cylinder"
parameters = { volume_a = 1e-3, volume_b = 1e-3 }
inputs = { flow_a = "valve.flow_a", flow_b = "valve.flow_b" }
[units.body]
unit = "translational/mass"
parameters = { mass = 50 }
[units.load]
unit = "sources/force"
inputs = { force = "-load" }
[[joints]]
connect = ["cylinder.a", "body.a"]
[[joints]]
connect = ["body.b", "load.a"]
[parameters]
opening = { value = 1.0, unit = "1" }
load = { value = 0.0, unit = "N" }
[initial]
"cylinder.pressure_a" = 4e6
"cylinder.pressure_b" = 4e6
[outputs]
speed = "body.v"
pressure_a = "cylinder.pressure_a"
[run]
until = 1.2
points = 61
rtol = 1e-8
method = "auto"
"#;

/// v^2 = k^2 (p_s A_a - F)/(A_a^3 + A_b^3), what the valve's two edges let pass.
#[test]
fn a_valve_moves_a_cylinder_at_the_speed_of_both_its_edges() {
    let scene = of_text(DRIVEN, Keep::Needed);
    for (number, opening) in [-1.0, -0.3, 0.2, 0.6, 1.0].into_iter().enumerate() {
        for load in [-4000.0, 0.0, 9000.0] {
            let set = [("opening", opening), ("load", load), ("valve.nominal_flow", 4e-4)];
            let simulation = set
                .into_iter()
                .try_fold(Simulation::new(&scene), |run, (name, value)| run.parameter(name, value));
            let method = [Method::Auto, Method::Radau, Method::Rodas5p][number % 3];
            let (a, b) = (0.002, 0.0012);
            let passes = 4e-4 * f64::abs(opening) / f64::sqrt(3.5e6);
            let driving = if opening > 0.0 { 1e7 * a - load } else { 1e7 * b + load };
            let exact = opening.signum() * passes * (driving / (a * a * a + b * b * b)).sqrt();
            let until = 0.4 / exact.abs();
            let run = simulation.expect("parameters").method(method).until(until).run();
            let run = run.unwrap_or_else(|error| panic!("{set:?} {method}: {error}"));
            let speed = run.last("speed").expect("an output");
            assert!((speed - exact).abs() < 1e-3 * exact.abs(), "{set:?}: {speed}, not {exact}");
            let drop = (a * exact.abs() / passes).powi(2);
            let pressure = if opening > 0.0 { 1e7 - drop } else { drop };
            let found = run.last("pressure_a").expect("an output");
            assert!((found - pressure).abs() < 1e-3 * 1e7, "{set:?}: {found}, not {pressure}");
        }
    }
}

/// Two chambers alike with a piston of equal areas: oil past it damps the swing as
/// m v' = A (p_a - p_b), (p_a - p_b)' = -2 K/V (A v + c (p_a - p_b)).
#[test]
fn oil_past_the_piston_damps_its_swing() {
    let scene = example("hydraulic/cylinder", Keep::All);
    for leakage in [1e-13, 1e-11, 1e-10] {
        for mass in [20.0, 2000.0] {
            let set = [
                ("cylinder.leakage", leakage),
                ("cylinder.area_b", 0.002),
                ("cylinder.volume_b", 2e-4),
                ("body.mass", mass),
            ];
            let run = run(&scene, &set, &[("body.v", 1e-4)]);
            let decay = 1.4e9 / 2e-4 * leakage;
            let square = 2.0 * 1.4e9 / 2e-4 * 0.002 * 0.002 / mass;
            let root = Complex::new(decay * decay - square, 0.0).sqrt();
            let [fast, slow] = [-root - decay, root - decay];
            // d(p)/dt = -2 K A v/V at the start, from zero.
            let start = -2.0 * 1.4e9 / 2e-4 * 0.002 * 1e-4;
            let exact = |t: f64| (((slow * t).exp() - (fast * t).exp()) / (slow - fast) * start).re;
            let drops = column(&run, "pressure_a").iter().zip(column(&run, "pressure_b"));
            for (time, (a, b)) in run.times.iter().zip(drops) {
                let size = start.abs() / square.sqrt().max(2.0 * decay);
                let off = (a - b - exact(*time)).abs() / size;
                assert!(off < 1e-4, "{leakage}, {mass}: {} of {}", a - b, exact(*time));
            }
        }
    }
}

/// An opening that comes to rest wide open is where its limit begins, by rounding on either side.
#[test]
fn a_valve_that_opens_wide_without_a_jump_stops_no_method() {
    let scene = example("hydraulic/valve", Keep::Needed);
    let methods = [
        Method::Auto,
        Method::Dop853,
        Method::Tsit5,
        Method::Radau,
        Method::Rodas5p,
        Method::Taylor,
    ];
    let exact = Simulation::new(&scene).rtol(1e-12).points(2).run().expect("it runs");
    let exact = exact.last("place").expect("an output");
    for method in methods {
        for rtol in [1e-4, 1e-6, 1e-8, 1e-10] {
            let run = Simulation::new(&scene).method(method).rtol(rtol).points(2).run();
            let run = run.unwrap_or_else(|error| panic!("{method} at {rtol:e}: {error}"));
            let place = run.last("place").expect("an output");
            assert!((place - exact).abs() < 1e2 * rtol, "{method} at {rtol:e}: {place}, {exact}");
        }
    }
}
