//! `machinist run`: one scene over time, to numbers and plots.

mod compare;
mod error;
mod fixed;

use std::path::{Path, PathBuf};

use clap::Args;
use machinist::error::StopCause;
use machinist::field::ModalSimulator;
use machinist::trajectory::{Column, ColumnKind, Trajectory, sensitivity_name};
use machinist::{SimulateError, Simulation};
use machinist_contract::Simulator;

use super::amount::{Amount, as_json};
use super::arguments::{RunArgs, SceneArgs};
use super::output::{
    columns, counted_events, draw_file, print, print_with, remark_beside, remarks, require_picture,
    require_table, write_file,
};
use super::scene::Scene;
use super::settings::with_parameters;
use super::times::{Times, times};
use crate::failure::Failure;
use crate::interrupt;
use crate::number::number;
use crate::parquet;
use crate::progress::during;
use crate::rounding::Rounding;
use compare::{Other, Others};
#[cfg(not(feature = "derive"))]
use fixed::Fixed;
use fixed::OverSteps;
pub use fixed::step_method;
#[cfg(feature = "derive")]
pub use fixed::{Fixed, LargestError};
use serde_json::json;

#[derive(Debug, Args)]
pub struct RunCommand {
    /// Number of output times, including both ends; equally spaced, unless --times gives a range
    #[arg(long, value_name = "NUMBER")]
    points: Option<usize>,
    /// Output times, s: a list, `0,0.1,0.5`, or a logarithmic range of times after the start with
    /// `--points` values, `1e-3..10:log`
    #[arg(long, value_name = "TIMES", value_parser = times, allow_hyphen_values = true)]
    times: Option<Times>,
    /// Simulate only this number of the slowest eigenmodes, computed at the start of the run
    #[arg(long, value_name = "NUMBER")]
    modes: Option<usize>,
    /// Add derivatives of all states and outputs by these parameters, or by initial values of these
    /// states, as columns d(output)/d(parameter)
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    sensitivities: Vec<String>,
    #[command(flatten)]
    fixed: fixed::Options,
    #[command(flatten)]
    error: error::Options,
    #[command(flatten)]
    others: Others,
    /// Write all values to a .csv or .json file; - writes only CSV to standard output
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: Option<PathBuf>,
    /// Plot to a .svg or .png file
    #[arg(long, help_heading = "Output", value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Columns to write and plot: states, outputs, energy.total, requested derivatives
    #[arg(long, help_heading = "Output", value_name = "NAMES", value_delimiter = ',')]
    columns: Vec<String>,
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    run: RunArgs,
}

/// Output times of a run.
enum At<'t> {
    /// These in addition to the run's own.
    Also(&'t [f64]),
    /// Only these.
    Only(&'t [f64]),
}

impl At<'_> {
    fn asked_of<'a>(&self, run: Simulation<'a>) -> Simulation<'a> {
        match self {
            Self::Also(times) => run.also_at(times),
            Self::Only(times) => match times {
                [first, .., last] => run.from(*first).until(*last).times(times),
                _ => run,
            },
        }
    }
}

/// Format of `--out`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Csv,
    Json,
    Parquet,
    StandardOutput,
}

