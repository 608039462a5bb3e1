//! The driver of all one-step methods: step sizes, samples, limits and failures.
//! A method itself only tries steps.

mod ending;
mod kept;

use machinist_contract::Real;

use super::{Samples, Stopped, Stretch, Watch};
use crate::error::StopCause;
use crate::method::sensitivity::Tangents;
use ending::{Ending, end_at};
use kept::Kept;

/// A method that needs nothing but the state at the start of a step.
pub(crate) trait OneStep {
    /// Makes `state` at `time` the start of the next step.
    fn begin(&mut self, time: f64, state: &[f64]);

    /// A first step for [`OneStep::begin`]'s start.
    fn first_step(&mut self) -> f64;

    /// Tries a step from the start; it becomes the current step.
    fn attempt(&mut self, step: f64) -> Trial;

    /// Whether no step will follow those that are tried from now on: after them the
    /// method may only be asked for their ends and what is before, or to try another.
    fn is_last(&mut self, _is_last: bool) {}

    /// Holds errors of steps to a relative tolerance from now on, where a method can and that is
    /// less than its own; to what is absolute in proportion.
    #[cfg(feature = "implicit")]
    fn hold_to(&mut self, _rtol: f64) {}

    /// State at the end of the current step.
    fn end(&self) -> &[f64];

    /// State at `time` within the current step.
    fn interpolate(&mut self, time: f64, state: &mut [f64]);

    /// The error half way through the current step, between its ends, over what is
    /// allowed there, [`BETWEEN`] times the tolerances; asked where samples or events may
    /// lie, and told whether samples do.
    ///
    /// The error of a step's end says nothing of states between, where a stiff machine
    /// follows its excitation: any end is then right, and steps grow without bound.
    fn error_between(&mut self, _is_sampled: bool) -> f64 {
        0.0
    }

    /// Takes the current step: its end is the start of the next one.
    fn accept(&mut self);

    /// How the error grows with the step.
    fn pace(&self) -> Pace;

    /// The next step after [`OneStep::accept`], of a method that can tell it from what
    /// it knows of the solution and not from the last step's error.
    fn own_step(&mut self) -> Option<f64> {
        None
    }

    /// Whether states within a step are right, up to a kink, also where its end is not: those
    /// of a method that knows the solution before it steps.
    fn knows_ahead(&self) -> bool {
        false
    }

    /// Whether much less is known of the solution ahead than is wanted, by a method that knows it
    /// before it steps.
    #[cfg(feature = "implicit")]
    fn is_cut_short(&self) -> bool {
        false
    }

    /// Carries sensitivities over the current step, from its start to its end; gives their
    /// error over what is allowed, as [`Tangents::error`] has it.
    fn carry(&mut self, _tangents: &Tangents<'_>, _start: &[f64], _end: &mut [f64]) -> f64 {
        unreachable!("a method that does not carry sensitivities is refused before it steps")
    }

    /// Sensitivities at `time` within the current step, over which they were carried from
    /// `start`.
    fn tangents_at(
        &mut self,
        _tangents: &Tangents<'_>,
        _time: f64,
        _start: &[f64],
        _into: &mut [f64],
    ) {
        unreachable!("a method that does not carry sensitivities is refused before it steps")
    }

    /// In so many parts of a step guards are looked at.
    fn parts(&self) -> usize {
        4
    }
}

/// States between the ends of steps may err by so many tolerances.
#[cfg(feature = "implicit")]
pub(super) const BETWEEN: f64 = 10.0;

/// So many steps at least from end to end of a stretch where nothing moves: what begins later
/// must not be stepped over.
pub(super) const LOOKS: f64 = 100.0;

/// Whether nothing has moved over a step, by more than a small part of the absolute tolerances.
pub(super) fn rests(moves: impl Iterator<Item = (f64, f64)>, atol: &[f64]) -> bool {
    moves.zip(atol).all(|((start, end), atol)| (end - start).abs() <= resting(*atol))
}

/// By how much a state of an absolute tolerance moves at most while it rests.
pub(super) fn resting(atol: f64) -> f64 {
    const PART: f64 = 1e-3;
    PART * atol
}

/// What came of a step.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Trial {
    /// The error over what the tolerances allow; the step is good if that is at
    /// most 1.
    Error(f64),
    /// Something of the `index`-th state is not finite.
    NotFinite { what: &'static str, index: usize },
    /// The step's equations could not be solved; `shrink` times the step may do.
    #[cfg_attr(
        not(any(feature = "implicit", test)),
        expect(dead_code, reason = "only implicit methods solve")
    )]
    Unsolved { shrink: f64 },
}

