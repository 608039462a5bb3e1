//! Integration methods, and the one function that runs any of them.
//!
//! To add a method, write one file in `src/method/` with a type that is an [`Integrator`], and add
//! one row to the table in `method_table.rs` and one to `Method::integrator`.

#[cfg(feature = "implicit")]
pub(crate) mod auto;
#[cfg(feature = "implicit")]
mod bordered;
mod choices;
#[cfg(feature = "implicit")]
#[cfg(feature = "diffsol")]
mod diffsol;
#[cfg(feature = "implicit")]
mod exact;
mod explicit;
#[cfg(feature = "implicit")]
pub mod fixed;
mod inertia;
mod jump;
mod lanes;
#[cfg(feature = "implicit")]
mod lu;
mod milestone;
mod one_step;
#[cfg(feature = "implicit")]
mod onset;
pub(crate) mod patience;
#[cfg(feature = "implicit")]
pub mod published;
#[cfg(feature = "implicit")]
mod quadrature;
#[cfg(feature = "implicit")]
mod radau;
pub(crate) mod reverse;
#[cfg(feature = "implicit")]
mod rosenbrock;
mod saturating;
pub(crate) mod sensitivity;
pub(crate) mod sliding;
#[cfg(feature = "implicit")]
mod sparse;
#[cfg(feature = "implicit")]
mod step_matrix;
mod stretch;
mod suitable;
mod system;
mod tableau;
pub(crate) mod taylor;
pub(crate) mod tolerance;
mod vectors;
mod watch;

use crate::error::{NotCompiledIn, StopCause};
pub(crate) use crate::held::Held;
use crate::method::sensitivity::Passing;
pub use crate::method_table::Method;
use crate::trajectory::Switch;
pub use crate::trajectory::Work;
pub use choices::{Auto, BadChoice, ExplicitMethod, ImplicitMethod};
use inertia::Moment;
pub(crate) use jump::just_behind;
pub(crate) use one_step::{OneStep, Trial};
pub use stretch::{Samples, Stretch};
pub(crate) use stretch::{cut, within};
pub use system::System;
pub use tolerance::StepTolerance;
pub use watch::Watch;
pub(crate) use watch::{EventRecord, Front, Memory};

/// An integration method: carries a state over one smooth stretch of a run.
///
/// Sealed: the methods are those of the table, and the arguments of a method may grow.
pub trait Integrator: sealed::Sealed {
    /// Carries `state` from `stretch.from` to `stretch.until`, and pushes the state at every time
    /// that `samples` requests on the way.
    ///
    /// # Errors
    /// [`Stopped`] if the method cannot continue; `state` is then unspecified.
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped>;
}

mod sealed {
    /// Implemented by the methods of the table only.
    pub trait Sealed {}
}
use sealed::Sealed;

/// Time and cause of an integration that could not continue.
#[derive(Debug, Clone, PartialEq)]
pub struct Stopped {
    /// Time reached \[s\].
    pub time: f64,
    /// Cause.
    pub cause: StopCause,
}

/// A problem to integrate, checked beforehand: all values are finite, `from < until`, times are
/// within the run and sorted, lengths are right, and tolerances are positive.
pub struct Problem<'a> {
    /// The equations.
    pub system: &'a System<'a>,
    /// Start time \[s\].
    pub from: f64,
    /// End time \[s\].
    pub until: f64,
    /// Times at which the state is requested, sorted \[s\].
    pub times: &'a [f64],
    /// State at the start.
    pub initial: Vec<f64>,
    /// Times at which the right-hand side jumps, in any order \[s\].
    pub jumps: Vec<f64>,
    /// Tolerances of its steps.
    pub tolerance: StepTolerance,
    /// Choices of `auto`.
    pub auto: Auto,
    /// Maximum number of steps.
    pub max_steps: usize,
}

