//! Runs a simulator: checks the request, integrates, and returns a [`Trajectory`].

mod checked;
mod differentiate;
#[cfg(all(feature = "fit", feature = "sweep"))]
mod elsewhere;
mod energy;
mod gradient;
#[cfg(feature = "sweep")]
mod in_sweeps;
mod inertia;
mod notes;
mod sampling;
#[cfg(feature = "linear")]
mod shooting;
mod small;
mod start;
mod table;
mod undefined;

use std::sync::atomic::AtomicBool;
use std::time::Duration;

use machinist_contract::Simulator;

use crate::constraints::Constraints;
#[cfg(feature = "linear")]
use crate::constraints::consistent;
use crate::error::{NotCompiledIn, SimulateError, StopCause, did_you_mean};
use crate::method::patience::Patience;
use crate::method::reverse::Log;
use crate::method::sensitivity::{By, Start, Tangents, columns};
use crate::method::{Auto, Method, Problem, Run, StepTolerance, Stopped, System};
pub use crate::trajectory::MAX_POINTS;
use crate::trajectory::{Stop, Trajectory};

pub(crate) use checked::{require_admitted, require_guards};
pub use differentiate::Differentiated;
pub use gradient::{Gradient, Pull, Slope};
use sampling::Sampling;
use small::Sized;
pub use start::NegativeInertias;
use table::Table;

/// Default maximum number of steps of a run.
pub const MAX_STEPS: usize = 10_000_000;

/// Returns the values of the parameters in the spec, in SI units.
#[must_use]
pub fn parameter_defaults(simulator: &dyn Simulator<f64>) -> Vec<f64> {
    (0..simulator.shape().parameters).map(|index| simulator.parameter_default(index)).collect()
}

/// A run of one simulator, with settings to adjust. Settings that are not adjusted have the values
/// of the scene's spec.
///
/// ```
/// use machinist::{Method, Simulation};
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/oscillator.rs"));
/// # fn main() -> Result<(), machinist::SimulateError> {
/// let simulator = Oscillator;
///
/// let trajectory = Simulation::new(&simulator)
///     .parameter("rotor.damping", 0.3)?
///     .until(2.0)
///     .rtol(1e-8)
///     .method(Method::Dop853)
///     .points(1001)
///     .run()?;
///
/// let angle = trajectory.column("rotor.angle").expect("the scene has this state");
/// assert_eq!(angle.len(), 1001);
/// println!("{} rad/s after {} steps", angle[1000], trajectory.work.steps);
/// # Ok(())
/// # }
/// ```
///
/// Sensitivities are columns beside the others. The rotor comes to rest at M/c, which changes by
/// -M/c^2 with its stiffness c:
///
/// ```
/// use machinist::{Method, Simulation};
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/oscillator.rs"));
/// # fn main() -> Result<(), machinist::SimulateError> {
///
/// let run = Simulation::new(&Oscillator)
///     .until(100.0)
///     .method(Method::Dop853)
///     .sensitivities(&["rotor.stiffness"])?
///     .run()?;
///
/// let slope = run.sensitivity("rotor.angle", "rotor.stiffness").expect("it was asked for");
/// let (torque, stiffness) = (30.0, 50.0_f64);
/// assert!((slope[slope.len() - 1] + torque / stiffness.powi(2)).abs() < 1e-7);
/// # Ok(())
/// # }
/// ```
#[derive(Clone)]
#[must_use = "a simulation does nothing until it is `run`"]
#[expect(clippy::struct_excessive_bools, reason = "settings that do not depend on each other")]
pub struct Simulation<'a> {
    simulator: &'a dyn Simulator<f64>,
    parameters: Vec<f64>,
    initial_state: Option<Vec<f64>>,
    /// Entries of the initial state that replace those of the spec.
    initial_values: Vec<(usize, f64)>,
    /// True to search for an equilibrium near the start; `None` stands for the spec's setting.
    in_equilibrium: Option<bool>,
    from: f64,
    until: f64,
    sampling: Sampling,
    rtol: f64,
    atol: Option<Vec<f64>>,
    /// Scales of states as an earlier run has measured them, instead of those of the spec.
    sizes: Vec<(usize, f64)>,
    holds_small: bool,
    /// True for the second run of an error estimate.
    is_refined: bool,
    method: Option<Method>,
    auto: Auto,
    max_steps: usize,
    energy_balance: bool,
    keeps_energy: bool,
    sensitivities: Vec<By>,
    controls_sensitivities: bool,
    patience: Patience<'a>,
}

