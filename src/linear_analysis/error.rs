//! What can go wrong in a linear analysis.

use std::fmt;

use thiserror::Error;

use crate::error::SimulateError;

/// Why there is no linear analysis.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum LinearError {
    /// The run that leads to the point was refused or stopped.
    #[error(transparent)]
    Simulate(#[from] SimulateError),
    /// The scene is too large: for full matrices, or for all shapes of a chain.
    #[error(
        "scene `{scene}` has {states} states, but what a linear analysis needs here takes at most \
         {most}"
    )]
    TooLarge {
        /// The scene.
        scene: String,
        /// Its number of states.
        states: usize,
        /// How many would do.
        most: usize,
    },
    /// An output has accelerations or forces of constraints in it, which a force changes at once.
    #[error(
        "how `{output}` answers a force on `{coordinate}` is not analysed: it has accelerations or \
         forces of constraints in it, which answer at once. \
         Hint: make the force a parameter of the scene, 0 if need be, and name that"
    )]
    AnswersAtOnce {
        /// The output.
        output: String,
        /// The coordinate.
        coordinate: String,
    },
    /// A constraint would have to move with what varies.
    #[error(
        "what varies with `{parameter}` is not analysed: constraint `{constraint}` depends on it, \
         and what it holds would have to move with it. \
         Hint: take a parameter of a force, or a coordinate on which a force acts"
    )]
    MovesConstraint {
        /// The parameter.
        parameter: String,
        /// The constraint.
        constraint: String,
    },
    /// Orders are of something else than a speed.
    #[error("orders are of a parameter or a state in rad/s, but `{name}` {why}")]
    NoSpeed {
        /// What was given.
        name: String,
        /// What it is.
        why: String,
    },
    /// A list is as long as the scene does not ask for.
    #[error("scene `{scene}` has {expected} {what}, but {found} values were given")]
    WrongLength {
        /// The scene.
        scene: String,
        /// What was given: `states`, `parameters`.
        what: &'static str,
        /// How many there are.
        expected: usize,
        /// How many were given.
        found: usize,
    },
    /// A rate or a derivative is NaN or infinite.
    #[error("{what} is {value}, but must be a finite number")]
    NotFinite {
        /// Which number.
        what: String,
        /// What it is.
        value: f64,
    },
    /// It does not come back onto its constraints.
    #[error("scene `{scene}` does not come back onto its constraint `{constraint}`")]
    Lost {
        /// The scene.
        scene: String,
        /// The constraint.
        constraint: String,
    },
    /// No state at constant speed was found.
    #[error(
        "scene `{scene}` has no equilibrium near the guess, with time held at {time} s; what \
         remains nearest to one: {}",
        listed(residuals)
    )]
    NoEquilibrium {
        /// The scene.
        scene: String,
        /// Time that was held \[s\].
        time: f64,
        /// Rates that should be zero, the worst first.
        residuals: Vec<Residual>,
    },
    /// An equilibrium that a parameter leaves nothing of.
    #[error(
        "scene `{scene}` is in equilibrium only at this value of `{parameter}`: beside it, nothing \
         could make up for what it changes, so that no derivative by it is told"
    )]
    LosesEquilibrium {
        /// The scene.
        scene: String,
        /// The parameter.
        parameter: String,
    },
    /// Whatever modes are tried, the equilibrium in them is one that an event contradicts.
    #[error(
        "scene `{scene}` has no equilibrium whose modes agree with their guards; last tried: {modes}"
    )]
    NoModes {
        /// The scene.
        scene: String,
        /// The last modes that were tried.
        modes: String,
    },
    /// Differences of the Jacobian that tend to nothing, as at a kink.
    #[error(
        "scene `{scene}`: how its Jacobian changes{} could not be told; it may have a kink there",
        parameter.as_ref().map_or_else(String::new, |name| format!(" with `{name}`"))
    )]
    Unsettled {
        /// The scene.
        scene: String,
        /// The parameter, if it was by one.
        parameter: Option<String>,
    },
    /// A matrix has no inverse.
    #[error("{what} is singular")]
    Singular {
        /// Which matrix.
        what: &'static str,
    },
    /// The eigenvalues were not found.
    #[error("the eigenvalues of dy'/dy were not found: the iteration does not converge")]
    Eigenvalues,
    /// No such quantity.
    #[error("scene `{scene}` has no {kind} `{name}`{hint}")]
    Unknown {
        /// The scene.
        scene: String,
        /// What was looked for.
        kind: &'static str,
        /// The name asked for.
        name: String,
        /// The nearest known name, as a question, or nothing.
        hint: String,
    },
    /// A range of frequencies makes no sense.
    #[error(
        "{points} frequencies from {from} to {until} rad/s were asked for; a range goes from a \
         finite number above 0 up to a larger one and has 2 to {max} points",
        max = super::response::MAX_POINTS
    )]
    BadRange {
        /// Lowest frequency \[rad/s\].
        from: f64,
        /// Highest \[rad/s\].
        until: f64,
        /// How many.
        points: usize,
    },
}

/// A rate that is zero in equilibrium and is not zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Residual {
    /// The state.
    pub state: String,
    /// Its unit.
    pub unit: String,
    /// Its rate, in that unit per second.
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
