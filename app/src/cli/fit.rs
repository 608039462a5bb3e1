//! `machinist fit`: parameters of a scene from measured runs.

mod answer;
pub mod data;
pub(super) mod unknown;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::{Args, ValueEnum};
use machinist::Simulation;
use machinist::constraints;
use machinist::fit::{self, End, Evaluation, Fitted, Measured, Plan, Unknown, Unsolved};
use machinist::trajectory::{Column, ColumnKind, Trajectory};
use machinist_contract::Simulator;

use super::amount::{Amount, assignment, bare_assignment, in_si};
use super::output::{draw_file, print, require_ending, require_picture};
use super::rewrite::{FoundValue, write_scene};
use super::scene::Scene;
use super::settings::{with_method, with_parameters};
use crate::failure::Failure;
use crate::interrupt;
use crate::number::number;
use crate::progress::spinner;
use answer::Answer;
use data::Reading;
use unknown::{Asked, asked, unknowns};

/// Steps of a search at most, unless told otherwise.
const STEPS: usize = 100;
/// Curves of a plot have so many points beside those of the data.
const POINTS: usize = 600;
#[derive(Debug, Args)]
pub struct FitCommand {
    /// Name of a scene built in, or a scene file
    scene: String,
    /// A measured run: a CSV file with time in its first column; may be given several times
    #[arg(long, value_name = "FILE", required = true)]
    data: Vec<PathBuf>,
    /// What is fitted: parameters, or initial values of states, with bounds or without
    #[arg(long, value_name = "NAME[=FROM..TO]", value_delimiter = ',', required = true,
        value_parser = asked)]
    parameters: Vec<Asked>,
    /// What a column of the data is, if it bears another name
    #[arg(long, value_name = "COLUMN=OUTPUT", value_parser = pair)]
    map: Vec<(String, String)>,
    /// Only these outputs or states; all columns unless given
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    outputs: Vec<String>,
    /// Standard deviation of an output's measurement, in its unit; found from the residuals
    /// unless given
    #[arg(long, value_name = "OUTPUT=VALUE", value_parser = bare_assignment)]
    sigma: Vec<(String, f64)>,
    /// Give a parameter another value: in its SI unit, or with a unit, `18 [kN m/rad]`
    #[arg(long, value_name = "UNIT.PARAMETER=VALUE", value_parser = assignment)]
    set: Vec<(String, Amount)>,
    /// Start time of the runs, s
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    from: Option<f64>,
    /// Relative tolerance of a step
    #[arg(long, value_name = "TOLERANCE", allow_hyphen_values = true)]
    rtol: Option<f64>,
    /// The method, one that carries sensitivities
    #[arg(long, value_name = "NAME")]
    method: Option<String>,
    /// Searches from so many starts, spread within bounds
    #[arg(long, value_name = "NUMBER", default_value_t = 1)]
    starts: usize,
    /// How residuals count
    #[arg(long, value_name = "LOSS", default_value = "squares")]
    loss: LossName,
    /// Steps of a search at most
    #[arg(long, value_name = "NUMBER", default_value_t = STEPS)]
    steps: usize,
    /// As JSON
    #[arg(long)]
    json: bool,
    /// Plot data beside the runs before and after to a file that ends in .svg or .png; of
    /// several data files, one beside the other
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Write the scene with the fitted values to a file that ends in .toml
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum LossName {
    /// Their squares
    Squares,
    /// Their squares, beyond what is usual their sizes: outliers count less
    Huber,
}

/// `column=output`.
fn pair(text: &str) -> Result<(String, String), String> {
    let (column, output) =
        text.split_once('=').ok_or("write it as COLUMN=OUTPUT, such as n1=motor_speed")?;
    Ok((column.trim().to_owned(), output.trim().to_owned()))
}

