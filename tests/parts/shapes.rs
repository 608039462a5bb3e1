//! Parts whose shape sets their law: cams, and loads at an angle.

use std::f64::consts::{PI, TAU};

use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use super::{METHODS, by_small_steps, column, contact, example, off, run};
use crate::own_scene::of_text;

/// Returns the lift of the cam over its largest, and its slope, at an angle from the nose.
fn law(angle: f64) -> (f64, f64) {
    let base = 1.0 - f64::cos(1.2);
    let way = ((angle.cos() - f64::cos(1.2)) / base).clamp(0.0, 1.0);
    let lift = way.powi(3) * (10.0 - 15.0 * way + 6.0 * way * way);
    (lift, -30.0 * (way * (1.0 - way)).powi(2) * angle.sin() / base)
}

const CAM: &str = r#"
[scene]
name = "turned"
[units.drive]
unit = "sources/speed"
inputs = { speed = "turning" }
[units.cam]
unit = "rotational/cam"
[units.valve]
unit = "translational/mass"
parameters = { mass = 0.2 }
[units.spring]
unit = "translational/spring"
parameters = { stiffness = 2e4, free_length = -0.005 }
[units.seat]
unit = "translational/fixed"
[[joints]]
connect = ["drive.a", "cam.a"]
[[joints]]
connect = ["cam.b", "valve.a"]
[[joints]]
connect = ["seat.a", "spring.a"]
[[joints]]
connect = ["spring.b", "valve.b"]
[parameters]
turning = { value = 100.0, unit = "rad/s" }
start = { value = -1e-4, unit = "m" }
[initial]
"drive.phi" = 3.141592653589793
"valve.x" = "start"
[guess]
"drive.phi_dot" = 100
[outputs]
lift = "valve.x"
speed = "valve.v"
force = "cam.force"
torque = "cam.torque"
[run]
until = 0.1
points = 201
rtol = 1e-9
method = "dop853"
"#;

fn turned(scene: &ModelSimulator, turning: f64, set: &[(&str, f64)]) -> machinist::Trajectory {
    set.iter()
        .try_fold(Simulation::new(scene), |run, (name, value)| run.parameter(name, *value))
        .and_then(|run| run.parameter("turning", turning))
        .expect("parameters")
        .until(TAU / turning)
        .run()
        .unwrap_or_else(|error| panic!("{turning} {set:?}: {error}"))
}

#[test]
fn a_follower_moves_on_its_cam_and_off_it_as_by_small_steps() {
    let scene = of_text(CAM, Keep::Needed);
    for (turning, damping) in [(40.0, 100.0), (100.0, 0.0), (250.0, 3e3), (400.0, 100.0)] {
        let run = turned(&scene, turning, &[("cam.damping", damping)]);
        let exact = by_small_steps([-1e-4, 0.0], TAU / turning, 20_000, |t, y| {
            let (lift, slope) = law(PI + turning * t);
            let rate = 0.01 * slope * turning - y[1];
            let push = contact(1e6, damping, 0.01 * lift - y[0], rate);
            [y[1], (push - 2e4 * (y[0] + 0.005)) / 0.2]
        });
        let error = (run.last("lift").expect("an output") - exact[0]).abs();
        assert!(error < 1e-6, "{turning}, {damping}: {error:e}");
        let (mut least, mut power) = (f64::INFINITY, 0.0f64);
        for row in 0..run.times.len() {
            let at = |name: &str| column(&run, name)[row];
            least = least.min(at("force"));
            let slope = 0.01 * law(PI + turning * run.times[row]).1;
            power = power.max((at("torque") + at("force") * slope).abs());
        }
        assert!(least >= 0.0, "{turning}, {damping}: it pulls");
        assert!(power < 1e-9, "{turning}: torque and force by one slope: {power:e}");
    }
}

