//! `[friction.NAME]` of units and scenes: sliding, sticking and breakaway compared with closed
//! forms and with standard parts written out by hand.

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

/// Methods that support constraints.
const METHODS: [Method; 5] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Auto];

fn scene(head: &str, body: &str) -> ModelSimulator {
    let text =
        format!("[scene]\nname = \"friction\"\n{head}\n[run]\nuntil = 10\npoints = 401\n{body}");
    of_text(&text, Keep::Needed)
}

const BLOCK: &str = r#"
    [define.block.coordinates.x]
    unit = "m"
    velocity = "v"
    [define.block.parameters]
    mass = { value = 2.0, unit = "kg" }
    stiffness = { value = 50.0, unit = "N/m" }
    coulomb = { value = 6.0, unit = "N" }
    [define.block.energy]
    kinetic = "mass*v^2/2"
    potential = "stiffness*x^2/2"
    [define.block.friction.guide]
    speed = "v"
    sliding = "coulomb"
    unit = "N"
    doc = "of the guide"
"#;

fn block() -> ModelSimulator {
    let head = r#"
        [units.block]
        unit = "block"
        [initial]
        "block.x" = 1
        [outputs]
        friction = "block.guide"
    "#;
    scene(head, BLOCK)
}

fn last(run: &Trajectory, name: &str) -> f64 {
    *run.column(name).and_then(|values| values.last()).expect("a column")
}

/// Each half cycle is a sine about a point F/k away: it ends 2 F/k nearer, and the last one where
/// the spring force is less than F.
#[test]
fn a_sprung_block_swings_2_f_over_k_less_each_time_and_rests() {
    let block = block();
    for (mass, stiffness, coulomb) in [
        (2.0, 50.0, 6.0),
        (2.0, 50.0, 0.37),
        (1e-9, 2e-3, 1.3e-4),
        (4e3, 3e6, 2e5),
        (2.0, 50.0, 60.0),
    ] {
        let step = coulomb / stiffness;
        let mut rest = 1.0f64;
        while rest.abs() > step {
            rest = 2.0 * step * rest.signum() - rest;
        }
        let halves = (1.0 / (2.0 * step)).ceil() + 1.0;
        let until = halves * std::f64::consts::PI * f64::sqrt(mass / stiffness);
        for method in METHODS {
            for rtol in [1e-4, 1e-7, 1e-10] {
                let run = Simulation::new(&block).method(method).rtol(rtol).until(until);
                let run = run.parameter("block.mass", mass).expect("a parameter");
                let run = run.parameter("block.stiffness", stiffness).expect("a parameter");
                let run = run.parameter("block.coulomb", coulomb).expect("a parameter").run();
                let run = run.unwrap_or_else(|error| panic!("{method}, {rtol:e}: {error}"));
                let (x, v) = (last(&run, "block.x"), last(&run, "block.v"));
                let what = format!("{method}, {rtol:e}, {coulomb} N of {stiffness} N/m: {x}, {v}");
                assert!((x - rest).abs() < 300.0 * rtol && v.abs() < 1e-9, "{what}, not {rest}");
                let held = last(&run, "friction");
                let pulls = stiffness * x;
                assert!((held - pulls).abs() < 1e-6 * coulomb, "{what}: {held} holds {pulls}");
            }
        }
    }
}

/// A part written out by hand, with Stribeck friction and an alternating force.
#[test]
fn it_moves_as_the_standard_part_does() {
    let head = |unit: &str, more: &str| {
        format!(
            r#"
            [units.body]
            unit = "translational/mass"
            [units.guide]
            unit = "{unit}"
            [[joints]]
            connect = ["body.b", "guide.a"]
            [[forces]]
            port = "body.b"
            expression = "2.5 [N]*sin(1.3 [rad/s]*t) - 0.7 [N/m]*body.x"
            [outputs]
            force = "guide.{more}"
            "#
        )
    };
    let own = r#"
        [define.own.coordinates.x]
        unit = "m"
        [define.own.ports.a]
        kind = "translational"
        coordinate = "x"
        [define.own.friction.rubs]
        speed = "x_dot"
        sliding = "1 [N] + 0.5 [N]*exp(-abs(x_dot)/(0.1 [m/s])) + 0.01 [N s/m]*abs(x_dot)"
        breakaway = "1.5 [N]"
        unit = "N"
    "#;
    let part = scene(&head("translational/friction", "force"), "");
    let own = scene(&head("own", "rubs"), own);
    for method in METHODS {
        let runs = [&part, &own]
            .map(|machine| Simulation::new(machine).method(method).rtol(1e-9).run().expect("ends"));
        let switches = runs.each_ref().map(|run| run.work.switches);
        assert_eq!(switches[0], switches[1], "{method}");
        assert!(switches[0] > 5, "{method}: {switches:?}");
        for name in ["body.x", "body.v", "force"] {
            let [a, b] = runs.each_ref().map(|run| run.column(name).expect("a column"));
            let off = a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
            assert!(off < 1e-6, "{method}, {name}: {off:e}");
        }
    }
}

