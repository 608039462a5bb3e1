//! Switches beside fields, compared with chains of rotors and with closed forms. Elements of order 1
//! are such chains; chains of more and more rotors converge to elements of higher order.

use std::fmt::Write;

use machinist::field::{Discretisation, FieldSimulator};
use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;

use crate::clutched_chains::ClutchedChains;
use crate::own_scene::of_text;

const METHODS: [Method; 5] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Auto];
/// Number of elements of fields and of rotors less one of the chain that all methods are compared
/// with.
const ELEMENTS: usize = 6;
/// Numbers of rotors less one of chains that converge.
const MORE: [usize; 3] = [12, 24, 48];
/// Bound of the differences of extrapolated speeds; the largest, of a stop, is 5.8e-5.
const EXTRAPOLATED: f64 = 1e-4;
const LENGTH: f64 = 2.0;
const DENSITY: f64 = 0.5;
const STIFFNESS: f64 = 40.0;
const DAMPING_TIME: f64 = 2e-2;

/// Shafts and the forces at their ends; `{a0}` and `{a1}` are the angles of the start and the end
/// of shaft `a`, `{a0'}` and `{a1'}` their rates.
struct Case {
    shafts: &'static [&'static str],
    /// End of a shaft, and the torque on it.
    torques: &'static [(&'static str, &'static str)],
}

/// Ends as the scene of fields, or of chains, names them.
fn with_names(text: &str, shafts: &[&str], name: &dyn Fn(&str, bool, bool) -> String) -> String {
    let mut text = text.to_owned();
    for shaft in shafts {
        for (number, is_end) in [(0, false), (1, true)] {
            text = text.replace(&format!("{{{shaft}{number}'}}"), &name(shaft, is_end, true));
            text = text.replace(&format!("{{{shaft}{number}}}"), &name(shaft, is_end, false));
        }
    }
    text
}

const RUN: &str = "[run]\nuntil = 3.0\npoints = 61\nrtol = 1e-9\n";

fn scene_of_fields(case: &Case) -> String {
    let mut text = format!("[scene]\nname = \"fields\"\n{RUN}");
    let name = |shaft: &str, is_end: bool, is_rate: bool| {
        let place = if is_end { "end" } else { "start" };
        format!("{shaft}.{place}{}", if is_rate { "_dot" } else { "" })
    };
    for shaft in case.shafts {
        write!(
            text,
            r#"
            [units.{shaft}]
            unit = "shaft"
            inputs = {{ load = 0 }}
            parameters = {{ length = {LENGTH}, density = {DENSITY}, stiffness = {STIFFNESS}, damping_time = {DAMPING_TIME} }}
            fields = {{ phi = {{ elements = {ELEMENTS}, order = 1 }} }}
            "#
        )
        .expect("written");
    }
    for (end, torque) in case.torques {
        let port = with_names(&format!("{{{end}}}"), case.shafts, &name);
        let torque = with_names(torque, case.shafts, &name);
        write!(text, "\n[[forces]]\nport = \"{port}\"\nexpression = \"{torque}\"\n")
            .expect("written");
    }
    text += "\n[outputs]\n";
    for shaft in case.shafts {
        writeln!(text, "{shaft}_start = \"{shaft}.start_dot\"\n{shaft}_end = \"{shaft}.end_dot\"")
            .expect("written");
    }
    text
}

fn scene_of_chains(case: &Case, elements: usize) -> String {
    let mut text = format!("[scene]\nname = \"chains\"\n[units.u]\nunit = \"u\"\n{RUN}");
    let name = |shaft: &str, is_end: bool, is_rate: bool| {
        format!("{}{shaft}{}", if is_rate { "w" } else { "" }, if is_end { elements } else { 0 })
    };
    let (mut kinetic, mut potential, mut dissipation) =
        (String::from("0 [J]"), String::from("0 [J]"), String::from("0 [W]"));
    let inertia = DENSITY * LENGTH / elements as f64;
    let spring = STIFFNESS / (LENGTH / elements as f64);
    for shaft in case.shafts {
        for index in 0..=elements {
            write!(
                text,
                "\n[define.u.coordinates.{shaft}{index}]\nunit = \"rad\"\nvelocity = \"w{shaft}{index}\"\n"
            )
            .expect("written");
            let share = if index % elements == 0 { 0.5 } else { 1.0 };
            write!(kinetic, " + {} [kg m^2]*w{shaft}{index}^2/2", share * inertia)
                .expect("written");
        }
        for index in 0..elements {
            let next = index + 1;
            write!(potential, " + {spring} [N m]*({shaft}{next} - {shaft}{index})^2/2")
                .expect("written");
            let damping = spring * DAMPING_TIME;
            write!(dissipation, " + {damping} [N m s]*(w{shaft}{next} - w{shaft}{index})^2/2")
                .expect("written");
        }
    }
    write!(
        text,
        "\n[define.u.energy]\nkinetic = \"{kinetic}\"\npotential = \"{potential}\"\ndissipation = \"{dissipation}\"\n"
    )
    .expect("written");
    for (end, torque) in case.torques {
        let coordinate = with_names(&format!("{{{end}}}"), case.shafts, &name);
        let torque = with_names(torque, case.shafts, &name);
        write!(
            text,
            "\n[[define.u.forces]]\ncoordinate = \"{coordinate}\"\nexpression = \"{torque}\"\n"
        )
        .expect("written");
    }
    text
}

