//! Frequency responses.

use std::io;
use std::ops::Range;

use machinist_contract::{Quantity, Simulator};
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;
use serde::Serialize;

use super::differences::derivative;
use super::motions::{Motions, Places};
use super::output_slopes::output_slopes;
use super::state_space::Signal;
use super::within::Within;
use super::{LinearError, Linearization, ModeKind, Point, full, position, scales};
use crate::constraints::Constraints;
use crate::error::did_you_mean;

/// Maximum number of frequencies.
pub const MAX_POINTS: usize = 1_000_000;
/// Factor by which the range of frequencies extends beyond the slowest and the fastest motion.
const BEYOND: f64 = 10.0;
/// Prefix of the name of a force, before its coordinate. A parameter of such a name is a test force
/// that the derivation added to the scene.
pub const FORCE_ON: &str = "force on ";

/// Frequency response of an output to a harmonic input.
///
/// After transients have decayed, an input p + a Re(e^(j w t)) causes an output o + a Re(H(w) e^(j
/// w t)).
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Response {
    /// Name of the varied parameter, or of the coordinate on which a force acts.
    pub from: String,
    /// Its unit.
    pub from_unit: String,
    /// Name of the output or state.
    pub to: String,
    /// Its unit.
    pub to_unit: String,
    /// Angular frequencies w \[rad/s\].
    pub frequencies: Vec<f64>,
    /// |H| \[unit of `to` over unit of `from`\].
    pub amplitudes: Vec<f64>,
    /// arg H \[rad\], continuous over frequency; negative for a lag.
    pub phases: Vec<f64>,
}

impl Response {
    /// Returns the unit of the amplitudes: the unit of the output over that of the input.
    #[must_use]
    pub fn amplitude_unit(&self) -> String {
        match self.from_unit.as_str() {
            "1" => self.to_unit.clone(),
            unit if unit.contains([' ', '/', '*']) => format!("{}/({unit})", self.to_unit),
            unit => format!("{}/{unit}", self.to_unit),
        }
    }

    /// Writes a table: a header with units, then one line per frequency.
    ///
    /// # Errors
    /// Errors of `writer`.
    pub fn write_csv(&self, writer: impl io::Write) -> io::Result<()> {
        let mut csv = csv::Writer::from_writer(writer);
        let amplitude = format!("amplitude [{}]", self.amplitude_unit());
        csv.write_record(["frequency [rad/s]", &amplitude, "phase [rad]"])?;
        for index in 0..self.frequencies.len() {
            let line = [self.frequencies[index], self.amplitudes[index], self.phases[index]];
            csv.serialize(line)?;
        }
        csv.flush()
    }
}

/// Input of a response or of a state-space model.
pub(super) struct Input {
    pub name: String,
    pub unit: String,
    /// Derivative of y' by the input.
    pub rate: DVector<f64>,
    /// Index of the parameter; `None` for a force.
    pub parameter: Option<usize>,
}

impl Input {
    /// Returns name, unit and value at the operating point.
    pub fn signal(self, parameters: &[f64]) -> Signal {
        let value = self.parameter.map_or(0.0, |index| parameters[index]);
        Signal { name: self.name, unit: self.unit, value }
    }

    /// Creates the error for a force with feedthrough to an output.
    pub fn answers_at_once(&self, output: &str) -> LinearError {
        let coordinate = self.name.trim_start_matches(FORCE_ON).to_owned();
        LinearError::DirectFeedthrough { output: output.to_owned(), coordinate }
    }
}

/// Output of a response, with its derivatives by states and input.
struct Output {
    name: String,
    unit: String,
    by_state: DVector<f64>,
    by_input: f64,
}

/// A, b and C, with motions measured by their scales.
struct Scaled {
    matrix: DMatrix<f64>,
    rate: DVector<f64>,
    by_state: DVector<f64>,
}

