//! `machinist improve`: parameters of the best design within limits.

mod answer;
pub mod units;

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;
use machinist::fit::{Unknown, spread_starts};
use machinist::improve::{
    End, Expression, ExpressionError, Found, Improvement, Inequality, Sizes, Values, check,
};
use machinist::trajectory::{Column, Trajectory};
use machinist::{SimulateError, Simulation};
use machinist_contract::Simulator;
use miette::{LabeledSpan, MietteDiagnostic, Report};

use super::arguments::{RunArgs, SceneArgs};
use super::fit::start_of;
use super::fit::unknown::{Asked, asked, unknowns};
use super::output::{draw_file, print, require_ending, require_picture};
use super::rewrite::{FoundValue, write_scene};
use super::scene::Scene;
use super::settings::for_numbers;
use crate::failure::{ErrorCode, Failure};
use crate::interrupt;
use crate::number::number;
use crate::progress::spinner;
use answer::Answer;

/// Default maximum number of steps of a search.
const STEPS: usize = 100;

#[derive(Debug, Args)]
pub struct Improve {
    /// Objective to minimize: an expression of extremes, means and final values of outputs, such as
    /// max(abs(twist)), and of parameters
    #[arg(
        long,
        value_name = "EXPRESSION",
        conflicts_with = "maximise",
        allow_hyphen_values = true
    )]
    minimise: Option<String>,
    /// Objective to maximize, an expression as for --minimise
    #[arg(long, value_name = "EXPRESSION", allow_hyphen_values = true)]
    maximise: Option<String>,
    /// Constraint, such as max(abs(coupling_torque)) <= 900; repeatable
    #[arg(long, value_name = "EXPRESSION<=EXPRESSION", allow_hyphen_values = true)]
    subject_to: Vec<String>,
    /// Parameters or initial values of states to vary, optionally with bounds
    #[arg(long, value_name = "NAME[=FROM..TO]", value_delimiter = ',', required = true,
        value_parser = asked)]
    parameters: Vec<Asked>,
    /// Number of times at which runs are evaluated. Default: that of the scene, but at least 2001
    #[arg(long, value_name = "NUMBER")]
    points: Option<usize>,
    /// Number of starts, spread within the bounds
    #[arg(long, value_name = "NUMBER", default_value_t = 1)]
    starts: usize,
    /// Maximum number of steps of a search
    #[arg(long, value_name = "NUMBER", default_value_t = STEPS)]
    steps: usize,
    /// Print JSON
    #[arg(long, help_heading = "Output")]
    json: bool,
    /// Plot the outputs in the expressions, before and after, to a .svg or .png file
    #[arg(long, help_heading = "Output", value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Write the scene with the values found to a .toml file
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    run: RunArgs,
}

/// Goal as text and as parsed.
struct Goal<'t> {
    /// Text of the objective.
    objective_text: &'t str,
    /// Expression to minimize.
    objective: Expression,
    is_greatest: bool,
    inequalities: Vec<Inequality>,
}

/// Search that has ended.
struct Searched {
    found: Found,
    sizes: Sizes,
    /// Number of starts that failed, and the reason of the first.
    lost: (usize, Option<String>),
    runs: usize,
}

impl Improve {
    pub fn execute(&self) -> Result<(), Failure> {
        self.check_options()?;
        let scene = self.scene.load()?;
        let simulator = scene.simulator();
        let goal = self.goal(simulator)?;
        let simulation = self.simulation(simulator)?;
        let start = start_of(&simulation, &self.scene, &self.run)?;
        let unknowns = unknowns(&self.parameters, simulator, &simulation, &start)?;
        let (unknowns, are_parameters): (Vec<Unknown>, Vec<bool>) = unknowns.into_iter().unzip();
        let plain = Improvement {
            simulation: &simulation,
            unknowns: &unknowns,
            objective: &goal.objective,
            inequalities: &goal.inequalities,
        };
        check_first_run(&plain)?;
        let flag = interrupt::flag();
        let limited = simulation.clone().until_flagged(&flag);
        let limited = match self.run.max_steps {
            Some(_) => limited,
            None => limited.max_steps(steps_of(&plain)),
        };
        let improvement = Improvement { simulation: &limited, ..plain };
        let searched = self.search(&improvement, &flag)?;
        let plain = Improvement { simulation: &simulation, ..improvement };
        let answer = Answer::new(&plain, &goal, &self.subject_to, &searched, simulator)?;
        if let Some(file) = &self.plot {
            draw(&plain, &goal, &answer.values(), file)?;
        }
        if let Some(file) = &self.out {
            let found = answer.parameters.iter().zip(&are_parameters).map(|(found, is_it)| {
                FoundValue { name: &found.name, value: found.value, is_parameter: *is_it }
            });
            write_scene(&self.scene, found, file)?;
        }
        self.tell(&answer, &scene)?;
        self.verdict(&searched.found)
    }

