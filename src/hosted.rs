//! Runs that a host steps or divides into pieces, for model exchange and co-simulation.
//!
//! A [`Standing`] is the status of such a run, as plain data. A [`Hosted`] machine begins a run and
//! carries it to a later time by a method of this crate. If the host integrates by its own method,
//! the machine evaluates the event indicators and executes events. Events, starts and constraints
//! are treated as in [a run](crate::Simulation).

mod branches;

use std::cell::RefCell;
use std::time::Duration;

use machinist_contract::Simulator;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::constraints::{Constraints, consistent, require_independent};
use crate::error::{SimulateError, StopCause};
use crate::method::patience::Patience;
use crate::method::{
    Auto, Memory, Method, Problem, StepTolerance, Stopped, System, Watch, just_behind, within,
};
use crate::scales::scales;
use crate::simulate::{MAX_STEPS, Simulation, require_admitted, require_guards};
use crate::trajectory::Switch;

pub use branches::{branches, margins};

/// Jumps nearer than this many roundings of a time coincide with it.
const AT_ONCE: f64 = 512.0;

/// Returns the distance from a time within which jumps coincide with it.
fn at_once(time: f64) -> f64 {
    AT_ONCE * f64::EPSILON * time.abs()
}

/// A machine that a host runs, at given parameters.
#[derive(Clone, Copy)]
pub struct Hosted<'a> {
    simulator: &'a dyn Simulator<f64>,
    parameters: &'a [f64],
    auto: Auto,
    max_steps: usize,
    patience: Patience<'a>,
}

/// Status of a hosted run. Together with the parameters it determines all that follows, to the last
/// bit. Serialize it in a format with infinite numbers, which JSON does not have.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Standing {
    /// Time \[s\].
    pub time: f64,
    /// State \[q, q', z\].
    pub state: Vec<f64>,
    /// Start of the run, and the time from which its length is taken \[s\].
    span: (f64, f64),
    /// Jumps of the rate before and after the current time.
    ends: (f64, f64),
    rtol: f64,
    atol: Vec<f64>,
    /// True if the host steps the run.
    is_stepped: bool,
    /// Parameters to which the state has been settled.
    parameters: Vec<f64>,
    memory: Memory,
}

/// Settings for the start of a hosted run.
pub struct Beginning<'b> {
    /// Start time \[s\].
    pub from: f64,
    /// Time from which the length of the run is taken, after the start \[s\].
    pub until: f64,
    /// Relative tolerance, above 0 and at most 1.
    pub rtol: f64,
    /// True if the host steps the run by its own method; otherwise it is [carried](Hosted::carry).
    pub is_stepped: bool,
    /// State at the start; entries that are not given are guesses, and so are all entries if an
    /// equilibrium is searched for.
    pub state: Vec<f64>,
    /// Returns whether a state is given. Constraints do not move such states, and an equilibrium
    /// moves them no further than necessary.
    pub is_given: &'b dyn Fn(usize) -> bool,
    /// True to begin in the equilibrium near the state, as `Simulation::in_equilibrium` does.
    pub in_equilibrium: bool,
}

/// Reason why a hosted run cannot begin or continue.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum HostedError {
    /// The start is invalid.
    #[error(transparent)]
    Refused(#[from] SimulateError),
    /// The run stopped.
    #[error("stopped at t = {time} s: {cause}")]
    Stopped {
        /// Time reached \[s\].
        time: f64,
        /// Reason, with a hint.
        cause: StopCause,
    },
}

impl HostedError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Refused(error) => error.code(),
            Self::Stopped { cause, .. } => cause.code(),
        }
    }
}

impl From<Stopped> for HostedError {
    fn from(Stopped { time, cause }: Stopped) -> Self {
        Self::Stopped { time, cause }
    }
}

/// Result of a piece of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// Reason for its end.
    pub reached: Reached,
    /// Events that happened, in order.
    pub switches: Vec<Switch>,
}

/// Reason why a piece of a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reached {
    /// The requested time is reached.
    End,
    /// Events were found and are still to be executed.
    Event,
    /// The host ended the piece.
    Interrupted,
}

impl Standing {
    /// Returns whether the status belongs to a run of this simulator, with all values in range.
    #[must_use]
    pub fn fits(&self, simulator: &dyn Simulator<f64>) -> bool {
        let states = simulator.shape().states();
        let is_finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
        let Self { time, state, span, atol, rtol, memory, parameters, .. } = self;
        [state.len(), atol.len()] == [states; 2]
            && parameters.len() == simulator.shape().parameters
            && is_finite(state)
            && is_finite(&[*time, span.0, span.1])
            && span.0 < span.1
            && atol.iter().chain([rtol]).all(|value| *value > 0.0 && value.is_finite())
            && memory.fits(simulator)
    }

