//! Events, and steps between communication points.

use std::cell::Cell;
use std::sync::Arc;

use machinist::Method;
use machinist::hosted::{Hosted, Reached, Standing};

use super::{Instance, Interface, Phase, Refusal};
use crate::resource::Machine;

/// Permitted deviation of communication points, relative to the time reached or to the step.
const OFF: f64 = 1e-6;

/// Result of an update of discrete states.
#[derive(Debug, Clone, PartialEq)]
pub struct Update {
    /// Names of the events that happened.
    pub events: Vec<String>,
    /// True if a continuous state has changed.
    pub moves: bool,
    /// Next time at which the rate jumps \[s\].
    pub next: Option<f64>,
}

/// Step under way, detached from its instance so that others may look at the instance.
pub struct Step {
    machine: Arc<Machine>,
    parameters: Vec<f64>,
    standing: Standing,
    until: f64,
    halts: bool,
    /// True if the host allows the step to end early.
    pub may_return_early: bool,
    /// True if there are inputs that a host may set within the step.
    pub has_inputs: bool,
}

/// State within a step, shown to the host.
pub struct Intermediate<'a> {
    /// Time reached \[s\].
    pub time: f64,
    /// State of the run.
    pub standing: &'a Standing,
}

/// Reply of the host to an intermediate state.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Reply {
    /// Parameters including inputs, if the host has set one.
    pub parameters: Option<Vec<f64>>,
    /// Time at which the host wants the step to end \[s\].
    pub end: Option<f64>,
}

/// Callback for intermediate states.
pub type Looks<'a> = dyn Fn(&Intermediate<'_>) -> Reply + 'a;

/// Result of a step.
#[derive(Debug, Clone, PartialEq)]
pub struct Stepped {
    /// State of the run at the end.
    pub standing: Standing,
    /// Parameters, with inputs set within the step.
    pub parameters: Vec<f64>,
    /// True if the host has to handle an event.
    pub event: bool,
    /// True if the step ended early.
    pub early: bool,
}

impl Instance {
    /// Enters event mode.
    ///
    /// # Errors
    /// [`Refusal`] if the host has not asked for event mode, or outside the modes of a run.
    pub fn enter_event_mode(&mut self) -> Result<(), Refusal> {
        let call = "fmi3EnterEventMode";
        match self.interface {
            Interface::ModelExchange => self.require(call, &[Phase::ContinuousTime])?,
            Interface::CoSimulation { event_mode: true, .. } => {
                self.require(call, &[Phase::Step])?;
            }
            Interface::CoSimulation { event_mode: false, .. } => {
                return Err(Refusal::argument("event mode was not requested at instantiation"));
            }
        }
        self.now.phase = Phase::Event;
        Ok(())
    }

    /// Handles the events at the time reached.
    ///
    /// # Errors
    /// [`Refusal`] outside event mode, and if events are endless or fail.
    pub fn update_discrete_states(&mut self) -> Result<Update, Refusal> {
        self.require("fmi3UpdateDiscreteStates", &[Phase::Event])?;
        self.start()?;
        let machine = Arc::clone(&self.machine);
        let hosted = Hosted::new(machine.simulator(), &self.now.parameters);
        let mut standing = self.standing()?.clone();
        let switches = hosted.happen(&mut standing)?;
        let events = switches.into_iter().map(|switch| switch.event).collect();
        let before = &self.standing()?.state;
        let differs = |entry: &usize| before[*entry].to_bits() != standing.state[*entry].to_bits();
        let moves = machine.variables.states().iter().any(differs);
        let next = standing.next_jump().filter(|_| self.is_exchange());
        self.now.standing = Some(standing);
        Ok(Update { events, moves, next })
    }

    /// Enters continuous-time mode.
    ///
    /// # Errors
    /// [`Refusal`] if the instance is not in event mode of Model Exchange.
    pub fn enter_continuous_time(&mut self) -> Result<(), Refusal> {
        let call = "fmi3EnterContinuousTimeMode";
        self.require_exchange(call)?;
        self.require(call, &[Phase::Event])?;
        self.start()?;
        self.now.phase = Phase::ContinuousTime;
        Ok(())
    }

    /// Accepts a step of the host. Returns whether the host has to enter event mode.
    ///
    /// # Errors
    /// [`Refusal`] if the instance is not in continuous-time mode.
    pub fn completed_step(&mut self) -> Result<bool, Refusal> {
        let call = "fmi3CompletedIntegratorStep";
        self.require_exchange(call)?;
        self.require(call, &[Phase::ContinuousTime])?;
        let hosted = Hosted::new(self.machine.simulator(), &self.now.parameters);
        Ok(self.now.standing.as_mut().is_some_and(|standing| hosted.step_is_complete(standing)))
    }

