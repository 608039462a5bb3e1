//! Maximum numbers of operations of emitted steps and filters, added up function by function as
//! emitted code calls them.
//!
//! An operation is a sum, product, quotient, change of sign or comparison of numbers, or a call of
//! an elementary function, an integer power or a table. Tests count the operations that emitted
//! code executes.

mod duals;
mod filter;

use machinist_contract::fixed_step::StepMethod;
use machinist_contract::implicit::LANES;
use machinist_model::functions::FunctionId;
use machinist_model::hoist::Hoisted;
use machinist_model::{Elimination, Model, StateKind, Tape, operations};

use super::body::{steps_of, wide_batches};
use super::estimator::Tangents;
use super::{EstimatorOptions, Real};
use filter::{Derivatives, Filter};

/// Numbers of operations of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StepCost {
    /// Maximum of a step without events and discontinuities.
    pub usual: usize,
    /// Maximum of each further part, which begins with events or a discontinuity.
    pub each: usize,
    /// Maximum number of parts of a step.
    pub parts: usize,
}

impl StepCost {
    /// Returns the maximum of any step.
    #[must_use]
    pub fn most(&self) -> usize {
        self.usual + (self.parts - 1) * self.each
    }

    /// Returns the numbers with operations outside of parts.
    fn with(self, around: usize) -> Self {
        Self { usual: self.usual + around, ..self }
    }
}

impl std::fmt::Display for StepCost {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { usual, each, parts } = self;
        if *parts == 1 {
            return write!(f, "at most {usual} operations");
        }
        let most = self.most();
        write!(
            f,
            "{usual} operations without events, at most {each} more for each further part, "
        )?;
        write!(f, "{most} in {parts} parts")
    }
}

/// Numbers of operations of a filter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FilterCost {
    /// A prediction over a step.
    pub predict: StepCost,
    /// Maximum of a correction by all measured outputs.
    pub correct: usize,
}

/// Returns the maximum number of parts of a step: one for each event, one for a discontinuity,
/// and the rest.
pub(super) fn parts(model: &Model) -> usize {
    model.events.len() + usize::from(!model.discontinuities.results.is_empty()) + 1
}

/// Returns the numbers of operations of a step.
#[must_use]
pub fn step_cost(model: &Model, method: StepMethod, real: Real) -> StepCost {
    let model = &model.live();
    Step::new(model, method, real).cost(None)
}

/// Returns the numbers of operations of a filter.
#[must_use]
pub fn filter_cost(
    model: &Model,
    (method, real): (StepMethod, Real),
    options: &EstimatorOptions,
) -> FilterCost {
    let model = &model.live();
    let tangents = Tangents::of(model, method, options);
    let step = Step::new(model, method, real);
    cost_of(&step, options, Derivatives::Tapes(&tangents))
}

/// Returns the numbers of operations of a filter in Rust, which takes the same operations as in C
/// except for derivatives on dual numbers.
#[must_use]
pub fn rust_filter_cost(
    model: &Model,
    method: StepMethod,
    options: &EstimatorOptions,
) -> FilterCost {
    cost_of(&Step::new(model, method, Real::Double), options, Derivatives::Duals)
}

fn cost_of(step: &Step<'_>, options: &EstimatorOptions, by: Derivatives<'_>) -> FilterCost {
    let of = Filter::new(step, options, by, true);
    let predict = step.cost(Some(&of)).with(of.around_a_step());
    FilterCost { predict, correct: Filter::new(step, options, by, false).correct() }
}

/// Sign of a number: two comparisons.
const SIGN: usize = 2;
/// A guard that its rate takes back to zero: two signs, absolute values, a product, a comparison.
const COMES_BACK: usize = 2 * SIGN + 4;
/// Operations of the search for a zero crossing for each digit of a number: half of a sum, and a
/// cubic by Horner's scheme.
const PASSING: usize = 2 + 6 + SIGN;
/// Coefficients of the cubic, before the search.
const CUBIC: usize = 8;
/// Sum of step and time with the remainder of the sum.
const PASS_TIME: usize = 4;

/// Returns the operations of a tape as emitted: one call for several angles computes sine and
/// cosine of each.
fn executed(tape: &Tape, real: Real) -> usize {
    let steps = steps_of(tape, real);
    let members = wide_batches(&steps).flat_map(|batch| &batch.members);
    let in_vain = members.filter(|member| member.results.iter().any(Option::is_none)).count();
    operations(tape) + in_vain
}

