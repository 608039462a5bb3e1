//! Checks of every scene: emitted derivatives against the complex step, and the energy balance of
//! its run.

use machinist_contract::Real;
use nalgebra::{DMatrix, DVector};

use super::machine::Point;
use super::matrix::{Weights, matrix_error};
use super::power::{account_error, relative, residual};
use super::{Check, CheckFailure, Machine, Measured, worse};
use machinist::complex_step::{self, ComplexStep};

/// See [`Weights::floors`].
const ENTRY: &str =
    "complex step, relative to the entry (at least 1e-2 of its weighed row or column)";
const BOTH_ROUND: &str =
    "the complex step has no truncation error; rounding is left, more where terms cancel";

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "Jacobian of the rate at 20 random states",
        reference: ENTRY,
        tolerance: 1e-12,
        reason: BOTH_ROUND,
        measure: rate_jacobian,
    },
    Check {
        name: "Jacobian by parameters at 20 random states",
        reference: ENTRY,
        tolerance: 1e-12,
        reason: BOTH_ROUND,
        measure: parameter_jacobian,
    },
    Check {
        name: "time derivative at 20 random states",
        reference: ENTRY,
        tolerance: 1e-12,
        reason: BOTH_ROUND,
        measure: time_derivative,
    },
    Check {
        name: "power balance at 20 random states",
        reference: "dE/dt = supplied - lost, relative to the sizes of its terms",
        tolerance: 1e-13,
        reason: "an identity; only rounding of some hundred operations is left",
        measure: power_balance,
    },
    Check {
        name: "energy account of the run at rtol 1e-11",
        reference: "energy stored, supplied and lost, relative to the energy passed, if any, or in motion",
        tolerance: 1e-8,
        reason: "a thousand times the tolerance of a step, which errors of many steps stay below",
        measure: energy_account,
    },
];

const POINTS: usize = 20;

fn rate_jacobian(machine: &Machine) -> Result<Measured, CheckFailure> {
    let sizes = state_sizes(machine);
    over_points(machine, |p| {
        let exact = complex_step::rate_jacobian(machine.complex, p.time, &p.state, &p.parameters);
        weighed_error(machine, p, (&machine.rate_jacobian(p), &exact), (&sizes, &sizes))
    })
}

fn parameter_jacobian(machine: &Machine) -> Result<Measured, CheckFailure> {
    let states = state_sizes(machine);
    let size = |value: &f64| if *value == 0.0 { 1.0 } else { value.abs() };
    over_points(machine, |p| {
        let exact =
            complex_step::parameter_jacobian(machine.complex, p.time, &p.state, &p.parameters);
        let sizes: Vec<f64> = p.parameters.iter().map(size).collect();
        weighed_error(machine, p, (&machine.parameter_jacobian(p), &exact), (&states, &sizes))
    })
}

fn time_derivative(machine: &Machine) -> Result<Measured, CheckFailure> {
    let states = state_sizes(machine);
    over_points(machine, |p| {
        let mut ours = vec![0.0; p.state.len()];
        machine.real.time_derivative(p.time, &p.state, &p.parameters, &mut ours);
        let ours = DMatrix::from_column_slice(ours.len(), 1, &ours);
        let exact: DVector<f64> =
            complex_step::time_derivative(machine.complex, p.time, &p.state, &p.parameters);
        let exact = DMatrix::from_column_slice(exact.len(), 1, exact.as_slice());
        weighed_error(machine, p, (&ours, &exact), (&states, &[1.0]))
    })
}

fn state_sizes(machine: &Machine) -> Vec<f64> {
    (0..machine.real.shape().states()).map(|index| machine.real.state_scale(index)).collect()
}

/// Returns the worst value of a measure over the random points.
fn over_points(
    machine: &Machine,
    measure: impl Fn(&Point) -> f64,
) -> Result<Measured, CheckFailure> {
    let points = machine.random_points(POINTS)?;
    Ok(Measured::error(points.iter().map(measure).fold(0.0, worse)))
}

fn weighed_error(
    machine: &Machine,
    p: &Point,
    (ours, exact): (&DMatrix<f64>, &DMatrix<f64>),
    (rows, columns): (&[f64], &[f64]),
) -> f64 {
    let is_constrained = machine.real.constraints() > 0;
    let weights = Weights { rows, columns, is_constrained, rate: &machine.rate(p) };
    matrix_error(ours, exact, &weights)
}

/// Compares the residual with the sum of |dE/dy_i y_i'|, |dE/dt| at rest, |supplied| and |lost|;
/// and the emitted dE/dt with the signed sum, with derivatives of E by the complex step.
fn power_balance(machine: &Machine) -> Result<Measured, CheckFailure> {
    over_points(machine, |p| {
        let power = machine.real.power_balance(p.time, &p.state, &p.parameters);
        let rate = machine.rate(p);
        let gradient = energy_gradient(machine, p).into_iter();
        let terms =
            gradient.zip(&rate).map(|(de, rate)| de * rate).chain([energy_by_time(machine, p)]);
        let (sum, size) = terms
            .fold((0.0, 0.0), |(sum, size): (f64, f64), term: f64| (sum + term, size + term.abs()));
        let chain = relative(machine.real, p, (power.stored_rate - sum).abs(), size);
        worse(residual(machine.real, p, size), chain)
    })
}

/// Returns dE/dt with the state held, as for a spring with a moving foot.
fn energy_by_time(machine: &Machine, p: &Point) -> f64 {
    let lift = |values: &[f64]| values.iter().copied().map(ComplexStep::literal).collect();
    let (state, parameters): (Vec<ComplexStep>, Vec<ComplexStep>) =
        (lift(&p.state), lift(&p.parameters));
    let time = ComplexStep::perturbed(p.time);
    machine.complex.energy(time, &state, &parameters).total().derivative()
}

fn energy_gradient(machine: &Machine, p: &Point) -> Vec<f64> {
    let lift = |values: &[f64]| values.iter().copied().map(ComplexStep::literal).collect();
    let parameters: Vec<ComplexStep> = lift(&p.parameters);
    let mut state: Vec<ComplexStep> = lift(&p.state);
    let time = ComplexStep::literal(p.time);
    let mut gradient = Vec::with_capacity(state.len());
    for (index, value) in p.state.iter().enumerate() {
        state[index] = ComplexStep::perturbed(*value);
        gradient.push(machine.complex.energy(time, &state, &parameters).total().derivative());
        state[index] = ComplexStep::literal(*value);
    }
    gradient
}

/// Checks the energy balance of the scene's own run.
fn energy_account(machine: &Machine) -> Result<Measured, CheckFailure> {
    let trajectory = machine.simulation(&[])?.rtol(1e-11).with_energy_balance(true).run()?;
    let error =
        trajectory.energy_balance.as_ref().map_or(f64::NAN, |balance| account_error(balance, 0.0));
    Ok(Measured::error(error))
}
