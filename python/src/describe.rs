//! Description of a machine as a dictionary.

use machinist_contract::{Simulator, StateKind};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Names, units, descriptions and defaults.
pub fn describe<'py>(
    py: Python<'py>,
    simulator: &dyn Simulator<f64>,
    (running, tunable): (&str, &[bool]),
) -> PyResult<Bound<'py, PyDict>> {
    let shape = simulator.shape();
    let told = PyDict::new(py);
    told.set_item("name", simulator.name())?;
    told.set_item("title", simulator.title())?;
    told.set_item("running", running)?;
    let row = |quantity: machinist_contract::Quantity<'_>| {
        [quantity.name, quantity.unit, quantity.doc].map(str::to_owned)
    };
    let parameters: Vec<_> = tunable
        .iter()
        .enumerate()
        .map(|(k, tunable)| (row(simulator.parameter(k)), simulator.parameter_default(k), tunable))
        .collect();
    told.set_item("parameters", parameters)?;
    let kind = |k: usize| match simulator.state_kind(k) {
        _ if simulator.is_mode(k) => "mode",
        StateKind::Position => "position",
        StateKind::Velocity => "velocity",
        StateKind::FirstOrder => "first order",
    };
    let states: Vec<_> = (0..shape.states())
        .map(|k| (row(simulator.state(k)), kind(k), simulator.state_scale(k)))
        .collect();
    told.set_item("states", states)?;
    let outputs: Vec<_> = (0..shape.outputs).map(|k| row(simulator.output(k))).collect();
    told.set_item("outputs", outputs)?;
    let events: Vec<_> = (0..simulator.events())
        .map(|k| {
            let event = simulator.event(k);
            [event.name.to_owned(), event.doc.to_owned()]
        })
        .collect();
    told.set_item("events", events)?;
    let constraints: Vec<_> = (0..simulator.constraints())
        .map(|k| {
            let constraint = simulator.constraint(k);
            [constraint.name, constraint.unit, constraint.doc].map(str::to_owned)
        })
        .collect();
    told.set_item("constraints", constraints)?;
    let defaults = simulator.run_defaults();
    let run = PyDict::new(py);
    run.set_item("start", defaults.from)?;
    run.set_item("until", defaults.until)?;
    run.set_item("points", defaults.points)?;
    run.set_item("rtol", defaults.rtol)?;
    run.set_item("method", defaults.method)?;
    told.set_item("run", run)?;
    Ok(told)
}
