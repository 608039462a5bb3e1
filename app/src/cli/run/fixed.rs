//! `machinist run --fixed`: steps of a fixed length, as emitted C99 takes them, compared with the
//! adaptive run.

use std::path::Path;

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
use crate::plot::{PlotError, plot_errors};

#[derive(Debug, Args)]
pub struct Options {
    /// Use fixed steps of this size, `1ms`, as emitted C99 does, and report errors relative to the
    /// adaptive run; of several sizes, `2ms,1ms`, report and plot the errors over the size
    #[arg(long, value_name = "TIMES", value_parser = time, value_delimiter = ',', allow_hyphen_values = true, conflicts_with_all = ["sensitivities", "modes"])]
    fixed: Vec<f64>,
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

/// Returns the largest of errors, the first of equal ones.
fn worst(errors: Vec<LargestError>) -> Option<LargestError> {
    errors.into_iter().rev().max_by(|a, b| a.relative.total_cmp(&b.relative))
}

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
    /// Returns the settings for each size of fixed steps that is asked for.
    pub fn asked(&self) -> Result<Vec<Fixed>, Failure> {
        let settings = |&step: &f64| {
            if !(step > 0.0 && step.is_finite()) {
                let message =
                    format!("--fixed {step}: the step size must be finite and above zero");
                return Err(Failure::input(message, "such as `--fixed 1e-4`, in seconds"));
            }
            let advice = "use smaller steps, or `--step-method ros2` for a stiff machine";
            Ok(Fixed { step, method: self.step_method.unwrap_or_default(), advice })
        };
        self.fixed.iter().map(settings).collect()
    }
}

/// Largest error of fixed steps, away from events.
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
        if let Some(friction) = FixedSteps::unsuitable(simulator) {
            let message = format!(
                "--fixed: constraint `{}` is of friction whose speed jumps at a place, which fixed \
                 steps do not find in time",
                friction.name
            );
            let hint = "let the speed change over a short distance, such as by \
                        `min(max((x - x0)/1e-3, 0), 1)`";
            return Err(Failure::input(message, hint));
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

    /// Returns the largest error of any output, or of any state if there are no outputs, as
    /// [`Stepping::errors`].
    #[cfg(feature = "derive")]
    pub fn largest_error(&self, run: &Simulation<'_>, exact: &Trajectory) -> LargestError {
        let none = LargestError { relative: 0.0, name: String::new() };
        worst(self.errors(run, exact)).unwrap_or(none)
    }

    /// Returns the largest error of each output, or of each state if there are no outputs, against
    /// an adaptive run with the same times. Within a step of an event of that run, both may be on
    /// different sides of it.
    pub fn errors(&self, run: &Simulation<'_>, exact: &Trajectory) -> Vec<LargestError> {
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
        let none = |column: &&Column| LargestError { relative: 0.0, name: column.name.clone() };
        let mut largest: Vec<LargestError> = columns.iter().map(none).collect();
        for (row, (time, state)) in self.times.iter().zip(&self.states).enumerate() {
            let is_near = |event: f64| (event - time).abs() <= 1.5 * self.step;
            if exact.switches.iter().any(|switch| is_near(switch.time)) {
                continue;
            }
            simulator.outputs(*time, state, run.parameter_values(), &mut outputs);
            let values = if kind == ColumnKind::Output { &outputs } else { state };
            for (entry, value) in values.iter().enumerate() {
                let relative = (value - columns[entry].values[row]).abs() / ranges[entry];
                let relative = if relative.is_nan() { f64::INFINITY } else { relative };
                largest[entry].relative = largest[entry].relative.max(relative);
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

/// Errors of fixed steps of several sizes.
#[derive(Default)]
pub struct OverSteps {
    /// Sizes \[s\].
    sizes: Vec<f64>,
    /// Number of steps and of events, and errors of the outputs, for each size.
    runs: Vec<(usize, usize, Vec<LargestError>)>,
}

impl OverSteps {
    /// Adds a run.
    pub fn push(&mut self, stepping: &Stepping, errors: Vec<LargestError>) {
        self.sizes.push(stepping.step);
        self.runs.push((stepping.steps, stepping.events, errors));
    }

    /// Draws the errors over the size of steps. Errors that vanish have no place on the axis.
    pub fn plot(&self, texts: [&str; 2], path: &Path) -> Result<(), PlotError> {
        let mut ascending: Vec<usize> = (0..self.sizes.len()).collect();
        ascending.sort_by(|&a, &b| self.sizes[a].total_cmp(&self.sizes[b]));
        let sizes: Vec<f64> = ascending.iter().map(|&run| self.sizes[run]).collect();
        let names = self.runs.first().into_iter().flat_map(|(.., errors)| errors).enumerate();
        let curve = |(entry, of): (usize, &LargestError)| {
            let errors = ascending.iter().map(|&run| self.runs[run].2[entry].relative);
            (of.name.clone(), errors.collect::<Vec<f64>>())
        };
        let curves: Vec<(String, Vec<f64>)> =
            names.map(curve).filter(|(_, errors)| errors.iter().all(|&e| e > 0.0)).collect();
        plot_errors(&sizes, curves, texts, path)
    }

    /// Returns a table with the largest error of each size, and the order between sizes.
    pub fn table(self) -> String {
        let heads = ["step [s]", "steps", "events", "largest error", "of", "order"];
        let mut lines = vec![heads.map(str::to_owned)];
        let mut before: Option<(f64, f64)> = None;
        for (size, (steps, events, errors)) in self.sizes.into_iter().zip(self.runs) {
            let Some(LargestError { relative, name }) = worst(errors) else { continue };
            let order = before.map(|(last, error)| (error / relative).ln() / (last / size).ln());
            let order = order.filter(|order| order.is_finite());
            let order = order.map_or_else(String::new, |order| format!("{order:.2}"));
            let error = number(relative, 3);
            lines.push([
                number(size, 4),
                steps.to_string(),
                events.to_string(),
                error,
                name,
                order,
            ]);
            before = Some((size, relative));
        }
        columns(&lines, 0)
    }
}