impl Trial {
    fn is_good(&self) -> bool {
        matches!(self, Trial::Error(error) if *error <= 1.0)
    }
}

/// How a step size follows from errors: after error e of step h and error e' of
/// the one before, the next is `safety` h e^-exponent e'^memory, within limits
/// (a PI controller, Hairer, Norsett, Wanner, section II.4 and IV.2).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pace {
    pub(super) exponent: f64,
    pub(super) memory: f64,
    pub(super) safety: f64,
    pub(super) smallest: f64,
    pub(super) largest: f64,
    /// A step that would grow by less than this stays, and so do the factors of its
    /// matrix; 1 if there are none to keep.
    pub(super) hold: f64,
}

/// Where [`drive`] ended before the end of the stretch because it was told to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Left {
    /// Time reached \[s\].
    pub(super) time: f64,
    /// The step it would have tried next \[s\].
    pub(super) step: f64,
}

/// Carries `state` from `from` to the end of the stretch by steps of `method`;
/// `leave` is asked after every step with the step taken whether to stop there.
pub(super) fn drive<M: OneStep>(
    method: &mut M,
    stretch: &Stretch<'_>,
    from: Left,
    state: &mut [f64],
    samples: &mut Samples<'_>,
    mut leave: impl FnMut(&M, f64) -> bool,
) -> Result<Option<Left>, Stopped> {
    require_possible_tolerance(stretch, state)?;
    let (mut time, mut step) = (from.time, from.step);
    let mut last_error = 1e-4;
    let mut before = None;
    let mut rejected = false;
    let mut kept = Kept::new(state);
    loop {
        let End { now, tried, arrives } = end_of_step(time, step, stretch.until);
        let arrives = arrives > 0.0;
        method.is_last(arrives);
        // Every pass, whatever it leads to.
        stretch.require_uninterrupted(time)?;
        let trial = attempt(method, stretch, samples, (tried, now));
        let pace = method.pace();
        let is_good = trial.is_good();
        let passing = passing(method, stretch, now, is_good);
        if is_good && let Some(share) = stretch.watch.and_then(Watch::share_that_is_told) {
            stretch.count_rejected(time)?;
            (step, rejected) = (share * tried, true);
            continue;
        }
        if let Trial::Error(error) = trial
            && (is_good || passing.is_some())
        {
            if let Some(passing) = passing {
                match end_at(method, stretch, (time, now), passing, state, samples)? {
                    Ending::Event => return Ok(None),
                    Ending::Kink { time: behind } => {
                        begin_behind(method, stretch, &mut kept, (behind, state));
                        step = method.own_step().unwrap_or(tried);
                        (time, before, rejected) = (behind, None, false);
                        if stretch.leaps_to_end(behind, state, samples) {
                            return Ok(None);
                        }
                        // There may be no end of a step but at kinks.
                        stretch.require_fewer_passes(behind)?;
                        continue;
                    }
                    Ending::NotReached => {}
                }
                stretch.count_rejected(time)?;
                step = 0.5 * (passing - time);
                rejected = true;
                if is_too_small(step, time) {
                    let from = (time, &mut *state);
                    match leap_on(method, stretch, &mut kept, from, samples)? {
                        Leap::ToEnd => return Ok(None),
                        Leap::Behind(behind) => (time, step, before) = (behind, tried, None),
                        Leap::Nowhere => return Err(explain(stretch, trial, (time, &kept.end))),
                    }
                }
                continue;
            }
            stretch.system.count_step();
            let moves = kept.end.iter().copied().zip(method.end().iter().copied());
            let stood_still = rests(moves.take(stretch.system.states()), stretch.atol);
            let has_moved = kept.put_back(method, stretch, now)?;
            stretch.require_bounded(now, &kept.end)?;
            constrain_tangents(stretch, now, &kept.end);
            sample(method, stretch, (now, &kept.end), state, samples)?;
            method.accept();
            stretch.system.tangents().inspect(|tangents| tangents.accept());
            let factor = pace.factor(pace.believed(error, tried, before), last_error);
            let factor = if rejected { factor.min(1.0) } else { factor };
            step = method.own_step().unwrap_or(tried * factor);
            if stood_still {
                step = step.min(stretch.looked_at() / LOOKS);
            }
            last_error = error.max(1e-4);
            before = Some((tried, error));
            rejected = false;
            time = now;
            let is_enough = leave(method, tried);
            if has_moved {
                method.begin(now, &kept.end);
                stretch.watch.inspect(|watch| watch.start(now, &kept.end));
            }
            if arrives || is_enough {
                state.copy_from_slice(&kept.end);
                return Ok((!arrives).then_some(Left { time, step }));
            }
            stretch.require_wanted(time, &kept.end)?;
            if let Some(cause) = stretch.leads_nowhere(step, time, &kept.end) {
                return Err(Stopped { time, cause });
            }
        } else {
            stretch.count_rejected(time)?;
            step = tried * shrink(trial, pace);
            rejected = true;
            if is_too_small(step, time) {
                let from = (time, &mut *state);
                match leap_on(method, stretch, &mut kept, from, samples)? {
                    Leap::ToEnd => return Ok(None),
                    Leap::Behind(behind) => {
                        (time, step, before) = (behind, method.first_step(), None);
                    }
                    Leap::Nowhere => return Err(explain(stretch, trial, (time, &kept.end))),
                }
            }
        }
    }
}