    /// Returns `time` moved into the segment between jumps that the run is on.
    #[must_use]
    pub fn within(&self, time: f64) -> f64 {
        within(time, self.ends)
    }

    /// Returns the next time at which the rate jumps \[s\].
    #[must_use]
    pub fn next_jump(&self) -> Option<f64> {
        (self.ends.1 < f64::INFINITY).then_some(self.ends.1)
    }

    /// Returns whether the motion slides along a switching surface.
    #[must_use]
    pub fn is_sliding(&self) -> bool {
        self.memory.is_sliding()
    }

    /// Returns the end of the run; past it, that of another run of this length from now on.
    fn end(&self) -> f64 {
        let (from, until) = self.span;
        if self.time < until { until } else { self.time + (until - from) }
    }

    /// Returns the relative tolerance of the run.
    #[must_use]
    pub fn rtol(&self) -> f64 {
        self.rtol
    }

    /// Returns whether an indicator is the guard of an active event; otherwise it is constant.
    #[must_use]
    pub fn is_watched(&self, simulator: &dyn Simulator<f64>, indicator: usize) -> bool {
        self.memory.is_watched(simulator, indicator)
    }

    /// Returns the parameters with relations as the run holds them between events: rates with these
    /// are smooth.
    #[must_use]
    pub fn held_parameters(&self, parameters: &[f64]) -> Vec<f64> {
        self.memory.parameters(parameters)
    }

    /// Returns whether events were found that are still to be executed.
    #[must_use]
    pub fn is_at_event(&self) -> bool {
        self.memory.is_halted()
    }
}

impl<'a> Hosted<'a> {
    /// Creates a machine from a simulator and all of its parameters, which are finite.
    #[must_use]
    pub fn new(simulator: &'a dyn Simulator<f64>, parameters: &'a [f64]) -> Self {
        let (auto, max_steps) = (Auto::default(), MAX_STEPS);
        Self { simulator, parameters, auto, max_steps, patience: Patience::default() }
    }

    /// Sets the choices of `auto`.
    #[must_use]
    pub fn auto(self, auto: Auto) -> Self {
        Self { auto, ..self }
    }

    /// Sets the number of steps after which a piece stops with an error; [`MAX_STEPS`] unless set.
    #[must_use]
    pub fn max_steps(self, max_steps: usize) -> Self {
        Self { max_steps, ..self }
    }

    /// Limits the computing time of each piece, as [`Simulation::time_limit`] does for a run.
    #[must_use]
    pub fn time_limit(self, limit: Duration) -> Self {
        Self { patience: Patience { limit: Some(limit), ..self.patience }, ..self }
    }

    /// Stops a piece with the cause that `why` returns; it is called after every step.
    #[must_use]
    pub fn until_told(self, why: &'a dyn Fn() -> Option<StopCause>) -> Self {
        Self { patience: Patience { asked: Some(why), ..self.patience }, ..self }
    }

    /// Checks parameters that a host has set.
    ///
    /// # Errors
    /// [`SimulateError`] as [`Simulation::run`](crate::Simulation::run).
    pub fn check(&self) -> Result<(), SimulateError> {
        let run = Simulation::new(self.simulator).parameters(self.parameters);
        run.checked_parameters()?;
        run.checked_jumps().map(|_| ())
    }

    /// Returns the number of indicators: one for each event, then one for each switching surface.
    #[must_use]
    pub fn indicators(&self) -> usize {
        self.simulator.events() + self.simulator.kinks()
    }

    /// Begins a run on the constraints, with modes that agree with their guards.
    ///
    /// # Errors
    /// [`HostedError`] where [`Simulation::run`](crate::Simulation::run) would fail before its
    /// first step.
    pub fn begin(&self, beginning: Beginning<'_>) -> Result<Standing, HostedError> {
        let Beginning { from, until, rtol, is_stepped, state, is_given, in_equilibrium } =
            beginning;
        let Self { simulator, parameters, .. } = *self;
        if !(from < until && (until - from).is_finite()) {
            return Err(SimulateError::BadSpan { from, until }.into());
        }
        if !(rtol > 0.0 && rtol <= 1.0) {
            return Err(SimulateError::BadTolerance(rtol).into());
        }
        require_admitted(simulator, parameters)?;
        let state = if in_equilibrium {
            let run = Simulation::new(simulator).parameters(parameters);
            let run = run.from(from).until(until).rtol(rtol);
            let given: Vec<usize> = (0..state.len()).filter(|entry| is_given(*entry)).collect();
            run.balanced(state, &given)?
        } else {
            consistent(simulator, parameters, from, state, &is_given)?
        };
        require_independent(simulator, parameters, from, &state)?;
        let scales = scales(simulator, parameters, from, &state);
        let begun = self.set_out(Standing {
            time: from,
            state,
            span: (from, until),
            ends: (from, from),
            rtol,
            atol: scales.iter().map(|scale| rtol * scale).collect(),
            is_stepped,
            parameters: parameters.to_vec(),
            memory: Memory::default(),
        });
        Ok(begun?.0)
    }