impl RunCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        let format = self.out.as_deref().map(format_of).transpose()?;
        require_picture(self.plot.as_deref(), "--plot")?;
        let scene = self.scene.load()?;
        match &self.fixed.asked()?[..] {
            [] => {}
            [fixed] => return self.by_fixed_steps(fixed, &scene, format),
            several => return self.over_steps(several, &scene),
        }
        self.check_columns(scene.simulator())?;
        self.check_sensitivities()?;
        let from = self.run.span.start_time(scene.simulator());
        let others = self.others.load(scene.simulator(), from)?;
        let times: Vec<f64> = others.iter().flat_map(Other::times).copied().collect();
        // A table on standard output leaves no place for the estimate.
        let is_shown = format != Some(Format::StandardOutput);
        match self.estimated(&scene, &At::Also(&times), is_shown)? {
            Ok((mut trajectory, shortfall)) => {
                let mut summary = self.summary(&scene, &trajectory);
                let (names, tables) = self.compare(others, &scene, &mut trajectory)?;
                summary.push_str(&tables);
                if self.write(&scene, format, &trajectory, &names)? {
                    print(&summary)?;
                } else {
                    remark_beside(&trajectory);
                }
                let missed = |reason| format!("the accuracy was not reached: {reason}");
                shortfall.map_or(Ok(()), |reason| Err(Failure::unsuccessful(missed(reason), "")))
            }
            Err(error) => Err(self.stopped(&scene, format, error)?),
        }
    }

    /// Takes steps of a fixed length and compares them with the adaptive run at the same times.
    fn by_fixed_steps(
        &self,
        fixed: &Fixed,
        scene: &Scene,
        format: Option<Format>,
    ) -> Result<(), Failure> {
        let simulator = scene.simulator();
        let run = self.adjusted(self.scene.simulation(simulator)?)?;
        let until = self.run.span.until.unwrap_or(simulator.run_defaults().until);
        let rows = self.points.unwrap_or(simulator.run_defaults().points).max(2) - 1;
        let stepping = during("stepping", || fixed.run(&run, until, rows))?;
        let exact = run.clone().times(stepping.times());
        let mut trajectory = during("simulating", || exact.run())?;
        let mut summary =
            fixed.compare(&stepping, simulator, run.parameter_values(), &mut trajectory);
        if let Some(unknown) = self.columns.iter().find(|name| trajectory.find(name).is_none()) {
            let known = trajectory.columns.iter().map(|column| column.name.as_str());
            let message = format!("there is no column `{unknown}`");
            return Err(Failure::unknown(message, unknown, known));
        }
        let trajectory = self.chosen_columns(trajectory);
        if !self.write(scene, format, &trajectory, &self.columns)? {
            return Ok(());
        }
        for file in [&self.out, &self.plot].into_iter().flatten() {
            summary.extend(["\nwrote ", &file.display().to_string(), "\n"]);
        }
        print(&summary)
    }

    /// Takes steps of several sizes, and compares each run with the adaptive one.
    fn over_steps(&self, several: &[Fixed], scene: &Scene) -> Result<(), Failure> {
        if self.out.is_some() || !self.columns.is_empty() {
            let message = "--out and --columns take one size of `--fixed`";
            return Err(Failure::input(message, "`--plot` draws the errors over the size"));
        }
        let simulator = scene.simulator();
        let run = self.adjusted(self.scene.simulation(simulator)?)?;
        let until = self.run.span.until.unwrap_or(simulator.run_defaults().until);
        let rows = self.points.unwrap_or(simulator.run_defaults().points).max(2) - 1;
        let mut errors = OverSteps::default();
        let mut title = String::new();
        for fixed in several {
            let stepping = during("stepping", || fixed.run(&run, until, rows))?;
            let exact = run.clone().times(stepping.times());
            let exact = during("simulating", || exact.run())?;
            errors.push(&stepping, stepping.errors(&run, &exact));
            title = format!("{}: {}", exact.scene, exact.title);
        }
        let said = "errors of fixed steps over the range of each output, away from events";
        if let Some(file) = &self.plot {
            draw_file(file, |path| errors.plot([&title, said], path))?;
        }
        let mut summary = format!("{title}\n{said}\n\n{}", errors.table());
        if let Some(file) = &self.plot {
            summary.extend(["\nwrote ", &file.display().to_string(), "\n"]);
        }
        print(&summary)
    }

    /// Writes the results of a run that stopped. A summary is printed only if the run was
    /// interrupted, because then nothing is wrong with it.
    fn stopped(
        &self,
        scene: &Scene,
        format: Option<Format>,
        mut error: SimulateError,
    ) -> Result<Failure, Failure> {
        let SimulateError::Stopped { kept, cause, .. } = &mut error else {
            return Ok(error.into());
        };
        let is_interrupted = *cause == StopCause::Interrupted;
        let Some(kept) = kept.take() else { return Ok(error.into()) };
        let Some(last) = kept.times.last().copied() else { return Ok(error.into()) };
        let files: Vec<String> = [&self.out, &self.plot]
            .into_iter()
            .flatten()
            .map(|file| match file.to_str() {
                Some("-") => "standard output".to_owned(),
                _ => file.display().to_string(),
            })
            .collect();
        let kept = self.chosen_columns(*kept);
        let written = files.is_empty() || self.write(scene, format, &kept, &self.columns)?;
        if is_interrupted && written {
            print(&self.summary(scene, &kept))?;
        }
        if files.is_empty() {
            return Ok(error.into());
        }
        let what = format!("the results until {last} s are in {}", files.join(" and "));
        Ok(Failure::unsuccessful(error, what))
    }

    /// Writes the files asked for. Returns whether standard output is still free.
    fn write(
        &self,
        scene: &Scene,
        format: Option<Format>,
        trajectory: &Trajectory,
        drawn: &[String],
    ) -> Result<bool, Failure> {
        if let Some(file) = &self.plot {
            let names: Vec<&str> = drawn.iter().map(String::as_str).collect();
            draw_file(file, |path| crate::plot::plot(trajectory, &names, path))?;
        }
        match (format, &self.out) {
            (Some(Format::StandardOutput), _) => {
                print_with(|out| trajectory.write_csv(out))?;
                return Ok(false);
            }
            (Some(Format::Csv), Some(file)) => write_file(file, |out| trajectory.write_csv(out))?,
            (Some(Format::Json), Some(file)) => write_file(file, |out| trajectory.write_json(out))?,
            (Some(Format::Parquet), Some(file)) => {
                let Trajectory { method, rtol, notes, stopped, .. } = trajectory;
                let parameters = as_json(&self.scene.machine.set);
                let more = json!({
                    "settings": { "method": method, "rtol": rtol, "parameters": parameters },
                    "notes": notes,
                    "stopped": stopped,
                });
                let of = ("run", self.scene.scene.as_str(), scene);
                parquet::write_table(file, &parquet::of_run(trajectory), of, more)?;
            }
            _ => {}
        }
        Ok(true)
    }

    fn trajectory(
        &self,
        simulator: &dyn Simulator<f64>,
        set: &[(String, Amount)],
        times: &At<'_>,
    ) -> Result<Result<Trajectory, SimulateError>, Failure> {
        self.simulated(simulator, set, times, |simulation| {
            during("simulating", || simulation.run())
        })
    }

    /// Prepares the run asked for and passes it to a function.
    fn simulated<T>(
        &self,
        simulator: &dyn Simulator<f64>,
        set: &[(String, Amount)],
        times: &At<'_>,
        work: impl FnOnce(&Simulation<'_>) -> T,
    ) -> Result<T, Failure> {
        let whole = with_parameters(Simulation::new(simulator), set)?;
        let machine = &self.scene.machine;
        let flag = interrupt::flag();
        let Some(modes) = self.modes else {
            let simulation = times.asked_of(self.adjusted(machine.with_initial(whole)?)?);
            return Ok(work(&simulation.until_flagged(&flag)));
        };
        let modal = ModalSimulator::new(simulator, whole.parameter_values(), modes);
        let modal = modal.map_err(|error| Failure::input(error, ""))?;
        let simulation = machine.with_initial(Simulation::new(&modal))?;
        let simulation = times.asked_of(self.adjusted(simulation)?);
        Ok(work(&simulation.until_flagged(&flag)))
    }

    /// Runs the others, and adds their columns beside those of the first. Returns the names to
    /// draw, and a table for each of the others.
    fn compare(
        &self,
        others: Vec<Other>,
        scene: &Scene,
        first: &mut Trajectory,
    ) -> Result<(Vec<String>, String), Failure> {
        if others.is_empty() {
            return Ok((self.columns.clone(), String::new()));
        }
        let (times, mut beside) = (first.times.clone(), Vec::new());
        for other in others {
            let run = |other: Option<&Scene>, set: &[(String, Amount)]| {
                // Another scene keeps its own parameters.
                let all = [&self.scene.machine.set, set].concat();
                let set = if other.is_some() { set } else { &all };
                let simulator = other.unwrap_or(scene).simulator();
                Ok(self.trajectory(simulator, set, &At::Only(&times))??)
            };
            beside.push(other.beside(first, &run)?);
        }
        let tables = beside.iter().map(|other| other.table(first)).collect();
        let added: Vec<(usize, Column)> =
            beside.iter().flat_map(|other| other.columns(first)).collect();
        let has_outputs = first.of_kind(ColumnKind::Output).next().is_some();
        let kind = if has_outputs { ColumnKind::Output } else { ColumnKind::State };
        let is_drawn = |column: &Column| match self.columns.as_slice() {
            [] => column.kind == kind,
            asked => asked.contains(&column.name),
        };
        let mut names = Vec::new();
        for (place, column) in first.columns.iter().enumerate().filter(|(_, c)| is_drawn(c)) {
            names.push(column.name.clone());
            let of_it = added.iter().filter(|(of, _)| *of == place);
            names.extend(of_it.map(|(_, column)| column.name.clone()));
        }
        first.columns.extend(added.into_iter().map(|(_, column)| column));
        Ok((names, tables))
    }

    /// Applies all options except parameters and initial values to a run.
    fn adjusted<'a>(&self, mut simulation: Simulation<'a>) -> Result<Simulation<'a>, Failure> {
        simulation = self.run.apply(simulation)?;
        if let Some(points) = self.points {
            simulation = simulation.points(points);
        }
        if let Some(times) = &self.times {
            let span = [self.run.span.from, self.run.span.until];
            simulation = times.asked_of(simulation, span, self.points)?;
        }
        if !self.sensitivities.is_empty() {
            simulation = simulation.sensitivities(&self.sensitivities)?;
        }
        Ok(simulation)
    }

    /// Returns an error for unknown columns before the run.
    fn check_columns(&self, simulator: &dyn Simulator<f64>) -> Result<(), Failure> {
        let shape = simulator.shape();
        let states = (0..shape.states()).map(|index| simulator.state(index).name);
        let outputs = (0..shape.outputs).map(|index| simulator.output(index).name);
        let known: Vec<&str> = outputs.chain(states).chain(["energy.total"]).collect();
        let by = &self.sensitivities;
        let derivatives = known.iter().flat_map(|of| by.iter().map(|by| sensitivity_name(of, by)));
        let derivatives: Vec<String> = derivatives.collect();
        let known = known.iter().copied().chain(derivatives.iter().map(String::as_str));
        match self.columns.iter().find(|name| !known.clone().any(|known| known == *name)) {
            None => Ok(()),
            Some(name) => Err(Failure::unknown(
                format!("scene `{}` has no column `{}`", simulator.name(), name.escape_debug()),
                name,
                known,
            )),
        }
    }

    /// Returns an error for derivatives that are asked for twice.
    fn check_sensitivities(&self) -> Result<(), Failure> {
        let all = &self.sensitivities;
        match (1..all.len()).find(|index| all[..*index].contains(&all[*index])) {
            None => Ok(()),
            Some(twice) => {
                let message = format!("--sensitivities {} is given twice", all[twice]);
                Err(Failure::input(message, ""))
            }
        }
    }

    /// Keeps the columns asked for, in that order.
    fn chosen_columns(&self, mut trajectory: Trajectory) -> Trajectory {
        if !self.columns.is_empty() {
            let find = |name: &String| trajectory.find(name).cloned();
            trajectory.columns = self.columns.iter().filter_map(find).collect();
        }
        trajectory
    }

    fn summary(&self, scene: &Scene, trajectory: &Trajectory) -> String {
        let work = trajectory.work;
        // A run that stopped at once has a single time.
        let span = match (trajectory.times.first(), trajectory.times.last()) {
            (Some(from), Some(until)) => format!("{from} s to {until} s, "),
            _ => String::new(),
        };
        let mut text = format!(
            "{}: {} ({})\n{}, rtol {:e}, {span}{} points{}\n\
             {} steps, {} rejected, {} rate evaluations, {} Jacobians, {} factorizations, \
             {} Newton iterations{}{}{}\n\n",
            trajectory.scene,
            trajectory.title,
            scene.how(),
            trajectory.method,
            trajectory.rtol,
            trajectory.times.len(),
            remarks(trajectory, "--out FILE.json"),
            work.steps,
            work.rejected,
            work.rate_evaluations,
            work.jacobian_evaluations,
            work.factorizations,
            work.newton_iterations,
            switches(trajectory),
            drift(trajectory),
            error::remark(trajectory),
        );
        let header = ["", "unit", "final", "least", "greatest"].map(str::to_owned).to_vec();
        let error = trajectory.error.as_ref().map(|_| "error".to_owned());
        let header: Vec<String> = header.into_iter().chain(error).collect();
        let shown = |column: &&Column| !self.columns.is_empty() || is_short(trajectory, column);
        let rounding = Rounding::of(trajectory);
        let rows = trajectory.columns.iter().filter(shown).map(|column| {
            let error = error::cell(trajectory, column);
            summary_row(&rounding, column).into_iter().chain(error).collect::<Vec<_>>()
        });
        text.push_str(&columns(&std::iter::once(header).chain(rows).collect::<Vec<_>>(), 2));
        for file in [&self.out, &self.plot].into_iter().flatten() {
            text.extend(["\nwrote ", &file.display().to_string()]);
        }
        text.trim_end().to_owned() + "\n"
    }
}

