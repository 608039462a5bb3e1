//! Parameters of a machine from measured runs, by least squares with exact derivatives.
//!
//! Residuals are what a run is off what was measured, output by output and sample by sample,
//! each over the output's scale; their derivatives are the sensitivities of the run
//! ([`Simulation::sensitivities`]). Unknowns are searched for on a logarithmic scale where
//! their bounds are positive, else over their size.

mod findings;
mod least_squares;
mod rounds;
mod statistics;

use std::sync::atomic::AtomicBool;

use nalgebra::{DMatrix, DVector};

use crate::error::{SimulateError, StopCause};
use crate::simulate::Simulation;
use crate::trajectory::Trajectory;

pub use findings::{Combination, Findings, FoundParameter, OutputResidual};
pub use least_squares::{End, Evaluation, Found, Loss, Search, least_squares};
pub use rounds::{Fitted, Plan, Unsolved, scale_of, steps_of};
pub use statistics::{Chance, Direction, Statistics, chance, statistics, students_t};

/// A parameter, or the initial value of a state, to be found.
#[derive(Debug, Clone, PartialEq)]
pub struct Unknown {
    /// Its name.
    pub name: String,
    /// Where the search starts.
    pub start: f64,
    /// Least and greatest value; infinite where there is none.
    pub bounds: (f64, f64),
}

impl Unknown {
    /// From a value; from the middle of the bounds where it lies beyond them.
    #[must_use]
    pub fn from(name: &str, value: f64, bounds: Option<(f64, f64)>) -> Self {
        let bounds = bounds.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        let (low, high) = bounds;
        let is_within = (low..=high).contains(&value);
        let middle = if low > 0.0 { (low * high).sqrt() } else { 0.5 * (low + high) };
        let start = if is_within { value } else { middle };
        Self { name: name.to_owned(), start, bounds }
    }

    /// Whether it is searched for by its logarithm.
    #[must_use]
    pub fn is_logarithmic(&self) -> bool {
        self.bounds.0 > 0.0 && self.bounds.1 > 0.0
    }

    /// What changes of it are measured by where it is not logarithmic.
    fn size(&self) -> f64 {
        let (low, high) = self.bounds;
        let span = if (high - low).is_finite() { high - low } else { 0.0 };
        match self.start.abs() {
            0.0 if span > 0.0 => span,
            0.0 => 1.0,
            size => size,
        }
    }

    /// Where a search starts, as it knows it.
    pub(crate) fn inner_start(&self) -> f64 {
        self.inner(self.start)
    }

    /// Bounds, likewise.
    pub(crate) fn inner_bounds(&self) -> (f64, f64) {
        (self.inner(self.bounds.0), self.inner(self.bounds.1))
    }

    pub(crate) fn inner(&self, value: f64) -> f64 {
        if self.is_logarithmic() { value.ln() } else { value / self.size() }
    }

    /// The value that the search knows as `inner`.
    #[must_use]
    pub fn outer(&self, inner: f64) -> f64 {
        let value = if self.is_logarithmic() { inner.exp() } else { inner * self.size() };
        value.clamp(self.bounds.0, self.bounds.1)
    }

    /// d outer/d inner.
    #[must_use]
    pub fn slope(&self, value: f64) -> f64 {
        if self.is_logarithmic() { value } else { self.size() }
    }
}

/// What was measured in one run.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// When, ascending and not before the start of the run \[s\].
    pub times: Vec<f64>,
    /// Outputs or states by name, with a value for each time; NaN where there is none.
    pub columns: Vec<(String, Vec<f64>)>,
}

/// A fit to be made.
pub struct Fit<'a> {
    /// The run without what is fitted: parameters, start, method, tolerance.
    pub simulation: &'a Simulation<'a>,
    /// What is looked for.
    pub unknowns: &'a [Unknown],
    /// Measured runs, all from the same start.
    pub measured: &'a [Measured],
}

/// The given start, then others spread evenly within bounds, by multiples of powers of the root
/// of x^(n+1) = x + 1 (the R sequence of M. Roberts); what has no bounds stays.
#[must_use]
pub fn spread_starts(first: &[f64], bounds: &[(f64, f64)], count: usize) -> Vec<Vec<f64>> {
    let n = first.len();
    let root = (0..64).fold(2.0_f64, |x, _| (1.0 + x).powf(1.0 / (n as f64 + 1.0)));
    let spread = |index: usize| {
        let inner = |k: usize| {
            let (low, high) = bounds[k];
            let share = (0.5 + index as f64 * root.powi(-(k as i32 + 1))).fract();
            if (high - low).is_finite() { low + share * (high - low) } else { first[k] }
        };
        (0..n).map(inner).collect::<Vec<f64>>()
    };
    std::iter::once(first.to_vec()).chain((1..count).map(spread)).collect()
}

