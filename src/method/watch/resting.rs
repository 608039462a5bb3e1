//! Rest on a kink that pushes back from both sides, as of a spring with preload: nothing but the
//! jump of a force holds it, and a run goes to and fro across the kink, by roundings, without end.

use super::Watch;
use crate::error::StopCause;
use crate::method::Stretch;

/// So many passages are looked at together.
const MANY: u32 = 1000;
/// Of what the tolerances allow states, so much is moved between them at most.
const STILL: f64 = 0.1;

/// Of the steps that a run may take: more passages than that lead to an end that tells nothing.
const SHARE: f64 = 0.1;

/// The passages of a kink, since they were looked at.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Passages {
    count: u32,
    since: f64,
    latest: f64,
    /// By how much the guard moves between two at most, at the rate it has there.
    moves: f64,
}

impl Watch<'_> {
    /// The cause to end where a state goes to and fro across a kink, by far less than is allowed,
    /// so often that a good part of all steps would go there.
    pub(super) fn rests_on(
        &self,
        stretch: &Stretch<'_>,
        kink: usize,
        (time, state): (f64, &[f64]),
    ) -> Option<StopCause> {
        let (_, slope) = self.guard_at(time, state, kink);
        let passages = {
            let passages = &mut self.inner.borrow_mut().passages[kink];
            if passages.count > 0 {
                passages.moves = passages.moves.max((slope * (time - passages.latest)).abs());
            } else {
                passages.since = time;
            }
            passages.latest = time;
            passages.count += 1;
            if passages.count < MANY {
                return None;
            }
            std::mem::take(passages)
        };
        let each = (time - passages.since) / f64::from(MANY - 1);
        if (stretch.until - time) / each < SHARE * stretch.max_steps as f64 {
            return None;
        }
        let (here, _) = self.guard_at(time, state, kink);
        let mut shifted = state.to_vec();
        let moved = (0..self.system.states()).map(|index| {
            let allowed = stretch.atol[index] + stretch.rtol * state[index].abs();
            shifted[index] = state[index] + allowed;
            let (there, _) = self.guard_at(time, &shifted, kink);
            shifted[index] = state[index];
            (index, (there - here).abs())
        });
        let (index, most) = moved.max_by(|a, b| a.1.total_cmp(&b.1))?;
        (passages.moves < STILL * most)
            .then(|| StopCause::RestsOnKink { state: self.system.name(index), value: state[index] })
    }
}
