//! Prescribed speeds that jump: the impulse is that of the constraint forces, its work is supplied,
//! and every method obtains it at every tolerance.

use machinist::hosted::{Beginning, Hosted, Reached};
use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

const KEEPING: [Method; 5] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Auto];

const GRAVITY: f64 = 9.81;
const LENGTH: f64 = 1.5;

/// Returns a pendulum on a cart with a prescribed speed.
fn trolley(speed: &str) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "trolley"
        [parameters]
        size = {{ value = 0.8, unit = "m/s" }}
        begins = {{ value = 0.77, unit = "s" }}
        share = {{ value = 0.3, unit = "1" }}
        [units]
        cart = {{ unit = "sources/linear_speed", inputs = {{ speed = "{speed}" }} }}
        hangs = {{ unit = "hangs" }}
        [[joints]]
        connect = ["cart.a", "hangs.cart"]
        [outputs]
        angle = "hangs.angle"
        [run]
        until = 4.0
        points = 41
        [initial]
        "hangs.angle" = 0.3
        [define.hangs.coordinates]
        x = {{ unit = "m" }}
        angle = {{ unit = "rad" }}
        [define.hangs.ports]
        cart = {{ kind = "translational", coordinate = "x" }}
        [define.hangs.energy]
        kinetic = "2 [kg]*(x_dot^2 + 2*1.5 [m]*x_dot*angle_dot*cos(angle) + (1.5 [m]*angle_dot)^2)/2"
        potential = "-2 [kg]*9.81 [m/s^2]*1.5 [m]*cos(angle)"
        "#
    );
    of_text(&text, Keep::All)
}

fn run(scene: &ModelSimulator, set: &[(&str, f64)], method: Method, rtol: f64) -> Trajectory {
    let mut run = Simulation::new(scene);
    for (name, value) in set {
        run = run.parameter(name, *value).expect("a parameter");
    }
    let run = run.method(method).rtol(rtol).with_energy_balance(true).run();
    run.unwrap_or_else(|error| panic!("{set:?}, {method} at {rtol:e}: {error}"))
}

/// Integrates two states by Runge-Kutta steps.
fn carried(
    rate: impl Fn(f64, [f64; 2]) -> [f64; 2],
    mut y: [f64; 2],
    (from, until): (f64, f64),
) -> [f64; 2] {
    let moved = |y: [f64; 2], f: [f64; 2], by: f64| [y[0] + by * f[0], y[1] + by * f[1]];
    let steps = (10_000.0 * (until - from)).ceil();
    let h = (until - from) / steps;
    for step in 0..steps as usize {
        let t = from + step as f64 * h;
        let a = rate(t, y);
        let b = rate(t + 0.5 * h, moved(y, a, 0.5 * h));
        let c = rate(t + 0.5 * h, moved(y, b, 0.5 * h));
        let d = rate(t + h, moved(y, c, h));
        y = std::array::from_fn(|k| y[k] + h / 6.0 * (a[k] + 2.0 * (b[k] + c[k]) + d[k]));
    }
    y
}

/// theta'' = -g/l sin(theta) between jumps of the cart's speed, theta' -= cos(theta) dv/l at each.
fn swings(jumps: &[(f64, f64)]) -> f64 {
    let rate = |_, [angle, speed]: [f64; 2]| [speed, -GRAVITY / LENGTH * f64::sin(angle)];
    let ends = jumps.iter().copied().chain([(4.0, 0.0)]);
    let (_, y) = ends.fold((0.0, [0.3, 0.0]), |(from, y), (until, jump)| {
        let y = carried(rate, y, (from, until));
        (until, [y[0], y[1] - f64::cos(y[0]) * jump / LENGTH])
    });
    y[0]
}

fn check(scene: &ModelSimulator, set: &[(&str, f64)], expected: f64) {
    for method in KEEPING {
        for rtol in [1e-4, 1e-7, 1e-10] {
            let run = run(scene, set, method, rtol);
            let found = run.last("angle").expect("an output");
            let what = format!("{set:?}, {method} at {rtol:e}");
            assert!((found - expected).abs() < 100.0 * rtol, "{what}: {found} for {expected}");
            let balance = run.energy_balance.as_ref().expect("asked for");
            let off = balance.max_residual_relative();
            assert!(off < 100.0 * rtol, "{what}: power is off by {off:e}");
        }
    }
}

