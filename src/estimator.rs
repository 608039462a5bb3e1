//! State estimators: an extended Kalman filter of a machine by names, and its consistency.
//!
//! The filter is [`machinist_contract::fixed_step::ExtendedKalmanFilter`]. Emitted Rust calls the
//! same functions, and emitted C99 has the same operations.

#[cfg(all(feature = "fit", feature = "sweep"))]
mod consistency;

use machinist_contract::fixed_step::{
    Clock, Correction, ExtendedKalmanFilter, FilterMemory, FixedMethod, FixedSteps, Stepped,
};
use machinist_contract::{Dual, Simulator};
use thiserror::Error;

use crate::error::did_you_mean;
use crate::simulate::parameter_defaults;
#[cfg(all(feature = "fit", feature = "sweep"))]
pub use consistency::{Consistency, ConsistencyRun, Instant, OutputError};

/// Design of an extended Kalman filter, by the names of a scene.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EstimatorDesign<'m> {
    /// Method of the steps.
    pub method: FixedMethod<'m>,
    /// Measured outputs, with the standard deviations of their noise in the units of the outputs.
    pub measured: Vec<(String, f64)>,
    /// Parameters to be estimated with the state.
    pub estimated: Vec<String>,
    /// Intensities of noise: of parameters, as disturbances, in their unit times the root of a
    /// second; of states and of estimated parameters in their unit per root of a second.
    pub noise: Vec<(String, f64)>,
    /// Standard deviations of states and estimated parameters at the start; without one the start
    /// is known.
    pub start: Vec<(String, f64)>,
}

/// Reason why there is no filter.
#[derive(Debug, Clone, PartialEq, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "estimator::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum EstimatorError {
    /// No quantity has this name.
    #[error("the scene has no {kind} `{name}`{hint}")]
    UnknownName {
        /// Expected kind.
        kind: &'static str,
        /// Requested name.
        name: String,
        /// Nearest known name as a question, or empty.
        hint: String,
    },
    /// A name is given twice.
    #[error("{kind} `{name}` is given twice")]
    DuplicateName {
        /// Kind of the list.
        kind: &'static str,
        /// The name.
        name: String,
    },
    /// A deviation is not a positive number.
    #[error("the deviation of `{name}` is {deviation}, but must be a finite number above 0")]
    BadDeviation {
        /// Name of the quantity.
        name: String,
        /// The deviation.
        deviation: f64,
    },
    /// Nothing is measured.
    #[error("no output is measured. Hint: give an output with the deviation of its noise")]
    NothingMeasured,
    /// A mode is a whole number without a covariance.
    #[error("`{name}` is a mode, which only events change; it has no noise")]
    Mode {
        /// The mode.
        name: String,
    },
    /// The machine or the method does not allow a filter.
    #[error("scene `{scene}` has no estimator: {why}")]
    Unsuitable {
        /// Name of the scene.
        scene: String,
        /// Reason.
        why: String,
    },
}

impl EstimatorError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.into()
    }
}

/// Indices of a design, the arguments of the filter.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EstimatorIndices<'m> {
    /// Method of the steps.
    pub method: FixedMethod<'m>,
    /// As [`ExtendedKalmanFilter::measured`].
    pub measured: Vec<(usize, f64)>,
    /// As [`ExtendedKalmanFilter::estimated`].
    pub estimated: Vec<usize>,
    /// As [`ExtendedKalmanFilter::diffusing`].
    pub diffusing: Vec<(usize, f64)>,
    /// As [`ExtendedKalmanFilter::disturbed`].
    pub disturbed: Vec<(usize, f64)>,
    /// Standard deviation of each entry of x at the start.
    pub start: Vec<f64>,
}

impl<'m> EstimatorDesign<'m> {
    /// Finds the names of the design in a scene.
    ///
    /// # Errors
    /// [`EstimatorError`] for names, deviations, and machines without a filter.
    pub fn indices(
        &self,
        simulator: &dyn Simulator<f64>,
    ) -> Result<EstimatorIndices<'m>, EstimatorError> {
        let names = Names { simulator };
        if self.measured.is_empty() {
            return Err(EstimatorError::NothingMeasured);
        }
        once("output", self.measured.iter().map(|(name, _)| name))?;
        once("parameter", &self.estimated)?;
        once("noise", self.noise.iter().map(|(name, _)| name))?;
        once("deviation", self.start.iter().map(|(name, _)| name))?;
        for (name, deviation) in self.measured.iter().chain(&self.noise).chain(&self.start) {
            if !(*deviation > 0.0 && deviation.is_finite()) {
                let (name, deviation) = (name.clone(), *deviation);
                return Err(EstimatorError::BadDeviation { name, deviation });
            }
        }
        let measured = self.measured.iter().map(|(name, deviation)| {
            let index = names.output(name).ok_or_else(|| names.unknown("output", name))?;
            Ok((index, *deviation))
        });
        let measured = measured.collect::<Result<_, EstimatorError>>()?;
        let estimated: Vec<usize> = self
            .estimated
            .iter()
            .map(|name| names.parameter(name).ok_or_else(|| names.unknown("parameter", name)))
            .collect::<Result<_, _>>()?;
        let states = simulator.shape().states();
        let (mut diffusing, mut disturbed) = (Vec::new(), Vec::new());
        for (name, intensity) in &self.noise {
            match (names.entry(name, &estimated)?, names.parameter(name)) {
                (Some(entry), _) => diffusing.push((entry, *intensity)),
                (None, Some(parameter)) => disturbed.push((parameter, *intensity)),
                (None, None) => return Err(names.unknown("parameter or state", name)),
            }
        }
        let mut start = vec![0.0; states + estimated.len()];
        for (name, deviation) in &self.start {
            let entry = names.entry(name, &estimated)?;
            let entry = entry.ok_or_else(|| names.unknown("state or estimated parameter", name))?;
            start[entry] = *deviation;
        }
        let method = self.method;
        let found = EstimatorIndices { method, measured, estimated, diffusing, disturbed, start };
        found.check(simulator)?;
        Ok(found)
    }
}

