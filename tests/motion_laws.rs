//! Motion laws against accelerations written by hand and integrated by quadrature, and against
//! the characteristic values of VDI 2143.

use std::f64::consts::PI;

use machinist::{Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;

use crate::common::column;
use crate::own_scene::{of_text, refusal};

/// Acceleration of a law between rests.
type Acceleration = fn(f64) -> f64;

fn quarters(x: f64) -> f64 {
    match x {
        x if x < 0.125 => (4.0 * PI * x).sin(),
        x if x < 0.875 => (4.0 / 3.0 * PI * (x - 0.125)).cos(),
        x => (4.0 * PI * x).sin(),
    }
}

fn trapezoid(x: f64) -> f64 {
    match x {
        x if x < 0.125 => (4.0 * PI * x).sin(),
        x if x < 0.375 => 1.0,
        x if x < 0.625 => (4.0 * PI * (x - 0.375)).cos(),
        x if x < 0.875 => -1.0,
        x => (4.0 * PI * x).sin(),
    }
}

/// Law, greatest speed, acceleration and jerk over x in the literature, and the acceleration.
#[expect(clippy::approx_constant, reason = "as printed")]
const LAWS: [(&str, [f64; 3], Acceleration); 7] = [
    ("parabola", [2.0, 4.0, 0.0], |x| if x < 0.5 { 4.0 } else { -4.0 }),
    ("simple sine", [1.5708, 4.9348, 15.503], |x| PI * PI / 2.0 * (PI * x).cos()),
    ("inclined sine", [2.0, 6.2832, 39.478], |x| 2.0 * PI * (2.0 * PI * x).sin()),
    ("3-4-5", [1.875, 5.7735, 60.0], |x| 60.0 * x - 180.0 * x * x + 120.0 * x.powi(3)),
    ("4-5-6-7", [2.1875, 7.5132, 52.5], |x| 420.0 * x * x * (1.0 - x).powi(2) * (1.0 - 2.0 * x)),
    ("modified sine", [1.7596, 5.5280, 69.466], |x| 4.0 * PI * PI / (4.0 + PI) * quarters(x)),
    ("modified trapezoid", [2.0, 4.8881, 61.427], |x| 8.0 * PI / (2.0 + PI) * trapezoid(x)),
];

/// A law of a place that moves at a speed of 1, with its derivatives along the motion.
fn scene(call: &str) -> String {
    format!(
        r#"
        [scene]
        name = "lawful"
        [units.mover]
        unit = "mover"
        [initial]
        "mover.x" = -0.5
        "mover.v" = 1.0
        [parameters]
        v0 = {{ value = 0.0, unit = "1" }}
        v1 = {{ value = 0.0, unit = "1" }}
        a0 = {{ value = 0.0, unit = "1" }}
        a1 = {{ value = 0.0, unit = "1" }}
        inflection = {{ value = 0.5, unit = "1" }}
        [outputs]
        way = {{ expression = "{call}", unit = "1" }}
        speed = {{ expression = "der({call})", unit = "1/s" }}
        acceleration = {{ expression = "der(der({call}))", unit = "1/s^2" }}
        [run]
        until = 2.0
        points = 2
        rtol = 1e-10
        method = "dop853"
        [define.mover.coordinates.x]
        unit = "1"
        velocity = "v"
        [define.mover.energy]
        kinetic = "1 [J s^2]*v^2/2"
        "#
    )
}

/// Runs from x = -0.5 with output at some x.
fn run(call: &str, set: &[(&str, f64)], at: &[f64]) -> Trajectory {
    let scene = of_text(&scene(call), Keep::Needed);
    let times: Vec<f64> = at.iter().map(|x| x + 0.5).collect();
    let run = set
        .iter()
        .try_fold(Simulation::new(&scene), |run, (name, value)| run.parameter(name, *value));
    run.expect("parameters").times(&times).run().expect("it runs")
}

/// Integrates by Gauss's formula with 8 nodes in each of `panels` panels.
fn integral(from: f64, to: f64, panels: usize, of: impl Fn(f64) -> f64) -> f64 {
    const NODES: [(f64, f64); 4] = [
        (0.183_434_642_495_649_8, 0.362_683_783_378_362),
        (0.525_532_409_916_329, 0.313_706_645_877_887_3),
        (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
        (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
    ];
    let width = (to - from) / panels as f64;
    let panel = |k: usize| {
        let middle = from + (k as f64 + 0.5) * width;
        let pair = |(node, weight): &(f64, f64)| {
            weight * (of(middle - node * width / 2.0) + of(middle + node * width / 2.0))
        };
        NODES.iter().map(pair).sum::<f64>() * width / 2.0
    };
    (0..panels).map(panel).sum()
}

/// Points inside (0, 1) at which no law has a corner.
fn places() -> Vec<f64> {
    (0..211).map(|k| (f64::from(k) + 0.37) / 211.0).collect()
}

/// Returns the integral of an acceleration from 0 to x, and that of (x - u) a(u), by panels that
/// end at the corners.
fn integrated(x: f64, corners: &[f64], a: impl Fn(f64) -> f64 + Copy) -> [f64; 2] {
    let mut ends: Vec<f64> = corners.iter().copied().filter(|c| *c > 0.0 && *c < x).collect();
    ends.insert(0, 0.0);
    ends.push(x);
    ends.dedup_by(|b, a| *b - *a < 1e-12);
    ends.windows(2).fold([0.0; 2], |[speed, way], pair| {
        let inside = |u: f64| a(u.clamp(pair[0] + 1e-15, pair[1] - 1e-15));
        let more = integral(pair[0], pair[1], 6, inside);
        let lever = integral(pair[0], pair[1], 6, |u| (x - u) * inside(u));
        [speed + more, way + lever]
    })
}

#[test]
fn laws_between_rests_integrate_their_accelerations() {
    let eighths: Vec<f64> = (0..=8).map(|k| f64::from(k) / 8.0).collect();
    for (name, _, acceleration) in LAWS {
        let at = places();
        let run = run(&format!("motion_law('{name}', mover.x)"), &[], &at);
        for (row, x) in at.iter().enumerate() {
            let [speed, way] = integrated(*x, &eighths, acceleration);
            // A simple sine starts with a step of its acceleration, and no step of its speed.
            for (column, wanted, size) in [
                (column(&run, "way"), way, 1.0),
                (column(&run, "speed"), speed, 2.0),
                (column(&run, "acceleration"), acceleration(*x), 7.0),
            ] {
                let off = (column[row] - wanted).abs() / size;
                assert!(off < 2e-13, "{name} at {x}: {} for {wanted}", column[row]);
            }
        }
    }
}

/// The characteristic values are those of the guideline, to the digits printed there.
#[test]
fn laws_have_the_characteristic_values_of_the_guideline() {
    let step = 1.0 / 65536.0;
    let at: Vec<f64> = (0..65536).map(|k| (f64::from(k) + 0.5) * step).collect();
    let greatest = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    for (name, [speed, acceleration, jerk], _) in LAWS {
        let run = run(&format!("motion_law('{name}', mover.x)"), &[], &at);
        let accelerations = column(&run, "acceleration");
        // Corners are at multiples of 1/8, so half a step from the places on either side.
        let corner = |k: usize| k % 8192 == 8191;
        let jerks: Vec<f64> = accelerations
            .windows(2)
            .enumerate()
            .filter(|(k, _)| !corner(*k))
            .map(|(_, pair)| (pair[1] - pair[0]) / step)
            .collect();
        for (found, wanted) in [
            (greatest(column(&run, "speed")), speed),
            (greatest(accelerations), acceleration),
            (greatest(&jerks), jerk),
        ] {
            // The places miss an extreme by half a step.
            assert!((found - wanted).abs() <= 1e-4 * wanted, "{name}: {found} for {wanted}");
        }
    }
}

#[test]
fn laws_dwell_outside_and_repeat_over_a_turn() {
    for (name, ..) in LAWS {
        let run = run(&format!("motion_law('{name}', mover.x)"), &[], &[-0.4, -1e-9, 1.0, 1.4]);
        assert_eq!(column(&run, "way"), [0.0, 0.0, 1.0, 1.0], "{name}");
        assert!(column(&run, "speed").iter().all(|v| v.abs() < 1e-12), "{name}");
    }
}

/// Accelerations of the two lobes of a law over their lengths, for an amplitude of 1.
type Lobes = [fn(f64) -> f64; 2];

fn long(w: f64) -> f64 {
    if w < 0.25 { (2.0 * PI * w).sin() } else { (2.0 / 3.0 * PI * (w - 0.25)).cos() }
}

fn plateau(w: f64) -> f64 {
    match w {
        w if w < 0.25 => (2.0 * PI * w).sin(),
        w if w < 0.75 => 1.0,
        w => (2.0 * PI * (w - 0.75)).cos(),
    }
}

const LOBES: [(&str, Lobes); 6] = [
    ("parabola", [|_| 1.0, |_| 1.0]),
    ("simple sine", [|w| (PI / 2.0 * w).cos(), |w| (PI / 2.0 * w).sin()]),
    ("inclined sine", [|w| (PI * w).sin(), |w| (PI * w).sin()]),
    ("modified sine", [long, |w| long(1.0 - w)]),
    ("modified trapezoid", [plateau, |w| plateau(1.0 - w)]),
    ("harmonic combination", [long, |w| (PI / 2.0 * w).sin()]),
];

/// The amplitudes of both lobes follow from two equations, for the speed and the way at x = 1.
#[test]
fn laws_of_two_lobes_match_speeds_at_both_ends_with_any_inflection() {
    for (name, [rise, fall]) in LOBES {
        let call = format!("motion_law('{name}', mover.x, v0, v1, inflection)");
        for (v0, v1, m) in [
            (0.0, 0.0, 0.5),
            (0.0, 0.0, 0.31),
            (0.7, 0.0, 0.5),
            (0.0, 1.4, 0.65),
            (-0.8, 0.6, 0.42),
            (1.9, -2.3, 0.8),
            (1.0, 1.0, 0.1),
        ] {
            let at = places();
            let set = [("v0", v0), ("v1", v1), ("inflection", m)];
            let run = run(&call, &set, &at);
            let n = 1.0 - m;
            let corners: Vec<f64> = [0.0, 0.25, 0.75, 1.0]
                .iter()
                .flat_map(|c| [c * m, m + c * n])
                .chain([m + 0.5 * n])
                .collect();
            let mut corners = corners;
            corners.sort_by(f64::total_cmp);
            let first = |x: f64| if x < m { rise(x / m) } else { 0.0 };
            let second = |x: f64| if x < m { 0.0 } else { fall((x - m) / n) };
            let [i1, j1] = integrated(1.0, &corners, first);
            let [i2, j2] = integrated(1.0, &corners, second);
            // i1 A - i2 B = v1 - v0, j1 A - j2 B = 1 - v0.
            let (p, q) = (v1 - v0, 1.0 - v0);
            let determinant = -i1 * j2 + i2 * j1;
            let (a, b) = ((-p * j2 + q * i2) / determinant, (i1 * q - j1 * p) / determinant);
            let acceleration = |x: f64| a * first(x) - b * second(x);
            for (row, x) in at.iter().enumerate() {
                let [speed, way] = integrated(*x, &corners, acceleration);
                for (column, wanted, size) in [
                    (column(&run, "way"), way + v0 * x, 1.0),
                    (column(&run, "speed"), speed + v0, 1.0 + v0.abs() + v1.abs()),
                    (column(&run, "acceleration"), acceleration(*x), a.abs() + b.abs()),
                ] {
                    let off = (column[row] - wanted).abs() / size.max(1.0);
                    let case = format!("{name}, {v0}, {v1}, {m} at {x}");
                    assert!(off < 2e-13, "{case}: {} for {wanted}", column[row]);
                }
            }
        }
    }
}

#[test]
fn laws_go_on_at_the_speeds_of_their_ends() {
    let set = [("v0", 0.7), ("v1", -1.2), ("inflection", 0.4)];
    let at = [-0.5, -0.1, 1.1, 1.5];
    for (name, ..) in LOBES {
        let call = format!("motion_law('{name}', mover.x, v0, v1, inflection)");
        let run = run(&call, &set, &at);
        for (row, wanted) in [-0.35, -0.07, 1.0 - 0.12, 1.0 - 0.6].into_iter().enumerate() {
            assert!((column(&run, "way")[row] - wanted).abs() < 1e-13, "{name}");
        }
    }
}

/// A polynomial of degree 2 n + 1 is fixed by n + 1 conditions at each end.
#[test]
fn polynomials_match_speeds_and_accelerations_at_their_ends() {
    let small = 1e-9;
    for (name, degree) in [("3-4-5", 5), ("4-5-6-7", 7)] {
        let call = format!("motion_law('{name}', mover.x, v0, v1, a0, a1)");
        for [v0, v1, a0, a1] in [
            [0.0; 4],
            [1.0, 1.0, 0.0, 0.0],
            [0.5, -2.0, 0.0, 0.0],
            [0.0, 0.0, 3.0, -7.0],
            [-1.3, 2.1, 11.0, 5.0],
        ] {
            let set = [("v0", v0), ("v1", v1), ("a0", a0), ("a1", a1)];
            let nodes: Vec<f64> = (0..=degree + 1).map(|k| f64::from(k) / 10.0 + 0.1).collect();
            let at: Vec<f64> =
                [small].into_iter().chain(nodes.iter().copied()).chain([1.0 - small]).collect();
            let run = run(&call, &set, &at);
            let last = at.len() - 1;
            let (way, speed) = (column(&run, "way"), column(&run, "speed"));
            let acceleration = column(&run, "acceleration");
            for (found, wanted) in [
                (way[0], 0.0),
                (way[last], 1.0),
                (speed[0], v0),
                (speed[last], v1),
                (acceleration[0], a0),
                (acceleration[last], a1),
            ] {
                assert!((found - wanted).abs() < 1e-6, "{name} {set:?}: {found} for {wanted}");
            }
            // Its differences of order 2 n + 2 vanish.
            let mut differences = way[1..last].to_vec();
            for _ in 0..=degree {
                differences = differences.windows(2).map(|pair| pair[1] - pair[0]).collect();
            }
            assert!(differences.iter().all(|d| d.abs() < 1e-11), "{name}: {differences:?}");
            // The seventh degree leaves with no jerk: a - a0 grows as x^2.
            if degree == 7 {
                let jerk = |row: usize, end: f64| (acceleration[row] - end) / small;
                assert!(jerk(0, a0).abs() < 1e-3 && jerk(last, a1).abs() < 1e-3, "{name}");
            }
        }
    }
}

#[test]
fn laws_that_are_none_are_refused_at_their_name() {
    for (call, wanted) in [
        ("motion_law('modified sinus', mover.x)", "did you mean `modified sine`?"),
        ("motion_law(mover.x, mover.x)", "the name of a law must be quoted"),
        ("motion_law('3-4-5', mover.x, 1)", "this law takes 0, 2 or 4 arguments after x, not 1"),
        ("motion_law('parabola', mover.x, 1, 1, 1, 1)", "0, 2 or 3 arguments after x, not 4"),
        ("motion_law('parabola', mover.x, 0, 0, 1.2)", "lies between 0 and 1"),
        ("motion_law('3-4-5', t)", "must be dimensionless"),
        ("motion_law('3-4-5')", "wrong number or kind of arguments"),
    ] {
        let said = refusal(&scene(call));
        assert!(said.contains(wanted), "{call}: {said}");
    }
}

/// A servo turns an inertia by a law: its torque is the inertia times the acceleration.
#[test]
fn a_drive_that_imposes_a_law_needs_the_torque_of_its_acceleration() {
    for (name, _, acceleration) in LAWS {
        let text = format!(
            r#"
            [scene]
            name = "indexed"
            [units.drive]
            unit = "sources/angle"
            parameters = {{ inertia = 0.3 }}
            inputs = {{ angle = "pitch*motion_law('{name}', (t - begin)/span)" }}
            [parameters]
            pitch = {{ value = 0.8, unit = "rad" }}
            begin = {{ value = 0.1, unit = "s" }}
            span = {{ value = 0.25, unit = "s" }}
            [outputs]
            angle = "drive.phi"
            torque = "drive.torque"
            [run]
            until = 0.5
            points = 2
            rtol = 1e-10
            method = "dop853"
            "#
        );
        let scene = of_text(&text, Keep::Needed);
        for (pitch, begin, span) in [(0.8, 0.1, 0.25), (-2.0, 0.0, 0.4), (0.01, 0.3, 0.01)] {
            // A step of the acceleration at the start of a run is a step of the initial torque.
            let at: Vec<f64> = places().iter().map(|x| begin + x * span).collect();
            let set = [("pitch", pitch), ("begin", begin), ("span", span)];
            let run = set.iter().try_fold(Simulation::new(&scene), |run, (name, value)| {
                run.parameter(name, *value)
            });
            let run = run.expect("parameters").times(&at).run().expect("it runs");
            let size = 0.3 * pitch.abs() / (span * span);
            for (row, x) in places().iter().enumerate() {
                let torque = column(&run, "torque")[row];
                let wanted = 0.3 * pitch * acceleration(*x) / (span * span);
                let off = (torque - wanted).abs() / size;
                assert!(off < 1e-8, "{name}, {span} at {x}: {torque} for {wanted}");
            }
        }
    }
}
