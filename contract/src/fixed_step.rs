//! Steps of a fixed length, for real time: no allocation, no iteration without a bound, the same
//! operations at every step in which no event happens.
//!
//! Emitted C99 takes the same steps with the same operations in the same order.
//!
//! - [`FixedMethod`]: Heun (order 2), Runge-Kutta (order 4), and a linearly implicit Rosenbrock
//!   method (order 2, L-stable).
//! - Guards are looked at once a step. Where one passes zero, the root of the cubic through its
//!   values and rates at both ends of the step says when; a shorter step leads there, new values
//!   are given, and what is left of the step follows.
//! - Constraints are met again after each step by one step of Newton's method for positions and
//!   one for velocities.
//!
//! Times at which the rate jumps, and kinks, are passed over: there the error of a step is of the
//! order of its length.

mod events;
mod projection;

use crate::elimination::Elimination;
use crate::{Real, Simulator};
use projection::Projection;

/// A number that steps of a fixed length are taken in.
pub trait StepNumber: Real + PartialOrd {
    /// Half the distance of one to the next number, doubled: the machine epsilon.
    const EPSILON: f64;
    /// Binary digits of a number.
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

/// How a step is taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FixedMethod<'a> {
    /// Heun's method, of order 2: two rates.
    Heun,
    /// The classical Runge-Kutta method, of order 4: four rates.
    RungeKutta4,
    /// A Rosenbrock method of order 2 (ROS2 with `g = 1 - 1/sqrt 2`, L-stable): two rates, one
    /// Jacobian, one elimination with two right sides.
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

/// `1 - 1/sqrt 2`.
pub const ROSENBROCK_GAMMA: f64 = 1.0 - core::f64::consts::FRAC_1_SQRT_2;

/// What runs by steps of a fixed length.
pub struct FixedSteps<'a, R: Real> {
    /// The machine.
    pub simulator: &'a dyn Simulator<R>,
    /// Its parameters.
    pub parameters: &'a [R],
    /// What [`Simulator::prepare`] gives for them.
    pub constants: &'a [R],
    /// How a step is taken.
    pub method: FixedMethod<'a>,
    /// Largest number of times at which events happen within a step.
    pub events_a_step: usize,
}

/// Numbers and signs that steps are computed in, as many as [`FixedSteps::room`] says.
pub struct Room<'w, R> {
    /// Numbers.
    pub numbers: &'w mut [R],
    /// Signs; the first, one for each event, are the sides on which guards are, and are kept from
    /// step to step.
    pub signs: &'w mut [i8],
}

/// How a step ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stepped {
    /// After so many events.
    Events(usize),
    /// There were more events than may be in a step; the next step goes on with them.
    TooManyEvents,
}

/// Takes so many numbers from the front of what is left.
fn take<'w, T>(rest: &mut &'w mut [T], count: usize) -> &'w mut [T] {
    let (taken, left) = core::mem::take(rest).split_at_mut(count);
    *rest = left;
    taken
}

/// Where one step is computed.
struct Scratch<'w, R> {
    slope: &'w mut [R],
    sum: &'w mut [R],
    stage: &'w mut [R],
    jacobian: &'w mut [R],
    factors: &'w mut [R],
    projection: Projection<'w, R>,
}

/// `out = state + h slope`.
#[inline]
fn ahead<R: Real>(out: &mut [R], state: &[R], h: R, slope: &[R]) {
    for ((out, &state), &slope) in out.iter_mut().zip(state).zip(slope) {
        *out = state + h * slope;
    }
}

/// `sum = sum + h slope`.
#[inline]
fn add<R: Real>(sum: &mut [R], h: R, slope: &[R]) {
    for (sum, &slope) in sum.iter_mut().zip(slope) {
        *sum = *sum + h * slope;
    }
}

impl<R: StepNumber> FixedSteps<'_, R> {
    /// How many numbers and signs [`Room`] must have.
    #[must_use]
    pub fn room(&self) -> [usize; 2] {
        let states = self.simulator.shape().states();
        let events = self.simulator.events();
        let numbers = self.scratch_room() + 2 * states + 6 * events + self.resets();
        [numbers, 3 * events]
    }

    fn scratch_room(&self) -> usize {
        let states = self.simulator.shape().states();
        let [jacobian, places] = self.implicit_room();
        3 * states + jacobian + places + Projection::<R>::room(self.simulator)
    }

    /// Numbers of a Jacobian and of its factors.
    fn implicit_room(&self) -> [usize; 2] {
        match &self.method {
            FixedMethod::Rosenbrock2(of) => {
                [self.simulator.rate_jacobian_pattern().entries.len(), of.places]
            }
            FixedMethod::Heun | FixedMethod::RungeKutta4 => [0, 0],
        }
    }

    fn scratch<'w>(&self, rest: &mut &'w mut [R]) -> Scratch<'w, R> {
        let states = self.simulator.shape().states();
        let [jacobian, places] = self.implicit_room();
        Scratch {
            slope: take(rest, states),
            sum: take(rest, states),
            stage: take(rest, states),
            jacobian: take(rest, jacobian),
            factors: take(rest, places),
            projection: Projection::new(self.simulator, rest),
        }
    }

    /// Advances a state by a step, with the events that happen within it.
    ///
    /// # Panics
    /// If there is less room than [`FixedSteps::room`] says, or the state has another length than
    /// the machine's.
    pub fn step(&self, time: R, step: R, state: &mut [R], room: &mut Room<'_, R>) -> Stepped {
        if self.simulator.events() > 0 {
            return self.step_with_events(time, step, state, room);
        }
        let mut rest = &mut *room.numbers;
        let mut scratch = self.scratch(&mut rest);
        let end = take(&mut rest, state.len());
        self.advance(time, step, state, end, &mut scratch);
        state.copy_from_slice(end);
        Stepped::Events(0)
    }

    fn rate(&self, time: R, state: &[R], rate: &mut [R]) {
        self.simulator.prepared_rate(time, state, self.parameters, self.constants, rate);
    }

    /// One step without a look at events, onto the constraints.
    fn advance(&self, time: R, h: R, state: &[R], end: &mut [R], scratch: &mut Scratch<'_, R>) {
        match &self.method {
            FixedMethod::Heun => self.heun(time, h, state, end, scratch),
            FixedMethod::RungeKutta4 => self.runge_kutta(time, h, state, end, scratch),
            FixedMethod::Rosenbrock2(of) => self.rosenbrock(of, (time, h), state, end, scratch),
        }
        self.project(time + h, end, scratch);
    }

    /// Puts a state back onto the constraints, if there are any.
    fn project(&self, time: R, state: &mut [R], scratch: &mut Scratch<'_, R>) {
        if self.simulator.constraints() > 0 {
            scratch.projection.project(self, time, state);
        }
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
        let (simulator, parameters, constants) =
            (self.simulator, self.parameters, self.constants);
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
        // The Jacobian has been used: its place is too short in general, so k1 stays in `slope`
        // and the second right side is made of it.
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
