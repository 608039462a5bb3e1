//! Closed forms of parts that lift, carry and hold at a place.

use machinist_codegen::mechanics::reduce::Keep;

use super::{by_small_steps, column, example, off, run};

const GRAVITY: f64 = 9.81;

#[test]
fn an_anchor_holds_at_its_place() {
    let scene = example("translational/anchor", Keep::Needed);
    for place in [-3.0, 0.0, 0.6, 40.0] {
        for stiffness in [2.0, 50.0, 9e4] {
            let run = run(&scene, &[("wall.place", place), ("spring.stiffness", stiffness)], &[]);
            let frequency = (stiffness / 2.0f64).sqrt();
            let rest = place - 0.2;
            let exact = |t: f64| {
                let (sin, cos) = (frequency * t).sin_cos();
                rest * (1.0 - cos) + sin / frequency
            };
            let error = off(&run, "place", exact)
                .max(off(&run, "force", |t| stiffness * (rest - exact(t))));
            assert!(error < 1e-7, "{place}, {stiffness}: {error:e}");
        }
    }
}

#[test]
fn a_mass_with_a_length_swings_as_if_its_springs_were_nearer() {
    let scene = example("translational/long_mass", Keep::Needed);
    for length in [-0.2, 0.0, 0.4, 3.0] {
        for mass in [1e-2, 2.0, 400.0] {
            let run = run(&scene, &[("carriage.length", length), ("carriage.mass", mass)], &[]);
            let frequency = (400.0 / mass).sqrt();
            let rest = (300.0 * 0.3 + 100.0 * (0.7 - length)) / 400.0;
            let place = |t: f64| {
                let (sin, cos) = (frequency * t).sin_cos();
                rest + (0.3 - rest) * cos + sin / frequency + length / 2.0
            };
            let speed = |t: f64| {
                let (sin, cos) = (frequency * t).sin_cos();
                -(0.3 - rest) * frequency * sin + cos
            };
            let error = off(&run, "place", place).max(off(&run, "speed", speed));
            assert!(error < 1e-6, "{length}, {mass}: {error:e}");
        }
    }
}

#[test]
fn a_weight_on_a_slope_pulls_by_its_sine() {
    let scene = example("translational/weight", Keep::Needed);
    for incline in [-30.0f64, 0.0, 6.0, 90.0] {
        for mass in [10.0, 1200.0, 1e5] {
            let angle = incline.to_radians();
            let set = [("weight.incline", angle), ("weight.mass", mass), ("car.mass", 2.0 * mass)];
            let run = run(&scene, &set, &[]);
            let pull = GRAVITY * angle.sin() / 2.0;
            let push = 900.0 / (2.0 * mass) / 2.0;
            let speed = |t: f64| 8.0 - pull * t + push * (1.0 - (2.0 * t).cos());
            let place = |t: f64| 8.0 * t - pull * t * t / 2.0 + push * (t - (2.0 * t).sin() / 2.0);
            let error = off(&run, "speed", speed).max(off(&run, "place", place));
            assert!(error < 1e-8, "{incline}, {mass}: {error:e}");
            if incline != 0.0 {
                let lifted = |t: f64| mass * GRAVITY * angle.sin() * place(t);
                let error = off(&run, "lifted", lifted);
                assert!(error < 1e-8, "{incline}, {mass}: lifted {error:e}");
            }
        }
    }
}

/// A load on a rope follows its hook; the work of lifting is stored.
#[test]
fn a_load_is_lifted_by_its_hook() {
    const UNTIL: f64 = 3.0;
    let scene = example("translational/hoisted_load", Keep::Needed);
    for mass in [20.0, 100.0, 700.0] {
        for damping in [0.0, 200.0, 2000.0] {
            let set = [("load.mass", mass), ("rope.damping", damping)];
            let run = run(&scene, &set, &[]);
            let hook_speed = |t: f64| {
                let s = (t / 0.5).clamp(0.0, 1.0);
                0.5 * s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s)
            };
            let start = [-mass * GRAVITY / 4000.0, 0.0, 0.0];
            let [place, _, hook] = by_small_steps(start, UNTIL, 100_000, |t, [x, v, hook]| {
                let force = 4000.0 * (hook - x) + damping * (hook_speed(t) - v);
                [*v, force / mass - GRAVITY, hook_speed(t)]
            });
            let found = *column(&run, "height").last().expect("a height");
            assert!((found - place).abs() < 1e-7, "{mass}, {damping}: {found} for {place}");
            assert!((hook - 0.5 * (UNTIL - 0.25)).abs() < 1e-9);
            let lifted = *column(&run, "lifted").last().expect("an energy");
            assert!((lifted - mass * GRAVITY * found).abs() < 1e-9 * lifted.abs());
        }
    }
}

#[test]
fn a_drum_lifts_by_its_radius() {
    let scene = example("rotational/rope_drum", Keep::Needed);
    for radius in [1e-2, 0.2, 3.0] {
        for mass in [1.0, 100.0, 1e4] {
            let run = run(&scene, &[("drum.radius", radius), ("load.mass", mass)], &[]);
            let rate = (250.0 - radius * mass * GRAVITY) / (1.0 + mass * radius * radius);
            let error = off(&run, "speed", |t| rate * t)
                .max(off(&run, "height", |t| radius * rate * t * t / 2.0));
            assert!(error < 1e-8, "{radius}, {mass}: {error:e}");
        }
    }
}

