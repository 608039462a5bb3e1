//! `machinist cycle --over`: periodic motions over a parameter.

use std::io;
use std::path::Path;

use machinist::Simulation;
use machinist::periodic::{
    Bifurcation, Branch, BranchPoint, BranchSettings, CycleSettings, Stability, branch,
};
use machinist::trajectory::{Column, ColumnKind};
use serde_json::json;

use super::{CycleCommand, Extent};
use crate::cli::output::{columns, draw_file, print, print_with, write_file};
use crate::cli::scene::Scene;
use crate::failure::Failure;
use crate::number::number;
use crate::parquet::{self, Values};
use crate::plot::plot_branch;
use crate::progress::during;

/// Maximum number of columns in the table of bifurcations.
const SHOWN: usize = 4;

/// Branch with the ranges of the columns to report.
struct Ranges<'b> {
    branch: &'b Branch,
    /// Names and units.
    columns: Vec<(String, String)>,
    /// Extents of all columns at each point.
    extents: Vec<Vec<Extent>>,
}

impl CycleCommand {
    /// Follows the motion over a parameter.
    pub(super) fn follow(
        &self,
        scene: &Scene,
        run: &Simulation<'_>,
        cycle: CycleSettings,
        to_standard_output: bool,
    ) -> Result<(), Failure> {
        let Some(over) = &self.over else { return Ok(()) };
        over.check(run)?;
        let settings = BranchSettings {
            cycle,
            parameter: over.name.clone(),
            from: over.from,
            to: over.to,
            longest_step: self.longest_step,
            max_points: self.max_points,
        };
        let found = during("following a periodic motion", || branch(run, &settings))?;
        let ranges = self.ranges(&found);
        if let Some(file) = &self.plot {
            draw_file(file, |path| ranges.plot(scene.simulator().title(), path))?;
        }
        let table = |out: &mut dyn io::Write| ranges.table(out);
        match &self.out {
            Some(_) if to_standard_output => print_with(table)?,
            Some(file) if parquet::is_named(file) => {
                let of = ("cycle", self.scene.scene.as_str(), scene);
                parquet::write_table(file, &ranges.as_columns(), of, json!({ "end": found.end }))?;
            }
            Some(file) => write_file(file, table)?,
            None => {}
        }
        if self.json && !to_standard_output {
            let text = serde_json::to_string_pretty(&found);
            let text = text.map_err(|error| Failure::unsuccessful(error, ""))?;
            print(&format!("{text}\n"))?;
        } else if !to_standard_output {
            print(&self.told(scene, &ranges))?;
        }
        if found.is_complete {
            return Ok(());
        }
        let message = format!("the branch ends early: {}", found.end);
        Err(Failure::unsuccessful(message, "try a shorter `--longest-step`, or more segments"))
    }

