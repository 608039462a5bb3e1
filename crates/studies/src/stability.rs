//! Extreme cases for all methods: right, refused or wrong results.
//!
//! A complete run is *right* if no state errs by more than [`ALLOWED`] times the relative tolerance
//! (or by once the tolerance for every step, if that is more), and by no more than [`LARGEST`], at
//! any of the case's times, relative to the largest value of the state at them; otherwise it is
//! *wrong*. A run that stops with an error is *refused*. The absolute tolerance of a state is the
//! relative one times that same size, so small states count like large ones. No run takes more than
//! [`MAX_STEPS`] steps, so none hangs.
//!
//! The reference is a closed form or, where there is none, two unrelated methods that agree at
//! tight tolerances; a conservative machine is judged by its energy. To add a case, add one line to
//! `src/stability/cases.rs`, or to `contacts.rs` beside it for contact, winders and fields.

mod cases;
mod contacts;
mod drift;
pub mod machines;
mod order;
mod truth;

use machinist_contract::Simulator;
use serde::{Serialize, Serializer};

pub use drift::{LongRun, constraint_drift};
use machinist::error::{SimulateError, StopCause};
use machinist::method::Method;
use machinist::simulate::Simulation;
use machinist::trajectory::{ColumnKind, Trajectory};
pub use order::{ObservedOrders, POWERS, observed_orders};
use truth::{Known, Truth};

/// Maximum error of a right run in relative tolerances, for any number of steps: errors of steps
/// add up, and ill-conditioned cases amplify them.
pub const ALLOWED: f64 = 1000.0;

/// Maximum relative error of a right run at any tolerance.
pub const LARGEST: f64 = 0.01;

/// Maximum number of steps of a run.
pub const MAX_STEPS: usize = 50_000;

/// Selection of cases and methods.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// Methods.
    pub methods: Vec<Method>,
    /// Relative tolerance of every run.
    pub rtol: f64,
    /// Text that `part: name` of a case must contain, if given.
    pub only: Option<String>,
    /// Number of steps of the runs that measure drift from constraints; none if 0.
    pub drift_steps: usize,
}

impl Default for Plan {
    /// Selects all cases and methods, at 1e-6.
    fn default() -> Self {
        Self { methods: Method::compiled_in().collect(), rtol: 1e-6, only: None, drift_steps: 0 }
    }
}

/// Results of all cases.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Study {
    /// Relative tolerance of every run.
    pub rtol: f64,
    /// Methods, in the order of the cells.
    pub methods: Vec<Method>,
    /// One for each case.
    pub rows: Vec<Row>,
    /// Orders observed on the Prothero-Robinson problem, if all cases were selected.
    pub orders: Vec<ObservedOrders>,
    /// Runs with very many steps under constraints.
    pub long_runs: Vec<LongRun>,
}

/// Results of one case.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// Aspect that is strained.
    pub part: &'static str,
    /// Degree of strain.
    pub case: String,
    /// Reference of errors.
    pub truth: String,
    /// Difference between two ways to the reference, in the measure of errors; 0 for a closed form.
    pub agreement: f64,
    /// One for each method.
    pub cells: Vec<Cell>,
}

/// Result of one case by one method.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Cell {
    /// The method.
    pub method: Method,
    /// Result of the run.
    #[serde(flatten)]
    pub outcome: Outcome,
}

/// Result of a run.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "outcome", rename_all = "snake_case")]
pub enum Outcome {
    /// The error is within the limit.
    Right {
        /// Error over relative tolerance.
        error: f64,
        /// Number of steps taken.
        steps: u64,
    },
    /// The run stopped with an error.
    Refused {
        /// Reason in one word, for a table.
        word: &'static str,
        /// The error.
        reason: String,
    },
    /// The error exceeds the limit.
    Wrong {
        /// Error over relative tolerance; `null` in JSON if it is not finite.
        #[serde(serialize_with = "finite_or_null")]
        error: f64,
        /// Number of steps taken.
        steps: u64,
    },
}

impl Study {
    /// Returns the results of one method, with their cases.
    pub fn of(&self, method: Method) -> impl Iterator<Item = (&Row, &Outcome)> {
        let cells = move |row: &Row| row.cells.iter().position(|cell| cell.method == method);
        self.rows
            .iter()
            .filter_map(move |row| cells(row).map(|index| (row, &row.cells[index].outcome)))
    }

    /// Returns the numbers of right, refused and wrong cells of a method.
    #[must_use]
    pub fn counts(&self, method: Method) -> [usize; 3] {
        let mut counts = [0; 3];
        for (_, outcome) in self.of(method) {
            counts[match outcome {
                Outcome::Right { .. } => 0,
                Outcome::Refused { .. } => 1,
                Outcome::Wrong { .. } => 2,
            }] += 1;
        }
        counts
    }
}

