//! The equations that a method integrates, and counts of their evaluations.

use std::cell::{Cell, RefCell};
use std::time::{Duration, Instant};

use super::Stopped;
#[cfg(feature = "implicit")]
use super::exact::Known;
use super::milestone::Milestone;
use super::patience::Patience;
use super::sliding::Slide;
use crate::constraints::{Constraints, EnergyLevel};
use crate::error::StopCause;
use crate::held::Held;
use crate::method::reverse::Log;
use crate::method::sensitivity::Tangents;
use crate::trajectory::Work;
use machinist_contract::{Simulator, SparsityPattern};

/// Energy supplied, energy dissipated, energy passed.
pub(crate) const FLOWS: usize = 3;

/// y' = f(t, y) of one simulator at fixed parameters, y = \[q, q', z\], optionally followed by
/// three quadratures of its power balance:
///
/// ```text
/// w_supplied' = P_supplied    w_dissipated' = P_dissipated
/// w_passed'   = |P_supplied| + |P_dissipated|
/// ```
pub struct System<'a> {
    simulator: &'a dyn Simulator<f64>,
    parameters: &'a [f64],
    /// Parameters and slots of relations, as steps hold them.
    held: Held,
    /// Relations along whose surfaces the motion slides.
    pub(super) slides: RefCell<Vec<Slide>>,
    /// Values that depend on the parameters alone, computed once per run.
    constants: Vec<f64>,
    states: usize,
    with_flows: bool,
    constraints: Option<Constraints<'a>>,
    /// Energy that steps keep, if they keep it.
    energy_level: Option<EnergyLevel>,
    tangents: Option<Tangents<'a>>,
    log: Option<&'a Log>,
    work: Cell<Work>,
    /// Largest absolute value of every state at ends of steps.
    sizes: RefCell<Vec<f64>>,
    notes: RefCell<Vec<String>>,
    patience: Patience<'a>,
    /// Start of the run, if its time is limited.
    began: Option<Instant>,
    onlooker: Option<Onlooker<'a>>,
    /// Length of the run of which this is a piece \[s\]; 0 if it is none.
    whole: f64,
    has_stepped: Cell<bool>,
    milestone: Cell<Milestone>,
    /// Equations in closed form, by relations and modes as held.
    #[cfg(feature = "implicit")]
    closed_forms: RefCell<Known>,
}

/// Receives time and state after every step that is not the last of a stretch. Returns whether the
/// run is to end there.
pub(crate) type Onlooker<'a> = &'a dyn Fn(f64, &[f64]) -> bool;

impl<'a> System<'a> {
    /// Returns the equations of `simulator`, with or without energy quadratures.
    #[must_use]
    pub fn new(simulator: &'a dyn Simulator<f64>, parameters: &'a [f64], with_flows: bool) -> Self {
        let states = simulator.shape().states();
        let mut constants = vec![0.0; simulator.constants()];
        simulator.prepare(parameters, &mut constants);
        let held = Held::live(simulator, parameters);
        Self {
            simulator,
            parameters,
            constraints: Constraints::held(simulator, &held),
            held,
            slides: RefCell::default(),
            constants,
            states,
            with_flows,
            energy_level: None,
            tangents: None,
            log: None,
            work: Cell::default(),
            sizes: RefCell::new(vec![0.0; states]),
            notes: RefCell::default(),
            patience: Patience::default(),
            began: None,
            onlooker: None,
            whole: 0.0,
            has_stepped: Cell::new(false),
            milestone: Cell::default(),
            #[cfg(feature = "implicit")]
            closed_forms: RefCell::default(),
        }
    }

    /// Returns the system with limits of the run from now on.
    pub(crate) fn within(self, patience: Patience<'a>) -> Self {
        Self { patience, began: patience.limit.map(|_| Instant::now()), ..self }
    }

    /// Returns the system with an onlooker of its steps.
    pub(crate) fn shown_to(self, onlooker: Option<Onlooker<'a>>) -> Self {
        Self { onlooker, ..self }
    }

    /// Returns the system for a piece of a run of this length \[s\].
    pub(crate) fn piece_of(self, whole: f64) -> Self {
        Self { whole, ..self }
    }

    /// Returns the length of the run of which this is a piece \[s\]; 0 if it is none.
    pub(super) fn whole(&self) -> f64 {
        self.whole
    }

    /// Returns whether the onlooker ends the run here.
    pub(super) fn is_left_at(&self, time: f64, state: &[f64]) -> bool {
        self.onlooker.is_some_and(|leaves| leaves(time, &state[..self.states]))
    }

    /// Returns the system with sensitivities carried along.
    pub(crate) fn with_tangents(self, tangents: Option<Tangents<'a>>) -> Self {
        if let Some(tangents) = &tangents {
            tangents.hold(&self.held);
        }
        Self { tangents, ..self }
    }

    /// Returns the system with steps that keep the energy of their start, if wanted.
    pub(crate) fn keeping_energy(self, is_wanted: bool) -> Self {
        Self { energy_level: is_wanted.then(EnergyLevel::default), ..self }
    }

