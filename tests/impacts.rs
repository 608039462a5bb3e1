//! Impacts beside dry friction: a finite force sends no impulse, so what is thrown slides, and
//! friction begins anew from the speed after the impact. Compared with closed forms.

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::fixed_step::StepMethod;
use machinist_model::ModelSimulator;

use crate::fixed_steps::steps_in_rust;
use crate::own_scene::of_text;

/// Methods that support constraints.
const METHODS: [Method; 6] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Auto, Method::Exact];

fn scene(text: &str) -> ModelSimulator {
    of_text(&format!("[scene]\nname = \"impact\"\n{text}"), Keep::Needed)
}

fn run(machine: &ModelSimulator, method: Method, rtol: f64, values: &[(&str, f64)]) -> Trajectory {
    let mut run = Simulation::new(machine).method(method).rtol(rtol).with_energy_balance(true);
    for (name, value) in values {
        run = run.parameter(name, *value).expect("a parameter");
    }
    run.run().unwrap_or_else(|error| panic!("{method}, {rtol:e}, {values:?}: {error}"))
}

fn happened(run: &Trajectory, event: &str) -> usize {
    run.switches.iter().filter(|switch| switch.event == event).count()
}

/// A block that slides to a wall and is thrown back.
const WALL: &str = r#"
    [units.block]
    unit = "block"
    [initial]
    "block.v" = "block.start"
    [run]
    until = 4
    points = 81
    [define.block.coordinates.x]
    unit = "m"
    velocity = "v"
    [define.block.parameters]
    start = { value = 1.0, unit = "m/s" }
    mass = { value = 2.0, unit = "kg" }
    coulomb = { value = 0.1, unit = "N" }
    restitution = { value = 0.8, unit = "1" }
    wall = { value = 0.5, unit = "m" }
    [define.block.energy]
    kinetic = "mass*v^2/2"
    [define.block.friction.guide]
    speed = "v"
    sliding = "coulomb"
    unit = "N"
    [define.block.events.hits]
    guard = "x - wall"
    direction = "rising"
    set = { v = "-restitution*v" }
"#;

/// A block of [`WALL`]: position and speed at a time.
fn at_wall(start: f64, slows: f64, restitution: f64, wall: f64, time: f64) -> [f64; 2] {
    let slide = |start: f64, time: f64| {
        let time = if slows > 0.0 { time.min(start / slows) } else { time };
        [start * time - slows * time * time / 2.0, start - slows * time]
    };
    let left = start * start - 2.0 * slows * wall;
    let meets = 2.0 * wall / (start + left.max(0.0).sqrt());
    if left <= 0.0 || time <= meets {
        return slide(start, time);
    }
    let [x, v] = slide(restitution * left.sqrt(), time - meets);
    [wall - x, -v]
}

#[test]
fn what_a_wall_throws_back_slides_on() {
    let machine = scene(WALL);
    for (start, mass, coulomb, restitution, wall) in [
        (1.0, 2.0, 0.1, 0.8, 0.5),
        (1.0, 2.0, 1.9, 0.8, 0.5),
        (1.0, 2.0, 1e-7, 1.0, 0.5),
        (1.0, 2.0, 0.4, 0.01, 0.5),
        (1.0, 2.0, 0.4, 0.0, 0.5),
        // It rests before the wall.
        (1.0, 2.0, 2.1, 0.8, 0.5),
        (300.0, 1e-3, 2.0, 0.5, 100.0),
        (1e-3, 50.0, 1e-4, 0.9, 2e-4),
    ] {
        let values = [
            ("block.start", start),
            ("block.mass", mass),
            ("block.coulomb", coulomb),
            ("block.restitution", restitution),
            ("block.wall", wall),
        ];
        for method in METHODS {
            for rtol in [1e-4, 1e-6, 1e-9] {
                let run = run(&machine, method, rtol, &values);
                let [x, v] = ["block.x", "block.v"].map(|name| run.column(name).expect("a column"));
                for ((time, x), v) in run.times.iter().zip(x).zip(v) {
                    let exact = at_wall(start, coulomb / mass, restitution, wall, *time);
                    let off = (x - exact[0]).abs() / wall + (v - exact[1]).abs() / start;
                    let what = format!("{method}, {rtol:e}, {values:?} at {time}");
                    assert!(off < 300.0 * rtol, "{what}: {x}, {v}, not {exact:?}");
                }
                let balance = run.energy_balance.as_ref().expect("asked for");
                assert!(balance.max_residual_relative() < 300.0 * rtol, "{method}, {values:?}");
            }
        }
    }
}

