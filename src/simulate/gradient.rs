//! Gradient of one number of a run by all parameters and initial values, by the adjoint method.

use super::Simulation;
use crate::error::SimulateError;
use crate::method::reverse::{Log, Pulled, WayBack};
use crate::method::sensitivity::{By, Tangents};
use crate::method::{Method, System};
use crate::trajectory::Trajectory;

/// Derivatives of a number by the values of one column of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Pull {
    /// Name of a state or an output.
    pub column: String,
    /// d(number)/d(value), one for each output time.
    pub slopes: Vec<f64>,
}

/// Derivative of a number by a parameter or by the initial value of a state.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Slope {
    /// Name of the parameter or state.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// True if it belongs to a parameter.
    pub is_parameter: bool,
    /// Value of the parameter or state in the run, in its unit.
    pub at: f64,
    /// d(number)/d(parameter or initial value).
    pub value: f64,
}

/// Derivatives of a number of a run by all parameters and initial values.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Gradient {
    /// The run.
    pub run: Trajectory,
    /// Derivatives by every parameter, then by every initial value, in the simulator's order.
    pub slopes: Vec<Slope>,
}

impl Simulation<'_> {
    /// Runs, and returns the derivatives of one number of the run by all parameters and initial
    /// values. The adjoint method costs as much as a few runs, however many parameters there are.
    ///
    /// `of` receives the run and returns the dependence of the number on its columns; entries for
    /// the same column add up. The derivatives are those of the computed solution with its steps,
    /// like those of [`Simulation::sensitivities`] without control of their errors.
    ///
    /// The method is `tsit5` or `dop853`, which also replaces a method that is left to the scene.
    ///
    /// # Errors
    /// [`SimulateError::NotReversible`] for a machine with events, switching surfaces or
    /// constraints, for which [`Simulation::sensitivities`] can be used; for a pull whose length
    /// differs from that of the run, or whose column is not a state or output. Otherwise as for
    /// [`Simulation::run`].
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
                let mut rate = vec![0.0; system.len()];
                system.rate(time.next_down(), state, &mut rate);
                let jumped = tangents.jump(&system, (time, state, &rate), (time, state), false);
                stopped = stopped.take().or(jumped.err());
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

    /// Returns whether the steps of the run can be reversed.
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
            "its rate has switching surfaces"
        } else {
            return Ok(());
        };
        Err(SimulateError::NotReversible { scene: simulator.name().to_owned(), why })
    }

    /// Converts pulls to derivatives by the states at output times, and to direct derivatives by
    /// parameters and initial values that outputs contain.
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
        // S of the parameters themselves: every initial value stands for its state.
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