    fn check_options(&self) -> Result<(), Failure> {
        require_picture(self.plot.as_deref(), "--plot")?;
        if let Some(file) = &self.out {
            require_ending(file, &["toml"], "--out")?;
        }
        if self.starts == 0 || self.steps == 0 {
            return Err(Failure::input("--starts and --steps must be at least 1", ""));
        }
        if self.points.is_some_and(|points| points < 2) {
            return Err(Failure::input("--points must be at least 2", ""));
        }
        if self.minimise.is_none() && self.maximise.is_none() {
            let help = "such as --minimise 'max(abs(coupling_torque))'";
            return Err(Failure::input("no objective: give --minimise or --maximise", help));
        }
        Ok(())
    }

    fn goal(&self, simulator: &dyn Simulator<f64>) -> Result<Goal<'_>, Failure> {
        let (option, text) = match (&self.minimise, &self.maximise) {
            (Some(text), _) => ("--minimise", text),
            (None, text) => ("--maximise", text.as_ref().unwrap_or(&self.scene.scene)),
        };
        let mut objective = expression(option, text, simulator)?;
        let is_greatest = self.minimise.is_none();
        if is_greatest {
            let range = objective.range.clone();
            let node = machinist::improve::Node::Negative(Box::new(objective));
            objective = Expression { node, range };
        }
        let inequality = |text: &String| {
            let read = Inequality::parse(text).and_then(|inequality| {
                check(&inequality.left, simulator)?;
                check(&inequality.right, simulator)?;
                units::check_sides(&inequality, simulator)?;
                Ok(units::sides_in_one_unit(inequality, simulator))
            });
            read.map_err(|error| wrong("--subject-to", text, &error))
        };
        let inequalities = self.subject_to.iter().map(inequality).collect::<Result<_, _>>()?;
        Ok(Goal { objective_text: text, objective, is_greatest, inequalities })
    }

    fn simulation<'a>(&self, simulator: &'a dyn Simulator<f64>) -> Result<Simulation<'a>, Failure> {
        for_numbers(simulator, (&self.scene, &self.run), self.points)
    }

    fn search(
        &self,
        improvement: &Improvement<'_>,
        flag: &AtomicBool,
    ) -> Result<Searched, Failure> {
        let spinner = spinner("improving");
        let mut best: Option<Found> = None;
        let mut lost = (0, None);
        let mut runs = 0;
        let mut sizes: Option<Sizes> = None;
        let starts = spread_starts(&improvement.start(), &improvement.bounds(), self.starts);
        for start in starts {
            if flag.load(Ordering::Relaxed) {
                break;
            }
            // Scaled by the sizes of the first start that can be simulated.
            let told = match &sizes {
                Some(sizes) => Ok(sizes.clone()),
                None => improvement
                    .numbers_at(&improvement.values(&start))
                    .map(|told| improvement.sizes(&told)),
            };
            let found = told.map_err(|error| error.to_string()).and_then(|told| {
                let sizes = &*sizes.insert(told);
                improvement.search(&start, sizes, self.steps, Some(flag), |evaluation| {
                    runs += 1;
                    let value = evaluation.objective[0].value * sizes.objective;
                    let missed = evaluation.missed();
                    let missed = if missed > 0.0 { ", constraints violated" } else { "" };
                    let value = number(value, 6);
                    spinner.set_message(format!("improving: {runs} runs, {value}{missed}"));
                })
            });
            match found {
                Ok(found) => {
                    if best.as_ref().is_none_or(|best| found.is_better_than(best)) {
                        best = Some(found);
                    }
                }
                Err(_) if flag.load(Ordering::Relaxed) => {}
                Err(why) => {
                    lost.0 += 1;
                    lost.1.get_or_insert(why);
                }
            }
        }
        spinner.finish_and_clear();
        let is_interrupted = flag.load(Ordering::Relaxed);
        match (best, sizes) {
            (Some(mut found), Some(sizes)) => {
                if is_interrupted {
                    found.end = End::Interrupted;
                }
                Ok(Searched { found, sizes, lost, runs })
            }
            _ if is_interrupted => Err(Failure::ended(
                ErrorCode::Interrupted,
                "the search was interrupted at its start",
                "",
            )),
            _ => {
                let why = lost.1.unwrap_or_default();
                let message = format!("no start can be simulated: {why}");
                Err(Failure::unsuccessful(message, "other bounds, or `--set`, may help"))
            }
        }
    }

    fn tell(&self, answer: &Answer, scene: &Scene) -> Result<(), Failure> {
        if self.json {
            let text = serde_json::to_string_pretty(answer)
                .map_err(|error| Failure::unsuccessful(error, ""))?;
            return print(&format!("{text}\n"));
        }
        let mut text = answer.describe(scene);
        for file in [&self.out, &self.plot].into_iter().flatten() {
            text.extend(["\nwrote ", &file.display().to_string(), "\n"]);
        }
        print(&text)
    }

    fn verdict(&self, found: &Found) -> Result<(), Failure> {
        let more = "the values above are the best so far";
        match found.end {
            End::Interrupted => {
                Err(Failure::ended(ErrorCode::Interrupted, "the search was interrupted", more))
            }
            _ if !found.is_feasible() => {
                let missed: Vec<&str> = found
                    .evaluation
                    .constraints
                    .iter()
                    .zip(&self.subject_to)
                    .filter(|(branches, _)| branches[0].value > 1e-7)
                    .map(|(_, text)| text.as_str())
                    .collect();
                let message = format!("found no values that satisfy {}", missed.join(" and "));
                let help = "the values above violate it least; other bounds, `--starts`, or more \
                            parameters may help";
                Err(Failure::unsuccessful(message, help))
            }
            End::Converged | End::Infeasible => Ok(()),
            End::Steps => {
                let message = format!("the search has not converged after {} steps", self.steps);
                Err(Failure::unsuccessful(message, format!("{more}; `--steps` allows more")))
            }
            End::Stuck => {
                let help = format!("{more}; a lower `--rtol`, or other bounds, may help");
                Err(Failure::unsuccessful("no further step improves the objective", help))
            }
        }
    }
}

