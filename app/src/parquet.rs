//! Tables as Parquet files, in the layout that the Python package writes and reads.
//!
//! Columns are plain: numbers are `double`, counts `int64`, texts UTF-8; missing values are null.
//! The origin of a table is in the file's metadata, as JSON under `machinist.sweep`,
//! `machinist.run` and so on, and the units of columns are under `machinist.units`.

#[cfg(feature = "derive")]
use std::collections::BTreeSet;
use std::io;
use std::path::Path;

use machinist::Trajectory;
use serde_json::{Map, Value, json};

use crate::cli::output::write_file;
use crate::cli::scene::{Scene, SceneSource};
#[cfg(feature = "derive")]
use crate::deriving::{self, Request};
use crate::failure::{ErrorCode, Failure};
use machinist_model::file::write;
use machinist_model::fingerprint::{of_behaviour, of_bytes};

/// Extension of Parquet files.
pub const ENDING: &str = "parquet";

/// Values of a column.
pub enum Values {
    /// Numbers.
    Numbers(Vec<f64>),
    /// Numbers with missing values.
    Some(Vec<Option<f64>>),
    /// Counts.
    Counts(Vec<i64>),
    /// Texts with missing values.
    Texts(Vec<Option<String>>),
}

/// Column of a table.
pub struct Column {
    pub name: String,
    /// SI unit of numbers.
    pub unit: Option<String>,
    pub values: Values,
}

impl Column {
    /// Returns the head of the column in every CSV table: `twist [rad]`, or the name alone of what
    /// has no unit.
    pub fn head(&self) -> String {
        match &self.unit {
            Some(unit) => format!("{} [{unit}]", self.name),
            None => self.name.clone(),
        }
    }

    /// Creates a column of numbers in a unit.
    pub fn numbers(name: impl Into<String>, unit: &str, values: Vec<f64>) -> Self {
        let (name, unit) = (name.into(), Some(unit.to_owned()));
        Self { name, unit, values: Values::Numbers(values) }
    }
}

impl Values {
    fn len(&self) -> usize {
        match self {
            Self::Numbers(values) => values.len(),
            Self::Some(values) => values.len(),
            Self::Counts(values) => values.len(),
            Self::Texts(values) => values.len(),
        }
    }

    /// Returns a value as text, empty if it is missing.
    fn cell(&self, row: usize) -> String {
        match self {
            Self::Numbers(values) => values[row].to_string(),
            Self::Some(values) => values[row].map_or_else(String::new, |value| value.to_string()),
            Self::Counts(values) => values[row].to_string(),
            Self::Texts(values) => values[row].clone().unwrap_or_default(),
        }
    }
}

/// Writes columns of equal length as a CSV table.
pub fn write_csv(columns: &[Column], out: &mut dyn io::Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(out);
    writer.write_record(columns.iter().map(Column::head))?;
    for row in 0..columns.first().map_or(0, |column| column.values.len()) {
        writer.write_record(columns.iter().map(|column| column.values.cell(row)))?;
    }
    writer.flush()
}

/// Returns whether a file is to be a Parquet file, by its extension.
pub fn is_named(file: &Path) -> bool {
    file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(ENDING))
}

/// Returns an error if the file is a Parquet file and the program cannot write it.
pub fn require(file: &Path) -> Result<(), Failure> {
    if cfg!(feature = "parquet") || !is_named(file) {
        return Ok(());
    }
    Err(unavailable(file))
}

fn unavailable(file: &Path) -> Failure {
    let message = format!("--out {}: this program was built without Parquet", file.display());
    let help = ".csv holds the same; `cargo install --path app` builds a program with Parquet";
    Failure::coded(ErrorCode::NotBuiltIn, message, help)
}

