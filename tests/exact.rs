//! Linear machines solved without steps, compared with methods that step.

use machinist::error::StopCause;
use machinist::{Method, SimulateError, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, Simulator};
use machinist_model::ModelSimulator;
use machinist_scenes::scenes;

use crate::own_scene::of_text;

/// Returns the machine of a spec in one file, with nothing left out.
fn machine(text: &str) -> ModelSimulator {
    of_text(text, Keep::All)
}

/// Returns a mass on a spring and a damper, driven by a force.
fn oscillator(mass: f64, damping: f64, stiffness: f64, force: &str) -> ModelSimulator {
    machine(&format!(
        r#"
[scene]
name = "oscillator"
[units.body]
unit = "body"
[define.body.coordinates.x]
unit = "m"
[define.body.parameters.mass]
value = {mass:?}
unit = "kg"
[define.body.parameters.damping]
value = {damping:?}
unit = "N s/m"
[define.body.parameters.stiffness]
value = {stiffness:?}
unit = "N/m"
[define.body.energy]
kinetic = "mass*x_dot^2/2"
potential = "stiffness*x^2/2"
dissipation = "damping*x_dot^2/2"
[[define.body.forces]]
coordinate = "x"
expression = "{force}"
[initial]
"body.x" = 0.3
"body.x_dot" = -0.7
[run]
until = 3.0
points = 31
rtol = 1e-10
method = "auto"
"#
    ))
}

/// Returns rotors in a row, with damping proportional to stiffness or not.
fn chain(damping: f64) -> ModelSimulator {
    machine(&format!(
        r#"
[scene]
name = "chain"
[units]
a = {{ unit = "rotor", parameters = {{ inertia = 2.0 }} }}
b = {{ unit = "rotor", parameters = {{ inertia = 0.7 }} }}
c = {{ unit = "rotor", parameters = {{ inertia = 0.3 }} }}
first = {{ unit = "coupling", parameters = {{ stiffness = 40.0, damping = 0.04, ratio = 2.0 }} }}
second = {{ unit = "coupling", parameters = {{ stiffness = 90.0, damping = {damping:?}, ratio = 0.5 }} }}
[[joints]]
connect = ["a.shaft", "first.driving"]
[[joints]]
connect = ["b.shaft", "first.driven"]
[[joints]]
connect = ["b.shaft", "second.driving"]
[[joints]]
connect = ["c.shaft", "second.driven"]
[[forces]]
port = "a.shaft"
expression = "3 [N m]*sin(2 [rad/s]*t)*step(t, 0.4 [s])"
[initial]
"a.phi" = 0.3
"c.omega" = 1.5
[run]
until = 3.0
points = 31
rtol = 1e-10
method = "auto"
"#
    ))
}

fn run(simulator: &dyn Simulator<f64>, method: Method, rtol: f64) -> Trajectory {
    let run = Simulation::new(simulator).method(method).rtol(rtol).run();
    run.unwrap_or_else(|error| panic!("{method}: {error}"))
}

/// Returns the largest difference of a state, relative to its largest value.
fn distance(a: &Trajectory, b: &Trajectory) -> f64 {
    let pairs = a.columns.iter().zip(&b.columns);
    let of_column = pairs.map(|(a, b)| {
        let size = b.values.iter().fold(f64::MIN_POSITIVE, |size, value| size.max(value.abs()));
        let values = a.values.iter().zip(&b.values);
        values.map(|(a, b)| (a - b).abs() / size).fold(0.0, f64::max)
    });
    of_column.fold(0.0, f64::max)
}

/// Asserts that the solution agrees with a method that steps.
fn assert_right(name: &str, simulator: &dyn Simulator<f64>, by: &str) {
    let exact = run(simulator, Method::Exact, 1e-9);
    let stepped = run(simulator, Method::Radau, 1e-13);
    let distance = distance(&exact, &stepped);
    println!("{name}: {distance:.1e}, {:?}", exact.notes);
    assert!(distance < 2e-11, "{name}: {distance:e} from stepping");
    assert!(exact.notes.iter().any(|note| note.contains(by)), "{name}: {:?}", exact.notes);
    assert_eq!(exact.work.rejected + exact.work.newton_iterations, 0);
}

