//! What an archive holds for the library beside it: a model file, and what of it are inputs.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use machinist_contract::Describe as _;
use machinist_model::ModelSimulator;
use machinist_model::file::{self, FileError, Stamped};
use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};
use thiserror::Error;

use crate::variables::{Unfit, Variables};

/// Name of the model file within `resources`, as `machinist compile` writes it.
pub const MODEL: &str = "machine.model";
/// Name of the file beside it that holds an [`Export`].
pub const EXPORT: &str = "machine.export";
/// The first bytes of that.
const MARK: &[u8; 16] = b"machinist export";

/// How a model is exported.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Export {
    /// Names of parameters that are inputs.
    pub inputs: Vec<String>,
}

impl Export {
    /// Its bytes.
    #[must_use]
    pub fn write(&self) -> Vec<u8> {
        file::seal(MARK, self)
    }
}

/// Why an archive's resources are not run.
#[derive(Debug, Error)]
pub enum LoadError {
    /// A file cannot be read.
    #[error("{path}: {error}")]
    Read {
        /// The file.
        path: PathBuf,
        /// Why not.
        error: io::Error,
    },
    /// A file is not what was written.
    #[error("{path}: {error}")]
    File {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        error: FileError,
    },
    /// The resources are not those of the description.
    #[error("the instantiation token is `{found}`, but that of the resources is `{expected}`")]
    Token {
        /// That of the resources.
        expected: String,
        /// That of the description.
        found: String,
    },
    /// The model cannot be exported like that.
    #[error(transparent)]
    Unfit(#[from] Unfit),
}

/// The token that ties a description to resources: of the bytes of both files.
#[must_use]
pub fn token(model: &[u8], export: &[u8]) -> String {
    let mut hash = Sha256::new();
    hash.update(model);
    hash.update(export);
    let hash = hash.finalize();
    let mut hash = hash.iter().map(|byte| format!("{byte:02x}"));
    let mut hex = |bytes: usize| hash.by_ref().take(bytes).collect::<String>();
    // In the form of a GUID, as descriptions have it.
    let [a, b, c, d, e] = [4, 2, 2, 2, 6].map(&mut hex);
    format!("{{{a}-{b}-{c}-{d}-{e}}}")
}

/// A model ready to be run as an FMU.
#[derive(Debug)]
pub struct Machine {
    /// It, compiled where the target can.
    pub simulator: ModelSimulator,
    /// Its variables.
    pub variables: Variables,
    /// The token of the resources it was read from.
    pub token: String,
}

impl Machine {
    /// Of the files of a folder, which must be those that a token is of.
    ///
    /// # Errors
    /// [`LoadError`].
    pub fn load(folder: &Path, found: &str) -> Result<Self, LoadError> {
        let read = |name: &str| {
            let path = folder.join(name);
            fs::read(&path).map_err(|error| LoadError::Read { path, error })
        };
        let wrong = |name: &str| {
            let path = folder.join(name);
            move |error| LoadError::File { path, error }
        };
        let [model, export] = [read(MODEL)?, read(EXPORT)?];
        let expected = token(&model, &export);
        let Stamped { model, .. } = file::read(&model).map_err(wrong(MODEL))?;
        let export: Export = file::open(MARK, &export).map_err(wrong(EXPORT))?;
        if expected != found.trim() {
            return Err(LoadError::Token { expected, found: found.to_owned() });
        }
        let variables = Variables::of(&model, &export.inputs)?;
        Ok(Self { simulator: ModelSimulator::new(model), variables, token: expected })
    }

    /// Values of parameters as the spec has them.
    #[must_use]
    pub fn parameters(&self) -> Vec<f64> {
        let count = self.simulator.shape().parameters;
        (0..count).map(|index| self.simulator.parameter_default(index)).collect()
    }
}
