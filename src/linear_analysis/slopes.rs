//! Derivatives of eigenmodes by parameters.
//!
//! For a simple eigenvalue with right and left eigenvectors x and w of A = dy'/dy,
//!
//! ```text
//! d lambda/dp = w^T (dA/dp) x/(w^T x),   dA/dp = A_p + A_y dy/dp
//! ```
//!
//! where y is the point, which moves with p. Both terms are computed together, see
//! [`bends`](super::bends). dy/dp of a start, and of a state along the run, are the run's
//! sensitivities; that of an equilibrium follows from its equations, see [`PointSlopes::of`].

use std::ops::AddAssign;

use machinist_contract::{Derivatives, Dual, DualFunction, Quantity, Simulator};
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

use super::bends::{Direction, changes};
use super::inverse_iteration::InverseIteration;
use super::motions::Places;
use super::search::{ACCEPTED, RANK};
use super::{LinearError, Linearization, Mode, ModeKind, Place, Point, full, scales};
use crate::simulate::Simulation;
use crate::trajectory::sensitivity_name;

/// Part of a change by a parameter that no move of the state compensates, relative to that change.
const LEFT: f64 = 1e-8;
/// Relative difference below which eigenvalues are equal.
const SAME: f64 = 1e-9;

/// Derivatives dy/dp of an operating point by parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct PointSlopes {
    /// Indices of the parameters.
    parameters: Vec<usize>,
    /// dy/dp, `states` by the number of parameters.
    state: DMatrix<f64>,
}

/// Derivatives of an eigenmode by one parameter, in SI units over the parameter's unit.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct ModeSlope {
    /// Derivative of the real part of the eigenvalue.
    pub real: f64,
    /// Derivative of the imaginary part, the frequency of the damped motion.
    pub imaginary: f64,
    /// Derivative of [`Mode::natural_frequency`].
    pub natural_frequency: f64,
    /// Derivative of [`Mode::damping_ratio`].
    pub damping_ratio: f64,
}

/// Reason why an eigenmode has no derivatives.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NoSlope {
    /// The motion is free for all parameters.
    Free,
    /// The eigenmodes with these indices have the same eigenvalue: how they separate depends on the
    /// direction in parameter space.
    Repeated(Vec<usize>),
    /// The matrix is defective: an oscillation turns into two decays, or several eigenvalues share
    /// one shape. The eigenvalue changes with the root of the parameter.
    Defective,
}

impl PointSlopes {
    /// Computes the derivatives of the operating point of a run by parameters.
    ///
    /// The derivative of an equilibrium follows from the equations
    ///
    /// ```text
    /// q''(y, p) = 0    z'(y, p) = 0    H s'(y, p) = 0,  H = d[q'', z']/ds
    /// g(y, p) = 0      dg/dt(y, p) = 0      of constraints
    /// ```
    ///
    /// where s are the positions in y: it is the shortest dy that keeps them zero, with states
    /// measured by their scales. States that an equilibrium leaves open, such as an angle that
    /// nothing depends on, stay unchanged.
    ///
    /// # Errors
    /// [`LinearError::Simulate`] if a name is not a parameter, [`LinearError::LosesEquilibrium`] if no
    /// equilibrium remains when a parameter changes, and the errors of [`Simulation::run`] with
    /// sensitivities.
    pub fn of<N: AsRef<str>>(
        run: &Simulation<'_>,
        place: Place,
        point: &Point,
        by: &[N],
    ) -> Result<Self, LinearError> {
        let simulator = run.simulator();
        let parameters = by.iter().map(|name| run.parameter_index(name.as_ref()));
        let parameters = parameters.collect::<Result<Vec<usize>, _>>()?;
        let state = match place {
            Place::Equilibrium => of_equilibrium(simulator, point, &parameters)?,
            Place::Initial | Place::Time(_) => of_run(run, point, &parameters)?,
        };
        Ok(Self { parameters, state })
    }

    /// Returns the parameters with names and units.
    pub fn by<'s>(&self, simulator: &'s dyn Simulator<f64>) -> Vec<Quantity<'s>> {
        self.parameters.iter().map(|index| simulator.parameter(*index)).collect()
    }

    /// Returns dy/dp, `states` by the number of parameters.
    #[must_use]
    pub fn state(&self) -> &DMatrix<f64> {
        &self.state
    }
}

