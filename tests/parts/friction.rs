//! Friction with exact sticking: times of sticking, holding forces, and breakaway.

use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use super::{column, example, time_of};
use crate::own_scene::{model_of_specs, of_text};

/// Zero but for the rounding with which a state is put onto a constraint, of speeds of the
/// scale 1.
const AT_REST: f64 = 4.0 * f64::EPSILON;

pub(super) fn orders(low: f64, high: f64, count: i32) -> impl Iterator<Item = f64> {
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
