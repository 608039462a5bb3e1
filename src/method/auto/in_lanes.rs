//! Checks of `auto` on the steps of Taylor's method, where variants take them side by side.
//!
//! A variant stays in its lane for as long as a run of its own would continue by Taylor's method,
//! with bitwise equal results. A variant that would change the method leaves its lane. Lanes are
//! checked side by side, and only those that are due.

use machinist_contract::{SideBySide, Simulator};

use super::stiffness::{
    Evidence, LOOKS_EVERY, STIFF_STEPS, SpectralRadius, few_steps, worth_beginning,
};
use super::{Series, taylor_limit};
use crate::lanes::Lanes;
use crate::method::stretch::within;
use crate::method::taylor::FEW;
use crate::method::taylor::step::order_for;
use crate::method::taylor::variants::{Equations, Moment, Overseer, Variant, places};

/// Returns whether `auto` runs a machine by Taylor's method alone until something becomes stiff, in
/// steps of a relative tolerance.
pub(crate) fn goes_in_lanes(simulator: &dyn Simulator<f64>, rtol: f64) -> bool {
    let is_plain = simulator.events() == 0
        && simulator.kinks() == 0
        && simulator.constraints() == 0
        && simulator.linear().is_none();
    is_plain && matches!(Series::of(simulator, rtol), Series::Suits(_))
}

/// Checks the steps of all lanes.
pub(crate) struct Lookout<'a, R> {
    machine: &'a dyn SideBySide<R>,
    limit: f64,
    few: f64,
    worth_beginning: f64,
    /// Spectral radius for stretches that begin.
    beginning: SpectralRadius<'a, R>,
    radius: SpectralRadius<'a, R>,
    jacobian: Vec<R>,
    /// Number of steps of every lane until the next check.
    wait: R,
    /// Lanes that were beyond the limit at the last check, as bits.
    near: u32,
    evidence: Vec<Evidence>,
}

impl<'a, R: Lanes> Lookout<'a, R> {
    /// Returns the checks for steps of a relative tolerance.
    pub(crate) fn new(machine: &'a dyn SideBySide<R>, rtol: f64) -> Self {
        let states = machine.shape().states();
        Self {
            machine,
            limit: taylor_limit(order_for(rtol)),
            few: few_steps(states),
            worth_beginning: worth_beginning(states),
            beginning: SpectralRadius::new(machine),
            radius: SpectralRadius::new(machine),
            jacobian: vec![R::literal(0.0); machine.rate_jacobian_pattern().entries.len()],
            wait: R::literal(0.0),
            near: 0,
            evidence: (0..R::COUNT).map(|_| Evidence::of(STIFF_STEPS)).collect(),
        }
    }

    /// Returns the lanes in which stability would require so many steps that an implicit method
    /// begins.
    fn held(&mut self, at: &Moment<'_, R>) -> u32 {
        at.equations.jacobian(at.time, at.state, &mut self.jacobian);
        let limits = at.left / R::literal(self.limit);
        let steps = limits * self.beginning.settled(&self.jacobian);
        R::less(R::literal(self.worth_beginning), steps)
    }
}

impl<R: Lanes> Overseer<R> for Lookout<'_, R> {
    fn leaving(&mut self, variants: &[Variant]) -> Vec<bool> {
        let mut equations = Equations::new(self.machine);
        let mut state = vec![R::literal(0.0); self.machine.shape().states()];
        let of_bundle = |variants: &[Variant]| {
            let [mut time, mut left] = [R::literal(0.0); 2];
            for index in 0..R::COUNT {
                // An idle lane repeats the first.
                let variant = variants.get(index).unwrap_or(&variants[0]);
                let span @ (from, until) = (variant.ends[0], variant.ends[1]);
                time.set_lane(index, within(from, span));
                left.set_lane(index, until - from);
                equations.load(index, &variant.parameters);
                for (into, value) in state.iter_mut().zip(&variant.initial) {
                    into.set_lane(index, *value);
                }
            }
            equations.prepare();
            let held = self.held(&Moment { equations: &equations, time, left, state: &state });
            (0..variants.len()).map(move |index| held >> index & 1 == 1)
        };
        variants.chunks(R::COUNT).flat_map(of_bundle).collect()
    }

    fn begin(&mut self, lanes: u32, at_start: u32, terms: R, at: &Moment<'_, R>) -> u32 {
        let mut begun = R::literal(0.0);
        for index in places(lanes) {
            begun.set_lane(index, 1.0);
            self.evidence[index] = Evidence::of(STIFF_STEPS);
        }
        self.radius.begin(begun);
        let every = R::literal(LOOKS_EVERY as f64);
        self.wait = R::select_less(R::literal(0.5), begun, every, self.wait);
        self.near &= !lanes;
        let cut_short = R::less(terms, R::literal((FEW + 1) as f64));
        let asked = lanes & !at_start;
        let held = if asked == 0 { 0 } else { asked & self.held(at) };
        lanes & (cut_short | held)
    }

    fn look(&mut self, (passed, good): (u32, R), step: R, at: &Moment<'_, R>) -> u32 {
        let (zero, half) = (R::literal(0.0), R::literal(0.5));
        self.wait = self.wait - good;
        let waited = R::less(self.wait, half);
        if passed & (waited | self.near) == 0 {
            return 0;
        }
        let every = R::literal(LOOKS_EVERY as f64);
        self.wait = R::select_less(self.wait, half, every, self.wait);
        let has_few = R::less(at.left, R::literal(self.few) * step);
        let due = passed & (waited | self.near) & !has_few;
        if due == 0 {
            return 0;
        }
        let mut takes = zero;
        for index in places(due) {
            takes.set_lane(index, 1.0);
        }
        at.equations.jacobian(at.time, at.state, &mut self.jacobian);
        let strain = step * self.radius.looked_at(&self.jacobian, takes);
        let beyond = R::less(R::literal(self.limit), strain);
        self.near = self.near & !due | beyond & due;
        let is_enough = |index: &usize| self.evidence[*index].grows(beyond >> index & 1 == 1);
        places(due).filter(is_enough).fold(0, |leaving, index| leaving | 1 << index)
    }
}
