//! Estimation of parameters from measured runs, by least squares with exact derivatives.
//!
//! Residuals are the differences of a run and its measurement, output by output and sample by
//! sample, divided by the output's scale. Their derivatives are the sensitivities of the run
//! ([`Simulation::sensitivities`]). The search uses the logarithm of an unknown if its bounds are
//! positive, otherwise its ratio to a typical size.

mod experiment;
mod findings;
mod least_squares;
mod profile;
mod rounds;
mod statistics;
mod threads;

use std::sync::atomic::AtomicBool;

use nalgebra::{DMatrix, DVector};

use crate::error::{SimulateError, StopCause};
use crate::simulate::Simulation;
use crate::trajectory::Trajectory;

pub use experiment::{Experiment, Measured, Noise};
pub use findings::{Combination, Findings, FoundParameter, OutputResidual};
pub use least_squares::{End, Evaluation, Found, Loss, Search, least_squares};
pub use profile::{Profile, ProfilePoint};
pub use rounds::{Fitted, Plan, Unsolved, scale_of};
pub use statistics::{Chance, Direction, Statistics, chance, statistics, students_t};
#[cfg(feature = "sweep")]
pub use threads::Lender;

/// Bounds of an unknown, in its unit; infinite where there are none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Lower bound.
    pub low: f64,
    /// Upper bound.
    pub high: f64,
}

impl Bounds {
    /// No bounds.
    pub const NONE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };
}

/// A parameter or the initial value of a state to be estimated.
#[derive(Debug, Clone, PartialEq)]
pub struct Unknown {
    /// Name of the parameter or state.
    pub name: String,
    /// Start of the search.
    pub start: f64,
    /// Lower and upper bound; infinite where there is none.
    pub bounds: Bounds,
}

impl Unknown {
    /// Creates an unknown that starts at `value`, or at the middle of the bounds if `value` lies
    /// beyond them.
    #[must_use]
    pub fn from(name: &str, value: f64, bounds: Option<Bounds>) -> Self {
        let bounds = bounds.unwrap_or(Bounds::NONE);
        let Bounds { low, high } = bounds;
        let is_within = (low..=high).contains(&value);
        let middle = if low > 0.0 { (low * high).sqrt() } else { 0.5 * (low + high) };
        let start = if is_within { value } else { middle };
        Self { name: name.to_owned(), start, bounds }
    }

    /// Returns whether the search uses the logarithm of the unknown.
    #[must_use]
    pub fn is_logarithmic(&self) -> bool {
        self.bounds.low > 0.0 && self.bounds.high > 0.0
    }

    /// Returns the unit of change of an unknown that is not logarithmic.
    fn size(&self) -> f64 {
        let Bounds { low, high } = self.bounds;
        let span = if (high - low).is_finite() { high - low } else { 0.0 };
        match self.start.abs() {
            0.0 if span > 0.0 => span,
            0.0 => 1.0,
            size => size,
        }
    }

    /// Returns the start in the coordinate of the search.
    pub(crate) fn inner_start(&self) -> f64 {
        self.inner(self.start)
    }

    /// Returns the bounds in the coordinate of the search.
    pub(crate) fn inner_bounds(&self) -> Bounds {
        Bounds { low: self.inner(self.bounds.low), high: self.inner(self.bounds.high) }
    }

    pub(crate) fn inner(&self, value: f64) -> f64 {
        if self.is_logarithmic() { value.ln() } else { value / self.size() }
    }

    /// Returns the value at the search coordinate `inner`.
    #[must_use]
    pub fn outer(&self, inner: f64) -> f64 {
        let value = if self.is_logarithmic() { inner.exp() } else { inner * self.size() };
        value.clamp(self.bounds.low, self.bounds.high)
    }

    /// Returns d outer/d inner.
    #[must_use]
    pub fn slope(&self, value: f64) -> f64 {
        if self.is_logarithmic() { value } else { self.size() }
    }
}

