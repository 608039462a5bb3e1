//! Parts that lose power: lossy gears, slipping parts, bristles and oil.

use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;

use super::{METHODS, column, example, off, run, time_of};
use crate::own_scene::of_text;

const GEAR: &str = r#"
[scene]
name = "lossy"

[units.motor]
unit = "rotational/inertia"
parameters = { inertia = 0.1 }

[units.gear]
unit = "rotational/lossy_gear"

[units.drum]
unit = "rotational/inertia"
parameters = { inertia = 2 }

[units.drive]
unit = "sources/torque"
inputs = { torque = "pull" }

[units.weight]
unit = "sources/torque"
inputs = { torque = "-load" }

[[joints]]
connect = ["drive.a", "motor.a"]
[[joints]]
connect = ["motor.b", "gear.a"]
[[joints]]
connect = ["gear.b", "drum.a"]
[[joints]]
connect = ["weight.a", "drum.b"]

[parameters]
pull = { value = 1.0, unit = "N m" }
load = { value = 0.0, unit = "N m" }
turned = { value = 0.0, unit = "rad" }
motor_speed = { value = 0.0, unit = "rad/s" }
drum_speed = { value = 0.0, unit = "rad/s" }

[initial]
"motor.phi" = "turned"
"motor.omega" = "motor_speed"
"drum.omega" = "drum_speed"

[outputs]
motor = "motor.omega"
drum = "drum.omega"
angle = "motor.phi"
height = "drum.phi"
torque_a = "gear.torque_a"
torque_b = "gear.torque_b"
loss = "gear.loss"

[run]
until = 2.0
points = 41
rtol = 1e-8
method = "dop853"
"#;

/// Begun with the mesh pressed as it stays, both sides speed up evenly; what arrives is by the
/// efficiency of the side that drives.
#[test]
fn what_a_lossy_gear_transmits_is_by_its_efficiency_in_both_directions() {
    let scene = of_text(GEAR, Keep::Needed);
    let mut count = 0;
    for (efficiency, back_efficiency) in [(0.3, 0.9), (0.95, 0.4), (0.5, -0.7), (1.0, 1.0)] {
        for ratio in [0.2, 20.0, -5.0] {
            for (direction, mesh) in [(1.0, 5.0), (1.0, -40.0), (-1.0, 7.0), (-1.0, -0.3)] {
                let method = METHODS[count % METHODS.len()];
                let rtol = [1e-8, 1e-10][count % 2];
                count += 1;
                let drives = mesh / ratio * direction > 0.0;
                let share = if drives { 1.0 / efficiency } else { back_efficiency };
                // What locks itself jams where its own side is light: it moves no more evenly.
                if share / (0.1 * ratio * ratio) + 0.5 < 0.0 {
                    continue;
                }
                // Speeds up in its direction.
                let (start, gain) = (3.0 * direction, 0.7 * direction);
                let pull = 0.1 * gain + mesh / ratio * share;
                let run = [
                    ("gear.ratio", ratio),
                    ("gear.efficiency", efficiency),
                    ("gear.back_efficiency", back_efficiency),
                    ("pull", pull),
                    ("load", mesh - 2.0 * gain / ratio),
                    ("turned", ratio * mesh / 1e5),
                    ("motor_speed", start),
                    ("drum_speed", start / ratio),
                ]
                .into_iter()
                .try_fold(Simulation::new(&scene), |run, (name, value)| run.parameter(name, value))
                .expect("parameters")
                .method(method)
                .rtol(rtol)
                .with_energy_balance(true)
                .run();
                let case = format!("{efficiency}, {back_efficiency}, {ratio}, {mesh}, {method}");
                let run = run.unwrap_or_else(|error| panic!("{case}: {error}"));
                let motor = |t: f64| start + gain * t;
                let errors = [off(&run, "motor", motor), off(&run, "drum", |t| motor(t) / ratio)];
                assert!(errors.iter().all(|e| *e < 2e3 * rtol), "{case}: {errors:?}");
                for row in 0..run.times.len() {
                    let at = |name: &str| column(&run, name)[row];
                    let taken = -at("torque_a") * at("motor");
                    let given = at("torque_b") * at("drum");
                    let most = 1e4 * rtol * taken.abs().max(given.abs());
                    assert!((taken - share * given).abs() < most, "{case}: {taken}, {given}");
                }
                let balance = run.energy_balance.as_ref().expect("asked for");
                let lost = balance.dissipated.last().expect("rows");
                let exact = (mesh / ratio * (share - 1.0)).abs() * (2.0 * 3.0 + 2.0 * 0.7);
                assert!((lost - exact).abs() < 1e4 * rtol * (1.0 + exact), "{case}: {lost}");
                assert!(balance.max_residual_relative() < 1e3 * rtol, "{case}");
            }
        }
    }
}

