//! Checks that every scene goes through: emitted derivatives against the complex
//! step, and the energy account of its run.

use machinist_contract::Real;
use nalgebra::{DMatrix, DVector};

use super::machine::Point;
use super::{Check, CheckFailure, Machine, Measured, worse};
use machinist::complex_step::{self, ComplexStep};

/// See [`matrix_error`].
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

/// Rows and columns of a matrix with constraints that are smaller than this, beside its
/// largest entry, are rounding.
const NOTHING: f64 = 1e-12;
/// Entries of such a matrix that are smaller than this, likewise, are held to it.
const LEAST: f64 = 1e-3;
const POINTS: usize = 20;

fn rate_jacobian(machine: &Machine) -> Result<Measured, CheckFailure> {
    let sizes = state_sizes(machine);
    over_points(machine, |p| {
        let exact = complex_step::rate_jacobian(machine.complex, p.time, &p.state, &p.parameters);
        matrix_error((machine, p), &machine.rate_jacobian(p), &exact, (&sizes, &sizes))
    })
}

fn parameter_jacobian(machine: &Machine) -> Result<Measured, CheckFailure> {
    let states = state_sizes(machine);
    let size = |value: &f64| if *value == 0.0 { 1.0 } else { value.abs() };
    over_points(machine, |p| {
        let exact =
            complex_step::parameter_jacobian(machine.complex, p.time, &p.state, &p.parameters);
        let sizes: Vec<f64> = p.parameters.iter().map(size).collect();
        matrix_error((machine, p), &machine.parameter_jacobian(p), &exact, (&states, &sizes))
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
        matrix_error((machine, p), &ours, &exact, (&states, &[1.0]))
    })
}

fn state_sizes(machine: &Machine) -> Vec<f64> {
    (0..machine.real.shape().states()).map(|index| machine.real.state_scale(index)).collect()
}

/// The worst of a measure over the random points.
fn over_points(
    machine: &Machine,
    measure: impl Fn(&Point) -> f64,
) -> Result<Measured, CheckFailure> {
    let points = machine.random_points(POINTS)?;
    Ok(Measured::error(points.iter().map(measure).fold(0.0, worse)))
}

/// max over i, j of |A_ij - B_ij|/max(|B_ij|, 1e-2 F_ij), where F_ij is the largest of
/// B's row i and column j, weighed by the sizes r of the rows and s of the columns:
/// |B_ik| s_k/s_j and |B_kj| r_i/r_k.
///
/// 1e-12 of the floor is a hundred roundings of the largest that enters where a full mass
/// matrix is solved: by the rotor's angle a motor's rotor currents change by 1e6, and
/// the stator's, solved along with them, by some tens that such numbers leave. An entry
/// outside a pattern is zero in A.
///
/// Constraints solve all coordinates together: what one row needs, others leave their
/// rounding in. The floor is at least [`LEAST`] of the largest of all of B, or of the rates
/// by their sizes if these are larger; and all of that where nothing but rounding is in a
/// row or column, as in those of the masses of a machine that is driven.
fn matrix_error(
    (machine, p): (&Machine, &Point),
    ours: &DMatrix<f64>,
    exact: &DMatrix<f64>,
    (rows, columns): (&[f64], &[f64]),
) -> f64 {
    if ours.shape() != exact.shape() || (rows.len(), columns.len()) != exact.shape() {
        return f64::NAN;
    }
    let weighed = DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
        exact[(i, j)].abs() * columns[j] / rows[i]
    });
    let largest = |values: &mut dyn Iterator<Item = &f64>| values.copied().fold(0.0, worse);
    let by_row: Vec<f64> = weighed.row_iter().map(|row| largest(&mut row.iter())).collect();
    let by_column: Vec<f64> =
        weighed.column_iter().map(|column| largest(&mut column.iter())).collect();
    let is_constrained = machine.real.constraints() > 0;
    let rates = machine.rate(p).into_iter().zip(rows).map(|(rate, row)| (rate / row).abs());
    let of_all = rates.chain(by_row.iter().copied()).fold(0.0, worse);
    let mut error = 0.0;
    for (i, row) in rows.iter().enumerate() {
        for (j, column) in columns.iter().enumerate() {
            let (a, b) = (ours[(i, j)], exact[(i, j)]);
            let is_nothing = by_row[i].min(by_column[j]) <= NOTHING * of_all;
            let size = if is_constrained && is_nothing {
                of_all
            } else if is_constrained {
                worse(1e-2 * worse(by_row[i], by_column[j]), LEAST * of_all)
            } else {
                1e-2 * worse(by_row[i], by_column[j])
            };
            let floor = size * row / column;
            // Both zero, as where a load is saturated, is no error over no scale.
            let distance = (a - b).abs();
            error = worse(error, if distance == 0.0 { 0.0 } else { distance / b.abs().max(floor) });
        }
    }
    error
}

/// The residual, relative to the sum of |dE/dy_i y_i'|, |dE/dt| at rest, |supplied| and
/// |lost|; and the emitted dE/dt against the sum with signs, derivatives of E by the
/// complex step.
fn power_balance(machine: &Machine) -> Result<Measured, CheckFailure> {
    over_points(machine, |p| {
        let power = machine.real.power_balance(p.time, &p.state, &p.parameters);
        let rate = machine.rate(p);
        let gradient = energy_gradient(machine, p).into_iter();
        let terms =
            gradient.zip(&rate).map(|(de, rate)| de * rate).chain([energy_by_time(machine, p)]);
        let (sum, size) = terms
            .fold((0.0, 0.0), |(sum, size): (f64, f64), term: f64| (sum + term, size + term.abs()));
        let size = size + power.supplied.abs() + power.dissipated.abs();
        // Constraints may leave nothing that moves and stores energy.
        let stored = machine.real.energy(p.time, &p.state, &p.parameters);
        let least = if machine.real.constraints() > 0 { stored.kinetic } else { 0.0 };
        let size = size.max(least);
        let error = worse(power.residual().abs(), (power.stored_rate - sum).abs());
        if error == 0.0 { 0.0 } else { error / size }
    })
}

/// dE/dt with the state held: a spring whose foot is moved by something.
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

/// Largest residual of the account over the scene's own run, divided by the
/// integral of |supplied| + |lost| power, or where none of either flows by the largest
/// energy in motion.
fn energy_account(machine: &Machine) -> Result<Measured, CheckFailure> {
    let trajectory = machine.simulation(&[])?.rtol(1e-11).with_energy_balance(true).run()?;
    let error = trajectory.energy_balance.as_ref().map_or(f64::NAN, |balance| {
        let largest = balance.residual.iter().fold(0.0, |most, r| worse(most, r.abs()));
        let passed = balance.passed.last().copied().unwrap_or(0.0);
        let flows = passed > 1e-12 * balance.largest_active;
        let scale = if flows { passed } else { balance.largest_active };
        if scale > 0.0 { largest / scale } else { f64::NAN }
    });
    Ok(Measured::error(error))
}