/// Runs every selected case by every selected method.
///
/// # Errors
/// [`SimulateError`] if the tolerance is out of range, or if the reference of a case cannot be
/// computed, which is a defect of the case.
pub fn study(plan: &Plan) -> Result<Study, SimulateError> {
    if !(plan.rtol > 0.0 && plan.rtol <= 1.0) {
        return Err(SimulateError::BadTolerance(plan.rtol));
    }
    let wanted = |case: &Case| {
        let name = || format!("{}: {}", case.part, case.name);
        plan.only.as_ref().is_none_or(|text| name().contains(text.as_str()))
    };
    let cases = cases::all();
    let rows = cases.iter().filter(|case| wanted(case)).map(|case| case.row(plan));
    let rows = rows.collect::<Result<_, _>>()?;
    let orders = if plan.only.is_none() { observed_orders() } else { Vec::new() };
    let long_runs = match plan.drift_steps {
        0 => Vec::new(),
        steps => constraint_drift(plan.rtol, steps)?,
    };
    Ok(Study { rtol: plan.rtol, methods: plan.methods.clone(), rows, orders, long_runs })
}

/// A run that strains methods.
struct Case {
    part: &'static str,
    name: String,
    simulator: &'static dyn Simulator<f64>,
    settings: Vec<(&'static str, f64)>,
    /// Times at which it is judged, the last of which is its end \[s\].
    times: Vec<f64>,
    truth: Truth,
}

impl Case {
    fn row(&self, plan: &Plan) -> Result<Row, SimulateError> {
        let known = self.truth.find(self)?;
        let cells = plan.methods.iter().map(|method| {
            let outcome = self.outcome(*method, plan.rtol, &known)?;
            Ok(Cell { method: *method, outcome })
        });
        let cells = cells.collect::<Result<_, SimulateError>>()?;
        let (case, truth) = (self.name.clone(), known.name);
        Ok(Row { part: self.part, case, truth, agreement: known.agreement, cells })
    }

    fn outcome(&self, method: Method, rtol: f64, known: &Known) -> Result<Outcome, SimulateError> {
        let atol: Vec<f64> = known.sizes.iter().map(|size| rtol * size).collect();
        let run = self.simulation()?.method(method).rtol(rtol).atol(&atol).max_steps(MAX_STEPS);
        Ok(match run.run() {
            Ok(run) => {
                let error = known.error(self, &run) / rtol;
                let steps = run.work.steps;
                if error <= ALLOWED.max(steps as f64).min(LARGEST / rtol) {
                    Outcome::Right { error, steps }
                } else {
                    Outcome::Wrong { error, steps }
                }
            }
            Err(error) => Outcome::Refused {
                word: word(&error, method, self.simulator),
                reason: error.to_string(),
            },
        })
    }

    fn simulation(&self) -> Result<Simulation<'static>, SimulateError> {
        let until = self.times.last().copied().unwrap_or_default();
        let base = Simulation::new(self.simulator).until(until).times(&self.times);
        self.settings.iter().try_fold(base, |run, (name, value)| run.parameter(name, *value))
    }
}

/// Returns in one word why a run was refused.
fn word(error: &SimulateError, method: Method, simulator: &dyn Simulator<f64>) -> &'static str {
    match error {
        _ if !method.suits(simulator) => "unfit",
        SimulateError::Stopped { cause, .. } => match cause {
            StopCause::TooManySteps { .. } | StopCause::TooSlowPace { .. } => "steps",
            StopCause::StepTooSmall => "small",
            StopCause::NotFinite { .. } => "nan",
            StopCause::Newton => "newton",
            StopCause::ToleranceBelowRounding { .. } | StopCause::ClosedForm { .. } => "rounding",
            StopCause::Overflow { .. } => "grows",
            StopCause::Contradiction { .. } => "modes",
            StopCause::Chattering { .. } => "chatters",
            StopCause::Zeno { .. } => "zeno",
            StopCause::OffConstraint { .. } | StopCause::Overdetermined { .. } => "drift",
            StopCause::TooLarge { .. } => "large",
            StopCause::Unsuitable(_) => "unfit",
            _ => "solver",
        },
        _ => "input",
    }
}

/// Returns the states at the times of a run, one row per time.
fn states(run: &Trajectory) -> Vec<Vec<f64>> {
    let columns: Vec<_> = run.of_kind(ColumnKind::State).collect();
    let row = |time| columns.iter().map(|column| column.values[time]).collect();
    (0..run.times.len()).map(row).collect()
}

/// JSON has no NaN and no infinity.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands it over so")]
fn finite_or_null<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    value.is_finite().then_some(*value).serialize(serializer)
}