    /// Begins a run at a consistent state. Returns the events at its start.
    fn set_out(&self, mut standing: Standing) -> Result<(Standing, Vec<Switch>), HostedError> {
        let Standing { time: from, span, is_stepped, .. } = standing;
        let until = span.1;
        self.pass_jumps(&mut standing);
        require_guards(self.simulator, self.parameters)?;
        let system = System::new(self.simulator, self.parameters, false);
        let problem = self.problem(&system, &standing, until);
        let mut state = standing.state.clone();
        let Some(watch) = Watch::new(&problem, &mut state)? else {
            return Ok((standing, Vec::new()));
        };
        system.constrain(from, &mut state)?;
        let memory = if is_stepped { Some(watch.set_out(&problem, &mut state)?) } else { None };
        let switches = watch.take_switches();
        standing.memory = memory.unwrap_or_else(|| watch.into_memory());
        standing.state = state;
        Ok((standing, switches))
    }

    /// Computes the indicators: one for each event and each switching surface. The host has to stop
    /// where one changes its sign.
    pub fn indicate(&self, standing: &Standing, values: &mut [f64]) {
        let (time, state) = (standing.within(standing.time), &standing.state[..]);
        standing.memory.indicators((self.simulator, self.parameters), (time, state), values);
    }

    /// Computes y' at the current state of the run, with relations as the run holds them: smooth
    /// between events.
    pub fn rate(&self, standing: &Standing, rate: &mut [f64]) {
        let (time, state) = (standing.within(standing.time), &standing.state[..]);
        if standing.memory.is_sliding() {
            let system = System::new(self.simulator, self.parameters, false);
            standing.memory.hold(&system);
            system.state_rate(time, state, rate);
        } else {
            let parameters = standing.held_parameters(self.parameters);
            self.simulator.rate(time, state, &parameters, rate);
        }
    }

    /// Returns the derivative of an indicator by its guard, which has this value.
    #[must_use]
    pub fn indicator_slope(&self, standing: &Standing, indicator: usize, guard: f64) -> f64 {
        let relation = indicator.checked_sub(self.simulator.events());
        relation.map_or(1.0, |index| standing.memory.slope(self.simulator, index, guard))
    }

    /// Examines the state after a step of the host. Returns whether events have to be executed now,
    /// or the state has to be projected onto the constraints.
    pub fn step_is_complete(&self, standing: &mut Standing) -> bool {
        let system = System::new(self.simulator, self.parameters, false);
        let problem = self.problem(&system, standing, standing.end());
        let mut memory = standing.memory.clone();
        let asks = Watch::resume(&problem, &memory).is_some_and(|watch| {
            watch.look(&mut memory, standing.within(standing.time), &standing.state)
        });
        standing.memory = memory;
        let time = standing.within(standing.time);
        let off = Constraints::of(self.simulator, self.parameters)
            .map_or(0.0, |constraints| constraints.off(time, &standing.state));
        asks || off > standing.rtol
    }

    /// Executes what is due at the current time: a jump of the rate, and events that were found or
    /// whose guards have crossed zero. Then projects the state onto the constraints. Returns the
    /// events.
    ///
    /// # Errors
    /// [`HostedError`] as in any run; `standing` is then unchanged.
    pub fn happen(&self, standing: &mut Standing) -> Result<Vec<Switch>, HostedError> {
        let mut next = standing.clone();
        self.pass_jumps(&mut next);
        let system = System::new(self.simulator, self.parameters, false);
        let time = next.within(next.time);
        let mut state = next.state.clone();
        let is_jump = (time - next.ends.0).abs() <= at_once(time);
        let problem = self.problem(&system, &next, next.end());
        if is_jump || next.parameters != self.parameters {
            let times = (time.next_down(), just_behind(time, next.end()));
            system.take_up(times, &problem.tolerance, &mut state)?;
            next.parameters.copy_from_slice(self.parameters);
        }
        system.constrain(time, &mut state)?;
        let mut memory = next.memory.clone();
        let mut switches = Vec::new();
        if let Some(watch) = Watch::resume(&problem, &memory) {
            switches = if next.is_stepped {
                watch.happen(&problem, &mut memory, (time, is_jump), &mut state)?;
                watch.into_switches()
            } else {
                watch.go_through(&problem, &mut memory, time, &mut state)?
            };
        }
        next.memory = memory;
        next.state = state;
        *standing = next;
        Ok(switches)
    }

