//! Decision of `auto` whether a run may step as loosely as requested.
//!
//! Errors of steps add up where nothing forgets them: over thousands of periods, steps at a
//! tolerance of 1e-3 end anywhere, and no single step shows it. In few steps they cannot add up to
//! much. The number of steps shows only during the run, so the requested tolerance is tried. Once
//! there are too many steps for the time covered, the run starts again with tighter ones.

use machinist_contract::taylor::{Bends, TaylorSeries};
use machinist_contract::{Real, Simulator};

use super::{Method, Problem, Run, Stopped};
use crate::error::StopCause;

/// Loosest tolerance of `auto` in runs of many steps: two digits less save less than half the time.
pub(crate) const LOOSEST_OF_MANY: f64 = 1e-5;

/// Loosest tolerance of `auto` in runs of few steps: a part that slips when a force is large enough
/// slips later by a share of its period, and by a hundredth of that no motion is known any more.
const LOOSEST: f64 = 1e-3;

/// Number of steps that counts as few.
const FEW: f64 = 400.0;

/// A run that is tried with loose steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Trial {
    /// Relative tolerance of its steps.
    pub(super) rtol: f64,
    from: f64,
    /// Length of the run \[s\].
    whole: f64,
    /// Steps counted before it.
    before: u64,
    /// Number of steps that counts as few.
    few: f64,
    is_over: bool,
}

impl Trial {
    /// Returns whether the trial is over, after this many steps up to a time.
    pub(super) fn is_over_at(&mut self, steps: u64, time: f64) -> bool {
        let steps = (steps - self.before) as f64;
        let [least, passed] = has_passed((steps, self.few), time - self.from, self.whole);
        self.is_over |= passed < least;
        self.is_over
    }
}

/// Returns the share of a run's time to be covered after some steps and the share that is covered,
/// in the same unit: after n steps, of which N are few, (n/N)^2 of its time. A run with equal steps
/// is then abandoned the sooner the longer it would take, and short steps at its start are
/// forgiven.
pub(super) fn has_passed<R: Real>((steps, few): (R, R), passed: R, whole: R) -> [R; 2] {
    [steps * steps * whole, few * few * passed]
}

/// Returns the number of steps from a state on that counts as few; zero for a machine in which
/// errors of single steps say little. A machine that conserves energy forgets nothing, and its pace
/// errs with its energy: errors of its motion grow with the square of its steps. A machine that
/// switches does so at another time, or not at all.
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

/// Returns whether no power is supplied or dissipated: by the structure of the machine, or else,
/// where it tells nothing, at a state and at some nearby.
fn is_conservative(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    span: (f64, f64),
    state: &[f64],
) -> bool {
    let near = || is_conservative_near(simulator, parameters, span, state);
    simulator.conserves_energy(parameters).unwrap_or_else(near)
}

/// Powers that are exactly zero at several states have no terms.
fn is_conservative_near(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    (from, until): (f64, f64),
    state: &[f64],
) -> bool {
    let states = simulator.shape().states();
    [0.0, 0.37, -0.61].into_iter().all(|shift| {
        let beside = |index: usize| state[index] + shift * simulator.state_scale(index);
        let beside: Vec<f64> = (0..states).map(beside).collect();
        let time = from + f64::abs(shift) * (until - from);
        let power = simulator.power_balance(time, &beside, parameters);
        power.supplied == 0.0 && power.dissipated == 0.0
    })
}

impl Method {
    /// Returns the relative tolerance of steps where they may be many.
    pub(crate) fn step_rtol(self, rtol: f64) -> f64 {
        if self == Self::Auto { rtol.min(LOOSEST_OF_MANY) } else { rtol }
    }

    /// Returns the relative tolerances of the steps of a run, to be tried one after another until
    /// it ends, each with whether it is abandoned after too many steps.
    pub(crate) fn paces(self, rtol: f64) -> impl Iterator<Item = (f64, bool)> {
        let of_many = self.step_rtol(rtol);
        let of_few = (rtol > of_many).then_some((rtol.min(LOOSEST), true));
        of_few.into_iter().chain([(of_many, false)])
    }
}

impl Problem<'_> {
    /// Returns the run with loose steps, if these are looser than where they are many, and if it
    /// ended this way, or would not end otherwise.
    pub(super) fn tried_loosely(&self, method: Method) -> Option<(Run, Option<Stopped>)> {
        let (rtol, is_left) = method.paces(self.rtol).next()?;
        let system = self.system;
        // A run that carries sensitivities does not start again.
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
