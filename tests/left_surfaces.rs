//! A motion that slides along a switching surface, which a jump leaves: no finite force follows a
//! surface that jumps, or holds what is thrown off it. Compared with closed forms.

use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::common::column;
use crate::own_scene::of_text;

const METHODS: [Method; 6] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Taylor, Method::Auto];
const CARRYING: [Method; 4] = [Method::Tsit5, Method::Dop853, Method::Radau, Method::Auto];

/// Begins to jump at this time \[s\].
const BEGINS: f64 = 1.25;

/// A mass on a belt at rest, pulled by less than the friction, and how belt or mass jump.
pub fn on_belt(speed: &str, more: &str) -> ModelSimulator {
    of_text(
        &format!(
            r#"
            [scene]
            name = "belt"
            [units.u]
            unit = "u"
            [run]
            until = 5
            points = 101
            [define.u.coordinates.x]
            unit = "m"
            velocity = "v"
            [define.u.parameters]
            mass = {{ value = 2.0, unit = "kg" }}
            friction = {{ value = 1.0, unit = "N" }}
            pull = {{ value = 0.4, unit = "N" }}
            jump = {{ value = 0.5, unit = "m/s" }}
            begins = {{ value = 1.25, unit = "s" }}
            [define.u.helpers.belt]
            expression = "{speed}"
            unit = "m/s"
            [define.u.energy]
            kinetic = "mass*v^2/2"
            [[define.u.forces]]
            coordinate = "x"
            expression = "pull - friction*sign(v - belt)"
            {more}
            "#
        ),
        Keep::All,
    )
}

/// The ways to jump, and whether the mass jumps instead of the belt.
fn ways() -> Vec<(&'static str, ModelSimulator, bool)> {
    let event = |set: &str| {
        format!(
            "[define.u.events.go]\nguard = \"t - begins\"\ndirection = \"rising\"\nset = {{ {set} }}"
        )
    };
    let mode = format!("[define.u.modes.on]\n{}", event("on = 1"));
    vec![
        ("a step", on_belt("jump*step(t, begins)", ""), false),
        // One jump of 10 within the run.
        ("an integer", on_belt("jump*min(floor(t/begins), 1)", ""), false),
        ("a comparison", on_belt("jump*(1 + sign(t - begins))/2", ""), false),
        ("a mode", on_belt("jump*on", &mode), false),
        ("an event", on_belt("0 [m/s]", &event("v = \"v - jump\"")), true),
    ]
}

/// Position and speed at some time after the start.
pub fn exact([friction, pull, jump, begins]: [f64; 4], is_kicked: bool, time: f64) -> [f64; 2] {
    if time < begins {
        return [0.0, 0.0];
    }
    let time = time - begins;
    // Relative to the belt, the mass moves by -jump at first.
    let relative = -jump;
    let slows = (friction * relative.signum() - pull) / 2.0;
    let slides = time.min(relative / slows);
    let way = relative * slides - slows * slides * slides / 2.0;
    let left = if slides < time { 0.0 } else { relative - slows * slides };
    if is_kicked { [way, left] } else { [way + jump * time, left + jump] }
}

fn with(machine: &ModelSimulator, values: [f64; 4]) -> Simulation<'_> {
    let names = ["u.friction", "u.pull", "u.jump", "u.begins"];
    let run = names.iter().zip(values);
    run.fold(Simulation::new(machine), |run, (name, value)| {
        run.parameter(name, value).expect("a parameter")
    })
}

