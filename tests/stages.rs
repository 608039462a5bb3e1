//! Events with a common guard, inertias that jump, events beside fields, and limits of runs, by all
//! methods against closed forms.

use machinist::field::{Discretisation, FieldSimulator};
use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

const OWN: [Method; 6] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Taylor, Method::Auto];

/// Returns a mass on a line, with the given unit text.
fn mass(kinetic: &str, definition: &str) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "stages"
        [units.u]
        unit = "u"
        [initial]
        "u.v" = 1.0
        [run]
        until = 3.0
        points = 31
        rtol = 1e-8
        method = "auto"
        [define.u.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.u.energy]
        kinetic = "{kinetic}"
        {definition}
        "#
    );
    of_text(&text, Keep::All)
}

fn last(run: &Trajectory, name: &str) -> f64 {
    *run.column(name).expect("a column").last().expect("a row")
}

fn assert_near(found: f64, expected: f64, allowed: f64, what: &str) {
    assert!((found - expected).abs() <= allowed, "{what}: {found} and not {expected}");
}

#[test]
fn two_events_on_one_guard_each_happen_at_their_own_crossing() {
    let thrown = mass(
        "1 [kg]*v^2/2",
        r#"
        [[define.u.forces]]
        coordinate = "x"
        expression = "-9.81 [N]"
        [define.u.parameters]
        at = { value = 50.0, unit = "m" }
        [define.u.states]
        up = { unit = "1", rate = "0 [1/s]" }
        down = { unit = "1", rate = "0 [1/s]" }
        [define.u.events]
        rises = { guard = "x - at", direction = "rising", set = { up = "up + 1" } }
        falls = { guard = "x - at", direction = "falling", set = { down = "down + 1" } }
        "#,
    );
    let highest = 50.0_f64.powi(2) / (2.0 * 9.81);
    for method in OWN {
        for height in 1..=26 {
            let at = 5.0 * f64::from(height) + 0.37;
            let run = Simulation::new(&thrown).method(method).until(11.0).rtol(1e-8);
            let run = run.initial_value("u.v", 50.0).expect("a state");
            let run = run.parameter("u.at", at).expect("a parameter").run().expect("it runs");
            let passes = if at < highest { 1.0 } else { 0.0 };
            let counts = [last(&run, "u.up"), last(&run, "u.down")];
            let passed_once = counts.iter().all(|count| (count - passes).abs() < 0.5);
            assert!(passed_once, "{method} at {at} m: {counts:?}");
        }
    }
}

#[test]
fn momentum_goes_on_where_an_inertia_jumps_with_time() {
    let machine = mass(
        "(1 [kg] + more*step(t, 1 [s]))*v^2/2",
        "[define.u.parameters]\nmore = { value = 1.0, unit = \"kg\" }\n",
    );
    for method in OWN {
        for more in [0.0, 1.0, -0.5, 7.0] {
            let run = Simulation::new(&machine).method(method).with_energy_balance(true);
            let run = run.parameter("u.more", more).expect("a parameter").run().expect("it runs");
            assert_near(last(&run, "u.v"), 1.0 / (1.0 + more), 1e-12, &format!("{method} {more}"));
            assert_near(last(&run, "energy.residual"), 0.0, 1e-9, &format!("{method} {more}"));
        }
    }
}

#[test]
fn an_event_switches_a_torque_on_a_shaft_with_a_field() {
    let text = r#"
        [scene]
        name = "switched"
        [units.shaft]
        unit = "shaft"
        inputs = { load = 0 }
        parameters = { damping_time = 1e-4 }
        fields = { phi = { elements = 4, order = 2 } }
        [modes.off]
        [parameters.torque]
        value = 1.0
        unit = "N m"
        [parameters.at]
        value = 1.0
        unit = "s"
        [events.stops]
        guard = "t - at"
        direction = "rising"
        when = { off = 0 }
        set = { off = 1 }
        [[forces]]
        port = "shaft.start"
        expression = "piecewise(off < 1, torque, 0)"
        [outputs]
        end_speed = "shaft.end_dot"
        [run]
        until = 2.0
        points = 201
        rtol = 1e-7
        method = "auto"
    "#;
    let machine = of_text(text, Keep::Needed);
    let cut =
        FieldSimulator::new(machine.with_fields(), Discretisation::default()).expect("it is cut");
    let run = |method: Method, at: f64| {
        let run = Simulation::new(&cut).method(method).rtol(1e-7);
        run.parameter("at", at).expect("a parameter").run().expect("it runs")
    };
    // The impulse of the torque, over the inertia of the shaft: twice as long, twice as fast.
    let never = last(&run(Method::Radau, 1e3), "end_speed");
    for method in [Method::Dop853, Method::Rodas5p, Method::Radau, Method::Auto] {
        for at in [0.5, 1.0, 1.7] {
            let run = run(method, at);
            assert_eq!(run.switches.len(), 1, "{method} at {at} s");
            assert_near(last(&run, "end_speed") / never, at / 2.0, 1e-2, &format!("{method} {at}"));
        }
    }
}

#[test]
fn every_pass_of_a_run_hears_its_limits() {
    let machine = mass(
        "1 [kg]*v^2/2",
        r#"
        [define.u.parameters]
        rise = { value = 0.3, unit = "s" }
        [[define.u.forces]]
        coordinate = "x"
        expression = "-10 [N/m]*x + 1 [N]*min(max((t - 0.7 [s])/rise, 0), 1)"
        "#,
    );
    for method in OWN {
        let limit = std::time::Duration::from_millis(300);
        let began = std::time::Instant::now();
        let run = Simulation::new(&machine).method(method).rtol(1e-6).time_limit(limit).run();
        assert!(began.elapsed().as_secs() < 5, "{method}: {run:?}");
    }
}
