//! Parts of mechanisms in a plane, and mechanisms of parts alone.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, Simulator};
use machinist_model::ModelSimulator;
use machinist_studies::closed_form::four_bar::FOUR_BAR;
use machinist_studies::closed_form::slider_crank::{SLIDER_CRANK, SliderCrank};

use super::{METHODS, by_small_steps, column, contact, example, off, run};
use crate::own_scene::of_specs;

/// Runs with other values of parameters, by a method and a tolerance.
fn run_by(
    scene: &ModelSimulator,
    set: &[(&str, f64)],
    method: Method,
    rtol: f64,
    times: Option<&[f64]>,
) -> Trajectory {
    let mut simulation = Simulation::new(scene).method(method).rtol(rtol);
    for (name, value) in set {
        simulation = simulation.parameter(name, *value).expect("a parameter");
    }
    if let Some(times) = times {
        let end = times.last().expect("times");
        simulation = simulation.until(*end).times(times);
    }
    simulation.run().unwrap_or_else(|error| panic!("{set:?} {method} {rtol:e}: {error}"))
}

/// Returns a quarter of the period of a pendulum with w^2 = g/l, released at an angle from hanging.
fn quarter(frequency: f64, angle: f64) -> f64 {
    let (mut a, mut b): (f64, f64) = (1.0, (0.5 * angle).cos());
    for _ in 0..40 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    PI / (2.0 * a) / frequency
}

#[test]
fn a_link_held_at_its_end_swings_as_a_pendulum() {
    let scene = example("planar/link", Keep::Needed);
    let cases = [(0.1, 0.5), (0.4, 0.9), (3.0, 0.3), (1.0, 1.0)];
    for (number, (length, centre)) in cases.into_iter().enumerate() {
        let inertia = 2.0 * length * length / 15.0;
        let lever: f64 = centre * length;
        let frequency = (2.0 * 9.81 * lever / (inertia + 2.0 * lever * lever)).sqrt();
        let quarter = quarter(frequency, FRAC_PI_2 - 0.5);
        let times: Vec<f64> = (0..=8).map(|k| f64::from(k) * quarter).collect();
        let set = [("bar.length", length), ("bar.centre", centre), ("bar.inertia", inertia)];
        for (offset, rtol) in [1e-5, 1e-8, 1e-11].into_iter().enumerate() {
            let method = METHODS[(number + offset) % METHODS.len()];
            let run = run_by(&scene, &set, method, rtol, Some(&times));
            let exact = |k: usize| [-0.5, -FRAC_PI_2, 0.5 - PI, -FRAC_PI_2][k % 4];
            for (k, angle) in column(&run, "angle").iter().enumerate() {
                let error = (angle - exact(k)).abs();
                assert!(error < 300.0 * rtol, "{length}, {centre}, {method} {rtol:e}: {error:e}");
            }
        }
    }
}

