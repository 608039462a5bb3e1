//! `machinist cycle`: periodic motions and their stability.

mod branch;
mod section;

use std::io;
use std::path::PathBuf;

use clap::Args;
use machinist::Simulation;
use machinist::periodic::{Cycle, CycleError, CycleSettings, Multiplier, Period, Stability, cycle};
use machinist::trajectory::{Column, ColumnKind, Trajectory};
use machinist_contract::Simulator;
use serde_json::json;

use super::amount::{Amount, time};
use super::arguments::{RunArgs, SceneArgs};
use super::output::{
    columns, counted_events, draw_file, is_standard_output, notes_told, print, print_with,
    require_picture, write_file,
};
use super::range::{Range, range};
use super::scene::Scene;
use crate::failure::Failure;
use crate::interrupt;
use crate::number::number;
use crate::parquet;
use crate::progress::during;

/// Default relative tolerance, unless the scene's is lower: multipliers then have about eight
/// digits.
const RTOL: f64 = 1e-10;
/// Maximum number of multipliers in the table.
const SHOWN: usize = 12;

#[derive(Debug, Args)]
pub struct CycleCommand {
    /// Period of the excitation: a time, or the parameter that determines it, in rad/s, Hz or s.
    /// Default: unknown, of a machine that does not depend on time
    #[arg(long, value_name = "TIME|PARAMETER", value_parser = period)]
    period: Option<Excitation>,
    /// Number of periods of the excitation in a period of the motion
    #[arg(long, value_name = "NUMBER", default_value_t = 1, requires = "period")]
    multiple: usize,
    /// First guess of an unknown period. Default: the latest return of the settled motion
    #[arg(long, value_name = "TIME", value_parser = time, conflicts_with = "period")]
    guess: Option<f64>,
    /// Angles that advance by whole turns in a period, `rotor.phi=1`
    #[arg(long, value_name = "UNIT.ANGLE=TURNS", value_parser = turns, value_delimiter = ',',
        allow_hyphen_values = true)]
    turns: Vec<(String, f64)>,
    /// Time for which the machine runs before the search begins; 0 starts from the initial values.
    /// Default: until the end of the scene's run
    #[arg(long, value_name = "TIME", value_parser = time, conflicts_with = "until")]
    settle: Option<f64>,
    /// Number of segments of the period (multiple shooting), for unstable motions
    #[arg(long, value_name = "NUMBER", default_value_t = 1)]
    segments: usize,
    /// Number of output times of the motion, including both ends
    #[arg(long, value_name = "NUMBER", default_value_t = 401)]
    points: usize,
    /// Follow the motion over a parameter, also where the branch turns back, from the first value
    /// until it leaves the range
    #[arg(long, value_name = "UNIT.PARAMETER=FROM..TO", value_parser = range)]
    over: Option<Range>,
    /// Longest step along the branch, as a share of the range of --over
    #[arg(long, value_name = "SHARE", default_value_t = 0.05, requires = "over")]
    longest_step: f64,
    /// Maximum number of points of the branch
    #[arg(long, value_name = "NUMBER", default_value_t = 1000, requires = "over")]
    max_points: usize,
    /// Follow the branches of twice the period that begin at flips too, and those that begin at
    /// their flips, up to this number of doublings
    #[arg(long, value_name = "NUMBER", default_value_t = 0, requires = "over")]
    doublings: u32,
    /// Run the machine at this number of values of the parameter instead of following a motion, and
    /// report its state once in a period (Poincare section, bifurcation diagram)
    #[arg(long, value_name = "NUMBER", requires_all = ["over", "period"],
        conflicts_with_all = ["longest_step", "max_points", "doublings", "json"])]
    sections: Option<usize>,
    /// Number of periods after the time to settle that --sections reports
    #[arg(long, value_name = "NUMBER", default_value_t = 64, requires = "sections")]
    returns: usize,
    /// Outputs and states to report, write and plot. Default: all outputs
    #[arg(long, help_heading = "Output", value_name = "NAMES", value_delimiter = ',')]
    columns: Vec<String>,
    /// Write the motion over one period, or the branch of --over, to a .csv file; - writes only CSV
    /// to standard output
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: Option<PathBuf>,
    /// Plot the motion, or amplitudes over the parameter of --over, to a .svg or .png file
    #[arg(long, help_heading = "Output", value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Print JSON, in SI units
    #[arg(long, help_heading = "Output")]
    json: bool,
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    run: RunArgs,
}

