//! Files of named matrices: MAT-files of level 5 for MATLAB, Octave and SciPy, and `.npz` archives
//! for NumPy. The same content gives the same bytes.

use std::io;

/// Content of a named entry.
#[derive(Debug, Clone, PartialEq)]
pub enum Entry {
    /// Matrix by rows, with its number of columns.
    Matrix(Vec<Vec<f64>>, usize),
    /// List of texts.
    Names(Vec<String>),
    /// Text.
    Text(String),
}

impl Entry {
    /// Returns a column of numbers.
    pub fn column(numbers: &[f64]) -> Self {
        Self::Matrix(numbers.iter().map(|number| vec![*number]).collect(), 1)
    }

    /// Returns a single number.
    pub fn number(number: f64) -> Self {
        Self::column(&[number])
    }
}

/// Data types and array classes of MAT-files (MAT-File Format, The MathWorks, 2023, tables 1-1 and
/// 1-3).
mod mat {
    pub const INT8: u32 = 1;
    pub const INT32: u32 = 5;
    pub const UINT16: u32 = 4;
    pub const UINT32: u32 = 6;
    pub const DOUBLE: u32 = 9;
    pub const MATRIX: u32 = 14;
    pub const CELL_CLASS: u32 = 1;
    pub const CHAR_CLASS: u32 = 4;
    pub const DOUBLE_CLASS: u32 = 6;
}

/// Returns a MAT-file of level 5, without compression.
///
/// # Errors
/// If an entry has 4 GiB or more.
pub fn mat_file(entries: &[(impl AsRef<str>, Entry)]) -> io::Result<Vec<u8>> {
    let mut file = format!("{:<116}", "MATLAB 5.0 MAT-file, written by machinist").into_bytes();
    // No data of subsystems, version 1.0, little-endian.
    file.extend([0; 8]);
    file.extend(0x0100_u16.to_le_bytes());
    file.extend(b"IM");
    for (name, entry) in entries {
        let name = name.as_ref();
        let array = match entry {
            Entry::Matrix(rows, columns) => doubles(name, rows, *columns)?,
            Entry::Text(text) => text_array(name, text)?,
            Entry::Names(names) => {
                let mut body = head(name, mat::CELL_CLASS, [names.len(), 1])?;
                for name in names {
                    body.extend(text_array("", name)?);
                }
                element(mat::MATRIX, &body)?
            }
        };
        file.extend(array);
    }
    Ok(file)
}

fn doubles(name: &str, rows: &[Vec<f64>], columns: usize) -> io::Result<Vec<u8>> {
    let mut body = head(name, mat::DOUBLE_CLASS, [rows.len(), columns])?;
    let by_columns = (0..columns).flat_map(|column| rows.iter().map(move |row| row[column]));
    let bytes: Vec<u8> = by_columns.flat_map(f64::to_le_bytes).collect();
    body.extend(element(mat::DOUBLE, &bytes)?);
    element(mat::MATRIX, &body)
}

fn text_array(name: &str, text: &str) -> io::Result<Vec<u8>> {
    let units: Vec<u16> = text.encode_utf16().collect();
    let mut body = head(name, mat::CHAR_CLASS, [usize::from(!units.is_empty()), units.len()])?;
    let bytes: Vec<u8> = units.into_iter().flat_map(u16::to_le_bytes).collect();
    body.extend(element(mat::UINT16, &bytes)?);
    element(mat::MATRIX, &body)
}

/// Returns flags, dimensions and name of an array.
fn head(name: &str, class: u32, dimensions: [usize; 2]) -> io::Result<Vec<u8>> {
    let flags: Vec<u8> = [class, 0].into_iter().flat_map(u32::to_le_bytes).collect();
    let mut head = element(mat::UINT32, &flags)?;
    let mut sizes = Vec::new();
    for size in dimensions {
        sizes.extend(i32::try_from(size).map_err(io::Error::other)?.to_le_bytes());
    }
    head.extend(element(mat::INT32, &sizes)?);
    head.extend(element(mat::INT8, name.as_bytes())?);
    Ok(head)
}

/// Returns a data element: type, length, and bytes padded to a multiple of 8.
fn element(kind: u32, bytes: &[u8]) -> io::Result<Vec<u8>> {
    let length = u32::try_from(bytes.len()).map_err(io::Error::other)?;
    let mut element = [kind.to_le_bytes(), length.to_le_bytes()].concat();
    element.extend(bytes);
    element.resize(element.len().next_multiple_of(8), 0);
    Ok(element)
}

/// Returns an `.npz` archive.
///
/// # Errors
/// If an entry has 4 GiB or more.
#[cfg(feature = "derive")]
pub fn npz_file(entries: &[(impl AsRef<str>, Entry)]) -> io::Result<Vec<u8>> {
    let files: Vec<(String, Vec<u8>)> = entries
        .iter()
        .map(|(name, entry)| (format!("{}.npy", name.as_ref()), npy(entry)))
        .collect();
    let files: Vec<(&str, &[u8])> =
        files.iter().map(|(name, bytes)| (name.as_str(), bytes.as_slice())).collect();
    crate::fmu::zip_archive(&files)
}

/// Returns an array in NumPy's format 1.0 (numpy.lib.format).
#[cfg(feature = "derive")]
fn npy(entry: &Entry) -> Vec<u8> {
    let (kind, shape, bytes) = match entry {
        Entry::Matrix(rows, columns) => {
            let bytes = rows.iter().flatten().copied().flat_map(f64::to_le_bytes).collect();
            ("<f8".to_owned(), format!("({}, {columns})", rows.len()), bytes)
        }
        Entry::Names(names) => {
            let (kind, bytes) = characters(names);
            (kind, format!("({},)", names.len()), bytes)
        }
        Entry::Text(text) => {
            let (kind, bytes) = characters(std::slice::from_ref(text));
            (kind, "()".to_owned(), bytes)
        }
    };
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    // Magic, version and length take 10 bytes; the header ends with a newline, at a multiple of 64.
    let whole = (10 + header.len() + 1).next_multiple_of(64);
    header.push_str(&" ".repeat(whole - 10 - header.len() - 1));
    header.push('\n');
    let mut file = b"\x93NUMPY\x01\x00".to_vec();
    file.extend((header.len() as u16).to_le_bytes());
    file.extend(header.into_bytes());
    file.extend::<Vec<u8>>(bytes);
    file
}

/// Returns the type of texts of equal length and their characters in UTF-32.
#[cfg(feature = "derive")]
fn characters(texts: &[String]) -> (String, Vec<u8>) {
    let width = texts.iter().map(|text| text.chars().count()).max().unwrap_or(0).max(1);
    let padded = texts.iter().flat_map(|text| {
        let characters = text.chars().map(u32::from);
        characters.chain(std::iter::repeat(0)).take(width)
    });
    (format!("<U{width}"), padded.flat_map(u32::to_le_bytes).collect())
}
