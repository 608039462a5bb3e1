//! Runs by hosts compared with runs of emitted code.

use std::sync::Arc;
use std::thread;

use machinist::trajectory::ColumnKind;
use machinist::{Discretisation, FieldSimulator, Simulation, Trajectory};
use machinist_contract::Simulator;
use machinist_fmu::abi::{Status, fmi3GetOutputDerivatives};
use machinist_scenes::scenes::{find_f64, find_field_f64};

use super::host::{Archive, Stepper, Unit, ok};

/// Runs a built-in scene to convergence, with a number of points.
fn reference(scene: &str, until: f64, points: usize) -> Trajectory {
    let simulator: &dyn Simulator<f64> = find_f64(scene).expect("a built-in scene");
    let run = Simulation::new(simulator).until(until).points(points).rtol(1e-10);
    run.run().expect("it runs")
}

/// Returns the largest error of an output relative to its range, and its name. Discontinuous
/// outputs are not compared next to an event.
fn worst(archive: &Archive, reference: &Trajectory, rows: &[Vec<f64>]) -> (f64, String) {
    let near_event =
        |time: f64| reference.switches.iter().any(|switch| (switch.time - time).abs() < 1e-7);
    let mut worst = (0.0, String::new());
    for (column, (name, _)) in archive.outputs().iter().enumerate() {
        let exact = reference.column(name).expect("an output of the scene");
        let [least, most] = [f64::min, f64::max].map(|f| exact.iter().copied().fold(exact[0], f));
        let range = (most - least).max(1e-6 * most.abs().max(1e-300));
        for ((time, exact), row) in reference.times.iter().zip(exact).zip(rows) {
            let error = (row[column] - exact).abs() / range;
            if !near_event(*time) && (error.is_nan() || error > worst.0) {
                worst = (error, format!("{name} at {time}"));
            }
        }
    }
    worst
}

fn simulated(archive: &Archive, unit: &Unit, until: f64, points: usize) -> Vec<Vec<f64>> {
    let references: Vec<u32> = archive.outputs().into_iter().map(|(_, at)| at).collect();
    unit.begin(until);
    let mut rows = vec![unit.get(&references)];
    let step = until / (points - 1) as f64;
    for index in 1..points {
        let from = (index - 1) as f64 * step;
        unit.step(from, step);
        rows.push(unit.get(&references));
    }
    rows
}

#[test]
fn fields_are_cut_as_they_are_exported_and_run_by_both_interfaces() {
    for (options, elements) in [(&[][..], None), (&["--elements", "3"][..], Some(3))] {
        let archive = Archive::of("shaft_with_rotors", options);
        let scene = find_field_f64("shaft_with_rotors").expect("a built-in scene");
        let wanted = Discretisation { elements, order: None };
        let cut = FieldSimulator::new(scene, wanted).expect("fields");
        let (until, points) = (0.01, 11);
        let run = Simulation::new(cut.single()).until(until).points(points).rtol(1e-11);
        let reference = run.run().expect("it runs");
        let simulation = archive.simulation();
        let rows = simulated(&archive, &simulation, until, points);
        let (error, place) = worst(&archive, &reference, &rows);
        assert!(error < 1e-6, "{error:.1e} of {place}");
        // A restored state continues with the same bits.
        let bytes = simulation.written();
        let references: Vec<u32> = archive.outputs().into_iter().map(|(_, at)| at).collect();
        simulation.step(until, 1e-3);
        let first = simulation.get(&references);
        simulation.read(&bytes);
        simulation.step(until, 1e-3);
        assert_eq!(simulation.get(&references), first);

        let exchange = archive.exchange();
        exchange.begin(1e-3);
        let mut stepper = Stepper::new(&exchange);
        stepper.go(1e-3, 1e-6);
        let exact = reference.columns.iter().filter(|c| c.kind == ColumnKind::State);
        for (found, exact) in stepper.state().iter().zip(exact) {
            let size = exact.values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            let error = (found - exact.values[1]).abs();
            assert!(error <= 1e-6 * size, "{}: {found} for {}", exact.name, exact.values[1]);
        }
        assert_eq!(archive.elements("ModelExchange")[0]["providesDirectionalDerivatives"], "true");
    }
}

