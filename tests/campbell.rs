//! Frequencies over a parameter, against closed forms.

use machinist::Simulation;
use machinist::linear_analysis::{
    Campbell, LinearError, Place, Variation, campbell, campbell_over_speeds,
};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

/// Returns a unit `s` of two coordinates, with a line of parameters and its energies.
fn of_two(unit: &str, parameters: &str, energies: &str) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "of_two"
        [units.s]
        unit = "s"
        [outputs]
        a = "s.a"
        b = "s.b"
        [run]
        until = 1.0
        points = 2
        rtol = 1e-9
        method = "auto"
        [define.s.coordinates]
        a = {{ unit = "{unit}" }}
        b = {{ unit = "{unit}" }}
        [define.s.parameters]
        {parameters}
        [define.s.energy]
        {energies}
        "#
    );
    of_text(&text, Keep::Needed)
}

/// Returns an overhung disc at a speed, which tilts in two directions; k, across and polar as in
/// [`whirl`].
fn disc() -> ModelSimulator {
    of_two(
        "rad",
        r#"across = { value = 0.5, unit = "kg m^2" }
        polar = { value = 0.3, unit = "kg m^2" }
        stiffness = { value = 2e4, unit = "N m/rad" }
        speed = { value = 100.0, unit = "rad/s" }
        load = { value = 1.0, unit = "1" }"#,
        r#"kinetic = "across*(a_dot^2 + b_dot^2)/2 + polar*speed*a*b_dot"
        potential = "load*stiffness*(a^2 + b^2)/2""#,
    )
}

const ACROSS: f64 = 0.5;
const POLAR: f64 = 0.3;
const STIFFNESS: f64 = 2e4;

/// Returns backward and forward whirl frequencies of the disc at a speed.
fn whirl(speed: f64) -> [f64; 2] {
    let half = POLAR * speed / ACROSS / 2.0;
    let middle = (half * half + STIFFNESS / ACROSS).sqrt();
    [middle - half, middle + half]
}

fn over(scene: &ModelSimulator, parameter: &str, values: &[f64], orders: &[f64]) -> Campbell {
    let variation = Variation { parameter, values, place: Place::Equilibrium, speed: None, orders };
    campbell(&Simulation::new(scene), &variation).expect("it oscillates")
}

#[test]
fn a_disc_whirls_backward_and_forward_and_meets_its_orders_as_by_hand() {
    let values: Vec<f64> = (0..=40).map(|step| 20.0 * f64::from(step)).collect();
    let found = over(&disc(), "s.speed", &values, &[1.0, 2.0, 0.5]);
    assert_eq!((found.unit.as_str(), found.branches.len()), ("rad/s", 2));
    assert_eq!(found.speeds.as_deref(), Some(&values[..]));
    for (row, value) in values.iter().enumerate() {
        for (branch, exact) in found.branches.iter().zip(whirl(*value)) {
            assert!((branch.frequencies[row] / exact - 1.0).abs() < 1e-9, "{value}");
            assert!(branch.damping_ratios[row].abs() < 1e-9);
        }
    }
    // n w = k/(across n^2 -+ polar n), where there is one within the range.
    let at = |order: f64, sign: f64| {
        (STIFFNESS / (ACROSS * order * order - sign * POLAR * order)).sqrt()
    };
    let mut exact = vec![(1.0, 0, at(1.0, -1.0)), (1.0, 1, at(1.0, 1.0))];
    exact.extend([(2.0, 0, at(2.0, -1.0)), (2.0, 1, at(2.0, 1.0)), (0.5, 0, at(0.5, -1.0))]);
    exact.sort_by(|a, b| a.2.total_cmp(&b.2));
    assert_eq!(found.critical.len(), exact.len(), "{:?}", found.critical);
    for (found, (order, branch, value)) in found.critical.iter().zip(exact) {
        assert_eq!((found.order.to_bits(), found.branch), (f64::to_bits(order), branch));
        assert!((found.value / value - 1.0).abs() < 1e-9, "{found:?} for {value}");
        assert!((found.frequency / (order * value) - 1.0).abs() < 1e-9, "{found:?}");
    }
}

#[test]
fn motions_whose_frequencies_pass_each_other_are_told_apart_by_shape() {
    let scene = of_two(
        "m",
        r#"first = { value = 100.0, unit = "N/m" }
        second = { value = 100.0, unit = "N/m" }"#,
        r#"kinetic = "1 [kg]*(a_dot^2 + b_dot^2)/2"
        potential = "first*a^2/2 + second*b^2/2""#,
    );
    let values: Vec<f64> = (0..50).map(|step| 21.0 + 4.0 * f64::from(step)).collect();
    let found = over(&scene, "s.second", &values, &[1.0]);
    assert_eq!(found.branches.len(), 2);
    assert_eq!(found.speeds, None);
    assert!(found.critical.is_empty());
    for (row, value) in values.iter().enumerate() {
        for (branch, exact) in found.branches.iter().zip([value.sqrt(), 10.0]) {
            assert!((branch.frequencies[row] / exact - 1.0).abs() < 1e-9, "{value}");
        }
    }
    let moves: Vec<&str> = found.branches.iter().map(|branch| branch.moves.as_str()).collect();
    assert_eq!(moves, ["s.b", "s.a"]);
}

