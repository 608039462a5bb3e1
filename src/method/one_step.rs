//! The driver of all one-step methods: step sizes, samples, limits and failures. A method itself
//! only tries steps.

mod bends;
mod change_point;
mod control;
mod ending;
mod finite;
mod kept;

use machinist_contract::Real;

use super::{Samples, Stopped, Stretch, Watch};
use crate::error::StopCause;
use crate::method::sensitivity::Tangents;
use change_point::{Past, past};
use control::Control;
pub(crate) use control::Pace;
use ending::{Ending, end_at};
pub(super) use finite::first_not_finite;
#[cfg(feature = "implicit")]
pub(super) use finite::{finite_jacobian, require_finite};
use kept::{Kept, put_back_between};

/// A method that needs only the state at the start of a step.
pub(crate) trait OneStep {
    /// Makes `state` at `time` the start of the next step.
    fn begin(&mut self, time: f64, state: &[f64]);

    /// Returns a first step from the start given by [`OneStep::begin`].
    fn first_step(&mut self) -> f64;

    /// Tries a step from the start; it becomes the current step.
    fn attempt(&mut self, step: f64) -> Trial;

    /// Tells the method that no further step will follow those tried from now on. Afterwards the
    /// method is asked only for their ends and the states before them, or to try another step.
    fn is_last(&mut self, _is_last: bool) {}

    /// Returns the state at the end of the current step.
    fn end(&self) -> &[f64];

    /// Computes the state at `time` within the current step.
    fn interpolate(&mut self, time: f64, state: &mut [f64]);

    /// Computes the state at `time` within the current step, less accurately if that saves
    /// evaluations of the rate.
    fn sketch(&mut self, time: f64, state: &mut [f64]) {
        self.interpolate(time, state);
    }

    /// Returns whether the method itself checks its steps where functions that were flat bend.
    fn sees_bends(&self) -> bool {
        false
    }

    /// Computes the states at several times within the current step, one after another.
    fn interpolate_each(&mut self, times: &[f64], states: &mut [f64]) {
        let size = states.len() / times.len().max(1);
        for (time, state) in times.iter().zip(states.chunks_exact_mut(size)) {
            self.interpolate(*time, state);
        }
    }

    /// Computes how far each state may be from its start anywhere within the current step.
    ///
    /// The default takes the dense output at quarters of the step. A step resolves the motion, so
    /// twice the largest distance seen there covers what lies between.
    fn reach(&mut self, [from, until]: [f64; 2], start: &[f64], reach: &mut [f64]) {
        const SHARES: [f64; 3] = [0.25, 0.5, 0.75];
        for (reach, (start, end)) in reach.iter_mut().zip(start.iter().zip(self.end())) {
            *reach = 2.0 * (end - start).abs();
        }
        let mut within = start.to_vec();
        for share in SHARES {
            self.interpolate(from + share * (until - from), &mut within);
            for (reach, (start, within)) in reach.iter_mut().zip(start.iter().zip(&within)) {
                *reach = reach.max(2.0 * (within - start).abs());
            }
        }
    }

    /// Returns the error at the middle of the current step, over its limit of [`BETWEEN`] times the
    /// tolerances. It is requested where samples or events may lie within the step; the argument is
    /// true for samples.
    ///
    /// The error at the end of a step says nothing of states in between if a stiff machine follows
    /// its excitation: any end is then right, and steps grow without bound.
    fn error_between(&mut self, _is_sampled: bool) -> f64 {
        0.0
    }

    /// Returns a watched function at a time within the current step, for a method that knows it
    /// without the state.
    fn value(&mut self, _of: Bounded, _time: f64) -> Option<f64> {
        None
    }

    /// Returns the largest value that the derivative of an order of a watched function may have from
    /// the start of the current step to a time within it, for a method that knows this.
    fn bound(&mut self, _of: Bounded, _order: usize, _until: f64) -> Option<f64> {
        None
    }

    /// Accepts the current step: its end becomes the start of the next one.
    fn accept(&mut self);

    /// Returns the relation between error and step size.
    fn pace(&self) -> Pace;

    /// Returns the step after [`OneStep::accept`], for a method that derives it from the solution
    /// and not from the error of the last step.
    fn own_step(&mut self) -> Option<f64> {
        None
    }

    /// Returns whether the solution ahead is known much less than wanted, for a method that knows
    /// this before a step.
    #[cfg(feature = "implicit")]
    fn is_cut_short(&self) -> bool {
        false
    }

    /// Returns whether the method itself is a step past a change point.
    fn passes_change_points(&self) -> bool {
        false
    }