/// A parameter estimation problem.
///
/// The stiffness of a spring is found from measured angles, here from those of a run:
///
/// ```
/// use machinist::fit::{Bounds, Experiment, Fit, Measured, Plan, Unknown};
/// use machinist::{Method, Simulation};
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/oscillator.rs"));
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
///
/// let simulation = Simulation::new(&Oscillator).method(Method::Dop853).until(3.0);
/// let measured = simulation.clone().parameter("rotor.stiffness", 42.0)?.points(31).run()?;
/// let angles = measured.column("rotor.angle").expect("a state").to_vec();
/// let columns = vec![("rotor.angle".to_owned(), angles)];
/// let data = [Experiment::new("run 1", Measured { times: measured.times, columns })];
///
/// let unknowns = [Unknown::from("rotor.stiffness", 60.0, Some(Bounds { low: 10.0, high: 200.0 }))];
/// let fit = Fit::new(&simulation, &unknowns, &data);
/// let fitted = fit.solve(&Plan::default(), &mut |_, _| ())?;
/// let found = fit.findings(&fitted);
/// assert!((found.parameters[0].value - 42.0).abs() < 1e-5);
/// # Ok(())
/// # }
/// ```
///
/// Data that do not determine a parameter are reported. A torque that begins after the last
/// measurement has no standard error:
///
/// ```
/// use machinist::fit::{Bounds, Experiment, Fit, Measured, Plan, Unknown};
/// use machinist::{Method, Simulation};
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/oscillator.rs"));
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
///
/// let simulation = Simulation::new(&Oscillator).method(Method::Dop853);
/// let times = vec![0.1, 0.2, 0.3, 0.4];
/// let columns = vec![("rotor.angle".to_owned(), vec![0.35, 0.21, 0.02, -0.16])];
/// let data = [Experiment::new("before the torque", Measured { times, columns })];
/// let unknowns = [
///     Unknown::from("rotor.angle", 0.4, None),
///     Unknown::from("torque", 30.0, Some(Bounds { low: 1.0, high: 100.0 })),
/// ];
/// let fit = Fit::new(&simulation, &unknowns, &data);
/// let found = fit.findings(&fit.solve(&Plan::default(), &mut |_, _| ())?);
/// assert!(found.parameters[0].standard_error.is_some());
/// assert!(found.parameters[1].standard_error.is_none());
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy)]
pub struct Fit<'a> {
    /// The run with all settings that are not fitted: parameters, start, method, tolerance.
    pub simulation: &'a Simulation<'a>,
    /// Unknowns.
    pub unknowns: &'a [Unknown],
    /// Measured runs, each with its differences from the simulation.
    pub experiments: &'a [Experiment],
    #[cfg(feature = "sweep")]
    lender: Option<threads::Lender<'a>>,
}

/// Returns `first`, then other starts spread evenly within the bounds, by multiples of powers of
/// the root of x^(n+1) = x + 1 (the R sequence of M. Roberts). Unknowns without bounds keep their
/// first value.
#[must_use]
pub fn spread_starts(first: &[f64], bounds: &[Bounds], count: usize) -> Vec<Vec<f64>> {
    let n = first.len();
    let root = (0..64).fold(2.0_f64, |x, _| (1.0 + x).powf(1.0 / (n as f64 + 1.0)));
    let spread = |index: usize| {
        let inner = |k: usize| {
            let Bounds { low, high } = bounds[k];
            let share = (0.5 + index as f64 * root.powi(-(k as i32 + 1))).fract();
            if (high - low).is_finite() { low + share * (high - low) } else { first[k] }
        };
        (0..n).map(inner).collect::<Vec<f64>>()
    };
    std::iter::once(first.to_vec()).chain((1..count).map(spread)).collect()
}

impl<'a> Fit<'a> {
    /// Creates a fit that runs on this thread.
    #[must_use]
    pub fn new(
        simulation: &'a Simulation<'a>,
        unknowns: &'a [Unknown],
        experiments: &'a [Experiment],
    ) -> Self {
        Self {
            simulation,
            unknowns,
            experiments,
            #[cfg(feature = "sweep")]
            lender: None,
        }
    }

