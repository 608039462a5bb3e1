//! Friction on a shaft with prescribed motion: it reverses where the speed crosses zero, sticks
//! where the drive rests, and the drive supplies its losses.

use std::f64::consts::PI;

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use super::{METHODS, column};
use crate::own_scene::of_text;

/// A rotor of 2 kg m^2 that is turned as said, with a part on it, and what it loses.
fn driven(drive: &str, part: &str, joint: &str) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "driven"
        [units]
        drive = {{ {drive} }}
        rotor = {{ unit = "rotational/inertia", parameters = {{ inertia = "2 [kg m^2] - drive.inertia" }} }}
        part = {{ {part} }}
        [parameters]
        size = {{ value = 3.0, unit = "rad/s" }}
        pace = {{ value = 2.0, unit = "rad/s" }}
        [[joints]]
        connect = ["drive.a", "rotor.a"]
        [[joints]]
        connect = ["rotor.b", "{joint}"]
        [outputs]
        speed = "rotor.omega"
        torque = "drive.torque"
        friction = "part.torque"
        loss = "part.loss"
        power = "drive.power"
        [run]
        until = 10.0
        points = 401
        rtol = 1e-9
        method = "dop853"
        "#,
    );
    of_text(&text, Keep::All)
}

const BRAKE: &str = r#"unit = "rotational/brake", inputs = { normal_force = "10 [N]" }"#;
const SINE: &str = r#"unit = "sources/speed", inputs = { speed = "size*sin(pace*t)" }"#;

fn run(scene: &ModelSimulator, set: &[(&str, f64)], method: Method, rtol: f64) -> Trajectory {
    let mut run = Simulation::new(scene);
    for (name, value) in set {
        run = run.parameter(name, *value).expect("a parameter");
    }
    let run = run.method(method).rtol(rtol).max_steps(50_000).with_energy_balance(true).run();
    run.unwrap_or_else(|error| panic!("{set:?}, {method} at {rtol:e}: {error}"))
}

fn times_of(run: &Trajectory, events: &[&str]) -> Vec<f64> {
    let of = run.switches.iter().filter(|switch| events.contains(&switch.event.as_str()));
    of.map(|switch| switch.time).collect()
}

/// W = integral of c |omega| dt, drive torque J alpha + c sign(omega), events at zeros of the sine.
#[test]
fn friction_on_a_driven_shaft_slides_on_where_its_speed_passes_zero() {
    let scene = driven(SINE, BRAKE, "part.a");
    for size in [1e-3, 3.0, 1e3] {
        for pace in [0.4, 2.0, 37.0] {
            for method in METHODS {
                for rtol in [1e-3, 1e-6, 1e-9, 1e-12] {
                    let what = format!("{size} {pace} {method} {rtol:e}");
                    let run = run(&scene, &[("size", size), ("pace", pace)], method, rtol);
                    let zeros = (10.0 * pace / PI).floor() as usize;
                    let ends = times_of(&run, &["part.ends_forth", "part.ends_back"]);
                    let breaks = times_of(&run, &["part.breaks_forth", "part.breaks_back"]);
                    assert_eq!(ends.len(), zeros, "{what}: {ends:?}");
                    assert_eq!(breaks.len(), zeros + 1, "{what}: {breaks:?}");
                    assert_eq!(breaks[1..], ends, "{what}");
                    for (number, found) in breaks.iter().enumerate() {
                        let exact = number as f64 * PI / pace;
                        assert!(
                            (found - exact).abs() < 1e-12 * (1.0 + exact),
                            "{what}: {found} for {exact}"
                        );
                    }
                    for (row, time) in run.times.iter().enumerate() {
                        let at = |name: &str| column(&run, name)[row];
                        let (speed, slope) =
                            (size * (pace * time).sin(), size * pace * (pace * time).cos());
                        assert!(
                            (at("speed") - speed).abs() < 1e-12 * size,
                            "{what}: {} at {time}",
                            at("speed")
                        );
                        if speed.abs() < 1e-9 * size {
                            continue;
                        }
                        let friction = -5.0 * speed.signum();
                        assert!(
                            (at("friction") - friction).abs() < 1e-12,
                            "{what}: {} at {time}",
                            at("friction")
                        );
                        let torque = 2.0 * slope - friction;
                        let off = (at("torque") - torque).abs();
                        assert!(
                            off < 1e-10 * (5.0 + 2.0 * size * pace),
                            "{what}: {off:e} at {time}"
                        );
                    }
                    let balance = run.energy_balance.as_ref().expect("asked for");
                    let turned = |until: f64| {
                        let (whole, rest) = ((until * pace / PI).floor(), (until * pace) % PI);
                        size / pace * (2.0 * whole + 1.0 - rest.cos())
                    };
                    let work = 5.0 * turned(10.0);
                    let lost = *balance.dissipated.last().expect("rows");
                    let off = (lost - work).abs();
                    assert!(off < (200.0 * rtol + 1e-11) * work, "{what}: lost {lost} for {work}");
                    assert!(
                        balance.max_residual_relative() < 1e3 * rtol,
                        "{what}: {:e}",
                        balance.max_residual_relative()
                    );
                }
            }
        }
    }
}