    /// Carries sensitivities over the current step, from its start to its end. Returns their error
    /// over the tolerances, as defined by [`Tangents::error`].
    fn carry(&mut self, _tangents: &Tangents<'_>, _start: &[f64], _end: &mut [f64]) -> f64 {
        unreachable!("a method that does not carry sensitivities is refused before it steps")
    }

    /// Computes the sensitivities at `time` within the current step, over which they were carried
    /// from `start`.
    fn tangents_at(
        &mut self,
        _tangents: &Tangents<'_>,
        _time: f64,
        _start: &[f64],
        _into: &mut [f64],
    ) {
        unreachable!("a method that does not carry sensitivities is refused before it steps")
    }
}

/// A watched function of which a method may know bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Bounded {
    /// Guard of an event, or counted after these, of a kink.
    Guard(usize),
    /// Share of the rate above in a motion that slides along the surface of a relation.
    Share(usize),
}

/// Factor for the tolerances of states between the ends of steps.
#[cfg(feature = "implicit")]
pub(super) const BETWEEN: f64 = 10.0;

/// Minimum number of steps in a stretch in which nothing moves, so that no later start is stepped
/// over.
pub(super) const LOOKS: f64 = 100.0;

/// Returns whether no state moved over a step by more than a small share of its absolute tolerance.
pub(super) fn rests(moves: impl Iterator<Item = (f64, f64)>, atol: &[f64]) -> bool {
    moves.zip(atol).all(|((start, end), atol)| (end - start).abs() <= resting(*atol))
}

/// Returns the largest move at rest of a state with an absolute tolerance.
pub(super) fn resting(atol: f64) -> f64 {
    const PART: f64 = 1e-3;
    PART * atol
}

/// Result of a step.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Trial {
    /// The error over the tolerances; the step is good if it is at most 1.
    Error(f64),
    /// A value of the `index`-th state is not finite.
    NotFinite { what: &'static str, index: usize },
    /// The equations of the step could not be solved, or it passes over a bend; `shrink` times the
    /// step may work.
    Unsolved { shrink: f64 },
}

impl Trial {
    fn is_good(&self) -> bool {
        matches!(self, Trial::Error(error) if *error <= 1.0)
    }
}

/// Point at which [`drive`] was told to end before the end of the stretch.
#[derive(Debug, Clone, Copy)]
pub(super) struct ResumePoint {
    /// Time reached \[s\].
    pub(super) time: f64,
    /// The next step it would have tried \[s\].
    pub(super) step: f64,
}

