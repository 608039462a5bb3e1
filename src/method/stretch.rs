//! A stretch of a run without jumps, and the samples requested of the run.

use super::milestone::out_of_steps;
use super::system::FLOWS;
use super::{Auto, Problem, Stopped, System, Watch};
use crate::error::StopCause;

/// A stretch of a run on which the right-hand side is smooth.
pub struct Stretch<'a> {
    /// The equations; [`Stretch::rate`] evaluates rates within the stretch.
    pub system: &'a System<'a>,
    /// Start time \[s\].
    pub from: f64,
    /// End time \[s\].
    pub until: f64,
    /// Relative tolerance.
    pub rtol: f64,
    /// Absolute tolerance of every state.
    pub atol: &'a [f64],
    /// Largest number of steps of the whole run.
    pub max_steps: usize,
    /// True if first steps are shortened; see [`StepTolerance::shortens`](super::StepTolerance).
    pub(super) shortens: bool,
    /// Choices of `auto`.
    #[cfg_attr(
        not(feature = "implicit"),
        expect(dead_code, reason = "no `auto` without `implicit`")
    )]
    pub(super) auto: Auto,
    /// Guards to be watched, if there are any.
    pub watch: Option<&'a Watch<'a>>,
}

impl<'a> Stretch<'a> {
    pub(super) fn new(
        problem: &'a Problem<'a>,
        (from, until): (f64, f64),
        watch: Option<&'a Watch<'a>>,
    ) -> Self {
        Self {
            system: problem.system,
            from,
            until,
            rtol: problem.tolerance.rtol,
            atol: &problem.tolerance.atol,
            max_steps: problem.max_steps,
            shortens: problem.tolerance.shortens,
            auto: problem.auto,
            watch,
        }
    }

    /// Returns a stretch for steps without error control.
    #[cfg(feature = "implicit")]
    pub(super) fn without_control(
        system: &'a System<'a>,
        from: f64,
        until: f64,
        atol: &'a [f64],
    ) -> Self {
        let (rtol, max_steps) = (1e-6, usize::MAX);
        let auto = Auto::default();
        Self { system, from, until, rtol, atol, max_steps, shortens: false, auto, watch: None }
    }

    /// Returns the time over which the run is observed \[s\]: the stretch, or the whole run of
    /// which it is a piece.
    pub(super) fn looked_at(&self) -> f64 {
        (self.until - self.from).max(self.system.whole())
    }

    /// Returns `time` moved into \[from, until).
    ///
    /// A jump at t0 has its new value from t0 on. A method that evaluates the right-hand side at
    /// the end of the stretch, as every implicit one does, would see the value after the jump and
    /// lose its order. The last moment before the end stands for the limit from the left, which it
    /// equals to rounding. Likewise, no trial step looks back before the start of the stretch.
    #[must_use]
    pub fn within(&self, time: f64) -> f64 {
        within(time, (self.from, self.until))
    }

    /// Evaluates f(t, y) at `time` moved into the stretch.
    pub fn rate(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        self.system.rate(self.within(time), state, rate);
    }

    /// Evaluates f(t, y) without quadratures at `time` moved into the stretch.
    pub fn state_rate(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        self.system.state_rate(self.within(time), state, rate);
    }

    /// Evaluates the arguments of functions that saturate at `time` moved into the stretch.
    pub fn saturating_arguments(&self, time: f64, state: &[f64], arguments: &mut [f64]) {
        let (simulator, held) = (self.system.simulator(), self.system.held().all());
        simulator.saturating_arguments(self.within(time), state, &held, arguments);
    }

    /// Returns the rates of the quadratures at `time` moved into the stretch.
    #[must_use]
    pub fn flow_rates(&self, time: f64, state: &[f64]) -> [f64; FLOWS] {
        self.system.flow_rates(self.within(time), state)
    }

    /// Evaluates the partial derivative of f with respect to time, without quadratures, at `time`
    /// moved into the stretch.
    pub fn time_derivative(&self, time: f64, state: &[f64], derivative: &mut [f64]) {
        self.system.time_derivative(self.within(time), state, derivative);
    }

    /// Evaluates df/dy without quadratures at `time` moved into the stretch.
    pub fn jacobian(&self, time: f64, state: &[f64], values: &mut [f64]) {
        self.system.jacobian(self.within(time), state, values);
    }

    /// Returns the rows of df/dy of the quadratures at `time` moved into the stretch.
    #[must_use]
    pub fn flow_gradient(&self, time: f64, state: &[f64]) -> Vec<(usize, [f64; FLOWS])> {
        self.system.flow_gradient(self.within(time), state)
    }

    /// Projects a state onto the constraints, if there are any.
    pub(super) fn constrain(&self, time: f64, state: &mut [f64]) -> Result<(), Stopped> {
        let constrained = self.system.constrain(self.within(time), state);
        constrained.map_err(|stopped| Stopped { time, ..stopped })
    }