/// Describes the origin of results: the machine and the program.
fn provenance(argument: &str, scene: &Scene) -> Result<Map<String, Value>, Failure> {
    let simulator = scene.simulator();
    let of_model = |argument: &str| -> Result<String, Failure> {
        let stamped = match SceneSource::of(argument)? {
            SceneSource::Model(stamped) => *stamped,
            #[cfg(feature = "derive")]
            SceneSource::Spec(source) => {
                let keep = machinist_codegen::mechanics::reduce::Keep::Needed;
                deriving::stamped(&Request::model(&source, keep))?
            }
            #[cfg(not(feature = "derive"))]
            SceneSource::Spec(source) => return Err(crate::cli::scene::cannot_derive(&source)),
        };
        Ok(of_bytes(&write(&stamped)))
    };
    let fingerprint =
        if scene.is_emitted() { of_behaviour(simulator) } else { of_model(argument)? };
    let mut told = Map::new();
    told.insert("model".to_owned(), simulator.name().into());
    told.insert("fingerprint".to_owned(), fingerprint.into());
    told.insert("machinist".to_owned(), env!("CARGO_PKG_VERSION").into());
    Ok(told)
}

/// Describes the program and system that made the results.
fn made_by() -> Value {
    let system = format!("{} {}", std::env::consts::OS, std::env::consts::ARCH);
    json!({ "program": concat!("machinist ", env!("CARGO_PKG_VERSION")), "system": system })
}

/// Writes a table that a command made of a scene. `more` holds the other settings that determine
/// its numbers.
pub fn write_table(
    file: &Path,
    columns: &[Column],
    (command, argument, scene): (&str, &str, &Scene),
    more: Value,
) -> Result<(), Failure> {
    let of = origin(argument, scene, more)?;
    let key = of_bytes(of.to_string().as_bytes());
    let told = json!({ command: of, "made_by": made_by(), "key": key });
    let bytes = bytes(columns, command, &told)?;
    write_file(file, |out| out.write_all(&bytes))
}

fn origin(argument: &str, scene: &Scene, more: Value) -> Result<Value, Failure> {
    let mut of = provenance(argument, scene)?;
    if let Value::Object(more) = more {
        of.extend(more);
    }
    Ok(Value::Object(of))
}

/// Reads a table that [`write_table`] wrote with the same machine and settings. `is_same` compares
/// the value of a setting in the file with that of the command.
#[cfg(feature = "derive")]
pub fn read_table(
    file: &Path,
    (command, argument, scene): (&str, &str, &Scene),
    more: Value,
    is_same: impl Fn(&str, &Value, &Value) -> bool,
) -> Result<Vec<Column>, Failure> {
    let wrong = |why: String| {
        let message = format!("--resume: {}: {why}", file.display());
        Failure::input(message, "give another --out, or leave out --resume to begin again")
    };
    let (columns, told) = read(file, command).map_err(wrong)?;
    let of = origin(argument, scene, more)?;
    let theirs = told.get(command).and_then(Value::as_object).cloned().unwrap_or_default();
    let Value::Object(ours) = of else { return Ok(columns) };
    let names: BTreeSet<&String> = ours.keys().chain(theirs.keys()).collect();
    let value = |of: &Map<String, Value>, name: &str| of.get(name).cloned().unwrap_or_default();
    let differs = |name: &&&String| !is_same(name, &value(&theirs, name), &value(&ours, name));
    let others: Vec<&str> = names.iter().filter(differs).map(|name| name.as_str()).collect();
    if others.is_empty() {
        return Ok(columns);
    }
    Err(wrong(format!("it has runs of other settings: {}", others.join(", "))))
}

/// Returns the columns of a run, time first. If a state and an output share a name, the state is
/// taken.
pub fn of_run(run: &Trajectory) -> Vec<Column> {
    let mut columns = vec![Column::numbers("time", "s", run.times.clone())];
    for column in &run.columns {
        if columns.iter().all(|other| other.name != column.name) {
            columns.push(Column::numbers(&column.name, &column.unit, column.values.clone()));
        }
    }
    columns
}

/// Encodes columns of equal length as a file with the metadata `told`.
#[cfg(not(feature = "parquet"))]
fn bytes(_columns: &[Column], _name: &str, _told: &Value) -> Result<Vec<u8>, Failure> {
    Err(Failure::coded(ErrorCode::NotBuiltIn, "this program was built without Parquet", ""))
}

/// Reads the columns and the metadata of a file.
#[cfg(all(feature = "derive", not(feature = "parquet")))]
fn read(_file: &Path, _name: &str) -> Result<(Vec<Column>, Value), String> {
    Err("this program was built without Parquet".to_owned())
}

#[cfg(all(feature = "derive", feature = "parquet"))]
mod reading;
#[cfg(all(feature = "derive", feature = "parquet"))]
use reading::read;
#[cfg(feature = "parquet")]
use with_crate::bytes;