/// Period of an excitation.
#[derive(Debug, Clone, PartialEq)]
enum Excitation {
    Time(Amount),
    Parameter(String),
}

/// Parses a time or the name of a parameter.
fn period(text: &str) -> Result<Excitation, String> {
    let is_number =
        text.trim_start().starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    if is_number {
        return Amount::parse(text).map(Excitation::Time);
    }
    Ok(Excitation::Parameter(text.trim().to_owned()))
}

/// Parses `angle=turns`.
fn turns(text: &str) -> Result<(String, f64), String> {
    let (name, turns) =
        text.split_once('=').ok_or("write it as ANGLE=TURNS, such as rotor.phi=1")?;
    let turns = turns.trim().parse().map_err(|_| format!("`{turns}` is not a number"))?;
    Ok((name.trim().to_owned(), turns))
}

impl CycleCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        let to_standard_output = is_standard_output(self.out.as_deref())?;
        require_picture(self.plot.as_deref(), "--plot")?;
        let scene = self.scene.load()?;
        let simulator = scene.simulator();
        self.check_columns(simulator)?;
        let flag = interrupt::flag();
        let run = self.run(simulator)?.until_flagged(&flag);
        let settings = self.settings(simulator)?;
        if self.sections.is_some() {
            return self.write_sections(&scene, &run, &settings, to_standard_output);
        }
        if self.over.is_some() {
            return self.follow(&scene, &run, settings, to_standard_output);
        }
        let found = during("searching for a periodic motion", || cycle(&run, &settings))?;
        self.write(&scene, &found, to_standard_output)
    }

    /// Prepares the runs of the search.
    fn run<'s>(&self, simulator: &'s dyn Simulator<f64>) -> Result<Simulation<'s>, Failure> {
        let machine = &self.scene.machine;
        let mut run = machine.simulation(simulator)?;
        if !machine.initial.is_empty() {
            run = run.in_equilibrium(false);
        }
        self.run.apply_bounded(run, RTOL)
    }

    fn settings(&self, simulator: &dyn Simulator<f64>) -> Result<CycleSettings, Failure> {
        let from = self.run.span.start_time(simulator);
        let until = self.run.span.until.unwrap_or(simulator.run_defaults().until);
        if until < from && self.settle.is_none() {
            let message = format!("the run ends at {until} s, which is before its start, {from} s");
            return Err(Failure::input(message, "`--from` and `--until` set both"));
        }
        let period = match &self.period {
            None => Period::Unknown(self.guess),
            Some(Excitation::Parameter(name)) => Period::Parameter(name.clone()),
            Some(Excitation::Time(amount)) => {
                amount.check("--period", "s")?;
                Period::Fixed(amount.value)
            }
        };
        Ok(CycleSettings {
            period,
            multiple: self.multiple,
            turns: self.turns.clone(),
            settle: self.settle.unwrap_or(until - from),
            segments: self.segments,
            points: self.points,
            ..CycleSettings::default()
        })
    }

    fn check_columns(&self, simulator: &dyn Simulator<f64>) -> Result<(), Failure> {
        let shape = simulator.shape();
        let outputs = (0..shape.outputs).map(|index| simulator.output(index).name);
        let known = outputs.chain((0..shape.states()).map(|index| simulator.state(index).name));
        match self.columns.iter().find(|name| !known.clone().any(|known| known == *name)) {
            None => Ok(()),
            Some(name) => {
                let message = format!(
                    "scene `{}` has no output or state `{}`",
                    simulator.name(),
                    name.escape_debug()
                );
                Err(Failure::unknown(message, name, known))
            }
        }
    }

    /// Returns the columns asked for, or all outputs, or all states if there are no outputs.
    fn chosen<'t>(&self, motion: &'t Trajectory) -> Vec<&'t Column> {
        if !self.columns.is_empty() {
            return self.columns.iter().filter_map(|name| motion.find(name)).collect();
        }
        let outputs: Vec<_> = motion.of_kind(ColumnKind::Output).collect();
        if outputs.is_empty() { motion.of_kind(ColumnKind::State).collect() } else { outputs }
    }

    fn write(&self, scene: &Scene, found: &Cycle, to_standard_output: bool) -> Result<(), Failure> {
        let names: Vec<String> =
            self.chosen(&found.motion).iter().map(|column| column.name.clone()).collect();
        if let Some(file) = &self.plot {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            draw_file(file, |path| crate::plot::plot(&found.motion, &names, path))?;
        }
        let mut written = found.motion.clone();
        if !self.columns.is_empty() {
            written.columns.retain(|column| self.columns.contains(&column.name));
        }
        let table = |out: &mut dyn io::Write| written.write_csv(out);
        match &self.out {
            Some(_) if to_standard_output => return print_with(table),
            Some(file) if parquet::is_named(file) => {
                let of = ("cycle", self.scene.scene.as_str(), scene);
                let more = json!({ "period": found.period, "stability": found.stability });
                parquet::write_table(file, &parquet::of_run(&written), of, more)?;
            }
            Some(file) => write_file(file, table)?,
            None => {}
        }
        if self.json {
            let text = serde_json::to_string_pretty(found);
            let text = text.map_err(|error| Failure::unsuccessful(error, ""))?;
            return print(&format!("{text}\n"));
        }
        print(&self.summary(scene, found))
    }

    fn summary(&self, scene: &Scene, found: &Cycle) -> String {
        let simulator = scene.simulator();
        let kind = if found.is_forced { "of the excitation" } else { "solved for" };
        let mut text = format!(
            "{}: {} ({})\nperiod {} s ({kind}), from {} s\n{}, rtol {:e}; {} Newton steps, relative \
             residual {}\n\n",
            simulator.name(),
            simulator.title(),
            scene.how(),
            number(found.period, 10),
            number(found.start, 6),
            found.motion.method,
            found.motion.rtol,
            found.iterations,
            number(found.residual, 2),
        );
        let head = ["column", "mean", "amplitude", "least", "greatest"].map(str::to_owned);
        let mut rows = vec![head];
        for column in self.chosen(&found.motion) {
            let of = Extent::of(&found.motion, column);
            let numbers = [of.mean, of.amplitude(), of.least, of.greatest];
            let [mean, amplitude, least, greatest] = numbers.map(|value| number(value, 7));
            rows.push([
                format!("{} [{}]", column.name, column.unit),
                mean,
                amplitude,
                least,
                greatest,
            ]);
        }
        text.push_str(&columns(&rows, 1));
        text.push_str(&events(&found.motion));
        text.extend(["\n", &describe(found), "\n\n"]);
        text.push_str(&multipliers(simulator, found));
        text.push_str(&notes_told(&found.notes, "--json"));
        for file in [&self.out, &self.plot].into_iter().flatten() {
            text.extend(["\nwrote ", &file.display().to_string()]);
        }
        text.trim_end().to_owned() + "\n"
    }
}

