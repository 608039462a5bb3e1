//! Runs of all samples, in lanes and on threads, and the tables made of them.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use machinist::error::StopCause;
use machinist::improve::Expression;
use machinist::scatter::{Design, Groups, Points, Saltelli, ScatterError, Summary, value_over};
use machinist::sweep::VariantRun;
use machinist::trajectory::{self, ColumnKind, Trajectory};
use machinist::{Method, SimulateError, Simulation};
use machinist_contract::Simulator;

use super::inputs::Inputs;
use super::{Results, ScatterCommand};
use crate::cli::improve::units;
use crate::cli::scene::Scene;
use crate::cli::variants::Variants;
use crate::failure::{ErrorCode, Failure};
use crate::parquet::{Column, Values};
use crate::progress::spinner;

/// Number of runs between looks at the interrupt.
const BATCH: usize = 4096;
/// Time between two writings of the table.
const BETWEEN_SAVES: Duration = Duration::from_secs(60);
/// Maximum number of stored values of outputs over time, 512 MB.
const MAX_STORED: usize = 1 << 26;

/// Points to be run.
pub struct Plan {
    kind: Kind,
    names: Vec<String>,
}

enum Kind {
    Plain(Points),
    Saltelli(Saltelli),
}

impl Plan {
    pub fn new(design: Design, with_indices: bool, inputs: &Inputs) -> Result<Self, Failure> {
        let wrong = |error: ScatterError| {
            let help = "--sampler random and --sampler latin have no limit of dimensions";
            let help = if matches!(error, ScatterError::Dimensions(_)) { help } else { "" };
            Failure::input(error, help)
        };
        let kind = if with_indices {
            Kind::Saltelli(Saltelli::new(design).map_err(wrong)?)
        } else {
            Kind::Plain(design.points().map_err(wrong)?)
        };
        Ok(Self { kind, names: inputs.names.clone() })
    }

    /// Returns the number of runs.
    pub fn len(&self) -> usize {
        match &self.kind {
            Kind::Plain(points) => points.len(),
            Kind::Saltelli(design) => design.rows().saturating_mul(design.row_length()),
        }
    }

    /// Returns which samples are independent of each other.
    pub fn groups(&self) -> Groups {
        match &self.kind {
            Kind::Plain(points) => points.groups(),
            Kind::Saltelli(design) => design.groups(),
        }
    }

    /// Returns the number of runs of a row of a Saltelli design.
    pub fn row_length(&self) -> Option<usize> {
        match &self.kind {
            Kind::Plain(_) => None,
            Kind::Saltelli(design) => Some(design.row_length()),
        }
    }

    /// Returns points in the order of runs, about [`BATCH`] of them.
    pub fn batch(&self, from: usize) -> Vec<Vec<f64>> {
        match &self.kind {
            Kind::Plain(points) => {
                (from..points.len().min(from + BATCH)).map(|index| points.get(index)).collect()
            }
            Kind::Saltelli(design) => {
                let length = design.row_length();
                let rows = BATCH.div_ceil(length);
                let first = from / length;
                (first..design.rows().min(first + rows)).flat_map(|row| design.row(row)).collect()
            }
        }
    }

    /// Returns the values of a quantity as samples for statistics: those of all runs, or, of a
    /// Saltelli design, those at its points A, then B. Their places keep the order of groups.
    pub fn samples<T: Copy>(&self, values: &[T]) -> Vec<T> {
        let Some(length) = self.row_length() else { return values.to_vec() };
        let rows = values.len() / length;
        let of = |point: usize| (0..rows).map(move |row| values[row * length + point]);
        of(0).chain(of(1)).collect()
    }

    /// Names the kind of each point of a Saltelli design.
    fn point_name(&self, index: usize) -> Option<String> {
        let place = index % self.row_length()?;
        Some(match place {
            0 => "A".to_owned(),
            1 => "B".to_owned(),
            place => format!("A with {} of B", self.names[place - 2]),
        })
    }
}

/// Outcome of one run.
pub struct Outcome {
    /// Values of the parameters that vary.
    pub parameters: Vec<f64>,
    /// Values of the expressions, or the reason why there are none.
    pub values: Result<Vec<f64>, String>,
    /// Number of steps.
    pub steps: u64,
}

/// All runs that were done.
pub struct Ran {
    outcomes: Vec<Outcome>,
    stored: Stored,
    /// True if Ctrl-C ended the runs.
    pub is_interrupted: bool,
}

/// Values of columns over time.
#[derive(Default)]
struct Stored {
    times: Vec<f64>,
    /// Names of columns.
    columns: Vec<String>,
    /// Values of each column at each time, one for each stored run.
    values: Vec<Vec<Vec<f64>>>,
    count: usize,
    /// Reason why no more runs are stored.
    full: bool,
    /// True if runs have different output times.
    differ: bool,
}

