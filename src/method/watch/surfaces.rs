//! Surfaces along which a motion slides and which it leaves at a jump: no finite force follows a
//! surface that jumps, or brings back a state that is moved off it.

use super::{Watch, Watched};
use crate::method::sliding::Order;

impl Watch<'_> {
    /// Ends the sliding along surfaces off which a jump takes the motion, from a time and state to
    /// others.
    pub(in crate::method) fn leave_surfaces(
        &self,
        (front, before): (f64, &[f64]),
        (behind, after): (f64, &[f64]),
    ) {
        let mut slides = self.system.slides();
        if slides.is_empty() {
            return;
        }
        let of = |time: f64, state: &[f64]| {
            (self.system.kink_guards(time, state), self.system.kink_rates(time, state))
        };
        let ((guards, rates), (guards_after, rates_after)) = (of(front, before), of(behind, after));
        slides.retain(|slide| {
            let relation = slide.relation;
            let place = self.watched.iter().position(|it| it.relation() == Some(relation));
            let rounding = place.map_or(0.0, |place| self.inner.borrow().parts.rounding(place));
            let passed = (behind - front) * rates[relation].abs().max(rates_after[relation].abs());
            let has_left = (guards_after[relation] - guards[relation]).abs() > rounding + passed;
            let has_turned = slide.order == Order::Second
                && rates_after[relation].to_bits() != rates[relation].to_bits();
            !(has_left || has_turned)
        });
        self.system.slide(&slides);
    }

    /// Ends the sliding along surfaces off which a state is by more than the tolerances, at the start
    /// of a piece of a run: inputs or parameters have changed, or the rate jumps there.
    pub(in crate::method) fn leave_distant_surfaces(&self, time: f64, state: &[f64]) {
        let mut slides = self.system.slides();
        if slides.is_empty() {
            return;
        }
        let guards = self.system.kink_guards(time, state);
        slides.retain(|slide| {
            let of = |it: &Watched| it.relation() == Some(slide.relation);
            let blur = self.watched.iter().position(of).map(|place| self.blur(place, time, state));
            let off = guards[slide.relation] - slide.sides.level();
            blur.is_none_or(|blur| off.abs() <= blur)
        });
        self.system.slide(&slides);
    }
}