/// Where a run goes on from which no step can be taken.
enum Leap {
    /// No more than rounding was left of the stretch.
    ToEnd,
    /// At this time, behind kinks that were nearer than time resolves.
    Behind(f64),
    Nowhere,
}

/// Goes on from the end of the last step, if that needs no step.
fn leap_on(
    method: &mut dyn OneStep,
    stretch: &Stretch<'_>,
    kept: &mut Kept,
    (time, state): (f64, &mut [f64]),
    samples: &mut Samples<'_>,
) -> Result<Leap, Stopped> {
    state.copy_from_slice(&kept.end);
    if stretch.leaps_to_end(time, state, samples) {
        return Ok(Leap::ToEnd);
    }
    let Some(behind) = stretch.leaps_over_kinks(time, state)? else { return Ok(Leap::Nowhere) };
    begin_behind(method, stretch, kept, (behind, state));
    Ok(Leap::Behind(behind))
}

/// Begins anew behind a kink.
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

/// Tries a step that ends at `now`; its error is also that of what is wanted between its ends,
/// and of sensitivities.
fn attempt(
    method: &mut dyn OneStep,
    stretch: &Stretch<'_>,
    samples: &Samples<'_>,
    (step, now): (f64, f64),
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
    match (trial, stretch.system.tangents()) {
        (Trial::Error(error), Some(tangents)) if error <= 1.0 => tangents.carry(method, error),
        _ => trial,
    }
}

/// Where a guard passes first within the current step, which ends at `now`.
fn passing(
    method: &mut dyn OneStep,
    stretch: &Stretch<'_>,
    now: f64,
    is_good: bool,
) -> Option<f64> {
    let watch = stretch.watch?;
    if is_good {
        watch.first_passing(method, now)
    } else if method.knows_ahead() {
        watch.kink_within(method, now)
    } else {
        None
    }
}

/// The whole stretch at once, from its start.
pub(super) fn drive_all<M: OneStep>(
    method: &mut M,
    stretch: &Stretch<'_>,
    state: &mut [f64],
    samples: &mut Samples<'_>,
) -> Result<(), Stopped> {
    method.begin(stretch.from, state);
    let start = Left { time: stretch.from, step: method.first_step() };
    drive(method, stretch, start, state, samples, |_, _| false).map(|_| ())
}

impl Pace {
    /// The error to choose the next step by, after an error at a step and, before that,
    /// a step and its error.
    ///
    /// An estimate is a number that changes its sign, and passes through zero now and
    /// then where the error does not: in a fast oscillation as often as once in a few
    /// hundred steps. A step that grew by that would be far too long, and might be
    /// accepted by the same chance. So an error that is suddenly far below what the step
    /// before foretells is not believed at once.
    fn believed(&self, error: f64, step: f64, before: Option<(f64, f64)>) -> f64 {
        const LUCK: f64 = 1e-2;
        let foretold = |(step_before, error): (f64, f64)| {
            error * (step / step_before).powf(1.0 / self.exponent)
        };
        before.map_or(error, |before| error.max(LUCK * foretold(before)))
    }

    fn factor(&self, error: f64, last_error: f64) -> f64 {
        let wanted = self.safety * error.powf(-self.exponent) * last_error.powf(self.memory);
        // An error of zero wants an infinite step; a NaN cannot be.
        let factor = wanted.min(self.largest).max(self.smallest);
        if (1.0..=self.hold).contains(&factor) { 1.0 } else { factor }
    }
}

