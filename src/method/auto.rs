//! Chooses a method by the machine and the tolerance, and changes it when a machine
//! turns out to be stiff, or not to be any more.

#[cfg(feature = "sweep")]
pub(crate) mod in_lanes;
mod ringing;

use machinist_contract::Simulator;
use machinist_contract::taylor::{Bends, TaylorSeries};

use super::exact::Exact;
use super::explicit::ExplicitSteps;
use super::one_step::{Left, OneStep, drive};
use super::radau::RadauSteps;
use super::rosenbrock::RosenbrockSteps;
use super::tableau::{DOP853, Pair, RODAS5P};
use super::taylor::TaylorSteps;
use super::{Integrator, Method, Samples, Sealed, Stopped, Stretch};
use ringing::{LENIENT, rings};

/// So many steps of evidence change the method.
const STIFF_STEPS: usize = 15;
/// So many without it make the evidence void.
const EASY_STEPS: usize = 6;
/// After so many changes within a stretch the run stays with the implicit method,
/// which is never wrong, only slower.
const MOST_CHANGES: usize = 20;
/// An implicit step that is not this much longer than an explicit one could be
/// does not pay for its factorization.
const WORTH: f64 = 2.0;
/// A machine with constraints that neither gains nor loses energy forgets no error: it drifts
/// in energy with every step, and in phase with the square of their number. Its steps are so
/// many times as tight, which makes twice as many of them.
const FAITHFUL: f64 = 300.0;
/// Steps that are tighter only for that are not tighter than this.
const TIGHTEST: f64 = 1e-13;
/// Taylor's method looks for stiffness every so many steps, each of which costs as much
/// as this many rates and more, while a look costs a Jacobian.
const LOOKS_EVERY: usize = 8;

/// Series with more sums of products in an order than this are slower than Runge-Kutta
/// steps. So it is measured on chains of pendulums: of two links they have 12 and are
/// nearly twice as fast, of five 75 and half as fast, of ten 300 and a quarter as fast, at
/// equal errors from 1e-3 to 1e-10.
const MANY_SUMS: usize = 40;
/// At tolerances up to this one Radau's methods cost less than Rosenbrock's, or as much,
/// and keep to it where a spring is all but rigid.
const TIGHT: f64 = 1e-6;
/// Taylor's method goes on where so many steps more would do, stiff or not: an implicit
/// method first has to find its step.
const FEW_STEPS: f64 = 150.0;

/// Solves linear machines without steps where that is exact enough. Otherwise starts
/// with an explicit method; changes to an implicit one where steps are
/// held by stability instead of accuracy, and back where they are not.
pub(super) struct Auto;

impl Sealed for Auto {}

impl Integrator for Auto {
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        // Neither closed forms nor series carry sensitivities.
        let from = if stretch.system.tangents().is_some() {
            stretch.from
        } else {
            let Some(from) = without_steps(stretch, state, samples) else { return Ok(()) };
            from
        };
        let mut rtol = Method::Auto.step_rtol(stretch.rtol);
        if stretch.system.constraints().is_some() && is_conservative(stretch, state) {
            rtol = (rtol / FAITHFUL).max(TIGHTEST.min(rtol));
            stretch.system.note(format!(
                "steps at a relative tolerance of {rtol:.1e}: with constraints and without \
                 losses, errors of steps add up"
            ));
        }
        let atol = Method::tightened(stretch.atol, stretch.rtol, rtol);
        let stretch = &Stretch { from, rtol, atol: &atol, ..*stretch };
        let choice = Choice::new(stretch);
        match choice.explicit {
            Explicit::Taylor(series) => {
                let mut strain = Strain::new(stretch.system.simulator(), choice.limit);
                let look = |method: &TaylorSteps<'_>, step: f64| {
                    let (time, state) = method.start();
                    strain.look(stretch.until - time, step, |values| {
                        stretch.jacobian(time, state, values);
                    })
                };
                let mut method = TaylorSteps::new(stretch, series).looking_within();
                method.begin(stretch.from, state);
                if method.is_cut_short() {
                    stretch.system.note(
                        "dop853 instead of taylor: the solution has no power series at the start, \
                         as where a root begins at zero"
                            .to_owned(),
                    );
                    return choice.by_pair(&DOP853, stretch, state, samples);
                }
                choice.alternate(&mut method, stretch, (state, samples), look)
            }
            Explicit::Pair(pair) => choice.by_pair(pair, stretch, state, samples),
        }
    }
}