#[test]
fn a_rigid_lossy_gear_passes_on_its_efficiency_from_either_side() {
    let gear = of_text(&GEAR.replace("lossy_gear", "rigid_lossy_gear"), Keep::All);
    let mut sides = [0; 2];
    for ratio in [-8.0, 0.3, 1.0, 25.0] {
        for efficiency in [0.3, 0.8, 1.0] {
            for (speed, pull, load) in [
                (5.0, 3.0, 1.0),
                (5.0, -3.0, -2.0),
                (-5.0, 3.0, 1.0),
                (-5.0, -3.0, 1.0),
                (5.0, 0.1, 9.0),
            ] {
                let run = [
                    ("gear.ratio", ratio),
                    ("gear.efficiency", efficiency),
                    ("gear.back_efficiency", 0.7 * efficiency),
                    ("motor.inertia", 0.8),
                    ("drum.inertia", 30.0),
                    ("motor_speed", ratio * speed),
                    ("drum_speed", speed),
                    ("pull", pull),
                    ("load", load),
                ]
                .into_iter()
                .try_fold(Simulation::new(&gear), |run, (name, value)| run.parameter(name, value))
                .expect("parameters")
                .until(0.01)
                .points(11)
                .rtol(1e-9)
                .method(Method::Auto)
                .run()
                .expect("it runs");
                let at = |name: &str| column(&run, name)[5];
                let (into, out) = (-at("torque_a") * at("motor"), at("torque_b") * at("drum"));
                let case = format!("{ratio} {efficiency} {speed} {pull} {load}: {into} {out}");
                let forward = into > 0.0;
                sides[usize::from(forward)] += 1;
                let passed =
                    if forward { out - efficiency * into } else { into - 0.7 * efficiency * out };
                assert!(passed.abs() < 1e-12 * into.abs().max(out.abs()), "{case}");
                let loss = at("loss");
                assert!((into - out - loss).abs() < 1e-12 * into.abs().max(1.0), "{case}: {loss}");
            }
        }
    }
    assert!(sides.iter().all(|count| *count > 10), "{sides:?}");
}

#[test]
fn a_gear_that_locks_itself_holds_its_load_and_another_lets_it_fall() {
    let scene = of_text(GEAR, Keep::Needed);
    for (number, back_efficiency) in [-2.0, -1e-3, 1e-3, 0.5].into_iter().enumerate() {
        for load in [-30.0, 1.0, 400.0] {
            for method in [METHODS[number], METHODS[number + 1]] {
                let set = [
                    ("gear.ratio", 20.0),
                    ("gear.back_efficiency", back_efficiency),
                    ("pull", 0.0),
                    ("load", load),
                    ("turned", 20.0 * load / 1e5),
                ];
                let run = set
                    .into_iter()
                    .try_fold(Simulation::new(&scene), |run, (name, value)| {
                        run.parameter(name, value)
                    })
                    .expect("parameters")
                    .method(method)
                    .rtol(1e-9)
                    .run()
                    .unwrap_or_else(|error| panic!("{set:?} {method}: {error}"));
                let case = format!("{back_efficiency}, {load}, {method}");
                // J_a r a = -M e/r, J_b a = M - L.
                let share = back_efficiency.max(0.0);
                let gain = -load * share / 20.0 / (0.1 * 20.0 + 2.0 * share / 20.0);
                let drum = run.last("drum").expect("an output");
                let allowed = if back_efficiency < 0.0 {
                    1e-6 * load.abs()
                } else {
                    1e-4 * (gain * 2.0).abs()
                };
                // Let go it swings on the mesh.
                let swing =
                    if back_efficiency < 0.0 { 0.0 } else { load.abs() / (1e5f64 * 2.0).sqrt() };
                assert!((drum - 2.0 * gain).abs() <= allowed + swing, "{case}: {drum}, {gain}");
                if back_efficiency < 0.0 {
                    let still = column(&run, "motor").iter().all(|w| w.abs() < 1e-13);
                    assert!(still, "{case}: it creeps");
                }
            }
        }
    }
    // What swings on the mesh does not turn a worm: a load let go on it.
    let set = [("gear.ratio", 20.0), ("gear.back_efficiency", -0.5), ("pull", 0.0), ("load", 50.0)];
    let run = run(&scene, &[&set[..], &[("gear.damping", 0.0)]].concat(), &[]);
    let frequency = f64::sqrt(1e5 / 2.0);
    let error = off(&run, "height", |t| 5e-4 * ((frequency * t).cos() - 1.0));
    assert!(error < 1e-5, "{error:e}");
    assert!(column(&run, "motor").iter().all(|w| w.abs() < 1e-13), "it creeps");
}

