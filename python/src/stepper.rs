//! Runs that Python carries in pieces.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use machinist::hosted::{Hosted, HostedError, Reached, Standing};
use machinist::method::Auto;
use machinist::simulate::MAX_STEPS;
use machinist::trajectory::Switch;
use machinist::{Method, SimulateError, Simulation};
use machinist_contract::Simulator;
use machinist_model::file::{self, FileError};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyMapping};

use crate::arrays::{array, numbers};
use crate::failure::Failure;
use crate::machine::Machine;
use crate::patience::Patience;
use crate::settings::{Settings, assignments};

/// Version of the package: of the engine, whose status may have another form in the next one.
const VERSION: &str = env!("CARGO_PKG_VERSION");
/// The first bytes of a saved run, with the version of its content.
const MARK: &[u8; 16] = b"machinist run v1";
/// Number of bytes of the mark before the version.
const NAME: usize = 15;

/// A saved run: version of the package, machine, manner, parameters, status, events at the start.
/// Method and choices of `auto` are text.
type Saved = (
    String,
    (String, Option<usize>, Option<usize>),
    (String, String, usize, Option<Duration>),
    Vec<f64>,
    Standing,
    Events,
);

/// A run that is carried in pieces.
#[pyclass(frozen, module = "machinist._machinist")]
pub struct Stepper {
    machine: Py<Machine>,
    manner: Manner,
    now: Mutex<Now>,
    /// True while a thread carries the run.
    is_busy: AtomicBool,
}

/// Manner in which pieces are integrated.
#[derive(Clone)]
struct Manner {
    method: Method,
    auto: Auto,
    /// Maximum number of steps of a piece.
    max_steps: usize,
    /// Limit of the computing time of a piece.
    time_limit: Option<Duration>,
}

/// Everything that changes.
#[derive(Clone)]
struct Now {
    parameters: Vec<f64>,
    standing: Standing,
    /// Events at the start, until the first piece lists them.
    events: Events,
}

/// Right of one thread to change a run.
struct Lease<'a>(&'a AtomicBool);

impl Drop for Lease<'_> {
    fn drop(&mut self) {
        self.0.store(false, Ordering::Release);
    }
}

/// Events with their times.
type Events = Vec<(f64, String)>;

impl Stepper {
    fn of(machine: Py<Machine>, manner: Manner, now: Now) -> Self {
        Self { machine, manner, now: Mutex::new(now), is_busy: AtomicBool::new(false) }
    }

    /// Copy of the present status. Nobody holds the lock for longer than a copy takes.
    fn now(&self) -> Now {
        self.now.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn become_now(&self, now: Now) {
        *self.now.lock().unwrap_or_else(PoisonError::into_inner) = now;
    }

    fn lease(&self) -> Result<Lease<'_>, Failure> {
        if self.is_busy.swap(true, Ordering::Acquire) {
            let message = "the run is being advanced already. Hint: copy() makes a run of its own";
            return Err(Failure::input(message));
        }
        Ok(Lease(&self.is_busy))
    }

    /// Calls a function with the simulator and the present status.
    fn with<T>(&self, job: impl FnOnce(&dyn Simulator<f64>, &Now) -> T) -> Result<T, Failure> {
        let now = self.now();
        self.machine.get().source.with(|simulator| job(simulator, &now))
    }

    /// Carries a run to a time, or to the first event.
    fn carry(
        &self,
        simulator: &dyn Simulator<f64>,
        now: &mut Now,
        (until, halts): (f64, bool),
        patience: &Patience,
    ) -> Result<Events, HostedError> {
        let Manner { method, auto, max_steps, time_limit } = self.manner;
        let end = || patience.end();
        let Now { parameters, standing, events } = now;
        let hosted = Hosted::new(simulator, parameters).auto(auto).max_steps(max_steps);
        let hosted = time_limit.into_iter().fold(hosted.until_told(&end), Hosted::time_limit);
        let mut events = std::mem::take(events);
        while standing.time < until && (events.is_empty() || !halts) {
            let piece = hosted.carry(standing, until, (method, halts), &|_, _| false)?;
            let mut switches = piece.switches;
            if piece.reached == Reached::Event {
                switches.extend(hosted.happen(standing)?);
            }
            events.extend(listed(switches));
        }
        Ok(events)
    }
}

