//! Roots of guards on the dense output of a step.

use machinist_contract::Direction;

use super::super::Side;
use super::super::polynomial::{NODES, SHARES};
use super::super::watched::Watched;
use super::{
    AT_REST, GROWTH, Guard, Look, Outcome, PIECES, Parts, Samples, Step, Zero, is_wanted, middle,
};

impl Parts {
    /// Returns how a guard that is on `side` at the start of the step begins.
    ///
    /// # Errors
    /// The side on which it stays, if it surely does not cross zero until a time within the step.
    fn beginning(
        &mut self,
        step: &mut Step<'_, '_>,
        (guard, until): (Guard, f64),
        side: Side,
    ) -> Result<Beginning, Side> {
        let Guard { index, direction, zero, .. } = guard;
        match side {
            Side::Idle => Err(side),
            Side::Known(on) if until >= self.end.time && self.is_clear(step, index, on) => {
                Err(side)
            }
            Side::Known(side) => Ok(Beginning { side, zero, leaves: false }),
            Side::Fresh { passed, residual } => {
                match self.first_seen(step, (index, direction), (passed, residual), until) {
                    Start::On(side, zero) => Ok(Beginning { side, zero, leaves: false }),
                    Start::Leaves { from, zero } => {
                        Ok(Beginning { side: -from, zero, leaves: true })
                    }
                    Start::Unseen => Err(side),
                }
            }
        }
    }

    /// Returns the outcome for a guard that is on `side` at the start of the step, until a limit
    /// within the step.
    pub(in crate::method::watch) fn outcome(
        &mut self,
        step: &mut Step<'_, '_>,
        (guard, limit): (Guard, f64),
        side: Side,
    ) -> Outcome {
        let Guard { index, direction, is_kink, .. } = guard;
        let Beginning { mut side, mut zero, leaves } =
            match self.beginning(step, (guard, limit), side) {
                Ok(beginning) => beginning,
                Err(stays) => return Outcome::Stays(stays),
            };
        if leaves && !is_kink && is_wanted(direction, -side) {
            return Outcome::Passes { time: self.start.time, from: -side };
        }
        let (mut from, until) = (self.start.time, limit);
        loop {
            let mut pieces = PIECES;
            let of = (index, side, zero);
            let Some(time) = self.first_root(step, of, [from, until], &mut pieces) else { break };
            if is_wanted(direction, side) {
                return Outcome::Passes { time, from: side };
            }
            side = -side;
            let is_same = zero.is_some_and(|zero| time <= zero.time);
            if is_same || time >= until {
                break;
            }
            (from, zero) = (time, Some(self.zero_at(step, time, index)));
        }
        Outcome::Stays(Side::Known(side))
    }

    /// Returns all times at which a guard that is on `side` at the start of the step crosses zero
    /// in its direction, until a time within the step, and its side then.
    pub(in crate::method::watch) fn passings(
        &mut self,
        step: &mut Step<'_, '_>,
        (guard, until): (Guard, f64),
        side: Side,
    ) -> (Vec<f64>, Side) {
        let Guard { index, direction, .. } = guard;
        let mut passings = Vec::new();
        self.samples.clear();
        let Beginning { mut side, mut zero, leaves } =
            match self.beginning(step, (guard, until), side) {
                Ok(beginning) => beginning,
                Err(stays) => return (passings, stays),
            };
        if leaves && is_wanted(direction, -side) {
            passings.push(self.start.time);
        }
        let mut from = self.start.time;
        let (mut since, mut span) = (from, self.spans[index].min(until - from));
        while from < until {
            self.samples.clear();
            let to = if from + span < until { from + span } else { until };
            let mut pieces = PIECES;
            let found = self.first_root(step, (index, side, zero), [from, to], &mut pieces);
            if pieces == 0 && middle(from, 0.5 * (from + to)).is_some() {
                span = 0.5 * (to - from);
                continue;
            }
            // The root at which it was zero does not count again.
            let is_other = |time: &f64| zero.is_none_or(|zero| *time > zero.time);
            let Some(time) = found.filter(is_other) else {
                span *= if to < until { GROWTH } else { 1.0 };
                from = to;
                continue;
            };
            if is_wanted(direction, side) {
                passings.push(time);
            }
            // The next root is about as far from this one as the last one.
            span = if middle(since, time).is_some() { time - since } else { span };
            (from, since) = (time, time);
            let at = self.zero_at(step, time, index);
            side = match self.first_sign(step, index, at, until) {
                Some((seen, _)) if at.rate * side > 0.0 => seen,
                _ => -side,
            };
            zero = Some(at);
        }
        self.samples.clear();
        self.spans[index] = span;
        (passings, Side::Known(side))
    }