#[test]
fn sensitivities_go_through_the_impact() {
    let machine = scene(WALL);
    let by = ["block.coulomb", "block.restitution", "block.wall", "block.start"];
    // Before it rests again.
    let time = 1.5;
    let values = [0.1, 0.8, 0.5, 1.0];
    let exact = |values: [f64; 4]| at_wall(values[3], values[0] / 2.0, values[1], values[2], time);
    for method in METHODS.into_iter().filter(|method| *method != Method::Rodas5p) {
        let run = Simulation::new(&machine).method(method).rtol(1e-9).until(time).points(2);
        let run = run.sensitivities(&by).expect("known").run().expect("it runs");
        for (number, by) in by.into_iter().enumerate() {
            let moved = |step: f64| {
                let mut moved = values;
                moved[number] += step;
                exact(moved)
            };
            let [ahead, behind] = [1e-5, -1e-5].map(moved);
            for (entry, of) in ["block.x", "block.v"].into_iter().enumerate() {
                let found = *run.sensitivity(of, by).expect("a column").last().expect("rows");
                let slope = (ahead[entry] - behind[entry]) / 2e-5;
                assert!((found - slope).abs() < 1e-6, "{method}, {of} by {by}: {found}, {slope}");
            }
        }
    }
}

/// A block at rest, held by friction against a force, is kicked.
#[test]
fn what_sticks_slides_when_it_is_kicked() {
    let machine = scene(
        r#"
        [units.block]
        unit = "block"
        [run]
        until = 8
        points = 81
        [outputs]
        guide = "block.guide"
        [define.block.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.block.parameters]
        mass = { value = 2.0, unit = "kg" }
        coulomb = { value = 1.0, unit = "N" }
        pull = { value = 0.5, unit = "N" }
        kick = { value = 1.0, unit = "m/s" }
        [define.block.energy]
        kinetic = "mass*v^2/2"
        potential = "-pull*x"
        [define.block.friction.guide]
        speed = "v"
        sliding = "coulomb"
        unit = "N"
        [define.block.events.kicked]
        guard = "t - 0.7 [s]"
        direction = "rising"
        set = { v = "v + kick" }
        "#,
    );
    for (coulomb, pull, kick) in
        [(1.0, 0.5, 1.0), (1.0, 0.5, -1.0), (1.0, -0.9, 1e-3), (50.0, 0.0, 4.0), (1.0, 0.5, 1e-10)]
    {
        let values = [("block.coulomb", coulomb), ("block.pull", pull), ("block.kick", kick)];
        let slows = (coulomb * f64::signum(kick) - pull) / 2.0;
        // A slower contact sticks.
        let kick = if f64::abs(kick) < 1e-9 { 0.0 } else { kick };
        for method in METHODS {
            for rtol in [1e-4, 1e-8] {
                let run = run(&machine, method, rtol, &values);
                let [x, v, guide] =
                    ["block.x", "block.v", "guide"].map(|name| run.column(name).expect("a column"));
                for (row, time) in run.times.iter().enumerate() {
                    let time = (time - 0.7).clamp(0.0, kick / slows);
                    let exact = [kick * time - slows * time * time / 2.0, kick - slows * time];
                    let exact = if time > 0.0 { exact } else { [0.0, 0.0] };
                    let off = (x[row] - exact[0]).abs() + (v[row] - exact[1]).abs();
                    let what = format!("{method}, {rtol:e}, {values:?} at {}", run.times[row]);
                    assert!(off < 300.0 * rtol, "{what}: {}, {}, not {exact:?}", x[row], v[row]);
                }
                let last = *guide.last().expect("rows");
                assert!((last + pull).abs() < 1e-9, "it rests again: {last}");
            }
        }
    }
}

/// Blocks that rub on the ground; one slides towards another, which sticks.
const BLOCKS: &str = r#"
    [initial]
    "a.v" = 2
    "b.x" = 0.5
    [run]
    until = 3
    points = 61
    [define.block.coordinates.x]
    unit = "m"
    velocity = "v"
    [define.block.parameters]
    mass = { value = 1.0, unit = "kg" }
    coulomb = { value = 1.0, unit = "N" }
    [define.block.energy]
    kinetic = "mass*v^2/2"
    [define.block.friction.guide]
    speed = "v"
    sliding = "coulomb"
    unit = "N"
"#;