/// With a stiff contact, the follower stays on the cam as long as the spring is strong enough.
#[test]
fn a_follower_lifts_off_at_the_speed_at_which_its_spring_is_too_weak() {
    let scene = of_text(CAM, Keep::Needed);
    let step = 1e-4;
    let bend = |angle: f64| (law(angle + step).1 - law(angle - step).1) / (2.0 * step);
    let weakest = (1..3000).map(|k| 1.2 * f64::from(k) / 3000.0).filter(|a| bend(*a) < 0.0);
    let square = weakest.map(|a| 2e4 * (0.01 * law(a).0 + 0.005) / (0.2 * 0.01 * -bend(a)));
    let critical = square.fold(f64::INFINITY, f64::min).sqrt();
    for (share, lifts) in [(0.5, false), (0.93, false), (1.07, true)] {
        let stiff = [("cam.stiffness", 1e7), ("cam.damping", 1e3), ("start", -1e-5)];
        let run = turned(&scene, share * critical, &stiff);
        // Pressed only after the start, where it settles.
        let late = run.times.iter().zip(column(&run, "force"));
        let least = late.filter(|(t, _)| **t > 0.2 * run.times[200]).map(|(_, force)| *force);
        let least = least.fold(f64::INFINITY, f64::min);
        assert_eq!(least == 0.0, lifts, "{share} of {critical}: {least}");
    }
}

/// Returns a modified sine and its slope.
fn modified_sine(x: f64) -> (f64, f64) {
    let over = 1.0 / (4.0 + PI);
    match x {
        x if x <= 0.0 => (0.0, 0.0),
        x if x < 0.125 => {
            let way = PI * x - (4.0 * PI * x).sin() / 4.0;
            (over * way, over * PI * (1.0 - (4.0 * PI * x).cos()))
        }
        x if x < 0.875 => {
            let angle = PI * (4.0 * x + 1.0) / 3.0;
            let way = 2.0 + PI * x - 2.25 * angle.sin();
            (over * way, over * PI * (1.0 - 3.0 * angle.cos()))
        }
        x if x < 1.0 => {
            let way = 4.0 + PI * x - (4.0 * PI * x).sin() / 4.0;
            (over * way, over * PI * (1.0 - (4.0 * PI * x).cos()))
        }
        _ => (1.0, 0.0),
    }
}

/// Steps of Runge and Kutta from corner to corner of the law, with the contact by the hand-written
/// law. At high speeds the follower leaves the cam and lands on it again.
#[test]
fn a_follower_of_a_cam_with_dwells_lifts_off_and_lands_as_by_small_steps() {
    let mut lifted = 0;
    for (speed, damping, [rise, dwell, fall], stiffness) in [
        (10.0, 100.0, [1.5, 1.0, 1.5], 1e6),
        (30.0, 0.0, [1.5, 1.0, 1.5], 1e6),
        (60.0, 300.0, [1.0, 0.3, 2.0], 1e6),
        (90.0, 50.0, [0.8, 1.2, 0.9], 2e5),
        (140.0, 1e3, [2.0, 0.1, 0.7], 1e7),
    ] {
        let set = [
            ("cam.damping", damping),
            ("cam.rise", rise),
            ("cam.dwell", dwell),
            ("cam.fall", fall),
            ("cam.stiffness", stiffness),
        ];
        let text = std::fs::read_to_string(
            crate::own_scene::folder_of_specs().join("parts/rotational/dwell_cam.toml"),
        );
        let text = text.expect("the example").replace("30 [rad/s]", &format!("{speed} [rad/s]"));
        let text = text.replace("phi_dot\" = 30", &format!("phi_dot\" = {speed}"));
        let fast = of_text(&text, Keep::All);
        let until = 1.7 * TAU / speed;
        let run = set.iter().try_fold(Simulation::new(&fast).rtol(1e-11), |run, (name, value)| {
            run.parameter(name, *value)
        });
        let run = run.expect("parameters").until(until).run().expect("it runs");
        let cam = |t: f64| {
            let turn = (speed * t - 0.5).rem_euclid(TAU);
            let (up, up_slope) = modified_sine(turn / rise);
            let (down, down_slope) = modified_sine((turn - rise - dwell) / fall);
            (0.02 * (up - down), 0.02 * speed * (up_slope / rise - down_slope / fall))
        };
        let rate = |t: f64, y: [f64; 2]| {
            let (lift, slope) = cam(t);
            let push = contact(stiffness, damping, lift - y[0], slope - y[1]);
            [y[1], (push - 1e4 * (y[0] + 0.03) - 5.0 * y[1]) / 0.5]
        };
        let steps = 400_000;
        let h = until / f64::from(steps);
        let mut y = [-2.97e-4, 0.0];
        for k in 0..steps {
            let t = h * f64::from(k);
            let ahead = |r: [f64; 2], h: f64| [y[0] + h * r[0], y[1] + h * r[1]];
            let a = rate(t, y);
            let b = rate(t + h / 2.0, ahead(a, h / 2.0));
            let c = rate(t + h / 2.0, ahead(b, h / 2.0));
            let d = rate(t + h, ahead(c, h));
            let mean = [0, 1].map(|i| (a[i] + 2.0 * (b[i] + c[i]) + d[i]) / 6.0);
            y = ahead(mean, h);
        }
        let error = (run.last("lift").expect("an output") - y[0]).abs();
        assert!(error < 2e-9, "{speed}: {error:e}");
        let forces = column(&run, "force");
        assert!(forces.iter().all(|force| *force >= 0.0), "{speed}: it pulls");
        lifted += usize::from(forces.contains(&0.0));
        let profile = off(&run, "profile", |t| cam(t).0);
        assert!(profile < 1e-12, "{speed}: {profile:e}");
    }
    assert!((2..=4).contains(&lifted), "{lifted} of 5 lift off");
}

