//! `machinist run --fixed`: steps of a fixed length, as emitted C99 takes them, compared with the
//! adaptive run.

use clap::Args;
use machinist::Simulation;
use machinist::linear_analysis::{Place, operating_point};
use machinist::trajectory::{Column, ColumnKind, Trajectory};
use machinist_contract::Simulator;
use machinist_contract::fixed_step::{Clock, FixedSteps, Room, StepMethod, Stepped};
use machinist_model::Elimination;

use super::columns;
use crate::cli::amount::time;
use crate::failure::Failure;
use crate::number::number;

#[derive(Debug, Args)]
pub struct Options {
    /// Use fixed steps of this size, `1ms`, as emitted C99 does, and report errors relative to the
    /// adaptive run
    #[arg(long, value_name = "TIME", value_parser = time, allow_hyphen_values = true, conflicts_with_all = ["sensitivities", "modes"])]
    fixed: Option<f64>,
    /// With --fixed: step method, rk4, heun or ros2. Default: rk4
    #[arg(long, value_name = "NAME", requires = "fixed", value_parser = step_method)]
    step_method: Option<StepMethod>,
}

/// Returns the method of a name.
pub fn step_method(name: &str) -> Result<StepMethod, String> {
    let found = StepMethod::ALL.into_iter().find(|method| method.name() == name);
    found.ok_or_else(|| {
        let names = StepMethod::ALL.map(StepMethod::name).join(", ");
        format!("known are {names}")
    })
}

/// Maximum number of steps of a run.
const MOST_STEPS: f64 = 1e9;

/// Settings of fixed steps.
pub struct Fixed {
    step: f64,
    method: StepMethod,
    /// Hint where the state does not remain finite.
    advice: &'static str,
}

/// Result of fixed steps.
pub struct Stepping {
    times: Vec<f64>,
    /// State at each time.
    states: Vec<Vec<f64>>,
    steps: usize,
    step: f64,
    events: usize,
    /// Number of steps that exceeded the maximum number of parts.
    crowded: usize,
}

impl Options {
    /// Returns the settings, if fixed steps are asked for.
    pub fn asked(&self) -> Result<Option<Fixed>, Failure> {
        let Some(step) = self.fixed else { return Ok(None) };
        if !(step > 0.0 && step.is_finite()) {
            let message = format!("--fixed {step}: the step size must be finite and above zero");
            return Err(Failure::input(message, "such as `--fixed 1e-4`, in seconds"));
        }
        let advice = "use smaller steps, or `--step-method ros2` for a stiff machine";
        Ok(Some(Fixed { step, method: self.step_method.unwrap_or_default(), advice }))
    }
}

/// Largest error of fixed steps, away from events.
#[cfg(feature = "derive")]
pub struct LargestError {
    /// Error relative to the range of the quantity in the adaptive run.
    pub relative: f64,
    /// Name of the output, or of the state if the scene has no outputs.
    pub name: String,
}

impl Fixed {
    /// Creates the settings from a step size \[s\], above zero, a method, and the hint for steps
    /// that are too large.
    #[cfg(feature = "derive")]
    pub fn of(step: f64, method: StepMethod, advice: &'static str) -> Self {
        Self { step, method, advice }
    }

    /// Takes steps over the time of a run, with about `rows` rows. The steps are shortened so that
    /// their number is whole.
    pub fn run(&self, run: &Simulation<'_>, until: f64, rows: usize) -> Result<Stepping, Failure> {
        let simulator = run.simulator();
        let point = operating_point(run, Place::Initial)?;
        let (from, mut state) = (point.time, point.state);
        if until <= from {
            let message = format!("the run ends at {until} s, which is not after {from} s");
            return Err(Failure::input(message, "`--until` and `--from` set both"));
        }
        let wanted = (until - from) / self.step;
        if wanted > MOST_STEPS {
            let message = format!("--fixed {}: the run would take {wanted:.0} steps", self.step);
            return Err(Failure::input(message, "use larger steps or a shorter run"));
        }
        // A step that fits up to rounding is not shortened.
        let steps = (wanted * (1.0 - 1e-9)).ceil().max(1.0) as usize;
        let (step, every) = ((until - from) / steps as f64, (steps / rows).max(1));
        let pattern = simulator.rate_jacobian_pattern();
        let elimination = Elimination::new(state.len(), pattern.entries);
        let mut constants = vec![0.0; simulator.constants()];
        simulator.prepare(&point.parameters, &mut constants);
        let machine = FixedSteps {
            simulator,
            parameters: &point.parameters,
            constants: &constants,
            method: self.method.with(elimination.borrowed()),
            parts_a_step: FixedSteps::enough_parts(simulator),
        };
        let [numbers, signs] = machine.room();
        let (mut numbers, mut signs) = (vec![0.0; numbers], vec![0; signs]);
        let mut room = Room { numbers: &mut numbers, signs: &mut signs };
        let mut clock = Clock::new(from);
        machine.settle(from, &mut state, &mut room);
        let mut stepping = Stepping {
            times: vec![from],
            states: vec![state.clone()],
            steps,
            step,
            events: 0,
            crowded: 0,
        };
        for index in 1..=steps {
            match machine.step(clock.time(), step, &mut state, &mut room) {
                Stepped::Events(events) => stepping.events += events,
                Stepped::TooManyParts => stepping.crowded += 1,
            }
            clock.pass(step);
            if index == steps || index % every == 0 {
                stepping.times.push(if index == steps { until } else { clock.time() });
                stepping.states.push(state.clone());
            }
        }
        if let Some(lost) = stepping.first_lost() {
            let message = format!(
                "{} with steps of {step:.3e} s: the state is not finite at {lost} s",
                self.method.name()
            );
            return Err(Failure::unsuccessful(message, self.advice));
        }
        Ok(stepping)
    }

