//! Extreme cases against all methods: which are right, which refuse, which are wrong.
//!
//! A run that ends is *right* if no state errs by more than [`ALLOWED`] times the
//! relative tolerance, or by once the tolerance for every step where these are more, and
//! by no more than [`LARGEST`], at any of the case's times, relative to the largest value
//! that the state has at them; else it is *wrong*. A run that stops with an error is
//! *refused*. The absolute tolerance of a state is the relative one times that same
//! size, so that small states count like large ones. No run takes more than
//! [`MAX_STEPS`] steps, so none hangs.
//!
//! What is right is told by a closed form, or where there is none by two unrelated
//! methods that agree at tight tolerances; a conservative machine is judged by its
//! energy. To add a case: one line in `src/stability/cases.rs`.

mod cases;
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

/// Errors of a run that is right, in relative tolerances, at any number of steps: errors
/// of steps add up, and ill-conditioned cases enlarge them.
pub const ALLOWED: f64 = 1000.0;

/// Relative error of a run that is right at any tolerance.
pub const LARGEST: f64 = 0.01;

/// A run of the study may take so many steps.
pub const MAX_STEPS: usize = 50_000;

/// What to run.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// The methods.
    pub methods: Vec<Method>,
    /// Relative tolerance of every run.
    pub rtol: f64,
    /// Only cases whose `part: name` contains this text, if any is given.
    pub only: Option<String>,
    /// Steps of the runs that show how far constraints are left; none if 0.
    pub drift_steps: usize,
}

impl Default for Plan {
    /// All cases and methods, at 1e-6.
    fn default() -> Self {
        Self { methods: Method::compiled_in().collect(), rtol: 1e-6, only: None, drift_steps: 0 }
    }
}

/// The outcomes of all cases.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Study {
    /// Relative tolerance of every run.
    pub rtol: f64,
    /// The methods, in the order of the cells.
    pub methods: Vec<Method>,
    /// One for each case.
    pub rows: Vec<Row>,
    /// Orders on the problem of Prothero and Robinson, if all cases were wanted.
    pub orders: Vec<ObservedOrders>,
    /// Runs of very many steps under constraints.
    pub long_runs: Vec<LongRun>,
}

/// One case.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// What is strained.
    pub part: &'static str,
    /// How far.
    pub case: String,
    /// What errors are measured against.
    pub truth: String,
    /// How far two ways to it agree, as errors are measured; 0 for a closed form.
    pub agreement: f64,
    /// One for each method.
    pub cells: Vec<Cell>,
}

/// One case by one method.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Cell {
    /// The method.
    pub method: Method,
    /// How it ended.
    #[serde(flatten)]
    pub outcome: Outcome,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "outcome", rename_all = "snake_case")]
pub enum Outcome {
    /// The error is at most what is allowed.
    Right {
        /// Error over relative tolerance.
        error: f64,
        /// Steps taken.
        steps: u64,
    },
    /// The run stopped with an error.
    Refused {
        /// In one word, for a table.
        word: &'static str,
        /// The error.
        reason: String,
    },
    /// The run ended with a larger error.
    Wrong {
        /// Error over relative tolerance; `null` in JSON if it is no number.
        #[serde(serialize_with = "finite_or_null")]
        error: f64,
        /// Steps taken.
        steps: u64,
    },
}

impl Study {
    /// Outcomes of one method, with their cases.
    pub fn of(&self, method: Method) -> impl Iterator<Item = (&Row, &Outcome)> {
        let cells = move |row: &Row| row.cells.iter().position(|cell| cell.method == method);
        self.rows
            .iter()
            .filter_map(move |row| cells(row).map(|index| (row, &row.cells[index].outcome)))
    }

    /// How many cells of a method are right, refused and wrong.
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

/// Runs every case that is wanted by every method that is.
///
/// # Errors
/// [`SimulateError`] if the tolerance makes no sense, or if what is right in a case
/// cannot be told, which is a defect of the case.
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
    /// Times at which it is judged, the last one its end \[s\].
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

/// Why a run was refused, in one word.
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

/// States at the times of a run, one row a time.
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
