//! Orders of run-ups: known components, and the response of an oscillator to a linear chirp by
//! quadrature.

use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::cli::{answer, assert_refused, text};
use crate::shaken::{self, DAMPING, MASS, STIFFNESS};

/// Growth of the speed \[rad/s^2\].
const GROWTH: f64 = 0.5;

/// A force of 3 N at the angle of a shaft that runs up.
const FORCE: &str = "3 [N]*cos(0.25 [rad/s^2]*t^2)";
const MORE: &str = r#"
    [outputs]
    way = { expression = "body.x", unit = "mm" }
    angle = { expression = "0.25 [rad/s^2]*t^2", unit = "rad" }
    speed = { expression = "0.5 [rad/s^2]*t", unit = "rad/s" }
    known = { expression = "1 [N] + 4 [N]*cos(0.5 [rad/s^2]*t^2) + 0.2 [N]*sin(0.875 [rad/s^2]*t^2)", unit = "N" }
    [run]
    until = 80
    points = 2
    rtol = 1e-11
    method = "dop853"
    "#;

fn orders(folder: &Path, options: &[&str]) -> Value {
    let [scene, json] = ["run_up.toml", "orders.json"].map(|name| folder.join(name));
    fs::write(&scene, shaken::scene(FORCE, MORE)).expect("written");
    let start = ["spectrum", text(&scene), "--out", text(&json)];
    answer(&[&start[..], options].concat());
    serde_json::from_slice(&fs::read(&json).expect("a file")).expect("JSON")
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("numbers").iter().map(|x| x.as_f64().expect("a number")).collect()
}

/// Returns the cut of an output at a line.
fn cut(found: &Value, output: &str, line: usize) -> Vec<f64> {
    let outputs = found["outputs"].as_array().expect("outputs");
    let one = outputs.iter().find(|one| one["name"] == output).expect("the output");
    let rows = one["amplitudes"].as_array().expect("rows");
    rows.iter().map(|row| numbers(row)[line]).collect()
}

/// Components of a turn have their amplitudes at any speed, by the angle and by the speed.
#[test]
fn orders_of_a_run_up_have_their_amplitudes_at_any_speed() {
    let folder = tempfile::tempdir().expect("a folder");
    for (over, turns, window) in
        [("angle", "8", "hann"), ("speed", "8", "flat_top"), ("angle", "2", "hann")]
    {
        let found = orders(
            folder.path(),
            &["--over", over, "--turns", turns, "--window", window, "--settle", "4"],
        );
        let turns: usize = turns.parse().expect("a number");
        assert_eq!(numbers(&found["orders"])[2 * turns].to_bits(), 2.0_f64.to_bits());
        let speeds = numbers(&found["speeds"]);
        assert!(speeds.windows(2).all(|pair| pair[0] < pair[1]) && speeds.len() > 40);
        for (line, wanted) in [(0, 1.0), (2 * turns, 4.0), (7 * turns / 2, 0.2), (5 * turns, 0.0)] {
            for amplitude in cut(&found, "known", line) {
                let off = (amplitude - wanted).abs();
                assert!(off < 2e-5, "{over}, {turns}, {line}: {amplitude} for {wanted}");
            }
        }
    }
}

