//! CSV tables that expressions refer to.

use std::path::{Component, Path, PathBuf};

use crate::spec::code::Code;
use crate::spec::diagnostic::{FileId, Mistake, Span, Spanned};
use crate::spec::dimension::Unit;
use crate::spec::measure::Measure;
use crate::spec::names::{self, quoted};
use crate::spec::source::{Sources, folder_of};

/// Maximum number of rows of a table.
const MAX_ROWS: usize = 100_000;
/// Number of rows that a spline needs.
const MIN_ROWS: usize = 2;

/// A CSV file as read. Its first column is sorted.
#[derive(Debug, Clone, PartialEq)]
pub struct CsvTable {
    /// The spec that refers to it.
    pub spec: FileId,
    /// The path as written in that spec.
    pub path: String,
    /// Its columns, the first being the abscissa.
    pub columns: Vec<Column>,
    /// Spans of its rows, below the header.
    pub rows: Vec<Span>,
}

/// A column of a CSV file.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// Its coherent unit of measure.
    pub unit: Unit,
    /// Conversion factor of its numbers.
    factor: f64,
    /// Its numbers in that unit, finite.
    pub values: Vec<f64>,
}

/// Reads all files, once for each spec that refers to them.
pub(super) fn read_all(
    named: &[Spanned<String>],
    sources: &mut Sources,
    mistakes: &mut Vec<Mistake>,
) -> Vec<CsvTable> {
    let mut tables: Vec<CsvTable> = Vec::new();
    for path in named {
        let spec = path.span.file;
        if tables.iter().any(|table| table.spec == spec && table.path == path.value) {
            continue;
        }
        match read(path, sources) {
            Ok((columns, rows)) => {
                tables.push(CsvTable { spec, path: path.value.clone(), columns, rows });
            }
            Err(mistake) => mistakes.push(mistake),
        }
    }
    tables
}

fn read(
    path: &Spanned<String>,
    sources: &mut Sources,
) -> Result<(Vec<Column>, Vec<Span>), Mistake> {
    let found = locate(path, sources)?;
    let file = sources.read(&found).map_err(|error| {
        Mistake::new(Code::InvalidTable, path.span, error.to_string(), "named here")
    })?;
    let text = sources.get(file).text.clone();
    columns(&text, file)
}

/// Finds the file of a relative path, which must stay below the folder of its spec.
fn locate(path: &Spanned<String>, sources: &Sources) -> Result<PathBuf, Mistake> {
    let refuse = |message: &str| {
        let help = "the path must be relative to the spec and stay below its folder";
        Err(Mistake::new(Code::InvalidTable, path.span, message, "not allowed").help(help))
    };
    let spec = &sources.get(path.span.file).file.path;
    if spec.as_os_str().is_empty() {
        return refuse("a unit that comes with Machinist has no folder to find tables in");
    }
    let foreign = path.value.contains(['\\', '\0']) || path.value.is_empty();
    let plain =
        Path::new(&path.value).components().all(|part| matches!(part, Component::Normal(_)));
    if foreign || !plain {
        return refuse("the path of a table leads out of the spec's folder");
    }
    let folder = folder_of(spec);
    let joined = folder.join(&path.value);
    // A symbolic link may lead anywhere, so the real path decides.
    let (Ok(real), Ok(real_folder)) = (joined.canonicalize(), folder.canonicalize()) else {
        let message = format!("there is no file {}", quoted(&path.value));
        return Err(Mistake::new(Code::InvalidTable, path.span, message, "named here"));
    };
    if !real.starts_with(real_folder) {
        return refuse("the path of a table leads out of the spec's folder");
    }
    Ok(joined)
}