    /// Returns the names of measured quantities, each once.
    #[must_use]
    pub fn outputs(&self) -> Vec<&'a str> {
        let mut names: Vec<&str> = Vec::new();
        for (_, name, _) in self.columns() {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// Returns the measured columns with their experiments.
    fn columns(&self) -> impl Iterator<Item = (&'a Experiment, &'a str, &'a [f64])> + use<'a> {
        self.experiments.iter().flat_map(|experiment| {
            let columns = experiment.measured.columns.iter();
            columns.map(move |(name, values)| (experiment, name.as_str(), values.as_slice()))
        })
    }

    /// Returns the start of the search, in its coordinates.
    #[must_use]
    pub fn start(&self) -> Vec<f64> {
        self.unknowns.iter().map(Unknown::inner_start).collect()
    }

    /// Returns the bounds in the coordinates of the search.
    #[must_use]
    pub fn bounds(&self) -> Vec<Bounds> {
        self.unknowns.iter().map(Unknown::inner_bounds).collect()
    }

    /// Returns the values of the unknowns at search coordinates.
    #[must_use]
    pub fn values(&self, inner: &[f64]) -> Vec<f64> {
        self.unknowns.iter().zip(inner).map(|(unknown, inner)| unknown.outer(*inner)).collect()
    }

    /// Returns the simulation with the settings of an experiment.
    ///
    /// # Errors
    /// An unknown name of a parameter or state, with the nearest known one.
    pub fn simulation_of(&self, experiment: &Experiment) -> Result<Simulation<'a>, SimulateError> {
        let mut simulation = self.simulation.clone();
        for (name, value) in &experiment.given {
            simulation = match simulation.clone().given(name, *value) {
                // Modes can be set, although they cannot be differentiated by.
                Err(SimulateError::NotDifferentiable { .. }) => {
                    simulation.initial_value(name, *value)?
                }
                other => other?,
            };
        }
        Ok(experiment.from.into_iter().fold(simulation, Simulation::from))
    }

    /// Runs one experiment at these values, with output at its start and then at these times.
    ///
    /// # Errors
    /// As for [`Simulation::run`].
    pub fn run(
        &self,
        experiment: &Experiment,
        values: &[f64],
        times: &[f64],
        with_sensitivities: bool,
    ) -> Result<Trajectory, SimulateError> {
        let mut simulation = self.simulation_of(experiment)?;
        for (unknown, value) in self.unknowns.iter().zip(values) {
            simulation = simulation.given(&unknown.name, *value)?;
        }
        let from = simulation.start_time();
        let until = times.last().copied().unwrap_or(from);
        let times: Vec<f64> = std::iter::once(from).chain(times.iter().copied()).collect();
        simulation = simulation.until(until).times(&times);
        if with_sensitivities {
            let names: Vec<&str> = self.unknowns.iter().map(|unknown| &*unknown.name).collect();
            simulation = simulation.sensitivities(&names)?;
        }
        simulation.run()
    }

    /// Computes the residuals, over the scale of each output, and their derivatives by the search
    /// coordinates.
    ///
    /// # Errors
    /// [`FitError`] if a run stopped or gave a value that is not finite.
    pub fn evaluate(
        &self,
        inner: &[f64],
        scale_of: &(dyn Fn(&str) -> f64 + Sync),
    ) -> Result<Evaluation, FitError> {
        let values = self.values(inner);
        let compared = self.each(self.experiments.len(), |fit, number| {
            fit.compared(&fit.experiments[number], &values, scale_of)
        });
        let (mut residuals, mut rows) = (Vec::new(), Vec::new());
        for (experiment, compared) in self.experiments.iter().zip(compared) {
            let (own, own_rows) = compared.map_err(|why| self.of_experiment(experiment, why))?;
            residuals.extend(own);
            rows.extend(own_rows);
        }
        Ok(Evaluation {
            jacobian: DMatrix::from_row_slice(residuals.len(), self.unknowns.len(), &rows),
            residuals: DVector::from_vec(residuals),
        })
    }

    /// Computes the residuals of one experiment, and their derivatives row by row.
    fn compared(
        &self,
        experiment: &Experiment,
        values: &[f64],
        scale_of: &dyn Fn(&str) -> f64,
    ) -> Result<(Vec<f64>, Vec<f64>), FitError> {
        let (mut residuals, mut rows) = (Vec::new(), Vec::new());
        let run = self.run(experiment, values, &experiment.measured.times, true)?;
        for (name, data) in &experiment.measured.columns {
            let noise = experiment.noise_of(name);
            let found = run.column(name).unwrap_or_default();
            let slopes: Vec<&[f64]> = self
                .unknowns
                .iter()
                .map(|unknown| run.sensitivity(name, &unknown.name).unwrap_or_default())
                .collect();
            // The first row of the run is its start.
            let samples = data.iter().zip(found.iter().skip(1)).enumerate();
            for (row, (data, found)) in samples.filter(|(_, (data, _))| !data.is_nan()) {
                let scale = scale_of(name) * noise.map_or(1.0, |noise| noise.at(row, *data));
                residuals.push((found - data) / scale);
                for ((unknown, value), slopes) in self.unknowns.iter().zip(values).zip(&slopes) {
                    rows.push(slopes[row + 1] * unknown.slope(*value) / scale);
                }
            }
        }
        if residuals.iter().chain(&rows).all(|value| value.is_finite()) {
            Ok((residuals, rows))
        } else {
            Err(FitError::NotFinite)
        }
    }

    /// Adds the name of the experiment to an error if there are several experiments.
    fn of_experiment(&self, experiment: &Experiment, why: FitError) -> FitError {
        if self.experiments.len() < 2 {
            return why;
        }
        FitError::Experiment { name: experiment.name.clone(), why: Box::new(why) }
    }

    /// Searches from a start in search coordinates.
    ///
    /// # Errors
    /// The reason why the start cannot be evaluated.
    pub fn search(
        &self,
        start: &[f64],
        scale_of: &(dyn Fn(&str) -> f64 + Sync),
        (loss, most): (Loss, usize),
        interrupt: Option<&AtomicBool>,
        watch: &(dyn Fn(&Evaluation) + Sync),
    ) -> Result<Found, String> {
        let bounds = self.bounds();
        let search = Search { bounds: &bounds, loss, most, interrupt };
        self.search_within(start, scale_of, &search, watch)
    }

    /// Searches like [`Fit::search`], within the bounds of `search`.
    fn search_within(
        &self,
        start: &[f64],
        scale_of: &(dyn Fn(&str) -> f64 + Sync),
        search: &Search<'_>,
        watch: &(dyn Fn(&Evaluation) + Sync),
    ) -> Result<Found, String> {
        let evaluate = |inner: &[f64]| {
            let evaluation = self.evaluate(inner, scale_of).map_err(|error| error.to_string())?;
            watch(&evaluation);
            Ok(evaluation)
        };
        least_squares(evaluate, start, search)
    }

    /// Returns the residuals of every measured column in the order of time, from an evaluation with
    /// these scales.
    #[must_use]
    pub fn residuals_by_column<'e>(
        &self,
        evaluation: &'e Evaluation,
        scales: &[(String, f64)],
    ) -> Vec<ColumnResiduals<'e>>
    where
        'a: 'e,
    {
        let mut rest = evaluation.residuals.as_slice();
        let mut all = Vec::new();
        for (experiment, output, data) in self.columns() {
            let (noise, scale) = (experiment.noise_of(output), scale_of(scales, output));
            let known = data.iter().enumerate().filter(|(_, value)| !value.is_nan());
            let size = |(row, value): (usize, &f64)| {
                scale * noise.map_or(1.0, |noise| noise.at(row, *value))
            };
            let sizes: Vec<f64> = known.map(size).collect();
            let (residuals, others) = rest.split_at(sizes.len());
            all.push(ColumnResiduals { experiment: &experiment.name, output, residuals, sizes });
            rest = others;
        }
        all
    }

