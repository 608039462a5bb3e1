//! Derivatives of an expression over a run by all parameters and initial values.

use super::evaluate::Shown;
use super::expression::Expression;
use super::{parameter_of, stretches};
use crate::error::SimulateError;
use crate::simulate::{Differentiated, Gradient, Pull, Simulation, Slope};
use crate::trajectory::Trajectory;

/// Value of an expression over a run with its derivatives.
#[derive(Debug, Clone)]
pub struct NumberGradient {
    /// Value of the expression.
    pub value: f64,
    /// The run and the derivatives by parameters and initial values.
    pub gradient: Gradient,
    /// True if the adjoint method was used, which includes initial values.
    pub is_in_reverse: bool,
    /// Names by which there is no derivative, with reasons.
    pub left_out: Vec<(String, String)>,
}

/// Computes an expression over a run with its derivatives. If the machine is smooth and the method
/// is an explicit pair or left open, the adjoint method ([`Simulation::gradient`]) gives
/// derivatives by all parameters and initial values. Otherwise sensitivities give those by all
/// parameters.
///
/// # Errors
/// As for [`Simulation::run`].
pub fn gradient(
    simulation: &Simulation<'_>,
    expression: &Expression,
) -> Result<NumberGradient, SimulateError> {
    if !simulation.is_reversible() {
        return forwards(simulation, expression);
    }
    let mut told = (f64::NAN, Vec::new());
    let gradient = simulation.gradient(|run| {
        let (value, pulls, direct) = pulls(simulation, expression, run);
        told = (value, direct);
        pulls
    });
    let mut gradient = match gradient {
        Err(SimulateError::NoSensitivities { .. }) => return forwards(simulation, expression),
        gradient => gradient?,
    };
    let (value, direct) = told;
    for (name, slope) in direct {
        let own = gradient.slopes.iter_mut().find(|own| own.is_parameter && own.name == name);
        if let Some(own) = own {
            own.value += slope;
        }
    }
    Ok(NumberGradient { value, gradient, is_in_reverse: true, left_out: Vec::new() })
}

/// Names of parameters with the direct derivatives of an expression by them, for a fixed run.
type Direct = Vec<(String, f64)>;

/// Returns the value of an expression, its derivatives by each value of the columns it names, and
/// its direct derivatives by parameters.
fn pulls(
    simulation: &Simulation<'_>,
    expression: &Expression,
    run: &Trajectory,
) -> (f64, Vec<Pull>, Direct) {
    /// Number of values that are varied at once.
    const BLOCK: usize = 64;
    let rows = run.times.len();
    // A one between rows of zeros on either side; a window into this vector is a unit vector for
    // any row.
    let mut one = vec![0.0; 2 * rows];
    one[rows] = 1.0;
    let parameter = |name: &str| parameter_of(simulation, name);
    let stretches = stretches(simulation, run);
    let valued = |by: &[String], slopes: &dyn Fn(&str, usize) -> std::ops::Range<usize>| {
        let slopes = |column: &str, by: usize| &one[slopes(column, by)];
        let stretches = stretches.clone();
        let shown = Shown { run, stretches, by, slopes: &slopes, parameter: &parameter };
        shown.value(expression)
    };
    let mut names: Vec<String> = Vec::new();
    expression.for_each_name(&mut |name, _, _| {
        if !names.iter().any(|known| known == name) {
            names.push(name.to_owned());
        }
    });
    let (columns, parameters): (Vec<_>, Vec<_>) =
        names.into_iter().partition(|name| run.column(name).is_some());
    let (value, direct) = valued(&parameters, &|_, _| 0..rows);
    let pulls = columns.into_iter().map(|column| {
        let blocks = (0..rows).step_by(BLOCK).flat_map(|first| {
            let nameless = vec![String::new(); BLOCK.min(rows - first)];
            let slopes = |of: &str, by: usize| {
                let start = if of == column { rows - first - by } else { 0 };
                start..start + rows
            };
            valued(&nameless, &slopes).1
        });
        let slopes = blocks.collect();
        Pull { column, slopes }
    });
    (value, pulls.collect(), parameters.into_iter().zip(direct).collect())
}

/// Computes the gradient by sensitivities.
fn forwards(
    simulation: &Simulation<'_>,
    expression: &Expression,
) -> Result<NumberGradient, SimulateError> {
    let simulator = simulation.simulator();
    let all = (0..simulator.shape().parameters).map(|index| simulator.parameter(index).name);
    let Differentiated { run, by, left_out } =
        simulation.differentiate(all.map(str::to_owned).collect())?;
    let parameter = |name: &str| parameter_of(simulation, name);
    let slopes = |column: &str, k: usize| run.sensitivity(column, &by[k]).unwrap_or_default();
    let stretches = stretches(simulation, &run);
    let shown = Shown { run: &run, stretches, by: &by, slopes: &slopes, parameter: &parameter };
    let (value, values) = shown.value(expression);
    let slopes = by.iter().zip(values).filter_map(|(name, value)| {
        let index = simulation.parameter_index(name).ok()?;
        let unit = simulator.parameter(index).unit.to_owned();
        let at = simulation.parameter_values()[index];
        Some(Slope { name: name.clone(), unit, is_parameter: true, at, value })
    });
    let slopes = slopes.collect();
    let gradient = Gradient { run, slopes };
    Ok(NumberGradient { value, gradient, is_in_reverse: false, left_out })
}
