//! Periodic motions of a machine, and their stability.
//!
//! A motion of period T fulfils
//!
//! ```text
//! phi(y_0; t_0, t_0 + T) = y_0 + 2 pi k
//! ```
//!
//! with the flow phi of the machine and whole turns k of the angles that advance. Multiple shooting
//! divides the period into segments with a state at the start of each, and solves for all of these
//! states by Newton's method. The derivatives of the flow are the sensitivities of the runs with
//! respect to their initial values; they are exact through events, resets and constraints. Their
//! product over the period is the monodromy matrix, and its eigenvalues are the Floquet
//! multipliers.
//!
//! The period is given by an excitation, or unknown. If it is unknown, a phase condition joins the
//! equations: the start moves at right angles to the rate.
//!
//! R. Seydel, Practical Bifurcation and Stability Analysis, chapter 7; U. Ascher, R. Mattheij and
//! R. Russell, Numerical Solution of Boundary Value Problems, chapter 4.

mod branch;
mod corner;
mod doubled;
mod equations;
mod error;
mod floquet;
mod follow;
mod guess;
mod locate;
mod newton;
mod section;
mod shot;

use std::f64::consts::TAU;

use machinist_contract::Simulator;
use serde::Serialize;

use crate::error::did_you_mean;
use crate::simulate::Simulation;
use crate::trajectory::{ColumnKind, Trajectory};
use equations::{Guess, Period as Span, Problem};
use newton::Solution;

pub use branch::{Bifurcation, Branch, BranchPoint, BranchSettings, MAX_POINTS, branch};
pub use doubled::{doubled, doublings};
pub use error::CycleError;
pub use floquet::{Crossing, Multiplier, Stability};
pub use section::{Section, repeats};

/// Maximum number of segments of a period.
pub const MAX_SEGMENTS: usize = 200;
/// Maximum number of unknowns: the equations are solved by the singular values of a full matrix.
pub const MAX_UNKNOWNS: usize = 2000;

/// Period of the motion searched for.
#[derive(Debug, Clone, PartialEq)]
pub enum Period {
    /// Period of the excitation \[s\].
    Fixed(f64),
    /// Name of a parameter that determines the period: an angular frequency in rad/s, a frequency
    /// in Hz or 1/s, or the period itself in s.
    Parameter(String),
    /// Unknown period of a machine that does not depend on time, with a first guess \[s\].
    Unknown(Option<f64>),
}

/// Settings of a search for a periodic motion.
#[derive(Debug, Clone, PartialEq)]
pub struct CycleSettings {
    /// Period.
    pub period: Period,
    /// Number of periods of the excitation in a period of the motion.
    pub multiple: usize,
    /// Names of angles that advance by whole turns in a period, and the numbers of turns.
    pub turns: Vec<(String, f64)>,
    /// Time for which the machine runs before the search begins \[s\].
    pub settle: f64,
    /// Number of segments of the period.
    pub segments: usize,
    /// Maximum number of Newton's steps.
    pub max_iterations: usize,
    /// Number of output times of the motion, including both ends.
    pub points: usize,
}

impl Default for CycleSettings {
    /// An unknown period, one segment, no time to settle.
    fn default() -> Self {
        Self {
            period: Period::Unknown(None),
            multiple: 1,
            turns: Vec::new(),
            settle: 0.0,
            segments: 1,
            max_iterations: 40,
            points: 401,
        }
    }
}

impl CycleSettings {
    /// Returns the period \[s\] of the motion at the parameters of a run, unless it is unknown.
    ///
    /// # Errors
    /// [`CycleError`] if the parameter that determines it is unknown, or the period is no time.
    pub fn period_of(&self, run: &Simulation<'_>) -> Result<Option<f64>, CycleError> {
        Ok(span(run, self)?.of(run.parameter_values()))
    }
}

/// A periodic motion with its stability.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Cycle {
    /// Name of the scene.
    pub scene: String,
    /// Start of the period \[s\].
    pub start: f64,
    /// Period \[s\].
    pub period: f64,
    /// True if the period is that of an excitation, false if it was solved for.
    pub is_forced: bool,
    /// State at the start of the period, \[q, q', z\] with modes.
    pub state: Vec<f64>,
    /// Largest difference of the state after a period, relative to the sum of its scale and its
    /// size.
    pub residual: f64,
    /// Number of Newton's steps.
    pub iterations: usize,
    /// Floquet multipliers in descending order of their moduli.
    pub multipliers: Vec<Multiplier>,
    /// Stability of the motion.
    pub stability: Stability,
    /// Remarks, such as on multipliers by differences.
    pub notes: Vec<String>,
    /// The motion over one period.
    pub motion: Trajectory,
}

