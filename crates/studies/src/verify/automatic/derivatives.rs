//! Derivatives of the rate against extrapolated differences, and the rate in another execution of
//! the machine.

use machinist::complex_step::dense;
use machinist::linear_analysis::differences::{LARGEST, changes};
use nalgebra::DMatrix;

use super::visit::Visit;
use super::{Found, Outcome, Row};
use crate::verify::machine::Point;
use crate::verify::matrix::{Weights, distances};

const DIFFERENCES: &str = "extrapolated differences, relative to the entry (at least 1e-2 of its \
                           weighed row or column)";
const TOLERANCE: f64 = 1e-6;
/// Error of a difference, relative to its scale, up to which it counts.
const SETTLED: f64 = 1e-2 * TOLERANCE;
const SIX_DIGITS: &str = "differences are good to eight digits or more; entries that they do not \
                          settle, as beside a kink, are left out";
const IMPLICIT: &str = "Implicit methods, modes and responses rest on it: they would be slow or \
                        wrong.";

pub(super) const BY_STATE: Row = Row {
    name: "dy'/dy along the run and around it",
    reference: DIFFERENCES,
    tolerance: TOLERANCE,
    reason: SIX_DIGITS,
    matters: IMPLICIT,
    measure: by_state,
};

pub(super) const BY_PARAMETERS: Row = Row {
    name: "dy'/dp along the run and around it",
    reference: DIFFERENCES,
    tolerance: TOLERANCE,
    reason: SIX_DIGITS,
    matters: "Responses to disturbances rest on it: they would be wrong.",
    measure: by_parameters,
};

pub(super) const BY_TIME: Row = Row {
    name: "time derivative along the run and around it",
    reference: DIFFERENCES,
    tolerance: TOLERANCE,
    reason: SIX_DIGITS,
    matters: "Rosenbrock methods rest on it: they would lose their order.",
    measure: by_time,
};

pub(super) const BITS: Row = Row {
    name: "rate and Jacobian, interpreted and compiled",
    reference: "the same bits: numbers that differ",
    tolerance: 0.0,
    reason: "both do the same operations in the same order",
    matters: "One of the two computes another machine: please report it with the scene.",
    measure: bits,
};

/// Step relative to the usual first one of extrapolation, so that a phase w t does not turn within
/// a step.
const FINE: f64 = 1e-2;

/// Ratio of other steps, by which roundings differ. Where terms of a rate cancel, as those of a fast
/// gyroscope, neighbours in a table may agree by chance.
const SHORTER: f64 = 0.7;

/// Varied quantity.
#[derive(Clone, Copy)]
enum Along {
    State,
    Parameters,
    Time,
}

fn by_state(visit: &Visit<'_>) -> Outcome {
    let pattern = visit.simulator.rate_jacobian_pattern();
    let sizes = visit.sizes.clone();
    compare(visit, Along::State, &sizes, |point| {
        let mut values = vec![0.0; pattern.entries.len()];
        visit.simulator.rate_jacobian(point.time, &point.state, &point.parameters, &mut values);
        dense(pattern, &values)
    })
}

fn by_parameters(visit: &Visit<'_>) -> Outcome {
    let pattern = visit.simulator.parameter_jacobian_pattern();
    if visit.subject.simulation.parameter_values().is_empty() {
        return Outcome::Skipped("no parameter is left to change".to_owned());
    }
    let size = |value: &f64| if *value == 0.0 { 1.0 } else { value.abs() };
    let sizes: Vec<f64> = visit.subject.simulation.parameter_values().iter().map(size).collect();
    compare(visit, Along::Parameters, &sizes, |point| {
        let (time, state, parameters) = (point.time, &point.state, &point.parameters);
        let mut values = vec![0.0; pattern.entries.len()];
        visit.simulator.parameter_jacobian(time, state, parameters, &mut values);
        dense(pattern, &values)
    })
}

fn by_time(visit: &Visit<'_>) -> Outcome {
    // A load may last only a small part of the run.
    let size = 1e-2 * visit.duration();
    compare(visit, Along::Time, &[size], |point| {
        let mut values = vec![0.0; point.state.len()];
        visit.simulator.time_derivative(point.time, &point.state, &point.parameters, &mut values);
        DMatrix::from_column_slice(values.len(), 1, &values)
    })
}

