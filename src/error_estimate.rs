//! Global error of a run, estimated from a second run at a tighter tolerance.
//!
//! The error of a result is proportional to the tolerance of the steps, or nearly so. With the
//! results y of a run and z of one at a tolerance [`REFINEMENT`] times as tight, both at the same
//! times, the error of y is
//!
//! ```text
//! e = |y - z| r/(r - 1),    r = REFINEMENT
//! ```
//!
//! and no less than the rounding of the largest value. A ratio above r overestimates it by at most
//! twice. The estimate covers the integration in time alone: not the elements of a field, the
//! digits of a parameter, or the spec itself.

use crate::error::{SimulateError, StopCause};
use crate::method::taylor::LEAST_RTOL;
pub use crate::method::tolerance::REFINEMENT;
use crate::simulate::Simulation;
use crate::trajectory::{Column, ColumnKind, Switch, Trajectory};
pub use crate::trajectory::{ColumnError, ErrorEstimate};

/// Maximum number of runs of [`Simulation::run_to_accuracy`]. Where the error falls only as the
/// square root of the tolerance, each run halves the missing decades: of sixteen, the digits of a
/// number, eight runs leave a sixteenth of one.
const ATTEMPTS: usize = 8;

/// Fraction of the accuracy that the next attempt aims at. Errors are only nearly proportional to
/// tolerances, and with this margin the attempt meets the accuracy at once.
const AIM: f64 = 0.5;

/// Smallest ratio of the tolerances of two attempts. An error as large as the motion is not
/// proportional to the tolerance, and tells little about the one that is needed.
const FURTHEST: f64 = 1e-4;

/// Ratio of tolerances by which an error that is not noise falls below a quarter of the value.
const IF_NOISE: f64 = 1e-2;

/// Number of attempts in a row that may reduce the error no further. Steps that end at events and
/// jumps become shorter only at a much tighter tolerance, so each such attempt tightens it by a
/// decade more.
const IDLE_ATTEMPTS: i32 = 3;

/// Tightest tolerance of an attempt, at which both runs are possible.
const LEAST_ATTEMPTED: f64 = 2.0 * REFINEMENT * LEAST_RTOL;

/// Fraction of the largest value in a unit that may be rounding in another column of that unit,
/// after the sums of up to sixteen terms that outputs of a machine rarely exceed.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A run whose estimated error is below a requested accuracy.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct AccurateRun {
    /// The run; its `rtol` is the tolerance that was needed.
    pub trajectory: Trajectory,
    /// Its estimated error.
    pub error: ErrorEstimate,
    /// Reason why the accuracy is not met, if it is not.
    pub shortfall: Option<String>,
}

impl ErrorEstimate {
    /// Estimates the error of `run` from [`Simulation::refined`], a run at a tighter tolerance.
    #[must_use]
    pub fn of(run: &Trajectory, refined: &Result<Trajectory, SimulateError>) -> Self {
        let rtol = refined.as_ref().ok().map(|refined| refined.rtol);
        let unknown = |reason: String| Self { rtol, columns: Vec::new(), unknown: Some(reason) };
        let refined = match refined {
            Ok(refined) => refined,
            Err(error) => {
                return unknown(format!("the second run, at a tighter tolerance, fails: {error}"));
            }
        };
        if let Some(reason) = other_events(&run.switches, &refined.switches) {
            return unknown(reason);
        }
        // A closed form evaluates the rate once per segment, a stepping method more often; only the
        // latter has errors of steps.
        let has_steps = run.work.rate_evaluations > run.work.steps;
        let may_be_alike = has_steps && refined.rtol < LEAST_RTOL && moves(run);
        if may_be_alike && run.columns == refined.columns {
            let reason = "steps are as tight as possible at both tolerances";
            return unknown(reason.to_owned());
        }
        let columns = run.columns.iter().zip(&refined.columns).map(|(column, finer)| {
            let error = |(value, finer): (&f64, &f64)| {
                let off = (value - finer).abs() * REFINEMENT / (REFINEMENT - 1.0);
                // NaN beside NaN is not an error.
                if value.is_nan() && finer.is_nan() { 0.0 } else { off }
            };
            let errors = || column.values.iter().zip(&finer.values).map(error);
            let rounding = f64::EPSILON * size(&column.values);
            let largest =
                errors().fold(rounding, |most, error| if error <= most { most } else { error });
            let last = errors().next_back().map_or(rounding, |last| last.max(rounding));
            ColumnError { name: column.name.clone(), largest, last }
        });
        Self { rtol, columns: columns.collect(), unknown: None }
    }

    /// Returns the estimate for the column of this name.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<&ColumnError> {
        self.columns.iter().find(|column| column.name == name)
    }
}