impl Linearization<'_> {
    /// Computes the derivatives of every eigenmode by every parameter. `modes` are those of
    /// [`Linearization::modes`], and `point` contains the derivatives of the operating point.
    ///
    /// # Errors
    /// [`crate::SimulateError::NoDerivatives`] for a scene without functions on dual numbers.
    pub fn mode_slopes(
        &self,
        modes: &[Mode],
        point: &PointSlopes,
    ) -> Result<Vec<Result<Vec<ModeSlope>, NoSlope>>, LinearError> {
        let scales = scales(self.simulator);
        let by_scales =
            |row: usize, column: usize, entry: f64| entry * scales[column] / scales[row];
        let matrix = full(self.simulator, &self.matrix.clone().scaled(by_scales))?;
        let changes = self.matrix_slopes(point)?;
        let iteration = InverseIteration::new(&matrix);
        let solver = Solver { norm: matrix.norm(), iteration, scales };
        let pattern = self.simulator.rate_jacobian_pattern().entries;
        let slopes = |number: usize| {
            let (right, left) = solver.vectors(modes, number)?;
            let value = modes[number].eigenvalue();
            Ok(changes
                .iter()
                .map(|values| {
                    let entries = pattern.iter().zip(values);
                    let of_value = entries.map(|((row, column), value)| {
                        left[*row as usize] * right[*column as usize] * *value
                    });
                    ModeSlope::of(value, of_value.sum())
                })
                .collect())
        };
        Ok((0..modes.len()).map(slopes).collect())
    }

    /// Returns dA/dp including the motion of the point, in the order of the pattern, for each
    /// parameter.
    fn matrix_slopes(&self, point: &PointSlopes) -> Result<Vec<Vec<f64>>, LinearError> {
        let directions: Vec<_> = (0..point.parameters.len())
            .map(|k| (Some(point.parameters[k]), point.state.column(k).iter().copied().collect()))
            .collect();
        changes(self.simulator, &self.point, &directions)
    }
}

impl ModeSlope {
    /// Converts the derivative of an eigenvalue.
    fn of(value: Complex64, slope: Complex64) -> Self {
        let size = value.norm();
        let natural_frequency = (value.conj() * slope).re / size;
        let damping_ratio = (value.re * natural_frequency / size - slope.re) / size;
        // A real eigenvalue stays real.
        let imaginary = if value.im == 0.0 { 0.0 } else { slope.im };
        Self { real: slope.re, imaginary, natural_frequency, damping_ratio }
    }
}

/// A with states measured by their scales.
struct Solver {
    iteration: InverseIteration,
    norm: f64,
    scales: DVector<f64>,
}

impl Solver {
    /// Returns right and left eigenvectors with product 1, in units.
    fn vectors(
        &self,
        modes: &[Mode],
        number: usize,
    ) -> Result<(DVector<Complex64>, DVector<Complex64>), NoSlope> {
        const ROUNDINGS: f64 = 64.0;
        if modes[number].kind == ModeKind::Free {
            return Err(NoSlope::Free);
        }
        let value = modes[number].eigenvalue();
        let [mut right, mut left] = self.iteration.vectors(value, number, &[]);
        let overlap = left.dot(&right);
        let uncertain = ROUNDINGS * f64::EPSILON * self.norm / overlap.norm();
        let is_near = |other: Complex64| {
            let apart = (other - value).norm();
            apart <= SAME * value.norm() || apart <= uncertain
        };
        let others = (0..modes.len())
            .filter(|other| *other != number && modes[*other].kind != ModeKind::Free);
        let same: Vec<usize> = others.filter(|other| is_near(modes[*other].eigenvalue())).collect();
        if value.im > 0.0 && is_near(value.conj()) || overlap.norm() <= LEFT {
            return Err(if same.is_empty() { NoSlope::Defective } else { NoSlope::Repeated(same) });
        }
        if !same.is_empty() {
            return Err(NoSlope::Repeated(same));
        }
        for (index, scale) in self.scales.iter().enumerate() {
            right[index] *= *scale;
            left[index] /= overlap * *scale;
        }
        Ok((right, left))
    }
}

/// Returns dy/dp at a time of the run, from its sensitivities.
fn of_run(
    run: &Simulation<'_>,
    point: &Point,
    parameters: &[usize],
) -> Result<DMatrix<f64>, LinearError> {
    let simulator = run.simulator();
    let names: Vec<&str> =
        parameters.iter().map(|index| simulator.parameter(*index).name).collect();
    let states = simulator.shape().states();
    let from = run.start_time();
    // The start is the same for a run of any length.
    let is_start = point.time.to_bits() == from.to_bits();
    let until = if is_start { from + 1e-6 * from.abs().max(1.0) } else { point.time };
    let run = run.clone().until(until).points(2).sensitivities(&names)?.run()?;
    let row = if is_start { 0 } else { run.times.len() - 1 };
    let slope = |state: usize, column: usize| {
        let name = sensitivity_name(simulator.state(state).name, names[column]);
        run.find(&name).map_or(f64::NAN, |column| column.values[row])
    };
    Ok(DMatrix::from_fn(states, names.len(), slope))
}

