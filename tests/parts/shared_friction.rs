//! Several friction parts that stick on one shaft: the distribution of forces is a choice, the
//! motion is not.

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use super::{METHODS, column, time_of};
use crate::own_scene::of_text;

/// Returns brakes of 5 N m, 10 N m and so on, on a rotor of 2 kg m^2 driven by a torque that grows
/// by 3 N m/s.
fn brakes(count: usize, parameters: &str) -> ModelSimulator {
    let units = (1..=count).map(|k| {
        format!(
            "[units.brake_{k}]\nunit = \"rotational/brake\"\nparameters = {{ {parameters} }}\n\
             inputs = {{ normal_force = \"{}*1 [N]\" }}\n\
             [[joints]]\nconnect = [\"rotor.b\", \"brake_{k}.a\"]\n",
            10 * k
        )
    });
    let outputs = (1..=count).map(|k| format!("torque_{k} = \"brake_{k}.torque\"\n"));
    let text = format!(
        r#"
        [scene]
        name = "brakes"
        [units.rotor]
        unit = "rotational/inertia"
        parameters = {{ inertia = 2 }}
        [units.drive]
        unit = "sources/torque"
        inputs = {{ torque = "slope*t" }}
        [parameters]
        slope = {{ value = 3.0, unit = "N m/s" }}
        [[joints]]
        connect = ["drive.a", "rotor.a"]
        {}
        [outputs]
        speed = "rotor.omega"
        {}
        [run]
        until = 12.0
        points = 121
        rtol = 1e-9
        method = "dop853"
        "#,
        units.collect::<String>(),
        outputs.collect::<String>()
    );
    of_text(&text, Keep::Needed)
}

fn run(scene: &ModelSimulator, slope: f64, method: Method, rtol: f64) -> Trajectory {
    let run = Simulation::new(scene).parameter("slope", slope).expect("known");
    let run = run.method(method).rtol(rtol).max_steps(20_000).with_energy_balance(true).run();
    run.unwrap_or_else(|error| panic!("{slope}, {method} at {rtol:e}: {error}"))
}

/// The first lets go where the torque is its own, and gives that from then on; the next takes the
/// rest. All of them together slip where the torque is the sum of all: 2 omega' = 3 t - sum.
#[test]
fn parallel_brakes_hold_until_the_sum_of_their_torques() {
    for count in [2, 3] {
        let scene = brakes(count, "");
        let capacity = |k: usize| 5.0 * k as f64;
        let sum: f64 = (1..=count).map(capacity).sum();
        for slope in [3.0, -4.0] {
            for method in METHODS {
                let run = run(&scene, slope, method, 1e-8);
                let what = format!("{count} brakes, {slope}, {method}");
                let slips = sum / f64::abs(slope);
                let mut lets_go = 0.0;
                for k in 1..=count {
                    let way = if slope > 0.0 { "forth" } else { "back" };
                    lets_go += capacity(k) / f64::abs(slope);
                    let found = time_of(&run, &format!("brake_{k}.breaks_{way}"));
                    assert!((found - lets_go).abs() < 1e-7, "{what}: {k} at {found}");
                }
                for (row, time) in run.times.iter().enumerate() {
                    let speed = column(&run, "speed")[row];
                    let after = (time - slips).max(0.0);
                    let exact = slope * after * after / 4.0;
                    assert!((speed - exact).abs() < 1e-6, "{what}: {speed} at {time}");
                    let mut carried = 0.0;
                    for k in 1..=count {
                        let torque = column(&run, &format!("torque_{k}"))[row];
                        let within = torque.abs() <= capacity(k) * (1.0 + 1e-9) + 1e-7;
                        assert!(within, "{what}: {torque} of {k} at {time}");
                        carried += torque;
                    }
                    let wanted = f64::clamp(slope * time, -sum, sum);
                    assert!((carried + wanted).abs() < 1e-6, "{what}: {carried} at {time}");
                }
                let told = run.notes.iter().filter(|note| note.contains("whoever carries"));
                assert!(told.count() >= count - 1, "{what}: {:?}", run.notes);
                let balance = run.energy_balance.as_ref().expect("asked for");
                assert!(balance.max_residual_relative() < 1e-6, "{what}");
            }
        }
    }
}

