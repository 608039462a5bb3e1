//! Gear meshes: a stiffness that varies with the tooth against the closed form of Hill's equation
//! with two values (Meissner), backlash against shooting from corner to corner
//! (`tests/gears/references.py`).

mod describing;

use std::f64::consts::TAU;

use machinist::Simulation;
use machinist::periodic::{
    Bifurcation, BranchSettings, Cycle, CycleSettings, Period, Stability, branch, cycle,
};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

/// A gear turned at a steady speed drives a wheel of 2.25 kg m^2 on a base radius of 1.5 m, which
/// is 1 kg along the line of action, against a steady torque.
fn drive(gears: &str, mesh: &str, backlash: f64) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "meshing"
        [units.drive]
        unit = "sources/angle"
        inputs = {{ angle = "0.013 + tooth/20*t" }}
        [units.gears]
        {gears}
        [units.wheel]
        unit = "rotational/inertia"
        parameters = {{ inertia = 2.25 }}
        [units.load]
        unit = "sources/torque"
        inputs = {{ torque = "-1.5*load_force" }}
        [[joints]]
        connect = ["drive.a", "gears.a"]
        [[joints]]
        connect = ["gears.b", "wheel.a"]
        [[joints]]
        connect = ["wheel.b", "load.a"]
        [parameters]
        tooth = {{ value = 1.0, unit = "rad/s", doc = "mesh frequency" }}
        load_force = {{ value = 0.1, unit = "N m", doc = "torque per metre of base radius" }}
        damping = {{ value = 0.1, unit = "N s/m" }}
        backlash = {{ value = {backlash:?}, unit = "m" }}
        [initial]
        "drive.phi" = 0.013
        "wheel.phi" = {:?}
        "wheel.omega" = "tooth/30"
        [guess]
        "drive.phi_dot" = "tooth/20"
        [outputs]
        way = "{mesh}.way"
        [run]
        until = 1.0
        points = 2
        rtol = 1e-11
        method = "dop853"
        "#,
        (0.013 - 0.1 - backlash / 2.0) / 1.5
    );
    of_text(&text, Keep::Needed)
}

fn of_tooth(settle: f64) -> CycleSettings {
    CycleSettings {
        period: Period::Parameter("tooth".to_owned()),
        turns: vec![("drive.phi".to_owned(), 0.05), ("wheel.phi".to_owned(), 1.0 / 30.0)],
        settle,
        points: 2001,
        ..CycleSettings::default()
    }
}

/// Returns half the range of a column.
fn amplitude(cycle: &Cycle, column: &str) -> f64 {
    let values = cycle.motion.column(column).expect("a column");
    let range = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(*value), high.max(*value))
    });
    (range.1 - range.0) / 2.0
}

/// Returns the flow of x'' + c x' + k x = f over a time, as a matrix on (x, x', 1).
fn flow(time: f64, c: f64, k: f64, f: f64) -> [[f64; 3]; 3] {
    let (decay, square) = (c / 2.0, k - c * c / 4.0);
    let omega = square.sqrt();
    let (sin, cos) = (omega * time).sin_cos();
    let envelope = (-decay * time).exp();
    let a = envelope * (cos + decay / omega * sin);
    let b = envelope * sin / omega;
    let d = envelope * (cos - decay / omega * sin);
    let rest = f / k;
    [[a, b, rest * (1.0 - a)], [-k * b, d, rest * k * b], [0.0, 0.0, 1.0]]
}