/// Runs points of one machine.
pub struct Runner<'a> {
    command: &'a ScatterCommand,
    scene: &'a Scene,
    inputs: &'a Inputs,
    expressions: Vec<&'a Expression>,
    points: Option<usize>,
    flag: &'a AtomicBool,
    /// Names of columns that are stored over time.
    columns: Vec<String>,
}

impl<'a> Runner<'a> {
    pub fn new(
        command: &'a ScatterCommand,
        scene: &'a Scene,
        inputs: &'a Inputs,
        results: &'a Results,
        flag: &'a AtomicBool,
    ) -> Result<Self, Failure> {
        let points = command.points_of(results);
        let expressions = results.expressions();
        let columns = wanted(command, scene.simulator())?;
        Ok(Self { command, scene, inputs, expressions, points, flag, columns })
    }

    /// Returns the parameters that vary.
    pub fn inputs(&self) -> &Inputs {
        self.inputs
    }

    /// Returns the seed and the confidence asked for.
    pub fn settings(&self) -> &ScatterCommand {
        self.command
    }

    fn settings_of_runs(&self) -> Variants<'a> {
        let ScatterCommand { scene, run, threads, .. } = self.command;
        Variants { scene, run, points: self.points, threads: *threads, flag: Some(self.flag) }
    }

    fn is_interrupted(&self) -> bool {
        self.flag.load(Ordering::Relaxed)
    }

    /// Runs what is left of the plan after the outcomes `done`, or until Ctrl-C. Meanwhile `save` is
    /// called every minute.
    pub fn run(
        &self,
        plan: &Plan,
        done: Vec<Outcome>,
        save: &dyn Fn(&Ran) -> Result<(), Failure>,
    ) -> Result<Ran, Failure> {
        self.check_first_run()?;
        let spinner = spinner("simulating");
        let mut stored = Stored { columns: self.columns.clone(), ..Stored::default() };
        let mut outcomes = done;
        let mut saved = Instant::now();
        while outcomes.len() < plan.len() && !self.is_interrupted() {
            let points = plan.batch(outcomes.len());
            let keep = |run: &VariantRun| stored.add(self.scene.simulator(), run);
            let batch = self.outcomes(&points, keep)?;
            let whole = batch.len() == points.len();
            outcomes.extend(batch);
            if !whole {
                break;
            }
            spinner.set_message(format!("simulating: {} of {} runs", outcomes.len(), plan.len()));
            if saved.elapsed() > BETWEEN_SAVES {
                let ran = Ran { outcomes, stored, is_interrupted: true };
                save(&ran)?;
                Ran { outcomes, stored, .. } = ran;
                saved = Instant::now();
            }
        }
        spinner.finish_and_clear();
        let is_interrupted = self.is_interrupted() && outcomes.len() < plan.len();
        if let Some(Outcome { values: Err(first), .. }) = outcomes.first()
            && outcomes.iter().all(|outcome| outcome.values.is_err())
        {
            return Err(Failure::unsuccessful(format!("every run has no result: {first}"), ""));
        }
        if outcomes.is_empty() {
            return Err(Failure::ended(
                ErrorCode::Interrupted,
                "interrupted before the first run ended",
                "",
            ));
        }
        Ok(Ran { outcomes, stored, is_interrupted })
    }

    /// Takes one step with the values of the scene, to find errors that all runs share.
    fn check_first_run(&self) -> Result<(), Failure> {
        let run = self.settings_of_runs().adjust(Simulation::new(self.scene.simulator()));
        match run.max_steps(1).run() {
            Err(SimulateError::Stopped { .. }) | Ok(_) => Ok(()),
            Err(error) => Err(error.into()),
        }
    }

    /// Runs points. After Ctrl-C, only the outcomes before the first interrupted run are returned.
    pub fn outcomes(
        &self,
        points: &[Vec<f64>],
        mut keep: impl FnMut(&VariantRun),
    ) -> Result<Vec<Outcome>, Failure> {
        let values_of_points: Vec<Vec<f64>> =
            points.iter().map(|point| self.inputs.values(point)).collect();
        let variants: Vec<Vec<f64>> =
            values_of_points.iter().map(|values| self.inputs.variant(values)).collect();
        let (expressions, is_kept) = (&self.expressions, !self.columns.is_empty());
        // Results are reduced to values where they are computed: whole runs fill the memory.
        let reduced = |simulation: &Simulation<'_>, run: Result<VariantRun, SimulateError>| {
            let run = run?;
            let values = values(expressions, simulation, &run);
            Ok((values, run.steps, is_kept.then_some(run)))
        };
        let runs = self.settings_of_runs().runs_each(self.scene, &variants, reduced)?;
        let mut outcomes = Vec::with_capacity(runs.len());
        for (parameters, run) in values_of_points.into_iter().zip(runs) {
            let outcome = match run {
                Err(SimulateError::Stopped { cause: StopCause::Interrupted, .. }) => break,
                Err(error) => Outcome { parameters, values: Err(error.to_string()), steps: 0 },
                Ok((values, steps, run)) => {
                    run.iter().for_each(&mut keep);
                    Outcome { parameters, values, steps }
                }
            };
            outcomes.push(outcome);
        }
        Ok(outcomes)
    }
}

