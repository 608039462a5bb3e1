//! Work-precision measurements: error against work and time.
//!
//! Errors are relative to an independent reference: the emitted code run in numbers of 31 digits
//! or, if that is impossible, a run at the tightest tolerance with which a run by another method
//! agrees. The agreement of both is part of the result, since smaller errors have no meaning.

mod precise;
mod reference;

use std::time::{Duration, Instant};

use machinist_contract::Simulator;
use serde::{Serialize, Serializer};

use crate::double_double::Twin;
use machinist::error::SimulateError;
use machinist::method::{Method, Work};
use machinist::simulate::Simulation;
use machinist::trajectory::{ColumnKind, Trajectory};
pub use reference::Reference;

/// Default tolerances of a measurement, from loose to tight.
pub const TOLERANCES: [f64; 11] =
    [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12];

/// Settings of a measurement.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// Methods.
    pub methods: Vec<Method>,
    /// Relative tolerances, from loose to tight.
    pub tolerances: Vec<f64>,
    /// Number of runs for the median time, unless `enough` ends them earlier.
    pub runs: usize,
    /// Total time of runs after which a point is not timed any more \[ms\].
    pub enough: f64,
    /// Time of a run after which a curve ends \[ms\].
    pub longest: f64,
    /// Limit of the computing time of a run.
    pub time_limit: Option<Duration>,
}

impl Default for Plan {
    /// Selects every method at [`TOLERANCES`], with 25 runs or 300 ms each.
    fn default() -> Self {
        let (methods, tolerances) = (Method::compiled_in().collect(), TOLERANCES.to_vec());
        Self { methods, tolerances, runs: 25, enough: 300.0, longest: 300.0, time_limit: None }
    }
}

/// Error against time of one scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WorkPrecision {
    /// Name of the scene.
    pub scene: String,
    /// Reference of the errors.
    pub reference: Reference,
    /// One for each method.
    pub curves: Vec<Curve>,
}

/// Results of one method at decreasing tolerances.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Curve {
    /// The method.
    pub method: Method,
    /// Points, from loose to tight tolerances.
    pub points: Vec<Point>,
    /// Tolerances at which the method stopped, with reasons.
    pub stopped: Vec<Stop>,
}

/// Result at one tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Point {
    /// Relative tolerance.
    pub rtol: f64,
    /// max over states of max over time |y - reference|/size of the state: its largest value, or
    /// its scale if that value is only rounding.
    #[serde(serialize_with = "finite_or_null")]
    pub error: f64,
    /// Median time of a run \[ms\].
    pub milliseconds: f64,
    /// Work spent on the run.
    pub work: Work,
}

/// A run that stopped.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stop {
    /// Relative tolerance.
    pub rtol: f64,
    /// Time and reason.
    pub reason: String,
}

impl Point {
    /// Returns error over tolerance, which is constant if the method keeps its tolerance.
    #[must_use]
    pub fn proportionality(&self) -> f64 {
        self.error / self.rtol
    }
}

/// Measures a scene with the settings of its spec, against its `twin` in numbers of 31 digits if it
/// has one.
///
/// # Errors
/// [`SimulateError`] if a tolerance is out of range, or if no method completes the run at any tight
/// tolerance, so that there is no reference. A method that stops is not an error but a [`Stop`].
pub fn measure(
    machine: &Simulation<'_>,
    twin: Option<&dyn Twin>,
    plan: &Plan,
) -> Result<WorkPrecision, SimulateError> {
    if let Some(rtol) = plan.tolerances.iter().find(|rtol| !(**rtol > 0.0 && **rtol <= 1.0)) {
        return Err(SimulateError::BadTolerance(*rtol));
    }
    let reference = Reference::of(machine, twin, plan.time_limit)?;
    let curves = plan
        .methods
        .iter()
        .filter(|method| method.suits(machine.simulator()))
        .map(|method| curve(machine, *method, plan, &reference));
    let curves = curves.collect();
    Ok(WorkPrecision { scene: machine.simulator().name().to_owned(), reference, curves })
}

