//! Whether a run by `auto` may step as loosely as it is asked to.
//!
//! Errors of steps add up where nothing forgets them: over thousands of periods steps at a
//! tolerance of 1e-3 end anywhere, and no step tells. In few steps they cannot add up to much. How
//! many a run takes it shows itself, so it is tried with the tolerance that is asked for; once its
//! steps are too many for the time that they have come, it begins anew with tighter ones.

use machinist_contract::taylor::{Bends, TaylorSeries};
use machinist_contract::{Real, Simulator};

use super::faithful::is_conservative;
use super::{Method, Problem, Run, Stopped};
use crate::error::StopCause;

/// Steps of `auto` are never looser than this where they are many: two digits less save less than
/// half the time.
pub(crate) const LOOSEST_OF_MANY: f64 = 1e-5;

/// Nor than this where they are few: what slips when a force is large enough slips later by part of
/// its period, and by a hundredth of that no motion is known any more.
const LOOSEST: f64 = 1e-3;

/// So many steps are few.
const FEW: f64 = 400.0;

/// A run that is tried with loose steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Trial {
    /// The relative tolerance of its steps.
    pub(super) rtol: f64,
    from: f64,
    /// Length of the run \[s\].
    whole: f64,
    /// Steps that were counted before it.
    before: u64,
    /// So many are few.
    few: f64,
    is_over: bool,
}

impl Trial {
    /// Whether it is over, after so many steps counted until a time.
    pub(super) fn is_over_at(&mut self, steps: u64, time: f64) -> bool {
        let steps = (steps - self.before) as f64;
        let [least, passed] = has_passed((steps, self.few), time - self.from, self.whole);
        self.is_over |= passed < least;
        self.is_over
    }
}

/// What a run must have passed after so many steps, and what it has, in the same unit: after n steps
/// where N are few, the share (n/N)^2 of its time. So a run whose steps are all alike is left the
/// sooner the longer it would take, and short steps at its start are forgiven.
pub(super) fn has_passed<R: Real>((steps, few): (R, R), passed: R, whole: R) -> [R; 2] {
    [steps * steps * whole, few * few * passed]
}

/// How many steps from a state on are few; none of a machine of which errors of single steps say
/// little. One that neither gains nor loses energy forgets nothing, and its pace errs with its
/// energy: errors of its motion grow with the square of its steps. One that switches does so at
/// another time, or not at all.
pub(crate) fn few(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    span: (f64, f64),
    state: &[f64],
) -> f64 {
    let bends = simulator.taylor().map(TaylorSeries::bends);
    let switches = simulator.events() > 0 || simulator.kinks() > 0 || bends == Some(Bends::Corners);
    let forgets = || !is_conservative(simulator, parameters, span, state);
    if simulator.constraints() == 0 && !switches && forgets() { FEW } else { 0.0 }
}

impl Method {
    /// The relative tolerance of steps where they may be many.
    pub(crate) fn step_rtol(self, rtol: f64) -> f64 {
        if self == Self::Auto { rtol.min(LOOSEST_OF_MANY) } else { rtol }
    }

    /// Relative tolerances that the steps of a run keep to, one after the other until it has ended,
    /// and of each whether it is left where steps are too many.
    pub(crate) fn paces(self, rtol: f64) -> impl Iterator<Item = (f64, bool)> {
        let of_many = self.step_rtol(rtol);
        let of_few = (rtol > of_many).then_some((rtol.min(LOOSEST), true));
        of_few.into_iter().chain([(of_many, false)])
    }
}

impl Problem<'_> {
    /// The run with loose steps, if these are looser than where they are many, and if it has
    /// ended so, or could not by others.
    pub(super) fn tried_loosely(&self, method: Method) -> Option<(Run, Option<Stopped>)> {
        let (rtol, is_left) = method.paces(self.rtol).next()?;
        let system = self.system;
        // What carries sensitivities does not begin anew.
        if !is_left || system.tangents().is_some() {
            return None;
        }
        let (from, whole) = (self.from, self.until - self.from);
        let span = (from, self.until);
        let few = few(system.simulator(), system.parameters(), span, &self.initial);
        if few == 0.0 {
            return None;
        }
        let (notes, before) = (system.notes().len(), system.work().steps);
        system.tries(Some(Trial { rtol, from, whole, before, few, is_over: false }));
        let (run, stopped) = self.integrate_once(method);
        let is_over = system.tries(None).is_some_and(|trial| trial.is_over);
        let is_final = match &stopped {
            None | Some(Stopped { cause: StopCause::TooManySteps { .. }, .. }) => true,
            Some(_) => !is_over && system.interruption().is_some(),
        };
        if is_final {
            return Some((run, stopped));
        }
        system.forget_notes(notes);
        None
    }
}