fn times(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let entry = |i: usize, j: usize| (0..3).map(|k| a[i][k] * b[k][j]).sum();
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

const PAIR: &str = r#"unit = "rotational/gear_pair"
        parameters = { teeth_a = 20, teeth_b = 30, radius_a = 1, tooth_stiffness = 0.6, contact_ratio = 1.6, backlash = 0, damping = "damping", error = 0 }"#;

/// One and two pairs of teeth in turn: the monodromy matrix is the product of the flows of two
/// oscillators. Parametric resonance is where the mesh frequency is near twice the natural one.
#[test]
fn teeth_in_turn_have_the_multipliers_of_meissner() {
    let mut unstable = 0;
    for ratio in [1.25_f64, 1.6, 2.3] {
        let gears = PAIR.replace("contact_ratio = 1.6", &format!("contact_ratio = {ratio:?}"));
        let scene = drive(&gears, "gears.mesh", 0.0);
        for (tooth, damping) in [
            (0.35, 0.1),
            (0.9, 0.05),
            (1.3, 0.02),
            (1.75, 0.02),
            (1.95, 0.0),
            (2.3, 0.01),
            (5.0, 0.3),
        ] {
            let run = Simulation::new(&scene).parameter("tooth", tooth).expect("a parameter");
            let run = run.parameter("damping", damping).expect("a parameter");
            let found = cycle(&run, &of_tooth(0.0)).expect("a cycle");
            let (span, share) = (TAU / tooth, ratio % 1.0);
            let few = 0.6 * ratio.floor();
            let begun = 20.0 * 0.013 / TAU;
            let segment = |share: f64, k: f64| flow(share * span, damping, k, 0.1);
            let whole = times(
                &segment(begun, few + 0.6),
                &times(&segment(1.0 - share, few), &segment(share - begun, few + 0.6)),
            );
            let [[a, b, p], [c, d, q], _] = whole;
            let (trace, determinant) = (a + d, a * d - b * c);
            let [one, two] = {
                let found: Vec<_> = found.nontrivial().collect();
                assert_eq!(found.len(), 2, "{found:?}");
                [found[0], found[1]].map(|m| num_complex::Complex64::new(m.real, m.imaginary))
            };
            let case = format!("{ratio}, {tooth}, {damping}: {one}, {two}");
            assert!((one + two - trace).norm() < 1e-8 * (1.0 + trace.abs()), "{case}: {trace}");
            assert!((one * two - determinant).norm() < 1e-8, "{case}: {determinant}");
            unstable += usize::from(found.stability == Stability::Unstable);
            // The steady motion solves x = whole x.
            let solved = ((1.0 - d) * p + b * q) / ((1.0 - a) * (1.0 - d) - b * c);
            let way = found.motion.column("way").expect("a column")[0];
            assert!((way - solved).abs() < 1e-8 * solved.abs().max(0.1), "{case}: {way}, {solved}");
        }
    }
    assert!((2..=8).contains(&unstable), "{unstable} of 21 are unstable");
}

const LOOSE: &str = r#"unit = "rotational/gear_mesh"
        parameters = { teeth_a = 20, teeth_b = 30, radius_a = 1, backlash = "backlash", damping = "damping" }
        inputs = { stiffness = "1 [N/m]", error = "0.05 [m]*cos(2*pi*gears.phase)" }"#;

/// Returns the same gears with a stiffness that varies with the tooth, and without error.
fn loose_and_soft() -> String {
    let varying = LOOSE.replace("1 [N/m]\"", "1 [N/m]*(1 + 0.3*cos(2*pi*gears.phase))\"");
    let soft = varying.replace("0.05 [m]*cos(2*pi*gears.phase)", "0 [m]");
    assert_ne!(soft, varying);
    soft
}

/// Teeth with backlash part near resonance: the amplitude jumps up as the speed rises past one
/// fold, and down as it falls past the other (Kahraman and Singh; Blankenship and Kahraman).
#[test]
fn loose_gears_part_near_resonance_as_in_the_reference() {
    for (gears, amplitudes) in [(LOOSE, AMPLITUDES), (&loose_and_soft(), AMPLITUDES_SOFT)] {
        let scene = drive(gears, "gears", 2.0);
        for (tooth, wanted) in amplitudes {
            let run = Simulation::new(&scene).parameter("tooth", tooth).expect("a parameter");
            let found = cycle(&run, &of_tooth(300.0)).expect("a cycle");
            assert_eq!(found.stability, Stability::Stable);
            let found = amplitude(&found, "way");
            assert!((found - wanted).abs() < 2e-5 * wanted, "{tooth}: {found} for {wanted}");
        }
    }
}

/// The same mesh as an oscillator of the way between the teeth, in closed form.
const WAY: &str = r#"
    [scene]
    name = "rattle"
    [units.pair]
    unit = "pair"
    [initial]
    "pair.x" = 1.1
    [outputs]
    way = "pair.x"
    [run]
    until = 300.0
    points = 2
    rtol = 1e-11
    method = "dop853"
    [define.pair.coordinates.x]
    unit = "m"
    [define.pair.parameters]
    tooth = { value = 1.2, unit = "rad/s" }
    damping = { value = 0.1, unit = "N s/m" }
    load = { value = 0.1, unit = "N" }
    error = { value = 0.05, unit = "m" }
    [define.pair.helpers.compression]
    expression = "max(x - 1 [m], 0) + min(x + 1 [m], 0)"
    unit = "m"
    [define.pair.energy]
    kinetic = "1 [kg]*x_dot^2/2"
    potential = "1 [N/m]*compression^2/2"
    dissipation = "damping*x_dot^2/2"
    [[define.pair.forces]]
    coordinate = "x"
    expression = "load + 1 [kg]*error*tooth^2*cos(tooth*t)"
"#;

/// Follows the branch over a parameter and returns its two folds, in the order of the branch.
fn folds(
    run: &Simulation<'_>,
    (parameter, from, to): (&str, f64, f64),
    cycle: &CycleSettings,
    most: usize,
) -> [f64; 2] {
    let settings = BranchSettings {
        cycle: cycle.clone(),
        parameter: parameter.to_owned(),
        from,
        to,
        longest_step: 0.05,
        max_points: most,
    };
    let found = branch(run, &settings).expect("a branch");
    assert!(found.is_complete, "{}", found.end);
    let all: Vec<(Bifurcation, f64)> =
        found.bifurcations().map(|(kind, point)| (kind, point.value)).collect();
    match all[..] {
        [(Bifurcation::Fold, first), (Bifurcation::Fold, second)] => [first, second],
        _ => panic!("{all:?}"),
    }
}

fn assert_folds(
    (scene, [low, high]): (&ModelSimulator, [f64; 2]),
    parameter: &str,
    cycle: &CycleSettings,
    most: usize,
) {
    for (from, to, wanted) in [(1.2, 0.6, [low, high]), (0.6, 1.2, [high, low])] {
        let found = folds(&Simulation::new(scene), (parameter, from, to), cycle, most);
        for (fold, wanted) in found.iter().zip(wanted) {
            assert!((fold - wanted).abs() < 1e-8, "{fold} for {wanted}");
        }
    }
}

#[test]
fn continuation_finds_both_folds_between_which_loose_gears_jump() {
    let cycle = CycleSettings {
        period: Period::Parameter("pair.tooth".to_owned()),
        settle: 300.0,
        points: 401,
        ..CycleSettings::default()
    };
    assert_folds((&of_text(WAY, Keep::Needed), FOLDS), "pair.tooth", &cycle, 400);
}

/// The gear part has a drive that is prescribed: a constraint that moves with time and parameter.
#[test]
fn continuation_of_the_gear_part_finds_the_folds_of_its_oscillator() {
    let scene = drive(LOOSE, "gears", 2.0);
    for segments in [1, 3] {
        let cycle = CycleSettings { segments, points: 401, ..of_tooth(300.0) };
        assert_folds((&scene, FOLDS), "tooth", &cycle, 100);
    }
}

/// Stiffness that varies and backlash together.
#[test]
fn continuation_finds_the_folds_of_loose_gears_with_a_stiffness_of_the_tooth() {
    let scene = drive(&loose_and_soft(), "gears", 2.0);
    let cycle = CycleSettings { points: 401, ..of_tooth(300.0) };
    assert_folds((&scene, FOLDS_SOFT), "tooth", &cycle, 100);
}

/// Mesh frequencies and half the range of the way between the teeth.
const AMPLITUDES: [(f64, f64); 4] = [
    (1.2, 0.132_649_191_789_544_6),
    (0.9, 0.229_166_292_386_498_16),
    (0.84, 0.261_271_83),
    (0.65, 0.036_350_559),
];

/// Mesh frequencies at the folds.
const FOLDS: [f64; 2] = [0.708_031_618_721_829, 0.828_463_984_388_200_6];

/// The same with a stiffness that varies by 0.3.
const AMPLITUDES_SOFT: [(f64, f64); 4] = [
    (1.2, 0.060_638_091_366),
    (0.9, 0.189_198_999_849),
    (0.84, 0.225_459_506_355),
    (0.65, 0.053_966_817_829),
];
const FOLDS_SOFT: [f64; 2] = [0.705_697_489_229_3, 0.844_564_142_008_1];