/// Conditions of an equilibrium as linear equations of its moves.
struct Equations {
    /// Derivatives by the state, with states measured by their scales and rows of length 1.
    by_state: DMatrix<f64>,
    /// Derivatives by the parameters.
    by_parameters: DMatrix<f64>,
}

fn of_equilibrium(
    simulator: &dyn Simulator<f64>,
    point: &Point,
    parameters: &[usize],
) -> Result<DMatrix<f64>, LinearError> {
    let scales = scales(simulator);
    let Equations { by_state, by_parameters } = equations(simulator, point, parameters, &scales)?;
    let singular = LinearError::Singular { what: "the Jacobian of the equilibrium" };
    let svd = by_state.clone().try_svd(true, true, f64::EPSILON, 10_000).ok_or(singular.clone())?;
    let moves = svd.solve(&-&by_parameters, RANK).map_err(|_| singular)?;
    let left = &by_state * &moves + &by_parameters;
    for (column, parameter) in parameters.iter().enumerate() {
        let value = point.parameters[*parameter];
        let size = if value == 0.0 { 1.0 } else { value.abs() };
        let allowed = LEFT * by_parameters.column(column).norm() + ACCEPTED / size;
        let left = left.column(column).norm();
        if left.is_nan() || left > allowed {
            return Err(LinearError::LosesEquilibrium {
                scene: simulator.name().to_owned(),
                parameter: simulator.parameter(*parameter).name.to_owned(),
            });
        }
    }
    Ok(DMatrix::from_fn(moves.nrows(), moves.ncols(), |row, column| {
        moves[(row, column)] * scales[row]
    }))
}

fn equations(
    simulator: &dyn Simulator<f64>,
    point: &Point,
    parameters: &[usize],
    scales: &DVector<f64>,
) -> Result<Equations, LinearError> {
    let states = scales.len();
    let at = (point.time, &point.state[..], &point.parameters[..]);
    let places = Places::of(simulator);
    let (positions, dynamic) = (&places.positions, places.dynamic());
    let jacobian = full(simulator, &super::jacobian(simulator, point)?)?;
    let by_parameters = parameter_jacobian(simulator, point, parameters);
    let steepness = jacobian.select_rows(&dynamic).select_columns(positions);
    let mut drift_by_state = &steepness * jacobian.select_rows(positions);
    let mut drift_by_parameters = &steepness * by_parameters.select_rows(positions);
    let rates = super::rate(simulator, point).select_rows(positions);
    if rates.iter().any(|rate| *rate != 0.0) {
        let states = (0..states).map(|index| (None, unit(states, index)));
        let given = parameters.iter().map(|index| (Some(*index), vec![0.0; scales.len()]));
        let directions: Vec<_> = states.chain(given).collect();
        let pattern = simulator.rate_jacobian_pattern();
        let changes = changes(simulator, point, &directions)?;
        for (direction, values) in changes.iter().enumerate() {
            let change = crate::dense::dense(pattern, values);
            let bent = change.select_rows(&dynamic).select_columns(positions) * &rates;
            match direction.checked_sub(scales.len()) {
                None => drift_by_state.column_mut(direction).add_assign(&bent),
                Some(parameter) => drift_by_parameters.column_mut(parameter).add_assign(&bent),
            }
        }
    }
    let of_rows = scales.select_rows(&dynamic);
    let size = scaled(&jacobian, scales, scales).norm();
    let mut all = Equations {
        by_state: DMatrix::zeros(0, scales.len()),
        by_parameters: DMatrix::zeros(0, parameters.len()),
    };
    let rates = (jacobian.select_rows(&dynamic), by_parameters.select_rows(&dynamic));
    all.add(rates, (&of_rows, scales), size);
    all.add((drift_by_state, drift_by_parameters), (&of_rows, scales), size * size);
    for function in [DualFunction::ConstraintValues, DualFunction::ConstraintRates] {
        let constraints = constraint_slopes(simulator, function, at, parameters)?;
        let ones = DVector::from_element(constraints.0.nrows(), 1.0);
        let size = scaled(&constraints.0, &ones, scales).norm();
        all.add(constraints, (&ones, scales), size);
    }
    Ok(all)
}

