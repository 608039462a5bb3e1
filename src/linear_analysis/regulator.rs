//! Optimal regulators and state estimators of state-space models.

mod error;
mod riccati;

use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;
use serde::Serialize;

use super::LinearError;
use super::state_space::{
    Hidden, Matrices, Rows, Signal, StateSpace, eigenvalues_about, sort_poles, to_rows,
};
use crate::error::did_you_mean;
pub use error::RegulatorError;
use riccati::{Riccati, Time};

/// Maximum number of states of a design.
pub const MAX_STATES_OF_DESIGNS: usize = 300;

/// Size of a signal in its own unit: the deviation that costs 1 in a regulator, or the standard
/// deviation of noise in an estimator.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Weight {
    /// Name of an input or output of the model.
    pub name: String,
    /// The deviation, above 0, in the unit of the signal.
    pub deviation: f64,
}

/// Linear-quadratic regulator u = u0 - K (x - x0).
///
/// It minimizes the integral, or the sum over samples, of (y_i/w_i)^2 + (u_j/w_j)^2 over the
/// weighted outputs and inputs with deviations w.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Regulator {
    /// Names of the inputs that are controlled, the rows of K.
    pub inputs: Vec<String>,
    /// Names of the states, the columns of K.
    pub states: Vec<String>,
    /// K, in units of the inputs per unit of the states.
    pub gain: Rows,
    /// X of the Riccati equation; x^T X x is the cost that remains from a state on.
    pub cost: Rows,
    /// Eigenvalues of A - B K, as real and imaginary part.
    pub poles: Vec<[f64; 2]>,
}

/// Steady Kalman filter, an estimator of the state from measured outputs.
///
/// ```text
/// x' = A x + B u + L (y - C x - D u)                             continuous
/// x[k+1] = A x[k] + B u[k] + L (y[k] - C x[k] - D u[k])          sampled
/// x[k|k] = x[k] + M (y[k] - C x[k] - D u[k])
/// ```
///
/// Inputs with a deviation are disturbed by white noise, and so is each measured output. Of a
/// sampled model, deviations are standard deviations at each sample. Of a continuous one, they are
/// square roots of spectral densities, in the unit of the signal times the root of a second.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Estimator {
    /// Names of the measured outputs, the columns of L.
    pub outputs: Vec<String>,
    /// Names of the states, the rows of L.
    pub states: Vec<String>,
    /// L, in units of the states per unit of the outputs; per second if continuous.
    pub gain: Rows,
    /// M of a sampled model.
    pub innovation_gain: Option<Rows>,
    /// Covariance of the error of x before the measurement.
    pub covariance: Rows,
    /// Eigenvalues of A - L C, as real and imaginary part.
    pub poles: Vec<[f64; 2]>,
}

impl StateSpace {
    /// Returns the linear-quadratic regulator of the inputs that are weighted. Other inputs are
    /// left alone.
    ///
    /// # Errors
    /// [`RegulatorError`] for weights that do not fit the model, and if no regulator exists.
    pub fn lqr(&self, weights: &[Weight]) -> Result<Regulator, RegulatorError> {
        let design = Design::new(self, weights)?;
        let Sizes { inputs, matrices: Matrices { a, b, c, d }, states, .. } = &design.sizes;
        let riccati = Riccati {
            time: design.time(),
            q: c.tr_mul(c),
            r: DMatrix::identity(inputs.len(), inputs.len()) + d.tr_mul(d),
            n: c.tr_mul(d),
            a: a.clone(),
            b: b.clone(),
        };
        let solution = riccati.solve().ok_or_else(|| design.refused(Purpose::Regulate))?;
        let sized = |row: usize, column: usize| inputs[row] / states[column];
        let gain = solution.gain.map_with_location(|row, column, k| k * sized(row, column));
        let cost =
            solution.x.map_with_location(|row, column, x| x / (states[row] * states[column]));
        let poles = poles_of(&(a - b * &solution.gain), self)?;
        Ok(Regulator {
            inputs: names_of(&design.model.inputs),
            states: names_of(&design.model.states),
            gain: to_rows(&gain),
            cost: to_rows(&cost),
            poles,
        })
    }