/// Returns two rotors on a slipping part, the first with a growing torque.
fn pulled(unit: &str, outputs: &str) -> String {
    format!(
        r#"
        [scene]
        name = "pulled"
        [units.drive]
        unit = "sources/torque"
        inputs = {{ torque = "slope*t" }}
        [units.motor]
        unit = "rotational/inertia"
        [units.part]
        unit = "{unit}"
        [units.load]
        unit = "rotational/inertia"
        [[joints]]
        connect = ["drive.a", "motor.a"]
        [[joints]]
        connect = ["motor.b", "part.a"]
        [[joints]]
        connect = ["part.b", "load.a"]
        [parameters]
        slope = {{ value = 1.0, unit = "N m/s" }}
        [outputs]
        motor = "motor.omega"
        load = "load.omega"
        {outputs}
        [run]
        until = 1.0
        points = 41
        rtol = 1e-9
        method = "dop853"
        "#
    )
}

#[test]
fn a_torque_limiter_and_a_belt_slip_exactly_when_they_should() {
    let limiter =
        of_text(&pulled("rotational/torque_limiter", "torque = \"part.torque\""), Keep::Needed);
    let belt = of_text(
        &pulled(
            "rotational/slipping_belt",
            "pull = \"part.pull\"\ntight = \"part.tight\"\nslack = \"part.slack\"",
        ),
        Keep::Needed,
    );
    let mut count = 0;
    for inertia in [1e-2, 1.0, 300.0] {
        for load in [0.05, 8.0] {
            for slope in [-20.0, 0.5, 1e4] {
                let method = METHODS[count % METHODS.len()];
                count += 1;
                let common = [("motor.inertia", inertia), ("load.inertia", load), ("slope", slope)];
                let run_until = |scene, own: &[(&str, f64)], end: f64| {
                    common
                        .iter()
                        .chain(own)
                        .try_fold(Simulation::new(scene), |run, (name, value)| {
                            run.parameter(name, *value)
                        })
                        .expect("parameters")
                        .method(method)
                        .until(end)
                        .with_energy_balance(true)
                        .run()
                        .unwrap_or_else(|error| panic!("{common:?} {method}: {error}"))
                };
                let sign = f64::signum(slope);
                let event = if slope > 0.0 { "part.breaks_back" } else { "part.breaks_forth" };
                let case = format!("{inertia}, {load}, {slope}, {method}");
                for (limit, peak) in [(0.2, 1.0), (5.0, 1.4)] {
                    // Of the torque the load takes its share.
                    let slips = peak * limit * (inertia + load) / (load * slope.abs());
                    let own = [("part.limit", limit), ("part.peak", peak)];
                    let run = run_until(&limiter, &own, 2.0 * slips);
                    let found = time_of(&run, event);
                    assert!((found - slips).abs() < 1e-8 * slips, "{case}: {found}, not {slips}");
                    let together = slope * slips * slips / (2.0 * (inertia + load));
                    let exact = together + sign * limit * slips / load;
                    let last = run.last("load").expect("an output");
                    assert!((last - exact).abs() < 1e-7 * exact.abs(), "{case}: {last}, {exact}");
                    let own = 1.5 * slope * slips * slips - sign * limit * slips;
                    let exact = together + own / inertia;
                    let last = run.last("motor").expect("an output");
                    assert!((last - exact).abs() < 1e-7 * exact.abs(), "{case}: {last}, {exact}");
                }
                for (pretension, friction, wrap) in [(100.0, 0.5, 2.8), (3e3, 0.1, 1.0)] {
                    let grip = f64::exp(friction * wrap);
                    // T_1 - T_2 of T_1 + T_2 = 2 F and T_1 = grip T_2.
                    let limit = 2.0 * pretension * (grip - 1.0) / (grip + 1.0);
                    // w_b = w_a/3; the rim of b is at 0.15 m.
                    let whole = inertia + load / 9.0;
                    let slips = limit * 0.15 * 3.0 * whole / (load * slope.abs());
                    let own = [
                        ("part.pretension", pretension),
                        ("part.friction", friction),
                        ("part.wrap", wrap),
                    ];
                    let run = run_until(&belt, &own, 1.5 * slips);
                    let found = time_of(&run, event);
                    assert!((found - slips).abs() < 1e-8 * slips, "{case}: {found}, not {slips}");
                    let strands = ["tight", "slack"].map(|name| run.last(name).expect("an output"));
                    let off = (strands[0] / strands[1] / grip - 1.0).abs();
                    assert!(off < 1e-9, "{case}: {strands:?}");
                    let exact = (slope * slips * slips / 2.0 / whole).abs() / 3.0
                        + 0.5 * limit * 0.15 * slips / load;
                    let last = run.last("load").expect("an output").abs();
                    assert!((last - exact).abs() < 1e-7 * exact, "{case}: {last}, {exact}");
                    let balance = run.energy_balance.as_ref().expect("asked for");
                    assert!(balance.max_residual_relative() < 1e-7, "{case}");
                }
            }
        }
    }
}

