//! Guards that jump, that oscillate many times within a step, and windows of a sawtooth that are
//! narrower than evaluations are apart: each zero crossing is counted once, by every method.

use std::f64::consts::PI;

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

const OWN: [Method; 6] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Taylor, Method::Auto];

/// x = sin(t), from a start with x' = 1.
const OSCILLATOR: &str = r#"
        [define.part.coordinates.x]
        unit = "1"
        [define.part.energy]
        kinetic = "0.5 [kg m^2]*x_dot^2"
        potential = "0.5 [N m]*x^2"
"#;

/// x = sin(t), or a shaft, with more of the unit.
fn scene(unit: &str, initial: &str) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "guards"
        [units.p]
        unit = "part"
        [initial]
        {initial}
        [run]
        until = 20
        points = 41
        {unit}
        "#
    );
    of_text(&text, Keep::Needed)
}

fn swing(guard: &str, direction: &str) -> ModelSimulator {
    let unit = format!(
        r#"
        {OSCILLATOR}
        [define.part.states.n]
        unit = "1"
        rate = "0 [1/s]"
        [define.part.events.counts]
        guard = "{guard}"
        direction = "{direction}"
        set = {{ n = "n + 1" }}
        "#
    );
    scene(&unit, "\"p.x_dot\" = 1")
}

fn run(machine: &ModelSimulator, method: Method, rtol: f64) -> Trajectory {
    let run = Simulation::new(machine).method(method).rtol(rtol).run();
    run.unwrap_or_else(|error| panic!("{method} at {rtol:e}: {error}"))
}

fn last(run: &Trajectory, name: &str) -> f64 {
    *run.column(name).and_then(|values| values.last()).expect("a column")
}

fn counts(machine: &ModelSimulator, rtols: &[f64], expected: u64, what: &str) {
    for method in OWN {
        for rtol in rtols {
            let run = run(machine, method, *rtol);
            assert_eq!(run.work.switches, expected, "{what}: {method} at {rtol:e}");
            assert!((last(&run, "p.n") - expected as f64).abs() < 1e-9, "{what}: {method}");
        }
    }
}

#[test]
fn a_guard_that_jumps_passes_each_time_it_jumps() {
    // sin(t) rises through 0.5 four times in 20 s, and falls three times.
    let rtols = [1e-4, 1e-6, 1e-8];
    counts(&swing("sign(x - 0.5)", "rising"), &rtols, 4, "a sign");
    counts(&swing("sign(x - 0.5)", "both"), &rtols, 7, "a sign, both ways");
    counts(&swing("piecewise(x < 0.5, -1, 1)", "falling"), &rtols, 3, "a comparison");
    counts(&swing("tanh((x - 0.5)*1e6)", "rising"), &rtols, 4, "a steep one");
    // It falls below three quarters three times.
    counts(&swing("x - mod(x, 0.25) - 0.6", "falling"), &rtols, 3, "a count of quarters");
    let timed = swing("piecewise(t < 10 [s], -1, t < 12 [s], 1, t < 14 [s], -1, 1)", "rising");
    counts(&timed, &rtols, 2, "a guard of time");
}

#[test]
fn a_guard_that_jumps_from_zero_leaves_it_there() {
    // sin(t) rises through 0.5, and through 1/1.9, four times in 20 s.
    for (guard, direction) in [
        ("piecewise(x < 0.5, 0, 1)", "rising"),
        ("piecewise(x < 0.5, 0, -1)", "falling"),
        ("piecewise(x < 0.5, 0, x)", "rising"),
        ("floor(1.9*max(x, 0))", "rising"),
    ] {
        counts(&swing(guard, direction), &[1e-4, 1e-6, 1e-9], 4, guard);
    }
}

#[test]
fn the_wrap_of_a_sawtooth_ticks_once_each_time() {
    let ticks = swing("mod(t, 0.7 [s]) - 0.35 [s]", "falling");
    // From 0.7 s to 19.6 s.
    counts(&ticks, &[1e-4, 1e-7], 28, "a clock");
}

#[test]
fn no_passing_of_a_fast_guard_is_stepped_over() {
    // sin(300 t) rises through 0.9 once a turn, 954 times and once more.
    let expected = ((300.0 * 20.0 - f64::asin(0.9)) / (2.0 * PI)).floor() as u64 + 1;
    counts(&swing("sin(300 [1/s]*t) - 0.9", "rising"), &[1e-4, 1e-9], expected, "of time");
    // A shaft that is driven evenly: phi = t^2/2, seen by 50 lines.
    let unit = r#"
        [define.part.coordinates.phi]
        unit = "rad"
        velocity = "w"
        [define.part.energy]
        kinetic = "0.5 [kg m^2]*w^2"
        [[define.part.forces]]
        coordinate = "phi"
        expression = "0.2 [N m]"
        [define.part.states.n]
        unit = "1"
        rate = "0 [1/s]"
        [define.part.events.counts]
        guard = "sin(50*phi) - 0.5"
        direction = "rising"
        set = { n = "n + 1" }
    "#;
    // phi = 0.1 t^2 = 40 rad at the end.
    let expected = ((50.0 * 40.0 - PI / 6.0) / (2.0 * PI)).floor() as u64 + 1;
    counts(&scene(unit, ""), &[1e-4, 1e-6, 1e-9], expected, "an encoder");
}

