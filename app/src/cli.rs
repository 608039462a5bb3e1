//! Command line, with one file in `src/cli/` for each command.
//!
//! Answers go to standard output, everything else to standard error. The exit code is 0 for
//! success, 1 for a check that failed or a run that stopped, 2 for bad input. A command that fails
//! leaves no file behind.

mod amount;
pub mod arguments;
mod bench;
#[cfg(feature = "derive")]
mod cache;
mod campbell;
#[cfg(feature = "derive")]
pub mod check;
#[cfg(feature = "derive")]
mod compile;
mod completions;
mod cycle;
#[cfg(feature = "derive")]
mod derive;
mod estimator;
#[cfg(feature = "derive")]
pub mod explain;
mod explain_error;
mod fatigue;
mod fit;
#[cfg(feature = "derive")]
mod fmu;
#[cfg(feature = "derive")]
pub mod generate;
mod gradient;
pub mod groups;
#[cfg(feature = "derive")]
mod import;
pub mod improve;
mod linear;
mod linearize;
mod list;
pub mod modes;
#[cfg(feature = "derive")]
pub mod new;
mod orders;
pub mod output;
#[cfg(feature = "derive")]
mod parts;
mod plot;
mod range;
#[cfg(feature = "derive")]
mod report;
mod response;
mod rewrite;
pub mod run;
#[cfg(feature = "derive")]
pub mod scatter;
pub mod scene;
#[cfg(feature = "derive")]
mod schema;
mod sensitivity;
pub mod settings;
mod show;
mod signals;
#[cfg(feature = "derive")]
pub mod specs;
mod spectrum;
mod stability;
mod studies;
mod sweep;
mod table;
mod threads;
mod times;
mod variants;
pub mod verify;
pub mod walk;
#[cfg(feature = "derive")]
mod watch;

use std::ffi::OsString;
use std::process::ExitCode;

#[cfg(feature = "derive")]
use arguments::DeriveArgs;
#[cfg(feature = "derive")]
use clap::ArgMatches;
#[cfg(feature = "derive")]
use clap::parser::ValueSource;
use clap::{
    ColorChoice, CommandFactory as _, FromArgMatches as _, Parser, Subcommand, ValueEnum as _,
};

use crate::config::{self, Colours};
#[cfg(feature = "derive")]
use crate::deriving;
#[cfg(feature = "derive")]
use crate::failure::Failure;
#[cfg(feature = "derive")]
use crate::watch::worker;

