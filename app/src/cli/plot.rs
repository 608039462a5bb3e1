//! `machinist plot`: columns of a run or of a table, over time or over another column.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use machinist::Simulation;
use machinist::trajectory::{Column, ColumnKind};

use super::arguments::{MachineArgs, RunArgs};
use super::fit::data::{named, reader};
use super::output::{draw_file, print, require_picture};
use crate::failure::Failure;
use crate::plot::{plot_over, subtitle};
use crate::progress::during;

#[derive(Debug, Args)]
pub struct PlotCommand {
    /// Columns to plot. Default: the outputs of a scene, or all columns of a table
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    columns: Vec<String>,
    /// Column of the horizontal axis. Default: time, or the first column of a table
    #[arg(long, value_name = "NAME")]
    over: Option<String>,
    /// Number of output times, including both ends
    #[arg(long, value_name = "NUMBER")]
    points: Option<usize>,
    /// Write to this .svg or .png file. Default: the name of the scene or table, ending in .svg
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: Option<PathBuf>,
    /// Name of a built-in scene, a scene file, a model file, or a table in a .csv file
    scene: String,
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    run: RunArgs,
}

/// Columns of one length. The first one is the horizontal axis unless another is named.
struct Table {
    title: String,
    subtitle: String,
    columns: Vec<Column>,
}

impl PlotCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        require_picture(self.out.as_deref(), "--out")?;
        let source = Path::new(&self.scene);
        let ends_in = |ending| source.extension().is_some_and(|e| e.eq_ignore_ascii_case(ending));
        if ends_in("parquet") || ends_in("json") {
            let message = format!("{}: tables are read from .csv files", self.scene);
            return Err(Failure::input(message, "`--out FILE.csv` of other commands writes one"));
        }
        let table = if ends_in("csv") { self.read(source)? } else { self.simulate()? };
        let (across, drawn) = self.chosen(&table)?;
        let out = self.out.clone().unwrap_or_else(|| {
            PathBuf::from(format!("{}.svg", source.file_stem().unwrap_or_default().display()))
        });
        let head = |Column { name, unit, .. }: &Column| match unit.as_str() {
            "" => name.clone(),
            _ => format!("{name} [{unit}]"),
        };
        draw_file(&out, |path| {
            let texts = [table.title.as_str(), table.subtitle.as_str()];
            plot_over((head(across), &across.values), &drawn, texts, path)
        })?;
        print(&format!("wrote {}\n", out.display()))
    }

    /// Runs the scene.
    fn simulate(&self) -> Result<Table, Failure> {
        let scene = self.machine.load(&self.scene)?;
        let run = self.run.apply(self.machine.simulation(scene.simulator())?)?;
        let run = self.points.into_iter().fold(run, Simulation::points);
        let trajectory = during("simulating", || run.run())?;
        let time = column("time", "s", trajectory.times.clone());
        Ok(Table {
            subtitle: subtitle(&trajectory),
            title: trajectory.title,
            columns: std::iter::once(time).chain(trajectory.columns).collect(),
        })
    }

    /// Reads the columns of a table that contain only numbers and gaps.
    fn read(&self, path: &Path) -> Result<Table, Failure> {
        let is_run = self.points.is_some()
            || self.run != RunArgs::default()
            || self.machine != MachineArgs::default();
        if is_run {
            let message = format!("{} is a table, so nothing runs", path.display());
            return Err(Failure::input(message, "leave out the options of machines and runs"));
        }
        let text = fs::read_to_string(path).map_err(|error| Failure::file(path, &error))?;
        let unreadable = |error: csv::Error| {
            Failure::input(format!("{}: {error}", path.display()), "all rows have the same cells")
        };
        let mut reader = reader(&text);
        let header = reader.headers().map_err(unreadable)?.clone();
        let mut values: Vec<Option<Vec<f64>>> = vec![Some(Vec::new()); header.len()];
        for record in reader.records() {
            let record = record.map_err(unreadable)?;
            for (values, cell) in values.iter_mut().zip(&record) {
                let number = if cell.is_empty() { Ok(f64::NAN) } else { cell.parse() };
                match number {
                    Ok(number) => values.iter_mut().for_each(|values| values.push(number)),
                    Err(_) => *values = None,
                }
            }
        }
        let columns = header.iter().zip(values).filter_map(|(head, values)| {
            let (name, unit) = named(head);
            Some(column(name, unit.unwrap_or_default(), values?))
        });
        let columns: Vec<Column> = columns.collect();
        if columns.first().is_none_or(|first| first.values.is_empty()) {
            let message = format!("{} has no column of numbers", path.display());
            return Err(Failure::input(message, "the first line has the names of the columns"));
        }
        let title = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        Ok(Table { title, subtitle: String::new(), columns })
    }

    /// Returns the column of the horizontal axis and the columns to plot.
    fn chosen<'t>(&self, table: &'t Table) -> Result<(&'t Column, Vec<&'t Column>), Failure> {
        let columns = &table.columns;
        let find = |name: &String| {
            columns.iter().find(|column| column.name == *name).ok_or_else(|| {
                let known = columns.iter().map(|column| column.name.as_str());
                let message = format!("there is no column of numbers `{}`", name.escape_debug());
                Failure::unknown(message, name, known)
            })
        };
        let across = self.over.as_ref().map_or(Ok(&columns[0]), find)?;
        if !self.columns.is_empty() {
            return Ok((across, self.columns.iter().map(find).collect::<Result<_, _>>()?));
        }
        let of = |kind| {
            let others = columns.iter().skip(1).filter(|column| column.name != across.name);
            others.filter(move |column| column.kind == kind).collect::<Vec<_>>()
        };
        let outputs = of(ColumnKind::Output);
        Ok((across, if outputs.is_empty() { of(ColumnKind::State) } else { outputs }))
    }
}

fn column(name: &str, unit: &str, values: Vec<f64>) -> Column {
    Column {
        name: name.to_owned(),
        unit: unit.to_owned(),
        kind: ColumnKind::Output,
        doc: String::new(),
        values,
    }
}