/// Two blocks rub on the ground. One slides into the other, which sticks, with restitution; a third
/// that touches neither keeps its friction.
#[test]
fn a_block_that_is_hit_takes_its_share_of_momentum() {
    let own = r#"
        [units]
        a = { unit = "block" }
        b = { unit = "block" }
        c = { unit = "block" }
        [parameters]
        restitution = { value = 0.5, unit = "1" }
        [events.meet]
        guard = "a.x - b.x"
        direction = "rising"
        set = { "a.v" = "a.v - (1 + restitution)*(a.v - b.v)*b.mass/(a.mass + b.mass)", "b.v" = "b.v + (1 + restitution)*(a.v - b.v)*a.mass/(a.mass + b.mass)" }
        "#;
    let machine = scene(&[own, BLOCKS].concat());
    for (mass, restitution) in [(1.0, 0.5), (3.0, 0.9), (0.2, 0.3), (1.0, 1.0)] {
        let values = [("b.mass", mass), ("restitution", restitution), ("b.coulomb", mass)];
        // Both slow down by 1 m/s^2, and a slides back if b is heavier.
        let speed = f64::sqrt(4.0 - 2.0 * 0.5);
        let after = [
            speed - (1.0 + restitution) * speed * mass / (1.0 + mass),
            (1.0 + restitution) * speed / (1.0 + mass),
        ];
        for method in METHODS {
            let run = run(&machine, method, 1e-8, &values);
            assert_eq!(happened(&run, "meet"), 1, "{method}, {values:?}");
            assert_eq!(happened(&run, "c.guide_closes"), 1, "{method}: the third is not moved");
            for (name, after) in ["a.x", "b.x"].into_iter().zip(after) {
                let found = *run.column(name).and_then(|x| x.last()).expect("a row");
                let exact = 0.5 + after * after.abs() / 2.0;
                assert!(
                    (found - exact).abs() < 1e-6,
                    "{method}, {values:?}: {name} {found}, not {exact}"
                );
            }
        }
    }
}

/// A hook couples a block that slides to one that sticks: momentum stays, then both slow down.
#[test]
fn what_a_hook_pulls_along_slides() {
    let own = r#"
        [units]
        a = { unit = "block" }
        b = { unit = "block" }
        [modes.hooked]
        [constraints.hook]
        expression = "a.v - b.v"
        when = { hooked = 1 }
        [events.meet]
        guard = "a.x - b.x"
        direction = "rising"
        when = { hooked = 0 }
        set = { hooked = 1 }
        "#;
    let machine = scene(&[own, BLOCKS].concat());
    for (mass, coulomb) in [(1.0, 1.0), (5.0, 0.1), (0.1, 3.0)] {
        let values = [("b.mass", mass), ("b.coulomb", coulomb)];
        let common = f64::sqrt(3.0) / (1.0 + mass);
        let slows = (1.0 + coulomb) / (1.0 + mass);
        for method in METHODS {
            let run = run(&machine, method, 1e-8, &values);
            for name in ["a.x", "b.x"] {
                let found = *run.column(name).and_then(|x| x.last()).expect("a row");
                let exact = 0.5 + common * common / (2.0 * slows);
                assert!(
                    (found - exact).abs() < 1e-6,
                    "{method}, {values:?}: {name} {found}, not {exact}"
                );
            }
        }
    }
}

/// Parts with friction between two inertias, one of which is kicked in either direction.
#[test]
fn parts_that_stick_let_go_when_a_shaft_is_kicked() {
    for (part, limits, locks) in [
        (
            "unit = \"rotational/clutch\"\ninputs = { normal_force = 1 }\nparameters = { friction = 0.5 }",
            0.5,
            false,
        ),
        ("unit = \"rotational/torque_limiter\"\nparameters = { limit = 0.5 }", 0.5, false),
        ("unit = \"rotational/one_way_clutch\"\ninputs = { drag = 0.5 }", 0.5, true),
    ] {
        let machine = scene(&format!(
            r#"
            [units.left]
            unit = "rotational/inertia"
            parameters = {{ inertia = 2 }}
            [units.right]
            unit = "rotational/inertia"
            parameters = {{ inertia = 3 }}
            [units.part]
            {part}
            [[joints]]
            connect = ["left.b", "part.a"]
            [[joints]]
            connect = ["part.b", "right.a"]
            [parameters]
            kick = {{ value = 1.0, unit = "rad/s" }}
            [initial]
            "left.omega" = 1
            "right.omega" = 1
            [run]
            until = 20
            points = 101
            [events.kicked]
            guard = "t - 1 [s]"
            direction = "rising"
            set = {{ "right.omega" = "right.omega + kick" }}
            "#
        ));
        for kick in [1.0, -1.0, 0.01] {
            for method in METHODS {
                let run = run(&machine, method, 1e-8, &[("kick", kick)]);
                let common = 1.0 + 3.0 * kick / 5.0;
                let is_locked = locks && kick < 0.0;
                // The difference falls by the torque on both until it is zero.
                let slows = limits * (1.0 / 2.0 + 1.0 / 3.0);
                for (row, time) in run.times.iter().enumerate().filter(|(_, time)| **time > 1.0) {
                    let left = (f64::abs(kick) - slows * (time - 1.0)).max(0.0) * kick.signum();
                    let left = if is_locked { 0.0 } else { left };
                    let exact = [common - 3.0 / 5.0 * left, common + 2.0 / 5.0 * left];
                    for (name, exact) in ["left.omega", "right.omega"].into_iter().zip(exact) {
                        let found = run.column(name).expect("a column")[row];
                        let what = format!("{part}, {method}, kick {kick}, {name} at {time}");
                        assert!((found - exact).abs() < 1e-6, "{what}: {found}, not {exact}");
                    }
                }
            }
        }
    }
}

