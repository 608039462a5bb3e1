//! Jumps of S where the rate jumps: at events, kinks, and jumps in time.
//!
//! A guard g(t, y, p) crosses zero at a time that moves with p; after it the state is r(t, y, p)
//! and the rate another one. With f- and f+ the rates on both sides,
//!
//! ```text
//! dt_e/dp = -(g_y S- + g_p) / (g_y f- + g_t)
//! S+ = (r_y (S- + f- dt_e/dp) + r_p + r_t dt_e/dp) - f+ dt_e/dp
//! ```
//!
//! At a jump of the rate in time, r is the identity and dt_e/dp that of its time. The same holds
//! where a relation changes, and S is continuous where the rate is. Dual numbers of time, state and
//! parameters at once give the parenthesis, through any number of resets and the projection onto
//! constraints.
//!
//! If two things happen at once that p moves apart, or if a guard is grazed, there is no
//! derivative; the run stops with a message.

use machinist_contract::{Dual, DualFunction};
use nalgebra::DMatrix;

use super::Tangents;
use crate::error::StopCause;
use crate::method::{EventRecord, Front, Stopped, Stretch, System, Watch};

/// Time of a change, and its derivatives.
#[derive(Debug, Clone)]
pub(super) struct Instant {
    pub(super) time: f64,
    pub(super) shifts: Vec<f64>,
}

/// Relative difference up to which shifts of times are the same.
const SAME: f64 = 1e-6;

/// Returns whether times differ only by rounding.
fn is_at(a: f64, b: f64) -> bool {
    (a - b).abs() <= 64.0 * f64::EPSILON * a.abs().max(b.abs())
}

/// State at a crossing.
pub(crate) struct Passing<'p> {
    /// Time.
    pub(crate) time: f64,
    /// The state there, before any change.
    pub(crate) before: &'p [f64],
}

