//! Errors of runs.

mod stop_cause;

use thiserror::Error;

use crate::trajectory::Trajectory;

pub use stop_cause::StopCause;

/// Reason why a run was refused or stopped.
#[derive(Debug, Clone, PartialEq, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "run::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum SimulateError {
    /// No parameter has this name.
    #[error("scene `{scene}` has no parameter `{name}`{hint}")]
    UnknownParameter {
        /// Name of the scene.
        scene: String,
        /// Requested name.
        name: String,
        /// Nearest known name as a question, or empty.
        hint: String,
    },
    /// Nothing depends on the parameter, so the scene was derived without it.
    #[error(
        "nothing in scene `{scene}` uses parameter `{name}`, so its value has no effect. Hint: \
         leave it out, or derive the scene without reduction"
    )]
    UnusedParameter {
        /// Name of the scene.
        scene: String,
        /// Name of the parameter.
        name: String,
    },
    /// The spec's checks refuse these parameter values.
    #[error("scene `{scene}`: {rule}, but it is {value}")]
    RefusedParameters {
        /// Name of the scene.
        scene: String,
        /// Violated rule.
        rule: String,
        /// Value that violates the rule.
        value: f64,
    },
    /// No parameter and no state has this name.
    #[error("scene `{scene}` has no parameter and no state `{name}`{hint}")]
    UnknownDirection {
        /// Name of the scene.
        scene: String,
        /// Requested name.
        name: String,
        /// Nearest known name as a question, or empty.
        hint: String,
    },
    /// The run cannot be differentiated by this parameter or state.
    #[error("no sensitivities with respect to `{name}`: it {why}")]
    NotDifferentiable {
        /// Name of the parameter or state.
        name: String,
        /// Reason.
        why: String,
    },
    /// The simulator has no functions on dual numbers.
    #[error(
        "scene `{scene}` has no sensitivities: they require its functions on dual numbers, which \
         scenes with fields, their eigenmodes, and simulators written for one number type do not \
         have"
    )]
    NoDerivatives {
        /// Name of the scene.
        scene: String,
    },
    /// The method does not carry sensitivities.
    #[error("method `{method}` does not carry sensitivities; these do: {known}")]
    NoSensitivities {
        /// Name of the method.
        method: &'static str,
        /// Names of the methods that carry sensitivities.
        known: String,
    },
    /// The run has no gradient by the adjoint method.
    #[error("scene `{scene}` has no adjoint gradient: {why}")]
    NotReversible {
        /// Name of the scene.
        scene: String,
        /// Reason.
        why: &'static str,
    },
    /// No method has this name.
    #[error(transparent)]
    UnknownMethod(#[from] UnknownMethod),
    /// The method is of a family that this program was compiled without.
    #[error(transparent)]
    NotCompiledIn(#[from] NotCompiledIn),
    /// A start in equilibrium was requested, but no equilibrium was found.
    #[error("no start in equilibrium: {0}")]
    NoEquilibrium(String),
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
    /// A parameter, an initial state or the time of a jump is NaN or infinite.
    #[strum(serialize = "value-not-finite")]
    #[error("{what} is {value}, but must be a finite number")]
    NotFinite {
        /// Name of the value.
        what: String,
        /// The value.
        value: f64,
    },
    /// The relative tolerance is out of range.
    #[error("relative tolerance {0} must be a finite number above 0 and at most 1")]
    BadTolerance(f64),
    /// The requested accuracy is out of range.
    #[error("accuracy {0} must be a finite number above 0 and at most 1")]
    BadAccuracy(f64),
    /// An absolute tolerance is out of range.
    #[error("absolute tolerance {value} of `{state}` must be a finite number above 0")]
    BadAbsoluteTolerance {
        /// Name of the state.
        state: String,
        /// Its absolute tolerance, in the unit of the state.
        value: f64,
    },
    /// A constant energy was requested of a run that cannot keep it.
    #[error("scene `{scene}` cannot be projected onto its energy: {why}")]
    NoConstantEnergy {
        /// Name of the scene.
        scene: String,
        /// Reason.
        why: &'static str,
    },
    /// The end of the run is not after its start.
    #[error("the run goes from {from} s until {until} s, but must end after it starts")]
    BadSpan {
        /// Start time \[s\].
        from: f64,
        /// End time \[s\].
        until: f64,
    },
    /// The number of output times is out of range.
    #[error(
        "{0} output points were requested, but a run has 2 to {max} of them",
        max = crate::trajectory::MAX_POINTS
    )]
    BadPoints(usize),
    /// An output time lies outside the run or before its predecessor.
    #[error(
        "output time number {index}, {time} s, must lie between {from} s and {until} s and not \
         before the previous one"
    )]
    BadTime {
        /// Index in the list, from 0.
        index: usize,
        /// The time \[s\].
        time: f64,
        /// Start time of the run \[s\].
        from: f64,
        /// End time of the run \[s\].
        until: f64,
    },
    /// No two unrelated methods complete the run that is to be the reference.
    #[error("{scene}: no two methods complete the reference run")]
    NoReference {
        /// Name of the scene.
        scene: String,
    },
    /// The method does not support events or constraints, and the machine has some.
    #[error(transparent)]
    Unsuitable(#[from] Unsuitable),
    /// A guard is identically zero.
    #[error(
        "{scene}: the guard of event `{event}` is identically zero, so it never crosses zero. \
         Hint: look for a difference of equal terms, or a parameter that is 0"
    )]
    GuardIsZero {
        /// Name of the scene.
        scene: String,
        /// Name of the event.
        event: String,
    },
    /// No start near the guesses fulfils the constraints.
    #[error(
        "{scene}: no initial {what} fulfils constraint `{constraint}`. Nearest found: {residuals}. \
         Hint: values in [initial] are kept, the others are solved for from [guess]; with these \
         parameters, there may be no solution"
    )]
    ImpossibleStart {
        /// Name of the scene.
        scene: String,
        /// `position` or `velocity`.
        what: &'static str,
        /// Constraint with the largest residual.
        constraint: String,
        /// Residuals of the constraints at the best point found.
        residuals: String,
    },
    /// A constraint is redundant or empty.
    #[error("{scene}: constraint `{constraint}` {why}. Hint: {hint}")]
    RedundantConstraint {
        /// Name of the scene.
        scene: String,
        /// Name of the constraint, the last of the redundant ones.
        constraint: String,
        /// Reason.
        why: String,
        /// Hint on how to mend it.
        hint: &'static str,
    },
    /// Coordinates move together without inertia at the start.
    #[error(
        "{scene}: {coordinates} no inertia at the start, so that nothing determines their \
         accelerations. Hint: start elsewhere, or give the body that they move an inertia about \
         its centre"
    )]
    SingularInertia {
        /// Name of the scene.
        scene: String,
        /// Beginning of a sentence on the coordinates.
        coordinates: String,
    },
    /// The integration stopped early.
    #[strum(serialize = "")]
    #[error("{scene}: method `{method}` stopped at t = {time} s: {cause}")]
    Stopped {
        /// Name of the scene.
        scene: String,
        /// Name of the method.
        method: &'static str,
        /// Time reached \[s\].
        time: f64,
        /// Reason, with a hint.
        cause: StopCause,
        /// The run until then; `None` if nothing was kept, as in a sweep.
        kept: Option<Box<Trajectory>>,
    },
}