/// On for a hundredth and a thousandth of each turn: the share of the time.
#[test]
fn narrow_windows_of_a_sawtooth_are_not_stepped_over() {
    for share in [1e-2, 1e-3] {
        let unit = format!(
            r#"
            [define.part.coordinates.phi]
            unit = "rad"
            velocity = "w"
            [define.part.energy]
            kinetic = "0.01 [kg m^2]*w^2/2"
            [define.part.states.on]
            unit = "s"
            rate = "piecewise(mod(2*phi, 1) < {}, 0, 1)"
            "#,
            1.0 - share
        );
        let shaft = scene(&unit, "\"p.w\" = 10");
        for method in OWN {
            for rtol in [1e-6, 1e-9] {
                let on = last(&run(&shaft, method, rtol), "p.on");
                // 400 turns, each with two restarts of one or two tolerances.
                let off = (on - 20.0 * share).abs();
                assert!(off < 1500.0 * rtol + 1e-8, "{method} at {rtol:e}, {share}: {on}");
            }
        }
    }
}

/// The duty cycle follows the current: the comparison crosses once per period, faster for it, and
/// does not chatter.
#[test]
fn pulses_whose_width_follows_what_they_drive_do_not_chatter() {
    let text = r#"
        [scene]
        name = "pwm"
        [units.l]
        unit = "coil"
        [run]
        until = 0.3
        points = 2
        [define.coil.parameters]
        period = { value = 1e-3, unit = "s" }
        [define.coil.helpers.duty]
        expression = "max(min(0.04 [1/A]*(20 [A] - i), 0.95), 0.05)"
        unit = "1"
        [define.coil.states.i]
        unit = "A"
        rate = "(piecewise(mod(t, period) < duty*period, 48 [V], 0 [V]) - 0.5 [ohm]*i)/(1e-3 [H])"
    "#;
    let coil = of_text(text, Keep::Needed);
    let exact = by_periods(300);
    for method in OWN {
        for rtol in [1e-5, 1e-8] {
            let found = last(&run(&coil, method, rtol), "l.i");
            // Each period errs by about a tolerance of 20 A, and forgets those before.
            assert!(
                (found - exact).abs() < 1e3 * rtol,
                "{method} at {rtol:e}: {found}, not {exact}"
            );
        }
    }
}

/// Period by period in closed form: on until mod(t, T) = duty(i) T, by bisection, then off.
fn by_periods(periods: usize) -> f64 {
    const T: f64 = 1e-3;
    let after = |i: f64, volts: f64, time: f64| {
        let rest = volts / 0.5;
        rest + (i - rest) * f64::exp(-500.0 * time)
    };
    let duty = |i: f64| (0.04 * (20.0 - i)).clamp(0.05, 0.95);
    let mut i = 0.0;
    for _ in 0..periods {
        let (mut low, mut high) = (0.0, T);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if middle < duty(after(i, 48.0, middle)) * T { low = middle } else { high = middle }
        }
        i = after(after(i, 48.0, low), 0.0, T - low);
    }
    i
}

/// The pulses of a force end steps where the guard is zero, but for rounding: it crosses there once,
/// and not again at the start of the next step.
#[test]
fn samples_in_phase_with_a_pulsed_force_happen_once_each() {
    for sines in [23, 40] {
        let unit = format!(
            r#"
            [define.part.coordinates.x]
            unit = "1"
            [define.part.energy]
            kinetic = "0.5 [kg m^2]*x_dot^2"
            potential = "10 [N m]*x^2"
            [define.part.modes.n]
            [define.part.events.samples]
            guard = "sin({sines}*pi*1 [1/s]*t)"
            direction = "rising"
            set = {{ n = "n + 1" }}
            [[define.part.forces]]
            coordinate = "x"
            expression = "0.1 [N m]*n + 1 [N m]*piecewise({sines}*t < 1 [s], 1, {sines}*t < 5 [s], 2, {sines}*t < 9 [s], 1, {sines}*t < 11 [s], 2, {sines}*t < 15 [s], 4, 0)"
            "#
        );
        let machine = scene(&unit, "\"p.x\" = 1");
        let count = (1.5 * f64::from(sines)).ceil();
        for method in OWN {
            let run = Simulation::new(&machine).method(method).rtol(1e-6).until(3.0).run();
            let run = run.unwrap_or_else(|error| panic!("{method}, {sines}: {error}"));
            let found = last(&run, "p.n");
            assert!((found - count).abs() < 0.5, "{method}, {sines}: {found} and not {count}");
        }
    }
}

