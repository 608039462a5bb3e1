//! Starts in equilibrium: compared with closed forms, and without motion afterwards.

#![expect(clippy::float_cmp, reason = "modes, and what is zero exactly")]

use machinist::trajectory::{ColumnKind, Trajectory};
use machinist::{SimulateError, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, Simulator, StateKind};
use machinist_model::{ModelSimulator, file};

use crate::own_scene::{of_specs, of_text, refusal};

/// Returns a mass that hangs on a spring with a cubic part.
fn hung(initial: &str) -> String {
    format!(
        r#"
        [scene]
        name = "hung"
        [units.body]
        unit = "body"
        [initial]
        {initial}
        [outputs]
        x = "body.x"
        [run]
        until = 3.0
        points = 31
        rtol = 1e-9
        method = "dop853"
        [define.body.coordinates]
        x = {{ unit = "m" }}
        [define.body.parameters]
        mass = {{ value = 2, unit = "kg" }}
        gravity = {{ value = 9.81, unit = "m/s^2" }}
        stiffness = {{ value = 300, unit = "N/m" }}
        cubic = {{ value = 4e4, unit = "N/m^3" }}
        [define.body.energy]
        kinetic = "mass*x_dot^2/2"
        potential = "stiffness*x^2/2 + cubic*x^4/4 + mass*gravity*x"
        "#
    )
}

/// Returns the real root of k x + c x^3 = -m g, by Cardano's formula.
fn hangs_at([mass, gravity, stiffness, cubic]: [f64; 4]) -> f64 {
    let (p, q) = (stiffness / cubic, mass * gravity / cubic);
    let root = (q * q / 4.0 + p * p * p / 27.0).sqrt();
    let larger = (-q / 2.0 - root).cbrt();
    larger - p / (3.0 * larger)
}

/// Returns the largest move of a column, relative to its size, or to `least` if that is larger.
fn move_of(run: &Trajectory, name: &str, least: f64) -> f64 {
    let values = run.column(name).expect("a column");
    let size = values.iter().fold(least, |most, value| most.max(value.abs()));
    values.iter().fold(0.0, |most: f64, value| most.max((value - values[0]).abs())) / size
}

/// Asserts that all states without drift are at rest.
fn assert_still(simulator: &dyn Simulator<f64>, run: &Trajectory) {
    for (index, column) in run.of_kind(ColumnKind::State).enumerate() {
        let moves = match simulator.state_kind(index) {
            StateKind::Position if column.values[0] == 0.0 => continue,
            _ => move_of(run, &column.name, simulator.state_scale(index)),
        };
        assert!(moves < 1e-9, "{} moves by {moves:e}", column.name);
    }
}

fn run(simulator: &dyn Simulator<f64>) -> Trajectory {
    Simulation::new(simulator).run().expect("it starts in equilibrium and runs")
}

#[test]
fn a_mass_on_a_stiffening_spring_hangs_where_cardano_says() {
    let simulator = of_text(&hung("from = \"equilibrium\""), Keep::Needed);
    assert!(simulator.starts_in_equilibrium());
    for [mass, stiffness, cubic] in
        [[2.0, 300.0, 4e4], [1e-6, 1e-9, 3.0], [5e6, 1e3, 1e-2], [2.0, 1e12, 1.0], [0.1, 7.0, 1e9]]
    {
        let simulation = Simulation::new(&simulator).parameter("body.mass", mass);
        let simulation = simulation.and_then(|run| run.parameter("body.stiffness", stiffness));
        let simulation = simulation.and_then(|run| run.parameter("body.cubic", cubic));
        let run = simulation.and_then(|run| run.run()).expect("it hangs");
        let x = run.column("x").expect("x")[0];
        let [weight, pull] = [mass * 9.81, -(stiffness * x + cubic * x * x * x)];
        assert!((pull / weight - 1.0).abs() < 1e-9, "{pull} for {weight} N");
        assert!(move_of(&run, "x", 0.0) < 1e-6, "{mass}: {}", move_of(&run, "x", 0.0));
    }
    let exact = hangs_at([2.0, 9.81, 300.0, 4e4]);
    assert!((run(&simulator).column("x").expect("x")[0] / exact - 1.0).abs() < 1e-12);
    // As given, it falls.
    let given = Simulation::new(&simulator).in_equilibrium(false).run().expect("it falls");
    assert!(given.column("x").expect("x")[0] == 0.0 && move_of(&given, "x", 0.0) > 0.9);
}