impl<'a> Simulation<'a> {
    /// Creates a run with the settings of the scene's spec.
    pub fn new(simulator: &'a dyn Simulator<f64>) -> Self {
        let defaults = simulator.run_defaults();
        Self {
            simulator,
            parameters: parameter_defaults(simulator),
            initial_state: None,
            initial_values: Vec::new(),
            in_equilibrium: None,
            from: defaults.from,
            until: defaults.until,
            sampling: Sampling::of(&defaults),
            rtol: defaults.rtol,
            atol: None,
            sizes: Vec::new(),
            holds_small: true,
            is_refined: false,
            method: None,
            auto: Auto::default(),
            max_steps: MAX_STEPS,
            energy_balance: false,
            keeps_energy: false,
            sensitivities: Vec::new(),
            controls_sensitivities: true,
            patience: Patience::default(),
        }
    }

    /// Sets one parameter, in its SI unit.
    ///
    /// # Errors
    /// [`SimulateError::UnknownParameter`], with the nearest known name.
    pub fn parameter(mut self, name: &str, value: f64) -> Result<Self, SimulateError> {
        let index = self.parameter_index(name)?;
        self.parameters[index] = value;
        Ok(self)
    }

    /// Returns the index of a parameter.
    pub(crate) fn parameter_index(&self, name: &str) -> Result<usize, SimulateError> {
        let names = || (0..self.parameters.len()).map(|index| self.simulator.parameter(index).name);
        names().position(|known| known == name).ok_or_else(|| {
            let (scene, name) = (self.simulator.name().to_owned(), name.to_owned());
            if self.simulator.is_unused(&name) {
                return SimulateError::UnusedParameter { scene, name };
            }
            let hint = did_you_mean(&name, names());
            SimulateError::UnknownParameter { scene, name, hint }
        })
    }

    /// Sets all parameters, in the simulator's order.
    pub fn parameters(mut self, values: &[f64]) -> Self {
        self.parameters = values.to_vec();
        self
    }

    /// Returns the values of all parameters, in the simulator's order.
    #[must_use]
    pub fn parameter_values(&self) -> &[f64] {
        &self.parameters
    }

    /// Starts from this state \[q, q', z\] instead of the spec's.
    pub fn initial_state(mut self, state: &[f64]) -> Self {
        self.initial_state = Some(state.to_vec());
        self
    }

    /// Starts with this value of one state, in its unit. Other states are those of the spec or of
    /// [`Simulation::initial_state`].
    ///
    /// # Errors
    /// [`SimulateError::UnknownDirection`], with the nearest known name.
    pub fn initial_value(mut self, name: &str, value: f64) -> Result<Self, SimulateError> {
        let states = || (0..self.simulator.shape().states()).map(|i| self.simulator.state(i).name);
        let index = states().position(|known| known == name).ok_or_else(|| {
            SimulateError::UnknownDirection {
                scene: self.simulator.name().to_owned(),
                name: name.to_owned(),
                hint: did_you_mean(name, states()),
            }
        })?;
        self.initial_values.retain(|(other, _)| *other != index);
        self.initial_values.push((index, value));
        Ok(self)
    }

    /// Sets whether to start in equilibrium, regardless of the spec: in a state near the given
    /// start at which all rates vanish, with time held at the run's start. The machine is then at
    /// rest or at constant speed; see [`linear_analysis::equilibrium`].
    ///
    /// The search begins at the initial values. An equilibrium may leave some of them open, such as
    /// the angle of a freely turning shaft. These stay as near as possible to the initial values,
    /// first of all to those that `[initial]` or [`Simulation::initial_value`] names. Modes are
    /// chosen so that no guard contradicts them. If there is no equilibrium nearby, the machine
    /// creeps downhill to one, as if all its motions were heavily damped.
    ///
    /// An equilibrium may be unstable; a note of the trajectory then gives the growth rate of
    /// deviations.
    ///
    /// [`linear_analysis::equilibrium`]: crate::linear_analysis::equilibrium()
    #[cfg(feature = "linear")]
    pub fn in_equilibrium(mut self, wanted: bool) -> Self {
        self.in_equilibrium = Some(wanted);
        self
    }