/// Returns the maximum number of events that are watched in a state: each event counts with the
/// first of its modes, and of the events of a mode those of one value.
fn watched_at_once(model: &Model) -> usize {
    let mut always = 0;
    let mut counts: Vec<((u32, f64), usize)> = Vec::new();
    for event in &model.events {
        let Some(first) = event.when.first() else {
            always += 1;
            continue;
        };
        match counts.iter_mut().find(|(mode, _)| mode == first) {
            Some((_, count)) => *count += 1,
            None => counts.push((*first, 1)),
        }
    }
    let modes: std::collections::BTreeSet<u32> =
        counts.iter().map(|((mode, _), _)| *mode).collect();
    let most = |mode: u32| {
        let of_mode = counts.iter().filter(|((other, _), _)| *other == mode);
        of_mode.map(|(_, count)| *count).max().unwrap_or(0)
    };
    always + modes.into_iter().map(most).sum::<usize>()
}

/// Operations of the parts of a step.
struct Step<'a> {
    model: &'a Model,
    method: StepMethod,
    real: Real,
    hoisted: Hoisted,
    /// Operations of the motion that functions share.
    motion: usize,
    /// Digits of a number.
    digits: usize,
    states: usize,
    events: usize,
    /// Number of events that end a mode in which they are watched.
    leaving: usize,
    /// Maximum number of events that are watched in a state, as a mode has one value at a time.
    at_once: usize,
    /// Comparisons of modes, over all events.
    watched: usize,
    is_constrained: bool,
}

impl<'a> Step<'a> {
    fn new(model: &'a Model, method: StepMethod, real: Real) -> Self {
        let hoisted = Hoisted::new(model);
        let leaves = |event: &&machinist_model::Event| {
            event.when.iter().any(|(entry, _)| event.sets.contains(entry))
        };
        Self {
            model,
            method,
            real,
            motion: executed(&hoisted.motion, real),
            hoisted,
            digits: match real {
                Real::Double => f64::MANTISSA_DIGITS as usize,
                Real::Float => f32::MANTISSA_DIGITS as usize,
            },
            states: model.states.len(),
            events: model.events.len(),
            leaving: model.events.iter().filter(leaves).count(),
            at_once: watched_at_once(model),
            watched: model.events.iter().map(|event| event.when.len()).sum(),
            is_constrained: !model.constraints.is_empty(),
        }
    }

    /// Returns the operations of a function of the machine.
    fn of(&self, id: FunctionId) -> usize {
        let own = executed(self.hoisted.tape(self.model, id), self.real);
        let solve = self.model.solve(id).map_or(0, |solve| {
            let of_step = |step: &machinist_model::SolveStep| {
                usize::from(step.scale.is_some()) + 2 * step.terms.len()
            };
            let columns = (solve.columns as usize).next_multiple_of(LANES);
            columns * solve.steps.iter().map(of_step).sum::<usize>()
        });
        own + solve + if self.model.reads_motion(id) { self.motion } else { 0 }
    }

    /// Returns the operations of an elimination: its factors, and the solution for a right side.
    fn elimination(&self) -> [usize; 2] {
        let entries = &self.model.rate_jacobian.pattern.entries;
        Elimination::new(self.states, entries).borrowed().operations()
    }

    /// Returns the operations of a step without events. `ahead` is a product and a sum for each
    /// state.
    fn advance(&self) -> usize {
        let (rate, states) = (self.of(FunctionId::Rate), self.states);
        match self.method {
            StepMethod::RungeKutta4 => 4 * rate + 14 * states + 5,
            StepMethod::Heun => 2 * rate + 6 * states + 2,
            StepMethod::Rosenbrock2 => {
                let [factor, solve] = self.elimination();
                let derivatives =
                    self.of(FunctionId::RateJacobian) + self.of(FunctionId::TimeDerivative);
                2 * rate + derivatives + factor + 2 * solve + 14 * states + 4
            }
        }
    }

    /// Returns the operations of the shortest shift onto constraints: the matrices, comparisons of
    /// their entries, and an elimination with row exchanges.
    fn shortest(&self) -> usize {
        let model = self.model;
        let size = model.coordinates.len() + model.constraints.len();
        let of_column =
            |left: usize| 3 * (left - 1) + 2 + (left - 1) * (2 * left + 4) + 2 * left - 1;
        let elimination = 2 * size * size + 2 + (1..=size).map(of_column).sum::<usize>();
        self.of(FunctionId::MassMatrix)
            + self.of(FunctionId::ConstraintMatrix)
            + model.constraint_matrix.pattern.entries.len()
            + elimination
    }

    /// Returns the operations that turn the positions by a shift.
    fn shift_positions(&self) -> usize {
        let coordinates = self.model.coordinates.len();
        let is_position =
            |state: &&machinist_model::State| matches!(state.kind, StateKind::Position(_));
        let positions = self.model.states.iter().filter(is_position).count();
        // Each quaternion has one position more than it has coordinates. A scene without
        // constraints may lack positions.
        let quaternions = positions.saturating_sub(coordinates);
        coordinates + 25 * quaternions
    }