#[test]
fn models_keep_the_wish_and_a_run_may_have_one_of_its_own() {
    let simulator = of_text(&hung("from = \"equilibrium\""), Keep::Needed);
    let stamped = file::Stamped { generator: String::new(), model: simulator.model().clone() };
    let read = file::read(&file::write(&stamped)).expect("a model");
    let of_file = ModelSimulator::new(read.model);
    assert_eq!(run(&simulator).columns, run(&of_file).columns);

    let plain = of_text(&hung("\"body.x\" = 0.01"), Keep::Needed);
    assert!(!plain.starts_in_equilibrium());
    assert_eq!(run(&plain).column("x").expect("x")[0].to_bits(), 0.01_f64.to_bits());
    let asked = Simulation::new(&plain).in_equilibrium(true).run().expect("it hangs");
    let same = run(&simulator);
    let [a, b] = [&asked, &same].map(|run| run.column("x").expect("x")[0]);
    assert!((a / b - 1.0).abs() < 1e-12);
    // A run starts in a state given by the caller.
    let own = Simulation::new(&simulator).initial_state(&[0.2, 0.0]).run().expect("it runs");
    assert_eq!(own.column("x").expect("x")[0].to_bits(), 0.2_f64.to_bits());
    let near = Simulation::new(&simulator).initial_state(&[0.2, 0.0]).in_equilibrium(true);
    let found = near.run().expect("it hangs").column("x").expect("x")[0];
    assert!((found / b - 1.0).abs() < 1e-12);
}

/// Returns a pendulum tilted by a torque, described by its angle or by x and y on a rod.
fn tilted(by_angle: bool, initial: &str) -> String {
    let (coordinates, energy, extra, output) = if by_angle {
        (
            "phi = { unit = \"rad\" }",
            "kinetic = \"mass*length^2*phi_dot^2/2\"
             potential = \"-mass*gravity*length*cos(phi)\"",
            "[[define.bob.forces]]\ncoordinate = \"phi\"\nexpression = \"torque\"",
            "bob.phi",
        )
    } else {
        (
            "x = { unit = \"m\" }\ny = { unit = \"m\" }",
            "kinetic = \"mass*(x_dot^2 + y_dot^2)/2\"
             potential = \"mass*gravity*y\"",
            "[define.bob.constraints.rod]
             expression = \"x^2 + y^2 - length^2\"
             [[define.bob.forces]]
             coordinate = \"x\"
             expression = \"-torque*y/length^2\"
             [[define.bob.forces]]
             coordinate = \"y\"
             expression = \"torque*x/length^2\"
             [define.bob.outputs.angle]
             expression = \"asin(x/length)\"
             unit = \"rad\"",
            "bob.angle",
        )
    };
    format!(
        r#"
        [scene]
        name = "tilted"
        [units.bob]
        unit = "bob"
        [initial]
        from = "equilibrium"
        {initial}
        [outputs]
        phi = "{output}"
        [run]
        until = 3.0
        points = 31
        rtol = 1e-10
        method = "dop853"
        [define.bob.coordinates]
        {coordinates}
        [define.bob.parameters]
        mass = {{ value = 1.2, unit = "kg" }}
        gravity = {{ value = 9.81, unit = "m/s^2" }}
        length = {{ value = 0.7, unit = "m" }}
        torque = {{ value = 3.0, unit = "N m" }}
        [define.bob.energy]
        {energy}
        {extra}
        "#
    )
}