    /// Sets a parameter, or the initial value of a state if no parameter has this name.
    #[cfg(feature = "fit")]
    pub(crate) fn given(self, name: &str, value: f64) -> Result<Self, SimulateError> {
        match By::named(self.simulator, name)? {
            By::Parameter(_) => self.parameter(name, value),
            By::Initial(_) => self.initial_value(name, value),
        }
    }

    /// Sets the start time \[s\].
    pub fn from(mut self, time: f64) -> Self {
        self.from = time;
        self
    }

    /// Sets the end time \[s\].
    pub fn until(mut self, time: f64) -> Self {
        self.until = time;
        self
    }

    /// Sets the number of output times, equally spaced and including both ends.
    pub fn points(mut self, points: usize) -> Self {
        self.sampling = Sampling::Points(points);
        self
    }

    /// Sets the output times, sorted and within the run \[s\].
    pub fn times(mut self, times: &[f64]) -> Self {
        self.sampling = Sampling::Times(times.to_vec());
        self
    }

    /// Adds output times, as far as they lie within the run \[s\]. Changes of times, start or end
    /// after this call do not take them into account.
    pub fn also_at(mut self, more: &[f64]) -> Self {
        // Invalid times are refused by the run.
        if !more.is_empty()
            && let Ok(mut times) = self.checked_times()
        {
            let within = |time: &&f64| self.from <= **time && **time <= self.until;
            times.extend(more.iter().filter(within));
            times.sort_by(f64::total_cmp);
            times.dedup();
            self.sampling = Sampling::Times(times);
        }
        self
    }

    /// Sets the relative tolerance of every step. The absolute tolerance of a state is this times
    /// the state's scale, unless [`Simulation::atol`] is set. The scale is that of the spec. A
    /// first-order state without one gets a scale of at most 1 from its effect on other states at
    /// the start.
    pub fn rtol(mut self, rtol: f64) -> Self {
        self.rtol = rtol;
        self
    }

    /// Returns the relative tolerance of the run.
    #[must_use]
    pub fn relative_tolerance(&self) -> f64 {
        self.rtol
    }

    /// Sets the absolute tolerance of every state, each in its unit.
    pub fn atol(mut self, atol: &[f64]) -> Self {
        self.atol = Some(atol.to_vec());
        self
    }

    /// Returns the same run at another relative tolerance; absolute tolerances are scaled by the
    /// same factor.
    pub fn at_tolerance(mut self, rtol: f64) -> Self {
        let factor = rtol / self.rtol;
        self.atol.iter_mut().flatten().for_each(|atol| *atol *= factor);
        self.rtol = rtol;
        self
    }

    /// Makes this the second run of an error estimate.
    pub(crate) fn with_shortened_steps(mut self) -> Self {
        self.is_refined = true;
        self
    }

    /// Sets the method.
    pub fn method(mut self, method: Method) -> Self {
        self.method = Some(method);
        self
    }

    /// Runs by `auto` with these choices.
    #[cfg(feature = "implicit")]
    pub fn auto(mut self, choices: Auto) -> Self {
        (self.method, self.auto) = (Some(Method::Auto), choices);
        self
    }

    /// Sets the number of steps after which the run stops with an error; [`MAX_STEPS`] unless set.
    pub fn max_steps(mut self, steps: usize) -> Self {
        self.max_steps = steps;
        self
    }

    /// Stops with [`StopCause::TooSlow`] soon after a run has computed for this time; there is no
    /// limit unless set. Runs in the lanes of a sweep share the time that they take together.
    pub fn time_limit(mut self, limit: Duration) -> Self {
        self.patience.limit = Some(limit);
        self
    }

    /// Stops with [`StopCause::Interrupted`] soon after this flag is set. The error contains the
    /// run until then.
    pub fn until_flagged(mut self, flag: &'a AtomicBool) -> Self {
        self.patience.flag = Some(flag);
        self
    }

    /// Stops with the cause that `why` returns; it is called after every step. This serves callers
    /// that cannot set a flag meanwhile, and limits on several runs together.
    pub fn until_told(mut self, why: &'a dyn Fn() -> Option<StopCause>) -> Self {
        self.patience.asked = Some(why);
        self
    }