/// True if any column changes over time.
fn moves(run: &Trajectory) -> bool {
    let is_constant =
        |values: &[f64]| values.iter().all(|value| value.to_bits() == values[0].to_bits());
    !run.columns.iter().all(|column| is_constant(&column.values))
}

/// Returns why the events of two runs cannot be compared, if they differ.
fn other_events(run: &[Switch], refined: &[Switch]) -> Option<String> {
    let differ = run.iter().zip(refined).find(|(a, b)| a.event != b.event).map(|(a, _)| a);
    let differ = differ.or_else(|| run.get(refined.len())).or_else(|| refined.get(run.len()))?;
    Some(format!(
        "from event `{}` at {} s on, a run at a tighter tolerance has different events ({} in all, \
         not {}): they depend on rounding",
        differ.event,
        differ.time,
        refined.len(),
        run.len()
    ))
}

impl Simulation<'_> {
    /// Returns the same run at tolerances tighter by [`REFINEMENT`] than those that its steps keep,
    /// for [`ErrorEstimate::of`].
    pub fn refined(&self) -> Self {
        let kept = self.method_and_step_rtol();
        let rtol = kept.map_or_else(|_| self.relative_tolerance(), |(_, rtol)| rtol);
        self.clone().at_tolerance(rtol / REFINEMENT).with_shortened_steps()
    }

    /// Estimates the error of a run by a second one. Both runs can be made on two threads by means
    /// of [`Simulation::refined`].
    ///
    /// ```
    /// use machinist::{Method, Simulation};
    /// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/oscillator.rs"));
    /// # fn main() -> Result<(), machinist::SimulateError> {
    /// let simulation = Simulation::new(&Oscillator).rtol(1e-6).method(Method::Dop853);
    /// let run = simulation.run()?;
    /// let error = simulation.error_estimate(&run);
    /// let angle = error.column("rotor.angle").expect("the scene has this state");
    /// assert!(angle.largest < 1e-4);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn error_estimate(&self, run: &Trajectory) -> ErrorEstimate {
        ErrorEstimate::of(run, &self.refined().run())
    }

    /// Runs at increasingly tight tolerances until the estimated error of every column is at most
    /// `accuracy` times its largest value. If that is not met, or an attempt fails after others
    /// worked, returns the attempt with the smallest error, and the reason.
    ///
    /// # Errors
    /// As for [`Simulation::run`], of the first attempt or by an interruption;
    /// [`SimulateError::BadAccuracy`] if the accuracy is not above 0 and at most 1.
    pub fn run_to_accuracy(&self, accuracy: f64) -> Result<AccurateRun, SimulateError> {
        self.run_to_accuracy_by(accuracy, |simulation| {
            let trajectory = simulation.run()?;
            let error = simulation.error_estimate(&trajectory);
            Ok((trajectory, error))
        })
    }

    /// Does the same as [`Simulation::run_to_accuracy`], with runs and estimates made by the
    /// caller, for example on two threads.
    ///
    /// # Errors
    /// As for [`Simulation::run_to_accuracy`].
    pub fn run_to_accuracy_by(
        &self,
        accuracy: f64,
        mut estimated: impl FnMut(&Self) -> Result<(Trajectory, ErrorEstimate), SimulateError>,
    ) -> Result<AccurateRun, SimulateError> {
        if !(accuracy > 0.0 && accuracy <= 1.0) {
            return Err(SimulateError::BadAccuracy(accuracy));
        }
        let mut rtol = self.relative_tolerance();
        let (mut best, mut attempts, mut idle) = (None::<Attempt>, 0, 0);
        let mut noise = Noise { energy: self.typical_energy()?, ..Noise::default() };
        loop {
            attempts += 1;
            let found = estimated(&self.clone().at_tolerance(rtol));
            if let Some(reason) = failure(&found)
                && let Some(best) = best
            {
                return Ok(best.short(&format!("the attempt at rtol {rtol:e} failed: {reason}")));
            }
            let (trajectory, error) = found?;
            if noise.finds((&trajectory, &error), accuracy) {
                best = None;
            }
            let (name, part) = noise.worst(&trajectory, &error);
            if error.unknown.is_some() || part <= accuracy {
                let shortfall = error.unknown.clone();
                return Ok(AccurateRun { trajectory, error, shortfall });
            }
            let is_better = best.as_ref().is_none_or(|best| part < best.part);
            idle = if is_better { 0 } else { idle + 1 };
            let factor =
                if noise.suspected.contains(&name) { IF_NOISE } else { AIM * accuracy / part };
            let factor = factor.max(FURTHEST);
            let wanted = rtol * factor;
            let next = one_digit((wanted * 0.1f64.powi(idle)).max(LEAST_ATTEMPTED));
            let reason = if !part.is_finite() {
                Some("it is not a number")
            } else if idle == IDLE_ATTEMPTS {
                Some("a tighter tolerance does not reduce the error")
            } else if wanted < LEAST_ATTEMPTED || next >= rtol {
                Some("the tolerance that this needs is below rounding")
            } else if attempts == ATTEMPTS {
                Some("all attempts are used up")
            } else {
                None
            };
            let this = Attempt { trajectory, error, name, part };
            let kept = best.filter(|_| !is_better).unwrap_or(this);
            if let Some(reason) = reason {
                return Ok(kept.short(reason));
            }
            (best, rtol) = (Some(kept), next);
        }
    }
}

