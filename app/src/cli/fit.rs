//! `machinist fit`: parameters of a scene from measured runs.

mod answer;
pub mod data;
mod experiments;
mod noise;
mod plot;
pub(super) mod unknown;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use machinist::Simulation;
use machinist::constraints;
use machinist::fit::{End, Evaluation, Experiment, Fit, Fitted, Plan, Profile, Unknown, Unsolved};
use machinist_contract::Simulator;

use super::amount::in_si;
use super::arguments::{RunArgs, SceneArgs};
use super::output::{print, require_ending, require_picture};
use super::rewrite::{FoundValue, write_scene};
use super::scene::Scene;
use crate::failure::{ErrorCode, Failure};
use crate::interrupt;
use crate::number::number;
use crate::progress::spinner;
use answer::Answer;
use data::{File, Reading};
use experiments::Setup;
use noise::{Sigma, of_output};
use unknown::{Asked, asked, unknowns};

/// Default maximum number of steps of a search.
const STEPS: usize = 100;

#[derive(Debug, Args)]
pub struct FitCommand {
    /// Measured run: a CSV file with time in its first column; repeatable
    #[arg(long, value_name = "FILE", required_unless_present = "experiments")]
    data: Vec<PathBuf>,
    /// Measured runs with individual settings: a TOML file with one table [[experiment]] for each
    /// run, with the key `data` and the optional keys `name`, `from`, `set`, `map`, `outputs` and
    /// `sigma`
    #[arg(long, value_name = "FILE")]
    experiments: Option<PathBuf>,
    /// Parameters or initial values of states to fit, optionally with bounds
    #[arg(long, value_name = "NAME[=FROM..TO]", value_delimiter = ',', required = true,
        value_parser = asked)]
    parameters: Vec<Asked>,
    /// Outputs or states to fit. Default: all columns of the data
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    outputs: Vec<String>,
    /// Standard deviation of an output's measurement: absolute, relative to the measured value, or
    /// both, `0.02 + 1 %`. Default: the column `sigma(OUTPUT)` of the data, otherwise an estimate
    /// from the residuals
    #[arg(long, value_name = "OUTPUT=VALUE", value_parser = of_output)]
    sigma: Vec<(String, Sigma)>,
    /// Number of starts, spread within the bounds
    #[arg(long, value_name = "NUMBER", default_value_t = 1)]
    starts: usize,
    /// Loss function of the residuals
    #[arg(long, value_name = "LOSS", default_value = "squares")]
    loss: LossName,
    /// Maximum number of steps of a search
    #[arg(long, value_name = "NUMBER", default_value_t = STEPS)]
    steps: usize,
    /// Add confidence intervals by profile likelihood, for all fitted parameters or for these
    #[arg(long, value_name = "NAMES", value_delimiter = ',', num_args = 0..=1)]
    profile: Option<Vec<String>>,
    /// Output that a column of the data measures, if their names differ
    #[arg(long, value_name = "COLUMN=OUTPUT", value_parser = pair)]
    map: Vec<(String, String)>,
    /// Plot the profiles to a .svg or .png file
    #[arg(long, help_heading = "Output", value_name = "FILE")]
    plot_profiles: Option<PathBuf>,
    /// Print JSON
    #[arg(long, help_heading = "Output")]
    json: bool,
    /// Plot the data and the runs before and after the fit to a .svg or .png file, with several
    /// data files side by side
    #[arg(long, help_heading = "Output", value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Write the scene with the fitted values to a .toml file
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    run: RunArgs,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum LossName {
    /// Squares of the residuals
    Squares,
    /// Huber's loss: quadratic for small residuals, linear for large ones, which reduces the weight
    /// of outliers
    Huber,
}

/// Returns the state in which a run starts, with the initial values asked for.
pub(super) fn start_of(
    simulation: &Simulation<'_>,
    scene: &SceneArgs,
    run: &RunArgs,
) -> Result<Vec<f64>, Failure> {
    let simulator = simulation.simulator();
    let from = run.span.start_time(simulator);
    let mut start = constraints::start(simulator, simulation.parameter_values(), from)?;
    for (index, value) in start.iter_mut().enumerate() {
        let name = simulator.state(index).name;
        let given = scene.machine.initial.iter().find(|(given, _)| given == name);
        *value = given.map_or(*value, |(_, amount)| amount.value);
    }
    Ok(start)
}

/// Parses `column=output`.
fn pair(text: &str) -> Result<(String, String), String> {
    let (column, output) =
        text.split_once('=').ok_or("write it as COLUMN=OUTPUT, such as n1=motor_speed")?;
    Ok((column.trim().to_owned(), output.trim().to_owned()))
}