/// Formats how often each event happened, on a line of its own; empty without events.
fn switches(trajectory: &Trajectory) -> String {
    if trajectory.switches.is_empty() {
        return String::new();
    }
    format!("\n{} switches: {}", trajectory.work.switches, counted_events(trajectory))
}

/// Formats the largest violation of the constraints, on a line of its own.
fn drift(trajectory: &Trajectory) -> String {
    trajectory.drift.map_or_else(String::new, |drift| {
        format!(
            "\nconstraints off by at most {:.1e} before and {:.1e} after being put back",
            drift.before, drift.after
        )
    })
}

/// Returns whether a column is shown in the summary: states and outputs, but not an output with the
/// name of a state.
fn is_short(trajectory: &Trajectory, column: &Column) -> bool {
    column.kind != ColumnKind::Output
        || trajectory.of_kind(ColumnKind::State).all(|state| state.name != column.name)
}

fn summary_row(rounding: &Rounding<'_>, column: &Column) -> [String; 5] {
    let values = rounding.rid(column);
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let last = values.last().copied().unwrap_or(f64::NAN);
    let [last, least, greatest] = [last, least, greatest].map(|value| number(value, 6));
    [column.name.clone(), column.unit.clone(), last, least, greatest]
}

fn format_of(file: &Path) -> Result<Format, Failure> {
    if file == Path::new("-") {
        return Ok(Format::StandardOutput);
    }
    require_table(file, &["csv", "json"])?;
    let is_json = file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"));
    Ok(if parquet::is_named(file) {
        Format::Parquet
    } else if is_json {
        Format::Json
    } else {
        Format::Csv
    })
}