/// x = sin(t): guards whose rate is zero with them cross where they change their sign, and one that
/// only touches zero leaves it once, at the start.
#[test]
fn guards_that_are_zero_with_their_rate_happen_once_where_they_change_sign() {
    for (guard, direction, count) in [
        ("x^3", "rising", 4.0),
        ("x^3", "falling", 3.0),
        ("x*abs(x)", "rising", 4.0),
        ("x*abs(x)", "falling", 3.0),
        ("x*abs(x)", "both", 6.0),
        ("x^3", "both", 6.0),
        ("x^5", "rising", 4.0),
        ("x^2", "rising", 1.0),
        ("x^2", "falling", 0.0),
        ("x^2", "both", 0.0),
    ] {
        let unit = format!(
            r#"
            {OSCILLATOR}
            [define.part.states.y]
            unit = "1"
            rate = "1e-9 [1/s]*n"
            [define.part.modes.n]
            [define.part.events.counts]
            guard = "{guard}"
            direction = "{direction}"
            set = {{ n = "n + 1" }}
            "#
        );
        let machine = scene(&unit, "\"p.x_dot\" = 1");
        for method in OWN {
            for rtol in [1e-4, 1e-6, 1e-9] {
                let found = last(&run(&machine, method, rtol), "p.n");
                let what = format!("{method} at {rtol:e}: {guard}, {direction}");
                assert!((found - count).abs() < 0.5, "{what}: {found} and not {count}");
            }
        }
    }
}

/// The line of an encoder and an event that the motion reads, both at the time of a sample: it shows
/// the state before them.
#[test]
fn samples_at_the_time_of_an_event_show_the_state_before_it() {
    let unit = format!(
        r#"
        {OSCILLATOR}
        [define.part.states]
        counted = {{ unit = "1", rate = "0 [1/s]" }}
        read = {{ unit = "1", rate = "0 [1/s]" }}
        [define.part.events.counts]
        guard = "t - 2 [s]"
        set = {{ counted = "counted + 1" }}
        [define.part.events.acts]
        guard = "t - 4 [s]"
        set = {{ read = "read + 1" }}
        [[define.part.forces]]
        coordinate = "x"
        expression = "0.1 [N m]*read"
        "#
    );
    let machine = scene(&unit, "\"p.x_dot\" = 1");
    for method in OWN {
        let run = Simulation::new(&machine).method(method).rtol(1e-6).until(6.0).points(4).run();
        let run = run.unwrap_or_else(|error| panic!("{method}: {error}"));
        assert_eq!(run.column("p.counted"), Some(&[0.0, 0.0, 1.0, 1.0][..]), "{method}");
        assert_eq!(run.column("p.read"), Some(&[0.0, 0.0, 0.0, 1.0][..]), "{method}");
    }
}

/// Guards that reach zero at a corner trigger alike whether time or a state takes them there, and
/// whether the motion reads the event or not.
#[test]
fn guards_with_a_corner_at_zero_happen_alike_by_time_and_by_a_state() {
    for (guard, rising, falling) in [
        ("max(3 - u, 0)", 0.0, 1.0),
        ("min(u - 3, 0)", 1.0, 0.0),
        ("max(u - 3, 0)", 1.0, 0.0),
        ("abs(u - 3)", 1.0, 1.0),
        ("-abs(u - 3)", 1.0, 1.0),
        ("u - 3", 1.0, 0.0),
    ] {
        for (direction, count) in [("rising", rising), ("falling", falling)] {
            for (by, read) in [("t/1 [s]", 1), ("z", 1), ("t/1 [s]", 0), ("z", 0)] {
                let unit = format!(
                    r#"
                    {OSCILLATOR}
                    [define.part.states]
                    z = {{ unit = "1", rate = "1 [1/s]" }}
                    n = {{ unit = "1", rate = "0 [1/s]" }}
                    [define.part.events.e]
                    guard = "{}"
                    direction = "{direction}"
                    set = {{ n = "n + 1" }}
                    [[define.part.forces]]
                    coordinate = "x"
                    expression = "{read} [N m]*n"
                    "#,
                    guard.replace('u', by)
                );
                let machine = scene(&unit, "\"p.x_dot\" = 1");
                for method in OWN {
                    let found = last(&run(&machine, method, 1e-6), "p.n");
                    let what = format!("{method}: {guard}, {direction}, by {by}, {read}");
                    assert!((found - count).abs() < 0.5, "{what}: {found} and not {count}");
                }
            }
        }
    }
}