/// An event that sets the mode of a friction itself decides alone.
#[test]
fn an_event_may_say_that_friction_holds() {
    let machine =
        scene(&WALL.replace("set = { v = \"-restitution*v\" }", "set = { v = 0, guide_slip = 0 }"));
    for method in METHODS {
        let run = run(&machine, method, 1e-8, &[]);
        let [x, v] = ["block.x", "block.v"]
            .map(|name| *run.column(name).and_then(|all| all.last()).expect("a row"));
        assert!((x - 0.5).abs() < 1e-7 && v.abs() < 1e-12, "{method}: {x}, {v}");
        assert_eq!(happened(&run, "block.guide_closes"), 1, "{method}");
    }
}

/// Fixed steps, as in emitted C, of a block that a wall throws back.
#[test]
fn fixed_steps_go_through_the_impact() {
    let machine = scene(WALL);
    for method in StepMethod::ALL {
        for steps in [100, 313, 4000] {
            let step = 4.0 / f64::from(steps);
            let start = [0.0, 1.0, 2.0];
            let (rows, _) = steps_in_rust(machine.model(), method, (&start, step, steps as usize));
            let last = rows.last().expect("a row");
            let exact = at_wall(1.0, 0.05, 0.8, 0.5, 4.0);
            let off = (last[0] - exact[0]).abs() + (last[1] - exact[1]).abs();
            assert!(off < 1e-9, "{method:?}, {steps}: {last:?}, not {exact:?}");
        }
    }
}

/// A body that slides along a joint into a wall, beside one whose orientation is a quaternion.
#[test]
fn bodies_in_space_slide_on_after_an_impact() {
    let machine = scene(
        r#"
        [units.world]
        unit = "spatial/world"
        [units.slide]
        unit = "spatial/prismatic"
        parameters = { n_x = 1, n_y = 0, n_z = 0 }
        [units.bob]
        unit = "spatial/body"
        parameters = { mass = 2 }
        [units.ball]
        unit = "spatial/spherical"
        [units.top]
        unit = "spatial/body"
        [[joints]]
        connect = ["world.frame", "slide.a"]
        [[joints]]
        connect = ["slide.b", "bob.a"]
        [[joints]]
        connect = ["world.frame", "ball.a"]
        [[joints]]
        connect = ["ball.b", "top.a"]
        [initial]
        "slide.v" = 1
        [run]
        until = 4
        points = 81
        [friction.guide]
        speed = "slide.v"
        sliding = "0.1 [N]"
        unit = "N"
        [friction.socket]
        speed = "ball.turn_omega_z"
        sliding = "0.1 [N m]"
        unit = "N m"
        [events.hits]
        guard = "slide.s - 0.5 [m]"
        direction = "rising"
        set = { "slide.v" = "-0.8*slide.v" }
        "#,
    );
    for method in METHODS.into_iter().filter(|method| *method != Method::Exact) {
        let run = run(&machine, method, 1e-8, &[]);
        let s = run.column("slide.s").expect("a column");
        for (time, s) in run.times.iter().zip(s) {
            let exact = at_wall(1.0, 0.05, 0.8, 0.5, *time);
            assert!((s - exact[0]).abs() < 1e-6, "{method}, {time}: {s}, not {exact:?}");
        }
    }
}