    fn ranges<'b>(&self, branch: &'b Branch) -> Ranges<'b> {
        let of = |point: &BranchPoint| -> Vec<Extent> {
            let motion = &point.cycle.motion;
            self.chosen(motion).iter().map(|column| Extent::of(motion, column)).collect()
        };
        let first = branch.points.first().map(|point| self.chosen(&point.cycle.motion));
        let named = |column: &&Column| (column.name.clone(), column.unit.clone());
        Ranges {
            branch,
            columns: first.iter().flatten().map(named).collect(),
            extents: branch.points.iter().map(of).collect(),
        }
    }

    fn told(&self, scene: &Scene, ranges: &Ranges<'_>) -> String {
        let simulator = scene.simulator();
        let Branch { parameter, unit, points, end, .. } = ranges.branch;
        let first = points.first().map(|point| &point.cycle.motion);
        let (method, rtol) = first.map_or(("", 0.0), |run| (run.method.name(), run.rtol));
        let mut text = format!(
            "{}: {} ({})\nperiodic motions over {parameter} [{unit}]; {method}, rtol {rtol:e}\n{} \
             points\n\n",
            simulator.name(),
            simulator.title(),
            scene.how(),
            points.len(),
        );
        let shown = ranges.columns.len().min(SHOWN);
        let mut head = vec![
            String::new(),
            "stability".to_owned(),
            format!("{parameter} [{unit}]"),
            "period [s]".to_owned(),
            "modulus".to_owned(),
        ];
        let amplitudes = ranges.columns[..shown].iter();
        head.extend(amplitudes.map(|(name, unit)| format!("{name} amplitude [{unit}]")));
        let mut rows = vec![head];
        let last = points.len() - 1;
        for (index, (point, extents)) in points.iter().zip(&ranges.extents).enumerate() {
            let kind = match (point.bifurcation, &point.grazed) {
                (Some(kind), None) => kind.name().to_owned(),
                (Some(kind), Some(guard)) => format!("{} {guard}", kind.name()),
                (None, _) if index == 0 => "start".to_owned(),
                (None, _) if index == last => "end".to_owned(),
                (None, _) => continue,
            };
            let stability = ranges.stability(index);
            let numbers = [point.value, point.cycle.period, modulus(point)];
            let mut row = vec![kind, stability];
            row.extend(numbers.map(|value| number(value, 9)));
            row.extend(extents[..shown].iter().map(|extent| number(extent.amplitude(), 6)));
            rows.push(row);
        }
        text.push_str(&columns(&rows, 2));
        text.extend(["\nThe branch ends at ", end, ".\n"]);
        for file in [&self.out, &self.plot].into_iter().flatten() {
            text.extend(["\nwrote ", &file.display().to_string()]);
        }
        text.trim_end().to_owned() + "\n"
    }
}

/// Returns the largest modulus of the multipliers but that of the phase.
fn modulus(point: &BranchPoint) -> f64 {
    point.cycle.nontrivial().map(|multiplier| multiplier.modulus).fold(0.0, f64::max)
}

fn word(stability: Stability) -> &'static str {
    match stability {
        Stability::Stable => "stable",
        Stability::Unstable => "unstable",
        Stability::Neutral => "neutral",
    }
}

