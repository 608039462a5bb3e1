//! `machinist spectrum`: amplitudes of a run's outputs over frequency, or over orders of a speed.

use std::io;
use std::path::{Path, PathBuf};

use clap::Args;
use machinist::Simulation;
use machinist::trajectory::{Column, ColumnKind, Trajectory};
use serde::Serialize;

use super::amount::time;
use super::arguments::{RunArgs, SceneArgs};
use super::orders::{OrderArgs, Shared};
use super::output::{
    columns, draw_file, print, print_with, remark_beside, remarks, require_picture, require_table,
    write_file,
};
use super::scene::Scene;
use super::signals::{finite, interval};
use crate::failure::Failure;
use crate::number::number;
use crate::parquet;
use crate::plot::plot_spectrum;
use crate::progress::during;
use crate::spectrum::{Window, amplitudes, peaks};
use serde_json::json;

/// Default number of samples, which gives lines up to 1024 times the resolution.
const SAMPLES: usize = 2048;
const MOST_SAMPLES: usize = 10_000_000;

#[derive(Debug, Args)]
pub struct Spectrum {
    /// Outputs or states. Default: all outputs
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    outputs: Vec<String>,
    /// Time after the start at which the analysed interval begins; it ends with the run. Default: 0
    #[arg(long, value_name = "TIME", value_parser = time, allow_hyphen_values = true)]
    settle: Option<f64>,
    /// Number of samples, equally spaced; the highest frequency is half the sampling rate
    #[arg(long, value_name = "NUMBER", default_value_t = SAMPLES)]
    samples: usize,
    /// Window function
    #[arg(long, value_name = "WINDOW", value_enum, default_value_t = Window::Hann)]
    window: Window,
    /// Number of largest peaks shown for each output
    #[arg(long, help_heading = "Output", value_name = "NUMBER", default_value_t = 5)]
    peaks: usize,
    /// Write all spectral lines to a .csv or .json file; - writes only CSV to standard output
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: Option<PathBuf>,
    /// Plot to a .svg or .png file
    #[arg(long, help_heading = "Output", value_name = "FILE")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    orders: OrderArgs,
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    run: RunArgs,
}

/// Spectra of several columns over the same lines.
#[derive(Debug, Serialize)]
struct Spectra {
    scene: String,
    window: &'static str,
    from: f64,
    until: f64,
    samples: usize,
    /// k/(until - from) \[Hz\].
    frequencies: Vec<f64>,
    outputs: Vec<One>,
    /// Notes of the run.
    notes: Vec<String>,
}

#[derive(Debug, Serialize)]
struct One {
    name: String,
    unit: String,
    /// Mean first, then amplitudes.
    amplitudes: Vec<f64>,
}

impl Spectrum {
    pub fn execute(&self) -> Result<(), Failure> {
        if self.orders.are_asked_for() {
            return self.execute_orders();
        }
        let is_standard_output = self.out.as_deref() == Some(Path::new("-"));
        if let Some(file) = self.out.as_deref().filter(|_| !is_standard_output) {
            require_table(file, &["csv", "json"])?;
        }
        require_picture(self.plot.as_deref(), "--plot")?;
        if !(2..=MOST_SAMPLES).contains(&self.samples) {
            let message = format!("--samples {}: a spectrum has 2 to {MOST_SAMPLES}", self.samples);
            return Err(Failure::input(message, ""));
        }
        let scene = self.scene.load()?;
        let simulation = self.simulation(&scene)?;
        let (from, until) = self.interval(&scene)?;
        let run = during("simulating", || simulation.run())?;
        let chosen = finite(&run, &self.outputs, "a spectrum")?;
        let spectra = Spectra {
            scene: run.scene.clone(),
            window: self.window.name(),
            from,
            until,
            samples: self.samples,
            frequencies: (0..=self.samples / 2).map(|k| k as f64 / (until - from)).collect(),
            outputs: chosen.into_iter().map(|column| self.of(column, &run)).collect(),
            notes: run.notes.clone(),
        };
        if let Some(file) = &self.plot {
            let subtitle = format!("{}, amplitudes, window {}", run.scene, spectra.window);
            let lines: Vec<Column> = spectra.outputs.iter().map(One::column).collect();
            draw_file(file, |path| {
                plot_spectrum(&spectra.frequencies, &lines, [&run.title, &subtitle], path)
            })?;
        }
        match &self.out {
            Some(_) if is_standard_output => {
                remark_beside(&run);
                return print_with(|out| spectra.write_csv(out));
            }
            Some(file) if file.extension().is_some_and(|ending| ending == "json") => {
                write_file(file, |out| Ok(serde_json::to_writer_pretty(out, &spectra)?))?;
            }
            Some(file) if parquet::is_named(file) => {
                let frequencies = spectra.frequencies.clone();
                let mut columns = vec![parquet::Column::numbers("frequency", "Hz", frequencies)];
                columns.extend(spectra.outputs.iter().map(|One { name, unit, amplitudes }| {
                    parquet::Column::numbers(name, unit, amplitudes.clone())
                }));
                let Spectra { window, from, until, samples, .. } = &spectra;
                let more =
                    json!({ "window": window, "from": from, "until": until, "samples": samples });
                parquet::write_table(
                    file,
                    &columns,
                    ("spectrum", &self.scene.scene, &scene),
                    more,
                )?;
            }
            Some(file) => write_file(file, |out| spectra.write_csv(out))?,
            None => {}
        }
        print(&self.summary(&scene, &run, &spectra))
    }

