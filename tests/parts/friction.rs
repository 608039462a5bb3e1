//! Friction with exact sticking: times of sticking, holding forces, and breakaway.

use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use super::{column, example, time_of};
use crate::own_scene::{model_of_specs, of_text};

/// Zero but for the rounding with which a state is put onto a constraint, of speeds of the
/// scale 1.
const AT_REST: f64 = 4.0 * f64::EPSILON;

fn orders(low: f64, high: f64, count: i32) -> impl Iterator<Item = f64> {
    (0..count).map(move |k| low * (high / low).powf(f64::from(k) / f64::from(count - 1)))
}

/// Returns a rotor that brakes from a speed, and is then loaded by a growing torque.
fn braked() -> ModelSimulator {
    of_text(
        r#"
        [scene]
        name = "braked"
        [units.rotor]
        unit = "rotational/inertia"
        [units.brake]
        unit = "rotational/brake"
        inputs = { normal_force = "press" }
        [units.pull]
        unit = "sources/torque"
        inputs = { torque = "slope*max(t - begin, 0 [s])" }
        [[joints]]
        connect = ["rotor.b", "brake.a"]
        [[joints]]
        connect = ["pull.a", "rotor.a"]
        [parameters]
        press = { value = 10.0, unit = "N" }
        slope = { value = 1.0, unit = "N m/s" }
        begin = { value = 2.0, unit = "s" }
        speed = { value = 1.0, unit = "rad/s" }
        [initial]
        "rotor.omega" = "speed"
        [outputs]
        phi = "rotor.phi"
        omega = "rotor.omega"
        torque = "brake.torque"
        [run]
        until = 10.0
        points = 101
        rtol = 1e-9
        method = "dop853"
        "#,
        Keep::Needed,
    )
}

#[test]
fn a_brake_locks_and_breaks_away_when_it_should() {
    let scene = braked();
    let methods = [Method::Dop853, Method::Tsit5, Method::Radau, Method::Rodas5p, Method::Auto];
    let mut count = 0;
    for inertia in orders(1e-3, 1e3, 4) {
        for press in orders(1e-2, 1e4, 4) {
            for speed in [-100.0, -1e-2, 1e-2, 1.0, 100.0] {
                let method = methods[count % methods.len()];
                count += 1;
                let (capacity, peak) = (0.5 * press, 1.3);
                let stop: f64 = inertia * f64::abs(speed) / capacity;
                let begin = 2.0 * stop;
                // It breaks away half of the time to stop later.
                let slope = peak * capacity / (0.5 * stop);
                let run = Simulation::new(&scene)
                    .parameter("rotor.inertia", inertia)
                    .and_then(|run| run.parameter("press", press))
                    .and_then(|run| run.parameter("speed", speed))
                    .and_then(|run| run.parameter("begin", begin))
                    .and_then(|run| run.parameter("slope", slope))
                    .and_then(|run| run.parameter("brake.peak", peak))
                    .expect("parameters")
                    .method(method)
                    .until(3.0 * stop)
                    .run()
                    .unwrap_or_else(|error| panic!("{inertia} {press} {speed} {method}: {error}"));
                let ends = if speed > 0.0 { "brake.ends_forth" } else { "brake.ends_back" };
                let locked = time_of(&run, ends);
                let case = format!("{inertia}, {press}, {speed}, {method}");
                assert!((locked - stop).abs() < 1e-8 * stop, "{case}: {locked} for {stop}");
                let broke = time_of(&run, "brake.breaks_forth");
                let expected = begin + 0.5 * stop;
                assert!((broke - expected).abs() < 1e-8 * stop, "{case}: {broke} for {expected}");
                let turned = 0.5 * speed * stop;
                for (row, time) in run.times.iter().enumerate() {
                    if *time < locked * 1.000_001 || *time > broke * 0.999_999 {
                        continue;
                    }
                    // Held without creeping, by what pulls.
                    assert!(column(&run, "omega")[row].abs() < AT_REST, "{case}: it creeps");
                    let off = (column(&run, "phi")[row] - turned).abs();
                    assert!(off < 1e-7 * turned.abs(), "{case}: held at {off:e} beside");
                    let held = column(&run, "torque")[row] + slope * (time - begin).max(0.0);
                    assert!(held.abs() < 1e-9 * capacity, "{case}: {held:e} is left");
                }
                let late = run.last("omega").expect("an output");
                // J w' = slope s - C from s = stop/2 on, until s = stop.
                let impulse = slope * (1.0 - 0.25) * stop * stop / 2.0 - capacity * 0.5 * stop;
                let exact = impulse / inertia;
                assert!((late - exact).abs() < 1e-7 * exact, "{case}: {late} for {exact}");
            }
        }
    }
}

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
fn a_sprung_mass_turns_and_rests_where_coulomb_says() {
    let scene = example("translational/friction", Keep::All);
    for start in [0.019, 0.021, 0.059, 0.061, 0.11, 0.31, 0.77, -0.51, 2.0] {
        let run = Simulation::new(&scene)
            .rtol(1e-10)
            .parameter("guide.stribeck", 0.0)
            .and_then(|run| run.parameter("guide.viscous", 0.0))
            .expect("parameters")
            .initial_state(&place(&scene, start))
            .until(40.0)
            .run()
            .unwrap_or_else(|error| panic!("{start}: {error}"));
        // 2 N on 100 N/m: each half swing ends 0.04 m nearer, and it rests within 0.02 m.
        let (mut at, mut turns): (f64, usize) = (start, 0);
        while at.abs() > 0.02 {
            at = -at + 0.04 * at.signum();
            turns += 1;
        }
        let rest = run.last("place").expect("an output");
        assert!((rest - at).abs() < 1e-8, "{start}: at {rest}, not {at}");
        let ends = run.switches.iter().filter(|switch| switch.event.contains("ends")).count();
        assert_eq!(ends, turns, "{start}");
        let creep = run.last("speed").expect("an output").abs();
        assert!(creep < AT_REST, "{start}: it creeps by {creep:e}");
        let held = run.last("force").expect("an output");
        assert!((held - 100.0 * at).abs() < 1e-6, "{start}: held by {held}");
    }
}