/// Whether no power is supplied or dissipated, neither at a state nor at some beside it: then
/// it is exactly zero, for there are no terms of it.
fn is_conservative(stretch: &Stretch<'_>, state: &[f64]) -> bool {
    let simulator = stretch.system.simulator();
    let states = stretch.system.states();
    [0.0, 0.37, -0.61].into_iter().all(|shift| {
        let beside = |index: usize| state[index] + shift * simulator.state_scale(index);
        let beside: Vec<f64> = (0..states).map(beside).collect();
        let time = stretch.from + f64::abs(shift) * (stretch.until - stretch.from);
        let power = simulator.power_balance(time, &beside, stretch.system.parameters());
        power.supplied == 0.0 && power.dissipated == 0.0
    })
}

/// Solves a linear machine in closed form as far as that is exact enough, or more exact
/// than steps would be; the time from which on it is not, if there is one.
fn without_steps(
    stretch: &Stretch<'_>,
    state: &mut [f64],
    samples: &mut Samples<'_>,
) -> Option<f64> {
    let stopped = Exact.integrate(stretch, state, samples).err()?;
    let rest = Stretch { from: stopped.time, ..*stretch };
    if !rings(&rest) {
        return Some(rest.from);
    }
    let lenient = Stretch { rtol: LENIENT * rest.rtol, ..rest };
    let stopped = Exact.integrate(&lenient, state, samples);
    if stopped.is_ok() {
        stretch.system.note(format!(
            "in closed form though rounding exceeds the relative tolerance of {:e}: it rings \
             for so long that steps would add up to more",
            stretch.rtol
        ));
    }
    stopped.err().map(|stopped| stopped.time)
}

/// The methods for a machine and a tolerance. Another one, of any kind, is one more
/// case here.
struct Choice<'a> {
    explicit: Explicit<'a>,
    explicit_name: &'static str,
    /// Where |h lambda| is larger, stability holds the explicit method's steps.
    limit: f64,
    implicit_name: &'static str,
    is_tight: bool,
}