    /// Keeps the energy of a state at the start of a stretch. Events may change it.
    pub(super) fn keep_energy_of(&self, time: f64, state: &[f64]) {
        if let (Some(level), Some(constraints)) = (&self.energy_level, &self.constraints) {
            if self.simulator.events() > 0 {
                level.end();
            }
            level.begin(constraints, time, &state[..self.states]);
        }
    }

    /// Returns the system with a log of its steps.
    pub(crate) fn logged(self, log: Option<&'a Log>) -> Self {
        Self { log, ..self }
    }

    /// Returns the log of the steps, if there is one.
    pub(crate) fn log(&self) -> Option<&'a Log> {
        self.log
    }

    /// Returns the sensitivities, if they are requested.
    pub(crate) fn tangents(&self) -> Option<&Tangents<'a>> {
        self.tangents.as_ref()
    }

    /// Returns the reason for the run to end, if there is one.
    pub(super) fn interruption(&self) -> Option<StopCause> {
        self.patience.end(|| self.began.map_or(Duration::ZERO, |began| began.elapsed()))
    }

    /// Returns the simulator, for methods that need more than rate and Jacobian.
    #[must_use]
    pub fn simulator(&self) -> &'a dyn Simulator<f64> {
        self.simulator
    }

    /// Returns the constraints, if there are any.
    pub(crate) fn constraints(&self) -> Option<&Constraints<'a>> {
        self.constraints.as_ref()
    }

    /// Projects a state onto the constraints, if there are any, and onto the energy of the run if
    /// its steps keep it.
    pub(crate) fn constrain(&self, time: f64, state: &mut [f64]) -> Result<(), Stopped> {
        let Some(constraints) = &self.constraints else { return Ok(()) };
        constraints.project(time, state).map_err(|lost| {
            let constraint = constraints.name(lost.0).to_owned();
            Stopped { time, cause: StopCause::OffConstraint { constraint } }
        })?;
        if let Some(level) = &self.energy_level {
            constraints.put_onto_energy(level, time, state);
        }
        Ok(())
    }

    /// Returns the parameters and slots, as steps hold them.
    pub(crate) fn held(&self) -> &Held {
        &self.held
    }

    /// Returns whether an event is armed: all its modes have their values.
    pub(crate) fn is_armed(&self, event: usize, state: &[f64]) -> bool {
        let when = self.simulator.event(event).when;
        // Modes are integers, but for rounding.
        when.iter().all(|(entry, value)| (state[*entry as usize] - value).abs() < 0.5)
    }

    /// Returns the entries of the state that an event sets, and their new values.
    pub(crate) fn new_values(&self, event: usize, time: f64, state: &[f64]) -> Vec<(usize, f64)> {
        let count = |event: usize| self.simulator.event(event).sets.len();
        let mut values = vec![0.0; (0..self.simulator.events()).map(count).sum()];
        self.simulator.resets(time, state, &self.held.all(), &mut values);
        let first: usize = (0..event).map(count).sum();
        let entries = self.simulator.event(event).sets.iter().map(|entry| *entry as usize);
        entries.zip(values[first..].iter().copied()).collect()
    }

    /// Returns the parameters.
    #[must_use]
    pub fn parameters(&self) -> &'a [f64] {
        self.parameters
    }

    /// Returns the number of equations.
    #[must_use]
    pub fn len(&self) -> usize {
        self.states() + if self.with_flows { FLOWS } else { 0 }
    }

    /// Returns whether there is nothing to integrate.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns the number of states of the simulator, without quadratures.
    #[must_use]
    pub fn states(&self) -> usize {
        self.states
    }

    /// Returns the name of the unknown of the `index`-th equation.
    #[must_use]
    pub fn name(&self, index: usize) -> String {
        if index < self.states() {
            self.simulator.state(index).name.to_owned()
        } else {
            "energy flow".to_owned()
        }
    }

    /// Evaluates f(t, y), `len` long.
    pub fn rate(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        let states = self.states();
        let (rate, flow_rates) = rate.split_at_mut(states);
        let state = &state[..states];
        self.state_rate(time, state, rate);
        if self.with_flows {
            flow_rates.copy_from_slice(&self.flow_rates(time, state));
        }
    }

    /// Evaluates f(t, y) without the quadratures, `states` long.
    pub fn state_rate(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        if self.is_sliding() {
            self.sliding_rate(time, state, rate);
        } else {
            self.rate_of_modes(time, state, rate);
        }
    }

    /// Evaluates f(t, y) with relations as held, whether the motion slides or not.
    pub(super) fn rate_of_modes(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        self.count(|work| work.rate_evaluations += 1);
        self.simulator.prepared_rate(time, state, &self.held.all(), &self.constants, rate);
    }

    /// Returns the nonzeros of df/dy without the rows of the quadratures.
    #[must_use]
    pub fn jacobian_pattern(&self) -> SparsityPattern<'a> {
        self.simulator.rate_jacobian_pattern()
    }

    /// Evaluates df/dy without the rows of the quadratures, values in pattern order.
    pub fn jacobian(&self, time: f64, state: &[f64], values: &mut [f64]) {
        self.count(|work| work.jacobian_evaluations += 1);
        let state = &state[..self.states()];
        if self.is_sliding() {
            return self.sliding_jacobian(time, state, values);
        }
        let (parameters, constants) = (self.held.all(), &self.constants);
        self.simulator.prepared_rate_jacobian(time, state, &parameters, constants, values);
    }

    /// Evaluates df/dy, then df/dp, without the rows of the quadratures, values in pattern order.
    pub(crate) fn jacobians(&self, time: f64, state: &[f64], values: &mut [f64]) {
        self.count(|work| work.jacobian_evaluations += 1);
        let state = &state[..self.states()];
        let (parameters, constants) = (self.held.all(), &self.constants);
        self.simulator.prepared_jacobians(time, state, &parameters, constants, values);
    }

    /// Returns the rows of df/dy that belong to the quadratures, as `(column, entries)`; none if
    /// there are no quadratures.
    ///
    /// They are forward differences. With rows of zeros Newton's iteration sees the power one
    /// iterate late, takes that for slow convergence, and cuts steps. With these rows it converges
    /// as without quadratures, and its result does not depend on them.
    pub fn flow_gradient(&self, time: f64, state: &[f64]) -> Vec<(usize, [f64; FLOWS])> {
        if !self.with_flows {
            return Vec::new();
        }
        let mut shifted = state[..self.states()].to_vec();
        let base = self.flow_rates(time, &shifted);
        let column = |index: usize| {
            let value = shifted[index];
            let size = value.abs().max(self.simulator.state_scale(index));
            shifted[index] = value + f64::EPSILON.sqrt() * size;
            let step = shifted[index] - value;
            let ahead = self.flow_rates(time, &shifted);
            shifted[index] = value;
            (index, std::array::from_fn(|flow| (ahead[flow] - base[flow]) / step))
        };
        (0..self.states()).map(column).collect()
    }

    /// Evaluates the partial derivative of f with respect to time, without quadratures.
    pub fn time_derivative(&self, time: f64, state: &[f64], derivative: &mut [f64]) {
        let states = self.states();
        let (state, derivative) = (&state[..states], &mut derivative[..states]);
        if self.is_sliding() {
            return self.sliding_time_derivative(time, state, derivative);
        }
        let (parameters, constants) = (self.held.all(), &self.constants);
        self.simulator.prepared_time_derivative(time, state, &parameters, constants, derivative);
    }

    /// Adds a note on the run for the user; repetitions and notes beyond a limit are left out.
    pub fn note(&self, note: String) {
        const MOST: usize = 100;
        let mut notes = self.notes.borrow_mut();
        if notes.len() < MOST && !notes.contains(&note) {
            notes.push(note);
        }
    }

    /// Returns all notes.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        self.notes.borrow().clone()
    }

    /// Counts a step whose error was controlled.
    pub fn count_step(&self) {
        self.has_stepped.set(true);
        self.count(|work| work.steps += 1);
    }

    /// Measures the states at the end of a step.
    pub(super) fn measure(&self, state: &[f64]) {
        for (size, value) in self.sizes.borrow_mut().iter_mut().zip(state) {
            *size = size.max(value.abs());
        }
    }

    /// Returns the largest absolute value of every state at ends of steps.
    pub(crate) fn sizes(&self) -> Vec<f64> {
        self.sizes.borrow().clone()
    }

    /// Returns whether there was such a step: there is none if everything was solved in closed
    /// form.
    #[must_use]
    pub fn has_stepped(&self) -> bool {
        self.has_stepped.get()
    }

    /// Returns the mean of many steps, of which the last ended at `time` \[s\], once in as many.
    /// Returns `None` for a run that others may end early, whose end need not be reached.
    pub(super) fn pace(&self, time: f64) -> Option<f64> {
        if self.patience.is_limited() || self.onlooker.is_some() {
            return None;
        }
        let mut milestone = self.milestone.get();
        let pace = milestone.pace(self.work().steps, time);
        self.milestone.set(milestone);
        pace
    }

    /// Returns the equations known in closed form.
    #[cfg(feature = "implicit")]
    pub(super) fn closed_forms(&self) -> &RefCell<Known> {
        &self.closed_forms
    }

    /// Adds to the counts.
    pub fn count(&self, add: impl FnOnce(&mut Work)) {
        let mut work = self.work.get();
        add(&mut work);
        self.work.set(work);
    }

    /// Returns the counts so far.
    #[must_use]
    pub fn work(&self) -> Work {
        self.work.get()
    }

    /// Returns the rates of the quadratures.
    #[must_use]
    pub fn flow_rates(&self, time: f64, state: &[f64]) -> [f64; FLOWS] {
        if self.is_sliding() {
            return self.sliding_flows(time, state);
        }
        let power = self.simulator.power_balance(time, state, &self.held.all());
        let passed = power.supplied.abs() + power.dissipated.abs();
        [power.supplied, power.dissipated, passed]
    }
}