/// An attempt that misses the accuracy.
struct Attempt {
    trajectory: Trajectory,
    error: ErrorEstimate,
    /// Column with the largest error, relative to its largest value, and that error.
    name: String,
    part: f64,
}

impl Attempt {
    /// Returns the run, with the reason for which no further attempt is made.
    fn short(self, reason: &str) -> AccurateRun {
        let Self { trajectory, error, name, part } = self;
        let shortfall = format!(
            "the error of `{name}` is {part:.1e} of its largest value at rtol {:e}: {reason}",
            trajectory.rtol
        );
        AccurateRun { trajectory, error, shortfall: Some(shortfall) }
    }
}

/// Returns why an attempt has no estimate, unless it was interrupted.
fn failure(attempt: &Result<(Trajectory, ErrorEstimate), SimulateError>) -> Option<String> {
    match attempt {
        Ok((_, error)) => error.unknown.clone(),
        Err(SimulateError::Stopped { cause: StopCause::Interrupted, .. }) => None,
        Err(error) => Some(error.to_string()),
    }
}

/// Columns that are zero but for errors, such as a motion across a plane of symmetry, or the energy of
/// a pendulum that starts at its level of reference.
///
/// The error of such a column is as large as its value at every tolerance. It counts as zero after two
/// attempts if it is below the accuracy times the largest column in its unit.
#[derive(Default)]
struct Noise {
    /// Typical energy of the machine \[J\].
    energy: f64,
    /// Names of columns that were all error in the last attempt, and of those that count as zero.
    suspected: Vec<String>,
    known: Vec<String>,
}

impl Noise {
    /// Takes an attempt; returns whether further columns count as zero from now on.
    fn finds(&mut self, (run, error): (&Trajectory, &ErrorEstimate), accuracy: f64) -> bool {
        /// Fraction of a value above which it is all error.
        const ALL: f64 = 0.25;
        let is_noise = |(error, column): &(&ColumnError, &Column)| {
            let size = size(&column.values);
            error.largest > ALL * size && size <= accuracy * self.largest(run, column)
        };
        let columns = error.columns.iter().zip(&run.columns).filter(is_noise);
        let found: Vec<String> = columns.map(|(_, column)| column.name.clone()).collect();
        let is_new = |name: &&String| self.suspected.contains(name) && !self.known.contains(name);
        let new: Vec<String> = found.iter().filter(is_new).cloned().collect();
        let is_any = !new.is_empty();
        self.known.extend(new);
        self.suspected = found;
        is_any
    }

    /// Returns the name of the column with the largest relative error, and that error. Columns that
    /// count as zero or consist only of rounding errors of others in their unit are ignored.
    fn worst(&self, run: &Trajectory, error: &ErrorEstimate) -> (String, f64) {
        let part = |error: &ColumnError, column: &Column| {
            let size = size(&column.values);
            let counts = size > ROUNDING * self.largest(run, column);
            if counts && !self.known.contains(&column.name) { error.largest / size } else { 0.0 }
        };
        let columns = error.columns.iter().zip(&run.columns);
        let parts = columns.map(|(error, column)| (error.name.clone(), part(error, column)));
        parts.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default()
    }

    /// Returns the largest value of all columns in the unit of one.
    fn largest(&self, run: &Trajectory, column: &Column) -> f64 {
        let least = if column.kind == ColumnKind::Energy { self.energy } else { 0.0 };
        let alike = run.columns.iter().filter(|other| other.unit == column.unit);
        alike.map(|other| size(&other.values)).fold(least, f64::max)
    }
}

/// Returns the largest number of one decimal digit that is at most `value`.
fn one_digit(value: f64) -> f64 {
    let exponent = value.log10().floor() as i32;
    let digit = (value / 10f64.powi(exponent)).floor().max(1.0);
    // Parsing the decimal avoids the rounding of a product.
    format!("{digit}e{exponent}").parse().unwrap_or(value)
}

/// Returns the largest absolute value of a column.
fn size(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
}