/// Returns the initial state with the body at a position.
fn place(scene: &ModelSimulator, x: f64) -> Vec<f64> {
    use machinist_contract::{Describe, Simulator};
    let mut state = vec![0.0; scene.shape().states()];
    scene.initial_state(Simulation::new(scene).parameter_values(), &mut state);
    let index = (0..state.len()).find(|index| scene.state(*index).name == "body.x");
    state[index.expect("a place")] = x;
    state
}

#[test]
fn a_bearing_runs_up_against_its_friction() {
    let scene = of_text(
        r#"
        [scene]
        name = "run_up"
        [units.rotor]
        unit = "rotational/inertia"
        [units.bearing]
        unit = "rotational/bearing_friction"
        parameters = { stribeck = 0 }
        [units.drive]
        unit = "sources/torque"
        inputs = { torque = "pull" }
        [[joints]]
        connect = ["rotor.b", "bearing.a"]
        [[joints]]
        connect = ["drive.a", "rotor.a"]
        [parameters]
        pull = { value = 2.0, unit = "N m" }
        [outputs]
        omega = "rotor.omega"
        torque = "bearing.torque"
        [run]
        until = 10.0
        points = 51
        rtol = 1e-10
        method = "dop853"
        "#,
        Keep::Needed,
    );
    for pull in [-50.0, -1.01, -0.99, 0.0, 0.5, 0.999, 1.001, 3.0, 1e3] {
        for viscous in orders(1e-3, 10.0, 4) {
            let run = Simulation::new(&scene)
                .parameter("pull", pull)
                .and_then(|run| run.parameter("bearing.viscous", viscous))
                .expect("parameters")
                .run()
                .unwrap_or_else(|error| panic!("{pull}, {viscous}: {error}"));
            let driven = f64::signum(pull) * (f64::abs(pull) - 1.0).max(0.0);
            for (row, time) in run.times.iter().enumerate() {
                let exact = -driven / viscous * (-viscous * time).exp_m1();
                let omega = column(&run, "omega")[row];
                let allowed = 1e-8 * exact.abs() + 1e-8;
                assert!((omega - exact).abs() <= allowed, "{pull}, {viscous}: {omega}");
                if driven == 0.0 {
                    let held = column(&run, "torque")[row] + pull;
                    assert!(held.abs() < 1e-12, "{pull}: {held:e}");
                }
            }
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

/// Returns a chain of masses on a rough guide, pulled by springs from one end.
fn chain(count: usize) -> String {
    use std::fmt::Write as _;
    let mut text = String::from("[scene]\nname = \"rough_chain\"\n[units.hand]\n");
    text += "unit = \"sources/force\"\ninputs = { force = \"2 [N/s]*t\" }\n";
    text += "[[joints]]\nconnect = [\"hand.a\", \"body1.a\"]\n";
    for k in 1..=count {
        let _ = write!(
            text,
            "[units.body{k}]\nunit = \"translational/mass\"\n[units.guide{k}]\n\
             unit = \"translational/friction\"\n\
             parameters = {{ coulomb = 1, stribeck = 0, viscous = 0 }}\n\
             [[joints]]\nconnect = [\"body{k}.b\", \"guide{k}.a\"]\n"
        );
        if k < count {
            let next = k + 1;
            let _ = write!(
                text,
                "[units.link{k}]\nunit = \"translational/spring_damper\"\n\
                 parameters = {{ stiffness = 50, damping = 20 }}\n\
                 [[joints]]\nconnect = [\"body{k}.a\", \"link{k}.a\"]\n\
                 [[joints]]\nconnect = [\"link{k}.b\", \"body{next}.a\"]\n"
            );
        }
    }
    text += "[outputs]\nx = \"body1.x\"\n";
    text += "[run]\nuntil = 2.5\npoints = 26\nrtol = 1e-7\nmethod = \"dop853\"\n";
    text
}

#[test]
fn a_rough_chain_starts_body_after_body_without_chattering() {
    // All begin at one time, more of them than what would be taken for endless events.
    let count = 60;
    let scene = of_text(&chain(count), Keep::All);
    let run = Simulation::new(&scene).with_energy_balance(true).run().expect("it runs");
    let breaks = |k: usize| {
        let name = format!("guide{k}.breaks_forth");
        run.switches.iter().find(|switch| switch.event == name).map(|switch| switch.time)
    };
    // The first lets go at 1 N, each later than the one before it.
    assert!((breaks(1).expect("it slides") - 0.5).abs() < 1e-8);
    let starts: Vec<f64> = (1..=count).map_while(breaks).collect();
    assert!(starts.windows(2).all(|pair| pair[0] < pair[1]), "{starts:?}");
    assert!(starts.len() >= 3, "{starts:?}");
    // Pulled ever more, none turns round: each begins once and breaks away at most once.
    assert_eq!(run.switches.len(), count + starts.len());
    let residual = run.energy_balance.as_ref().expect("asked for").max_residual_relative();
    assert!(residual < 1e-6, "{residual:e}");
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

#[test]
fn a_sliding_mass_stays_at_its_stop_until_it_is_pulled_off() {
    let scene = example("translational/sliding_mass", Keep::All);
    for coulomb in [0.1, 0.5, 1.0, 2.0, 3.5] {
        let run = Simulation::new(&scene)
            .rtol(1e-10)
            .parameter("body.coulomb", coulomb)
            .and_then(|run| run.parameter("body.lowest", -10.0))
            .expect("parameters")
            .with_energy_balance(true)
            .run()
            .unwrap_or_else(|error| panic!("{coulomb}: {error}"));
        // x'' = 4 - 2 t - C from x = 0, v = 3: on the stop where x = 1.
        let way = |t: f64| 3.0 * t + (4.0 - coulomb) * t * t / 2.0 - t * t * t / 3.0;
        let met = time_of(&run, "body.meets_upper");
        assert!((way(met) - 1.0).abs() < 1e-9, "{coulomb}: {met}");
        // It leaves where 4 - 2 t falls below -C, and slides by -(t - left)^2.
        let left = 2.0 + 0.5 * coulomb;
        assert!((time_of(&run, "body.leaves_upper") - left).abs() < 1e-9, "{coulomb}");
        for (row, time) in run.times.iter().enumerate() {
            let speed = column(&run, "speed")[row];
            if *time > met + 1e-9 && *time < left {
                assert!(speed.abs() < AT_REST, "{coulomb}: it moves at {time}");
                assert!((column(&run, "place")[row] - 1.0).abs() < 1e-9, "{coulomb} at {time}");
            } else if *time > left {
                assert!((speed + (time - left).powi(2)).abs() < 1e-8, "{coulomb} at {time}");
            }
        }
        let residual = run.energy_balance.as_ref().expect("asked for").max_residual_relative();
        assert!(residual < 1e-8, "{coulomb}: {residual:e}");
    }
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

#[test]
fn a_constraint_in_a_mode_is_emitted_as_one() {
    use machinist_codegen::write::{Mode, emit_scenes};
    let model = model_of_specs("parts/rotational/brake", Keep::Needed);
    let folder = tempfile::tempdir().expect("a folder");
    emit_scenes(folder.path(), &[model], Mode::Write).expect("emitted");
    let file = folder.path().join("rotational_brake.rs");
    let text = std::fs::read_to_string(file).expect("a file");
    assert!(text.contains("of_friction("), "{text}");
}