/// The same by a point of a body, whose share of the mass does not matter, and by a rod.
#[test]
fn points_and_rods_swing_as_a_pendulum() {
    let scene = example("planar/point", Keep::Needed);
    for (along, across) in [(-0.2, 0.05), (0.3, -0.4), (-1.5, 0.0)] {
        let lever = f64::hypot(along, across);
        let frequency = (2.0 * 9.81 * lever / (0.03 + 2.0 * lever * lever)).sqrt();
        // From the eye to the centre of mass, at the start.
        let start = f64::atan2(-across, -along) + 0.5;
        let swing = (start + FRAC_PI_2 + PI).rem_euclid(TAU) - PI;
        let quarter = quarter(frequency, swing);
        let times: Vec<f64> = (0..=4).map(|k| f64::from(k) * quarter).collect();
        for share in [1e-5, 1e-2] {
            let set = [("eye.along", along), ("eye.across", across), ("eye.share", share)];
            let run = run_by(&scene, &set, Method::Dop853, 1e-10, Some(&times));
            let exact = [0.5, 0.5 - swing, 0.5 - 2.0 * swing, 0.5 - swing, 0.5];
            for (row, angle) in column(&run, "angle").iter().enumerate() {
                let error = (angle - exact[row]).abs();
                assert!(error < 1e-7, "{along}, {across}, {share}: {angle} of {}", exact[row]);
            }
            // The nail carries what gravity and the centre of mass take; it hangs at rest
            // but for what turns: m g + m w^2 l.
            let (speed, force) = (column(&run, "speed")[1], column(&run, "force_y")[1]);
            let exact = 2.0 * (9.81 + speed * speed * lever);
            assert!((force - exact).abs() < 1e-6 * exact, "{along}, {share}: {force}, {exact}");
        }
    }
    let scene = example("planar/rod", Keep::Needed);
    for gravity in [1.6, 9.81, 270.0] {
        let swing = f64::atan2(0.4, 0.3);
        let quarter = quarter(f64::sqrt(gravity / 0.5), swing);
        let times: Vec<f64> = (0..=4).map(|k| f64::from(k) * quarter).collect();
        for (number, method) in METHODS.into_iter().enumerate() {
            let rtol = [1e-6, 1e-9][number % 2];
            let run = run_by(&scene, &[("bob.gravity", gravity)], method, rtol, Some(&times));
            for (x, exact) in column(&run, "x").iter().zip([0.4, 0.0, -0.4, 0.0, 0.4]) {
                assert!((x - exact).abs() < 100.0 * rtol, "{gravity} {method}: {x} of {exact}");
            }
            // m (g cos + v^2/l), v^2 = 2 g l (cos - cos of the swing), hanging.
            let exact = gravity * (3.0 - 2.0 * swing.cos());
            let pull = column(&run, "force")[1];
            assert!((pull - exact).abs() < 200.0 * rtol * exact, "{gravity} {method}: {pull}");
        }
    }
}

#[test]
fn a_slider_crank_of_parts_moves_and_takes_the_torque_of_its_closed_form() {
    let scene = of_specs("linkages/slider_crank", Keep::Needed);
    let cases = [
        (0.05, 0.2, 2e-3, 1.1),
        (0.05, 0.08, 1e-4, 1.1),
        (0.04, 1.0, 0.05, 30.0),
        (0.01, 0.2, 2e-3, 1e-3),
    ];
    let mut count = 0;
    for (crank, rod, rod_inertia, slider_mass) in cases {
        let set = [
            ("crank.length", crank),
            ("rod.length", rod),
            ("rod.inertia", rod_inertia),
            ("slider.mass", slider_mass),
        ];
        let exact = SliderCrank { crank, rod, rod_inertia, slider_mass, ..SLIDER_CRANK };
        for rtol in [1e-6, 1e-9] {
            let method = METHODS[count % METHODS.len()];
            count += 1;
            let run = run_by(&scene, &set, method, rtol, None);
            let angle = |t: f64| 0.4 + 30.0 * t;
            let errors = [
                off(&run, "rod_angle", |t| exact.at(angle(t)).rod_angle),
                off(&run, "stroke", |t| exact.at(angle(t)).stroke),
                off(&run, "slider_speed", |t| exact.at(angle(t)).slider_speed),
                off(&run, "slider_acceleration", |t| exact.at(angle(t)).slider_acceleration),
                // The drive has an inertia of its own, which costs nothing at constant speed.
                off(&run, "torque", |t| exact.at(angle(t)).torque),
            ];
            let worst = errors.iter().fold(0.0, |most: f64, e| most.max(*e));
            assert!(worst < 50.0 * rtol, "{crank}, {rod}, {method} at {rtol:e}: {errors:?}");
        }
    }
}

/// Three bodies with an angle each and nine constraints: another way to the same machine.
#[test]
fn mechanisms_of_parts_have_the_forces_of_those_of_whole_bodies() {
    let of_parts = run(&of_specs("linkages/slider_crank", Keep::Needed), &[], &[]);
    let of_bodies = run(&of_specs("slider_crank", Keep::Needed), &[], &[]);
    // The weight of the slider, which here moves sideways only, rests on the guide there.
    let weight = 1.1 * 9.81;
    let pairs = column(&of_parts, "guide_force").iter().zip(column(&of_bodies, "guide_force"));
    for (ours, theirs) in pairs {
        assert!((ours + weight - theirs).abs() < 1e-6 * weight, "{ours}, {theirs}");
    }
    let times: Vec<f64> = (0..=50).map(|k| 0.01 * f64::from(k)).collect();
    let [of_parts, of_bodies] = ["linkages/four_bar", "four_bar"].map(|name| {
        run_by(&of_specs(name, Keep::Needed), &[], Method::Dop853, 1e-10, Some(&times))
    });
    for name in ["crank_angle", "crank_speed", "pin_force_x", "pin_force_y"] {
        let size = column(&of_bodies, name).iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        for (ours, theirs) in column(&of_parts, name).iter().zip(column(&of_bodies, name)) {
            assert!((ours - theirs).abs() < 1e-6 * size, "{name}: {ours}, {theirs}");
        }
    }
}

