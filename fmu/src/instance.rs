//! An instance of an FMU: what it is at, what may be asked of it then, and its numbers.
//!
//! What fails changes nothing: after an error an instance is as it was before the call. Whoever
//! asks for something at a time at which the standard does not allow it is refused.

mod derivatives;
mod snapshot;
mod stepping;
mod values;

use std::collections::BTreeMap;
use std::sync::Arc;

use machinist::hosted::{Beginning, Hosted, HostedError, Standing};
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::resource::Machine;
use crate::variables::Initial;

pub use snapshot::Snapshot;
pub use stepping::{Intermediate, Looks, Reply, Step, Stepped, Update};
pub use values::Type;

/// What an instance is driven by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interface {
    /// A method of the host's.
    ModelExchange,
    /// Ours, between the host's communication points.
    CoSimulation {
        /// Whether the host handles events.
        event_mode: bool,
        /// Whether it copes with steps that end early.
        early_return: bool,
    },
}

/// What an instance is at, in the standard's words.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Phase {
    /// Instantiated.
    Instantiated,
    /// Initialization mode.
    Initialization,
    /// Event mode.
    Event,
    /// Continuous-time mode.
    ContinuousTime,
    /// Step mode.
    Step,
    /// Within a step, while the host looks on.
    Intermediate,
    /// Terminated.
    Terminated,
}

/// Why an instance refuses something.
#[derive(Debug, Error)]
pub enum Refusal {
    /// It is not allowed now.
    #[error("{call} is not allowed in {phase:?} mode")]
    OutOfOrder {
        /// What was called.
        call: &'static str,
        /// What the instance is at.
        phase: Phase,
    },
    /// It is of the other interface.
    #[error("{0} is not of the interface that was instantiated")]
    OtherInterface(&'static str),
    /// An argument makes no sense.
    #[error("{0}")]
    Argument(String),
    /// The run does not begin or does not go on.
    #[error(transparent)]
    Run(#[from] HostedError),
    /// A number that is none: a shorter step may do.
    #[error("{0} is not a finite number")]
    NotFinite(String),
}

impl Refusal {
    /// An argument that makes no sense.
    pub(crate) fn argument(message: impl Into<String>) -> Self {
        Self::Argument(message.into())
    }

    /// Whether the host may try a shorter step.
    #[must_use]
    pub fn is_discard(&self) -> bool {
        matches!(self, Self::NotFinite(_))
    }
}

/// The host's experiment.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct Experiment {
    from: f64,
    until: f64,
    rtol: f64,
}

/// All of an instance that changes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Now {
    phase: Phase,
    parameters: Vec<f64>,
    /// Entries of the state that the host has begin otherwise.
    chosen: Vec<Option<f64>>,
    experiment: Experiment,
    /// Nothing before the start is computed.
    standing: Option<Standing>,
}

/// An instance.
#[derive(Debug)]
pub struct Instance {
    machine: Arc<Machine>,
    interface: Interface,
    now: Now,
    /// States that were kept for the host, by their handles.
    kept: BTreeMap<usize, Snapshot>,
    handles: usize,
}

impl Instance {
    /// A machine, instantiated.
    #[must_use]
    pub fn new(machine: Arc<Machine>, interface: Interface) -> Self {
        let now = Now::of(&machine);
        Self { machine, interface, now, kept: BTreeMap::new(), handles: 0 }
    }

    /// What it is at.
    #[must_use]
    pub fn phase(&self) -> Phase {
        self.now.phase
    }

    /// The machine it is of.
    #[must_use]
    pub fn machine(&self) -> &Arc<Machine> {
        &self.machine
    }

    /// Time reached \[s\]; that of the start before it.
    #[must_use]
    pub fn time(&self) -> f64 {
        let Now { standing, experiment, .. } = &self.now;
        standing.as_ref().map_or(experiment.from, |standing| standing.time)
    }

    /// As instantiated.
    ///
    /// # Errors
    /// [`Refusal`] within a step.
    pub fn reset(&mut self) -> Result<(), Refusal> {
        if self.now.phase == Phase::Intermediate {
            return Err(Refusal::OutOfOrder { call: "fmi3Reset", phase: self.now.phase });
        }
        self.now = Now::of(&self.machine);
        Ok(())
    }

