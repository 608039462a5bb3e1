//! Comparison of a run with measured data, other scenes, or other settings.

use std::path::Path;

use clap::Args;
use machinist::Simulation;
use machinist::trajectory::{Column, ColumnKind, Trajectory};
use machinist_contract::Simulator;

use crate::cli::amount::{Amount, assignment};
use crate::cli::fit::data::Reading;
use crate::cli::output::{columns, notes_told};
use crate::cli::scene::{Loading, Scene};
use crate::cli::settings::with_parameters;
use crate::failure::Failure;
use crate::number::number;

#[derive(Debug, Args)]
pub struct Others {
    /// Compare with a CSV file, whose first column is time, or with the run of another scene or
    /// model; repeatable
    #[arg(long, value_name = "CSV|SCENE")]
    compare: Vec<String>,
    /// Compare with a run of the same scene with other parameters; repeatable
    #[arg(long, value_name = "UNIT.PARAMETER=VALUE,..", value_parser = assignments)]
    compare_set: Vec<Settings>,
}

/// Function that runs another scene, or the first one, with these parameters.
type RunOther<'r> = dyn Fn(Option<&Scene>, &[(String, Amount)]) -> Result<Trajectory, Failure> + 'r;

/// Parameters with values and the text they were read from.
#[derive(Debug, Clone)]
pub struct Settings {
    text: String,
    values: Vec<(String, Amount)>,
}

/// Other run before its execution.
pub enum Other {
    /// Measured data: times, and outputs or states at them.
    File {
        label: String,
        times: Vec<f64>,
        columns: Vec<(String, Vec<f64>)>,
    },
    Scene {
        label: String,
        scene: Box<Scene>,
    },
    Settings {
        label: String,
        values: Vec<(String, Amount)>,
    },
}

/// Comparable part of another run: values at the times of the first one, NaN where it has none.
pub struct Beside {
    pub label: String,
    kind: ColumnKind,
    /// Values by the index of the first run's column.
    values: Vec<(usize, Vec<f64>)>,
    /// Notes that the first run does not have.
    notes: Vec<String>,
}

impl Others {
    /// Reads files and loads scenes before the first run.
    pub fn load(&self, simulator: &dyn Simulator<f64>, from: f64) -> Result<Vec<Other>, Failure> {
        let mut others = Vec::new();
        for argument in &self.compare {
            let path = Path::new(argument);
            let name = path.file_name().and_then(|name| name.to_str());
            let label = name.unwrap_or(argument).to_owned();
            others.push(if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("csv")) {
                let (map, outputs, until) = (&[], &[], None);
                let reading = Reading { simulator, map, outputs, from, until, skips_unknown: true };
                let measured = reading.read(path)?.measured;
                Other::File { label, times: measured.times, columns: measured.columns }
            } else {
                Other::Scene { label, scene: Box::new(Scene::load(argument, &Loading::default())?) }
            });
        }
        for Settings { text, values } in &self.compare_set {
            // Errors are found before the first run.
            let _ = with_parameters(Simulation::new(simulator), values)?;
            others.push(Other::Settings { label: text.clone(), values: values.clone() });
        }
        Ok(others)
    }
}

impl Other {
    /// Times \[s\] that the first run has to include.
    pub fn times(&self) -> &[f64] {
        match self {
            Self::File { times, .. } => times,
            Self::Scene { .. } | Self::Settings { .. } => &[],
        }
    }

    /// Runs the other at the times of the first run, with a function that runs scenes or settings.
    pub fn beside(self, first: &Trajectory, run: &RunOther<'_>) -> Result<Beside, Failure> {
        let (label, trajectory) = match self {
            Self::File { label, times, columns } => {
                return of_file(label, &times, &columns, first);
            }
            Self::Scene { label, scene } => (label, run(Some(&scene), &[])?),
            Self::Settings { label, values } => (label, run(None, &values)?),
        };
        let same = |column: &Column| {
            trajectory.find(&column.name).filter(|other| other.unit == column.unit)
        };
        // Any two machines have energies, which are compared only if nothing else is wanted.
        let is_energy = |column: &Column| column.kind == ColumnKind::Energy;
        let all_energies = first.columns.iter().all(is_energy);
        let places = first.columns.iter().enumerate();
        let places = places.filter(|(_, column)| all_energies || !is_energy(column));
        let values =
            places.filter_map(|(place, column)| Some((place, same(column)?.values.clone())));
        let values = values.collect();
        let notes = trajectory.notes.iter().filter(|note| !first.notes.contains(note));
        let notes = notes.cloned().collect();
        Beside { label, kind: ColumnKind::Output, values, notes }.required(first)
    }
}