#[test]
fn a_four_bar_of_parts_obeys_freudenstein_and_keeps_its_energy() {
    let scene = of_specs("linkages/four_bar", Keep::Needed);
    let times: Vec<f64> = (0..=40).map(|k| 0.01 * f64::from(k)).collect();
    for (number, method) in METHODS.into_iter().enumerate() {
        let rtol = [1e-9, 1e-6][number % 2];
        let run = run_by(&scene, &[], method, rtol, Some(&times));
        let start = (1.5, 25.0);
        for row in 0..run.times.len() {
            let at = |name: &str| column(&run, name)[row];
            let crank = at("crank_angle");
            let (coupler, rocker) = FOUR_BAR.angles(crank);
            let turned = |a: f64, b: f64| ((a - b + PI).rem_euclid(TAU) - PI).abs();
            let off = turned(coupler, at("coupler_angle")).max(turned(rocker, at("rocker_angle")));
            assert!(off < 1e-11, "{method} at {}: {off:e}", run.times[row]);
            let speed = FOUR_BAR.speed(crank, start);
            let off = (at("crank_speed") / speed - 1.0).abs();
            assert!(off < 100.0 * rtol, "{method} at {}: {off:e}", run.times[row]);
        }
    }
}

/// tan b = (d + r sin a)/(r cos a) of the lever; its torque by virtual work.
#[test]
fn a_slotted_lever_goes_slow_forth_and_quick_back() {
    let scene = example("planar/slot", Keep::Needed);
    for (number, depth) in [-0.11, -0.3, -2.0].into_iter().enumerate() {
        for (offset, rtol) in [1e-6, 1e-9].into_iter().enumerate() {
            let method = METHODS[(number + 2 * offset) % METHODS.len()];
            let run = run_by(&scene, &[("foot.place_y", depth)], method, rtol, None);
            let (r, d, w) = (0.1, -depth, 5.0);
            let motion = |t: f64| {
                let (sin, cos) = (w * t).sin_cos();
                let square = r * r + d * d + 2.0 * r * d * sin;
                // b' = w r (r + d sin a)/s^2, and its derivative.
                let (top, top_rate) = (r * (r + d * sin), r * d * cos);
                let rate = w * top / square;
                let bend = w * w * (top_rate / square - top * 2.0 * r * d * cos / square.powi(2));
                ((d + r * sin).atan2(r * cos), rate, bend, square.sqrt())
            };
            let torque = |t: f64| {
                let (angle, rate, bend, _) = motion(t);
                let lever = (0.06 + 2.0 * 0.3 * 0.3) * bend + 2.0 * 9.81 * 0.3 * angle.cos();
                lever * rate / w + 1.0 * 9.81 * 0.05 * (w * t).cos()
            };
            let errors = [
                off(&run, "lever", |t| motion(t).0),
                off(&run, "rate", |t| motion(t).1),
                off(&run, "travel", |t| motion(t).3),
                off(&run, "torque", torque),
            ];
            let worst = errors.iter().fold(0.0, |most: f64, e| most.max(*e));
            assert!(worst < 100.0 * rtol, "{depth}, {method} at {rtol:e}: {errors:?}");
        }
    }
}

/// r'' = w^2 r along the arm, 2 m w r' across it.
#[test]
fn a_sleeve_is_thrown_out_along_its_arm() {
    let scene = example("planar/prismatic", Keep::Needed);
    for (number, method) in METHODS.into_iter().enumerate() {
        let mass = [1e-3, 0.5, 40.0][number % 3];
        let rtol = [1e-9, 1e-6][number % 2];
        let run = run_by(&scene, &[("sleeve.mass", mass)], method, rtol, None);
        let (travel, rate) = (|t: f64| 0.1 * (3.0 * t).cosh(), |t: f64| 0.3 * (3.0 * t).sinh());
        let force = |t: f64| 2.0 * mass * 3.0 * rate(t);
        let torque = |t: f64| travel(t) * force(t) + 9.81 * 0.5 * (3.0 * t).cos();
        let errors =
            [off(&run, "travel", travel), off(&run, "force", force), off(&run, "torque", torque)];
        let worst = errors.iter().fold(0.0, |most: f64, e| most.max(*e));
        assert!(worst < 100.0 * rtol, "{mass}, {method} at {rtol:e}: {errors:?}");
    }
}