#[test]
fn what_slides_stays_behind_a_surface_that_jumps() {
    for (way, machine, is_kicked) in ways() {
        for values in [
            [1.0, 0.4, 0.5, BEGINS],
            [1.0, -0.9, 0.5, BEGINS],
            [1.0, 0.4, -0.5, 3.0],
            [300.0, 10.0, 7.0, BEGINS],
            [1.0, 0.0, 1e-3, BEGINS],
            // It does not reach the belt before the end.
            [1.0, 0.0, 60.0, 0.7],
        ] {
            for method in METHODS {
                for rtol in [1e-4, 1e-6, 1e-9] {
                    let run = with(&machine, values).method(method).rtol(rtol).run();
                    let run = run.unwrap_or_else(|error| panic!("{way}, {method}: {error}"));
                    let (x, v) = (column(&run, "u.x"), column(&run, "u.v"));
                    for (row, time) in run.times.iter().enumerate() {
                        let exact = exact(values, is_kicked, *time);
                        let off = (x[row] - exact[0]).abs() + (v[row] - exact[1]).abs();
                        let what = format!("{way}, {method}, {rtol:e}, {values:?} at {time}");
                        let is_at_jump = (time - values[3]).abs() < 1e-9;
                        assert!(
                            is_at_jump || off < 100.0 * rtol * values[2].abs().max(1.0),
                            "{what}: {}, {}, not {exact:?}",
                            x[row],
                            v[row]
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn sensitivities_stay_behind_with_it() {
    let names = ["u.friction", "u.pull", "u.jump", "u.begins"];
    let values = [1.0, 0.4, 0.5, BEGINS];
    for (way, machine, is_kicked) in ways() {
        for method in CARRYING {
            let run = with(&machine, values).method(method).rtol(1e-9).times(&[0.0, 1.6, 4.0]);
            let run = run.sensitivities(&names).expect("known").run();
            let run = run.unwrap_or_else(|error| panic!("{way}, {method}: {error}"));
            for (row, time) in run.times.iter().enumerate().skip(1) {
                for (number, name) in names.into_iter().enumerate() {
                    let at = |by: f64| {
                        let mut moved = values;
                        moved[number] += by;
                        exact(moved, is_kicked, *time)
                    };
                    let [ahead, behind] = [at(1e-5), at(-1e-5)];
                    for (entry, of) in ["u.x", "u.v"].into_iter().enumerate() {
                        let found = run.sensitivity(of, name).expect("a column")[row];
                        let slope = (ahead[entry] - behind[entry]) / 2e-5;
                        let what = format!("{way}, {method}: d({of})/d({name}) at {time}");
                        assert!((found - slope).abs() < 1e-6, "{what}: {found}, not {slope}");
                    }
                }
            }
        }
    }
}

/// A mass held at a place by `-3 N*sign(x)` with damping, after its oscillation about it has died
/// away, is kicked: it moves as one that was put there at rest.
#[test]
fn what_is_held_flat_is_let_go_by_a_kick() {
    let machine = |kick: &str| {
        of_text(
            &format!(
                r#"
                [scene]
                name = "held"
                [units.u]
                unit = "u"
                [initial]
                "u.x" = "u.start"
                [run]
                until = 30
                points = 301
                [define.u.coordinates.x]
                unit = "m"
                velocity = "v"
                [define.u.parameters]
                start = {{ value = 0.1, unit = "m" }}
                [define.u.energy]
                kinetic = "0.5 [kg]*v^2"
                potential = "3 [N]*abs(x)"
                dissipation = "1 [N s/m]*v^2"
                {kick}
                "#
            ),
            Keep::All,
        )
    };
    let kick = "[define.u.events.kick]\nguard = \"t - 20 [s]\"\ndirection = \"rising\"\n\
                set = { v = \"v + 1 [m/s]\" }";
    let (kicked, thrown) = (machine(kick), machine(""));
    for method in METHODS {
        for rtol in [1e-6, 1e-8] {
            let run = |of: &ModelSimulator, at: [f64; 2]| {
                let run = Simulation::new(of).method(method).rtol(rtol);
                let run = run.initial_value("u.x", at[0]).expect("a state");
                let run = run.initial_value("u.v", at[1]).expect("a state");
                run.run().unwrap_or_else(|error| panic!("{method}: {error}"))
            };
            let (kicked, thrown) = (run(&kicked, [0.1, 0.0]), run(&thrown, [0.0, 1.0]));
            let (after, from_start) = (&column(&kicked, "u.x")[201..], column(&thrown, "u.x"));
            let highest = after.iter().copied().fold(0.0, f64::max);
            assert!(highest > 0.05, "{method}: it moves, by {highest}");
            for (row, (after, exact)) in after.iter().zip(&from_start[1..]).enumerate() {
                let off = (after - exact).abs();
                assert!(off < 300.0 * rtol, "{method}, {rtol:e}, {row}: {after}, not {exact}");
            }
        }
    }
}

/// A mass slower than the belt only after the belt has jumped: the rate behind the jump is that of
/// the other side.
#[test]
fn sensitivities_take_the_side_behind_a_jump() {
    for (way, machine, is_kicked) in ways() {
        if is_kicked {
            continue;
        }
        for method in CARRYING {
            let run = with(&machine, [1.0, 0.0, 5.0, BEGINS]).method(method).rtol(1e-9);
            let run = run.initial_value("u.v", 1.0).expect("a state").times(&[0.0, 2.0]);
            let run = run.sensitivities(&["u.begins"]).expect("known").run().expect("it runs");
            // v = 1 - t/2 before, and grows as fast behind.
            let found = run.sensitivity("u.v", "u.begins").expect("a column")[1];
            assert!((found + 1.0).abs() < 1e-6, "{way}, {method}: {found}");
            let v = column(&run, "u.v")[1];
            assert!((v - (1.0 - BEGINS / 2.0 + (2.0 - BEGINS) / 2.0)).abs() < 1e-7, "{v}");
        }
    }
}