impl Linearization<'_> {
    /// Returns H(w) = C (j w - A)^-1 b + d at given frequencies w.
    ///
    /// `from` names a parameter, b = dy'/dp, or a coordinate, for a generalized force on it, b =
    /// M^-1 e in the rows of q'. `to` names an output or a state. Derivatives C and d of outputs
    /// are exact to rounding. For a force d = 0: an output that contains accelerations or
    /// constraint forces, and so has feedthrough, is refused, unless the scene was derived with a
    /// test force on the coordinate ([`FORCE_ON`]).
    ///
    /// For a machine with constraints, b of a force is M^-1 (e + G^T lambda) with G b = 0, and A, b
    /// and C are those of the allowed motions.
    ///
    /// # Errors
    /// [`LinearError::UnknownName`] for names, [`LinearError::NotFinite`] for derivatives,
    /// [`LinearError::Singular`] at an undamped resonance, [`LinearError::MovesConstraint`] for a
    /// parameter that a constraint depends on, [`LinearError::DirectFeedthrough`] for a force with
    /// feedthrough to the output.
    pub fn response(
        &self,
        from: &str,
        to: &str,
        frequencies: &[f64],
    ) -> Result<Response, LinearError> {
        let input = self.input(from)?;
        let output = self.output(to, &input)?;
        let transfer = self.transfer(&input, &output)?;
        let values = frequencies.iter().map(|frequency| transfer.at(*frequency));
        let values = values.collect::<Result<Vec<Complex64>, _>>()?;
        Ok(Response {
            from: input.name,
            from_unit: input.unit,
            to: output.name,
            to_unit: output.unit,
            frequencies: frequencies.to_vec(),
            amplitudes: values.iter().map(|value| value.norm()).collect(),
            phases: continuous(values.iter().map(|value| value.arg())),
        })
    }

    /// Returns a range of frequencies \[rad/s\], from a tenth of the slowest to ten times the
    /// fastest motion of the machine; 0.1 to 10 if it has none.
    ///
    /// # Errors
    /// As for [`Linearization::modes`].
    pub fn range_of_interest(&self) -> Result<Range<f64>, LinearError> {
        let modes = self.modes()?;
        let sizes = modes.iter().filter(|mode| mode.kind != ModeKind::Free);
        let (low, high) = sizes
            .map(super::Mode::natural_frequency)
            .fold((f64::INFINITY, 0.0_f64), |(low, high), size| (low.min(size), high.max(size)));
        Ok(if high > 0.0 { low / BEYOND..high * BEYOND } else { 1.0 / BEYOND..BEYOND })
    }

    /// Returns the largest growth rate of an eigenmode \[1/s\], or `None` if none grows. Only in
    /// the latter case does the machine settle to a harmonic response.
    ///
    /// # Errors
    /// As for [`Linearization::modes`].
    pub fn growth(&self) -> Result<Option<f64>, LinearError> {
        let modes = self.modes()?;
        let growing = modes.iter().filter(|mode| mode.grows());
        Ok(growing.map(|mode| mode.real).reduce(f64::max))
    }

    /// Returns the input of a name: a parameter, or a force on a coordinate.
    pub(super) fn input(&self, name: &str) -> Result<Input, LinearError> {
        let shape = self.simulator.shape();
        let parameter =
            |name: &str| position(name, shape.parameters, |i| self.simulator.parameter(i));
        let found = parameter(name).or_else(|| parameter(&format!("{FORCE_ON}{name}")));
        if let Some(index) = found {
            let Quantity { name, unit, .. } = self.simulator.parameter(index);
            self.require_still_constraints(index)?;
            let (name, unit, rate) =
                (name.to_owned(), unit.to_owned(), self.parameter_column(index)?);
            return Ok(Input { name, unit, rate, parameter: Some(index) });
        }
        if let Some(index) = position(name, shape.coordinates, |i| self.simulator.coordinate(i)) {
            let rate = self.force_column(index)?;
            let unit = force_unit(self.simulator.coordinate(index).unit);
            let name = format!("{FORCE_ON}{name}");
            return Ok(Input { name, unit, rate, parameter: None });
        }
        let parameters = (0..shape.parameters).map(|index| self.simulator.parameter(index).name);
        let coordinates = (0..shape.coordinates).map(|index| self.simulator.coordinate(index).name);
        Err(LinearError::UnknownName {
            scene: self.simulator.name().to_owned(),
            kind: "parameter or coordinate",
            name: name.to_owned(),
            hint: did_you_mean(name, parameters.chain(coordinates)),
        })
    }

    /// Returns dy'/dp of one parameter.
    fn parameter_column(&self, index: usize) -> Result<DVector<f64>, LinearError> {
        let pattern = self.simulator.parameter_jacobian_pattern();
        let mut values = vec![0.0; pattern.entries.len()];
        let Point { time, state, parameters } = &self.point;
        self.simulator.parameter_jacobian(*time, state, parameters, &mut values);
        let mut column = DVector::zeros(pattern.rows);
        for ((row, entry), value) in pattern.entries.iter().zip(&values) {
            if *entry as usize == index {
                column[*row as usize] = *value;
            }
        }
        let what = "the derivative of a rate by the parameter";
        finite(what, column.as_slice())?;
        Ok(column)
    }

    /// Returns y' due to a unit force on one coordinate.
    fn force_column(&self, index: usize) -> Result<DVector<f64>, LinearError> {
        let n = self.simulator.shape().coordinates;
        let Point { time, state, parameters } = &self.point;
        let constraints = Constraints::of(self.simulator, parameters);
        let matrix = constraints.map(|constraints| constraints.matrix(*time, state));
        let matrix = matrix.unwrap_or_else(|| DMatrix::zeros(0, n));
        // Constraints that hold only in other modes have a row of zeros and no force.
        let holds = (0..matrix.nrows()).filter(|row| matrix.row(*row).amax() > 0.0);
        let matrix = matrix.select_rows(&holds.collect::<Vec<_>>());
        let m = matrix.nrows();
        // M a - G^T lambda = e, G a = 0
        let mut whole = DMatrix::zeros(n + m, n + m);
        whole.view_mut((0, 0), (n, n)).copy_from(&self.mass_matrix());
        whole.view_mut((0, n), (n, m)).copy_from(&-matrix.transpose());
        whole.view_mut((n, 0), (m, n)).copy_from(&matrix);
        let mut force = DVector::zeros(n + m);
        force[index] = 1.0;
        let what = if m == 0 { "the mass matrix" } else { "the mass matrix with constraints" };
        let solution = whole.lu().solve(&force).ok_or(LinearError::Singular { what })?;
        let acceleration = solution.rows(0, n);
        let mut column = DVector::zeros(self.matrix.rows());
        for (place, value) in Places::of(self.simulator).velocities.iter().zip(acceleration.iter())
        {
            column[*place] = *value;
        }
        Ok(column)
    }

    fn output(&self, name: &str, input: &Input) -> Result<Output, LinearError> {
        let states = self.matrix.rows();
        if let Some(index) = named_output(self.simulator, name) {
            if input.parameter.is_none() && self.simulator.output_answers_at_once(index) {
                return Err(input.answers_at_once(name));
            }
            let unit = self.simulator.output(index).unit.to_owned();
            let parameters: Vec<usize> = input.parameter.into_iter().collect();
            let slopes = output_slopes(self.simulator, &self.point, &parameters);
            let by_state = slopes.by_state.row(index).transpose();
            let by_input = slopes.by_parameters.row(index).iter().sum();
            let what = "the derivative of the output";
            finite(what, by_state.as_slice())?;
            finite(what, &[by_input])?;
            return Ok(Output { name: name.to_owned(), unit, by_state, by_input });
        }
        if let Some(index) = position(name, states, |i| self.simulator.state(i)) {
            let unit = self.simulator.state(index).unit.to_owned();
            let by_state = DVector::from_fn(states, |i, _| if i == index { 1.0 } else { 0.0 });
            return Ok(Output { name: name.to_owned(), unit, by_state, by_input: 0.0 });
        }
        Err(self.unknown_output(name))
    }

    /// Returns C of one output: its derivatives by the states, of length `states`.
    ///
    /// # Panics
    /// If there is no such output.
    #[must_use]
    pub fn output_derivatives(&self, output: usize) -> Vec<f64> {
        let slopes = output_slopes(self.simulator, &self.point, &[]);
        slopes.by_state.row(output).iter().copied().collect()
    }

    /// Refuses a parameter on which constraints depend: constrained parts would have to move with
    /// it, at its velocity and acceleration.
    fn require_still_constraints(&self, parameter: usize) -> Result<(), LinearError> {
        const ROUNDING: f64 = 1e-9;
        let count = self.simulator.constraints();
        let Point { time, state, parameters } = &self.point;
        let Some(constraints) = Constraints::of(self.simulator, parameters) else { return Ok(()) };
        let value = parameters[parameter];
        let size = if value == 0.0 { 1.0 } else { value.abs() };
        let slopes = derivative(size, 2 * count, |shift| {
            let mut parameters = parameters.clone();
            parameters[parameter] += shift;
            let mut values = vec![0.0; 2 * count];
            let (positions, rates) = values.split_at_mut(count);
            self.simulator.constraint_values(*time, state, &parameters, positions);
            self.simulator.constraint_rates(*time, state, &parameters, rates);
            values
        });
        let matrix = constraints.matrix(*time, state);
        let scales = scales(self.simulator);
        let moves = |index: &usize| {
            // The limit is relative to the change due to a typical move of all coordinates.
            let row = matrix.row(index % count);
            let first = if *index < count { 0 } else { row.len() };
            let usual = row.iter().enumerate().map(|(k, slope)| (slope * scales[first + k]).abs());
            slopes[*index].abs() * size > ROUNDING * usual.sum::<f64>()
        };
        match (0..2 * count).find(moves) {
            None => Ok(()),
            Some(index) => Err(LinearError::MovesConstraint {
                parameter: self.simulator.parameter(parameter).name.to_owned(),
                constraint: self.simulator.constraint(index % count).name.to_owned(),
            }),
        }
    }

    /// Returns A, b and C with motions measured by their scales; for a machine with constraints,
    /// those of the allowed motions.
    fn scaled(&self, input: &Input, output: &Output) -> Result<Scaled, LinearError> {
        let scales = scales(self.simulator);
        let by_scales =
            |row: usize, column: usize, entry: f64| entry * scales[column] / scales[row];
        let matrix = full(self.simulator, &self.matrix.clone().scaled(by_scales))?;
        let rate = input.rate.component_div(&scales);
        let by_state = output.by_state.component_mul(&scales);
        if self.simulator.constraints() == 0 {
            return Ok(Scaled { matrix, rate, by_state });
        }
        let motions = Motions::new(self.simulator, &self.matrix);
        let what = "the matrix of the constraints";
        let within = Within::of(self.simulator, &self.point, &motions);
        let within = within.ok_or(LinearError::Singular { what })?;
        let places = Places::of(self.simulator);
        let moving = [&places.positions[..], &places.dynamic()].concat();
        let rate = within.dual() * rate.select_rows(&moving);
        let by_state = within.basis().transpose() * by_state.select_rows(&moving);
        Ok(Scaled { matrix: within.motions(&motions).matrix.full(), rate, by_state })
    }

    fn transfer(&self, input: &Input, output: &Output) -> Result<Transfer, LinearError> {
        let Scaled { matrix, rate, by_state } = self.scaled(input, output)?;
        Ok(Transfer {
            negative: matrix.map(|value| Complex64::from(-value)),
            rate: rate.map(Complex64::from),
            by_state,
            by_input: output.by_input,
        })
    }

    /// Returns H of an input and an output, by their names.
    pub(super) fn transfer_of(&self, from: &str, to: &str) -> Result<Transfer, LinearError> {
        let input = self.input(from)?;
        let output = self.output(to, &input)?;
        self.transfer(&input, &output)
    }
}