/// Returns the worst entry of all points.
fn compare(
    visit: &Visit<'_>,
    along: Along,
    sizes: &[f64],
    ours: impl Fn(&Point) -> DMatrix<f64>,
) -> Outcome {
    let mut found = Found::nothing();
    let mut settled = false;
    for point in visit.points.iter().filter(|point| !visit.is_at_kink(point)) {
        let ours = ours(point);
        let Differences { values, changes, roundings } = differences(visit, point, along, sizes);
        let rate = visit.rate(point);
        let weights = Weights {
            rows: &visit.sizes,
            columns: sizes,
            is_constrained: visit.simulator.constraints() > 0,
            rate: &rate,
        };
        // Entries whose differences do not converge are taken from the checked matrix, so that they
        // set no scale.
        let exact = DMatrix::from_fn(values.nrows(), values.ncols(), |i, j| {
            if values[(i, j)].is_finite() { values[(i, j)] } else { ours[(i, j)] }
        });
        let Some(floors) = weights.floors(&exact) else {
            found.take(f64::NAN, || "Its shape is not that of the states.".to_owned());
            continue;
        };
        // Where only rounding is left of a difference, as of a rate that does not depend on time, it sets
        // the scale.
        let rounded = roundings.map(|rounding| 2.0 * rounding / SETTLED);
        let floors = floors.zip_map(&least(visit, &rate, sizes), f64::max);
        let floors = floors.zip_map(&rounded, f64::max);
        for ((i, j), distance) in distances(&ours, &exact, &floors) {
            let scale = exact[(i, j)].abs().max(floors[(i, j)]);
            let is_settled = changes[(i, j)] + roundings[(i, j)] <= SETTLED * scale;
            settled |= is_settled;
            if is_settled || (distance.is_nan() && changes[(i, j)].is_finite()) {
                found.take(distance, || {
                    let row = visit.simulator.state(i).name;
                    format!("Worst: {row}' by {} at {} s.", name(visit, along, j), point.time)
                });
            }
        }
    }
    if settled {
        Outcome::Found(found)
    } else {
        Outcome::Undone("differences settle no entry: the rate is not smooth anywhere".to_owned())
    }
}

/// Returns the size that counts as zero relative to the rates, where no entry sets a scale; this
/// times the tolerance is their rounding.
fn least(visit: &Visit<'_>, rate: &[f64], sizes: &[f64]) -> DMatrix<f64> {
    const NOTHING: f64 = 1e-9;
    let rows = &visit.sizes;
    let rates = rate.iter().zip(rows).map(|(rate, row)| (rate / row).abs());
    let of_all = rates.fold(visit.duration().recip(), f64::max);
    DMatrix::from_fn(rows.len(), sizes.len(), |i, j| NOTHING * of_all * rows[i] / sizes[j])
}

fn name<'a>(visit: &Visit<'a>, along: Along, index: usize) -> &'a str {
    match along {
        Along::State => visit.simulator.state(index).name,
        Along::Parameters => visit.simulator.parameter(index).name,
        Along::Time => "t",
    }
}

/// Differences, column by column, with the change by the last extrapolation, infinite where a
/// switching surface is too near, and their rounding.
struct Differences {
    values: DMatrix<f64>,
    changes: DMatrix<f64>,
    roundings: DMatrix<f64>,
}

