//! Runs that a host divides into pieces equal undivided runs.

use std::cell::RefCell;

use machinist::hosted::{Beginning, Hosted, Reached, Standing};
use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, Simulator};
use machinist_scenes::scenes::find_f64;

use crate::own_scene::{of_specs, of_text};

fn scene(name: &str) -> &'static dyn Simulator<f64> {
    find_f64(name).expect("a built-in scene")
}

fn parameters(simulator: &dyn Simulator<f64>) -> Vec<f64> {
    (0..simulator.shape().parameters).map(|index| simulator.parameter_default(index)).collect()
}

fn begun(hosted: &Hosted<'_>, simulator: &dyn Simulator<f64>, until: f64) -> Standing {
    let mut state = vec![0.0; simulator.shape().states()];
    simulator.initial_state(&parameters(simulator), &mut state);
    let is_given = |index: usize| simulator.is_given(index);
    let is_given = &is_given;
    let (from, rtol, is_stepped) = (0.0, 1e-9, false);
    let beginning =
        Beginning { from, until, rtol, is_stepped, state, is_given, in_equilibrium: false };
    hosted.begin(beginning).expect("it begins")
}

fn last_state(simulator: &dyn Simulator<f64>, until: f64) -> Vec<f64> {
    let run = Simulation::new(simulator).until(until).points(2).rtol(1e-9).method(Method::Auto);
    let run = run.run().expect("it runs");
    let states = simulator.shape().states();
    run.columns[..states].iter().map(|column| column.values[1]).collect()
}

#[test]
fn pieces_make_up_the_run() {
    // Of uneven length, with events, friction that sticks, constraints, jumps between them.
    let scenes = [
        ("bouncing_mass", 0.5),
        ("stick_slip", 1.3),
        ("winder_holder_drop", 0.3),
        ("saw_gin", 0.7),
    ];
    for (name, until) in scenes {
        let simulator = scene(name);
        let parameters = parameters(simulator);
        let hosted = Hosted::new(simulator, &parameters);
        let mut standing = begun(&hosted, simulator, until);
        let pieces = 23;
        for piece in 1..=pieces {
            let share = f64::from(piece) / f64::from(pieces);
            let reached = hosted.carry(
                &mut standing,
                until * share * share,
                (Method::Auto, false),
                &|_, _| false,
            );
            assert_eq!(reached.expect("it goes on"), Reached::End);
        }
        for (index, exact) in last_state(simulator, until).iter().enumerate() {
            let found = standing.state[index];
            let size = simulator.state_scale(index).max(exact.abs());
            assert!((found - exact).abs() < 1e-6 * size, "{name} {index}: {found}, {exact}");
        }
    }
}

#[test]
fn a_piece_may_start_at_a_jump_in_time() {
    // A controller whose output is limited from the jump on; friction, a lossy gear, a rope.
    for (name, jump, until) in
        [("drives/winch", 0.2_f64, 0.4), ("parts/control/pid_controller", 0.2, 1.0)]
    {
        let machine = of_specs(name, Keep::All);
        let simulator: &dyn Simulator<f64> = machine.single();
        let parameters = parameters(simulator);
        let exact = last_state(simulator, until);
        for ends in [vec![jump], vec![0.5 * jump, jump, 1.1 * jump], vec![jump.next_up()]] {
            let hosted = Hosted::new(simulator, &parameters);
            let mut standing = begun(&hosted, simulator, until);
            for to in ends.into_iter().chain([until]) {
                let reached = hosted.carry(&mut standing, to, (Method::Auto, false), &|_, _| false);
                assert_eq!(reached.expect("it goes on"), Reached::End);
            }
            for (index, exact) in exact.iter().enumerate() {
                let found = standing.state[index];
                let size = simulator.state_scale(index).max(exact.abs());
                assert!((found - exact).abs() < 1e-5 * size, "{name} {index}: {found}, {exact}");
            }
        }
    }
}

#[test]
fn a_run_halts_before_an_event_and_goes_on_after_it() {
    let simulator = scene("bouncing_mass");
    let parameters = parameters(simulator);
    let hosted = Hosted::new(simulator, &parameters);
    let until = 0.4;
    let events = Simulation::new(simulator).until(until).rtol(1e-9).run().expect("it runs");
    let mut standing = begun(&hosted, simulator, until);
    for event in &events.switches {
        let how = (Method::Auto, true);
        let reached = hosted.carry(&mut standing, until, how, &|_, _| false);
        assert_eq!(reached.expect("it goes on"), Reached::Event);
        assert!((standing.time - event.time).abs() < 1e-8, "{} {}", standing.time, event.time);
        assert!(standing.is_at_event());
        let before = standing.state.clone();
        assert_eq!(hosted.happen(&mut standing).expect("it happens"), [event.event.as_str()]);
        assert!(!standing.is_at_event());
        assert_ne!(standing.state, before);
    }
    let how = (Method::Auto, true);
    let reached = hosted.carry(&mut standing, until, how, &|_, _| false);
    assert_eq!(reached.expect("it goes on"), Reached::End);
}

