//! Sensitivities of runs: against derivatives of closed forms, runs in numbers that carry
//! derivatives, and differences of runs.

use machinist_contract::Real;

use super::{CheckFailure, Machine, Measured, worse};
use crate::closed_form::Number;
use machinist::complex_step::ComplexStep;
use machinist::{Method, Trajectory};

/// Justification of tolerances for smooth machines.
pub(super) const SMOOTH: &str = "the run and its derivatives are held to 1e-12 a step";
/// Justification of tolerances across events.
pub(super) const ACROSS: &str = "likewise, and events move with the parameters";

impl Number for ComplexStep {
    fn literal(value: f64) -> Self {
        <Self as Real>::literal(value)
    }
    fn value(self) -> f64 {
        self.0.re
    }
    fn sqrt(self) -> Self {
        Real::sqrt(self)
    }
    fn exp(self) -> Self {
        Real::exp(self)
    }
    fn sin_cos(self) -> (Self, Self) {
        (Real::sin(self), Real::cos(self))
    }
    fn asin(self) -> Self {
        Real::asin(self)
    }
    fn atan(self) -> Self {
        Real::atan(self)
    }
}

/// Quantities of a closed form: states or outputs, and parameters with their published values.
pub(super) struct ClosedForm<'c, const C: usize, const P: usize> {
    pub(super) settings: &'c [(&'c str, f64)],
    pub(super) columns: [&'c str; C],
    pub(super) by: [(&'c str, f64); P],
    pub(super) until: f64,
    pub(super) points: usize,
}

/// Returns the largest error of d(column)/d(parameter) over a run, relative to the largest size of
/// each. `exact` returns the exact columns at a time as a function of the parameters.
pub(super) fn of_closed_form<const C: usize, const P: usize>(
    machine: &Machine,
    form: &ClosedForm<'_, C, P>,
    exact: impl Fn(f64, [ComplexStep; P]) -> [ComplexStep; C],
) -> Result<Measured, CheckFailure> {
    let run = machine.simulation(form.settings)?.until(form.until).points(form.points);
    let run = run.rtol(1e-12).method(Method::Dop853);
    let run = run.sensitivities(&form.by.map(|(name, _)| name))?.run()?;
    let mut error = 0.0;
    for (direction, (name, _)) in form.by.iter().enumerate() {
        let mut at = form.by.map(|(_, value)| <ComplexStep as Real>::literal(value));
        at[direction] = ComplexStep::perturbed(form.by[direction].1);
        let rows: Vec<[f64; C]> =
            run.times.iter().map(|time| exact(*time, at).map(ComplexStep::derivative)).collect();
        for (column, of) in form.columns.iter().enumerate() {
            let wanted: Vec<f64> = rows.iter().map(|row| row[column]).collect();
            error = worse(error, off(sensitivity(machine, &run, of, name)?, &wanted));
        }
    }
    Ok(Measured::error(error))
}

/// Returns the largest difference over the largest size.
fn off(ours: &[f64], wanted: &[f64]) -> f64 {
    super::relative_distance(ours, wanted)
}

fn sensitivity<'t>(
    machine: &Machine,
    run: &'t Trajectory,
    of: &str,
    by: &str,
) -> Result<&'t [f64], CheckFailure> {
    let missing = || CheckFailure::UnknownQuantity {
        scene: machine.name(),
        kind: "column",
        name: format!("d({of})/d({by})"),
    };
    run.sensitivity(of, by).ok_or_else(missing)
}

/// Compares sensitivities at a few times of a smooth machine's run with runs on numbers that carry
/// a derivative, one for each parameter, by independent extrapolated midpoint steps.
pub(super) fn against_complex_runs(
    machine: &Machine,
    by: &[&str],
    until: f64,
) -> Result<Measured, CheckFailure> {
    const ROWS: usize = 8;
    /// Number of steps between two rows.
    const STEPS: usize = 64;
    let times: Vec<f64> = (0..=ROWS).map(|k| until * k as f64 / ROWS as f64).collect();
    let run = machine.simulation(&[])?.until(until).times(&times).rtol(1e-12);
    let run = run.method(Method::Dop853).sensitivities(by)?.run()?;
    let shape = machine.real.shape();
    let parameters = machine.parameters(&[])?;
    let mut error = 0.0;
    for name in by {
        let place = machine.parameter_index(name)?;
        let mut carried: Vec<ComplexStep> =
            parameters.iter().map(|value| <ComplexStep as Real>::literal(*value)).collect();
        carried[place] = ComplexStep::perturbed(parameters[place]);
        let rows = carried_run(machine, &carried, &times, STEPS);
        for index in 0..shape.states() + shape.outputs {
            let of = match index.checked_sub(shape.states()) {
                None => machine.real.state(index).name,
                Some(output) => machine.real.output(output).name,
            };
            // The start is left out: an amplitude of currents that are all zero has no derivative.
            let values: Vec<f64> = rows.iter().skip(1).map(|row| row[index].0.re).collect();
            let wanted: Vec<f64> = rows.iter().skip(1).map(|row| row[index].derivative()).collect();
            if matters(&values, &wanted, parameters[place]) {
                error = worse(error, off(&sensitivity(machine, &run, of, name)?[1..], &wanted));
            }
        }
    }
    Ok(Measured::error(error))
}

