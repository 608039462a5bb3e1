//! Measured runs, read from CSV.

use std::fs;
use std::path::Path;

use machinist::fit::{Measured, Noise};
use machinist_contract::Simulator;

use crate::cli::amount::conversion;
use crate::failure::{ErrorCode, Failure, did_you_mean};

/// Interpretation of the columns of files.
pub struct Reading<'r> {
    pub simulator: &'r dyn Simulator<f64>,
    /// Renamed columns: column of a file, output or state.
    pub map: &'r [(String, String)],
    /// Outputs to read; all columns if empty.
    pub outputs: &'r [String],
    /// Start of the runs \[s\].
    pub from: f64,
    /// Time after which data are left out \[s\].
    pub until: Option<f64>,
    /// True if unknown columns are skipped instead of refused.
    pub skips_unknown: bool,
}

/// Content of a file, with its number of empty or NaN values.
pub struct File {
    pub measured: Measured,
    /// Standard deviations from columns of their own.
    pub noise: Vec<(String, Noise)>,
    pub gaps: usize,
}

/// Conversion from the unit of a column to that of its output or state.
type Conversion = Box<dyn Fn(f64) -> f64>;

/// Column to read.
struct Wanted {
    convert: Conversion,
    place: usize,
    /// Name of the output or state.
    name: String,
    /// True if the column is a standard deviation.
    is_deviation: bool,
    values: Vec<f64>,
}