/// Carries `state` from `from` to the end of the stretch by steps of `method`. After every step
/// `leave` is asked, with the step taken, whether to stop there.
pub(super) fn drive<M: OneStep>(
    method: &mut M,
    stretch: &Stretch<'_>,
    from: ResumePoint,
    state: &mut [f64],
    samples: &mut Samples<'_>,
    mut leave: impl FnMut(&M, f64) -> bool,
) -> Result<Option<ResumePoint>, Stopped> {
    require_possible_tolerance(stretch, state)?;
    let mut control = Control::from(from);
    let mut kept = Kept::with_bends(method, stretch, state);
    loop {
        let time = control.time;
        let longest = stretch.watch.map_or(f64::INFINITY, Watch::longest_step);
        let step = control.step.min(longest);
        let end = end_of_step(time, step, stretch.until);
        let End { now, tried, arrives } = control.shorten(stretch, method.pace(), end);
        let arrives = arrives > 0.0;
        method.is_last(arrives);
        // On every pass, whatever its result.
        stretch.require_uninterrupted(time)?;
        let trial = attempt(method, stretch, samples, &mut kept, [time, tried, now]);
        let pace = method.pace();
        // On every pass, whatever its result.
        stretch.require_uninterrupted(time)?;
        let error = match trial {
            Trial::Error(error) if trial.is_good() => error,
            _ => {
                control.reject(stretch, tried * shrink(trial, pace))?;
                if control.is_refused() {
                    match past(method, stretch, &mut kept, &mut control, (state, samples))? {
                        Past::Event => return Ok(None),
                        Past::ChangePoint => continue,
                        Past::Ahead(step) => control.step = control.step.min(step),
                        Past::Nothing => {}
                    }
                }
                if is_over(stretch, &kept, &control, trial, (state, samples))? {
                    return Ok(None);
                }
                continue;
            }
        };
        if let Some((watch, passing)) =
            stretch.watch.and_then(|it| Some((it, it.first_passing(method, now)?)))
        {
            if watch.is_too_long(tried) || control.shortens_to(stretch, passing) {
                stretch.count_rejected(time)?;
                continue;
            }
            let step = match end_at(method, stretch, (time, now), passing, state, samples)? {
                Ending::Event => return Ok(None),
                Ending::Change { time: behind } => {
                    begin_behind(method, stretch, &mut kept, (behind, state));
                    control.begin(behind, method.own_step().unwrap_or(tried));
                    if stretch.ends_within_rounding(behind, state, samples) {
                        return Ok(None);
                    }
                    stretch.require_fewer_passes(behind)?;
                    continue;
                }
                Ending::NotReached => 0.5 * (passing - time),
                Ending::OfError => 0.5 * tried,
            };
            control.reject(stretch, step)?;
            if is_over(stretch, &kept, &control, trial, (state, samples))? {
                return Ok(None);
            }
            continue;
        }
        let moves = kept.end.iter().copied().zip(method.end().iter().copied());
        let stood_still = rests(moves.take(stretch.system.states()), stretch.atol);
        let put_back = kept.put_back(method, stretch, now);
        if put_back.as_ref().map_or(true, |moved| moved.is_far()) {
            kept.exchange();
            control.longest = control.longest.max(tried);
            match past(method, stretch, &mut kept, &mut control, (state, samples))? {
                Past::Event => return Ok(None),
                Past::ChangePoint => continue,
                Past::Ahead(step) => {
                    control.reject(stretch, step.min(0.5 * tried))?;
                    if is_over(stretch, &kept, &control, trial, (state, samples))? {
                        return Ok(None);
                    }
                    continue;
                }
                Past::Nothing => kept.exchange(),
            }
        }
        let has_moved = put_back?.is_noticed();
        accept(method, stretch, (now, &kept.end), state, samples)?;
        control.accept(method, pace, now, (tried, error));
        if stood_still {
            control.step = control.step.min(stretch.looked_at() / LOOKS);
        }
        let is_enough = leave(method, tried);
        if has_moved {
            method.begin(now, &kept.end);
            stretch.watch.inspect(|watch| watch.put_back(now, &kept.end));
        }
        state.copy_from_slice(&kept.end);
        enter_counts(stretch, now, state);
        if arrives || is_enough {
            return Ok((!arrives).then_some(ResumePoint { time: now, step: control.step }));
        }
        stretch.require_wanted(now, state)?;
        if let Some(cause) = stretch.leads_nowhere(control.step, now, &kept.end) {
            return Err(Stopped { time: now, cause });
        }
    }
}

/// Accepts the current step with its end on the constraints, and takes samples up to it.
fn accept(
    method: &mut dyn OneStep,
    stretch: &Stretch<'_>,
    (now, end): (f64, &[f64]),
    scratch: &mut [f64],
    samples: &mut Samples<'_>,
) -> Result<(), Stopped> {
    stretch.watch.map_or(Ok(()), |watch| watch.pass(method, now))?;
    stretch.system.count_step();
    stretch.require_bounded(now, end)?;
    stretch.system.measure(end);
    constrain_tangents(stretch, now, end);
    sample(method, stretch, (now, end), scratch, samples)?;
    method.accept();
    stretch.system.tangents().inspect(|tangents| tangents.accept());
    Ok(())
}