/// The end of a step.
pub(super) struct End<R> {
    pub(super) now: R,
    pub(super) tried: R,
    /// Whether it is the end of the stretch: 1 or 0.
    pub(super) arrives: R,
}

/// The end of a step from `time`. What is left of the stretch is halved rather than cut
/// into a step and a sliver.
#[inline(always)]
pub(super) fn end_of_step<R: Real>(time: R, step: R, until: R) -> End<R> {
    let [zero, one, half, near] = [0.0, 1.0, 0.5, 0.99].map(R::literal);
    let remaining = until - time;
    let part = R::select_less(remaining, step + step, half * remaining, step);
    // What the clock advances is what is stepped, to the last bit.
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

/// Puts sensitivities, if there are any, at the end of the current step onto what constraints
/// leave free in a state on them.
fn constrain_tangents(stretch: &Stretch<'_>, now: f64, end: &[f64]) {
    if let Some(tangents) = stretch.system.tangents() {
        tangents.constrain_end(stretch, now, end);
    }
}

/// Pushes what is wanted until the end of the current step, `now`, all of it on the
/// constraints.
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
            samples.push(end);
        } else {
            method.interpolate(time, scratch);
            if let Some(index) = scratch.iter().position(|value| !value.is_finite()) {
                return Err(stretch.not_finite("the state", index, time));
            }
            stretch.constrain(time, scratch)?;
            tangents.inspect(|tangents| tangents.sample(method, stretch, time, scratch));
            samples.push(scratch);
        }
    }
    Ok(())
}

/// Whether time would hardly move, or the step is below all sense at time zero.
pub(super) fn is_too_small(step: f64, time: f64) -> bool {
    const ROUNDINGS: f64 = 10.0;
    step.is_nan() || step <= ROUNDINGS * f64::EPSILON * time.abs() || step < 1e-100
}

/// The cause behind steps that shrank to nothing.
fn explain(stretch: &Stretch<'_>, trial: Trial, (time, state): (f64, &[f64])) -> Stopped {
    let cause = match trial {
        Trial::NotFinite { what, index } => return stretch.not_finite(what, index, time),
        Trial::Unsolved { .. } => StopCause::Newton,
        Trial::Error(_) => StopCause::StepTooSmall,
    };
    Stopped { time, cause: stretch.cause_at(time, state, cause) }
}

/// Refuses tolerances that rounding alone exceeds: error estimates would be
/// noise, and steps accepted and rejected by chance.
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

/// A first step by the size of the rate and of its change over a trial step
/// (Hairer, Norsett, Wanner, section II.4); `order` is the method's.
///
/// `rate` is f(t, y) at the start; `trial` and `trial_rate` are scratch; all of them
/// without quadratures.
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

/// Root mean square of `error` over what the tolerances allow between the states
/// `before` and `after`.
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

/// Sum of (error/scale)^2, as four sums that do not wait for each other.
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

/// df/dy at a state, in pattern order.
///
/// # Errors
/// [`Trial::NotFinite`] if an entry is not finite.
#[cfg(feature = "implicit")]
pub(super) fn finite_jacobian(
    stretch: &Stretch<'_>,
    time: f64,
    state: &[f64],
    jacobian: &mut [f64],
) -> Result<(), Trial> {
    stretch.jacobian(time, state, jacobian);
    match first_not_finite(jacobian) {
        None => Ok(()),
        Some(entry) => {
            let (row, _) = stretch.system.jacobian_pattern().entries[entry];
            let what = "the Jacobian of the rate of";
            Err(Trial::NotFinite { what, index: row as usize })
        }
    }
}

/// Refuses values that are not finite.
///
/// # Errors
/// [`Trial::NotFinite`] with the first of them.
#[cfg(feature = "implicit")]
pub(super) fn require_finite(what: &'static str, values: &[f64]) -> Result<(), Trial> {
    match first_not_finite(values) {
        None => Ok(()),
        Some(index) => Err(Trial::NotFinite { what, index }),
    }
}

/// The first of many values that is not finite: looked for only where there is one, for
/// that can be told of all at once.
pub(super) fn first_not_finite(values: &[f64]) -> Option<usize> {
    let is_wrong = values.iter().fold(false, |wrong, value| wrong | !value.is_finite());
    if is_wrong { values.iter().position(|value| !value.is_finite()) } else { None }
}

#[cfg(test)]
mod tests;