impl Equations {
    /// Adds rows, measured by the scales of rows and columns. `size` is the size of their terms,
    /// compared with which a row may be rounding.
    fn add(
        &mut self,
        (by_state, mut by_parameters): (DMatrix<f64>, DMatrix<f64>),
        (of_rows, of_columns): (&DVector<f64>, &DVector<f64>),
        size: f64,
    ) {
        const ROUNDINGS: f64 = 64.0;
        let mut by_state = scaled(&by_state, of_rows, of_columns);
        for (row, scale) in of_rows.iter().enumerate() {
            let length = by_state.row(row).norm();
            let is_rounding = length <= ROUNDINGS * f64::EPSILON * size;
            let factor = if is_rounding { 0.0 } else { 1.0 / length };
            by_state.row_mut(row).scale_mut(factor);
            by_parameters.row_mut(row).scale_mut(factor / scale);
        }
        let first = self.by_state.nrows();
        let count = first + by_state.nrows();
        self.by_state.resize_vertically_mut(count, 0.0);
        self.by_state.rows_mut(first, by_state.nrows()).copy_from(&by_state);
        self.by_parameters.resize_vertically_mut(count, 0.0);
        self.by_parameters.rows_mut(first, by_state.nrows()).copy_from(&by_parameters);
    }
}

/// Returns a matrix with columns multiplied and rows divided by scales.
fn scaled(matrix: &DMatrix<f64>, rows: &DVector<f64>, columns: &DVector<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| {
        matrix[(row, column)] * columns[column] / rows[row]
    })
}

/// Returns derivatives of constraints by state and parameters.
fn constraint_slopes(
    simulator: &dyn Simulator<f64>,
    function: DualFunction,
    at: (f64, &[f64], &[f64]),
    parameters: &[usize],
) -> Result<(DMatrix<f64>, DMatrix<f64>), LinearError> {
    let (states, count) = (at.1.len(), simulator.constraints());
    if count == 0 {
        return Ok((DMatrix::zeros(0, states), DMatrix::zeros(0, parameters.len())));
    }
    let of_states = (0..states).map(|index| (None, unit(states, index)));
    let given = parameters.iter().map(|index| (Some(*index), vec![0.0; states]));
    let slopes =
        along(simulator, function, count, at, &of_states.chain(given).collect::<Vec<_>>())?;
    let of = |first: usize, columns: usize| {
        DMatrix::from_fn(count, columns, |row, column| slopes[first + column][row])
    };
    Ok((of(0, states), of(states, parameters.len())))
}

fn unit(size: usize, index: usize) -> Vec<f64> {
    let mut unit = vec![0.0; size];
    unit[index] = 1.0;
    unit
}

/// Returns dy'/dp for some parameters.
fn parameter_jacobian(
    simulator: &dyn Simulator<f64>,
    point: &Point,
    parameters: &[usize],
) -> DMatrix<f64> {
    let pattern = simulator.parameter_jacobian_pattern();
    let mut values = vec![0.0; pattern.entries.len()];
    simulator.parameter_jacobian(point.time, &point.state, &point.parameters, &mut values);
    crate::dense::dense(pattern, &values).select_columns(parameters)
}

/// Returns slopes of `count` values of a function along each direction: a parameter, if there is
/// one, and a change of the state.
fn along(
    simulator: &dyn Simulator<f64>,
    function: DualFunction,
    count: usize,
    (time, state, parameters): (f64, &[f64], &[f64]),
    directions: &[Direction],
) -> Result<Vec<Vec<f64>>, LinearError> {
    let derivatives: &dyn Derivatives = simulator.derivatives().ok_or_else(|| {
        crate::SimulateError::NoDerivatives { scene: simulator.name().to_owned() }
    })?;
    let constants = |values: &[f64]| values.iter().copied().map(Dual::constant).collect::<Vec<_>>();
    let mut slopes = Vec::with_capacity(directions.len());
    let mut values = vec![Dual::constant(0.0); count];
    for chunk in directions.chunks(Dual::DIRECTIONS) {
        let (mut state, mut parameters) = (constants(state), constants(parameters));
        for (lane, (parameter, moves)) in chunk.iter().enumerate() {
            if let Some(index) = parameter {
                parameters[*index].slopes[lane] = 1.0;
            }
            state.iter_mut().zip(moves).for_each(|(dual, slope)| dual.slopes[lane] = *slope);
        }
        derivatives.on_duals(function, Dual::constant(time), &state, &parameters, &mut values);
        let lanes = 0..chunk.len();
        slopes.extend(lanes.map(|lane| values.iter().map(|value| value.slopes[lane]).collect()));
    }
    Ok(slopes)
}
