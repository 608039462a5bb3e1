//! Machines of which errors of steps add up to many times the tolerance, or grow.

use machinist_contract::Simulator;

use super::loose::LOOSEST_OF_MANY;
use super::stretch::Tolerances;
use super::{Method, Stretch};

/// A machine with constraints that neither gains nor loses energy forgets no error: it drifts
/// in energy with every step, and in phase with the square of their number. Its steps are so
/// many times as tight, which makes two or three times as many of them.
const FAITHFUL: f64 = 300.0;
/// Steps that are tighter only for that are not tighter than this.
const TIGHTEST: f64 = 1e-13;

/// True if steps at this relative tolerance may be no tighter than at a looser one.
pub(crate) fn takes_tightest_steps(rtol: f64) -> bool {
    rtol / FAITHFUL < TIGHTEST
}

/// True if no power is supplied or dissipated: as the structure of the machine says, or else, where
/// it says nothing, neither at a state nor at some beside it.
pub(super) fn is_conservative(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    span: (f64, f64),
    state: &[f64],
) -> bool {
    let near = || is_conservative_near(simulator, parameters, span, state);
    simulator.conserves_energy(parameters).unwrap_or_else(near)
}

/// Powers that are exactly zero at some states have no terms.
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

/// Tolerances at which errors of a method's steps do not add up to many times those of a stretch;
/// nothing if these will do.
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

/// Likewise, as far as kinks are concerned.
pub(super) fn tolerances_at_kinks(method: Method, stretch: &Stretch<'_>) -> Option<Tolerances> {
    let stricter = method.stricter_at_kinks();
    (stricter > 1.0 && stretch.system.simulator().kinks() > 0).then(|| {
        let why = format!("where there are kinks, errors of {method} grow");
        tightened(stretch, stretch.rtol / stricter, &why)
    })
}

fn tightened(stretch: &Stretch<'_>, rtol: f64, why: &str) -> Tolerances {
    let rtol = rtol.max(TIGHTEST.min(stretch.rtol));
    stretch.system.note(format!("steps at a relative tolerance of {rtol:.1e}: {why}"));
    (rtol, Method::tightened(stretch.atol, stretch.rtol, rtol))
}

impl Method {
    /// Where a machine has kinks, steps are so many times as tight: what sticks or hits does so at
    /// another time by an error before, and that grows. Measured by a block on a belt and by a
    /// spring with play (`cargo bench -p machinist-tests --features measure --bench tolerances`).
    /// `auto` and `radau` are cautious by themselves; what others offer is measured as it is.
    fn stricter_at_kinks(self) -> f64 {
        match self {
            Self::Tsit5 => 50.0,
            Self::Dop853 | Self::Rodas5p | Self::Taylor => 10.0,
            _ => 1.0,
        }
    }
}
