//! Chains of a hundred rotors and more, whose eigenmodes follow from banded matrices.

use std::f64::consts::PI;
use std::fmt::Write as _;

use machinist::Simulation;
use machinist::field::{Discretisation, FieldSimulator};
use machinist::linear_analysis::{
    LinearError, Linearization, ModeKind, Place, Point, equilibrium, operating_point,
};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Describe as _;
use machinist_scenes::scenes::shaft_step_torque::ShaftStepTorque;
use machinist_studies::closed_form::shaft::SAW_GIN_SHAFT;
use num_complex::Complex64;

use crate::own_scene::of_text;

const ROTORS: usize = 120;
const INERTIA: f64 = 2.0;
const STIFFNESS: f64 = 5e3;
const DAMPING: f64 = 0.5;

/// Returns freely turning rotors on couplings, each a unit; a brake may act on the first.
fn rotors(brake: Option<f64>) -> String {
    let mut text = "[scene]\nname = \"rotors\"\nsource = \"Textbook.\"\n".to_owned();
    for k in 0..ROTORS {
        let _ = write!(
            text,
            "[units.r{k}]\nunit = \"rotor\"\nparameters = {{ inertia = {INERTIA} }}\n"
        );
    }
    for k in 1..ROTORS {
        let before = k - 1;
        let _ = write!(
            text,
            "[units.c{k}]\nunit = \"coupling\"\nparameters = {{ stiffness = {STIFFNESS}, \
             damping = {DAMPING} }}\n[[joints]]\nconnect = [\"r{before}.shaft\", \"c{k}.driving\"]\n\
             [[joints]]\nconnect = [\"c{k}.driven\", \"r{k}.shaft\"]\n"
        );
    }
    if let Some(brake) = brake {
        let _ = write!(
            text,
            "[[forces]]\nport = \"r0.shaft\"\nexpression = \"{brake} [N m s/rad]*(3 [rad/s] - \
             r0.omega)\"\n"
        );
    }
    let last = ROTORS - 1;
    let _ = write!(
        text,
        "[initial]\n\"r0.omega\" = 1.0\n[outputs]\nlast = \"r{last}.omega\"\n[run]\nuntil = 0.05\n"
    );
    text
}

#[test]
fn a_chain_that_turns_freely_has_the_frequencies_and_damping_of_the_closed_form() {
    for keep in [Keep::All, Keep::Needed] {
        let rotors = of_text(&rotors(None), keep);
        let run = Simulation::new(&rotors);
        // It continues to turn with its momentum: a hundred and twentieth of what one rotor had.
        let point = operating_point(&run, Place::Equilibrium).expect("it turns on");
        let speeds = &point.state[point.state.len() - ROTORS..];
        assert!(speeds.iter().all(|speed| (speed * ROTORS as f64 - 1.0).abs() < 1e-6));
        let modes = Linearization::at(&rotors, point).expect("regular").modes().expect("modes");
        let oscillations: Vec<_> =
            modes.iter().filter(|mode| mode.kind == ModeKind::Oscillation).collect();
        assert_eq!([modes.len(), oscillations.len()], [ROTORS + 1, ROTORS - 1]);
        for (k, mode) in (1..).zip(oscillations) {
            let sine = (f64::from(k) * PI / (2.0 * ROTORS as f64)).sin();
            let natural = 2.0 * (STIFFNESS / INERTIA).sqrt() * sine;
            let ratio = DAMPING / STIFFNESS * natural / 2.0;
            let expected = natural * Complex64::new(-ratio, (1.0 - ratio * ratio).sqrt());
            assert!((mode.eigenvalue() - expected).norm() < 1e-11 * natural, "{k}");
            assert!(mode.residual < 1e-13);
        }
    }
}

