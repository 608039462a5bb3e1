//! What can go wrong between a simulator and its trajectory.

use thiserror::Error;

use crate::method::Method;
use crate::trajectory::Trajectory;

/// Why a run was refused or stopped.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SimulateError {
    /// No parameter has this name.
    #[error("scene `{scene}` has no parameter `{name}`{hint}")]
    UnknownParameter {
        /// The scene asked.
        scene: String,
        /// The name asked for.
        name: String,
        /// The nearest known name, as a question, or nothing.
        hint: String,
    },
    /// Nothing depends on the parameter, so that the scene was derived without it.
    #[error(
        "nothing in scene `{scene}` uses parameter `{name}`: another value of it would change \
         nothing. Hint: leave it out, or derive the scene with all that its spec has"
    )]
    UnusedParameter {
        /// The scene asked.
        scene: String,
        /// The parameter.
        name: String,
    },
    /// Values of parameters with which the spec would be refused.
    #[error("scene `{scene}`: {rule}, but it is {value}")]
    RefusedParameters {
        /// The scene asked.
        scene: String,
        /// The rule for the value.
        rule: String,
        /// The value.
        value: f64,
    },
    /// No parameter and no state has this name.
    #[error("scene `{scene}` has no parameter and no state `{name}`{hint}")]
    UnknownDirection {
        /// The scene asked.
        scene: String,
        /// The name asked for.
        name: String,
        /// The nearest known name, as a question, or nothing.
        hint: String,
    },
    /// There are no derivatives by this.
    #[error("there are no sensitivities by `{name}`: it {why}")]
    NotDifferentiable {
        /// The parameter or the state.
        name: String,
        /// Why not.
        why: String,
    },
    /// A simulator without functions on dual numbers.
    #[error(
        "scene `{scene}` has no sensitivities: they take its functions on dual numbers, which \
         scenes with fields, their modes, and simulators written for one number type lack"
    )]
    NoDerivatives {
        /// The scene run.
        scene: String,
    },
    /// A method that does not carry sensitivities.
    #[error("method `{method}` does not carry sensitivities; these do: {known}")]
    NoSensitivities {
        /// The method's name.
        method: &'static str,
        /// The names of the methods that do.
        known: String,
    },
    /// What cannot be gone back over.
    #[error("scene `{scene}` has no gradient in reverse: {why}")]
    NotReversible {
        /// The scene's name.
        scene: String,
        /// What is in the way.
        why: &'static str,
    },
    /// No method has this name.
    #[error(transparent)]
    UnknownMethod(#[from] UnknownMethod),
    /// The method is of a family that this program was compiled without.
    #[error(transparent)]
    NotCompiledIn(#[from] NotCompiledIn),
    /// A start in equilibrium was asked for, and there is none.
    #[error("no start in equilibrium: {0}")]
    NoEquilibrium(String),
    /// A list is as long as the scene does not ask for.
    #[error("scene `{scene}` has {expected} {what}, but {found} values were given")]
    WrongLength {
        /// The scene asked.
        scene: String,
        /// What was given: `states`, `parameters`.
        what: &'static str,
        /// How many there are.
        expected: usize,
        /// How many were given.
        found: usize,
    },
    /// A parameter, an initial state or a time of a jump is NaN or infinite.
    #[error("{what} is {value}, but must be a finite number")]
    NotFinite {
        /// Which value.
        what: String,
        /// What it is.
        value: f64,
    },
    /// The relative tolerance cannot be met.
    #[error("relative tolerance {0} must be a finite number above 0 and at most 1")]
    BadTolerance(f64),
    /// The wanted accuracy cannot be met.
    #[error("accuracy {0} must be a finite number above 0 and at most 1")]
    BadAccuracy(f64),
    /// An absolute tolerance cannot be met.
    #[error("absolute tolerance {value} of `{state}` must be a finite number above 0")]
    BadAbsoluteTolerance {
        /// The state's name.
        state: String,
        /// Its absolute tolerance, in the state's unit.
        value: f64,
    },
    /// The run does not go forward.
    #[error("the run goes from {from} s until {until} s, but must end after it starts")]
    BadSpan {
        /// Start time \[s\].
        from: f64,
        /// End time \[s\].
        until: f64,
    },
    /// Too few or too many output times.
    #[error(
        "{0} output points were asked for, but a run has 2 to {max} of them",
        max = crate::simulate::MAX_POINTS
    )]
    BadPoints(usize),
    /// An output time lies outside the run or before its predecessor.
    #[error(
        "output time number {index}, {time} s, must lie between {from} s and {until} s \
         and not before the one in front of it"
    )]
    BadTime {
        /// Position in the list, from 0.
        index: usize,
        /// The time \[s\].
        time: f64,
        /// Start time of the run \[s\].
        from: f64,
        /// End time of the run \[s\].
        until: f64,
    },
    /// No two unrelated methods get through a run whose truth they should tell.
    #[error("{scene}: no two methods get through the run that is to be the reference")]
    NoReference {
        /// The scene.
        scene: String,
    },
    /// The method is not made for a machine with events or constraints.
    #[error(transparent)]
    Unsuitable(#[from] Unsuitable),
    /// A guard can never pass zero.
    #[error(
        "{scene}: the guard of event `{event}` is zero whatever the state, so that it never passes \
         zero. Hint: a difference of what is the same, or a parameter that is 0"
    )]
    GuardIsZero {
        /// The scene run.
        scene: String,
        /// The event.
        event: String,
    },
    /// No start near the guesses fulfils the constraints.
    #[error(
        "{scene}: no initial {what} fulfils constraint `{constraint}`. Nearest found: {residuals}. \
         Hint: what [initial] gives stays as it is, the rest is looked for from [guess]; \
         parameters may leave no such place"
    )]
    ImpossibleStart {
        /// The scene run.
        scene: String,
        /// `position` or `velocity`.
        what: &'static str,
        /// The constraint that is farthest off.
        constraint: String,
        /// What the constraints are where they are nearest to zero.
        residuals: String,
    },
    /// A constraint says what others say, or nothing.
    #[error("{scene}: constraint `{constraint}` {why}. Hint: {hint}")]
    RedundantConstraint {
        /// The scene run.
        scene: String,
        /// The constraint, the last of those that say the same.
        constraint: String,
        /// What is wrong with it.
        why: String,
        /// Hint on how to mend it.
        hint: &'static str,
    },
    /// The integration could not go on.
    #[error("{scene}: method `{method}` stopped at t = {time} s: {cause}")]
    Stopped {
        /// The scene run.
        scene: String,
        /// The method's name.
        method: &'static str,
        /// Time reached \[s\].
        time: f64,
        /// Why, and what may help.
        cause: StopCause,
        /// The run until there; nothing where nothing was kept, as in a sweep.
        kept: Option<Box<Trajectory>>,
    },
}

