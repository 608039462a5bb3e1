//! Values of variables: reading, and setting where the standard allows it.

use std::cell::OnceCell;

use machinist::hosted::{Hosted, Standing};

use super::{Instance, Phase, Refusal};
use crate::variables::{Causality, Initial, Kind, Variability, Variable};

/// Type of the variables that a function gets or sets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Type {
    /// Floating-point numbers of 64 bits.
    Float64,
    /// Integers of 32 bits.
    Int32,
}

impl Type {
    fn of(kind: Kind) -> Self {
        if matches!(kind, Kind::Mode(_)) { Self::Int32 } else { Self::Float64 }
    }
}

/// Quantities at the present state, computed once for all variables asked for.
struct Looks<'a> {
    instance: &'a Instance,
    standing: &'a Standing,
    rate: OnceCell<Vec<f64>>,
    outputs: OnceCell<Vec<f64>>,
    indicators: OnceCell<Vec<f64>>,
}

impl<'a> Looks<'a> {
    fn new(instance: &'a Instance, standing: &'a Standing) -> Self {
        let [rate, outputs, indicators] = [OnceCell::new(), OnceCell::new(), OnceCell::new()];
        Self { instance, standing, rate, outputs, indicators }
    }

    fn value(&self, kind: Kind) -> f64 {
        match kind {
            Kind::Time => self.standing.time,
            Kind::State(entry) | Kind::Mode(entry) => self.standing.state[entry],
            Kind::Parameter(index) => self.instance.now.parameters[index],
            Kind::Derivative(entry) => {
                self.rate.get_or_init(|| self.instance.rate(self.standing))[entry]
            }
            Kind::Output(index) => {
                self.outputs.get_or_init(|| self.instance.outputs(self.standing))[index]
            }
            Kind::Indicator(index) => {
                self.indicators.get_or_init(|| self.instance.indicators(self.standing))[index]
            }
            Kind::Step => unreachable!("the library chooses its steps itself"),
        }
    }
}

impl Instance {
    /// Gets values of variables of one type, by reference.
    ///
    /// # Errors
    /// [`Refusal`] before initialization mode, for references that are no variables of the type,
    /// and if the machine cannot start.
    pub fn get(&mut self, of: Type, references: &[u32], values: &mut [f64]) -> Result<(), Refusal> {
        if self.now.phase == Phase::Instantiated {
            let call = "reading values";
            return Err(Refusal::OutOfOrder { call, phase: self.now.phase });
        }
        require_count(references.len(), values.len())?;
        for reference in references {
            self.variable(*reference, of)?;
        }
        self.start()?;
        let looks = Looks::new(self, self.standing()?);
        for (reference, value) in references.iter().zip(values) {
            *value = looks.value(self.variable(*reference, of)?.kind);
        }
        Ok(())
    }

    /// Sets variables of one type, all or none.
    ///
    /// # Errors
    /// [`Refusal`] for references that are no variables of the type, for variables that cannot be
    /// set in this mode, and for values that are not finite.
    pub fn set(&mut self, of: Type, references: &[u32], values: &[f64]) -> Result<(), Refusal> {
        require_count(references.len(), values.len())?;
        for (reference, value) in references.iter().zip(values) {
            let variable = self.variable(*reference, of)?;
            if !self.can_be_set(variable) {
                let (name, phase) = (&variable.name, self.now.phase);
                let message = format!("`{name}` cannot be set in {phase:?} mode");
                return Err(Refusal::Argument(message));
            }
            if !value.is_finite() {
                return Err(Refusal::Argument(format!("`{}` cannot be {value}", variable.name)));
            }
        }
        for (reference, value) in references.iter().zip(values) {
            match self.variable(*reference, of)?.kind {
                Kind::Parameter(index) => self.now.parameters[index] = *value,
                Kind::State(entry) | Kind::Mode(entry) => self.now.chosen[entry] = Some(*value),
                Kind::Time
                | Kind::Derivative(_)
                | Kind::Output(_)
                | Kind::Indicator(_)
                | Kind::Step => {}
            }
        }
        if matches!(self.now.phase, Phase::Instantiated | Phase::Initialization)
            && !references.is_empty()
        {
            self.now.standing = None;
        }
        Ok(())
    }

    pub(super) fn variable(&self, reference: u32, of: Type) -> Result<&Variable, Refusal> {
        let found = self.machine.variables.get(reference);
        let variable = found.filter(|variable| Type::of(variable.kind) == of);
        variable.ok_or_else(|| {
            Refusal::Argument(format!("no variable of type {of:?} has value reference {reference}"))
        })
    }

    fn can_be_set(&self, variable: &Variable) -> bool {
        let phase = self.now.phase;
        match (variable.causality, variable.initial) {
            (Causality::Input, _) => match phase {
                Phase::Terminated => false,
                Phase::Instantiated
                | Phase::Initialization
                | Phase::Event
                | Phase::ContinuousTime
                | Phase::Step
                | Phase::Intermediate => true,
            },
            (Causality::Parameter, _) => match phase {
                Phase::Instantiated | Phase::Initialization => true,
                Phase::Event | Phase::Step => variable.variability == Variability::Tunable,
                Phase::ContinuousTime | Phase::Intermediate | Phase::Terminated => false,
            },
            (_, Some(Initial::Exact)) => {
                matches!(phase, Phase::Instantiated | Phase::Initialization)
            }
            (_, Some(Initial::Approx)) => phase == Phase::Instantiated,
            _ => false,
        }
    }