impl Tangents<'_> {
    /// Jumps S where the rate jumps in time, from `rate_before`, and where constraints move the state
    /// from `before` to `behind`. Relations are settled behind the jump.
    ///
    /// # Errors
    /// [`StopCause::CoincidentEvents`] if several things happen there that are moved apart.
    pub(crate) fn jump(
        &self,
        system: &System<'_>,
        (time, before, rate_before): (f64, &[f64], &[f64]),
        (behind, after): (f64, &[f64]),
        has_moved: bool,
    ) -> Result<(), Stopped> {
        let mut found: Option<Vec<f64>> = None;
        for (_, shifts) in
            self.jump_times().into_iter().filter(|jump| jump.0.to_bits() == time.to_bits())
        {
            if let Some(others) = &found {
                self.require_same(time, others, &shifts)?;
            }
            found = Some(shifts);
        }
        let still = || has_moved.then(|| vec![0.0; self.by.len()]);
        let Some(shifts) = found.or_else(still) else { return Ok(()) };
        self.require_apart(time, &shifts)?;
        let rate = |time: f64, state: &[f64]| {
            let mut rate = vec![0.0; system.len()];
            system.rate(time, state, &mut rate);
            rate
        };
        if has_moved {
            let passing = Passing { time: behind, before };
            self.take_up(system, &passing, &shifts, [rate_before, &rate(behind, after)], after)?;
        } else {
            self.shift(rate_before, &rate(time, before), &shifts);
        }
        self.inner.borrow_mut().latest = Instant { time, shifts };
        Ok(())
    }

    /// Jumps S where constraints move the state as its rate jumps.
    fn take_up(
        &self,
        system: &System<'_>,
        passing: &Passing<'_>,
        shifts: &[f64],
        [before, behind]: [&[f64]; 2],
        after: &[f64],
    ) -> Result<(), Stopped> {
        self.map(system, passing, shifts, before, (&EventRecord::default(), after))?;
        self.shift(&vec![0.0; behind.len()], behind, shifts);
        Ok(())
    }

    /// Computes S+ = S- + (f- - f+) dt/dp.
    fn shift(&self, before: &[f64], after: &[f64], shifts: &[f64]) {
        let count = self.by.len();
        let start = &mut self.inner.borrow_mut().start;
        for (row, (before, after)) in start.chunks_exact_mut(count).zip(before.iter().zip(after)) {
            for (value, shift) in row.iter_mut().zip(shifts) {
                if *shift != 0.0 {
                    *value += (before - after) * shift;
                }
            }
        }
    }

    /// Jumps S where relations changed and nothing else; `after` is the state after the change, to
    /// which constraints may have moved it.
    ///
    /// # Errors
    /// Returns an error if the rate jumps there, and the guards are moved apart or grazed.
    pub(crate) fn cross(
        &self,
        stretch: &Stretch<'_>,
        watch: &Watch<'_>,
        passing: &Passing<'_>,
        (after, has_moved): (&[f64], bool),
    ) -> Result<(), Stopped> {
        let Some(front) = watch.front() else { return Ok(()) };
        let behind = rate_of(stretch, passing.time, after);
        if !has_moved && front.rate == behind {
            return Ok(());
        }
        let mut found: Option<Vec<f64>> = None;
        for guard in watch.record().passed.into_iter().filter(|it| !watch.is_smooth_at(*it)) {
            let shifts = self.shifts_of_guard(watch, &front, passing, guard)?;
            if let Some(others) = &found {
                self.require_same(passing.time, others, &shifts)?;
            }
            found = Some(shifts);
        }
        if let Some(shifts) = found {
            if has_moved {
                let rates = [&front.rate[..], &behind];
                self.take_up(stretch.system, passing, &shifts, rates, after)?;
            } else {
                self.shift(&front.rate, &behind, &shifts);
            }
            self.inner.borrow_mut().latest = Instant { time: passing.time, shifts };
        }
        Ok(())
    }

    /// Jumps S where events happened; `after` is the state after them.
    ///
    /// # Errors
    /// Returns an error if the guards are moved apart or grazed, or events set positions that
    /// constraints then move.
    pub(crate) fn switch(
        &self,
        stretch: &Stretch<'_>,
        watch: &Watch<'_>,
        passing: &Passing<'_>,
        record: &EventRecord,
        after: &[f64],
    ) -> Result<(), Stopped> {
        let time = passing.time;
        let Some(front) = watch.front() else { return Ok(()) };
        let mut found: Option<Vec<f64>> = None;
        for guard in record.passed.iter().filter(|it| !watch.is_smooth_at(**it)) {
            let shifts = self.shifts_of_guard(watch, &front, passing, *guard)?;
            if let Some(others) = &found {
                self.require_same(time, others, &shifts)?;
            }
            found = Some(shifts);
        }
        let shifts = match found {
            Some(shifts) => shifts,
            None if record.applied.is_empty() => return Ok(()),
            // Caused by what happened just before.
            None => self.inner.borrow().latest.shifts.clone(),
        };
        let behind = rate_of(stretch, time, after);
        self.map(stretch.system, passing, &shifts, &front.rate, (record, after))?;
        let count = self.by.len();
        {
            let start = &mut self.inner.borrow_mut().start;
            for (row, rate) in start.chunks_exact_mut(count).zip(&behind) {
                for (value, shift) in row.iter_mut().zip(&shifts) {
                    if *shift != 0.0 {
                        *value -= rate * shift;
                    }
                }
            }
        }
        self.inner.borrow_mut().latest = Instant { time, shifts };
        let start = self.inner.borrow().start.clone();
        self.require_finite(stretch, time, &start)
    }

    /// Maps S through the events at the start of the run, whose time does not move.
    pub(crate) fn settle(
        &self,
        system: &System<'_>,
        time: f64,
        before: &[f64],
        record: &EventRecord,
        after: &[f64],
    ) -> Result<(), Stopped> {
        if record.applied.is_empty() {
            return Ok(());
        }
        let passing = Passing { time, before };
        let (shifts, rate) = (vec![0.0; self.by.len()], vec![0.0; before.len()]);
        self.map(system, &passing, &shifts, &rate, (record, after))
    }

    /// Computes S = r_y (S + f dt/dp) + r_p + r_t dt/dp for the events, one after another.
    fn map(
        &self,
        system: &System<'_>,
        passing: &Passing<'_>,
        shifts: &[f64],
        rate: &[f64],
        (record, after): (&EventRecord, &[f64]),
    ) -> Result<(), Stopped> {
        let count = self.by.len();
        let simulator = self.simulator;
        let events: Vec<_> = (0..simulator.events()).map(|index| simulator.event(index)).collect();
        let lengths: Vec<usize> = events.iter().map(|event| event.sets.len()).collect();
        let mut values = vec![Dual::constant(0.0); lengths.iter().sum()];
        let tangents = self.inner.borrow().start.clone();
        let mut mapped = tangents.clone();
        for directions in self.chunks() {
            let parameters = self.parameters_along(&directions);
            let mut state = self.state_along(passing.before, &tangents, &directions);
            let mut time = Dual::constant(passing.time);
            for (lane, direction) in directions.clone().enumerate() {
                let shift = shifts[direction];
                time.slopes[lane] = shift;
                if shift != 0.0 {
                    for (dual, rate) in state.iter_mut().zip(rate) {
                        dual.slopes[lane] += rate * shift;
                    }
                }
            }
            for index in &record.applied {
                // New values use live relations, whatever is held.
                let (function, live) = (DualFunction::Resets, &parameters[..self.parameters.len()]);
                self.derivatives.on_duals(function, time, &state, live, &mut values);
                let first: usize = lengths[..*index].iter().sum();
                for (entry, value) in events[*index].sets.iter().zip(&values[first..]) {
                    let entry = *entry as usize;
                    state[entry] = if simulator.is_mode(entry) {
                        Dual::constant(value.value.round())
                    } else {
                        *value
                    };
                }
            }
            if let Some(constraints) = system.constraints() {
                let at = (time, &parameters[..]);
                put_back(self, constraints, at, &mut state, after)
                    .map_err(|cause| Stopped { time: passing.time, cause })?;
            }
            for (index, dual) in state.iter().enumerate() {
                mapped[index * count..][directions.clone()]
                    .copy_from_slice(&dual.slopes[..directions.len()]);
            }
        }
        self.inner.borrow_mut().start.copy_from_slice(&mapped);
        Ok(())
    }

    /// Returns the derivatives of the time at which a guard crosses.
    fn shifts_of_guard(
        &self,
        watch: &Watch<'_>,
        front: &Front,
        passing: &Passing<'_>,
        guard: usize,
    ) -> Result<Vec<f64>, Stopped> {
        let events = self.simulator.events();
        let (function, count, place, sign) = match watch.kink_of(guard) {
            None => (DualFunction::Guards, events, guard, 1.0),
            Some((place, sign)) => (DualFunction::KinkGuards, self.simulator.kinks(), place, sign),
        };
        let Passing { time, before } = *passing;
        let (value, rate) = front.guards[guard];
        let start = self.inner.borrow().start.clone();
        let mut slopes = self.slopes(function, count, time, before, &start).swap_remove(place);
        for slope in &mut slopes {
            *slope *= sign;
        }
        let latest = self.inner.borrow().latest.clone();
        let room = watch.blur(guard, time, before);
        if is_at(latest.time, time) {
            // What happened just before put the guard there, or made it jump beyond.
            let follows = slopes.iter().zip(&latest.shifts).all(|(slope, shift)| {
                let moved = rate * shift;
                (slope + moved).abs() <= SAME * slope.abs().max(moved.abs())
            });
            if follows || value.abs() > room {
                return Ok(latest.shifts);
            }
        }
        let bend = watch.bend_of(guard);
        if rate * rate <= 2.0 * bend * room || rate == 0.0 {
            let name = self.name_of(guard);
            return Err(Stopped { time, cause: StopCause::Grazing { name } });
        }
        let shifts: Vec<f64> = slopes.iter().map(|slope| -slope / rate).collect();
        self.require_apart(time, &shifts)?;
        Ok(shifts)
    }

    fn name_of(&self, guard: usize) -> String {
        let events = self.simulator.events();
        if guard < events {
            format!("the guard of event `{}`", self.simulator.event(guard).name)
        } else {
            "a comparison in the rate".to_owned()
        }
    }

    /// Refuses a change at the time of the last one if it moves differently.
    fn require_apart(&self, time: f64, shifts: &[f64]) -> Result<(), Stopped> {
        let latest = self.inner.borrow().latest.clone();
        if is_at(latest.time, time) {
            self.require_same(time, &latest.shifts, shifts)
        } else {
            Ok(())
        }
    }

    fn require_same(&self, time: f64, a: &[f64], b: &[f64]) -> Result<(), Stopped> {
        let differs = |(a, b): (&f64, &f64)| (a - b).abs() > SAME * a.abs().max(b.abs());
        match a.iter().zip(b).position(differs) {
            None => Ok(()),
            Some(direction) => {
                let by = self.by[direction].quantity(self.simulator).name.to_owned();
                Err(Stopped { time, cause: StopCause::CoincidentEvents { by } })
            }
        }
    }
}

