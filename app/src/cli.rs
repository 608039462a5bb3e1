//! Command line, with one file in `src/cli/` for each command.
//!
//! Answers go to standard output, everything else to standard error. The exit code is 0 for
//! success, 1 for a check that failed or a run that stopped, 2 for bad input. A command that fails
//! leaves no file behind.

mod amount;
mod bench;
#[cfg(feature = "derive")]
mod cache;
mod campbell;
#[cfg(feature = "derive")]
pub mod check;
#[cfg(feature = "derive")]
mod compile;
mod completions;
#[cfg(feature = "derive")]
mod derive;
#[cfg(feature = "derive")]
pub mod explain;
mod fit;
#[cfg(feature = "derive")]
mod fmu;
#[cfg(feature = "derive")]
mod generate;
mod gradient;
mod improve;
mod linear;
mod list;
pub mod modes;
#[cfg(feature = "derive")]
pub mod new;
pub mod output;
#[cfg(feature = "derive")]
mod parts;
mod range;
#[cfg(feature = "derive")]
mod report;
mod response;
mod rewrite;
mod run;
pub mod scene;
#[cfg(feature = "derive")]
mod schema;
mod sensitivity;
pub mod settings;
mod show;
#[cfg(feature = "derive")]
pub mod specs;
mod spectrum;
mod stability;
mod sweep;
mod threads;
mod times;
pub mod verify;
pub mod walk;
#[cfg(feature = "derive")]
mod watch;

use std::process::ExitCode;

use clap::{Parser, Subcommand};
#[cfg(feature = "derive")]
use machinist_algebra::cas::Algebra;

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
    /// Derive anew, and remember nothing of it
    #[cfg(feature = "derive")]
    #[arg(long, global = true)]
    no_cache: bool,
    /// Algebra that derives: plain, or symbolica, which simplifies further and runs once a machine;
    /// gen, derive and the report of all scenes take symbolica unless told otherwise
    #[cfg(feature = "derive")]
    #[arg(long, global = true, value_name = "NAME", value_parser = algebra)]
    algebra: Option<Algebra>,
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Begin a machine of your own: a crate that simulates it, or only its spec
    #[cfg(feature = "derive")]
    New(new::New),
    /// Emit the simulators of all scenes as Rust, or of one as C99
    #[cfg(feature = "derive")]
    Gen(generate::Generate),
    /// Check specs and say what is wrong with them
    #[cfg(feature = "derive")]
    Check(check::Check),
    /// Print the equations of motion of a scene
    #[cfg(feature = "derive")]
    Derive(derive::Derive),
    /// Derive a scene and write its model, which runs anywhere
    #[cfg(feature = "derive")]
    Compile(compile::Compile),
    /// Write a scene as a functional mock-up unit, for hosts of FMI 3.0
    #[cfg(feature = "derive")]
    Fmu(fmu::Fmu),
    /// Say what is left out of a scene, why, and what that saves
    #[cfg(feature = "derive")]
    Explain(explain::Explain),
    /// Simulate a scene
    Run(run::Run),
    /// Which parameters matter for which outputs, along a run
    Sensitivity(sensitivity::Sensitivity),
    /// How one number of a run depends on all parameters and initial values
    Gradient(gradient::GradientCommand),
    /// Find parameters of a scene from measured runs
    Fit(fit::FitCommand),
    /// Find parameters at which a design is best, within limits
    Improve(improve::Improve),
    /// Amplitudes of a run's outputs over frequency
    Spectrum(spectrum::Spectrum),
    /// Simulate many variants of a scene, to a table
    Sweep(sweep::Sweep),
    /// Measure error against run time of all methods on a scene
    Bench(bench::Bench),
    /// Strain all methods by extreme cases: right, refused or wrong
    Stability(stability::Stability),
    /// Natural frequencies, damping and mode shapes of a scene
    Modes(modes::Modes),
    /// Natural frequencies over a parameter, and where orders of a speed meet them
    Campbell(campbell::CampbellDiagram),
    /// Frequency response of a scene: amplitude and phase
    Response(response::FrequencyResponse),
    /// Say which model of a winder is enough, and where it winds stably
    Walk(walk::WalkCommand),
    /// Hold the simulators against closed forms and references
    Verify(verify::Verify),
    /// Make pages with drawings, equations, plots, checks and costs: of all scenes, or of one
    #[cfg(feature = "derive")]
    Report(report::Report),
    /// Show a machine in the browser while its spec is written: run at each save
    #[cfg(feature = "derive")]
    Watch(watch::Watch),
    /// Show what a scene is made of: units, ports, parameters, states, outputs, events, checks
    Show(show::Show),
    /// List the scenes that are built in
    List(list::List),
    /// List the standard parts that scenes are made of, or show one of them
    #[cfg(feature = "derive")]
    Parts(parts::Parts),
    /// Print what a spec may hold, as JSON schema, for editors
    #[cfg(feature = "derive")]
    Schema(schema::Schema),
    /// What is remembered of scenes that were derived
    #[cfg(feature = "derive")]
    Cache(cache::CacheCommand),
    /// Write what a shell needs to complete commands and options
    Completions(completions::Completions),
    /// What a parent process has its child do
    #[cfg(feature = "derive")]
    #[command(name = deriving::COMMAND, hide = true)]
    DeriveForParent,
    /// The work of the child process of `watch`
    #[cfg(feature = "derive")]
    #[command(name = worker::COMMAND, hide = true)]
    RunForWatch(worker::Ask),
}