    /// Computes y' at a state of the run.
    pub(super) fn rate(&self, standing: &Standing) -> Vec<f64> {
        let simulator = self.machine.simulator();
        let mut rate = vec![0.0; standing.state.len()];
        Hosted::new(simulator, &self.now.parameters).rate(standing, &mut rate);
        rate
    }

    fn outputs(&self, standing: &Standing) -> Vec<f64> {
        let simulator = self.machine.simulator();
        let mut outputs = vec![0.0; simulator.shape().outputs];
        let time = standing.within(standing.time);
        simulator.outputs(time, &standing.state, &self.now.parameters, &mut outputs);
        outputs
    }

    fn indicators(&self, standing: &Standing) -> Vec<f64> {
        let hosted = Hosted::new(self.machine.simulator(), &self.now.parameters);
        let mut indicators = vec![0.0; hosted.indicators()];
        hosted.indicate(standing, &mut indicators);
        indicators
    }

    /// Gets the continuous states, in the order in which the host knows them.
    ///
    /// # Errors
    /// [`Refusal`] if the call is not allowed in this mode or interface.
    pub fn continuous_states(&mut self, values: &mut [f64]) -> Result<(), Refusal> {
        self.for_states("fmi3GetContinuousStates", values, |_, standing| standing.state.clone())
    }

    /// Gets the derivatives of the continuous states.
    ///
    /// # Errors
    /// [`Refusal`] likewise, or if a derivative is not finite.
    pub fn derivatives(&mut self, values: &mut [f64]) -> Result<(), Refusal> {
        self.for_states("fmi3GetContinuousStateDerivatives", values, Self::rate)?;
        match values.iter().position(|value| !value.is_finite()) {
            None => Ok(()),
            Some(index) => {
                let entry = self.machine.variables.states()[index];
                let name = self.machine.simulator().state(entry).name;
                Err(Refusal::NotFinite(format!("the rate of `{name}`")))
            }
        }
    }

    /// Gets the typical sizes of the continuous states.
    ///
    /// # Errors
    /// [`Refusal`] likewise.
    pub fn nominals(&mut self, values: &mut [f64]) -> Result<(), Refusal> {
        let sizes = |instance: &Self, standing: &Standing| {
            let simulator = instance.machine.simulator();
            (0..standing.state.len()).map(|entry| simulator.state_scale(entry)).collect()
        };
        self.for_states("fmi3GetNominalsOfContinuousStates", values, sizes)
    }

    fn for_states(
        &mut self,
        call: &'static str,
        values: &mut [f64],
        compute: impl Fn(&Self, &Standing) -> Vec<f64>,
    ) -> Result<(), Refusal> {
        self.require_exchange(call)?;
        let phases =
            [Phase::Initialization, Phase::Event, Phase::ContinuousTime, Phase::Terminated];
        self.require(call, &phases)?;
        require_count(self.machine.variables.states().len(), values.len())?;
        self.start()?;
        let all = compute(self, self.standing()?);
        for (value, entry) in values.iter_mut().zip(self.machine.variables.states()) {
            *value = all[*entry];
        }
        Ok(())
    }

    /// Gets the event indicators.
    ///
    /// # Errors
    /// [`Refusal`] likewise.
    pub fn event_indicators(&mut self, values: &mut [f64]) -> Result<(), Refusal> {
        let call = "fmi3GetEventIndicators";
        self.require_exchange(call)?;
        let phases =
            [Phase::Initialization, Phase::Event, Phase::ContinuousTime, Phase::Terminated];
        self.require(call, &phases)?;
        require_count(self.machine.variables.indicators(), values.len())?;
        self.start()?;
        values.copy_from_slice(&self.indicators(self.standing()?));
        Ok(())
    }

    /// Sets time, in continuous-time mode.
    ///
    /// # Errors
    /// [`Refusal`] in other modes, or if the time is not finite.
    pub fn set_time(&mut self, time: f64) -> Result<(), Refusal> {
        let call = "fmi3SetTime";
        self.require_exchange(call)?;
        self.require(call, &[Phase::ContinuousTime])?;
        if !time.is_finite() {
            return Err(Refusal::Argument(format!("time cannot be {time}")));
        }
        if let Some(standing) = &mut self.now.standing {
            standing.time = time;
        }
        Ok(())
    }

    /// Sets continuous states, in continuous-time mode.
    ///
    /// # Errors
    /// [`Refusal`] in other modes, or if a state is not finite.
    pub fn set_continuous_states(&mut self, values: &[f64]) -> Result<(), Refusal> {
        let call = "fmi3SetContinuousStates";
        self.require_exchange(call)?;
        self.require(call, &[Phase::ContinuousTime])?;
        let entries = self.machine.variables.states();
        require_count(entries.len(), values.len())?;
        if let Some(index) = values.iter().position(|value| !value.is_finite()) {
            let name = self.machine.simulator().state(entries[index]).name;
            return Err(Refusal::NotFinite(format!("`{name}`")));
        }
        if let Some(standing) = &mut self.now.standing {
            for (entry, value) in entries.iter().zip(values) {
                standing.state[*entry] = *value;
            }
        }
        Ok(())
    }
}

/// Returns an error unless there are as many values as variables.
pub(super) fn require_count(expected: usize, found: usize) -> Result<(), Refusal> {
    if expected == found {
        Ok(())
    } else {
        Err(Refusal::Argument(format!("{found} values for {expected} variables")))
    }
}
