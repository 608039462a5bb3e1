//! A run over one segment of the period, with its derivatives.

use nalgebra::{DMatrix, DVector};

use super::rows;
use crate::error::{SimulateError, StopCause};
use crate::simulate::Simulation;
use crate::trajectory::{ColumnKind, Trajectory};

/// Ends of a run with the derivatives of both by the initial values.
pub(super) struct Shot {
    /// State at the start, on the constraints.
    pub(super) start: Vec<f64>,
    /// State at the end.
    pub(super) end: Vec<f64>,
    /// Derivative of the start by the initial values: the projection onto the constraints.
    pub(super) projection: DMatrix<f64>,
    /// Derivative of the end by the initial values.
    pub(super) transition: DMatrix<f64>,
    /// Derivatives of start and end by the parameter.
    pub(super) by_parameter: Option<[DVector<f64>; 2]>,
    /// Reason why the derivatives are differences.
    pub(super) note: Option<String>,
}

/// States and parameter to differentiate by.
#[derive(Clone, Copy)]
pub(super) struct Directions<'d> {
    /// Indices of states.
    pub(super) states: &'d [usize],
    /// Index of a parameter.
    pub(super) parameter: Option<usize>,
    /// Typical sizes of these states.
    pub(super) scales: &'d [f64],
}

impl Shot {
    /// Runs over a segment; `run` has its start, its end and its initial state.
    pub(super) fn new(run: &Simulation<'_>, by: Directions<'_>) -> Result<Self, SimulateError> {
        let Directions { states, parameter, .. } = by;
        match run.clone().points(2).along(states, parameter).run() {
            Ok(trajectory) => Ok(Self::of(&trajectory, by)),
            Err(error) if has_differences(&error) => Self::by_differences(run, by, &error),
            Err(error) => Err(error),
        }
    }

    /// Reads the derivatives of a run with sensitivities.
    fn of(trajectory: &Trajectory, Directions { states, parameter, .. }: Directions<'_>) -> Self {
        let mut ends = rows(trajectory);
        let (n, count) = (states.len(), states.len() + usize::from(parameter.is_some()));
        // Rows of states come first, each with all directions.
        let columns: Vec<_> = trajectory.of_kind(ColumnKind::Sensitivity).collect();
        let last = trajectory.times.len() - 1;
        let at = |row: usize, column: usize, time: usize| {
            columns[states[row] * count + column].values[time]
        };
        let end = ends.pop().unwrap_or_default();
        Self {
            start: ends.swap_remove(0),
            end,
            projection: DMatrix::from_fn(n, n, |row, column| at(row, column, 0)),
            transition: DMatrix::from_fn(n, n, |row, column| at(row, column, last)),
            by_parameter: parameter
                .map(|_| [0, last].map(|time| DVector::from_fn(n, |row, _| at(row, n, time)))),
            note: None,
        }
    }

    /// Takes central differences of runs from both sides of each initial value.
    fn by_differences(
        run: &Simulation<'_>,
        Directions { states, parameter, scales }: Directions<'_>,
        why: &SimulateError,
    ) -> Result<Self, SimulateError> {
        let run = run.clone().points(2).along(&[], None);
        let ends = |run: &Simulation<'_>| {
            let trajectory = run.run()?;
            let mut ends = rows(&trajectory);
            let end = ends.pop().unwrap_or_default();
            Ok::<_, SimulateError>((ends.swap_remove(0), end))
        };
        let (start, end) = ends(&run)?;
        // Truncation grows with h^2 and the error of the run with rtol/h: least in sum here.
        let step = run.relative_tolerance().cbrt();
        let n = states.len();
        let (mut projection, mut transition) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
        for (column, (index, scale)) in states.iter().zip(scales).enumerate() {
            let step = step * (scale + start[*index].abs());
            let moved = |by: f64| {
                let mut state = start.clone();
                state[*index] += by;
                ends(&run.clone().shot_from(&state))
            };
            let (ahead, behind) = (moved(step)?, moved(-step)?);
            for (row, at) in states.iter().enumerate() {
                projection[(row, column)] = (ahead.0[*at] - behind.0[*at]) / (2.0 * step);
                transition[(row, column)] = (ahead.1[*at] - behind.1[*at]) / (2.0 * step);
            }
        }
        let by_parameter = parameter.map(|index| {
            let value = run.parameter_values()[index];
            let step = step * if value == 0.0 { 1.0 } else { value.abs() };
            let moved =
                |by: f64| ends(&run.clone().shot_from(&start).parameter_at(index, value + by));
            let (ahead, behind) = (moved(step)?, moved(-step)?);
            let slopes = |ahead: &[f64], behind: &[f64]| {
                let slope = |at: &usize| (ahead[*at] - behind[*at]) / (2.0 * step);
                DVector::from_iterator(n, states.iter().map(slope))
            };
            Ok::<_, SimulateError>([slopes(&ahead.0, &behind.0), slopes(&ahead.1, &behind.1)])
        });
        let note =
            format!("multipliers are from differences of runs, with half of the digits: {why}");
        let by_parameter = by_parameter.transpose()?;
        Ok(Self { start, end, projection, transition, by_parameter, note: Some(note) })
    }
}

/// Returns whether a run without sensitivities may complete although one with them does not.
fn has_differences(error: &SimulateError) -> bool {
    match error {
        SimulateError::NoDerivatives { .. }
        | SimulateError::NoSensitivities { .. }
        | SimulateError::NotDifferentiable { .. } => true,
        SimulateError::Stopped { cause, .. } => matches!(
            cause,
            StopCause::Chattering { .. }
                | StopCause::InertiaJumps
                | StopCause::ProjectedPosition { .. }
                | StopCause::Grazing { .. }
                | StopCause::CoincidentEvents { .. }
        ),
        _ => false,
    }
}
