//! Controllers with events and limits, against their closed forms.

use machinist::Method;
use machinist_codegen::mechanics::reduce::Keep;
use nalgebra::{Matrix5, Vector5};

use super::{column, example, off, run};
use crate::own_scene::of_text;

const LOOP: &str = r#"
[scene]
name = "closed_loop"
[units.controller]
unit = "control/pid_controller"
parameters = { least = -1e12, greatest = 1e12 }
inputs = { reference = "1", measured = "body.x/1 [m]" }
[units.body]
unit = "translational/mass"
[units.actuator]
unit = "sources/force"
inputs = { force = "controller.output*1 [N]" }
[[joints]]
connect = ["actuator.a", "body.a"]
[outputs]
place = "body.x"
[run]
until = 2.0
points = 41
rtol = 1e-10
method = "auto"
"#;

/// x'' = u of the five linear equations, by the exponential of their matrix.
#[test]
fn a_loop_of_a_mass_and_a_pid_controller_moves_by_its_matrix() {
    let scene = of_text(LOOP, Keep::Needed);
    for (gain, integral, derivative, filter, weight) in [
        (40.0, 1.0, 0.3, 0.01, 1.0),
        (10.0, 5.0, 0.5, 0.1, 0.0),
        (1e3, 0.5, 0.05, 1e-3, 0.5),
        (0.5, 1e3, 3.0, 0.5, 2.0),
    ] {
        let set = [
            ("controller.gain", gain),
            ("controller.integral_time", integral),
            ("controller.derivative_time", derivative),
            ("controller.filter_time", filter),
            ("controller.weight", weight),
        ];
        let run = run(&scene, &set, &[]);
        let of_filter = gain * derivative / filter;
        // x, v, integral, filtered, 1.
        #[rustfmt::skip]
        let matrix = Matrix5::new(
            0.0, 1.0, 0.0, 0.0, 0.0,
            -gain - of_filter, 0.0, 1.0, of_filter, gain * weight,
            -gain / integral, 0.0, 0.0, 0.0, gain / integral,
            1.0 / filter, 0.0, 0.0, -1.0 / filter, 0.0,
            0.0, 0.0, 0.0, 0.0, 0.0,
        );
        let start = Vector5::new(0.0, 0.0, 0.0, 0.0, 1.0);
        let error = off(&run, "place", |t| ((matrix * t).exp() * start)[0]);
        assert!(error < 1e-7, "{set:?}: {error:e}");
    }
}

/// Asserts the integral of a controller whose error of 1 requires more than its limit.
fn assert_integral_is_led_back(unit: &str, inputs: &str) {
    let text = format!(
        r#"
[scene]
name = "at_its_limit"
[units.controller]
unit = "{unit}"
inputs = {{ {inputs} }}
[outputs]
output = "controller.output"
integral = "controller.integral"
[run]
until = 10.0
points = 101
rtol = 1e-10
method = "auto"
"#
    );
    let scene = of_text(&text, Keep::Needed);
    for (gain, integral, tracking) in [(2.0, 0.5, 0.1), (5.0, 10.0, 1.0), (1.5, 0.1, 3.0)] {
        let set = [
            ("controller.gain", gain),
            ("controller.integral_time", integral),
            ("controller.tracking_time", tracking),
        ];
        let run = run(&scene, &set, &[]);
        let end = tracking * gain / integral + 1.0 - gain;
        let error = off(&run, "integral", |t| -end * (-t / tracking).exp_m1());
        assert!(error < 1e-7, "{unit} {set:?}: {error:e}");
        assert!(off(&run, "output", |_| 1.0) < 1e-12);
    }
}

#[test]
fn the_integral_of_a_pi_controller_at_its_limit_is_led_back() {
    assert_integral_is_led_back("control/pi_controller", "error = \"1\"");
}

#[test]
fn the_integral_of_a_pid_controller_at_its_limit_is_led_back() {
    let inputs = "reference = \"1\", measured = \"0\"";
    assert_integral_is_led_back("control/pid_controller", inputs);
}

/// A ramp, and a lag from where what is missing is the rate times its time constant.
#[test]
fn a_rate_limiter_rises_along_a_ramp_and_arrives_as_a_lag() {
    let scene = example("control/rate_limiter", Keep::Needed);
    for time in [1e-4, 0.01, 0.1] {
        for (rise, fall) in [(2.0, 5.0), (30.0, 2.5), (1.5, 100.0)] {
            let set = [("ramp.time_constant", time), ("ramp.rise", rise), ("ramp.fall", fall)];
            let run = run(&scene, &set, &[]);
            let follow = |t: f64, from: f64, to: f64, rate: f64| {
                let missing: f64 = (to - from).abs();
                let bends = ((missing - rate * time) / rate).max(0.0);
                let way = if t < bends {
                    rate * t
                } else {
                    missing - (missing - rate * bends) * (-(t - bends) / time).exp()
                };
                from + (to - from).signum() * way
            };
            let risen = follow(0.9, 0.0, 1.0, rise);
            let exact = |t: f64| {
                if t < 0.1 {
                    0.0
                } else if t < 1.0 {
                    follow(t - 0.1, 0.0, 1.0, rise)
                } else {
                    follow(t - 1.0, risen, 0.0, fall)
                }
            };
            let error = off(&run, "reference", exact);
            assert!(error < 1e-7, "{set:?}: {error:e}");
        }
    }
}

/// Switching times of a lag towards 30 or 0 between 19.5 and 20.5, from logarithms.
#[test]
fn a_relay_on_a_lag_switches_in_its_period() {
    let scene = example("control/relay", Keep::Needed);
    let methods = [Method::Dop853, Method::Tsit5, Method::Radau, Method::Rodas5p, Method::Auto];
    for (number, band) in [0.01f64, 0.5, 5.0].into_iter().enumerate() {
        for time in [0.5f64, 10.0, 300.0] {
            let period =
                time * ((10.0 + band) / (10.0 - band) * (20.0 + band) / (20.0 - band)).ln();
            let first = time * (30.0 / (10.0 - band)).ln();
            let method = methods[(number + time as usize) % methods.len()];
            let run = machinist::Simulation::new(&scene)
                .parameter("relay.lower", -band)
                .and_then(|run| run.parameter("relay.upper", band))
                .and_then(|run| run.parameter("room.time_constant", time))
                .expect("parameters")
                .method(method)
                .rtol(1e-10)
                .until(first + 5.25 * period)
                .run()
                .unwrap_or_else(|error| panic!("{band}, {time}, {method}: {error}"));
            let off = run.switches.iter().filter(|s| s.event == "relay.switches_off");
            let off: Vec<f64> = off.map(|switch| switch.time).collect();
            assert_eq!(off.len(), 6, "{band}, {time}, {method}");
            for (k, found) in off.iter().enumerate() {
                let exact = first + k as f64 * period;
                assert!((found - exact).abs() < 1e-7 * exact, "{band}, {time}: {found}, {exact}");
            }
            let warm = run.times.iter().zip(column(&run, "temperature"));
            let beyond = warm.filter(|(t, _)| **t > first).map(|(_, w)| (w - 20.0).abs());
            assert!(beyond.fold(0.0, f64::max) < band * (1.0 + 1e-6), "{band}, {time}");
        }
    }
}
