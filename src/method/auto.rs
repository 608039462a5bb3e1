//! Chooses a method by the machine and the tolerance, and changes it when a machine becomes stiff
//! or is no longer stiff.

#[cfg(feature = "sweep")]
pub(crate) mod in_lanes;
mod ringing;
mod rival;
mod stiffness;

use machinist_contract::Simulator;
use machinist_contract::taylor::TaylorSeries;

use super::exact::Exact;
use super::explicit::ExplicitSteps;
use super::one_step::{OneStep, ResumePoint, drive};
use super::radau::RadauSteps;
use super::rosenbrock::RosenbrockSteps;
use super::tableau::{DOP853, Pair, RODAS5P, TSIT5};
use super::taylor::TaylorSteps;
use super::{ExplicitMethod, ImplicitMethod, Integrator, Samples, Sealed, Stopped, Stretch};
use ringing::{LENIENT, rings};
use rival::Rival;
use stiffness::{
    Evidence, LOOKS_EVERY, LOOKS_OF_PAIR_EVERY, Retry, STIFF_STEPS, SpectralRadius, Strain,
    TRANSIENT, is_worth_beginning, worth,
};

/// Number of changes within a stretch after which the run stays with the implicit method, which is
/// never wrong, only slower.
const MOST_CHANGES: usize = 20;
/// Number of sums of products in an order above which a run begins with Runge-Kutta steps, and changes
/// to series only if these prove longer ([`Rival`]). Measured on chains of pendulums at equal errors
/// from 1e-3 to 1e-10: with two links they have 12 sums and are nearly twice as fast, with five 75
/// and half as fast, with ten 300 and a quarter as fast. With 45 to 60 (three links, a motor in
/// stationary axes, three links by relative angles) they take 0.3 to 1.2 times the time of `dop853`
/// at equal tolerances, and their errors are 20 to 140 times smaller.
const MANY_SUMS: usize = 60;
/// Tolerance up to which Radau's methods cost at most as much as Rosenbrock's, and maintain it
/// where a spring is nearly rigid.
const TIGHT: f64 = 1e-6;
/// Share of the stability limit down to which steps held by stability vary.
const VARIES: f64 = 0.8;
/// Number of states from which on Radau's methods cost less at 1e-5, because they factor less
/// often. At 1e-5 Rosenbrock's take 0.7 to 0.9 of their time with 2 to 20 states (stiff chemistry,
/// circuits), but 1.6, 1.9 and 2.8 times as long on shafts of 26, 76 and 206.
const MANY_STATES: usize = 24;
/// Tolerance above which runs of so many states are short, and Rosenbrock's steps are cheaper.
const LOOSE: f64 = 1e-5;
/// Number of explicit steps at the stability limit above which a machine is nearly rigid. It then
/// takes Radau's methods at loose tolerances, too.
const RIGID: f64 = 1e6;

/// Solves linear machines without steps where that is accurate enough. Otherwise it starts with an
/// explicit method, unless stability alone would require very many steps. It changes to an implicit
/// method where steps are held by stability instead of accuracy, and back where they are not.
pub(super) struct Automatic;

impl Sealed for Automatic {}

impl Integrator for Automatic {
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        let has_guards = stretch.watch.is_some() || stretch.system.constraints().is_some();
        let steps = has_guards || !stretch.auto.exact || stretch.system.tangents().is_some();
        let from = if steps {
            // Steps cost less than closed forms from switch to switch, and carry sensitivities at
            // less cost.
            stretch.from
        } else {
            let Some(from) = without_steps(stretch, state, samples) else { return Ok(()) };
            from
        };
        let stretch = &Stretch { from, ..*stretch };
        let choice = Choice::new(stretch, state);
        match choice.explicit {
            Explicit::Taylor(series) => choice.by_series(series, stretch, state, samples),
            Explicit::Pair(pair) => choice.by_pair(pair, stretch, state, samples),
        }
    }
}

/// Solves a linear machine in closed form as far as that is accurate enough, or more accurate than
/// steps would be. Returns the time from which on it is not, if there is one.
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
            "in closed form, although rounding exceeds the relative tolerance of {:e}: the machine \
             rings so long that errors of steps would add up to more",
            stretch.rtol
        ));
    }
    stopped.err().map(|stopped| stopped.time)
}

/// The methods for a machine and a tolerance. A further method of any kind is another case here.
struct Choice<'a> {
    explicit: Explicit<'a>,
    /// Series with many sums, which may prove better than the pair.
    rival: Option<&'a dyn TaylorSeries<f64>>,
    explicit_name: &'static str,
    /// Value of |h lambda| above which stability holds the explicit method's steps.
    limit: f64,
    implicit_name: &'static str,
    by_radau: bool,
    /// True if an implicit method begins.
    is_stiff_from_the_start: bool,
}

