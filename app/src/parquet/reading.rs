//! Tables read from Parquet files that the program wrote.

use std::fs::File;
use std::path::Path;

use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::{ByteArray, DataType};
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use serde_json::Value;

use super::{Column, Values};

/// Reads the columns and the metadata of a file.
///
/// # Errors
/// A reason why it is no such table.
pub fn read(file: &Path, name: &str) -> Result<(Vec<Column>, Value), String> {
    let opened = File::open(file).map_err(|error| error.to_string())?;
    let reader = SerializedFileReader::new(opened).map_err(|error| error.to_string())?;
    let metadata = reader.metadata().file_metadata();
    let key = format!("machinist.{name}");
    let told = metadata.key_value_metadata().into_iter().flatten().find(|pair| pair.key == key);
    let told = told.and_then(|pair| pair.value.as_deref());
    let told = told.ok_or_else(|| format!("it has no runs of `machinist {name}`"))?;
    let told = serde_json::from_str(told).map_err(|error| error.to_string())?;
    let columns = columns(&reader).map_err(|error| error.to_string())?;
    Ok((columns, told))
}

fn columns(reader: &SerializedFileReader<File>) -> Result<Vec<Column>, ParquetError> {
    let schema = reader.metadata().file_metadata().schema_descr();
    let mut columns = Vec::with_capacity(schema.num_columns());
    for index in 0..schema.num_columns() {
        let mut values: Option<Values> = None;
        for group in 0..reader.num_row_groups() {
            let rows = reader.metadata().row_group(group).num_rows().try_into().unwrap_or(0);
            let more = column(reader.get_row_group(group)?.get_column_reader(index)?, rows)?;
            match (&mut values, more) {
                (None, more) => values = Some(more),
                (Some(Values::Some(all)), Values::Some(more)) => all.extend(more),
                (Some(Values::Counts(all)), Values::Counts(more)) => all.extend(more),
                (Some(Values::Texts(all)), Values::Texts(more)) => all.extend(more),
                _ => return Err(ParquetError::General("a column changes its type".to_owned())),
            }
        }
        let name = schema.column(index).name().to_owned();
        columns.push(Column {
            name,
            unit: None,
            values: values.unwrap_or(Values::Some(Vec::new())),
        });
    }
    Ok(columns)
}

fn column(reader: ColumnReader, rows: usize) -> Result<Values, ParquetError> {
    let refused = || ParquetError::General("a column of another type".to_owned());
    match reader {
        ColumnReader::DoubleColumnReader(reader) => Ok(Values::Some(all(reader, rows)?)),
        ColumnReader::Int64ColumnReader(reader) => {
            let counts: Option<Vec<i64>> = all(reader, rows)?.into_iter().collect();
            Ok(Values::Counts(counts.ok_or_else(refused)?))
        }
        ColumnReader::ByteArrayColumnReader(reader) => {
            let text = |bytes: Option<ByteArray>| {
                bytes.map(|bytes| bytes.as_utf8().map(str::to_owned)).transpose()
            };
            let texts = all(reader, rows)?.into_iter().map(text);
            Ok(Values::Texts(texts.collect::<Result<_, _>>()?))
        }
        _ => Err(refused()),
    }
}

/// Returns all values, none where they are missing.
fn all<T: DataType>(
    mut reader: ColumnReaderImpl<T>,
    rows: usize,
) -> Result<Vec<Option<T::T>>, ParquetError> {
    let (mut levels, mut values) = (Vec::with_capacity(rows), Vec::with_capacity(rows));
    while levels.len() < rows {
        let (read, ..) =
            reader.read_records(rows - levels.len(), Some(&mut levels), None, &mut values)?;
        if read == 0 {
            return Err(ParquetError::General("rows are missing".to_owned()));
        }
    }
    let mut values = values.into_iter();
    Ok(levels.into_iter().map(|level| if level > 0 { values.next() } else { None }).collect())
}
