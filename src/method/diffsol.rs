//! Methods of the crate diffsol, on dense nalgebra matrices.

use std::cell::{Cell, RefCell};

use ::diffsol::error::OdeSolverError;
use ::diffsol::{
    ConstantOp, DiffsolError, InitialConditionSolverOptions, Matrix, NalgebraContext, NalgebraLU,
    NalgebraMat, NalgebraVec, NonLinearOp, NonLinearOpJacobian, OdeEquations, OdeEquationsRef,
    OdeSolverMethod, OdeSolverOptions, OdeSolverProblem, OdeSolverState, OdeSolverStopReason, Op,
    Sdirk, Tableau, UnitCallable, Vector, VectorCommon,
};

use super::{Integrator, Samples, Sealed, Stopped, Stretch};
use crate::error::StopCause;

type M = NalgebraMat<f64>;
type V = NalgebraVec<f64>;
type Solver = NalgebraLU<f64>;

/// Replacement for a rate that is not finite. It is so large that the step is rejected and
/// shortened, but its square is still finite, so that no NaN arises inside the solver.
const REPELLENT: f64 = 1e100;

/// Backward differentiation formulas; `OdeSolverProblem::bdf`.
pub(super) struct Bdf;
/// `Tableau::tr_bdf2`.
pub(super) struct TrBdf2;
/// `Tableau::esdirk34`.
pub(super) struct Esdirk34;
/// `Tableau::tsit45`.
pub(super) struct Tsit45;

impl Sealed for Bdf {}

impl Integrator for Bdf {
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        require_small(stretch)?;
        let problem = problem(stretch, state);
        let start = problem.bdf_state::<Solver>().map(|start| with_sane_step(start, stretch));
        let solver = start.and_then(|start| problem.bdf_solver::<Solver>(start));
        advance(solver, |_| (), stretch, state, samples)
    }
}

impl Sealed for TrBdf2 {}

impl Integrator for TrBdf2 {
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        integrate_sdirk(Tableau::tr_bdf2, stretch, state, samples)
    }
}

impl Sealed for Esdirk34 {}

impl Integrator for Esdirk34 {
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        integrate_sdirk(Tableau::esdirk34, stretch, state, samples)
    }
}

impl Sealed for Tsit45 {}

impl Integrator for Tsit45 {
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        require_small(stretch)?;
        let problem = problem(stretch, state);
        let tableau = Tableau::tsit45();
        let start = problem.rk_state(&tableau).map(|start| with_sane_step(start, stretch));
        let solver = start.and_then(|start| problem.explicit_rk_solver(start, tableau));
        advance(solver, |_| (), stretch, state, samples)
    }
}

/// Refuses scenes that are too large for dense matrices.
fn require_small(stretch: &Stretch<'_>) -> Result<(), Stopped> {
    const MOST: usize = 4000;
    let states = stretch.system.states();
    if states <= MOST {
        return Ok(());
    }
    Err(Stopped { time: stretch.from, cause: StopCause::TooLarge { states, most: MOST } })
}

fn integrate_sdirk(
    tableau: fn() -> Tableau<f64>,
    stretch: &Stretch<'_>,
    state: &mut [f64],
    samples: &mut Samples<'_>,
) -> Result<(), Stopped> {
    require_small(stretch)?;
    let (problem, tableau) = (problem(stretch, state), tableau());
    let start = problem.rk_state(&tableau).map(|start| with_sane_step(start, stretch));
    let solver = start.and_then(|start| problem.sdirk_solver::<Solver, M>(start, tableau));
    // diffsol shortens a step that would pass the stop time, but keeps the matrix and the
    // convergence rate of the longer one. It may then accept a first iterate that is far off.
    // Setting the state anew renews both.
    let renew = |solver: &mut Sdirk<'_, Equations<'_>, Solver>| {
        let state = solver.state_clone();
        solver.set_state(state);
    };
    advance(solver, renew, stretch, state, samples)
}

fn problem<'a>(stretch: &'a Stretch<'a>, state: &[f64]) -> OdeSolverProblem<Equations<'a>> {
    let context = NalgebraContext::default();
    OdeSolverProblem {
        eqn: Equations::new(stretch, V::from_vec(state.to_vec(), context)),
        rtol: stretch.rtol,
        atol: V::from_vec(stretch.atol.to_vec(), context),
        t0: stretch.from,
        h0: 1.0,
        integrate_out: false,
        sens_rtol: None,
        sens_atol: None,
        out_rtol: None,
        out_atol: None,
        param_rtol: None,
        param_atol: None,
        ic_options: InitialConditionSolverOptions::default(),
        ode_options: OdeSolverOptions {
            // diffsol counts Newton's failures over the whole solution, so any fixed limit would
            // stop a long run. Steps that keep failing decrease until they are too small instead.
            max_nonlinear_solver_failures: usize::MAX,
            max_error_test_failures: 200,
            // This limit only ends the decrease. `advance` decides whether a step still advances
            // time; a limit near that would forbid the last short step before the end of a segment.
            min_timestep: (stretch.until - stretch.from) * f64::EPSILON * f64::EPSILON,
            ..OdeSolverOptions::default()
        },
    }
}

