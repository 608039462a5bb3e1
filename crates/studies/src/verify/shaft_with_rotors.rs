//! Checks of the shaft between two rotors: frequencies, free and rotor-ended, and decay.

use machinist_contract::Describe as _;
use machinist_scenes::scenes::shaft_with_rotors::ShaftWithRotors;

use super::{Check, CheckFailure, Machine, Measured, worse};
use crate::closed_form::shaft::{SAW_GIN_SHAFT, kelvin_voigt_decay, kelvin_voigt_ratio};
use machinist::field::{Discretisation, FieldSimulator};
use machinist::linear_analysis::{Linearization, ModeKind, Point};
use machinist::{Method, Simulation};

/// Moments of inertia of the rotors: none, or those of the spec \[kg m^2\].
const RIGID: [f64; 2] = [4.2, 1.244];
/// Damping time of the spec \[s\].
const DAMPING_TIME: f64 = 1e-5;
/// Twist of the spec \[rad\].
const TWIST: f64 = 0.01;

const ROUNDING: &str = "the elements' own error is some 1e-13; the eigenvalues' rounding is left";

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "first ten frequencies without rotors, 10 elements of order 8",
        reference: "k pi c/l, relative",
        tolerance: 1e-10,
        reason: ROUNDING,
        measure: |machine| frequencies(machine, [0.0; 2], |k| SAW_GIN_SHAFT.free_free_frequency(k)),
    },
    Check {
        name: "first ten frequencies with rotors, 10 elements of order 8",
        reference: "the transcendental equation of both rotors, relative",
        tolerance: 1e-10,
        reason: ROUNDING,
        measure: |machine| {
            frequencies(machine, RIGID, |k| SAW_GIN_SHAFT.rotor_ended_frequency(k, RIGID))
        },
    },
    Check {
        name: "order of the fifth frequency's error with rotors, elements of order 1 to 5",
        reference: "twice the order of the elements; largest distance",
        tolerance: 0.15,
        reason: "measured between two finite refinements",
        measure: order_of_frequencies,
    },
    Check {
        name: "damping ratios of five motions without rotors, 5 elements of order 8",
        reference: "damping time times frequency over 2, relative",
        tolerance: 1e-9,
        reason: "small ratios are differences of the eigenvalues' parts",
        measure: damping,
    },
    Check {
        name: "decay of the first mode without rotors, let go twisted",
        reference: "Kelvin-Voigt decay of that mode over the run, relative to the twist",
        tolerance: 1e-7,
        reason: "a hundred times the tolerance of a step",
        measure: decay,
    },
];

fn cut(elements: usize, order: usize) -> Result<FieldSimulator<'static, f64>, CheckFailure> {
    let wanted = Discretisation { elements: Some(elements), order: Some(order) };
    Ok(FieldSimulator::new(&ShaftWithRotors, wanted)?)
}

fn parameters(machine: &Machine, rotors: [f64; 2]) -> Result<Vec<f64>, CheckFailure> {
    machine.parameters(&[("driving.inertia", rotors[0]), ("driven.inertia", rotors[1])])
}

/// Returns the scene linearized at rest.
fn at_rest<'a>(
    machine: &Machine,
    simulator: &'a FieldSimulator<'static, f64>,
    rotors: [f64; 2],
) -> Result<Linearization<'a>, CheckFailure> {
    let state = vec![0.0; simulator.shape().states()];
    let point = Point { time: 0.0, state, parameters: parameters(machine, rotors)? };
    Ok(Linearization::at(simulator.single(), point)?)
}

/// Returns natural frequencies without damping, except the free rotation.
fn natural(
    machine: &Machine,
    [elements, order]: [usize; 2],
    rotors: [f64; 2],
) -> Result<Vec<f64>, CheckFailure> {
    let simulator = cut(elements, order)?;
    let mut natural =
        at_rest(machine, &simulator, rotors)?.second_order()?.undamped_frequencies()?;
    natural.remove(0);
    Ok(natural)
}

fn frequencies(
    machine: &Machine,
    rotors: [f64; 2],
    exact: fn(u32) -> f64,
) -> Result<Measured, CheckFailure> {
    let found = natural(machine, [10, 8], rotors)?;
    let errors = (1..=10).zip(&found).map(|(k, found)| (found / exact(k) - 1.0).abs());
    Ok(Measured::error(errors.fold(0.0, worse)))
}

fn order_of_frequencies(machine: &Machine) -> Result<Measured, CheckFailure> {
    let exact = SAW_GIN_SHAFT.rotor_ended_frequency(5, RIGID);
    let mut worst = 0.0;
    for (order, elements) in [(1, 40), (2, 20), (3, 12), (4, 8), (5, 6)] {
        let error = |elements| -> Result<f64, CheckFailure> {
            Ok((natural(machine, [elements, order], RIGID)?[4] / exact - 1.0).abs())
        };
        let measured = (error(elements)? / error(2 * elements)?).log2();
        worst = worse(worst, (measured - 2.0 * order as f64).abs());
    }
    Ok(Measured::error(worst))
}

fn damping(machine: &Machine) -> Result<Measured, CheckFailure> {
    let simulator = cut(5, 8)?;
    let modes = at_rest(machine, &simulator, [0.0; 2])?.modes()?;
    let found = modes.iter().filter(|mode| mode.kind == ModeKind::Oscillation);
    let errors = (1..=5).zip(found).map(|(k, mode)| {
        let exact = kelvin_voigt_ratio(SAW_GIN_SHAFT.free_free_frequency(k), DAMPING_TIME);
        (mode.damping_ratio() / exact - 1.0).abs()
    });
    Ok(Measured::error(errors.fold(0.0, worse)))
}

fn decay(machine: &Machine) -> Result<Measured, CheckFailure> {
    let simulator = cut(5, 8)?;
    let run = Simulation::new(simulator.single())
        .parameters(&parameters(machine, [0.0; 2])?)
        .rtol(1e-9)
        .method(Method::Radau)
        .run()?;
    let frequency = SAW_GIN_SHAFT.free_free_frequency(1);
    let angles = machine.column(&run, "start_angle")?;
    let errors = run.times.iter().zip(angles).map(|(time, angle)| {
        (angle / TWIST - kelvin_voigt_decay(*time, frequency, DAMPING_TIME)).abs()
    });
    Ok(Measured::error(errors.fold(0.0, worse)))
}