/// Returns whether a derivative is more than rounding of its column.
fn matters(values: &[f64], slopes: &[f64], parameter: f64) -> bool {
    const LEAST: f64 = 1e-6;
    let size = |all: &[f64]| all.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let is_lost = slopes.iter().any(|slope| slope.is_nan());
    is_lost
        || size(slopes) * parameter.abs().max(1e-3) > LEAST * size(values) && size(values) > 1e-9
}

/// Returns states and outputs at some times, by extrapolated steps of Gragg's rule (R. Bulirsch, J.
/// Stoer, 1966).
fn carried_run(
    machine: &Machine,
    parameters: &[ComplexStep],
    times: &[f64],
    steps: usize,
) -> Vec<Vec<ComplexStep>> {
    let shape = machine.real.shape();
    let zero = <ComplexStep as Real>::literal(0.0);
    let mut state = vec![zero; shape.states()];
    machine.complex.initial_state(parameters, &mut state);
    let mut rows = Vec::with_capacity(times.len());
    for (row, time) in times.iter().enumerate() {
        if row > 0 {
            let (from, step) = (times[row - 1], (time - times[row - 1]) / steps as f64);
            for k in 0..steps {
                state = extrapolated(machine, parameters, from + step * k as f64, (&state, step));
            }
        }
        let mut outputs = vec![zero; shape.outputs];
        let now = <ComplexStep as Real>::literal(*time);
        machine.complex.outputs(now, &state, parameters, &mut outputs);
        rows.push(state.iter().copied().chain(outputs).collect());
    }
    rows
}

/// Makes one step of order 14, from 2, 4, .. 14 midpoint steps.
fn extrapolated(
    machine: &Machine,
    parameters: &[ComplexStep],
    time: f64,
    (state, step): (&[ComplexStep], f64),
) -> Vec<ComplexStep> {
    const ORDERS: usize = 7;
    let mut table: Vec<Vec<ComplexStep>> = Vec::new();
    for k in 0..ORDERS {
        let mut best = gragg(machine, parameters, time, (state, step), 2 * (k + 1));
        let mut previous = std::mem::take(&mut table).into_iter();
        let mut row = Vec::new();
        for j in 1..=k {
            let ratio = (k + 1) as f64 / (k + 1 - j) as f64;
            let share = <ComplexStep as Real>::literal(1.0 / (ratio * ratio - 1.0));
            let Some(before) = previous.next() else { break };
            let next = best.iter().zip(&before).map(|(a, b)| *a + (*a - *b) * share).collect();
            row.push(std::mem::replace(&mut best, next));
        }
        row.push(best);
        table = row;
    }
    table.pop().unwrap_or_default()
}

/// Makes steps by the modified midpoint rule.
fn gragg(
    machine: &Machine,
    parameters: &[ComplexStep],
    time: f64,
    (state, step): (&[ComplexStep], f64),
    count: usize,
) -> Vec<ComplexStep> {
    let h = step / count as f64;
    let literal = |value: f64| <ComplexStep as Real>::literal(value);
    let rate = |k: usize, y: &[ComplexStep]| {
        let mut rate = vec![literal(0.0); y.len()];
        machine.complex.rate(literal(time + h * k as f64), y, parameters, &mut rate);
        rate
    };
    let plus = |y: &[ComplexStep], rate: &[ComplexStep], h: f64| -> Vec<ComplexStep> {
        y.iter().zip(rate).map(|(y, rate)| *y + *rate * literal(h)).collect()
    };
    let mut last = state.to_vec();
    let mut now = plus(state, &rate(0, state), h);
    for k in 1..count {
        let next = plus(&last, &rate(k, &now), 2.0 * h);
        last = std::mem::replace(&mut now, next);
    }
    let ahead = plus(&last, &rate(count, &now), h);
    now.iter().zip(&ahead).map(|(a, b)| (*a + *b) * literal(0.5)).collect()
}

/// Compares sensitivities over a run with central differences of sixth order, of runs between the
/// same events. Parameters are varied by a share of their size.
pub(super) fn against_differences(
    machine: &Machine,
    by: &[&str],
    (until, points): (f64, usize),
    share: f64,
) -> Result<Measured, CheckFailure> {
    let base = machine.simulation(&[])?.until(until).points(points);
    let base = base.rtol(1e-12).method(Method::Dop853);
    let run = base.clone().sensitivities(by)?.run()?;
    let shape = machine.real.shape();
    let mut error = 0.0;
    for name in by {
        let value = machine.value(name)?;
        let step = share * if value == 0.0 { 1.0 } else { value.abs() };
        let at = |times: f64| base.clone().parameter(name, value + times * step)?.run();
        let weights = [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)];
        let mut near = Vec::new();
        for (times, weight) in weights {
            near.push((at(times)?, at(-times)?, weight / (60.0 * step)));
        }
        for index in 0..shape.states() + shape.outputs {
            let column = &run.columns[index];
            let difference = |row: usize| {
                let terms = near.iter().map(|(above, below, weight)| {
                    weight * (above.columns[index].values[row] - below.columns[index].values[row])
                });
                terms.sum::<f64>()
            };
            let wanted: Vec<f64> = (0..run.times.len()).map(difference).collect();
            if matters(&column.values, &wanted, value) {
                let ours = sensitivity(machine, &run, &column.name, name)?;
                error = worse(error, off(ours, &wanted));
            }
        }
    }
    Ok(Measured::error(error))
}