#[test]
fn a_pendulum_tilts_as_its_torque_has_it_by_angle_and_by_constraint() {
    let by_constraint = tilted(false, "\"bob.x\" = 0\n[guess]\n\"bob.y\" = -0.5");
    for text in [tilted(true, ""), by_constraint] {
        let machine = &of_text(&text, Keep::Needed);
        for torque in [0.0, 1e-7, 3.0, -6.0, 8.0] {
            let simulation = Simulation::new(machine).parameter("bob.torque", torque);
            let run = simulation.and_then(|run| run.run()).expect("it hangs");
            let exact = (torque / (1.2 * 9.81 * 0.7)).asin();
            let found = run.column("phi").expect("phi")[0];
            assert!((found - exact).abs() < 1e-9 * exact.abs().max(1e-9), "{found} {exact}");
            assert_still(machine, &run);
            assert!(run.notes.iter().all(|note| !note.contains("unstable")));
        }
        let beyond = Simulation::new(machine).parameter("bob.torque", 9.0);
        match beyond.and_then(|run| run.run()) {
            Err(SimulateError::NoEquilibrium(why)) => {
                assert!(why.contains("no equilibrium near the guess") && why.contains("[initial]"));
            }
            other => panic!("{:?}", other.map(|run| run.column("phi").map(<[f64]>::to_vec))),
        }
    }
}

#[test]
fn an_equilibrium_on_top_is_told_to_be_unstable() {
    let simulator = of_text(&tilted(true, "\"bob.phi\" = 3.0"), Keep::Needed);
    let simulation = Simulation::new(&simulator).parameter("bob.torque", 0.0).expect("it is one");
    let run = simulation.clone().until(0.5).run().expect("it stands");
    let found = run.column("phi").expect("phi")[0];
    assert!((found - std::f64::consts::PI).abs() < 1e-12, "{found}");
    let note = simulation.run().expect("it falls").notes;
    let time = (0.7_f64 / 9.81).sqrt();
    let told = format!("unstable: deviations grow by e in {time:.3e} s");
    assert!(note.iter().any(|note| note.contains(&told)), "{told}: {note:?}");
}

#[test]
fn a_motor_under_load_starts_at_the_speed_its_curve_gives() {
    // U = R i + k w, J w' = k i - load, and c w^2 on the fan behind an elastic shaft.
    let text = r#"
        [scene]
        name = "driven"
        [units.m]
        unit = "m"
        [initial]
        from = "equilibrium"
        "m.fan" = 0.3
        [outputs]
        speed = "m.fan_dot"
        current = "m.current"
        twist = { expression = "m.rotor - m.fan", unit = "rad" }
        angle = "m.fan"
        [run]
        until = 2.0
        points = 21
        rtol = 1e-9
        method = "auto"
        [define.m.coordinates]
        rotor = { unit = "rad" }
        fan = { unit = "rad" }
        [define.m.parameters]
        inertia = { value = 0.3, unit = "kg m^2" }
        voltage = { value = 200, unit = "V" }
        resistance = { value = 0.5, unit = "ohm" }
        inductance = { value = 0.02, unit = "H" }
        constant = { value = 1.1, unit = "N m/A" }
        stiffness = { value = 900, unit = "N m/rad" }
        damping = { value = 2, unit = "N m s/rad" }
        drag = { value = 4e-3, unit = "N m s^2/rad^2" }
        [define.m.states.current]
        unit = "A"
        rate = "(voltage - resistance*current - constant*rotor_dot)/inductance"
        [define.m.energy]
        kinetic = "inertia*(rotor_dot^2 + fan_dot^2)/2"
        potential = "stiffness*(rotor - fan)^2/2"
        dissipation = "damping*(rotor_dot - fan_dot)^2/2"
        stored = "inductance*current^2/2"
        [define.m.power]
        supplied = "voltage*current"
        dissipated = "resistance*current^2"
        [[define.m.forces]]
        coordinate = "rotor"
        expression = "constant*current"
        conversion = true
        [[define.m.forces]]
        coordinate = "fan"
        expression = "-drag*fan_dot*abs(fan_dot)"
        "#;
    let simulator = of_text(text, Keep::Needed);
    for voltage in [0.5, 20.0, 200.0, 5000.0] {
        let simulation = Simulation::new(&simulator).parameter("m.voltage", voltage);
        let run = simulation.and_then(|run| run.run()).expect("it turns");
        // k (U - k w)/R = c w^2
        let b = 1.1 * 1.1 / 0.5 / 4e-3;
        let speed = b * ((1.0 + 4.0 * voltage / 1.1 / b).sqrt() - 1.0) / 2.0;
        let torque = 4e-3 * speed * speed;
        let columns =
            ["speed", "current", "twist", "angle"].map(|name| run.column(name).expect(name));
        let found = columns.map(|column| column[0]);
        for (found, exact) in found.iter().zip([speed, torque / 1.1, torque / 900.0]) {
            assert!((found / exact - 1.0).abs() < 1e-9, "{found} {exact} at {voltage} V");
        }
        // Named states move only if required: the twist is in the rotor's angle.
        assert!((found[3] - 0.3).abs() < 1e-12, "{}", found[3]);
        for name in ["speed", "current", "twist"] {
            assert!(move_of(&run, name, 1.0) < 1e-5, "{name} {:e}", move_of(&run, name, 1.0));
        }
    }
}