    /// Returns the largest distance of a guard beyond zero within the step, if it is back on its
    /// side at the end.
    pub(in crate::method::watch) fn dip(
        &mut self,
        step: &mut Step<'_, '_>,
        (index, side): (usize, f64),
        passing: f64,
    ) -> Option<f64> {
        if side * self.end.values[index] <= 0.0 {
            return None;
        }
        let zero = Some(self.zero_at(step, passing, index));
        let of = (index, -side, zero);
        let back = self.first_root(step, of, [passing, self.end.time], &mut PIECES.clone())?;
        let depths = SHARES
            .map(|share| -side * self.sample(step, passing + (back - passing) * share, index));
        Some(depths.into_iter().fold(0.0, f64::max))
    }

    /// Returns whether the guard of an event stays on its side over the whole step, with relations
    /// held in another way than the step was evaluated.
    pub(in crate::method::watch) fn stays_as_held(
        &mut self,
        step: &mut Step<'_, '_>,
        (index, side): (usize, f64),
        start: &[f64],
    ) -> bool {
        let (from, until) = (self.start.time, self.end.time);
        self.state.copy_from_slice(start);
        let begin = self.look_at(step.system, from, Look::default());
        self.state.copy_from_slice(step.method.end());
        let end = self.look_at(step.system, until, Look::default());
        let kept = (
            std::mem::replace(&mut self.start, begin),
            std::mem::replace(&mut self.end, end),
            std::mem::replace(&mut self.samples, Samples::new(self.watched.len())),
        );
        let is_beyond = side * self.start.values[index] <= 0.0;
        let of = (index, side, None);
        let stays =
            !is_beyond && self.first_root(step, of, [from, until], &mut PIECES.clone()).is_none();
        (self.start, self.end, self.samples) = kept;
        stays
    }

    /// Relations are held in another way from the end of the step on.
    pub(in crate::method::watch) fn forget_end(&mut self) {
        self.end.time = f64::NAN;
    }

    /// Returns whether a guard certainly stays on its side over the step, by the cubic through both
    /// ends and the error of the previous one.
    fn is_clear(&self, step: &mut Step<'_, '_>, index: usize, side: f64) -> bool {
        /// Distances from a place have a corner there, of which the estimate sees a tenth.
        const WIDER: f64 = 16.0;
        let ends = |look: &Look| [look.time, look.values[index], look.rates[index]];
        let [start, end] = [&self.start, &self.end].map(ends);
        let span = end[0] - start[0];
        let coefficients =
            [start[1], start[1] + span * start[2] / 3.0, end[1] - span * end[2] / 3.0, end[1]];
        let error = match self.bound(step, (index, None), 4, [start[0], end[0]]) {
            Some(bound) => bound * span.powi(4) / 384.0,
            None => match self.error_by_extrapolation(index) {
                Some(error) => WIDER * error,
                None => return false,
            },
        };
        let rounding = 16.0 * f64::EPSILON * self.sizes[index];
        let room = error + rounding;
        coefficients.iter().all(|value| side * value > room)
    }

    /// Returns an estimate of the distance between a guard and its cubic over the step, if the
    /// previous step allows one.
    fn error_by_extrapolation(&self, index: usize) -> Option<f64> {
        // The distance from a place turns as sharply as the place is narrow.
        let is_place = matches!(self.watched[index], Watched::Zone(_) | Watched::Nearest(_));
        if is_place
            || !self.has_before
            || self.turns[index].may_turn_within(self.end.time - self.start.time)
        {
            return None;
        }
        let ends = |look: &Look| [look.time, look.values[index], look.rates[index]];
        let [first, start, end] = [&self.before, &self.start, &self.end].map(ends);
        let (span, span_before) = (end[0] - start[0], start[0] - first[0]);
        // The previous cubic, extrapolated, misses by g'''' (h (h + h'))^2/24, and its rate
        // likewise. Between its ends this one is off by g'''' h^4/384 at most. Where a guard turns,
        // one estimate may be small by chance, but not both.
        let (whole, missed) = (span + span_before, cubic([first, start], end[0]));
        let by_value = (missed[0] - end[1]).abs() / (span * whole).powi(2);
        let by_rate = (missed[1] - end[2]).abs() / (2.0 * span * whole * (span + whole));
        Some(by_value.max(by_rate) * span.powi(4) / 16.0)
    }