/// Parses the expression of an option and checks its names and units.
pub(super) fn expression(
    option: &str,
    text: &str,
    simulator: &dyn Simulator<f64>,
) -> Result<Expression, Failure> {
    let read = Expression::parse(text).and_then(|expression| {
        check(&expression, simulator)?;
        units::check(&expression, simulator)?;
        Ok(units::in_one_unit(expression, simulator))
    });
    read.map_err(|error| wrong(option, text, &error))
}

/// Creates the error for an expression of the command line, with its position.
pub(super) fn wrong(option: &str, text: &str, error: &ExpressionError) -> Failure {
    let range = error.range.clone();
    let length = range.end.max(range.start + 1) - range.start;
    let mut diagnostic = MietteDiagnostic::new(format!("{option}: {}", error.message))
        .with_code(error.code())
        .with_label(LabeledSpan::new(Some("here".to_owned()), range.start, length));
    if !error.help.is_empty() {
        diagnostic = diagnostic.with_help(error.help.clone());
    }
    Failure::Input(vec![Report::new(diagnostic).with_source_code(format!("{text} "))])
}

/// Takes one step, to find errors that all variants share.
fn check_first_run(improvement: &Improvement<'_>) -> Result<(), Failure> {
    let names: Vec<&str> = improvement.unknowns.iter().map(|unknown| &*unknown.name).collect();
    let short = improvement.simulation.clone().points(2).max_steps(1).sensitivities(&names)?;
    match short.run() {
        Err(SimulateError::Stopped { .. }) | Ok(_) => Ok(()),
        Err(error) => Err(error.into()),
    }
}

/// Returns the maximum number of steps of a variant, a multiple of those of the start.
fn steps_of(improvement: &Improvement<'_>) -> usize {
    const TIMES: u64 = 50;
    const LEAST: u64 = 20_000;
    const UNKNOWN: u64 = 200_000;
    let limited = improvement.simulation.clone().max_steps(UNKNOWN as usize);
    let first = Improvement { simulation: &limited, ..*improvement };
    let starts: Vec<f64> = first.unknowns.iter().map(|unknown| unknown.start).collect();
    let steps = first.run(&starts, false).map_or(UNKNOWN / TIMES, |run| run.work.steps);
    (TIMES * steps).max(LEAST) as usize
}

/// Draws the columns that the expressions use, before and after.
fn draw(
    improvement: &Improvement<'_>,
    goal: &Goal<'_>,
    found: &[f64],
    file: &std::path::Path,
) -> Result<(), Failure> {
    let starts: Vec<f64> = improvement.unknowns.iter().map(|unknown| unknown.start).collect();
    let after = improvement.run(found, false)?;
    // A start that cannot be simulated is not drawn.
    let before = improvement.run(&starts, false).ok();
    let mut names: Vec<String> = Vec::new();
    let sides =
        goal.inequalities.iter().flat_map(|inequality| [&inequality.left, &inequality.right]);
    for expression in std::iter::once(&goal.objective).chain(sides) {
        expression.for_each_name(&mut |name, _, is_within| {
            if is_within && after.find(name).is_some() && !names.iter().any(|known| known == name) {
                names.push(name.to_owned());
            }
        });
    }
    if names.is_empty() {
        names.extend(after.columns.last().map(|column| column.name.clone()));
    }
    let mut columns = Vec::new();
    for name in &names {
        let Some(of) = after.find(name) else { continue };
        let column = |what: &str, values: &[f64]| Column {
            name: format!("{name}, {what}"),
            values: values.to_vec(),
            ..of.clone()
        };
        if let Some(values) = before.as_ref().and_then(|run| run.column(name)) {
            columns.push(column("before", values));
        }
        columns.push(column("improved", &of.values));
    }
    let drawn = Trajectory { columns, ..after };
    let names: Vec<&str> = drawn.columns.iter().map(|column| &*column.name).collect();
    draw_file(file, |path| crate::plot::plot(&drawn, &names, path))
}

/// Returns the values before the search; `None` if the start cannot be simulated.
fn before(improvement: &Improvement<'_>) -> Option<Values> {
    let starts: Vec<f64> = improvement.unknowns.iter().map(|unknown| unknown.start).collect();
    improvement.numbers_at(&starts).ok()
}