impl Problem<'_> {
    /// Returns the states at the requested times, one row after another.
    ///
    /// The run is divided at jumps, and the method restarts at each. No step crosses a jump, so a
    /// jump costs no order of accuracy. The same holds at events.
    ///
    /// # Errors
    /// [`Stopped`] if the method cannot continue; at the start if it is not made for such a machine
    /// or not compiled in.
    pub fn integrate(&self, method: Method) -> Result<Run, Stopped> {
        let (run, stopped) = self.integrate_kept(method);
        stopped.map_or(Ok(run), Err)
    }

    /// Does the same as [`Problem::integrate`]. If the method cannot continue, it also returns the
    /// rows until then.
    #[must_use]
    pub(crate) fn integrate_kept(&self, method: Method) -> (Run, Option<Stopped>) {
        let mut watch = None;
        let mut samples = Samples::new(self.times, self.initial.len());
        let stopped = self.carry(method, &mut watch, &mut samples).err();
        let switches = watch.map_or_else(Vec::new, Watch::into_switches);
        let taken = samples.taken();
        (Run { rows: samples.into_rows(), switches, taken }, stopped)
    }

    /// Corrects the modes of a start, and nothing else.
    ///
    /// # Errors
    /// [`StopCause::Contradiction`] if they contradict each other, or if anything other than modes
    /// would have to change.
    #[cfg(feature = "linear")]
    pub(crate) fn settle(&self, state: &mut [f64]) -> Result<(), Stopped> {
        Watch::new(self, state).map(|_| ())
    }

    fn carry<'a>(
        &'a self,
        method: Method,
        watch: &mut Option<Watch<'a>>,
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        let integrator = self.integrator(method)?;
        let mut state = self.initial.clone();
        // A relation that nobody watches stays live.
        if method.watches_events() {
            *watch = Watch::new(self, &mut state)?;
        }
        let watch = watch.as_ref();
        let tangents = self.system.tangents();
        if let Some(watch) = watch {
            // Corrected modes may hold what was free.
            self.system.constrain(self.from, &mut state)?;
            if let Some(tangents) = tangents {
                let record = watch.record();
                tangents.settle(self.system, self.from, &self.initial, &record, &state)?;
            }
        }
        tangents.inspect(|tangents| tangents.sample_start(samples, self.from));
        while samples.next_until(self.from).is_some() {
            samples.push(&state);
        }
        self.go_on((method, integrator), watch, &mut state, samples, false).map(|_| ())
    }

    /// Carries a watched state from start to end. If it is to halt at events, returns the time of
    /// the first event, which has then been found and not yet applied.
    ///
    /// # Errors
    /// As [`Problem::integrate`].
    pub(crate) fn carry_on(
        &self,
        method: Method,
        watch: Option<&Watch<'_>>,
        state: &mut [f64],
        halts: bool,
    ) -> Result<Option<f64>, Stopped> {
        let mut samples = Samples::new(&[], state.len());
        watch.filter(|_| halts).inspect(|watch| watch.halt_at_counters());
        self.go_on((method, self.integrator(method)?), watch, state, &mut samples, halts)
    }

    /// Applies events that a host has found, or that were found at the end of the piece before.
    pub(crate) fn apply(&self, watch: &Watch<'_>, state: &mut [f64]) -> Result<(), Stopped> {
        let stretch = Stretch::new(self, (self.from, self.until), Some(watch));
        self.switch(&stretch, watch, state).map(|_| ())
    }

    /// Returns the method, if it is made for such a machine and compiled in.
    fn integrator(&self, method: Method) -> Result<&'static (dyn Integrator + Sync), Stopped> {
        method.check(self.system.simulator()).map_err(|unsuitable| Stopped {
            time: self.from,
            cause: StopCause::Unsuitable(Box::new(unsuitable)),
        })?;
        method.integrator().ok_or_else(|| {
            let cause = StopCause::NotCompiledIn(NotCompiledIn::of(method));
            Stopped { time: self.from, cause }
        })
    }

    /// Does the same as [`Problem::carry_on`], with samples on the way.
    fn go_on(
        &self,
        (method, integrator): (Method, &dyn Integrator),
        watch: Option<&Watch<'_>>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
        halts: bool,
    ) -> Result<Option<f64>, Stopped> {
        for ends in cut(self.from, self.until, self.jumps.clone()).windows(2) {
            let mut from = ends[0];
            self.jump((from, ends[1]), watch, state)?;
            while from < ends[1] {
                let stretch = Stretch::new(self, (from, ends[1]), watch);
                let _span = tracing::debug_span!("segment", from, until = stretch.until).entered();
                from = stretch.until;
                stretch.require_uninterrupted(stretch.from)?;
                stretch.require_finite_rate(state)?;
                self.system.keep_energy_of(stretch.within(stretch.from), state);
                if stretch.is_trivial() {
                    stretch.euler_step(state, samples);
                    continue;
                }
                let Some(watch) = stretch.watch else {
                    integrator.integrate(&stretch, state, samples)?;
                    continue;
                };
                watch.start_stretch(&stretch, state);
                // Along a surface no series exists, and dy'/dy, with which implicit methods carry
                // sensitivities, has more entries than its pattern.
                let is_special = method == Method::Taylor || self.system.tangents().is_some();
                let is_changed = is_special && self.system.is_sliding();
                let integrator = if is_changed { &explicit::Dop853 } else { integrator };
                if let Some(tangents) = self.system.tangents() {
                    tangents.begin_stretch(self.system, stretch.within(stretch.from), state)?;
                }
                if !watch.turns(&stretch, stretch.from, state) {
                    integrator.integrate(&stretch, state, samples)?;
                }
                if halts && let Some(time) = watch.has_halted() {
                    return Ok(Some(time));
                }
                from = self.switch(&stretch, watch, state)?.unwrap_or(from);
            }
        }
        Ok(None)
    }

    /// Applies jumps in time at the start of a stretch: velocities that constraints prescribe, and
    /// sensitivities.
    fn jump(
        &self,
        (from, until): (f64, f64),
        watch: Option<&Watch<'_>>,
        state: &mut [f64],
    ) -> Result<(), Stopped> {
        let before = state.to_vec();
        let (front, behind) = (from.next_down(), just_behind(from, until));
        if from > self.from {
            self.system.keep_momentum((from - (behind - from), behind), state)?;
        }
        let has_moved = self.system.take_up((front, behind), &self.tolerance, state)?;
        let tangents = self.system.tangents().filter(|_| from > self.from || has_moved);
        // Before relations settle on their sides behind the jump.
        let rate_before = tangents.map(|_| {
            let mut rate = vec![0.0; self.system.len()];
            self.system.rate(front, &before, &mut rate);
            rate
        });
        if let Some(watch) = watch {
            if from > self.from {
                let surfaces = watch.surfaces(front, &before);
                watch.leave_surfaces(surfaces, (behind, state), behind - front);
            } else {
                watch.leave_distant_surfaces(behind, state);
            }
            watch.jump_in_time(&Stretch::new(self, (from, until), Some(watch)), state)?;
        }
        let Some((tangents, rate)) = tangents.zip(rate_before) else { return Ok(()) };
        tangents.jump(self.system, (from, &before, &rate), (behind, state), has_moved)
    }

    /// Applies the events for which the method stopped, and returns the time. Energy lost there
    /// counts as dissipated.
    fn switch(
        &self,
        stretch: &Stretch<'_>,
        watch: &Watch<'_>,
        state: &mut [f64],
    ) -> Result<Option<f64>, Stopped> {
        let front = self.system.moment(stretch.until, state);
        let Some(time) = watch.switch(state)? else { return Ok(None) };
        let front = Moment { time, ..front };
        let is_of_time = watch.changes_with_time(time, &front.state);
        let impulses = self.system.pass_inertia(watch, &front, state)?;
        self.system.account(&front, impulses.supplied, state);
        let has_moved = watch.has_changed_relations()
            && self.system.go_along(time, is_of_time, &self.tolerance, state)?;
        let switched = self.system.moment(time, state);
        self.system.constrain(time, state)?;
        if let Some(tangents) = self.system.tangents() {
            let passing = Passing { time: stretch.within(time), before: &front.state };
            let record = watch.record();
            if record.applied.is_empty() {
                tangents.cross(stretch, watch, &passing, (state, has_moved))?;
            } else {
                tangents.switch(stretch, watch, &passing, &record, state)?;
            }
        }
        self.system.account(&switched, 0.0, state);
        Ok(Some(time))
    }
}

