//! Sensitivities along a run: S = dy/dp, carried with the states.
//!
//! Between events they follow the variational equations
//!
//! ```text
//! S' = J S + df/dp,   J = df/dy        S(from) = dy_0/dp
//! ```
//!
//! which a method solves with its own stages, so that S is the derivative of what the method
//! computes at its steps. At an event, whose time moves with p, they jump; see [`instant`].
//! Everything that is not in dy'/dy and dy'/dp is differentiated on dual numbers: the start,
//! outputs, guards, resets, times of jumps, constraints.
//!
//! An entry of S is at `state * directions + direction`.

mod allowed;
mod columns;
mod equations;
mod instant;
mod sliding;
mod start;

use std::cell::{Cell, OnceCell, RefCell};
use std::ops::Range;

use machinist_contract::{Derivatives, Describe, Dual, DualFunction, Simulator};

use crate::constraints::{Constraints, Level};
use crate::error::{SimulateError, did_you_mean};
use crate::method::one_step::first_not_finite;
use crate::method::vectors::widest;
use crate::method::{Held, Method, OneStep, Samples, Stopped, Stretch, Trial};
use allowed::Allowed;
use equations::Product;
use instant::Instant;

pub(crate) use columns::columns;
pub(crate) use equations::Equations;
pub(crate) use instant::Passing;
pub(crate) use start::Start;

/// Quantity to differentiate by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum By {
    /// A parameter.
    Parameter(usize),
    /// The initial value of a state.
    Initial(usize),
}

impl By {
    /// Returns the parameter of a name, or else the state.
    pub(crate) fn named(simulator: &dyn Simulator<f64>, name: &str) -> Result<Self, SimulateError> {
        let shape = simulator.shape();
        let parameters = || (0..shape.parameters).map(|index| simulator.parameter(index).name);
        let states = || (0..shape.states()).map(|index| simulator.state(index).name);
        if let Some(index) = parameters().position(|known| known == name) {
            return Ok(Self::Parameter(index));
        }
        match states().position(|known| known == name) {
            Some(index) if simulator.is_mode(index) => Err(SimulateError::NotDifferentiable {
                name: name.to_owned(),
                why: "is a mode, whose values are whole numbers".to_owned(),
            }),
            Some(index) => Ok(Self::Initial(index)),
            None if simulator.is_unused(name) => Err(SimulateError::UnusedParameter {
                scene: simulator.name().to_owned(),
                name: name.to_owned(),
            }),
            None => Err(SimulateError::UnknownDirection {
                scene: simulator.name().to_owned(),
                name: name.to_owned(),
                hint: did_you_mean(name, parameters().chain(states())),
            }),
        }
    }

    /// Returns its name and unit.
    pub(crate) fn quantity(self, simulator: &dyn Describe) -> machinist_contract::Quantity<'_> {
        match self {
            Self::Parameter(index) => simulator.parameter(index),
            Self::Initial(index) => simulator.state(index),
        }
    }
}

/// Derivatives of the state, carried along a run.
pub(crate) struct Tangents<'a> {
    simulator: &'a dyn Simulator<f64>,
    derivatives: &'a dyn Derivatives,
    parameters: &'a [f64],
    by: Vec<By>,
    states: usize,
    equations: Equations,
    /// The equations along surfaces, once the motion slides, and whether it does.
    full_equations: OnceCell<Equations>,
    is_sliding: Cell<bool>,
    /// Sizes of the quantities to differentiate by.
    sizes: Vec<f64>,
    is_controlled: bool,
    inner: RefCell<Inner>,
    allowed: RefCell<Option<Allowed>>,
    /// Parameters and slots of the run that carries them.
    held: RefCell<Option<Held>>,
    scratch: RefCell<Scratch>,
}

/// Buffers that are rewritten at every state.
struct Scratch {
    /// Values of dy'/dy and dy'/dp.
    jacobians: Vec<f64>,
    /// df/dp of the directions.
    drive: Vec<f64>,
}

struct Inner {
    /// S at the start of the current step.
    start: Vec<f64>,
    /// S at its end, once it was carried there.
    end: Vec<f64>,
    /// S at the requested times.
    rows: Vec<f64>,
    latest: Instant,
}

