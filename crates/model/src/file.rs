//! Model files.
//!
//! ```text
//! bytes  0..16   "machinist model\n"
//!       16..20   version of the format, little endian
//!       20..28   length of the content, likewise
//!       28..60   SHA-256 of the content
//!       60..     content: generator, then the model, as postcard writes them
//! ```
//!
//! The same model gives the same bytes on every machine. Models of the previous version are
//! converted. A file is checked when it is read: one that is cut off, altered or of any other
//! version is refused with the reason, and so is a model that breaks a rule of models.

mod previous;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};
use thiserror::Error;

use crate::{Malformed, Model};

/// Version of the format, increased whenever the meaning of a model's bytes changes.
pub const VERSION: u32 = 10;

/// The first bytes of every file.
pub const MARK: &[u8; 16] = b"machinist model\n";

const HEADER: usize = 60;

/// A model with its generator.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Stamped {
    /// Name and version of the generator, and the extent of the scene that it kept.
    pub generator: String,
    /// The model.
    pub model: Model,
}

/// Reason why bytes are not a model.
#[derive(Debug, Clone, PartialEq, Eq, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "model::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum FileError {
    /// The bytes do not begin with the mark of models.
    #[error("this is not a model of Machinist")]
    Foreign,
    /// The bytes have another version of the format.
    #[error(
        "this model has version {found} of the format, but this program reads {VERSION} and {}",
        previous::VERSION
    )]
    Version {
        /// Version in the header.
        found: u32,
    },
    /// The bytes are too few or too many.
    #[error("this model should have {expected} bytes but has {found}: it is cut off or too long")]
    Length {
        /// Length according to the header.
        expected: u64,
        /// Actual length.
        found: u64,
    },
    /// The content does not have the hash in the header.
    #[error("this model has been altered: its content does not have the hash it was written with")]
    Altered,
    /// The hash is right, but the content is not a model.
    #[error("this model cannot be decoded: {reason}")]
    Undecodable {
        /// Message of the decoder.
        reason: String,
    },
    /// The content decodes to a model that breaks a rule.
    #[error("this model is not valid: {0}")]
    Malformed(#[from] Malformed),
}

impl FileError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.into()
    }
}

/// Returns the bytes of a model.
#[must_use]
pub fn write(stamped: &Stamped) -> Vec<u8> {
    seal(MARK, stamped)
}

/// Reads a model from bytes, of this version of the format or the previous one.
///
/// # Errors
/// [`FileError`] if the bytes are not those of [`write()`], of this program or of one that wrote
/// the previous version.
pub fn read(bytes: &[u8]) -> Result<Stamped, FileError> {
    let stamped: Stamped = match open(MARK, bytes) {
        Err(FileError::Version { found: previous::VERSION }) => {
            open_version::<previous::Stamped>(MARK, bytes, previous::VERSION)?.into()
        }
        read => read?,
    };
    stamped.model.validate()?;
    Ok(stamped)
}

/// Returns the bytes of plain data behind a header with the given mark.
///
/// # Panics
/// Never: plain data can always be written to memory.
#[must_use]
pub fn seal(mark: &[u8; 16], data: &impl Serialize) -> Vec<u8> {
    let content = postcard::to_stdvec(data).expect("plain data can be written to memory");
    let mut bytes = Vec::with_capacity(HEADER + content.len());
    bytes.extend_from_slice(mark);
    bytes.extend_from_slice(&VERSION.to_le_bytes());
    bytes.extend_from_slice(&(content.len() as u64).to_le_bytes());
    bytes.extend_from_slice(&Sha256::digest(&content));
    bytes.extend_from_slice(&content);
    bytes
}

/// Reads the data from bytes that [`seal`] returned.
///
/// # Errors
/// [`FileError`] if the bytes are not those of [`seal`] with the same mark.
pub fn open<T: DeserializeOwned>(mark: &[u8; 16], bytes: &[u8]) -> Result<T, FileError> {
    open_version(mark, bytes, VERSION)
}

/// Reads the data of a version of the format.
fn open_version<T: DeserializeOwned>(
    mark: &[u8; 16],
    bytes: &[u8],
    version: u32,
) -> Result<T, FileError> {
    let rest = bytes.strip_prefix(mark).ok_or(FileError::Foreign)?;
    let cut_off = || FileError::Length { expected: HEADER as u64, found: bytes.len() as u64 };
    let (stored, rest) = rest.split_first_chunk().ok_or_else(cut_off)?;
    let found = u32::from_le_bytes(*stored);
    if found != version {
        return Err(FileError::Version { found });
    }
    let (length, rest) = rest.split_first_chunk().ok_or_else(cut_off)?;
    let length = u64::from_le_bytes(*length);
    let (hash, content) = rest.split_first_chunk::<32>().ok_or_else(cut_off)?;
    if length != content.len() as u64 {
        let expected = length.saturating_add(HEADER as u64);
        return Err(FileError::Length { expected, found: bytes.len() as u64 });
    }
    if Sha256::digest(content).as_slice() != hash {
        return Err(FileError::Altered);
    }
    let undecodable = |reason: String| FileError::Undecodable { reason };
    let (data, left) =
        postcard::take_from_bytes(content).map_err(|error| undecodable(error.to_string()))?;
    if left.is_empty() {
        Ok(data)
    } else {
        Err(undecodable(format!("{} bytes are left over", left.len())))
    }
}

/// Returns whether bytes begin with the mark of models.
#[must_use]
pub fn is_model(bytes: &[u8]) -> bool {
    bytes.starts_with(MARK)
}
