//! Causes of stops.

use thiserror::Error;

use super::{NotCompiledIn, Unsuitable};

/// Reason why an integration stopped.
#[derive(Debug, Clone, PartialEq, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "run::", serialize_all = "kebab-case")]
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
    CoincidentEvents {
        /// Name of the parameter or state that separates them.
        by: String,
    },
    /// An event sets a position that violates constraints, and projection moves it.
    #[error(
        "an event sets `{state}` to a value that violates constraints, and sensitivities are not \
         carried through its projection. Hint: let the event set positions that fulfil the \
         constraints"
    )]
    ProjectedPosition {
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
    SpeedJumps {
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

impl StopCause {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.into()
    }

    /// Returns the cause of a stop at a quantity that is not finite.
    pub(crate) fn not_finite(what: String) -> Self {
        Self::NotFinite { what, parameters: Vec::new() }
    }
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
