//! Runs in numbers of 31 digits by emitted Taylor series, more precise than any method.

use machinist_contract::Real;
use machinist_contract::taylor::TaylorSeries;

use super::worse;
use crate::double_double::{DoubleDouble, Twin};
use machinist::trajectory::{ColumnKind, Trajectory};
use machinist_contract::taylor::value;

/// Order of the series and size of their remainder, relative to the largest value of each state.
const RUNS: [(usize, f64); 2] = [(48, 1e-26), (40, 1e-23)];
/// Maximum number of steps; a machine that needs more is so stiff that other references are better.
const MAX_STEPS: usize = 4_000;
/// Number of last terms that determine the length of a step; some vanish by symmetry.
const JUDGED: usize = 6;
/// Largest ratio of a step to the previous one.
const GROWTH: f64 = 4.0;

/// States over time, with the difference between two runs.
pub(super) struct Precise {
    /// Values by state, then by time.
    pub(super) states: Vec<Vec<f64>>,
    /// max over states of max over time |a - b|/max over time |a|.
    pub(super) agreement: f64,
}

/// Returns the series of a machine, unless it has corners, constraints or events.
pub(super) fn series(machine: &dyn Twin) -> Option<&dyn TaylorSeries<DoubleDouble>> {
    let is_free = machine.events() == 0 && machine.constraints() == 0;
    machine.taylor().filter(|series| is_free && !series.has_corners())
}

/// Computes the run of `pilot` with its parameters, from the same start at the same times; `None` if steps are too
/// short.
pub(super) fn solve(
    machine: &dyn Twin,
    series: &dyn TaylorSeries<DoubleDouble>,
    parameters: &[f64],
    pilot: &Trajectory,
) -> Option<Precise> {
    let run = Run::new(machine, series, parameters, pilot);
    let [ours, other] = RUNS.map(|(order, rtol)| run.states(order, rtol));
    let (ours, other) = (ours?, other?);
    let distance = |index: usize| {
        let pairs = ours.iter().zip(&other).map(|(a, b)| (a[index] - b[index]).to_f64().abs());
        pairs.fold(0.0, worse) / run.sizes[index]
    };
    let states = run.sizes.len();
    let by_state = |index: usize| ours.iter().map(|row| row[index].to_f64()).collect();
    Some(Precise {
        states: (0..states).map(by_state).collect(),
        agreement: (0..states).map(distance).fold(0.0, worse),
    })
}

struct Run<'a> {
    series: &'a dyn TaylorSeries<DoubleDouble>,
    parameters: Vec<DoubleDouble>,
    /// Times at which the right-hand side jumps, in order.
    jumps: Vec<DoubleDouble>,
    start: Vec<DoubleDouble>,
    /// Largest absolute values of the states; 1 for a state that stays zero.
    sizes: Vec<f64>,
    times: &'a [f64],
}

impl<'a> Run<'a> {
    fn new(
        machine: &dyn Twin,
        series: &'a dyn TaylorSeries<DoubleDouble>,
        parameters: &[f64],
        pilot: &'a Trajectory,
    ) -> Self {
        let shape = machine.shape();
        let lift = DoubleDouble::literal;
        let parameters: Vec<_> = parameters.iter().map(|value| lift(*value)).collect();
        let mut jumps = vec![lift(0.0); shape.discontinuities];
        machine.discontinuities(&parameters, &mut jumps);
        jumps.sort_by(|a, b| a.to_f64().total_cmp(&b.to_f64()));
        let columns = || pilot.of_kind(ColumnKind::State).map(|column| &column.values);
        let size = |values: &Vec<f64>| values.iter().fold(0.0f64, |size, v| size.max(v.abs()));
        let sizes = columns().map(size).map(|size| if size > 0.0 { size } else { 1.0 });
        Self {
            series,
            parameters,
            jumps,
            start: columns().map(|values| lift(values[0])).collect(),
            sizes: sizes.collect(),
            times: &pilot.times,
        }
    }

    /// Returns the states at all times.
    fn states(&self, order: usize, rtol: f64) -> Option<Vec<Vec<DoubleDouble>>> {
        let lift = DoubleDouble::literal;
        let (&first, &last) = (self.times.first()?, self.times.last()?);
        let end = lift(last);
        let mut coefficients = vec![lift(0.0); (order + 1) * self.start.len()];
        let mut workspace = vec![lift(0.0); self.series.series_workspace(order)];
        let mut found = Vec::with_capacity(self.times.len());
        let (mut time, mut state) = (lift(first), self.start.clone());
        // Series of a machine at rest may have no terms that determine the first step.
        let mut longest = (last - first) / self.times.len() as f64;
        for _ in 0..MAX_STEPS {
            let (parameters, to) = (&self.parameters, &mut coefficients);
            self.series.series(time, &state, parameters, to, &mut workspace);
            let step = self.step_length(&coefficients, rtol).min(longest);
            if step.is_nan() || step <= 0.0 {
                return None;
            }
            longest = GROWTH * step;
            let next = self.jumps.iter().copied().find(|jump| (*jump - time).to_f64() > 0.0);
            let stop = next.filter(|next| (end - *next).to_f64() > 0.0).unwrap_or(end);
            let is_cut = (stop - time).to_f64() <= step;
            let until = if is_cut { stop } else { time + lift(step) };
            let at = |moment: DoubleDouble| {
                let mut state = vec![lift(0.0); self.start.len()];
                value(&coefficients, moment - time, &mut state);
                state
            };
            while let Some(&wanted) = self.times.get(found.len())
                && (lift(wanted) - until).to_f64() <= 0.0
            {
                found.push(at(lift(wanted)));
            }
            if found.len() == self.times.len() {
                return Some(found);
            }
            (state, time) = (at(until), until);
        }
        None
    }

    /// Returns the length at which the last terms are small enough.
    fn step_length(&self, coefficients: &[DoubleDouble], rtol: f64) -> f64 {
        let orders = coefficients.chunks_exact(self.sizes.len()).enumerate();
        let length = |(order, terms): (usize, &[DoubleDouble])| {
            let sizes = terms.iter().zip(&self.sizes).map(|(term, size)| term.to_f64() / size);
            let largest = sizes.fold(0.0f64, |largest, size| largest.max(size.abs()));
            (rtol / largest).powf(1.0 / order as f64)
        };
        orders.rev().take(JUDGED).map(length).fold(f64::INFINITY, f64::min)
    }
}
