//! Errors of linear analysis.

use std::fmt;

use thiserror::Error;

use crate::error::SimulateError;

/// Error of a linear analysis.
#[derive(Debug, Clone, PartialEq, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "linear::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum LinearError {
    /// The run to the operating point was refused or stopped.
    #[strum(serialize = "")]
    #[error(transparent)]
    Simulate(#[from] SimulateError),
    /// The scene is too large for dense matrices, or for all shapes of a chain.
    #[error("scene `{scene}` has {states} states, but this linear analysis takes at most {most}")]
    TooLarge {
        /// Name of the scene.
        scene: String,
        /// Number of its states.
        states: usize,
        /// Maximum number of states.
        most: usize,
    },
    /// An output contains accelerations or constraint forces, so it has a direct feedthrough of
    /// forces.
    #[error(
        "the response of `{output}` to a force on `{coordinate}` is not supported: it contains \
         accelerations or constraint forces, which have direct feedthrough. Hint: make the force a \
         parameter of the scene, with value 0 if need be, and name that"
    )]
    DirectFeedthrough {
        /// Name of the output.
        output: String,
        /// Name of the coordinate.
        coordinate: String,
    },
    /// A constraint depends on the varied parameter.
    #[error(
        "the response to `{parameter}` is not supported: constraint `{constraint}` depends on it, \
         so a change of it would prescribe a motion. Hint: take a parameter of a force, or a \
         coordinate on which a force acts"
    )]
    MovesConstraint {
        /// Name of the parameter.
        parameter: String,
        /// Name of the constraint.
        constraint: String,
    },
    /// Orders refer to a quantity that is not a speed.
    #[error("orders refer to a parameter, a state or an output in rad/s, but `{name}` {why}")]
    NoSpeed {
        /// Name given.
        name: String,
        /// Reason.
        why: String,
    },
    /// A list has the wrong length for the scene.
    #[error("scene `{scene}` has {expected} {what}, but {found} values were given")]
    WrongLength {
        /// Name of the scene.
        scene: String,
        /// Kind of values: `states`, `parameters`.
        what: &'static str,
        /// Expected number of values.
        expected: usize,
        /// Number of values given.
        found: usize,
    },
    /// A rate or a derivative is NaN or infinite.
    #[error("{what} is {value}, but must be a finite number")]
    NotFinite {
        /// Name of the number.
        what: String,
        /// The value.
        value: f64,
    },
    /// Projection onto the constraints fails.
    #[error("scene `{scene}` cannot be projected onto its constraint `{constraint}`")]
    OffConstraint {
        /// Name of the scene.
        scene: String,
        /// Name of the constraint.
        constraint: String,
    },
    /// No equilibrium was found.
    #[error(
        "scene `{scene}` has no equilibrium near the guess, with time held at {time} s; largest \
         remaining rates: {}",
        listed(residuals)
    )]
    NoEquilibrium {
        /// Name of the scene.
        scene: String,
        /// Time \[s\].
        time: f64,
        /// Rates that should be zero, the largest first.
        residuals: Vec<Residual>,
    },
    /// The equilibrium exists only at this value of a parameter.
    #[error(
        "scene `{scene}` is in equilibrium only at this value of `{parameter}`: no state balances \
         a change of it, so derivatives with respect to it do not exist"
    )]
    LosesEquilibrium {
        /// Name of the scene.
        scene: String,
        /// Name of the parameter.
        parameter: String,
    },
    /// No equilibrium has modes that agree with their guards.
    #[error(
        "scene `{scene}` has no equilibrium whose modes agree with their guards; last tried: {modes}"
    )]
    NoModes {
        /// Name of the scene.
        scene: String,
        /// Modes tried last.
        modes: String,
    },
    /// Differences of the Jacobian do not converge, as at a switching surface.
    #[error(
        "scene `{scene}`: the derivative of its Jacobian{} could not be determined; a switching \
         surface may be near",
        parameter.as_ref().map_or_else(String::new, |name| format!(" by `{name}`"))
    )]
    NotSmooth {
        /// Name of the scene.
        scene: String,
        /// Name of the parameter, if there is one.
        parameter: Option<String>,
    },
    /// A matrix has no inverse.
    #[error("{what} is singular")]
    Singular {
        /// Name of the matrix.
        what: &'static str,
    },
    /// The eigenvalue iteration does not converge.
    #[error("the eigenvalues of dy'/dy were not found: the iteration does not converge")]
    Eigenvalues,
    /// No quantity has this name.
    #[error("scene `{scene}` has no {kind} `{name}`{hint}")]
    UnknownName {
        /// Name of the scene.
        scene: String,
        /// Kind of quantity.
        kind: &'static str,
        /// Requested name.
        name: String,
        /// Nearest known name as a question, or empty.
        hint: String,
    },
    /// A name is given twice.
    #[error("the {kind} `{name}` is given twice. Hint: name each {kind} once")]
    DuplicateName {
        /// Kind of name: `input`, `output`.
        kind: &'static str,
        /// The name.
        name: String,
    },
    /// A matrix has the wrong shape.
    #[error("the matrix {matrix} must have {rows} rows of {columns} numbers")]
    Shape {
        /// Name of the matrix.
        matrix: &'static str,
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
    },
    /// A sampling period is not a positive number.
    #[error("a sampling period is a finite number of seconds above 0, but {period} was given")]
    BadPeriod {
        /// The period \[s\].
        period: f64,
    },
    /// A sampled model is to be sampled.
    #[error("the model is sampled already; sample the continuous one")]
    Sampled,
    /// A sampled model is too fast for its period.
    #[error(
        "sampled at {period} s, the model overflows: its fastest motion grows beyond all numbers \
         between two samples. Hint: take a shorter period"
    )]
    Overflow {
        /// The period \[s\].
        period: f64,
    },
    /// A range of frequencies is invalid.
    #[error(
        "{points} frequencies from {from} to {until} rad/s were requested; a range goes from a \
         finite number above 0 to a larger one and has 2 to {max} points",
        max = super::response::MAX_POINTS
    )]
    BadRange {
        /// Lowest frequency \[rad/s\].
        from: f64,
        /// Highest frequency \[rad/s\].
        until: f64,
        /// Number of points.
        points: usize,
    },
}

impl LinearError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Simulate(error) => error.code(),
            error => error.into(),
        }
    }
}

impl LinearError {
    /// Converts the error of a search for a start in equilibrium.
    pub(crate) fn of_start(self) -> SimulateError {
        match self {
            Self::Simulate(error) => error,
            error => SimulateError::NoEquilibrium(format!(
                "{error}. Hint: give values nearer to equilibrium in [initial], or start from \
                 those values"
            )),
        }
    }
}

/// A rate that should be zero in equilibrium but is not.
#[derive(Debug, Clone, PartialEq)]
pub struct Residual {
    /// Name of the state.
    pub state: String,
    /// Its unit.
    pub unit: String,
    /// Its rate, in this unit per second.
    pub rate: f64,
}

impl fmt::Display for Residual {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unit = if self.unit == "1" { String::new() } else { format!(" {}", self.unit) };
        write!(f, "`{}` changes by {:.3e}{unit} a second", self.state, self.rate)
    }
}

fn listed(residuals: &[Residual]) -> String {
    const SHOWN: usize = 3;
    let shown: Vec<String> = residuals.iter().take(SHOWN).map(ToString::to_string).collect();
    shown.join(", ")
}