fn of_file(
    label: String,
    times: &[f64],
    columns: &[(String, Vec<f64>)],
    first: &Trajectory,
) -> Result<Beside, Failure> {
    let values = columns.iter().filter_map(|(name, values)| {
        let place = first.columns.iter().position(|column| column.name == *name)?;
        let mut at_times = vec![f64::NAN; first.times.len()];
        for (time, value) in times.iter().zip(values) {
            let row = first.times.partition_point(|other| other < time);
            if first.times.get(row).is_some_and(|other| other.to_bits() == time.to_bits()) {
                at_times[row] = *value;
            }
        }
        Some((place, at_times))
    });
    let (values, notes) = (values.collect(), Vec::new());
    Beside { label, kind: ColumnKind::Measured, values, notes }.required(first)
}

impl Beside {
    /// Returns an error if there is nothing to compare.
    fn required(self, first: &Trajectory) -> Result<Self, Failure> {
        let is_known = |(_, values): &(usize, Vec<f64>)| values.iter().any(|v| v.is_finite());
        if self.values.iter().any(is_known) {
            return Ok(self);
        }
        let message = format!("{} has nothing to compare with `{}`", self.label, first.scene);
        Err(Failure::input(message, "columns of the same name and unit are compared"))
    }

    /// Returns the values as additional columns of the first run.
    pub fn columns<'c>(&'c self, first: &'c Trajectory) -> impl Iterator<Item = (usize, Column)> {
        self.values.iter().map(|(place, values)| {
            let of = &first.columns[*place];
            let name = format!("{}, {}", of.name, self.label);
            (*place, Column { name, kind: self.kind, values: values.clone(), ..of.clone() })
        })
    }

    /// Formats the largest differences and their times.
    pub fn table(&self, first: &Trajectory) -> String {
        let header = ["", "unit", "largest difference", "at [s]", "of its size"].map(str::to_owned);
        let rows = self.values.iter().filter_map(|(place, values)| {
            let column = &first.columns[*place];
            let (difference, row) = largest_difference(&column.values, values)?;
            let size = column.values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
            let share = match difference {
                0.0 => "0".to_owned(),
                _ if size == 0.0 => String::new(),
                _ => format!("{} %", number(100.0 * difference / size, 3)),
            };
            let cells = [number(difference, 4), number(first.times[row], 6), share];
            let [difference, time, share] = cells;
            Some([column.name.clone(), column.unit.clone(), difference, time, share])
        });
        let rows: Vec<[String; 5]> = std::iter::once(header).chain(rows).collect();
        let notes = notes_told(&self.notes, "`machinist run` of it with --out FILE.json");
        format!("\ncompared with {}{notes}\n{}", self.label, columns(&rows, 2))
    }
}

/// Returns the largest difference of two columns with its row; `None` if they share no values.
fn largest_difference(first: &[f64], other: &[f64]) -> Option<(f64, usize)> {
    let differences = first.iter().zip(other).map(|(a, b)| (a - b).abs()).enumerate();
    let known = differences.filter(|(_, difference)| difference.is_finite());
    known.map(|(row, size)| (size, row)).reduce(|a, b| if b.0 > a.0 { b } else { a })
}

fn assignments(text: &str) -> Result<Settings, String> {
    let values = text.split(',').map(assignment).collect::<Result<_, _>>()?;
    Ok(Settings { text: text.to_owned(), values })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_difference_is_found_where_both_are_known() {
        let (first, other) = ([0.0, 1.0, 5.0, 2.0], [0.5, f64::NAN, 2.0, 9.0]);
        assert_eq!(largest_difference(&first, &other), Some((7.0, 3)));
        assert_eq!(largest_difference(&first, &[f64::NAN; 4]), None);
    }

    #[test]
    fn settings_are_assignments_with_commas_between() {
        let settings = assignments("a.b=1,c.d=2e3").expect("they are");
        let values = crate::cli::amount::in_si(&settings.values);
        assert_eq!(values, [("a.b".to_owned(), 1.0), ("c.d".to_owned(), 2e3)]);
        assert!(assignments("a.b").is_err() && assignments("a.b=1,").is_err());
    }
}
