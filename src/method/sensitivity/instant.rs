//! What S does where the rate jumps: at events, kinks, and jumps in time.
//!
//! A guard g(t, y, p) passes zero at a time that moves with p; behind it the state is
//! r(t, y, p) and the rate another one. With f- and f+ the rates on both sides,
//!
//! ```text
//! dt_e/dp = -(g_y S- + g_p) / (g_y f- + g_t)
//! S+ = (r_y (S- + f- dt_e/dp) + r_p + r_t dt_e/dp) - f+ dt_e/dp
//! ```
//!
//! At a jump of the rate in time r is the identity and dt_e/dp that of its time; at a kink
//! likewise, and S is continuous where the rate is. Dual numbers of time, state and parameters
//! at once give the parenthesis, through any number of resets and the move back onto
//! constraints.
//!
//! Where two things happen at once that p moves apart, and where a guard is grazed, there is no
//! derivative, and the run stops and says so.

use machinist_contract::{Dual, DualFunction};
use nalgebra::DMatrix;

use super::Tangents;
use crate::error::StopCause;
use crate::method::{Happened, Stopped, Stretch, System, Watch};

/// When something happened, and how that moves with what is differentiated by.
#[derive(Debug, Clone)]
pub(super) struct Instant {
    pub(super) time: f64,
    pub(super) shifts: Vec<f64>,
}

/// Shifts of times that differ by no more than this share are the same.
const SAME: f64 = 1e-6;

/// Times that differ by rounding are the same.
fn is_at(a: f64, b: f64) -> bool {
    (a - b).abs() <= 64.0 * f64::EPSILON * a.abs().max(b.abs())
}

/// What is known of a passing.
pub(crate) struct Passing<'p> {
    /// When.
    pub(crate) time: f64,
    /// The state there, before anything happens.
    pub(crate) before: &'p [f64],
    /// The same or a moment earlier, where the rate is surely that of before.
    pub(crate) front: (f64, &'p [f64]),
}