#[derive(Clone, Copy)]
enum Explicit<'a> {
    Taylor(&'a dyn TaylorSeries<f64>),
    Pair(&'static Pair),
}

impl<'a> Choice<'a> {
    fn new(stretch: &Stretch<'a>) -> Self {
        let rtol = stretch.rtol;
        let has_tangents = stretch.system.tangents().is_some();
        // Of the implicit methods only Radau's carry sensitivities.
        let is_tight = rtol <= TIGHT || has_tangents;
        let implicit_name = if is_tight { "radau" } else { "rodas5p" };
        let of_pair = |name, pair: &'static Pair| Self {
            explicit: Explicit::Pair(pair),
            explicit_name: name,
            limit: pair.stability,
            implicit_name,
            is_tight,
        };
        let pair = of_pair("dop853", &DOP853);
        let (series, why) = if has_tangents {
            (None, "")
        } else {
            suitable_series(stretch.system.simulator(), rtol)
        };
        let chosen = match series {
            None => pair,
            Some(series) => Self {
                explicit: Explicit::Taylor(series),
                explicit_name: "taylor",
                limit: taylor_limit(TaylorSteps::order_for(rtol)),
                ..pair
            },
        };
        stretch.system.note(format!(
            "starts with {}, for a relative tolerance of {rtol:e}{why}",
            chosen.explicit_name
        ));
        chosen
    }

    fn by_pair(
        &self,
        pair: &'static Pair,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        let choice = Self { explicit_name: "dop853", limit: pair.stability, ..*self };
        let look = |method: &ExplicitSteps<'_>, _| Some(method.stiffness());
        let mut method = ExplicitSteps::new(pair, stretch);
        method.begin(stretch.from, state);
        choice.alternate(&mut method, stretch, (state, samples), look)
    }

    /// Goes on by an explicit method that has begun while nothing is stiff, and implicitly
    /// while something is; `look` gives |h lambda| after a step of the explicit method, or
    /// nothing if it has not looked.
    fn alternate<M: OneStep>(
        &self,
        explicit: &mut M,
        stretch: &Stretch<'_>,
        (state, samples): (&mut [f64], &mut Samples<'_>),
        mut look: impl FnMut(&M, f64) -> Option<f64>,
    ) -> Result<(), Stopped> {
        let mut at = Left { time: stretch.from, step: explicit.first_step() };
        let mut changes = 0;
        loop {
            let mut evidence = Evidence::default();
            let mut seen = 0.0;
            let is_stiff = |method: &M, step| {
                look(method, step).is_some_and(|strain| {
                    seen = strain;
                    evidence.grows(strain > self.limit)
                })
            };
            let Some(left) = drive(explicit, stretch, at, state, samples, is_stiff)? else {
                return Ok(());
            };
            stretch.system.note(format!(
                "{} instead of {} from t = {:.6} s on: steps were held by stability, \
                 |h lambda| = {seen:.1}",
                self.implicit_name, self.explicit_name, left.time,
            ));
            changes += 2;
            let may_return = changes < MOST_CHANGES;
            let Some(left) = self.implicit_stretch(stretch, left, state, samples, may_return)?
            else {
                return Ok(());
            };
            stretch.system.note(format!(
                "{} instead of {} from t = {:.6} s on: no longer stiff",
                self.explicit_name, self.implicit_name, left.time
            ));
            explicit.begin(left.time, state);
            at = Left { step: explicit.own_step().unwrap_or(left.step), ..left };
        }
    }

    /// Goes on implicitly, until it would do explicitly.
    fn implicit_stretch(
        &self,
        stretch: &Stretch<'_>,
        from: Left,
        state: &mut [f64],
        samples: &mut Samples<'_>,
        may_return: bool,
    ) -> Result<Option<Left>, Stopped> {
        let mut radius = SpectralRadius::new(stretch.system.simulator());
        let mut evidence = Evidence::default();
        let mut is_easy = |jacobian: &[f64], step: f64| {
            let explicit_step = self.limit / radius.renew(jacobian);
            evidence.grows(step < WORTH * explicit_step) && may_return
        };
        if self.is_tight {
            let mut method = RadauSteps::new(stretch);
            method.begin(from.time, state);
            let leave = |method: &RadauSteps<'_>, step| is_easy(method.jacobian(), step);
            drive(&mut method, stretch, from, state, samples, leave)
        } else {
            let mut method = RosenbrockSteps::new(&RODAS5P, stretch);
            method.begin(from.time, state);
            let leave = |method: &RosenbrockSteps<'_>, step| is_easy(method.jacobian(), step);
            drive(&mut method, stretch, from, state, samples, leave)
        }
    }
}

/// The machine's series, if a run by it is likely to be right and the fastest; and why
/// not, where it has one.
fn suitable_series(
    simulator: &dyn Simulator<f64>,
    rtol: f64,
) -> (Option<&dyn TaylorSeries<f64>>, &'static str) {
    let Some(series) = simulator.taylor() else { return (None, "") };
    if series.bends() == Bends::Corners {
        let why = "; not with taylor, whose long steps do not see branches and tables from afar";
        return (None, why);
    }
    let order = TaylorSteps::order_for(rtol);
    // Of every sum its two factors are kept, from order to order.
    if series.series_workspace(order) > 2 * MANY_SUMS * order {
        return (None, "; not with taylor, whose series have many sums");
    }
    (Some(series), "")
}

/// |h lambda| up to which Taylor's method of an order is stable, less a fifth, for steps
/// that are held by stability vary around it.
///
/// |1 + z + ... + z^p/p!| <= 1 on the negative real axis down to about
/// -(0.368 p + 1.4), and in other directions to the left about as far: the region is
/// that of |z e^(1 - z/p)| <= p, grown by a part that becomes small (G. Szegoe, 1924;
/// R. Jeltsch, O. Nevanlinna, Numerische Mathematik 37, 1981). Steps held by accuracy
/// end at less than half of it, for terms decay to the tolerance.
fn taylor_limit(order: usize) -> f64 {
    0.8 * (order as f64 / std::f64::consts::E + 1.4)
}

/// How near Taylor's method is to the limit of its stability.
struct Strain<'a> {
    radius: SpectralRadius<'a>,
    jacobian: Vec<f64>,
    limit: f64,
    steps: usize,
    is_near: bool,
}