#[test]
fn a_cam_by_a_table_is_the_cam_of_its_law_turn_after_turn() {
    let scene = example("rotational/table_cam", Keep::All);
    for method in [Method::Dop853, Method::Tsit5, Method::Radau, Method::Auto] {
        let run = Simulation::new(&scene).method(method).rtol(1e-6).until(0.15).run();
        let run = run.unwrap_or_else(|error| panic!("{method}: {error}"));
        // The table has a row each five degrees.
        let error = off(&run, "profile", |t| 0.01 * law(PI + 100.0 * t).0);
        assert!(error < 1e-3, "{method}: {error:e}");
        assert!(column(&run, "force").iter().all(|force| *force >= 0.0), "{method}: it pulls");
    }
}

/// Returns the work of the load within half its width about the middle, by Simpson's rule.
fn work(width: f64, until: f64) -> f64 {
    let base = 1.0 - f64::cos(width);
    let torque = |angle: f64| {
        let way = ((angle.cos() - f64::cos(width)) / base).clamp(0.0, 1.0);
        100.0 * way.powi(3) * (10.0 - 15.0 * way + 6.0 * way * way)
    };
    let step = (until + width) / 400.0;
    let panel = |k: i32| {
        let start = f64::from(k) * step - width;
        let middle = torque(start + 0.5 * step);
        (torque(start) + 4.0 * middle + torque(start + step)) * step / 6.0
    };
    (0..400).map(panel).sum()
}

/// J w^2/2 falls by the work of the load, turn after turn; none is stepped over, however short.
#[test]
fn a_load_at_an_angle_takes_its_work_from_the_flywheel() {
    let scene = example("sources/crank_load", Keep::All);
    let methods = [
        Method::Dop853,
        Method::Auto,
        Method::Taylor,
        Method::Tsit5,
        Method::Radau,
        Method::Rodas5p,
    ];
    for (number, method) in methods.into_iter().enumerate() {
        for (width, until) in [(2e-3, 3.0), (0.02, 3.0), (0.1, 3.0), (0.5, 2.0), (3.0, 0.5)] {
            let place = [3.0, -2.0, 0.5][number % 3];
            let idle = if width < 0.1 { 0.0 } else { 1.0 };
            let set = [("load.place", place), ("load.width", width), ("load.idle_torque", idle)];
            let simulation = set.into_iter().try_fold(
                Simulation::new(&scene).method(method).rtol(1e-9).until(until).points(2),
                |run, (name, value)| run.parameter(name, value),
            );
            let run = simulation.expect("parameters").run().expect("it runs");
            let last = |name: &str| run.last(name).expect("an output");
            let [angle, speed] = [last("angle"), last("speed")];
            let first = if place - width < 0.0 { place + TAU } else { place };
            let turns = ((angle - first + width) / TAU).floor();
            let since = angle - first - turns * TAU;
            let begun = work(width, -width + 1e-12).max(0.0);
            let early =
                if place.abs() < width { work(width, width) - work(width, -place) } else { 0.0 };
            let done = turns * work(width, width) + work(width, since.min(width)) - begun + early;
            let left = 1.5 * speed * speed;
            let lost = 600.0 - left - idle * angle;
            let case = format!("{width}, {method}: {lost}, not {done}");
            assert!((lost - done).abs() < 1e-3 * done, "{case}");
        }
    }
    let still = run(&scene, &[("load.peak_torque", 0.0)], &[]);
    assert!(off(&still, "speed", |_| 20.0) < 1e-12);
}