impl Tangents<'_> {
    /// Jumps S where the rate jumps in time; and where constraints move the state, from what it was
    /// `before` to what it is `behind`.
    ///
    /// # Errors
    /// [`StopCause::AtOnce`] if several things happen there that are moved apart.
    pub(crate) fn jump(
        &self,
        system: &System<'_>,
        (time, before): (f64, &[f64]),
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
        let rate_before = rate(time.next_down(), before);
        if has_moved {
            let passing = Passing { time: behind, before, front: (time, before) };
            self.take_up(system, &passing, &shifts, [&rate_before, &rate(behind, after)], after)?;
        } else {
            self.shift(&rate_before, &rate(time, before), &shifts);
        }
        self.inner.borrow_mut().latest = Instant { time, shifts };
        Ok(())
    }

    /// S where constraints move the state as its rate jumps.
    fn take_up(
        &self,
        system: &System<'_>,
        passing: &Passing<'_>,
        shifts: &[f64],
        [before, behind]: [&[f64]; 2],
        after: &[f64],
    ) -> Result<(), Stopped> {
        self.map(system, passing, shifts, before, (&Happened::default(), after))?;
        self.shift(&vec![0.0; behind.len()], behind, shifts);
        Ok(())
    }

    /// S+ = S- + (f- - f+) dt/dp.
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

    /// Jumps S where kinks were passed and nothing else; `after` is the state behind them, to which
    /// constraints may have moved it.
    ///
    /// # Errors
    /// If the rate jumps there, and the kinks are moved apart or grazed.
    pub(crate) fn cross(
        &self,
        stretch: &Stretch<'_>,
        watch: &Watch<'_>,
        passing: &Passing<'_>,
        kinks: &[usize],
        ((behind, after), has_moved): ((f64, &[f64]), bool),
    ) -> Result<(), Stopped> {
        let rates = rates_beside(stretch, passing.front, (behind, after));
        if !has_moved && !self.rate_jumps(stretch, passing.front, (behind, after), &rates) {
            return Ok(());
        }
        let mut found: Option<Vec<f64>> = None;
        for kink in kinks {
            let shifts = self.shifts_of_guard(watch, passing, *kink)?;
            if let Some(others) = &found {
                self.require_same(passing.time, others, &shifts)?;
            }
            found = Some(shifts);
        }
        if let Some(shifts) = found {
            if has_moved {
                let passing = Passing { time: stretch.within(behind), ..*passing };
                let rates = rates.each_ref().map(Vec::as_slice);
                self.take_up(stretch.system, &passing, &shifts, rates, after)?;
            } else {
                self.shift(&rates[0], &rates[1], &shifts);
            }
            self.inner.borrow_mut().latest = Instant { time: passing.time, shifts };
        }
        Ok(())
    }

    /// Whether the rate is another one on both sides, by more than it changes beside them.
    fn rate_jumps(
        &self,
        stretch: &Stretch<'_>,
        front: (f64, &[f64]),
        behind: (f64, &[f64]),
        rates: &[Vec<f64>; 2],
    ) -> bool {
        const BESIDE: f64 = 100.0;
        const ROUNDING: f64 = 1e-13;
        let by = moment(stretch, front.0);
        let aside = |(time, state): (f64, &[f64]), rate: &[f64], by: f64| {
            let moved: Vec<f64> = state.iter().zip(rate).map(|(y, f)| y + by * f).collect();
            (time + by, moved)
        };
        let earlier = aside(front, &rates[0], -by);
        let later = aside(behind, &rates[1], by);
        let beside = rates_beside(stretch, (earlier.0, &earlier.1), (later.0, &later.1));
        (0..self.states).any(|index| {
            let [before, after] = [0, 1].map(|side: usize| rates[side][index]);
            let change = |side: usize| (beside[side][index] - rates[side][index]).abs();
            let usual = self.simulator.state_scale(index) / (stretch.until - stretch.from);
            let size = before.abs().max(after.abs()).max(usual);
            (before - after).abs() > BESIDE * (change(0) + change(1)) + ROUNDING * size
        })
    }

    /// Jumps S where events happened; `after` is the state behind them.
    ///
    /// # Errors
    /// If they are moved apart, grazed, or set positions that constraints then move.
    pub(crate) fn switch(
        &self,
        stretch: &Stretch<'_>,
        watch: &Watch<'_>,
        passing: &Passing<'_>,
        happened: &Happened,
        after: &[f64],
    ) -> Result<(), Stopped> {
        let time = passing.time;
        let mut found: Option<Vec<f64>> = None;
        for guard in &happened.passed {
            let shifts = self.shifts_of_guard(watch, passing, *guard)?;
            if let Some(others) = &found {
                self.require_same(time, others, &shifts)?;
            }
            found = Some(shifts);
        }
        let shifts = match found {
            Some(shifts) => shifts,
            None if happened.applied.is_empty() => return Ok(()),
            // What happened just before has led to it.
            None => self.inner.borrow().latest.shifts.clone(),
        };
        let ahead = self.ahead(stretch, time, after);
        let [before, behind] = rates_beside(stretch, passing.front, (ahead.0, &ahead.1));
        self.map(stretch.system, passing, &shifts, &before, (happened, after))?;
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

    /// S through what events did at the start of the run, which does not move.
    pub(crate) fn settle(
        &self,
        system: &System<'_>,
        time: f64,
        before: &[f64],
        happened: &Happened,
        after: &[f64],
    ) -> Result<(), Stopped> {
        if happened.applied.is_empty() {
            return Ok(());
        }
        let passing = Passing { time, before, front: (time, before) };
        let (shifts, rate) = (vec![0.0; self.by.len()], vec![0.0; before.len()]);
        self.map(system, &passing, &shifts, &rate, (happened, after))
    }

    /// S = r_y (S + f dt/dp) + r_p + r_t dt/dp of what events do, one after the other.
    fn map(
        &self,
        system: &System<'_>,
        passing: &Passing<'_>,
        shifts: &[f64],
        rate: &[f64],
        (happened, after): (&Happened, &[f64]),
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
            for index in &happened.applied {
                let function = DualFunction::Resets;
                self.derivatives.on_duals(function, time, &state, &parameters, &mut values);
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

    /// How the time moves at which a guard passes.
    fn shifts_of_guard(
        &self,
        watch: &Watch<'_>,
        passing: &Passing<'_>,
        guard: usize,
    ) -> Result<Vec<f64>, Stopped> {
        let events = self.simulator.events();
        let (function, count, place) = if guard < events {
            (DualFunction::Guards, events, guard)
        } else {
            (DualFunction::KinkGuards, self.simulator.kinks(), guard - events)
        };
        let Passing { time, before, front } = *passing;
        let (value, _) = watch.guard_at(time, before, guard);
        let (_, rate) = watch.guard_at(front.0, front.1, guard);
        let start = self.inner.borrow().start.clone();
        let slopes = self.slopes(function, count, time, before, &start).swap_remove(place);
        let latest = self.inner.borrow().latest.clone();
        let room = watch.blur(guard, time, before);
        if is_at(latest.time, time) {
            // What happened just before has put the guard there, or made it jump beyond.
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
            "what a kink of the rate compares".to_owned()
        }
    }

    /// Refuses what happens at once with what happened just before, but moves otherwise.
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
                Err(Stopped { time, cause: StopCause::AtOnce { by } })
            }
        }
    }

    /// A moment behind events, where kinks that are at zero there have taken their side.
    fn ahead(&self, stretch: &Stretch<'_>, time: f64, after: &[f64]) -> (f64, Vec<f64>) {
        let mut ahead = after.to_vec();
        if self.simulator.kinks() == 0 {
            return (time, ahead);
        }
        let by = moment(stretch, time);
        let mut rate = vec![0.0; stretch.system.len()];
        stretch.rate(time, after, &mut rate);
        for (value, rate) in ahead.iter_mut().zip(&rate) {
            *value += by * rate;
        }
        (time + by, ahead)
    }
}

