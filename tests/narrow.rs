//! Forces that last a thousandth or a millionth of a run, from rest: no method may step over them.

use std::f64::consts::{PI, TAU};

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::own_scene::{of_files, of_text};

const OWN: [Method; 6] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Taylor, Method::Auto];

/// Returns a block on a hardening spring, at rest for 100 s except for a force.
fn text(force: &str) -> String {
    format!(
        r#"
        [scene]
        name = "blocks"
        [units.block]
        unit = "block"
        [run]
        until = 100.0
        points = 101
        rtol = 1e-8
        method = "auto"
        [define.block.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.block.parameters]
        centre = {{ value = 50.0, unit = "s" }}
        width = {{ value = 1e-3, unit = "s" }}
        [define.block.energy]
        kinetic = "1 [kg]*v^2/2"
        potential = "1 [N/m]*x^2/2 + 1 [N/m^3]*x^4/4"
        [[define.block.forces]]
        coordinate = "x"
        expression = '100*({force})*1 [s]/width/1e3'
        "#
    )
}

fn run(block: &ModelSimulator, method: Method, rtol: f64, set: [f64; 2]) -> Trajectory {
    let run = Simulation::new(block).method(method).rtol(rtol);
    let run = run.parameter("block.centre", set[0]).expect("a parameter");
    let run = run.parameter("block.width", set[1]).expect("a parameter");
    run.run().unwrap_or_else(|error| panic!("{method} at {rtol:e}, {set:?}: {error}"))
}

fn difference(a: &Trajectory, b: &Trajectory) -> f64 {
    ["block.x", "block.v"].iter().fold(0.0, |most: f64, name| {
        let values = [a, b].map(|run| run.column(name).expect("a state"));
        let pairs = values[0].iter().zip(values[1]);
        pairs.fold(most, |most, (a, b)| most.max((a - b).abs()))
    })
}

/// Checks that the force leaves its `impulse` [N s], and that all methods agree.
fn is_seen(block: &ModelSimulator, set: [f64; 2], impulse: f64) {
    let exact = run(block, Method::Dop853, 1e-13, set);
    // After a very short pulse the energy is that of its impulse.
    let (x, v) = (exact.column("block.x").expect("x"), exact.column("block.v").expect("v"));
    let last = x.len() - 1;
    let energy = v[last].powi(2) / 2.0 + x[last].powi(2) / 2.0 + x[last].powi(4) / 4.0;
    let expected = impulse * impulse / 2.0;
    assert!((energy - expected).abs() < 1e-3 * expected, "{set:?}: {energy} for {expected}");
    for method in OWN {
        for rtol in [1e-3, 1e-5, 1e-7, 1e-9] {
            let error = difference(&run(block, method, rtol, set), &exact);
            assert!(error < 100.0 * rtol, "{method} at {rtol:e}, {set:?}: {error:e}");
        }
    }
}

const PLACES: [[f64; 2]; 4] = [[50.0, 1e-3], [50.0, 1e-5], [12.345, 1e-4], [99.0, 3e-3]];

#[test]
fn a_bell_is_seen_from_rest() {
    for bell in
        ["1 [N]*exp(-((t - centre)/width)^2)", "1 [N]*2/sqrt(pi)/(1 + ((t - centre)/width)^2)^2"]
    {
        let block = of_text(&text(bell), Keep::Needed);
        for set in PLACES {
            is_seen(&block, set, 0.1 * std::f64::consts::PI.sqrt());
        }
    }
}

#[test]
fn a_bell_multiplied_out_is_seen_as_well() {
    // The exponent is accurate only to the rounding of t^2 over the width squared.
    let bell = "1 [N]*exp(-(t^2 - 2*t*centre + centre^2)/width^2)";
    let block = of_text(&text(bell), Keep::Needed);
    for method in OWN {
        let run = run(&block, method, 1e-6, [50.0, 1e-3]);
        let [x, v] = ["block.x", "block.v"].map(|name| run.last(name).expect("a state"));
        let energy = v.powi(2) / 2.0 + x.powi(2) / 2.0 + x.powi(4) / 4.0;
        let expected = 0.005 * std::f64::consts::PI;
        assert!((energy - expected).abs() < 1e-3 * expected, "{method}: {energy}");
    }
}

#[test]
fn pulses_by_smooth_steps_are_seen_from_rest() {
    let up_and_down =
        "1 [N]*smooth_step((t - centre)/width)*(1 - smooth_step((t - centre)/width - 1))";
    let hat = "1 [N]*max(0, 1 - abs((t - centre)/width))";
    for pulse in [up_and_down, hat] {
        let block = of_text(&text(pulse), Keep::Needed);
        for set in PLACES {
            is_seen(&block, set, 0.1);
        }
    }
}