impl<'a> Strain<'a> {
    fn new(simulator: &'a dyn Simulator<f64>, limit: f64) -> Self {
        let entries = simulator.rate_jacobian_pattern().entries.len();
        Self {
            radius: SpectralRadius::new(simulator),
            jacobian: vec![0.0; entries],
            limit,
            steps: 0,
            is_near: false,
        }
    }

    /// |h lambda| after a step, `left` of the stretch being left: now and then, and after every
    /// one beyond the limit; not where few steps are left.
    fn look(&mut self, left: f64, step: f64, jacobian: impl FnOnce(&mut [f64])) -> Option<f64> {
        self.steps += 1;
        let is_due = self.is_near || self.steps.is_multiple_of(LOOKS_EVERY);
        if !is_due || left < FEW_STEPS * step {
            return None;
        }
        jacobian(&mut self.jacobian);
        self.radius.renew(&self.jacobian);
        let strain = step * self.radius.renew(&self.jacobian);
        self.is_near = strain > self.limit;
        Some(strain)
    }
}

/// Steps that speak for a change, not too far apart (Hairer, Wanner, section
/// IV.2).
#[derive(Default)]
struct Evidence {
    found: usize,
    missed: usize,
}

impl Evidence {
    /// Takes the evidence of one step; true if it is enough.
    fn grows(&mut self, is_evidence: bool) -> bool {
        if is_evidence {
            self.missed = 0;
            self.found += 1;
        } else {
            self.missed += 1;
            if self.missed == EASY_STEPS {
                self.found = 0;
            }
        }
        self.found >= STIFF_STEPS
    }
}

/// Largest |eigenvalue| of the Jacobian, by one more power of it a step.
struct SpectralRadius<'a> {
    entries: &'a [(u32, u32)],
    vector: Vec<f64>,
    next: Vec<f64>,
    estimate: f64,
}

impl<'a> SpectralRadius<'a> {
    fn new(simulator: &'a dyn Simulator<f64>) -> Self {
        let size = simulator.shape().states();
        // Anything but an eigenvector.
        let vector = (0..size).map(|index| 1.0 + 0.1 * ((index % 7) as f64)).collect();
        let entries = simulator.rate_jacobian_pattern().entries;
        Self { entries, vector, next: vec![0.0; size], estimate: 0.0 }
    }

    /// The estimate after two more multiplications: the square root of the growth
    /// over both, for one alone turns positions into accelerations and says
    /// nothing. It decays slowly, so that a vector that happens to be short of
    /// the fastest motion does not make a machine look easy.
    fn renew(&mut self, jacobian: &[f64]) -> f64 {
        let growth = self.multiply(jacobian) * self.multiply(jacobian);
        let radius = growth.sqrt();
        if radius.is_finite() {
            self.estimate = radius.max(0.9 * self.estimate);
        }
        self.estimate
    }

    /// vector = J vector, then made of length 1; gives the length it had.
    fn multiply(&mut self, jacobian: &[f64]) -> f64 {
        self.next.fill(0.0);
        for (&(row, column), value) in self.entries.iter().zip(jacobian) {
            self.next[row as usize] += value * self.vector[column as usize];
        }
        let length = |vector: &[f64]| vector.iter().map(|v| v * v).sum::<f64>().sqrt();
        let (before, after) = (length(&self.vector), length(&self.next));
        if after > 0.0 && after.is_finite() {
            for (vector, next) in self.vector.iter_mut().zip(&self.next) {
                *vector = next / after;
            }
        }
        after / before
    }
}
