//! Clutches: when they lock, slip and free, and what they lose.

use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;

use super::friction::orders;
use super::{column, example, time_of};
use crate::own_scene::of_text;

#[test]
fn a_clutch_couples_when_it_should_and_loses_what_it_must() {
    let scene = example("rotational/clutch", Keep::All);
    for load in orders(1e-2, 1e2, 5) {
        for geometry in orders(0.1, 100.0, 4) {
            let capacity = 0.5 * 100.0 * geometry;
            let reduced = 1.0 / (1.0 / 2.0 + 1.0 / load);
            let lock = 0.2 + 6.0 * reduced / capacity;
            let run = Simulation::new(&scene)
                .rtol(1e-9)
                .parameter("load.inertia", load)
                .and_then(|run| run.parameter("clutch.geometry", geometry))
                .expect("parameters")
                .until(2.0 * lock)
                .with_energy_balance(true)
                .run()
                .expect("it runs");
            let locked = time_of(&run, "clutch.ends_back");
            assert!((locked - lock).abs() < 1e-8 * lock, "{load}, {geometry}: {locked} for {lock}");
            let common = 2.0 * 6.0 / (2.0 + load);
            for name in ["motor", "load"] {
                let speed = run.last(name).expect("an output");
                assert!((speed - common).abs() < 1e-8, "{load}, {geometry}: {speed}");
            }
            let balance = run.energy_balance.as_ref().expect("asked for");
            let lost = balance.dissipated.last().expect("rows");
            let exact = 0.5 * reduced * 36.0;
            assert!((lost - exact).abs() < 1e-7 * exact, "{load}, {geometry}: {lost} for {exact}");
        }
    }
}

#[test]
fn a_clutch_that_locks_and_slips_often_loses_no_energy_it_should_not() {
    let text = r#"
        [scene]
        name = "often"
        [units.left]
        unit = "rotational/inertia"
        [units.clutch]
        unit = "rotational/clutch"
        parameters = { peak = 1.2 }
        inputs = { normal_force = "10 [N]" }
        [units.right]
        unit = "rotational/inertia"
        parameters = { inertia = 0.7 }
        [units.drive]
        unit = "sources/torque"
        inputs = { torque = "20 [N m]*sin(10 [rad/s]*t)" }
        [[joints]]
        connect = ["left.b", "clutch.a"]
        [[joints]]
        connect = ["clutch.b", "right.a"]
        [[joints]]
        connect = ["drive.a", "left.a"]
        [outputs]
        left = "left.omega"
        right = "right.omega"
        torque = "clutch.torque"
        [run]
        until = 157.07963267948966
        points = 2001
        rtol = 1e-9
        method = "dop853"
    "#;
    let scene = of_text(text, Keep::Needed);
    let run = Simulation::new(&scene).with_energy_balance(true).run().expect("it runs");
    let count = |name: &str| run.switches.iter().filter(|s| s.event.contains(name)).count();
    // Twice a period of 250 it sticks and breaks away.
    assert!(count("ends") >= 499 && count("breaks") >= 499, "{}", run.switches.len());
    let residual = run.energy_balance.as_ref().expect("asked for").max_residual_relative();
    assert!(residual < 1e-8, "{residual:e}");
    let largest = column(&run, "torque").iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    assert!(largest <= 6.0 * 1.000_001, "{largest}");
}

/// The force with which b would overtake a is prescribed in another form.
#[test]
fn a_one_way_clutch_between_imposed_motions_that_it_forbids_is_refused_by_name() {
    let text = r#"
        [scene]
        name = "forbidden"
        [units]
        a = { unit = "sources/speed", inputs = { speed = "1 [rad/s]*sin(3 [rad/s]*t)" } }
        b = { unit = "sources/speed", inputs = { speed = "0.5 [rad/s]" } }
        clutch = { unit = "rotational/one_way_clutch", inputs = { drag = "1 [N m]" } }
        [[joints]]
        connect = ["a.a", "clutch.a"]
        [[joints]]
        connect = ["b.a", "clutch.b"]
        [run]
        until = 5.0
        points = 11
        rtol = 1e-8
        method = "dop853"
    "#;
    let scene = of_text(text, Keep::All);
    let error = Simulation::new(&scene).run().expect_err("refused").to_string();
    let names = ["clutch.grip", "a.drive", "b.drive", "t = 0.17453"];
    assert!(names.iter().all(|name| error.contains(name)), "{error}");
}