    /// Returns the first time within a span at which a guard leaves a side, if it does.
    fn first_root(
        &mut self,
        step: &mut Step<'_, '_>,
        of: (usize, f64, Option<Zero>),
        [low, high]: [f64; 2],
        pieces: &mut usize,
    ) -> Option<f64> {
        let times: [f64; NODES] = std::array::from_fn(|node| match node {
            0 => low,
            _ if node == NODES - 1 => high,
            _ => low + (high - low) * SHARES[node],
        });
        let samples = self.deflated_each(step, of, times);
        let rounding = self.rounding(of.0);
        // At its start the quotient is a rate, and just behind it is the least accurate.
        let since = |time: f64| of.2.map_or(1.0, |zero| (time - zero.time).max(0.0));
        let soonest = if since(low) > 0.0 { low } else { low + (high - low) * SHARES[1] };
        let noise = 0.25 * rounding / since(soonest);
        let enclosure = self.enclosure(step, (of.0, of.2), (&samples, noise), [low, high]);
        let (first, last) = (samples[0], samples[NODES - 1]);
        if enclosure.is_above() {
            return None;
        }
        // Only rounding; a larger value is not resolved yet.
        let is_rounding = |(node, sample): (usize, &f64)| {
            (sample * since(low + (high - low) * SHARES[node])).abs() <= rounding
        };
        if samples.iter().enumerate().all(is_rounding) {
            return None;
        }
        let beyond = |sample: f64, time: f64| -sample * since(time) > rounding;
        if first < -enclosure.error && beyond(first, low) {
            return Some(low);
        }
        // A guard that does not reach zero, and is not surely above it, may turn within.
        if enclosure.is_monotone() && last < first && beyond(last, high) {
            return Some(self.root(step, of, [low, high]));
        }
        *pieces = pieces.saturating_sub(1);
        let Some(middle) = middle(low, high).filter(|_| *pieces > 0) else {
            return (last < 0.0).then_some(high);
        };
        self.first_root(step, of, [low, middle], pieces)
            .or_else(|| self.first_root(step, of, [middle, high], pieces))
    }

    /// Returns a value that is positive while a guard is on a side; for a guard that was zero,
    /// divided by the time since then.
    fn deflated(
        &mut self,
        step: &mut Step<'_, '_>,
        (index, side, zero): (usize, f64, Option<Zero>),
        time: f64,
    ) -> f64 {
        let value = |parts: &mut Self, step: &mut Step<'_, '_>| parts.sample(step, time, index);
        match zero {
            None => side * value(self, step),
            Some(zero) if time <= zero.time => side * zero.rate,
            Some(zero) => side * (value(self, step) - zero.residual) / (time - zero.time),
        }
    }

    /// Returns [`Parts::deflated`] at each of these times.
    fn deflated_each(
        &mut self,
        step: &mut Step<'_, '_>,
        of: (usize, f64, Option<Zero>),
        times: [f64; NODES],
    ) -> [f64; NODES] {
        let is_behind = |time: &f64| of.2.is_none_or(|zero| *time > zero.time);
        self.sample_all(step, times.into_iter().filter(is_behind), of.0);
        times.map(|time| self.deflated(step, of, time))
    }

    /// Returns the time at which a guard leaves a side, between two times at which it is on it and
    /// not, by false position with halving (Illinois). The result is never early.
    fn root(
        &mut self,
        step: &mut Step<'_, '_>,
        of: (usize, f64, Option<Zero>),
        [mut low, mut high]: [f64; 2],
    ) -> f64 {
        let mut at_low = self.deflated(step, of, low);
        let mut at_high = self.deflated(step, of, high);
        if at_low <= 0.0 {
            return low;
        }
        let (mut kept, mut count) = (0, 0);
        while let Some(middle) = middle(low, high) {
            count += 1;
            let chord = high - (high - low) * (at_high / (at_high - at_low));
            let is_within = low < chord && chord < high;
            let time = if is_within && count % 4 != 0 { chord } else { middle };
            let guard = self.between(step, of, time);
            if guard > 0.0 {
                (low, at_low) = (time, guard);
                at_high *= if kept == 1 { 0.5 } else { 1.0 };
                kept = 1;
            } else {
                (high, at_high) = (time, guard);
                at_low *= if kept == -1 { 0.5 } else { 1.0 };
                kept = -1;
            }
            if guard == 0.0 {
                break;
            }
        }
        high
    }