/// A drive that rests at times: its speed, and the times at which it starts and stops.
struct Drive {
    unit: &'static str,
    speed: fn(f64) -> f64,
    rests: &'static [(f64, f64)],
    /// Accuracy of the times: smoother drives leave zero more slowly.
    within: f64,
}

const TRAPEZOID: &str = r#"unit = "sources/speed", inputs = { speed = "size*(max(0, min(min(t/1 [s], 1), (3 [s] - t)/1 [s])) - max(0, min(min((t - 5 [s])/1 [s], 1), (8 [s] - t)/1 [s])))" }"#;

fn trapezoid(t: f64) -> f64 {
    3.0 * (t.min(1.0).min(3.0 - t).max(0.0) - (t - 5.0).min(1.0).min(8.0 - t).max(0.0))
}

const DRIVES: [Drive; 5] = [
    Drive { unit: TRAPEZOID, speed: trapezoid, rests: &[(3.0, 5.0), (8.0, 10.0)], within: 1e-11 },
    Drive {
        unit: r#"unit = "sources/speed", inputs = { speed = "size*max(sin(pace*t), 0)" }"#,
        speed: |t| 3.0 * f64::max((2.0 * t).sin(), 0.0),
        rests: &[(PI / 2.0, PI), (1.5 * PI, 2.0 * PI), (2.5 * PI, 3.0 * PI)],
        within: 1e-11,
    },
    Drive {
        unit: r#"unit = "sources/speed", inputs = { speed = "size*max(t/1 [s] - 4, 0)^2 - size*max(t/1 [s] - 7, 0)" }"#,
        speed: |t| 3.0 * (f64::max(t - 4.0, 0.0).powi(2) - f64::max(t - 7.0, 0.0)),
        rests: &[(0.0, 4.0)],
        within: 1e-5,
    },
    Drive {
        unit: r#"unit = "sources/speed", inputs = { speed = "size*(smooth_step((t - 1 [s])/1 [s]) - smooth_step((t - 3 [s])/2 [s]))" }"#,
        speed: |t| {
            let step = |u: f64| {
                u.clamp(0.0, 1.0).powi(3)
                    * (u.clamp(0.0, 1.0) * (6.0 * u.clamp(0.0, 1.0) - 15.0) + 10.0)
            };
            3.0 * (step(t - 1.0) - step((t - 3.0) / 2.0))
        },
        rests: &[(0.0, 1.0), (5.0, 10.0)],
        within: 1e-4,
    },
    Drive {
        unit: r#"unit = "sources/angle", inputs = { angle = "size*max(t/1 [s] - 2, 0)^2*0.5 [s] - size*max(t/1 [s] - 3, 0)^2*1 [s] + size*max(t/1 [s] - 4, 0)^2*0.5 [s]" }"#,
        speed: |t| {
            3.0 * (f64::max(t - 2.0, 0.0) - 2.0 * f64::max(t - 3.0, 0.0) + f64::max(t - 4.0, 0.0))
        },
        rests: &[(0.0, 2.0), (4.0, 10.0)],
        within: 1e-11,
    },
];

