//! From [`Program`] to text, one file a target.
//!
//! Excluded: reading specs, algebra, and files (see [`crate::write`]). Emission
//! decides names and layout only; what is computed, and in which order, is the
//! tape's.

pub mod literal;
pub mod rust;
pub mod text;

use crate::program::Program;
use crate::tape::{NodeId, Tape};

/// Where emitted Rust lives and how it is made again.
#[derive(Clone)]
pub struct EmitOptions {
    /// Path of the contract crate: `crate` or `::machinist_scenes`.
    pub contract: syn::Path,
    /// The command that makes the file again, for its header.
    pub command: String,
    /// Whether the crate that the files are in has a feature for each scene.
    pub scene_features: bool,
}

impl EmitOptions {
    /// For modules within `machinist-scenes` itself.
    #[must_use]
    pub fn within_contract() -> Self {
        Self {
            contract: syn::parse_quote!(crate),
            command: "cargo run --release -- gen".to_owned(),
            scene_features: true,
        }
    }

    /// For files in the `OUT_DIR` of a crate that depends on `machinist-scenes`.
    #[must_use]
    pub fn for_build_script() -> Self {
        Self {
            contract: syn::parse_quote!(::machinist_scenes),
            command: "cargo build".to_owned(),
            scene_features: false,
        }
    }
}

/// What makes a program impossible to emit. None of these comes from a spec that
/// has passed its checks; they keep a mistake of an earlier stage out of the text.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
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
    /// A tape breaks a rule of [`crate::tape`].
    #[error("function `{function}`: {reason}")]
    Malformed {
        /// The emitted function.
        function: &'static str,
        /// The rule broken.
        reason: String,
    },
    /// The emitted tokens are no Rust module.
    #[error("the emitted module does not parse: {reason}")]
    Unparsable {
        /// What the parser says.
        reason: String,
    },
}

/// The functions of a program by name, in the order of the emitted module.
pub(crate) fn functions(program: &Program) -> Vec<(&'static str, &Tape)> {
    let mut functions = vec![
        ("initial_state", &program.initial_state),
        ("discontinuities", &program.discontinuities),
        ("rate", &program.rate),
        ("mass_matrix", &program.mass_matrix.tape),
        ("forcing", &program.forcing),
        ("rate_jacobian", &program.rate_jacobian.tape),
        ("parameter_jacobian", &program.parameter_jacobian.tape),
        ("time_derivative", &program.time_derivative),
        ("outputs", &program.outputs),
        ("energy", &program.energy),
        ("power_balance", &program.power_balance),
    ];
    if !program.events.is_empty() {
        functions.extend([
            ("guards", &program.guards),
            ("guard_rates", &program.guard_rates),
            ("resets", &program.resets),
        ]);
    }
    if !program.constraints.is_empty() {
        functions.extend([
            ("constraint_values", &program.constraint_values),
            ("constraint_rates", &program.constraint_rates),
            ("constraint_matrix", &program.constraint_matrix.tape),
        ]);
    }
    functions
}