impl<'a> Tangents<'a> {
    /// Returns the tangents of a run that starts with S = `start`.
    ///
    /// # Errors
    /// [`SimulateError::NoDerivatives`] for a simulator without dual numbers.
    pub(crate) fn new(
        simulator: &'a dyn Simulator<f64>,
        parameters: &'a [f64],
        (by, is_controlled): (Vec<By>, bool),
        from: f64,
    ) -> Result<Self, SimulateError> {
        let scene = || simulator.name().to_owned();
        let derivatives = simulator
            .derivatives()
            .ok_or_else(|| SimulateError::NoDerivatives { scene: scene() })?;
        let (states, count) = (simulator.shape().states(), by.len());
        let parameter = |by: &By| match by {
            By::Parameter(index) => Some(*index),
            By::Initial(_) => None,
        };
        let patterns = (simulator.rate_jacobian_pattern(), simulator.parameter_jacobian_pattern());
        let directions: Vec<_> = by.iter().map(parameter).collect();
        let equations = Equations::new(patterns.0, patterns.1, &directions);
        let zeros = vec![0.0; states * count];
        let inner = Inner {
            start: zeros.clone(),
            end: zeros.clone(),
            rows: Vec::new(),
            latest: Instant { time: from, shifts: vec![0.0; count] },
        };
        let scratch = Scratch { jacobians: vec![0.0; equations.values()], drive: zeros };
        let inner = RefCell::new(inner);
        let size = |by: &By| match by {
            By::Parameter(index) if parameters[*index] != 0.0 => parameters[*index].abs(),
            By::Parameter(_) => 1.0,
            By::Initial(index) => simulator.state_scale(*index),
        };
        let sizes = by.iter().map(size).collect();
        Ok(Self {
            simulator,
            derivatives,
            parameters,
            by,
            states,
            equations,
            full_equations: OnceCell::new(),
            is_sliding: Cell::new(false),
            sizes,
            is_controlled,
            inner,
            allowed: RefCell::default(),
            held: RefCell::default(),
            scratch: RefCell::new(scratch),
        })
    }

    /// Returns the quantities to differentiate by.
    pub(crate) fn by(&self) -> &[By] {
        &self.by
    }

    /// Returns the number of entries of S.
    pub(crate) fn len(&self) -> usize {
        self.states * self.by.len()
    }

    /// Returns S at the start of the current step.
    pub(crate) fn start(&self) -> Vec<f64> {
        self.inner.borrow().start.clone()
    }

    /// Sets S at the start of the current step.
    pub(crate) fn restart(&self, tangents: &[f64]) {
        self.inner.borrow_mut().start.copy_from_slice(tangents);
    }