    /// Returns the operations of a projection onto the constraints; zero without constraints.
    fn project(&self) -> usize {
        if !self.is_constrained {
            return 0;
        }
        self.of(FunctionId::ConstraintValues)
            + self.of(FunctionId::ConstraintRates)
            + 2 * self.shortest()
            + self.shift_positions()
            + self.model.coordinates.len()
    }

    fn guards(&self) -> usize {
        self.of(FunctionId::Guards)
    }

    fn look_at(&self) -> usize {
        self.guards() + self.of(FunctionId::GuardRates)
    }

    fn apply(&self) -> usize {
        self.of(FunctionId::Resets)
    }

    /// Returns the operations that find the next discontinuity and the length up to it; zero
    /// without discontinuities.
    fn jump(&self) -> usize {
        let times = self.model.discontinuities.results.len();
        if times == 0 { 0 } else { 1 + self.of(FunctionId::Discontinuities) + 2 * times + 6 }
    }

    /// Returns the operations of a trial step up to an end, with its projection.
    fn try_step(&self) -> usize {
        self.advance() + self.project() + usize::from(self.is_constrained)
    }

    /// Returns the operations that find events that have passed.
    fn pass(&self) -> usize {
        SIGN * self.events + self.watched
    }

    /// Returns the operations that correct modes. Each event that ends its mode happens at most
    /// once, in a round of its own, and the last round finds none. A round tries those that are
    /// watched and have not happened.
    fn settle(&self, filter: Option<&Filter<'_>>) -> usize {
        let (rounds, ended) = (self.leaving + 1, self.leaving);
        let of_event = (SIGN + COMES_BACK) * self.events + 2 * self.watched;
        let tried: usize = (0..rounds).map(|round| self.at_once.min(ended - round)).sum();
        let followed = filter.map_or(0, |filter| filter.reset() + filter.projected());
        rounds * (self.look_at() + of_event)
            + tried * self.apply()
            + ended * (self.project() + followed)
    }

    /// Returns the operations that record the signs of guards.
    fn look(&self) -> usize {
        self.look_at() + (2 * SIGN + COMES_BACK) * self.events + self.watched
    }

    /// Returns the operations of all events at a time.
    fn happen(&self, filter: Option<&Filter<'_>>) -> usize {
        let applied = self.watched + self.at_once * self.apply() + self.project();
        let tried = self.at_once.min(self.leaving);
        let undone = tried * (self.watched + self.apply()) + self.watched;
        let followed = filter.map_or(0, |filter| {
            filter.before() + self.at_once * filter.reset() + filter.projected() + filter.after()
        });
        self.guards()
            + applied
            + SIGN * self.events
            + undone
            + self.settle(filter)
            + self.look()
            + followed
    }

    /// Returns the operations up to the end of a part: guards at both ends, and those that have
    /// passed.
    fn to_the_end(&self) -> usize {
        1 + self.jump() + 2 * self.look_at() + 2 + self.try_step() + self.pass()
    }

    /// Returns the operations of the acceptance of a part.
    fn accept(&self) -> usize {
        SIGN * self.events + self.watched
    }

    /// Returns the operations of a step.
    fn cost(&self, filter: Option<&Filter<'_>>) -> StepCost {
        let usual = self.usual(filter) + PASS_TIME;
        StepCost { usual, each: self.further_part(filter), parts: parts(self.model) }
    }

    /// Returns the maximum number of operations of a step without events and discontinuities.
    fn usual(&self, filter: Option<&Filter<'_>>) -> usize {
        let followed = filter.map_or(0, Filter::part);
        let own = if self.events > 0 {
            self.to_the_end() + self.accept()
        } else if self.jump() > 0 {
            4 + self.jump() + self.try_step()
        } else {
            self.try_step()
        };
        own + followed
    }

    /// Returns the maximum number of operations by which a part that events or a discontinuity end
    /// lengthens a step.
    fn further_part(&self, filter: Option<&Filter<'_>>) -> usize {
        if self.events == 0 {
            return self.usual(filter);
        }
        let located = self.at_once
            * (CUBIC + PASSING * self.digits + 2 + usize::from(filter.is_some()))
            + (1 + 1 + 2 + self.try_step())
            + (2 + 2 + usize::from(filter.is_some()))
            + self.guards()
            + self.events * (1 + SIGN);
        let jumped = self.accept() + 2 + self.guards() + self.pass();
        let ended = if self.jump() > 0 { located.max(jumped) } else { located };
        let followed = filter.map_or(0, Filter::part);
        self.to_the_end() + followed + ended + self.happen(filter)
    }
}