/// f on both sides.
fn rates_beside(
    stretch: &Stretch<'_>,
    front: (f64, &[f64]),
    behind: (f64, &[f64]),
) -> [Vec<f64>; 2] {
    [front, behind].map(|(time, state)| {
        let mut rate = vec![0.0; stretch.system.len()];
        stretch.rate(time, state, &mut rate);
        rate
    })
}

/// No time, but more than rounding \[s\].
pub(crate) fn moment(stretch: &Stretch<'_>, time: f64) -> f64 {
    1e-12 * time.abs().max(stretch.until - stretch.from)
}

/// Puts a state with slopes onto the constraints, as the state `after` was put from where
/// events had set it.
///
/// ```text
/// M(q) (v+ - v-) + G(q, t)^T nu = 0,   g'(q, v+, t) = 0
/// ```
///
/// differentiated as it stands, with what M and G change by.
fn put_back(
    tangents: &Tangents<'_>,
    constraints: &crate::constraints::Constraints<'_>,
    (time, parameters): (Dual, &[Dual]),
    state: &mut [Dual],
    after: &[f64],
) -> Result<(), StopCause> {
    /// Moves of positions that are no drift.
    const DRIFT: f64 = 1e-6;
    let simulator = tangents.simulator;
    let n = simulator.shape().coordinates;
    let m = simulator.constraints();
    for index in 0..n {
        let scale = simulator.state_scale(index).max(after[index].abs());
        if (after[index] - state[index].value).abs() > DRIFT * scale {
            let state = simulator.state(index).name.to_owned();
            return Err(StopCause::MovedPosition { state });
        }
    }
    let velocities: Vec<f64> = (0..n).map(|index| state[n + index].value).collect();
    let moved = DMatrix::from_fn(n, 1, |index, _| after[n + index] - velocities[index]);
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
    for index in 0..n {
        for lane in 0..lanes {
            state[index].slopes[lane] -= shift[(index, lane)];
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
            state[n + index].slopes[lane] += shift[(index, lane)];
        }
    }
    Ok(())
}