impl Reading<'_> {
    /// Reads a file: a header, ascending times in the first column, then a column for each output,
    /// and `sigma(output)` for the standard deviations of its values.
    pub fn read(&self, path: &Path) -> Result<File, Failure> {
        let text = fs::read_to_string(path).map_err(|error| Failure::file(path, &error))?;
        self.read_text(&text).map_err(|Refusal(message, help)| {
            Failure::coded(ErrorCode::InvalidData, format!("{}: {message}", path.display()), help)
        })
    }

    fn read_text(&self, text: &str) -> Result<File, Refusal> {
        let text = text.trim_start_matches(BYTE_ORDER_MARK);
        let mut reader = reader(text);
        let header = reader.headers().map_err(|error| refuse(error.to_string(), ""))?.clone();
        let in_seconds = seconds(&header)?;
        let mut wanted = self.wanted(&header)?;
        let mut times: Vec<f64> = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|error| refuse(error.to_string(), ""))?;
            let line = record.position().map_or(0, |position| line_of(text, position.byte()));
            let time = in_seconds(cell(&record, 0, (line, "time"))?);
            self.check_time(time, times.last().copied(), line)?;
            if self.until.is_some_and(|until| time > until) {
                break;
            }
            times.push(time);
            for column in &mut wanted {
                let value = cell(&record, column.place, (line, &column.name))?;
                if value.is_infinite() {
                    let message = format!("line {line}: `{}` is infinite", column.name);
                    return Err(refuse(message, "gaps are empty cells or NaN"));
                }
                column.values.push((column.convert)(value));
            }
        }
        if times.last().is_none_or(|last| *last <= self.from) {
            let until = self.until.map(|until| format!(" until {until} s")).unwrap_or_default();
            let from = self.from;
            let message = format!("there are no data after the start of the run, {from} s{until}");
            return Err(refuse(message, ""));
        }
        let (deviations, columns): (Vec<Wanted>, Vec<Wanted>) =
            wanted.into_iter().partition(|column| column.is_deviation);
        for deviation in &deviations {
            check_deviations(deviation, &columns)?;
        }
        let gaps = columns.iter().flat_map(|column| &column.values).filter(|v| v.is_nan()).count();
        let noise = deviations.into_iter().map(|own| (own.name, Noise::Each(own.values)));
        let columns = columns.into_iter().map(|column| (column.name, column.values)).collect();
        Ok(File { measured: Measured { times, columns }, noise: noise.collect(), gaps })
    }

    /// Returns the columns to read, or an error if any is missing.
    fn wanted(&self, header: &csv::StringRecord) -> Result<Vec<Wanted>, Refusal> {
        let mut wanted: Vec<Wanted> = Vec::new();
        for (place, cell) in header.iter().enumerate().skip(1) {
            let deviation = deviation_of(cell);
            let is_deviation = deviation.is_some();
            let read = self.output_of(deviation.as_deref().unwrap_or(cell))?;
            let Some((name, convert)) = read else { continue };
            let is_same = |other: &Wanted| other.name == name && other.is_deviation == is_deviation;
            if wanted.iter().any(is_same) {
                return Err(refuse(format!("there are two columns `{name}`"), ""));
            }
            wanted.push(Wanted { convert, place, name, is_deviation, values: Vec::new() });
        }
        let has = |name: &str| wanted.iter().any(|other| !other.is_deviation && other.name == name);
        if let Some(missing) = self.outputs.iter().find(|name| !has(name)) {
            let columns: Vec<&str> = header.iter().map(|cell| named(cell).0).collect();
            return Err(refuse(
                format!("there is no column `{}`", missing.escape_debug()),
                did_you_mean(missing, columns.into_iter()),
            ));
        }
        if wanted.iter().all(|column| column.is_deviation) {
            return Err(refuse("there is no column besides time".to_owned(), ""));
        }
        Ok(wanted)
    }

    fn check_time(&self, time: f64, latest: Option<f64>, line: usize) -> Result<(), Refusal> {
        if !time.is_finite() {
            return Err(refuse(format!("line {line}: the time is missing"), ""));
        }
        if let Some(latest) = latest.filter(|latest| time < *latest) {
            let message = format!("line {line}: {time} s is before the {latest} s above it");
            return Err(refuse(message, "times must increase"));
        }
        if time < self.from {
            let message =
                format!("line {line}: {time} s is before the start of the run, {} s", self.from);
            return Err(refuse(message, "`--from` sets another start time"));
        }
        Ok(())
    }

    /// Returns the output or state of a column and its conversion; `None` if the column is not
    /// wanted.
    fn output_of(&self, cell: &str) -> Result<Option<(String, Conversion)>, Refusal> {
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
        // Tables of `machinist run` also contain energies, which are skipped.
        if mapped.is_none() && name.starts_with("energy.") {
            return Ok(None);
        }
        let Some(quantity) = known.iter().find(|quantity| quantity.name == name) else {
            if self.skips_unknown {
                return Ok(None);
            }
            let message = format!(
                "column `{}` is neither an output nor a state of scene `{}`",
                name.escape_debug(),
                simulator.name()
            );
            let hint = did_you_mean(name, known.iter().map(|quantity| quantity.name));
            let help =
                format!("{hint}; `--map COLUMN=OUTPUT` assigns it, `--outputs` selects columns");
            return Err(refuse(message, help));
        };
        let Some(unit) = unit else { return Ok(Some((name.to_owned(), Box::new(|value| value)))) };
        let Some(convert) = conversion(unit, quantity.unit) else {
            let message = format!(
                "column `{column}` is in {}, but `{name}` in {}",
                unit.escape_debug(),
                quantity.unit
            );
            let help = "units of one dimension are converted; leave the unit out of the header if \
                        the numbers are right";
            return Err(refuse(message, help));
        };
        Ok(Some((name.to_owned(), Box::new(convert))))
    }
}

/// Returns the conversion from the unit of the first column, which is time, to seconds.
fn seconds(header: &csv::StringRecord) -> Result<Conversion, Refusal> {
    let (time, unit) = named(header.get(0).unwrap_or_default());
    if !matches!(time.to_ascii_lowercase().as_str(), "t" | "time") {
        let message = format!("the first column is `{}`, not time", time.escape_debug());
        return Err(refuse(message, "a header begins with `time` or `time [s]`"));
    }
    let Some(unit) = unit else { return Ok(Box::new(|time| time)) };
    let Some(convert) = conversion(unit, "s") else {
        let message = format!("time is in {}, which is not a unit of time", unit.escape_debug());
        return Err(refuse(message, "times are in seconds, or in a unit of time such as ms"));
    };
    Ok(Box::new(convert))
}

