//! State-space models x' = A x + B u, y = C x + D u about a point, for the design of controllers.

mod discrete;
mod minimal;
mod poles;
mod reach;
mod zeros;

use nalgebra::{DMatrix, DVector};
use serde::Serialize;

use super::output_slopes::{OutputSlopes, output_slopes};
use super::response::{Input, finite, named_output, outputs};
use super::{LinearError, Linearization, full, position, rate, scales};
use crate::error::did_you_mean;
use minimal::Minimal;
pub(super) use poles::{eigenvalues_about, sort_poles};
pub use reach::Hidden;

/// Matrix as a list of its rows.
pub type Rows = Vec<Vec<f64>>;

/// State, input or output of a [`StateSpace`].
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Signal {
    /// Name in the scene; `force on NAME` for a generalized force on a coordinate.
    pub name: String,
    /// SI unit, or the unit of the output as written in the spec.
    pub unit: String,
    /// Value at the operating point, from which the linear model counts.
    pub value: f64,
}

/// Conversion of a continuous model to samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Hold {
    /// Inputs are constant between samples (zero-order hold): exact by the exponential of a matrix.
    Zoh,
    /// Bilinear (Tustin's) approximation s = 2 (z - 1)/(h (z + 1)). Its states are not samples of
    /// the continuous ones; inputs and outputs are.
    Tustin,
}

/// Sampling of a [`StateSpace`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Sampling {
    /// Time between samples h \[s\].
    pub period: f64,
    /// Conversion.
    pub hold: Hold,
}

/// Linear model of a machine about an operating point, in deviations from it:
///
/// ```text
/// x' = A x + B u,  y = C x + D u          x[k+1] = A x[k] + B u[k] if sampled
/// ```
///
/// The states are those of the scene without modes. Positions and velocities that constraints
/// determine are eliminated, including those of held brakes and sticking friction: x then
/// contains independent coordinates, and A, B and C refer to motions that the constraints allow.
/// Derivatives are exact to rounding.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StateSpace {
    /// x, of length n.
    pub states: Vec<Signal>,
    /// u, of length m.
    pub inputs: Vec<Signal>,
    /// y, of length p.
    pub outputs: Vec<Signal>,
    /// A, n by n.
    pub a: Rows,
    /// B, n by m.
    pub b: Rows,
    /// C, p by n.
    pub c: Rows,
    /// D, p by m.
    pub d: Rows,
    /// Time at the operating point \[s\].
    pub time: f64,
    /// x' at the operating point, in units of x per second; zero in equilibrium.
    pub drift: Vec<f64>,
    /// Names of states that constraints determine and that x therefore leaves out.
    pub eliminated: Vec<String>,
    /// Sampling; `None` for a continuous model.
    pub sampling: Option<Sampling>,
    /// Typical sizes of x, which measure what is negligible.
    #[serde(skip)]
    pub(super) scales: Vec<f64>,
}