#[test]
fn a_cart_whose_speed_jumps_swings_its_pendulum() {
    let scene = trolley("size*step(t, begins)");
    for (size, begins) in [(0.8, 0.77), (-5.0, 1e-3), (3.0, 2.9), (1e-3, 1.0)] {
        let set = [("size", size), ("begins", begins)];
        check(&scene, &set, swings(&[(begins, size)]));
    }
}

/// A short ramp is as a jump but for half of its length, and takes few steps: what is left of its
/// polynomial in t - t0 is not multiplied out in t, which would be nothing but rounding.
#[test]
fn a_cart_whose_speed_changes_within_a_moment_swings_its_pendulum() {
    for length in ["1e-2", "1e-4", "1e-5"] {
        let ramp = format!("0.8 [m/s]*smooth_step((t - 0.77 [s])/{length} [s])");
        let scene = trolley(&ramp);
        let length: f64 = length.parse().expect("a number");
        let expected = swings(&[(0.77 + 0.5 * length, 0.8)]);
        for method in KEEPING {
            let run = Simulation::new(&scene).method(method).rtol(1e-7).max_steps(2_000).run();
            let run = run.unwrap_or_else(|error| panic!("{length:e}, {method}: {error}"));
            let found = run.last("angle").expect("an output");
            let allowed = 1e-5 + length * length;
            assert!((found - expected).abs() < allowed, "{length:e}, {method}: {found}");
        }
    }
}

/// No list of times contains these jumps: they are found during the run.
#[test]
fn a_cart_whose_speed_jumps_to_and_fro_swings_its_pendulum() {
    let scene = trolley("piecewise(sin(3 [rad/s]*t) < share, 0 [m/s], size)");
    for share in [0.3, 0.9] {
        let first = f64::asin(share) / 3.0;
        let last = (std::f64::consts::PI - f64::asin(share)) / 3.0;
        let turn = std::f64::consts::TAU / 3.0;
        let jumps = [(first, 0.8), (last, -0.8), (first + turn, 0.8), (last + turn, -0.8)];
        check(&scene, &[("share", share)], swings(&jumps));
    }
}

/// The same holds without a jump of the speed itself: a position has a corner.
#[test]
fn a_rope_that_is_wound_from_a_moment_on_keeps_the_angular_momentum_of_its_load() {
    let text = r#"
        [scene]
        name = "hoist"
        [parameters]
        begins = { value = 0.77, unit = "s" }
        pace = { value = 0.9, unit = "m/s" }
        [units]
        load = { unit = "planar/particle" }
        [constraints.rope]
        expression = "sqrt(load.x^2 + load.y^2) - (5 [m] - pace*max(t - begins, 0))"
        [initial]
        "load.x" = 3.0
        [guess]
        "load.y" = -4.0
        [outputs]
        angle = { expression = "atan2(load.x, -load.y)", unit = "rad" }
        [run]
        until = 4.0
        points = 41
    "#;
    let scene = of_text(text, Keep::All);
    for (begins, pace) in [(0.77, 0.9), (2.0, -1.0), (0.0, 0.5)] {
        // (L^2 theta')' = -g L sin(theta)
        let length = |t: f64| 5.0 - pace * f64::max(t - begins, 0.0);
        let rate = |t: f64, [angle, spin]: [f64; 2]| {
            [spin / length(t).powi(2), -GRAVITY * length(t) * f64::sin(angle)]
        };
        let start = [f64::atan2(3.0, 4.0), 0.0];
        let y = carried(rate, carried(rate, start, (0.0, begins)), (begins, 4.0));
        check(&scene, &[("begins", begins), ("pace", pace)], y[0]);
    }
}

/// A prescribed position with a corner, and one that jumps: x'' = k (u - x)/m.
#[test]
fn what_a_spring_hangs_on_may_move_with_corners_and_jumps() {
    let scene = |place: &str| {
        let text = format!(
            r#"
            [scene]
            name = "drawn"
            [units]
            drive = {{ unit = "sources/position", inputs = {{ place = "{place}" }} }}
            spring = {{ unit = "translational/spring", parameters = {{ stiffness = 100 }} }}
            mass = {{ unit = "translational/mass", parameters = {{ mass = 1.0 }} }}
            [[joints]]
            connect = ["drive.a", "spring.a"]
            [[joints]]
            connect = ["spring.b", "mass.a"]
            [outputs]
            angle = "mass.x"
            [run]
            until = 1.0
            points = 11
            "#
        );
        of_text(&text, Keep::All)
    };
    let after = 10.0 * (1.0 - 0.47_f64);
    check(&scene("0.2 [m/s]*max(t - 0.47 [s], 0)"), &[], 0.02 * (after - after.sin()));
    let jumps = scene("0.1 [m]*step(t, 0.47 [s])");
    for method in KEEPING {
        let found = run(&jumps, &[], method, 1e-9).last("angle").expect("an output");
        assert!((found - 0.1 * (1.0 - after.cos())).abs() < 1e-7, "{method}: {found}");
    }
}