impl Fit<'_> {
    /// Names of what was measured, each once.
    #[must_use]
    pub fn outputs(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for (name, _) in self.measured.iter().flat_map(|measured| &measured.columns) {
            if !names.contains(&name.as_str()) {
                names.push(name);
            }
        }
        names
    }

    /// Where the search starts, as it knows it.
    #[must_use]
    pub fn start(&self) -> Vec<f64> {
        self.unknowns.iter().map(Unknown::inner_start).collect()
    }

    /// Bounds, as the search knows them.
    #[must_use]
    pub fn bounds(&self) -> Vec<(f64, f64)> {
        self.unknowns.iter().map(Unknown::inner_bounds).collect()
    }

    /// Values of the unknowns.
    #[must_use]
    pub fn values(&self, inner: &[f64]) -> Vec<f64> {
        self.unknowns.iter().zip(inner).map(|(unknown, inner)| unknown.outer(*inner)).collect()
    }

    /// The run of one measurement at these values, sampled where it was measured, and at its
    /// start in front of that.
    ///
    /// # Errors
    /// As [`Simulation::run`].
    pub fn run(
        &self,
        measured: &Measured,
        values: &[f64],
        with_sensitivities: bool,
    ) -> Result<Trajectory, SimulateError> {
        let mut simulation = self.simulation.clone();
        for (unknown, value) in self.unknowns.iter().zip(values) {
            simulation = simulation.given(&unknown.name, *value)?;
        }
        let from = simulation.start_time();
        let until = measured.times.last().copied().unwrap_or(from);
        let times: Vec<f64> = std::iter::once(from).chain(measured.times.iter().copied()).collect();
        simulation = simulation.until(until).times(&times);
        if with_sensitivities {
            let names: Vec<&str> = self.unknowns.iter().map(|unknown| &*unknown.name).collect();
            simulation = simulation.sensitivities(&names)?;
        }
        simulation.run()
    }

    /// Residuals, over the scale of each output, and their derivatives by what the search knows.
    ///
    /// # Errors
    /// Why a run stopped, or gave what is no number.
    pub fn evaluate(
        &self,
        inner: &[f64],
        scale_of: &dyn Fn(&str) -> f64,
    ) -> Result<Evaluation, FitError> {
        let values = self.values(inner);
        let (mut residuals, mut rows) = (Vec::new(), Vec::new());
        for measured in self.measured {
            let run = self.run(measured, &values, true)?;
            for (name, data) in &measured.columns {
                let scale = scale_of(name);
                let found = run.column(name).unwrap_or_default();
                let slopes: Vec<&[f64]> = self
                    .unknowns
                    .iter()
                    .map(|unknown| run.sensitivity(name, &unknown.name).unwrap_or_default())
                    .collect();
                // The first row of the run is its start.
                let samples = data.iter().zip(found.iter().skip(1)).enumerate();
                for (row, (data, found)) in samples.filter(|(_, (data, _))| !data.is_nan()) {
                    residuals.push((found - data) / scale);
                    for ((unknown, value), slopes) in self.unknowns.iter().zip(&values).zip(&slopes)
                    {
                        rows.push(slopes[row + 1] * unknown.slope(*value) / scale);
                    }
                }
            }
        }
        if !residuals.iter().chain(&rows).all(|value| value.is_finite()) {
            return Err(FitError::NotFinite);
        }
        Ok(Evaluation {
            jacobian: DMatrix::from_row_slice(residuals.len(), self.unknowns.len(), &rows),
            residuals: DVector::from_vec(residuals),
        })
    }

    /// Searches from a start, as the search knows it.
    ///
    /// # Errors
    /// Why nothing could be evaluated at the start.
    pub fn search(
        &self,
        start: &[f64],
        scale_of: &dyn Fn(&str) -> f64,
        (loss, most): (Loss, usize),
        interrupt: Option<&AtomicBool>,
        mut watch: impl FnMut(&Evaluation),
    ) -> Result<Found, String> {
        let evaluate = |inner: &[f64]| {
            let evaluation = self.evaluate(inner, scale_of).map_err(|error| error.to_string())?;
            watch(&evaluation);
            Ok(evaluation)
        };
        let bounds = self.bounds();
        least_squares(evaluate, start, &Search { bounds: &bounds, loss, most, interrupt })
    }

    /// Residuals of every measured column in the order of time, as they stand in an evaluation.
    #[must_use]
    pub fn residuals_by_column<'e>(&self, evaluation: &'e Evaluation) -> Vec<(&str, &'e [f64])> {
        let mut rest = evaluation.residuals.as_slice();
        let mut all = Vec::new();
        for (name, data) in self.measured.iter().flat_map(|measured| &measured.columns) {
            let count = data.iter().filter(|value| !value.is_nan()).count();
            let (own, others) = rest.split_at(count);
            all.push((name.as_str(), own));
            rest = others;
        }
        all
    }
}

/// Why residuals could not be evaluated.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FitError {
    /// The run was refused or stopped.
    #[error(transparent)]
    Simulate(#[from] SimulateError),
    /// What is compared, or a derivative of it, is no number.
    #[error("an output that is compared, or its derivative, is not a finite number")]
    NotFinite,
}

impl FitError {
    /// Whether somebody has asked to stop.
    #[must_use]
    pub fn is_interrupted(&self) -> bool {
        matches!(self, Self::Simulate(SimulateError::Stopped { cause: StopCause::Interrupted, .. }))
    }
}