    /// Returns the steady Kalman filter for noise on some inputs and on the measured outputs.
    ///
    /// # Errors
    /// [`RegulatorError`] for noise that does not fit the model, and if no filter exists.
    pub fn kalman(&self, noise: &[Weight]) -> Result<Estimator, RegulatorError> {
        let design = Design::new(self, noise)?;
        let Sizes { outputs, matrices: Matrices { a, b, c, d }, states, .. } = &design.sizes;
        // The dual problem; noise and measurements have size 1.
        let riccati = Riccati {
            time: design.time(),
            a: a.transpose(),
            b: c.transpose(),
            q: b * b.transpose(),
            r: DMatrix::identity(outputs.len(), outputs.len()) + d * d.transpose(),
            n: b * d.transpose(),
        };
        let solution = riccati.solve().ok_or_else(|| design.refused(Purpose::Estimate))?;
        let gain = solution.gain.transpose();
        let poles = poles_of(&(a - &gain * c), self)?;
        let sized = |matrix: &DMatrix<f64>| {
            to_rows(&matrix.map_with_location(|row, column, l| l * states[row] / outputs[column]))
        };
        let innovation = self.sampling.map(|_| {
            let seen = &solution.x * c.transpose();
            let spread = &riccati.r + c * &seen;
            spread.lu().solve(&seen.transpose()).map_or_else(DMatrix::default, |m| m.transpose())
        });
        let covariance =
            solution.x.map_with_location(|row, column, x| x * states[row] * states[column]);
        Ok(Estimator {
            outputs: names_of(&design.model.outputs),
            states: names_of(&design.model.states),
            gain: sized(&gain),
            innovation_gain: innovation.as_ref().map(sized),
            covariance: to_rows(&covariance),
            poles,
        })
    }

    /// Returns the model of some inputs and outputs, by their indices.
    #[must_use]
    pub fn part(&self, inputs: &[usize], outputs: &[usize]) -> Self {
        let columns = |rows: &Rows| -> Rows {
            rows.iter().map(|row| inputs.iter().map(|index| row[*index]).collect()).collect()
        };
        let rows = |rows: &Rows| -> Rows { outputs.iter().map(|i| rows[*i].clone()).collect() };
        Self {
            inputs: inputs.iter().map(|index| self.inputs[*index].clone()).collect(),
            outputs: outputs.iter().map(|index| self.outputs[*index].clone()).collect(),
            b: columns(&self.b),
            c: rows(&self.c),
            d: columns(&rows(&self.d)),
            ..self.clone()
        }
    }
}

/// Purpose of a design.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Purpose {
    Regulate,
    Estimate,
}

/// Model of the weighted inputs and outputs.
struct Design {
    model: StateSpace,
    sizes: Sizes,
}

/// Matrices with signals measured by their deviations and states by their sizes.
struct Sizes {
    inputs: Vec<f64>,
    outputs: Vec<f64>,
    states: DVector<f64>,
    matrices: Matrices,
}

impl Design {
    fn new(whole: &StateSpace, weights: &[Weight]) -> Result<Self, RegulatorError> {
        let states = whole.states.len();
        if states > MAX_STATES_OF_DESIGNS {
            return Err(RegulatorError::TooLarge { states });
        }
        for (index, weight) in weights.iter().enumerate() {
            check(whole, weight)?;
            if weights[..index].iter().any(|before| before.name == weight.name) {
                return Err(LinearError::DuplicateName {
                    kind: "signal",
                    name: weight.name.clone(),
                }
                .into());
            }
        }
        let of = |signals: &[Signal]| -> (Vec<usize>, Vec<f64>) {
            let weighted = signals.iter().enumerate().filter_map(|(index, signal)| {
                let weight = weights.iter().find(|weight| weight.name == signal.name)?;
                Some((index, weight.deviation))
            });
            weighted.unzip()
        };
        let ((inputs, of_inputs), (outputs, of_outputs)) = (of(&whole.inputs), of(&whole.outputs));
        if inputs.is_empty() {
            return Err(RegulatorError::NoInput);
        }
        if outputs.is_empty() {
            return Err(RegulatorError::NoOutput);
        }
        let model = whole.part(&inputs, &outputs);
        let (Matrices { a, mut b, mut c, mut d }, states) = model.balanced();
        for (index, deviation) in of_inputs.iter().enumerate() {
            b.column_mut(index).scale_mut(*deviation);
            d.column_mut(index).scale_mut(*deviation);
        }
        for (index, deviation) in of_outputs.iter().enumerate() {
            c.row_mut(index).unscale_mut(*deviation);
            d.row_mut(index).unscale_mut(*deviation);
        }
        let matrices = Matrices { a, b, c, d };
        let sizes = Sizes { inputs: of_inputs, outputs: of_outputs, states, matrices };
        Ok(Self { model, sizes })
    }

