//! Acceptance of the steps of all lanes.

use machinist_contract::Real;

use crate::error::StopCause;
use crate::lanes::Lanes;
use crate::method::one_step::{self, is_too_small};
use crate::method::taylor::magnitude::Magnitude;
use crate::method::taylor::step::{self, Tolerance};

use super::clock::places;
use super::lane::Lane;
use super::{Along, Bundle, gather};

impl<R: Lanes> Bundle<'_, R> {
    /// Accepts or rejects steps, and takes the coefficients of the lanes with accepted ones.
    pub(super) fn judge(&mut self, lanes: &mut [Option<Lane>]) {
        let (zero, half, one) = (R::literal(0.0), R::literal(0.5), R::literal(1.0));
        let (defects, finite) = self.defects();
        let within =
            self.defects_within().map(|defects| step::lasting_error(defects, self.clock.step));
        // A step is accepted in lanes that try one, with a finite end and an error up to 1.
        let good = R::select_less(defects * self.clock.step, self.limit, one, zero);
        let good = R::select_less(finite, half, good, zero);
        let good = R::select_less(self.clock.waits, half, good, zero);
        let good = within.map_or(good, |within| R::select_less(one, within, zero, good));
        (self.passed, self.good) = (R::less(half, good), good);
        let rejected = self.clock.running & !self.passed & !self.clock.starting();
        self.rejected = zero;
        for index in places(rejected) {
            self.rejected.set_lane(index, 1.0);
            if let Some(lane) = &mut lanes[index] {
                let is_finite = finite.lane(index) == 0.0;
                let [defect, step, terms] =
                    [defects, self.clock.step, self.terms].map(|values| values.lane(index));
                let error = step::over_allowed(step::error(defect, step, terms));
                let within = within.map_or(0.0, |within| within.lane(index));
                let error = if error <= 1.0 { error.larger(within) } else { error };
                self.reject(index, lane, is_finite.then_some(error));
            }
        }
        for index in places(self.passed & !R::less(self.clock.now, self.clock.sample)) {
            if let Some(lane) = &mut lanes[index] {
                self.sample(index, lane);
            }
        }
        let moves = self.moves();
        self.clock.pass(good, moves);
        if rejected == 0 {
            std::mem::swap(&mut self.current, &mut self.following);
            std::mem::swap(&mut self.inverse_weights, &mut self.following_weights);
        } else {
            take(&mut self.current, &self.following, self.rejected);
            take(&mut self.inverse_weights, &self.following_weights, self.rejected);
        }
        self.measure_terms();
    }

    /// Returns the largest defect of each lane's step in units of its tolerance, and zero in the
    /// lanes in which state and rate at the end are finite.
    fn defects(&self) -> (R, R) {
        let begin = &self.following[..2 * self.states];
        let largest = step::defect(&self.slope, &begin[self.states..], &self.inverse_weights);
        (largest, zeros(begin))
    }

    /// Returns the largest defect within each lane's step where functions saturate, in units of its
    /// tolerance, if the machine has such functions.
    fn defects_within(&mut self) -> Option<R> {
        let (zero, half) = (R::literal(0.0), R::literal(0.5));
        let (coefficients, step) = (&self.current[..], self.clock.step);
        let mut along = Along { equations: &self.equations, clock: &self.clock, coefficients };
        let between = &mut self.between;
        let ends = (&coefficients[..self.states], step, &self.end[..]);
        let is_any = |place| R::less(zero, place) != 0;
        let mut largest = zero;
        self.saturating.as_mut()?.places(&mut along, ends, is_any, |along, after, is_there| {
            let rate = |state: &[R], rate: &mut [R]| {
                along.equations.rate(along.time(after), state, rate);
            };
            let defect = between.defect(coefficients, after, &self.inverse_weights, rate);
            largest = largest.larger(R::select_less(half, is_there, defect, zero));
        });
        Some(largest)
    }

    /// Computes the sizes of the last coefficients relative to the tolerances.
    fn measure_terms(&mut self) {
        for (size, terms) in self.sizes.iter_mut().zip(self.current.chunks_exact(self.states).rev())
        {
            *size = terms
                .iter()
                .zip(&self.inverse_weights)
                .fold(R::literal(0.0), |largest, (term, inverse)| {
                    largest.larger((*term * *inverse).abs())
                });
        }
    }

    /// Returns 1 in the lanes in which something has moved over the step, 0 in others.
    fn moves(&self) -> R {
        let (zero, one) = (R::literal(0.0), R::literal(1.0));
        let ends = self.current.iter().zip(&self.end).zip(&self.resting);
        ends.fold(zero, |moves, ((start, end), resting)| {
            R::select_less(*resting, (*end - *start).abs(), one, moves)
        })
    }

    /// Shortens a lane's step by its error relative to what is allowed, if its end is finite.
    fn reject(&mut self, index: usize, lane: &mut Lane, error: Option<f64>) {
        let (time, step, order) =
            (self.clock.time.lane(index), self.clock.step.lane(index), self.order_of(index));
        let trial = match error {
            Some(error) => one_step::Trial::Error(error),
            None => self.trial(index, lane, (step, order)),
        };
        lane.rejected += 1;
        let step = step * one_step::shrink(trial, step::pace(order));
        self.clock.step.set_lane(index, step);
        if is_too_small(step, time) {
            let cause = match trial {
                one_step::Trial::NotFinite { what, index } => {
                    StopCause::not_finite(format!("{what} state number {index}"))
                }
                _ => StopCause::StepTooSmall,
            };
            lane.stop(time, cause);
        }
    }

    /// Returns the result of a lane's step whose end is not finite.
    fn trial(
        &mut self,
        index: usize,
        lane: &Lane,
        step_and_order: (f64, usize),
    ) -> one_step::Trial {
        let mut tolerance = Tolerance::new(self.rtol, &lane.variant.tolerance.atol, self.order);
        gather(&self.inverse_weights, index, tolerance.inverse_weights());
        let (slope, begin) = self.scratch.split_at_mut(self.states);
        let begin = &mut begin[..2 * self.states];
        gather(&self.slope, index, slope);
        gather(&self.following[..2 * self.states], index, begin);
        step::trial(&tolerance, slope, begin, step_and_order)
    }

    /// Takes the samples of a lane's accepted step.
    fn sample(&mut self, index: usize, lane: &mut Lane) {
        let (from, until) = (self.clock.time.lane(index), self.clock.now.lane(index));
        while lane.next_sample() <= until {
            let time = lane.next_sample();
            for state in 0..self.states {
                let value = if time >= until {
                    self.end[state].lane(index)
                } else {
                    self.value(index, state, time - from)
                };
                lane.rows.push(value);
            }
            lane.taken += 1;
        }
        self.clock.sample.set_lane(index, lane.next_sample());
    }

    /// Returns the polynomial of a state at a time after the start of the lane's step.
    fn value(&self, index: usize, state: usize, after: f64) -> f64 {
        let mut terms = self.current.iter().skip(state).step_by(self.states).rev();
        let highest = terms.next().map_or(0.0, |term| term.lane(index));
        terms.fold(highest, |value, term| Real::mul_add(value, after, term.lane(index)))
    }
}

/// Replaces values by the following ones, except in the lanes that stay, given as 1 or 0.
fn take<R: Lanes>(values: &mut [R], following: &[R], stays: R) {
    let half = R::literal(0.5);
    for (value, following) in values.iter_mut().zip(following) {
        *value = R::select_less(stays, half, *following, *value);
    }
}

/// Returns zero in the lanes in which all numbers are finite, NaN in others.
pub(super) fn zeros<R: Lanes>(values: &[R]) -> R {
    // Several independent sums avoid waiting for each addition.
    let zero = R::literal(0.0);
    let (blocks, rest) = values.as_chunks::<8>();
    let mut sums = [zero; 8];
    for block in blocks {
        for (sum, value) in sums.iter_mut().zip(block) {
            *sum = *sum + *value * zero;
        }
    }
    sums.iter()
        .fold(rest.iter().fold(zero, |sum, value| sum + *value * zero), |sum, part| sum + *part)
}