/// Returns the values of expressions over a run, or the reason why there are none.
fn values(
    expressions: &[&Expression],
    simulation: &Simulation<'_>,
    run: &VariantRun,
) -> Result<Vec<f64>, String> {
    let value = |expression: &&Expression| value_over(expression, simulation, run);
    let values: Vec<f64> = expressions.iter().map(value).collect();
    match values.iter().find(|value| !value.is_finite()) {
        Some(value) => Err(format!("a result is {value}")),
        None => Ok(values),
    }
}

/// Returns the names of columns that are plotted.
fn wanted(
    command: &ScatterCommand,
    simulator: &dyn Simulator<f64>,
) -> Result<Vec<String>, Failure> {
    if command.plot.is_none() {
        return Ok(Vec::new());
    }
    let shape = simulator.shape();
    let outputs: Vec<&str> = (0..shape.outputs).map(|index| simulator.output(index).name).collect();
    let states: Vec<&str> = (0..shape.states()).map(|index| simulator.state(index).name).collect();
    if command.columns.is_empty() {
        let all = if outputs.is_empty() { states } else { outputs };
        return Ok(all.into_iter().map(str::to_owned).collect());
    }
    let known = || outputs.iter().chain(&states).copied();
    match command.columns.iter().find(|name| known().all(|known| known != *name)) {
        None => Ok(command.columns.clone()),
        Some(name) => Err(Failure::unknown(
            format!("--columns: there is no output or state `{}`", name.escape_debug()),
            name,
            known(),
        )),
    }
}

impl Stored {
    fn add(&mut self, simulator: &dyn Simulator<f64>, run: &VariantRun) {
        if self.columns.is_empty() || self.full {
            return;
        }
        if self.count == 0 {
            self.times.clone_from(&run.times);
            self.values = vec![vec![Vec::new(); run.times.len()]; self.columns.len()];
        }
        if self.times != run.times {
            self.differ = true;
            return;
        }
        if (self.count + 1) * self.columns.len() * self.times.len() > MAX_STORED {
            self.full = true;
            return;
        }
        let shape = simulator.shape();
        for (name, values) in self.columns.iter().zip(&mut self.values) {
            let output = (0..shape.outputs).find(|index| simulator.output(*index).name == name);
            let state = (0..shape.states()).find(|index| simulator.state(*index).name == name);
            let rows = if output.is_some() { &run.outputs } else { &run.states };
            let Some(place) = output.or(state) else { continue };
            for (values, row) in values.iter_mut().zip(rows) {
                values.push(row[place]);
            }
        }
        self.count += 1;
    }
}

impl Ran {
    /// Returns the number of runs.
    pub fn count(&self) -> usize {
        self.outcomes.len()
    }

    /// Iterates over the numbers of runs without results, and the reasons.
    pub fn stopped(&self) -> impl Iterator<Item = (usize, &str)> {
        let outcomes = self.outcomes.iter().enumerate();
        outcomes
            .filter_map(|(number, outcome)| Some((number, outcome.values.as_ref().err()?.as_str())))
    }

    /// Returns the values of an expression in all runs; NaN for those without results.
    pub fn values(&self, expression: usize) -> Vec<f64> {
        let value = |outcome: &Outcome| {
            outcome.values.as_ref().map_or(f64::NAN, |values| values[expression])
        };
        self.outcomes.iter().map(value).collect()
    }

    /// Returns a note if not all runs are in the plot.
    pub fn note_on_bands(&self) -> Option<String> {
        let done = self.outcomes.len() - self.stopped().count();
        (!self.stored.columns.is_empty() && self.stored.count < done).then(|| {
            format!("the plot shows {} of {done} runs, which memory holds", self.stored.count)
        })
    }