#[test]
fn co_simulation_is_a_run_of_our_own() {
    let scenes = [
        ("saw_gin", 1.4),
        ("bouncing_mass", 0.5),
        ("stick_slip", 2.0),
        ("winder_holder_drop", 0.5),
        ("winder_linkage", 0.3),
    ];
    for (scene, until) in scenes {
        let archive = Archive::of(scene, &[]);
        let exact = reference(scene, until, 101);
        let rows = simulated(&archive, &archive.simulation(), until, 101);
        let (error, place) = worst(&archive, &exact, &rows);
        assert!(error < 1e-6, "{scene}: {place} is off by {error:e}");
    }
}

#[test]
fn model_exchange_with_a_method_of_the_hosts_is_a_run_of_our_own() {
    // Step sizes with which the error of order 4 is below the bound.
    let scenes = [
        ("saw_gin", 0.3, 2e-5),
        ("bouncing_mass", 0.5, 1e-4),
        ("stick_slip", 2.0, 5e-4),
        ("winder_holder_drop", 0.1, 1e-4),
    ];
    for (scene, until, longest) in scenes {
        let archive = Archive::of(scene, &[]);
        let exact = reference(scene, until, 41);
        let references: Vec<u32> = archive.outputs().into_iter().map(|(_, at)| at).collect();
        let unit = archive.exchange();
        unit.begin(until);
        let mut stepper = Stepper::new(&unit);
        let mut rows = vec![unit.get(&references)];
        for time in &exact.times[1..] {
            stepper.go(*time, longest);
            rows.push(unit.get(&references));
        }
        let (error, place) = worst(&archive, &exact, &rows);
        assert!(error < 1e-6, "{scene}: {place} is off by {error:e}");
        let happened = exact.switches.len();
        assert!(stepper.events >= happened, "{scene}: {} of {happened}", stepper.events);
    }
}

/// Two brakes hold a shaft together, each at its limit at times. The drift of constraints in a
/// host's steps must not be taken for the end or reversal of sliding.
#[test]
fn brakes_that_hold_together_do_so_under_a_method_of_the_hosts() {
    let text = r#"
        [scene]
        name = "brakes"
        [units]
        rotor = { unit = "rotational/inertia", parameters = { inertia = 0.0182 } }
        first = { unit = "rotational/brake", parameters = { friction = 1.79 }, inputs = { normal_force = "1 [N]" } }
        second = { unit = "rotational/brake", parameters = { friction = 1.6 }, inputs = { normal_force = "1 [N]" } }
        [[joints]]
        connect = ["rotor.a", "first.a"]
        [[joints]]
        connect = ["rotor.a", "second.a"]
        [[forces]]
        port = "rotor.b"
        expression = "2.03 [N m]*sin(3.13 [rad/s]*t)"
        [outputs]
        speed = "rotor.omega"
        [run]
        until = 20.0
    "#;
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("brakes.toml");
    std::fs::write(&file, text).expect("written");
    let archive = Archive::of(file.to_str().expect("a plain path"), &[]);
    let speed = [archive.reference("speed")];
    let unit = archive.exchange();
    unit.begin(20.0);
    let mut stepper = Stepper::new(&unit);
    stepper.drift = 1e-7;
    for step in 1..=100 {
        stepper.go(0.2 * f64::from(step), 1e-2);
        let speed = unit.get(&speed)[0];
        assert!(speed.abs() < 1e-6, "{speed} after {step}");
    }
    // They take turns several times in each of ten periods of the torque, and are projected now and
    // then.
    assert!((10..160).contains(&stepper.events), "{}", stepper.events);
}

#[test]
fn four_instances_on_four_threads_run_as_one_does() {
    let archive = Arc::new(Archive::of("saw_gin", &[]));
    let alone = simulated(&archive, &archive.simulation(), 0.2, 21);
    let run = || {
        let archive = Arc::clone(&archive);
        thread::spawn(move || simulated(&archive, &archive.simulation(), 0.2, 21))
    };
    let threads: Vec<_> = (0..4).map(|_| run()).collect();
    for thread in threads {
        assert_eq!(thread.join().expect("it ends"), alone);
    }
}