impl Linearization<'_> {
    /// Returns the state-space model from some inputs to some outputs.
    ///
    /// An input is a parameter, or a coordinate for a generalized force on it. An output is an
    /// output of the scene or a state.
    ///
    /// # Errors
    /// [`LinearError::UnknownName`] for names, [`LinearError::DuplicateName`] for a name given twice,
    /// [`LinearError::NotFinite`] for derivatives, [`LinearError::MovesConstraint`] for a parameter
    /// that a constraint depends on, [`LinearError::DirectFeedthrough`] for a force on a coordinate with
    /// feedthrough to an output, [`LinearError::TooLarge`] for more than
    /// [`MAX_STATES`](super::MAX_STATES) states.
    pub fn state_space(
        &self,
        inputs: &[impl AsRef<str>],
        outputs: &[impl AsRef<str>],
    ) -> Result<StateSpace, LinearError> {
        let (simulator, point) = (self.simulator, &self.point);
        require_once("input", inputs)?;
        require_once("output", outputs)?;
        let inputs = inputs.iter().map(|name| self.input(name.as_ref()));
        let inputs = inputs.collect::<Result<Vec<Input>, _>>()?;
        let parameters: Vec<usize> = inputs.iter().filter_map(|input| input.parameter).collect();
        let slopes = output_slopes(simulator, point, &parameters);
        let minimal = Minimal::of(simulator, point)?;
        let jacobian = full(simulator, &self.matrix)?;
        let rates = DMatrix::from_fn(jacobian.nrows(), inputs.len(), |row, column| {
            inputs[column].rate[row]
        });
        let outputs = outputs.iter().map(|name| self.read(name.as_ref(), &inputs, &slopes));
        let outputs = outputs.collect::<Result<Vec<Read>, _>>()?;
        let states = jacobian.nrows();
        let by_state = DMatrix::from_fn(outputs.len(), states, |row, at| outputs[row].by_state[at]);
        let value = |index: &usize| Signal {
            name: simulator.state(*index).name.to_owned(),
            unit: simulator.state(*index).unit.to_owned(),
            value: point.state[*index] + 0.0,
        };
        let (whole, scales) = (rate(simulator, point), scales(simulator));
        Ok(StateSpace {
            states: minimal.states.iter().map(value).collect(),
            a: to_rows(&minimal.reduced(&jacobian)),
            b: to_rows(&rates.select_rows(&minimal.states)),
            c: to_rows(&minimal.seen(&by_state)),
            d: outputs.iter().map(|output| output.by_input.clone()).collect(),
            inputs: inputs.into_iter().map(|input| input.signal(&point.parameters)).collect(),
            outputs: outputs.into_iter().map(|output| output.signal).collect(),
            time: point.time,
            // Rates of -0 are 0.
            drift: minimal.states.iter().map(|index| whole[*index] + 0.0).collect(),
            eliminated: minimal.eliminated(simulator),
            sampling: None,
            scales: minimal.states.iter().map(|index| scales[*index]).collect(),
        })
    }

    /// Returns an output or state with its derivatives by state and inputs.
    fn read(
        &self,
        name: &str,
        inputs: &[Input],
        slopes: &OutputSlopes,
    ) -> Result<Read, LinearError> {
        let (simulator, point) = (self.simulator, &self.point);
        let states = simulator.shape().states();
        let Some(index) = named_output(simulator, name) else {
            let index = position(name, states, |index| simulator.state(index));
            let index = index.ok_or_else(|| self.unknown_output(name))?;
            let signal = Signal {
                name: name.to_owned(),
                unit: simulator.state(index).unit.to_owned(),
                value: point.state[index],
            };
            let mut by_state = DVector::zeros(states);
            by_state[index] = 1.0;
            return Ok(Read { signal, by_state, by_input: vec![0.0; inputs.len()] });
        };
        let through = slopes.by_parameters.row(index);
        let mut columns = through.iter();
        let mut by_input = Vec::with_capacity(inputs.len());
        for input in inputs {
            by_input.push(match input.parameter {
                Some(_) => columns.next().copied().unwrap_or(f64::NAN),
                None if simulator.output_answers_at_once(index) => {
                    return Err(input.answers_at_once(name));
                }
                None => 0.0,
            });
        }
        let by_state = slopes.by_state.row(index).transpose();
        let what = "the derivative of the output";
        finite(what, by_state.as_slice())?;
        finite(what, &by_input)?;
        let values = outputs(simulator, point.time, &point.state, &point.parameters);
        let unit = simulator.output(index).unit.to_owned();
        let signal = Signal { name: name.to_owned(), unit, value: values[index] };
        Ok(Read { signal, by_state, by_input })
    }

    /// Creates the error for a name that is neither an output nor a state.
    pub(super) fn unknown_output(&self, name: &str) -> LinearError {
        let shape = self.simulator.shape();
        let outputs = (0..shape.outputs).map(|index| self.simulator.output(index).name);
        let states = (0..shape.states()).map(|index| self.simulator.state(index).name);
        LinearError::UnknownName {
            scene: self.simulator.name().to_owned(),
            kind: "output or state",
            name: name.to_owned(),
            hint: did_you_mean(name, outputs.chain(states)),
        }
    }
}

/// Output with its derivatives by the whole state and by the inputs.
struct Read {
    signal: Signal,
    by_state: DVector<f64>,
    by_input: Vec<f64>,
}