    /// Requests the derivatives of all states and outputs by these parameters, or by the initial
    /// values of these states: columns `d(output)/d(parameter)` of the trajectory, in the unit of
    /// the numerator over that of the denominator.
    ///
    /// They are derivatives of the computed solution with its steps, also through events, whose
    /// times move. If the scene's method does not carry sensitivities, another one that does is
    /// used.
    ///
    /// # Errors
    /// [`SimulateError::UnknownDirection`], with the nearest known name;
    /// [`SimulateError::NotDifferentiable`] of a mode.
    pub fn sensitivities<N: AsRef<str>>(mut self, by: &[N]) -> Result<Self, SimulateError> {
        let named = |name: &N| By::named(self.simulator, name.as_ref());
        self.sensitivities = by.iter().map(named).collect::<Result<_, _>>()?;
        Ok(self)
    }

    /// Sets whether errors of sensitivities shorten steps, as those of states do; true unless set.
    /// If false, the steps are those of a run without sensitivities. The sensitivities may then be
    /// far less accurate than the states: for example where an event excites a fast decaying motion
    /// that the states do not show.
    pub fn with_controlled_sensitivities(mut self, wanted: bool) -> Self {
        self.controls_sensitivities = wanted;
        self
    }

    /// Returns the simulator.
    #[must_use]
    pub fn simulator(&self) -> &'a dyn Simulator<f64> {
        self.simulator
    }

    /// Returns the start time of the run \[s\].
    #[must_use]
    pub fn start_time(&self) -> f64 {
        self.from
    }

    /// Returns the end time of the run \[s\].
    #[must_use]
    pub fn end_time(&self) -> f64 {
        self.until
    }

    /// Returns the state at the start and the parameters, after checking them.
    #[cfg(feature = "linear")]
    pub(crate) fn checked_start(&self) -> Result<(Vec<f64>, Vec<f64>), SimulateError> {
        let parameters = self.checked_parameters()?.to_vec();
        let mut state = self.checked_initial_state()?;
        if self.simulator.events() > 0 {
            // Modes must agree with their guards, as at the start of a run, and constraints must
            // hold.
            self.settle(&mut state)?;
            state = consistent(self.simulator, &parameters, self.from, state, &|_| false)?;
        }
        Ok((state, parameters))
    }

    pub(crate) fn chosen_method(&self) -> Result<Method, SimulateError> {
        match self.method {
            Some(method) => Ok(method),
            None => Ok(Method::from_name(self.simulator.run_defaults().method)?),
        }
    }

    /// Integrates from start to end.
    ///
    /// # Errors
    /// [`SimulateError`] if a setting is invalid or the integration stops early. In the second case
    /// the error gives time and cause, and contains the run until then.
    pub fn run(&self) -> Result<Trajectory, SimulateError> {
        let asked = self.chosen_method()?;
        let method = self.method_for_sensitivities(asked)?;
        self.run_resized(|simulation| simulation.run_sized(method, asked, None))
    }

    /// Runs by `method` instead of the requested one, and logs its steps if `log` is given.
    pub(crate) fn run_by(
        &self,
        method: Method,
        asked: Method,
        log: Option<&Log>,
    ) -> Result<Trajectory, SimulateError> {
        self.run_sized(method, asked, log).map(|sized| sized.trajectory)
    }

    /// Does the same, and measures the states.
    fn run_sized(
        &self,
        method: Method,
        asked: Method,
        log: Option<&Log>,
    ) -> Result<Sized, SimulateError> {
        if !method.is_compiled_in() {
            return Err(NotCompiledIn::of(method).into());
        }
        let scene = self.simulator.name();
        let _span = tracing::info_span!("run", scene, %method, rtol = self.rtol).entered();
        let times = self.checked_times()?;
        let parameters = self.checked_parameters()?;
        method.check(self.simulator)?;
        self.check_constant_energy()?;
        let mut initial = self.checked_initial_state()?;
        let system = System::new(self.simulator, parameters, self.energy_balance)
            .within(self.patience)
            .logged(log)
            .keeping_energy(self.keeps_energy)
            .with_tangents(self.tangents(&initial)?);
        if method != asked {
            system.note(format!("{method} instead of {asked}, which does not carry sensitivities"));
        }
        require_guards(self.simulator, parameters)?;
        self.note_projected(&system, &initial);
        self.negative_inertia_at(&initial).into_iter().for_each(|note| system.note(note));
        self.note_little_inertia(&system, &initial);
        #[cfg(feature = "linear")]
        self.note_unstable(&system, &initial);
        let states = system.states();
        let mut atol = self.checked_atol(&initial)?;
        let energy_atol = self.rtol * self.energy_scale(&initial);
        initial.resize(system.len(), 0.0);
        atol.resize(system.len(), energy_atol);

        let machine = (self.simulator, parameters);
        let mut tolerance = StepTolerance::new((method, self.auto), machine, (self.rtol, atol));
        tolerance.shortens = self.is_refined;
        let problem = Problem {
            system: &system,
            from: self.from,
            until: self.until,
            times: &times,
            initial,
            jumps: self.checked_jumps()?,
            tolerance,
            auto: self.auto,
            max_steps: self.max_steps,
        };
        let (run, stopped) = problem.integrate_kept(method);
        if system.has_stepped() {
            self.note_tolerance(&system, &problem.tolerance, &run.rows);
        }
        let energy_at_start = self.total_energy(&problem.initial[..states]);
        let Some(Stopped { time, cause }) = stopped else {
            let stepped = system.has_stepped();
            let sizes = if stepped { Self::sizes(&system, &run.rows) } else { Vec::new() };
            let StepTolerance { rtol, atol, .. } = &problem.tolerance;
            let scales = atol.iter().map(|atol| atol / rtol).collect();
            let trajectory = self.trajectory(method, &system, &times, run, energy_at_start);
            return Ok(Sized { trajectory, sizes, scales });
        };
        let cause = self.with_parameters(cause, &problem.initial[..states]);
        let mut kept = self.trajectory(method, &system, &times, run, energy_at_start);
        kept.stopped = Some(Stop { time, cause: cause.to_string() });
        Err(SimulateError::Stopped {
            scene: self.simulator.name().to_owned(),
            method: method.name(),
            time,
            cause,
            kept: Some(Box::new(kept)),
        })
    }

    /// Returns the requested method if it carries sensitivities or none are requested. If no method
    /// was chosen, returns one that carries them.
    fn method_for_sensitivities(&self, asked: Method) -> Result<Method, SimulateError> {
        let is_left_open = self.method.is_none();
        if self.sensitivities.is_empty() || asked.carries_sensitivities() {
            Ok(asked)
        } else if is_left_open {
            Ok(asked.for_sensitivities())
        } else {
            let known = Method::ALL.iter().filter(|method| method.carries_sensitivities());
            let known = known.map(|method| method.name()).collect::<Vec<_>>().join(", ");
            Err(SimulateError::NoSensitivities { method: asked.name(), known })
        }
    }

    /// Returns the sensitivities at the start; `None` if none are requested.
    fn tangents(&self, initial: &[f64]) -> Result<Option<Tangents<'_>>, SimulateError> {
        if self.sensitivities.is_empty() {
            return Ok(None);
        }
        let by = (self.sensitivities.clone(), self.controls_sensitivities);
        let tangents = Tangents::new(self.simulator, &self.parameters, by, self.from)?;
        let is_of_spec = self.initial_state.is_none();
        let set: Vec<usize> = self.initial_values.iter().map(|(index, _)| *index).collect();
        let named = self.starts_in_equilibrium().then(|| self.named());
        let (time, in_equilibrium) = (self.from, named.as_deref());
        let start = Start { time, state: initial, is_of_spec, set: &set, in_equilibrium };
        if !tangents.begin(&start)? {
            self.check_tangents(&tangents, initial)?;
        }
        Ok(Some(tangents))
    }

    fn trajectory(
        &self,
        method: Method,
        system: &System<'_>,
        times: &[f64],
        run: Run,
        energy_at_start: f64,
    ) -> Trajectory {
        let Run { rows, switches, taken } = run;
        let times = times[..taken].to_vec();
        let mut table = Table::new(self.simulator, times.len());
        let width = system.len();
        for (index, time) in times.iter().enumerate() {
            table.push(*time, &rows[index * width..(index + 1) * width], &self.parameters);
        }
        let energy_balance =
            self.energy_balance.then(|| table.energy_balance(&rows, width, energy_at_start));
        table.note_not_finite(system, &times);
        let mut columns_of_run = table.into_columns(energy_balance.as_ref());
        if let Some(tangents) = system.tangents() {
            columns_of_run.extend(columns(self.simulator, tangents, &times, (&rows, width)));
        }
        Trajectory {
            scene: self.simulator.name().to_owned(),
            title: self.simulator.title().to_owned(),
            method,
            rtol: self.rtol,
            work: system.work(),
            notes: system.notes(),
            stopped: None,
            switches,
            drift: system.constraints().map(Constraints::drift),
            times,
            columns: columns_of_run,
            energy_balance,
            error: None,
        }
    }
}