#[test]
fn an_input_acts_from_where_the_host_sets_it() {
    let archive = Archive::of("two_mass", &["--inputs", "drive_torque"]);
    let variables = archive.variables();
    assert_eq!(variables["drive_torque"]["causality"], "input");
    assert_eq!(variables["drive_torque"]["variability"], "continuous");
    let (input, speed) = (archive.reference("drive_torque"), archive.reference("driver_speed"));
    let unit = archive.simulation();
    unit.begin(1.0);
    unit.step(0.0, 0.5);
    unit.set(input, -50.0);
    unit.step(0.5, 0.5);
    let simulator = find_f64("two_mass").expect("a built-in scene");
    let run = |torque: f64, from: f64, state: Option<&[f64]>| {
        let run = Simulation::new(simulator).parameter("drive_torque", torque).expect("it is one");
        let run = run.from(from).until(from + 0.5).points(2).rtol(1e-10);
        let run = state.map_or(run.clone(), |state| run.initial_state(state));
        let run = run.run().expect("it runs");
        let states = simulator.shape().states();
        let last: Vec<f64> = run.columns[..states].iter().map(|c| c.values[1]).collect();
        (last, run.column("driver_speed").expect("an output")[1])
    };
    let default = variables["drive_torque"]["start"].parse().expect("a start value");
    let (state, _) = run(default, 0.0, None);
    let (_, exact) = run(-50.0, 0.5, Some(&state));
    let found = unit.get(&[speed])[0];
    assert!((found - exact).abs() < 1e-7 * exact.abs().max(1.0), "{found} against {exact}");
}

/// An input that the host computes gives the same run as the same expression in the scene.
#[test]
fn an_input_that_follows_a_sine_is_the_scene_with_that_sine() {
    let archive = Archive::of("two_mass", &["--inputs", "load_torque"]);
    let simulator = find_f64("two_mass").expect("a built-in scene");
    let run = Simulation::new(simulator).parameter("load_amplitude", 300.0).expect("it is one");
    let exact = run.until(0.2).points(21).rtol(1e-10).run().expect("it runs");
    let unit = archive.exchange();
    unit.begin(0.2);
    let mut stepper = Stepper::new(&unit);
    let input = archive.reference("load_torque");
    stepper.input = Some((input, |time| 843.72 + 300.0 * (241.8051 * time).sin()));
    let references: Vec<u32> = archive.outputs().into_iter().map(|(_, at)| at).collect();
    let mut rows = vec![unit.get(&references)];
    for time in &exact.times[1..] {
        stepper.go(*time, 2e-5);
        rows.push(unit.get(&references));
    }
    let (error, place) = worst(&archive, &exact, &rows);
    assert!(error < 1e-6, "{place} is off by {error:e}");
}

#[test]
fn parameters_are_set_before_the_run_and_tuned_along_it() {
    let archive = Archive::of("saw_gin", &[]);
    let speed = [archive.reference("cylinder_speed")];
    let inertia = archive.reference("motor.inertia");
    let unit = archive.simulation();
    unit.set(inertia, 6.0);
    unit.begin(0.4);
    unit.step(0.0, 0.4);
    let simulator = find_f64("saw_gin").expect("a built-in scene");
    let run = Simulation::new(simulator).parameter("motor.inertia", 6.0).expect("it is one");
    let exact = run.until(0.4).points(2).rtol(1e-10).run().expect("it runs");
    let exact = exact.column("cylinder_speed").expect("an output")[1];
    let found = unit.get(&speed)[0];
    assert!((found - exact).abs() < 1e-6 * exact.abs(), "{found} against {exact}");
    // In step mode the parameter may be tuned, which changes the rest of the run.
    unit.set(inertia, 3.0);
    unit.step(0.4, 0.1);
    assert!((unit.get(&speed)[0] - exact).abs() > 1e-3);
}

#[test]
fn outputs_have_rates_along_the_motion() {
    let archive = Archive::of("saw_gin", &[]);
    let unit = archive.simulation();
    unit.begin(1.0);
    unit.step(0.0, 0.3);
    let references: Vec<u32> = archive.outputs().into_iter().map(|(_, at)| at).collect();
    let count = references.len();
    let mut rates = vec![f64::NAN; count];
    let orders = vec![1; count];
    let at = (references.as_ptr(), orders.as_ptr(), rates.as_mut_ptr());
    ok!(unit, fmi3GetOutputDerivatives(unit.handle, at.0, count, at.1, at.2, count));
    let step = 1e-6;
    let before = unit.get(&references);
    unit.step(0.3, step);
    let after = unit.get(&references);
    for (index, rate) in rates.iter().enumerate() {
        let slope = (after[index] - before[index]) / step;
        let size = rate.abs().max(1e3 * before[index].abs());
        assert!((slope - rate).abs() < 1e-3 * size, "{index}: {slope} against {rate}");
    }
    let second = [2];
    let status = unsafe {
        fmi3GetOutputDerivatives(unit.handle, at.0, 1, second.as_ptr(), rates.as_mut_ptr(), 1)
    };
    assert_eq!(status, Status::Error);
}
