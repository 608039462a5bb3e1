//! `machinist cycle --sections`: states once in a period at many values of a parameter.

use std::sync::atomic::AtomicBool;

use machinist::periodic::{CycleSettings, Section, repeats};
use machinist::sweep::VariantRun;
use machinist::trajectory::{Column, ColumnKind};
use machinist::{SimulateError, Simulation};
use machinist_contract::Simulator;
use serde_json::json;

use super::CycleCommand;
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

/// Column of the sections: its place among outputs and then states, name and unit.
struct Watched {
    place: usize,
    name: String,
    unit: String,
}

/// Section at a value of the parameter, or the reason why there is none.
type Found = Result<Section, String>;

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
        if count < 2 {
            return Err(Failure::input("--sections must be at least 2", ""));
        }
        over.check(run)?;
        let values: Vec<f64> = (0..count).map(|at| over.value(at, count)).collect();
        for value in [over.from, over.to] {
            let _ = settings.sectioned(run.clone().parameter(&over.name, value)?, self.returns)?;
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
                return print_with(|out| parquet::write_csv(&as_columns(&written), out));
            }
            Some(file) if parquet::is_named(file) => {
                let of = ("cycle", self.scene.scene.as_str(), scene);
                parquet::write_table(file, &as_columns(&written), of, json!({}))?;
            }
            Some(file) => write_file(file, |out| parquet::write_csv(&as_columns(&written), out))?,
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
    ) -> Result<Vec<Found>, Failure> {
        let flag = interrupt::flag();
        let returns = self.returns;
        let of = |value: &f64| Ok(run.clone().parameter(name, *value)?.parameter_values().to_vec());
        let variants = values.iter().map(of).collect::<Result<Vec<_>, Failure>>()?;
        let places: Vec<usize> = watched.iter().map(|one| one.place).collect();
        let runs = self.variants(Some(&flag));
        let take = |_: &Simulation<'_>, found: Result<VariantRun, SimulateError>| {
            found.map(|run| run.last(&places, returns)).map_err(|error| error.to_string())
        };
        runs.runs_of(
            scene,
            &variants,
            // A variant without a period of its own stops as it is.
            |run| settings.sectioned(run.clone(), returns).unwrap_or(run),
            take,
        )
    }

    fn variants<'a>(&'a self, flag: Option<&'a AtomicBool>) -> Variants<'a> {
        Variants { scene: &self.scene, run: &self.run, points: None, threads: None, flag }
    }

    /// Returns parameter, period and columns, one row for each period.
    fn as_table(
        &self,
        (over, unit): (&Range, &str),
        values: &[f64],
        watched: &[Watched],
        sections: &[Found],
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
            let of = |(_, section): (&f64, &Found)| {
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
        sections: &[Found],
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
        // Half of the digits of the runs: what is left of the transients is not told from their errors.
        let rtol = self.variants(None).adjust(Simulation::new(simulator));
        let same = rtol.relative_tolerance().sqrt();
        let found: Vec<_> = sections.iter().map(|section| section.as_ref().ok()).collect();
        let repeats: Vec<String> = sections
            .iter()
            .zip(repeats(&found, same))
            .map(|(section, period)| match (section, period) {
                (Err(reason), _) => reason.clone(),
                (Ok(_), None) => "not".to_owned(),
                (Ok(_), Some(period)) => period.to_string(),
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