#[test]
fn a_piece_ends_where_who_looks_on_says() {
    let simulator = scene("saw_gin");
    let parameters = parameters(simulator);
    let hosted = Hosted::new(simulator, &parameters);
    let mut standing = begun(&hosted, simulator, 1.0);
    let shown = RefCell::new(Vec::new());
    let looks = |time: f64, state: &[f64]| {
        shown.borrow_mut().push((time, state.to_vec()));
        time > 0.1
    };
    let reached = hosted.carry(&mut standing, 1.0, (Method::Dop853, false), &looks);
    assert_eq!(reached.expect("it goes on"), Reached::Left);
    let (time, state) = shown.borrow().last().cloned().expect("it was shown");
    assert!(time > 0.1 && time < 0.5, "{time}");
    assert_eq!((standing.time, &standing.state), (time, &state));
    for (found, exact) in state.iter().zip(last_state(simulator, time)) {
        assert!((found - exact).abs() < 1e-6 * exact.abs().max(1.0), "{found}, {exact}");
    }
}

/// A mass at rest on a belt by `-F*sign(v - belt)`, whose speed a host changes between pieces, or
/// which jumps by itself at the start of one.
#[test]
fn a_host_may_move_a_surface_along_which_a_run_slides() {
    let text = |speed: &str| {
        format!(
            r#"
            [scene]
            name = "belt"
            [units.u]
            unit = "u"
            [run]
            until = 5
            points = 2
            [define.u.coordinates.x]
            unit = "m"
            velocity = "v"
            [define.u.parameters]
            belt = {{ value = 0, unit = "m/s" }}
            friction = {{ value = 0.2, unit = "N" }}
            [define.u.energy]
            kinetic = "0.5 [kg]*v^2"
            [[define.u.forces]]
            coordinate = "x"
            expression = "-friction*sign(v - {speed})"
            "#
        )
    };
    for speed in ["belt", "(belt + 0.5 [m/s]*step(t, 1 [s]))"] {
        let machine = of_text(&text(speed), Keep::All);
        let changes = speed == "belt";
        for method in [Method::Auto, Method::Tsit5, Method::Radau] {
            let mut values = parameters(&machine);
            let place = (0..values.len()).find(|k| machine.parameter(*k).name == "u.belt");
            let mut standing = begun(&Hosted::new(&machine, &values), &machine, 5.0);
            for until in [0.5, 1.0, 1.7, 4.0] {
                if changes && until > 1.0 {
                    values[place.expect("a parameter")] = 0.5;
                }
                let hosted = Hosted::new(&machine, &values);
                let reached = hosted.carry(&mut standing, until, (method, false), &|_, _| false);
                assert_eq!(reached.expect("it goes on"), Reached::End);
                let slides = (until - 1.0).clamp(0.0, 2.5);
                let speed = 0.2 * slides;
                let place = 0.5 * speed * slides + 0.5 * (until - 3.5).max(0.0);
                let found = (standing.state[0], standing.state[1]);
                let off = (found.0 - place).abs() + (found.1 - speed).abs();
                assert!(off < 1e-8, "{method}, {until}: {found:?}, not {place}, {speed}");
            }
        }
    }
}

/// The same by a host that takes steps of its own.
#[test]
fn a_host_that_steps_may_move_a_surface() {
    let machine = of_text(
        r#"
        [scene]
        name = "belt"
        [units.u]
        unit = "u"
        [run]
        until = 5
        points = 2
        [define.u.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.u.parameters]
        belt = { value = 0, unit = "m/s" }
        [define.u.energy]
        kinetic = "0.5 [kg]*v^2"
        [[define.u.forces]]
        coordinate = "x"
        expression = "-0.2 [N]*sign(v - belt)"
        "#,
        Keep::All,
    );
    let mut values = parameters(&machine);
    let mut state = vec![0.0; 2];
    machine.initial_state(&values, &mut state);
    let (from, until, rtol, is_stepped) = (0.0, 5.0, 1e-9, true);
    let is_given = &|_| true;
    let beginning =
        Beginning { from, until, rtol, is_stepped, state, is_given, in_equilibrium: false };
    let mut standing = Hosted::new(&machine, &values).begin(beginning).expect("it begins");
    values[0] = 0.5;
    let hosted = Hosted::new(&machine, &values);
    hosted.happen(&mut standing).expect("it goes on");
    let mut rate = vec![0.0; 2];
    hosted.rate(&standing, &mut rate);
    assert_eq!(rate, [0.0, 0.2], "the belt drags it along");
    assert_eq!(standing.state, [0.0, 0.0]);
}
