//! Settings of a run, from keywords.

use std::time::Duration;

use machinist::error_estimate::AccurateRun;
use machinist::method::{Auto, BadChoice};
use machinist::{Method, SimulateError, Simulation, Trajectory};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping, PyString};

use crate::arrays::numbers;
use crate::failure::Failure;

/// Settings of a run; omitted ones take the scene's values.
#[derive(Debug, Clone, Default)]
pub struct Settings {
    /// All parameters in order.
    pub all_parameters: Option<Vec<f64>>,
    /// Some parameters by name.
    pub parameters: Vec<(String, f64)>,
    initial: Vec<(String, f64)>,
    state: Option<Vec<f64>>,
    start: Option<f64>,
    until: Option<f64>,
    points: Option<usize>,
    times: Option<Vec<f64>>,
    rtol: Option<f64>,
    atol: Option<Vec<f64>>,
    /// Integration method.
    pub method: Option<Method>,
    /// Choices of the method auto.
    pub auto: Option<Auto>,
    /// Maximum number of steps.
    pub max_steps: Option<usize>,
    equilibrium: Option<bool>,
    energy_balance: bool,
    constant_energy: bool,
    /// True to estimate the error.
    error: bool,
    /// Target error of the result, as a fraction of the largest value of a column.
    accuracy: Option<f64>,
    sensitivities: Vec<String>,
    /// Limit of the computing time.
    pub time_limit: Option<Duration>,
}

impl Settings {
    /// Settings from keywords; `None` counts as omitted.
    ///
    /// # Errors
    /// A value is invalid, or a keyword is unknown.
    pub fn of(keywords: &Bound<'_, PyDict>) -> Result<Self, Failure> {
        let mut settings = Self::default();
        for (key, value) in keywords {
            if !value.is_none() {
                settings
                    .set(key.cast::<PyString>().map_err(PyErr::from)?.to_cow()?.as_ref(), &value)?;
            }
        }
        Ok(settings)
    }

    /// Returns whether a relative tolerance is given.
    pub fn has_tolerance(&self) -> bool {
        self.rtol.is_some()
    }

    /// Returns the end time \[s\] if it is given.
    pub fn end(&self) -> Option<f64> {
        self.until
    }

    fn set(&mut self, key: &str, value: &Bound<'_, PyAny>) -> Result<(), Failure> {
        let list = || numbers(key, value, None).map(|values| values.as_slice().to_vec());
        match key {
            "parameters" if value.cast::<PyMapping>().is_ok() => {
                self.parameters = assignments(key, value)?;
            }
            "parameters" => self.all_parameters = Some(list()?),
            "initial" if value.cast::<PyMapping>().is_ok() => {
                self.initial = assignments(key, value)?;
            }
            "initial" => self.state = Some(list()?),
            "start" => self.start = Some(number(key, value)?),
            "until" => self.until = Some(number(key, value)?),
            "points" => self.points = Some(count(key, value)?),
            "times" => self.times = Some(list()?),
            "rtol" => self.rtol = Some(number(key, value)?),
            "atol" => self.atol = Some(list()?),
            "method" => {
                let name = extracted::<String>(key, value, "the name of a method")?;
                self.method = Some(Method::from_name(&name).map_err(SimulateError::from)?);
            }
            "auto" => {
                let choices = extracted::<String>(key, value, "choices of the method auto")?;
                let read = choices.parse().map_err(|bad: BadChoice| {
                    Failure::Coded("InputError", bad.code(), bad.to_string())
                });
                self.auto = Some(read?);
            }
            "max_steps" => self.max_steps = Some(count(key, value)?),
            "equilibrium" => self.equilibrium = Some(extracted(key, value, "true or false")?),
            "energy_balance" => self.energy_balance = extracted(key, value, "true or false")?,
            "constant_energy" => self.constant_energy = extracted(key, value, "true or false")?,
            "error" => self.error = extracted(key, value, "true or false")?,
            "accuracy" => self.accuracy = Some(number(key, value)?),
            "sensitivities" => self.sensitivities = extracted(key, value, "a list of names")?,
            "time_limit" => {
                let limit = Duration::try_from_secs_f64(number(key, value)?).map_err(|error| {
                    Failure::input(format!("time_limit, seconds from 0: {error}"))
                })?;
                self.time_limit = Some(limit);
            }
            _ => return Err(Failure::input(format!("there is no setting `{key}`"))),
        }
        Ok(())
    }