#[derive(Clone, Copy)]
enum Explicit<'a> {
    Taylor(&'a dyn TaylorSeries<f64>),
    Pair(Named),
}

/// A pair and its name.
type Named = (&'static str, &'static Pair);

const OF_ORDER_8: Named = ("dop853", &DOP853);
const OF_ORDER_5: Named = ("tsit5", &TSIT5);

impl<'a> Choice<'a> {
    fn new(stretch: &Stretch<'a>, state: &[f64]) -> Self {
        let rtol = stretch.rtol;
        let has_tangents = stretch.system.tangents().is_some();
        // Of the implicit methods only Radau's carry sensitivities.
        let has_many = stretch.system.states() >= MANY_STATES;
        let by_radau = has_tangents
            || stretch.auto.implicit.map_or_else(
                || rtol <= TIGHT || has_many && rtol <= LOOSE,
                |method| method == ImplicitMethod::Radau,
            );
        let implicit_name = if by_radau { "radau" } else { "rodas5p" };
        let of_pair = |named: Named| Self {
            explicit: Explicit::Pair(named),
            rival: None,
            explicit_name: named.0,
            limit: pair_limit(named.1),
            implicit_name,
            by_radau,
            is_stiff_from_the_start: false,
        };
        let is_of_order_5 = stretch.auto.explicit == Some(ExplicitMethod::Tsit5);
        let pair = of_pair(if is_of_order_5 { OF_ORDER_5 } else { OF_ORDER_8 });
        let found = if has_tangents || stretch.system.is_sliding() {
            Series::None
        } else {
            Series::of(stretch.system.simulator(), rtol).chosen(stretch.auto.explicit)
        };
        let why = found.objection();
        let mut chosen = match found {
            Series::None | Series::MissesCorners(_) => pair,
            Series::HasManySums(series) => Self { rival: Some(series), ..pair },
            Series::Suits(series) => {
                Self { explicit: Explicit::Taylor(series), ..pair }.of_series(rtol)
            }
        };
        let (simulator, span) = (stretch.system.simulator(), stretch.until - stretch.from);
        let held = is_worth_beginning(simulator, span / chosen.limit, |values| {
            stretch.jacobian(stretch.from, &state[..stretch.system.states()], values);
        });
        chosen.is_stiff_from_the_start = held.is_some();
        if stretch.auto.implicit.is_none()
            && rtol > LOOSE
            && held.is_some_and(|steps| steps > RIGID)
        {
            (chosen.by_radau, chosen.implicit_name) = (true, "radau");
        }
        let first = if held.is_some() { chosen.implicit_name } else { chosen.explicit_name };
        let why = held.map_or_else(
            || why.to_owned(),
            |steps| {
                format!("; stability would require {steps:.0} steps of {}", chosen.explicit_name)
            },
        );
        stretch
            .system
            .note(format!("starts with {first}, for a relative tolerance of {rtol:e}{why}"));
        chosen
    }

    /// Returns the choice with the name and the stability limit of Taylor's method.
    fn of_series(self, rtol: f64) -> Self {
        let limit = taylor_limit(TaylorSteps::order_for(rtol));
        Self { explicit_name: "taylor", limit, rival: None, ..self }
    }

    fn by_series(
        &self,
        series: &dyn TaylorSeries<f64>,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        let mut strain = Strain::new(stretch.system.simulator(), self.limit, LOOKS_EVERY);
        let look = |method: &TaylorSteps<'_>, step: f64| strain.look(stretch, method.start(), step);
        let mut method = TaylorSteps::new(stretch, series);
        if !self.is_stiff_from_the_start {
            method.begin(stretch.from, state);
            if method.has_no_series() {
                stretch.system.note(
                    "dop853 instead of taylor: the solution has no power series at the start, such \
                     as at a root of zero"
                        .to_owned(),
                );
                return self.by_pair(OF_ORDER_8, stretch, state, samples);
            }
        }
        let gives_way = |_: &TaylorSteps<'_>| false;
        let left = self.alternate(&mut method, stretch, (state, samples), (look, gives_way))?;
        let Some(ResumePoint { time: from, .. }) = left else { return Ok(()) };
        stretch.system.note(format!(
            "dop853 instead of taylor from t = {from:.6} s on: the solution has no power series \
             there, or one with terms that are not finite"
        ));
        let choice = Self { is_stiff_from_the_start: false, ..*self };
        choice.by_pair(OF_ORDER_8, &Stretch { from, ..*stretch }, state, samples)
    }

