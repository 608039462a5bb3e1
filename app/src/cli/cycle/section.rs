//! `machinist cycle --sections`: states once in a period at many values of a parameter.

use machinist::periodic::CycleSettings;
use machinist::sweep::VariantRun;
use machinist::trajectory::{Column, ColumnKind};
use machinist::{SimulateError, Simulation};
use machinist_contract::Simulator;
use serde_json::json;

use super::CycleCommand;
use super::branch::table;
use crate::cli::output::{columns, draw_file, print, print_with, write_file};
use crate::cli::range::Range;
use crate::cli::scene::Scene;
use crate::cli::variants::Variants;
use crate::failure::Failure;
use crate::interrupt;
use crate::number::number;
use crate::parquet;
use crate::plot::plot_branch;
use crate::progress::during;

/// Difference after some periods, over the range of a column in the diagram, that counts as a
/// return.
const SAME: f64 = 1e-6;

/// Column of the sections: its place among outputs and then states, name and unit.
struct Watched {
    place: usize,
    name: String,
    unit: String,
}

/// Values of all columns in the periods after the time to settle, or the reason why there are none.
type Section = Result<Vec<Vec<f64>>, String>;

impl CycleCommand {
    /// Runs the machine at all values of the parameter, and writes, draws and prints its sections.
    pub(super) fn write_sections(
        &self,
        scene: &Scene,
        run: &Simulation<'_>,
        settings: &CycleSettings,
        to_standard_output: bool,
    ) -> Result<(), Failure> {
        let (Some(over), Some(count)) = (&self.over, self.sections) else { return Ok(()) };
        if count < 2 || self.returns < 2 {
            let message = "--sections and --returns must be at least 2";
            return Err(Failure::input(message, ""));
        }
        over.check(run)?;
        let values: Vec<f64> = (0..count).map(|at| over.value(at, count)).collect();
        for value in [over.from, over.to] {
            settings.period_of(&run.clone().parameter(&over.name, value)?)?;
        }
        let watched = self.watched(scene.simulator());
        let sections = during("simulating", || {
            self.sections_at((scene, run), settings, (&over.name, &values), &watched)
        })?;
        let simulator = run.simulator();
        let mut all = (0..simulator.shape().parameters).map(|at| simulator.parameter(at));
        let unit = all.find(|one| one.name == over.name).map_or("", |one| one.unit);
        let written = self.as_table((over, unit), &values, &watched, &sections);
        if let Some(file) = &self.plot {
            let title = scene.simulator().title();
            draw_file(file, |path| draw(&written, title, path))?;
        }
        match &self.out {
            Some(_) if to_standard_output => {
                return print_with(|out| table(&as_columns(&written), out));
            }
            Some(file) if parquet::is_named(file) => {
                let of = ("cycle", self.scene.scene.as_str(), scene);
                parquet::write_table(file, &as_columns(&written), of, json!({}))?;
            }
            Some(file) => write_file(file, |out| table(&as_columns(&written), out))?,
            None => {}
        }
        print(&self.told_sections((scene, over, unit), &values, &sections))
    }

    fn watched(&self, simulator: &dyn Simulator<f64>) -> Vec<Watched> {
        let shape = simulator.shape();
        let (outputs, states) = (shape.outputs, shape.states());
        let of = |place: usize| {
            let (name, unit) = if place < outputs {
                let output = simulator.output(place);
                (output.name, output.unit)
            } else {
                let state = simulator.state(place - outputs);
                (state.name, state.unit)
            };
            Watched { place, name: name.to_owned(), unit: unit.to_owned() }
        };
        let all = (0..outputs + states).map(of);
        if self.columns.is_empty() {
            return all.take(if outputs > 0 { outputs } else { states }).collect();
        }
        all.filter(|one| self.columns.contains(&one.name)).collect()
    }