/// H(w) = C (j w - A)^-1 b + d.
pub(super) struct Transfer {
    /// -A.
    negative: DMatrix<Complex64>,
    rate: DVector<Complex64>,
    by_state: DVector<f64>,
    by_input: f64,
}

impl Transfer {
    /// Returns H at a frequency \[rad/s\].
    pub fn at(&self, frequency: f64) -> Result<Complex64, LinearError> {
        // Without motions, as with a closed brake. nalgebra's solution reads beyond such matrices.
        if self.negative.is_empty() {
            return Ok(Complex64::from(self.by_input));
        }
        let mut matrix = self.negative.clone();
        for index in 0..matrix.nrows() {
            matrix[(index, index)] += Complex64::new(0.0, frequency);
        }
        let what = "j w - A, at an undamped resonance,";
        let state = matrix.lu().solve(&self.rate).ok_or(LinearError::Singular { what })?;
        let parts = state.iter().zip(&self.by_state).map(|(state, by_state)| state * *by_state);
        let answer = parts.sum::<Complex64>() + self.by_input;
        // A division by a number close to zero acts like a division by zero.
        if answer.is_finite() { Ok(answer) } else { Err(LinearError::Singular { what }) }
    }
}

/// Returns angular frequencies equally spaced in their logarithm, including both ends.
///
/// # Errors
/// [`LinearError::BadRange`] unless 0 < from < until, finite, and 2 to
/// `MAX_POINTS` points.
pub fn logarithmic_range(from: f64, until: f64, points: usize) -> Result<Vec<f64>, LinearError> {
    let is_range = from > 0.0 && from < until && until.is_finite();
    if !(is_range && (2..=MAX_POINTS).contains(&points)) {
        return Err(LinearError::BadRange { from, until, points });
    }
    let last = points - 1;
    let (low, span) = (from.ln(), until.ln() - from.ln());
    let frequency = |index: usize| match index {
        0 => from,
        _ if index == last => until,
        _ => (low + span * index as f64 / last as f64).exp(),
    };
    Ok((0..points).map(frequency).collect())
}

