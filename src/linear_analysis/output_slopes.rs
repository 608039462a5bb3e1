//! Derivatives of outputs by state and parameters.

use machinist_contract::{Derivatives, Dual, DualFunction, Simulator};
use nalgebra::DMatrix;

use super::differences::derivative;
use super::response::outputs;
use super::{Point, scales};

/// do/dy and do/dp of all outputs.
pub(super) struct OutputSlopes {
    /// do/dy, `outputs` by `states`.
    pub by_state: DMatrix<f64>,
    /// do/dp of the given parameters, in their order.
    pub by_parameters: DMatrix<f64>,
}

/// Returns the derivatives of all outputs: exact to rounding by dual numbers, or by extrapolated
/// differences for a simulator without them.
pub(super) fn output_slopes(
    simulator: &dyn Simulator<f64>,
    point: &Point,
    parameters: &[usize],
) -> OutputSlopes {
    let by = |column: usize| {
        let states = point.state.len();
        if column < states {
            Varied::State(column)
        } else {
            Varied::Parameter(parameters[column - states])
        }
    };
    let columns = point.state.len() + parameters.len();
    let varied: Vec<Varied> = (0..columns).map(by).collect();
    let all = match simulator.derivatives() {
        Some(duals) => by_duals(simulator, duals, point, &varied),
        None => by_differences(simulator, point, &varied),
    };
    let states = point.state.len();
    OutputSlopes {
        by_state: all.columns(0, states).into_owned(),
        by_parameters: all.columns(states, parameters.len()).into_owned(),
    }
}

/// Variable of a derivative.
#[derive(Clone, Copy)]
enum Varied {
    State(usize),
    Parameter(usize),
}

fn by_duals(
    simulator: &dyn Simulator<f64>,
    duals: &dyn Derivatives,
    point: &Point,
    varied: &[Varied],
) -> DMatrix<f64> {
    let constants = |values: &[f64]| values.iter().copied().map(Dual::constant).collect::<Vec<_>>();
    let count = simulator.shape().outputs;
    let mut slopes = DMatrix::zeros(count, varied.len());
    let mut values = vec![Dual::constant(0.0); count];
    for (chunk, along) in varied.chunks(Dual::DIRECTIONS).enumerate() {
        let (mut state, mut parameters) = (constants(&point.state), constants(&point.parameters));
        for (direction, varied) in along.iter().enumerate() {
            match *varied {
                Varied::State(index) => state[index].slopes[direction] = 1.0,
                Varied::Parameter(index) => parameters[index].slopes[direction] = 1.0,
            }
        }
        let time = Dual::constant(point.time);
        duals.on_duals(DualFunction::Outputs, time, &state, &parameters, &mut values);
        for direction in 0..along.len() {
            let column = chunk * Dual::DIRECTIONS + direction;
            for (row, value) in values.iter().enumerate() {
                slopes[(row, column)] = value.slopes[direction];
            }
        }
    }
    slopes
}

fn by_differences(
    simulator: &dyn Simulator<f64>,
    point: &Point,
    varied: &[Varied],
) -> DMatrix<f64> {
    let scales = scales(simulator);
    let count = simulator.shape().outputs;
    let mut slopes = DMatrix::zeros(count, varied.len());
    for (column, varied) in varied.iter().enumerate() {
        let size = match *varied {
            Varied::State(index) => scales[index],
            Varied::Parameter(index) if point.parameters[index] != 0.0 => {
                point.parameters[index].abs()
            }
            Varied::Parameter(_) => 1.0,
        };
        let found = derivative(size, count, |shift| {
            let Point { time, mut state, mut parameters } = point.clone();
            match *varied {
                Varied::State(index) => state[index] += shift,
                Varied::Parameter(index) => parameters[index] += shift,
            }
            outputs(simulator, time, &state, &parameters)
        });
        slopes.column_mut(column).copy_from_slice(&found);
    }
    slopes
}