/// A part and its friction torque at a speed.
struct Part {
    unit: &'static str,
    joint: &'static str,
    friction: fn(f64) -> f64,
}

const PARTS: [Part; 2] = [
    Part { unit: BRAKE, joint: "part.a", friction: |speed| -5.0 * speed.signum() },
    Part {
        unit: r#"unit = "rotational/bearing_friction""#,
        joint: "part.a",
        friction: |w| -(1.0 + 0.5 * (-w.abs() / 0.1).exp() + 0.01 * w.abs()) * w.signum(),
    },
];

/// It sticks as the drive comes to rest, and slides as soon as it moves; the drive carries all.
#[test]
fn friction_on_a_driven_shaft_sticks_while_its_drive_rests() {
    for (number, drive) in DRIVES.iter().enumerate() {
        for part in &PARTS {
            let scene = driven(drive.unit, part.unit, part.joint);
            for method in METHODS {
                for rtol in [1e-3, 1e-6, 1e-9, 1e-12] {
                    let what = format!("{number} {} {method} {rtol:e}", part.unit);
                    let run = run(&scene, &[], method, rtol);
                    let found = times_of(&run, &["part.ends_forth", "part.ends_back"]);
                    let ends: Vec<f64> =
                        drive.rests.iter().map(|rest| rest.0).filter(|t| *t > 0.0).collect();
                    let breaks: Vec<f64> =
                        drive.rests.iter().map(|rest| rest.1).filter(|t| *t < 10.0).collect();
                    for end in &ends {
                        let near = found.iter().any(|time| (time - end).abs() < drive.within);
                        assert!(near, "{what}: {end} of {found:?}");
                    }
                    let found = times_of(&run, &["part.breaks_forth", "part.breaks_back"]);
                    for end in &breaks {
                        let near = found.iter().any(|time| (time - end).abs() < drive.within);
                        assert!(near, "{what}: {end} of {found:?}");
                    }
                    assert!(run.switches.len() < 16, "{what}: {:?}", run.switches);
                    for (row, time) in run.times.iter().enumerate() {
                        let at = |name: &str| column(&run, name)[row];
                        let speed = (drive.speed)(*time);
                        assert!(
                            (at("speed") - speed).abs() < 1e-12,
                            "{what}: {} at {time}",
                            at("speed")
                        );
                        let is_near = drive
                            .rests
                            .iter()
                            .any(|(a, b)| (a - time).abs().min((b - time).abs()) < 1e-3);
                        let rests = drive.rests.iter().any(|(a, b)| (*a..=*b).contains(time));
                        if is_near || speed.abs() < 1e-6 && !rests {
                            continue;
                        }
                        let friction =
                            if speed.abs() < 1e-14 { 0.0 } else { (part.friction)(speed) };
                        assert!(
                            (at("friction") - friction).abs() < 1e-11,
                            "{what}: {} for {friction} at {time}",
                            at("friction")
                        );
                    }
                    let balance = run.energy_balance.as_ref().expect("asked for");
                    assert!(
                        balance.max_residual_relative() < 1e3 * rtol,
                        "{what}: {:e}",
                        balance.max_residual_relative()
                    );
                }
            }
        }
    }
}