impl FitCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        self.check()?;
        let scene = self.scene.load()?;
        let simulator = scene.simulator();
        let simulation = self.simulation(simulator)?;
        let setups = self.setups()?;
        let (experiments, gaps) = self.experiments(&setups, &simulation)?;
        let start = start_of(&simulation, &self.scene, &self.run)?;
        let unknowns = unknowns(&self.parameters, simulator, &simulation, &start)?;
        let (unknowns, are_parameters): (Vec<Unknown>, Vec<bool>) = unknowns.into_iter().unzip();
        check_settings(&setups, &unknowns)?;
        let profiled = self.profiled(&unknowns)?;
        let flag = interrupt::flag();
        let plain = simulation.clone();
        let simulation = simulation.until_flagged(&flag);
        let lender = super::threads::lender(&scene);
        let mut simulation = simulation;
        if self.run.max_steps.is_none() {
            let limit = Fit::new(&simulation, &unknowns, &experiments).step_limit();
            simulation = simulation.max_steps(limit);
        }
        let fit = Fit::new(&simulation, &unknowns, &experiments).on_threads(&*lender);
        let count = values(&experiments).count();
        if count < unknowns.len() {
            let message = format!("{count} values are too few for {} unknowns", unknowns.len());
            return Err(Failure::input(message, ""));
        }
        check_first_runs(&fit)?;
        let plan = Plan {
            is_robust: self.loss == LossName::Huber,
            starts: self.starts,
            steps: self.steps,
            interrupt: Some(&flag),
        };
        let fitted = solve(&fit, &plan)?;
        let mut answer = Answer::new(&fit, &fitted, (&setups, &gaps), simulator);
        if !profiled.is_empty() && fitted.found.end != End::Interrupted {
            answer.profiles = profiles(&fit, &fitted, &profiled, &plan);
        }
        if let Some(file) = &self.plot {
            plot::draw(&Fit::new(&plain, &unknowns, &experiments), &answer, file)?;
        }
        if let Some(file) = &self.plot_profiles {
            plot::draw_profiles(&answer, file)?;
        }
        if let Some(file) = &self.out {
            let found = answer.parameters.iter().zip(&are_parameters).map(|(found, is_it)| {
                FoundValue { name: &found.name, value: found.value, is_parameter: *is_it }
            });
            write_scene(&self.scene, found, file)?;
        }
        self.tell(&answer, &scene)?;
        self.ended(&answer, fitted.found.end)
    }

    /// Writes the result to standard output.
    fn tell(&self, answer: &Answer, scene: &Scene) -> Result<(), Failure> {
        if self.json {
            let text = serde_json::to_string_pretty(answer)
                .map_err(|error| Failure::unsuccessful(error, ""))?;
            return print(&format!("{text}\n"));
        }
        let mut text = answer.describe(scene);
        for file in [&self.out, &self.plot, &self.plot_profiles].into_iter().flatten() {
            text.extend(["\nwrote ", &file.display().to_string(), "\n"]);
        }
        print(&text)
    }

    /// Returns an error unless the search has succeeded.
    fn ended(&self, answer: &Answer, end: End) -> Result<(), Failure> {
        let more = "the values above are the best so far";
        match end {
            End::Converged => Ok(()),
            // Residuals within the errors of the runs cannot get smaller.
            End::Stuck if answer.is_exact() => Ok(()),
            End::Interrupted => {
                Err(Failure::ended(ErrorCode::Interrupted, "the fit was interrupted", more))
            }
            End::Steps => {
                let message = format!("the fit has not converged after {} steps", self.steps);
                Err(Failure::unsuccessful(message, format!("{more}; `--steps` allows more")))
            }
            End::Stuck => {
                let help = format!("{more}; a lower `--rtol`, or other bounds, may help");
                Err(Failure::unsuccessful("no further step improves the fit", help))
            }
        }
    }

    fn check(&self) -> Result<(), Failure> {
        require_picture(self.plot.as_deref(), "--plot")?;
        require_picture(self.plot_profiles.as_deref(), "--plot-profiles")?;
        if let Some(file) = &self.out {
            require_ending(file, &["toml"], "--out")?;
        }
        if self.plot_profiles.is_some() && self.profile.is_none() {
            let help = "add `--profile`, for all or some parameters";
            return Err(Failure::input("--plot-profiles needs `--profile`", help));
        }
        if self.starts == 0 || self.steps == 0 {
            return Err(Failure::input("--starts and --steps must be at least 1", ""));
        }
        Ok(())
    }

    fn simulation<'a>(&self, simulator: &'a dyn Simulator<f64>) -> Result<Simulation<'a>, Failure> {
        self.run.apply(self.scene.simulation(simulator)?)
    }

    /// Returns the experiments asked for: files alone, then those with settings.
    fn setups(&self) -> Result<Vec<Setup>, Failure> {
        let plain = self.data.iter().map(|path| Setup {
            name: path.display().to_string(),
            data: path.clone(),
            ..Setup::default()
        });
        let mut setups: Vec<Setup> = plain.collect();
        if let Some(path) = &self.experiments {
            setups.extend(experiments::read(path)?);
        }
        let is_twice = |(number, setup): &(usize, &Setup)| {
            setups[..*number].iter().any(|other| other.name == setup.name)
        };
        match setups.iter().enumerate().find(is_twice) {
            None => Ok(setups),
            Some((_, setup)) => {
                let message = format!("there are two runs named `{}`", setup.name.escape_debug());
                Err(Failure::input(
                    message,
                    "list each run once; `name` distinguishes experiments with the same data",
                ))
            }
        }
    }

    /// Reads the data of the experiments, with the number of gaps in each.
    fn experiments(
        &self,
        setups: &[Setup],
        simulation: &Simulation<'_>,
    ) -> Result<(Vec<Experiment>, Vec<usize>), Failure> {
        let read = setups.iter().map(|setup| self.experiment(setup, simulation));
        let (all, gaps): (Vec<Experiment>, Vec<usize>) =
            read.collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
        self.check_columns(&all)?;
        check_noise(&all)?;
        Ok((all, gaps))
    }

    /// Reads one experiment. Options of the command line on columns apply unless the experiment has
    /// its own.
    fn experiment(
        &self,
        setup: &Setup,
        simulation: &Simulation<'_>,
    ) -> Result<(Experiment, usize), Failure> {
        let simulator = simulation.simulator();
        let map = [&setup.map[..], &self.map].concat();
        let outputs = if setup.outputs.is_empty() { &self.outputs } else { &setup.outputs };
        let given_from = setup.from.or(self.run.span.from);
        let from = given_from.unwrap_or(simulator.run_defaults().from);
        let until = self.run.span.until;
        let reading = Reading { simulator, map: &map, outputs, from, until, skips_unknown: false };
        let File { measured, mut noise, gaps } = reading.read(&setup.data)?;
        let is_measured = |name: &str| measured.columns.iter().any(|(column, _)| column == name);
        let own = setup.sigma.iter().map(|(name, _)| ("sigma", name));
        let own = own.chain(setup.map.iter().map(|(_, output)| ("map", output)));
        if let Some((key, name)) = own.into_iter().find(|(_, name)| !is_measured(name)) {
            let message = format!(
                "experiment `{}`: {key} of `{}`, which is not measured",
                setup.name.escape_debug(),
                name.escape_debug()
            );
            let known = measured.columns.iter().map(|(column, _)| column.as_str());
            return Err(Failure::unknown(message, name, known));
        }
        let is_new = |(name, _): &&(String, Sigma)| {
            is_measured(name) && setup.sigma.iter().all(|(other, _)| other != name)
        };
        for (name, sigma) in setup.sigma.iter().chain(self.sigma.iter().filter(is_new)) {
            if noise.iter().any(|(other, _)| other == name) {
                let message = format!("{}: the data already contain `sigma({name})`", setup.name);
                return Err(Failure::input(message, "remove either the column or this sigma"));
            }
            noise.push((name.clone(), sigma.of(name, simulator)?));
        }
        let (name, given) = (setup.name.clone(), in_si(&setup.set));
        let experiment = Experiment { name, measured, given, from: given_from, noise };
        check_given(setup, &experiment, simulation)?;
        Ok((experiment, gaps))
    }

    /// Returns an error if an option on the command line names an unknown column.
    fn check_columns(&self, experiments: &[Experiment]) -> Result<(), Failure> {
        let columns = experiments.iter().flat_map(|experiment| &experiment.measured.columns);
        let known: Vec<&str> = columns.map(|(name, _)| name.as_str()).collect();
        if let Some((column, output)) =
            self.map.iter().find(|(_, output)| !known.contains(&output.as_str()))
        {
            let message = format!("--map {column}={output}: no file has a column `{column}`");
            return Err(Failure::input(message.escape_debug(), ""));
        }
        match self.sigma.iter().find(|(name, _)| !known.contains(&name.as_str())) {
            None => Ok(()),
            Some((name, _)) => Err(Failure::unknown(
                format!("--sigma {}: there are no data for it", name.escape_debug()),
                name,
                known.into_iter(),
            )),
        }
    }

    /// Returns the indices of the unknowns whose profiles are asked for.
    fn profiled(&self, unknowns: &[Unknown]) -> Result<Vec<usize>, Failure> {
        let Some(names) = &self.profile else { return Ok(Vec::new()) };
        if names.is_empty() {
            return Ok((0..unknowns.len()).collect());
        }
        let place = |name: &String| {
            let known = unknowns.iter().map(|unknown| unknown.name.as_str());
            known.clone().position(|other| other == name).ok_or_else(|| {
                let message = format!("--profile {}: it is not fitted", name.escape_debug());
                Failure::unknown(message, name, known)
            })
        };
        names.iter().map(place).collect()
    }
}