/// Returns the final position of the pendulum for a size and a time of jumps.
type Swing<'s> = &'s dyn Fn(f64, f64) -> f64;

/// Sensitivities by the time of a jump and by its size, against differences of the swing.
#[test]
fn sensitivities_go_through_jumps_of_imposed_speeds() {
    let by_list = trolley("size*step(t, begins)");
    let on_the_way = trolley("piecewise(sin(3 [rad/s]*(t - begins)) < share, 0 [m/s], size)");
    let turn = std::f64::consts::TAU / 3.0;
    let shift = f64::asin(0.3) / 3.0;
    let jump = |size: f64, begins: f64| swings(&[(begins, size)]);
    let jumps = |size: f64, begins: f64| {
        let last = begins + turn / 2.0 - shift;
        let [first, again] = [begins + shift, begins + shift + turn];
        swings(&[(first, size), (last, -size), (again, size), (last + turn, -size)])
    };
    let known: [(_, Swing, _); 2] = [(&by_list, &jump, 0.77), (&on_the_way, &jumps, 0.1)];
    for (scene, swings, begins) in known {
        let step = 1e-4;
        let by_size = (swings(0.8 + step, begins) - swings(0.8 - step, begins)) / (2.0 * step);
        let by_time = (swings(0.8, begins + step) - swings(0.8, begins - step)) / (2.0 * step);
        for method in [Method::Dop853, Method::Tsit5] {
            let run = Simulation::new(scene).method(method).rtol(1e-9);
            let run = run.parameter("begins", begins).expect("a parameter");
            let run = run.sensitivities(&["size", "begins"]).expect("parameters");
            let run = run.run().unwrap_or_else(|error| panic!("{method}: {error}"));
            for (by, expected) in [("size", by_size), ("begins", by_time)] {
                let found = *run.sensitivity("angle", by).expect("a column").last().expect("rows");
                let error = (found - expected).abs();
                assert!(error < 1e-5, "{method}, by {by}: {found} for {expected}");
            }
        }
    }
}

/// A host that carries the run in pieces, one of which ends at the jump, and one that steps it.
#[test]
fn a_host_s_runs_go_through_jumps_of_imposed_speeds() {
    let scene = trolley("size*step(t, begins)");
    let simulator: &dyn Simulator<f64> = &scene;
    let parameters: Vec<f64> =
        (0..simulator.shape().parameters).map(|index| simulator.parameter_default(index)).collect();
    let hosted = Hosted::new(simulator, &parameters);
    let expected = swings(&[(0.77, 0.8)]);
    let states = simulator.shape().states();
    let angle = (0..states).find(|index| simulator.state(*index).name == "hangs.angle");
    let angle = angle.expect("a state");
    for is_stepped in [false, true] {
        let mut state = vec![0.0; states];
        simulator.initial_state(&parameters, &mut state);
        let is_given = &|index: usize| simulator.is_given(index);
        let beginning = Beginning {
            from: 0.0,
            until: 4.0,
            rtol: 1e-8,
            is_stepped,
            state,
            is_given,
            in_equilibrium: false,
        };
        let mut standing = hosted.begin(beginning).expect("it begins");
        for until in [0.5, 0.77, 2.0, 4.0] {
            if !is_stepped {
                let auto = (Method::Auto, false);
                let reached = hosted.carry(&mut standing, until, auto, &|_, _| false);
                assert_eq!(reached.expect("it goes on").reached, Reached::End);
                continue;
            }
            let h = (until - standing.time) / 2000.0;
            let start = standing.time;
            for step in 0..2000 {
                let t = start + f64::from(step) * h;
                let mut y = standing.state.clone();
                let mut sum = vec![0.0; states];
                for (weight, part) in [(1.0, 0.0), (2.0, 0.5), (2.0, 0.5), (1.0, 1.0)] {
                    let at = standing.within(t + part * h);
                    if part > 0.0 {
                        let slopes = y.clone();
                        y = std::array::from_fn::<f64, 4, _>(|k| {
                            standing.state[k] + part * h * slopes[k]
                        })
                        .to_vec();
                    }
                    let mut rate = vec![0.0; states];
                    simulator.rate(at, &y, &parameters, &mut rate);
                    sum.iter_mut().zip(&rate).for_each(|(sum, rate)| *sum += weight * rate);
                    y = rate;
                }
                for (value, sum) in standing.state.iter_mut().zip(&sum) {
                    *value += h / 6.0 * sum;
                }
                standing.time = if step == 1999 { until } else { t + h };
            }
            hosted.happen(&mut standing).expect("it goes on");
        }
        let found = standing.state[angle];
        assert!((found - expected).abs() < 1e-5, "{is_stepped}: {found} for {expected}");
    }
}