/// The first has let go, and slides by no more than its sliding torque, before the next is loaded
/// in full: break-away torques do not add up.
#[test]
fn of_break_away_torques_only_the_last_counts() {
    let scene = brakes(2, "peak = 1.5");
    let run = run(&scene, 3.0, Method::Auto, 1e-9);
    assert!((time_of(&run, "brake_1.breaks_forth") - 7.5 / 3.0).abs() < 1e-7);
    let slips = (5.0 + 1.5 * 10.0) / 3.0;
    assert!((time_of(&run, "brake_2.breaks_forth") - slips).abs() < 1e-7);
    for (time, speed) in run.times.iter().zip(column(&run, "speed")) {
        let after = (time - slips).max(0.0);
        // It starts with a jump from 20 N m to 15 N m.
        let exact = 0.75 * after * after + 2.5 * after;
        assert!((speed - exact).abs() < 1e-6, "{speed} for {exact} at {time}");
    }
}

/// A torque that swings: the brake that has let go is at its limit while the other holds, and
/// comes back.
#[test]
fn parallel_brakes_hold_a_torque_that_swings_between_their_limits() {
    let text = r#"
        [scene]
        name = "swings"
        [units]
        first = { unit = "rotational/brake", inputs = { normal_force = "16 [N]" } }
        second = { unit = "rotational/brake", inputs = { normal_force = "10 [N]" } }
        rotor = { unit = "rotational/inertia" }
        drive = { unit = "sources/torque", inputs = { torque = "size*sin(5 [rad/s]*t)" } }
        [parameters]
        size = { value = 12.0, unit = "N m" }
        [[joints]]
        connect = ["drive.a", "rotor.a"]
        [[joints]]
        connect = ["rotor.b", "first.a"]
        [[joints]]
        connect = ["rotor.b", "second.a"]
        [outputs]
        speed = "rotor.omega"
        first = "first.torque"
        second = "second.torque"
        [run]
        until = 10.0
        points = 401
        rtol = 1e-8
        method = "dop853"
    "#;
    let scene = of_text(text, Keep::Needed);
    for method in METHODS {
        for rtol in [1e-4, 1e-8] {
            for size in [7.9, 8.1, 12.0, 12.9] {
                let what = format!("{method} at {rtol:e}, {size}");
                let run = Simulation::new(&scene).parameter("size", size).expect("known");
                let run = run.method(method).rtol(rtol).max_steps(50_000).run();
                let run = run.unwrap_or_else(|error| panic!("{what}: {error}"));
                assert!(run.switches.len() < 200, "{what}: {} events", run.switches.len());
                for (row, time) in run.times.iter().enumerate() {
                    let at = |name: &str| column(&run, name)[row];
                    assert!(at("speed").abs() < 1e-6, "{what}: {} at {time}", at("speed"));
                    let torque = size * (5.0 * time).sin();
                    let off = at("first") + at("second") + torque;
                    assert!(off.abs() < 1e-3, "{what}: {off} at {time}");
                    assert!(at("first").abs() < 8.0 + 1e-3, "{what}: {} at {time}", at("first"));
                    assert!(at("second").abs() < 5.0 + 1e-3, "{what}: {} at {time}", at("second"));
                }
            }
        }
    }
}