/// Result of a method for a problem.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// States at the requested times, one row after another.
    pub rows: Vec<f64>,
    /// Events that happened, in order.
    pub switches: Vec<Switch>,
    /// Number of requested times reached: all, unless the method stopped.
    pub taken: usize,
}

impl Method {
    /// Returns the code that the method runs; `None` if the Cargo feature of its family is not
    /// enabled.
    #[cfg_attr(
        all(feature = "diffsol", feature = "implicit"),
        expect(clippy::unnecessary_wraps, reason = "some features may be off")
    )]
    fn integrator(self) -> Option<&'static (dyn Integrator + Sync)> {
        match self {
            #[cfg(feature = "diffsol")]
            Self::Bdf => Some(&diffsol::Bdf),
            #[cfg(feature = "diffsol")]
            Self::TrBdf2 => Some(&diffsol::TrBdf2),
            #[cfg(feature = "diffsol")]
            Self::Esdirk34 => Some(&diffsol::Esdirk34),
            #[cfg(feature = "diffsol")]
            Self::Tsit45 => Some(&diffsol::Tsit45),
            Self::Tsit5 => Some(&explicit::Tsit5),
            Self::Dop853 => Some(&explicit::Dop853),
            #[cfg(feature = "implicit")]
            Self::Rodas5p => Some(&rosenbrock::Rodas5p),
            #[cfg(feature = "implicit")]
            Self::Radau => Some(&radau::Radau),
            #[cfg(feature = "implicit")]
            Self::Auto => Some(&auto::Automatic),
            Self::Taylor => Some(&taylor::Taylor),
            #[cfg(feature = "implicit")]
            Self::Exact => Some(&exact::Exact),
            #[cfg(not(all(feature = "diffsol", feature = "implicit")))]
            _ => None,
        }
    }

    /// Returns the overseer of the steps of variants in lanes.
    #[cfg(feature = "sweep")]
    #[cfg_attr(
        not(feature = "implicit"),
        expect(unused_variables, reason = "without implicit methods there is no `auto`")
    )]
    pub(crate) fn overseer<'a, R: crate::lanes::Lanes>(
        self,
        machine: &'a dyn machinist_contract::SideBySide<R>,
        rtol: f64,
    ) -> Option<Box<dyn taylor::variants::Overseer<R> + 'a>> {
        match self {
            #[cfg(feature = "implicit")]
            Self::Auto => Some(Box::new(auto::in_lanes::Lookout::new(machine, rtol))),
            _ => None,
        }
    }

    /// Returns whether the Cargo feature of the method's family is enabled.
    #[must_use]
    pub fn is_compiled_in(self) -> bool {
        self.integrator().is_some()
    }

    /// Returns every method that is compiled in, in the order of the table.
    pub fn compiled_in() -> impl Iterator<Item = Self> {
        Self::ALL.iter().copied().filter(|method| method.is_compiled_in())
    }
}

impl NotCompiledIn {
    pub(crate) fn of(method: Method) -> Self {
        let compiled_in: Vec<_> = Method::compiled_in().map(Method::name).collect();
        let feature = method.feature().unwrap_or_default();
        Self { name: method.name(), feature, compiled_in: compiled_in.join(", ") }
    }
}
