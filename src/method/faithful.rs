//! Machines in which errors of steps add up to many times the tolerance, or grow.

use machinist_contract::{Reader, Simulator};

use super::loose::LOOSEST_OF_MANY;
use super::stretch::Tolerances;
use super::{Method, Stretch};

/// Factor by which steps are tightened for a machine with constraints that conserves energy. It
/// forgets no error: its energy drifts with every step, and its phase with the square of their
/// number. This makes two or three times as many steps.
const FAITHFUL: f64 = 300.0;
/// Lower bound of tolerances that are tightened only for this reason.
const TIGHTEST: f64 = 1e-13;

/// Returns whether steps at this relative tolerance may be no tighter than at a looser one.
pub(crate) fn takes_tightest_steps(rtol: f64) -> bool {
    rtol / FAITHFUL < TIGHTEST
}

/// Returns whether no power is supplied or dissipated: by the structure of the machine, or else,
/// where it tells nothing, at a state and at some nearby.
pub(super) fn is_conservative(
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

/// Returns tolerances at which errors of a method's steps do not add up to many times those of a
/// stretch; `None` if these are sufficient.
pub(super) fn faithful_tolerances(
    method: Method,
    stretch: &Stretch<'_>,
    state: &[f64],
) -> Option<Tolerances> {
    let (system, span) = (stretch.system, (stretch.from, stretch.until));
    let drifts = system.constraints().is_some()
        && is_conservative(system.simulator(), system.parameters(), span, state);
    if !drifts {
        return tolerances_at_kinks(method, stretch);
    }
    let rtol = stretch.rtol.min(LOOSEST_OF_MANY) / FAITHFUL;
    Some(tightened(stretch, rtol, "with constraints and without losses, errors of steps add up"))
}

/// Returns whether the rate has kinks; those that only guards of events read do not count.
pub(super) fn has_kinks(simulator: &dyn Simulator<f64>) -> bool {
    let is_of_rate = |index| simulator.relation(index).readers.contains(&Reader::Rate);
    let relations = simulator.relations();
    simulator.kinks() > relations || (0..relations).any(is_of_rate)
}

/// Returns tolerances as far as kinks are concerned.
pub(super) fn tolerances_at_kinks(method: Method, stretch: &Stretch<'_>) -> Option<Tolerances> {
    let stricter = method.stricter_at_kinks();
    (stricter > 1.0 && has_kinks(stretch.system.simulator())).then(|| {
        let why = format!("errors of {method} grow at switching surfaces");
        tightened(stretch, stretch.rtol / stricter, &why)
    })
}

fn tightened(stretch: &Stretch<'_>, rtol: f64, why: &str) -> Tolerances {
    let rtol = rtol.max(TIGHTEST.min(stretch.rtol));
    stretch.system.note(format!("steps at a relative tolerance of {rtol:.1e}: {why}"));
    (rtol, Method::tightened(stretch.atol, stretch.rtol, rtol))
}

impl Method {
    /// Factor by which steps are tighter if a machine has kinks: an error before a part sticks or
    /// hits changes the time at which it does, and this error grows. Measured with a block on a
    /// belt and a spring with backlash (`cargo bench -p machinist-tests --features measure --bench
    /// tolerances`). `auto` and `radau` are cautious by themselves; the others are measured as they
    /// are.
    fn stricter_at_kinks(self) -> f64 {
        match self {
            Self::Tsit5 => 50.0,
            Self::Dop853 | Self::Rodas5p | Self::Taylor => 10.0,
            _ => 1.0,
        }
    }
}