    /// Returns the table of all runs.
    pub fn columns(
        &self,
        simulator: &dyn Simulator<f64>,
        inputs: &Inputs,
        results: &Results,
        plan: &Plan,
    ) -> Vec<Column> {
        let mut columns = vec![Column {
            name: "run".to_owned(),
            unit: None,
            values: Values::Counts((0..self.count() as i64).collect()),
        }];
        if plan.row_length().is_some() {
            let names = (0..self.count()).map(|index| plan.point_name(index));
            let values = Values::Texts(names.collect());
            columns.push(Column { name: "point".to_owned(), unit: None, values });
        }
        for (index, (name, unit)) in inputs.names.iter().zip(&inputs.units).enumerate() {
            let values = self.outcomes.iter().map(|outcome| outcome.parameters[index]).collect();
            columns.push(Column::numbers(name, unit, values));
        }
        let named = results.names().into_iter().zip(results.expressions());
        for (index, (name, expression)) in named.enumerate() {
            let values = self
                .outcomes
                .iter()
                .map(|outcome| outcome.values.as_ref().ok().map(|values| values[index]));
            let unit = Some(units::of(expression, simulator));
            columns.push(Column { name, unit, values: Values::Some(values.collect()) });
        }
        let steps = self.outcomes.iter().map(|outcome| outcome.steps as i64).collect();
        let errors = self.outcomes.iter().map(|outcome| outcome.values.as_ref().err().cloned());
        for (name, values) in
            [("steps", Values::Counts(steps)), ("error", Values::Texts(errors.collect()))]
        {
            columns.push(Column { name: name.to_owned(), unit: None, values });
        }
        columns
    }

    /// Returns quantiles of the stored columns over time.
    pub fn bands(
        &self,
        simulator: &dyn Simulator<f64>,
        quantiles: &[f64],
    ) -> Result<Trajectory, Failure> {
        let Stored { times, columns, values, differ, .. } = &self.stored;
        if *differ {
            let message = "--plot: the runs have different output times";
            return Err(Failure::input(message, "give them one end with --until"));
        }
        let shape = simulator.shape();
        let unit = |name: &str| {
            let outputs = (0..shape.outputs).map(|index| simulator.output(index));
            let states = (0..shape.states()).map(|index| simulator.state(index));
            let mut all = outputs.chain(states);
            all.find(|quantity| quantity.name == name).map_or("1", |quantity| quantity.unit)
        };
        let mut bands = Vec::new();
        for (name, at_times) in columns.iter().zip(values) {
            let all = at_times.iter().map(|values| Summary::of(values, &Groups::Independent, 0.95));
            let all: Vec<Summary> = all
                .collect::<Result<_, _>>()
                .map_err(|error| Failure::unsuccessful(format!("--plot: {error}"), ""))?;
            for p in quantiles {
                bands.push(trajectory::Column {
                    name: format!("{name}, {} %", crate::number::number(100.0 * p, 4)),
                    unit: unit(name).to_owned(),
                    kind: ColumnKind::Output,
                    doc: format!("quantile of `{name}`"),
                    values: all.iter().map(|summary| summary.quantile(*p).value).collect(),
                });
            }
        }
        let run = Simulation::new(simulator);
        Ok(Trajectory {
            scene: simulator.name().to_owned(),
            title: format!("{}: quantiles of {} runs", simulator.title(), self.stored.count),
            method: Method::Auto,
            rtol: run.relative_tolerance(),
            work: machinist::method::Work::default(),
            notes: Vec::new(),
            stopped: None,
            switches: Vec::new(),
            drift: None,
            times: times.clone(),
            columns: bands,
            energy_balance: None,
            error: None,
        })
    }
}

/// Returns the outcomes that a table of [`Ran::columns`] contains: of whole rows of the plan, at
/// most of all. Returns nothing if columns are missing.
pub fn outcomes_of(
    columns: &[Column],
    inputs: &Inputs,
    results: &Results,
    plan: &Plan,
) -> Option<Vec<Outcome>> {
    let find = |name: &str| Some(&columns.iter().find(|column| column.name == name)?.values);
    let numbers = |name: &String| match find(name)? {
        Values::Some(values) => Some(values),
        _ => None,
    };
    let parameters: Vec<_> = inputs.names.iter().map(numbers).collect::<Option<_>>()?;
    let names = results.names();
    let values: Vec<_> = names.iter().map(numbers).collect::<Option<_>>()?;
    let (Values::Counts(steps), Values::Texts(errors)) = (find("steps")?, find("error")?) else {
        return None;
    };
    let length = plan.row_length().unwrap_or(1);
    let count = steps.len().min(plan.len()) / length * length;
    let outcome = |row: usize| {
        let values = values.iter().map(|column| column[row]).collect::<Option<Vec<f64>>>();
        let error = || errors[row].clone().unwrap_or_default();
        Some(Outcome {
            parameters: parameters.iter().map(|column| column[row]).collect::<Option<_>>()?,
            values: values.ok_or_else(error),
            steps: steps[row].try_into().ok()?,
        })
    };
    (0..count).map(outcome).collect()
}
