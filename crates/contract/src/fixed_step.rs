//! Fixed-step integration for real time: no allocation, no unbounded iteration, and the same
//! operations in every step without events.
//!
//! Emitted C99 takes the same steps with the same operations in the same order.
//!
//! - [`FixedMethod`]: Heun (order 2), Runge-Kutta (order 4), and a linearly implicit Rosenbrock
//!   method (order 2, L-stable).
//! - Guards are evaluated once a step. If one crosses zero, its time is the root of the cubic
//!   through the guard's values and rates at both ends of the step. A shorter step ends there,
//!   the event resets the state, and the rest of the step follows.
//! - Constraints are fulfilled again after each step by one step of Newton's method for positions
//!   and one for velocities.
//! - Times at which the rate is discontinuous end parts of a step too.
//!
//! Switching surfaces are not located. There the error of a step is of second order in its
//! length.
//!
//! [`ExtendedKalmanFilter`] estimates the state from measurements by these steps and their exact
//! derivatives.

mod carried;
mod ekf;
mod events;
mod follow;
mod projection;

use crate::elimination::Elimination;
use crate::{Constraint, Jumps, Real, Simulator};
pub use ekf::{Correction, ExtendedKalmanFilter, FilterMemory, FilterSizes};
use follow::{Follow, Nobody};
use projection::Projection;

/// Number type of fixed-step integration.
pub trait StepNumber: Real + PartialOrd {
    /// Distance from one to the next number.
    const EPSILON: f64;
    /// Number of binary digits.
    const DIGITS: u32;
}

impl StepNumber for f64 {
    const EPSILON: f64 = f64::EPSILON;
    const DIGITS: u32 = f64::MANTISSA_DIGITS;
}

impl StepNumber for f32 {
    const EPSILON: f64 = f32::EPSILON as f64;
    const DIGITS: u32 = f32::MANTISSA_DIGITS;
}

/// Method of a step, with its data for a machine.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum FixedMethod<'a> {
    /// Heun's method, of order 2: two evaluations of the rate.
    Heun,
    /// The classical Runge-Kutta method, of order 4: four evaluations of the rate.
    #[default]
    RungeKutta4,
    /// A Rosenbrock method of order 2 (ROS2 with `g = 1 - 1/sqrt 2`, L-stable). It takes two
    /// rates, one Jacobian, and one elimination with two right sides.
    ///
    /// ```text
    /// (I - g h J) k1 = f(t, y) + g h f_t
    /// (I - g h J) k2 = f(t + h, y + h k1) - 2 k1 - g h f_t
    /// y' = y + 3/2 h k1 + 1/2 h k2
    /// ```
    ///
    /// Source: Verwer, Spee, Blom, Hundsdorfer: A second-order Rosenbrock method applied to
    /// photochemical dispersion problems. SIAM J. Sci. Comput. 20 (1999) 1456.
    Rosenbrock2(Elimination<'a>),
}

/// Name of a method, before the pattern of a machine is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum StepMethod {
    /// [`FixedMethod::RungeKutta4`].
    #[default]
    RungeKutta4,
    /// [`FixedMethod::Heun`].
    Heun,
    /// [`FixedMethod::Rosenbrock2`], for stiff machines.
    Rosenbrock2,
}

impl StepMethod {
    /// All methods.
    pub const ALL: [Self; 3] = [Self::RungeKutta4, Self::Heun, Self::Rosenbrock2];

    /// Returns the method, if it needs nothing of the machine.
    #[must_use]
    pub fn explicit(self) -> Option<FixedMethod<'static>> {
        match self {
            Self::RungeKutta4 => Some(FixedMethod::RungeKutta4),
            Self::Heun => Some(FixedMethod::Heun),
            Self::Rosenbrock2 => None,
        }
    }

    /// Returns its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::RungeKutta4 => "rk4",
            Self::Heun => "heun",
            Self::Rosenbrock2 => "ros2",
        }
    }

    /// Returns its description, as part of a sentence.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::RungeKutta4 => "the classical Runge-Kutta method of order 4",
            Self::Heun => "Heun's method of order 2",
            Self::Rosenbrock2 => "a linearly implicit Rosenbrock method of order 2",
        }
    }

    /// Returns the method for a machine, given the elimination for its `I - g h J`.
    #[must_use]
    pub fn with(self, elimination: Elimination<'_>) -> FixedMethod<'_> {
        match self {
            Self::RungeKutta4 => FixedMethod::RungeKutta4,
            Self::Heun => FixedMethod::Heun,
            Self::Rosenbrock2 => FixedMethod::Rosenbrock2(elimination),
        }
    }
}

