//! Surfaces along which a motion slides and which it leaves at a jump: no finite force follows a
//! surface that jumps, or brings back a state that is moved off it.

use super::Watch;
use crate::method::sliding::Order;

/// Guards of relations and borders, and their rates, in front of a jump.
pub(in crate::method) struct Surfaces {
    guards: Vec<f64>,
    rates: Vec<f64>,
}

impl Watch<'_> {
    /// Returns the guards at a time and state, if the motion slides along a surface.
    pub(in crate::method) fn surfaces(&self, time: f64, state: &[f64]) -> Option<Surfaces> {
        self.system.is_sliding().then(|| Surfaces {
            guards: self.system.kink_guards(time, state),
            rates: self.system.kink_rates(time, state),
        })
    }

    /// Ends the sliding along surfaces off which a jump takes the motion, from the guards in front of
    /// it to a time and state behind it. `passed` is the time between.
    pub(in crate::method) fn leave_surfaces(
        &self,
        front: Option<Surfaces>,
        (time, state): (f64, &[f64]),
        passed: f64,
    ) {
        let Some((front, behind)) = front.zip(self.surfaces(time, state)) else { return };
        let mut slides = self.system.slides();
        slides.retain(|slide| {
            let [guard, rate] = [(&front.guards, &behind.guards), (&front.rates, &behind.rates)]
                .map(|(front, behind)| [front[slide.relation], behind[slide.relation]]);
            let rounding =
                self.place_of(slide.relation).map_or(0.0, |place| self.rounding_of(place));
            let way = passed * rate[0].abs().max(rate[1].abs());
            let has_left = (guard[1] - guard[0]).abs() > rounding + way;
            let has_turned = slide.order == Order::Second && rate[0].to_bits() != rate[1].to_bits();
            !(has_left || has_turned)
        });
        self.system.slide(&slides);
    }

    /// Ends the sliding along surfaces off which a state is by more than the tolerances, at the start
    /// of a piece of a run: inputs or parameters have changed, or the rate jumps there.
    pub(in crate::method) fn leave_distant_surfaces(&self, time: f64, state: &[f64]) {
        let Some(here) = self.surfaces(time, state) else { return };
        let mut slides = self.system.slides();
        slides.retain(|slide| {
            let blur = self.place_of(slide.relation).map(|place| self.blur(place, time, state));
            let off = here.guards[slide.relation] - slide.sides.level();
            blur.is_none_or(|blur| off.abs() <= blur)
        });
        self.system.slide(&slides);
    }

    /// Returns the place of the first watched function of a relation.
    fn place_of(&self, relation: usize) -> Option<usize> {
        self.watched.iter().position(|it| it.relation() == Some(relation))
    }
}