/// Range of a column over a period.
pub(super) struct Extent {
    pub(super) mean: f64,
    pub(super) least: f64,
    pub(super) greatest: f64,
}

impl Extent {
    /// Returns least and greatest value at the output times, and the mean by the trapezoidal rule.
    pub(super) fn of(motion: &Trajectory, column: &Column) -> Self {
        let pairs = motion.times.windows(2).zip(column.values.windows(2));
        let area: f64 = pairs.map(|(t, y)| (t[1] - t[0]) * 0.5 * (y[0] + y[1])).sum();
        let ends = [motion.times.first(), motion.times.last()];
        let span = ends[1].copied().unwrap_or(1.0) - ends[0].copied().unwrap_or(0.0);
        let values = || column.values.iter().copied();
        Self {
            mean: area / span,
            least: values().fold(f64::INFINITY, f64::min),
            greatest: values().fold(f64::NEG_INFINITY, f64::max),
        }
    }

    /// Half of the range.
    pub(super) fn amplitude(&self) -> f64 {
        0.5 * (self.greatest - self.least)
    }
}

/// Returns a line on the events in a period.
fn events(motion: &Trajectory) -> String {
    if motion.switches.is_empty() {
        return String::new();
    }
    format!("\nEvents in a period: {}.\n", counted_events(motion))
}