/// Returns f at a state, with relations as held.
fn rate_of(stretch: &Stretch<'_>, time: f64, state: &[f64]) -> Vec<f64> {
    let mut rate = vec![0.0; stretch.system.len()];
    stretch.rate(time, state, &mut rate);
    rate
}

/// Projects a state with slopes onto the constraints, as the state `after` was projected from where
/// events had set it.
///
/// ```text
/// M(q) (v+ - v-) + G(q, t)^T nu = 0,   g'(q, v+, t) = 0
/// ```
///
/// differentiated as it is, including the changes of M and G.
fn put_back(
    tangents: &Tangents<'_>,
    constraints: &crate::constraints::Constraints<'_>,
    (time, parameters): (Dual, &[Dual]),
    state: &mut [Dual],
    after: &[f64],
) -> Result<(), StopCause> {
    /// Relative move of positions above which it is no drift.
    const DRIFT: f64 = 1e-6;
    let simulator = tangents.simulator;
    let n = simulator.shape().coordinates;
    let first = simulator.shape().positions;
    let m = simulator.constraints();
    for index in 0..first {
        let scale = simulator.state_scale(index).max(after[index].abs());
        if (after[index] - state[index].value).abs() > DRIFT * scale {
            let state = simulator.state(index).name.to_owned();
            return Err(StopCause::ProjectedPosition { state });
        }
    }
    let velocities: Vec<f64> = (0..n).map(|index| state[first + index].value).collect();
    let moved = DMatrix::from_fn(n, 1, |index, _| after[first + index] - velocities[index]);
    for (dual, value) in state.iter_mut().zip(after) {
        dual.value = *value;
    }
    let zero = Dual::constant(0.0);
    let on_duals = |function, state: &[Dual], values: &mut [Dual]| {
        tangents.derivatives.on_duals(function, time, state, parameters, values);
    };
    let matrix = constraints.matrix(time.value, after);
    let lost = || StopCause::OffConstraint { constraint: constraints.name(0).to_owned() };
    let saddle = constraints.saddle(time.value, after, &matrix).lu();
    let lanes = Dual::DIRECTIONS;

    let mut residuals = vec![zero; m];
    on_duals(DualFunction::ConstraintValues, state, &mut residuals);
    let right_side =
        DMatrix::from_fn(n + m, lanes, |i, k| if i < n { 0.0 } else { residuals[i - n].slopes[k] });
    let shift = saddle.solve(&right_side).ok_or_else(lost)?;
    for lane in 0..lanes {
        let moves =
            constraints.moves(time.value, after, &shift.column(lane).rows(0, n).into_owned());
        for (entry, change) in state.iter_mut().zip(moves) {
            entry.slopes[lane] -= change;
        }
    }

    // nu of the move itself.
    let gained = &matrix * &moved;
    let right_side =
        DMatrix::from_fn(n + m, 1, |i, _| if i < n { 0.0 } else { gained[(i - n, 0)] });
    let multipliers = saddle.solve(&right_side).ok_or_else(lost)?;
    let mut top = DMatrix::zeros(n, lanes);
    let pattern = simulator.mass_matrix_pattern().entries;
    let mut values = vec![zero; pattern.len()];
    on_duals(DualFunction::MassMatrix, state, &mut values);
    for ((row, column), value) in pattern.iter().zip(&values) {
        for lane in 0..lanes {
            top[(*row as usize, lane)] -= value.slopes[lane] * moved[(*column as usize, 0)];
        }
    }
    let pattern = simulator.constraint_matrix_pattern().entries;
    let mut values = vec![zero; pattern.len()];
    on_duals(DualFunction::ConstraintMatrix, state, &mut values);
    for ((row, column), value) in pattern.iter().zip(&values) {
        for lane in 0..lanes {
            top[(*column as usize, lane)] -=
                value.slopes[lane] * multipliers[(n + *row as usize, 0)];
        }
    }
    let mut residuals = vec![zero; m];
    on_duals(DualFunction::ConstraintRates, state, &mut residuals);
    let right_side = DMatrix::from_fn(n + m, lanes, |i, k| {
        if i < n { top[(i, k)] } else { -residuals[i - n].slopes[k] }
    });
    let shift = saddle.solve(&right_side).ok_or_else(lost)?;
    for index in 0..n {
        for lane in 0..lanes {
            state[first + index].slopes[lane] += shift[(index, lane)];
        }
    }
    Ok(())
}