#[cfg(feature = "linear")]
impl SimulateError {
    /// Of a search that has failed.
    pub(crate) fn no_equilibrium(error: crate::linear_analysis::LinearError) -> Self {
        match error {
            crate::linear_analysis::LinearError::Simulate(error) => error,
            error => Self::NoEquilibrium(format!(
                "{error}. Hint: give values nearer to it in [initial], or start as given there"
            )),
        }
    }
}

/// Why an integration could not go on.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum StopCause {
    /// Steps shrank until they no longer advance time.
    #[error(
        "the step size fell below what time resolves. \
         Hint: a jump that is not written with `step` or `piecewise`, a solution that grows \
         without bound, or a tolerance below what rounding allows"
    )]
    StepTooSmall,
    /// The right-hand side or its Jacobian is NaN or infinite.
    #[error(
        "{what} is not a finite number. \
         Hint: a division by zero, the root or logarithm of a negative number, a mass matrix \
         that is singular, or a parameter out of its range"
    )]
    NotFinite {
        /// What is not finite.
        what: String,
    },
    /// A state has grown beyond what can be reckoned with.
    #[error(
        "`{state}` has grown to {value:e}, beyond what can be reckoned with. \
         Hint: a solution that grows without bound; end the run before, or look for the sign \
         of a force that drives what it should hold"
    )]
    Overflow {
        /// The state.
        state: String,
        /// Its value, in its unit.
        value: f64,
    },
    /// Modes contradict guards, and no event sets them right.
    #[error(
        "the modes contradict event `{event}`: its guard is beyond zero although it is still \
         watched for, and what it does would change more than modes, or leads to no end. \
         Hint: give other modes or another state in [initial]"
    )]
    Contradiction {
        /// The event.
        event: String,
    },
    /// The tolerance is finer than numbers are.
    #[error("rounding alone exceeds the relative tolerance {rtol}. Hint: 1e-14 is about the least")]
    ToleranceBelowRounding {
        /// The relative tolerance.
        rtol: f64,
    },
    /// Newton's iteration fails however small the step.
    #[error(
        "Newton's iteration does not converge. \
         Hint: the right-hand side is not smooth there; write jumps with `step` or `piecewise`, \
         or try the method `dop853`"
    )]
    Newton,
    /// The limit on steps is reached.
    #[error(
        "the limit of {limit} steps is reached. \
         Hint: an explicit method on a stiff machine takes as many, and so does a rate that \
         jumps to and fro; else raise the limit"
    )]
    TooManySteps {
        /// The limit.
        limit: usize,
    },
    /// Steps so short that those that may be taken, and 100 000 times as many, lead nowhere near the
    /// end; not of a run with a limit of time, or one that somebody looks at.
    #[error(
        "steps are {step:.1e} s on average: {steps:.0e} of them would be left to the end. \
         Hint: an explicit method on a stiff machine takes as many (`auto` and `radau` do not), \
         and so does a motion that is far faster than the run is long; look for a parameter or \
         a speed of the wrong size"
    )]
    TooSlowPace {
        /// Their mean \[s\].
        step: f64,
        /// How many are left to the end of the stretch.
        steps: f64,
    },
    /// The flag of [`Simulation::until_flagged`](crate::Simulation::until_flagged) was set.
    #[error("the run was interrupted")]
    Interrupted,
    /// It took longer than whoever asked for it allows.
    #[error("the limit of {seconds} s of computing is reached")]
    TooSlow {
        /// The limit \[s\].
        seconds: f64,
    },
    /// The kinetic energy jumps with time where sensitivities are carried.
    #[error(
        "the kinetic energy jumps, so that velocities do, and sensitivities are not carried \
         through that. Hint: let the inertia change smoothly"
    )]
    InertiaJumps,
    /// The rate of a state jumps to and fro across a value that it is driven to from
    /// either side.
    #[error(
        "`{state}` chatters at {value:e}: its rate jumps from one side of that to the other and \
         drives it back from both. Hint: dry friction by `sign`, most often; write it as \
         `[friction.NAME]`, which sticks, or smooth it, as the unit `friction_slider_smooth` does"
    )]
    Chattering {
        /// The state.
        state: String,
        /// Where, in its unit.
        value: f64,
    },
    /// A state rests where its force jumps, and is pushed back to from both sides.
    #[error(
        "`{state}` rests at {value:e}, where the force on it jumps and pushes it back from both \
         sides: nothing but that jump holds it, and it goes to and fro across it without end. \
         Hint: hold it by a mode of its own while what pulls is less than the jump, or make the \
         jump a steep slope, as of `sqrt(x^2 + e^2)` for `abs(x)`"
    )]
    RestsOnKink {
        /// The state.
        state: String,
        /// Where, in its unit.
        value: f64,
    },
    /// Events follow on one another without end.
    #[error(
        "event `{event}` happens over and over: {count} events within no time (Zeno). \
         Hint: let an event set a mode in which the machine rests or slides, below some speed"
    )]
    Zeno {
        /// The last of them.
        event: String,
        /// So many.
        count: usize,
    },
    /// A guard that hardly passes zero: when it does is not decided.
    #[error(
        "{name} is grazed: it passes zero so slowly that the tolerances decide when, and \
         whether, so that there are no sensitivities behind it. \
         Hint: a lower `rtol`, an earlier end, or parameters that pass it clearly"
    )]
    Grazing {
        /// What is grazed.
        name: String,
    },
    /// Several things happen at one time, which a parameter moves apart.
    #[error(
        "several events or jumps happen at once here, and `{by}` moves them apart: which comes \
         first decides the derivative. Hint: leave `{by}` out of the sensitivities, or give it a \
         value that keeps them apart"
    )]
    AtOnce {
        /// What moves them apart.
        by: String,
    },
    /// An event sets a position that constraints move on.
    #[error(
        "an event sets `{state}` to what constraints do not allow, and sensitivities do not \
         follow how it is put back. Hint: let the event set positions that fulfil them"
    )]
    MovedPosition {
        /// The state that is moved most.
        state: String,
    },
    /// Modes let a constraint hold that says what others say already, while these move by
    /// themselves.
    #[error(
        "constraint `{constraint}` {why}, in the modes that events have set: its force could not \
         be told from theirs, and no event lets it go behind which the motion could go on. Hint: \
         what is imposed may be what the part forbids, as a one-way clutch that would be driven \
         backwards, or a mass onto its stop; put a spring between, or take friction that fades \
         near rest, such as `rotational/smooth_friction`"
    )]
    Overdetermined {
        /// The constraint.
        constraint: String,
        /// What is wrong with it.
        why: String,
    },
    /// The machine cannot be put back onto its constraints.
    #[error(
        "the machine comes off constraint `{constraint}` and cannot be put back onto it. \
         Hint: it may be at a dead point, where constraints lock it or leave it undecided, or \
         an event has set a position that breaks them"
    )]
    OffConstraint {
        /// The constraint.
        constraint: String,
    },
    /// What holds in some modes only would have to pull along what jumps in speed.
    #[error(
        "a speed that is imposed jumps, and constraint `{constraint}`, which holds in some modes \
         only, as friction does that sticks, would have to pull along with a force without bound. \
         Hint: let the speed change within a short time, as by `min(max((t - t0)/1e-3, 0), 1)`"
    )]
    Jerked {
        /// The constraint.
        constraint: String,
    },
    /// A method that works on full matrices, on a scene that is too large for them.
    #[error(
        "it works on full matrices, and {states} states are more than {most}. \
         Hint: `rodas5p`, `radau` and the explicit methods run large fields"
    )]
    TooLarge {
        /// States of the scene.
        states: usize,
        /// The most that full matrices are made for.
        most: usize,
    },
    /// The method is not made for a machine with events or constraints.
    #[error(transparent)]
    Unsuitable(Box<Unsuitable>),
    /// The method's family is not compiled in.
    #[error(transparent)]
    NotCompiledIn(NotCompiledIn),
    /// Taylor's method on a simulator without series.
    #[error(
        "this simulator has no Taylor series: it was written by hand, or is too large; \
         try the method `auto`"
    )]
    NoSeries,
    /// The closed form of a machine that is not linear.
    #[error(
        "its equations are not linear with constant coefficients, or were written by hand; \
         try the method `auto`"
    )]
    NotLinear,
    /// A closed form that rounding spoils.
    #[error("{reason}")]
    ClosedForm {
        /// What is wrong with it.
        reason: String,
    },
    /// What diffsol reports beyond that.
    #[error("{0}")]
    Diffsol(String),
}