#[test]
fn a_pulse_in_a_table_is_seen_from_rest() {
    // Fine knots far to both sides prevent oscillations of the spline between coarse ones.
    let fine = (0..=80).map(|k| (f64::from(k) - 40.0, if k == 40 { 1.0 } else { 0.0 }));
    let mut rows = vec!["time [1],load [N]".to_owned(), "-1e5,0".to_owned()];
    rows.extend(fine.map(|(time, load)| format!("{time},{load}")));
    rows.push("1e5,0".to_owned());
    let scene = text(r#"table("pulse.csv", "load", (t - centre)/width)"#);
    let block = of_files(&[("scene.toml", &scene), ("pulse.csv", &rows.join("\n"))], Keep::Needed);
    // The integral of the cardinal natural spline over its knots is 1 except for what is cut off.
    for set in PLACES {
        is_seen(&block, set, 0.1);
    }
}

#[test]
fn a_pulse_in_every_turn_is_seen_from_rest() {
    // Bells about 1, 2, 3.. s, as those of a crank; no list of times contains all of them.
    let pulses = [
        "exp((cos(2*pi*(t - centre)/(1 [s])) - 1)/(2*pi*width/1 [s])^2*2)",
        "exp(-((mod(t - centre + 0.5 [s], 1 [s]) - 0.5 [s])/width)^2)",
    ];
    for pulse in pulses {
        let text = text(&format!("1 [N]*{pulse}"));
        // The block is free, so impulses add up.
        let text = text.replace("1 [N/m]*x^2/2 + 1 [N/m^3]*x^4/4", "0 [J]");
        let block = of_text(&text, Keep::Needed);
        for width in [1e-2, 1e-3, 1e-5] {
            let expected = 100.0 * 0.1 * std::f64::consts::PI.sqrt();
            for method in OWN {
                let v = run(&block, method, 1e-6, [0.3, width]).last("block.v").expect("a state");
                // The first one is a bell only to order width squared; each of the hundred errs by
                // one or two tolerances, by `radau` several.
                let error = (v / expected - 1.0).abs();
                let allowed = if method == Method::Radau { 1e-3 } else { 2e-4 };
                assert!(
                    error < allowed + 20.0 * width * width,
                    "{method}, {width:e}: {pulse}: {v}"
                );
            }
        }
    }
}

/// A torque for a moment of each turn, with known work, on an otherwise free rotor: all methods see
/// every pulse.
#[test]
fn a_pulse_in_every_turn_of_a_rotor_is_seen() {
    let text = r#"
        [scene]
        name = "rotor"
        [units.rotor]
        unit = "rotor"
        [initial]
        "rotor.phi_dot" = 6.283185307179586
        [run]
        until = 60.0
        points = 2
        [define.rotor.coordinates]
        phi = { unit = "rad" }
        x = { unit = "m" }
        [define.rotor.parameters]
        width = { value = 1e-2, unit = "rad" }
        torque = { value = 0.0, unit = "N m" }
        [define.rotor.helpers]
        pulse = { expression = "PULSE", unit = "1" }
        [define.rotor.energy]
        kinetic = "1 [kg m^2]*phi_dot^2/2 + 1 [kg]*x_dot^2/2"
        [[define.rotor.forces]]
        coordinate = "phi"
        expression = "torque*pulse"
        [[define.rotor.forces]]
        coordinate = "x"
        expression = "1 [N]*pulse/width"
    "#;
    // Integral of a pulse over a turn, to order width squared.
    let pulses = [
        ("exp((cos(phi - 2) - 1)/width^2)", TAU.sqrt()),
        ("1/(1 + (2*sin(phi/2 - 1)/width)^2)^2", PI / 2.0),
        ("exp(-((mod(phi - 2 + pi, 2*pi) - pi)/width)^2)", PI.sqrt()),
    ];
    for (pulse, area) in pulses {
        let rotor = of_text(&text.replace("PULSE", pulse), Keep::Needed);
        for (width, torque, method) in [3e-2, 3e-3, 1e-4]
            .into_iter()
            .flat_map(|width| [0.0, 0.5].map(|torque| (width, torque)))
            .flat_map(|(width, torque)| OWN.map(|method| (width, torque, method)))
        {
            let run = Simulation::new(&rotor).method(method).rtol(1e-6).max_steps(100_000);
            let run = run.parameter("rotor.width", width).expect("a parameter");
            let run = run.parameter("rotor.torque", torque / width).expect("a parameter");
            let run = run.run().unwrap_or_else(|error| panic!("{method}, {pulse}: {error}"));
            let [phi, speed, v] = ["rotor.phi", "rotor.phi_dot", "rotor.x_dot"]
                .map(|name| run.last(name).expect("a state"));
            let turns = ((phi - 2.0) / TAU).ceil();
            let what = format!("{method}, {width:e}, {torque}: {pulse}: {v} after {turns}");
            // Without a torque there are equal pulses at one speed; otherwise the speed contains
            // all work.
            let (found, expected) = if torque == 0.0 {
                (v, turns * area / TAU)
            } else {
                (speed * speed - TAU * TAU, 2.0 * turns * torque * area)
            };
            let error = (found / expected - 1.0).abs();
            assert!(error < 2e-3 + width * width, "{what}: {error:e}");
        }
    }
}

/// Returns the speed of a mass of 1 kg with a damper of 1 N s/m under a force of 1 N that changes
/// its sign.
fn chopped(rate: f64, duty: f64, until: f64) -> f64 {
    let mut ends: Vec<f64> = (0..=(rate * until) as usize + 1)
        .flat_map(|k| [k as f64 / rate, (k as f64 + duty) / rate])
        .collect();
    ends.retain(|end| *end < until);
    ends.push(until);
    let pairs = ends.windows(2).enumerate();
    pairs.fold(0.0, |v, (k, ends)| {
        let force = if k % 2 == 0 { 1.0 } else { -1.0 };
        force + (v - force) * (ends[0] - ends[1]).exp()
    })
}

/// Returns a block with a damper under a force that changes its sign as a sawtooth crosses a level.
fn compared_with_a_sawtooth() -> ModelSimulator {
    let text = text("0 [N]")
        .replace("1 [N/m]*x^2/2 + 1 [N/m^3]*x^4/4", "0 [J]")
        .replace("unit = \"s\" }\n        width", "unit = \"Hz\" }\n        width")
        .replace("value = 1e-3, unit = \"s\"", "value = 0.3, unit = \"1\"")
        .replace(
            "100*(0 [N])*1 [s]/width/1e3",
            "piecewise(mod(centre*t, 1) < width, 1 [N], -1 [N]) - 1 [N*s/m]*v",
        )
        .replace("until = 100.0", "until = 0.2");
    of_text(&text, Keep::Needed)
}

#[test]
fn what_is_compared_with_a_sawtooth_switches_at_both_of_its_ends() {
    let block = compared_with_a_sawtooth();
    // Runs that end with a period and others; periods that begin with the run, and the opposite.
    for rate in [25.0, 77.0, 100.0, 125.0, 400.0, 1e3, -100.0] {
        for method in OWN {
            let v = run(&block, method, 1e-8, [rate, 0.3]).last("block.v").expect("a state");
            let expected =
                if rate > 0.0 { chopped(rate, 0.3, 0.2) } else { -chopped(-rate, 0.7, 0.2) };
            assert!((v - expected).abs() < 1e-6, "{method}, {rate}: {v} for {expected}");
        }
    }
}

/// The compared value does not move the switching time at which the sawtooth jumps, but its own
/// rate does.
#[test]
fn derivatives_go_through_both_ends_of_a_sawtooth() {
    let block = compared_with_a_sawtooth();
    for (rate, duty) in [(77.0, 0.3), (412.0, 0.9)] {
        let step = 1e-5;
        let by_rate = (chopped(rate + step, duty, 0.2) - chopped(rate - step, duty, 0.2)) / step;
        let by_duty = (chopped(rate, duty + step, 0.2) - chopped(rate, duty - step, 0.2)) / step;
        for method in [Method::Dop853, Method::Tsit5, Method::Radau, Method::Auto] {
            let run = Simulation::new(&block).method(method).rtol(1e-9);
            let run = run.parameter("block.centre", rate).expect("a parameter");
            let run = run.parameter("block.width", duty).expect("a parameter");
            let run = run.sensitivities(&["block.centre", "block.width"]).expect("parameters");
            let run = run.run().unwrap_or_else(|error| panic!("{method}: {error}"));
            for (by, twice) in [("block.centre", by_rate), ("block.width", by_duty)] {
                let found = run.sensitivity("block.v", by).expect("a column");
                let found = *found.last().expect("rows");
                let error = (found - 0.5 * twice).abs();
                assert!(error < 1e-6, "{method}, {rate}, by {by}: {found} for {}", 0.5 * twice);
            }
        }
    }
}
