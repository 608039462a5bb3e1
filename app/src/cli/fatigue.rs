//! `machinist fatigue`: rainflow counting of a run's outputs, and the damage of their cycles.

mod curve;
mod loads;

use std::path::{Path, PathBuf};

use clap::Args;
use machinist::Simulation;
use machinist::fatigue::{Residue, turning_points};
use machinist::trajectory::{Column, Trajectory};
use serde_json::json;

use super::amount::time;
use super::arguments::{RunArgs, SceneArgs};
use super::output::{
    draw_file, print, print_with, remark_beside, require_picture, require_table, write_file,
};
use super::signals::{finite, interval};
use crate::failure::Failure;
use crate::parquet;
use crate::plot::plot_loads;
use crate::progress::during;
use curve::CurveArgs;
use loads::{Loads, Signal};

/// Default number of samples of the first run.
const SAMPLES: usize = 20_000;
const MOST_SAMPLES: usize = 10_000_000;
/// Default share of the largest range up to which ranges do not count.
const GATE: f64 = 1e-3;
/// Change of a turning point by the second run, over the largest range, above which a note asks for
/// more samples.
const COARSE: f64 = 1e-2;

#[derive(Debug, Args)]
pub struct Fatigue {
    /// Outputs or states, such as torques and stresses. Default: all outputs
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    outputs: Vec<String>,
    /// Time after the start at which counting begins; it ends with the run. Default: 0
    #[arg(long, value_name = "TIME", value_parser = time, allow_hyphen_values = true)]
    settle: Option<f64>,
    /// Number of equally spaced samples in which turning points are searched for; a second run finds
    /// them between samples
    #[arg(long, value_name = "NUMBER", default_value_t = SAMPLES)]
    samples: usize,
    /// Share of the largest range of an output up to which ranges do not count
    #[arg(long, value_name = "SHARE", default_value_t = GATE)]
    gate: f64,
    /// The run repeats, as a duty cycle: ranges that stay open are closed by the next repetition.
    /// Default: they count as half cycles
    #[arg(long)]
    repeat: bool,
    /// Number of classes of the range in the table
    #[arg(long, help_heading = "Output", value_name = "NUMBER", default_value_t = 8,
        value_parser = clap::value_parser!(u32).range(1..=1000))]
    classes: u32,
    /// Write all counted cycles to a .csv, .json or .parquet file; - writes only CSV to standard
    /// output
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: Option<PathBuf>,
    /// Plot amplitudes over the number of cycles that reach them to a .svg or .png file
    #[arg(long, help_heading = "Output", value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Print JSON, with all counted cycles
    #[arg(long, help_heading = "Output")]
    json: bool,
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    curve: CurveArgs,
    #[command(flatten)]
    run: RunArgs,
}

