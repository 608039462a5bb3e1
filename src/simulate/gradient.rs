//! The gradient of one number of a run by all parameters and initial values, in reverse.

use super::Simulation;
use crate::error::SimulateError;
use crate::method::reverse::{Log, Pulled, WayBack};
use crate::method::sensitivity::{By, Tangents};
use crate::method::{Method, System};
use crate::trajectory::Trajectory;

/// How a number depends on a column of a run: its derivative by every value of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Pull {
    /// A state or an output.
    pub column: String,
    /// d(number)/d(value), one for each sampled time.
    pub slopes: Vec<f64>,
}

/// A number's derivative by a parameter or by the initial value of a state.
#[derive(Debug, Clone, PartialEq)]
pub struct Slope {
    /// Name of the parameter or state.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Whether it is a parameter.
    pub is_parameter: bool,
    /// What it is in the run, in its unit.
    pub at: f64,
    /// d(number)/d(it).
    pub value: f64,
}

/// The derivatives of a number of a run by everything it is given.
#[derive(Debug, Clone)]
pub struct Gradient {
    /// The run.
    pub run: Trajectory,
    /// By every parameter, then by every initial value, in the order of the simulator.
    pub slopes: Vec<Slope>,
}

impl Simulation<'_> {
    /// Runs, and gives the derivatives of one number of the run by all parameters and initial
    /// values at once: in reverse, for what a few runs cost, however many there are.
    ///
    /// `of` is given the run and says how the number depends on its columns; those it names
    /// several times add up. Derivatives are those of what the method computes with the steps it
    /// takes, as [`Simulation::sensitivities`] without control of their errors gives them.
    ///
    /// By `tsit5` or `dop853`, which takes the place of a method that is left to the scene.
    ///
    /// # Errors
    /// [`SimulateError::NotReversible`] of a machine with events, kinks or constraints, which
    /// [`Simulation::sensitivities`] are there for; of a pull of another length than the run, or
    /// by a column that is none of its states and outputs. Else as [`Simulation::run`].
    pub fn gradient(
        &self,
        of: impl FnOnce(&Trajectory) -> Vec<Pull>,
    ) -> Result<Gradient, SimulateError> {
        self.require_smooth()?;
        let asked = self.chosen_method()?;
        let is_left_open = matches!(self.method, None | Some(Method::Auto));
        let method = match WayBack::of(asked) {
            None if is_left_open => Method::Dop853,
            _ => asked,
        };
        let way_back = WayBack::of(method).ok_or_else(|| {
            let known = Method::ALL.iter().filter(|method| WayBack::of(**method).is_some());
            let known = known.map(|method| method.name()).collect::<Vec<_>>().join(", ");
            SimulateError::NoSensitivities { method: asked.name(), known }
        })?;
        let alone = Self { sensitivities: Vec::new(), energy_balance: false, ..self.clone() };
        let log = Log::default();
        let run = alone.run_by(method, method, Some(&log))?;
        let shape = self.simulator.shape();
        let parameters = (0..shape.parameters).map(By::Parameter);
        let by: Vec<By> = parameters.chain((0..shape.states()).map(By::Initial)).collect();
        let everything = Self { sensitivities: by.clone(), ..alone };
        let initial = everything.checked_initial_state()?;
        let system = System::new(self.simulator, &self.parameters, false);
        let tangents = everything.tangents(&initial)?.ok_or_else(|| {
            SimulateError::NoDerivatives { scene: self.simulator.name().to_owned() }
        })?;
        let start = tangents.start();
        let (by_states, mut by_all) = self.pulls(&run, &of(&run), &tangents)?;
        let mut by_parameters = vec![0.0; shape.parameters];
        let mut stopped = None;
        let mut begins = |time: f64, lambda: &[f64], state: &[f64]| {
            if time > self.from {
                tangents.restart(&vec![0.0; tangents.len()]);
                stopped = stopped
                    .take()
                    .or(tangents.jump(&system, (time, state), (time, state), false).err());
                let shifted = tangents.pulled(lambda);
                by_all.iter_mut().zip(shifted).for_each(|(sum, shifted)| *sum += shifted);
            }
        };
        let pulled = Pulled { times: &run.times, by_states: &by_states, begins: &mut begins };
        let lambda = way_back.pull_back(&system, log, pulled, &mut by_parameters);
        if let Some(stopped) = stopped {
            let (scene, method) = (self.simulator.name().to_owned(), method.name());
            let (time, cause) = (stopped.time, stopped.cause);
            return Err(SimulateError::Stopped { scene, method, time, cause, kept: None });
        }
        tangents.restart(&start);
        by_parameters.resize(by.len(), 0.0);
        let of_start = tangents.pulled(&lambda);
        let values = by_all.iter().zip(&by_parameters).zip(&of_start).map(|((a, b), c)| a + b + c);
        let slopes = by.iter().zip(values).map(|(by, value)| {
            let quantity = by.quantity(self.simulator);
            let (is_parameter, at) = match by {
                By::Parameter(index) => (true, self.parameters[*index]),
                By::Initial(index) => (false, initial[*index]),
            };
            let (name, unit) = (quantity.name.to_owned(), quantity.unit.to_owned());
            Slope { name, unit, is_parameter, at, value }
        });
        Ok(Gradient { slopes: slopes.collect(), run })
    }

    /// Whether steps can be gone back over.
    #[must_use]
    pub fn is_reversible(&self) -> bool {
        self.require_smooth().is_ok()
    }

    fn require_smooth(&self) -> Result<(), SimulateError> {
        let simulator = self.simulator;
        let why = if simulator.events() > 0 {
            "it has events"
        } else if simulator.constraints() > 0 {
            "it has constraints"
        } else if simulator.kinks() > 0 {
            "its rate has kinks"
        } else {
            return Ok(());
        };
        Err(SimulateError::NotReversible { scene: simulator.name().to_owned(), why })
    }

    /// What pulls are of the states at the sampled times, and by parameters and initial values
    /// where outputs read them, all other things being equal.
    fn pulls(
        &self,
        run: &Trajectory,
        pulls: &[Pull],
        tangents: &Tangents<'_>,
    ) -> Result<(Vec<f64>, Vec<f64>), SimulateError> {
        let shape = self.simulator.shape();
        let (states, rows) = (shape.states(), run.times.len());
        let mut of_states = vec![0.0; rows * states];
        let mut of_outputs = vec![0.0; rows * shape.outputs];
        for pull in pulls {
            let place = run.columns.iter().position(|column| column.name == pull.column);
            let place = place.filter(|place| *place < states + shape.outputs);
            let (place, true) = (place.unwrap_or_default(), place.is_some()) else {
                let why = "a pull is by a column that is no state and no output";
                return Err(SimulateError::NotReversible { scene: run.scene.clone(), why });
            };
            if pull.slopes.len() != rows {
                let why = "a pull has another length than the run";
                return Err(SimulateError::NotReversible { scene: run.scene.clone(), why });
            }
            let (into, width, place) = match place.checked_sub(states) {
                None => (&mut of_states, states, place),
                Some(output) => (&mut of_outputs, shape.outputs, output),
            };
            for (row, slope) in pull.slopes.iter().enumerate() {
                into[row * width + place] += slope;
            }
        }
        // S of what is differentiated by itself: every initial value stands for its state.
        let count = tangents.by().len();
        let mut unit = vec![0.0; states * count];
        (0..states).for_each(|state| unit[state * count + shape.parameters + state] = 1.0);
        let mut by_all = vec![0.0; count];
        for (row, time) in run.times.iter().enumerate() {
            let pull = &of_outputs[row * shape.outputs..][..shape.outputs];
            if pull.iter().all(|slope| *slope == 0.0) {
                continue;
            }
            let state: Vec<f64> =
                run.columns[..states].iter().map(|column| column.values[row]).collect();
            let slopes = tangents.of_outputs(shape.outputs, &[*time], (&state, states), &unit);
            let into = &mut of_states[row * states..][..states];
            for (slopes, pull) in slopes.chunks_exact(count).zip(pull) {
                let (by_parameters, by_states) = slopes.split_at(shape.parameters);
                let sums =
                    by_all.iter_mut().zip(by_parameters).chain(into.iter_mut().zip(by_states));
                sums.for_each(|(sum, slope)| *sum += pull * slope);
            }
        }
        Ok((of_states, by_all))
    }
}
