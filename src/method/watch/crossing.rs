//! The first guard that crosses zero, where a trial step ends.

use super::{Inner, Outcome, Side, Watch, Watched, by_rounding};

/// The first guard that crosses zero, at the end of a trial step.
struct Crossing {
    index: usize,
    /// The side from which it crosses.
    from: f64,
    /// The guard, less its residual at the start of the segment, and its rate.
    guard: f64,
    rate: f64,
}

impl Watch<'_> {
    fn crossing(&self, inner: &mut Inner, time: f64, end: &[f64]) -> Option<Crossing> {
        let (index, _) = inner.first()?;
        let Outcome::Passes { from, .. } = inner.outcomes[index] else { return None };
        let there = self.followed(inner, time, end);
        let (guard, rate) = inner.parts.at(self.system, time, &there, index);
        let residual = inner.zeros[index].map_or(0.0, |zero| zero.residual);
        Some(Crossing { index, from, guard: guard - residual, rate })
    }

    /// Returns whether the first guard that crosses moves the other way at the crossing. The
    /// crossing is then an error of the step, and a shorter step does not cross.
    pub(in crate::method) fn is_of_error(&self, time: f64, end: &[f64]) -> bool {
        let inner = &mut *self.inner.borrow_mut();
        let Some(Crossing { index, from, rate, .. }) = self.crossing(inner, time, end) else {
            return false;
        };
        let was_zero = match self.watched[index] {
            // A guard beyond zero at the end has crossed.
            Watched::Event(_) => {
                let is_back = from * inner.parts.last(index).0 > 0.0;
                is_back && matches!(inner.sides[index], Side::Fresh { .. })
            }
            Watched::Branch(_) => inner.zeros[index].is_some(),
            _ => false,
        };
        was_zero && from * rate > 0.0
    }

    /// Returns the correction to the crossing time `time`, where the state is `end`; `None` if the
    /// guard gives no finite correction.
    pub(in crate::method) fn correction(&self, time: f64, end: &[f64]) -> Option<f64> {
        let inner = &mut *self.inner.borrow_mut();
        let Crossing { index, guard, rate, .. } = self.crossing(inner, time, end)?;
        // Behind a border the function is live, and roots and logarithms may have no finite slope
        // at zero.
        let correction = -guard / rate;
        (correction.is_finite() && !self.watched[index].is_border()).then_some(correction)
    }

    /// Returns whether the event guard that crosses first has not reached zero yet at `time`, where
    /// the state is `end`. The guard is then too steep for Newton's method.
    pub(in crate::method) fn is_short_of(&self, time: f64, end: &[f64]) -> bool {
        let inner = &mut *self.inner.borrow_mut();
        let Some(Crossing { index, from, guard, rate }) = self.crossing(inner, time, end) else {
            return false;
        };
        let zero = inner.parts.rounding(index).max(by_rounding(time, rate));
        !self.is_kink(index) && inner.zeros[index].is_none() && from * guard > zero
    }

    /// Returns whether the first guard that crosses is beyond zero at `time`, where the state is
    /// `end`.
    pub(in crate::method) fn has_passed_at(&self, time: f64, end: &[f64]) -> bool {
        let inner = &mut *self.inner.borrow_mut();
        self.crossing(inner, time, end).is_some_and(|it| it.from * it.guard < 0.0)
    }
}
