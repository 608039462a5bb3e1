//! Event mode, steps that end early, intermediate updates, time events.

use std::sync::{Arc, Mutex};

use machinist::Simulation;
use machinist_fmu::abi::{
    Status, fmi3EnterEventMode, fmi3EnterStepMode, fmi3GetFloat64, fmi3SetFloat64,
};
use machinist_scenes::scenes::find_f64;

use super::host::{Archive, Drive, Stepper, Unit, ok};

#[test]
fn a_host_with_event_mode_sees_every_event_of_the_run() {
    for (scene, until) in [("bouncing_mass", 0.5), ("stick_slip", 2.0)] {
        let simulator = find_f64(scene).expect("a built-in scene");
        let exact = Simulation::new(simulator).until(until).run().expect("it runs").switches;
        let archive = Archive::of(scene, &[]);
        let unit = Unit::new(&archive, Drive::Events).expect("an instance");
        unit.begin(until);
        unit.update();
        ok!(unit, fmi3EnterStepMode(unit.handle));
        let (mut time, mut seen) = (0.0, Vec::new());
        while time < until - 1e-9 {
            let (event, reached) = unit.step(time, (time + 0.01).min(until) - time);
            time = reached;
            if event {
                seen.push(time);
                ok!(unit, fmi3EnterEventMode(unit.handle));
                unit.update();
                ok!(unit, fmi3EnterStepMode(unit.handle));
            }
        }
        let happened: Vec<f64> = exact.iter().map(|switch| switch.time).collect();
        let mut distinct = happened.clone();
        distinct.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
        assert_eq!(seen.len(), distinct.len(), "{scene}: {seen:?} against {happened:?}");
        for (seen, happened) in seen.iter().zip(&distinct) {
            assert!((seen - happened).abs() < 1e-6, "{scene}: {seen} against {happened}");
        }
        let named = unit.log();
        assert!(exact.iter().all(|s| named.iter().any(|line| line.contains(&s.event))));
    }
}

#[test]
fn intermediate_updates_show_the_motion_and_end_a_step() {
    let archive = Archive::of("saw_gin", &["--inputs", "load.mean"]);
    let output = archive.reference("cylinder_speed");
    let (input, limit) = (archive.reference("load.mean"), 0.25);
    let unit = Unit::new(&archive, Drive::Events).expect("an instance");
    unit.begin(1.0);
    unit.update();
    ok!(unit, fmi3EnterStepMode(unit.handle));
    let seen = Arc::new(Mutex::new(Vec::new()));
    let into = Arc::clone(&seen);
    unit.looks_by(Box::new(move |handle, time| {
        let mut value = f64::NAN;
        let at = (&raw const output, &raw mut value);
        let status = unsafe { fmi3GetFloat64(handle, at.0, 1, at.1, 1) };
        assert_eq!(status, Status::Ok);
        into.lock().expect("a list").push((time, value));
        (time > 0.2).then_some(limit)
    }));
    let (event, reached) = unit.step(0.0, 1.0);
    assert!(!event);
    assert_eq!(reached.to_bits(), f64::to_bits(limit));
    let shown = std::mem::take(&mut *seen.lock().expect("a list"));
    assert!(shown.len() > 10 && shown.windows(2).all(|pair| pair[0].0 < pair[1].0));
    // The values shown lie on the run.
    let simulator = find_f64("saw_gin").expect("a built-in scene");
    let times: Vec<f64> = shown.iter().map(|(time, _)| *time).collect();
    let run = Simulation::new(simulator).until(0.3).rtol(1e-10).times(&times);
    let run = run.run().expect("it runs");
    let exact = run.column("cylinder_speed").expect("an output");
    for ((time, found), exact) in shown.iter().zip(exact) {
        assert!((found - exact).abs() < 1e-4, "at {time}: {found} against {exact}");
    }
    // An input set within a step acts from there on.
    let before = unit.written();
    unit.looks_by(Box::new(|_, _| None));
    unit.step(limit, 1.2);
    let untouched = unit.get(&[output])[0];
    unit.read(&before);
    unit.looks_by(Box::new(move |handle, time| {
        let load = if time < 1.0 { 843.72 } else { 300.0 };
        let status = unsafe { fmi3SetFloat64(handle, &raw const input, 1, &raw const load, 1) };
        assert_eq!(status, Status::Ok);
        None
    }));
    unit.step(limit, 1.2);
    assert!((unit.get(&[output])[0] - untouched).abs() > 0.1);
}

/// A step function of time is a time event. The host learns of it beforehand, and the rate does
/// not jump until the host has handled it.
#[test]
fn jumps_in_time_are_time_events() {
    let spec = r#"
[scene]
name = "pushed"
title = "A mass that is pushed from 0.3 s on"
[units]
mass = { unit = "translational/mass", parameters = { mass = 2 } }
push = { unit = "sources/force", inputs = { force = "6 [N]*step(t, 0.1 [s] + 0.2 [s])" } }
[[joints]]
connect = ["mass.a", "push.a"]
[outputs]
speed = "mass.v"
acceleration = { expression = "push.force", unit = "N", doc = "force" }
[run]
until = 1.0
points = 11
rtol = 1e-8
method = "auto"
"#;
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("pushed.toml");
    std::fs::write(&path, spec).expect("written");
    let archive = Archive::of(path.to_str().expect("a plain path"), &[]);
    let [speed, force] = ["speed", "acceleration"].map(|name| archive.reference(name));
    let unit = archive.exchange();
    unit.begin(1.0);
    let mut stepper = Stepper::new(&unit);
    // Steps end at the jump by themselves, and not earlier.
    stepper.go(0.29, 0.05);
    assert_eq!(unit.get(&[force]), [0.0]);
    stepper.go(1.0, 0.05);
    assert_eq!(stepper.events, 1);
    let found = unit.get(&[speed])[0];
    assert!((found.abs() - 3.0 * 0.7).abs() < 1e-12, "{found}");
    let simulation = archive.simulation();
    simulation.begin(1.0);
    simulation.step(0.0, 1.0);
    let found = simulation.get(&[speed])[0];
    assert!((found.abs() - 3.0 * 0.7).abs() < 1e-9, "{found}");
}

/// At 2.5 s the frequency vanishes together with its rate, so that the sign of the argument of
/// `abs` is that of rounding, which is that of the 40 Hz before the last step.
#[test]
fn a_kink_that_fades_away_at_a_communication_point_does_not_stop_the_run() {
    let archive = Archive::of("specs/scenes/parts/electrical/converter.toml", &[]);
    let unit = archive.simulation();
    unit.begin(2.5);
    let size = 2.5 / 200.0;
    for index in 0..200 {
        unit.step(f64::from(index) * size, size);
    }
    let speed = unit.get(&[archive.reference("speed")])[0];
    assert!(speed.is_finite() && speed > 0.1 && speed < 10.0, "{speed}");
}
