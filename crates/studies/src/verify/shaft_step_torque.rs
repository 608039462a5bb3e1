//! Checks of the uniform shaft against its closed forms, with refinement.

use machinist_scenes::scenes::shaft_step_torque::ShaftStepTorque;

use super::{Check, CheckFailure, Machine, Measured, worse};
use crate::closed_form::shaft::SAW_GIN_SHAFT;
use machinist::field::{Discretisation, FieldSimulator};
use machinist::linear_analysis::{Linearization, Point};
use machinist::{Method, Simulation};

/// Torque of the spec \[N m\].
const TORQUE: f64 = 843.72;

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "first ten frequencies, 10 elements of order 8",
        reference: "(2 k - 1) pi c/(2 l), relative",
        tolerance: 1e-10,
        reason: "the elements' own error is some 1e-13; the eigenvalues' rounding is left",
        measure: frequencies,
    },
    Check {
        name: "order of the first ten frequencies' errors, elements of order 1 to 5",
        reference: "twice the order of the elements; largest distance",
        tolerance: 0.1,
        reason: "measured between two finite refinements",
        measure: order_of_frequencies,
    },
    Check {
        name: "static twist under the end torque, every node",
        reference: "M x/(G I), relative to the end",
        tolerance: 1e-11,
        reason: "elements hold it exactly; the solution of 96 equations rounds",
        measure: static_twist,
    },
    Check {
        name: "rotation of the end after the step of torque, 32 elements of order 4",
        reference: "d'Alembert's triangle over a period, relative to its height",
        tolerance: 3e-3,
        reason: "the triangle has corners, at which the elements converge slowly",
        measure: |machine| Ok(Measured::error(step_error(machine, 32)?)),
    },
    Check {
        name: "order of that error as elements are halved",
        reference: "at least 0.8, by which it falls short",
        tolerance: 0.0,
        reason: "a corner is resolved to the length of an element",
        measure: order_of_step,
    },
];

/// Returns the scene, divided into elements.
fn cut(elements: usize, order: usize) -> Result<FieldSimulator<'static, f64>, CheckFailure> {
    let wanted = Discretisation { elements: Some(elements), order: Some(order) };
    Ok(FieldSimulator::new(&ShaftStepTorque, wanted)?)
}

fn at_rest<'a>(
    machine: &Machine,
    simulator: &'a FieldSimulator<'static, f64>,
) -> Result<Linearization<'a>, CheckFailure> {
    use machinist_contract::Describe as _;
    let state = vec![0.0; simulator.shape().states()];
    let point = Point { time: 0.0, state, parameters: machine.parameters(&[])? };
    Ok(Linearization::at(simulator.single(), point)?)
}

fn natural(machine: &Machine, elements: usize, order: usize) -> Result<Vec<f64>, CheckFailure> {
    let simulator = cut(elements, order)?;
    Ok(at_rest(machine, &simulator)?.second_order()?.undamped_frequencies()?)
}

fn frequencies(machine: &Machine) -> Result<Measured, CheckFailure> {
    let found = natural(machine, 10, 8)?;
    let errors = (1..=10).zip(&found).map(|(k, found)| {
        let exact = SAW_GIN_SHAFT.fixed_free_frequency(k);
        (found / exact - 1.0).abs()
    });
    Ok(Measured::error(errors.fold(0.0, worse)))
}

/// Computes each frequency with equally many elements per wave, and with twice as many.
fn order_of_frequencies(machine: &Machine) -> Result<Measured, CheckFailure> {
    let mut worst = 0.0;
    for (order, of_fifth) in [(1, 30), (2, 14), (3, 9), (4, 7), (5, 6)] {
        for k in 1..=10_u32 {
            let exact = SAW_GIN_SHAFT.fixed_free_frequency(k);
            let elements = (of_fifth * (2 * k as usize - 1)).div_ceil(9);
            let error = |elements| -> Result<f64, CheckFailure> {
                Ok((natural(machine, elements, order)?[k as usize - 1] / exact - 1.0).abs())
            };
            let measured = (error(elements)? / error(2 * elements)?).log2();
            worst = worse(worst, (measured - 2.0 * order as f64).abs());
        }
    }
    Ok(Measured::error(worst))
}

/// Makes one Newton step from rest, which is exact for the linear shaft.
fn static_twist(machine: &Machine) -> Result<Measured, CheckFailure> {
    use machinist_contract::{Describe as _, Simulator as _};
    let simulator = cut(24, 4)?;
    let parameters = machine.parameters(&[])?;
    let n = simulator.shape().coordinates;
    let mut rate = vec![0.0; 2 * n];
    simulator.rate(0.0, &vec![0.0; 2 * n], &parameters, &mut rate);
    let linearization = at_rest(machine, &simulator)?;
    let slopes = linearization.matrix()?.view((n, 0), (n, n)).into_owned();
    let accelerations = nalgebra::DVector::from_column_slice(&rate[n..]);
    let twist = slopes.lu().solve(&-accelerations).ok_or(CheckFailure::Singular)?;
    let mut state = twist.as_slice().to_vec();
    state.resize(2 * n, 0.0);
    let places = simulator.places(0, &parameters);
    let end = SAW_GIN_SHAFT.static_twist(SAW_GIN_SHAFT.length, TORQUE);
    let errors = places
        .iter()
        .zip(simulator.values(0, &state))
        .map(|(x, angle)| (angle - SAW_GIN_SHAFT.static_twist(*x, TORQUE)).abs() / end);
    Ok(Measured::error(errors.fold(0.0, worse)))
}

fn order_of_step(machine: &Machine) -> Result<Measured, CheckFailure> {
    const LEAST: f64 = 0.8;
    let errors = [step_error(machine, 8)?, step_error(machine, 32)?];
    let order = (errors[0] / errors[1]).log2() / 2.0;
    let error = if order.is_nan() { f64::NAN } else { (LEAST - order).max(0.0) };
    Ok(Measured { error, value: Some(order), expected: Some(LEAST) })
}

/// Returns the largest error of the end's rotation over a period, relative to its height.
fn step_error(machine: &Machine, elements: usize) -> Result<f64, CheckFailure> {
    let simulator = cut(elements, 4)?;
    let period = 4.0 * SAW_GIN_SHAFT.length / SAW_GIN_SHAFT.wave_speed();
    let run = Simulation::new(simulator.single())
        .parameters(&machine.parameters(&[])?)
        .until(period)
        .points(201)
        .rtol(1e-7)
        .method(Method::Dop853)
        .run()?;
    let angles = machine.column(&run, "end_angle")?;
    let length = SAW_GIN_SHAFT.length;
    let height = 2.0 * SAW_GIN_SHAFT.static_twist(length, TORQUE);
    let errors = run.times.iter().zip(angles).map(|(time, angle)| {
        (angle - SAW_GIN_SHAFT.step_torque(length, *time, TORQUE).angle).abs() / height
    });
    Ok(errors.fold(0.0, worse))
}
