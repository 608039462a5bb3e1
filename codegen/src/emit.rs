//! Emission of a [`Model`](machinist_model::Model) as text, one folder per target, and of
//! equations as documents.
//!
//! Excluded: reading specs, algebra, and files (see [`crate::write`]). Emission decides names and
//! layout only; the tape determines the operations and their order.

pub mod c99;
pub mod document;
pub mod literal;
pub mod rust;
mod telling;
pub mod text;

use machinist_model::Malformed;

/// Location and origin of emitted Rust.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EmitOptions {
    /// The command that updates the file, for its header.
    pub command: String,
    /// True if the crate of the files has a feature for each scene.
    pub scene_features: bool,
}

impl EmitOptions {
    /// Returns the options for modules of a crate of scenes, as `machinist gen` writes them.
    #[must_use]
    pub fn for_scenes() -> Self {
        Self { command: "cargo run --release -- gen".to_owned(), scene_features: true }
    }

    /// Returns the options for files in the `OUT_DIR` of a crate that depends on
    /// `machinist-contract`.
    #[must_use]
    pub fn for_build_script() -> Self {
        Self { command: "cargo build".to_owned(), scene_features: false }
    }
}

/// Reason why a model cannot be emitted. No spec that has passed its checks leads to such an
/// error; the checks guard against defects of earlier stages.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "emit::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum EmitError {
    /// A literal is infinite or not a number.
    #[error("{place}: {value} is not a finite number, so it cannot be emitted")]
    NotFinite {
        /// The function or quantity that contains the number.
        place: String,
        /// The number.
        value: f64,
    },
    /// A name is not a Rust identifier.
    #[error("`{name}` is not a valid Rust identifier")]
    Identifier {
        /// The name.
        name: String,
    },
    /// Two quantities of one kind share a name.
    #[error("two {kind} are named `{name}`")]
    NamedTwice {
        /// The name.
        name: String,
        /// The kind of both.
        kind: &'static str,
    },
    /// A target has no way to express a part of the model.
    #[error("{message}")]
    Unsupported {
        /// The part that cannot be emitted, and the reason.
        message: String,
    },
    /// The model breaks a rule of models.
    #[strum(serialize = "")]
    #[error("{0}")]
    Malformed(#[from] Malformed),
    /// The emitted tokens are not a Rust module.
    #[error("the emitted module does not parse: {reason}")]
    Unparsable {
        /// The message of the parser.
        reason: String,
    },
}

impl EmitError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Malformed(error) => error.code(),
            error => error.into(),
        }
    }
}