/// Solves the fit and shows its progress.
fn solve(fit: &Fit<'_>, plan: &Plan<'_>) -> Result<Fitted, Failure> {
    let spinner = spinner("fitting");
    let fitted = fit.solve(plan, &mut |runs, evaluation| {
        spinner.set_message(progress("fitting", runs, evaluation));
    });
    spinner.finish_and_clear();
    fitted.map_err(|unsolved| match unsolved {
        Unsolved::NoStart { .. } => {
            Failure::unsuccessful(unsolved, "other bounds, or `--set`, may help")
        }
        _ => Failure::unsuccessful(unsolved, ""),
    })
}

/// Computes the profiles and shows their progress.
fn profiles(fit: &Fit<'_>, fitted: &Fitted, which: &[usize], plan: &Plan<'_>) -> Vec<Profile> {
    let spinner = spinner("profiling");
    let found = fit.profiles(fitted, which, plan, &mut |runs, evaluation| {
        spinner.set_message(progress("profiling", runs, evaluation));
    });
    spinner.finish_and_clear();
    found
}

/// Returns an error if a setting of an experiment is unknown or has a unit of another dimension.
fn check_given(
    setup: &Setup,
    experiment: &Experiment,
    simulation: &Simulation<'_>,
) -> Result<(), Failure> {
    for (name, amount) in &setup.set {
        amount.check_of(name, simulation)?;
    }
    let fit = Fit::new(simulation, &[], &[]);
    fit.simulation_of(experiment).map(|_| ()).map_err(|error| {
        let message = format!("experiment `{}`: {error}", setup.name.escape_debug());
        Failure::input(message, "")
    })
}