/// A brake and a gear with losses that stick on one shaft: motion is the same whichever is first.
#[test]
fn a_brake_and_a_lossy_gear_on_one_shaft_move_alike_in_either_order() {
    let text = include_str!("../../specs/scenes/drives/winch.toml");
    let text = text.replace(r#"["brake.a", "wheel.a"]"#, r#"["brake.a", "gear.a"]"#);
    let text = text.replace("4e4 [N]", "2500 [N]");
    let line = |name: &str| text.lines().find(|line| line.starts_with(name)).expect("a unit");
    let [brake, gear] = ["brake = ", "gear = "].map(line);
    let both = format!("{brake}\n{gear}");
    assert!(text.contains(&both));
    let other = text.replace(&both, &format!("{gear}\n{brake}"));
    let torque = 500.0 * 9.81 * 0.25 / 20.0;
    let heights = [&text, &other].map(|text| {
        let scene = of_text(text, Keep::Needed);
        let run = Simulation::new(&scene).rtol(1e-9).max_steps(30_000).run();
        let run = run.unwrap_or_else(|error| panic!("{error}"));
        assert!(run.notes.iter().any(|note| note.contains("whoever carries")), "{:?}", run.notes);
        for (time, held) in run.times.iter().zip(column(&run, "holding")) {
            // As far as the gear may be tight: it may hold, or press, with what it loses.
            let room = 0.2 * torque + 1.0;
            assert!(*time < 8.0 || (held - torque).abs() < room, "{held} at {time}");
        }
        column(&run, "height").to_vec()
    });
    let apart = heights[0].iter().zip(&heights[1]).map(|(a, b)| (a - b).abs());
    let apart = apart.fold(0.0, f64::max);
    assert!(apart < 1e-5, "{apart:e}");
}

/// Two brakes hold or slide together as one does that is as strong as both: through slides of
/// either that begin and end while the other holds, and however fast rounding would turn the rotor.
#[test]
fn two_brakes_on_one_rotor_move_it_as_one_brake_would() {
    let scene = |second: &str| {
        let text = format!(
            r#"
            [scene]
            name = "brakes"
            [parameters]
            size = {{ value = 1.3, unit = "N m" }}
            pace = {{ value = 3.1, unit = "rad/s" }}
            [units]
            rotor = {{ unit = "rotational/inertia", parameters = {{ inertia = 0.2 }} }}
            first = {{ unit = "rotational/brake", inputs = {{ normal_force = "1 [N]" }} }}
            {second}
            [[joints]]
            connect = ["rotor.a", "first.a"]
            [[forces]]
            port = "rotor.b"
            expression = "size*sin(pace*t)"
            [outputs]
            speed = "rotor.omega"
            [run]
            until = 20.0
            points = 201
            "#
        );
        of_text(&text, Keep::Needed)
    };
    let both = scene(
        "second = { unit = \"rotational/brake\", inputs = { normal_force = \"1 [N]\" } }\n\
         [[joints]]\nconnect = [\"rotor.a\", \"second.a\"]",
    );
    let alone = scene("");
    let mut random = fastrand::Rng::with_seed(12);
    for round in 0..24 {
        let between = |random: &mut fastrand::Rng, least: f64, most: f64| {
            least * (most / least).powf(random.f64())
        };
        let first = between(&mut random, 0.1, 2.0);
        let second = if round % 4 == 0 { first } else { between(&mut random, 0.1, 2.0) };
        let inertia = between(&mut random, 1e-3, 20.0);
        let pace = between(&mut random, 0.1, 15.0);
        let share = if round % 2 == 0 {
            between(&mut random, 0.2, 0.999)
        } else {
            between(&mut random, 1.001, 3.0)
        };
        let method = METHODS[round % METHODS.len()];
        let rtol = [1e-6, 1e-8, 1e-10][round % 3];
        let set = [("rotor.inertia", inertia), ("size", share * (first + second)), ("pace", pace)];
        let what = format!("{first} and {second}, {set:?}, {method} at {rtol:e}");
        let run = |scene: &ModelSimulator, brakes: &[(&str, f64)], method, rtol| {
            let mut run = Simulation::new(scene);
            for (name, value) in set.iter().chain(brakes) {
                run = run.parameter(name, *value).expect("a parameter");
            }
            let run = run.method(method).rtol(rtol).max_steps(100_000).run();
            column(&run.unwrap_or_else(|error| panic!("{what}: {error}")), "speed").to_vec()
        };
        let brakes = [("first.friction", first), ("second.friction", second)];
        let found = run(&both, &brakes, method, rtol);
        let one = [("first.friction", first + second)];
        let wanted = run(&alone, &one, Method::Dop853, 1e-11);
        let fastest = wanted.iter().fold(1.0, |most: f64, speed| most.max(speed.abs()));
        for (found, wanted) in found.iter().zip(&wanted) {
            assert!(
                (found - wanted).abs() < 300.0 * rtol * fastest,
                "{what}: {found} for {wanted}"
            );
            assert!(share > 1.0 || *wanted == 0.0 || wanted.abs() < 1e-9, "{what}: {wanted}");
        }
    }
}