fn curve(machine: &Simulation<'_>, method: Method, plan: &Plan, reference: &Reference) -> Curve {
    let (mut points, mut stopped) = (Vec::new(), Vec::new());
    for rtol in &plan.tolerances {
        // A method that stops at a loose tolerance may complete the run at a tight one.
        match point(machine, method, *rtol, plan, reference) {
            Ok(point) => {
                points.push(point);
                if point.milliseconds > plan.longest {
                    break;
                }
            }
            Err(error) => stopped.push(Stop { rtol: *rtol, reason: error.to_string() }),
        }
    }
    Curve { method, points, stopped }
}

fn point(
    machine: &Simulation<'_>,
    method: Method,
    rtol: f64,
    plan: &Plan,
    reference: &Reference,
) -> Result<Point, SimulateError> {
    let timed = || {
        let start = Instant::now();
        let trajectory = run(machine, method, rtol, plan.time_limit).run()?;
        Ok::<_, SimulateError>((start.elapsed().as_secs_f64() * 1e3, trajectory))
    };
    let (first, trajectory) = timed()?;
    let mut times = Vec::new();
    if first > plan.enough {
        times.push(first);
    }
    // The first of short runs is discarded, since memory and caches are cold.
    while times.len() < plan.runs && times.iter().sum::<f64>() <= plan.enough {
        times.push(timed()?.0);
    }
    times.sort_by(f64::total_cmp);
    let error = reference.distance(&trajectory);
    Ok(Point { rtol, error, milliseconds: times[times.len() / 2], work: trajectory.work })
}

/// Output times of a measured run.
const POINTS: usize = 101;

/// Returns the run of a machine by a method, with its parameters, start and end.
fn run<'a>(
    machine: &Simulation<'a>,
    method: Method,
    rtol: f64,
    time_limit: Option<Duration>,
) -> Simulation<'a> {
    let run = machine.clone().points(POINTS).method(method).rtol(rtol);
    time_limit.into_iter().fold(run, Simulation::time_limit)
}

/// Ratio to its scale below which a state is rounding, so that its own size is no measure.
const ROUNDING: f64 = 1e-12;

/// Reference values of a state over time.
#[derive(Debug, Clone, PartialEq)]
struct KnownState {
    name: String,
    values: Vec<f64>,
    /// Reference of relative errors: its largest value, or its scale if that is only rounding.
    size: f64,
}

impl KnownState {
    fn new(name: String, values: Vec<f64>, scale: f64) -> Self {
        let largest = values.iter().map(|value| value.abs()).fold(0.0, worse);
        let size = if largest <= ROUNDING * scale { scale } else { largest };
        Self { name, values, size }
    }
}

/// Returns the states of a run.
fn states(simulator: &dyn Simulator<f64>, trajectory: &Trajectory) -> Vec<KnownState> {
    let columns = trajectory.of_kind(ColumnKind::State).enumerate();
    let known = columns.map(|(index, column)| {
        let scale = simulator.state_scale(index);
        KnownState::new(column.name.clone(), column.values.clone(), scale)
    });
    known.collect()
}

/// Returns max over states of max over time |a - b|/size of b; NaN if a state is missing or a value
/// is NaN.
fn distance(a: &Trajectory, b: &[KnownState]) -> f64 {
    let of_state = |KnownState { name, values, size }: &KnownState| {
        let Some(ours) = a.column(name) else { return f64::NAN };
        ours.iter().zip(values).map(|(a, b)| (a - b).abs()).fold(0.0, worse) / size
    };
    b.iter().map(of_state).fold(0.0, worse)
}

/// Returns the larger value; NaN if either is NaN.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// JSON has no NaN and no infinity.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands it over so")]
fn finite_or_null<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    value.is_finite().then_some(*value).serialize(serializer)
}

#[cfg(test)]
mod tests;