/// `1 - 1/sqrt 2`.
pub const ROSENBROCK_GAMMA: f64 = 1.0 - core::f64::consts::FRAC_1_SQRT_2;

/// A machine that runs by steps of fixed length.
pub struct FixedSteps<'a, R: Real> {
    /// The machine.
    pub simulator: &'a dyn Simulator<R>,
    /// Its parameters.
    pub parameters: &'a [R],
    /// Result of [`Simulator::prepare`] for them.
    pub constants: &'a [R],
    /// Method of the steps.
    pub method: FixedMethod<'a>,
    /// Largest number of parts of a step. Events and times at which the rate is discontinuous end
    /// a part.
    pub parts_a_step: usize,
}

/// Workspace for numbers and signs, of the sizes that [`FixedSteps::room`] returns.
pub struct Room<'w, R> {
    /// Numbers.
    pub numbers: &'w mut [R],
    /// Signs. The first ones, one for each event, are the signs of the guards; they are kept from
    /// step to step.
    pub signs: &'w mut [i8],
}

/// Outcome of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stepped {
    /// The step ended after this number of events.
    Events(usize),
    /// The limit of parts was reached. Later zero crossings are handled in the next step.
    TooManyParts,
}

/// Rest of a slice that is divided into parts.
struct Rest<'w, T>(&'w mut [T]);

impl<'w, T> Rest<'w, T> {
    /// Takes `count` elements from the front.
    fn take(&mut self, count: usize) -> &'w mut [T] {
        let (taken, left) = core::mem::take(&mut self.0).split_at_mut(count);
        self.0 = left;
        taken
    }
}

/// The time of a run by steps, with compensated summation: the rounding error of each sum is
/// added to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock<R> {
    time: R,
    rest: R,
}

impl<R: Real> Clock<R> {
    /// Returns a clock at the given time.
    #[must_use]
    pub fn new(time: R) -> Self {
        Self { time, rest: R::literal(0.0) }
    }

    /// Returns the time.
    #[must_use]
    pub fn time(&self) -> R {
        self.time
    }

    /// Adds a step.
    pub fn pass(&mut self, step: R) {
        let whole = step + self.rest;
        let before = self.time;
        self.time = before + whole;
        self.rest = whole - (self.time - before);
    }
}

/// Scratch space of one step.
struct Scratch<'w, R> {
    slope: &'w mut [R],
    sum: &'w mut [R],
    stage: &'w mut [R],
    jacobian: &'w mut [R],
    factors: &'w mut [R],
    projection: Projection<'w, R>,
}

/// Returns the length until just before a discontinuity, where the rate still has its old value.
fn before_jump<R: StepNumber>(now: R, left: R, jump: R) -> R {
    let zero = R::literal(0.0);
    let length = (jump - R::literal(R::EPSILON) * (jump.abs() + left)) - now;
    if zero < length { length } else { zero }
}

/// Computes `out = state + h slope`.
#[inline]
fn ahead<R: Real>(out: &mut [R], state: &[R], h: R, slope: &[R]) {
    for ((out, &state), &slope) in out.iter_mut().zip(state).zip(slope) {
        *out = state + h * slope;
    }
}

/// Computes `sum = sum + h slope`.
#[inline]
fn add<R: Real>(sum: &mut [R], h: R, slope: &[R]) {
    for (sum, &slope) in sum.iter_mut().zip(slope) {
        *sum = *sum + h * slope;
    }
}

