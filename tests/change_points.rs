//! Loops that pass positions in which their constraints lose rank.

use std::f64::consts::PI;

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::common::column;
use crate::own_scene::{of_specs, of_text};

/// Methods for constrained machines, with tolerances.
const RUNS: [(Method, f64); 8] = [
    (Method::Auto, 1e-5),
    (Method::Auto, 1e-8),
    (Method::Auto, 1e-11),
    (Method::Dop853, 1e-7),
    (Method::Dop853, 1e-10),
    (Method::Tsit5, 1e-6),
    (Method::Radau, 1e-9),
    (Method::Rodas5p, 1e-7),
];

/// A crank and a rocker of equal length, and a coupler as long as the base.
fn parallelogram(damping: f64) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "parallelogram"
        [units.p]
        unit = "parallelogram"
        [outputs]
        a = "p.a"
        b = "p.b"
        c = "p.c"
        [initial]
        "p.a" = 1
        "p.a_dot" = 2
        [guess]
        "p.c" = 1
        [run]
        until = 20
        points = 201
        rtol = 1e-9
        method = "auto"
        [define.parallelogram.coordinates]
        a = {{ unit = "rad" }}
        b = {{ unit = "rad" }}
        c = {{ unit = "rad" }}
        [define.parallelogram.parameters]
        l = {{ value = 0.3, unit = "m" }}
        d = {{ value = 0.8, unit = "m" }}
        m = {{ value = 1.5, unit = "kg" }}
        k = {{ value = {damping}, unit = "N m s/rad" }}
        [define.parallelogram.energy]
        kinetic = "m*l^2/6*(a_dot^2 + c_dot^2) + m/2*(l^2*a_dot^2 + d^2*b_dot^2/3 + l*d*a_dot*b_dot*cos(a - b))"
        dissipation = "k*a_dot^2/2"
        [define.parallelogram.constraints]
        x = {{ expression = "l*cos(a) + d*cos(b) - l*cos(c) - d" }}
        y = {{ expression = "l*sin(a) + d*sin(b) - l*sin(c)" }}
        "#
    );
    of_text(&text, Keep::All)
}

/// The same links crossed, with a spring of `stiffness` at the crank, which starts at an angle with a
/// speed.
fn crossed(stiffness: f64, [angle, speed]: [f64; 2], until: f64) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "crossed"
        [units.p]
        unit = "crossed"
        [outputs]
        a = "p.a"
        c = "p.c"
        a_dot = "p.a_dot"
        [initial]
        "p.a" = {angle:?}
        "p.a_dot" = {speed:?}
        [guess]
        "p.b" = -0.75
        "p.c" = -1.75
        [run]
        until = {until:?}
        points = 1001
        rtol = 1e-9
        method = "auto"
        [define.crossed.coordinates]
        a = {{ unit = "rad" }}
        b = {{ unit = "rad" }}
        c = {{ unit = "rad" }}
        [define.crossed.parameters]
        l = {{ value = {L}, unit = "m" }}
        d = {{ value = {D}, unit = "m" }}
        m = {{ value = {M}, unit = "kg" }}
        k = {{ value = {stiffness:?}, unit = "N m/rad" }}
        [define.crossed.energy]
        kinetic = "m*l^2/6*(a_dot^2 + c_dot^2) + m/2*(l^2*a_dot^2 + d^2*b_dot^2/3 + l*d*a_dot*b_dot*cos(a - b))"
        potential = "k*(a - {MIDDLE} [rad])^2/2"
        [define.crossed.constraints]
        x = {{ expression = "l*cos(a) + d*cos(b) - l*cos(c) - d" }}
        y = {{ expression = "l*sin(a) + d*sin(b) - l*sin(c)" }}
        "#
    );
    of_text(&text, Keep::All)
}

const L: f64 = 0.3;
const D: f64 = 0.8;
const M: f64 = 1.5;
/// Angle at which the spring is free \[rad\].
const MIDDLE: f64 = 1.6;

