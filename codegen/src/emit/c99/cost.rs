//! Number of operations of a step: of a step without events, and the maximum. They follow from
//! the tapes, and from how often a step calls each function.

use machinist_contract::fixed_step::StepMethod;
use machinist_contract::implicit::LANES;
use machinist_model::functions::FunctionId;
use machinist_model::hoist::Hoisted;
use machinist_model::{Elimination, Model, operations};

/// Numbers of calls in a step, of functions of the machine and of projections onto constraints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StepCalls {
    /// Calls of [`FunctionId::Rate`].
    pub rates: usize,
    /// Calls of [`FunctionId::RateJacobian`] and [`FunctionId::TimeDerivative`].
    pub jacobians: usize,
    /// Calls of [`FunctionId::Guards`].
    pub guards: usize,
    /// Calls of [`FunctionId::GuardRates`].
    pub guard_rates: usize,
    /// Calls of [`FunctionId::Resets`].
    pub resets: usize,
    /// Calls of [`FunctionId::Discontinuities`].
    pub discontinuities: usize,
    /// Projections onto the constraints.
    pub projections: usize,
}

/// Numbers of operations of a step; a sine or a root counts as one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StepCost {
    /// Operations of a step without events and discontinuities.
    pub usual: usize,
    /// Maximum number of operations of a step.
    pub most: usize,
    /// Maximum number of parts of a step.
    pub parts: usize,
}

/// Returns the maximum number of parts of a step: one for each event, one for a discontinuity,
/// and the rest.
pub(super) fn parts(model: &Model) -> usize {
    model.events.len() + usize::from(!model.discontinuities.results.is_empty()) + 1
}

/// Returns the calls of a step without events and discontinuities, and the maximum number of
/// each.
#[must_use]
pub fn step_calls(model: &Model, method: StepMethod) -> [StepCalls; 2] {
    let events = model.events.len();
    let [has_events, has_jumps, is_constrained] =
        [events > 0, !model.discontinuities.results.is_empty(), !model.constraints.is_empty()]
            .map(usize::from);
    let (stages, jacobians) = match method {
        StepMethod::RungeKutta4 => (4, 0),
        StepMethod::Heun => (2, 0),
        StepMethod::Rosenbrock2 => (2, 1),
    };
    let usual = StepCalls {
        rates: stages,
        jacobians,
        guards: 2 * has_events,
        guard_rates: 2 * has_events,
        resets: 0,
        discontinuities: has_jumps,
        projections: is_constrained,
    };
    let (parts, rounds) = (parts(model), 2 * events);
    // With events, a part is stepped twice: to its end, and to the first event in it.
    let steps = parts * (1 + has_events);
    let most = StepCalls {
        rates: steps * stages,
        jacobians: steps * jacobians,
        guards: parts * has_events * (5 + rounds),
        guard_rates: parts * has_events * (3 + rounds),
        resets: parts * events * (1 + rounds),
        discontinuities: parts * has_jumps,
        projections: is_constrained * (steps + parts * has_events * (1 + rounds)),
    };
    [usual, most]
}

/// Returns the number of operations of a step.
#[must_use]
pub fn step_cost(model: &Model, method: StepMethod) -> StepCost {
    let [usual, most] = step_calls(model, method).map(|calls| cost(model, method, &calls));
    StepCost { usual, most, parts: parts(model) }
}

fn cost(model: &Model, method: StepMethod, calls: &StepCalls) -> usize {
    let hoisted = Hoisted::new(model);
    let motion = operations(&hoisted.motion);
    let of = |id: FunctionId| {
        let own = operations(hoisted.tape(model, id));
        let solve = model.solve(id).map_or(0, |solve| {
            let of_step = |step: &machinist_model::SolveStep| {
                usize::from(step.scale.is_some()) + 2 * step.terms.len()
            };
            let columns = (solve.columns as usize).next_multiple_of(LANES);
            columns * solve.steps.iter().map(of_step).sum::<usize>()
        });
        own + solve + if model.reads_motion(id) { motion } else { 0 }
    };
    let states = model.states.len();
    // `ahead` is a product and a sum for each state.
    let (per_step, implicit) = match method {
        StepMethod::RungeKutta4 => (14 * states + 4, 0),
        StepMethod::Heun => (6 * states + 2, 0),
        StepMethod::Rosenbrock2 => {
            let list = Elimination::new(states, &model.rate_jacobian.pattern.entries);
            let [factor, solve] = list.borrowed().operations();
            let both = of(FunctionId::RateJacobian) + of(FunctionId::TimeDerivative);
            (14 * states + 4, both + factor + 2 * solve)
        }
    };
    let stages = if method == StepMethod::RungeKutta4 { 4 } else { 2 };
    let steps = calls.rates / stages;
    let size = model.coordinates.len() + model.constraints.len();
    let elimination: usize = (1..=size).map(|left| (left - 1) * (3 + 2 * left) + 2 * left).sum();
    let projection = if calls.projections == 0 {
        0
    } else {
        let twice = of(FunctionId::MassMatrix) + of(FunctionId::ConstraintMatrix) + elimination;
        let residuals = of(FunctionId::ConstraintValues) + of(FunctionId::ConstraintRates);
        2 * twice + residuals + 2 * model.coordinates.len() + 4
    };
    // Finding the root of a guard takes 26 operations per digit of a number.
    let roots = if calls.resets > 0 { parts(model) * model.events.len() * 53 * 26 } else { 0 };
    let when_there = |count: usize, id: FunctionId| if count > 0 { count * of(id) } else { 0 };
    calls.rates * of(FunctionId::Rate)
        + steps * per_step
        + calls.jacobians * implicit
        + when_there(calls.guards, FunctionId::Guards)
        + when_there(calls.guard_rates, FunctionId::GuardRates)
        + when_there(calls.resets, FunctionId::Resets)
        + when_there(calls.discontinuities, FunctionId::Discontinuities)
        + calls.projections * projection
        + roots
}