#[test]
fn guides_carry_what_weight_and_curvature_ask() {
    let slope = example("planar/on_line", Keep::Needed);
    for (number, angle) in [-1.5, -0.5, 0.0, 0.3, 1.2].into_iter().enumerate() {
        for mass in [1e-3, 50.0] {
            let set = [("slope.angle", angle), ("bead.mass", mass)];
            let run = run_by(&slope, &set, METHODS[number], 1e-9, None);
            let start = 0.4 / f64::cos(angle);
            let pull = 9.81 * f64::sin(angle);
            let error = off(&run, "travel", |t| start * t - pull * t * t / 2.0).max(off(
                &run,
                "force",
                |_| mass * 9.81 * f64::cos(angle),
            ));
            assert!(error < 1e-7, "{angle}, {mass}: {error:e}");
        }
    }
    let hoop = example("planar/on_circle", Keep::Needed);
    for (number, speed) in [0.5, 3.0, 5.0, 40.0].into_iter().enumerate() {
        let mut simulation = Simulation::new(&hoop).rtol(1e-10).method(METHODS[number]);
        let mut state = vec![0.0; 4];
        hoop.initial_state(simulation.parameter_values(), &mut state);
        let index = (0..4).find(|index| hoop.state(*index).name == "bead.v_x");
        state[index.expect("a speed")] = speed;
        simulation = simulation.initial_state(&state);
        let run = simulation.run().expect("it runs");
        for row in 0..run.times.len() {
            let y = column(&run, "y")[row];
            let square = speed * speed - 2.0 * 9.81 * (y + 0.5);
            let exact = 9.81 * y / 0.5 - square / 0.5;
            let force = column(&run, "force")[row];
            let size = 9.81 + speed * speed / 0.5;
            assert!((force - exact).abs() < 1e-7 * size, "{speed}: {force} of {exact}");
        }
    }
}

#[test]
fn a_spring_in_the_plane_swings_in_ellipses_and_hangs_as_one_along_a_line() {
    let scene = example("planar/spring_damper", Keep::Needed);
    for stiffness in [1.0, 200.0, 1e4] {
        let set =
            [("spring.stiffness", stiffness), ("spring.damping", 0.0), ("spring.free_length", 0.0)];
        for method in [Method::Dop853, Method::Radau, Method::Auto, Method::Taylor] {
            let run = run_by(&scene, &set, method, 1e-9, None);
            let frequency = f64::sqrt(stiffness);
            let rest = -9.81 / stiffness;
            let error = off(&run, "x", |t| 0.3 * (frequency * t).cos())
                .max(off(&run, "y", |t| rest + (-0.2 - rest) * (frequency * t).cos()));
            assert!(error < 1e-6, "{stiffness} {method}: {error:e}");
        }
    }
    for damping in [0.5, 5.0, 27.0] {
        let start = [("bob.x", 0.0), ("bob.y", -0.5)];
        let run = run(&scene, &[("spring.damping", damping)], &start);
        // y = rest + (y0 - rest) e^(-d t) (cos + d/w sin), hanging.
        let (decay, rest) = (damping / 2.0, -0.3 - 9.81 / 200.0);
        let frequency = f64::sqrt(200.0 - decay * decay);
        let exact = |t: f64| {
            let (sin, cos) = (frequency * t).sin_cos();
            rest + (-0.5 - rest) * (-decay * t).exp() * (cos + decay / frequency * sin)
        };
        let error = off(&run, "y", exact);
        assert!(error < 1e-7, "{damping}: {error:e}");
    }
}