/// Lagrangian specs of machines to fast, checked Rust simulators.
#[derive(Debug, Parser)]
#[command(name = "machinist", version, propagate_version = true)]
struct Cli {
    #[cfg(feature = "derive")]
    #[command(flatten)]
    derivation: DeriveArgs,
    /// Colour messages: auto (on terminals), always or never
    #[arg(long, global = true, value_name = "WHEN", alias = "color", hide_possible_values = true)]
    colours: Option<Colours>,
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Create a new machine: a crate that simulates it, or only its spec
    #[cfg(feature = "derive")]
    New(new::New),
    /// Emit the simulators of all scenes as Rust, or of one as C99
    #[cfg(feature = "derive")]
    Gen(generate::Generate),
    /// Check specs and report errors
    #[cfg(feature = "derive")]
    Check(check::Check),
    /// Print the equations of motion of a scene
    #[cfg(feature = "derive")]
    Derive(derive::Derive),
    /// Write a scene of a robot that a URDF file describes
    #[cfg(feature = "derive")]
    Import(import::Import),
    /// Derive a scene and write it as a portable model file
    #[cfg(feature = "derive")]
    Compile(compile::Compile),
    /// Export a scene as a functional mock-up unit (FMI 2.0 or 3.0)
    #[cfg(feature = "derive")]
    Fmu(fmu::Fmu),
    /// Explain what is left out of a scene, why, and what that saves
    #[cfg(feature = "derive")]
    Explain(explain::Explain),
    /// Explain an error by its code: cause and remedy
    ExplainError(explain_error::ExplainError),
    /// Simulate a scene
    Run(run::RunCommand),
    /// Plot the columns of a run or of a table, over time or over another column
    Plot(plot::PlotCommand),
    /// Rank parameters by their effect on the outputs of a run
    Sensitivity(sensitivity::Sensitivity),
    /// Differentiate one result of a run by all parameters and initial values
    Gradient(gradient::GradientCommand),
    /// Fit parameters of a scene to measured runs
    Fit(fit::FitCommand),
    /// Optimize parameters of a scene under constraints
    Improve(improve::Improve),
    /// Compute amplitude spectra of a run's outputs
    Spectrum(spectrum::Spectrum),
    /// Count the load cycles of a run's outputs (rainflow), and add up their damage
    Fatigue(fatigue::Fatigue),
    /// Simulate variants of a scene over ranges of parameters
    Sweep(sweep::Sweep),
    /// Compute the scatter of results for parameters with distributions: mean, quantiles,
    /// probability of failure, sensitivity indices
    #[cfg(feature = "derive")]
    Scatter(scatter::ScatterCommand),
    /// Measure error and run time of all methods on a scene
    Bench(bench::Bench),
    /// Test all methods on extreme cases: right, refused or wrong
    Stability(stability::Stability),
    /// Compute natural frequencies, damping and mode shapes of a scene
    Modes(modes::Modes),
    /// Compute natural frequencies over a parameter, and their crossings with orders of a speed
    Campbell(campbell::CampbellDiagram),
    /// Compute the frequency response of a scene: amplitude and phase
    Response(response::FrequencyResponse),
    /// Compute the state-space model of a scene, with poles, zeros, regulators and Kalman filters
    Linearize(linearize::Linearize),
    /// Find periodic motions of a scene and their stability
    Cycle(cycle::CycleCommand),
    /// Compute studies of the literature again
    Studies(studies::Studies),
    /// Old name of `studies walk`
    #[command(hide = true)]
    Walk(walk::WalkCommand),
    /// Compare the simulators with closed forms and references
    Verify(verify::Verify),
    /// Write HTML pages with drawings, equations, plots, checks and costs, of all scenes or of one
    #[cfg(feature = "derive")]
    Report(report::Report),
    /// Show a machine in the browser, and run it again whenever its spec is saved
    #[cfg(feature = "derive")]
    Watch(watch::Watch),
    /// Show the units, ports, parameters, states, outputs, events and checks of a scene
    Show(show::Show),
    /// List the built-in scenes
    List(list::List),
    /// List the standard parts, or show one of them
    #[cfg(feature = "derive")]
    Parts(parts::Parts),
    /// Print the JSON schema of specs, for editors
    #[cfg(feature = "derive")]
    Schema(schema::Schema),
    /// Show or clear the cache of derived models
    #[cfg(feature = "derive")]
    Cache(cache::CacheCommand),
    /// Print the completion script for a shell
    Completions(completions::Completions),
    /// Derive for a parent process
    #[cfg(feature = "derive")]
    #[command(name = deriving::COMMAND, hide = true)]
    DeriveForParent,
    /// Run for the parent process of `watch`
    #[cfg(feature = "derive")]
    #[command(name = worker::COMMAND, hide = true)]
    RunForWatch(worker::Ask),
}

/// Returns the command line of the program.
#[must_use]
pub fn command() -> clap::Command {
    let command = groups::grouped(Cli::command());
    // Without a scene, no single run takes these options.
    command.mut_subcommand("verify", |verify| {
        verify.mut_args(|arg| match arg.get_help_heading() {
            Some("Run" | "Machine") if arg.get_id() != "set" => arg.requires("scene"),
            _ => arg,
        })
    })
}