fn run(simulator: &dyn Simulator<f64>, method: Method) -> Trajectory {
    let run = Simulation::new(simulator).method(method).run();
    run.unwrap_or_else(|stopped| panic!("{}, {method}: {stopped}", simulator.name()))
}

fn compare(case: &Case) {
    let chains = of_text(&scene_of_chains(case, ELEMENTS), Keep::All);
    let fields = of_text(&scene_of_fields(case), Keep::Needed);
    let fields = FieldSimulator::new(fields.with_fields(), Discretisation::default());
    let fields = fields.expect("it is divided into elements");
    let exact = run(chains.single(), Method::Dop853);
    for method in METHODS {
        let found = run(fields.single(), method);
        for shaft in case.shafts {
            for (end, index) in [("start", 0), ("end", ELEMENTS)] {
                let exact = exact.column(&format!("u.w{shaft}{index}")).expect("a column");
                let found = found.column(&format!("{shaft}_{end}")).expect("a column");
                let size = exact.iter().fold(0.1, |most: f64, value| most.max(value.abs()));
                for (row, (found, exact)) in found.iter().zip(exact).enumerate() {
                    assert!(
                        (found - exact).abs() <= 1e-5 * size,
                        "{method}, {shaft} {end}, row {row}: {found} and not {exact}"
                    );
                }
            }
        }
    }
}

/// Compares the speeds of ends of chains of more and more rotors with fields of order 4.
fn converge(case: &Case) {
    let chains = MORE.map(|elements| {
        let chains = of_text(&scene_of_chains(case, elements), Keep::All);
        (elements, run(chains.single(), Method::Dop853))
    });
    converge_to_fields(case, |shaft, is_end| {
        chains.each_ref().map(|(elements, run)| {
            let column = format!("u.w{shaft}{}", if is_end { *elements } else { 0 });
            run.column(&column).expect("a column").to_vec()
        })
    });
}

/// Compares speeds of ends of [`MORE`] chains with fields of order 4: differences fall by four
/// whenever the number doubles, and those of the extrapolated speeds, (4 b - a)/3 of two chains,
/// are below [`EXTRAPOLATED`] of the largest speed.
fn converge_to_fields(case: &Case, speeds: impl Fn(&str, bool) -> [Vec<f64>; MORE.len()]) {
    let exact = fields_of_order_4(case);
    for shaft in case.shafts {
        for (end, is_end) in [("start", false), ("end", true)] {
            let exact = exact.column(&format!("{shaft}_{end}")).expect("a column");
            let size = exact.iter().fold(0.1, |most: f64, value| most.max(value.abs()));
            let speeds = speeds(shaft, is_end);
            let off = |of: &dyn Fn(usize) -> f64| {
                let off = |row: usize| (of(row) - exact[row]).abs() / size;
                (0..exact.len()).map(off).fold(0.0, f64::max)
            };
            let errors = [0, 1, 2].map(|chain| off(&|row| speeds[chain][row]));
            let beyond = off(&|row| (4.0 * speeds[2][row] - speeds[1][row]) / 3.0);
            // Shorter waves than a chain of 12 elements carries are still seen.
            let [coarse, fine] = [errors[0] / errors[1], errors[1] / errors[2]];
            assert!((3.5..5.0).contains(&coarse), "{shaft} {end}: {errors:?}");
            assert!((3.8..4.3).contains(&fine), "{shaft} {end}: {errors:?}");
            assert!(beyond < EXTRAPOLATED, "{shaft} {end}: {beyond} of {errors:?}");
        }
    }
}