/// y'' = W^2 (s - y) of the chain's way y at the load, which is driven by s = r w t + A sin(z w t).
#[test]
fn a_chain_shakes_its_load_by_its_polygon() {
    let scene = example("rotational/chain", Keep::Needed);
    for (teeth, pitch) in [(8.0, 0.05), (17.0, 0.0127), (40.0, 0.01)] {
        for stiffness in [1e4, 1e6] {
            for polygon in [0.0, 1.0] {
                // The other sprocket is all but round.
                let set = [
                    ("chain.teeth_a", teeth),
                    ("chain.teeth_b", 3000.0),
                    ("chain.pitch", pitch),
                    ("chain.stiffness", stiffness),
                    ("chain.damping", 0.0),
                    ("chain.polygon", polygon),
                    ("loaded", teeth * 10.0 / 3000.0),
                    ("load.inertia", 2e3 * pitch * pitch * 1e3),
                ];
                let run = run(&scene, &set, &[]);
                let radius = 3000.0 * pitch / TAU;
                let own = (stiffness * radius * radius / (2e6 * pitch * pitch)).sqrt();
                let (meshing, size) =
                    (10.0 * teeth, polygon * pitch / (PI * (teeth * teeth - 1.0)));
                let forced = size * own * own / (own * own - meshing * meshing);
                let free = -forced * meshing / own;
                let mean = teeth * 10.0 / 3000.0;
                let exact = |t: f64| {
                    let shaken = forced * meshing * (meshing * t).cos();
                    mean + (shaken + free * own * (own * t).cos()) / radius
                };
                let error = off(&run, "load", exact);
                assert!(error < 1e-5, "{teeth}, {stiffness}, {polygon}: {error:e}");
            }
        }
    }
}

/// The force that holds a load by a rope about a drum may be smaller by a factor up to e^(friction
/// wrap).
#[test]
fn a_rope_about_a_drum_slides_where_euler_and_eytelwein_say() {
    let scene = example("translational/capstan", Keep::Needed);
    for (number, method) in METHODS.into_iter().enumerate() {
        for (friction, wrap) in [(0.3, PI), (0.1, 8.0), (0.4, 3.0), (0.8, TAU)] {
            let rtol = [1e-9, 1e-7][number % 2];
            let run = Simulation::new(&scene)
                .parameter("rope.friction", friction)
                .and_then(|run| run.parameter("rope.wrap", wrap))
                .expect("parameters")
                .method(method)
                .rtol(rtol)
                .run()
                .unwrap_or_else(|error| panic!("{friction}, {wrap}, {method}: {error}"));
            let ratio = f64::exp(friction * wrap);
            // The hand's pull falls slowly: k x = F but for 1e-3 of it, and what it swings.
            let breaks = run.switches.iter().find(|switch| switch.event == "rope.breaks_forth");
            let slides = breaks.expect("it slides").time;
            let way = 0.5 * slides;
            let held = 250.0 * (1.0 - way.powi(3) * (10.0 - 15.0 * way + 6.0 * way * way));
            let case = format!("{friction}, {wrap}, {method}: {held} at {slides}");
            assert!((held - 500.0 / ratio).abs() < 0.2, "{case}");
            for (row, time) in run.times.iter().enumerate() {
                let [pull, held, load] =
                    ["pull", "held", "load"].map(|name| column(&run, name)[row]);
                if *time < slides {
                    let off = (load - 0.025).abs().max((pull - 500.0).abs() / 2e4);
                    assert!(off < 1e3 * rtol, "{case}: it creeps at {time}");
                } else if *time > slides + 0.05 {
                    // All but what speeds up the rope itself, of 0.1 kg.
                    assert!((pull - ratio * held).abs() < 2.0, "{case}: {pull}, {held} at {time}");
                }
                assert!(pull >= 0.0 && held >= 0.0, "{case}: it pushes");
            }
        }
    }
}
