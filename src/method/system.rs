//! The equations a method integrates, and the count of how often it asks.

use std::cell::{Cell, RefCell};
use std::time::{Duration, Instant};

use super::Stopped;
use super::loose::Trial;
use super::milestone::Milestone;
use super::patience::Patience;
use crate::constraints::Constraints;
use crate::error::StopCause;
use crate::method::reverse::Log;
use crate::method::sensitivity::Tangents;
use machinist_contract::{Simulator, SparsityPattern};
use serde::Serialize;

/// Energy supplied, energy dissipated, energy passed.
pub(crate) const FLOWS: usize = 3;

/// What a run has cost. Evaluations are counted here, at the simulator, and not
/// taken from what a solver says of itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Work {
    /// Steps accepted.
    pub steps: u64,
    /// Steps tried and rejected for their error.
    pub rejected: u64,
    /// Evaluations of the right-hand side.
    pub rate_evaluations: u64,
    /// Evaluations of its Jacobian.
    pub jacobian_evaluations: u64,
    /// Factorizations of a step's matrix.
    pub factorizations: u64,
    /// Newton iterations, each with one solution of a factored system.
    pub newton_iterations: u64,
    /// Events that happened.
    pub switches: u64,
}

/// y' = f(t, y) of one simulator at fixed parameters, y = \[q, q', z\], followed
/// on demand by three quadratures of its power balance:
///
/// ```text
/// w_supplied' = P_supplied    w_dissipated' = P_dissipated
/// w_passed'   = |P_supplied| + |P_dissipated|
/// ```
pub struct System<'a> {
    simulator: &'a dyn Simulator<f64>,
    parameters: &'a [f64],
    /// What the parameters alone decide, computed once a run.
    constants: Vec<f64>,
    states: usize,
    with_flows: bool,
    constraints: Option<Constraints<'a>>,
    tangents: Option<Tangents<'a>>,
    log: Option<&'a Log>,
    work: Cell<Work>,
    notes: RefCell<Vec<String>>,
    patience: Patience<'a>,
    /// When it began, if it may not take as long as it likes.
    began: Option<Instant>,
    onlooker: Option<Onlooker<'a>>,
    /// Length of the run that this is a piece of \[s\]; 0 if it is none.
    whole: f64,
    has_stepped: Cell<bool>,
    milestone: Cell<Milestone>,
    /// What is tried with loose steps, while it is.
    trial: Cell<Option<Trial>>,
}

/// Who is shown time and state after every step that is not the last of a stretch, and says
/// whether the run is to end there.
pub(crate) type Onlooker<'a> = &'a dyn Fn(f64, &[f64]) -> bool;

impl<'a> System<'a> {
    /// The equations of `simulator`, with or without energy quadratures.
    #[must_use]
    pub fn new(simulator: &'a dyn Simulator<f64>, parameters: &'a [f64], with_flows: bool) -> Self {
        let states = simulator.shape().states();
        let mut constants = vec![0.0; simulator.constants()];
        simulator.prepare(parameters, &mut constants);
        Self {
            simulator,
            parameters,
            constants,
            states,
            with_flows,
            constraints: Constraints::of(simulator, parameters),
            tangents: None,
            log: None,
            work: Cell::default(),
            notes: RefCell::default(),
            patience: Patience::default(),
            began: None,
            onlooker: None,
            whole: 0.0,
            has_stepped: Cell::new(false),
            milestone: Cell::default(),
            trial: Cell::new(None),
        }
    }

    /// The same, that goes on only so long from now on.
    pub(crate) fn within(self, patience: Patience<'a>) -> Self {
        Self { patience, began: patience.limit.map(|_| Instant::now()), ..self }
    }

    /// The same, whose steps somebody looks at.
    pub(crate) fn shown_to(self, onlooker: Option<Onlooker<'a>>) -> Self {
        Self { onlooker, ..self }
    }

