//! Kinks: guards at which nothing happens but that the rate is another one behind them.
//!
//! A step ends there, and the next begins strictly behind, so that it sees one side alone. If
//! the rate jumps at a kink and drives the state back to it from both sides, no motion goes
//! on from there: it chatters.

use super::super::Stretch;
use super::passing::evaluate;
use super::{Side, Watch};
use crate::method::Stopped;

/// Of the time reached, or of the step: behind a kink within this, or not at all.
const BEHIND: f64 = 1e-12;

impl Watch<'_> {
    /// If what happens at the end of a step, in `state`, is that kinks are passed and
    /// nothing else: puts the state behind them, and gives the time and the kinks that tell it.
    ///
    /// # Errors
    /// [`Chattering`](crate::error::StopCause::Chattering) if the state is driven back from behind,
    /// [`RestsOnKink`](crate::error::StopCause::RestsOnKink) if it goes to and fro without end.
    pub(in crate::method) fn cross(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
    ) -> Result<Option<(f64, Vec<usize>)>, Stopped> {
        let is_kink = |index: &usize| self.is_kink(*index);
        let are_kinks = |happening: &mut (f64, Vec<usize>)| {
            !happening.1.is_empty() && happening.1.iter().all(is_kink)
        };
        let happening = self.inner.borrow_mut().happening.take_if(are_kinks);
        let Some((time, kinks)) = happening else { return Ok(None) };
        let mut behind = time;
        for kink in &kinks {
            behind = self.put_behind(stretch, *kink, behind, state)?;
            if let Some(cause) = self.rests_on(stretch, *kink, (behind, state)) {
                return Err(Stopped { time, cause });
            }
        }
        let jumps = |index: &usize| {
            let outcome = self.inner.borrow().outcomes[*index];
            matches!(outcome, super::Outcome::Passes { jumps: true, .. })
        };
        // What only jumps there passes when the others do.
        let tells: Vec<usize> = kinks.iter().copied().filter(|index| !jumps(index)).collect();
        Ok(Some((behind, if tells.is_empty() { kinks } else { tells })))
    }

    /// If a state from which no step can be taken is in front of kinks by less than time resolves:
    /// puts it behind them, and gives its time.
    ///
    /// # Errors
    /// As [`Watch::cross`].
    pub(in crate::method) fn cross_at_once(
        &self,
        stretch: &Stretch<'_>,
        time: f64,
        state: &mut [f64],
    ) -> Result<Option<f64>, Stopped> {
        /// Roundings of the time.
        const NEAR: f64 = 16.0;
        let (events, all) = {
            let inner = self.inner.borrow();
            (self.system.simulator().events(), inner.sides.len())
        };
        let mut kinks = Vec::new();
        for index in events..all {
            let side = self.inner.borrow().sides[index];
            let (guard, rate) = self.kink(index, stretch.within(time), state);
            let away = -guard / rate;
            if let Side::Known(from) = side
                && from * guard >= 0.0
                && (0.0..=NEAR * f64::EPSILON * time.abs()).contains(&away)
            {
                kinks.push((index, from));
            }
        }
        if kinks.is_empty() {
            return Ok(None);
        }
        {
            let inner = &mut *self.inner.borrow_mut();
            inner.outcomes = inner.sides.iter().map(|side| super::Outcome::Stays(*side)).collect();
            for (index, from) in &kinks {
                let passes = super::Outcome::Passes { time, from: *from, jumps: false };
                inner.outcomes[*index] = passes;
            }
            inner.happening = Some((time, kinks.into_iter().map(|(index, _)| index).collect()));
        }
        let behind = self.cross(stretch, state)?.map(|(behind, _)| behind);
        Ok(behind.filter(|behind| *behind > time))
    }

    /// Puts a state at a kink behind it; its new time.
    fn put_behind(
        &self,
        stretch: &Stretch<'_>,
        kink: usize,
        time: f64,
        state: &mut [f64],
    ) -> Result<f64, Stopped> {
        let from = match self.inner.borrow().outcomes[kink] {
            super::Outcome::Passes { from, .. } => from,
            super::Outcome::Stays(_) => return Ok(time),
        };
        let states = self.system.states();
        let mut rate = vec![0.0; state.len()];
        stretch.rate(time, state, &mut rate);
        let guard = |time: f64, state: &[f64]| self.kink(kink, stretch.within(time), state);
        let (here, slope) = guard(time, state);
        // The state may be behind the kink already, where it is driven back.
        let way = if from * slope > 0.0 { -1.0 } else { 1.0 };
        let shifted = |state: &[f64], by: f64| -> Vec<f64> {
            state.iter().zip(&rate).map(|(value, rate)| value + by * way * rate).collect()
        };
        let largest = BEHIND * time.abs().max(stretch.until - stretch.from);
        let least = 4.0 * f64::EPSILON * time.abs().max(stretch.until - stretch.from);
        // Far away at no rate: never there.
        let distance = if here == 0.0 { 0.0 } else { 2.0 * (here / slope).abs() };
        let mut by = if distance.is_nan() { f64::INFINITY } else { distance.max(least) };
        let mut side = if by <= largest {
            Side::Fresh { passed: true, residual: 4.0 * here.abs() }
        } else {
            // The step has ended in front of it.
            Side::Known(here.signum())
        };
        if here.abs() <= self.inner.borrow().parts.rounding(kink) {
            // It is on both sides, and however slowly it moves: it has passed.
            side = Side::Known(-from);
        }
        let mut now = time;
        while by <= largest {
            let ahead = shifted(state, by);
            let (behind, slope_behind) = guard(time + by, &ahead);
            let back = shifted(state, -by);
            let (before, slope_before) = guard(time - by, &back);
            if from * behind < 0.0 && from * before > 0.0 {
                let is_driven_back = from * slope_before < 0.0 && from * slope_behind > 0.0;
                if is_driven_back && let Some(cause) = stretch.chattering(time, &ahead[..]) {
                    return Err(Stopped { time, cause });
                }
                side = Side::Known(-from);
                now = (time + by).min(stretch.until);
                state[..states].copy_from_slice(&ahead[..states]);
                break;
            }
            by *= 4.0;
        }
        if now <= time
            && let Some(behind) = self.leap(stretch, (kink, from), (time, state), way)
        {
            side = Side::Known(-from);
            now = behind;
        }
        self.inner.borrow_mut().sides[kink] = side;
        Ok(now)
    }

    /// Puts a state in front of a guard that jumps behind it, `way` being 1 or, where it is driven back,
    /// -1; its new time. One that jumps tells nothing of it from in front: it is on the other side at
    /// once. Nothing if it is behind, or not near.
    fn leap(
        &self,
        stretch: &Stretch<'_>,
        (index, from): (usize, f64),
        (time, state): (f64, &mut [f64]),
        way: f64,
    ) -> Option<f64> {
        let guard = |time: f64, state: &[f64]| self.guards(stretch.within(time), state)[index];
        if from * guard(time, state) <= 0.0 {
            return None;
        }
        let states = self.system.states();
        let mut rate = vec![0.0; state.len()];
        stretch.rate(time, state, &mut rate);
        let size = time.abs().max(stretch.until - stretch.from);
        let mut by = 4.0 * f64::EPSILON * size;
        while by <= BEHIND * size {
            let ahead = state.iter().zip(&rate).map(|(value, rate)| value + by * way * rate);
            let ahead: Vec<f64> = ahead.collect();
            if from * guard(time + by, &ahead) < 0.0 {
                state[..states].copy_from_slice(&ahead[..states]);
                return Some((time + by).min(stretch.until));
            }
            by *= 4.0;
        }
        None
    }

    /// Puts a state at the end of a step behind the guards of events that jump there; its new time.
    pub(in crate::method) fn leap_behind_jumps(
        &self,
        stretch: &Stretch<'_>,
        (time, passing): (f64, f64),
        state: &mut [f64],
    ) -> f64 {
        let near = 64.0 * f64::EPSILON * time.abs();
        let jumped: Vec<(usize, f64)> = {
            let inner = self.inner.borrow();
            let outcomes = inner.outcomes.iter().enumerate();
            let jumped = outcomes.filter_map(|(index, outcome)| match *outcome {
                super::Outcome::Passes { time, from, jumps: true } if time <= passing + near => {
                    Some((index, from))
                }
                _ => None,
            });
            jumped.filter(|(index, _)| !self.is_kink(*index)).collect()
        };
        jumped.into_iter().fold(time, |time, jumped| {
            self.leap(stretch, jumped, (time, state), 1.0).unwrap_or(time)
        })
    }

    /// A kink's guard and its rate.
    fn kink(&self, index: usize, time: f64, state: &[f64]) -> (f64, f64) {
        let simulator = self.system.simulator();
        let (events, kinks) = (simulator.events(), simulator.kinks());
        let (mut guards, mut rates) = (vec![0.0; kinks], vec![0.0; kinks]);
        evaluate(self.system, 0, time, state, [&mut guards, &mut rates]);
        (guards[index - events], rates[index - events])
    }
}
