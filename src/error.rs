//! Errors of runs.

use thiserror::Error;

use crate::method::Method;
use crate::trajectory::Trajectory;

/// Reason why a run was refused or stopped.
#[derive(Debug, Clone, PartialEq, Error)]
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
        max = crate::simulate::MAX_POINTS
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
    /// The integration stopped early.
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

#[cfg(feature = "linear")]
impl SimulateError {
    /// Converts the error of a failed search for an equilibrium.
    pub(crate) fn no_equilibrium(error: crate::linear_analysis::LinearError) -> Self {
        match error {
            crate::linear_analysis::LinearError::Simulate(error) => error,
            error => Self::NoEquilibrium(format!(
                "{error}. Hint: give values nearer to equilibrium in [initial], or start from \
                 those values"
            )),
        }
    }
}

impl StopCause {
    /// Returns the cause of a stop at a quantity that is not finite.
    pub(crate) fn not_finite(what: String) -> Self {
        Self::NotFinite { what, parameters: Vec::new() }
    }
}

/// Reason why an integration stopped.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum StopCause {
    /// The step size fell below the resolution of time.
    #[error(
        "the step size fell below the resolution of time. Hint: a discontinuity that is not \
         written with `step` or `piecewise`, a solution that grows without bound, or a tolerance \
         below rounding"
    )]
    StepTooSmall,
    /// The right-hand side or its Jacobian is NaN or infinite.
    #[error("{}", not_finite(.what, .parameters))]
    NotFinite {
        /// Name of the quantity that is not finite.
        what: String,
        /// Names and values of parameters, each of which makes it finite at the start if it has
        /// another value.
        parameters: Vec<(String, f64)>,
    },
    /// A state has grown beyond the range of computation.
    #[error(
        "`{state}` has grown to {value:e}, beyond the range of computation. Hint: the solution \
         grows without bound; end the run earlier, or check the signs of forces"
    )]
    Overflow {
        /// Name of the state.
        state: String,
        /// Its value, in its unit.
        value: f64,
    },
    /// Modes contradict guards, and no event resolves the contradiction.
    #[error(
        "the modes contradict event `{event}`: its guard is already beyond zero, but the event \
         would change more than modes, or the events never settle. Hint: give other modes or \
         another state in [initial]"
    )]
    Contradiction {
        /// Name of the event.
        event: String,
    },
    /// Rounding errors exceed the tolerance.
    #[error("rounding exceeds the relative tolerance {rtol}. Hint: use about 1e-14 or more")]
    ToleranceBelowRounding {
        /// Relative tolerance.
        rtol: f64,
    },
    /// Newton's iteration fails at any step size.
    #[error(
        "Newton's iteration does not converge. \
         Hint: the right-hand side is not smooth there; write jumps with `step` or `piecewise`, \
         or try the method `dop853`"
    )]
    Newton,
    /// The maximum number of steps is reached.
    #[error(
        "the limit of {limit} steps is reached. Hint: a stiff machine with an explicit method, or \
         a rate that chatters; otherwise raise the limit"
    )]
    TooManySteps {
        /// Maximum number of steps.
        limit: usize,
    },
    /// Steps are so short that even 100 000 times the maximum number of them would not reach the
    /// end. Runs with a time limit and runs that somebody watches are exempt.
    #[error(
        "steps are {step:.1e} s on average: {steps:.0e} more would be needed. Hint: a stiff \
         machine with an explicit method (use `auto` or `radau`), or a motion far too fast for the \
         length of the run; look for a parameter or a speed of the wrong magnitude"
    )]
    TooSlowPace {
        /// Mean step size \[s\].
        step: f64,
        /// Estimated number of steps to the end of the segment.
        steps: f64,
    },
    /// The flag of [`Simulation::until_flagged`](crate::Simulation::until_flagged) was set.
    #[error("the run was interrupted")]
    Interrupted,
    /// The run took longer than its time limit.
    #[error("the limit of {seconds} s of computing is reached")]
    TooSlow {
        /// Time limit \[s\].
        seconds: f64,
    },
    /// The kinetic energy jumps while sensitivities are carried.
    #[error(
        "the kinetic energy jumps, and sensitivities are not carried through the jump of \
         velocities. Hint: let the inertia change smoothly"
    )]
    InertiaJumps,
    /// The kinetic energy jumps where a guard that reads velocities crosses zero.
    #[error(
        "the kinetic energy jumps where a comparison of velocities changes, and no law determines \
         the velocities behind such a jump. Hint: let the inertia depend on time, on positions or \
         on modes that events set"
    )]
    InertiaByVelocity,
    /// A motion would slide along the surface of a relation, but cannot.
    #[error(
        "`{state}` is driven back to {value:e} from both sides, and no unique sliding motion \
         exists: the comparison is in the kinetic energy or in a constraint, its force is \
         multiplied by another one that switches there, or sensitivities are requested where only \
         the second derivative of its guard jumps. Hint: write dry friction as `[friction.NAME]`"
    )]
    Chattering {
        /// Name of the state.
        state: String,
        /// Value at which it chatters, in its unit.
        value: f64,
    },
    /// A sliding motion cannot be projected back onto its surface.
    #[error("`{state}` cannot be projected back onto the switching surface along which it slides")]
    OffSurface {
        /// Name of a state.
        state: String,
    },
    /// Events follow one another without end (Zeno).
    #[error(
        "event `{event}` happens over and over: {count} events within no time (Zeno). \
         Hint: let an event set a mode in which the machine rests or slides, below some speed"
    )]
    Zeno {
        /// Name of the last event.
        event: String,
        /// Number of events.
        count: usize,
    },
    /// A guard is grazed: it crosses zero so slowly that the time of the crossing is not
    /// determined.
    #[error(
        "{name} is grazed: it crosses zero so slowly that the crossing depends on the tolerances, \
         and there are no sensitivities after it. Hint: lower `rtol`, end the run earlier, or \
         choose parameters with a clear crossing"
    )]
    Grazing {
        /// Name of the grazed guard or switching surface.
        name: String,
    },
    /// Several events or jumps coincide, and a parameter separates them.
    #[error(
        "several events or jumps coincide, and `{by}` separates them: the derivative depends on \
         their order. Hint: leave `{by}` out of the sensitivities, or give it a value that \
         separates them"
    )]
    AtOnce {
        /// Name of the parameter or state that separates them.
        by: String,
    },
    /// An event sets a position that violates constraints, and projection moves it.
    #[error(
        "an event sets `{state}` to a value that violates constraints, and sensitivities are not \
         carried through its projection. Hint: let the event set positions that fulfil the \
         constraints"
    )]
    MovedPosition {
        /// Name of the state that projection moves most.
        state: String,
    },
    /// A constraint is redundant in the modes that events have set, and the constraints it repeats
    /// prescribe a motion.
    #[error(
        "constraint `{constraint}` {why}, in the modes that events have set: the constraint forces \
         are not unique, and no event releases it so that the motion could continue. Hint: a \
         prescribed motion may be one that the part prevents, such as driving a one-way clutch \
         backwards or a mass into its stop; put a spring in between, or use friction that fades \
         near rest, such as `rotational/smooth_friction`"
    )]
    Overdetermined {
        /// Name of the constraint.
        constraint: String,
        /// Reason.
        why: String,
    },
    /// Projection onto the constraints fails.
    #[error(
        "the state violates constraint `{constraint}`, and projection onto it fails. Hint: the \
         machine may be at a dead point, where constraints lock it or leave its motion \
         undetermined, or an event has set a position that violates them"
    )]
    OffConstraint {
        /// Name of the constraint.
        constraint: String,
    },
    /// A constraint that holds only in some modes would need an infinite force to follow a
    /// prescribed speed that jumps.
    #[error(
        "a prescribed speed jumps, and constraint `{constraint}`, which is active in some modes \
         only, would need an infinite force to follow. Hint: write dry friction as `[friction]`, \
         which then slides, or let the speed change within a short time, such as by `min(max((t - \
         t0)/1e-3, 0), 1)`"
    )]
    Jerked {
        /// Name of the constraint.
        constraint: String,
    },
    /// The scene is too large for a method that uses full matrices.
    #[error(
        "it uses full matrices, and the scene has {states} states, more than {most}. Hint: \
         `rodas5p`, `radau` and the explicit methods run large fields"
    )]
    TooLarge {
        /// Number of states of the scene.
        states: usize,
        /// Maximum number of states.
        most: usize,
    },
    /// The method does not support events or constraints, and the machine has some.
    #[error(transparent)]
    Unsuitable(Box<Unsuitable>),
    /// The method's family is not compiled in.
    #[error(transparent)]
    NotCompiledIn(NotCompiledIn),
    /// Taylor's method was requested for a simulator without Taylor series.
    #[error(
        "this simulator has no Taylor series: it was written by hand, or is too large; \
         try the method `auto`"
    )]
    NoSeries,
    /// The method `exact` was requested for a machine that is not linear.
    #[error(
        "its equations are not linear with constant coefficients, or were written by hand; \
         try the method `auto`"
    )]
    NotLinear,
    /// Rounding spoils the closed form.
    #[error("{reason}")]
    ClosedForm {
        /// Explanation.
        reason: String,
    },
    /// Any other error of diffsol.
    #[error("{0}")]
    Diffsol(String),
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

/// Error for a method that would ignore events or constraints of the machine.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("scene `{scene}` has {feature}; these do: {known}", feature = .feature.told(.method))]
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
    fn told(self, method: &str) -> String {
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
    pub(crate) fn of(method: Method) -> Self {
        let compiled_in: Vec<_> = Method::compiled_in().map(Method::name).collect();
        let feature = method.feature().unwrap_or_default();
        Self { name: method.name(), feature, compiled_in: compiled_in.join(", ") }
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

/// Returns the message on a quantity that is not finite.
fn not_finite(what: &str, parameters: &[(String, f64)]) -> String {
    if parameters.is_empty() {
        return format!(
            "{what} is not a finite number. Hint: a division by zero, the root or logarithm of a \
             negative number, a mass matrix that is singular, friction by a constraint force that \
             jams, or a parameter out of its range"
        );
    }
    let causes: Vec<String> =
        parameters.iter().map(|(name, value)| format!("parameter `{name}` is {value}")).collect();
    format!(
        "{what} is not a finite number, because {}. Hint: give it another value",
        causes.join(" or because ")
    )
}