    /// Returns whether there is nothing for a method to step on: no states, or a stretch between
    /// jumps that differ by rounding, such as 0.1 + 0.2 and 0.3.
    pub(super) fn is_trivial(&self) -> bool {
        const ROUNDINGS: f64 = 512.0;
        let size = self.from.abs().max(self.until.abs());
        self.system.is_empty() || self.until - self.from <= ROUNDINGS * f64::EPSILON * size
    }

    /// Moves the state to the end if only rounding is left after `time` and the state hardly moves;
    /// returns whether it does.
    pub(super) fn ends_within_rounding(
        &self,
        time: f64,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> bool {
        let rest = Stretch { from: time, ..*self };
        let is_over = rest.is_trivial() && rest.hardly_moves(state);
        if is_over {
            rest.euler_step(state, samples);
        }
        is_over
    }

    /// Returns whether one Euler step over the whole stretch moves no state by more than allowed.
    fn hardly_moves(&self, state: &[f64]) -> bool {
        let mut rate = vec![0.0; state.len()];
        self.rate(self.from, state, &mut rate);
        let length = self.until - self.from;
        (0..self.system.states()).all(|index| {
            (length * rate[index]).abs() <= self.atol[index] + self.rtol * state[index].abs()
        })
    }

    /// Takes one Euler step over the whole stretch, exact to rounding on a trivial one.
    pub(super) fn euler_step(&self, state: &mut [f64], samples: &mut Samples<'_>) {
        let mut rate = vec![0.0; state.len()];
        self.rate(self.from, state, &mut rate);
        if let Some(tangents) = self.system.tangents() {
            tangents.euler_step(self, state);
            tangents.sample_start(samples, self.until);
        }
        for (value, rate) in state.iter_mut().zip(&rate) {
            *value += (self.until - self.from) * rate;
        }
        while samples.next_until(self.until).is_some() {
            samples.push(state);
        }
    }

    /// Refuses to continue from `time` if the run is to end there.
    pub(super) fn require_uninterrupted(&self, time: f64) -> Result<(), Stopped> {
        self.system.interruption().map_or(Ok(()), |cause| Err(Stopped { time, cause }))
    }

    /// Counts a rejected step, and refuses to continue as [`Stretch::require_fewer_passes`] does.
    pub(super) fn count_rejected(&self, time: f64) -> Result<(), Stopped> {
        self.system.count(|work| work.rejected += 1);
        self.require_fewer_passes(time)
    }

    /// Refuses to continue once all steps are taken, including rejected ones.
    pub(super) fn require_fewer_passes(&self, time: f64) -> Result<(), Stopped> {
        let work = self.system.work();
        let limit = self.max_steps;
        if work.rejected.max(work.steps) > limit as u64 {
            return Err(Stopped { time, cause: StopCause::TooManySteps { limit } });
        }
        Ok(())
    }

    /// Does the same as [`Stretch::require_uninterrupted`], after a step that ends in a state.
    pub(super) fn require_wanted(&self, time: f64, state: &[f64]) -> Result<(), Stopped> {
        self.require_uninterrupted(time)?;
        if self.system.is_left_at(time, state) {
            return Err(Stopped { time, cause: StopCause::Interrupted });
        }
        Ok(())
    }

    /// Refuses a start at which the right-hand side is NaN or infinite.
    pub(super) fn require_finite_rate(&self, state: &[f64]) -> Result<(), Stopped> {
        let mut rate = vec![0.0; state.len()];
        self.rate(self.from, state, &mut rate);
        match rate.iter().position(|value| !value.is_finite()) {
            None => Ok(()),
            Some(index) => Err(self.not_finite("the rate of", index, self.from)),
        }
    }

    /// Returns the cause to end at `time` if all steps are taken, or if all allowed steps lead
    /// nowhere near the end of the stretch.
    pub(super) fn out_of_steps(&self, time: f64) -> Option<StopCause> {
        let steps = self.system.work().steps;
        out_of_steps((steps, self.max_steps), self.until - time, || self.system.pace(time))
    }

    /// Returns the cause of steps that became too short or too many: chattering, if a state
    /// chatters, otherwise `else_cause`.
    pub(super) fn cause_at(&self, time: f64, state: &[f64], else_cause: StopCause) -> StopCause {
        self.chattering(time, state).unwrap_or(else_cause)
    }

    /// Returns the cause to end before a step from `time`: it is too short, all steps are taken or
    /// lead nowhere, or they are too short to reach the end because a state chatters.
    pub(super) fn leads_nowhere(&self, step: f64, time: f64, state: &[f64]) -> Option<StopCause> {
        /// Number of steps between checks for chattering.
        const EVERY: u64 = 512;
        let stuck = (time + step <= time).then_some(StopCause::StepTooSmall);
        if let Some(cause) = self.out_of_steps(time).or(stuck) {
            return Some(self.cause_at(time, state, cause));
        }
        let reached = step * self.max_steps as f64;
        let steps = self.system.work().steps;
        let is_asked = reached < self.until - time && steps.is_multiple_of(EVERY);
        is_asked.then(|| self.chattering(time, state)).flatten()
    }

    /// Returns a state whose rate jumps through zero nearby and drives it back from both sides. On
    /// either side the rate must be the same half as near, so that it is a jump and not a slope. It
    /// must also be so a while later, so that the jump does not move, as in a comparison with a
    /// sawtooth in time.
    pub(super) fn chattering(&self, time: f64, state: &[f64]) -> Option<StopCause> {
        /// Distances from the state, in tolerances; steps that chatter end within them.
        const NEAR: [f64; 2] = [100.0, 50.0];
        const SAME: f64 = 0.1;
        /// Factor of the time that a motion over this distance takes.
        const LATER: f64 = 100.0;
        let mut shifted = state.to_vec();
        let mut rate = vec![0.0; state.len()];
        let found = (0..self.system.states()).find(|&index| {
            let allowed = self.atol[index] + self.rtol * state[index].abs();
            let mut at = |shift: f64, time: f64| {
                shifted[index] = state[index] + shift;
                self.rate(time, &shifted, &mut rate);
                shifted[index] = state[index];
                rate[index]
            };
            let mut beside =
                |time: f64| NEAR.map(|near| [at(near * allowed, time), at(-near * allowed, time)]);
            let is_same = |a: f64, b: f64| (a - b).abs() <= SAME * a.abs();
            let is_driven_back = |[far, near]: [[f64; 2]; 2]| {
                far[0] < 0.0 && far[1] > 0.0 && is_same(far[0], near[0]) && is_same(far[1], near[1])
            };
            let [far, near] = beside(time);
            if !is_driven_back([far, near]) {
                return false;
            }
            let takes = NEAR[0] * allowed / far[0].abs().max(far[1].abs());
            is_driven_back(beside(self.within(time + LATER * takes)))
        })?;
        Some(StopCause::Chattering { state: self.system.name(found), value: state[found] })
    }

    /// Refuses a state that is not finite, or so large that its square is not: steps would continue
    /// forever, with errors that are not numbers.
    pub(super) fn require_bounded(&self, time: f64, state: &[f64]) -> Result<(), Stopped> {
        /// Its square, and energies, are still finite.
        const LARGEST: f64 = 1e150;
        let states = &state[..self.system.states()];
        let Some(index) = states.iter().position(|value| value.is_nan() || value.abs() > LARGEST)
        else {
            return Ok(());
        };
        if !state[index].is_finite() {
            return Err(self.not_finite("the state", index, time));
        }
        let state = self.system.name(index);
        Err(Stopped { time, cause: StopCause::Overflow { state, value: states[index] } })
    }

    /// Returns the error for a value of the `index`-th state that is not finite.
    #[must_use]
    pub fn not_finite(&self, what: &str, index: usize, time: f64) -> Stopped {
        let what = format!("{what} `{}`", self.system.name(index));
        Stopped { time, cause: StopCause::not_finite(what) }
    }
}

/// Returns `time` moved between two others, and off them by the rounding of a comparison of time
/// with one of them; see [`Stretch::within`].
pub(crate) fn within(time: f64, ends: (f64, f64)) -> f64 {
    let (first, last) = inside(ends);
    time.min(last).max(first)
}

/// Returns the first and the last time used between two ends.
pub(crate) fn inside((from, until): (f64, f64)) -> (f64, f64) {
    const ROUNDINGS: f64 = 4.0;
    let room = |end: f64| ROUNDINGS * f64::EPSILON * if end.is_finite() { end.abs() } else { 0.0 };
    (from + room(from), until.next_down().min(until - room(until)))
}

/// Returns the start and end of a span, and between them the times strictly inside it, in order and
/// without duplicates.
pub(crate) fn cut(from: f64, until: f64, mut times: Vec<f64>) -> Vec<f64> {
    times.retain(|time| from < *time && *time < until);
    times.extend([from, until]);
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// States at the requested times, collected in order.
pub struct Samples<'a> {
    times: &'a [f64],
    taken: usize,
    rows: Vec<f64>,
}

impl<'a> Samples<'a> {
    pub(super) fn new(times: &'a [f64], width: usize) -> Self {
        Self { times, taken: 0, rows: Vec::with_capacity(times.len() * width) }
    }

    /// Returns the next requested time, if it is not after `time`.
    #[must_use]
    pub fn next_until(&self, time: f64) -> Option<f64> {
        self.times.get(self.taken).copied().filter(|next| *next <= time)
    }

    /// Returns how many requested times are next and not after `time`.
    pub(crate) fn due(&self, time: f64) -> usize {
        self.times[self.taken..].partition_point(|next| *next <= time)
    }

    /// Takes the state at the next requested time.
    pub fn push(&mut self, state: &[f64]) {
        self.rows.extend_from_slice(state);
        self.taken += 1;
    }

    pub(super) fn taken(&self) -> usize {
        self.taken
    }

    pub(super) fn into_rows(self) -> Vec<f64> {
        self.rows
    }
}