/// Three shafts on two clutches, the last with a brake, shaken by a torque.
const TRAIN: &str = r#"
    [scene]
    name = "train"
    [units.drive]
    unit = "sources/torque"
    inputs = { torque = "pull*sin(frequency*t)" }
    [units.first]
    unit = "rotational/inertia"
    [units.near]
    unit = "rotational/clutch"
    inputs = { normal_force = "near_force" }
    [units.second]
    unit = "rotational/inertia"
    [units.far]
    unit = "rotational/clutch"
    inputs = { normal_force = "far_force" }
    [units.third]
    unit = "rotational/inertia"
    [units.brake]
    unit = "rotational/brake"
    inputs = { normal_force = "brake_force" }
    [[joints]]
    connect = ["drive.a", "first.a"]
    [[joints]]
    connect = ["first.b", "near.a"]
    [[joints]]
    connect = ["near.b", "second.a"]
    [[joints]]
    connect = ["second.b", "far.a"]
    [[joints]]
    connect = ["far.b", "third.a"]
    [[joints]]
    connect = ["third.b", "brake.a"]
    [parameters]
    pull = { value = 10.0, unit = "N m" }
    frequency = { value = 6.0, unit = "rad/s" }
    near_force = { value = 10.0, unit = "N" }
    far_force = { value = 8.0, unit = "N" }
    brake_force = { value = 4.0, unit = "N" }
    speed = { value = 3.0, unit = "rad/s" }
    [initial]
    "first.omega" = "speed"
    [outputs]
    first = "first.omega"
    second = "second.omega"
    third = "third.omega"
    [run]
    until = 2.0
    points = 41
    rtol = 1e-9
    method = "dop853"
"#;

/// The same by small steps: in each, impulses within the limits of the clutches that bring
/// sliding speeds as near to zero as they can (Gauss and Seidel's iteration, projected).
fn by_impulses(inertia: [f64; 3], limit: [f64; 3], [pull, frequency, speed]: [f64; 3]) -> [f64; 3] {
    const STEPS: usize = 8000;
    let step = 2.0 / STEPS as f64;
    let mut omega = [speed, 0.0, 0.0];
    let mut impulse = [0.0; 3];
    for number in 0..STEPS {
        let time = (number as f64 + 0.5) * step;
        omega[0] += step * pull * (frequency * time).sin() / inertia[0];
        let apply = |omega: &mut [f64; 3], contact: usize, by: f64| {
            omega[contact] -= by / inertia[contact];
            if contact < 2 {
                omega[contact + 1] += by / inertia[contact + 1];
            }
        };
        for (contact, by) in impulse.into_iter().enumerate() {
            apply(&mut omega, contact, by);
        }
        for _ in 0..60 {
            let mut largest: f64 = 0.0;
            for contact in 0..3 {
                let next = if contact < 2 { omega[contact + 1] } else { 0.0 };
                let others = if contact < 2 { 1.0 / inertia[contact + 1] } else { 0.0 };
                let wanted = (omega[contact] - next) / (1.0 / inertia[contact] + others);
                let most = step * limit[contact];
                let new = (impulse[contact] + wanted).clamp(-most, most);
                apply(&mut omega, contact, new - impulse[contact]);
                largest = largest.max((new - impulse[contact]).abs());
                impulse[contact] = new;
            }
            if largest < 1e-14 {
                break;
            }
        }
    }
    omega
}

