//! `machinist cycle --over`: periodic motions over a parameter.

use std::path::Path;

use machinist::Simulation;
use machinist::periodic::{
    Bifurcation, Branch, BranchPoint, BranchSettings, CycleSettings, Stability, doublings,
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
        let found =
            during("following a periodic motion", || doublings(run, &settings, self.doublings))?;
        let ranges: Vec<_> = found.iter().map(|branch| self.ranges(branch)).collect();
        if let Some(file) = &self.plot {
            draw_file(file, |path| plot(&ranges, scene.simulator().title(), path))?;
        }
        let columns = || as_columns(&ranges, self.doublings > 0);
        match &self.out {
            Some(_) if to_standard_output => print_with(|out| parquet::write_csv(&columns(), out))?,
            Some(file) if parquet::is_named(file) => {
                let of = ("cycle", self.scene.scene.as_str(), scene);
                let more = json!({ "end": found[0].end });
                parquet::write_table(file, &columns(), of, more)?;
            }
            Some(file) => write_file(file, |out| parquet::write_csv(&columns(), out))?,
            None => {}
        }
        if self.json && !to_standard_output {
            let text = match &found[..] {
                [only] if self.doublings == 0 => serde_json::to_string_pretty(only),
                all => serde_json::to_string_pretty(all),
            };
            let text = text.map_err(|error| Failure::unsuccessful(error, ""))?;
            print(&format!("{text}\n"))?;
        } else if !to_standard_output {
            print(&self.describe(scene, &ranges))?;
        }
        let Some(early) = found.iter().find(|branch| !branch.is_complete) else { return Ok(()) };
        let message = format!("the branch ends early: {}", early.end);
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

    fn describe(&self, scene: &Scene, all: &[Ranges<'_>]) -> String {
        let simulator = scene.simulator();
        let Branch { parameter, unit, points, .. } = all[0].branch;
        let first = points.first().map(|point| &point.cycle.motion);
        let (method, rtol) = first.map_or(("", 0.0), |run| (run.method.name(), run.rtol));
        let mut text = format!(
            "{}: {} ({})\nperiodic motions over {parameter} [{unit}]; {method}, rtol {rtol:e}\n",
            simulator.name(),
            simulator.title(),
            scene.how(),
        );
        for (index, ranges) in all.iter().enumerate() {
            if index > 0 {
                text.push_str("\nTwice the period, from a flip: ");
            }
            text.push_str(&ranges.describe());
        }
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

/// Draws amplitudes of all branches and, if it is solved for, the period.
fn plot(all: &[Ranges<'_>], title: &str, path: &Path) -> Result<(), crate::plot::PlotError> {
    let points = || all.iter().flat_map(|ranges| &ranges.branch.points);
    let places: Vec<f64> = points().map(|point| point.value).collect();
    let is_forced = points().all(|point| point.cycle.is_forced);
    let (mut panels, mut marks): (Vec<Vec<Column>>, Vec<_>) = (Vec::new(), Vec::new());
    let mut before = 0;
    for (index, ranges) in all.iter().enumerate() {
        let after = places.len() - before - ranges.branch.points.len();
        for (at, mut columns) in ranges.panels(is_forced).into_iter().enumerate() {
            for column in &mut columns {
                let gap = |count: usize| vec![f64::NAN; count];
                column.values = [gap(before), column.values.split_off(0), gap(after)].concat();
                if index > 0 {
                    column.name = format!("{}, doubled {index}", column.name);
                }
            }
            if at == panels.len() {
                panels.push(Vec::new());
            }
            panels[at].extend(columns);
        }
        marks.extend(ranges.marks(usize::from(index > 0)));
        before += ranges.branch.points.len();
    }
    let Branch { parameter, unit, .. } = all[0].branch;
    let axis = format!("{parameter} [{unit}]");
    let subtitle = format!("periodic motions over {parameter}");
    plot_branch((axis, &places), &panels, marks, [title, &subtitle], path)
}

impl Ranges<'_> {
    fn describe(&self) -> String {
        let Branch { parameter, unit, points, end, .. } = self.branch;
        let ranges = self;
        let mut text = format!("{} points\n\n", points.len());
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
        text
    }

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

    /// Returns amplitudes and, if it is solved for, the period.
    fn panels(&self, is_forced: bool) -> Vec<Vec<Column>> {
        let mut panels = Vec::new();
        for (at, (name, unit)) in self.columns.iter().enumerate() {
            let values: Vec<f64> = self.extents.iter().map(|all| all[at].amplitude()).collect();
            panels.push(self.split(&format!("{name} amplitude"), unit, &values));
        }
        if !is_forced {
            let points = self.branch.points.iter();
            let periods: Vec<f64> = points.map(|point| point.cycle.period).collect();
            panels.push(self.split("period", "s", &periods));
        }
        panels
    }

    /// Returns parameter, amplitude and name of the bifurcations after some points.
    fn marks(&self, skipped: usize) -> Vec<(f64, f64, String)> {
        let first = |index: usize| self.extents[index].first().map_or(f64::NAN, Extent::amplitude);
        let points = self.branch.points.iter().enumerate().skip(skipped);
        let marks = points.filter_map(|(index, point)| {
            let kind = point.bifurcation?;
            Some((point.value, first(index), kind.name().to_owned()))
        });
        marks.collect()
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
}

/// Returns the columns of the table of all branches, with their numbers if asked for.
fn as_columns(all: &[Ranges<'_>], with_numbers: bool) -> Vec<parquet::Column> {
    let mut tables = all.iter().map(Ranges::as_columns);
    let mut joined = tables.next().unwrap_or_default();
    for table in tables {
        for (column, more) in joined.iter_mut().zip(table) {
            match (&mut column.values, more.values) {
                (Values::Numbers(values), Values::Numbers(more)) => values.extend(more),
                (Values::Texts(values), Values::Texts(more)) => values.extend(more),
                _ => {}
            }
        }
    }
    if with_numbers {
        let of = |(index, ranges): (usize, &Ranges<'_>)| {
            vec![(index + 1) as f64; ranges.branch.points.len()]
        };
        let numbers = all.iter().enumerate().flat_map(of).collect();
        joined.insert(0, parquet::Column::numbers("branch", "1", numbers));
    }
    joined
}