impl EstimatorIndices<'_> {
    /// Returns the filter.
    #[must_use]
    pub fn filter<'a>(&'a self, simulator: &'a dyn Simulator<f64>) -> ExtendedKalmanFilter<'a> {
        ExtendedKalmanFilter {
            simulator,
            method: self.method,
            parts_a_step: FixedSteps::<f64>::enough_parts(simulator),
            measured: &self.measured,
            estimated: &self.estimated,
            diffusing: &self.diffusing,
            disturbed: &self.disturbed,
        }
    }

    fn check(&self, simulator: &dyn Simulator<f64>) -> Result<(), EstimatorError> {
        let refused = |why: &str| {
            let (scene, why) = (simulator.name().to_owned(), why.to_owned());
            EstimatorError::Unsuitable { scene, why }
        };
        self.filter(simulator).refusal().map_or(Ok(()), |why| Err(refused(why)))
    }
}

/// Names of a scene.
struct Names<'a> {
    simulator: &'a dyn Simulator<f64>,
}

impl<'a> Names<'a> {
    fn output(&self, name: &str) -> Option<usize> {
        (0..self.simulator.shape().outputs).find(|index| self.simulator.output(*index).name == name)
    }

    fn parameter(&self, name: &str) -> Option<usize> {
        (0..self.simulator.shape().parameters)
            .find(|index| self.simulator.parameter(*index).name == name)
    }

    /// Returns the entry of x of a name.
    fn entry(&self, name: &str, estimated: &[usize]) -> Result<Option<usize>, EstimatorError> {
        let states = self.simulator.shape().states();
        if let Some(index) = (0..states).find(|index| self.simulator.state(*index).name == name) {
            if self.simulator.is_mode(index) {
                return Err(EstimatorError::Mode { name: name.to_owned() });
            }
            return Ok(Some(index));
        }
        let of = |parameter: &usize| self.simulator.parameter(*parameter).name == name;
        Ok(estimated.iter().position(of).map(|slot| states + slot))
    }

    fn unknown(&self, kind: &'static str, name: &str) -> EstimatorError {
        let shape = self.simulator.shape();
        let outputs = (0..shape.outputs).map(|index| self.simulator.output(index).name);
        let states = (0..shape.states()).map(|index| self.simulator.state(index).name);
        let parameters = (0..shape.parameters).map(|index| self.simulator.parameter(index).name);
        let known: Vec<&'a str> = match kind {
            "output" => outputs.collect(),
            "parameter" => parameters.collect(),
            _ => states.chain(parameters).collect(),
        };
        let hint = did_you_mean(name, known.into_iter());
        EstimatorError::UnknownName { kind, name: name.to_owned(), hint }
    }
}

fn once<'a>(
    kind: &'static str,
    names: impl IntoIterator<Item = &'a String>,
) -> Result<(), EstimatorError> {
    let mut seen = Vec::new();
    for name in names {
        if seen.contains(&name) {
            return Err(EstimatorError::DuplicateName { kind, name: name.clone() });
        }
        seen.push(name);
    }
    Ok(())
}

/// Extended Kalman filter of a machine, with its memory.
///
/// ```
/// # use machinist::estimator::{Estimator, EstimatorDesign};
/// # use machinist_contract::{Describe, Simulator};
/// # fn example(machine: &dyn Simulator<f64>, speeds: &[f64]) {
/// let design = EstimatorDesign {
///     measured: vec![("motor_speed".to_owned(), 0.1)],
///     noise: vec![("load.mean".to_owned(), 5.0)],
///     ..EstimatorDesign::default()
/// };
/// let indices = design.indices(machine).expect("names of the scene");
/// let mut estimator = Estimator::new(machine, &indices);
/// for speed in speeds {
///     let _ = estimator.predict(1e-3);
///     estimator.correct(&[*speed]);
///     println!("{:?}", estimator.outputs());
/// }
/// # }
/// ```
pub struct Estimator<'a> {
    filter: ExtendedKalmanFilter<'a>,
    start: &'a [f64],
    clock: Clock<f64>,
    state: Vec<f64>,
    parameters: Vec<f64>,
    constants: Vec<f64>,
    root: Vec<f64>,
    numbers: Vec<f64>,
    signs: Vec<i8>,
    duals: Vec<Dual>,
}