impl FitCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        self.check()?;
        let scene = Scene::load(&self.scene, false)?;
        let simulator = scene.simulator();
        let simulation = self.simulation(simulator)?;
        let from = self.from.unwrap_or(simulator.run_defaults().from);
        let outputs = &self.outputs[..];
        let reading = Reading { simulator, map: &self.map, outputs, from, skips_unknown: false };
        let files =
            self.data.iter().map(|path| reading.read(path)).collect::<Result<Vec<_>, _>>()?;
        let gaps: usize = files.iter().map(|file| file.gaps).sum();
        let measured: Vec<Measured> = files.into_iter().map(|file| file.measured).collect();
        let is_measured = |name: &String| {
            measured.iter().any(|run| run.columns.iter().any(|(column, _)| column == name))
        };
        if let Some((column, output)) = self.map.iter().find(|(_, output)| !is_measured(output)) {
            let message = format!("--map {column}={output}: no file has a column `{column}`");
            return Err(Failure::input(message.escape_debug(), ""));
        }
        let start = constraints::start(simulator, simulation.parameter_values(), from)?;
        let unknowns = unknowns(&self.parameters, simulator, &simulation, &start)?;
        let (unknowns, are_parameters): (Vec<Unknown>, Vec<bool>) = unknowns.into_iter().unzip();
        let flag = interrupt::flag();
        let plain = simulation.clone();
        let simulation = simulation.until_flagged(&flag);
        let limit = fit::steps_of(&simulation, &unknowns, &measured);
        let simulation = simulation.max_steps(limit);
        let fit = fit::Fit { simulation: &simulation, unknowns: &unknowns, measured: &measured };
        let count = values(&measured).count();
        if count < unknowns.len() {
            let message = format!("{count} values are too few for {} unknowns", unknowns.len());
            return Err(Failure::input(message, ""));
        }
        self.check_sigmas(&fit)?;
        check_first_run(&fit)?;
        let fitted = self.solve(&fit, &flag)?;
        let answer = Answer::new(&fit, &fitted, gaps, simulator);
        if let Some(file) = &self.plot {
            draw(&fit::Fit { simulation: &plain, ..fit }, &answer, file)?;
        }
        if let Some(file) = &self.out {
            let found = answer.parameters.iter().zip(&are_parameters).map(|(found, is_it)| {
                FoundValue { name: &found.name, value: found.value, is_parameter: *is_it }
            });
            write_scene(&self.scene, found, &in_si(&self.set), file)?;
        }
        if self.json {
            let text = serde_json::to_string_pretty(&answer)
                .map_err(|error| Failure::unsuccessful(error, ""))?;
            print(&format!("{text}\n"))?;
        } else {
            let mut text = answer.told(&scene, &self.data);
            for file in [&self.out, &self.plot].into_iter().flatten() {
                text.extend(["\nwrote ", &file.display().to_string(), "\n"]);
            }
            print(&text)?;
        }
        let more = "the values above are the best so far";
        match fitted.found.end {
            End::Converged => Ok(()),
            // Nothing is better than as exact as the runs themselves.
            End::Stuck if answer.is_exact() => Ok(()),
            End::Interrupted => Err(Failure::unsuccessful("the fit was interrupted", more)),
            End::Steps => {
                let message = format!("the fit has not converged after {} steps", self.steps);
                Err(Failure::unsuccessful(message, format!("{more}; `--steps` allows more")))
            }
            End::Stuck => {
                let help = format!("{more}; a lower `--rtol`, or other bounds, may help");
                Err(Failure::unsuccessful("no step from there leads to anything better", help))
            }
        }
    }

    fn check(&self) -> Result<(), Failure> {
        require_picture(self.plot.as_deref(), "--plot")?;
        if let Some(file) = &self.out {
            require_ending(file, &["toml"], "--out")?;
        }
        if self.starts == 0 || self.steps == 0 {
            return Err(Failure::input("--starts and --steps are at least 1", ""));
        }
        match self.sigma.iter().find(|(_, sigma)| *sigma <= 0.0) {
            None => Ok(()),
            Some((name, sigma)) => {
                Err(Failure::input(format!("--sigma {name}={sigma} is not above 0"), ""))
            }
        }
    }

    fn simulation<'a>(&self, simulator: &'a dyn Simulator<f64>) -> Result<Simulation<'a>, Failure> {
        let mut simulation = with_parameters(Simulation::new(simulator), &self.set)?;
        simulation = self.from.into_iter().fold(simulation, Simulation::from);
        simulation = self.rtol.into_iter().fold(simulation, Simulation::rtol);
        with_method(simulation, self.method.as_deref())
    }

    fn check_sigmas(&self, fit: &fit::Fit<'_>) -> Result<(), Failure> {
        let known = fit.outputs();
        match self.sigma.iter().find(|(name, _)| !known.contains(&name.as_str())) {
            None => Ok(()),
            Some((name, _)) => Err(Failure::input(
                format!("--sigma {}: that is not measured", name.escape_debug()),
                crate::failure::did_you_mean(name, known.into_iter()),
            )),
        }
    }

    /// The fit as asked for, told of on the way.
    fn solve(&self, fit: &fit::Fit<'_>, flag: &AtomicBool) -> Result<Fitted, Failure> {
        let spinner = spinner("fitting");
        let plan = Plan {
            sigma: &self.sigma,
            is_robust: self.loss == LossName::Huber,
            starts: self.starts,
            steps: self.steps,
            interrupt: Some(flag),
        };
        let fitted = fit.solve(&plan, &mut |runs, evaluation| {
            spinner.set_message(progress(runs, evaluation));
        });
        spinner.finish_and_clear();
        fitted.map_err(|unsolved| match unsolved {
            Unsolved::Interrupted => Failure::unsuccessful(unsolved, ""),
            Unsolved::NoStart { .. } => {
                Failure::unsuccessful(unsolved, "other bounds, or `--set`, may help")
            }
        })
    }
}