    /// Enters step mode.
    ///
    /// # Errors
    /// [`Refusal`] if the instance is not in event mode of Co-Simulation.
    pub fn enter_step_mode(&mut self) -> Result<(), Refusal> {
        let call = "fmi3EnterStepMode";
        self.require_simulation(call)?;
        self.require(call, &[Phase::Event])?;
        self.now.phase = Phase::Step;
        Ok(())
    }

    /// Begins a step between communication points, which has to be [ended](Instance::end_step).
    ///
    /// # Errors
    /// [`Refusal`] if the instance is not in step mode or not at that time, or if the step does not
    /// go forward.
    pub fn begin_step(&mut self, from: f64, size: f64) -> Result<Step, Refusal> {
        let call = "fmi3DoStep";
        self.require_simulation(call)?;
        self.require(call, &[Phase::Step])?;
        let Interface::CoSimulation { event_mode, early_return } = self.interface else {
            return Err(Refusal::OtherInterface(call));
        };
        let mut standing = self.standing()?.clone();
        let until = from + size;
        if !(size > 0.0 && until.is_finite() && until > standing.time) {
            return Err(Refusal::Argument(format!("a step of {size} s from {from} s on")));
        }
        let room = OFF * size.max(1e-9 * from.abs());
        if (from - standing.time).abs() > room {
            let message = format!("the step is from {from} s, but the FMU is at {}", standing.time);
            return Err(Refusal::Argument(message));
        }
        if standing.is_at_event() {
            // The host leaves events to the instance.
            let machine = Arc::clone(&self.machine);
            Hosted::new(machine.simulator(), &self.now.parameters).happen(&mut standing)?;
        }
        let inputs = self.machine.variables.all().iter();
        let is_input = |causality| causality == crate::variables::Causality::Input;
        let has_inputs = inputs.map(|variable| variable.causality).any(is_input);
        let step = Step {
            machine: Arc::clone(&self.machine),
            parameters: self.now.parameters.clone(),
            standing,
            until,
            halts: event_mode && early_return,
            may_return_early: early_return,
            has_inputs,
        };
        self.now.phase = Phase::Intermediate;
        Ok(step)
    }

    /// Sets the state that the host sees within a step.
    pub fn show(&mut self, standing: &Standing) {
        self.now.standing = Some(standing.clone());
    }

    /// Present values of the parameters.
    #[must_use]
    pub fn parameters(&self) -> &[f64] {
        &self.now.parameters
    }

    /// Ends a step with its result, or restores the state before it if there is none.
    pub fn end_step(&mut self, before: &Step, stepped: Option<&Stepped>) {
        let (standing, parameters) = stepped.map_or_else(
            || (&before.standing, &before.parameters),
            |stepped| (&stepped.standing, &stepped.parameters),
        );
        self.now.standing = Some(standing.clone());
        self.now.parameters.clone_from(parameters);
        self.now.phase = Phase::Step;
    }
}

impl Step {
    /// Takes the step. `looks` is called after every step of the method.
    ///
    /// # Errors
    /// [`Refusal`] if the method fails.
    pub fn take(&self, looks: Option<&Looks<'_>>) -> Result<Stepped, Refusal> {
        let mut standing = self.standing.clone();
        let mut parameters = self.parameters.clone();
        let mut until = self.until;
        loop {
            let hosted = Hosted::new(self.machine.simulator(), &parameters);
            // The host handles jumps in the same way as events.
            let jump = standing.next_jump().filter(|jump| self.halts && *jump < until);
            let reply = Cell::new(Reply::default());
            let shown = standing.clone();
            let leaves = |time: f64, state: &[f64]| {
                let Some(looks) = looks else { return false };
                let standing = hosted.at(&shown, time, state);
                let told = looks(&Intermediate { time, standing: &standing });
                let leaves = told != Reply::default();
                reply.set(told);
                leaves
            };
            let how = (Method::Auto, self.halts);
            let piece = hosted.carry(&mut standing, jump.unwrap_or(until), how, &leaves)?;
            let early = standing.time < self.until;
            match piece.reached {
                Reached::Event => {
                    return Ok(Stepped { standing, parameters, event: true, early });
                }
                Reached::End => {
                    let event = jump.is_some();
                    return Ok(Stepped { standing, parameters, event, early });
                }
                Reached::Interrupted => {
                    let Reply { parameters: set, end } = reply.take();
                    if let Some(end) = end {
                        until = until.min(end.max(standing.time));
                    }
                    parameters = set.unwrap_or(parameters);
                    if until <= standing.time {
                        return Ok(Stepped { standing, parameters, event: false, early });
                    }
                }
            }
        }
    }
}