impl Cycle {
    /// Returns the multipliers other than that of the phase of a motion of unknown period.
    pub fn nontrivial(&self) -> impl Iterator<Item = &Multiplier> {
        self.multipliers.iter().filter(|multiplier| !multiplier.is_trivial)
    }
}

/// Searches for a periodic motion of the machine near the end of a run of length `settle`, which
/// begins at the initial state of `run`.
///
/// The tolerance of the search is ten times the relative tolerance of `run`. Method, limits and
/// interrupts are those of `run`.
///
/// # Errors
/// [`CycleError`] if a setting is invalid, a run stops, or the search does not converge.
///
/// ```
/// use machinist::Simulation;
/// use machinist::periodic::{CycleSettings, Period, Stability, cycle};
/// use machinist_scenes::scenes::bouncing_mass::BouncingMass;
///
/// let run = Simulation::new(&BouncingMass).rtol(1e-10);
/// let period = Period::Parameter("frequency".to_owned());
/// let found = cycle(&run, &CycleSettings { period, settle: 2.0, ..CycleSettings::default() })?;
/// assert!((found.period - 0.1).abs() < 1e-12);
/// assert_eq!(found.stability, Stability::Stable);
/// # Ok::<(), machinist::periodic::CycleError>(())
/// ```
pub fn cycle(run: &Simulation<'_>, settings: &CycleSettings) -> Result<Cycle, CycleError> {
    let problem = problem(run, settings)?;
    let solution = first(&problem, settings)?;
    finished(&problem, &solution, settings.points)
}

/// Finds the motion that the machine settles to.
fn first(problem: &Problem<'_>, settings: &CycleSettings) -> Result<Solution, CycleError> {
    let guess = guess::settled(problem, settings)?;
    let solution = newton::solve(problem, guess, settings.max_iterations)?;
    if problem.period != Span::Unknown {
        require_repetition(problem, &solution.guess)?;
    }
    Ok(solution)
}

/// Requires that the motion solves the equations a period later too. It does not if the excitation
/// has another period.
fn require_repetition(problem: &Problem<'_>, guess: &Guess) -> Result<(), CycleError> {
    let mut later = guess.clone();
    later.skipped += 1.0;
    for node in &mut later.nodes {
        node.iter_mut().zip(&problem.advance).for_each(|(state, advance)| *state += advance);
    }
    let (share, state, difference) = problem.largest_gap(&problem.shots(&later)?);
    // Half of the digits: near a grazing event, differences grow as square roots.
    if share <= problem.tolerance().sqrt() {
        return Ok(());
    }
    let simulator = problem.run.simulator();
    Err(CycleError::OtherExcitation {
        scene: simulator.name().to_owned(),
        period: problem.span_of(guess).1,
        state: simulator.state(state).name.to_owned(),
        difference,
    })
}

/// Checks the settings and states the problem.
fn problem<'a>(run: &Simulation<'a>, settings: &CycleSettings) -> Result<Problem<'a>, CycleError> {
    let bad = |what: String| Err(CycleError::BadSetting(what));
    let CycleSettings { multiple, segments, settle, points, .. } = settings;
    if *multiple == 0 {
        return bad("the multiple of the period must be at least 1".to_owned());
    }
    if !(1..=MAX_SEGMENTS).contains(segments) {
        return bad(format!("{segments} segments: a period has 1 to {MAX_SEGMENTS} of them"));
    }
    if !(settle.is_finite() && *settle >= 0.0) {
        return bad(format!("the time to settle is {settle} s, but must not be negative"));
    }
    if *points < 2 {
        return bad(format!("{points} output times: a motion has at least 2"));
    }
    let simulator = run.simulator();
    let free = run.continuous_states();
    if free.is_empty() {
        return bad(format!("scene `{}` has no states that move", simulator.name()));
    }
    let unknowns = free.len() * segments;
    if unknowns > MAX_UNKNOWNS {
        let scene = simulator.name().to_owned();
        return Err(CycleError::TooLarge { scene, unknowns });
    }
    let turns = settings.turns.iter().map(|turn| turn_of(simulator, turn));
    let turns = turns.collect::<Result<Vec<_>, _>>()?;
    let mut advance = vec![0.0; simulator.shape().states()];
    for (index, turns) in turns {
        advance[index] += TAU * turns;
    }
    let period = span(run, settings)?;
    Ok(Problem::new(run.clone(), free, advance, period, *segments))
}