/// Returns the inertia of crossed links as felt by the crank, by tan(c/2) = -(d + l)/(d - l) tan(a/2).
fn crossed_inertia(a: f64) -> f64 {
    let ratio = -(D + L) / (D - L);
    let tangent = (a / 2.0).tan();
    let c = 2.0 * (ratio * tangent).atan();
    let of_c = ratio * (1.0 + tangent * tangent) / (1.0 + (ratio * tangent).powi(2));
    let b = (L * (c.sin() - a.sin())).atan2(D + L * (c.cos() - a.cos()));
    let of_b = L * (c.cos() * of_c - a.cos()) / (D * b.cos());
    let cranks = M * L * L / 3.0 * (1.0 + of_c * of_c);
    cranks + M * (L * L + D * D * of_b * of_b / 3.0 + L * D * of_b * (a - b).cos())
}

/// Checks that links are crossed as in the closed form: the angles of the cranks, and an ellipse about the
/// ends of the crank with the length of the coupler, on which the coupler crosses the base.
fn require_crossed(run: &Trajectory, name: &str) {
    for (a, c) in column(run, "a").iter().zip(column(run, "c")) {
        let sum = (D - L) * (c / 2.0).sin() * (a / 2.0).cos()
            + (D + L) * (a / 2.0).sin() * (c / 2.0).cos();
        assert!(sum.abs() < 1e-11, "{name}: the cranks are off by {sum:e} at {a}");
        let [[x, y], [far_x, far_y]] = [[L * a.cos(), L * a.sin()], [D + L * c.cos(), L * c.sin()]];
        // In line with the base, they cross nowhere.
        if y.abs() > 0.1 * L {
            let crossing = x - y * (far_x - x) / (far_y - y);
            let off = crossing.abs() + (crossing - x).hypot(y) - D;
            assert!(off.abs() < 1e-10, "{name}: the crossing is off its ellipse by {off:e} at {a}");
        }
    }
}

fn run(machine: &ModelSimulator, method: Method, rtol: f64) -> Trajectory {
    let run = Simulation::new(machine).method(method).rtol(rtol).run();
    run.unwrap_or_else(|error| panic!("{method:?} at {rtol:e}: {error}"))
}

/// Returns the largest distance of two columns.
fn off(one: &[f64], other: impl Fn(usize) -> f64) -> f64 {
    one.iter().enumerate().map(|(row, value)| (value - other(row)).abs()).fold(0.0, f64::max)
}

/// Without gravity it turns steadily; with damping its rate decays, as all of it turns with the
/// inertia 5/3 m l^2.
#[test]
fn a_parallelogram_turns_on_through_positions_in_line() {
    let [steady, damped] = [0.0, 0.01].map(parallelogram);
    let rate = 0.01 / (5.0 / 3.0 * 1.5 * 0.09);
    for (method, rtol) in RUNS {
        for machine in [&steady, &damped] {
            let run = run(machine, method, rtol);
            let turned = |row: usize| {
                let time = 0.1 * row as f64;
                let is_steady = std::ptr::eq(machine, &raw const steady);
                1.0 + if is_steady { 2.0 * time } else { 2.0 * -(-rate * time).exp_m1() / rate }
            };
            let allowed = 1e3 * rtol;
            for name in ["a", "c"] {
                let off = off(column(&run, name), turned);
                assert!(off < allowed, "{method:?} at {rtol:e}: {name} is off by {off:e}");
            }
            let off = off(column(&run, "b"), |_| 0.0);
            assert!(off < allowed, "{method:?} at {rtol:e}: b is off by {off:e}");
        }
    }
}

/// Rods of one length and mass turn as one angle from upright: 3 phi'' = (7/2) g sin(phi), here
/// by the classical method of Runge and Kutta.
#[test]
fn windows_of_four_bars_pass_their_positions_in_line() {
    const STEPS: usize = 2000;
    let bars = of_specs("iftomm/four_bars", Keep::All);
    let run = Simulation::new(&bars).run().expect("a run");
    let step = 0.1 / STEPS as f64;
    let rate = |[phi, speed]: [f64; 2]| [speed, 3.5 / 3.0 * 9.81 * phi.sin()];
    let mut state: [f64; 2] = [0.0, 1.0];
    let (x, y) = (column(&run, "x"), column(&run, "y"));
    for (row, (x, y)) in x.iter().zip(y).enumerate() {
        let off = (x - state[0].sin()).hypot(y - state[0].cos());
        assert!(off < 1e-8, "row {row}: off by {off:e}");
        for _ in 0..STEPS {
            let add = |by: f64, rate: [f64; 2]| [state[0] + by * rate[0], state[1] + by * rate[1]];
            let one = rate(state);
            let two = rate(add(0.5 * step, one));
            let three = rate(add(0.5 * step, two));
            let four = rate(add(step, three));
            state = std::array::from_fn(|i| {
                state[i] + step / 6.0 * (one[i] + 2.0 * (two[i] + three[i]) + four[i])
            });
        }
    }
}