impl SimulateError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Stopped { cause, .. } => cause.code(),
            error => error.into(),
        }
    }
}

/// Error for a name that is not in the table of methods.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("there is no method `{name}`{hint}; known are {known}")]
pub struct UnknownMethod {
    /// Requested name.
    pub name: String,
    /// Nearest known name as a question, or empty.
    pub hint: String,
    /// Names of all methods.
    pub known: String,
}

impl UnknownMethod {
    /// Returns the code of this kind of error.
    #[must_use]
    pub fn code(&self) -> &'static str {
        "run::unknown-method"
    }
}

/// Error for a method that would ignore events or constraints of the machine.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("scene `{scene}` has {feature}; these do: {known}", feature = .feature.describe(.method))]
pub struct Unsuitable {
    /// Name of the scene.
    pub scene: String,
    /// Name of the method.
    pub method: &'static str,
    /// Feature that the method does not support.
    pub feature: Feature,
    /// Names of the methods that support it.
    pub known: String,
}

impl Unsuitable {
    /// Returns the code of this kind of error.
    #[must_use]
    pub fn code(&self) -> &'static str {
        "run::unsuitable"
    }
}

/// Feature of a machine that a method may not support.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Feature {
    /// Events.
    Events,
    /// Constraints.
    Constraints,
}

impl Feature {
    fn describe(self, method: &str) -> String {
        match self {
            Self::Events => format!("events, which `{method}` does not support"),
            Self::Constraints => format!("constraints, which `{method}` does not support"),
        }
    }
}

/// Error for a method whose family was not compiled in.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error(
    "method `{name}` is not compiled in. \
     Hint: build with the feature `{feature}`, or use one of {compiled_in}"
)]
pub struct NotCompiledIn {
    /// Name of the method.
    pub name: &'static str,
    /// Cargo feature of its family.
    pub feature: &'static str,
    /// Names of the methods that are compiled in.
    pub compiled_in: String,
}

impl NotCompiledIn {
    /// Returns the code of this kind of error.
    #[must_use]
    pub fn code(&self) -> &'static str {
        "run::not-compiled-in"
    }
}

/// Returns the name in `known` that resembles `name` most, or ends in it after a dot.
#[must_use]
pub fn nearest<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    const RESEMBLES: f64 = 0.6;
    let likeness = |candidate: &str| {
        let is_last_part = candidate.strip_suffix(name).is_some_and(|owner| owner.ends_with('.'));
        if is_last_part { 1.0 } else { strsim::normalized_damerau_levenshtein(name, candidate) }
    };
    let likely = known.map(|candidate| (likeness(candidate), candidate));
    let likely = likely.filter(|(likeness, _)| *likeness > RESEMBLES);
    likely.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, candidate)| candidate)
}

/// Returns ` (did you mean ...?)` with the nearest name in `known`, or an empty string.
#[must_use]
pub fn did_you_mean<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    nearest(name, known).map_or_else(String::new, |name| format!(" (did you mean `{name}`?)"))
}