    fn by_pair(
        &self,
        (name, pair): Named,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        let choice = Self { explicit_name: name, limit: pair_limit(pair), ..*self };
        let mut strain = Strain::new(stretch.system.simulator(), choice.limit, LOOKS_OF_PAIR_EVERY);
        // The stages show no fast motion beside a much larger one, nor one at rest.
        let look = |method: &ExplicitSteps<'_>, step: f64| {
            let shown = method.stiffness();
            let looked_at = strain.look(stretch, method.start(), step);
            Some(looked_at.map_or(shown, |strain| shown.max(strain)))
        };
        let mut method = ExplicitSteps::new(pair, stretch);
        if !choice.is_stiff_from_the_start {
            method.begin(stretch.from, state);
        }
        let mut rival = self.rival.map(|series| Rival::new(stretch, series));
        let mut gain = 0.0;
        let gives_way = |method: &ExplicitSteps<'_>| {
            let gains = rival.as_mut().and_then(|rival| rival.gains(method.start()));
            gains.inspect(|gains| gain = *gains).is_some()
        };
        // Pairs continue anywhere, and give way to series alone.
        let left = choice.alternate(&mut method, stretch, (state, samples), (look, gives_way))?;
        let (Some(ResumePoint { time: from, .. }), Some(series)) = (left, self.rival) else {
            return Ok(());
        };
        stretch.system.note(format!(
            "taylor instead of dop853 from t = {from:.6} s on: a step replaces {gain:.1}"
        ));
        let choice = Self { is_stiff_from_the_start: false, ..choice }.of_series(stretch.rtol);
        choice.by_series(series, &Stretch { from, ..*stretch }, state, samples)
    }

    /// Alternates between an explicit method while the machine is not stiff and an implicit one
    /// while it is. `look` returns |h lambda| after a step of the explicit method, or `None` if it
    /// has not been evaluated. Returns the point at which the explicit method cannot continue, or
    /// gives way to another.
    fn alternate<M: OneStep>(
        &self,
        explicit: &mut M,
        stretch: &Stretch<'_>,
        (state, samples): (&mut [f64], &mut Samples<'_>),
        (mut look, mut gives_way): (impl FnMut(&M, f64) -> Option<f64>, impl FnMut(&M) -> bool),
    ) -> Result<Option<ResumePoint>, Stopped> {
        let mut changes = 0;
        let mut patience = STIFF_STEPS;
        // When the implicit method is tried once more, and whether this is why it is tried.
        let (mut retry, mut is_doubted) = (None::<Retry>, false);
        let mut left = ResumePoint { time: stretch.from, step: 0.0 };
        let mut is_explicit = !self.is_stiff_from_the_start;
        if is_explicit {
            left.step = explicit.first_step();
        }
        loop {
            if is_explicit {
                let mut evidence = Evidence::of(patience);
                let (mut seen, mut is_cut_short) = (0.0, false);
                let is_stiff = |method: &M, step| {
                    let looked_at = look(method, step);
                    seen = looked_at.unwrap_or(seen);
                    let is_stiff =
                        looked_at.is_some_and(|strain| evidence.grows(strain > self.limit));
                    let is_due = retry.as_mut().is_some_and(|retry| retry.grows(seen / self.limit));
                    is_doubted = is_due && !is_stiff;
                    is_cut_short = method.is_cut_short() || !is_stiff && gives_way(method);
                    is_stiff || is_due || is_cut_short
                };
                let Some(at) = drive(explicit, stretch, left, state, samples, is_stiff)? else {
                    return Ok(None);
                };
                left = at;
                if is_cut_short {
                    return Ok(Some(left));
                }
                let why = if is_doubted {
                    "steps stayed near the stability limit"
                } else {
                    "steps were limited by stability"
                };
                stretch.system.note(format!(
                    "{} instead of {} from t = {:.6} s on: {why}, |h lambda| = {seen:.1}",
                    self.implicit_name, self.explicit_name, left.time,
                ));
            }
            // Doubts become rare by themselves.
            changes += if is_doubted { 0 } else { 2 };
            let may_return = changes < MOST_CHANGES;
            let mut steps = 0;
            let at = self.implicit_stretch(stretch, left, (state, samples), &mut |easy| {
                steps += 1;
                may_return && easy
            })?;
            let Some(at) = at else { return Ok(None) };
            stretch.system.note(format!(
                "{} instead of {} from t = {:.6} s on: no longer stiff",
                self.explicit_name, self.implicit_name, at.time
            ));
            // After a change in vain, the next one is less likely.
            if is_explicit && steps < 2 * STIFF_STEPS {
                patience *= 2;
            }
            let states = stretch.system.states();
            let step = (at.time - left.time) / steps as f64;
            let was_right = step > worth(states) * left.step;
            retry.get_or_insert_with(|| Retry::new(states)).begin(is_doubted && !was_right);
            is_explicit = true;
            explicit.begin(at.time, state);
            left = ResumePoint { step: explicit.own_step().unwrap_or(at.step), ..at };
            if explicit.is_cut_short() {
                return Ok(Some(left));
            }
        }
    }

    /// Integrates implicitly until `leave` says so; it is asked after each step whether few enough
    /// explicit steps would do. A step of zero length is to be chosen.
    fn implicit_stretch(
        &self,
        stretch: &Stretch<'_>,
        from: ResumePoint,
        (state, samples): (&mut [f64], &mut Samples<'_>),
        leave: &mut dyn FnMut(bool) -> bool,
    ) -> Result<Option<ResumePoint>, Stopped> {
        let simulator = stretch.system.simulator();
        let mut radius = SpectralRadius::new(simulator);
        let mut evidence = Evidence::of(STIFF_STEPS);
        let worth = worth(stretch.system.states());
        let mut passed = 0.0;
        let mut is_over = |jacobian: &[f64], step: f64| {
            let explicit_step = self.limit / radius.renew(jacobian, 1.0);
            passed += step;
            let is_over = passed > TRANSIENT * explicit_step;
            leave(is_over && evidence.grows(step < worth * explicit_step))
        };
        if self.by_radau {
            let (mut method, from) = begun(RadauSteps::new(stretch), from, state);
            let is_over = |method: &RadauSteps<'_>, step| is_over(method.jacobian(), step);
            drive(&mut method, stretch, from, state, samples, is_over)
        } else {
            let (mut method, from) = begun(RosenbrockSteps::new(&RODAS5P, stretch), from, state);
            let is_over = |method: &RosenbrockSteps<'_>, step| is_over(method.jacobian(), step);
            drive(&mut method, stretch, from, state, samples, is_over)
        }
    }
}

/// Returns a method that has begun, and its first step: the given one, unless it has zero length.
fn begun<M: OneStep>(mut method: M, from: ResumePoint, state: &[f64]) -> (M, ResumePoint) {
    method.begin(from.time, state);
    let step = if from.step > 0.0 { from.step } else { method.first_step() };
    (method, ResumePoint { step, ..from })
}

/// Series of a machine, and whether a run by them is likely to be right and fastest.
enum Series<'a> {
    None,
    /// Long steps may miss branches and tables.
    MissesCorners(&'a dyn TaylorSeries<f64>),
    HasManySums(&'a dyn TaylorSeries<f64>),
    Suits(&'a dyn TaylorSeries<f64>),
}

impl<'a> Series<'a> {
    fn of(simulator: &'a dyn Simulator<f64>, rtol: f64) -> Self {
        let Some(series) = simulator.taylor() else { return Self::None };
        let order = TaylorSteps::order_for(rtol);
        if series.has_corners() {
            Self::MissesCorners(series)
        } else if series.series_workspace(order) > 2 * MANY_SUMS * order {
            // For every sum, two factors are kept from order to order.
            Self::HasManySums(series)
        } else {
            Self::Suits(series)
        }
    }

    /// Returns the series as a run has chosen its explicit method.
    fn chosen(self, wanted: Option<ExplicitMethod>) -> Self {
        match (wanted, self) {
            (None, found) => found,
            (
                Some(ExplicitMethod::Taylor),
                Self::MissesCorners(series) | Self::HasManySums(series) | Self::Suits(series),
            ) => Self::Suits(series),
            _ => Self::None,
        }
    }

    /// Returns why a run does not begin with the series, as the end of a note.
    fn objection(&self) -> &'static str {
        match self {
            Self::None | Self::Suits(_) => "",
            Self::MissesCorners(_) => {
                "; not with taylor, whose long steps may miss branches and tables"
            }
            Self::HasManySums(_) => "; not with taylor, whose series have many sums",
        }
    }
}

/// Returns |h lambda| up to which a pair is stable, minus a margin.
fn pair_limit(pair: &Pair) -> f64 {
    VARIES * pair.stability
}

/// Returns |h lambda| up to which Taylor's method of an order is stable, minus a fifth, because
/// steps held by stability vary around it.
///
/// |1 + z + ... + z^p/p!| <= 1 on the negative real axis down to about -(0.368 p + 1.4), and in
/// other directions to the left about as far. The region is that of |z e^(1 - z/p)| <= p, enlarged
/// by a part that becomes small (G. Szegoe, 1924; R. Jeltsch, O. Nevanlinna, Numerische Mathematik
/// 37, 1981). Steps held by accuracy end at less than half of it, because terms decay to the
/// tolerance.
fn taylor_limit(order: usize) -> f64 {
    VARIES * (order as f64 / std::f64::consts::E + 1.4)
}
