//! What a run leaves: times, columns of numbers with names and units, and the
//! work it took.

use std::io;

use serde::Serialize;

use crate::constraints::Drift;
use crate::error_estimate::ErrorEstimate;
use crate::method::{Method, Work};

/// The result of a run. All columns are as long as `times`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Trajectory {
    /// The scene's name.
    pub scene: String,
    /// The scene in one line.
    pub title: String,
    /// The method used.
    pub method: Method,
    /// Relative tolerance used.
    pub rtol: f64,
    /// What the run cost.
    pub work: Work,
    /// What the method has to say of the run, such as which one `auto` chose and
    /// why; mostly nothing.
    pub notes: Vec<String>,
    /// Where and why the run ended before its end; nothing if it did not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stopped: Option<Stop>,
    /// Events that happened, in order; those at one time in the order of the spec. A
    /// column at just that time has its value from before.
    pub switches: Vec<Switch>,
    /// How far the machine came off its constraints, if it has any.
    pub drift: Option<Drift>,
    /// Output times \[s\].
    pub times: Vec<f64>,
    /// States, then outputs, then energies, then sensitivities.
    pub columns: Vec<Column>,
    /// Power supplied and lost against energy stored, if the run was asked for it.
    pub energy_balance: Option<EnergyBalance>,
    /// Estimated error of the columns, where somebody has estimated it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<ErrorEstimate>,
}

/// The name of the column of a derivative.
#[must_use]
pub fn sensitivity_name(of: &str, by: &str) -> String {
    ["d(", of, ")/d(", by, ")"].concat()
}

/// Why a run ended before its end.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stop {
    /// Time reached \[s\].
    pub time: f64,
    /// Why, and what may help.
    pub cause: String,
}

/// An event that happened.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Switch {
    /// When \[s\].
    pub time: f64,
    /// The spec's name of the event.
    pub event: String,
}

/// One quantity over time.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Column {
    /// The spec's name, `motor.omega`; energies are called `energy.total` and so on.
    pub name: String,
    /// SI unit; `1` for a pure number.
    pub unit: String,
    /// What the column is.
    pub kind: ColumnKind,
    /// One sentence of meaning.
    pub doc: String,
    /// Values at the trajectory's times.
    pub values: Vec<f64>,
}

/// What a column is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ColumnKind {
    /// A coordinate, a velocity or a first-order state.
    State,
    /// A wanted output. At a jump it has its value from the right.
    Output,
    /// An energy of the whole machine.
    Energy,
    /// Derivative of a state or an output by a parameter or an initial value,
    /// `d(coupling.twist)/d(coupling.stiffness)`.
    Sensitivity,
    /// What was measured.
    Measured,
}

/// The energy account of a run: what a machine stores must be what it was
/// supplied with, less what it lost,
///
/// ```text
/// residual(t) = E(t) - E(from) - W_supplied(t) + W_dissipated(t)
/// ```
///
/// with E = T + V + stored, and W the integrals over time of the power supplied
/// and dissipated, integrated alongside the states. The residual of an exact
/// run is zero; what remains measures equations and integration together. It
/// takes E to be continuous: a spring whose stiffness jumps while it is bent
/// shows up as a residual. All in J.
#[derive(Debug, Clone, PartialEq, Serialize)]
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
    /// max over t of |residual(t)|, divided by the energy passed until the end of
    /// the run; by `largest_active` where that is larger, so that a machine that
    /// is closed, or nearly, is measured by the energy it tosses to and fro.
    /// 0 for a machine at rest.
    #[must_use]
    pub fn max_residual_relative(&self) -> f64 {
        let passed = self.passed.last().copied().unwrap_or(0.0);
        let scale = passed.max(self.largest_active);
        let largest = self.residual.iter().fold(0.0, |max: f64, value| max.max(value.abs()));
        if scale > 0.0 { largest / scale } else { largest }
    }
}

impl Trajectory {
    /// The values of the column of this name. If a scene has a state and an
    /// output of one name, the state's.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        self.find(name).map(|column| column.values.as_slice())
    }

    /// The column of this name, with unit and meaning.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name == name)
    }

    /// The columns of one kind, in order.
    pub fn of_kind(&self, kind: ColumnKind) -> impl Iterator<Item = &Column> {
        self.columns.iter().filter(move |column| column.kind == kind)
    }

    /// d(of)/d(by) of a state or an output, if the run was asked for it.
    #[must_use]
    pub fn sensitivity(&self, of: &str, by: &str) -> Option<&[f64]> {
        self.column(&sensitivity_name(of, by))
    }

    /// The value at the end of the run of the column of this name.
    #[must_use]
    pub fn last(&self, name: &str) -> Option<f64> {
        self.column(name)?.last().copied()
    }

    /// Writes a table: a header `time [s],motor.omega [rad/s],...`, then one line
    /// a time, each number in the shortest form that reads back the same.
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

    /// Writes one JSON object: scene, method, work, times, columns. JSON has no
    /// NaN and no infinity; an output that is one becomes `null`.
    ///
    /// # Errors
    /// Whatever `writer` reports.
    pub fn write_json(&self, mut writer: impl io::Write) -> io::Result<()> {
        serde_json::to_writer_pretty(&mut writer, self)?;
        writeln!(writer)
    }
}
