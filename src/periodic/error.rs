//! Errors of searches for periodic motions.

use thiserror::Error;

use super::MAX_UNKNOWNS;
use crate::error::{SimulateError, StopCause};

/// Reason why no periodic motion was found.
#[derive(Debug, Clone, PartialEq, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "cycle::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum CycleError {
    /// A run was refused or stopped.
    #[strum(serialize = "")]
    #[error(transparent)]
    Simulate(#[from] SimulateError),
    /// A setting is out of range.
    #[error("{0}")]
    BadSetting(String),
    /// No state has this name.
    #[error("scene `{scene}` has no state `{name}`{hint}")]
    UnknownState {
        /// Name of the scene.
        scene: String,
        /// Requested name.
        name: String,
        /// Nearest known name as a question, or empty.
        hint: String,
    },
    /// The equations have too many unknowns for full matrices.
    #[error(
        "the periodic motion of scene `{scene}` has {unknowns} unknowns, more than \
         {MAX_UNKNOWNS}. Hint: use fewer segments, or coarser fields"
    )]
    TooLarge {
        /// Name of the scene.
        scene: String,
        /// Number of unknowns.
        unknowns: usize,
    },
    /// The machine depends on time, and no period was given.
    #[error(
        "scene `{scene}` depends on time, so its motions have the period of the excitation. Hint: \
         give the period, or the parameter that determines it"
    )]
    NeedsPeriod {
        /// Name of the scene.
        scene: String,
    },
    /// The motion returns nowhere near its end.
    #[error(
        "the motion of scene `{scene}` from {from} s until {until} s does not return to the state \
         at its end{moves}. Hint: let the machine settle for longer, guess the period, or name the \
         angles that advance by whole turns"
    )]
    NoReturn {
        /// Name of the scene.
        scene: String,
        /// Start of the run \[s\].
        from: f64,
        /// Its end \[s\].
        until: f64,
        /// State that differs most at the nearest approach, or empty.
        moves: String,
    },
    /// The machine is at rest.
    #[error(
        "scene `{scene}` is in equilibrium at {time} s, so no motion determines a period. Hint: \
         give other initial values"
    )]
    AtRest {
        /// Name of the scene.
        scene: String,
        /// Time \[s\].
        time: f64,
    },
    /// Newton's method does not converge.
    #[error(
        "scene `{scene}`: no periodic motion near the start: after {iterations} steps, `{state}` \
         still differs by {difference:.3e} after a period of {period} s. Hint: let the machine \
         settle for longer, give a better guess, a multiple of the period, or more segments"
    )]
    NotFound {
        /// Name of the scene.
        scene: String,
        /// Number of Newton's steps.
        iterations: usize,
        /// State that differs most.
        state: String,
        /// Its difference, in its unit.
        difference: f64,
        /// Period reached \[s\].
        period: f64,
    },
    /// The excitation does not repeat with the period.
    #[error(
        "scene `{scene}`: the excitation does not repeat after {period} s: a period later, `{state}` \
         differs by {difference:.3e}. Hint: give the common period of all excitations, or let the \
         machine settle until they repeat"
    )]
    OtherExcitation {
        /// Name of the scene.
        scene: String,
        /// Period \[s\].
        period: f64,
        /// State that differs most.
        state: String,
        /// Its difference, in its unit.
        difference: f64,
    },
    /// The continuous states return, but a mode does not.
    #[error(
        "scene `{scene}`: after a period of {period} s the motion returns in another mode: \
         `{state}` goes from {from} to {to}. Hint: look for a multiple of the period"
    )]
    OtherMode {
        /// Name of the scene.
        scene: String,
        /// Period \[s\].
        period: f64,
        /// Name of the mode.
        state: String,
        /// Its value at the start.
        from: f64,
        /// Its value after a period.
        to: f64,
    },
}

impl CycleError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Simulate(error) => error.code(),
            error => error.into(),
        }
    }
}

impl CycleError {
    /// Returns whether somebody ended the work, so that it must not be tried again.
    pub(super) fn is_final(&self) -> bool {
        matches!(
            self,
            Self::Simulate(SimulateError::Stopped {
                cause: StopCause::Interrupted | StopCause::TooSlow { .. },
                ..
            })
        )
    }

    /// Returns whether a run stopped on its way, as opposed to having been refused.
    pub(super) fn is_of_motion(&self) -> bool {
        matches!(self, Self::Simulate(SimulateError::Stopped { .. })) && !self.is_final()
    }
}