fn listed(switches: Vec<Switch>) -> impl Iterator<Item = (f64, String)> {
    switches.into_iter().map(|switch| (switch.time, switch.event))
}

/// Failure of a run as of one that is not divided.
fn failure(simulator: &dyn Simulator<f64>, method: Method, error: HostedError) -> Failure {
    match error {
        HostedError::Refused(error) => error.into(),
        HostedError::Stopped { time, cause } => {
            let (scene, method) = (simulator.name().to_owned(), method.name());
            SimulateError::Stopped { scene, method, time, cause, kept: None }.into()
        }
        error => Failure::input(error.to_string()),
    }
}

impl Manner {
    fn of(settings: &Settings, simulator: &dyn Simulator<f64>) -> Result<Self, SimulateError> {
        let method = match (settings.auto, settings.method) {
            (Some(_), _) => Method::Auto,
            (None, Some(method)) => method,
            (None, None) => Method::from_name(simulator.run_defaults().method)?,
        };
        Ok(Self {
            method,
            auto: settings.auto.unwrap_or_default(),
            max_steps: settings.max_steps.unwrap_or(MAX_STEPS),
            time_limit: settings.time_limit,
        })
    }
}

#[pymethods]
impl Stepper {
    /// Starts a run.
    #[new]
    fn new(
        py: Python<'_>,
        machine: Py<Machine>,
        settings: &Bound<'_, PyDict>,
    ) -> Result<Self, Failure> {
        let settings = Settings::of(settings)?;
        let source = &machine.get().source;
        let begin = |simulator: &dyn Simulator<f64>| {
            let manner = Manner::of(&settings, simulator)?;
            let mut run = settings.apply(Simulation::new(simulator))?;
            if settings.end().is_none() {
                let usual = simulator.run_defaults();
                let until = run.start_time() + (usual.until - usual.from);
                run = run.until(until);
            }
            let parameters = run.parameter_values().to_vec();
            let begun = run.begin().map_err(|error| failure(simulator, manner.method, error));
            let (standing, switches) = begun?;
            Ok::<_, Failure>((
                manner,
                Now { parameters, standing, events: listed(switches).collect() },
            ))
        };
        let (manner, now) = py.detach(|| source.with(begin))??;
        Ok(Self::of(machine, manner, now))
    }

    /// The run of this machine from the bytes of `save`.
    #[staticmethod]
    fn restore(machine: Py<Machine>, bytes: &[u8]) -> Result<Self, Failure> {
        let refused = |why: &str| Failure::input(format!("these bytes cannot be restored: {why}"));
        let saved: Result<Saved, FileError> = file::open(MARK, bytes);
        let is_run = bytes.get(..NAME) == Some(&MARK[..NAME]);
        let other = || refused("another version of the package has saved them");
        let saved = saved.map_err(|error| match error {
            FileError::Foreign if !is_run => refused("they are not a saved run"),
            FileError::Length { .. } => refused("they are cut off or too long"),
            FileError::Altered => refused("they have been altered"),
            _ => other(),
        })?;
        let (version, of, manner, parameters, standing, events) = saved;
        if version != VERSION {
            return Err(other());
        }
        if of != machine.get().identity() {
            return Err(refused("they are a run of another machine, or of another version of it"));
        }
        let (method, auto, max_steps, time_limit) = manner;
        let method = Method::from_name(&method).map_err(SimulateError::from)?;
        let auto = auto.parse().map_err(|_| refused("their choices of auto are unknown"))?;
        let fits = machine.get().source.with(|simulator| {
            standing.fits(simulator) && Hosted::new(simulator, &parameters).check().is_ok()
        })?;
        if !fits {
            return Err(refused("their values do not fit the machine"));
        }
        let manner = Manner { method, auto, max_steps, time_limit };
        Ok(Self::of(machine, manner, Now { parameters, standing, events }))
    }