/// From positions in line several motions begin, and a start solved from a guess finds them to half the
/// digits. Beside them the start is not a corner.
#[test]
fn a_start_in_line_is_refused_and_one_beside_it_runs() {
    let machine = parallelogram(0.0);
    let given = |a: f64| {
        let run = Simulation::new(&machine).initial_state(&[a, 0.0, a, 2.0, 0.0, 2.0]);
        run.until(0.4).points(2).run()
    };
    let guessed = |a: f64| Simulation::new(&machine).initial_value("p.a", a)?.until(0.4).run();
    for found in [given(0.0), given(PI), guessed(0.0)] {
        let error = found.expect_err("a change point").to_string();
        assert!(error.contains("the start is a change point"), "{error}");
    }
    for a in [1e-3, 1e-2, -1e-2, 0.1, PI + 1e-2] {
        let run = given(a).unwrap_or_else(|error| panic!("{a}: {error}"));
        assert!((column(&run, "c")[1] - a - 0.8).abs() < 1e-6, "{a}: {:?}", column(&run, "c"));
        assert!(!run.notes.iter().any(|note| note.contains("corner")), "{a}: {:?}", run.notes);
    }
}

/// Crossed links swing for 500 periods between 1 rad and 2.2 rad, away from positions in line: by the
/// quadrature of time over the angle a = 1.6 - 0.6 cos(s), dt = sqrt(I/k) ds.
#[test]
fn crossed_links_swing_as_by_quadrature() {
    const STIFFNESS: f64 = 5.0;
    const SHARES: usize = 200;
    let rate = |s: f64| (crossed_inertia(MIDDLE - 0.6 * s.cos()) / STIFFNESS).sqrt();
    let time = |until: f64| -> f64 {
        let step = until / SHARES as f64;
        // Simpson's rule.
        let share = |index: usize| {
            let s = index as f64 * step;
            step / 6.0 * (rate(s) + 4.0 * rate(s + step / 2.0) + rate(s + step))
        };
        (0..SHARES).map(share).sum()
    };
    let until = 1000.0 * time(std::f64::consts::PI) + time(std::f64::consts::FRAC_PI_2);
    let machine = crossed(STIFFNESS, [1.0, 0.0], until);
    for (method, rtol) in [(Method::Auto, 1e-10), (Method::Dop853, 1e-11), (Method::Radau, 1e-10)] {
        let run = run(&machine, method, rtol);
        let name = format!("{method:?}");
        require_crossed(&run, &name);
        let last = |column: &[f64]| *column.last().expect("rows");
        let (angle, speed) = (last(column(&run, "a")), last(column(&run, "a_dot")));
        let exact = 0.6 * (STIFFNESS / crossed_inertia(MIDDLE)).sqrt();
        assert!((angle - MIDDLE).abs() < 1e-5, "{name}: {angle} at the end");
        assert!((speed - exact).abs() < 1e-5, "{name}: {speed} instead of {exact} at the end");
    }
}

/// Crossed links turn through positions in line, where they might open.
#[test]
fn crossed_links_stay_crossed_through_positions_in_line() {
    let machine = crossed(0.0, [1.0, 2.0], 20.0);
    let energy = |a: f64, speed: f64| crossed_inertia(a) * speed * speed / 2.0;
    for rtol in [1e-5, 1e-7, 1e-9, 1e-11] {
        let run = run(&machine, Method::Radau, rtol);
        require_crossed(&run, &format!("{rtol:e}"));
        let angles = column(&run, "a");
        let rows = angles.iter().zip(column(&run, "a_dot"));
        for (a, speed) in rows.filter(|(a, _)| a.sin().abs() > 0.05) {
            let lost = energy(*a, *speed) / energy(1.0, 2.0) - 1.0;
            assert!(lost.abs() < 1e3 * rtol + 1e-9, "{rtol:e}: energy is off by {lost:e} at {a}");
        }
        let turned = angles.last().expect("rows");
        assert!(*turned > 7.0 * std::f64::consts::TAU, "{rtol:e}: {turned}");
    }
}
