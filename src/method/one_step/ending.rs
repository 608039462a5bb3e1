//! Steps that end where a guard passes zero.

use super::kept::Kept;
use super::{OneStep, constrain_tangents, sample};
use crate::method::sensitivity::{Passing, moment};
use crate::method::{Samples, Stopped, Stretch, Watch};

/// What became of a step that was to end where a guard passes zero.
pub(super) enum Ending {
    /// There is an event for the watch.
    Event,
    /// It ended at a kink; the state is behind it now.
    Kink { time: f64 },
    /// That shorter step could not be taken.
    NotReached,
}

/// Takes the current step anew, so that it ends where a guard passes zero, and leaves
/// the rest to the watch.
pub(super) fn end_at(
    method: &mut dyn OneStep,
    stretch: &Stretch<'_>,
    (from, until): (f64, f64),
    passing: f64,
    state: &mut [f64],
    samples: &mut Samples<'_>,
) -> Result<Ending, Stopped> {
    let Some(watch) = stretch.watch else { return Ok(Ending::NotReached) };
    if passing <= from {
        watch.copy_start(state);
        stretch.system.tangents().inspect(|tangents| tangents.comes_from(from, state));
        watch.happens(from, passing, state);
        return Ok(Ending::Event);
    }
    // Less than what time resolves is left until there: no step is so short.
    let is_there = passing - from <= 4.0 * f64::EPSILON * passing.abs();
    if is_there && watch.passes_kink() && stretch.system.tangents().is_none() {
        watch.copy_start(state);
        stretch.system.count_step();
        if let Some(cause) = stretch.out_of_steps(from) {
            return Err(Stopped { time: from, cause });
        }
        watch.happens(from, passing, state);
        let Some((behind, _)) = watch.cross(stretch, state)? else { return Ok(Ending::Event) };
        stretch.take_up((from, behind), state)?;
        return Ok(Ending::Kink { time: behind });
    }
    method.is_last(true);
    let Some((time, passing)) = reach(method, (stretch, watch), (from, until), passing) else {
        return Ok(Ending::NotReached);
    };
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
    let front = in_front(stretch, (from, time));
    if watch.passes_kink() {
        kept.stay_in_front(method, stretch, (front, time))?;
    } else {
        kept.put_back(method, stretch, time)?;
    }
    constrain_tangents(stretch, time, &kept.end);
    sample(method, stretch, (time, &kept.end), state, samples)?;
    if let Some(tangents) = stretch.system.tangents() {
        tangents.accept();
        state.copy_from_slice(&kept.end);
        if stretch.system.simulator().kinks() > 0 {
            method.interpolate(front, state);
            tangents.comes_from(front, state);
        } else {
            tangents.comes_from(time, state);
        }
    }
    state.copy_from_slice(&kept.end);
    let time = watch.leap_behind_jumps(stretch, (time, passing), state);
    watch.happens(time, passing, state);
    let Some((behind, kinks)) = watch.cross(stretch, state)? else { return Ok(Ending::Event) };
    let has_moved = stretch.take_up((front, behind), state)?;
    if let Some(tangents) = stretch.system.tangents() {
        let (earlier, front) = tangents.front();
        let time = stretch.within(time);
        let passing = Passing { time, before: &kept.end, front: (earlier, &front) };
        tangents.cross(stretch, watch, &passing, &kinks, ((behind, state), has_moved))?;
    }
    if watch.turns(stretch, behind, state) {
        return Ok(Ending::Event);
    }
    Ok(Ending::Kink { time: behind })
}

/// Takes steps that end where a guard passes first; gives the time at which the last of them ends, and
/// when that guard passes.
fn reach(
    method: &mut dyn OneStep,
    (stretch, watch): (&Stretch<'_>, &Watch<'_>),
    (from, until): (f64, f64),
    mut passing: f64,
) -> Option<(f64, f64)> {
    /// So often another guard may turn out to pass before.
    const MOST: usize = 16;
    for _ in 0..MOST {
        let time = if watch.passes_kink() {
            approach(method, (stretch, watch), (from, watch.next_event(until)), passing)
        } else {
            correct(method, watch, (from, until), passing)
        }?;
        let front = in_front(stretch, (from, time));
        let Some(earlier) = watch.passes_in_front(method, (from, front)) else {
            return Some((time, passing));
        };
        passing = earlier;
    }
    None
}

/// A moment before the end of a step, where what jumps there has not jumped yet.
fn in_front(stretch: &Stretch<'_>, (from, time): (f64, f64)) -> f64 {
    (time - moment(stretch, time)).max(0.5 * (from + time))
}

/// Takes steps that end where an event is, corrected by Newton's method; gives the time at
/// which the last of them ends.
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
        let correction = watch.correction(time, method.end());
        let small = 1e-3 * (until - from);
        let Some(correction) = correction.filter(|c| c.abs() <= small) else { break };
        let corrected = (time + correction).min(until);
        let is_settled = correction.abs() <= 4.0 * f64::EPSILON * time.abs() || corrected <= from;
        if is_settled || round == corrections {
            break;
        }
        time = corrected;
    }
    Some(time)
}

/// Takes steps that end nearer and nearer to a kink, which is somewhere about `passing`; gives
/// the time at which the last of them ends.
///
/// A rate that jumps there spoils steps that end beyond it, so that these tell no more than
/// that they do: the root is foretold from in front of it.
fn approach(
    method: &mut dyn OneStep,
    (stretch, watch): (&Stretch<'_>, &Watch<'_>),
    (from, until): (f64, f64),
    passing: f64,
) -> Option<f64> {
    const ROUNDS: usize = 12;
    /// So many times what time resolves it goes back.
    const MOST: f64 = 4.0;
    let resolved = 4.0 * f64::EPSILON * until.abs().max(until - from);
    let mut back = 0.5 * resolved;
    let (mut front, mut beyond) = (from, until);
    let mut foretold = None;
    let mut time = passing;
    for _ in 0..ROUNDS {
        let is_good = method.attempt(time - from).is_good();
        let (distance, correction) = watch.before_kink(time, method.end());
        if is_good && (correction.abs() <= resolved || distance.abs() <= watch.rounding()) {
            let is_front = distance > 0.0 || time - back <= from || back > MOST * resolved;
            let earlier = time - MOST * resolved;
            if is_front || !stretch.rate_jumps(method.end(), (earlier, time), time - from) {
                return Some(time);
            }
            // Methods ask for the rate at the end, which is to be that in front of the kink.
            time -= back;
            back *= 2.0;
            continue;
        }
        let next = Some(time + correction);
        if is_good && distance > 0.0 {
            (front, foretold) = (time, next);
        } else {
            beyond = time;
        }
        let is_between = |next: &f64| front < *next && *next < beyond;
        let own = next.filter(|_| is_good).filter(is_between);
        time = own.or(foretold.filter(is_between)).unwrap_or(0.5 * (front + beyond));
        if beyond - front <= resolved {
            break;
        }
    }
    (front > from && method.attempt(front - from).is_good()).then_some(front)
}