#[test]
fn a_conveyor_carries_its_load_against_rollers_and_slope() {
    let scene = example("rotational/conveyor", Keep::Needed);
    for incline in [0.0f64, 3.0, 5.0] {
        for length in [5.0, 50.0] {
            for radius in [0.1, 0.25] {
                let angle = incline.to_radians();
                let set = [
                    ("belt.incline", angle),
                    ("belt.length", length),
                    ("belt.radius", radius),
                    ("belt.fading_speed", 1e-3),
                ];
                // Fast enough that the resistance has not faded by the end.
                let start = 40.0 / radius;
                let run = run(&scene, &set, &[("belt.omega", start)]);
                let main = 0.025 * length * GRAVITY * (20.0 + 60.0 * angle.cos());
                let slope = length * 60.0 * GRAVITY * angle.sin();
                let inertia = 5.0 + length * 80.0 * radius * radius;
                let mean = (1500.0 - radius * (main + slope)) / inertia;
                let ripple = 100.0 / inertia / 3.0;
                let speed = |t: f64| radius * (start + mean * t + ripple * (1.0 - (3.0 * t).cos()));
                assert!(speed(10.0) > 1.0, "{incline} {length} {radius}: too slow");
                let error = off(&run, "speed", speed)
                    .max(off(&run, "loss", |t| main * speed(t)))
                    .max(off(&run, "flow", |t| 60.0 * speed(t)));
                assert!(error < 1e-8, "{incline}, {length}, {radius}: {error:e}");
                if incline > 0.0 {
                    assert!(off(&run, "lifting", |t| slope * speed(t)) < 1e-8);
                }
            }
        }
    }
}

/// Flies between the stops at constant speed, and is in contact for half a period.
#[test]
fn an_arm_swings_between_its_stops() {
    let scene = example("rotational/end_stops", Keep::Needed);
    for stiffness in [200.0f64, 1000.0, 1e5] {
        for lowest in [-0.5, 0.2] {
            let set =
                [("stops.damping", 0.0), ("stops.stiffness", stiffness), ("stops.lowest", lowest)];
            let run = run(&scene, &set, &[]);
            let frequency = (stiffness / 0.5).sqrt();
            let contact = std::f64::consts::PI / frequency;
            let flight = (1.4 - lowest) / 4.0;
            let angle = |t: f64| {
                // Time since the last pass of the lower stop upward.
                let since = (t + (0.8 - lowest) / 4.0) % (2.0 * (flight + contact));
                let above = since - flight;
                let back = above - contact;
                let below = back - flight;
                let depth = |time: f64| 4.0 / frequency * (frequency * time).sin();
                if above < 0.0 {
                    lowest + 4.0 * since
                } else if back < 0.0 {
                    1.4 + depth(above)
                } else if below < 0.0 {
                    1.4 - 4.0 * back
                } else {
                    lowest - depth(below)
                }
            };
            let error = off(&run, "angle", angle);
            assert!(error < 1e-7, "{stiffness}, {lowest}: {error:e}");
        }
    }
}

/// A backlash with a rest angle is that without, seen from a turned shaft.
#[test]
fn a_backlash_rests_at_its_angle() {
    let scene = example("rotational/backlash", Keep::All);
    let plain = run(&scene, &[], &[]);
    for rest in [-2.0, 0.01, 0.7] {
        let turned = run(&scene, &[("play.rest", rest)], &[("load.phi", rest)]);
        for name in ["twist", "torque"] {
            let size = column(&plain, name).iter().fold(0.0, |most: f64, v| most.max(v.abs()));
            let pairs = column(&plain, name).iter().zip(column(&turned, name));
            let most = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(most < 1e-6 * size, "{rest}, {name}: {most:e}");
        }
    }
}

/// The run-up follows one equation of both shafts, apart from the twist of the mesh.
#[test]
fn a_gear_drive_loses_in_its_teeth_and_bearings() {
    let scene = example("rotational/gear_drive", Keep::Needed);
    for (ratio, efficiency) in [(2.0, 0.97), (5.0, 0.97), (5.0, 0.7), (20.0, 0.9)] {
        for viscous in [0.0, 0.01, 0.05] {
            let set = [
                ("gear.ratio", ratio),
                ("gear.efficiency", efficiency),
                ("gear.viscous_b", viscous),
            ];
            let run = run(&scene, &set, &[]);
            // eta n (M - C_a - d_a n w - J_a n w') = J_b w' + C_b + d_b w.
            let inertia = 2.0 + efficiency * ratio * ratio * 0.05;
            let drive = efficiency * ratio * (8.0 - 0.1) - 0.5;
            let drag = efficiency * ratio * ratio * 0.001 + viscous;
            let speed = |t: f64| drive / drag * (1.0 - (-drag / inertia * t).exp());
            let at = |time: f64| run.times.iter().position(|t| *t >= time).expect("a time");
            let row = at(3.9);
            let time = run.times[row];
            let found = column(&run, "load")[row];
            let what = format!("{ratio}, {efficiency}, {viscous}");
            assert!((found / speed(time) - 1.0).abs() < 2e-3, "{what}: {found} {}", speed(time));
            let rate = (drive - drag * speed(time)) / inertia;
            let tooth = 8.0 - 0.1 - 0.001 * ratio * speed(time) - 0.05 * ratio * rate;
            let losses = [
                ("teeth", (1.0 - efficiency) * tooth * ratio * speed(time)),
                ("bearing_a", (0.1 + 0.001 * ratio * speed(time)) * ratio * speed(time)),
                ("bearing_b", (0.5 + viscous * speed(time)) * speed(time)),
            ];
            for (name, loss) in losses {
                let found = column(&run, name)[row];
                assert!((found / loss - 1.0).abs() < 1e-2, "{what}: {name} {found} for {loss}");
            }
        }
    }
}