/// Sticking friction cannot exert an infinite force: it slides until speeds are the same. A clutch
/// that is written with a constraint in place of friction stops the run.
#[test]
fn a_speed_that_jumps_is_not_followed_by_friction() {
    let text = r#"
        [scene]
        name = "belt"
        [units]
        drive = { unit = "sources/speed", inputs = { speed = "2 [rad/s]*SHAPE" } }
        clutch = { unit = "rotational/clutch", inputs = { normal_force = "10 [N]" } }
        rotor = { unit = "rotational/inertia" }
        [[joints]]
        connect = ["drive.a", "clutch.a"]
        [[joints]]
        connect = ["clutch.b", "rotor.a"]
        [outputs]
        angle = "rotor.phi"
        [run]
        until = 3.0
        points = 31
    "#;
    let jumps = of_text(&text.replace("SHAPE", "step(t, 1 [s])"), Keep::Needed);
    let ramp = "min(max((t - 1 [s])/1e-3 [s], 0), 1)";
    let soon = of_text(&text.replace("SHAPE", ramp), Keep::Needed);
    let own = r#"
        [scene]
        name = "coupling"
        [units]
        drive = { unit = "sources/speed", inputs = { speed = "2 [rad/s]*step(t, 1 [s])" } }
        rotor = { unit = "rotational/inertia" }
        [modes.closed]
        initial = 1
        [constraints.grips]
        expression = "drive.phi_dot - rotor.omega"
        when = { closed = 1 }
        [run]
        until = 3.0
        points = 31
    "#;
    let rigid = of_text(own, Keep::Needed);
    for method in KEEPING {
        // It slides for 0.4 s: 5 N m on 1 kg m^2, 2 rad/s.
        let run = Simulation::new(&jumps).method(method).rtol(1e-8).run().expect("it runs");
        let angle = run.last("angle").expect("an output");
        assert!((angle - (0.4 + 2.0 * 1.6)).abs() < 1e-7, "{method}: {angle}");
        let stopped = Simulation::new(&rigid).method(method).run().expect_err("it cannot follow");
        let told = stopped.to_string();
        assert!(told.contains("constraint `grips`") && told.contains("t = 1"), "{told}");
        // It starts 0.5 ms later on average.
        let run = Simulation::new(&soon).method(method).rtol(1e-8).run().expect("it runs");
        let angle = run.last("angle").expect("an output");
        assert!((angle - (0.4 + 2.0 * 1.6)).abs() < 1e-5, "{method}: {angle}");
    }
}

/// A corner of a constraint over which the machine moves by itself: the transverse motion is lost,
/// and this is reported.
#[test]
fn a_corner_of_what_holds_takes_energy_and_is_told() {
    let text = r#"
        [scene]
        name = "corner"
        [units]
        bead = { unit = "planar/particle" }
        [constraints.wire]
        expression = "bead.y - 0.5*abs(bead.x)"
        [initial]
        "bead.x" = -2.0
        "bead.v_x" = 1.0
        [outputs]
        angle = "bead.v_x"
        [run]
        until = 1.0
        points = 2
    "#;
    let scene = of_text(text, Keep::All);
    // Down a slope of 1/2 at g/2.5 along x; behind the corner 3/5 of the speed is left.
    let fall = GRAVITY * 0.4;
    let reaches = (f64::sqrt(1.0 + 4.0 * fall) - 1.0) / fall;
    let expected = 0.6 * (1.0 + fall * reaches) - fall * (1.0 - reaches);
    for method in KEEPING {
        let run = run(&scene, &[], method, 1e-9);
        let found = run.last("angle").expect("an output");
        assert!((found - expected).abs() < 1e-7, "{method}: {found} for {expected}");
        assert!(run.notes.iter().any(|note| note.contains("corner")), "{:?}", run.notes);
        let balance = run.energy_balance.as_ref().expect("asked for");
        assert!(balance.max_residual_relative() < 1e-7, "{method}");
    }
}
