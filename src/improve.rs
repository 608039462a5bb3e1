//! Optimization of designs: parameters that minimize an expression over a run, subject to
//! inequalities.
//!
//! Expressions contain parameters and results of runs, such as `max(abs(coupling_torque))`; see
//! [`Expression`]. Their derivatives follow from the run's sensitivities
//! ([`Simulation::sensitivities`]), and are exact for the value computed from its samples. Unknowns
//! are [`Unknown`]s of a fit; the search uses their logarithms where bounds are positive.

mod course;
mod evaluate;
mod expression;
mod gradient;
mod quadratic;
mod search;

use std::sync::atomic::AtomicBool;

use machinist_contract::Simulator;

use crate::error::{SimulateError, did_you_mean};
use crate::fit::{Bounds, Unknown};
use crate::simulate::Simulation;
use crate::trajectory::Trajectory;
use evaluate::Shown;

pub use evaluate::Branch;
pub use expression::{
    Expression, ExpressionError, Function, Inequality, Node, Operator, Reduction,
};
pub use gradient::{NumberGradient, gradient};
pub use search::{End, Evaluation, Found, Search, search};

/// An optimization problem.
pub struct Improvement<'a> {
    /// The run with all settings that are not varied; expressions use its output times.
    pub simulation: &'a Simulation<'a>,
    /// Unknowns.
    pub unknowns: &'a [Unknown],
    /// Expression to be minimized.
    pub objective: &'a Expression,
    /// Inequalities to be fulfilled.
    pub inequalities: &'a [Inequality],
}

/// Values of the objective and the inequalities at a point.
#[derive(Debug, Clone, PartialEq)]
pub struct Values {
    /// Value of the objective.
    pub objective: f64,
    /// Values of both sides of each inequality.
    pub sides: Vec<(f64, f64)>,
    /// Notes of the run.
    pub notes: Vec<String>,
}

/// Scales of the objective and the inequalities.
#[derive(Debug, Clone, PartialEq)]
pub struct Sizes {
    /// Scale of the objective.
    pub objective: f64,
    /// Scale of each inequality.
    pub inequalities: Vec<f64>,
}

/// Refuses unknown names, and time-dependent quantities outside of reductions.
///
/// # Errors
/// The problem and its position in the text.
pub fn check(
    expression: &Expression,
    simulator: &dyn Simulator<f64>,
) -> Result<(), ExpressionError> {
    let shape = simulator.shape();
    let parameters = || (0..shape.parameters).map(|index| simulator.parameter(index).name);
    let states = || (0..shape.states()).map(|index| simulator.state(index).name);
    let outputs = || (0..shape.outputs).map(|index| simulator.output(index).name);
    let mut wrong = None;
    expression.for_each_name(&mut |name, range, is_within| {
        let is_parameter = parameters().any(|known| known == name);
        let is_course = outputs().chain(states()).any(|known| known == name) || name == "t";
        let error = match (is_parameter, is_course) {
            (true, _) => return,
            (false, true) if is_within => return,
            (false, true) => {
                let message = format!("`{name}` changes over time; reduce it to one number");
                let help = format!(
                    "write max({name}), min({name}), mean({name}), final({name}) or another of \
                     integral, rms, initial, peak_time"
                );
                ExpressionError::new(message, range.clone()).with_help(help)
            }
            (false, false) => {
                let known = outputs().chain(parameters()).chain(states());
                let hint = did_you_mean(name, known);
                let scene = simulator.name();
                let message =
                    format!("scene `{scene}` has no output, parameter or state `{name}`{hint}");
                ExpressionError::new(message, range.clone())
            }
        };
        wrong.get_or_insert(error);
    });
    match wrong.or_else(|| nested(expression, false)) {
        None => Ok(()),
        Some(error) => Err(error),
    }
}