/// Refuses names that are given twice.
fn require_once<S: AsRef<str>>(kind: &'static str, names: &[S]) -> Result<(), LinearError> {
    let twice = names.iter().enumerate().find(|(index, name)| {
        names[..*index].iter().any(|before| before.as_ref() == name.as_ref())
    });
    match twice {
        None => Ok(()),
        Some((_, name)) => Err(LinearError::DuplicateName { kind, name: name.as_ref().to_owned() }),
    }
}

/// Returns the rows of a matrix.
pub(super) fn to_rows(matrix: &DMatrix<f64>) -> Rows {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}

/// Returns the matrix of some rows. The number of columns is given for matrices without rows.
pub(super) fn of_rows(rows: &[Vec<f64>], columns: usize) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), columns, |row, column| rows[row][column])
}

/// A, B, C and D as matrices.
#[derive(Debug, Clone)]
pub(super) struct Matrices {
    pub a: DMatrix<f64>,
    pub b: DMatrix<f64>,
    pub c: DMatrix<f64>,
    pub d: DMatrix<f64>,
}

impl StateSpace {
    /// Creates a model from its matrices, about zero, with states `x1`, inputs `u1`, outputs `y1`
    /// and so on, without units. It is sampled by [`Hold::Zoh`] if there is a period \[s\].
    ///
    /// # Errors
    /// [`LinearError::Shape`] for rows of other lengths than those of A (n by n), B (n by m), C (p
    /// by n) and D (p by m), [`LinearError::NotFinite`] for numbers, [`LinearError::BadPeriod`] for
    /// a period that is not positive.
    pub fn of_matrices([a, b, c, d]: [Rows; 4], period: Option<f64>) -> Result<Self, LinearError> {
        let (n, p) = (a.len(), c.len());
        let m = b.first().or(d.first()).map_or(0, Vec::len);
        let shapes = [("A", &a, n, n), ("B", &b, n, m), ("C", &c, p, n), ("D", &d, p, m)];
        for (name, rows, height, width) in shapes {
            if rows.len() != height || rows.iter().any(|row| row.len() != width) {
                return Err(LinearError::Shape { matrix: name, rows: height, columns: width });
            }
            rows.iter().try_for_each(|row| finite(name, row))?;
        }
        if let Some(period) = period.filter(|period| !(*period > 0.0 && period.is_finite())) {
            return Err(LinearError::BadPeriod { period });
        }
        let signals = |letter: char, count: usize| -> Vec<Signal> {
            let signal = |number| Signal {
                name: format!("{letter}{number}"),
                unit: "1".to_owned(),
                value: 0.0,
            };
            (1..=count).map(signal).collect()
        };
        Ok(Self {
            states: signals('x', n),
            inputs: signals('u', m),
            outputs: signals('y', p),
            time: 0.0,
            drift: vec![0.0; n],
            eliminated: Vec::new(),
            sampling: period.map(|period| Sampling { period, hold: Hold::Zoh }),
            scales: vec![1.0; n],
            a,
            b,
            c,
            d,
        })
    }

    /// Returns the matrices of the model.
    pub(super) fn matrices(&self) -> Matrices {
        let (n, m) = (self.states.len(), self.inputs.len());
        Matrices {
            a: of_rows(&self.a, n),
            b: of_rows(&self.b, m),
            c: of_rows(&self.c, n),
            d: of_rows(&self.d, m),
        }
    }

    /// Returns the matrices with states measured by their scales and balanced, and the size of
    /// each state: x = size times the state of these matrices.
    pub(super) fn balanced(&self) -> (Matrices, DVector<f64>) {
        let Matrices { a, mut b, mut c, d } = self.matrices();
        let mut sizes = DVector::from_column_slice(&self.scales);
        let mut a = DMatrix::from_fn(a.nrows(), a.ncols(), |row, column| {
            a[(row, column)] * sizes[column] / sizes[row]
        });
        if !a.is_empty() {
            sizes.component_mul_assign(&crate::dense::balance(&mut a));
        }
        for (index, size) in sizes.iter().enumerate() {
            b.row_mut(index).apply(|entry| *entry /= size);
            c.column_mut(index).apply(|entry| *entry *= size);
        }
        (Matrices { a, b, c, d }, sizes)
    }
}