impl Ranges<'_> {
    /// Returns the stability of a point, and of both sides at a bifurcation.
    fn stability(&self, index: usize) -> String {
        let points = &self.branch.points;
        if points[index].bifurcation.is_none() {
            return word(points[index].cycle.stability).to_owned();
        }
        let of = |point: &BranchPoint| point.bifurcation.is_none().then_some(point.cycle.stability);
        let before = points[..index].iter().rev().find_map(of);
        let after = points[index..].iter().find_map(of);
        let sides = [before, after].into_iter().flatten().map(word);
        sides.collect::<Vec<_>>().join(" to ")
    }

    /// Draws amplitudes and, if it is solved for, the period.
    fn plot(&self, title: &str, path: &Path) -> Result<(), crate::plot::PlotError> {
        let points = &self.branch.points;
        let places: Vec<f64> = points.iter().map(|point| point.value).collect();
        let mut panels = Vec::new();
        for (at, (name, unit)) in self.columns.iter().enumerate() {
            let values: Vec<f64> = self.extents.iter().map(|all| all[at].amplitude()).collect();
            panels.push(self.split(&format!("{name} amplitude"), unit, &values));
        }
        if points.iter().any(|point| !point.cycle.is_forced) {
            let periods: Vec<f64> = points.iter().map(|point| point.cycle.period).collect();
            panels.push(self.split("period", "s", &periods));
        }
        let first = |index: usize| self.extents[index].first().map_or(f64::NAN, Extent::amplitude);
        let marks = points.iter().enumerate().filter_map(|(index, point)| {
            let kind = point.bifurcation?;
            Some((point.value, first(index), kind.name().to_owned()))
        });
        let Branch { parameter, unit, .. } = self.branch;
        let axis = format!("{parameter} [{unit}]");
        let subtitle = format!("periodic motions over {parameter}");
        plot_branch((axis, &places), &panels, marks.collect(), [title, &subtitle], path)
    }

    /// Splits a curve into its stable and its unstable parts, which meet at bifurcations.
    fn split(&self, name: &str, unit: &str, values: &[f64]) -> Vec<Column> {
        let points = &self.branch.points;
        let part = |is_stable: bool| {
            let value = |(index, value): (usize, &f64)| {
                let is_of_it = |at: usize| {
                    let BranchPoint { bifurcation, cycle, .. } = &points[at];
                    bifurcation.is_none() && (cycle.stability == Stability::Stable) == is_stable
                };
                let beside =
                    [index.checked_sub(1), (index + 1 < points.len()).then_some(index + 1)];
                let is_shared = points[index].bifurcation.is_some()
                    && beside.into_iter().flatten().any(is_of_it);
                if is_of_it(index) || is_shared { *value } else { f64::NAN }
            };
            values.iter().enumerate().map(value).collect::<Vec<_>>()
        };
        let column = |name: String, values: Vec<f64>| Column {
            name,
            unit: unit.to_owned(),
            kind: ColumnKind::Output,
            doc: String::new(),
            values,
        };
        let parts = [(name.to_owned(), part(true)), (format!("{name}, unstable"), part(false))];
        let is_drawn = |(_, values): &(String, Vec<f64>)| values.iter().any(|x| x.is_finite());
        parts.into_iter().filter(is_drawn).map(|(name, values)| column(name, values)).collect()
    }

    /// Returns the columns of the table.
    fn as_columns(&self) -> Vec<parquet::Column> {
        let Branch { parameter, unit, points, .. } = self.branch;
        let numbers = |of: &dyn Fn(&BranchPoint) -> f64| points.iter().map(of).collect();
        let mut all = vec![
            parquet::Column::numbers(parameter, unit, numbers(&|point| point.value)),
            parquet::Column::numbers("period", "s", numbers(&|point| point.cycle.period)),
            parquet::Column::numbers("modulus", "1", numbers(&modulus)),
        ];
        for (at, (name, unit)) in self.columns.iter().enumerate() {
            type Part = fn(&Extent) -> f64;
            let parts: [(&str, Part); 3] = [
                ("mean", |extent| extent.mean),
                ("least", |extent| extent.least),
                ("greatest", |extent| extent.greatest),
            ];
            for (part, of) in parts {
                let values = self.extents.iter().map(|extents| of(&extents[at])).collect();
                all.push(parquet::Column::numbers(format!("{name}.{part}"), unit, values));
            }
        }
        let texts = |name: &str, of: &dyn Fn(&BranchPoint) -> Option<String>| parquet::Column {
            name: name.to_owned(),
            unit: None,
            values: Values::Texts(points.iter().map(of).collect()),
        };
        let stability = |point: &BranchPoint| Some(word(point.cycle.stability).to_owned());
        all.push(texts("stability", &stability));
        let kind =
            |point: &BranchPoint| point.bifurcation.map(Bifurcation::name).map(str::to_owned);
        all.push(texts("bifurcation", &kind));
        all
    }

    /// Writes parameter, period, largest modulus, ranges, stability and bifurcation of each point.
    fn table(&self, out: &mut dyn io::Write) -> io::Result<()> {
        let all = self.as_columns();
        let mut writer = csv::Writer::from_writer(out);
        writer.write_record(all.iter().map(parquet::Column::head))?;
        let cell = |column: &parquet::Column, row: usize| match &column.values {
            Values::Numbers(values) => values[row].to_string(),
            Values::Texts(values) => values[row].clone().unwrap_or_default(),
            _ => String::new(),
        };
        for row in 0..self.branch.points.len() {
            writer.write_record(all.iter().map(|column| cell(column, row)))?;
        }
        writer.flush()
    }
}