/// Describes the stability.
fn describe(found: &Cycle) -> String {
    let largest = found.nontrivial().map(|multiplier| multiplier.modulus).fold(0.0, f64::max);
    let size = number(largest, 6);
    match found.stability {
        Stability::Stable => {
            format!("Stable: disturbances decay in a period to {size} at most.")
        }
        Stability::Unstable => {
            let count = found.nontrivial().filter(|multiplier| multiplier.modulus > 1.0).count();
            format!(
                "Unstable: {count} of the multipliers are outside the unit circle, up to {size}."
            )
        }
        Stability::Neutral => {
            "Neutral: a multiplier is on the unit circle to the accuracy of the runs.".to_owned()
        }
    }
}

/// Returns the table of multipliers; complex pairs have one row.
fn multipliers(simulator: &dyn Simulator<f64>, found: &Cycle) -> String {
    let head = ["multiplier", "leaves at", "moves", "modulus"].map(str::to_owned);
    let mut rows = vec![head];
    let once = found.multipliers.iter().filter(|multiplier| multiplier.imaginary >= 0.0);
    for multiplier in once.clone().take(SHOWN) {
        let Multiplier { real, imaginary, modulus, is_trivial, crossing, .. } = multiplier;
        let value = match imaginary {
            0.0 => number(*real, 10),
            _ => format!("{} \u{b1} {} i", number(*real, 10), number(*imaginary, 10)),
        };
        let leaves = if *is_trivial { "phase" } else { crossing.name() };
        let moves = largest(simulator, multiplier);
        rows.push([value, leaves.to_owned(), moves, number(*modulus, 8)]);
    }
    let mut text = columns(&rows, 3);
    let more = once.count().saturating_sub(SHOWN);
    if more > 0 {
        text.extend(["and ", &more.to_string(), " smaller ones; --json has all of them\n"]);
    }
    text
}

/// Names the states that a multiplier's eigenvector changes most, over their scales.
fn largest(simulator: &dyn Simulator<f64>, multiplier: &Multiplier) -> String {
    const NAMED: usize = 2;
    const MINOR: f64 = 0.05;
    let shares = multiplier
        .vector
        .iter()
        .enumerate()
        .map(|(index, [re, im])| (re.hypot(*im) / simulator.state_scale(index), index));
    let mut shares: Vec<(f64, usize)> = shares.filter(|(share, _)| *share > MINOR).collect();
    shares.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let names = shares.iter().take(NAMED).map(|(_, index)| simulator.state(*index).name);
    names.collect::<Vec<_>>().join(", ")
}

impl From<CycleError> for Failure {
    fn from(error: CycleError) -> Self {
        match error {
            CycleError::Simulate(error) => error.into(),
            CycleError::NotFound { .. } | CycleError::OtherMode { .. } => {
                Self::unsuccessful(error, "")
            }
            _ => Self::input(error, ""),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_period_is_a_time_or_a_parameter() {
        let time = Amount { value: 0.5, unit: None };
        assert_eq!(period("0.5"), Ok(Excitation::Time(time)));
        assert_eq!(period("drive.omega"), Ok(Excitation::Parameter("drive.omega".to_owned())));
        assert!(period("5x").is_err());
        assert_eq!(turns("rotor.phi=-1"), Ok(("rotor.phi".to_owned(), -1.0)));
        assert!(turns("rotor.phi").is_err() && turns("rotor.phi=x").is_err());
    }
}
