//! Results of a run: times, columns of numbers with names and units, and the work spent.

use std::io;

use serde::Serialize;

use crate::method_table::Method;

/// Maximum number of output times of a run.
pub const MAX_POINTS: usize = 10_000_000;

/// Results of a run. All columns have the length of `times`.
///
/// Columns are found by name, and can be written as a table:
///
/// ```
/// use machinist::{Method, Simulation};
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/oscillator.rs"));
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
///
/// let run = Simulation::new(&Oscillator).method(Method::Dop853).until(2.0).points(3).run()?;
/// assert_eq!(run.times, [0.0, 1.0, 2.0]);
/// let torque = run.find("spring_torque").expect("the scene wants this output");
/// assert_eq!((torque.unit.as_str(), torque.values.len()), ("N m", 3));
/// assert_eq!(run.last("spring_torque"), Some(torque.values[2]));
///
/// let mut table = Vec::new();
/// run.write_csv(&mut table)?;
/// assert!(table.starts_with(b"time [s],rotor.angle [rad],rotor.omega [rad/s],"));
/// # Ok(())
/// # }
/// ```
///
/// Events are listed with their times. A mass bounces on a plate that shakes by 1.7 mm:
///
/// ```
/// use machinist::Simulation;
/// use machinist_scenes::scenes::bouncing_mass::BouncingMass;
///
/// let run = Simulation::new(&BouncingMass).run()?;
/// let bounces: Vec<f64> = run.switches.iter().map(|switch| switch.time).collect();
/// assert!(bounces.len() > 15 && bounces.is_sorted());
/// assert!(bounces.iter().all(|time| (0.0..2.0).contains(time)));
/// # Ok::<(), machinist::SimulateError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Trajectory {
    /// Name of the scene.
    pub scene: String,
    /// Description of the scene in one line.
    pub title: String,
    /// Method used.
    pub method: Method,
    /// Relative tolerance used.
    pub rtol: f64,
    /// Work spent on the run.
    pub work: Work,
    /// Notes of the method on the run, such as which method `auto` chose and why; mostly empty.
    pub notes: Vec<String>,
    /// Time and cause of an early end of the run, if it ended early.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stopped: Option<Stop>,
    /// Events in their order; simultaneous ones are in the order of the spec. A column at the time
    /// of an event has its value from before.
    pub switches: Vec<Switch>,
    /// Largest drift from the constraints, if the machine has any.
    pub drift: Option<Drift>,
    /// Output times \[s\].
    pub times: Vec<f64>,
    /// States, then outputs, then energies, then sensitivities.
    pub columns: Vec<Column>,
    /// Energy balance, if it was requested.
    pub energy_balance: Option<EnergyBalance>,
    /// Estimated errors of the columns, if they were estimated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<ErrorEstimate>,
}

/// Cost of a run. Evaluations are counted here, at the simulator, and not taken from what a solver
/// reports.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Work {
    /// Steps accepted.
    pub steps: u64,
    /// Steps tried and rejected for their error.
    pub rejected: u64,
    /// Evaluations of the right-hand side.
    pub rate_evaluations: u64,
    /// Evaluations of its Jacobian.
    pub jacobian_evaluations: u64,
    /// Factorizations of a step's matrix.
    pub factorizations: u64,
    /// Newton iterations, each with one solution of a factored system.
    pub newton_iterations: u64,
    /// Events that happened.
    pub switches: u64,
}

/// Largest drift of a run. The residual of each constraint is measured by the typical size of its
/// coordinates' motion.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct Drift {
    /// Drift before projection, at the end of a step or within one.
    pub before: f64,
    /// Drift after projection.
    pub after: f64,
}

/// Estimated error of every column of a run.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ErrorEstimate {
    /// Relative tolerance of the second run, if it reached its end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rtol: Option<f64>,
    /// Errors of the columns, in the order of the trajectory; empty if the runs give no estimate.
    pub columns: Vec<ColumnError>,
    /// Reason why the runs give no estimate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unknown: Option<String>,
}

/// Estimated error of one column, in its unit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ColumnError {
    /// Name of the column.
    pub name: String,
    /// Largest error over all times.
    pub largest: f64,
    /// Error at the last time.
    pub last: f64,
}

/// Returns the name of the column of a derivative.
#[must_use]
pub fn sensitivity_name(of: &str, by: &str) -> String {
    ["d(", of, ")/d(", by, ")"].concat()
}

/// Time and cause of an early end of a run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stop {
    /// Time reached \[s\].
    pub time: f64,
    /// Cause, with a hint.
    pub cause: String,
}

/// An event of a run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Switch {
    /// Time \[s\].
    pub time: f64,
    /// Name of the event in the spec.
    pub event: String,
}