fn differences(visit: &Visit<'_>, point: &Point, along: Along, sizes: &[f64]) -> Differences {
    /// Roundings of the rate in the difference over the largest step.
    const ROUNDINGS: f64 = 8.0;
    let states = point.state.len();
    let terms = terms(visit, point);
    let mut found = Differences {
        values: DMatrix::zeros(states, sizes.len()),
        changes: DMatrix::zeros(states, sizes.len()),
        roundings: DMatrix::zeros(states, sizes.len()),
    };
    for (column, size) in sizes.iter().enumerate() {
        // A mode is a whole number; derivatives by it are not needed.
        let is_mode = matches!(along, Along::State) && visit.simulator.is_mode(column);
        let size = away_from_kinks(visit, point, (along, column), *size);
        let Some(size) = size.filter(|_| !is_mode) else {
            found.changes.column_mut(column).fill(f64::INFINITY);
            continue;
        };
        let size = FINE * size;
        let at = |step: f64| visit.rate(&shifted(point, along, column, step));
        let [whole, shorter] = [1.0, SHORTER].map(|part| changes(part * size, states, at));
        for (row, ((value, change), (other, _))) in whole.into_iter().zip(shorter).enumerate() {
            found.values[(row, column)] = value;
            let change = change.max((value - other).abs());
            let rounding = ROUNDINGS * f64::EPSILON * terms[row] / (LARGEST * size);
            let is_known = value.is_finite() && rounding.is_finite();
            found.roundings[(row, column)] = if is_known { rounding } else { 0.0 };
            found.changes[(row, column)] = if is_known { change } else { f64::INFINITY };
        }
    }
    found
}

/// Returns the sizes of the terms of each rate, sum_j |dy_i'/dy_j y_j|. Where they cancel, as in a
/// shaft that turns without twist, their rounding is far above that of the rate.
fn terms(visit: &Visit<'_>, point: &Point) -> Vec<f64> {
    let entries = visit.simulator.rate_jacobian_pattern().entries;
    let mut values = vec![0.0; entries.len()];
    visit.simulator.rate_jacobian(point.time, &point.state, &point.parameters, &mut values);
    let mut terms = vec![0.0; point.state.len()];
    for ((row, column), value) in entries.iter().zip(values) {
        terms[*row as usize] += (value * point.state[*column as usize]).abs();
    }
    // A NaN of the checked matrix is reported where it is, and hides nothing here.
    let largest = |(term, rate): (f64, f64)| rate.abs().max(term);
    terms.into_iter().zip(visit.rate(point)).map(largest).collect()
}

fn shifted(point: &Point, along: Along, column: usize, step: f64) -> Point {
    let mut point = point.clone();
    match along {
        Along::State => point.state[column] += step,
        Along::Parameters => point.parameters[column] += step,
        Along::Time => point.time += step,
    }
    point
}

/// Returns a size, at most the given one, for which the largest step crosses no switching surface
/// and no time at which the rate is known to change.
fn away_from_kinks(
    visit: &Visit<'_>,
    point: &Point,
    (along, column): (Along, usize),
    mut size: f64,
) -> Option<f64> {
    const HALVINGS: usize = 12;
    let here = visit.branches(point);
    for _ in 0..HALVINGS {
        let step = FINE * LARGEST * size;
        let mut ends = [-step, step].map(|step| shifted(point, along, column, step)).into_iter();
        if ends.all(|end| visit.branches(&end) == here) {
            return Some(size);
        }
        size *= 0.5;
    }
    None
}

/// Counts the numbers of rate and Jacobian that differ.
fn bits(visit: &Visit<'_>) -> Outcome {
    let twin = match visit.subject.twin {
        Ok(twin) => twin,
        Err(why) => return Outcome::Skipped(why.to_owned()),
    };
    let simulator = visit.simulator;
    let entries = simulator.rate_jacobian_pattern().entries.len();
    let mut found = Found::nothing();
    for point in &visit.points {
        let (time, state, parameters) = (point.time, &point.state, &point.parameters);
        let (mut ours, mut theirs) = (vec![0.0; entries], vec![0.0; entries]);
        simulator.rate_jacobian(time, state, parameters, &mut ours);
        twin.rate_jacobian(time, state, parameters, &mut theirs);
        ours.extend(visit.rate(point));
        let mut rate = vec![0.0; state.len()];
        twin.rate(time, state, parameters, &mut rate);
        theirs.extend(rate);
        let differ = ours.iter().zip(&theirs).filter(|(a, b)| a.to_bits() != b.to_bits()).count();
        found.take(differ as f64, || format!("Worst at {time} s."));
    }
    Outcome::Found(found)
}