/// Begins texts of some programs.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// Returns a reader of a table whose cells are separated by commas, semicolons or tabs, and whose
/// comments begin with `#`.
pub fn reader(text: &str) -> csv::Reader<&[u8]> {
    let text = text.trim_start_matches(BYTE_ORDER_MARK);
    let header = text.lines().next().unwrap_or_default();
    let count = |delimiter: &u8| header.bytes().filter(|byte| byte == delimiter).count();
    let delimiter = [b',', b';', b'\t'].into_iter().max_by_key(count);
    csv::ReaderBuilder::new()
        .delimiter(delimiter.unwrap_or(b','))
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_reader(text.as_bytes())
}

/// Error in a file, with a hint.
struct Refusal(String, String);

fn refuse(message: String, help: impl Into<String>) -> Refusal {
    Refusal(message, help.into())
}

/// Returns the line, from 1, of a record that begins at a byte, after comments and empty lines.
fn line_of(text: &str, byte: u64) -> usize {
    let (before, rest) = text.split_at_checked(byte as usize).unwrap_or((text, ""));
    let skipped = rest.split_inclusive('\n').take_while(|line| {
        let line = line.trim();
        line.is_empty() || line.starts_with('#')
    });
    before.matches('\n').count() + skipped.count() + 1
}

/// Returns the number at a place; NaN if it is empty.
fn cell(
    record: &csv::StringRecord,
    place: usize,
    (line, what): (usize, &str),
) -> Result<f64, Refusal> {
    match record.get(place).unwrap_or_default() {
        "" => Ok(f64::NAN),
        cell => cell.parse::<f64>().map_err(|_| {
            let message =
                format!("line {line}: `{}` of {what} is not a number", cell.escape_debug());
            refuse(message, "gaps are empty cells or NaN")
        }),
    }
}

/// Returns an error unless standard deviations belong to a column of the file and are positive
/// where it has a value.
fn check_deviations(deviation: &Wanted, columns: &[Wanted]) -> Result<(), Refusal> {
    let Wanted { name, values, .. } = deviation;
    let Some(column) = columns.iter().find(|column| column.name == *name) else {
        return Err(refuse(format!("`sigma({name})` belongs to no column"), ""));
    };
    let is_bad =
        |(value, sigma): (&f64, &f64)| !value.is_nan() && (sigma.is_nan() || *sigma <= 0.0);
    match column.values.iter().zip(values).position(is_bad) {
        None => Ok(()),
        Some(row) => {
            let message =
                format!("row {}: `sigma({name})` is {}, not above 0", row + 1, values[row]);
            Err(refuse(message, "every value needs a standard deviation, in the same unit"))
        }
    }
}

/// Returns `twist [rad]` for `sigma(twist) [rad]`.
fn deviation_of(cell: &str) -> Option<String> {
    let rest = cell.trim().strip_prefix("sigma(")?;
    let (name, unit) = rest.split_once(')')?;
    Some(format!("{name}{unit}"))
}

/// Returns name and unit of `name [unit]`.
pub fn named(cell: &str) -> (&str, Option<&str>) {
    let cell = cell.trim();
    match cell.strip_suffix(']').and_then(|rest| rest.rsplit_once('[')) {
        Some((name, unit)) => (name.trim(), Some(unit.trim())),
        None => (cell, None),
    }
}

#[cfg(test)]
mod tests {
    use super::{deviation_of, line_of, named};

    #[test]
    fn a_header_may_give_a_unit() {
        assert_eq!(named("time [s]"), ("time", Some("s")));
        assert_eq!(named(" twist "), ("twist", None));
        assert_eq!(named("a.b[N m/rad]"), ("a.b", Some("N m/rad")));
    }

    #[test]
    fn lines_are_counted_whatever_they_end_with() {
        assert_eq!(line_of("a,b\n1,2\n", 4), 2);
        assert_eq!(line_of("a,b\r\n1,2\r\n", 4), 2);
        assert_eq!(line_of("a,b\n# made by\n\n1,2\n", 4), 4);
    }

    #[test]
    fn a_column_may_be_the_standard_deviation_of_another() {
        assert_eq!(deviation_of("sigma(a.b) [rad]").as_deref(), Some("a.b [rad]"));
        assert_eq!(deviation_of("sigma"), None);
    }
}