/// Returns an error if a reduction contains a reduction.
fn nested(expression: &Expression, is_within: bool) -> Option<ExpressionError> {
    match &expression.node {
        Node::Number(..) | Node::Name(_) => None,
        Node::Negative(a) | Node::Call(_, a) => nested(a, is_within),
        Node::Binary(_, a, b) => nested(a, is_within).or_else(|| nested(b, is_within)),
        Node::Reduce(..) if is_within => {
            let message = "this is one number already and does not change over time";
            Some(ExpressionError::new(message, expression.range.clone()))
        }
        Node::Reduce(_, a) => nested(a, true),
    }
}

impl Improvement<'_> {
    /// Returns the start of the search, in search coordinates.
    #[must_use]
    pub fn start(&self) -> Vec<f64> {
        self.unknowns.iter().map(Unknown::inner_start).collect()
    }

    /// Returns the bounds in search coordinates.
    #[must_use]
    pub fn bounds(&self) -> Vec<Bounds> {
        self.unknowns.iter().map(Unknown::inner_bounds).collect()
    }

    /// Returns the values of the unknowns at search coordinates.
    #[must_use]
    pub fn values(&self, inner: &[f64]) -> Vec<f64> {
        let bounds = self.bounds();
        let value = |((unknown, inner), Bounds { low, high }): ((&Unknown, &f64), &Bounds)| {
            // Values at a bound are exact to the last bit.
            if inner <= low {
                unknown.bounds.low
            } else if inner >= high {
                unknown.bounds.high
            } else {
                unknown.outer(*inner)
            }
        };
        self.unknowns.iter().zip(inner).zip(&bounds).map(value).collect()
    }

    /// Runs at some values of the unknowns.
    ///
    /// # Errors
    /// As for [`Simulation::run`].
    pub fn run(
        &self,
        values: &[f64],
        with_sensitivities: bool,
    ) -> Result<Trajectory, SimulateError> {
        let mut simulation = self.given(values)?;
        if with_sensitivities {
            let names: Vec<&str> = self.unknowns.iter().map(|unknown| &*unknown.name).collect();
            simulation = simulation.sensitivities(&names)?;
        }
        simulation.run()
    }

    fn given(&self, values: &[f64]) -> Result<Simulation<'_>, SimulateError> {
        let mut simulation = self.simulation.clone();
        for (unknown, value) in self.unknowns.iter().zip(values) {
            simulation = simulation.given(&unknown.name, *value)?;
        }
        Ok(simulation)
    }

    /// Evaluates the expressions at some values of the unknowns, without derivatives.
    ///
    /// # Errors
    /// As for [`Simulation::run`].
    pub fn numbers_at(&self, values: &[f64]) -> Result<Values, SimulateError> {
        let run = self.run(values, false)?;
        let value = |expression: &Expression| -> Result<f64, SimulateError> {
            Ok(self.branches(&run, values, &[], expression)?[0].value)
        };
        let sides = self.inequalities.iter().map(|i| Ok((value(&i.left)?, value(&i.right)?)));
        Ok(Values {
            objective: value(self.objective)?,
            sides: sides.collect::<Result<_, SimulateError>>()?,
            notes: run.notes,
        })
    }

    /// Returns the scales of objective and inequalities.
    #[must_use]
    pub fn sizes(&self, told: &Values) -> Sizes {
        let positive = |size: f64| if size > 0.0 && size.is_finite() { size } else { 1.0 };
        let of_sides = |(left, right): &(f64, f64)| {
            positive(if *right == 0.0 { left.abs() } else { right.abs() })
        };
        Sizes {
            objective: positive(told.objective.abs()),
            inequalities: told.sides.iter().map(of_sides).collect(),
        }
    }

    /// Evaluates objective and inequalities with derivatives, at a point in search coordinates.
    ///
    /// # Errors
    /// The reason why the run stopped.
    pub fn evaluate(&self, inner: &[f64], sizes: &Sizes) -> Result<Evaluation, SimulateError> {
        let values = self.values(inner);
        let run = self.run(&values, true)?;
        let names: Vec<String> = self.unknowns.iter().map(|unknown| unknown.name.clone()).collect();
        let scaled = |expression: &Expression, size: f64| -> Result<Vec<Branch>, SimulateError> {
            let mut branches = self.branches(&run, &values, &names, expression)?;
            for branch in &mut branches {
                branch.value /= size;
                for ((slope, unknown), value) in
                    branch.slopes.iter_mut().zip(self.unknowns).zip(&values)
                {
                    *slope *= unknown.slope(*value) / size;
                }
            }
            Ok(branches)
        };
        let objective = scaled(self.objective, sizes.objective)?;
        let constraints = self.inequalities.iter().zip(&sizes.inequalities).map(|(i, size)| {
            let range = i.left.range.start..i.right.range.end;
            let sides = (Box::new(i.left.clone()), Box::new(i.right.clone()));
            let (a, b) = if i.is_at_most { sides } else { (sides.1, sides.0) };
            let less = Node::Binary(Operator::Subtract, a, b);
            scaled(&Expression { node: less, range }, *size)
        });
        let constraints = constraints.collect::<Result<_, _>>()?;
        Ok(Evaluation { objective, constraints })
    }

    fn branches(
        &self,
        run: &Trajectory,
        values: &[f64],
        by: &[String],
        expression: &Expression,
    ) -> Result<Vec<Branch>, SimulateError> {
        let simulation = self.given(values)?;
        let parameter = |name: &str| parameter_of(&simulation, name);
        let stretches = stretches(&simulation, run);
        let slopes = |column: &str, k: usize| run.sensitivity(column, &by[k]).unwrap_or_default();
        let shown = Shown { run, stretches, by, slopes: &slopes, parameter: &parameter };
        Ok(shown.branches(expression))
    }

    /// Searches from a start in search coordinates.
    ///
    /// # Errors
    /// The reason why the start cannot be evaluated.
    pub fn search(
        &self,
        start: &[f64],
        sizes: &Sizes,
        most: usize,
        interrupt: Option<&AtomicBool>,
        mut watch: impl FnMut(&Evaluation),
    ) -> Result<Found, String> {
        let bounds = self.bounds();
        let evaluate = |inner: &[f64]| {
            let evaluation = self.evaluate(inner, sizes).map_err(|error| error.to_string())?;
            watch(&evaluation);
            Ok(evaluation)
        };
        search(evaluate, start, &Search { bounds: &bounds, most, interrupt })
    }

    /// Returns the decrease of the objective per unit by which the right side of each inequality is
    /// relaxed, in their own units.
    #[must_use]
    pub fn costs(&self, found: &Found, sizes: &Sizes) -> Vec<f64> {
        let costs = found.multipliers.iter().zip(&sizes.inequalities);
        costs.map(|(multiplier, size)| multiplier * sizes.objective / size).collect()
    }
}