#[test]
fn a_motion_that_ceases_to_oscillate_ends_its_branch() {
    let scene = of_two(
        "m",
        r#"damping = { value = 1.0, unit = "N s/m" }"#,
        r#"kinetic = "1 [kg]*(a_dot^2 + b_dot^2)/2"
        potential = "100 [N/m]*a^2/2 + 400 [N/m]*b^2/2"
        dissipation = "damping*a_dot^2/2""#,
    );
    let values: Vec<f64> = (0..=30).map(f64::from).collect();
    let found = over(&scene, "s.damping", &values, &[]);
    for (row, value) in values.iter().enumerate() {
        let slow = found.branches[0].frequencies[row];
        assert_eq!(slow.is_finite(), *value < 20.0, "{value}");
        if slow.is_finite() {
            let exact = (100.0 - value * value / 4.0).sqrt();
            assert!((slow / exact - 1.0).abs() < 1e-9);
            assert!((found.branches[0].damping_ratios[row] - value / 20.0).abs() < 1e-9);
        }
        assert!((found.branches[1].frequencies[row] / 20.0 - 1.0).abs() < 1e-9);
    }
}

#[test]
fn orders_are_of_a_speed_and_names_are_known() {
    let scene = disc();
    let run = Simulation::new(&scene);
    let ask = |parameter, speed| {
        let (values, orders) = (&[1.0, 2.0], &[1.0]);
        let place = Place::Initial;
        campbell(&run, &Variation { parameter, values, place, speed, orders })
    };
    let said = |result: Result<Campbell, LinearError>| result.expect_err("refused").to_string();
    assert!(said(ask("s.sped", None)).contains("did you mean `s.speed`"));
    assert!(said(ask("s.speed", Some("s.load"))).contains("`s.load` is in 1"));
    assert!(said(ask("s.load", Some("s.spee"))).contains("(did you mean `s.speed`?)"));
    // The speed is a parameter that is not varied, and a state.
    let by_parameter = ask("s.load", Some("s.speed")).expect("it is in rad/s");
    assert_eq!(by_parameter.speeds.as_deref(), Some(&[100.0, 100.0][..]));
    let by_state = ask("s.load", Some("s.a_dot")).expect("it is in rad/s");
    assert_eq!(by_state.speeds.as_deref(), Some(&[0.0, 0.0][..]));
}

/// The bench winder is shaken once and twice a turn of its drum, whose speed is an output: twice a
/// turn meets the damped frequency at half of it.
#[test]
fn orders_may_be_of_a_speed_that_is_an_output() {
    let scene = include_str!("../specs/scenes/winder_linear.toml").replace(
        "[outputs]",
        "[outputs]\nturning = { expression = \"drum_speed\", unit = \"rad/s\", doc = \"turning\" }",
    );
    let scene = of_text(&scene, Keep::Needed);
    let run = Simulation::new(&scene);
    let values: Vec<f64> = (1..=20).map(|k| 0.5 * f64::from(k)).collect();
    let orders = &[1.0, 2.0];
    let variation = Variation {
        parameter: "winding_speed",
        values: &values,
        place: Place::Initial,
        speed: Some("turning"),
        orders,
    };
    let found = campbell(&run, &variation).expect("it is in rad/s");
    let damped = (45_800.0 / 1.9 - (95.0_f64 / 3.8).powi(2)).sqrt();
    let expected = [(2.0, 0.5 * damped * 0.05), (1.0, damped * 0.05)];
    assert_eq!(found.critical.len(), 2, "{:?}", found.critical);
    for (meeting, (order, value)) in found.critical.iter().zip(expected) {
        assert!((meeting.order - order).abs() < 1e-12, "{meeting:?}");
        assert!((meeting.value / value - 1.0).abs() < 1e-9, "{meeting:?} {value}");
    }
    let refused = Variation { speed: Some("turing"), ..variation };
    let said = campbell(&run, &refused).expect_err("refused").to_string();
    assert!(said.contains("is no parameter, state or output (did you mean `turning`?)"), "{said}");
}

