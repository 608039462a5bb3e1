//! Periodic motions, their multipliers and branches. `tests/cycles/references.py` computes the
//! reference values.

mod bouncing;
mod machines;
mod specs;
mod studies;

use std::f64::consts::{PI, TAU};
use std::sync::atomic::AtomicBool;

use machinist::error::StopCause;
use machinist::periodic::{
    Bifurcation, BranchSettings, Crossing, Cycle, CycleError, CycleSettings, Period, Stability,
    branch, cycle,
};
use machinist::{Method, SimulateError, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;
use machinist_scenes::scenes::bouncing_mass::BouncingMass;
use machinist_scenes::scenes::stick_slip::StickSlip;

use self::specs::{BY_MODES, BY_SIGN, DUFFING};
use crate::own_scene::{of_specs, of_text};

/// Start x, x', number of segments, and multipliers of the three motions at omega = 1.6.
type Reference = (f64, f64, usize, [(f64, f64); 2]);
const DUFFING_AT_1_6: [Reference; 3] = [
    (
        0.859_549_923_672_858_3,
        1.947_153_120_206_419,
        1,
        [
            (0.635_714_037_458_308_5, 0.520_672_228_214_866_1),
            (0.635_714_037_458_308_5, -0.520_672_228_214_866_1),
        ],
    ),
    (
        -0.906_109_060_643_935_6,
        1.662_599_464_128_847_5,
        5,
        [(1.664_803_325_179_692_5, 0.0), (0.405_592_598_502_826_3, 0.0)],
    ),
    (
        -0.193_848_362_478_811_8,
        0.032_521_830_369_414_74,
        2,
        [
            (-0.516_322_571_735_284, 0.639_251_835_016_873_3),
            (-0.516_322_571_735_284, -0.639_251_835_016_873_3),
        ],
    ),
];

/// Frequencies and crests at the folds.
const DUFFING_FOLDS: [(f64, f64); 2] = [
    (1.779_719_524_298_572, 1.722_252_019_352_125),
    (1.324_236_200_770_565_5, 0.592_832_191_094_890_8),
];

fn of_period(name: &str, settle: f64) -> CycleSettings {
    let period = Period::Parameter(name.to_owned());
    CycleSettings { period, settle, ..CycleSettings::default() }
}

fn near(value: f64, wanted: f64, tolerance: f64) {
    let off = (value - wanted).abs() / wanted.abs();
    assert!(off <= tolerance, "{value} instead of {wanted}: off by {off:.1e}");
}

/// Returns the real multipliers but that of the phase.
fn multipliers(cycle: &Cycle) -> Vec<f64> {
    cycle.nontrivial().map(|multiplier| multiplier.real).collect()
}

fn crest(cycle: &Cycle, column: &str) -> f64 {
    let values = cycle.motion.column(column).expect("a column");
    values.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
}

#[test]
fn van_der_pol_has_the_period_and_the_multiplier_of_the_reference() {
    let scene = of_specs("classics/van_der_pol", Keep::Needed);
    // mu, period, second multiplier.
    for (mu, period, multiplier) in [
        (0.01, 6.283_224_576_985_487_9, 0.939_100_629_856_157_2),
        (0.1, 6.287_111_272_288_727, 0.533_069_259_209_673_8),
        (1.0, 6.663_286_859_323_13, 8.596_950_636_038_052e-4),
        (10.0, 19.078_369_566_939_014, 0.0),
        (100.0, 162.837_071_092_370_7, 0.0),
        (1000.0, 1_614.401_125_808_085, 0.0),
    ] {
        let run = Simulation::new(scene.single());
        let run = run.parameter("oscillator.damping", mu).expect("a parameter").rtol(1e-11);
        let settle = if mu < 1.0 { 60.0 } else { 3.0 * (2.0 * mu + 6.0) };
        let settings = CycleSettings { settle, ..CycleSettings::default() };
        let found = cycle(&run, &settings).expect("a cycle");
        near(found.period, period, 1e-9);
        assert_eq!(found.stability, Stability::Stable);
        let [other] = multipliers(&found)[..] else { panic!("{:?}", found.multipliers) };
        assert!((other - multiplier).abs() < 1e-9, "mu {mu}: {other}");
        let phase = found.multipliers.iter().find(|one| one.is_trivial).expect("the phase");
        // The rate where the motion begins is a thousandth of that of the jumps.
        assert!((phase.real - 1.0).abs() < 1e-9 * (1.0 + mu * mu), "mu {mu}: {}", phase.real);
    }
}

#[test]
fn three_motions_of_a_driven_hard_spring_have_the_multipliers_of_the_reference() {
    let scene = of_text(DUFFING, Keep::Needed);
    for (x, v, segments, wanted) in DUFFING_AT_1_6 {
        let run = Simulation::new(scene.single());
        let run = run.parameter("block.frequency", 1.6).expect("a parameter");
        let run = run.initial_value("block.x", x + 1e-4).expect("a state");
        let run = run.initial_value("block.v", v).expect("a state");
        let settings = CycleSettings { segments, ..of_period("block.frequency", 0.0) };
        let found = cycle(&run, &settings).expect("a cycle");
        assert!((found.state[0] - x).abs() < 1e-9 && (found.state[1] - v).abs() < 1e-9);
        assert_eq!(found.multipliers.len(), 2);
        for (one, (real, imaginary)) in found.multipliers.iter().zip(wanted) {
            let off = (one.real - real).hypot(one.imaginary - imaginary);
            assert!(off < 1e-8, "{one:?} instead of {real} + {imaginary} i");
        }
        let is_stable = wanted[0].0.hypot(wanted[0].1) < 1.0;
        assert_eq!(found.stability == Stability::Stable, is_stable);
    }
}

#[test]
fn eigenvectors_are_those_of_differences() {
    let scene = of_text(DUFFING, Keep::Needed);
    let run = Simulation::new(scene.single());
    let run = run.parameter("block.frequency", 1.6).expect("a parameter");
    let (x, v, ..) = DUFFING_AT_1_6[1];
    let run = run.initial_value("block.x", x).expect("a state");
    let run = run.initial_value("block.v", v).expect("a state");
    let found = cycle(&run, &of_period("block.frequency", 0.0)).expect("a cycle");
    let one = &found.multipliers[0];
    assert!(one.imaginary == 0.0 && one.modulus > 1.0);
    let step = 1e-5;
    let end = |sign: f64| {
        let state: Vec<f64> =
            found.state.iter().zip(&one.vector).map(|(y, [re, _])| y + sign * step * re).collect();
        let run = run.clone().initial_value("block.x", state[0]).expect("a state");
        let run = run.initial_value("block.v", state[1]).expect("a state");
        let run = run.until(found.period).run().expect("a run");
        ["block.x", "block.v"].map(|name| run.last(name).expect("a state"))
    };
    let (ahead, behind) = (end(1.0), end(-1.0));
    for (index, [re, im]) in one.vector.iter().enumerate() {
        let grown = (ahead[index] - behind[index]) / (2.0 * step);
        assert!((grown - one.real * re).abs() < 1e-7 && *im == 0.0);
    }
}

#[test]
fn a_backbone_is_followed_through_the_folds_of_harmonic_balance() {
    let scene = of_text(DUFFING, Keep::Needed);
    let settings = BranchSettings {
        cycle: CycleSettings { points: 201, ..of_period("block.frequency", 200.0) },
        parameter: "block.frequency".to_owned(),
        from: 0.6,
        to: 2.2,
        longest_step: 0.05,
        max_points: 1000,
    };
    let run = Simulation::new(scene.single());
    let found = branch(&run, &settings).expect("a branch");
    assert!(found.is_complete, "{}", found.end);
    let folds: Vec<_> = found.bifurcations().collect();
    assert_eq!(folds.len(), 2);
    for ((kind, point), (frequency, amplitude)) in folds.iter().zip(DUFFING_FOLDS) {
        assert_eq!(*kind, Bifurcation::Fold);
        // Errors of the frequency are squares of those of the place on the branch.
        near(point.value, frequency, 1e-9);
        near(crest(&point.cycle, "x"), amplitude, 1e-3);
        assert!((point.cycle.multipliers[0].modulus - 1.0).abs() < 1e-5);
    }
    // Between the folds the branch is unstable, elsewhere stable.
    let mut is_unstable = false;
    for point in &found.points {
        match point.bifurcation {
            Some(_) => is_unstable = !is_unstable,
            None => assert_eq!(point.cycle.stability == Stability::Unstable, is_unstable),
        }
    }
    let back = BranchSettings { from: 2.2, to: 0.6, ..settings };
    let back = branch(&run, &back).expect("a branch");
    let values: Vec<f64> = back.bifurcations().map(|(_, point)| point.value).collect();
    assert_eq!(values.len(), 2);
    near(values[0], DUFFING_FOLDS[1].0, 1e-9);
    near(values[1], DUFFING_FOLDS[0].0, 1e-9);
}

#[test]
fn stick_slip_without_stribeck_has_its_closed_form() {
    let run = Simulation::new(&StickSlip).rtol(1e-11);
    let run = run.parameter("slider.stribeck_friction", 0.0).expect("a parameter");
    let settings = CycleSettings { settle: 5.0, ..CycleSettings::default() };
    let (mass, stiffness, normal, most, least, belt) = (1.0, 400.0, 10.0, 0.4, 0.25, 0.1);
    let omega: f64 = f64::sqrt(stiffness / mass);
    let excess = (most - least) * normal / stiffness;
    let slip = 2.0 / omega * (PI - (excess * omega / belt).atan());
    let found = cycle(&run, &settings).expect("a cycle");
    near(found.period, slip + 2.0 * excess / belt, 1e-10);
    assert_eq!(found.stability, Stability::Stable);
    // Sticking forgets the disturbance.
    assert!(multipliers(&found)[0].abs() < 1e-10);
}

#[test]
fn dry_friction_without_stops_has_the_amplitude_of_den_hartog() {
    for text in [BY_MODES, BY_SIGN] {
        let scene = of_text(&specs::rubbing(text), Keep::Needed);
        for frequency in [0.7_f64, 0.9, 1.3] {
            let run = Simulation::new(scene.single());
            let run = run.parameter("block.frequency", frequency).expect("a parameter");
            let found = cycle(&run, &of_period("block.frequency", 300.0)).expect("a cycle");
            // Den Hartog, Trans. ASME 53, 1931, with natural frequency 1 and static deflection 1.
            let v = 1.0 / (1.0 - frequency * frequency);
            let angle = PI / frequency;
            let u = angle.sin() / (frequency * (1.0 + angle.cos()));
            let amplitude = (v * v - (0.3 * u).powi(2)).sqrt();
            near(crest(&found, "x"), amplitude, 1e-4);
            assert_eq!(
                found.motion.switches.iter().filter(|s| s.event.contains("ends")).count(),
                if found.motion.switches.is_empty() { 0 } else { 2 }
            );
        }
    }
}

/// Stops begin where the block accelerates by nothing as it turns: amplitude times the square of the
/// frequency is the friction, f^2 = V^2/(U^2 + 1/w^4).
#[test]
fn stops_begin_at_the_boundary_of_den_hartog() {
    let scene = of_text(&specs::rubbing(BY_MODES), Keep::Needed);
    for frequency in [0.6_f64, 0.9, 1.3] {
        let v = 1.0 / (1.0 - frequency * frequency);
        let angle = PI / frequency;
        let u = angle.sin() / (frequency * (1.0 + angle.cos()));
        let boundary = v.abs() / u.hypot(1.0 / (frequency * frequency));
        let settings = BranchSettings {
            cycle: CycleSettings { points: 101, ..of_period("block.frequency", 300.0) },
            parameter: "block.friction".to_owned(),
            from: 0.8 * boundary,
            to: 1.1 * boundary,
            longest_step: 0.1,
            max_points: 200,
        };
        let run = Simulation::new(scene.single());
        let run = run.parameter("block.frequency", frequency).expect("a parameter");
        let found = branch(&run, &settings).expect("a branch");
        assert!(found.is_complete, "{frequency}: {}", found.end);
        let bends: Vec<_> = found.bifurcations().map(|(kind, p)| (kind, p.value)).collect();
        let [(kind, value)] = bends[..] else { panic!("{frequency}: {boundary} {bends:?}") };
        assert_eq!(kind, Bifurcation::Events);
        near(value, boundary, 1e-8);
    }
}

#[test]
fn motions_with_stops_have_the_same_multipliers_by_modes_and_along_a_surface() {
    let settings = of_period("block.frequency", 60.0);
    let find = |scene: &ModelSimulator| {
        let run = Simulation::new(scene.single());
        let run = run.parameter("block.friction", 0.7).expect("a parameter");
        let run = run.parameter("block.frequency", 0.4).expect("a parameter");
        cycle(&run, &settings).expect("a cycle")
    };
    let (by_modes, by_sign) = (
        find(&of_text(&specs::rubbing(BY_MODES), Keep::Needed)),
        find(&of_text(&specs::rubbing(BY_SIGN), Keep::Needed)),
    );
    for found in [&by_modes, &by_sign] {
        assert!(!found.notes.iter().any(|note| note.contains("differences")), "{:?}", found.notes);
    }
    near(crest(&by_sign, "x"), crest(&by_modes, "x"), 1e-6);
    // The place of a stop depends on that of the last one.
    let largest = |cycle: &Cycle| cycle.multipliers[0].real;
    assert!(largest(&by_modes) > 1e-4);
    let off = (largest(&by_modes) - largest(&by_sign)).abs();
    assert!(off < 1e-6, "{off:e}: {:?}", by_sign.multipliers);
}

/// Rotor with an eccentric mass: phi'' = torque - damping phi' - weight sin(phi).
const ROTOR: &str = r#"
    [scene]
    name = "eccentric"
    [units.rotor]
    unit = "rotor"
    [initial]
    "rotor.omega" = 4.0
    [outputs]
    speed = "rotor.omega"
    [run]
    until = 60.0
    points = 2
    rtol = 1e-11
    method = "dop853"
    [define.rotor.coordinates.phi]
    unit = "rad"
    velocity = "omega"
    [define.rotor.parameters]
    torque = { value = 0.8, unit = "N m" }
    damping = { value = 0.2, unit = "N m s/rad" }
    weight = { value = 3.0, unit = "N m" }
    [define.rotor.energy]
    kinetic = "1 [kg m^2]*omega^2/2"
    potential = "-weight*cos(phi)"
    dissipation = "damping*omega^2/2"
    [[define.rotor.forces]]
    coordinate = "phi"
    expression = "torque"
"#;

#[test]
fn a_turning_eccentric_rotor_repeats_after_a_turn() {
    let scene = of_text(ROTOR, Keep::All);
    let run = Simulation::new(scene.single());
    let settings = CycleSettings {
        turns: vec![("rotor.phi".to_owned(), 1.0)],
        settle: 60.0,
        ..CycleSettings::default()
    };
    let found = cycle(&run, &settings).expect("a cycle");
    // The same with the angle as independent variable, by Runge-Kutta's method of order 4: speed,
    // time.
    let rate = |phi: f64, omega: f64| [(0.8 - 0.2 * omega - 3.0 * phi.sin()) / omega, 1.0 / omega];
    let (mut omega, mut period) = (found.state[1], 0.0);
    let steps = 4000;
    let h = TAU / f64::from(steps);
    for index in 0..steps {
        let phi = found.state[0] + h * f64::from(index);
        let a = rate(phi, omega);
        let b = rate(phi + h / 2.0, omega + h / 2.0 * a[0]);
        let c = rate(phi + h / 2.0, omega + h / 2.0 * b[0]);
        let d = rate(phi + h, omega + h * c[0]);
        period += h / 6.0 * (a[1] + 2.0 * b[1] + 2.0 * c[1] + d[1]);
        omega += h / 6.0 * (a[0] + 2.0 * b[0] + 2.0 * c[0] + d[0]);
    }
    near(omega, found.state[1], 1e-9);
    near(found.period, period, 1e-9);
    near(multipliers(&found)[0], (-0.2 * period).exp(), 1e-8);
    assert_eq!(found.stability, Stability::Stable);
}

/// Driven pendulum as a mass on a rod, and by its angle.
const PENDULUM_BY_ROD: &str = r#"
    [scene]
    name = "rod"
    [units.bob]
    unit = "bob"
    [constraints.rod]
    expression = "(bob.x^2 + bob.y^2 - 1 [m^2])/2/1 [m]"
    [initial]
    "bob.x" = 0.3
    [guess]
    "bob.y" = -1.0
    [outputs]
    x = "bob.x"
    [run]
    until = 100.0
    points = 2
    rtol = 1e-11
    method = "dop853"
    [define.bob.coordinates.x]
    unit = "m"
    velocity = "u"
    [define.bob.coordinates.y]
    unit = "m"
    velocity = "v"
    [define.bob.parameters]
    damping = { value = 0.2, unit = "N s/m" }
    force = { value = 1.0, unit = "N" }
    frequency = { value = 2.5, unit = "rad/s" }
    [define.bob.energy]
    kinetic = "1 [kg]*(u^2 + v^2)/2"
    potential = "9.81 [N]*y"
    dissipation = "damping*(u^2 + v^2)/2"
    [[define.bob.forces]]
    coordinate = "x"
    expression = "force*cos(frequency*t)"
"#;
const PENDULUM_BY_ANGLE: &str = r#"
    [scene]
    name = "angle"
    [units.bob]
    unit = "bob"
    [initial]
    "bob.phi" = 0.3
    [outputs]
    x = { expression = "sin(bob.phi)*1 [m]", unit = "m" }
    [run]
    until = 100.0
    points = 2
    rtol = 1e-11
    method = "dop853"
    [define.bob.coordinates.phi]
    unit = "rad"
    velocity = "omega"
    [define.bob.parameters]
    damping = { value = 0.2, unit = "N m s/rad" }
    force = { value = 1.0, unit = "N m" }
    frequency = { value = 2.5, unit = "rad/s" }
    [define.bob.energy]
    kinetic = "1 [kg m^2]*omega^2/2"
    potential = "-9.81 [N m]*cos(phi)"
    dissipation = "damping*omega^2/2"
    [[define.bob.forces]]
    coordinate = "phi"
    expression = "force*cos(frequency*t)*cos(phi)"
"#;

#[test]
fn constraints_leave_the_multipliers_of_the_minimal_coordinates() {
    let find = |text: &str, segments: usize| {
        let scene = of_text(text, Keep::Needed);
        let settings = CycleSettings { segments, ..of_period("bob.frequency", 100.0) };
        cycle(&Simulation::new(scene.single()), &settings).expect("a cycle")
    };
    let angle = find(PENDULUM_BY_ANGLE, 1);
    for segments in [1, 3] {
        let rod = find(PENDULUM_BY_ROD, segments);
        assert_eq!((rod.multipliers.len(), angle.multipliers.len()), (2, 2));
        for (a, b) in rod.multipliers.iter().zip(&angle.multipliers) {
            assert!((a.real - b.real).hypot(a.imaginary - b.imaginary) < 1e-8, "{a:?} {b:?}");
        }
        near(crest(&rod, "x"), crest(&angle, "x"), 1e-8);
        assert_eq!(rod.multipliers[0].crossing, Crossing::NeimarkSacker);
    }
}

#[test]
fn searches_without_a_period_or_a_motion_are_refused() {
    let duffing = of_text(DUFFING, Keep::Needed);
    let run = Simulation::new(duffing.single());
    let unknown = CycleSettings { settle: 10.0, ..CycleSettings::default() };
    assert!(matches!(cycle(&run, &unknown), Err(CycleError::NeedsPeriod { .. })));
    // A guard depends on time, the rate does not.
    let bouncing = cycle(&Simulation::new(&BouncingMass), &unknown);
    assert!(matches!(bouncing, Err(CycleError::NeedsPeriod { .. })), "{bouncing:?}");
    let wrong = of_period("block.force", 0.0);
    let Err(CycleError::BadSetting(why)) = cycle(&run, &wrong) else { panic!("refused") };
    assert!(why.contains("is in N"), "{why}");
    let still = CycleSettings { turns: vec![("block.x".to_owned(), 1.0)], ..unknown.clone() };
    assert!(matches!(cycle(&run, &still), Err(CycleError::BadSetting(_))));
    let nobody = CycleSettings { turns: vec![("block.y".to_owned(), 1.0)], ..unknown.clone() };
    assert!(matches!(cycle(&run, &nobody), Err(CycleError::UnknownState { .. })));
    let flag = AtomicBool::new(true);
    let interrupted = cycle(&run.clone().until_flagged(&flag), &of_period("block.frequency", 9.0));
    let Err(CycleError::Simulate(SimulateError::Stopped { cause, .. })) = interrupted else {
        panic!("interrupted")
    };
    assert_eq!(cause, StopCause::Interrupted);

    let pendulum = of_text(&ROTOR.replace("value = 0.8", "value = 0.0"), Keep::All);
    let run = Simulation::new(pendulum.single()).method(Method::Dop853);
    let run = run.initial_value("rotor.omega", 0.0).expect("a state");
    let at_rest = cycle(&run, &CycleSettings { settle: 10.0, ..CycleSettings::default() });
    assert!(matches!(at_rest, Err(CycleError::AtRest { .. })), "{at_rest:?}");
    // Motions that decay do not repeat, whatever the guess.
    let run = run.initial_value("rotor.phi", 0.5).expect("a state");
    for settings in [
        CycleSettings { settle: 10.0, ..CycleSettings::default() },
        CycleSettings { period: Period::Unknown(Some(3.7)), ..CycleSettings::default() },
    ] {
        assert!(cycle(&run, &settings).is_err());
    }
}

#[test]
fn a_conservative_motion_is_neutral() {
    let scene = of_text(
        &ROTOR.replace("value = 0.8", "value = 0.0").replace("value = 0.2", "value = 0.0"),
        Keep::All,
    );
    let run = Simulation::new(scene.single());
    let run = run.initial_value("rotor.omega", 0.0).expect("a state");
    let run = run.initial_value("rotor.phi", 1.0).expect("a state");
    let period = Period::Unknown(Some(3.9));
    let found = cycle(&run, &CycleSettings { period, ..CycleSettings::default() });
    let found = found.expect("a cycle");
    assert_eq!(found.stability, Stability::Neutral);
    // Period of the pendulum by the arithmetic-geometric mean.
    let swing = crest(&found, "rotor.phi");
    let (mut a, mut b) = (1.0, (swing / 2.0).cos());
    for _ in 0..6 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    near(found.period, TAU / (3.0_f64.sqrt() * a), 1e-5);
}