impl Fatigue {
    pub fn execute(&self) -> Result<(), Failure> {
        let is_standard_output = self.out.as_deref() == Some(Path::new("-"));
        if let Some(file) = self.out.as_deref().filter(|_| !is_standard_output) {
            require_table(file, &["csv", "json"])?;
        }
        require_picture(self.plot.as_deref(), "--plot")?;
        if !(3..=MOST_SAMPLES).contains(&self.samples) {
            let message = format!("--samples {}: counting needs 3 to {MOST_SAMPLES}", self.samples);
            return Err(Failure::input(message, ""));
        }
        if !(0.0..1.0).contains(&self.gate) {
            let message = format!("--gate {} is not a share from 0 to below 1", self.gate);
            return Err(Failure::input(message, ""));
        }
        self.curve.check()?;
        let scene = self.scene.load()?;
        let (from, until) = interval(&self.run.span, self.settle, &scene)?;
        let prepared = self.run.apply(self.scene.simulation(scene.simulator())?)?.until(until);
        let (run, change) = self.sampled(&prepared, (from, until))?;
        let columns = finite(&run, &self.outputs, "rainflow counting")?;
        self.curve.check_outputs(&columns)?;
        let residue = if self.repeat { Residue::Repeated } else { Residue::Half };
        let signals = columns
            .iter()
            .map(|column| Signal::of(column, &run.times, self.gate, residue, &self.curve));
        let loads = Loads {
            signals: signals.collect::<Result<_, _>>()?,
            interval: (from, run.times.last().copied().unwrap_or(until)),
            is_repeated: self.repeat,
            samples: self.samples,
            gate: self.gate,
            is_coarse: change > COARSE,
            classes: self.classes as usize,
        };
        if let Some(file) = &self.plot {
            let (places, columns) = loads.collectives();
            let subtitle = format!("{}, amplitudes over the cycles that reach them", run.scene);
            draw_file(file, |path| plot_loads(&places, &columns, [&run.title, &subtitle], path))?;
        }
        match &self.out {
            Some(_) if is_standard_output => {
                remark_beside(&run);
                return print_with(|out| loads.write_csv(out));
            }
            Some(file) if file.extension().is_some_and(|ending| ending == "json") => {
                let whole = loads.json(&run);
                write_file(file, |out| Ok(serde_json::to_writer_pretty(out, &whole)?))?;
            }
            Some(file) if parquet::is_named(file) => {
                let of = ("fatigue", self.scene.scene.as_str(), &scene);
                let more = json!({ "from": from, "until": until, "samples": self.samples, "gate": self.gate });
                parquet::write_table(file, &loads.as_columns(), of, more)?;
            }
            Some(file) => write_file(file, |out| loads.write_csv(out))?,
            None => {}
        }
        if self.json {
            let text = serde_json::to_string_pretty(&loads.json(&run));
            let text = text.map_err(|error| Failure::unsuccessful(error, ""))?;
            return print(&(text + "\n"));
        }
        let files = [self.out.as_deref(), self.plot.as_deref()];
        print(&loads.summary(&scene, &run, &files))
    }

    /// Runs at equally spaced samples, and once more with the vertices of the parabolas through each
    /// turning point and its neighbours. Returns the second run and the largest change of a turning
    /// point over the range of its output.
    fn sampled(
        &self,
        prepared: &Simulation<'_>,
        (from, until): (f64, f64),
    ) -> Result<(Trajectory, f64), Failure> {
        let step = (until - from) / self.samples as f64;
        let time = |n: usize| if n == self.samples { until } else { from + step * n as f64 };
        let times: Vec<f64> = (0..=self.samples).map(time).collect();
        let first = prepared.clone().times(&times);
        let first = during("simulating", || first.run())?;
        let chosen = finite(&first, &self.outputs, "rainflow counting")?;
        let vertices = chosen.iter().flat_map(|column| vertices(column, &first.times, self.gate));
        let mut more: Vec<f64> = first.times.iter().copied().chain(vertices).collect();
        more.sort_by(f64::total_cmp);
        more.dedup();
        let second = prepared.clone().times(&more);
        let second = during("simulating again, at the turning points", || second.run())?;
        let again = finite(&second, &self.outputs, "rainflow counting")?;
        let change = chosen.iter().zip(again).map(|(first, second)| {
            let (a, b) = (loads::ends(&first.values), loads::ends(&second.values));
            let range = b.1 - b.0;
            if range > 0.0 { (a.0 - b.0).max(b.1 - a.1) / range } else { 0.0 }
        });
        let change = change.fold(0.0, f64::max);
        drop(chosen);
        Ok((second, change))
    }
}

/// Returns the times of the vertices of parabolas through turning points and their neighbours.
fn vertices(column: &Column, times: &[f64], gate: f64) -> Vec<f64> {
    let values = &column.values;
    let points = turning_points(values, gate * loads::range(values));
    let inner = points.into_iter().filter(|at| *at > 0 && at + 1 < values.len());
    let vertex = |at: usize| {
        let (before, here, after) = (values[at - 1], values[at], values[at + 1]);
        let bend = before - 2.0 * here + after;
        let share = if bend == 0.0 { 0.0 } else { 0.5 * (before - after) / bend };
        let time = times[at] + share.clamp(-0.5, 0.5) * (times[at + 1] - times[at]);
        time.clamp(times[at - 1], times[at + 1])
    };
    inner.map(vertex).collect()
}