    /// Replaces the adaptive run by the steps, with a column of errors after each state and output.
    /// Returns a summary of the errors.
    pub fn compare(
        &self,
        stepping: &Stepping,
        simulator: &dyn Simulator<f64>,
        parameters: &[f64],
        adaptive: &mut Trajectory,
    ) -> String {
        let shape = simulator.shape();
        let mut outputs = vec![vec![0.0; shape.outputs]; stepping.times.len()];
        for ((time, state), outputs) in
            stepping.times.iter().zip(&stepping.states).zip(&mut outputs)
        {
            simulator.outputs(*time, state, parameters, outputs);
        }
        let mut compared = Vec::new();
        let mut lines = vec![["", "unit", "final", "greatest", "largest error"].map(str::to_owned)];
        for (kind, of) in [(ColumnKind::State, &stepping.states), (ColumnKind::Output, &outputs)] {
            let columns: Vec<Column> = adaptive.of_kind(kind).cloned().collect();
            for (entry, exact) in columns.into_iter().enumerate() {
                let values: Vec<f64> = of.iter().map(|row| row[entry]).collect();
                let errors: Vec<f64> =
                    values.iter().zip(&exact.values).map(|(value, exact)| value - exact).collect();
                let largest = |values: &[f64]| values.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
                let last = values.last().copied().unwrap_or(f64::NAN);
                let shown = [last, largest(&values), largest(&errors)];
                let [last, greatest, error] = shown.map(|value| number(value, 6));
                lines.push([exact.name.clone(), exact.unit.clone(), last, greatest, error]);
                let name = format!("error({})", exact.name);
                compared.push(Column { values, ..exact.clone() });
                compared.push(Column { name, values: errors, ..exact });
            }
        }
        adaptive.columns = compared;
        adaptive.energy_balance = None;
        let parts = match stepping.crowded {
            0 => String::new(),
            some => format!("\n{some} steps have more parts than allowed: use smaller steps"),
        };
        format!(
            "{}: {}\n{} steps of {:e} s by {}, {} events{parts}\nerrors against {}, rtol {:e}\n\n{}",
            adaptive.scene,
            adaptive.title,
            stepping.steps,
            stepping.step,
            self.method.meaning(),
            stepping.events,
            adaptive.method,
            adaptive.rtol,
            columns(&lines, 2)
        )
    }
}

impl Stepping {
    /// Times of the states.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// Returns the largest error of an output, or of a state if there are no outputs, against an
    /// adaptive run with the same times. Within a step of an event of that run, both may be on
    /// different sides of it.
    #[cfg(feature = "derive")]
    pub fn largest_error(&self, run: &Simulation<'_>, exact: &Trajectory) -> LargestError {
        let simulator = run.simulator();
        let mut outputs = vec![0.0; simulator.shape().outputs];
        let kind = if outputs.is_empty() { ColumnKind::State } else { ColumnKind::Output };
        let columns: Vec<&Column> = exact.of_kind(kind).collect();
        let range = |values: &[f64]| {
            let [low, high] = [f64::min, f64::max].map(|of| values.iter().copied().reduce(of));
            let size = values.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
            // A constant has no range of its own.
            let range = high.unwrap_or(0.0) - low.unwrap_or(0.0);
            range.max(1e-6 * size).max(f64::MIN_POSITIVE)
        };
        let ranges: Vec<f64> = columns.iter().map(|column| range(&column.values)).collect();
        let mut largest = LargestError { relative: 0.0, name: String::new() };
        for (row, (time, state)) in self.times.iter().zip(&self.states).enumerate() {
            let is_near = |event: f64| (event - time).abs() <= 1.5 * self.step;
            if exact.switches.iter().any(|switch| is_near(switch.time)) {
                continue;
            }
            simulator.outputs(*time, state, run.parameter_values(), &mut outputs);
            let values = if kind == ColumnKind::Output { &outputs } else { state };
            for ((value, column), range) in values.iter().zip(&columns).zip(&ranges) {
                let relative = (value - column.values[row]).abs() / range;
                let relative = if relative.is_nan() { f64::INFINITY } else { relative };
                if relative > largest.relative || largest.name.is_empty() {
                    largest = LargestError { relative, name: column.name.clone() };
                }
            }
        }
        largest
    }

    /// Returns the first time at which the state is not finite.
    fn first_lost(&self) -> Option<f64> {
        let mut rows = self.times.iter().zip(&self.states);
        rows.find(|(_, state)| state.iter().any(|value| !value.is_finite())).map(|(time, _)| *time)
    }
}
