//! Runs that a host divides into pieces equal undivided runs.

use std::cell::RefCell;
use std::time::Duration;

use machinist::error::StopCause;
use machinist::hosted::{Beginning, Hosted, Piece, Reached, Standing, branches, margins};
use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, Simulator};
use machinist_model::ModelSimulator;
use machinist_scenes::scenes::find_f64;

use crate::left_surfaces::{exact, on_belt};
use crate::own_scene::of_specs;

fn scene(name: &str) -> &'static dyn Simulator<f64> {
    find_f64(name).expect("a built-in scene")
}

fn parameters(simulator: &dyn Simulator<f64>) -> Vec<f64> {
    (0..simulator.shape().parameters).map(|index| simulator.parameter_default(index)).collect()
}

fn begun(hosted: &Hosted<'_>, simulator: &dyn Simulator<f64>, until: f64) -> Standing {
    begun_as(false, hosted, simulator, until)
}

fn begun_as(
    is_stepped: bool,
    hosted: &Hosted<'_>,
    simulator: &dyn Simulator<f64>,
    until: f64,
) -> Standing {
    let mut state = vec![0.0; simulator.shape().states()];
    simulator.initial_state(&parameters(simulator), &mut state);
    let is_given = |index: usize| simulator.is_given(index);
    let is_given = &is_given;
    let (from, rtol) = (0.0, 1e-9);
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
            assert_eq!(reached.expect("it goes on").reached, Reached::End);
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
                assert_eq!(reached.expect("it goes on").reached, Reached::End);
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
fn a_piece_lists_its_events_and_keeps_to_its_limits() {
    let simulator = scene("bouncing_mass");
    let parameters = parameters(simulator);
    let run = Simulation::new(simulator).rtol(1e-9).until(0.4).points(2).method(Method::Auto);
    let whole = run.run().expect("it runs");
    let (mut standing, _) = run.begin().expect("it begins");
    let hosted = Hosted::new(simulator, &parameters);
    let auto = (Method::Auto, false);
    let told = || Some(StopCause::Interrupted);
    for (limited, code) in [
        (hosted.max_steps(3), "run::too-many-steps"),
        (hosted.time_limit(Duration::ZERO), "run::too-slow"),
        (hosted.until_told(&told), "run::interrupted"),
    ] {
        let before = standing.clone();
        let error = limited.carry(&mut standing, 0.4, auto, &|_, _| false).expect_err(code);
        assert_eq!(error.code(), code);
        assert_eq!(standing, before);
    }
    let piece = hosted.carry(&mut standing, 0.4, auto, &|_, _| false).expect("it goes on");
    assert_eq!(piece, Piece { reached: Reached::End, switches: whole.switches.clone() });
    for (column, value) in whole.columns.iter().zip(&standing.state) {
        assert_eq!(column.values[1].to_bits(), value.to_bits(), "{}", column.name);
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
        assert_eq!(reached.expect("it goes on").reached, Reached::Event);
        assert!((standing.time - event.time).abs() < 1e-8, "{} {}", standing.time, event.time);
        assert!(standing.is_at_event());
        let before = standing.state.clone();
        let happened = hosted.happen(&mut standing).expect("it happens");
        let names: Vec<&str> = happened.iter().map(|switch| switch.event.as_str()).collect();
        assert_eq!(names, [event.event.as_str()]);
        assert!(!standing.is_at_event());
        assert_ne!(standing.state, before);
    }
    let how = (Method::Auto, true);
    let reached = hosted.carry(&mut standing, until, how, &|_, _| false);
    assert_eq!(reached.expect("it goes on").reached, Reached::End);
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
    assert_eq!(reached.expect("it goes on").reached, Reached::Interrupted);
    let (time, state) = shown.borrow().last().cloned().expect("it was shown");
    assert!(time > 0.1 && time < 0.5, "{time}");
    assert_eq!((standing.time, &standing.state), (time, &state));
    for (found, exact) in state.iter().zip(last_state(simulator, time)) {
        assert!((found - exact).abs() < 1e-6 * exact.abs().max(1.0), "{found}, {exact}");
    }
}

/// A host that holds branches over steps of its own meets the switches of a run.
#[test]
fn rates_are_live_unless_branches_are_held() {
    let text = r#"
        [scene]
        name = "held"
        [units.u]
        unit = "u"
        [run]
        until = 1
        points = 2
        rtol = 1e-12
        [define.u.states.y]
        unit = "1"
        rate = "(1 + floor(2*y) + abs(y - 0.7))/(1 [s])"
    "#;
    let machine = crate::own_scene::of_text(text, Keep::Needed);
    let rate = |y: f64, branches: &[f64]| {
        let mut rate = [0.0];
        machine.rate(0.0, &[y], branches, &mut rate);
        (2.0 * rate[0]) as i32
    };
    assert_eq!([rate(0.2, &[]), rate(1.2, &[])], [3, 7], "halves");
    let held = branches(&machine, &[], (0.0, &[0.2]));
    let mut sorted: Vec<f64> = held.iter().map(|slot| slot.abs()).collect();
    sorted.sort_by(f64::total_cmp);
    assert_eq!(sorted, [0.0, f64::INFINITY]);
    assert_eq!(rate(1.2, &held), 1, "the branches at 0.2");
    let margin =
        |y: f64| margins(&machine, (&[], &held), (0.0, &[y])).into_iter().fold(9.0, f64::min);
    assert!((margin(0.2) - 0.4).abs() < 1e-15 && (margin(0.6) + 0.2).abs() < 1e-15);
    assert!(
        margins(&machine, (&[], &[0.0, f64::INFINITY]), (0.0, &[0.2])).contains(&f64::INFINITY)
    );
    // From 0 with y' = 1.7 - y, from 1/2 with y' = 2.7 - y, from 0.7 with y' = 1.3 + y.
    let [first, second] = [(1.7_f64 / 1.2).ln(), (2.2_f64 / 2.0).ln()];
    let run = Simulation::new(&machine).until(first + second + 0.1).run().expect("a run");
    let last = run.last("u.y").expect("a state");
    assert!((last - (2.0 * 0.1_f64.exp() - 1.3)).abs() < 1e-9, "{last}");
}

/// Returns the parameters of a mass of 2 kg on a belt, which 0.4 N drag along.
fn on_belt_with(machine: &ModelSimulator, jump: f64) -> Vec<f64> {
    let given = [("u.friction", 0.4), ("u.pull", 0.0), ("u.jump", jump), ("u.begins", 1.0)];
    let mut values = parameters(machine);
    for (place, value) in values.iter_mut().enumerate() {
        let found = given.iter().find(|(name, _)| machine.parameter(place).name == *name);
        *value = found.map_or(*value, |(_, given)| *given);
    }
    values
}

/// A mass at rest on a belt whose speed a host changes between pieces, or which jumps by itself at
/// the start of one.
#[test]
fn a_host_may_move_a_surface_along_which_a_run_slides() {
    for (speed, before) in [("jump", 0.0), ("jump*step(t, begins)", 0.5)] {
        let machine = on_belt(speed, "");
        for method in [Method::Auto, Method::Tsit5, Method::Radau] {
            let [before, behind] = [before, 0.5].map(|jump| on_belt_with(&machine, jump));
            let mut standing = begun(&Hosted::new(&machine, &before), &machine, 5.0);
            for until in [0.5, 1.0, 1.7, 4.0] {
                let hosted = Hosted::new(&machine, if until > 1.0 { &behind } else { &before });
                let reached = hosted.carry(&mut standing, until, (method, false), &|_, _| false);
                assert_eq!(reached.expect("it goes on").reached, Reached::End);
                let [place, speed] = exact([0.4, 0.0, 0.5, 1.0], false, until);
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
    let machine = on_belt("jump", "");
    let [before, behind] = [0.0, 0.5].map(|jump| on_belt_with(&machine, jump));
    let mut standing = begun_as(true, &Hosted::new(&machine, &before), &machine, 5.0);
    let hosted = Hosted::new(&machine, &behind);
    hosted.happen(&mut standing).expect("it goes on");
    let mut rate = vec![0.0; 2];
    hosted.rate(&standing, &mut rate);
    assert_eq!(rate, [0.0, 0.2], "the belt drags it along");
    assert_eq!(standing.state, [0.0, 0.0]);
}

/// A mass of 1 kg that throws half of it off where it passes zero, so that its speed doubles.
fn thrower() -> ModelSimulator {
    crate::own_scene::of_text(
        r#"
        [scene]
        name = "thrower"
        [units.u]
        unit = "u"
        [initial]
        "u.x" = -1.0
        "u.v" = 1.0
        [run]
        until = 3
        points = 2
        [define.u.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.u.parameters]
        place = { value = 0.0, unit = "m" }
        [define.u.modes.thrown]
        [define.u.energy]
        kinetic = "piecewise(thrown < 1, 1 [kg], 0.5 [kg])*v^2/2"
        [define.u.events.throws]
        guard = "x - place"
        direction = "rising"
        when = { thrown = 0 }
        set = { thrown = 1 }
        "#,
        Keep::All,
    )
}

#[test]
fn momentum_goes_on_through_events_that_a_host_executes() {
    let machine = thrower();
    let parameters = parameters(&machine);
    let hosted = Hosted::new(&machine, &parameters);
    let mut halted = begun(&hosted, &machine, 3.0);
    let halts = (Method::Auto, true);
    let piece = hosted.carry(&mut halted, 2.0, halts, &|_, _| false).expect("it goes on");
    assert_eq!(piece.reached, Reached::Event);
    let mut stepped = begun_as(true, &hosted, &machine, 3.0);
    (stepped.time, stepped.state[0]) = (1.0 + 1e-12, 1e-12);
    assert!(hosted.step_is_complete(&mut stepped));
    for standing in [&mut halted, &mut stepped] {
        let switches = hosted.happen(standing).expect("it happens");
        assert_eq!(switches.len(), 1);
        assert!((switches[0].time - 1.0).abs() < 1e-9, "{switches:?}");
        assert!((standing.state[1] - 2.0).abs() < 1e-12, "{:?}", standing.state);
    }
}

#[test]
fn a_host_may_go_on_after_the_end_and_move_guards_over_zero() {
    let machine = thrower();
    let mut given = parameters(&machine);
    given[0] = 20.0;
    let mut standing = begun(&Hosted::new(&machine, &given), &machine, 3.0);
    let auto = (Method::Auto, false);
    let hosted = Hosted::new(&machine, &given);
    hosted.carry(&mut standing, 10.0, auto, &|_, _| false).expect("it goes on");
    hosted.happen(&mut standing).expect("nothing is due");
    let moved = [5.0];
    let hosted = Hosted::new(&machine, &moved);
    let piece = hosted.carry(&mut standing, 11.0, auto, &|_, _| false).expect("it goes on");
    assert_eq!((piece.switches.len(), piece.switches[0].time), (1, 10.0));
    assert!((standing.state[0] - 11.0).abs() < 1e-9, "{:?}", standing.state);
}

/// Short pieces once left out the springs of machines that are solved by their modes.
#[test]
fn short_pieces_of_a_linear_machine_make_up_its_motion() {
    // x'' + d x' + k x = f, oscillating, creeping, nearly critical and without a spring.
    let machine = crate::own_scene::of_text(
        r#"
        [scene]
        name = "linear"
        [units.u]
        unit = "u"
        [initial]
        "u.x" = 1.0
        "u.v" = -0.3
        [run]
        until = 1
        points = 2
        rtol = 1e-9
        method = "auto"
        [define.u.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.u.parameters]
        d = { value = 0.0, unit = "N*s/m" }
        k = { value = 9.0, unit = "N/m" }
        f = { value = 0.0, unit = "N" }
        [define.u.energy]
        kinetic = "(1 [kg])*v^2/2"
        potential = "k*x^2/2"
        dissipation = "d*v^2/2"
        [[define.u.forces]]
        coordinate = "x"
        expression = "f"
        "#,
        Keep::All,
    );
    let auto = (Method::Auto, false);
    for (d, k) in [(0.0, 9.0), (0.5, 9.0), (7.0, 9.0), (6.0 + 1e-9, 9.0), (3.0, 0.0), (0.0, 0.0)] {
        for f in [0.0, 2.0] {
            let given = [d, k, f];
            let named = ["u.d", "u.k", "u.f"];
            let place =
                |index: usize| named.iter().position(|it| *it == machine.parameter(index).name);
            let given: Vec<f64> = (0..3).map(|it| given[place(it).expect("a parameter")]).collect();
            let run =
                Simulation::new(&machine).parameters(&given).method(Method::Dop853).rtol(1e-13);
            let hosted = Hosted::new(&machine, &given);
            let (mut standing, _) = run.begin().expect("it begins");
            let mut size = 1e-9;
            while standing.time < 0.5 {
                let until = standing.time + size;
                hosted.carry(&mut standing, until, auto, &|_, _| false).expect("it goes on");
                size = if size > 3e-4 { 1e-9 } else { 1.7 * size };
            }
            let exact = run.until(standing.time).points(2).run().expect("it runs");
            for (column, found) in exact.columns.iter().zip(&standing.state) {
                let off = (column.values[1] - found).abs();
                assert!(off < 2e-11, "{d} {k} {f}: {} is off by {off}", column.name);
            }
        }
    }
}