/// Ziegler's column, M = mu \[3, 1; 1, 1\], K = \[2 k - P l, P l - k; -k, k\]: 2 mu^2 s^4 +
/// mu (7 k - 2 P l) s^2 + k^2 = 0, which flutters from P l = (7/2 - sqrt 2) k on.
#[test]
fn a_column_under_a_load_that_follows_flutters_from_the_load_known_on() {
    let scene = of_two(
        "rad",
        r#"load = { value = 100.0, unit = "N" }"#,
        r#"kinetic = "0.25 [kg m^2]*(3*a_dot^2 + b_dot^2 + 2*a_dot*b_dot*cos(a - b))/2"
        potential = "100 [N m]*(a^2 + (b - a)^2)/2"
        [[define.s.forces]]
        coordinate = "a"
        expression = "load*0.5 [m]*sin(a - b)""#,
    );
    let values: Vec<f64> = (0..=25).map(|step| 40.0 * f64::from(step)).collect();
    let found = over(&scene, "s.load", &values, &[]);
    let [growing] = &found.growing[..] else { panic!("{:?}", found.growing) };
    assert!((growing.from / ((3.5 - 2f64.sqrt()) * 200.0) - 1.0).abs() < 1e-7, "{growing:?}");
    let growth = |load: &f64| {
        let half = num_complex::Complex64::from(100.0 - load / 7.0) * 7.0;
        let square = (-half + (half * half - 8e4).sqrt()) / (4.0 * 0.25);
        square.sqrt().re.abs()
    };
    let exact = values.iter().map(growth).fold(0.0, f64::max);
    assert!((growing.fastest / exact - 1.0).abs() < 1e-9, "{growing:?} is not {exact}");
    assert_eq!((growing.to.to_bits(), growing.at.to_bits()), (1e3f64.to_bits(), 1e3f64.to_bits()));
    assert_eq!(growing.moves.len(), 2, "{growing:?}");
}

#[test]
fn a_machine_that_is_damped_grows_nowhere_and_one_driven_by_its_damping_everywhere() {
    for (damping, stretches) in [("1", 0), ("-1", 1)] {
        let energies = format!(
            r#"kinetic = "1 [kg]*(a_dot^2 + b_dot^2)/2"
            potential = "k*a^2/2 + 400 [N/m]*b^2/2"
            dissipation = "{damping} [N s/m]*a_dot^2/2""#
        );
        let scene = of_two("m", r#"k = { value = 100.0, unit = "N/m" }"#, &energies);
        let found = over(&scene, "s.k", &[100.0, 200.0, 300.0], &[]);
        assert_eq!(found.growing.len(), stretches, "{:?}", found.growing);
        for growing in &found.growing {
            let ends = [growing.from, growing.to].map(f64::to_bits);
            assert_eq!(ends, [100.0, 300.0].map(f64::to_bits));
            assert!((growing.fastest - 0.5).abs() < 1e-12 && growing.moves == ["s.a"]);
        }
    }
}

/// A torsional chain of two inertias, whose frequency is the same at every speed.
#[test]
fn a_machine_that_does_not_depend_on_speed_is_met_by_orders_at_its_frequency_over_them() {
    let simulator = of_two(
        "rad",
        r#"motor = { value = 2.0, unit = "kg m^2" }
        load = { value = 3.0, unit = "kg m^2" }
        stiffness = { value = 1200.0, unit = "N m/rad" }
        soft = { value = 7.0, unit = "N m/rad" }"#,
        r#"kinetic = "motor*a_dot^2/2 + load*b_dot^2/2"
        potential = "stiffness*(a - b)^2/2 + soft*b^2/2""#,
    );
    // w^4 - (k/m + (k + s)/l) w^2 + k s/(m l) = 0
    let (k, s, m, l) = (1200.0, 7.0, 2.0, 3.0);
    let (half, product) = (f64::midpoint(k / m, (k + s) / l), k * s / (m * l));
    let fast = half + (half * half - product).sqrt();
    let exact = [(product / fast).sqrt(), fast.sqrt()];
    let speeds: Vec<f64> = (0..=20).map(f64::from).collect();
    let run = Simulation::new(&simulator);
    let orders = [0.5, 1.0, 2.0, 10.0];
    let found = campbell_over_speeds(&run, Place::Initial, &speeds, &orders).expect("a diagram");
    assert_eq!((found.branches.len(), found.speeds.as_deref()), (2, Some(&speeds[..])));
    for (branch, exact) in found.branches.iter().zip(exact) {
        assert_eq!(branch.frequencies.len(), speeds.len());
        assert!(branch.frequencies.iter().all(|w| (w / exact - 1.0).abs() < 1e-12));
    }
    let mut expected: Vec<(f64, f64)> = orders
        .iter()
        .flat_map(|order| exact.map(|w| (*order, w / order)))
        .filter(|(_, speed)| *speed <= 20.0)
        .collect();
    expected.sort_by(|a, b| a.1.total_cmp(&b.1));
    assert_eq!(found.critical.len(), expected.len());
    for (meeting, (order, speed)) in found.critical.iter().zip(expected) {
        assert_eq!(meeting.order.to_bits(), order.to_bits());
        assert!((meeting.value / speed - 1.0).abs() < 1e-12, "{meeting:?}");
        assert!((meeting.order * meeting.value / meeting.frequency - 1.0).abs() < 1e-14);
    }
}