/// A driven shaft takes a rotor along through a clutch, a brake is on the rotor: where the speed
/// passes zero, that of both lets go which is weaker.
#[test]
fn of_a_clutch_and_a_brake_in_a_row_the_weaker_slides_on() {
    for clutch_first in [true, false] {
        let clutch =
            r#"clutch = { unit = "rotational/torque_limiter", parameters = { limit = "clutch" } }"#;
        let brake =
            r#"brake = { unit = "rotational/brake", inputs = { normal_force = "2*brake/1 [m]" } }"#;
        let both = if clutch_first { [clutch, brake] } else { [brake, clutch] }.join("\n        ");
        let text = format!(
            r#"
            [scene]
            name = "row"
            [units]
            drive = {{ unit = "sources/speed", inputs = {{ speed = "3 [rad/s]*cos(2 [rad/s]*t)" }} }}
            {both}
            rotor = {{ unit = "rotational/inertia", parameters = {{ inertia = 0.1 }} }}
            [parameters]
            clutch = {{ value = 10.0, unit = "N m" }}
            brake = {{ value = 5.0, unit = "N m" }}
            [[joints]]
            connect = ["drive.a", "clutch.a"]
            [[joints]]
            connect = ["clutch.b", "rotor.a"]
            [[joints]]
            connect = ["rotor.b", "brake.a"]
            [initial]
            "rotor.omega" = 3
            [outputs]
            speed = "rotor.omega"
            torque = "drive.torque"
            clutch = "clutch.torque"
            brake = "brake.torque"
            [run]
            until = 10.0
            points = 401
            rtol = 1e-9
            method = "dop853"
            "#
        );
        let scene = of_text(&text, Keep::All);
        for method in METHODS {
            for rtol in [1e-3, 1e-6, 1e-10] {
                let what = format!("{clutch_first} {method} {rtol:e}");
                // The rotor needs 0.6 N m at most.
                let strong = run(&scene, &[], method, rtol);
                for (row, time) in strong.times.iter().enumerate() {
                    let at = |name: &str| column(&strong, name)[row];
                    let speed = 3.0 * (2.0 * time).cos();
                    assert!(
                        (at("speed") - speed).abs() < 1e-11,
                        "{what}: {} at {time}",
                        at("speed")
                    );
                    if speed.abs() > 1e-6 {
                        let torque = -0.6 * (2.0 * time).sin() + 5.0 * speed.signum();
                        assert!(
                            (at("clutch") - torque).abs() < 1e-9,
                            "{what}: {} at {time}",
                            at("clutch")
                        );
                    }
                }
                let weak = run(&scene, &[("clutch", 4.0)], method, rtol);
                // 0.1 w' = -4 - 5 until it stands.
                let stands =
                    weak.times.iter().zip(column(&weak, "speed")).filter(|(time, _)| **time > 1.0);
                for (time, speed) in stands {
                    assert!(speed.abs() < 1e-9, "{what}: {speed} at {time}");
                }
                for (row, time) in weak.times.iter().enumerate() {
                    let speed = 3.0 * (2.0 * time).cos();
                    if *time < 1.0 || speed.abs() < 1e-6 {
                        continue;
                    }
                    let at = |name: &str| column(&weak, name)[row];
                    let torque = 4.0 * speed.signum();
                    assert!(
                        (at("clutch") - torque).abs() < 1e-9,
                        "{what}: {} at {time}",
                        at("clutch")
                    );
                    assert!(
                        (at("brake") + torque).abs() < 1e-9,
                        "{what}: {} at {time}",
                        at("brake")
                    );
                }
            }
        }
    }
}

/// A crank that turns freely with a flywheel, or at an imposed speed, and a slider on a rough
/// guide: its speed passes zero at the dead points, where it is the crank that leads.
#[test]
fn friction_of_a_slider_lets_its_crank_through_dead_points() {
    let scene = |drive: &str| {
        let text = format!(
            r#"
            [scene]
            name = "slider"
            [units.crank]
            unit = "planar/slider_crank"
            parameters = {{ gravity = 0 }}
            [units.wheel]
            unit = "rotational/inertia"
            parameters = {{ inertia = 0.5 }}
            [units.guide]
            unit = "translational/friction"
            parameters = {{ coulomb = 20, stribeck = 0, viscous = 0 }}
            {drive}
            [[joints]]
            connect = ["wheel.b", "crank.shaft"]
            [[joints]]
            connect = ["crank.slider", "guide.a"]
            [initial]
            "wheel.omega" = 20
            [outputs]
            speed = "wheel.omega"
            angle = "wheel.phi"
            [run]
            until = 2.0
            points = 101
            rtol = 1e-9
            method = "dop853"
            "#
        );
        of_text(&text, Keep::All)
    };
    let free = scene("");
    let place = |phi: f64| {
        let (r, l) = (0.05, 0.2);
        r * phi.cos() + (l * l - (r * phi.sin()).powi(2)).sqrt()
    };
    for method in METHODS {
        for rtol in [1e-4, 1e-6, 1e-8] {
            let what = format!("{method} {rtol:e}");
            let run = run(&free, &[], method, rtol);
            assert!(run.switches.len() > 10, "{what}: {:?}", run.switches);
            // It loses the friction over the way that the slider goes.
            let angles = column(&run, "angle");
            let steps = 2000;
            let way: f64 = angles
                .windows(2)
                .map(|ends| {
                    let angle = |k: usize| ends[0] + (ends[1] - ends[0]) * k as f64 / steps as f64;
                    let moves = (0..steps).map(|k| place(angle(k + 1)) - place(angle(k)));
                    moves.map(f64::abs).sum::<f64>()
                })
                .sum();
            let balance = run.energy_balance.as_ref().expect("asked for");
            let lost = *balance.dissipated.last().expect("rows");
            let off = (lost / (20.0 * way) - 1.0).abs();
            assert!(off < 1e-6 + 300.0 * rtol, "{what}: lost {lost} over {way}");
            let residual = balance.max_residual_relative();
            assert!(residual < 1e3 * rtol, "{what}: {residual:e}");
        }
    }
}

