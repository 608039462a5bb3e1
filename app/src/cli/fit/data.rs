//! Measured runs, read from CSV.

use std::fs;
use std::path::Path;

use machinist::fit::Measured;
use machinist_contract::Simulator;

use crate::failure::{Failure, did_you_mean};

/// How columns of files are told apart.
pub struct Reading<'r> {
    pub simulator: &'r dyn Simulator<f64>,
    /// Other names: column of a file, output or state.
    pub map: &'r [(String, String)],
    /// Only these outputs; all columns if empty.
    pub outputs: &'r [String],
    /// Start of the runs \[s\].
    pub from: f64,
    /// Whether columns that are neither are left out instead of refused.
    pub skips_unknown: bool,
}

/// A file, and how many of its places are empty or NaN.
pub struct File {
    pub measured: Measured,
    pub gaps: usize,
}

impl Reading<'_> {
    /// Reads a file: a header, times in its first column, ascending, then a column an output.
    pub fn read(&self, path: &Path) -> Result<File, Failure> {
        let text = fs::read_to_string(path).map_err(|error| Failure::file(path, &error))?;
        let refuse = |message: String, help: &str| {
            Failure::input(format!("{}: {message}", path.display()), help)
        };
        let text = text.trim_start_matches('\u{feff}');
        let header = text.lines().next().unwrap_or_default();
        let delimiter = [b',', b';', b'\t']
            .into_iter()
            .max_by_key(|delimiter| header.bytes().filter(|byte| byte == delimiter).count());
        let mut reader = csv::ReaderBuilder::new()
            .delimiter(delimiter.unwrap_or(b','))
            .trim(csv::Trim::All)
            .comment(Some(b'#'))
            .from_reader(text.as_bytes());
        let header = reader.headers().map_err(|error| refuse(error.to_string(), ""))?.clone();
        let (time, unit) = named(header.get(0).unwrap_or_default());
        if !matches!(time.to_ascii_lowercase().as_str(), "t" | "time") {
            let message = format!("the first column is `{}`, not time", time.escape_debug());
            return Err(refuse(message, "a header begins with `time` or `time [s]`"));
        }
        if unit.is_some_and(|unit| unit != "s") {
            let message = format!("time is in {}, not in s", unit.unwrap_or_default());
            return Err(refuse(message, "times are in seconds"));
        }
        let mut wanted: Vec<(usize, String)> = Vec::new();
        for (place, cell) in header.iter().enumerate().skip(1) {
            if let Some(name) =
                self.output_of(cell).map_err(|(message, help)| refuse(message, &help))?
            {
                if wanted.iter().any(|(_, other)| *other == name) {
                    return Err(refuse(format!("`{name}` stands in two columns"), ""));
                }
                wanted.push((place, name));
            }
        }
        if let Some(missing) =
            self.outputs.iter().find(|name| wanted.iter().all(|(_, other)| other != *name))
        {
            let columns = header.iter().map(|cell| named(cell).0);
            return Err(refuse(
                format!("there is no column `{}`", missing.escape_debug()),
                &did_you_mean(missing, columns.collect::<Vec<_>>().into_iter()),
            ));
        }
        if wanted.is_empty() {
            return Err(refuse("there is no column but time".to_owned(), ""));
        }
        let mut times: Vec<f64> = Vec::new();
        let mut columns: Vec<(String, Vec<f64>)> =
            wanted.iter().map(|(_, name)| (name.clone(), Vec::new())).collect();
        let mut gaps = 0;
        for record in reader.records() {
            let record = record.map_err(|error| refuse(error.to_string(), ""))?;
            let line = record.position().map_or(0, csv::Position::line);
            let cell = |place: usize, what: &str| match record.get(place).unwrap_or_default() {
                "" => Ok(f64::NAN),
                cell => cell.parse::<f64>().map_err(|_| {
                    let message =
                        format!("line {line}: `{}` of {what} is no number", cell.escape_debug());
                    refuse(message, "an empty place is a gap, and so is NaN")
                }),
            };
            let time = cell(0, "time")?;
            let latest = times.last().copied().unwrap_or(f64::NEG_INFINITY);
            if !time.is_finite() {
                return Err(refuse(format!("line {line}: there is no time"), ""));
            }
            if time < latest {
                let message = format!("line {line}: {time} s is before the {latest} s above it");
                return Err(refuse(message, "times must ascend"));
            }
            if time < self.from {
                let message = format!(
                    "line {line}: {time} s is before the start of the run, {} s",
                    self.from
                );
                return Err(refuse(message, "`--from` gives another start"));
            }
            times.push(time);
            for ((place, name), (_, values)) in wanted.iter().zip(&mut columns) {
                let value = cell(*place, name)?;
                if value.is_infinite() {
                    let message = format!("line {line}: `{name}` is infinite");
                    return Err(refuse(message, "an empty place is a gap, and so is NaN"));
                }
                gaps += usize::from(value.is_nan());
                values.push(value);
            }
        }
        if times.last().is_none_or(|last| *last <= self.from) {
            let message =
                format!("nothing is measured after the start of the run, {} s", self.from);
            return Err(refuse(message, ""));
        }
        Ok(File { measured: Measured { times, columns }, gaps })
    }

    /// The output or state that a column is of; nothing if it is not wanted.
    fn output_of(&self, cell: &str) -> Result<Option<String>, (String, String)> {
        let simulator = self.simulator;
        let shape = simulator.shape();
        let outputs = (0..shape.outputs).map(|index| simulator.output(index));
        let states = (0..shape.states()).map(|index| simulator.state(index));
        let known: Vec<_> = outputs.chain(states).collect();
        let (column, unit) = named(cell);
        let mapped = self.map.iter().find(|(from, _)| from == column || from == cell);
        let name = mapped.map_or(column, |(_, to)| to.as_str());
        if !self.outputs.is_empty() && !self.outputs.iter().any(|wanted| wanted == name) {
            return Ok(None);
        }
        // What a run of ours writes besides: its energy account.
        if mapped.is_none() && name.starts_with("energy.") {
            return Ok(None);
        }
        let Some(quantity) = known.iter().find(|quantity| quantity.name == name) else {
            if self.skips_unknown {
                return Ok(None);
            }
            let message = format!(
                "column `{}` is no output and no state of scene `{}`",
                name.escape_debug(),
                simulator.name()
            );
            let hint = did_you_mean(name, known.iter().map(|quantity| quantity.name));
            let help = format!(
                "{hint}; `--map COLUMN=OUTPUT` names it, `--outputs` takes only some columns"
            );
            return Err((message, help));
        };
        if let Some(unit) = unit
            && unit != quantity.unit
        {
            let message =
                format!("column `{column}` is in {unit}, but `{name}` in {}", quantity.unit);
            return Err((message, "convert it, or leave the unit out of the header".to_owned()));
        }
        Ok(Some(name.to_owned()))
    }
}

/// Name and unit of `name [unit]`.
fn named(cell: &str) -> (&str, Option<&str>) {
    let cell = cell.trim();
    match cell.strip_suffix(']').and_then(|rest| rest.rsplit_once('[')) {
        Some((name, unit)) => (name.trim(), Some(unit.trim())),
        None => (cell, None),
    }
}

#[cfg(test)]
mod tests {
    use super::named;

    #[test]
    fn a_header_may_give_a_unit() {
        assert_eq!(named("time [s]"), ("time", Some("s")));
        assert_eq!(named(" twist "), ("twist", None));
        assert_eq!(named("a.b[N m/rad]"), ("a.b", Some("N m/rad")));
    }
}