const BRISTLES: &str = r#"
[scene]
name = "bristles"
[units.drive]
unit = "sources/linear_speed"
inputs = { speed = "given" }
[units.guide]
unit = "translational/lugre_friction"
[[joints]]
connect = ["drive.a", "guide.a"]
[parameters]
given = { value = 0.01, unit = "m/s" }
[initial]
"drive.x_dot" = "given"
[outputs]
bending = "guide.bending"
drag = "guide.drag"
[run]
until = 1.0
points = 101
rtol = 1e-9
method = "auto"
"#;

/// z = z_s (1 - e^(-k v t/g)), and what it settles at is Stribeck's law.
#[test]
fn bristles_bend_and_slide_at_a_constant_speed_as_their_closed_form() {
    let scene = of_text(BRISTLES, Keep::Needed);
    for (number, given) in [-1.0, -3e-3, 1e-5, 1e-3, 0.02, 5.0].into_iter().enumerate() {
        for stiffness in [300.0, 1e4, 1e6] {
            let method = [Method::Auto, Method::Radau, Method::Rodas5p][number % 3];
            let simulation = Simulation::new(&scene)
                .parameter("given", given)
                .and_then(|run| run.parameter("guide.stiffness", stiffness))
                .expect("parameters");
            let run = simulation.method(method).run().expect("it runs");
            let law = 1.0 + 0.5 * (-f64::powi(given / 0.01, 2)).exp();
            let (rate, settled) =
                (stiffness * f64::abs(given) / law, law / stiffness * given.signum());
            let bending = |t: f64| -settled * (-rate * t).exp_m1();
            let drag = |t: f64| {
                stiffness * bending(t) + 100.0 * settled * rate * (-rate * t).exp() + 0.4 * given
            };
            // A bending of 1e-4 is of size 1.
            let errors = [off(&run, "bending", bending), off(&run, "drag", drag)];
            let allowed = 1e-5 + 1e-12 / settled.abs();
            assert!(errors.iter().all(|e| *e < allowed), "{given}, {stiffness}: {errors:?}");
        }
    }
}