    /// The run as bytes.
    fn save<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        let Manner { method, auto, max_steps, time_limit } = &self.manner;
        let Now { parameters, standing, events } = self.now();
        let manner = (method.name().to_owned(), auto.to_string(), *max_steps, *time_limit);
        let (version, machine) = (VERSION.to_owned(), self.machine.get().identity());
        let saved: Saved = (version, machine, manner, parameters, standing, events);
        PyBytes::new(py, &file::seal(MARK, &saved))
    }

    /// A copy that continues on its own.
    fn copy(&self, py: Python<'_>) -> Self {
        Self::of(self.machine.clone_ref(py), self.manner.clone(), self.now())
    }

    /// Carries the run to a time, or to the first event before it if it `halts`. Returns the events
    /// with their times.
    fn advance(&self, py: Python<'_>, until: f64, halts: bool) -> Result<Events, Failure> {
        let _lease = self.lease()?;
        let mut now = self.now();
        let time = now.standing.time;
        if !(until.is_finite() && until >= time) {
            let message = format!("the run is at t = {time} s and cannot advance to t = {until} s");
            return Err(Failure::input(message));
        }
        let source = &self.machine.get().source;
        let (events, quiet) = py.detach(|| {
            let patience = Patience::new();
            let events = source.with(|simulator| {
                let carried = self.carry(simulator, &mut now, (until, halts), &patience);
                carried.map_err(|error| failure(simulator, self.manner.method, error))
            });
            (events, patience.require_quiet())
        });
        quiet?;
        let events = events??;
        self.become_now(now);
        Ok(events)
    }

    /// Sets parameters, some by name or all in order; all or none.
    fn set(&self, values: &Bound<'_, PyAny>) -> Result<(), Failure> {
        let _lease = self.lease()?;
        let mut now = self.now();
        let machine = self.machine.get();
        let (all, named) = if values.cast::<PyMapping>().is_ok() {
            (None, assignments("parameters", values)?)
        } else {
            (Some(numbers("parameters", values, None)?), Vec::new())
        };
        let given = machine.source.with(|simulator| {
            let start = all.as_ref().map_or(&now.parameters[..], |all| all.as_slice());
            let mut run = Simulation::new(simulator).parameters(start);
            for (name, value) in &named {
                run = run.parameter(name, *value)?;
            }
            let given = run.parameter_values().to_vec();
            Hosted::new(simulator, &given).check()?;
            Ok::<_, SimulateError>(given)
        })??;
        let tunable = machine.tunable()?;
        let is_refused = |index: &usize| {
            !tunable[*index] && given[*index].to_bits() != now.parameters[*index].to_bits()
        };
        if let Some(fixed) = (0..given.len()).find(is_refused) {
            let name = machine.source.with(|it| it.parameter(fixed).name.to_owned())?;
            return Err(Failure::input(format!(
                "parameter `{name}` cannot change during a run: constraints depend on it, or only \
                 the start does. Hint: give it to start(); `tunable` in the table of parameters \
                 tells which can change"
            )));
        }
        now.parameters = given;
        self.become_now(now);
        Ok(())
    }

    /// Time \[s\].
    #[getter]
    fn time(&self) -> f64 {
        self.now().standing.time
    }

    /// State y.
    #[getter]
    fn state<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        array(py, self.now().standing.state)
    }

    /// All parameters.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        array(py, self.now().parameters)
    }

    /// Rate y', with relations as the run holds them.
    #[getter]
    fn rate<'py>(&self, py: Python<'py>) -> Result<Bound<'py, PyArray1<f64>>, Failure> {
        let rate = self.with(|simulator, now| {
            let mut rate = vec![0.0; now.standing.state.len()];
            Hosted::new(simulator, &now.parameters).rate(&now.standing, &mut rate);
            rate
        })?;
        Ok(array(py, rate))
    }

    /// All outputs.
    #[getter]
    fn outputs<'py>(&self, py: Python<'py>) -> Result<Bound<'py, PyArray1<f64>>, Failure> {
        let outputs = self.with(|simulator, Now { parameters, standing, .. }| {
            let mut outputs = vec![0.0; simulator.shape().outputs];
            let time = standing.within(standing.time);
            simulator.outputs(time, &standing.state, parameters, &mut outputs);
            outputs
        })?;
        Ok(array(py, outputs))
    }

    /// True if the motion slides along a switching surface.
    #[getter]
    fn is_sliding(&self) -> bool {
        self.now().standing.is_sliding()
    }

    /// Name of the method, and relative tolerance.
    #[getter]
    fn manner(&self) -> (&'static str, f64) {
        (self.manner.method.name(), self.now().standing.rtol())
    }
}