impl Switch {
    /// Records that an event has happened.
    pub(crate) fn new(time: f64, event: &str) -> Self {
        tracing::debug!(time, event, "event");
        Self { time, event: event.to_owned() }
    }
}

/// A quantity over time.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Column {
    /// Name in the spec, such as `motor.omega`; energies are called `energy.total` and so on.
    pub name: String,
    /// SI unit; `1` for a dimensionless quantity.
    pub unit: String,
    /// Kind of the quantity.
    pub kind: ColumnKind,
    /// Description in one sentence.
    pub doc: String,
    /// Values at the times of the trajectory.
    pub values: Vec<f64>,
}

/// Kind of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum ColumnKind {
    /// A coordinate, a velocity or a first-order state.
    State,
    /// An output. At a jump it has its value from the right.
    Output,
    /// An energy of the whole machine.
    Energy,
    /// Derivative of a state or an output by a parameter or an initial value,
    /// `d(coupling.twist)/d(coupling.stiffness)`.
    Sensitivity,
    /// Measured data.
    Measured,
}

/// The energy balance of a run: the energy stored must be the energy supplied, less the energy
/// dissipated,
///
/// ```text
/// residual(t) = E(t) - E(from) - W_supplied(t) + W_dissipated(t)
/// ```
///
/// with E = T + V + stored, and W the integrals over time of the power supplied and dissipated,
/// integrated alongside the states. The residual of an exact run is zero, so it measures the error
/// of equations and integration together. The balance assumes a continuous E: a spring whose
/// stiffness jumps while it is bent causes a residual. All values are in J.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct EnergyBalance {
    /// W_supplied at the trajectory's times.
    pub supplied: Vec<f64>,
    /// W_dissipated.
    pub dissipated: Vec<f64>,
    /// Integral of |P_supplied| + |P_dissipated|: the energy that has passed.
    pub passed: Vec<f64>,
    /// E(t) - E(from) - W_supplied + W_dissipated.
    pub residual: Vec<f64>,
    /// Largest energy in motion or in the first-order states, max |T| + |stored|.
    pub largest_active: f64,
}

impl EnergyBalance {
    /// Returns max |`residual`(t)| divided by the energy passed until the end of the run, or by
    /// `largest_active` if that is larger. A closed or nearly closed machine is thus measured by
    /// the energy that it exchanges internally. The result is 0 for a machine at rest.
    #[must_use]
    pub fn max_residual_relative(&self) -> f64 {
        let passed = self.passed.last().copied().unwrap_or(0.0);
        let scale = passed.max(self.largest_active);
        let largest = self.residual.iter().fold(0.0, |max: f64, value| max.max(value.abs()));
        if scale > 0.0 { largest / scale } else { largest }
    }
}

impl Trajectory {
    /// Returns the values of the column of this name. If a state and an output have the same name,
    /// returns those of the state.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        self.find(name).map(|column| column.values.as_slice())
    }

    /// Returns the column of this name.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name == name)
    }

    /// Returns the columns of one kind, in order.
    pub fn of_kind(&self, kind: ColumnKind) -> impl Iterator<Item = &Column> {
        self.columns.iter().filter(move |column| column.kind == kind)
    }

    /// Returns d(of)/d(by) of a state or an output, if it was requested.
    #[must_use]
    pub fn sensitivity(&self, of: &str, by: &str) -> Option<&[f64]> {
        self.column(&sensitivity_name(of, by))
    }

    /// Returns the value of a column at the end of the run.
    #[must_use]
    pub fn last(&self, name: &str) -> Option<f64> {
        self.column(name)?.last().copied()
    }

    /// Writes a table: a header `time [s],motor.omega [rad/s],...`, then one line per time, with
    /// each number in the shortest form that reads back the same.
    ///
    /// # Errors
    /// Whatever `writer` reports.
    pub fn write_csv(&self, writer: impl io::Write) -> io::Result<()> {
        let mut csv = csv::Writer::from_writer(writer);
        let header = self.columns.iter().map(|column| format!("{} [{}]", column.name, column.unit));
        csv.write_record(std::iter::once("time [s]".to_owned()).chain(header))?;
        let mut line = Vec::with_capacity(self.columns.len() + 1);
        for (row, time) in self.times.iter().enumerate() {
            line.clear();
            line.push(*time);
            line.extend(self.columns.iter().map(|column| column.values[row]));
            csv.serialize(&line)?;
        }
        csv.flush()
    }

    /// Writes one JSON object: scene, method, work, times, columns. JSON has neither NaN nor
    /// infinity; such values of outputs become `null`.
    ///
    /// # Errors
    /// Whatever `writer` reports.
    pub fn write_json(&self, mut writer: impl io::Write) -> io::Result<()> {
        serde_json::to_writer_pretty(&mut writer, self)?;
        writeln!(writer)
    }
}