#[cfg(feature = "parquet")]
mod with_crate {
    use std::sync::Arc;

    use parquet::basic::{LogicalType, Repetition, Type as Physical};
    use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
    use parquet::errors::ParquetError;
    use parquet::file::metadata::KeyValue;
    use parquet::file::properties::WriterProperties;
    use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
    use parquet::schema::types::Type;
    use serde_json::{Map, Value};

    use super::{Column, Values};
    use crate::failure::Failure;

    /// Encodes columns of equal length as a file with the metadata `told`.
    pub fn bytes(columns: &[Column], name: &str, told: &Value) -> Result<Vec<u8>, Failure> {
        let failed = |error: ParquetError| Failure::unsuccessful(format!("the table: {error}"), "");
        written(columns, name, told).map_err(failed)
    }

    fn written(columns: &[Column], name: &str, told: &Value) -> Result<Vec<u8>, ParquetError> {
        let fields = columns.iter().map(field).collect::<Result<Vec<_>, _>>()?;
        let schema = Type::group_type_builder("schema").with_fields(fields).build()?;
        let units: Map<String, Value> = columns
            .iter()
            .filter_map(|column| Some((column.name.clone(), column.unit.clone()?.into())))
            .collect();
        let metadata = vec![
            KeyValue::new(format!("machinist.{name}"), told.to_string()),
            KeyValue::new("machinist.units".to_owned(), Value::Object(units).to_string()),
        ];
        let properties = WriterProperties::builder()
            .set_created_by(concat!("machinist ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_key_value_metadata(Some(metadata));
        let mut file = Vec::new();
        let properties = Arc::new(properties.build());
        let mut writer = SerializedFileWriter::new(&mut file, Arc::new(schema), properties)?;
        let mut rows = writer.next_row_group()?;
        for column in columns {
            if let Some(mut writer) = rows.next_column()? {
                write(column, &mut writer)?;
                writer.close()?;
            }
        }
        rows.close()?;
        writer.close()?;
        Ok(file)
    }

    fn field(column: &Column) -> Result<Arc<Type>, ParquetError> {
        let (physical, logical) = match &column.values {
            Values::Numbers(_) | Values::Some(_) => (Physical::DOUBLE, None),
            Values::Counts(_) => (Physical::INT64, None),
            Values::Texts(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        };
        let field = Type::primitive_type_builder(&column.name, physical)
            .with_repetition(Repetition::OPTIONAL)
            .with_logical_type(logical)
            .build()?;
        Ok(Arc::new(field))
    }

    fn write(column: &Column, writer: &mut SerializedColumnWriter<'_>) -> Result<(), ParquetError> {
        /// Returns the definition levels, 1 for present and 0 for missing, and the present values.
        fn levels<T, U>(all: &[Option<T>], of: impl Fn(&T) -> U) -> (Vec<i16>, Vec<U>) {
            let levels = all.iter().map(|value| i16::from(value.is_some())).collect();
            (levels, all.iter().flatten().map(of).collect())
        }
        match &column.values {
            Values::Numbers(all) => {
                let levels = vec![1; all.len()];
                writer.typed::<DoubleType>().write_batch(all, Some(&levels), None)?;
            }
            Values::Some(all) => {
                let (levels, all) = levels(all, |value| *value);
                writer.typed::<DoubleType>().write_batch(&all, Some(&levels), None)?;
            }
            Values::Counts(all) => {
                let levels = vec![1; all.len()];
                writer.typed::<Int64Type>().write_batch(all, Some(&levels), None)?;
            }
            Values::Texts(all) => {
                let (levels, all) = levels(all, |text| ByteArray::from(text.as_str()));
                writer.typed::<ByteArrayType>().write_batch(&all, Some(&levels), None)?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_without_parquet_says_how_to_build_it_in() {
        let Failure::Input(told) = unavailable(Path::new("table.parquet")) else {
            panic!("what is asked for makes no sense there");
        };
        assert_eq!(
            told[0].to_string(),
            "--out table.parquet: this program was built without Parquet"
        );
        let help = told[0].help().expect("help").to_string();
        assert!(help.contains("`cargo install --path app`"), "{help}");
    }
}