    fn execute_orders(&self) -> Result<(), Failure> {
        require_picture(self.plot.as_deref(), "--plot")?;
        let scene = self.scene.load()?;
        let run = self.run.apply(self.scene.simulation(scene.simulator())?)?;
        let shared = Shared {
            outputs: &|run| {
                Ok(finite(run, &self.outputs, "a spectrum")?.into_iter().cloned().collect())
            },
            interval: self.interval(&scene)?,
            window: self.window,
            out: self.out.as_deref(),
            plot: self.plot.as_deref(),
        };
        self.orders.execute(&scene, &run, &shared)
    }

    fn interval(&self, scene: &Scene) -> Result<(f64, f64), Failure> {
        interval(&self.run.span, self.settle, scene)
    }

    /// Prepares the run with outputs at the samples. The next sample would be at the end of the
    /// interval.
    fn simulation<'s>(&self, scene: &'s Scene) -> Result<Simulation<'s>, Failure> {
        let (from, until) = self.interval(scene)?;
        let time = |n| from + (until - from) * f64::from(n) / self.samples as f64;
        let times: Vec<f64> = (0..self.samples as u32).map(time).collect();
        let run = self.run.apply(self.scene.simulation(scene.simulator())?)?;
        Ok(run.until(until).times(&times))
    }

    fn of(&self, column: &Column, run: &Trajectory) -> One {
        debug_assert_eq!(column.values.len(), run.times.len());
        One {
            name: column.name.clone(),
            unit: column.unit.clone(),
            amplitudes: amplitudes(&column.values, self.window),
        }
    }

    fn summary(&self, scene: &Scene, run: &Trajectory, spectra: &Spectra) -> String {
        let Spectra { from, until, samples, window, .. } = spectra;
        let resolution = 1.0 / (until - from);
        let mut text = format!(
            "{}: {} ({})\n{samples} samples from {from} s to {until} s, window {window}: lines each {} Hz \
             up to {} Hz{}\n\n",
            run.scene,
            run.title,
            scene.how(),
            number(resolution, 6),
            number(resolution * (samples / 2) as f64, 6),
            remarks(run, "--out FILE.json"),
        );
        let mut rows = vec![["", "unit", "mean", "frequency [Hz]", "amplitude"].map(str::to_owned)];
        for One { name, unit, amplitudes } in &spectra.outputs {
            let mut head = [name.clone(), unit.clone(), number(amplitudes[0], 6)];
            for peak in peaks(amplitudes, self.peaks.max(1)) {
                let [name, unit, mean] = std::mem::take(&mut head);
                let place = number(spectra.frequencies[peak], 6);
                rows.push([name, unit, mean, place, number(amplitudes[peak], 6)]);
            }
            if !head[0].is_empty() {
                let [name, unit, mean] = head;
                rows.push([name, unit, mean, String::new(), String::new()]);
            }
        }
        text.push_str(&columns(&rows, 2));
        for file in [&self.out, &self.plot].into_iter().flatten() {
            text.extend(["\nwrote ", &file.display().to_string()]);
        }
        text.trim_end().to_owned() + "\n"
    }
}

impl One {
    /// Returns the amplitudes without the mean, for the plot.
    fn column(&self) -> Column {
        let mut values = self.amplitudes.clone();
        values[0] = f64::NAN;
        Column {
            name: self.name.clone(),
            unit: self.unit.clone(),
            kind: ColumnKind::Output,
            doc: String::new(),
            values,
        }
    }
}

impl Spectra {
    fn write_csv(&self, out: impl io::Write) -> io::Result<()> {
        let outputs = self.outputs.iter();
        let outputs = outputs.map(|one| (format!("{} [{}]", one.name, one.unit), &*one.amplitudes));
        let first = ("frequency [Hz]".to_owned(), &*self.frequencies);
        write_columns(&std::iter::once(first).chain(outputs).collect::<Vec<_>>(), out)
    }
}

/// Writes columns of one length below their heads as CSV.
pub(super) fn write_columns(columns: &[(String, &[f64])], out: impl io::Write) -> io::Result<()> {
    let mut table = csv::Writer::from_writer(out);
    table.write_record(columns.iter().map(|(head, _)| head))?;
    for row in 0..columns.first().map_or(0, |(_, values)| values.len()) {
        table.write_record(columns.iter().map(|(_, values)| format!("{:?}", values[row])))?;
    }
    table.flush()
}