/// Returns the value of an expression over a run.
#[cfg(feature = "sweep")]
pub(crate) fn value_of_run(
    expression: &Expression,
    simulation: &Simulation<'_>,
    run: &Trajectory,
) -> f64 {
    let parameter = |name: &str| parameter_of(simulation, name);
    let stretches = stretches(simulation, run);
    let slopes = |_: &str, _: usize| -> &[f64] { &[] };
    Shown { run, stretches, by: &[], slopes: &slopes, parameter: &parameter }.value(expression).0
}

/// Returns the value of a parameter in a run.
fn parameter_of(simulation: &Simulation<'_>, name: &str) -> Option<f64> {
    let (values, simulator) = (simulation.parameter_values(), simulation.simulator());
    let place = (0..values.len()).find(|index| simulator.parameter(*index).name == name)?;
    Some(values[place])
}

/// Returns the first rows of segments between events and jumps.
fn stretches(simulation: &Simulation<'_>, run: &Trajectory) -> Vec<usize> {
    let (simulator, parameters) = (simulation.simulator(), simulation.parameter_values());
    let mut jumps = vec![0.0; simulator.shape().discontinuities];
    simulator.discontinuities(parameters, &mut jumps);
    let happened = run.switches.iter().map(|switch| switch.time);
    let mut rows: Vec<usize> = happened
        .chain(jumps)
        .map(|time| run.times.partition_point(|sampled| *sampled < time))
        .filter(|row| *row < run.times.len())
        .chain([0])
        .collect();
    rows.sort_unstable();
    rows.dedup();
    rows
}