    /// The same for a piece of a run of this length \[s\].
    pub(crate) fn piece_of(self, whole: f64) -> Self {
        Self { whole, ..self }
    }

    /// Length of the run that this is a piece of \[s\]; 0 if it is none.
    pub(super) fn whole(&self) -> f64 {
        self.whole
    }

    /// Whether the run is to end where it is, by who looks at its steps.
    pub(super) fn is_left_at(&self, time: f64, state: &[f64]) -> bool {
        self.onlooker.is_some_and(|leaves| leaves(time, &state[..self.states]))
    }

    /// The same, whose sensitivities are carried along.
    pub(crate) fn with_tangents(self, tangents: Option<Tangents<'a>>) -> Self {
        Self { tangents, ..self }
    }

    /// The same, whose steps are kept.
    pub(crate) fn logged(self, log: Option<&'a Log>) -> Self {
        Self { log, ..self }
    }

    /// Where steps are kept, if they are.
    pub(crate) fn log(&self) -> Option<&'a Log> {
        self.log
    }

    /// Sensitivities, if they are asked for.
    pub(crate) fn tangents(&self) -> Option<&Tangents<'a>> {
        self.tangents.as_ref()
    }

    /// Why the run is to end where it is, if it is.
    pub(super) fn interruption(&self) -> Option<StopCause> {
        self.patience.end(|| self.began.map_or(Duration::ZERO, |began| began.elapsed()))
    }

    /// The simulator, for methods that need more than rate and Jacobian.
    #[must_use]
    pub fn simulator(&self) -> &'a dyn Simulator<f64> {
        self.simulator
    }

    /// The constraints, if there are any.
    pub(crate) fn constraints(&self) -> Option<&Constraints<'a>> {
        self.constraints.as_ref()
    }

    /// Puts a state back onto the constraints, if there are any.
    pub(crate) fn constrain(&self, time: f64, state: &mut [f64]) -> Result<(), Stopped> {
        let Some(constraints) = &self.constraints else { return Ok(()) };
        constraints.project(time, state).map_err(|lost| {
            let constraint = constraints.name(lost.0).to_owned();
            Stopped { time, cause: StopCause::OffConstraint { constraint } }
        })
    }

    /// The parameters.
    #[must_use]
    pub fn parameters(&self) -> &'a [f64] {
        self.parameters
    }

    /// Number of equations.
    #[must_use]
    pub fn len(&self) -> usize {
        self.states() + if self.with_flows { FLOWS } else { 0 }
    }

    /// Whether there is nothing to integrate.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of states of the simulator, without quadratures.
    #[must_use]
    pub fn states(&self) -> usize {
        self.states
    }

    /// Name of the `index`-th equation's unknown.
    #[must_use]
    pub fn name(&self, index: usize) -> String {
        if index < self.states() {
            self.simulator.state(index).name.to_owned()
        } else {
            "energy flow".to_owned()
        }
    }

    /// f(t, y), `len` long.
    pub fn rate(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        let states = self.states();
        let (rate, flow_rates) = rate.split_at_mut(states);
        let state = &state[..states];
        self.state_rate(time, state, rate);
        if self.with_flows {
            flow_rates.copy_from_slice(&self.flow_rates(time, state));
        }
    }

    /// f(t, y) without the quadratures, `states` long.
    pub fn state_rate(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        self.count(|work| work.rate_evaluations += 1);
        self.simulator.prepared_rate(time, state, self.parameters, &self.constants, rate);
    }

    /// Nonzeros of df/dy without the rows of the quadratures.
    #[must_use]
    pub fn jacobian_pattern(&self) -> SparsityPattern<'a> {
        self.simulator.rate_jacobian_pattern()
    }

    /// df/dy without the rows of the quadratures, values in pattern order.
    pub fn jacobian(&self, time: f64, state: &[f64], values: &mut [f64]) {
        self.count(|work| work.jacobian_evaluations += 1);
        let state = &state[..self.states()];
        let (parameters, constants) = (self.parameters, &self.constants);
        self.simulator.prepared_rate_jacobian(time, state, parameters, constants, values);
    }

    /// df/dy, then df/dp, without the rows of the quadratures, values in pattern order.
    pub(crate) fn jacobians(&self, time: f64, state: &[f64], values: &mut [f64]) {
        self.count(|work| work.jacobian_evaluations += 1);
        let state = &state[..self.states()];
        let (parameters, constants) = (self.parameters, &self.constants);
        self.simulator.prepared_jacobians(time, state, parameters, constants, values);
    }

    /// The rows of df/dy that belong to the quadratures, as `(column, entries)`;
    /// nothing if there are none.
    ///
    /// By forward differences: with rows of zeros Newton's iteration sees the
    /// power one iterate late, takes that for slow convergence, and cuts steps;
    /// with these it converges as without quadratures, and what it converges to
    /// does not depend on them.
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

    /// Partial derivative of f with respect to time, without quadratures.
    pub fn time_derivative(&self, time: f64, state: &[f64], derivative: &mut [f64]) {
        let states = self.states();
        let (state, derivative) = (&state[..states], &mut derivative[..states]);
        let (parameters, constants) = (self.parameters, &self.constants);
        self.simulator.prepared_time_derivative(time, state, parameters, constants, derivative);
    }

    /// Tells the user something of how the run went; what has been said already,
    /// or too much, is left out.
    pub fn note(&self, note: String) {
        const MOST: usize = 100;
        let mut notes = self.notes.borrow_mut();
        if notes.len() < MOST && !notes.contains(&note) {
            notes.push(note);
        }
    }

    /// Forgets all notes but so many.
    pub(super) fn forget_notes(&self, but: usize) {
        self.notes.borrow_mut().truncate(but);
    }

    /// All that was noted.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        self.notes.borrow().clone()
    }

    /// Counts a step whose error was held below tolerances.
    pub fn count_step(&self) {
        self.has_stepped.set(true);
        self.count(|work| work.steps += 1);
    }

    /// Whether there was such a step: not where all was solved in closed form.
    #[must_use]
    pub fn has_stepped(&self) -> bool {
        self.has_stepped.get()
    }

    /// The mean of many steps, of which the last ended at `time` \[s\]; once in as many. Nothing of a
    /// run that others may leave before its end, which need not be meant to be reached.
    pub(super) fn pace(&self, time: f64) -> Option<f64> {
        if self.patience.is_limited() || self.onlooker.is_some() {
            return None;
        }
        let mut milestone = self.milestone.get();
        let pace = milestone.pace(self.work().steps, time);
        self.milestone.set(milestone);
        pace
    }

    /// Begins or ends to try loose steps; gives what was tried.
    pub(super) fn tries(&self, trial: Option<Trial>) -> Option<Trial> {
        self.trial.replace(trial)
    }

    /// What is tried with loose steps, if that is so.
    #[cfg(feature = "implicit")]
    pub(super) fn trial(&self) -> Option<Trial> {
        self.trial.get()
    }

    /// Whether loose steps are too many until a time.
    pub(super) fn is_over_at(&self, time: f64) -> bool {
        let Some(mut trial) = self.trial.get() else { return false };
        let is_over = trial.is_over_at(self.work().steps, time);
        self.trial.set(Some(trial));
        is_over
    }

    /// Adds to the work counted.
    pub fn count(&self, add: impl FnOnce(&mut Work)) {
        let mut work = self.work.get();
        add(&mut work);
        self.work.set(work);
    }

    /// The work counted so far.
    #[must_use]
    pub fn work(&self) -> Work {
        self.work.get()
    }

    /// Rates of the quadratures.
    #[must_use]
    pub fn flow_rates(&self, time: f64, state: &[f64]) -> [f64; FLOWS] {
        let power = self.simulator.power_balance(time, state, self.parameters);
        let passed = power.supplied.abs() + power.dissipated.abs();
        [power.supplied, power.dissipated, passed]
    }
}