    fn sections_at(
        &self,
        (scene, run): (&Scene, &Simulation<'_>),
        settings: &CycleSettings,
        (name, values): (&str, &[f64]),
        watched: &[Watched],
    ) -> Result<Vec<Section>, Failure> {
        let flag = interrupt::flag();
        let (from, returns) = (run.start_time(), self.returns);
        let settled = |run: &Simulation<'_>| {
            let period = settings.period_of(run).ok().flatten().unwrap_or(f64::NAN);
            let before = (settings.settle / period).ceil();
            (before, period)
        };
        let of = |value: &f64| Ok(run.clone().parameter(name, *value)?.parameter_values().to_vec());
        let variants = values.iter().map(of).collect::<Result<Vec<_>, Failure>>()?;
        let section = |found: VariantRun| {
            let outputs = found.outputs.first().map_or(0, Vec::len);
            let first = found.times.len() - returns.min(found.times.len());
            let of = |one: &Watched| {
                let at = one.place;
                let (rows, at) =
                    if at < outputs { (&found.outputs, at) } else { (&found.states, at - outputs) };
                rows[first..].iter().map(|row| row[at]).collect()
            };
            watched.iter().map(of).collect()
        };
        let runs = Variants {
            scene: &self.scene,
            run: &self.run,
            points: None,
            threads: None,
            flag: Some(&flag),
        };
        let take = |_: &Simulation<'_>, found: Result<VariantRun, SimulateError>| {
            found.map(section).map_err(|error| error.to_string())
        };
        runs.runs_of(
            scene,
            &variants,
            |run| {
                let (before, period) = settled(&run);
                let periods = before + (returns - 1) as f64;
                run.from(from).until(from + periods * period).points(periods as usize + 1)
            },
            take,
        )
    }

    /// Returns parameter, period and columns, one row for each period.
    fn as_table(
        &self,
        (over, unit): (&Range, &str),
        values: &[f64],
        watched: &[Watched],
        sections: &[Section],
    ) -> Vec<Column> {
        let column = |name: &str, unit: &str, values: Vec<f64>| Column {
            name: name.to_owned(),
            unit: unit.to_owned(),
            kind: ColumnKind::Measured,
            doc: String::new(),
            values,
        };
        let found = || values.iter().zip(sections).filter(|(_, section)| section.is_ok());
        let places = found().flat_map(|(value, _)| vec![*value; self.returns]).collect();
        let periods = found().flat_map(|_| (0..self.returns).map(|at| at as f64)).collect();
        let mut all = vec![column(&over.name, unit, places), column("return", "1", periods)];
        for (at, one) in watched.iter().enumerate() {
            let of = |(_, section): (&f64, &Section)| {
                section.as_ref().map_or_else(|_| Vec::new(), |columns| columns[at].clone())
            };
            all.push(column(&one.name, &one.unit, found().flat_map(of).collect()));
        }
        all
    }

    fn told_sections(
        &self,
        (scene, over, unit): (&Scene, &Range, &str),
        values: &[f64],
        sections: &[Section],
    ) -> String {
        let simulator = scene.simulator();
        let mut text = format!(
            "{}: {} ({})\nstates once in a period over {} [{unit}], {} values of {} periods\n\n",
            simulator.name(),
            simulator.title(),
            scene.how(),
            over.name,
            values.len(),
            self.returns,
        );
        let ranges = ranges(sections);
        let repeats: Vec<String> = sections
            .iter()
            .map(|section| match section {
                Err(reason) => reason.clone(),
                Ok(section) => repeat(section, &ranges)
                    .map_or_else(|| "not".to_owned(), |period| period.to_string()),
            })
            .collect();
        let mut rows = vec![["from", "to", "repeats after"].map(str::to_owned)];
        rows[0][0] = format!("{} from [{unit}]", over.name);
        let numbered: Vec<usize> = (0..values.len()).collect();
        for same in numbered.chunk_by(|a, b| repeats[*a] == repeats[*b]) {
            let [first, last] = [same[0], same[same.len() - 1]];
            let [from, to] = [first, last].map(|at| number(values[at], 6));
            rows.push([from, to, repeats[first].clone()]);
        }
        text.push_str(&columns(&rows, 1));
        for file in [&self.out, &self.plot].into_iter().flatten() {
            text.extend(["\nwrote ", &file.display().to_string()]);
        }
        text.trim_end().to_owned() + "\n"
    }
}

/// Returns the range of each column over all sections.
fn ranges(sections: &[Section]) -> Vec<f64> {
    let found = || sections.iter().flatten();
    let count = found().next().map_or(0, Vec::len);
    let of = |at: usize| {
        let values = found().flat_map(move |section| section[at].iter().copied());
        let (least, greatest) = values
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), value| (a.min(value), b.max(value)));
        greatest - least
    };
    (0..count).map(of).collect()
}

/// Returns the number of periods after which a section repeats, up to half of those reported.
fn repeat(section: &[Vec<f64>], ranges: &[f64]) -> Option<usize> {
    let returns = section.first().map_or(0, Vec::len);
    let is_same = |values: &[f64], period: usize, range: f64| {
        let pairs = values.iter().zip(&values[period..]);
        pairs.into_iter().all(|(a, b)| (a - b).abs() <= SAME * range)
    };
    (1..=returns / 2).find(|period| {
        section.iter().zip(ranges).all(|(values, range)| is_same(values, *period, *range))
    })
}

fn as_columns(table: &[Column]) -> Vec<parquet::Column> {
    let of = |column: &Column| {
        parquet::Column::numbers(&column.name, &column.unit, column.values.clone())
    };
    table.iter().map(of).collect()
}

fn draw(
    table: &[Column],
    title: &str,
    path: &std::path::Path,
) -> Result<(), crate::plot::PlotError> {
    let axis = format!("{} [{}]", table[0].name, table[0].unit);
    let subtitle = format!("states once in a period over {}", table[0].name);
    let panels: Vec<_> = table[2..].iter().map(|column| vec![column.clone()]).collect();
    plot_branch((axis, &table[0].values), &panels, Vec::new(), [title, &subtitle], path)
}