/// A pad between two bodies: forces on them are equal and opposite, and they end with a common
/// velocity.
#[test]
fn between_two_bodies_momentum_stays() {
    let machine = scene(
        r#"
        [units.low]
        unit = "translational/mass"
        parameters = { mass = 3 }
        [units.top]
        unit = "translational/mass"
        parameters = { mass = 1 }
        [initial]
        "top.v" = 2
        [friction.pad]
        speed = "top.v - low.v"
        sliding = "1.5 [N]"
        unit = "N"
        [outputs]
        pad = "pad"
        "#,
        "",
    );
    for method in METHODS {
        let run = Simulation::new(&machine).method(method).rtol(1e-8).run().expect("ends");
        let [low, top] = ["low.v", "top.v"].map(|name| run.column(name).expect("a state"));
        for (low, top) in low.iter().zip(top) {
            assert!((3.0 * low + top - 2.0).abs() < 1e-9, "{method}: {low}, {top}");
        }
        // They move together after v/(F/m + F/M) = 1 s, at 2/(1 + 3) m/s.
        let times = run.times.iter().zip(low.iter().zip(top));
        for (time, (low, top)) in times {
            let expected = if *time < 1.0 { 2.0 - 2.0 * time } else { 0.0 };
            assert!((top - low - expected).abs() < 1e-7, "{method} at {time} s: {top}, {low}");
        }
        assert!(last(&run, "pad").abs() < 1e-9, "{method}");
    }
}

/// A belt with a prescribed speed: at each moment it supplies the power that friction gives to the
/// block and dissipates.
#[test]
fn a_belt_supplies_what_friction_gives_and_loses() {
    let machine = scene(
        r#"
        [units.block]
        unit = "block"
        [outputs]
        friction = "block.pad"
        slides = "block.pad_slide"
        "#,
        r#"
        [define.block.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.block.helpers.belt]
        expression = "0.3 [m/s]*(1 + 0.5*sin(2 [rad/s]*t))"
        unit = "m/s"
        [define.block.energy]
        kinetic = "2 [kg]*v^2/2"
        potential = "50 [N/m]*x^2/2"
        [define.block.friction.pad]
        speed = "v - belt"
        sliding = "5 [N] + 1.2 [N]*exp(-abs(v - belt)/(0.1 [m/s]))"
        breakaway = "7 [N]"
        unit = "N"
        "#,
    );
    let run = Simulation::new(&machine).rtol(1e-10).run().expect("ends");
    assert!(run.work.switches > 5, "{}", run.work.switches);
    let columns = ["block.x", "block.v", "slides"].map(|name| run.column(name).expect("there"));
    let parameters: Vec<f64> = Vec::new();
    let modes = run.column("block.pad_slip").expect("a mode");
    for (row, time) in run.times.iter().enumerate() {
        let [x, v, slides] = columns.each_ref().map(|column| column[row]);
        let belt = 0.3 * (1.0 + 0.5 * f64::sin(2.0 * time));
        let state = [x, v, modes[row]];
        let power = Simulator::<f64>::power_balance(&machine, *time, &state, &parameters);
        if modes[row] != 0.0 {
            assert!((power.supplied - slides * belt).abs() < 1e-9, "{time}: {power:?}");
            assert!((power.dissipated + slides * (v - belt)).abs() < 1e-9, "{time}: {power:?}");
            assert!(power.dissipated > -1e-9, "{time}: {power:?}");
        }
    }
}