#[test]
fn a_chain_that_is_driven_runs_at_the_speed_of_its_drive() {
    let rotors = of_text(&rotors(Some(40.0)), Keep::Needed);
    let point = operating_point(&Simulation::new(&rotors), Place::Equilibrium).expect("driven");
    let speeds = &point.state[point.state.len() - ROTORS..];
    assert!(speeds.iter().all(|speed| (speed / 3.0 - 1.0).abs() < 1e-12));
    let modes = Linearization::at(&rotors, point).expect("regular").modes().expect("modes");
    let count = |kind| modes.iter().filter(|mode| mode.kind == kind).count();
    assert_eq!(count(ModeKind::Free), 1);
    let sum: f64 = modes
        .iter()
        .map(|mode| mode.real * if mode.kind == ModeKind::Oscillation { 2.0 } else { 1.0 })
        .sum();
    let trace = -(2.0 * (ROTORS - 1) as f64 * DAMPING + 40.0) / INERTIA;
    assert!((sum / trace - 1.0).abs() < 1e-12, "{sum} {trace}");
}

/// Returns an undamped shaft of elements of order 1, held at one end, at rest without the twist of
/// its torque.
fn shaft(elements: usize) -> (FieldSimulator<'static, f64>, Point) {
    let wanted = Discretisation { elements: Some(elements), order: Some(1) };
    let shaft = FieldSimulator::new(&ShaftStepTorque, wanted).expect("elements");
    let shape = shaft.shape();
    let parameters = (0..shape.parameters).map(|index| shaft.parameter_default(index)).collect();
    let point = Point { time: 1.0, state: vec![0.0; shape.states()], parameters };
    (shaft, point)
}

#[test]
fn a_shaft_of_more_states_than_full_matrices_take_twists_and_vibrates_as_the_closed_forms() {
    const ELEMENTS: usize = 1200;
    let (shaft, point) = shaft(ELEMENTS);
    assert_eq!(shaft.shape().states(), 2 * ELEMENTS);
    let point = equilibrium(&shaft, &point).expect("it twists");
    let end = SAW_GIN_SHAFT.static_twist(SAW_GIN_SHAFT.length, 843.72);
    let places = shaft.places(0, &point.parameters);
    for (x, angle) in places.iter().zip(shaft.values(0, &point.state)) {
        let expected = end * x / SAW_GIN_SHAFT.length;
        assert!((angle - expected).abs() < 1e-11 * end, "{x}: {angle} {expected}");
    }
    let linear = Linearization::at(&shaft, point).expect("regular");
    let modes = linear.modes().expect("modes");
    assert_eq!(modes.len(), ELEMENTS);
    // Of the shaft itself (2 k - 1) w; inertia is at the nodes, half as much at the end.
    let slowest = SAW_GIN_SHAFT.fixed_free_frequency(1);
    let nodes = 4.0 * ELEMENTS as f64 / PI * slowest;
    for (k, mode) in (1..).zip(&modes) {
        let expected = nodes * (f64::from(2 * k - 1) * PI / (4.0 * ELEMENTS as f64)).sin();
        assert_eq!((mode.kind, mode.shape.len()), (ModeKind::Oscillation, 2 * ELEMENTS));
        let off = (mode.imaginary / expected - 1.0).abs();
        // Frequencies far below the highest have the rounding error of its square.
        assert!(off < 1e-15 * (ELEMENTS * ELEMENTS) as f64, "{k}: {off:e}");
        assert!(mode.real.abs() < 1e-12 * nodes && mode.residual < 1e-13);
    }
    let too_large = |refused: Option<LinearError>, limit: usize| matches!(refused, Some(LinearError::TooLarge { most, .. }) if most == limit);
    assert!(too_large(linear.matrix().err(), 2000));
    assert!(too_large(linear.second_order().err(), 2000));
    assert!(too_large(linear.response("torque", "end_angle", &[1.0, 2.0]).err(), 2000));
    let (longer, point) = self::shaft(6000);
    assert!(too_large(Linearization::at(&longer, point).err(), 10_000));
}