impl<R: StepNumber> FixedSteps<'_, R> {
    /// Returns the numbers and signs that [`Room`] must have.
    #[must_use]
    pub fn room(&self) -> [usize; 2] {
        let states = self.simulator.shape().states();
        let events = self.simulator.events();
        let jumps = self.simulator.shape().discontinuities;
        let numbers = self.scratch_room() + 2 * states + 6 * events + self.resets() + jumps;
        [numbers, 3 * events]
    }

    fn scratch_room(&self) -> usize {
        let states = self.simulator.shape().states();
        let [jacobian, places] = self.implicit_room();
        3 * states + jacobian + places + Projection::<R>::room(self.simulator)
    }

    /// Returns the numbers of a Jacobian and of its factors.
    fn implicit_room(&self) -> [usize; 2] {
        match &self.method {
            FixedMethod::Rosenbrock2(of) => {
                [self.simulator.rate_jacobian_pattern().entries.len(), of.places]
            }
            FixedMethod::Heun | FixedMethod::RungeKutta4 => [0, 0],
        }
    }

    fn scratch<'w>(&self, rest: &mut Rest<'w, R>) -> Scratch<'w, R> {
        let states = self.simulator.shape().states();
        let [jacobian, places] = self.implicit_room();
        Scratch {
            slope: rest.take(states),
            sum: rest.take(states),
            stage: rest.take(states),
            jacobian: rest.take(jacobian),
            factors: rest.take(places),
            projection: Projection::new(self.simulator, rest),
        }
    }

    /// Advances a state by a step and handles the events within it.
    ///
    /// # Panics
    /// If there is less room than [`FixedSteps::room`] says, or the state has another length than
    /// the machine's.
    pub fn step(&self, time: R, step: R, state: &mut [R], room: &mut Room<'_, R>) -> Stepped {
        self.step_followed((time, step), state, room, &mut Nobody)
    }

    /// As [`FixedSteps::step`]; a follower is told the parts and events of the step.
    fn step_followed(
        &self,
        (time, step): (R, R),
        state: &mut [R],
        room: &mut Room<'_, R>,
        follower: &mut impl Follow<R>,
    ) -> Stepped {
        if self.simulator.events() > 0 {
            return self.step_with_events((time, step), state, room, follower);
        }
        let mut rest = Rest(room.numbers);
        let mut scratch = self.scratch(&mut rest);
        let end = rest.take(state.len());
        let count = self.simulator.shape().discontinuities;
        if count == 0 {
            self.advance(time, step, state, end, &mut scratch);
            follower.part(self, (time, step), state, end);
            state.copy_from_slice(end);
            return Stepped::Events(0);
        }
        let jumps = rest.take(count);
        let (mut now, mut left) = (time, step);
        let mut stepped = Stepped::Events(0);
        for part in 1..=self.parts_a_step {
            if left <= R::literal(0.0) {
                break;
            }
            let mut jump = self.next_jump(now, now + left, jumps);
            if part == self.parts_a_step && jump.take().is_some() {
                stepped = Stepped::TooManyParts;
            }
            let length = jump.map_or(left, |jump| before_jump(now, left, jump));
            if R::literal(0.0) < length {
                self.advance(now, length, state, end, &mut scratch);
                follower.part(self, (now, length), state, end);
                state.copy_from_slice(end);
            }
            let Some(jump) = jump else { break };
            left = left - (jump - now);
            now = jump;
        }
        stepped
    }

    /// Returns the friction whose speed jumps at places, if there is any: fixed steps evaluate
    /// relations as they are, so they find such a place only after the speed has jumped.
    #[must_use]
    pub fn unsuitable(simulator: &dyn Simulator<R>) -> Option<Constraint<'_>> {
        let mut all = (0..simulator.constraints()).map(|index| simulator.constraint(index));
        all.find(|constraint| constraint.jumps == Jumps::AtPlaces)
    }

    /// Returns a sufficient number of parts for steps with each event once and one discontinuity
    /// of the rate.
    #[must_use]
    pub fn enough_parts(simulator: &dyn Simulator<R>) -> usize {
        simulator.events() + usize::from(simulator.shape().discontinuities > 0) + 1
    }

    /// Returns the first discontinuity of the rate after `now` and up to `until`.
    fn next_jump(&self, now: R, until: R, times: &mut [R]) -> Option<R> {
        self.simulator.discontinuities(self.parameters, times);
        let mut first = None;
        for &time in times.iter() {
            if now < time && time <= first.unwrap_or(until) {
                first = Some(time);
            }
        }
        first
    }

    fn rate(&self, time: R, state: &[R], rate: &mut [R]) {
        self.simulator.prepared_rate(time, state, self.parameters, self.constants, rate);
    }

    /// Takes one step without events and projects the result onto the constraints.
    fn advance(&self, time: R, h: R, state: &[R], end: &mut [R], scratch: &mut Scratch<'_, R>) {
        match &self.method {
            FixedMethod::Heun => self.heun(time, h, state, end, scratch),
            FixedMethod::RungeKutta4 => self.runge_kutta(time, h, state, end, scratch),
            FixedMethod::Rosenbrock2(of) => self.rosenbrock(of, (time, h), state, end, scratch),
        }
        self.project(time + h, end, scratch);
    }

    /// Projects a state onto the constraints, if there are any.
    fn project(&self, time: R, state: &mut [R], scratch: &mut Scratch<'_, R>) {
        if self.simulator.constraints() > 0 {
            scratch.projection.project(self, time, state);
        }
    }

    /// Puts a state that was changed by hand onto the constraints, then settles it as
    /// [`FixedSteps::settle`].
    ///
    /// # Panics
    /// As [`FixedSteps::step`].
    pub fn restore_and_settle(&self, time: R, state: &mut [R], room: &mut Room<'_, R>) {
        self.restore((time, state), room, &mut Nobody);
        self.settle(time, state, room);
    }

    /// Projects a state that was changed onto the constraints. A follower is told.
    fn restore(
        &self,
        (time, state): (R, &mut [R]),
        room: &mut Room<'_, R>,
        follower: &mut impl Follow<R>,
    ) {
        let mut scratch = self.scratch(&mut Rest(room.numbers));
        self.project(time, state, &mut scratch);
        follower.projected(self, time, state);
    }

    fn heun(&self, time: R, h: R, state: &[R], end: &mut [R], scratch: &mut Scratch<'_, R>) {
        let Scratch { slope, sum, stage, .. } = scratch;
        self.rate(time, state, slope);
        sum.copy_from_slice(slope);
        ahead(stage, state, h, slope);
        self.rate(time + h, stage, slope);
        add(sum, R::literal(1.0), slope);
        ahead(end, state, R::literal(0.5) * h, sum);
    }

    fn runge_kutta(&self, time: R, h: R, state: &[R], end: &mut [R], scratch: &mut Scratch<'_, R>) {
        let Scratch { slope, sum, stage, .. } = scratch;
        let (half, two) = (R::literal(0.5) * h, R::literal(2.0));
        self.rate(time, state, slope);
        sum.copy_from_slice(slope);
        ahead(stage, state, half, slope);
        self.rate(time + half, stage, slope);
        add(sum, two, slope);
        ahead(stage, state, half, slope);
        self.rate(time + half, stage, slope);
        add(sum, two, slope);
        ahead(stage, state, h, slope);
        self.rate(time + h, stage, slope);
        add(sum, R::literal(1.0), slope);
        ahead(end, state, h / R::literal(6.0), sum);
    }

    fn rosenbrock(
        &self,
        of: &Elimination<'_>,
        (time, h): (R, R),
        state: &[R],
        end: &mut [R],
        scratch: &mut Scratch<'_, R>,
    ) {
        let Scratch { slope, sum, stage, jacobian, factors, .. } = scratch;
        let (simulator, parameters, constants) = (self.simulator, self.parameters, self.constants);
        let scale = R::literal(ROSENBROCK_GAMMA) * h;
        simulator.prepared_rate_jacobian(time, state, parameters, constants, jacobian);
        of.factor(scale, jacobian, factors);
        // The sum holds f_t until it is needed for the step.
        simulator.time_derivative(time, state, parameters, sum);
        self.rate(time, state, slope);
        add(slope, scale, sum);
        of.solve(factors, slope);
        ahead(stage, state, h, slope);
        ahead(end, state, R::literal(1.5) * h, slope);
        // The second right side overwrites k1 and the time derivative.
        for (first, by_time) in slope.iter_mut().zip(sum.iter()) {
            *first = -(R::literal(2.0) * *first) - scale * *by_time;
        }
        self.rate(time + h, stage, sum);
        for (right_side, &first) in sum.iter_mut().zip(slope.iter()) {
            *right_side = *right_side + first;
        }
        of.solve(factors, sum);
        add(end, R::literal(0.5) * h, sum);
    }
}