/// Returns an error if an experiment sets a parameter that is fitted.
fn check_settings(setups: &[Setup], unknowns: &[Unknown]) -> Result<(), Failure> {
    for setup in setups {
        let is_fitted = |name: &String| unknowns.iter().any(|unknown| unknown.name == *name);
        if let Some((name, _)) = setup.set.iter().find(|(name, _)| is_fitted(name)) {
            let message = format!(
                "experiment `{}` sets `{name}`, which is fitted",
                setup.name.escape_debug()
            );
            let help = "remove it from `set` or `--parameters`; `--set` gives the initial guess";
            return Err(Failure::input(message, help));
        }
    }
    Ok(())
}

/// Returns an error unless the noise of an output is known in all experiments and nowhere 0.
fn check_noise(experiments: &[Experiment]) -> Result<(), Failure> {
    for experiment in experiments {
        for (name, values) in &experiment.measured.columns {
            let Some(noise) = experiment.noise_of(name) else { continue };
            let lacks = |other: &&Experiment| {
                let is_measured = other.measured.columns.iter().any(|(column, _)| column == name);
                is_measured && other.noise_of(name).is_none()
            };
            if let Some(other) = experiments.iter().find(lacks) {
                let message = format!(
                    "the sigma of `{name}` is given for {}, but not for {}",
                    experiment.name, other.name
                );
                return Err(Failure::input(message, "give it for all experiments, or for none"));
            }
            let mut known = values.iter().enumerate().filter(|(_, value)| !value.is_nan());
            if let Some((row, value)) = known.find(|(row, value)| noise.at(*row, **value) == 0.0) {
                let message = format!(
                    "{}: row {} of `{name}` is {value}, so its relative standard deviation is zero",
                    experiment.name,
                    row + 1
                );
                return Err(Failure::input(message, "add an absolute part, as in `0.02 + 1 %`"));
            }
        }
    }
    Ok(())
}

/// Takes one step of each experiment, to find errors that all variants share.
fn check_first_runs(fit: &Fit<'_>) -> Result<(), Failure> {
    let names: Vec<&str> = fit.unknowns.iter().map(|unknown| unknown.name.as_str()).collect();
    for experiment in fit.experiments {
        let simulation = fit.simulation_of(experiment)?;
        let short = simulation.points(2).max_steps(1).sensitivities(&names)?;
        match short.run() {
            Err(machinist::SimulateError::Stopped { .. }) | Ok(_) => {}
            Err(error) => return Err(error.into()),
        }
    }
    Ok(())
}

/// Returns the values of all measured columns without gaps.
fn values(experiments: &[Experiment]) -> impl Iterator<Item = f64> {
    let columns = experiments.iter().flat_map(|experiment| &experiment.measured.columns);
    columns.flat_map(|(_, values)| values).copied().filter(|value| !value.is_nan())
}

fn progress(what: &str, runs: usize, evaluation: &Evaluation) -> String {
    let mean = evaluation.residuals.norm() / (evaluation.residuals.len() as f64).sqrt();
    format!("{what}: {runs} evaluations, residuals of {} on average", number(mean, 4))
}