/// Returns x(t) of m x'' + d x' + k x = 3 cos(GROWTH t^2/2) from rest, by Duhamel's integral at
/// equal steps of time. The state goes on from step to step; within one, Gauss's formula with 8
/// nodes integrates the force.
fn response(step: f64, steps: usize) -> Vec<f64> {
    const NODES: [(f64, f64); 4] = [
        (0.183_434_642_495_649_8, 0.362_683_783_378_362),
        (0.525_532_409_916_329, 0.313_706_645_877_887_3),
        (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
        (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
    ];
    let decay = DAMPING / (2.0 * MASS);
    let omega = (STIFFNESS / MASS - decay * decay).sqrt();
    // The oscillation as a complex amplitude: x = Im(z)/omega, z' = (i omega - decay) z + f/m.
    let mut z = (0.0, 0.0);
    let turned = |z: (f64, f64), time: f64| {
        let (sin, cos) = (omega * time).sin_cos();
        let envelope = (-decay * time).exp();
        (envelope * (z.0 * cos - z.1 * sin), envelope * (z.0 * sin + z.1 * cos))
    };
    let mut found = vec![0.0];
    for number in 0..steps {
        let start = step * number as f64;
        z = turned(z, step);
        for (node, weight) in NODES.into_iter().flat_map(|(x, w)| [(x, w), (-x, w)]) {
            let time = step * (0.5 + 0.5 * node);
            let force = 3.0 / MASS * (0.5 * GROWTH * (start + time).powi(2)).cos();
            let part = turned((force, 0.0), step - time);
            z = (z.0 + 0.5 * step * weight * part.0, z.1 + 0.5 * step * weight * part.1);
        }
        found.push(z.1 / omega);
    }
    found
}

/// The cut of order 1 is that of the closed form at equal angles, block by block. Its peak lies
/// near the resonance, below that of a steady speed.
#[test]
fn the_cut_of_a_run_up_through_resonance_is_that_of_the_chirp() {
    let folder = tempfile::tempdir().expect("a folder");
    let [csv, map, cuts] = ["cuts.csv", "map.png", "cuts.svg"].map(|name| folder.path().join(name));
    let (turns, samples) = (4_usize, 64_usize);
    let options = ["--over", "angle", "--turns", "4", "--orders=1", "--outputs", "way"];
    let found = orders(folder.path(), &options);
    let speeds = numbers(&found["speeds"]);
    let amplitudes = cut(&found, "way", turns);
    let steps = 160_000;
    let step = 80.0 / steps as f64;
    let fine = response(step, steps);
    // At equal angles by a cubic through four steps: (omega h)^4 is 1e-8 of the amplitude.
    let at = |time: f64| {
        let k = ((time / step) as usize).clamp(1, steps - 2);
        let u = time / step - k as f64;
        let y = [fine[k - 1], fine[k], fine[k + 1], fine[k + 2]];
        let w = [
            -u * (u - 1.0) * (u - 2.0) / 6.0,
            (u + 1.0) * (u - 1.0) * (u - 2.0) / 2.0,
            -(u + 1.0) * u * (u - 2.0) / 2.0,
            (u + 1.0) * u * (u - 1.0) / 6.0,
        ];
        y.iter().zip(w).map(|(y, w)| y * w).sum::<f64>()
    };
    let length = turns * samples;
    let largest = amplitudes.iter().copied().fold(0.0, f64::max);
    for (block, amplitude) in amplitudes.iter().enumerate() {
        let value = |n: usize| {
            let angle = TAU * (block * length / 4 + n) as f64 / samples as f64;
            1e3 * at((2.0 * angle / GROWTH).sqrt())
        };
        let weight = |n: usize| 0.5 - 0.5 * (TAU * n as f64 / length as f64).cos();
        let all: Vec<(f64, f64)> = (0..length).map(|n| (weight(n), value(n))).collect();
        let sum: f64 = all.iter().map(|(w, _)| w).sum();
        let mean = all.iter().map(|(w, x)| w * x).sum::<f64>() / sum;
        let (mut real, mut imaginary) = (0.0, 0.0);
        for (n, (w, x)) in all.iter().enumerate() {
            let (sin, cos) = (TAU * n as f64 / samples as f64).sin_cos();
            real += w * (x - mean) * cos;
            imaginary += w * (x - mean) * sin;
        }
        let wanted = 2.0 * f64::hypot(real, imaginary) / sum;
        let off = (amplitude - wanted).abs() / largest;
        assert!(off < 1e-6, "block {block}: {amplitude} for {wanted}");
    }
    let peak = (0..speeds.len()).max_by(|a, b| amplitudes[*a].total_cmp(&amplitudes[*b]));
    let peak = peak.expect("blocks");
    let natural = (STIFFNESS / MASS).sqrt();
    let steady = 1e3 * 3.0 / (DAMPING * natural);
    assert!((0.97..1.1).contains(&(speeds[peak] / natural)), "{}", speeds[peak]);
    assert!((0.9..1.0).contains(&(amplitudes[peak] / steady)), "{}", amplitudes[peak]);
    let scene = folder.path().join("run_up.toml");
    let files = ["--out", text(&csv), "--plot", text(&map), "--plot-cuts", text(&cuts)];
    let said = answer(&[&["spectrum", text(&scene)][..], &options, &files].concat());
    assert!(said.contains("blocks of 4 turns with 64 samples each"), "{said}");
    let table = fs::read_to_string(&csv).expect("a table");
    assert!(table.starts_with("time [s],speed [rad/s],way order 1 [mm]\n"), "{table}");
    assert_eq!(table.lines().count(), speeds.len() + 1);
    assert!(fs::read(&map).expect("a picture").starts_with(b"\x89PNG"));
    assert!(fs::read_to_string(&cuts).expect("a picture").contains("speed [rad/s]"));
}

#[test]
fn orders_without_a_shaft_that_turns_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = folder.path().join("run_up.toml");
    fs::write(&scene, shaken::scene(FORCE, MORE)).expect("written");
    for (options, wanted) in [
        (&["--over", "way"][..], "not in rad or rad/s"),
        (&["--over", "angel"][..], "did you mean `angle`?"),
        (&["--over", "angle", "--orders=0.3"][..], "between the lines"),
        (&["--over", "angle", "--orders=40"][..], "at most 32"),
        (&["--over", "angle", "--until", "5"][..], "fewer than a block"),
        (&["--orders=1"][..], "--over"),
    ] {
        assert_refused(&[&["spectrum", text(&scene)][..], options].concat(), &[wanted]);
    }
}

/// A universal joint between shafts at an angle beta turns the second one by
/// phi + sum t^n sin(2 n phi)/n with t = tan(beta/2)^2: the orders 2 n of its speed have the
/// amplitudes 2 omega t^n.
#[test]
fn a_universal_joint_has_the_even_orders_of_its_angle() {
    let folder = tempfile::tempdir().expect("a folder");
    let [scene, json] = ["cardan.toml", "orders.json"].map(|name| folder.path().join(name));
    for angle in [0.1_f64, 0.4, 0.9] {
        let spec = format!(
            r#"
            [scene]
            name = "cardan_shaft"
            [units.drive]
            unit = "sources/speed"
            inputs = {{ speed = "30 [rad/s]" }}
            [units.joint]
            unit = "rotational/cardan"
            parameters = {{ angle = {angle:?} }}
            [units.load]
            unit = "rotational/inertia"
            parameters = {{ inertia = 2 }}
            [[joints]]
            connect = ["drive.a", "joint.a"]
            [[joints]]
            connect = ["joint.b", "load.a"]
            [guess]
            "drive.phi_dot" = 30
            "load.omega" = 30
            [outputs]
            speed = "load.omega"
            angle = "drive.phi"
            [run]
            until = 4
            points = 2
            rtol = 1e-11
            method = "dop853"
            "#
        );
        fs::write(&scene, spec).expect("written");
        let start = ["spectrum", text(&scene), "--out", text(&json), "--over", "angle"];
        answer(&[&start[..], &["--outputs", "speed", "--turns", "4"]].concat());
        let found = serde_json::from_slice(&fs::read(&json).expect("a file")).expect("JSON");
        let t = (angle / 2.0).tan().powi(2);
        let wanted = [
            (0, 30.0),
            (1, 0.0),
            (2, 60.0 * t),
            (3, 0.0),
            (4, 60.0 * t * t),
            (6, 60.0 * t.powi(3)),
        ];
        for (order, wanted) in wanted {
            for amplitude in cut(&found, "speed", 4 * order) {
                let off = (amplitude - wanted).abs();
                assert!(off < 1e-6, "{angle}, order {order}: {amplitude}, not {wanted}");
            }
        }
    }
}