    /// Start time \[s\], if set.
    pub fn start(&self) -> Option<f64> {
        self.start
    }

    /// Applies the settings to a run.
    ///
    /// # Errors
    /// A name is unknown.
    pub fn apply<'a>(&self, mut run: Simulation<'a>) -> Result<Simulation<'a>, SimulateError> {
        if let Some(all) = &self.all_parameters {
            run = run.parameters(all);
        }
        for (name, value) in &self.parameters {
            run = run.parameter(name, *value)?;
        }
        if let Some(state) = &self.state {
            run = run.initial_state(state);
        }
        for (name, value) in &self.initial {
            run = run.initial_value(name, *value)?;
        }
        run = self.equilibrium.into_iter().fold(run, Simulation::in_equilibrium);
        run = run.sensitivities(&self.sensitivities)?;
        run = self.start.into_iter().fold(run, Simulation::from);
        run = self.until.into_iter().fold(run, Simulation::until);
        run = self.points.into_iter().fold(run, Simulation::points);
        if let Some(times) = &self.times {
            run = run.times(times);
        }
        run = self.rtol.into_iter().fold(run, Simulation::rtol);
        if let Some(atol) = &self.atol {
            run = run.atol(atol);
        }
        run = self.method.into_iter().fold(run, Simulation::method);
        run = self.auto.into_iter().fold(run, Simulation::auto);
        run = self.max_steps.into_iter().fold(run, Simulation::max_steps);
        run = self.time_limit.into_iter().fold(run, Simulation::time_limit);
        run = run.with_constant_energy(self.constant_energy);
        Ok(run.with_energy_balance(self.energy_balance))
    }

    /// Runs, with an error estimate or to an accuracy if requested.
    ///
    /// # Errors
    /// As [`Simulation::run`] and [`Simulation::run_to_accuracy`].
    pub fn run(&self, simulation: &Simulation<'_>) -> Result<Trajectory, SimulateError> {
        if let Some(accuracy) = self.accuracy {
            let AccurateRun { mut trajectory, error, shortfall, .. } =
                simulation.run_to_accuracy(accuracy)?;
            let missed = |reason| format!("the accuracy is not met: {reason}");
            trajectory.notes.extend(shortfall.map(missed));
            return Ok(Trajectory { error: Some(error), ..trajectory });
        }
        let run = simulation.run()?;
        let error = self.error.then(|| simulation.error_estimate(&run));
        Ok(Trajectory { error, ..run })
    }
}

/// `{name: number}`.
///
/// # Errors
/// A name or a number has another type.
pub fn assignments(what: &str, value: &Bound<'_, PyAny>) -> Result<Vec<(String, f64)>, Failure> {
    let items = value.call_method0("items")?;
    let mut all = Vec::new();
    for item in items.try_iter()? {
        let (name, value) = item?.extract::<(Bound<'_, PyAny>, Bound<'_, PyAny>)>()?;
        let name = extracted::<String>(what, &name, "names")?;
        let value = number(&format!("{what}[`{name}`]"), &value)?;
        all.push((name, value));
    }
    Ok(all)
}

fn number(what: &str, value: &Bound<'_, PyAny>) -> Result<f64, Failure> {
    extracted(what, value, "a number")
}

fn count(what: &str, value: &Bound<'_, PyAny>) -> Result<usize, Failure> {
    extracted(what, value, "a whole number from 0")
}

/// Converts a value to its Rust type.
///
/// # Errors
/// The value has another type.
pub fn extracted<'a, 'py, T: FromPyObject<'a, 'py>>(
    what: &str,
    value: &'a Bound<'py, PyAny>,
    wanted: &str,
) -> Result<T, Failure> {
    value.extract().map_err(|_| {
        let given = value.repr().map_or_else(|_| "something else".to_owned(), |r| r.to_string());
        Failure::input(format!("{what} must be {wanted}, not {given}"))
    })
}