/// Returns an error for options before a command that does not have them.
#[cfg(feature = "derive")]
fn check_place(command: &clap::Command, matches: &ArgMatches) -> Result<(), Failure> {
    let given = ["algebra", "no_cache"].into_iter().find(|option| {
        let is_given = matches.value_source(option) == Some(ValueSource::CommandLine);
        let inner = matches.subcommand_name().and_then(|name| command.find_subcommand(name));
        is_given
            && !inner.is_some_and(|inner| inner.get_arguments().any(|arg| arg.get_id() == option))
    });
    given.map_or(Ok(()), |option| {
        let (option, name) = (option.replace('_', "-"), matches.subcommand_name());
        let message =
            format!("`{}` derives nothing, so it takes no `--{option}`", name.unwrap_or_default());
        Err(Failure::input(message, "leave the option out"))
    })
}

/// Returns the colours asked for, before the command line is parsed.
fn asked_colours(arguments: &[OsString]) -> Option<Colours> {
    let arguments: Vec<String> =
        arguments.iter().map(|argument| argument.to_string_lossy().into_owned()).collect();
    let value = |(at, argument): (usize, &String)| {
        let rest = ["--colours", "--color"].iter().find_map(|name| argument.strip_prefix(name))?;
        let next = || arguments.get(at + 1).cloned();
        let value =
            if rest.is_empty() { next() } else { rest.strip_prefix('=').map(str::to_owned) };
        Colours::from_str(&value?, false).ok()
    };
    arguments.iter().enumerate().find_map(value)
}

/// Runs the command that the arguments of this process ask for.
#[must_use]
pub fn main() -> ExitCode {
    run(&std::env::args_os().collect::<Vec<_>>()).into()
}

/// Runs the command that arguments ask for, the first of which is the name of the program, and
/// returns the exit code.
pub fn run(arguments: &[OsString]) -> u8 {
    if let Err(failure) = config::load() {
        return failure.tell();
    }
    config::start_log();
    let choice = match asked_colours(arguments).or_else(config::colours) {
        None | Some(Colours::Auto) => ColorChoice::Auto,
        Some(Colours::Always) => ColorChoice::Always,
        Some(Colours::Never) => ColorChoice::Never,
    };
    let mut command = command().color(choice);
    let matches = command.try_get_matches_from_mut(arguments).unwrap_or_else(|error| error.exit());
    let cli = Cli::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    cli.colours.or_else(config::colours).into_iter().for_each(config::colour_messages);
    #[cfg(feature = "derive")]
    {
        if let Err(failure) = check_place(&command, &matches) {
            return failure.tell();
        }
        cli.derivation.apply();
    }
    let done = match cli.command {
        #[cfg(feature = "derive")]
        Command::New(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::Gen(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::Check(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::Derive(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::Explain(command) => command.execute(),
        Command::ExplainError(command) => command.execute(),
        Command::Run(command) => command.execute(),
        Command::Plot(command) => command.execute(),
        Command::Sensitivity(command) => command.execute(),
        Command::Fit(command) => command.execute(),
        Command::Gradient(command) => command.execute(),
        Command::Improve(command) => command.execute(),
        Command::Spectrum(command) => command.execute(),
        Command::Fatigue(command) => command.execute(),
        Command::Sweep(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::Scatter(command) => command.execute(),
        Command::Bench(command) => command.execute(),
        Command::Stability(command) => command.execute(),
        Command::Modes(command) => command.execute(),
        Command::Campbell(command) => command.execute(),
        Command::Response(command) => command.execute(),
        Command::Linearize(command) => command.execute(),
        Command::Cycle(command) => command.execute(),
        Command::Studies(command) => command.execute(),
        Command::Walk(command) => {
            eprintln!("machinist: `walk` is now `studies walk`");
            command.execute()
        }
        Command::Verify(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::Report(command) => command.execute(),
        Command::Show(command) => command.execute(),
        Command::List(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::Parts(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::Import(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::Compile(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::Fmu(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::Schema(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::Cache(command) => command.execute(),
        Command::Completions(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::DeriveForParent => deriving::answer_parent(),
        #[cfg(feature = "derive")]
        Command::RunForWatch(ask) => ask.execute(),
        #[cfg(feature = "derive")]
        Command::Watch(command) => command.execute(),
    };
    match done {
        Ok(()) => 0,
        Err(failure) => failure.tell(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        command().debug_assert();
    }
}
