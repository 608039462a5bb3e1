//! Error against work and time: what each method pays for accuracy.
//!
//! Errors are against a reference that is no part of what is measured: the emitted
//! code run in numbers of 31 digits, or where it has no such run, one at the tightest
//! tolerance that a run by another method agrees with. How far the two agree is part
//! of the answer, since no error below that means anything.

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

/// Tolerances of a measurement, from loose to tight, unless told otherwise.
pub const TOLERANCES: [f64; 11] =
    [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12];

/// What to measure.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// The methods.
    pub methods: Vec<Method>,
    /// Relative tolerances, from loose to tight.
    pub tolerances: Vec<f64>,
    /// Runs of which the median time counts, unless `enough` ends them before.
    pub runs: usize,
    /// A point is timed no more once its runs together took longer than this \[ms\].
    pub enough: f64,
    /// A curve ends once a run takes longer than this \[ms\].
    pub longest: f64,
    /// How long a run may compute at all.
    pub time_limit: Option<Duration>,
}

impl Default for Plan {
    /// Every method at [`TOLERANCES`], 25 runs or 300 ms each.
    fn default() -> Self {
        let (methods, tolerances) = (Method::compiled_in().collect(), TOLERANCES.to_vec());
        Self { methods, tolerances, runs: 25, enough: 300.0, longest: 300.0, time_limit: None }
    }
}

/// Error against time of one scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WorkPrecision {
    /// The scene.
    pub scene: String,
    /// What errors are measured against.
    pub reference: Reference,
    /// One for each method.
    pub curves: Vec<Curve>,
}

/// One method at falling tolerances.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Curve {
    /// The method.
    pub method: Method,
    /// From loose to tight.
    pub points: Vec<Point>,
    /// Tolerances at which the method could not go on, and why.
    pub stopped: Vec<Stop>,
}

/// One tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Point {
    /// Relative tolerance.
    pub rtol: f64,
    /// max over states of max over time |y - reference|/size of the state: its largest value, or
    /// its scale if that is only rounding.
    #[serde(serialize_with = "finite_or_null")]
    pub error: f64,
    /// Median time of a run \[ms\].
    pub milliseconds: f64,
    /// What the run cost.
    pub work: Work,
}

/// A run that could not go on.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stop {
    /// Relative tolerance.
    pub rtol: f64,
    /// Where and why.
    pub reason: String,
}

impl Point {
    /// Error over tolerance: the same at all tolerances if the method keeps what
    /// it is asked for.
    #[must_use]
    pub fn proportionality(&self) -> f64 {
        self.error / self.rtol
    }
}

/// Measures a scene as its spec runs it, against its `twin` in numbers of 31 digits if
/// it has one.
///
/// # Errors
/// [`SimulateError`] if a tolerance makes no sense, or if no method gets through
/// the run at any tight tolerance, so that there is no reference. A method that
/// cannot go on is no error but a [`Stop`].
pub fn measure(
    simulator: &dyn Simulator<f64>,
    twin: Option<&dyn Twin>,
    plan: &Plan,
) -> Result<WorkPrecision, SimulateError> {
    if let Some(rtol) = plan.tolerances.iter().find(|rtol| !(**rtol > 0.0 && **rtol <= 1.0)) {
        return Err(SimulateError::BadTolerance(*rtol));
    }
    let reference = Reference::of(simulator, twin, plan.time_limit)?;
    let curves = plan
        .methods
        .iter()
        .filter(|method| method.suits(simulator))
        .map(|method| curve(simulator, *method, plan, &reference));
    let curves = curves.collect();
    Ok(WorkPrecision { scene: simulator.name().to_owned(), reference, curves })
}

fn curve(
    simulator: &dyn Simulator<f64>,
    method: Method,
    plan: &Plan,
    reference: &Reference,
) -> Curve {
    let (mut points, mut stopped) = (Vec::new(), Vec::new());
    for rtol in &plan.tolerances {
        // A method that cannot go on at a loose tolerance may at a tight one.
        match point(simulator, method, *rtol, plan, reference) {
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
    simulator: &dyn Simulator<f64>,
    method: Method,
    rtol: f64,
    plan: &Plan,
    reference: &Reference,
) -> Result<Point, SimulateError> {
    let timed = || {
        let start = Instant::now();
        let trajectory = run(simulator, method, rtol, plan.time_limit).run()?;
        Ok::<_, SimulateError>((start.elapsed().as_secs_f64() * 1e3, trajectory))
    };
    let (first, trajectory) = timed()?;
    let mut times = Vec::new();
    if first > plan.enough {
        times.push(first);
    }
    // The first of short runs does not count: it finds memory and caches cold.
    while times.len() < plan.runs && times.iter().sum::<f64>() <= plan.enough {
        times.push(timed()?.0);
    }
    times.sort_by(f64::total_cmp);
    let error = reference.distance(&trajectory);
    Ok(Point { rtol, error, milliseconds: times[times.len() / 2], work: trajectory.work })
}

/// Output times of a measured run.
const POINTS: usize = 101;

fn run(
    simulator: &dyn Simulator<f64>,
    method: Method,
    rtol: f64,
    time_limit: Option<Duration>,
) -> Simulation<'_> {
    let run = Simulation::new(simulator).points(POINTS).method(method).rtol(rtol);
    time_limit.into_iter().fold(run, Simulation::time_limit)
}

/// Beside its scale, a state that stays below this is rounding: its own size is no measure.
const ROUNDING: f64 = 1e-12;

/// A state over time, as a reference knows it.
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

/// The states of a run.
fn states(simulator: &dyn Simulator<f64>, trajectory: &Trajectory) -> Vec<KnownState> {
    let columns = trajectory.of_kind(ColumnKind::State).enumerate();
    let known = columns.map(|(index, column)| {
        let scale = simulator.state_scale(index);
        KnownState::new(column.name.clone(), column.values.clone(), scale)
    });
    known.collect()
}

/// max over states of max over time |a - b|/size of b; NaN if a state is missing or a value is no
/// number.
fn distance(a: &Trajectory, b: &[KnownState]) -> f64 {
    let of_state = |KnownState { name, values, size }: &KnownState| {
        let Some(ours) = a.column(name) else { return f64::NAN };
        ours.iter().zip(values).map(|(a, b)| (a - b).abs()).fold(0.0, worse) / size
    };
    b.iter().map(of_state).fold(0.0, worse)
}

/// The larger; NaN if either is.
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