    /// Returns the number of steps after which a variant is given up: many times that of the start.
    #[must_use]
    pub fn step_limit(&self) -> usize {
        const TIMES: u64 = 50;
        const LEAST: u64 = 20_000;
        const UNKNOWN: u64 = 200_000;
        let first = self.simulation.clone().max_steps(UNKNOWN as usize);
        let fit = Fit::new(&first, self.unknowns, self.experiments);
        let starts: Vec<f64> = self.unknowns.iter().map(|unknown| unknown.start).collect();
        let steps = |experiment: &Experiment| {
            let run = fit.run(experiment, &starts, &experiment.measured.times, false);
            run.map_or(UNKNOWN / TIMES, |run| run.work.steps)
        };
        let most = self.experiments.iter().map(steps).max();
        (TIMES * most.unwrap_or_default()).max(LEAST) as usize
    }
}

/// Residuals of one measured column.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnResiduals<'e> {
    /// Name of the experiment.
    pub experiment: &'e str,
    /// Name of the output or state.
    pub output: &'e str,
    /// Residuals divided by `sizes`.
    pub residuals: &'e [f64],
    /// Divisor of each residual, in the unit of the output.
    pub sizes: Vec<f64>,
}

/// Reason why residuals could not be evaluated.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "fit::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum FitError {
    /// The run was refused or stopped.
    #[strum(serialize = "")]
    #[error(transparent)]
    Simulate(#[from] SimulateError),
    /// A compared output or one of its derivatives is not finite.
    #[error("an output that is compared, or its derivative, is not a finite number")]
    NotFinite,
    /// Error in one of several experiments.
    #[strum(serialize = "")]
    #[error("{name}: {why}")]
    Experiment {
        /// Name of the experiment.
        name: String,
        /// The error.
        why: Box<FitError>,
    },
}

impl FitError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Simulate(error) => error.code(),
            Self::Experiment { why, .. } => why.code(),
            error => error.into(),
        }
    }
}

impl FitError {
    /// Returns whether the run was interrupted.
    #[must_use]
    pub fn is_interrupted(&self) -> bool {
        match self {
            Self::Simulate(SimulateError::Stopped { cause, .. }) => {
                *cause == StopCause::Interrupted
            }
            Self::Experiment { why, .. } => why.is_interrupted(),
            _ => false,
        }
    }
}
