//! Sensitivities of motions that slide along switching surfaces, against closed forms and
//! differences of runs.

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

const CARRYING: [Method; 4] = [Method::Tsit5, Method::Dop853, Method::Radau, Method::Auto];

fn machine(run: &str, definition: &str) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "slides"
        [units.u]
        unit = "u"
        [run]
        points = 41
        rtol = 1e-9
        {run}
        {definition}
        "#
    );
    of_text(&text, Keep::All)
}

/// A value by which a run is differentiated: a parameter or an initial value.
type By<'a> = (&'a str, f64);

fn simulation<'m>(machine: &'m ModelSimulator, values: &[By<'_>]) -> Simulation<'m> {
    let mut run = Simulation::new(machine);
    for (name, value) in values {
        run = match run.clone().parameter(name, *value) {
            Ok(run) => run,
            Err(_) => run.initial_value(name, *value).expect("a state"),
        };
    }
    run
}

fn carried(machine: &ModelSimulator, method: Method, values: &[By<'_>]) -> Trajectory {
    let names: Vec<&str> = values.iter().map(|(name, _)| *name).collect();
    let run = simulation(machine, values).method(method).sensitivities(&names).expect("known");
    run.run().unwrap_or_else(|stopped| panic!("{method}: {stopped}"))
}

/// Compares the sensitivities of a column at all times with differences of a function of time and
/// values.
fn compare(
    run: &Trajectory,
    column: &str,
    values: &[By<'_>],
    allowed: f64,
    mut exact: impl FnMut(&[f64]) -> Vec<f64>,
) {
    for (place, (name, value)) in values.iter().enumerate() {
        let by = 1e-4 * value.abs().max(0.1);
        let mut at = |times: f64| {
            let mut all: Vec<f64> = values.iter().map(|(_, value)| *value).collect();
            all[place] += times * by;
            exact(&all)
        };
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(&mut at);
        let found = run.sensitivity(column, name).expect("a column");
        let scale = found.iter().fold(0.1, |most: f64, value| most.max(value.abs()));
        for (row, found) in found.iter().enumerate() {
            let expected = (a[row] - 8.0 * b[row] + 8.0 * c[row] - d[row]) / (12.0 * by);
            let time = run.times[row];
            assert!(
                (found - expected).abs() <= allowed * scale,
                "{column} by {name} at {time} s: {found} and not {expected}"
            );
        }
    }
}

#[test]
fn sliding_mode_control_has_the_sensitivities_of_its_closed_form() {
    let machine = machine(
        "until = 4.0\n[initial]\n\"u.x\" = 1.0",
        r#"
        [define.u.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.u.parameters]
        m = { value = 2.0, unit = "kg" }
        force = { value = 10.0, unit = "N" }
        load = { value = 1.5, unit = "N" }
        c = { value = 1.1, unit = "1/s" }
        [define.u.energy]
        kinetic = "m*v^2/2"
        [[define.u.forces]]
        coordinate = "x"
        expression = "load - force*sign(v + c*x)"
        "#,
    );
    let values = [("u.m", 2.0), ("u.force", 10.0), ("u.load", 1.5), ("u.c", 1.1), ("u.x", 1.0)];
    let times: Vec<f64> = (0..41).map(|k| 0.1 * f64::from(k)).collect();
    // Until v + c x = 0 with full force, then along it.
    let place = |all: &[f64]| -> Vec<f64> {
        let [m, force, load, c, x0] = all else { panic!("five") };
        let a = (force - load) / m;
        let reached = (-1.0 + (1.0 + 2.0 * c * c * x0 / a).sqrt()) / c;
        let x = |t: f64| x0 - a * t * t / 2.0;
        let along =
            |t: f64| if t < reached { x(t) } else { x(reached) * (-c * (t - reached)).exp() };
        times.iter().map(|t| along(*t)).collect()
    };
    for method in CARRYING {
        compare(&carried(&machine, method, &values), "u.x", &values, 1e-7, place);
    }
}

#[test]
fn a_mass_on_a_belt_has_the_sensitivities_of_its_closed_form_before_and_after_it_slips() {
    let machine = machine(
        "until = 4.0\n[initial]\n\"u.v\" = 0.5",
        r#"
        [define.u.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.u.parameters]
        k = { value = 3.0, unit = "N/m" }
        d = { value = 0.4, unit = "N s/m" }
        grip = { value = 2.0, unit = "N" }
        belt = { value = 0.5, unit = "m/s" }
        [define.u.energy]
        kinetic = "1 [kg]*v^2/2"
        potential = "k*x^2/2"
        dissipation = "d*v^2/2"
        [[define.u.forces]]
        coordinate = "x"
        expression = "-grip*sign(v - belt)"
        "#,
    );
    let values = [("u.k", 3.0), ("u.d", 0.4), ("u.grip", 2.0), ("u.belt", 0.5)];
    let times: Vec<f64> = (0..41).map(|k| 0.1 * f64::from(k)).collect();
    let place = |all: &[f64]| -> Vec<f64> {
        let [k, d, grip, belt] = all else { panic!("four") };
        let slips = (grip - d * belt) / (k * belt);
        let (decay, middle) = (d / 2.0, grip / k);
        let omega = (k - decay * decay).sqrt();
        let start = belt * slips - middle;
        let along = |t: f64| {
            let since = t - slips;
            let sine = (belt + decay * start) / omega;
            let swing = start * (omega * since).cos() + sine * (omega * since).sin();
            middle + (-decay * since).exp() * swing
        };
        times.iter().map(|t| if *t < slips { belt * t } else { along(*t) }).collect()
    };
    for method in CARRYING {
        compare(&carried(&machine, method, &values), "u.x", &values, 1e-7, place);
    }
    // An initial slip of either sign is over at once.
    let by_start = carried(&machine, Method::Auto, &[("u.v", 0.5)]);
    let of_start = by_start.sensitivity("u.x", "u.v").expect("a column");
    assert!(of_start.iter().all(|value| value.abs() < 1e-9), "{of_start:?}");
}

#[test]
fn motions_along_two_surfaces_and_a_curved_one_have_the_sensitivities_of_differences() {
    let chain = machine(
        "until = 3.0\n[initial]\n\"u.v1\" = 0.3\n\"u.v2\" = 0.9",
        r#"
        [define.u.coordinates.x1]
        unit = "m"
        velocity = "v1"
        [define.u.coordinates.x2]
        unit = "m"
        velocity = "v2"
        [define.u.parameters]
        k = { value = 4.0, unit = "N/m" }
        grip = { value = 2.5, unit = "N" }
        more = { value = 0.3, unit = "kg" }
        belt = { value = 0.5, unit = "m/s" }
        [define.u.energy]
        kinetic = "1 [kg]*v1^2/2 + 2 [kg]*v2^2/2 + more*(v1 - v2)^2/2"
        potential = "k*x1^2/2 + 1 [N/m]*(x1 - x2)^2/2"
        dissipation = "0.2 [N s/m]*(v1 - v2)^2/2 + 0.1 [N s/m]*v2^2/2"
        [[define.u.forces]]
        coordinate = "x1"
        expression = "-grip*sign(v1 - belt)"
        [[define.u.forces]]
        coordinate = "x2"
        expression = "-3 [N]*sign(v2 - belt*cos(2 [1/s]*t))"
        "#,
    );
    let of_chain = [("u.k", 4.0), ("u.grip", 2.5), ("u.more", 0.3), ("u.belt", 0.5), ("u.v2", 0.9)];
    let curved = machine(
        "until = 3.0\n[initial]\n\"u.y\" = 0.5",
        r#"
        [define.u.parameters]
        p = { value = 0.8, unit = "1" }
        gain = { value = 4.0, unit = "1" }
        [define.u.states]
        x = { unit = "1", rate = "(1 + y/4)/(1 [s])" }
        y = { unit = "1", rate = "(cos(x) - gain*sign(y - p*sin(x)))/(1 [s])" }
        "#,
    );
    let of_curved = [("u.p", 0.8), ("u.gain", 4.0), ("u.y", 0.5)];
    let cases = [(&chain, &of_chain[..], ["u.x1", "u.x2"]), (&curved, &of_curved, ["u.x", "u.y"])];
    for (machine, values, columns) in cases {
        for column in columns {
            let values_of = |all: &[f64]| {
                let values: Vec<_> =
                    values.iter().zip(all).map(|((name, _), value)| (*name, *value)).collect();
                let run = simulation(machine, &values).method(Method::Dop853).rtol(1e-12);
                run.run().expect("it runs").column(column).expect("a column").to_vec()
            };
            for method in CARRYING {
                compare(&carried(machine, method, values), column, values, 1e-6, values_of);
            }
        }
    }
}

/// Two masses between which a relay acts that depends on their distance and relative speed, while
/// another comparison switches a load. Once it slides, the distance decays as exp(-c t), whatever
/// acts on the masses.
#[test]
fn a_relay_slides_on_while_another_comparison_switches() {
    for (stiffness, load) in [(8.0, 1.5), (8.0, 0.0), (0.0, 0.0), (0.0, 1.5), (80.0, 3.0)] {
        let machine = machine(
            "until = 3.0\n[initial]\n\"u.x2\" = 0.2\n\"u.v1\" = 0.3",
            &format!(
                r#"
                [define.u.coordinates.x1]
                unit = "m"
                velocity = "v1"
                [define.u.coordinates.x2]
                unit = "m"
                velocity = "v2"
                [define.u.parameters]
                m1 = {{ value = 0.5, unit = "kg" }}
                m2 = {{ value = 0.3, unit = "kg" }}
                force = {{ value = 10.0, unit = "N" }}
                load = {{ value = {load:?}, unit = "N" }}
                c = {{ value = 5.0, unit = "1/s" }}
                k = {{ value = {stiffness:?}, unit = "N/m" }}
                period = {{ value = 0.353128, unit = "s" }}
                length = {{ value = 4.0, unit = "m" }}
                [define.u.energy]
                kinetic = "m1*v1^2/2 + m2*v2^2/2"
                potential = "k*x1^2/2"
                [[define.u.forces]]
                coordinate = "x1"
                expression = "force*sign(v2 - v1 + c*(x2 - x1))"
                [[define.u.forces]]
                coordinate = "x2"
                expression = "-force*sign(v2 - v1 + c*(x2 - x1))"
                [[define.u.forces]]
                coordinate = "x2"
                expression = "load*piecewise(mod(t, period)/period < 0.5 + x1/length, 1, -1)"
                "#
            ),
        );
        for method in [Method::Dop853, Method::Radau, Method::Taylor, Method::Tsit5] {
            let run = Simulation::new(&machine).method(method).run();
            let run = run.unwrap_or_else(|stopped| panic!("{method}: {stopped}"));
            let column = |name: &str| run.column(name).expect("a state").to_vec();
            let [x1, x2, v1, v2] = ["u.x1", "u.x2", "u.v1", "u.v2"].map(column);
            let slides =
                |row: &usize| (v2[*row] - v1[*row] + 5.0 * (x2[*row] - x1[*row])).abs() < 1e-9;
            let since = (0..x1.len()).find(slides).expect("slides");
            assert!(run.times[since] < 0.5);
            for row in since..x1.len() {
                let decay = (-5.0 * (run.times[row] - run.times[since])).exp();
                let off = x2[row] - x1[row] - (x2[since] - x1[since]) * decay;
                assert!(off.abs() < 1e-8, "{method} at {} s: {off}", run.times[row]);
            }
            // The relay acts on both masses alike, so it leaves their momentum alone.
            if stiffness == 0.0 && load == 0.0 {
                let momentum = v1.iter().zip(&v2).map(|(v1, v2)| 0.5 * v1 + 0.3 * v2);
                let lost = momentum.map(|it| (it - 0.15).abs()).fold(0.0, f64::max);
                assert!(lost < 1e-9, "{method}: {lost}");
            }
        }
    }
}

/// Speeds of a mass under a rising force, held by a brake that reads the speed in steps:
///
/// ```text
/// m v' = a t - k q floor(v/q + 1/2)
/// ```
///
/// Where the speed reaches the edge of a step, it stays there until the force exceeds the brake's
/// next one.
fn braked_speeds([m, a, k, q]: [f64; 4], times: &[f64]) -> Vec<f64> {
    let (mut since, mut speed, mut step) = (0.0, 0.0, 0.0);
    let mut speeds = Vec::new();
    let mut times = times.iter().copied().peekable();
    loop {
        let brake = k * q * step;
        let at = |t: f64| {
            speed + (a * (t - since).powi(2) / 2.0 + (a * since - brake) * (t - since)) / m
        };
        let edge = (step + 0.5) * q;
        // a s^2/2 + (a t0 - brake) s = m (edge - speed)
        let slope = (a * since - brake) / a;
        let reached = since - slope + (slope * slope + 2.0 * m * (edge - speed) / a).sqrt();
        let left = reached.max(k * q * (step + 1.0) / a);
        while let Some(t) = times.next_if(|t| *t <= left) {
            speeds.push(if t <= reached { at(t) } else { edge });
        }
        if times.peek().is_none() {
            return speeds;
        }
        (since, speed, step) = (left, edge, step + 1.0);
    }
}

fn braked(until: f64) -> ModelSimulator {
    machine(
        &format!("until = {until}"),
        r#"
        [define.u.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.u.parameters]
        m = { value = 2.0, unit = "kg" }
        a = { value = 3.0, unit = "N/s" }
        k = { value = 5.0, unit = "N s/m" }
        q = { value = 0.3, unit = "m/s" }
        [define.u.energy]
        kinetic = "m*v^2/2"
        [[define.u.forces]]
        coordinate = "x"
        expression = "a*t - k*q*(v/q + 1/2 - mod(v/q + 1/2, 1))"
        "#,
    )
}

#[test]
fn a_speed_read_in_steps_stays_at_the_edges_where_its_force_holds_it() {
    let machine = braked(10.0);
    let times: Vec<f64> = (0..41).map(|k| 0.25 * f64::from(k)).collect();
    let methods =
        [CARRYING.to_vec(), vec![Method::Rodas5p, Method::Taylor, Method::Exact]].concat();
    for (m, a, k, q) in [
        (2.0, 3.0, 5.0, 0.3),
        (0.2, 3.0, 5.0, 0.3),
        (2.0, 30.0, 5.0, 0.3),
        (2.0, 0.7, 50.0, 0.02),
        (1e-3, 0.7, 2.0, 0.1),
        (40.0, 20.0, 0.5, 1.0),
    ] {
        let expected = braked_speeds([m, a, k, q], &times);
        for method in &methods {
            let values = [("u.m", m), ("u.a", a), ("u.k", k), ("u.q", q)];
            let run = simulation(&machine, &values).method(*method).run();
            let run = run.unwrap_or_else(|stopped| panic!("{method}, m = {m}, a = {a}: {stopped}"));
            for (found, expected) in run.column("u.v").expect("a column").iter().zip(&expected) {
                let allowed = 1e-7 * expected.abs().max(q);
                assert!(
                    (found - expected).abs() <= allowed,
                    "{method}, m = {m}, a = {a}, q = {q}: {found} and not {expected}"
                );
            }
        }
    }
}

#[test]
fn a_speed_read_in_steps_has_the_sensitivities_of_its_closed_form() {
    let machine = braked(10.0);
    let times: Vec<f64> = (0..41).map(|k| 0.25 * f64::from(k)).collect();
    let values = [("u.m", 2.0), ("u.a", 3.1), ("u.k", 5.0), ("u.q", 0.3)];
    for method in CARRYING {
        let speeds = |all: &[f64]| braked_speeds(all.try_into().expect("four"), &times);
        compare(&carried(&machine, method, &values), "u.v", &values, 1e-6, speeds);
    }
}

/// m x'' = -load - c x' - k q floor(x/q): a digital controller that holds a load.
#[test]
fn a_load_held_by_an_encoder_comes_to_rest_on_an_edge_of_its_lines() {
    let machine = machine(
        "until = 60.0",
        r#"
        [define.u.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.u.parameters]
        q = { value = 0.01, unit = "m" }
        c = { value = 2.0, unit = "N s/m" }
        load = { value = 1.3, unit = "N" }
        [define.u.energy]
        kinetic = "0.8 [kg]*v^2/2"
        dissipation = "c*v^2/2"
        [[define.u.forces]]
        coordinate = "x"
        expression = "-load - 40 [N/m]*(x - mod(x, q))"
        "#,
    );
    let methods = [Method::Tsit5, Method::Dop853, Method::Radau, Method::Rodas5p, Method::Auto];
    for (q, c, load) in [(0.01, 2.0, 1.3), (0.01, 0.5, 0.05), (0.1, 4.0, 3.0), (0.001, 1.0, 0.3)] {
        for (method, rtol) in methods.into_iter().flat_map(|it| [(it, 1e-5), (it, 1e-7)]) {
            let values = [("u.q", q), ("u.c", c), ("u.load", load), ("u.x", 0.02)];
            let run = simulation(&machine, &values).method(method).rtol(rtol).run();
            let run = run.unwrap_or_else(|stopped| panic!("{method}, q = {q}: {stopped}"));
            // The load is between the forces on both sides of the edge.
            let edge = q * (-load / (40.0 * q)).ceil();
            let [x, v] = ["u.x", "u.v"].map(|name| run.column(name).expect("a column")[40]);
            assert!((x - edge).abs() <= 2.0 * rtol, "{method}, q = {q}, {rtol}: {x}, not {edge}");
            assert!(v.abs() <= 1e-3 * q, "{method}, q = {q}, {rtol}: {v} m/s");
        }
    }
}