/// Limits the first step that diffsol proposes to the segment, and replaces it if it is not
/// positive and finite.
fn with_sane_step<S: OdeSolverState<V>>(mut start: S, stretch: &Stretch<'_>) -> S {
    let span = stretch.until - stretch.from;
    let step = start.as_mut().h;
    *step = if *step > 0.0 { step.min(span) } else { 1e-6 * span };
    start
}

/// Steps `solver` to the end of the segment; `before_last` prepares it for the step that ends
/// there.
fn advance<'p, S: OdeSolverMethod<'p, Equations<'p>>>(
    solver: Result<S, DiffsolError>,
    before_last: impl Fn(&mut S),
    stretch: &Stretch<'p>,
    state: &mut [f64],
    samples: &mut Samples<'_>,
) -> Result<(), Stopped> {
    let refused = |error: DiffsolError| Stopped {
        time: stretch.from,
        cause: StopCause::Diffsol(error.to_string()),
    };
    let mut solver = solver.map_err(refused)?;
    solver.set_stop_time(stretch.until).map_err(refused)?;
    let outcome = step_to_end(&mut solver, before_last, stretch, samples);
    let statistics = solver.get_statistics();
    stretch.system.count(|work| {
        work.rejected += statistics.number_of_error_test_failures as u64;
        work.factorizations += statistics.number_of_linear_solver_setups as u64;
        work.newton_iterations += statistics.number_of_nonlinear_solver_iterations as u64;
    });
    state.copy_from_slice(solver.state().y.inner().as_slice());
    outcome
}

fn step_to_end<'p, S: OdeSolverMethod<'p, Equations<'p>>>(
    solver: &mut S,
    before_last: impl Fn(&mut S),
    stretch: &Stretch<'p>,
    samples: &mut Samples<'_>,
) -> Result<(), Stopped> {
    let mut between = solver.state().y.clone();
    loop {
        let before = solver.state().t;
        if before + 1.001 * solver.state().h >= stretch.until {
            before_last(solver);
        }
        let newton_fails = solver.get_statistics().number_of_nonlinear_solver_fails;
        solver.problem().eqn.rate.trouble.set(None);
        let stopped = solver.step();
        let newton_failed = solver.get_statistics().number_of_nonlinear_solver_fails > newton_fails;
        let reason = stopped.map_err(|error| explain(solver, stretch, newton_failed, &error))?;
        let arrived = matches!(reason, OdeSolverStopReason::TstopReached);
        let now = solver.state().t;
        stretch.require_bounded(now, solver.state().y.inner().as_slice())?;
        if !arrived && now <= before {
            let stuck = OdeSolverError::StepSizeTooSmall { time: now };
            return Err(explain(solver, stretch, newton_failed, &stuck.into()));
        }
        stretch.system.count_step();
        // The last step ends at the end of the segment only to rounding.
        while let Some(time) = samples.next_until(if arrived { stretch.until } else { now }) {
            if time >= now || arrived && time >= stretch.until {
                samples.push(solver.state().y.inner().as_slice());
            } else {
                let failed = |error: DiffsolError| Stopped {
                    time,
                    cause: StopCause::Diffsol(error.to_string()),
                };
                solver.interpolate_inplace(time, &mut between).map_err(failed)?;
                stretch.require_bounded(time, between.inner().as_slice())?;
                samples.push(between.inner().as_slice());
            }
        }
        if arrived {
            return Ok(());
        }
        if let Some(cause) = stretch.out_of_steps(now) {
            return Err(Stopped { time: now, cause });
        }
        stretch.require_uninterrupted(now)?;
    }
}

/// Translates an error of diffsol to a cause in terms of the machine.
fn explain<'p, S: OdeSolverMethod<'p, Equations<'p>>>(
    solver: &S,
    stretch: &Stretch<'p>,
    newton_failed: bool,
    error: &DiffsolError,
) -> Stopped {
    let time = solver.state().t;
    if let Some((what, index)) = solver.problem().eqn.rate.trouble.get() {
        return stretch.not_finite(what, index, time);
    }
    let cause = match error {
        DiffsolError::OdeSolverError(OdeSolverError::TooManyNonlinearSolverFailures { .. })
        | DiffsolError::NonLinearSolverError(_) => StopCause::Newton,
        DiffsolError::OdeSolverError(OdeSolverError::StepSizeTooSmall { .. }) if newton_failed => {
            StopCause::Newton
        }
        DiffsolError::OdeSolverError(
            OdeSolverError::StepSizeTooSmall { .. }
            | OdeSolverError::TooManyErrorTestFailures { .. },
        ) => StopCause::StepTooSmall,
        other => StopCause::Diffsol(other.to_string()),
    };
    Stopped { time, cause }
}