impl<'a> Estimator<'a> {
    /// Returns the filter at the start of the spec's run.
    #[must_use]
    pub fn new(simulator: &'a dyn Simulator<f64>, indices: &'a EstimatorIndices<'a>) -> Self {
        let shape = simulator.shape();
        let parameters = parameter_defaults(simulator);
        let mut state = vec![0.0; shape.states()];
        simulator.initial_state(&parameters, &mut state);
        Self::at(simulator, indices, simulator.run_defaults().from, &state, &parameters)
    }

    /// Returns the filter at a time and state, which must be on the constraints.
    ///
    /// # Panics
    /// If the lengths differ from those of the simulator.
    #[must_use]
    pub fn at(
        simulator: &'a dyn Simulator<f64>,
        indices: &'a EstimatorIndices<'a>,
        time: f64,
        state: &[f64],
        parameters: &[f64],
    ) -> Self {
        let filter = indices.filter(simulator);
        let sizes = filter.sizes();
        assert_eq!([state.len(), parameters.len()], [sizes.state, sizes.parameters]);
        let mut estimator = Self {
            filter,
            start: &indices.start,
            clock: Clock::new(time),
            state: state.to_vec(),
            parameters: parameters.to_vec(),
            constants: vec![0.0; sizes.constants],
            root: vec![0.0; sizes.root],
            numbers: vec![0.0; sizes.numbers],
            signs: vec![0; sizes.signs],
            duals: vec![Dual::constant(0.0); sizes.duals],
        };
        let start = estimator.start;
        estimator.with(|filter, memory| filter.begin(start, memory));
        estimator
    }

    /// Calls with the filter and its memory.
    fn with<T>(
        &mut self,
        call: impl FnOnce(&ExtendedKalmanFilter<'_>, &mut FilterMemory<'_>) -> T,
    ) -> T {
        let mut memory = FilterMemory {
            clock: self.clock,
            state: &mut self.state,
            parameters: &mut self.parameters,
            constants: &mut self.constants,
            root: &mut self.root,
            numbers: &mut self.numbers,
            signs: &mut self.signs,
            duals: &mut self.duals,
        };
        let result = call(&self.filter, &mut memory);
        self.clock = memory.clock;
        result
    }

    /// Advances the estimate by a step \[s\].
    pub fn predict(&mut self, step: f64) -> Stepped {
        self.with(|filter, memory| filter.predict(step, memory))
    }

    /// Corrects the estimate by measured outputs, in the order of the design. Values that are not
    /// a number are left out.
    ///
    /// # Panics
    /// If there are fewer values than measured outputs.
    pub fn correct(&mut self, measured: &[f64]) -> Correction {
        self.with(|filter, memory| filter.correct(measured, memory))
    }

    /// Sets a parameter, such as an input.
    ///
    /// # Panics
    /// If there is no parameter with this index.
    pub fn set(&mut self, parameter: usize, value: f64) {
        self.parameters[parameter] = value;
        self.filter.simulator.prepare(&self.parameters, &mut self.constants);
    }

    /// Returns the time of the estimate \[s\].
    #[must_use]
    pub fn time(&self) -> f64 {
        self.clock.time()
    }

    /// Returns the estimated state.
    #[must_use]
    pub fn state(&self) -> &[f64] {
        &self.state
    }

    /// Returns the parameters, with the estimated ones among them.
    #[must_use]
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// Returns the outputs of the scene at the estimate.
    #[must_use]
    pub fn outputs(&self) -> Vec<f64> {
        let mut outputs = vec![0.0; self.filter.simulator.shape().outputs];
        let simulator = self.filter.simulator;
        simulator.outputs(self.time(), &self.state, &self.parameters, &mut outputs);
        outputs
    }

    /// Returns the square root S of the covariance S S^T, column by column.
    #[must_use]
    pub fn root(&self) -> &[f64] {
        let size = self.filter.entries();
        &self.root[..size * size]
    }

    /// Returns the covariance of two entries of x: states, then estimated parameters.
    ///
    /// # Panics
    /// If an index is too large.
    #[must_use]
    pub fn covariance(&self, row: usize, column: usize) -> f64 {
        self.filter.covariance(&self.root, row, column)
    }

    /// Returns the standard deviations of the entries of x.
    #[must_use]
    pub fn deviations(&self) -> Vec<f64> {
        (0..self.filter.entries()).map(|entry| self.covariance(entry, entry).sqrt()).collect()
    }
}