/// Refuses at once what no variant would do either.
fn check_first_run(fit: &fit::Fit<'_>) -> Result<(), Failure> {
    let names: Vec<&str> = fit.unknowns.iter().map(|unknown| unknown.name.as_str()).collect();
    let short = fit.simulation.clone().points(2).max_steps(1).sensitivities(&names)?;
    match short.run() {
        Err(machinist::SimulateError::Stopped { .. }) | Ok(_) => Ok(()),
        Err(error) => Err(error.into()),
    }
}

/// Draws each data file beside the runs before and after.
fn draw(fit: &fit::Fit<'_>, answer: &Answer, file: &std::path::Path) -> Result<(), Failure> {
    for (index, measured) in fit.measured.iter().enumerate() {
        let drawn = compared(fit, measured, answer)?;
        let names: Vec<&str> = drawn.columns.iter().map(|column| &*column.name).collect();
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        let ending = file.extension().unwrap_or_default().to_string_lossy();
        let path = match index {
            0 => file.to_owned(),
            _ => file.with_file_name(format!("{stem}-{}.{ending}", index + 1)),
        };
        draw_file(&path, |path| crate::plot::plot(&drawn, &names, path))?;
    }
    Ok(())
}

/// Values of all measured columns.
fn values(measured: &[Measured]) -> impl Iterator<Item = f64> {
    let columns = measured.iter().flat_map(|measured| &measured.columns);
    columns.flat_map(|(_, values)| values).copied().filter(|value| !value.is_nan())
}

fn progress(runs: usize, evaluation: &Evaluation) -> String {
    let mean = evaluation.residuals.norm() / (evaluation.residuals.len() as f64).sqrt();
    format!("fitting: {runs} evaluations, residuals of {} on average", number(mean, 4))
}

/// What was measured in a run as dots, and the runs before and after as lines.
fn compared(
    fit: &fit::Fit<'_>,
    measured: &Measured,
    answer: &Answer,
) -> Result<Trajectory, Failure> {
    let from = measured.times.first().copied().unwrap_or(0.0);
    let until = measured.times.last().copied().unwrap_or(from);
    let dense = (0..=POINTS).map(|k| from + (until - from) * k as f64 / POINTS as f64);
    let dense = dense.map(|time| (time.clamp(from, until), None));
    let sampled = measured.times.iter().enumerate().map(|(row, time)| (*time, Some(row)));
    let mut all: Vec<(f64, Option<usize>)> = dense.chain(sampled).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let times: Vec<f64> = all.iter().map(|(time, _)| *time).collect();
    let wanted = Measured { times: times.clone(), columns: Vec::new() };
    let starts: Vec<f64> = fit.unknowns.iter().map(|unknown| unknown.start).collect();
    let fitted: Vec<f64> = answer.parameters.iter().map(|found| found.value).collect();
    let after = fit.run(&wanted, &fitted, false)?;
    // A start that cannot be simulated is not drawn.
    let before = fit.run(&wanted, &starts, false).ok();
    let mut columns = Vec::new();
    for (name, values) in &measured.columns {
        let Some(of) = after.find(name) else { continue };
        let column = |what: &str, kind: ColumnKind, values: Vec<f64>| Column {
            name: format!("{name}, {what}"),
            kind,
            values,
            ..of.clone()
        };
        let data = all.iter().map(|(_, row)| row.map_or(f64::NAN, |row| values[row])).collect();
        columns.push(column("measured", ColumnKind::Measured, data));
        if let Some(before) = before.as_ref().and_then(|run| run.column(name)) {
            columns.push(column("before", of.kind, before[1..].to_vec()));
        }
        columns.push(column("fitted", of.kind, of.values[1..].to_vec()));
    }
    Ok(Trajectory { times, columns, ..after })
}