#[test]
fn one_mass_is_right_under_every_force_that_has_a_closed_form() {
    let forces = [
        ("nothing", "0 [N]"),
        ("constant", "2 [N]"),
        ("ramp", "1.5 [N/s]*t"),
        ("harmonic", "2 [N]*cos(3 [rad/s]*t + 0.4)"),
        ("resonance", "2 [N]*sin(4 [rad/s]*t)"),
        ("beats", "2 [N]*sin(3 [rad/s]*t)*cos(5 [rad/s]*t)^2"),
        ("decay", "2 [N]*exp(-0.7 [1/s]*t)*sin(6 [rad/s]*t + 1)"),
        ("growth", "0.1 [N/s^2]*t^2*cosh(0.5 [1/s]*t)"),
        ("switched", "2 [N]*step(t, 1.05 [s]) - 1 [N]*step(t, 2.4 [s])*cos(9 [rad/s]*t)"),
        ("pieces", "piecewise(t < 0.5 [s], 1 [N], t < 1.7 [s], -2 [N/s]*t, 3 [N]*sin(2 [1/s]*t))"),
        ("smooth", "4 [N]*smooth_step((t - 0.5 [s])/(1.5 [s]))"),
        ("held", "2 [N/s]*min(t, 1.3 [s])"),
    ];
    for (name, force) in forces {
        assert_right(name, &oscillator(2.0, 0.3, 32.0, force), "by its mode,");
    }
}

#[test]
fn one_mass_is_right_whatever_its_damping() {
    // Free, undamped, weak, nearly critical on both sides, critical, strong, none of
    // a spring; springs that push.
    let machines = [
        (0.0, 0.0),
        (0.0, 32.0),
        (0.1, 32.0),
        (15.9999, 32.0),
        (16.0, 32.0),
        (16.0001, 32.0),
        (17.0, 32.0),
        (4000.0, 32.0),
        (5.0, 0.0),
        (0.3, -2.0),
    ];
    for (damping, stiffness) in machines {
        let simulator = oscillator(2.0, damping, stiffness, "2 [N]*sin(4 [rad/s]*t) + 1 [N/s]*t");
        let name = format!("damping {damping}, stiffness {stiffness}");
        assert_right(&name, &simulator, "solved by");
    }
}

#[test]
fn chains_are_solved_by_modes_where_they_share_their_dampers_and_else_by_an_exponential() {
    // 0.04/40 = 0.09/90: damping in proportion to stiffness.
    assert_right("proportional", &chain(0.09), "3 modes");
    assert_right("any damping", &chain(0.5), "exponential");
    assert_right("two_mass", &scenes::two_mass::TwoMass, "exponential");
    assert_right("winder_linear", &scenes::winder_linear::WinderLinear, "by its mode,");
}

#[test]
fn modes_that_lie_close_are_kept_apart() {
    let pair = machine(
        r#"
[scene]
name = "pair"
[units.both]
unit = "both"
[define.both.coordinates.a]
unit = "rad"
[define.both.coordinates.b]
unit = "rad"
[define.both.energy]
kinetic = "2 [kg m^2]*(a_dot^2 + b_dot^2)/2"
potential = "3 [N m/rad]*(a^2 + (1 + 1e-14)*b^2)/2 + 1e-13 [N m/rad]*(a - b)^2/2"
[initial]
"both.a" = 0.3
"both.b_dot" = 0.2
[run]
until = 3.0
points = 31
rtol = 1e-10
method = "auto"
"#,
    );
    assert_right("pair", &pair, "2 modes");
}

#[test]
fn the_account_of_energy_closes() {
    for simulator in
        [&chain(0.09), &chain(0.5), &oscillator(2.0, 0.3, 32.0, "2 [N]*step(t, 1 [s])")]
    {
        let run = Simulation::new(simulator).method(Method::Exact).with_energy_balance(true).run();
        let balance = run.expect("a run").energy_balance.expect("asked for");
        let passed = balance.passed.last().copied().expect("times");
        let residual = balance.residual.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        println!("{}: {residual:e} of {passed}", simulator.name());
        assert!(residual <= 1e-9 * (passed + balance.largest_active), "{residual} of {passed}");
    }
}