    /// Returns [`Parts::deflated`] at a time that is not sampled again.
    fn between(
        &mut self,
        step: &mut Step<'_, '_>,
        of: (usize, f64, Option<Zero>),
        time: f64,
    ) -> f64 {
        let count = self.samples.count();
        let found = self.deflated(step, of, time);
        self.samples.truncate(count);
        found
    }

    /// Returns the start of a step for a guard whose side is not known.
    fn first_seen(
        &mut self,
        step: &mut Step<'_, '_>,
        (index, direction): (usize, Direction),
        (passed, residual): (bool, f64),
        until: f64,
    ) -> Start {
        let time = self.start.time;
        let (value, rate) = (self.start.values[index], self.start.rates[index]);
        let by_time = 16.0 * f64::EPSILON * time.abs() * rate.abs();
        let is_far =
            |side: f64| direction != Direction::Both && is_wanted(direction, -side.signum());
        let zero = residual.max(by_time);
        // A value that rounding alone may take beyond zero is not beyond it.
        let unclear = if is_far(value) { zero.max(self.rounding(index)) } else { zero };
        if value.abs() > unclear {
            return Start::On(value.signum(), None);
        }
        let at = Zero { time, residual: value, rate };
        let Some((seen, is_at_once)) = self.first_sign(step, index, at, until) else {
            return Start::Unseen;
        };
        // A guard that just crossed goes on, unless its event may have brought it to rest.
        let moves_guard = || step.system.simulator().event(index).moves_guard;
        let goes_on = passed && (is_at_once || !moves_guard());
        if !goes_on && is_far(seen) {
            Start::Leaves { from: -seen, zero: Some(at) }
        } else {
            Start::On(seen, Some(at))
        }
    }

    /// Returns the side to which a guard leaves zero, and whether it does so at a finite rate.
    fn first_sign(
        &mut self,
        step: &mut Step<'_, '_>,
        index: usize,
        at: Zero,
        mut until: f64,
    ) -> Option<(f64, bool)> {
        const SOONER: f64 = 0.125;
        let mut found = None;
        while until > at.time {
            let span = until - at.time;
            // A rate within rounding does not count, nor one at which a guard rests.
            let rests = (AT_REST * self.largest(index)).max(self.rounding(index));
            if at.rate.abs() * span > rests {
                return Some((at.rate.signum(), true));
            }
            let times = SHARES.map(|share| at.time + span * share);
            let samples = self.deflated_each(step, (index, 1.0, Some(at)), times);
            let noise = self.rounding(index) / (span * SHARES[1]);
            let span_of = [at.time, until];
            let enclosure = self.enclosure(step, (index, Some(at)), (&samples, noise), span_of);
            let moved = |node: usize| samples[node].abs() * span * SHARES[node];
            let Some(seen) = (0..NODES).find(|node| moved(*node) > rests) else { break };
            if enclosure.error > SOONER * samples[seen].abs() {
                until = at.time + SOONER * span;
                continue;
            }
            found = Some((samples[seen].signum(), false));
            if seen > 1 {
                break;
            }
            // A long step may hide that the guard was on the other side before.
            until = at.time + SHARES[seen] * span;
        }
        found
    }
}

/// Returns the cubic through two times, values and rates, with its rate, at a time between or
/// beyond them.
fn cubic([[from, low, low_rate], [until, high, high_rate]]: [[f64; 3]; 2], time: f64) -> [f64; 2] {
    let span = until - from;
    let (s, left) = ((time - from) / span, (until - time) / span);
    let ends = left * left * (1.0 + 2.0 * s) * low + s * s * (3.0 - 2.0 * s) * high;
    let rates = left * low_rate - s * high_rate;
    let slope = 6.0 * s * left * (high - low) / span + (left - s) * rates
        - s * left * (low_rate + high_rate);
    [ends + span * s * left * rates, slope]
}

/// Beginning of a guard that may cross zero within a step.
struct Beginning {
    /// Side on which it is, just behind the start.
    side: f64,
    /// The start of the segment, if it was zero there.
    zero: Option<Zero>,
    /// True if it leaves the other side at the start of the step.
    leaves: bool,
}

/// State of a guard at the start of a step.
enum Start {
    /// On a side; it may have been zero.
    On(f64, Option<Zero>),
    /// It leaves this side at the start.
    Leaves { from: f64, zero: Option<Zero> },
    /// Zero during the whole step.
    Unseen,
}