/// Parts along a line, behind a screw, and a lossy gear between a drive and a load: events are at
/// zeros of the speed, and losses are the power of the drive minus that of the load.
#[test]
fn every_part_with_friction_can_be_driven() {
    let scene = |units: &str, joints: &[[&str; 2]], events: &str| {
        let joints =
            joints.iter().map(|[a, b]| format!("[[joints]]\nconnect = [\"{a}\", \"{b}\"]\n"));
        let text = format!(
            r#"
            [scene]
            name = "{events}"
            [units]
            {units}
            {}
            [run]
            until = 10.0
            points = 101
            rtol = 1e-9
            method = "dop853"
            "#,
            joints.collect::<String>()
        );
        of_text(&text, Keep::All)
    };
    let turns =
        r#"drive = { unit = "sources/speed", inputs = { speed = "3 [rad/s]*sin(2 [rad/s]*t)" } }"#;
    let slides = r#"drive = { unit = "sources/linear_speed", inputs = { speed = "3 [m/s]*sin(2 [rad/s]*t)" } }"#;
    let guide = r#"part = { unit = "translational/friction" }"#;
    let gear = r#"part = { unit = "rotational/lossy_gear" }
            load = { unit = "rotational/inertia" }
            damper = { unit = "sources/torque", inputs = { torque = "7 [N m]" } }"#;
    let scenes = vec![
        scene(&format!("{slides}\n{guide}"), &[["drive.a", "part.a"]], "guide"),
        scene(
            &format!("{turns}\nscrew = {{ unit = \"rotational/screw\" }}\n{guide}"),
            &[["drive.a", "screw.a"], ["screw.b", "part.a"]],
            "screw",
        ),
        scene(
            &format!("{turns}\n{gear}"),
            &[["drive.a", "part.a"], ["part.b", "load.a"], ["load.b", "damper.a"]],
            "gear",
        ),
    ];
    for scene in &scenes {
        for method in [Method::Dop853, Method::Radau, Method::Auto] {
            for rtol in [1e-4, 1e-7] {
                let run = run(scene, &[], method, rtol);
                let what = format!("{} {method} {rtol:e}", run.scene);
                let ends = times_of(&run, &["part.ends_forth", "part.ends_back"]);
                assert_eq!(ends.len(), 6, "{what}: {ends:?}");
                for (number, found) in ends.iter().enumerate() {
                    let exact = (number + 1) as f64 * PI / 2.0;
                    assert!((found - exact).abs() < 1e-11, "{what}: {found} for {exact}");
                }
                let balance = run.energy_balance.as_ref().expect("asked for");
                assert!(
                    balance.max_residual_relative() < 1e3 * rtol,
                    "{what}: {:e}",
                    balance.max_residual_relative()
                );
                assert!(*balance.dissipated.last().expect("rows") > 0.0, "{what}");
            }
        }
    }
}