#[test]
fn trains_of_clutches_and_a_brake_move_as_by_small_impulses() {
    let scene = of_text(TRAIN, Keep::Needed);
    let mut dice = fastrand::Rng::with_seed(7);
    let mut order = |low: f64, high: f64| low * (high / low).powf(dice.f64());
    let (mut stuck, mut wrong) = (0, Vec::new());
    for number in 0..60 {
        let inertia = [0; 3].map(|_| order(0.1, 10.0));
        let limit = [0; 3].map(|_| order(0.05, 20.0));
        let [pull, frequency, speed] = [order(0.5, 50.0), order(1.0, 30.0), order(0.01, 10.0)];
        let method = [Method::Dop853, Method::Tsit5, Method::Auto][number % 3];
        let set = [
            ("first.inertia", inertia[0]),
            ("second.inertia", inertia[1]),
            ("third.inertia", inertia[2]),
            ("near_force", 2.0 * limit[0]),
            ("far_force", 2.0 * limit[1]),
            ("brake_force", 2.0 * limit[2]),
            ("pull", pull),
            ("frequency", frequency),
            ("speed", speed),
        ];
        let simulation = Simulation::new(&scene).method(method).with_energy_balance(true);
        let simulation = set
            .iter()
            .try_fold(simulation, |run, (name, value)| run.parameter(name, *value))
            .expect("parameters");
        let run = match simulation.run() {
            Ok(run) => run,
            Err(error) => {
                wrong.push(format!("{set:?} {method}: {error}"));
                continue;
            }
        };
        stuck += run.switches.iter().filter(|switch| switch.event.contains("ends")).count();
        let exact = by_impulses(inertia, limit, [pull, frequency, speed]);
        let found = ["first", "second", "third"].map(|name| run.last(name).expect("an output"));
        let size = column(&run, "first").iter().fold(0.0, |most: f64, w| most.max(w.abs()));
        let off = found.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size;
        let residual = run.energy_balance.as_ref().expect("asked for").max_residual_relative();
        if off.is_nan() || off > 2e-3 || residual > 1e-7 {
            wrong.push(format!("{set:?} {method}: {found:?} for {exact:?}, balance {residual:e}"));
        }
    }
    assert!(wrong.is_empty(), "{} of 60:\n{}", wrong.len(), wrong.join("\n"));
    assert!(stuck > 200, "only {stuck} times did anything stick");
}

#[test]
fn a_clutch_that_sticks_takes_a_motion_from_the_modes() {
    use machinist::linear_analysis::{Linearization, ModeKind, Place, operating_point};
    let text = |slip: i32, normal_force: f64| {
        format!(
            r#"
            [scene]
            name = "held"
            [units.wall]
            unit = "rotational/fixed"
            [units.spring]
            unit = "rotational/spring"
            parameters = {{ stiffness = 100 }}
            [units.left]
            unit = "rotational/inertia"
            parameters = {{ inertia = 2 }}
            [units.clutch]
            unit = "rotational/clutch"
            inputs = {{ normal_force = "{normal_force} [N]" }}
            [units.right]
            unit = "rotational/inertia"
            parameters = {{ inertia = 3 }}
            [[joints]]
            connect = ["wall.a", "spring.a"]
            [[joints]]
            connect = ["spring.b", "left.a"]
            [[joints]]
            connect = ["left.b", "clutch.a"]
            [[joints]]
            connect = ["clutch.b", "right.a"]
            [initial]
            "clutch.slip" = {slip}
            [run]
            until = 2.0
            points = 11
            rtol = 1e-8
            method = "dop853"
            "#
        )
    };
    // Stuck, both inertias swing as one; open, the left one alone. What is pressed is not open for
    // long: a start is in modes that agree with their guards.
    for (slip, normal_force, inertia) in [(0, 10.0, 5.0), (2, 0.0, 2.0), (2, 10.0, 5.0)] {
        let scene = of_text(&text(slip, normal_force), Keep::All);
        let run = Simulation::new(&scene);
        let point = operating_point(&run, Place::Initial).expect("a state");
        let modes = Linearization::at(&scene, point).expect("regular").modes().expect("modes");
        let swings: Vec<f64> = modes
            .iter()
            .filter(|mode| mode.kind == ModeKind::Oscillation)
            .map(machinist::linear_analysis::Mode::natural_frequency)
            .collect();
        let exact = f64::sqrt(100.0 / inertia);
        assert!(
            swings.len() == 1 && (swings[0] - exact).abs() < 1e-9 * exact,
            "slip {slip}: {swings:?}, not {exact}"
        );
    }
}