    /// Enters initialization mode.
    ///
    /// # Errors
    /// [`Refusal`] if it was not just instantiated, or if times or the tolerance make no sense.
    pub fn enter_initialization(
        &mut self,
        tolerance: Option<f64>,
        from: f64,
        until: Option<f64>,
    ) -> Result<(), Refusal> {
        self.require("fmi3EnterInitializationMode", &[Phase::Instantiated])?;
        let run = &self.machine.model().run;
        let until = until.unwrap_or(from + (run.until - run.from));
        if !(from < until && (until - from).is_finite()) {
            let message = format!("an experiment from {from} s until {until} s");
            return Err(Refusal::argument(message));
        }
        let rtol = tolerance.unwrap_or(run.rtol);
        if !(rtol > 0.0 && rtol <= 1.0) {
            return Err(Refusal::argument(format!("a relative tolerance of {rtol}")));
        }
        self.now.experiment = Experiment { from, until, rtol };
        self.now.standing = None;
        self.now.phase = Phase::Initialization;
        Ok(())
    }

    /// Leaves it, for event mode or for the first step.
    ///
    /// # Errors
    /// [`Refusal`] if it is not in it, or if the machine cannot start there.
    pub fn exit_initialization(&mut self) -> Result<(), Refusal> {
        self.require("fmi3ExitInitializationMode", &[Phase::Initialization])?;
        self.start()?;
        self.now.phase = match self.interface {
            Interface::ModelExchange | Interface::CoSimulation { event_mode: true, .. } => {
                Phase::Event
            }
            Interface::CoSimulation { event_mode: false, .. } => Phase::Step,
        };
        Ok(())
    }

    /// Ends the run.
    ///
    /// # Errors
    /// [`Refusal`] before the start.
    pub fn terminate(&mut self) -> Result<(), Refusal> {
        let phases = [Phase::Event, Phase::ContinuousTime, Phase::Step];
        self.require("fmi3Terminate", &phases)?;
        self.now.phase = Phase::Terminated;
        Ok(())
    }

    fn require(&self, call: &'static str, phases: &[Phase]) -> Result<(), Refusal> {
        let phase = self.now.phase;
        if phases.contains(&phase) { Ok(()) } else { Err(Refusal::OutOfOrder { call, phase }) }
    }

    fn is_exchange(&self) -> bool {
        self.interface == Interface::ModelExchange
    }

    fn require_exchange(&self, call: &'static str) -> Result<(), Refusal> {
        if self.is_exchange() { Ok(()) } else { Err(Refusal::OtherInterface(call)) }
    }

    fn require_simulation(&self, call: &'static str) -> Result<(), Refusal> {
        if self.is_exchange() { Err(Refusal::OtherInterface(call)) } else { Ok(()) }
    }

    /// Where the run stands; its start is computed if that has not been done.
    fn start(&mut self) -> Result<&Standing, Refusal> {
        let standing = match self.now.standing.take() {
            Some(standing) => standing,
            None => self.begin()?,
        };
        Ok(self.now.standing.insert(standing))
    }

    /// Where the run stands.
    fn standing(&self) -> Result<&Standing, Refusal> {
        let missing = || Refusal::OutOfOrder { call: "this", phase: self.now.phase };
        self.now.standing.as_ref().ok_or_else(missing)
    }

    fn begin(&self) -> Result<Standing, Refusal> {
        let simulator = self.machine.simulator();
        let parameters = &self.now.parameters;
        let mut state = vec![0.0; simulator.shape().states()];
        simulator.initial_state(parameters, &mut state);
        for (value, chosen) in state.iter_mut().zip(&self.now.chosen) {
            *value = chosen.unwrap_or(*value);
        }
        if let Some(entry) = state.iter().position(|value| !value.is_finite()) {
            let name = simulator.state(entry).name;
            return Err(Refusal::argument(format!("`{name}` starts at {}", state[entry])));
        }
        let Experiment { from, until, rtol } = self.now.experiment;
        let in_equilibrium = simulator.starts_in_equilibrium();
        // What the host sets is named to the search, as what `run` sets.
        let is_given = |entry: usize| {
            let is_set = in_equilibrium && self.now.chosen[entry].is_some();
            is_set || simulator.is_given(entry)
        };
        let is_stepped = self.is_exchange();
        let beginning =
            Beginning { from, until, rtol, is_stepped, state, is_given: &is_given, in_equilibrium };
        Ok(Hosted::new(simulator, parameters).begin(beginning)?)
    }

    /// Where a state's value at the start is from.
    fn initial(&self, entry: usize) -> Option<Initial> {
        let variables = self.machine.variables.all();
        let found = variables.iter().find(|variable| variable.kind.entry() == Some(entry));
        found.and_then(|variable| variable.initial)
    }
}

impl Now {
    fn of(machine: &Machine) -> Self {
        let run = &machine.model().run;
        Self {
            phase: Phase::Instantiated,
            parameters: machine.parameters(),
            chosen: vec![None; machine.simulator().shape().states()],
            experiment: Experiment { from: run.from, until: run.until, rtol: run.rtol },
            standing: None,
        }
    }
}