/// Returns the algebra of a name.
#[cfg(feature = "derive")]
fn algebra(name: &str) -> Result<Algebra, String> {
    let known = Algebra::ALL.iter().find(|algebra| algebra.name() == name);
    known.copied().ok_or_else(|| {
        let names: Vec<&str> = Algebra::ALL.iter().map(|algebra| algebra.name()).collect();
        format!("this build knows {}", names.join(" and "))
    })
}

/// Returns the algebra that the environment names, if any.
#[cfg(feature = "derive")]
fn algebra_of_environment() -> Result<Option<Algebra>, Failure> {
    const VARIABLE: &str = "MACHINIST_ALGEBRA";
    let Some(name) = std::env::var_os(VARIABLE).filter(|name| !name.is_empty()) else {
        return Ok(None);
    };
    let name = name.to_string_lossy();
    let refuse = |known| Failure::input(format!("{VARIABLE} is `{}`", name.escape_debug()), known);
    algebra(&name).map(Some).map_err(refuse)
}

/// Runs the command that the arguments of this process ask for.
#[must_use]
pub fn main() -> ExitCode {
    let cli = Cli::parse();
    #[cfg(feature = "derive")]
    if cli.no_cache {
        deriving::turn_off_cache();
    }
    #[cfg(feature = "derive")]
    match cli.algebra.map_or_else(algebra_of_environment, |named| Ok(Some(named))) {
        Ok(named) => named.into_iter().for_each(deriving::derive_by),
        Err(failure) => return failure.tell(),
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
        Command::Run(command) => command.execute(),
        Command::Sensitivity(command) => command.execute(),
        Command::Fit(command) => command.execute(),
        Command::Gradient(command) => command.execute(),
        Command::Improve(command) => command.execute(),
        Command::Spectrum(command) => command.execute(),
        Command::Sweep(command) => command.execute(),
        Command::Bench(command) => command.execute(),
        Command::Stability(command) => command.execute(),
        Command::Modes(command) => command.execute(),
        Command::Campbell(command) => command.execute(),
        Command::Response(command) => command.execute(),
        Command::Walk(command) => command.execute(),
        Command::Verify(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::Report(command) => command.execute(),
        Command::Show(command) => command.execute(),
        Command::List(command) => command.execute(),
        #[cfg(feature = "derive")]
        Command::Parts(command) => command.execute(),
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
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.tell(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory as _;

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }
}