/// Returns the zero of a decreasing function, by bisection.
fn root(mut low: f64, mut high: f64, falls: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let middle = low + 0.5 * (high - low);
        if falls(middle) > 0.0 { low = middle } else { high = middle }
    }
    low
}

#[test]
fn a_one_way_clutch_frees_and_locks_when_it_should() {
    let text = r#"
        [scene]
        name = "one_way"
        [units.drive]
        unit = "sources/torque"
        inputs = { torque = "10 [N m]*sin(frequency*t)" }
        [units.motor]
        unit = "rotational/inertia"
        [units.freewheel]
        unit = "rotational/one_way_clutch"
        inputs = { drag = "drag" }
        [units.load]
        unit = "rotational/inertia"
        [[joints]]
        connect = ["drive.a", "motor.a"]
        [[joints]]
        connect = ["motor.b", "freewheel.a"]
        [[joints]]
        connect = ["freewheel.b", "load.a"]
        [parameters]
        frequency = { value = 5.0, unit = "rad/s" }
        drag = { value = 0.1, unit = "N m" }
        [outputs]
        motor = "motor.omega"
        load = "load.omega"
        [run]
        until = 1.0
        points = 41
        rtol = 1e-10
        method = "dop853"
    "#;
    let scene = of_text(text, Keep::Needed);
    for frequency in orders(0.5, 500.0, 4) {
        for load in orders(0.1, 100.0, 4) {
            for (drag, peak) in [(0.01, 1.0), (0.3, 1.0), (0.3, 2.5)] {
                // Both turn as one until the load would be held back by more than the drag.
                let share = load / (1.0 + load);
                let breakaway: f64 = drag * peak / (10.0 * share);
                if breakaway >= 0.99 {
                    continue;
                }
                let freed = (std::f64::consts::PI + breakaway.asin()) / frequency;
                let cos = |t: f64| (frequency * t).cos();
                let slips = |t: f64| {
                    let by_drive = 10.0 / frequency * (cos(t) - cos(freed));
                    by_drive - drag * (1.0 + 1.0 / load) * (t - freed)
                };
                // It runs ahead at most until the drive has turned over once more.
                let turn = std::f64::consts::TAU / frequency;
                let locked = root(freed + 0.25 * turn, freed + turn, slips);
                let run = Simulation::new(&scene)
                    .parameter("frequency", frequency)
                    .and_then(|run| run.parameter("load.inertia", load))
                    .and_then(|run| run.parameter("drag", drag))
                    .and_then(|run| run.parameter("freewheel.peak", peak))
                    .expect("parameters")
                    .until(locked + 0.01 * turn)
                    .run()
                    .unwrap_or_else(|error| panic!("{frequency} {load} {drag}: {error}"));
                let case = format!("{frequency}, {load}, {drag}, {peak}");
                let found = time_of(&run, "freewheel.breaks_forth");
                assert!((found - freed).abs() < 1e-8 * turn, "{case}: frees at {found}");
                let found = time_of(&run, "freewheel.ends_forth");
                assert!((found - locked).abs() < 1e-6 * turn, "{case}: {found}, not {locked}");
                let ahead = column(&run, "load").iter().zip(column(&run, "motor"));
                let least = ahead.map(|(load, motor)| load - motor).fold(0.0, f64::min);
                assert!(least > -1e-9, "{case}: the motor overtakes by {least:e}");
            }
        }
    }
}
