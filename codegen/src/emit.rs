//! From a [`Model`](machinist_model::Model) to text, one folder a target; from equations to documents.
//!
//! Excluded: reading specs, algebra, and files (see [`crate::write`]). Emission
//! decides names and layout only; what is computed, and in which order, is the
//! tape's.

pub mod c99;
pub mod document;
pub mod literal;
pub mod rust;
mod telling;
pub mod text;

use machinist_model::Malformed;

/// Where emitted Rust lives and how it is made again.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EmitOptions {
    /// The command that makes the file again, for its header.
    pub command: String,
    /// Whether the crate that the files are in has a feature for each scene.
    pub scene_features: bool,
}

impl EmitOptions {
    /// For modules of a crate of scenes, as `machinist gen` writes them.
    #[must_use]
    pub fn for_scenes() -> Self {
        Self { command: "cargo run --release -- gen".to_owned(), scene_features: true }
    }

    /// For files in the `OUT_DIR` of a crate that depends on `machinist-contract`.
    #[must_use]
    pub fn for_build_script() -> Self {
        Self { command: "cargo build".to_owned(), scene_features: false }
    }
}

/// What makes a model impossible to emit. None of these comes from a spec that
/// has passed its checks; they keep a mistake of an earlier stage out of the text.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EmitError {
    /// A literal is infinite or not a number.
    #[error("{place}: {value} is not a finite number, so it cannot be emitted")]
    NotFinite {
        /// The function or quantity the number stands in.
        place: String,
        /// The number.
        value: f64,
    },
    /// A name is no Rust identifier.
    #[error("the name `{name}` is no Rust identifier")]
    Identifier {
        /// The name.
        name: String,
    },
    /// Two quantities of one kind share a name.
    #[error("the name `{name}` is given to two {kind}")]
    NamedTwice {
        /// The name.
        name: String,
        /// What both are.
        kind: &'static str,
    },
    /// A target has no way to express a part of the model.
    #[error("{message}")]
    Unsupported {
        /// The part that cannot be emitted, and the reason.
        message: String,
    },
    /// The model breaks a rule of models.
    #[error("{0}")]
    Malformed(#[from] Malformed),
    /// The emitted tokens are no Rust module.
    #[error("the emitted module does not parse: {reason}")]
    Unparsable {
        /// What the parser says.
        reason: String,
    },
}