    fn time(&self) -> Time {
        if self.model.sampling.is_some() { Time::Sampled } else { Time::Continuous }
    }

    /// Returns the reason why there is no solution: an eigenmode that does not decay by itself and
    /// that inputs cannot move or outputs do not show.
    fn refused(&self, purpose: Purpose) -> RegulatorError {
        let lasting = |hidden: Result<Vec<Hidden>, LinearError>| {
            let hidden = hidden.unwrap_or_default();
            hidden.into_iter().find(|hidden| !self.decays(hidden))
        };
        let unmoved = || lasting(self.model.uncontrollable()).map(|found| self.model.named(&found));
        let unseen = || lasting(self.model.unobservable()).map(|found| self.model.named(&found));
        match purpose {
            Purpose::Regulate => unmoved()
                .map(|motion| RegulatorError::Unmoved { motion })
                .or_else(|| unseen().map(|motion| RegulatorError::Unweighted { motion })),
            Purpose::Estimate => unseen()
                .map(|motion| RegulatorError::Unmeasured { motion })
                .or_else(|| unmoved().map(|motion| RegulatorError::Undisturbed { motion })),
        }
        .unwrap_or(RegulatorError::Unsolved)
    }

    fn decays(&self, hidden: &Hidden) -> bool {
        /// Rate of decay, relative to the norm of A, that counts as none.
        const ROUNDING: f64 = 1e-12;
        let [real, imaginary] = hidden.pole;
        match self.time() {
            Time::Continuous => real < -ROUNDING * self.sizes.matrices.a.norm(),
            Time::Sampled => real.hypot(imaginary) < 1.0 - ROUNDING,
        }
    }
}

impl StateSpace {
    /// Describes an eigenmode by the largest shares: `cylinder.phi 77 %, driver.phi 23 %`.
    #[must_use]
    pub fn named(&self, hidden: &Hidden) -> String {
        const SHOWN: usize = 3;
        const MINOR: f64 = 0.02;
        let mut order: Vec<usize> = (0..hidden.shares.len()).collect();
        crate::sorting::sort_descending(&mut order, |index| (1e9 * hidden.shares[*index]).round());
        let major = order.into_iter().filter(|index| hidden.shares[*index] >= MINOR).take(SHOWN);
        let shown = major.map(|index| {
            format!("{} {:.0} %", self.states[index].name, 100.0 * hidden.shares[index])
        });
        shown.collect::<Vec<_>>().join(", ")
    }
}

fn names_of(signals: &[Signal]) -> Vec<String> {
    signals.iter().map(|signal| signal.name.clone()).collect()
}

/// Checks name and number of a weight.
fn check(model: &StateSpace, weight: &Weight) -> Result<(), RegulatorError> {
    let names = || model.inputs.iter().chain(&model.outputs).map(|signal| signal.name.as_str());
    if !names().any(|name| name == weight.name) {
        let hint = did_you_mean(&weight.name, names());
        return Err(RegulatorError::UnknownSignal { name: weight.name.clone(), hint });
    }
    if !(weight.deviation > 0.0 && weight.deviation.is_finite()) {
        let Weight { name, deviation } = weight.clone();
        return Err(RegulatorError::BadDeviation { name, deviation });
    }
    Ok(())
}

fn poles_of(closed: &DMatrix<f64>, model: &StateSpace) -> Result<Vec<[f64; 2]>, LinearError> {
    let one = if model.sampling.is_some() { 1.0 } else { 0.0 };
    let mut poles: Vec<Complex64> = eigenvalues_about(closed.clone(), one)?;
    sort_poles(&mut poles);
    Ok(poles.into_iter().map(|pole| [pole.re, pole.im]).collect())
}