/// Across the line it falls, swings on the spring and falls; along it, it slides freely.
#[test]
fn a_ball_bounces_on_a_slope_as_its_closed_form() {
    let scene = example("planar/line_contact", Keep::Needed);
    for (number, stiffness) in [50.0, 2e4, 1e7].into_iter().enumerate() {
        for angle in [-1.0, -0.3, 0.0, 0.8] {
            let (across, along) = (9.81 * f64::cos(angle), -9.81 * f64::sin(angle));
            let height = 0.5 * f64::cos(angle) - 0.05;
            let meets = (2.0 * across * height).sqrt();
            let frequency = f64::sqrt(stiffness);
            let contact = 2.0 * (PI - (meets * frequency / across).atan()) / frequency;
            let fall = meets / across;
            let set =
                [("slope.angle", angle), ("slope.damping", 0.0), ("slope.stiffness", stiffness)];
            // Each time when it is at its height again, and in the middle of a contact.
            let turn = 2.0 * fall + contact;
            let times: Vec<f64> = (0..=4).map(|k| f64::from(k) * 0.5 * turn).collect();
            let method = [Method::Dop853, Method::Radau, Method::Tsit5][number];
            let run = run_by(&scene, &set, method, 1e-10, Some(&times));
            let deepest = across / stiffness
                + ((across / stiffness).powi(2) + meets * meets / stiffness).sqrt();
            for (row, time) in times.iter().enumerate() {
                let [x, y] = ["x", "y"].map(|name| column(&run, name)[row]);
                let gap = y * angle.cos() - x * angle.sin() - 0.05;
                let exact = if row % 2 == 0 { height } else { -deepest };
                assert!((gap - exact).abs() < 1e-6, "{stiffness}, {angle}: {gap} of {exact}");
                let way = x * angle.cos() + y * angle.sin() - 0.5 * angle.sin();
                let exact = along * time * time / 2.0;
                assert!((way - exact).abs() < 1e-7, "{stiffness}, {angle}: {way} of {exact}");
            }
        }
    }
    for damping in [5.0, 200.0, 1e4] {
        let set = [("slope.damping", damping), ("slope.angle", 0.0)];
        let run = run(&scene, &set, &[]);
        let exact = by_small_steps([0.5, 0.0], 2.0, 200_000, |_, y| {
            [y[1], contact(2e4, damping, 0.05 - y[0], -y[1]) - 9.81]
        });
        let error = (run.last("y").expect("an output") - exact[0]).abs();
        assert!(error < 1e-6, "{damping}: {error:e}");
        assert!(column(&run, "force").iter().all(|force| *force >= 0.0), "{damping}: it pulls");
    }
    // What lies on the line stays there: m g = k depth.
    let rests = -9.81 / 2e4 + 0.05;
    let lies = run(&scene, &[("slope.angle", 0.0)], &[("ball.y", rests)]);
    let error = off(&lies, "y", |_| rests);
    assert!(error < 1e-7, "{error:e}");
}