/// A method's name that is not in the table of methods.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("there is no method `{name}`{hint}; known are {known}")]
pub struct UnknownMethod {
    /// The name asked for.
    pub name: String,
    /// The nearest known name, as a question, or nothing.
    pub hint: String,
    /// The names of all methods.
    pub known: String,
}

/// A method on a machine that it would run past what matters.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("scene `{scene}` has {lack}; these do: {known}", lack = .lack.told(.method))]
pub struct Unsuitable {
    /// The scene.
    pub scene: String,
    /// The method's name.
    pub method: &'static str,
    /// What the method does not do.
    pub lack: Lack,
    /// The names of the methods that do.
    pub known: String,
}

/// What a method may not do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lack {
    /// Watch for events.
    Events,
    /// Keep to constraints.
    Constraints,
}

impl Lack {
    fn told(self, method: &str) -> String {
        match self {
            Self::Events => format!("events, which `{method}` does not watch for"),
            Self::Constraints => format!("constraints, which `{method}` does not keep to"),
        }
    }
}

/// A method of a family that this program was compiled without.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error(
    "method `{name}` is not compiled in. \
     Hint: build with the feature `{feature}`, or use one of {compiled_in}"
)]
pub struct NotCompiledIn {
    /// The method's name.
    pub name: &'static str,
    /// The Cargo feature of its family.
    pub feature: &'static str,
    /// The names of the methods that are there.
    pub compiled_in: String,
}

impl NotCompiledIn {
    pub(crate) fn of(method: Method) -> Self {
        let compiled_in: Vec<_> = Method::compiled_in().map(Method::name).collect();
        let feature = method.feature().unwrap_or_default();
        Self { name: method.name(), feature, compiled_in: compiled_in.join(", ") }
    }
}

/// The one of `known` that resembles `name` most, or ends in it after a dot, if any does.
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

/// ` (did you mean ...?)` for the nearest of `known`, else nothing.
#[must_use]
pub fn did_you_mean<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    nearest(name, known).map_or_else(String::new, |name| format!(" (did you mean `{name}`?)"))
}