#[test]
fn bristles_far_from_sliding_are_a_spring_with_a_damper() {
    for (folder, body, speed) in
        [("rotational", "inertia", "omega"), ("translational", "mass", "v")]
    {
        let scene = of_text(
            &format!(
                r#"
                [scene]
                name = "far_from_sliding"
                [units.body]
                unit = "{folder}/{body}"
                [units.bristles]
                unit = "{folder}/lugre_friction"
                parameters = {{ coulomb = 1e10, viscous = 2 }}
                [[joints]]
                connect = ["body.a", "bristles.a"]
                [initial]
                "body.{speed}" = 1
                [outputs]
                speed = "body.{speed}"
                [run]
                until = 0.5
                points = 101
                rtol = 1e-9
                method = "auto"
                "#
            ),
            Keep::Needed,
        );
        for stiffness in [1e3, 1e5] {
            for damping in [0.0, 10.0, 50.0] {
                let set = [("bristles.stiffness", stiffness), ("bristles.damping", damping)];
                let run = run(&scene, &set, &[]);
                let decay = 0.5 * (damping + 2.0);
                let frequency = f64::sqrt(stiffness - decay * decay);
                let error = off(&run, "speed", |t| {
                    let (sin, cos) = (frequency * t).sin_cos();
                    (-decay * t).exp() * (cos - decay / frequency * sin)
                });
                assert!(error < 1e-6, "{folder}, {stiffness}, {damping}: {error:e}");
            }
        }
    }
}

/// Which side is faster does not matter: no torque is lost, and power only that of the slip.
#[test]
fn a_fluid_coupling_is_alike_from_both_sides() {
    let scene = of_text(
        r#"
        [scene]
        name = "both_sides"
        [units.left]
        unit = "rotational/inertia"
        [units.coupling]
        unit = "rotational/fluid_coupling"
        [units.right]
        unit = "rotational/inertia"
        [[joints]]
        connect = ["left.b", "coupling.a"]
        [[joints]]
        connect = ["coupling.b", "right.a"]
        [initial]
        "left.omega" = 100
        [outputs]
        left = "left.omega"
        right = "right.omega"
        [run]
        until = 3.0
        points = 31
        rtol = 1e-9
        method = "auto"
        "#,
        Keep::All,
    );
    for other in [-100.0, -30.0, 60.0] {
        let there = run(&scene, &[], &[("right.omega", other)]);
        let back = run(&scene, &[], &[("left.omega", other), ("right.omega", 100.0)]);
        for row in 0..there.times.len() {
            let [left, right] = ["left", "right"].map(|name| column(&there, name)[row]);
            let mirrored = ["right", "left"].map(|name| column(&back, name)[row]);
            assert!((left + right - 100.0 - other).abs() < 1e-6, "{other}: {left}, {right}");
            let off = (left - mirrored[0]).abs().max((right - mirrored[1]).abs());
            assert!(off < 1e-6, "{other}: {off:e}");
        }
        let slips = ["left", "right"].map(|name| there.last(name).expect("an output"));
        assert!(slips[0] > slips[1] - 1e-9, "{other}: it overshoots");
    }
}

/// J u' = -S u (c w + q u) for the slip speed u: Bernoulli's equation.
#[test]
fn a_fluid_coupling_starts_a_load_as_its_closed_form() {
    let scene = example("rotational/fluid_coupling", Keep::Needed);
    for (number, quadratic) in [-0.0045, -0.003, 0.0, 0.02].into_iter().enumerate() {
        for inertia in [0.5, 20.0, 3e3] {
            for diameter in [0.1, 0.6] {
                let size = 870.0 * f64::powi(diameter, 5);
                let method = METHODS[number];
                let run = Simulation::new(&scene)
                    .parameter("coupling.quadratic", quadratic)
                    .and_then(|run| run.parameter("load.inertia", inertia))
                    .and_then(|run| run.parameter("coupling.diameter", diameter))
                    .expect("parameters")
                    .method(method)
                    .rtol(1e-10)
                    .run()
                    .unwrap_or_else(|error| panic!("{quadratic}, {inertia}: {error}"));
                let (a, b) = (size * 0.005 * 150.0 / inertia, size * quadratic / inertia);
                let slip = |t: f64| {
                    let gone = (-a * t).exp();
                    150.0 * a * gone / (a + b * 150.0 * (1.0 - gone))
                };
                let error = off(&run, "speed", |t| 150.0 - slip(t));
                assert!(error < 1e-7, "{quadratic}, {inertia}, {diameter}, {method}: {error:e}");
            }
        }
    }
}