/// A mass above an elastic stop, and one that rests on a rigid one.
const STOPPED: &str = r#"
    [scene]
    name = "stopped"
    [units.body]
    unit = "translational/mass"
    parameters = { mass = 3 }
    [units.weight]
    unit = "sources/force"
    inputs = { force = "-30 [N]" }
    [units.floor]
    unit = "floor"
    [[joints]]
    connect = ["weight.a", "body.a"]
    [[joints]]
    connect = ["floor.a", "body.b"]
    [initial]
    from = "equilibrium"
    "body.x" = 2.5
    [outputs]
    x = "body.x"
    closed = "floor.closed"
    [run]
    until = 1.0
    points = 11
    rtol = 1e-9
    method = "dop853"
    [define.floor.coordinates]
    x = { unit = "m" }
    [define.floor.ports.a]
    kind = "translational"
    coordinate = "x"
    [define.floor.parameters]
    stiffness = { value = 1e5, unit = "N/m" }
    [define.floor.modes.closed]
    initial = 0
    [define.floor.helpers.push]
    expression = "piecewise(closed < 1, 0 [N], -stiffness*x)"
    unit = "N"
    [define.floor.events.touches]
    guard = "x"
    direction = "falling"
    when = { closed = 0 }
    set = { closed = 1 }
    [define.floor.events.leaves]
    guard = "push"
    direction = "falling"
    when = { closed = 1 }
    set = { closed = 0 }
    [[define.floor.forces]]
    coordinate = "x"
    expression = "push"
    "#;

#[test]
fn a_mass_above_a_stop_comes_to_lie_on_it() {
    let simulator = of_text(STOPPED, Keep::Needed);
    let run = run(&simulator);
    let [x, closed] = ["x", "closed"].map(|name| run.column(name).expect(name));
    assert!((x[0] / -3e-4 - 1.0).abs() < 1e-9, "{}", x[0]);
    assert!(closed.iter().all(|closed| *closed == 1.0) && run.switches.is_empty());
    assert!(move_of(&run, "x", 0.0) < 1e-7);
    // Nothing holds it from above.
    let up = STOPPED.replace("-30 [N]", "30 [N]");
    let error = Simulation::new(&of_text(&up, Keep::Needed)).run().expect_err("it flies off");
    assert!(error.to_string().contains("`body.v` changes by 1.000e1 m/s a second"), "{error}");
}

