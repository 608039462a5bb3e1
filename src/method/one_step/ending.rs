//! Steps that end where a guard crosses zero.

use super::kept::Kept;
use super::{OneStep, constrain_tangents, sample};
use crate::method::sensitivity::Passing;
use crate::method::{Samples, Stopped, Stretch, Watch};

/// Outcome of a step that was to end at a zero crossing.
pub(super) enum Ending {
    /// The watch has an event to apply.
    Event,
    /// Relations changed there; the state is after the change.
    Change { time: f64 },
    /// The shorter step could not be taken.
    NotReached,
    /// The guard moves the other way there: a shorter step does not cross.
    OfError,
}

/// Retakes the current step to end at a zero crossing, and leaves events to the watch.
pub(super) fn end_at(
    method: &mut dyn OneStep,
    stretch: &Stretch<'_>,
    (from, until): (f64, f64),
    passing: f64,
    state: &mut [f64],
    samples: &mut Samples<'_>,
) -> Result<Ending, Stopped> {
    let Some(watch) = stretch.watch else { return Ok(Ending::NotReached) };
    // The time left is below the resolution: no step is so short.
    let is_short = until - from <= 1e3 * f64::EPSILON * until.abs();
    if passing - from <= 4.0 * f64::EPSILON * passing.abs() {
        watch.copy_start(state);
        watch.enter_counts(from, state);
        if !is_short && watch.is_of_error(from, state) {
            return Ok(Ending::OfError);
        }
        stretch.count_rejected(from)?;
        watch.happens(from, passing, state);
        return change(stretch, watch, from, state);
    }
    method.is_last(true);
    let Some(time) = correct(method, watch, (from, until), passing) else {
        return Ok(Ending::NotReached);
    };
    if !is_short && watch.is_of_error(time, method.end()) {
        return Ok(Ending::OfError);
    }
    if let Some(tangents) = stretch.system.tangents()
        && !tangents.carry(method, 0.0).is_good()
    {
        return Ok(Ending::NotReached);
    }
    stretch.system.count_step();
    if let Some(cause) = stretch.out_of_steps(time) {
        return Err(Stopped { time, cause });
    }
    let mut kept = Kept::new(state);
    kept.put_back(method, stretch, time)?;
    constrain_tangents(stretch, time, &kept.end);
    watch.tally(method, time)?;
    sample(method, stretch, (time, &kept.end), state, samples)?;
    stretch.system.tangents().inspect(|tangents| tangents.accept());
    state.copy_from_slice(&kept.end);
    watch.enter_counts(time, state);
    watch.happens(time, passing, state);
    change(stretch, watch, time, state)
}

/// Changes relations without leaving the method, if nothing else happens.
fn change(
    stretch: &Stretch<'_>,
    watch: &Watch<'_>,
    time: f64,
    state: &mut [f64],
) -> Result<Ending, Stopped> {
    // Parts that are held in modes may come to rest or start to move, and surfaces need other
    // methods.
    if !watch.is_of_kinks() || stretch.system.constraints().is_some() {
        return Ok(Ending::Event);
    }
    let (system, slides) = (stretch.system, stretch.system.slides());
    let front = system.moment(time, state);
    watch.switch(state)?;
    let impulses = system.pass_inertia(watch, &front, state)?;
    system.account(&front, impulses.supplied, state);
    if let Some(tangents) = system.tangents() {
        let passing = Passing { time, before: &front.state };
        tangents.cross(stretch, watch, &passing, (state, false))?;
    }
    if slides != system.slides() {
        watch.goes_on_elsewhere(time);
        return Ok(Ending::Event);
    }
    Ok(Ending::Change { time })
}

/// Takes steps to a zero of a guard, corrected by Newton's method. Returns the end time of the last
/// one.
fn correct(
    method: &mut dyn OneStep,
    watch: &Watch<'_>,
    (from, until): (f64, f64),
    passing: f64,
) -> Option<f64> {
    let corrections = watch.corrections();
    let mut time = passing;
    for round in 0..=corrections {
        if !method.attempt(time - from).is_good() {
            return None;
        }
        let Some(correction) = watch.correction(time, method.end()) else { break };
        let corrected = (time + correction).min(until);
        if correction.abs() <= 4.0 * f64::EPSILON * time.abs() || corrected <= from {
            break;
        }
        let is_near = correction.abs() <= 1e-3 * (until - from);
        if is_near && round < corrections {
            time = corrected;
            continue;
        }
        // Newton's method must leave less than it began with; otherwise the guard here is not what
        // it was along the way.
        let is_nearer = correction.abs() <= 1e-3 * (passing - from);
        if !(is_near && is_nearer) && watch.has_passed_at(time, method.end()) {
            return earlier(method, watch, from, time);
        }
        break;
    }
    if !watch.is_short_of(time, method.end()) {
        return Some(time);
    }
    let found = beyond(method, watch, (from, until), time);
    if found.is_none() && !method.attempt(time - from).is_good() {
        return None;
    }
    Some(found.unwrap_or(time))
}

/// Takes steps that end where a guard has just crossed, between the start and a time at which it is
/// far beyond.
fn earlier(method: &mut dyn OneStep, watch: &Watch<'_>, from: f64, mut high: f64) -> Option<f64> {
    let resolved = 4.0 * f64::EPSILON * high.abs().max(high - from);
    let mut low = from;
    while high - low > resolved {
        let middle = low + 0.5 * (high - low);
        if !method.attempt(middle - from).is_good() {
            return None;
        }
        if watch.has_passed_at(middle, method.end()) {
            high = middle;
        } else {
            low = middle;
        }
        let there = watch.correction(middle, method.end()).map_or(f64::NAN, |by| middle + by);
        if (there - middle).abs() <= 1e-3 * (high - low) && low <= there && there <= high {
            high = there;
            break;
        }
    }
    method.attempt(high - from).is_good().then_some(high)
}

/// Takes steps that end ever further after `time`, before which a guard is too steep for Newton's
/// method, until one crosses; then as close as time resolves.
fn beyond(
    method: &mut dyn OneStep,
    watch: &Watch<'_>,
    (from, until): (f64, f64),
    time: f64,
) -> Option<f64> {
    let resolved = 4.0 * f64::EPSILON * time.abs().max(time - from);
    let (mut low, mut high, mut by) = (time, until, resolved);
    while low < until {
        let next = (low + by).min(until);
        if !method.attempt(next - from).is_good() {
            return None;
        }
        if !watch.is_short_of(next, method.end()) {
            high = next;
            break;
        }
        (low, by) = (next, 4.0 * by);
    }
    if low >= until {
        return None;
    }
    while high - low > resolved {
        let middle = low + 0.5 * (high - low);
        if !method.attempt(middle - from).is_good() {
            return None;
        }
        if watch.is_short_of(middle, method.end()) {
            low = middle;
        } else {
            high = middle;
        }
    }
    method.attempt(high - from).is_good().then_some(high)
}
