//! `machinist fit`: parameters of a scene from measured runs.

mod answer;
pub mod data;
pub(super) mod unknown;

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::{Args, ValueEnum};
use machinist::Simulation;
use machinist::constraints;
use machinist::fit::{self, End, Evaluation, Found, Loss, Measured, Unknown};
use machinist::trajectory::{Column, ColumnKind, Trajectory};
use machinist_contract::Simulator;

use super::assignment;
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
/// How often the scales of outputs follow the residuals.
const REWEIGHTINGS: usize = 4;
/// Scales that change by no more than this share have settled.
const SETTLED: f64 = 1e-2;
/// Curves of a plot have so many points beside those of the data.
const POINTS: usize = 600;
/// Huber's size in standard deviations: 95 % as efficient as squares where nothing is wild.
const HUBER: f64 = 1.345;
/// A standard deviation for a median of sizes, of the normal distribution.
const OF_MEDIAN: f64 = 1.4826;

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
    #[arg(long, value_name = "OUTPUT=VALUE", value_parser = assignment)]
    sigma: Vec<(String, f64)>,
    /// Give a parameter another value, in its SI unit
    #[arg(long, value_name = "UNIT.PARAMETER=VALUE", value_parser = assignment)]
    set: Vec<(String, f64)>,
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

/// A search that has ended, with what it went by.
struct Fitted {
    found: Found,
    loss: Loss,
    /// Scale of each output.
    scales: Vec<(String, f64)>,
    /// Starts that led nowhere, and why the first did not.
    lost: (usize, Option<String>),
    steps: usize,
    runs: usize,
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
        let limit = steps_of(&simulation, &unknowns, &measured);
        let simulation = simulation.max_steps(limit);
        let fit = fit::Fit { simulation: &simulation, unknowns: &unknowns, measured: &measured };
        let count = values(&measured).count();
        if count < unknowns.len() {
            let message = format!("{count} values are too few for {} unknowns", unknowns.len());
            return Err(Failure::input(message, ""));
        }
        self.check_sigmas(&fit)?;
        check_first_run(&fit)?;
        let fitted = self.search(&fit, &flag)?;
        let answer = Answer::new(&fit, &fitted, gaps, simulator);
        if let Some(file) = &self.plot {
            draw(&fit::Fit { simulation: &plain, ..fit }, &answer, file)?;
        }
        if let Some(file) = &self.out {
            let found = answer.parameters.iter().zip(&are_parameters).map(|(found, is_it)| {
                FoundValue { name: &found.name, value: found.value, is_parameter: *is_it }
            });
            write_scene(&self.scene, found, &self.set, file)?;
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

    fn search(&self, fit: &fit::Fit<'_>, flag: &AtomicBool) -> Result<Fitted, Failure> {
        let spinner = spinner("fitting");
        let mut scales = self.first_scales(fit);
        let mut runs = 0;
        let mut search = |start: &[f64], scales: &[(String, f64)], loss: Loss| {
            let scale_of = |name: &str| scale_of(scales, name);
            let (first, told) = (runs, std::cell::Cell::new(runs));
            let found =
                fit.search(start, &scale_of, (loss, self.steps), Some(flag), |evaluation| {
                    told.set(told.get() + 1);
                    spinner.set_message(progress(told.get(), evaluation));
                });
            runs = told.get().max(first);
            found
        };
        let mut best: Option<Found> = None;
        let mut lost = (0, None);
        for start in fit::spread_starts(&fit.start(), &fit.bounds(), self.starts) {
            match search(&start, &scales, Loss::Squares) {
                Ok(found) => {
                    let is_interrupted = found.end == End::Interrupted;
                    if best.as_ref().is_none_or(|best| found.cost < best.cost) {
                        best = Some(found);
                    }
                    if is_interrupted {
                        break;
                    }
                }
                Err(_) if flag.load(Ordering::Relaxed) => {}
                Err(why) => {
                    lost.0 += 1;
                    lost.1.get_or_insert(why);
                }
            }
            if flag.load(Ordering::Relaxed) {
                break;
            }
        }
        let Some(mut found) = best else {
            if flag.load(Ordering::Relaxed) {
                return Err(Failure::unsuccessful("the fit was interrupted at its start", ""));
            }
            let why = lost.1.unwrap_or_default();
            let message = format!("no start can be simulated: {why}");
            return Err(Failure::unsuccessful(message, "other bounds, or `--set`, may help"));
        };
        let mut loss = Loss::Squares;
        let weighs = self.sigma.is_empty() && fit.outputs().len() > 1;
        let is_robust = self.loss == LossName::Huber;
        let rounds = if weighs || is_robust { REWEIGHTINGS } else { 0 };
        let mut steps = found.steps;
        for _ in 0..rounds {
            if flag.load(Ordering::Relaxed) {
                break;
            }
            let before = scales.clone();
            if weighs {
                scales = renewed(fit, &found.evaluation, &scales, is_robust);
            }
            let is_same =
                |(a, b): (&(String, f64), &(String, f64))| (a.1 - b.1).abs() <= SETTLED * a.1;
            if !is_robust && before.iter().zip(&scales).all(is_same) {
                break;
            }
            if is_robust {
                let scale_of = |name: &str| scale_of(&scales, name);
                if let Ok(now) = fit.evaluate(&found.at, &scale_of) {
                    let sizes: Vec<f64> = now.residuals.iter().map(|r| r.abs()).collect();
                    loss = Loss::Huber(HUBER * OF_MEDIAN * median(sizes).max(f64::MIN_POSITIVE));
                }
            }
            match search(&found.at.clone(), &scales, loss) {
                Ok(better) => {
                    steps += better.steps;
                    found = better;
                }
                Err(why) => {
                    scales = before;
                    if !flag.load(Ordering::Relaxed) {
                        lost.1.get_or_insert(why);
                    }
                    break;
                }
            }
        }
        if flag.load(Ordering::Relaxed) {
            found.end = End::Interrupted;
        }
        spinner.finish_and_clear();
        Ok(Fitted { found, loss, scales, lost, steps, runs })
    }

    /// What residuals are measured by at first: the standard deviation given, else that of what
    /// was measured about its mean.
    fn first_scales(&self, fit: &fit::Fit<'_>) -> Vec<(String, f64)> {
        let of = |name: &&str| {
            let given = self.sigma.iter().find(|(other, _)| other == name);
            let all = fit.measured.iter().flat_map(|measured| &measured.columns);
            let own = all.filter(|(other, _)| other == name).flat_map(|(_, values)| values);
            let own: Vec<f64> = own.copied().filter(|value| !value.is_nan()).collect();
            let scale = given.map_or_else(|| spread(&own), |(_, sigma)| *sigma);
            ((*name).to_owned(), scale)
        };
        fit.outputs().iter().map(of).collect()
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

/// Steps that a variant may take before it is given up: many times those of the start.
fn steps_of(simulation: &Simulation<'_>, unknowns: &[Unknown], measured: &[Measured]) -> usize {
    const TIMES: u64 = 50;
    const LEAST: u64 = 20_000;
    const UNKNOWN: u64 = 200_000;
    let first = simulation.clone().max_steps(UNKNOWN as usize);
    let fit = fit::Fit { simulation: &first, unknowns, measured };
    let starts: Vec<f64> = unknowns.iter().map(|unknown| unknown.start).collect();
    let runs = measured.iter().map(|measured| fit.run(measured, &starts, false));
    let most = runs.map(|run| run.map_or(UNKNOWN / TIMES, |run| run.work.steps)).max();
    (TIMES * most.unwrap_or_default()).max(LEAST) as usize
}

/// Values of all measured columns.
fn values(measured: &[Measured]) -> impl Iterator<Item = f64> {
    let columns = measured.iter().flat_map(|measured| &measured.columns);
    columns.flat_map(|(_, values)| values).copied().filter(|value| !value.is_nan())
}

fn scale_of(scales: &[(String, f64)], name: &str) -> f64 {
    scales.iter().find(|(other, _)| other == name).map_or(1.0, |(_, scale)| *scale)
}

/// Standard deviation about the mean; the size of what does not vary, and 1 of zeros.
fn spread(values: &[f64]) -> f64 {
    let n = values.len().max(1) as f64;
    let mean = values.iter().sum::<f64>() / n;
    let square = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / n;
    let size = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    match square.sqrt() {
        spread if spread > 1e-9 * size => spread,
        _ if size > 0.0 => size,
        _ => 1.0,
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Scales of outputs by their residuals, so that what is measured well counts for more; not
/// below a millionth of what they were at first.
fn renewed(
    fit: &fit::Fit<'_>,
    evaluation: &Evaluation,
    scales: &[(String, f64)],
    is_robust: bool,
) -> Vec<(String, f64)> {
    const LEAST: f64 = 1e-6;
    let residuals = fit.residuals_by_column(evaluation);
    let renew = |(name, scale): &(String, f64)| {
        let own = residuals.iter().filter(|(other, _)| other == name);
        let own: Vec<f64> = own.flat_map(|(_, residuals)| *residuals).copied().collect();
        let mean = own.iter().map(|r| r * r).sum::<f64>() / own.len().max(1) as f64;
        let usual = if is_robust {
            OF_MEDIAN * median(own.iter().map(|r| r.abs()).collect())
        } else {
            mean.sqrt()
        };
        (name.clone(), scale * if usual.is_finite() { usual.max(LEAST) } else { 1.0 })
    };
    scales.iter().map(renew).collect()
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