#[test]
fn a_brake_that_sticks_holds_what_it_can() {
    let text = |torque: f64, speed: f64| {
        format!(
            r#"
            [scene]
            name = "braked"
            [units.rotor]
            unit = "rotational/inertia"
            parameters = {{ inertia = 2 }}
            [units.brake]
            unit = "rotational/brake"
            inputs = {{ normal_force = "100 [N]" }}
            [units.drive]
            unit = "sources/torque"
            inputs = {{ torque = "{torque} [N m]" }}
            [units.fan]
            unit = "sources/fan"
            [[joints]]
            connect = ["rotor.a", "drive.a"]
            [[joints]]
            connect = ["rotor.b", "brake.a"]
            [[joints]]
            connect = ["rotor.b", "fan.a"]
            [initial]
            from = "equilibrium"
            "rotor.omega" = {speed}
            [outputs]
            speed = "rotor.omega"
            slip = "brake.slip"
            [run]
            until = 1.0
            points = 11
            rtol = 1e-9
            method = "dop853"
            "#
        )
    };
    // It holds 50 N m. Beyond that the fan has to take the rest; a rotor that turns, and is
    // driven by less, is slowed until it sticks.
    for (torque, speed, exact) in [
        (40.0, 0.0, 0.0),
        (80.0, 0.0, 150.0 * 3.0_f64.sqrt()),
        (40.0, 100.0, 0.0),
        (90.0, 500.0, 300.0),
    ] {
        let simulator = of_text(&text(torque, speed), Keep::Needed);
        let run = run(&simulator);
        let [found, slip] = ["speed", "slip"].map(|name| run.column(name).expect(name));
        assert!((found[0] - exact).abs() <= 1e-9 * exact, "{} at {torque} N m", found[0]);
        assert!(move_of(&run, "speed", 1e-3) < 1e-7 && run.switches.is_empty(), "{torque}");
        let is_right = |slip: &f64| *slip == if exact == 0.0 { 0.0 } else { 1.0 };
        assert!(slip.iter().all(is_right), "{slip:?} at {torque} N m from {speed} rad/s");
    }
}

#[test]
fn sensitivities_of_a_start_in_equilibrium_are_those_of_its_closed_form() {
    let hung = of_text(&hung("from = \"equilibrium\""), Keep::Needed);
    let by = ["body.mass", "body.stiffness", "body.cubic", "body.x"];
    let simulation = Simulation::new(&hung).sensitivities(&by).expect("they are known");
    let run = simulation.run().expect("it hangs");
    let x = run.column("x").expect("x")[0];
    let slope = 300.0 + 3.0 * 4e4 * x * x;
    for (by, exact) in by.iter().zip([-9.81, -x, -x * x * x, 0.0]) {
        let found = run.sensitivity("x", by).expect("it was asked for");
        for found in found {
            assert!((found - exact / slope).abs() <= 1e-7 * (exact / slope).abs(), "{by} {found}");
        }
    }
    let tilted = of_text(&tilted(false, "\"bob.x\" = 0\n[guess]\n\"bob.y\" = -0.5"), Keep::Needed);
    let by = ["bob.torque", "bob.length"];
    let simulation = Simulation::new(&tilted).sensitivities(&by).expect("they are known");
    let run = simulation.run().expect("it hangs");
    // sin(phi) = t/(m g l)
    let sine = 3.0 / (1.2 * 9.81 * 0.7_f64);
    let slope = sine / (1.0 - sine * sine).sqrt();
    for (by, exact) in by.iter().zip([slope / 3.0, -slope / 0.7]) {
        let found = run.sensitivity("phi", by).expect("it was asked for")[0];
        assert!((found / exact - 1.0).abs() < 1e-8, "{by}: {found} {exact}");
    }
}

#[test]
fn machines_of_the_specs_start_in_equilibrium_and_stay() {
    // Hanging, within constraints, on a brake, at synchronous speed from standstill.
    for name in ["four_bar", "pendulum_constrained", "drives/winch", "drives/press", "motor_run_up"]
    {
        let simulator = of_specs(name, Keep::Needed);
        let simulation = Simulation::new(&simulator).in_equilibrium(true);
        let run = simulation.until(0.05).points(6).run();
        let run = run.unwrap_or_else(|error| panic!("{name}: {error}"));
        for (index, column) in run.of_kind(ColumnKind::State).enumerate() {
            if simulator.state_kind(index) == StateKind::Velocity {
                let scale = simulator.state_scale(index).max(column.values[0].abs());
                let moves = column.values.iter().map(|value| (value - column.values[0]).abs());
                let moves = moves.fold(0.0, f64::max) / scale;
                assert!(moves < 1e-6, "{name}: {} by {moves:e}", column.name);
            }
        }
    }
}

#[test]
fn bad_wishes_are_refused_at_their_place() {
    let told = refusal(&hung("from = \"equilibrum\""));
    for part in ["a start is `from = \"equilibrium\"`", "did you mean"] {
        assert!(told.contains(part), "{told}");
    }
    assert!(refusal(&hung("from = 3")).contains("from"));
}