#[test]
fn a_million_periods_keep_their_phase() {
    let simulator = oscillator(2.0, 0.0, 32.0, "0 [N]");
    let until = 1e6 * std::f64::consts::FRAC_PI_2;
    let run = Simulation::new(&simulator).method(Method::Auto).until(until).points(2).run();
    let run = run.expect("a run");
    let [x, speed] = ["body.x", "body.x_dot"].map(|name| run.column(name).expect("a state")[1]);
    // Rounding of the end time alone is 2e-10 s.
    assert!((x - 0.3).abs() < 3e-9 && (speed + 0.7).abs() < 3e-9, "{x} {speed}");
    assert!(run.work.steps < 3, "{:?}", run.work);
}

#[test]
fn machines_that_are_not_linear_are_refused_by_exact_and_stepped_by_auto() {
    let forces = ["2 [N/m^2]*x^2", "1 [N/m]*x*sin(3 [rad/s]*t)", "1 [N]*tanh(2 [1/s]*t)"];
    for force in forces {
        let simulator = oscillator(2.0, 0.3, 32.0, force);
        assert!(!Method::Exact.suits(&simulator), "{force}");
        match Simulation::new(&simulator).method(Method::Exact).run() {
            Err(SimulateError::Stopped { cause: cause @ StopCause::NotLinear, .. }) => {
                assert!(cause.to_string().contains("not linear"), "{cause}");
            }
            other => panic!("{force}: {other:?}"),
        }
        let auto = run(&simulator, Method::Auto, 1e-9);
        assert!(auto.work.steps > 3, "{force}");
    }
}

#[test]
fn an_exponential_that_would_lose_the_tolerance_is_refused_and_auto_steps() {
    // Two bodies on a damper that is not proportional: too stiff for too long a time.
    let mut parameters: Vec<f64> = {
        let simulator = chain(0.5);
        (0..simulator.shape().parameters).map(|i| simulator.parameter_default(i)).collect()
    };
    let simulator = chain(0.5);
    let stiff = (0..simulator.shape().parameters)
        .find(|index| simulator.parameter(*index).name == "second.damping")
        .expect("a parameter");
    parameters[stiff] = 1e9;
    let simulation = Simulation::new(&simulator).parameters(&parameters).rtol(1e-8);
    match simulation.clone().method(Method::Exact).run() {
        Err(SimulateError::Stopped {
            cause: StopCause::ClosedForm { reason: message }, ..
        }) => {
            assert!(message.contains("norm") && message.contains("auto"), "{message}");
        }
        other => panic!("{other:?}"),
    }
    let auto = simulation.clone().method(Method::Auto).run().expect("stepped");
    let radau = simulation.method(Method::Radau).rtol(1e-11).run().expect("stepped");
    let distance = distance(&auto, &radau);
    assert!(distance < 1e-5, "{distance:e}");
}

#[test]
fn polynomials_of_time_that_begin_late_keep_their_digits() {
    type Force = fn(f64, f64) -> String;
    let forces: [(Force, f64); 3] = [
        (|at, width| format!("4 [N]*smooth_step((t - {at:?} [s])/{width:?} [s])"), 0.9),
        (|at, width| format!("1 [N]*step(t, {at:?} [s])*((t - {at:?} [s])/{width:?} [s])^4"), 1.0),
        (
            |at, width| {
                format!(
                    "1 [N]*piecewise(t < {at:?} [s], 0, t < {:?} [s], \
                     ((t - {at:?} [s])/{width:?} [s])^4 - 2*((t - {at:?} [s])/{width:?} [s])^3, 0)",
                    at + width
                )
            },
            0.8,
        ),
    ];
    for (force, after) in forces {
        for (at, width) in [(30.0, 0.01), (1000.0, 1.0), (3000.0, 0.5), (7.0, 2.0), (5000.0, 0.2)] {
            let simulator = oscillator(1.0, 0.0, 4.0, &force(at, width));
            let until = at + after;
            let run = |method, from: f64, rtol| {
                let simulation = Simulation::new(&simulator).initial_state(&[0.0, 0.0]);
                let simulation = simulation.from(from).times(&[from, until]).until(until);
                simulation.method(method).rtol(rtol).run()
            };
            // Before, the machine is at rest.
            let reference = run(Method::Dop853, at, 1e-12).expect("it runs");
            let exact = reference.last("body.x").expect("a state");
            for method in [Method::Exact, Method::Auto] {
                let run = run(method, 0.0, 1e-9).expect("it runs");
                let x = run.last("body.x").expect("a state");
                let off = (x - exact).abs() / exact.abs();
                assert!(off < 1e-7, "{method}, {}: {x} for {exact}", force(at, width));
            }
        }
    }
}