    /// Returns lambda^T S at the start of the current step, for every direction.
    pub(crate) fn pulled(&self, lambda: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.by.len()];
        let start = &self.inner.borrow().start;
        for (row, factor) in start.chunks_exact(self.by.len().max(1)).zip(lambda) {
            for (sum, value) in sums.iter_mut().zip(row) {
                *sum += factor * value;
            }
        }
        sums
    }

    /// Iterates over S of one direction, at the start of the current step.
    pub(crate) fn start_of(&self, direction: usize) -> impl Iterator<Item = f64> {
        let start = self.inner.borrow().start.clone();
        start.into_iter().skip(direction).step_by(self.by.len())
    }

    /// Takes S at the requested times so far, row after row.
    fn take_rows(&self) -> Vec<f64> {
        std::mem::take(&mut self.inner.borrow_mut().rows)
    }

    /// Returns the variational equations of the current stretch.
    pub(crate) fn equations(&self) -> &Equations {
        if self.is_sliding.get() {
            self.full_equations.get_or_init(|| sliding::full_equations(self.states, &self.by))
        } else {
            &self.equations
        }
    }

    /// Evaluates J and df/dp at a state of a stretch: the parts of S' = J S + df/dp that do not
    /// depend on S. `values` are [`Equations::values`] long and begin with J; df/dp has to be zero
    /// where no parameter is.
    pub(crate) fn linearize(
        &self,
        stretch: &Stretch<'_>,
        time: f64,
        state: &[f64],
        values: &mut [f64],
        drive: &mut [f64],
    ) {
        if self.is_sliding.get() {
            let time = stretch.within(time);
            self.linearize_along_surfaces(stretch.system, time, state, values);
            self.equations().drive(values, drive);
        } else if self.equations.are_driven() {
            stretch.system.jacobians(stretch.within(time), state, values);
            self.equations.drive(values, drive);
        } else {
            stretch.jacobian(time, state, values);
        }
    }

    /// Evaluates J S + df/dp at a state of a stretch.
    pub(crate) fn rate(
        &self,
        stretch: &Stretch<'_>,
        time: f64,
        state: &[f64],
        tangents: &[f64],
        into: &mut [f64],
    ) {
        let Scratch { jacobians, drive } = &mut *self.scratch.borrow_mut();
        self.linearize(stretch, time, state, jacobians, drive);
        let of = (&jacobians[..], &drive[..]);
        widest(Product { equations: self.equations(), of, tangents, into });
    }

    /// Visits the entries of dy'/dy at the last evaluation of [`Tangents::rate`]: row, column,
    /// value.
    #[cfg(feature = "implicit")]
    pub(crate) fn for_each_slope(&self, mut look: impl FnMut(usize, usize, f64)) {
        let jacobians = &self.scratch.borrow().jacobians;
        let entries = self.simulator.rate_jacobian_pattern().entries;
        for ((row, column), value) in entries.iter().zip(jacobians) {
            look(*row as usize, *column as usize, *value);
        }
    }

    /// Carries S over the current step of a method, whose states have this error; returns the
    /// result for both.
    pub(crate) fn carry(&self, method: &mut dyn OneStep, of_states: f64) -> Trial {
        let Inner { start, end, .. } = &mut *self.inner.borrow_mut();
        let error = method.carry(self, start, end);
        match first_not_finite(end) {
            Some(place) => {
                let index = place / self.by.len();
                Trial::NotFinite { what: "a sensitivity of", index }
            }
            None if self.is_controlled && error.is_nan() => Trial::Error(f64::INFINITY),
            None if self.is_controlled => Trial::Error(error.max(of_states)),
            None => Trial::Error(of_states),
        }
    }

    /// Returns the errors of S over the tolerances, the largest of all directions, for several
    /// estimates evaluated one after another; see [`Allowed`].
    pub(crate) fn errors(
        &self,
        stretch: &Stretch<'_>,
        ends: (&[f64], &[f64]),
        of: impl FnOnce(&mut dyn FnMut(&[f64]) -> f64) -> f64,
    ) -> f64 {
        let mut allowed = self.allowed.borrow_mut();
        let states = &stretch.atol[..self.states];
        let allowed = allowed.get_or_insert_with(|| Allowed::new(states, &self.sizes));
        allowed.set(stretch.rtol, ends);
        of(&mut |errors| allowed.norm(errors))
    }

    /// Returns whether the error of S is controlled.
    pub(crate) fn is_controlled(&self) -> bool {
        self.is_controlled
    }

    fn require_finite(
        &self,
        stretch: &Stretch<'_>,
        time: f64,
        tangents: &[f64],
    ) -> Result<(), Stopped> {
        match first_not_finite(tangents) {
            None => Ok(()),
            Some(place) => Err(stretch.not_finite("a sensitivity of", place / self.by.len(), time)),
        }
    }

    /// Projects S at the end of the current step onto the tangent space of the constraints.
    pub(crate) fn constrain_end(&self, stretch: &Stretch<'_>, time: f64, state: &[f64]) {
        let end = &mut self.inner.borrow_mut().end;
        self.constrain(stretch.system.constraints(), stretch.within(time), state, end);
    }

    /// Accepts the current step: its end becomes the start of the next one.
    pub(crate) fn accept(&self) {
        let inner = &mut *self.inner.borrow_mut();
        if let Some(allowed) = &mut *self.allowed.borrow_mut() {
            allowed.keep(&inner.end);
        }
        std::mem::swap(&mut inner.start, &mut inner.end);
    }

    /// Takes S at a requested time within the current step, where the state is `state`.
    pub(crate) fn sample(
        &self,
        method: &mut dyn OneStep,
        stretch: &Stretch<'_>,
        time: f64,
        state: &[f64],
    ) {
        let Inner { start, rows, .. } = &mut *self.inner.borrow_mut();
        let first = rows.len();
        rows.resize(first + self.len(), 0.0);
        let row = &mut rows[first..];
        method.tangents_at(self, time, start, row);
        self.constrain(stretch.system.constraints(), stretch.within(time), state, row);
    }

    /// Takes S at a requested time at the end of the current step.
    pub(crate) fn sample_end(&self) {
        let Inner { end, rows, .. } = &mut *self.inner.borrow_mut();
        rows.extend_from_slice(end);
    }

    /// Takes S at all requested times up to the start of the next step.
    pub(crate) fn sample_start(&self, samples: &Samples<'_>, until: f64) {
        let Inner { start, rows, .. } = &mut *self.inner.borrow_mut();
        let wanted = samples.due(until);
        (0..wanted).for_each(|_| rows.extend_from_slice(start));
    }

    /// Takes one Euler step, exact to rounding where it is short to rounding.
    pub(crate) fn euler_step(&self, stretch: &Stretch<'_>, state: &[f64]) {
        let start = &mut self.inner.borrow_mut().start;
        let mut rate = vec![0.0; start.len()];
        self.rate(stretch, stretch.from, state, start, &mut rate);
        for (value, rate) in start.iter_mut().zip(&rate) {
            *value += (stretch.until - stretch.from) * rate;
        }
    }

    /// Returns the ranges of directions that are evaluated side by side.
    fn chunks(&self) -> impl Iterator<Item = Range<usize>> + use<> {
        let count = self.by.len();
        (0..count).step_by(Dual::DIRECTIONS).map(move |k| k..(k + Dual::DIRECTIONS).min(count))
    }

    /// Uses relations as a run holds them.
    pub(crate) fn hold(&self, held: &Held) {
        self.held.replace(Some(held.clone()));
    }

    /// Returns parameters with slopes along some directions, followed by slots if relations are
    /// held.
    fn parameters_along(&self, directions: &Range<usize>) -> Vec<Dual> {
        let held = self.held.borrow();
        let held = held.as_ref().map(Held::all);
        self.along(held.as_deref().unwrap_or(self.parameters), directions)
    }

    /// Returns parameters with slopes along some directions, and live relations.
    fn live_parameters_along(&self, directions: &Range<usize>) -> Vec<Dual> {
        self.along(self.parameters, directions)
    }

    fn along(&self, all: &[f64], directions: &Range<usize>) -> Vec<Dual> {
        let mut duals: Vec<Dual> = all.iter().copied().map(Dual::constant).collect();
        for (lane, direction) in directions.clone().enumerate() {
            if let By::Parameter(index) = self.by[direction] {
                duals[index].slopes[lane] = 1.0;
            }
        }
        duals
    }

    /// Sets `duals` to a state with slopes S along some directions.
    fn set_along(
        &self,
        state: &[f64],
        tangents: &[f64],
        directions: &Range<usize>,
        duals: &mut [Dual],
    ) {
        let rows = tangents.chunks_exact(self.by.len());
        for ((dual, value), row) in duals.iter_mut().zip(state).zip(rows) {
            let along = &row[directions.clone()];
            // One by one, because a call for so few entries costs more.
            let slopes = std::array::from_fn(|lane| along.get(lane).copied().unwrap_or(0.0));
            *dual = Dual { value: *value, slopes };
        }
    }

    /// Returns a state with slopes S along some directions.
    fn state_along(&self, state: &[f64], tangents: &[f64], directions: &Range<usize>) -> Vec<Dual> {
        let mut duals = vec![Dual::constant(0.0); self.states];
        self.set_along(state, tangents, directions, &mut duals);
        duals
    }

    /// Returns the slopes of a function in every direction, one row per value.
    fn slopes(
        &self,
        function: DualFunction,
        values: usize,
        time: f64,
        state: &[f64],
        tangents: &[f64],
    ) -> Vec<Vec<f64>> {
        let mut slopes = vec![Vec::with_capacity(self.by.len()); values];
        let mut results = vec![Dual::constant(0.0); values];
        for directions in self.chunks() {
            let parameters = self.parameters_along(&directions);
            let state = self.state_along(state, tangents, &directions);
            let time = Dual::constant(time);
            self.derivatives.on_duals(function, time, &state, &parameters, &mut results);
            for (slopes, result) in slopes.iter_mut().zip(&results) {
                slopes.extend_from_slice(&result.slopes[..directions.len()]);
            }
        }
        slopes
    }

    /// Shifts S the shortest way to where constraints hold to first order, as the projection of a
    /// state does to its derivatives.
    fn constrain(
        &self,
        constraints: Option<&Constraints<'_>>,
        time: f64,
        state: &[f64],
        tangents: &mut [f64],
    ) {
        let Some(constraints) = constraints else { return };
        let count = self.by.len();
        let rows = self.simulator.constraints();
        for (function, level) in [
            (DualFunction::ConstraintValues, Level::Positions),
            (DualFunction::ConstraintRates, Level::Velocities),
        ] {
            let slopes = self.slopes(function, rows, time, state, tangents);
            // Keep what cannot be solved; the state itself was projected with the same matrix.
            let Some(shift) = constraints.shortest_each(time, state, &slopes) else { continue };
            let first = constraints.first(level);
            for (direction, shift) in shift.column_iter().enumerate() {
                let shift = shift.into_owned();
                let moves = match level {
                    Level::Positions => constraints.moves(time, state, &shift),
                    Level::Velocities => shift.as_slice().to_vec(),
                };
                for (index, moved) in moves.into_iter().enumerate() {
                    tangents[(first + index) * count + direction] -= moved;
                }
            }
        }
    }
}

impl Method {
    /// Returns whether the method carries sensitivities with the states.
    #[must_use]
    pub fn carries_sensitivities(self) -> bool {
        matches!(self, Self::Tsit5 | Self::Dop853 | Self::Radau | Self::Auto | Self::Exact)
    }

    /// Returns the method for a run with sensitivities, if it was left to the scene or to `auto`.
    pub(crate) fn for_sensitivities(self) -> Self {
        match self {
            carries if carries.carries_sensitivities() => self,
            _ if Self::Auto.is_compiled_in() => Self::Auto,
            _ => Self::Dop853,
        }
    }
}
