//! Scenes assembled from the library's parts against published results of the Modelica
//! Standard Library; see `tests/msl/README.md`.

use std::path::Path;

use machinist::Simulation;
use machinist_codegen::mechanics::reduce::Keep;

use crate::own_scene::of_specs;

/// Columns of a reference with those of ours, and the largest difference over the
/// reference's range.
type Signals = &'static [(&'static str, &'static str, f64)];

/// The header of a reference and its rows.
fn reference(name: &str) -> (Vec<String>, Vec<Vec<f64>>) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("msl").join(name);
    let text = std::fs::read_to_string(path).expect("a reference");
    let mut lines = text.lines();
    let header = lines.next().expect("a header").split(',').map(str::to_owned).collect();
    let row = |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
    (header, lines.map(row).collect())
}

/// Every signal at every row within its tolerance.
fn agree(scene: &str, csv: &str, signals: Signals) {
    let (header, rows) = reference(csv);
    let times: Vec<f64> = rows.iter().map(|row| row[0]).collect();
    let simulator = of_specs(&format!("msl/{scene}"), Keep::Needed);
    let run = Simulation::new(&simulator).from(0.0).times(&times).run().expect("it runs");
    let mut wrong = Vec::new();
    for (theirs, ours, tolerance) in signals {
        let column = header.iter().position(|name| name == theirs).expect("a column");
        let expected: Vec<f64> = rows.iter().map(|row| row[column]).collect();
        let least = expected.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = expected.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let found = run.column(ours).expect("an output");
        let off = found.iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let off = off / (greatest - least);
        println!("{scene} {theirs}: {off:.1e}");
        if off.is_nan() || off > *tolerance {
            wrong.push(format!("{theirs}: {off:.1e} of the range, allowed {tolerance:.0e}"));
        }
    }
    assert!(wrong.is_empty(), "{scene}: {}", wrong.join("; "));
}

/// The reference's own solver errs in phase by 3e-4 of the range.
const FIRST: Signals = &[
    ("damper.phi_rel", "damper_twist", 5e-4),
    ("damper.w_rel", "damper_rate", 5e-4),
    ("inertia3.phi", "angle3", 5e-4),
    ("inertia3.w", "speed3", 5e-4),
];

#[test]
fn first() {
    agree("first", "Rotational_First.csv", FIRST);
}

#[test]
fn first_grounded() {
    agree("first_grounded", "Rotational_FirstGrounded.csv", FIRST);
}

#[test]
fn oscillator() {
    // The reference's phase errs by 5e-4 of the range near resonance, 2e-4 with damping.
    let signals: Signals = &[
        ("damper1.s_rel", "damper1_length", 5e-4),
        ("damper1.v_rel", "damper1_rate", 5e-4),
        ("mass1.s", "place1", 1e-3),
        ("mass1.v", "speed1", 1e-3),
    ];
    agree("oscillator", "Translational_Oscillator.csv", signals);
}

#[test]
fn damper() {
    let signals: Signals = &[
        ("damper1.s_rel", "length1", 1e-5),
        ("damper1.v_rel", "rate1", 1e-5),
        ("damper2.s_rel", "length2", 1e-5),
        ("damper2.v_rel", "rate2", 1e-5),
        ("springDamper3.s_rel", "length3", 1e-5),
        ("springDamper3.v_rel", "rate3", 1e-5),
    ];
    agree("damper", "Translational_Damper.csv", signals);
}

#[test]
fn preload() {
    let signals: Signals = &[
        ("friction.v_rel", "spool_speed", 1e-3),
        ("innerContactA.s_rel", "inner_a", 1e-3),
        ("innerContactB.s_rel", "inner_b", 1e-3),
        ("outerContactA.v_rel", "outer_a_rate", 1e-3),
        ("outerContactB.s_rel", "outer_b", 1e-3),
        ("outerContactB.v_rel", "outer_b_rate", 1e-3),
    ];
    agree("preload", "Translational_PreLoad.csv", signals);
}

#[test]
fn dcpm_start() {
    let signals: Signals = &[
        ("dcpm.la.i", "current", 1e-5),
        ("loadInertia.phi", "angle", 1e-5),
        ("loadInertia.w", "speed", 1e-5),
    ];
    agree("dcpm_start", "Machines_DCPM_Start.csv", signals);
}

#[test]
fn friction() {
    let signals: Signals = &[
        ("clutch.phi_rel", "clutch_angle", 3e-5),
        ("clutch.w_rel", "clutch_speed", 3e-5),
        ("inertia3.phi", "angle3", 3e-5),
        ("inertia3.w", "speed3", 3e-5),
        ("spring.phi_rel", "twist", 3e-5),
        ("spring.w_rel", "twist_rate", 3e-5),
    ];
    agree("friction", "Rotational_Friction.csv", signals);
}

#[test]
fn coupled_clutches() {
    let signals: Signals = &[
        ("J1.phi", "angle1", 3e-5),
        ("J1.w", "speed1", 3e-5),
        ("clutch1.phi_rel", "angle_of_clutch1", 3e-5),
        ("clutch1.w_rel", "speed_of_clutch1", 3e-5),
        ("clutch2.phi_rel", "angle_of_clutch2", 3e-5),
        ("clutch2.w_rel", "speed_of_clutch2", 3e-5),
        ("clutch3.phi_rel", "angle_of_clutch3", 3e-5),
        ("clutch3.w_rel", "speed_of_clutch3", 3e-5),
    ];
    agree("coupled_clutches", "Rotational_CoupledClutches.csv", signals);
}

#[test]
fn one_way_clutch() {
    let signals: Signals = &[
        ("inertiaIn.phi", "angle_in", 1.5e-4),
        ("inertiaIn.w", "speed_in", 1.5e-4),
        ("oneWayClutch.phi_rel", "angle", 1.5e-4),
        ("oneWayClutch.w_rel", "speed", 1.5e-4),
    ];
    agree("one_way_clutch", "Rotational_OneWayClutch.csv", signals);
}

#[test]
fn lossy_gear() {
    // The mesh is elastic: what it swings each time the gear stops falls with the root of its
    // stiffness, 2.7e-3 of the range at 1e7 N m/rad.
    let signals: Signals = &[("Inertia2.phi", "angle", 4e-4), ("Inertia2.w", "speed", 3e-4)];
    agree("lossy_gear", "Rotational_LossyGearDemo1.csv", signals);
}

#[test]
fn sliding_friction() {
    let signals: Signals = &[
        ("stop1.s", "place1", 3e-5),
        ("stop1.v", "speed1", 3e-5),
        ("stop2.s", "place2", 3e-5),
        ("stop2.v", "speed2", 3e-5),
        // The law of the reference is a table of 50 speeds with straight lines between.
        ("mass.s", "place3", 5e-3),
        ("mass.v", "speed3", 5e-3),
    ];
    agree("sliding_friction", "Translational_Friction.csv", signals);
}