/// Returns whether the run is over because its next step would be too small, and only rounding is
/// left of the stretch.
fn is_over(
    stretch: &Stretch<'_>,
    kept: &Kept,
    control: &Control,
    trial: Trial,
    (state, samples): (&mut [f64], &mut Samples<'_>),
) -> Result<bool, Stopped> {
    if !is_too_small(control.step, control.time) {
        return Ok(false);
    }
    if ends_within_rounding(stretch, kept, (control.time, state), samples) {
        return Ok(true);
    }
    Err(explain(stretch, trial, (control.time, &kept.end)))
}

/// Returns whether only rounding is left of the stretch after the last step; the state is then at
/// its end.
fn ends_within_rounding(
    stretch: &Stretch<'_>,
    kept: &Kept,
    (time, state): (f64, &mut [f64]),
    samples: &mut Samples<'_>,
) -> bool {
    state.copy_from_slice(&kept.end);
    enter_counts(stretch, time, state);
    stretch.ends_within_rounding(time, state, samples)
}

/// Begins a segment after a change.
fn begin_behind(
    method: &mut dyn OneStep,
    stretch: &Stretch<'_>,
    kept: &mut Kept,
    (behind, state): (f64, &[f64]),
) {
    method.begin(behind, state);
    kept.end.copy_from_slice(state);
    stretch.watch.inspect(|watch| watch.start(behind, state));
}

/// Tries a step that ends at `now`. Its error includes that of samples between its ends, and of
/// sensitivities. If functions bend within it, it shall end there.
fn attempt<M: OneStep>(
    method: &mut M,
    stretch: &Stretch<'_>,
    samples: &Samples<'_>,
    kept: &mut Kept,
    [time, step, now]: [f64; 3],
) -> Trial {
    let mut trial = method.attempt(step);
    let is_sampled = samples.next_until(now).is_some_and(|at| at < now);
    if let Trial::Error(error) = trial
        && error <= 1.0
        && (stretch.watch.is_some() || is_sampled)
    {
        let between = method.error_between(is_sampled);
        trial = Trial::Error(if between <= error { error } else { between });
    }
    if trial.is_good()
        && let Some(bend) = kept.first_bend(method, stretch, [time, now])
    {
        return Trial::Unsolved { shrink: (bend - time) / step };
    }
    match (trial, stretch.system.tangents()) {
        (Trial::Error(error), Some(tangents)) if error <= 1.0 => tangents.carry(method, error),
        _ => trial,
    }
}

/// Integrates the whole stretch from its start.
pub(super) fn drive_all<M: OneStep>(
    method: &mut M,
    stretch: &Stretch<'_>,
    state: &mut [f64],
    samples: &mut Samples<'_>,
) -> Result<(), Stopped> {
    method.begin(stretch.from, state);
    let start = ResumePoint { time: stretch.from, step: method.first_step() };
    drive(method, stretch, start, state, samples, |_, _| false).map(|_| ())
}

/// End of a step.
pub(super) struct End<R> {
    pub(super) now: R,
    pub(super) tried: R,
    /// 1 at the end of the stretch, otherwise 0.
    pub(super) arrives: R,
}

/// Returns the end of a step from `time`. The rest of the stretch is halved rather than cut into a
/// step and a sliver.
#[inline(always)]
pub(super) fn end_of_step<R: Real>(time: R, step: R, until: R) -> End<R> {
    let [zero, one, half, near] = [0.0, 1.0, 0.5, 0.99].map(R::literal);
    let remaining = until - time;
    let part = R::select_less(remaining, step + step, half * remaining, step);
    // The clock advances by exactly the step.
    let tried = time + part - time;
    let or = |inside, end| R::select_less(step, near * remaining, inside, end);
    End { now: or(time + tried, until), tried: or(tried, remaining), arrives: or(zero, one) }
}

pub(super) fn shrink(trial: Trial, pace: Pace) -> f64 {
    match trial {
        Trial::Error(error) if error.is_finite() => {
            (pace.safety * error.powf(-pace.exponent)).clamp(pace.smallest, 0.9)
        }
        Trial::Error(_) | Trial::NotFinite { .. } => 0.2,
        Trial::Unsolved { shrink } => shrink,
    }
}

/// Projects sensitivities at the end of the current step onto the tangent space of the constraints,
/// if there are any, at a state on them.
fn constrain_tangents(stretch: &Stretch<'_>, now: f64, end: &[f64]) {
    if let Some(tangents) = stretch.system.tangents() {
        tangents.constrain_end(stretch, now, end);
    }
}

/// Pushes the samples up to the end of the current step, `now`, all of them on the constraints.
fn sample(
    method: &mut dyn OneStep,
    stretch: &Stretch<'_>,
    (now, end): (f64, &[f64]),
    scratch: &mut [f64],
    samples: &mut Samples<'_>,
) -> Result<(), Stopped> {
    while let Some(time) = samples.next_until(now) {
        let tangents = stretch.system.tangents();
        if time >= now {
            tangents.inspect(|tangents| tangents.sample_end());
            scratch.copy_from_slice(end);
        } else {
            method.interpolate(time, scratch);
            if let Some(index) = scratch.iter().position(|value| !value.is_finite()) {
                return Err(stretch.not_finite("the state", index, time));
            }
            put_back_between(stretch, time, scratch);
            tangents.inspect(|tangents| tangents.sample(method, stretch, time, scratch));
        }
        // Samples at the time of an event show the state before it.
        enter_counts(stretch, time.next_down(), scratch);
        samples.push(scratch);
    }
    Ok(())
}

/// Enters the values of counters at a time within the current step into a state.
fn enter_counts(stretch: &Stretch<'_>, time: f64, state: &mut [f64]) {
    stretch.watch.inspect(|watch| watch.enter_counts(time, state));
}

/// Returns whether time would hardly advance, or the step is meaninglessly small at time zero.
pub(super) fn is_too_small(step: f64, time: f64) -> bool {
    const ROUNDINGS: f64 = 10.0;
    step.is_nan() || step <= ROUNDINGS * f64::EPSILON * time.abs() || step < 1e-100
}

/// Returns the cause of steps that shrank to nothing.
fn explain(stretch: &Stretch<'_>, trial: Trial, (time, state): (f64, &[f64])) -> Stopped {
    let cause = match trial {
        Trial::NotFinite { what, index } => return stretch.not_finite(what, index, time),
        Trial::Unsolved { .. } => StopCause::Newton,
        Trial::Error(_) => StopCause::StepTooSmall,
    };
    Stopped { time, cause: stretch.cause_at(time, state, cause) }
}

/// Refuses tolerances below rounding: error estimates would be noise, and steps would be accepted
/// and rejected by chance.
fn require_possible_tolerance(stretch: &Stretch<'_>, state: &[f64]) -> Result<(), Stopped> {
    const ROUNDINGS: f64 = 4.0;
    let simulator = stretch.system.simulator();
    let impossible = (0..stretch.system.states()).any(|index| {
        let size = state[index].abs().max(simulator.state_scale(index));
        stretch.rtol * size + stretch.atol[index] < ROUNDINGS * f64::EPSILON * size
    });
    if impossible {
        let cause = StopCause::ToleranceBelowRounding { rtol: stretch.rtol };
        return Err(Stopped { time: stretch.from, cause });
    }
    Ok(())
}

/// Returns a first step from the size of the rate and its change over a trial step (Hairer,
/// Norsett, Wanner, section II.4); `order` is that of the method.
///
/// `rate` is f(t, y) at the start; `trial` and `trial_rate` are scratch; all of them without
/// quadratures.
pub(super) fn first_step(
    stretch: &Stretch<'_>,
    order: u32,
    time: f64,
    (state, rate): (&[f64], &[f64]),
    (trial, trial_rate): (&mut [f64], &mut [f64]),
) -> f64 {
    let size = |values: &mut dyn Iterator<Item = f64>| {
        let weighted = values.zip(state).zip(stretch.atol).map(|((value, state), atol)| {
            let ratio = value / (atol + stretch.rtol * state.abs());
            ratio * ratio
        });
        (weighted.sum::<f64>() / state.len() as f64).sqrt()
    };
    let span = stretch.until - time;
    let of_state = size(&mut state.iter().copied());
    let of_rate = size(&mut rate.iter().copied());
    let guess = if of_state < 1e-5 || of_rate < 1e-5 { 1e-6 } else { 0.01 * of_state / of_rate };
    let guess = if guess.is_finite() { guess.min(span) } else { 1e-6 * span };
    for ((trial, state), rate) in trial.iter_mut().zip(state).zip(rate) {
        *trial = state + guess * rate;
    }
    stretch.state_rate(time + guess, trial, trial_rate);
    let change = size(&mut trial_rate.iter().zip(rate).map(|(ahead, rate)| ahead - rate)) / guess;
    let largest = of_rate.max(change);
    let step = if largest.is_nan() {
        1e-3 * guess
    } else if largest <= 1e-15 {
        (guess * 1e-3).max(1e-6)
    } else {
        (0.01 / largest).powf(1.0 / f64::from(order))
    };
    let step = step.min(100.0 * guess).min(span);
    if step > 0.0 && step.is_finite() { step } else { 1e-6 * span }
}

/// Returns the root mean square of `error` over the tolerances between the states `before` and
/// `after`.
pub(super) fn weighted_norm(
    stretch: &Stretch<'_>,
    error: &[f64],
    before: &[f64],
    after: &[f64],
) -> f64 {
    let mut sum = 0.0;
    for (((error, before), after), atol) in error.iter().zip(before).zip(after).zip(stretch.atol) {
        let ratio = error / (atol + stretch.rtol * before.abs().max(after.abs()));
        sum += ratio * ratio;
    }
    (sum / error.len() as f64).sqrt()
}

/// Returns the sum of (error/scale)^2, as four independent sums.
#[cfg(feature = "implicit")]
pub(super) fn sum_of_squares(errors: &[f64], scales: &[f64]) -> f64 {
    let square = |(error, scale): (&f64, &f64)| (error / scale) * (error / scale);
    let (blocks, rest) = errors.as_chunks::<4>();
    let (scales, rest_scales) = scales[..errors.len()].as_chunks::<4>();
    let mut sums = [0.0; 4];
    for pair in blocks.iter().zip(scales) {
        for (sum, pair) in sums.iter_mut().zip(pair.0.iter().zip(pair.1)) {
            *sum += square(pair);
        }
    }
    let rest: f64 = rest.iter().zip(rest_scales).map(square).sum();
    sums.iter().sum::<f64>() + rest
}

#[cfg(test)]
mod tests;