/// Returns the state that advances, and the number of its turns.
fn turn_of(
    simulator: &dyn Simulator<f64>,
    (name, turns): &(String, f64),
) -> Result<(usize, f64), CycleError> {
    let states = || (0..simulator.shape().states()).map(|index| simulator.state(index));
    let Some(index) = states().position(|state| state.name == name) else {
        let hint = did_you_mean(name, states().map(|state| state.name));
        let scene = simulator.name().to_owned();
        return Err(CycleError::UnknownState { scene, name: name.clone(), hint });
    };
    let unit = simulator.state(index).unit;
    if unit != "rad" {
        let what = format!("`{name}` is in {unit}, and only angles, in rad, advance by turns");
        return Err(CycleError::BadSetting(what));
    }
    if !(turns.is_finite() && *turns != 0.0) {
        return Err(CycleError::BadSetting(format!("`{name}` cannot advance by {turns} turns")));
    }
    Ok((index, *turns))
}

/// Returns the period as the equations need it.
fn span(run: &Simulation<'_>, settings: &CycleSettings) -> Result<Span, CycleError> {
    let multiple = settings.multiple as f64;
    let checked = |period: f64| {
        if period.is_finite() && period > 0.0 {
            return Ok(period);
        }
        Err(CycleError::BadSetting(format!("the period is {period} s, but must be above 0 s")))
    };
    Ok(match &settings.period {
        Period::Fixed(period) => Span::Fixed(multiple * checked(*period)?),
        Period::Parameter(name) => {
            let index = run.parameter_index(name)?;
            let turns = match run.simulator().parameter(index).unit {
                "rad/s" => Some(TAU),
                "Hz" | "1/s" => Some(1.0),
                "s" => None,
                unit => {
                    return Err(CycleError::BadSetting(format!(
                        "`{name}` is in {unit}, and determines no period: give a parameter in \
                         rad/s, Hz or s"
                    )));
                }
            };
            let span = Span::OfParameter { index, turns, multiple };
            checked(span.of(run.parameter_values()).unwrap_or(f64::NAN))?;
            span
        }
        Period::Unknown(guess) => {
            guess.map(checked).transpose()?;
            if settings.multiple != 1 {
                let what = "a multiple needs the period of an excitation".to_owned();
                return Err(CycleError::BadSetting(what));
            }
            Span::Unknown
        }
    })
}

/// Computes the motion and the multipliers of a solution.
fn finished(
    problem: &Problem<'_>,
    solution: &Solution,
    points: usize,
) -> Result<Cycle, CycleError> {
    let Solution { guess, shots, residual, iterations } = solution;
    let (start, period) = problem.span_of(guess);
    if problem.period == Span::Unknown {
        guess::require_motion(problem, guess, start)?;
    }
    let motion = problem.run_at(guess).shot_from(&guess.nodes[0]);
    let motion = motion.from(start).until(start + period).points(points).run()?;
    let multipliers = floquet::multipliers(problem, shots);
    let stability = Stability::of(&multipliers, problem.tolerance());
    let mut notes = motion.notes.clone();
    for note in shots.iter().filter_map(|shot| shot.note.clone()) {
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
    Ok(Cycle {
        scene: problem.run.simulator().name().to_owned(),
        start,
        period,
        is_forced: problem.period != Span::Unknown,
        state: guess.nodes[0].clone(),
        residual: *residual,
        iterations: *iterations,
        multipliers,
        stability,
        notes,
        motion,
    })
}

/// Returns the states of a run, row after row.
fn rows(run: &Trajectory) -> Vec<Vec<f64>> {
    let columns: Vec<_> = run.of_kind(ColumnKind::State).collect();
    let row = |index: usize| columns.iter().map(|column| column.values[index]).collect();
    (0..run.times.len()).map(row).collect()
}