fn fields_of_order_4(case: &Case) -> Trajectory {
    let text = scene_of_fields(case).replace("order = 1", "order = 4");
    let fields = of_text(&text, Keep::Needed);
    let fields = FieldSimulator::new(fields.with_fields(), Discretisation::default());
    run(fields.expect("it is divided into elements").single(), Method::Dop853)
}

#[test]
fn a_torque_that_switches_turns_a_shaft_as_it_turns_a_chain() {
    let case = Case {
        shafts: &["a"],
        torques: &[
            ("a0", "piecewise(t < 1 [s], 2 [N m], 0 [N m])"),
            ("a1", "-1.5 [N m]*step(t, 1.7 [s])"),
        ],
    };
    compare(&case);
    converge(&case);
}

/// Once waves have died out, a free shaft turns with the impulse of its torques over its inertia.
#[test]
fn the_impulses_of_switched_torques_over_the_inertia_are_the_speed_of_a_shaft() {
    let torques = &[
        ("a0", "piecewise(t < 1 [s], 2 [N m], 0 [N m])"),
        ("a1", "-1.5 [N m]*(step(t, 1.7 [s]) - step(t, 2.1 [s]))"),
    ];
    let text = scene_of_fields(&Case { shafts: &["a"], torques });
    let text = text.replace("order = 1", "order = 4").replace("until = 3.0", "until = 8.0");
    let text = text.replace(&format!("damping_time = {DAMPING_TIME}"), "damping_time = 5e-2");
    let scene = of_text(&text, Keep::Needed);
    let cut = FieldSimulator::new(scene.with_fields(), Discretisation::default());
    let cut = cut.expect("it is divided into elements");
    let exact = (2.0 * 1.0 - 1.5 * 0.4) / (DENSITY * LENGTH);
    for method in METHODS {
        let run = run(cut.single(), method);
        for end in ["a_start", "a_end"] {
            let speed = run.column(end).expect("a column").last().expect("a row");
            assert!((speed - exact).abs() < 1e-6, "{method} {end}: {speed} and not {exact}");
        }
    }
}

#[test]
fn dry_friction_at_the_end_of_a_shaft_sticks_and_slides_as_on_a_chain() {
    let case = Case {
        shafts: &["a"],
        torques: &[("a0", "-2 [N m]*sign({a0'})"), ("a1", "3 [N m]*sin(4 [1/s]*t)")],
    };
    compare(&case);
    converge(&case);
}

#[test]
fn a_stop_at_the_end_of_a_shaft_meets_it_as_on_a_chain() {
    let case = Case {
        shafts: &["a"],
        torques: &[
            ("a0", "2 [N m]"),
            ("a1", "-piecewise({a1} < 0.3, 0 [N m], 200 [N m]*({a1} - 0.3) + 1 [N m s]*{a1'})"),
        ],
    };
    compare(&case);
    converge(&case);
}

const CLUTCH: Case = Case {
    shafts: &["a", "b"],
    torques: &[
        ("a0", "2 [N m]*cos(2 [1/s]*t)"),
        ("a1", "-1.2 [N m]*sign({a1'} - {b0'})"),
        ("b0", "1.2 [N m]*sign({a1'} - {b0'})"),
        ("b1", "-0.5 [N m s]*{b1'}"),
    ],
};

#[test]
fn a_clutch_between_two_shafts_slips_and_holds_as_between_two_chains() {
    compare(&CLUTCH);
}

/// Differences fall by four with chains of 12, 24 and 48 elements written by hand, since deriving
/// that many coordinates takes long.
#[test]
fn a_clutch_between_two_shafts_slips_and_holds_as_between_chains_by_hand() {
    let chains = MORE.map(|elements| {
        let chains = ClutchedChains {
            elements,
            length: LENGTH,
            density: DENSITY,
            stiffness: STIFFNESS,
            damping_time: DAMPING_TIME,
            drive: [2.0, 2.0],
            capacity: 1.2,
            brake: 0.5,
        };
        chains.speeds(0.05, 61)
    });
    converge_to_fields(&CLUTCH, |shaft, is_end| {
        let place = 2 * usize::from(shaft == "b") + usize::from(is_end);
        chains.each_ref().map(|rows| rows.iter().map(|row| row[place]).collect())
    });
}

#[test]
fn a_relay_and_a_limited_torque_drive_a_shaft_as_they_drive_a_chain() {
    let case = Case {
        shafts: &["a"],
        torques: &[
            ("a0", "max(-1 [N m], min(1 [N m], 5 [N m]*(0.5 - {a0})))"),
            ("a1", "-0.7 [N m]*sign({a1} - 0.2 + 0.1 [s]*{a1'})"),
        ],
    };
    compare(&case);
    converge(&case);
}