/// While one part sticks, noise of speeds at a switching surface ends steps; other parts must break
/// away at the right time meanwhile.
#[test]
fn what_breaks_away_beside_what_sticks_does_so_in_time() {
    let body = r#"
        [define.block.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.block.helpers.belt]
        expression = "0.3 [m/s]*(1 + 0.5*sin(2 [rad/s]*t))"
        unit = "m/s"
        [define.block.energy]
        kinetic = "2 [kg]*v^2/2"
        potential = "50 [N/m]*x^2/2"
        [define.block.friction.guide]
        speed = "v - belt"
        sliding = "5.886 [N]*(0.7 + 0.3*exp(-abs(v - belt)/(0.1 [m/s])))"
        breakaway = "6.4746 [N]"
        unit = "N"
    "#;
    let alone = "[units.block]\nunit = \"block\"\n[initial]\n\"block.x\" = 0.2\n";
    let beside = r#"
        [units.block]
        unit = "block"
        [units.plate]
        unit = "translational/mass"
        parameters = { mass = 3 }
        [units.top]
        unit = "translational/mass"
        [initial]
        "block.x" = 0.2
        "top.v" = 2
        [friction.pad]
        speed = "top.v - plate.v"
        sliding = "4 [N] + 1 [N s/m]*abs(top.v - plate.v)"
        breakaway = "6 [N]"
        unit = "N"
        [[forces]]
        port = "plate.b"
        expression = "7 [N]*sin(3 [rad/s]*t)"
    "#;
    let (alone, beside) = (scene(alone, body), scene(beside, body));
    let run = |machine, method, rtol: f64| {
        let run = Simulation::new(machine).method(method).rtol(rtol).run();
        last(&run.unwrap_or_else(|error| panic!("{method}, {rtol:e}: {error}")), "block.x")
    };
    let exact = run(&alone, Method::Radau, 1e-12);
    assert!((exact - run(&alone, Method::Dop853, 1e-12)).abs() < 1e-9, "{exact}");
    for method in METHODS {
        for step in 0..12 {
            let rtol = 10f64.powf(-6.0 - 0.4 * f64::from(step));
            let x = run(&beside, method, rtol);
            assert!(
                (x - exact).abs() < 300.0 * rtol + 1e-9,
                "{method}, {rtol:e}: {x}, not {exact}"
            );
        }
    }
}

/// The brake's limit is 10 N m. At loose tolerances those of the stiff shaft's angles are worth more
/// than what the drive pulls above it.
#[test]
fn a_brake_that_is_too_weak_at_the_start_lets_go_at_any_tolerance() {
    let scene = of_text(
        r#"
        [scene]
        name = "overloaded"
        [units.drive]
        unit = "sources/torque"
        inputs = { torque = "torque" }
        [units.motor]
        unit = "rotational/inertia"
        parameters = { inertia = 0.1 }
        [units.shaft]
        unit = "rotational/spring_damper"
        parameters = { stiffness = 1e7, damping = 1e3 }
        [units.rotor]
        unit = "rotational/inertia"
        parameters = { inertia = 1 }
        [units.brake]
        unit = "rotational/brake"
        parameters = { friction = 1 }
        inputs = { normal_force = "10 [N]" }
        [[joints]]
        connect = ["drive.a", "motor.a"]
        [[joints]]
        connect = ["motor.b", "shaft.a"]
        [[joints]]
        connect = ["shaft.b", "rotor.a"]
        [[joints]]
        connect = ["rotor.b", "brake.a"]
        [parameters]
        torque = { value = 15, unit = "N m" }
        [initial]
        "motor.phi" = "torque/shaft.stiffness"
        [run]
        until = 2
        points = 3
        "#,
        Keep::All,
    );
    for stiffness in [1e6, 1e7, 1e9] {
        for (torque, speed) in [(9.0, 0.0), (10.5, 1.0 / 1.1), (15.0, 10.0 / 1.1)] {
            for rtol in [1e-3, 1e-5, 1e-6, 1e-7, 1e-9] {
                for method in [Method::Auto, Method::Radau] {
                    let run = Simulation::new(&scene).method(method).rtol(rtol);
                    let run = run.parameter("shaft.stiffness", stiffness).expect("a parameter");
                    let run = run.parameter("torque", torque).expect("a parameter").run();
                    let found = run.expect("a run").last("rotor.omega").expect("a state");
                    let what = format!("{method} at {rtol:e}, {stiffness:e}, {torque} N m");
                    assert!((found - speed).abs() < 2e-3, "{what}: {found} and not {speed}");
                }
            }
        }
    }
}

/// A contact that closes while slower than its sticking speed but faster than the tolerances decides
/// once: m v' = F - r t.
#[test]
fn a_contact_pressed_ever_harder_under_a_load_begins_to_slide() {
    let head = r#"
        [units.block]
        unit = "block"
    "#;
    let body = r#"
        [define.block.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.block.energy]
        kinetic = "1 [kg]*v^2"
        [[define.block.forces]]
        coordinate = "x"
        expression = "20 [N]"
        [define.block.friction.guide]
        speed = "v"
        sliding = "30 [N/s]*t"
        breakaway = "45 [N/s]*t"
        idle = "1e-6 [N]"
        sticking_speed = "1e-6 [m/s]"
        unit = "N"
    "#;
    let block = scene(head, body);
    for method in METHODS {
        for rtol in [1e-4, 1e-6, 1e-8, 1e-11] {
            let run = Simulation::new(&block).method(method).rtol(rtol).until(1.0).run();
            let run = run.unwrap_or_else(|error| panic!("{method} at {rtol:e}: {error}"));
            let found = last(&run, "block.v");
            assert!((found - 2.5).abs() < 1e-5, "{method} at {rtol:e}: {found} and not 2.5");
        }
    }
}