    /// Integrates to a later time by a method of this crate, which restarts there. The piece ends
    /// earlier if `leaves`, called with time and state after steps, says so. With `halts` it also
    /// ends at events, which are then found but not executed.
    ///
    /// # Errors
    /// [`HostedError`] if the method cannot continue; `standing` is then unchanged.
    pub fn carry(
        &self,
        standing: &mut Standing,
        until: f64,
        (method, halts): (Method, bool),
        leaves: &dyn Fn(f64, &[f64]) -> bool,
    ) -> Result<Piece, HostedError> {
        let left = RefCell::new(None);
        let onlooker = |time: f64, state: &[f64]| {
            let is_left = leaves(time, state);
            if is_left {
                *left.borrow_mut() = Some((time, state.to_vec()));
            }
            is_left
        };
        let system = System::new(self.simulator, self.parameters, false);
        let (from, end) = standing.span;
        let system = system.within(self.patience).shown_to(Some(&onlooker)).piece_of(end - from);
        let (machine, requested) =
            ((self.simulator, self.parameters), (standing.rtol, standing.atol.clone()));
        let tolerance = StepTolerance::new((method, self.auto), machine, requested);
        let problem = Problem { tolerance, ..self.problem(&system, standing, until) };
        let watch = Watch::resume(&problem, &standing.memory);
        let mut state = standing.state.clone();
        let carried = problem.carry_on(method, watch.as_ref(), &mut state, halts);
        let (time, reached) = match carried {
            Ok(None) => (until, Reached::End),
            Ok(Some(time)) => (time, Reached::Event),
            Err(Stopped { cause: StopCause::Interrupted, time }) => match left.take() {
                None => return Err(Stopped { cause: StopCause::Interrupted, time }.into()),
                Some((time, there)) => {
                    state = there;
                    (time, Reached::Interrupted)
                }
            },
            Err(stopped) => return Err(stopped.into()),
        };
        let mut switches = Vec::new();
        let memory = watch.map(|watch| {
            switches = watch.take_switches();
            watch.into_memory()
        });
        let mut next = Standing { time, state, ..standing.clone() };
        next.memory = memory.unwrap_or_default();
        next.parameters.copy_from_slice(self.parameters);
        self.pass_jumps(&mut next);
        *standing = next;
        Ok(Piece { reached, switches })
    }

    /// Returns the same run at another time and state.
    #[must_use]
    pub fn at(&self, standing: &Standing, time: f64, state: &[f64]) -> Standing {
        let mut there = Standing { time, state: state.to_vec(), ..standing.clone() };
        self.pass_jumps(&mut there);
        there
    }

    /// Selects the segment between jumps that contains the current time.
    fn pass_jumps(&self, standing: &mut Standing) {
        let mut jumps = vec![0.0; self.simulator.shape().discontinuities];
        self.simulator.discontinuities(self.parameters, &mut jumps);
        let time = standing.time;
        let room = at_once(time);
        let is_ahead = |jump: &f64| *jump > time + room;
        let next = jumps.iter().copied().filter(is_ahead).fold(f64::INFINITY, f64::min);
        let is_passed = |jump: &f64| *jump <= time + room;
        let last = jumps.iter().copied().filter(is_passed).fold(f64::NEG_INFINITY, f64::max);
        standing.ends = (last, next);
    }

    fn problem<'p>(&self, system: &'p System<'p>, standing: &Standing, until: f64) -> Problem<'p> {
        let mut jumps = vec![0.0; self.simulator.shape().discontinuities];
        self.simulator.discontinuities(self.parameters, &mut jumps);
        Problem {
            system,
            from: standing.time,
            until,
            times: &[],
            initial: standing.state.clone(),
            jumps,
            tolerance: StepTolerance::requested(standing.rtol, standing.atol.clone()),
            auto: self.auto,
            max_steps: self.max_steps,
        }
    }
}

impl Simulation<'_> {
    /// Begins a run with these settings that a host [carries](Hosted::carry) in pieces. Method and
    /// limits are given for each piece. Also returns the events at the start.
    ///
    /// # Errors
    /// [`HostedError`] where [`Simulation::run`] would fail before its first step.
    pub fn begin(&self) -> Result<(Standing, Vec<Switch>), HostedError> {
        let span = (self.start_time(), self.end_time());
        self.checked_times()?;
        let parameters = self.checked_parameters()?;
        self.chosen_method()?.check(self.simulator()).map_err(SimulateError::from)?;
        let state = self.checked_initial_state()?;
        let atol = self.checked_atol(&state)?;
        Hosted::new(self.simulator(), parameters).set_out(Standing {
            time: span.0,
            state,
            span,
            ends: (span.0, span.0),
            rtol: self.relative_tolerance(),
            atol,
            is_stepped: false,
            parameters: parameters.to_vec(),
            memory: Memory::default(),
        })
    }
}