#[test]
fn balls_that_meet_exchange_their_momentum() {
    let scene = example("planar/circle_contact", Keep::All);
    for direction in [0.0, 0.7, 2.5, -1.9] {
        let (sin, cos) = f64::sin_cos(direction);
        for mass in [0.1, 2.0, 50.0] {
            for stiffness in [500.0, 1e6] {
                let set = [
                    ("contact.damping", 0.0),
                    ("contact.stiffness", stiffness),
                    ("second.mass", mass),
                ];
                let start = [
                    ("first.v_x", cos),
                    ("first.v_y", sin),
                    ("second.x", 0.3 * cos),
                    ("second.y", 0.3 * sin),
                ];
                let run = run(&scene, &set, &start);
                let last = |name: &str| run.last(name).expect("an output");
                let (first, second) = ((1.0 - mass) / (1.0 + mass), 2.0 / (1.0 + mass));
                let exact = [first * cos, first * sin, second * cos, second * sin];
                let found = ["first_x", "first_y", "second_x", "second_y"].map(last);
                let error = found.iter().zip(exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(error < 1e-7, "{direction}, {mass}, {stiffness}: {found:?}");
            }
        }
    }
    // Beside the middle: as by hand, in small steps.
    for damping in [0.0, 20.0, 1e3] {
        let run = run(&scene, &[("contact.damping", damping)], &[]);
        let exact =
            by_small_steps([0.0, 0.0, 1.0, 0.0, 0.3, 0.06, 0.0, 0.0], 1.0, 100_000, |_, s| {
                let (x, y) = (s[4] - s[0], s[5] - s[1]);
                let distance = x.hypot(y);
                let rate = (x * (s[6] - s[2]) + y * (s[7] - s[3])) / distance;
                let push = contact(2e4, damping, 0.1 - distance, -rate) / distance;
                [s[2], s[3], -push * x, -push * y, s[6], s[7], push * x / 2.0, push * y / 2.0]
            });
        let found = ["first_x", "first_y", "second_x", "second_y"];
        for (name, exact) in found.into_iter().zip([exact[2], exact[3], exact[6], exact[7]]) {
            let error = (run.last(name).expect("an output") - exact).abs();
            assert!(error < 1e-6, "{damping} {name}: {error:e}");
        }
        assert!(column(&run, "force").iter().all(|force| *force >= 0.0), "{damping}: it pulls");
    }
}

/// Motion of two rods, by Lagrange's equations in two angles.
#[test]
fn a_double_pendulum_moves_as_by_its_two_angles() {
    let scene = example("planar/revolute", Keep::Needed);
    let exact = by_small_steps([-1.0, 0.0, 0.0, 0.0], 1.0, 100_000, |_, y| {
        let (l, h, m, j, g) = (0.2, 0.1, 1.0, 0.0033, 9.81);
        let (first, second, mixed) = (j + m * h * h + m * l * l, j + m * h * h, m * l * h);
        let (sin, cos) = (y[0] - y[1]).sin_cos();
        let off = mixed * cos;
        let up = -mixed * sin * y[3] * y[3] - m * g * (h + l) * y[0].cos();
        let low = mixed * sin * y[2] * y[2] - m * g * h * y[1].cos();
        let divisor = first * second - off * off;
        [y[2], y[3], (second * up - off * low) / divisor, (first * low - off * up) / divisor]
    });
    for method in METHODS {
        let run = run_by(&scene, &[], method, 1e-9, None);
        for (name, exact) in [("upper", exact[0]), ("lower", exact[1])] {
            let error = (run.last(name).expect("an output") - exact).abs();
            assert!(error < 1e-6, "{method} {name}: {error:e}");
        }
    }
}

#[test]
fn what_is_thrown_flies_in_a_parabola_and_turns_on() {
    let stone = example("planar/particle", Keep::Needed);
    let body = example("planar/body", Keep::Needed);
    for speed in [-30.0, 0.1, 5.0, 1e3] {
        let thrown = run(&stone, &[], &[("stone.v_y", speed)]);
        let error = off(&thrown, "y", |t| speed * t - 9.81 * t * t / 2.0);
        assert!(error.max(off(&thrown, "x", |t| 2.0 * t)) < 1e-9, "{speed}: {error:e}");
        let thrown = run(&body, &[], &[("body.v_y", speed)]);
        let w = f64::sqrt(50.0);
        let errors = [
            off(&thrown, "x", |t| (w * t).sin() / w),
            off(&thrown, "y", |t| speed * t - 9.81 * t * t / 2.0),
            off(&thrown, "angle", |t| 4.0 * t),
        ];
        assert!(errors.iter().all(|error| *error < 1e-8), "{speed}: {errors:?}");
    }
}

/// A link that turns over: the pin carries weight and centrifugal force.
#[test]
fn a_pin_in_the_frame_carries_a_link() {
    let scene = example("planar/anchor", Keep::Needed);
    for (number, place) in [-3.0, 0.1, 20.0].into_iter().enumerate() {
        let run = run_by(&scene, &[("pin.place_y", place)], METHODS[number + 2], 1e-10, None);
        let inertia = 0.0033 + 0.01;
        for row in 0..run.times.len() {
            let at = |name: &str| column(&run, name)[row];
            let (sin, cos) = at("angle").sin_cos();
            let square = at("speed").powi(2);
            let kept = 0.5 * inertia * (400.0 - square) - 9.81 * 0.1 * (sin - f64::sin(0.2));
            assert!(kept.abs() < 1e-8, "{place}: {kept:e}");
            let turn = -9.81 * 0.1 * cos / inertia;
            let force =
                [0.1 * (-turn * sin - square * cos), 9.81 + 0.1 * (turn * cos - square * sin)];
            let off = (at("force_x") - force[0]).abs().max((at("force_y") - force[1]).abs());
            assert!(off < 1e-6, "{place}: {off:e}");
        }
    }
}
