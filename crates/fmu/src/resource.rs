//! Resources of an archive: a model file and the export settings.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use machinist::simulate::parameter_defaults;
use machinist::{Discretisation, FieldSimulator};
use machinist_contract::Simulator;
use machinist_model::file::{self, FileError, Stamped};
use machinist_model::{Model, ModelSimulator};
use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};
use thiserror::Error;

use crate::variables::{Unfit, Variables};

/// Name of the model file within `resources`, in the format of `machinist compile`.
pub const MODEL: &str = "machine.model";
/// Name of the file beside it that holds an [`Export`].
pub const EXPORT: &str = "machine.export";
/// First bytes of the export file.
const MARK: &[u8; 16] = b"machinist export";

/// Settings of an export.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Export {
    /// Names of the parameters that are inputs.
    pub inputs: Vec<String>,
    /// Number of elements of each field, if not the spec's.
    pub elements: Option<usize>,
    /// Order of the elements, if not the spec's.
    pub order: Option<usize>,
}

impl Export {
    /// Serializes the settings.
    #[must_use]
    pub fn write(&self) -> Vec<u8> {
        file::seal(MARK, self)
    }
}

/// Reason why an archive's resources cannot be run.
#[derive(Debug, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "fmu::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum LoadError {
    /// A file cannot be read.
    #[error("{path}: {error}")]
    Read {
        /// The file.
        path: PathBuf,
        /// Reason for the failure.
        error: io::Error,
    },
    /// A file is invalid.
    #[strum(serialize = "")]
    #[error("{path}: {error}")]
    File {
        /// The file.
        path: PathBuf,
        /// Defect of the file.
        error: FileError,
    },
    /// The resources do not match the description.
    #[error("the instantiation token is `{found}`, but that of the resources is `{expected}`")]
    Token {
        /// Token of the resources.
        expected: String,
        /// Token of the description.
        found: String,
    },
    /// The model cannot be exported like that.
    #[strum(serialize = "")]
    #[error(transparent)]
    Unfit(#[from] Unfit),
}

impl LoadError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::File { error, .. } => error.code(),
            Self::Unfit(error) => error.code(),
            error => error.into(),
        }
    }
}

/// Returns the token that ties a description to its resources: a hash of the bytes of both files.
#[must_use]
pub fn token(model: &[u8], export: &[u8]) -> String {
    let mut hash = Sha256::new();
    hash.update(model);
    hash.update(export);
    let hash = hash.finalize();
    let mut hash = hash.iter().map(|byte| format!("{byte:02x}"));
    let mut hex = |bytes: usize| hash.by_ref().take(bytes).collect::<String>();
    // Descriptions want the form of a GUID.
    let [a, b, c, d, e] = [4, 2, 2, 2, 6].map(&mut hex);
    format!("{{{a}-{b}-{c}-{d}-{e}}}")
}

/// Model ready to be run as an FMU.
pub struct Machine {
    /// Simulator of the model, compiled where the target supports it.
    model: Arc<ModelSimulator>,
    /// Simulator with discretized fields, if there are fields.
    cut: Option<FieldSimulator<'static, f64>>,
    /// Variables of the model.
    pub variables: Variables,
    /// Token of the resources that it was read from.
    pub token: String,
}

impl std::fmt::Debug for Machine {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Machine").field("token", &self.token).finish_non_exhaustive()
    }
}

impl Machine {
    /// Prepares a model with the settings of its export.
    ///
    /// # Errors
    /// [`Unfit`].
    pub fn of(model: Model, export: &Export, token: String) -> Result<Self, Unfit> {
        let has_fields = !model.fields.is_empty();
        let model = Arc::new(ModelSimulator::compiled_at_once(model));
        let wanted = Discretisation { elements: export.elements, order: export.order };
        let cut = if has_fields {
            let cut = FieldSimulator::of_shared(model.clone().shared_with_fields(), wanted)?;
            Some(cut.with_shared_derivatives(model.clone().shared_with_fields_on_duals()))
        } else if wanted == Discretisation::default() {
            None
        } else {
            return Err(Unfit::NoFields { scene: model.model().name.clone() });
        };
        let simulator = cut.as_ref().map_or_else(|| model.single() as _, FieldSimulator::single);
        let variables = Variables::of(model.model(), simulator, &export.inputs)?;
        Ok(Self { model, cut, variables, token })
    }

    /// Returns the simulator to run.
    #[must_use]
    pub fn simulator(&self) -> &dyn Simulator<f64> {
        match &self.cut {
            None => self.model.single(),
            Some(cut) => cut.single(),
        }
    }

    /// Returns the model to run.
    #[must_use]
    pub fn model(&self) -> &Model {
        self.model.model()
    }

    /// Loads the files of a folder and compares their token with the given one.
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
        Ok(Self::of(model, &export, expected)?)
    }

    /// Returns the spec's values of the parameters.
    #[must_use]
    pub fn parameters(&self) -> Vec<f64> {
        parameter_defaults(self.simulator())
    }
}