/// One segment as equations of diffsol: y' = f(t, y) with identity mass.
struct Equations<'a> {
    rate: Rate<'a>,
    start: Start,
}

struct Rate<'a> {
    stretch: &'a Stretch<'a>,
    size: usize,
    context: NalgebraContext,
    /// Values of the Jacobian's nonzeros, for transfer from the simulator to the matrix.
    nonzeros: RefCell<Vec<f64>>,
    /// Quantity that was last not finite, with its row, since the last accepted step.
    trouble: Cell<Option<(&'static str, usize)>>,
}

struct Start {
    state: V,
    context: NalgebraContext,
}

impl<'a> Equations<'a> {
    fn new(stretch: &'a Stretch<'a>, state: V) -> Self {
        let context = NalgebraContext::default();
        let nonzeros = vec![0.0; stretch.system.jacobian_pattern().entries.len()];
        let rate = Rate {
            stretch,
            size: stretch.system.len(),
            context,
            nonzeros: RefCell::new(nonzeros),
            trouble: Cell::new(None),
        };
        Self { rate, start: Start { state, context } }
    }
}

impl NonLinearOp for Rate<'_> {
    fn call_inplace(&self, x: &V, t: f64, y: &mut V) {
        let rate = y.inner_mut().as_mut_slice();
        self.stretch.rate(t, x.inner().as_slice(), rate);
        if let Some(index) = rate.iter().position(|value| !value.is_finite()) {
            self.trouble.set(Some(("the rate of", index)));
            rate.fill(REPELLENT);
        }
    }
}

impl NonLinearOpJacobian for Rate<'_> {
    fn jac_mul_inplace(&self, x: &V, t: f64, v: &V, y: &mut V) {
        let mut matrix = M::zeros(self.size, self.size, self.context);
        self.jacobian_inplace(x, t, &mut matrix);
        matrix.gemv(1.0, v, 0.0, y);
    }

    /// Fills the matrix from the emitted nonzeros, in one evaluation.
    fn jacobian_inplace(&self, x: &V, t: f64, y: &mut M) {
        let state = x.inner().as_slice();
        let mut nonzeros = self.nonzeros.borrow_mut();
        self.stretch.jacobian(t, state, &mut nonzeros);
        let matrix = y.inner_mut();
        matrix.fill(0.0);
        let entries = self.stretch.system.jacobian_pattern().entries;
        for (&(row, column), &value) in entries.iter().zip(nonzeros.iter()) {
            let (row, column) = (row as usize, column as usize);
            if !value.is_finite() {
                self.trouble.set(Some(("the Jacobian of the rate of", row)));
            }
            matrix[(row, column)] = value;
        }
        let states = self.stretch.system.states();
        for (column, values) in self.stretch.flow_gradient(t, state) {
            for (flow, value) in values.into_iter().enumerate() {
                matrix[(states + flow, column)] = value;
            }
        }
    }
}

impl ConstantOp for Start {
    fn call_inplace(&self, _t: f64, y: &mut V) {
        y.copy_from(&self.state);
    }
}

/// Implements sizes and types for the equations, their rate and their start.
macro_rules! square_op {
    ($op:ty, $self:ident => $size:expr, $context:expr) => {
        impl Op for $op {
            type T = f64;
            type V = V;
            type M = M;
            type C = NalgebraContext;

            fn context(&self) -> &NalgebraContext {
                let $self = self;
                &$context
            }
            fn nstates(&self) -> usize {
                let $self = self;
                $size
            }
            fn nout(&self) -> usize {
                self.nstates()
            }
            fn nparams(&self) -> usize {
                0
            }
        }
    };
}

square_op!(Rate<'_>, this => this.size, this.context);
square_op!(Start, this => this.state.len(), this.context);
square_op!(Equations<'_>, this => this.rate.size, this.rate.context);

impl<'b> OdeEquationsRef<'b> for Equations<'_> {
    type Mass = UnitCallable<M>;
    type Rhs = &'b Rate<'b>;
    type Root = UnitCallable<M>;
    type Init = &'b Start;
    type Out = UnitCallable<M>;
    type Reset = UnitCallable<M>;
}

impl OdeEquations for Equations<'_> {
    fn rhs(&self) -> &Rate<'_> {
        &self.rate
    }

    fn mass(&self) -> Option<UnitCallable<M>> {
        None
    }

    fn init(&self) -> &Start {
        &self.start
    }

    /// Does nothing: the parameters belong to the simulator.
    fn set_params(&mut self, _parameters: &V) {}

    fn get_params(&self, _parameters: &mut V) {}
}
