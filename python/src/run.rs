//! Results of a run for Python.

use std::sync::{Mutex, PoisonError};

use machinist::Trajectory;
use machinist::error_estimate::ErrorEstimate;
use machinist::trajectory::{Column, ColumnKind, EnergyBalance};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict as _, PyDict};

use crate::arrays::array;

/// Numbers of a run, moved to NumPy on first access without a copy.
enum Slot {
    Kept(Vec<f64>),
    Handed(Py<PyArray1<f64>>),
}

impl Slot {
    fn hand<'py>(&mut self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        match self {
            Self::Handed(values) => values.bind(py).clone(),
            Self::Kept(values) => {
                let values = array(py, std::mem::take(values));
                *self = Self::Handed(values.clone().unbind());
                values
            }
        }
    }
}

struct Named {
    name: String,
    unit: String,
    kind: &'static str,
    doc: String,
}

/// A run: times and numeric columns.
#[pyclass(frozen, module = "machinist._machinist")]
pub struct Run {
    told: Description,
    columns: Vec<Named>,
    /// Times, then the columns.
    slots: Mutex<Vec<Slot>>,
}

/// All but the columns.
struct Description {
    machine: String,
    title: String,
    method: &'static str,
    rtol: f64,
    work: machinist::method::Work,
    notes: Vec<String>,
    events: Vec<(f64, String)>,
    stopped: Option<(f64, String)>,
    drift: Option<(f64, f64)>,
    energy_residual: Option<f64>,
    error: Option<ErrorEstimate>,
}

impl Run {
    pub fn new(run: Trajectory) -> Self {
        let told = Description {
            energy_residual: run.energy_balance.as_ref().map(EnergyBalance::max_residual_relative),
            machine: run.scene,
            title: run.title,
            method: run.method.name(),
            rtol: run.rtol,
            work: run.work,
            notes: run.notes,
            events: run.switches.into_iter().map(|switch| (switch.time, switch.event)).collect(),
            stopped: run.stopped.map(|stop| (stop.time, stop.cause)),
            drift: run.drift.map(|drift| (drift.before, drift.after)),
            error: run.error,
        };
        let mut slots = vec![Slot::Kept(run.times)];
        let mut columns = Vec::with_capacity(run.columns.len());
        for Column { name, unit, kind, doc, values } in run.columns {
            columns.push(Named { name, unit, kind: name_of(kind), doc });
            slots.push(Slot::Kept(values));
        }
        Self { told, columns, slots: Mutex::new(slots) }
    }
}

fn name_of(kind: ColumnKind) -> &'static str {
    match kind {
        ColumnKind::State => "state",
        ColumnKind::Output => "output",
        ColumnKind::Energy => "energy",
        ColumnKind::Sensitivity => "sensitivity",
        ColumnKind::Measured => "measured",
        _ => "other",
    }
}

#[pymethods]
impl Run {
    /// Times \[s\].
    fn times<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.slot(py, 0)
    }

    /// (name, unit, kind, description) of every column.
    fn columns(&self) -> Vec<(&str, &str, &str, &str)> {
        self.columns.iter().map(|c| (&*c.name, &*c.unit, c.kind, &*c.doc)).collect()
    }

    /// Values of a column, by index.
    fn values<'py>(&self, py: Python<'py>, column: usize) -> PyResult<Bound<'py, PyArray1<f64>>> {
        if column < self.columns.len() {
            Ok(self.slot(py, column + 1))
        } else {
            Err(pyo3::exceptions::PyIndexError::new_err("there is no such column"))
        }
    }

    /// All other results as a dictionary.
    fn told<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let Description { machine, title, method, rtol, work, notes, events, stopped, .. } =
            &self.told;
        let told = PyDict::new(py);
        told.set_item("machine", machine)?;
        told.set_item("title", title)?;
        told.set_item("method", method)?;
        told.set_item("rtol", rtol)?;
        let counts = PyDict::new(py);
        for (name, count) in [
            ("steps", work.steps),
            ("rejected", work.rejected),
            ("rate_evaluations", work.rate_evaluations),
            ("jacobian_evaluations", work.jacobian_evaluations),
            ("factorizations", work.factorizations),
            ("newton_iterations", work.newton_iterations),
            ("events", work.switches),
        ] {
            counts.set_item(name, count)?;
        }
        told.set_item("work", counts)?;
        told.set_item("notes", notes)?;
        told.set_item("events", events)?;
        told.set_item("stopped", stopped)?;
        told.set_item("drift", self.told.drift)?;
        told.set_item("energy_residual", self.told.energy_residual)?;
        let error = self.told.error.as_ref();
        let errors = error.filter(|error| error.unknown.is_none()).map(|error| {
            let columns = error.columns.iter();
            columns.map(|column| (column.name.as_str(), column.largest)).into_py_dict(py)
        });
        told.set_item("error", errors.transpose()?)?;
        told.set_item("error_unknown", error.and_then(|error| error.unknown.as_ref()))?;
        Ok(told)
    }
}

impl Run {
    fn slot<'py>(&self, py: Python<'py>, index: usize) -> Bound<'py, PyArray1<f64>> {
        let mut slots = self.slots.lock().unwrap_or_else(PoisonError::into_inner);
        slots[index].hand(py)
    }
}
