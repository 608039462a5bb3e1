//! Instance of an FMU: its mode, the calls allowed in each mode, and its values.
//!
//! A call that fails changes nothing: the instance stays as it was before. Calls in a mode in which
//! the standard does not allow them are refused.

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

/// Interface by which a host drives an instance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interface {
    /// The host integrates with a method of its own.
    ModelExchange,
    /// The instance integrates between the host's communication points.
    CoSimulation {
        /// True if the host handles events.
        event_mode: bool,
        /// True if the host accepts steps that end early.
        early_return: bool,
    },
}

/// Mode of an instance, in the standard's words.
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
    /// Within a step, during a callback of the host.
    Intermediate,
    /// Terminated.
    Terminated,
}

/// Reason why an instance refuses a call.
#[derive(Debug, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "fmu::", serialize_all = "kebab-case")]
pub enum Refusal {
    /// The call is not allowed in the present mode.
    #[error("{call} is not allowed in {phase:?} mode")]
    OutOfOrder {
        /// Name of the call.
        call: &'static str,
        /// Mode of the instance.
        phase: Phase,
    },
    /// The call belongs to the other interface.
    #[error("{0} does not belong to the interface that was instantiated")]
    OtherInterface(&'static str),
    /// An argument is invalid.
    #[error("{0}")]
    Argument(String),
    /// The run cannot start or continue.
    #[strum(serialize = "")]
    #[error(transparent)]
    Run(#[from] HostedError),
    /// A result is not finite. A shorter step may help.
    #[error("{0} is not a finite number")]
    NotFinite(String),
}

impl Refusal {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Run(error) => error.code(),
            error => error.into(),
        }
    }
}

impl Refusal {
    /// Creates the refusal of an invalid argument.
    pub(crate) fn argument(message: impl Into<String>) -> Self {
        Self::Argument(message.into())
    }

    /// Returns whether the host may try a shorter step.
    #[must_use]
    pub fn is_discard(&self) -> bool {
        matches!(self, Self::NotFinite(_))
    }
}

/// Experiment of the host.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Experiment {
    /// Start time \[s\].
    pub from: f64,
    /// End time, from which the length of the run is taken \[s\].
    pub until: f64,
    /// Relative tolerance.
    pub rtol: f64,
}

/// Mutable data of an instance.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Now {
    phase: Phase,
    parameters: Vec<f64>,
    /// Start values that the host has set for entries of the state.
    chosen: Vec<Option<f64>>,
    experiment: Experiment,
    /// State of the run; `None` until the start is computed.
    standing: Option<Standing>,
}

/// Instance of an FMU.
#[derive(Debug)]
pub struct Instance {
    machine: Arc<Machine>,
    interface: Interface,
    now: Now,
    /// States kept for the host, by their handles.
    kept: BTreeMap<usize, Snapshot>,
    handles: usize,
}

impl Instance {
    /// Instantiates a machine.
    #[must_use]
    pub fn new(machine: Arc<Machine>, interface: Interface) -> Self {
        let now = Now::of(&machine);
        Self { machine, interface, now, kept: BTreeMap::new(), handles: 0 }
    }

    /// Mode of the instance.
    #[must_use]
    pub fn phase(&self) -> Phase {
        self.now.phase
    }

    /// Machine of the instance.
    #[must_use]
    pub fn machine(&self) -> &Arc<Machine> {
        &self.machine
    }

    /// Time reached \[s\]; before the start, the start time.
    #[must_use]
    pub fn time(&self) -> f64 {
        let Now { standing, experiment, .. } = &self.now;
        standing.as_ref().map_or(experiment.from, |standing| standing.time)
    }

    /// Resets the instance to its state after instantiation.
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
    /// [`Refusal`] if the instance was not just instantiated, or if times or the tolerance are
    /// invalid.
    pub fn enter_initialization(
        &mut self,
        tolerance: Option<f64>,
        from: f64,
        until: Option<f64>,
    ) -> Result<(), Refusal> {
        self.require("fmi3EnterInitializationMode", &[Phase::Instantiated])?;
        self.now.experiment = self.experiment_of(tolerance, from, until)?;
        self.now.standing = None;
        self.now.phase = Phase::Initialization;
        Ok(())
    }

    /// Sets up the experiment before initialization mode is entered, as FMI 2.0 does.
    ///
    /// # Errors
    /// [`Refusal`] as [`Instance::enter_initialization`].
    pub fn set_up(
        &mut self,
        tolerance: Option<f64>,
        from: f64,
        until: Option<f64>,
    ) -> Result<(), Refusal> {
        self.require("fmi2SetupExperiment", &[Phase::Instantiated])?;
        self.now.experiment = self.experiment_of(tolerance, from, until)?;
        Ok(())
    }

    /// Experiment of the host; before it is set up, that of the model.
    #[must_use]
    pub fn experiment(&self) -> Experiment {
        self.now.experiment
    }

    /// Returns an experiment with the values of the model where the host gives none.
    fn experiment_of(
        &self,
        tolerance: Option<f64>,
        from: f64,
        until: Option<f64>,
    ) -> Result<Experiment, Refusal> {
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
        Ok(Experiment { from, until, rtol })
    }

    /// Leaves initialization mode for event mode or step mode.
    ///
    /// # Errors
    /// [`Refusal`] if the instance is not in initialization mode, or if the machine cannot start.
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

    /// Returns the state of the run, after computing the start if needed.
    fn start(&mut self) -> Result<&Standing, Refusal> {
        let standing = match self.now.standing.take() {
            Some(standing) => standing,
            None => self.begin()?,
        };
        Ok(self.now.standing.insert(standing))
    }

    /// Returns the state of the run.
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
        // Entries set by the host count as given in the search, like those that `run` sets.
        let is_given = |entry: usize| {
            let is_set = in_equilibrium && self.now.chosen[entry].is_some();
            is_set || simulator.is_given(entry)
        };
        let is_stepped = self.is_exchange();
        let beginning =
            Beginning { from, until, rtol, is_stepped, state, is_given: &is_given, in_equilibrium };
        Ok(Hosted::new(simulator, parameters).begin(beginning)?)
    }

    /// Returns the origin of the start value of an entry of the state.
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
