//! Followers of a step, which are told its parts and events.

use super::FixedSteps;
use crate::Real;

/// Follower of a step. It is told in order what becomes of the state; parts that are tried and
/// repeated are left out.
pub(super) trait Follow<R: Real> {
    /// Notes a part of a step without events, with the states at its start and end.
    fn part(
        &mut self,
        _of: &FixedSteps<'_, R>,
        _time_and_length: (R, R),
        _start: &[R],
        _end: &[R],
    ) {
    }
    /// Notes that events follow at a time, before they change the state. `first` is the event whose
    /// zero crossing determines the time; `None` if the time is known.
    fn before_events(
        &mut self,
        _of: &FixedSteps<'_, R>,
        _first: Option<usize>,
        _time: R,
        _state: &[R],
    ) {
    }
    /// Notes an event, before it resets the state.
    fn reset(&mut self, _of: &FixedSteps<'_, R>, _event: usize, _time: R, _before: &[R]) {}
    /// Notes a projection onto the constraints after events, with its result.
    fn projected(&mut self, _of: &FixedSteps<'_, R>, _time: R, _state: &[R]) {}
    /// Notes the state after all events at a time.
    fn after_events(&mut self, _of: &FixedSteps<'_, R>, _time: R, _state: &[R]) {}
}

/// No follower.
pub(super) struct Nobody;

impl<R: Real> Follow<R> for Nobody {}
