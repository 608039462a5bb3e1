//! Errors of designs.

use thiserror::Error;

use super::{LinearError, MAX_STATES_OF_DESIGNS};

/// Reason why there is no regulator or estimator.
#[derive(Debug, Clone, PartialEq, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "regulator::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum RegulatorError {
    /// The model itself is at fault.
    #[strum(serialize = "")]
    #[error(transparent)]
    Linear(#[from] LinearError),
    /// The model is too large.
    #[error("a design takes at most {MAX_STATES_OF_DESIGNS} states, but the model has {states}")]
    TooLarge {
        /// Number of its states.
        states: usize,
    },
    /// No signal has this name.
    #[error("the model has no input or output `{name}`{hint}")]
    UnknownSignal {
        /// Requested name.
        name: String,
        /// Nearest known name as a question, or empty.
        hint: String,
    },
    /// A deviation is not a positive number.
    #[error("the deviation of `{name}` is {deviation}, but must be a finite number above 0")]
    BadDeviation {
        /// Name of the signal.
        name: String,
        /// The deviation.
        deviation: f64,
    },
    /// No input has a deviation.
    #[error(
        "no input has a deviation. Hint: give one for each input that is controlled (LQR) or \
         disturbed (Kalman filter)"
    )]
    NoInput,
    /// No output has a deviation.
    #[error(
        "no output has a deviation. Hint: give one for each output that is regulated (LQR) or \
         measured (Kalman filter)"
    )]
    NoOutput,
    /// The controlled inputs cannot move a motion that does not decay.
    #[error(
        "no regulator exists: the controlled inputs do not move {motion}, which does not decay"
    )]
    Unmoved {
        /// Largest shares of its states.
        motion: String,
    },
    /// No weighted output shows a motion that does not decay.
    #[error(
        "no regulator exists: no weighted output shows {motion}, which does not decay. Hint: give \
         a deviation for an output that contains it"
    )]
    Unweighted {
        /// Largest shares of its states.
        motion: String,
    },
    /// No measured output shows a motion that does not decay.
    #[error(
        "no Kalman filter exists: no measured output shows {motion}, which does not decay. Hint: \
         measure an output that contains it"
    )]
    Unmeasured {
        /// Largest shares of its states.
        motion: String,
    },
    /// No noise moves a motion that does not decay.
    #[error(
        "no steady Kalman filter exists: no noise moves {motion}, which does not decay. Hint: give \
         a deviation for an input that moves it"
    )]
    Undisturbed {
        /// Largest shares of its states.
        motion: String,
    },
    /// The Riccati equation was not solved.
    #[error(
        "the Riccati equation was not solved: its numbers differ too much in size. Hint: choose \
         deviations that differ less, or leave fast states out of the model"
    )]
    Unsolved,
}

impl RegulatorError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Linear(error) => error.code(),
            error => error.into(),
        }
    }
}