/// Returns the index of an output of a name.
pub(super) fn named_output(simulator: &dyn Simulator<f64>, name: &str) -> Option<usize> {
    position(name, simulator.shape().outputs, |index| simulator.output(index))
}

/// Returns all outputs.
pub(super) fn outputs(
    simulator: &dyn Simulator<f64>,
    time: f64,
    state: &[f64],
    parameters: &[f64],
) -> Vec<f64> {
    let mut outputs = vec![0.0; simulator.shape().outputs];
    simulator.outputs(time, state, parameters, &mut outputs);
    outputs
}

/// Refuses numbers that are not finite.
pub(super) fn finite(what: &str, values: &[f64]) -> Result<(), LinearError> {
    match values.iter().find(|value| !value.is_finite()) {
        None => Ok(()),
        Some(value) => Err(LinearError::NotFinite { what: what.to_owned(), value: *value }),
    }
}

/// Returns the unit of a generalized force on a coordinate: work over coordinate.
fn force_unit(coordinate: &str) -> String {
    match coordinate {
        "rad" | "1" => "N m".to_owned(),
        "m" => "N".to_owned(),
        "C" => "V".to_owned(),
        other => format!("J/({other})"),
    }
}

/// Returns angles without jumps of a whole turn; the first lies above -pi and up to pi.
fn continuous(angles: impl Iterator<Item = f64>) -> Vec<f64> {
    use std::f64::consts::TAU;
    let mut before = f64::NAN;
    let mut unwrapped = |angle: f64| {
        let turns = ((before - angle) / TAU).round();
        let angle = if turns.is_finite() { angle + turns * TAU } else { angle };
        before = angle;
        angle
    };
    angles.map(&mut unwrapped).collect()
}