/// Reads the columns with their numbers, and the spans of rows.
fn columns(text: &str, file: FileId) -> Result<(Vec<Column>, Vec<Span>), Mistake> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
    let mut columns: Vec<Column> = Vec::new();
    let mut rows = Vec::new();
    for (row, record) in reader.records().enumerate() {
        let record = record.map_err(|error| csv_mistake(&error, text, file))?;
        let line = Line::of(&record, text, file);
        if row == 0 {
            columns = header(&record, &line)?;
            continue;
        }
        if row > MAX_ROWS {
            return Err(line.mistake(None, format!("a table has at most {MAX_ROWS} rows")));
        }
        rows.push(line.cell(None));
        for (index, (cell, column)) in record.iter().zip(&mut columns).enumerate() {
            column.values.push(number(cell, column.factor).ok_or_else(|| {
                line.mistake(Some(index), "a cell of a table must be a finite number".to_owned())
            })?);
        }
        if let Some([.., before, now]) = columns.first().map(|x| x.values.as_slice())
            && before >= now
        {
            let message = "the first column of a table must increase strictly".to_owned();
            return Err(line.mistake(Some(0), message));
        }
    }
    if columns.first().is_none_or(|x| x.values.len() < MIN_ROWS) {
        let message = format!("a table has at least {MIN_ROWS} rows below its header");
        return Err(Mistake::new(Code::InvalidTable, Span::new(file, 0..0), message, "too short"));
    }
    Ok((columns, rows))
}

/// Reads `time [s]` of each column.
fn header(record: &csv::StringRecord, line: &Line) -> Result<Vec<Column>, Mistake> {
    let mut columns: Vec<Column> = Vec::new();
    for (index, cell) in record.iter().enumerate() {
        let parts = cell.trim().strip_suffix(']').and_then(|cell| cell.split_once('['));
        let Some((name, unit)) = parts else {
            let mistake = line.mistake(Some(index), "a column needs a unit in its name".to_owned());
            return Err(mistake.help("write time [s],load [N m]"));
        };
        let name = Spanned { value: name.trim().to_owned(), span: line.cell(Some(index)) };
        // Names with dots are allowed, as in columns of runs, `motor.omega`.
        for part in name.value.split('.') {
            names::check(&Spanned { value: part.to_owned(), span: name.span })?;
        }
        let Measure { unit, factor } = Measure::parse(unit)
            .map_err(|error| line.mistake(Some(index), error.message).help(error.help))?;
        if columns.iter().any(|column| column.name == name.value) {
            let message = format!("two columns are named {}", quoted(&name.value));
            return Err(line.mistake(Some(index), message));
        }
        let (name, factor) = (name.value, factor.to_f64());
        columns.push(Column { name, unit, factor, values: Vec::new() });
    }
    if columns.len() < 2 {
        return Err(line.mistake(None, "a table has at least two columns".to_owned()));
    }
    Ok(columns)
}

fn number(cell: &str, factor: f64) -> Option<f64> {
    let cell = cell.trim();
    let plain = cell.bytes().all(|b| b.is_ascii_digit() || b"+-.eE".contains(&b));
    let value = cell.parse::<f64>().ok().filter(|_| plain)? * factor;
    value.is_finite().then_some(value)
}

/// Position of a record of a CSV file.
struct Line {
    file: FileId,
    start: usize,
    end: usize,
    cells: Vec<std::ops::Range<usize>>,
}

impl Line {
    fn of(record: &csv::StringRecord, text: &str, file: FileId) -> Line {
        let at = record.position().map_or(0, |position| position.byte() as usize);
        let rest = text.get(at..).unwrap_or_default();
        let start = at + (rest.len() - rest.trim_start_matches(['\r', '\n']).len());
        let rest = text.get(start..).unwrap_or_default();
        let end = start + rest.find('\n').unwrap_or(rest.len());
        let mut cells = Vec::new();
        let mut offset = start;
        for cell in rest[..end - start].split(',') {
            cells.push(offset..offset + cell.trim_end().len());
            offset += cell.len() + 1;
        }
        Line { file, start, end, cells }
    }

    /// Returns the span of a cell, or of the whole line.
    fn cell(&self, index: Option<usize>) -> Span {
        let cell = index.and_then(|index| self.cells.get(index).cloned());
        Span::new(self.file, cell.unwrap_or(self.start..self.end))
    }

    fn mistake(&self, cell: Option<usize>, message: String) -> Mistake {
        Mistake::new(Code::InvalidTable, self.cell(cell), message, "here")
    }
}

fn csv_mistake(error: &csv::Error, text: &str, file: FileId) -> Mistake {
    let at = error.position().map_or(0, |position| position.byte() as usize).min(text.len());
    let message = match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("a row of a table has {len} cells where the header has {expected_len}")
        }
        _ => "this is not a CSV file".to_owned(),
    };
    Mistake::new(Code::InvalidTable, Span::new(file, at..at), message, "here")
}
