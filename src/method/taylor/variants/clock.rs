//! Times of lanes.

use crate::lanes::Lanes;
use crate::method::one_step::{End, LOOKS, end_of_step};
use crate::method::stretch::inside;
use crate::method::taylor::magnitude::smaller;
use crate::method::taylor::step::GROWTH;

use super::lane::Lane;

/// Times and steps of all lanes.
pub(super) struct Clock<R> {
    /// Lanes that have a variant, as bits.
    pub(super) running: u32,
    /// 1 in the lanes that do not try a step, because they begin a segment or have no variant; 0 in
    /// others.
    pub(super) waits: R,
    /// Start of the segment, its end, and the first and the last number between them.
    from: R,
    until: R,
    first: R,
    last: R,
    /// Start of the step.
    pub(super) time: R,
    /// End of the step.
    pub(super) now: R,
    pub(super) step: R,
    /// Longest step to be tried next.
    longest: R,
    /// The same where nothing moves.
    longest_at_rest: R,
    /// Time of the next sample.
    pub(super) sample: R,
    pub(super) steps: R,
    /// Number of steps after which a lane is asked whether it goes on.
    most: R,
}

impl<R: Lanes> Clock<R> {
    pub(super) fn new() -> Self {
        let (zero, one) = (R::literal(0.0), R::literal(1.0));
        Self {
            running: 0,
            waits: one,
            from: zero,
            until: zero,
            first: zero,
            last: zero,
            time: zero,
            now: zero,
            step: zero,
            longest: zero,
            longest_at_rest: zero,
            sample: zero,
            steps: zero,
            most: zero,
        }
    }

    /// Sets a lane to the start of a variant.
    pub(super) fn load(&mut self, index: usize, lane: &Lane) {
        self.running |= 1 << index;
        self.time.set_lane(index, lane.from());
        self.steps.set_lane(index, 0.0);
        self.allow(index, lane);
        self.sample.set_lane(index, lane.next_sample());
        self.begin(index, lane);
    }

    /// Sets a lane to the start of its segment.
    pub(super) fn begin(&mut self, index: usize, lane: &Lane) {
        let (from, until) = (lane.from(), lane.until());
        self.from.set_lane(index, from);
        self.until.set_lane(index, until);
        let (first, last) = inside((from, until));
        self.first.set_lane(index, first);
        self.last.set_lane(index, last);
        self.longest.set_lane(index, (until - from) / GROWTH);
        self.longest_at_rest.set_lane(index, (until - from) / LOOKS);
        self.waits.set_lane(index, 1.0);
    }

    /// Allows a lane more steps until it is asked.
    pub(super) fn allow(&mut self, index: usize, lane: &Lane) {
        self.most.set_lane(index, lane.steps_at_once() as f64);
    }

    /// Leaves a lane idle.
    pub(super) fn stop(&mut self, index: usize) {
        self.running &= !(1 << index);
        self.waits.set_lane(index, 1.0);
    }

    /// Returns the lanes that begin a segment.
    pub(super) fn starting(&self) -> u32 {
        self.running & R::less(R::literal(0.5), self.waits)
    }

    /// Returns the rest of the segment.
    pub(super) fn left(&self) -> R {
        self.until - self.time
    }

    /// Returns times moved into the segment; see [`crate::method::stretch::Stretch::within`].
    pub(super) fn within(&self, time: R) -> R {
        smaller(time, self.last).larger(self.first)
    }

    /// Moves to the ends of accepted steps, given as 1 or 0; `moves` says likewise whether anything
    /// has moved.
    pub(super) fn pass(&mut self, good: R, moves: R) {
        let half = R::literal(0.5);
        let longest = R::literal(GROWTH) * self.step;
        let at_rest = smaller(longest, self.longest_at_rest);
        let longest = R::select_less(half, moves, longest, at_rest);
        self.longest = R::select_less(half, good, longest, self.longest);
        self.time = R::select_less(half, good, self.now, self.time);
        self.steps = self.steps + good;
    }

    /// Returns the lanes at the end of their segment.
    pub(super) fn arrived(&self) -> u32 {
        !R::less(self.time, self.until)
    }

    /// Returns a step length without excessive growth.
    pub(super) fn bounded(&self, step: R) -> R {
        smaller(step, self.longest)
    }

    /// Returns the lanes that have taken all steps allowed until they are asked.
    pub(super) fn exhausted(&self) -> u32 {
        !R::less(self.steps, self.most)
    }

    /// Returns the lanes whose step does not advance time.
    pub(super) fn stuck(&self) -> u32 {
        !R::less(self.time, self.time + self.step)
    }

    /// Computes the ends of the next steps.
    pub(super) fn aim(&mut self) {
        let End { now, tried, .. } = end_of_step(self.time, self.step, self.until);
        (self.now, self.step) = (now, tried);
    }

    /// Does the same as [`Clock::aim`] for one lane.
    pub(super) fn aim_at(&mut self, index: usize) {
        let End { now, tried, .. } = end_of_step(self.time, self.step, self.until);
        self.now.set_lane(index, now.lane(index));
        self.step.set_lane(index, tried.lane(index));
    }
}

/// Returns the indices of set bits.
pub(crate) fn places(bits: u32) -> impl Iterator<Item = usize> {
    let rest = |bits: &u32| Some(bits & bits.wrapping_sub(1)).filter(|bits| *bits != 0);
    std::iter::successors(Some(bits).filter(|bits| *bits != 0), rest)
        .map(|bits| bits.trailing_zeros() as usize)
}
